/* result.h -- what cagd_fit gives back. */
#ifndef CAGD_FIT_RESULT_H
#define CAGD_FIT_RESULT_H

#include "core/fit/attempt.h"

/* From an attempt that has come to its end, whose history it takes over; without statistics.  Points that are not free are those that
 * were given, not rounded by way of working coordinates.  NULL when there is no memory. */
cagd_fit_result *fit_result_make(const cagd_fit_data *data, const cagd_fit_options *options, const fit_problem *problem,
                                 fit_attempt *attempt);
#endif
