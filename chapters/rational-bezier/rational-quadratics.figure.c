/* rational-quadratics.figure.c -- drawings for rational-quadratics.claims.h. */
#include "chapters/rational-bezier/conic-figures.h"

FIGURE(middle_weight_sign)
{
    svg *s =
        svg_new("middle_weight_sign", "One constant, two arcs",
                "With the points (1, 0), (0, 0), (0, 1) the weights 2, 1, 2 and 1, 1, 4 give the same arc inside the "
                "triangle with different parameters; the weights 2, -1, 2, with the same constant 4, give the rest "
                "of the ellipse.");
    num_q R[6] = {q(1), q(0), q(0), q(0), q(0), q(1)}, P[2];
    num_q w[3] = {q(2), q(1), q(2)}, skew[3] = {q(1), q(1), q(4)}, other[3] = {q(2), q(-1), q(2)};
    svg_window window = {r(-1, 4), r(-1, 5), r(7, 5), r(7, 5)};
    svg_panel(s, window, 430, 0, "$ω_0ω_2/ω_1^2=4$ for all three");
    svg_area(s, 3, R, SVG_FILL);
    put_triangle(s, R, SVG_S, SVG_SW, SVG_W);
    svg_rational(s, 2, R, w, SVG_CURVE);
    svg_rational(s, 2, R, other, SVG_WRONG);
    for (int k = 1; k < 4; k++) {
        rational_point_q(2, 2, R, w, r(k, 4), P);
        svg_mark(s, svg_pair(P), SVG_CURVE, SVG_DISC);
        rational_point_q(2, 2, R, skew, r(k, 4), P);
        svg_mark(s, svg_pair(P), SVG_CURVE_2, SVG_SQUARE);
    }
    rational_point_q(2, 2, R, other, r(1, 2), P);
    svg_mark(s, svg_pair(P), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_pair(P), SVG_NE, SVG_WRONG, "(1,1)");
    svg_legend_line(s, SVG_CURVE, "weights 2, 1, 2 and 1, 1, 4");
    svg_legend_mark(s, SVG_CURVE, SVG_DISC, "2, 1, 2 at $t=1/4,1/2,3/4$");
    svg_legend_mark(s, SVG_CURVE_2, SVG_SQUARE, "1, 1, 4 at the same $t$");
    svg_legend_line(s, SVG_WRONG, "weights 2, $-1$, 2");
    return s;
}
