/* descartes-rule.figure.c -- drawings for descartes-rule.claims.h. */
#include "chapters/shape-parameter/drawing.h"

FIGURE(roots_at_minus_seven)
{
    svg *s =
        svg_new("roots_at_minus_seven", "More roots than changes of sign",
                "Sums of the printed functions with the coefficients 1, 1, 200, 1, 1, 1, 1 and 1 or -1.  For β = -7 "
                "the first has two roots and no change of sign in its coefficients, the second three roots and one "
                "change; for β = -21/4 there are none, and one.");
    for (int last = 1; last >= -1; last -= 2) {
        num_q near[8], far[8], a[8];
        data_of(last > 0 ? "positive_coefficients_with_two_roots" : "one_change_of_sign_and_three_roots", "k", 8, 1, a);
        svg_panel(s, window(q(0), q(-2), q(1), q(4)), 320, 240,
                  last > 0 ? "$k=(1,1,200,1,1,1,1,1)$" : "$k=(1,1,200,1,1,1,1,-1)$");
        svg_axes(s, r(1, 4), q(1), "t", NULL);
        factors(1, 7, r(-21, 4), near, far);
        put_graph(s, 7, near, far, a, SVG_RIGHT);
        factors(1, 7, q(-7), near, far);
        put_graph(s, 7, near, far, a, SVG_WRONG);
    }
    svg_legend_line(s, SVG_WRONG, "$β=-7$");
    svg_legend_line(s, SVG_RIGHT, "$β=-21/4$");
    return s;
}

FIGURE(zero_at_the_beginning)
{
    svg *s = svg_new(
        "zero_at_the_beginning", "A sum whose first and last coefficient are 0",
        "The sum of the corrected functions of β = 1 with the coefficients 0, -1, 1, 1, 1, 1, 1, 0: it is 0 at t = "
        "0 and t = 1, negative at first, as its first coefficient that is not 0 is, and has one root between.");
    num_q near[8], far[8], a[8];
    data_of("no_sign_makes_the_first_coefficient_positive", "k", 8, 1, a);
    svg_panel(s, window(q(0), r(-1, 2), q(1), q(1)), 360, 240, "$k=(0,-1,1,1,1,1,1,0)$, $β=1$");
    svg_axes(s, r(1, 4), r(1, 2), "t", NULL);
    factors(0, 7, q(1), near, far);
    put_graph(s, 7, near, far, a, SVG_CURVE);
    svg_mark(s, svg_at(0, 0), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_at(0, 0), SVG_NE, SVG_WRONG, "f(0)=0");
    svg_mark(s, svg_at(1, 0), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_at(1, 0), SVG_NW, SVG_WRONG, "f(1)=0");
    return s;
}
