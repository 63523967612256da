/* Figures of the section on parameters. */
#include "chapters/hermite-coons/drawing.h"

FIGURE(graphs_and_axes)
{
    svg *s = svg_new("graphs_and_axes", "What no graph y = f(x) can be",
                     "A parabola and its image turned by a right angle, with two points over one x; the unit circle "
                     "with its upright tangent at (1, 0) and two points over x = 3/5; a cubic with a crossing.");
    svg_panel(s, window(r(-9, 5), r(-7, 5), r(9, 5), r(9, 5)), 230, 0, "turned by a right angle");
    svg_axes(s, q(1), q(1), "x", "y");
    /* y = x^2 over [-6/5, 6/5] */
    num_q R[6] = {r(-6, 5), r(36, 25), q(0), r(-36, 25), r(6, 5), r(36, 25)}, Q[6];
    for (int i = 0; i < 3; i++)
        Q[2 * i] = neg_q(R[2 * i + 1]), Q[2 * i + 1] = R[2 * i];
    svg_bezier(s, 2, R, SVG_CURVE);
    svg_bezier(s, 2, Q, SVG_CURVE_2);
    svg_line(s, svg_at(-1, 0), svg_at(-1, 1), SVG_MUTED);
    svg_mark(s, svg_at(-1, 1), SVG_CURVE_2, SVG_USUAL);
    svg_mark(s, svg_at(-1, -1), SVG_CURVE_2, SVG_USUAL);
    svg_panel(s, window(r(-7, 5), r(-7, 5), r(7, 5), r(9, 5)), 206, 0, "two $y$ for one $x$,\nan upright tangent");
    svg_axes(s, q(1), q(1), "x", "y");
    svg_circle(s, svg_at(0, 0), q(1), SVG_CURVE);
    svg_line(s, at(r(3, 5), q(0)), at(r(3, 5), q(1)), SVG_MUTED);
    svg_mark(s, at(r(3, 5), r(4, 5)), SVG_CURVE, SVG_USUAL);
    svg_mark(s, at(r(3, 5), r(-4, 5)), SVG_CURVE, SVG_USUAL);
    svg_arrow(s, svg_at(1, 0), svg_at(1, 1), SVG_RIGHT);
    svg_label(s, svg_at(1, 1), SVG_NE, SVG_RIGHT, "P'");
    svg_panel(s, window(r(-7, 5), r(-7, 5), r(7, 5), r(9, 5)), 206, 0, "$(t^2-1,t^3-t)$");
    svg_axes(s, q(1), q(1), "x", "y");
    static const int loop[8] = {10, -15, -14, 31, -14, -31, 10, 15}; /* over [-3/2, 3/2], in eighths */
    put_bezier(s, 3, loop, 8, SVG_CURVE);
    svg_mark(s, svg_at(0, 0), SVG_CURVE, SVG_USUAL);
    return s;
}
