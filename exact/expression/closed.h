/* closed.h -- values with n a variable (n 为变量的值): powers with n in the exponent and factorials of n are variables of their own, and a sum
 * whose terms are F(k) = (G(k+1) - G(k))/a is (G(high+1) - G(low))/a, G = R F (Gosper).
 *
 * An identity between such values is one for every n from some n on, if nothing by which is divided is 0 for any of these: the variables
 * w = b^n and w = (p n)! are put in the place of what they stand for.  Sources: those of exact/decide/sums.h. */
#ifndef CAGD_CLOSED_H
#define CAGD_CLOSED_H

#include "exact/expression/terms.h"

/* The variable for a growth, whose kind, `by`, base, low and rule are given: the one that is the same, or a new one; 0 where there is no room. */
int cagd_growth_variable(cagd_search *s, cagd_growth growth, cagd_num_f *w);
/* v = p n + c with small whole p and c. */
int cagd_linear_with_n(cagd_search *s, cagd_num_f v, int *p, int *c);
/* Whether the denominator is not 0, as a function of the other variables, for any whole n >= s->from. */
int cagd_is_defined_for_every(const cagd_search *s, cagd_num_f value);

/* The value for whole n >= s->from; 0 where it is not found.  The sums in it are added to s->closed. */
int cagd_closed(cagd_search *s, const cagd_tree *t, const cagd_frame *f, cagd_num_f *out);
/* Whether a and b are equal for every whole n >= s->from: as functions of n and the variables w, and (-1)^n being 1 and -1. */
int cagd_equal_closed(const cagd_search *s, cagd_num_f a, cagd_num_f b);
#endif
