/* attempt.h -- the way from one curve to a minimum. */
#ifndef CAGD_FIT_ATTEMPT_H
#define CAGD_FIT_ATTEMPT_H

#include "core/fit/ceres.h"
#include "core/fit/objective.h"

typedef struct fit_attempt {
    const fit_problem *problem;
    fit_curve *curve; /* where it starts                                                              */
    double *feet;
    fit_objective *objective; /* where it is; at the end evaluated at theta                                   */
    int max_iterations;       /* of all its parts together                                                    */
    double initial_cost;
    double radius;    /* of the trust region of Ceres                                                 */
    double decrement; /* Newton's, after the last of Newton's steps; see model.h                      */
    fit_outcome outcome;
} fit_attempt;

/* Returns 0 when there is no memory; fit_attempt_free is to be called all the same. */
int fit_attempt_new(const fit_problem *problem, fit_attempt *attempt);
void fit_attempt_free(fit_attempt *attempt);

/* Adds to the attempt what a run of the minimiser did, and takes its history over.  Returns 0 when there is no
 * memory. */
int fit_attempt_append(fit_attempt *attempt, fit_outcome *run);

/* Adds one step of the given length, at whose end the objective was evaluated last.  Returns 0 when there is no
 * memory. */
int fit_attempt_step(fit_attempt *attempt, int accepted, double length);

/* Decides whether what the minimiser calls converged is a minimum.  It is none when the curve is none; when a point
 * of the curve has so small a share that rounding would take it away; or when a point goes to infinity as its weight goes to 0; or when a weight runs away, so that the cost
 * falls towards a weight 0 or infinity without a minimum.  Then the attempt has failed. */
void fit_attempt_judge(fit_attempt *attempt);
#endif
