/* The figure of the section on the proof of the end formulas. */
#include "chapters/judge/figure.h"
#include "chapters/judge/figure_data.h"
#include "figures/words.h"

/* The graph of c_0 + c_1 t + c_2 t^2 + c_3 t^3 over [0, b]. */
static void draw_polynomial(svg *s, const num_q c[4], num_q b, enum svg_role drawn_as)
{
    num_q scaled[4], y[4], P[8], power = q(1);
    for (int k = 0; k < 4; k++, power = mul_q(power, b))
        scaled[k] = mul_q(c[k], power);
    bernstein_from_power_q(3, scaled, y);
    for (int i = 0; i < 4; i++) {
        P[2 * i] = mul_q(r(i, 3), b);
        P[2 * i + 1] = y[i];
    }
    svg_bezier(s, 3, P, drawn_as);
}

/* (t, R(t)) as a rational curve of degree n + 1: points, weights, the abscissa t = t w/w. */
static void draw_values(svg *s, int n, const num_q R[], const num_q w[])
{
    num_q H[3 * 8], t[] = {q(0), q(1)}, one[] = {q(1), q(1)}, p[8], x[8], y[8], v[8], Q[16], u[8];
    for (int i = 0; i <= n; i++)
        p[i] = mul_q(w[i], R[i]);
    bernstein_product_q(n, w, 1, t, x);
    bernstein_product_q(n, p, 1, one, y);
    bernstein_product_q(n, w, 1, one, v);
    for (int i = 0; i <= n + 1; i++) {
        H[3 * i] = x[i];
        H[3 * i + 1] = y[i];
        H[3 * i + 2] = v[i];
    }
    rational_dehomogenize_q(n + 1, 2, H, Q, u);
    svg_rational(s, n + 1, Q, u, SVG_CURVE);
}

FIGURE(quotient_derivatives)
{
    svg *s = svg_new(
        "quotient_derivatives", "The printed second and third derivatives of a quotient",
        "Left, (1+3t)/(1+t) with its Taylor polynomial of order 2 and the one with the printed R''(0) = -5.  Right, "
        "(2t+2t^2)/(1+t^2) with its Taylor polynomial of order 3 and the one with the printed R'''(0) = -24.");
    num_q one[2], one_weights[2], two[3], two_weights[3];
    data_of("printed_second_derivative_of_quotient_is_wrong", "R", 2, 1, one);
    data_of("printed_second_derivative_of_quotient_is_wrong", "ω", 2, 1, one_weights);
    data_of("printed_third_derivative_of_quotient_is_wrong", "R", 3, 1, two);
    data_of("printed_third_derivative_of_quotient_is_wrong", "ω", 3, 1, two_weights);
    num_q right2[] = {q(1), q(2), q(-2), q(0)}, wrong2[] = {q(1), q(2), r(-5, 2), q(0)};
    num_q right3[] = {q(0), q(2), q(2), q(-2)}, wrong3[] = {q(0), q(2), q(2), q(-4)};
    svg_panel(s, (svg_window){q(0), r(1, 2), q(1), r(9, 4)}, 280, 260,
              "$R = (1+3t)/(1+t)$: printed $R''(0) = -5$,\ntrue $R''(0) = -4$");
    svg_axes(s, r(1, 4), r(1, 2), "t", "R");
    draw_polynomial(s, wrong2, q(1), SVG_WRONG);
    draw_polynomial(s, right2, q(1), SVG_RIGHT);
    draw_values(s, 1, one, one_weights);
    svg_panel(s, (svg_window){q(0), q(0), q(1), r(9, 4)}, 280, 260,
              "$R = (2t+2t^2)/(1+t^2)$: printed $R'''(0) = -24$,\ntrue $R'''(0) = -12$");
    svg_axes(s, r(1, 4), r(1, 2), "t", "R");
    draw_polynomial(s, wrong3, q(1), SVG_WRONG);
    draw_polynomial(s, right3, q(1), SVG_RIGHT);
    draw_values(s, 2, two, two_weights);
    svg_legend_line(s, SVG_CURVE, "$R(t)$");
    svg_legend_line(s, SVG_RIGHT, "Taylor polynomial at $0$");
    svg_legend_line(s, SVG_WRONG, "with the printed derivative");
    return s;
}
