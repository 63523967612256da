/* drawing.h -- what the drawings of this chapter have in common. */
#ifndef CAGD_SHAPE_DRAWING_H
#define CAGD_SHAPE_DRAWING_H

#include "chapters/judge/figure.h"
#include "chapters/judge/figure_data.h"
#include "figures/words.h"

static inline void factors(int printed, int n, num_q beta, num_q near[], num_q far[])
{
    if (printed)
        shape_factors_printed_q(beta, near, far);
    else
        shape_factors_q(n, beta, near, far);
}

/* The curve of the points P, printed functions (n = 7) or corrected ones, by its Bézier points of degree n+1. */
static inline void put_curve(svg *s, int printed, int n, const num_q P[], num_q beta, enum svg_role paint)
{
    num_q near[MAX_DEGREE + 1], far[MAX_DEGREE + 1], E[(MAX_DEGREE + 1) * MAX_DEGREE], Q[2 * (MAX_DEGREE + 1)];
    factors(printed, n, beta, near, far);
    shape_matrix_q(n, near, far, E);
    for (int k = 0; k <= n + 1; k++)
        for (int c = 0; c < 2; c++) {
            num_q *value = &Q[2 * k + c];
            *value = q(0);
            for (int i = 0; i <= n; i++)
                *value = add_q(*value, mul_q(E[k * (n + 1) + i], P[2 * i + c]));
        }
    svg_bezier(s, n + 1, Q, paint);
}

/* The graph of the polynomial sum a_i (near_i s + far_i t) s^{n-i} t^i over [0,1]. */
static inline void put_graph(svg *s, int n, const num_q near[], const num_q far[], const num_q a[], enum svg_role paint)
{
    num_q E[(MAX_DEGREE + 1) * MAX_DEGREE], Q[2 * (MAX_DEGREE + 1)];
    shape_matrix_q(n, near, far, E);
    for (int k = 0; k <= n + 1; k++) {
        Q[2 * k] = r(k, n + 1);
        Q[2 * k + 1] = q(0);
        for (int i = 0; i <= n; i++)
            Q[2 * k + 1] = add_q(Q[2 * k + 1], mul_q(E[k * (n + 1) + i], a[i]));
    }
    svg_bezier(s, n + 1, Q, paint);
}

/* The nine values of the figures of the source; those outside the true range as wrong. */
static inline void nine_curves(svg *s, const num_q P[])
{
    for (int beta = -7; beta <= 1; beta++)
        put_curve(s, 0, 7, P, q(beta), beta < -5 ? SVG_WRONG : beta == 0 ? SVG_CURVE_2 : SVG_FAMILY);
    put_curve(s, 0, 7, P, q(1), SVG_CURVE);
    svg_legend_line(s, SVG_CURVE, "$β=1$");
    svg_legend_line(s, SVG_CURVE_2, "$β=0$, the Bézier curve");
    svg_legend_line(s, SVG_FAMILY, "$β=-1,...,-5$");
    svg_legend_line(s, SVG_WRONG, "$β=-6,-7$, outside");
}

/* The triangle of the claims on β = -7, its first and last corner repeated, the curves of β = -21/4 and -7, and a level line. */
static inline void put_triangle(svg *s, num_q level)
{
    num_q P[16];
    data_of("curve_at_minus_seven_crosses_a_line_off_its_polygon", "P", 8, 2, P);
    svg_polyline(s, 8, P, SVG_POLYGON);
    put_curve(s, 0, 7, P, r(-21, 4), SVG_RIGHT);
    put_curve(s, 0, 7, P, q(-7), SVG_WRONG);
    svg_line(s, at(q(0), level), at(q(1), level), SVG_POINT);
    svg_frame(s);
}

/* Only function i, or with i < 0 the sum of all. */
static inline void choice(int i, num_q a[])
{
    for (int j = 0; j <= 7; j++)
        a[j] = q(i < 0 || j == i);
}
#endif
