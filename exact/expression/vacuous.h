/* vacuous.h -- statements that say nothing by their form alone. */
#ifndef CAGD_VACUOUS_H
#define CAGD_VACUOUS_H

#include "exact/expression/scope.h"

/* Whether each of its relations has two sides that are one formula, or repeats what is supposed, declared, or defined: a >= 0 for a >= 0,
 * A => A, A <=> A.  The statement is one that holds. */
int cagd_is_vacuous(const cagd_scope *scope, const cagd_tree *statement);
#endif
