/* interval.h -- the number type i: closed intervals with MPFR endpoints.
 * Every operation rounds outwards, so the true result lies in the interval. */
#ifndef CAGD_NUM_INTERVAL_H
#define CAGD_NUM_INTERVAL_H

#include "exact/number/rational.h"

#include <mpfr.h>

enum { INTERVAL_PRECISION = 128 };

struct cagd_interval {
    mpfr_t lo, hi;
};
typedef struct cagd_num_i {
    const struct cagd_interval *at;
} cagd_num_i;

cagd_num_i cagd_add_i(cagd_num_i a, cagd_num_i b);
cagd_num_i cagd_sub_i(cagd_num_i a, cagd_num_i b);
cagd_num_i cagd_mul_i(cagd_num_i a, cagd_num_i b);
cagd_num_i cagd_div_i(cagd_num_i a, cagd_num_i b); /* UNDEFINED for b = [0,0]; UNABLE and the whole line when 0 is
                                  one of several points of b                                    */
cagd_num_i cagd_neg_i(cagd_num_i a);
cagd_num_i cagd_from_int_i(long m);
cagd_num_i cagd_from_ratio_i(long m, long n);
cagd_num_i cagd_root_i(int n, cagd_num_i a); /* encloses the roots of the points >= 0; UNDEFINED when there are
                                 none, UNABLE when there are points < 0                         */

cagd_num_i cagd_from_rational_i(cagd_num_q a); /* the tightest interval around a                        */
int cagd_contains_i(cagd_num_i a, cagd_num_q x);
int cagd_contains_zero_i(cagd_num_i a);
int cagd_sign_i(cagd_num_i a);     /* +1 or -1 when every point has that sign, else 0       */
double cagd_width_i(cagd_num_i a); /* hi - lo, rounded up                                   */
double cagd_lower_i(cagd_num_i a); /* lo rounded down                                       */
double cagd_upper_i(cagd_num_i a); /* hi rounded up                                         */
#endif
