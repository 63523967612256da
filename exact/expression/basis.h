/* basis.h -- a family of functions b_0, ..., b_n of t in [a,b], perhaps with a parameter, and what bases of curves are asked
 * about: linear independence, total positivity, monotony, Bernstein coefficients, values and derivatives at the ends (函数组的性质).
 *
 * What is a formula, such as sum b_i = 1, is checked as one (check.h). */
#ifndef CAGD_BASIS_H
#define CAGD_BASIS_H

#include "exact/expression/find.h"

enum { CAGD_MOST_FUNCTIONS = 33, CAGD_END_ORDERS = 3 };

typedef struct cagd_basis {
    int count;                 /* of functions                                                                   */
    cagd_side_of_box t, range; /* the interval; the parameter, where has_parameter                               */
    int angle;                 /* 0; or the argument is an angle, and t the tangent of one so-manyth of it (angle.h) */
    const char *end[2], *sum;  /* a, b and a + b in TeX                                                           */
    int has_parameter, others; /* others: how many more variables there are                                     */
    cagd_num_f function[CAGD_MOST_FUNCTIONS];
    cagd_num_f at_end[2][CAGD_END_ORDERS][CAGD_MOST_FUNCTIONS]; /* derivatives 0, 1, 2 at a and b, by t           */
    int degree; /* of polynomials in the argument; -1 where one of them is none                                     */
    const cagd_num_f *coefficient; /* b_i(t) = sum_j coefficient[i (degree+1) + j] B_j^degree((t-a)/(b-a))         */
    const char *name[CAGD_MOST_UNKNOWNS], *letter[CAGD_MOST_UNKNOWNS]; /* what variables of the field stand for  */
    int names;
} cagd_basis;

/* The place of the argument among the children of a name with arguments: the first that is not the parameter, which may be NULL; else the first. */
int cagd_basis_argument(const cagd_tree *function, const char *parameter);

/* The functions: `function` is a name with indices and an argument, b_i(t), for first <= index <= last; the argument has bounds
 * in the scope, and other indices have one value.  `parameter` may be NULL.  The field is opened anew.  NULL, or why it cannot be read. */
const char *cagd_basis_read(const cagd_scope *scope, const cagd_tree *function, const char *index, long first,
                            long last, const char *parameter, cagd_basis *out);

/* For which values of the parameter all functions are defined, but for single t: the others are poles of their coefficients. */
void cagd_basis_defined(const cagd_basis *b, cagd_found *out);

/* For which values of the parameter the functions are linearly independent: where their Wronskian is not the function 0. */
void cagd_basis_independent(const cagd_basis *b, cagd_found *out);

/* For which values of the parameter the functions are totally positive on [a,b]: det b_{j_l}(t_k) >= 0 for all j_1 < ... < j_m and
 * t_1 < ... < t_m.
 *
 * With W the Wronskian of neighbours b_i, ..., b_k: if all W > 0 on (a,b) they are, and if some W < 0 somewhere they are not
 * (karlin-1968, chapter 2: for each i these are an extended Chebyshev system, so that minors of neighbouring columns are positive;
 * Fekete's lemma gives the others, and [a,b] is the limit).  Where W >= 0 has zeros inside, it is undecided, but for values that are
 * limits of good ones.  Where the parameter's value is bad, `block` names the neighbours and t the numbers of a negative minor. */
typedef struct cagd_negative_minor {
    int first, order;
    cagd_num_q parameter, t[CAGD_MOST_FUNCTIONS], value;
} cagd_negative_minor;
void cagd_basis_totally_positive(const cagd_basis *b, double seconds, cagd_found *out, cagd_negative_minor *minor);

/* How b_i changes with the parameter, for all t and all values in its range. */
typedef enum cagd_monotony {
    CAGD_CONSTANT,
    CAGD_INCREASING,
    CAGD_DECREASING,
    CAGD_NOT_MONOTONE,
    CAGD_UNKNOWN
} cagd_monotony;
cagd_monotony cagd_basis_monotony(const cagd_basis *b, int i);
#endif
