/* Figures of the section on joints. */
#include "chapters/foundations/figures.h"

FIGURE(joints_of_order)
{
    svg *s = svg_new("joints_of_order", "Joints of order 0, 1 and 2",
                     "One first piece and three second pieces: one that has only the point in common, one with the "
                     "same tangent and a "
                     "derivative twice as long, and one with the same curvature as well; at the last two the circle of "
                     "curvature of the first piece is drawn.");
    /* P_I = (t - 1, (t-1)^2/2 ...): P = (0,0), P' = (1,0), P'' = (0,1) at t = 1; the circle has radius 1 */
    const int first[6] = {-2, 1, 2, -2, 0, 1}; /* halves */
    static const int second[3][6] = {{0, 0, 1, 2, 2, 0}, {0, 0, 4, 0, 0, -2}, {0, 0, 4, 0, 1, 4}};
    static const char *const captions[3] = {"order 0: the point", "order 1: the tangent, $λ=2$",
                                            "order 2: the curvature, $λ=2$"};
    for (int k = 0; k < 3; k++) {
        num_q c[6], d[6];
        fractions(6, first, 2, c);
        fractions(6, second[k], 2, d);
        svg_panel(s, window(r(-6, 5), r(-7, 5), r(12, 5), r(11, 5)), 230, 0, captions[k]);
        if (k > 0)
            svg_circle(s, svg_at(0, 1), q(1), SVG_MUTED);
        put_power_curve(s, 2, c, q(0), q(1), SVG_CURVE);
        put_power_curve(s, 2, d, q(0), q(1), k == 2 ? SVG_RIGHT : SVG_CURVE_2);
        svg_mark(s, svg_at(0, 0), SVG_POINT, SVG_USUAL);
        svg_frame(s);
    }
    svg_legend_line(s, SVG_CURVE, "first piece");
    svg_legend_line(s, SVG_CURVE_2, "second piece");
    svg_legend_line(s, SVG_RIGHT, "second piece, $P''=λ^2P''+βP'$");
    svg_legend_line(s, SVG_MUTED, "circle of curvature");
    return s;
}

FIGURE(same_curvature_other_side)
{
    svg *s = svg_new("same_curvature_other_side", "One curvature on both sides of the joint, and a change of side",
                     "The parabola y = x squared up to the origin, and from there either y = x squared or y = - x "
                     "squared: the tangent and "
                     "the curvature K = 2 are continuous both times, the vector of curvature only once.");
    const int first[6] = {-1, 1, 1, -2, 0, 1};
    num_q c[6], up[6] = {q(0), q(0), q(1), q(0), q(0), q(1)}, down[6] = {q(0), q(0), q(1), q(0), q(0), q(-1)};
    integers(6, first, c);
    svg_panel(s, window(q(-1), q(-1), q(1), q(1)), 380, 0, "$K=2$ from either side");
    svg_circle(s, at(q(0), r(1, 2)), r(1, 2), SVG_MUTED);
    svg_circle(s, at(q(0), r(-1, 2)), r(1, 2), SVG_MUTED);
    put_power_curve(s, 2, c, q(0), q(1), SVG_CURVE);
    put_power_curve(s, 2, up, q(0), q(1), SVG_RIGHT);
    put_power_curve(s, 2, down, q(0), q(1), SVG_WRONG);
    svg_mark(s, svg_at(0, 0), SVG_POINT, SVG_USUAL);
    svg_frame(s);
    svg_legend_line(s, SVG_CURVE, "first piece");
    svg_legend_line(s, SVG_RIGHT, "(1-5-3) holds");
    svg_legend_line(s, SVG_WRONG, "$K$ is continuous, (1-5-3) is violated");
    svg_legend_line(s, SVG_MUTED, "circles of curvature");
    return s;
}

FIGURE(joined_and_closed)
{
    svg *s =
        svg_new("joined_and_closed", "Two pieces that are joined, and one curve that is closed",
                "Left two segments in a row: the second begins where the first ends, and neither is closed.  Right "
                "what the condition says as printed, with one letter for both curves: a curve that ends where it "
                "begins.");
    svg_panel(s, window(r(-1, 4), r(-3, 4), r(9, 4), r(3, 4)), 320, 0, "$P_{II}(0)=P_I(1)$");
    svg_segment(s, svg_at(0, 0), svg_at(1, 0), SVG_CURVE);
    svg_segment(s, svg_at(1, 0), svg_at(2, 0), SVG_CURVE_2);
    for (int k = 0; k <= 2; k++)
        svg_mark(s, svg_at(k, 0), SVG_POINT, SVG_USUAL);
    svg_label(s, svg_at(0, 0), SVG_S, SVG_POINT, "P_I(0)");
    svg_label(s, svg_at(1, 0), SVG_N, SVG_POINT, "P_I(1)");
    svg_label(s, svg_at(1, 0), SVG_S, SVG_POINT, "P_{II}(0)");
    svg_label(s, svg_at(2, 0), SVG_S, SVG_POINT, "P_{II}(1)");
    const int coefficients[8] = {0, 0, 4, 5, -4, -15, 0, 10}; /* (4t(1-t), 5t(1-t)(1-2t)) */
    num_q c[8];
    integers(8, coefficients, c);
    svg_panel(s, window(r(-1, 4), r(-3, 4), r(5, 4), r(3, 4)), 192, 0, "$P_x(0)=P_x(1)$, as printed");
    put_power_curve(s, 3, c, q(0), q(1), SVG_WRONG);
    svg_mark(s, svg_at(0, 0), SVG_POINT, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "first piece");
    svg_legend_line(s, SVG_CURVE_2, "second piece");
    svg_legend_line(s, SVG_WRONG, "a closed curve");
    return s;
}
