#include "chapters/nurbs/bspline-figures.h"

FIGURE(discrete_bsplines)
{
    enum { p = 3, m = 9 };
    num_q u[p + 2 + 2 * p], v[m + p + 1];
    /* knots u_i = 2i, among them the integers: v */
    for (int i = 0; i < p + 2 + 2 * p; i++)
        u[i] = from_int_q(2 * (i - p));
    svg *s = svg_new("discrete_bsplines", "A B-spline as a sum of finer ones",
                     "A cubic B-spline over the even integers 0 to 8, and the five B-splines over all integers, each "
                     "times its discrete "
                     "B-spline 1/8, 4/8, 6/8, 4/8, 1/8, that add up to it.");
    svg_panel(s, (svg_window){from_int_q(0), from_int_q(0), from_int_q(8), from_ratio_q(4, 5)}, 520, 260,
              "$N$ over the knots 0, 2, 4, 6, 8 is the sum of five B-splines over 0, 1, ..., 8,\n"
              "each times a value of the discrete B-spline, marked over its Greville abscissa.");
    svg_axes(s, from_int_q(1), from_ratio_q(1, 4), "t", NULL);
    draw_basis_function(s, p, u + p, from_int_q(1), SVG_CURVE);
    for (int i = 0; i <= m + p; i++)
        v[i] = from_int_q(i);
    for (int j = 0; j + p + 1 <= 8; j++) {
        /* alpha(j) by the span of u that contains j: u_mu = 2 floor(j/2) */
        num_q a[p + 1];
        int mu = p + j / 2;
        bspline_discrete_q(p, u, mu, v + j + 1, a);
        num_q alpha = a[p - (mu - p)]; /* of the B-spline with the first knot u_p = 0 */
        num_q xi = bspline_greville_q(p, v, j);
        char name[24];
        draw_basis_function(s, p, v + j, alpha, SVG_CURVE_2);
        svg_mark(s, (svg_point){xi, alpha}, SVG_RIGHT, SVG_USUAL);
        snprintf(name, sizeof name, "α(%d) = %s", j, to_string_q(alpha));
        svg_label(s,
                  (svg_point){j == 0   ? from_ratio_q(7, 4)
                              : j == 4 ? from_ratio_q(25, 4)
                                       : xi,
                              alpha},
                  j == 0   ? SVG_W
                  : j == 1 ? SVG_NW
                  : j == 2 ? SVG_N
                  : j == 3 ? SVG_NE
                           : SVG_E,
                  SVG_RIGHT, name);
    }
    svg_legend_line(s, SVG_CURVE, "$N$");
    svg_legend_line(s, SVG_CURVE_2, "$α(j) M_j$");
    return s;
}
