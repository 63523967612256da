/* envelope-uniqueness-general.figure.c -- drawings for envelope-uniqueness-general.claims.h. */
#include "chapters/nurbs/family-figures.h"

#include <stdio.h>

/* The other factors: 4 t τ + 1, t τ + 1, t + 2 τ. */
static num_q quartic_factor(svg_point P, const void *data)
{
    (void)data;
    return add_q(q(1), mul_q(q(4), mul_q(P.x, P.y)));
}
static num_q sextic_factor(svg_point P, const void *data)
{
    (void)data;
    return add_q(q(1), mul_q(P.x, P.y));
}
static num_q cubic_factor(svg_point P, const void *data)
{
    (void)data;
    return add_q(P.x, mul_q(q(2), P.y));
}

FIGURE(nurbs_envelope_square)
{
    svg *s = svg_new(
        "nurbs_envelope_square", "Where the condition of the envelope holds",
        "Three squares of pairs (t, τ).  The diagonal is the curve.  Beside it the condition holds on a hyperbola for "
        "the convex quartic with r = 2, on a hyperbola for "
        "the sextic of space with r = 3, and on the line τ = -t/2 for the cubic as a curve of order 6 with r = 3.");
    static const struct {
        const char *caption;
        svg_field *factor;
        int half;
    } panel[3] = {{"$k=5$, $r=2$: $(t,2t^4+3t^2)$\n$4tτ+1=0$", quartic_factor, 1},
                  {"$k=7$, $r=3$: the sextic of space\n$tτ+1=0$", sextic_factor, 2},
                  {"$k=6$, $r=3$: $(t,t^3)$\n$t+2τ=0$", cubic_factor, 1}};
    for (int k = 0; k < 3; k++) {
        int a = panel[k].half;
        svg_panel(s, svg_integer_window(-a, -a, a, a), 210, 0, panel[k].caption);
        svg_axes(s, q(a), q(a), "t", "τ");
        svg_frame(s);
        svg_segment(s, svg_at(-a, -a), svg_at(a, a), SVG_CURVE);
        svg_implicit(s, panel[k].factor, NULL, 80, SVG_WRONG);
    }
    svg_legend_line(s, SVG_CURVE, "$τ=t$, the curve");
    svg_legend_line(s, SVG_WRONG, "the other factor");
    return s;
}

/* The second envelopes as functions of a parameter. */
static svg_point quartic_second(num_q x, const void *data)
{
    (void)data;
    return at(x, sub_q(mul_q(q(2), mul_q(x, x)), r(1, 8)));
}
static svg_point cubic_second(num_q t, const void *data)
{
    (void)data;
    return at(div_q(t, q(10)), div_q(mul_q(t, mul_q(t, t)), q(-80)));
}
static svg_point sextic_second(num_q x, const void *upright)
{
    num_q a = mul_q(q(2), x), aa = mul_q(a, a); /* a = t + τ */
    if (upright == NULL)
        return at(x, sub_q(q(2), mul_q(q(3), aa)));
    return at(x, div_q(mul_q(a, sub_q(aa, q(3))), q(2)));
}

FIGURE(nurbs_envelope_extra)
{
    svg *s = svg_new("nurbs_envelope_extra", "Envelopes beside the curve",
                     "Left the conics of the convex quartic (t, 2t⁴ + 3t²): many of them touch the parabola y = 2x² - "
                     "1/8 below it.  Right the conics of the cubic (t, t³), taken as a "
                     "curve of order 6: those with -1/2 < τ ≤ 1/2 touch another, smaller cubic.");
    static const int x[6] = {0, 1}, y4[5] = {0, 0, 3, 0, 2}, y3[6] = {0, 0, 0, 1};
    struct nurbs quartic = one_span(4, 1, x, y4), cubic = one_span(5, 1, x, y3);
    svg_panel(s, window(r(-3, 5), r(-3, 10), r(3, 5), r(3, 2)), 380, 285, "$k=5$, $r=2$: the convex quartic");
    put_family(s, &quartic, 4, 2, 24);
    put_curve(s, &quartic, SVG_CURVE);
    svg_plot(s, quartic_second, NULL, r(-3, 8), r(3, 8), 40, SVG_WRONG);
    svg_mark(s, at(q(0), r(-1, 8)), SVG_WRONG, SVG_USUAL);
    svg_label(s, at(q(0), r(-1, 8)), SVG_S, SVG_WRONG, "(0,-1/8)");
    svg_frame(s);
    svg_panel(s, window(r(-1, 4), r(-1, 40), r(1, 4), r(1, 40)), 380, 285,
              "$k=6$, $r=3$: the cubic $(t,t^3)$, near the origin");
    put_family(s, &cubic, 5, 3, 40);
    put_curve(s, &cubic, SVG_CURVE);
    svg_plot(s, cubic_second, NULL, q(-1), q(1), 40, SVG_WRONG);
    svg_frame(s);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_FAMILY, "its members");
    svg_legend_line(s, SVG_WRONG, "another envelope");
    return s;
}

FIGURE(nurbs_envelope_space)
{
    svg *s = svg_new("nurbs_envelope_space", "A curve of space, curved and twisted everywhere, with a second envelope",
                     "The curve (t, t⁶ - 15t², 3t⁵ + 10t³), order 7, in two projections with its cubic members, r = 3, "
                     "and the second curve, which those with τ < -1/2 or τ ≥ 1/2 touch.");
    static const int x[7] = {0, 1}, y[7] = {0, 0, -15, 0, 0, 0, 1}, z[7] = {0, 0, 0, 10, 0, 3};
    static const int upright = 1;
    for (int k = 0; k < 2; k++) {
        struct nurbs c = one_span(6, 2, x, k == 0 ? y : z);
        svg_panel(s, window(r(-6, 5), q(k == 0 ? -20 : -12), r(6, 5), q(k == 0 ? 8 : 12)), 380, 300,
                  k == 0 ? "$(x,y)$" : "$(x,z)$");
        put_family(s, &c, 6, 3, 32);
        put_curve(s, &c, SVG_CURVE);
        svg_plot(s, sextic_second, k == 0 ? NULL : &upright, r(-3, 4), r(3, 4), 40, SVG_WRONG);
        if (k == 0)
            svg_mark(s, svg_at(0, 2), SVG_WRONG, SVG_USUAL);
        if (k == 0)
            svg_label(s, svg_at(0, 2), SVG_N, SVG_WRONG, "(0,2,0)");
        svg_frame(s);
    }
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_FAMILY, "members of order 4");
    svg_legend_line(s, SVG_WRONG, "the second envelope");
    return s;
}

FIGURE(divisor_zero)
{
    static const int knot[] = {0, 3, 3, 3, 4, 5, 6, 7};
    svg *s =
        svg_new("divisor_zero", "A divisor of the chain that is zero",
                "The knots 0, 3, 3, 3, 4, 5, 6, 7 and the intervals whose lengths are the divisors of the chain on "
                "the span from 3 to 4 for r = 2: the first of them is a point.");
    svg_panel(s, window(r(-1, 2), r(-15, 4), r(15, 2), r(3, 2)), 460, 210,
              "$k=4$, $r=2$, $j=4$: the span $[t_4,t_5)=[3,4)$");
    svg_segment(s, svg_at(0, 0), svg_at(7, 0), SVG_AXIS);
    svg_segment(s, svg_at(3, 0), svg_at(4, 0), SVG_CURVE);
    for (int i = 0, height = 0; i < 8; i++) {
        char name[8];
        height = i > 0 && knot[i] == knot[i - 1] ? height + 1 : 0;
        snprintf(name, sizeof name, "t_%d", i + 1);
        svg_mark(s, at(q(knot[i]), r(height, 2)), SVG_POINT, SVG_USUAL);
        svg_label(s, at(q(knot[i]), r(height, 2)), height > 0 ? SVG_W : SVG_SW, SVG_POINT, name);
    }
    for (int i = 2; i <= 5; i++) { /* [t_i, t_{i+k-r}] */
        num_q left = q(knot[i - 1]), right = q(knot[i + 1]), y = sub_q(r(1, 2), r(3 * i, 4));
        int zero = knot[i - 1] == knot[i + 1];
        char name[16];
        snprintf(name, sizeof name, zero ? "t_%d-t_%d=0" : "t_%d-t_%d", i + 2, i);
        if (zero)
            svg_mark(s, at(left, y), SVG_WRONG, SVG_USUAL);
        else
            svg_segment(s, at(left, y), at(right, y), SVG_RIGHT);
        svg_label(s, at(right, y), SVG_E, zero ? SVG_WRONG : SVG_RIGHT, name);
    }
    svg_legend_line(s, SVG_CURVE, "the span");
    svg_legend_line(s, SVG_RIGHT, "divisors $t_{i+k-r}-t_i$");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "a divisor 0");
    return s;
}
