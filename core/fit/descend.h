/* descend.h -- from the curve of an attempt downhill to a minimum. */
#ifndef CAGD_FIT_DESCEND_H
#define CAGD_FIT_DESCEND_H

#include "core/fit/attempt.h"

/* Ceres, from curve and feet of the attempt near to a minimum, with rough feet.  This and the others leave the objective at
 * the best x, and return 0 when there is no memory. */
int fit_descend_near(const fit_problem *problem, const cagd_fit_options *options, fit_attempt *attempt);

/* Newton's steps from where the objective is, as long as they shrink what the unknowns can still take away of the residuals, and
 * that is more than `tolerance` of them.  The minimiser compares costs, which near the minimum say nothing any more when the
 * gradient still does.  *left: |y|, model.h, at the end. */
int fit_descend_newton(const fit_problem *problem, const cagd_fit_options *options, double tolerance, double *left,
                       fit_attempt *attempt);

/* From curve and feet of the attempt, near the minimum if its last run of Ceres has converged, to the minimum as far as binary64 goes
 * or `tolerance` of the options asks, and again when a search finds better feet. */
int fit_descend(const fit_problem *problem, const cagd_fit_options *options, fit_attempt *attempt);
#endif
