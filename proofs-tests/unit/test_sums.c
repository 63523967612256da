/* test_sums.c -- creative telescoping against identities that are known, and against sums by addition. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/decide/sums.h"
#include "exact/number/field.h"
#include "exact/words.h"

static num_f n, k, t;
static num_f whole(long m) { return from_int_f(m); }

static void open_field(void)
{
    field_open(8);
    n = variable_f("n"), k = variable_f("k"), t = variable_f("t");
}

/* binomial(n,k)^e */
static cagd_term binomials(int e)
{
    cagd_term F = cagd_term_one();
    for (int i = 0; i < e; i++)
        F = cagd_term_times_binomial(F, n, k, 1, 0, whole(0), 0, 1, whole(0));
    return F;
}
static cagd_term bernstein(void)
{
    cagd_term F = cagd_term_times_power(binomials(1), t, 0, 1);
    return cagd_term_times_power(F, sub_f(whole(1), t), 1, -1);
}

/* The sum is S for every n, of a telescoper of that order. */
static void proved(cagd_term F, num_f first, num_f start, num_f ratio, int order)
{
    cagd_sum s = {F, first, ratio, start, 0, 0, 1, 0};
    cagd_telescoper T;
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_PROVED);
    assert_int_equal(T.order, order);
    assert_true(cagd_telescoper_holds(F, n, k, &T));
    T.R = add_f(T.R, k); /* another one is none */
    assert_false(cagd_telescoper_holds(F, n, k, &T));
    s.ratio = add_f(ratio, div_f(n, add_f(n, whole(1)))); /* right for n = 0 alone */
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_REFUTED);
    s.ratio = ratio, s.start = add_f(start, whole(1));
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_REFUTED);
}

static void test_known_sums(void **state)
{
    (void)state;
    open_field();
    num_f one = whole(1), two = whole(2), n1 = add_f(n, one);
    proved(binomials(1), one, one, two, 1); /* 2^n */
    /* (2n choose n): ratio (2n+1)(2n+2)/(n+1)^2 */
    proved(binomials(2), one, one, div_f(mul_f(add_f(mul_f(two, n), one), two), n1), 1);
    proved(bernstein(), one, one, one, 1);
    /* sum (-1)^k (n choose k) 2^(n-k) = 1 */
    cagd_term F = cagd_term_times_power(cagd_term_times_power(binomials(1), neg_f(one), 0, 1), two, 1, -1);
    proved(F, one, one, one, 1);
    /* sum (n+k choose k) 2^(-k) = 2^n, of which the terms do not end at k = n */
    F = cagd_term_times_binomial(cagd_term_one(), n, k, 1, 1, whole(0), 0, 1, whole(0));
    proved(cagd_term_times_power(F, two, 0, -1), one, one, two, 1);
    /* Vandermonde: sum (n choose k) (m choose k) = (n+m choose n), of ratio (n+m+1)/(n+1) */
    num_f m = variable_f("m");
    F = cagd_term_times_binomial(binomials(1), n, k, 0, 0, m, 0, 1, whole(0));
    cagd_sum s = {F, one, div_f(add_f(n1, m), n1), one, 0, 0, 1, 0};
    cagd_telescoper T;
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_PROVED);
    field_close();
}

/* Franel's numbers: sum (n choose k)^3 has a recurrence of order 2 and no closed form; (n+2)^2 f(n+2) = (7n^2+21n+16) f(n+1) +
 * 8 (n+1)^2 f(n). */
static void test_a_recurrence_of_order_two(void **state)
{
    (void)state;
    open_field();
    cagd_telescoper T;
    assert_true(cagd_telescope(binomials(3), n, k, 3, &T));
    assert_int_equal(T.order, 2);
    assert_true(cagd_telescoper_holds(binomials(3), n, k, &T));
    num_f n1 = add_f(n, whole(1)), n2 = add_f(n, whole(2)),
          middle = add_f(add_f(mul_f(whole(7), mul_f(n, n)), mul_f(whole(21), n)), whole(16));
    num_f scale = div_f(T.a[2], mul_f(n2, n2));
    assert_true(cagd_equal_f(T.a[1], neg_f(mul_f(scale, middle))));
    assert_true(cagd_equal_f(T.a[0], neg_f(mul_f(scale, mul_f(whole(8), mul_f(n1, n1))))));
    /* No closed form with a rational ratio is accepted. */
    cagd_sum s = {binomials(3), whole(1), div_f(whole(2), whole(1)), whole(1), 0, 0, 1, 0};
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_REFUTED);
    field_close();
}

/* sum over k of (-1)^k (n choose k) (3k + 1) (3k + 2) ... (3k + n) / n! = (-3)^n, whose telescoper has the order 3. */
static void test_a_sum_by_order_three(void **state)
{
    (void)state;
    open_field();
    num_f above = add_f(mul_f(whole(3), k), n), up = whole(1), down = whole(1);
    for (int j = 1; j <= 3; j++) {
        up = mul_f(up, add_f(above, whole(j)));
        down = mul_f(down, add_f(mul_f(whole(3), k), whole(j)));
    }
    cagd_term F = {div_f(add_f(above, whole(1)), sub_f(add_f(n, whole(1)), k)),
                   div_f(mul_f(sub_f(k, n), up), mul_f(add_f(k, whole(1)), down))};
    proved(F, whole(1), whole(1), whole(-3), 3);
    field_close();
}

/* A ratio of more factors than are looked at has no telescoper. */
static void test_a_term_of_many_factors(void **state)
{
    (void)state;
    open_field();
    num_f up = whole(1), down = whole(1);
    for (int j = 0; j < 66; j++)
        up = mul_f(up, add_f(k, from_ratio_f(2 * j + 1, 2))), down = mul_f(down, add_f(k, from_ratio_f(3 * j + 1, 3)));
    cagd_telescoper T;
    cagd_term F = {whole(1), div_f(up, down)};
    assert_false(cagd_telescope(F, n, k, 0, &T));
    region_faults = 0;
    field_close();
}

/* Gosper's case, order 0: sum of differences. */
static void test_an_indefinite_sum(void **state)
{
    (void)state;
    open_field();
    /* F = k k! = (k+1)! - k!; R = 1/k */
    cagd_term F =
        cagd_term_times_rational(cagd_term_times_factorial(cagd_term_one(), n, k, 0, 1, whole(0), 1), n, k, k);
    cagd_telescoper T;
    assert_true(cagd_telescope(F, n, k, 0, &T));
    assert_int_equal(T.order, 0);
    assert_true(cagd_telescoper_holds(F, n, k, &T));
    assert_true(cagd_equal_f(mul_f(T.R, k), T.a[0]));
    /* 1/k has none: the harmonic numbers are no hypergeometric term. */
    F = cagd_term_times_rational(cagd_term_one(), n, k, div_f(whole(1), k));
    assert_false(cagd_telescope(F, n, k, 0, &T));
    field_close();
}

/* Terms against their values: ratios of factorials and powers for small numbers. */
static void test_terms(void **state)
{
    (void)state;
    open_field();
    cagd_term F = cagd_term_times_factorial(cagd_term_one(), n, k, 2, -1, whole(3), 1); /* (2n-k+3)! */
    num_f e = add_f(sub_f(mul_f(whole(2), n), k), whole(3));
    assert_true(cagd_equal_f(F.by_n, mul_f(add_f(e, whole(1)), add_f(e, whole(2)))));
    assert_true(cagd_equal_f(F.by_k, div_f(whole(1), e)));
    F = cagd_term_times_factorial(cagd_term_one(), n, k, -1, 2, whole(0), -1); /* 1/(2k-n)! */
    e = sub_f(mul_f(whole(2), k), n);
    assert_true(cagd_equal_f(F.by_n, e));
    assert_true(cagd_equal_f(F.by_k, div_f(whole(1), mul_f(add_f(e, whole(1)), add_f(e, whole(2))))));
    F = cagd_term_times_power(cagd_term_one(), t, -2, 3);
    assert_true(cagd_equal_f(F.by_n, div_f(whole(1), mul_f(t, t))));
    assert_true(cagd_equal_f(F.by_k, mul_f(t, mul_f(t, t))));
    field_close();
}

/* A sum that is wrong from some n on only, beyond the rows that are looked at, is not proved. */
static void test_late_differences(void **state)
{
    (void)state;
    open_field();
    num_f late = whole(1); /* n (n-1) ... (n-6) vanishes for the first rows */
    for (int i = 0; i < 7; i++)
        late = mul_f(late, sub_f(n, whole(i)));
    cagd_sum s = {binomials(1), whole(1), add_f(whole(2), late), whole(1), 0, 0, 1, 0};
    cagd_telescoper T;
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_UNDECIDED);
    field_close();
}

static void test_factors(void **state)
{
    (void)state;
    open_field();
    num_f factor[4];
    int power[4];
    num_f a = add_f(k, n), b = sub_f(mul_f(k, k), t);
    num_f p = div_f(mul_f(mul_f(mul_f(whole(6), n), mul_f(a, a)), b), add_f(t, whole(5)));
    assert_int_equal(cagd_factors_f(p, k, 4, factor, power), 2);
    int first = cagd_degree_f(factor[0], k) == 1 ? 0 : 1;
    assert_int_equal(power[first], 2);
    assert_int_equal(power[1 - first], 1);
    assert_true(cagd_is_constant_f(div_f(factor[first], a), NULL));
    assert_true(cagd_is_constant_f(div_f(factor[1 - first], b), NULL));
    assert_int_equal(cagd_factors_f(p, k, 1, factor, power), -1);
    assert_int_equal(cagd_factors_f(n, k, 4, factor, power), 0);
    assert_int_equal(cagd_factors_f(p, add_f(k, n), 4, factor, power), -1); /* no variable */
    expect_fault(FAULT_UNABLE);
    assert_true(cagd_equal_f(div_f(cagd_numerator_f(p), cagd_denominator_f(p)), p));
    assert_int_equal(cagd_denominator_degree_f(cagd_numerator_f(p), t), 0);
    field_close();
}

/* (m choose j), 0 outside 0 <= j <= m, as a rational. */
static void choose(mpq_t out, int m, int j)
{
    mpq_set_ui(out, 0, 1);
    if (j >= 0 && j <= m)
        mpz_bin_uiui(mpq_numref(out), (unsigned long)m, (unsigned long)j);
}

/* The ratios of binomial(2 n + 3 k + 5, n + 2 k + 1) 3^(n + 2 k) (n + 4)/(k + 2) at small numbers, by the values themselves. */
static void value_of_term(mpq_t out, int m, int j)
{
    mpq_t x;
    mpz_t power;
    mpq_init(x), mpz_init(power);
    choose(out, 2 * m + 3 * j + 5, m + 2 * j + 1);
    mpz_ui_pow_ui(power, 3, (unsigned long)(m + 2 * j));
    mpq_set_z(x, power), mpq_mul(out, out, x);
    mpq_set_si(x, m + 4, (unsigned long)(j + 2)), mpq_canonicalize(x), mpq_mul(out, out, x);
    mpq_clear(x), mpz_clear(power);
}
static void test_terms_by_their_values(void **state)
{
    (void)state;
    open_field();
    cagd_term F = cagd_term_times_binomial(cagd_term_one(), n, k, 2, 3, whole(5), 1, 2, whole(1));
    F = cagd_term_times_power(F, whole(3), 1, 2);
    F = cagd_term_times_rational(F, n, k, div_f(add_f(n, whole(4)), add_f(k, whole(2))));
    for (int m = 0; m < 5; m++)
        for (int j = 0; j <= m; j++) {
            mpq_t here, next, ratio;
            mpq_inits(here, next, ratio, (mpq_ptr)0);
            value_of_term(here, m, j);
            for (int by_n = 0; by_n <= 1; by_n++) {
                num_q value;
                value_of_term(next, m + by_n, j + !by_n);
                mpq_div(ratio, next, here);
                num_f found = substitute_f(substitute_f(by_n ? F.by_n : F.by_k, n, whole(m)), k, whole(j));
                assert_true(cagd_is_constant_f(found, &value));
                assert_true(mpq_equal(value.at, ratio));
            }
            mpq_clears(here, next, ratio, (mpq_ptr)0);
        }
    field_close();
}

/* sum_k (-1)^k (n choose k)/(k + x) = n!/(x (x+1) ... (x+n)): proved for x = t > 0, and not for x = t - 2, where the ratio of
 * neighbours has the factor k + t - 1 in its denominator, which is 0 for k = 0 and t = 1. */
static void test_poles_in_a_term(void **state)
{
    (void)state;
    open_field();
    for (int less = 0; less <= 2; less += 2) {
        num_f x = sub_f(t, whole(less));
        cagd_term F = cagd_term_times_power(binomials(1), whole(-1), 0, 1);
        F = cagd_term_times_rational(F, n, k, div_f(whole(1), add_f(k, x)));
        num_f start = div_f(whole(1), x), ratio = div_f(add_f(n, whole(1)), add_f(add_f(n, whole(1)), x));
        cagd_sum s = {F, start, ratio, start, 0, 0, 1, 0};
        cagd_telescoper T;
        /* `first` is F(0,0), and later rows begin with F(m,0) = F(0,0) */
        assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), less ? CAGD_SUM_UNDECIDED : CAGD_SUM_PROVED);
        s.generic = 1; /* as a function of t it is defined for t - 2, too */
        assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_PROVED);
    }
    field_close();
}

/* sum_k (n choose k)/n = 2^n/n from n = 1 on; for n = 0 there is no such term. */
static void test_sums_from_a_number_on(void **state)
{
    (void)state;
    open_field();
    num_f one = whole(1), half = div_f(one, whole(2));
    cagd_term F = cagd_term_times_rational(binomials(1), n, k, div_f(one, n));
    cagd_sum s = {F, one, div_f(mul_f(whole(2), n), add_f(n, one)), whole(2), 1, 0, 1, 0};
    cagd_telescoper T;
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_PROVED); /* 2^n/n */
    s.from = 0;
    region_faults = 0;
    assert_int_not_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_PROVED);
    region_faults = 0;
    s.from = 1, s.start = half;
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_REFUTED);
    /* a factor n - 2 in a denominator is no harm from 3 on, and is one from 1 on */
    F = cagd_term_times_rational(binomials(1), n, k, div_f(one, sub_f(n, whole(2))));
    s = (cagd_sum){F, one, div_f(mul_f(whole(2), sub_f(n, whole(2))), sub_f(n, one)), whole(8), 3, 0, 1, 0};
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_PROVED);
    s.start = whole(9); /* for n = 3 it is 8 */
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_REFUTED);
    s.start = whole(8), s.first = whole(2);
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_REFUTED);
    s.first = one, s.from = 1;
    assert_int_not_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_PROVED);
    region_faults = 0;
    field_close();
}

/* a + m. */
static num_f plus(num_f a, long m) { return add_f(a, whole(m)); }

/* The value of a + b k + c k^2. */
static num_f quadratic(long a, long b, long c)
{
    return add_f(whole(a), mul_f(k, add_f(whole(b), mul_f(whole(c), k))));
}

/* 1/(k^2+1) - 1/((k+1)^2+1) = (2k+1)/((k^2+1) ((k+1)^2+1)): factors of two degrees, with a leading coefficient that is not 1.  And
 * with a = k^2+k+1, b = k^2+4k+7, c = a(k) (k+1)^3 - b(k) k^3 the solution of a x(k+1) - b x = c is x = k^3, of higher degree than
 * the degrees of a, b and c say. */
static void test_shifts_and_degrees(void **state)
{
    (void)state;
    open_field();
    cagd_telescoper T;
    num_f next = substitute_f(quadratic(1, 0, 1), k, add_f(k, whole(1)));
    cagd_term F =
        cagd_term_times_rational(cagd_term_one(), n, k, div_f(quadratic(1, 2, 0), mul_f(quadratic(1, 0, 1), next)));
    assert_true(cagd_telescope(F, n, k, 0, &T));
    assert_true(cagd_telescoper_holds(F, n, k, &T));
    num_f k1 = add_f(k, whole(1)), a = quadratic(1, 1, 1), b = quadratic(7, 4, 1);
    num_f c = sub_f(mul_f(a, mul_f(k1, mul_f(k1, k1))), mul_f(b, mul_f(k, mul_f(k, k))));
    F = cagd_term_times_rational(cagd_term_one(), n, k, c);
    F.by_k = mul_f(F.by_k, div_f(a, substitute_f(b, k, k1)));
    assert_true(cagd_telescope(F, n, k, 0, &T));
    assert_true(cagd_telescoper_holds(F, n, k, &T));
    field_close();
}

/* A denominator whose sign is not read off its coefficients, (n-30)^2 + 1, is no proof, though it is nowhere 0; nor is one that is 0
 * where only numbers beyond the first rows lie, n - 30. */
static void test_denominators_that_are_not_told(void **state)
{
    (void)state;
    open_field();
    num_f n1 = add_f(n, whole(1)), far = sub_f(n, whole(30)), square = add_f(mul_f(far, far), whole(1));
    for (int with_zero = 0; with_zero < 2; with_zero++) {
        num_f q = with_zero ? far : square, first = div_f(whole(1), substitute_f(q, n, whole(0)));
        cagd_sum s = {cagd_term_times_rational(binomials(1), n, k, div_f(whole(1), q)),
                      first,
                      div_f(mul_f(whole(2), q), substitute_f(q, n, n1)),
                      first,
                      0,
                      0,
                      1,
                      0};
        cagd_telescoper T;
        assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_UNDECIDED);
    }
    field_close();
}

/* With a recurrence of order 0 at most, the rows n = 0 and 1 are looked at: the sum of (n choose k) is 3^n in the first alone. */
static void test_the_last_of_the_first_rows(void **state)
{
    (void)state;
    open_field();
    cagd_telescoper T;
    cagd_sum s = {binomials(1), whole(1), whole(3), whole(1), 0, 0, 1, 0};
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 0, &T), CAGD_SUM_REFUTED);
    s.ratio = whole(2);
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 0, &T), CAGD_SUM_UNDECIDED);
    field_close();
}

/* A telescoper whose last coefficients are 0 is one as long as some coefficient is not. */
static void test_coefficients_that_are_zero(void **state)
{
    (void)state;
    open_field();
    cagd_telescoper T, none = {.order = 1, .a = {whole(0), whole(0)}, .R = whole(0)};
    cagd_term F = binomials(1);
    assert_true(cagd_telescope(F, n, k, 3, &T));
    assert_int_equal(T.order, 1);
    T.order = 2, T.a[2] = whole(0);
    assert_true(cagd_telescoper_holds(F, n, k, &T));
    assert_false(cagd_telescoper_holds(F, n, k, &none));
    field_close();
}

/* F(n,k) = (-29)(-28)...(n-30) C(n,k) n! / ((k-30)! (n-k+30)!), read off its ratios: (k+1)(k-29) stands in the denominator of that in k, so
 * that no row with n >= 30 is defined, though the telescoper is defined everywhere and the first rows have the sum that is claimed, of
 * the ratio (2n+2)(2n+1)/(n+31). */
static void test_a_term_that_ends_before_its_row(void **state)
{
    (void)state;
    open_field();
    num_f n1 = plus(n, 1), left = sub_f(n, k);
    cagd_term F = {div_f(mul_f(mul_f(n1, n1), plus(n, -29)), mul_f(plus(left, 1), plus(left, 31))),
                   div_f(mul_f(left, plus(left, 30)), mul_f(plus(k, 1), plus(k, -29)))};
    num_f ratio = div_f(mul_f(plus(mul_f(whole(2), n), 2), plus(mul_f(whole(2), n), 1)), plus(n, 31));
    cagd_sum s = {F, whole(1), ratio, whole(1), 0, 0, 1, 0};
    cagd_telescoper T;
    assert_true(cagd_telescope(F, n, k, 3, &T));
    assert_true(cagd_telescoper_holds(F, n, k, &T));
    assert_int_equal(T.order, 1);
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_UNDECIDED);
    /* with k+31 in the place of k-29 it ends nowhere, and has another sum */
    s.F.by_k = div_f(mul_f(left, plus(left, 30)), mul_f(plus(k, 1), plus(k, 31)));
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_REFUTED);
    field_close();
}

/* Equations with too many unknowns, or too many equations, are not solved: k^70 is summed by a polynomial of 71 degrees, and
 * k^130 (k!)^100 leads to 131 equations. */
static void test_equations_that_are_too_many(void **state)
{
    (void)state;
    open_field();
    cagd_telescoper T;
    num_f next = div_f(plus(k, 1), k), of_powers = whole(1), of_factorials = whole(1);
    for (int i = 0; i < 70; i++)
        of_powers = mul_f(of_powers, next);
    assert_false(cagd_telescope((cagd_term){whole(1), of_powers}, n, k, 0, &T));
    for (int i = 70; i < 130; i++)
        of_powers = mul_f(of_powers, next);
    for (int i = 0; i < 100; i++)
        of_factorials = mul_f(of_factorials, plus(k, 1));
    assert_false(cagd_telescope((cagd_term){whole(1), mul_f(of_powers, of_factorials)}, n, k, 0, &T));
    assert_int_equal(region_faults, 0);
    field_close();
}

/* C(n,k) C(2n,n-2-k), of the sum C(3n,n-2), is no ratio of its neighbour in n where k = n - 1: the factor n - k - 1. */
static void test_a_step_in_n_that_is_not_defined(void **state)
{
    (void)state;
    open_field();
    num_f two_n = mul_f(whole(2), n), three_n = mul_f(whole(3), n);
    cagd_term F = cagd_term_times_binomial(binomials(1), n, k, 2, 0, whole(0), 1, -1, whole(-2));
    num_f up = mul_f(mul_f(plus(three_n, 1), plus(three_n, 2)), plus(three_n, 3)),
          down = mul_f(mul_f(plus(n, -1), plus(two_n, 3)), plus(two_n, 4));
    cagd_sum s = {F, whole(1), div_f(up, down), whole(1), 2, 0, 1, 0};
    cagd_telescoper T;
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_UNDECIDED);
    assert_true(cagd_telescoper_holds(F, n, k, &T));
    field_close();
}

/* C(n+1,k+1) is 1 and not 0 for k = -1, so that the recurrence of the term is none of its sum 2^(n+1) - 1.  The ratio 3 - 2n/3 is that of
 * the first three rows. */
static void test_a_term_that_begins_before_its_row(void **state)
{
    (void)state;
    open_field();
    cagd_term F = {div_f(plus(n, 2), plus(sub_f(n, k), 1)), div_f(sub_f(n, k), plus(k, 2))};
    cagd_sum s = {F, whole(1), sub_f(whole(3), div_f(mul_f(whole(2), n), whole(3))), whole(1), 0, 0, 1, 0};
    cagd_telescoper T;
    assert_int_equal(cagd_sum_for_every_n(&s, n, k, 1, &T), CAGD_SUM_UNDECIDED);
    assert_true(cagd_telescoper_holds(F, n, k, &T));
    assert_false(cagd_is_zero_f(substitute_f(T.R, k, whole(0))));
    field_close();
}

/* Zeros of a denominator before k = from, the zero polynomial, and more factors than are looked at. */
static void test_what_may_vanish(void **state)
{
    (void)state;
    open_field();
    num_f product = whole(1);
    for (int j = 1; j <= 66; j++)
        product = mul_f(product, plus(k, j));
    assert_true(cagd_is_never_zero(plus(k, 1), n, k, 2));
    assert_false(cagd_is_never_zero(plus(k, -1), n, k, 2));
    assert_false(cagd_is_never_zero(whole(0), n, k, 0));
    assert_false(cagd_is_never_zero(product, n, k, 0));
    field_close();
}

/* (e+2)!^2 and its inverse over e!^2, and so on: steps of every size with powers of every size, by the product itself. */
static void test_powers_of_factorials(void **state)
{
    (void)state;
    open_field();
    for (int p = -3; p <= 3; p++)
        for (int q = -3; q <= 3; q++)
            for (int power = -3; power <= 3; power++) {
                region_mark mark = region_open();
                cagd_term F = cagd_term_times_factorial(cagd_term_one(), n, k, p, q, whole(5), power);
                for (int by_n = 0; by_n < 2; by_n++) {
                    const int step = by_n ? p : q;
                    num_f e = plus(add_f(mul_f(whole(p), n), mul_f(whole(q), k)), 5), ratio = whole(1);
                    for (int i = 1; i <= step; i++) /* (e+1) ... (e+step) */
                        ratio = mul_f(ratio, plus(e, i));
                    for (int i = step + 1; i <= 0; i++) /* 1/((e+step+1) ... e) */
                        ratio = div_f(ratio, plus(e, i));
                    num_f all = whole(1);
                    for (int i = 0; i < (power < 0 ? -power : power); i++)
                        all = power < 0 ? div_f(all, ratio) : mul_f(all, ratio);
                    assert_true(cagd_equal_f(by_n ? F.by_n : F.by_k, all));
                }
                F = cagd_term_times_power(cagd_term_one(), t, p, q);
                num_f by_n = whole(1);
                for (int i = 0; i < (p < 0 ? -p : p); i++)
                    by_n = p < 0 ? div_f(by_n, t) : mul_f(by_n, t);
                assert_true(cagd_equal_f(F.by_n, by_n));
                region_drop(mark);
            }
    field_close();
}

/* k^2 + 2k + 2 and k^2 + 2 have roots whose sums differ by 2, and are no shifts of each other. */
static void test_quadratics_that_are_no_shifts(void **state)
{
    (void)state;
    open_field();
    cagd_telescoper T;
    num_f a = quadratic(2, 2, 1), b = quadratic(3, -2, 1), next = quadratic(2, 0, 1); /* next(k) = b(k+1) */
    num_f c = sub_f(mul_f(a, plus(k, 1)), mul_f(b, k));
    cagd_term F = cagd_term_times_rational(cagd_term_one(), n, k, c);
    F.by_k = mul_f(F.by_k, div_f(a, next));
    assert_true(cagd_telescope(F, n, k, 0, &T));
    assert_true(cagd_telescoper_holds(F, n, k, &T));
    field_close();
}

/* Which polynomials are 0 somewhere for whole n >= k >= 0, n >= from, whichever of the variables stands first in the field. */
static void test_where_polynomials_vanish(void **state)
{
    (void)state;
    for (int order = 0; order < 2; order++) {
        field_open(8);
        if (order == 0)
            n = variable_f("n"), k = variable_f("k");
        else
            k = variable_f("k"), n = variable_f("n");
        t = variable_f("t");
        num_f s = variable_f("s");
        for (int from = 0; from <= 4; from++)
            for (int m = -2; m <= 6; m++) { /* k - m, n - m, n - k + m: 0 for k = m, n = m, and k = n + m */
                num_f of_k = plus(k, -m), of_n = plus(n, -m), between = plus(sub_f(n, k), m);
                for (int sign = 1; sign >= -1; sign -= 2) {
                    assert_int_equal(cagd_is_never_zero(mul_f(whole(sign), of_k), n, k, from), m < 0);
                    assert_int_equal(cagd_is_never_zero(mul_f(whole(sign), of_n), n, k, from), m < from);
                    assert_int_equal(cagd_is_never_zero(mul_f(whole(sign), between), n, k, from), m > 0);
                }
                /* as functions of t: one coefficient that is never 0 is enough, whichever it is */
                num_f never = plus(k, 1), square = mul_f(t, t);
                assert_true(cagd_is_never_zero(add_f(mul_f(t, of_k), never), n, k, from));
                assert_true(cagd_is_never_zero(add_f(of_k, mul_f(t, never)), n, k, from));
                assert_true(cagd_is_never_zero(add_f(of_k, mul_f(square, never)), n, k, from));
                assert_true(cagd_is_never_zero(add_f(add_f(of_k, mul_f(square, of_n)), mul_f(t, never)), n, k, from));
                assert_true(cagd_is_never_zero(add_f(of_k, mul_f(s, never)), n, k, from));
                assert_int_equal(cagd_is_never_zero(add_f(of_k, mul_f(t, plus(k, -m))), n, k, from), m < 0);
                assert_int_equal(cagd_is_never_zero(mul_f(never, of_n), n, k, from), m < from);
            }
        field_close();
    }
    open_field();
    field_close();
}

/* sum over k = 0, ..., N of (N choose k) (2N - 2 - k) = 2^(N-1) (3N - 4) for N = 2n + 1: from n = 1, N = 3 on no term is 0, while for N = 2 the one
 * with k = 2 would be. */
static void test_the_first_last_term(void **state)
{
    (void)state;
    open_field();
    cagd_telescoper T;
    cagd_term F = cagd_term_times_binomial(cagd_term_one(), n, k, 2, 0, whole(1), 0, 1, whole(0));
    F = cagd_term_times_rational(F, n, k, sub_f(mul_f(whole(4), n), k));
    num_f six = mul_f(whole(6), n);
    for (int generic = 0; generic < 2; generic++) {
        cagd_sum s = {F, whole(4), div_f(mul_f(whole(4), plus(six, 5)), plus(six, -1)), whole(20), 1, generic, 2, 1};
        assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_PROVED);
    }
    field_close();
}

/* To 2n, and to 2n + 1; a divisor that is 0 for k = 31, or for no whole n. */
static void test_sums_to_multiples_of_n(void **state)
{
    (void)state;
    open_field();
    cagd_telescoper T;
    for (int e = 0; e < 2; e++) {
        cagd_term F = cagd_term_times_binomial(cagd_term_one(), n, k, 2, 0, whole(e), 0, 1, whole(0));
        cagd_sum s = {F, whole(1), whole(4), whole(1 + e), 0, 1, 2, e};
        assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_PROVED);
        s.beyond = 1 - e;
        assert_int_not_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_PROVED);
        s.by = 1, s.beyond = 0;
        assert_int_not_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_PROVED);
        num_f far = sub_f(k, whole(31));
        s = (cagd_sum){cagd_term_times_rational(F, n, k, far),
                       whole(-31),
                       div_f(mul_f(whole(4), sub_f(n, whole(30))), sub_f(n, whole(31))),
                       whole(-31),
                       0,
                       1,
                       2,
                       e};
        assert_int_not_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_PROVED);
    }
}

/* p = 0 of a sum to N = p n + e stands for 1: the sum of (n choose k) to N = n. */
static void test_a_last_term_that_is_not_said(void **state)
{
    (void)state;
    open_field();
    num_f one = whole(1);
    cagd_telescoper T;
    for (int by = 0; by < 2; by++) {
        cagd_sum s = {binomials(1), one, whole(2), one, 0, 0, by, 0};
        assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_PROVED);
        s.ratio = whole(3);
        assert_int_equal(cagd_sum_for_every_n(&s, n, k, 3, &T), CAGD_SUM_REFUTED);
        assert_int_equal(region_faults, 0);
    }
    field_close();
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(test_terms),
                                       unit(test_known_sums),
                                       unit(test_a_recurrence_of_order_two),
                                       unit(test_a_sum_by_order_three),
                                       unit(test_a_term_of_many_factors),
                                       unit(test_an_indefinite_sum),
                                       unit(test_late_differences),
                                       unit(test_factors),
                                       unit(test_terms_by_their_values),
                                       unit(test_poles_in_a_term),
                                       unit(test_coefficients_that_are_zero),
                                       unit(test_sums_from_a_number_on),
                                       unit(test_shifts_and_degrees),
                                       unit(test_denominators_that_are_not_told),
                                       unit(test_a_term_that_ends_before_its_row),
                                       unit(test_equations_that_are_too_many),
                                       unit(test_a_step_in_n_that_is_not_defined),
                                       unit(test_a_term_that_begins_before_its_row),
                                       unit(test_what_may_vanish),
                                       unit(test_powers_of_factorials),
                                       unit(test_quadratics_that_are_no_shifts),
                                       unit(test_where_polynomials_vanish),
                                       unit(test_the_last_of_the_first_rows),
                                       unit(test_sums_to_multiples_of_n),
unit(test_a_last_term_that_is_not_said),
                                       unit(test_the_first_last_term)};
    return run_unit_tests(tests);
}
