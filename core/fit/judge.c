#include "core/fit/attempt.h"

#include "core/number/limits.h"

#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>

/* The largest share R_index at the measured points, and at the middles of the pieces; from `enough` on it may be a smaller one. */
static double largest_share(const fit_problem *p, const fit_objective *f, int index, double enough)
{
    const fit_curve *curve = f->curve;
    double R[MAX_DEGREE + 1], R1[MAX_DEGREE + 1], largest = 0;
    for (int i = -curve->pieces; largest < enough && i < p->points; i++) {
        int piece = i < 0 ? i + curve->pieces : fit_curve_piece(curve, f->feet[i]);
        int mu = curve->span[piece], m = index - mu + p->degree;
        if (m < 0 || m > p->degree)
            continue;
        fit_curve_shares(curve, piece, i < 0 ? (curve->knots[mu] + curve->knots[mu + 1]) / 2 : f->feet[i], R, R1);
        largest = fmax(largest, R[m]);
    }
    return largest;
}

static void fail(fit_attempt *a, const char *form, ...)
{
    va_list values;
    va_start(values, form);
    a->outcome.termination = CAGD_FIT_FAILED;
    vsnprintf(a->outcome.message, sizeof a->outcome.message, form, values);
    va_end(values);
}

/* Whether the gradient along log w_k is small only because the weight hardly counts, not because the residuals are orthogonal
 * to its column of the Jacobian: Gauss and Newton's step in it alone would take more than sqrt(tolerance) of the cost away, and
 * the weight from one end of the precision to the other, 2^53 times what it is. */
static int runs_away(const fit_problem *p, const fit_objective *f, double tolerance, int k)
{
    int n = p->unknowns;
    double g = fit_objective_gradient(f, k), square = 0;
    for (int i = 0; i < n; i++)
        square += f->triangle[i * (n + 1) + k] * f->triangle[i * (n + 1) + k];
    return g * g > 2 * (sqrt(tolerance) * f->cost + fit_problem_blur(p, f->cost)) * square &&
           fabs(g) > -log(DBL_EPSILON / 2) * square;
}

void fit_attempt_judge(const fit_problem *p, const cagd_fit_options *o, fit_attempt *a)
{
    const fit_objective *f = a->objective;
    if (!isfinite(f->cost))
        fail(a, "The distances have left the range of numbers.");
    for (int k = 0; isfinite(f->cost) && k < p->unknowns; k++) {
        int index = p->unknown[k].index;
        double w = f->curve->weights[index];
        if (!p->unknown[k].is_weight || fit_problem_on_bound(p, k, f->curve))
            continue;
        if (largest_share(p, f, index, DBL_EPSILON / 2) < DBL_EPSILON / 2 || runs_away(p, f, o->tolerance, k))
            fail(a,
                 "No minimum was found: the cost falls ever slower while weight %d goes to %s (it is %.2g); other "
                 "starts, or bounds on the weights, may help.",
                 index, w < 1 ? "0" : "infinity", w);
    }
}
