/* test_statements.c -- statements that are decided: where ranges begin, what is certified, what is refused to be read, and monotony. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/expression/basis.h"
#include "exact/expression/certify.h"
#include "exact/expression/check.h"
#include "exact/expression/read.h"

#include <stdio.h>
#include <string.h>

static cagd_scope scope;

/* Definitions, and with a star in front ranges and conditions. */
static void let(const char *const lines[])
{
    cagd_reading_error error;
    scope = (cagd_scope){0};
    for (int k = 0; lines[k] != NULL; k++) {
        const char *line = lines[k] + (*lines[k] == '*');
        if (!(line > lines[k] ? cagd_read_ranges : cagd_read_definition)(&scope, line, 0, (int)strlen(line), &error))
            fail_msg("%s: %s", line, error.message);
    }
}
static const cagd_tree *statement_of(const char *text)
{
    cagd_reading_error error;
    return cagd_read_statement(&scope, text, 0, (int)strlen(text), &error);
}

/* A sum that holds from some n on is proved for every n where the range begins there, and fails where it begins before. */
static void ranges_begin_where_they_say(void **state)
{
    (void)state;
    static const struct {
        const char *range, *statement;
        cagd_answer answer;
    } list[] = {
        {"n > 0, n \\in \\mathbb{N}", "\\sum_{k=0}^n (-1)^k \\binom{n}{k} = 0", CAGD_HOLDS},
        {"n \\ge 1, n \\in \\mathbb{N}", "\\sum_{k=0}^n (-1)^k \\binom{n}{k} = 0", CAGD_HOLDS},
        {"n \\ge 0, n \\in \\mathbb{N}", "\\sum_{k=0}^n (-1)^k \\binom{n}{k} = 0", CAGD_FAILS},
        {"n > 1, n \\in \\mathbb{N}", "\\sum_{k=0}^n (-1)^k k \\binom{n}{k} = 0", CAGD_HOLDS},
        {"n > 0, n \\in \\mathbb{N}", "\\sum_{k=0}^n (-1)^k k \\binom{n}{k} = 0", CAGD_FAILS},
    };
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        cagd_finding found;
        let((const char *const[]){list[k].range, NULL});
        const cagd_tree *t = statement_of(list[k].statement);
        assert_non_null(t);
        cagd_check(&scope, t, 20, &found);
        if (found.answer != list[k].answer || found.for_every != (list[k].answer == CAGD_HOLDS))
            fail_msg("%s, %s: answer %d, for every n: %d", list[k].range, list[k].statement, (int)found.answer,
                     found.for_every);
        region_faults = 0;
        field_close();
    }
}

/* One to three conditions, implications and equivalences, all of which have to be true: by truth tables.  (A single condition behind
 * others could be what is supposed of them.) */
static void lists_of_implications(void **state)
{
    (void)state;
    enum { NUMBERS = 4, LISTS = 150 };
    static const struct {
        const char *text;
        int at[NUMBERS]; /* whether it is true for n = 0, 1, 2, 3 */
    } atom[] = {{"n < 2", {1, 1, 0, 0}},    {"n \\ge 1", {0, 1, 1, 1}}, {"n > 2", {0, 0, 0, 1}},
                {"n \\ne 2", {1, 1, 0, 1}}, {"0 \\le n", {1, 1, 1, 1}}, {"2 n^2 < 5 n", {0, 1, 1, 0}}};
    static const char *const joined[] = {"", " \\Rightarrow ", " \\iff "};
    int answers[3] = {0};
    for (int k = 0; k < LISTS; k++) {
        char text[400] = "";
        int is[NUMBERS] = {1, 1, 1, 1}, parts = random_int(1, 3), failing = 0;
        for (int m = 0; m < parts; m++) {
            int a = random_int(0, 5), b = random_int(0, 5), how = random_int(m > 0, 2);
            size_t at = strlen(text);
            snprintf(text + at, sizeof text - at, "%s(%s%s%s)", m > 0 ? " \\land " : "", atom[a].text, joined[how],
                     how > 0 ? atom[b].text : "");
            for (int n = 0; n < NUMBERS; n++)
                is[n] &= how == 0   ? atom[a].at[n]
                         : how == 1 ? !atom[a].at[n] || atom[b].at[n]
                                    : atom[a].at[n] == atom[b].at[n];
        }
        for (int n = 0; n < NUMBERS; n++)
            failing += !is[n];
        cagd_finding found;
        let((const char *const[]){"*n = 0..3", NULL});
        const cagd_tree *t = statement_of(text);
        if (t == NULL)
            fail_msg("%s", text);
        cagd_check(&scope, t, 20, &found);
        if (found.answer != (failing > 0 ? CAGD_FAILS : CAGD_HOLDS) || found.failing != failing)
            fail_msg("%s: answer %d, %ld of %ld cases fail, not %d", text, (int)found.answer, found.failing,
                     found.cases, failing);
        answers[found.answer]++;
        region_faults = 0;
        field_close();
    }
    assert_true(answers[CAGD_HOLDS] >= 8 && answers[CAGD_FAILS] >= 15);
}

/* Every spelling of the numbers 0 to 3 has just these: the first and the last are among them, and their neighbours are not. */
static void ranges_have_the_numbers_they_say(void **state)
{
    (void)state;
    static const char *const spelled[] = {"i = 0..3",
                                          "0 \\le i \\le 3",
                                          "0 \\le i < 4",
                                          "-1 < i \\le 3",
                                          "-1 < i < 4",
                                          "i = 0, 1, 2, 3",
                                          "i = 0, \\dots, 3",
                                          "i = 0, 1, \\dots, 3",
                                          "3 \\ge i \\ge 0",
                                          "4 > i > -1",
                                          "3 \\ge i > -1",
                                          "4 > i \\ge 0",
                                          "i \\ge 0, i \\le 3",
                                          "i > -1, i < 4",
                                          "0 \\le i, 3 \\ge i",
                                          "n = 3, i = 0..n",
                                          "n = 3..3, i = n-3..n",
                                          "n = 3..3, i = 0, \\dots, n",
                                          "n = 3..3, 0 \\le i < n+1",
                                          "n = 3..3, n-4 < i < 2n-2",
                                          "i \\in \\mathbb{N}, i \\le 3"};
    for (size_t k = 0; k < sizeof spelled / sizeof *spelled; k++)
        for (int number = -1; number <= 4; number++) {
            char text[80];
            cagd_finding found;
            int fails = number >= 0 && number <= 3;
            cagd_reading_error error;
            let((const char *const[]){"x_i \\in \\mathbb{R}", NULL});
            if (!cagd_read_ranges(&scope, spelled[k], 0, (int)strlen(spelled[k]), &error))
                fail_msg("%s: %s", spelled[k], error.message);
            snprintf(text, sizeof text, "(i - (%d)) (x_i^2 + 1) \\ne 0", number);
            const cagd_tree *t = statement_of(text);
            assert_non_null(t);
            assert_true(cagd_make_indices_whole(&scope, t, &error));
            cagd_check(&scope, t, 20, &found);
            if (found.answer != (fails ? CAGD_FAILS : CAGD_HOLDS) || found.cases != 4 || found.failing != fails)
                fail_msg("%s, %d: answer %d, %ld of %ld cases fail", spelled[k], number, (int)found.answer,
                         found.failing, found.cases);
            int told = !fails;
            for (int m = 0; m < found.given; m++)
                told |=
                    strcmp(found.example[m].name, "i") == 0 && cagd_equal_q(found.example[m].value, from_int_q(number));
            assert_true(told);
            region_faults = 0;
            field_close();
        }
}

/* Numbers that are ordered and near to one another: an equality of their differences is refuted, whatever is true at the point of the cell that is
 * found first. */
static void what_is_false_near_a_point(void **state)
{
    (void)state;
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 5; k++)
            for (int times = 1; times <= 3 && i != k; times++) {
                char text[80];
                cagd_finding found;
                let((const char *const[]){"x_i \\in \\mathbb{R}", "*x_i < x_{i+1}, x_5 < x_0 + \\frac{1}{100}", NULL});
                snprintf(text, sizeof text, "x_%d - x_%d = %d (x_%d - x_%d)", i + 1, i, times, k + 1, k);
                const cagd_tree *t = statement_of(text);
                assert_non_null(t);
                cagd_check(&scope, t, 60, &found);
                if (found.answer != CAGD_FAILS)
                    fail_msg("%s: answer %d", text, (int)found.answer);
                region_faults = 0;
                field_close();
            }
}

/* Statements of which every part is needed, and the same with one part less, or another one: the first, the last and those between, both directions, both sides, bounds that
 * are met and bounds that are not. */
static void every_part_counts(void **state)
{
    (void)state;
    static const char numbers[] = "x, y, u, v, x_i \\in \\mathbb{R}";
    static const struct {
        const char *lines[4], *holds[8], *fails[8];
    } list[] = {
        /* what is never 0, above it, below it, and on either side */
        {{numbers},
         {"x^2 + 1 \\ne 0", "-x^2 - 1 \\ne 0", "x^2 + y^2 \\ne -1", "-x^2 - y^2 - u^2 \\ne 1"},
         {"x \\ne 0", "x^2 \\ne 1", "-x^2 \\ne 0", "x y \\ne 1"}},
        {{numbers, "*x_i < x_{i+1}"},
         {"x_0 \\ne x_1", "x_1 \\ne x_0", "x_0 \\ne x_2", "x_2 > x_0", "x_0 < x_1 < x_2 < x_3"},
         {"x_0 > x_1", "x_2 - x_1 \\ne x_1 - x_0", "x_0 < x_1 < x_2 < x_1"}},
        {{numbers, "*x_i \\le x_{i+1}"},
         {"x_0 \\le x_3", "x_3 \\ge x_0"},
         {"x_0 < x_3", "x_0 \\ne x_1", "x_0 \\ge x_1"}},
        {{numbers, "*x \\le y \\le u \\le v"},
         {"x \\le y", "y \\le u", "u \\le v", "x \\le v", "x + y \\le u + v"},
         {"x < v", "v \\le x", "x + v \\le y + u"}},
        {{numbers, "*x = y = u"}, {"x = y", "y = u", "u = x"}, {"x = v", "u = 1"}},
        {{numbers, "*x \\ge 1, y \\ge 1, u \\ge 1"},
         {"x y u \\ge 1", "x + y + u \\ge 3", "u \\ge 1"},
         {"x y v \\ge 1", "x + y + u > 3", "v \\ge 1"}},
        {{numbers, "*0 \\le x \\le 1, 0 < y < 1"},
         {"x (1-x) \\ge 0", "y (1-y) > 0", "x y < 1", "x + y > 0", "x + y < 2"},
         {"x (1-x) > 0", "x y > 0", "x \\ge y", "y \\ge \\frac12"}},
        {{numbers, "*-1 \\le x < 1"}, {"1 - x > 0", "1 + x \\ge 0", "x^2 \\le 1"}, {"1 + x > 0", "x^2 < 1"}},
        {{numbers, "*-1 < x \\le 1"}, {"1 + x > 0", "1 - x \\ge 0", "x^3 > -1"}, {"1 - x > 0", "x^2 < 1"}},
        {{numbers, "*x \\le 0"},
         {"-x \\ge 0", "x^3 \\le 0", "|x| = -x", "\\max(x, 0) = 0", "\\min(x, 0) = x"},
         {"x < 0", "|x| = x", "|x| > 0"}},
        {{numbers, "*0 \\le x, y, u \\le 1"},
         {"x y u \\le 1", "x + y + u \\le 3", "(1-x)(1-y)(1-u) \\ge 0"},
         {"x + y + u \\le 2", "(1-x)(1-y)(1-u) > 0", "x + y + v \\le 3"}},
        /* connectives */
        {{numbers},
         {"x > 0, y > 0, u > 0 \\Rightarrow x y u > 0", "x > 0 \\Rightarrow x \\ge 0", "x > 1 \\Rightarrow x^2 > x",
          "x = 1 \\Rightarrow (y = 2 \\Rightarrow x + y = 3)"},
         {"x > 0, y > 0 \\Rightarrow x y u > 0", "x > 0, u > 0 \\Rightarrow x y u > 0",
          "y > 0, u > 0 \\Rightarrow x y u > 0", "x \\ge 0 \\Rightarrow x > 0", "x \\ge 1 \\Rightarrow x^2 > x"}},
        {{numbers},
         {"x < 0 \\lor x = 0 \\lor x > 0", "x \\le 0 \\lor x > 0", "\\neg(x < 0) \\lor x < 1",
          "\\neg(x > 0 \\iff x \\le 0)", "x y = 0 \\iff x = 0 \\lor y = 0"},
         {"x < 0 \\lor x > 0", "x < 0 \\lor x = 0", "x = 0 \\lor x > 0", "\\neg(x > 0 \\iff y > 0)",
          "x y = 0 \\iff x = 0", "x y = 0 \\iff y = 0", "\\neg(x > 0)"}},
        {{numbers},
         {"x > 0 \\iff -x < 0", "x^2 = 1 \\iff x = 1 \\lor x = -1", "x = y \\iff x - y = 0"},
         {"x^2 = 1 \\iff x = 1", "x = 1 \\iff x^2 = 1", "x > 0 \\iff x^2 > 0", "x \\ge 0 \\iff x > 0"}},
        /* the greatest and the least of several, and amounts */
        {{numbers},
         {"\\max(x, y, u) \\ge x", "\\max(x, y, u) \\ge y", "\\max(x, y, u) \\ge u", "\\min(x, y, u) \\le u",
          "\\max(x, y) + \\min(x, y) = x + y", "\\min(x, y) = -\\max(-x, -y)"},
         {"\\max(x, y, u) > x", "\\max(x, y, u) > u", "\\min(x, y, u) < y", "\\max(x, y) = x", "\\min(x, y) = y",
          "\\max(x, y, u) = \\max(x, y)"}},
        {{numbers},
         {"\\max(x, y) < u \\Rightarrow x < u", "\\max(x, y) < u \\Rightarrow y < u",
          "x < u, y < u \\Rightarrow \\max(x, y) < u", "\\min(x, y) > u \\Rightarrow y > u",
          "x \\ge u, y \\ge u \\Rightarrow \\min(x, y) \\ge u"},
         {"x < u \\Rightarrow \\max(x, y) < u", "y < u \\Rightarrow \\max(x, y) < u",
          "\\max(x, y) > u \\Rightarrow x > u", "\\min(x, y) < u \\Rightarrow x < u",
          "x \\ge u \\Rightarrow \\min(x, y) \\ge u"}},
        {{numbers},
         {"|x| < 1 \\iff -1 < x < 1", "|x| \\ge 1 \\iff x \\le -1 \\lor x \\ge 1", "|x| = 0 \\iff x = 0",
          "|x y| = |x| |y|", "|x + y| \\le |x| + |y|", "|x| \\ne -1"},
         {"|x| < 1 \\iff x < 1", "|x| < 1 \\iff x > -1", "|x| \\ge 1 \\iff x \\ge 1", "|x + y| < |x| + |y|",
          "|x + y| = |x| + |y|", "|x| \\ne 1"}},
        {{numbers},
         {"\\sqrt{x^2+1} > x", "\\sqrt{x^2+1} > -x", "\\sqrt{x^2+1} \\ge 1", "\\sqrt{x^2+1} \\ne x",
          "x < \\sqrt{x^2+1}", "\\sqrt{x^2+y^2} \\le |x| + |y|"},
         {"\\sqrt{x^2+1} \\ne 1", "\\sqrt{x^2+1} > 1", "\\sqrt{x^2+1} \\le x + 1", "\\sqrt{x^2+y^2} = |x| + |y|",
          "\\sqrt{x^2+4} \\ge 3"}},
        /* quantifiers over one number, over none, and over several, of which the first or the last breaks it */
        {{numbers},
         {"\\forall k \\in \\{2\\}: k = 2", "\\forall k \\in \\{0, \\dots, 3\\}: k^2 \\le 9",
          "\\exists k \\in \\{0, \\dots, 3\\}: k^2 = 9", "\\exists k \\in \\{0, \\dots, 3\\}: k = 0",
          "\\forall k \\in \\{0, 3, 5\\}: k \\ne 4"},
         {"\\forall k \\in \\{0, \\dots, 3\\}: k^2 < 9", "\\forall k \\in \\{0, \\dots, 3\\}: k > 0",
          "\\exists k \\in \\{0, \\dots, 3\\}: k = 4", "\\exists k \\in \\{0, 3, 5\\}: k = 4",
          "\\forall k \\in \\{0, 3, 5\\}: k < 5", "\\forall k \\in \\{0, 3, 5\\}: k > 0"}},
        {{numbers, "*n = 0..3"},
         {"n (n-1) (n-2) (n-3) = 0", "0 \\le n \\le 3", "\\exists k \\in \\{0, \\dots, n\\}: k = n"},
         {"n (n-1) (n-2) = 0", "(n-1) (n-2) (n-3) = 0", "n < 3", "n > 0"}},
        {{numbers, "*n = 1..2, m = 0..n"},
         {"m \\le n", "m (m-1) (m-2) = 0"},
         {"m < n", "m (m-1) = 0", "(m-1) (m-2) = 0", "m + n < 4", "m + n > 1"}},
        {{numbers, "*n = 1, 4, 6"},
         {"(n-1) (n-4) (n-6) = 0"},
         {"(n-1) (n-4) = 0", "(n-4) (n-6) = 0", "(n-1) (n-6) = 0"}},
        {{numbers, "*n = 2, 4, \\dots, 8"},
         {"(n-2) (n-4) (n-6) (n-8) = 0", "\\lfloor n/2 \\rfloor = n/2"},
         {"(n-2) (n-4) (n-6) = 0", "(n-4) (n-6) (n-8) = 0", "n \\ne 6"}},
        {{numbers, "*i = 1..1, j = 1..1, k = 1..1, l = 1..1, m = 1..1, n = 1..1, p = 1..1, r = 1..1"},
         {"i + j + k + l + m + n + p + r = 8"},
         {"i + j + k + l + m + n + p + r = 7"}},
        /* conditions that are known in parts of what x is, under quantifiers */
        {{numbers},
         {"\\forall k \\in \\{1, \\dots, 2\\}: (x > 1 \\land x < 0 \\Rightarrow k = 0)",
          "\\forall k \\in \\{1, \\dots, 2\\}: (k = 0 \\iff (x > 1 \\land x < 0))",
          "\\forall k \\in \\{1, \\dots, 2\\}: ((x > 1 \\land x < 0) \\iff k = 0)",
          "\\forall k \\in \\{1, \\dots, 2\\}: \\neg(x > k \\land x < 0)",
          "\\exists k \\in \\{1, \\dots, 2\\}: (x > k \\lor x \\le 1)",
          "\\forall k \\in \\{0, \\dots, 2\\}: (x > k \\lor x < 3)",
          "\\forall k \\in \\{1, \\dots, 2\\}: (x > 2 \\Rightarrow x > k)"},
         {"\\forall k \\in \\{1, \\dots, 2\\}: (x > 1 \\Rightarrow x > k)",
          "\\forall k \\in \\{1, \\dots, 2\\}: (x > 2 \\iff x > k)",
          "\\exists k \\in \\{1, \\dots, 2\\}: (x > k \\lor x \\le 0)",
          "\\forall k \\in \\{1, \\dots, 2\\}: \\neg(x > k \\land x < 2)",
          "\\forall k \\in \\{1, \\dots, 2\\}: (x < k \\lor x < 0)"}},
        {{numbers},
         {"\\max(x, \\min(y, u)) = \\min(\\max(x, y), \\max(x, u))", "|\\max(x, y) - \\min(x, y)| = |x - y|"},
         {"\\max(x, \\min(y, u)) = \\min(\\max(x, y), u)", "|\\max(x, y) - \\min(x, y)| = x - y"}},
        /* chains and lists of relations: each link, each part */
        {{numbers},
         {"x^2 \\ge 0 = 0 \\cdot x", "-x^2 \\le 0 \\le x^2 \\le x^2 + 1", "(x+y)^2 = x^2 + 2 x y + y^2 = (y+x)^2"},
         {"-x^2 \\le 0 \\le x^2 \\le x^2 - 1", "-x^2 \\le 0 < x^2 \\le x^2 + 1", "-x^2 < 0 \\le x^2",
          "(x+y)^2 = x^2 + y^2 = (y+x)^2", "(x+y)^2 = x^2 + 2 x y + y^2 = (y-x)^2"}},
        {{numbers},
         {"x + x = 2 x \\land y + y = 2 y \\land u + u = 2 u"},
         {"x + x = x \\land y + y = 2 y \\land u + u = 2 u", "x + x = 2 x \\land y + y = y \\land u + u = 2 u",
          "x + x = 2 x \\land y + y = 2 y \\land u + u = u"}},
        /* roots of numbers, whatever squares are in them */
        {{numbers},
         {"\\sqrt{50} = 5 \\sqrt{2}", "\\sqrt{32} = 4 \\sqrt{2}", "\\sqrt{\\frac{1}{2}} = \\frac{\\sqrt{2}}{2}",
          "\\sqrt{2} \\sqrt{3} = \\sqrt{6}", "\\sqrt{98} + \\sqrt{8} = 9 \\sqrt{2}", "1 < \\sqrt{2} < \\frac32"},
         {"\\sqrt{50} = 2 \\sqrt{5}", "\\sqrt{32} = 2 \\sqrt{2}", "\\sqrt{2} + \\sqrt{3} = \\sqrt{5}",
          "\\sqrt{2} \\ge \\frac32", "\\sqrt{3} \\le \\sqrt{2}"}},
        {{numbers},
         {"\\pi > \\frac{314}{100}", "\\pi < \\frac{315}{100}", "3 < \\pi < 4"},
         {"\\pi > \\frac{315}{100}", "\\pi < \\frac{314}{100}"}},
        /* pieces: at their joint, above and below it */
        {{numbers, "f(x) = \\begin{cases} x^2 & x \\ge 0 \\\\ -x^2 & x < 0 \\end{cases}"},
         {"f(0) = 0", "f'(0) = 0", "f(-x) = -f(x)", "f'(x) = 2 |x|", "f(x) x \\ge 0"},
         {"f(x) \\ge 0", "f(x) \\le 0", "f'(x) = 2 x", "f'(x) = -2 x"}},
        {{numbers, "g(x) = \\begin{cases} 1 & x > 1 \\\\ 2 & x = 1 \\\\ 3 & x < 1 \\end{cases}"},
         {"g(1) = 2", "g(2) = 1", "g(0) = 3", "1 \\le g(x) \\le 3"},
         {"g(x) < 3", "g(x) > 1", "g(x) \\ne 2"}},
        /* sums of squares, and what touches 0 */
        {{numbers},
         {"x^2 - 2 x y + y^2 \\ge 0", "x^2 + y^2 + u^2 \\ge x y + y u + u x", "x^4 - 2 x^2 + 1 \\ge 0"},
         {"x^2 - 2 x y + y^2 > 0", "x^2 - 3 x y + y^2 \\ge 0", "x^4 - 2 x^2 + 1 > 0", "x^4 - 3 x^2 + 1 \\ge 0"}},
        /* angles */
        {{"\\alpha, \\beta \\in \\mathbb{R}"},
         {"\\cos^2 \\alpha + \\sin^2 \\alpha = 1",
          "\\cos(\\alpha - \\beta) = \\cos \\alpha \\cos \\beta + \\sin \\alpha \\sin \\beta",
          "\\sin(\\alpha + \\pi) = -\\sin \\alpha", "\\cos \\frac{5\\pi}{12} > \\frac14", "\\cos \\alpha \\ge -1",
          "\\sin(-\\alpha) = -\\sin \\alpha", "2 \\cos^2 \\frac{\\alpha}{2} = 1 + \\cos \\alpha"},
         {"\\cos(\\alpha + \\beta) = \\cos \\alpha \\cos \\beta + \\sin \\alpha \\sin \\beta",
          "\\sin(\\pi \\cdot \\pi) = 0", "\\sin(\\alpha + \\pi) = \\sin \\alpha", "\\cos \\alpha > -1",
          "\\sin \\alpha < 1", "\\cos \\frac{5\\pi}{12} > \\frac13", "\\cos(-\\alpha) = -\\cos \\alpha"}},
        {{"\\alpha \\in \\mathbb{R}", "\\beta = \\frac{\\alpha}{2}"},
         {"2 \\cos^2 \\beta = 1 + \\cos \\alpha", "\\sin \\alpha = 2 \\sin \\beta \\cos \\beta"},
         {"2 \\cos^2 \\beta = 1 - \\cos \\alpha", "\\sin \\alpha = \\sin \\beta \\cos \\beta"}},
    };
    int seen[2] = {0};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        for (int m = 0; m < 16; m++) {
            const char *text = m < 8 ? list[k].holds[m] : list[k].fails[m - 8];
            if (text == NULL)
                continue;
            cagd_finding found;
            let(list[k].lines);
            const cagd_tree *t = statement_of(text);
            if (t == NULL)
                fail_msg("%s is not read", text);
            cagd_check(&scope, t, 20, &found);
            if (found.answer != (m < 8 ? CAGD_HOLDS : CAGD_FAILS))
                fail_msg("%s, %s: answer %d, %s", list[k].lines[1] != NULL ? list[k].lines[1] : "", text,
                         (int)found.answer, found.why != NULL ? found.why : "");
            seen[m < 8]++;
            region_faults = 0;
            field_close();
        }
    assert_true(seen[0] > 100 && seen[1] > 100);
}

static int cases_taken;
static int take(void *data, const char *inputs, const char *nodes, const char *steps)
{
    (void)data, (void)inputs, (void)nodes, (void)steps;
    cases_taken++;
    return 1;
}

/* An identity is certified where it stands for itself: not where a name is a function of others, which no certificate says. */
static void what_is_certified_stands_for_itself(void **state)
{
    (void)state;
    static const struct {
        const char *lines[4], *statement;
        int certified;
    } list[] = {
        {{"x, y \\in \\mathbb{R}"}, "(x + y)^2 = x^2 + 2 x y + y^2", 1},
        {{"x, y \\in \\mathbb{R}", "*x + y = 1"}, "x^2 - y^2 = x - y", 0},
        {{"*n = 1..3", "x \\in \\mathbb{R}"}, "\\sum_{k=0}^n \\binom{n}{k} x^k = (1+x)^n", 1},
    };
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        cagd_finding found;
        let(list[k].lines);
        const cagd_tree *t = statement_of(list[k].statement);
        assert_non_null(t);
        cagd_check(&scope, t, 20, &found);
        if (found.answer != CAGD_HOLDS)
            fail_msg("%s: answer %d", list[k].statement, (int)found.answer);
        cases_taken = 0;
        if (cagd_certify(&scope, t, &found, 20, take, NULL) != list[k].certified ||
            (list[k].certified && cases_taken != found.cases))
            fail_msg("%s: %d cases of %ld", list[k].statement, cases_taken, found.cases);
        region_faults = 0;
        field_close();
    }
}

/* In a chain "\dots" stands between equal relations, or before the first. */
static void dots_in_chains(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int is_read;
    } list[] = {{"x = \\dots = y", 1},          {"x < \\dots < y", 1},     {"x \\le \\dots \\le y", 1},
                {"\\dots = x = y", 1},          {"x = \\dots < y", 0},     {"x < \\dots = y", 0},
                {"x < \\dots \\le y", 0},       {"x \\le \\dots < y", 0},  {"x = \\dots y", 0},
                {"x = y = \\dots = 1", 1},      {"x < y = \\dots = 1", 1}, {"x = y < \\dots = 1", 0},
                {"x = \\dots = \\dots = y", 0}, {"x = y = \\dots", 0}};
    let((const char *const[]){"x, y \\in \\mathbb{R}", NULL});
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        if ((statement_of(list[k].text) != NULL) != list[k].is_read)
            fail_msg("%s is%s read", list[k].text, list[k].is_read ? " not" : "");
}

/* Powers of five bases, of which one begins with its exponent 0, beside names in another order. */
static void powers_of_many_bases(void **state)
{
    (void)state;
    static const char *const sums[] = {"\\sum_{k=0}^{n-2} w_k (a b c d)^{k+2} x^k",
                                       "\\sum_{k=0}^{n-2} w_k (a b c d)^{k+2} x^{k+1}"};
    for (int k = 0; k < 2; k++) {
        char text[300];
        cagd_finding found;
        let((const char *const[]){"a, b, c, d, x, w_i \\in \\mathbb{R}", "*n = 4..6", NULL});
        snprintf(text, sizeof text,
                 "w_0 a^2 b^2 c^2 d^2 + w_1 a^3 b^3 c^3 d^3 x + x^2 w_2 a^4 b^4 c^4 d^4 + \\dots + w_{n-2} a^n b^n c^n "
                 "d^n x^{n-2} = %s",
                 sums[k]);
        const cagd_tree *t = statement_of(text);
        assert_non_null(t);
        cagd_check(&scope, t, 20, &found);
        assert_int_equal(found.answer, k == 0 ? CAGD_HOLDS : CAGD_FAILS);
        region_faults = 0;
        field_close();
    }
}

/* A name that is bound again has nothing of what was known of it before. */
static void names_are_bound_again(void **state)
{
    (void)state;
    static cagd_context c;
    c = (cagd_context){.scope = &scope};
    for (int again = 0; again < 2; again++) {
        cagd_binding *b = cagd_bind(&c, "x", cagd_value_int(3 + again));
        assert_non_null(b);
        assert_int_equal(c.count, 1);
        assert_string_equal(b->key, "x");
        assert_true(b->value.rational && cagd_equal_q(b->value.q, from_int_q(3 + again)));
        assert_false(b->unknown || b->solved || b->has_low || b->has_high || b->low_open || b->high_open);
        assert_null(b->variable);
        b->unknown = b->solved = b->has_low = b->has_high = b->low_open = b->high_open = 1;
    }
}

/* Functions of t in [-2,2] and c in [-2,2]; of the last but one the derivative by c is 1 + u^2 c^2 (u^2 + c^2 - 3) with u^2 = 2 t^2,
 * which is not below 0, and no sum of squares; of the last it is the same less 1. */
static void monotony(void **state)
{
    (void)state;
    static const struct {
        const char *function;
        cagd_monotony is;
    } list[] = {{"t^2", CAGD_CONSTANT},
                {"c", CAGD_INCREASING},
                {"t - c^3", CAGD_DECREASING},
                {"(t + 2) c", CAGD_INCREASING},
                {"t c", CAGD_NOT_MONOTONE},
                {"c^2", CAGD_NOT_MONOTONE},
                {"\\frac{c}{5 + c}", CAGD_INCREASING},
                {"c + \\frac{4 t^4 c^3}{3} + \\frac{2 t^2 c^5}{5} - 2 t^2 c^3", CAGD_INCREASING},
                {"-c - \\frac{4 t^4 c^3}{3} - \\frac{2 t^2 c^5}{5} + 2 t^2 c^3", CAGD_DECREASING},
                {"\\frac{4 t^4 c^3}{3} + \\frac{2 t^2 c^5}{5} - 2 t^2 c^3", CAGD_NOT_MONOTONE}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        char line[200];
        static cagd_basis b;
        cagd_reading_error error;
        snprintf(line, sizeof line, "b_i(t) = %s", list[k].function);
        let((const char *const[]){"-2 \\le c \\le 2", line, "*i = 0..0, -2 \\le t \\le 2", NULL});
        const cagd_tree *f = cagd_read_value(&scope, "b_i(t)", 0, 6, &error);
        if (f == NULL)
            fail_msg("%s", error.message);
        const char *why = cagd_basis_read(&scope, f, "i", 0, 0, "c", &b);
        if (why != NULL)
            fail_msg("%s: %s", list[k].function, why);
        if (cagd_basis_monotony(&b, 0) != list[k].is)
            fail_msg("%s: %d", list[k].function, (int)cagd_basis_monotony(&b, 0));
        region_faults = 0;
        field_close();
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(ranges_begin_where_they_say),
                                       unit(lists_of_implications),
                                       unit(ranges_have_the_numbers_they_say),
                                       unit(what_is_false_near_a_point),
                                       unit(every_part_counts),
                                       unit(what_is_certified_stands_for_itself),
                                       unit(dots_in_chains),
                                       unit(powers_of_many_bases),
                                       unit(names_are_bound_again),
                                       unit(monotony)};
    return run_unit_tests(tests);
}
