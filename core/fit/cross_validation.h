/* cross_validation.h -- the weight of the smoothing term by generalised cross-validation (广义交叉验证).
 *
 * Of n equations and k(lambda) unknowns that the points determine, lambda minimises
 *
 *     V(lambda) = n chi_squared(lambda)/(n - 1.4 k(lambda))^2:
 *
 * from a weight that leaves a straight line downwards in tenths, each fit from the one before, and then between the neighbours of the best one.
 * With 1 in the place of 1.4 the weight comes out too small now and then.  Source: wahba-1990; kim-gu-2004. */
#ifndef CAGD_FIT_CROSS_VALIDATION_H
#define CAGD_FIT_CROSS_VALIDATION_H

#include "core/fit/search.h"

/* The smoothed curve with as many control points as the options say, those with loops only where there are no others.  *result, which may be
 * NULL, is replaced where there is a minimum.  how: see `smoothed` of cagd_fit_found. */
cagd_status fit_smooth_best(const fit_search *s, const cagd_fit_options *options, int how, cagd_fit_result **result);

/* As many control points, over even knots, as leave half of the equations, 40 knots at most. */
int fit_most_points(const fit_search *s);
#endif
