/* shape_parameter.tmpl.h -- Bézier curves with a shape parameter (带形状参数的 Bézier 曲线)
 *
 *     q(t) = sum_{i=0}^n P_i B_{i,n}(t),   B_{i,n}(t) = (near_i (1-t) + far_i t) (1-t)^{n-i} t^i,
 *     near_i = C(n,i) + beta a_i,   far_i = near_{n-i},   a_i = C(n-2,i-1) - C(n-2,i-2),
 *
 * of degree n+1 and, for beta = 0, the Bézier curve of degree n.  2 <= n < MAX_DEGREE, 1 <= dim <= MAX_DIM,
 * any beta and t; coordinate c of point i is P[i*dim + c].  Results do not overlap arguments.
 * The family is the corrected one of deng-zhang-2022 in every degree; the functions that are called
 * printed are those of formula (1) there, n = 7, by the letter.
 * Source: deng-zhang-2022, definitions 2.1, 3.1 and 5.1. */
#include "core/number/binomial.h"

#include "core/number/generic_on.h"

/* near[i] and far[i], i = 0, ..., n. */
KERNEL void G(shape_factors)(int n, num beta, num near[restrict], num far[restrict])
{
    for (int i = 0; i <= n; i++) {
        long a = binomial(n - 2, i - 1) - binomial(n - 2, i - 2);
        near[i] = add(from_int(binomial(n, i)), mul(from_int(a), beta));
        far[n - i] = near[i];
    }
}

/* The same of the printed functions: row i of (1) is (c_0 + c_1 beta + c_2 beta t) (1-t)^{7-i} t^i. */
KERNEL void G(shape_factors_printed)(num beta, num near[restrict], num far[restrict])
{
    static const int row[8][3] = {{1, 0, -1}, {7, 1, -5},  {21, 4, -9}, {35, 5, -9},
                                  {35, 0, 1}, {21, -5, 9}, {7, -4, 5},  {1, -1, 1}};
    for (int i = 0; i <= 7; i++) {
        near[i] = add(from_int(row[i][0]), mul(from_int(row[i][1]), beta));
        far[i] = add(near[i], mul(from_int(row[i][2]), beta));
    }
}

/* B[i] = B_{i,n}(t).  Functions of degree 3 in the place of the last two levels of the recursion:
 *     B_{i,n} = (1-t)^2 (1 - beta t) B_i^{n-2} + (2 + beta) t (1-t) B_{i-1}^{n-2} + t^2 (1 - beta (1-t)) B_{i-2}^{n-2}. */
KERNEL void G(shape_basis)(int n, num beta, num t, num B[])
{
    num s = sub(from_int(1), t), one = from_int(1);
    num left = mul(mul(s, s), sub(one, mul(beta, t))), right = mul(mul(t, t), sub(one, mul(beta, s)));
    num middle = mul(mul(s, t), add(from_int(2), beta));
    G(bernstein_basis)(n - 2, t, B);
    B[n - 1] = B[n] = from_int(0);
    for (int i = n; i >= 0; i--) {
        num value = mul(left, B[i]);
        if (i >= 1)
            value = add(value, mul(middle, B[i - 1]));
        if (i >= 2)
            value = add(value, mul(right, B[i - 2]));
        B[i] = value;
    }
}

/* B[i] = B_{i,7}(t) as printed, i = 0, ..., 7. */
KERNEL void G(shape_basis_printed)(num beta, num t, num B[])
{
    num near[8], far[8], s = sub(from_int(1), t), power = from_int(1);
    G(shape_factors_printed)(beta, near, far);
    for (int i = 0; i <= 7; i++, power = mul(power, t))
        B[i] = mul(power, add(mul(near[i], s), mul(far[i], t)));
    power = from_int(1);
    for (int i = 7; i >= 0; i--, power = mul(power, s))
        B[i] = mul(power, B[i]);
}

/* The (n+2) x (n+1) matrix E, row by row, of functions (near_i (1-t) + far_i t) (1-t)^{n-i} t^i in the Bernstein
 * basis of degree n+1: B_i = sum_k E_{k,i} B_k^{n+1},
 *     E_{i,i} = near_i / C(n+1,i),   E_{i+1,i} = far_i / C(n+1,i+1),   0 elsewhere. */
KERNEL void G(shape_matrix)(int n, const num near[restrict], const num far[restrict], num E[restrict])
{
    for (int m = 0; m < (n + 2) * (n + 1); m++)
        E[m] = from_int(0);
    for (int i = 0; i <= n; i++) {
        E[i * (n + 1) + i] = div(near[i], from_int(binomial(n + 1, i)));
        E[(i + 1) * (n + 1) + i] = div(far[i], from_int(binomial(n + 1, i + 1)));
    }
}

/* The n+2 Bézier points of q in degree n+1: every one divides an edge of the polygon,
 *     Q_k = (1 - r_k) P_{k-1} + r_k P_k,   r_k = near_k / C(n+1,k),   Q_0 = P_0, Q_{n+1} = P_n. */
KERNEL void G(shape_bezier_points)(int n, int dim, const num P[restrict], num beta, num Q[restrict])
{
    num near[MAX_DEGREE + 1], far[MAX_DEGREE + 1];
    G(shape_factors)(n, beta, near, far);
    for (int c = 0; c < dim; c++) {
        Q[c] = P[c];
        Q[(n + 1) * dim + c] = P[n * dim + c];
    }
    for (int k = 1; k <= n; k++) {
        num whole = from_int(binomial(n + 1, k)), a = div(far[k - 1], whole), b = div(near[k], whole);
        for (int c = 0; c < dim; c++)
            Q[k * dim + c] = add(mul(a, P[(k - 1) * dim + c]), mul(b, P[k * dim + c]));
    }
}

/* out = q(t): n-2 levels of de Casteljau's triangle, and the functions of degree 3 on the three points that are left. */
KERNEL void G(shape_point)(int n, int dim, const num P[restrict], num beta, num t, num out[restrict])
{
    num w[(MAX_DEGREE + 1) * MAX_DIM], B[3];
    for (int m = 0; m < (n + 1) * dim; m++)
        w[m] = P[m];
    for (int k = n; k > 2; k--)
        G(bezier_casteljau_level)(k, dim, w, t);
    G(shape_basis)(2, beta, t, B);
    for (int c = 0; c < dim; c++)
        out[c] = add(mul(B[0], w[c]), add(mul(B[1], w[dim + c]), mul(B[2], w[2 * dim + c])));
}

/* out = sum_{i=0}^7 P_i B_{i,7}(t) with the printed functions. */
KERNEL void G(shape_point_printed)(int dim, const num P[restrict], num beta, num t, num out[restrict])
{
    num B[8];
    G(shape_basis_printed)(beta, t, B);
    for (int c = 0; c < dim; c++) {
        out[c] = mul(P[c], B[0]);
        for (int i = 1; i <= 7; i++)
            out[c] = add(out[c], mul(P[i * dim + c], B[i]));
    }
}

/* Row k of out is the k-th derivative of q at t, k = 0, ..., r; zero for k > n+1. */
KERNEL void G(shape_derivatives)(int n, int dim, const num P[restrict], num beta, num t, int r, num out[restrict])
{
    num Q[(MAX_DEGREE + 1) * MAX_DIM];
    G(shape_bezier_points)(n, dim, P, beta, Q);
    G(bezier_derivatives)(n + 1, dim, Q, t, r, out);
}

/* out = sum_{i,j} P_{ij} B_{i,n}(u) B_{j,m}(v), the first basis with beta, the second with gamma.  Row by row:
 * coordinate c of P_{ij} is P[(i (m+1) + j) dim + c]. */
KERNEL void G(shape_surface_point)(int n, int m, int dim, const num P[restrict], num beta, num gamma, num u, num v,
                                   num out[restrict])
{
    num row[(MAX_DEGREE + 1) * MAX_DIM];
    for (int i = 0; i <= n; i++)
        G(shape_point)(m, dim, P + i * (m + 1) * dim, gamma, v, row + i * dim);
    G(shape_point)(n, dim, row, beta, u, out);
}
#include "core/number/generic_off.h"
