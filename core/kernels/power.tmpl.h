/* power.tmpl.h -- polynomial curves in powers of the parameter (幂基曲线)   P(t) = sum_{k=0}^n c_k t^k.
 *
 * 0 <= n <= MAX_DEGREE, 1 <= dim <= MAX_DIM, any t; coordinate j of c_k is c[k*dim + j], the constant c_0 first.
 * Results do not overlap arguments unless said.
 * Source: hu-1987, 1-4 and 1-5. */
#include "core/number/limits.h"

#include "core/number/generic_on.h"

/* out = P(t) by Horner's rule (...(c_n t + c_{n-1}) t + ...) t + c_0 (formula 1-4-2): n multiplications and n
 * additions for each coordinate. */
KERNEL void G(power_point)(int n, int dim, const num c[restrict], num t, num out[restrict])
{
    for (int j = 0; j < dim; j++) {
        out[j] = c[n * dim + j];
        for (int k = n - 1; k >= 0; k--)
            out[j] = add(mul(out[j], t), c[k * dim + j]);
    }
}

/* The n coefficients k c_k of P', in place; the last one is left as it was.  Nothing happens for n = 0. */
KERNEL void G(power_hodograph)(int n, int dim, num c[])
{
    for (int k = 0; k < n; k++)
        for (int j = 0; j < dim; j++)
            c[k * dim + j] = mul(from_int(k + 1), c[(k + 1) * dim + j]);
}

/* Row k of out is the k-th derivative of P at t: out[k*dim + j], k = 0, ..., r; zero for k > n. */
KERNEL void G(power_derivatives)(int n, int dim, const num c[restrict], num t, int r, num out[restrict])
{
    num w[(MAX_DEGREE + 1) * MAX_DIM];
    for (int m = 0; m < (n + 1) * dim; m++)
        w[m] = c[m];
    for (int k = 0; k <= r && k <= n; k++) {
        G(power_point)(n - k, dim, w, t, out + k * dim);
        G(power_hodograph)(n - k, dim, w);
    }
    for (int m = (n + 1) * dim; m < (r + 1) * dim; m++)
        out[m] = from_int(0);
}

/* Row k of d is the forward difference (向前差分) of order k at 0 with the step delta, k = 0, ..., n:
 *     d_0 = P(0),   d_k = sum_{i=0}^k (-1)^{k-i} C(k,i) P(i delta). */
KERNEL void G(power_differences)(int n, int dim, const num c[restrict], num delta, num d[restrict])
{
    for (int i = 0; i <= n; i++)
        G(power_point)(n, dim, c, mul(from_int(i), delta), d + i * dim);
    for (int k = 1; k <= n; k++)
        for (int m = (n + 1) * dim - 1; m >= k * dim; m--)
            d[m] = sub(d[m], d[m - dim]);
}

/* One step of the parameter, in place, by n additions for each coordinate (formula 1-4-3): the differences at t
 * become those at t + delta, d_k + d_{k+1} for k < n. */
KERNEL void G(power_difference_step)(int n, int dim, num d[])
{
    for (int m = 0; m < n * dim; m++)
        d[m] = add(d[m], d[m + dim]);
}

/* The same step for the differences divided by powers of the step, e_k = d_k / delta^k (formula 1-4-4): e_k becomes
 * e_k + delta e_{k+1} for k < n. */
KERNEL void G(power_scaled_difference_step)(int n, int dim, num delta, num e[])
{
    for (int m = 0; m < n * dim; m++)
        e[m] = add(e[m], mul(delta, e[m + dim]));
}

/* The n+1 coefficients out of the piece from u to v as a curve over the unit interval, P(u + (v - u) t) in powers of
 * t (formula 1-5-5 for n = 3).  Any u and v; a point for u = v. */
KERNEL void G(power_on_interval)(int n, int dim, const num c[restrict], num u, num v, num out[restrict])
{
    num h = sub(v, u), scale = from_int(1);
    for (int m = 0; m < (n + 1) * dim; m++)
        out[m] = c[m];
    for (int k = 0; k < n; k++) /* repeated synthetic division by t - u: Taylor's coefficients at u */
        for (int i = n - 1; i >= k; i--)
            for (int j = 0; j < dim; j++)
                out[i * dim + j] = add(out[i * dim + j], mul(u, out[(i + 1) * dim + j]));
    for (int k = 1; k <= n; k++) {
        scale = mul(scale, h);
        for (int j = 0; j < dim; j++)
            out[k * dim + j] = mul(scale, out[k * dim + j]);
    }
}
#include "core/number/generic_off.h"
