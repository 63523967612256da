/* by_feet.h -- points in the order of their feet, and a result that tells of them in this order. */
#ifndef CAGD_FIT_BY_FEET_H
#define CAGD_FIT_BY_FEET_H

#include "core/fit/cagd_fit.h"

/* data and result say what those say that they were made of, of the same points in another order; whatever belongs to a point goes with it:
 * its coordinates and standard deviation, foot, residual and distance, whether the foot is at an end, whether it is an outlier, and the
 * indices of the end points and of the largest distance.  What belongs to no point is that of the result they were made of, which owns it. */
typedef struct fit_by_feet {
    cagd_fit_data data;
    cagd_fit_result result;
    double *numbers;
    int *marks;
} fit_by_feet;

/* Equal feet keep the order of the points.  Of `data` the points of the result are taken, which are the first ones; of `result` `outlier` may
 * be NULL.  Returns 0 when there is no memory; fit_by_feet_free has to be called in either case. */
int fit_by_feet_of(const cagd_fit_data *data, const cagd_fit_result *result, fit_by_feet *sorted);
void fit_by_feet_free(fit_by_feet *sorted);
#endif
