/* test_changes.c -- how a statement is changed to see whether it says anything, and which statements say nothing by their form. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/expression/change.h"
#include "exact/expression/read.h"
#include "exact/expression/vacuous.h"
#include "exact/number/field.h"

#include <stdio.h>
#include <string.h>

static cagd_scope scope;

static void define(const char *line)
{
    cagd_reading_error error = {0};
    if (!cagd_read_definition(&scope, line, 0, (int)strlen(line), &error))
        fail_msg("%s: %s", line, error.message);
}
static void begin(void)
{
    scope = (cagd_scope){0};
    field_open(8);
    define("x, y, u, x_i, c_i^r \\in \\mathbb{R}");
    define("f(t) = t^2");
}
static const cagd_tree *statement_of(const char *text)
{
    cagd_reading_error error = {0};
    const cagd_tree *t = cagd_read_statement(&scope, text, 0, (int)strlen(text), &error);
    if (t == NULL)
        fail_msg("%s: %s", text, error.message);
    return t;
}

enum { MOST = 12 };

/* All changes of a statement, in their order: each number is one more, each relation but = is turned around, each term of a sum has the other
 * sign, each index, exponent and end of a range is one more; where there is nothing of that kind, each name is. */
static void all_changes(void **state)
{
    (void)state;
    static const struct {
        const char *statement, *changed[MOST];
    } list[] = {
        {"x + 2 = y", {"-x + 2 = y", "x - 2 = y", "x + (2 + 1) = y"}},
        {"x - y \\le u", {"x - y \\ge u", "-x - y \\le u", "x + y \\le u"}},
        {"x < y", {"x > y"}},
        {"x > y \\ne u", {"x < y \\ne u", "x > y = u"}},
        {"x \\ge 3", {"x \\le 3", "x \\ge (3 + 1)"}},
        {"x = y", {"(x + 1) = y", "x = (y + 1)"}},
        {"x_u y = f(x)", {"x_{u + 1} y = f(x)"}},
        {"x_1 = y", {"x_{1 + 1} = y"}},
        {"c_y^u = x", {"c_{y + 1}^u = x", "c_y^{u + 1} = x"}},
        {"c_1^u = x", {"c_{1 + 1}^u = x", "c_1^{u + 1} = x"}},
        {"x^u = y^2", {"x^{u + 1} = y^2", "x^u = y^{2 + 1}"}},
        {"\\binom{x}{y} = u", {"\\binom{x + 1}{y} = u", "\\binom{x}{y + 1} = u"}},
        {"\\sum_{k=x}^y u = x", {"\\sum_{k=x + 1}^y u = x", "\\sum_{k=x}^{y + 1} u = x"}},
        {"\\prod_{k=1}^y u = x", {"\\prod_{k=1 + 1}^y u = x", "\\prod_{k=1}^{y + 1} u = x"}},
        {"\\max_{k=x}^y u = x", {"\\max_{k=x + 1}^y u = x", "\\max_{k=x}^{y + 1} u = x"}},
        {"\\min_{k=x}^1 u = x", {"\\min_{k=x + 1}^1 u = x", "\\min_{k=x}^{1 + 1} u = x"}},
        {"f(x) = y", {"(f(x) + 1) = y", "f(x) = (y + 1)"}},
        {"f(x)|_{x=y} = u", {"f(x)|_{x=y + 1} = u"}},
        {"\\frac{x}{y} = |u|", {"\\frac{x + 1}{y} = |u|", "\\frac{x}{y + 1} = |u|", "\\frac{x}{y} = |u + 1|"}},
        {"x = 1, y < u", {"x = (1 + 1), y < u", "x = 1, y > u"}},
        {"x = 1 \\Rightarrow y \\ne u", {"x = (1 + 1) \\Rightarrow y \\ne u", "x = 1 \\Rightarrow y = u"}},
    };
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        begin();
        const cagd_tree *t = statement_of(list[k].statement);
        int count = 0;
        while (count < MOST && list[k].changed[count] != NULL) {
            const cagd_tree *is = cagd_changed(t, count), *expected = statement_of(list[k].changed[count]);
            if (is == NULL || !cagd_tree_equal(is, expected))
                fail_msg("%s, change %d is not %s", list[k].statement, count, list[k].changed[count]);
            count++;
        }
        if (cagd_changed(t, count) != NULL)
            fail_msg("%s has more than %d changes", list[k].statement, count);
        if (!cagd_tree_equal(t, statement_of(list[k].statement)))
            fail_msg("%s was changed itself", list[k].statement);
        field_close();
    }
}

static const char *const sign[] = {"=", "\\ne", "<", "\\le", ">", "\\ge"};
/* The signs of a - b for which a relation holds: bits of -, 0, +. */
static const unsigned signs[] = {2, 5, 1, 3, 4, 6};
static const int turned[] = {0, 1, 4, 5, 2, 3};

static void says_nothing(const char *statement, int expected)
{
    int is = cagd_is_vacuous(&scope, statement_of(statement));
    if (is != expected)
        fail_msg("%s says %s", statement, is ? "nothing" : "something");
}

/* A relation says nothing where another one between the same sides, of which it follows, is supposed, a condition, or how a name was declared;
 * either side may be the left one. */
static void what_follows_says_nothing(void **state)
{
    (void)state;
    for (int known = 0; known < 6; known++)
        for (int said = 0; said < 6; said++) {
            int follows = (signs[known] & ~signs[said]) == 0;
            char text[200], range[80];
            for (int turn = 0; turn < 2; turn++) {
                const char *a = turn ? "y^2" : "x y", *b = turn ? "x y" : "y^2";
                const char *relation = sign[turn ? turned[said] : said];
                begin();
                snprintf(text, sizeof text, "x y %s y^2 \\Rightarrow %s %s %s", sign[known], a, relation, b);
                says_nothing(text, follows);
                snprintf(text, sizeof text, "u = 1, x y %s y^2 \\Rightarrow %s %s %s", sign[known], a, relation, b);
                says_nothing(text, follows);
                snprintf(text, sizeof text, "x y %s y^2 \\Rightarrow %s %s %s, u = u", sign[known], a, relation, b);
                says_nothing(text, follows);
                snprintf(text, sizeof text, "x y %s y^2 \\Rightarrow %s %s %s, u = 1", sign[known], a, relation, b);
                says_nothing(text, 0);
                snprintf(text, sizeof text, "u %s y^2 \\Rightarrow %s %s %s", sign[known], a, relation, b);
                says_nothing(text, 0);
                cagd_reading_error error = {0};
                snprintf(range, sizeof range, "x y %s y^2", sign[known]);
                if (cagd_read_ranges(&scope, range, 0, (int)strlen(range), &error)) {
                    snprintf(text, sizeof text, "%s %s %s", a, relation, b);
                    says_nothing(text, follows);
                }
                field_close();
                if (known < 2)
                    continue;
                begin();
                snprintf(range, sizeof range, "x %s 1", sign[known]); /* a bound of the name */
                assert_true(cagd_read_ranges(&scope, range, 0, (int)strlen(range), &error));
                snprintf(text, sizeof text, turn ? "1 %s x" : "x %s 1", relation);
                says_nothing(text, follows);
                snprintf(text, sizeof text, turn ? "2 %s x" : "x %s 2", relation);
                says_nothing(text, 0);
                field_close();
            }
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(all_changes), unit(what_follows_says_nothing)};
    return run_unit_tests(tests);
}
