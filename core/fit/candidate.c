#include "core/fit/candidate.h"

#include "core/fit/keyed.h"
#include "core/require.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* Of points in no order the polygon goes from foot to foot.  NaN when there is no memory. */
static double ratio_by_feet(const cagd_fit_data *data, const cagd_fit_result *r)
{
    const size_t n = (size_t)r->count, dim = (size_t)data->dim;
    keyed *list = malloc((n + 1) * sizeof *list);
    double *points = malloc((n * dim + 1) * sizeof *points), ratio = NAN;
    if (list != NULL && points != NULL) {
        for (size_t i = 0; i < n; i++)
            list[i] = (keyed){r->feet[i], (int)i};
        qsort(list, n, sizeof *list, fit_by_key);
        for (size_t i = 0; i < n; i++)
            memcpy(points + i * dim, data->points + (size_t)list[i].index * dim, dim * sizeof *points);
        ratio = cagd_fit_length_ratio(&(cagd_fit_data){r->count, data->dim, points, NULL}, r);
    }
    free(list);
    free(points);
    return ratio;
}

int fit_is_good(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *r)
{
    if (!cagd_fit_is_minimum(r) || !isfinite(r->chi_squared))
        return 0;
    return (options->unordered ? ratio_by_feet(data, r) : cagd_fit_length_ratio(data, r)) <= CAGD_FIT_LONGEST_RATIO;
}

cagd_status fit_problems_of(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *r,
                            int *problems, int *beneath)
{
    cagd_fit_quality quality;
    *problems = ~0, *beneath = 0;
    REQUIRE(fit_is_good(data, options, r), CAGD_OK);
    const cagd_status status = cagd_fit_quality_of(data, options, r, &quality);
    REQUIRE(status == CAGD_OK, status);
    *beneath = quality.beneath != CAGD_FIT_BENEATH_NOTHING && quality.beneath != CAGD_FIT_BENEATH_DIGITS;
    *problems = quality.problems | (*beneath ? CAGD_FIT_STRUCTURE : 0);
    return CAGD_OK;
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
