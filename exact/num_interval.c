#include "exact/num_interval.h"

static struct interval *fresh(void) { return region_slot(SLOT_INTERVAL); }

static num_i whole_line(unsigned fault)
{
    struct interval *r = fresh();
    region_faults |= fault;
    mpfr_set_inf(r->lo, -1);
    mpfr_set_inf(r->hi, +1);
    return (num_i){r};
}

num_i from_rational_i(num_q a)
{
    struct interval *r = fresh();
    mpfr_set_q(r->lo, a.at, MPFR_RNDD);
    mpfr_set_q(r->hi, a.at, MPFR_RNDU);
    return (num_i){r};
}
num_i from_int_i(long m)
{
    struct interval *r = fresh();
    mpfr_set_si(r->lo, m, MPFR_RNDD);
    mpfr_set_si(r->hi, m, MPFR_RNDU);
    return (num_i){r};
}
num_i from_ratio_i(long m, long n) { return div_i(from_int_i(m), from_int_i(n)); }

num_i add_i(num_i a, num_i b)
{
    struct interval *r = fresh();
    mpfr_add(r->lo, a.at->lo, b.at->lo, MPFR_RNDD);
    mpfr_add(r->hi, a.at->hi, b.at->hi, MPFR_RNDU);
    return (num_i){r};
}
num_i sub_i(num_i a, num_i b)
{
    struct interval *r = fresh();
    mpfr_sub(r->lo, a.at->lo, b.at->hi, MPFR_RNDD);
    mpfr_sub(r->hi, a.at->hi, b.at->lo, MPFR_RNDU);
    return (num_i){r};
}
num_i neg_i(num_i a)
{
    struct interval *r = fresh();
    mpfr_neg(r->lo, a.at->hi, MPFR_RNDD);
    mpfr_neg(r->hi, a.at->lo, MPFR_RNDU);
    return (num_i){r};
}

typedef int rounded_operation(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

/* [min, max] of the four results at the endpoints: right for a product, and for a quotient whose
 * divisor does not contain 0.  A product 0 * infinity counts as 0: infinite ends are limits only. */
static num_i hull_of_corners(rounded_operation *op, num_i a, num_i b)
{
    mpfr_srcptr x[2] = {a.at->lo, a.at->hi}, y[2] = {b.at->lo, b.at->hi};
    struct interval *r = fresh();
    mpfr_t v;
    mpfr_init2(v, INTERVAL_PRECISION);
    for (int k = 0; k < 4; k++) {
        op(v, x[k & 1], y[k >> 1], MPFR_RNDD);
        if (mpfr_nan_p(v))
            mpfr_set_zero(v, 1);
        if (k == 0 || mpfr_less_p(v, r->lo))
            mpfr_set(r->lo, v, MPFR_RNDD);
        op(v, x[k & 1], y[k >> 1], MPFR_RNDU);
        if (mpfr_nan_p(v))
            mpfr_set_zero(v, 1);
        if (k == 0 || mpfr_greater_p(v, r->hi))
            mpfr_set(r->hi, v, MPFR_RNDU);
    }
    mpfr_clear(v);
    return (num_i){r};
}
num_i mul_i(num_i a, num_i b) { return hull_of_corners(mpfr_mul, a, b); }
num_i div_i(num_i a, num_i b)
{
    if (mpfr_zero_p(b.at->lo) && mpfr_zero_p(b.at->hi))
        return whole_line(FAULT_UNDEFINED);
    if (contains_zero_i(b))
        return whole_line(FAULT_UNABLE);
    return hull_of_corners(mpfr_div, a, b);
}

num_i root_i(int n, num_i a)
{
    if (n < 1 || mpfr_sgn(a.at->hi) < 0)
        return whole_line(FAULT_UNDEFINED);
    struct interval *r = fresh();
    if (mpfr_sgn(a.at->lo) < 0) {
        region_faults |= FAULT_UNABLE;
        mpfr_set_zero(r->lo, 1);
    } else {
        mpfr_rootn_ui(r->lo, a.at->lo, (unsigned long)n, MPFR_RNDD);
    }
    mpfr_rootn_ui(r->hi, a.at->hi, (unsigned long)n, MPFR_RNDU);
    return (num_i){r};
}

int contains_i(num_i a, num_q x) { return mpfr_cmp_q(a.at->lo, x.at) <= 0 && mpfr_cmp_q(a.at->hi, x.at) >= 0; }
int contains_zero_i(num_i a) { return mpfr_sgn(a.at->lo) <= 0 && mpfr_sgn(a.at->hi) >= 0; }
int sign_i(num_i a) { return mpfr_sgn(a.at->lo) > 0 ? 1 : mpfr_sgn(a.at->hi) < 0 ? -1 : 0; }
double lower_i(num_i a) { return mpfr_get_d(a.at->lo, MPFR_RNDD); }
double upper_i(num_i a) { return mpfr_get_d(a.at->hi, MPFR_RNDU); }
double width_i(num_i a)
{
    mpfr_t w;
    mpfr_init2(w, 53);
    mpfr_sub(w, a.at->hi, a.at->lo, MPFR_RNDU);
    double v = mpfr_get_d(w, MPFR_RNDU);
    mpfr_clear(w);
    return v;
}
