/* interval.h -- what this folder needs of intervals beyond exact/number/interval.h: bounds given as
 * binary64, hulls, squares, and sums that outlive a region. */
#ifndef CAGD_STATIONARY_INTERVAL_H
#define CAGD_STATIONARY_INTERVAL_H

#include "exact/kernels_i.h"
#include "exact/number/region.h"
#include "exact/words.h"

#include <math.h>

static inline num_i between(double low, double high)
{
    struct cagd_interval *r = cagd_region_slot(SLOT_INTERVAL);
    mpfr_set_d(r->lo, low, MPFR_RNDD);
    mpfr_set_d(r->hi, high, MPFR_RNDU);
    return (num_i){r};
}
static inline num_i number(double x) { return between(x, x); }

/* x - r <= x <= x + r, and the same of the factor exp(x), |x| <= r <= 1: 1 - r <= exp(x) <= 1 + r + r^2. */
static inline num_i around(double x, double r) { return add_i(number(x), between(-r, r)); }
static inline num_i factor_around(double w, double r)
{
    struct cagd_interval *f = cagd_region_slot(SLOT_INTERVAL);
    mpfr_set_d(f->lo, r, MPFR_RNDU);
    mpfr_ui_sub(f->lo, 1, f->lo, MPFR_RNDD);
    mpfr_set_d(f->hi, r, MPFR_RNDU);
    mpfr_sqr(f->hi, f->hi, MPFR_RNDU);
    mpfr_add_d(f->hi, f->hi, r, MPFR_RNDU);
    mpfr_add_ui(f->hi, f->hi, 1, MPFR_RNDU);
    return mul_i(number(w), (num_i){f});
}

static inline num_i hull(num_i a, num_i b)
{
    struct cagd_interval *r = cagd_region_slot(SLOT_INTERVAL);
    mpfr_min(r->lo, a.at->lo, b.at->lo, MPFR_RNDD);
    mpfr_max(r->hi, a.at->hi, b.at->hi, MPFR_RNDU);
    return (num_i){r};
}

static inline num_i square(num_i a)
{
    struct cagd_interval *r = cagd_region_slot(SLOT_INTERVAL);
    mpfr_srcptr far = mpfr_cmpabs(a.at->lo, a.at->hi) > 0 ? a.at->lo : a.at->hi;
    mpfr_srcptr near = far == a.at->lo ? a.at->hi : a.at->lo;
    mpfr_sqr(r->hi, far, MPFR_RNDU);
    if (contains_zero_i(a))
        mpfr_set_zero(r->lo, 1);
    else
        mpfr_sqr(r->lo, near, MPFR_RNDD);
    return (num_i){r};
}

/* A number no smaller than any |x|, x of a. */
static inline double size_of(num_i a) { return fmax(-lower_i(a), upper_i(a)); }

/* The numbers of T that are nearest to those of a. */
static inline num_i within(num_i T, num_i a)
{
    struct cagd_interval *r = cagd_region_slot(SLOT_INTERVAL);
    mpfr_max(r->lo, a.at->lo, T.at->lo, MPFR_RNDD);
    mpfr_min(r->lo, r->lo, T.at->hi, MPFR_RNDD);
    mpfr_min(r->hi, a.at->hi, T.at->hi, MPFR_RNDU);
    mpfr_max(r->hi, r->hi, T.at->lo, MPFR_RNDU);
    return (num_i){r};
}

static inline num_i inner(int dim, const num_i a[], const num_i b[])
{
    num_i sum = mul_i(a[0], b[0]);
    for (int c = 1; c < dim; c++)
        sum = add_i(sum, mul_i(a[c], b[c]));
    return sum;
}

/* Sums that outlive the regions of their terms. */
static inline void sums_init(int count, struct cagd_interval sum[])
{
    for (int k = 0; k < count; k++) {
        mpfr_init2(sum[k].lo, INTERVAL_PRECISION);
        mpfr_init2(sum[k].hi, INTERVAL_PRECISION);
        mpfr_set_zero(sum[k].lo, 1);
        mpfr_set_zero(sum[k].hi, 1);
    }
}
static inline void sums_clear(int count, struct cagd_interval sum[])
{
    for (int k = 0; k < count; k++) {
        mpfr_clear(sum[k].lo);
        mpfr_clear(sum[k].hi);
    }
}
static inline void accumulate(struct cagd_interval *sum, num_i x)
{
    mpfr_add(sum->lo, sum->lo, x.at->lo, MPFR_RNDD);
    mpfr_add(sum->hi, sum->hi, x.at->hi, MPFR_RNDU);
}
#endif
