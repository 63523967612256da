/* test_comparison.c -- the rules of the judge one by one: what a comparison decides, what is noted of it, which data a body is
 * given, and what an outcome in one number type is worth. */
#include "proofs-tests/unit/unit_exact.h"

#include "chapters/judge/case.h"
#include "chapters/judge/run.h"
#include "chapters/judge/words.h"
#include "exact/number/field.h"
#include "exact/record/trace.h"
#include "exact/words.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const claim without_data = {.name = "without data", .scope = ""};
static trial tried(void) { return (trial){.claim = &without_data}; }
static const char *shown(const trial *T, const char *name)
{
    for (int k = 0; k < T->exhibits; k++)
        if (strcmp(T->shown[k].name, name) == 0)
            return T->shown[k].value;
    return NULL;
}
static void done(trial *T)
{
    forget_exhibits(T->shown, T->exhibits);
    *T = tried();
}
static num_i between(int low, int high) { return cagd_hull_i(from_int_i(low), from_int_i(high)); }

/* ---- comparisons --------------------------------------------------------------------------------------- */

/* Two numbers with the bounds u and 3/2 u: a distance of 2u is 4/5 of what is allowed, one of 4u is too much. */
static void binary64_differs_by_its_bounds(void **state)
{
    (void)state;
    const num_m a = {1, 1, 0}, near = {1 + 2 * unit_roundoff, 1.5, 0}, far = {1 + 4 * unit_roundoff, 1.5, 0};
    for (int turned = 0; turned < 2; turned++) {
        trial T = tried();
        same_m(&T, turned ? near : a, turned ? a : near);
        assert_int_equal(T.outcome, HOLDS);
        assert_true(T.worst > 0.79 && T.worst <= 0.8);
        same_m(&T, a, a);
        assert_true(T.worst > 0.79); /* the worst stays */
        assert_int_equal(T.exhibits, 0);
        same_m(&T, turned ? far : a, turned ? a : far);
        assert_int_equal(T.outcome, FAILS);
        assert_true(T.worst > 1.5 && T.worst < 1.7);
        assert_int_equal(T.compared, 3);
        assert_int_equal(T.exhibits, 2); /* nothing was said about it */
        char text[40];
        snprintf(text, sizeof text, "%.17g", far.v);
        assert_string_equal(shown(&T, turned ? "left" : "right"), text);
        assert_string_equal(shown(&T, turned ? "right" : "left"), "1");
        done(&T);
    }
    trial T = tried();
    same_m(&T, a, (num_m){1 + 2 * unit_roundoff, 1, 0}); /* all but as much as is allowed */
    assert_int_equal(T.outcome, HOLDS);
    done(&T);
    same_m(&T, exact_m(NAN), exact_m(1));
    assert_int_equal(T.outcome, FAILS);
    same_m(&T, a, exact_m(1)); /* which no smaller error makes forgotten */
    assert_true(isnan(T.worst));
    done(&T);
}

static void intervals_refute_and_confirm_no_equality(void **state)
{
    (void)state;
    trial T = tried();
    same_i(&T, between(0, 4), from_int_i(2));
    assert_int_equal(T.outcome, UNDECIDED);
    same_i(&T, between(1, 2), from_int_i(2));
    assert_int_equal(T.outcome, UNDECIDED);
    assert_true(T.worst == 4); /* of the widest */
    same_i(&T, between(0, 4), from_int_i(5));
    assert_int_equal(T.outcome, FAILS);
    assert_int_equal(T.exhibits, 2);
    assert_string_equal(shown(&T, "left"), "[0, 4]");
    assert_string_equal(shown(&T, "right"), "[5, 5]");
    done(&T);
    vanishes_i(&T, between(1, 2));
    assert_int_equal(T.outcome, FAILS);
    done(&T);
}

/* What is just as far as its bounds allow is not refuted, the next binary64 is; what is no number is. */
static void a_bound_is_allowed_itself(void **state)
{
    (void)state;
    const num_m at = {0, 1, 0}, wide = {0, 0x1p60, 3};
    for (int k = 0; k < 2; k++) {
        const num_m zero = k == 0 ? at : wide;
        const double bound = error_bound_m(zero), beyond = nextafter(bound, INFINITY);
        for (int sign = -1; sign <= 1; sign += 2) {
            trial T = tried();
            same_m(&T, zero, exact_m(sign * bound));
            assert_int_equal(T.outcome, HOLDS);
            assert_true(T.worst == 1);
            same_m(&T, exact_m(sign * beyond), zero);
            assert_int_equal(T.outcome, FAILS);
            done(&T);
        }
        trial T = tried();
        nonnegative_m(&T, (num_m){-bound, zero.e, zero.k});
        assert_int_equal(T.outcome, HOLDS);
        nonnegative_m(&T, (num_m){-beyond, zero.e, zero.k});
        assert_int_equal(T.outcome, FAILS);
        done(&T);
    }
    static const struct {
        double value;
        outcome sign;
    } list[] = {{NAN, FAILS}, {-INFINITY, FAILS}, {INFINITY, HOLDS}, {-0.0, HOLDS}, {0.0, HOLDS}, {-0x1p-1074, FAILS}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        trial T = tried();
        nonnegative_m(&T, exact_m(list[k].value));
        assert_int_equal(T.outcome, list[k].sign);
        assert_int_equal(T.exhibits, list[k].sign == FAILS);
        done(&T);
        same_m(&T, exact_m(list[k].value), exact_m(0));
        assert_int_equal(T.outcome, list[k].value == 0 ? HOLDS : FAILS); /* -0 is 0 */
        done(&T);
    }
}

/* Whichever comes first, the widest is kept, and the largest part of a bound. */
static void the_worst_of_three_is_kept(void **state)
{
    (void)state;
    static const int orders[][3] = {{1, 2, 4}, {1, 4, 2}, {2, 1, 4}, {2, 4, 1}, {4, 1, 2}, {4, 2, 1}};
    for (size_t k = 0; k < sizeof orders / sizeof *orders; k++) {
        trial T = tried(), U = tried();
        for (int m = 0; m < 3; m++) {
            int width = orders[k][m];
            same_i(&T, between(0, width), from_int_i(0));
            same_m(&U, (num_m){1 + 2 * unit_roundoff, 16.0 / width, 0}, exact_m(1)); /* 2 u of 16 u / width */
        }
        assert_true(T.worst == 4);
        assert_true(U.worst > 0.49 && U.worst <= 0.5);
        assert_int_equal(T.outcome, UNDECIDED);
        assert_int_equal(U.outcome, HOLDS);
        done(&T);
        done(&U);
    }
}

static void signs_in_every_type(void **state)
{
    (void)state;
    static const struct {
        int low, high;
        outcome outcome;
    } intervals[] = {{-1, 1, UNDECIDED}, {-2, -1, FAILS}, {-1, 0, UNDECIDED}, {0, 1, HOLDS}, {1, 2, HOLDS}};
    for (size_t k = 0; k < sizeof intervals / sizeof *intervals; k++) {
        trial T = tried();
        nonnegative_i(&T, between(intervals[k].low, intervals[k].high));
        assert_int_equal(T.outcome, intervals[k].outcome);
        assert_int_equal(T.exhibits, intervals[k].outcome == FAILS);
        if (intervals[k].outcome == FAILS)
            assert_string_equal(shown(&T, "negative"), "[-2, -1]");
        assert_int_equal(T.compared, 1);
        done(&T);
    }
    for (int sign = -1; sign <= 1; sign++) {
        trial T = tried();
        nonnegative_q(&T, from_int_q(sign));
        assert_int_equal(T.outcome, sign < 0 ? FAILS : HOLDS);
        if (sign < 0)
            assert_string_equal(shown(&T, "negative"), "-1");
        assert_int_equal(T.exhibits, sign < 0);
        done(&T);
        /* Below 0 by its bound is not refuted, by more it is. */
        nonnegative_m(&T, (num_m){-(1 + sign) * unit_roundoff, 1.5, 0});
        assert_int_equal(T.outcome, sign > 0 ? FAILS : HOLDS);
        assert_int_equal(T.exhibits, sign > 0);
        if (sign > 0)
            assert_string_equal(shown(&T, "negative"), "-2.2204460492503131e-16");
        done(&T);
    }
    field_open(4);
    trial T = tried();
    num_f x = variable_f("x");
    nonnegative_f(&T, from_int_f(0));
    nonnegative_f(&T, x);
    assert_int_equal(T.outcome, HOLDS);
    assert_int_equal(T.exhibits, 0);
    nonnegative_f(&T, neg_f(x));
    assert_int_equal(T.outcome, FAILS);
    assert_string_equal(shown(&T, "negative"), "-x");
    T.positive = NULL;
    done(&T);
    nonnegative_f(&T, sub_f(x, variable_f("y")));
    assert_int_equal(T.outcome, HOLDS);
    expect_fault(FAULT_UNABLE);
    done(&T);
    field_close();
}

/* Coefficients say something for positive values of the variables that occur, in numerator or denominator. */
static void variables_whose_sign_was_used(void **state)
{
    (void)state;
    field_open(6);
    trial T = tried();
    num_f x11 = variable_f("x11"), ax1 = variable_f("ax1"), x1 = variable_f("x1"), y = variable_f("y"),
          z = variable_f("z");
    nonnegative_f(&T, x11);
    assert_string_equal(T.positive, "x11");
    nonnegative_f(&T, ax1);
    assert_string_equal(T.positive, "x11 ax1");
    nonnegative_f(&T, x1); /* part of the names of both */
    assert_string_equal(T.positive, "x11 ax1 x1");
    nonnegative_f(&T, add_f(x1, x11));
    assert_string_equal(T.positive, "x11 ax1 x1");
    nonnegative_f(&T, div_f(from_int_f(1), y));
    assert_string_equal(T.positive, "x11 ax1 x1 y");
    same_f(&T, z, z);
    assert_string_equal(T.positive, "x11 ax1 x1 y");
    assert_int_equal(T.outcome, HOLDS);
    assert_int_equal(T.compared, 6);
    done(&T);
    field_close();
}

/* Names of one letter, too, stand in the list one behind the other; each once. */
static void signs_of_single_letters(void **state)
{
    (void)state;
    trial T = tried();
    field_open(4);
    static const char *const names[] = {"w", "v", "w", "long"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        nonnegative_f(&T, variable_f(names[k]));
    assert_string_equal(T.positive, "w v long");
    same_f(&T, variable_f("v"), from_int_f(2));
    assert_string_equal(shown(&T, "left"), "v");
    assert_string_equal(shown(&T, "right"), "2");
    done(&T);
    field_close();
}

static void zero_in_every_type(void **state)
{
    (void)state;
    field_open(1);
    for (int value = 0; value < 2; value++) {
        trial T = tried();
        vanishes_q(&T, from_int_q(value));
        assert_int_equal(T.outcome, value == 0 ? HOLDS : FAILS);
        assert_int_equal(T.compared, 1);
        done(&T);
        vanishes_f(&T, from_int_f(value));
        assert_int_equal(T.outcome, value == 0 ? HOLDS : FAILS);
        assert_int_equal(T.compared, 1);
        done(&T);
        vanishes_m(&T, from_int_m(value));
        assert_int_equal(T.outcome, value == 0 ? HOLDS : FAILS);
        assert_int_equal(T.compared, 1);
        if (value != 0)
            assert_string_equal(shown(&T, "left"), "1");
        done(&T);
        vanishes_i(&T, from_int_i(value));
        assert_int_equal(T.outcome, value == 0 ? UNDECIDED : FAILS);
        assert_int_equal(T.compared, 1);
        done(&T);
    }
    field_close();
}

/* What ought to vanish stands on the left, 0 on the right. */
static void what_should_vanish_is_on_the_left(void **state)
{
    (void)state;
    static const char *const sides[NUMBER_TYPES][2] = {{"5", "0"}, {"5", "0"}, {"[5, 5]", "[0, 0]"}, {"5", "0"}};
    field_open(1);
    for (number_type t = 0; t < NUMBER_TYPES; t++) {
        trial T = tried();
        switch (t) {
        case FIELD_TYPE:
            vanishes_f(&T, from_int_f(5));
            break;
        case RATIONAL_TYPE:
            vanishes_q(&T, from_int_q(5));
            break;
        case INTERVAL_TYPE:
            vanishes_i(&T, from_int_i(5));
            break;
        default:
            vanishes_m(&T, exact_m(5));
        }
        assert_int_equal(T.outcome, FAILS);
        assert_string_equal(shown(&T, "left"), sides[t][0]);
        assert_string_equal(shown(&T, "right"), sides[t][1]);
        done(&T);
    }
    field_close();
}

/* A condition is told with its formula, but not that of a counterexample, which is one of the body and not of what is printed;
 * the first that does not hold, with what it is about. */
static void conditions_are_told(void **state)
{
    (void)state;
    for (int kind = 0; kind < KINDS; kind++) {
        const claim c = {.name = "conditions", .scope = "", .kind = (claim_kind)kind};
        trial T = {.claim = &c};
        agree_as(&T, 1, "1 < 2");
        assert_int_equal(T.exhibits, 0);
        about(&T, "two numbers");
        agree_as(&T, 0, "2 < 1");
        agree_as(&T, 0, "3 < 1");
        assert_int_equal(T.outcome, FAILS);
        assert_int_equal(T.compared, 3);
        assert_int_equal(T.exhibits, kind == COUNTEREXAMPLE ? 1 : 2);
        assert_string_equal(shown(&T, "compared"), "two numbers");
        if (kind != COUNTEREXAMPLE)
            assert_string_equal(shown(&T, "condition"), "2 < 1");
        forget_exhibits(T.shown, T.exhibits);
    }
}

/* Told is what the comparison is about that fails, not another one. */
static void what_a_comparison_is_about(void **state)
{
    (void)state;
    static const char *const what[] = {"one", "two", "three"};
    for (int failing = 0; failing < 3; failing++) {
        trial T = tried();
        for (int k = 0; k < 3; k++) {
            about(&T, what[k]);
            same_q(&T, from_int_q(k), from_int_q(k == failing ? 7 : k));
        }
        assert_string_equal(shown(&T, "compared"), what[failing]);
        assert_int_equal(T.exhibits, 3);
        done(&T);
    }
}

/* After a division by zero, too, a difference is one; after what could not be computed there is none. */
static void what_is_compared_after_a_fault(void **state)
{
    (void)state;
    static const struct {
        unsigned fault;
        outcome outcome;
    } list[] = {{0, FAILS}, {FAULT_UNDEFINED, FAILS}, {FAULT_UNABLE, HOLDS}, {FAULT_CROWDED, HOLDS}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        trial T = tried();
        region_faults = list[k].fault;
        same_q(&T, from_int_q(1), from_int_q(2));
        assert_int_equal(T.outcome, list[k].outcome);
        assert_int_equal(T.exhibits, list[k].outcome == FAILS ? 2 : 0);
        assert_int_equal(T.compared, 1);
        region_faults = 0;
        done(&T);
    }
}

/* What is shown of a binary64, or of the ends of an interval, is read again as the same number. */
static void shown_numbers_are_the_numbers(void **state)
{
    (void)state;
    static const double list[] = {1.0 / 3, -2e-300 / 3, 1e300 / 7, 0x1.fffffffffffffp-1, 0.1};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        trial T = tried();
        num_i a =
            cagd_hull_i(from_rational_i(from_double_q(list[k])), from_rational_i(from_double_q(2 * fabs(list[k]))));
        show_m(&T, "number", exact_m(list[k]));
        show_i(&T, "interval", a);
        assert_true(strtod(shown(&T, "number"), NULL) == list[k]);
        char *end;
        assert_true(strtod(shown(&T, "interval") + 1, &end) == list[k]);
        assert_true(strtod(end + 1, NULL) == 2 * fabs(list[k]));
        done(&T);
    }
}

/* What is compared is noted where a trace is open, in the order of the comparisons. */
static void comparisons_are_noted(void **state)
{
    (void)state;
    field_open(2);
    cagd_trace_open(100);
    trial T = tried();
    num_q x = unknown_q(&T, "x", 0), t = parameter_q(&T, "t");
    assert_true(strstr(cagd_trace_inputs(), "\"x0\"") != NULL && strstr(cagd_trace_inputs(), "\"t\"") != NULL);
    agree(&T, 1);
    same_q(&T, x, x);
    same_q(&T, x, t);
    nonnegative_q(&T, t);
    nonnegative_q(&T, neg_q(t));
    refute(&T, 1);
    assert_string_equal(cagd_trace_steps(),
                        "[{\"agree\":true},{\"same\":[1,1],\"equal\":true},{\"same\":[1,3],\"equal\":false},"
                        "{\"nonnegative\":3,\"good\":true},{\"nonnegative\":4,\"good\":false},{\"agree\":false}]\n");
    cagd_trace_close();
    cagd_trace_open(100);
    num_f y = variable_f("y");
    same_f(&T, y, y);
    same_f(&T, y, neg_f(y));
    nonnegative_f(&T, y);
    nonnegative_f(&T, neg_f(y));
    assert_string_equal(cagd_trace_steps(), "[{\"same\":[0,0],\"equal\":true},{\"same\":[0,1],\"equal\":false},"
                                            "{\"nonnegative\":0,\"good\":true,\"text\":\"y\",\"sign\":1},"
                                            "{\"nonnegative\":2,\"good\":false,\"text\":\"-y\",\"sign\":-1}]\n");
    cagd_trace_close();
    done(&T);
    field_close();
}

/* ---- data ---------------------------------------------------------------------------------------------- */

/* The first outputs of splitmix64 from the states 0 and 1, by its publication. */
static void the_generator_is_splitmix64(void **state)
{
    (void)state;
    trial T = {.state = 0};
    assert_int_equal(pick(&T, 0, 999999), 0xe220a8397b1dcdafu % 1000000);
    assert_int_equal(pick(&T, 0, 999999), 0x6e789e6aa1b965f4u % 1000000);
    assert_int_equal(pick(&T, -5, 999994), (int)(0x06c45d188009454fu % 1000000) - 5);
}

/* Numbers in [-1, 1], weights in [1/8, 4], parameters in (-1, 2), what is inside in (0, 1), of twenty binary digits. */
static void where_data_lie(void **state)
{
    (void)state;
    enum { ONE = 1 << 20 };
    trial T = {.state = 7}, U = T;
    for (int k = 0; k < 10; k++) {
        assert_true(cagd_equal_q(unknown_q(&T, "x", 0), from_ratio_q(pick(&U, -ONE, ONE), ONE)));
        assert_true(cagd_equal_q(positive_q(&T, "w", 0), from_ratio_q(pick(&U, ONE / 8, 4 * ONE), ONE)));
        assert_true(cagd_equal_q(parameter_q(&T, "t"), from_ratio_q(pick(&U, 1 - ONE, 2 * ONE - 1), ONE)));
        assert_true(cagd_equal_q(whole_q(&T, "n", 3, 99), from_int_q(pick(&U, 3, 99))));
        assert_true(cagd_equal_q(inside_q(&T, "s"), from_ratio_q(pick(&U, 1, ONE - 1), ONE)));
    }
}

/* A formula of 401 letters is cut, one of 400 is not. */
static void a_long_formula_is_cut(void **state)
{
    (void)state;
    field_open(2);
    trial T = tried();
    for (int digits = 399; digits <= 401; digits++) {
        char number[402];
        memset(number, '1', (size_t)digits);
        number[digits] = '\0';
        num_f a = from_rational_f(from_string_q(number));
        show_f(&T, "number", a);
        if (digits <= 400) {
            assert_string_equal(shown(&T, "number"), number);
        } else {
            number[400] = '\0';
            assert_int_equal(strncmp(shown(&T, "number"), number, 400), 0);
            assert_string_equal(shown(&T, "number") + 400, " ...");
        }
        done(&T);
    }
    field_close();
}

static void what_lies_inside(void **state)
{
    (void)state;
    field_open(2);
    trial T = tried();
    num_f s = variable_f("s");
    assert_true(equal_f(mul_f(inside_f(&T, "s"), add_f(s, from_int_f(1))), s));
    field_close();
}

#define VALUES(...)                                                                                                    \
    (const char *const[]) { __VA_ARGS__ }
#define ONE_VALUE(entry, written) .name = entry, .text = written, .rows = 1, .columns = 1, .value = VALUES(written)
static const datum given[] = {
    {ONE_VALUE("three", "3")},
    {ONE_VALUE("half", "1/2")},
    {ONE_VALUE("part", "3.5")},
    {ONE_VALUE("large", "99999999999")},
    {ONE_VALUE("small", "-99999999999")},
    {ONE_VALUE("variable", "w1")},
    {ONE_VALUE("letter", "A")},
    {ONE_VALUE("below", "-0.1")},
    {ONE_VALUE("most", "2147483647")},
    {ONE_VALUE("least", "-2147483648")},
    {.name = "signs", .text = "\"%%\"", .rows = 1, .columns = 0, .value = VALUES("%%")},
    {ONE_VALUE("tenth", "0.1")},
    {.name = "text", .text = "\"y\"", .rows = 1, .columns = 0, .value = VALUES("y")},
    {.name = "points", .rows = 2, .columns = 3, .value = VALUES("1", "2", "3", "4", "5", "6")},
    {ONE_VALUE("three", "3"), .place = IN_RESULT},
    {ONE_VALUE("tenth", "0.1"), .place = IN_RESULT},
    {ONE_VALUE("variable", "w1"), .place = IN_RESULT},
    {.name = "text", .text = "\"y\"", .rows = 1, .columns = 0, .value = VALUES("y"), .place = IN_RESULT},
    {.name = "points", .rows = 2, .columns = 3, .value = VALUES("1", "2", "3", "4", "5", "6"), .place = IN_RESULT},
    {.name = NULL}};
static const claim with_data = {.name = "with data", .scope = "", .data = given};
static trial given_to(void) { return (trial){.claim = &with_data}; }
static void made_a_mistake(trial *T, const char *what)
{
    if (what == NULL) {
        assert_false(T->mistaken);
        assert_null(shown(T, "mistake"));
    } else {
        assert_true(T->mistaken);
        assert_non_null(shown(T, "mistake"));
        assert_string_equal(shown(T, "mistake"), what);
    }
    forget_exhibits(T->shown, T->exhibits);
    *T = given_to();
}

static void what_is_given(void **state)
{
    (void)state;
    trial T = given_to();
    num_q P[6];
    assert_int_equal(given_whole(&T, "three"), 3);
    assert_string_equal(shown(&T, "three"), "3");
    made_a_mistake(&T, NULL);
    given_whole(&T, "part");
    made_a_mistake(&T, "'part': the datum is no whole number");
    given_whole(&T, "large");
    made_a_mistake(&T, "'large': the datum is no whole number");
    given_whole(&T, "small");
    made_a_mistake(&T, "'small': the datum is no whole number");
    assert_int_equal(given_whole(&T, "nothing"), 0);
    made_a_mistake(&T, "'nothing': the block has no such datum");
    given_whole(&T, "points");
    made_a_mistake(&T, "'points': the datum has another shape");
    assert_int_equal(given_whole(&T, "most"), 2147483647);
    assert_int_equal(given_whole(&T, "least"), -2147483647 - 1);
    made_a_mistake(&T, NULL);
    assert_string_equal(given_text(&T, "signs"), "%%");
    assert_string_equal(shown(&T, "signs"), "%%");
    assert_string_equal(given_text(&T, "text"), "y");
    assert_string_equal(shown(&T, "text"), "y");
    made_a_mistake(&T, NULL);
    assert_string_equal(given_text(&T, "three"), "");
    made_a_mistake(&T, "'three': the datum has another shape");
    given_points_q(&T, "points", 2, 3, P);
    assert_true(cagd_equal_q(P[5], from_int_q(6)));
    assert_string_equal(shown(&T, "points"), "(1, 2, 3) (4, 5, 6)");
    made_a_mistake(&T, NULL);
    given_points_q(&T, "points", 1, 3, P);
    made_a_mistake(&T, "'points': the datum has another shape");
    given_points_q(&T, "points", 2, 2, P);
    made_a_mistake(&T, "'points': the datum has another shape");
    field_open(2);
    assert_true(equal_f(given_f(&T, "variable"), variable_f("w1")));
    assert_true(equal_f(given_f(&T, "half"), from_ratio_f(1, 2)));
    assert_true(equal_f(given_f(&T, "letter"), variable_f("A")));
    made_a_mistake(&T, NULL);
    field_close();
    /* The nearest binary64 of 1/10, an error of half a unit of its last place at most, once rounded. */
    num_m tenth = given_m(&T, "tenth"), half = given_m(&T, "half");
    assert_true(tenth.v == 0.1 && tenth.e == 0.1 && tenth.k == 1);
    num_m below = given_m(&T, "below");
    assert_true(half.v == 0.5 && half.e == 0);
    assert_true(below.v == -0.1 && below.e == 0.1);
    made_a_mistake(&T, NULL);
}

static void what_is_found(void **state)
{
    (void)state;
    trial T = given_to();
    num_q P[6];
    for (int k = 0; k < 6; k++)
        P[k] = from_int_q(k + 1);
    found_whole(&T, "three", 3);
    assert_string_equal(shown(&T, "three"), "3");
    made_a_mistake(&T, NULL);
    found_whole(&T, "three", 4);
    assert_string_equal(shown(&T, "three"), "4");
    made_a_mistake(&T, "'three': another result is stated");
    found_whole(&T, "points", 1);
    made_a_mistake(&T, "'points': the stated result has another shape");
    found_whole(&T, "nothing", 4);
    made_a_mistake(&T, "'nothing': the block states no such result");
    found_text(&T, "text", "y");
    made_a_mistake(&T, NULL);
    found_text(&T, "text", "z");
    made_a_mistake(&T, "'text': another result is stated");
    found_points_q(&T, "points", 2, 3, P);
    made_a_mistake(&T, NULL);
    found_points_q(&T, "points", 2, 2, P);
    made_a_mistake(&T, "'points': the stated result has another shape");
    found_points_q(&T, "points", 1, 3, P);
    made_a_mistake(&T, "'points': the stated result has another shape");
    for (int k = 0; k < 6; k += 5) { /* the first and the last count */
        P[k] = from_int_q(9);
        found_points_q(&T, "points", 2, 3, P);
        made_a_mistake(&T, "'points': another result is stated");
        P[k] = from_int_q(k + 1);
    }
    found_q(&T, "tenth", from_ratio_q(1, 10));
    made_a_mistake(&T, NULL);
    found_m(&T, "tenth", from_ratio_m(1, 10)); /* of binary64 the very number is stated, which 1/10 is not */
    made_a_mistake(&T, "'tenth': another result is stated");
    found_m(&T, "three", from_int_m(3));
    made_a_mistake(&T, NULL);
    found_i(&T, "tenth", from_ratio_i(1, 10));
    made_a_mistake(&T, NULL);
    found_i(&T, "tenth", from_ratio_i(1, 9));
    made_a_mistake(&T, "'tenth': another result is stated");
    field_open(2);
    found_f(&T, "variable", variable_f("w1"));
    made_a_mistake(&T, NULL);
    found_f(&T, "variable", variable_f("w2"));
    made_a_mistake(&T, "'variable': another result is stated");
    field_close();
}

/* Where another result is stated what came out is shown, in every type; and where the stated one is of another shape. */
static void what_came_out_is_shown(void **state)
{
    (void)state;
    trial T = given_to();
    static const char *const out[NUMBER_TYPES] = {"7", "7", "[7, 7]", "7"};
    field_open(2);
    for (number_type t = 0; t < NUMBER_TYPES; t++)
        for (int shape = 0; shape < 2; shape++) {
            const char *name = shape ? "points" : "three";
            switch (t) {
            case FIELD_TYPE:
                found_f(&T, name, from_int_f(7));
                break;
            case RATIONAL_TYPE:
                found_q(&T, name, from_int_q(7));
                break;
            case INTERVAL_TYPE:
                found_i(&T, name, from_int_i(7));
                break;
            default:
                found_m(&T, name, exact_m(7));
            }
            assert_string_equal(shown(&T, name), out[t]);
            made_a_mistake(&T, shape ? "'points': the stated result has another shape"
                                     : "'three': another result is stated");
        }
    field_close();
    num_q P[6];
    for (int k = 0; k < 6; k++)
        P[k] = from_ratio_q(k, 2);
    found_points_q(&T, "points", 2, 3, P);
    assert_string_equal(shown(&T, "points"), "(0, 1/2, 1) (3/2, 2, 5/2)");
    made_a_mistake(&T, "'points': another result is stated");
    found_text(&T, "text", "z");
    assert_string_equal(shown(&T, "text"), "z");
    made_a_mistake(&T, "'text': another result is stated");
    found_q(&T, "tenth", from_ratio_q(1, 10)); /* and where it is the stated one, that as it is written */
    assert_string_equal(shown(&T, "tenth"), "0.1");
    made_a_mistake(&T, NULL);
}

/* An entry is found by its whole name, whatever others begin so and wherever they stand. */
static void entries_are_found_by_their_whole_names(void **state)
{
    (void)state;
    const datum list[] = {{ONE_VALUE("xyz", "1")},
                          {ONE_VALUE("x", "2")},
                          {ONE_VALUE("xy", "3")},
                          {ONE_VALUE("xyz", "4"), .place = IN_RESULT},
                          {ONE_VALUE("xy", "5"), .place = IN_RESULT},
                          {ONE_VALUE("x", "6"), .place = IN_RESULT},
                          {.name = NULL}};
    static const char *const names[] = {"x", "xy", "xyz"};
    static const int data[] = {2, 3, 1}, found[] = {6, 5, 4};
    const claim c = {.name = "names", .scope = "", .data = list};
    trial T = {.claim = &c};
    for (int k = 0; k < 3; k++) {
        assert_int_equal(given_whole(&T, names[k]), data[k]);
        found_whole(&T, names[k], found[k]);
        assert_false(T.mistaken);
    }
    assert_int_equal(given_whole(&T, "xyzw"), 0);
    assert_true(T.mistaken);
    forget_exhibits(T.shown, T.exhibits);
}

/* The first entry and the last count as any other. */
static void what_nobody_asks_for(void **state)
{
    (void)state;
    const datum two[] = {given[0], given[1], {.name = NULL}};
    const claim c = {.name = "two", .scope = "", .data = two};
    for (int asked = 0; asked < 4; asked++) {
        trial T = {.claim = &c};
        if (asked & 1)
            given_q(&T, "three");
        if (asked & 2)
            given_q(&T, "half");
        look_for_unused(&T);
        assert_int_equal(T.mistaken, asked != 3);
        if (asked == 1 || asked == 2)
            assert_string_equal(shown(&T, "mistake"), asked == 1 ? "'half': nothing in the body asks for it"
                                                                 : "'three': nothing in the body asks for it");
        forget_exhibits(T.shown, T.exhibits);
    }
}

/* ---- what an outcome is worth -------------------------------------------------------------------------- */

static claim_result *judge_one(const claim *c) { return judge_claims(&c, 1, &(run_options){.jobs = 1}); }

/* The run can say nothing; the control fails by comparison, as it should. */
#define UNABLE_RUN(S)                                                                                                  \
    static void unable_##S(trial *T)                                                                                   \
    {                                                                                                                  \
        if (!T->planted)                                                                                               \
            region_faults |= FAULT_UNABLE;                                                                             \
        same_##S(T, from_int_##S(1), from_int_##S(T->planted ? 2 : 1));                                                \
    }
UNABLE_RUN(f)
UNABLE_RUN(q)
UNABLE_RUN(i)
UNABLE_RUN(m)

static void unable_confirms_nothing(void **state)
{
    (void)state;
    static void (*const bodies[])(trial *) = {unable_f, unable_q, unable_i, unable_m};
    for (int kind = 0; kind < KINDS; kind++)
        for (number_type t = 0; t < NUMBER_TYPES; t++) {
            claim c = {.name = "unable", .scope = "", .kind = (claim_kind)kind};
            c.body[t] = bodies[t];
            claim_result *r = judge_one(&c);
            assert_int_equal(r->by[t].outcome, UNDECIDED);
            assert_int_equal(r->by[t].control_caught, kind != COUNTEREXAMPLE);
            assert_false(r->as_expected);
            assert_int_equal(r->outcome, UNDECIDED);
            assert_int_equal(r->evidence, NO_EVIDENCE);
            assert_int_equal(r->computed, NO_EVIDENCE);
            assert_string_equal(r->scope, "");
            free_results(r, 1);
        }
}

static void any_degree_q(trial *T) { same_q(T, from_int_q(T->degree), from_int_q(T->degree + T->planted)); }

static void agrees_always(trial *T) { agree(T, 1); }

/* Intervals that meet refute nothing, so a counterexample in them alone is none; nor do they decide: they enclose. */
static void meet_i(trial *T) { same_i(T, from_int_i(1), T->planted ? from_int_i(2) : from_int_i(1)); }
static void meet_in_both_i(trial *T) { (void)T, same_i(T, from_int_i(1), from_int_i(1)); }
static void intervals_that_meet_are_no_decision(void **state)
{
    (void)state;
    static const struct {
        void (*body)(trial *);
        claim_kind kind;
        int as_expected;
        evidence evidence;
    } list[] = {{meet_i, IDENTITY, 1, ENCLOSED},
                {meet_i, DECISION, 1, ENCLOSED},
                {meet_in_both_i, COUNTEREXAMPLE, 0, NO_EVIDENCE}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        const claim c = {.name = "meet", .scope = "", .kind = list[k].kind, .body = {[INTERVAL_TYPE] = list[k].body}};
        claim_result *r = judge_one(&c);
        assert_int_equal(r->by[INTERVAL_TYPE].outcome, UNDECIDED);
        assert_true(r->by[INTERVAL_TYPE].control_caught);
        assert_int_equal(r->as_expected, list[k].as_expected);
        assert_int_equal(r->evidence, list[k].evidence);
        free_results(r, 1);
    }
}

/* One number type in which a claim fails is enough, whichever it is, and whatever could not be said in another one. */
#define CAN_FAIL(S)                                                                                                    \
    static void fails_##S(trial *T) { same_##S(T, from_int_##S(1), from_int_##S(2)); }                                 \
    static void is_one_##S(trial *T) { same_##S(T, from_int_##S(1), from_int_##S(T->planted ? 2 : 1)); }
CAN_FAIL(f)
CAN_FAIL(q)
CAN_FAIL(i)
CAN_FAIL(m)
static void one_type_that_fails_is_enough(void **state)
{
    (void)state;
    static void (*const fails[])(trial *) = {fails_f, fails_q, fails_i, fails_m};
    static void (*const holds[])(trial *) = {is_one_f, is_one_q, is_one_i, is_one_m};
    static void (*const unable[])(trial *) = {unable_f, unable_q, unable_i, unable_m};
    for (unsigned failing = 0; failing < 1u << NUMBER_TYPES; failing++)
        for (int open = 0; open < 2; open++) {
            claim c = {.name = "one type", .scope = ""};
            for (number_type t = 0; t < NUMBER_TYPES; t++)
                c.body[t] = failing >> t & 1 ? fails[t] : open ? unable[t] : holds[t];
            claim_result *r = judge_one(&c);
            int is_open = failing == 0 && open;
            assert_int_equal(r->outcome, failing != 0 ? FAILS : is_open ? UNDECIDED : HOLDS);
            assert_int_equal(r->as_expected, failing == 0 && !open);
            assert_int_equal(r->evidence, failing == 0 && !open ? PROVED : NO_EVIDENCE);
            free_results(r, 1);
        }
}

/* A control that is caught in every number type but one. */
static void every_type_has_its_control(void **state)
{
    (void)state;
    static void (*const uncaught[])(trial *) = {NULL, NULL, meet_in_both_i, NULL};
    static void (*const holds[])(trial *) = {is_one_f, is_one_q, is_one_i, is_one_m};
    for (number_type wrong = 0; wrong < NUMBER_TYPES; wrong++) {
        claim c = {.name = "controls", .scope = "", .body = {holds[0], holds[1], holds[2], holds[3]}};
        c.body[wrong] = uncaught[wrong] != NULL ? uncaught[wrong] : agrees_always;
        claim_result *r = judge_one(&c);
        for (number_type t = 0; t < NUMBER_TYPES; t++)
            assert_int_equal(r->by[t].control_caught, t != wrong);
        assert_false(r->as_expected);
        assert_int_equal(r->outcome, UNDECIDED);
        free_results(r, 1);
    }
}

/* A control is caught in whichever case it fails, the last one, too; that of a counterexample has to hold in all of them. */
static int wrong_at;
static void wrong_in_one_degree_q(trial *T)
{
    same_q(T, from_int_q(T->planted && T->degree == wrong_at), from_int_q(0));
}
static void refuted_but_in_one_degree_q(trial *T)
{
    same_q(T, from_int_q(!T->planted || T->degree == wrong_at), from_int_q(0));
}
static void controls_of_all_cases(void **state)
{
    (void)state;
    for (int refutes = 0; refutes < 2; refutes++)
        for (wrong_at = 1; wrong_at <= 4; wrong_at++) {
            const claim c = {.name = "controls",
                             .scope = "",
                             .kind = refutes ? COUNTEREXAMPLE : DECISION,
                             .degree_low = 1,
                             .degree_high = 3,
                             .degree_sampled = 3,
                             .body = {[RATIONAL_TYPE] = refutes ? refuted_but_in_one_degree_q : wrong_in_one_degree_q}};
            claim_result *r = judge_one(&c);
            assert_int_equal(r->by[RATIONAL_TYPE].outcome, refutes ? FAILS : HOLDS);
            assert_int_equal(r->by[RATIONAL_TYPE].control_caught, refutes == (wrong_at > 3));
            assert_int_equal(r->as_expected, refutes == (wrong_at > 3));
            free_results(r, 1);
        }
}

/* The data of case k are those of the seed FNV-1a of the name, plus k; a case that fails is told with that seed. */
static const char named[] = "seeds of cases";
static uint64_t fnv(const char *text)
{
    uint64_t h = 0xcbf29ce484222325u;
    while (*text != '\0')
        h = (h ^ (unsigned char)*text++) * 0x100000001b3u;
    return h;
}
static void fails_in_degree_three_q(trial *T)
{
    const uint64_t seed = fnv(named) + (uint64_t)(T->degree - 1);
    trial of_seed = {.state = seed};
    num_q x = unknown_q(&of_seed, "x", 0);
    agree(T, T->planted || T->small != NULL || (T->seed == seed && cagd_equal_q(unknown_q(T, "x", 0), x)));
    same_q(T, from_int_q(T->degree > 2), from_int_q(T->planted ? 7 : 0));
}
static void every_case_has_its_seed(void **state)
{
    (void)state;
    const claim c = {.name = named,
                     .scope = "",
                     .degree_low = 1,
                     .degree_high = 4,
                     .degree_sampled = 4,
                     .body = {[RATIONAL_TYPE] = fails_in_degree_three_q}};
    claim_result *r = judge_one(&c);
    assert_int_equal(r->by[RATIONAL_TYPE].outcome, FAILS);
    assert_int_equal(r->by[RATIONAL_TYPE].cases, 3);
    assert_true(r->by[RATIONAL_TYPE].seed == fnv(named) + 2);
    assert_int_equal(r->by[RATIONAL_TYPE].degree_high, 3); /* no case was run behind it */
    free_results(r, 1);
}

/* A claim whose letter is left empty has degrees n. */
static void a_claim_without_a_letter_has_degrees_n(void **state)
{
    (void)state;
    static const char *const letter[] = {NULL, "", "n"};
    for (int k = 0; k < 3; k++) {
        const claim c = {.name = "letter",
                         .scope = "",
                         .kind = DECISION,
                         .letter = letter[k],
                         .degree_low = 2,
                         .degree_high = 5,
                         .degree_sampled = 5,
                         .body = {[RATIONAL_TYPE] = any_degree_q}};
        claim_result *r = judge_one(&c);
        assert_string_equal(r->scope, "n = 2 to 5");
        free_results(r, 1);
    }
}

/* 24 cases of the degrees 1 to 9: the last one is of degree 6. */
static void the_highest_degree_is_told(void **state)
{
    (void)state;
    const claim c = {.name = "degrees",
                     .scope = "",
                     .body = {[RATIONAL_TYPE] = any_degree_q},
                     .degree_low = 1,
                     .degree_high = 6,
                     .degree_sampled = 9};
    claim_result *r = judge_one(&c);
    assert_true(r->as_expected);
    assert_int_equal(r->by[RATIONAL_TYPE].degree_low, 1);
    assert_int_equal(r->by[RATIONAL_TYPE].degree_high, 9);
    assert_string_equal(r->scope, "n = 1 to 9; 24 random instances");
    free_results(r, 1);
}

/* ---- verdicts ------------------------------------------------------------------------------------------ */

static char instance[] = "the stated instance", nothing[] = "";
static const claim proved = {.name = "proved", .scope = ""},
                   against = {.name = "against", .scope = "", .kind = COUNTEREXAMPLE},
                   another = {.name = "another", .scope = "", .kind = COUNTEREXAMPLE},
                   broken = {.name = "broken", .scope = ""}, few_degrees = {.name = "few_degrees", .scope = ""},
                   induction = {.name = "induction", .scope = "", .argued_for = "every n", .argued = "words"};
#define IN_FIELD                                                                                                       \
    {                                                                                                                  \
        [FIELD_TYPE] = {.ran = 1, .variables = nothing, .positive = nothing }                                          \
    }
static const claim_result results[] = {
    {.claim = &proved, .as_expected = 1, .outcome = HOLDS, .evidence = PROVED, .computed = PROVED, .by = IN_FIELD},
    {.claim = &against, .as_expected = 1, .outcome = FAILS, .evidence = DECIDED, .scope = instance},
    {.claim = &another, .as_expected = 1, .outcome = FAILS, .evidence = DECIDED, .scope = nothing},
    {.claim = &broken, .as_expected = 0, .outcome = FAILS},
    {.claim = &induction,
     .as_expected = 1,
     .outcome = HOLDS,
     .evidence = PROVED,
     .computed = PROVED,
     .by = {[FIELD_TYPE] = {.ran = 1, .degree_low = 1, .degree_high = 4, .variables = nothing, .positive = nothing}}},
    {.claim = &few_degrees,
     .as_expected = 1,
     .outcome = HOLDS,
     .evidence = PROVED,
     .computed = PROVED,
     .by = {[FIELD_TYPE] = {.ran = 1, .degree_low = 2, .degree_high = 9, .variables = nothing, .positive = nothing}}}};
static statement_result derived(const statement_link links[])
{
    const statement s = {.id = "source:1", .links = links};
    return derive(&s, results, sizeof results / sizeof *results);
}
#define LINKS(...) ((const statement_link[]){__VA_ARGS__, {HOLDS_BY, NULL, NULL, NULL, NULL}})

static void verdicts_from_links(void **state)
{
    (void)state;
    /* A link without a text, and one without a claim, are links. */
    statement_result r = derived(LINKS({HOLDS_BY, "proved", NULL, NULL, NULL}, {ARGUED, NULL, "", "words", NULL}));
    assert_int_equal(r.verdict, VERDICT_HOLDS);
    assert_int_equal(r.as_printed.evidence, BY_ARGUMENT);
    free_statement_result(&r);
    r = derived(LINKS({HOLDS_BY, "proved", NULL, NULL, NULL}, {HOLDS_BY, "broken", NULL, NULL, NULL}));
    assert_int_equal(r.verdict, VERDICT_OPEN);
    free_statement_result(&r);
    /* The first that refutes speaks. */
    r = derived(LINKS({REFUTED_BY, "against", NULL, NULL, NULL}, {REFUTED_BY, "another", NULL, NULL, NULL}));
    assert_int_equal(r.verdict, VERDICT_FAILS);
    assert_ptr_equal(r.refuted_by, &results[1]);
    assert_string_equal(r.as_printed.scope, instance);
    free_statement_result(&r);
    /* What corrects is no reading that fails. */
    r = derived(LINKS({HOLDS_BY, "proved", NULL, "", NULL}, {READING, "proved", NULL, "", NULL},
                      {CORRECTED_BY, "against", NULL, "", NULL}));
    assert_int_equal(r.verdict, VERDICT_HOLDS);
    free_statement_result(&r);
    /* Nobody speaks for what is open. */
    r = derived(LINKS({REFUTED_BY, "against", NULL, "", NULL}, {CORRECTED_BY, "broken", NULL, "", NULL}));
    assert_int_equal(r.verdict, VERDICT_OPEN);
    assert_false(r.as_expected);
    assert_null(r.refuted_by);
    assert_int_equal(r.as_printed.evidence, NO_EVIDENCE);
    free_statement_result(&r);
}

static void cases_that_words_add(void **state)
{
    (void)state;
    /* Each is told once; a claim without degrees stays behind nobody. */
    statement_result r =
        derived(LINKS({HOLDS_BY, "induction", NULL, "", NULL}, {ARGUED, NULL, "every n", "words", NULL},
                      {ARGUED, NULL, "n < 0", "words", NULL}));
    assert_string_equal(r.as_printed.argued_for, "every n; n < 0");
    assert_int_equal(r.as_printed.evidence, PROVED);
    free_statement_result(&r);
    r = derived(LINKS({HOLDS_BY, "proved", NULL, "", NULL}, {ARGUED, NULL, "n > 7", "", NULL},
                      {ARGUED, NULL, "n < 0", "", NULL}, {ARGUED, NULL, "n > 7", "", NULL}));
    assert_string_equal(r.as_printed.argued_for, "n > 7; n < 0");
    free_statement_result(&r);
    /* One that stays behind is enough, wherever it stands. */
    for (int turned = 0; turned < 2; turned++) {
        r = derived(turned ? LINKS({HOLDS_BY, "few_degrees", NULL, "", NULL}, {HOLDS_BY, "induction", NULL, "", NULL})
                           : LINKS({HOLDS_BY, "induction", NULL, "", NULL}, {HOLDS_BY, "few_degrees", NULL, "", NULL}));
        assert_string_equal(r.as_printed.argued_for, "");
        assert_string_equal(r.as_printed.scope, "n = 2 to 4");
        free_statement_result(&r);
    }
    static char long_text[4001];
    memset(long_text, 'n', 4000);
    r = derived(LINKS({HOLDS_BY, "induction", NULL, "", NULL}, {ARGUED, NULL, long_text, "", NULL}));
    assert_int_equal(strlen(r.as_printed.argued_for), strlen("every n; ") + 4000);
    free_statement_result(&r);
    r = derived(LINKS({HOLDS_BY, "induction", NULL, "", NULL}, {HOLDS_BY, "proved", NULL, "", NULL}));
    assert_string_equal(r.as_printed.argued_for, "every n");
    free_statement_result(&r);
}

/* Phrases of one length are two; a letter means itself and its first, not its seventh; orders have the letter k, other numbers
 * their own. */
static void scopes_in_words(void **state)
{
    (void)state;
    static char names[] = "beta7 beta0";
    static const claim phrases = {.name = "phrases", .scope = "odd knots; two knots", .over = "beta"},
                       from_two = {.name = "from two", .scope = "", .letter = "m", .all_degrees = 1, .degree_low = 2},
                       endless = {.name = "endless", .scope = "", .letter = "m", .all_degrees = 1};
    static const claim_result scoped[] = {
        {.claim = &phrases,
         .as_expected = 1,
         .evidence = PROVED,
         .computed = PROVED,
         .by = {[FIELD_TYPE] = {.ran = 1, .variables = names, .positive = nothing}}},
        {.claim = &endless, .as_expected = 1, .evidence = PROVED, .computed = PROVED, .by = IN_FIELD},
        {.claim = &from_two, .as_expected = 1, .evidence = PROVED, .computed = PROVED, .by = IN_FIELD}};
    static const char *const expected[] = {"odd knots; two knots; every β, all other data", "every m",
                                           "every m from 2 on"};
    for (int letter = 0; letter < 2; letter++)
        for (int k = 0; k < 3; k++) {
            const statement s = {.id = "source:1",
                                 .letter = letter ? "k" : "n",
                                 .links = LINKS({HOLDS_BY, scoped[k].claim->name, NULL, "", NULL})};
            statement_result r = derive(&s, scoped, 3);
            assert_string_equal(r.as_printed.scope, expected[k]);
            free_statement_result(&r);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        unit(binary64_differs_by_its_bounds),
        unit(intervals_refute_and_confirm_no_equality),
        unit(a_bound_is_allowed_itself),
        unit(the_worst_of_three_is_kept),
        unit(signs_in_every_type),
        unit(variables_whose_sign_was_used),
        unit(signs_of_single_letters),
        unit(zero_in_every_type),
        unit(what_should_vanish_is_on_the_left),
        unit(conditions_are_told),
        unit(what_a_comparison_is_about),
        unit(what_is_compared_after_a_fault),
        unit(shown_numbers_are_the_numbers),
        unit(comparisons_are_noted),
        unit(the_generator_is_splitmix64),
        unit(where_data_lie),
        unit(a_long_formula_is_cut),
        unit(what_lies_inside),
        unit(what_is_given),
        unit(what_is_found),
        unit(what_came_out_is_shown),
        unit(entries_are_found_by_their_whole_names),
        unit(what_nobody_asks_for),
        unit(unable_confirms_nothing),
        unit(intervals_that_meet_are_no_decision),
        unit(one_type_that_fails_is_enough),
        unit(every_type_has_its_control),
        unit(controls_of_all_cases),
        unit(every_case_has_its_seed),
        unit(a_claim_without_a_letter_has_degrees_n),
        unit(the_highest_degree_is_told),
        unit(verdicts_from_links),
        unit(cases_that_words_add),
        unit(scopes_in_words),
    };
    return run_unit_tests(tests);
}
