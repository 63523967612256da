/* test_field.c -- what is asked of a rational function: signs of coefficients, degrees, variables; and what is refused. */
#include "unit_exact.h"

#include "exact/number/field.h"
#include "exact/number/parallel.h"
#include "exact/words.h"

#include <pthread.h>
#include <stdio.h>

/* sum s_i v^i with coefficients of these signs, and over (v + 1)^2 and over v - 1: the sign is read off all coefficients. */
static void signs_of_all_coefficients(void **state)
{
    (void)state;
    cagd_field_open(2);
    num_f v = variable_f("v"), w = variable_f("w"), plus = add_f(v, from_int_f(1)), minus = sub_f(v, from_int_f(1));
    for (int length = 1; length <= 5; length++)
        for (int code = 0, codes = length == 5   ? 243
                                   : length == 4 ? 81
                                   : length == 3 ? 27
                                   : length == 2 ? 9
                                                 : 3;
             code < codes; code++) {
            region_mark m = region_open();
            num_f p = from_int_f(0), power = from_int_f(1);
            int positive = 0, negative = 0;
            for (int i = 0, rest = code; i < length; i++, rest /= 3, power = mul_f(power, i % 2 ? v : w)) {
                p = add_f(p, mul_f(from_int_f((rest % 3 - 1) * (i + 2)), power));
                positive += rest % 3 == 2, negative += rest % 3 == 0;
            }
            int sign = positive && negative ? -2 : positive ? 1 : negative ? -1 : 0;
            assert_int_equal(coefficients_sign_f(p), sign);
            if (sign != 0 && sign != -2) {
                assert_int_equal(coefficients_sign_f(div_f(p, mul_f(plus, add_f(w, plus)))), sign);
                assert_int_equal(coefficients_sign_f(div_f(from_int_f(sign), mul_f(plus, add_f(w, plus)))), sign);
                assert_int_equal(coefficients_sign_f(div_f(from_int_f(sign), minus)), -2);
            }
            region_drop(m);
        }
    field_close();
}

/* x^1 y^2 z^3 u^4 over (x + 2y + 3z + 4u): degrees, coefficients, values and derivatives by each of four variables. */
static void functions_of_each_of_four_variables(void **state)
{
    (void)state;
    field_open(4);
    const num_f x[4] = {variable_f("x"), variable_f("y"), variable_f("z"), variable_f("u")};
    num_f product = from_int_f(1), sum = from_int_f(0);
    for (int k = 0; k < 4; k++) {
        for (int e = 0; e <= k; e++)
            product = mul_f(product, x[k]);
        sum = add_f(sum, mul_f(from_int_f(k + 1), x[k]));
    }
    num_f f = div_f(product, sum);
    for (int k = 0; k < 4; k++) {
        num_f rest = product; /* the coefficient of x_k^(k+1) in the product */
        for (int e = 0; e <= k; e++)
            rest = div_f(rest, x[k]);
        assert_int_equal(degree_f(f, x[k]), k + 1);
        assert_int_equal(denominator_degree_f(f, x[k]), 1);
        assert_true(equal_f(coefficient_f(product, x[k], k + 1), rest));
        assert_true(equal_f(substitute_f(product, x[k], from_int_f(1)), rest));
        /* f' = (k+1) f / x_k - (k+1) f / sum */
        num_f c = mul_f(from_int_f(k + 1), f);
        assert_true(equal_f(derivative_f(f, x[k]), sub_f(div_f(c, x[k]), div_f(c, sum))));
    }
    field_close();
}

static void degrees_and_answers_without_a_variable(void **state)
{
    (void)state;
    cagd_field_open(2);
    num_f v = variable_f("v"), w = variable_f("w"), no = add_f(v, w);
    num_f a = div_f(add_f(mul_f(v, mul_f(v, w)), from_int_f(3)), add_f(w, mul_f(v, v)));
    assert_int_equal(degree_f(a, v), 2);
    assert_int_equal(denominator_degree_f(a, v), 2);
    assert_int_equal(degree_f(a, w), 1);
    assert_int_equal(denominator_degree_f(a, w), 1);
    for (int i = 0; i <= 3; i++)
        for (int j = 0; j <= 3; j++) {
            assert_int_equal(cagd_has_degrees_f(a, v, i, j), i == 2 && j == 2);
            assert_int_equal(cagd_has_degrees_f(a, w, i, j), i == 1 && j == 1);
        }
    assert_int_equal(degree_f(from_int_f(0), v), -1);
    assert_int_equal(degree_f(a, no), -1);
    expect_fault(FAULT_UNDEFINED);
    assert_int_equal(denominator_degree_f(a, no), -1);
    expect_fault(FAULT_UNDEFINED);
    substitute_f(a, no, v);
    expect_fault(FAULT_UNDEFINED);
    derivative_f(a, no);
    expect_fault(FAULT_UNDEFINED);
    coefficient_f(a, v, 0);
    expect_fault(FAULT_UNDEFINED);
    div_f(a, from_int_f(0));
    expect_fault(FAULT_UNDEFINED);
    from_ratio_f(1, 0);
    expect_fault(FAULT_UNDEFINED);
    assert_true(equal_f(from_ratio_f(3, -1), from_int_f(-3)));
    root_f(0, a);
    expect_fault(FAULT_UNABLE);
    root_f(-2, mul_f(a, a));
    expect_fault(FAULT_UNABLE);
    assert_true(equal_f(root_f(1, a), a));
    field_close();
}

/* More variables than there can be: room for FIELD_MAX_VARIABLES, and the fault beside one that was there. */
static void as_many_variables_as_there_can_be(void **state)
{
    (void)state;
    char name[16];
    region_faults = FAULT_MEMORY;
    cagd_field_open(FIELD_MAX_VARIABLES + 1);
    expect_fault(FAULT_MEMORY | FAULT_UNABLE);
    num_f sum = from_int_f(0);
    for (int i = 0; i < FIELD_MAX_VARIABLES; i++) {
        snprintf(name, sizeof name, "x%d", i);
        sum = add_f(sum, variable_f(name));
        assert_int_equal(field_variable_f(variable_f(name)), i);
    }
    assert_int_equal(field_variable_f(sum), -1);
    variable_f("another");
    expect_fault(FAULT_CROWDED);
    cagd_field_open(0); /* room for one */
    variable_f("a");
    assert_int_equal(region_faults, 0);
    variable_f("b");
    expect_fault(FAULT_CROWDED);
    variable_f("sixteen_letters_"); /* one letter too many */
    expect_fault(FAULT_UNABLE);
    field_close();
}

/* A thread that opened no field has one for one variable. */
static void *work_without_a_field(void *state)
{
    int *good = state;
    num_f three = from_int_f(3), a = variable_f("a");
    *good = region_faults == 0 && equal_f(div_f(mul_f(three, a), a), three);
    variable_f("b");
    *good &= region_faults == FAULT_CROWDED;
    cagd_thread_end();
    return NULL;
}
static void a_field_that_nobody_opened(void **state)
{
    (void)state;
    int good = 0;
    pthread_t thread;
    assert_int_equal(pthread_create(&thread, NULL, work_without_a_field, &good), 0);
    assert_int_equal(pthread_join(thread, NULL), 0);
    assert_true(good);
}

/* A word has 64 bits: of the largest coefficient for each term, above and below; and of 0 over anything nothing is left. */
static void sizes(void **state)
{
    (void)state;
    cagd_field_open(2);
    num_f t = variable_f("t"), s = variable_f("s"), one = from_int_f(1), large = one;
    for (int k = 0; k < 100; k++)
        large = add_f(large, large);
    num_f q = add_f(t, one), p = add_f(add_f(mul_f(large, t), s), one), a = div_f(p, q); /* 101 bits */
    assert_int_equal(cagd_words_f(p), 3 * 2 + 1);
    assert_int_equal(cagd_words_f(a), 3 * 2 + 2);
    assert_int_equal(cagd_words_f(div_f(one, p)), 1 + 3 * 2);
    assert_int_equal(cagd_words_f(div_f(one, neg_f(p))), 1 + 3 * 2);
    num_f nothing = sub_f(a, a);
    assert_true(equal_f(cagd_denominator_f(nothing), one));
    assert_string_equal(to_string_f(nothing), "0");
    nothing = sub_f(add_f(a, s), add_f(s, a));
    assert_true(equal_f(cagd_denominator_f(nothing), one));
    field_close();
}

/* a + b x + c y is linear; x y, x^2 and what is divided by a variable are not. */
static void linear_forms(void **state)
{
    (void)state;
    cagd_field_open(3);
    num_f x = variable_f("x"), y = variable_f("y"), one = from_int_f(1), half = from_ratio_f(1, 2);
    struct cagd_linear form;
    assert_true(cagd_linear_f(add_f(add_f(half, mul_f(from_int_f(3), x)), neg_f(y)), &form));
    assert_int_equal(form.count, 2);
    assert_true(cagd_equal_q(form.constant, from_ratio_q(1, 2)));
    for (int k = 0; k < 2; k++)
        assert_true(
            cagd_equal_q(form.coefficient[k], from_int_q(form.variable[k] == cagd_field_variable_f(x) ? 3 : -1)));
    assert_true(cagd_linear_f(half, &form));
    assert_int_equal(form.count, 0);
    const num_f none[] = {mul_f(x, y),   mul_f(x, x), add_f(one, mul_f(x, y)),
                          div_f(one, x), div_f(x, y), div_f(x, add_f(x, one))};
    for (size_t k = 0; k < sizeof none / sizeof *none; k++)
        assert_false(cagd_linear_f(none[k], &form));
    field_close();
}

/* 1/((x+1)...(x+n)), of more factors than a list of them has room for, times (x+1)...(x+n) is 1, and it is equal to itself in other
 * ways of making it. */
static void more_factors_than_a_list_has(void **state)
{
    (void)state;
    enum { MOST = 40 };
    cagd_field_open(2);
    num_f x = variable_f("x"), up = from_int_f(1), down = up, product = up;
    for (int n = 1; n <= MOST; n++) {
        up = div_f(up, add_f(x, from_int_f(n)));
        product = mul_f(product, add_f(x, from_int_f(n)));
        assert_int_equal(denominator_degree_f(up, x), n);
        assert_true(equal_f(mul_f(up, product), from_int_f(1)));
        assert_true(equal_f(up, div_f(from_int_f(1), product)));
    }
    for (int n = MOST; n >= 1; n--)
        down = div_f(down, add_f(x, from_int_f(n)));
    assert_true(equal_f(up, down));
    field_close();
}

/* Where there is nothing to do in parallel, nothing is touched. */
static void no_work(void **state)
{
    (void)state;
    cagd_field_open(1);
    num_f x = variable_f("x");
    cagd_in_parallel(2, 0, NULL, NULL);
    assert_string_equal(cagd_field_variables(), "x");
    assert_true(equal_f(x, variable_f("x")));
    field_close();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        unit(signs_of_all_coefficients),
        unit(functions_of_each_of_four_variables),
        unit(degrees_and_answers_without_a_variable),
        unit(as_many_variables_as_there_can_be),
        unit(a_field_that_nobody_opened),
        unit(sizes),
        unit(linear_forms),
        unit(more_factors_than_a_list_has),
        unit(no_work),
    };
    return run_unit_tests(tests);
}
