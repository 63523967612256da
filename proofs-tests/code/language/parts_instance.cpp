#include "parts.h"
template struct Series<double>; /* what this file defines is weak, and nothing else is in it */
