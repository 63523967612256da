/* similar.h -- equalities for every choice of several whole numbers, as of n and k with 0 <= k <= n: B_i^n = (1-t) B_i^{n-1} + t B_{i-1}^{n-1}.
 *
 * Two terms are similar (相似项) if their quotient is a rational function of the numbers.  C(N,K), N! and b^N whose N and K differ by whole numbers are:
 * with one of each kind as a variable w of the field each side is a rational function of the numbers, the names and these
 * variables, and where those functions are equal, so are the sides.  All rewriting is by
 *
 *     C(N,K) = (K+1)/(N+1) C(N+1,K+1) = (N+1-K)/(N+1) C(N+1,K),   N >= 0, K any whole number,
 *     (N+1)! = (N+1) N!,  N >= 0;   b^(N+1) = b b^N,
 *
 * or, where 0 <= K <= N, with C(N,K) = N!/(K! (N-K)!).  A derivative by a name is one by what stands in the bases: (b^N)' = N b'/b b^N.
 * That N >= 0, and that no divisor is 0, is read off the ranges, whose ends are linear in the numbers before.
 * Source: petkovsek-wilf-zeilberger-1996, 5.6. */
#ifndef CAGD_SIMILAR_H
#define CAGD_SIMILAR_H

#include "exact/expression/every.h"

/* Whether the equality, the chain of them, or each of several, holds for every choice of the whole numbers of list[]; the range of one may depend on those
 * before it; conditions of the scope are not needed.  1 and out->similar with what was rewritten, or 0. */
int cagd_holds_for_every_choice(const cagd_scope *scope, const cagd_tree *statement, const cagd_variable *const list[],
                                int count, cagd_every *out);
#endif
