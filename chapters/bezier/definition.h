/* definition.h -- Bernstein polynomials and Bézier curves, straight from the definitions.
 *
 * The other side of this chapter's comparisons.  Nothing here follows a recurrence of the kernels, or
 * uses their binomial coefficients; nothing is fast.  Generic text, for the sections of this chapter. */
#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

/* B_i^n(t) = C(n,i) (1-t)^{n-i} t^i */
static inline num G(basis)(int n, int i, num t)
{
    if (i < 0 || i > n)
        return from_int(0);
    return mul(G(choose)(n, i), mul(G(power)(sub(from_int(1), t), n - i), G(power)(t, i)));
}

/* Coordinate c of the curve at t: the sum of b_i B_i^n(t). */
static inline num G(curve)(int n, int dim, const num b[], int c, num t)
{
    num sum = from_int(0);
    for (int i = 0; i <= n; i++)
        sum = add(sum, mul(b[i * dim + c], G(basis)(n, i, t)));
    return sum;
}

/* The coefficient of t^k in B_i^n: the binomial theorem for (1-t)^{n-i}. */
static inline num G(basis_coefficient)(int n, int i, int k)
{
    num size = mul(G(choose)(n, i), G(choose)(n - i, k - i));
    return (k - i) % 2 == 0 ? size : neg(size);
}

/* The r-th derivative of B_i^n at t: in the field by differentiating the rational function, in the other
 * types power by power. */
static inline num G(basis_derivative)(int n, int i, int r, num t)
{
#if FIELD
    num at = variable_f("t"), D = G(basis)(n, i, at);
    for (int k = 0; k < r; k++)
        D = derivative_f(D, at);
    return substitute_f(D, at, t);
#else
    num sum = from_int(0);
    for (int k = r; k <= n; k++) {
        num factor = from_int(G(falling_factorial)(k, r));
        sum = add(sum, mul(mul(G(basis_coefficient)(n, i, k), factor), G(power)(t, k - r)));
    }
    return sum;
#endif
}

/* The r-th derivative of coordinate c of the curve at t. */
static inline num G(curve_derivative)(int n, int dim, const num b[], int c, int r, num t)
{
    num sum = from_int(0);
    for (int i = 0; i <= n; i++)
        sum = add(sum, mul(b[i * dim + c], G(basis_derivative)(n, i, r, t)));
    return sum;
}

/* The r-th forward difference of coordinate c at point i: the alternating sum. */
static inline num G(difference)(int dim, const num b[], int c, int i, int r)
{
    num sum = from_int(0);
    for (int k = 0; k <= r; k++) {
        num term = mul(G(choose)(r, k), b[(i + k) * dim + c]);
        sum = (r - k) % 2 == 0 ? add(sum, term) : sub(sum, term);
    }
    return sum;
}
#include "chapters/judge/claims_off.h"
