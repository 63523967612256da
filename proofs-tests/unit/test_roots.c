/* test_roots.c -- Descartes' rule against Sturm's theorem and against planted roots. */
#include "unit_roots.h"

#include "exact/decide/sturm.h"
#include "exact/words.h"

static num_q from_power_of_two(int e)
{
    num_q r = from_int_q(1), step = e < 0 ? from_ratio_q(1, 2) : from_int_q(2);
    for (int k = e < 0 ? -e : e; k > 0; k--)
        r = mul_q(r, step);
    return r;
}
static poly linear(num_q root) { return poly_from_q(2, (num_q[]){neg_q(root), from_int_q(1)}); }

/* Both ways, all four kinds of ends; cagd_sturm_count is for (a,b]. */
static void assert_descartes_is_sturm(poly p, num_q a, num_q b)
{
    int at_a = cagd_is_zero_q(poly_value(p, a)), at_b = cagd_is_zero_q(poly_value(p, b)), n = cagd_sturm_count(p, a, b);
    if (cagd_equal_q(a, b)) {
        assert_int_equal(n, 0);
        assert_int_equal(cagd_count_roots(p, a, b, CLOSED).distinct, at_a);
        return;
    }
    assert_int_equal(cagd_count_roots(p, a, b, OPEN_LEFT).distinct, n);
    assert_int_equal(cagd_count_roots(p, a, b, OPEN).distinct, n - at_b);
    assert_int_equal(cagd_count_roots(p, a, b, CLOSED).distinct, n + at_a);
    assert_int_equal(cagd_count_roots(p, a, b, OPEN_RIGHT).distinct, n + at_a - at_b);
    struct cagd_root_count open = cagd_count_roots(p, a, b, OPEN);
    assert_int_equal(open.crossings + open.touches, open.distinct);
}

/* Disjoint, increasing, each with one root of its factor by Sturm. */
static void assert_isolated(poly p, num_q a, num_q b)
{
    struct cagd_root r[64];
    int n = cagd_isolate_roots(p, a, b, r, 64), counted = 0;
    assert_int_equal(n, cagd_count_roots(p, a, b, CLOSED).distinct);
    for (int k = 0; k < n; k++) {
        int order = cagd_compare_q(r[k].lo, r[k].hi);
        assert_true(order <= 0 && cagd_compare_q(a, r[k].lo) <= 0 && cagd_compare_q(r[k].hi, b) <= 0);
        int at_hi = cagd_is_zero_q(poly_value(r[k].factor, r[k].hi));
        if (order == 0)
            assert_true(at_hi);
        else
            assert_int_equal(cagd_sturm_count(r[k].factor, r[k].lo, r[k].hi) - at_hi, 1);
        if (k > 0)
            assert_true(cagd_compare_q(r[k - 1].hi, r[k].lo) <= 0);
        poly power = poly_constant(from_int_q(1));
        for (int m = 0; m < r[k].multiplicity; m++)
            power = poly_mul(power, r[k].factor);
        assert_true(cagd_poly_divides(power, p) && !cagd_poly_divides(poly_mul(power, r[k].factor), p));
        counted += r[k].multiplicity;

        struct cagd_root fine = refine_root(r[k], from_power_of_two(-70));
        assert_true(cagd_compare_q(sub_q(fine.hi, fine.lo), from_power_of_two(-70)) <= 0);
        assert_true(cagd_compare_q(r[k].lo, fine.lo) <= 0 && cagd_compare_q(fine.hi, r[k].hi) <= 0);
        if (cagd_equal_q(fine.lo, fine.hi))
            assert_true(cagd_is_zero_q(poly_value(p, fine.lo)));
        else
            assert_int_equal(
                cagd_sturm_count(r[k].factor, fine.lo, fine.hi) - cagd_is_zero_q(poly_value(r[k].factor, fine.hi)), 1);
    }
    assert_int_equal(counted, cagd_count_roots(p, a, b, CLOSED).counted);
}

static void random_polynomials(void **state)
{
    (void)state;
    for (int k = 0; k < 500; k++) {
        region_mark m = region_open();
        int n = random_int(0, 16);
        num_q c[17], a = coarse_q(6, 5), b = add_q(a, from_ratio_q(random_int(0, 9), random_int(1, 4)));
        for (int j = 0; j <= n; j++)
            c[j] = k % 2 ? random_q() : coarse_q(4, 2);
        poly p = k % 3 ? poly_from_q(n + 1, c) : poly_from_bernstein(n, c);
        if (!cagd_poly_is_zero(p)) {
            assert_descartes_is_sturm(p, a, b);
            assert_int_equal(cagd_count_roots_line(p).distinct, cagd_sturm_count_line(p));
            assert_int_equal(cagd_count_roots_above(p, a).distinct, cagd_sturm_count_above(p, a));
            assert_int_equal(cagd_count_roots_below(p, b).distinct,
                             cagd_sturm_count_below(p, b) - cagd_is_zero_q(poly_value(p, b)));
            if (k % 5 == 0)
                assert_isolated(p, a, b);
        }
        region_drop(m);
    }
}

static void planted_roots_with_multiplicity_and_at_the_ends(void **state)
{
    (void)state;
    for (int k = 0; k < 300; k++) {
        region_mark m = region_open();
        struct planted f = plant();
        num_q a = f.count > 0 && k % 2 ? f.at[0] : coarse_q(3, 4);
        num_q b = f.count > 1 && k % 3 ? f.at[f.count - 1] : add_q(a, from_ratio_q(random_int(0, 8), 3));
        if (cagd_compare_q(a, b) <= 0) {
            for (enum cagd_ends e = CLOSED; e <= OPEN_RIGHT; e++)
                if (cagd_compare_q(a, b) < 0 || e == CLOSED || e == OPEN)
                    assert_same_count(cagd_count_roots(f.p, a, b, e), planted_count(&f, a, b, e));
            assert_descartes_is_sturm(f.p, a, b);
            assert_isolated(f.p, a, b);
        }
        num_q far = from_int_q(1000000);
        assert_same_count(cagd_count_roots_line(f.p), planted_count(&f, neg_q(far), far, OPEN));
        assert_same_count(cagd_count_roots_above(f.p, a), planted_count(&f, a, far, OPEN));
        assert_same_count(cagd_count_roots_below(f.p, a), planted_count(&f, neg_q(far), a, OPEN));
        region_drop(m);
    }
}

static void wilkinson(void **state)
{
    (void)state;
    poly w = poly_constant(from_int_q(1));
    for (int k = 1; k <= 20; k++)
        w = poly_mul(w, linear(from_int_q(k)));
    num_q a = from_int_q(1), b = from_int_q(20);
    assert_descartes_is_sturm(w, a, b);
    assert_int_equal(cagd_count_roots(w, a, b, CLOSED).crossings, 18);
    assert_isolated(w, a, b);
    /* Wilkinson's perturbation -210 - 2^-23 leaves ten real roots */
    poly perturbed = w, t19 = poly_constant(from_power_of_two(-23));
    for (int k = 0; k < 19; k++)
        t19 = poly_mul(t19, poly_variable());
    perturbed = poly_sub(w, t19);
    assert_int_equal(cagd_count_roots_line(perturbed).distinct, 10);
    assert_int_equal(cagd_sturm_count_line(perturbed), 10);
}

/* t^n - 2 (c t - 1)^2 has two roots closer to 1/c than c^-(n+2)/2: the worst case of any subdivision. */
static void mignotte(void **state)
{
    (void)state;
    for (int n = 3; n <= 24; n += 7) {
        num_q c[25];
        for (int k = 0; k <= n; k++)
            c[k] = from_int_q(k == n);
        c[0] = add_q(c[0], from_int_q(-2));
        c[1] = add_q(c[1], from_int_q(4 * 101));
        c[2] = add_q(c[2], from_int_q(-2 * 101 * 101));
        poly p = poly_from_q(n + 1, c);
        assert_descartes_is_sturm(p, from_int_q(0), from_int_q(1));
        assert_int_equal(cagd_count_roots(p, from_int_q(0), from_int_q(1), OPEN).crossings, 2);
        assert_isolated(p, from_int_q(0), from_int_q(1));
    }
}

static void chebyshev(void **state)
{
    (void)state;
    poly before = poly_constant(from_int_q(1)), t = poly_variable(), two_t = poly_scale(t, from_int_q(2));
    num_q one = from_int_q(1), minus = from_int_q(-1);
    for (int n = 1; n <= 40; n++) {
        assert_int_equal(cagd_count_roots(t, minus, one, OPEN).crossings, n);
        poly square = poly_sub(poly_mul(t, t), poly_constant(one)); /* T_n^2 - 1 touches n - 1 times */
        struct cagd_root_count c = cagd_count_roots(square, minus, one, CLOSED);
        assert_int_equal(c.touches, n - 1);
        assert_int_equal(c.crossings, 0);
        assert_int_equal(c.distinct, n + 1);
        assert_int_equal(c.counted, 2 * n);
        if (n % 8 == 0)
            assert_descartes_is_sturm(square, minus, one);
        poly next = poly_sub(poly_mul(two_t, t), before);
        before = t;
        t = next;
    }
}

/* Roots 1/3, 1/3 +- 2^-200 and a double one 2^-300 away. */
static void clusters(void **state)
{
    (void)state;
    num_q third = from_ratio_q(1, 3), h = from_power_of_two(-200), k = from_power_of_two(-300);
    poly d = linear(add_q(third, k));
    poly p = poly_mul(poly_mul(linear(third), linear(add_q(third, h))), linear(sub_q(third, h)));
    p = poly_mul(p, poly_mul(d, d));
    num_q zero = from_int_q(0), one = from_int_q(1);
    assert_descartes_is_sturm(p, zero, one);
    assert_isolated(p, zero, one);
    struct cagd_root_count c = cagd_count_roots(p, zero, one, OPEN);
    assert_int_equal(c.crossings, 3);
    assert_int_equal(c.touches, 1);
}

static void bounds_enclose_every_root(void **state)
{
    (void)state;
    for (int k = 0; k < 100; k++) {
        struct planted f = plant();
        num_q B = root_bound(f.p);
        for (int j = 0; j < f.count; j++)
            assert_true(cagd_compare_q(f.at[j], B) < 0 && cagd_compare_q(neg_q(B), f.at[j]) < 0);
    }
}

/* For x^6 - x^5/2 - 3x^4/2 - 3x^3 - 7x^2 - 15x - 31 every |c_(6-k)| is below 2^(k-1), and the positive root is above 2: the exponent that
 * is divided by k has to be rounded up. */
static void a_bound_that_is_needed(void **state)
{
    (void)state;
    const num_q c[] = {from_int_q(-31),     from_int_q(-15),     from_int_q(-7), from_int_q(-3),
                       from_ratio_q(-3, 2), from_ratio_q(-1, 2), from_int_q(1)};
    poly p = poly_from_q(7, c);
    assert_int_equal(cagd_count_roots(p, from_int_q(2), from_int_q(3), OPEN).distinct, 1);
    assert_int_equal(cagd_count_roots_above(p, from_int_q(0)).distinct, 1);
    assert_true(cagd_compare_q(root_bound(p), from_int_q(2)) > 0);
}

/* The bound of 0 is undefined, that of a number any; x^n - c (x^(n-1) + ... + 1) for c > 1 has a root between c and c + 1, and x^n - c x^m one
 * at c^(1/(n-m)), beyond which the polynomial is positive. */
static void bounds_by_one_coefficient_and_by_all(void **state)
{
    (void)state;
    static const int of[][2] = {{3, 2}, {7, 4},  {15, 8},      {31, 16},           {2, 1},
                                {3, 1}, {63, 8}, {1 << 20, 1}, {(1 << 20) - 1, 1}, {1, 5}};
    const num_q one = from_int_q(1);
    for (size_t k = 0; k < sizeof of / sizeof *of; k++)
        for (int n = 1; n <= 9; n++)
            for (int m = -1; m < n; m++) { /* -1: all coefficients */
                region_mark mark = region_open();
                num_q c = from_ratio_q(of[k][0], of[k][1]), a[10];
                for (int sign = 1; sign >= -1; sign -= 2) { /* and -x for x */
                    for (int i = 0; i <= n; i++) {
                        a[i] = i == n ? one : m < 0 || i == m ? neg_q(c) : from_int_q(0);
                        a[i] = sign < 0 && i % 2 ? neg_q(a[i]) : a[i];
                    }
                    poly p = poly_from_q(n + 1, a);
                    num_q B = root_bound(p), end = sign < 0 ? neg_q(B) : B, value = poly_value(p, end);
                    assert_int_equal(cagd_sign_q(value), 1);
                    assert_int_equal(cagd_sturm_count_line(p), cagd_sturm_count(p, neg_q(B), B));
                    assert_int_equal(cagd_count_roots_line(p).distinct, cagd_sturm_count_line(p));
                }
                region_drop(mark);
            }
    assert_true(cagd_sign_q(root_bound(poly_constant(one))) > 0);
    assert_int_equal(region_faults, 0);
    root_bound(poly_from_q(0, NULL));
    expect_fault(FAULT_UNDEFINED);
}

/* Beyond all roots, on either side, and the same without roots. */
static void half_lines_beyond_the_roots(void **state)
{
    (void)state;
    num_q huge = from_power_of_two(40), one = from_int_q(1);
    poly p[] = {poly_constant(one), linear(one), poly_mul(linear(one), linear(neg_q(one)))};
    for (int k = 0; k < 3; k++) {
        assert_int_equal(cagd_count_roots_above(p[k], huge).distinct, 0);
        assert_int_equal(cagd_count_roots_below(p[k], neg_q(huge)).distinct, 0);
        assert_int_equal(cagd_count_roots_above(p[k], neg_q(huge)).distinct, k);
        assert_int_equal(cagd_count_roots_below(p[k], huge).distinct, k);
        assert_int_equal(cagd_sturm_count_above(p[k], neg_q(huge)), k);
        assert_int_equal(cagd_sturm_count_below(p[k], huge), k);
        assert_int_equal(region_faults, 0);
    }
}

/* An ordinate at the end that is smaller than what was cut off of the others: its sign is asked for again, at either end. */
static void a_sign_that_is_hidden_at_an_end(void **state)
{
    (void)state;
    num_q tiny = from_int_q(1), zero = from_int_q(0), one = from_int_q(1), half = from_ratio_q(1, 2);
    for (int k = 0; k < 2000; k++)
        tiny = mul_q(tiny, half);
    const num_q near[] = {tiny, sub_q(one, tiny)};
    for (int k = 0; k < 2; k++) {
        struct cagd_root_count r = cagd_count_roots(linear(near[k]), zero, one, OPEN);
        assert_int_equal(r.distinct, 1);
        assert_int_equal(r.crossings, 1);
        assert_int_equal(cagd_count_roots(linear(k == 0 ? neg_q(tiny) : add_q(one, tiny)), zero, one, OPEN).distinct,
                         0);
    }
}

static void edges(void **state)
{
    (void)state;
    num_q zero = from_int_q(0), one = from_int_q(1);
    poly nothing = poly_from_q(0, NULL), t = poly_variable();
    cagd_count_roots(nothing, zero, one, CLOSED);
    expect_fault(FAULT_UNDEFINED);
    cagd_count_roots_line(nothing);
    expect_fault(FAULT_UNDEFINED);
    cagd_isolate_roots(nothing, zero, one, NULL, 0);
    expect_fault(FAULT_UNDEFINED);
    cagd_count_roots(t, one, zero, OPEN);
    expect_fault(FAULT_UNDEFINED);
    assert_int_equal(cagd_count_roots(t, zero, zero, CLOSED).distinct, 1);
    assert_int_equal(cagd_count_roots(t, zero, zero, OPEN_LEFT).distinct, 0);
    assert_int_equal(cagd_count_roots(t, zero, zero, OPEN_RIGHT).distinct, 0);
    struct cagd_root r;
    assert_int_equal(cagd_isolate_roots(poly_mul(t, linear(one)), zero, one, &r, 1), 2); /* no room for the second */
    assert_true(cagd_is_zero_q(r.lo) && cagd_is_zero_q(r.hi) && r.multiplicity == 1);
    for (enum cagd_ends e = CLOSED; e <= OPEN_RIGHT; e++) { /* one point, a root or not */
        assert_int_equal(cagd_count_roots(t, zero, zero, e).distinct, e == CLOSED);
        assert_int_equal(cagd_count_roots(t, one, one, e).distinct, 0);
    }
    assert_int_equal(cagd_isolate_roots(poly_mul(t, t), zero, zero, &r, 1), 1);
    assert_true(cagd_is_zero_q(r.lo) && cagd_is_zero_q(r.hi) && r.multiplicity == 2);
    assert_int_equal(cagd_isolate_roots(t, one, one, &r, 1), 0);
    assert_int_equal(cagd_isolate_roots(poly_constant(one), zero, one, &r, 1), 0);
    refine_root(r, neg_q(one));
    expect_fault(FAULT_UNDEFINED);
    refine_root(r, zero);
    expect_fault(FAULT_UNDEFINED);
}

/* By trial: the least denominator with a number inside, and of these numbers the least in size. */
static num_q simplest_by_trial(num_q a, num_q b)
{
    for (long n = 1;; n++)
        for (long m = 0; m <= 40 * n; m++)
            for (int sign = 1; sign >= -1; sign -= 2) {
                num_q x = from_ratio_q(sign * m, n);
                if (cagd_compare_q(a, x) < 0 && cagd_compare_q(x, b) < 0)
                    return x;
            }
}
static void the_simplest_number_between(void **state)
{
    (void)state;
    enum { MOST = 7 };
    num_q end[2 * MOST * MOST * 3];
    int ends = 0;
    for (long n = 1; n <= MOST; n++)
        for (long m = -3 * n; m <= 3 * n; m++) {
            int known = 0;
            num_q x = from_ratio_q(m, n);
            for (int k = 0; k < ends; k++)
                known |= cagd_equal_q(end[k], x);
            if (!known)
                end[ends++] = x;
        }
    for (int i = 0; i < ends; i++)
        for (int j = 0; j < ends; j++) {
            region_mark mark = region_open();
            if (cagd_compare_q(end[i], end[j]) < 0 && (i + j) % 3 == 0) {
                num_q x = cagd_simplest_between(end[i], end[j]);
                if (!cagd_equal_q(x, simplest_by_trial(end[i], end[j])))
                    fail_msg("%s between %s and %s", to_string_q(x), to_string_q(end[i]), to_string_q(end[j]));
            }
            region_drop(mark);
        }
    num_q huge = from_power_of_two(200), next = add_q(huge, from_int_q(1));
    assert_true(cagd_equal_q(cagd_simplest_between(huge, next), add_q(huge, from_ratio_q(1, 2))));
    assert_true(cagd_equal_q(cagd_simplest_between(neg_q(next), neg_q(huge)), sub_q(neg_q(huge), from_ratio_q(1, 2))));
    assert_true(
        cagd_equal_q(cagd_simplest_between(from_int_q(0), div_q(from_int_q(1), huge)), div_q(from_int_q(1), next)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        unit(random_polynomials),
        unit(planted_roots_with_multiplicity_and_at_the_ends),
        unit(wilkinson),
        unit(mignotte),
        unit(chebyshev),
        unit(clusters),
        unit(bounds_enclose_every_root),
        unit(a_bound_that_is_needed),
        unit(bounds_by_one_coefficient_and_by_all),
        unit(half_lines_beyond_the_roots),
        unit(a_sign_that_is_hidden_at_an_end),
        unit(edges),
        unit(the_simplest_number_between),
    };
    return run_unit_tests(tests);
}
