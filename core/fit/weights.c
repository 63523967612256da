#include "core/fit/weights.h"

#include "core/fit/candidate.h"
#include "core/fit/fit.h"
#include "core/fit/objective.h"
#include "core/fit/quantile.h"
#include "core/fit/rank.h"

#include "core/require.h"
#include <math.h>
#include <stddef.h>
#include <stdlib.h>

static const double WIDEST = 16, BY_CHANCE = 0.05;

/* *fall: D; *more: m.  Returns 0 when there is no memory. */
static cagd_status linear_model(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *r,
                                double *fall, int *rank)
{
    fit_problem p;
    fit_rank k = {0};
    cagd_status status = fit_problem_make(data, options, &fit_usual_strategy, &p, &(int){0});
    fit_objective *o = status == CAGD_OK ? fit_objective_new(&p) : NULL;
    fit_curve *curve = status == CAGD_OK ? fit_curve_new(p.degree, p.count, p.period, p.dim, p.knots) : NULL;
    int *none = calloc((size_t)p.unknowns + 1, sizeof *none), n = p.unknowns;
    if (status == CAGD_OK && (o == NULL || curve == NULL || none == NULL))
        status = CAGD_NO_MEMORY;
    if (status == CAGD_OK) {
        fit_problem_curve(&p, options->initial, curve);
        fit_objective_begin(o, curve, r->feet);
        if (!fit_rank_of(n, fit_problem_equations(&p), fit_problem_roundings(&p), o->triangle, n + 1, none, &k))
            status = CAGD_NO_MEMORY;
    }
    *fall = 0, *rank = k.rank;
    for (int j = 0; status == CAGD_OK && j < k.rank; j++) {
        double z = 0;
        for (int i = 0; i < n; i++)
            z += k.U[i * n + j] * o->triangle[i * (n + 1) + n];
        *fall += z * z;
    }
    if (k.U != NULL)
        fit_rank_free(&k);
    fit_curve_free(curve);
    fit_objective_free(o);
    free(none);
    fit_problem_free(&p);
    return status;
}

/* The distances of a spline that is to have weights and has none hold its misfit as well.  What weights would leave of the sum of squares, `rest` on
 * `left` degrees of freedom, is of errors alone, and so are standard errors by it. */
static void leave_out(double rest, int left, cagd_fit_result *r)
{
    r->found.weights = 2;
    for (int q = 0; q < r->unknowns + r->invariants; q++)
        r->interval_by[q] = CAGD_FIT_INTERVAL_NOT_SOUGHT;
    if (r->scale_is_given)
        return;
    const double scale_squared = rest / left;
    for (int k = 0; k < r->unknowns * r->unknowns; k++)
        r->covariance[k] *= scale_squared / r->scale_squared;
    r->scale_squared = scale_squared;
    r->quantile = fit_student_quantile(left);
}

cagd_status fit_test_weights(const cagd_fit_data *data, const cagd_fit_options *options, double within,
                             cagd_fit_result **result, int *where)
{
    cagd_fit_result *r = *result;
    cagd_fit_found *found = &r->found;
    found->weights = -1;
    if (!cagd_fit_is_minimum(r) || found->ellipse.known || options->loss != CAGD_FIT_SQUARES || r->points_on_curve ||
        options->smooth > 0 || found->smoothed || options->monotone || r->curve.count == r->curve.degree + 1 ||
        r->rank < r->unknowns)
        return CAGD_OK;
    cagd_fit_options free = *options;
    free.initial = &r->curve;
    free.free |= CAGD_FIT_WEIGHTS;
    double fall;
    int rank;
    cagd_status status = linear_model(data, &free, r, &fall, &rank);
    REQUIRE(status == CAGD_OK, status);
    const int more = rank - r->rank, left = r->degrees_of_freedom - more;
    if (more <= 0 || left <= 0 || !(r->chi_squared > fall))
        return CAGD_OK;
    found->weights = 0;
    found->weights_number = more, found->weights_freedom = left;
    found->weights_ratio = data->sigma != NULL ? fall / more : fall / more / ((r->chi_squared - fall) / left);
    found->weights_probability = fit_f_probability(found->weights_ratio, more, data->sigma != NULL ? 1e9 : left);
    if (!(found->weights_probability < BY_CHANCE))
        return CAGD_OK;
    cagd_fit_result *weighted = NULL;
    free.weight_low = fmax(free.weight_low, 1 / WIDEST);
    free.without_intervals = 1; /* where the same points have asked for weights they covered 90 % */
    free.weight_high = fmin(free.weight_high, WIDEST);
    status = fit_plainly(data, &free, &weighted, where);
    REQUIRE(status == CAGD_OK || status == CAGD_TOO_FEW, status);
    int better = status == CAGD_OK && (!(found->within > 0) || weighted->largest <= within);
    for (int k = 0; better && k < weighted->unknowns; k++)
        better = !weighted->at_bound[k];
    if (!better || !fit_is_good(data, options, weighted) || !(fit_score(data, weighted) < fit_score(data, r))) {
        cagd_fit_free(weighted);
        leave_out(r->chi_squared - fall, left, r);
        return CAGD_OK;
    }
    weighted->found = *found;
    weighted->found.weights = 1;
    if (within > 0)
        weighted->found.within = weighted->largest <= within ? 1 : -1;
    cagd_fit_free(r);
    *result = weighted;
    return CAGD_OK;
}
