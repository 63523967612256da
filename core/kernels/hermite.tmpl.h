/* hermite.tmpl.h -- polynomials with given values and derivatives (Hermite 插值).
 *
 * Curves: 1 <= dim <= MAX_DIM; coordinate c of datum i is data[i*dim + c].  Results do not overlap arguments.
 * Source: slides-ch4, sections 2 and 3. */
#include "core/number/limits.h"

#include "core/number/generic_on.h"

/* Row k of B has the derivatives of order k at t, k = 0, ..., r, of the four cubics over [t0, t1] (混合函数)
 *     g_0 = 1 at t0,   g_1 = 1 at t1,   h_0' = 1 at t0,   h_1' = 1 at t1,
 * all other values and first derivatives at t0 and t1 being 0: with u = (t - t0)/(t1 - t0)
 *     g_0 = 1 - 3u^2 + 2u^3,  g_1 = 3u^2 - 2u^3,  h_0 = (t1 - t0)(u - 2u^2 + u^3),  h_1 = (t1 - t0)(u^3 - u^2).
 * B[4k], ..., B[4k+3] in this order; zero for k > 3; any t.  UNDEFINED for t0 = t1. */
KERNEL void G(hermite_blending)(num t0, num t1, num t, int r, num B[])
{
    static const int power[4][4] = {{1, 0, -3, 2}, {0, 0, 3, -2}, {0, 1, -2, 1}, {0, 0, -1, 1}};
    num length = sub(t1, t0), u = div(sub(t, t0), length), scale = from_int(1);
    for (int k = 0; k <= r; k++) {
        for (int i = 0; i < 4; i++) {
            num sum = from_int(0);
            for (int j = 3; j >= k; j--) { /* Horner's rule for the derivative with respect to u */
                int falling = 1;
                for (int m = 0; m < k; m++)
                    falling *= j - m;
                sum = add(mul(sum, u), from_int(falling * power[i][j]));
            }
            B[4 * k + i] = div(i < 2 ? sum : mul(length, sum), scale);
        }
        scale = mul(scale, length);
    }
}

/* Row k of out is the derivative of order k at t, k = 0, ..., r, r <= MAX_DEGREE, of the cubic curve over [t0, t1] with the data
 *     P(t0), P(t1), P'(t0), P'(t1)
 * in this order.  UNDEFINED for t0 = t1. */
KERNEL void G(hermite_cubic)(int dim, num t0, num t1, const num data[restrict], num t, int r, num out[restrict])
{
    num B[4 * (MAX_DEGREE + 1)];
    G(hermite_blending)(t0, t1, t, r, B);
    for (int k = 0; k <= r; k++)
        for (int c = 0; c < dim; c++) {
            num sum = from_int(0);
            for (int i = 0; i < 4; i++)
                sum = add(sum, mul(B[4 * k + i], data[i * dim + c]));
            out[k * dim + c] = sum;
        }
}

/* g[i] = prod_{j != i} (t - tau_j)/(tau_i - tau_j), i = 0, ..., n: the polynomials of degree n that are 1 at one of
 * n+1 nodes and 0 at the others (Lagrange 混合函数).  UNDEFINED when two nodes are equal. */
KERNEL void G(lagrange_blending)(int n, const num tau[restrict], num t, num g[restrict])
{
    for (int i = 0; i <= n; i++) {
        num product = from_int(1);
        for (int j = 0; j <= n; j++)
            if (j != i)
                product = mul(product, div(sub(t, tau[j]), sub(tau[i], tau[j])));
        g[i] = product;
    }
}

/* The coefficients c[0], ..., c[N] in powers of t of the one polynomial of degree <= N with
 *     P^(j)(tau_i) = f[l_0 + ... + l_{i-1} + j],   0 <= j < l[i],   i = 0, ..., d-1,
 * where N+1 = l[0] + ... + l[d-1] <= MAX_ORDER and all l[i] >= 1: nodes and places as in divided.tmpl.h.
 * By the table of divided differences and Newton's form.  UNDEFINED when two of the tau are equal. */
KERNEL void G(hermite_interpolant)(int d, const int l[], const num tau[restrict], const num f[restrict],
                                   num c[restrict])
{
    num D[MAX_ORDER], factorial = from_int(1);
    int node[MAX_ORDER], first[MAX_ORDER], count = 0;
    for (int i = 0; i < d; i++) {
        first[i] = count;
        for (int j = 0; j < l[i]; j++)
            node[count++] = i;
    }
    for (int m = 0; m < count; m++)
        D[m] = f[first[node[m]]];
    for (int s = 1; s < count; s++) { /* D_m becomes the difference over nodes m-s, ..., m, for m >= s */
        factorial = mul(factorial, from_int(s));
        for (int m = count - 1; m >= s; m--) {
            int a = node[m - s], b = node[m];
            D[m] = a == b ? div(f[first[a] + s], factorial) : div(sub(D[m], D[m - 1]), sub(tau[b], tau[a]));
        }
    }
    for (int m = count - 1; m >= 0; m--) { /* c becomes c (t - tau) + D_m */
        for (int k = count - 1 - m; k > 0; k--)
            c[k] = k == count - 1 - m ? c[k - 1] : sub(c[k - 1], mul(tau[node[m]], c[k]));
        c[0] = m == count - 1 ? D[m] : sub(D[m], mul(tau[node[m]], c[0]));
    }
}
#include "core/number/generic_off.h"
