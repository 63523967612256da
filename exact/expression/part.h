/* part.h -- a part of a case: names within pieces and cells, in which everything that is said is compared, or which is cut further. */
#ifndef CAGD_EXPRESSION_PART_H
#define CAGD_EXPRESSION_PART_H

#include "exact/expression/run.h"

/* What is supposed and said, r->premise and r->claim, in that part. */
cagd_answer cagd_decide_part(cagd_run *r, const cagd_part *p);
#endif
