#include "parts.h"
Halved::Halved(double x) : a(half_of(x)) {} /* optimised, the one constructor is an alias of the other */
