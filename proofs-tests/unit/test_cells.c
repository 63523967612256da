/* test_cells.c -- what is known of names together, the signs that follow, inequalities between ordered names, and sums for every n. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/expression/cell.h"
#include "exact/expression/every.h"
#include "exact/expression/order.h"
#include "exact/expression/read.h"
#include "exact/words.h"

#include <string.h>

enum { MOST = 4, NEGATIVE = CAGD_CAN_BE_NEGATIVE, ZERO = CAGD_CAN_BE_ZERO, POSITIVE = CAGD_CAN_BE_POSITIVE };

static cagd_scope scope;
static cagd_context cell;

static void begin(const char *definition)
{
    cagd_reading_error error;
    scope = (cagd_scope){0};
    field_open(16);
    assert_true(cagd_read_definition(&scope, definition, 0, (int)strlen(definition), &error));
    cell = (cagd_context){.scope = &scope, .steps = CAGD_USUAL_STEPS, .in_field = 1};
}

static num_f form(const char *text)
{
    cagd_reading_error error;
    const cagd_tree *t = cagd_read_value(&scope, text, 0, (int)strlen(text), &error);
    assert_non_null(t);
    num_f value = cagd_in_field(cagd_evaluate(&cell, t));
    assert_int_equal(region_faults, 0);
    return value;
}

struct limit {
    const char *form; /* NULL: no more */
    int strict;
};

/* The names are met in the order in which they stand in `names`. */
static void begin_cell(const char *names, const struct limit limit[])
{
    begin("x, y \\in \\mathbb{R}");
    for (; *names != '\0'; names++)
        form((char[]){*names, '\0'});
    for (int k = 0; k < MOST && limit[k].form != NULL; k++)
        assert_true(cagd_limit_cell(&cell, form(limit[k].form), limit[k].strict));
}

/* What is not decided is not positive: x^4 y^2 + y^4 u^2 + u^4 x^2 - 3 x^2 y^2 u^2 is nonnegative, and no sum of squares. */
static void what_is_not_decided_is_not_positive(void **state)
{
    (void)state;
    static const char choi_lam[] = "x^4 y^2 + y^4 u^2 + u^4 x^2 - 3 x^2 y^2 u^2";
    num_q value[CAGD_MOST_UNKNOWNS];
    int rational;
    begin("x, y, u \\in \\mathbb{R}");
    num_f p = form(choi_lam), negative = form("-1 - x^2 - y^2 - u^2");
    assert_int_equal(cagd_positive_in_cell(&cell, p, 0, value, &rational), CAGD_UNDECIDED);
    assert_false(cagd_is_positive_in_cell(&cell, p, 0));
    assert_false(cagd_is_positive_in_cell(&cell, negative, 0));
    field_close();
    static const struct limit ordered[MOST] = {{"x", 1}, {"y - x", 1}};
    begin_cell("xy", ordered);
    assert_true(cagd_is_positive_in_cell(&cell, form("x y + y"), 1));
    assert_false(cagd_is_positive_in_cell(&cell, form("x - y"), 0));
    field_close();
}

/* A point of a cell meets all its limits; an empty cell has none. */
static void points_of_cells(void **state)
{
    (void)state;
    static const struct {
        struct limit limit[MOST];
        int is_empty;
    } list[] = {{{{"x - y", 1}, {"y - 1/3", 0}, {"1/2 - x", 1}}, 0},
                {{{"x - y", 1}, {"x + y - 7", 0}, {"9 - x - y", 0}}, 0},
                {{{"x - 5 y", 1}, {"y + 2 - x", 1}}, 0},
                {{{"2 x + 3 y - 100", 0}, {"101 - 2 x - 3 y", 1}, {"-y", 1}}, 0},
                {{{"x - y", 0}, {"y - x", 0}, {"x - 2/7", 1}}, 0},
                {{{"x - y", 1}, {"y - x", 1}}, 1},
                {{{"x + y - 1", 1}, {"-x", 0}, {"-y", 0}}, 1}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        num_q value[CAGD_MOST_UNKNOWNS];
        begin_cell("xy", list[k].limit);
        assert_int_equal(cagd_point_of_cell(&cell, value), !list[k].is_empty);
        for (int m = 0; !list[k].is_empty && m < MOST && list[k].limit[m].form != NULL; m++) {
            num_f f = form(list[k].limit[m].form);
            for (int n = 0; n < cell.count; n++)
                f = substitute_f(f, cell.binding[n].value.f, cagd_from_rational_f(value[n]));
            num_q at;
            assert_true(cagd_is_constant_f(f, &at));
            assert_true(list[k].limit[m].strict ? cagd_sign_q(at) > 0 : cagd_sign_q(at) >= 0);
        }
        field_close();
    }
}

static void bounds_of_a_name(void **state)
{
    (void)state;
    static const struct {
        struct limit limit[MOST];
        const char *form;
        unsigned signs; /* 0: there are no such values */
    } list[] = {
        {{{"x", 1}}, "x", POSITIVE},
        {{{"x", 0}}, "x", ZERO | POSITIVE},
        {{{"x", 1}, {"x", 0}}, "x", POSITIVE},
        {{{"x", 0}, {"x", 1}}, "x", POSITIVE},
        {{{"-x", 1}, {"-x", 0}}, "x", NEGATIVE},
        {{{"x", 1}, {"x + 1", 1}}, "x", POSITIVE},
        {{{"x + 1", 1}, {"x", 1}}, "x", POSITIVE},
        {{{"1 - x", 0}, {"2 - x", 0}}, "x - 1", NEGATIVE | ZERO},
        {{{"x - 1", 0}, {"1 - x", 0}}, "x - 1", ZERO},
        {{{"x - 1", 0}, {"1 - x", 1}}, "x", 0},
        {{{"x - 1", 1}, {"1 - x", 0}}, "x", 0},
        {{{"x - 2", 0}, {"1 - x", 0}}, "x", 0},
        {{{"x - x", 1}}, "x", 0},
        {{{"x - x", 0}}, "x", NEGATIVE | ZERO | POSITIVE},
        {{{"x - x - 1", 0}}, "x", 0},
        {{{"x - x + 1", 1}}, "x", NEGATIVE | ZERO | POSITIVE},
        {{{"x - y", 1}, {"y - x", 0}}, "x", 0},
        {{{"x - y", 0}, {"y - x", 0}}, "x - y", ZERO},
        {{{"x", 1}, {"y", 1}}, "-2 x y", NEGATIVE},
        {{{"-x", 1}, {"-y", 1}}, "x y", POSITIVE},
        {{{"x", 0}, {"y", 1}}, "x y", ZERO | POSITIVE},
        {{{"x", 1}, {"-y", 1}}, "\\frac{x}{-3 y}", POSITIVE},
        {{{"x", 1}}, "-x^3", NEGATIVE},
        {{{NULL, 0}}, "-x^2 y^2", NEGATIVE | ZERO},
    };
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        begin_cell("xy", list[k].limit);
        if (cagd_cell_is_empty(&cell) != (list[k].signs == 0))
            fail_msg("cell %d is%s empty", (int)k, list[k].signs == 0 ? " not" : "");
        unsigned signs = list[k].signs != 0 ? cagd_signs(&cell, cagd_value_f(form(list[k].form))) : 0;
        if (signs != list[k].signs)
            fail_msg("cell %d: the signs of %s are %u, not %u", (int)k, list[k].form, signs, list[k].signs);
        field_close();
    }
}

/* What was found before something more is known is not said again. */
static void more_is_known(void **state)
{
    (void)state;
    begin_cell("xy", (struct limit[MOST]){{NULL, 0}});
    assert_int_equal(cagd_signs_of_form(&cell, form("x - y")), NEGATIVE | ZERO | POSITIVE);
    assert_true(cagd_limit_cell(&cell, form("x - y"), 0));
    assert_int_equal(cagd_signs_of_form(&cell, form("x - y")), ZERO | POSITIVE);
    assert_true(cagd_solve_in_cell(&cell, form("x - y - 1")));
    assert_int_equal(cagd_signs(&cell, cagd_value_f(form("x - y"))), POSITIVE);
    field_close();
}

static void ordered_names(void **state)
{
    (void)state;
    static const struct {
        struct limit limit[MOST];
        const char *form;
        int strict, holds;
    } list[] = {
        {{{"x", 0}, {"1 - y", 0}, {"y - x", 1}}, "2 - y", 1, 1},
        {{{"x", 0}, {"1 - y", 0}, {"y - x", 1}}, "1 - y", 0, 1},
        {{{"x", 0}, {"1 - y", 0}, {"y - x", 1}}, "1 - y", 1, 0},
        {{{"x", 0}, {"1 - y", 0}, {"y - x", 1}}, "x", 0, 1},
        {{{"x", 0}, {"y - x", 1}}, "y^2 - x^2", 1, 1},
        {{{"x", 0}, {"y - x", 0}}, "y^2 - x^2", 1, 0},
        {{{"x", 0}, {"y - x", 0}}, "y^2 - x^2", 0, 1},
        {{{"x - y", 0}, {"x - y", 1}}, "x - y", 1, 1},
        {{{"x - y", 1}, {"x - y", 0}}, "x - y", 1, 1},
        {{{"x - y", 1}, {"x - y + 1", 1}}, "x - y", 1, 1},
        {{{"x - y", 0}, {"x - y + 1", 1}}, "x - y", 1, 0},
    };
    for (size_t k = 0; k < 2 * sizeof list / sizeof *list; k++) {
        begin_cell(k % 2 ? "xy" : "yx", list[k / 2].limit);
        if (cagd_is_positive_in_cell(&cell, form(list[k / 2].form), list[k / 2].strict) != list[k / 2].holds)
            fail_msg("order %d, %s: %s", (int)(k / 2), k % 2 ? "x, y" : "y, x", list[k / 2].form);
        field_close();
    }
}

/* c t + 1 > 0 for all t >= 0: where the leading coefficient vanishes, a root goes to infinity. */
static void roots_at_infinity(void **state)
{
    (void)state;
    begin("x, y \\in \\mathbb{R}");
    num_f t = variable_f("t"), c = variable_f("c"), one = from_int_f(1);
    cagd_side_of_box of_t = {.variable = t, .has_low = 1, .low = from_int_q(0)}, all = {.variable = c};
    cagd_cells *cells = region_bytes(sizeof *cells);
    cagd_constraint constraint = {.p = add_f(mul_f(c, t), one), .demand = CAGD_MORE_THAN_ZERO, .t = of_t};
    assert_true(cagd_cells_of(1, &constraint, &all, cells));
    assert_int_equal(cells->count, 1);
    assert_int_equal(cells->cell[0], CAGD_FAILS);
    assert_int_equal(cells->at[0], CAGD_HOLDS);
    assert_int_equal(cells->cell[1], CAGD_HOLDS);
    assert_true(cagd_is_zero_q(cells->root[0].lo) && cagd_is_zero_q(cells->root[0].hi));
    field_close();
}

/* Each sum as it is, and one that is wrong; the first numbers n alone do not decide. */
static void sums_for_every_number(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int holds;
    } list[] = {
        {"\\sum_{k=0}^n \\binom{n}{k} = 2^n", 1},
        {"\\sum_{k=0}^n \\binom{n}{k}^2 = \\binom{2n}{n}", 1},
        {"\\sum_{k=0}^n \\frac{(n!)^2}{(k!)^2 ((n-k)!)^2} = \\binom{2n}{n}", 1},
        {"\\sum_{k=1}^{n-1} \\binom{n-2}{k-1} = 2^{n-2}", 1},
        {"\\sum_{k=0}^n \\binom{n}{k} 3^k = 4^n", 1},
        {"\\sum_{k=0}^n \\binom{n}{k} = 2^{n-1}", 0},
        {"\\sum_{k=0}^n \\binom{n}{k} k^n = n!", 0},
        /* false from n = 1 on; with the base for a constant it would be the next one */
        {"\\sum_{k=0}^n (-1)^k \\binom{n}{k} \\frac{2^k k! (2k+1)^k}{(2k+1)!} = \\frac{4^n}{(2n+1) \\binom{2n}{n}}", 0},
        {"\\sum_{k=0}^n (-1)^k \\binom{n}{k} \\frac{1}{2k+1} = \\frac{4^n}{(2n+1) \\binom{2n}{n}}", 1},
        {"\\sum_{k=0}^n (n+1-k) \\binom{n}{k} = (n+2) 2^{n-1}", 1},
        {"\\sum_{k=0}^n (2k+3) (k+1)^{-2} (k+2)^{-2} = (n+1) (n+3) (n+2)^{-2}", 1},
        {"\\sum_{k=0}^n (2k+3) (k+1)^{-2} (k+2)^{-2} = (n+1) (n+3) (n+2)^{-1}", 0},
        {"\\sum_{k=0}^n \\binom{n}{k} n^k = 2^n", 0}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        cagd_reading_error error;
        cagd_every found;
        begin("n \\ge 0, n \\in \\mathbb{N}");
        const cagd_tree *t = cagd_read_statement(&scope, list[k].text, 0, (int)strlen(list[k].text), &error);
        assert_non_null(t);
        if (cagd_holds_for_every(&scope, t, cagd_declared(&scope, "n"), 0, 8, &found) != list[k].holds)
            fail_msg("%s is%s proved", list[k].text, list[k].holds ? " not" : "");
        region_faults = 0;
        field_close();
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(points_of_cells),      unit(what_is_not_decided_is_not_positive),
                                       unit(bounds_of_a_name),     unit(more_is_known),
                                       unit(ordered_names),        unit(roots_at_infinity),
                                       unit(sums_for_every_number)};
    return run_unit_tests(tests);
}
