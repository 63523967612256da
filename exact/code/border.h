/* border.h -- where a comparison turns: points on the border of a condition of the code, and on all sides of it. */
#ifndef CAGD_CODE_BORDER_H
#define CAGD_CODE_BORDER_H

#include "exact/code/points.h"
#include "exact/number/rational.h"

/* The value at the point of an expression as conditions have it, "2*t*p[0] - (a + b)/c", where `name`, unless it is NULL, has
 * the value `instead`; {NULL} where it divides by 0 or is not understood.  In the region. */
cagd_num_q cagd_code_evaluate(const char *expression, const struct cagd_code_point *p, const char *name,
                              cagd_num_q instead);

/* The difference of a condition as a function of one variable, the others being as at the point. */
enum { CAGD_CODE_MOST_ZEROS = 16 };
struct cagd_code_border {
    int varies;                              /* whether it depends on the variable, and is understood               */
    int zeros;                               /* how many real zeros and poles it has, at most CAGD_CODE_MOST_ZEROS  */
    int rational;                            /* those of them that are rational, and were found as such             */
    int values;                              /* of the variable, which show all of its signs:                       */
    cagd_num_q at[5 * CAGD_CODE_MOST_ZEROS]; /* each zero that is rational, near it on both sides, between, and far */
    cagd_num_q
        least; /* where its derivative vanishes, nearly, and it is least in amount; {NULL} where there is no such place */
};

/* For the variable `element` of input `input`.  Zeros are isolated by Descartes' rule (roots.h); a rational one is found as such, where its
 * denominator has at most 256 bits.  Values are in the region. */
struct cagd_code_border cagd_code_border(const char *difference, const struct cagd_code_point *p, int input,
                                         int element);
#endif
