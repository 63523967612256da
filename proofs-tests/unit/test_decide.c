/* test_decide.c -- the verdict about code: what was proved, on which ways, and what is left open. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/code/decide.h"
#include "exact/words.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct asked {
    int which;
    const char *lines;
    enum cagd_code_word word;
    int paths, proved, exhaustive;
    long points, undefined;
    const char *message, *open; /* what they begin with */
    const char *at;             /* the last input of the point that is told; NULL: none, "*": any; -1 above: any */
} list[] = {
    /* more ways than are followed: what was proved of the first ones is not proved */
    {0, ":input: y[9]\n:points: 900", CAGD_CODE_SAMPLED, 256, 256, 0, 900, 0, "", "", NULL},
    /* equal at the point of a way, and not as functions; a square that is 0 is not looked for, and told */
    {1, ":input: x", CAGD_CODE_SAMPLED, 2, 1, 0, 20, 0, "on 1 of the ways the two sides are different functions", "",
     NULL},
    {2, ":input: x", CAGD_CODE_PROVED, 1, 1, 0, 20, 0, "", "x^2-24690*x+152399025 = 0", NULL},
    /* equal neighbours are another way; of each pattern there are four points */
    {3, ":input: u[4] nondecreasing\n:output: r", CAGD_CODE_COMPUTED, 8, 8, 0, 32, 0, "", "", "*"},
    {3, ":input: u[4] increasing\n:output: r", CAGD_CODE_COMPUTED, 1, 1, 0, 20, 0, "", "", "*"},
    {3, ":input: u[4] nondecreasing\n:output: r\n:points: 50", CAGD_CODE_COMPUTED, 8, 8, 0, 50, 0, "", "", "*"},
    /* a way that one number takes, which nobody tried */
    {4, ":input: x", CAGD_CODE_PROVED, 1, 1, 0, 20, 0, "", "a number of more than", NULL},
    {5, ":input: x", CAGD_CODE_UNDECIDED, 1, 1, 0, 20, 0, "something", "", "12345"},
    {22, ":input: x", CAGD_CODE_UNDECIDED, 1, 1, 0, 20, 0, "", "", "12345"}, /* a way on which the process ends */
    {6, ":input: x", CAGD_CODE_PROVED, 1, 1, 1, 20, 1, "", "", NULL},
    {7, ":input: x", CAGD_CODE_DIFFERS, 2, 1, 0, 20, 0, "", "", "12345"},
    {11, ":input: most = 12344; x in [0, most]", CAGD_CODE_PROVED, 1, 1, 1, 20, 0, "", "", NULL},
    {12, ":input: most = 12345; x in [0, most)", CAGD_CODE_PROVED, 1, 1, 1, 20, 0, "", "", NULL},
    {11, ":input: most = 12345; x in [0, most]", /* an end is tried */
     CAGD_CODE_UNDECIDED, 1, 0, 0, 1, 0, "a number of more than", "", "12345"},
    {8, ":input: most = 7; x in [0, most]", CAGD_CODE_PROVED, 1, 1, 1, 20, 0, "", "", NULL},
    {8, ":input: most = 9; x in [8, most]", CAGD_CODE_DIFFERS, 0, 0, 0, 1, 0, "", "", "*"},
    {9, ":input: x", CAGD_CODE_PROVED, 1, 1, 1, 20, 0, "", "", NULL},
    /* more ways than are run; a square, of which a point by chance shows where it is larger */
    {13, ":input: y[11]\n:points: 1", CAGD_CODE_PROVED, 256, 256, 0, 1, 0, "", "there are more ways than are followed",
     NULL},
    {14, ":input: x", CAGD_CODE_DIFFERS, 2, 1, 0, 20, 0, "", "", "*"},
    /* as small as it goes: of 0, 1, 2, 3, -1 and 1/2 the first that differs, and only what varies */
    {16, ":input: least = -1; most = 1; x", CAGD_CODE_DIFFERS, -1, -1, 0, -1, 0, "", "", "0"},
    {16, ":input: least = 0; most = 99; x", CAGD_CODE_DIFFERS, -1, -1, 0, -1, 0, "", "", "1"},
    {16, ":input: least = 1; most = 99; x", CAGD_CODE_DIFFERS, -1, -1, 0, -1, 0, "", "", "2"},
    {16, ":input: least = 2; most = 99; x", CAGD_CODE_DIFFERS, -1, -1, 0, -1, 0, "", "", "3"},
    {16, ":input: least = -99; most = 0; x", CAGD_CODE_DIFFERS, -1, -1, 0, -1, 0, "", "", "-1"},
    {16, ":input: least = 0; most = 1; x", CAGD_CODE_DIFFERS, -1, -1, 0, -1, 0, "", "", "1/2"},
    {16, ":input: least = 0; most = 9; x = 17/2", CAGD_CODE_DIFFERS, 0, 0, 0, 1, 0, "", "", "17/2"},
    {16, ":input: least = 0; most = 9; x = 9", CAGD_CODE_SAMPLED, 1, 0, 0, 1, 0, "", "", NULL},
    {17, ":input: p[3]", CAGD_CODE_DIFFERS, -1, -1, 0, -1, 0, "", "", "0"},
    /* an infinity is itself, and a NaN is one */
    {18, ":input: kind = 0; x", CAGD_CODE_PROVED, 1, 1, 1, 20, 0, "", "", NULL},
    {18, ":input: kind = 1; x", CAGD_CODE_DIFFERS, 0, 0, 0, 1, 0, "", "", "*"},
    {18, ":input: kind = 2; x", CAGD_CODE_DIFFERS, 0, 0, 0, 1, 0, "", "", "*"},
    {18, ":input: kind = 3; x", CAGD_CODE_DIFFERS, 0, 0, 0, 1, 0, "", "", "*"},
    {18, ":input: kind = 5; x", CAGD_CODE_PROVED, 1, 1, 1, 20, 0, "", "", NULL},
    {18, ":input: kind = 9; x", CAGD_CODE_DIFFERS, 0, 0, 0, 1, 0, "", "", "*"},
    {18, ":input: kind = 10; x", CAGD_CODE_PROVED, 1, 1, 1, 20, 0, "", "", NULL},
    {18, ":input: kind = 11; x", CAGD_CODE_DIFFERS, 0, 0, 0, 1, 0, "", "", "*"},
    {18, ":input: kind = 12; x", CAGD_CODE_DIFFERS, 0, 0, 0, 1, 0, "", "", "*"},
    {18, ":input: kind = 14; x", CAGD_CODE_DIFFERS, 0, 0, 0, 1, 0, "", "", "*"},
    /* roots at points are intervals */
    {19, ":input: x\n:roots: enclose", CAGD_CODE_ENCLOSED, 1, 0, 0, 20, 0,
     "a square root, which is asked for as an interval", "", NULL},
    {19, ":input: x\n:roots: refuse", CAGD_CODE_UNDECIDED, 0, 0, 0, 0, 0, "a square root that is not rational", "",
     "*"},
    {19, ":input: x", CAGD_CODE_PROVED, 1, 1, 1, 20, 0, "", "", NULL},
    {20, ":input: x\n:roots: enclose", CAGD_CODE_DIFFERS, 0, 0, 0, 1, 0, "", "", "*"},
    {21, ":input: x\n:roots: refuse", CAGD_CODE_PROVED, 1, 1, 1, 20, 0, "", "", NULL},
    {10, ":input: x", CAGD_CODE_UNDECIDED, 0, 0, 0, 0, 0, "no point was found where the preconditions are true", "",
     NULL},
};

static void one(const struct cagd_code_program *p, int number, const struct asked *a)
{
    char text[400];
    struct cagd_code_harness_error error;
    int tells = strstr(a->lines, ":output:") != NULL;
    snprintf(text, sizeof text, ":::{exactly} it\n:input: which = %d\n%s\n:call: double r = 1;\n%s:::\n", a->which,
             a->lines, tells ? "" : ":expect: r = 1\n");
    struct cagd_code_harness *h = cagd_code_read_harness(text, &error);
    if (h == NULL)
        fail_msg("case %d: %s", number, error.cause);
    struct cagd_code_verdict *v = cagd_code_decide(p, h, h->points > 0 ? h->points : 20, 0);
    if (v->word != a->word || (a->paths >= 0 && (v->paths != a->paths || v->proved != a->proved)) ||
        v->exhaustive != a->exhaustive || (a->points >= 0 && v->points != a->points) || v->undefined != a->undefined)
        fail_msg("case %d: word %d, paths %d, proved %d, exhaustive %d, points %ld, undefined %ld; %s; %s", number,
                 (int)v->word, v->paths, v->proved, v->exhaustive, v->points, v->undefined, v->message, v->open);
    if (strncmp(v->message, a->message, strlen(a->message)) != 0 || strncmp(v->open, a->open, strlen(a->open)) != 0 ||
        (*a->open == 0 && *v->open != 0))
        fail_msg("case %d: message '%s', open '%s'", number, v->message, v->open);
    assert_true((a->at != NULL) == (v->point != NULL));
    if (a->at != NULL && *a->at != '*')
        assert_string_equal(v->point->input[v->point->inputs - 1].value[0], a->at);
    assert_int_equal(v->untold > 0, a->which == 0);
    if (a->which == 3)
        assert_int_equal(v->seen, v->patterns);
    cagd_code_verdict_free(v);
    cagd_code_harness_free(h);
}

/* The worst of each result, in whatever order they are told. */
static void the_worst_of_each_result(void **state)
{
    (void)state;
    char message[400];
    struct cagd_code_harness_error error;
    struct cagd_code_program *p = cagd_code_load(DECIDED, sizeof message, message);
    struct cagd_code_harness *h =
        cagd_code_read_harness(":::{exactly} it\n:input: which = 15\n:input: x\n:call: double r = 1;\n"
                               ":output: same\n:output: seventh\n:output: seventh again\n:output: same again\n:::\n",
                               &error);
    assert_non_null(p);
    if (h == NULL)
        fail_msg("%s", error.cause);
    struct cagd_code_verdict *v = cagd_code_decide(p, h, 20, 200);
    assert_int_equal(v->worsts, 4);
    for (int k = 0; k < v->worsts; k++) {
        int is_rounded = strncmp(v->worst[k].name, "seventh", 7) == 0;
        assert_true(is_rounded ? v->worst[k].ulps > 0.25 && v->worst[k].ulps <= 0.5 : v->worst[k].ulps == 0);
        assert_true(is_rounded ? v->worst[k].mean > 0.1 : v->worst[k].mean == 0);
        assert_int_equal(v->worst[k].by_chance, 101); /* of 200 more than half */
        assert_true(v->worst[k].mean <= v->worst[k].ulps);
        for (int order = 0; order < CAGD_CODE_ORDERS; order++) /* of no sum */
            assert_true(v->worst[k].mean_in_order[order] == v->worst[k].mean);
        region_mark mark = region_open(); /* what is told is the worst point's */
        num_q x = cagd_from_double_q(to_double_q(cagd_from_string_q(v->worst[k].point->input[1].value[0])));
        num_q exact = is_rounded ? div_q(x, from_int_q(7)) : x;
        int exponent;
        assert_true(v->worst[k].computed == to_double_q(exact)); /* one operation is rounded to the nearest */
        assert_string_equal(v->worst[k].exact, strlen(cagd_to_string_q(exact)) < 64 ? cagd_to_string_q(exact) : "");
        frexp(to_double_q(exact), &exponent);
        double wrong_by = fabs(to_double_q(sub_q(from_double_q(v->worst[k].computed), exact)));
        assert_true(fabs(wrong_by / ldexp(1, exponent - 53) - v->worst[k].ulps) <= 1e-12);
        region_drop(mark);
    }
    assert_int_equal(v->rounded, 200);
    assert_int_equal(v->turned, 0);
    cagd_code_verdict_free(v);
    cagd_code_harness_free(h);
    cagd_code_unload(p);
}

static void verdicts(void **state)
{
    (void)state;
    char message[400];
    struct cagd_code_program *p = cagd_code_load(DECIDED, sizeof message, message);
    if (p == NULL)
        fail_msg("%s", message);
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        one(p, (int)k, &list[k]);
    cagd_code_unload(p);
}

/* What keeps a run from its end is told, and what keeps it from its beginning. */
static void runs_end_for_a_reason(void **state)
{
    (void)state;
    static const char *const value[] = {"1/3"}, *const wrong[] = {"1/x"};
    static const struct cagd_code_input good = {"x", 0, value, NULL, 1}, bad = {"which", 0, wrong, NULL, 1};
    static const struct {
        struct cagd_code_job job;
        enum cagd_code_end end;
        const char *message;
    } jobs[] = {
        {{.entry = "never_ends", .most_seconds = 1}, CAGD_CODE_BOUND, "more time than is allowed"},
        {{.entry = "asks_for_more", .inputs = 1, .input = &good}, CAGD_CODE_REFUSED, "the harness has no input x of 2"},
        {{.entry = "asks_for_more"}, CAGD_CODE_REFUSED, "the harness has no input x of 2"},
        {{.entry = "cagd_code_entry", .inputs = 1, .input = &bad}, CAGD_CODE_REFUSED, "\"1/x\" is no number"},
        {{.entry = "nothing"}, CAGD_CODE_REFUSED, "there is no function nothing"}};
    char message[400];
    struct cagd_code_program *p = cagd_code_load(DECIDED, sizeof message, message);
    assert_non_null(p);
    for (size_t k = 0; k < sizeof jobs / sizeof *jobs; k++) {
        struct cagd_code_outcome *o = cagd_code_run(p, &jobs[k].job);
        assert_non_null(o);
        if (o->end != jobs[k].end || strcmp(o->message, jobs[k].message) != 0)
            fail_msg("job %zu: end %d, %s", k, (int)o->end, o->message);
        cagd_code_outcome_free(o);
    }
    cagd_code_unload(p);
    assert_null(cagd_code_load("/nowhere/object.so", sizeof message, message));
    assert_string_equal(message, "/nowhere/object.so: No such file or directory");
    p = cagd_code_load("/dev/null", sizeof message, message); /* no object */
    assert_non_null(p);
    struct cagd_code_outcome *o = cagd_code_run(p, &jobs[0].job);
    assert_int_equal(o->end, CAGD_CODE_REFUSED);
    assert_non_null(strstr(o->message, "file too short"));
    cagd_code_outcome_free(o);
    cagd_code_unload(p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(verdicts), unit(the_worst_of_each_result), unit(runs_end_for_a_reason)};
    return run_unit_tests(tests);
}
