#include "core/fit/starts.h"

#include "core/fit/descend.h"
#include "core/fit/few.h"
#include "core/fit/initial.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { EVEN = 3 }; /* guesses with the same weight for all inner points */

/* The weights of guess number `guess`. */
static void guess_weights(const fit_problem *p, const cagd_fit_options *o, int guess, fit_curve *curve)
{
    static const double inner[EVEN] = {1, 3, 1 / 3.0};
    for (int i = 0; i < p->count; i++)
        curve->weights[i] = 1;
    for (int k = 0; guess < EVEN && k < p->unknowns; k++)
        if (p->unknown[k].is_weight && p->unknown[k].index < p->count - 1)
            curve->weights[p->unknown[k].index] = fmin(fmax(inner[guess], p->low), p->high);
    if (guess >= EVEN)
        fit_initial_weights(p, o->seed, -guess, curve);
}

/* From the curve near to its minimum; *cost: there. */
static int carried(const fit_problem *p, const cagd_fit_options *o, fit_curve *curve, double *cost)
{
    fit_attempt a;
    double left;
    cagd_fit_options few_steps = *o;
    few_steps.max_iterations = o->max_iterations < p->strategy.steps ? o->max_iterations : p->strategy.steps;
    int good = fit_attempt_new(p, &a);
    if (good) {
        fit_curve_copy(a.curve, curve);
        good = fit_feet_guess(p, curve, a.feet) && fit_descend_near(p, &few_steps, &a) &&
               fit_descend_newton(p, &few_steps, p->strategy.telling, &left, &a);
    }
    if (good) {
        *cost = a.objective->cost;
        fit_curve_copy(curve, a.objective->curve);
    }
    fit_attempt_free(&a);
    return good;
}

/* Whether half of the digits of binary64 tell every weight from 0 and infinity, and every point; working coordinates are of the order
 * of 1.  Curves whose cost falls towards such a weight lie on the way to no minimum. */
static int sound(const fit_problem *p, const fit_curve *curve)
{
    double most = 1 / sqrt(DBL_EPSILON);
    for (int i = 0; i < p->count; i++) {
        if (!(curve->weights[i] * most >= 1 && curve->weights[i] <= most))
            return 0;
        for (int c = 0; c < p->dim; c++)
            if (!(fabs(curve->points[i * p->dim + c]) <= most))
                return 0;
    }
    return 1;
}

/* The best of the curves that begin with some order of the points, if they have none, and some weights, if these are free. */
static int found(const fit_problem *p, const cagd_fit_options *o, fit_curve *curve)
{
    int *order = malloc((size_t)p->points * sizeof *order),
        guesses = o->free & CAGD_FIT_WEIGHTS ? EVEN + p->strategy.guesses : 1;
    fit_curve *try = fit_curve_new(p->degree, p->count, p->dim, p->knots);
    double best = INFINITY, nothing = fit_problem_blur(p, 0);
    int good = order != NULL && try != NULL, first = 1;
    for (int by = 0; good && by < (p->unordered ? FIT_ORDERS : 1); by++) {
        for (int i = 0; i < p->points; i++)
            order[i] = i;
        good = !p->unordered || fit_initial_order(p, by, order);
        for (int guess = 0; good && guess < guesses && best > nothing; guess++) {
            double cost;
            guess_weights(p, o, guess, try);
            good = fit_initial_curve(p, order, try, &cost);
            if (good && first) /* if nothing else will do */
                fit_curve_copy(curve, try);
            first = 0;
            good = good && carried(p, o, try, &cost);
            if (good && cost < best && sound(p, try)) {
                best = cost;
                fit_curve_copy(curve, try);
            }
        }
    }
    free(order);
    fit_curve_free(try);
    return good;
}

int fit_start(const fit_problem *p, const cagd_fit_options *o, int start, fit_curve *curve)
{
    fit_problem few;
    if (p->nothing_free) {
        fit_problem_curve(p, o->initial, curve);
        return 1;
    }
    int good = fit_few_thinned(p, (p->points - 1) / (p->strategy.enough * p->strategy.times * p->unknowns) + 1, &few);
    if (!good)
        return 0;
    if (o->initial != NULL)
        fit_problem_curve(p, o->initial, curve);
    else
        good = found(&few, o, curve);
    if (good && start > 0) {
        fit_initial_weights(p, o->seed, start, curve);
        if (o->free & (CAGD_FIT_INNER_POINTS | CAGD_FIT_END_POINTS))
            good = fit_initial_improve(&few, curve);
    }
    fit_few_free(&few);
    return good;
}
