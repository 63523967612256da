/* test_shares.c -- code that is run exactly with rounding: the error of a number is the sum of what arose at each line. */
#include "proofs-tests/unit/unit_exact.h"

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

int main(void)
{
    const struct CMUnitTest tests[] = {unit(shares_make_the_error), unit(lines_are_told_apart)};
    return run_unit_tests(tests);
}
