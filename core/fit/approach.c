#include "core/fit/approach.h"

#include "core/fit/descend.h"
#include "core/fit/few.h"

#include <stdlib.h>
#include <string.h>

/* How near each of the two comes, of the size of the residuals.  No part of a result, whose last stage ends by `tolerance`. */
#define ROUGHLY  1e-2
#define AVERAGED 1e-4

/* From the curve of the attempt, which becomes what is reached, and its feet, with other points. */
static int approach_with(const fit_problem *few, const cagd_fit_options *o, double tolerance, const double feet[],
                         fit_attempt *a)
{
    fit_attempt rough;
    double cost;
    int good = fit_attempt_new(few, &rough);
    if (good) {
        fit_curve_copy(rough.curve, a->curve);
        if (feet != NULL)
            memcpy(rough.feet, feet, (size_t)few->points * sizeof *feet);
        good = (feet != NULL || fit_feet_search(few, rough.curve, rough.feet, &cost)) &&
               fit_descend_near(few, o, tolerance, &rough);
    }
    if (good) {
        fit_curve_copy(a->curve, rough.objective->curve);
        good = fit_attempt_append(a, &rough.outcome);
    }
    fit_attempt_free(&rough);
    return good;
}

int fit_approach(const fit_problem *p, const cagd_fit_options *o, fit_attempt *a)
{
    fit_problem few;
    int enough = FIT_ENOUGH * p->unknowns, groups = FIT_TIMES * enough;
    double cost, *feet;
    if (p->points < 2 * groups)
        return fit_feet_search(p, a->curve, a->feet, &cost);
    if (!fit_few_thinned(p, p->points / (p->loss == CAGD_FIT_SQUARES ? enough : groups), &few))
        return 0;
    int good = approach_with(&few, o, ROUGHLY, NULL, a);
    fit_few_free(&few);
    good = good && fit_feet_search(p, a->curve, a->feet, &cost);
    if (!good || p->loss != CAGD_FIT_SQUARES)
        return good;
    feet = malloc((size_t)groups * sizeof *feet);
    good = feet != NULL && fit_few_means(p, a->curve, a->feet, groups, &few, feet);
    if (good) {
        good = fit_problem_equations(&few) < p->unknowns || approach_with(&few, o, AVERAGED, feet, a);
        fit_few_free(&few);
    }
    free(feet);
    return good;
}
