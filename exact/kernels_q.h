/* kernels_q.h -- the kernels on rationals; compiled once, in kernels_q.c. */
#ifndef CAGD_KERNELS_Q_H
#define CAGD_KERNELS_Q_H

#include "core/number/binomial.h"
#include "exact/curve/spline.h"
#include "exact/words.h"

#define spline_q cagd_spline_q

#define G(name) name##_q
#include "core/kernels/net_type.tmpl.h"
#include "core/kernels/span_type.tmpl.h"
#undef G

#include "generated/kernels/q.h"
#endif
