/* test_example.c -- the numbers that are tried as an example where a formula fails. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/expression/example.c" /* for what is its own */

enum { MOST_NAMES = 9, KINDS = 6 };

/* Without bounds, below, above, between, and at one end or the other alone. */
static cagd_binding bounded(int kind, num_q low, num_q high)
{
    return (cagd_binding){.value = cagd_value_f(variable_f("x")),
                          .unknown = 1,
                          .has_low = kind == 1 || kind >= 3,
                          .has_high = kind >= 2,
                          .low_open = kind == 1 || kind == 3 || kind == 4,
                          .high_open = kind == 2 || kind == 3 || kind == 5,
                          .low = kind == 1 || kind >= 3 ? low : (num_q){NULL},
                          .high = kind >= 2 ? high : (num_q){NULL}};
}

static int meets(const cagd_binding *b, num_q x)
{
    int above = b->has_low ? cagd_compare_q(x, b->low) : 1, below = b->has_high ? cagd_compare_q(b->high, x) : 1;
    return (b->low_open ? above > 0 : above >= 0) && (b->high_open ? below > 0 : below >= 0);
}

/* Every number is within the bounds of its name.  Names with the same bounds: all of them are different in some rounds, without
 * bounds in every one, between two in nearly every one; no two rounds have the same numbers, and without bounds they have both signs. */
static void numbers_of_different_names(void **state)
{
    (void)state;
    static const int ends[][2] = {{0, 1}, {-3, -2}, {7, 9}, {-50, 60}, {100, 200}};
    cagd_field_open(4);
    for (size_t e = 0; e < sizeof ends / sizeof *ends; e++)
        for (int kind = 0; kind < KINDS; kind++)
            for (int names = 1; names <= MOST_NAMES; names++) {
                cagd_binding b = bounded(kind, from_int_q(ends[e][0]), from_int_q(ends[e][1]));
                int apart = 0, again = 0, negative = 0, positive = 0;
                num_q x[MOST_ROUNDS][MOST_NAMES];
                for (int round = 0; round < MOST_ROUNDS; round++) {
                    int same = 0;
                    for (int m = 0; m < names; m++) {
                        x[round][m] = different(&b, m, names, round);
                        assert_true(meets(&b, x[round][m]));
                        negative |= cagd_sign_q(x[round][m])<0, positive |= cagd_sign_q(x[round][m])> 0;
                        for (int k = 0; k < m; k++)
                            same |= cagd_equal_q(x[round][m], x[round][k]);
                    }
                    apart += !same;
                    for (int k = 0; k < round; k++) {
                        int equal = 1;
                        for (int m = 0; m < names; m++)
                            equal &= cagd_equal_q(x[round][m], x[k][m]);
                        again += equal;
                    }
                }
                assert_true(apart >= (kind == 0 ? MOST_ROUNDS : kind >= 3 ? MOST_ROUNDS - 2 : MOST_ROUNDS / 4));
                assert_true(kind > 0 || (negative && positive));
                assert_true(again == 0 || names <= 2); /* one or two have no more choices */
            }
    cagd_field_close();
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(numbers_of_different_names)};
    return run_unit_tests(tests);
}
