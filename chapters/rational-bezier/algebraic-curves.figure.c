#include "chapters/rational-bezier/plane-figures.h"

FIGURE(degree_of_a_hyperbola)
{
    svg *s =
        svg_new("degree_of_a_hyperbola", "A hyperbola is not of degree 1",
                "The hyperbola xy = 1 is of the form printed for degree 1.  The line y = x meets it in two points.");
    struct terms F = terms_of("hyperbola_has_the_printed_form_for_degree_one", "α, i, j", 2);
    svg_panel(s, svg_integer_window(-3, -3, 3, 3), 300, 0, "$xy-1=0$: exponents at most 1, degree 2");
    svg_axes(s, q(1), q(1), "x", "y");
    svg_implicit(s, value_of, &F, 160, SVG_CURVE);
    svg_line(s, svg_at(0, 0), svg_at(1, 1), SVG_CURVE_2);
    svg_mark(s, svg_at(1, 1), SVG_WRONG, SVG_USUAL);
    svg_mark(s, svg_at(-1, -1), SVG_WRONG, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "$xy=1$");
    svg_legend_line(s, SVG_CURVE_2, "a line");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "two common points");
    return s;
}

FIGURE(arc_of_a_line)
{
    svg *s = svg_new(
        "arc_of_a_line", "A quadratic whose equation is that of a line",
        "The points (0, 0), (0, 0), (1, 1) with weights 1 give the curve (t², t²), the segment from (0, 0) to (1, "
        "1).  The determinant is (x - y)² up to a factor: its curve is the line, of degree 1.");
    num_q R[6];
    data_of("doubled_parameter_halves_the_degree", "R", 3, 2, R);
    svg_panel(s, window(r(-1, 2), r(-1, 2), r(3, 2), r(3, 2)), 300, 0, "$n=2$, $F=(x-y)^2$");
    svg_axes(s, q(1), q(1), "x", "y");
    svg_line(s, svg_at(0, 0), svg_at(1, 1), SVG_CURVE_2);
    svg_bezier(s, 2, R, SVG_CURVE);
    svg_mark(s, svg_at(0, 0), SVG_POINT, SVG_USUAL);
    svg_mark(s, svg_at(1, 1), SVG_POINT, SVG_USUAL);
    svg_label(s, svg_at(0, 0), SVG_NW, SVG_POINT, "R_0=R_1");
    svg_label(s, svg_at(1, 1), SVG_NW, SVG_POINT, "R_2");
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_CURVE_2, "$F=0$, a line");
    return s;
}

FIGURE(smooth_cubic)
{
    svg *s =
        svg_new("smooth_cubic", "A cubic that is not rational",
                "The cubic y² = x³ - x has two separate real parts and no singular point, not even an imaginary one.");
    struct terms F = terms_of("smooth_cubic_has_two_separate_parts", "α, i, j", 3);
    svg_panel(s, window(q(-2), q(-2), q(2), q(2)), 300, 0, "$y^2=x^3-x$: $n=3$, $d=s=0$, $g=1$");
    svg_axes(s, q(1), q(1), "x", "y");
    svg_implicit(s, value_of, &F, 160, SVG_CURVE);
    return s;
}
