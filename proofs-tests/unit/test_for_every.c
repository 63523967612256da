/* test_for_every.c -- what is proved for every n: of many functions of n, of which no two are equal, each is proved to be itself in other words and
 * none to be another; and so are sums and what they are.  What is wrong is multiplied by (n-1) ... (n-8), so that the first cases hold, as is
 * taken for granted, and the fault has to be seen in the proof. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/expression/check.h"
#include "exact/expression/every.h"
#include "exact/expression/read.h"

#include <stdio.h>
#include <string.h>

static cagd_scope scope;

static void begin(void)
{
    cagd_reading_error error;
    static const char *const line[] = {"x, y \\in \\mathbb{R}", "H_m = \\sum_{j=1}^m \\frac{1}{j}"};
    scope = (cagd_scope){0};
    field_open(24);
    for (int k = 0; k < 2; k++)
        assert_true(cagd_read_definition(&scope, line[k], 0, (int)strlen(line[k]), &error));
    static const char range[] = "n \\ge 1, n \\in \\mathbb{N}";
    assert_true(cagd_read_ranges(&scope, range, 0, (int)strlen(range), &error));
}

/* Whether it is proved, from n = 1 on. */
static int is_proved(const char *text)
{
    cagd_reading_error error;
    region_mark mark = region_open();
    begin();
    const cagd_tree *t = cagd_read_statement(&scope, text, 0, (int)strlen(text), &error);
    if (t == NULL)
        fail_msg("%s: %s", text, error.message);
    cagd_every *found = region_bytes(sizeof *found);
    assert_non_null(found);
    int is = cagd_holds_for_every(&scope, t, cagd_declared(&scope, "n"), 1, 8, found);
    region_faults = 0;
    field_close();
    region_drop(mark);
    return is;
}

#define FIRST "(n-1)(n-2)(n-3)(n-4)(n-5)(n-6)(n-7)(n-8)"
/* The same for another side: both are 0 for the first numbers. */
static int is_proved_equal(const char *left, const char *right, int same)
{
    char text[600];
    snprintf(text, sizeof text, same ? "%s = %s" : FIRST " (%s) = " FIRST " (%s)", left, right);
    int is = is_proved(text);
    if (is && !same)
        fail_msg("%s is proved", text);
    return is;
}

/* Functions of n, those that are no closed forms among them: each is another one. */
static const char *const function[] = {"n",
                                       "n+1",
                                       "2n",
                                       "n^2",
                                       "n^3",
                                       "\\frac{n(n+1)}{2}",
                                       "2^n",
                                       "2^{n+1}",
                                       "2^{2n}",
                                       "3^n",
                                       "(-1)^n",
                                       "(-2)^n",
                                       "x^n",
                                       "x^{n+1}",
                                       "x^{2n}",
                                       "x^{-n}",
                                       "(xy)^n",
                                       "(x+1)^n",
                                       "x^{n^2}",
                                       "n^n",
                                       "n 2^n",
                                       "n!",
                                       "(n+1)!",
                                       "(n-1)!",
                                       "(2n)!",
                                       "(2n+1)!",
                                       "(n!)^2",
                                       "\\frac{1}{n!}",
                                       "(n^2)!",
                                       "(3n)!",
                                       "\\frac{n!}{n+1}",
                                       "\\binom{2n}{n}",
                                       "\\binom{2n}{n-1}",
                                       "\\binom{n}{2}",
                                       "\\binom{n+1}{3}",
                                       "\\binom{x}{n}",
                                       "\\binom{n+x}{n}",
                                       "\\binom{n^2}{n}",
                                       "|n-50|",
                                       "\\max(n,50)",
                                       "\\lfloor \\frac{n}{2} \\rfloor",
                                       "H_n",
                                       "H_{2n}",
                                       "H_{n+1}",
                                       "H_n^2",
                                       "n H_n",
                                       "\\sum_{k=1}^n k^n",
                                       "\\sum_{k=1}^n \\frac{1}{k^2}",
                                       "\\sum_{k=0}^{n^2} x^k",
                                       "\\prod_{k=1}^n (x+k)",
                                       "\\prod_{k=0}^n (x+k)",
                                       "\\prod_{k=1}^n (x-k)",
                                       "\\prod_{k=1}^{2n} (x+k)",
                                       "\\prod_{k=1}^n (x+k^2)",
                                       "\\sum_{k=1}^n 2^k",
                                       "\\sum_{k=0}^n \\binom{n}{k} k",
                                       "\\sum_{k=0}^n \\binom{n}{k}^2 x^k",
                                       "0",
                                       "1",
                                       "x"};

static void no_function_is_another(void **state)
{
    (void)state;
    enum { COUNT = sizeof function / sizeof *function };
    int themselves = 0;
    for (int i = 0; i < COUNT; i++)
        for (int k = 0; k < COUNT; k++) {
            char again[200];
            if (i != k && (i * 7 + k * 3) % 4 != 0) /* a quarter of all pairs */
                continue;
            snprintf(again, sizeof again, "2 (%s) - (%s)", function[k], function[k]);
            themselves += is_proved_equal(function[i], i == k ? again : function[k], i == k);
        }
    assert_int_equal(themselves, 47);
}

/* Terms, the end and the begin of the sum, and what that is: each with its own, none with another's. */
static const struct {
    const char *term, *is;
    int from;
} sum[] = {{"\\binom{n}{k}", "2^n", 0},
           {"k \\binom{n}{k}", "n 2^{n-1}", 0},
           {"\\binom{n}{k}^2", "\\binom{2n}{n}", 0},
           {"\\binom{n}{k} x^k", "(1+x)^n", 0},
           {"\\binom{n}{k} x^k y^{n-k}", "(x+y)^n", 0},
           {"(-1)^k \\binom{n}{k}", "0", 0},
           {"k", "\\frac{n(n+1)}{2}", 1},
           {"k^2", "\\frac{n(n+1)(2n+1)}{6}", 1},
           {"k^3", "\\frac{n^2(n+1)^2}{4}", 1},
           {"x^k", "\\frac{x^{n+1}-1}{x-1}", 0},
           {"k k!", "(n+1)! - 1", 1},
           {"\\frac{1}{k(k+1)}", "\\frac{n}{n+1}", 1},
           {"2k-1", "n^2", 1},
           {"2^k", "2^{n+1} - 2", 1},
           {"k 2^k", "(n-1) 2^{n+1} + 2", 1},
           {"(-1)^k \\binom{n}{k} \\frac{x}{x+k}", "\\frac{n!}{\\prod_{j=1}^n (x+j)}", 0},
           {"H_k", "(n+1) H_n - n", 1},
           {"\\binom{n+k}{k} 2^{-k}", "2^n", 0},
           {"\\binom{k}{2}", "\\binom{n+1}{3}", 1},
           {"1", "n + 1", 0},
           {"\\frac{\\binom{n}{k}}{k+1}", "\\frac{2^{n+1}-1}{n+1}", 0},
           {"k^2 \\binom{n}{k}", "n(n+1) 2^{n-2}", 0},
           {"(-1)^k \\binom{n}{k} \\frac{1}{k+1}", "\\frac{1}{n+1}", 0}};

static void no_sum_is_another(void **state)
{
    (void)state;
    enum { COUNT = sizeof sum / sizeof *sum };
    int proved = 0;
    for (int i = 0; i < COUNT; i++)
        for (int k = 0; k < COUNT; k++)
            for (int turned = 0; turned <= (i == k); turned++) {
                char left[150];
                int same = strcmp(sum[i].is, sum[k].is) == 0;
                snprintf(left, sizeof left, "\\sum_{k=%d}^n (%s)", sum[i].from, sum[i].term);
                if (!same && (i + 5 * k) % 3 != 0)
                    continue;
                proved += is_proved_equal(turned ? sum[k].is : left, turned ? left : sum[k].is, same);
            }
    assert_int_equal(proved, 46); /* all but the one whose right side has two terms, either way round */
}

/* From and to where: a term more or less at either end is another sum. */
static void every_end_counts(void **state)
{
    (void)state;
    int proved = 0;
    static const char *const ends[][2] = {{"0", "n"},   {"1", "n"},   {"2", "n"}, {"0", "n-1"},
                                          {"0", "n+1"}, {"1", "n+1"}, {"-1", "n"}};
    static const struct {
        const char *term, *is; /* the sum from 0 to n */
    } list[] = {{"\\binom{n}{k}", "2^n"}, {"x^k", "\\frac{x^{n+1}-1}{x-1}"}, {"k+3", "\\frac{(n+1)(n+6)}{2}"}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++)
        for (size_t k = 0; k < sizeof ends / sizeof *ends; k++) {
            char left[200];
            snprintf(left, sizeof left, "\\sum_{k=%s}^{%s} (%s)", ends[k][0], ends[k][1], list[i].term);
            int same = k == 0 || (i == 0 && (k == 4 || k == 6)); /* C(n,-1) = C(n,n+1) = 0 */
            proved += is_proved_equal(left, list[i].is, same);
        }
    assert_int_equal(proved, 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(no_function_is_another), unit(no_sum_is_another), unit(every_end_counts)};
    return run_unit_tests(tests);
}
