/* value.h -- a number that is a rational where it is one, and otherwise a rational function of the variables of the field. */
#ifndef CAGD_VALUE_H
#define CAGD_VALUE_H

#include "exact/number/field.h"

typedef struct cagd_value {
    int rational; /* then q is the value, otherwise f, which is no constant */
    cagd_num_q q;
    cagd_num_f f;
    const struct cagd_angle *angle; /* NULL, or what a letter stands for that has no value as a number (angle.h) */
} cagd_value;

cagd_value cagd_value_q(cagd_num_q q);
cagd_value cagd_value_f(cagd_num_f f); /* a constant becomes a rational */
cagd_value
cagd_value_constant(cagd_num_q q); /* where a trace is open, a constant of its program, which is no older than it */
cagd_value cagd_value_int(long m);
cagd_num_f cagd_in_field(cagd_value a);

/* UNABLE where the operands are so large that the result would take long, or much memory. */
cagd_value cagd_value_add(cagd_value a, cagd_value b);
cagd_value cagd_value_sub(cagd_value a, cagd_value b);
cagd_value cagd_value_mul(cagd_value a, cagd_value b);
cagd_value cagd_value_div(cagd_value a, cagd_value b); /* UNDEFINED for b = 0 */

int cagd_value_is_zero(cagd_value a);
/* Whether it is a whole number that fits, which goes to *m. */
int cagd_value_is_whole(cagd_value a, long *m);
#endif
