/* with.h -- decisions that are made of smaller ones, these being given: with the plain predicates they are the functions of the
 * same names, with those that testify (exact/record) they testify step by step.  Only for exact/decide and exact/record. */
#ifndef CAGD_WITH_H
#define CAGD_WITH_H

#include "exact/decide/hull.h"
#include "exact/decide/resultant.h"

/* The order of rationals. */
struct cagd_order {
    int (*compare)(cagd_num_q a, cagd_num_q b);
    int (*sign)(cagd_num_q a);
    int (*equal)(cagd_num_q a, cagd_num_q b);
};

int cagd_hull_certificate_holds_with(const struct cagd_order *order, int d, int count, const cagd_num_q points[],
                                     const cagd_num_q x[], struct cagd_hull_certificate c);
int cagd_turn_2d_with(const struct cagd_order *order, const cagd_num_q P[2], const cagd_num_q Q[2],
                      const cagd_num_q R[2]);

/* det A, its pivots told from 0 by is_zero. */
cagd_num_f cagd_pivoted_determinant_with_f(int (*is_zero)(cagd_num_f), int n, const cagd_num_f A[]);

/* The resultant of two elements of the field by a variable, its determinant computed by that function. */
cagd_num_f cagd_resultant_with_f(cagd_num_f (*determinant)(int n, const cagd_num_f A[]), cagd_num_f p, cagd_num_f q,
                                 cagd_num_f variable);
#endif
