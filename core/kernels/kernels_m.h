/* kernels_m.h -- the kernels on binary64 with a running error bound; compiled once, in kernels_m.c. */
#ifndef CAGD_KERNELS_M_H
#define CAGD_KERNELS_M_H

#include "core/number/binomial.h"
#include "core/number/num_measured.h"

#include <stddef.h>

#define G(name) name##_m
#include "core/kernels/spline_type.tmpl.h"

#include "core/kernels/net_type.tmpl.h"
#include "core/kernels/span_type.tmpl.h"
#undef G

#include "generated/kernels/m.h"
#endif
