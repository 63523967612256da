/* rational.tmpl.h -- rational Bézier curves (有理 Bézier 曲线)
 *
 *     R(t) = sum B_i^n(t) w_i R_i / w(t),   w(t) = sum B_i^n(t) w_i.
 *
 * The points R_i are affine, coordinate c of point i is R[i*dim + c]; the weights (权因子) w_i stand
 * beside them, not multiplied in.  0 <= n <= MAX_DEGREE, 1 <= dim < MAX_DIM.  Any t and any weights;
 * a value is UNDEFINED where its weight is 0.  A point of weight 0 does not count.  Results do not
 * overlap arguments unless said.
 * Source: wang-ch3, 3.2 and 3.3; farin-2002, ch. 12 and 13. */
#include "core/number/binomial.h"

#include "core/number/generic_on.h"

/* H_i = (w_i R_i, w_i): n+1 points of dim+1 coordinates, the weight last (formula 3.2.1). */
KERNEL void G(rational_homogenize)(int n, int dim, const num R[restrict], const num w[restrict], num H[restrict])
{
    for (int i = 0; i <= n; i++) {
        for (int c = 0; c < dim; c++)
            H[i * (dim + 1) + c] = mul(w[i], R[i * dim + c]);
        H[i * (dim + 1) + dim] = w[i];
    }
}

/* The inverse: w_i is the last coordinate of H_i, R_i the others divided by it. */
KERNEL void G(rational_dehomogenize)(int n, int dim, const num H[restrict], num R[restrict], num w[restrict])
{
    for (int i = 0; i <= n; i++) {
        w[i] = H[i * (dim + 1) + dim];
        for (int c = 0; c < dim; c++)
            R[i * dim + c] = div(H[i * (dim + 1) + c], w[i]);
    }
}

/* The denominator w(t). */
KERNEL num G(rational_weight)(int n, const num w[], num t)
{
    num total;
    G(bezier_casteljau)(n, 1, w, t, &total);
    return total;
}

/* out = R(t), of dim coordinates. */
KERNEL void G(rational_point)(int n, int dim, const num R[restrict], const num w[restrict], num t, num out[restrict])
{
    num H[(MAX_DEGREE + 1) * MAX_DIM], P[MAX_DIM], total;
    G(rational_homogenize)(n, dim, R, w, H);
    G(bezier_casteljau)(n, dim + 1, H, t, P);
    G(rational_dehomogenize)(0, dim, P, out, &total);
}

/* Row k of out is the k-th derivative of R = P/w, k = 0, ..., r, r <= MAX_DEGREE, from those of the homogeneous
 * curve: row k of D holds P^(k) and w^(k).  By P = w R and Leibniz,
 *     R^(k) = (P^(k) - sum_{j=1}^k C(k,j) w^(j) R^(k-j)) / w. */
KERNEL void G(rational_quotient_derivatives)(int dim, const num D[restrict], int r, num out[restrict])
{
    for (int k = 0; k <= r; k++)
        for (int c = 0; c < dim; c++) {
            num sum = D[k * (dim + 1) + c];
            for (int j = 1; j <= k; j++) {
                num term = mul(D[j * (dim + 1) + dim], out[(k - j) * dim + c]);
                sum = sub(sum, mul(from_int(binomial(k, j)), term));
            }
            out[k * dim + c] = div(sum, D[dim]);
        }
}

/* Row k of out is the k-th derivative of R at t, k = 0, ..., r, r <= MAX_DEGREE. */
KERNEL void G(rational_derivatives)(int n, int dim, const num R[restrict], const num w[restrict], num t, int r,
                                    num out[restrict])
{
    num H[(MAX_DEGREE + 1) * MAX_DIM], D[(MAX_DEGREE + 1) * MAX_DIM];
    G(rational_homogenize)(n, dim, R, w, H);
    G(bezier_derivatives)(n, dim + 1, H, t, r, D);
    G(rational_quotient_derivatives)(dim, D, r, out);
}

/* Level r, 0 <= r <= n, of the rational de Casteljau triangle at lambda (formulas 3.3.2 and 3.3.3):
 *     w_i^r = (1-lambda) w_{i-1}^{r-1} + lambda w_i^{r-1},
 *     R_i^r = (1-lambda) w_{i-1}^{r-1}/w_i^r R_{i-1}^{r-1} + lambda w_i^{r-1}/w_i^r R_i^{r-1}.
 * The book's indices i = r, ..., n are stored from 0: n-r+1 points Rr and weights wr.
 * UNDEFINED as soon as a weight of some level 1, ..., r is 0. */
KERNEL void G(rational_casteljau)(int n, int dim, const num R[restrict], const num w[restrict], num lambda, int r,
                                  num Rr[restrict], num wr[restrict])
{
    num P[(MAX_DEGREE + 1) * MAX_DIM], v[MAX_DEGREE + 1], mu = sub(from_int(1), lambda);
    for (int i = 0; i <= n; i++)
        v[i] = w[i];
    for (int m = 0; m < (n + 1) * dim; m++)
        P[m] = R[m];
    for (int k = 1; k <= r; k++)
        for (int i = 0; i <= n - k; i++) {
            num left = mul(mu, v[i]), right = mul(lambda, v[i + 1]);
            v[i] = add(left, right);
            left = div(left, v[i]);
            right = div(right, v[i]);
            for (int c = 0; c < dim; c++)
                P[i * dim + c] = add(mul(left, P[i * dim + c]), mul(right, P[(i + 1) * dim + c]));
        }
    for (int i = 0; i <= n - r; i++)
        wr[i] = v[i];
    for (int m = 0; m < (n - r + 1) * dim; m++)
        Rr[m] = P[m];
}

/* The same curve over [0,t] (Rl, wl) and over [t,1] (Rr, wr), each over the unit interval (theorem
 * 3.3.1).  By homogeneous coordinates: UNDEFINED only if one of the resulting weights is 0. */
KERNEL void G(rational_split)(int n, int dim, const num R[restrict], const num w[restrict], num t, num Rl[restrict],
                              num wl[restrict], num Rr[restrict], num wr[restrict])
{
    num H[(MAX_DEGREE + 1) * MAX_DIM], left[(MAX_DEGREE + 1) * MAX_DIM], right[(MAX_DEGREE + 1) * MAX_DIM];
    G(rational_homogenize)(n, dim, R, w, H);
    G(bezier_split)(n, dim + 1, H, t, left, right);
    G(rational_dehomogenize)(n, dim, left, Rl, wl);
    G(rational_dehomogenize)(n, dim, right, Rr, wr);
}

/* The n+2 points Re and weights we of the same curve in degree n+1 <= MAX_DEGREE (formulas 3.2.8 and
 * 3.2.9), by homogeneous coordinates. */
KERNEL void G(rational_elevate)(int n, int dim, const num R[restrict], const num w[restrict], num Re[restrict],
                                num we[restrict])
{
    num H[(MAX_DEGREE + 1) * MAX_DIM], E[(MAX_DEGREE + 1) * MAX_DIM];
    G(rational_homogenize)(n, dim, R, w, H);
    G(bezier_elevate)(n, dim + 1, H, E);
    G(rational_dehomogenize)(n + 1, dim, E, Re, we);
}

/* out_i = w_i a^i b^{n-i}: the weights of the same curve and points in the parameter u with
 * t = a u / (a u + b (1-u)), a and b not 0 (formulas 3.2.10 and 3.2.14).  out may be w. */
KERNEL void G(rational_reparametrize)(int n, const num w[], num a, num b, num out[])
{
    num power = from_int(1);
    for (int i = 0; i <= n; i++, power = mul(power, a))
        out[i] = mul(w[i], power);
    power = from_int(1);
    for (int i = n; i >= 0; i--, power = mul(power, b))
        out[i] = mul(out[i], power);
}

/* The n-1 invariants (不变量) I[i-1] = I_i = w_i^2 / (w_{i-1} w_{i+1}), i = 1, ..., n-1, of the
 * transformations above (definition 3.2.2).  UNDEFINED when w_{i-1} or w_{i+1} is 0. */
KERNEL void G(rational_invariants)(int n, const num w[restrict], num I[restrict])
{
    for (int i = 1; i < n; i++)
        I[i - 1] = mul(div(w[i], w[i - 1]), div(w[i], w[i + 1]));
}

/* The standard form (标准形): the weights w_i/w_0 q^i with q = (w_0/w_n)^{1/n}, n >= 1, so that the
 * first and the last are 1.  UNDEFINED when w_0 or w_n is 0; UNABLE when w_0/w_n has no such root.
 * out may be w. */
KERNEL void G(rational_standard_form)(int n, const num w[], num out[])
{
    num q = root(n, div(w[0], w[n])), scale = div(from_int(1), w[0]);
    for (int i = 1; i < n; i++) {
        scale = mul(scale, q);
        out[i] = mul(w[i], scale);
    }
    out[0] = out[n] = from_int(1);
}
#include "core/number/generic_off.h"
