#include "core/fit/statistics.h"

#include <math.h>
#include <stddef.h>

void fit_loss(cagd_fit_loss loss, double scale, double s, double value[3])
{
    double a = scale, root = sqrt(s), ratio = 1 + s / (a * a);
    switch (loss) {
    case CAGD_FIT_HUBER:
        if (root > a) {
            value[0] = 2 * a * root - a * a;
            value[1] = a / root;
            value[2] = -a / (2 * s * root);
            return;
        }
        break;
    case CAGD_FIT_CAUCHY:
        value[0] = a * a * log1p(s / (a * a));
        value[1] = 1 / ratio;
        value[2] = -1 / (a * a * ratio * ratio);
        return;
    case CAGD_FIT_SQUARES:
        break;
    }
    value[0] = s;
    value[1] = 1;
    value[2] = 0;
}

/* ---- Quantiles ------------------------------------------------------------------------------------ */

static const long double normal_quantile = 1.959963984540054235524594430520551527956L;

double fit_normal_quantile(void) { return (double)normal_quantile; }

/* P(|T| <= t) with theta = atan(t/sqrt(nu)), in closed form:
 *     nu odd     2/pi (theta + sin theta cos theta (1 + 2/3 c (1 + 4/5 c (1 + ... (nu-3)/(nu-2) c)))),   c = cos^2 theta,
 *     nu even    sin theta (1 + 1/2 c (1 + 3/4 c (1 + ... (nu-3)/(nu-2) c))).
 * Source: abramowitz-stegun-1964, 26.7.3 and 26.7.4. */
static long double student_probability(int nu, long double theta, long double *density)
{
    const long double pi = 3.141592653589793238462643383279502884L;
    long double c = cosl(theta) * cosl(theta), sum = 1, factor = 1;
    for (int j = nu - 3; j > 0; j -= 2) {
        sum = 1 + sum * c * (long double)j / (long double)(j + 1);
        factor *= c * (long double)(j + 2) / (long double)(j + 1);
    }
    if (nu % 2 == 0) { /* dP/dtheta = cos theta (1 + 1/2) (1 + 1/4) ... c^{nu/2-1} */
        *density = factor * cosl(theta);
        return sinl(theta) * sum;
    }
    if (nu == 1) {
        *density = 2 / pi;
        return 2 / pi * theta;
    }
    *density = 2 / pi * factor * 2 * c; /* the first factor of the product, 2/1 c, has no j */
    return 2 / pi * (theta + sinl(theta) * cosl(theta) * sum);
}

/* For many degrees of freedom the expansion about the normal quantile is used, whose first term left out is of the size of
 * nu^{-5} < 2^{-61}.  For fewer, P is increasing and concave in theta, hence Newton's method from the left increases to the solution;
 * it ends when rounding stops it.  It begins with three terms of the expansion, which all lie below.  Source: abramowitz-stegun-1964, 26.7.5. */
double fit_student_quantile(int nu)
{
    const long double wanted = 0.95L, z = normal_quantile, n = nu, y = z * z;
    if (nu < 1)
        return NAN;
    const long double g1 = z * (y + 1) / 4, g2 = z * ((5 * y + 16) * y + 3) / 96;
    if (nu > 5000) {
        long double g3 = z * (((3 * y + 19) * y + 17) * y - 15) / 384;
        long double g4 = z * ((((79 * y + 776) * y + 1482) * y - 1920) * y - 945) / 92160;
        return (double)(z + (g1 + (g2 + (g3 + g4 / n) / n) / n) / n);
    }
    long double theta = atanl((z + (g1 + g2 / n) / n) / sqrtl(n)), density;
    for (int step = 0; step < 64; step++) {
        long double missing = wanted - student_probability(nu, theta, &density), next = theta + missing / density;
        if (!(next > theta))
            break;
        theta = next;
    }
    return (double)(sqrtl(n) * tanl(theta));
}

/* ---- The scale of the errors ---------------------------------------------------------------------- */

static double scaled_square(const cagd_fit_data *data, const cagd_fit_result *result, int i)
{
    double sum = 0, sigma = data->sigma != NULL ? data->sigma[i] : 1;
    for (int c = 0; c < data->dim; c++) {
        double r = result->residuals[i * data->dim + c] / sigma;
        sum += r * r;
    }
    return sum;
}

/* Huber's factor for the covariance of an M-estimate: see the header. */
static double m_estimate_scale(const cagd_fit_data *data, const cagd_fit_options *options,
                               const cagd_fit_result *result)
{
    double spread = 0, mean = 0, variance = 0, value[3], count = data->count, normals = data->dim - 1;
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < data->count; i++) {
            double s = scaled_square(data, result, i);
            fit_loss(options->loss, options->loss_scale, s, value);
            double m = value[1] + 2 * s * value[2] / normals;
            if (pass == 0) {
                spread += value[1] * value[1] * s;
                mean += m / count;
            } else {
                variance += (m - mean) * (m - mean) / count;
            }
        }
    double K = 1 + result->rank / (count * normals) * variance / (mean * mean);
    return mean > 0 ? K * K * spread / result->degrees_of_freedom / (mean * mean) : NAN;
}

static void fill_scale(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result *result)
{
    double n = (double)data->count * (data->dim - 1), k = result->rank, value[3], sum = 0;
    int squares = options->loss == CAGD_FIT_SQUARES, known = data->sigma != NULL;
    int d = result->degrees_of_freedom = data->count * (data->dim - 1) - result->rank;
    for (int i = 0; i < data->count; i++) {
        fit_loss(options->loss, options->loss_scale, scaled_square(data, result, i), value);
        sum += value[0];
    }
    result->chi_squared = sum;
    result->reduced_chi_squared = d > 0 ? sum / d : NAN;
    result->aic = known ? sum + 2 * k : n * log(sum / n) + 2 * (k + 1);
    result->bic = known ? sum + k * log(n) : n * log(sum / n) + (k + 1) * log(n);
    if (squares && known) {
        result->scale_squared = 1;
        result->quantile = fit_normal_quantile();
    } else {
        result->scale_squared = d <= 0    ? NAN
                                : squares ? result->reduced_chi_squared
                                          : m_estimate_scale(data, options, result);
        result->quantile = fit_student_quantile(d);
    }
    for (int m = 0; m < result->unknowns * result->unknowns; m++)
        result->covariance[m] *= result->scale_squared;
}

/* ---- Functions of the unknowns --------------------------------------------------------------------- */

/* The derivative of a function f of the curve by one unknown. */
typedef double derivative(const cagd_fit_unknown *by, const void *f);

/* sqrt(g^T covariance g), g the gradient: the delta method. */
static double error_of(const cagd_fit_result *result, derivative *g, const void *f)
{
    int n = result->unknowns;
    double variance = 0;
    for (int a = 0; a < n; a++) {
        double ga = g(&result->unknown[a], f);
        if (ga != 0)
            for (int b = 0; b < n; b++)
                variance += ga * g(&result->unknown[b], f) * result->covariance[a * n + b];
    }
    return variance > 0 ? sqrt(variance) : variance <= 0 ? 0 : NAN;
}

/* By the logarithms of weights, of log I_j, f pointing to j. */
static double log_invariant_derivative(const cagd_fit_unknown *by, const void *f)
{
    int away = by->index - *(const int *)f;
    return !by->is_weight ? 0 : away == 0 ? 2 : away == 1 || away == -1 ? -1 : 0;
}

/* The logarithm is known also of a weight that is itself 0 or infinite in binary64. */
static double log_weight(const cagd_fit_result *result, int j)
{
    double w = result->curve.weights[j];
    for (int k = 0; k < result->unknowns && !(w > 0 && isfinite(w)); k++)
        if (result->unknown[k].is_weight && result->unknown[k].index == j)
            return result->value[k];
    return log(w);
}

static double log_invariant(const cagd_fit_result *result, int j)
{
    if (result->curve.weights == NULL)
        return 0;
    double before = log_weight(result, j - 1), here = log_weight(result, j), after = log_weight(result, j + 1);
    return here - before + (here - after);
}

static void fill_invariants(cagd_fit_result *result)
{
    for (int j = 1; j <= result->invariants; j++) {
        double I = exp(log_invariant(result, j)), error = I * error_of(result, log_invariant_derivative, &j);
        const double *w = result->curve.weights;
        double quotient = w != NULL ? w[j] / w[j - 1] * (w[j] / w[j + 1]) : NAN;
        if (quotient > 0 && isfinite(quotient)) /* the same without the roundings of a logarithm */
            I = quotient;
        for (int a = 0; a < result->unknowns; a++)
            if (log_invariant_derivative(&result->unknown[a], &j) != 0 && !result->at_bound[a] &&
                !result->determined[a])
                error = INFINITY;
        result->invariant[j - 1] = I;
        result->invariant_error[j - 1] = error;
    }
}

void fit_statistics(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result *result)
{
    fill_scale(data, options, result);
    fill_invariants(result);
}

/* ---- Which conic ----------------------------------------------------------------------------------- */

/* The distance h = |P_1 - F| of the middle point from the line P_0 P_2, F = (1-s) P_0 + s P_2, and its direction
 * n = (P_1 - F)/h: dh = n . (dP_1 - (1-s) dP_0 - s dP_2). */
struct height {
    double h, s, normal[3];
};

static struct height height_of(const cagd_fit_result *result)
{
    const double *P = result->relative != NULL ? result->relative : result->curve.points;
    struct height at = {0};
    double chord = 0, along = 0;
    int dim = result->curve.dim;
    for (int c = 0; c < dim; c++) {
        chord += (P[2 * dim + c] - P[c]) * (P[2 * dim + c] - P[c]);
        along += (P[dim + c] - P[c]) * (P[2 * dim + c] - P[c]);
    }
    at.s = chord > 0 ? along / chord : 0;
    for (int c = 0; c < dim; c++) {
        at.normal[c] = P[dim + c] - (1 - at.s) * P[c] - at.s * P[2 * dim + c];
        at.h = hypot(at.h, at.normal[c]);
    }
    for (int c = 0; c < dim && at.h > 0; c++)
        at.normal[c] /= at.h;
    return at;
}

static double height_derivative(const cagd_fit_unknown *by, const void *f)
{
    const struct height *at = f;
    double share = by->index == 0 ? at->s - 1 : by->index == 1 ? 1 : -at->s;
    return by->is_weight ? 0 : share * at->normal[by->coordinate];
}

enum { GIVEN, ON_BOUND, NOT_DETERMINED, DETERMINED };

/* What is known of log I_1.  Free ends slide in two directions, which leave the type as it is. */
static int knowledge_of_type(const cagd_fit_result *result)
{
    int one = 1, knowledge = GIVEN, ends = 0;
    for (int a = 0; a < result->unknowns; a++)
        ends |= !result->unknown[a].is_weight && result->unknown[a].index != 1;
    for (int a = 0; a < result->unknowns; a++)
        if (log_invariant_derivative(&result->unknown[a], &one) != 0) {
            int sliding = ends && result->flat <= 2;
            int known = result->at_bound[a] ? ON_BOUND : result->determined[a] || sliding ? DETERMINED : NOT_DETERMINED;
            knowledge = knowledge == GIVEN || known < knowledge ? known : knowledge;
        }
    return knowledge;
}

cagd_fit_conic cagd_fit_conic_of(const cagd_fit_result *result)
{
    cagd_fit_conic conic = {.kind = CAGD_FIT_NOT_QUADRATIC, .text = "not a curve of degree 2 in one span"};
    const cagd_spline *curve = &result->curve;
    if (curve->degree != 2 || curve->count != 3)
        return conic;
    int one = 1;
    double equal[3] = {1, 1, 1};
    conic.log_invariant = log_invariant(result, 1);
    conic.error = error_of(result, log_invariant_derivative, &one);
    struct height at = height_of(result);
    double error = error_of(result, height_derivative, &at);
    cagd_conic_classify_weights(curve->weights != NULL ? curve->weights : equal, &conic.type);
    int ellipse = conic.type == CAGD_ELLIPSE, parabola = conic.type == CAGD_PARABOLA;
    int knowledge = knowledge_of_type(result);
    if (isnan(conic.error) || isnan(error)) {
        conic.kind = CAGD_FIT_CONIC_UNKNOWN;
        conic.text = "of a type whose uncertainty is unknown: there are no degrees of freedom";
    } else if (at.h <= result->quantile * error || at.h == 0) {
        conic.kind = CAGD_FIT_STRAIGHT;
        conic.text = "cannot tell a conic from a straight line";
    } else if (knowledge == NOT_DETERMINED) {
        conic.kind = CAGD_FIT_CONIC_UNKNOWN;
        conic.text = "of a type that the points do not determine";
    } else if (knowledge == ON_BOUND) {
        conic.kind = CAGD_FIT_CONIC_UNKNOWN;
        conic.text = ellipse ? "an ellipse whose weight is on its bound" : "a hyperbola whose weight is on its bound";
    } else if (knowledge == GIVEN) {
        conic.kind = CAGD_FIT_CONIC_CERTAIN;
        conic.text = ellipse    ? "an ellipse, by its given weights"
                     : parabola ? "a parabola, by its given weights"
                                : "a hyperbola, by its given weights";
    } else if (fabs(conic.log_invariant) > result->quantile * conic.error) {
        conic.kind = CAGD_FIT_CONIC_CERTAIN;
        conic.text = ellipse ? "an ellipse at 95 %" : "a hyperbola at 95 %";
    } else {
        conic.kind = CAGD_FIT_CONIC_UNDECIDED;
        conic.text = ellipse    ? "cannot tell ellipse from parabola"
                     : parabola ? "a parabola, as far as can be told"
                                : "cannot tell hyperbola from parabola";
    }
    return conic;
}
