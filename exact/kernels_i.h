/* kernels_i.h -- the kernels on intervals; compiled once, in kernels_i.c. */
#ifndef CAGD_KERNELS_I_H
#define CAGD_KERNELS_I_H

#include "core/number/binomial.h"
#include "exact/number/interval.h"
#include "exact/words.h"

#include <stddef.h>

#define G(name) name##_i
#include "core/kernels/spline_type.tmpl.h"

#include "core/kernels/net_type.tmpl.h"
#include "core/kernels/span_type.tmpl.h"
#undef G

#include "generated/kernels/i.h"
#endif
