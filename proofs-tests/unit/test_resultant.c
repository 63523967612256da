/* test_resultant.c -- resultants against the product over the roots; determinants against Leibniz. */
#include "unit_exact.h"

#include "exact/decide/resultant.h"
#include "exact/words.h"

static num_q q(long m) { return from_int_q(m); }

/* The sum over all permutations, by expansion along the first row. */
static num_q expansion(int n, const num_q A[])
{
    if (n == 0)
        return q(1);
    num_q sum = q(0), *minor = region_bytes((size_t)(n * n) * sizeof *minor);
    for (int c = 0; c < n; c++) {
        for (int i = 1, k = 0; i < n; i++)
            for (int j = 0; j < n; j++)
                if (j != c)
                    minor[k++] = A[i * n + j];
        num_q term = mul_q(A[c], expansion(n - 1, minor));
        sum = c % 2 ? sub_q(sum, term) : add_q(sum, term);
    }
    return sum;
}

static void determinant_is_leibniz(void **state)
{
    (void)state;
    for (int k = 0; k < 200; k++) {
        region_mark m = region_open();
        int n = random_int(0, 6);
        num_q A[36];
        for (int i = 0; i < n * n; i++)
            A[i] = k % 2 ? random_q() : coarse_q(1, 1); /* zeros: pivoting, and singular ones */
        assert_true(cagd_equal_q(cagd_pivoted_determinant_q(n, A), expansion(n, A)));
        region_drop(m);
    }
}

/* At every point the determinant of the values is the value of the determinant. */
static void determinant_over_the_field(void **state)
{
    (void)state;
    field_open(2);
    num_f t = variable_f("t"), s = variable_f("s");
    for (int k = 0; k < 20; k++) {
        region_mark m = region_open();
        int n = random_int(1, 4);
        num_f A[16];
        num_q a[16], t0 = random_q(), s0 = random_q(), value;
        for (int i = 0; i < n * n; i++) {
            long u = random_int(-2, 2), v = random_int(0, 2), w = random_int(-1, 1);
            A[i] = add_f(add_f(mul_f(from_int_f(u), t), mul_f(from_int_f(v), mul_f(s, s))), div_f(from_int_f(w), t));
            a[i] = add_q(add_q(mul_q(q(u), t0), mul_q(q(v), mul_q(s0, s0))), div_q(q(w), t0));
        }
        num_f at = substitute_f(substitute_f(cagd_pivoted_determinant_f(n, A), t, from_rational_f(t0)), s,
                                from_rational_f(s0));
        assert_true(is_constant_f(at, &value));
        assert_true(cagd_equal_q(value, cagd_pivoted_determinant_q(n, a)));
        region_drop(m);
    }
}

/* Of all matrices with one entry in every row and column, t, t + 1, ...: their product, with the sign of the permutation. */
static void determinants_of_permutations(void **state)
{
    (void)state;
    field_open(1);
    num_f t = variable_f("t");
    for (int n = 1; n <= 4; n++)
        for (int code = 0; code < 1 << (2 * n); code++) {
            region_mark m = region_open();
            int column[4], taken = 0, sign = 1;
            for (int i = 0; i < n; i++)
                column[i] = code >> (2 * i) & 3, taken |= 1 << column[i];
            if (taken == (1 << n) - 1) {
                num_f A[16], product = from_int_f(1);
                num_q a[16], value = q(1);
                for (int k = 0; k < n * n; k++)
                    A[k] = from_int_f(0), a[k] = q(0);
                for (int i = 0; i < n; i++) {
                    A[i * n + column[i]] = add_f(t, from_int_f(i)), a[i * n + column[i]] = q(2 + i);
                    product = mul_f(product, A[i * n + column[i]]), value = mul_q(value, q(2 + i));
                    for (int k = 0; k < i; k++)
                        sign *= column[k] > column[i] ? -1 : 1;
                }
                assert_true(equal_f(cagd_pivoted_determinant_f(n, A), mul_f(from_int_f(sign), product)));
                assert_true(cagd_equal_q(cagd_pivoted_determinant_q(n, a), mul_q(q(sign), value)));
            }
            region_drop(m);
        }
    field_close();
}

static void resultant_is_the_product_over_roots(void **state)
{
    (void)state;
    int zeros = 0;
    for (int k = 0; k < 300; k++) {
        region_mark mark = region_open();
        int m = random_int(0, 6), n = random_int(0, 6);
        num_q alpha[6], beta[6], a = random_q(), b = random_q(), product = q(1);
        poly p = poly_constant(a), r = poly_constant(b);
        for (int i = 0; i < m; i++) {
            alpha[i] = k % 2 ? random_q() : coarse_q(5, 3);
            p = poly_mul(p, poly_from_q(2, (num_q[]){neg_q(alpha[i]), q(1)}));
            product = mul_q(product, b);
        }
        for (int j = 0; j < n; j++) {
            beta[j] = k % 2 ? random_q() : coarse_q(5, 3);
            r = poly_mul(r, poly_from_q(2, (num_q[]){neg_q(beta[j]), q(1)}));
            product = mul_q(product, a);
        }
        for (int i = 0; i < m; i++)
            for (int j = 0; j < n; j++)
                product = mul_q(product, sub_q(alpha[i], beta[j]));
        if (!cagd_is_zero_q(a) && !cagd_is_zero_q(b)) {
            assert_true(cagd_equal_q(cagd_poly_resultant_sylvester(p, r), product));
            assert_true(cagd_equal_q(cagd_poly_resultant_bezout(p, r), product));
            zeros += cagd_is_zero_q(product);
        }
        region_drop(mark);
    }
    assert_true(zeros > 20);
    cagd_poly_resultant_sylvester(poly_from_q(0, NULL), poly_variable());
    expect_fault(FAULT_UNDEFINED);
    cagd_poly_resultant_bezout(poly_variable(), poly_from_q(0, NULL));
    expect_fault(FAULT_UNDEFINED);
}

/* Leading coefficients may be 0: the size is what the caller says. */
static void stated_degrees(void **state)
{
    (void)state;
    for (int k = 0; k < 50; k++) {
        num_q a[5] = {random_q(), random_q(), random_q(), random_q(), q(0)}, b[5];
        for (int j = 0; j < 5; j++)
            b[j] = random_q();
        num_q r = cagd_resultant_sylvester_q(4, a, 4, b);
        assert_true(cagd_equal_q(r, cagd_resultant_bezout_q(4, a, 4, b)));
        /* one degree too many: a factor -b_4 or b_4 */
        assert_true(cagd_equal_q(r, mul_q(cagd_resultant_sylvester_q(3, a, 4, b), b[4])));
    }
    num_q a[3] = {q(1), q(2), q(0)}, b[2] = {q(3), q(4)};
    cagd_resultant_bezout_q(2, a, 1, b);
    expect_fault(FAULT_UNDEFINED);
}

/* x = t^2, y = t^3 - t: the resultant in t is the implicit equation, up to sign. */
static void implicit_equation(void **state)
{
    (void)state;
    field_open(2);
    num_f x = variable_f("x"), y = variable_f("y"), zero = from_int_f(0), one = from_int_f(1);
    num_f a[3] = {neg_f(x), zero, one}, b[4] = {neg_f(y), neg_f(one), zero, one};
    num_f expected = sub_f(mul_f(x, mul_f(sub_f(x, one), sub_f(x, one))), mul_f(y, y));
    num_f r = cagd_resultant_sylvester_f(2, a, 3, b);
    assert_true(cagd_is_zero_f(sub_f(r, cagd_resultant_bezout_f(2, a, 3, b))));
    assert_true(cagd_is_zero_f(add_f(r, expected)) || cagd_is_zero_f(sub_f(r, expected)));
}

/* Res_t(x - t^2, y - (t^3 - t)/2) written with t as one of the variables. */
static void resultant_by_a_variable(void **state)
{
    (void)state;
    field_open(3);
    num_f x = variable_f("x"), y = variable_f("y"), t = variable_f("t"), one = from_int_f(1), two = from_int_f(2);
    num_f p = sub_f(x, mul_f(t, t)), q = sub_f(y, div_f(sub_f(mul_f(t, mul_f(t, t)), t), two));
    num_f square = mul_f(x, mul_f(sub_f(x, one), sub_f(x, one)));
    num_f expected = sub_f(mul_f(y, y), div_f(square, from_int_f(4)));
    num_f ratio = div_f(cagd_resultant_by_f(p, q, t), expected);
    assert_true(is_constant_f(ratio, NULL) && !cagd_is_zero_f(ratio));
    /* Of t - x and t - y it has a sign, as of arrays. */
    num_f a[] = {neg_f(x), one}, b[] = {neg_f(y), one};
    num_f linear = cagd_resultant_by_f(sub_f(t, x), sub_f(t, y), t);
    assert_true(cagd_equal_f(linear, sub_f(x, y)));
    assert_true(cagd_equal_f(linear, cagd_resultant_sylvester_f(1, a, 1, b)));
    num_f f = div_f(add_f(mul_f(p, p), y), x);
    assert_true(cagd_is_zero_f(sub_f(coefficient_f(f, t, 2), neg_f(two))));
    assert_true(cagd_is_zero_f(sub_f(coefficient_f(f, t, 0), add_f(x, div_f(y, x)))));
    assert_true(cagd_is_zero_f(coefficient_f(f, t, 1)) && cagd_is_zero_f(coefficient_f(f, t, 5)));
    coefficient_f(f, x, 0);
    expect_fault(FAULT_UNDEFINED);
    coefficient_f(f, mul_f(t, t), 0);
    expect_fault(FAULT_UNDEFINED);
    cagd_resultant_by_f(p, from_int_f(0), t);
    expect_fault(FAULT_UNDEFINED);
    cagd_resultant_by_f(p, div_f(one, t), t);
    expect_fault(FAULT_UNDEFINED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        unit(determinant_is_leibniz),
        unit(determinants_of_permutations),
        unit(determinant_over_the_field),
        unit(resultant_is_the_product_over_roots),
        unit(stated_degrees),
        unit(implicit_equation),
        unit(resultant_by_a_variable),
    };
    return run_unit_tests(tests);
}
