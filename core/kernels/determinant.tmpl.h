/* determinant.tmpl.h -- determinants without division, and resultants (结式).
 *
 * Matrices are stored row by row and have at most MAX_ORDER rows.  A polynomial of formal degree n
 * has coefficients a[0] x^n + a[1] x^{n-1} + ... + a[n], a[0] the leading one; it may be 0.
 * Results do not overlap arguments.
 * Source: wang-ch3, 3.4; bird-2011. */
#include "core/number/binomial.h"

#include "core/number/generic_on.h"

/* det M of an n x n matrix, 1 <= n <= MAX_ORDER, in O(n^4) additions and multiplications.  For a
 * matrix X let mu(X) keep what is above the diagonal of X, have 0 below it, and
 * -(X_{i+1,i+1} + ... + X_{n,n}) in place i of it.  Then X_1 = M, X_{k+1} = mu(X_k) M leads to
 * X_n whose first entry is (-1)^{n-1} det M.  Below the diagonal X is never needed. */
KERNEL num G(determinant)(int n, const num M[])
{
    num X[MAX_ORDER * MAX_ORDER], mu[MAX_ORDER], row[MAX_ORDER];
    for (int m = 0; m < n * n; m++)
        X[m] = M[m];
    for (int k = 1; k < n; k++) {
        mu[n - 1] = from_int(0);
        for (int i = n - 1; i > 0; i--)
            mu[i - 1] = sub(mu[i], X[i * n + i]);
        for (int i = 0; i < n; i++) {
            for (int j = i; j < n; j++) {
                row[j] = mul(mu[i], M[i * n + j]);
                for (int m = i + 1; m < n; m++)
                    row[j] = add(row[j], mul(X[i * n + m], M[m * n + j]));
            }
            for (int j = i; j < n; j++)
                X[i * n + j] = row[j];
        }
    }
    return n % 2 == 0 ? neg(X[0]) : X[0];
}

/* Sylvester's (m+n) x (m+n) matrix of a (degree m) and b (degree n), m + n <= MAX_ORDER: n rows of
 * shifted a over m rows of shifted b (formula 3.4.1).  Its determinant is their resultant. */
KERNEL void G(sylvester)(int m, const num a[restrict], int n, const num b[restrict], num M[restrict])
{
    for (int i = 0; i < m + n; i++)
        for (int j = 0; j < m + n; j++) {
            int k = i < n ? j - i : j - (i - n), degree = i < n ? m : n;
            M[i * (m + n) + j] = k < 0 || k > degree ? from_int(0) : i < n ? a[k] : b[k];
        }
}

/* The symmetric n x n matrix M of Bézout of a and b, both of degree n <= MAX_ORDER:
 *     (a(x) b(y) - a(y) b(x)) / (x - y) = sum M_{ij} x^{n-1-i} y^{n-1-j}. */
KERNEL void G(bezout)(int n, const num a[restrict], const num b[restrict], num M[restrict])
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            num minor = sub(mul(a[i], b[j + 1]), mul(a[j + 1], b[i]));
            M[i * n + j] = i > 0 && j + 1 < n ? add(M[(i - 1) * n + j + 1], minor) : minor;
        }
}

/* Res(a, b) = a_0^n b_0^m prod (alpha_i - beta_j) over the roots, for degrees m and n, 1 <= m + n <= MAX_ORDER. */
KERNEL num G(resultant)(int m, const num a[], int n, const num b[])
{
    num M[MAX_ORDER * MAX_ORDER];
    G(sylvester)(m, a, n, b, M);
    return G(determinant)(m + n, M);
}

/* The same for equal degrees 1 <= n <= MAX_ORDER, from the smaller matrix:
 * Res(a, b) = (-1)^{n(n-1)/2} det of Bézout's matrix. */
KERNEL num G(bezout_resultant)(int n, const num a[], const num b[])
{
    num M[MAX_ORDER * MAX_ORDER];
    G(bezout)(n, a, b, M);
    num det = G(determinant)(n, M);
    return n * (n - 1) / 2 % 2 == 0 ? det : neg(det);
}

/* a[i] = C(n,i) w_i (R_i[axis] - x), i = 0, ..., n: the coefficients of u^n, ..., 1 that formula 3.4.2 gives
 * to one coordinate of the rational curve (R, w) of the plane, axis 0 or 1. */
KERNEL void G(implicit_coefficients)(int n, const num R[restrict], const num w[restrict], int axis, num x,
                                     num a[restrict])
{
    for (int i = 0; i <= n; i++)
        a[i] = mul(mul(from_int(binomial(n, i)), w[i]), sub(R[2 * i + axis], x));
}

/* F(x, y), the determinant (3.4.1) of the rational curve (R, w) of the plane, 1 <= n <= MAX_ORDER, from
 * Bézout's matrix. */
KERNEL num G(implicit_value)(int n, const num R[], const num w[], num x, num y)
{
    num a[MAX_ORDER + 1], b[MAX_ORDER + 1];
    G(implicit_coefficients)(n, R, w, 0, x, a);
    G(implicit_coefficients)(n, R, w, 1, y, b);
    return G(bezout_resultant)(n, a, b);
}
#include "core/number/generic_off.h"
