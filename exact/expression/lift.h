/* lift.h -- square roots of functions as names of their own (根式作新变元): sqrt(q) is r with r^2 = q, r >= 0, and so is a length with its dot product.
 *
 * What is then said of these names wherever they exist is what the statement says wherever its roots are numbers. */
#ifndef CAGD_LIFT_H
#define CAGD_LIFT_H

#include "exact/expression/finding.h"

enum { CAGD_MOST_LIFTED = 6 };

/* The roots that were lifted: their names, and what they are roots of. */
typedef struct cagd_lifted {
    int count;
    const char *name[CAGD_MOST_LIFTED];
    const cagd_tree *of[CAGD_MOST_LIFTED];
    int is_length[CAGD_MOST_LIFTED]; /* of what is never negative */
} cagd_lifted;

/* The statement with names in place of the square roots in its relations, what these names are being supposed in *scope, which was a copy; NULL where no
 * root is lifted: in a sum, a derivative or a case it may have letters that stand for nothing outside. */
const cagd_tree *cagd_with_roots_lifted(cagd_scope *scope, const cagd_tree *statement, cagd_lifted *out);
/* The finding without these names, which are not those of the page. */
void cagd_forget_lifted(cagd_finding *f, const cagd_lifted *lifted);
#endif
