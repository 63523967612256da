/* determinants.h -- determinants and polynomials straight from their definitions.
 *
 * For the other side of the comparisons with the kernels; nothing is fast.  Generic text; a section includes it for its one
 * number type. */
#ifndef CAGD_RATIONAL_BEZIER_DETERMINANTS_H
#define CAGD_RATIONAL_BEZIER_DETERMINANTS_H

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

/* Leibniz' sum over the permutations of the rows i, ..., n-1 of the n x n matrix M into the columns that are not in the set
 * `used` of bits; the determinant is that of i = 0 and used = 0.  n <= 31. */
static inline num G(leibniz)(int n, const num M[], int i, unsigned used)
{
    if (i == n)
        return from_int(1);
    num sum = from_int(0);
    int before = 0; /* free columns to the left of j: as many exchanges */
    for (int j = 0; j < n; j++)
        if (!(used >> j & 1)) {
            num term = mul(M[i * n + j], G(leibniz)(n, M, i + 1, used | 1u << j));
            sum = before++ % 2 == 0 ? add(sum, term) : sub(sum, term);
        }
    return sum;
}

/* a_0 z^n + a_1 z^{n-1} + ... + a_n */
static inline num G(horner)(int n, const num a[], num z)
{
    num sum = a[0];
    for (int i = 1; i <= n; i++)
        sum = add(mul(sum, z), a[i]);
    return sum;
}

/* sum C(n,i) p_i u^{n-i} */
static inline num G(in_u)(int n, const num p[], num u)
{
    num sum = from_int(0);
    for (int i = 0; i <= n; i++)
        sum = add(sum, mul(mul(from_int(binomial(n, i)), p[i]), G(power)(u, n - i)));
    return sum;
}
#include "chapters/judge/claims_off.h"
#endif
