/* figures.h -- what the drawings of this chapter have in common. */
#ifndef CAGD_FOUNDATIONS_FIGURES_H
#define CAGD_FOUNDATIONS_FIGURES_H

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

/* The piece over [u, v] of the plane curve of degree n <= 3 with these coefficients. */
static inline void put_power_curve(svg *s, int n, const num_q c[], num_q u, num_q v, enum svg_role role)
{
    num_q piece[8], line[4], R[8];
    power_on_interval_q(n, 2, c, u, v, piece);
    for (int j = 0; j < 2; j++) {
        for (int k = 0; k <= n; k++)
            line[k] = piece[2 * k + j];
        power_to_bernstein_q(n, line, line);
        for (int k = 0; k <= n; k++)
            R[2 * k + j] = line[k];
    }
    svg_bezier(s, n, R, role);
}

static inline svg_point power_curve_point(int n, const num_q c[], num_q t)
{
    num_q P[2];
    power_point_q(n, 2, c, t, P);
    return svg_pair(P);
}
#endif
