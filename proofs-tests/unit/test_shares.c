/* test_shares.c -- code that is run exactly with rounding: the error of a number is the sum of what arose at each line. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/code/orders.h"
#include "exact/code/value.h"
#include "exact/words.h"

#include <math.h>
#include <string.h>

static const struct cagd_code_place place[] = {{"a.c", "f", 1}, {"a.c", "f", 2}, {"a.c", "f", 3}, {"b.c", "f", 3}};
enum { LEFT, RIGHT, HERE, OTHER };

/* What a binary64 lacks of the exact number. */
static double error_of(num_q exact, double d) { return to_double_q(sub_q(from_double_q(d), exact)); }

/* The exact number and its binary64; the difference arose at that place. */
static cagd_code_value rounded(num_q exact, int at)
{
    cagd_code_value v = {.q = exact, .d = to_double_q(exact)};
    struct cagd_code_share *share = cagd_region_array(1, 1, sizeof *share);
    *share = (struct cagd_code_share){&place[at], error_of(exact, v.d)};
    v.share = share;
    v.shares = share->amount != 0;
    return v;
}

static double share_of(cagd_code_value v, int at)
{
    double amount = 0;
    for (int k = 0; k < v.shares; k++)
        if (v.share[k].place->line == place[at].line && strcmp(v.share[k].place->file, place[at].file) == 0)
            amount += v.share[k].amount;
    return amount;
}

/* Each share is computed by at most four roundings, one more adds it up; none of three places cancels another. */
static void is_told(cagd_code_value v, double exact_error)
{
    double sum = 0, size = 0;
    for (int at = LEFT; at <= HERE; at++) {
        sum += share_of(v, at);
        size += fabs(share_of(v, at));
    }
    if (!(fabs(sum - exact_error) <= 8 * 0x1p-53 * size))
        fail_msg("the shares make %g of %g", sum, exact_error);
}

static void shares_make_the_error(void **state)
{
    (void)state;
    static cagd_code_value (*const operation[])(cagd_code_value, cagd_code_value) = {
        cagd_code_sum, cagd_code_difference, cagd_code_product, cagd_code_quotient};
    static struct cagd_code_job job = {.numbers = CAGD_CODE_ROUNDING};
    static struct cagd_code_outcome outcome;
    cagd_code_machine = (struct cagd_code_machine){.job = &job, .outcome = &outcome};
    cagd_code_at = &place[HERE];
    int here = 0;
    for (int k = 0; k < 400; k++) {
        region_mark mark = region_open();
        num_q x = from_ratio_q(random_int(1, 1000) * (k % 3 ? 1 : -1), random_int(1, 1000)),
              y = from_ratio_q(random_int(1, 1000) * (k % 5 ? 1 : -1), random_int(1, 1000));
        cagd_code_value v = operation[k % 4](rounded(x, LEFT), rounded(y, RIGHT));
        is_told(v, error_of(v.q, v.d));
        assert_true(share_of(v, OTHER) == 0);
        here += share_of(v, HERE) != 0;
        cagd_code_value minus = cagd_code_negative(v);
        for (int at = LEFT; at <= HERE; at++)
            assert_true(share_of(minus, at) == -share_of(v, at));
        region_drop(mark);
    }
    assert_int_equal(outcome.operations, 400);
    assert_true(here > 200);
}

/* The shares of one line add up; the same line of another file is another place. */
static void lines_are_told_apart(void **state)
{
    (void)state;
    region_mark mark = region_open();
    cagd_code_value x = rounded(from_ratio_q(1, 3), HERE), y = rounded(from_ratio_q(1, 7), OTHER), v = {.d = 0};
    cagd_code_at = &place[HERE];
    cagd_code_shared(&v, x, 3, y, -2, 1);
    assert_int_equal(v.shares, 2);
    assert_true(share_of(v, HERE) == 3 * share_of(x, HERE) + 1);
    assert_true(share_of(v, OTHER) == -2 * share_of(y, OTHER));
    cagd_code_shared(&v, (cagd_code_value){.d = 1}, 1, (cagd_code_value){.d = 2}, 1, 0);
    assert_int_equal(v.made, 0);
    region_drop(mark);
}

/* a by b as a run does it; 'n' and 'r' have a alone. */
static cagd_code_value made(char by, cagd_code_value a, cagd_code_value b)
{
    cagd_code_value v = {.d = by == '+'   ? a.d + b.d
                              : by == '-' ? a.d - b.d
                              : by == '*' ? a.d * b.d
                              : by == '/' ? a.d / b.d
                              : by == 'n' ? -a.d
                                          : sqrt(a.d)};
    cagd_code_note_made(&v, by, a, b);
    return v;
}
static cagd_code_value alone(double d) { return (cagd_code_value){.d = d}; }

static void in_orders(cagd_code_value v, double as_run, double smallest_first, double largest_first, double in_halves)
{
    assert_true(v.d == as_run);
    assert_true(cagd_code_in_order(v, CAGD_CODE_SMALLEST_FIRST) == smallest_first);
    assert_true(cagd_code_in_order(v, CAGD_CODE_LARGEST_FIRST) == largest_first);
    assert_true(cagd_code_in_order(v, CAGD_CODE_IN_HALVES) == in_halves);
}

/* 1 and small numbers, of which each alone is lost beside 1, and of which it depends on the order how many are. */
static void sums_have_three_orders(void **state)
{
    (void)state;
    const double e = 0x1p-53;
    const cagd_code_value one = alone(1), small = alone(e), less = alone(e / 2);
    cagd_code_value two = made('+', one, small), four = made('+', made('+', two, small), small);
    in_orders(alone(0.1), 0.1, 0.1, 0.1, 0.1);
    in_orders(two, 1, 1, 1, 1);
    in_orders(four, 1, 1 + 4 * e, 1, 1 + 2 * e);
    in_orders(made('n', four, alone(0)), -1, -1 - 4 * e, -1, -1 - 2 * e);
    in_orders(made('*', four, alone(3)), 3, 3 * (1 + 4 * e), 3, 3 * (1 + 2 * e));
    in_orders(made('*', alone(3), four), 3, 3 * (1 + 4 * e), 3, 3 * (1 + 2 * e));
    in_orders(made('/', alone(2), four), 2, 2 / (1 + 4 * e), 2, 2 / (1 + 2 * e));
    in_orders(made('/', four, alone(2)), 0.5, (1 + 4 * e) / 2, 0.5, (1 + 2 * e) / 2);
    in_orders(made('r', made('*', four, alone(4)), alone(0)), 2, sqrt(4 * (1 + 4 * e)), 2, sqrt(4 * (1 + 2 * e)));
    /* wherever the largest stands, and whatever its sign */
    in_orders(made('+', made('+', small, one), small), 1, 1 + 2 * e, 1, 1);
    in_orders(made('+', made('+', small, small), one), 1 + 2 * e, 1 + 2 * e, 1, 1);
    in_orders(made('+', made('+', less, alone(-1)), less), -1, -1 + e, -1, -1);
    in_orders(made('+', made('+', less, less), alone(-1)), -1 + e, -1 + e, -1, -1);
    /* what is subtracted is one sum with the rest, its signs turned, and turned again */
    in_orders(made('-', made('-', one, less), less), 1, 1 - e, 1, 1 - e);
    in_orders(made('-', one, made('+', less, less)), 1 - e, 1 - e, 1, 1 - e);
    in_orders(made('-', one, made('-', less, made('n', less, alone(0)))), 1 - e, 1 - e, 1, 1 - e);
    in_orders(made('-', made('n', made('-', alone(7), one), alone(0)), alone(2)), -8, -8, -8, -8);
    /* a product is one term, with the value that it has in that order */
    in_orders(made('-', made('*', four, alone(1)), one), 0, 4 * e, 0, 2 * e);
    in_orders(made('-', one, made('*', four, alone(1))), 0, -4 * e, 0, -2 * e);
}

/* More terms than one sum has room for, and more operations than are noted at first: whole numbers have one sum. */
static void long_sums_are_whole(void **state)
{
    (void)state;
    const int many = 700;
    cagd_code_value left = alone(0), right = alone(0), sum = alone(0);
    for (int k = 1; k <= many; k++) {
        left = made('+', left, alone(k));
        right = made('-', alone(k), right);
        sum = made('+', made('*', alone(k), alone(2)), sum);
    }
    in_orders(left, many * (many + 1) / 2, many * (many + 1) / 2, many * (many + 1) / 2, many * (many + 1) / 2);
    in_orders(right, many / 2, many / 2, many / 2, many / 2);
    in_orders(sum, many * (many + 1), many * (many + 1), many * (many + 1), many * (many + 1));
}

/* What is made when there is no more room has its binary64 alone. */
static void operations_are_noted_as_far_as_there_is_room(void **state)
{
    (void)state;
    cagd_code_value v = alone(1);
    int noted = 0;
    do {
        v = made('*', v, alone(1));
        noted += v.made > 0;
    } while (v.made > 0 && noted <= 1 << 20);
    assert_in_range(noted, 1 << 19, 1 << 20);
    in_orders(made('+', alone(0.5), alone(0.25)), 0.75, 0.75, 0.75, 0.75);
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(sums_have_three_orders), unit(shares_make_the_error),
                                       unit(lines_are_told_apart), unit(long_sums_are_whole),
                                       unit(operations_are_noted_as_far_as_there_is_room)};
    return run_unit_tests(tests);
}
