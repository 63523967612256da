/* every.h -- sums for every n (对每个 n 的和式): a statement c sum_{k=low}^{n+d} F(n,k) = S(n) whose terms are products of binomial
 * coefficients, factorials, powers and rational functions, by creative telescoping (exact/decide/sums.h). */
#ifndef CAGD_EVERY_H
#define CAGD_EVERY_H

#include "exact/decide/sums.h"
#include "exact/expression/evaluate.h"

/* What proves it: sum_j a_j(n) F(n+j,k) = G(n,k+1) - G(n,k), G = R F, in the letters n and k of the statement, as texts; the recurrence
 * that the sum and S both satisfy, for every n from `from` on; the numbers before that are looked at one by one. */
typedef struct cagd_every {
    int order;
    long from;
    const char *n, *k, *a[CAGD_TELESCOPER_ORDER + 1], *R;
} cagd_every;

/* Whether it holds for every n >= the lower end of the range of n, the first `checked` of them being known; 1 and *out, or 0. */
int cagd_holds_for_every(const cagd_scope *scope, const cagd_tree *statement, const cagd_variable *n, long low,
                         int checked, cagd_every *out);
#endif
