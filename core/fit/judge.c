#include "core/fit/attempt.h"
#include "core/fit/unknowns.h"

#include "core/number/limits.h"

#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>

static void fail(fit_attempt *a, const char *form, ...) __attribute__((format(printf, 2, 3)));
static void fail(fit_attempt *a, const char *form, ...)
{
    va_list values;
    va_start(values, form);
    a->outcome.termination = CAGD_FIT_FAILED;
    vsnprintf(a->outcome.message, sizeof a->outcome.message, form, values);
    va_end(values);
}

/* The share R_index of point `index` in the curve at t, which lies in the piece. */
static double share_of(const fit_curve *curve, int index, int piece, double t)
{
    double R[MAX_DEGREE + 1], slopes[MAX_DEGREE + 1];
    int m = fit_curve_place(curve, index, piece);
    if (m < 0)
        return 0;
    fit_curve_shares(curve, piece, t, R, slopes);
    return R[m];
}

/* Whether rounding would take the share of a point away at all measured points and at the middles of the pieces. */
static int is_lost(const fit_objective *f, int index)
{
    const fit_curve *curve = f->curve;
    const double smallest = DBL_EPSILON / 2;
    int lost = 1;
    for (int piece = 0; lost && piece < curve->pieces; piece++) {
        const double *u = curve->spline.knots + curve->span[piece];
        lost = share_of(curve, index, piece, (u[0] + u[1]) / 2) < smallest;
    }
    for (int i = 0; lost && i < f->problem->points; i++)
        lost = share_of(curve, index, fit_curve_piece(curve, f->feet[i]), f->feet[i]) < smallest;
    return lost;
}

/* Whether the weight of unknown k runs away.  Then the gradient along log w_k is small only because the weight hardly
 * counts, and not because the residuals are orthogonal to its column of the Jacobian.  Two things tell: the step of
 * Gauss and Newton in this unknown alone would lower the cost by more than sqrt(tolerance) of it, and would change
 * the weight by a factor of more than 2^53, which is from one end of the precision to the other. */
static int runs_away(const fit_objective *f, int k)
{
    const fit_problem *p = f->problem;
    int n = p->unknowns;
    double g = fit_objective_gradient(f, k), square = 0;
    for (int i = 0; i < n; i++)
        square += f->triangle[i * (n + 1) + k] * f->triangle[i * (n + 1) + k];
    double noticed = sqrt(p->options->tolerance) * f->cost + fit_problem_cost_error(p, f->cost);
    return g * g > 2 * noticed * square && fabs(g) > -log(DBL_EPSILON / 2) * square;
}

/* Whether point j of the curve goes to infinity while its weight goes to 0 and their product stays: then the curve would
 * go on with a negative weight, as an arc of more than a half turn has.  Half of the digits of binary64 are lost. */
static int goes_to_infinity(const fit_objective *f, int j)
{
    const double most = 1 / sqrt(DBL_EPSILON);
    double size = 0;
    for (int c = 0; c < f->problem->dim; c++)
        size = fmax(size, fabs(f->curve->points[j * f->problem->dim + c]));
    return f->curve->weights[j] * most < 1 && size > most;
}

void fit_attempt_judge(fit_attempt *a)
{
    const fit_problem *p = a->problem;
    const fit_objective *f = a->objective;
    if (!isfinite(f->cost)) {
        fail(a, "The distances have left the range of numbers.");
        return;
    }
    for (int k = 0; k < p->unknowns; k++) {
        int index = p->unknown[k].index;
        double w = f->curve->weights[index];
        if (!p->unknown[k].is_weight || fit_unknown_is_on_bound(p, k, f->curve))
            continue;
        if (goes_to_infinity(f, index))
            fail(a,
                 "No minimum was found: point %d of the curve goes to infinity and its weight to 0 (it is %.2g), as "
                 "where an arc turns by a half turn or more.",
                 index, w);
        else if (is_lost(f, index) || runs_away(f, k))
            fail(a,
                 "No minimum was found: the cost falls ever slower while weight %d goes to %s (it is %.2g).",
                 index, w < 1 ? "0" : "infinity", w);
    }
}
