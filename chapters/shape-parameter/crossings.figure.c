/* crossings.figure.c -- drawings for crossings.claims.h. */
#include "chapters/shape-parameter/drawing.h"

FIGURE(crossings_off_the_polygon)
{
    svg *s = svg_new(
        "crossings_off_the_polygon", "Lines that meet the curve and not its polygon",
        "Left eight points on the line y = 1 and the printed curve of β = 1, which sinks below the line y = 63/64. "
        " Right a triangle, enlarged near its first corner: the curve of β = -7 crosses the line y = -1/200 "
        "below the triangle twice, that of β = -21/4 does not.");
    num_q P[16];
    data_of("printed_curve_crosses_a_line_off_its_polygon", "P", 8, 2, P);
    svg_panel(s, window(q(0), r(24, 25), q(7), r(101, 100)), 360, 250, "as printed, $β=1$ ($y$ stretched)");
    svg_axes(s, q(1), r(1, 100), "x", "y");
    svg_polyline(s, 8, P, SVG_POLYGON);
    put_curve(s, 1, 7, P, q(1), SVG_WRONG);
    svg_line(s, at(q(0), r(63, 64)), at(q(1), r(63, 64)), SVG_POINT);
    svg_panel(s, window(r(-1, 100), r(-3, 200), r(3, 25), r(1, 25)), 360, 250,
              "corrected, $β=-7$ and $β=-21/4$, near $P_0=P_1$");
    put_triangle(s, r(-1, 200));
    svg_legend_line(s, SVG_POLYGON, "the polygon");
    svg_legend_line(s, SVG_WRONG, "crosses the line");
    svg_legend_line(s, SVG_RIGHT, "$β=-21/4$");
    svg_legend_line(s, SVG_POINT, "the line");
    return s;
}
