#include "core/fit/refine.h"

#include "core/fit/candidate.h"
#include "core/fit/continuation.h"
#include "core/fit/cross_validation.h"
#include "core/fit/fit.h"
#include "core/fit/means.h"
#include "core/fit/placement.h"
#include "core/fit/scattered.h"
#include "core/fit/tolerance.h"
#include "core/require.h"

#include <stddef.h>

/* The chosen curve once more, with all that is said of it; the one that was chosen, where that leads from a good curve to none. */
static cagd_status finish(const fit_search *s, const cagd_fit_options *options, cagd_fit_result **result)
{
    cagd_fit_result *last = *result;
    cagd_fit_options o = *options;
    o.initial = &last->curve;
    o.smooth = last->found.smooth > 0 ? last->found.smooth : options->smooth;
    o.free &= ~CAGD_FIT_WEIGHTS;
    o.without_intervals = options->without_intervals || last->found.knots_chosen;
    cagd_status status = fit_plainly(s->data, &o, result, s->where);
    REQUIRE(status == CAGD_OK, (cagd_fit_free(last), status));
    const int worse = (fit_is_good(s->data, options, last) && !fit_is_good(s->data, options, *result)) ||
                      (fit_search_is_shapely(s, last, 0) && !fit_search_is_shapely(s, *result, 0)) ||
                      (last->found.smoothed == 3 && (fit_search_is_within(s, *result) < fit_search_is_within(s, last) ||
                                                     !fit_search_has_no_loops(s, *result)));
    (*result)->found = last->found;
    cagd_fit_free(worse ? *result : last);
    *result = worse ? last : *result;
    return CAGD_OK;
}

/* The number of control points, and the knots.  Of scattered points by means, of others by all of them; with a tolerance, minima that are not good
 * lead to good ones by what is taken out of them, and where they do not, or do not meet it, to other ways. */
static cagd_status find_knots(fit_search *s)
{
    cagd_status status = fit_search_by_means(s);
    if (status == CAGD_OK && s->best == NULL)
        status = fit_search_knots(s);
    if (status == CAGD_OK && s->within > 0 && s->best != NULL)
        status = fit_search_within(s);
    if (status == CAGD_OK && s->best != NULL)
        s->best->found.count_chosen = s->best->found.knots_chosen = 1;
    return status;
}

cagd_status fit_refined(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_choices *choices,
                        cagd_fit_result **result, int *where)
{
    cagd_fit_options own = *options;
    int without_memory = 0;
    fit_search s = {.data = data,
                    .options = &own,
                    .choices = choices,
                    .where = where,
                    .without_memory = &without_memory,
                    .within = choices->within};
    s.scattered = own.unordered || s.within > 0 ? 1 : fit_neighbours(data);
    const int chosen = choices->count || choices->within > 0;
    if (chosen || choices->smooth == 1)
        own.free &= ~CAGD_FIT_WEIGHTS;
    const int smooth_only = chosen && !(choices->within > 0) && (choices->smooth == 1 || own.smooth > 0);
    cagd_status status = smooth_only ? CAGD_OK : chosen ? find_knots(&s) : fit_plainly(data, &own, &s.best, where);
    const int segments = own.count > own.degree + 1 || own.knots != NULL || own.closed || chosen;
    const int mended = choices->smooth == 2 && segments && !(own.free & CAGD_FIT_WEIGHTS) && own.smooth == 0;
    int led = 0;
    if (status == CAGD_OK && mended && !chosen && own.knots == NULL) {
        if (!fit_search_has_no_loops(&s, s.best) && own.degree > 1)
            status = fit_lead_from_smooth(&s, &led);
        if (status == CAGD_OK && !fit_search_has_no_loops(&s, s.best))
            status = fit_place_knots(&s);
    }
    const int good = status == CAGD_OK && s.best != NULL && fit_is_good(data, &own, s.best);
    if (status == CAGD_OK && own.smooth == 0 && own.degree > 1 && (choices->smooth == 1 || (mended && !good))) {
        cagd_fit_options smoothed = own;
        if (chosen)
            smoothed.count = fit_most_points(&s);
        status = s.scattered > 1 ? fit_smooth_by_means(&s, &own, choices->smooth, chosen, &s.best)
                                 : fit_smooth_best(&s, &smoothed, choices->smooth, &s.best);
    }
    if (status == CAGD_OK && without_memory)
        status = CAGD_NO_MEMORY;
    if (status == CAGD_OK && smooth_only && own.smooth > 0) {
        own.count = fit_most_points(&s);
        return fit_plainly(data, &own, result, where);
    }
    if (status == CAGD_OK && s.best == NULL) /* no smoothing leads to a minimum */
        return fit_refined(data, options, &(cagd_fit_choices){.count = choices->count}, result, where);
    if (status == CAGD_OK &&
        (led || s.best->found.knots_chosen || chosen || (s.best->found.smoothed && own.smooth == 0)))
        status = finish(&s, &own, &s.best);
    if (status == CAGD_OK && choices->within > 0)
        s.best->found.within = s.best->largest <= choices->within ? 1 : -1;
    if (status == CAGD_OK)
        *result = s.best;
    else
        cagd_fit_free(s.best);
    return status;
}
