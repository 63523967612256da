#include "core/fit/arguments.h"
#include "core/fit/candidate.h"
#include "core/fit/closing.h"
#include "core/fit/ellipse.h"
#include "core/fit/ellipse_result.h"
#include "core/fit/end_outliers.h"
#include "core/fit/fit.h"
#include "core/fit/refine.h"
#include "core/fit/weights.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* choose.c -- which curve is fitted where the options leave that open. */

enum { FEW = 64 };                /* points: of fewer the distances may look like noise though they are none */
static const double SMALL = 0.02; /* of the width of the points: where distances are larger, others have a chance */

/* The widest side of the box about the points. */
static double extent_of(const cagd_fit_data *data)
{
    double extent = 0;
    for (int c = 0; c < data->dim; c++) {
        double low = data->points[c], high = low;
        for (int i = 1; i < data->count; i++) {
            low = fmin(low, data->points[(size_t)i * (size_t)data->dim + (size_t)c]);
            high = fmax(high, data->points[(size_t)i * (size_t)data->dim + (size_t)c]);
        }
        extent = fmax(extent, high - low);
    }
    return extent;
}

cagd_fit_choices cagd_fit_choices_all(void)
{
    return (cagd_fit_choices){.closed = -1, .form = 1, .count = 1, .weights = 1, .smooth = 2};
}

/* What speaks against a candidate beside another one: structure that is beneath what the points are given to, too. */
static int against(const cagd_fit_candidate *c) { return c->problems | (c->beneath ? CAGD_FIT_STRUCTURE : 0); }

/* Whether the best candidate, a conic in one segment or an ellipse, does for the points: nothing but a gap between them, or deviations that may be
 * given wrongly, is found against it.  A
 * conic whose middle point is far away, an arc of nearly a half turn, is better told by centre and axes. */
static int is_enough(const cagd_fit_data *data, const cagd_fit_found *found, const cagd_fit_result *r)
{
    return !(against(&found->candidate[0]) & ~(CAGD_FIT_GAPS | CAGD_FIT_DEVIATIONS)) &&
           (r->points_on_curve || r->rms <= extent_of(data) * SMALL);
}

/* How many points of the curve are its own. */
static int own_count(const cagd_fit_result *r) { return r->period > 0 ? r->period : r->curve.count; }

/* Whether a candidate, though not good, shows that one which nothing is said against is too simple: by a score that is lower by FIT_VERY_STRONG.  One
 * that goes to and fro between the points is nearer to them for that alone, and shows nothing. */
static int shows_simple(const cagd_fit_candidate *c, const cagd_fit_candidate *simple)
{
    const int astray = CAGD_FIT_EXCURSIONS | CAGD_FIT_LOOPS | CAGD_FIT_BACKWARDS;
    return against(simple) == 0 && !(c->problems & astray) && c->score < simple->score - FIT_VERY_STRONG;
}

/* Whether a candidate is better than the best one so far: one against which nothing is found before one with problems, then the lower score.
 * Where both have none, as of too few points, one that is good, then the lower root mean square. */
static int is_better(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_candidate *c,
                     const cagd_fit_result *one, const cagd_fit_candidate *b, const cagd_fit_result *best)
{
    if ((against(c) == 0) != (against(b) == 0))
        return against(c) == 0;
    if (!isinf(c->score) || !isinf(b->score))
        return c->score < b->score;
    const int good = fit_is_good(data, options, one), best_is_good = fit_is_good(data, options, best);
    return good > best_is_good || (good == best_is_good && one->rms < best->rms);
}

/* Whether the curve `one` is to compete with the best one, which does for the points: it shows that that one is too simple, or nothing is found
 * against it, as there is against that one.  Deviations that are too small for the best one may be given wrongly: then scores are those of unknown
 * ones, and that alone is no reason. */
static cagd_status counts_beside(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *one,
                                 const cagd_fit_result *best, const cagd_fit_found *found, int *counts)
{
    cagd_fit_data own = *data;
    cagd_fit_candidate c = {.problems = ~0}, simple = found->candidate[0];
    int beneath;
    *counts = 0;
    REQUIRE(fit_is_good(data, options, one), CAGD_OK);
    const cagd_status status = fit_problems_of(data, options, one, &c.problems, &beneath);
    own.sigma = simple.problems & CAGD_FIT_DEVIATIONS ? NULL : data->sigma;
    simple.problems &= ~CAGD_FIT_DEVIATIONS;
    simple.score = fit_score(&own, best), c.score = fit_score(&own, one);
    *counts = shows_simple(&c, &simple) || (c.problems == 0 && against(&simple) != 0);
    return status;
}

/* The candidate is added to those that were found, in the first place where it is the best one. */
static void enter(const cagd_fit_candidate *c, int first, cagd_fit_found *found)
{
    if (found->candidates == CAGD_FIT_MAX_CANDIDATES)
        return;
    int at = first ? 0 : found->candidates;
    for (int k = found->candidates++; k > at; k--)
        found->candidate[k] = found->candidate[k - 1];
    found->candidate[at] = *c;
}

/* The candidate takes the place of the best one if it is better; it is released otherwise.  NULL: there is none.  within > 0: its score is the number
 * of its control points if it keeps within that distance, and if it does not, that is a problem, too. */
static cagd_status compete_within(const cagd_fit_data *data, const cagd_fit_options *options, double within,
                                  const char *name, cagd_fit_result *one, cagd_fit_result **best, cagd_fit_found *found)
{
    int problems, beneath;
    REQUIRE(one != NULL, CAGD_OK);
    const cagd_status status = fit_problems_of(data, options, one, &problems, &beneath);
    REQUIRE(status == CAGD_OK, (cagd_fit_free(one), status));
    const int counts = fit_is_good(data, options, one) && (within == 0 || one->largest <= within);
    const double score = !counts ? INFINITY : within > 0 ? own_count(one) : fit_score(data, one);
    cagd_fit_candidate c = {"",
                            (int)lrint(one->effective),
                            cagd_fit_is_minimum(one),
                            counts ? problems & (beneath ? ~CAGD_FIT_STRUCTURE : ~0) : ~0,
                            counts && beneath,
                            score,
                            one->rms};
    snprintf(c.name, sizeof c.name, "%s", name);
    cagd_fit_candidate *b = &found->candidate[0];
    if (*best != NULL && within == 0) {
        b->problems |= shows_simple(&c, b) ? CAGD_FIT_SIMPLE : 0;
        c.problems |= shows_simple(b, &c) ? CAGD_FIT_SIMPLE : 0;
    }
    const int first = *best == NULL || is_better(data, options, &c, one, b, *best);
    enter(&c, first, found);
    cagd_fit_free(first ? *best : one);
    *best = first ? one : *best;
    return CAGD_OK;
}

static cagd_status compete(const cagd_fit_data *data, const cagd_fit_options *options, const char *name,
                           cagd_fit_result *one, cagd_fit_result **best, cagd_fit_found *found)
{
    return compete_within(data, options, 0, name, one, best, found);
}

/* The degrees from 2 to 5, each with the number of control points that is given or that it asks for. */
static cagd_status choose_degree(const cagd_fit_data *data, const cagd_fit_options *options,
                                 const cagd_fit_choices *choices, cagd_fit_result **result, cagd_fit_found *found,
                                 int *where)
{
    enum { LOWEST = 2, HIGHEST = 5 };
    for (int p = LOWEST; p <= HIGHEST; p++) {
        cagd_fit_options own = *options;
        cagd_fit_result *one = NULL;
        char name[64];
        own.degree = p;
        if (own.count > 0 && own.count <= p) /* of a closed curve, too, the points are more than the degree */
            break;
        cagd_status status = fit_refined(data, &own, choices, &one, where);
        if (status == CAGD_OK && choices->weights && !(own.free & CAGD_FIT_WEIGHTS))
            status = fit_test_weights(data, &own, choices->within, &one, where);
        if (status == CAGD_TOO_FEW && *result != NULL)
            break;
        REQUIRE(status == CAGD_OK, status);
        snprintf(name, sizeof name, "degree %d with %d control points", p, own_count(one));
        status = compete_within(data, &own, choices->within, name, one, result, found);
        REQUIRE(status == CAGD_OK, status);
    }
    return *result != NULL ? CAGD_OK : CAGD_BAD_OPTION;
}

/* Whether a line does, however the conic came out: nothing is found against it, the distances from it are small, and its score is no higher; of a
 * robust loss, whose scales differ, something is found against the conic instead.  Along a line a conic may take up errors with a very large middle
 * weight, or come to a minimum that runs to and fro. */
static cagd_status line_does(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *line,
                             const cagd_fit_candidate *conic, int *does)
{
    int problems, beneath;
    const cagd_status status = fit_problems_of(data, options, line, &problems, &beneath);
    const int better = options->loss == CAGD_FIT_SQUARES ? fit_score(data, line) <= conic->score : conic->problems != 0;
    *does = status == CAGD_OK && problems == 0 && line->rms <= extent_of(data) * SMALL && better;
    return status;
}

/* A conic in one segment and, where it is hardly bent, there is none, or a straight line does, that line. */
static cagd_status try_conic(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result **result,
                             cagd_fit_found *found, int *where)
{
    cagd_fit_result *one = NULL;
    cagd_status status = fit_plainly(data, options, &one, where);
    REQUIRE(status == CAGD_OK, status);
    int straight = !cagd_fit_is_minimum(one) || cagd_fit_conic_of(one).kind == CAGD_FIT_STRAIGHT;
    status = compete(data, options, "a conic in one segment", one, result, found);
    if (status == CAGD_OK && options->free & CAGD_FIT_END_POINTS) {
        cagd_fit_options chord = *options;
        cagd_fit_result *line = NULL;
        chord.degree = 1;
        status = fit_plainly(data, &chord, &line, where);
        if (status == CAGD_OK && !straight)
            status = line_does(data, options, line, &found->candidate[0], &straight);
        if (status == CAGD_OK && straight)
            status = compete(data, options, "a straight line", line, result, found);
        else
            cagd_fit_free(line);
    }
    return status;
}

static cagd_status try_ellipse(const cagd_fit_data *data, const cagd_fit_options *options, int beside,
                               cagd_fit_result **result, cagd_fit_found *found)
{
    int counts = 1;
    cagd_fit_result *one = NULL;
    const int free_ends =
        options->closed || (options->free & CAGD_FIT_END_POINTS && options->ends == CAGD_FIT_ENDS_MEASURED);
    REQUIRE(free_ends && !options->monotone && data->count * (data->dim - 1) > 3 * data->dim, CAGD_OK);
    cagd_status status = fit_ellipse_result(data, options, &one);
    if (status == CAGD_OK && beside)
        status = one != NULL ? counts_beside(data, options, one, *result, found, &counts) : CAGD_TOO_FEW;
    if (status != CAGD_OK || !counts) {
        cagd_fit_free(one);
        return status == CAGD_TOO_FEW ? CAGD_OK : status;
    }
    return compete(data, options, one == NULL || one->found.ellipse.whole ? "a whole ellipse" : "an arc of an ellipse",
                   one, result, found);
}

/* A cubic spline; `beside` a curve that does, if it counts.  One that is good with a smoothing term alone is not sought where a curve stands that nothing is said against. */
static cagd_status try_spline(const cagd_fit_data *data, const cagd_fit_options *options,
                              const cagd_fit_choices *choices, int beside, cagd_fit_result **result,
                              cagd_fit_found *found, int *where)
{
    cagd_fit_options spline = *options;
    cagd_fit_choices own = *choices;
    cagd_fit_result *one = NULL;
    int counts = 1;
    char name[64];
    spline.degree = 3;
    spline.free &= ~CAGD_FIT_WEIGHTS;
    if (own.smooth == 2 && *result != NULL && (beside || against(&found->candidate[0]) == 0))
        own.smooth = 0;
    cagd_status status = fit_refined(data, &spline, &own, &one, where);
    if (status == CAGD_OK && choices->weights)
        status = fit_test_weights(data, &spline, choices->within, &one, where);
    if (status == CAGD_OK && beside)
        status = counts_beside(data, &spline, one, *result, found, &counts);
    if (status != CAGD_OK || !counts) {
        cagd_fit_free(one);
        return *result != NULL && status != CAGD_NO_MEMORY ? CAGD_OK : status;
    }
    snprintf(name, sizeof name, "a cubic spline with %d control points", own_count(one));
    return compete(data, &spline, name, one, result, found);
}

/* The best curve does.  Others are tried beside it where it leaves a gap, which may be its own, and of few points, whose distances say little. */
static cagd_status look_beside(const cagd_fit_data *data, const cagd_fit_options *options,
                               const cagd_fit_choices *choices, cagd_fit_result **result, cagd_fit_found *found,
                               int *where)
{
    const int gap = (against(&found->candidate[0]) & CAGD_FIT_GAPS) != 0, conic = !(*result)->found.ellipse.known;
    cagd_status status = CAGD_OK;
    REQUIRE(options->loss == CAGD_FIT_SQUARES && !(*result)->points_on_curve && (gap || data->count < FEW), CAGD_OK);
    if (gap && conic)
        status = try_ellipse(data, options, 1, result, found);
    return status == CAGD_OK ? try_spline(data, options, choices, 1, result, found, where) : status;
}

/* A conic in one segment, an ellipse, a cubic spline, in this order, until one does. */
static cagd_status choose_form(const cagd_fit_data *data, const cagd_fit_options *options,
                               const cagd_fit_choices *choices, cagd_fit_result **result, cagd_fit_found *found,
                               int *where)
{
    cagd_status status = CAGD_OK;
    if (!options->closed) {
        status = try_conic(data, options, result, found, where);
        REQUIRE(status == CAGD_OK, status);
        if (is_enough(data, found, *result))
            return look_beside(data, options, choices, result, found, where);
    }
    if (options->loss != CAGD_FIT_SQUARES) { /* scores of different scales do not compare */
        cagd_fit_options spline = *options;
        spline.degree = 3;
        return *result != NULL ? CAGD_OK : fit_refined(data, &spline, choices, result, where);
    }
    status = try_ellipse(data, options, 0, result, found);
    REQUIRE(status == CAGD_OK, status);
    if (*result != NULL && (*result)->found.ellipse.known && is_enough(data, found, *result))
        return look_beside(data, options, choices, result, found, where);
    return try_spline(data, options, choices, 0, result, found, where);
}

/* What `found` holds of the choice becomes that of the result. */
static void keep_found(cagd_fit_result *result, const cagd_fit_found *found)
{
    cagd_fit_found own = result->found;
    own.chosen = 1;
    own.closing = found->closing;
    own.candidates = found->candidates;
    for (int k = 0; k < found->candidates; k++)
        own.candidate[k] = found->candidate[k];
    result->found = own;
}

/* What a choice needs beside the points. */
typedef struct wishes {
    const cagd_fit_options *options;
    const cagd_fit_choices *choices;
} wishes;

static cagd_status choose_plainly(const cagd_fit_data *data, const void *how, cagd_fit_result **result, int *where)
{
    const cagd_fit_options *options = ((const wishes *)how)->options;
    const cagd_fit_choices *choices = ((const wishes *)how)->choices;
    *result = NULL;
    cagd_status status = fit_check_options(options);
    if (status == CAGD_OK)
        status = fit_check_data(data, options->free == 0, where);
    REQUIRE(status == CAGD_OK, status);
    cagd_fit_found found = {0};
    cagd_fit_data own = *data;
    cagd_fit_options asked = *options;
    const int nothing_free = options->free == 0;
    if (!nothing_free && choices->closed != 0 && options->initial == NULL)
        found.closing = cagd_fit_closing_of(data, options->unordered);
    if (choices->closed == 1 ||
        (choices->closed < 0 && (found.closing == CAGD_FIT_REPEATED || found.closing == CAGD_FIT_AROUND)))
        asked.closed = 1;
    own.count -= asked.closed && fit_repeats_first(data);
    if (nothing_free || asked.initial != NULL)
        status = fit_plainly(data, options, result, where);
    else if (choices->degree) {
        cagd_fit_choices all = *choices;
        if (asked.closed && asked.count == 0)
            all.count = 1;
        if (asked.knots != NULL)
            return CAGD_BAD_OPTION;
        status = choose_degree(&own, &asked, &all, result, &found, where);
    } else if (choices->form)
        status = choose_form(&own, &asked, choices, result, &found, where);
    else {
        cagd_fit_choices all = *choices;
        if (asked.closed && asked.count == 0 && asked.knots == NULL) {
            all.count = 1;
            asked.free &= ~CAGD_FIT_WEIGHTS;
        }
        status = fit_refined(&own, &asked, &all, result, where);
        if (status == CAGD_OK && choices->weights && !(asked.free & CAGD_FIT_WEIGHTS))
            status = fit_test_weights(&own, &asked, choices->within, result, where);
    }
    if (status == CAGD_OK)
        keep_found(*result, &found);
    else {
        cagd_fit_free(*result);
        *result = NULL;
    }
    return status;
}

cagd_status cagd_fit_choose(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_choices *choices,
                            cagd_fit_result **result, int *where)
{
    int ignored;
    REQUIRE(result != NULL, CAGD_NULL);
    *result = NULL;
    where = where != NULL ? where : &ignored;
    *where = -1;
    REQUIRE(data != NULL && options != NULL && choices != NULL && data->points != NULL, CAGD_NULL);
    REQUIRE(isfinite(choices->within) && choices->within >= 0, CAGD_BAD_OPTION);
    const wishes how = {options, choices};
    return fit_without_end_outliers(data, options, choose_plainly, &how, result, where);
}
