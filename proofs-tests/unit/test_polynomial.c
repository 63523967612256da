/* test_polynomial.c -- polynomials over Q against their definitions. */
#include "unit_exact.h"

#include "exact/number/polynomial.h"
#include "exact/words.h"

#include <string.h>

static poly random_poly(int degree)
{
    num_q c[65];
    for (int k = 0; k <= degree; k++)
        c[k] = random_q();
    return poly_from_q(degree + 1, c);
}
static poly power(poly p, int n)
{
    poly r = poly_constant(from_int_q(1));
    for (int k = 0; k < n; k++)
        r = poly_mul(r, p);
    return r;
}
/* B_i^n(t) = C(n,i) t^i (1-t)^(n-i), the coefficient as a product of fractions. */
static poly bernstein(int i, int n)
{
    num_q c = from_int_q(1);
    for (int k = 1; k <= i; k++)
        c = mul_q(c, from_ratio_q(n - i + k, k));
    poly t = poly_variable(), u = poly_sub(poly_constant(from_int_q(1)), t);
    return poly_scale(poly_mul(power(t, i), power(u, n - i)), c);
}

static void bernstein_form_is_the_sum_of_basis_functions(void **state)
{
    (void)state;
    for (int n = 0; n <= 24; n++) {
        num_q b[25];
        poly sum = poly_from_q(0, NULL);
        for (int i = 0; i <= n; i++) {
            b[i] = random_q();
            sum = poly_add(sum, poly_scale(bernstein(i, n), b[i]));
        }
        assert_true(cagd_poly_equal(poly_from_bernstein(n, b), sum));
    }
}

static void to_bernstein_inverts_over_any_interval(void **state)
{
    (void)state;
    for (int n = 0; n <= 20; n++) {
        num_q b[25], lo = random_q(), hi = random_q();
        poly p = random_poly(n);
        poly line = poly_from_q(2, (num_q[]){lo, sub_q(hi, lo)});
        poly_to_bernstein(p, n + n % 4, lo, hi, b);
        assert_true(cagd_poly_equal(poly_from_bernstein(n + n % 4, b), poly_compose(p, line)));
        assert_true(cagd_equal_q(b[0], poly_value(p, lo)));
        assert_true(cagd_equal_q(b[n + n % 4], poly_value(p, hi)));
    }
}

static void values_are_homomorphisms(void **state)
{
    (void)state;
    for (int k = 0; k < 50; k++) {
        poly p = random_poly(random_int(0, 12)), q = random_poly(random_int(0, 9));
        num_q t = random_q(), P = poly_value(p, t), Q = poly_value(q, t);
        assert_true(cagd_equal_q(poly_value(poly_add(p, q), t), add_q(P, Q)));
        assert_true(cagd_equal_q(poly_value(poly_sub(p, q), t), sub_q(P, Q)));
        assert_true(cagd_equal_q(poly_value(poly_mul(p, q), t), mul_q(P, Q)));
        assert_true(cagd_equal_q(poly_value(poly_neg(p), t), neg_q(P)));
        assert_true(cagd_equal_q(poly_value(poly_scale(p, Q), t), mul_q(P, Q)));
        assert_true(cagd_equal_q(poly_value(poly_compose(p, q), t), poly_value(p, Q)));
        /* p(t + h) - p(t) - h p'(t) is divisible by h^2 */
        poly shift = poly_compose(p, poly_from_q(2, (num_q[]){t, from_int_q(1)}));
        assert_true(cagd_equal_q(poly_coefficient(shift, 1), poly_value(poly_derivative(p), t)));
    }
}

static void division_and_gcd(void **state)
{
    (void)state;
    for (int k = 0; k < 50; k++) {
        poly p = random_poly(random_int(0, 12)), q = random_poly(random_int(0, 8)), g = random_poly(random_int(0, 5));
        poly r = poly_remainder(p, q);
        assert_true(cagd_poly_equal(p, poly_add(poly_mul(poly_quotient(p, q), q), r)));
        assert_true(cagd_poly_degree(r) < cagd_poly_degree(q));
        poly common = poly_gcd(poly_mul(p, g), poly_mul(q, g));
        assert_true(cagd_poly_divides(g, common) && cagd_poly_divides(common, poly_mul(p, g)));
        assert_true(cagd_poly_divides(common, poly_mul(q, g)));
        assert_true(cagd_equal_q(poly_coefficient(common, cagd_poly_degree(common)), from_int_q(1)));
        assert_int_equal(cagd_poly_degree(common), cagd_poly_degree(g) + cagd_poly_degree(poly_gcd(p, q)));
    }
    poly zero = poly_from_q(0, NULL), one = poly_constant(from_int_q(1));
    assert_true(cagd_poly_divides(one, zero) && cagd_poly_divides(zero, zero) && !cagd_poly_divides(zero, one));
    assert_true(cagd_poly_is_zero(poly_gcd(zero, zero)));
    assert_int_equal(cagd_poly_degree(zero), -1);
    poly_quotient(one, zero);
    expect_fault(FAULT_UNDEFINED);
    poly_remainder(one, zero);
    expect_fault(FAULT_UNDEFINED);
}

static void squarefree_decomposition_multiplies_back(void **state)
{
    (void)state;
    for (int k = 0; k < 60; k++) {
        poly p = poly_constant(random_q()), factor[64];
        int multiplicity[64];
        for (int m = 1; m <= 5; m++)
            p = poly_mul(p, power(random_poly(random_int(0, 2)), m));
        int count = poly_squarefree(p, factor, multiplicity);
        poly product = poly_constant(poly_coefficient(p, cagd_poly_degree(p)));
        for (int j = 0; j < count; j++) {
            assert_true(cagd_poly_degree(factor[j]) > 0);
            assert_true(j == 0 || multiplicity[j - 1] < multiplicity[j]);
            assert_int_equal(cagd_poly_degree(poly_gcd(factor[j], poly_derivative(factor[j]))), 0);
            for (int i = 0; i < j; i++)
                assert_int_equal(cagd_poly_degree(poly_gcd(factor[i], factor[j])), 0);
            product = poly_mul(product, power(factor[j], multiplicity[j]));
        }
        assert_true(cagd_poly_equal(p, product));
    }
    poly_squarefree(poly_from_q(0, NULL), NULL, NULL);
    expect_fault(FAULT_UNDEFINED);
}

static void fractions_of_the_field_in_one_variable(void **state)
{
    (void)state;
    field_open(3);
    num_f t = variable_f("t"), w = variable_f("w");
    num_f a = div_f(sub_f(mul_f(t, t), from_ratio_f(1, 4)), add_f(t, from_ratio_f(1, 2))); /* t - 1/2 */
    poly p, q;
    poly_from_field(a, t, &p, &q);
    num_q x = random_q();
    assert_true(cagd_equal_q(div_q(poly_value(p, x), poly_value(q, x)), sub_q(x, from_ratio_q(1, 2))));
    assert_int_equal(cagd_poly_degree(q), 0);
    poly_from_field(from_ratio_f(3, 7), t, &p, &q);
    assert_int_equal(cagd_poly_degree(p), 0);
    poly_from_field(from_int_f(0), t, &p, &q);
    assert_true(cagd_poly_is_zero(p));
    poly_from_field(div_f(t, w), t, &p, &q);
    expect_fault(FAULT_UNABLE);
    poly_from_field(a, add_f(t, w), &p, &q);
    expect_fault(FAULT_UNDEFINED);
}

static void text_and_edges(void **state)
{
    (void)state;
    poly p = poly_from_q(3, (num_q[]){from_int_q(1), from_ratio_q(-1, 3), from_int_q(1)});
    assert_string_equal(poly_to_string(p, "t"), "t^2 - 1/3*t + 1");
    assert_true(cagd_is_zero_q(poly_coefficient(p, 7)));
    num_q out[2];
    poly_to_bernstein(p, 1, from_int_q(0), from_int_q(1), out);
    expect_fault(FAULT_UNDEFINED);
}

/* The degree of p(q) is that of p times that of q, and has to be an int: 46341^2 is more than 2^31 - 1, and 46340^2 less. */
static void degrees_that_no_int_has(void **state)
{
    (void)state;
    enum { DEGREE = 46341 };
    num_q *c = cagd_region_array(1, DEGREE + 1, sizeof *c), zero = from_int_q(0);
    assert_non_null(c);
    for (int k = 0; k < DEGREE; k++)
        c[k] = zero;
    c[DEGREE] = from_int_q(1);
    poly p = cagd_poly_from_q(DEGREE + 1, c);
    cagd_poly_compose(p, p);
    expect_fault(FAULT_MEMORY);
}

/* A fault stays beside those that were there before. */
static void faults_add_up(void **state)
{
    (void)state;
    num_q one[] = {from_int_q(1)};
    poly p = cagd_poly_from_q(1, one), zero = cagd_poly_sub(p, p);
    region_faults = FAULT_UNABLE;
    cagd_poly_quotient(p, zero);
    expect_fault(FAULT_UNABLE | FAULT_UNDEFINED);
    region_faults = FAULT_UNABLE;
    div_q(one[0], from_int_q(0));
    expect_fault(FAULT_UNABLE | FAULT_UNDEFINED);
}

/* c p for a rational c, whole numbers without a common divisor, the leading one above 0. */
static void primitive_polynomials(void **state)
{
    (void)state;
    const long whole[][4] = {{6, -9, 15, 0}, {0, 0, -4, 0}, {2, 3, 0, -5}, {0, 0, 0, 0}, {-7, 0, 0, 0}, {4, 6, 0, 10}};
    const long expected[][4] = {{2, -3, 5, 0}, {0, 0, 1, 0}, {-2, -3, 0, 5}, {0, 0, 0, 0}, {1, 0, 0, 0}, {2, 3, 0, 5}};
    for (size_t k = 0; k < sizeof whole / sizeof *whole; k++)
        for (int over = 1; over <= 9; over += 4) {
            num_q c[4], d[4];
            for (int i = 0; i < 4; i++)
                c[i] = from_ratio_q(whole[k][i], over), d[i] = from_int_q(expected[k][i]);
            assert_true(cagd_poly_equal(cagd_poly_primitive(poly_from_q(4, c)), poly_from_q(4, d)));
        }
}

/* No polynomial has a Bernstein form of a degree below its own; over an interval without length its value is put in everywhere. */
static void forms_of_every_degree(void **state)
{
    (void)state;
    for (int degree = 0; degree <= 4; degree++)
        for (int n = 0; n <= 6; n++) {
            num_q out[7];
            poly p = random_poly(degree);
            poly_to_bernstein(p, n, from_int_q(0), from_int_q(1), out);
            if (n < degree) {
                expect_fault(FAULT_UNDEFINED);
                continue;
            }
            assert_int_equal(region_faults, 0);
            assert_true(cagd_poly_equal(poly_from_bernstein(n, out), p));
            poly_to_bernstein(p, n, from_ratio_q(2, 3), from_ratio_q(2, 3), out);
            for (int i = 0; i <= n; i++)
                assert_true(cagd_equal_q(out[i], poly_value(p, from_ratio_q(2, 3))));
        }
}

/* A factor may have any multiplicity, and be the only one. */
static void high_multiplicities(void **state)
{
    (void)state;
    for (int m = 1; m <= 12; m++) {
        poly factor[16], p = poly_from_q(2, (num_q[]){from_int_q(-3), from_int_q(2)});
        int multiplicity[16];
        assert_int_equal(poly_squarefree(power(p, m), factor, multiplicity), 1);
        assert_int_equal(multiplicity[0], m);
        assert_true(cagd_poly_divides(factor[0], p) && cagd_poly_divides(p, factor[0]));
    }
    poly factor[1];
    int multiplicity[1];
    assert_int_equal(poly_squarefree(poly_constant(from_int_q(5)), factor, multiplicity), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        unit(bernstein_form_is_the_sum_of_basis_functions),
        unit(to_bernstein_inverts_over_any_interval),
        unit(values_are_homomorphisms),
        unit(division_and_gcd),
        unit(squarefree_decomposition_multiplies_back),
        unit(fractions_of_the_field_in_one_variable),
        unit(text_and_edges),
        unit(degrees_that_no_int_has),
        unit(faults_add_up),
        unit(primitive_polynomials),
        unit(forms_of_every_degree),
        unit(high_multiplicities),
    };
    return run_unit_tests(tests);
}
