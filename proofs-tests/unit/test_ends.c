/* test_ends.c -- the ends of intervals against a slow form that shares nothing with exact/number/interval.c: the end of a result is
 * the least or greatest of exact rational values, rounded once by MPFR to the precision of the region. */
#include "unit_exact.h"

#include "exact/number/interval.h"
#include "exact/words.h"

#include <float.h>
#include <math.h>

/* Ends that matter: zeros, both signs, one, values of few and of many bits, huge and tiny ones. */
static const double ends[] = {-0x1.fffffffffffffp600, -1.75, -1,   -0x1p-600, 0, 0x1.8p-600, 1,
                              0x1.5555555555555p0,    3,     1e300};
enum { ENDS = sizeof ends / sizeof ends[0], MOST_VALUES = 16 };
static const long precisions[] = {2, 5, 53, 128};

static num_i interval(double low, double high)
{
    cagd_region_set_precision(2000); /* holds every double */
    num_i a = cagd_between_i(low, high);
    return a;
}

/* Exact values, of which the least and the greatest are wanted. */
struct values {
    int count;
    mpq_t value[MOST_VALUES];
};
static void begin(struct values *v) { v->count = 0; }
static mpq_ptr next(struct values *v)
{
    mpq_init(v->value[v->count]);
    return v->value[v->count++];
}
/* The interval is the hull of the values, its ends rounded outwards to `bits` bits. */
static void assert_hull(num_i r, struct values *v, long bits)
{
    int low = 0, high = 0;
    for (int k = 1; k < v->count; k++) {
        low = mpq_cmp(v->value[k], v->value[low]) < 0 ? k : low;
        high = mpq_cmp(v->value[k], v->value[high]) > 0 ? k : high;
    }
    mpfr_t end;
    mpfr_init2(end, bits);
    assert_int_equal(mpfr_get_prec(r.at->lo), bits);
    assert_int_equal(mpfr_get_prec(r.at->hi), bits);
    mpfr_set_q(end, v->value[low], MPFR_RNDD);
    assert_true(mpfr_equal_p(end, r.at->lo));
    mpfr_set_q(end, v->value[high], MPFR_RNDU);
    assert_true(mpfr_equal_p(end, r.at->hi));
    mpfr_clear(end);
    for (int k = 0; k < v->count; k++)
        mpq_clear(v->value[k]);
}
static void add_value(struct values *v, double x) { mpq_set_d(next(v), x); }

/* Every operation of two operands on all intervals between these ends. */
static void two_operands(double a, double b, double c, double d)
{
    for (size_t p = 0; p < sizeof precisions / sizeof precisions[0]; p++) {
        region_mark m = region_open();
        num_i x = interval(a, b), y = interval(c, d);
        const double X[2] = {a, b}, Y[2] = {c, d};
        cagd_region_set_precision(precisions[p]);
        mpq_t s, t;
        mpq_inits(s, t, (mpq_ptr)0);
        struct values sums, differences, products, quotients;
        begin(&sums), begin(&differences), begin(&products), begin(&quotients);
        int has_zero = c <= 0 && d >= 0;
        for (int i = 0; i < 2; i++)
            for (int j = 0; j < 2; j++) {
                mpq_set_d(s, X[i]), mpq_set_d(t, Y[j]);
                mpq_add(next(&sums), s, t);
                mpq_sub(next(&differences), s, t);
                mpq_mul(next(&products), s, t);
                if (!has_zero)
                    mpq_div(next(&quotients), s, t);
            }
        assert_hull(add_i(x, y), &sums, precisions[p]);
        assert_hull(sub_i(x, y), &differences, precisions[p]);
        assert_hull(mul_i(x, y), &products, precisions[p]);
        if (!has_zero) {
            assert_hull(div_i(x, y), &quotients, precisions[p]);
        } else {
            num_i line = div_i(x, y);
            assert_true(mpfr_inf_p(line.at->lo) && mpfr_sgn(line.at->lo) < 0);
            assert_true(mpfr_inf_p(line.at->hi) && mpfr_sgn(line.at->hi) > 0);
            expect_fault(c == 0 && d == 0 ? FAULT_UNDEFINED : FAULT_UNABLE);
        }
        struct values both;
        begin(&both);
        add_value(&both, a), add_value(&both, b), add_value(&both, c), add_value(&both, d);
        assert_hull(cagd_hull_i(x, y), &both, precisions[p]);
        mpq_clears(s, t, (mpq_ptr)0);
        region_drop(m);
    }
}
static void operations_of_two(void **state)
{
    (void)state;
    for (int a = 0; a < ENDS; a++)
        for (int b = a; b < ENDS; b++)
            for (int c = 0; c < ENDS; c++)
                for (int d = c; d < ENDS; d++)
                    two_operands(ends[a], ends[b], ends[c], ends[d]);
}

/* The points of T nearest to those of x, for ends that two bits hold exactly. */
static void nearest_points(void **state)
{
    (void)state;
    for (int a = -3; a <= 3; a++)
        for (int b = a; b <= 3; b++)
            for (int c = -3; c <= 3; c++)
                for (int d = c; d <= 3; d++) {
                    region_mark m = region_open();
                    num_i r = cagd_nearest_in_i(interval(a, b), interval(c, d));
                    double low = c < a ? a : c > b ? b : c, high = d < a ? a : d > b ? b : d;
                    assert_true(mpfr_cmp_d(r.at->lo, low) == 0 && mpfr_cmp_d(r.at->hi, high) == 0);
                    region_drop(m);
                }
}

/* The ends of T have more bits than the result: that goes outward, whichever end is taken twice. */
static void nearest_points_of_finer_ends(void **state)
{
    (void)state;
    cagd_region_set_precision(300);
    num_i T = from_ratio_i(1, 3);
    cagd_region_set_precision(60);
    for (int far = -1; far <= 1; far++) {
        num_i r = cagd_nearest_in_i(T, from_int_i(far));
        if (far < 1)
            assert_true(mpfr_cmp(r.at->lo, T.at->lo) <= 0 && mpfr_cmp(T.at->lo, r.at->hi) <= 0);
        else
            assert_true(mpfr_cmp(r.at->lo, T.at->hi) <= 0 && mpfr_cmp(T.at->hi, r.at->hi) <= 0);
    }
}

/* Every end is rounded once and outward, to few bits as to many. */
static void nearest_points_are_rounded_outward(void **state)
{
    (void)state;
    for (int code = 0; code < 625; code++)
        for (int p = 0; p < 4; p++) {
            region_mark m = region_open();
            const int place[4] = {code % 5, code / 5 % 5, code / 25 % 5, code / 125};
            num_i end[4];
            cagd_region_set_precision(300);
            for (int k = 0; k < 4; k++)
                end[k] = from_ratio_i(3 * place[k] - 5 + k, 7 + 2 * k);
            num_i T = cagd_hull_i(end[0], end[1]), a = cagd_hull_i(end[2], end[3]);
            cagd_region_set_precision(precisions[p]);
            num_i r = cagd_nearest_in_i(T, a);
            mpfr_srcptr low = a.at->lo, high = a.at->hi;
            low = mpfr_less_p(low, T.at->lo) ? T.at->lo : mpfr_greater_p(low, T.at->hi) ? T.at->hi : low;
            high = mpfr_less_p(high, T.at->lo) ? T.at->lo : mpfr_greater_p(high, T.at->hi) ? T.at->hi : high;
            mpfr_t rounded;
            mpfr_init2(rounded, precisions[p]);
            mpfr_set(rounded, low, MPFR_RNDD);
            assert_true(mpfr_equal_p(rounded, r.at->lo));
            mpfr_set(rounded, high, MPFR_RNDU);
            assert_true(mpfr_equal_p(rounded, r.at->hi));
            mpfr_clear(rounded);
            region_drop(m);
        }
}

static void operations_of_one(void **state)
{
    (void)state;
    for (int a = 0; a < ENDS; a++)
        for (int b = a; b < ENDS; b++)
            for (size_t p = 0; p < sizeof precisions / sizeof precisions[0]; p++) {
                region_mark m = region_open();
                long bits = precisions[p];
                num_i x = interval(ends[a], ends[b]);
                cagd_region_set_precision(bits);
                struct values v;
                begin(&v);
                add_value(&v, -ends[a]), add_value(&v, -ends[b]);
                assert_hull(neg_i(x), &v, bits);
                begin(&v);
                mpq_t s;
                mpq_init(s);
                mpq_set_d(s, ends[a]), mpq_mul(next(&v), s, s);
                mpq_set_d(s, ends[b]), mpq_mul(next(&v), s, s);
                if (ends[a] <= 0 && ends[b] >= 0)
                    add_value(&v, 0);
                assert_hull(cagd_square_i(x), &v, bits);
                begin(&v);
                add_value(&v, ends[a]), add_value(&v, ends[b]);
                assert_hull(cagd_between_i(ends[a], ends[b]), &v, bits);
                begin(&v);
                add_value(&v, ends[a]);
                assert_hull(cagd_from_double_i(ends[a]), &v, bits);
                begin(&v);
                mpq_set(next(&v), (mpq_set_ui(s, 355 + (unsigned)a, 113 + (unsigned)b), mpq_canonicalize(s), s));
                assert_hull(cagd_from_rational_i(from_mpq_q(s)), &v, bits);
                begin(&v);
                long whole = 123456789L * (a - 4) + b;
                mpq_set_si(next(&v), whole, 1);
                assert_hull(from_int_i(whole), &v, bits);
                /* a sum of exact ends */
                struct cagd_interval sum[2];
                cagd_region_set_precision(4000);
                cagd_sums_init(2, sum);
                cagd_accumulate(&sum[1], x), cagd_accumulate(&sum[1], x);
                assert_true(mpfr_zero_p(sum[0].lo) && mpfr_zero_p(sum[0].hi));
                begin(&v);
                mpq_set_d(s, ends[a]), mpq_add(next(&v), s, s);
                mpq_set_d(s, ends[b]), mpq_add(next(&v), s, s);
                assert_hull((num_i){&sum[1]}, &v, 4000);
                cagd_sums_clear(2, sum);
                /* and one that is rounded at every step */
                cagd_region_set_precision(2);
                cagd_sums_init(1, sum);
                cagd_accumulate(&sum[0], x), cagd_accumulate(&sum[0], interval(1, 1));
                mpfr_t low, high;
                mpfr_inits2(2, low, high, (mpfr_ptr)0);
                mpfr_set_d(low, ends[a], MPFR_RNDD), mpfr_add_ui(low, low, 1, MPFR_RNDD);
                mpfr_set_d(high, ends[b], MPFR_RNDU), mpfr_add_ui(high, high, 1, MPFR_RNDU);
                assert_true(mpfr_equal_p(low, sum[0].lo) && mpfr_equal_p(high, sum[0].hi));
                mpfr_clears(low, high, (mpfr_ptr)0);
                cagd_sums_clear(1, sum);
                mpq_clear(s);
                region_drop(m);
            }
}

/* l^n <= a < (the number after l)^n at the lower end, and so on above. */
static void roots(void **state)
{
    (void)state;
    for (int n = 1; n <= 5; n++)
        for (int a = 0; a < ENDS; a++)
            for (int b = a; b < ENDS; b++)
                for (size_t p = 0; p < sizeof precisions / sizeof precisions[0]; p++) {
                    region_mark m = region_open();
                    num_i x = interval(ends[a], ends[b]);
                    cagd_region_set_precision(precisions[p]);
                    num_i r = root_i(n, x);
                    if (ends[b] < 0) {
                        expect_fault(FAULT_UNDEFINED);
                        assert_true(mpfr_inf_p(r.at->lo) && mpfr_inf_p(r.at->hi));
                        region_drop(m);
                        continue;
                    }
                    double low = ends[a] < 0 ? 0 : ends[a];
                    if (ends[a] < 0)
                        expect_fault(FAULT_UNABLE);
                    mpfr_t power, near;
                    mpfr_init2(power, 20000), mpfr_init2(near, precisions[p]);
                    mpfr_pow_ui(power, r.at->lo, (unsigned long)n, MPFR_RNDN);
                    assert_true(mpfr_cmp_d(power, low) <= 0);
                    mpfr_set(near, r.at->lo, MPFR_RNDN), mpfr_nextabove(near);
                    mpfr_pow_ui(power, near, (unsigned long)n, MPFR_RNDN);
                    assert_true(low > 0 ? mpfr_cmp_d(power, low) > 0 : mpfr_zero_p(r.at->lo));
                    mpfr_pow_ui(power, r.at->hi, (unsigned long)n, MPFR_RNDN);
                    assert_true(mpfr_cmp_d(power, ends[b]) >= 0);
                    if (ends[b] > 0) {
                        mpfr_set(near, r.at->hi, MPFR_RNDN), mpfr_nextbelow(near);
                        mpfr_pow_ui(power, near, (unsigned long)n, MPFR_RNDN);
                        assert_true(mpfr_cmp_d(power, ends[b]) < 0);
                    }
                    mpfr_clears(power, near, (mpfr_ptr)0);
                    region_drop(m);
                }
    root_i(0, interval(1, 1));
    expect_fault(FAULT_UNDEFINED);
}

static void what_is_asked(void **state)
{
    (void)state;
    for (int a = 0; a < ENDS; a++)
        for (int b = a; b < ENDS; b++) {
            region_mark m = region_open();
            num_i x = interval(ends[a], ends[b]);
            assert_int_equal(sign_i(x), ends[a] > 0 ? 1 : ends[b] < 0 ? -1 : 0);
            assert_int_equal(contains_zero_i(x), ends[a] <= 0 && ends[b] >= 0);
            for (int c = 0; c < ENDS; c++)
                assert_int_equal(contains_i(x, from_double_q(ends[c])), a <= c && c <= b);
            assert_true(lower_i(x) == ends[a] && upper_i(x) == ends[b]);
            assert_true(cagd_size_i(x) == fmax(fabs(ends[a]), fabs(ends[b])));
            mpq_t width, told;
            mpq_inits(width, told, (mpq_ptr)0);
            mpq_set_d(width, ends[b]), mpq_set_d(told, ends[a]), mpq_sub(width, width, told);
            if (isfinite(width_i(x))) {
                mpq_set_d(told, width_i(x));
                assert_true(mpq_cmp(told, width) >= 0);
                if (width_i(x) > 0) {
                    mpq_set_d(told, nextafter(width_i(x), 0));
                    assert_true(mpq_cmp(told, width) < 0);
                }
            }
            mpq_clears(width, told, (mpq_ptr)0);
            region_drop(m);
        }
    cagd_region_set_precision(128);
    num_i third = from_ratio_i(1, 3); /* ends that are no doubles are rounded outwards */
    assert_true(lower_i(third) < upper_i(third) && nextafter(lower_i(third), 1) == upper_i(third));
    assert_true(contains_i(third, from_ratio_q(1, 3)) && width_i(third) < 0x1p-126);
    cagd_between_i(1, 0);
    expect_fault(FAULT_UNDEFINED);
    region_faults = FAULT_CROWDED; /* a fault that was set stays */
    cagd_between_i(NAN, 0);
    expect_fault(FAULT_CROWDED | FAULT_UNDEFINED);
    region_faults = FAULT_CROWDED;
    root_i(2, cagd_between_i(-1, 1));
    expect_fault(FAULT_CROWDED | FAULT_UNABLE);
}

/* Products with infinite ends: 0 times infinity is 0, since the ends are limits. */
static void infinite_ends(void **state)
{
    (void)state;
    num_i line = cagd_between_i(-INFINITY, INFINITY), above = cagd_between_i(2, INFINITY), zero = from_int_i(0);
    num_i r = mul_i(line, zero);
    assert_true(mpfr_zero_p(r.at->lo) && mpfr_zero_p(r.at->hi));
    r = mul_i(above, cagd_between_i(0, 3));
    assert_true(mpfr_zero_p(r.at->lo) && mpfr_inf_p(r.at->hi));
    r = mul_i(above, cagd_between_i(-3, 0));
    assert_true(mpfr_inf_p(r.at->lo) && mpfr_sgn(r.at->lo) < 0 && mpfr_zero_p(r.at->hi));
    r = mul_i(line, cagd_between_i(-1, 5));
    assert_true(mpfr_inf_p(r.at->lo) && mpfr_inf_p(r.at->hi));
    r = div_i(from_int_i(1), above);
    assert_true(mpfr_zero_p(r.at->lo) && mpfr_cmp_d(r.at->hi, 0.5) == 0);
}

static void others(void **state)
{
    (void)state;
    for (int k = 0; k <= 240; k++) {
        region_mark m = region_open();
        /* of few bits, of more than the precision has, and such that all sums are exact */
        double radius = k > 200 ? 1 - ldexp(1, 200 - k) : k == 200 ? 1 : k % 4 < 2 ? k * 0x1.1p-8 : k / 207.0;
        cagd_region_set_precision(k % 2 ? 128 : 24);
        num_i around = cagd_exp_around_i(radius);
        mpfr_t e;
        mpfr_init2(e, 300);
        mpfr_set_d(e, -radius, MPFR_RNDN), mpfr_exp(e, e, MPFR_RNDN);
        assert_true(mpfr_cmp(around.at->lo, e) <= 0);
        mpfr_set_d(e, radius, MPFR_RNDN), mpfr_exp(e, e, MPFR_RNDN);
        assert_true(mpfr_cmp(around.at->hi, e) >= 0);
        mpq_t low, high, r;
        mpq_inits(low, high, r, (mpq_ptr)0);
        mpq_set_d(r, radius);
        mpq_set_ui(low, 1, 1), mpq_sub(low, low, r);
        mpq_mul(high, r, r), mpq_add(high, high, r), mpq_set_ui(r, 1, 1), mpq_add(high, high, r);
        assert_true(mpfr_cmp_q(around.at->lo, low) <= 0 && mpfr_cmp_q(around.at->hi, high) >= 0);
        assert_true(lower_i(around) >= 1 - radius - 0x1p-20 &&
                    upper_i(around) <= 1 + radius + radius * radius + 0x1p-20);
        mpq_clears(low, high, r, (mpq_ptr)0);
        mpfr_clear(e);
        cagd_region_set_precision(128);
        radius = k >= 200 ? radius : k * 0x1.1p-8;
        num_i x = cagd_around_i(1.5, radius);
        assert_true(contains_i(x, from_double_q(1.5 - radius)) && contains_i(x, from_double_q(1.5 + radius)));
        assert_true(lower_i(x) == 1.5 - radius && upper_i(x) == 1.5 + radius);
        region_drop(m);
    }
    const double outside[] = {-0x1p-1074, 1 + DBL_EPSILON, NAN, INFINITY};
    for (int k = 0; k < 4; k++) {
        num_i line = cagd_exp_around_i(outside[k]);
        expect_fault(FAULT_UNABLE);
        assert_true(mpfr_inf_p(line.at->lo) && mpfr_inf_p(line.at->hi));
    }
    num_i a[3] = {cagd_between_i(-1, 2), cagd_between_i(3, 5), cagd_between_i(-7, -4)};
    num_i b[3] = {cagd_between_i(2, 3), cagd_between_i(-1, 1), cagd_between_i(10, 11)};
    num_i none = cagd_inner_i(0, a, b), one = cagd_inner_i(1, a, b), three = cagd_inner_i(3, a, b);
    assert_true(mpfr_zero_p(none.at->lo) && mpfr_zero_p(none.at->hi));
    assert_true(lower_i(one) == -3 && upper_i(one) == 6);
    assert_true(lower_i(three) == -3 - 5 - 77 && upper_i(three) == 6 + 5 - 40);
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(operations_of_two),
                                       unit(nearest_points),
                                       unit(nearest_points_of_finer_ends),
                                       unit(nearest_points_are_rounded_outward),
                                       unit(operations_of_one),
                                       unit(roots),
                                       unit(what_is_asked),
                                       unit(infinite_ends),
                                       unit(others)};
    return run_unit_tests(tests);
}
