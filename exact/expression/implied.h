/* implied.h -- a relation where what is supposed is not used in any other way: r^2 = a b, x y >= 1, s^2 >= 3/4 for c <= 1/2 on the circle.
 *
 * Everything that is known of the names (conditions, bounds, the cell, the polynomials of roots) is a sign of a polynomial, and so is the
 * relation: exact/decide/cylinders.h decides whether the one implies the other, for few names. */
#ifndef CAGD_IMPLIED_H
#define CAGD_IMPLIED_H

#include "exact/expression/sign.h"

/* Where a relation is false: of each binding a number, or a root that is none; and the sign of left - right. */
typedef struct cagd_implied_example {
    int rational; /* all are numbers */
    cagd_num_q value[CAGD_MOST_UNKNOWNS];
    const struct cagd_root *root[CAGD_MOST_UNKNOWNS]; /* NULL: the number */
    int order;
} cagd_implied_example;

/* The relation number k of the chain t.  HOLDS: it does for all names for which that is true which is known, and for which no divisor of its sides is
 * 0.  FAILS: at *out; where that is rational it is to be looked at once more, as conditions may have been left out. */
cagd_answer cagd_implied_relation(const cagd_context *c, const cagd_tree *t, int k, double until,
                                  cagd_implied_example *out);
#endif
