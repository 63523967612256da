/* scope.h -- for which degrees and values a claim was decided. */
#ifndef CAGD_SCOPE_H
#define CAGD_SCOPE_H

#include "chapters/judge/run.h"

/* "n = 1 to 4; every value of t and every positive value of w0..w4": made from what was run in the type that gives the
 * claim its evidence.  The caller frees. */
char *scope_of(const claim_result *r);
#endif
