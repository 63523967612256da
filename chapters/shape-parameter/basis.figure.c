/* basis.figure.c -- drawings for basis.claims.h. */
#include "chapters/shape-parameter/drawing.h"

FIGURE(eight_functions)
{
    svg *s =
        svg_new("eight_functions", "The eight functions as printed and as corrected",
                "The graphs of the eight functions for β = -5.  Left the printed ones: the fourth and the fifth, B₃ "
                "and B₄, are no mirror images, and the sum of all rises to more than 1.1.  Right the corrected ones, "
                "symmetric and with sum 1.");
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

FIGURE(beta_zero)
{
    svg *s =
        svg_new("beta_zero", "What happens at beta = 0",
                "Left the coefficients of the eighth power in the eight printed functions, over β: all are 0 for β = "
                "0 and for no other β.  Right the eight functions for β = 0, the Bernstein polynomials of degree "
                "seven; B₀ is the first of them and not all.");
    static const int factor[8] = {-1, -5, -9, -9, 1, 9, 5, 1};
    num_q near[8], far[8], a[8];
    svg_panel(s, window(q(-7), q(-10), q(1), q(10)), 300, 260, "the coefficients of $t^8$, over $β$");
    svg_axes(s, q(1), q(5), "β", NULL);
    for (int i = 0; i <= 7; i++) {
        long slope = i % 2 == 1 ? factor[i] : -factor[i];
        svg_line(s, svg_at(0, 0), svg_at(1, slope), SVG_CURVE);
    }
    svg_mark(s, svg_at(0, 0), SVG_POINT, SVG_USUAL);
    svg_panel(s, window(q(0), q(0), q(1), q(1)), 380, 260, "$β=0$");
    svg_axes(s, r(1, 4), r(1, 2), "t", NULL);
    factors(1, 7, q(0), near, far);
    for (int i = 7; i >= 0; i--) {
        choice(i, a);
        put_graph(s, 7, near, far, a, i ? SVG_CURVE : SVG_WRONG);
    }
    svg_legend_line(s, SVG_CURVE, "one for each function");
    svg_legend_line(s, SVG_WRONG, "$B_0$");
    return s;
}

FIGURE(dependent_functions)
{
    svg *s = svg_new("dependent_functions", "Functions that are no basis",
                     "Left the corrected functions B₃ and B₄ for β = -7, which are the same, beside those for β = -4.  "
                     "Right four multiples of functions for β = -21/4 that add up to 0.");
    static const int k[8] = {0, 0, -5, 27, -27, 5, 0, 0};
    num_q near[8], far[8], a[8];
    svg_panel(s, window(q(0), q(0), q(1), r(1, 4)), 320, 240, "$B_3$ and $B_4$");
    svg_axes(s, r(1, 2), r(1, 4), "t", NULL);
    for (int beta = -4; beta >= -7; beta -= 3)
        for (int i = 3; i <= 4; i++) {
            factors(0, 7, q(beta), near, far);
            choice(i, a);
            put_graph(s, 7, near, far, a, beta == -7 ? SVG_WRONG : i == 3 ? SVG_CURVE : SVG_CURVE_2);
        }
    svg_panel(s, window(q(0), q(-1), q(1), q(1)), 320, 240, "$β=-21/4$: $-B_2$, $27/5 B_3$, $-27/5 B_4$, $B_5$");
    svg_axes(s, r(1, 2), r(1, 2), "t", NULL);
    factors(0, 7, r(-21, 4), near, far);
    for (int i = 2; i <= 5; i++) {
        choice(i, a);
        a[i] = r(k[i], 5);
        put_graph(s, 7, near, far, a, SVG_FAMILY);
    }
    for (int i = 0; i <= 7; i++)
        a[i] = r(k[i], 5);
    put_graph(s, 7, near, far, a, SVG_WRONG);
    svg_legend_line(s, SVG_CURVE, "$B_3$, $β=-4$");
    svg_legend_line(s, SVG_CURVE_2, "$B_4$, $β=-4$");
    svg_legend_line(s, SVG_WRONG, "$B_3=B_4$ for $β=-7$; the sum 0");
    return s;
}

FIGURE(degree_five_at_the_end)
{
    svg *s =
        svg_new("degree_five_at_the_end", "The last function but one of degree five at t = 1",
                "For β = -1: the function B₄ of degree five meets the axis at t = 1 with the slope -4, that of degree "
                "seven with the slope 0.");
    num_q near[8], far[8], a[8];
    svg_panel(s, window(q(0), q(0), q(1), r(1, 2)), 380, 240, "$β=-1$");
    svg_axes(s, r(1, 4), r(1, 4), "t", NULL);
    choice(4, a);
    for (int n = 5; n <= 7; n += 2) {
        factors(0, n, q(-1), near, far);
        put_graph(s, n, near, far, a, n == 5 ? SVG_WRONG : SVG_RIGHT);
    }
    svg_legend_line(s, SVG_WRONG, "$B_{4,5}$, as printed");
    svg_legend_line(s, SVG_RIGHT, "$B_{4,7}$");
    return s;
}
