/* Figures of the section on changes of the parameter. */
#include "chapters/foundations/figures.h"

FIGURE(piece_of_a_cubic)
{
    svg *s = svg_new("piece_of_a_cubic", "A piece of a cubic as a cubic",
                     "A cubic and its piece from t_0 = 1/5 to t_1 = 7/10, with the tangent at the beginning of the "
                     "piece in the old parameter "
                     "and, half as long, in the new one.");
    const int coefficients[8] = {0, 0, 3, 4, 0, -9, 0, 6};
    num_q c[8], piece[8], d[6], t0 = r(1, 5), t1 = r(7, 10);
    integers(8, coefficients, c);
    for (int m = 0; m < 6; m++)
        d[m] = mul_q(q(m / 2 + 1), c[m + 2]);
    power_on_interval_q(3, 2, c, t0, t1, piece);
    svg_panel(s, window(r(-1, 5), r(-1, 5), r(39, 10), r(7, 4)), 560, 0, "$t_0=1/5$, $t_1=7/10$");
    put_power_curve(s, 3, c, q(0), q(1), SVG_FAMILY);
    put_power_curve(s, 3, piece, q(0), q(1), SVG_CURVE);
    svg_point P = power_curve_point(3, c, t0), V = power_curve_point(2, d, t0), Q = power_curve_point(3, c, t1);
    svg_arrow(s, P, at(add_q(P.x, mul_q(r(1, 2), V.x)), add_q(P.y, mul_q(r(1, 2), V.y))), SVG_RIGHT);
    svg_arrow(s, P, at(add_q(P.x, V.x), add_q(P.y, V.y)), SVG_MUTED);
    svg_mark(s, P, SVG_POINT, SVG_USUAL);
    svg_label(s, P, SVG_NW, SVG_POINT, "P(t_0)");
    svg_mark(s, Q, SVG_POINT, SVG_USUAL);
    svg_label(s, Q, SVG_S, SVG_POINT, "P(t_1)");
    svg_legend_line(s, SVG_FAMILY, "the whole cubic");
    svg_legend_line(s, SVG_CURVE, "the piece");
    svg_legend_line(s, SVG_MUTED, "$dP/dt$");
    svg_legend_line(s, SVG_RIGHT, "$dP/dt^*$");
    return s;
}

/* (u, pu/(pu + 1 - u)) for the ratio p */
static svg_point fractional(num_q u, const void *data)
{
    num_q pu = mul_q(q(*(const int *)data), u);
    return at(u, div_q(pu, add_q(pu, sub_q(q(1), u))));
}

FIGURE(fractional_parameter)
{
    static const int ratios[3] = {1, 2, 6};
    static const enum svg_role roles[3] = {SVG_MUTED, SVG_CURVE, SVG_CURVE_2};
    static const char *const names[3] = {"$p:q=1$", "$p:q=2$", "$p:q=6$"};
    svg *s = svg_new("fractional_parameter", "A fractional change of the parameter",
                     "Left t as a function of u for three ratios p : q.  Right a cubic with the points of the "
                     "parameters u = 0, 1/8, ..., 1 "
                     "for the ratio 6: the curve is the same, the points crowd towards its end.");
    svg_panel(s, window(q(0), q(0), q(1), q(1)), 240, 0, "$t=pu/(pu+q(1-u))$");
    svg_axes(s, r(1, 2), r(1, 2), "u", "t");
    for (int k = 0; k < 3; k++)
        svg_plot(s, fractional, ratios + k, q(0), q(1), 32, roles[k]);
    const int coefficients[8] = {0, 0, 3, 4, 0, -9, 0, 6};
    num_q c[8];
    integers(8, coefficients, c);
    svg_panel(s, window(r(-1, 5), r(-1, 5), r(16, 5), r(5, 4)), 400, 0, "the points $u=0,1/8,...,1$");
    put_power_curve(s, 3, c, q(0), q(1), SVG_FAMILY);
    for (int k = 0; k <= 8; k++) {
        svg_mark(s, power_curve_point(3, c, r(k, 8)), SVG_MUTED, SVG_USUAL);
        svg_mark(s, power_curve_point(3, c, fractional(r(k, 8), ratios + 2).y), SVG_CURVE_2, SVG_USUAL);
    }
    for (int k = 0; k < 3; k++)
        svg_legend_line(s, roles[k], names[k]);
    svg_legend_mark(s, SVG_CURVE_2, SVG_USUAL, "points for $p:q=6$");
    svg_legend_mark(s, SVG_MUTED, SVG_USUAL, "points for $p:q=1$");
    return s;
}
