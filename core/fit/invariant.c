#include "core/fit/invariant.h"

#include "core/fit/propagation.h"

#include <math.h>
#include <stddef.h>

double fit_log_invariant_derivative(const cagd_fit_unknown *by, const void *j)
{
    int away = by->index - *(const int *)j;
    return !by->is_weight ? 0 : away == 0 ? 2 : away == 1 || away == -1 ? -1 : 0;
}

/* The logarithm is known also of a weight that is itself 0 or infinite in binary64. */
static double log_weight(const cagd_fit_result *result, int j)
{
    double w = result->curve.weights[j];
    for (int k = 0; k < result->unknowns && !(w > 0 && isfinite(w)); k++)
        if (result->unknown[k].is_weight && result->unknown[k].index == j)
            return result->value[k];
    return log(w);
}

double fit_log_invariant(const cagd_fit_result *result, int j)
{
    if (result->curve.weights == NULL)
        return 0;
    double before = log_weight(result, j - 1), here = log_weight(result, j), after = log_weight(result, j + 1);
    return here - before + (here - after);
}

/* I_j without the roundings of a logarithm, where binary64 holds the quotients. */
static double invariant(const cagd_fit_result *result, int j)
{
    const double *w = result->curve.weights;
    double quotient = w != NULL ? w[j] / w[j - 1] * (w[j] / w[j + 1]) : NAN;
    return quotient > 0 && isfinite(quotient) ? quotient : exp(fit_log_invariant(result, j));
}

/* Whether no unknown that I_j depends on moves along a free direction. */
static int is_determined(const cagd_fit_result *result, int j)
{
    int determined = 1;
    for (int a = 0; a < result->unknowns; a++)
        if (fit_log_invariant_derivative(&result->unknown[a], &j) != 0 && !result->at_bound[a])
            determined = determined && result->determined[a];
    return determined;
}

void fit_invariants(cagd_fit_result *result)
{
    for (int j = 1; j <= result->invariants; j++) {
        double error = fit_propagated_error(result, fit_log_invariant_derivative, &j);
        result->invariant[j - 1] = invariant(result, j);
        result->invariant_error[j - 1] =
            is_determined(result, j) ? exp(fit_log_invariant(result, j)) * error : INFINITY;
    }
}
