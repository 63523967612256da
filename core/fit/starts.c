#include "core/fit/starts.h"

#include "core/fit/approach.h"
#include "core/fit/descend.h"
#include "core/fit/few.h"
#include "core/fit/initial.h"

#include <math.h>
#include <stdlib.h>

/* How many weights are tried without knowledge, equal ones and others, how many steps each of them has, and how near to its minimum it
 * comes.  What is not found here is found by no tolerance. */
enum { EVEN = 3, UNEVEN = 13, STEPS = 40 };
#define TELLING 1e-3

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
    few_steps.max_iterations = o->max_iterations < STEPS ? o->max_iterations : STEPS;
    int good = fit_attempt_new(p, &a);
    if (good) {
        fit_curve_copy(a.curve, curve);
        good = fit_feet_guess(p, curve, a.feet) && fit_descend_near(p, &few_steps, &a) &&
               fit_descend_newton(p, &few_steps, TELLING, &left, &a);
    }
    if (good) {
        *cost = a.objective->cost;
        fit_curve_copy(curve, a.objective->curve);
    }
    fit_attempt_free(&a);
    return good;
}

/* The best of the curves that begin with some order of the points, if they have none, and some weights, if these are free. */
static int found(const fit_problem *p, const cagd_fit_options *o, fit_curve *curve)
{
    int *order = malloc((size_t)p->points * sizeof *order), guesses = o->free & CAGD_FIT_WEIGHTS ? EVEN + UNEVEN : 1;
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
            good = fit_initial_curve(p, order, try, &cost) && carried(p, o, try, &cost);
            if (good && (cost < best || first)) {
                best = cost;
                fit_curve_copy(curve, try);
            }
            first = 0;
        }
    }
    free(order);
    fit_curve_free(try);
    return good;
}

int fit_start(const fit_problem *p, const cagd_fit_options *o, int start, fit_curve *curve)
{
    fit_problem few;
    int good = fit_few_thinned(p, (p->points - 1) / (FIT_ENOUGH * FIT_TIMES * p->unknowns) + 1, &few);
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
