/* change.h -- a statement with one thing changed: what still holds then did not depend on it.  A statement that holds however it
 * is changed says nothing. */
#ifndef CAGD_CHANGE_H
#define CAGD_CHANGE_H

#include "exact/expression/tree.h"

/* The change number `which`, from 0: a number, an index or an end of a range is 1 more, a term has the other sign, a
 * relation the other direction; where there is nothing of that kind, a name is 1 more.  NULL when there are not so many. */
const cagd_tree *cagd_changed(const cagd_tree *t, int which);
#endif
