#include "core/fit/starts.h"

#include "core/fit/descend.h"
#include "core/fit/initial.h"
#include "core/fit/order.h"
#include "core/fit/sample.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

/* ---- Weights ------------------------------------------------------------------------------------------ */

/* Steele, Lea and Flood's generator SplitMix64. */
static uint64_t scrambled(uint64_t x)
{
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

void fit_random_weights(const fit_problem *p, int number, fit_curve *curve)
{
    for (int k = 0; k < p->unknowns; k++)
        if (p->unknown[k].is_weight) {
            uint64_t bits = scrambled(scrambled(scrambled(p->options->seed) + (uint64_t)number) + (uint64_t)k);
            double uniform = (double)(bits >> 11) * 0x1p-53; /* 0 <= uniform < 1 */
            double low = fmax(log(p->low), -log(p->strategy.weight_spread)),
                   high = fmin(log(p->high), log(p->strategy.weight_spread));
            curve->weights[p->unknown[k].index] = exp(low + uniform * (high - low));
        }
    fit_curve_update(curve);
}

enum { EVEN_GUESSES = 3 }; /* guesses with the same weight for all inner points */

/* The weights of guess number `guess`: even ones, and then random ones. */
static void guess_weights(const fit_problem *p, int guess, fit_curve *curve)
{
    static const double inner[EVEN_GUESSES] = {1, 3, 1 / 3.0};
    for (int i = 0; i < p->count; i++)
        curve->weights[i] = 1;
    for (int k = 0; guess < EVEN_GUESSES && k < p->unknowns; k++)
        if (p->unknown[k].is_weight && p->unknown[k].index < p->count - 1)
            curve->weights[p->unknown[k].index] = fmin(fmax(inner[guess], p->low), p->high);
    if (guess >= EVEN_GUESSES)
        fit_random_weights(p, -guess, curve);
}

/* ---- Guesses ------------------------------------------------------------------------------------------ */

/* Leads the curve near its minimum; *cost: there.  Returns 0 when there is no memory. */
static int lead(const fit_problem *p, fit_curve *curve, double *cost)
{
    fit_attempt a;
    int good = fit_attempt_new(p, &a);
    if (good) {
        if (a.max_iterations > p->strategy.guess_steps)
            a.max_iterations = p->strategy.guess_steps;
        fit_curve_copy(a.curve, curve);
        good = fit_feet_guess(p, curve, a.feet) && fit_descend_near(&a) &&
               fit_descend_newton(&a, p->strategy.guess_accuracy);
    }
    if (good) {
        *cost = a.objective->cost;
        fit_curve_copy(curve, a.objective->curve);
    }
    fit_attempt_free(&a);
    return good;
}

/* Whether every weight lies between 2^-26 and 2^26, and no coordinate, which in working coordinates is of the order
 * of 1, is larger than 2^26.  Curves whose cost falls towards a weight 0 or infinity lead to no minimum. */
static int is_moderate(const fit_problem *p, const fit_curve *curve)
{
    const double most = 1 / sqrt(DBL_EPSILON);
    for (int i = 0; i < p->count; i++) {
        if (!(curve->weights[i] * most >= 1 && curve->weights[i] <= most))
            return 0;
        for (int c = 0; c < p->dim; c++)
            if (!(fabs(curve->points[i * p->dim + c]) <= most))
                return 0;
    }
    return 1;
}

/* The best guess so far. */
typedef struct best_guess {
    fit_curve *curve; /* the first one, if none is moderate */
    int guesses;
    double cost;
} best_guess;

/* The guesses for one order of the points; `curve` is room for one.  Returns 0 when there is no memory. */
static int try_order(const fit_problem *p, const int order[], fit_curve *curve, best_guess *best)
{
    const int most = p->options->free & CAGD_FIT_WEIGHTS ? EVEN_GUESSES + p->strategy.guesses : 1;
    const double nothing = fit_problem_cost_error(p, 0);
    for (int guess = 0; guess < most && best->cost > nothing; guess++) {
        double cost;
        guess_weights(p, guess, curve);
        if (!fit_initial_curve(p, order, curve))
            return 0;
        if (best->guesses++ == 0)
            fit_curve_copy(best->curve, curve);
        if (!lead(p, curve, &cost))
            return 0;
        if (cost < best->cost && is_moderate(p, curve)) {
            best->cost = cost;
            fit_curve_copy(best->curve, curve);
        }
    }
    return 1;
}

/* The best of all guesses: several orders of the points, if they have none, and several sets of weights, if these are
 * free. */
static int guess_curve(const fit_problem *p, fit_curve *curve)
{
    best_guess best = {curve, 0, INFINITY};
    int *order = malloc((size_t)p->points * sizeof *order);
    fit_curve *room = fit_curve_new(p->degree, p->count, p->period, p->dim, p->knots);
    int good = order != NULL && room != NULL;
    for (int kind = 0; good && kind < (p->unordered ? FIT_ORDERS : 1); kind++) {
        for (int i = 0; i < p->points; i++)
            order[i] = i;
        good = (!p->unordered || fit_order(p, (enum fit_order_kind)kind, order)) && try_order(p, order, room, &best);
    }
    free(order);
    fit_curve_free(room);
    return good;
}

/* ---- Starts ------------------------------------------------------------------------------------------- */

/* Start number `start`, a sample of the points taking the place of all. */
static int start_with(const fit_problem *sample, int start, fit_curve *curve)
{
    const cagd_fit_options *o = sample->options;
    int good = 1;
    if (o->initial != NULL)
        fit_problem_curve(sample, o->initial, curve);
    else
        good = guess_curve(sample, curve);
    if (!good || start == 0)
        return good;
    fit_random_weights(sample, start, curve);
    return !(o->free & (CAGD_FIT_INNER_POINTS | CAGD_FIT_END_POINTS)) || fit_initial_improve(sample, curve);
}

int fit_start(const fit_problem *p, int start, fit_curve *curve)
{
    fit_problem sample;
    if (p->nothing_free) {
        fit_problem_curve(p, p->options->initial, curve);
        return 1;
    }
    int most = p->strategy.points_per_unknown * p->strategy.means_factor * p->unknowns;
    if (!fit_sample_every(p, (p->points - 1) / most + 1, &sample))
        return 0;
    int good = start_with(&sample, start, curve);
    fit_sample_free(&sample);
    return good;
}
