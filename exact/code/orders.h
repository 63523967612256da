/* orders.h -- what a run with rounding would have computed, had its sums been done in another order; only for exact/code.
 *
 * The operations of the run are noted.  A sum of sums is one sum of its terms, a_1 + ... + a_n with signs; in another order they
 * are added in another order, in binary64, and everything else is done as the code does it.  What is no +, -, *, / or square
 * root is taken as it came out. */
#ifndef CAGD_CODE_ORDERS_H
#define CAGD_CODE_ORDERS_H

#include "exact/code/value.h"

/* v was made from a and b by '+', '-', '*', '/', or from a alone by 'n' (-a) or 'r' (its root). */
void cagd_code_note_made(cagd_code_value *v, char by, cagd_code_value a, cagd_code_value b);
/* The binary64 that v would be; v.d where that is not known. */
double cagd_code_in_order(cagd_code_value v, enum cagd_code_order order);
#endif
