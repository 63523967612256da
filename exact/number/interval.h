/* interval.h -- the number type i: closed intervals with MPFR endpoints.
 * Every operation rounds outwards, so the true result lies in the interval. */
#ifndef CAGD_NUM_INTERVAL_H
#define CAGD_NUM_INTERVAL_H

#include "exact/number/rational.h"

#include <mpfr.h>

enum { INTERVAL_PRECISION = 128 };

struct interval {
    mpfr_t lo, hi;
};
typedef struct num_i {
    const struct interval *at;
} num_i;

num_i add_i(num_i a, num_i b);
num_i sub_i(num_i a, num_i b);
num_i mul_i(num_i a, num_i b);
num_i div_i(num_i a, num_i b); /* UNDEFINED for b = [0,0]; UNABLE and the whole line when 0 is
                                  one of several points of b                                    */
num_i neg_i(num_i a);
num_i from_int_i(long m);
num_i from_ratio_i(long m, long n);
num_i root_i(int n, num_i a); /* encloses the roots of the points >= 0; UNDEFINED when there are
                                 none, UNABLE when there are points < 0                         */

num_i from_rational_i(num_q a); /* the tightest interval around a                        */
int contains_i(num_i a, num_q x);
int contains_zero_i(num_i a);
int sign_i(num_i a);     /* +1 or -1 when every point has that sign, else 0       */
double width_i(num_i a); /* hi - lo, rounded up                                   */
double lower_i(num_i a); /* lo rounded down                                       */
double upper_i(num_i a); /* hi rounded up                                         */
#endif
