/* bounds.h -- what stands behind a formula without a word and is a bound of a variable, or a condition of variables.
 *
 * Nobody says of a variable that it has such bounds, a > 0, 0 <= a <= 1, u_0 <= u < u_1: they are supposed. */
#ifndef CAGD_EXPRESSION_BOUNDS_H
#define CAGD_EXPRESSION_BOUNDS_H

#include "exact/expression/scope.h"

#define CAGD_BEYOND_BOUNDS "the name has other bounds already: write those that are meant in :for:"

/* Names without meaning and numbers alone: a condition, if it is no statement. */
int cagd_is_of_plain_names(const cagd_scope *scope, const cagd_tree *t);
/* Whether it has one value: numbers, whole numbers, and names that were defined by these alone, as knots u_i = i. */
int cagd_is_constant(const cagd_scope *scope, const cagd_tree *t);
/* A relation, other than =, of a variable and constants, or of a variable between two constants or two knots, u_i <= u < u_{i+1}; of the
 * variable no condition of the scope speaks, nor the premise, which may be NULL. */
int cagd_is_range_of_name(const cagd_scope *scope, const cagd_tree *t, const cagd_tree *premise);
/* A range in a statement, behind a formula or a quantifier, whose ends are outside of the bounds that its name has from elsewhere, \forall t \in [-1,2] with 0 <= t <= 1:
 * nobody knows which are meant.  NULL where there is none. */
const cagd_tree *cagd_is_beyond_bounds(const cagd_scope *scope, const cagd_tree *statement);
/* A name without a value in the bounds of a variable on which the statement depends, which goes to *of; NULL where there is none. */
const cagd_tree *cagd_unknown_in_bounds(const cagd_scope *scope, const cagd_tree *statement, const cagd_variable **of);
#endif
