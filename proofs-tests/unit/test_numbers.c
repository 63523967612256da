/* test_numbers.c -- the number types d m q i f: laws, enclosures, bounds, faults, texts, rounding. */
#include "unit_exact.h"

#include "core/number/num_measured.h"
#include "exact/number/field.h"
#include "exact/number/interval.h"
#include "exact/words.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LAWS = 15, LAWS_OF_BINARY64 = 6 };

#define G(name) name##_d
#include "laws.tmpl.h"
#undef G
#define G(name) name##_m
#include "laws.tmpl.h"
#undef G
#define G(name) name##_q
#include "laws.tmpl.h"
#undef G
#define G(name) name##_i
#include "laws.tmpl.h"
#undef G
#define G(name) name##_f
#include "laws.tmpl.h"
#undef G

static num_q q(long m) { return from_int_q(m); }
static num_q power_of_two(int e)
{
    mpq_t x;
    mpq_init(x);
    mpq_set_ui(x, 1, 1);
    if (e < 0)
        mpq_div_2exp(x, x, (mp_bitcnt_t)-e);
    else
        mpq_mul_2exp(x, x, (mp_bitcnt_t)e);
    num_q r = from_mpq_q(x);
    mpq_clear(x);
    return r;
}
static double random_double(void) { return (double)random_int(-999999937, 999999937) / 1048573.0 + 0x1p-20; }

static void laws_of_the_rationals(void **state)
{
    (void)state;
    for (int k = 0; k < 300; k++) {
        region_mark m = region_open();
        num_q left[LAWS], right[LAWS];
        laws_q(random_q(), random_q(), random_q(), left, right);
        for (int law = 0; law < LAWS; law++)
            assert_true(cagd_equal_q(left[law], right[law]));
        region_drop(m);
    }
}

/* Elements of Q(s,t): quotients of random polynomials. */
static num_f random_f(void)
{
    num_f s = variable_f("s"), t = variable_f("t"), p[2];
    for (int k = 0; k < 2; k++) {
        p[k] = from_rational_f(random_q());
        for (int j = random_int(1, 3); j > 0; j--)
            p[k] = add_f(mul_f(p[k], j % 2 ? s : t), from_rational_f(random_q()));
    }
    return div_f(p[0], p[1]);
}
static void laws_of_the_field(void **state)
{
    (void)state;
    field_open(2);
    for (int k = 0; k < 30; k++) {
        region_mark m = region_open();
        num_f left[LAWS], right[LAWS];
        laws_f(random_f(), random_f(), random_f(), left, right);
        for (int law = 0; law < LAWS; law++)
            assert_true(cagd_is_zero_f(sub_f(left[law], right[law])));
        region_drop(m);
    }
}

/* Both sides contain the exact rational, and are not much wider than it needs. */
static void laws_of_intervals(void **state)
{
    (void)state;
    for (int k = 0; k < 300; k++) {
        region_mark m = region_open();
        num_q a = random_q(), b = random_q(), c = random_q(), exact[LAWS], same[LAWS];
        num_i left[LAWS], right[LAWS];
        laws_q(a, b, c, exact, same);
        laws_i(from_rational_i(a), from_rational_i(b), from_rational_i(c), left, right);
        for (int law = 0; law < LAWS; law++) {
            assert_true(contains_i(left[law], exact[law]) && contains_i(right[law], exact[law]));
            assert_true(width_i(left[law]) <= 0x1p-60 * (1 + fabs(to_double_q(mul_q(a, mul_q(b, c))))));
        }
        region_drop(m);
    }
}

/* |v - exact| <= bound. */
static void assert_within_bound(num_m x, num_q exact)
{
    double bound = error_bound_m(x);
    assert_true(bound >= 0);
    if (isfinite(bound) && isfinite(x.v)) {
        num_q error = sub_q(from_double_q(x.v), exact), most = from_double_q(bound);
        assert_true(cagd_compare_q(error, most) <= 0 && cagd_compare_q(neg_q(error), most) <= 0);
    }
}

static void laws_of_measured_and_plain_binary64(void **state)
{
    (void)state;
    int bounded = 0;
    for (int k = 0; k < 300; k++) {
        region_mark m = region_open();
        double x[3] = {random_double(), random_double(), random_double()};
        num_q exact[LAWS], same[LAWS];
        num_m left[LAWS], right[LAWS];
        num_d plain[LAWS], other[LAWS];
        laws_q(from_double_q(x[0]), from_double_q(x[1]), from_double_q(x[2]), exact, same);
        laws_m(exact_m(x[0]), exact_m(x[1]), exact_m(x[2]), left, right);
        laws_d(x[0], x[1], x[2], plain, other);
        for (int law = 0; law < LAWS; law++) {
            assert_within_bound(left[law], exact[law]);
            assert_within_bound(right[law], exact[law]);
            assert_memory_equal(&left[law].v, &plain[law], sizeof(double)); /* bit for bit */
            assert_memory_equal(&right[law].v, &other[law], sizeof(double));
            if (law < LAWS_OF_BINARY64)
                assert_memory_equal(&plain[law], &other[law], sizeof(double));
            bounded += isfinite(error_bound_m(left[law]));
        }
        region_drop(m);
    }
    assert_int_equal(bounded, 300 * LAWS);
}

/* One long program in four arithmetics: the exact result is where the other three say. */
static void enclosures_and_bounds_of_long_programs(void **state)
{
    (void)state;
    int finite = 0;
    for (int k = 0; k < 200; k++) {
        region_mark m = region_open();
        unsigned char code[24];
        num_d d[4];
        num_m e[4];
        num_q x[4];
        num_i y[4];
        for (int s = 0; s < 24; s++)
            code[s] = (unsigned char)random_int(0, 255);
        for (int r = 0; r < 4; r++) {
            d[r] = random_double();
            e[r] = exact_m(d[r]);
            x[r] = from_double_q(d[r]);
            y[r] = from_rational_i(x[r]);
        }
        int steps = random_int(6, 24);
        program_d(steps, code, d);
        program_m(steps, code, e);
        program_q(steps, code, x);
        program_i(steps, code, y);
        for (int r = 0; r < 4; r++) {
            assert_memory_equal(&d[r], &e[r].v, sizeof(double));
            assert_within_bound(e[r], x[r]);
            finite += isfinite(error_bound_m(e[r]));
            if (region_faults == 0) /* a square that may be 0 makes an interval unable */
                assert_true(contains_i(y[r], x[r]));
        }
        region_faults &= ~(unsigned)FAULT_UNABLE;
        region_drop(m);
    }
    assert_true(finite > 400);
}

/* The same program on variables; then numbers are put in for them. */
static void a_proof_specialises_to_every_value(void **state)
{
    (void)state;
    for (int k = 0; k < 40; k++) {
        region_mark m = region_open();
        field_open(2);
        unsigned char code[5];
        for (int s = 0; s < 5; s++)
            code[s] = (unsigned char)random_int(0, 255);
        num_f t = variable_f("t"), w = variable_f("w"), f[4] = {t, w, from_ratio_f(5, 3), add_f(t, w)};
        num_q x = random_q(), y = random_q(), r[4] = {x, y, from_ratio_q(5, 3), add_q(x, y)}, value;
        program_f(5, code, f);
        program_q(5, code, r);
        for (int i = 0; i < 4; i++) {
            num_f at = substitute_f(substitute_f(f[i], t, from_rational_f(x)), w, from_rational_f(y));
            assert_true(is_constant_f(at, &value) && cagd_equal_q(value, r[i]));
        }
        region_drop(m);
    }
}

static void floors(void **state)
{
    (void)state;
    static const struct {
        const char *a;
        long floor;
    } list[] = {{"0", 0},     {"3", 3},   {"-3", -3},   {"7/2", 3},
                {"-7/2", -4}, {"1/3", 0}, {"-1/3", -1}, {"0.999999999999999999999", 0}};
    region_mark m = region_open();
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        assert_true(cagd_equal_q(cagd_floor_q(from_string_q(list[k].a)), from_int_q(list[k].floor)));
    region_drop(m);
}

static void roots(void **state)
{
    (void)state;
    for (int k = 0; k < 200; k++) {
        region_mark m = region_open();
        num_q a = random_q(), square = mul_q(a, a), r = root_q(2, square);
        assert_true(cagd_equal_q(mul_q(r, r), square) && cagd_sign_q(r) >= 0);
        num_i s = root_i(2, from_rational_i(square));
        assert_true(contains_i(s, r));
        num_i third = root_i(3, from_rational_i(mul_q(square, square)));
        assert_true(contains_i(mul_i(third, mul_i(third, third)), mul_q(square, square)));
        double x = fabs(random_double());
        num_m root = root_m(2, exact_m(x * x));
        num_i true_root = root_i(2, from_rational_i(from_double_q(x * x)));
        num_q error = sub_q(from_double_q(root.v), from_double_q(lower_i(true_root)));
        assert_true(fabs(to_double_q(error)) <= error_bound_m(root) + (upper_i(true_root) - lower_i(true_root)));
        region_drop(m);
    }
    root_q(2, q(2));
    expect_fault(FAULT_UNABLE);
    root_q(2, from_ratio_q(1, 2)); /* of the denominator alone there is none */
    expect_fault(FAULT_UNABLE);
    root_q(2, q(-1));
    expect_fault(FAULT_UNABLE);
    for (int n = 1; n <= 5; n++) { /* of rationals below 0 there is none, odd or not */
        root_q(n, q(-1));
        expect_fault(FAULT_UNABLE);
        root_q(n, from_ratio_q(-32, 243));
        expect_fault(FAULT_UNABLE);
    }
    root_q(0, q(1));
    expect_fault(FAULT_UNABLE);
    root_q(-2, q(1));
    expect_fault(FAULT_UNABLE);
    assert_true(cagd_equal_q(root_q(5, from_ratio_q(32, 243)), from_ratio_q(2, 3)));
    assert_true(cagd_is_zero_q(root_q(3, q(0))) && cagd_equal_q(root_q(1, q(7)), q(7)));
    root_i(2, from_int_i(-1));
    expect_fault(FAULT_UNDEFINED);
    field_open(2);
    num_f t = variable_f("t"), u = sub_f(t, from_ratio_f(1, 3)), r = root_f(2, div_f(mul_f(u, u), mul_f(t, t)));
    assert_true(cagd_is_zero_f(sub_f(mul_f(r, r), div_f(mul_f(u, u), mul_f(t, t)))));
    num_f cube = mul_f(mul_f(t, t), mul_f(t, mul_f(u, mul_f(u, u))));
    assert_true(cagd_is_zero_f(sub_f(root_f(3, mul_f(from_int_f(-8), cube)), mul_f(from_int_f(-2), mul_f(t, u)))));
    assert_true(cagd_is_zero_f(root_f(3, from_int_f(0))));
    num_f no_power[] = {t, neg_f(mul_f(t, t)), mul_f(from_int_f(2), mul_f(t, t)), mul_f(u, mul_f(t, t))};
    for (int k = 0; k < 4; k++) {
        root_f(2, no_power[k]);
        expect_fault(FAULT_UNABLE);
    }
    assert_true(error_bound_m(root_m(3, exact_m(2))) > DBL_MAX);
}

/* An unbounded error times an exact 0 is still no bound. */
static void no_bound_is_infinite(void **state)
{
    (void)state;
    num_m wild = div_m(exact_m(1), sub_m(exact_m(0.1), exact_m(0.1)));
    assert_true(error_bound_m(wild) > DBL_MAX);
    assert_true(error_bound_m(mul_m(wild, exact_m(0))) > DBL_MAX);
    assert_true(error_bound_m(sub_m(wild, wild)) > DBL_MAX);
    assert_true(error_bound_m(div_m(exact_m(0), wild)) > DBL_MAX);
}

static void faults_stick(void **state)
{
    (void)state;
    div_q(q(1), q(0));
    assert_int_equal(region_faults, FAULT_UNDEFINED);
    root_q(2, q(3));
    add_q(q(1), q(1));
    expect_fault(FAULT_UNDEFINED | FAULT_UNABLE);
    from_ratio_q(1, 0);
    expect_fault(FAULT_UNDEFINED);
    from_double_q(HUGE_VAL);
    expect_fault(FAULT_UNDEFINED);
    from_double_q(NAN);
    expect_fault(FAULT_UNDEFINED);
    div_i(from_int_i(1), from_int_i(0));
    expect_fault(FAULT_UNDEFINED);
    num_i third = from_ratio_i(1, 3), zero = sub_i(third, third); /* 0 and its neighbours */
    num_i line = div_i(from_int_i(1), zero);
    expect_fault(FAULT_UNABLE);
    assert_true(contains_i(line, random_q()));
    assert_int_equal(sign_i(zero), 0);
    assert_int_equal(sign_i(third), 1);
    assert_int_equal(sign_i(neg_i(third)), -1);

    field_open(2);
    num_f t = variable_f("t"), w = variable_f("w"), zero_f = sub_f(t, t);
    div_f(t, zero_f);
    expect_fault(FAULT_UNDEFINED);
    from_ratio_f(1, 0);
    expect_fault(FAULT_UNDEFINED);
    substitute_f(div_f(w, t), t, from_int_f(0));
    expect_fault(FAULT_UNDEFINED);
    derivative_f(t, add_f(t, w));
    expect_fault(FAULT_UNDEFINED);
    assert_int_equal(degree_f(t, mul_f(t, t)), -1);
    expect_fault(FAULT_UNDEFINED);
    num_f third_variable = variable_f("v");
    assert_int_equal(region_faults, FAULT_CROWDED);
    div_f(t, third_variable); /* the placeholder is 0; that is no news */
    denominator_degree_f(t, third_variable);
    expect_fault(FAULT_CROWDED);
    variable_f("a_name_that_is_too_long");
    expect_fault(FAULT_UNABLE);
    field_open(FIELD_MAX_VARIABLES + 1);
    expect_fault(FAULT_UNABLE);
}

static void the_field_calculates(void **state)
{
    (void)state;
    field_open(2);
    num_f t = variable_f("t"), w = variable_f("w"), value;
    num_f a = div_f(add_f(mul_f(t, t), w), sub_f(t, w)); /* (t^2 + w)/(t - w) */
    /* the quotient rule by hand */
    num_f slope =
        div_f(sub_f(sub_f(mul_f(t, t), mul_f(from_int_f(2), mul_f(t, w))), w), mul_f(sub_f(t, w), sub_f(t, w)));
    assert_true(cagd_is_zero_f(sub_f(derivative_f(a, t), slope)));
    assert_int_equal(degree_f(a, t), 2);
    assert_int_equal(denominator_degree_f(a, w), 1);
    assert_int_equal(degree_f(sub_f(a, a), t), -1);
    for (int k = 0; k < 20; k++) {
        num_q x = random_q(), y = random_q(), v;
        value = substitute_f(substitute_f(a, t, from_rational_f(x)), w, from_rational_f(y));
        assert_true(is_constant_f(value, &v));
        assert_true(cagd_equal_q(v, div_q(add_q(mul_q(x, x), y), sub_q(x, y))));
    }
    assert_false(is_constant_f(a, NULL));
    assert_string_equal(to_string_f(sub_f(t, t)), "0");
    assert_string_equal(to_string_f(div_f(neg_f(t), from_int_f(4))), "-t/4");
    assert_string_equal(to_string_f(div_f(from_int_f(1), mul_f(from_int_f(4), t))), "1/(4*t)");
    assert_string_equal(to_string_f(div_f(add_f(t, from_int_f(1)), mul_f(t, t))), "(t+1)/t^2");
    assert_string_equal(to_string_f(from_ratio_f(-1, 3)), "-1/3");
    assert_string_equal(to_string_f(div_f(sub_f(t, w), mul_f(from_int_f(2), t))), "(t-w)/(2*t)");
    assert_int_equal(field_variable_f(variable_f("w")), 1);
    assert_int_equal(field_variable_f(a), -1);
}

static void texts_are_read_exactly(void **state)
{
    (void)state;
    struct {
        const char *text;
        long m, n;
    } good[] = {{"3", 3, 1},          {"-3/7", -3, 7},   {"+6/4", 3, 2},     {"0.1", 1, 10},      {"-.5", -1, 2},
                {"5.", 5, 1},         {"1e-3", 1, 1000}, {"2.5E+2", 250, 1}, {"0x1.8p-3", 3, 16}, {"0x10", 16, 1},
                {"-0X.8P1", -1, 1},   {"0xfF", 255, 1},  {"0", 0, 1},        {"-0", 0, 1},        {"0e99999", 0, 1},
                {"00012/0008", 3, 2}, {"0x1e2", 482, 1}, {"1e0", 1, 1},      {"0/5", 0, 1},       {"12.50", 25, 2}};
    for (size_t k = 0; k < sizeof good / sizeof good[0]; k++) {
        assert_true(cagd_equal_q(from_string_q(good[k].text), from_ratio_q(good[k].m, good[k].n)));
        assert_int_equal(region_faults, 0);
    }
    const char *bad[] = {"",
                         "-",
                         "+",
                         " 1",
                         "1 ",
                         "1/",
                         "/2",
                         "1/0",
                         "1/-2",
                         "1/2/3",
                         ".",
                         "1.2.3",
                         "e5",
                         "1e",
                         "1e+",
                         "1e 5",
                         "0x",
                         "0x.",
                         "0xg",
                         "0x1p",
                         "--1",
                         "+-1",
                         "1,5",
                         "nan",
                         "inf",
                         "1e100000",
                         "1e-100000",
                         "1e-99999999999999999999",
                         "1e9223372036854775807",
                         "1p3",
                         "1.5/2",
                         "1/2.5",
                         "0x1/2",
                         "1/0x2",
                         "1_0",
                         "１"};
    for (size_t k = 0; k < sizeof bad / sizeof bad[0]; k++) {
        from_string_q(bad[k]);
        expect_fault(FAULT_UNDEFINED);
    }
    for (int k = 0; k < 100; k++) { /* there and back */
        num_q a = mul_q(random_q(), random_q());
        assert_true(cagd_equal_q(from_string_q(to_string_q(a)), a));
        char text[64];
        double x = ldexp(random_double(), random_int(-1060, 900));
        snprintf(text, sizeof text, "%a", x);
        assert_true(cagd_equal_q(from_string_q(text), from_double_q(x)));
    }
    for (int length = 1; length <= 40; length++) { /* nines, and F's: powers of 10 and 16 less 1 */
        char nines[44], sixteens[44] = "0x";
        num_q ten = from_int_q(1), sixteen = from_int_q(1);
        memset(nines, '9', (size_t)length), memset(sixteens + 2, 'f', (size_t)length);
        nines[length] = sixteens[length + 2] = '\0';
        for (int k = 0; k < length; k++)
            ten = mul_q(ten, from_int_q(10)), sixteen = mul_q(sixteen, from_int_q(16));
        assert_true(cagd_equal_q(from_string_q(nines), sub_q(ten, from_int_q(1))));
        assert_true(cagd_equal_q(from_string_q(sixteens), sub_q(sixteen, from_int_q(1))));
    }
    static char below[100004] = "1/";
    char *const digits = below + 2;
    memset(digits, '7', 100001);
    for (int length = 100001; length >= 99999; length--) { /* 99999 are read, and no more, also as a denominator */
        digits[length] = '\0';
        for (int k = 0; k < 2; k++) {
            num_q a = from_string_q(k == 0 ? digits : below);
            if (length > 99999)
                expect_fault(FAULT_UNDEFINED);
            else
                assert_int_equal(strlen(to_string_q(a)), length + 2 * k);
        }
    }
    num_q repeated = div_q(mul_q(from_int_q(7), sub_q(from_string_q("1e99999"), from_int_q(1))), from_int_q(9));
    assert_true(cagd_equal_q(from_string_q(digits), repeated));
    for (int behind = 99999; behind <= 100001;
         behind++) { /* no more than that behind the point or before it, with an exponent or not, and below a bar */
        static char text[4][100020];
        int more = behind - 99999;
        snprintf(text[0], sizeof text[0], "%s.%.*s%.*s", more == 1 ? "" : "7", 99999, digits, more, "77");
        snprintf(text[1], sizeof text[1], "%s.%.*s%.*se1", more == 1 ? "" : "7", 99999, digits, more, "77");
        snprintf(text[2], sizeof text[2], "%.*s%.*se1", 99999, digits, more, "77");
        snprintf(text[3], sizeof text[3], "1/%.*s%.*s", 99999, digits, more, "77");
        for (int k = 0; k < 4; k++) {
            from_string_q(text[k]);
            if (more > 0)
                expect_fault(FAULT_UNDEFINED);
            assert_int_equal(region_faults, 0);
        }
    }
    digits[33333] = '.';
    assert_true(cagd_equal_q(from_string_q(digits), from_string_q(to_string_q(from_string_q(digits)))));
    assert_int_equal(strlen(to_string_q(from_string_q("1e99999"))), 100000);
    assert_int_equal(strlen(to_string_q(from_string_q("1e-99999"))), strlen("1/") + 100000);
}

/* MPFR's rounding into binary64's own exponent range. */
static double nearest_by_mpfr(num_q a)
{
    mpfr_exp_t least = mpfr_get_emin(), most = mpfr_get_emax();
    mpfr_t x;
    mpfr_init2(x, 53);
    mpfr_set_emin(-1073);
    mpfr_set_emax(1024);
    int inexact = mpfr_set_q(x, a.at, MPFR_RNDN);
    mpfr_subnormalize(x, inexact, MPFR_RNDN);
    double v = mpfr_get_d(x, MPFR_RNDN);
    mpfr_set_emin(least);
    mpfr_set_emax(most);
    mpfr_clear(x);
    return v;
}
static void assert_nearest(num_q a)
{
    double x = to_double_q(a), y = nearest_by_mpfr(a);
    assert_memory_equal(&x, &y, sizeof x);
    x = to_double_q(neg_q(a)), y = nearest_by_mpfr(neg_q(a));
    if (!cagd_is_zero_q(a))
        assert_memory_equal(&x, &y, sizeof x);
}

static void doubles_are_nearest(void **state)
{
    (void)state;
    assert_true(to_double_q(q(0)) == 0);
    for (int k = 0; k < 4000; k++) {
        region_mark m = region_open();
        /* around every exponent, subnormal and overflowing ones included */
        num_q a = mul_q(random_q(), power_of_two(k % 3 == 0 ? random_int(-1120, -1000) : random_int(-1150, 1040)));
        assert_nearest(a);
        /* halfway between neighbours, and a hair to either side */
        double x = ldexp(1 + (double)random_int(0, 999999937) * 0x1p-30,
                         k % 2 ? random_int(-1074, -1015) : random_int(-1074, 1023));
        double y = nextafter(x, HUGE_VAL);
        num_q upper = isfinite(y) ? from_double_q(y) : power_of_two(1024);
        num_q middle = mul_q(from_ratio_q(1, 2), add_q(from_double_q(x), upper)), hair = power_of_two(-1300);
        assert_nearest(middle);
        assert_nearest(add_q(middle, hair));
        assert_nearest(sub_q(middle, hair));
        assert_true(to_double_q(from_double_q(x)) == x);
        region_drop(m);
    }
    num_q largest = from_double_q(DBL_MAX), hair = power_of_two(-5);
    num_q halfway = add_q(largest, power_of_two(970)); /* to the next power of two */
    assert_true(to_double_q(halfway) > DBL_MAX);
    assert_true(to_double_q(sub_q(halfway, hair)) <= DBL_MAX);
    assert_nearest(halfway);
    assert_nearest(power_of_two(1024));
    assert_nearest(power_of_two(20000));
    assert_nearest(power_of_two(-20000));
    assert_nearest(power_of_two(-1075)); /* half the smallest number: to 0 */
    assert_nearest(add_q(power_of_two(-1075), power_of_two(-3000)));
    assert_nearest(sub_q(power_of_two(-1022), power_of_two(-1080))); /* up to the smallest normal */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        unit(laws_of_the_rationals),
        unit(laws_of_the_field),
        unit(laws_of_intervals),
        unit(laws_of_measured_and_plain_binary64),
        unit(enclosures_and_bounds_of_long_programs),
        unit(a_proof_specialises_to_every_value),
        unit(floors),
        unit(roots),
        unit(no_bound_is_infinite),
        unit(faults_stick),
        unit(the_field_calculates),
        unit(texts_are_read_exactly),
        unit(doubles_are_nearest),
    };
    return run_unit_tests(tests);
}
