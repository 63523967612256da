/* span.h -- spans and multiplicities (exact/span.h), their comparisons with testimony (number.h). */
#ifndef CAGD_EXACT_SPAN_H
#define CAGD_EXACT_SPAN_H

#include "core/api/cagd.h"
#include "exact/record/number.h"
#include "exact/words.h"

static inline int before_q(num_q a, num_q b) { return cagd_testify_compare_q(a, b) < 0; }

#define G(name) name##_q
#include "core/kernels/span.tmpl.h"
#undef G
#endif
