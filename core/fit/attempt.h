/* attempt.h -- one way from a curve to a minimum, and what is made of it. */
#ifndef CAGD_FIT_ATTEMPT_H
#define CAGD_FIT_ATTEMPT_H

#include "core/fit/ceres.h"
#include "core/fit/objective.h"

typedef struct fit_attempt {
    fit_curve *curve; /* where it starts                                                         */
    double *feet;
    fit_objective *objective; /* where it ends: evaluated at theta                                       */
    double initial_cost, radius;
    fit_outcome outcome;
} fit_attempt;

/* Returns 0 when there is no memory; fit_attempt_free is to be called all the same. */
int fit_attempt_new(const fit_problem *problem, fit_attempt *attempt);
void fit_attempt_free(fit_attempt *attempt);

/* Adds to the attempt what a run of the minimiser did; takes its history over.  Returns 0 when there is no memory. */
int fit_attempt_append(fit_attempt *attempt, fit_outcome *more);

/* The same of one step that was evaluated last, of the given length. */
int fit_attempt_step(fit_attempt *attempt, int accepted, double length);

/* What the minimiser calls converged is none when the curve is none; when it has lost a point, whose share rounding would
 * take away; or when a weight runs away: then the cost falls towards a weight 0 or infinity without a minimum. */
void fit_attempt_judge(const fit_problem *problem, const cagd_fit_options *options, fit_attempt *attempt);
#endif
