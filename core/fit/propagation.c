#include "core/fit/propagation.h"

#include <math.h>

double fit_propagated_error(const cagd_fit_result *result, fit_derivative *gradient, const void *f)
{
    int n = result->unknowns;
    double variance = 0;
    for (int a = 0; a < n; a++) {
        double ga = gradient(&result->unknown[a], f);
        if (ga != 0)
            for (int b = 0; b < n; b++)
                variance += ga * gradient(&result->unknown[b], f) * result->covariance[a * n + b];
    }
    return variance > 0 ? sqrt(variance) : variance <= 0 ? 0 : NAN;
}
