/* monotone.h -- feet in the order of the points (保序垂足). */
#ifndef CAGD_FIT_MONOTONE_H
#define CAGD_FIT_MONOTONE_H

#include "core/fit/cagd_fit.h"
#include "core/fit/strategy.h"

/* One fit of the points that are given, whatever the order of its feet. */
typedef cagd_status fit_of_points(const cagd_fit_data *data, const cagd_fit_options *options,
                                  const fit_strategy *strategy, cagd_fit_result **result, int *where);

/* The fit whose feet do not fall back, cagd_fit.h, by fits in which neighbours that share a foot are one point, their mean
 * weighted by 1/s_i^2:
 *
 *     sum_i |Q_i - C(t)|^2/s_i^2 = |mean - C(t)|^2 sum_i 1/s_i^2 + sum_i |Q_i - mean|^2/s_i^2,
 *
 * and the last sum does not move.  Neighbours whose feet fall back are pooled (pool adjacent violators, barlow-1972), and pooled ones
 * are divided where those before would go back and those behind forward, until nothing changes. */
cagd_status fit_monotone(const cagd_fit_data *data, const cagd_fit_options *options, const fit_strategy *strategy,
                         fit_of_points *fit, cagd_fit_result **result, int *where);
#endif
