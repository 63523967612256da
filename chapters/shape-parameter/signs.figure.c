/* signs.figure.c -- drawings for signs.claims.h. */
#include "chapters/shape-parameter/drawing.h"

FIGURE(negative_function)
{
    svg *s =
        svg_new("negative_function", "The third function is negative below the true range",
                "The function B₂ near t = 0 for β = -7, -6, -21/4 and -4.  For the first two values it falls below 0 "
                "before it rises; for -21/4 it rises slowly, for -4 at once.");
    static const int value[4][2] = {{-7, 1}, {-6, 1}, {-21, 4}, {-4, 1}};
    num_q near[8], far[8], a[8];
    choice(2, a);
    svg_panel(s, window(q(0), r(-1, 80), r(1, 4), r(1, 25)), 460, 300, "$B_2$ on $[0,1/4]$");
    svg_axes(s, r(1, 20), r(1, 100), "t", NULL);
    for (int k = 0; k < 4; k++) {
        factors(0, 7, r(value[k][0], value[k][1]), near, far);
        put_graph(s, 7, near, far, a, k < 2 ? SVG_WRONG : k == 2 ? SVG_RIGHT : SVG_CURVE);
    }
    svg_mark(s, at(r(1, 9), q(0)), SVG_WRONG, SVG_USUAL);
    svg_label(s, at(r(1, 9), q(0)), SVG_SE, SVG_WRONG, "1/9");
    svg_note(s, at(r(23, 400), r(-19, 2000)), SVG_SE, SVG_WRONG, "$β=-7$, then $-6$ above it");
    svg_legend_line(s, SVG_WRONG, "$β=-7,-6$ (printed)");
    svg_legend_line(s, SVG_RIGHT, "$β=-21/4$");
    svg_legend_line(s, SVG_CURVE, "$β=-4$");
    return s;
}

FIGURE(slopes_in_beta)
{
    svg *s =
        svg_new("slopes_in_beta", "How the functions change with beta",
                "The derivatives of the eight corrected functions by β, over t.  Those of B₁, B₂, B₅ and B₆ change "
                "their sign, at 1/5, 4/9, 5/9 and 4/5; B₀ and B₇ decrease, B₃ and B₄ increase.");
    num_q low[2][8], high[2][8], a[8];
    shape_factors_q(7, q(0), low[0], low[1]);
    shape_factors_q(7, q(1), high[0], high[1]);
    for (int end = 0; end < 2; end++)
        for (int i = 0; i <= 7; i++)
            high[end][i] = sub_q(high[end][i], low[end][i]);
    svg_panel(s, window(q(0), r(-1, 16), q(1), r(1, 16)), 480, 320, NULL);
    svg_axes(s, r(1, 5), r(1, 20), "t", NULL);
    for (int i = 0; i <= 7; i++) {
        choice(i, a);
        int outer = i == 0 || i == 7, middle = i == 3 || i == 4;
        put_graph(s, 7, high[0], high[1], a, outer ? SVG_CURVE_2 : middle ? SVG_RIGHT : SVG_WRONG);
    }
    data_of("signs_of_the_slopes", "change, corrected functions", 8, 1, a);
    for (int k = 0; k <= 7; k++)
        if (!cagd_is_zero_q(a[k]))
            svg_mark(s, at(a[k], q(0)), SVG_POINT, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE_2, "$B_0$ and $B_7$ decrease with $β$");
    svg_legend_line(s, SVG_RIGHT, "$B_3$ and $B_4$ increase");
    svg_legend_line(s, SVG_WRONG, "$B_1,B_2,B_5,B_6$ do both, which is printed as increasing");
    return s;
}
