/* continuation.h -- a spline without smoothing term, led to from a smooth one (延拓法).
 *
 * Of many minima of the squares that have nearly the same cost the one without loops is the one that bends least.  With n control points and the
 * weight lambda_0 = n^-4 sum 1/sigma_i^2 the smoothing term lets the curve be off by about the way between two of them, and there is one minimum.
 * From there lambda_k = 10^-k lambda_0, k = 1, ..., 6, and at last lambda = 0, each fit from the one before. */
#ifndef CAGD_FIT_CONTINUATION_H
#define CAGD_FIT_CONTINUATION_H

#include "core/fit/search.h"

/* As many control points as the options say.  The curve takes the place of the best one if it is good and has no loops; *led says whether it
 * did. */
cagd_status fit_lead_from_smooth(fit_search *s, int *led);
#endif
