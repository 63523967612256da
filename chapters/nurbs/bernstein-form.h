/* bernstein-form.h -- the Bernstein form by the binomial theorem: the other side of claims about Bézier segments. */
#include "chapters/judge/claims_on.h"

/* C(n,i) as a product of fractions; 0 for i < 0 and i > n. */
static inline num G(binomial_product)(int n, int i)
{
    num product = from_int(i >= 0 && i <= n);
    for (int k = 1; k <= i; k++)
        product = mul(product, from_ratio(n + 1 - k, k));
    return product;
}

/* The coefficient of t^r in B_i^p = C(p,i) t^i (1-t)^{p-i}. */
static inline num G(bernstein_coefficient)(int p, int i, int r)
{
    num size = mul(G(binomial_product)(p, i), G(binomial_product)(p - i, r - i));
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

/* a^k */
static inline num G(power_of)(num a, int k)
{
    num product = from_int(1);
    for (; k > 0; k--)
        product = mul(product, a);
    return product;
}
#include "chapters/judge/claims_off.h"
