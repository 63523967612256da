#include "core/fit/cross_validation.h"

#include "core/fit/candidate.h"
#include "core/require.h"

#include <math.h>
#include <stddef.h>

/* What says that the feet may have gone astray. */
enum { ASTRAY = CAGD_FIT_EXCURSIONS | CAGD_FIT_LOOPS | CAGD_FIT_BACKWARDS | CAGD_FIT_COARSE };

/* n chi^2/(n - 1.4 k)^2 of a minimum; infinite of others. */
static double cross_validation(const cagd_fit_data *data, const cagd_fit_result *r)
{
    const double n = fit_equations_of(data), left = n - 1.4 * fit_unknowns_of(r);
    return cagd_fit_is_minimum(r) && left > 0 ? n * r->chi_squared / (left * left) : HUGE_VAL;
}

/* The fit with the smoothing term lambda, from the curve before if there is one, and from the points if that leads to no good curve, as where the
 * curve before was nearly straight and has its feet where they do not follow the order of the points: the lower of both.  *score: its own. */
static cagd_status smooth_by(const fit_search *s, const cagd_fit_options *options, double lambda,
                             const cagd_fit_result *from, cagd_fit_result **result, double *score)
{
    cagd_fit_options o = *options;
    cagd_fit_result *other = NULL;
    cagd_status status = CAGD_OK;
    *result = NULL;
    o.smooth = lambda;
    o.free &= ~CAGD_FIT_WEIGHTS;
    if (from != NULL) {
        o.initial = &from->curve;
        status = fit_search_fit(s->data, &o, result, s->where);
    }
    if (status == CAGD_OK && (from == NULL || fit_search_problems(s, *result) & ASTRAY)) {
        o.initial = options->initial;
        status = fit_search_fit(s->data, &o, &other, s->where);
    }
    if (*result == NULL || (other != NULL && cagd_fit_is_minimum(other) &&
                            (!cagd_fit_is_minimum(*result) || other->cost < (*result)->cost))) {
        cagd_fit_result *higher = *result;
        *result = other;
        other = higher;
    }
    cagd_fit_free(other);
    if (status != CAGD_OK) {
        cagd_fit_free(*result);
        *result = NULL;
    }
    *score = status == CAGD_OK ? cross_validation(s->data, *result) : HUGE_VAL;
    return status;
}

/* The best of the fits with a smoothing term, its weight and score, and whether it has loops or excursions. */
typedef struct smoothest {
    cagd_fit_result *fit;
    double lambda, score;
    int loops;
} smoothest;

/* The next fit takes the place of the best one if its score is lower; one with loops only that of others with loops.  Whether it does. */
static int is_better_smoothed(const fit_search *s, cagd_fit_result *next, double lambda, double score, smoothest *best)
{
    REQUIRE(isfinite(score), 0);
    const int loops = !fit_search_has_no_loops(s, next),
              better = best->fit == NULL || loops < best->loops || (loops == best->loops && score < best->score);
    if (better)
        *best = (smoothest){next, lambda, score, loops};
    return better;
}

/* From a weight that leaves a straight line downwards in tenths, each fit from the one before, until the points determine MOST of the unknowns, and
 * a smaller weight helps no more. */
static cagd_status smooth_downwards(const fit_search *s, const cagd_fit_options *options, smoothest *best)
{
    enum { TENTHS = 22, PATIENT = 2 };
    const double most = 0.9;
    double lambda = fit_precision_of(s->data), score;
    cagd_fit_result *last = NULL;
    cagd_status status = CAGD_OK;
    for (int k = 0, idle = 0; k < TENTHS && idle < PATIENT && status == CAGD_OK; k++, lambda /= 10) {
        cagd_fit_result *next;
        status = smooth_by(s, options, lambda, last, &next, &score);
        if (status != CAGD_OK)
            break;
        if (last != best->fit)
            cagd_fit_free(last);
        cagd_fit_result *before = best->fit;
        if (is_better_smoothed(s, next, lambda, score, best)) {
            idle = 0;
            cagd_fit_free(before);
        } else
            idle = next->effective > most * next->unknowns ? idle + 1 : 0;
        last = next;
    }
    if (last != best->fit)
        cagd_fit_free(last);
    return status;
}

/* Between the neighbours of the best weight: by factors of 10^(1/2), 10^(1/4), 10^(1/8), upwards or else downwards. */
static cagd_status smooth_between(const fit_search *s, const cagd_fit_options *options, smoothest *best)
{
    for (double step = 0.5; step > 0.1; step /= 2)
        for (int down = 0, better = 0; down < 2 && !better; down++) {
            const double lambda = best->lambda * pow(10, down ? -step : step);
            cagd_fit_result *next, *before = best->fit;
            double score;
            cagd_status status = smooth_by(s, options, lambda, before, &next, &score);
            REQUIRE(status == CAGD_OK, status);
            better = is_better_smoothed(s, next, lambda, score, best);
            cagd_fit_free(better ? before : next);
        }
    return CAGD_OK;
}

cagd_status fit_smooth_best(const fit_search *s, const cagd_fit_options *options, int how, cagd_fit_result **result)
{
    smoothest best = {NULL, 0, HUGE_VAL, 1};
    cagd_status status = smooth_downwards(s, options, &best);
    if (status == CAGD_OK && best.fit != NULL)
        status = smooth_between(s, options, &best);
    if (status == CAGD_OK && best.fit != NULL) {
        best.fit->found.smoothed = how;
        best.fit->found.smooth = best.lambda;
        cagd_fit_free(*result);
        *result = best.fit;
    } else
        cagd_fit_free(best.fit);
    return status;
}

int fit_most_points(const fit_search *s)
{
    enum { MOST = 40 };
    fit_knots k;
    fit_knots_even(s->options->closed ? s->options->degree + 1 : 0, &k);
    while (fit_search_has_room(s, &k) && k.inner < MOST)
        fit_knots_even(k.inner + 1, &k);
    return fit_knots_count(&k, s->options->degree, s->options->closed);
}
