#include "core/fit/problem.h"

#include "core/fit/arguments.h"
#include "core/fit/loss.h"
#include "core/fit/means.h"
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
    free(p->support.first);
    free(p->support.unknown);
    free(p->local);
}

/* Whether the lengths of the spans of a closed curve come again after a period, but for rounding. */
static int is_periodic(const fit_problem *p)
{
    const double length = p->knots[p->count] - p->knots[p->degree];
    int good = 1;
    for (int i = 0; i + p->period <= p->count + p->degree; i++)
        good = good && fabs(p->knots[i + p->period] - p->knots[i] - length) <= 8 * DBL_EPSILON * length;
    return good;
}

/* Knots of the initial curve, or as given, or even. */
static cagd_status make_knots(const cagd_fit_options *o, fit_problem *p)
{
    const cagd_spline *initial = o->initial;
    const double *knots = initial != NULL ? initial->knots : o->knots;
    p->degree = initial != NULL ? initial->degree : o->degree;
    p->count = initial != NULL ? initial->count
               : o->closed     ? (o->count != 0 ? o->count : o->degree + 2) + o->degree
               : o->count != 0 ? o->count
                               : o->degree + 1;
    int n = p->count, d = p->degree, given = initial != NULL || (o->knots != NULL);
    REQUIRE(d >= 1 && d <= MAX_DEGREE, initial != NULL ? CAGD_BAD_CURVE : CAGD_BAD_OPTION);
    REQUIRE(n > d, initial != NULL ? CAGD_BAD_CURVE : CAGD_BAD_OPTION);
    REQUIRE(!given || knots != NULL, CAGD_BAD_CURVE);
    p->knots = malloc((size_t)(n + d + 1) * sizeof *p->knots);
    REQUIRE(p->knots != NULL, CAGD_NO_MEMORY);
    p->period = o->closed ? n - d : 0;
    for (int i = 0; i <= n + d; i++)
        p->knots[i] = given                  ? knots[i]
                      : !o->closed && i <= d ? 0
                      : !o->closed && i >= n ? 1
                                             : (double)(i - d) / (n - d);
    double one = 0;
    cagd_spline basis = {d, n, 1, p->knots, &one, NULL};
    int span;
    REQUIRE(cagd_spline_span(&basis, p->knots[d], CAGD_RIGHT, &span) == CAGD_OK, CAGD_BAD_CURVE);
    REQUIRE(!o->closed || (p->period > d && is_periodic(p)), CAGD_BAD_CURVE);
    REQUIRE(o->closed || (p->knots[0] == p->knots[d] && p->knots[n] == p->knots[n + d]), CAGD_BAD_CURVE);
    for (int i = d + 1; i + d < n; i++) /* an inner knot of multiplicity p+1 breaks the curve */
        REQUIRE(p->knots[i] < p->knots[i + d], CAGD_BAD_CURVE);
    return CAGD_OK;
}

/* The unknowns in the order of the points of the curve: of each its weight, then its coordinates.  The first weight
 * is given, and so is the last one of a curve of one span. */
static void number_unknowns(const cagd_fit_options *o, fit_problem *p)
{
    const int own = p->period > 0 ? p->period : p->count, last = own - 1, one_span = p->count == p->degree + 1;
    for (int i = 0; i <= last; i++) {
        int end = p->period == 0 && (i == 0 || i == last), given = i == 0 || (one_span && i == last);
        if (o->free & CAGD_FIT_WEIGHTS && !given)
            p->unknown[p->unknowns++] = (cagd_fit_unknown){1, i, 0};
        for (int c = 0; o->free & (end ? CAGD_FIT_END_POINTS : CAGD_FIT_INNER_POINTS) && c < p->dim; c++)
            p->unknown[p->unknowns++] = (cagd_fit_unknown){0, i, c};
    }
}

/* The support of every piece u_mu < u_{mu+1}: the unknowns of the points mu-p, ..., mu. */
static void find_support(fit_problem *p)
{
    fit_support *s = &p->support;
    int at = 0;
    s->unknowns = p->unknowns;
    for (int mu = p->degree; mu < p->count; mu++) {
        if (!(p->knots[mu] < p->knots[mu + 1]))
            continue;
        s->first[s->pieces++] = at;
        for (int k = 0; k < p->unknowns; k++) {
            int m = p->unknown[k].index - (mu - p->degree);
            m += m < 0 ? p->period : 0;
            if (m < 0 || m > p->degree)
                continue;
            p->local[at] = p->unknown[k];
            p->local[at].index = m;
            s->unknown[at++] = k;
        }
    }
    s->first[s->pieces] = at;
}

static cagd_status make_unknowns(const cagd_fit_options *o, fit_problem *p)
{
    const size_t n = (size_t)p->count, d = (size_t)p->degree, most = (n - d) * (d + 1) * ((size_t)p->dim + 1);
    p->unknown = malloc(n * ((size_t)p->dim + 1) * sizeof *p->unknown);
    p->support.first = malloc((n - d + 1) * sizeof *p->support.first);
    p->support.unknown = malloc(most * sizeof *p->support.unknown);
    p->local = malloc(most * sizeof *p->local);
    REQUIRE(p->unknown && p->support.first && p->support.unknown && p->local, CAGD_NO_MEMORY);
    number_unknowns(o, p);
    REQUIRE(p->unknowns > 0 || o->free == 0, CAGD_BAD_OPTION);
    find_support(p);
    return CAGD_OK;
}

/* Squared distances, their sum, and the square of what rounding makes of a distance, 2^-106 of it, are numbers
 * without underflow or overflow when the distance lies between 2^-400 and 2^400: 2*400 + 31 < 1024 and 2*400 + 106 <
 * 1022. */
static int in_range(double x) { return x >= 0x1p-400 && x <= 0x1p+400; }

/* Widens *low and *high until the coordinates c of all points lie between them. */
static void enclose(int count, int dim, int c, const double points[], double *low, double *high)
{
    for (int i = 0; i < count; i++) {
        double x = points[(size_t)i * (size_t)dim + (size_t)c];
        *low = -fit_larger(-*low, -x);
        *high = fit_larger(*high, x);
    }
}

/* Unit and centre of the working coordinates: those of the points; where nothing is free also those of the curve,
 * since a single point has no size, and the curve may be anywhere. */
static cagd_status choose_coordinates(const cagd_fit_data *data, const cagd_fit_options *o, fit_problem *p)
{
    int dim = data->dim, exponent;
    double low[3], high[3], extent = 0;
    for (int c = 0; c < dim; c++) {
        low[c] = high[c] = data->points[c];
        enclose(data->count, dim, c, data->points, &low[c], &high[c]);
        if (o->free == 0)
            enclose(p->count, dim, c, o->initial->points, &low[c], &high[c]);
        extent = fmax(extent, high[c] / 2 - low[c] / 2);
    }
    REQUIRE(extent > 0 || o->free != 0, CAGD_ALL_EQUAL);
    REQUIRE(in_range(extent), CAGD_OVERFLOW);
    frexp(extent, &exponent); /* extent, half of the widest side, < 2^exponent */
    p->unit = ldexp(1, exponent);
    for (int c = 0; c < dim; c++) {
        int far = fmax(low[c], -high[c]) / 3 >= extent;
        p->centre[c] = far ? p->unit * rint((low[c] / 2 + high[c] / 2) / p->unit) : 0;
    }
    return CAGD_OK;
}

/* The points in working coordinates, and their precision. */
static cagd_status make_points(const cagd_fit_data *data, fit_problem *p, int *where)
{
    const size_t dim = (size_t)data->dim, numbers = (size_t)data->count * dim;
    const double inverse = 1 / p->unit; /* exactly: the unit is a power of two */
    p->points = data->count;
    p->Q = malloc(numbers * sizeof *p->Q);
    p->precision = malloc((size_t)data->count * sizeof *p->precision);
    REQUIRE(p->Q && p->precision, CAGD_NO_MEMORY);
    p->size = 2;
    for (size_t m = 0; m < numbers; m += dim)
        for (size_t c = 0; c < dim; c++) {
            p->Q[m + c] = (data->points[m + c] - p->centre[c]) * inverse;
            p->size = fit_larger(p->size, fabs(p->Q[m + c]));
        }
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
    *p = (fit_problem){
        .options = o, .strategy = *strategy, .dim = data->dim, .loss = o->loss, .loss_scale = o->loss_scale};
    p->nothing_free = o->free == 0;
    p->unordered = o->unordered || p->nothing_free;
    int measured = (o->free & CAGD_FIT_END_POINTS) != 0 && o->ends == CAGD_FIT_ENDS_MEASURED && !o->closed;
    p->end_point[0] = measured ? 0 : -1;
    p->end_point[1] = measured ? data->count - 1 : -1;
    p->low = o->weight_low, p->high = o->weight_high;
    cagd_status status = make_knots(o, p);
    if (status == CAGD_OK)
        status = check_initial(p, o->initial);
    if (status == CAGD_OK)
        status = choose_coordinates(data, o, p);
    if (status == CAGD_OK)
        status = make_points(data, p, where);
    p->smooth = o->smooth * p->unit * p->unit;
    if (status == CAGD_OK)
        status = make_unknowns(o, p);
    if (status == CAGD_OK)
        fit_problem_look_at_points(p);
    return status;
}

/* Weights of the same curve, the largest of which is between 1/2 and 1: a power of two is no gauge, and keeps their
 * sums in range. */
static void scale_weights(fit_curve *curve)
{
    double largest = 0;
    int exponent;
    for (int i = 0; i < curve->spline.count; i++)
        largest = fmax(largest, curve->weights[i]);
    frexp(largest, &exponent);
    for (int i = 0; i < curve->spline.count; i++)
        curve->weights[i] = ldexp(curve->weights[i], -exponent);
}

/* The weights in the gauge: the first one becomes 1, and so does the last one of a curve of one span. */
static void gauge_weights(fit_curve *curve)
{
    const int last = curve->spline.count - 1, one_span = last == curve->spline.degree;
    double first = log(curve->weights[0]),
           slope = one_span ? (log(curve->weights[last]) - first) / curve->spline.degree : 0;
    if (first == 0 && slope == 0)
        return;
    for (int i = 0; i <= last; i++)
        curve->weights[i] = i == 0 || (i == last && slope != 0) ? 1 : exp(log(curve->weights[i]) - first - i * slope);
}

void fit_problem_curve(const fit_problem *p, const cagd_spline *initial, fit_curve *curve)
{
    for (int i = 0; i < p->count; i++) {
        curve->weights[i] = initial->weights != NULL ? initial->weights[i] : 1;
        for (int c = 0; c < p->dim; c++)
            curve->points[i * p->dim + c] = (initial->points[i * p->dim + c] - p->centre[c]) / p->unit;
    }
    if (p->nothing_free)
        scale_weights(curve);
    else
        gauge_weights(curve);
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

int fit_problem_equations(const fit_problem *p)
{
    return p->points * (p->dim - 1) + (p->end_point[0] >= 0) + (p->end_point[1] >= 0);
}

int fit_problem_roundings(const fit_problem *p) { return 4 * p->degree + 16; }

void fit_problem_look_at_points(fit_problem *p)
{
    p->rounding = 0;
    for (int i = 0; i < p->points; i++) {
        double error = p->precision[i] * (2 * p->degree + 2) * DBL_EPSILON * p->size;
        p->rounding += error * error;
    }
    p->neighbours = p->unordered ? 1 : fit_neighbours(&(cagd_fit_data){p->points, p->dim, fit_point(p, 0), NULL});
}

double fit_problem_cost_error(const fit_problem *p, double cost)
{
    return sqrt(2 * cost * p->rounding) + p->rounding / 2 + p->points * DBL_EPSILON * cost;
}
