/* nurbs-de-boor.figure.c -- drawings for nurbs-de-boor.claims.h. */
#include "chapters/nurbs/curve-of-claim.h"

FIGURE(deboor_triangle)
{
    static const int point[] = {0, 0, 1, 7, 9, 8, 12, 1}, knot[] = {-3, -2, -1, 0, 6, 7, 8, 9};
    static const int heavy[] = {1, 1, 3, 1};
    static const enum svg_direction side[] = {SVG_SW, SVG_NW, SVG_NE, SVG_SE};
    svg *s = svg_new("deboor_triangle", "De Boor's algorithm with weights",
                     "A segment of a cubic NURBS curve, and the three levels of the recursion at the middle of its "
                     "interval; left with the weights 1, "
                     "right with the weight 3 at r3, which draws every point of the levels towards r3.");
    for (int panel = 0; panel < 2; panel++) {
        spline c = spline_of(4, 3, knot, 1, point, 1, panel ? heavy : NULL);
        num_q R[8], w[4], t = q(3);
        svg_panel(s, svg_integer_window(-1, -1, 13, 9), 380, 0, panel ? "weights 1, 1, 3, 1" : "all weights 1");
        draw_polygon(s, c, "r", side, SVG_POLYGON);
        for (int i = 0; i < 8; i++)
            R[i] = c.R[i];
        for (int i = 0; i < 4; i++)
            w[i] = c.w[i];
        for (int level = 1; level <= 3; level++) {
            nurbs_deboor_level_q(nurbs_on_span_q(3, 2, c.u, 3, NULL, NULL), level, R, w, t);
            svg_polyline(s, 4 - level, R, SVG_FAMILY);
            for (int m = 0; m < 4 - level; m++) {
                static const enum svg_direction towards[4][3] = {
                    {SVG_N}, {SVG_W, SVG_N, SVG_E}, {SVG_W, SVG_E}, {SVG_S}};
                char name[40];
                snprintf(name, sizeof name, "r_%d^{[%d]}", level + 1 + m, level);
                svg_mark(s, svg_pair(R + 2 * m), level == 3 ? SVG_CURVE : SVG_POINT, SVG_USUAL);
                if (panel == 0 || level == 3)
                    svg_label(s, svg_pair(R + 2 * m), towards[level][m], level == 3 ? SVG_CURVE : SVG_POINT, name);
            }
        }
        draw_spline(s, c, SVG_CURVE);
    }
    svg_legend_line(s, SVG_CURVE, "the segment over $[t_4,t_5)$");
    svg_legend_line(s, SVG_FAMILY, "the polygons of the levels at $t$");
    return s;
}

FIGURE(wrong_interval)
{
    static const enum svg_direction side[] = {SVG_SW, SVG_N, SVG_S, SVG_NE};
    svg *s = svg_new("wrong_interval", "The recursion on another interval",
                     "A quadratic NURBS curve of two segments.  For t = 7/2, in the interval [t3, t4), the recursion "
                     "with j = 4 ends in a point of the "
                     "second segment, continued backwards, and not on the curve.");
    const char *name = "other_interval_gives_other_point";
    spline c = spline_of_claim(name, 4, 2);
    num_q P[2 * 33], Q[2], t = number_of_claim(name, "t");
    svg_panel(s, window(r(-1, 2), r(-1, 2), r(7, 2), r(5, 2)), 400, 0, "$k=3$, $t_i=i$, $t=7/2$ in $[t_3,t_4)$");
    draw_polygon(s, c, "r", side, SVG_POLYGON);
    for (int i = 0; i <= 32; i++)
        nurbs_point_q(nurbs_on_span_q(2, 2, c.u, 3, c.R, c.w), add_q(q(3), r(i, 32)), P + 2 * i);
    svg_polyline(s, 33, P, SVG_WRONG);
    draw_spline(s, c, SVG_CURVE);
    nurbs_point_q(nurbs_on_span_q(2, 2, c.u, 3, c.R, c.w), t, Q);
    svg_mark(s, svg_pair(Q), SVG_WRONG, SVG_USUAL);
    svg_mark(s, spline_point(c, t), SVG_RIGHT, SVG_USUAL);
    svg_label(s, svg_pair(Q), SVG_SE, SVG_WRONG, "j=4");
    svg_label(s, spline_point(c, t), SVG_S, SVG_RIGHT, "j=3");
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_mark(s, SVG_RIGHT, SVG_USUAL, "$r(7/2)$, with the $j$ of the interval");
    svg_legend_line(s, SVG_WRONG, "the segment of $j=4$ continued to $[t_3,t_4)$");
    return s;
}
