/* geometric-definition.figure.c -- drawings for geometric-definition.claims.h. */
#include "chapters/nurbs/family-figures.h"

#include <stdio.h>

FIGURE(nurbs_polygons)
{
    svg *s = svg_new("nurbs_polygons", "A curve as the envelope of polygons",
                     "Left a polygon as a curve of order 2 that skips a leg because two knots are one.  Right a cubic "
                     "spline, weights 1, and its polygons of level 2 for "
                     "parameters of the whole domain; one is emphasized, with the point where it touches.");
    static const int jump_knot[6] = {0, 1, 2, 2, 3, 4}, jump[12] = {0, 0, 1, 1, 2, 1, 4, 2, 1, 5, 0, 1};
    struct nurbs line = nurbs_of(4, 1, jump_knot, jump, 1);
    svg_panel(s, window(q(-1), q(-1), q(6), q(3)), 300, 0, "$k=2$, $u_2=u_3$:\nthe leg $R_1R_2$ is not run through");
    put_polygon(s, &line, "R");
    put_curve(s, &line, SVG_CURVE);
    svg_segment(s, svg_at(1, 2), svg_at(4, 2), SVG_WRONG);
    static const int knot[10] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10},
                     point[18] = {0, 0, 1, 1, 4, 1, 4, 6, 1, 8, 5, 1, 10, 2, 1, 9, -1, 1};
    struct nurbs c = nurbs_of(6, 3, knot, point, 1);
    svg_panel(s, window(q(1), q(2), q(10), q(8)), 400, 0,
              "$k=4$, $n=6$: the polygons $r^{[2]}(t,τ)$,\n$τ$ in the whole domain");
    for (int k = 0; k <= 12; k++)
        for (int mu = 3; mu < 6; mu++)
            put_member(s, &c, mu, 2, add_q(q(4), r(k, 4)), SVG_FAMILY);
    put_curve(s, &c, SVG_CURVE);
    for (int mu = 3; mu < 6; mu++)
        put_member(s, &c, mu, 2, r(11, 2), SVG_CURVE_2);
    svg_mark(s, point_of(&c, 4, r(11, 2)), SVG_POINT, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_WRONG, "not run through");
    svg_legend_line(s, SVG_CURVE_2, "the polygon of $τ=11/2$");
    svg_legend_line(s, SVG_FAMILY, "other polygons");
    return s;
}

FIGURE(nurbs_polygons_extra)
{
    svg *s = svg_new("nurbs_polygons_extra", "A leg all of whose points satisfy the condition",
                     "A convex cubic spline curve with two spans and a strictly convex control polygon.  The second "
                     "segment, continued backwards, has an inflection at the parameter 9/2 of the "
                     "first span; the leg of the polygon of this parameter lies on the tangent there.");
    static const int knot[9] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    static const int point[15] = {-12, 264, 1, -4, 24, 1, 4, -24, 1, 12, 120, 1, 20, 840, 1}; /* over 8 */
    struct nurbs c = nurbs_of(5, 3, knot, point, 8);
    svg_panel(s, window(r(-1, 2), q(-4), r(3, 2), q(9)), 460, 330, "$k=4$, $n=5$, two spans");
    for (int k = 0; k <= 16; k++)
        for (int mu = 3; mu < 5; mu++)
            put_member(s, &c, mu, 2, add_q(q(4), r(k, 8)), SVG_FAMILY);
    put_polygon(s, &c, NULL);
    put_curve(s, &c, SVG_CURVE);
    put_member(s, &c, 3, 2, r(9, 2), SVG_CURVE_2);
    put_member(s, &c, 4, 2, r(9, 2), SVG_WRONG);
    svg_mark(s, at(r(1, 3), q(0)), SVG_WRONG, SVG_USUAL);
    svg_mark(s, point_of(&c, 3, q(5)), SVG_MUTED, SVG_USUAL);
    svg_frame(s);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_CURVE_2, "the polygon of $τ=9/2$");
    svg_legend_line(s, SVG_WRONG, "its leg, a solution");
    svg_legend_line(s, SVG_POLYGON, "control polygon");
    svg_legend_line(s, SVG_FAMILY, "other polygons");
    return s;
}

FIGURE(recursion_indices)
{
    enum { n = 4 };
    svg *s = svg_new("recursion_indices", "Which points the recursion asks for",
                     "The points of the levels 0, 1 and 2 for n = 4, each with arrows from the two that it is computed "
                     "from.  With i = 2, ..., n on every level the second level asks for a point of level 1 with the "
                     "index 1, and that for the point with the index 0, which does not exist.");
    svg_panel(s, window(r(-1, 2), r(-3, 4), r(5, 2), r(19, 4)), 400, 300,
              "$k=4$, $n=4$; level $r$ to the right, index $i$ upwards");
    for (int level = 0; level <= 2; level++)
        for (int i = 0; i <= n; i++) {
            int good = i >= level + 1, asked = good || (level > 0 && i >= level) || (level == 0 && i == 0);
            char name[24];
            if (!asked)
                continue;
            snprintf(name, sizeof name, level > 0 ? "r_%d^{[%d]}" : "r_%d", i, level);
            for (int from = i - 1; level > 0 && from <= i; from++)
                svg_arrow(s, at(q(level - 1), q(from)), at(sub_q(q(level), r(1, 10)), sub_q(q(i), r(i - from, 10))),
                          good ? SVG_FAMILY : SVG_WRONG);
            svg_mark(s, svg_at(level, i), good ? SVG_POINT : SVG_WRONG, SVG_USUAL);
            if (level == 1)
                svg_label_at(s, svg_at(level, i), SVG_MIDDLE, 0, 105, good ? SVG_POINT : SVG_WRONG, name);
            else
                svg_label(s, svg_at(level, i), level == 0 ? SVG_W : SVG_E, good ? SVG_POINT : SVG_WRONG, name);
        }
    svg_legend_mark(s, SVG_POINT, SVG_USUAL, "$i=r+1,…,n$");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "asked for by $i=2$ on level 2");
    return s;
}
