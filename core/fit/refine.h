/* refine.h -- splines whose number of control points, knots and smoothing term are chosen (节点的选取). */
#ifndef CAGD_FIT_REFINE_H
#define CAGD_FIT_REFINE_H

#include "core/fit/cagd_fit.h"

/* A curve of the degree of the options, without weights unless these are free and nothing is to be chosen.  With choices->count its knots are chosen, otherwise
 * they are those of the options; then it is smoothed as choices->smooth says.  `data` does not repeat a point. */
cagd_status fit_refined(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_choices *choices,
                        cagd_fit_result **result, int *where);

/* The points of a polynomial spline on other knots, count of them in `to`, where every span of the new knots that lies in one of the old ones
 * has the old curve; elsewhere near it.  Period: of the old curve, 0 when open. */
void fit_respace(const cagd_spline *from, int period, const double knots[], int count, double to[]);
#endif
