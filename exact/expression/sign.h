/* sign.h -- whether a polynomial is positive where its variables have bounds, exactly.
 *
 * In one variable roots are counted.  In two, the values of the second are isolated between which the order of the roots of the
 * first does not change (discriminants, resultants, leading coefficients, values at the ends), and one number between any two
 * of them decides.  In more, x = (a + b u)/(1 + u) maps the positive numbers to a < x < b, and a numerator whose coefficients are
 * all positive is a proof; bounds are halved until that is so, or a point refutes. */
#ifndef CAGD_EXPRESSION_SIGN_H
#define CAGD_EXPRESSION_SIGN_H

#include "exact/decide/roots.h"
#include "exact/expression/evaluate.h"

typedef enum cagd_answer { CAGD_HOLDS, CAGD_FAILS, CAGD_UNDECIDED } cagd_answer;

/* A variable of the field and its bounds. */
typedef struct cagd_side_of_box {
    cagd_num_f variable;
    int has_low, has_high, low_open, high_open;
    cagd_num_q low, high;
} cagd_side_of_box;

/* Whether p >= 0 (p > 0 if strict) in the box; p is a polynomial in its variables.  FAILS: at a point of it p < 0 (p <= 0), which
 * goes to point[] unless the only ones have coordinates that are no rationals; then *rational is 0. */
cagd_answer cagd_positive_in_box(cagd_num_f p, int strict, int count, const cagd_side_of_box side[], cagd_num_q point[],
                                 int *rational);

/* The simplest rational between a and b: a < x < b, the denominator being least, and then the numerator. */
cagd_num_q cagd_simplest_between(cagd_num_q a, cagd_num_q b);
/* A simple rational inside the side. */
cagd_num_q cagd_inside(const cagd_side_of_box *s);
int cagd_is_inside(const cagd_side_of_box *s, cagd_num_q x);

/* For which values of a parameter p >= 0 (p > 0) for all t of the other side: the parameter's side is cut by `count` numbers
 * root[k]; cell[k] is the answer below root[k], cell[count] above the last; at[k] the answer for root[k] itself.  In increasing
 * order.  0 where there are too many or p has other variables. */
enum { CAGD_MOST_CUTS = 60 };
typedef struct cagd_cells {
    int count;
    struct cagd_root root[CAGD_MOST_CUTS];
    cagd_answer cell[CAGD_MOST_CUTS + 1], at[CAGD_MOST_CUTS];
    int empty[CAGD_MOST_CUTS + 1];          /* the first and the last cell may be */
    cagd_num_q sample[CAGD_MOST_CUTS + 1];  /* a number of each cell */
    cagd_num_q witness[CAGD_MOST_CUTS + 1]; /* where the cell fails: a t with p < 0 for that number */
} cagd_cells;
int cagd_positive_cells(cagd_num_f p, int strict, const cagd_side_of_box *t, const cagd_side_of_box *parameter,
                        cagd_cells *out);
#endif
