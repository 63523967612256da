/* end_outliers.h -- whether the first and the last point are outliers (端点处的离群点).
 *
 * A measured end follows the point that measures it, and the distance of this point from the curve says little about it.  So it is judged by the
 * curve of the others, whose end is measured by the next point.  The piece of that curve at its end goes on behind it, as the same rational
 * function, by as much as the piece is long, as far as the denominator is positive.  From the end one goes on, or else back, as long as that
 * comes nearer to the point.  With d the vector from the place C where one stops to the point, n = d/|d|, J the derivatives of C by the unknowns, V their covariance, and s the standard deviation that the other points have
 * (outliers.h), the point is an outlier where
 *
 *     |d|^2 > z^2 (s^2 + n^T J V J^T n),    N P(F > z^2/k) = 0.05,
 *
 * F with k = dim-1 and 0.37 f degrees of freedom, f those of the fit: the median of the distances is as good as 0.37 times as many points
 * would be by their squares.  So a good end of N points is left out about once in 20 N times; of 600 ends in simulations with 12 points none
 * and 3, with 25 and 51 none.
 *
 * An outlier is left out: the curve is that of the others, and the next point, which measures its end, is judged likewise, until a tenth of
 * the points is left out. */
#ifndef CAGD_FIT_END_OUTLIERS_H
#define CAGD_FIT_END_OUTLIERS_H

#include "core/fit/cagd_fit.h"

/* A fit of the points that are given; how: what it needs beside them. */
typedef cagd_status fit_of_data(const cagd_fit_data *data, const void *how, cagd_fit_result **result, int *where);

/* The fit without the outliers at the ends, if it is one whose ends are judged: of a robust loss, of points in order that measure the ends.  What the
 * result says of points is said of all of them. */
cagd_status fit_without_end_outliers(const cagd_fit_data *data, const cagd_fit_options *options, fit_of_data *fit,
                                     const void *how, cagd_fit_result **result, int *where);
#endif
