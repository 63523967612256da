#include "core/fit/minimum.h"

#include "core/fit/approach.h"
#include "core/fit/descend.h"
#include "core/fit/starts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Nothing is free: the feet on the given curve, and the cost. */
static int find_feet(fit_attempt *a)
{
    double cost;
    int good = fit_feet_search(a->problem, a->curve, a->feet, &cost);
    if (good)
        fit_objective_begin(a->objective, a->curve, a->feet);
    a->initial_cost = a->objective->cost;
    strcpy(a->outcome.message, "Nothing is free: the feet of the points on the given curve.");
    return good;
}

/* The attempt from start number `start`.  Returns 0 when there is no memory. */
static int try_start(int start, fit_attempt *a)
{
    if (!fit_start(a->problem, start, a->curve))
        return 0;
    if (!(a->problem->nothing_free ? find_feet(a) : fit_approach(a) && fit_descend(a)))
        return 0;
    fit_objective_by_theta(a->objective);
    fit_attempt_judge(a);
    return 1;
}

/* Whether attempt a has ended better than b: b alone has failed, or the cost of a is lower by more than rounding. */
static int is_better(const fit_attempt *a, const fit_attempt *b)
{
    int a_failed = a->outcome.termination == CAGD_FIT_FAILED, b_failed = b->outcome.termination == CAGD_FIT_FAILED;
    double cost = b->objective->cost;
    return a_failed == b_failed ? a->objective->cost < cost - fit_problem_cost_error(a->problem, cost) : b_failed;
}

/* Whether the attempt from this start takes the place of the best one.  Starts beyond those asked for only do when
 * they come to a minimum. */
static int replaces(const fit_attempt *a, int start, const fit_minimum *m)
{
    int asked = start < a->problem->options->starts;
    return start == 0 || (is_better(a, &m->attempt) && (asked || a->outcome.termination == CAGD_FIT_CONVERGED));
}

/* How many of the costs are that of the minimum, which the minimiser knows to its tolerance. */
static int count_agreeing(const fit_minimum *m, int starts, const double costs[])
{
    const fit_problem *p = m->attempt.problem;
    double cost = m->attempt.objective->cost,
           error = sqrt(p->options->tolerance) * cost + fit_problem_cost_error(p, cost);
    int agreeing = 0;
    for (int start = 0; start < starts; start++)
        agreeing += costs[start] - cost <= error;
    return agreeing;
}

/* The starts that may be made. */
static int most_starts(const fit_problem *p)
{
    int extra = p->options->free & CAGD_FIT_WEIGHTS ? p->strategy.extra_starts : 0;
    return p->nothing_free ? 1 : p->options->starts + extra;
}

int fit_minimum_of(const fit_problem *p, fit_minimum *m)
{
    int most = most_starts(p), start = 0, good = 1;
    double *costs = malloc((size_t)most * sizeof *costs);
    *m = (fit_minimum){0};
    for (; costs && good && start < most; start++) {
        if (start >= p->options->starts && m->attempt.outcome.termination == CAGD_FIT_CONVERGED)
            break;
        fit_attempt a;
        good = fit_attempt_new(p, &a) && try_start(start, &a);
        if (good)
            costs[start] = a.objective->cost;
        if (good && replaces(&a, start, m)) {
            fit_attempt worse = m->attempt;
            m->attempt = a;
            m->start = start;
            a = worse;
        }
        fit_attempt_free(&a);
        if (p->options->after_start != NULL)
            p->options->after_start(p->options->context, start + 1, p->options->starts);
    }
    good = good && costs;
    if (good)
        m->agreeing_starts = count_agreeing(m, start, costs);
    free(costs);
    return good;
}

void fit_minimum_free(fit_minimum *m) { fit_attempt_free(&m->attempt); }
