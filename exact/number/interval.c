#include "exact/number/interval.h"
#include "exact/number/slots.h"
#include "exact/words.h"

#include <math.h>

/* A slot that was used with another precision changes. */
static struct cagd_interval *fresh(void)
{
    struct cagd_interval *r = cagd_region_slot(SLOT_INTERVAL);
    long precision = cagd_region_precision();
    if (mpfr_get_prec(r->lo) != precision) {
        mpfr_set_prec(r->lo, precision);
        mpfr_set_prec(r->hi, precision);
    }
    return r;
}

static num_i whole_line(unsigned fault)
{
    struct cagd_interval *r = fresh();
    region_faults |= fault;
    mpfr_set_inf(r->lo, -1);
    mpfr_set_inf(r->hi, +1);
    return (num_i){r};
}

num_i cagd_from_rational_i(num_q a)
{
    struct cagd_interval *r = fresh();
    mpfr_set_q(r->lo, a.at, MPFR_RNDD);
    mpfr_set_q(r->hi, a.at, MPFR_RNDU);
    return (num_i){r};
}
num_i cagd_between_i(double low, double high)
{
    if (!(low <= high))
        return whole_line(FAULT_UNDEFINED);
    struct cagd_interval *r = fresh();
    mpfr_set_d(r->lo, low, MPFR_RNDD);
    mpfr_set_d(r->hi, high, MPFR_RNDU);
    return (num_i){r};
}
num_i cagd_from_double_i(double x) { return cagd_between_i(x, x); }
num_i cagd_around_i(double x, double r) { return add_i(cagd_from_double_i(x), cagd_between_i(-r, r)); }
num_i cagd_from_int_i(long m)
{
    struct cagd_interval *r = fresh();
    mpfr_set_si(r->lo, m, MPFR_RNDD);
    mpfr_set_si(r->hi, m, MPFR_RNDU);
    return (num_i){r};
}
num_i cagd_from_ratio_i(long m, long n) { return div_i(from_int_i(m), from_int_i(n)); }

num_i cagd_add_i(num_i a, num_i b)
{
    struct cagd_interval *r = fresh();
    mpfr_add(r->lo, a.at->lo, b.at->lo, MPFR_RNDD);
    mpfr_add(r->hi, a.at->hi, b.at->hi, MPFR_RNDU);
    return (num_i){r};
}
num_i cagd_sub_i(num_i a, num_i b)
{
    struct cagd_interval *r = fresh();
    mpfr_sub(r->lo, a.at->lo, b.at->hi, MPFR_RNDD);
    mpfr_sub(r->hi, a.at->hi, b.at->lo, MPFR_RNDU);
    return (num_i){r};
}
num_i cagd_neg_i(num_i a)
{
    struct cagd_interval *r = fresh();
    mpfr_neg(r->lo, a.at->hi, MPFR_RNDD);
    mpfr_neg(r->hi, a.at->lo, MPFR_RNDU);
    return (num_i){r};
}

/* One end of a product.  0 * infinity counts as 0: infinite ends are limits only. */
static void product(mpfr_ptr r, mpfr_srcptr x, mpfr_srcptr y, mpfr_rnd_t rounding)
{
    mpfr_mul(r, x, y, rounding);
    if (mpfr_nan_p(r))
        mpfr_set_zero(r, 1);
}

/* Of a, when every point is >= 0: +1; when every point is <= 0: -1; else 0. */
static int side(num_i a) { return mpfr_sgn(a.at->lo) >= 0 ? 1 : mpfr_sgn(a.at->hi) <= 0 ? -1 : 0; }

/* The ends of a product are products of ends: which, the signs say, unless both factors have points of both. */
num_i cagd_mul_i(num_i a, num_i b)
{
    struct cagd_interval *r = fresh();
    int A = side(a), B = side(b);
    if (A == 0 && B == 0) {
        mpfr_t other;
        mpfr_init2(other, cagd_region_precision());
        product(r->lo, a.at->lo, b.at->hi, MPFR_RNDD);
        product(other, a.at->hi, b.at->lo, MPFR_RNDD);
        mpfr_min(r->lo, r->lo, other, MPFR_RNDD);
        product(r->hi, a.at->lo, b.at->lo, MPFR_RNDU);
        product(other, a.at->hi, b.at->hi, MPFR_RNDU);
        mpfr_max(r->hi, r->hi, other, MPFR_RNDU);
        mpfr_clear(other);
        return (num_i){r};
    }
    /* the lower end is the least product: of the ends of a that go with that of b, and conversely */
    mpfr_srcptr a_low = B > 0 || (B == 0 && A < 0) ? a.at->lo : a.at->hi;
    mpfr_srcptr b_low = A > 0 || (A == 0 && B < 0) ? b.at->lo : b.at->hi;
    mpfr_srcptr a_high = B > 0 || (B == 0 && A > 0) ? a.at->hi : a.at->lo;
    mpfr_srcptr b_high = A > 0 || (A == 0 && B > 0) ? b.at->hi : b.at->lo;
    product(r->lo, a_low, b_low, MPFR_RNDD);
    product(r->hi, a_high, b_high, MPFR_RNDU);
    return (num_i){r};
}
num_i cagd_div_i(num_i a, num_i b)
{
    if (mpfr_zero_p(b.at->lo) && mpfr_zero_p(b.at->hi))
        return whole_line(FAULT_UNDEFINED);
    if (contains_zero_i(b))
        return whole_line(FAULT_UNABLE);
    struct cagd_interval *r = fresh();
    int A = side(a), B = side(b);
    mpfr_srcptr a_low = B > 0 ? a.at->lo : a.at->hi, a_high = B > 0 ? a.at->hi : a.at->lo;
    /* the lower end is negative unless A = B, and then it is large where the divisor is small in size */
    mpfr_srcptr small = B > 0 ? b.at->lo : b.at->hi, large = B > 0 ? b.at->hi : b.at->lo;
    mpfr_div(r->lo, a_low, A == B ? large : small, MPFR_RNDD);
    mpfr_div(r->hi, a_high, A == 0 || A == B ? small : large, MPFR_RNDU);
    return (num_i){r};
}

num_i cagd_root_i(int n, num_i a)
{
    if (n < 1 || mpfr_sgn(a.at->hi) < 0)
        return whole_line(FAULT_UNDEFINED);
    struct cagd_interval *r = fresh();
    if (mpfr_sgn(a.at->lo) < 0) {
        region_faults |= FAULT_UNABLE;
        mpfr_set_zero(r->lo, 1);
    } else {
        mpfr_rootn_ui(r->lo, a.at->lo, (unsigned long)n, MPFR_RNDD);
    }
    mpfr_rootn_ui(r->hi, a.at->hi, (unsigned long)n, MPFR_RNDU);
    return (num_i){r};
}

num_i cagd_square_i(num_i a)
{
    struct cagd_interval *r = fresh();
    mpfr_srcptr far = mpfr_cmpabs(a.at->lo, a.at->hi) > 0 ? a.at->lo : a.at->hi;
    mpfr_srcptr near = far == a.at->lo ? a.at->hi : a.at->lo;
    mpfr_sqr(r->hi, far, MPFR_RNDU);
    if (contains_zero_i(a))
        mpfr_set_zero(r->lo, 1);
    else
        mpfr_sqr(r->lo, near, MPFR_RNDD);
    return (num_i){r};
}

num_i cagd_exp_around_i(double radius)
{
    if (!(0 <= radius && radius <= 1))
        return whole_line(FAULT_UNABLE);
    struct cagd_interval *r = fresh();
    mpfr_set_d(r->lo, radius, MPFR_RNDU);
    mpfr_ui_sub(r->lo, 1, r->lo, MPFR_RNDD);
    mpfr_set_d(r->hi, radius, MPFR_RNDU);
    mpfr_sqr(r->hi, r->hi, MPFR_RNDU);
    mpfr_add_d(r->hi, r->hi, radius, MPFR_RNDU);
    mpfr_add_ui(r->hi, r->hi, 1, MPFR_RNDU);
    return (num_i){r};
}

num_i cagd_inner_i(int dim, const num_i a[], const num_i b[])
{
    if (dim < 1)
        return from_int_i(0);
    num_i sum = mul_i(a[0], b[0]);
    for (int c = 1; c < dim; c++)
        sum = add_i(sum, mul_i(a[c], b[c]));
    return sum;
}

num_i cagd_hull_i(num_i a, num_i b)
{
    struct cagd_interval *r = fresh();
    mpfr_min(r->lo, a.at->lo, b.at->lo, MPFR_RNDD);
    mpfr_max(r->hi, a.at->hi, b.at->hi, MPFR_RNDU);
    return (num_i){r};
}
num_i cagd_nearest_in_i(num_i T, num_i a)
{
    struct cagd_interval *r = fresh();
    mpfr_max(r->lo, a.at->lo, T.at->lo, MPFR_RNDD);
    mpfr_min(r->lo, r->lo, T.at->hi, MPFR_RNDD);
    mpfr_min(r->hi, a.at->hi, T.at->hi, MPFR_RNDU);
    mpfr_max(r->hi, r->hi, T.at->lo, MPFR_RNDU);
    return (num_i){r};
}

void cagd_sums_init(int count, struct cagd_interval sum[])
{
    for (int k = 0; k < count; k++) {
        mpfr_inits2(cagd_region_precision(), sum[k].lo, sum[k].hi, (mpfr_ptr)0);
        mpfr_set_zero(sum[k].lo, 1);
        mpfr_set_zero(sum[k].hi, 1);
    }
}
void cagd_sums_clear(int count, struct cagd_interval sum[])
{
    for (int k = 0; k < count; k++)
        mpfr_clears(sum[k].lo, sum[k].hi, (mpfr_ptr)0);
}
void cagd_accumulate(struct cagd_interval *sum, num_i x)
{
    mpfr_add(sum->lo, sum->lo, x.at->lo, MPFR_RNDD);
    mpfr_add(sum->hi, sum->hi, x.at->hi, MPFR_RNDU);
}

int cagd_contains_i(num_i a, num_q x) { return mpfr_cmp_q(a.at->lo, x.at) <= 0 && mpfr_cmp_q(a.at->hi, x.at) >= 0; }
int cagd_contains_zero_i(num_i a) { return mpfr_sgn(a.at->lo) <= 0 && mpfr_sgn(a.at->hi) >= 0; }
int cagd_sign_i(num_i a) { return mpfr_sgn(a.at->lo) > 0 ? 1 : mpfr_sgn(a.at->hi) < 0 ? -1 : 0; }
double cagd_lower_i(num_i a) { return mpfr_get_d(a.at->lo, MPFR_RNDD); }
double cagd_upper_i(num_i a) { return mpfr_get_d(a.at->hi, MPFR_RNDU); }
double cagd_size_i(num_i a) { return fmax(-lower_i(a), upper_i(a)); }
double cagd_width_i(num_i a)
{
    mpfr_t w;
    mpfr_init2(w, 53);
    mpfr_sub(w, a.at->hi, a.at->lo, MPFR_RNDU);
    double v = mpfr_get_d(w, MPFR_RNDU);
    mpfr_clear(w);
    return v;
}
