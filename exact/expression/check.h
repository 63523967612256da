/* check.h -- a statement, read into a tree, is decided: proved, refuted by an example, or neither.
 *
 * It is looked at for every choice of its whole numbers.  An equality is decided in the field, where it holds for all values of
 * the other names at once, and refuted by small rationals, with which both sides are computed again; an inequality is
 * decided where the names have bounds (sign.h).  Where a case of a definition changes within the bounds, the parts and the
 * number between them are looked at one by one. */
#ifndef CAGD_CHECK_H
#define CAGD_CHECK_H

#include "exact/expression/finding.h"

/* The statement, within so many seconds.  The field is opened anew: no element of an earlier one may be alive.  What is found
 * lives in the region. */
void cagd_check(const cagd_scope *scope, const cagd_tree *statement, double seconds, cagd_finding *out);

/* A statement that holds is changed in many ways, for so many seconds; what becomes of it is noted in *out. */
void cagd_check_changes(const cagd_scope *scope, const cagd_tree *statement, double seconds, cagd_finding *out);
#endif
