#include "core/fit/cagd_fit.h"

#include <math.h>
#include <stddef.h>

int cagd_fit_is_minimum(const cagd_fit_result *r) { return r->termination == CAGD_FIT_CONVERGED && !r->refuted; }

void cagd_fit_refute(cagd_fit_result *r) { r->refuted = 1; }

/* Whether binary64 holds a positive number that was computed from its logarithm. */
static int is_held(double positive) { return positive > 0 && isfinite(positive); }

/* The estimate of exp(x), with the interval of x. */
static cagd_fit_estimate exponential(cagd_fit_estimate x)
{
    double value = exp(x.value);
    return (cagd_fit_estimate){value, is_held(value) ? value * x.error : NAN, exp(x.low), exp(x.high), 0, x.by};
}

/* The interval of quantity q, an unknown or, behind these, the logarithm of an invariant, in the place of the linear
 * one, if it was found otherwise, or not at all. */
static cagd_fit_estimate by_profile(const cagd_fit_result *r, int q, cagd_fit_estimate e)
{
    e.by = r->interval_by != NULL ? r->interval_by[q] : CAGD_FIT_INTERVAL_LINEAR;
    if (!isfinite(e.error))
        return e;
    if (e.by == CAGD_FIT_INTERVAL_PROFILE)
        e.low = r->interval[2 * q], e.high = r->interval[2 * q + 1];
    if (e.by == CAGD_FIT_INTERVAL_NONE)
        e.error = e.low = e.high = NAN;
    if (e.by == CAGD_FIT_INTERVAL_NOT_SOUGHT)
        e.low = e.high = NAN;
    return e;
}

cagd_fit_estimate cagd_fit_unknown_estimate(const cagd_fit_result *r, int k)
{
    const cagd_fit_unknown *u = &r->unknown[k];
    double value = u->is_weight ? r->value[k] : r->relative[u->index * r->curve.dim + u->coordinate], error = NAN;
    if (!r->at_bound[k] && r->determined[k] && cagd_fit_is_minimum(r))
        error = sqrt(r->covariance[(size_t)k * (size_t)r->unknowns + (size_t)k]);
    double reach = r->quantile * error;
    cagd_fit_estimate e = {value, error, value - reach, value + reach, r->origin[u->coordinate], 0};
    e = by_profile(r, k, e);
    return u->is_weight ? exponential(e) : e;
}

cagd_fit_estimate cagd_fit_invariant_estimate(const cagd_fit_result *r, int j)
{
    double value = r->invariant[j], error = r->invariant_error[j];
    if (!is_held(value))
        return (cagd_fit_estimate){value, NAN, NAN, NAN, 0, 0};
    if (!isfinite(error) || !cagd_fit_is_minimum(r))
        error = NAN;
    double reach = r->quantile * error / value;
    cagd_fit_estimate e = by_profile(
        r, r->unknowns + j, (cagd_fit_estimate){log(value), error, log(value) - reach, log(value) + reach, 0, 0});
    return (cagd_fit_estimate){value, e.error, exp(e.low), exp(e.high), 0, e.by};
}

double cagd_fit_correlation(const cagd_fit_result *r, int i, int j)
{
    size_t n = (size_t)r->unknowns, a = (size_t)i, b = (size_t)j;
    return r->covariance[a * n + b] / sqrt(r->covariance[a * n + a] * r->covariance[b * n + b]);
}

double cagd_fit_deviation(const cagd_fit_data *data, const cagd_fit_result *r, int i)
{
    return data->sigma != NULL ? data->sigma[i] : cagd_fit_is_minimum(r) ? sqrt(r->scale_squared) : NAN;
}

double cagd_fit_standardised(const cagd_fit_data *data, const cagd_fit_result *r, int i)
{
    double deviation = cagd_fit_deviation(data, r, i);
    return isfinite(deviation) && deviation > 0 ? r->distances[i] / deviation : NAN;
}

int cagd_fit_finest_unknown(const cagd_fit_result *r, double *spacing)
{
    int finest = -1;
    double smallest = HUGE_VAL;
    *spacing = 0;
    for (int k = 0; k < r->unknowns; k++) {
        double error = cagd_fit_unknown_estimate(r, k).error, step = r->spacing[r->unknown[k].coordinate];
        if (r->unknown[k].is_weight || !(error > 0 && step > error))
            continue;
        *spacing = fmax(*spacing, step);
        if (error < smallest)
            smallest = error, finest = k;
    }
    return finest;
}
