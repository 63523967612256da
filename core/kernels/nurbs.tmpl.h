/* nurbs.tmpl.h -- NURBS curves (非均匀有理 B 样条曲线)
 *
 *     R(t) = sum N_{i,p}(t) w_i R_i / w(t),   w(t) = sum N_{i,p}(t) w_i.
 *
 * Knots, points and spans as in bspline.tmpl.h; the points R_i are affine, of dim coordinates, 1 <= dim < MAX_DIM, the
 * weights (权因子) w_i stand beside them, not multiplied in.  Any weights; a value is UNDEFINED where w(t) = 0.
 * What is not here is done in homogeneous coordinates: rational_homogenize(n-1, ...), then the function of
 * bspline.tmpl.h with dim+1, then rational_dehomogenize(n-1, ...).
 * Source: wang-ch4, 4.1; piegl-tiller-1997, ch. 4 and 5. */
#include "core/number/generic_on.h"

/* H: the p+1 homogeneous points of the span (formula 4.1.1).  The knots are not read. */
KERNEL void G(nurbs_homogenize)(struct G(curve_span) s, num H[restrict])
{
    int first = s.mu - s.degree;
    G(rational_homogenize)(s.degree, s.dim, s.points + first * s.dim, s.weights + first, H);
}

/* The denominator w(t).  The points are not read. */
KERNEL num G(nurbs_weight)(struct G(curve_span) s, num t)
{
    num total;
    G(bspline_deboor)(G(on_span)(s.degree, 1, s.knots, s.mu, s.weights), t, &total);
    return total;
}

/* out = R(t), of dim coordinates (formula 4.1.2). */
KERNEL void G(nurbs_point)(struct G(curve_span) s, num t, num out[restrict])
{
    num H[(MAX_DEGREE + 1) * MAX_DIM], P[MAX_DIM], total;
    G(nurbs_homogenize)(s, H);
    G(bspline_deboor)(G(span_alone)(s.degree, s.dim + 1, s.knots, s.mu, H), t, P);
    G(rational_dehomogenize)(0, s.dim, P, out, &total);
}

/* Row k of out is the k-th derivative of R at t, k = 0, ..., r, r <= MAX_DEGREE. */
KERNEL void G(nurbs_derivatives)(struct G(curve_span) s, num t, int r, num out[restrict])
{
    num H[(MAX_DEGREE + 1) * MAX_DIM], D[(MAX_DEGREE + 1) * MAX_DIM];
    G(nurbs_homogenize)(s, H);
    G(bspline_derivatives)(G(span_alone)(s.degree, s.dim + 1, s.knots, s.mu, H), t, r, D);
    G(rational_quotient_derivatives)(s.dim, D, r, out);
}

/* The squared curvature at t, 2 <= dim < MAX_DIM.  UNDEFINED also where R' = 0. */
KERNEL num G(nurbs_curvature_squared)(struct G(curve_span) s, num t)
{
    num D[3 * MAX_DIM];
    G(nurbs_derivatives)(s, t, 2, D);
    return G(curvature_squared)(s.dim, D + s.dim, D + 2 * s.dim);
}

/* The torsion at t of a curve in space, dim = 3.  UNDEFINED also where R' x R'' = 0. */
KERNEL num G(nurbs_torsion)(struct G(curve_span) s, num t)
{
    num D[4 * 3];
    G(nurbs_derivatives)(s, t, 3, D);
    return G(torsion)(D + 3, D + 6, D + 9);
}

/* Level r of the rational triangle at t, 1 <= r <= p, in place (formulas 4.1.3 and 4.1.4): the p+2-r points R and weights w,
 * i = mu-p+r-1, ..., mu, of level r-1 become the p+1-r of level r,
 *     w_i^r = a w_i^{r-1} + b w_{i-1}^{r-1},   R_i^r = a w_i^{r-1}/w_i^r R_i^{r-1} + b w_{i-1}^{r-1}/w_i^r R_{i-1}^{r-1},
 * a = (t - u_i)/(u_{i+p+1-r} - u_i), b = 1-a.  The last ones stay; those of s are not read.  UNDEFINED where a new weight is 0. */
KERNEL void G(nurbs_deboor_level)(struct G(curve_span) s, int r, num R[], num w[], num t)
{
    const num *u = s.knots;
    for (int m = 0; m <= s.degree - r; m++) {
        int i = s.mu - s.degree + r + m, far = i + s.degree + 1 - r;
        num length = sub(u[far], u[i]);
        num right = mul(div(sub(t, u[i]), length), w[m + 1]), left = mul(div(sub(u[far], t), length), w[m]);
        w[m] = add(right, left);
        right = div(right, w[m]);
        left = div(left, w[m]);
        for (int c = 0; c < s.dim; c++)
            R[m * s.dim + c] = add(mul(right, R[(m + 1) * s.dim + c]), mul(left, R[m * s.dim + c]));
    }
}

/* The recursion to its end, algorithm 4.1.1: out = R(t), as the last point of the triangle above.  UNDEFINED as soon
 * as a weight of any level is 0, which positive weights exclude for u_mu <= t <= u_{mu+1}. */
KERNEL void G(nurbs_deboor)(struct G(curve_span) s, num t, num out[restrict])
{
    int p = s.degree, dim = s.dim, first = s.mu - p;
    num P[(MAX_DEGREE + 1) * MAX_DIM], v[MAX_DEGREE + 1];
    for (int m = 0; m < (p + 1) * dim; m++)
        P[m] = s.points[first * dim + m];
    for (int m = 0; m <= p; m++)
        v[m] = s.weights[first + m];
    for (int r = 1; r <= p; r++)
        G(nurbs_deboor_level)(s, r, P, v, t);
    for (int c = 0; c < dim; c++)
        out[c] = P[c];
}

/* Boehm's insertion of one knot x, u_mu <= x < u_{mu+1}: n+p+2 knots v, n+1 points S and weights z of the same curve,
 *     z_i = a w_i + (1-a) w_{i-1},   S_i = (a w_i R_i + (1-a) w_{i-1} R_{i-1})/z_i
 * with a as in bspline_insert.  UNDEFINED where a z_i is 0. */
KERNEL void G(nurbs_insert)(const struct G(spline) * curve, int mu, num x, num v[restrict], num S[restrict],
                            num z[restrict])
{
    int n = curve->count, p = curve->degree, dim = curve->dim;
    const num *u = curve->knots, *R = curve->points, *w = curve->weights;
    num P[(MAX_DEGREE + 1) * MAX_DIM], q[MAX_DEGREE + 1];
    for (int m = 0; m < (p + 1) * dim; m++)
        P[m] = R[(mu - p) * dim + m];
    for (int m = 0; m <= p; m++)
        q[m] = w[mu - p + m];
    if (p > 0)
        G(nurbs_deboor_level)(G(span_of_curve)(curve, mu), 1, P, q, x);
    for (int i = 0; i <= n + p + 1; i++)
        v[i] = i <= mu ? u[i] : i == mu + 1 ? x : u[i - 1];
    for (int i = 0; i <= n; i++) {
        int changed = mu - p < i && i <= mu, from = changed ? i - mu + p - 1 : i <= mu ? i : i - 1;
        z[i] = changed ? q[from] : w[from];
        for (int c = 0; c < dim; c++)
            S[i * dim + c] = changed ? P[from * dim + c] : R[from * dim + c];
    }
}
#include "core/number/generic_off.h"
