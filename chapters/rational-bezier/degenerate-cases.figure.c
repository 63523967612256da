#include "chapters/judge/figure.h"
#include "exact/kernels_q.h"
#include "figures/svg.h"

/* t = alpha u / (1 - u + alpha u), alpha being the data. */
static svg_point alpha_graph(num_q u, const void *data)
{
    num_q share = mul_q(*(const num_q *)data, u);
    return (svg_point){u, div_q(share, add_q(sub_q(from_int_q(1), u), share))};
}

FIGURE(geometric_weights)
{
    enum { n = 3 };
    static const int point[] = {0, 0, 1, 3, 4, 3, 5, 0};
    num_q R[2 * (n + 1)], zero = from_int_q(0), one = from_int_q(1), third = from_ratio_q(1, 3),
                          half = from_ratio_q(1, 2);
    num_q three = from_int_q(3), above = from_ratio_q(21, 20);
    for (int k = 0; k < 2 * (n + 1); k++)
        R[k] = from_int_q(point[k]);
    svg *s =
        svg_new("geometric_weights", "A polynomial curve with geometric weights",
                "Left, t as a function of u for alpha = 1/3, 1 and 3.  Right, a cubic Bézier curve with the points of "
                "parameters k/8 for alpha = 1 and for alpha = 3.");
    svg_panel(s, (svg_window){zero, zero, above, above}, 300, 0, "$t = α u/(1 - u + α u)$");
    svg_axes(s, half, half, "u", "t");
    svg_plot(s, alpha_graph, &one, zero, one, 4, SVG_CURVE);
    svg_plot(s, alpha_graph, &three, zero, one, 16, SVG_CURVE_2);
    svg_plot(s, alpha_graph, &third, zero, one, 16, SVG_MUTED);
    svg_panel(s, svg_integer_window(-1, -1, 6, 4), 420, 0,
              "weights $α^i$: one curve, other points at $u = 1/8, ..., 7/8$;\ndiscs $α = 1$, squares $α = 3$");
    svg_control_polygon(s, n, R, "P");
    svg_bezier(s, n, R, SVG_FAMILY);
    num_q w[2][n + 1];
    for (int i = 0; i <= n; i++)
        w[0][i] = one;
    w[1][0] = one;
    for (int i = 1; i <= n; i++)
        w[1][i] = mul_q(w[1][i - 1], three);
    for (int which = 0; which < 2; which++)
        for (int k = 1; k < 8; k++) {
            num_q P[2];
            rational_point_q(n, 2, R, w[which], from_ratio_q(k, 8), P);
            svg_mark(s, svg_pair(P), which ? SVG_CURVE_2 : SVG_CURVE, SVG_USUAL);
        }
    svg_legend_line(s, SVG_CURVE, "$α = 1$");
    svg_legend_line(s, SVG_CURVE_2, "$α = 3$");
    svg_legend_line(s, SVG_MUTED, "$α = 1/3$");
    return s;
}

FIGURE(equal_weights)
{
    enum { n = 3 };
    static const int point[] = {0, 0, 1, 3, 4, 3, 5, 0}, numerator[] = {1, 1, 2, 4}, denominator[] = {4, 2, 1, 1};
    num_q R[2 * (n + 1)], w[n + 1], P[2];
    for (int k = 0; k < 2 * (n + 1); k++)
        R[k] = from_int_q(point[k]);
    svg *s = svg_new("equal_weights", "Equal weights give the Bézier curve",
                     "Four points with the weights 1, w, w, 1.  For w = 1 the rational curve is the Bézier curve of "
                     "the points, with "
                     "the same point for every parameter; the points of parameters k/8 are marked on both.  For w = "
                     "1/4, 1/2, 2 and 4 "
                     "it is another curve.");
    svg_panel(s, svg_integer_window(-1, -1, 6, 4), 460, 0, "weights $1, ω, ω, 1$");
    svg_control_polygon(s, n, R, "R");
    for (int k = 0; k < 4; k++) {
        w[0] = w[n] = from_int_q(1);
        w[1] = w[2] = from_ratio_q(numerator[k], denominator[k]);
        svg_rational(s, n, R, w, SVG_FAMILY);
    }
    for (int i = 0; i <= n; i++)
        w[i] = from_int_q(5);
    svg_rational(s, n, R, w, SVG_CURVE);
    for (int k = 0; k <= 8; k++) {
        bezier_casteljau_q(n, 2, R, from_ratio_q(k, 8), P);
        svg_mark(s, svg_pair(P), SVG_CURVE_2, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "all weights equal");
    svg_legend_mark(s, SVG_CURVE_2, SVG_USUAL, "Bézier curve, $t=k/8$");
    svg_legend_line(s, SVG_FAMILY, "$ω = 1/4, 1/2, 2, 4$");
    return s;
}
