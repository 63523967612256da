/* descend.h -- from the curve of an attempt downhill to a minimum.
 *
 * Each leaves the objective at the best x and returns 0 when there is no memory. */
#ifndef CAGD_FIT_DESCEND_H
#define CAGD_FIT_DESCEND_H

#include "core/fit/attempt.h"

/* By Ceres, from curve and feet of the attempt near to a minimum, with feet by Taylor's polynomial. */
int fit_descend_near(fit_attempt *attempt);

/* By Newton's steps from where the objective is, as long as they lower Newton's decrement, model.h, and it is more
 * than `tolerance` of the residuals.  The minimiser compares costs, which near a minimum no longer tell two points
 * apart when their gradients still do. */
int fit_descend_newton(fit_attempt *attempt, double tolerance);

/* From curve and feet of the attempt to the minimum, as far as binary64 goes or the tolerance of the options asks;
 * and once more whenever a search finds better feet.  The start is taken to be near the minimum if the last run of
 * Ceres has converged. */
int fit_descend(fit_attempt *attempt);
#endif
