/* sides.h -- both sides of a relation that fails, as functions of one of the names of its counterexample. */
#ifndef CAGD_SIDES_H
#define CAGD_SIDES_H

#include "exact/expression/finding.h"

/* The name of the example over which the two sides are told apart best: a number that is no whole one, on which a side depends; of several
 * one with bounds.  Its place in example[], or -1; and its range: the bounds, where they are numbers when the others are, and otherwise
 * two units from its value. */
int cagd_free_name(const cagd_scope *scope, const cagd_finding *f, cagd_num_q *low, cagd_num_q *high);

/* Both sides where that name has the value x and the others are as in the example: 1, or 0 where a side has no value. */
int cagd_sides_at(const cagd_scope *scope, const cagd_finding *f, int name, cagd_num_q x, cagd_num_q *left,
                  cagd_num_q *right);
#endif
