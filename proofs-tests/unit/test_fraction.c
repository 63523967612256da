/* test_fraction.c -- fractions whose denominators are kept factored are, coefficient by coefficient, what FLINT makes of
 * them: sums, differences, products and quotients of random fractions with common factors, some of them repeated, some
 * cancelling, some of a denominator that is too long to be factored.  So are derivatives, a numerator over the denominator
 * of another fraction, and what is said of equality and degrees. */
#include "exact/number/field.h"
#include "exact/number/fraction.h"
#include "exact/words.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

enum { VARIABLES = 5, ROUNDS = 400 };

static uint64_t state_of_random = 20261122;
static long pick(long low, long high)
{
    state_of_random = state_of_random * 6364136223846793005u + 1442695040888963407u;
    return low + (long)((state_of_random >> 33) % (uint64_t)(high - low + 1));
}
static num_f variable(long k) { return variable_f((const char *[]){"a", "b", "c", "d", "e"}[k]); }

/* 1 + c_1 a + c_2 b + ... */
static num_f linear(void)
{
    num_f sum = from_int_f(1);
    for (long k = 0; k < VARIABLES; k++)
        sum = add_f(sum, mul_f(from_int_f(pick(1, 3)), variable(k)));
    return sum;
}
static num_f power(num_f x, int n)
{
    num_f r = from_int_f(1);
    for (int k = 0; k < n; k++)
        r = mul_f(r, x);
    return r;
}
/* 1287 terms, linear in no variable: too long to be factored. */
static num_f long_polynomial(void) { return add_f(power(linear(), 8), variable(pick(0, VARIABLES - 1))); }

/* A difference of two variables, a number times one, a quadratic, or now and then a long polynomial. */
static num_f factor(void)
{
    num_f x = variable(pick(0, VARIABLES - 1)), y = variable(pick(0, VARIABLES - 1));
    switch (pick(0, 9)) {
    case 0:
        return add_f(mul_f(x, y), from_int_f(pick(1, 3)));
    case 1:
        return mul_f(x, from_int_f(pick(1, 6)));
    case 2:
        return pick(0, 9) == 0 ? long_polynomial() : linear();
    default:
        return sub_f(sub_f(x, y), from_int_f(pick(0, 1)));
    }
}

/* A product of up to three factors, of which short ones are repeated now and then; not 0. */
static num_f product(void)
{
    num_f q = from_int_f(1), f = factor();
    for (long k = pick(0, 3); k > 0; k--) {
        if (pick(0, 2) > 0 || fmpz_mpoly_length(f.at->numerator, cagd_field_context()) > 100)
            f = factor();
        if (!cagd_is_zero_f(f))
            q = mul_f(q, f);
    }
    return q;
}
static num_f random_fraction(void)
{
    return div_f(mul_f(from_ratio_f(pick(-6, 6), pick(1, 6)), product()), mul_f(from_int_f(pick(1, 4)), product()));
}

typedef void operation(struct cagd_field_element *, const struct cagd_field_element *,
                       const struct cagd_field_element *);
typedef void reference(fmpz_mpoly_q_t, const fmpz_mpoly_q_t, const fmpz_mpoly_q_t, const fmpz_mpoly_ctx_t);

static int listed, not_factored; /* results with a list of factors, and with a denominator without one */

/* r is what FLINT has. */
static void is_that_of_flint(const struct cagd_field_element *r, const fmpz_mpoly_q_t expected)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    fmpz_mpoly_q_t x;
    fmpz_mpoly_q_init(x, ctx);
    cagd_fraction_get(x, r);
    assert_true(fmpz_mpoly_q_is_canonical(x, ctx));
    assert_true(fmpz_mpoly_q_equal(x, expected, ctx));
    for (int v = 0; v < VARIABLES; v++)
        assert_int_equal(cagd_fraction_denominator_degree(r, v), fmpz_mpoly_degree_si(fmpz_mpoly_q_denref(x), v, ctx));
    assert_int_equal(cagd_fraction_is_polynomial(r), fmpz_mpoly_is_one(fmpz_mpoly_q_denref(x), ctx));
    listed += r->factors.known && r->factors.count > 0;
    not_factored += !r->factors.known;
    fmpz_mpoly_q_clear(x, ctx);
}

static void agrees(operation *op, reference *by_flint, num_f a, num_f b)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    struct cagd_field_element r;
    fmpz_mpoly_q_t expected, x, y;
    cagd_field_slot_init(&r), fmpz_mpoly_q_init(expected, ctx), fmpz_mpoly_q_init(x, ctx), fmpz_mpoly_q_init(y, ctx);
    op(&r, a.at, b.at);
    cagd_fraction_get(x, a.at), cagd_fraction_get(y, b.at);
    by_flint(expected, x, y, ctx);
    is_that_of_flint(&r, expected);
    assert_int_equal(cagd_fraction_equal(a.at, b.at), fmpz_mpoly_q_equal(x, y, ctx));
    assert_int_equal(cagd_fraction_equal(&r, a.at), fmpz_mpoly_q_equal(expected, x, ctx));
    fmpz_mpoly_q_clear(expected, ctx), fmpz_mpoly_q_clear(x, ctx), fmpz_mpoly_q_clear(y, ctx),
        cagd_field_slot_clear(&r);
}

static void all_operations_agree(num_f a, num_f b)
{
    agrees(cagd_fraction_add, fmpz_mpoly_q_add, a, b);
    agrees(cagd_fraction_sub, fmpz_mpoly_q_sub, a, b);
    agrees(cagd_fraction_mul, fmpz_mpoly_q_mul, a, b);
    if (!cagd_is_zero_f(b))
        agrees(cagd_fraction_div, fmpz_mpoly_q_div, a, b);
}

/* (p/q)' = (p' q - p q')/q^2 */
static void derivative_agrees(num_f a, int variable)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    struct cagd_field_element r;
    fmpz_mpoly_q_t x, p, q;
    cagd_field_slot_init(&r), fmpz_mpoly_q_init(x, ctx), fmpz_mpoly_q_init(p, ctx), fmpz_mpoly_q_init(q, ctx);
    cagd_fraction_derivative(&r, a.at, variable);
    cagd_fraction_get(x, a.at);
    fmpz_mpoly_derivative(fmpz_mpoly_q_numref(p), fmpz_mpoly_q_numref(x), variable, ctx);
    fmpz_mpoly_derivative(fmpz_mpoly_q_numref(q), fmpz_mpoly_q_denref(x), variable, ctx);
    fmpz_mpoly_q_mul(q, q, x, ctx); /* q' p/q */
    fmpz_mpoly_q_sub(p, p, q, ctx);
    fmpz_mpoly_set(fmpz_mpoly_q_numref(q), fmpz_mpoly_q_denref(x), ctx);
    fmpz_mpoly_one(fmpz_mpoly_q_denref(q), ctx);
    fmpz_mpoly_q_div(x, p, q, ctx);
    is_that_of_flint(&r, x);
    fmpz_mpoly_q_clear(x, ctx), fmpz_mpoly_q_clear(p, ctx), fmpz_mpoly_q_clear(q, ctx), cagd_field_slot_clear(&r);
}

/* The numerator of a over the denominator of b. */
static void over_denominator_agrees(num_f a, num_f b)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    struct cagd_field_element r;
    fmpz_mpoly_q_t x;
    cagd_field_slot_init(&r), fmpz_mpoly_q_init(x, ctx);
    cagd_fraction_over_denominator_of(&r, a.at->numerator, b.at);
    fmpz_mpoly_set(fmpz_mpoly_q_numref(x), a.at->numerator, ctx);
    cagd_fraction_denominator(fmpz_mpoly_q_denref(x), b.at);
    fmpz_mpoly_q_canonicalise(x, ctx);
    is_that_of_flint(&r, x);
    fmpz_mpoly_q_clear(x, ctx), cagd_field_slot_clear(&r);
}

/* Two fractions with the same numerator, or nearly, over denominators that differ in an integer, in one factor, or not at all. */
static int alike, different;
static void equality_agrees(void)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    num_f p = from_int_f(7), f = product(), g = product(), q = mul_f(f, g);
    for (long k = 0; k < VARIABLES; k++)
        p = add_f(p, mul_f(from_int_f(k + 1), variable(k)));
    num_f x = div_f(div_f(p, f), g), y;
    switch (pick(0, 6)) {
    case 0:
        y = div_f(p, mul_f(g, f));
        break;
    case 1:
        y = div_f(p, mul_f(from_int_f(5), q));
        break;
    case 2:
        y = div_f(p, mul_f(q, sub_f(variable(0), variable(1))));
        break;
    case 3:
        y = div_f(p, mul_f(f, mul_f(g, g)));
        break;
    case 4:
        y = div_f(p, mul_f(f, product()));
        break;
    case 5: /* FLINT has it without the factors */
        x = div_f(p, f), q = long_polynomial();
        y = mul_f(div_f(p, q), div_f(q, f));
        break;
    default:
        y = div_f(add_f(p, from_int_f(1)), q);
    }
    fmpz_mpoly_q_t a, b;
    fmpz_mpoly_q_init(a, ctx), fmpz_mpoly_q_init(b, ctx);
    cagd_fraction_get(a, x.at), cagd_fraction_get(b, y.at);
    int same = fmpz_mpoly_q_equal(a, b, ctx);
    assert_int_equal(equal_f(x, y), same);
    assert_int_equal(equal_f(y, x), same);
    alike += same;
    different += !same && fmpz_mpoly_equal(fmpz_mpoly_q_numref(a), fmpz_mpoly_q_numref(b), ctx);
    fmpz_mpoly_q_clear(a, ctx), fmpz_mpoly_q_clear(b, ctx);
}

static void fractions_are_those_of_flint(void **state)
{
    (void)state;
    field_open(VARIABLES);
    for (int round = 0; round < ROUNDS; round++) {
        region_mark mark = region_open();
        num_f a = random_fraction(), b = random_fraction(), c = random_fraction();
        switch (pick(0, 6)) { /* common factors, and sums and products in which something cancels */
        case 0:
            b = sub_f(c, a);
            break;
        case 1:
            b = div_f(a, product());
            break;
        case 2:
            a = div_f(b, product());
            break;
        case 3:
            b = cagd_is_zero_f(a) ? b : div_f(product(), a);
            break;
        case 4:
            a = cagd_is_zero_f(b) ? a : div_f(product(), b);
        }
        all_operations_agree(a, b);
        agrees(cagd_fraction_sub, fmpz_mpoly_q_sub, a, a);
        derivative_agrees(a, round % VARIABLES);
        over_denominator_agrees(a, b);
        assert_true(equal_f(add_f(add_f(a, b), c), add_f(a, add_f(b, c))));
        equality_agrees();
        region_drop(mark);
    }
    assert_true(listed > ROUNDS && not_factored > ROUNDS / 20 && alike > ROUNDS / 10 && different > ROUNDS / 4);
    region_free_all();
    field_close();
    flint_cleanup();
}

/* (1 + x f^2)/(g f^2) by x is 1/g; and powers up to the greatest that a list holds, and beyond. */
static void powers_of_factors(void **state)
{
    (void)state;
    field_open(VARIABLES);
    num_f x = variable(0), f = sub_f(variable(1), variable(2)), g = add_f(variable(3), from_int_f(2)),
          one = from_int_f(1);
    num_f a = div_f(div_f(add_f(one, mul_f(x, power(f, 2))), g), power(f, 2));
    derivative_agrees(a, 0);
    assert_true(equal_f(derivative_f(a, x), div_f(one, g)));
    num_f half = one;
    for (int k = 0; k < FIELD_MOST_POWER / 2; k++)
        half = div_f(half, f);
    agrees(cagd_fraction_mul, fmpz_mpoly_q_mul, half, half);
    num_f most = mul_f(half, half), beyond = div_f(most, f);
    assert_true(most.at->factors.known && !beyond.at->factors.known);
    agrees(cagd_fraction_mul, fmpz_mpoly_q_mul, div_f(one, mul_f(g, f)), most);
    agrees(cagd_fraction_div, fmpz_mpoly_q_div, most, mul_f(f, g));
    agrees(cagd_fraction_add, fmpz_mpoly_q_add, most, beyond);
    agrees(cagd_fraction_sub, fmpz_mpoly_q_sub, beyond, half);
    assert_true(equal_f(mul_f(beyond, f), most) && equal_f(most, mul_f(beyond, f)));
    for (int k = 0; k < 256; k++) { /* of two factors, each up to the third */
        region_mark mark = region_open();
        num_f p = add_f(x, mul_f(power(f, k % 2), power(g, k % 3))), q = add_f(x, from_int_f(2));
        all_operations_agree(div_f(p, mul_f(power(f, k % 4), power(g, k / 4 % 4))),
                             div_f(q, mul_f(power(f, k / 16 % 4), power(g, k / 64))));
        region_drop(mark);
    }
    region_free_all();
    field_close();
    flint_cleanup();
}

/* Numbers with numbers and with what is none. */
static void numbers(void **state)
{
    (void)state;
    field_open(VARIABLES);
    num_f x = variable(0), others[] = {x, sub_f(x, from_int_f(3)), div_f(from_int_f(2), sub_f(x, variable(1)))};
    for (int m = -4; m <= 4; m++)
        for (int n = 1; n <= 6; n++) {
            num_f a = from_ratio_f(m, n);
            for (int i = -4; i <= 4; i++)
                for (int j = 1; j <= 6; j++)
                    all_operations_agree(a, from_ratio_f(i, j));
            for (int k = 0; k < 3; k++) {
                all_operations_agree(a, others[k]);
                all_operations_agree(others[k], a);
            }
        }
    region_free_all();
    field_close();
    flint_cleanup();
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(fractions_are_those_of_flint),
                                       cmocka_unit_test(powers_of_factors), cmocka_unit_test(numbers)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
