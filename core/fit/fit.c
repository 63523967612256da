#include "core/fit/cagd_fit.h"

#include "core/fit/approach.h"
#include "core/fit/arguments.h"
#include "core/fit/descend.h"
#include "core/fit/result.h"
#include "core/fit/starts.h"
#include "core/fit/statistics.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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

/* What was measured of the numbers that begin a fit.  240 random conics, cubics, quartics and splines of 3 segments, weights between 1/4 and
 * 4, with 60 to 80 points without noise each: so many are found again, two or three more or less being chance.
 *
 *     rounds   0, 2, 4, 8, 16           213, 214, 218, 221, 221    fewer leave points that no weights mend, more only take time
 *     spread   4, 8, 16, 64, 256        223, 224, 221, 220, 216    the tries are thirteen: spread wider, few are near any weights
 *     groups   16, 32, 64, 128, 1000    220, 222, 221, 220, 220    without scatter it is all one
 *     more     0, 4, 8                  221, 221, 221              some start always comes to a minimum
 *
 * 24 conics with 40 points that scatter by 0.3, as much as they bend, and 24 cubics with 60 that scatter by 0.05: so many of both come to the lowest
 * minimum that any of these ways has found.
 *
 *     groups   8, 16, 64, 1000          7 + 10, 5 + 10, 8 + 12, 8 + 12    fewer means cut corners
 *     more     0, 2, 4, 8, 16           3 + 10, 4 + 11, 6 + 12, 8 + 12, 8 + 12    in 1, 2.5, 3.5, 5 and 5 times the time
 *
 * A conic and a cubic with 200, 2 000 and 20 000 points that scatter by 0.002: time over the usual time, everywhere for the same cost.
 *
 *     nearly   1e-2, 1e-3, 1e-5, 1e-6      0.94 to 1.04: it is all one, as Newton's steps lead to the end from all of them
 *     anchors, sides   16, 32, 128, 256    all one but for the noise of the measurement
 *     enough   5, 10, 40, 80               0.4 to 0.6, 0.6 to 1, 1 to 1.7, 0.5 to 6
 *     times    1, 2, 8, 16                 0.4 to 0.6, 0.6 to 1, 1 to 1.7, 1 to 2.9
 *     guesses  3, 6, 26, 52                0.4 to 0.6, 0.6 to 0.8, 1.4 to 1.8, 2 to 6
 *
 * These are easy; what fewer points, means and guesses lose where it is difficult has not been measured, so they stay.
 *
 * All trade time for the chance of the lowest of several minima; what a minimum is does not depend on them. */
const fit_strategy fit_usual_strategy = {.nearly = 1e-4,
                                         .rough = 0x1p-6,
                                         .enough = 20,
                                         .times = 4,
                                         .anchors = 64,
                                         .sides = 64,
                                         .guesses = 13,
                                         .steps = 40,
                                         .spread = 16,
                                         .telling = 1e-3,
                                         .groups = 64,
                                         .rounds = 8,
                                         .more = 8};

/* Nothing is free: the feet on the given curve, and the cost. */
static int feet_alone(const fit_problem *p, fit_attempt *a)
{
    double cost;
    int good = fit_feet_search(p, a->curve, a->feet, &cost);
    if (good)
        fit_objective_begin(a->objective, a->curve, a->feet);
    a->initial_cost = a->objective->cost;
    strcpy(a->outcome.message, "Nothing is free: the feet of the points on the given curve.");
    return good;
}

/* The attempt from start number `start`. */
static int try_start(const fit_problem *p, const cagd_fit_options *o, int start, fit_attempt *a)
{
    int good = fit_start(p, o, start, a->curve);
    if (p->nothing_free)
        good = good && feet_alone(p, a);
    else
        good = good && fit_approach(p, o, a) && fit_descend(p, o, a);
    if (good) {
        fit_objective_by_theta(a->objective);
        fit_attempt_judge(p, o, a);
    }
    return good;
}

/* Whether the end of one start is better than that of another. */
static int better(const fit_problem *p, const fit_attempt *a, const fit_attempt *b)
{
    int a_failed = a->outcome.termination == CAGD_FIT_FAILED, b_failed = b->outcome.termination == CAGD_FIT_FAILED;
    double was = b->objective->cost;
    return a_failed == b_failed ? a->objective->cost < was - fit_problem_blur(p, was) : b_failed;
}

/* All starts, and as long as none has come to a minimum some more; the best stays. */
static cagd_status run(const cagd_fit_data *data, const cagd_fit_options *o, const fit_problem *p,
                       cagd_fit_result **result)
{
    fit_attempt best = {0};
    int best_start = 0, good = 1, starts = 0;
    int most = p->nothing_free ? 1 : o->starts + (o->free & CAGD_FIT_WEIGHTS ? p->strategy.more : 0);
    double *costs = malloc((size_t)most * sizeof *costs);
    for (int start = 0; costs && good && start < most; start++) {
        if (start >= o->starts && best.outcome.termination == CAGD_FIT_CONVERGED)
            break;
        fit_attempt a;
        good = fit_attempt_new(p, &a) && try_start(p, o, start, &a);
        if (good) {
            costs[starts++] = a.objective->cost;
            if (start == 0 ||
                (better(p, &a, &best) && (start < o->starts || a.outcome.termination == CAGD_FIT_CONVERGED))) {
                fit_attempt worse = best;
                best = a;
                a = worse;
                best_start = start;
            }
        }
        fit_attempt_free(&a);
    }
    if (costs && good)
        *result = fit_result_make(data, o, p, &best);
    if (*result != NULL) {
        double cost = (*result)->cost, blur = sqrt(o->tolerance) * cost + fit_problem_blur(p, cost);
        (*result)->best_start = best_start;
        for (int start = 0; start < starts; start++) /* the minimiser knows costs to its tolerance */
            (*result)->agreeing_starts += costs[start] - cost <= blur;
    }
    fit_attempt_free(&best);
    free(costs);
    return *result != NULL ? CAGD_OK : CAGD_NO_MEMORY;
}

cagd_status fit_with_strategy(const cagd_fit_data *data, const cagd_fit_options *options, const fit_strategy *strategy,
                              cagd_fit_result **result, int *where)
{
    int ignored;
    fit_problem p;
    REQUIRE(result != NULL, CAGD_NULL);
    *result = NULL;
    if (where == NULL)
        where = &ignored;
    *where = -1;
    REQUIRE(data != NULL && options != NULL && data->points != NULL, CAGD_NULL);
    cagd_status status = fit_check_options(options);
    if (status == CAGD_OK)
        status = fit_check_data(data, options->free == 0, where);
    if (status != CAGD_OK)
        return status;
    status = fit_problem_make(data, options, strategy, &p, where);
    if (status == CAGD_OK && fit_problem_equations(&p) < p.unknowns)
        status = CAGD_TOO_FEW;
    if (status == CAGD_OK)
        status = run(data, options, &p, result);
    if (status == CAGD_OK)
        fit_statistics(data, options, *result);
    fit_problem_free(&p);
    return status;
}

cagd_status cagd_fit(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result **result, int *where)
{
    return fit_with_strategy(data, options, &fit_usual_strategy, result, where);
}
