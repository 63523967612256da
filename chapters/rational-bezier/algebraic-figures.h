/* algebraic-figures.h -- what the drawings of envelopes, implicit equations and genera have in common. */
#ifndef CAGD_ALGEBRAIC_FIGURES_H
#define CAGD_ALGEBRAIC_FIGURES_H

#include "chapters/judge/figure.h"
#include "exact/kernels_q.h"
#include "figures/svg.h"

static inline num_q q(long m) { return from_int_q(m); }
static inline num_q r(long m, long n) { return from_ratio_q(m, n); }
static inline svg_point at(num_q x, num_q y) { return (svg_point){x, y}; }
static inline svg_window window(num_q x0, num_q y0, num_q x1, num_q y1) { return (svg_window){x0, y0, x1, y1}; }

/* P[k] = m[k] / unit */
static inline void fractions(int count, const int m[], long unit, num_q P[])
{
    for (int k = 0; k < count; k++)
        P[k] = r(m[k], unit);
}
#endif
