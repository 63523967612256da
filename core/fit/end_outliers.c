#include "core/fit/end_outliers.h"

#include "core/fit/fit.h"
#include "core/fit/quantile.h"
#include "core/kernels/kernels_d.h"
#include "core/number/limits.h"
#include "core/require.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- the curve behind its end --------------------------------------------------------------------------- */

/* The place at t of the piece over [u_mu, u_mu+1] and of what it goes on as; share[m] = N_i w_i / sum N_j w_j, i = mu-p+m. */
typedef struct place {
    double t, C[3], share[MAX_DEGREE + 1], away[3], distance; /* away: from here to the point */
} place;

/* Returns 0 where the denominator is not positive. */
static int find_place(const cagd_fit_result *r, int mu, double t, const double q[], place *at)
{
    const cagd_spline *c = &r->curve;
    const int p = c->degree, dim = c->dim;
    double sum = 0, square = 0;
    *at = (place){.t = t};
    bspline_basis_d(p, c->knots, mu, t, at->share);
    for (int m = 0; m <= p; m++)
        sum += at->share[m] *= c->weights[mu - p + m];
    REQUIRE(sum > 0, 0);
    for (int m = 0; m <= p; m++) {
        at->share[m] /= sum;
        for (int x = 0; x < dim; x++)
            at->C[x] += at->share[m] * r->relative[(mu - p + m) * dim + x];
    }
    for (int x = 0; x < dim; x++) {
        at->away[x] = q[x] - at->C[x];
        square += at->away[x] * at->away[x];
    }
    at->distance = sqrt(square);
    return 1;
}

/* From the end of the piece in so many steps of `step`, as far as each comes nearer to q; back to the last of them.  Returns whether one did. */
static int walk(const cagd_fit_result *r, int mu, int steps, double step, const double q[], place *at)
{
    place next;
    const double start = at->t;
    int k = 1;
    while (k <= steps && find_place(r, mu, start + k * step, q, &next) && next.distance < at->distance)
        *at = next, k++;
    return k > 1;
}

/* The place nearest to q that is reached from the end without going away from q: behind the end, or on the piece.  Between two steps by thirds. */
static place nearest_place(const cagd_fit_result *r, int end, const double q[])
{
    enum { STEPS = 256, THIRDS = 80 };
    const cagd_spline *c = &r->curve;
    const int mu = end == 0 ? c->degree : c->count - 1;
    const double behind = (end == 0 ? -1 : 1) * (c->knots[mu + 1] - c->knots[mu]) / STEPS;
    place best, at, other;
    find_place(r, mu, c->knots[end == 0 ? mu : mu + 1], q, &best);
    if (!walk(r, mu, STEPS, behind, q, &best))
        walk(r, mu, STEPS, -behind, q, &best);
    double low = best.t - fabs(behind), high = best.t + fabs(behind);
    for (int k = 0; k < THIRDS; k++) {
        const double third = (high - low) / 3;
        if (!find_place(r, mu, low + third, q, &at) || !find_place(r, mu, high - third, q, &other))
            break;
        if (at.distance < other.distance)
            high -= third;
        else
            low += third;
        at = at.distance < other.distance ? at : other;
        best = at.distance < best.distance ? at : best;
    }
    return best;
}

/* n^T J V J^T n, n = away/distance. */
static double variance_across(const cagd_fit_result *r, int end, const place *at)
{
    const cagd_spline *c = &r->curve;
    const int p = c->degree, dim = c->dim, first = end == 0 ? 0 : c->count - 1 - p;
    double variance = 0;
    double *J = calloc((size_t)r->unknowns + 1, sizeof *J);
    if (J == NULL)
        return NAN;
    for (int k = 0; k < r->unknowns; k++) {
        const cagd_fit_unknown u = r->unknown[k];
        const int m = u.index - first;
        for (int x = 0; x < dim && m >= 0 && m <= p; x++) {
            const double change = u.is_weight ? r->relative[u.index * dim + x] - at->C[x] : u.coordinate == x;
            J[k] += at->share[m] * change * at->away[x] / at->distance;
        }
    }
    for (int k = 0; k < r->unknowns; k++)
        for (int l = 0; l < r->unknowns; l++)
            variance += J[k] * r->covariance[k * r->unknowns + l] * J[l];
    free(J);
    return variance;
}

/* ---- the points ------------------------------------------------------------------------------------------- */

/* The data without so many points at the start and at the end. */
static cagd_fit_data without(const cagd_fit_data *data, const int left_out[2])
{
    return (cagd_fit_data){data->count - left_out[0] - left_out[1], data->dim,
                           data->points + (size_t)left_out[0] * (size_t)data->dim,
                           data->sigma != NULL ? data->sigma + left_out[0] : NULL};
}

/* z of end_outliers.h. */
static double limit_of(int count, int dim, int freedom)
{
    const double efficiency = 0.3675; /* of the median of |x|, huber-1981, 5.1 */
    const int k = dim - 1;
    double low = 0, high = 1e3;
    for (int round = 0; round < 60; round++) {
        const double z = (low + high) / 2;
        if (count * fit_f_probability(z * z / k, k, efficiency * freedom) > 0.05)
            low = z;
        else
            high = z;
    }
    return high;
}

/* Whether point i is an outlier of the curve of the others: 1, 0, and -1 where that cannot be said. */
static int is_outlier(const cagd_fit_data *data, int i, int end, const cagd_fit_result *others, double *limit)
{
    double q[3];
    if (!cagd_fit_is_minimum(others) || others->points_on_curve || !(others->deviation > 0) ||
        others->end_points[0] < 0)
        return -1;
    for (int x = 0; x < data->dim; x++)
        q[x] = data->points[(size_t)i * (size_t)data->dim + (size_t)x] - others->origin[x];
    const place at = nearest_place(others, end, q);
    const double s = others->deviation * (data->sigma != NULL ? data->sigma[i] : 1),
                 variance = at.distance > 0 ? variance_across(others, end, &at) : 0;
    *limit = limit_of(data->count, data->dim, others->degrees_of_freedom);
    return variance >= 0 ? at.distance > *limit * sqrt(s * s + variance) : -1;
}

/* Leaves outliers out at one end as long as there are any. */
static cagd_status judge_end(const cagd_fit_data *data, int end, fit_of_data *fit, const void *how, int left_out[2],
                             cagd_fit_result **result, int judged[2], double *limit)
{
    enum { PART = 10 };
    for (int most = data->count / PART, found = 1; found == 1 && most > 0; most--) {
        cagd_fit_result *others = NULL;
        const int i = end == 0 ? left_out[0] : data->count - 1 - left_out[1];
        int ignored = -1;
        left_out[end]++;
        const cagd_fit_data fewer = without(data, left_out);
        cagd_status status = fit(&fewer, how, &others, &ignored);
        REQUIRE(status != CAGD_NO_MEMORY, status);
        found = status == CAGD_OK ? is_outlier(data, i, end, others, limit) : -1;
        judged[end] = found >= 0;
        left_out[end] -= found != 1;
        cagd_fit_free(found == 1 ? *result : others);
        if (found == 1)
            *result = others;
    }
    return CAGD_OK;
}

/* ---- what the result says of points ------------------------------------------------------------------------ */

/* An array of the points, `size` bytes each, with those that are left out before it and behind it. */
static int lengthen(void *array, size_t size, const int left_out[2], int count, const void *start, const void *end)
{
    void **old = array;
    const size_t before = (size_t)left_out[0] * size, middle = (size_t)count * size,
                 behind = (size_t)left_out[1] * size;
    char *all = malloc(before + middle + behind);
    if (all == NULL)
        return 0;
    if (before > 0)
        memcpy(all, start, before);
    memcpy(all + before, *old, middle);
    if (behind > 0)
        memcpy(all + before + middle, end, behind);
    free(*old);
    *old = all;
    return 1;
}

/* The distances of points that are left out from the curve; NULL when there is no memory or none is left out. */
static cagd_fit_result *distances_from(const cagd_fit_data *data, int first, int count, const cagd_fit_result *r)
{
    cagd_fit_result *feet = NULL;
    cagd_fit_options o = cagd_fit_defaults();
    const cagd_fit_data some = {count, data->dim, data->points + (size_t)first * (size_t)data->dim, NULL};
    o.free = 0, o.initial = &r->curve;
    if (count > 0 && fit_plainly(&some, &o, &feet, NULL) == CAGD_OK)
        for (int i = 0; i < count; i++)
            feet->outlier[i] = 1;
    return feet;
}

/* The points that are left out are told of as the others are. */
static cagd_status tell_of_all(const cagd_fit_data *data, const int left_out[2], cagd_fit_result *r)
{
    const size_t dim = (size_t)data->dim;
    cagd_fit_result *part[2];
    double sum = r->rms * r->rms * r->count;
    int good = 1;
    for (int end = 0; end < 2; end++) {
        part[end] = distances_from(data, end == 0 ? 0 : data->count - left_out[1], left_out[end], r);
        good = good && (left_out[end] == 0 || part[end] != NULL);
    }
#define LENGTHEN(array, size)                                                                                          \
    (good = good && lengthen(&r->array, size, left_out, r->count, part[0] ? part[0]->array : NULL,                     \
                             part[1] ? part[1]->array : NULL))
    LENGTHEN(feet, sizeof(double));
    LENGTHEN(residuals, dim * sizeof(double));
    LENGTHEN(distances, sizeof(double));
    LENGTHEN(foot_at_end, sizeof(int));
    LENGTHEN(outlier, sizeof(int));
#undef LENGTHEN
    r->count = data->count;
    r->largest_at += left_out[0];
    for (int end = 0; end < 2; end++) {
        r->end_points[end] += left_out[0];
        r->outliers += left_out[end];
        r->left_out[end] = left_out[end];
        if (part[end] == NULL)
            continue;
        sum += part[end]->rms * part[end]->rms * left_out[end];
        r->feet_at_ends += part[end]->feet_at_ends;
        if (part[end]->largest > r->largest) {
            r->largest = part[end]->largest;
            r->largest_at = part[end]->largest_at + (end == 0 ? 0 : data->count - left_out[1]);
        }
        cagd_fit_free(part[end]);
    }
    r->rms = sqrt(sum / data->count);
    return good ? CAGD_OK : CAGD_NO_MEMORY;
}

cagd_status fit_without_end_outliers(const cagd_fit_data *data, const cagd_fit_options *options, fit_of_data *fit,
                                     const void *how, cagd_fit_result **result, int *where)
{
    int left_out[2] = {0, 0}, judged[2] = {0, 0};
    double limit = 0;
    cagd_status status = fit(data, how, result, where);
    if (status != CAGD_OK || options->loss == CAGD_FIT_SQUARES || options->unordered || (*result)->end_points[0] < 0)
        return status;
    for (int end = 0; end < 2 && status == CAGD_OK; end++)
        status = judge_end(data, end, fit, how, left_out, result, judged, &limit);
    if (status == CAGD_OK && left_out[0] + left_out[1] > 0)
        status = tell_of_all(data, left_out, *result);
    if (status != CAGD_OK) {
        cagd_fit_free(*result);
        *result = NULL;
        return status;
    }
    memcpy((*result)->end_is_judged, judged, sizeof judged);
    (*result)->end_limit = limit;
    return CAGD_OK;
}
