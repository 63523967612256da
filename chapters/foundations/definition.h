/* definition.h -- powers, polynomial curves in powers, and angles, straight from the definitions.
 *
 * The other side of this chapter's comparisons: no rule of Horner, no differences, no derivatives of kernels.
 * Generic text, for the sections of this chapter. */
#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

/* Coordinate j of sum_k c_k t^k, term by term. */
static inline num G(power_sum)(int n, int dim, const num c[], int j, num t)
{
    num sum = from_int(0);
    for (int k = 0; k <= n; k++)
        sum = add(sum, mul(c[k * dim + j], G(power)(t, k)));
    return sum;
}

/* Its r-th derivative: the sum of k (k-1) ... (k-r+1) c_k t^{k-r}. */
static inline num G(power_sum_derivative)(int n, int dim, const num c[], int j, int r, num t)
{
    num sum = from_int(0);
    for (int k = r; k <= n; k++) {
        num term = mul(c[k * dim + j], G(power)(t, k - r));
        for (int i = 0; i < r; i++)
            term = mul(term, from_int(k - i));
        sum = add(sum, term);
    }
    return sum;
}

/* (cos, sin) of the angle whose half has the tangent a. */
struct G(turn) {
    num cos, sin;
};
static inline struct G(turn) G(turn_by)(num a)
{
    num aa = mul(a, a), one = from_int(1), whole_square = add(one, aa);
    return (struct G(turn)){div(sub(one, aa), whole_square), div(add(a, a), whole_square)};
}
#include "chapters/judge/claims_off.h"
