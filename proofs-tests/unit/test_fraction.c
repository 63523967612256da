/* test_fraction.c -- fractions whose denominators are kept factored are, coefficient by coefficient, what FLINT makes of
 * them: sums, differences, products and quotients of random fractions with common factors, some of them repeated, some
 * cancelling, some of a denominator that is too long to be factored.  So are derivatives, a numerator over the denominator
 * of another fraction, and what is said of equality and degrees. */
#include "exact/fraction.h"
#include "exact/num_field.h"

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

/* A difference of two variables, a number times one, a quadratic, or now and then a long polynomial. */
static num_f factor(void)
{
    num_f x = variable(pick(0, VARIABLES - 1)), y = variable(pick(0, VARIABLES - 1));
    switch (pick(0, 9)) {
    case 0:
        return add_f(mul_f(x, y), from_int_f(pick(1, 3)));
    case 1:
        return mul_f(x, from_int_f(pick(1, 6)));
    case 2: {
        num_f sum = from_int_f(1);
        for (long k = 0; k < VARIABLES; k++)
            sum = add_f(sum, mul_f(from_int_f(pick(1, 3)), variable(k)));
        num_f power = sum;
        for (int k = 1; k < 8; k++) /* 1287 terms */
            power = mul_f(power, sum);
        return pick(0, 9) == 0 ? add_f(power, x) : sum;
    }
    default:
        return sub_f(sub_f(x, y), from_int_f(pick(0, 1)));
    }
}

static num_f random_fraction(void)
{
    num_f p = from_ratio_f(pick(-6, 6), pick(1, 6)), q = from_int_f(pick(1, 4));
    for (long k = pick(0, 3); k > 0; k--)
        p = mul_f(p, factor());
    for (long k = pick(0, 3); k > 0; k--) {
        num_f f = factor();
        if (!is_zero_f(f))
            q = mul_f(q, f);
    }
    return div_f(p, q);
}

typedef void operation(struct field_element *, const struct field_element *, const struct field_element *);
typedef void reference(fmpz_mpoly_q_t, const fmpz_mpoly_q_t, const fmpz_mpoly_q_t, const fmpz_mpoly_ctx_t);

static int listed, not_factored; /* results with a list of factors, and with a denominator without one */

/* r is what FLINT has. */
static void is_that_of_flint(const struct field_element *r, const fmpz_mpoly_q_t expected)
{
    const fmpz_mpoly_ctx_struct *ctx = field_context();
    fmpz_mpoly_q_t x;
    fmpz_mpoly_q_init(x, ctx);
    fraction_get(x, r);
    assert_true(fmpz_mpoly_q_is_canonical(x, ctx));
    assert_true(fmpz_mpoly_q_equal(x, expected, ctx));
    for (int v = 0; v < VARIABLES; v++)
        assert_int_equal(fraction_denominator_degree(r, v), fmpz_mpoly_degree_si(fmpz_mpoly_q_denref(x), v, ctx));
    assert_int_equal(fraction_is_polynomial(r), fmpz_mpoly_is_one(fmpz_mpoly_q_denref(x), ctx));
    listed += r->factors.known && r->factors.count > 0;
    not_factored += !r->factors.known;
    fmpz_mpoly_q_clear(x, ctx);
}

static void agrees(operation *op, reference *by_flint, num_f a, num_f b)
{
    const fmpz_mpoly_ctx_struct *ctx = field_context();
    struct field_element r;
    fmpz_mpoly_q_t expected, x, y;
    field_slot_init(&r), fmpz_mpoly_q_init(expected, ctx), fmpz_mpoly_q_init(x, ctx), fmpz_mpoly_q_init(y, ctx);
    op(&r, a.at, b.at);
    fraction_get(x, a.at), fraction_get(y, b.at);
    by_flint(expected, x, y, ctx);
    is_that_of_flint(&r, expected);
    assert_int_equal(fraction_equal(a.at, b.at), fmpz_mpoly_q_equal(x, y, ctx));
    assert_int_equal(fraction_equal(&r, a.at), fmpz_mpoly_q_equal(expected, x, ctx));
    fmpz_mpoly_q_clear(expected, ctx), fmpz_mpoly_q_clear(x, ctx), fmpz_mpoly_q_clear(y, ctx), field_slot_clear(&r);
}

/* (p/q)' = (p' q - p q')/q^2 */
static void derivative_agrees(num_f a, int variable)
{
    const fmpz_mpoly_ctx_struct *ctx = field_context();
    struct field_element r;
    fmpz_mpoly_q_t x, p, q;
    field_slot_init(&r), fmpz_mpoly_q_init(x, ctx), fmpz_mpoly_q_init(p, ctx), fmpz_mpoly_q_init(q, ctx);
    fraction_derivative(&r, a.at, variable);
    fraction_get(x, a.at);
    fmpz_mpoly_derivative(fmpz_mpoly_q_numref(p), fmpz_mpoly_q_numref(x), variable, ctx);
    fmpz_mpoly_derivative(fmpz_mpoly_q_numref(q), fmpz_mpoly_q_denref(x), variable, ctx);
    fmpz_mpoly_q_mul(q, q, x, ctx); /* q' p/q */
    fmpz_mpoly_q_sub(p, p, q, ctx);
    fmpz_mpoly_set(fmpz_mpoly_q_numref(q), fmpz_mpoly_q_denref(x), ctx);
    fmpz_mpoly_one(fmpz_mpoly_q_denref(q), ctx);
    fmpz_mpoly_q_div(x, p, q, ctx);
    is_that_of_flint(&r, x);
    fmpz_mpoly_q_clear(x, ctx), fmpz_mpoly_q_clear(p, ctx), fmpz_mpoly_q_clear(q, ctx), field_slot_clear(&r);
}

/* The numerator of a over the denominator of b. */
static void over_denominator_agrees(num_f a, num_f b)
{
    const fmpz_mpoly_ctx_struct *ctx = field_context();
    struct field_element r;
    fmpz_mpoly_q_t x;
    field_slot_init(&r), fmpz_mpoly_q_init(x, ctx);
    fraction_over_denominator_of(&r, a.at->numerator, b.at);
    fmpz_mpoly_set(fmpz_mpoly_q_numref(x), a.at->numerator, ctx);
    fraction_denominator(fmpz_mpoly_q_denref(x), b.at);
    fmpz_mpoly_q_canonicalise(x, ctx);
    is_that_of_flint(&r, x);
    fmpz_mpoly_q_clear(x, ctx), field_slot_clear(&r);
}

static void fractions_are_those_of_flint(void **state)
{
    (void)state;
    field_open(VARIABLES);
    for (int round = 0; round < ROUNDS; round++) {
        region_mark mark = region_open();
        num_f a = random_fraction(), b = random_fraction(), c = random_fraction();
        if (pick(0, 2) == 0) /* common factors, and sums in which something cancels */
            b = sub_f(c, a);
        agrees(fraction_add, fmpz_mpoly_q_add, a, b);
        agrees(fraction_sub, fmpz_mpoly_q_sub, a, b);
        agrees(fraction_sub, fmpz_mpoly_q_sub, a, a);
        agrees(fraction_mul, fmpz_mpoly_q_mul, a, b);
        if (!is_zero_f(b))
            agrees(fraction_div, fmpz_mpoly_q_div, a, b);
        derivative_agrees(a, round % VARIABLES);
        over_denominator_agrees(a, b);
        assert_true(equal_f(add_f(add_f(a, b), c), add_f(a, add_f(b, c))));
        region_drop(mark);
    }
    assert_true(listed > ROUNDS && not_factored > ROUNDS / 20);
    region_free_all();
    field_close();
    flint_cleanup();
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(fractions_are_those_of_flint)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
