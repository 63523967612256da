/* example.h -- numbers for which a relation is false: both sides are computed in rationals, by the tree and not in the field. */
#ifndef CAGD_EXAMPLE_H
#define CAGD_EXAMPLE_H

#include "exact/expression/evaluate.h"

/* Whether the relation k of the chain t, or for k < 0 any truth t, is false for value[m] of the unknown binding m of the context, all of them being within
 * their bounds and everything that is supposed being true; the two sides.  The values of solved bindings are written. */
int cagd_is_example(const cagd_context *c, const cagd_tree *t, int k, cagd_num_q value[], cagd_num_q *left,
                    cagd_num_q *right);
/* Small numbers for which it is. */
int cagd_find_example(const cagd_context *c, const cagd_tree *t, int k, cagd_num_q value[], cagd_num_q *left,
                      cagd_num_q *right);
#endif
