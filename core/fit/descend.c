#include "core/fit/descend.h"

#include "core/fit/model.h"
#include "core/fit/unknowns.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Whether the squares of all entries of the triangle are numbers. */
static int is_finite_triangle(int n, const double triangle[])
{
    double sum = 0;
    for (int m = 0; m < n * n; m++)
        sum += triangle[m] * triangle[m];
    return isfinite(sum);
}

/* A fit_residuals: the triangle (R z; 0 e) with e such that half the sum of squares is F, unknowns + 1 residuals for
 * any number of points; and what rounding makes of F = 0, below which no decrease counts.  Where the derivatives are
 * asked for the minimiser has gone, and the feet there are accepted. */
static int residuals(void *objective, const double x[], double left[], double jacobian[])
{
    fit_objective *f = objective;
    int n = f->problem->unknowns;
    fit_objective_at(f, x);
    if (!isfinite(f->cost) || !is_finite_triangle(n + 1, f->triangle))
        return 0;
    double rest = 2 * f->cost;
    for (int k = 0; k < n; k++) {
        left[k] = f->triangle[k * (n + 1) + n];
        rest -= left[k] * left[k];
    }
    left[n] = sqrt(fmax(0, rest) + 2 * fit_problem_cost_error(f->problem, 0));
    if (jacobian != NULL) {
        for (int k = 0; k < n; k++)
            memcpy(jacobian + k * n, f->triangle + k * (n + 1), (size_t)n * sizeof *jacobian);
        memset(jacobian + n * n, 0, (size_t)n * sizeof *jacobian);
        fit_objective_accept(f);
    }
    return 1;
}

/* Puts the objective at the better of what was accepted and what was evaluated last: Ceres does not go the last step
 * when it is short. */
static void settle(fit_objective *f)
{
    if (f->evaluated && f->cost < f->accepted)
        fit_objective_accept(f);
    fit_objective_at(f, f->x);
    fit_objective_accept(f);
}

/* Runs Ceres from where the objective is.  Returns 0 when there is no memory. */
static int run_ceres(fit_attempt *a, double tolerance)
{
    const fit_problem *p = a->problem;
    int n = p->unknowns, left = a->max_iterations - a->outcome.iterations;
    fit_outcome run = {0};
    double *low = malloc(3 * (size_t)n * sizeof *low), *high = low + n, *x = high + n;
    if (low == NULL)
        return 0;
    fit_unknowns_bounds(p, a->objective->base, low, high);
    memcpy(x, a->objective->x, (size_t)n * sizeof *x);
    fit_least_squares rows = {n, n + 1, residuals, a->objective, low, high};
    int good = fit_minimise(&rows, tolerance, left > 0 ? left : 0, x, &a->radius, &run) && fit_attempt_append(a, &run);
    settle(a->objective);
    free(low);
    return good;
}

int fit_descend_near(fit_attempt *a)
{
    const fit_problem *p = a->problem;
    fit_objective *f = a->objective;
    f->limit = p->strategy.taylor_reach;
    f->newton = 0;
    fit_objective_begin(f, a->curve, a->feet);
    return run_ceres(a, fmax(p->strategy.handover, p->options->tolerance));
}

/* ---- Newton's steps ------------------------------------------------------------------------------------ */

/* What rounding leaves of the decrement.  The residuals are off by b_i, problem.h, of which the decrement has the
 * part that falls to the unknowns; and every row is rounded, as often one way as the other, when it is taken into the
 * triangle. */
static double smallest_decrement(const fit_problem *p, double cost)
{
    return sqrt(2 * fit_problem_cost_error(p, 0) * p->unknowns / fit_problem_equations(p)) +
           DBL_EPSILON / 2 * sqrt(2 * cost * p->points * fit_problem_roundings(p));
}

/* Newton's method from x: the model there, the bounds on x, the unknowns that stand on one, and room for the next x. */
typedef struct newton {
    fit_model model;
    double *low, *high, *next;
    int *fixed;
} newton;

static void newton_free(newton *w)
{
    fit_model_free(&w->model);
    free(w->low);
    free(w->fixed);
}

/* The objective, evaluated with second derivatives at its accepted x, and its model.  Returns 0 when there is no
 * memory; newton_free is to be called all the same. */
static int newton_new(fit_objective *f, newton *w)
{
    const fit_problem *p = f->problem;
    size_t n = (size_t)p->unknowns;
    *w = (newton){.low = malloc(3 * n * sizeof *w->low), .fixed = malloc(n * sizeof *w->fixed)};
    if (w->low == NULL || w->fixed == NULL)
        return 0;
    w->high = w->low + n, w->next = w->high + n;
    fit_unknowns_bounds(p, f->base, w->low, w->high);
    f->evaluated = f->evaluated && f->newton;
    f->newton = 1;
    fit_objective_at(f, f->x);
    fit_objective_accept(f);
    for (int k = 0; k < p->unknowns; k++)
        w->fixed[k] = fit_unknown_is_on_bound(p, k, f->curve);
    return fit_model_of(f, w->fixed, &w->model);
}

/* next = x + step; returns 0 if this passes a bound.  *length: of the step. */
static int step_from(const fit_objective *f, newton *w, double *length)
{
    int n = f->problem->unknowns, inside = 1;
    double square = 0;
    fit_model_step(&w->model, w->next);
    for (int k = 0; k < n; k++) {
        square += w->next[k] * w->next[k];
        w->next[k] += f->x[k];
        inside = inside && w->low[k] <= w->next[k] && w->next[k] <= w->high[k];
    }
    *length = sqrt(square);
    return inside;
}

/* The objective and its model at `next`.  Returns 0 when there is no memory. */
static int go(fit_objective *f, newton *w)
{
    fit_model_free(&w->model);
    fit_objective_evaluate(f, w->next, FIT_ROWS);
    return fit_model_of(f, w->fixed, &w->model);
}

int fit_descend_newton(fit_attempt *a, double tolerance)
{
    fit_objective *f = a->objective;
    newton w;
    const double smallest = smallest_decrement(a->problem, f->cost);
    int good = newton_new(f, &w), is_last = 0, stalls = 0;
    double length;
    a->decrement = w.model.decrement;
    while (good && !stalls && a->outcome.iterations < a->max_iterations &&
           fmax(smallest, tolerance * sqrt(2 * f->cost)) < a->decrement && step_from(f, &w, &length)) {
        f->newton = !is_last;
        good = go(f, &w);
        double before = a->decrement, now = w.model.decrement;
        int better = good && isfinite(f->cost) && now < before;
        good = good && fit_attempt_step(a, better, length);
        if (!better)
            break;
        fit_objective_accept(f);
        a->decrement = now;
        is_last = now * (now / before) < smallest; /* the next step is, and needs no new second derivatives */
        stalls = now > before / 2;                 /* only rounding is left, or nothing is gained by going on */
    }
    f->newton = 1;
    if (good) {
        fit_objective_at(f, f->x);
        fit_objective_accept(f);
    }
    newton_free(&w);
    return good;
}

/* ---- To the minimum ------------------------------------------------------------------------------------ */

/* Whether Newton's steps have converged, so that no decrease of the cost is left that counts. */
static int has_converged(const fit_attempt *a)
{
    double cost = a->objective->cost, most = a->problem->options->tolerance * 2 * cost;
    return a->decrement * a->decrement <= most + fit_problem_cost_error(a->problem, cost);
}

static int has_steps_left(const fit_attempt *a) { return a->outcome.iterations < a->max_iterations; }

/* To a minimum for feet near those that are accepted.  Where Newton's steps lead no further Ceres goes on, each time
 * until it gains much less than before, and at last to the tolerance of the options. */
static int descend_to_minimum(fit_attempt *a, int near)
{
    const double tolerance = a->problem->options->tolerance, handover = a->problem->strategy.handover;
    int good = 1, last = 0;
    a->decrement = HUGE_VAL;
    if (near)
        good = fit_descend_newton(a, tolerance);
    for (double gain = handover; good && !last && !has_converged(a) && has_steps_left(a); gain *= handover) {
        last = gain <= tolerance;
        good = run_ceres(a, fmax(gain, tolerance));
        if (good && a->outcome.termination == CAGD_FIT_CONVERGED)
            good = fit_descend_newton(a, tolerance);
    }
    return good;
}

/* Takes the feet of the attempt for those of the objective, if its cost becomes lower; whether it did. */
static int take_feet(fit_attempt *a)
{
    fit_objective *f = a->objective;
    double *before = f->feet, cost = f->cost;
    f->feet = a->feet;
    fit_objective_evaluate(f, f->x, FIT_ROWS);
    int better = f->cost < cost - fit_problem_cost_error(a->problem, cost);
    if (better) {
        a->feet = before;
    } else {
        f->feet = before;
        fit_objective_evaluate(f, f->x, FIT_ROWS);
    }
    fit_objective_accept(f);
    return better;
}

static void note_steps(fit_attempt *a)
{
    a->outcome.termination = CAGD_FIT_NOT_CONVERGED;
    snprintf(a->outcome.message, sizeof a->outcome.message, "The largest number of iterations was reached.");
}

int fit_descend(fit_attempt *a)
{
    fit_objective *f = a->objective;
    double gain;
    int near = a->outcome.termination == CAGD_FIT_CONVERGED;
    f->limit = FOOT_EXACT;
    f->newton = 1;
    fit_objective_begin(f, a->curve, a->feet);
    for (;; near = 1) {
        if (!descend_to_minimum(a, near))
            return 0;
        if (!has_steps_left(a) && !has_converged(a))
            note_steps(a);
        if (!fit_feet_improve(a->problem, f->curve, f->feet, a->feet, &gain))
            return 0;
        int worth = gain > fit_problem_cost_error(a->problem, f->cost);
        if (!worth || !has_steps_left(a) || !take_feet(a))
            return 1;
    }
}
