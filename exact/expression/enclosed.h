/* enclosed.h -- counterexamples where an angle is a number, too, as in sin t <= t/2 (包围).
 *
 * The field has t and x = tan(t/2), or a quarter of it, as two variables, and pi as one.  Here t is a rational number, and x and pi are
 * between two rational numbers that enclose them (MPFR): where in that box left - right has one sign, and no divisor is 0, the
 * order of both sides is known. */
#ifndef CAGD_ENCLOSED_H
#define CAGD_ENCLOSED_H

#include "exact/expression/evaluate.h"

typedef struct cagd_enclosed_example {
    cagd_num_q value[CAGD_MOST_UNKNOWNS]; /* of the bindings without a value that have a number                       */
    int is_enclosed[CAGD_MOST_UNKNOWNS];  /* the others: tangents of angles that are numbers, pi                      */
    int order;                            /* the sign of left - right there                                           */
    double left, right;                   /* about                                                                    */
} cagd_enclosed_example;

/* Whether the relation k of the chain t is found false for such numbers, everything that is supposed being true. */
int cagd_find_enclosed_example(const cagd_context *c, const cagd_tree *t, int k, cagd_enclosed_example *out);
#endif
