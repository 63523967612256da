#include "core/fit/placement.h"

#include "core/require.h"

#include <math.h>
#include <stdlib.h>

enum {
    PATIENCE = 5,      /* so many more knots are tried after the best number          */
    LEAST_IN_SPAN = 3, /* points that a segment keeps on either side of a new knot    */
    SHAPE = FIT_FIGURE | CAGD_FIT_FAR | CAGD_FIT_BACKWARDS
};

/* ---- knots are put in ------------------------------------------------------------------------------------ */

/* The foot of a point, and its squared distance. */
typedef struct squared {
    double foot, square;
} squared;

static int by_foot(const void *a, const void *b)
{
    const squared *x = a, *y = b;
    return (x->foot > y->foot) - (x->foot < y->foot);
}

/* Puts a knot in, as the header says.  Returns 0 where no segment has points enough, -1 when there is no memory. */
static int divide(const fit_search *s, const cagd_fit_result *r, fit_knots *k)
{
    const int n = r->count, segments = k->inner + 1, least = s->dense ? 1 : LEAST_IN_SPAN;
    squared *list = malloc((size_t)n * sizeof *list);
    double best = 0, at = -1;
    if (list == NULL)
        return -1;
    for (int i = 0; i < n; i++)
        list[i] = (squared){r->feet[i], r->distances[i] * r->distances[i]};
    qsort(list, (size_t)n, sizeof *list, by_foot);
    for (int g = 0, low = 0; g < segments; g++) {
        const double end = g < k->inner ? k->u[g] : 2, from = g > 0 ? k->u[g - 1] : 0;
        int high = low;
        double sum = 0, largest = 0, half = 0;
        for (; high < n && list[high].foot < end; high++) {
            sum += list[high].square;
            largest = fmax(largest, list[high].square);
        }
        double size = s->choices->within > 0 ? largest : sum;
        if (high - low >= 2 * least && size > best) {
            int middle = low + least - 1;
            for (int i = low; i <= middle; i++)
                half += list[i].square;
            while (middle < high - least - 1 && half < sum / 2)
                half += list[++middle].square;
            double u = (list[middle].foot + list[middle + 1].foot) / 2;
            if (u > from && u < fmin(end, 1))
                best = size, at = u;
        }
        low = high;
    }
    free(list);
    if (at < 0)
        return 0;
    fit_knots_insert(k, at);
    return 1;
}

cagd_status fit_put_into(fit_search *s, fit_knots k, cagd_fit_result *last, int even, int patience)
{
    enum { MOST_VAIN = 30, FEW = 5 };
    const int vain = s->scattered > 1 ? FEW : MOST_VAIN;
    cagd_status status = CAGD_OK;
    double lowest = HUGE_VAL;
    for (int idle = 0; idle < patience && status == CAGD_OK;) {
        cagd_fit_result *next;
        status = fit_search_over(s, &k, even ? NULL : last, &next);
        if (status != CAGD_OK) {
            if (status == CAGD_TOO_FEW && (last != NULL || s->best != NULL))
                status = CAGD_OK;
            break;
        }
        const double score = fit_search_score(s, &k, next);
        if (fit_search_is_best(s, &k, next)) {
            if (s->best != last)
                cagd_fit_free(s->best);
            s->best = next;
        }
        idle = score < lowest ? 0 : idle + (lowest < HUGE_VAL || k.inner > vain);
        lowest = fmin(lowest, score);
        if (last != s->best)
            cagd_fit_free(last);
        last = next;
        if (next->points_on_curve ||
            (fit_search_is_within(s, next) && (!s->good_alone || fit_search_may_be_best(s, next))) ||
            !fit_search_has_room(s, &k))
            break;
        if (even)
            fit_knots_even(k.inner + 1, &k);
        else {
            int put = divide(s, next, &k);
            if (put < 0)
                status = CAGD_NO_MEMORY;
            if (put <= 0)
                break;
        }
    }
    if (last != s->best)
        cagd_fit_free(last);
    return status;
}

/* The same from as few knots as there can be. */
static cagd_status put_in(fit_search *s, int even)
{
    fit_knots k;
    fit_knots_even(s->options->closed ? s->options->degree + 1 : 0, &k);
    return fit_put_into(s, k, NULL, even, PATIENCE);
}

/* ---- knots are taken out ---------------------------------------------------------------------------------- */

/* Whether the fit over these knots becomes the best one; `lowest`, which others begin with, is not released.  `shape`: not if it has gaps,
 * excursions or loops that `lowest` has not. */
static cagd_status try_knots(fit_search *s, const fit_knots *k, const cagd_fit_result *lowest, int shape, int *better)
{
    cagd_fit_result *next;
    cagd_status status = fit_search_over(s, k, lowest, &next);
    REQUIRE(status == CAGD_OK, status);
    *better = fit_search_score(s, k, next) < s->score &&
              !(shape && fit_search_problems(s, next) & ~fit_search_problems(s, lowest) &
                             (s->detours ? SHAPE : SHAPE & ~CAGD_FIT_EXCURSIONS)) &&
              fit_search_is_best(s, k, next);
    if (*better && s->best != lowest)
        cagd_fit_free(s->best);
    if (*better)
        s->best = next;
    else
        cagd_fit_free(next);
    return CAGD_OK;
}

cagd_status fit_take_out_idle(fit_search *s)
{
    enum { SHIFTS = 4 };
    for (int better = 1; better;) {
        better = 0;
        const fit_knots from = s->at;
        cagd_fit_result *lowest = s->best;
        for (int shift = 0; shift < SHIFTS && !better && from.inner > fit_search_fewest_knots(s); shift++) {
            const int first = shift & 1, last = from.inner - (shift & 2 ? 2 : 1);
            if ((double)s->data->count * from.inner * from.inner * (shift ? SHIFTS : 1) > FIT_MOST_WORK)
                break;
            for (int i = first; i <= last; i++) {
                const fit_knots k = fit_knots_without(&from, i, shift);
                int best;
                cagd_status status = try_knots(s, &k, lowest, shift, &best);
                if (status != CAGD_OK && s->best != lowest)
                    cagd_fit_free(lowest);
                REQUIRE(status == CAGD_OK, status);
                better |= best;
            }
        }
        if (better)
            cagd_fit_free(lowest);
    }
    return CAGD_OK;
}

/* Of a tolerance that is not met, the distance that is: the fewest control points that are found to keep every point within that one. */
static cagd_status settle_for_nearest(fit_search *s)
{
    REQUIRE(s->within > 0 && fit_search_may_be_best(s, s->best) && s->best->largest > s->within, CAGD_OK);
    s->within = s->best->largest;
    s->score = fit_search_score(s, &s->at, s->best);
    return fit_take_out_idle(s);
}

/* ---- both ------------------------------------------------------------------------------------------------- */

/* Knots are put in, each where it helps most, and even ones. */
static cagd_status put_both(fit_search *s)
{
    cagd_status status = put_in(s, 0);
    return status == CAGD_OK && !s->dense ? put_in(s, 1) : status;
}

/* Where the best curve has excursions, loops or gaps, once more among those that have neither them nor a cusp, if there are any. */
static cagd_status put_shapely(fit_search *s)
{
    REQUIRE(s->best != NULL && !s->shapely && !(s->within > 0) && !fit_search_is_shapely(s, s->best, 0), CAGD_OK);
    fit_search again = *s;
    again.best = NULL, again.shapely = FIT_NO_CUSP;
    const cagd_status status = put_both(&again);
    const int found = status == CAGD_OK && again.best != NULL;
    cagd_fit_free(found ? s->best : again.best);
    if (found)
        *s = again;
    return status;
}

static cagd_status search_once(fit_search *s)
{
    const int shapely = s->shapely;
    cagd_status status = put_both(s);
    if (status == CAGD_OK)
        status = put_shapely(s);
    if (status == CAGD_OK && s->best != NULL) {
        if (!s->shapely && !(s->within > 0))
            s->shapely = fit_search_is_shapely(s, s->best, 0) ? FIT_NO_FIGURE : 0;
        status = fit_take_out_idle(s);
    }
    if (status == CAGD_OK && s->best != NULL)
        status = settle_for_nearest(s);
    s->shapely = shapely;
    return status;
}

cagd_status fit_search_knots(fit_search *s)
{
    cagd_status status = search_once(s);
    REQUIRE(status == CAGD_OK && s->best != NULL && !(s->within > 0) &&
                fit_search_problems(s, s->best) & CAGD_FIT_EXCURSIONS,
            status);
    fit_search again = *s; /* once more among those without a detour */
    again.best = NULL, again.shapely = FIT_NO_FIGURE, again.detours = 1;
    status = search_once(&again);
    const int found = status == CAGD_OK && again.best != NULL && fit_search_problems(s, again.best) == 0;
    cagd_fit_free(found ? s->best : again.best);
    if (found)
        s->best = again.best, s->score = again.score, s->at = again.at;
    return status;
}

/* ---- as many as are asked for ----------------------------------------------------------------------------- */

/* The fit takes the place of *last if its cost is lower, and is released otherwise; whether it does. */
static int take_lower(cagd_fit_result *next, cagd_fit_result **last)
{
    const int lower = next->cost < (*last)->cost;
    cagd_fit_free(lower ? *last : next);
    *last = lower ? next : *last;
    return lower;
}

cagd_status fit_place_knots(fit_search *s)
{
    enum { MOST_VAIN = 3 };
    const int p = s->options->degree, closed = s->options->closed;
    fit_knots k;
    cagd_fit_result *last = NULL;
    fit_knots_even(closed ? p + 1 : 0, &k);
    cagd_status status = fit_search_over(s, &k, NULL, &last);
    for (int vain = 0, put = 1; status == CAGD_OK && vain < MOST_VAIN &&
                                fit_knots_count(&k, p, closed) < s->options->count && k.inner < FIT_MOST_KNOTS &&
                                put > 0;) {
        cagd_fit_result *next = NULL;
        put = divide(s, last, &k);
        status = put < 0 ? CAGD_NO_MEMORY : put > 0 ? fit_search_over(s, &k, last, &next) : CAGD_OK;
        if (next != NULL) {
            const int minimum = cagd_fit_is_minimum(next);
            vain = take_lower(next, &last) && minimum ? 0 : vain + 1;
        }
    }
    if (status == CAGD_OK && (closed ? last->period : last->curve.count) == s->options->count &&
        fit_search_has_no_loops(s, last)) {
        cagd_fit_free(s->best);
        s->best = last;
        s->best->found.knots_chosen = 1;
    } else
        cagd_fit_free(last);
    return status == CAGD_TOO_FEW ? CAGD_OK : status;
}
