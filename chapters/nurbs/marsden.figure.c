/* marsden.figure.c -- drawings for marsden.claims.h. */
#include "chapters/nurbs/matrix-figures.h"

#include <stdio.h>

enum { p = 2, k = 3, SPANS = 3 };
static const int knots[2 * k + SPANS - 1] = {-3, -2, 0, 3, 4, 6, 7, 8}; /* spans [0,3], [3,4], [4,6] */

/* The terms omega_i(x) N_i(t) of Marsden's identity for one x, and their sum. */
FIGURE(marsden_identity)
{
    num_q u[2 * k + SPANS - 1], A[k * k], w[k], c[k], x = q(2);
    svg *s = svg_new(
        "marsden_identity", "Marsden's identity",
        "Over the knots 0, 3, 4 and 6 the quadratic B-splines, each multiplied by its coefficient, and their sum, "
        "which is the parabola (2-t)².");
    integers(2 * k + SPANS - 1, knots, u);
    static const struct {
        int t[2], y[2];
        enum svg_direction towards;
    } beside[] = {{{1, 4}, {9, 2}, SVG_NE},
                  {{3, 2}, {-4, 3}, SVG_S},
                  {{13, 5}, {6, 5}, SVG_NW},
                  {{6, 1}, {8, 3}, SVG_E},
                  {{28, 5}, {17, 2}, SVG_SE}};
    svg_panel(s, window(q(0), q(-3), r(13, 2), q(17)), 440, 320, "$k=3$, $x=2$, simple knots");
    svg_axes(s, q(1), q(5), "t", NULL);
    for (int mu = p; mu < p + SPANS; mu++) {
        num_q sum[k] = {q(0), q(0), q(0)};
        bspline_matrix_q(p, u, mu, A);
        marsden_coefficients_q(p, u, mu, x, w);
        for (int i = 0; i < k; i++) {
            column_of(p, A, i, w[i], c);
            put_polynomial(s, p, c, u[mu], u[mu + 1], SVG_CURVE_2);
            for (int j = 0; j < k; j++)
                sum[j] = add_q(sum[j], c[j]);
        }
        put_polynomial(s, p, sum, u[mu], u[mu + 1], SVG_CURVE);
        svg_mark(s, at(u[mu], q(0)), SVG_POINT, SVG_RING);
    }
    svg_mark(s, at(u[p + SPANS], q(0)), SVG_POINT, SVG_RING);
    for (int i = 0; i < k + SPANS - 1; i++) {
        char name[32];
        snprintf(name, sizeof name, "ω_%dN_%d", i + 1, i + 1);
        svg_label(s, at(r(beside[i].t[0], beside[i].t[1]), r(beside[i].y[0], beside[i].y[1])), beside[i].towards,
                  SVG_CURVE_2, name);
    }
    svg_label(s, at(r(9, 2), r(25, 4)), SVG_NW, SVG_CURVE, "(x-t)^2");
    svg_legend_line(s, SVG_CURVE, "the sum: $(x-t)^2$");
    svg_legend_line(s, SVG_CURVE_2, "its terms $ω_i(x)N_{i,3}(t)$");
    svg_legend_mark(s, SVG_POINT, SVG_RING, "knots");
    return s;
}

/* The parabola y = t^2 as a B-spline curve: abscissae Sym_1/2, ordinates Sym_2. */
FIGURE(powers_from_averages)
{
    enum { count = k + SPANS - 1 };
    num_q u[2 * k + SPANS - 1], P[2 * count], g[k * k], A[k * k], c[k];
    svg *s =
        svg_new("powers_from_averages", "The powers of t in the B-spline basis",
                "The graph of t² over three spans as a quadratic B-spline curve.  Its control points have the averages "
                "of two neighbouring knots as abscissae, and the products of the two knots as ordinates.");
    integers(2 * k + SPANS - 1, knots, u);
    for (int mu = p; mu < p + SPANS; mu++) {
        marsden_matrix_q(p, u, mu, g);
        for (int i = 0; i < k; i++) {
            P[2 * (mu - p + i)] = g[k + i];
            P[2 * (mu - p + i) + 1] = g[2 * k + i];
        }
    }
    svg_panel(s, window(q(-2), q(-3), q(7), q(44)), 420, 300,
              "$k=3$, points $((t_{i+1}+t_{i+2})/2,\\ t_{i+1}t_{i+2})$");
    svg_axes(s, q(1), q(10), "t", NULL);
    svg_polyline(s, count, P, SVG_POLYGON);
    for (int i = 0; i < count; i++)
        svg_mark(s, svg_pair(P + 2 * i), SVG_POLYGON, SVG_USUAL);
    for (int mu = p; mu < p + SPANS; mu++) {
        bspline_matrix_q(p, u, mu, A);
        for (int j = 0; j < k; j++) {
            c[j] = q(0);
            for (int i = 0; i < k; i++)
                c[j] = add_q(c[j], mul_q(A[j * k + i], P[2 * (mu - p + i) + 1]));
        }
        put_polynomial(s, p, c, u[mu], u[mu + 1], SVG_CURVE);
        svg_mark(s, at(u[mu], mul_q(u[mu], u[mu])), SVG_POINT, SVG_USUAL);
    }
    num_q end = u[p + SPANS];
    svg_mark(s, at(end, mul_q(end, end)), SVG_POINT, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "the spline: $t^2$");
    svg_legend_line(s, SVG_POLYGON, "control polygon");
    svg_legend_mark(s, SVG_POINT, SVG_USUAL, "knots");
    return s;
}
