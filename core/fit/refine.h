/* refine.h -- splines whose number of control points, knots and smoothing term are chosen (节点的选取).
 *
 * What is done in which order.  The number of control points and the knots, where they are asked for: of scattered points by means (scattered.h),
 * of others by all (placement.h), with a tolerance in more ways (tolerance.h).  As many control points as are given over even knots, and where
 * those are not good led to from a smooth curve (continuation.h), or over knots that the points place.  Then the smoothing term, where it is
 * asked for or the curve is not good without (cross_validation.h).  What was found is fitted once more, with all that is said of it. */
#ifndef CAGD_FIT_REFINE_H
#define CAGD_FIT_REFINE_H

#include "core/fit/cagd_fit.h"

/* A curve of the degree of the options, without weights unless these are free and nothing is to be chosen.  With choices->count its knots are chosen, otherwise
 * they are those of the options; then it is smoothed as choices->smooth says.  `data` does not repeat a point. */
cagd_status fit_refined(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_choices *choices,
                        cagd_fit_result **result, int *where);
#endif
