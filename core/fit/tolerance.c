#include "core/fit/tolerance.h"

#include "core/fit/continuation.h"
#include "core/fit/placement.h"
#include "core/require.h"

#include <math.h>
#include <stddef.h>

/* The spline over even knots, led to from a smooth one, takes the place of the best one if it comes nearer to the points; *nearer says
 * whether it does. */
static cagd_status lead_over_even(fit_search *s, const fit_knots *k, int *nearer)
{
    const cagd_fit_options *asked = s->options;
    cagd_fit_options own = *asked;
    fit_search one = *s;
    int led;
    own.count = fit_knots_count(k, own.degree, own.closed);
    one.options = &own, one.best = NULL;
    cagd_status status = fit_lead_from_smooth(&one, &led);
    *nearer = status == CAGD_OK && led && (s->best == NULL || one.best->largest < s->best->largest);
    if (*nearer) {
        cagd_fit_free(s->best);
        s->best = one.best, s->at = *k;
        s->score = fit_search_score(s, k, s->best);
    } else
        cagd_fit_free(one.best);
    return status;
}

/* With a tolerance: even knots, a quarter more of them each time, until one curve keeps within it or PATIENT have come no nearer; then knots are
 * taken out. */
static cagd_status search_from_smooth(fit_search *s)
{
    enum { FEWEST = 4, PATIENT = 3 };
    cagd_status status = CAGD_OK;
    fit_knots k;
    fit_knots_even(s->options->closed ? s->options->degree + 1 : FEWEST, &k);
    for (int idle = 0; status == CAGD_OK && idle < PATIENT && fit_search_has_room(s, &k);
         fit_knots_even(k.inner + k.inner / 4, &k)) {
        int nearer;
        status = lead_over_even(s, &k, &nearer);
        idle = nearer ? 0 : idle + 1;
        if (nearer && fit_search_is_within(s, s->best))
            break;
    }
    if (status == CAGD_TOO_FEW)
        status = CAGD_OK;
    if (status == CAGD_OK && s->best != NULL)
        status = fit_take_out_idle(s);
    return status;
}

/* The spline over these even knots with as large a smoothing term, to a factor of 10, as lets it keep within the distance without loops.  It,
 * or the one that comes nearest to that, becomes the best one if it comes nearer than the one before; *met says whether it keeps within. */
static cagd_status smooth_within(fit_search *s, const fit_knots *k, int *met)
{
    enum { TENTHS = 14 };
    cagd_fit_options o = *s->options;
    cagd_fit_result *last = NULL;
    cagd_status status = CAGD_OK;
    o.count = fit_knots_count(k, o.degree, o.closed);
    o.smooth = fit_precision_of(s->data) * pow(o.count, -4);
    *met = 0;
    for (int tenth = 0; tenth < TENTHS && status == CAGD_OK && !*met; tenth++) {
        cagd_fit_result *next = NULL;
        o.smooth = tenth > 0 ? o.smooth / 10 : o.smooth;
        o.initial = last != NULL ? &last->curve : NULL;
        status = fit_search_fit(s->data, &o, &next, s->where);
        if (last != s->best)
            cagd_fit_free(last);
        last = next;
        if (status != CAGD_OK || !fit_search_has_no_loops(s, last) || last->degrees_of_freedom <= 0 ||
            (s->best != NULL && last->largest >= s->best->largest))
            continue;
        cagd_fit_free(s->best);
        s->best = last, s->at = *k;
        s->best->found.smoothed = 3, s->best->found.smooth = o.smooth;
        *met = fit_search_is_within(s, last);
    }
    if (last != s->best)
        cagd_fit_free(last);
    return status;
}

/* With a tolerance that no curve keeps without a smoothing term: even knots, a quarter more of them each time, with one. */
static cagd_status search_smoothed(fit_search *s)
{
    enum { FEWEST = 4 };
    cagd_status status = CAGD_OK;
    int met = 0;
    fit_knots k;
    fit_knots_even(s->options->closed ? s->options->degree + 1 : FEWEST, &k);
    while (status == CAGD_OK && !met && fit_knots_count(&k, s->options->degree, s->options->closed) <= s->data->count &&
           k.inner < FIT_MOST_KNOTS && (double)s->data->count * k.inner * k.inner <= FIT_MOST_WORK) {
        status = smooth_within(s, &k, &met);
        fit_knots_even(k.inner + k.inner / 4, &k);
    }
    return status == CAGD_TOO_FEW ? CAGD_OK : status;
}

/* Whether the best curve keeps within the distance that is asked for, without loops. */
static int answers(const fit_search *s)
{
    return s->best != NULL && s->best->largest <= s->choices->within && fit_search_has_no_loops(s, s->best);
}

/* Whether the best curve of the one is a better answer to a tolerance than that of the other. */
static int answers_better(const fit_search *one, const fit_search *other)
{
    REQUIRE(one->best != NULL && !answers(other), 0);
    const int loops = !fit_search_has_no_loops(one, one->best), others = !fit_search_has_no_loops(other, other->best);
    return answers(one) || (loops != others ? loops < others : one->best->largest < other->best->largest);
}

cagd_status fit_search_within(fit_search *s)
{
    enum { GOOD, PLACED, EVEN, SMOOTHED, WAYS };
    cagd_status status = CAGD_OK;
    for (int way = GOOD; way < WAYS && status == CAGD_OK && !answers(s); way++) {
        if (way == GOOD && fit_search_has_no_loops(s, s->best))
            continue;
        fit_search again = *s;
        again.best = NULL, again.within = s->choices->within, again.good_alone = 1, again.dense = way != GOOD;
        status = way == SMOOTHED ? search_smoothed(&again)
                 : way == EVEN   ? search_from_smooth(&again)
                                 : fit_search_knots(&again);
        const int taken = status == CAGD_OK && answers_better(&again, s);
        cagd_fit_free(taken ? s->best : again.best);
        if (taken)
            *s = again;
    }
    s->dense = 0;
    return status;
}
