#include "core/fit/cagd_fit.h"

#include "core/fit/invariant.h"
#include "core/fit/propagation.h"

#include <math.h>
#include <stddef.h>

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
        if (fit_log_invariant_derivative(&result->unknown[a], &one) != 0) {
            int sliding = ends && result->flat <= 2;
            int known = result->at_bound[a] ? ON_BOUND : result->determined[a] || sliding ? DETERMINED : NOT_DETERMINED;
            knowledge = knowledge == GIVEN || known < knowledge ? known : knowledge;
        }
    return knowledge;
}

/* Whether the 95 % interval of log I_1 contains 0: where I_1 has one by the profile of the cost, that, and where it has none, or none
 * was sought, no type is certain. */
static int contains_parabola(const cagd_fit_result *result, const cagd_fit_conic *conic)
{
    int by = result->interval_by != NULL && result->invariants > 0 ? (int)result->interval_by[result->unknowns] : 0;
    const double *interval = result->interval + 2 * (by != 0 ? result->unknowns : 0);
    if (by == CAGD_FIT_INTERVAL_PROFILE)
        return interval[0] <= 0 && interval[1] >= 0;
    return by != CAGD_FIT_INTERVAL_LINEAR || fabs(conic->log_invariant) <= result->quantile * conic->error;
}

/* The type of a curve that is a conic, as far as it is known. */
static void judge(int knowledge, const cagd_fit_result *result, cagd_fit_conic *conic)
{
    int ellipse = conic->type == CAGD_ELLIPSE, parabola = conic->type == CAGD_PARABOLA;
    if (knowledge == NOT_DETERMINED) {
        conic->kind = CAGD_FIT_CONIC_UNKNOWN;
        conic->text = "of a type that the points do not determine";
    } else if (knowledge == ON_BOUND) {
        conic->kind = CAGD_FIT_CONIC_UNKNOWN;
        conic->text = ellipse ? "an ellipse whose weight is on its bound" : "a hyperbola whose weight is on its bound";
    } else if (knowledge == GIVEN) {
        conic->kind = CAGD_FIT_CONIC_CERTAIN;
        conic->text = ellipse    ? "an ellipse, by its given weights"
                      : parabola ? "a parabola, by its given weights"
                                 : "a hyperbola, by its given weights";
    } else if (!contains_parabola(result, conic)) {
        conic->kind = CAGD_FIT_CONIC_CERTAIN;
        conic->text = ellipse ? "an ellipse at 95 %" : "a hyperbola at 95 %";
    } else {
        conic->kind = CAGD_FIT_CONIC_UNDECIDED;
        conic->text = ellipse    ? "cannot tell ellipse from parabola"
                      : parabola ? "a parabola, as far as can be told"
                                 : "cannot tell hyperbola from parabola";
    }
}

cagd_fit_conic cagd_fit_conic_of(const cagd_fit_result *result)
{
    cagd_fit_conic conic = {.kind = CAGD_FIT_NOT_QUADRATIC, .text = "not a curve of degree 2 in one span"};
    const cagd_spline *curve = &result->curve;
    if (curve->degree != 2 || curve->count != 3)
        return conic;
    int one = 1;
    double equal[3] = {1, 1, 1};
    conic.log_invariant = fit_log_invariant(result, 1);
    conic.error = fit_propagated_error(result, fit_log_invariant_derivative, &one);
    struct height at = height_of(result);
    double error = fit_propagated_error(result, height_derivative, &at);
    cagd_conic_classify_weights(curve->weights != NULL ? curve->weights : equal, &conic.type);
    if (knowledge_of_type(result) == NOT_DETERMINED) {
        judge(NOT_DETERMINED, result, &conic);
    } else if (isnan(conic.error) || isnan(error)) {
        conic.kind = CAGD_FIT_CONIC_UNKNOWN;
        conic.text = "of a type whose uncertainty is unknown: there are no degrees of freedom";
    } else if (at.h <= result->quantile * error || at.h == 0) {
        conic.kind = CAGD_FIT_STRAIGHT;
        conic.text = "cannot tell a conic from a straight line";
    } else {
        judge(knowledge_of_type(result), result, &conic);
    }
    return conic;
}
