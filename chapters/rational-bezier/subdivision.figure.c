#include "chapters/judge/figure.h"
#include "chapters/judge/figure_data.h"
#include "figures/words.h"

FIGURE(subdivision_triangle)
{
    enum { n = 3 };
    static const int point[] = {0, 0, 1, 5, 6, 6, 8, 0}, weight[] = {1, 2, 3, 1};
    num_q R[2 * (n + 1)], w[n + 1], lambda = from_ratio_q(2, 5), P[2 * (n + 1)], v[n + 1], left[2 * (n + 1)],
                                    right[2 * (n + 1)];
    integers(2 * (n + 1), point, R);
    integers(n + 1, weight, w);
    svg *s = svg_new(
        "subdivision_triangle", "The triangle of a rational cubic, and the two halves",
        "A rational cubic with weights 1, 2, 3, 1, cut at 2/5 by de Casteljau's triangle; the polygons of the left and "
        "the right part are its two sides.");
    svg_panel(s, svg_integer_window(-1, -1, 9, 7), 560, 0, "$λ = 2/5$, weights 1, 2, 3, 1");
    svg_control_polygon(s, n, R, "R");
    svg_rational(s, n, R, w, SVG_CURVE);
    for (int r = 0; r <= n; r++) {
        rational_casteljau_q(n, 2, R, w, lambda, r, P, v);
        if (r > 0 && r < n)
            svg_polyline(s, n - r + 1, P, SVG_FAMILY);
        for (int c = 0; c < 2; c++) {
            left[2 * r + c] = P[c];
            right[2 * (n - r) + c] = P[2 * (n - r) + c];
        }
    }
    svg_polyline(s, n + 1, left, SVG_RIGHT);
    svg_polyline(s, n + 1, right, SVG_CURVE_2);
    static const char *const name[n][n] = {{"R_1^1", "R_2^1", "R_3^1"}, {"R_2^2", "R_3^2"}, {"R_3^3"}};
    static const enum svg_direction towards[n][n] = {{SVG_W, SVG_N, SVG_E}, {SVG_NW, SVG_NE}, {SVG_S}};
    for (int r = 1; r <= n; r++) {
        rational_casteljau_q(n, 2, R, w, lambda, r, P, v);
        for (int i = 0; i <= n - r; i++) {
            svg_mark(s, svg_pair(P + 2 * i), SVG_POINT, SVG_USUAL);
            svg_label(s, svg_pair(P + 2 * i), towards[r - 1][i], SVG_POINT, name[r - 1][i]);
        }
    }
    svg_legend_line(s, SVG_RIGHT, "left part: $R_0^0 R_1^1 R_2^2 R_3^3$");
    svg_legend_line(s, SVG_CURVE_2, "right part: $R_3^3 R_3^2 R_3^1 R_3^0$");
    return s;
}

FIGURE(triangle_point_at_infinity)
{
    static const int point[] = {0, 0, 3, 3, 6, 0}, numerator[] = {2, 1, 4, 9}, denominator[] = {5, 2, 5, 10};
    num_q R[6], w[3], lambdas[2], P[4], v[2], S[2];
    integers(6, point, R);
    data_of("intermediate_weight_can_vanish", "ω", 3, 1, w);
    data_of("intermediate_weight_can_vanish", "λ", 2, 1, lambdas);
    num_q lambda = lambdas[0];
    svg *s = svg_new(
        "triangle_point_at_infinity", "A regular curve whose triangle has a point at infinity",
        "The quadratic with weights 1, -1/2, 1 is regular for all parameters.  With λ from 0 to 1 the point R11 of its "
        "triangle runs from R0 away from R1 to infinity, reached at λ = 2/3, and back on the other side to R1; at 2/3 "
        "the last line of the triangle, the tangent, is parallel to R0R1.");
    svg_panel(s, svg_integer_window(-4, -4, 9, 7), 520, 0,
              "weights 1, $-$1/2, 1: for $λ=2/3$ the weight $ω_1^1$ is 0 and $R_1^1$ at infinity");
    svg_line(s, svg_pair(R), svg_pair(R + 2), SVG_MUTED);
    static const char *const name[] = {"R_0", "R_1", "R_2"};
    static const enum svg_direction towards[] = {SVG_NW, SVG_NW, SVG_NE};
    svg_polyline(s, 3, R, SVG_POLYGON);
    for (int i = 0; i < 3; i++) {
        svg_mark(s, svg_pair(R + 2 * i), SVG_POLYGON, SVG_USUAL);
        svg_label(s, svg_pair(R + 2 * i), towards[i], SVG_POINT, name[i]);
    }
    svg_rational(s, 2, R, w, SVG_CURVE);
    static const char *const value[] = {"λ=2/5", "λ=1/2", "λ=4/5", "λ=9/10"};
    for (int k = 0; k < 4; k++) {
        rational_casteljau_q(2, 2, R, w, from_ratio_q(numerator[k], denominator[k]), 1, P, v);
        svg_mark(s, svg_pair(P), SVG_WRONG, SVG_USUAL);
        svg_label(s, svg_pair(P), SVG_NW, SVG_WRONG, value[k]);
    }
    num_q H[9], last[3];
    rational_homogenize_q(2, 2, R, w, H);
    bezier_casteljau_level_q(2, 3, H, lambda); /* of the two points the first has the weight 0 */
    rational_dehomogenize_q(0, 2, H + 3, P, last);
    rational_point_q(2, 2, R, w, lambda, S);
    svg_line(s, svg_pair(P), svg_pair(S), SVG_CURVE_2);
    svg_mark(s, svg_pair(P), SVG_CURVE_2, SVG_USUAL);
    svg_label(s, svg_pair(P), SVG_SE, SVG_CURVE_2, "R_2^1");
    svg_mark(s, svg_pair(S), SVG_CURVE, SVG_USUAL);
    svg_label(s, svg_pair(S), SVG_SE, SVG_CURVE, "R_2^2=R(2/3)");
    svg_legend_line(s, SVG_CURVE, "the curve");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "$R_1^1$ for four values of $λ$");
    svg_legend_line(s, SVG_CURVE_2, "the line $R_1^1R_2^1$ for $λ=2/3$");
    return s;
}

/* A quadratic, its right half, and the cut. */
struct right_half {
    num_q R[6], w[3], c;
};

/* The printed quotient with the weights repaired: numerator at t, denominator at (t - c)/(1 - c). */
static svg_point printed_right_half(num_q t, const void *data)
{
    const struct right_half *h = data;
    num_q H[9], P[3], one = from_int_q(1);
    rational_homogenize_q(2, 2, h->R, h->w, H);
    bezier_casteljau_q(2, 3, H, t, P);
    num_q bottom = rational_weight_q(2, h->w, div_q(sub_q(t, h->c), sub_q(one, h->c)));
    return (svg_point){div_q(P[0], bottom), div_q(P[1], bottom)};
}

FIGURE(right_half_misprint)
{
    static const int point[] = {0, 0, 3, 5, 6, 0}, weight[] = {1, 2, 1};
    num_q R[6], w[3], c = from_ratio_q(1, 2), one = from_int_q(1), Rl[6], wl[3];
    struct right_half h = {.c = c};
    integers(6, point, R);
    integers(3, weight, w);
    rational_split_q(2, 2, R, w, c, Rl, wl, h.R, h.w);
    svg *s = svg_new(
        "right_half_misprint", "The right half, as printed and as it is",
        "A rational quadratic cut at 1/2.  The printed quotient, even with the right weights, leaves the curve because "
        "numerator and denominator have different arguments.");
    svg_panel(s, svg_integer_window(-1, -1, 8, 6), 480, 0,
              "$[a,b] = [0,1], c = 1/2$; the numerator with the argument\n$(t-a)/(b-a)$, the weights already repaired");
    svg_control_polygon(s, 2, R, "R");
    svg_rational(s, 2, R, w, SVG_FAMILY);
    svg_rational(s, 2, h.R, h.w, SVG_RIGHT);
    svg_plot(s, printed_right_half, &h, c, one, 16, SVG_WRONG);
    svg_point wrong = printed_right_half(from_ratio_q(3, 4), &h);
    num_q P[2];
    rational_point_q(2, 2, R, w, from_ratio_q(3, 4), P);
    svg_mark(s, svg_pair(P), SVG_RIGHT, SVG_USUAL);
    svg_label_at(s, svg_pair(P), SVG_START, 190, 0, SVG_RIGHT, "R(3/4)");
    svg_mark(s, wrong, SVG_WRONG, SVG_USUAL);
    svg_label(s, wrong, SVG_SW, SVG_WRONG, "t = 3/4");
    svg_legend_line(s, SVG_RIGHT, "the curve over $[c,b]$");
    svg_legend_line(s, SVG_WRONG, "the printed quotient, $c ≤ t ≤ b$");
    return s;
}
