/* binomial.h -- binomial coefficients as machine integers. */
#ifndef CAGD_BINOMIAL_H
#define CAGD_BINOMIAL_H

#include "core/number/limits.h"

/* C(n, i) for 0 <= n <= MAX_DEGREE, and 0 for i < 0 or i > n.  Pascal's rule: no product overflows. */
static inline long binomial(int n, int i)
{
    long row[MAX_DEGREE + 1] = {1};
    if (i < 0 || i > n)
        return 0;
    for (int m = 1; m <= n; m++)
        for (int k = m < i ? m : i; k > 0; k--)
            row[k] += row[k - 1];
    return row[i];
}
#endif
