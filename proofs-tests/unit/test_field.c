/* test_field.c -- what is asked of a rational function: signs of coefficients, degrees, variables; and what is refused. */
#include "unit_exact.h"

#include "exact/number/field.h"
#include "exact/number/parallel.h"
#include "exact/words.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

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

/* 1/x, 1/(x y), and 1 over what is too long to be factored are no numbers, nor linear, nor variables; x/2, 2x and -x are no variables either. */
static void what_is_no_number_and_no_variable(void **state)
{
    (void)state;
    cagd_field_open(5);
    const num_f one = from_int_f(1), x = variable_f("x"), y = variable_f("y"), z = variable_f("z"), u = variable_f("u"),
                v = variable_f("v");
    num_f sum = add_f(add_f(add_f(add_f(add_f(one, x), y), z), u), v), lengthy = one;
    for (int k = 0; k < 8; k++)
        lengthy = mul_f(lengthy, sum);
    lengthy = add_f(lengthy, x); /* 1287 terms, linear in no variable */
    const num_f none[] = {div_f(one, x),
                          div_f(one, mul_f(x, y)),
                          div_f(one, lengthy),
                          div_f(from_int_f(3), lengthy),
                          div_f(x, lengthy),
                          lengthy,
                          x,
                          div_f(x, y)};
    struct cagd_linear form;
    for (size_t k = 0; k < sizeof none / sizeof *none; k++) {
        assert_false(is_constant_f(none[k], NULL));
        int is_x = k == 6;
        assert_int_equal(field_variable_f(none[k]), is_x ? 0 : -1);
        assert_int_equal(cagd_linear_f(none[k], &form) != 0, is_x);
    }
    const num_f like_x[] = {div_f(x, from_int_f(2)),
                            mul_f(from_int_f(2), x),
                            neg_f(x),
                            mul_f(x, x),
                            mul_f(x, y),
                            add_f(x, one),
                            sub_f(x, x),
                            one};
    for (size_t k = 0; k < sizeof like_x / sizeof *like_x; k++) {
        assert_int_equal(field_variable_f(like_x[k]), -1);
        derivative_f(x, like_x[k]);
        expect_fault(FAULT_UNDEFINED);
    }
    num_q value;
    for (int m = -2; m <= 2; m++) {
        assert_true(is_constant_f(from_ratio_f(m, 7), &value) && cagd_equal_q(value, from_ratio_q(m, 7)));
        assert_true(is_constant_f(from_ratio_f(m, 7), NULL));
    }
    /* all five variables and a number, over a number */
    assert_true(cagd_linear_f(div_f(sum, from_int_f(-3)), &form));
    assert_int_equal(form.count, 5);
    assert_true(cagd_equal_q(form.constant, from_ratio_q(-1, 3)));
    for (int k = 0; k < 5; k++) {
        assert_true(cagd_equal_q(form.coefficient[k], from_ratio_q(-1, 3)));
        for (int j = 0; j < k; j++)
            assert_int_not_equal(form.variable[j], form.variable[k]);
    }
    assert_true(cagd_linear_f(from_int_f(0), &form) && form.count == 0 && cagd_is_zero_q(form.constant));
    field_close();
}

/* Names of one to fifteen letters, in the order in which they came. */
static void names_of_variables(void **state)
{
    (void)state;
    char name[FIELD_MAX_NAME + 2] = "", all[FIELD_MAX_NAME * FIELD_MAX_NAME] = "";
    cagd_field_open(FIELD_MAX_NAME);
    assert_string_equal(cagd_field_variables(), "");
    for (int length = 1; length <= FIELD_MAX_NAME; length++) {
        name[length - 1] = (char)('a' + length);
        assert_int_equal(field_variable_f(variable_f(name)), length - 1);
        snprintf(all + strlen(all), sizeof all - strlen(all), length > 1 ? " %s" : "%s", name);
        assert_string_equal(cagd_field_variables(), all);
        assert_string_equal(to_string_f(variable_f(name)), name);
    }
    assert_int_equal(region_faults, 0);
    variable_f("sixteen_letters_");
    expect_fault(FAULT_UNABLE);
    cagd_field_open(2); /* those of another field are gone */
    assert_string_equal(cagd_field_variables(), "");
    field_close();
}

/* The parts of a fraction in parentheses only where they have to be. */
static void texts_of_fractions(void **state)
{
    (void)state;
    cagd_field_open(2);
    const num_f t = variable_f("t"), w = variable_f("w"), one = from_int_f(1), four = from_int_f(4), tw = mul_f(t, w),
                t2 = mul_f(t, t);
    const struct {
        num_f f;
        const char *text;
    } list[] = {{div_f(tw, four), "t*w/4"},
                {div_f(neg_f(tw), four), "-t*w/4"},
                {div_f(mul_f(from_int_f(3), t), four), "3*t/4"},
                {div_f(t, tw), "1/w"},
                {div_f(t2, w), "t^2/w"},
                {div_f(w, t2), "w/t^2"},
                {div_f(one, tw), "1/(t*w)"},
                {div_f(add_f(t, w), four), "(t+w)/4"},
                {div_f(add_f(neg_f(t), w), four), "(-t+w)/4"},
                {div_f(one, add_f(t, w)), "1/(t+w)"},
                {div_f(one, sub_f(t, w)), "1/(t-w)"},
                {div_f(sub_f(t, w), add_f(t, w)), "(t-w)/(t+w)"},
                {div_f(neg_f(one), t), "-1/t"},
                {from_int_f(-7), "-7"},
                {add_f(t, one), "t+1"}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        assert_string_equal(to_string_f(list[k].f), list[k].text);
    field_close();
}

/* (3 + 5 v^2 - 7 v^4 w)/(2 (w + 1) w): every coefficient over the same denominator, in lowest terms, those that are missing 0; so over one that is not factored. */
static void coefficients_of_fractions(void **state)
{
    (void)state;
    cagd_field_open(6);
    const num_f v = variable_f("v"), w = variable_f("w"), one = from_int_f(1);
    num_f sum = add_f(add_f(add_f(add_f(add_f(one, w), variable_f("a")), variable_f("b")), variable_f("c")),
                      variable_f("d")),
          lengthy = one;
    for (int k = 0; k < 8; k++)
        lengthy = mul_f(lengthy, sum);
    lengthy = add_f(lengthy, w);
    const num_f c[] = {from_int_f(3), from_int_f(0), from_int_f(5), from_int_f(0), mul_f(from_int_f(-7), w)},
                below[] = {mul_f(from_int_f(2), mul_f(w, add_f(w, one))), lengthy, from_int_f(15), one};
    for (int d = 0; d < 4; d++) {
        num_f p = from_int_f(0), power = one;
        for (int k = 0; k < 5; k++, power = mul_f(power, v))
            p = add_f(p, mul_f(c[k], power));
        p = div_f(p, below[d]);
        for (int k = -1; k <= 6; k++)
            assert_true(equal_f(coefficient_f(p, v, k), k < 0 || k > 4 ? from_int_f(0) : div_f(c[k], below[d])));
        coefficient_f(div_f(p, v), v, 0);
        expect_fault(FAULT_UNDEFINED);
        assert_true(equal_f(mul_f(cagd_numerator_f(p), one), mul_f(p, cagd_denominator_f(p))));
        assert_true(equal_f(cagd_denominator_f(cagd_numerator_f(p)), one) &&
                    equal_f(cagd_denominator_f(cagd_denominator_f(p)), one));
    }
    field_close();
}

/* 6 w (x - w) (x^2 + w)^2 (x + 1)^3 (w - 2)^4 over anything, by x: three factors of powers 1, 2, 3, as long as there is room for three. */
static void factors_with_a_variable(void **state)
{
    (void)state;
    cagd_field_open(2);
    const num_f x = variable_f("x"), w = variable_f("w"), one = from_int_f(1);
    const num_f expected[] = {sub_f(x, w), add_f(mul_f(x, x), w), add_f(x, one)}, other = sub_f(w, from_int_f(2));
    num_f p = mul_f(from_int_f(6), w), factor[5];
    int power[5];
    for (int k = 0; k < 3; k++)
        for (int e = 0; e <= k; e++)
            p = mul_f(p, expected[k]);
    for (int e = 0; e < 4; e++)
        p = mul_f(p, other);
    for (int room = 0; room <= 5; room++)
        for (int over = 0; over < 2; over++) {
            int count = cagd_factors_f(over ? div_f(p, add_f(x, from_int_f(9))) : p, x, room, factor, power), seen = 0;
            assert_int_equal(count, room < 3 ? -1 : 3);
            for (int i = 0; i < count; i++)
                for (int k = 0; k < 3; k++)
                    if (equal_f(factor[i], expected[k]) || equal_f(factor[i], neg_f(expected[k]))) {
                        assert_int_equal(power[i], k + 1);
                        seen |= 1 << k;
                    }
            assert_int_equal(seen, count > 0 ? 7 : 0);
            assert_int_equal(region_faults, 0);
        }
    assert_int_equal(cagd_factors_f(mul_f(w, w), x, 5, factor, power), 0);
    assert_int_equal(cagd_factors_f(p, add_f(x, w), 5, factor, power), -1);
    expect_fault(FAULT_UNABLE);
    field_close();
}

/* Of more different divisors than are kept, with and without common factors: 1/(x+n) - 1/(x+n+1) is 1/((x+n)(x+n+1)). */
static void more_divisors_than_are_kept(void **state)
{
    (void)state;
    enum { MOST = 260 };
    cagd_field_open(1);
    const num_f x = variable_f("x"), one = from_int_f(1);
    num_f part[MOST];
    for (int round = 0; round < 2; round++)
        for (int n = 0; n < MOST; n++) {
            num_f a = add_f(x, from_int_f(n)), b = add_f(a, one);
            part[n] = div_f(one, a);
            assert_true(equal_f(mul_f(part[n], a), one));
            assert_int_equal(denominator_degree_f(part[n], x), 1);
            num_f both = div_f(one, mul_f(a, b));
            assert_true(equal_f(sub_f(part[n], div_f(one, b)), both));
            assert_int_equal(denominator_degree_f(mul_f(both, both), x), 4);
            if (n > 0)
                assert_true(equal_f(sub_f(part[n - 1], part[n]), mul_f(part[n - 1], part[n])));
        }
    field_close();
}

/* Of work in parallel: each piece once, in order begun, on no more threads than there are jobs and on as many. */
struct pieces {
    pthread_mutex_t lock;
    pthread_cond_t all;
    int begun, now, most, wanted, often[24], order[24], in_other_thread;
    pthread_t caller;
};
static void piece(void *context, int k)
{
    struct pieces *p = context;
    struct timespec until;
    clock_gettime(CLOCK_REALTIME, &until);
    until.tv_sec += 20;
    pthread_mutex_lock(&p->lock);
    p->order[p->begun++] = k;
    p->often[k]++;
    p->in_other_thread += !pthread_equal(p->caller, pthread_self());
    p->now++;
    p->most = p->now > p->most ? p->now : p->most;
    pthread_cond_broadcast(&p->all);
    while (p->most < p->wanted) /* until so many are at work */
        if (pthread_cond_timedwait(&p->all, &p->lock, &until) != 0)
            break;
    p->now--;
    pthread_mutex_unlock(&p->lock);
    region_faults |= FAULT_CROWDED; /* gone with the thread */
    variable_f("mine");
}
static void pieces_of_work(void **state)
{
    (void)state;
    const int jobs[] = {-1, 0, 1, 2, 3, 5, 100};
    cagd_field_open(1);
    num_f x = variable_f("x");
    for (int j = 0; j < 7; j++)
        for (int count = 0; count <= 24; count += count < 6 ? 1 : 9) {
            int threads = jobs[j] < 1 ? 1 : jobs[j] < count ? jobs[j] : count;
            struct pieces p = {.wanted = threads, .caller = pthread_self()};
            pthread_mutex_init(&p.lock, NULL), pthread_cond_init(&p.all, NULL);
            cagd_in_parallel(jobs[j], count, piece, &p);
            assert_int_equal(p.begun, count);
            assert_int_equal(p.in_other_thread, count);
            assert_int_equal(p.most, count > 0 ? threads : 0);
            for (int k = 0; k < 24; k++)
                assert_int_equal(p.often[k], k < count);
            for (int k = 0; k < count && threads == 1; k++)
                assert_int_equal(p.order[k], k);
            pthread_mutex_destroy(&p.lock), pthread_cond_destroy(&p.all);
        }
    assert_int_equal(region_faults, 0);
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
        unit(what_is_no_number_and_no_variable),
        unit(names_of_variables),
        unit(texts_of_fractions),
        unit(coefficients_of_fractions),
        unit(factors_with_a_variable),
        unit(more_divisors_than_are_kept),
        unit(pieces_of_work),
    };
    return run_unit_tests(tests);
}
