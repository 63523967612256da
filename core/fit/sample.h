/* sample.h -- a problem with few points in the place of many, for the way to the minimum. */
#ifndef CAGD_FIT_SAMPLE_H
#define CAGD_FIT_SAMPLE_H

#include "core/fit/problem.h"

/* Every stride-th point, and the last one.  The sample shares all but its points with the problem, which has to
 * outlive it.  Returns 0 when there is no memory. */
int fit_sample_every(const fit_problem *problem, int stride, fit_problem *sample);

/* The domain is divided into `groups` equal parts, and of the points whose feet t lie in one of them the mean is
 * taken: the mean of Q_i - C(t_i), put to the curve at the mean of the t_i, which becomes its foot.  So the curvature
 * of the curve is not in it.  A mean has the precision of its points together.  Parts without points are left out.
 * The points of the ends stay what they are.  feet[groups + 2] has room for all. */
int fit_sample_means(const fit_problem *problem, const fit_curve *curve, const double t[], int groups,
                     fit_problem *sample, double feet[]);

/* Releases what the two have made. */
void fit_sample_free(fit_problem *sample);
#endif
