/* ellipse_result.h -- a fitted ellipse as the result of a fit. */
#ifndef CAGD_FIT_ELLIPSE_RESULT_H
#define CAGD_FIT_ELLIPSE_RESULT_H

#include "core/fit/cagd_fit.h"

/* *result: the ellipse, whole where the options are of a closed curve or the points go around by more than a turn, otherwise the arc
 * over the feet of the points; or the circle, where an F test at 95 % does not tell it from an ellipse.  Its unknowns are not those
 * of points and weights, of which there are none: what is known of it stands in found.ellipse.  NULL, with OK, where the fit
 * comes to no ellipse, or the points do not determine it. */
cagd_status fit_ellipse_result(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result **result);
#endif
