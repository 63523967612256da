/* certify.h -- what was found is noted, so that others can check it (证书). */
#ifndef CAGD_EXPRESSION_CERTIFY_H
#define CAGD_EXPRESSION_CERTIFY_H

#include "exact/expression/run.h"

/* What was found, once more, with its operations noted as exact/record/trace.h has them: each case of equalities that hold, or the
 * example with its two sides.
 * 1; 0 where a certificate does not say it all: inequalities whose box would be cut into too many parts, or whose names are tied to one
 * another; cases that were cut into parts, implications, and values whose making is not noted on either side, such as two
 * derivatives.  The field is opened anew. */
int cagd_certify(const cagd_scope *scope, const cagd_tree *statement, const cagd_finding *found, double seconds,
                 cagd_take_case *take, void *data);

/* a relation b, which is compared, as a step of the certificate; where it cannot be noted, r->unnoted. */
void cagd_note_step(cagd_run *r, const cagd_context *c, cagd_relation relation, cagd_value a, cagd_value b);
#endif
