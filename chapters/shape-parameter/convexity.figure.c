/* convexity.figure.c -- drawings for convexity.claims.h. */
#include "chapters/shape-parameter/drawing.h"

FIGURE(convexity_lost)
{
    svg *s =
        svg_new("convexity_lost", "Convex polygons whose curves are not convex",
                "Left the triangle (0,0), (1,1), (2,0) with the curve of β = -7, which meets the base three times, and "
                "that of β = -21/4, which is convex.  Right a flat convex polygon at height 100, the printed curve of "
                "β = 1, which crosses a line four times, and the corrected one.");
    num_q P[16];
    svg_panel(s, window(r(-1, 10), r(-1, 10), r(21, 10), r(11, 10)), 380, 0, "$P_0=P_1$, $P_2$, $P_3=...=P_7$");
    put_triangle(s, q(0));
    data_of("printed_curve_of_a_convex_polygon_meets_a_line_four_times", "P", 8, 2, P);
    svg_panel(s, window(r(-1, 4), r(193, 2), r(29, 4), r(203, 2)), 340, 230, "$β=1$, $y$ from 96.5 to 101.5");
    svg_polyline(s, 8, P, SVG_POLYGON);
    put_curve(s, 1, 7, P, q(1), SVG_WRONG);
    put_curve(s, 0, 7, P, q(1), SVG_RIGHT);
    svg_line(s, at(q(0), r(401, 4)), at(q(1), r(401, 4)), SVG_POINT);
    svg_frame(s);
    svg_legend_line(s, SVG_POLYGON, "the polygon");
    svg_legend_line(s, SVG_WRONG, "$β=-7$; as printed");
    svg_legend_line(s, SVG_RIGHT, "$β=-21/4$; corrected");
    svg_legend_line(s, SVG_POINT, "a line");
    return s;
}
