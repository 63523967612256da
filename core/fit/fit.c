#include "core/fit/cagd_fit.h"

#include "core/fit/ceres.h"
#include "core/fit/initial.h"
#include "core/fit/objective.h"
#include "core/fit/rank.h"
#include "core/fit/statistics.h"
#include "core/kernels_d.h"

#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *cagd_fit_status_text(cagd_fit_status status)
{
    switch (status) {
    case CAGD_FIT_OK:
        return "no error";
    case CAGD_FIT_BAD_DATA:
        return "a coordinate is not finite, a standard deviation is not positive, or the dimension is not 2 or 3";
    case CAGD_FIT_BAD_OPTIONS:
        return "an option is outside its range";
    case CAGD_FIT_BAD_CURVE:
        return "the initial curve or the knots are not those of a clamped, continuous curve with positive weights";
    case CAGD_FIT_TOO_FEW:
        return "there are fewer equations than unknowns";
    case CAGD_FIT_ALL_EQUAL:
        return "all points are equal";
    case CAGD_FIT_NO_MEMORY:
        return "there is not enough memory";
    case CAGD_FIT_OUT_OF_RANGE:
        return "coordinates or standard deviations are so large or so small that squared distances leave the range of "
               "numbers";
    }
    return "unknown status";
}

cagd_fit_options cagd_fit_defaults(void)
{
    return (cagd_fit_options){.degree = 2,
                              .free = CAGD_FIT_WEIGHTS | CAGD_FIT_INNER_POINTS,
                              .loss = CAGD_FIT_SQUARES,
                              .loss_scale = 1,
                              .weight_low = 0,
                              .weight_high = INFINITY,
                              .starts = 1,
                              .seed = 1,
                              .tolerance = 1e-14,
                              .max_iterations = 200,
                              .method = CAGD_FIT_ELIMINATED};
}

/* ---- The problem ------------------------------------------------------------------------------------------- */

#define REQUIRE(condition, status)                                                                                     \
    do {                                                                                                               \
        if (!(condition))                                                                                              \
            return status;                                                                                             \
    } while (0)

static cagd_fit_status check_options(const cagd_fit_options *o)
{
    const int all = CAGD_FIT_WEIGHTS | CAGD_FIT_INNER_POINTS | CAGD_FIT_END_POINTS;
    REQUIRE(o->free != 0 && (o->free & ~all) == 0, CAGD_FIT_BAD_OPTIONS);
    REQUIRE(o->loss == CAGD_FIT_SQUARES || o->loss == CAGD_FIT_HUBER || o->loss == CAGD_FIT_CAUCHY,
            CAGD_FIT_BAD_OPTIONS);
    REQUIRE(isfinite(o->loss_scale) && o->loss_scale > 0, CAGD_FIT_BAD_OPTIONS);
    REQUIRE(o->weight_low >= 0 && o->weight_low < 1 && o->weight_high > 1, CAGD_FIT_BAD_OPTIONS);
    REQUIRE(o->starts >= 1 && o->max_iterations >= 1, CAGD_FIT_BAD_OPTIONS);
    REQUIRE(isfinite(o->tolerance) && o->tolerance > 0, CAGD_FIT_BAD_OPTIONS);
    REQUIRE(o->method == CAGD_FIT_ELIMINATED || o->method == CAGD_FIT_PLAIN, CAGD_FIT_BAD_OPTIONS);
    REQUIRE(o->initial != NULL || (o->free & CAGD_FIT_INNER_POINTS) || o->degree == 1, CAGD_FIT_BAD_OPTIONS);
    return CAGD_FIT_OK;
}

static cagd_fit_status check_data(const cagd_fit_data *data, int *where)
{
    REQUIRE(data->points != NULL && data->count >= 0 && (data->dim == 2 || data->dim == 3), CAGD_FIT_BAD_DATA);
    int equal = 1;
    for (int i = 0; i < data->count; i++)
        for (int c = 0; c < data->dim; c++) {
            double x = data->points[(size_t)i * (size_t)data->dim + (size_t)c];
            *where = i;
            REQUIRE(isfinite(x), CAGD_FIT_BAD_DATA);
            equal = equal && x == data->points[c];
        }
    for (int i = 0; data->sigma != NULL && i < data->count; i++) {
        *where = i;
        REQUIRE(isfinite(data->sigma[i]) && data->sigma[i] > 0, CAGD_FIT_BAD_DATA);
    }
    *where = -1;
    REQUIRE(data->count >= 2, CAGD_FIT_TOO_FEW);
    REQUIRE(!equal, CAGD_FIT_ALL_EQUAL);
    return CAGD_FIT_OK;
}

static void problem_free(fit_problem *p)
{
    free(p->Q);
    free(p->precision);
    free(p->knots);
    free(p->unknown);
    free(p->first);
    free(p->reach);
    free(p->slot);
}

/* Knots of the initial curve, or as given, or even. */
static cagd_fit_status make_knots(const cagd_fit_options *o, fit_problem *p)
{
    const cagd_spline *initial = o->initial;
    const double *knots = initial != NULL ? initial->knots : o->knots;
    p->degree = initial != NULL ? initial->degree : o->degree;
    p->count = initial != NULL ? initial->count : o->count != 0 ? o->count : o->degree + 1;
    int n = p->count, d = p->degree, given = initial != NULL || (o->knots != NULL);
    REQUIRE(d >= 1 && d <= MAX_DEGREE, initial != NULL ? CAGD_FIT_BAD_CURVE : CAGD_FIT_BAD_OPTIONS);
    REQUIRE(n > d, initial != NULL ? CAGD_FIT_BAD_CURVE : CAGD_FIT_BAD_OPTIONS);
    REQUIRE(!given || knots != NULL, CAGD_FIT_BAD_CURVE);
    p->knots = malloc((size_t)(n + d + 1) * sizeof *p->knots);
    REQUIRE(p->knots != NULL, CAGD_FIT_NO_MEMORY);
    for (int i = 0; i <= n + d; i++)
        p->knots[i] = given ? knots[i] : i <= d ? 0 : i >= n ? 1 : (double)(i - d) / (n - d);
    double one = 0;
    cagd_spline basis = {d, n, 1, p->knots, &one, NULL};
    int span;
    REQUIRE(cagd_spline_span(&basis, p->knots[d], CAGD_RIGHT, &span) == CAGD_OK, CAGD_FIT_BAD_CURVE);
    REQUIRE(p->knots[0] == p->knots[d] && p->knots[n] == p->knots[n + d], CAGD_FIT_BAD_CURVE);
    for (int i = d + 1; i + d < n; i++) /* an inner knot of multiplicity p+1 breaks the curve */
        REQUIRE(p->knots[i] < p->knots[i + d], CAGD_FIT_BAD_CURVE);
    return CAGD_FIT_OK;
}

/* The unknowns in the order of the points: for each its weight, then its coordinates. */
static cagd_fit_status make_unknowns(const cagd_fit_options *o, fit_problem *p)
{
    int n = p->count, d = p->degree, one_span = n == d + 1;
    p->unknown = malloc((size_t)(n * (p->dim + 1)) * sizeof *p->unknown);
    p->first = malloc((size_t)(n - d + 1) * sizeof *p->first);
    p->reach = malloc((size_t)((n - d) * (d + 1) * (p->dim + 1)) * sizeof *p->reach);
    p->slot = malloc((size_t)((n - d) * (d + 1) * (p->dim + 1)) * sizeof *p->slot);
    REQUIRE(p->unknown && p->first && p->reach && p->slot, CAGD_FIT_NO_MEMORY);
    for (int i = 0; i < n; i++) {
        int end = i == 0 || i == n - 1, gauge = i == 0 || (one_span && i == n - 1);
        if (o->free & CAGD_FIT_WEIGHTS && !gauge)
            p->unknown[p->unknowns++] = (cagd_fit_unknown){1, i, 0};
        for (int c = 0; o->free & (end ? CAGD_FIT_END_POINTS : CAGD_FIT_INNER_POINTS) && c < p->dim; c++)
            p->unknown[p->unknowns++] = (cagd_fit_unknown){0, i, c};
    }
    REQUIRE(p->unknowns > 0, CAGD_FIT_BAD_OPTIONS);
    int pieces = 0, at = 0;
    for (int mu = d; mu < n; mu++) {
        if (!(p->knots[mu] < p->knots[mu + 1]))
            continue;
        p->first[pieces++] = at;
        for (int k = 0; k < p->unknowns; k++)
            if (mu - d <= p->unknown[k].index && p->unknown[k].index <= mu) {
                p->slot[at] = p->unknown[k];
                p->slot[at].index -= mu - d;
                p->reach[at++] = k;
            }
    }
    p->first[pieces] = at;
    return CAGD_FIT_OK;
}

/* Squared distances, their sum, and the square of what rounding makes of a distance, 2^-106 of it, are numbers without underflow
 * or overflow when the distance lies between 2^-400 and 2^400: 2*400 + 31 < 1024 and 2*400 + 106 < 1022. */
enum { RANGE = 400 };
static int in_range(double x) { return x >= ldexp(1, -RANGE) && x <= ldexp(1, RANGE); }

static cagd_fit_status make_points(const cagd_fit_data *data, fit_problem *p, int *where)
{
    int dim = data->dim, e;
    size_t numbers = (size_t)data->count * (size_t)dim;
    double low[3], high[3], extent = 0;
    p->points = data->count;
    p->dim = dim;
    p->Q = malloc(numbers * sizeof *p->Q);
    p->precision = malloc((size_t)data->count * sizeof *p->precision);
    REQUIRE(p->Q && p->precision, CAGD_FIT_NO_MEMORY);
    for (int c = 0; c < dim; c++) {
        low[c] = high[c] = data->points[c];
        for (int i = 1; i < data->count; i++) {
            double x = data->points[(size_t)i * (size_t)dim + (size_t)c];
            low[c] = fmin(low[c], x);
            high[c] = fmax(high[c], x);
        }
        extent = fmax(extent, high[c] / 2 - low[c] / 2);
    }
    REQUIRE(in_range(extent), CAGD_FIT_OUT_OF_RANGE);
    frexp(extent, &e); /* extent < 2^e, the half of the widest side */
    p->unit = ldexp(1, e);
    for (int c = 0; c < dim; c++)
        p->centre[c] = 2 * p->unit * rint((low[c] / 2 + high[c] / 2) / (2 * p->unit));
    for (size_t m = 0; m < numbers; m++)
        p->Q[m] = (data->points[m] - p->centre[m % (size_t)dim]) / p->unit;
    for (int i = 0; i < data->count; i++) {
        p->precision[i] = data->sigma != NULL ? p->unit / data->sigma[i] : p->unit;
        *where = i;
        REQUIRE(in_range(p->precision[i]), CAGD_FIT_OUT_OF_RANGE);
    }
    *where = -1;
    return CAGD_FIT_OK;
}

/* The initial curve in the gauge and in working coordinates. */
static cagd_fit_status make_initial(const cagd_spline *initial, const fit_problem *p, fit_curve *curve)
{
    int n = p->count;
    REQUIRE(initial->dim == p->dim && initial->points != NULL, CAGD_FIT_BAD_CURVE);
    for (int i = 0; i < n; i++) {
        double w = initial->weights != NULL ? initial->weights[i] : 1;
        REQUIRE(isfinite(w) && w > 0, CAGD_FIT_BAD_CURVE);
        curve->weights[i] = w;
        for (int c = 0; c < p->dim; c++) {
            double x = initial->points[i * p->dim + c];
            REQUIRE(isfinite(x), CAGD_FIT_BAD_CURVE);
            curve->points[i * p->dim + c] = (x - p->centre[c]) / p->unit;
        }
    }
    double first = log(curve->weights[0]),
           slope = n == p->degree + 1 ? (log(curve->weights[n - 1]) - first) / p->degree : 0;
    if (first != 0 || slope != 0)
        for (int i = 0; i < n; i++)
            curve->weights[i] =
                i == 0 || (i == n - 1 && slope != 0) ? 1 : exp(log(curve->weights[i]) - first - i * slope);
    fit_curve_update(curve);
    return CAGD_FIT_OK;
}

/* ---- One start --------------------------------------------------------------------------------------------- */

static void points_free(fit_problem *p)
{
    free(p->Q);
    free(p->precision);
}

/* Every stride-th point, and the last one. */
static int thinned(const fit_problem *p, int stride, fit_problem *few)
{
    size_t dim = (size_t)p->dim;
    *few = *p;
    few->points = (p->points - 1) / stride + 1 + ((p->points - 1) % stride != 0);
    few->Q = malloc((size_t)few->points * dim * sizeof *few->Q);
    few->precision = malloc((size_t)few->points * sizeof *few->precision);
    if (few->Q == NULL || few->precision == NULL) {
        points_free(few);
        return 0;
    }
    for (int k = 0; k < few->points; k++) {
        int i = k < few->points - 1 ? k * stride : p->points - 1;
        memcpy(few->Q + (size_t)k * dim, p->Q + (size_t)i * dim, dim * sizeof *few->Q);
        few->precision[k] = p->precision[i];
    }
    return 1;
}

/* The best of the initial curves: orders, if there is none, times weights of the inner points, if these are free. */
static int found_curve(const fit_problem *p, const cagd_fit_options *o, fit_curve *curve)
{
    static const double inner[] = {1, 3, 1 / 3.0};
    int good = 1, *order = malloc((size_t)p->points * sizeof *order), weights = o->free & CAGD_FIT_WEIGHTS ? 3 : 1;
    fit_curve *try = fit_curve_new(p->degree, p->count, p->dim, p->knots);
    double best = INFINITY;
    good = order != NULL && try != NULL;
    for (int guess = 0; good && guess < (p->unordered ? FIT_ORDERS : 1); guess++) {
        for (int i = 0; i < p->points; i++)
            order[i] = i;
        good = !p->unordered || fit_initial_order(p, guess, order);
        for (int w = 0; good && w < weights; w++) {
            for (int i = 0; i < p->count; i++)
                try->weights[i] = 1;
            for (int k = 0; k < p->unknowns; k++)
                if (p->unknown[k].is_weight && p->unknown[k].index < p->count - 1)
                    try->weights[p->unknown[k].index] = fmin(fmax(inner[w], exp(p->low)), exp(p->high));
            double cost;
            good = fit_initial_curve(p, order, try, &cost);
            if (good && (cost < best || (guess == 0 && w == 0))) {
                best = cost;
                fit_curve_copy(curve, try);
            }
        }
    }
    free(order);
    fit_curve_free(try);
    return good;
}

typedef struct attempt {
    fit_curve *curve; /* where it starts                                                         */
    double *feet;
    fit_objective *objective; /* where it ends: evaluated at theta                                       */
    double initial_cost, radius;
    int near; /* the start is already near the minimum of all points                                     */
    fit_outcome outcome;
} attempt;

/* Appends what a second run of the minimiser did. */
static int append(fit_outcome *all, fit_outcome *more)
{
    if (all->history == NULL) {
        *all = *more;
        return 1;
    }
    cagd_fit_step *longer = realloc(all->history, (size_t)(all->steps + more->steps + 1) * sizeof *longer);
    if (longer == NULL) {
        free(more->history);
        return 0;
    }
    for (int i = 0; i < more->steps; i++) {
        longer[all->steps + i] = more->history[i];
        longer[all->steps + i].iteration += all->iterations;
    }
    free(more->history);
    all->history = longer;
    all->steps += more->steps;
    all->iterations += more->iterations;
    all->termination = more->termination;
    memcpy(all->message, more->message, sizeof all->message);
    return 1;
}

static int roundings(const fit_problem *p) { return 4 * p->degree + 16; }

static int equations(const fit_problem *p) { return p->points * (p->dim - 1); }

/* Component k of the gradient, R^T z. */
static double gradient(const fit_objective *f, int k)
{
    int n = f->problem->unknowns;
    double g = 0;
    for (int i = 0; i <= k; i++)
        g += f->triangle[i * (n + 1) + k] * f->triangle[i * (n + 1) + n];
    return g;
}

static double largest_gradient(const fit_objective *f)
{
    double largest = 0;
    for (int k = 0; k < f->problem->unknowns; k++)
        largest = fmax(largest, fabs(gradient(f, k)));
    return largest;
}

static void bounds_of(const fit_problem *p, double low[], double high[])
{
    for (int k = 0; k < p->unknowns; k++) {
        low[k] = p->unknown[k].is_weight ? p->low : -INFINITY;
        high[k] = p->unknown[k].is_weight ? p->high : INFINITY;
    }
}

static int on_bound(const fit_problem *p, int k, double x)
{
    return p->unknown[k].is_weight && (x == p->low || x == p->high);
}

/* What is left out of the Gauss-Newton step x -> x + d(x): the second derivatives.  Near the minimum d is nearly linear, and
 * pairs of earlier differences tell how: a step s with d(x + s) = 0 in their span (Anderson's acceleration).  The differences
 * of d are kept orthonormal, those of x + d follow. */
enum { MEMORY = 8 };
typedef struct memory {
    int n, pairs;
    double *q, *u; /* MEMORY rows of n */
} memory;

static double product(int n, const double a[], const double b[])
{
    double sum = 0;
    for (int k = 0; k < n; k++)
        sum += a[k] * b[k];
    return sum;
}

static void subtract(int n, double factor, const double a[], double from[])
{
    for (int k = 0; k < n; k++)
        from[k] -= factor * a[k];
}

/* moved, and changed: of x, and of d.  Both are overwritten. */
static void remember(memory *m, double moved[], double changed[])
{
    int n = m->n;
    if (m->pairs == MEMORY || m->pairs == n)
        m->pairs = 0;
    subtract(n, -1, changed, moved);
    for (int j = 0; j < m->pairs; j++) {
        double part = product(n, m->q + j * n, changed);
        subtract(n, part, m->q + j * n, changed);
        subtract(n, part, m->u + j * n, moved);
    }
    double length = sqrt(product(n, changed, changed));
    if (!(length > 0))
        return;
    for (int k = 0; k < n; k++) {
        m->q[m->pairs * n + k] = changed[k] / length;
        m->u[m->pairs * n + k] = moved[k] / length;
    }
    m->pairs++;
}

static void accelerate(const memory *m, const double d[], double rest[], double step[])
{
    int n = m->n;
    memcpy(rest, d, (size_t)n * sizeof *rest);
    memcpy(step, d, (size_t)n * sizeof *step);
    for (int j = 0; j < m->pairs; j++) {
        double part = product(n, m->q + j * n, rest);
        subtract(n, part, m->q + j * n, rest);
        subtract(n, part, m->u + j * n, step);
    }
}

/* The Gauss-Newton step d at what was evaluated last, and *left, the length of the part of the residuals it takes away. */
static int gauss_newton(const fit_objective *f, const int fixed[], double d[], double *left)
{
    const fit_problem *p = f->problem;
    int n = p->unknowns;
    fit_rank rank;
    double size = f->cost;
    *left = INFINITY;
    memset(d, 0, (size_t)n * sizeof *d);
    for (int k = 0; k < n * (n + 1); k++)
        size += fabs(f->triangle[k]);
    if (!isfinite(size))
        return 1;
    if (!fit_rank_of(n, equations(p), roundings(p), f->triangle, n + 1, fixed, &rank))
        return 0;
    *left = fit_rank_step(&rank, f->triangle + n, n + 1, d);
    fit_rank_free(&rank);
    return 1;
}

/* To the end, as long as the steps shrink the part of the residuals that the unknowns can still take away.  The minimiser
 * compares costs, which near the minimum say nothing any more when the gradient still does.  *left: that part. */
static int polish(fit_objective *f, int fixed[], double tolerance, int most, double *left, fit_outcome *outcome)
{
    const fit_problem *p = f->problem;
    int n = p->unknowns, good;
    size_t room = (size_t)n;
    double *work = malloc((2 * MEMORY + 6) * room * sizeof *work), after;
    cagd_fit_step *longer = realloc(outcome->history, (size_t)(outcome->steps + most + 1) * sizeof *longer);
    if (longer != NULL)
        outcome->history = longer;
    if (work == NULL || longer == NULL) {
        free(work);
        return 0;
    }
    memory m = {n, 0, work, work + MEMORY * n};
    double *d = m.u + MEMORY * n, *next = d + n, *next_d = next + n, *step = next_d + n, *rest = step + n;
    for (int k = 0; k < n; k++)
        fixed[k] = on_bound(p, k, f->theta[k]);
    good = gauss_newton(f, fixed, d, left);
    for (int i = 0; good && i<most && * left> tolerance * sqrt(2 * f->cost); i++) {
        int inside = 1;
        accelerate(&m, d, rest, step);
        for (int k = 0; k < n; k++) {
            next[k] = f->theta[k] + step[k];
            inside = inside && !(p->unknown[k].is_weight && (next[k] < p->low || next[k] > p->high));
        }
        if (!inside)
            break;
        fit_objective_evaluate(f, next, 1);
        good = gauss_newton(f, fixed, next_d, &after);
        int better = after < *left;
        outcome->history[outcome->steps++] = (cagd_fit_step){
            ++outcome->iterations, better, f->cost, largest_gradient(f), sqrt(product(n, step, step)), INFINITY};
        if (!better && m.pairs == 0)
            break;
        if (!better) {
            m.pairs = 0;
            continue;
        }
        for (int k = 0; k < n; k++) {
            rest[k] = next[k] - f->theta[k];
            step[k] = next_d[k] - d[k];
        }
        remember(&m, rest, step);
        fit_objective_accept(f);
        memcpy(d, next_d, room * sizeof *d);
        int stalls = after > *left / 2 && m.pairs > 2; /* only rounding is left, or nothing is gained by going on */
        *left = after;
        if (stalls)
            break;
    }
    free(work);
    return good;
}

/* What rounding makes of a cost: of its sum, and of the points in it, as in fit_foot.  Residuals r_i that are off by b_i change
 * half the sum of their squares by at most sum |r_i| b_i + b_i^2/2, by Cauchy and Schwarz at most sqrt(2 cost sum b_i^2) + sum b_i^2/2;
 * with a robust loss by less, for rho'(r^2) r <= sqrt(rho(r^2)). */
static double cost_blur(const fit_problem *p, double cost)
{
    double sum = 0;
    for (int i = 0; i < p->points; i++) {
        double blur = p->precision[i] * (2 * p->degree + 2) * DBL_EPSILON * 2;
        sum += blur * blur;
    }
    return sqrt(2 * cost * sum) + sum / 2 + p->points * DBL_EPSILON * cost;
}

/* The objective at the theta that was accepted, whatever was tried since. */
static void settle(fit_objective *f)
{
    fit_objective_at(f, f->theta);
    fit_objective_accept(f);
}

static void swap_feet(fit_objective *f, attempt *a)
{
    double *feet = f->feet;
    f->feet = a->feet;
    a->feet = feet;
}

/* The way to the minimum is made with feet of which Taylor's polynomial is the curve over 1/256 of the length on which it
 * changes; near the minimum it is exact.  The way ends where a step gains less than ROUGHLY of the cost, with means of points
 * AVERAGED: these two say when the next stage begins, and are no part of a result, whose last stage ends by `tolerance`. */
#define ROUGH    0x1p-8
#define ROUGHLY  1e-4
#define AVERAGED 1e-8

/* To minimise from curve and feet of the attempt, and again when a search finds better feet; for approaching only to come
 * near, with rough feet. */
static int eliminated(const fit_problem *p, const cagd_fit_options *o, double tolerance, int approaching, attempt *a)
{
    int n = p->unknowns, most = o->max_iterations;
    size_t room = (size_t)n;
    fit_objective *f = a->objective;
    double *low = malloc(3 * room * sizeof *low), *high = low + n, *theta = high + n;
    double cost, left = 0, reached = HUGE_VAL, aim = sqrt(tolerance);
    int *fixed = malloc(room * sizeof *fixed), good = low && fixed;
    if (good) {
        bounds_of(p, low, high);
        fit_problem_get(p, a->curve, f->theta);
        for (int k = 0; k < n; k++)
            f->theta[k] = fmin(fmax(f->theta[k], low[k]), high[k]);
        memcpy(f->feet, a->feet, (size_t)p->points * sizeof *f->feet);
        fit_curve_copy(f->curve, a->curve);
        f->limit = a->near ? FOOT_EXACT : ROUGH;
        fit_objective_evaluate(f, f->theta, 1);
        fit_objective_accept(f);
        a->initial_cost = f->cost;
    }
    for (int rough = !a->near; good; rough = 0) {
        fit_outcome outcome = {0};
        memcpy(theta, f->theta, room * sizeof *theta);
        f->limit = rough ? ROUGH : FOOT_EXACT;
        good = fit_minimise(n, n + 1, fit_objective_residuals, f, low, high,
                            rough ? (approaching ? tolerance : ROUGHLY) : aim, rough,
                            most - a->outcome.iterations, theta, &a->radius, &outcome) &&
               append(&a->outcome, &outcome);
        if (!good)
            break;
        settle(f);
        if (approaching)
            break;
        if (rough && a->outcome.iterations < most)
            continue;
        if (a->outcome.termination == CAGD_FIT_CONVERGED) {
            good = polish(f, fixed, tolerance, most, &left, &a->outcome);
            settle(f);
            /* A decrease of the cost is left that counts: the steps of Gauss and Newton did not converge. */
            if (good && aim > tolerance && left * left > tolerance * 2 * f->cost + cost_blur(p, f->cost) &&
                a->outcome.iterations < most) {
                aim = tolerance;
                continue;
            }
        }
        settle(f);
        if (!(f->cost < reached)) /* the minimiser went back to the feet it had: no third time */
            break;
        reached = f->cost - cost_blur(p, f->cost);
        good = good && fit_feet_search(p, f->curve, a->feet, &cost);
        if (!good || cost >= f->cost - cost_blur(p, f->cost) || a->outcome.iterations >= most)
            break;
        cost = f->cost;
        swap_feet(f, a);
        fit_objective_evaluate(f, f->theta, 1);
        if (!(f->cost < cost - cost_blur(p, cost))) {
            swap_feet(f, a);
            fit_objective_evaluate(f, f->theta, 1);
            break;
        }
        fit_objective_accept(f);
    }
    free(low);
    free(fixed);
    return good;
}

/* The same as one problem of all unknowns. */
static int plain(const fit_problem *p, const cagd_fit_options *o, attempt *a)
{
    fit_objective *f = a->objective;
    double D[9];
    fit_problem_get(p, a->curve, f->theta);
    for (int k = 0; k < p->unknowns; k++)
        if (p->unknown[k].is_weight)
            f->theta[k] = fmin(fmax(f->theta[k], p->low), p->high);
    for (int i = 0; i < p->points; i++)
        fit_foot(a->curve, p->Q + (size_t)i * (size_t)p->dim, &a->feet[i], D);
    fit_curve_copy(f->curve, a->curve);
    if (!fit_minimise_plain(p, a->curve, o->tolerance, o->max_iterations, f->theta, a->feet, &a->outcome))
        return 0;
    a->initial_cost = a->outcome.steps > 0 ? a->outcome.history[0].cost : HUGE_VAL;
    for (int i = 0; i < p->points; i++) {
        f->feet[i] = fmin(fmax(a->feet[i], fit_curve_start(a->curve)), fit_curve_end(a->curve));
        if (f->feet[i] != a->feet[i]) {
            a->outcome.termination = CAGD_FIT_FAILED;
            snprintf(a->outcome.message, sizeof a->outcome.message, "The foot of point %d left the domain.", i);
        }
    }
    settle(f);
    return 1;
}

/* Points for the way to the minimum: so many for each unknown suffice to come near; TIMES as many means of points with
 * neighbouring feet know the minimum nearly as well as all points do. */
enum { ENOUGH = 20, TIMES = 4 };

static int attempt_new(const fit_problem *p, attempt *a)
{
    *a = (attempt){.radius = 1e4}; /* that of Ceres by default */
    a->curve = fit_curve_new(p->degree, p->count, p->dim, p->knots);
    a->feet = malloc((size_t)p->points * sizeof *a->feet);
    a->objective = fit_objective_new(p);
    return a->curve && a->feet && a->objective;
}

static void attempt_free(attempt *a)
{
    fit_curve_free(a->curve);
    free(a->feet);
    fit_objective_free(a->objective);
    free(a->outcome.history);
}

/* Means of points whose feet t lie in one of `groups` equal parts of the domain, with the curvature taken out: the mean of what
 * the points are off the curve, put to the curve at the mean of the feet, which become feet[]. */
static int averaged(const fit_problem *p, const fit_curve *curve, const double t[], int groups, fit_problem *few,
                    double feet[])
{
    int dim = p->dim, count = 0;
    double start = fit_curve_start(curve), part = (fit_curve_end(curve) - start) / groups, D[9];
    *few = *p;
    few->Q = calloc((size_t)groups * (size_t)dim, sizeof *few->Q);
    few->precision = calloc((size_t)groups, sizeof *few->precision);
    if (few->Q == NULL || few->precision == NULL) {
        points_free(few);
        return 0;
    }
    for (int g = 0; g < groups; g++)
        feet[g] = 0;
    for (int i = 0; i < p->points; i++) {
        double share = p->precision[i] * p->precision[i];
        int g = (int)((t[i] - start) / part);
        g = g < 0 ? 0 : g < groups ? g : groups - 1;
        fit_curve_derivatives(curve, t[i], D);
        for (int c = 0; c < dim; c++)
            few->Q[g * dim + c] += share * (p->Q[(size_t)i * (size_t)dim + (size_t)c] - D[c]);
        feet[g] += share * (t[i] - start);
        few->precision[g] += share;
    }
    for (int g = 0; g < groups; g++) {
        double all = few->precision[g];
        if (!(all > 0))
            continue;
        feet[count] = start + feet[g] / all;
        fit_curve_derivatives(curve, feet[count], D);
        for (int c = 0; c < dim; c++)
            few->Q[count * dim + c] = D[c] + few->Q[g * dim + c] / all;
        few->precision[count++] = sqrt(all);
    }
    few->points = count;
    return 1;
}

/* From the curve of the attempt, which becomes what is reached, and its feet, with other points. */
static int approach_with(const fit_problem *few, const cagd_fit_options *o, double tolerance, const double feet[],
                         attempt *a)
{
    attempt rough;
    double cost;
    int good = attempt_new(few, &rough);
    if (good) {
        fit_curve_copy(rough.curve, a->curve);
        if (feet != NULL)
            memcpy(rough.feet, feet, (size_t)few->points * sizeof *feet);
        good = (feet != NULL || fit_feet_search(few, rough.curve, rough.feet, &cost)) &&
               eliminated(few, o, tolerance, 1, &rough);
    }
    if (good) {
        fit_curve_copy(a->curve, rough.objective->curve);
        good = append(&a->outcome, &rough.outcome);
        rough.outcome.history = NULL;
    }
    attempt_free(&rough);
    return good;
}

/* Most of the way, and the feet of all points: with few points, and then with means of all, unless large errors are to count
 * less than in a mean. */
static int approach(const fit_problem *p, const cagd_fit_options *o, attempt *a)
{
    fit_problem few;
    int enough = ENOUGH * p->unknowns, groups = TIMES * enough;
    double cost, *feet;
    if (p->points < 2 * groups)
        return fit_feet_search(p, a->curve, a->feet, &cost);
    if (!thinned(p, p->points / (p->loss == CAGD_FIT_SQUARES ? enough : groups), &few))
        return 0;
    int good = approach_with(&few, o, ROUGHLY, NULL, a);
    points_free(&few);
    good = good && fit_feet_search(p, a->curve, a->feet, &cost);
    if (!good || p->loss != CAGD_FIT_SQUARES)
        return good;
    feet = malloc((size_t)groups * sizeof *feet);
    good = feet != NULL && averaged(p, a->curve, a->feet, groups, &few, feet);
    if (good) {
        a->near = good = equations(&few) < p->unknowns || approach_with(&few, o, AVERAGED, feet, a);
        points_free(&few);
    }
    free(feet);
    return good;
}

/* The largest share R_index at the measured points, and at the middles of the pieces; from `enough` on it may be a smaller one. */
static double largest_share(const fit_problem *p, const fit_objective *f, int index, double enough)
{
    const fit_curve *curve = f->curve;
    double R[MAX_DEGREE + 1], largest = 0;
    for (int i = -curve->pieces; largest < enough && i < p->points; i++) {
        int piece = i < 0 ? i + curve->pieces : fit_curve_piece(curve, f->feet[i]);
        int mu = curve->span[piece], m = index - mu + p->degree;
        if (m < 0 || m > p->degree)
            continue;
        fit_curve_shares(curve, piece, i < 0 ? (curve->knots[mu] + curve->knots[mu + 1]) / 2 : f->feet[i], R);
        largest = fmax(largest, R[m]);
    }
    return largest;
}

static void fail(attempt *a, const char *form, ...)
{
    va_list values;
    va_start(values, form);
    a->outcome.termination = CAGD_FIT_FAILED;
    vsnprintf(a->outcome.message, sizeof a->outcome.message, form, values);
    va_end(values);
}

/* Whether the gradient along log w_k is small only because the weight hardly counts, not because the residuals are orthogonal
 * to its column of the Jacobian: Gauss and Newton's step in it alone would take more than sqrt(tolerance) of the cost away, and
 * the weight from one end of the precision to the other, 2^53 times what it is. */
static int runs_away(const fit_problem *p, const fit_objective *f, double tolerance, int k)
{
    int n = p->unknowns;
    double g = gradient(f, k), square = 0;
    for (int i = 0; i <= k; i++)
        square += f->triangle[i * (n + 1) + k] * f->triangle[i * (n + 1) + k];
    return g * g > 2 * (sqrt(tolerance) * f->cost + cost_blur(p, f->cost)) * square &&
           fabs(g) > -log(DBL_EPSILON / 2) * square;
}

/* What the minimiser calls converged is none when the curve is none; when it has lost a point, whose share rounding would
 * take away; or when a weight runs away: then the cost falls towards a weight 0 or infinity without a minimum. */
static void judge(const fit_problem *p, const cagd_fit_options *o, attempt *a)
{
    const fit_objective *f = a->objective;
    if (!isfinite(f->cost))
        fail(a, "The distances have left the range of numbers.");
    for (int k = 0; isfinite(f->cost) && k < p->unknowns; k++) {
        int index = p->unknown[k].index;
        double w = f->curve->weights[index];
        if (!p->unknown[k].is_weight || on_bound(p, k, f->theta[k]))
            continue;
        if (largest_share(p, f, index, DBL_EPSILON / 2) < DBL_EPSILON / 2 || runs_away(p, f, o->tolerance, k))
            fail(a,
                 "No minimum was found: the cost falls ever slower while weight %d goes to %s (it is %.2g); other "
                 "starts, or bounds on the weights, may help.",
                 index, w < 1 ? "0" : "infinity", w);
    }
}

/* The attempt from start number `start`. */
static int try_start(const fit_problem *p, const cagd_fit_options *o, int start, attempt *a)
{
    fit_problem few;
    double cost;
    int good = thinned(p, (p->points - 1) / (ENOUGH * TIMES * p->unknowns) + 1, &few);
    if (!good)
        return 0;
    if (o->initial != NULL)
        make_initial(o->initial, p, a->curve);
    else
        good = found_curve(&few, o, a->curve);
    if (good && start > 0) {
        fit_initial_weights(p, o->seed, start, a->curve);
        if (o->free & (CAGD_FIT_INNER_POINTS | CAGD_FIT_END_POINTS))
            good = fit_initial_improve(&few, a->curve);
    }
    points_free(&few);
    good =
        good && (o->method == CAGD_FIT_ELIMINATED ? approach(p, o, a) : fit_feet_search(p, a->curve, a->feet, &cost));
    good = good && (o->method == CAGD_FIT_PLAIN ? plain(p, o, a) : eliminated(p, o, o->tolerance, 0, a));
    if (good)
        judge(p, o, a);
    return good;
}

/* ---- The result -------------------------------------------------------------------------------------------- */

void cagd_fit_free(cagd_fit_result *r)
{
    if (r == NULL)
        return;
    free((void *)r->curve.knots);
    free((void *)r->curve.points);
    free((void *)r->curve.weights);
    free(r->feet), free(r->residuals), free(r->distances), free(r->foot_at_end);
    free(r->history);
    free(r->unknown), free(r->value), free(r->at_bound);
    free(r->covariance), free(r->free_directions), free(r->determined);
    free(r->invariant), free(r->invariant_error);
    free(r);
}

static double *numbers(size_t count) { return calloc(count + 1, sizeof(double)); }

/* Points of the curve and of theta in the coordinates of the data. */
static int fill_curve(const fit_problem *p, const attempt *a, cagd_fit_result *r)
{
    int n = p->count, dim = p->dim;
    double *knots = numbers((size_t)(n + p->degree + 1)), *points = numbers((size_t)(n * dim)),
           *weights = numbers((size_t)n);
    r->curve = (cagd_spline){p->degree, n, dim, knots, points, weights};
    r->unknowns = p->unknowns;
    r->unknown = malloc((size_t)p->unknowns * sizeof *r->unknown);
    r->value = numbers((size_t)p->unknowns);
    r->at_bound = calloc((size_t)p->unknowns, sizeof *r->at_bound);
    if (!knots || !points || !weights || !r->unknown || !r->value || !r->at_bound)
        return 0;
    memcpy(knots, p->knots, (size_t)(n + p->degree + 1) * sizeof *knots);
    memcpy(weights, a->objective->curve->weights, (size_t)n * sizeof *weights);
    for (int m = 0; m < n * dim; m++)
        points[m] = p->centre[m % dim] + p->unit * a->objective->curve->points[m];
    for (int k = 0; k < p->unknowns; k++) {
        cagd_fit_unknown u = r->unknown[k] = p->unknown[k];
        r->value[k] = u.is_weight ? a->objective->theta[k] : points[u.index * dim + u.coordinate];
        r->at_bound[k] = on_bound(p, k, a->objective->theta[k]);
    }
    return 1;
}

static int fill_points(const fit_problem *p, const attempt *a, cagd_fit_result *r)
{
    int dim = p->dim;
    size_t count = (size_t)p->points;
    r->count = p->points;
    r->feet = numbers(count);
    r->residuals = numbers(count * (size_t)dim);
    r->distances = numbers(count);
    r->foot_at_end = calloc(count, sizeof *r->foot_at_end);
    if (!r->feet || !r->residuals || !r->distances || !r->foot_at_end)
        return 0;
    double sum = 0;
    for (int i = 0; i < p->points; i++) {
        const double *q = p->Q + (size_t)i * (size_t)dim;
        double *left = r->residuals + (size_t)i * (size_t)dim, D[9], t = a->objective->feet[i], square = 0;
        r->foot_at_end[i] = fit_foot(a->objective->curve, q, &t, D) == FOOT_AT_END;
        r->feet[i] = t;
        for (int c = 0; c < dim; c++) {
            left[c] = p->unit * (q[c] - D[c]);
            square += left[c] * left[c];
        }
        double side = dim == 2 ? D[2] * left[1] - D[3] * left[0] : 1;
        r->distances[i] = side < 0 ? -sqrt(square) : sqrt(square);
        sum += square;
        if (sqrt(square) > r->largest) {
            r->largest = sqrt(square);
            r->largest_at = i;
        }
        r->out_of_order += !p->unordered && i > 0 && t < r->feet[i - 1];
    }
    r->rms = sqrt(sum / p->points);
    return 1;
}

/* Rank, covariance and flat directions; lengths go back to the coordinates of the data. */
static int fill_uncertainty(const fit_problem *p, attempt *a, cagd_fit_result *r)
{
    int n = p->unknowns, good;
    size_t nn = (size_t)n * (size_t)n;
    fit_objective *f = a->objective;
    fit_rank rank;
    r->covariance = numbers(nn);
    r->free_directions = numbers(nn);
    r->determined = calloc((size_t)n, sizeof *r->determined);
    if (!r->covariance || !r->free_directions || !r->determined)
        return 0;
    for (int k = 0; k < n; k++) {
        double g = fabs(gradient(f, k)) / (p->unknown[k].is_weight ? 1 : p->unit);
        r->gradient_norm = r->at_bound[k] ? r->gradient_norm : fmax(r->gradient_norm, g);
    }
    if (p->loss != CAGD_FIT_SQUARES)
        fit_objective_evaluate(f, f->theta, 0);
    for (int k = 0; k < n; k++)
        for (int i = 0; i <= k && !p->unknown[k].is_weight; i++)
            f->triangle[i * (n + 1) + k] /= p->unit;
    f->evaluated = 0;
    good = fit_rank_of(n, equations(p), roundings(p), f->triangle, n + 1, r->at_bound, &rank);
    if (good) {
        r->rank = rank.rank;
        r->flat = rank.flat;
        fit_rank_report(&rank, r->at_bound, r->covariance, r->free_directions, r->determined);
        fit_rank_free(&rank);
    }
    return good;
}

/* What is given is not rounded by way of working coordinates. */
static void restore_given_points(const cagd_fit_data *data, const cagd_fit_options *o, cagd_fit_result *r)
{
    int n = r->curve.count, dim = r->curve.dim;
    double *points = (double *)r->curve.points;
    for (int j = 0; j < n; j++) {
        int given = 1;
        for (int k = 0; k < r->unknowns; k++)
            given &= r->unknown[k].is_weight || r->unknown[k].index != j;
        const double *from = o->initial != NULL ? o->initial->points + j * dim
                             : j == 0           ? data->points
                                                : data->points + (size_t)(data->count - 1) * (size_t)dim;
        if (given && (o->initial != NULL || j == 0 || j == n - 1))
            memcpy(points + j * dim, from, (size_t)dim * sizeof *points);
    }
}

static cagd_fit_result *make_result(const fit_problem *p, attempt *a)
{
    cagd_fit_result *r = calloc(1, sizeof *r);
    if (r == NULL)
        return NULL;
    r->cost = a->objective->cost;
    r->invariants = p->count == p->degree + 1 ? p->degree - 1 : 0;
    r->invariant = numbers((size_t)r->invariants);
    r->invariant_error = numbers((size_t)r->invariants);
    if (!r->invariant || !r->invariant_error || !fill_curve(p, a, r) || !fill_points(p, a, r) ||
        !fill_uncertainty(p, a, r)) {
        cagd_fit_free(r);
        return NULL;
    }
    r->termination = a->outcome.termination;
    r->iterations = a->outcome.iterations;
    r->initial_cost = a->initial_cost;
    r->steps = a->outcome.steps;
    r->history = a->outcome.history;
    a->outcome.history = NULL;
    memcpy(r->message, a->outcome.message, sizeof r->message);
    return r;
}

/* Whether the end of one start is better than that of another. */
static int better(const fit_problem *p, const attempt *a, const attempt *b)
{
    int a_failed = a->outcome.termination == CAGD_FIT_FAILED, b_failed = b->outcome.termination == CAGD_FIT_FAILED;
    double was = b->objective->cost;
    return a_failed == b_failed ? a->objective->cost < was - cost_blur(p, was) : b_failed;
}

/* All starts, and as long as none has come to a minimum some more; the best stays. */
enum { MORE_STARTS = 8 };
static cagd_fit_status run(const fit_problem *p, const cagd_fit_options *o, cagd_fit_result **result)
{
    attempt best = {0};
    int best_start = 0, good = 1, starts = 0, most = o->starts + (o->free & CAGD_FIT_WEIGHTS ? MORE_STARTS : 0);
    double *costs = numbers((size_t)most);
    for (int start = 0; costs && good && start < most; start++) {
        if (start >= o->starts && best.outcome.termination == CAGD_FIT_CONVERGED)
            break;
        attempt a;
        good = attempt_new(p, &a) && try_start(p, o, start, &a);
        if (good) {
            costs[starts++] = a.objective->cost;
            if (start == 0 ||
                (better(p, &a, &best) && (start < o->starts || a.outcome.termination == CAGD_FIT_CONVERGED))) {
                attempt worse = best;
                best = a;
                a = worse;
                best_start = start;
            }
        }
        attempt_free(&a);
    }
    if (costs && good)
        *result = make_result(p, &best);
    if (*result != NULL) {
        double cost = (*result)->cost, blur = sqrt(o->tolerance) * cost + cost_blur(p, cost);
        (*result)->best_start = best_start;
        for (int start = 0; start < starts; start++) /* the minimiser knows costs to its tolerance */
            (*result)->agreeing_starts += costs[start] - cost <= blur;
    }
    attempt_free(&best);
    free(costs);
    return *result != NULL ? CAGD_FIT_OK : CAGD_FIT_NO_MEMORY;
}

cagd_fit_status cagd_fit(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result **result,
                         int *where)
{
    int ignored;
    fit_problem p = {0};
    *result = NULL;
    if (where == NULL)
        where = &ignored;
    *where = -1;
    cagd_fit_status status = check_options(options);
    if (status == CAGD_FIT_OK)
        status = check_data(data, where);
    if (status != CAGD_FIT_OK)
        return status;
    p.loss = options->loss;
    p.loss_scale = options->loss_scale;
    p.unordered = options->unordered;
    p.low = log(options->weight_low);
    p.high = log(options->weight_high);
    status = make_points(data, &p, where);
    if (status == CAGD_FIT_OK)
        status = make_knots(options, &p);
    if (status == CAGD_FIT_OK)
        status = make_unknowns(options, &p);
    if (status == CAGD_FIT_OK && options->initial != NULL) {
        fit_curve *curve = fit_curve_new(p.degree, p.count, p.dim, p.knots);
        status = curve != NULL ? make_initial(options->initial, &p, curve) : CAGD_FIT_NO_MEMORY;
        fit_curve_free(curve);
    }
    if (status == CAGD_FIT_OK && equations(&p) < p.unknowns)
        status = CAGD_FIT_TOO_FEW;
    if (status == CAGD_FIT_OK)
        status = run(&p, options, result);
    if (status == CAGD_FIT_OK) {
        restore_given_points(data, options, *result);
        fit_statistics(data, options, *result);
    }
    problem_free(&p);
    return status;
}
