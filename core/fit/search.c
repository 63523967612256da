#include "core/fit/search.h"

#include "core/fit/candidate.h"
#include "core/fit/strategy.h"
#include "core/require.h"

#include <math.h>
#include <stdlib.h>

cagd_status fit_search_fit(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result **result,
                           int *where)
{
    enum { ITERATIONS = 100 };
    cagd_fit_options o = *options;
    fit_strategy s = fit_usual_strategy;
    s.intervals = 0;
    if (o.max_iterations > ITERATIONS)
        o.max_iterations = ITERATIONS;
    return fit_with_strategy(data, &o, &s, result, where);
}

cagd_status fit_search_over(const fit_search *s, const fit_knots *k, const cagd_fit_result *from,
                            cagd_fit_result **result)
{
    const int p = s->options->degree, closed = s->options->closed, dim = s->data->dim,
              count = fit_knots_count(k, p, closed), all = count + (closed ? p : 0);
    cagd_fit_options o = *s->options;
    double *U = malloc(((size_t)(all + p + 1) + (size_t)(all * dim)) * sizeof *U), *P = U + all + p + 1;
    *result = NULL;
    REQUIRE(U != NULL, CAGD_NO_MEMORY);
    fit_knots_spell(k, p, closed, U);
    cagd_spline initial = {p, all, dim, U, P, NULL};
    o.count = count, o.knots = U;
    if (from != NULL && from->curve.degree == p) {
        fit_respace(&from->curve, from->period, U, all, P);
        o.initial = &initial;
    }
    cagd_status status = fit_search_fit(s->data, &o, result, s->where);
    free(U);
    return status;
}

int fit_search_has_room(const fit_search *s, const fit_knots *k)
{
    const int p = s->options->degree, count = fit_knots_count(k, p, s->options->closed);
    return k->inner < FIT_MOST_KNOTS &&
           (s->dense ? 1 : 2) * count * s->data->dim <= s->data->count * (s->data->dim - 1) + 2 * s->data->dim;
}

int fit_search_fewest_knots(const fit_search *s) { return s->options->closed ? s->options->degree : 0; }

int fit_search_problems(const fit_search *s, const cagd_fit_result *r)
{
    int problems, beneath;
    *s->without_memory |= fit_problems_of(s->data, s->options, r, &problems, &beneath) == CAGD_NO_MEMORY;
    return problems;
}

int fit_search_has_no_loops(const fit_search *s, const cagd_fit_result *r)
{
    return !(fit_search_problems(s, r) & CAGD_FIT_LOOPS);
}

int fit_search_is_shapely(const fit_search *s, const cagd_fit_result *r, int cusp_too)
{
    double t;
    return !(fit_search_problems(s, r) & (s->detours ? FIT_FIGURE : FIT_FIGURE & ~CAGD_FIT_EXCURSIONS)) &&
           !(cusp_too && cagd_fit_has_cusp(r, &t));
}

int fit_search_may_be_best(const fit_search *s, const cagd_fit_result *r)
{
    REQUIRE(s->within > 0, fit_is_good(s->data, s->options, r) &&
                               (!s->shapely || fit_search_is_shapely(s, r, s->shapely == FIT_NO_CUSP)));
    return s->good_alone ? fit_search_has_no_loops(s, r) : cagd_fit_is_minimum(r);
}

int fit_search_is_within(const fit_search *s, const cagd_fit_result *r)
{
    return s->within > 0 && r->largest <= s->within;
}

/* The score of a curve; one that is not good has to be better by what is very strong evidence.  It is not looked at where its score alone is
 * higher than that of the best one.  A detour does not count on the way, where other knots take it away. */
static double score_of_shape(const fit_search *s, const cagd_fit_result *r)
{
    const double score = fit_score(s->data, r);
    return s->best != NULL && score >= s->score
               ? score
               : score + (fit_search_problems(s, r) & ~CAGD_FIT_EXCURSIONS ? FIT_VERY_STRONG : 0);
}

double fit_search_score(const fit_search *s, const fit_knots *k, const cagd_fit_result *r)
{
    if (!fit_search_may_be_best(s, r))
        return HUGE_VAL;
    return !(s->within > 0) ? score_of_shape(s, r) : fit_search_is_within(s, r) ? k->inner - 1e6 : r->largest;
}

int fit_search_is_best(fit_search *s, const fit_knots *k, const cagd_fit_result *r)
{
    double score = fit_search_score(s, k, r);
    int better = s->best == NULL || score < s->score;
    if (better)
        s->score = score, s->at = *k;
    return better;
}

double fit_precision_of(const cagd_fit_data *data)
{
    double sum = 0;
    for (int i = 0; i < data->count; i++)
        sum += data->sigma != NULL ? 1 / (data->sigma[i] * data->sigma[i]) : 1;
    return sum;
}
