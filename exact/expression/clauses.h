/* clauses.h -- a statement as clauses (合取范式), each of them an alternative of relations: A => B is "not A, or B".
 *
 * An amount, a greatest or a least of several goes into clauses, too: a statement S of |a| is (a < 0, or S of a) and (a > 0, or S of -a).
 * A square root that is one side is squared: sqrt(E) <= R is E >= 0, R >= 0 and E <= R^2.  That E >= 0 is said besides: where it is false, the root is not defined,
 * and the statement is not refuted by that. */
#ifndef CAGD_EXPRESSION_CLAUSES_H
#define CAGD_EXPRESSION_CLAUSES_H

#include "exact/expression/tree.h"

enum { CAGD_MOST_LITERALS = 8 };

/* A tree that says the same: the statement itself where it is relations, or several of them; otherwise relations of two sides and CAGD_ANY of at most CAGD_MOST_LITERALS of them, all together in CAGD_ALL.  NULL where there are
 * too many, or where the statement has other parts, as "there is". */
const cagd_tree *cagd_in_clauses(const cagd_tree *statement);
/* The same with "A => B" in the place of alternatives, A being the opposites of all relations but the last one. */
const cagd_tree *cagd_in_implications(const cagd_tree *statement);
/* Whether a square root is a side of some relation: then what is false of the clauses may be said of where a root is not defined. */
int cagd_has_squared_roots(const cagd_tree *statement);
#endif
