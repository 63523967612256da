#include "core/fit/statistics.h"

#include "core/fit/invariant.h"
#include "core/fit/loss.h"
#include "core/fit/quantile.h"
#include "core/require.h"

#include <math.h>
#include <stddef.h>

/* Whether the curve has ends, and these are given.  A closed curve has none, whatever the flag says. */
static int has_given_ends(const cagd_fit_options *options, const cagd_fit_result *result)
{
    return result->period == 0 && !(options->free & CAGD_FIT_END_POINTS);
}

/* Whether point i is an end of the curve that is given: its distance is 0 whatever the unknowns are. */
static int is_given_end(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *result,
                        int i)
{
    REQUIRE(has_given_ends(options, result), 0);
    int at[2] = {1, 1};
    for (int c = 0; c < data->dim; c++) {
        const double x = data->points[(size_t)i * (size_t)data->dim + (size_t)c] - result->origin[c];
        at[0] &= x == result->relative[c];
        at[1] &= x == result->relative[(result->curve.count - 1) * data->dim + c];
    }
    return at[0] || at[1];
}

/* Residuals of point i: across the curve, and along it where it is one of an end; none of a given end. */
static int directions_of(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *result,
                         int i)
{
    REQUIRE(!is_given_end(data, options, result, i), 0);
    return data->dim - 1 + (i == result->end_points[0]) + (i == result->end_points[1]);
}

static int equations(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *result)
{
    int sum = result->tied;
    for (int i = 0; i < data->count; i++)
        sum += directions_of(data, options, result, i);
    return sum;
}

static double scaled_square(const cagd_fit_data *data, const cagd_fit_result *result, int i)
{
    double sum = 0, sigma = data->sigma != NULL ? data->sigma[i] : 1;
    for (int c = 0; c < data->dim; c++) {
        double r = result->residuals[i * data->dim + c] / sigma;
        sum += r * r;
    }
    return sum;
}

int fit_counted_unknowns(const cagd_fit_result *result)
{
    return isfinite(result->effective) ? (int)rint(result->effective) : result->unknowns;
}

/* Huber's factor for the covariance of an M-estimate: see the header. */
static double m_estimate_scale(const cagd_fit_data *data, const cagd_fit_options *options,
                               const cagd_fit_result *result)
{
    double spread = 0, mean = 0, variance = 0, value[3], count = 0;
    for (int i = 0; i < data->count; i++)
        count += directions_of(data, options, result, i) > 0;
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < data->count; i++) {
            const int directions = directions_of(data, options, result, i);
            if (directions == 0)
                continue;
            double s = scaled_square(data, result, i);
            fit_loss(options->loss, options->loss_scale, s, value);
            double m = value[1] + 2 * s * value[2] / directions;
            if (pass == 0) {
                spread += value[1] * value[1] * s;
                mean += m / count;
            } else {
                variance += (m - mean) * (m - mean) / count;
            }
        }
    const double k = fit_counted_unknowns(result), n = equations(data, options, result);
    double K = 1 + k / n * variance / (mean * mean);
    return mean > 0 ? K * K * spread / result->degrees_of_freedom / (mean * mean) : NAN;
}

/* The sum of the losses, and what tells fits of the same points apart. */
static void fill_criteria(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result *result)
{
    const int rows = equations(data, options, result), known = data->sigma != NULL;
    double n = rows, k = result->effective, value[3], sum = 0;
    for (int i = 0; i < data->count; i++) {
        fit_loss(options->loss, options->loss_scale, scaled_square(data, result, i), value);
        sum += value[0];
    }
    int d = result->degrees_of_freedom = rows - fit_counted_unknowns(result);
    result->chi_squared = sum;
    result->reduced_chi_squared = d > 0 ? sum / d : NAN;
    result->aic = known ? sum + 2 * k : n * log(sum / n) + 2 * (k + 1);
    result->bic = known ? sum + k * log(n) : n * log(sum / n) + (k + 1) * log(n);
}

/* The scale of the errors, and the quantile that goes with what is known of it. */
static void fill_scale(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result *result)
{
    int squares = options->loss == CAGD_FIT_SQUARES, d = result->degrees_of_freedom;
    result->scale_is_given = squares && data->sigma != NULL;
    result->quantile = result->scale_is_given ? fit_normal_quantile() : fit_student_quantile(d);
    result->scale_squared = result->scale_is_given ? 1
                            : d <= 0               ? NAN
                            : squares              ? result->reduced_chi_squared
                                                   : m_estimate_scale(data, options, result);
}

void fit_statistics(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result *result)
{
    fill_criteria(data, options, result);
    fill_scale(data, options, result);
    for (int m = 0; m < result->unknowns * result->unknowns; m++)
        result->covariance[m] *= result->scale_squared;
    fit_invariants(result);
    const int are_points = has_given_ends(options, result) && options->initial == NULL;
    result->ends_are_exact = are_points && (data->sigma != NULL || result->scale_squared > 0);
}
