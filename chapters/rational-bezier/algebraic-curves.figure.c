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

FIGURE(arc_of_a_parabola)
{
    enum { n = 4 };
    svg *s = svg_new(
        "arc_of_a_parabola", "A quartic whose equation is that of a parabola",
        "Five different points with weights 1 give an arc of the parabola y = x²; the parameters t and -1 - t have the "
        "same point.  The determinant is (x² - y)² up to a factor: its curve is the parabola, of degree 2.");
    num_q R[2 * (n + 1)];
    data_of("doubled_parameter_halves_the_degree", "R", n + 1, 2, R);
    const num_q whole[6] = {r(-5, 4), r(25, 16), q(0), r(-25, 16), r(5, 4), r(25, 16)};
    svg_panel(s, window(r(-5, 4), r(-1, 4), r(3, 2), r(3, 2)), 300, 0, "$n=4$, $256F=(x^2-y)^2$");
    svg_axes(s, q(1), q(1), "x", "y");
    svg_bezier(s, 2, whole, SVG_CURVE_2);
    svg_bezier(s, n, R, SVG_CURVE);
    for (int i = 0; i <= n; i++)
        svg_mark(s, svg_pair(R + 2 * i), SVG_POINT, SVG_USUAL);
    svg_label(s, svg_at(0, 0), SVG_NW, SVG_POINT, "R_0");
    svg_label(s, svg_at(1, 1), SVG_NW, SVG_POINT, "R_4");
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_CURVE_2, "$F=0$, a parabola");
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
