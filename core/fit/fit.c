/* fit.c -- a fit from its arguments to its result, in five stages.
 *
 *     problem        fit_problem       points, curve and unknowns in working coordinates: problem.h, unknowns.h
 *     reduction      fit_objective     the cost as a function of the curve alone: objective.h, feet.h, reduction.h
 *     minimiser      fit_attempt       from one start to where it ends: starts.h, approach.h, descend.h
 *     verification   fit_minimum       which ends are minima, and the lowest of them: judge.c, minimum.h
 *     statistics     cagd_fit_result   in the coordinates of the data, with errors: result.h, statistics.h, profile.h */
#include "core/fit/cagd_fit.h"

#include "core/fit/arguments.h"
#include "core/fit/end_outliers.h"
#include "core/fit/fit.h"
#include "core/fit/minimum.h"
#include "core/fit/monotone.h"
#include "core/fit/outliers.h"
#include "core/fit/profile.h"
#include "core/fit/result.h"
#include "core/fit/statistics.h"

#include <math.h>
#include <stddef.h>

cagd_fit_options cagd_fit_defaults(void)
{
    return (cagd_fit_options){.degree = 2,
                              .free = CAGD_FIT_WEIGHTS | CAGD_FIT_INNER_POINTS | CAGD_FIT_END_POINTS,
                              .ends = CAGD_FIT_ENDS_MEASURED,
                              .loss = CAGD_FIT_SQUARES,
                              .loss_scale = 1,
                              .weight_low = 0,
                              .weight_high = INFINITY,
                              .starts = 1,
                              .seed = 1,
                              .tolerance = 1e-14,
                              .max_iterations = 200};
}

/* The stages after the problem; NULL when there is no memory. */
static cagd_fit_result *solve(const cagd_fit_data *data, const fit_problem *p)
{
    fit_minimum minimum;
    cagd_fit_result *result = NULL;
    if (fit_minimum_of(p, &minimum))
        result = fit_result_make(data, p, &minimum);
    if (result != NULL) {
        fit_statistics(data, p->options, result);
        result->loss_scale = p->options->loss_scale;
        if ((p->strategy.intervals && !fit_profile(p, &minimum, result)) || !fit_outliers(data, p->options, result)) {
            cagd_fit_free(result);
            result = NULL;
        }
    }
    fit_minimum_free(&minimum);
    return result;
}

/* The arguments, whose pointers are not NULL, are checked before anything is made of them. */
static cagd_status check(const cagd_fit_data *data, const cagd_fit_options *options, int *where)
{
    cagd_status status = fit_check_options(options);
    return status == CAGD_OK ? fit_check_data(data, options->free == 0, where) : status;
}

/* The stages of one fit; ends[]: the points that the curve begins and ends in, where its ends are measured and the points
 * have no order, otherwise NULL. */
static cagd_status fit_once(const cagd_fit_data *data, const cagd_fit_options *options, const fit_strategy *strategy,
                            const int ends[], cagd_fit_result **result, int *where)
{
    fit_problem p;
    cagd_status status = fit_problem_make(data, options, strategy, &p, where);
    for (int end = 0; end < 2 && ends != NULL; end++)
        p.end_point[end] = ends[end];
    if (status == CAGD_OK && !(p.smooth > 0) && fit_problem_equations(&p) < p.unknowns)
        status = CAGD_TOO_FEW;
    if (status == CAGD_OK && (*result = solve(data, &p)) == NULL)
        status = CAGD_NO_MEMORY;
    fit_problem_free(&p);
    return status;
}

/* Of points in any order those that measure the ends of the curve are not known.  Where no initial curve says which they
 * are, a first fit has two of the points as exact ends, and the second one begins with its curve.  A straight line, whose points are its
 * ends, slides in the first fit. */
static cagd_status fit_in_any_order(const cagd_fit_data *data, const cagd_fit_options *options,
                                    const fit_strategy *strategy, cagd_fit_result **result, int *where)
{
    static const double zero[3] = {0};
    cagd_fit_options exact = *options, measured = *options;
    cagd_fit_result *first = NULL;
    cagd_spline curve;
    int ends[2];
    if (options->degree > 1)
        exact.free &= ~CAGD_FIT_END_POINTS;
    else
        exact.ends = CAGD_FIT_ENDS_SLIDE;
    if (options->initial == NULL) {
        cagd_status status = exact.free == 0 ? CAGD_BAD_OPTION : fit_once(data, &exact, strategy, NULL, &first, where);
        REQUIRE(status == CAGD_OK, status);
        curve = first->curve;
        measured.initial = &curve;
    }
    const double *origin = first != NULL ? first->origin : zero,
                 *points = first != NULL ? first->relative : options->initial->points;
    for (int end = 0; end < 2 && points != NULL; end++)
        ends[end] = fit_nearest_measured(data, origin, points + end * (measured.initial->count - 1) * data->dim);
    int known = points != NULL && ends[0] != ends[1];
    if (!known)
        measured.ends = CAGD_FIT_ENDS_SLIDE;
    cagd_status status = fit_once(data, &measured, strategy, known ? ends : NULL, result, where);
    cagd_fit_free(first);
    return status;
}

static cagd_status fit_with_scale(const cagd_fit_data *data, const cagd_fit_options *options,
                                  const fit_strategy *strategy, cagd_fit_result **result, int *where)
{
    const int measured =
        !options->closed && options->free & CAGD_FIT_END_POINTS && options->ends == CAGD_FIT_ENDS_MEASURED;
    return measured && options->unordered && options->free & CAGD_FIT_INNER_POINTS
               ? fit_in_any_order(data, options, strategy, result, where)
               : fit_once(data, options, strategy, NULL, result, where);
}

/* The scale of a robust loss and the curve in turn: the first curve is that of least squares, every other one has the scale that the
 * median of the distances of the one before says, until that changes by less than a hundredth.  Where the median is 0 the last
 * scale stays. */
static cagd_status fit_and_scale(const cagd_fit_data *data, const cagd_fit_options *options,
                                 const fit_strategy *strategy, cagd_fit_result **result, int *where)
{
    enum { ROUNDS = 20 };
    cagd_fit_options next = *options;
    next.loss = CAGD_FIT_SQUARES;
    next.loss_scale = 1;
    cagd_status status = fit_with_scale(data, &next, strategy, result, where);
    for (int round = 0; status == CAGD_OK && round < ROUNDS; round++) {
        double deviation = fit_robust_deviation(data, *result), scale = fit_loss_scale_of(options->loss, deviation);
        int settled = round > 0 && fabs(scale - next.loss_scale) <= next.loss_scale / 100;
        REQUIRE(!isnan(deviation), (cagd_fit_free(*result), *result = NULL, CAGD_NO_MEMORY));
        if (settled || (!(scale > 0) && round > 0))
            break;
        next.loss = options->loss;
        next.loss_scale = scale > 0 ? scale : (*result)->rms > 0 ? (*result)->rms : 1;
        cagd_fit_free(*result);
        *result = NULL;
        status = fit_with_scale(data, &next, strategy, result, where);
    }
    return status;
}

cagd_status fit_with_strategy(const cagd_fit_data *data, const cagd_fit_options *options, const fit_strategy *strategy,
                              cagd_fit_result **result, int *where)
{
    int ignored;
    REQUIRE(result != NULL, CAGD_NULL);
    *result = NULL;
    where = where != NULL ? where : &ignored;
    *where = -1;
    REQUIRE(data != NULL && options != NULL && data->points != NULL, CAGD_NULL);
    cagd_status status = check(data, options, where);
    REQUIRE(status == CAGD_OK, status);
    if (options->monotone)
        return fit_monotone(data, options, strategy, fit_with_scale, result, where);
    return options->loss != CAGD_FIT_SQUARES && options->loss_scale == 0
               ? fit_and_scale(data, options, strategy, result, where)
               : fit_with_scale(data, options, strategy, result, where);
}

cagd_status fit_plainly(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result **result,
                        int *where)
{
    return fit_with_strategy(data, options, &fit_usual_strategy, result, where);
}

static cagd_status fit_by_options(const cagd_fit_data *data, const void *options, cagd_fit_result **result, int *where)
{
    return fit_plainly(data, options, result, where);
}

cagd_status cagd_fit(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result **result, int *where)
{
    return fit_without_end_outliers(data, options, fit_by_options, options, result, where);
}
