/* compare.h -- one relation between two values in a part of a case. */
#ifndef CAGD_EXPRESSION_COMPARE_H
#define CAGD_EXPRESSION_COMPARE_H

#include "exact/expression/run.h"

/* The relation number k of the chain t, whose sides have the values a and b. */
cagd_answer cagd_compared(cagd_run *r, cagd_context *c, const cagd_tree *t, int k, cagd_value a, cagd_value b);
#endif
