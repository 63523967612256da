/* kernels_m.h -- the kernels on binary64 with a running error bound. */
#ifndef CAGD_KERNELS_M_H
#define CAGD_KERNELS_M_H

#include "core/number/num_measured.h"

#define G(name) name##_m
#include "core/kernels/kernels.tmpl.h"
#undef G
#endif
