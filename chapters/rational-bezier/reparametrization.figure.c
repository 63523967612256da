#include "chapters/judge/figure.h"
#include "chapters/judge/figure_data.h"
#include "figures/words.h"

/* Marks the points of the parameters 1/8, ..., 7/8. */
static void mark_eighths(svg *s, int n, const num_q R[], const num_q w[], enum svg_role drawn_as, enum svg_shape shape)
{
    for (int k = 1; k < 8; k++) {
        num_q P[2];
        rational_point_q(n, 2, R, w, from_ratio_q(k, 8), P);
        svg_mark(s, svg_pair(P), drawn_as, shape);
    }
}

FIGURE(reparametrization)
{
    enum { n = 3 };
    static const int point[] = {0, 0, 1, 4, 5, 4, 6, 0}, weight[] = {1, 2, 2, 1}, other[] = {1, 6, 18, 27};
    num_q R[2 * (n + 1)], w[n + 1], v[n + 1];
    integers(2 * (n + 1), point, R);
    integers(n + 1, weight, w);
    integers(n + 1, other, v);
    svg *s =
        svg_new("reparametrization", "Equal invariants: one curve at two speeds",
                "A rational cubic with weights 1, 2, 2, 1, and the same curve with weights 1, 6, 18, 27: the points of "
                "equal parameter steps lie elsewhere on one curve.");
    for (int panel = 0; panel < 2; panel++) {
        svg_panel(s, svg_integer_window(-1, -1, 7, 5), 380, 0,
                  panel == 0 ? "weights 1, 2, 2, 1:  $I_1 = I_2 = 2$" : "weights 1, 6, 18, 27:  $I_1 = I_2 = 2$");
        svg_control_polygon(s, n, R, "R");
        svg_rational(s, n, R, panel == 0 ? w : v, SVG_CURVE);
        mark_eighths(s, n, R, panel == 0 ? w : v, SVG_POINT, panel == 0 ? SVG_DISC : SVG_SQUARE);
    }
    svg_legend_mark(s, SVG_POINT, SVG_DISC, "$t = 1/8, ..., 7/8$");
    svg_legend_mark(s, SVG_POINT, SVG_SQUARE, "$u = 1/8, ..., 7/8$, with $t = 3u/(3u + 1 - u)$");
    return s;
}

FIGURE(equal_invariants_other_arc)
{
    enum { n = 2 };
    static const int point[] = {-1, 0, 0, 1, 1, 0}, weight[] = {2, 1, 2}, other[] = {2, -1, 2};
    num_q R[2 * (n + 1)], w[n + 1], v[n + 1], P[2], Q[2], half = from_ratio_q(1, 2);
    integers(2 * (n + 1), point, R);
    integers(n + 1, weight, w);
    integers(n + 1, other, v);
    rational_point_q(n, 2, R, w, half, P);
    rational_point_q(n, 2, R, v, half, Q);
    svg *s =
        svg_new("equal_invariants_other_arc", "Equal invariants, different arcs",
                "Over one triangle, weights 2, 1, 2 give an arc of an ellipse inside, weights 2, -1, 2 the rest of the "
                "ellipse outside, although the invariant is 1/4 for both.");
    num_q low = from_ratio_q(-13, 10);
    svg_panel(s, (svg_window){from_ratio_q(-17, 10), low, from_ratio_q(17, 10), from_ratio_q(13, 10)}, 440, 0,
              "$I_1 = 1/4$ for both, $a = b = 1$, both denominators positive");
    static const char *const name[] = {"R_0", "R_1", "R_2"};
    static const enum svg_direction towards[] = {SVG_NW, SVG_N, SVG_NE};
    svg_polyline(s, n + 1, R, SVG_POLYGON);
    for (int i = 0; i <= n; i++) {
        svg_mark(s, svg_pair(R + 2 * i), SVG_POLYGON, SVG_USUAL);
        svg_label(s, svg_pair(R + 2 * i), towards[i], SVG_POINT, name[i]);
    }
    svg_rational(s, n, R, w, SVG_CURVE);
    svg_rational(s, n, R, v, SVG_CURVE_2);
    svg_mark(s, svg_pair(P), SVG_CURVE, SVG_USUAL);
    svg_label(s, svg_pair(P), SVG_S, SVG_CURVE, "R(1/2)");
    svg_mark(s, svg_pair(Q), SVG_CURVE_2, SVG_USUAL);
    svg_label(s, svg_pair(Q), SVG_N, SVG_CURVE_2, "R^*(1/2)");
    svg_legend_line(s, SVG_CURVE, "weights 2, 1, 2");
    svg_legend_line(s, SVG_CURVE_2, "weights 2, $-$1, 2");
    return s;
}

FIGURE(same_parabola_two_sets)
{
    enum { n = 3 };
    num_q w[2][n + 1], R[2][2 * (n + 1)];
    data_of("same_parabola_has_two_invariant_sets", "R", n + 1, 2, R[0]);
    data_of("same_parabola_has_two_invariant_sets", "ω", n + 1, 1, w[0]);
    data_of("same_parabola_has_two_invariant_sets", "R*", n + 1, 2, R[1]);
    data_of("same_parabola_has_two_invariant_sets", "ω*", n + 1, 1, w[1]);
    static const char *const caption[] = {"weights 1, 1, 1, 1:  $I_1 = I_2 = 1$",
                                          "weights 1, 4/3, 5/3, 2:  $I_1 = 16/15, I_2 = 25/24$"};
    svg *s =
        svg_new("same_parabola_two_sets", "One map, two control polygons of degree 3",
                "The arc (2t(1-t), t^2) of a parabola as a cubic with equal weights and with weights 1, 4/3, 5/3, 2: "
                "the points of equal parameters agree, the polygons and the invariants do not.");
    for (int k = 0; k < 2; k++) {
        svg_panel(s, (svg_window){from_ratio_q(-1, 4), from_ratio_q(-1, 4), from_ratio_q(11, 10), from_ratio_q(6, 5)},
                  340, 0, caption[k]);
        svg_control_polygon(s, n, R[k], "R");
        svg_rational(s, n, R[k], w[k], SVG_CURVE);
        mark_eighths(s, n, R[k], w[k], SVG_POINT, SVG_DISC);
    }
    svg_legend_line(s, SVG_CURVE, "$(2t(1-t), t^2)$, in both");
    svg_legend_mark(s, SVG_POINT, SVG_DISC, "$t = 1/8, ..., 7/8$");
    return s;
}
