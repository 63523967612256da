/* starts.h -- where the way to the minimum begins. */
#ifndef CAGD_FIT_STARTS_H
#define CAGD_FIT_STARTS_H

#include "core/fit/problem.h"

/* Start number `start` becomes `curve`: 0 the initial curve or, where there is none, the best of several that were found from the
 * points, each carried near its minimum; the others the same curve with other weights, and points that fit them.  Returns 0 when there
 * is no memory. */
int fit_start(const fit_problem *problem, const cagd_fit_options *options, int start, fit_curve *curve);
#endif
