#include "core/fit/initial.h"

#include "core/fit/ceres.h"
#include "core/fit/feet.h"
#include "core/fit/reduction.h"
#include "core/kernels/kernels_d.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static const double *point_of(const fit_problem *p, int i) { return p->Q + (size_t)i * (size_t)p->dim; }

/* Order ------------------------------------------------------------------------------------------------------- */

typedef struct keyed {
    double key;
    int index;
} keyed;

static int by_key(const void *a, const void *b)
{
    const keyed *x = a, *y = b;
    return x->key != y->key ? (x->key > y->key) - (x->key < y->key) : (x->index > y->index) - (x->index < y->index);
}

/* From each point to the nearest that is left, beginning at one end: the point farthest from the centre. */
static void chain(const fit_problem *p, const double centre[], int order[])
{
    int n = p->points, dim = p->dim, far = 0;
    double farthest = -1;
    for (int i = 0; i < n; i++) {
        double d = fit_distance_squared(dim, point_of(p, i), centre);
        order[i] = i;
        if (d > farthest)
            farthest = d, far = i;
    }
    order[0] = far, order[far] = 0;
    for (int i = 1; i < n; i++) {
        int best = i;
        double nearest = HUGE_VAL;
        for (int k = i; k < n; k++) {
            double d = fit_distance_squared(dim, point_of(p, order[k]), point_of(p, order[i - 1]));
            if (d < nearest)
                nearest = d, best = k;
        }
        int swap = order[i];
        order[i] = order[best];
        order[best] = swap;
    }
}

int fit_initial_order(const fit_problem *p, int guess, int order[])
{
    int n = p->points, dim = p->dim;
    double centre[3] = {0}, scatter[9] = {0}, U[9], s[3], V[9];
    keyed *list = malloc((size_t)n * sizeof *list);
    if (list == NULL)
        return 0;
    for (int i = 0; i < n; i++)
        for (int c = 0; c < dim; c++)
            centre[c] += point_of(p, i)[c] / n;
    for (int i = 0; i < n; i++)
        for (int a = 0; a < dim; a++)
            for (int b = 0; b < dim; b++)
                scatter[a * dim + b] += (point_of(p, i)[a] - centre[a]) * (point_of(p, i)[b] - centre[b]);
    int good = fit_svd(dim, scatter, U, s, V);
    for (int i = 0; good && i < n; i++) {
        double x = 0, y = 0;
        for (int c = 0; c < dim; c++) {
            x += (point_of(p, i)[c] - centre[c]) * V[c * dim];
            y += (point_of(p, i)[c] - centre[c]) * V[c * dim + 1];
        }
        list[i] = (keyed){guess == 0 ? x : atan2(y, x), i};
    }
    if (good)
        qsort(list, (size_t)n, sizeof *list, by_key);
    int from = 0;
    double widest = 0;
    for (int i = 0; good && guess == 1 && i < n; i++) {
        double before = i > 0 ? list[i - 1].key : list[n - 1].key - 2 * acos(-1);
        if (list[i].key - before > widest)
            widest = list[i].key - before, from = i;
    }
    for (int i = 0; good && i < n; i++)
        order[i] = list[(i + from) % n].index;
    if (good && guess == 2)
        chain(p, centre, order);
    free(list);
    return good;
}

/* Parameters along the chords between the centres of groups of points: single points may be scattered by more than they
 * are apart.  Returns 0 when there is no memory. */
static int chord_parameters(const fit_problem *p, const int order[], double start, double end, double t[])
{
    int n = p->points, dim = p->dim, groups = n < p->strategy.groups ? n : p->strategy.groups;
    double length = 0, before[3] = {0}, *at = malloc((size_t)groups * sizeof *at);
    if (at == NULL)
        return 0;
    for (int g = 0; g < groups; g++) {
        int low = (int)((long)n * g / groups), high = (int)((long)n * (g + 1) / groups);
        double centre[3] = {0};
        for (int i = low; i < high; i++)
            for (int c = 0; c < dim; c++)
                centre[c] += point_of(p, order[i])[c] / (high - low);
        length += g > 0 ? sqrt(fit_distance_squared(dim, centre, before)) : 0;
        at[g] = length;
        memcpy(before, centre, sizeof before);
    }
    for (int i = 0; i < n; i++) {
        double place = n > 1 ? (double)i * (groups - 1) / (n - 1) : 0;
        int g = (int)place < groups - 2 ? (int)place : groups - 2;
        double x = at[g] + (place - g) * (at[g + 1] - at[g]);
        t[order[i]] = start + (end - start) * (length > 0 ? x / length : (double)i / (n - 1));
    }
    free(at);
    return 1;
}

/* Linear least squares --------------------------------------------------------------------------------------------- */

/* The free points that come closest at the parameters t, distances weighted with sqrt(rho') of the curve as it was if
 * `robust`.  Where they are not determined, the change is the smallest. */
static int solve_points(const fit_problem *p, const double t[], int robust, fit_curve *curve)
{
    int dim = p->dim, free_points = 0, pieces = curve->pieces, degree = p->degree, good;
    int *column = malloc((size_t)p->count * sizeof *column), *first = malloc((size_t)(pieces + 1) * sizeof *first);
    int *reach = malloc((size_t)(pieces * (degree + 1)) * sizeof *reach);
    if (!column || !first || !reach) {
        free(column), free(first), free(reach);
        return 0;
    }
    for (int i = 0; i < p->count; i++)
        column[i] = -1;
    for (int k = 0; k < p->unknowns; k++)
        if (!p->unknown[k].is_weight && column[p->unknown[k].index] < 0)
            column[p->unknown[k].index] = free_points++;
    int at = 0, m = free_points, n = m + dim;
    for (int k = 0; k < pieces; k++) {
        first[k] = at;
        for (int i = curve->span[k] - degree; i <= curve->span[k]; i++)
            if (column[i] >= 0)
                reach[at++] = column[i];
    }
    first[pieces] = at;
    size_t mm = (size_t)m * (size_t)m;
    fit_reduction *rows = fit_reduction_new(m, dim, pieces, first, reach);
    double *work = malloc((3 * mm + (size_t)m + 1) * sizeof *work);
    good = rows && work;
    for (int i = 0; good && i < p->points; i++) {
        double R[MAX_DEGREE + 1], R1[MAX_DEGREE + 1], D[9], slope = 1;
        int piece = fit_curve_piece(curve, t[i]), low = curve->span[piece] - degree, stride;
        fit_curve_shares(curve, piece, t[i], R, R1);
        fit_curve_derivatives(curve, t[i], D);
        double square = fit_distance_squared(dim, D, point_of(p, i)) * p->precision[i] * p->precision[i];
        if (robust)
            fit_problem_loss(p, square, &slope);
        double factor = p->precision[i] * sqrt(slope), *row = fit_reduction_row(rows, piece, &stride);
        for (int j = 0; j <= degree; j++)
            if (column[low + j] >= 0) {
                *row = factor * R[j];
                row += stride;
            }
        for (int c = 0; c < dim; c++, row += stride)
            *row = factor * (point_of(p, i)[c] - D[c]);
    }
    if (good && m > 0) {
        const double *T = fit_reduction_triangle(rows);
        double *A = work, *U = A + mm, *V = U + mm, *s = V + mm;
        for (int i = 0; i < m; i++)
            for (int j = 0; j < m; j++)
                A[i * m + j] = T[i * n + j];
        good = fit_svd(m, A, U, s, V);
        double smallest = s[0] * DBL_EPSILON * p->points;
        for (int i = 0; good && i < m; i++)
            for (int c = 0; s[i] > smallest && c < dim; c++) {
                double along = 0;
                for (int r = 0; r < m; r++)
                    along += U[r * m + i] * T[r * n + m + c];
                for (int k = 0; k < p->count; k++)
                    if (column[k] >= 0)
                        curve->points[k * dim + c] += along / s[i] * V[column[k] * m + i];
            }
    }
    fit_curve_update(curve);
    fit_reduction_free(rows);
    free(work), free(column), free(first), free(reach);
    return good;
}

/* Feet on the curve, points for these feet, in turn; *cost: half the sum of losses of the last feet. */
static int improve(const fit_problem *p, fit_curve *curve, double t[], double *cost)
{
    double D[9], slope;
    for (int round = 0; round <= p->strategy.rounds; round++) {
        *cost = 0;
        for (int i = 0; i < p->points; i++) {
            fit_foot(curve, point_of(p, i), &t[i], D);
            double square = fit_distance_squared(p->dim, D, point_of(p, i)) * p->precision[i] * p->precision[i];
            *cost += fit_problem_loss(p, square, &slope) / 2;
        }
        if (round < p->strategy.rounds && !solve_points(p, t, 1, curve))
            return 0;
    }
    return 1;
}

int fit_initial_curve(const fit_problem *p, const int order[], fit_curve *curve, double *cost)
{
    int dim = p->dim, n = p->count - 1;
    const double *from = point_of(p, order[0]), *to = point_of(p, order[p->points - 1]);
    double *t = malloc((size_t)p->points * sizeof *t);
    if (t == NULL)
        return 0;
    for (int i = 0; i <= n; i++) {
        double along = greville_d(p->degree, p->knots, i) - fit_curve_start(curve);
        along /= fit_curve_end(curve) - fit_curve_start(curve);
        for (int c = 0; c < dim; c++)
            curve->points[i * dim + c] = i == n ? to[c] : from[c] + along * (to[c] - from[c]);
    }
    fit_curve_update(curve);
    int good = chord_parameters(p, order, fit_curve_start(curve), fit_curve_end(curve), t) &&
               solve_points(p, t, 0, curve) && improve(p, curve, t, cost) &&
               (!p->unordered || fit_feet_search(p, curve, t, cost));
    free(t);
    return good;
}

int fit_initial_improve(const fit_problem *p, fit_curve *curve)
{
    double cost, *t = malloc((size_t)p->points * sizeof *t);
    int good =
        t != NULL && fit_feet_search(p, curve, t, &cost) && solve_points(p, t, 1, curve) && improve(p, curve, t, &cost);
    free(t);
    return good;
}

/* Starts ---------------------------------------------------------------------------------------------------------- */

/* Steele, Lea and Flood's generator SplitMix64. */
static uint64_t scrambled(uint64_t x)
{
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

void fit_initial_weights(const fit_problem *p, unsigned long seed, int start, fit_curve *curve)
{
    for (int k = 0; k < p->unknowns; k++)
        if (p->unknown[k].is_weight) {
            uint64_t bits = scrambled(scrambled(scrambled(seed) + (uint64_t)start) + (uint64_t)k);
            double even = (double)(bits >> 11) * 0x1p-53; /* 0 <= even < 1 */
            double low = fmax(log(p->low), -log(p->strategy.spread)),
                   high = fmin(log(p->high), log(p->strategy.spread));
            curve->weights[p->unknown[k].index] = exp(low + even * (high - low));
        }
    fit_curve_update(curve);
}
