/* induction.h -- sums and products to n as variables of their own (不定和), and equalities between them by induction.
 *
 * S(n) = sum f(k) over k = low, ..., n, f free of n, satisfies S(n+1) = S(n) + f(n+1), and a product S(n+1) = S(n) f(n+1); f may have such
 * sums in it, as the harmonic numbers in sum H_k.  A difference E of two sides is a rational function of n and these variables; so is
 * E(n+1), and if that is r(n) E(n) with r defined for every n, then E is 0 for every n where it is for the first one.  Source: karr-1981,
 * of whose difference fields these are the simplest. */
#ifndef CAGD_INDUCTION_H
#define CAGD_INDUCTION_H

#include "exact/expression/closed.h"

/* A sum or product over k = low, ..., p n + c of what depends on n by k alone; 0 where it is none. */
int cagd_sum_to_n(cagd_search *s, const cagd_tree *t, const cagd_frame *f, cagd_num_f *out);
/* Whether *N, the numerator of E with ((-1)^n)^2 = 1, satisfies N(n+1) = r N(n) by what is known of the variables, r being defined for every n >=
 * s->from, as E is. */
int cagd_vanishes_by_induction(const cagd_search *s, cagd_num_f E, cagd_num_f *N, cagd_num_f *r);
#endif
