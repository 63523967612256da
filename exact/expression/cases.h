/* cases.h -- all choices of the whole numbers, one by one. */
#ifndef CAGD_EXPRESSION_CASES_H
#define CAGD_EXPRESSION_CASES_H

#include "exact/expression/run.h"

/* From the whole number `level` on, those before being chosen. */
void cagd_decide_cases(cagd_run *r, int level);
/* Whether a range has no end. */
int cagd_has_no_end(const cagd_run *r);
/* Whether there is one whole number alone, on which no condition depends; then it begins at *low. */
int cagd_has_one_number(cagd_run *r, long *low);
/* The case that was noted goes where it is wanted; 0 where it says too little. */
int cagd_give_case(cagd_run *r);
#endif
