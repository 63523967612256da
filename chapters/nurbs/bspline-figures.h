/* bspline-figures.h -- drawing B-splines and their curves exactly: every segment as the Bézier curve that it is. */
#include "chapters/judge/figure.h"
#include "exact/record/span.h"
#include "figures/words.h"

#include <stdio.h>

enum { MOST_DRAWN = 32 };

/* The curve of n points of the plane. */
static inline void draw_bspline(svg *s, int n, int p, const num_q u[], const num_q c[], enum svg_role role)
{
    num_q b[2 * MOST_DRAWN];
    for (int mu = p; mu < n; mu++)
        if (before_q(u[mu], u[mu + 1])) {
            bspline_to_bezier_q(on_span_q(p, 2, u, mu, c), b);
            svg_bezier(s, p, b, role);
        }
}

/* Of the pieces of a function, the one of span mu: its graph is the curve of the points (Greville abscissa, coefficient). */
static inline void draw_spline_function(svg *s, int n, int p, const num_q u[], const num_q coefficient[],
                                        enum svg_role role)
{
    num_q c[2 * MOST_DRAWN];
    for (int i = 0; i < n; i++)
        c[2 * i] = bspline_greville_q(p, u, i), c[2 * i + 1] = coefficient[i];
    draw_bspline(s, n, p, u, c, role);
}

/* The whole graph of scale times the B-spline of the p+2 knots own, which are the middle ones of a longer vector. */
static inline void draw_basis_function(svg *s, int p, const num_q own[], num_q scale, enum svg_role role)
{
    num_q u[MOST_DRAWN], coefficient[MOST_DRAWN];
    for (int i = 0; i <= 3 * p + 1; i++)
        u[i] = i < p            ? sub_q(own[0], from_int_q(p - i))
               : i <= 2 * p + 1 ? own[i - p]
                                : add_q(own[p + 1], from_int_q(i - 2 * p - 1));
    for (int i = 0; i <= 2 * p; i++)
        coefficient[i] = i == p ? scale : from_int_q(0);
    draw_spline_function(s, 2 * p + 1, p, u, coefficient, role);
}

/* The value of a spline function at t. */
static inline num_q spline_value(int n, int p, const num_q u[], const num_q c[], num_q t)
{
    num_q value;
    bspline_deboor_q(on_span_q(p, 1, u, find_span_q(n, p, u, t), c), t, &value);
    return value;
}
