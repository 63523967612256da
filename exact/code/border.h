/* border.h -- where a comparison turns: points on the border of a condition of the code, and beside it. */
#ifndef CAGD_CODE_BORDER_H
#define CAGD_CODE_BORDER_H

#include "exact/code/points.h"
#include "exact/number/rational.h"

/* The value at the point of an expression as conditions have it, "2*t*p[0] - (a + b)/c", where `name`, unless it is NULL, has
 * the value `instead`; {NULL} where it divides by 0 or is not understood.  In the region. */
cagd_num_q cagd_code_evaluate(const char *expression, const struct cagd_code_point *p, const char *name,
                              cagd_num_q instead);

/* The variable `element` of input `input` takes a value where the difference of a condition is 0, the others being as at the
 * point: that value, if the difference is linear in it and not constant; {NULL} otherwise. */
cagd_num_q cagd_code_border(const char *difference, const struct cagd_code_point *p, int input, int element);
#endif
