/* conditions.h -- the conditions of ways through the code: which need not be said, and which ways they leave open. */
#ifndef CAGD_CODE_CONDITIONS_H
#define CAGD_CODE_CONDITIONS_H

#include "exact/code/points.h"

/* What follows from the preconditions and from what is kept is marked as implied; what is divided by and cannot be 0 is dropped. */
void cagd_code_simplify(struct cagd_code_outcome *outcome);

/* A run in the field, and the point of its comparisons. */
struct cagd_code_leaf {
    const struct cagd_code_outcome *outcome;
    const struct cagd_code_point *point;
};

/* The code decides what it compares next by what it has compared: runs in which the same neighbours are equal are the leaves of a tree,
 * whose branches are the conditions in their order.  Whether the other leaf takes the other branch at the k-th condition of this one. */
int cagd_code_branches_off(const struct cagd_code_leaf *leaf, int k, const struct cagd_code_leaf *other);

/* That branch: 0 when no inputs take it, which is proved; 1 and a point that should take it; -1 when that is not known.  The text
 * has the condition. */
int cagd_code_branch(const struct cagd_code_harness *h, const struct cagd_code_leaf *leaf, int k,
                     struct cagd_code_point **point, size_t room, char text[]);
/* Whether both took the same way. */
int cagd_code_is_same_way(const struct cagd_code_leaf *a, const struct cagd_code_leaf *b);
int cagd_code_count_conditions(const struct cagd_code_outcome *o);

/* Whether inputs that do not decrease have equal neighbours at the same places. */
int cagd_code_is_of_one_pattern(const struct cagd_code_point *a, const struct cagd_code_point *b);
#endif
