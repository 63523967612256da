#include "core/fit/refine.h"

#include "core/fit/candidate.h"
#include "core/fit/fit.h"
#include "core/fit/means.h"
#include "core/fit/strategy.h"
#include "core/number/limits.h"
#include "core/require.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST_KNOTS = 120,   /* inner knots, of a closed curve segments                                      */
    PATIENCE = 5,       /* so many more knots are tried after the best number                           */
    LEAST_IN_SPAN = 3,  /* points that a segment keeps on either side of a new knot                     */
    MOST_WORK = 4000000 /* points times the square of knots, up to which knots are taken out one by one */
};

/* ---- knots ------------------------------------------------------------------------------------------- */

/* Inner knots between 0 and 1; of a closed curve also 0, the seam, which is not among them. */
typedef struct knots {
    int inner;
    double u[MOST_KNOTS + 1];
} knots;

static int count_of(const knots *k, int degree, int closed) { return closed ? k->inner + 1 : k->inner + degree + 1; }

/* Knot i of a closed curve's period 0, inner knots; i may be any. */
static double periodic_knot(const knots *k, int i)
{
    const int n = k->inner + 1, turns = i >= 0 ? i / n : -((n - 1 - i) / n), at = i - turns * n;
    return turns + (at == 0 ? 0 : k->u[at - 1]);
}

/* All knots, as cagd_fit takes them. */
static void spell(const knots *k, int degree, int closed, double U[])
{
    const int count = count_of(k, degree, closed), all = count + degree + (closed ? degree : 0) + 1;
    for (int i = 0; i < all; i++)
        U[i] = closed ? periodic_knot(k, i - degree) : i <= degree ? 0 : i >= count ? 1 : k->u[i - degree - 1];
}

static void make_even(int inner, knots *k)
{
    k->inner = inner;
    for (int i = 0; i < inner; i++)
        k->u[i] = (double)(i + 1) / (inner + 1);
}

static void insert(knots *k, double u)
{
    int at = k->inner++;
    for (; at > 0 && k->u[at - 1] > u; at--)
        k->u[at] = k->u[at - 1];
    k->u[at] = u;
}

static void take_out(knots *k, int at)
{
    for (int i = at; i < k->inner - 1; i++)
        k->u[i] = k->u[i + 1];
    k->inner--;
}

/* ---- a spline on other knots -------------------------------------------------------------------------- */

/* The polar form of the segment over [u_mu, u_mu+1] at the arguments a_1, ..., a_p, less `shift`. */
static void polar_form(const cagd_spline *c, int mu, const double a[], double shift, double P[])
{
    const int p = c->degree, dim = c->dim;
    double d[(MAX_DEGREE + 1) * 3];
    memcpy(d, c->points + (mu - p) * dim, (size_t)((p + 1) * dim) * sizeof *d);
    for (int r = 1; r <= p; r++)
        for (int i = 0; i <= p - r; i++) {
            const double *u = c->knots + mu - p + r + i;
            const double s = (a[r - 1] - shift - u[0]) / (u[p + 1 - r] - u[0]);
            for (int x = 0; x < dim; x++)
                d[i * dim + x] += s * (d[(i + 1) * dim + x] - d[i * dim + x]);
        }
    memcpy(P, d, (size_t)dim * sizeof *P);
}

void fit_respace(const cagd_spline *from, int period, const double v[], int count, double to[])
{
    const int p = from->degree;
    const double start = from->knots[p], end = from->knots[from->count];
    for (int j = 0; j < count; j++) {
        int span = -1; /* the one nearest to the middle of what the point moves */
        for (int i = j; i <= j + p; i++)
            if (v[i] < v[i + 1] && i >= (period ? 0 : p) && (period || i < count) &&
                (span < 0 || abs(2 * i - 2 * j - p) < abs(2 * span - 2 * j - p)))
                span = i;
        double middle = (v[span] + v[span + 1]) / 2,
               shift = period ? floor((middle - start) / (end - start)) * (end - start) : 0;
        int mu = p;
        while (mu < from->count - 1 && from->knots[mu + 1] <= middle - shift)
            mu++;
        polar_form(from, mu, v + j + 1, shift, to + j * from->dim);
    }
}

/* ---- one fit ------------------------------------------------------------------------------------------ */

/* Excursions, loops and gaps; a cusp as well. */
enum { NO_FIGURE = 1, NO_CUSP };

typedef struct search {
    const cagd_fit_data *data;
    const cagd_fit_options *options;
    const cagd_fit_choices *choices;
    int *where;
    int *without_memory; /* becomes 1 where there was not enough to look at a fit */
    cagd_fit_result *best;
    double within;  /* with a tolerance, the distance that every point is to keep within       */
    int good_alone; /* with a tolerance, whether a minimum that is not good or has loops is passed over too */
    int shapely;    /* what a curve is passed over for: nothing, or one of the two below    */
    int scattered; /* how many neighbours it takes until points do not scatter by more than they are apart, see means.h */
    int dense;     /* with a tolerance, whether segments and degrees of freedom may be as few as they can */
    double score;
    knots at; /* of the best one */
} search;

/* A fit among many, without intervals by the profile, which takes much longer than one that will not converge is worth. */
static cagd_status fit_candidate(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result **result,
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

/* A step on the way to another fit, for which its own end need not be reached. */
static cagd_status fit_step(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result **result,
                            int *where)
{
    enum { ITERATIONS = 40 };
    cagd_fit_options o = *options;
    o.tolerance = fmax(o.tolerance, 1e-6);
    if (o.max_iterations > ITERATIONS)
        o.max_iterations = ITERATIONS;
    return fit_candidate(data, &o, result, where);
}

/* The spline on these knots, from the one before if there is one. */
static cagd_status fit_on(const search *s, const knots *k, const cagd_fit_result *from, cagd_fit_result **result)
{
    const int p = s->options->degree, closed = s->options->closed, dim = s->data->dim, count = count_of(k, p, closed),
              all = count + (closed ? p : 0);
    cagd_fit_options o = *s->options;
    double *U = malloc(((size_t)(all + p + 1) + (size_t)(all * dim)) * sizeof *U), *P = U + all + p + 1;
    *result = NULL;
    REQUIRE(U != NULL, CAGD_NO_MEMORY);
    spell(k, p, closed, U);
    cagd_spline initial = {p, all, dim, U, P, NULL};
    o.count = count, o.knots = U;
    if (from != NULL && from->curve.degree == p) {
        fit_respace(&from->curve, from->period, U, all, P);
        o.initial = &initial;
    }
    cagd_status status = fit_candidate(s->data, &o, result, s->where);
    free(U);
    return status;
}

/* Whether a curve with so many unknowns leaves half of the equations, of a dense one whether there are as many equations. */
static int has_room(const search *s, const knots *k)
{
    const int p = s->options->degree, count = count_of(k, p, s->options->closed);
    return k->inner < MOST_KNOTS &&
           (s->dense ? 1 : 2) * count * s->data->dim <= s->data->count * (s->data->dim - 1) + 2 * s->data->dim;
}

/* What is not good about the curve of a fit, and about its control points and feet as well. */
enum {
    FIGURE = CAGD_FIT_EXCURSIONS | CAGD_FIT_LOOPS | CAGD_FIT_GAPS,
    SHAPE = FIGURE | CAGD_FIT_FAR | CAGD_FIT_BACKWARDS
};

/* What is not good about a fit; all of it where it is no minimum or has excursions. */
static int problems_of(const search *s, const cagd_fit_result *r)
{
    int problems;
    *s->without_memory |= fit_problems_of(s->data, s->options, r, &problems) == CAGD_NO_MEMORY;
    return problems;
}

/* A good fit that crosses itself no more often than its points do. */
static int has_no_loops(const search *s, const cagd_fit_result *r) { return !(problems_of(s, r) & CAGD_FIT_LOOPS); }

/* Whether the curve has no excursions, loops and gaps and, if that is asked, does not turn back as at a cusp. */
static int is_shapely(const search *s, const cagd_fit_result *r, int cusp_too)
{
    double t;
    return !(problems_of(s, r) & FIGURE) && !(cusp_too && cagd_fit_has_cusp(r, &t));
}

/* Whether the fit is one that the search may end with. */
static int may_be_best(const search *s, const cagd_fit_result *r)
{
    REQUIRE(s->within > 0, fit_is_good(s->data, s->options, r) && (!s->shapely || is_shapely(s, r, s->shapely == NO_CUSP)));
    return s->good_alone ? has_no_loops(s, r) : cagd_fit_is_minimum(r);
}

/* Whether it keeps every point within the distance that is asked for. */
static int is_within(const search *s, const cagd_fit_result *r) { return s->within > 0 && r->largest <= s->within; }

/* The score of a curve; one that is not good has to be better by what is very strong evidence.  It is not looked at where its score alone is
 * higher than that of the best one. */
static double score_of_shape(const search *s, const cagd_fit_result *r)
{
    const double score = fit_score(s->data, r);
    return s->best != NULL && score >= s->score ? score : score + (problems_of(s, r) != 0 ? FIT_VERY_STRONG : 0);
}

/* The smaller the better, and infinite of what may not be best: with a tolerance the number of points, once it is met. */
static double score_of(const search *s, const knots *k, const cagd_fit_result *r)
{
    if (!may_be_best(s, r))
        return HUGE_VAL;
    return !(s->within > 0) ? score_of_shape(s, r) : is_within(s, r) ? k->inner - 1e6 : r->largest;
}

/* Takes the result for the best one if it is; whether it is.  It is not released. */
static int is_best(search *s, const knots *k, const cagd_fit_result *r)
{
    double score = score_of(s, k, r);
    int better = s->best == NULL || score < s->score;
    if (better)
        s->score = score, s->at = *k;
    return better;
}

/* The chosen curve once more, with all that is said of it; the one that was chosen, where that leads from a good curve to none. */
static cagd_status finish(const search *s, const cagd_fit_options *options, cagd_fit_result **result)
{
    cagd_fit_result *last = *result;
    cagd_fit_options o = *options;
    o.initial = &last->curve;
    o.smooth = last->found.smooth > 0 ? last->found.smooth : options->smooth;
    o.free &= ~CAGD_FIT_WEIGHTS;
    o.without_intervals = options->without_intervals || last->found.knots_chosen;
    cagd_status status = fit_plainly(s->data, &o, result, s->where);
    REQUIRE(status == CAGD_OK, (cagd_fit_free(last), status));
    const int worse =
        (fit_is_good(s->data, options, last) && !fit_is_good(s->data, options, *result)) ||
        (is_shapely(s, last, 0) && !is_shapely(s, *result, 0)) ||
        (last->found.smoothed == 3 && (is_within(s, *result) < is_within(s, last) || !has_no_loops(s, *result)));
    (*result)->found = last->found;
    cagd_fit_free(worse ? *result : last);
    *result = worse ? last : *result;
    return CAGD_OK;
}

/* ---- where a knot goes ---------------------------------------------------------------------------------- */

typedef struct keyed {
    double key, square;
} keyed;

static int by_key(const void *a, const void *b)
{
    const keyed *x = a, *y = b;
    return (x->key > y->key) - (x->key < y->key);
}

/* The segment with the largest sum of squared distances, with a tolerance that with the largest distance, is divided where half of that sum lies on either side.  Returns 0
 * where no segment has points enough, -1 when there is no memory. */
static int divide(const search *s, const cagd_fit_result *r, knots *k)
{
    const int n = r->count, segments = k->inner + 1, least = s->dense ? 1 : LEAST_IN_SPAN;
    keyed *list = malloc((size_t)n * sizeof *list);
    double best = 0, at = -1;
    if (list == NULL)
        return -1;
    for (int i = 0; i < n; i++)
        list[i] = (keyed){r->feet[i], r->distances[i] * r->distances[i]};
    qsort(list, (size_t)n, sizeof *list, by_key);
    for (int g = 0, low = 0; g < segments; g++) {
        const double end = g < k->inner ? k->u[g] : 2, from = g > 0 ? k->u[g - 1] : 0;
        int high = low;
        double sum = 0, largest = 0, half = 0;
        for (; high < n && list[high].key < end; high++) {
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
            double u = (list[middle].key + list[middle + 1].key) / 2;
            if (u > from && u < fmin(end, 1))
                best = size, at = u;
        }
        low = high;
    }
    free(list);
    if (at < 0)
        return 0;
    insert(k, at);
    return 1;
}

/* ---- the search ------------------------------------------------------------------------------------------- */

/* Even knots, or those that are put in one by one, from these, over which `last` is a fit unless it is NULL, until `patience` more have not
 * helped, or there are more than MOST_VAIN without any that may be best; of scattered points, of which means have led to none, FEW. */
static cagd_status put_into(search *s, knots k, cagd_fit_result *last, int even, int patience)
{
    enum { MOST_VAIN = 30, FEW = 5 };
    const int vain = s->scattered > 1 ? FEW : MOST_VAIN;
    cagd_status status = CAGD_OK;
    double lowest = HUGE_VAL;
    for (int idle = 0; idle < patience && status == CAGD_OK;) {
        cagd_fit_result *next;
        status = fit_on(s, &k, even ? NULL : last, &next);
        if (status != CAGD_OK) {
            if (status == CAGD_TOO_FEW && (last != NULL || s->best != NULL))
                status = CAGD_OK;
            break;
        }
        const double score = score_of(s, &k, next);
        if (is_best(s, &k, next)) {
            if (s->best != last)
                cagd_fit_free(s->best);
            s->best = next;
        }
        idle = score < lowest ? 0 : idle + (lowest < HUGE_VAL || k.inner > vain);
        lowest = fmin(lowest, score);
        if (last != s->best)
            cagd_fit_free(last);
        last = next;
        if (next->points_on_curve || (is_within(s, next) && (!s->good_alone || may_be_best(s, next))) ||
            !has_room(s, &k))
            break;
        if (even)
            make_even(k.inner + 1, &k);
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
static cagd_status put_in(search *s, int even)
{
    knots k;
    make_even(s->options->closed ? s->options->degree + 1 : 0, &k);
    return put_into(s, k, NULL, even, PATIENCE);
}

/* The sum of 1/sigma^2. */
static double precision_of(const cagd_fit_data *data)
{
    double sum = 0;
    for (int i = 0; i < data->count; i++)
        sum += data->sigma != NULL ? 1 / (data->sigma[i] * data->sigma[i]) : 1;
    return sum;
}

/* The spline over even knots, led to from a smooth one: of many minima that have nearly the same cost the one without loops is the one that
 * bends least.  A smoothing term which lets the curve be off by about the way between two of its control points has one minimum; from there
 * the term is taken back in tenths, and at last left out.  The curve takes the place of the best one if it is good and has no loops; *led says
 * whether it did. */
static cagd_status lead_from_smooth(search *s, int *led)
{
    enum { TENTHS = 7 };
    cagd_fit_options o = *s->options;
    cagd_fit_result *last = NULL;
    cagd_status status = CAGD_OK;
    double lambda = precision_of(s->data) * pow(o.count, -4);
    for (int k = 0; k <= TENTHS && status == CAGD_OK; k++, lambda /= 10) {
        cagd_fit_result *next = NULL;
        o.smooth = k < TENTHS ? lambda : 0;
        o.initial = last != NULL ? &last->curve : NULL;
        status = k < TENTHS ? fit_step(s->data, &o, &next, s->where) : fit_candidate(s->data, &o, &next, s->where);
        cagd_fit_free(last);
        last = next;
    }
    *led = status == CAGD_OK && has_no_loops(s, last);
    if (*led) {
        cagd_fit_free(s->best);
        s->best = last;
    } else
        cagd_fit_free(last);
    return status;
}

/* The fit takes the place of *last if its cost is lower, and is released otherwise; whether it does. */
static int take_lower(cagd_fit_result *next, cagd_fit_result **last)
{
    const int lower = next->cost < (*last)->cost;
    cagd_fit_free(lower ? *last : next);
    *last = lower ? next : *last;
    return lower;
}

/* As many control points as are asked for, over knots that are put in one by one.  A fit with a knot more that ends higher is not taken; the one
 * before goes on with the next knot as well.  The curve takes the place of the best one, which is not good or has loops, if it has neither. */
static cagd_status place_knots(search *s)
{
    enum { MOST_VAIN = 3 };
    const int p = s->options->degree, closed = s->options->closed;
    knots k;
    cagd_fit_result *last = NULL;
    make_even(closed ? p + 1 : 0, &k);
    cagd_status status = fit_on(s, &k, NULL, &last);
    for (int vain = 0, put = 1; status == CAGD_OK && vain < MOST_VAIN && count_of(&k, p, closed) < s->options->count &&
                                k.inner < MOST_KNOTS && put > 0;) {
        cagd_fit_result *next = NULL;
        put = divide(s, last, &k);
        status = put < 0 ? CAGD_NO_MEMORY : put > 0 ? fit_on(s, &k, last, &next) : CAGD_OK;
        if (next != NULL) {
            const int minimum = cagd_fit_is_minimum(next);
            vain = take_lower(next, &last) && minimum ? 0 : vain + 1;
        }
    }
    if (status == CAGD_OK && (closed ? last->period : last->curve.count) == s->options->count &&
        has_no_loops(s, last)) {
        cagd_fit_free(s->best);
        s->best = last;
        s->best->found.knots_chosen = 1;
    } else
        cagd_fit_free(last);
    return status == CAGD_TOO_FEW ? CAGD_OK : status;
}

/* Whether the fit over these knots becomes the best one; `lowest`, which others begin with, is not released.  `shape`: not if it has gaps,
 * excursions or loops that `lowest` has not. */
static cagd_status try_knots(search *s, const knots *k, const cagd_fit_result *lowest, int shape, int *better)
{
    cagd_fit_result *next;
    cagd_status status = fit_on(s, k, lowest, &next);
    REQUIRE(status == CAGD_OK, status);
    *better = score_of(s, k, next) < s->score && !(shape && problems_of(s, next) & ~problems_of(s, lowest) & SHAPE) &&
              is_best(s, k, next);
    if (*better && s->best != lowest)
        cagd_fit_free(s->best);
    if (*better)
        s->best = next;
    else
        cagd_fit_free(next);
    return CAGD_OK;
}

/* The knots without knot i; the one before it (shift & 1) and the one behind it (shift & 2) are moved half the way to where it was. */
static knots without(const knots *from, int i, int shift)
{
    knots k = *from;
    take_out(&k, i);
    if (shift & 1)
        k.u[i - 1] = (from->u[i - 1] + from->u[i]) / 2;
    if (shift & 2)
        k.u[i] = (from->u[i + 1] + from->u[i]) / 2;
    return k;
}

/* Inner knots that a curve has at least. */
static int fewest_knots(const search *s) { return s->options->closed ? s->options->degree : 0; }

/* Knots are taken out of the best curve, that first without which it is best, as long as it becomes better.  Where it does not, the neighbours of
 * the one that is taken out move towards its place. */
static cagd_status take_out_idle(search *s)
{
    enum { SHIFTS = 4 };
    for (int better = 1; better;) {
        better = 0;
        const knots from = s->at;
        cagd_fit_result *lowest = s->best;
        for (int shift = 0; shift < SHIFTS && !better && from.inner > fewest_knots(s); shift++) {
            const int first = shift & 1, last = from.inner - (shift & 2 ? 2 : 1);
            if ((double)s->data->count * from.inner * from.inner * (shift ? SHIFTS : 1) > MOST_WORK)
                break;
            for (int i = first; i <= last; i++) {
                const knots k = without(&from, i, shift);
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

/* ---- smoothing ------------------------------------------------------------------------------------------- */

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
static cagd_status smooth_by(const search *s, const cagd_fit_options *options, double lambda,
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
        status = fit_candidate(s->data, &o, result, s->where);
    }
    if (status == CAGD_OK && (from == NULL || problems_of(s, *result) & ASTRAY)) {
        o.initial = options->initial;
        status = fit_candidate(s->data, &o, &other, s->where);
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
static int is_better_smoothed(const search *s, cagd_fit_result *next, double lambda, double score, smoothest *best)
{
    REQUIRE(isfinite(score), 0);
    const int loops = !has_no_loops(s, next),
              better = best->fit == NULL || loops < best->loops || (loops == best->loops && score < best->score);
    if (better)
        *best = (smoothest){next, lambda, score, loops};
    return better;
}

/* From a weight that leaves a straight line downwards in tenths, each fit from the one before, until the points determine MOST of the unknowns, and
 * a smaller weight helps no more. */
static cagd_status smooth_downwards(const search *s, const cagd_fit_options *options, smoothest *best)
{
    enum { TENTHS = 22, PATIENT = 2 };
    const double most = 0.9;
    double lambda = precision_of(s->data), score;
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
static cagd_status smooth_between(const search *s, const cagd_fit_options *options, smoothest *best)
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

/* The weight of the smoothing term by cross-validation.  *result, which may be NULL, is replaced where there is one. */
static cagd_status smooth_best(const search *s, const cagd_fit_options *options, int how, cagd_fit_result **result)
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

/* As many control points, over even knots, as leave half of the equations, 40 knots at most. */
static int most_points(const search *s)
{
    enum { MOST = 40 };
    knots k;
    make_even(s->options->closed ? s->options->degree + 1 : 0, &k);
    while (has_room(s, &k) && k.inner < MOST)
        make_even(k.inner + 1, &k);
    return count_of(&k, s->options->degree, s->options->closed);
}

/* The same of scattered points, by means of neighbours: all points could gain by a curve that goes to and fro between them.  The weight of
 * the term and the curve are those of the means, from where the curve is led to all points; where that comes to no minimum, as of fewer means
 * than control points, all points say them.  chosen: the number of control points is not given. */
static cagd_status smooth_by_means(const search *s, const cagd_fit_options *options, int how, int chosen,
                                   cagd_fit_result **result)
{
    cagd_fit_data means;
    cagd_fit_options o = *options;
    cagd_fit_result *first = NULL, *all = NULL;
    cagd_status status = fit_means(s->data, s->scattered, &means);
    search of_means = *s;
    of_means.data = &means, of_means.scattered = 1;
    if (status == CAGD_OK && chosen)
        o.count = most_points(&of_means);
    if (status == CAGD_OK)
        status = smooth_best(&of_means, &o, how, &first);
    if (status == CAGD_OK && first != NULL) {
        o.smooth = first->found.smooth * precision_of(s->data) / precision_of(&means);
        o.initial = &first->curve;
        o.free &= ~CAGD_FIT_WEIGHTS;
        status = fit_candidate(s->data, &o, &all, s->where);
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
    o.count = chosen ? most_points(s) : o.count;
    return led || (status != CAGD_OK && status != CAGD_TOO_FEW) ? status : smooth_best(s, &o, how, result);
}

/* ---- all of it --------------------------------------------------------------------------------------------- */

/* Of a tolerance that is not met, the distance that is: the fewest control points that are found to keep every point within that one. */
static cagd_status settle_for_nearest(search *s)
{
    REQUIRE(s->within > 0 && may_be_best(s, s->best) && s->best->largest > s->within, CAGD_OK);
    s->within = s->best->largest;
    s->score = score_of(s, &s->at, s->best);
    return take_out_idle(s);
}

/* Knots are put in, each where it helps most, and even ones. */
static cagd_status put_both(search *s)
{
    cagd_status status = put_in(s, 0);
    return status == CAGD_OK && !s->dense ? put_in(s, 1) : status;
}

/* Where the best curve has excursions, loops or gaps, once more among those that have neither them nor a cusp, if there are any. */
static cagd_status put_shapely(search *s)
{
    REQUIRE(s->best != NULL && !s->shapely && !(s->within > 0) && !is_shapely(s, s->best, 0), CAGD_OK);
    search again = *s;
    again.best = NULL, again.shapely = NO_CUSP;
    const cagd_status status = put_both(&again);
    const int found = status == CAGD_OK && again.best != NULL;
    cagd_fit_free(found ? s->best : again.best);
    if (found)
        *s = again;
    return status;
}

/* Knots are put in, and then taken out; out of a shapely curve as long as it stays one. */
static cagd_status search_knots(search *s)
{
    const int shapely = s->shapely;
    cagd_status status = put_both(s);
    if (status == CAGD_OK)
        status = put_shapely(s);
    if (status == CAGD_OK && s->best != NULL) {
        if (!s->shapely && !(s->within > 0))
            s->shapely = is_shapely(s, s->best, 0) ? NO_FIGURE : 0;
        status = take_out_idle(s);
    }
    if (status == CAGD_OK && s->best != NULL)
        status = settle_for_nearest(s);
    s->shapely = shapely;
    return status;
}

/* The spline over even knots, led to from a smooth one, takes the place of the best one if it comes nearer to the points; *nearer says
 * whether it does. */
static cagd_status lead_over_even(search *s, const knots *k, int *nearer)
{
    const cagd_fit_options *asked = s->options;
    cagd_fit_options own = *asked;
    search one = *s;
    int led;
    own.count = count_of(k, own.degree, own.closed);
    one.options = &own, one.best = NULL;
    cagd_status status = lead_from_smooth(&one, &led);
    *nearer = status == CAGD_OK && led && (s->best == NULL || one.best->largest < s->best->largest);
    if (*nearer) {
        cagd_fit_free(s->best);
        s->best = one.best, s->at = *k;
        s->score = score_of(s, k, s->best);
    } else
        cagd_fit_free(one.best);
    return status;
}

/* With a tolerance: even knots, a quarter more of them each time, until one curve keeps within it or PATIENT have come no nearer; then knots are
 * taken out. */
static cagd_status search_from_smooth(search *s)
{
    enum { FEWEST = 4, PATIENT = 3 };
    cagd_status status = CAGD_OK;
    knots k;
    make_even(s->options->closed ? s->options->degree + 1 : FEWEST, &k);
    for (int idle = 0; status == CAGD_OK && idle < PATIENT && has_room(s, &k); make_even(k.inner + k.inner / 4, &k)) {
        int nearer;
        status = lead_over_even(s, &k, &nearer);
        idle = nearer ? 0 : idle + 1;
        if (nearer && is_within(s, s->best))
            break;
    }
    if (status == CAGD_TOO_FEW)
        status = CAGD_OK;
    if (status == CAGD_OK && s->best != NULL)
        status = take_out_idle(s);
    return status;
}

/* The spline over these even knots with as large a smoothing term, to a factor of 10, as lets it keep within the distance without loops.  It,
 * or the one that comes nearest to that, becomes the best one if it comes nearer than the one before; *met says whether it keeps within. */
static cagd_status smooth_within(search *s, const knots *k, int *met)
{
    enum { TENTHS = 14 };
    cagd_fit_options o = *s->options;
    cagd_fit_result *last = NULL;
    cagd_status status = CAGD_OK;
    o.count = count_of(k, o.degree, o.closed);
    o.smooth = precision_of(s->data) * pow(o.count, -4);
    *met = 0;
    for (int tenth = 0; tenth < TENTHS && status == CAGD_OK && !*met; tenth++) {
        cagd_fit_result *next = NULL;
        o.smooth = tenth > 0 ? o.smooth / 10 : o.smooth;
        o.initial = last != NULL ? &last->curve : NULL;
        status = fit_candidate(s->data, &o, &next, s->where);
        if (last != s->best)
            cagd_fit_free(last);
        last = next;
        if (status != CAGD_OK || !has_no_loops(s, last) || last->degrees_of_freedom <= 0 ||
            (s->best != NULL && last->largest >= s->best->largest))
            continue;
        cagd_fit_free(s->best);
        s->best = last, s->at = *k;
        s->best->found.smoothed = 3, s->best->found.smooth = o.smooth;
        *met = is_within(s, last);
    }
    if (last != s->best)
        cagd_fit_free(last);
    return status;
}

/* With a tolerance that no curve keeps without a smoothing term: even knots, a quarter more of them each time, with one. */
static cagd_status search_smoothed(search *s)
{
    enum { FEWEST = 4 };
    cagd_status status = CAGD_OK;
    int met = 0;
    knots k;
    make_even(s->options->closed ? s->options->degree + 1 : FEWEST, &k);
    while (status == CAGD_OK && !met && count_of(&k, s->options->degree, s->options->closed) <= s->data->count &&
           k.inner < MOST_KNOTS && (double)s->data->count * k.inner * k.inner <= MOST_WORK) {
        status = smooth_within(s, &k, &met);
        make_even(k.inner + k.inner / 4, &k);
    }
    return status == CAGD_TOO_FEW ? CAGD_OK : status;
}

/* Whether the best curve keeps within the distance that is asked for, without loops. */
static int answers(const search *s)
{
    return s->best != NULL && s->best->largest <= s->choices->within && has_no_loops(s, s->best);
}

/* Whether the best curve of the one is a better answer to a tolerance than that of the other. */
static int answers_better(const search *one, const search *other)
{
    REQUIRE(one->best != NULL && !answers(other), 0);
    const int loops = !has_no_loops(one, one->best), others = !has_no_loops(other, other->best);
    return answers(one) || (loops != others ? loops < others : one->best->largest < other->best->largest);
}

/* The knots without the one that the fit needs least; *fit becomes the fit over them, NULL where there is none. */
static cagd_status drop_a_knot(const search *s, knots *k, cagd_fit_result **fit)
{
    const knots from = *k;
    cagd_fit_result *best = NULL;
    for (int i = 0; i < from.inner && from.inner > fewest_knots(s); i++) {
        const knots one = without(&from, i, 0);
        cagd_fit_result *next;
        const cagd_status status = fit_on(s, &one, *fit, &next);
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
static cagd_status from_means(search *s, search *of_means)
{
    knots k = of_means->at;
    cagd_status status = CAGD_OK;
    while (status == CAGD_OK && of_means->best != NULL) {
        cagd_fit_result *all;
        status = fit_on(s, &k, of_means->best, &all);
        REQUIRE(status == CAGD_OK, status);
        if (isfinite(score_of(s, &k, all)) && is_best(s, &k, all)) {
            s->best = all;
            break;
        }
        cagd_fit_free(all);
        status = drop_a_knot(of_means, &k, &of_means->best);
    }
    return status;
}

/* Of points that scatter by more than they are apart, whose polygon says nothing of the curve: first the knots by the means of neighbours, then
 * more of them by all points, as long as each helps and brings no excursions, loops or gaps.  Otherwise nothing is the best one. */
static cagd_status search_by_means(search *s)
{
    REQUIRE(s->scattered > 1, CAGD_OK);
    cagd_fit_data means;
    cagd_status status = fit_means(s->data, s->scattered, &means);
    search of_means = *s;
    of_means.data = &means, of_means.scattered = 1, of_means.shapely = s->shapely = NO_FIGURE;
    if (status == CAGD_OK)
        status = search_knots(&of_means);
    if (status == CAGD_OK)
        status = from_means(s, &of_means);
    if (status == CAGD_OK && s->best != NULL)
        status = put_into(s, s->at, s->best, 0, 1);
    if (status == CAGD_OK && s->best != NULL)
        status = take_out_idle(s);
    s->shapely = 0;
    cagd_fit_free(of_means.best);
    fit_means_free(&means);
    return status == CAGD_TOO_FEW ? CAGD_OK : status;
}

/* Minima that are not good lead with a tolerance to good ones by what is taken out of them.  Where they do not, good ones alone are sought; where
 * these do not keep within it, with knots as dense as the points, placed by these and then even, and at last with a smoothing term. */
static cagd_status find_knots(search *s)
{
    enum { GOOD, PLACED, EVEN, SMOOTHED, WAYS };
    cagd_status status = search_by_means(s);
    if (status == CAGD_OK && s->best == NULL)
        status = search_knots(s);
    for (int way = GOOD; way < WAYS && status == CAGD_OK && s->within > 0 && s->best != NULL && !answers(s); way++) {
        if (way == GOOD && has_no_loops(s, s->best))
            continue;
        search again = *s;
        again.best = NULL, again.within = s->choices->within, again.good_alone = 1, again.dense = way != GOOD;
        status = way == SMOOTHED ? search_smoothed(&again)
                 : way == EVEN   ? search_from_smooth(&again)
                                 : search_knots(&again);
        const int taken = status == CAGD_OK && answers_better(&again, s);
        cagd_fit_free(taken ? s->best : again.best);
        if (taken)
            *s = again;
    }
    s->dense = 0;
    if (status == CAGD_OK && s->best != NULL)
        s->best->found.count_chosen = s->best->found.knots_chosen = 1;
    return status;
}

cagd_status fit_refined(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_choices *choices,
                        cagd_fit_result **result, int *where)
{
    cagd_fit_options own = *options;
    int without_memory = 0;
    search s = {.data = data,
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
        if (!has_no_loops(&s, s.best) && own.degree > 1)
            status = lead_from_smooth(&s, &led);
        if (status == CAGD_OK && !has_no_loops(&s, s.best))
            status = place_knots(&s);
    }
    const int good = status == CAGD_OK && s.best != NULL && fit_is_good(data, &own, s.best);
    if (status == CAGD_OK && own.smooth == 0 && own.degree > 1 && (choices->smooth == 1 || (mended && !good))) {
        cagd_fit_options smoothed = own;
        if (chosen)
            smoothed.count = most_points(&s);
        status = s.scattered > 1 ? smooth_by_means(&s, &own, choices->smooth, chosen, &s.best)
                                 : smooth_best(&s, &smoothed, choices->smooth, &s.best);
    }
    if (status == CAGD_OK && without_memory)
        status = CAGD_NO_MEMORY;
    if (status == CAGD_OK && smooth_only && own.smooth > 0) {
        own.count = most_points(&s);
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
