/* test_fit_choices.c -- which curve is chosen, what is tried where a fit is not good, and which ends are left out: small sets of points. */
#include "core/fit/cagd_fit.h"
#include "core/fit/candidate.h"
#include "core/fit/outliers.h"
#include "core/fit/quantile.h"
#include "core/fit/weights.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MOST_AROUND = 400 };
static double ring[3 * MOST_AROUND];

/* So many points around a circle, from the angle `from` on, `turn` degrees from one to the next, in a plane of space for dim 3. */
static cagd_fit_data on_circle(int n, int dim, double from, double turn)
{
    for (int i = 0; i < n; i++) {
        const double phi = (from + turn * i) * acos(-1) / 180, x = 7 + 2 * cos(phi), y = -3 + 2 * sin(phi);
        ring[i * dim] = x, ring[i * dim + 1] = dim == 2 ? y : 0.6 * y;
        if (dim == 3)
            ring[i * dim + 2] = 0.8 * y;
    }
    return (cagd_fit_data){n, dim, ring, NULL};
}

/* As good as normal, of variance 1, the same for every i: the sum of twelve even numbers, by splitmix64. */
static double noise_told(int i)
{
    double sum = -6;
    for (int k = 0; k < 12; k++) {
        uint64_t z = ((uint64_t)i * 12 + (uint64_t)k + 1) * 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        sum += (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }
    return sum;
}

/* ---- what cures a fit ---------------------------------------------------------------------------------------------------- */

static void scatter(int n, double size, double P[])
{
    for (int i = 0; i < n; i++) {
        const double u = (double)i / (n - 1);
        P[2 * i] = u + size * noise_told(2 * i + 1), P[2 * i + 1] = u * (1 - u) + size * noise_told(2 * i + 2);
    }
}

/* A letter for each cure that was tried, and behind it what of options and choices is not what the fit had. */
static void tell_trials(const cagd_fit_cures *cures, const cagd_fit_options *o, const cagd_fit_choices *c, char *text,
                        size_t room)
{
    char *at = text, *end = text + room;
    *at = 0;
#define TELL(what, now, before)                                                                                        \
    if ((now) != (before))                                                                                             \
    at += snprintf(at, (size_t)(end - at), " %s %.4g", what, (double)(now))
    for (int k = 0; k < cures->count; k++) {
        const cagd_fit_trial *t = &cures->trial[k];
        at += snprintf(at, (size_t)(end - at), "%s%c", k > 0 ? ", " : "", "ISNBHUMOCLDAGJ"[t->cure]);
        TELL("degree", t->options.degree, o->degree);
        TELL("count", t->options.count, o->count);
        TELL("iterations", t->options.max_iterations, o->max_iterations);
        TELL("starts", t->options.starts, o->starts);
        TELL("free", t->options.free, o->free);
        TELL("unordered", t->options.unordered, o->unordered);
        TELL("monotone", t->options.monotone, o->monotone);
        TELL("loss", t->options.loss, o->loss);
        TELL("scale", t->options.loss_scale, o->loss_scale);
        TELL("low", t->options.weight_low, o->weight_low);
        TELL("high", t->options.weight_high, o->weight_high);
        TELL("smooth", t->options.smooth, o->smooth);
        TELL("silent", t->options.without_intervals, o->without_intervals);
        TELL("form", t->choices.form, c->form);
        TELL("number", t->choices.count, c->count);
        TELL("degrees", t->choices.degree, c->degree);
        TELL("weights", t->choices.weights, c->weights);
        TELL("smoothed", t->choices.smooth, c->smooth);
        TELL("closed", t->choices.closed, c->closed);
        assert_true(t->options.after_start == o->after_start && t->minimum == (t->problems != ~0));
        assert_true(t->minimum ? t->rms > 0 : 1);
    }
#undef TELL
}

static void no_start(void *context, int ended, int starts) { (void)context, (void)ended, (void)starts; }

/* What is tried of a fit that is no minimum, or of which something else is said, on points that scatter so much that nothing helps: all of it, in its order, and what
 * each asks for.  I iterations, S starts, N without weights, B bounds, H Huber, J Huber with a spline, U unordered, M monotone, O smoothed, C another number of
 * control points, L lighter, D degree, A automatic number, G degrees. */
static void cures_are_tried_in_their_order(void **state)
{
    (void)state;
    enum {
        FAILED = 1,
        REFUTED,
        GIVEN_KNOTS = 4,
        SMOOTHED = 8,
        ORDERLESS = 16,
        ROBUST = 32,
        BOUNDED = 64,
        ELLIPSE = 128,
        CLOSED = 256
    };
    static const cagd_fit_choices plain = {.closed = 0};
    static const struct {
        int degree, count, free, how, problems, strays;
        const char *tried;
    } of[] = {
        {3, 0, 7, FAILED, 0, 0, "I iterations 400, N free 6, B low 0.0625 high 16, U unordered 1, A number 1"},
        {3, 0, 7, REFUTED | BOUNDED, 0, 0, "S starts 8, N free 6, U unordered 1, A number 1"},
        {3, 0, 6, FAILED | REFUTED, 0, 0,
         "I iterations 400, S starts 8, U unordered 1, O number 1 smoothed 1, A number 1"},
        {3, 0, 6, 0, CAGD_FIT_STRUCTURE, 2,
         "H loss 1 scale 0, D degree 4, D degree 5, A number 1, G degree 2 number 1 degrees 1"},
        {3, 0, 6, ROBUST, CAGD_FIT_COARSE, 2, "D degree 4, D degree 5, A number 1, C count 5, C count 6"},
        {3, 7, 6, GIVEN_KNOTS, CAGD_FIT_EXCURSIONS, 1, "U unordered 1, M monotone 1, O smoothed 1"},
        {3, 7, 6, GIVEN_KNOTS | BOUNDED, CAGD_FIT_FAR, 0, "U unordered 1, O smoothed 1"},
        {3, 7, 6, GIVEN_KNOTS | ROBUST, CAGD_FIT_BACKWARDS, 0, "U unordered 1, O smoothed 1"},
        {3, 7, 6, GIVEN_KNOTS | ORDERLESS, CAGD_FIT_LOOPS, 0, "O smoothed 1"},
        {3, 0, 6, 0, CAGD_FIT_GAPS, 0, ""},
        {3, 0, 6, 0, CAGD_FIT_DEVIATIONS, 0, ""},
        {3, 0, 6, 0, CAGD_FIT_GAPS | CAGD_FIT_DEVIATIONS, 1, "H loss 1 scale 0"},
        {3, 0, 6, 0, 0, 1, "H loss 1 scale 0"},
        {3, 0, 6, 0, 0, 0, ""},
        {3, 0, 6, 0, CAGD_FIT_SIMPLE, 0, "A number 1"},
        {3, 8, 6, 0, CAGD_FIT_LOOPS, 0, "U unordered 1, M monotone 1, O smoothed 1, C count 6, A count 0 number 1"},
        {3, 6, 6, 0, CAGD_FIT_LOOPS, 0, "U unordered 1, M monotone 1, O smoothed 1, A count 0 number 1"},
        {2, 6, 6, 0, CAGD_FIT_LOOPS, 0, "U unordered 1, M monotone 1, O smoothed 1, C count 4, A count 0 number 1"},
        {2, 6, 6, ELLIPSE, CAGD_FIT_LOOPS, 0, "U unordered 1, M monotone 1, O smoothed 1, A count 0 number 1"},
        {3, 7, 6, GIVEN_KNOTS, CAGD_FIT_LOOPS | CAGD_FIT_COARSE, 1,
         "H loss 1 scale 0, U unordered 1, M monotone 1, O smoothed 1"},
        {3, 6, 6, SMOOTHED, CAGD_FIT_STRUCTURE | CAGD_FIT_COARSE, 0,
         "L smooth 0.004, L smooth 4e-05, A count 0 number 1, G degree 2 degrees 1"},
        {3, 6, 6, SMOOTHED, CAGD_FIT_LOOPS, 0, "U unordered 1, M monotone 1, A count 0 number 1"},
        {1, 0, 6, 0, CAGD_FIT_COARSE | CAGD_FIT_LOOPS, 0,
         "U unordered 1, M monotone 1, D degree 2, D degree 3, G degree 2 number 1 degrees 1"},
        {2, 5, 6, CLOSED, CAGD_FIT_COARSE | CAGD_FIT_LOOPS, 0,
         "U unordered 1, M monotone 1, O smoothed 1, A count 0 number 1, C count 6, C count 7, G degrees 1"},

    };
    enum { MANY = 14 };
    double P[2 * MANY], knots[] = {0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1};
    char text[2000];
    scatter(MANY, 0.2, P);
    const cagd_fit_data d = {MANY, 2, P, NULL};
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        cagd_fit_options o = cagd_fit_defaults(), first;
        cagd_fit_result *r;
        cagd_fit_cures cures;
        cagd_fit_quality q = {.problems = of[k].problems, .strays = of[k].strays};
        o.degree = of[k].degree, o.count = of[k].count, o.free = of[k].free, o.max_iterations = 40,
        o.after_start = no_start;
        o.knots = of[k].how & GIVEN_KNOTS ? knots : NULL, o.smooth = of[k].how & SMOOTHED ? 0.0367 : 0;
        o.loss = of[k].how & ROBUST ? CAGD_FIT_CAUCHY : CAGD_FIT_SQUARES, o.unordered = of[k].how & ORDERLESS ? 1 : 0;
        o.weight_low = of[k].how & BOUNDED ? 0.5 : 0, o.closed = of[k].how & CLOSED ? 1 : 0;
        first = o, first.without_intervals = 1;
        assert_int_equal(cagd_fit(&d, &first, &r, NULL), CAGD_OK);
        r->termination = of[k].how & FAILED ? CAGD_FIT_NOT_CONVERGED : CAGD_FIT_CONVERGED,
        r->refuted = (of[k].how & REFUTED) != 0;
        r->found.ellipse.known = (of[k].how & ELLIPSE) != 0;
        assert_int_equal(cagd_fit_cures_of(&d, &o, &plain, r, &q, &cures), CAGD_OK);
        tell_trials(&cures, &o, &plain, text, sizeof text);
        assert_string_equal(text, of[k].tried);
        assert_true(cures.best == -1 && !cures.too_many);
        cagd_fit_free(r);
    }
}

/* What everything is open for is tried with a spline, as many control points as there are points for; what is far off asks for Huber's loss alone. */
static void cures_of_what_was_chosen(void **state)
{
    (void)state;
    enum { MANY = 14 };
    double P[2 * MANY];
    char text[2000];
    scatter(MANY, 0.2, P);
    cagd_fit_data d = {MANY, 2, P, NULL};
    const cagd_fit_choices all = {.closed = 0, .form = 1, .count = 1, .weights = 1};
    cagd_fit_options o = cagd_fit_defaults();
    static const struct {
        int problems, strays;
        double within;
        const char *tried;
    } of[] = {{0, 1, 0, "H loss 1 scale 0, J degree 3 free 6 loss 1 scale 0 form 0"},
              {CAGD_FIT_LOOPS, 0, 0,
               "U unordered 1, M degree 3 free 6 monotone 1 form 0, O degree 3 free 6 form 0 smoothed 1"},
              {CAGD_FIT_LOOPS | CAGD_FIT_COARSE, 1, 0.5,
               "H loss 1 scale 0, U unordered 1, M degree 3 free 6 monotone 1 form 0"}};
    for (int k = 0; k < 3; k++) {
        cagd_fit_choices c = all;
        cagd_fit_result *r;
        cagd_fit_cures cures;
        cagd_fit_quality q = {.problems = of[k].problems, .strays = of[k].strays};
        o.max_iterations = 40, c.within = of[k].within;
        assert_int_equal(cagd_fit(&d, &o, &r, NULL), CAGD_OK);
        r->found.ellipse.known = 1; /* so that no number of control points is fewer */
        r->termination = CAGD_FIT_CONVERGED;
        assert_int_equal(cagd_fit_cures_of(&d, &o, &c, r, &q, &cures), CAGD_OK);
        tell_trials(&cures, &o, &c, text, sizeof text);
        assert_string_equal(text, of[k].tried);
        /* Too many points or control points, and nothing free: nothing is tried. */
        d.count = CAGD_FIT_MOST_TRIED + 1;
        assert_int_equal(cagd_fit_cures_of(&d, &o, &c, r, &q, &cures), CAGD_OK);
        assert_true(cures.too_many && cures.count == 0 && cures.best == -1);
        d.count = MANY, r->curve.count = CAGD_FIT_MOST_TRIED_CONTROL_POINTS + 1;
        assert_int_equal(cagd_fit_cures_of(&d, &o, &c, r, &q, &cures), CAGD_OK);
        assert_true(cures.too_many && cures.count == 0);
        cagd_fit_options feet = o;
        feet.free = 0;
        assert_int_equal(cagd_fit_cures_of(&d, &feet, &c, r, &q, &cures), CAGD_OK);
        assert_true(!cures.too_many && cures.count == 0 && cures.best == -1);
        cagd_fit_free(r);
    }
}

/* A fit that stopped too early is cured by the first thing that is tried, and nothing else is; feet that fall back ask for both. */
static void what_helps_is_the_last(void **state)
{
    (void)state;
    enum { MANY = 60 };
    double P[2 * MANY];
    scatter(MANY, 0.005, P);
    const cagd_fit_data d = {MANY, 2, P, NULL};
    const cagd_fit_choices plain = {.closed = 0};
    cagd_fit_options o = cagd_fit_defaults();
    cagd_fit_result *r;
    cagd_fit_cures cures;
    for (int k = 0; k < 3; k++) {
        const cagd_fit_quality q = {.problems = k == 0 ? 0 : k == 1 ? CAGD_FIT_LOOPS : CAGD_FIT_BACKWARDS};
        assert_int_equal(cagd_fit(&d, &o, &r, NULL), CAGD_OK);
        r->termination = k == 0 ? CAGD_FIT_NOT_CONVERGED : CAGD_FIT_CONVERGED;
        assert_int_equal(cagd_fit_cures_of(&d, &o, &plain, r, &q, &cures), CAGD_OK);
        assert_int_equal(cures.best, 0);
        assert_int_equal(cures.count, k == 2 ? 2 : 1);
        assert_int_equal(cures.trial[0].cure, k == 0 ? CAGD_FIT_CURE_ITERATIONS : CAGD_FIT_CURE_UNORDERED);
        assert_true(cures.trial[0].minimum && cures.trial[0].problems == 0 &&
                    fabs(cures.trial[0].rms / r->rms - 1) < 1e-6);
        assert_true(k < 2 || cures.trial[1].cure == CAGD_FIT_CURE_MONOTONE);
        cagd_fit_free(r);
    }
}

/* ---- which curve is chosen -------------------------------------------------------------------------------------------------- */

static cagd_fit_result *chosen(const cagd_fit_data *d, const cagd_fit_options *o, const cagd_fit_choices *c)
{
    cagd_fit_result *r;
    int where = 99;
    assert_int_equal(cagd_fit_choose(d, o, c, &r, &where), CAGD_OK);
    assert_true(r != NULL && where == -1 && r->found.chosen);
    return r;
}

static void choices_that_are_refused(void **state)
{
    (void)state;
    double P[40];
    scatter(20, 0.01, P);
    const cagd_fit_data d = {20, 2, P, NULL}, none = {20, 2, NULL, NULL};
    const cagd_fit_options o = cagd_fit_defaults();
    const cagd_fit_choices all = cagd_fit_choices_all();
    assert_true(all.closed == -1 && all.form == 1 && all.count == 1 && all.degree == 0 && all.weights == 1 &&
                all.smooth == 2 && all.within == 0);
    cagd_fit_result *r;
    int where;
#define REFUSED(data, options, choices, status, place)                                                                 \
    do {                                                                                                               \
        r = (cagd_fit_result *)P, where = 99;                                                                          \
        assert_int_equal(cagd_fit_choose(data, options, choices, &r, &where), status);                                 \
        assert_true(r == NULL && where == (place));                                                                    \
    } while (0)
    REFUSED(NULL, &o, &all, CAGD_NULL, -1);
    REFUSED(&d, NULL, &all, CAGD_NULL, -1);
    REFUSED(&d, &o, NULL, CAGD_NULL, -1);
    REFUSED(&none, &o, &all, CAGD_NULL, -1);
    assert_int_equal(cagd_fit_choose(&d, &o, &all, NULL, &where), CAGD_NULL);
    cagd_fit_choices c = all;
    c.within = -1;
    REFUSED(&d, &o, &c, CAGD_BAD_OPTION, -1);
    c.within = NAN;
    REFUSED(&d, &o, &c, CAGD_BAD_OPTION, -1);
    c.within = INFINITY;
    REFUSED(&d, &o, &c, CAGD_BAD_OPTION, -1);
    static const double knots[] = {0, 0, 0, 0.5, 1, 1, 1};
    cagd_fit_options given = o;
    given.count = 4, given.knots = knots, given.free = 6;
    c = (cagd_fit_choices){.degree = 1};
    REFUSED(&d, &given, &c, CAGD_BAD_OPTION, -1);
    given = o, given.tolerance = 0;
    REFUSED(&d, &given, &all, CAGD_BAD_OPTION, -1);
    P[27] = NAN;
    REFUSED(&d, &o, &all, CAGD_BAD_DATA, 13);
#undef REFUSED
}

/* Points that come back are closed where that is open or asked, and are not where it is not; a last one that repeats the first is left out. */
static void closed_curves_are_chosen(void **state)
{
    (void)state;
    for (int closed = -1; closed <= 1; closed++)
        for (int repeated = 0; repeated < 2; repeated++) {
            const cagd_fit_data d = on_circle(24 + repeated, 2, 30, 15);
            cagd_fit_options o = cagd_fit_defaults();
            cagd_fit_choices c = {.closed = closed};
            o.degree = 3, o.count = 8, o.free = 6;
            cagd_fit_result *r = chosen(&d, &o, &c);
            assert_int_equal(r->found.closing, closed == 0 ? CAGD_FIT_OPEN
                                               : repeated  ? CAGD_FIT_REPEATED
                                                           : CAGD_FIT_AROUND);
            assert_int_equal(r->period, closed ? 8 : 0);
            assert_int_equal(r->count, closed ? 24 : 24 + repeated);
            cagd_fit_free(r);
            c.form = 1;
            r = chosen(&d, &o, &c);
            assert_true(!r->found.ellipse.known || (r->found.ellipse.whole && r->found.ellipse.circle));
            assert_true(closed == 0 || r->found.ellipse.known);
            cagd_fit_free(r);
        }
    const cagd_fit_data arc = on_circle(24, 2, 30, 5);
    cagd_fit_options o = cagd_fit_defaults();
    cagd_fit_choices c = {.closed = -1};
    o.degree = 3, o.count = 8, o.free = 6;
    cagd_fit_result *r = chosen(&arc, &o, &c);
    assert_true(r->found.closing == CAGD_FIT_OPEN && r->period == 0);
    cagd_fit_free(r);
}

/* Of a parabola the conic alone, of a line the line before the conic, of degrees each with its number; each candidate with its own score, and the best one first. */
static void candidates_are_told(void **state)
{
    (void)state;
    enum { MANY = 80 };
    double P[2 * MANY];
    cagd_fit_data d = {MANY, 2, P, NULL};
    cagd_fit_options o = cagd_fit_defaults();
    cagd_fit_choices c = cagd_fit_choices_all();
    o.without_intervals = 1;
    scatter(MANY, 0.004, P);
    cagd_fit_result *r = chosen(&d, &o, &c);
    assert_true(r->found.candidates == 1 && r->curve.degree == 2 && r->curve.count == 3);
    assert_string_equal(r->found.candidate[0].name, "a conic in one segment");
    assert_true(r->found.candidate[0].converged && r->found.candidate[0].problems == 0 &&
                r->found.candidate[0].unknowns == 7);
    assert_true(r->found.candidate[0].score == fit_score(&d, r) && r->found.candidate[0].rms == r->rms);
    cagd_fit_free(r);
    for (int i = 0; i < MANY; i++)
        P[2 * i + 1] = 0.3 * P[2 * i] + 0.004 * noise_told(2 * i + 2);
    r = chosen(&d, &o, &c);
    assert_true(r->curve.degree == 1 && r->found.candidates == 2);
    assert_string_equal(r->found.candidate[0].name, "a straight line");
    assert_string_equal(r->found.candidate[1].name, "a conic in one segment");
    assert_true(r->found.candidate[0].score == fit_score(&d, r) && r->found.candidate[0].unknowns == 4);
    cagd_fit_free(r);
    scatter(MANY, 0.004, P);
    c = (cagd_fit_choices){.degree = 1};
    o.free = 6;
    for (int within = 0; within < 2; within++) {
        c.within = within ? 0.05 : 0;
        r = chosen(&d, &o, &c);
        assert_int_equal(r->found.candidates, 4);
        int seen = 0;
        for (int k = 0; k < 4; k++) {
            const cagd_fit_candidate *own = &r->found.candidate[k];
            int degree = 0, count = 0;
            assert_int_equal(sscanf(own->name, "degree %d with %d control points", &degree, &count), 2);
            assert_true(degree >= 2 && degree <= 5 && count == degree + 1);
            seen |= 1 << degree;
            assert_true(!within || own->score == count);
            assert_true(own->unknowns == 2 * count && own->converged);
        }
        assert_int_equal(seen, 4 + 8 + 16 + 32);
        assert_true(r->found.candidate[0].score == (within ? r->curve.count : fit_score(&d, r)));
        assert_int_equal(r->curve.degree, 2);
        cagd_fit_free(r);
    }
    o.count = 4; /* enough for degrees 2 and 3 */
    r = chosen(&d, &o, &c);
    assert_int_equal(r->found.candidates, 2);
    cagd_fit_free(r);
}

/* A spline that has weights, or has none: D, m and F of the test, and what becomes of scale and intervals. */
static void weights_are_tested(void **state)
{
    (void)state;
    enum { MANY = 120 };
    static const double knots[] = {0, 0, 0, 0, 0.5, 1, 1, 1, 1}, C[] = {0, 0, 1, 2, 3, 2.5, 4, -1, 6, 1},
                        heavy[] = {1, 4, 0.5, 3, 1};
    for (int variant = 0; variant < 4; variant++) {
        const int given = variant & 1, weighted = variant & 2;
        double P[2 * MANY], s[MANY];
        const cagd_spline truth = {3, 5, 2, knots, C, weighted ? heavy : NULL};
        for (int i = 0; i < MANY; i++) {
            s[i] = 0.005;
            assert_int_equal(
                cagd_spline_point(&truth, i / (MANY - 1.0), i + 1 < MANY ? CAGD_RIGHT : CAGD_LEFT, P + 2 * i), CAGD_OK);
            for (int x = 0; x < 2; x++)
                P[2 * i + x] += 0.005 / 1.5 * noise_told(2 * i + x + 3);
        }
        const cagd_fit_data d = {MANY, 2, P, given ? s : NULL};
        cagd_fit_options o = cagd_fit_defaults();
        cagd_fit_result *without, *with, *r;
        o.degree = 3, o.count = 5, o.free = 6;
        assert_int_equal(cagd_fit(&d, &o, &without, NULL), CAGD_OK);
        assert_int_equal(cagd_fit(&d, &o, &r, NULL), CAGD_OK);
        o.free = 7;
        assert_int_equal(cagd_fit(&d, &o, &with, NULL), CAGD_OK);
        o.free = 6;
        assert_int_equal(fit_test_weights(&d, &o, 0, &r, NULL), CAGD_OK);
        const cagd_fit_found *f = &r->found;
        assert_int_equal(f->weights_number, 4);
        assert_int_equal(f->weights_freedom, without->degrees_of_freedom - 4);
        assert_true(fabs(f->weights_probability -
                         fit_f_probability(f->weights_ratio, 4, given ? 1e9 : f->weights_freedom)) < 1e-12);
        assert_int_equal(f->weights, weighted ? 1 : 0);
        if (weighted) {
            assert_true(fabs(r->chi_squared / with->chi_squared - 1) < 1e-6 &&
                        r->interval_by[0] == CAGD_FIT_INTERVAL_NOT_SOUGHT);
        } else { /* the cost falls by about what the linear model says */
            const double fall = without->chi_squared - with->chi_squared,
                         ratio = given ? fall / 4 : fall / 4 / (with->chi_squared / f->weights_freedom);
            assert_true(fabs(f->weights_ratio / ratio - 1) < 0.1 && f->weights_probability > 0.05);
            assert_true(r->interval_by[0] == without->interval_by[0] && r->scale_squared == without->scale_squared);
        }
        /* What is not asked: with a smoothing term, a robust loss, feet in order, of one segment, of no minimum. */
        for (int k = 0; k < 7; k++) {
            cagd_fit_options other = o;
            cagd_fit_result same = *without, *one = &same;
            other.loss = k == 0 ? CAGD_FIT_HUBER : CAGD_FIT_SQUARES, other.smooth = k == 1 ? 1 : 0,
            other.monotone = k == 2;
            same.termination = k == 3 ? CAGD_FIT_NOT_CONVERGED : CAGD_FIT_CONVERGED, same.points_on_curve = k == 4;
            same.found.smoothed = k == 5, same.found.ellipse.known = k == 6;
            assert_int_equal(fit_test_weights(&d, &other, 0, &one, NULL), CAGD_OK);
            assert_true(one == &same && same.found.weights == -1);
        }
        cagd_fit_free(without);
        cagd_fit_free(with);
        cagd_fit_free(r);
    }
}

/* ---- ends that are outliers ------------------------------------------------------------------------------------------------ */

/* Two points at the start and one at the end lie far off: the curve is that of the others, and all are told of alike. */
static void points_left_out_are_told_of(void **state)
{
    (void)state;
    enum { MANY = 51 };
    for (int variant = 0; variant < 4; variant++) {
        const int given = variant & 1, two = variant & 2; /* two at the start and one at the end, or one and two */
        const int start = two ? 2 : 1, end = two ? 1 : 2;
        double P[2 * MANY], s[MANY];
        scatter(MANY, 0.002, P);
        for (int i = 0; i < MANY; i++)
            s[i] = i % 3 ? 0.002 : 0.004;
        for (int i = 0; i < start; i++)
            P[2 * i + 1] += i ? -0.2 : 0.3;
        for (int i = 0; i < end; i++)
            P[2 * (MANY - 1 - i) + 1] += i ? -0.2 : 0.35;
        P[2 * 25 + 1] += given ? 0.45 : 0; /* the farthest one may be none of those that are left out */
        const cagd_fit_data d = {MANY, 2, P, given ? s : NULL},
                            inner = {MANY - 3, 2, P + 2 * start, given ? s + start : NULL};
        cagd_fit_options o = cagd_fit_defaults();
        cagd_fit_result *r, *of_inner;
        o.loss = CAGD_FIT_HUBER, o.loss_scale = 0, o.without_intervals = 1;
        assert_int_equal(cagd_fit(&d, &o, &r, NULL), CAGD_OK);
        assert_int_equal(cagd_fit(&inner, &o, &of_inner, NULL), CAGD_OK);
        assert_true(r->left_out[0] == start && r->left_out[1] == end && r->end_is_judged[0] && r->end_is_judged[1]);
        assert_true(r->end_points[0] == start && r->end_points[1] == MANY - 1 - end && r->count == MANY);
        assert_true(of_inner->left_out[0] == 0 && of_inner->left_out[1] == 0 && of_inner->count == MANY - 3);
        assert_memory_equal(r->curve.points, of_inner->curve.points, 6 * sizeof(double));
        assert_true(r->cost == of_inner->cost && r->scale_squared == of_inner->scale_squared);
        double squares = 0, largest = 0;
        int at = 0, outliers = 0, at_ends = 0;
        for (int i = 0; i < MANY; i++) {
            double C[2];
            const double away = hypot(r->residuals[2 * i], r->residuals[2 * i + 1]);
            assert_true(fabs(away - fabs(r->distances[i])) < 1e-12);
            assert_int_equal(cagd_spline_point(&r->curve, r->feet[i], r->feet[i] < 1 ? CAGD_RIGHT : CAGD_LEFT, C),
                             CAGD_OK);
            for (int c = 0; c < 2; c++)
                assert_true(fabs(C[c] + r->residuals[2 * i + c] - P[2 * i + c]) < 1e-12);
            squares += away * away, outliers += r->outlier[i], at_ends += r->foot_at_end[i];
            if (away > largest)
                largest = away, at = i;
            assert_true(!(i < start || i >= MANY - end) || r->outlier[i]);
        }
        assert_true(fabs(r->rms - sqrt(squares / MANY)) < 1e-12 && fabs(r->largest - largest) < 1e-12);
        assert_int_equal(r->largest_at, at);
        assert_int_equal(r->outliers, outliers);
        assert_int_equal(r->feet_at_ends, at_ends);
        assert_true(at_ends > 0); /* beyond the ends no foot is orthogonal */
        /* N P(F > z^2) = 0.05 with 1 and 0.37 f degrees of freedom, of the data and the fit that were judged last: one point less than are left */
        const double z = r->end_limit, f = of_inner->degrees_of_freedom - 1;
        assert_true(fabs((MANY)*fit_f_probability(z * z, 1, 0.3675 * f) / 0.05 - 1) < 1e-6);
        cagd_fit_free(of_inner);
        cagd_fit_free(r);
        o.loss = CAGD_FIT_SQUARES, o.loss_scale = 1;
        assert_int_equal(cagd_fit(&d, &o, &r, NULL), CAGD_OK);
        assert_true(r->left_out[0] == 0 && r->left_out[1] == 0 && !r->end_is_judged[0] && r->end_limit == 0);
        cagd_fit_free(r);
        o.loss = CAGD_FIT_HUBER, o.loss_scale = 0, o.ends = CAGD_FIT_ENDS_SLIDE;
        assert_int_equal(cagd_fit(&d, &o, &r, NULL), CAGD_OK);
        assert_true(r->left_out[0] == 0 && r->left_out[1] == 0 && !r->end_is_judged[0] && !r->end_is_judged[1]);
        cagd_fit_free(r);
    }
}

/* Points in no order have no first one that could be judged. */
static void ends_without_order_are_not_judged(void **state)
{
    (void)state;
    double P[2 * 40];
    scatter(40, 0.002, P);
    P[1] -= 0.1;
    cagd_fit_options o = cagd_fit_defaults();
    cagd_fit_result *r;
    o.loss = CAGD_FIT_CAUCHY, o.loss_scale = 0, o.unordered = 1, o.without_intervals = 1;
    assert_int_equal(cagd_fit(&(cagd_fit_data){40, 2, P, NULL}, &o, &r, NULL), CAGD_OK);
    assert_true(r->left_out[0] == 0 && r->left_out[1] == 0 && !r->end_is_judged[0] && !r->end_is_judged[1] &&
                r->count == 40);
    cagd_fit_free(r);
}

/* The scale of a robust loss is the one that the distances of its own curve say, to a hundredth; where more than half of these are 0 it is their root mean
 * square. */
static void a_robust_scale_is_that_of_its_own_curve(void **state)
{
    (void)state;
    double P[2 * 60], s[60];
    static const double knots[] = {0, 0, 1, 1}, line[] = {0, 0, 10, 0};
    for (int k = 0; k < 4; k++) {
        scatter(60, 0.004, P);
        for (int i = 0; i < 60; i++)
            P[2 * i + 1] += i % 4 == 1 ? 0.05 * (i % 3 + 1) : 0, s[i] = 0.002 * (1 + i % 2);
        const cagd_fit_data d = {60, 2, P, k & 2 ? s : NULL};
        cagd_fit_options o = cagd_fit_defaults();
        cagd_fit_result *r;
        o.loss = k & 1 ? CAGD_FIT_HUBER : CAGD_FIT_CAUCHY, o.loss_scale = 0, o.without_intervals = 1;
        assert_int_equal(cagd_fit(&d, &o, &r, NULL), CAGD_OK);
        const double wanted = fit_loss_scale_of(o.loss, fit_robust_deviation(&d, r));
        assert_true(r->left_out[0] + r->left_out[1] > 0 || fabs(r->loss_scale - wanted) <= wanted / 90);
        cagd_fit_free(r);
    }
    const cagd_spline given = {1, 2, 2, knots, line, NULL};
    cagd_fit_options o = cagd_fit_defaults();
    cagd_fit_result *r;
    for (int i = 0; i < 21; i++)
        P[2 * i] = 0.1 + i * 0.4, P[2 * i + 1] = i % 5 == 0 ? 3 : 0;
    o.initial = &given, o.free = 0, o.loss = CAGD_FIT_HUBER, o.loss_scale = 0;
    assert_int_equal(cagd_fit(&(cagd_fit_data){21, 2, P, NULL}, &o, &r, NULL), CAGD_OK);
    assert_true(fabs(r->loss_scale - sqrt(5 * 9 / 21.0)) < 1e-14 && r->outliers == 0);
    cagd_fit_free(r);
}

/* ---- what every result says -------------------------------------------------------------------------------------------------- */

static int starts_ended, starts_asked, in_turn;
static void count_start(void *context, int ended, int starts)
{
    in_turn &= ended == starts_ended + 1 && context == (void *)&starts_ended;
    starts_ended = ended, starts_asked = starts;
}

/* Open and closed, in order and in none, with deviations, with a smoothing term, near the origin and far from it on either side: points, distances, values and spacings
 * by their definition. */
static void results_say_what_they_are(void **state)
{
    (void)state;
    enum { MANY = 60 };
    for (int variant = 0; variant < 32; variant++) {
        const int dim = variant & 1 ? 3 : 2, closed = variant & 2, unordered = variant & 4, smooth = variant & 8;
        const double far = variant & 16 ? (variant & 1 ? -1e6 : 3e6) : 0;
        if (closed && unordered)
            continue;
        double P[3 * MANY], s[MANY];
        for (int i = 0; i < MANY; i++) {
            const int k = unordered ? i * 7 % MANY : i;
            const double a = closed ? 2 * acos(-1) * (k + 0.5) / MANY : 2.0 * k / MANY,
                         at[3] = {4 * cos(a), 3 * sin(a), sin(2 * a)};
            for (int c = 0; c < dim; c++)
                P[i * dim + c] = (c == 1 ? -far : far) + at[c] + 0.02 * noise_told(dim * i + c);
            s[i] = 0.02 * (1 + i % 2);
        }
        const cagd_fit_data d = {MANY, dim, P, variant % 5 || smooth ? s : NULL};
        cagd_fit_options o = cagd_fit_defaults();
        cagd_fit_result *r;
        o.degree = 3, o.count = closed ? 8 : 5, o.free = 6, o.closed = closed ? 1 : 0, o.unordered = unordered ? 1 : 0;
        o.smooth = smooth ? 1e-4 : 0, o.without_intervals = variant % 3 == 0, o.starts = 1 + variant % 2;
        o.after_start = count_start, o.context = &starts_ended, starts_ended = 0, in_turn = 1;
        assert_int_equal(cagd_fit(&d, &o, &r, NULL), CAGD_OK);
        assert_true(unordered || (in_turn && starts_ended == o.starts && starts_asked == o.starts));
        assert_true(cagd_fit_is_minimum(r) && r->agreeing_starts >= 1 && r->agreeing_starts <= o.starts);
        const int own = closed ? 8 : 5, count = own + (closed ? 3 : 0);
        assert_true(r->curve.count == count && r->period == (closed ? own : 0) && r->unknowns == own * dim &&
                    r->count == MANY);
        for (int k = 0; k < r->unknowns; k++) {
            const cagd_fit_unknown u = r->unknown[k];
            assert_true(!u.is_weight && u.index == k / dim && u.coordinate == k % dim);
            assert_true(r->value[k] == r->curve.points[k]);
            assert_true(fabs(r->relative[k] + r->origin[u.coordinate] - r->value[k]) <= r->spacing[u.coordinate]);
        }
        for (int k = own * dim; k < count * dim; k++)
            assert_true(r->curve.points[k] == r->curve.points[k - own * dim]);
        double squares = 0, largest = 0, cost = 0, size[3] = {0};
        int at = 0, at_ends = 0, behind = 0;
        cagd_spline near = r->curve;
        near.points = r->relative;
        for (int i = 0; i < MANY; i++) {
            double D[6], square = 0;
            const double end = near.knots[near.count];
            assert_int_equal(
                cagd_spline_derivatives(&near, r->feet[i], r->feet[i] < end ? CAGD_RIGHT : CAGD_LEFT, 1, D), CAGD_OK);
            for (int c = 0; c < dim; c++) {
                const double left = P[i * dim + c] - r->origin[c] - D[c];
                assert_true(fabs(r->residuals[i * dim + c] - left) < 1e-12);
                square += left * left, size[c] = fmax(size[c], fabs(P[i * dim + c]));
            }
            const double left_side = dim == 2 ? D[2] * r->residuals[2 * i + 1] - D[3] * r->residuals[2 * i] : 1;
            assert_true(fabs(r->distances[i] - copysign(sqrt(square), left_side)) < 1e-12);
            squares += square, cost += square / (d.sigma != NULL ? s[i] * s[i] : 1) / 2;
            if (sqrt(square) > largest)
                largest = sqrt(square), at = i;
            at_ends += r->foot_at_end[i], behind += i > 0 && r->feet[i] < r->feet[i - 1];
        }
        assert_true(fabs(r->rms - sqrt(squares / MANY)) < 1e-12 && fabs(r->largest - largest) < 1e-12 &&
                    r->largest_at == at);
        assert_true(r->feet_at_ends == at_ends && r->out_of_order == (unordered ? 0 : behind - (closed && behind > 0)));
        assert_true(fabs(2 * cost / r->chi_squared - 1) < 1e-9 &&
                    (smooth ? r->cost > cost : fabs(r->cost / cost - 1) < 1e-9));
        if (smooth) /* lambda/2 times the integral that is told */
            assert_true(fabs((r->cost - cost) / (1e-4 / 2 * r->roughness) - 1) < 1e-6 && r->effective < r->unknowns);
        else
            assert_true(r->roughness == 0 && r->effective == r->rank);
        for (int c = 0; c < dim; c++)
            assert_true(r->spacing[c] == nextafter(size[c], INFINITY) - size[c]);
        assert_true(!r->points_on_curve && r->outliers == 0 && r->rms_of_others == r->rms);
        for (int q = 0; q < r->unknowns + r->invariants; q++)
            assert_true((r->interval_by[q] == CAGD_FIT_INTERVAL_NOT_SOUGHT) == (o.without_intervals || smooth));
        cagd_fit_free(r);
    }
}

/* A weight on its bound is no unknown: it is not determined, and the gradient along it is not that of a minimum. */
static void weights_on_their_bounds(void **state)
{
    (void)state;
    double P[2 * 40];
    for (int i = 0; i < 40; i++)
        P[2 * i] = 3 * cos(i * 2.6 / 39) + 0.001 * noise_told(2 * i),
              P[2 * i + 1] = 3 * sin(i * 2.6 / 39) + 0.001 * noise_told(2 * i + 1);
    for (int high = 0; high < 2;
         high++) { /* the weight cos(1.3) = 0.27, which is to be 0.9 or more; of the other bound, 3 to be 1.1 or less */
        cagd_fit_options o = cagd_fit_defaults();
        cagd_fit_result *r;
        if (high)
            for (int i = 0; i < 40; i++) { /* y = 1/x, from 1/10 to 10 */
                const double t = pow(10, i / 19.5 - 1);
                P[2 * i] = t + 0.001 * noise_told(2 * i), P[2 * i + 1] = 1 / t + 0.001 * noise_told(2 * i + 1);
            }
        o.weight_low = high ? 0 : 0.9, o.weight_high = high ? 1.1 : INFINITY, o.without_intervals = 1;
        assert_int_equal(cagd_fit(&(cagd_fit_data){40, 2, P, NULL}, &o, &r, NULL), CAGD_OK);
        int k = 0;
        while (!r->unknown[k].is_weight)
            k++;
        assert_true(r->curve.weights[1] == (high ? 1.1 : 0.9) && r->at_bound[k] && !r->determined[k] && r->rank <= 6);
        assert_true(r->gradient_norm < 1e-6 && isnan(cagd_fit_unknown_estimate(r, k).error));
        for (int m = 0; m < r->unknowns; m++)
            assert_true(m == k || (!r->at_bound[m] && r->determined[m]));
        cagd_fit_free(r);
    }
}

/* Knots of a closed curve have a period, each of them; it has more points than its degree; weights are numbers. */
static void curves_that_are_none(void **state)
{
    (void)state;
    double P[2 * 40], C[2 * 10], w[10];
    scatter(40, 0.01, P);
    const cagd_fit_data d = {40, 2, P, NULL};
    for (int k = -1; k < 14; k++) {
        double knots[14];
        cagd_fit_options o = cagd_fit_defaults();
        cagd_fit_result *r;
        for (int i = 0; i < 14; i++)
            knots[i] = (i - 3) / 7.0 + (i == k ? 0.01 : 0);
        o.degree = 3, o.count = 7, o.closed = 1, o.free = 6, o.knots = knots;
        const int paired = k < 0 || (k - 7 < 0 && k + 7 > 13); /* no other knot is to be a period away */
        assert_int_equal(cagd_fit(&d, &o, &r, NULL), paired ? CAGD_OK : CAGD_BAD_CURVE);
        cagd_fit_free(r);
    }
    for (int count = 2; count <= 5; count++) {
        cagd_fit_options o = cagd_fit_defaults();
        cagd_fit_result *r;
        o.degree = 3, o.count = count, o.closed = 1, o.free = 6;
        assert_int_equal(cagd_fit(&d, &o, &r, NULL), count > 3 ? CAGD_OK : CAGD_BAD_CURVE);
        cagd_fit_free(r);
    }
    static const double bezier[] = {0, 0, 0, 0, 1, 1, 1, 1};
    static const double wrong[] = {0, -1, INFINITY, NAN};
    for (int j = 0; j < 4; j++)
        for (int k = 0; k < 8; k++) {
            cagd_fit_options o = cagd_fit_defaults();
            cagd_fit_result *r;
            for (int i = 0; i < 4; i++)
                w[i] = 1, C[2 * i] = i, C[2 * i + 1] = i % 2;
            if (k < 4)
                w[j] = wrong[k];
            else
                C[2 * j + k % 2] = k < 6 ? INFINITY : NAN;
            const cagd_spline curve = {3, 4, 2, bezier, C, w};
            o.initial = &curve;
            assert_int_equal(cagd_fit(&d, &o, &r, NULL), CAGD_BAD_CURVE);
            assert_null(r);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cures_are_tried_in_their_order),
        cmocka_unit_test(cures_of_what_was_chosen),
        cmocka_unit_test(what_helps_is_the_last),
        cmocka_unit_test(choices_that_are_refused),
        cmocka_unit_test(closed_curves_are_chosen),
        cmocka_unit_test(candidates_are_told),
        cmocka_unit_test(weights_are_tested),
        cmocka_unit_test(points_left_out_are_told_of),
        cmocka_unit_test(ends_without_order_are_not_judged),
        cmocka_unit_test(a_robust_scale_is_that_of_its_own_curve),
        cmocka_unit_test(results_say_what_they_are),
        cmocka_unit_test(weights_on_their_bounds),
        cmocka_unit_test(curves_that_are_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
