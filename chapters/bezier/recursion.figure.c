/* Figures of the section on the recursion. */
#include "chapters/judge/figure.h"
#include "figures/words.h"

FIGURE(two_curves_of_one_point_less)
{
    svg *s = svg_new("two_curves_of_one_point_less", "A cubic from two curves of degree 2",
                     "The curves of the first three and of the last three points, and the cubic, each of whose points "
                     "divides the segment between theirs in the ratio t : (1 - t).");
    static const int from[8] = {0, 0, 1, 4, 6, 5, 8, 0};
    num_q b[8], near[2], far[2], P[2];
    integers(8, from, b);
    svg_panel(s, window(q(-1), q(-1), q(9), q(6)), 460, 0, "$P_{0,3}=(1-t)P_{0,2}+tP_{1,3}$, $t=1/5,...,4/5$");
    svg_control_polygon(s, 3, b, "P");
    svg_bezier(s, 2, b, SVG_CURVE_2);
    svg_bezier(s, 2, b + 2, SVG_RIGHT);
    for (int k = 1; k <= 4; k++) {
        bezier_casteljau_q(2, 2, b, r(k, 5), near);
        bezier_casteljau_q(2, 2, b + 2, r(k, 5), far);
        bezier_casteljau_q(3, 2, b, r(k, 5), P);
        svg_segment(s, svg_pair(near), svg_pair(far), SVG_FAMILY);
        svg_mark(s, svg_pair(near), SVG_CURVE_2, SVG_USUAL);
        svg_mark(s, svg_pair(far), SVG_RIGHT, SVG_USUAL);
        svg_mark(s, svg_pair(P), SVG_CURVE, SVG_USUAL);
    }
    svg_bezier(s, 3, b, SVG_CURVE);
    svg_legend_line(s, SVG_CURVE, "$P_{0,3}$");
    svg_legend_line(s, SVG_CURVE_2, "$P_{0,2}$");
    svg_legend_line(s, SVG_RIGHT, "$P_{1,3}$");
    return s;
}

FIGURE(crowded_points)
{
    svg *s =
        svg_new("crowded_points", "Many points, and points everywhere",
                "The parabola y = x squared with nine points that crowd at 0, and with nine points in equal steps; "
                "the last chord of the first polyline stays where it is however many points follow.");
    num_q b[6] = {q(0), q(0), r(1, 2), q(0), q(1), q(1)}, P[18];
    for (int k = 0; k < 2; k++) {
        svg_panel(s, window(r(-1, 20), r(-1, 20), r(21, 20), r(21, 20)), 320, 0,
                  k ? "$t=0,1/8,2/8,...,1$" : "$t=0,2^{-7},...,2^{-1},1$");
        for (int i = 0; i <= 8; i++)
            bezier_casteljau_q(2, 2, b, k ? r(i, 8) : i == 0 ? q(0) : r(1, 1 << (8 - i)), P + 2 * i);
        svg_bezier(s, 2, b, SVG_CURVE);
        svg_polyline(s, 9, P, k ? SVG_RIGHT : SVG_WRONG);
        for (int i = 0; i <= 8; i++)
            svg_mark(s, svg_pair(P + 2 * i), SVG_POINT, SVG_USUAL);
        svg_frame(s);
    }
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_WRONG, "points that crowd");
    svg_legend_line(s, SVG_RIGHT, "points in equal steps");
    return s;
}
