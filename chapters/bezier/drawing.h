/* drawing.h -- what the drawings of this chapter have in common. */
#ifndef CAGD_BEZIER_DRAWING_H
#define CAGD_BEZIER_DRAWING_H

#include "chapters/judge/figure.h"
#include "exact/kernels_q.h"
#include "figures/svg.h"

static inline num_q q(long m) { return from_int_q(m); }
static inline num_q r(long m, long n) { return from_ratio_q(m, n); }
static inline svg_point at(num_q x, num_q y) { return (svg_point){x, y}; }
static inline svg_window window(num_q x0, num_q y0, num_q x1, num_q y1) { return (svg_window){x0, y0, x1, y1}; }
static inline void integers(int count, const int from[], num_q out[])
{
    for (int m = 0; m < count; m++)
        out[m] = q(from[m]);
}
#endif
