/* scattered.h -- knots and smoothing of points that scatter by more than they are apart.
 *
 * The polygon of such points says nothing of the curve, and a curve through them can gain by going to and fro between them.  The means of
 * m neighbours have errors smaller by sqrt(m); knots, or the weight of a smoothing term, and a first curve are found by the means (means.h), and
 * led to all points from there.  A weight lambda of G means becomes lambda (sum 1/sigma_i^2)/(sum 1/sigma_G^2). */
#ifndef CAGD_FIT_SCATTERED_H
#define CAGD_FIT_SCATTERED_H

#include "core/fit/search.h"

/* First the knots by the means of neighbours, then more of them by all points, as long as each helps and brings no excursions, loops or gaps.
 * Otherwise, and of points that do not scatter so, nothing is the best one. */
cagd_status fit_search_by_means(fit_search *s);

/* fit_smooth_best of scattered points.  Where the curve of the means comes to no minimum, as of fewer means than control points, all points say it.
 * chosen: the number of control points is not given. */
cagd_status fit_smooth_by_means(const fit_search *s, const cagd_fit_options *options, int how, int chosen,
                                cagd_fit_result **result);
#endif
