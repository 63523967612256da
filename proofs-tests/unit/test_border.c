/* test_border.c -- where a comparison of code that is run exactly turns: the expressions of conditions, and their borders. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/code/border.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

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
                {"(s)", 0, 0},
                {"2*(t^)", 0, 0},
                {"2 ", 2, 1},
                {"1^1000", 1, 1},
                {"1^1001", 0, 0},
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
    /* of the variable a function has degrees up to 64 */
    static const struct {
        const char *function;
        int is_known;
    } high[] = {{"t^64 - 1", 1},
                {"t^65 - 1", 0},
                {"1/t^64 - 1", 1},
                {"1/t^65 - 1", 0},
                {"t^40*t^24 - 1", 1},
                {"t^40*t^25", 0},
                {"1/t^40 + 1/(t^25 - 2)", 0},
                {"1/t^40 + 1/(t^24 - 2)", 1}};
    for (size_t k = 0; k < sizeof high / sizeof *high; k++)
        if (cagd_code_border(high[k].function, &point, 0, 0).varies != high[k].is_known)
            fail_msg("%s", high[k].function);
    /* a name with another value: t, and one element of k */
    assert_true(cagd_equal_q(cagd_code_evaluate("t + k[1]", &point, "t", from_int_q(7)), from_ratio_q(13, 2)));
    assert_true(cagd_equal_q(cagd_code_evaluate("k[0] + k[1]", &point, "k[1]", from_int_q(7)), from_int_q(8)));
}

/* The zeros and poles of the difference, the others being as they are; the first rational one. */
static void borders_are_zeros(void **state)
{
    (void)state;
    static const struct {
        const char *difference;
        int input, element, zeros;
        long m, n; /* n = 0: none is rational */
    } list[] = {{"t - 1", 0, 0, 1, 1, 1},
                {"2*t - k[2]", 0, 0, 1, 5, 2},
                {"2*t - k[2]", 1, 2, 1, 4, 3},
                {"2*t - k[2]", 1, 1, 0, 0, 0},
                {"t*k[0] + k[1]", 1, 0, 1, 3, 4},
                {"t^2 - 1", 0, 0, 2, -1, 1},
                {"t^2 - 2", 0, 0, 2, 0, 0},
                {"t^2 + 1", 0, 0, 0, 0, 0},
                {"(t - 1/3)^2 - 1/10000000000000000000000000000000000000000", 0, 0, 2, 0, 0},
                {"(3*t - 1)^2", 0, 0, 1, 1, 3},
                {"(7*t - 3)*(t^2 - 2)*(t - 1)", 0, 0, 4, 3, 7},
                {"1/t", 0, 0, 1, 0, 1},
                {"t/k[2] - k[0]", 0, 0, 1, 5, 1},
                {"u", 0, 0, 0, 0, 0}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        struct cagd_code_border b = cagd_code_border(list[k].difference, &point, list[k].input, list[k].element);
        int found = 0;
        assert_int_equal(b.zeros, list[k].zeros);
        for (int j = 0; j < b.values; j++)
            found |= list[k].n != 0 && cagd_equal_q(b.at[j], from_ratio_q(list[k].m, list[k].n));
        if (found != (list[k].n != 0))
            fail_msg("%s: %ld/%ld is not found", list[k].difference, list[k].m, list[k].n);
    }
}

/* Products of a t - b, which have rational zeros, and of t^2 - c, which have two that are none, over others of both kinds: how many there
 * are is known, which of them are rational, and that the values are zeros, poles, or none. */
static void zeros_of_drawn_products(void **state)
{
    (void)state;
    static const int not_square[] = {2, 3, 5, 6, 7, 10, -1, -2};
    for (int n = 0; n < 60; n++) {
        char text[300] = "1";
        num_q rational[6];
        int linear = 0, pairs = 0, used = 0, poles = random_int(0, 1);
        for (int k = 0; k < 5; k++) {
            size_t at = strlen(text);
            const char *by = poles && k == 4 ? "/" : "*";
            if (random_int(0, 2) > 0) {
                int a = random_int(1, 9), b = random_int(-9, 9), known = 0;
                num_q x = from_ratio_q(b, a);
                for (int j = 0; j < linear; j++)
                    known |= cagd_equal_q(rational[j], x);
                if (known)
                    continue;
                rational[linear++] = x;
                snprintf(text + at, sizeof text - at, "%s(%d*t - (%d))", by, a, b);
            } else {
                int which = random_int(0, 7);
                if (used >> which & 1)
                    continue;
                used |= 1 << which, pairs += not_square[which] > 0;
                snprintf(text + at, sizeof text - at, "%s(t^2 - (%d))", by, not_square[which]);
            }
        }
        struct cagd_code_border b = cagd_code_border(text, &point, 0, 0);
        if (b.zeros != linear + 2 * pairs || b.rational != linear)
            fail_msg("%s has %d zeros, %d rational", text, b.zeros, b.rational);
        int exact = 0;
        for (int j = 0; j < b.values; j++)
            for (int m = 0; m < linear; m++)
                exact += cagd_equal_q(b.at[j], rational[m]);
        assert_int_equal(exact, linear);
    }
}

/* Among the values are some of every sign that the difference has, however near its zeros lie. */
static void values_show_all_signs(void **state)
{
    (void)state;
    static const struct {
        const char *difference;
        const char *signs;
    } list[] = {{"(3*t - 1)^2", "0+"}, {"(t - 1/3)^2 - 1/10000000000000000000000000000000000000000", "-0+"},
                {"t^2 - 2", "-+"},     {"2 - t^2", "-+"},
                {"t^3 - 2*t", "-0+"},  {"-(t^2 - 2)^2", "-"}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        struct cagd_code_border b = cagd_code_border(list[k].difference, &point, 0, 0);
        char seen[4] = "";
        size_t many = 0;
        for (const char *sign = "-0+"; *sign != 0; sign++)
            for (int j = 0; j < b.values; j++) {
                num_q value = cagd_code_evaluate(list[k].difference, &point, "t", b.at[j]);
                if (cagd_sign_q(value) == (*sign == '-' ? -1 : *sign == '+') && strchr(seen, *sign) == NULL)
                    seen[many++] = *sign;
            }
        assert_string_equal(seen, list[k].signs);
    }
    /* of two zeros each, one below the first, one between and one above the last, 1 away or half of the way */
    static const long at[][2] = {{-2, 3}, {1, 3}, {7, 6}, {2, 1}, {3, 1}};
    struct cagd_code_border b = cagd_code_border("(3*t - 1)*(t - 2)", &point, 0, 0);
    for (size_t k = 0; k < sizeof at / sizeof *at; k++) {
        int there = 0;
        for (int j = 0; j < b.values; j++)
            there |= cagd_equal_q(b.at[j], from_ratio_q(at[k][0], at[k][1]));
        assert_true(there);
    }
    assert_int_equal(b.values, 9); /* both zeros and 2^-40 to either side of them, beside these three */
    assert_int_equal(b.rational, 2);
    num_q near = from_ratio_q(1, 1L << 40);
    assert_true(cagd_equal_q(b.at[1], sub_q(b.at[0], near)) && cagd_equal_q(b.at[2], add_q(b.at[0], near)));
    /* the derivative of (t^2 - 2t + 2)/t^2 vanishes at 2 alone, though that of its numerator and denominator does at 0, too */
    b = cagd_code_border("(t^2 - 2*t + 2)/t^2", &point, 0, 0);
    assert_true(cagd_equal_q(b.least, from_int_q(2)));
    b = cagd_code_border("(t - 1/3)^2 + 5", &point, 0, 0);
    assert_true(b.varies && b.zeros == 0 && cagd_equal_q(b.least, from_ratio_q(1, 3)));
}

/* Of more zeros than there is room for it has the first ones; of two that are 2^-39 apart it has the middle once. */
static void many_zeros_and_near_ones(void **state)
{
    (void)state;
    for (int zeros = CAGD_CODE_MOST_ZEROS - 1; zeros <= CAGD_CODE_MOST_ZEROS + 5; zeros++) {
        char text[600] = "1";
        for (int k = zeros; k > 0; k--)
            snprintf(text + strlen(text), sizeof text - strlen(text), "*(t - %d/7)", k * k);
        struct cagd_code_border b = cagd_code_border(text, &point, 0, 0);
        int known = zeros < CAGD_CODE_MOST_ZEROS ? zeros : CAGD_CODE_MOST_ZEROS;
        assert_int_equal(b.zeros, known);
        assert_int_equal(b.rational, known);
        assert_int_equal(b.values, 4 * known + 1);
        for (int k = 0; k < known; k++) {
            int there = 0;
            for (int j = 0; j < b.values; j++)
                there += cagd_equal_q(b.at[j], from_ratio_q((k + 1) * (k + 1), 7));
            assert_int_equal(there, 1);
        }
    }
    static const struct {
        long more;
        int values;
    } list[] = {{-1, 7}, {0, 7}, {1, 9}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        char text[100];
        snprintf(text, sizeof text, "(t - 1)*(t - 1 - %ld/%ld)", (1L << 21) + list[k].more, 1L << 60);
        struct cagd_code_border b = cagd_code_border(text, &point, 0, 0);
        assert_int_equal(b.zeros, 2);
        assert_int_equal(b.rational, 2);
        assert_int_equal(b.values, list[k].values);
        for (int j = 0; j < b.values; j++)
            for (int m = 0; m < j; m++)
                assert_false(cagd_equal_q(b.at[j], b.at[m]));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(expressions_have_their_values), unit(borders_are_zeros),
                                       unit(zeros_of_drawn_products), unit(values_show_all_signs),
                                       unit(many_zeros_and_near_ones)};
    return run_unit_tests(tests);
}
