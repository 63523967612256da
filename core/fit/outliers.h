/* outliers.h -- the scale of a robust loss, and the points that do not obey it (离群点).
 *
 * The scale of the points is estimated by the median of the distances, which half of the points may not obey: of normal errors with standard
 * deviation 1 the distance of a point from a curve of the plane has the median 0.6745 (MAD), of a curve in space, with two
 * directions across, sqrt(2 log 2) = 1.1774.  The number of unknowns is allowed for by sqrt(n/(n - k)), n and k
 * of statistics.h.
 *
 * An outlier is farther than the largest of N normal errors is once in twenty times:  N P(|Z| > z) = 0.05; in space
 * N exp(-z^2/2) = 0.05.  Of points that lie on the curve but for rounding none is one.
 * Source: huber-1981, 5.7 and 6.4. */
#ifndef CAGD_FIT_OUTLIERS_H
#define CAGD_FIT_OUTLIERS_H

#include "core/fit/cagd_fit.h"

/* The estimate, in units of the standard deviations where these are given; 0 where more than half of the points lie on the
 * curve, NaN when there is no memory. */
double fit_robust_deviation(const cagd_fit_data *data, const cagd_fit_result *result);

/* The scale for a loss of which 95 % efficiency at normal errors is asked: 1.345 deviations for Huber's, 2.385 for
 * Cauchy's. */
double fit_loss_scale_of(cagd_fit_loss loss, double deviation);

/* Fills deviation, outlier_limit, outlier, outliers and rms_of_others; `outlier` is there already.  Returns 0 when there is no
 * memory. */
int fit_outliers(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result *result);
#endif
