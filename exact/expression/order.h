/* order.h -- inequalities in a cell: names that are ordered, as u_0 < u_1 < u_2, are written by their increments, u_1 = u_0 + y,
 * u_2 = u_0 + y + z with y, z > 0, upon which bounds are those of single names (sign.h). */
#ifndef CAGD_ORDER_H
#define CAGD_ORDER_H

#include "exact/expression/sign.h"

/* Whether p >= 0 (p > 0 if strict) in the cell; p is a polynomial in its variables.  FAILS: perhaps not, and value[m] of the unknown
 * binding m has numbers near to where it is not, if *rational; they need not be in the cell. */
cagd_answer cagd_positive_in_cell(const cagd_context *c, cagd_num_f p, int strict, cagd_num_q value[], int *rational);
/* Whether it is shown. */
int cagd_is_positive_in_cell(const cagd_context *c, cagd_num_f p, int strict);
#endif
