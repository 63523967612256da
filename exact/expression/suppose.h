/* suppose.h -- what is supposed becomes known of the cell.
 *
 * A condition with an index that means nothing, u_i <= u_{i+1}, is said for every index: for all names u_j that come up, and
 * for those between them. */
#ifndef CAGD_SUPPOSE_H
#define CAGD_SUPPOSE_H

#include "exact/expression/evaluate.h"

/* The conditions of the scope that are not for every index, and the premise: 1 when they are known of the cell, or true; 0 where one is false; -1 where one
 * needs a cut, which is noted.  c->missing counts those that could not be used. */
int cagd_suppose_conditions(cagd_context *c);
/* Those for every index, for the names that there are by now. */
void cagd_suppose_for_names(cagd_context *c);
/* Whether all conditions are true, names having numbers: 1, 0; -1 where that is not known. */
int cagd_conditions_hold(cagd_context *c);
#endif
