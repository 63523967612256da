/* simplex.h -- linear systems in numbers that are not negative, decided with evidence, and systems of linear inequalities by them. */
#ifndef CAGD_SIMPLEX_H
#define CAGD_SIMPLEX_H

#include "exact/number/rational.h"

/* Is there an x >= 0 with A x = b?  A has rows x columns entries, row by row.  Phase one of the simplex method over Q with
 * Bland's rule, which ends always.  Exactly one of the two is there (Farkas); both live in the region.
 * Source: bland-1977; farkas-1902. */
struct cagd_simplex {
    int solvable;
    const cagd_num_q *x; /* solvable: `columns` numbers                                         */
    const cagd_num_q *y; /* otherwise: `rows` numbers with y A <= 0 (every column) and y b > 0  */
};
struct cagd_simplex cagd_simplex(int rows, int columns, const cagd_num_q A[], const cagd_num_q b[]);

/* Is there a point p of d coordinates with form_j . p > 0 for the strict forms and form_j . p >= 0 for the others?  form_j is
 * forms[d j .. d j + d - 1]; at least one is strict.  If so, the point; if not, numbers lambda_j >= 0 whose sum over the strict forms is
 * 1, with sum lambda_j form_j = 0 (Motzkin's transposition theorem).  The evidence has been checked by the next function.
 * Source: motzkin-1936. */
struct cagd_inequalities {
    int solvable;
    const cagd_num_q *point;  /* d numbers      */
    const cagd_num_q *lambda; /* `count` numbers */
};
struct cagd_inequalities cagd_inequalities(int d, int count, const cagd_num_q forms[], const int strict[]);

/* Does the evidence prove what it says?  Multiplications, additions and signs only. */
int cagd_inequalities_hold(int d, int count, const cagd_num_q forms[], const int strict[], struct cagd_inequalities s);
#endif
