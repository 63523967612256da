/* figures.h -- what the drawings of this chapter have in common. */
#ifndef CAGD_FOUNDATIONS_FIGURES_H
#define CAGD_FOUNDATIONS_FIGURES_H

#include "chapters/judge/figure.h"
#include "figures/words.h"

/* The piece over [u, v] of the plane curve of degree n <= 3 with these coefficients. */
static inline void put_power_curve(svg *s, int n, const num_q c[], num_q u, num_q v, enum svg_role role)
{
    num_q piece[8], line[4], R[8];
    power_on_interval_q(n, 2, c, u, v, piece);
    for (int j = 0; j < 2; j++) {
        for (int k = 0; k <= n; k++)
            line[k] = piece[2 * k + j];
        bernstein_from_power_q(n, line, line);
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
