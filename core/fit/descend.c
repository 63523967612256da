#include "core/fit/descend.h"

#include "core/fit/model.h"

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

/* A fit_residuals: the triangle (R z; 0 e) with e such that half the sum of squares is F, unknowns + 1 residuals for any number of
 * points; and what rounding makes of F = 0, below which no decrease counts.  Where the derivatives are asked for the minimiser
 * has gone, and the feet there are accepted. */
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
    left[n] = sqrt(fmax(0, rest) + 2 * fit_problem_blur(f->problem, 0));
    if (jacobian != NULL) {
        for (int k = 0; k < n; k++)
            memcpy(jacobian + k * n, f->triangle + k * (n + 1), (size_t)n * sizeof *jacobian);
        memset(jacobian + n * n, 0, (size_t)n * sizeof *jacobian);
        fit_objective_accept(f);
    }
    return 1;
}

/* The objective at the better of what was accepted and what was evaluated last: Ceres does not go the last step when it is short. */
static void settle(fit_objective *f)
{
    if (f->evaluated && f->cost < f->accepted)
        fit_objective_accept(f);
    fit_objective_at(f, f->x);
    fit_objective_accept(f);
}

static int run_ceres(const fit_problem *p, const cagd_fit_options *o, double tolerance, fit_attempt *a)
{
    int n = p->unknowns;
    int left = o->max_iterations - a->outcome.iterations;
    size_t room = (size_t)n;
    fit_outcome outcome = {0};
    double *low = malloc(3 * room * sizeof *low);
    int good = low != NULL;
    if (good) {
        double *high = low + n, *x = high + n;
        fit_problem_bounds(p, a->objective->base, low, high);
        memcpy(x, a->objective->x, room * sizeof *x);
        fit_least_squares rows = {n, n + 1, residuals, a->objective, low, high};
        good = fit_minimise(&rows, tolerance, left > 0 ? left : 0, x, &a->radius, &outcome) &&
               fit_attempt_append(a, &outcome);
        settle(a->objective);
    }
    free(low);
    return good;
}

/* What rounding leaves of |y|: the residuals are off by b_i, fit_problem_blur, of which y has the part that falls to the unknowns; and
 * every row is rounded, as often one way as the other, when it is taken into the triangle. */
static double floor_of(const fit_problem *p, double cost)
{
    return sqrt(2 * fit_problem_blur(p, 0) * p->unknowns / fit_problem_equations(p)) +
           DBL_EPSILON / 2 * sqrt(2 * cost * p->points * fit_problem_roundings(p));
}

int fit_descend_near(const fit_problem *p, const cagd_fit_options *o, fit_attempt *a)
{
    fit_objective *f = a->objective;
    f->limit = p->strategy.rough;
    f->newton = 0;
    fit_objective_begin(f, a->curve, a->feet);
    a->initial_cost = f->cost;
    return run_ceres(p, o, fmax(p->strategy.nearly, o->tolerance), a);
}

/* x + step, or 0 if this passes a bound; *length: of the step. */
static int step_from(const fit_objective *f, const fit_model *model, const double low[], const double high[],
                     double next[], double *length)
{
    int n = f->problem->unknowns, inside = 1;
    double square = 0;
    fit_model_step(model, next);
    for (int k = 0; k < n; k++) {
        square += next[k] * next[k];
        next[k] += f->x[k];
        inside = inside && low[k] <= next[k] && next[k] <= high[k];
    }
    *length = sqrt(square);
    return inside;
}

int fit_descend_newton(const fit_problem *p, const cagd_fit_options *o, double tolerance, double *left, fit_attempt *a)
{
    fit_objective *f = a->objective;
    int n = p->unknowns, steady = 0;
    double *low = malloc(3 * (size_t)n * sizeof *low), enough = floor_of(p, f->cost), length;
    int *fixed = malloc((size_t)n * sizeof *fixed), good = low && fixed;
    fit_model model = {0};
    if (good) {
        fit_problem_bounds(p, f->base, low, low + n);
        f->evaluated = f->evaluated && f->newton;
        f->newton = 1;
        fit_objective_at(f, f->x);
        fit_objective_accept(f);
    }
    for (int k = 0; good && k < n; k++)
        fixed[k] = fit_problem_on_bound(p, k, f->curve);
    good = good && fit_model_of(f, fixed, &model);
    *left = model.left;
    while (good && a->outcome.iterations < o->max_iterations && fmax(enough, tolerance * sqrt(2 * f->cost)) < *left) {
        double *next = low + 2 * n;
        if (!step_from(f, &model, low, low + n, next, &length))
            break;
        fit_model_free(&model);
        f->newton = !steady;
        fit_objective_evaluate(f, next, 1);
        good = fit_model_of(f, fixed, &model);
        int better = good && isfinite(f->cost) && model.left < *left;
        good = good && fit_attempt_step(a, better, length);
        if (!better)
            break;
        fit_objective_accept(f);
        int stalls = model.left > *left / 2; /* only rounding is left, or nothing is gained by going on */
        steady = model.left * (model.left / *left) < enough; /* another step is the last */
        *left = model.left;
        if (stalls)
            break;
    }
    f->newton = 1;
    if (good) {
        fit_objective_at(f, f->x);
        fit_objective_accept(f);
    }
    fit_model_free(&model);
    free(low);
    free(fixed);
    return good;
}

/* Whether Newton's steps have converged, so that no decrease of the cost is left that counts. */
static int converged(const fit_problem *p, const cagd_fit_options *o, const fit_objective *f, double left)
{
    return left * left <= o->tolerance * 2 * f->cost + fit_problem_blur(p, f->cost);
}

/* To a minimum, near which the objective is or is not.  Where Newton's steps lead no further Ceres goes on, every time until it gains much
 * less, and at last to the tolerance of the options. */
static int to_minimum(const fit_problem *p, const cagd_fit_options *o, int near, double *left, fit_attempt *a)
{
    int good = 1, last = 0;
    *left = HUGE_VAL;
    if (near)
        good = fit_descend_newton(p, o, o->tolerance, left, a);
    for (double gain = p->strategy.nearly;
         good && !last && !(near && converged(p, o, a->objective, *left)) && a->outcome.iterations < o->max_iterations;
         near = 1, gain *= p->strategy.nearly) {
        last = gain <= o->tolerance;
        good = run_ceres(p, o, fmax(gain, o->tolerance), a);
        if (good && a->outcome.termination == CAGD_FIT_CONVERGED)
            good = fit_descend_newton(p, o, o->tolerance, left, a);
    }
    return good;
}

int fit_descend(const fit_problem *p, const cagd_fit_options *o, fit_attempt *a)
{
    fit_objective *f = a->objective;
    double left, gain;
    int good = 1, near = a->outcome.termination == CAGD_FIT_CONVERGED;
    f->limit = FOOT_EXACT;
    f->newton = 1;
    fit_objective_begin(f, a->curve, a->feet);
    for (;; near = 1) {
        good = good && to_minimum(p, o, near, &left, a);
        if (good && a->outcome.iterations >= o->max_iterations && !converged(p, o, f, left)) {
            a->outcome.termination = CAGD_FIT_NOT_CONVERGED;
            snprintf(a->outcome.message, sizeof a->outcome.message, "Maximum number of iterations reached.");
        }
        good = good && fit_feet_improve(p, f->curve, f->feet, a->feet, &gain);
        if (!good || gain <= fit_problem_blur(p, f->cost) || a->outcome.iterations >= o->max_iterations)
            return good;
        double *feet = f->feet, cost = f->cost;
        f->feet = a->feet;
        fit_objective_evaluate(f, f->x, 1);
        int better = f->cost < cost - fit_problem_blur(p, cost);
        f->feet = better ? f->feet : feet;
        a->feet = better ? feet : a->feet;
        if (!better)
            fit_objective_evaluate(f, f->x, 1);
        fit_objective_accept(f);
        if (!better)
            return good;
    }
}
