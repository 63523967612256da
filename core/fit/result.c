#include "core/fit/result.h"

#include "core/fit/batch.h"
#include "core/fit/feet.h"
#include "core/fit/rank.h"
#include "core/fit/smoothing.h"
#include "core/fit/unknowns.h"
#include "core/number/limits.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

void cagd_fit_free(cagd_fit_result *r)
{
    if (r == NULL)
        return;
    free((void *)r->curve.knots);
    free((void *)r->curve.points);
    free((void *)r->curve.weights);
    free(r->relative);
    free(r->outlier);
    free(r->feet), free(r->residuals), free(r->distances), free(r->foot_at_end);
    free(r->history);
    free(r->unknown), free(r->value), free(r->at_bound);
    free(r->covariance), free(r->free_directions), free(r->determined);
    free(r->invariant), free(r->invariant_error);
    free(r->interval), free(r->interval_by);
    free(r);
}

static double *numbers(size_t count) { return calloc(count + 1, sizeof(double)); }

/* Points of the curve and of theta in the coordinates of the data. */
static int fill_curve(const fit_problem *p, const fit_attempt *a, cagd_fit_result *r)
{
    int n = p->count, dim = p->dim;
    double *knots = numbers((size_t)(n + p->degree + 1)), *points = numbers((size_t)(n * dim)),
           *weights = numbers((size_t)n);
    r->curve = (cagd_spline){p->degree, n, dim, knots, points, weights};
    r->relative = numbers((size_t)(n * dim));
    memcpy(r->origin, p->centre, sizeof r->origin);
    r->period = p->period;
    r->unknowns = p->unknowns;
    r->unknown = malloc(((size_t)p->unknowns + 1) * sizeof *r->unknown);
    r->value = numbers((size_t)p->unknowns);
    r->at_bound = calloc((size_t)p->unknowns + 1, sizeof *r->at_bound);
    if (!knots || !points || !weights || !r->relative || !r->unknown || !r->value || !r->at_bound)
        return 0;
    memcpy(knots, p->knots, (size_t)(n + p->degree + 1) * sizeof *knots);
    memcpy(weights, a->objective->curve->weights, (size_t)n * sizeof *weights);
    for (int m = 0; m < n * dim; m++) {
        r->relative[m] = p->unit * a->objective->curve->points[m];
        points[m] = p->centre[m % dim] + r->relative[m];
    }
    for (int k = 0; k < p->unknowns; k++) {
        cagd_fit_unknown u = r->unknown[k] = p->unknown[k];
        r->value[k] = u.is_weight ? log(weights[u.index]) : points[u.index * dim + u.coordinate];
        r->at_bound[k] = fit_unknown_is_on_bound(p, k, a->objective->curve);
    }
    return 1;
}

/* The feet of FIT_BATCH points that were found together. */
typedef struct batch {
    int first, known; /* known: whether they were */
    double feet[FIT_BATCH], D[FIT_BATCH][6];
} batch;

/* The foot of point i, as exact as can be, with point and derivatives there; whether it is an end that nothing holds it at. */
static int final_foot(const fit_problem *p, const fit_objective *o, int i, batch *b, double *t, double D[])
{
    if (i % FIT_BATCH == 0) {
        b->first = i;
        b->known = i + FIT_BATCH <= p->points;
        if (b->known) {
            memcpy(b->feet, o->feet + i, sizeof b->feet);
            b->known = fit_batch_feet(p, o->curve, o->width, i, b->feet, b->D);
        }
    }
    if (b->known) {
        *t = b->feet[i - b->first];
        memcpy(D, b->D[i - b->first], sizeof *b->D);
        return 0;
    }
    *t = o->feet[i];
    return !fit_held_foot(p, o->curve, i, t, D) && fit_foot(o->curve, fit_point(p, i), t, D) == FOOT_AT_END;
}

static int fill_points(const fit_problem *p, const fit_attempt *a, cagd_fit_result *r)
{
    int dim = p->dim;
    size_t count = (size_t)p->points;
    r->count = p->points;
    r->feet = numbers(count);
    r->residuals = numbers(count * (size_t)dim);
    r->distances = numbers(count);
    r->foot_at_end = calloc(count, sizeof *r->foot_at_end);
    r->outlier = calloc(count, sizeof *r->outlier);
    if (!r->feet || !r->residuals || !r->distances || !r->foot_at_end || !r->outlier)
        return 0;
    double sum = 0;
    batch room;
    memcpy(r->end_points, p->end_point, sizeof r->end_points);
    for (int i = 0; i < p->points; i++) {
        const double *q = p->Q + (size_t)i * (size_t)dim;
        double *left = r->residuals + (size_t)i * (size_t)dim, D[9], t, square = 0;
        r->foot_at_end[i] = final_foot(p, a->objective, i, &room, &t, D);
        r->feet_at_ends += r->foot_at_end[i];
        r->feet[i] = t;
        for (int c = 0; c < dim; c++) {
            left[c] = p->unit * (q[c] - D[c]);
            square += left[c] * left[c];
        }
        double side = dim == 2 ? D[2] * left[1] - D[3] * left[0] : 1;
        const double sign[] = {1, -1}, away = sqrt(square); /* which side it is nobody foresees: no branch */
        r->distances[i] = sign[side < 0] * away;
        sum += square;
        if (away > r->largest) {
            r->largest = away;
            r->largest_at = i;
        }
        r->out_of_order += !p->options->unordered && i > 0 && t < r->feet[i - 1];
    }
    r->rms = sqrt(sum / p->points);
    if (p->period > 0 && r->out_of_order > 0) /* where the points go on over the seam */
        r->out_of_order--;
    return 1;
}

/* K: the matrix of the smoothing term by the points, in units of the data as the triangle is; lambda is already in it. */
static void smoothing_matrix(const fit_problem *p, const fit_curve *curve, double K[])
{
    const int n = p->unknowns;
    double row[MAX_DEGREE + 1];
    for (int piece = 0; piece < curve->pieces; piece++)
        for (int g = 0; g < fit_smoothing_nodes(p); g++) {
            fit_smoothing_row(p, curve, piece, g, row);
            for (int a = p->support.first[piece]; a < p->support.first[piece + 1]; a++)
                for (int b = p->support.first[piece]; b < p->support.first[piece + 1]; b++)
                    if (p->local[a].coordinate == p->local[b].coordinate)
                        K[p->support.unknown[a] * n + p->support.unknown[b]] +=
                            row[p->local[a].index] * row[p->local[b].index] / (p->unit * p->unit);
        }
}

/* The statistics of a curve with a smoothing term from the triangle without it: every unknown is determined.  Returns 0 when
 * there is no memory. */
static int fill_smoothed(const fit_problem *p, const fit_attempt *a, cagd_fit_result *r)
{
    const int n = p->unknowns;
    const double *T = a->objective->triangle;
    double *K = numbers((size_t)n * (size_t)n), *H = numbers((size_t)n * (size_t)n);
    if (K != NULL && H != NULL) {
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++)
                for (int k = 0; k < n; k++)
                    r->covariance[i * n + j] += T[k * (n + 1) + i] * T[k * (n + 1) + j];
        smoothing_matrix(p, a->objective->curve, K);
        r->rank = n;
        r->effective = fit_smoothing_sandwich(n, r->covariance, K, H, 1);
        r->roughness = fit_smoothing_square(p, a->objective->curve) / p->options->smooth;
        for (int k = 0; k < n; k++)
            r->determined[k] = 1;
    }
    int good = K != NULL && H != NULL;
    free(K);
    free(H);
    return good;
}

/* Rank, covariance and flat directions; lengths go back to the coordinates of the data. */
static int fill_uncertainty(const fit_problem *p, fit_attempt *a, cagd_fit_result *r)
{
    int n = p->unknowns, held = 0;
    size_t nn = (size_t)n * (size_t)n;
    fit_objective *f = a->objective;
    fit_rank rank;
    r->covariance = numbers(nn);
    r->free_directions = numbers(nn);
    r->determined = calloc((size_t)n + 1, sizeof *r->determined);
    if (!r->covariance || !r->free_directions || !r->determined)
        return 0;
    if (n == 0)
        return 1;
    for (int k = 0; k < n; k++) {
        double g = fabs(fit_objective_gradient(f, k)) / (p->unknown[k].is_weight ? 1 : p->unit);
        r->gradient_norm = r->at_bound[k] ? r->gradient_norm : fmax(r->gradient_norm, g);
    }
    if (p->loss != CAGD_FIT_SQUARES || p->smooth > 0)
        fit_objective_evaluate(f, f->x, FIT_DISTANCES), fit_objective_by_theta(f);
    for (int k = 0; k < n; k++)
        for (int i = 0; i < n && !p->unknown[k].is_weight; i++)
            f->triangle[i * (n + 1) + k] /= p->unit;
    if (p->smooth > 0)
        return fill_smoothed(p, a, r);
    const int rows = fit_problem_equations(p), roundings = fit_problem_roundings(p);
    for (int k = 0; k < n; k++)
        held = held || r->at_bound[k];
    const int regular = held ? 0 : fit_rank_regular(n, rows, roundings, f->triangle, n + 1, r->covariance);
    if (regular > 0) {
        r->rank = n;
        r->effective = n;
        for (int k = 0; k < n; k++)
            r->determined[k] = 1;
    }
    if (regular != 0)
        return regular > 0;
    int good = fit_rank_of(n, rows, roundings, f->triangle, n + 1, r->at_bound, &rank);
    if (good) {
        r->rank = rank.rank;
        r->effective = rank.rank;
        r->flat = rank.flat;
        fit_rank_report(&rank, r->at_bound, r->covariance, r->free_directions, r->determined);
        fit_rank_free(&rank);
    }
    return good;
}

int fit_nearest_measured(const cagd_fit_data *data, const double origin[], const double P[])
{
    int nearest = 0;
    double smallest = HUGE_VAL;
    for (int i = 0; i < data->count; i++) {
        const double *Q = data->points + (size_t)i * (size_t)data->dim;
        double square = 0;
        for (int c = 0; c < data->dim; c++)
            square += (Q[c] - origin[c] - P[c]) * (Q[c] - origin[c] - P[c]);
        if (square < smallest)
            smallest = square, nearest = i;
    }
    return nearest;
}

/* What is given is not rounded by way of working coordinates.  Without an initial curve fixed ends are measured
 * points: the first and the last one, or those which the guessed order begins and ends with. */
static void restore_given_points(const cagd_fit_data *data, const cagd_fit_options *o, cagd_fit_result *r)
{
    int n = r->curve.count, dim = r->curve.dim;
    double *points = (double *)r->curve.points, *weights = (double *)r->curve.weights;
    for (int j = 0; j < n; j++) {
        int given = 1;
        if (o->free == 0) /* in no gauge */
            weights[j] = o->initial->weights != NULL ? o->initial->weights[j] : 1;
        for (int k = 0; k < r->unknowns; k++)
            given &= r->unknown[k].is_weight || r->unknown[k].index != j;
        if (!given || o->closed || (o->initial == NULL && j > 0 && j < n - 1))
            continue;
        int i = o->unordered ? fit_nearest_measured(data, r->origin, r->relative + j * dim)
                : j == 0     ? 0
                             : data->count - 1;
        const double *from = o->initial != NULL ? o->initial->points + j * dim : data->points + (size_t)i * (size_t)dim;
        memcpy(points + j * dim, from, (size_t)dim * sizeof *points);
        for (int c = 0; c < dim; c++)
            r->relative[j * dim + c] = from[c] - r->origin[c];
    }
}

/* Spacing of the measured coordinates, and whether the distances are no larger than what coordinates of the curve are
 * off by in binary64, p steps of de Casteljau on homogeneous coordinates and a division, and measured ones by their
 * rounding. */
static void fill_rounding(const cagd_fit_data *data, cagd_fit_result *r)
{
    double size = 0, rounding = 0;
    int dim = data->dim, count = data->count;
    for (int m = 0; m < r->curve.count * dim; m++)
        size = fmax(size, fabs(r->relative[m]));
    for (int c = 0; c < dim; c++) {
        double largest = 0;
        for (int i = 0; i < count; i++) {
            largest = fit_larger(largest, fabs(data->points[i * dim + c]));
            size = fit_larger(size, fabs(data->points[i * dim + c] - r->origin[c]));
        }
        r->spacing[c] = nextafter(largest, INFINITY) - largest;
        rounding = hypot(rounding, r->spacing[c] / 2);
    }
    r->points_on_curve = r->rms <= (2 * r->curve.degree + 2) * DBL_EPSILON * size + rounding;
}

/* What the minimiser did; its history is taken over. */
static void fill_minimiser(fit_minimum *m, cagd_fit_result *r)
{
    fit_outcome *outcome = &m->attempt.outcome;
    r->best_start = m->start;
    r->agreeing_starts = m->agreeing_starts;
    r->cost = m->attempt.objective->cost;
    r->initial_cost = m->attempt.initial_cost;
    r->termination = outcome->termination;
    r->iterations = outcome->iterations;
    r->steps = outcome->steps;
    r->history = outcome->history;
    outcome->history = NULL;
    memcpy(r->message, outcome->message, sizeof r->message);
}

/* Room for the invariants and for intervals, which are statistics. */
static int make_invariants(const fit_problem *p, cagd_fit_result *r)
{
    r->invariants = p->count == p->degree + 1 ? p->degree - 1 : 0;
    r->invariant = numbers((size_t)r->invariants);
    r->invariant_error = numbers((size_t)r->invariants);
    const size_t quantities = (size_t)p->unknowns + (size_t)r->invariants;
    r->interval = numbers(2 * quantities);
    r->interval_by = calloc(quantities + 1, sizeof *r->interval_by);
    return r->invariant && r->invariant_error && r->interval && r->interval_by;
}

cagd_fit_result *fit_result_make(const cagd_fit_data *data, const fit_problem *p, fit_minimum *m)
{
    fit_attempt *a = &m->attempt;
    cagd_fit_result *r = calloc(1, sizeof *r);
    if (r == NULL)
        return NULL;
    fill_minimiser(m, r);
    if (!make_invariants(p, r) || !fill_curve(p, a, r) || !fill_points(p, a, r) || !fill_uncertainty(p, a, r)) {
        cagd_fit_free(r);
        return NULL;
    }
    restore_given_points(data, p->options, r);
    fill_rounding(data, r);
    return r;
}
