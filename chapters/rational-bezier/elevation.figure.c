#include "chapters/frame/figure.h"
#include "exact/kernels_q.h"
#include "figures/svg.h"
