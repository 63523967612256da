/* sign.h -- whether a polynomial is positive where its variables have bounds, exactly.
 *
 * In one variable roots are counted.  In two, the values of the second are isolated between which the order of the roots of the
 * first does not change (discriminants, resultants, leading coefficients, values at the ends), and one number between any two
 * of them decides.  In more, x = (a + b u)/(1 + u) maps the positive numbers to a < x < b, and a numerator whose coefficients are
 * all positive is a proof; bounds are halved until that is so, or a point refutes; even powers of factors are left out, and A x^2 + B x + C >= 0
 * where A, C, 4 A C - B^2 >= 0. */
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

/* p with x = a + u, b - u, (a + b u)/(1 + u) for each side, times a power of 1 + u, u > 0 being called x again: it has the signs of p in the open box. */
cagd_num_f cagd_over_positive_numbers(cagd_num_f p, int count, const cagd_side_of_box side[]);

/* Whether p >= 0 by its coefficients over positive numbers, and, if strict, p is not 0 on a face that belongs to the box: the smallest
 * ones are asked. */
int cagd_is_positive_by_coefficients(cagd_num_f p, int strict, int count, const cagd_side_of_box side[]);

/* A simple rational inside the side. */
cagd_num_q cagd_inside(const cagd_side_of_box *s);
int cagd_is_inside(const cagd_side_of_box *s, cagd_num_q x);

/* What is asked of a parameter: that p >= 0, or p > 0, for all t of a side, or that p is the function 0; p is a polynomial in the
 * parameter and t, for 0 in any variables. */
typedef enum cagd_demand { CAGD_AT_LEAST_ZERO, CAGD_MORE_THAN_ZERO, CAGD_ZERO } cagd_demand;
typedef struct cagd_constraint {
    cagd_num_f p;
    cagd_demand demand;
    cagd_side_of_box t; /* where p is free of other variables, that of the parameter */
    int or_next;        /* this or the next one is asked: so several in a row are one clause */
} cagd_constraint;

/* For which values of the parameter all constraints, or clauses of them, hold: its side is cut by `count` numbers root[k]; cell[k] is the answer below
 * root[k], cell[count] the one above the last; at[k] the answer for root[k] itself, all in increasing order.  0 where there are too
 * many cuts. */
enum { CAGD_MOST_CUTS = 200 };
typedef struct cagd_cells {
    int count;
    struct cagd_root root[CAGD_MOST_CUTS];
    cagd_answer cell[CAGD_MOST_CUTS + 1], at[CAGD_MOST_CUTS];
    int empty[CAGD_MOST_CUTS + 1];         /* the first and the last cell may be                                  */
    cagd_num_q sample[CAGD_MOST_CUTS + 1]; /* a number of each cell                                               */
    int broken[CAGD_MOST_CUTS +
               1]; /* the first constraint that does not hold in the cell; of a clause the one with the witness */
    cagd_num_q witness[CAGD_MOST_CUTS + 1]; /* a t for which it does not, if has_witness                           */
    int has_witness[CAGD_MOST_CUTS + 1];
} cagd_cells;
int cagd_cells_of(int constraints, const cagd_constraint constraint[], const cagd_side_of_box *parameter,
                  cagd_cells *out);
/* The product of the irreducible factors of p that contain the parameter and nothing else; 1 where there are none, or too many. */
cagd_num_f cagd_factor_of_parameter(cagd_num_f p, cagd_num_f parameter);

/* The answers of some of these constraints for the same cells. */
void cagd_answer_cells(int constraints, const cagd_constraint constraint[], const cagd_side_of_box *parameter,
                       cagd_cells *cells);
/* A cell in which a constraint fails, the most telling one: beside a cell in which all hold, and of these the one with the shortest number.
 * -1 where there is none. */
int cagd_telling_failure(const cagd_cells *cells);
#endif
