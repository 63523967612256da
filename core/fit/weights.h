/* weights.h -- whether the weights of a spline explain anything (权因子的检验). */
#ifndef CAGD_FIT_WEIGHTS_H
#define CAGD_FIT_WEIGHTS_H

#include "core/fit/cagd_fit.h"

/* *result is a spline whose weights are 1, a minimum.  Where weights are free as well, the linear model at that curve says by how much, D, the sum
 * of squares would fall, and in how many more directions, m; with d degrees of freedom left and no influence of weights D/m over what then remains
 * over d is distributed as F.  Where that is less probable than once in twenty times the weights are fitted, between 1/16 and 16, and
 * kept if the score of cagd_fit_choose becomes lower; *result is replaced.  within > 0: not where the spline keeps every
 * point within that distance and with weights does not.  Where they would explain something and are not kept, no intervals are sought, and the
 * scale of the errors is what the distances with weights would say.  What was found stands in found. */
cagd_status fit_test_weights(const cagd_fit_data *data, const cagd_fit_options *options, double within,
                             cagd_fit_result **result, int *where);
#endif
