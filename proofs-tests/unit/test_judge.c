/* test_judge.c -- the judge of the claims, judged: hand-made claims whose outcome is known. */
#include "proofs-tests/unit/unit_exact.h"

#include "chapters/judge/run.h"
#include "chapters/judge/words.h"
#include "exact/number/field.h"
#include "exact/words.h"

#include "core/clock.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FIELD   1
#define G(name) name##_f
#include "proofs-tests/unit/judge_bodies.tmpl.h"
#undef G
#undef FIELD
#define FIELD   0
#define G(name) name##_q
#include "proofs-tests/unit/judge_bodies.tmpl.h"
#undef G
#define G(name) name##_i
#include "proofs-tests/unit/judge_bodies.tmpl.h"
#undef G
#define G(name) name##_m
#include "proofs-tests/unit/judge_bodies.tmpl.h"
#undef G

/* A claim of that name in all four number types, or in one. */
#define EVERYWHERE(body_name)                                                                                          \
    .name = #body_name, .scope = "", .body = {body_name##_f, body_name##_q, body_name##_i, body_name##_m}
#define IN(type, suffix, body_name) .name = #body_name, .scope = "", .body = {[type] = body_name##suffix}

static claim_result *judge_one(const claim *c)
{
    const run_options options = {.jobs = 1};
    return judge_claims(&c, 1, &options);
}

static const char *shown(const type_result *b, const char *name)
{
    for (int k = 0; k < b->exhibits; k++)
        if (strcmp(b->shown[k].name, name) == 0)
            return b->shown[k].value;
    return NULL;
}

/* ---- What holds ------------------------------------------------------------------------------- */

static void test_an_identity_is_proved(void **state)
{
    (void)state;
    const claim c = {EVERYWHERE(square_of_sum)};
    claim_result *r = judge_one(&c);
    assert_true(r->as_expected);
    assert_int_equal(r->outcome, HOLDS);
    assert_int_equal(r->evidence, PROVED);
    assert_string_equal(r->scope, "all data");
    static const outcome expected[] = {HOLDS, HOLDS, UNDECIDED, HOLDS}; /* intervals confirm nothing */
    static const int cases[] = {1, 24, 12, 24};
    for (number_type t = 0; t < NUMBER_TYPES; t++) {
        assert_true(r->by[t].ran);
        assert_true(r->by[t].control_caught);
        assert_int_equal(r->by[t].outcome, expected[t]);
        assert_int_equal(r->by[t].cases, cases[t]);
        assert_int_equal(r->by[t].compared, cases[t]);
        assert_int_equal(r->by[t].faults, 0);
        assert_non_null(shown(&r->by[t], "x"));
        assert_null(shown(&r->by[t], "left"));
    }
    free_results(r, 1);
}

static void test_evidence_is_that_of_the_strongest_type(void **state)
{
    (void)state;
    static const evidence expected[] = {PROVED, SAMPLED, ENCLOSED, MEASURED};
    static const char *const scope[] = {"all data", "24 random instances", "12 random instances",
                                        "24 random instances"};
    const claim list[] = {{IN(FIELD_TYPE, _f, square_of_sum)},
                          {IN(RATIONAL_TYPE, _q, square_of_sum)},
                          {IN(INTERVAL_TYPE, _i, square_of_sum)},
                          {IN(DOUBLE_TYPE, _m, square_of_sum)}};
    for (number_type t = 0; t < NUMBER_TYPES; t++) {
        claim_result *r = judge_one(&list[t]);
        assert_true(r->as_expected);
        assert_int_equal(r->outcome, HOLDS);
        assert_int_equal(r->evidence, expected[t]);
        assert_string_equal(r->scope, scope[t]);
        for (number_type other = 0; other < NUMBER_TYPES; other++)
            assert_int_equal(r->by[other].ran, other == t);
        free_results(r, 1);
    }
}

static void test_every_degree_is_visited(void **state)
{
    (void)state;
    const claim identity = {EVERYWHERE(power_of_degree), .degree_low = 1, .degree_high = 4, .degree_sampled = 30};
    claim_result *r = judge_one(&identity);
    assert_true(r->as_expected);
    assert_string_equal(r->scope, "n = 1 to 4; all data");
    assert_int_equal(r->by[FIELD_TYPE].cases, 4);
    assert_int_equal(r->by[FIELD_TYPE].degree_high, 4);
    for (number_type t = RATIONAL_TYPE; t < NUMBER_TYPES; t++) { /* one case each, from the lowest on */
        assert_int_equal(r->by[t].cases, 30);
        assert_int_equal(r->by[t].degree_low, 1);
        assert_int_equal(r->by[t].degree_high, 30);
    }
    assert_true(r->by[DOUBLE_TYPE].worst > 0 && r->by[DOUBLE_TYPE].worst <= 1);
    assert_true(r->by[INTERVAL_TYPE].worst > 0 && r->by[INTERVAL_TYPE].worst < 1e-20);
    assert_true(r->by[RATIONAL_TYPE].worst == 0);
    free_results(r, 1);

    const claim decision = {IN(RATIONAL_TYPE, _q, power_of_degree), .kind = DECISION, .degree_low = 3, .degree_high = 5,
                            .degree_sampled = 5};
    r = judge_one(&decision);
    assert_true(r->as_expected);
    assert_int_equal(r->evidence, DECIDED);
    assert_int_equal(r->by[RATIONAL_TYPE].cases, 3);
    assert_string_equal(r->scope, "n = 3 to 5");
    free_results(r, 1);

    const claim all = {IN(FIELD_TYPE, _f, square_of_sum), .all_degrees = 1};
    r = judge_one(&all);
    assert_string_equal(r->scope, "every n; all data");
    free_results(r, 1);
}

static void test_deep_is_deeper(void **state)
{
    (void)state;
    const claim c = {IN(RATIONAL_TYPE, _q, square_of_sum)}, *list[] = {&c};
    const run_options options = {.jobs = 1, .deep = 1};
    claim_result *r = judge_claims(list, 1, &options);
    assert_int_equal(r->by[RATIONAL_TYPE].cases, 1000);
    free_results(r, 1);
}

/* ---- What does not ---------------------------------------------------------------------------- */

static void test_false_is_false(void **state)
{
    (void)state;
    const claim c = {EVERYWHERE(one_is_zero)};
    claim_result *r = judge_one(&c);
    assert_false(r->as_expected);
    assert_int_equal(r->outcome, FAILS);
    assert_int_equal(r->evidence, NO_EVIDENCE);
    for (number_type t = 0; t < NUMBER_TYPES; t++) {
        const type_result *b = &r->by[t];
        assert_int_equal(b->outcome, FAILS);
        assert_int_equal(b->cases, 1); /* the first failing case ends the run, and shows its first difference */
        assert_int_equal(b->compared, 2);
        assert_int_equal(b->exhibits, t == FIELD_TYPE ? 3 : 4); /* with the number that x is */
        assert_int_equal(shown(b, "x0") == NULL, t == FIELD_TYPE);
        assert_string_equal(shown(b, "compared"), "x + 1 and x");
        assert_non_null(shown(b, "left"));
        assert_non_null(shown(b, "right"));
        assert_true(b->seed != 0);
    }
    assert_string_equal(shown(&r->by[FIELD_TYPE], "left"), "x0+1");
    free_results(r, 1);
}

static void test_nothing_compared_is_a_failure(void **state)
{
    (void)state;
    const claim c = {EVERYWHERE(nothing)};
    claim_result *r = judge_one(&c);
    assert_false(r->as_expected);
    for (number_type t = 0; t < NUMBER_TYPES; t++) {
        assert_int_equal(r->by[t].outcome, FAILS);
        assert_false(r->by[t].control_caught);
        assert_string_equal(shown(&r->by[t], "empty"), "nothing was compared");
    }
    free_results(r, 1);
}

/* A letter k counts orders, or something else, from 0 on. */
static void test_orders_are_told_as_they_are(void **state)
{
    (void)state;
    static const char *const scope[] = {"k = 0 to 6; all data", "k = 1 to 6; all data", "every k; all data"};
    for (int k = 0; k < 3; k++) {
        const claim c = {IN(FIELD_TYPE, _f, square_of_sum),
                         .letter = "k",
                         .degree_low = k == 1,
                         .degree_high = 6,
                         .degree_sampled = 6,
                         .all_degrees = k == 2};
        claim_result *r = judge_one(&c);
        assert_string_equal(r->scope, scope[k]);
        free_results(r, 1);
    }
}

/* Of what was not run nothing is known. */
static void test_a_claim_that_is_not_run(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        const claim c = {.name = "no_body", .scope = "", .kind = k == 0 ? IDENTITY : COUNTEREXAMPLE};
        claim_result *r = judge_one(&c);
        assert_int_equal(r->outcome, UNDECIDED);
        assert_int_equal(r->evidence, NO_EVIDENCE);
        assert_false(r->as_expected);
        free_results(r, 1);
    }
}

/* The largest part of the bound is none where an error is no number. */
static void is_no_number_at_two_m(trial *T)
{
    num_m one = exact_m(1), third = div_m(one, exact_m(3));
    same_m(T, mul_m(third, exact_m(3)), fault(T, one, exact_m(2)));
    same_m(T, exact_m(T->degree == 2 ? NAN : 1), one);
}
static void test_an_error_that_is_no_number_is_the_largest(void **state)
{
    (void)state;
    const claim c = {IN(DOUBLE_TYPE, _m, is_no_number_at_two), .degree_low = 1, .degree_high = 3, .degree_sampled = 3};
    claim_result *r = judge_one(&c);
    assert_int_equal(r->outcome, FAILS);
    assert_true(isnan(r->by[DOUBLE_TYPE].worst));
    free_results(r, 1);
}

static void test_a_control_must_fail_by_comparison(void **state)
{
    (void)state;
    const claim list[] = {{IN(FIELD_TYPE, _f, control_passes)},
                          {IN(FIELD_TYPE, _f, control_is_empty)},
                          {IN(FIELD_TYPE, _f, control_divides_by_zero)},
                          {IN(RATIONAL_TYPE, _q, control_is_empty)},
                          {IN(RATIONAL_TYPE, _q, control_divides_by_zero)}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        claim_result *r = judge_one(&list[k]);
        const type_result *b = &r->by[k < 3 ? FIELD_TYPE : RATIONAL_TYPE];
        assert_int_equal(b->outcome, HOLDS);
        assert_false(b->control_caught);
        assert_false(r->as_expected);
        assert_int_equal(r->outcome, UNDECIDED);
        assert_int_equal(r->evidence, NO_EVIDENCE);
        free_results(r, 1);
    }
}

static void test_one_bad_type_spoils_the_claim(void **state)
{
    (void)state;
    const claim c = {
        .name = "half_wrong", .scope = "", .body = {[FIELD_TYPE] = square_of_sum_f, [RATIONAL_TYPE] = one_is_zero_q}};
    claim_result *r = judge_one(&c);
    assert_int_equal(r->by[FIELD_TYPE].outcome, HOLDS);
    assert_false(r->as_expected);
    assert_int_equal(r->outcome, FAILS);
    assert_int_equal(r->evidence, NO_EVIDENCE);
    free_results(r, 1);
}

/* ---- Undefined, unable, crowded ---------------------------------------------------------------- */

static void test_undefined_fails(void **state)
{
    (void)state;
    const claim c = {.name = "divides_by_zero",
                     .scope = "",
                     .body = {[FIELD_TYPE] = divides_by_zero_f,
                              [RATIONAL_TYPE] = divides_by_zero_q,
                              [INTERVAL_TYPE] = divides_by_zero_i}};
    claim_result *r = judge_one(&c);
    assert_false(r->as_expected);
    for (number_type t = FIELD_TYPE; t <= INTERVAL_TYPE; t++) {
        assert_int_equal(r->by[t].outcome, FAILS);
        assert_true(r->by[t].faults & FAULT_UNDEFINED);
        assert_string_equal(shown(&r->by[t], "undefined"), "a division by zero");
    }
    free_results(r, 1);
}

static void test_unable_is_neither_true_nor_false(void **state)
{
    (void)state;
    const claim c = {EVERYWHERE(unable)};
    claim_result *r = judge_one(&c);
    assert_false(r->as_expected);
    assert_int_equal(r->outcome, UNDECIDED);
    for (number_type t = 0; t < NUMBER_TYPES; t++) {
        assert_int_equal(r->by[t].outcome, UNDECIDED);
        assert_int_equal(r->by[t].faults, FAULT_UNABLE);
        assert_false(r->by[t].control_caught); /* nor does a control fail so */
    }
    free_results(r, 1);

    const claim before = {EVERYWHERE(false_then_unable)};
    r = judge_one(&before);
    for (number_type t = 0; t < NUMBER_TYPES; t++)
        assert_int_equal(r->by[t].outcome, FAILS);
    free_results(r, 1);
}

static void test_a_crowded_field_grows(void **state)
{
    (void)state;
    const claim c = {IN(FIELD_TYPE, _f, forty_variables)};
    claim_result *r = judge_one(&c);
    assert_true(r->as_expected);
    assert_int_equal(r->evidence, PROVED);
    assert_int_equal(r->by[FIELD_TYPE].faults, 0);
    assert_int_equal(r->by[FIELD_TYPE].compared, 1); /* of the last attempt only */
    assert_int_equal(r->by[FIELD_TYPE].exhibits, 1);
    assert_string_equal(r->scope, "all data");
    free_results(r, 1);

    const claim most = {IN(FIELD_TYPE, _f, too_many_variables)};
    r = judge_one(&most);
    assert_false(r->as_expected);
    assert_int_equal(r->by[FIELD_TYPE].outcome, UNDECIDED);
    assert_true(r->by[FIELD_TYPE].faults & FAULT_CROWDED);
    free_results(r, 1);
}

/* What a claim was proved for is variable in all of its cases, and not in the last one alone. */
static void test_the_variables_of_all_cases(void **state)
{
    (void)state;
    const claim c = {IN(FIELD_TYPE, _f, numbers_above_two), .degree_low = 1, .degree_high = 3};
    claim_result *r = judge_one(&c);
    assert_true(r->as_expected);
    assert_string_equal(r->by[FIELD_TYPE].variables, "x0 y1");
    assert_string_equal(r->by[FIELD_TYPE].positive, "x0");
    free_results(r, 1);
}

/* ---- Signs -------------------------------------------------------------------------------------- */

static void test_signs(void **state)
{
    (void)state;
    const claim c = {EVERYWHERE(positive_sum)};
    claim_result *r = judge_one(&c);
    assert_true(r->as_expected);
    assert_int_equal(r->evidence, PROVED);
    assert_string_equal(r->scope, "all positive data");
    for (number_type t = 0; t < NUMBER_TYPES; t++)
        assert_true(r->by[t].control_caught);
    assert_int_equal(r->by[RATIONAL_TYPE].outcome, HOLDS);
    assert_int_equal(r->by[INTERVAL_TYPE].outcome, UNDECIDED); /* by its same() */
    free_results(r, 1);
}

static void test_coefficients_of_both_signs_decide_nothing(void **state)
{
    (void)state;
    const claim field = {IN(FIELD_TYPE, _f, sign_is_open)};
    claim_result *r = judge_one(&field);
    assert_false(r->as_expected);
    assert_int_equal(r->by[FIELD_TYPE].outcome, UNDECIDED);
    assert_int_equal(r->by[FIELD_TYPE].faults, FAULT_UNABLE);
    free_results(r, 1);
    const claim others = {
        .name = "sign_is_open",
        .scope = "",
        .body = {[RATIONAL_TYPE] = sign_is_open_q, [INTERVAL_TYPE] = sign_is_open_i, [DOUBLE_TYPE] = sign_is_open_m}};
    r = judge_one(&others);
    assert_true(r->as_expected);
    assert_int_equal(r->by[INTERVAL_TYPE].outcome, HOLDS); /* an interval can confirm an inequality */
    free_results(r, 1);
}

/* ---- Counterexamples ----------------------------------------------------------------------------- */

static void test_a_counterexample_fails_and_its_control_holds(void **state)
{
    (void)state;
    const claim c = {IN(RATIONAL_TYPE, _q, one_is_two), .kind = COUNTEREXAMPLE};
    claim_result *r = judge_one(&c);
    assert_true(r->as_expected);
    assert_int_equal(r->outcome, FAILS);
    assert_int_equal(r->evidence, DECIDED);
    assert_string_equal(r->scope, "the stated instance");
    assert_int_equal(r->by[RATIONAL_TYPE].cases, 1);
    assert_string_equal(shown(&r->by[RATIONAL_TYPE], "left"), "1");
    assert_string_equal(shown(&r->by[RATIONAL_TYPE], "right"), "2");
    free_results(r, 1);
}

static void test_what_is_no_counterexample(void **state)
{
    (void)state;
    static const struct {
        claim claim;
        outcome outcome;
        int control_caught;
    } list[] = {
        {{IN(RATIONAL_TYPE, _q, control_passes), .kind = COUNTEREXAMPLE}, HOLDS, 1},
        {{IN(RATIONAL_TYPE, _q, fails_by_division_only), .kind = COUNTEREXAMPLE}, UNDECIDED, 1},
        {{IN(RATIONAL_TYPE, _q, one_is_zero), .kind = COUNTEREXAMPLE}, FAILS, 0}, /* its control fails too   */
        {{IN(RATIONAL_TYPE, _q, nothing), .kind = COUNTEREXAMPLE}, UNDECIDED, 0}, /* nothing was compared    */
        {{IN(RATIONAL_TYPE, _q, control_is_empty), .kind = COUNTEREXAMPLE}, HOLDS, 0},
        {{IN(RATIONAL_TYPE, _q, square_of_sum), .kind = COUNTEREXAMPLE}, HOLDS, 0}, /* what is printed is true */
        {{IN(RATIONAL_TYPE, _q, control_is_unable), .kind = COUNTEREXAMPLE}, FAILS, 0},
        {{IN(RATIONAL_TYPE, _q, false_then_unable), .kind = COUNTEREXAMPLE}, UNDECIDED, 0},
    };
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        claim_result *r = judge_one(&list[k].claim);
        assert_int_equal(r->by[RATIONAL_TYPE].outcome, list[k].outcome);
        assert_int_equal(r->by[RATIONAL_TYPE].control_caught, list[k].control_caught);
        assert_false(r->as_expected);
        assert_int_equal(r->evidence, NO_EVIDENCE);
        free_results(r, 1);
    }
}

/* ---- Data and exhibits --------------------------------------------------------------------------- */

static num_q seen_q[3];
static num_i seen_i[3];
static num_m seen_m[3];
static void take_q(trial *T)
{
    seen_q[0] = unknown_q(T, "x", 0), seen_q[1] = positive_q(T, "w", 0), seen_q[2] = parameter_q(T, "t");
    seen_i[0] = seen_i[1] = seen_i[2] = from_int_i(0);
    trial S = {.state = T->seed}, U = {.state = T->seed};
    seen_i[0] = unknown_i(&S, "x", 0), seen_i[1] = positive_i(&S, "w", 0), seen_i[2] = parameter_i(&S, "t");
    seen_m[0] = unknown_m(&U, "x", 0), seen_m[1] = positive_m(&U, "w", 0), seen_m[2] = parameter_m(&U, "t");
    for (int k = 0; k < 3; k++) {
        agree(T, !T->planted && contains_i(seen_i[k], seen_q[k]) && width_i(seen_i[k]) == 0);
        agree(T, cagd_equal_q(from_double_q(seen_m[k].v), seen_q[k]) && error_bound_m(seen_m[k]) == 0);
    }
    agree(T, cagd_compare_q(seen_q[0], from_int_q(-1)) >= 0 && cagd_compare_q(seen_q[0], from_int_q(1)) <= 0);
    agree(T, cagd_compare_q(seen_q[1], from_ratio_q(1, 8)) >= 0 && cagd_compare_q(seen_q[1], from_int_q(4)) <= 0);
    agree(T, cagd_compare_q(seen_q[2], from_int_q(-1)) > 0 && cagd_compare_q(seen_q[2], from_int_q(2)) < 0);
}

static void test_data_are_the_same_dyadics_everywhere(void **state)
{
    (void)state;
    const claim c = {.name = "data", .scope = "", .body = {[RATIONAL_TYPE] = take_q}};
    claim_result *r = judge_one(&c);
    assert_true(r->as_expected);
    assert_int_equal(r->by[RATIONAL_TYPE].compared, 24 * 9);
    free_results(r, 1);
}

static void test_pick_stays_in_range(void **state)
{
    (void)state;
    trial T = {.state = 1};
    int count[7] = {0};
    for (int k = 0; k < 7000; k++) {
        int v = pick(&T, -3, 3);
        assert_true(v >= -3 && v <= 3);
        count[v + 3]++;
    }
    for (int k = 0; k < 7; k++)
        assert_true(count[k] > 800 && count[k] < 1200);
    assert_int_equal(pick(&T, 5, 5), 5);
}

static void test_exhibits(void **state)
{
    (void)state;
    const claim c = {EVERYWHERE(exhibits)};
    claim_result *r = judge_one(&c);
    assert_true(r->as_expected);
    for (number_type t = 0; t < NUMBER_TYPES; t++)
        assert_string_equal(shown(&r->by[t], "words"), "number 7");
    assert_string_equal(shown(&r->by[RATIONAL_TYPE], "half"), "1/2");
    assert_string_equal(shown(&r->by[RATIONAL_TYPE], "R"), "(1, 1/2) (-3, 3/4)");
    assert_string_equal(shown(&r->by[RATIONAL_TYPE], "w"), "1, 1/2, -3");
    assert_string_equal(shown(&r->by[DOUBLE_TYPE], "R"), "(1, 0.5) (-3, 0.75)");
    assert_string_equal(shown(&r->by[INTERVAL_TYPE], "half"), "[0.5, 0.5]");
    assert_string_equal(shown(&r->by[FIELD_TYPE], "half"), "1/2");
    free_results(r, 1);
}

/* What stands in the block, asked for by name. */
static void take_given_q(trial *T)
{
    num_q R[4], w[3], t = given_q(T, "t"), S[2];
    given_points_q(T, "R", 2, 2, R);
    given_points_q(T, "w", 3, 1, w);
    int n = given_whole(T, "n");
    S[0] = add_q(R[0], mul_q(t, R[2])), S[1] = add_q(R[1], mul_q(w[n], R[3]));
    found_points_q(T, "S", 1, 2, S);
    found_q(T, "R[1]", R[1]);
    found_whole(T, "2n", 2 * n);
    found_text(T, "F", given_text(T, "G"));
    agree(T, !T->planted && T->faulty == T->planted);
}

#define VALUES(...)                                                                                                    \
    (const char *const[]) { __VA_ARGS__ }
#define GIVEN_DATA                                                                                                     \
    {.name = "t", .rows = 1, .columns = 1, .value = VALUES("0x1.8p-1")},                                               \
        {.name = "R", .rows = 2, .columns = 2, .value = VALUES("1", "-2/3", "0.4", "1e2")},                            \
        {.name = "w", .rows = 3, .columns = 1, .value = VALUES("1", "2", "3")},                                        \
        {.name = "n", .rows = 1, .columns = 1, .value = VALUES("2")},                                                  \
        {.name = "G", .rows = 1, .columns = 0, .value = VALUES("y^2")},                                                \
        {.name = "S", .rows = 1, .columns = 2, .value = VALUES("1.3", "898/3"), .place = IN_RESULT},                   \
        {.name = "R[1]", .rows = 1, .columns = 1, .value = VALUES("-2/3"), .place = IN_RESULT},                        \
        {.name = "2n", .rows = 1, .columns = 1, .value = VALUES("4"), .place = IN_RESULT},                             \
    {                                                                                                                  \
        .name = "F", .rows = 1, .columns = 0, .value = VALUES("y^2"), .place = IN_RESULT                               \
    }
enum { GIVEN_ENTRIES = 9 };

static void test_given_data(void **state)
{
    (void)state;
    const datum good[] = {GIVEN_DATA, {.name = NULL}};
    const claim c = {IN(RATIONAL_TYPE, _q, take_given), .kind = DECISION, .data = good};
    claim_result *r = judge_one(&c);
    assert_true(r->as_expected);
    assert_string_equal(shown(&r->by[RATIONAL_TYPE], "R"), "(1, -2/3) (0.4, 1e2)");
    assert_string_equal(shown(&r->by[RATIONAL_TYPE], "t"), "0x1.8p-1");
    assert_string_equal(shown(&r->by[RATIONAL_TYPE], "S"), "(1.3, 898/3)");
    assert_string_equal(shown(&r->by[RATIONAL_TYPE], "F"), "y^2");
    free_results(r, 1);
}

/* Every entry of the block spoiled in turn: another value, another shape, another name, left out, in another place; and one
 * too many. */
static void test_given_data_are_tied_to_the_body(void **state)
{
    (void)state;
    const datum good[] = {GIVEN_DATA, {.name = NULL}};
    for (int k = 0; k < GIVEN_ENTRIES; k++)
        for (int way = 0; way < 6; way++) {
            datum bad[GIVEN_ENTRIES + 2] = {GIVEN_DATA};
            static const char *const others[] = {"7", "7", "7", "7"};
            if (way == 0 && bad[k].place == IN_RESULT)
                bad[k].value = others;
            else if (way == 1)
                bad[k].rows++, bad[k].value = others;
            else if (way == 2)
                bad[k].name = "other";
            else if (way == 3)
                bad[k] = bad[GIVEN_ENTRIES - 1], bad[GIVEN_ENTRIES - 1].name = NULL;
            else if (way == 4)
                bad[k].place = bad[k].place == IN_DATA ? IN_RESULT : IN_DATA;
            else if (way == 5)
                bad[GIVEN_ENTRIES] = good[k], bad[GIVEN_ENTRIES].name = "unused";
            else
                continue;
            const claim c = {IN(RATIONAL_TYPE, _q, take_given), .kind = DECISION, .data = bad};
            claim_result *r = judge_one(&c);
            assert_false(r->as_expected);
            assert_non_null(shown(&r->by[RATIONAL_TYPE], "mistake"));
            free_results(r, 1);
        }
    const claim none = {IN(RATIONAL_TYPE, _q, take_given), .kind = DECISION};
    claim_result *r = judge_one(&none);
    assert_false(r->as_expected);
    free_results(r, 1);
}

/* w = 0, and in the control w = 1: a counterexample to "w is 1"; what is given instead is for the control alone. */
static void weight_is_one_q(trial *T)
{
    num_q w = given_q(T, "w");
    found_q(T, "w + 1", add_q(w, from_int_q(1)));
    same_q(T, w, from_int_q(1));
}
static void refuted_q(trial *T) { refute(T, fault(T, 1, 2) == 2); }

static void test_data_instead(void **state)
{
    (void)state;
    const datum data[] = {{.name = "w", .rows = 1, .columns = 1, .value = VALUES("0")},
                          {.name = "w", .rows = 1, .columns = 1, .value = VALUES("1"), .place = IN_INSTEAD},
                          {.name = "w + 1", .rows = 1, .columns = 1, .value = VALUES("1"), .place = IN_RESULT},
                          {.name = NULL}};
    const claim c = {IN(RATIONAL_TYPE, _q, weight_is_one), .kind = COUNTEREXAMPLE, .data = data};
    claim_result *r = judge_one(&c);
    assert_true(r->as_expected);
    free_results(r, 1);
    const datum unused[] = {data[0],
                            data[2],
                            data[1],
                            {.name = "v", .rows = 1, .columns = 1, .value = VALUES("1"), .place = IN_INSTEAD},
                            {.name = NULL}};
    const claim d = {IN(RATIONAL_TYPE, _q, weight_is_one), .kind = COUNTEREXAMPLE, .data = unused};
    r = judge_one(&d);
    assert_false(r->as_expected);
    assert_false(r->by[RATIONAL_TYPE].control_caught);
    free_results(r, 1);
    /* A stated result that does not come out is no counterexample, although the comparison fails. */
    const datum wrong[] = {data[0],
                           data[1],
                           {.name = "w + 1", .rows = 1, .columns = 1, .value = VALUES("2"), .place = IN_RESULT},
                           {.name = NULL}};
    const claim e = {IN(RATIONAL_TYPE, _q, weight_is_one), .kind = COUNTEREXAMPLE, .data = wrong};
    r = judge_one(&e);
    assert_false(r->as_expected);
    assert_int_equal(r->by[RATIONAL_TYPE].outcome, UNDECIDED);
    free_results(r, 1);
    const claim f = {IN(RATIONAL_TYPE, _q, refuted), .kind = COUNTEREXAMPLE}, g = {IN(RATIONAL_TYPE, _q, refuted)};
    r = judge_one(&f);
    assert_true(r->as_expected);
    free_results(r, 1);
    r = judge_one(&g);
    assert_true(r->as_expected); /* fault() is the other way round in an identity */
    free_results(r, 1);
}

/* In the other types: a variable of the field, an interval, a binary64 with its error. */
static void given_f_body(trial *T)
{
    num_f w = given_f(T, "w");
    found_f(T, "v", w);
    same_f(T, mul_f(w, from_int_f(2)), add_f(w, fault(T, w, from_int_f(1))));
}
static void given_m_body(trial *T)
{
    num_m a = given_m(T, "a"), b = given_m(T, "b");
    found_m(T, "a", a);
    agree(T, error_bound_m(a) == 0 && error_bound_m(b) > 0 && error_bound_m(b) < 1e-16 && !T->planted);
}
static void given_i_body(trial *T)
{
    num_i a = given_i(T, "a");
    found_i(T, "3a", mul_i(a, from_int_i(3)));
    agree(T, contains_i(a, from_ratio_q(1, 3)) && width_i(a) > 0 && !T->planted);
}

static void test_given_in_every_type(void **state)
{
    (void)state;
    const datum f[] = {{.name = "w", .rows = 1, .columns = 1, .value = VALUES("w1")},
                       {.name = "v", .rows = 1, .columns = 1, .value = VALUES("w1"), .place = IN_RESULT},
                       {.name = NULL}},
                m[] = {{.name = "a", .rows = 1, .columns = 1, .value = VALUES("0.5")},
                       {.name = "b", .rows = 1, .columns = 1, .value = VALUES("0.35")},
                       {.name = "a", .rows = 1, .columns = 1, .value = VALUES("0x1p-1"), .place = IN_RESULT},
                       {.name = NULL}},
                i[] = {{.name = "a", .rows = 1, .columns = 1, .value = VALUES("1/3")},
                       {.name = "3a", .rows = 1, .columns = 1, .value = VALUES("1"), .place = IN_RESULT},
                       {.name = NULL}};
    const claim list[] = {{.name = "f", .scope = "", .body = {[FIELD_TYPE] = given_f_body}, .data = f},
                          {.name = "m", .scope = "", .body = {[DOUBLE_TYPE] = given_m_body}, .data = m},
                          {.name = "i", .scope = "", .body = {[INTERVAL_TYPE] = given_i_body}, .data = i}};
    for (int k = 0; k < 3; k++) {
        claim_result *r = judge_one(&list[k]);
        assert_true(r->as_expected);
        free_results(r, 1);
    }
}

/* A claim that was not compiled in carries what it is about. */
static void compare_context_q(trial *T)
{
    const int *pair = T->claim->context;
    same_q(T, from_int_q(pair[0]), from_int_q(fault(T, pair[1], pair[1] + 1)));
}
static void test_context(void **state)
{
    (void)state;
    static const int equal[] = {5, 5}, unequal[] = {5, 6};
    const claim list[] = {{IN(RATIONAL_TYPE, _q, compare_context), .kind = DECISION, .context = equal},
                          {IN(RATIONAL_TYPE, _q, compare_context), .kind = DECISION, .context = unequal}};
    for (int k = 0; k < 2; k++) {
        claim_result *r = judge_one(&list[k]);
        assert_int_equal(r->as_expected, k == 0);
        free_results(r, 1);
    }
}

/* ---- Several jobs --------------------------------------------------------------------------------- */

static const claim many[] = {{EVERYWHERE(square_of_sum)},
                             {EVERYWHERE(power_of_degree), .degree_low = 1, .degree_high = 6, .degree_sampled = 9},
                             {EVERYWHERE(one_is_zero)},
                             {EVERYWHERE(nothing)},
                             {EVERYWHERE(unable)},
                             {EVERYWHERE(false_then_unable)},
                             {EVERYWHERE(positive_sum)},
                             {EVERYWHERE(sign_is_open)},
                             {EVERYWHERE(exhibits)},
                             {EVERYWHERE(forty_variables)},
                             {IN(FIELD_TYPE, _f, too_many_variables)},
                             {IN(FIELD_TYPE, _f, divides_by_zero)},
                             {IN(RATIONAL_TYPE, _q, one_is_two), .kind = COUNTEREXAMPLE}};
enum { MANY = sizeof many / sizeof *many };

/* How often the progress of each was told: in each of its number types. */
static int told_of[MANY];
static void count_progress(void *context, int done, int total, const char *name)
{
    int *last = context;
    assert_int_equal(done, *last + 1);
    assert_int_equal(total, 10 * NUMBER_TYPES + 3);
    int k = 0;
    while (k < MANY && many[k].name != name)
        k++;
    assert_true(k < MANY);
    told_of[k]++;
    *last = done;
}

/* True up to degree 2: the case that fails is told with its degree, once, in the letter of the claim. */
static void at_most_two_q(trial *T)
{
    if (T->deep)
        show_text(T, "n", "%d", T->degree);
    same_q(T, from_int_q(T->degree > 2), from_int_q(fault(T, 0, 1)));
}
static void test_a_failing_case_tells_its_degree(void **state)
{
    (void)state;
    for (int k = 0; k < 3; k++) {
        claim c = {IN(RATIONAL_TYPE, _q, at_most_two), .degree_low = 1, .degree_high = 4, .degree_sampled = 4};
        c.letter = k == 1 ? "k" : "n";
        const claim *list = &c;
        claim_result *r = judge_claims(&list, 1, &(run_options){.jobs = 1, .deep = k == 2});
        const type_result *b = &r->by[RATIONAL_TYPE];
        int told = 0;
        for (int m = 0; m < b->exhibits; m++)
            if (strcmp(b->shown[m].name, c.letter) == 0) {
                assert_string_equal(b->shown[m].value, "3");
                told++;
            }
        assert_int_equal(b->outcome, FAILS);
        assert_int_equal(told, 1);
        free_results(r, 1);
    }
}

/* False from degree 3 on where x_1 is negative, w > 1, the fraction s is not 1/2 and the whole number not its least one;
 * undefined where y = 0. */
static void fails_in_one_corner_q(trial *T)
{
    num_q x[] = {unknown_q(T, "x", 0), unknown_q(T, "x", 1)}, w = positive_q(T, "w", 4), s = inside_q(T, "s"),
          t = parameter_q(T, "t"), y = unknown_q(T, "y", 2), n = whole_q(T, "n", 5, 9);
    int corner = T->degree >= 3 && cagd_sign_q(x[1]) < 0 && cagd_compare_q(w, from_int_q(1)) > 0 &&
                 !cagd_equal_q(s, from_ratio_q(1, 2)) && cagd_compare_q(n, from_int_q(5)) > 0;
    show_q(T, "quotient", div_q(t, y));
    same_q(T, add_q(x[0], from_int_q(corner)), add_q(x[0], from_int_q(fault(T, 0, 2))));
}
static void false_everywhere_q(trial *T) { same_q(T, from_int_q(1), from_int_q(2 * T->degree)); }
static void true_of_any_q(trial *T) { nonnegative_q(T, positive_q(T, "w", 0)); }
/* Decided to be false where w > 2, which its data are. */
static void at_most_q(trial *T)
{
    num_q w = add_q(positive_q(T, "w", 0), from_int_q(2));
    about(T, "whether w_0 + 2 is at most 2");
    agree(T, cagd_compare_q(w, from_int_q(fault(T, 2, 1))) <= 0);
}
static void false_everywhere_f(trial *T) { same_f(T, variable_f("x"), from_int_f(2 * T->degree)); }
static void test_the_smallest_instance_of_a_failure(void **state)
{
    static const char *const wanted[][2] = {{"m", "3"},    {"x0 to x1", "0, -1"}, {"w4", "2"}, {"s", "1/3"},
                                            {"t", "1/2"},  {"y2", "1"},           {"n", "6"},  {"quotient", "1/2"},
                                            {"left", "1"}, {"right", "0"}};
    enum { WANTED = sizeof wanted / sizeof *wanted };
    (void)state;
    const claim c = {IN(RATIONAL_TYPE, _q, fails_in_one_corner), .letter = "m", .degree_low = 1, .degree_high = 4,
                     .degree_sampled = 4};
    claim_result *r = judge_one(&c);
    assert_false(r->as_expected);
    assert_int_equal(r->witnesses, WANTED);
    for (int k = 0; k < WANTED; k++) {
        assert_string_equal(r->witness[k].name, wanted[k][0]);
        assert_string_equal(r->witness[k].value, wanted[k][1]);
    }
    free_results(r, 1);
    /* Without data to choose, in the field alone, of a counterexample, and of what is as expected there is none. */
    const claim without[] = {
        {IN(RATIONAL_TYPE, _q, false_everywhere)},
        {IN(FIELD_TYPE, _f, false_everywhere)},
        {IN(RATIONAL_TYPE, _q, true_of_any), .kind = COUNTEREXAMPLE},
        {IN(RATIONAL_TYPE, _q, at_most_two), .letter = "m", .degree_low = 1, .degree_high = 2, .degree_sampled = 2}};
    for (size_t k = 0; k < sizeof without / sizeof *without; k++) {
        r = judge_one(&without[k]);
        assert_int_equal(r->as_expected, k == 3);
        assert_string_equal(r->scope, k == 3 ? "m = 1 to 2; 24 random instances" : "");
        assert_int_equal(r->witnesses, 0);
        free_results(r, 1);
    }
}

/* A claim whose control is not caught is open, and no instance is looked for.  Where no number of the search will do, it ends
 * after some hundred runs, long before its time is over. */
static int runs_of_search;
static void false_at_zero_q(trial *T)
{
    int k = 0;
    while (k < 6 && cagd_sign_q(unknown_q(T, "x", k)) == 0)
        k++;
    same_q(T, from_int_q(k == 6), from_int_q(0)); /* without a control */
}
static void false_of_no_whole_number_q(trial *T)
{
    num_q x = unknown_q(T, "x", 0);
    runs_of_search++;
    same_q(T, from_int_q(strchr(to_string_q(x), '/') != NULL), from_int_q(fault(T, 0, 2)));
}
static void test_an_instance_that_is_not_found(void **state)
{
    (void)state;
    const claim list[] = {
        {IN(RATIONAL_TYPE, _q, false_at_zero)},
        {IN(RATIONAL_TYPE, _q, false_of_no_whole_number), .degree_low = 1, .degree_high = 9, .degree_sampled = 9}};
    for (int k = 0; k < 2; k++) {
        runs_of_search = 0;
        claim_result *r = judge_one(&list[k]);
        assert_int_equal(r->outcome, k == 0 ? UNDECIDED : FAILS);
        assert_int_equal(r->witnesses, 0);
        assert_true(runs_of_search <= 400 + 3); /* with the case that fails, which is told, and its control */
        free_results(r, 1);
    }
}

/* What a case is told with: its data, and the condition that does not hold. */
static void test_a_failing_decision_tells_its_data_and_its_condition(void **state)
{
    (void)state;
    const claim c = {IN(RATIONAL_TYPE, _q, at_most), .kind = DECISION};
    claim_result *r = judge_one(&c);
    const type_result *b = &r->by[RATIONAL_TYPE];
    const exhibit *lists[] = {b->shown, r->witness};
    assert_int_equal(b->exhibits, 3);
    assert_int_equal(r->witnesses, 3);
    for (int k = 0; k < 2; k++) {
        assert_string_equal(lists[k][0].name, "w0");
        assert_string_equal(lists[k][1].name, "compared");
        assert_string_equal(lists[k][2].name, "condition");
        assert_string_equal(lists[k][2].value, "cagd_compare_q(w, from_int_q(fault(T, 2, 1))) <= 0");
    }
    assert_non_null(strchr(b->shown[0].value, '/')); /* the random number of the case */
    assert_string_equal(r->witness[0].value, "1");
    free_results(r, 1);
}

/* Without data there is one instance of each degree, and it is not tried again and again. */
static int times_run;
static void is_below_four_q(trial *T)
{
    times_run++;
    agree(T, T->degree < fault(T, 4, 1));
}
static void test_a_decision_without_data_is_tried_once_a_degree(void **state)
{
    (void)state;
    const claim c = {IN(RATIONAL_TYPE, _q, is_below_four), .kind = DECISION, .degree_low = 1, .degree_high = 4,
                     .degree_sampled = 4};
    times_run = 0;
    claim_result *r = judge_one(&c);
    assert_int_equal(r->outcome, FAILS);
    assert_int_equal(r->witnesses, 0);
    assert_true(times_run <= 4 + 1 + 4 + 4); /* the run, the case that is told, the control, the search */
    free_results(r, 1);
}

/* Of a failing case in intervals, which have no small instance, the data are told as well. */
static void false_of_any_i(trial *T) { vanishes_i(T, add_i(positive_i(T, "w", 0), from_int_i(1))); }
static void test_a_failing_case_tells_its_data(void **state)
{
    (void)state;
    const claim c = {IN(INTERVAL_TYPE, _i, false_of_any)};
    claim_result *r = judge_one(&c);
    const type_result *b = &r->by[INTERVAL_TYPE];
    assert_int_equal(b->outcome, FAILS);
    assert_true(b->exhibits >= 2);
    assert_string_equal(b->shown[0].name, "w0");
    free_results(r, 1);
}

static claim_result *judge_many(int jobs, int *finished)
{
    const claim *list[MANY];
    for (int k = 0; k < MANY; k++)
        list[k] = &many[k];
    *finished = 0;
    memset(told_of, 0, sizeof told_of);
    const run_options options = {.jobs = jobs, .progress = count_progress, .context = finished};
    return judge_claims(list, MANY, &options);
}

static void same_text(const char *a, const char *b)
{
    assert_int_equal(a == NULL, b == NULL);
    if (a != NULL)
        assert_string_equal(a, b);
}

static void test_results_do_not_depend_on_the_jobs(void **state)
{
    (void)state;
    int finished;
    double started = cagd_seconds(), taken = 0;
    claim_result *one = judge_many(1, &finished);
    assert_int_equal(finished, 10 * NUMBER_TYPES + 3);
    for (int k = 0; k < MANY; k++)
        for (number_type t = 0; t < NUMBER_TYPES; t++) {
            assert_true(one[k].by[t].seconds >= 0);
            taken += one[k].by[t].seconds;
        }
    assert_true(taken <= cagd_seconds() - started); /* one after the other */
    static const int jobs[] = {0, 2, 7, 64};
    for (size_t j = 0; j < sizeof jobs / sizeof *jobs; j++) {
        claim_result *several = judge_many(jobs[j], &finished);
        for (int k = 0; k < MANY; k++)
            assert_int_equal(told_of[k], several[k].by[FIELD_TYPE].ran + several[k].by[RATIONAL_TYPE].ran +
                                             several[k].by[INTERVAL_TYPE].ran + several[k].by[DOUBLE_TYPE].ran);
        assert_int_equal(finished, 10 * NUMBER_TYPES + 3);
        for (int k = 0; k < MANY; k++) {
            assert_ptr_equal(several[k].claim, &many[k]);
            assert_int_equal(several[k].as_expected, one[k].as_expected);
            assert_int_equal(several[k].outcome, one[k].outcome);
            assert_int_equal(several[k].evidence, one[k].evidence);
            assert_string_equal(several[k].scope, one[k].scope);
            for (number_type t = 0; t < NUMBER_TYPES; t++) {
                const type_result *a = &one[k].by[t], *b = &several[k].by[t];
                assert_int_equal(a->ran, b->ran);
                assert_int_equal(a->outcome, b->outcome);
                assert_int_equal(a->faults, b->faults);
                assert_int_equal(a->cases, b->cases);
                assert_int_equal(a->compared, b->compared);
                assert_int_equal(a->degree_high, b->degree_high);
                assert_true(a->worst == b->worst);
                assert_true(a->seed == b->seed);
                assert_int_equal(a->control_caught, b->control_caught);
                same_text(a->variables, b->variables);
                same_text(a->positive, b->positive);
                assert_int_equal(a->exhibits, b->exhibits);
                for (int e = 0; e < a->exhibits; e++) {
                    assert_string_equal(a->shown[e].name, b->shown[e].name);
                    assert_string_equal(a->shown[e].value, b->shown[e].value);
                }
            }
        }
        free_results(several, MANY);
    }
    free_results(one, MANY);
}

static void test_no_claims(void **state)
{
    (void)state;
    const run_options options = {.jobs = 3};
    free_results(judge_claims(NULL, 0, &options), 0);
}

/* ---- Verdicts -------------------------------------------------------------------------------------- */

/* Results as judge_claims would leave them: good claims by evidence, and one that went wrong. */
static const claim proved = {.name = "proved"}, decided = {.name = "decided"}, sampled = {.name = "sampled"},
                   against = {.name = "against", .kind = COUNTEREXAMPLE}, wrong = {.name = "wrong"};
static char against_scope[] = "the stated instance";
static const claim_result results[] = {
    {.claim = &proved, .as_expected = 1, .evidence = PROVED},
    {.claim = &decided, .as_expected = 1, .evidence = DECIDED},
    {.claim = &sampled, .as_expected = 1, .evidence = SAMPLED},
    {.claim = &against, .as_expected = 1, .outcome = FAILS, .evidence = DECIDED, .scope = against_scope},
    {.claim = &wrong, .as_expected = 0, .evidence = NO_EVIDENCE}};
enum { RESULTS = sizeof results / sizeof *results };

static statement_result verdict_of(const statement_link links[], int is_definition)
{
    const statement s = {.id = "source:1", .is_definition = is_definition, .links = links};
    return derive(&s, results, RESULTS);
}

static int in(unsigned roles, role r) { return roles >> r & 1; }

/* What the roles present have to lead to, said the other way round than in verdict.c.  The reading fails. */
static verdict expected_verdict(unsigned roles, int is_definition)
{
    int for_it = in(roles, HOLDS_BY) || in(roles, CHECKED_BY);
    if (in(roles, REFUTED_BY))
        return VERDICT_FAILS;
    if (is_definition)
        return VERDICT_DEFINITION;
    if (for_it && in(roles, HYPOTHESIS))
        return VERDICT_CONDITIONAL;
    if (in(roles, READING) && !in(roles, HYPOTHESIS) && !(for_it && in(roles, MEANT)))
        return VERDICT_UNDECIDED;
    return for_it ? VERDICT_HOLDS : VERDICT_OPEN;
}

static void test_every_combination_of_roles(void **state)
{
    (void)state;
    static const char *const good[ROLES] = {
        [HOLDS_BY] = "proved",      [CONFIRMED_BY] = "sampled", [REFUTED_BY] = "against",
        [CORRECTED_BY] = "decided", [HYPOTHESIS] = "against",   [NEEDS] = "against",
        [READING] = "against",      [CHECKED_BY] = "decided",   [READING_WITH] = "proved"};
    for (unsigned roles = 0; roles < 1u << ROLES; roles++)
        for (int is_definition = 0; is_definition <= 1; is_definition++)
            for (int bad = -1; bad < 2 * ROLES; bad++) { /* the role whose claim went wrong, or is missing */
                if (bad >= 0 && (!in(roles, (role)(bad % ROLES)) || form_of_role[bad % ROLES] == PLACE_TEXT))
                    continue;
                statement_link links[ROLES + 1];
                int count = 0;
                for (int k = 0; k < ROLES; k++)
                    if (in(roles, (role)k)) {
                        const char *name = bad == k ? "wrong" : bad == ROLES + k ? "missing" : good[k];
                        links[count++] =
                            (statement_link){(role)k, name, form_of_role[k] == PLACE_TEXT ? "" : NULL, "", NULL};
                    }
                links[count] = (statement_link){HOLDS_BY, NULL, NULL, NULL, NULL};
                statement_result r = verdict_of(links, is_definition);
                assert_int_equal(r.as_expected, bad < 0);
                assert_int_equal(r.verdict, bad < 0 ? expected_verdict(roles, is_definition) : VERDICT_OPEN);
                int words = in(roles, ARGUED) || in(roles, CITES);
                int held = in(roles, HOLDS_BY) || in(roles, CHECKED_BY);
                if (bad >= 0) {
                    assert_int_equal(r.as_printed.evidence, NO_EVIDENCE);
                } else {
                    evidence correction = words && (in(roles, REFUTED_BY) || !held) ? BY_ARGUMENT : DECIDED;
                    assert_int_equal(r.as_corrected.evidence, in(roles, CORRECTED_BY) ? correction : NO_EVIDENCE);
                    if (r.verdict == VERDICT_FAILS)
                        assert_int_equal(r.as_printed.evidence, DECIDED);
                    else if (held && r.verdict != VERDICT_UNDECIDED)
                        assert_int_equal(r.as_printed.evidence, words                   ? BY_ARGUMENT
                                                                : in(roles, CHECKED_BY) ? DECIDED
                                                                                        : PROVED);
                    else
                        assert_int_equal(r.as_printed.evidence, NO_EVIDENCE);
                    assert_true((r.refuted_by != NULL) == (r.verdict == VERDICT_FAILS));
                }
                free_statement_result(&r);
            }
}

static void test_evidence_is_that_of_the_weakest_claim(void **state)
{
    (void)state;
    static const char *const orders[][3] = {{"proved", "decided", "sampled"}, {"sampled", "proved", "decided"}};
    for (int k = 0; k < 2; k++) {
        const statement_link links[] = {{HOLDS_BY, orders[k][0], NULL, "", NULL},
                                        {HOLDS_BY, orders[k][1], NULL, "", NULL},
                                        {HOLDS_BY, orders[k][2], NULL, "", NULL},
                                        {CORRECTED_BY, orders[k][0], NULL, "", NULL},
                                        {CORRECTED_BY, orders[k][1], NULL, "", NULL},
                                        {CORRECTED_BY, orders[k][2], NULL, "", NULL},
                                        {HOLDS_BY, NULL, NULL, NULL, NULL}};
        statement_result r = verdict_of(links, 0);
        assert_int_equal(r.verdict, VERDICT_HOLDS);
        assert_int_equal(r.as_printed.evidence, SAMPLED);
        assert_int_equal(r.as_corrected.evidence, SAMPLED);
        free_statement_result(&r);
    }
}

/* What refutes together is as good as the weakest of it, whichever stands first; the scope is the first one's. */
static void test_what_refutes_is_as_good_as_its_weakest(void **state)
{
    (void)state;
    static const claim argued = {.name = "argued", .kind = COUNTEREXAMPLE};
    static char another_scope[] = "another instance";
    const claim_result two[] = {
        results[3],
        {.claim = &argued, .as_expected = 1, .outcome = FAILS, .evidence = BY_ARGUMENT, .scope = another_scope}};
    for (int turned = 0; turned < 2; turned++) {
        const statement_link links[] = {{REFUTED_BY, turned ? "argued" : "against", NULL, "", NULL},
                                        {REFUTED_BY, turned ? "against" : "argued", NULL, "", NULL},
                                        {HOLDS_BY, NULL, NULL, NULL, NULL}};
        const statement s = {.id = "source:1", .links = links};
        statement_result r = derive(&s, two, 2);
        assert_int_equal(r.verdict, VERDICT_FAILS);
        assert_int_equal(r.as_printed.evidence, BY_ARGUMENT);
        assert_string_equal(r.as_printed.scope, turned ? another_scope : against_scope);
        free_statement_result(&r);
    }
}

static void test_readings(void **state)
{
    (void)state;
    const statement_link words[] = {{READING, NULL, NULL, "one way", NULL},
                                    {READING, NULL, NULL, "another", NULL},
                                    {HOLDS_BY, NULL, NULL, NULL, NULL}};
    statement_result r = verdict_of(words, 0);
    assert_true(r.as_expected);
    assert_int_equal(r.verdict, VERDICT_UNDECIDED); /* a reading in words has no claim */
    free_statement_result(&r);
    const statement_link none[] = {{HOLDS_BY, NULL, NULL, NULL, NULL}};
    r = verdict_of(none, 0);
    assert_true(r.as_expected);
    assert_int_equal(r.verdict, VERDICT_OPEN);
    free_statement_result(&r);
    const statement_link good[] = {
        {HOLDS_BY, "proved", NULL, "", NULL}, {READING, "sampled", NULL, "", NULL}, {HOLDS_BY, NULL, NULL, NULL, NULL}};
    r = verdict_of(good, 0);
    assert_int_equal(r.verdict, VERDICT_HOLDS); /* no reading fails */
    free_statement_result(&r);
}

static void test_result_of(void **state)
{
    (void)state;
    assert_ptr_equal(result_of("sampled", results, RESULTS), &results[2]);
    assert_null(result_of("missing", results, RESULTS));
    assert_null(result_of("sample", results, RESULTS));
    assert_null(result_of("sampled_claim", results, RESULTS));
    assert_null(result_of("proved", results, 0));
}

/* ---- Scopes ------------------------------------------------------------------------------------------ */

static char weighted_names[] = "x0 w1 t", weighted_positive[] = "w1", plain_names[] = "x3 w0 beta0", odd_names[] = "h7",
            no_names[] = "", one_weight[] = "w0 t", shift_names[] = "x1 h1 gamma", five_names[] = "x1 w1 h1 gamma t",
            knot_names[] = "x1 w1 t1", primed_names[] = "a b c d", one_gap[] = "d";
static const char order[] =
    "simple knots | every pattern of knots;0 < t < 1 | 0 ≤ t ≤ 1; * | all maps; the weights are positive | P ≠ 0";
static const claim
    weighted = {.name = "weighted", .scope = "simple knots", .over = "x#: points; w#: weights;t", .degree_high = 6},
    plain = {.name = "plain", .scope = "", .over = "x#: points; w#: weights; beta", .letter = "k"},
    odd = {.name = "odd", .scope = "simple knots", .letter = "m", .all_degrees = 1, .degree_low = 2},
    stretched = {.name = "stretched", .scope = "", .argued_for = "every n", .argued = "by induction"},
    stretched_later = {.name = "stretched later",
                       .scope = "",
                       .argued_for = "every n from 7 on",
                       .argued = "by symmetry"},
    worded = {.name = "worded", .scope = "", .argued_for = "", .argued = "by continuity"},
    said = {.name = "said", .scope = "0 < t < 1", .over = "x#: points; w: -"}, high = {.name = "high", .scope = ""},
    instances = {.name = "instances", .scope = ""},
    inside = {.name = "inside", .scope = "0 < t < 1", .over = "w#: weights; t", .within = order},
    closed = {.name = "closed", .scope = "0 ≤ t ≤ 1", .over = "w#: weights; t", .within = order},
    patterns = {.name = "patterns", .scope = "every pattern of knots", .within = order},
    letters = {.name = "letters", .scope = "", .over = "x#: points; h#: shifts; gamma"},
    others = {.name = "others", .scope = "", .over = "x#: nodes; h#: shifts; gamma"},
    shifts = {.name = "shifts", .scope = "simple knots", .over = "x#: points; h#: shifts; gamma", .degree_high = 9},
    arc = {.name = "arc", .scope = "the stated arc", .over = "w#: weights; t"},
    below = {.name = "below", .scope = "every t below 1", .over = "w#: weights; t"},
    five = {.name = "five", .scope = "", .over = "x#: points; w#: weights; h#: shifts; gamma; t"},
    last = {.name = "last", .scope = "", .over = "w#: weights; t"},
    maps = {.name = "maps", .scope = "all maps", .within = order},
    wide = {.name = "wide", .scope = "every pattern of knots; all maps", .within = order},
    designed = {.name = "designed", .scope = "the stated polygons"},
    regular = {.name = "regular", .scope = "", .where = "P ≠ 0; 0 < t < 1", .over = "w#: weights; t"},
    nonzero = {.name = "nonzero",
               .scope = "simple knots",
               .where = "P ≠ 0; 0 ≤ t ≤ 1",
               .over = "w#: weights; t",
               .within = order},
    numbers = {.name = "numbers",
               .scope = "the distinct knots variables up to order 5, numbers above",
               .over = "x#: gaps of the knots; w#: weights; t#: knots"},
    primed = {.name = "primed", .scope = "", .over = "a: t'; b: gamma'; c: h/l; d: gap"},
    bare = {.name = "bare", .scope = "", .where = "P ≠ 0"},
    seventh = {.name = "seventh", .scope = "the stated polygon"},
    stated = {.name = "stated", .scope = "the stated curves"};
#define RUN_IN_FIELD(c, low, high_, names, positive_names)                                                             \
    {                                                                                                                  \
        .claim = &c, .as_expected = 1, .evidence = PROVED, .computed = PROVED,                                         \
        .by =                                                                                                          \
        { [FIELD_TYPE] = {                                                                                             \
              .ran = 1, .degree_low = low, .degree_high = high_, .variables = names, .positive = positive_names} }     \
    }
static const claim_result scoped[] = {
    RUN_IN_FIELD(weighted, 1, 6, weighted_names, weighted_positive),
    RUN_IN_FIELD(plain, 3, 9, plain_names, no_names),
    RUN_IN_FIELD(odd, 0, 0, odd_names, no_names),
    RUN_IN_FIELD(stretched, 1, 4, no_names, no_names),
    RUN_IN_FIELD(worded, 1, 4, no_names, no_names),
    RUN_IN_FIELD(high, 7, 8, no_names, no_names),
    RUN_IN_FIELD(said, 0, 0, plain_names, no_names),
    RUN_IN_FIELD(inside, 0, 0, one_weight, no_names),
    RUN_IN_FIELD(closed, 1, 4, one_weight, no_names),
    RUN_IN_FIELD(patterns, 1, 3, no_names, no_names),
    RUN_IN_FIELD(maps, 0, 0, no_names, no_names),
    RUN_IN_FIELD(wide, 1, 3, no_names, no_names),
    RUN_IN_FIELD(below, 0, 0, one_weight, no_names),
    RUN_IN_FIELD(arc, 0, 0, one_weight, no_names),
    RUN_IN_FIELD(regular, 1, 4, one_weight, no_names),
    RUN_IN_FIELD(nonzero, 1, 3, one_weight, no_names),
    RUN_IN_FIELD(numbers, 1, 6, knot_names, no_names),
    RUN_IN_FIELD(primed, 0, 0, primed_names, one_gap),
    {.claim = &bare, .as_expected = 1, .evidence = DECIDED, .computed = DECIDED, .by = {[RATIONAL_TYPE] = {.ran = 1}}},
    RUN_IN_FIELD(five, 1, 4, five_names, no_names),
    RUN_IN_FIELD(last, 1, 9, one_weight, no_names),
    RUN_IN_FIELD(shifts, 1, 9, shift_names, no_names),
    RUN_IN_FIELD(letters, 1, 9, shift_names, no_names),
    RUN_IN_FIELD(others, 1, 9, shift_names, no_names),
    {.claim = &seventh,
     .as_expected = 1,
     .evidence = DECIDED,
     .computed = DECIDED,
     .by = {[RATIONAL_TYPE] = {.ran = 1, .degree_low = 7, .degree_high = 7}}},
    {.claim = &designed,
     .as_expected = 1,
     .evidence = DECIDED,
     .computed = DECIDED,
     .by = {[RATIONAL_TYPE] = {.ran = 1, .degree_low = 2, .degree_high = 3}}},
    {.claim = &stated,
     .as_expected = 1,
     .evidence = DECIDED,
     .computed = DECIDED,
     .by = {[RATIONAL_TYPE] = {.ran = 1}}},
    RUN_IN_FIELD(stretched_later, 1, 4, no_names, no_names),
    {.claim = &instances,
     .as_expected = 1,
     .evidence = SAMPLED,
     .computed = SAMPLED,
     .by = {[RATIONAL_TYPE] = {.ran = 1, .cases = 24}}},
};

static void assert_finding(const char *letter, evidence e, const char *scope, const char *argued_for,
                           const statement_link links[])
{
    const statement s = {.id = "source:1", .letter = letter, .links = links};
    statement_result r = derive(&s, scoped, sizeof scoped / sizeof *scoped);
    assert_true(r.as_expected);
    assert_int_equal(r.as_printed.evidence, e);
    assert_string_equal(r.as_printed.scope, scope);
    assert_string_equal(r.as_printed.argued_for, argued_for);
    free_statement_result(&r);
}
#define BY(name)                                                                                                       \
    {                                                                                                                  \
        HOLDS_BY, name, NULL, "", NULL                                                                                 \
    }
#define LINKS(...) ((const statement_link[]){__VA_ARGS__, {HOLDS_BY, NULL, NULL, NULL, NULL}})

static void test_the_scope_is_what_all_claims_have_in_common(void **state)
{
    (void)state;
    assert_finding(NULL, PROVED, "n = 1 to 6; simple knots; all points, all positive weights, every t", "",
                   LINKS(BY("weighted")));
    assert_finding("k", PROVED, "k = 3 to 9; all points and weights, every β", "", LINKS(BY("plain")));
    assert_finding("n", PROVED, "n = 2 to 8; all points and weights, every β", "", LINKS(BY("plain")));
    assert_finding("n", PROVED, "every m from 2 on; simple knots; all data", "", LINKS(BY("odd")));
    assert_finding("n", PROVED, "0 < t < 1; all points, all other data", "", LINKS(BY("said")));
    for (int turned = 0; turned < 2; turned++) /* weights positive in one are positive in both */
        assert_finding("n", PROVED,
                       turned ? "n = 2 to 6; simple knots; all points, all positive weights, every β and t"
                              : "n = 2 to 6; simple knots; all points, all positive weights, every t and β",
                       "", turned ? LINKS(BY("plain"), BY("weighted")) : LINKS(BY("weighted"), BY("plain")));
    assert_finding(
        "n", PROVED,
        "n = 1 to 6; every m from 2 on; simple knots; all points, all positive weights, every t, all other data", "",
        LINKS(BY("weighted"), BY("odd")));
    assert_finding("n", SAMPLED, "n = 2 to 8; all points and weights, every β; 24 random instances", "",
                   LINKS(BY("plain"), BY("instances")));
    assert_finding("n", PROVED, "n = 2 to 8; all points and weights, every β", "",
                   LINKS(BY("plain"), {CONFIRMED_BY, "instances", NULL, "", NULL}));
}

/* Of two phrases that the chapters compare the narrower one is left, whichever comes first; a letter of which a phrase
 * speaks is not among the data. */
static void test_a_narrower_phrase_is_left(void **state)
{
    (void)state;
    assert_finding("n", PROVED, "n = 1 to 4; 0 ≤ t ≤ 1; all weights", "", LINKS(BY("closed")));
    assert_finding("n", PROVED, "n = 1 to 4; 0 < t < 1; all weights", "", LINKS(BY("closed"), BY("inside")));
    assert_finding("n", PROVED, "n = 1 to 4; 0 < t < 1; all weights", "", LINKS(BY("inside"), BY("closed")));
    assert_finding("n", PROVED, "n = 1 to 3; simple knots; all points, all positive weights, every t", "",
                   LINKS(BY("patterns"), BY("weighted")));
    assert_finding("n", PROVED, "n = 2 to 3; every pattern of knots; all points and weights, every β", "",
                   LINKS(BY("patterns"), BY("plain"))); /* a phrase of one alone asks it of both */
    assert_finding("n", PROVED, "all maps", "", LINKS(BY("maps")));
    assert_finding("n", PROVED, "every t below 1; all weights", "", LINKS(BY("below")));
    assert_finding("n", PROVED, "n = 1 to 3; every pattern of knots", "", LINKS(BY("maps"), BY("patterns")));
    assert_finding("n", PROVED, "n = 1 to 3; every pattern of knots", "", LINKS(BY("patterns"), BY("maps")));
    assert_finding("n", PROVED, "every m from 2 on; simple knots; all data", "", LINKS(BY("odd"), BY("maps")));
    assert_finding("n", PROVED, "n = 1 to 3; every m from 2 on; simple knots; all data", "",
                   LINKS(BY("wide"), BY("odd"))); /* it takes the place of both */
}

/* Phrases that nobody compares are about different things: the degree is what is common. */
static void test_claims_about_different_things_are_apart(void **state)
{
    (void)state;
    const char *const apart = "n = 1 to 3; each step for its own cases (0 < t < 1; every pattern of knots)";
    assert_finding("n", PROVED, "n = 1 to 3; each step for its own cases (every pattern of knots; 0 < t < 1)", "",
                   LINKS(BY("patterns"), BY("said")));
    assert_finding("n", PROVED, apart, "", LINKS(BY("said"), BY("patterns")));
    assert_finding("n", PROVED, apart, "", LINKS(BY("said"), BY("patterns"), BY("inside")));
    assert_finding("n", PROVED, "n = 1 to 3; each step for its own cases (simple knots; 0 < t < 1)", "",
                   LINKS(BY("odd"), BY("patterns"), BY("said"))); /* the m of one step is not common */
    assert_finding("n", DECIDED, "n = 1 to 6; each step for its own cases (simple knots; the stated curves)", "",
                   LINKS(BY("weighted"), BY("stated")));
    assert_finding("n", DECIDED, "each step for its own cases (the stated curves; 0 < t < 1)", "",
                   LINKS(BY("stated"), BY("inside")));
    assert_finding("n", DECIDED,
                   "n = 2 to 3; each step for its own cases (the stated polygons; 0 < t < 1; simple knots)", "",
                   LINKS(BY("designed"), BY("said"), BY("weighted"))); /* three can be read */
    assert_finding("n", DECIDED, "n = 2 to 3; each step for its own cases", "",
                   LINKS(BY("designed"), BY("said"), BY("weighted"), BY("arc"))); /* four are told at the steps */
    assert_finding("n", DECIDED, "the stated curves", "", LINKS(BY("stated")));
    assert_finding("n", PROVED, "n = 7 to 8; the stated arc; all weights, every t", "", LINKS(BY("arc"), BY("high")));
    assert_finding("n", DECIDED, "n = 2 to 3; the stated polygons", "", LINKS(BY("designed"), BY("stretched")));
    assert_finding("n", DECIDED, "n = 2 to 3; each step for its own cases (the stated polygons)", "",
                   LINKS(BY("designed"), BY("plain")));
    assert_finding("n", DECIDED, "n = 7; each step for its own cases (the stated polygon)", "",
                   LINKS(BY("seventh"), BY("high")));
    assert_finding(
        "n", PROVED,
        "n = 1 to 3; each step for its own cases (every pattern of knots; 0 < t < 1), where β ≠ 0, and P is not 0", "",
        LINKS(BY("patterns"), BY("said"), {HYPOTHESIS, NULL, NULL, "β ≠ 0: why", "β ≠ 0"},
              {NEEDS, NULL, "here", "P is not 0", "P is not 0"})); /* hypotheses are asked of all steps */
    assert_finding("n", SAMPLED,
                   "n = 1 to 3; each step for its own cases (every pattern of knots; 0 < t < 1); 24 random instances",
                   "", LINKS(BY("patterns"), BY("said"), BY("instances")));
}

/* Data are told as long as a reader knows what they are about: those of one claim however many, of several up to four. */
static void test_data_that_nobody_has_together_are_told_by_step(void **state)
{
    (void)state;
    assert_finding("n", PROVED, "n = 1 to 9; simple knots; all points and shifts, every γ", "", LINKS(BY("shifts")));
    assert_finding("n", PROVED, "n = 1 to 6; simple knots; all points; each step for its own other data", "",
                   LINKS(BY("shifts"), BY("weighted")));
    assert_finding("n", PROVED, "n = 1 to 6; simple knots; all points; each step for its own other data, where P ≠ 0",
                   "", LINKS(BY("weighted"), BY("shifts"), {NEEDS, NULL, "", "why", "P ≠ 0"}));
    assert_finding("n", PROVED, "n = 1 to 4; 0 ≤ t ≤ 1; all weights, points and shifts, every γ", "",
                   LINKS(BY("closed"), BY("letters"))); /* of t a phrase speaks */
    assert_finding("n", PROVED, "n = 2 to 8; each step for its own data", "", LINKS(BY("plain"), BY("others")));
    assert_finding("n", PROVED, "n = 1 to 4; 0 < t < 1; all points; each step for its own other data", "",
                   LINKS(BY("said"), BY("five"))); /* data without a name are no others */
    assert_finding("n", PROVED, "n = 1 to 4; all points, weights and shifts, every γ and t", "",
                   LINKS(BY("five"), BY("last"))); /* both have t */
    assert_finding("n", PROVED, "n = 1 to 4; all points, weights and shifts, every γ and t", "",
                   LINKS(BY("five"), BY("letters"))); /* one claim has all */
    assert_finding("n", PROVED, "n = 1 to 4; all points, shifts and weights, every γ and t", "",
                   LINKS(BY("letters"), BY("five")));
    assert_finding("n", PROVED, "n = 2 to 6; simple knots; all points, all positive weights, every t and β", "",
                   LINKS(BY("weighted"), BY("plain"))); /* four kinds, no claim has all */
}

/* What a claim takes for granted of its data stands in the scope of everything that needs the claim. */
static void test_conditions_reach_the_verdict(void **state)
{
    (void)state;
    const char *const both = "n = 1 to 3; simple knots; all weights, where P ≠ 0, and 0 < t < 1";
    assert_finding("n", PROVED, "n = 1 to 4; all weights, where P ≠ 0, and 0 < t < 1", "", LINKS(BY("regular")));
    assert_finding("n", PROVED, "n = 1 to 3; simple knots; all weights, where P ≠ 0, and 0 ≤ t ≤ 1", "",
                   LINKS(BY("nonzero")));                                       /* of t a condition speaks */
    assert_finding("n", PROVED, both, "", LINKS(BY("nonzero"), BY("regular"))); /* the narrower one of two is left */
    assert_finding("n", PROVED, both, "", LINKS(BY("regular"), BY("nonzero")));
    assert_finding("n", PROVED, "n = 2 to 6; simple knots; all points, all positive weights, every t and β", "",
                   LINKS(BY("weighted"), BY("plain"), {CONFIRMED_BY, "regular", NULL, "", NULL}));
    assert_finding("n", PROVED, "n = 1 to 4; all weights, where P ≠ 0, and 0 < t < 1", "",
                   LINKS(BY("regular"), {HYPOTHESIS, NULL, NULL, "P is not 0", NULL})); /* the condition is named */
    assert_finding("n", PROVED, "0 < t < 1; all weights, where P ≠ 0", "",
                   LINKS(BY("inside"), {NEEDS, NULL, "", "", "$0<t<1$"}, {NEEDS, NULL, "", "", "P ≠ 0"})); /* said */
    assert_finding("n", PROVED, "n = 1 to 4; 0 ≤ t ≤ 1; all weights", "",
                   LINKS(BY("closed"), {NEEDS, NULL, "", "", "$0\\le t\\le1$"}));
    assert_finding(
        "n", PROVED, "0 < t < 1; all weights", "",
        LINKS(BY("inside"), {NEEDS, NULL, "", "", "0 ≤ t ≤ 1"})); /* by the table it is wider than what is said */
    assert_finding("n", PROVED, "0 < t < 1; all weights, where $0<t\\le1$, and $0<t<12$, and $0<t$", "",
                   LINKS(BY("inside"), {NEEDS, NULL, "", "", "$0<t\\le1$"}, {NEEDS, NULL, "", "", "$0<t<12$"},
                         {NEEDS, NULL, "", "", "$0<t$"}));
    for (int k = 0; k < 2; k++) /* positive weights meet what is within it, whichever is told first */
        assert_finding("n", PROVED, "0 < t < 1; all positive weights, where Q ≠ 0", "",
                       LINKS(BY("inside"), {NEEDS, NULL, "", "", k ? "P ≠ 0" : "the weights are positive"},
                             {NEEDS, NULL, "", "", k ? "the weights are positive" : "P ≠ 0"},
                             {NEEDS, NULL, "", "", "Q ≠ 0"}));
    assert_finding("n", DECIDED, "where P ≠ 0", "", LINKS(BY("bare")));
    assert_finding("n", DECIDED, "n = 1 to 4; where P ≠ 0", "every n", LINKS(BY("bare"), BY("stretched")));
    assert_finding(
        "n", PROVED,
        "n = 1 to 3; each step for its own cases (every pattern of knots; 0 < t < 1), where P ≠ 0, and 0 < t < 1", "",
        LINKS(BY("patterns"), BY("said"), BY("regular"))); /* they stand at the steps */
}

/* Of knots that are numbers above some order nobody says that they are all knots. */
static void test_what_a_phrase_says_are_definite_ones_are_not_all(void **state)
{
    (void)state;
    assert_finding("n", PROVED, "n = 1 to 6; the distinct knots variables up to order 5, numbers above; all weights",
                   "", LINKS(BY("numbers")));
    assert_finding(
        "n", PROVED,
        "n = 2 to 6; the distinct knots variables up to order 5, numbers above; all weights and points, every β", "",
        LINKS(BY("numbers"), BY("plain")));
}

/* What hypotheses ask of the data is told by its condition; positive data are called so. */
static void test_data_within_hypotheses(void **state)
{
    (void)state;
    assert_finding("n", PROVED, "n = 2 to 8; all points and weights, every β, where β ≠ 0", "",
                   LINKS(BY("plain"), {HYPOTHESIS, NULL, NULL, "β ≠ 0: why", "β ≠ 0"}));
    assert_finding("n", PROVED, "n = 2 to 8; all points, all positive weights, every β", "",
                   LINKS(BY("plain"), {NEEDS, NULL, "page 1", "", "the weights are positive"}));
    assert_finding("n", PROVED, "n = 2 to 8; all points and weights, every β, where the weights are positive there", "",
                   LINKS(BY("plain"), {NEEDS, NULL, "page 1", "", "the weights are positive there"}));
    assert_finding("n", PROVED, "n = 2 to 8; all points and weights, where $\\beta>0$, and $t_0<t_1$", "",
                   LINKS(BY("plain"), {NEEDS, NULL, "", "", "$\\beta>0$"}, {NEEDS, NULL, "", "", "$t_0<t_1$"},
                         {NEEDS, NULL, "", "", "$\\beta>0$"}));
    assert_finding("n", PROVED, "n = 1 to 4; where the weights are positive", "every n",
                   LINKS(BY("stretched"), {NEEDS, NULL, "", "", "the weights are positive"}));
    assert_finding("n", PROVED,
                   "n = 1 to 3; each step for its own cases (every pattern of knots; 0 < t < 1), where t > 0", "",
                   LINKS(BY("patterns"), BY("said"), {NEEDS, NULL, "", "", "t > 0"}));
    const statement_link refuted[] = {{REFUTED_BY, "against", NULL, "", NULL},
                                      {CORRECTED_BY, "plain", NULL, "", NULL},
                                      {NEEDS, NULL, "", "", "P ≠ 0"},
                                      {HOLDS_BY, NULL, NULL, NULL, NULL}};
    claim_result all[sizeof scoped / sizeof *scoped + 1];
    memcpy(all, scoped, sizeof scoped);
    all[sizeof scoped / sizeof *scoped] = (claim_result){
        .claim = &against, .as_expected = 1, .outcome = FAILS, .evidence = DECIDED, .scope = against_scope};
    const statement s = {.id = "source:1", .letter = "n", .class = "false", .links = refuted};
    statement_result r = derive(&s, all, sizeof all / sizeof *all);
    assert_string_equal(r.as_corrected.scope, "n = 2 to 8; all points and weights, every β, where P ≠ 0");
    free_statement_result(&r);
}

/* A letter that the statement does not have says nothing to its reader, unless it is what is positive. */
static void test_letters_of_the_statement_alone_are_told(void **state)
{
    (void)state;
    struct {
        const char *letters, *claim, *scope;
    } list[] = {{"x t", "plain", "n = 2 to 8; all points and weights"},
                {"beta", "plain", "n = 2 to 8; all points and weights, every β"},
                {"bet a x", "plain", "n = 2 to 8; all points and weights"},
                {"t", "weighted", "n = 1 to 6; simple knots; all points, all positive weights, every t"},
                {"T", "weighted", "n = 1 to 6; simple knots; all points, all positive weights"},
                {"a t", "primed", "every t', every positive gap"},
                {"a b", "primed", "every positive gap"},
                {"t gamma", "primed", "every t' and gamma', every positive gap"},
                {"l h", "primed", "every positive gap"}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        const statement s = {
            .id = "source:1", .letter = "n", .letters = list[k].letters, .links = LINKS(BY(list[k].claim))};
        statement_result r = derive(&s, scoped, sizeof scoped / sizeof *scoped);
        assert_string_equal(r.as_printed.scope, list[k].scope);
        free_statement_result(&r);
        finding f = finding_of(result_of(list[k].claim, scoped, sizeof scoped / sizeof *scoped), "n");
        assert_true(strlen(f.scope) >= strlen(list[k].scope)); /* a step tells all of its letters */
        free_finding(&f);
    }
}

/* A statement about one degree is told for that one, and is not as expected where the claims do not decide it. */
static void test_the_only_degree_of_a_statement(void **state)
{
    (void)state;
    statement s = {.id = "source:1", .letter = "n", .degree = 3, .links = LINKS(BY("plain"))};
    statement_result r = derive(&s, scoped, sizeof scoped / sizeof *scoped);
    assert_string_equal(r.as_printed.scope, "n = 3; all points and weights, every β");
    assert_int_equal(r.verdict, VERDICT_HOLDS);
    free_statement_result(&r);
    s.letter = "degree";
    r = derive(&s, scoped, sizeof scoped / sizeof *scoped);
    assert_string_equal(r.as_printed.scope, "degree 3; all points and weights, every β");
    free_statement_result(&r);
    s.degree = 9;
    r = derive(&s, scoped, sizeof scoped / sizeof *scoped);
    assert_int_equal(r.verdict, VERDICT_OPEN);
    assert_false(r.as_expected);
    free_statement_result(&r);
    s.links = LINKS(BY("primed")), s.letter = "n";
    r = derive(&s, scoped, sizeof scoped / sizeof *scoped);
    assert_string_equal(r.as_printed.scope, "every t', gamma' and h/l, every positive gap"); /* that has no degree */
    free_statement_result(&r);
}

static void test_the_finding_of_one_claim(void **state)
{
    (void)state;
    const claim_result *plain_result = &scoped[1], *worded_result = &scoped[4], *stretched_result = &scoped[3];
    finding f = finding_of(plain_result, "k");
    assert_int_equal(f.evidence, PROVED);
    assert_string_equal(f.scope, "k = 3 to 9; all points and weights, every β");
    free_finding(&f);
    assert_null(f.scope);
    f = finding_of(plain_result, "order");
    assert_string_equal(f.scope, "order 3 to 9; all points and weights, every β");
    free_finding(&f);
    f = finding_of(plain_result, "degree");
    assert_string_equal(f.scope, "degree 2 to 8; all points and weights, every β");
    free_finding(&f);
    f = finding_of(plain_result, NULL);
    assert_string_equal(f.scope, "n = 2 to 8; all points and weights, every β");
    free_finding(&f);
    f = finding_of(worded_result, "n");
    assert_int_equal(f.evidence, BY_ARGUMENT);
    free_finding(&f);
    f = finding_of(stretched_result, "n");
    assert_string_equal(f.argued_for, "every n");
    free_finding(&f);
}

/* A reading and the claims behind it: the weakest evidence, the common cases; another reading is not counted in. */
static void test_the_finding_of_a_reading(void **state)
{
    (void)state;
    const int count = sizeof scoped / sizeof *scoped;
    const char *first = scoped[1].claim->name, *second = scoped[4].claim->name, *third = scoped[3].claim->name;
    const statement_link links[] = {{READING, first, NULL, "one way", NULL},   {READING_WITH, second, NULL, "", NULL},
                                    {READING_WITH, first, NULL, "", NULL},     {READING, third, NULL, "another", NULL},
                                    {READING_WITH, "missing", NULL, "", NULL}, {HOLDS_BY, NULL, NULL, NULL, NULL}};
    const statement s = {.id = "source:1", .letter = "n", .links = links};
    finding two = finding_of_reading(&s, links, scoped, count), alone = finding_of(&scoped[1], "n");
    assert_int_equal(two.evidence, BY_ARGUMENT);
    assert_string_not_equal(two.scope, "");
    assert_int_equal(alone.evidence, PROVED);
    free_finding(&alone);
    free_finding(&two);
    const statement_link weak_last[] = {{READING, first, NULL, "one way", NULL},
                                        {READING_WITH, first, NULL, "", NULL},
                                        {READING_WITH, second, NULL, "", NULL},
                                        {HOLDS_BY, NULL, NULL, NULL, NULL}};
    finding three = finding_of_reading(&s, weak_last, scoped, count);
    assert_int_equal(three.evidence, BY_ARGUMENT);
    free_finding(&three);
    finding one = finding_of_reading(&s, links + 3, scoped, count), same = finding_of(&scoped[3], "n");
    assert_int_equal(one.evidence, same.evidence);
    assert_string_equal(one.scope, same.scope);
    free_finding(&one);
    free_finding(&same);
    /* of its letters and those of its statement, in the only degree of that; without letters all are told */
    static const char *const of_letters[][2] = {{"n t", "n = 4; all points and weights"},
                                                {"n beta", "n = 4; all points and weights, every β"},
                                                {NULL, "n = 4; all points and weights, every β"}};
    for (int k = 0; k < 3; k++) {
        const statement_link lettered[] = {{READING, first, NULL, "one way", of_letters[k][0]},
                                           {HOLDS_BY, NULL, NULL, NULL, NULL}};
        const statement of_four = {.id = "source:4", .letter = "n", .degree = 4, .links = lettered};
        finding f = finding_of_reading(&of_four, lettered, scoped, count);
        assert_string_equal(f.scope, of_letters[k][1]);
        free_finding(&f);
    }
    statement_result r = derive(&s, scoped, count); /* a claim that is missing */
    assert_false(r.as_expected);
    free_statement_result(&r);
    for (int degree = 6; degree <= 7; degree++) { /* the claim has 6, and not 7 */
        const statement_link way[] = {
            {READING, "weighted", NULL, "one way", NULL}, BY("last"), {HOLDS_BY, NULL, NULL, NULL, NULL}};
        const statement of_one = {.id = "source:5", .letter = "n", .degree = degree, .links = way};
        r = derive(&of_one, scoped, count);
        assert_int_equal(r.as_expected, degree == 6);
        free_statement_result(&r);
    }
}

/* "every n" is not among the cases because "every n from 7 on" is; said twice it is told once. */
static void test_cases_in_words_are_added_up(void **state)
{
    (void)state;
    const statement s = {.id = "source:1",
                         .letter = "n",
                         .links =
                             LINKS(BY("stretched later"), BY("stretched"), BY("stretched later"), BY("stretched"))};
    statement_result r = derive(&s, scoped, sizeof scoped / sizeof *scoped);
    assert_string_equal(r.as_printed.argued_for, "every n from 7 on; every n");
    free_statement_result(&r);
}

static void test_claims_without_a_common_case(void **state)
{
    (void)state;
    const statement s = {.id = "source:1", .links = LINKS(BY("stretched"), BY("high"))};
    statement_result r = derive(&s, scoped, sizeof scoped / sizeof *scoped);
    assert_false(r.as_expected);
    assert_int_equal(r.verdict, VERDICT_OPEN);
    assert_string_equal(r.as_printed.scope, "no n");
    free_statement_result(&r);
    const statement_link links[] = {{READING, "stretched", NULL, "one way", NULL}, /* nor may a reading be so */
                                    {READING_WITH, "high", NULL, "", NULL},
                                    {READING, "stretched", NULL, "another", NULL},
                                    {HOLDS_BY, NULL, NULL, NULL, NULL}};
    const statement read = {.id = "source:2", .links = links}, alone = {.id = "source:3", .links = links + 2};
    r = derive(&read, scoped, sizeof scoped / sizeof *scoped);
    assert_false(r.as_expected);
    assert_int_equal(r.verdict, VERDICT_OPEN);
    free_statement_result(&r);
    r = derive(&alone, scoped, sizeof scoped / sizeof *scoped);
    assert_true(r.as_expected);
    assert_int_equal(r.verdict, VERDICT_UNDECIDED);
    free_statement_result(&r);
}

static void test_arguments(void **state)
{
    (void)state;
    assert_finding("n", PROVED, "n = 1 to 4", "every n", LINKS(BY("stretched")));
    assert_finding("n", PROVED, "n = 2 to 4; all points and weights, every β", "", /* plain ends at 8 */
                   LINKS(BY("stretched"), BY("plain")));
    assert_finding("n", PROVED, "n = 2 to 4; all points and weights, every β", "every n; n > 9",
                   LINKS(BY("stretched"), BY("plain"), {ARGUED, NULL, "n > 9", "text", NULL}));
    assert_finding("n", BY_ARGUMENT, "n = 1 to 4", "", LINKS(BY("worded")));
    assert_finding("n", BY_ARGUMENT, "n = 7 to 8", "", LINKS(BY("high"), {ARGUED, NULL, "", "text", NULL}));
    assert_finding("n", BY_ARGUMENT, "n = 7 to 8", "", LINKS(BY("high"), {CITES, NULL, "place", "text", NULL}));
    assert_finding("n", SAMPLED, "24 random instances", "",
                   LINKS(BY("instances"), {CITES, NULL, "place", "text", NULL}));
}

static void test_a_claim_that_needs_words_is_argued(void **state)
{
    (void)state;
    const claim needs = {EVERYWHERE(square_of_sum), .argued_for = "", .argued = "words"},
                adds = {EVERYWHERE(square_of_sum), .argued_for = "every n", .argued = "words"};
    claim_result *r = judge_one(&needs);
    assert_int_equal(r->computed, PROVED);
    assert_int_equal(r->evidence, BY_ARGUMENT);
    free_results(r, 1);
    r = judge_one(&adds);
    assert_int_equal(r->evidence, PROVED);
    free_results(r, 1);
    /* what is weaker than words stays so, as does what is not known */
    const claim weak[] = {{IN(RATIONAL_TYPE, _q, square_of_sum), .argued_for = "", .argued = "words"},
                          {IN(RATIONAL_TYPE, _q, nothing), .argued_for = "", .argued = "words"}};
    for (int k = 0; k < 2; k++) {
        r = judge_one(&weak[k]);
        assert_int_equal(r->evidence, k == 0 ? SAMPLED : NO_EVIDENCE);
        free_results(r, 1);
    }
}

static void test_finding_words(void **state)
{
    (void)state;
    char scope_text[] = "n = 1 to 4", every[] = "every n", none[] = "", apart[] = "each step for its own cases";
    const struct {
        finding f;
        const char *words;
    } list[] = {{{PROVED, scope_text, none}, "proved for n = 1 to 4"},
                {{PROVED, scope_text, every}, "proved for n = 1 to 4; argued for every n"},
                {{BY_ARGUMENT, none, none}, "argued"},
                {{BY_ARGUMENT, scope_text, none}, "argued for n = 1 to 4"},
                {{BY_ARGUMENT, scope_text, every}, "argued for every n; computed for n = 1 to 4"},
                {{BY_ARGUMENT, none, every}, "argued for every n"},
                {{BY_ARGUMENT, apart, every}, "argued for every n; computed, each step for its own cases"},
                {{DECIDED, apart, none}, "decided, each step for its own cases"},
                {{NO_EVIDENCE, none, none}, ""}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        char *words = finding_words(&list[k].f);
        assert_string_equal(words, list[k].words);
        free(words);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        unit(test_an_identity_is_proved),
        unit(test_evidence_is_that_of_the_strongest_type),
        unit(test_every_degree_is_visited),
        unit(test_deep_is_deeper),
        unit(test_false_is_false),
        unit(test_nothing_compared_is_a_failure),
        unit(test_orders_are_told_as_they_are),
        unit(test_a_claim_that_is_not_run),
        unit(test_an_error_that_is_no_number_is_the_largest),
        unit(test_a_control_must_fail_by_comparison),
        unit(test_one_bad_type_spoils_the_claim),
        unit(test_undefined_fails),
        unit(test_unable_is_neither_true_nor_false),
        unit(test_a_crowded_field_grows),
        unit(test_the_variables_of_all_cases),
        unit(test_signs),
        unit(test_coefficients_of_both_signs_decide_nothing),
        unit(test_a_counterexample_fails_and_its_control_holds),
        unit(test_what_is_no_counterexample),
        unit(test_data_are_the_same_dyadics_everywhere),
        unit(test_pick_stays_in_range),
        unit(test_exhibits),
        unit(test_a_failing_case_tells_its_degree),
        unit(test_the_smallest_instance_of_a_failure),
        unit(test_an_instance_that_is_not_found),
        unit(test_a_failing_decision_tells_its_data_and_its_condition),
        unit(test_a_failing_case_tells_its_data),
        unit(test_a_decision_without_data_is_tried_once_a_degree),
        unit(test_given_data),
        unit(test_given_data_are_tied_to_the_body),
        unit(test_data_instead),
        unit(test_given_in_every_type),
        unit(test_context),
        unit(test_results_do_not_depend_on_the_jobs),
        unit(test_no_claims),
        unit(test_every_combination_of_roles),
        unit(test_evidence_is_that_of_the_weakest_claim),
        unit(test_what_refutes_is_as_good_as_its_weakest),
        unit(test_readings),
        unit(test_result_of),
        unit(test_the_scope_is_what_all_claims_have_in_common),
        unit(test_a_narrower_phrase_is_left),
        unit(test_claims_about_different_things_are_apart),
        unit(test_data_that_nobody_has_together_are_told_by_step),
        unit(test_conditions_reach_the_verdict),
        unit(test_what_a_phrase_says_are_definite_ones_are_not_all),
        unit(test_data_within_hypotheses),
        unit(test_letters_of_the_statement_alone_are_told),
        unit(test_the_only_degree_of_a_statement),
        unit(test_the_finding_of_one_claim),
        unit(test_the_finding_of_a_reading),
        unit(test_cases_in_words_are_added_up),
        unit(test_claims_without_a_common_case),
        unit(test_arguments),
        unit(test_a_claim_that_needs_words_is_argued),
        unit(test_finding_words),
    };
    return run_unit_tests(tests);
}
