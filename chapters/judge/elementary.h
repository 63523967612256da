/* elementary.h -- factorials, falling ones, binomial coefficients and powers straight from the definitions, and a comparison with 0.
 *
 * For the other side of the chapters' comparisons: nothing here follows the kernels or uses their binomial coefficients;
 * nothing is fast.  And points of which every coordinate is free, and polygons backwards.  Generic text; a section includes
 * it for its one number type. */
#ifndef CAGD_ELEMENTARY_H
#define CAGD_ELEMENTARY_H

#include "chapters/judge/claims_on.h"

static inline num G(factorial)(int n)
{
    num product = from_int(1);
    for (int k = 2; k <= n; k++)
        product = mul(product, from_int(k));
    return product;
}

/* n (n-1) ... (n-k+1); n <= 20 */
static inline long G(falling_factorial)(int n, int k) { return k == 0 ? 1 : n * G(falling_factorial)(n - 1, k - 1); }

/* n!/(i! (n-i)!), and 0 for i < 0 and i > n */
static inline num G(choose)(int n, int i)
{
    if (i < 0 || i > n)
        return from_int(0);
    return div(G(factorial)(n), mul(G(factorial)(i), G(factorial)(n - i)));
}

static inline num G(power)(num a, int k)
{
    num product = from_int(1);
    for (; k > 0; k--)
        product = mul(product, a);
    return product;
}

/* n+1 points of dim <= 3 coordinates, every one free: R[k*dim + j] is coordinate j of R_k. */
static inline void G(free_points)(trial *T, int n, int dim, num R[])
{
    static const char *const name[] = {"x", "y", "z"};
    for (int k = 0; k <= n; k++)
        for (int j = 0; j < dim; j++)
            R[k * dim + j] = unknown(T, name[j], k);
}

/* The polygon of n+1 points of dim coordinates backwards: R_i = P_{n-i}.  No overlap. */
static inline void G(reversed_points)(int n, int dim, const num P[], num R[])
{
    for (int i = 0; i <= n; i++)
        for (int c = 0; c < dim; c++)
            R[i * dim + c] = P[(n - i) * dim + c];
}

/* Compare: a > 0.  In the field: not 0, and all coefficients of one sign, the variables being positive.  The inexact types
 * refute only. */
static inline void G(must_be_positive)(trial *T, num a)
{
    nonnegative(T, a);
#if FIELD
    agree(T, !is_zero_f(a));
#elif RATIONAL
    agree(T, !is_zero_q(a));
#elif INTERVAL
    agree(T, upper_i(a) > 0);
#else
    agree(T, a.v + error_bound_m(a) > 0);
#endif
}
#include "chapters/judge/claims_off.h"
#endif
