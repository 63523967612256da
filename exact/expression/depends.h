/* depends.h -- which names a statement depends on, by itself and by the definitions that it uses. */
#ifndef CAGD_EXPRESSION_DEPENDS_H
#define CAGD_EXPRESSION_DEPENDS_H

#include "exact/expression/scope.h"

/* Whether the name occurs in the statement, or in the definitions that it uses. */
int cagd_depends_on(const cagd_scope *scope, const cagd_tree *statement, const char *head);
/* The whole numbers that the statement depends on, in the order in which they were declared; their number. */
int cagd_whole_numbers(const cagd_scope *scope, const cagd_tree *statement, const cagd_variable *list[], int room);

/* Whether the letter has a value, as r has behind r = 4, though it was declared before. */
int cagd_has_value(const cagd_scope *scope, const char *head);
/* Whether a condition speaks of any name that the statement depends on, its index that means nothing, `letter` or NULL, left out: where none does, it takes
 * nothing from the first cases. */
int cagd_condition_speaks_of(const cagd_scope *scope, const cagd_tree *condition, const char *letter,
                             const cagd_tree *statement);
#endif
