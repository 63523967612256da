/* interval.h -- the number type i: closed intervals with MPFR endpoints.
 * Every operation rounds outwards, so the true result lies in the interval.  Its ends have the precision of the region in which
 * it is made (cagd_region_set_precision), whatever the precision of the operands. */
#ifndef CAGD_NUM_INTERVAL_H
#define CAGD_NUM_INTERVAL_H

#include "exact/number/rational.h"

#include <mpfr.h>

/* lo <= x <= hi; an end may be infinite. */
struct cagd_interval {
    mpfr_t lo, hi;
};
typedef struct cagd_num_i {
    const struct cagd_interval *at;
} cagd_num_i;

cagd_num_i cagd_add_i(cagd_num_i a, cagd_num_i b);
cagd_num_i cagd_sub_i(cagd_num_i a, cagd_num_i b);
cagd_num_i cagd_mul_i(cagd_num_i a, cagd_num_i b);
cagd_num_i cagd_div_i(cagd_num_i a, cagd_num_i b); /* UNDEFINED for b = [0,0]; UNABLE and the whole line when 0
                                                      is one of several points of b                           */
cagd_num_i cagd_neg_i(cagd_num_i a);
cagd_num_i cagd_from_int_i(long m);
cagd_num_i cagd_from_ratio_i(long m, long n);
cagd_num_i cagd_root_i(int n, cagd_num_i a); /* encloses the roots of the points >= 0; UNDEFINED when there are
                                                none, UNABLE when there are points < 0                        */
cagd_num_i cagd_square_i(cagd_num_i a);      /* of the points of a: tighter than the product of a and a       */
cagd_num_i cagd_inner_i(int dim, const cagd_num_i a[], const cagd_num_i b[]); /* sum a_c b_c, 0 <= c < dim     */

cagd_num_i cagd_from_rational_i(cagd_num_q a);            /* the tightest interval around a                    */
cagd_num_i cagd_from_double_i(double x);                  /* the same around x; UNDEFINED for a NaN            */
cagd_num_i cagd_between_i(double low, double high);       /* UNDEFINED unless low <= high                      */
cagd_num_i cagd_around_i(double x, double r);             /* x - r to x + r, r >= 0                            */
cagd_num_i cagd_exp_around_i(double r);                   /* 1 - r to 1 + r + r^2, which has exp(x) for |x| <= r;
                                                             UNABLE unless 0 <= r <= 1                         */
cagd_num_i cagd_hull_i(cagd_num_i a, cagd_num_i b);       /* the least interval with all points of both        */
cagd_num_i cagd_nearest_in_i(cagd_num_i T, cagd_num_i a); /* the points of T that are nearest to those of a    */

int cagd_contains_i(cagd_num_i a, cagd_num_q x);
int cagd_contains_zero_i(cagd_num_i a);
int cagd_sign_i(cagd_num_i a);     /* +1 or -1 when every point has that sign, else 0       */
double cagd_width_i(cagd_num_i a); /* hi - lo, rounded up                                   */
double cagd_size_i(cagd_num_i a);  /* no smaller than |x| for any point x                   */
double cagd_lower_i(cagd_num_i a); /* lo rounded down                                       */
double cagd_upper_i(cagd_num_i a); /* hi rounded up                                         */

/* Sums that outlive the regions of their terms: `count` of them, 0 at first, in memory of the caller, who clears them.  Their
 * ends have the precision that the region has at this moment. */
void cagd_sums_init(int count, struct cagd_interval sum[]);
void cagd_sums_clear(int count, struct cagd_interval sum[]);
void cagd_accumulate(struct cagd_interval *sum, cagd_num_i x); /* *sum += x */
#endif
