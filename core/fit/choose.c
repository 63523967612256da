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

static const double BY_CHANCE = 0.01; /* residuals that are less probable than that are no noise                    */
static const double SMALL = 0.02;     /* of the width of the points: where distances are larger, others have a chance */

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

/* Whether a conic in one segment, or an ellipse, does for the points.  One whose middle point is far away, an arc of nearly a half
 * turn, is better told by centre and axes. */
static cagd_status find_enough(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *r,
                               int *enough)
{
    cagd_fit_runs runs;
    cagd_fit_quality quality;
    *enough = 0;
    REQUIRE(fit_is_good(data, options, r), CAGD_OK);
    cagd_status status = cagd_fit_quality_of(data, options, r, &quality);
    REQUIRE(status == CAGD_OK, status);
    REQUIRE(!(quality.problems & CAGD_FIT_FAR), CAGD_OK);
    *enough = r->points_on_curve != 0;
    REQUIRE(!*enough && !(r->rms > extent_of(data) * SMALL), CAGD_OK);
    status = cagd_fit_runs_of(r, &runs);
    *enough = status == CAGD_OK && !(runs.probability < BY_CHANCE);
    return status;
}

/* How many points of the curve are its own. */
static int own_count(const cagd_fit_result *r) { return r->period > 0 ? r->period : r->curve.count; }

/* The candidate takes the place of the best one if its score is lower; it is released otherwise.  within > 0: its score is the number
 * of its control points if it keeps within that distance. */
static void compete_within(const cagd_fit_data *data, const cagd_fit_options *options, double within, const char *name,
                           cagd_fit_result *one, cagd_fit_result **best, cagd_fit_found *found)
{
    int good = one != NULL && fit_is_good(data, options, one);
    if (one == NULL)
        return;
    good = good && (within == 0 || one->largest <= within);
    double score = !good ? INFINITY : within > 0 ? own_count(one) : fit_score(data, one);
    int first = *best == NULL || score < found->candidate[0].score, at = found->candidates;
    if (*best != NULL && isinf(score) && isinf(found->candidate[0].score)) { /* too few points for scores */
        const int best_is_good = fit_is_good(data, options, *best);
        first = good > best_is_good || (good == best_is_good && one->rms < (*best)->rms);
    }
    if (at < CAGD_FIT_MAX_CANDIDATES) {
        found->candidates++;
        at = first ? 0 : at;
        if (first)
            for (int k = found->candidates - 1; k > 0; k--)
                found->candidate[k] = found->candidate[k - 1];
        cagd_fit_candidate *c = &found->candidate[at];
        *c = (cagd_fit_candidate){"", (int)lrint(one->effective), cagd_fit_is_minimum(one), score, one->rms};
        snprintf(c->name, sizeof c->name, "%s", name);
    }
    if (first) {
        cagd_fit_free(*best);
        *best = one;
    } else
        cagd_fit_free(one);
}

static void compete(const cagd_fit_data *data, const cagd_fit_options *options, const char *name, cagd_fit_result *one,
                    cagd_fit_result **best, cagd_fit_found *found)
{
    compete_within(data, options, 0, name, one, best, found);
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
        if (own.count > 0 && own.count < p + 1 + own.closed)
            break;
        cagd_status status = fit_refined(data, &own, choices, &one, where);
        if (status == CAGD_OK && choices->weights && !(own.free & CAGD_FIT_WEIGHTS))
            status = fit_test_weights(data, &own, choices->within, &one, where);
        if (status == CAGD_TOO_FEW && *result != NULL)
            break;
        REQUIRE(status == CAGD_OK, status);
        snprintf(name, sizeof name, "degree %d with %d control points", p, own_count(one));
        compete_within(data, &own, choices->within, name, one, result, found);
    }
    return *result != NULL ? CAGD_OK : CAGD_BAD_OPTION;
}

/* A conic in one segment, an ellipse, a cubic spline, in this order, until one does. */
static cagd_status choose_form(const cagd_fit_data *data, const cagd_fit_options *options,
                               const cagd_fit_choices *choices, cagd_fit_result **result, cagd_fit_found *found,
                               int *where)
{
    cagd_fit_result *one = NULL;
    cagd_fit_options spline = *options;
    cagd_status status = CAGD_OK;
    int enough = 0;
    if (!options->closed) {
        status = fit_plainly(data, options, &one, where);
        REQUIRE(status == CAGD_OK, status);
        const int straight = !cagd_fit_is_minimum(one) || cagd_fit_conic_of(one).kind == CAGD_FIT_STRAIGHT;
        compete(data, options, "a conic in one segment", one, result, found);
        if (straight && options->free & CAGD_FIT_END_POINTS) {
            cagd_fit_options chord = *options;
            chord.degree = 1;
            status = fit_plainly(data, &chord, &one, where);
            REQUIRE(status == CAGD_OK, status);
            compete(data, options, "a straight line", one, result, found);
        }
        if (*result != NULL)
            status = find_enough(data, options, *result, &enough);
        REQUIRE(status == CAGD_OK && !enough, status);
    }
    if (options->loss != CAGD_FIT_SQUARES) { /* scores of different scales do not compare */
        if (*result != NULL)
            return CAGD_OK;
        spline.degree = 3;
        return fit_refined(data, &spline, choices, result, where);
    }
    const int free_ends =
        options->closed || (options->free & CAGD_FIT_END_POINTS && options->ends == CAGD_FIT_ENDS_MEASURED);
    if (free_ends && !options->monotone && data->count * (data->dim - 1) > 3 * data->dim) {
        status = fit_ellipse_result(data, options, &one);
        REQUIRE(status == CAGD_OK, status);
        compete(data, options, one == NULL || one->found.ellipse.whole ? "a whole ellipse" : "an arc of an ellipse",
                one, result, found);
        if (*result != NULL && (*result)->found.ellipse.known)
            status = find_enough(data, options, *result, &enough);
        REQUIRE(status == CAGD_OK && !enough, status);
    }
    spline.degree = 3;
    spline.free &= ~CAGD_FIT_WEIGHTS;
    one = NULL;
    status = fit_refined(data, &spline, choices, &one, where);
    if (status == CAGD_OK && choices->weights)
        status = fit_test_weights(data, &spline, choices->within, &one, where);
    REQUIRE(status == CAGD_OK || (*result != NULL && status != CAGD_NO_MEMORY), status);
    if (status == CAGD_OK) {
        char name[64];
        snprintf(name, sizeof name, "a cubic spline with %d control points", own_count(one));
        compete(data, &spline, name, one, result, found);
    }
    return CAGD_OK;
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
        if (status != CAGD_OK) {
            cagd_fit_free(*result);
            *result = NULL;
        }
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
