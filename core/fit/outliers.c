#include "core/fit/outliers.h"

#include "core/fit/statistics.h"

#include <math.h>
#include <stdlib.h>

/* The distance of point i in units of its standard deviation, or as it is. */
static double distance_of(const cagd_fit_data *data, const cagd_fit_result *r, int i)
{
    return fabs(r->distances[i]) / (data->sigma != NULL ? data->sigma[i] : 1);
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double fit_robust_deviation(const cagd_fit_data *data, const cagd_fit_result *r)
{
    const int n = data->count, freedom = r->degrees_of_freedom;
    double *distances = malloc((size_t)n * sizeof *distances);
    if (distances == NULL)
        return NAN;
    for (int i = 0; i < n; i++)
        distances[i] = distance_of(data, r, i);
    qsort(distances, (size_t)n, sizeof *distances, by_size);
    double median = (distances[(n - 1) / 2] + distances[n / 2]) / 2;
    free(distances);
    double of_normal = data->dim == 2 ? 0.67448975019608174 : 1.17741002251547469;
    return freedom > 0 ? median / of_normal * sqrt(1 + fit_counted_unknowns(r) / (double)freedom) : 0; /* n/(n - k) */
}

double fit_loss_scale_of(cagd_fit_loss loss, double deviation)
{
    return deviation * (loss == CAGD_FIT_HUBER ? 1.345 : 2.385);
}

/* z with N P = 0.05, P the probability that a point is farther than z. */
static double limit_of(int count, int dim)
{
    double low = 0, high = 40;
    if (dim == 3)
        return sqrt(2 * log(count / 0.05));
    for (int k = 0; k < 60; k++) {
        double middle = (low + high) / 2;
        if (count * erfc(middle / sqrt(2)) > 0.05)
            low = middle;
        else
            high = middle;
    }
    return high;
}

int fit_outliers(const cagd_fit_data *data, const cagd_fit_options *o, cagd_fit_result *r)
{
    double sum = 0;
    r->rms_of_others = r->rms;
    if (o->loss == CAGD_FIT_SQUARES)
        return 1;
    r->deviation = fit_robust_deviation(data, r);
    r->outlier_limit = limit_of(data->count, data->dim);
    if (isnan(r->deviation))
        return 0;
    for (int i = 0; i < data->count; i++) {
        r->outlier[i] =
            !r->points_on_curve && r->deviation > 0 && distance_of(data, r, i) > r->outlier_limit * r->deviation;
        r->outliers += r->outlier[i];
        sum += r->outlier[i] ? 0 : r->distances[i] * r->distances[i];
    }
    r->rms_of_others = sqrt(sum / (data->count - r->outliers));
    return 1;
}
