/* few.h -- a problem with fewer points in place of many, for the way to the minimum. */
#ifndef CAGD_FIT_FEW_H
#define CAGD_FIT_FEW_H

#include "core/fit/problem.h"

/* Every stride-th point, and the last one.  Only the points of *few are its own; returns 0 when there is no memory. */
int fit_few_thinned(const fit_problem *problem, int stride, fit_problem *few);

/* Means of points whose feet t lie in one of `groups` equal parts of the domain, with the curvature taken out: the mean of what
 * the points are off the curve, put to the curve at the mean of the feet, which become feet[groups]. */
int fit_few_means(const fit_problem *problem, const fit_curve *curve, const double t[], int groups, fit_problem *few,
                  double feet[]);

/* What the two have made. */
void fit_few_free(fit_problem *few);
#endif
