/* Figures of the section on a curve and its polygon. */
#include "chapters/judge/figure.h"
#include "exact/record/hull.h"
#include "figures/words.h"

#include <stdio.h>

FIGURE(bezier_hull)
{
    svg *s = svg_new("bezier_hull", "The curve in the hull of its points",
                     "A curve of degree 5 with its polygon and the shaded convex hull of the points; beyond the unit "
                     "interval it leaves the hull.");
    static const int from[12] = {0, 1, 1, 5, 4, 1, 3, 6, 8, 5, 7, 0};
    num_q b[12], corner[12], beyond[12];
    int vertex[7];
    integers(12, from, b);
    int count = convex_hull_2d(6, b, vertex);
    for (int k = 0; k < count; k++)
        corner[2 * k] = b[2 * vertex[k]], corner[2 * k + 1] = b[2 * vertex[k] + 1];
    svg_panel(s, window(q(-1), q(-1), q(9), q(7)), 460, 0, "degree 5, and the hull of six points");
    svg_area(s, count, corner, SVG_FILL);
    bezier_on_interval_q(5, 2, b, q(1), r(9, 8), beyond);
    svg_bezier(s, 5, beyond, SVG_WRONG);
    bezier_on_interval_q(5, 2, b, r(-1, 8), q(0), beyond);
    svg_bezier(s, 5, beyond, SVG_WRONG);
    static const enum svg_direction towards[] = {SVG_W, SVG_N, SVG_SE, SVG_NW, SVG_NE, SVG_E};
    svg_control_polygon_towards(s, 5, b, "P", towards);
    svg_bezier(s, 5, b, SVG_CURVE);
    svg_legend_line(s, SVG_CURVE, "$0≤t≤1$");
    svg_legend_line(s, SVG_WRONG, "$t<0$ and $t>1$");
    svg_legend_area(s, SVG_FILL, "convex hull");
    return s;
}

FIGURE(edges_and_end_tangents)
{
    svg *s = svg_new("edges_and_end_tangents", "The ends of a curve and its tangents there",
                     "A cubic that begins and ends with its polygon; a third of the derivative at each end is an edge; "
                     "right, the curve of the derivative, whose points are three times the edges.");
    static const int from[8] = {0, 0, 1, 3, 4, 4, 6, 1};
    num_q b[8], D[8];
    integers(8, from, b);
    svg_panel(s, window(q(-1), q(-1), q(7), q(5)), 330, 0, "$P\\'(0)/3=P_1-P_0$, $P\\'(1)/3=P_3-P_2$");
    svg_control_polygon(s, 3, b, "P");
    svg_bezier(s, 3, b, SVG_CURVE);
    svg_arrow(s, svg_pair(b), svg_pair(b + 2), SVG_RIGHT);
    svg_arrow(s, svg_pair(b + 4), svg_pair(b + 6), SVG_RIGHT);
    for (int m = 0; m < 8; m++)
        D[m] = b[m];
    bezier_hodograph_q(3, 2, D);
    svg_panel(s, window(q(-1), q(-10), q(10), q(10)), 170, 0, "$P\\'(t)$");
    svg_axes(s, q(5), q(5), NULL, NULL);
    static const enum svg_direction towards[] = {SVG_W, SVG_NE, SVG_W};
    svg_control_polygon_towards(s, 2, D, "D", towards);
    svg_bezier(s, 2, D, SVG_CURVE_2);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_CURVE_2, "its derivative");
    svg_legend_line(s, SVG_RIGHT, "a third of the derivative at the ends");
    return s;
}

FIGURE(read_from_either_end)
{
    svg *s = svg_new("read_from_either_end", "The points backwards, and the mirror image",
                     "Left, the polygon numbered from the other end: the same curve, its points P(i/8) with the "
                     "parameters 1 - i/8.  Right, a parabola and its mirror image, which is another curve.");
    static const int from[8] = {0, 0, 1, 3, 4, 4, 6, 1};
    num_q b[8], P[2];
    integers(8, from, b);
    svg_panel(s, window(q(-1), q(-1), q(7), q(5)), 330, 0, "the points with $t$ from either end");
    svg_polyline(s, 4, b, SVG_POLYGON);
    svg_bezier(s, 3, b, SVG_CURVE);
    for (int i = 0; i <= 4; i++) {
        char name[24];
        static const char *const forward[] = {"0", "1/4", "1/2", "3/4", "1"};
        bezier_casteljau_q(3, 2, b, r(i, 4), P);
        svg_mark(s, svg_pair(P), SVG_CURVE, SVG_USUAL);
        snprintf(name, sizeof name, "%s", forward[i]);
        svg_label(s, svg_pair(P), i < 3 ? SVG_SE : SVG_SW, SVG_CURVE, name);
        snprintf(name, sizeof name, "%s", forward[4 - i]);
        svg_label(s, svg_pair(P), i < 3 ? SVG_NW : SVG_NE, SVG_CURVE_2, name);
    }
    num_q curve[6] = {q(0), q(0), q(0), q(1), q(1), q(0)}, image[6] = {q(1), q(0), q(1), q(1), q(0), q(0)};
    svg_panel(s, window(r(-1, 5), r(-1, 5), r(6, 5), r(6, 5)), 230, 0, "the curve and its mirror image");
    svg_polyline(s, 3, curve, SVG_POLYGON);
    svg_bezier(s, 2, curve, SVG_CURVE);
    svg_bezier(s, 2, image, SVG_WRONG);
    svg_mark(s, at(r(1, 4), r(1, 2)), SVG_CURVE, SVG_USUAL);
    svg_mark(s, at(r(3, 4), r(1, 2)), SVG_WRONG, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "the curve, $t$ of $P_0,...,P_n$");
    svg_legend_line(s, SVG_CURVE_2, "$t$ of $P_n,...,P_0$");
    svg_legend_line(s, SVG_WRONG, "the mirror image");
    return s;
}

FIGURE(degrees_one_to_three)
{
    svg *s =
        svg_new("degrees_one_to_three", "Bézier curves of degree 1, 2 and 3",
                "A segment, an arc of a parabola and a cubic, each with its polygon of two, three and four points.");
    static const int from[3][8] = {{0, 0, 4, 3}, {0, 0, 3, 4, 4, 0}, {0, 0, 0, 3, 3, 4, 4, 0}};
    static const enum svg_direction towards[3][4] = {
        {SVG_S, SVG_N}, {SVG_S, SVG_N, SVG_S}, {SVG_S, SVG_NW, SVG_N, SVG_S}};
    static const char *const caption[3] = {"$n=1$", "$n=2$", "$n=3$"};
    for (int n = 1; n <= 3; n++) {
        num_q b[8];
        integers(2 * (n + 1), from[n - 1], b);
        svg_panel(s, window(q(-1), q(-1), q(5), q(5)), 200, 0, caption[n - 1]);
        svg_control_polygon_towards(s, n, b, "P", towards[n - 1]);
        svg_bezier(s, n, b, SVG_CURVE);
    }
    return s;
}
