/* test_judge_ends.c -- the judge at the ends of its ranges: more degrees than instances, degrees without end, more data than an int
 * has bits, a fault in one case alone, cases of which the lowest is the longest. */
#include "proofs-tests/unit/unit_exact.h"

#include "chapters/judge/case.h"
#include "chapters/judge/certificate.h"
#include "chapters/judge/memory_text.h"
#include "chapters/judge/run.h"
#include "chapters/judge/scope.h"
#include "chapters/judge/witness.h"
#include "chapters/judge/words.h"
#include "exact/words.h"

#include <malloc.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static claim_result *judge_one(const claim *c)
{
    const run_options options = {.jobs = 1};
    return judge_claims(&c, 1, &options);
}

/* ---- comparisons --------------------------------------------------------------------------------------- */

/* When the field has no room left its values are placeholders. */
static void in_a_crowded_field_nothing_is_refuted(void **state)
{
    (void)state;
    static const claim c = {.name = "crowded", .scope = ""};
    trial T = {.claim = &c};
    region_faults = FAULT_CROWDED;
    same_q(&T, from_int_q(1), from_int_q(2));
    assert_int_equal(T.compared, 1);
    assert_int_equal(T.outcome, HOLDS);
    assert_int_equal(judged_case(&T), UNDECIDED);
    region_faults = 0;
}

/* A NaN is the worst error of all. */
static void a_nan_is_the_worst(void **state)
{
    (void)state;
    static const claim c = {.name = "nan", .scope = ""};
    trial T = {.claim = &c};
    same_m(&T, exact_m(NAN), exact_m(1));
    assert_true(isnan(T.worst));
    forget_exhibits(T.shown, T.exhibits);
}

/* The width that counts is that of the difference, whichever side it comes from. */
static void the_widest_difference_counts(void **state)
{
    (void)state;
    static const claim c = {.name = "wide", .scope = ""};
    num_i one = from_int_i(1), third = from_ratio_i(1, 3), wide = mul_i(sub_i(third, third), from_int_i(7));
    for (int turned = 0; turned < 2; turned++) {
        trial T = {.claim = &c};
        same_i(&T, turned ? add_i(one, wide) : one, turned ? one : add_i(one, wide));
        assert_true(T.worst > width_i(one) && T.worst >= width_i(wide));
        double worst = T.worst;
        same_i(&T, one, one);
        assert_true(T.worst == worst);
        forget_exhibits(T.shown, T.exhibits);
    }
}

/* ---- cases --------------------------------------------------------------------------------------------- */

static void unable_in_degree_one_i(trial *T)
{
    num_i x = unknown_i(T, "x", 0);
    if (T->degree == 1 && !T->planted)
        region_faults |= FAULT_UNABLE;
    same_i(T, add_i(x, x), mul_i(from_int_i(T->planted ? 3 : 2), x));
}
/* Of twelve cases, of the degrees 1 and 2 in turn, the last is of degree 2. */
static void a_fault_of_an_early_case_is_kept(void **state)
{
    (void)state;
    const claim c = {.name = "unable in degree one",
                     .scope = "",
                     .degree_low = 1,
                     .degree_high = 2,
                     .degree_sampled = 2,
                     .body = {[INTERVAL_TYPE] = unable_in_degree_one_i}};
    claim_result *r = judge_one(&c);
    assert_int_equal(r->by[INTERVAL_TYPE].cases, 12);
    assert_int_equal(r->by[INTERVAL_TYPE].faults, FAULT_UNABLE);
    assert_true(r->by[INTERVAL_TYPE].control_caught);
    assert_false(r->as_expected);
    free_results(r, 1);
}

/* An early case that could not be computed is not forgotten for those that hold behind it, and a late one not for those before it. */
static int unable_at;
static void unable_somewhere_q(trial *T)
{
    if (T->degree == unable_at && !T->planted)
        region_faults |= FAULT_UNABLE;
    num_q x = unknown_q(T, "x", 0);
    same_q(T, add_q(x, x), mul_q(from_int_q(T->planted ? 3 : 2), x));
}
static void one_case_that_is_undecided_counts(void **state)
{
    (void)state;
    for (unable_at = 1; unable_at <= 4; unable_at++) {
        const claim c = {.name = "unable somewhere",
                         .scope = "",
                         .kind = DECISION,
                         .degree_low = 1,
                         .degree_high = 3,
                         .degree_sampled = 3,
                         .body = {[RATIONAL_TYPE] = unable_somewhere_q}};
        claim_result *r = judge_one(&c);
        assert_int_equal(r->by[RATIONAL_TYPE].outcome, unable_at > 3 ? HOLDS : UNDECIDED);
        assert_int_equal(r->outcome, unable_at > 3 ? HOLDS : UNDECIDED);
        assert_int_equal(r->as_expected, unable_at > 3);
        free_results(r, 1);
    }
}

static void degree_q(trial *T) { same_q(T, from_int_q(T->degree), from_int_q(T->planted ? -1 : T->degree)); }
static void every_degree_has_an_instance(void **state)
{
    (void)state;
    const claim c = {.name = "degrees",
                     .scope = "",
                     .degree_low = 1,
                     .degree_high = 30,
                     .degree_sampled = 30,
                     .body = {[RATIONAL_TYPE] = degree_q}};
    claim_result *r = judge_one(&c);
    assert_true(r->as_expected);
    assert_int_equal(r->by[RATIONAL_TYPE].cases, 30);
    assert_int_equal(r->by[RATIONAL_TYPE].degree_high, 30);
    free_results(r, 1);
}

/* The degree is shown once, and an order as it is. */
static void the_degree_is_shown_once(void **state)
{
    (void)state;
    for (int order = 0; order < 2; order++)
        for (int shown_before = 0; shown_before < 2; shown_before++) {
            const claim c = {
                .name = "shown", .scope = "", .letter = order ? "k" : "n", .degree_low = 1, .degree_high = 5};
            trial T = {.claim = &c, .degree = 3};
            if (shown_before)
                show_text(&T, c.letter, "%d", 7);
            show_degree(&c, &T);
            assert_int_equal(T.exhibits, 1);
            assert_string_equal(T.shown[0].name, c.letter);
            assert_string_equal(T.shown[0].value, shown_before ? "7" : "3");
            forget_exhibits(T.shown, T.exhibits);
        }
}

/* A claim without a letter has degrees n. */
static void the_letter_is_n_where_none_is_given(void **state)
{
    (void)state;
    static const char *const letter[] = {NULL, "", "n"};
    for (int k = 0; k < 3; k++) {
        const claim c = {.name = "shown", .scope = "", .letter = letter[k], .degree_low = 1, .degree_high = 5};
        trial T = {.claim = &c, .degree = 3};
        show_degree(&c, &T);
        assert_int_equal(T.exhibits, 1);
        assert_string_equal(T.shown[0].name, "n");
        forget_exhibits(T.shown, T.exhibits);
    }
}

/* Degree 0 is one as any other; a claim without degrees has none. */
static void degree_nought_is_shown(void **state)
{
    (void)state;
    for (int last = 0; last < 2; last++) {
        const claim c = {.name = "shown", .scope = "", .degree_low = 0, .degree_high = last};
        trial T = {.claim = &c, .degree = 0};
        show_degree(&c, &T);
        assert_int_equal(T.exhibits, last);
        if (last > 0)
            assert_string_equal(T.shown[0].value, "0");
        forget_exhibits(T.shown, T.exhibits);
    }
}

static void a_number_without_index_is_a_variable_of_the_field(void **state)
{
    (void)state;
    static const claim c = {.name = "whole", .scope = ""};
    trial T = {.claim = &c};
    field_open(4);
    assert_true(equal_f(whole_f(&T, "m", 0, 5), variable_f("m")));
    assert_true(equal_f(unknown_f(&T, "a", ALONE), variable_f("a")));
    assert_true(equal_f(positive_f(&T, "b", ALONE), variable_f("b")));
    assert_true(equal_f(unknown_f(&T, "a", 7), variable_f("a7")));
    field_close();
}

/* ---- data ---------------------------------------------------------------------------------------------- */

enum { ENTRIES = 34 };
static char entry_name[ENTRIES][4];
static int left_out;
static void ask_q(trial *T)
{
    num_q sum = from_int_q(0);
    for (int k = 0; k < ENTRIES; k++)
        if (k != left_out)
            sum = add_q(sum, given_q(T, entry_name[k]));
    same_q(T, sum, from_int_q(T->planted ? 0 : left_out < 0 ? ENTRIES : ENTRIES - 1));
}
static void entries_beyond_the_bits_of_an_int(void **state)
{
    (void)state;
    static const char *const one[] = {"1"};
    datum list[ENTRIES + 1] = {{.name = NULL}};
    for (int k = 0; k < ENTRIES; k++) {
        snprintf(entry_name[k], sizeof entry_name[k], "x%d", k);
        list[k] = (datum){.name = entry_name[k], .text = "1", .rows = 1, .columns = 1, .value = one};
    }
    list[ENTRIES] = (datum){.name = NULL};
    const claim c = {.name = "entries", .scope = "", .kind = DECISION, .data = list, .body = {[RATIONAL_TYPE] = ask_q}};
    for (left_out = -1; left_out < ENTRIES; left_out++) {
        claim_result *r = judge_one(&c);
        assert_int_equal(r->as_expected, left_out < 0);
        free_results(r, 1);
    }
}

/* ---- scopes -------------------------------------------------------------------------------------------- */

static char no_names[] = "", two_names[] = "x1 x10", tenth[] = "x10", knot_name[] = "t3";
#define IN_FIELD(c, low, high)                                                                                         \
    {                                                                                                                  \
        .claim = &c, .as_expected = 1, .evidence = PROVED, .computed = PROVED,                                         \
        .by =                                                                                                          \
        { [FIELD_TYPE] = {                                                                                             \
              .ran = 1, .degree_low = low, .degree_high = high, .variables = no_names, .positive = no_names} }         \
    }
#define SAMPLES(c, count)                                                                                              \
    {                                                                                                                  \
        .claim = &c, .as_expected = 1, .evidence = SAMPLED, .computed = SAMPLED, .by = {                               \
            [RATIONAL_TYPE] = {.ran = 1, .cases = count}                                                               \
        }                                                                                                              \
    }
static const claim from_one = {.name = "from_one", .scope = "", .all_degrees = 1, .degree_low = 1},
                   from_none = {.name = "from_none", .scope = "", .all_degrees = 1},
                   orders = {.name = "orders", .scope = "", .letter = "k", .all_degrees = 1, .degree_low = 2},
                   orders_from_one = {.name = "orders_from_one",
                                      .scope = "",
                                      .letter = "k",
                                      .all_degrees = 1,
                                      .degree_low = 1},
                   four_orders = {.name = "four_orders", .scope = "", .letter = "k"},
                   tenth_weight = {.name = "tenth_weight", .scope = "", .over = "x10: weight; x#: lengths"},
                   these_knots = {.name = "these_knots", .scope = "these knots", .over = "t#: knots"},
                   spaced = {.name = "spaced", .scope = "", .over = "x# : lengths ; y#: weights"},
                   the_knots = {.name = "the_knots", .scope = "the knots", .over = "t#: knots"},
                   low = {.name = "low", .scope = ""}, high = {.name = "high", .scope = ""},
                   few = {.name = "few", .scope = ""}, many = {.name = "many", .scope = ""},
                   against = {.name = "against", .kind = COUNTEREXAMPLE, .scope = ""};
static char stated[] = "the stated instance";
static const claim_result results[] = {
    IN_FIELD(from_one, 1, 4),
    IN_FIELD(from_none, 0, 4),
    IN_FIELD(orders, 2, 4),
    IN_FIELD(orders_from_one, 1, 4),
    IN_FIELD(four_orders, 1, 4),
    {.claim = &tenth_weight,
     .as_expected = 1,
     .evidence = PROVED,
     .computed = PROVED,
     .by = {[FIELD_TYPE] = {.ran = 1, .variables = two_names, .positive = tenth}}},
    {.claim = &these_knots,
     .as_expected = 1,
     .evidence = PROVED,
     .computed = PROVED,
     .by = {[FIELD_TYPE] = {.ran = 1, .variables = knot_name, .positive = no_names}}},
    {.claim = &spaced,
     .as_expected = 1,
     .evidence = PROVED,
     .computed = PROVED,
     .by = {[FIELD_TYPE] = {.ran = 1, .variables = two_names, .positive = no_names}}},
    {.claim = &the_knots,
     .as_expected = 1,
     .evidence = PROVED,
     .computed = PROVED,
     .by = {[FIELD_TYPE] = {.ran = 1, .variables = knot_name, .positive = no_names}}},
    IN_FIELD(low, 1, 4),
    IN_FIELD(high, 7, 8),
    SAMPLES(few, 12),
    SAMPLES(many, 1000),
    {.claim = &against, .as_expected = 1, .outcome = FAILS, .evidence = DECIDED, .scope = stated}};
enum { RESULTS = sizeof results / sizeof *results };

static void assert_scope(const char *name, const char *letter, const char *expected)
{
    finding f = finding_of(result_of(name, results, RESULTS), letter);
    assert_string_equal(f.scope, expected);
    free_finding(&f);
}
static void degrees_without_end(void **state)
{
    (void)state;
    assert_scope("from_one", "n", "every n from 1 on");
    assert_scope("from_none", "n", "every n");
    assert_scope("orders", "k", "every k from 2 on"); /* the order, one more than the degree, stays without end */
    assert_scope("orders", "n", "every n from 1 on");
}

/* What w# means has an index; of the letters those of a statement are left, the first of the Greek ones as well. */
static void names_and_what_they_stand_for(void **state)
{
    (void)state;
    static const struct {
        const char *over, *variables, *left, *words, *positive;
    } list[] = {{"w#: weights", "w0 w1", NULL, "all weights", NULL},
                {"w#: weights", "w w0", NULL, "all weights, all other data", NULL},
                {"alpha; beta", "alpha beta", NULL, "every α and β", NULL},
                {"alpha; beta", "alpha beta", "x alpha", "every α", NULL},
                {"alpha; beta", "alpha beta", "beta", "every β", NULL},
                {"e: ε; beta", "e beta", "varepsilon x", "every ε", NULL}, /* the last one of all */
                {"w#: weights; v#: equal weights", "w0 v0", NULL, "all equal weights", NULL},
                {"w#: widths; v#: equal weights", "w0 v0", NULL, "all widths and equal weights", NULL},
                {"w#; beta#", "w0 w1 beta2", NULL, "all w and β", NULL}, /* which stand for themselves */
                {"a; b; c", "a b c", "b", "every b, every positive a",
                 "a"}}; /* what is positive is asked for, whoever named it */
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        const claim c = {.name = "names", .scope = "", .over = list[k].over, .argued_for = ""};
        char variables[32], positive[8] = "";
        strcpy(variables, list[k].variables);
        if (list[k].positive != NULL)
            strcpy(positive, list[k].positive);
        claim_result r = {.claim = &c, .computed = PROVED, .evidence = PROVED};
        r.by[FIELD_TYPE] = (type_result){.ran = 1, .outcome = HOLDS, .variables = variables, .positive = positive};
        scope s = scope_of(&r);
        if (list[k].left != NULL)
            leave_letters(&s, list[k].left);
        char *words = scope_words(&s, "n");
        assert_string_equal(words, list[k].words);
        free(words);
        free_scope(&s);
    }
}

/* Two that are about different things, the first of them, too. */
static void data_of_different_kinds_are_mixed(void **state)
{
    (void)state;
    static const char *const over[] = {"x#: points", "x#: nodes", "x#: points; w#: weights"};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const claim c[] = {{.name = "one", .scope = "", .over = over[i], .argued_for = ""},
                               {.name = "other", .scope = "", .over = over[j], .argued_for = ""}};
            scope s[2];
            for (int k = 0; k < 2; k++) {
                char variables[] = "x0 w0", points[] = "x0", positive[] = "";
                claim_result r = {.claim = &c[k], .computed = PROVED, .evidence = PROVED};
                r.by[FIELD_TYPE] = (type_result){.ran = 1,
                                                 .outcome = HOLDS,
                                                 .variables = (k == 0 ? i : j) == 2 ? variables : points,
                                                 .positive = positive};
                s[k] = scope_of(&r);
            }
            meet_scope(&s[0], &s[1]);
            assert_int_equal(s[0].mixed, (i == 1) != (j == 1));
            free_scope(&s[0]);
            free_scope(&s[1]);
        }
}

/* Where something is proved, and something sampled, the instances stay. */
static void what_is_proved_has_no_instances(void **state)
{
    (void)state;
    for (int turned = 0; turned < 2; turned++) {
        scope a = {.instances = turned ? 0 : 12}, b = {.instances = turned ? 12 : 0};
        meet_scope(&a, &b);
        assert_int_equal(a.instances, 12);
        free_scope(&a);
        free_scope(&b);
    }
}

static void of_instances_the_fewest_are_told(void **state)
{
    (void)state;
    for (int turned = 0; turned < 2; turned++) {
        const statement_link links[] = {{HOLDS_BY, turned ? "many" : "few", NULL, "", NULL},
                                        {HOLDS_BY, turned ? "few" : "many", NULL, "", NULL},
                                        {HOLDS_BY, NULL, NULL, NULL, NULL}};
        const statement s = {.id = "source:1", .links = links};
        statement_result r = derive(&s, results, RESULTS);
        assert_string_equal(r.as_printed.scope, "12 random instances");
        free_statement_result(&r);
    }
}

static void a_correction_needs_a_case(void **state)
{
    (void)state;
    const statement_link links[] = {{REFUTED_BY, "against", NULL, "", NULL},
                                    {CORRECTED_BY, "low", NULL, "", NULL},
                                    {CORRECTED_BY, "high", NULL, "", NULL},
                                    {HOLDS_BY, NULL, NULL, NULL, NULL}};
    const statement s = {.id = "source:1", .links = links};
    statement_result r = derive(&s, results, RESULTS);
    assert_false(r.as_expected);
    assert_int_equal(r.verdict, VERDICT_OPEN);
    assert_string_equal(r.as_corrected.scope, "no n");
    free_statement_result(&r);
}

/* The order k is one more than the degree, from the first degree on. */
static void orders_are_one_more(void **state)
{
    (void)state;
    assert_scope("orders_from_one", "k", "every k");
    assert_scope("orders_from_one", "n", "every n");
    assert_scope("four_orders", "k", "k = 1 to 4");
    assert_scope("four_orders", "n", "n = 0 to 3");
}

/* n and p are letters of the degree: what is said with one of them meets what is said with the other, or with none. */
static void letters_of_the_degree(void **state)
{
    (void)state;
    const char *const letter[] = {NULL, "", "n", "p"};
    enum { LETTERS = sizeof letter / sizeof *letter };
    for (int one = 0; one < LETTERS; one++)
        for (int other = 0; other < LETTERS; other++) {
            const claim c[] = {{.name = "one", .scope = "", .letter = letter[one]},
                               {.name = "other", .scope = "", .letter = letter[other]}};
            const claim_result r[] = {IN_FIELD(c[0], 1, 4), IN_FIELD(c[1], 2, 9)};
            const statement_link links[] = {{HOLDS_BY, "one", NULL, "", NULL},
                                            {HOLDS_BY, "other", NULL, "", NULL},
                                            {HOLDS_BY, NULL, NULL, NULL, NULL}};
            const statement s = {.id = "source:1", .links = links};
            statement_result both = derive(&s, r, 2);
            assert_string_equal(both.as_printed.scope, "n = 2 to 4");
            free_statement_result(&both);
        }
}

/* In which cases a variable is asked for, and which names begin as another one, is no matter: each is told, and once. */
static const int asked_for[][3] = {{12, 12, 12}, {1, 1, 1}, {2, 12, 21}, {10, 100, 120}, {3, 123, 3}, {9, 90, 99}};
enum { ASKING = sizeof asked_for / sizeof *asked_for };
static void of_many_names_f(trial *T)
{
    num_f product = from_int_f(1);
    for (int k = 0; k < 3; k++)
        product = mul_f(product, unknown_f(T, "x", asked_for[T->degree - 1][k]));
    same_f(T, product, T->planted ? from_int_f(1) : product);
}
static void every_variable_of_any_case_is_told(void **state)
{
    (void)state;
    const claim c = {
        .name = "names", .scope = "", .body = {[FIELD_TYPE] = of_many_names_f}, .degree_low = 1, .degree_high = ASKING};
    claim_result *r = judge_one(&c);
    assert_true(r->as_expected);
    int told[128] = {0};
    for (const char *at = r->by[FIELD_TYPE].variables; *at != '\0'; at += strspn(at, " ")) {
        char *end;
        assert_int_equal(*at, 'x');
        told[strtol(at + 1, &end, 10)]++;
        at = end;
    }
    for (int index = 0; index < 128; index++) {
        int wanted = 0;
        for (int k = 0; k < ASKING * 3; k++)
            wanted |= asked_for[k / 3][k % 3] == index;
        assert_int_equal(told[index], wanted);
    }
    free_results(r, 1);
}

/* A name is among others as a whole: x1 is not, where x10 is. */
static void names_are_whole_words(void **state)
{
    (void)state;
    assert_scope("tenth_weight", "n", "all lengths, every positive weight");
    assert_scope("these_knots", "n", "these knots; all knots");
    assert_scope("the_knots", "n", "the knots");
    assert_scope("spaced", "n", "all lengths");
}

static const char *const greek_letters[][2] = {{"alpha", "α"}, {"beta", "β"},  {"gamma", "γ"},     {"lambda", "λ"},
                                               {"mu", "μ"},    {"tau", "τ"},   {"sigma", "σ"},     {"theta", "θ"},
                                               {"rho", "ρ"},   {"omega", "ω"}, {"delta", "δ"},     {"kappa", "κ"},
                                               {"chi", "χ"},   {"nu", "ν"},    {"varepsilon", "ε"}};
enum { GREEK = sizeof greek_letters / sizeof *greek_letters };

/* What a phrase says of a Greek letter is not said once more of the variable that TeX writes out. */
static void every_greek_letter_is_known(void **state)
{
    (void)state;
    for (size_t k = 0; k < GREEK; k++) {
        char name[16], phrase[16];
        snprintf(name, sizeof name, "%s", greek_letters[k][0]);
        snprintf(phrase, sizeof phrase, "0 < %s < 1", greek_letters[k][1]);
        const claim c = {.name = "greek", .scope = phrase, .over = name};
        claim_result r = IN_FIELD(c, 0, 0);
        r.by[FIELD_TYPE].variables = name;
        finding f = finding_of(&r, "n");
        assert_string_equal(f.scope, phrase);
        free_finding(&f);
    }
}

/* A relation says for which values of t where t stands by itself: no part of a word or a command, without an index or an argument. */
static void a_letter_stands_by_itself(void **state)
{
    (void)state;
    static const struct {
        const char *phrase;
        int says;
    } list[] = {{"0 < t < 1", 1}, {"$t>0$", 1},     {"t > 0", 1},      {"s < t", 1},    {"f(t) > 0", 1},
                {"st, t > 0", 1}, {"\\tau > 0", 0}, {"\\t > 0", 0},    {"at s > 0", 0}, {"s > st", 0},
                {"ts < 1", 0},    {"t_1 > 0", 0},   {"{t} > 0", 1},    {"|t| > 0", 1},  {"~t~ > 0", 1},
                {"@t > 0", 1},    {"[t] > 0", 1},   {"t(s) > 0", 0},   {"βt > 0", 0},   {"tβ > 0", 0},
                {"every st", 0},  {"every t", 1},   {"of t alone", 0}, {"t ≤ 1", 1},    {"t ≥ 0", 1},
                {"$t\\le1$", 1},  {"$t\\ge0$", 1},  {"t = 1", 0},      {"t ≠ 0", 0},    {"not every t", 0}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        char name[] = "t";
        const claim c = {.name = "letter", .scope = list[k].phrase, .over = "t"};
        claim_result r = IN_FIELD(c, 0, 0);
        r.by[FIELD_TYPE].variables = name;
        finding f = finding_of(&r, "n");
        const char *told = strstr(f.scope, list[k].phrase);
        assert_non_null(told);
        if ((strstr(told + strlen(list[k].phrase), "every t") == NULL) != list[k].says)
            fail_msg("%s", f.scope);
        free_finding(&f);
    }
}

static void a_condition_that_says_nothing_is_none(void **state)
{
    (void)state;
    scope s = {.within = NULL};
    add_condition(&s, NULL);
    add_condition(&s, "");
    assert_int_equal(s.where.count, 0);
    add_condition(&s, "t > 0");
    assert_int_equal(s.where.count, 1);
    free_scope(&s);
}

/* A decision runs in the degrees that it is for: what is sampled is an identity. */
static void decisions_have_no_degrees_to_sample(void **state)
{
    (void)state;
    const claim c = {.name = "decided",
                     .scope = "",
                     .kind = DECISION,
                     .degree_low = 1,
                     .degree_high = 3,
                     .degree_sampled = 1,
                     .body = {[RATIONAL_TYPE] = degree_q}};
    claim_result *r = judge_one(&c);
    assert_true(r->as_expected);
    assert_int_equal(r->by[RATIONAL_TYPE].cases, 3);
    assert_int_equal(r->by[RATIONAL_TYPE].degree_low, 1);
    assert_int_equal(r->by[RATIONAL_TYPE].degree_high, 3);
    free_results(r, 1);
}

static void a_result_has_a_sign(void **state)
{
    (void)state;
    static const char *const minus[] = {"-3"};
    static const datum list[] = {
        {.name = "m", .text = "-3", .rows = 1, .columns = 1, .value = minus, .place = IN_RESULT}, {.name = NULL}};
    static const claim c = {.name = "minus", .scope = "", .kind = DECISION, .data = list};
    for (int m = -3; m <= 3; m += 6) {
        trial T = {.claim = &c};
        found_whole(&T, "m", m);
        assert_int_equal(T.mistaken != 0, m > 0);
        forget_exhibits(T.shown, T.exhibits);
    }
}

/* ---- scopes made by hand ------------------------------------------------------------------------------- */

/* The scope of a claim that says so, of the degrees to `high` where that is not 0, with these variables of the field. */
static scope scope_that_says(const char *said, int last, const char *over, const char *variables)
{
    const claim c = {.name = "says", .scope = said, .over = over};
    char names[64];
    snprintf(names, sizeof names, "%s", variables);
    claim_result r = IN_FIELD(c, 1, last);
    r.by[FIELD_TYPE].variables = names;
    return scope_of(&r);
}

static void assert_words(const scope *s, const char *letter, const char *expected)
{
    char *words = scope_words(s, letter);
    assert_string_equal(words, expected);
    free(words);
}

/* Phrases in every order: apart are two of which each has one that the other one lacks, wherever it stands. */
static void a_phrase_is_looked_for_in_the_whole_list(void **state)
{
    (void)state;
    static const char *const lists[] = {"a",    "b",       "c",       "a; b",    "b; a",    "a; c",    "c; a",   "b; c",
                                        "c; b", "a; b; c", "b; c; a", "c; a; b", "a; c; b", "c; b; a", "b; a; c"};
    enum { LISTS = sizeof lists / sizeof *lists };
    for (int i = 0; i < LISTS; i++)
        for (int j = 0; j < LISTS; j++) {
            int alone[2] = {0}, different = 0;
            for (char c = 'a'; c <= 'c'; c++) {
                int mine = strchr(lists[i], c) != NULL, yours = strchr(lists[j], c) != NULL;
                alone[0] |= mine && !yours;
                alone[1] |= yours && !mine;
                different += mine || yours;
            }
            scope s = scope_that_says(lists[i], 4, "", ""), other = scope_that_says(lists[j], 4, "", "");
            meet_scope(&s, &other);
            assert_int_equal(s.apart, alone[0] && alone[1]);
            assert_int_equal(s.said.count, different);
            free_scope(&s);
            free_scope(&other);
        }
}

/* What is stated is so wherever the phrase stands; beside it data alone are more. */
static void what_is_stated_is_apart_from_what_is_more(void **state)
{
    (void)state;
    static const struct {
        const char *said[2];
        int high[2];
        const char *variables;
        int apart;
    } list[] = {{{"the stated arc", ""}, {0, 0}, "w0", 1},
                {{"the stated arc", ""}, {0, 0}, "", 0}, /* which is about everything */
                {{"the stated arc", ""}, {0, 4}, "", 1},
                {{"the stated arc", ""}, {4, 0}, "w0", 1},
                {{"the stated arc", ""}, {4, 4}, "w0", 1},
                {{"the stated arc", ""}, {4, 4}, "", 0},
                {{"a; the stated arc", "a"}, {0, 0}, "", 1},
                {{"a; b; the stated arc", "a"}, {0, 0}, "", 1},
                {{"the stated arc; a", "a"}, {0, 0}, "", 1},
                {{"a; the stated arc", "a"}, {4, 4}, "", 0},
                {{"the stated arc", "the stated arc; a"}, {0, 0}, "w0", 0},
                {{"the stated arc", "a; the stated arc"}, {0, 0}, "w0", 0}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        for (int turned = 0; turned < 2; turned++) {
            scope s = scope_that_says(list[k].said[0], list[k].high[0], "", ""),
                  other = scope_that_says(list[k].said[1], list[k].high[1], "w#: weights", list[k].variables);
            meet_scope(turned ? &other : &s, turned ? &s : &other);
            if ((turned ? other : s).apart != list[k].apart)
                fail_msg("%zu, turned %d", k, turned);
            free_scope(&s);
            free_scope(&other);
        }
}

/* Of two scopes that have data each has some that the other one lacks, by their whole names; data without a name are of one kind. */
static void data_are_told_apart_by_their_whole_names(void **state)
{
    (void)state;
    static const char *const names[] = {"a",   "b",   "c",     "d",       "a b", "b c",
                                        "a d", "c d", "a b c", "a b c d", "b a", "d c a"};
    enum { NAMES = sizeof names / sizeof *names };
    for (int i = 0; i < NAMES; i++)
        for (int j = 0; j < NAMES; j++) {
            int alone[2] = {0};
            for (char c = 'a'; c <= 'd'; c++) {
                int mine = strchr(names[i], c) != NULL, yours = strchr(names[j], c) != NULL;
                alone[0] |= mine && !yours;
                alone[1] |= yours && !mine;
            }
            scope s = scope_that_says("", 4, "a: gap; b: gaps; c: gaps above", names[i]),
                  other = scope_that_says("", 4, "a: gap; b: gaps; c: gaps above", names[j]);
            meet_scope(&s, &other);
            assert_int_equal(s.mixed, alone[0] && alone[1]);
            free_scope(&s);
            free_scope(&other);
        }
}

/* What a phrase says of data it says wherever it stands; and so does a condition of a letter. */
static void what_is_said_of_data_behind_other_phrases(void **state)
{
    (void)state;
    static const char *const said[] = {"the knots", "0 < s < 1"};
    for (int k = 0; k < 2; k++)
        for (int place = 0; place < 3; place++) {
            char phrases_of[64], expected[128];
            snprintf(phrases_of, sizeof phrases_of, "%s; %s; %s", place == 0 ? said[k] : "a",
                     place == 1 ? said[k] : "b", place == 2 ? said[k] : "c");
            scope s = scope_that_says(phrases_of, 0, "t#: knots; s", "t1 s");
            snprintf(expected, sizeof expected, "%s; %s", phrases_of, k == 0 ? "every s" : "all knots");
            assert_words(&s, "n", expected);
            add_condition(&s, "s > 7");
            add_condition(&s, "u > 7");
            snprintf(expected, sizeof expected, "%s; %s%s", phrases_of, k == 0 ? "" : "all knots, ",
                     "where s > 7, and u > 7");
            assert_words(&s, "n", expected);
            free_scope(&s);
        }
}

/* The rows of the table are of whole phrases, the first and the last as any other; every phrase that is wider gives way. */
static void rows_are_of_whole_phrases(void **state)
{
    (void)state;
    static const char table[] = "ab | cd; ef|gh; ab c | c; b | dd; x | last";
    static const struct {
        const char *one, *other, *left;
        int apart;
    } list[] = {{"ab", "cd", "ab", 0},       {"ab", "c", "ab; c", 1},           {"a", "cd", "a; cd", 1},
                {"abc", "cd", "abc; cd", 1}, {"ab", "cde", "ab; cde", 1},       {"ab c", "c", "ab c", 0},
                {"ab", "d", "ab; d", 1},     {"b", "cd", "b; cd", 1},           {"b", "dd", "b", 0},
                {"x", "last", "x", 0},       {"xx", "last", "xx; last", 1},     {"x", "las", "x; las", 1},
                {"y; cd", "ab", "y; ab", 0}, {"y; z; cd", "ab", "y; z; ab", 0}, {"last; y; last", "x", "x; y", 0},
                {"ab", "y; cd", "ab; y", 0}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        for (int knows = 1; knows < 4; knows++) {
            scope s = scope_that_says(list[k].one, 0, "", ""), other = scope_that_says(list[k].other, 0, "", "");
            s.within = knows & 1 ? table : NULL;
            other.within = knows & 2 ? table : NULL;
            meet_scope(&s, &other);
            assert_int_equal(s.apart, list[k].apart);
            int found_all = 0;
            char left[64];
            snprintf(left, sizeof left, "%s", list[k].left);
            for (char *at = left, *rest; at != NULL; at = rest, found_all++) {
                if ((rest = strstr(at, "; ")) != NULL)
                    *rest = '\0', rest += 2;
                int is_there = 0;
                for (int m = 0; m < s.said.count; m++)
                    is_there |= strcmp(s.said.at[m], at) == 0;
                if (!is_there)
                    fail_msg("%s and %s: %s", list[k].one, list[k].other, at);
            }
            assert_int_equal(s.said.count, found_all);
            free_scope(&s);
            free_scope(&other);
        }
}

/* Which phrases are narrower is kept from the claim that knows it, wherever that one stands. */
static void the_table_is_kept(void **state)
{
    (void)state;
    static const char table[] = "narrow | wide";
    for (int place = 0; place < 3; place++) {
        scope s = {.within = NULL};
        for (int k = 0; k < 3; k++) {
            const scope other = {.within = k == place ? table : NULL};
            meet_scope(&s, &other);
        }
        assert_ptr_equal(s.within, table);
        add_condition(&s, "wide");
        add_condition(&s, "narrow");
        add_condition(&s, "wide");
        assert_words(&s, "n", "where narrow");
        free_scope(&s);
    }
}

/* A noun that begins another one is one of its own, whichever comes first, in one claim and in two. */
static void nouns_are_whole(void **state)
{
    (void)state;
    static const struct {
        const char *over, *variables[2], *words;
    } list[] = {{"a: gap; b: gaps", {"a b", ""}, "every gap and gaps"},
                {"a: gap; b: gaps", {"b a", ""}, "every gaps and gap"},
                {"a: gap; b: gaps", {"a", "b"}, "every gap and gaps"},
                {"a: gap; b: gaps", {"b", "a"}, "every gaps and gap"},
                {"a: t; b: t'; c: t''", {"a b", "c a"}, "every t, t' and t''"},
                {"a: t; b: t'; c: t''", {"c", "b a"}, "every t'', t' and t"},
                {"a#: gap; b#: gaps", {"a1 b1", "a2 b3"}, "all gap and gaps"},
                {"", {"a b", "c"}, "all data"},
                {"b: gap", {"a", "b c"}, "every gap, all other data"}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        scope s = scope_that_says("", 0, list[k].over, list[k].variables[0]),
              other = scope_that_says("", 0, list[k].over, list[k].variables[1]);
        meet_scope(&s, &other);
        assert_words(&s, "n", list[k].words);
        free_scope(&s);
        free_scope(&other);
    }
}

/* The numbers of a scope have letters of their own beside the degree: a case is asked of each, wherever it stands in the list. */
static void ranges_of_several_letters(void **state)
{
    (void)state;
    static const char *const letter[] = {"", "m", "l"};
    for (int degree = 0; degree < 3; degree++)
        for (int empty = -1; empty < 3; empty++) {
            scope s = {.ranges = 0};
            for (int k = 0; k < 3; k++) {
                whole_range r = {.low = 1, .high = 7};
                strcpy(r.letter, letter[(3 + k - degree) % 3]); /* the degree is in that place */
                const scope one = {.range = &r, .ranges = 1};
                meet_scope(&s, &one);
                r = (whole_range){.low = k == empty ? 8 : 3, .high = 9};
                strcpy(r.letter, letter[(3 + k - degree) % 3]);
                meet_scope(&s, &one);
            }
            assert_int_equal(s.ranges, 3);
            assert_int_equal(is_empty_scope(&s), empty >= 0);
            keep_degree(&s, 5);
            for (int k = 0; k < 3; k++) {
                assert_int_equal(s.range[k].low, k == empty ? 8 : k == degree ? 5 : 3);
                assert_int_equal(s.range[k].high, k == degree ? 5 : 7);
            }
            free_scope(&s);
        }
}

/* A word for the degree stands before its number, a letter has a sign; another letter has its sign beside both. */
static void numbers_are_told_in_their_letters(void **state)
{
    (void)state;
    static const struct {
        int low, high;
        const char *letter, *words;
    } list[] = {{1, 4, "n", "n = 1 to 4; m = 1 to 4"},
                {1, 4, "k", "k = 2 to 5; m = 1 to 4"},
                {1, 4, "degree", "degree 1 to 4; m = 1 to 4"},
                {1, 4, "order", "order 2 to 5; m = 1 to 4"},
                {0, 3, "n", "n = 0 to 3; m = 0 to 3"},
                {0, 3, "k", "k = 1 to 4; m = 0 to 3"},
                {0, 0, "degree", "degree 0; m = 0"},
                {3, 3, "order", "order 4; m = 3"},
                {3, 3, "k", "k = 4; m = 3"},
                {4, 3, "n", "no n; no m"},
                {4, 3, "order", "no order; no m"},
                {2, WITHOUT_END, "n", "every n from 2 on; every m from 2 on"},
                {2, WITHOUT_END, "k", "every k from 3 on; every m from 2 on"},
                {1, WITHOUT_END, "order", "every order from 2 on; every m from 1 on"},
                {1, WITHOUT_END, "degree", "every degree from 1 on; every m from 1 on"},
                {0, WITHOUT_END, "k", "every k; every m"},
                {0, WITHOUT_END, "n", "every n; every m"}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        whole_range r[] = {{"", list[k].low, list[k].high}, {"m", list[k].low, list[k].high}};
        const scope s = {.range = r, .ranges = 2};
        assert_words(&s, list[k].letter, list[k].words);
    }
}

/* A condition reads as a phrase of the scope in TeX and in letters, with its indices; what is another relation or index does not. */
static void conditions_that_are_said(void **state)
{
    (void)state;
    static const struct {
        const char *said, *condition;
        int same;
    } list[] = {{"t ≤ 1", "$t\\le1$", 1},       {"t ≥ 1", "$t\\ge 1$", 1},      {"t ≠ 1", "$t\\ne1$", 1},
                {"t ≤ 1", "$t\\ge1$", 0},       {"t ≥ 1", "$t\\le 1$", 0},      {"t ≠ 1", "$t\\le1$", 0},
                {"t₀ < t₁", "$t_0<t_1$", 1},    {"t₀ < t₁", "$t_1<t_0$", 0},    {"t₁ < t₀", "$t_1<t_0$", 1},
                {"$t_0 < t_1$", "t₀ < t₁", 1},  {"t ≤ 1", "$t\\le1$ here", 0},  {"t ≤ 1 here", "$t\\le1$", 0},
                {"a; t ≥ 0; b", "$t\\ge0$", 1}, {"a; b; t ≥ 0", "t \\ge 0", 1}, {"t ≥ 0; a", "$ t \\ge 0 $", 1}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        scope s = scope_that_says(list[k].said, 0, "", "");
        add_condition(&s, list[k].condition);
        char expected[100];
        snprintf(expected, sizeof expected, "%s%s%s", list[k].said, list[k].same ? "" : "; where ",
                 list[k].same ? "" : list[k].condition);
        assert_words(&s, "n", expected);
        free_scope(&s);
    }
}

/* The letters of the field as TeX writes them are those of a statement, and as a text has them. */
static void greek_letters_are_left_by_both_names(void **state)
{
    (void)state;
    for (size_t k = 0; k < GREEK; k++)
        for (int form = 0; form < 2; form++)
            for (int known = 0; known < 2; known++) {
                char over[32], letters[32];
                snprintf(over, sizeof over, "e: %s", greek_letters[k][form]);
                snprintf(letters, sizeof letters, "n %s x", known ? greek_letters[k][0] : "t");
                scope s = scope_that_says("", 0, over, "e");
                leave_letters(&s, letters);
                assert_int_equal(s.kinds, known);
                free_scope(&s);
            }
    scope s = scope_that_says("", 0, "e: interval; f: x/y; g: y; h#: z",
                              "e f g h1"); /* of these the quotient and y are letters */
    leave_letters(&s, "x");
    assert_words(&s, "n", "all z, every interval");
    free_scope(&s);
}

/* ---- what several claims decide ------------------------------------------------------------------------ */

static statement_result derive_from(const statement *s, const statement_link links[])
{
    statement of = *s;
    of.links = links;
    return derive(&of, results, RESULTS);
}
#define LINKS(...) ((const statement_link[]){__VA_ARGS__, {HOLDS_BY, NULL, NULL, NULL, NULL}})
#define BY(role, name)                                                                                                 \
    {                                                                                                                  \
        role, name, NULL, "", NULL                                                                                     \
    }
#define ARGUMENT(cases)                                                                                                \
    {                                                                                                                  \
        ARGUED, NULL, cases, "words", NULL                                                                             \
    }

/* Cases that end as others do, or begin so, are other cases. */
static void cases_that_are_alike_are_told(void **state)
{
    (void)state;
    static const char *const alike[] = {"odd n > 7", "n > 7", "n", "odd n", "7"};
    enum { PHRASES = sizeof alike / sizeof *alike };
    for (int i = 0; i < PHRASES; i++)
        for (int j = 0; j < PHRASES; j++) {
            char expected[64];
            snprintf(expected, sizeof expected, "%s%s%s", alike[i], i == j ? "" : "; ", i == j ? "" : alike[j]);
            statement_result r = derive_from(&(statement){.id = "source:1"},
                                             LINKS(BY(HOLDS_BY, "low"), ARGUMENT(alike[i]), ARGUMENT(alike[j])));
            assert_string_equal(r.as_printed.argued_for, expected);
            assert_int_equal(r.as_printed.evidence, PROVED);
            free_statement_result(&r);
        }
}

/* Words that add cases and words that the cases need: the first lead beyond the degrees, the second weaken, in either order. */
static void words_of_both_kinds(void **state)
{
    (void)state;
    for (int turned = 0; turned < 2; turned++) {
        statement_result r =
            derive_from(&(statement){.id = "source:1"},
                        LINKS(BY(HOLDS_BY, "low"), ARGUMENT(turned ? "" : "n > 9"), ARGUMENT(turned ? "n > 9" : "")));
        assert_string_equal(r.as_printed.argued_for, "n > 9");
        assert_int_equal(r.as_printed.evidence, BY_ARGUMENT);
        free_statement_result(&r);
    }
}

/* Of several readings any may fail. */
static void one_reading_that_fails_is_enough(void **state)
{
    (void)state;
    for (int fails = 0; fails <= 3; fails++) {
        statement_result r = derive_from(&(statement){.id = "source:1"},
                                         LINKS(BY(HOLDS_BY, "low"), BY(READING, fails == 0 ? "against" : "low"),
                                               BY(READING, fails == 1 ? "against" : "few"),
                                               BY(READING, fails == 2 ? "against" : "low")));
        assert_true(r.as_expected);
        assert_int_equal(r.verdict, fails == 3 ? VERDICT_HOLDS : VERDICT_UNDECIDED);
        free_statement_result(&r);
    }
}

/* A reading is told in the letter of its statement. */
static void a_reading_is_told_in_the_letter(void **state)
{
    (void)state;
    static const char *const letter[] = {"n", "k", "degree", "", NULL}, *const told[] = {"n = 1 to 4", "k = 2 to 5",
                                                                                         "degree 1 to 4", "n = 1 to 4",
                                                                                         "n = 1 to 4"};
    for (int k = 0; k < 5; k++) {
        const statement s = {.id = "source:1", .letter = letter[k], .links = LINKS(BY(READING, "low"))};
        finding f = finding_of_reading(&s, s.links, results, RESULTS);
        assert_string_equal(f.scope, told[k]);
        free_finding(&f);
    }
}

/* Without a letter, and with an empty one, a statement counts degrees n; a correction is told as what is printed: of the
 * letters of the statement, and in its only degree. */
static void a_correction_is_told_as_a_print(void **state)
{
    (void)state;
    char names[] = "x1 t s";
    const claim c = {.name = "letters", .scope = "", .over = "x#: points; t; s"},
                refutes = {.name = "refutes", .kind = COUNTEREXAMPLE, .scope = ""};
    claim_result both[] = {
        IN_FIELD(c, 1, 6),
        {.claim = &refutes, .as_expected = 1, .outcome = FAILS, .evidence = DECIDED, .scope = stated}};
    both[0].by[FIELD_TYPE].variables = names;
    static const struct {
        const char *letter, *letters;
        int degree;
        const char *scope;
    } list[] = {{NULL, NULL, 0, "n = 1 to 6; all points, every t and s"},
                {"", NULL, 0, "n = 1 to 6; all points, every t and s"},
                {"n", "t", 0, "n = 1 to 6; all points, every t"},
                {"p", "t", 4, "p = 4; all points, every t"},
                {"degree", "s t", 6, "degree 6; all points, every t and s"},
                {"k", "x", 1, "k = 2; all points"}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        for (int corrects = 0; corrects < 2; corrects++) {
            const statement s = {.id = "source:1",
                                 .letter = list[k].letter,
                                 .letters = list[k].letters,
                                 .degree = list[k].degree,
                                 .links = corrects ? LINKS(BY(REFUTED_BY, "refutes"), BY(CORRECTED_BY, "letters"))
                                                   : LINKS(BY(HOLDS_BY, "letters"))};
            statement_result r = derive(&s, both, 2);
            assert_true(r.as_expected);
            assert_string_equal(corrects ? r.as_corrected.scope : r.as_printed.scope, list[k].scope);
            free_statement_result(&r);
        }
    for (int corrects = 0; corrects < 2; corrects++) { /* and not in a degree that its claims do not have */
        const statement s = {.id = "source:1",
                             .degree = 7,
                             .links = corrects ? LINKS(BY(REFUTED_BY, "refutes"), BY(CORRECTED_BY, "letters"))
                                               : LINKS(BY(HOLDS_BY, "letters"))};
        statement_result r = derive(&s, both, 2);
        assert_false(r.as_expected);
        assert_int_equal(r.verdict, VERDICT_OPEN);
        free_statement_result(&r);
    }
}

/* ---- what is written of a claim ------------------------------------------------------------------------ */

/* 9000 sums in degree 1, one in degree 2. */
static void long_in_degree_one_q(trial *T)
{
    num_q sum = unknown_q(T, "x", 0), one = from_int_q(1), less = sum;
    for (int k = 0; k < (T->degree == 1 ? 9000 : 1); k++)
        sum = add_q(sum, one);
    same_q(T, sum, add_q(less, from_int_q(T->planted ? -1 : T->degree == 1 ? 9000 : 1)));
}
/* Where there is another one it is left out; alone it is recorded after all. */
static void a_long_case_is_recorded_where_it_is_alone(void **state)
{
    (void)state;
    for (int last = 1; last <= 2; last++) {
        const claim c = {.name = "long in degree one",
                         .scope = "",
                         .degree_low = 1,
                         .degree_high = last,
                         .degree_sampled = last,
                         .body = {[RATIONAL_TYPE] = long_in_degree_one_q}};
        claim_result *r = judge_one(&c);
        assert_true(r->as_expected);
        struct recorded_case recorded[MOST_RECORDED];
        int count;
        char *text = certificate_of_claim(r, &count, recorded);
        assert_int_equal(count, 1);
        assert_int_equal(recorded[0].degree, last);
        assert_int_equal(recorded[0].nodes > 9000, last == 1);
        region_faults = 0; /* of the program that was too long */
        free(text);
        free_results(r, 1);
    }
}

/* Of degrees whose programs are too long the highest that is not is recorded, beside the lowest. */
static int long_from;
static void long_in_high_degrees_q(trial *T)
{
    num_q sum = unknown_q(T, "x", 0), one = from_int_q(1), less = sum;
    for (int k = 0; k < (T->degree >= long_from ? 9000 : 1); k++)
        sum = add_q(sum, one);
    same_q(T, sum, add_q(less, from_int_q(T->planted ? -1 : T->degree >= long_from ? 9000 : 1)));
}
static void the_highest_degree_that_is_not_too_long(void **state)
{
    (void)state;
    for (long_from = 2; long_from <= 6; long_from++) {
        const claim c = {.name = "long in high degrees",
                         .scope = "",
                         .degree_low = 1,
                         .degree_high = 5,
                         .degree_sampled = 5,
                         .body = {[RATIONAL_TYPE] = long_in_high_degrees_q}};
        const claim_result r = {.claim = &c};
        struct recorded_case recorded[MOST_RECORDED];
        int count;
        char *text = certificate_of_claim(&r, &count, recorded);
        assert_int_equal(count, long_from == 2 ? 1 : 2);
        assert_int_equal(recorded[0].degree, long_from - 1);
        assert_int_equal(recorded[count - 1].degree, 1);
        region_faults = 0;
        free(text);
    }
}

/* A field that had no room at first is recorded from anew: the program that was broken off is no part of the certificate. */
static void many_variables_f(trial *T)
{
    num_f sum = from_int_f(0);
    for (int k = 0; k < 20; k++)
        sum = add_f(sum, unknown_f(T, "x", k));
    same_f(T, sum, T->planted ? from_int_f(1) : sum);
}
static void a_crowded_field_is_recorded_anew(void **state)
{
    (void)state;
    const claim c = {.name = "many variables", .scope = "", .body = {[FIELD_TYPE] = many_variables_f}};
    claim_result *r = judge_one(&c);
    assert_true(r->as_expected);
    struct recorded_case recorded[MOST_RECORDED];
    int count, steps = 0;
    char *text = certificate_of_claim(r, &count, recorded);
    assert_int_equal(count, 1);
    assert_int_equal(recorded[0].inputs, 20);
    assert_int_equal(recorded[0].compared, 1);
    for (const char *at = text; (at = strstr(at, "{\"same\"")) != NULL; at++)
        steps++;
    assert_int_equal(steps, 1);
    free(text);
    free_results(r, 1);
}

/* Twelve conditions of two facts; three inputs, in the names of two a bracket stands. */
static void many_facts_q(trial *T)
{
    num_q x = unknown_q(T, "x]", 0), y = unknown_q(T, "y[", 0), z = unknown_q(T, "z", 0);
    for (int k = 0; k < 12; k++)
        agree(T, cagd_testify_equal_q(add_q(x, from_int_q(T->planted)), x) && !is_zero_q(add_q(y, z)));
}
static void what_is_recorded_is_counted(void **state)
{
    (void)state;
    const claim c = {.name = "many facts", .scope = "", .kind = DECISION, .body = {[RATIONAL_TYPE] = many_facts_q}};
    claim_result *r = judge_one(&c);
    struct recorded_case recorded[MOST_RECORDED];
    int count;
    char *text = certificate_of_claim(r, &count, recorded);
    assert_int_equal(count, 1);
    assert_int_equal(recorded[0].inputs, 3);
    assert_int_equal(recorded[0].facts, 24);
    int formulas = 0; /* beside each condition the one that combines its facts */
    for (const char *at = text; (at = strstr(at, "\"formula\":\"cagd_testify_equal_q(")) != NULL; at++)
        formulas++;
    assert_int_equal(formulas, 12);
    free(text);
    free_results(r, 1);
}

/* Of 40 nodes; those that are compared have numbers of two digits. */
static void nodes_of_two_digits_q(trial *T)
{
    num_q sum = from_int_q(0), other = from_int_q(1);
    for (int k = 1; k <= 16; k++)
        sum = add_q(sum, from_int_q(k));
    other = add_q(other, from_int_q(fault(T, 135, 0)));
    same_q(T, sum, sum);
    same_q(T, sum, other);
    same_q(T, other, other);
}
static void a_node_and_itself_are_counted(void **state)
{
    (void)state;
    const claim c = {
        .name = "itself", .scope = "", .kind = DECISION, .body = {[RATIONAL_TYPE] = nodes_of_two_digits_q}};
    claim_result *r = judge_one(&c);
    assert_true(r->as_expected);
    struct recorded_case recorded[MOST_RECORDED];
    int count;
    char *text = certificate_of_claim(r, &count, recorded);
    assert_int_equal(count, 1);
    assert_int_equal(recorded[0].compared, 3);
    assert_true(recorded[0].nodes > 20);
    assert_int_equal(recorded[0].of_the_same, 2);
    free(text);
    free_results(r, 1);
}

/* Sums of one number and of others that are equal to it: of some the text begins as that of others, "["+",0,1" and "["+",0,12". */
enum { ALIKE = 13 };
static void nodes_that_begin_alike_q(trial *T)
{
    num_q first = from_int_q(1), sum[ALIKE];
    for (int k = 0; k < ALIKE; k++)
        sum[k] = add_q(first, mul_q(from_ratio_q(1, 3), from_int_q(3)));
    for (int i = 0; i < ALIKE; i++)
        for (int j = i + 1; j < ALIKE; j++)
            same_q(T, sum[i], fault(T, sum[j], first));
}
static void nodes_are_compared_to_their_end(void **state)
{
    (void)state;
    const claim c = {
        .name = "alike", .scope = "", .kind = DECISION, .body = {[RATIONAL_TYPE] = nodes_that_begin_alike_q}};
    claim_result *r = judge_one(&c);
    assert_true(r->as_expected);
    struct recorded_case recorded[MOST_RECORDED];
    int count;
    char *text = certificate_of_claim(r, &count, recorded);
    assert_int_equal(count, 1);
    assert_int_equal(recorded[0].compared, ALIKE * (ALIKE - 1) / 2);
    assert_int_equal(recorded[0].of_the_same, 0);
    assert_non_null(strstr(text, "[\"+\",0,3]"));
    assert_non_null(strstr(text, "[\"+\",0,35]"));
    free(text);
    free_results(r, 1);
}

/* A claim is argued where its cases need words, and not where words add cases. */
static void words_in_a_certificate(void **state)
{
    (void)state;
    static const char *const words[][2] = {{"", ""}, {"words", ""}, {"words", "every n"}};
    for (int k = 0; k < 3; k++) {
        const claim c = {.name = "words",
                         .scope = "",
                         .argued = words[k][0],
                         .argued_for = words[k][1],
                         .kind = DECISION,
                         .body = {[RATIONAL_TYPE] = degree_q}};
        claim_result *r = judge_one(&c);
        struct recorded_case recorded[MOST_RECORDED];
        int count;
        char *text = certificate_of_claim(r, &count, recorded);
        assert_non_null(strstr(text, k == 1 ? "\"argued\":true" : "\"argued\":false"));
        assert_non_null(strstr(text, "\"evidence\":\"decided\""));
        free(text);
        free_results(r, 1);
    }
}

/* Of whatever role the first link is, a comma stands before the second. */
static void links_are_a_list(void **state)
{
    (void)state;
    for (int first = 0; first < ROLES; first++) {
        const statement_link links[] = {{(role)first, "against", "", "", NULL},
                                        {HOLDS_BY, "low", "", "", NULL},
                                        {HOLDS_BY, NULL, NULL, NULL, NULL}};
        const statement s = {.id = "source:1", .class = "", .corrected = "", .links = links};
        statement_result r = derive(&s, results, RESULTS);
        char *text = certificate_of_statement(&r);
        assert_non_null(strstr(text, "},\n{\"role\""));
        free(text);
        free_statement_result(&r);
    }
}

/* A text that grows by one letter at a time, from a first part of any length on, has room for its end and says how long it is. */
static void a_text_has_room_for_its_end(void **state)
{
    (void)state;
    for (size_t first = 0; first <= 40; first++) {
        char *text, expected[401];
        size_t size;
        FILE *out = text_open(&text, &size);
        assert_string_equal(text, "");
        memset(expected, 'b', sizeof expected - 1);
        memset(expected, 'a', first);
        fwrite(expected, 1, first, out);
        for (size_t length = first; length < sizeof expected - 1; length++) {
            assert_int_equal(fflush(out), 0);
            assert_int_equal(ftell(out), length);
            assert_int_equal(size, length);
            assert_int_equal(strlen(text), length);
            assert_true(malloc_usable_size(text) > length);
            fputc('b', out);
        }
        text_close(out, &text);
        expected[sizeof expected - 1] = '\0';
        assert_string_equal(text, expected);
        free(text);
    }
}

/* A control that asks for what is not there is no control. */
static void asks_in_its_control_q(trial *T)
{
    if (T->planted)
        (void)given_q(T, "y");
    same_q(T, from_int_q(1), from_int_q(1));
}
static void a_mistaken_control_catches_nothing(void **state)
{
    (void)state;
    const claim c = {
        .name = "mistaken", .scope = "", .kind = DECISION, .body = {[RATIONAL_TYPE] = asks_in_its_control_q}};
    claim_result *r = judge_one(&c);
    assert_int_equal(r->by[RATIONAL_TYPE].outcome, HOLDS);
    assert_false(r->by[RATIONAL_TYPE].control_caught);
    assert_false(r->as_expected);
    free_results(r, 1);
}

/* The scope of several claims meets another one. */
static void what_is_apart_stays_so(void **state)
{
    (void)state;
    for (int k = 0; k < 4; k++) {
        scope s = {.within = NULL};
        const scope other = {.apart = k & 1, .mixed = k >> 1};
        for (int times = 0; times < 2; times++) {
            meet_scope(&s, &other);
            assert_int_equal(s.apart, k & 1);
            assert_int_equal(s.mixed, k >> 1);
        }
        meet_scope(&s, &(scope){.within = NULL});
        assert_int_equal(s.apart, k & 1);
        assert_int_equal(s.mixed, k >> 1);
        free_scope(&s);
    }
}

/* Positive data meet a condition, and what the table says is wider, which is not told again; where steps have cases of their own
 * their data are not told, and it is. */
static void conditions_that_data_meet(void **state)
{
    (void)state;
    static const char *const condition[] = {"the weights are positive", "P ≠ 0", "Q ≠ 0"};
    static char weights[] = "weights";
    quantity data = {.noun = weights, .many = 1, .positive = 1, .claims = 1};
    for (int mixed = 0; mixed < 2; mixed++)
        for (int apart = 0; apart < 2; apart++)
            for (int k = 0; k < 3; k++) {
                scope s = {.data = &data,
                           .kinds = 1,
                           .apart = apart,
                           .mixed = mixed,
                           .within = "the weights are positive | P ≠ 0; Q ≠ 0 | the weights are positive"};
                add_condition(&s, condition[k]);
                char expected[100] = "", *words = scope_words(&s, "n");
                snprintf(expected, sizeof expected, "%s%s%s",
                         apart ? "each step for its own cases" : "all positive weights",
                         apart || k == 2 ? ", where " : "", apart || k == 2 ? condition[k] : "");
                assert_string_equal(words, expected);
                free(words);
                s.kinds = 0, s.data = NULL;
                free_scope(&s);
            }
}

/* In degree 1 it compares nothing, which is no failure that an instance shows; from degree 2 on it is false. */
static void compares_from_two_on_q(trial *T)
{
    num_q x = unknown_q(T, "x", 0);
    if (T->degree > 1)
        same_q(T, x, add_q(x, from_int_q(1)));
}
static void an_instance_compares_something(void **state)
{
    (void)state;
    const claim c = {.name = "empty at first",
                     .scope = "",
                     .degree_low = 1,
                     .degree_high = 3,
                     .degree_sampled = 3,
                     .body = {[RATIONAL_TYPE] = compares_from_two_on_q}};
    exhibit *shown;
    int count;
    find_witness(&c, &shown, &count);
    assert_true(count > 0);
    assert_string_equal(shown[0].name, "n");
    assert_string_equal(shown[0].value, "2");
    forget_exhibits(shown, count);
}

/* Numbers of one name whose indices follow one another are told together, whatever stands before them. */
static void numbers_in_rows_q(trial *T)
{
    num_q sum = from_int_q(1);
    for (int k = 0; k < 4; k++)
        sum = add_q(sum, unknown_q(T, k < 2 ? "x" : "w", k));
    same_q(T, mul_q(sum, unknown_q(T, "w", 7)), from_int_q(T->planted ? 1 : 2));
}
static void rows_of_numbers_are_told_by_their_ends(void **state)
{
    (void)state;
    static const char *const name[] = {"x0 to x1", "w2 to w3", "w7"};
    const claim c = {.name = "rows", .scope = "", .body = {[RATIONAL_TYPE] = numbers_in_rows_q}};
    exhibit *shown;
    int count;
    find_witness(&c, &shown, &count);
    assert_true(count >= 3);
    for (int k = 0; k < 3; k++)
        assert_string_equal(shown[k].name, name[k]);
    forget_exhibits(shown, count);
}

/* A body may show several values of one name, which are all told; an index 0 is told, and of indices with gaps each. */
static void shows_a_name_twice_q(trial *T)
{
    num_q x = unknown_q(T, "x", 0), y[] = {unknown_q(T, "y", 3), unknown_q(T, "y", 5), unknown_q(T, "y", 6)};
    show_q(T, "P", from_int_q(7));
    show_q(T, "P", from_int_q(8));
    show_q(T, "x0", x);
    same_q(T, add_q(x, add_q(y[0], add_q(y[1], y[2]))), from_int_q(T->planted ? 9 : 77));
}
static void all_values_of_one_name_are_told(void **state)
{
    (void)state;
    static const char *const wanted[][2] = {{"x0", "0"}, {"y3", "0"},   {"y5 to y6", "0, 0"}, {"P", "7"},
                                            {"P", "8"},  {"left", "0"}, {"right", "77"}};
    enum { WANTED = sizeof wanted / sizeof *wanted };
    const claim c = {.name = "twice", .scope = "", .body = {[RATIONAL_TYPE] = shows_a_name_twice_q}};
    claim_result *r = judge_one(&c);
    const type_result *b = &r->by[RATIONAL_TYPE];
    assert_int_equal(r->witnesses, WANTED);
    assert_int_equal(b->exhibits, WANTED);
    for (int k = 0; k < WANTED; k++) {
        assert_string_equal(r->witness[k].name, wanted[k][0]);
        assert_string_equal(r->witness[k].value, wanted[k][1]);
        assert_string_equal(b->shown[k].name, wanted[k][0]);
        if (k == 3 || k == 4)
            assert_string_equal(b->shown[k].value, wanted[k][1]);
    }
    free_results(r, 1);
}

/* What the case does not ask for is no part of it: y belongs to those that hold, which the search tried as well. */
static void asks_where_it_holds_q(trial *T)
{
    num_q x = unknown_q(T, "x", -1);
    if (cagd_compare_q(x, from_int_q(2)) < 0) {
        num_q y = unknown_q(T, "y", -1);
        same_q(T, y, y);
    } else {
        same_q(T, x, from_int_q(T->planted ? 7 : 1));
    }
}
static void only_what_the_case_asks_for_is_told(void **state)
{
    (void)state;
    const claim c = {.name = "asks", .scope = "", .body = {[RATIONAL_TYPE] = asks_where_it_holds_q}};
    exhibit *shown;
    int count;
    find_witness(&c, &shown, &count);
    assert_true(count > 0);
    assert_string_equal(shown[0].name, "x");
    assert_string_equal(shown[0].value, "2");
    for (int k = 0; k < count; k++)
        assert_string_not_equal(shown[k].name, "y");
    forget_exhibits(shown, count);
}

static void is_two_q(trial *T) { same_q(T, unknown_q(T, "x", 0), from_int_q(2)); }
static void the_search_for_a_witness_leaves_the_faults(void **state)
{
    (void)state;
    const claim c = {.name = "is two", .scope = "", .body = {[RATIONAL_TYPE] = is_two_q}};
    exhibit *shown;
    int count;
    region_faults = FAULT_UNABLE;
    find_witness(&c, &shown, &count);
    assert_int_equal(region_faults, FAULT_UNABLE);
    assert_true(count > 0);
    forget_exhibits(shown, count);
    region_faults = 0;
}

/* The number of each rank is of its kind, and no two ranks have the same one until those of a range of whole numbers are all there. */
static void simple_numbers_are_of_their_kind(void **state)
{
    (void)state;
    enum { RANKS = 12 };
    static const int range[][2] = {{0, 0}, {0, 2}, {-3, 1}, {5, 7}, {7, 7}, {2, 40}};
    for (size_t m = 0; m < sizeof range / sizeof *range; m++)
        for (enum input_kind kind = ANY_NUMBER; kind <= WHOLE_NUMBER; kind++) {
            const int least = range[m][0], most = range[m][1];
            num_q number[RANKS];
            for (int rank = 0; rank < RANKS; rank++) {
                struct small_input in = {.rank = rank};
                struct small_data data = {.at = &in, .count = 1};
                trial T = {.small = &data};
                num_q a = number[rank] = small_number(&T, "a", -1, kind, least, most);
                assert_string_equal(in.value, to_string_q(a));
                free(in.value);
                if (kind == POSITIVE_NUMBER || kind == FRACTION)
                    assert_true(cagd_sign_q(a) > 0);
                if (kind == FRACTION)
                    assert_true(cagd_compare_q(a, from_int_q(1)) < 0);
                if (kind == WHOLE_NUMBER)
                    assert_true(cagd_equal_q(a, from_int_q(rank < most - least ? least + rank : most)));
                for (int k = 0; k < rank; k++)
                    assert_true(!cagd_equal_q(number[k], a) || (kind == WHOLE_NUMBER && k >= most - least) ||
                                kind == PARAMETER || kind == FRACTION); /* 1/2 = 2/4 */
            }
        }
}

/* The simplest numbers of each kind, in their order. */
static void simple_numbers_are_in_order(void **state)
{
    (void)state;
    static const struct {
        enum input_kind kind;
        const char *number[8];
    } list[] = {{ANY_NUMBER, {"0", "1", "-1", "2", "-2", "3", "-3", "4"}},
                {POSITIVE_NUMBER, {"1", "2", "1/2", "3", "1/3", "4", "1/4", "5"}},
                {PARAMETER, {"1/2", "1/3", "2/3", "1/4", "1/2", "3/4", "1/5", "2/5"}},
                {FRACTION, {"1/2", "1/3", "2/3", "1/4", "1/2", "3/4", "1/5", "2/5"}},
                {WHOLE_NUMBER, {"-3", "-2", "-1", "0", "1", "2", "2", "2"}}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        for (int rank = 0; rank < 8; rank++) {
            struct small_input in = {.rank = rank};
            struct small_data data = {.at = &in, .count = 1};
            trial T = {.small = &data};
            (void)small_number(&T, "a", -1, list[k].kind, -3, 2);
            assert_string_equal(in.value, list[k].number[rank]);
            free(in.value);
        }
}

/* A number that got simpler may let one before it get simpler as well.  Here the first has rank 4 until all others have rank 0. */
static void simplifies_in_turns_q(trial *T)
{
    num_q x = unknown_q(T, "x", -1);
    int others = 0;
    for (int k = 0; k < 5; k++)
        others |= cagd_sign_q(unknown_q(T, "y", k)) != 0;
    int fails = cagd_equal_q(x, from_int_q(-2)) || (!others && cagd_equal_q(x, from_int_q(2)));
    same_q(T, from_int_q(fails), from_int_q(T->planted ? 2 : 0));
}
static void numbers_are_simplified_in_turns(void **state)
{
    (void)state;
    const claim c = {.name = "in turns", .scope = "", .body = {[RATIONAL_TYPE] = simplifies_in_turns_q}};
    exhibit *shown;
    int count;
    find_witness(&c, &shown, &count);
    assert_true(count > 2);
    assert_string_equal(shown[0].value, "2");
    assert_string_equal(shown[1].name, "y0 to y4");
    assert_string_equal(shown[1].value, "0, 0, 0, 0, 0");
    forget_exhibits(shown, count);
}

/* Each of the simplest numbers is tried with each: the claim fails for one pair of them alone. */
static int first_of_pair, second_of_pair;
static void fails_for_one_pair_q(trial *T)
{
    num_q x = unknown_q(T, "x", -1), y = unknown_q(T, "y", -1);
    int fails = cagd_equal_q(x, from_int_q(first_of_pair)) && cagd_equal_q(y, from_int_q(second_of_pair));
    same_q(T, from_int_q(fails), from_int_q(T->planted ? 2 : 0));
}
static void every_pair_of_simple_numbers_is_tried(void **state)
{
    (void)state;
    const claim c = {.name = "one pair", .scope = "", .body = {[RATIONAL_TYPE] = fails_for_one_pair_q}};
    for (first_of_pair = -1; first_of_pair <= 1; first_of_pair++)
        for (second_of_pair = -1; second_of_pair <= 1; second_of_pair++) {
            exhibit *shown;
            int count;
            char value[2][8];
            find_witness(&c, &shown, &count);
            assert_true(count >= 2);
            snprintf(value[0], sizeof value[0], "%d", first_of_pair);
            snprintf(value[1], sizeof value[1], "%d", second_of_pair);
            for (int k = 0; k < 2; k++) {
                assert_string_equal(shown[k].name, k == 0 ? "x" : "y");
                assert_string_equal(shown[k].value, value[k]);
            }
            forget_exhibits(shown, count);
        }
}

/* Numbers to 3 and parts to 1/4 are tried, alone. */
static int only_at;
static void fails_at_one_number_q(trial *T)
{
    int fails = cagd_equal_q(positive_q(T, "w", -1), only_at > 0 ? from_int_q(only_at) : from_ratio_q(1, -only_at));
    same_q(T, from_int_q(fails), from_int_q(T->planted ? 2 : 0));
}
static void numbers_are_tried_up_to_the_last_rank(void **state)
{
    (void)state;
    const claim c = {.name = "one number", .scope = "", .body = {[RATIONAL_TYPE] = fails_at_one_number_q}};
    for (only_at = -5; only_at <= 5; only_at++)
        if (only_at != 0 && only_at != -1) {
            exhibit *shown;
            int count;
            find_witness(&c, &shown, &count);
            assert_int_equal(count > 0, only_at >= -4 && only_at <= 4);
            forget_exhibits(shown, count);
        }
}

/* An instance whose result is not the stated one is a mistake of the block, and no witness. */
static void is_mistaken_but_at_two_q(trial *T)
{
    num_q x = unknown_q(T, "x", -1);
    found_q(T, "x", x);
    same_q(T, x, from_int_q(T->planted ? 9 : 7));
}
static void a_mistake_is_no_witness(void **state)
{
    (void)state;
    static const char *const two[] = {"2"};
    const datum list[] = {{.name = "x", .text = "2", .rows = 1, .columns = 1, .value = two, .place = IN_RESULT},
                          {.name = NULL}};
    const claim c = {
        .name = "mistaken", .scope = "", .data = list, .body = {[RATIONAL_TYPE] = is_mistaken_but_at_two_q}};
    exhibit *shown;
    int count;
    find_witness(&c, &shown, &count);
    assert_true(count > 0);
    assert_string_equal(shown[0].name, "x");
    assert_string_equal(shown[0].value, "2");
    int told = 0; /* once, although the body shows it as well */
    for (int k = 0; k < count; k++)
        told += strcmp(shown[k].name, "x") == 0;
    assert_int_equal(told, 1);
    forget_exhibits(shown, count);
}

/* More inputs than the search remembers. */
static void more_inputs_than_are_kept_q(trial *T)
{
    num_q sum = from_int_q(0);
    for (int k = 0; k < 4100; k++)
        sum = add_q(sum, unknown_q(T, "x", k));
    same_q(T, sum, add_q(sum, from_int_q(1)));
}
static void a_search_among_more_inputs_than_are_kept(void **state)
{
    (void)state;
    const claim c = {.name = "many inputs", .scope = "", .body = {[RATIONAL_TYPE] = more_inputs_than_are_kept_q}};
    exhibit *shown;
    int count;
    find_witness(&c, &shown, &count);
    assert_string_equal(shown[0].name, "x0 to x4095");
    forget_exhibits(shown, count);
    claim_result *r = judge_one(&c);
    assert_string_equal(r->by[RATIONAL_TYPE].shown[0].name, "x0 to x4095");
    free_results(r, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(in_a_crowded_field_nothing_is_refuted),
                                       unit(a_nan_is_the_worst),
                                       unit(the_widest_difference_counts),
                                       unit(a_mistaken_control_catches_nothing),
                                       unit(what_is_apart_stays_so),
                                       unit(an_instance_compares_something),
                                       unit(only_what_the_case_asks_for_is_told),
                                       unit(a_node_and_itself_are_counted),
                                       unit(nodes_are_compared_to_their_end),
                                       unit(a_fault_of_an_early_case_is_kept),
                                       unit(one_case_that_is_undecided_counts),
                                       unit(every_degree_has_an_instance),
                                       unit(entries_beyond_the_bits_of_an_int),
                                       unit(degrees_without_end),
                                       unit(of_instances_the_fewest_are_told),
                                       unit(names_and_what_they_stand_for),
                                       unit(data_of_different_kinds_are_mixed),
                                       unit(conditions_that_data_meet),
                                       unit(what_is_proved_has_no_instances),
                                       unit(a_correction_needs_a_case),
                                       unit(orders_are_one_more),
                                       unit(letters_of_the_degree),
                                       unit(every_variable_of_any_case_is_told),
                                       unit(simple_numbers_are_of_their_kind),
                                       unit(names_are_whole_words),
                                       unit(every_greek_letter_is_known),
                                       unit(a_letter_stands_by_itself),
                                       unit(a_condition_that_says_nothing_is_none),
                                       unit(decisions_have_no_degrees_to_sample),
                                       unit(a_result_has_a_sign),
                                       unit(what_is_recorded_is_counted),
                                       unit(links_are_a_list),
                                       unit(the_degree_is_shown_once),
                                       unit(the_letter_is_n_where_none_is_given),
                                       unit(a_number_without_index_is_a_variable_of_the_field),
                                       unit(a_search_among_more_inputs_than_are_kept),
                                       unit(a_long_case_is_recorded_where_it_is_alone),
                                       unit(rows_of_numbers_are_told_by_their_ends),
                                       unit(the_search_for_a_witness_leaves_the_faults),
                                       unit(degree_nought_is_shown),
                                       unit(a_phrase_is_looked_for_in_the_whole_list),
                                       unit(what_is_stated_is_apart_from_what_is_more),
                                       unit(nouns_are_whole),
                                       unit(ranges_of_several_letters),
                                       unit(numbers_are_told_in_their_letters),
                                       unit(conditions_that_are_said),
                                       unit(greek_letters_are_left_by_both_names),
                                       unit(cases_that_are_alike_are_told),
                                       unit(words_of_both_kinds),
                                       unit(one_reading_that_fails_is_enough),
                                       unit(a_correction_is_told_as_a_print),
                                       unit(simple_numbers_are_in_order),
                                       unit(numbers_are_simplified_in_turns),
                                       unit(a_mistake_is_no_witness),
                                       unit(the_highest_degree_that_is_not_too_long),
                                       unit(a_crowded_field_is_recorded_anew),
                                       unit(data_are_told_apart_by_their_whole_names),
                                       unit(all_values_of_one_name_are_told),
                                       unit(rows_are_of_whole_phrases),
                                       unit(a_text_has_room_for_its_end),
                                       unit(words_in_a_certificate),
                                       unit(what_is_said_of_data_behind_other_phrases),
                                       unit(the_table_is_kept),
                                       unit(every_pair_of_simple_numbers_is_tried),
                                       unit(numbers_are_tried_up_to_the_last_rank),
                                       unit(a_reading_is_told_in_the_letter)};
    return run_unit_tests(tests);
}
