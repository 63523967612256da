/* bezier.tmpl.h -- Bézier curves (Bézier 曲线)   b(t) = sum_{i=0}^n B_i^n(t) b_i.
 *
 * 0 <= n <= MAX_DEGREE, 1 <= dim <= MAX_DIM, any t; coordinate c of point i is b[i*dim + c].  With
 * dim = 1 a curve is a polynomial in Bernstein form.  Results do not overlap arguments unless said.
 * Source: farin-2002, ch. 4 to 6. */
#include "core/number/binomial.h"

#include "core/number/generic_on.h"

/* One level of de Casteljau's triangle, in place: the n+1 points b become the n points
 * (1-t) b_i + t b_{i+1}.  The last point stays as it was. */
KERNEL void G(bezier_casteljau_level)(int n, int dim, num b[], num t)
{
    num s = sub(from_int(1), t);
    for (int m = 0; m < n * dim; m++)
        b[m] = add(mul(s, b[m]), mul(t, b[m + dim]));
}

/* out = b(t): b_i^0 = b_i, b_i^k = (1-t) b_i^{k-1} + t b_{i+1}^{k-1}, b(t) = b_0^n.  out may overlap b. */
KERNEL void G(bezier_casteljau)(int n, int dim, const num b[], num t, num out[])
{
    num w[(MAX_DEGREE + 1) * MAX_DIM];
    for (int m = 0; m < (n + 1) * dim; m++)
        w[m] = b[m];
    for (int k = n; k > 0; k--)
        G(bezier_casteljau_level)(k, dim, w, t);
    for (int c = 0; c < dim; c++)
        out[c] = w[c];
}

/* out = b(t) in O(n) operations, without division, for every t:
 *     b(t) = (...((1-t) b_0 + C(n,1) t b_1)(1-t) + ...)(1-t) + C(n,n) t^n b_n. */
KERNEL void G(bezier_horner)(int n, int dim, const num b[restrict], num t, num out[restrict])
{
    num s = sub(from_int(1), t), power = from_int(1);
    long choose = 1;
    for (int c = 0; c < dim; c++)
        out[c] = b[c];
    for (int i = 1; i <= n; i++) {
        choose = next_binomial(n, i, choose);
        power = mul(power, t);
        num factor = mul(from_int(choose), power);
        for (int c = 0; c < dim; c++)
            out[c] = add(mul(out[c], s), mul(factor, b[i * dim + c]));
    }
}

/* The hodograph (速端曲线), in place: the n+1 points b become the n points n (b_{i+1} - b_i) of b'.
 * The last point stays as it was; nothing happens for n <= 0. */
KERNEL void G(bezier_hodograph)(int n, int dim, num b[])
{
    for (int m = 0; m < n * dim; m++)
        b[m] = mul(from_int(n), sub(b[m + dim], b[m]));
}

/* The n-r+1 points n!/(n-r)! Delta^r b_i of the r-th derivative curve, 0 <= r <= n.  out may overlap b. */
KERNEL void G(bezier_differences)(int n, int dim, const num b[], int r, num out[])
{
    num w[(MAX_DEGREE + 1) * MAX_DIM];
    for (int m = 0; m < (n + 1) * dim; m++)
        w[m] = b[m];
    for (int k = 0; k < r; k++)
        G(bezier_hodograph)(n - k, dim, w);
    for (int m = 0; m < (n - r + 1) * dim; m++)
        out[m] = w[m];
}

/* Row k of out is the k-th derivative of b at t: out[k*dim + c], k = 0, ..., r; zero for k > n. */
KERNEL void G(bezier_derivatives)(int n, int dim, const num b[restrict], num t, int r, num out[restrict])
{
    num w[(MAX_DEGREE + 1) * MAX_DIM];
    for (int m = 0; m < (n + 1) * dim; m++)
        w[m] = b[m];
    for (int k = 0; k <= r && k <= n; k++) {
        G(bezier_casteljau)(n - k, dim, w, t, out + k * dim);
        G(bezier_hodograph)(n - k, dim, w);
    }
    for (int m = (n + 1) * dim; m < (r + 1) * dim; m++)
        out[m] = from_int(0);
}

/* The same curve over [0,t] and over [t,1], each again over the unit interval, n+1 points each:
 *     left_k = b_0^k,   right_i = b_i^{n-i}     in de Casteljau's triangle at t. */
KERNEL void G(bezier_split)(int n, int dim, const num b[restrict], num t, num left[restrict], num right[restrict])
{
    for (int m = 0; m < (n + 1) * dim; m++)
        right[m] = b[m];
    for (int k = 0; k <= n; k++) {
        for (int c = 0; c < dim; c++)
            left[k * dim + c] = right[c];
        G(bezier_casteljau_level)(n - k, dim, right, t);
    }
}

/* The n+2 points of the same curve in degree n+1: e_i = i/(n+1) b_{i-1} + (1 - i/(n+1)) b_i. */
KERNEL void G(bezier_elevate)(int n, int dim, const num b[restrict], num e[restrict])
{
    for (int c = 0; c < dim; c++) {
        e[c] = b[c];
        e[(n + 1) * dim + c] = b[n * dim + c];
    }
    for (int i = 1; i <= n; i++) {
        num a = from_ratio(i, n + 1), a1 = from_ratio(n + 1 - i, n + 1);
        for (int c = 0; c < dim; c++)
            e[i * dim + c] = add(mul(a, b[(i - 1) * dim + c]), mul(a1, b[i * dim + c]));
    }
}

/* The inverse of elevation: the n points b, in degree n-1 >= 0, of a curve e_0, ..., e_n that is of this degree.  The
 * equations e_i = i/n b_{i-1} + (1 - i/n) b_i are solved from both ends; defect[dim] is what the one in the
 * middle, which is not used, lacks.  The curve is of degree n-1 if and only if defect = 0. */
KERNEL void G(bezier_reduce)(int n, int dim, const num e[restrict], num b[restrict], num defect[restrict])
{
    int middle = n / 2;
    for (int c = 0; c < dim; c++) {
        for (int i = 0; i < middle; i++) {
            num known = i > 0 ? mul(from_int(i), b[(i - 1) * dim + c]) : from_int(0);
            b[i * dim + c] = div(sub(mul(from_int(n), e[i * dim + c]), known), from_int(n - i));
        }
        for (int i = n; i > middle; i--) {
            num known = i < n ? mul(from_int(n - i), b[i * dim + c]) : from_int(0);
            b[(i - 1) * dim + c] = div(sub(mul(from_int(n), e[i * dim + c]), known), from_int(i));
        }
        num left = middle > 0 ? mul(from_ratio(middle, n), b[(middle - 1) * dim + c]) : from_int(0);
        num right = mul(from_ratio(n - middle, n), b[middle * dim + c]);
        defect[c] = sub(e[middle * dim + c], add(left, right));
    }
}

/* The polar form (blossom, 极形式) b[u_1, ..., u_n]: symmetric, affine in each argument, and
 * b[t, ..., t] = b(t).  Level k of the triangle is taken at u[k-1].  out may overlap b. */
KERNEL void G(bezier_blossom)(int n, int dim, const num b[], const num u[], num out[])
{
    num w[(MAX_DEGREE + 1) * MAX_DIM];
    for (int m = 0; m < (n + 1) * dim; m++)
        w[m] = b[m];
    for (int k = n; k > 0; k--)
        G(bezier_casteljau_level)(k, dim, w, u[n - k]);
    for (int c = 0; c < dim; c++)
        out[c] = w[c];
}

/* The n+1 points of the curve from u to v, over the unit interval: point i is b[u, ..., u, v, ..., v]
 * with i arguments v.  Any u and v, in any order. */
KERNEL void G(bezier_on_interval)(int n, int dim, const num b[restrict], num u, num v, num out[restrict])
{
    num x[MAX_DEGREE];
    for (int i = 0; i <= n; i++) {
        for (int k = 0; k < n; k++)
            x[k] = k < i ? v : u;
        G(bezier_blossom)(n, dim, b, x, out + i * dim);
    }
}

/* A polynomial with Bernstein coefficients f over [a,b] has the coefficients g over [c,d].
 * UNDEFINED for a = b. */
KERNEL void G(bernstein_on_interval)(int n, num a, num b, const num f[restrict], num c, num d, num g[restrict])
{
    num length = sub(b, a);
    G(bezier_on_interval)(n, 1, f, div(sub(c, a), length), div(sub(d, a), length), g);
}
#include "core/number/generic_off.h"
