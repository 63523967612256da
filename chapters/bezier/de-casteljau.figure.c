#include "chapters/judge/figure.h"
#include "exact/kernels_q.h"
#include "figures/svg.h"

#include <stdio.h>

enum { CUBIC = 3 };

static void cubic(num_q b[])
{
    static const int at[] = {0, 0, 2, 6, 8, 7, 10, 1};
    for (int m = 0; m < 2 * (CUBIC + 1); m++)
        b[m] = from_int_q(at[m]);
}

FIGURE(casteljau_triangle)
{
    num_q b[2 * (CUBIC + 1)], w[2 * (CUBIC + 1)], t = from_ratio_q(2, 5);
    svg *s =
        svg_new("casteljau_triangle", "De Casteljau's algorithm",
                "A cubic curve with its polygon; every edge divided in the ratio 2:3, the edges between the new points "
                "again, until the point of the curve at t = 2/5 is left.");
    cubic(b);
    svg_panel(s, (svg_window){from_int_q(-1), from_int_q(-1), from_int_q(11), from_int_q(8)}, 460, 0,
              "every edge divided in the ratio $t:(1-t)$, $t=2/5$");
    svg_bezier(s, CUBIC, b, SVG_CURVE);
    svg_control_polygon(s, CUBIC, b, "b");
    for (int m = 0; m < 2 * (CUBIC + 1); m++)
        w[m] = b[m];
    for (int k = 1; k <= CUBIC; k++) {
        bezier_casteljau_level_q(CUBIC + 1 - k, 2, w, t);
        svg_polyline(s, CUBIC + 1 - k, w, SVG_FAMILY);
        for (int i = 0; i <= CUBIC - k; i++) {
            static const enum svg_direction towards[CUBIC + 1][CUBIC] = {
                {SVG_N}, {SVG_W, SVG_N, SVG_NE}, {SVG_NW, SVG_NE}, {SVG_S}};
            char name[16];
            snprintf(name, sizeof name, "b_%d^%d", i, k);
            svg_mark(s, svg_pair(w + 2 * i), k == CUBIC ? SVG_CURVE : SVG_POINT, SVG_USUAL);
            svg_label(s, svg_pair(w + 2 * i), towards[k][i], k == CUBIC ? SVG_CURVE : SVG_POINT, name);
        }
    }
    return s;
}

FIGURE(bezier_split)
{
    num_q b[2 * (CUBIC + 1)], left[2 * (CUBIC + 1)], right[2 * (CUBIC + 1)];
    svg *s = svg_new("bezier_split", "Subdivision",
                     "The two sides of de Casteljau's triangle are the polygons of the two parts of the curve.");
    cubic(b);
    bezier_split_q(CUBIC, 2, b, from_ratio_q(2, 5), left, right);
    svg_panel(s, (svg_window){from_int_q(-1), from_int_q(-1), from_int_q(11), from_int_q(8)}, 460, 0,
              "the two sides of the triangle at $t=2/5$");
    svg_polyline(s, CUBIC + 1, b, SVG_MUTED);
    svg_bezier(s, CUBIC, left, SVG_CURVE);
    svg_bezier(s, CUBIC, right, SVG_CURVE_2);
    svg_polyline(s, CUBIC + 1, left, SVG_POLYGON);
    svg_polyline(s, CUBIC + 1, right, SVG_POLYGON);
    static const char *const left_name[] = {"b_0", "b_0^1", "b_0^2", "b_0^3"};
    static const char *const right_name[] = {NULL, "b_1^2", "b_2^1", "b_3"};
    static const enum svg_direction left_side[] = {SVG_SW, SVG_W, SVG_NW, SVG_S};
    static const enum svg_direction right_side[] = {SVG_S, SVG_NE, SVG_NE, SVG_SE};
    for (int i = 0; i <= CUBIC; i++) {
        svg_mark(s, svg_pair(left + 2 * i), SVG_CURVE, SVG_USUAL);
        svg_label(s, svg_pair(left + 2 * i), left_side[i], SVG_CURVE, left_name[i]);
        if (i == 0)
            continue;
        svg_mark(s, svg_pair(right + 2 * i), SVG_CURVE_2, SVG_USUAL);
        svg_label(s, svg_pair(right + 2 * i), right_side[i], SVG_CURVE_2, right_name[i]);
    }
    svg_legend_line(s, SVG_CURVE, "over $[0,t]$");
    svg_legend_line(s, SVG_CURVE_2, "over $[t,1]$");
    svg_legend_line(s, SVG_MUTED, "the polygon before");
    return s;
}
