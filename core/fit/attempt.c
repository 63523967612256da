#include "core/fit/attempt.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int fit_attempt_new(const fit_problem *p, fit_attempt *a)
{
    *a = (fit_attempt){.problem = p, .max_iterations = p->options->max_iterations};
    a->radius = 1e4; /* that of Ceres by default */
    a->curve = fit_curve_new(p->degree, p->count, p->period, p->dim, p->knots);
    a->feet = malloc((size_t)p->points * sizeof *a->feet);
    a->objective = fit_objective_new(p);
    return a->curve && a->feet && a->objective;
}

void fit_attempt_free(fit_attempt *a)
{
    fit_curve_free(a->curve);
    free(a->feet);
    fit_objective_free(a->objective);
    free(a->outcome.history);
}

/* Makes room for so many further steps. */
static int lengthen(fit_outcome *all, int steps)
{
    cagd_fit_step *longer = realloc(all->history, (size_t)(all->steps + steps + 1) * sizeof *longer);
    if (longer != NULL)
        all->history = longer;
    return longer != NULL;
}

int fit_attempt_append(fit_attempt *a, fit_outcome *run)
{
    fit_outcome *all = &a->outcome;
    int good = lengthen(all, run->steps);
    for (int i = 0; good && i < run->steps; i++) {
        all->history[all->steps + i] = run->history[i];
        all->history[all->steps + i].iteration += all->iterations;
    }
    free(run->history);
    run->history = NULL;
    if (!good)
        return 0;
    all->steps += run->steps;
    all->iterations += run->iterations;
    all->termination = run->termination;
    memcpy(all->message, run->message, sizeof all->message);
    return 1;
}

int fit_attempt_step(fit_attempt *a, int accepted, double length)
{
    const fit_objective *f = a->objective;
    fit_outcome *all = &a->outcome;
    double largest = 0;
    if (!lengthen(all, 1))
        return 0;
    for (int k = 0; k < f->problem->unknowns; k++)
        largest = fmax(largest, fabs(fit_objective_gradient(f, k)));
    all->history[all->steps++] = (cagd_fit_step){++all->iterations, accepted, f->cost, largest, length, INFINITY};
    return 1;
}
