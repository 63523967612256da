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

/* ---- Drawn cells, against all points of a lattice -------------------------------------------------------
 *
 * A drawn form is a x_i - b x_j + c with a, b = 0 or 1, or its negative, and |c| <= 1.  The planes on which such forms are 0 cut the space
 * into simplices whose corners are whole numbers; inside each simplex, each of its sides, edges and corners lies a point whose
 * coordinates are quarters, since four different remainders have room there.  Three limits and one more form never
 * lead farther out than 4 3/4, and so the signs of a form in a cell are those at the points of the lattice. */
enum { NAMES = 3, FAR = 19, DRAWN = 200 };

struct drawn {
    int plus, minus, constant; /* the name with each sign, or -1 */
};

/* Four times its value at a fourth of the numbers. */
static long at_quarters(const struct drawn *d, const int x[])
{
    return (d->plus >= 0 ? x[d->plus] : 0) - (d->minus >= 0 ? x[d->minus] : 0) + 4 * d->constant;
}

static struct drawn draw_form(void)
{
    struct drawn d = {random_int(-1, NAMES - 1), random_int(-1, NAMES - 1), random_int(-1, 1)};
    return d.plus >= 0 || d.minus >= 0 ? d : draw_form();
}

struct drawn_cell {
    int limits, strict[MOST];
    struct drawn limit[MOST];
};

/* A limit of the cell, or with 1 more, or any form. */
static struct drawn draw_near(const struct drawn_cell *c)
{
    struct drawn d = random_int(0, 3) > 0 ? c->limit[random_int(0, c->limits - 1)] : draw_form();
    d.constant += d.constant < 1 && random_int(0, 2) == 0;
    return d;
}

static num_f drawn_form(const struct drawn *d)
{
    static const char *const name[] = {"x", "y", "u"};
    num_f f = from_int_f(d->constant);
    if (d->plus >= 0)
        f = add_f(f, form(name[d->plus]));
    return d->minus >= 0 ? sub_f(f, form(name[d->minus])) : f;
}

static int is_in(const struct drawn_cell *c, const int x[])
{
    int in = 1;
    for (int k = 0; in && k < c->limits; k++) {
        long value = at_quarters(&c->limit[k], x);
        in = c->strict[k] ? value > 0 : value >= 0;
    }
    return in;
}

static unsigned sign_bit(long value) { return value < 0 ? NEGATIVE : value > 0 ? POSITIVE : ZERO; }

/* Three limits, or two and a bound that others may say already; the names are met in any order. */
static struct drawn_cell begin_drawn(void)
{
    static const char *const order[] = {"xyu", "xuy", "yxu", "yux", "uxy", "uyx"};
    struct drawn_cell c = {.limits = random_int(1, 3)};
    begin("x, y, u \\in \\mathbb{R}");
    for (const char *name = order[random_int(0, 5)]; *name != '\0'; name++)
        form((char[]){*name, '\0'});
    for (int k = 0; k < c.limits; k++) {
        c.limit[k] = draw_form(), c.strict[k] = random_int(0, 1);
        assert_true(cagd_limit_cell(&cell, drawn_form(&c.limit[k]), c.strict[k]));
    }
    return c;
}

/* The signs of a form, of a product of two forms and a third one, and of that alone where the cell has points: by the lattice. */
struct on_lattice {
    unsigned of_form, of_curved;
    long points;
};

static struct on_lattice look(const struct drawn_cell *c, const struct drawn p[3])
{
    struct on_lattice seen = {0};
    for (int x = -FAR; x <= FAR; x++)
        for (int y = -FAR; y <= FAR; y++)
            for (int u = -FAR; u <= FAR; u++) {
                const int at[NAMES] = {x, y, u};
                if (!is_in(c, at))
                    continue;
                seen.points++;
                seen.of_form |= sign_bit(at_quarters(&p[0], at));
                seen.of_curved |=
                    sign_bit(at_quarters(&p[0], at) * at_quarters(&p[1], at) + 4 * at_quarters(&p[2], at));
            }
    return seen;
}

static num_q at_point(num_f f, const num_q value[])
{
    num_q q;
    for (int n = 0; n < cell.count; n++)
        f = substitute_f(f, cell.binding[n].value.f, cagd_from_rational_f(value[n]));
    assert_true(cagd_is_constant_f(f, &q));
    return q;
}

static int is_point_of(const struct drawn_cell *c, const num_q value[])
{
    int in = 1;
    for (int k = 0; in && k < c->limits; k++)
        in = cagd_sign_q(at_point(drawn_form(&c->limit[k]), value)) >= c->strict[k];
    return in;
}

static void drawn_cells(void **state)
{
    (void)state;
    int empty = 0, held = 0, curved = 0, points = 0;
    for (int n = 0; n < DRAWN; n++) {
        struct drawn_cell c = begin_drawn();
        const struct drawn drawn[3] = {draw_near(&c), draw_near(&c), draw_near(&c)};
        struct on_lattice seen = look(&c, drawn);
        num_q value[CAGD_MOST_UNKNOWNS] = {0};
        assert_int_equal(cagd_cell_is_empty(&cell), seen.points == 0);
        assert_int_equal(cagd_point_of_cell(&cell, value), seen.points != 0);
        assert_true(seen.points == 0 || is_point_of(&c, value));
        empty += seen.points == 0;
        num_f f = drawn_form(&drawn[0]), g = add_f(mul_f(f, drawn_form(&drawn[1])), drawn_form(&drawn[2]));
        if (seen.points != 0 && cagd_signs_of_form(&cell, f) != seen.of_form)
            fail_msg("cell %d: the signs are %u, not %u", n, cagd_signs_of_form(&cell, f), seen.of_form);
        for (int k = 0; seen.points != 0 && k < 4; k++) {
            unsigned wrong = NEGATIVE | (k % 2 ? ZERO : 0), signs = k < 2 ? seen.of_form : seen.of_curved;
            int rational;
            cagd_answer answer = cagd_positive_in_cell(&cell, k < 2 ? f : g, k % 2, value, &rational);
            int is = (signs & wrong) == 0;
            if (answer == CAGD_HOLDS ? !is : k < 2 && is) /* of linear forms all is decided */
                fail_msg("cell %d: %s to be positive", n, is ? "not told" : "told");
            if (answer == CAGD_FAILS && rational)
                points += is_point_of(&c, value) && cagd_sign_q(at_point(k < 2 ? f : g, value)) < k % 2;
            *(k < 2 ? &held : &curved) += answer == CAGD_HOLDS;
        }
        region_faults = 0;
        field_close();
    }
    assert_true(empty >= 40 && held >= 200);
    assert_true(curved >= 145 && points >= 257); /* so many are decided, by now */
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(points_of_cells),       unit(what_is_not_decided_is_not_positive),
                                       unit(bounds_of_a_name),      unit(more_is_known),
                                       unit(ordered_names),         unit(roots_at_infinity),
                                       unit(sums_for_every_number), unit(drawn_cells)};
    return run_unit_tests(tests);
}
