/* test_border.c -- where a comparison of code that is run exactly turns: the expressions of conditions, and their borders. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/code/border.h"
#include "exact/words.h"

#include <stdio.h>

static const char *const at_t[] = {"2/3"}, *const at_k[] = {"1", "-1/2", "5"};
static const int alike[] = {0, 1, 2};
static const struct cagd_code_point point = {.inputs = 2,
                                             .input = {{"t", 0, at_t, alike, 1}, {"k", 3, at_k, alike, 1}}};

static void expressions_have_their_values(void **state)
{
    (void)state;
    static const struct {
        const char *expression;
        long m, n; /* n = 0: none */
    } list[] = {{"2", 2, 1},
                {"t", 2, 3},
                {"k[0]", 1, 1},
                {"k[2]", 5, 1},
                {"-t", -2, 3},
                {"+t", 2, 3},
                {"2*t*k[1] - (t + k[2])/4", -25, 12},
                {"t^3", 8, 27},
                {"-t^2 + 1", 5, 9},
                {"(1 - t)*(1 - t)^2", 1, 27},
                {"6/3/2*5", 5, 1},
                {" ( t ) ", 2, 3},
                {"1 - 2 - 3", -4, 1},
                {"t/(k[0] - 1)", 0, 0},
                {"s", 0, 0},
                {"k[3]", 0, 0},
                {"tt", 0, 0},
                {"(t", 0, 0},
                {"t)", 0, 0},
                {"t^", 0, 0},
                {"t^0", 0, 0},
                {"t^1001", 0, 0},
                {"t +", 0, 0},
                {"*t", 0, 0},
                {"", 0, 0}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        num_q value = cagd_code_evaluate(list[k].expression, &point, NULL, from_int_q(0));
        if ((value.at != NULL) != (list[k].n != 0) ||
            (list[k].n != 0 && !cagd_equal_q(value, from_ratio_q(list[k].m, list[k].n))))
            fail_msg("%s is not %ld/%ld", list[k].expression, list[k].m, list[k].n);
    }
    /* a name with another value: t, and one element of k */
    assert_true(cagd_equal_q(cagd_code_evaluate("t + k[1]", &point, "t", from_int_q(7)), from_ratio_q(13, 2)));
    assert_true(cagd_equal_q(cagd_code_evaluate("k[0] + k[1]", &point, "k[1]", from_int_q(7)), from_int_q(8)));
}

/* The difference is 0 there, the others being as they are; none where it is constant or not linear, or divides by 0. */
static void borders_are_zeros(void **state)
{
    (void)state;
    static const struct {
        const char *difference;
        int input, element;
        long m, n;
    } list[] = {{"t - 1", 0, 0, 1, 1},      {"2*t - k[2]", 0, 0, 5, 2},    {"2*t - k[2]", 1, 2, 4, 3},
                {"2*t - k[2]", 1, 1, 0, 0}, {"t*k[0] + k[1]", 1, 0, 3, 4}, {"t^2 - 1", 0, 0, 0, 0},
                {"1/t", 0, 0, 0, 0},        {"t/k[2] - k[0]", 0, 0, 5, 1}, {"u", 0, 0, 0, 0}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        num_q x = cagd_code_border(list[k].difference, &point, list[k].input, list[k].element);
        assert_int_equal(x.at != NULL, list[k].n != 0);
        if (x.at != NULL)
            assert_true(cagd_equal_q(x, from_ratio_q(list[k].m, list[k].n)));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(expressions_have_their_values), unit(borders_are_zeros)};
    return run_unit_tests(tests);
}
