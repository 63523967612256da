/* span.h -- spans and multiplicities in binary64. */
#ifndef CAGD_SPAN_H
#define CAGD_SPAN_H

#include "core/api/cagd.h"
#include "core/number/num_double.h"

static inline int before_d(num_d a, num_d b) { return a < b; }

#define G(name) name##_d
#include "core/kernels/span.tmpl.h"
#undef G
#endif
