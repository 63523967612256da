/* nurbs-properties.figure.c -- drawings for nurbs-properties.claims.h. */
#include "chapters/nurbs/curve-of-claim.h"

static const int wave[] = {0, 0, 1, 4, 3, 5, 5, 1, 7, 0, 9, 4, 11, 4, 12, 0};
static const int eight[] = {0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5};

FIGURE(local_control)
{
    static const int heavy[] = {1, 6, 1, 1, 1, 1, 1, 1};
    static const enum svg_direction side[] = {SVG_SW, SVG_W, SVG_E, SVG_SW, SVG_S, SVG_N, SVG_NE, SVG_SE};
    svg *s = svg_new("local_control", "A change is local",
                     "A cubic NURBS curve with eight points.  Left r3 is moved, right the weight of r2 is raised to 6; "
                     "only the segments "
                     "over the support of N3 and N2 change.");
    for (int side_by_side = 0; side_by_side < 2; side_by_side++) {
        spline c = spline_of(8, 3, eight, 1, wave, 1, NULL),
               d = spline_of(8, 3, eight, 1, wave, 1, side_by_side ? heavy : NULL);
        int last = side_by_side ? 4 : 5; /* the last span that changes */
        if (side_by_side == 0)
            d.R[5] = q(8);
        svg_panel(s, svg_integer_window(-1, -1, 13, side_by_side ? 6 : 9), 360, 0,
                  side_by_side ? "$w_2=6$: changed on $[t_2,t_6)$, towards $r_2$"
                               : "$r_3$ moved: changed on $[t_3,t_7)$");
        draw_polygon(s, c, "r", side, SVG_POLYGON);
        if (side_by_side == 0) {
            svg_polyline(s, 3, d.R + 2, SVG_MUTED);
            svg_arrow(s, svg_pair(c.R + 4), svg_pair(d.R + 4), SVG_POINT);
        }
        for (int mu = 3; mu <= last; mu++)
            draw_segment(s, d, mu, SVG_CURVE_2);
        draw_spline(s, c, SVG_CURVE);
        mark_knots(s, c, SVG_CURVE);
    }
    svg_legend_line(s, SVG_CURVE, "before");
    svg_legend_line(s, SVG_CURVE_2, "after, where it differs");
    return s;
}

FIGURE(knot_sides)
{
    static const enum svg_direction side[] = {SVG_SW, SVG_S, SVG_E, SVG_E}, other[] = {SVG_SW, SVG_N, SVG_N, SVG_SE};
    svg *s = svg_new("knot_sides", "The two sides of a knot",
                     "Left a quadratic curve with a simple knot: the tangents agree, the circles of curvature of both "
                     "sides do not.  "
                     "Right a curve of order 2 with a double knot: it has two values there.");
    spline c = spline_of_claim("one_order_more_jumps", 4, 2), d = spline_of_claim("k_fold_knot_tears_the_curve", 4, 1);
    svg_panel(s, window(r(-1, 2), r(-1, 2), r(3, 1), r(7, 2)), 300, 0,
              "$k=3$, simple knot: $r\\'$ agrees, $r\\'\\'$ jumps");
    draw_polygon(s, c, "r", side, SVG_POLYGON);
    draw_segment(s, c, 2, SVG_CURVE);
    draw_segment(s, c, 3, SVG_CURVE_2);
    num_q D[6];
    for (int mu = 2; mu < 4; mu++) { /* the other segment, continued beyond the knot */
        spline far = c;
        num_q P[2 * 9];
        for (int i = 0; i <= 8; i++) {
            num_q t = mu == 2 ? r(8 + i, 8) : r(i, 8);
            nurbs_point_q(nurbs_on_span_q(2, 2, far.u, mu, far.R, far.w), t, P + 2 * i);
        }
        svg_polyline(s, 9, P, SVG_MUTED);
    }
    nurbs_derivatives_q(nurbs_on_span_q(2, 2, c.u, 2, c.R, c.w), q(1), 1, D);
    svg_mark(s, svg_pair(D), SVG_POINT, SVG_USUAL);
    svg_label(s, svg_pair(D), SVG_NW, SVG_POINT, "r(1)");
    svg_panel(s, window(r(-1, 2), r(-1, 2), r(7, 2), r(2, 1)), 320, 0, "$k=2$, double knot: two values");
    draw_polygon(s, d, "r", other, SVG_MUTED);
    draw_segment(s, d, 1, SVG_CURVE);
    draw_segment(s, d, 3, SVG_CURVE_2);
    svg_legend_line(s, SVG_CURVE, "before the knot");
    svg_legend_line(s, SVG_CURVE_2, "after the knot");
    svg_legend_line(s, SVG_MUTED, "left: each segment continued beyond the knot");
    return s;
}

FIGURE(knot_vectors)
{
    static const int point[] = {0, 0, 0, 4, 4, 5, 7, 3, 6, 0, 3, 1}, clamped[] = {0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
    static const int uniform[] = {-3, -2, -1, 0, 1, 2, 3, 4, 5, 6}, weight[] = {1, 1, 2, 1, 1, 1};
    static const enum svg_direction side[] = {SVG_SW, SVG_NW, SVG_N, SVG_E, SVG_SE, SVG_N};
    svg *s = svg_new("knot_vectors", "Clamped, unclamped and periodic knots",
                     "Cubic NURBS curves with the same six points and weights: clamped, beginning and ending with the "
                     "polygon; over simple "
                     "knots, beginning and ending inside; continued periodically, closed.");
    for (int kind = 0; kind < 3; kind++) {
        static const char *const caption[] = {"clamped: knots 0, 0, 0, 0, 1, 2, 3, 3, 3, 3",
                                              "unclamped: simple knots −3, …, 6",
                                              "periodic: closed, smooth at the seam"};
        spline c = spline_of(6, 3, kind == 0 ? clamped : uniform, 1, point, 1, weight), d = c;
        if (kind == 2) {
            num_q period[7], H[18], K[3 * 9];
            for (int i = 0; i <= 6; i++)
                period[i] = q(i);
            rational_homogenize_q(5, 2, c.R, c.w, H);
            bspline_periodic_q(6, 3, 3, period, H, d.u, K);
            d.n = 9;
            rational_dehomogenize_q(8, 2, K, d.R, d.w);
        }
        svg_panel(s, svg_integer_window(-1, -1, 8, 6), 270, 0, caption[kind]);
        draw_polygon(s, c, "r", side, SVG_POLYGON);
        if (kind == 2)
            svg_segment(s, svg_pair(c.R + 10), svg_pair(c.R), SVG_MUTED);
        draw_spline(s, d, SVG_CURVE);
        mark_knots(s, d, SVG_CURVE);
    }
    svg_legend_line(s, SVG_CURVE, "the curve, $k=4$; squares at the knots");
    return s;
}
