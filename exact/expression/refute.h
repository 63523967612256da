/* refute.h -- what is false is refuted by numbers, which become the example of the finding. */
#ifndef CAGD_EXPRESSION_REFUTE_H
#define CAGD_EXPRESSION_REFUTE_H

#include "exact/expression/run.h"

/* All names of the page with their values; a name with root[m] has that root instead, with no `root` none has. */
void cagd_give_all(cagd_finding *f, const cagd_context *c, const cagd_num_q value[],
                   const struct cagd_root *const root[]);
/* The relation number k of the chain t, or any truth for k < 0: by small numbers that are looked for, or by those that are given, if at is not NULL.  FAILS, or
 * UNDECIDED where none are found. */
cagd_answer cagd_refuted_at(cagd_run *r, cagd_context *c, const cagd_tree *t, int k, const cagd_num_q at[]);
/* The same, the point having `count` coordinates of the bindings of[]. */
cagd_answer cagd_refuted(cagd_run *r, cagd_context *c, const cagd_tree *t, int k, const cagd_num_q point[],
                         const int of[], int count);
#endif
