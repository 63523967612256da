/* nurbs_parameters.tmpl.h -- a NURBS curve as a function of what is fitted: its weights, its points, its parameter.
 *
 *     C(t; lambda, P) = sum_m R_m P_m,   R_m = w_m N_m / w,   w = sum_m w_m N_m,   w_m = exp(lambda_m).
 *
 * m = 0, ..., p stands for the index mu-p+m: on a span no other point or weight counts.  Weights are fitted as
 * logarithms, so that they stay positive; a derivative by lambda_m is w_m times that by w_m, and no logarithm is ever
 * computed.  By a coordinate of a point the curve is linear: dC/dP_m = R_m e, and R_m^(r) e after r derivatives by t.
 *
 * Shapes.  Knots, points, weights and spans as in nurbs.tmpl.h; 0 <= r <= MAX_DEGREE.  UNDEFINED where w(t) = 0.
 * Results do not overlap arguments.
 * Source: the quotient rule; the claims are in chapters/fitting/curve-derivatives.claims.h. */
#include "core/number/generic_on.h"

/* Row k of R, k = 0, ..., r, holds the k-th derivatives by t of the rational basis (有理基) of the span, whose points are not read,
 *     R[k(p+1) + m] = R_m^(k)(t),   R_m^(k) = (w_m N_m^(k) - sum_{j=1}^k C(k,j) w^(j) R_m^(k-j)) / w. */
KERNEL void G(nurbs_basis)(struct G(curve_span) s, num t, int r, num R[restrict])
{
    int p = s.degree;
    const num *w = s.weights + (s.mu - p);
    num total[MAX_DEGREE + 1];
    G(bspline_basis_derivatives)(p, s.knots, s.mu, t, r, R);
    for (int k = 0; k <= r; k++) {
        num *row = R + k * (p + 1);
        total[k] = from_int(0);
        for (int m = 0; m <= p; m++) {
            row[m] = mul(w[m], row[m]);
            total[k] = add(total[k], row[m]);
        }
        for (int m = 0; m <= p; m++) {
            for (int j = 1; j <= k; j++)
                row[m] = sub(row[m], mul(mul(from_int(binomial(k, j)), total[j]), row[m - j * (p + 1)]));
            row[m] = div(row[m], total[0]);
        }
    }
}

/* out[m(p+1) + k] = dR_m/dlambda_k = R_m (delta_mk - R_k) at t: a symmetric matrix.  The mixed derivatives of the curve
 * are these numbers times the unit vectors, d^2 C / (dlambda_k dP_m) = dR_m/dlambda_k e. */
KERNEL void G(nurbs_basis_by_weights)(struct G(curve_span) s, num t, num out[restrict])
{
    int p = s.degree;
    num R[MAX_DEGREE + 1];
    G(nurbs_basis)(s, t, 0, R);
    for (int m = 0; m <= p; m++)
        for (int k = 0; k <= p; k++)
            out[m * (p + 1) + k] = mul(R[m], m == k ? sub(from_int(1), R[m]) : neg(R[k]));
}

/* The derivatives by the weights, dC/dlambda_m = R_m (P_m - C), and their derivatives by t, k = 0, ..., r: coordinate
 * c is out[(k(p+1) + m) dim + c] of
 *     d^k/dt^k dC/dlambda_m = R_m^(k) P_m - sum_{j=0}^k C(k,j) R_m^(k-j) C^(j)
 *                           = R_m^(k) (P_m - C) - sum_{j=1}^k C(k,j) R_m^(k-j) C^(j),   C^(j) = sum_m R_m^(j) P_m. */
KERNEL void G(nurbs_by_weights)(struct G(curve_span) s, num t, int r, num out[restrict])
{
    int p = s.degree, dim = s.dim;
    num R[(MAX_DEGREE + 1) * (MAX_DEGREE + 1)], C[(MAX_DEGREE + 1) * MAX_DIM];
    const num *points = s.points + (s.mu - p) * dim;
    G(nurbs_basis)(s, t, r, R);
    for (int k = 0; k <= r; k++)
        for (int c = 0; c < dim; c++) {
            C[k * dim + c] = mul(R[k * (p + 1)], points[c]);
            for (int m = 1; m <= p; m++)
                C[k * dim + c] = add(C[k * dim + c], mul(R[k * (p + 1) + m], points[m * dim + c]));
        }
    for (int k = 0; k <= r; k++)
        for (int m = 0; m <= p; m++)
            for (int c = 0; c < dim; c++) {
                num value = mul(R[k * (p + 1) + m], sub(points[m * dim + c], C[c]));
                for (int j = 1; j <= k; j++) {
                    num term = mul(R[(k - j) * (p + 1) + m], C[j * dim + c]);
                    value = sub(value, mul(from_int(binomial(k, j)), term));
                }
                out[(k * (p + 1) + m) * dim + c] = value;
            }
}

/* The second derivatives by two weights, coordinate c of (m,k) being out[(m(p+1) + k) dim + c]:
 *     d^2 C / (dlambda_m dlambda_k) = delta_mk R_m (P_m - C) - R_m R_k ((P_m - C) + (P_k - C)). */
KERNEL void G(nurbs_by_two_weights)(struct G(curve_span) s, num t, num out[restrict])
{
    int p = s.degree, dim = s.dim;
    num R[MAX_DEGREE + 1], away[(MAX_DEGREE + 1) * MAX_DIM];
    const num *points = s.points + (s.mu - p) * dim;
    G(nurbs_basis)(s, t, 0, R);
    for (int c = 0; c < dim; c++) {
        num C = mul(R[0], points[c]);
        for (int m = 1; m <= p; m++)
            C = add(C, mul(R[m], points[m * dim + c]));
        for (int m = 0; m <= p; m++)
            away[m * dim + c] = sub(points[m * dim + c], C);
    }
    for (int m = 0; m <= p; m++)
        for (int k = 0; k <= p; k++)
            for (int c = 0; c < dim; c++) {
                num both = mul(mul(R[m], R[k]), add(away[m * dim + c], away[k * dim + c]));
                num own = m == k ? mul(R[m], away[m * dim + c]) : from_int(0);
                out[(m * (p + 1) + k) * dim + c] = sub(own, both);
            }
}
#include "core/number/generic_off.h"
