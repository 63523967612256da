/* coefficient-matrix.figure.c -- drawings for coefficient-matrix.claims.h. */
#include "chapters/nurbs/matrix-figures.h"

#include <stdio.h>

/* A quadratic span with weights 1, 3, 1: the matrix on homogeneous points and, wrongly, on the affine ones. */
FIGURE(matrix_and_weights)
{
    enum { p = 2, k = 3 };
    static const int points[2 * k] = {0, 0, 2, 6, 8, 2}, from[2 * k] = {-2, -1, 0, 1, 2, 3};
    static const int weights[k] = {1, 4, 1};
    num_q R[2 * k], knots[2 * k], A[k * k], affine[2 * k], curve[2 * k], w[k];
    svg *s =
        svg_new("matrix_and_weights", "The matrix needs the weights",
                "Three control points with the weights 1, 4, 1.  The coefficient matrix applied to the homogeneous "
                "points gives the segment of the NURBS curve; applied to the affine points it gives another arc.");
    integers(2 * k, points, R);
    integers(2 * k, from, knots);
    bspline_matrix_q(p, knots, p, A);
    /* From powers of u to the points of Bézier, for each coordinate and for the weights. */
    num_q b[3][k], plain[2][k];
    for (int c = 0; c < 3; c++) {
        num_q sum[k], without[k];
        for (int j = 0; j < k; j++) {
            sum[j] = without[j] = q(0);
            for (int i = 0; i < k; i++) {
                num_q weight = q(weights[i]), value = c < 2 ? R[2 * i + c] : q(1);
                sum[j] = add_q(sum[j], mul_q(A[j * k + i], mul_q(weight, value)));
                without[j] = add_q(without[j], mul_q(A[j * k + i], value));
            }
        }
        bernstein_from_power_q(p, sum, b[c]);
        if (c < 2)
            bernstein_from_power_q(p, without, plain[c]);
    }
    for (int i = 0; i < k; i++) {
        w[i] = b[2][i];
        for (int c = 0; c < 2; c++) {
            curve[2 * i + c] = div_q(b[c][i], w[i]);
            affine[2 * i + c] = plain[c][i];
        }
    }
    svg_panel(s, window(r(-1, 2), r(-1, 2), r(17, 2), r(13, 2)), 400, 0, "order 3, uniform knots, weights 1, 4, 1");
    svg_control_polygon(s, p, R, "r");
    svg_bezier(s, p, affine, SVG_WRONG);
    svg_rational(s, p, curve, w, SVG_RIGHT);
    svg_legend_line(s, SVG_RIGHT, "the curve");
    svg_legend_line(s, SVG_WRONG, "the matrix applied to $r_i$");
    return s;
}

/* Cubic spans [0, 1] whose outer knots -2g, -g and 1+g, 1+2g move into its ends. */
FIGURE(matrices_of_merging_knots)
{
    enum { p = 3, k = 4, stages = 5 };
    static const int numerator[stages] = {2, 1, 1, 1, 0}, denominator[stages] = {1, 1, 2, 4, 1};
    static const int apart[2 * k] = {0, 1, 2, 3, 4, 5, 6, 7}, merged[2 * k] = {0, 1, 1, 1, 2, 2, 2, 3};
    static const char *const caption[stages] = {"$g=2$", "$g=1$: uniform", "$g=1/2$", "$g=1/4$", "$g=0$: Bernstein"};
    svg *s = svg_new("matrices_of_merging_knots", "The coefficient matrix as knots merge",
                     "Five coefficient matrices of the cubic span from 0 to 1 with the outer knots -2g, -g, 1+g and "
                     "1+2g, for g = 2, "
                     "1, 1/2, 1/4 and 0.  As the outer knots move into the ends of the span, the entries above the "
                     "diagonal fade, and "
                     "those below become the binomial numbers of the Bernstein polynomials in powers.");
    for (int n = 0; n < stages; n++) {
        num_q u[2 * k], A[k * k], g = r(numerator[n], denominator[n]);
        for (int m = 0; m < k; m++) {
            u[k - 1 - m] = neg_q(mul_q(q(m), g));
            u[k + m] = add_q(q(1), mul_q(q(m), g));
        }
        if (numerator[n] == 0) /* the outermost knots do not count, but have to differ */
            u[0] = q(-1), u[2 * k - 1] = q(2);
        bspline_matrix_by_differences_q(p, u, numerator[n] == 0 ? merged : apart, p, A);
        put_matrix(s, k, A, 56, caption[n]);
    }
    return s;
}

/* N_{i,3} of the knots 0, 1, 2, 3 on its middle span: the sums over the knots right of the span, and over all. */
FIGURE(full_powers)
{
    enum { p = 2, k = 3 };
    static const int from[2 * k] = {-1, 0, 1, 2, 3, 4}, one[k + 1] = {1, 1, 1, 1};
    num_q u[2 * k], A[k * k], c[k], alpha[k + 1];
    svg *s = svg_new(
        "full_powers", "With full powers the sum is zero",
        "The quadratic B-spline of the knots 0, 1, 2, 3.  On the span from 1 to 2 the printed sum over all knots "
        "is the zero function; the sum over the knots to the right of the span is the B-spline.");
    integers(2 * k, from, u);
    svg_panel(s, window(r(-1, 4), r(-1, 4), r(13, 4), r(1, 1)), 420, 190,
              "$k=3$, the knots of $N_{i,3}$ are 0, 1, 2, 3; span $[1,2)$");
    svg_axes(s, q(1), r(1, 2), "t", NULL);
    for (int span = 0; span < 3; span++) { /* the pieces of N on [0,1], [1,2], [2,3] */
        for (int m = 0; m < 2 * k; m++)
            u[m] = q(span - 2 + m);
        bspline_matrix_q(p, u, p, A);
        column_of(p, A, 2 - span, q(1), c);
        put_polynomial(s, p, c, q(span), q(span + 1), span == 1 ? SVG_RIGHT : SVG_MUTED);
    }
    /* The printed second line on [1,2]: 3 times the sum of alpha_l (t_l - t)^2, t = 1 + u. */
    num_q tau[k + 1] = {q(0), q(1), q(2), q(3)}, sum[k] = {q(0), q(0), q(0)};
    divided_weights_q(k + 1, one, tau, alpha);
    for (int m = 0; m <= k; m++) {
        num_q gap = sub_q(tau[m], q(1)), weight = mul_q(q(3), alpha[m]);
        sum[0] = add_q(sum[0], mul_q(weight, mul_q(gap, gap)));
        sum[1] = sub_q(sum[1], mul_q(weight, mul_q(q(2), gap)));
        sum[2] = add_q(sum[2], weight);
    }
    put_polynomial(s, p, sum, q(1), q(2), SVG_WRONG);
    svg_legend_line(s, SVG_RIGHT, "the sum over $τ_λ>t_r$");
    svg_legend_line(s, SVG_WRONG, "the sum over all $τ_λ$, as printed");
    svg_legend_line(s, SVG_MUTED, "$N_{i,3}$ on the other spans");
    return s;
}

/* Both sides of the first line of the proof for k = 1, where a zero power stands at a knot. */
FIGURE(zero_power_at_a_knot)
{
    svg *s = svg_new(
        "zero_power_at_a_knot", "A zero power at a knot",
        "The B-spline of order 1 of the knots 0 and 1, and the difference of the truncated powers at its "
        "knots.  They agree but for t = 0, where the zeroth power of 0 counts as 1 and the difference is 0, and "
        "for t = 1.");
    svg_panel(s, window(r(-1, 2), r(-1, 5), r(3, 2), r(6, 5)), 420, 190,
              "$k=1$: $N_{i,1}(t)$ and $(1-t)_+^0-(0-t)_+^0$");
    svg_axes(s, q(1), q(1), "t", NULL);
    svg_segment(s, at(r(-1, 2), q(0)), svg_at(0, 0), SVG_CURVE);
    svg_segment(s, svg_at(0, 1), svg_at(1, 1), SVG_CURVE);
    svg_segment(s, svg_at(1, 0), at(r(3, 2), q(0)), SVG_CURVE);
    svg_mark(s, svg_at(0, 1), SVG_RIGHT, SVG_USUAL);
    svg_mark(s, svg_at(1, 0), SVG_RIGHT, SVG_USUAL);
    svg_mark(s, svg_at(0, 0), SVG_WRONG, SVG_USUAL);
    svg_mark(s, svg_at(1, 1), SVG_WRONG, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "both");
    svg_legend_mark(s, SVG_RIGHT, SVG_USUAL, "$N_{i,1}$ at its knots");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "the difference, with $0_+^0=1$");
    return s;
}
