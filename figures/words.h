/* words.h -- the short words of drawings: exact numbers, points and windows. */
#ifndef CAGD_FIGURE_WORDS_H
#define CAGD_FIGURE_WORDS_H

#include "exact/kernels_q.h"
#include "figures/svg.h"

static inline num_q q(long m) { return from_int_q(m); }
static inline num_q r(long m, long n) { return from_ratio_q(m, n); }
static inline svg_point at(num_q x, num_q y) { return (svg_point){x, y}; }
static inline svg_window window(num_q x0, num_q y0, num_q x1, num_q y1) { return (svg_window){x0, y0, x1, y1}; }

/* to[k] = from[k] / unit */
static inline void fractions(int count, const int from[], long unit, num_q to[])
{
    for (int k = 0; k < count; k++)
        to[k] = r(from[k], unit);
}

static inline void integers(int count, const int from[], num_q to[]) { fractions(count, from, 1, to); }
#endif
