/* fit.h -- one fit of all points. */
#ifndef CAGD_FIT_FIT_H
#define CAGD_FIT_FIT_H

#include "core/fit/cagd_fit.h"

/* cagd_fit, but that the ends of the curve follow their points even where these are outliers. */
cagd_status fit_plainly(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result **result,
                        int *where);
#endif
