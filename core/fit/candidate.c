#include "core/fit/candidate.h"

#include <math.h>
#include <stddef.h>

static const double LONGEST = 1.26; /* see cagd_fit_length_ratio */

int fit_is_good(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *r)
{
    if (!cagd_fit_is_minimum(r) || !isfinite(r->chi_squared))
        return 0;
    return options->unordered || cagd_fit_length_ratio(data, r) <= LONGEST;
}

double fit_equations_of(const cagd_fit_data *data) { return (double)data->count * (data->dim - 1); }

double fit_unknowns_of(const cagd_fit_result *r)
{
    return r->effective - (r->end_points[0] >= 0) - (r->end_points[1] >= 0);
}

double fit_score(const cagd_fit_data *data, const cagd_fit_result *r)
{
    const double n = fit_equations_of(data), k = fit_unknowns_of(r) + (data->sigma == NULL);
    if (!(n - k - 2 > 0))
        return INFINITY;
    const double more = k * log(n) * n / (n - k - 2);
    return data->sigma != NULL ? r->chi_squared + more : n * log(r->chi_squared / n) + more;
}
