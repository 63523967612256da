/* Figures of the section on points of a cubic. */
#include "chapters/foundations/figures.h"

FIGURE(infinite_slope_and_two_values)
{
    svg *s = svg_new("infinite_slope_and_two_values", "A curve with a vertical tangent and two values",
                     "The parabola ((2t-1) squared, t).  Over x = 1/4 it has two points, and at t = 1/2 its slope is "
                     "infinite, while "
                     "its derivative with respect to t is (0, 1).");
    const int coefficients[6] = {1, 0, -4, 1, 4, 0};
    num_q c[6];
    integers(6, coefficients, c);
    svg_panel(s, window(r(-1, 4), r(-1, 10), r(5, 4), r(11, 10)), 360, 0, "$P(t)=((2t-1)^2,t)$");
    svg_axes(s, r(1, 4), r(1, 4), "x", "y");
    svg_segment(s, at(r(1, 4), r(-1, 10)), at(r(1, 4), r(11, 10)), SVG_MUTED);
    put_power_curve(s, 2, c, q(0), q(1), SVG_CURVE);
    svg_arrow(s, at(q(0), r(1, 2)), at(q(0), r(9, 10)), SVG_POINT);
    svg_label(s, at(q(0), r(9, 10)), SVG_E, SVG_POINT, "P'");
    for (int k = 1; k <= 3; k += 2)
        svg_mark(s, at(r(1, 4), r(k, 4)), SVG_POINT, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_MUTED, "$x=1/4$");
    return s;
}

FIGURE(degrees_two_and_three)
{
    svg *s = svg_new("degrees_two_and_three", "What a quadratic curve is, and what it is not",
                     "The parabola (t, t squared) is a polynomial curve of degree two, and bends to one side.  A cubic "
                     "is the first that can bend to the other side: (t, t cubed) does so at t = 0.");
    const int coefficients[2][8] = {{0, 0, 1, 0, 0, 1, 0, 0}, {0, 0, 1, 0, 0, 0, 0, 1}};
    for (int panel = 0; panel < 2; panel++) {
        num_q c[8];
        integers(8, coefficients[panel], c);
        svg_panel(s, window(q(-1), q(-1), q(1), q(1)), 240, 0, panel ? "$(t,t^3)$" : "$(t,t^2)$");
        svg_axes(s, q(1), q(1), NULL, NULL);
        svg_line(s, at(r(panel ? 0 : -1, 2), panel ? q(0) : r(1, 4)), at(q(panel), q(0)), SVG_MUTED);
        if (!panel)
            svg_line(s, at(r(1, 2), r(1, 4)), at(r(1, 4), q(0)), SVG_MUTED);
        put_power_curve(s, 3, c, q(-1), q(1), SVG_CURVE);
        svg_mark(s, panel ? svg_at(0, 0) : at(r(-1, 2), r(1, 4)), SVG_POINT, SVG_USUAL);
        if (!panel)
            svg_mark(s, at(r(1, 2), r(1, 4)), SVG_POINT, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_MUTED, "tangents: on one side, and crossed");
    return s;
}
