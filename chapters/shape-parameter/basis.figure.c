/* basis.figure.c -- drawings for basis.claims.h. */
#include "chapters/shape-parameter/drawing.h"

FIGURE(eight_functions)
{
    svg *s =
        svg_new("eight_functions", "The eight functions as printed and as corrected",
                "The graphs of the eight functions for β = -5.  Left the printed ones: the third and the fourth from "
                "the left in the middle are no mirror images, and the sum of all rises to more than 1.1.  Right the "
                "corrected ones, symmetric and with sum 1.");
    num_q near[8], far[8], a[8], beta = q(-5);
    for (int printed = 1; printed >= 0; printed--) {
        svg_panel(s, window(q(0), q(0), q(1), r(5, 4)), 380, 280, NULL);
        svg_heading(s, printed ? SVG_WRONG : SVG_RIGHT, printed ? "as printed, $β=-5$" : "corrected, $β=-5$");
        svg_axes(s, r(1, 4), r(1, 2), "t", NULL);
        factors(printed, 7, beta, near, far);
        for (int i = 0; i <= 7; i++) {
            choice(i, a);
            put_graph(s, 7, near, far, a, i == 3 || i == 4 ? (printed ? SVG_CURVE_2 : SVG_RIGHT) : SVG_CURVE);
        }
        choice(-1, a);
        put_graph(s, 7, near, far, a, printed ? SVG_WRONG : SVG_POINT);
    }
    svg_legend_line(s, SVG_CURVE, "$B_0,B_1,B_2,B_5,B_6,B_7$");
    svg_legend_line(s, SVG_CURVE_2, "$B_3$ and $B_4$ as printed");
    svg_legend_line(s, SVG_RIGHT, "$B_3$ and $B_4$ corrected");
    svg_legend_line(s, SVG_WRONG, "the sum as printed, $1-4β(1-t)^3t^4$");
    return s;
}
