/* fit.c -- a fit from its arguments to its result, in five stages.
 *
 *     problem        fit_problem       points, curve and unknowns in working coordinates: problem.h, unknowns.h
 *     reduction      fit_objective     the cost as a function of the curve alone: objective.h, feet.h, reduction.h
 *     minimiser      fit_attempt       from one start to where it ends: starts.h, approach.h, descend.h
 *     verification   fit_minimum       which ends are minima, and the lowest of them: judge.c, minimum.h
 *     statistics     cagd_fit_result   in the coordinates of the data, with errors: result.h, statistics.h */
#include "core/fit/cagd_fit.h"

#include "core/fit/arguments.h"
#include "core/fit/minimum.h"
#include "core/fit/result.h"
#include "core/fit/statistics.h"

#include <math.h>
#include <stddef.h>

cagd_fit_options cagd_fit_defaults(void)
{
    return (cagd_fit_options){.degree = 2,
                              .free = CAGD_FIT_WEIGHTS | CAGD_FIT_INNER_POINTS,
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
    fit_minimum_free(&minimum);
    if (result != NULL)
        fit_statistics(data, p->options, result);
    return result;
}

/* The arguments, whose pointers are not NULL, are checked before anything is made of them. */
static cagd_status check(const cagd_fit_data *data, const cagd_fit_options *options, int *where)
{
    cagd_status status = fit_check_options(options);
    return status == CAGD_OK ? fit_check_data(data, options->free == 0, where) : status;
}

cagd_status fit_with_strategy(const cagd_fit_data *data, const cagd_fit_options *options, const fit_strategy *strategy,
                              cagd_fit_result **result, int *where)
{
    int ignored;
    fit_problem p;
    REQUIRE(result != NULL, CAGD_NULL);
    *result = NULL;
    where = where != NULL ? where : &ignored;
    *where = -1;
    REQUIRE(data != NULL && options != NULL && data->points != NULL, CAGD_NULL);
    cagd_status status = check(data, options, where);
    REQUIRE(status == CAGD_OK, status);
    status = fit_problem_make(data, options, strategy, &p, where);
    if (status == CAGD_OK && fit_problem_equations(&p) < p.unknowns)
        status = CAGD_TOO_FEW;
    if (status == CAGD_OK && (*result = solve(data, &p)) == NULL)
        status = CAGD_NO_MEMORY;
    fit_problem_free(&p);
    return status;
}

cagd_status cagd_fit(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result **result, int *where)
{
    return fit_with_strategy(data, options, &fit_usual_strategy, result, where);
}
