/* kernels_d.h -- the kernels on binary64. */
#ifndef CAGD_KERNELS_D_H
#define CAGD_KERNELS_D_H

#include "core/api/cagd.h"
#include "core/number/num_double.h"

#include <stddef.h>

/* The struct spline_d of the kernels. */
#define spline_d cagd_spline

#define G(name) name##_d
#include "core/kernels/net_type.tmpl.h"
#include "core/kernels/span_type.tmpl.h"

#include "core/kernels/kernels.tmpl.h"
#undef G
#endif
