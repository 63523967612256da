/* drawing.h -- what the drawings of this chapter have in common. */
#ifndef CAGD_HERMITE_COONS_DRAWING_H
#define CAGD_HERMITE_COONS_DRAWING_H

#include "chapters/judge/figure.h"
#include "figures/words.h"

/* The plane cubic with the data P(0), P(1), P'(0), P'(1), by its Bézier points. */
static inline void put_hermite(svg *s, const num_q data[8], enum svg_role role)
{
    num_q R[8];
    for (int c = 0; c < 2; c++) {
        R[c] = data[c];
        R[2 + c] = add_q(data[c], div_q(data[4 + c], q(3)));
        R[4 + c] = sub_q(data[2 + c], div_q(data[6 + c], q(3)));
        R[6 + c] = data[2 + c];
    }
    svg_bezier(s, 3, R, role);
}

/* The graph over [t0, t1] of the cubic with the data f(t0), f(t1), f'(t0), f'(t1). */
static inline void put_hermite_graph(svg *s, num_q t0, num_q t1, const num_q f[4], enum svg_role role)
{
    num_q length = sub_q(t1, t0);
    num_q data[8] = {t0, f[0], t1, f[1], length, mul_q(length, f[2]), length, mul_q(length, f[3])};
    put_hermite(s, data, role);
}
/* The Bézier curve of integer points, divided by `below`. */
static inline void put_bezier(svg *s, int n, const int from[], long below, enum svg_role role)
{
    num_q R[2 * MAX_DEGREE + 2];
    for (int m = 0; m < 2 * (n + 1); m++)
        R[m] = r(from[m], below);
    svg_bezier(s, n, R, role);
}
#endif
