/* bernstein-form.h -- the Bernstein form by the binomial theorem: the other side of claims about Bézier segments. */
#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

/* The coefficient of t^r in B_i^p = C(p,i) t^i (1-t)^{p-i}. */
static inline num G(bernstein_coefficient)(int p, int i, int r)
{
    num size = mul(G(choose)(p, i), G(choose)(p - i, r - i));
    return (r - i) % 2 == 0 ? size : neg(size);
}

/* The coefficient of t^r, for t in [0,1], of coordinate c of the Bézier curve of the points b. */
static inline num G(bezier_coefficient)(int p, int dim, const num b[], int c, int r)
{
    num sum = from_int(0);
    for (int i = 0; i <= r; i++)
        sum = add(sum, mul(b[i * dim + c], G(bernstein_coefficient)(p, i, r)));
    return sum;
}

#include "chapters/judge/claims_off.h"
