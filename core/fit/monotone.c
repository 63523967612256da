#include "core/fit/monotone.h"

#include "core/fit/statistics.h"
#include "core/require.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    ROUNDS = 100,   /* fits, each with other neighbours pooled                                  */
    DIVISIONS = 20, /* rounds in which pools are divided; after them they only grow, which ends */
    LEAST = 2,      /* pools, of which one alone has no extent and no curve                     */
    STEPS = 4 /* of a fit after which pools have changed: feet astray are called back before they lead the curve */
};

/* The points, of which those from first[b] to first[b+1] - 1 share a foot and are one point of `means`. */
typedef struct pools {
    const cagd_fit_data *data;
    int count, *first, *room;
    int count_fitted, *fitted; /* those of the last fit */
    double *points, *sigma, *t, *weight;
    cagd_fit_data means;
} pools;

static void pools_free(pools *p)
{
    free(p->first);
    free(p->points);
}

/* Every point by itself. */
static int pools_new(const cagd_fit_data *data, pools *p)
{
    const size_t n = (size_t)data->count, dim = (size_t)data->dim;
    *p = (pools){.data = data, .count = data->count, .first = malloc(3 * (n + 1) * sizeof *p->first)};
    p->points = malloc((dim + 3) * n * sizeof *p->points);
    if (p->first == NULL || p->points == NULL)
        return 0;
    p->room = p->first + n + 1, p->fitted = p->room + n + 1;
    p->sigma = p->points + dim * n, p->t = p->sigma + n, p->weight = p->t + n;
    for (int i = 0; i <= data->count; i++)
        p->first[i] = i;
    return 1;
}

static double weight_of(const cagd_fit_data *data, int i)
{
    return data->sigma != NULL ? 1 / (data->sigma[i] * data->sigma[i]) : 1;
}

static const double *point_of(const cagd_fit_data *data, int i) { return data->points + (size_t)i * (size_t)data->dim; }

/* The means, counted from the first of their points so that nothing is lost far from the origin. */
static void take_means(pools *p)
{
    const int dim = p->data->dim;
    for (int b = 0; b < p->count; b++) {
        const double *origin = point_of(p->data, p->first[b]);
        double *mean = p->points + (size_t)b * (size_t)dim, sum[3] = {0}, weight = 0;
        for (int i = p->first[b]; i < p->first[b + 1]; i++) {
            const double w = weight_of(p->data, i);
            weight += w;
            for (int c = 0; c < dim; c++)
                sum[c] += w * (point_of(p->data, i)[c] - origin[c]);
        }
        for (int c = 0; c < dim; c++)
            mean[c] = origin[c] + sum[c] / weight;
        p->weight[b] = weight;
        p->sigma[b] = 1 / sqrt(weight);
    }
    const int alone = p->count == p->data->count;
    p->means = alone ? *p->data : (cagd_fit_data){p->count, dim, p->points, p->sigma};
}

static void note_fitted(pools *p)
{
    p->count_fitted = p->count;
    memcpy(p->fitted, p->first, (size_t)(p->count + 1) * sizeof *p->first);
}

/* Back to the pools of the last fit; whether there were others. */
static int restore_fitted(pools *p)
{
    const size_t size = (size_t)(p->count_fitted + 1) * sizeof *p->first;
    REQUIRE(p->count != p->count_fitted || memcmp(p->first, p->fitted, size) != 0, 0);
    p->count = p->count_fitted;
    memcpy(p->first, p->fitted, size);
    take_means(p);
    return 1;
}

/* By how much the parameter falls back from a to b; over the seam of a closed curve, `length` long, in the shorter way. */
static double fall(double a, double b, double length) { return length > 0 ? remainder(a - b, length) : a - b; }

/* Neighbours whose feet fall back become one, whose foot is about their mean.  The ends of a curve that are given stay by themselves.
 * Whether there were any. */
static int pool(pools *p, double length, int ends_given)
{
    int count = 0;
    const int last = p->count - 1;
    for (int b = 0; b <= last; b++) {
        double t = p->t[b], w = p->weight[b];
        int first = p->first[b];
        while (count > 0 && fall(p->t[count - 1], t, length) > 0 && !(ends_given && (count == 1 || b == last))) {
            count--;
            t += fall(p->t[count], t, length) * p->weight[count] / (w + p->weight[count]);
            w += p->weight[count];
            first = p->room[count];
        }
        p->t[count] = t, p->weight[count] = w, p->room[count++] = first;
    }
    const int pooled = count < p->count;
    p->room[count] = p->data->count;
    memcpy(p->first, p->room, (size_t)(count + 1) * sizeof *p->first);
    p->count = count;
    return pooled;
}

/* Where, in a pool with its foot at t, the points before would go back and those behind forward by most: the index of the first one
 * behind; 0 where that is nowhere.  They do where the sum of (C - Q_i) . C'/s_i^2 over those before is positive. */
static cagd_status place_to_divide(const pools *p, const cagd_fit_result *r, int b, int *at)
{
    const int dim = p->data->dim;
    cagd_spline near = r->curve;
    double D[2 * CAGD_MAX_DIM], sum = 0, size = 0, most = 0;
    near.points = r->relative;
    const double end = near.knots[near.count], t = r->feet[b];
    cagd_status status = cagd_spline_derivatives(&near, t, t < end ? CAGD_RIGHT : CAGD_LEFT, 1, D);
    *at = 0;
    for (int i = p->first[b]; status == CAGD_OK && i + 1 < p->first[b + 1]; i++) {
        double slope = 0;
        for (int c = 0; c < dim; c++)
            slope += (D[c] - (point_of(p->data, i)[c] - r->origin[c])) * D[dim + c] * weight_of(p->data, i);
        sum += slope, size += fabs(slope);
        if (sum > most && sum > 1e-9 * size)
            most = sum, *at = i + 1;
    }
    return status;
}

/* Pools are divided, each in one place at most.  *divided: whether any was. */
static cagd_status divide(pools *p, const cagd_fit_result *r, int *divided)
{
    int count = 0;
    *divided = 0;
    for (int b = 0; b < p->count; b++) {
        int at = 0;
        if (p->first[b + 1] - p->first[b] > 1) {
            cagd_status status = place_to_divide(p, r, b, &at);
            REQUIRE(status == CAGD_OK, status);
        }
        p->room[count++] = p->first[b];
        if (at > 0)
            p->room[count++] = at, *divided = 1;
    }
    p->room[count] = p->data->count;
    memcpy(p->first, p->room, (size_t)(count + 1) * sizeof *p->first);
    p->count = count;
    return CAGD_OK;
}

/* The distance of point i, at residual[] from the foot t, with its sign. */
static double distance_of(const cagd_fit_result *r, double t, const double residual[])
{
    const int dim = r->curve.dim;
    cagd_spline near = r->curve;
    double square = 0, D[2 * CAGD_MAX_DIM] = {0};
    near.points = r->relative;
    for (int c = 0; c < dim; c++)
        square += residual[c] * residual[c];
    if (dim == 2)
        cagd_spline_derivatives(&near, t, t < near.knots[near.count] ? CAGD_RIGHT : CAGD_LEFT, 1, D);
    return dim == 2 && D[2] * residual[1] - D[3] * residual[0] < 0 ? -sqrt(square) : sqrt(square);
}

/* What the result says of the means becomes what it says of the points. */
static cagd_status expand(const pools *p, const cagd_fit_options *options, cagd_fit_result *r)
{
    const cagd_fit_data *data = p->data;
    const int n = data->count, dim = data->dim;
    const size_t points = (size_t)n;
    double *feet = malloc(points * sizeof *feet), *residuals = malloc(points * (size_t)dim * sizeof *residuals),
           *distances = malloc(points * sizeof *distances), sum = 0, within = 0;
    int *at_end = calloc(points, sizeof *at_end), *outlier = calloc(points, sizeof *outlier);
    if (!feet || !residuals || !distances || !at_end || !outlier) {
        free(feet), free(residuals), free(distances), free(at_end), free(outlier);
        return CAGD_NO_MEMORY;
    }
    r->largest = 0, r->feet_at_ends = 0;
    for (int b = 0; b < p->count; b++)
        for (int i = p->first[b]; i < p->first[b + 1]; i++) {
            double *left = residuals + (size_t)i * (size_t)dim, square = 0;
            for (int c = 0; c < dim; c++) {
                const double more = point_of(data, i)[c] - point_of(&p->means, b)[c];
                left[c] = r->residuals[b * dim + c] + more;
                square += left[c] * left[c];
                within += more * more * weight_of(data, i);
            }
            feet[i] = r->feet[b];
            distances[i] = p->first[b + 1] - p->first[b] > 1 ? distance_of(r, feet[i], left) : r->distances[b];
            r->feet_at_ends += at_end[i] = r->foot_at_end[b];
            sum += square;
            if (sqrt(square) > r->largest)
                r->largest = sqrt(square), r->largest_at = i;
        }
    free(r->feet), free(r->residuals), free(r->distances), free(r->foot_at_end), free(r->outlier);
    r->feet = feet, r->residuals = residuals, r->distances = distances, r->foot_at_end = at_end, r->outlier = outlier;
    r->count = n;
    r->tied = n - p->count;
    r->rms = sqrt(sum / n);
    r->points_on_curve = 0;
    r->cost += within / 2, r->initial_cost += within / 2;
    for (int end = 0; end < 2; end++)
        r->end_points[end] = r->end_points[end] < 0 ? -1 : end == 0 ? 0 : n - 1;
    /* The means have standard deviations, whether the points have some or not: the covariance is (J^T J)^+ still. */
    fit_statistics(data, options, r);
    for (int q = 0; q < r->unknowns + r->invariants; q++)
        r->interval_by[q] = CAGD_FIT_INTERVAL_NOT_SOUGHT;
    return CAGD_OK;
}

/* The last curve, on which feet fall back that cannot be shared. */
static void give_up(cagd_fit_result *r)
{
    r->termination = CAGD_FIT_NOT_CONVERGED;
    snprintf(
        r->message, sizeof r->message,
        "Feet that fall back are shared until too few are left for so many unknowns, or without end; fewer control "
        "points help.");
}

cagd_status fit_monotone(const cagd_fit_data *data, const cagd_fit_options *options, const fit_strategy *strategy,
                         fit_of_points *fit, cagd_fit_result **result, int *where)
{
    pools p;
    fit_strategy quick = *strategy;
    cagd_fit_options next = *options;
    cagd_fit_result *last = NULL;
    const int ends_given = !options->closed && !(options->free & CAGD_FIT_END_POINTS);
    cagd_status status = pools_new(data, &p) ? CAGD_OK : CAGD_NO_MEMORY;
    quick.intervals = 0;
    for (int round = 0, whole = 0, done = 0; status == CAGD_OK && !done && round < ROUNDS; round++) {
        cagd_fit_result *one = NULL;
        int divided = 0, pooled = 0;
        take_means(&p);
        if (p.count < LEAST && last != NULL)
            break;
        next.max_iterations = whole || options->max_iterations < STEPS ? options->max_iterations : STEPS;
        status = fit(&p.means, &next, whole && p.count == data->count ? strategy : &quick, &one, where);
        if (status == CAGD_TOO_FEW && last != NULL) {
            status = CAGD_OK;
            break;
        }
        cagd_fit_free(last);
        last = one;
        if (status != CAGD_OK)
            break;
        note_fitted(&p);
        next.initial = &last->curve, next.starts = 1;
        const double length =
            last->period > 0 ? last->curve.knots[last->curve.count] - last->curve.knots[last->curve.degree] : 0;
        if (round < DIVISIONS)
            status = divide(&p, last, &divided);
        if (status == CAGD_OK && !divided) {
            memcpy(p.t, last->feet, (size_t)p.count * sizeof *p.t);
            pooled = pool(&p, length, ends_given);
        }
        done = whole && !divided && !pooled;
        whole = !divided && !pooled;
    }
    if (status == CAGD_OK && restore_fitted(&p))
        give_up(last);
    if (status == CAGD_OK && p.count < data->count)
        status = expand(&p, options, last);
    if (status == CAGD_OK)
        *result = last;
    else
        cagd_fit_free(last);
    pools_free(&p);
    return status;
}
