#include "core/fit/by_feet.h"
#include "core/fit/candidate.h"
#include "core/require.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

/* cures.c -- what else can be asked for where a fit is not good, and whether it helps: each is tried on the same points. */

enum {
    BESIDE = CAGD_FIT_GAPS | CAGD_FIT_DEVIATIONS, /* what may be of the points, and not of the curve */
    WANDERING = CAGD_FIT_EXCURSIONS | CAGD_FIT_LOOPS | CAGD_FIT_FAR | CAGD_FIT_BACKWARDS,
    SIMPLE = CAGD_FIT_STRUCTURE | CAGD_FIT_COARSE
};

/* The fit that is to be cured. */
typedef struct patient {
    const cagd_fit_data *data;
    const cagd_fit_options *options;
    const cagd_fit_choices *choices;
    const cagd_fit_result *result;
    int problems, strays;
    cagd_fit_cures *cures;
} patient;

static int own_count(const cagd_fit_result *r) { return r->period > 0 ? r->period : r->curve.count; }

/* Whether degree and knots are open to another wish: not those of a given curve, of given knots or of a distance. */
static int is_open(const patient *p)
{
    return p->options->initial == NULL && p->options->knots == NULL && !(p->choices->within > 0);
}

/* The trial that asks for the same as the fit; the caller changes it. */
static cagd_fit_trial same(const patient *p, cagd_fit_cure cure)
{
    cagd_fit_trial t = {.cure = cure, .options = *p->options, .choices = *p->choices, .problems = ~0, .rms = NAN};
    t.options.without_intervals = 1;
    t.options.after_start = NULL;
    return t;
}

/* A spline of so many control points, 0: as many as the points ask for, of the degree of the curve, 3 where that was chosen. */
static void ask_for_spline(const patient *p, int count, cagd_fit_trial *t)
{
    t->options.degree = t->choices.form ? 3 : p->options->degree;
    t->options.count = count;
    t->choices.form = 0;
    t->choices.count = count == 0;
    if (t->choices.weights)
        t->options.free &= ~CAGD_FIT_WEIGHTS;
}

/* Whether the points of a trial lie along its curve as they should: of points in no order those of its feet are their order. */
static cagd_status look(const patient *p, const cagd_fit_result *r, const cagd_fit_options *options, int *problems)
{
    cagd_fit_quality quality = {0};
    cagd_fit_options ordered = *options;
    fit_by_feet sorted;
    cagd_status status = CAGD_NO_MEMORY;
    ordered.unordered = 0;
    if (!options->unordered)
        status = cagd_fit_quality_of(p->data, options, r, &quality);
    else {
        if (fit_by_feet_of(p->data, r, &sorted))
            status = cagd_fit_quality_of(&sorted.data, &ordered, &sorted.result, &quality);
        fit_by_feet_free(&sorted);
    }
    *problems = quality.problems;
    return status;
}

/* Makes the trial, and keeps it: whether it is a minimum, what is not good about it.  One that the points do not allow is none. */
static cagd_status try_it(const patient *p, cagd_fit_trial t)
{
    cagd_fit_cures *cures = p->cures;
    cagd_fit_result *fit;
    REQUIRE(cures->count < CAGD_FIT_MAX_TRIALS, CAGD_OK);
    cagd_status status = cagd_fit_choose(p->data, &t.options, &t.choices, &fit, NULL);
    REQUIRE(status == CAGD_OK, status == CAGD_NO_MEMORY ? status : CAGD_OK);
    t.minimum = cagd_fit_is_minimum(fit);
    t.rms = fit->outliers > 0 ? fit->rms_of_others : fit->rms;
    if (t.minimum)
        status = look(p, fit, &t.options, &t.problems);
    if (t.minimum && t.options.unordered && !fit_is_good(p->data, &t.options, fit))
        t.problems |= CAGD_FIT_EXCURSIONS;
    cagd_fit_free(fit);
    REQUIRE(status == CAGD_OK, status);
    t.options.without_intervals = p->options->without_intervals;
    t.options.after_start = p->options->after_start;
    if (cures->best < 0 && t.minimum && t.problems == 0)
        cures->best = cures->count;
    cures->trial[cures->count++] = t;
    return CAGD_OK;
}

/* ---- what is asked for ----------------------------------------------------------------------------------- */

static cagd_status try_unordered(const patient *p)
{
    cagd_fit_trial t = same(p, CAGD_FIT_CURE_UNORDERED);
    REQUIRE(!p->options->unordered && !p->options->monotone, CAGD_OK);
    t.options.unordered = 1;
    return try_it(p, t);
}

static cagd_status try_monotone(const patient *p)
{
    cagd_fit_trial t = same(p, CAGD_FIT_CURE_MONOTONE);
    REQUIRE(!p->options->unordered && !p->options->monotone && p->options->loss == CAGD_FIT_SQUARES &&
                p->options->weight_low == 0 && isinf(p->options->weight_high),
            CAGD_OK);
    t.options.monotone = 1;
    if (t.choices.form)
        ask_for_spline(p, 0, &t);
    return try_it(p, t);
}

/* x to one digit, as one writes it. */
static double rounded(double x)
{
    const double unit = pow(10, floor(log10(x)));
    return x > 0 && isfinite(x) ? fmax(1, rint(x / unit)) * unit : x;
}

/* lambda 0: by cross-validation. */
static cagd_status try_smooth(const patient *p, double lambda)
{
    cagd_fit_trial t = same(p, lambda > 0 ? CAGD_FIT_CURE_LIGHTER : CAGD_FIT_CURE_SMOOTH);
    const int given_weights = !p->choices->weights && p->options->free & CAGD_FIT_WEIGHTS,
              smoothed = p->result->roughness > 0;
    REQUIRE(p->options->initial == NULL && !(p->choices->within > 0) && !given_weights &&
                (p->choices->form || p->options->degree > 1) && smoothed == (lambda > 0),
            CAGD_OK);
    if (t.options.knots == NULL)
        ask_for_spline(p, p->options->count, &t);
    t.options.free &= ~CAGD_FIT_WEIGHTS;
    t.choices.smooth = lambda == 0;
    t.options.smooth = lambda;
    return try_it(p, t);
}

/* So many control points; 0: as many as the points ask for. */
static cagd_status try_count(const patient *p, int count)
{
    cagd_fit_trial t = same(p, count == 0 ? CAGD_FIT_CURE_AUTO : CAGD_FIT_CURE_COUNT);
    const int degree = p->choices->form ? 3 : p->options->degree;
    REQUIRE(is_open(p) && !p->choices->degree && degree > 1 && (count == 0 || count > degree + 1), CAGD_OK);
    if (count == 0 && (p->choices->count || (p->choices->form && p->options->loss == CAGD_FIT_SQUARES)))
        return CAGD_OK;
    ask_for_spline(p, count, &t);
    return try_it(p, t);
}

/* Fewer: three quarters, then half of them. */
static cagd_status try_fewer(const patient *p, int of_four)
{
    const int n = own_count(p->result), fewer = n * of_four / 4;
    REQUIRE(!p->result->found.ellipse.known && n > p->result->curve.degree + 2 && fewer < n, CAGD_OK);
    return try_count(p, fewer);
}

/* A Bézier curve of higher degree. */
static cagd_status try_degree(const patient *p, int more)
{
    cagd_fit_trial t = same(p, CAGD_FIT_CURE_DEGREE);
    REQUIRE(is_open(p) && !p->choices->form && !p->choices->count && !p->choices->degree && p->options->count == 0 &&
                !p->options->closed && p->choices->closed != 1 && p->options->degree + more <= CAGD_MAX_DEGREE &&
                p->result->period == 0,
            CAGD_OK);
    t.options.degree += more;
    return try_it(p, t);
}

static cagd_status try_degrees(const patient *p)
{
    cagd_fit_trial t = same(p, CAGD_FIT_CURE_DEGREES);
    REQUIRE(is_open(p) && !p->choices->degree && p->options->loss == CAGD_FIT_SQUARES, CAGD_OK);
    ask_for_spline(p, p->options->count, &t);
    t.options.degree = 2;
    t.choices.degree = 1;
    return try_it(p, t);
}

static cagd_status try_huber(const patient *p)
{
    cagd_fit_trial t = same(p, CAGD_FIT_CURE_HUBER);
    REQUIRE(p->strays > 0 && p->options->loss == CAGD_FIT_SQUARES && !p->options->monotone, CAGD_OK);
    t.options.loss = CAGD_FIT_HUBER;
    t.options.loss_scale = 0;
    return try_it(p, t);
}

/* The same with a spline: where the form is open, a robust loss alone asks for a conic, whose scores do not compare with those of others. */
static cagd_status try_huber_spline(const patient *p)
{
    cagd_fit_trial t = same(p, CAGD_FIT_CURE_HUBER_AUTO);
    REQUIRE(p->strays > 0 && p->choices->form && is_open(p) && p->options->loss == CAGD_FIT_SQUARES && !p->options->monotone, CAGD_OK);
    t.options.loss = CAGD_FIT_HUBER;
    t.options.loss_scale = 0;
    ask_for_spline(p, 0, &t);
    return try_it(p, t);
}

/* Weights 1. */
static cagd_status try_inner(const patient *p)
{
    cagd_fit_trial t = same(p, CAGD_FIT_CURE_INNER);
    REQUIRE(p->options->free & CAGD_FIT_WEIGHTS && p->options->free & CAGD_FIT_INNER_POINTS &&
                p->options->initial == NULL && !p->choices->form && !p->choices->degree,
            CAGD_OK);
    t.options.free &= ~CAGD_FIT_WEIGHTS;
    t.choices.weights = 0;
    t.choices.smooth = t.choices.smooth == 2 ? 0 : t.choices.smooth;
    if (t.choices.closed < 0 && t.options.free & CAGD_FIT_END_POINTS)
        t.choices.closed = 0;
    return try_it(p, t);
}

static cagd_status try_bounds(const patient *p)
{
    cagd_fit_trial t = same(p, CAGD_FIT_CURE_BOUNDS);
    REQUIRE(p->options->free & CAGD_FIT_WEIGHTS && !p->choices->form && p->options->weight_low == 0 &&
                isinf(p->options->weight_high),
            CAGD_OK);
    t.options.weight_low = 0.0625;
    t.options.weight_high = 16;
    return try_it(p, t);
}

static cagd_status try_iterations(const patient *p)
{
    enum { TIMES = 10, MOST = 2000 };
    cagd_fit_trial t = same(p, CAGD_FIT_CURE_ITERATIONS);
    REQUIRE(p->result->termination == CAGD_FIT_NOT_CONVERGED && p->options->max_iterations * TIMES <= MOST, CAGD_OK);
    t.options.max_iterations *= TIMES;
    return try_it(p, t);
}

static cagd_status try_starts(const patient *p)
{
    enum { STARTS = 8 };
    cagd_fit_trial t = same(p, CAGD_FIT_CURE_STARTS);
    REQUIRE(p->result->refuted && p->options->starts < STARTS, CAGD_OK);
    t.options.starts = STARTS;
    return try_it(p, t);
}

/* ---- in which order ---------------------------------------------------------------------------------------- */

/* The k-th thing to try: of fits that are no minimum; of curves that wander off; of curves that are too simple. */
static cagd_status try_next(const patient *p, int k)
{
    const double lambda = p->options->smooth > 0 ? p->options->smooth : p->result->found.smooth;
    const int failed = !cagd_fit_is_minimum(p->result), wanders = p->problems & WANDERING, simple = p->problems & SIMPLE,
              astray = failed || wanders, more = (int)fmax(5, own_count(p->result) + 1);
    switch (k) {
    case 0: return failed ? try_iterations(p) : CAGD_OK;
    case 1: return failed ? try_starts(p) : CAGD_OK;
    case 2: return failed ? try_inner(p) : CAGD_OK;
    case 3: return failed ? try_bounds(p) : CAGD_OK;
    case 4: return simple ? try_huber(p) : CAGD_OK;
    case 5: return simple ? try_huber_spline(p) : CAGD_OK;
    case 6: return astray ? try_unordered(p) : CAGD_OK;
    case 7: return wanders ? try_monotone(p) : CAGD_OK;
    case 8: return astray ? try_smooth(p, 0) : CAGD_OK;
    case 9: return astray ? try_fewer(p, 3) : CAGD_OK;
    case 10: return astray ? try_fewer(p, 2) : CAGD_OK;
    case 11: return simple && lambda > 0 ? try_smooth(p, rounded(lambda / 10)) : CAGD_OK;
    case 12: return simple && lambda > 0 ? try_smooth(p, rounded(lambda / 1000)) : CAGD_OK;
    case 13: return simple ? try_degree(p, 1) : CAGD_OK;
    case 14: return simple ? try_degree(p, 2) : CAGD_OK;
    case 15: return try_count(p, 0);
    case 16: return p->problems & CAGD_FIT_COARSE && !(lambda > 0) ? try_count(p, more) : CAGD_OK;
    case 17: return p->problems & CAGD_FIT_COARSE && !(lambda > 0) ? try_count(p, more + 1) : CAGD_OK;
    default: return simple ? try_degrees(p) : CAGD_OK;
    }
}

/* Whether nothing more is to be tried: something helps, and of feet that go back both was tried, that the points are in no order and that they are
 * in this one; which of it is so no fit can tell. */
static int is_enough(const patient *p, int k)
{
    enum { MONOTONE = 7 };
    return p->cures->best >= 0 && !(p->problems & CAGD_FIT_BACKWARDS && k < MONOTONE);
}

cagd_status cagd_fit_cures_of(const cagd_fit_data *data, const cagd_fit_options *options,
                              const cagd_fit_choices *choices, const cagd_fit_result *result,
                              const cagd_fit_quality *quality, cagd_fit_cures *cures)
{
    enum { ALL = 19 };
    const patient p = {data, options, choices, result, quality->problems, quality->strays, cures};
    const int failed = !cagd_fit_is_minimum(result);
    *cures = (cagd_fit_cures){.best = -1};
    REQUIRE(options->free != 0 && (failed || quality->problems & ~BESIDE || quality->strays > 0), CAGD_OK);
    if (data->count > CAGD_FIT_MOST_TRIED || own_count(result) > CAGD_FIT_MOST_TRIED_CONTROL_POINTS) {
        cures->too_many = 1;
        return CAGD_OK;
    }
    if (!failed && !(quality->problems & ~BESIDE)) {
        const cagd_status status = try_huber(&p);
        return status == CAGD_OK && cures->best < 0 ? try_huber_spline(&p) : status;
    }
    for (int k = 0; k < ALL && !is_enough(&p, k - 1); k++) {
        const cagd_status status = try_next(&p, k);
        REQUIRE(status == CAGD_OK, status);
    }
    return CAGD_OK;
}
