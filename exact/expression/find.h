/* find.h -- for which values of a parameter a statement holds, exactly. */
#ifndef CAGD_EXPRESSION_FIND_H
#define CAGD_EXPRESSION_FIND_H

#include "exact/expression/run.h"

/* For which values of the parameter, a declared name without indices, the statement holds for all other names within their bounds: each case
 * of the whole numbers gives constraints of one other name at most.  In `cells` the numbers where it begins or ceases to hold are
 * among others; breaking[k] has the whole numbers of the case that breaks cell k first.  With `poles`, a number for which a divisor is 0
 * whatever the other names are is none for which it holds. */
typedef struct cagd_found {
    int known; /* 0: not found, and `why` says what was in the way */
    const char *why;
    const cagd_tree *where;
    long cases;
    cagd_side_of_box domain;
    cagd_cells cells;
    int leaves_out_poles; /* it is said of where both sides are defined */
    int wholes;
    const char *name_of_witness[CAGD_MOST_CUTS + 1]; /* of which name cells.witness is a value, or NULL */
    cagd_given breaking[CAGD_MOST_CUTS + 1][8];
} cagd_found;
void cagd_find(const cagd_scope *scope, const cagd_tree *statement, const char *parameter, int poles, double seconds,
               cagd_found *out);

/* The same with poles, once more, noted as exact/record/trace.h has it: the relations of all cases, the numbers that cut the domain, and what
 * holds in each cell and for each number.  1; 0 where that does not say it all: alternatives, ends of angles, cases that were cut into parts,
 * values whose making is not noted. */
int cagd_certify_found(const cagd_scope *scope, const cagd_tree *statement, const char *parameter, double seconds,
                       cagd_take_case *take, void *data);

/* The relation a >= b, a > b, a = b, or a \ne b as a constraint of the parameter, d being a - b; HOLDS if that is all it says. */
cagd_answer cagd_collected(cagd_run *r, cagd_context *c, cagd_relation relation, cagd_value d);
/* The alternative t of relations of two sides (clauses.h) as a clause of constraints.  Where it is not defined it is not true, but for alternatives of which another
 * one is. */
cagd_answer cagd_collect_clause(cagd_run *r, cagd_context *c, const cagd_tree *t);
#endif
