/* envelope-uniqueness-plane.figure.c -- drawings for envelope-uniqueness-plane.claims.h. */
#include "chapters/nurbs/family-figures.h"

FIGURE(nurbs_folded_line)
{
    svg *s = svg_new("nurbs_folded_line", "On a line every pair is a solution",
                     "A quadratic segment whose points are on a line, drawn with its parameter upwards: it runs from "
                     "1/2 to 3/4 and back.  The member of the parameter 2 runs "
                     "from 1/2 to 1.");
    svg_panel(s, window(q(0), q(2), r(11, 10), q(3)), 420, 240,
              "$k=3$, points 0, 1, 0 on a line; $t$ upwards, the point to the right");
    svg_axes(s, r(1, 4), r(1, 2), "x", "t");
    num_q curve[6] = {r(1, 2), q(2), q(1), r(5, 2), r(1, 2), q(3)};
    svg_bezier(s, 2, curve, SVG_CURVE);
    svg_segment(s, at(r(1, 2), q(2)), at(q(1), q(3)), SVG_WRONG);
    svg_mark(s, at(r(7, 8), r(11, 4)), SVG_WRONG, SVG_USUAL);
    svg_label(s, at(r(7, 8), r(11, 4)), SVG_E, SVG_WRONG, "7/8");
    svg_legend_line(s, SVG_CURVE, "$r(t)$, at most $3/4$");
    svg_legend_line(s, SVG_WRONG, "the member of $τ=2$, a solution $τ(t)=2$");
    return s;
}

/* The coordinates x and z of the points of one span of a cubic, weights 1, seen along the plane z = 0. */
FIGURE(points_off_the_plane)
{
    svg *s = svg_new("points_off_the_plane", "The sum of the triple products is zero, the products are not",
                     "Two cubics of space seen along the plane z = 0.  Left the osculating plane of (t + 1, t², t³) at "
                     "t = 0 contains "
                     "the origin, and none of the four control points.  Right the three points of level 1 of (t, t², "
                     "(t - 1)³) at τ = "
                     "1 are in the plane: each leg of the control polygon crosses it there, and its ends are off it.");
    static const int x[2][4] = {{1, 1}, {0, 1}}, z[2][4] = {{0, 0, 0, 1}, {-1, 3, -3, 1}};
    static const int half[2] = {1, 2};
    static const enum svg_direction side[2][4] = {{SVG_E, SVG_N, SVG_S, SVG_W}, {SVG_E, SVG_N, SVG_S, SVG_W}};
    static const char *const name[] = {"r_1", "r_2", "r_3", "r_4"};
    for (int k = 0; k < 2; k++) {
        struct nurbs c = one_span(3, half[k], x[k], z[k]);
        svg_panel(s, k == 0 ? window(q(-3), q(-17), q(5), q(17)) : window(q(-7), q(-240), q(8), q(60)), 340, 280,
                  k == 0 ? "$(t+1,t^2,t^3)$, $t=0$: the plane\ncontains the origin"
                         : "$(t,t^2,(t-1)^3)$, $r=2$, $τ=1$: level 1\nis in the plane");
        svg_segment(s, k == 0 ? svg_at(-3, 0) : svg_at(-7, 0), k == 0 ? svg_at(5, 0) : svg_at(8, 0), SVG_RIGHT);
        num_q R[8], d[12];
        for (int i = 0; i < 4; i++)
            R[2 * i] = c.H[3 * i], R[2 * i + 1] = c.H[3 * i + 1];
        for (int m = 0; m < 12; m++)
            d[m] = c.H[m];
        svg_polyline(s, 4, R, SVG_POLYGON);
        put_curve(s, &c, SVG_CURVE);
        for (int i = 0; i < 4; i++) {
            svg_mark(s, svg_pair(R + 2 * i), SVG_WRONG, SVG_USUAL);
            svg_label(s, svg_pair(R + 2 * i), side[k][i], SVG_WRONG, name[i]);
        }
        if (k == 0) {
            svg_mark(s, svg_at(0, 0), SVG_POINT, SVG_USUAL);
            svg_label(s, svg_at(0, 0), SVG_SW, SVG_POINT, "0");
            continue;
        }
        bspline_deboor_level_q(on_span_q(3, 3, c.u, 3, NULL), 1, d, q(1));
        for (int i = 0; i < 3; i++)
            svg_mark(s, svg_pair(d + 3 * i), SVG_RIGHT, SVG_USUAL);
    }
    svg_legend_line(s, SVG_CURVE, "the segment");
    svg_legend_line(s, SVG_RIGHT, "the plane, from the side");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "control points, off it");
    svg_legend_mark(s, SVG_RIGHT, SVG_USUAL, "the points of level 1");
    return s;
}
