/* invariant.h -- the shape invariants I_j = w_j^2/(w_{j-1} w_{j+1}) of a curve of one span (形状不变量).
 *
 * log I_j is linear in the logarithms of the weights, which are unknowns of the fit. */
#ifndef CAGD_FIT_INVARIANT_H
#define CAGD_FIT_INVARIANT_H

#include "core/fit/cagd_fit.h"

/* log I_j, 1 <= j <= degree-1; 0 for a curve without weights. */
double fit_log_invariant(const cagd_fit_result *result, int j);

/* A fit_derivative: of log I_j by an unknown; j points to the int j. */
double fit_log_invariant_derivative(const cagd_fit_unknown *by, const void *j);

/* Fills invariant and invariant_error of the result, from its curve and its covariance.  The error is I_j times that
 * of log I_j; infinite where log I_j changes along a free direction. */
void fit_invariants(cagd_fit_result *result);
#endif
