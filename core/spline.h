/* spline.h -- curves in binary64: the cagd_spline of cagd.h is the struct spline_d of the generic text. */
#ifndef CAGD_SPLINE_H
#define CAGD_SPLINE_H

#include "core/api/cagd.h"
#include "core/kernels/kernels_d.h"
#include "core/kernels/span.h"

#include <math.h>

static inline int is_zero_d(num_d a) { return a == 0; }
static inline int is_number_d(num_d a) { return isfinite(a); }

#define G(name) name##_d
#include "core/spline.tmpl.h"
#undef G
#endif
