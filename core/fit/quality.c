#include "core/fit/cagd_fit.h"

#include "core/fit/beneath.h"
#include "core/fit/candidate.h"
#include "core/fit/detour.h"
#include "core/fit/outliers.h"
#include "core/require.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* quality.c -- what is not good about a fit. */

enum { SIDES = 600, PER_PIECE = 24, FEW = 30 };

static const double BY_CHANCE = 0.01, HARDLY_BY_CHANCE = 0.001, PART = 0.1, USUAL = 4, MANY = 0.05, DEVIATIONS = 6,
                    COARSE = 0.02, STRAY = 10;

typedef struct polygon {
    int corners, dim;
    double *at;      /* corner i: at[i*dim + c]             */
    double *t, *way; /* its parameter, and how far it is along */
} polygon;

static double distance(int dim, const double a[], const double b[])
{
    double sum = 0;
    for (int c = 0; c < dim; c++)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sqrt(sum);
}

static int polygon_new(int corners, int dim, polygon *p)
{
    *p = (polygon){corners, dim, malloc((size_t)corners * ((size_t)dim + 2) * sizeof *p->at), NULL, NULL};
    if (p->at == NULL)
        return 0;
    p->t = p->at + (size_t)corners * (size_t)dim;
    p->way = p->t + corners;
    return 1;
}

/* The polygon inscribed in the curve, PER_PIECE sides or as many as SIDES allows over every segment. */
static cagd_status inscribe(const cagd_fit_result *r, polygon *p)
{
    cagd_spline near = r->curve;
    int segments = 0, at = 0;
    near.points = r->relative;
    for (int mu = near.degree; mu < near.count; mu++)
        segments += near.knots[mu] < near.knots[mu + 1];
    const int per = segments * PER_PIECE > SIDES ? SIDES / segments + 1 : PER_PIECE;
    cagd_status status = CAGD_OK;
    cagd_curve *curve = cagd_curve_new(&near, &status, NULL);
    if (status == CAGD_OK && !polygon_new(segments * per + 1, near.dim, p))
        status = CAGD_NO_MEMORY;
    for (int mu = near.degree; status == CAGD_OK && mu < near.count; mu++) {
        const double a = near.knots[mu], b = near.knots[mu + 1];
        for (int i = at == 0 ? 0 : 1; i <= per && a < b; i++, at++) {
            p->t[at] = i < per ? a + (b - a) * i / per : b;
            if (status == CAGD_OK)
                status = cagd_curve_point(curve, p->t[at], i < per ? CAGD_RIGHT : CAGD_LEFT, p->at + at * near.dim);
            p->way[at] =
                at > 0 ? p->way[at - 1] + distance(near.dim, p->at + at * near.dim, p->at + (at - 1) * near.dim) : 0;
        }
    }
    cagd_curve_free(curve);
    return status;
}

/* The polygon of the means of neighbours, of SIDES at most. */
static cagd_status of_points(const cagd_fit_data *data, const cagd_fit_result *r, polygon *p)
{
    const int n = r->count, groups = n < SIDES ? n : SIDES, dim = data->dim, closed = r->period > 0;
    REQUIRE(polygon_new(groups + closed, dim, p), CAGD_NO_MEMORY);
    memset(p->at, 0, (size_t)((groups + closed) * dim) * sizeof *p->at);
    for (int g = 0; g < groups; g++) {
        const int low = (int)((long)n * g / groups), high = (int)((long)n * (g + 1) / groups);
        for (int i = low; i < high; i++)
            for (int c = 0; c < dim; c++)
                p->at[g * dim + c] += (data->points[(size_t)i * (size_t)dim + (size_t)c] - r->origin[c]) / (high - low);
    }
    if (closed)
        memcpy(p->at + groups * dim, p->at, (size_t)dim * sizeof *p->at);
    return CAGD_OK;
}

static double side_of(const double a[], const double b[], const double q[])
{
    return (b[0] - a[0]) * (q[1] - a[1]) - (b[1] - a[1]) * (q[0] - a[0]);
}

/* How far q is from the corners low, ..., high of a polygon of the plane and the sides between them. */
static double distance_from(const polygon *p, int low, int high, const double q[])
{
    double nearest = distance(2, p->at + 2 * low, q);
    for (int i = low; i < high; i++) {
        const double *a = p->at + 2 * i, x = a[2] - a[0], y = a[3] - a[1], square = x * x + y * y;
        const double s = square > 0 ? fmin(1, fmax(0, ((q[0] - a[0]) * x + (q[1] - a[1]) * y) / square)) : 0;
        nearest = fmin(nearest, hypot(a[0] + s * x - q[0], a[1] + s * y - q[1]));
    }
    return nearest;
}

/* Whether sides i < j of an open polygon cross where its two ends come together, as at the trailing edge of an airfoil (翼型后缘): from there to the
 * ends the one is no farther from the other than `within`. */
static int is_where_ends_meet(const polygon *p, int i, int j, double within)
{
    const int last = p->corners - 1;
    for (int k = 0; k <= i; k++)
        REQUIRE(distance_from(p, j, last, p->at + 2 * k) <= within, 0);
    for (int k = j + 1; k <= last; k++)
        REQUIRE(distance_from(p, 0, i + 1, p->at + 2 * k) <= within, 0);
    return 1;
}

/* How often a polygon of the plane crosses itself; sides that have a corner in common do not count, nor what happens within errors where the ends of
 * an open one come together. */
static int crossings_of(const polygon *p, int closed, double within)
{
    int count = 0;
    for (int i = 0; i + 1 < p->corners; i++)
        for (int j = i + 2; j + 1 < p->corners - (closed && i == 0); j++) {
            const double *a = p->at + 2 * i, *b = a + 2, *c = p->at + 2 * j, *d = c + 2;
            count += side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0 &&
                     (closed || !is_where_ends_meet(p, i, j, within));
        }
    return count;
}

/* How far along the curve the parameter t is. */
static double way_to(const polygon *p, double t)
{
    int low = 0, high = p->corners - 1;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        *(t < p->t[middle] ? &high : &low) = middle;
    }
    double part = (t - p->t[low]) / (p->t[high] - p->t[low]);
    return p->way[low] + part * (p->way[high] - p->way[low]);
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The widest gap between neighbouring feet.  Of a closed curve the last foot and the first one are neighbours. */
static cagd_status find_gap(const cagd_fit_result *r, const polygon *p, cagd_fit_quality *q)
{
    const int n = r->count;
    double *t = malloc(2 * ((size_t)n + 1) * sizeof *t), *step = t + n + 1, length = p->way[p->corners - 1];
    REQUIRE(t != NULL, CAGD_NO_MEMORY);
    memcpy(t, r->feet, (size_t)n * sizeof *t);
    qsort(t, (size_t)n, sizeof *t, by_size);
    for (int i = 1; i < n; i++) {
        step[i - 1] = way_to(p, t[i]) - way_to(p, t[i - 1]);
        if (step[i - 1] > q->gap * length)
            q->gap = step[i - 1] / length, q->gap_from = t[i - 1], q->gap_to = t[i];
    }
    const double over = length - way_to(p, t[n - 1]) + way_to(p, t[0]);
    if ((r->period > 0 || r->found.ellipse.whole) && over > q->gap * length)
        q->gap = over / length, q->gap_from = t[n - 1], q->gap_to = t[0];
    qsort(step, (size_t)n - 1, sizeof *step, by_size);
    if (n > 2 && q->gap > PART && q->gap * length > USUAL * step[(n - 1) / 2])
        q->problems |= CAGD_FIT_GAPS;
    free(t);
    return CAGD_OK;
}

/* Feet that fall behind the one before, along the curve, by more than errors explain.  Neighbours with errors of rms along the curve differ
 * by sqrt(2) rms, the most of n of them by 2 sqrt(log n) rms, 6 rms of 8000, and where the curve bends towards them by a few times as much: one
 * alone has to go back twice as far. */
static void find_backwards(const cagd_fit_result *r, const polygon *p, cagd_fit_quality *q)
{
    const double length = p->way[p->corners - 1];
    double farthest = 0;
    for (int i = 1; i < r->count; i++) {
        double back = way_to(p, r->feet[i - 1]) - way_to(p, r->feet[i]);
        if (r->period > 0 || r->found.ellipse.whole) /* over the seam */
            back = remainder(back, length);
        q->backwards += back > DEVIATIONS * r->rms + length * 1e-9;
        farthest = fmax(farthest, back);
    }
    if (q->backwards >= MANY * r->count || (farthest > 2 * DEVIATIONS * r->rms && farthest > PART * length))
        q->problems |= CAGD_FIT_BACKWARDS;
}

/* A detour between neighbouring feet. */
static cagd_status find_detour(const cagd_fit_result *r, cagd_fit_quality *q)
{
    fit_detour detour;
    const cagd_status status = fit_detour_of(r, r->period > 0 || r->found.ellipse.whole, &detour);
    q->detour = detour.length, q->detour_from = detour.from, q->detour_to = detour.to;
    q->problems |= detour.length > 0 ? CAGD_FIT_EXCURSIONS : 0;
    return status;
}

/* What is large against the extent of the points: a control point's distance from their middle; of few points the distances. */
static void find_far(const cagd_fit_data *data, const cagd_fit_result *r, cagd_fit_quality *q)
{
    double middle[3], farthest = 0;
    const int dim = data->dim;
    const double extent = fit_extent_of(data, middle);
    for (int c = 0; c < dim; c++)
        middle[c] -= r->origin[c];
    for (int j = 0; j < r->curve.count && !r->found.ellipse.known; j++) {
        double d = distance(dim, r->relative + j * dim, middle);
        if (d > 1.5 * extent && d > farthest)
            farthest = d, q->far = j;
    }
    if (q->far >= 0)
        q->problems |= CAGD_FIT_FAR;
    if (data->sigma == NULL && (q->runs.pairs < FEW || r->roughness > 0) && r->rms > COARSE * extent)
        q->problems |= CAGD_FIT_COARSE;
}

/* The distance of a point in deviations; infinite beyond the ends. */
static double in_deviations(const cagd_fit_data *data, const cagd_fit_result *r, double deviation, int i)
{
    return i >= 0 && i < r->count ? fabs(r->distances[i]) / deviation / (data->sigma != NULL ? data->sigma[i] : 1)
                                  : INFINITY;
}

/* Of a point farther than STRAY whether it is so alone, or with at most two neighbours of more than half of that, where those beside them are within
 * two deviations: a jump and back.  Where the curve has missed something, as a corner, distances grow towards it. */
static int is_jump(const cagd_fit_data *data, const cagd_fit_result *r, double deviation, int i)
{
    enum { LONGEST_JUMP = 3 };
    const double quiet = 2;
    int low = i, high = i;
    if (!(in_deviations(data, r, deviation, i - 1) > STRAY && i > 0) &&
        !(in_deviations(data, r, deviation, i + 1) > STRAY && i + 1 < r->count))
        return 1;
    while (low > 0 && in_deviations(data, r, deviation, low - 1) > STRAY / 2)
        low--;
    while (high + 1 < r->count && in_deviations(data, r, deviation, high + 1) > STRAY / 2)
        high++;
    return high - low < LONGEST_JUMP && in_deviations(data, r, deviation, low - 1) <= quiet &&
           in_deviations(data, r, deviation, high + 1) <= quiet;
}

/* Points that errors of another kind have put far off.  Where most of them are no jumps the curve has missed something. */
static cagd_status find_strays(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *r,
                               cagd_fit_quality *q)
{
    if (options->loss != CAGD_FIT_SQUARES || r->points_on_curve || r->degrees_of_freedom < FEW)
        return CAGD_OK;
    const double deviation = fit_robust_deviation(data, r);
    int jumps = 0, far = 0;
    REQUIRE(!isnan(deviation), CAGD_NO_MEMORY);
    for (int i = 0; i < r->count && deviation > 0; i++) {
        if (!(in_deviations(data, r, deviation, i) > STRAY))
            continue;
        if (far < CAGD_FIT_STRAYS)
            q->stray[far] = i;
        jumps += is_jump(data, r, deviation, i);
        far++;
    }
    q->strays = far <= PART * r->count && 2 * jumps > far ? far : 0;
    return CAGD_OK;
}

/* Whether the given deviations are too small for the distances, which is a problem, or too large.  The cube root of chi-squared over its degrees
 * of freedom is about normal.  Source: wilson-hilferty-1931. */
static void find_deviations(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *r,
                            cagd_fit_quality *q)
{
    const double d = r->degrees_of_freedom, part = 2 / (9 * d);
    if (data->sigma == NULL || options->loss != CAGD_FIT_SQUARES || !(d > 0))
        return;
    const double z = (cbrt(r->chi_squared / d) - (1 - part)) / sqrt(part);
    q->problems |= erfc(z / sqrt(2)) / 2 < HARDLY_BY_CHANCE ? CAGD_FIT_DEVIATIONS : 0;
    q->too_large = erfc(-z / sqrt(2)) / 2 < HARDLY_BY_CHANCE;
}

/* Whether the distances are a wave.  Of a curve with more than a fourth as many unknowns as the points say things the fit itself makes the distances
 * that are left alike, and nothing is said. */
static int is_wave(const cagd_fit_data *data, const cagd_fit_result *r, const cagd_fit_runs *runs)
{
    return 4 * fit_unknowns_of(r) <= fit_equations_of(data) &&
           (runs->next_probability < BY_CHANCE || runs->lag_probability < HARDLY_BY_CHANCE);
}

/* Structure: a problem unless all distances are beneath what the points are given to. */
static void find_structure(const cagd_fit_data *data, const cagd_fit_result *r, cagd_fit_quality *q)
{
    const int structure = !r->points_on_curve && (q->runs.probability < BY_CHANCE ||
                                                  q->runs.local_probability < BY_CHANCE || is_wave(data, r, &q->runs));
    q->beneath = structure ? fit_beneath(data, r) : CAGD_FIT_BENEATH_NOTHING;
    q->problems |= structure && q->beneath == CAGD_FIT_BENEATH_NOTHING ? CAGD_FIT_STRUCTURE : 0;
}

cagd_status cagd_fit_quality_of(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *r,
                                cagd_fit_quality *q)
{
    polygon curve = {0}, points = {0};
    cagd_fit_data own = *data;
    own.count = r->count;
    *q = (cagd_fit_quality){.length_ratio = NAN, .far = -1};
    cagd_status status = inscribe(r, &curve);
    if (status == CAGD_OK)
        status = of_points(&own, r, &points);
    if (status == CAGD_OK)
        status = cagd_fit_runs_of(&own, options, r, &q->runs);
    if (status == CAGD_OK && r->count > 1)
        status = find_gap(r, &curve, q);
    if (status == CAGD_OK && r->count > 1 && options->free != 0)
        status = find_detour(r, q);
    if (status == CAGD_OK)
        status = find_strays(&own, options, r, q);
    if (status == CAGD_OK) {
        if (!options->unordered && options->free != 0) {
            q->length_ratio = cagd_fit_length_ratio(&own, r);
            find_backwards(r, &curve, q);
            if (data->dim == 2) {
                const int closed = r->period > 0 || r->found.ellipse.whole;
                q->crossings = crossings_of(&curve, closed, DEVIATIONS * r->rms);
                q->crossings_of_points = crossings_of(&points, closed, DEVIATIONS * r->rms);
            }
        }
        find_far(&own, r, q);
        q->problems |= q->length_ratio > CAGD_FIT_LONGEST_RATIO ? CAGD_FIT_EXCURSIONS : 0;
        q->detour = q->length_ratio > CAGD_FIT_LONGEST_RATIO ? 0 : q->detour; /* of one of many nothing is said */
        q->problems |= q->crossings > q->crossings_of_points ? CAGD_FIT_LOOPS : 0;
        find_structure(&own, r, q);
        find_deviations(&own, options, r, q);
    }
    free(curve.at);
    free(points.at);
    return status == CAGD_NO_MEMORY ? status : CAGD_OK;
}
