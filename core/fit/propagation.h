/* propagation.h -- the standard error of a function of the unknowns (误差传播). */
#ifndef CAGD_FIT_PROPAGATION_H
#define CAGD_FIT_PROPAGATION_H

#include "core/fit/cagd_fit.h"

/* The derivative of a function f of the curve by one unknown. */
typedef double fit_derivative(const cagd_fit_unknown *by, const void *f);

/* sqrt(g^T covariance g), g the gradient of f: the delta method.  NaN where the covariance is. */
double fit_propagated_error(const cagd_fit_result *result, fit_derivative *gradient, const void *f);
#endif
