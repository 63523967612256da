#include "core/fit/continuation.h"

#include <math.h>
#include <stddef.h>

/* A step on the way to another fit, for which its own end need not be reached. */
static cagd_status fit_step(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result **result,
                            int *where)
{
    enum { ITERATIONS = 40 };
    cagd_fit_options o = *options;
    o.tolerance = fmax(o.tolerance, 1e-6);
    if (o.max_iterations > ITERATIONS)
        o.max_iterations = ITERATIONS;
    return fit_search_fit(data, &o, result, where);
}

cagd_status fit_lead_from_smooth(fit_search *s, int *led)
{
    enum { TENTHS = 7 };
    cagd_fit_options o = *s->options;
    cagd_fit_result *last = NULL;
    cagd_status status = CAGD_OK;
    double lambda = fit_precision_of(s->data) * pow(o.count, -4);
    for (int k = 0; k <= TENTHS && status == CAGD_OK; k++, lambda /= 10) {
        cagd_fit_result *next = NULL;
        o.smooth = k < TENTHS ? lambda : 0;
        o.initial = last != NULL ? &last->curve : NULL;
        status = k < TENTHS ? fit_step(s->data, &o, &next, s->where) : fit_search_fit(s->data, &o, &next, s->where);
        cagd_fit_free(last);
        last = next;
    }
    *led = status == CAGD_OK && fit_search_has_no_loops(s, last);
    if (*led) {
        cagd_fit_free(s->best);
        s->best = last;
    } else
        cagd_fit_free(last);
    return status;
}
