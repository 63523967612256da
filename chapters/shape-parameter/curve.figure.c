/* curve.figure.c -- drawings for curve.claims.h. */
#include "chapters/shape-parameter/drawing.h"

FIGURE(curves_for_several_beta)
{
    svg *s = svg_new(
        "curves_for_several_beta", "The curves of several beta for one polygon",
        "One polygon of eight points and the nine curves of β = 1, 0, -1, ..., -7.  For fixed t the nine points "
        "stand on a straight segment in equal distances; three such segments are drawn.");
    static const int from[] = {0, 0, 0, 5, 3, 8, 6, 8, 9, 8, 12, 8, 15, 5, 15, 0};
    num_q P[16], ends[4];
    integers(2 * 8, from, P);
    svg_panel(s, window(q(-1), q(-1), q(16), q(9)), 500, 0, NULL);
    svg_control_polygon(s, 7, P, "P");
    nine_curves(s, P);
    for (int k = 1; k <= 3; k++) {
        shape_point_q(7, 2, P, q(-7), r(k, 4), ends);
        shape_point_q(7, 2, P, q(1), r(k, 4), ends + 2);
        svg_segment(s, svg_pair(ends), svg_pair(ends + 2), SVG_POINT);
    }
    svg_legend_line(s, SVG_POINT, "the points of $t=1/4,1/2,3/4$");
    return s;
}

FIGURE(end_edges)
{
    svg *s =
        svg_new("end_edges", "The tangent at the end of the curve",
                "The beginning of the curves of β = 1, -5 and -7.  The first two leave P₀ along the edge to P₁; the "
                "curve of β = -7 leaves it towards (5P₁ - P₂)/4, below the edge.");
    num_q P[16];
    data_of("edge_is_not_tangent_at_minus_seven", "P", 8, 2, P);
    svg_panel(s, window(r(-1, 10), r(-1, 5), r(3, 2), r(4, 5)), 440, 0, NULL);
    svg_polyline(s, 8, P, SVG_POLYGON);
    put_curve(s, 0, 7, P, q(1), SVG_CURVE);
    put_curve(s, 0, 7, P, q(-5), SVG_CURVE_2);
    put_curve(s, 0, 7, P, q(-7), SVG_WRONG);
    svg_point towards = at(r(3, 4), r(-1, 2));
    svg_segment(s, svg_at(0, 0), towards, SVG_MUTED);
    svg_mark(s, svg_at(0, 0), SVG_POLYGON, SVG_USUAL);
    svg_label(s, svg_at(0, 0), SVG_NW, SVG_POLYGON, "P_0");
    svg_mark(s, svg_at(1, 0), SVG_POLYGON, SVG_USUAL);
    svg_label(s, svg_at(1, 0), SVG_SE, SVG_POLYGON, "P_1");
    svg_frame(s);
    svg_legend_line(s, SVG_CURVE, "$β=1$");
    svg_legend_line(s, SVG_CURVE_2, "$β=-5$");
    svg_legend_line(s, SVG_WRONG, "$β=-7$");
    svg_legend_line(s, SVG_MUTED, "from $P_0$ towards $(5P_1-P_2)/4$");
    return s;
}

FIGURE(hull_and_sum)
{
    svg *s =
        svg_new("hull_and_sum", "The printed curve depends on the place of the origin",
                "Left a polygon near the origin with the printed and the corrected curve of β = 1, nearly the same.  "
                "Right the polygon moved up by 100: the corrected curve has moved with it, the printed one falls out "
                "of the convex hull.");
    static const int from[] = {0, 0, 1, 4, 2, 5, 3, 5, 4, 5, 5, 5, 6, 4, 7, 0};
    for (int far = 0; far <= 1; far++) {
        num_q P[16], up = q(100 * far);
        integers(2 * 8, from, P);
        for (int i = 0; i <= 7; i++)
            P[2 * i + 1] = add_q(P[2 * i + 1], up);
        svg_panel(s, window(r(-1, 2), sub_q(up, r(1, 2)), r(15, 2), add_q(up, r(11, 2))), 340, 0,
                  far ? "the points $P_i+(0,100)$" : "the points $P_i$");
        svg_area(s, 8, P, SVG_FILL);
        svg_polyline(s, 8, P, SVG_POLYGON);
        put_curve(s, 1, 7, P, q(1), SVG_WRONG);
        put_curve(s, 0, 7, P, q(1), SVG_RIGHT);
        svg_frame(s);
    }
    svg_legend_line(s, SVG_WRONG, "the printed curve, $β=1$");
    svg_legend_line(s, SVG_RIGHT, "the corrected curve, $β=1$");
    svg_legend_area(s, SVG_FILL, "convex hull");
    return s;
}

/* Eight points and the same points backwards, with the printed curve of each. */
FIGURE(two_directions_two_curves)
{
    svg *s =
        svg_new("two_directions_two_curves", "A polygon and its reverse",
                "The curves of a polygon far from the origin, and of the same points taken backwards, for β = 1.  With "
                "the printed functions they are two curves, with the corrected ones the same, run through in the "
                "other direction.");
    static const int from[] = {0, 0, 1, 4, 2, 6, 3, 6, 4, 5, 5, 4, 6, 3, 7, 0};
    num_q P[16], R[16];
    integers(2 * 8, from, P);
    for (int i = 0; i <= 7; i++) {
        P[2 * i + 1] = add_q(P[2 * i + 1], q(40));
        R[14 - 2 * i] = P[2 * i], R[15 - 2 * i] = P[2 * i + 1];
    }
    for (int printed = 1; printed >= 0; printed--) {
        svg_panel(s, window(r(-1, 2), r(79, 2), r(15, 2), r(93, 2)), 320, 0, NULL);
        svg_heading(s, printed ? SVG_WRONG : SVG_RIGHT, printed ? "as printed, $β=1$" : "corrected, $β=1$");
        svg_polyline(s, 8, P, SVG_POLYGON);
        put_curve(s, printed, 7, P, q(1), SVG_CURVE);
        put_curve(s, printed, 7, R, q(1), SVG_CURVE_2);
        static const char *const names[2] = {"P_0", "P_7"};
        for (int end = 0; end < 2; end++) {
            svg_mark(s, svg_pair(P + 14 * end), SVG_POLYGON, SVG_USUAL);
            svg_label(s, svg_pair(P + 14 * end), end ? SVG_E : SVG_W, SVG_POLYGON, names[end]);
        }
    }
    svg_legend_line(s, SVG_CURVE, "of $P_0,...,P_7$");
    svg_legend_line(s, SVG_CURVE_2, "of $P_7,...,P_0$");
    return s;
}

FIGURE(edges_that_do_not_move)
{
    svg *s =
        svg_new("edges_that_do_not_move", "A polygon whose curve does not depend on beta",
                "The first coordinate over t for the polygon with four points 0 and four points 1, which is one graph "
                "for all β, and for the polygon with five points 0 and three points 1, whose graphs move.");
    num_q near[8], far[8], a[8];
    for (int panel = 0; panel < 2; panel++) {
        svg_panel(s, window(q(0), q(0), q(1), q(1)), 280, 220, panel ? "$0,0,0,0,0,1,1,1$" : "$0,0,0,0,1,1,1,1$");
        svg_axes(s, r(1, 2), r(1, 2), "t", NULL);
        for (int i = 0; i <= 7; i++)
            a[i] = q(i >= 4 + panel);
        for (int beta = -5; beta <= 1; beta += 3) {
            factors(0, 7, q(beta), near, far);
            put_graph(s, 7, near, far, a, beta == 1 ? SVG_CURVE : beta == -2 ? SVG_FAMILY : SVG_CURVE_2);
        }
    }
    svg_legend_line(s, SVG_CURVE, "$β=1$");
    svg_legend_line(s, SVG_FAMILY, "$β=-2$");
    svg_legend_line(s, SVG_CURVE_2, "$β=-5$");
    return s;
}
