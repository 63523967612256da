/* envelope.figure.c -- drawings for envelope.claims.h. */
#include "chapters/judge/figure.h"
#include "figures/words.h"

/* The members of level `level` of the curve (R, w) for c = 0, 1/pieces, ..., 1. */
static void put_family(svg *s, int n, const num_q R[], const num_q w[], int level, int pieces)
{
    num_q Rr[2 * MAX_DEGREE + 2], wr[MAX_DEGREE + 1];
    for (int k = 0; k <= pieces; k++) {
        rational_casteljau_q(n, 2, R, w, r(k, pieces), level, Rr, wr);
        if (n - level == 1)
            svg_segment(s, svg_pair(Rr), svg_pair(Rr + 2), SVG_FAMILY);
        else
            svg_rational(s, n - level, Rr, wr, SVG_FAMILY);
    }
}

/* One member, in a role, with its control polygon. */
static void put_member(svg *s, int n, const num_q R[], const num_q w[], int level, num_q c, enum svg_role role)
{
    num_q Rr[2 * MAX_DEGREE + 2], wr[MAX_DEGREE + 1];
    rational_casteljau_q(n, 2, R, w, c, level, Rr, wr);
    if (n - level == 1)
        svg_segment(s, svg_pair(Rr), svg_pair(Rr + 2), role);
    else
        svg_rational(s, n - level, Rr, wr, role);
}

static void ones(int n, num_q w[])
{
    for (int i = 0; i <= n; i++)
        w[i] = q(1);
}

FIGURE(envelope_families)
{
    svg *s =
        svg_new("envelope_families", "A curve touches the members of its families",
                "A rational cubic with the points (0, 0), (1, 3), (4, 3), (5, 0) and weights 1, 2, 1, 1.  Left the "
                "quadratic members r = 1, right the linear members r = 2, for eleven values of c; each touches the "
                "cubic in the point of parameter c.");
    static const int points[8] = {0, 0, 1, 3, 4, 3, 5, 0};
    num_q R[8], w[4] = {q(1), q(2), q(1), q(1)}, P[2];
    integers(8, points, R);
    rational_point_q(3, 2, R, w, r(2, 5), P);
    for (int level = 1; level <= 2; level++) {
        svg_panel(s, window(r(-1, 2), r(-1, 2), r(11, 2), r(7, 2)), 330, 0,
                  level == 1 ? "$r=1$: members of degree 2" : "$r=2$: members of degree 1, the tangents");
        svg_control_polygon(s, 3, R, "R");
        put_family(s, 3, R, w, level, 10);
        put_member(s, 3, R, w, level, r(2, 5), SVG_CURVE_2);
        svg_rational(s, 3, R, w, SVG_CURVE);
        svg_mark(s, svg_pair(P), SVG_POINT, SVG_USUAL);
        svg_label(s, svg_pair(P), SVG_S, SVG_POINT, "R(c)");
    }
    svg_legend_line(s, SVG_CURVE, "the cubic");
    svg_legend_line(s, SVG_CURVE_2, "the member of $c=2/5$");
    svg_legend_line(s, SVG_FAMILY, "other members");
    return s;
}

FIGURE(envelope_cusp)
{
    svg *s = svg_new("envelope_cusp", "At a cusp the tangent member is a point",
                     "The cubic (τ², τ³) for τ from -1 to 1 and its members r = 2.  They are segments of its tangents; "
                     "at the cusp, the origin, the member shrinks to a point.");
    static const int points[8] = {3, -3, -1, 3, -1, -3, 3, 3};
    num_q R[8], w[4];
    fractions(8, points, 3, R);
    ones(3, w);
    svg_panel(s, window(r(-3, 5), r(-6, 5), r(6, 5), r(6, 5)), 290, 0,
              "$(τ^2,τ^3)$, $r=2$: the cusp\nis at $τ=0$, that is $c=1/2$");
    svg_control_polygon(s, 3, R, "R");
    put_family(s, 3, R, w, 2, 16);
    svg_bezier(s, 3, R, SVG_CURVE);
    svg_mark(s, svg_at(0, 0), SVG_WRONG, SVG_USUAL);
    svg_label(s, svg_at(0, 0), SVG_W, SVG_WRONG, "R^{[1]}(t,c)");
    svg_legend_line(s, SVG_CURVE, "the cubic");
    svg_legend_line(s, SVG_FAMILY, "members of degree 1");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "the member of the cusp: no tangent");
    return s;
}

FIGURE(envelope_extra)
{
    svg *s =
        svg_new("envelope_extra", "Envelopes beside the curve",
                "Left the quadratic members of the cubic (τ, τ³): they touch the cubic and also the axis y = 0.  Right "
                "the quadratic members of the convex quartic (τ, τ⁴ + 3τ²/2): many of them touch the parabola y = x² - "
                "1/16 below it.");
    static const int cubic[8] = {-3, -3, -1, 3, 1, -3, 3, 3}, quartic[10] = {-2, 5, -1, -2, 0, 1, 1, -2, 2, 5};
    num_q R[10], w[5];
    fractions(8, cubic, 3, R);
    ones(4, w);
    svg_panel(s, window(r(-3, 5), r(-1, 6), r(3, 5), r(1, 6)), 380, 285,
              "$n=3$, $r=1$: the cubic $(τ,τ^3)$ has an inflection\n($y$ stretched)");
    put_family(s, 3, R, w, 1, 24);
    svg_bezier(s, 3, R, SVG_CURVE);
    svg_segment(s, at(r(-1, 3), q(0)), at(r(1, 3), q(0)), SVG_WRONG);
    svg_mark(s, at(r(1, 6), q(0)), SVG_WRONG, SVG_USUAL);
    svg_label(s, at(r(1, 6), q(0)), SVG_S, SVG_WRONG, "(1/6,0)");
    svg_frame(s);
    fractions(10, quartic, 2, R);
    svg_panel(s, window(r(-3, 5), r(-3, 20), r(3, 5), r(3, 4)), 380, 0,
              "$n=4$, $r=2$: the quartic $(τ,τ^4+3τ^2/2)$ is convex");
    put_family(s, 4, R, w, 2, 24);
    svg_bezier(s, 4, R, SVG_CURVE);
    num_q parabola[6] = {r(-3, 8), r(5, 64), q(0), r(-13, 64), r(3, 8), r(5, 64)};
    svg_bezier(s, 2, parabola, SVG_WRONG);
    svg_mark(s, at(q(0), r(-1, 16)), SVG_WRONG, SVG_USUAL);
    svg_label(s, at(q(0), r(-1, 16)), SVG_S, SVG_WRONG, "(0,-1/16)");
    svg_frame(s);
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_FAMILY, "its members");
    svg_legend_line(s, SVG_WRONG, "the other envelope");
    return s;
}

FIGURE(envelope_contact)
{
    svg *s =
        svg_new("envelope_contact", "Curve and member touch, they do not osculate",
                "Left the cubic (τ, τ³) and its quadratic member of c = 1: they touch at (1, 1), with different "
                "curvatures.  Right the quartic (τ, τ⁴ + 3τ²/2) at τ = 0 with its members r = 1, 2, 3 and the circles "
                "of curvature of the quartic, of radius 1/3, and of the member r = 2, of radius 1/2.");
    static const int cubic[8] = {0, 0, 1, 0, 2, 0, 3, 3}, quartic[10] = {-2, 5, -1, -2, 0, 1, 1, -2, 2, 5};
    num_q R[10], w[5];
    ones(4, w);
    fractions(8, cubic, 3, R);
    svg_panel(s, window(q(0), r(-1, 10), r(11, 10), r(11, 10)), 350, 0,
              "$n=3$, $r=1$, $c=1$: $y\\'\\'=6$ and $y\\'\\'=9/2$");
    svg_axes(s, r(1, 2), r(1, 2), "x", "y");
    svg_bezier(s, 3, R, SVG_CURVE);
    put_member(s, 3, R, w, 1, q(1), SVG_CURVE_2);
    svg_mark(s, svg_at(1, 1), SVG_POINT, SVG_USUAL);
    svg_label(s, svg_at(1, 1), SVG_W, SVG_POINT, "R(1)");
    fractions(10, quartic, 2, R);
    svg_panel(s, window(r(-4, 5), r(-1, 5), r(4, 5), r(11, 10)), 430, 0,
              "$n=4$, $τ=0$, $c=1/2$: the curvatures are 3, 8/3, 2 and 0");
    svg_circle(s, at(q(0), r(1, 3)), r(1, 3), SVG_MUTED);
    svg_circle(s, at(q(0), r(1, 2)), r(1, 2), SVG_MUTED);
    put_member(s, 4, R, w, 1, r(1, 2), SVG_FAMILY);
    put_member(s, 4, R, w, 3, r(1, 2), SVG_FAMILY);
    svg_bezier(s, 4, R, SVG_CURVE);
    put_member(s, 4, R, w, 2, r(1, 2), SVG_CURVE_2);
    svg_mark(s, svg_at(0, 0), SVG_POINT, SVG_USUAL);
    svg_label(s, svg_at(0, 0), SVG_S, SVG_POINT, "R(c)");
    svg_note(s, at(r(1, 4), r(0, 1)), SVG_SE, SVG_FAMILY, "$r=3$");
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_line(s, SVG_CURVE_2, "the member with $n-r=2$");
    svg_legend_line(s, SVG_FAMILY, "the members $r=1$ and $r=3$");
    svg_legend_line(s, SVG_MUTED, "circles of curvature");
    return s;
}
