/* approach.h -- most of the way to the minimum, with few points in place of many. */
#ifndef CAGD_FIT_APPROACH_H
#define CAGD_FIT_APPROACH_H

#include "core/fit/attempt.h"

/* Points for the way: so many for each unknown suffice to come near; TIMES as many means of points with
 * neighbouring feet know the minimum nearly as well as all points do. */
enum { FIT_ENOUGH = 20, FIT_TIMES = 4 };

/* From the curve of the attempt to one near the minimum, and the feet of all points on it: with few points, and then with means of all,
 * unless large errors are to count less than in a mean.  Returns 0 when there is no memory. */
int fit_approach(const fit_problem *problem, const cagd_fit_options *options, fit_attempt *attempt);
#endif
