#include "chapters/judge/figure.h"
#include "figures/words.h"

/* The points of the parameters 1/4, 1/2, 3/4, with their parameters beside them. */
static void mark_quarters(svg *s, int n, const num_q R[], const num_q w[], enum svg_role role,
                          const enum svg_direction towards[3])
{
    static const char *const name[] = {"1/4", "1/2", "3/4"};
    for (int k = 0; k < 3; k++) {
        num_q P[2];
        rational_point_q(n, 2, R, w, from_ratio_q(k + 1, 4), P);
        svg_mark(s, svg_pair(P), role, SVG_USUAL);
        svg_label(s, svg_pair(P), towards[k], role, name[k]);
    }
}

FIGURE(shape_and_invariants)
{
    svg *s = svg_new(
        "shape_and_invariants", "Where the shape does not determine the invariants",
        "Three pairs of curves over one polygon each: a plane quartic run backwards, a plane quintic whose weights "
        "hide behind a common factor, and two congruent cubics of space.");
    {
        enum { n = 4 };
        static const int point[] = {0, 0, 3, 0, 0, 3, 3, 0, 0, 0}, weight[] = {1, 2, 1, 1, 1};
        num_q R[2 * (n + 1)], w[n + 1];
        integers(2 * (n + 1), point, R);
        integers(n + 1, weight, w);
        svg_panel(s, svg_integer_window(-1, -1, 4, 4), 300, 0,
                  "$n = 4$, in a plane: one point set for the weights\n1, 2, 1, 1, 1 and 1, 1, 1, 2, 1, run backwards");
        svg_polyline(s, 3, R, SVG_POLYGON);
        for (int i = 0; i < 3; i++)
            svg_mark(s, svg_pair(R + 2 * i), SVG_POLYGON, SVG_USUAL);
        svg_label(s, svg_pair(R), SVG_W, SVG_POLYGON, "R_0 = R_4");
        svg_label(s, svg_pair(R + 2), SVG_SE, SVG_POLYGON, "R_1 = R_3");
        svg_label(s, svg_pair(R + 4), SVG_N, SVG_POLYGON, "R_2");
        svg_rational(s, n, R, w, SVG_CURVE);
        static const enum svg_direction towards[] = {SVG_E, SVG_N, SVG_W};
        mark_quarters(s, n, R, w, SVG_CURVE, towards);
    }
    {
        enum { n = 5 };
        static const int point[] = {0, 0, 3, 0, 0, 3, 0, 0, 3, 0, 0, 3};
        num_q R[2 * (n + 1)], w[n + 1];
        integers(2 * (n + 1), point, R);
        for (int i = 0; i <= n; i++)
            w[i] = from_ratio_q(binomial(2, i < 3 ? i : i - 3), binomial(n, i));
        svg_panel(s, svg_integer_window(-1, -1, 4, 4), 300, 0,
                  "$n = 5$, in a plane: one map for the weights\n1, 2/5, 1/10, $c$/10, 2$c$/5, $c$, whatever $c$ is");
        num_q closed[] = {R[0], R[1], R[2], R[3], R[4], R[5], R[0], R[1]};
        svg_polyline(s, 4, closed, SVG_POLYGON);
        for (int i = 0; i < 3; i++)
            svg_mark(s, svg_pair(R + 2 * i), SVG_POLYGON, SVG_USUAL);
        svg_label(s, svg_pair(R), SVG_W, SVG_POLYGON, "R_0 = R_3");
        svg_label(s, svg_pair(R + 2), SVG_SE, SVG_POLYGON, "R_1 = R_4");
        svg_label(s, svg_pair(R + 4), SVG_N, SVG_POLYGON, "R_2 = R_5");
        svg_rational(s, n, R, w, SVG_CURVE);
        static const enum svg_direction towards[] = {SVG_NW, SVG_W, SVG_SW};
        mark_quarters(s, n, R, w, SVG_CURVE, towards);
    }
    {
        enum { n = 3 };
        static const int point[] = {1, 0, 0, 1, 0, -1, -1, 0}, weight[] = {1, 1, 2, 1}, other[] = {1, 2, 1, 1};
        num_q R[2 * (n + 1)], w[n + 1], v[n + 1];
        integers(2 * (n + 1), point, R);
        integers(n + 1, weight, w);
        integers(n + 1, other, v);
        num_q edge = from_ratio_q(3, 2);
        svg_panel(s, (svg_window){neg_q(edge), neg_q(edge), edge, edge}, 300, 0,
                  "$n = 3$, in space, seen along the $z$ axis: a half turn\ncarries one curve into the other");
        svg_control_polygon(s, n, R, "R");
        svg_rational(s, n, R, w, SVG_CURVE);
        svg_rational(s, n, R, v, SVG_CURVE_2);
        svg_mark(s, svg_at(0, 0), SVG_AXIS, SVG_CROSS);
    }
    svg_legend_line(s, SVG_CURVE, "$ω$: left 1, 2, 1, 1, 1; right 1, 1, 2, 1");
    svg_legend_line(s, SVG_CURVE_2, "$ω^*$: right 1, 2, 1, 1");
    return s;
}

/* tau(0) - tau*(0) for n = 5, a_1 = e_1, a_2 = e_2, a_3 = h e_3 and weights 1, the third one 2 in the second curve: as
 * it is, and with |a_1 x a_3|^2 = h^2 in place of |a_1 x a_2|^2 = 1. */
static svg_point true_difference(num_q h, const void *data)
{
    enum { n = 5 };
    (void)data;
    num_q R[3 * (n + 1)], w[n + 1], v[n + 1];
    for (int i = 0; i <= n; i++) {
        R[3 * i] = from_int_q(i > 0);
        R[3 * i + 1] = from_int_q(i > 1);
        R[3 * i + 2] = i > 2 ? h : from_int_q(0);
        w[i] = from_int_q(1);
        v[i] = from_int_q(i == 3 ? 2 : 1);
    }
    num_q zero = from_int_q(0);
    return (svg_point){h, sub_q(rational_torsion_q(n, R, w, zero), rational_torsion_q(n, R, v, zero))};
}
static svg_point printed_difference(num_q h, const void *data)
{
    (void)data;
    return (svg_point){h, div_q(from_ratio_q(-3, 5), h)};
}

FIGURE(torsion_misprint)
{
    svg *s = svg_new(
        "torsion_misprint", "The difference of the torsions, as printed and as it is",
        "For edges e1, e2 and h e3, the difference of the torsions as a function of h: it falls linearly, while the "
        "printed expression rises towards zero; they meet at h = 1 only.");
    svg_panel(s, (svg_window){from_int_q(0), from_ratio_q(-9, 5), from_int_q(3), from_ratio_q(1, 5)}, 460, 300,
              "$n = 5$, edges $a_1 = e_1, a_2 = e_2, a_3 = h e_3$;\nall weights 1, but $ω_3^* = 2$");
    svg_axes(s, from_int_q(1), from_ratio_q(3, 5), "h", "τ(0) - τ^*(0)");
    svg_plot(s, true_difference, NULL, from_ratio_q(1, 20), from_int_q(3), 8, SVG_RIGHT);
    svg_plot(s, printed_difference, NULL, from_ratio_q(1, 4), from_int_q(3), 24, SVG_WRONG);
    num_q two = from_int_q(2);
    svg_mark(s, true_difference(two, NULL), SVG_RIGHT, SVG_USUAL);
    svg_label(s, true_difference(two, NULL), SVG_SW, SVG_RIGHT, "-6/5");
    svg_mark(s, printed_difference(two, NULL), SVG_WRONG, SVG_USUAL);
    svg_label(s, printed_difference(two, NULL), SVG_SE, SVG_WRONG, "-3/10");
    svg_legend_line(s, SVG_RIGHT, "denominator $‖a_1 × a_2‖^2$: the difference");
    svg_legend_line(s, SVG_WRONG, "denominator $‖a_1 × a_3‖^2$: as printed");
    return s;
}
