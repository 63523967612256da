/* bernstein.tmpl.h -- the Bernstein basis (Bernstein 基) and polynomials written in it.
 *
 *     B_i^n(t) = C(n,i) (1-t)^{n-i} t^i,   i = 0, ..., n,   0 <= n <= MAX_DEGREE,   any t.
 *
 * A polynomial of degree n is an array of its n+1 coefficients.
 * Source: farin-2002, ch. 5 and 6. */
#include "core/number/binomial.h"

#include "core/number/generic_on.h"

/* B[i] = B_i^n(t), i = 0, ..., n, by B_i^k = (1-t) B_i^{k-1} + t B_{i-1}^{k-1}. */
KERNEL void G(bernstein_basis)(int n, num t, num B[])
{
    num s = sub(from_int(1), t);
    B[0] = from_int(1);
    for (int k = 1; k <= n; k++) {
        num carry = from_int(0);
        for (int i = 0; i < k; i++) {
            num b = B[i];
            B[i] = add(mul(s, b), carry);
            carry = mul(t, b);
        }
        B[k] = carry;
    }
}

/* Row k of B is the k-th derivative of the basis at t: B[k(n+1) + i] = (d/dt)^k B_i^n(t), k = 0, ..., r;
 * zero for k > n.  Source: the k-fold use of (B_i^m)' = m (B_{i-1}^{m-1} - B_i^{m-1}), from m = n-k+1 to n. */
KERNEL void G(bernstein_derivatives)(int n, num t, int r, num B[])
{
    for (int k = 0; k <= r; k++) {
        num *row = B + k * (n + 1);
        for (int i = 0; i <= n; i++)
            row[i] = from_int(0);
        if (k > n)
            continue;
        G(bernstein_basis)(n - k, t, row);
        for (int m = n - k + 1; m <= n; m++) {
            row[m] = mul(from_int(m), row[m - 1]);
            for (int i = m - 1; i > 0; i--)
                row[i] = mul(from_int(m), sub(row[i - 1], row[i]));
            row[0] = mul(from_int(-m), row[0]);
        }
    }
}

/* The n+m+1 coefficients c of the product of a (degree n) and b (degree m), n + m <= MAX_DEGREE:
 *     c_k = sum_{i+j=k} C(n,i) C(m,j) / C(n+m,k) a_i b_j.
 * a and b may be the same; c overlaps neither. */
KERNEL void G(bernstein_product)(int n, const num a[], int m, const num b[], num c[])
{
    for (int k = 0; k <= n + m; k++)
        c[k] = from_int(0);
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= m; j++) {
            num share = from_ratio(binomial(n, i) * binomial(m, j), binomial(n + m, i + j));
            c[i + j] = add(c[i + j], mul(share, mul(a[i], b[j])));
        }
}

/* The (n+2) x (n+1) matrix of degree elevation, row by row: e = E b with
 *     E_{i,i-1} = i/(n+1),   E_{i,i} = 1 - i/(n+1),   0 elsewhere. */
KERNEL void G(bernstein_elevation_matrix)(int n, num E[])
{
    for (int i = 0; i <= n + 1; i++)
        for (int j = 0; j <= n; j++) {
            int share = j == i - 1 ? i : j == i ? n + 1 - i : 0;
            E[i * (n + 1) + j] = from_ratio(share, n + 1);
        }
}

/* sum b_i B_i^n(t) = sum c_k t^k with c_k = C(n,k) times the k-th forward difference of b at 0.
 * c may be b. */
KERNEL void G(bernstein_to_power)(int n, const num b[], num c[])
{
    for (int i = 0; i <= n; i++)
        c[i] = b[i];
    for (int k = 1; k <= n; k++)
        for (int i = n; i >= k; i--)
            c[i] = sub(c[i], c[i - 1]);
    for (int k = 0; k <= n; k++)
        c[k] = mul(from_int(binomial(n, k)), c[k]);
}

/* The inverse of bernstein_to_power: b_i = sum_{k<=i} C(i,k)/C(n,k) c_k.  b may be c. */
KERNEL void G(bernstein_from_power)(int n, const num c[], num b[])
{
    for (int k = 0; k <= n; k++)
        b[k] = div(c[k], from_int(binomial(n, k)));
    for (int k = n; k >= 1; k--)
        for (int i = k; i <= n; i++)
            b[i] = add(b[i], b[i - 1]);
}
#include "core/number/generic_off.h"
