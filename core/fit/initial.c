#include "core/fit/initial.h"

#include "core/fit/ceres.h"
#include "core/fit/feet.h"
#include "core/fit/rank.h"
#include "core/fit/reduction.h"
#include "core/fit/smoothing.h"
#include "core/kernels/kernels_d.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Parameters --------------------------------------------------------------------------------------- */

/* length[g]: how far along the chords between the centres of groups of points, taken in their order, the centre of
 * group g lies; length[groups]: where these chords come back to the first centre. */
static void chord_lengths(const fit_problem *p, const int order[], int groups, double length[])
{
    int n = p->points, dim = p->dim;
    double before[3] = {0};
    for (int g = 0; g <= groups; g++) {
        int part = g % groups, low = (int)((long)n * part / groups), high = (int)((long)n * (part + 1) / groups);
        double centre[3] = {0};
        for (int i = low; i < high; i++)
            for (int c = 0; c < dim; c++)
                centre[c] += fit_point(p, order[i])[c] / (high - low);
        length[g] = g > 0 ? length[g - 1] + sqrt(fit_distance_squared(dim, centre, before)) : 0;
        memcpy(before, centre, sizeof before);
    }
}

/* t: parameters between start and end, along these chords; single points may be scattered by more than they are
 * apart.  Returns 0 when there is no memory. */
static int chord_parameters(const fit_problem *p, const int order[], double start, double end, double t[])
{
    const int n = p->points, groups = n < p->strategy.chord_groups ? n : p->strategy.chord_groups,
              chords = groups - (p->period == 0), steps = n - (p->period == 0);
    double *at = malloc((size_t)(groups + 1) * sizeof *at);
    if (at == NULL)
        return 0;
    chord_lengths(p, order, groups, at);
    double length = at[chords];
    for (int i = 0; i < n; i++) {
        double place = n > 1 ? (double)i * chords / steps : 0;
        int g = (int)place < chords - 1 ? (int)place : chords - 1;
        double x = at[g] + (place - g) * (at[g + 1] - at[g]);
        t[order[i]] = start + (end - start) * (length > 0 ? x / length : (double)i / (n - 1));
    }
    free(at);
    return 1;
}

/* ---- Linear least squares ----------------------------------------------------------------------------- */

/* The points that are free, as unknowns of a linear problem. */
typedef struct free_points {
    int *column; /* of each point of the curve: its number among the free ones, or -1 */
    fit_support support;
} free_points;

static void free_points_free(free_points *f)
{
    free(f->column);
    free(f->support.first);
    free(f->support.unknown);
}

/* Returns 0 when there is no memory; free_points_free is to be called all the same. */
static int free_points_new(const fit_problem *p, const fit_curve *curve, free_points *f)
{
    int pieces = curve->pieces, degree = p->degree, at = 0;
    *f = (free_points){.column = malloc((size_t)p->count * sizeof *f->column),
                       .support.first = malloc((size_t)(pieces + 1) * sizeof *f->support.first),
                       .support.unknown = malloc((size_t)(pieces * (degree + 1)) * sizeof *f->support.unknown)};
    if (!f->column || !f->support.first || !f->support.unknown)
        return 0;
    for (int i = 0; i < p->count; i++)
        f->column[i] = -1;
    for (int k = 0; k < p->unknowns; k++)
        if (!p->unknown[k].is_weight && f->column[p->unknown[k].index] < 0)
            f->column[p->unknown[k].index] = f->support.unknowns++;
    for (int i = p->period; p->period > 0 && i < p->count; i++) /* the same points once more */
        f->column[i] = f->column[i - p->period];
    for (int k = 0; k < pieces; k++) {
        f->support.first[k] = at;
        for (int i = curve->span[k] - degree; i <= curve->span[k]; i++)
            if (f->column[i] >= 0)
                f->support.unknown[at++] = f->column[i];
    }
    f->support.first[pieces] = at;
    f->support.pieces = pieces;
    return 1;
}

/* The row of measured point i at the parameter t: sum R_j dP_j = Q_i - C(t), weighted with its precision, and with
 * sqrt(rho') of its distance from the curve as it is if `robust`. */
static void add_row(const fit_problem *p, const fit_curve *curve, const free_points *f, int i, double t, int robust,
                    fit_reduction *rows)
{
    double R[MAX_DEGREE + 1], slopes[MAX_DEGREE + 1], D[9], slope = 1;
    int piece = fit_curve_piece(curve, t), low = curve->span[piece] - p->degree, stride;
    const double *Q = fit_point(p, i), precision = p->precision[i];
    fit_curve_shares(curve, piece, t, R, slopes);
    fit_curve_derivatives(curve, t, D);
    if (robust)
        fit_problem_loss(p, fit_distance_squared(p->dim, D, Q) * precision * precision, &slope);
    double factor = precision * sqrt(slope), *row = fit_reduction_row(rows, piece, &stride);
    for (int j = 0; j <= p->degree; j++)
        if (f->column[low + j] >= 0) {
            *row = factor * R[j];
            row += stride;
        }
    for (int c = 0; c < p->dim; c++, row += stride)
        *row = factor * (Q[c] - D[c]);
}

/* The rows of the smoothing term for the changes of the points. */
static void add_smoothing(const fit_problem *p, const fit_curve *curve, const free_points *f, fit_reduction *rows)
{
    double N[MAX_DEGREE + 1];
    for (int piece = 0; piece < curve->pieces; piece++)
        for (int g = 0; g < fit_smoothing_nodes(p); g++) {
            int stride, low = curve->span[piece] - p->degree;
            double *row = fit_reduction_row(rows, piece, &stride);
            fit_smoothing_row(p, curve, piece, g, N);
            for (int j = 0; j <= p->degree; j++)
                if (f->column[low + j] >= 0) {
                    *row = N[j];
                    row += stride;
                }
            for (int c = 0; c < p->dim; c++, row += stride)
                *row = -fit_smoothing_residual(p, curve, piece, N, c);
        }
}

/* Moves the free points by the solution of smallest length of the triangle T = (R z): by R^-1, or where R may lose a rank by the
 * singular values of R that count.  work has room for 3 m^2 + m numbers, m free points.  Returns 0 when there is no memory. */
static int move_points(const fit_problem *p, const free_points *f, const double T[], double work[], fit_curve *curve)
{
    int m = f->support.unknowns, dim = p->dim, n = m + dim;
    double *A = work, *U = A + m * m, *V = U + m * m, *s = V + m * m;
    if (fit_rank_inverse(m, p->points, 0, T, n, A)) {
        for (int k = 0; k < (p->period > 0 ? p->period : p->count); k++)
            for (int i = f->column[k]; i >= 0 && i < m; i++)
                for (int c = 0; c < dim; c++)
                    curve->points[k * dim + c] += A[f->column[k] * m + i] * T[i * n + m + c];
        return 1;
    }
    for (int i = 0; i < m; i++)
        for (int j = 0; j < m; j++)
            A[i * m + j] = T[i * n + j];
    if (!fit_svd(m, A, U, s, V))
        return 0;
    double smallest = s[0] * DBL_EPSILON * p->points;
    for (int i = 0; i < m; i++)
        for (int c = 0; s[i] > smallest && c < dim; c++) {
            double along = 0;
            for (int r = 0; r < m; r++)
                along += U[r * m + i] * T[r * n + m + c];
            for (int k = 0; k < (p->period > 0 ? p->period : p->count); k++)
                if (f->column[k] >= 0)
                    curve->points[k * dim + c] += along / s[i] * V[f->column[k] * m + i];
        }
    return 1;
}

/* The free points that come closest at the parameters t; where these do not determine them, the change is the
 * smallest.  Returns 0 when there is no memory. */
static int solve_points(const fit_problem *p, const double t[], int robust, fit_curve *curve)
{
    free_points f;
    fit_reduction *rows = NULL;
    double *work = NULL;
    int good = free_points_new(p, curve, &f);
    if (good) {
        size_t m = (size_t)f.support.unknowns;
        rows = fit_reduction_new(&f.support, p->dim);
        work = malloc((3 * m * m + m + 1) * sizeof *work);
        good = rows && work;
    }
    for (int i = 0; good && i < p->points; i++)
        add_row(p, curve, &f, i, t[i], robust, rows);
    if (good)
        add_smoothing(p, curve, &f, rows);
    if (good && f.support.unknowns > 0)
        good = move_points(p, &f, fit_reduction_triangle(rows), work, curve);
    fit_curve_update(curve);
    fit_reduction_free(rows);
    free(work);
    free_points_free(&f);
    return good;
}

/* ---- Curves ------------------------------------------------------------------------------------------- */

/* Feet on the curve, and points for these feet, in turn. */
static int alternate(const fit_problem *p, fit_curve *curve, double t[])
{
    double D[9];
    for (int k = 0; k < p->strategy.alternations; k++) {
        for (int i = 0; i < p->points; i++)
            if (!fit_held_foot(p, curve, i, &t[i], D))
                fit_foot(curve, fit_point(p, i), &t[i], D);
        if (!solve_points(p, t, 1, curve))
            return 0;
    }
    return 1;
}

/* The points of the curve on the line from one point to another, as a curve without weights has them. */
static void straighten(const fit_problem *p, const double from[], const double to[], fit_curve *curve)
{
    int dim = p->dim, last = p->count - 1;
    for (int i = 0; i <= last; i++) {
        double along = bspline_greville_d(p->degree, p->knots, i) - fit_curve_start(curve);
        along /= fit_curve_end(curve) - fit_curve_start(curve);
        for (int c = 0; c < dim; c++)
            curve->points[i * dim + c] = i == last ? to[c] : from[c] + along * (to[c] - from[c]);
    }
    fit_curve_update(curve);
}

int fit_initial_curve(const fit_problem *p, const int order[], fit_curve *curve)
{
    double *t = malloc((size_t)p->points * sizeof *t);
    if (t == NULL)
        return 0;
    straighten(p, fit_point(p, order[0]), fit_point(p, order[p->period > 0 ? 0 : p->points - 1]), curve);
    int good = chord_parameters(p, order, fit_curve_start(curve), fit_curve_end(curve), t) &&
               solve_points(p, t, 0, curve) && alternate(p, curve, t);
    free(t);
    return good;
}

int fit_initial_improve(const fit_problem *p, fit_curve *curve)
{
    double cost, *t = malloc((size_t)p->points * sizeof *t);
    int good =
        t != NULL && fit_feet_search(p, curve, t, &cost) && solve_points(p, t, 1, curve) && alternate(p, curve, t);
    free(t);
    return good;
}
