/* line-of-the-proof.figure.c -- drawings for line-of-the-proof.claims.h. */
#include "chapters/shape-parameter/drawing.h"

FIGURE(line_along_an_edge)
{
    svg *s =
        svg_new("line_along_an_edge", "A line that contains an edge of the polygon",
                "The convex polygon of the points (i, i(7-i)).  The line y = 12 contains the edge from P₃ to P₄ and "
                "has it on no side; the line y = 8 crosses two edges.");
    num_q P[16];
    data_of("line_through_an_edge_has_no_two_sides", "P", 8, 2, P);
    svg_panel(s, window(q(-1), q(-1), q(8), q(14)), 380, 260, NULL);
    svg_polyline(s, 8, P, SVG_POLYGON);
    static const char *const names[8] = {"P_0", "P_1", "P_2", "P_3", "P_4", "P_5", "P_6", "P_7"};
    for (int i = 0; i <= 7; i++) {
        svg_mark(s, svg_pair(P + 2 * i), SVG_POLYGON, SVG_USUAL);
        svg_label(s, svg_pair(P + 2 * i), i == 3 || i == 4 ? SVG_N : i < 3 ? SVG_W : SVG_E, SVG_POLYGON, names[i]);
    }
    svg_line(s, svg_at(0, 12), svg_at(1, 12), SVG_WRONG);
    svg_line(s, svg_at(0, 8), svg_at(1, 8), SVG_RIGHT);
    svg_legend_line(s, SVG_WRONG, "contains an edge");
    svg_legend_line(s, SVG_RIGHT, "crosses two edges");
    return s;
}

FIGURE(polygon_crossing_itself)
{
    svg *s =
        svg_new("polygon_crossing_itself", "A polygon that crosses itself on a line",
                "A polygon of eight points whose first and last edges meet the x-axis in the same point: it changes "
                "sides twice and has one point on the line.");
    static const enum svg_direction towards[] = {SVG_NW, SVG_E, SVG_E, SVG_S, SVG_S, SVG_W, SVG_W, SVG_NE};
    num_q P[16];
    data_of("polygon_that_crosses_itself_on_the_line", "P", 8, 2, P);
    svg_panel(s, window(r(-7, 2), r(-7, 2), r(7, 2), r(5, 2)), 380, 0, "$SA=2$, one point on $L$");
    svg_line(s, svg_at(0, 0), svg_at(1, 0), SVG_RIGHT);
    svg_label(s, svg_at(3, 0), SVG_N, SVG_RIGHT, "L");
    svg_control_polygon_towards(s, 7, P, "P", towards);
    svg_mark(s, svg_at(0, 0), SVG_WRONG, SVG_USUAL);
    svg_legend_line(s, SVG_POLYGON, "the polygon");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "the point, passed twice");
    return s;
}
