#include "core/fit/approach.h"

#include "core/fit/descend.h"
#include "core/fit/sample.h"

#include <stdlib.h>
#include <string.h>

/* The cost of the first curve for all points is told, and is that of its feet as exact as can be.  Returns 0 when there is no
 * memory. */
static int tell_initial_cost(fit_attempt *a)
{
    if (!fit_feet_guess(a->problem, a->curve, a->feet))
        return 0;
    a->objective->limit = FOOT_EXACT;
    a->initial_cost = fit_objective_cost(a->objective, a->curve, a->feet);
    return 1;
}

/* With all points. */
static int approach_by_all(fit_attempt *a)
{
    if (!fit_descend_near(a))
        return 0;
    memcpy(a->feet, a->objective->feet, (size_t)a->problem->points * sizeof *a->feet);
    fit_curve_copy(a->curve, a->objective->curve);
    return 1;
}

/* With a sample: the curve of the attempt becomes what is reached.  feet: those of the sample, or NULL. */
static int approach_by(const fit_problem *sample, const double feet[], fit_attempt *a)
{
    fit_attempt b;
    int good = fit_attempt_new(sample, &b);
    if (good) {
        fit_curve_copy(b.curve, a->curve);
        if (feet != NULL)
            memcpy(b.feet, feet, (size_t)sample->points * sizeof *feet);
        good = (feet != NULL || fit_feet_guess(sample, b.curve, b.feet)) && fit_descend_near(&b);
    }
    if (good) {
        fit_curve_copy(a->curve, b.objective->curve);
        good = fit_attempt_append(a, &b.outcome);
    }
    fit_attempt_free(&b);
    return good;
}

static int approach_by_every(int stride, fit_attempt *a)
{
    fit_problem sample;
    int good = fit_sample_every(a->problem, stride, &sample);
    if (good) {
        good = approach_by(&sample, NULL, a);
        fit_sample_free(&sample);
    }
    return good;
}

static int approach_by_means(int groups, fit_attempt *a)
{
    fit_problem sample;
    double *feet = malloc(((size_t)groups + 2) * sizeof *feet);
    int good = feet != NULL && fit_sample_means(a->problem, a->curve, a->feet, groups, &sample, feet);
    if (good) {
        good = fit_problem_equations(&sample) < sample.unknowns || approach_by(&sample, feet, a);
        fit_sample_free(&sample);
    }
    free(feet);
    return good;
}

int fit_approach(fit_attempt *a)
{
    const fit_problem *p = a->problem;
    int squares = p->loss == CAGD_FIT_SQUARES, points = p->strategy.points_per_unknown * p->unknowns;
    int means = p->strategy.means_factor * points;
    if (!tell_initial_cost(a))
        return 0;
    if (p->points < 2 * means)
        return approach_by_all(a);
    return approach_by_every(p->points / (squares ? points : means), a) && fit_feet_guess(p, a->curve, a->feet) &&
           (!squares || approach_by_means(means, a));
}
