/* bspline_matrix.tmpl.h -- the pieces of B-splines (B 样条) in powers: coefficient matrices (系数矩阵).
 *
 * The degree is p, the order k = p+1, 0 <= p, k < MAX_ORDER.  On the span mu, u[mu] < u[mu+1], the basis
 * functions that are not 0 are N_{mu-p}, ..., N_mu, polynomials of the parameter v of the span,
 *
 *     N_{mu-p+c}(t) = sum_{j=0}^p A[j k + c] v^j,   v = (t - u[mu]) / (u[mu+1] - u[mu]),
 *
 * so that row j of the k x k matrix A belongs to v^j and column c to the function mu-p+c (definition 4.4.1).
 * Of the knots (节点) only u[mu-p], ..., u[mu+p+1] are read, and A depends on the inner 2p of them.  The
 * span is not empty: that u[mu] and u[mu+1] differ is taken for granted.  Results do not overlap arguments.
 * Source: wang-ch4, 4.4; marsden-1970. */
#include "core/number/binomial.h"

#include "core/number/generic_on.h"

/* The matrix A by Cox and de Boor's recursion on polynomials of v: with t = u[mu] + v h and the function N of
 * degree q-1 that begins at u[i], its shares (t - u[i])/(u[i+q] - u[i]) N and (u[i+q] - t)/(u[i+q] - u[i]) N go to
 * the functions of degree q that begin at u[i] and at u[i-1].  i <= mu < i+q, so no denominator is 0. */
KERNEL void G(bspline_matrix)(int p, const num u[restrict], int mu, num A[restrict])
{
    int k = p + 1;
    num W[MAX_ORDER * MAX_ORDER], h = sub(u[mu + 1], u[mu]);
    A[0] = from_int(1);
    for (int q = 1; q <= p; q++) {
        for (int j = 0; j <= q; j++)
            for (int c = 0; c <= q; c++)
                W[j * k + c] = from_int(0);
        for (int c = 0; c < q; c++) {
            int i = mu - q + 1 + c;
            num length = sub(u[i + q], u[i]), slope = div(h, length);
            num rise = div(sub(u[mu], u[i]), length), fall = div(sub(u[i + q], u[mu]), length);
            for (int j = 0; j < q; j++) {
                num a = A[j * k + c];
                W[j * k + c + 1] = add(W[j * k + c + 1], mul(rise, a));
                W[(j + 1) * k + c + 1] = add(W[(j + 1) * k + c + 1], mul(slope, a));
                W[j * k + c] = add(W[j * k + c], mul(fall, a));
                W[(j + 1) * k + c] = sub(W[(j + 1) * k + c], mul(slope, a));
            }
        }
        for (int j = 0; j <= q; j++)
            for (int c = 0; c <= q; c++)
                A[j * k + c] = W[j * k + c];
    }
}

/* The p+1 coefficients a[0], ..., a[p] of N_i on the span mu, i <= mu <= i+p, by divided differences (theorem
 * 4.4.1): with the different knots tau_1, ..., tau_d of u[i], ..., u[i+k], their multiplicities and the weights
 * alpha of divided.tmpl.h,
 *     a_j = (u[i+k] - u[i]) (u[mu] - u[mu+1])^j sum alpha_{lm} p!/(j! (p-m-j)!) (tau_l - u[mu])^{p-m-j}
 * over the tau_l to the right of u[mu] and m <= p-j.  group[] says which knots coincide: group[a] = group[b] just
 * when u[a] = u[b], and group is nondecreasing. */
KERNEL void G(bspline_column_by_differences)(int p, const num u[restrict], const int group[restrict], int i, int mu,
                                             num a[restrict])
{
    int k = p + 1, d = 0, l[MAX_ORDER], right[MAX_ORDER];
    num tau[MAX_ORDER], alpha[MAX_ORDER], step = sub(u[mu], u[mu + 1]), scale = sub(u[i + k], u[i]);
    for (int m = i; m <= i + k; m++) {
        if (m == i || group[m] != group[m - 1]) {
            tau[d] = u[m];
            right[d] = group[m] > group[mu];
            l[d++] = 0;
        }
        l[d - 1]++;
    }
    G(divided_weights)(d, l, tau, alpha);
    for (int j = 0; j <= p; j++, scale = mul(scale, step)) {
        const num *weight = alpha;
        num sum = from_int(0);
        for (int q = 0; q < d; weight += l[q], q++) {
            if (!right[q])
                continue;
            /* Horner's rule in tau_q - u[mu]; falling = (p-j)!/(p-j-m)! */
            int last = l[q] - 1 < p - j ? l[q] - 1 : p - j;
            num gap = sub(tau[q], u[mu]), part = from_int(0), falling = from_int(1);
            for (int m = 0; m <= last; m++) {
                part = add(mul(part, gap), mul(falling, weight[m]));
                falling = mul(falling, from_int(p - j - m));
            }
            for (int m = last; m < p - j; m++)
                part = mul(part, gap);
            sum = add(sum, part);
        }
        a[j] = mul(mul(from_int(binomial(p, j)), scale), sum);
    }
}

/* The matrix A by divided differences, column by column (formulas 4.4.11 and 4.4.12). */
KERNEL void G(bspline_matrix_by_differences)(int p, const num u[restrict], const int group[restrict], int mu,
                                             num A[restrict])
{
    num a[MAX_ORDER];
    for (int c = 0; c <= p; c++) {
        G(bspline_column_by_differences)(p, u, group, mu - p + c, mu, a);
        for (int j = 0; j <= p; j++)
            A[j * (p + 1) + c] = a[j];
    }
}

/* w[c] = omega_{mu-p+c}(x), the product of x - u[i+1], ..., x - u[i+p] for i = mu-p+c (formula 4.4.14).  By
 * Marsden's identity (x - t)^p = sum omega_i(x) N_i(t) on the span mu. */
KERNEL void G(marsden_coefficients)(int p, const num u[restrict], int mu, num x, num w[restrict])
{
    for (int c = 0; c <= p; c++) {
        w[c] = from_int(1);
        for (int m = 1; m <= p; m++)
            w[c] = mul(w[c], sub(x, u[mu - p + c + m]));
    }
}

/* s[j] = the j-th elementary symmetric function (初等对称函数) of x[0], ..., x[n-1], j = 0, ..., n. */
KERNEL void G(elementary_symmetric)(int n, const num x[restrict], num s[restrict])
{
    s[0] = from_int(1);
    for (int m = 0; m < n; m++) {
        s[m + 1] = mul(s[m], x[m]);
        for (int j = m; j > 0; j--)
            s[j] = add(s[j], mul(s[j - 1], x[m]));
    }
}

/* The k x k matrix M, M[j k + c] = Sym_j(u[i+1], ..., u[i+p]) / C(p,j) with i = mu-p+c, so that
 * t^j = sum_c M[j k + c] N_{mu-p+c}(t) on the span (formulas 4.4.18, 4.4.19 and 4.4.22). */
KERNEL void G(marsden_matrix)(int p, const num u[restrict], int mu, num M[restrict])
{
    num s[MAX_ORDER];
    for (int c = 0; c <= p; c++) {
        G(elementary_symmetric)(p, u + mu - p + c + 1, s);
        for (int j = 0; j <= p; j++)
            M[j * (p + 1) + c] = div(s[j], from_int(binomial(p, j)));
    }
}

/* Its determinant: the product of u[b] - u[a] over all a <= mu < b with b - a <= p, divided by the product of all
 * C(p,j).  It is positive when the knots are nondecreasing and u[mu] < u[mu+1]. */
KERNEL num G(marsden_determinant)(int p, const num u[], int mu)
{
    num product = from_int(1);
    for (int a = mu - p + 1; a <= mu; a++)
        for (int b = mu + 1; b <= a + p; b++)
            product = mul(product, sub(u[b], u[a]));
    for (int j = 1; j < p; j++) /* C(p,0) and C(p,p) are 1 */
        product = div(product, from_int(binomial(p, j)));
    return product;
}

/* The cofactor (代数余子式) of place (row, column), counted from 0, of an n x n matrix M: (-1)^{row+column} times
 * the determinant of what is left without that row and column; 1 for n = 1. */
KERNEL num G(cofactor)(int n, const num M[], int row, int column)
{
    num rest[MAX_ORDER * MAX_ORDER];
    int m = 0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            if (i != row && j != column)
                rest[m++] = M[i * n + j];
    num minor = n > 1 ? G(determinant)(n - 1, rest) : from_int(1);
    return (row + column) % 2 == 0 ? minor : neg(minor);
}

/* The matrix A by Marsden's identity (theorem 4.4.3): with the cofactors g* of the matrix g of marsden_matrix,
 *     a_{jc} = (u[mu+1] - u[mu])^j / det g  sum_{m=j}^p C(m,j) u[mu]^{m-j} g*_{mc}. */
KERNEL void G(bspline_matrix_by_marsden)(int p, const num u[restrict], int mu, num A[restrict])
{
    int k = p + 1;
    num g[MAX_ORDER * MAX_ORDER], star[MAX_ORDER], h = sub(u[mu + 1], u[mu]), det = G(marsden_determinant)(p, u, mu);
    G(marsden_matrix)(p, u, mu, g);
    for (int c = 0; c <= p; c++) {
        num scale = div(from_int(1), det);
        for (int m = 0; m <= p; m++)
            star[m] = G(cofactor)(k, g, m, c);
        for (int j = 0; j <= p; j++, scale = mul(scale, h)) {
            num sum = from_int(0);
            for (int m = p; m >= j; m--)
                sum = add(mul(sum, u[mu]), mul(from_int(binomial(m, j)), star[m]));
            A[j * k + c] = mul(scale, sum);
        }
    }
}

/* The matrix A when u[mu+1], ..., u[mu+p+1] are all different (formula 4.4.23, its sign and exponent put right), whatever
 * the multiplicities up to u[mu]:
 *     a_{ji} = C(p,j) (u[i+k] - u[i]) (u[mu] - u[mu+1])^j sum_l (u[l] - u[mu])^{p-j} / prod_{m != l} (u[l] - u[m]),
 * the sum over l = mu+1, ..., i+k, the product over m = i, ..., i+k.  UNDEFINED when two of those to the
 * right of u[mu] are equal. */
KERNEL void G(bspline_matrix_simple)(int p, const num u[restrict], int mu, num A[restrict])
{
    int k = p + 1;
    num step = sub(u[mu], u[mu + 1]);
    for (int c = 0; c <= p; c++) {
        int i = mu - p + c;
        for (int j = 0; j <= p; j++)
            A[j * k + c] = from_int(0);
        for (int l = mu + 1; l <= i + k; l++) {
            num term = sub(u[i + k], u[i]), gap = sub(u[l], u[mu]);
            for (int m = i; m <= i + k; m++)
                if (m != l)
                    term = div(term, sub(u[l], u[m]));
            for (int j = p; j >= 0; j--, term = mul(term, gap))
                A[j * k + c] = add(A[j * k + c], term);
        }
        num power = from_int(1);
        for (int j = 0; j <= p; j++, power = mul(power, step))
            A[j * k + c] = mul(mul(from_int(binomial(p, j)), power), A[j * k + c]);
    }
}

/* The matrix A of equidistant knots (等距节点), the same on every span:
 *     a_{jc} = (-1)^j C(p,j) / p!  sum_{l=0}^c (-1)^l C(k,l) (c-l+1)^{p-j}. */
KERNEL void G(bspline_matrix_uniform)(int p, num A[])
{
    int k = p + 1;
    num factorial = from_int(1);
    for (int m = 2; m <= p; m++)
        factorial = mul(factorial, from_int(m));
    for (int j = 0; j <= p; j++)
        for (int c = 0; c <= p; c++) {
            num sum = from_int(0);
            for (int l = 0; l <= c; l++) {
                num term = from_int(l % 2 == 0 ? binomial(k, l) : -binomial(k, l));
                for (int m = 0; m < p - j; m++)
                    term = mul(term, from_int(c - l + 1));
                sum = add(sum, term);
            }
            sum = div(mul(from_int(binomial(p, j)), sum), factorial);
            A[j * k + c] = j % 2 == 0 ? sum : neg(sum);
        }
}

/* The matrix A of k knots 0 and k knots 1, of the Bernstein basis (Bernstein 基): a_{jc} = (-1)^{j+c} C(p,j) C(j,c),
 * 0 for j < c. */
KERNEL void G(bernstein_matrix)(int p, num A[])
{
    for (int j = 0; j <= p; j++)
        for (int c = 0; c <= p; c++) {
            long size = binomial(p, j) * binomial(j, c);
            A[j * (p + 1) + c] = from_int((j + c) % 2 == 0 ? size : -size);
        }
}
#include "core/number/generic_off.h"
