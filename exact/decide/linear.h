/* linear.h -- systems of linear inequalities over the rationals: a solution, or the proof that there is none. */
#ifndef CAGD_LINEAR_H
#define CAGD_LINEAR_H

#include "exact/number/rational.h"

enum cagd_linear_relation { CAGD_LINEAR_POSITIVE, CAGD_LINEAR_NONNEGATIVE, CAGD_LINEAR_ZERO };

/* a_0 + a_1 x_1 + ... + a_n x_n > 0, >= 0, or = 0; a: n + 1 numbers. */
struct cagd_linear_condition {
    const cagd_num_q *a;
    enum cagd_linear_relation relation;
};

/* solvable: x has n numbers with which all conditions hold.  Otherwise multiplier has count numbers, none negative where the condition
 * is an inequality; the conditions times these sum up to 0 x + c, with c < 0, or with c = 0 and a multiplier of a strict one > 0,
 * which is a contradiction. */
struct cagd_linear_answer {
    int solvable;
    const cagd_num_q *x, *multiplier;
};

/* n >= 0, count >= 0.  Phase one of the simplex method over Q with Bland's rule on the alternative of Motzkin; the answer has been
 * checked by the next function.  Without memory the fault is MEMORY, and the answer has neither. */
struct cagd_linear_answer cagd_linear_solve(int n, int count, const struct cagd_linear_condition condition[]);

/* Does the answer prove what it says?  Multiplications and additions only. */
int cagd_linear_answer_holds(int n, int count, const struct cagd_linear_condition condition[],
                             struct cagd_linear_answer answer);
#endif
