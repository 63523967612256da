#include "core/fit/ellipse_result.h"

#include "core/fit/candidate.h"
#include "core/fit/ellipse.h"
#include "core/fit/fit.h"
#include "core/fit/quantile.h"
#include "core/require.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

static double length_of(int dim, const double a[])
{
    double sum = 0;
    for (int c = 0; c < dim; c++)
        sum += a[c] * a[c];
    return sqrt(sum);
}

/* The value, which is g . x to first order, with its standard error; the interval lies about what is left without the bias. */
static cagd_fit_number number(const fit_ellipse *e, double value, const double g[], double scale_squared,
                              double quantile)
{
    double variance = 0, bias = 0;
    const int n = 3 * e->dim;
    for (int k = 0; k < n; k++) {
        bias += scale_squared * g[k] * e->bias[k];
        for (int l = 0; l < n; l++)
            variance += scale_squared * g[k] * e->inverse[k * n + l] * g[l];
    }
    const double error = variance >= 0 ? sqrt(variance) : NAN, middle = value - bias;
    return (cagd_fit_number){value, error, middle - quantile * error, middle + quantile * error};
}

/* The angle is that of a vector of the length A - B, which is taken for an ellipse's only when it is longer than chance makes it, and so
 * often too long.  Where its interval would reach farther than this to either side, in degrees, it has none: it covered 90 % there
 * (coverage_of_choices.c). */
static const double WIDEST_ANGLE = 10;

static void leave_intervals_out(int count, cagd_fit_number x[])
{
    for (int k = 0; k < count; k++)
        x[k].low = x[k].high = NAN;
}

/* Centre, semi-axes and angle.  With principal a = A u, b = B v:  dA = u.da,  dB = v.db,  and the angle turns by
 * (A v.da + B u.db)/(A^2 - B^2), where v is u turned to the left. */
static void describe(const fit_ellipse *e, double scale_squared, double quantile, cagd_fit_ellipse *to)
{
    const int dim = e->dim;
    const double *a = e->x + dim, *b = a + dim, A = length_of(dim, a), B = length_of(dim, b);
    double g[9] = {0}, h[9] = {0}, turn[9] = {0};
    for (int c = 0; c < dim; c++) {
        double one[9] = {0};
        one[c] = 1;
        to->centre[c] = number(e, e->x[c], one, scale_squared, quantile);
        g[dim + c] = a[c] / A;
        h[2 * dim + c] = b[c] / B;
        turn[dim + c] = A * b[c] / B / (A * A - B * B);
        turn[2 * dim + c] = B * a[c] / A / (A * A - B * B);
    }
    to->major = number(e, A, g, scale_squared, quantile);
    to->minor = number(e, B, h, scale_squared, quantile);
    if (dim == 2) {
        double angle = atan2(a[1], a[0]) * 180 / PI;
        const double degrees =
            a[0] * b[1] > a[1] * b[0] ? 180 / PI : -180 / PI; /* v is u turned to the left, or to the right */
        for (int k = 0; k < 3 * dim; k++)
            turn[k] *= degrees;
        angle = angle > 90 ? angle - 180 : angle <= -90 ? angle + 180 : angle;
        to->angle = number(e, angle, turn, scale_squared, quantile);
        if (!(A > B))
            to->angle.error = NAN;
        if (!(quantile * to->angle.error <= WIDEST_ANGLE))
            to->angle.low = to->angle.high = NAN;
    }
}

/* The probability that F with 2 and d degrees of freedom is larger than x: (1 + 2x/d)^(-d/2). */
static double beyond(double x, int d) { return pow(1 + 2 * x / d, -d / 2.0); }

/* Unrolls the angles along the points in order; *low and *high: how far they go.  Points in no order: all but the widest gap. */
static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void find_sweep(int count, double phi[], int unordered, double *low, double *high)
{
    if (unordered) {
        qsort(phi, (size_t)count, sizeof *phi, by_size);
        double widest = phi[0] + 2 * PI - phi[count - 1];
        *low = phi[0], *high = phi[count - 1];
        for (int i = 1; i < count; i++)
            if (phi[i] - phi[i - 1] > widest)
                widest = phi[i] - phi[i - 1], *low = phi[i], *high = phi[i - 1] + 2 * PI;
        return;
    }
    double last = *low = *high = phi[0];
    for (int i = 1; i < count; i++) {
        last += remainder(phi[i] - last, 2 * PI);
        *low = fmin(*low, last);
        *high = fmax(*high, last);
        phi[i] = last;
    }
}

/* The points go around with falling angle: b turns over. */
static void turn_over(fit_ellipse *e)
{
    const int dim = e->dim, n = 3 * dim;
    for (int k = 2 * dim; k < n; k++) {
        e->x[k] = -e->x[k];
        e->bias[k] = -e->bias[k];
        for (int l = 0; l < n; l++)
            e->inverse[k * n + l] = -e->inverse[k * n + l], e->inverse[l * n + k] = -e->inverse[l * n + k];
    }
}

/* What the curve as a result with nothing free does not say. */
static void fill(const cagd_fit_data *data, const fit_ellipse *e, const fit_ellipse *round, cagd_fit_result *r)
{
    const int n = data->count * (data->dim - 1), known = data->sigma != NULL;
    cagd_fit_ellipse *to = &r->found.ellipse;
    to->known = 1;
    r->effective = e->unknowns;
    r->iterations = e->iterations;
    r->cost = e->chi_squared / 2;
    r->termination = e->converged ? CAGD_FIT_CONVERGED : CAGD_FIT_NOT_CONVERGED;
    strcpy(r->message, e->converged ? "No step lowers the cost." : "The largest number of iterations was reached.");
    const int d = r->degrees_of_freedom = n - e->unknowns;
    r->chi_squared = e->chi_squared;
    r->reduced_chi_squared = d > 0 ? r->chi_squared / d : NAN;
    r->scale_is_given = known;
    r->scale_squared = known ? 1 : r->reduced_chi_squared;
    r->quantile = known ? fit_normal_quantile() : fit_student_quantile(d);
    const double k = e->unknowns, sum = r->chi_squared;
    r->aic = known ? sum + 2 * k : n * log(sum / n) + 2 * (k + 1);
    r->bic = known ? sum + k * log(n) : n * log(sum / n) + (k + 1) * log(n);
    describe(e, r->scale_squared, r->quantile, to);
    for (int c = 0; c < data->dim; c++) {
        double one[9] = {0};
        one[c] = 1;
        to->circle_centre[c] = number(round, round->x[c], one, r->scale_squared, r->quantile);
    }
    double g[9] = {0}, R = length_of(data->dim, round->x + data->dim);
    for (int c = 0; c < data->dim; c++)
        g[data->dim + c] = round->x[data->dim + c] / R;
    to->radius = number(round, R, g, r->scale_squared, r->quantile);
    if (!to->whole && !(r->rms * to->major.value <= FIT_BENT * to->minor.value * to->minor.value)) {
        leave_intervals_out(data->dim, to->centre);
        leave_intervals_out(data->dim, to->circle_centre);
        leave_intervals_out(1, &to->radius);
        leave_intervals_out(1, &to->major);
        leave_intervals_out(1, &to->minor);
        leave_intervals_out(1, &to->angle);
    }
}

/* How much larger the sum of squares of the circle is, as F with 2 degrees of freedom in the numerator; and whether that is by
 * chance in more than one of twenty cases. */
static int is_circle(const cagd_fit_data *data, const fit_ellipse *e, const fit_ellipse *round, double rounding,
                     cagd_fit_ellipse *to)
{
    const int d = to->freedom = data->count * (data->dim - 1) - e->unknowns;
    to->circle_rms = round->rms;
    if (!round->converged || d <= 0)
        return 0;
    const double more = round->chi_squared - e->chi_squared;
    if (data->sigma != NULL) {
        to->ratio = more / 2;
        return exp(-more / 2) > FIT_NO_CIRCLE; /* of chi squared with 2 degrees of freedom */
    }
    to->ratio = more / 2 / (e->chi_squared / d);
    return to->circle_rms <= rounding || beyond(to->ratio, d) > FIT_NO_CIRCLE;
}

/* The ellipse, from the first one or from the circle; NULL where the minimiser does not come to its end. */
static cagd_status result_of(const cagd_fit_data *data, const cagd_fit_options *options, int from_circle,
                             cagd_fit_result **result)
{
    double *phi = malloc((size_t)data->count * sizeof *phi), *points = NULL, low, high, rounding = 0;
    fit_ellipse ellipse, round;
    cagd_fit_ellipse test = {0};
    cagd_spline curve;
    cagd_status status = CAGD_NO_MEMORY;
    *result = NULL;
    int good = phi != NULL && fit_ellipse_of(data, 1, NULL, &round, phi) &&
               fit_ellipse_of(data, 0, from_circle ? &round : NULL, &ellipse, phi),
        circle = 0;
    if (good && ellipse.converged) {
        for (int i = 0; i < data->count * data->dim; i++)
            rounding = fmax(rounding, fabs(data->points[i]));
        rounding *= 8 * DBL_EPSILON;
        circle = is_circle(data, &ellipse, &round, rounding, &test);
        if (circle)
            good = fit_ellipse_of(data, 1, NULL, &round, phi);
        fit_ellipse *e = circle ? &round : &ellipse;
        if (good && e->unknowns < (circle ? 3 * (data->dim - 1) : 3 * data->dim - 1)) { /* as of a straight line */
            free(phi);
            return CAGD_OK;
        }
        double back = 0;
        for (int i = 1; i < data->count; i++)
            back += remainder(phi[i] - phi[i - 1], 2 * PI);
        if (back < 0 && !options->unordered) {
            turn_over(e);
            for (int i = 0; i < data->count; i++)
                phi[i] = -phi[i];
        }
        const double first = phi[0];
        find_sweep(data->count, phi, options->unordered, &low, &high);
        test.whole = options->closed || high - low >= 2 * PI;
        if (test.whole)
            low = first, high = first + 2 * PI;
        good = good && fit_ellipse_curve(e, low, high, &curve, &points);
    } else {
        free(phi);
        return good ? CAGD_OK : CAGD_NO_MEMORY;
    }
    if (good) {
        cagd_fit_options feet = *options;
        feet.free = 0, feet.closed = 0, feet.initial = &curve, feet.smooth = 0;
        status = fit_plainly(data, &feet, result, NULL);
    }
    if (status == CAGD_OK) {
        (*result)->found.ellipse = test;
        (*result)->found.ellipse.circle = circle;
        (*result)->found.ellipse.sweep = test.whole ? 360 : (high - low) * 180 / PI;
        fill(data, circle ? &round : &ellipse, &round, *result);
    }
    free(points);
    free(phi);
    return status;
}

/* An arc that scatters may lie between the sides of a flat ellipse, which is a minimum, too, but not a good curve. */
cagd_status fit_ellipse_result(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result **result)
{
    cagd_fit_result *other = NULL;
    cagd_status status = result_of(data, options, 0, result);
    REQUIRE(status == CAGD_OK && (*result == NULL || !fit_is_good(data, options, *result)), status);
    status = result_of(data, options, 1, &other);
    const int other_is_taken = status != CAGD_OK || (other != NULL && fit_is_good(data, options, other));
    cagd_fit_free(other_is_taken ? *result : other);
    *result = other_is_taken ? other : *result;
    return status;
}
