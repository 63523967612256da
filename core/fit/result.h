/* result.h -- what cagd_fit gives back. */
#ifndef CAGD_FIT_RESULT_H
#define CAGD_FIT_RESULT_H

#include "core/fit/minimum.h"

/* From a minimum, whose history it takes over; without statistics, statistics.h.  Points that are not free are those
 * that were given, not rounded by way of working coordinates.  NULL when there is no memory. */
cagd_fit_result *fit_result_make(const cagd_fit_data *data, const fit_problem *problem, fit_minimum *minimum);

/* The index of the measured point that is nearest to P, which is told from the origin: for an end that is one of them, but
 * for rounding, that one. */
int fit_nearest_measured(const cagd_fit_data *data, const double origin[], const double P[]);
#endif
