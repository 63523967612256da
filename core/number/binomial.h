/* binomial.h -- binomial coefficients as machine integers. */
#ifndef CAGD_BINOMIAL_H
#define CAGD_BINOMIAL_H

#include "core/number/limits.h"

/* C(n, i) from c = C(n, i-1), for 1 <= i <= n <= MAX_DEGREE: c (n-i+1)/i.  With c = q i + r the
 * quotient is q (n-i+1) + r (n-i+1)/i, and neither product overflows. */
static inline long next_binomial(int n, int i, long c) { return c / i * (n - i + 1) + c % i * (n - i + 1) / i; }

/* C(n, i) for 0 <= n <= MAX_DEGREE, and 0 for i < 0 or i > n. */
static inline long binomial(int n, int i)
{
    long c = i >= 0 && i <= n;
    for (int k = 1; k <= i && c != 0; k++)
        c = next_binomial(n, k, c);
    return c;
}
#endif
