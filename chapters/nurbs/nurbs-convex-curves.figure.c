/* nurbs-convex-curves.figure.c -- drawings for nurbs-convex-curves.claims.h. */
#include "chapters/nurbs/curve-of-claim.h"

FIGURE(convex_polygon_convex_spline)
{
    svg *s = svg_new("convex_polygon_convex_spline", "A convex polygon has a convex NURBS curve",
                     "Left: a convex polygon, polygons with knots inserted in the middle of all intervals once and "
                     "twice, and the curve. Middle: a convex polygon of five points, closed, and its periodic cubic "
                     "curve. Right: with a knot of multiplicity two the curve of order two is two "
                     "opposite sides of a square, and not continuous.");
    static const int point[] = {0, 2, 1, 0, 5, 0, 7, 2, 6, 5, 3, 6}, weight[] = {1, 1, 4, 1, 3, 1};
    static const int knot[] = {0, 1, 2, 4, 6, 8, 10, 11, 12, 13};
    static const enum svg_direction side[] = {SVG_W, SVG_SW, SVG_SE, SVG_E, SVG_NE, SVG_NW};
    spline c = spline_of(6, 3, knot, 2, point, 1, weight), first = c, second;
    for (long i = 5; i <= 7; i += 2)
        first = with_knot(first, from_ratio_q(i, 2));
    second = first;
    for (long i = 9; i <= 15; i += 2)
        second = with_knot(second, from_ratio_q(i, 4));
    svg_panel(s, svg_integer_window(-1, -1, 8, 7), 380, 0,
              "corners cut and cut again; the ends of the domain\nare simple knots");
    svg_heading(s, SVG_RIGHT, "convex polygon, convex curve");
    draw_polygon(s, c, "r", side, SVG_POLYGON);
    svg_polyline(s, second.n, second.R, SVG_CURVE_2);
    svg_polyline(s, first.n, first.R, SVG_RIGHT);
    draw_spline(s, c, SVG_CURVE);
    static const int ring[] = {0, 0, 4, 0, 5, 3, 2, 5, 0, 1, 0, 0, 4, 0, 5, 3};
    static const int ring_knot[] = {-6, -4, -2, 0, 2, 4, 6, 8, 10, 12, 14, 16};
    static const enum svg_direction around[] = {SVG_SW, SVG_SE, SVG_E, SVG_N, SVG_W, SVG_HERE, SVG_HERE, SVG_HERE};
    c = spline_of(8, 3, ring_knot, 2, ring, 1, NULL);
    svg_panel(s, svg_integer_window(-1, -1, 6, 6), 230, 0, "$r_6, r_7, r_8 = r_1, r_2, r_3$:\na periodic cubic");
    svg_heading(s, SVG_RIGHT, "a closed convex polygon");
    draw_polygon(s, c, "r", around, SVG_POLYGON);
    draw_spline(s, c, SVG_CURVE);
    static const enum svg_direction corner[] = {SVG_SW, SVG_SE, SVG_NE, SVG_NW};
    svg_panel(s, scaled_window(-1, -1, 3, 3, 2), 210, 0,
              "$k = 2$, knots $0, 0, 1, 1, 2, 2$:\nthe curve jumps at $t = 1$");
    svg_heading(s, SVG_WRONG, "a $k$-fold knot");
    c = spline_of_claim("knot_of_full_multiplicity_tears_the_curve", 4, 1);
    draw_polygon(s, c, "r", corner, SVG_POLYGON);
    draw_spline(s, c, SVG_CURVE);
    svg_legend_line(s, SVG_CURVE, "curve");
    svg_legend_line(s, SVG_POLYGON, "polygon");
    svg_legend_line(s, SVG_RIGHT, "knots inserted once");
    svg_legend_line(s, SVG_CURVE_2, "and again");
    return s;
}
