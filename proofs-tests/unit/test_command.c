/* test_command.c -- the commands that report, on registers made by hand: what they count, what they say, and their exit status.
 *
 * Whole outputs are compared with the files of the folder command-output; CAGD_WRITE_EXPECTED=1 writes these anew, to be read. */
#include "proofs-tests/unit/unit_exact.h"

#include "chapters/judge/certificate.h"
#include "chapters/judge/words.h"
#include "cli/commands.h"
#include "cli/digest.h"
#include "cli/junit.h"
#include "cli/report.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* ---- the registers ----------------------------------------------------------------------------------- */

static void square_f(trial *T)
{
    num_f x = unknown_f(T, "x", 0), w = positive_f(T, "w", 0);
    show_f(T, "x", x);
    same_f(T, mul_f(x, x), mul_f(x, fault(T, x, from_int_f(1))));
    nonnegative_f(T, w);
}
static void powers_f(trial *T)
{
    num_f x = unknown_f(T, "x", 0), p = x;
    for (int k = 1; k < T->degree; k++)
        p = mul_f(p, x);
    same_f(T, mul_f(p, x), mul_f(x, fault(T, p, x)));
    vanishes_f(T, sub_f(p, fault(T, p, x)));
}
/* What is proved in the field is certified there. */
static void powers_q(trial *T) { same_q(T, from_int_q(T->degree), from_int_q(fault(T, T->degree, 9))); }
static void variable_f_is_itself(trial *T)
{
    num_f x = unknown_f(T, "x", 0);
    same_f(T, x, fault(T, x, from_int_f(1)));
}
static void double_q(trial *T)
{
    num_q x = unknown_q(T, "x", 0);
    same_q(T, add_q(x, x), mul_q(from_int_q(fault(T, 2, 3)), x));
    if (T->deep)
        agree(T, 1);
}
static void double_i(trial *T)
{
    num_i x = unknown_i(T, "x", 0);
    same_i(T, add_i(x, x), mul_i(from_int_i(fault(T, 2, 3)), x));
}
static void double_m(trial *T)
{
    num_m x = div_m(unknown_m(T, "x", 0), from_int_m(7));
    same_m(T, add_m(mul_m(from_int_m(3), x), from_int_m(fault(T, 1, 2))),
           mul_m(from_int_m(3), add_m(x, from_ratio_m(1, 3))));
}
static void is_nine_q(trial *T)
{
    num_q x = given_q(T, "x");
    same_q(T, mul_q(x, x), from_int_q(fault(T, 9, 8)));
    num_q again = mul_q(x, from_int_q(1)); /* equal sums of different nodes */
    same_q(T, add_q(x, again), add_q(x, x));
}
static void is_four_q(trial *T)
{
    num_q x = given_q(T, "x");
    found_q(T, "x + 1", add_q(x, from_int_q(1)));
    about(T, "x and what is printed");
    same_q(T, x, from_int_q(fault(T, 3, 4)));
}
static void is_not_q(trial *T)
{
    num_q x = positive_q(T, "x", 1);
    about(T, "<&\">");
    same_q(T, x, add_q(x, from_int_q(1)));
}
static void is_unable_f(trial *T)
{
    num_f x = unknown_f(T, "x", 0);
    if (T->planted)
        same_f(T, x, from_int_f(1));
    else
        region_faults |= FAULT_UNABLE, agree(T, 1);
}

#define VALUES(...)                                                                                                    \
    (const char *const[]) { __VA_ARGS__ }
static const datum three[] = {
    {.name = "x", .text = "3", .rows = 1, .columns = 1, .value = VALUES("3")},
    {.name = "x + 1", .text = "4", .rows = 1, .columns = 1, .value = VALUES("4"), .place = IN_RESULT},
    {.name = NULL}};
/* Two results. */
static void is_four_twice_q(trial *T)
{
    found_q(T, "x + 2", add_q(given_q(T, "x"), from_int_q(2)));
    is_four_q(T);
}
static const datum two_results[] = {
    {.name = "x", .text = "3", .rows = 1, .columns = 1, .value = VALUES("3")},
    {.name = "x + 1", .text = "4", .rows = 1, .columns = 1, .value = VALUES("4"), .place = IN_RESULT},
    {.name = "x + 2", .text = "5", .rows = 1, .columns = 1, .value = VALUES("5"), .place = IN_RESULT},
    {.name = NULL}};
/* In a paragraph of 92 columns that begins in the seventh, the first is a line, and the second one column too long. */
static const datum in_one_line[] = {
    {.name = "x",
     .text = "3, as many as a triangle has sides, and one less than a square has",
     .rows = 1,
     .columns = 1,
     .value = VALUES("3")},
    {.name = "x + 1", .text = "4", .rows = 1, .columns = 1, .value = VALUES("4"), .place = IN_RESULT},
    {.name = NULL}};
static const datum in_two_lines[] = {
    {.name = "x",
     .text = "3, as many as a triangle has corners and one less than a square has",
     .rows = 1,
     .columns = 1,
     .value = VALUES("3")},
    {.name = "x + 1", .text = "4", .rows = 1, .columns = 1, .value = VALUES("4"), .place = IN_RESULT},
    {.name = NULL}};
static const datum only_three[] = {{.name = "x", .text = "3", .rows = 1, .columns = 1, .value = VALUES("3")},
                                   {.name = NULL}};
#define TEXTS(claim_name, in_file, at)                                                                                 \
    .name = claim_name, .title = "Title of " claim_name, .title_zh = "标题", .given = "numbers $x$", .let = "",        \
    .then = "$x = x$ in " claim_name, .method = "computed, as in [book]", .control = "another number", .scope = "",    \
    .over = "x#: points", .argued_for = "", .argued = "", .chapter = "first", .defines = "", .letter = "n",            \
    .file = "chapters/first/" in_file ".claims.h", .line = at
static claim claims[] = {
    {TEXTS("square_is_product", "one", 10), .body = {[FIELD_TYPE] = square_f}},
    {TEXTS("sum_is_double", "one", 20),
     .body = {[RATIONAL_TYPE] = double_q, [INTERVAL_TYPE] = double_i, [DOUBLE_TYPE] = double_m}},
    {TEXTS("sum_is_double_in_degrees", "one", 25), .degree_low = 1, .degree_high = 3, .degree_sampled = 9,
     .body = {[DOUBLE_TYPE] = double_m}},
    {TEXTS("powers_commute", "one", 28), .degree_low = 2, .degree_high = 4, .degree_sampled = 4,
     .body = {[FIELD_TYPE] = powers_f, [RATIONAL_TYPE] = powers_q}},
    {TEXTS("three_squared", "two", 30), .kind = DECISION, .body = {[RATIONAL_TYPE] = is_nine_q}, .data = only_three},
    {TEXTS("three_is_four", "two", 40), .kind = COUNTEREXAMPLE, .body = {[RATIONAL_TYPE] = is_four_q}, .data = three},
    {TEXTS("variable_is_itself", "two", 45), .kind = DECISION, .body = {[FIELD_TYPE] = variable_f_is_itself}},
    {TEXTS("one_is_two", "two", 50), .body = {[RATIONAL_TYPE] = is_not_q}},
    {TEXTS("nobody_knows", "two", 60), .body = {[FIELD_TYPE] = is_unable_f}},
    {.name = NULL}};
/* The first claims, which are as expected. */
enum { GOOD = 7 };

#define STATEMENT(of, in_source, at, its_class, correction, about, drawn)                                              \
    .id = in_source ":" of, .title = "Title of " of, .title_zh = "命题", .printed = "x = " of, .class = its_class,     \
    .corrected = correction, .figure = drawn, .example = "", .note = about, .letter = "n", .chapter = "first",         \
    .file = "chapters/first/one.claims.h", .line = at
#define LINKS(...)                                                                                                     \
    (const statement_link[])                                                                                           \
    {                                                                                                                  \
        __VA_ARGS__, { HOLDS_BY, NULL, NULL, NULL, NULL }                                                              \
    }
static const statement good_statements[] = {
    {STATEMENT("1", "book", 1, "", "", "As in [paper]", "picture"),
     .links = LINKS({HOLDS_BY, "square_is_product", NULL, "", NULL}, {HOLDS_BY, "three_squared", NULL, "", NULL},
                    {CONFIRMED_BY, "sum_is_double", NULL, "", NULL})},
    {STATEMENT("2", "book", 2, "misprint", "x = 3", "", ""), .striking = 1,
     .links = LINKS({REFUTED_BY, "three_is_four", NULL, "", NULL}, {CORRECTED_BY, "three_squared", NULL, "", NULL},
                    {ARGUED, NULL, "every n", "because", NULL})},
    {STATEMENT("3", "book", 3, "", "", "", ""), .links = LINKS({HOLDS_BY, "sum_is_double", NULL, "", NULL},
                                                               {HYPOTHESIS, "square_is_product", NULL, "$x = 0$", NULL},
                                                               {HYPOTHESIS, "three_is_four", NULL, "$x > 0$", NULL},
                                                               {NEEDS, "three_is_four", "page 7", "$y > 0$", NULL})},
    {STATEMENT("longer-than-others", "book", 9, "", "", "", ""), .is_definition = 1,
     .links = LINKS({HOLDS_BY, NULL, NULL, NULL, NULL})},
    {STATEMENT("4", "paper", 4, "", "", "", ""), .is_definition = 1,
     .links = LINKS({CHECKED_BY, "three_squared", NULL, "", NULL}, {CITES, NULL, "[book], 5", "a theorem", NULL})},
    {STATEMENT("5", "paper", 5, "", "", "", ""), .is_definition = 1,
     .links = LINKS({HOLDS_BY, NULL, NULL, NULL, NULL})},
    {STATEMENT("6", "paper", 6, "", "", "", ""),
     .links = LINKS({READING, "three_is_four", NULL, "one way", NULL},
                    {READING, "square_is_product", NULL, "another way", NULL})},
    {STATEMENT("7", "paper", 7, "", "", "", ""),
     .links = LINKS({HOLDS_BY, "sum_is_double", NULL, "", NULL}, {READING, "three_is_four", NULL, "one way", NULL},
                    {CONFIRMED_BY, "sum_is_double", NULL, "", NULL}, {MEANT, NULL, "page 8", "the other", NULL})},
    {STATEMENT("8", "paper", 8, "false", "", "", ""), .striking = 2,
     .links = LINKS({REFUTED_BY, "three_is_four", NULL, "", NULL})},
    {.id = NULL}};
static const statement bad_statements[] = {
    {STATEMENT("1", "book", 1, "", "", "", ""), .links = LINKS({HOLDS_BY, "square_is_product", NULL, "", NULL})},
    {STATEMENT("2", "book", 2, "", "", "", ""), .links = LINKS({HOLDS_BY, "one_is_two", NULL, "", NULL})},
    {STATEMENT("3", "book", 3, "", "", "", ""), .links = LINKS({HOLDS_BY, "nobody_knows", NULL, "", NULL})},
    {.id = NULL}};
/* All claims do what they should, and a statement does not follow from them. */
static const statement lost_statements[] = {
    {STATEMENT("1", "book", 1, "", "", "", ""), .links = LINKS({HOLDS_BY, "square_is_product", NULL, "", NULL})},
    {STATEMENT("2", "book", 2, "", "", "", ""),
     .links = LINKS({HOLDS_BY, "square_is_product", NULL, "", NULL}, {HOLDS_BY, "missing", NULL, "", NULL})},
    {.id = NULL}};
/* A claim in intervals alone; one whose control is not caught; one reading that words argue for; a class where nothing fails. */
static void never_caught_q(trial *T) { agree(T, 1); }
static void is_five_q(trial *T)
{
    num_q x = given_q(T, "x"), y = given_q(T, "y");
    found_q(T, "x + y", add_q(x, y));
    found_q(T, "x - y", sub_q(x, y));
    same_q(T, x, from_int_q(fault(T, 3, 5)));
}
static const datum two_data[] = {
    {.name = "x", .text = "3", .rows = 1, .columns = 1, .value = VALUES("3")},
    {.name = "y", .text = "1/2", .rows = 1, .columns = 1, .value = VALUES("1/2")},
    {.name = "x + y", .text = "7/2", .rows = 1, .columns = 1, .value = VALUES("7/2"), .place = IN_RESULT},
    {.name = "x - y", .text = "5/2", .rows = 1, .columns = 1, .value = VALUES("5/2"), .place = IN_RESULT},
    {.name = NULL}};
static const claim five = {TEXTS("three_is_five", "two", 95), .kind = COUNTEREXAMPLE,
                           .body = {[RATIONAL_TYPE] = is_five_q}, .data = two_data};
static const claim few_claims[] = {
    {TEXTS("enclosed_sum", "two", 70), .body = {[INTERVAL_TYPE] = double_i}},
    {TEXTS("decided_in_double", "two", 75), .kind = DECISION, .body = {[DOUBLE_TYPE] = double_m}},
    {TEXTS("never_caught", "two", 80), .body = {[RATIONAL_TYPE] = never_caught_q}},
    {TEXTS("square_is_product", "two", 90), .body = {[FIELD_TYPE] = square_f}},
    {.name = NULL}};
static const statement few_statements[] = {
    {STATEMENT("1", "book", 1, "misprint", "", "", ""),
     .links = LINKS({READING, "square_is_product", "because it is so", "one way", NULL},
                    {READING, "square_is_product", NULL, "another way", NULL})},
    {.id = NULL}};
/* Corrected by what words argue for, where nothing refutes what is printed. */
static const statement corrected_statements[] = {
    {STATEMENT("1", "book", 1, "", "x = 3", "", ""),
     .links = LINKS({CORRECTED_BY, "square_is_product", NULL, "", NULL}, {ARGUED, NULL, "", "because it is so", NULL})},
    {.id = NULL}};
/* What does not go into one line of a narrow terminal; outcomes of every kind; ranks with gaps, one of a statement that holds; the two ways to
 * refer to a source, and what is none; readings that nobody decided. */
static void is_not_i(trial *T)
{
    num_i x = positive_i(T, "x", 1);
    same_i(T, x, add_i(x, from_int_i(1)));
}
/* The error is infinitely many times a bound of 0. */
static void is_not_m(trial *T) { same_m(T, exact_m(1), exact_m(2)); }
static claim told_claims[] = {
    {TEXTS("three_is_four_in_whatever_way_it_is_counted", "two", 40), .kind = COUNTEREXAMPLE,
     .body = {[RATIONAL_TYPE] = is_four_q}, .data = in_one_line},
    {TEXTS("three_is_four_once_more", "two", 42), .kind = COUNTEREXAMPLE, .body = {[RATIONAL_TYPE] = is_four_q},
     .data = in_two_lines},
    {TEXTS("powers_commute", "one", 28), .degree_low = 2, .degree_high = 4, .degree_sampled = 4,
     .body = {[FIELD_TYPE] = powers_f}},
    {TEXTS("three_has_two_results", "two", 43), .kind = COUNTEREXAMPLE, .body = {[RATIONAL_TYPE] = is_four_twice_q},
     .data = two_results},
    {TEXTS("decided_in_double", "two", 75), .kind = DECISION, .body = {[DOUBLE_TYPE] = double_m}},
    {TEXTS("sum_is_double", "one", 20), .body = {[INTERVAL_TYPE] = double_i, [DOUBLE_TYPE] = double_m}},
    {TEXTS("one_is_two_in_intervals", "two", 50), .body = {[INTERVAL_TYPE] = is_not_i}},
    {TEXTS("nobody_knows", "two", 60), .body = {[FIELD_TYPE] = is_unable_f}},
    {TEXTS("never_caught", "two", 80), .body = {[RATIONAL_TYPE] = never_caught_q}},
    {TEXTS("one_is_two_in_double", "two", 85), .body = {[DOUBLE_TYPE] = is_not_m}},
    {.name = NULL}};
#define FALSE_BY(name) LINKS({REFUTED_BY, name, NULL, "", NULL})
static statement told_statements[] = {
    {STATEMENT("1", "book", 1, "false", "", "in a paper of [book], which is no paper", ""), .striking = 4,
     .links = FALSE_BY("three_is_four_once_more")},
    {STATEMENT("2", "book", 2, "missing-hypothesis", "", "as in [mypaper; paper]", ""),
     .links = FALSE_BY("three_is_four_in_whatever_way_it_is_counted")},
    {STATEMENT("third-of-all", "book", 3, "", "", "as in [paper-two] and in [paper", ""), .striking = 2,
     .links = LINKS({HOLDS_BY, "powers_commute", NULL, "", NULL},
                    {NEEDS, "three_is_four_once_more", "[paper], page 7", "$y > 0$", NULL},
                    {CITES, NULL, "[edited], 5", "a theorem", NULL})},
    {STATEMENT("4", "book", 4, "invalid-proof", "", "", ""), .striking = 1,
     .links = FALSE_BY("three_is_four_in_whatever_way_it_is_counted")},
    {STATEMENT("6", "book", 6, "false", "", "", ""), .striking = 5, .links = FALSE_BY("three_has_two_results")},
    {STATEMENT("5", "book", 5, "", "", "", ""),
     .links =
         LINKS({READING, "missing", "because it is so", "one way", NULL},
               {READING, "powers_commute", NULL, "another way", NULL}, {READING, "missing", NULL, "a third way", NULL},
               {READING, "decided_in_double", "because it is so", "a fourth way", NULL})},
    {.id = NULL}};
/* What a claim does for statements, in every role, once and beside others; claims that decide a reading together; hypotheses that
 * are shown to be needed, and words alone. */
static const statement role_statements[] = {
    {STATEMENT("1", "book", 1, "", "", "", ""),
     .links = LINKS({HOLDS_BY, "square_is_product", NULL, "", NULL}, {CONFIRMED_BY, "sum_is_double", NULL, "", NULL})},
    {STATEMENT("2", "book", 2, "", "x < 3 & x > 1", "", ""),
     .links = LINKS({CORRECTED_BY, "square_is_product", NULL, "", NULL},
                    {CORRECTED_BY, "powers_commute", NULL, "", NULL}, {CORRECTED_BY, "three_squared", NULL, "", NULL})},
    {STATEMENT("3", "paper", 3, "false", "", "", ""),
     .links = LINKS({HYPOTHESIS, NULL, NULL, "$x = 7$", NULL}, {REFUTED_BY, "three_is_four", NULL, "", NULL},
                    {REFUTED_BY, "three_is_five", NULL, "", NULL}, {NEEDS, NULL, "page 9", "$x = 8$", NULL})},
    {STATEMENT("4", "paper", 4, "", "", "", ""),
     .links = LINKS(
         {HOLDS_BY, "square_is_product", NULL, "", NULL}, {HYPOTHESIS, "three_is_five", NULL, "$x > 0$", NULL},
         {HYPOTHESIS, "three_is_four", NULL, "$x > 1$", NULL}, {HYPOTHESIS, NULL, NULL, "$x > 2$", NULL},
         {NEEDS, "three_is_four", "page 7", "$x > 3$", NULL}, {NEEDS, "three_is_five", "page 8", "$x > 4$", NULL})},
    {STATEMENT("5", "edited", 5, "", "", "", ""),
     .links = LINKS(
         {READING, "square_is_product", NULL, "one way", NULL}, {READING_WITH, "three_squared", NULL, "", NULL},
         {READING_WITH, "powers_commute", NULL, "", NULL}, {READING, "sum_is_double", NULL, "another way", NULL},
         {READING_WITH, "square_is_product", NULL, "", NULL}, {READING, "three_is_five", NULL, "a third way", NULL})},
    {STATEMENT("6", "edited", 6, "", "", "", ""), .is_definition = 1,
     .links = LINKS({CHECKED_BY, "three_squared", NULL, "", NULL}, {CHECKED_BY, "square_is_product", NULL, "", NULL},
                    {CHECKED_BY, "powers_commute", NULL, "", NULL})},
    {STATEMENT("7", "unlisted", 7, "", "", "", ""),
     .links = LINKS({HOLDS_BY, "square_is_product", NULL, "", NULL}, {HOLDS_BY, "powers_commute", NULL, "", NULL},
                    {HOLDS_BY, "three_squared", NULL, "", NULL}, {ARGUED, NULL, "x > 7", "first words", NULL},
                    {MEANT, NULL, "page 1", "one thing", NULL}, {CITES, NULL, "[edited], 5", "a theorem", NULL},
                    {ARGUED, NULL, "", "other words", NULL}, {CITES, NULL, "[paper], 6", "another theorem", NULL})},
    {.id = NULL}};
/* The entries of a table: one that holds, one with a misprint, one under a hypothesis, one that nobody decided, with a print of several lines. */
static const statement table_statements[] = {
    {STATEMENT("table-row-1-1", "book", 1, "", "", "as in [book; paper] and by xpaper]", "picture"),
     .links = LINKS({HOLDS_BY, "square_is_product", NULL, "", NULL})},
    {STATEMENT("table-row-1-2", "book", 2, "misprint", "x = 3", "not [mypaper], nor the book", ""), .striking = 1,
     .links = LINKS({REFUTED_BY, "three_is_four", NULL, "", NULL}, {CORRECTED_BY, "three_squared", NULL, "", NULL})},
    {STATEMENT("table-row-2-1", "book", 3, "", "y = 5", "", ""),
     .links = LINKS({HOLDS_BY, "sum_is_double", NULL, "", NULL}, {HYPOTHESIS, "three_is_four", NULL, "$x > 0$", NULL})},
    {STATEMENT("table-row-2-2, which is said in words that are longer than a line, so that what follows stands below "
               "them, and not below the verdict",
               "book", 4, "", "", "", ""),
     .links = LINKS({HOLDS_BY, NULL, NULL, NULL, NULL})},
    {STATEMENT("1", "edited", 5, "", "", "", ""), .links = LINKS({HOLDS_BY, "square_is_product", NULL, "", NULL})},
    {.id = NULL}};
static const char *const printed_ids[] = {"book:table-row-1-2", "edited:1", "book:1", NULL}, *const every_ids[] = {
                                                                                                 "edited:1", NULL};
static const source sources[] = {{"book", "Ann Author, Bob Author", "A book", "书", "1999", "Press", "chapter 1", "n"},
                                 {"paper", "unknown", "A paper", "", "unknown", "", "pages 1 to 9", "n"},
                                 {"edited", "Carl Author (editor)", "Collected", "", "2001", "Press", "", "n"},
                                 {.key = NULL}};
static const chapter chapters[] = {{"first", "The first"}, {.name = NULL}};
static const figure figures[] = {{.name = NULL}};
static claim good_claims[GOOD + 1];
static const cagd_register good = {good_claims, good_statements, chapters, figures, sources, NULL, NULL, NULL},
                           bad = {claims, bad_statements, chapters, figures, sources, NULL, NULL, NULL},
                           lost = {good_claims, lost_statements, chapters, figures, sources, NULL, NULL, NULL},
                           few = {few_claims, few_statements, chapters, figures, sources, NULL, NULL, NULL},
                           corrected = {few_claims, corrected_statements, chapters, figures, sources, NULL, NULL, NULL},
                           told = {told_claims, told_statements, chapters, figures, sources, NULL, NULL, NULL};

/* main.c has the list of the commands; here there is no other. */
const struct command *const commands[] = {&command_verify, NULL};

/* ---- a call ------------------------------------------------------------------------------------------ */

/* Of the sanitizer, which asks at the end of a process and not at its _exit; NULL in other builds. */
extern int __lsan_do_recoverable_leak_check(void) __attribute__((weak));
enum { LEAKS = 98 };

/* Runs the command in a process of its own.  Returns the exit status, that of a leak where memory is not given back, and in *out what it printed,
 * to be freed. */
static int call_of(const struct command *command, const cagd_register *reg, char **out, const char *const arguments[])
{
    static const int crashes[] = {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV};
    char name[32], *argv[16] = {name};
    int argc = 1;
    snprintf(name, sizeof name, "cagd %s", command->name);
    while (arguments[argc - 1] != NULL) {
        argv[argc] = strdup(arguments[argc - 1]); /* the parser of an option may write into it */
        argc++;
    }
    FILE *file = tmpfile();
    assert_non_null(file);
    fflush(NULL);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        for (size_t k = 0; k < sizeof crashes / sizeof *crashes; k++)
            signal(crashes[k], SIG_DFL); /* not as cmocka has it */
        dup2(fileno(file), STDOUT_FILENO);
        if (freopen("/dev/null", "w", stderr) == NULL)
            _exit(99);
        int code = command->run(&(struct call){command, reg, argc, argv});
        fflush(stdout);
        _exit(__lsan_do_recoverable_leak_check != NULL && __lsan_do_recoverable_leak_check() ? LEAKS : code);
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    long size = (fseek(file, 0, SEEK_END), ftell(file));
    rewind(file);
    *out = calloc((size_t)size + 1, 1);
    assert_non_null(*out);
    assert_int_equal(fread(*out, 1, (size_t)size, file), (size_t)size);
    fclose(file);
    while (argc > 1)
        free(argv[--argc]);
    return WEXITSTATUS(status);
}
#define CALL(command, reg, out, ...) call_of(&command_##command, reg, out, (const char *const[]){__VA_ARGS__, NULL})

static char *text_of(const char *path)
{
    FILE *file = fopen(path, "r");
    if (file == NULL)
        fail_msg("%s cannot be read", path);
    char *text = NULL;
    size_t size = 0;
    if (getdelim(&text, &size, '\0', file) < 0) {
        free(text);
        text = strdup("");
    }
    fclose(file);
    return text;
}

/* The text is that of the file in command-output. */
static void assert_expected(const char *name, const char *text)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s", EXPECTED, name);
    if (getenv("CAGD_WRITE_EXPECTED") != NULL) {
        FILE *file = fopen(path, "w");
        assert_non_null(file);
        fputs(text, file);
        fclose(file);
    }
    char *expected = text_of(path);
    if (strcmp(expected, text) != 0)
        fail_msg("not as in %s:\n%s", name, text);
    free(expected);
}

static void says(int code, const struct command *command, const cagd_register *reg, const char *expected,
                 const char *const arguments[])
{
    char *out;
    int status = call_of(command, reg, &out, arguments);
    assert_expected(expected, out);
    assert_int_equal(status, code);
    free(out);
}
#define SAYS(code, command, reg, expected, ...)                                                                        \
    says(code, &command_##command, reg, expected, (const char *const[]){__VA_ARGS__, NULL})

/* ---- the tests --------------------------------------------------------------------------------------- */

static void exit_status_is_that_of_the_verdicts(void **state)
{
    (void)state;
    static const struct {
        const struct command *command;
        const char *arguments[5];
        int good, bad;
    } list[] = {
        {&command_verify, {"-j1"}, EXIT_AS_EXPECTED, EXIT_NOT_AS_EXPECTED},
        {&command_verify, {"-j1", "--json"}, EXIT_AS_EXPECTED, EXIT_NOT_AS_EXPECTED},
        {&command_verify, {"-j1", "--tap"}, EXIT_AS_EXPECTED, EXIT_NOT_AS_EXPECTED},
        {&command_verify, {"square_is_product"}, EXIT_AS_EXPECTED, EXIT_AS_EXPECTED},
        {&command_verify, {"one_is_two"}, EXIT_USAGE, EXIT_NOT_AS_EXPECTED},
        {&command_verify, {"nobody_knows"}, EXIT_USAGE, EXIT_NOT_AS_EXPECTED},
        {&command_verify, {"--shard", "1/9"}, EXIT_AS_EXPECTED, EXIT_AS_EXPECTED},
        {&command_verify, {"--shard", "8/9"}, EXIT_AS_EXPECTED, EXIT_NOT_AS_EXPECTED},
        {&command_verify, {"--json", "--tap"}, EXIT_USAGE, EXIT_USAGE},
        {&command_verify, {"--shard", "8/7"}, EXIT_USAGE, EXIT_USAGE},
        {&command_verify, {"--shard", "1000/1000"}, EXIT_AS_EXPECTED, EXIT_AS_EXPECTED},
        {&command_verify, {"--shard", "1/1001"}, EXIT_USAGE, EXIT_USAGE},
        {&command_verify, {"--shard", "0/7"}, EXIT_USAGE, EXIT_USAGE},
        {&command_verify, {"--shard", "7"}, EXIT_USAGE, EXIT_USAGE},
        {&command_verify, {"--junit", "/nowhere/at/all"}, EXIT_USAGE, EXIT_USAGE},
        {&command_verify, {"--certificates", "/dev/null/at/all"}, EXIT_USAGE, EXIT_USAGE},
        {&command_verify, {"--report", "/dev/null/at/all"}, EXIT_USAGE, EXIT_USAGE},
        {&command_verify, {"-j1", "--junit", "/dev/full"}, EXIT_INTERNAL, EXIT_INTERNAL},
        {&command_verify, {"--report", "/tmp", "square_is_product"}, EXIT_USAGE, EXIT_USAGE},
        {&command_verify, {"--report", "/tmp", "--shard", "1/2"}, EXIT_USAGE, EXIT_USAGE},
        {&command_ledger, {"-j1"}, EXIT_AS_EXPECTED, EXIT_NOT_AS_EXPECTED},
        {&command_ledger, {"--json"}, EXIT_AS_EXPECTED, EXIT_NOT_AS_EXPECTED},
        {&command_ledger, {"book:1"}, EXIT_AS_EXPECTED, EXIT_AS_EXPECTED},
        {&command_ledger, {"book:3"}, EXIT_AS_EXPECTED, EXIT_NOT_AS_EXPECTED},
        {&command_ledger, {"book:9"}, EXIT_USAGE, EXIT_USAGE},
        {&command_ledger, {"--json", "--summary"}, EXIT_USAGE, EXIT_USAGE},
        {&command_ledger, {"--json", "--striking", "1"}, EXIT_USAGE, EXIT_USAGE},
        {&command_ledger, {"--summary", "--striking", "1"}, EXIT_USAGE, EXIT_USAGE},
        {&command_ledger, {"--striking", "0"}, EXIT_USAGE, EXIT_USAGE},
        {&command_ledger, {"--striking", "101"}, EXIT_USAGE, EXIT_USAGE},
        {&command_ledger, {"--striking", "100"}, EXIT_AS_EXPECTED, EXIT_NOT_AS_EXPECTED},
        {&command_ledger, {"--striking", "1", "book:1"}, EXIT_AS_EXPECTED, EXIT_AS_EXPECTED},
        {&command_verify, {"--shard", "1/0"}, EXIT_USAGE, EXIT_USAGE},
        {&command_verify, {"--shard", "1/1", "square_is_product"}, EXIT_AS_EXPECTED, EXIT_AS_EXPECTED},
        {&command_verify, {"--shard", "x/2"}, EXIT_USAGE, EXIT_USAGE},
        {&command_verify, {"--shard", "1/2/3"}, EXIT_USAGE, EXIT_USAGE},
        {&command_show, {"book:1"}, EXIT_AS_EXPECTED, EXIT_AS_EXPECTED},
        {&command_show, {"book:2"}, EXIT_AS_EXPECTED, EXIT_NOT_AS_EXPECTED},
        {&command_show, {"book:1", "book:2"}, EXIT_AS_EXPECTED, EXIT_NOT_AS_EXPECTED},
        {&command_show, {"book:2", "book:1"}, EXIT_AS_EXPECTED, EXIT_NOT_AS_EXPECTED},
        {&command_show, {"one_is_two"}, EXIT_USAGE, EXIT_NOT_AS_EXPECTED},
        {&command_show, {"paper:5"}, EXIT_AS_EXPECTED, EXIT_USAGE},
        {&command_show, {"first.square_is_product"}, EXIT_AS_EXPECTED, EXIT_AS_EXPECTED},
        {&command_show, {"--json", "book:1", "book:2"}, EXIT_USAGE, EXIT_USAGE},
        {&command_show, {"--json"}, EXIT_USAGE, EXIT_USAGE},
    };
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        for (int is_bad = 0; is_bad < 2; is_bad++) {
            char *out;
            int code = call_of(list[k].command, is_bad ? &bad : &good, &out, list[k].arguments);
            int expected = is_bad ? list[k].bad : list[k].good;
            if (code != expected)
                fail_msg("call %zu, cagd %s %s: %d, not %d", k, list[k].command->name, list[k].arguments[0], code,
                         expected);
            free(out);
        }
}

/* A statement that does not follow counts as much as a claim. */
static void statements_are_counted(void **state)
{
    (void)state;
    char folder[] = "/tmp/test_command_XXXXXX", command[128], path[64], *out;
    assert_non_null(mkdtemp(folder));
    assert_int_equal(CALL(verify, &lost, &out, "-j1"), EXIT_AS_EXPECTED);
    free(out);
    assert_int_equal(CALL(verify, &lost, &out, "-j1", "--report", folder), EXIT_NOT_AS_EXPECTED);
    free(out);
    assert_int_equal(CALL(verify, &good, &out, "-j1", "--report", folder), EXIT_AS_EXPECTED);
    free(out);
    assert_int_equal(CALL(ledger, &lost, &out, "-j1"), EXIT_NOT_AS_EXPECTED);
    free(out);
    assert_int_equal(CALL(show, &lost, &out, "book:2"), EXIT_NOT_AS_EXPECTED);
    free(out);
    assert_int_equal(CALL(show, &lost, &out, "book:1"), EXIT_AS_EXPECTED);
    free(out);
    /* A certificate that cannot be written. */
    snprintf(command, sizeof command, "mkdir -p '%s/claims/three_squared.json'", folder);
    assert_int_equal(system(command), 0);
    assert_int_equal(CALL(verify, &good, &out, "-j1", "--certificates", folder), EXIT_INTERNAL);
    free(out);
    /* What cannot be written is told, whatever is not as expected besides. */
    assert_int_equal(CALL(verify, &lost, &out, "-j1", "--report", folder, "--junit", "/dev/full"), EXIT_INTERNAL);
    free(out);
    /* A file that always has the same name is promised before anything is decided. */
    snprintf(path, sizeof path, "%s/manifest.json", folder);
    assert_int_equal(CALL(verify, &good, &out, "-j1", "--certificates", folder, "--junit", path), EXIT_USAGE);
    free(out);
    static const char *const reported[] = {"ledger.txt", "summary.txt", "striking.txt", "ledger.json"};
    for (int k = 0; k < 4; k++) {
        snprintf(path, sizeof path, "%s/%s", folder, reported[k]);
        assert_int_equal(CALL(verify, &good, &out, "-j1", "--report", folder, "--junit", path), EXIT_USAGE);
        free(out);
        snprintf(command, sizeof command, "rm -rf '%s' && mkdir -p '%s'", folder, path);
        assert_int_equal(system(command), 0);
        assert_int_equal(CALL(verify, &good, &out, "-j1", "--report", folder), EXIT_USAGE);
        free(out);
    }
    snprintf(path, sizeof path, "%s/manifest.json", folder);
    snprintf(command, sizeof command, "rm -rf '%s' && mkdir -p '%s'", folder, path);
    assert_int_equal(system(command), 0);
    assert_int_equal(CALL(verify, &good, &out, "-j1", "--certificates", folder), EXIT_USAGE);
    free(out);
    snprintf(command, sizeof command, "rm -r '%s'", folder);
    assert_int_equal(system(command), 0);
}

static int run_tenths(const struct call *call)
{
    (void)call;
    print_json_exactly(json_pack("[f]", 0.1));
    print_json(json_pack("[f]", 0.1));
    return 7;
}
static const struct command print_tenths = {.name = "tenths", .run = run_tenths};

/* Results that no run made. */
static void reports_of_given_results(void **state)
{
    (void)state;
    claim_result r[2] = {{.claim = &claims[0], .as_expected = 1}, {.claim = &claims[1], .as_expected = 1}};
    assert_null(speaking_type(&r[0]));
    r[0].by[INTERVAL_TYPE].outcome = FAILS; /* and did not run */
    assert_null(speaking_type(&r[0]));
    r[0].by[DOUBLE_TYPE].ran = 1;
    assert_ptr_equal(speaking_type(&r[0]), &r[0].by[DOUBLE_TYPE]);
    r[0].by[RATIONAL_TYPE] = (type_result){.ran = 1, .outcome = UNDECIDED};
    assert_ptr_equal(speaking_type(&r[0]), &r[0].by[RATIONAL_TYPE]);
    r[0].by[DOUBLE_TYPE].outcome = FAILS;
    assert_ptr_equal(speaking_type(&r[0]), &r[0].by[DOUBLE_TYPE]);
    r[0].by[FIELD_TYPE] = (type_result){.ran = 1, .outcome = FAILS};
    assert_ptr_equal(speaking_type(&r[0]), &r[0].by[FIELD_TYPE]);
    for (number_type t = 0; t < NUMBER_TYPES; t++) {
        r[0].by[t] = (type_result){.ran = 1, .seconds = 1 << t, .worst = 100};
        r[1].by[t] = (type_result){.ran = 1, .seconds = 0.5};
    }
    char *out;
    assert_int_equal(call_of(&print_tenths, &good, &out, (const char *const[]){NULL}), 7);
    assert_string_equal(out, "[\n  0.10000000000000001\n]\n[\n  0.1\n]\n");
    free(out);
    char path[] = "/tmp/test_command_XXXXXX";
    int file = mkstemp(path);
    assert_true(file >= 0);
    close(file);
    assert_int_equal(write_junit(path, r, 2), 0);
    char *text = text_of(path);
    assert_non_null(strstr(text, "tests=\"2\" failures=\"0\" errors=\"0\" time=\"17.000\""));
    assert_non_null(strstr(text, "name=\"square_is_product\" time=\"15.000\"/>"));
    assert_non_null(strstr(text, "name=\"sum_is_double\" time=\"2.000\"/>"));
    free(text);
    remove(path);
}

/* Of the empty text, of texts that end before, at and behind the end of a block, and of 10^5 letters: as sha256sum has them. */
static void digests(void **state)
{
    (void)state;
    static const struct {
        int length;
        const char *digest;
    } list[] = {
        {0, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
        {1, "ca978112ca1bbdcafac231b39a23dc4da786eff8147c4e72b9807785afee48bb"},
        {55, "9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318"},
        {56, "b35439a4ac6f0948b6d6f9e3c6af0f5f590ce20f1bde7090ef7970686ec6738a"},
        {63, "7d3e74a05d7db15bce4ad9ec0658ea98e3f06eeecf16b4c6fff2da457ddc2f34"},
        {64, "ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb"},
        {65, "635361c48bb9eab14198e76ea8ab7f1a41685d6ad62aa9146d301d4f17eb0ae0"},
        {119, "31eba51c313a5c08226adf18d4a359cfdfd8d2e816b13f4af952f7ea6584dcfb"},
        {120, "2f3d335432c70b580af0e8e1b3674a7c020d683aa5f73aaaedfdc55af904c21c"},
        {100000, "6d1cf22d7cc09b085dfc25ee1a1f3ae0265804c607bc2074ad253bcc82fd81ee"},
    };
    static char text[100001];
    char digest[DIGEST];
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        memset(text, 'a', (size_t)list[k].length);
        text[list[k].length] = '\0';
        digest_of_text(text, digest);
        assert_string_equal(digest, list[k].digest);
    }
    digest_of_text("标题 abc", digest);
    assert_string_equal(digest, "45da5821edd6aedfeec4f005c24a7ecd3a114ceff435bdd21238aa1ce356f449");
}

static void verify_says(void **state)
{
    (void)state;
    SAYS(EXIT_AS_EXPECTED, verify, &good, "verify-good.txt", "-j1");
    SAYS(EXIT_NOT_AS_EXPECTED, verify, &bad, "verify-bad.txt", "-j2");
    SAYS(EXIT_NOT_AS_EXPECTED, verify, &bad, "verify-bad.tap", "--tap");
    SAYS(EXIT_NOT_AS_EXPECTED, verify, &bad, "verify-bad.json", "--json");
    SAYS(EXIT_NOT_AS_EXPECTED, verify, &bad, "verify-shard.txt", "--shard", "4/4");
    SAYS(EXIT_AS_EXPECTED, verify, &good, "verify-deep.txt", "--deep", "sum_is_double*");
}

static void ledger_says(void **state)
{
    (void)state;
    SAYS(EXIT_AS_EXPECTED, ledger, &good, "ledger-good.txt", "-j1");
    SAYS(EXIT_AS_EXPECTED, ledger, &good, "ledger-good.json", "--json");
    SAYS(EXIT_AS_EXPECTED, ledger, &good, "ledger-striking.txt", "--striking", "1");
    SAYS(EXIT_AS_EXPECTED, ledger, &good, "ledger-two-striking.txt", "--striking", "9");
    SAYS(EXIT_NOT_AS_EXPECTED, ledger, &bad, "ledger-bad.txt", "-j1");
    SAYS(EXIT_AS_EXPECTED, ledger, &good, "ledger-summary.txt", "--summary", "paper:*");
}

/* What is enclosed is counted as sampled; controls that were caught are counted, and not those that ran; words that lead to a
 * reading weaken it alone; what does not fail has no class. */
static void what_few_claims_have(void **state)
{
    (void)state;
    char *out;
    assert_int_equal(CALL(verify, &few, &out, "-j1"), EXIT_NOT_AS_EXPECTED);
    assert_non_null(strstr(out, "\n4 claims: 1 proved, 1 decided, 0 argued, 1 sampled, 0 counterexamples, 1 not as "
                                "expected\n"));
    assert_non_null(strstr(out, "; 3 of 4 controls caught\n"));
    assert_null(strstr(out, "of the bound")); /* which is a bound of an identity */
    free(out);
    /* Why a claim that holds is not as expected; an error that is infinite, which JSON cannot say. */
    assert_int_equal(CALL(verify, &few, &out, "--tap", "never_caught"), EXIT_NOT_AS_EXPECTED);
    assert_non_null(strstr(out, "message: \"undecided, expected otherwise; rational: its control was not caught\"\n"));
    free(out);
    assert_int_equal(CALL(verify, &told, &out, "--json", "one_is_two_in_double"), EXIT_NOT_AS_EXPECTED);
    assert_non_null(strstr(out, "\"largest_error_over_bound\": null"));
    free(out);
    assert_int_equal(CALL(ledger, &few, &out, "-j1", "--json"), EXIT_AS_EXPECTED);
    json_t *ledger = json_loads(out, 0, NULL);
    const json_t *printed = json_object_get(json_array_get(json_object_get(ledger, "statements"), 0), "as_printed");
    static const char *const known[] = {"argued", "proved"};
    for (size_t k = 0; k < 2; k++) {
        const json_t *reading = json_array_get(json_object_get(printed, "readings"), k);
        assert_string_equal(json_string_value(json_object_get(reading, "evidence")), known[k]);
    }
    assert_string_equal(json_string_value(json_object_get(printed, "class")), "");
    json_decref(ledger);
    free(out);
}

/* Every run of blanks and ends of lines becomes one blank. */
static void squeeze(char *text)
{
    char *to = text;
    for (const char *at = text; *at != '\0'; at++) {
        int blank = *at == ' ' || *at == '\n';
        if (!blank || (to > text && to[-1] != ' '))
            *to++ = (char)(blank ? ' ' : *at);
    }
    *to = '\0';
}

/* The pages of all statements and all claims of a register are those of the file. */
static void all_pages(const cagd_register *reg, const char *expected)
{
    char *all = NULL, *out;
    size_t size;
    FILE *file = open_memstream(&all, &size);
    assert_non_null(file);
    for (const statement *s = reg->statements; s->id != NULL; s++) {
        (void)CALL(show, reg, &out, s->id);
        fputs(out, file);
        free(out);
    }
    for (const claim *c = reg->claims; c->name != NULL; c++) {
        (void)CALL(show, reg, &out, c->name);
        fputs(out, file);
        free(out);
    }
    fclose(file);
    assert_expected(expected, all);
    free(all);
}

/* Whatever comes out, in all forms: controls that were not caught, errors without end, claims that fail in intervals alone. */
static void outcomes_of_every_kind(void **state)
{
    (void)state;
    SAYS(EXIT_NOT_AS_EXPECTED, verify, &few, "verify-few.txt", "-j1");
    SAYS(EXIT_NOT_AS_EXPECTED, verify, &told, "verify-told.txt", "-j1");
    SAYS(EXIT_NOT_AS_EXPECTED, verify, &told, "verify-told.tap", "-j1", "--tap");
    SAYS(EXIT_NOT_AS_EXPECTED, verify, &told, "verify-told.json", "-j1", "--json");
}

/* A claim is told in every role that it has for a statement; claims that decide a reading together, the words for a statement, and
 * what each hypothesis is shown by, stand where they belong. */
static void every_role_is_told(void **state)
{
    (void)state;
    claim of_roles[GOOD + 2];
    memcpy(of_roles, claims, GOOD * sizeof *claims);
    of_roles[GOOD] = five;
    of_roles[GOOD + 1] = (claim){.name = NULL};
    const cagd_register roles = {of_roles, role_statements, chapters, figures, sources, NULL, NULL, NULL};
    all_pages(&roles, "show-roles.txt");
    SAYS(EXIT_AS_EXPECTED, ledger, &roles, "ledger-roles.txt", "-j1");
    SAYS(EXIT_AS_EXPECTED, ledger, &roles, "ledger-roles.json", "-j1", "--json");
    char folder[] = "/tmp/test_command_XXXXXX", path[64], command[128], *out;
    assert_non_null(mkdtemp(folder));
    assert_int_equal(CALL(verify, &roles, &out, "-j1", "--certificates", folder), EXIT_AS_EXPECTED);
    free(out);
    snprintf(path, sizeof path, "%s/manifest.json", folder);
    char *text = text_of(path);
    assert_expected("manifest-roles.json", text);
    json_t *manifest = json_loads(text, 0, NULL);
    free(text);
    /* Every statement that is not open has its certificate, whatever stands before it: the one of which the manifest has the digest. */
    const json_t *certified = json_object_get(manifest, "statements");
    assert_int_equal(json_array_size(certified), 6);
    for (size_t k = 0; k < json_array_size(certified); k++) {
        const json_t *one = json_array_get(certified, k);
        char id[32], digest[DIGEST];
        snprintf(id, sizeof id, "%s", json_string_value(json_object_get(one, "statement")));
        *strchr(id, ':') = '/';
        snprintf(path, sizeof path, "%s/%s.json", folder, id);
        text = text_of(path);
        digest_of_text(text, digest);
        assert_string_equal(digest, json_string_value(json_object_get(one, "sha256")));
        free(text);
    }
    json_decref(manifest);
    snprintf(command, sizeof command, "rm -r '%s'", folder);
    assert_int_equal(system(command), 0);
}

/* Sources are counted in the order in which they come, however many they are. */
static void every_source_is_counted(void **state)
{
    (void)state;
    enum { SOURCES = 40 };
    static char id[SOURCES * 2][16];
    statement of_sources[SOURCES * 2 + 1] = {{.id = NULL}};
    for (int k = 0; k < SOURCES * 2; k++) {
        of_sources[k] = good_statements[0];
        snprintf(id[k], sizeof id[k], "source%d:%d", k % SOURCES, k);
        of_sources[k].id = id[k];
    }
    cagd_register reg = good;
    reg.statements = of_sources;
    char *out;
    assert_int_equal(CALL(ledger, &reg, &out, "-j1", "--summary"), EXIT_AS_EXPECTED);
    const char *line = strchr(out, '\n');
    for (int k = 0; k < SOURCES; k++) {
        char expected[128];
        snprintf(expected, sizeof expected, "\n%s%-12d %10d %6d %12d %6d %10d %5d %11d\n", "source", k, 2, 2, 0, 0, 0,
                 0, 0);
        assert_int_equal(strncmp(line, expected, strlen(expected)), 0);
        line = strchr(line + 1, '\n');
    }
    assert_string_equal(line, "\n");
    free(out);
}

/* The report has the three most striking statements, as the ledger tells three. */
static void the_three_most_striking_are_reported(void **state)
{
    (void)state;
    char folder[] = "/tmp/test_command_XXXXXX", path[64], command[128], *out;
    statement four[sizeof told_statements / sizeof *told_statements];
    memcpy(four, told_statements, sizeof four);
    four[1].striking = 3;
    cagd_register reg = told;
    reg.statements = four;
    assert_non_null(mkdtemp(folder));
    assert_int_equal(CALL(verify, &reg, &out, "-j1", "--report", folder), EXIT_NOT_AS_EXPECTED);
    free(out);
    snprintf(path, sizeof path, "%s/striking.txt", folder);
    char *text = text_of(path);
    (void)CALL(ledger, &reg, &out, "-j1", "--striking", "3");
    assert_string_equal(text, out);
    free(out);
    (void)CALL(ledger, &reg, &out, "-j1", "--striking", "4");
    assert_string_not_equal(text, out);
    free(out);
    free(text);
    snprintf(command, sizeof command, "rm -r '%s'", folder);
    assert_int_equal(system(command), 0);
}

/* A source is the one whose key is that of the statement, whatever other keys begin so; and the literature is that of all claims
 * and of all citations, whatever stands before them. */
static void sources_are_found_by_their_whole_key(void **state)
{
    (void)state;
    static const source keys[] = {{"bookshelf", "Ann", "A shelf", "", "1990", "Press", "", "n"},
                                  {"boo", "Bob", "A fright", "", "1991", "Press", "", "n"},
                                  {"book", "Cid", "A book", "", "1992", "Press", "", "n"},
                                  {"paper", "Dan", "A paper", "", "1993", "Press", "", "n"},
                                  {"note", "Eve", "A note", "", "1994", "Press", "", "n"},
                                  {"first", "Fay", "A first", "", "1995", "Press", "", "n"},
                                  {.key = NULL}};
    claim methods[GOOD + 1];
    memcpy(methods, good_claims, sizeof methods);
    static const char *const method[] = {"as in [first]", "alone", "as in [paper]"};
    for (int k = 0; k < GOOD; k++)
        methods[k].method = method[k < 3 ? k : 1];
    const statement of_book[] = {
        {STATEMENT("1", "book", 1, "", "", "", ""),
         .links = LINKS({HOLDS_BY, "square_is_product", NULL, "", NULL}, {ARGUED, NULL, "n > 9", "words", NULL},
                        {CITES, NULL, "[note], 5", "a theorem", NULL}, {HOLDS_BY, "sum_is_double", NULL, "", NULL},
                        {HOLDS_BY, "sum_is_double_in_degrees", NULL, "", NULL})},
        {.id = NULL}};
    const cagd_register reg = {methods, of_book, chapters, figures, keys, NULL, NULL, NULL};
    char *out;
    assert_int_equal(CALL(show, &reg, &out, "book:1"), EXIT_AS_EXPECTED);
    assert_non_null(strstr(out, "\nCid: A book, 1992\n"));
    const char *literature = strstr(out, "\nLiterature\n");
    assert_non_null(literature);
    assert_string_equal(literature,
                        "\nLiterature\n    paper Dan: A paper, Press, 1993\n    note Eve: A note, Press, 1994\n"
                        "    first Fay: A first, Press, 1995\n");
    free(out);
}

/* A counterexample that refutes nothing is none in any form, and a statement that it should refute is open; what one refutes that needs
 * words is false by these. */
static void is_three_q(trial *T) { same_q(T, given_q(T, "x"), from_int_q(3)); }
static void counterexamples_that_are_none(void **state)
{
    (void)state;
    claim list[] = {{TEXTS("three_is_three", "two", 96), .kind = COUNTEREXAMPLE, .body = {[RATIONAL_TYPE] = is_three_q},
                     .data = only_three},
                    {TEXTS("three_is_four", "two", 40), .kind = COUNTEREXAMPLE, .body = {[RATIONAL_TYPE] = is_four_q},
                     .data = three},
                    {TEXTS("decided_in_double", "two", 97), .kind = DECISION, .body = {[DOUBLE_TYPE] = double_m}},
                    {.name = NULL}};
    list[1].argued = list[2].argued = "words";
    const statement of_these[] = {
        {STATEMENT("1", "book", 1, "false", "", "", ""), .links = FALSE_BY("three_is_three")},
        {STATEMENT("2", "book", 2, "false", "", "", ""), .links = FALSE_BY("three_is_four")},
        {STATEMENT("3", "book", 3, "", "", "", ""),
         .links = LINKS(
             {HOLDS_BY, "decided_in_double", NULL, "", NULL}, {READING, "three_is_three", NULL, "one way", NULL},
             {READING, "decided_in_double", NULL, "another way", NULL},
             {READING_WITH, "decided_in_double", NULL, "", NULL}, {READING_WITH, "three_is_three", NULL, "", NULL},
             {READING, "decided_in_double", NULL, "a third way", NULL})},
        {STATEMENT("4", "book", 4, "false", "", "", ""),
         .links = LINKS({HOLDS_BY, "decided_in_double", NULL, "", NULL},
                        {HYPOTHESIS, "three_is_three", NULL, "$x > 0$", NULL},
                        {NEEDS, "three_is_three", "page 7", "$x > 1$", NULL},
                        {REFUTED_BY, "three_is_three", NULL, "", NULL}, {REFUTED_BY, "three_is_four", NULL, "", NULL})},
        {.id = NULL}};
    const cagd_register reg = {list, of_these, chapters, figures, sources, NULL, NULL, NULL};
    SAYS(EXIT_NOT_AS_EXPECTED, verify, &reg, "verify-none.txt", "-j1");
    SAYS(EXIT_NOT_AS_EXPECTED, verify, &reg, "verify-none.tap", "-j1", "--tap");
    SAYS(EXIT_NOT_AS_EXPECTED, ledger, &reg, "ledger-none.txt", "-j1");
    SAYS(EXIT_NOT_AS_EXPECTED, ledger, &reg, "ledger-none.json", "-j1", "--json");
    all_pages(&reg, "show-none.txt");
}

/* Of a source what is not known, whether the word or the empty text says so, is left out. */
static void what_is_not_known_of_a_source(void **state)
{
    (void)state;
    static const struct {
        source source;
        const char *line, *literature;
    } list[] = {
        {{"book", "Ann, Bob", "A book", "书", "1999", "Press", "chapter 1", "n"},
         "Ann et al.: 书 (A book), chapter 1, 1999",
         "book Ann, Bob: A book, Press, 1999"},
        {{"book", "unknown", "A book", "", "unknown", "unknown", "", "n"}, "A book", "book A book"},
        {{"book", "", "A book", "", "", "", "", "n"}, "A book", "book A book"},
        {{"book", "Ann (editor)", "A book", "", "", "Press", "", "n"},
         "Ann: A book",
         "book Ann (editor): A book, Press"},
        {{"book", "", "A book", "书", "1999", "", "part 2", "n"}, "书 (A book), part 2, 1999", "book A book, 1999"},
        {{"book", "Ann", "A book", "", "unknown", "Press", "", "n"}, "Ann: A book", "book Ann: A book, Press"},
    };
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        const source of[] = {list[k].source, {.key = NULL}};
        const cagd_register reg = {good_claims, good_statements, chapters, figures, of, NULL, NULL, NULL};
        char *out, line[128], literature[128];
        assert_int_equal(CALL(show, &reg, &out, "book:1"), EXIT_AS_EXPECTED);
        snprintf(line, sizeof line, ":1)\n%s\n\nPrinted\n", list[k].line);
        snprintf(literature, sizeof literature, "\nLiterature\n    %s\n", list[k].literature);
        if (strstr(out, line) == NULL || strstr(out, literature) == NULL)
            fail_msg("%zu:\n%s", k, out);
        free(out);
    }
}

/* Of three statements any that does not follow is enough, in the ledger, in a report and on pages; and so is any of three claims. */
static void one_that_went_wrong_is_enough(void **state)
{
    (void)state;
    char folder[] = "/tmp/test_command_XXXXXX", command[128], *out;
    assert_non_null(mkdtemp(folder));
    for (int wrong = 0; wrong <= 3; wrong++) {
        statement three_of[4] = {{.id = NULL}};
        static const char *const id[] = {"book:1", "book:2", "book:3"};
        for (int k = 0; k < 3; k++) {
            three_of[k] = lost_statements[k == wrong];
            three_of[k].id = id[k];
        }
        cagd_register reg = good;
        reg.statements = three_of;
        const int code = wrong < 3 ? EXIT_NOT_AS_EXPECTED : EXIT_AS_EXPECTED;
        assert_int_equal(CALL(ledger, &reg, &out, "-j1"), code);
        free(out);
        assert_int_equal(CALL(ledger, &reg, &out, "-j1", "--json"), code);
        free(out);
        assert_int_equal(CALL(verify, &reg, &out, "-j1", "--report", folder), code);
        free(out);
        assert_int_equal(CALL(show, &reg, &out, "book:1", "book:2", "book:3"), code);
        free(out);
        claim list[4] = {{.name = NULL}};
        static const char *const name[] = {"a_claim", "b_claim", "c_claim"};
        for (int k = 0; k < 3; k++) {
            list[k] = few_claims[k == wrong ? 2 : 3];
            list[k].name = name[k];
        }
        const cagd_register of_claims = {list, bad_statements, chapters, figures, sources, NULL, NULL, NULL};
        assert_int_equal(CALL(verify, &of_claims, &out, "-j1"), code);
        free(out);
        assert_int_equal(CALL(show, &of_claims, &out, "a_claim", "b_claim", "c_claim"), code);
        free(out);
    }
    /* A part of no claims has certificates of none, in a folder that can be made. */
    snprintf(command, sizeof command, "touch '%s/claims'", folder);
    assert_int_equal(system(command), 0);
    assert_int_equal(CALL(verify, &good, &out, "-j1", "--shard", "1000/1000", "--certificates", folder), EXIT_INTERNAL);
    free(out);
    snprintf(command, sizeof command, "rm -r '%s'", folder);
    assert_int_equal(system(command), 0);
}

/* Several data and several results of a striking statement; a summary tells what is read from its print, too. */
static void lists_of_the_ledger(void **state)
{
    (void)state;
    claim list[] = {five, {.name = NULL}};
    const statement one[] = {
        {STATEMENT("1", "book", 1, "false", "", "", ""), .striking = 1, .links = FALSE_BY("three_is_five")},
        {.id = NULL}};
    const cagd_register reg = {list, one, chapters, figures, sources, NULL, printed_ids, NULL};
    char *out;
    assert_int_equal(CALL(ledger, &reg, &out, "-j1", "--striking", "1"), EXIT_AS_EXPECTED);
    assert_non_null(strstr(out, "\n      x = 3; y = 1/2 gives x + y = 7/2; x - y = 5/2\n"));
    free(out);
    for (int summary = 0; summary < 2; summary++) {
        assert_int_equal(CALL(ledger, &reg, &out, "-j1", summary ? "--summary" : "book:1"), EXIT_AS_EXPECTED);
        assert_non_null(strstr(out, "\n1 of 1 statements are read from their print as well"));
        assert_null(strstr(out, "creative telescoping"));
        free(out);
    }
}

/* A page tells the statements of its claim, and not of one whose name begins so or is the beginning of it. */
static void statements_are_those_of_the_claim(void **state)
{
    (void)state;
    static const char *const name[] = {"sum", "sum_is", "sum_is_double", "is_double"};
    enum { NAMES = sizeof name / sizeof *name };
    claim list[NAMES + 1] = {{.name = NULL}};
    statement of_each[NAMES + 1] = {{.id = NULL}};
    statement_link links[NAMES][2];
    char id[NAMES][16], *out;
    for (int k = 0; k < NAMES; k++) {
        list[k] = claims[0];
        list[k].name = name[k];
        links[k][0] = (statement_link){HOLDS_BY, name[k], NULL, "", NULL};
        links[k][1] = (statement_link){HOLDS_BY, NULL, NULL, NULL, NULL};
        snprintf(id[k], sizeof id[k], "book:%d", k + 1);
        of_each[k] = good_statements[0];
        of_each[k].id = id[k], of_each[k].links = links[k];
    }
    const cagd_register reg = {list, of_each, chapters, figures, sources, NULL, NULL, NULL};
    for (int k = 0; k < NAMES; k++) {
        char of_claim[32];
        snprintf(of_claim, sizeof of_claim, "first.%s", name[k]);
        assert_int_equal(CALL(show, &reg, &out, of_claim), EXIT_AS_EXPECTED);
        for (int m = 0; m < NAMES; m++)
            assert_int_equal(strstr(out, id[m]) != NULL, m == k);
        free(out);
    }
}

/* Each number type is named whose control was not caught, in their order, and none that did not run. */
static void controls_that_were_not_caught_are_named(void **state)
{
    (void)state;
    for (unsigned ran = 0; ran < 1u << NUMBER_TYPES; ran++)
        for (unsigned caught = 0; caught < 1u << NUMBER_TYPES; caught++) {
            claim_result r = {.claim = &claims[0], .outcome = HOLDS};
            char expected[256] = "holds, expected otherwise";
            for (number_type t = 0; t < NUMBER_TYPES; t++) {
                r.by[t].ran = ran >> t & 1, r.by[t].control_caught = caught >> t & 1;
                if (r.by[t].ran && !r.by[t].control_caught)
                    strcat(strcat(strcat(expected, "; "), number_type_name[t]), ": its control was not caught");
            }
            char *message = not_expected(&r);
            assert_string_equal(message, expected);
            free(message);
        }
}

/* All claims that are not as expected stand on the page of a statement, and all names in full, however long. */
static void everything_that_went_wrong_is_told(void **state)
{
    (void)state;
    char name[201], path[512], folder[] = "/tmp/test_command_XXXXXX", command[128], *out;
    memset(name, 'a', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    claim list[] = {{TEXTS("one_is_two", "two", 50), .body = {[RATIONAL_TYPE] = is_not_q}},
                    {TEXTS("square_is_product", "two", 90), .body = {[FIELD_TYPE] = square_f}},
                    {TEXTS("nobody_knows", "two", 60), .body = {[FIELD_TYPE] = is_unable_f}},
                    {TEXTS("never_caught", "two", 80), .body = {[RATIONAL_TYPE] = never_caught_q}},
                    {TEXTS("long", "two", 99), .body = {[FIELD_TYPE] = square_f}},
                    {.name = NULL}};
    list[4].name = name;
    char id[256];
    snprintf(id, sizeof id, "book:%s", name);
    statement of_these[] = {
        {STATEMENT("1", "book", 1, "", "", "", ""),
         .links = LINKS({HOLDS_BY, "one_is_two", NULL, "", NULL}, {HOLDS_BY, "square_is_product", NULL, "", NULL},
                        {HOLDS_BY, "nobody_knows", NULL, "", NULL}, {HOLDS_BY, "never_caught", NULL, "", NULL})},
        {STATEMENT("2", "book", 2, "", "", "", ""), .links = LINKS({HOLDS_BY, name, NULL, "", NULL})},
        {.id = NULL}};
    of_these[1].id = id;
    const cagd_register reg = {list, of_these, chapters, figures, sources, NULL, NULL, NULL};
    SAYS(EXIT_NOT_AS_EXPECTED, show, &reg, "show-all-wrong.txt", "book:1");
    assert_non_null(mkdtemp(folder));
    assert_int_equal(CALL(verify, &reg, &out, "-j1", "--certificates", folder), EXIT_NOT_AS_EXPECTED);
    assert_non_null(strstr(out, name));
    free(out);
    static const char *const kinds[] = {"claims", "book"};
    for (int k = 0; k < 2; k++) {
        snprintf(path, sizeof path, "%s/%s/%s.json", folder, kinds[k], name);
        char *text = text_of(path);
        assert_non_null(strstr(text, name));
        free(text);
    }
    snprintf(command, sizeof command, "rm -r '%s'", folder);
    assert_int_equal(system(command), 0);
    assert_int_equal(CALL(show, &reg, &out, name), EXIT_AS_EXPECTED);
    squeeze(out);
    snprintf(path, sizeof path, "first.%s (chapters/first/two.claims.h:99)", name);
    assert_non_null(strstr(out, path));
    snprintf(path, sizeof path, "book:%s Title of 2", name);
    assert_non_null(strstr(out, path));
    free(out);
}

/* An error that is no number is told as none, as an infinite one is. */
static void is_no_number_m(trial *T) { same_m(T, exact_m(0.0 / (T->degree + 0.0)), exact_m(1)); }
static void an_error_that_is_no_number(void **state)
{
    (void)state;
    claim list[] = {{TEXTS("is_no_number", "two", 95), .kind = DECISION, .body = {[DOUBLE_TYPE] = is_no_number_m}},
                    {.name = NULL}};
    const cagd_register reg = {list, bad_statements, chapters, figures, sources, NULL, NULL, NULL};
    char *out;
    assert_int_equal(CALL(verify, &reg, &out, "-j1", "--json"), EXIT_NOT_AS_EXPECTED);
    assert_non_null(strstr(out, "\"largest_error_over_bound\": null"));
    free(out);
}

/* Names and values are strings of YAML in TAP, whatever letters they have. */
static void shows_quotes_q(trial *T)
{
    show_text(T, "a \"name\\", "%s", "a \"value\": \\ β\n");
    agree(T, 0);
}
static void letters_of_yaml_are_escaped(void **state)
{
    (void)state;
    claim list[] = {{TEXTS("shows_quotes", "two", 95), .kind = DECISION, .body = {[RATIONAL_TYPE] = shows_quotes_q}},
                    {.name = NULL}};
    const cagd_register reg = {list, bad_statements, chapters, figures, sources, NULL, NULL, NULL};
    char *out;
    assert_int_equal(CALL(verify, &reg, &out, "-j1", "--tap"), EXIT_NOT_AS_EXPECTED);
    assert_non_null(strstr(out, "    - \"a \\\"name\\\\\": \"a \\\"value\\\": \\\\ β\\n\"\n"));
    free(out);
}

/* Values are told up to 300 columns. */
static char as_many[302];
static void shows_many_q(trial *T)
{
    show_text(T, "many", "%s", as_many);
    agree(T, 0);
}
static void long_values_are_cut(void **state)
{
    (void)state;
    claim list[] = {{TEXTS("shows_many", "two", 95), .kind = DECISION, .body = {[RATIONAL_TYPE] = shows_many_q}},
                    {.name = NULL}};
    const cagd_register reg = {list, bad_statements, chapters, figures, sources, NULL, NULL, NULL};
    for (size_t length = 299; length <= 301; length++) {
        memset(as_many, 'a', sizeof as_many - 1);
        as_many[length] = '\0';
        char *out, expected[400];
        assert_int_equal(CALL(verify, &reg, &out, "-j1", "shows_many"), EXIT_NOT_AS_EXPECTED);
        snprintf(expected, sizeof expected, "       many = %.300s%s\n", as_many, length > 300 ? " ..." : "");
        assert_non_null(strstr(out, expected));
        free(out);
    }
}

/* Whatever the texts of a case are, the file is XML. */
static void letters_of_xml_are_escaped(void **state)
{
    (void)state;
    char path[] = "/tmp/test_command_XXXXXX";
    int file = mkstemp(path);
    assert_true(file >= 0);
    close(file);
    struct junit *j = junit_new();
    junit_add(j, "a<b", "c&d", 0.25, NULL, NULL);
    junit_add(j, "e>f", "g\"h", 1.5, "i<j & k", "l > m \"n\"");
    junit_add(j, "o", "p", 0, "", "");
    assert_int_equal(junit_write(j, "suite", path), 0);
    char *text = text_of(path);
    assert_string_equal(text,
                        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                        "<testsuite name=\"suite\" tests=\"3\" failures=\"2\" errors=\"0\" time=\"1.750\">\n"
                        "  <testcase classname=\"a&lt;b\" name=\"c&amp;d\" time=\"0.250\"/>\n"
                        "  <testcase classname=\"e&gt;f\" name=\"g&quot;h\" time=\"1.500\">\n"
                        "    <failure message=\"i&lt;j &amp; k\">l &gt; m &quot;n&quot;</failure>\n  </testcase>\n"
                        "  <testcase classname=\"o\" name=\"p\" time=\"0.000\">\n"
                        "    <failure message=\"\"></failure>\n  </testcase>\n"
                        "</testsuite>\n");
    free(text);
    remove(path);
    assert_int_equal(junit_write(junit_new(), "none", "/dev/full"), -1);
}

/* What cannot be written ends with the status of it, whichever file or folder it is: of the claims, of a source, of its first and
 * its last statement; and what can be written is there. */
static void what_cannot_be_written_is_told(void **state)
{
    (void)state;
    static const struct {
        const char *before, *option;
        int good, lost; /* -1: of a source, or a rank, that the others do not have */
    } list[] = {{"true", "--certificates", EXIT_AS_EXPECTED, EXIT_AS_EXPECTED},
                {"touch claims", "--certificates", EXIT_INTERNAL, EXIT_INTERNAL},
                {"touch book", "--certificates", EXIT_INTERNAL, EXIT_INTERNAL},
                {"touch paper", "--certificates", EXIT_INTERNAL, -1},
                {"mkdir -p book/1.json", "--certificates", EXIT_INTERNAL, EXIT_INTERNAL},
                {"mkdir -p paper/8.json", "--certificates", EXIT_INTERNAL, -1},
                {"mkdir -p claims/variable_is_itself.json", "--certificates", EXIT_INTERNAL, EXIT_INTERNAL},
                {"ln -s /dev/full manifest.json", "--certificates", EXIT_INTERNAL, EXIT_INTERNAL},
                {"true", "--report", EXIT_AS_EXPECTED, EXIT_NOT_AS_EXPECTED},
                {"ln -s /dev/full ledger.txt", "--report", EXIT_INTERNAL, EXIT_INTERNAL},
                {"ln -s /dev/full summary.txt", "--report", EXIT_INTERNAL, EXIT_INTERNAL},
                {"ln -s /dev/full striking.txt", "--report", EXIT_INTERNAL, -1},
                {"ln -s /dev/full ledger.json", "--report", EXIT_INTERNAL, EXIT_INTERNAL}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        for (int is_lost = 0; is_lost < (list[k].lost < 0 ? 1 : 2); is_lost++) {
            char folder[] = "/tmp/test_command_XXXXXX", command[256], *out;
            assert_non_null(mkdtemp(folder));
            snprintf(command, sizeof command, "cd '%s' && %s", folder, list[k].before);
            assert_int_equal(system(command), 0);
            int code = CALL(verify, is_lost ? &lost : &good, &out, "-j1", list[k].option, folder);
            if (code != (is_lost ? list[k].lost : list[k].good))
                fail_msg("%s, %s, %d: %d", list[k].before, list[k].option, is_lost, code);
            free(out);
            snprintf(command, sizeof command, "rm -r '%s'", folder);
            assert_int_equal(system(command), 0);
        }
}

/* The pages say what was decided, by how many, and what speaks against it; how they are laid out is another matter. */
static void pages_say(void **state)
{
    (void)state;
    static const struct {
        const char *id, *says[6];
    } list[] = {
        {"book:1",
         {"It holds as printed: argued, each step for its own cases (the stated instance).",
          "An identity, proved for all points, all other positive data.", "A decision, argued for the stated instance.",
          "An identity, a decision and an argument in words decide it together.",
          "Ann Author et al.: 书 (A book), chapter 1, 1999"}},
        {"book:2",
         {"It fails as printed: a misprint (decided).",
          "It holds: argued for every n; computed for the stated instance.",
          "A decision and two arguments in words decide it together.", "because"}},
        {"book:3",
         {"It holds under more hypotheses: sampled for 24 random instances.", "An identity decides it.", "x > 0",
          "y > 0", "page 7"}},
        {"paper:4",
         {"A definition, with what is checked of it: argued for the stated instance.",
          "A decision, an argument in words and a citation check it together.", "a theorem", "A paper, pages 1 to 9"}},
        {"paper:5", {"A definition."}},
        {"paper:6",
         {"True: another way (2). False: one way (1).", "1 false one way decided by a counterexample",
          "2 true another way proved for all points, all other positive data"}},
        {"paper:7", {"It holds as printed: sampled for 24 random instances.", "the other"}},
        {"paper:8", {"It fails as printed: false (decided)."}},
        {"three_is_four",
         {"decided: a counterexample", "fails in 1 case, 1 comparison; control caught", "book:2", "paper:8"}},
        {"sum_is_double",
         {"sampled", "holds in 24 cases, 24 comparisons", "not refuted in 12 cases, 12 comparisons", "book:1",
          "paper:7"}},
        {"powers_commute", {"proved", "n = 2 to 4; all points", "holds in 3 cases, 6 comparisons; control caught"}},
    };
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        char *out;
        assert_int_equal(CALL(show, &good, &out, list[k].id), EXIT_AS_EXPECTED);
        squeeze(out);
        for (int m = 0; m < 6 && list[k].says[m] != NULL; m++)
            if (strstr(out, list[k].says[m]) == NULL)
                fail_msg("%s does not say '%s':\n%s", list[k].id, list[k].says[m], out);
        free(out);
    }
    char *out;
    assert_int_equal(CALL(show, &bad, &out, "one_is_two"), EXIT_NOT_AS_EXPECTED);
    assert_non_null(strstr(out, "fails in 1 case, 1 comparison; control caught"));
    assert_null(strstr(out, "a counterexample"));
    free(out);
    SAYS(EXIT_NOT_AS_EXPECTED, show, &bad, "show-bad-claim.txt", "one_is_two");
    SAYS(EXIT_NOT_AS_EXPECTED, show, &bad, "show-bad-statement.txt", "book:2");
    SAYS(EXIT_AS_EXPECTED, show, &good, "show-claim.json", "--json", "three_is_four");
    SAYS(EXIT_AS_EXPECTED, show, &good, "show-statement.json", "--json", "book:3");
}

/* The pages of all statements, of all claims and of a table, as they are laid out. */
/* What weakens a correction is told. */
static void words_for_a_correction_are_told(void **state)
{
    (void)state;
    SAYS(EXIT_AS_EXPECTED, show, &corrected, "show-corrected.txt", "book:1");
}

static void pages_are(void **state)
{
    (void)state;
    all_pages(&good, "show-good.txt");
    const cagd_register tables = {good_claims, table_statements, chapters, figures, sources,
                                  NULL,        printed_ids,      every_ids};
    SAYS(EXIT_AS_EXPECTED, show, &tables, "show-table.txt", "book:table");
    SAYS(EXIT_AS_EXPECTED, show, &tables, "show-entry.txt", "book:table-row-1-1");
    SAYS(EXIT_AS_EXPECTED, show, &tables, "show-edited.txt", "edited:1");
    SAYS(EXIT_AS_EXPECTED, show, &tables, "show-misprint.txt", "book:table-row-1-2");
    SAYS(EXIT_AS_EXPECTED, ledger, &tables, "ledger-table.txt", "-j1");
    SAYS(EXIT_AS_EXPECTED, ledger, &tables, "ledger-table.json", "-j1", "--json");
}

/* On a terminal of 42 columns and a wide one: outcomes of every kind, literature, ranks, readings. */
static void what_is_told_fits(void **state)
{
    (void)state;
    all_pages(&told, "show-told.txt");
    SAYS(EXIT_NOT_AS_EXPECTED, ledger, &told, "ledger-told.json", "--json");
    SAYS(EXIT_NOT_AS_EXPECTED, ledger, &told, "ledger-told-striking.txt", "--striking", "3");
    SAYS(EXIT_AS_EXPECTED, show, &told, "show-told-numbers.txt", "--numbers", "book:third-of-all");
    setenv("COLUMNS", "42", 1);
    all_pages(&told, "show-narrow.txt");
    SAYS(EXIT_NOT_AS_EXPECTED, ledger, &told, "ledger-narrow-striking.txt", "--striking", "1");
    SAYS(EXIT_AS_EXPECTED, ledger, &told, "ledger-narrow-one.txt", "--striking", "1", "book:1"); /* the fourth of one */
    const cagd_register tables = {good_claims, table_statements, chapters, figures, sources,
                                  NULL,        printed_ids,      every_ids};
    SAYS(EXIT_AS_EXPECTED, show, &tables, "show-narrow-table.txt", "book:table");
    unsetenv("COLUMNS");
}

/* The example of a statement, under the word for it: what one instance of a definition is, and of others that one is enough. */
static void examples_of_statements(void **state)
{
    (void)state;
    enum { COUNT = sizeof good_statements / sizeof *good_statements };
    static const char *const word[] = {"One instance is enough:", "An example:"};
    statement with[COUNT];
    memcpy(with, good_statements, sizeof with);
    cagd_register reg = good;
    reg.statements = with;
    for (int k = 0; k < COUNT - 1; k++) {
        char *out;
        (void)CALL(show, &reg, &out, with[k].id);
        assert_null(strstr(out, word[0]));
        assert_null(strstr(out, word[1]));
        free(out);
        with[k].example = "x = 17";
        (void)CALL(show, &reg, &out, with[k].id);
        squeeze(out);
        const char *at = strstr(out, word[with[k].is_definition]);
        if (at == NULL || strncmp(strchr(at, ':'), ": x = 17", 8) != 0 ||
            strstr(out, word[!with[k].is_definition]) != NULL)
            fail_msg("%s:\n%s", with[k].id, out);
        free(out);
    }
}

/* Everything that is written to files: certificates with their manifest, the report, JUnit. */
static void files_say(void **state)
{
    (void)state;
    static const char *const files[][2] = {{"manifest.json", "manifest.json"},
                                           {"claims/square_is_product.json", "certificate-field.json"},
                                           {"claims/sum_is_double_in_degrees.json", "certificate-none.json"},
                                           {"claims/powers_commute.json", "certificate-two-cases.json"},
                                           {"claims/sum_is_double.json", "certificate-rational.json"},
                                           {"claims/three_squared.json", "certificate-argued.json"},
                                           {"claims/variable_is_itself.json", "certificate-decision-in-field.json"},
                                           {"claims/three_is_four.json", "certificate-counterexample.json"},
                                           {"book/1.json", "certificate-holds.json"},
                                           {"book/2.json", "certificate-fails.json"},
                                           {"paper/4.json", "certificate-definition.json"},
                                           {"paper/6.json", "certificate-undecided.json"},
                                           {"ledger.txt", "report-ledger.txt"},
                                           {"summary.txt", "report-summary.txt"},
                                           {"striking.txt", "report-striking.txt"},
                                           {"ledger.json", "report-ledger.json"}};
    char folder[] = "/tmp/test_command_XXXXXX", path[4096], junit[4096], *out, *text;
    assert_non_null(mkdtemp(folder));
    snprintf(junit, sizeof junit, "%s/junit.xml", folder);
    assert_int_equal(CALL(verify, &good, &out, "-j1", "--certificates", folder, "--report", folder, "--junit", junit),
                     EXIT_AS_EXPECTED);
    free(out);
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        snprintf(path, sizeof path, "%s/%s", folder, files[k][0]);
        text = text_of(path);
        assert_expected(files[k][1], text);
        free(text);
    }
    /* What is open is not certified; every statement is counted. */
    assert_int_equal(CALL(verify, &bad, &out, "-j1", "--certificates", folder, "--report", folder, "--junit", junit),
                     EXIT_NOT_AS_EXPECTED);
    free(out);
    snprintf(path, sizeof path, "%s/manifest.json", folder);
    text = text_of(path);
    assert_expected("manifest-bad.json", text);
    free(text);
    text = text_of(junit);
    for (char *at = text; (at = strstr(at, "time=\"")) != NULL;) { /* how long it took is another matter */
        at += strlen("time=\"");
        memset(at, '0', strcspn(at, "\""));
    }
    for (char *at; (at = strstr(text, "\"00")) != NULL;)
        memmove(at + 1, at + 2, strlen(at + 2) + 1);
    assert_expected("junit-bad.xml", text);
    free(text);
    char command[4200];
    snprintf(command, sizeof command, "rm -r '%s'", folder);
    assert_int_equal(system(command), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        unit(exit_status_is_that_of_the_verdicts),
        unit(statements_are_counted),
        unit(reports_of_given_results),
        unit(digests),
        unit(verify_says),
        unit(ledger_says),
        unit(what_few_claims_have),
        unit(pages_say),
        unit(pages_are),
        unit(words_for_a_correction_are_told),
        unit(what_is_told_fits),
        unit(examples_of_statements),
        unit(files_say),
        unit(outcomes_of_every_kind),
        unit(every_role_is_told),
        unit(every_source_is_counted),
        unit(long_values_are_cut),
        unit(letters_of_yaml_are_escaped),
        unit(what_is_not_known_of_a_source),
        unit(the_three_most_striking_are_reported),
        unit(sources_are_found_by_their_whole_key),
        unit(an_error_that_is_no_number),
        unit(one_that_went_wrong_is_enough),
        unit(lists_of_the_ledger),
        unit(statements_are_those_of_the_claim),
        unit(controls_that_were_not_caught_are_named),
        unit(everything_that_went_wrong_is_told),
        unit(counterexamples_that_are_none),
        unit(letters_of_xml_are_escaped),
        unit(what_cannot_be_written_is_told),
    };
    for (claim *c = claims; c->name != NULL; c++)
        if (strcmp(c->name, "three_squared") == 0)
            c->argued = "words";
    told_claims[0].then = "the number of sides of a triangle, counted one after another from any of these, is four";
    told_claims[1].then = "the number of corners of a triangle, counted one after the other and from one, is four";
    told_claims[2].let = "$y = x$";
    told_claims[2].argued = "words", told_claims[2].argued_for = "every n";
    told_statements[2].letter = "k";
    memcpy(good_claims, claims, GOOD * sizeof *claims);
    setenv("ARGP_HELP_FMT", "", 1);
    return run_unit_tests(tests);
}
