#include "core/fit/scattered.h"

#include "core/fit/cross_validation.h"
#include "core/fit/means.h"
#include "core/fit/placement.h"
#include "core/require.h"

#include <math.h>
#include <stddef.h>

/* The knots without the one that the fit needs least; *fit becomes the fit over them, NULL where there is none. */
static cagd_status drop_a_knot(const fit_search *s, fit_knots *k, cagd_fit_result **fit)
{
    const fit_knots from = *k;
    cagd_fit_result *best = NULL;
    for (int i = 0; i < from.inner && from.inner > fit_search_fewest_knots(s); i++) {
        const fit_knots one = fit_knots_without(&from, i, 0);
        cagd_fit_result *next;
        const cagd_status status = fit_search_over(s, &one, *fit, &next);
        REQUIRE(status == CAGD_OK, (cagd_fit_free(best), status));
        const int better = cagd_fit_is_minimum(next) && (best == NULL || next->cost < best->cost);
        cagd_fit_free(better ? best : next);
        if (better)
            best = next, *k = one;
    }
    cagd_fit_free(*fit);
    *fit = best;
    return CAGD_OK;
}

/* The curve over the knots of a fit to means, begun with that fit, through all points; where that is not good, over fewer of these knots.  It
 * becomes the best one. */
static cagd_status from_means(fit_search *s, fit_search *of_means)
{
    fit_knots k = of_means->at;
    cagd_status status = CAGD_OK;
    while (status == CAGD_OK && of_means->best != NULL) {
        cagd_fit_result *all;
        status = fit_search_over(s, &k, of_means->best, &all);
        REQUIRE(status == CAGD_OK, status);
        if (isfinite(fit_search_score(s, &k, all)) && fit_search_is_best(s, &k, all)) {
            s->best = all;
            break;
        }
        cagd_fit_free(all);
        status = drop_a_knot(of_means, &k, &of_means->best);
    }
    return status;
}

cagd_status fit_search_by_means(fit_search *s)
{
    REQUIRE(s->scattered > 1, CAGD_OK);
    cagd_fit_data means;
    cagd_status status = fit_means(s->data, s->scattered, &means);
    fit_search of_means = *s;
    of_means.data = &means, of_means.scattered = 1, of_means.shapely = s->shapely = FIT_NO_FIGURE;
    if (status == CAGD_OK)
        status = fit_search_knots(&of_means);
    if (status == CAGD_OK)
        status = from_means(s, &of_means);
    if (status == CAGD_OK && s->best != NULL)
        status = fit_put_into(s, s->at, s->best, 0, 1);
    if (status == CAGD_OK && s->best != NULL)
        status = fit_take_out_idle(s);
    s->shapely = 0;
    cagd_fit_free(of_means.best);
    fit_means_free(&means);
    return status == CAGD_TOO_FEW ? CAGD_OK : status;
}

cagd_status fit_smooth_by_means(const fit_search *s, const cagd_fit_options *options, int how, int chosen,
                                cagd_fit_result **result)
{
    cagd_fit_data means;
    cagd_fit_options o = *options;
    cagd_fit_result *first = NULL, *all = NULL;
    cagd_status status = fit_means(s->data, s->scattered, &means);
    fit_search of_means = *s;
    of_means.data = &means, of_means.scattered = 1;
    if (status == CAGD_OK && chosen)
        o.count = fit_most_points(&of_means);
    if (status == CAGD_OK)
        status = fit_smooth_best(&of_means, &o, how, &first);
    if (status == CAGD_OK && first != NULL) {
        o.smooth = first->found.smooth * fit_precision_of(s->data) / fit_precision_of(&means);
        o.initial = &first->curve;
        o.free &= ~CAGD_FIT_WEIGHTS;
        status = fit_search_fit(s->data, &o, &all, s->where);
    }
    const int led = status == CAGD_OK && all != NULL && cagd_fit_is_minimum(all);
    if (led) {
        all->found.smoothed = how;
        all->found.smooth = o.smooth;
        cagd_fit_free(*result);
        *result = all;
    } else
        cagd_fit_free(all);
    cagd_fit_free(first);
    fit_means_free(&means);
    o = *options;
    o.count = chosen ? fit_most_points(s) : o.count;
    return led || (status != CAGD_OK && status != CAGD_TOO_FEW) ? status : fit_smooth_best(s, &o, how, result);
}
