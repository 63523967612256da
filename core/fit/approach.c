#include "core/fit/approach.h"

#include "core/fit/descend.h"
#include "core/fit/few.h"

#include <stdlib.h>
#include <string.h>

/* From the curve of the attempt, which becomes what is reached, and its feet, with other points. */
static int approach_with(const fit_problem *few, const cagd_fit_options *o, const double feet[], fit_attempt *a)
{
    fit_attempt rough;
    int good = fit_attempt_new(few, &rough);
    if (good) {
        fit_curve_copy(rough.curve, a->curve);
        if (feet != NULL)
            memcpy(rough.feet, feet, (size_t)few->points * sizeof *feet);
        good = (feet != NULL || fit_feet_guess(few, rough.curve, rough.feet)) && fit_descend_near(few, o, &rough);
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
    double *feet;
    if (p->points < 2 * groups) { /* few enough themselves */
        int good = fit_feet_guess(p, a->curve, a->feet) && fit_descend_near(p, o, a);
        if (good) {
            memcpy(a->feet, a->objective->feet, (size_t)p->points * sizeof *a->feet);
            fit_curve_copy(a->curve, a->objective->curve);
        }
        return good;
    }
    if (!fit_few_thinned(p, p->points / (p->loss == CAGD_FIT_SQUARES ? enough : groups), &few))
        return 0;
    int good = approach_with(&few, o, NULL, a);
    fit_few_free(&few);
    good = good && fit_feet_guess(p, a->curve, a->feet);
    if (!good || p->loss != CAGD_FIT_SQUARES)
        return good;
    feet = malloc((size_t)groups * sizeof *feet);
    good = feet != NULL && fit_few_means(p, a->curve, a->feet, groups, &few, feet);
    if (good) {
        good = fit_problem_equations(&few) < p->unknowns || approach_with(&few, o, feet, a);
        fit_few_free(&few);
    }
    free(feet);
    return good;
}
