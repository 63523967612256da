#include "core/fit/problem.h"

#include "core/fit/arguments.h"
#include "core/fit/loss.h"
#include "core/number/limits.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

void fit_problem_free(fit_problem *p)
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
static cagd_status make_knots(const cagd_fit_options *o, fit_problem *p)
{
    const cagd_spline *initial = o->initial;
    const double *knots = initial != NULL ? initial->knots : o->knots;
    p->degree = initial != NULL ? initial->degree : o->degree;
    p->count = initial != NULL ? initial->count : o->count != 0 ? o->count : o->degree + 1;
    int n = p->count, d = p->degree, given = initial != NULL || (o->knots != NULL);
    REQUIRE(d >= 1 && d <= MAX_DEGREE, initial != NULL ? CAGD_BAD_CURVE : CAGD_BAD_OPTION);
    REQUIRE(n > d, initial != NULL ? CAGD_BAD_CURVE : CAGD_BAD_OPTION);
    REQUIRE(!given || knots != NULL, CAGD_BAD_CURVE);
    p->knots = malloc((size_t)(n + d + 1) * sizeof *p->knots);
    REQUIRE(p->knots != NULL, CAGD_NO_MEMORY);
    for (int i = 0; i <= n + d; i++)
        p->knots[i] = given ? knots[i] : i <= d ? 0 : i >= n ? 1 : (double)(i - d) / (n - d);
    double one = 0;
    cagd_spline basis = {d, n, 1, p->knots, &one, NULL};
    int span;
    REQUIRE(cagd_spline_span(&basis, p->knots[d], CAGD_RIGHT, &span) == CAGD_OK, CAGD_BAD_CURVE);
    REQUIRE(p->knots[0] == p->knots[d] && p->knots[n] == p->knots[n + d], CAGD_BAD_CURVE);
    for (int i = d + 1; i + d < n; i++) /* an inner knot of multiplicity p+1 breaks the curve */
        REQUIRE(p->knots[i] < p->knots[i + d], CAGD_BAD_CURVE);
    return CAGD_OK;
}

/* The unknowns in the order of the points: for each its weight, then its coordinates. */
static cagd_status make_unknowns(const cagd_fit_options *o, fit_problem *p)
{
    int n = p->count, d = p->degree, one_span = n == d + 1;
    p->unknown = malloc((size_t)(n * (p->dim + 1)) * sizeof *p->unknown);
    p->first = malloc((size_t)(n - d + 1) * sizeof *p->first);
    p->reach = malloc((size_t)((n - d) * (d + 1) * (p->dim + 1)) * sizeof *p->reach);
    p->slot = malloc((size_t)((n - d) * (d + 1) * (p->dim + 1)) * sizeof *p->slot);
    REQUIRE(p->unknown && p->first && p->reach && p->slot, CAGD_NO_MEMORY);
    for (int i = 0; i < n; i++) {
        int end = i == 0 || i == n - 1, gauge = i == 0 || (one_span && i == n - 1);
        if (o->free & CAGD_FIT_WEIGHTS && !gauge)
            p->unknown[p->unknowns++] = (cagd_fit_unknown){1, i, 0};
        for (int c = 0; o->free & (end ? CAGD_FIT_END_POINTS : CAGD_FIT_INNER_POINTS) && c < p->dim; c++)
            p->unknown[p->unknowns++] = (cagd_fit_unknown){0, i, c};
    }
    REQUIRE(p->unknowns > 0 || o->free == 0, CAGD_BAD_OPTION);
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
    return CAGD_OK;
}

/* Squared distances, their sum, and the square of what rounding makes of a distance, 2^-106 of it, are numbers without underflow
 * or overflow when the distance lies between 2^-400 and 2^400: 2*400 + 31 < 1024 and 2*400 + 106 < 1022. */
static int in_range(double x) { return x >= 0x1p-400 && x <= 0x1p+400; }

/* The coordinates c of all points lie between low and high. */
static void enclose(int count, int dim, int c, const double points[], double *low, double *high)
{
    for (int i = 0; i < count; i++) {
        double x = points[(size_t)i * (size_t)dim + (size_t)c];
        *low = fmin(*low, x);
        *high = fmax(*high, x);
    }
}

static cagd_status make_points(const cagd_fit_data *data, const cagd_fit_options *o, fit_problem *p, int *where)
{
    int dim = data->dim, e;
    size_t numbers = (size_t)data->count * (size_t)dim;
    double low[3], high[3], extent = 0;
    p->points = data->count;
    p->Q = malloc(numbers * sizeof *p->Q);
    p->precision = malloc((size_t)data->count * sizeof *p->precision);
    REQUIRE(p->Q && p->precision, CAGD_NO_MEMORY);
    for (int c = 0; c < dim; c++) {
        low[c] = high[c] = data->points[c];
        enclose(data->count, dim, c, data->points, &low[c], &high[c]);
        if (o->free == 0) /* a single point has no size, and the curve may be anywhere */
            enclose(p->count, dim, c, o->initial->points, &low[c], &high[c]);
        extent = fmax(extent, high[c] / 2 - low[c] / 2);
    }
    REQUIRE(extent > 0 || o->free != 0, CAGD_ALL_EQUAL);
    REQUIRE(in_range(extent), CAGD_OVERFLOW);
    frexp(extent, &e); /* extent < 2^e, the half of the widest side */
    p->unit = ldexp(1, e);
    for (int c = 0; c < dim; c++) {
        int far = fmax(low[c], -high[c]) / 3 >= extent;
        p->centre[c] = far ? p->unit * rint((low[c] / 2 + high[c] / 2) / p->unit) : 0;
    }
    p->size = 2;
    for (int c = 0; c < dim; c++) /* the unit is a power of two */
        for (size_t m = (size_t)c; m < numbers; m += (size_t)dim)
            p->Q[m] = (data->points[m] - p->centre[c]) / p->unit;
    for (size_t m = 0; m < numbers; m++)
        p->size = fmax(p->size, fabs(p->Q[m]));
    for (int i = 0; i < data->count; i++) {
        p->precision[i] = data->sigma != NULL ? p->unit / data->sigma[i] : p->unit;
        *where = i;
        REQUIRE(in_range(p->precision[i]), CAGD_OVERFLOW);
    }
    *where = -1;
    return CAGD_OK;
}

/* Whether the initial curve is one; without any there is nothing to be checked. */
static cagd_status check_initial(const fit_problem *p, const cagd_spline *initial)
{
    if (initial == NULL)
        return CAGD_OK;
    REQUIRE(initial->dim == p->dim && initial->points != NULL, CAGD_BAD_CURVE);
    for (int i = 0; i < p->count; i++)
        REQUIRE(initial->weights == NULL || (isfinite(initial->weights[i]) && initial->weights[i] > 0), CAGD_BAD_CURVE);
    for (int m = 0; m < p->count * p->dim; m++)
        REQUIRE(isfinite(initial->points[m]), CAGD_BAD_CURVE);
    return CAGD_OK;
}

cagd_status fit_problem_make(const cagd_fit_data *data, const cagd_fit_options *o, const fit_strategy *strategy,
                             fit_problem *p, int *where)
{
    *p = (fit_problem){.options = o, .strategy = *strategy, .loss = o->loss, .loss_scale = o->loss_scale};
    p->unordered = o->unordered || o->free == 0;
    p->low = o->weight_low;
    p->high = o->weight_high;
    p->nothing_free = o->free == 0;
    p->dim = data->dim;
    cagd_status status = make_knots(o, p);
    if (status == CAGD_OK)
        status = check_initial(p, o->initial);
    if (status == CAGD_OK)
        status = make_points(data, o, p, where);
    if (status == CAGD_OK)
        status = make_unknowns(o, p);
    if (status == CAGD_OK)
        fit_problem_update_errors(p);
    return status;
}

void fit_problem_curve(const fit_problem *p, const cagd_spline *initial, fit_curve *curve)
{
    int n = p->count, e;
    double largest = 0;
    for (int i = 0; i < n; i++) {
        curve->weights[i] = initial->weights != NULL ? initial->weights[i] : 1;
        largest = fmax(largest, curve->weights[i]);
        for (int c = 0; c < p->dim; c++)
            curve->points[i * p->dim + c] = (initial->points[i * p->dim + c] - p->centre[c]) / p->unit;
    }
    if (p->nothing_free) { /* its own parameter; a power of two is no gauge, and keeps sums of weights in range */
        frexp(largest, &e);
        for (int i = 0; i < n; i++)
            curve->weights[i] = ldexp(curve->weights[i], -e);
        fit_curve_update(curve);
        return;
    }
    double first = log(curve->weights[0]),
           slope = n == p->degree + 1 ? (log(curve->weights[n - 1]) - first) / p->degree : 0;
    if (first != 0 || slope != 0)
        for (int i = 0; i < n; i++)
            curve->weights[i] =
                i == 0 || (i == n - 1 && slope != 0) ? 1 : exp(log(curve->weights[i]) - first - i * slope);
    fit_curve_update(curve);
}

/* phi(y) = 1 + y, from -1/2 on; below it falls like an exponential function and stays positive. */
static double phi(double y) { return y >= -0.5 ? 1 + y : exp(2 * y + 1) / 2; }
static double phi_inverse(double x) { return x >= 0.5 ? x - 1 : (log(2 * x) - 1) / 2; }

double fit_problem_slope(double y) { return y >= -0.5 ? 1 : exp(2 * y + 1); }
double fit_problem_bend(double y) { return y >= -0.5 ? 0 : 2; }

void fit_problem_set(const fit_problem *p, const fit_curve *base, const double x[], fit_curve *curve)
{
    for (int k = 0; k < p->unknowns; k++) { /* the weight of a point before its coordinates */
        int j = p->unknown[k].index, c = j * p->dim + p->unknown[k].coordinate;
        double *w = &curve->weights[j], b = base->weights[j];
        if (!p->unknown[k].is_weight)
            curve->points[c] = base->points[c] + x[k] / *w;
        else if (x[k] <= phi_inverse(p->low / b))
            *w = p->low;
        else if (x[k] >= phi_inverse(p->high / b))
            *w = p->high;
        else
            *w = fmin(fmax(b * phi(x[k]), p->low), p->high);
    }
    fit_curve_update(curve);
}

void fit_problem_get(const fit_problem *p, const fit_curve *base, const fit_curve *curve, double x[])
{
    for (int k = 0; k < p->unknowns; k++) {
        int j = p->unknown[k].index, c = j * p->dim + p->unknown[k].coordinate;
        double w = curve->weights[j];
        x[k] = p->unknown[k].is_weight ? phi_inverse(w / base->weights[j]) : w * (curve->points[c] - base->points[c]);
    }
}

void fit_problem_theta(const fit_problem *p, const fit_curve *curve, double theta[])
{
    for (int k = 0; k < p->unknowns; k++) {
        cagd_fit_unknown u = p->unknown[k];
        theta[k] = u.is_weight ? log(curve->weights[u.index]) : curve->points[u.index * p->dim + u.coordinate];
    }
}

void fit_problem_curve_of(const fit_problem *p, const double theta[], fit_curve *curve)
{
    for (int k = 0; k < p->unknowns; k++) {
        cagd_fit_unknown u = p->unknown[k];
        if (u.is_weight)
            curve->weights[u.index] = fmin(fmax(exp(theta[k]), p->low), p->high);
        else
            curve->points[u.index * p->dim + u.coordinate] = theta[k];
    }
    fit_curve_update(curve);
}

double fit_problem_loss(const fit_problem *p, double x, double *slope)
{
    double value[3] = {x, 1, 0};
    if (p->loss != CAGD_FIT_SQUARES)
        fit_loss(p->loss, p->loss_scale, x, value);
    *slope = value[1];
    return value[0];
}

int fit_problem_equations(const fit_problem *p) { return p->points * (p->dim - 1); }

int fit_problem_roundings(const fit_problem *p) { return 4 * p->degree + 16; }

void fit_problem_bounds(const fit_problem *p, const fit_curve *base, double low[], double high[])
{
    for (int k = 0; k < p->unknowns; k++) {
        double b = base->weights[p->unknown[k].index];
        low[k] = p->unknown[k].is_weight ? phi_inverse(p->low / b) : -INFINITY;
        high[k] = p->unknown[k].is_weight ? phi_inverse(p->high / b) : INFINITY;
    }
}

int fit_problem_on_bound(const fit_problem *p, int k, const fit_curve *curve)
{
    double w = curve->weights[p->unknown[k].index];
    return p->unknown[k].is_weight && (w == p->low || w == p->high);
}

void fit_problem_update_errors(fit_problem *p)
{
    p->rounding = 0;
    for (int i = 0; i < p->points; i++) {
        double blur = p->precision[i] * (2 * p->degree + 2) * DBL_EPSILON * p->size;
        p->rounding += blur * blur;
    }
}

double fit_problem_cost_error(const fit_problem *p, double cost)
{
    return sqrt(2 * cost * p->rounding) + p->rounding / 2 + p->points * DBL_EPSILON * cost;
}
