/* approach.h -- most of the way to the minimum, with few points in the place of many. */
#ifndef CAGD_FIT_APPROACH_H
#define CAGD_FIT_APPROACH_H

#include "core/fit/attempt.h"

/* From the curve of the attempt to one near the minimum, and the feet of all points on it.  The first approach takes
 * a sample of the points.  The second one takes means of all points, unless the loss is robust: a mean would let
 * large errors count as much as others.  Where there are few points they are taken themselves.  Returns 0 when there
 * is no memory. */
int fit_approach(fit_attempt *attempt);
#endif
