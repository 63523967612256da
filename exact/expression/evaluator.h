/* evaluator.h -- what the parts of the evaluation share; only for evaluate*.c.
 *
 * Each function is the value of one kind of tree, with the letters of the frame; where there is none, the trouble is told by cagd_fail and
 * what is returned counts for nothing. */
#ifndef CAGD_EVALUATOR_H
#define CAGD_EVALUATOR_H

#include "exact/expression/evaluate.h"

enum { CAGD_MOST_POWER = 1000 };

/* ---- evaluate.c ---------------------------------------------------------------------------------------- */

/* b is divided by: 0 where there is no room to note it. */
int cagd_note_divisor(cagd_context *c, cagd_value b);
/* Whether it is 0: of names near a root that is a matter of their polynomials. */
int cagd_is_zero_at_roots(const cagd_context *c, cagd_value b);
/* Of a name, with the derivatives that it has; and of its definitions for these indices and arguments. */
cagd_value cagd_name_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f);
cagd_value cagd_defined_value(cagd_context *c, const cagd_tree *t, const cagd_value value[], const cagd_frame *caller);

/* ---- evaluate_derivative.c ----------------------------------------------------------------------------- */

/* The order that a tree tells, which is a whole number. */
long cagd_order_of(cagd_context *c, const cagd_tree *t, const cagd_tree *order, const cagd_frame *f);
/* The k-th derivative, of the name t by its first argument, value[] being all of them and a its place, or of the body by the letter of t;
 * and the same by an angle. */
cagd_value cagd_derivative_of(cagd_context *c, const cagd_tree *t, const cagd_tree *body, cagd_value value[], long k,
                              cagd_value a, const cagd_frame *f);
cagd_value cagd_derivative_by_angle(cagd_context *c, const cagd_tree *t, const cagd_tree *body, cagd_value value[],
                                    long k, const struct cagd_angle *at, const cagd_frame *f);
cagd_value cagd_derivative_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f);
cagd_value cagd_place_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f);
cagd_value cagd_integral_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f);

/* ---- evaluate_vector.c --------------------------------------------------------------------------------- */

/* The component k of a vector, from 0, whichever is asked for here. */
cagd_value cagd_component_value(cagd_context *c, const cagd_tree *t, int k, const cagd_frame *f);
cagd_value cagd_dot_value(cagd_context *c, const cagd_tree *a, const cagd_tree *b, const cagd_frame *f);
/* (a, b, c) = (a x b) . c */
cagd_value cagd_mixed_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f);
/* Of a point or a cross product, and of a matrix that is computed: the component, or entry, that is asked for. */
cagd_value cagd_vector_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f);
cagd_value cagd_matrix_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f);
cagd_value cagd_determinant_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f);

/* ---- evaluate_number.c --------------------------------------------------------------------------------- */

cagd_value cagd_power_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f);
cagd_value cagd_factorial_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f);
cagd_value cagd_binomial_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f);
/* The q-number of n, or the q-factorial: polynomials in q, so q = 1 is no exception. */
cagd_value cagd_q_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f);
cagd_value cagd_q_binomial_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f);
cagd_value cagd_root_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f);
/* The n-th root of a, the one that is not negative if n is even. */
cagd_value cagd_root_of_value(cagd_context *c, const cagd_tree *t, cagd_value a, long n);

#endif
