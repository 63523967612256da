/* test_fit_statistics.c -- quantiles against known digits, statistics against sums made by hand. */
#include "unit_exact.h"

#include "core/fit/loss.h"
#include "core/fit/quantile.h"
#include "core/fit/statistics.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* The solutions of I_{nu/(nu+t^2)}(nu/2, 1/2) = 1/20, the incomplete beta function, to 20 digits in arithmetic of 40. */
static void quantiles_to_the_last_digit(void **state)
{
    (void)state;
    static const struct {
        int nu;
        double t;
    } known[] = {{1, 12.706204736174704646},    {2, 4.3026527297494638523},    {3, 3.1824463052837095927},
                 {4, 2.7764451051977943578},    {5, 2.5705818356363155147},    {10, 2.2281388519862747484},
                 {13, 2.1603686564627925015},   {29, 2.0452296421327042982},   {30, 2.04227245630123831},
                 {100, 1.9839715185235522866},  {1000, 1.962339080826408485},  {4999, 1.9604386466615249012},
                 {5000, 1.9604385517065079186}, {5001, 1.9604384567894743829}, {5002, 1.9604383619104015079},
                 {20000, 1.9600826051581351942}};
    for (size_t k = 0; k < sizeof known / sizeof known[0]; k++)
        assert_true(fabs(fit_student_quantile(known[k].nu) - known[k].t) <=
                    nextafter(known[k].t, INFINITY) - known[k].t);
    assert_true(fabs(erfc(fit_normal_quantile() / sqrt(2)) - 0.05) < 4 * DBL_EPSILON * 0.05);
    for (int nu = 1; nu < 12000; nu += 1 + nu / 7)
        assert_true(fit_student_quantile(nu + 1) < fit_student_quantile(nu));
    assert_true(fit_student_quantile(2000000000) >= fit_normal_quantile());
    assert_true(isnan(fit_student_quantile(0)) && isnan(fit_student_quantile(-3)));
}

/* rho' and rho'' by differences. */
static void losses_have_their_derivatives(void **state)
{
    (void)state;
    static const cagd_fit_loss losses[] = {CAGD_FIT_SQUARES, CAGD_FIT_HUBER, CAGD_FIT_CAUCHY};
    static const double places[] = {0.25, 1, 2.5, 30};
    const double h = 0x1p-16;
    for (int l = 0; l < 3; l++)
        for (int k = 0; k < 4; k++) {
            double value[3], left[3], right[3], s = places[k];
            fit_loss(losses[l], 1.25, s, value);
            fit_loss(losses[l], 1.25, s - h, left);
            fit_loss(losses[l], 1.25, s + h, right);
            for (int r = 0; r < 2; r++) /* the error of a central difference is of the size h^2, its rounding u/h */
                assert_true(fabs((right[r] - left[r]) / (2 * h) - value[r + 1]) < h * h + 0x1p-50 / h * (1 + s));
        }
    double zero[3];
    fit_loss(CAGD_FIT_HUBER, 2, 0, zero);
    assert_true(zero[0] == 0 && zero[1] == 1 && zero[2] == 0);
}

/* ---- A conic with three unknowns --------------------------------------------------------------------- */

enum { N = 8 };
static double points[2 * N], sigma[N], residuals[3 * N], covariance[9], invariant[1], invariant_error[1];
static double knots[] = {0, 0, 0, 1, 1, 1}, control[8], weights[3]; /* room for a cubic */
static int determined[3], at_bound[3];
static cagd_fit_unknown unknown[3] = {{1, 1, 0}, {0, 1, 0}, {0, 1, 1}};
static cagd_fit_data data;
static cagd_fit_options options;
static cagd_fit_result result;

static void conic(double w)
{
    static const double P[] = {0, 0, 1, 2, 3, 0}, C[] = {0.04, 0.01, 0.02, 0.01, 0.09, 0, 0.02, 0, 0.16};
    memcpy(control, P, sizeof P);
    memcpy(covariance, C, sizeof C);
    weights[0] = weights[2] = 1, weights[1] = w;
    for (int i = 0; i < N; i++) {
        sigma[i] = 0.5;
        points[2 * i] = points[2 * i + 1] = 10 + i;
        residuals[2 * i] = 0.3 * (i + 1);
        residuals[2 * i + 1] = -0.4 * (i + 1); /* of length (i+1)/2 */
    }
    for (int a = 0; a < 3; a++)
        determined[a] = 1, at_bound[a] = 0;
    data = (cagd_fit_data){N, 2, points, NULL};
    options = (cagd_fit_options){.loss = CAGD_FIT_SQUARES, .loss_scale = 1};
    result = (cagd_fit_result){.end_points = {-1, -1},
                               .curve = {2, 3, 2, knots, control, weights},
                               .relative = control,
                               .count = N,
                               .residuals = residuals,
                               .unknowns = 3,
                               .rank = 3,
                               .effective = 3,
                               .unknown = unknown,
                               .at_bound = at_bound,
                               .covariance = covariance,
                               .determined = determined,
                               .invariants = 1,
                               .invariant = invariant,
                               .invariant_error = invariant_error};
}
static int near(double a, double b) { return fabs(a - b) <= 16 * DBL_EPSILON * fabs(b); }

static void unknown_standard_deviations(void **state)
{
    (void)state;
    conic(0.5);
    fit_statistics(&data, &options, &result);
    double chi = 204 / 4.0; /* 1 + 4 + ... + 64 = 204 */
    assert_true(near(result.chi_squared, chi) && result.degrees_of_freedom == 5);
    assert_true(near(result.reduced_chi_squared, chi / 5) && near(result.scale_squared, chi / 5));
    assert_true(near(result.aic, 8 * log(chi / 8) + 8) && near(result.bic, 8 * log(chi / 8) + 4 * log(8)));
    assert_true(result.quantile == fit_student_quantile(5));
    assert_true(near(covariance[0], 0.04 * chi / 5) && near(covariance[2], 0.02 * chi / 5));
    assert_true(near(invariant[0], 0.25) && near(invariant_error[0], 0.25 * 2 * sqrt(0.04 * chi / 5)));
    result.effective = NAN; /* a smoothing term whose matrix is singular */
    fit_statistics(&data, &options, &result);
    assert_true(result.degrees_of_freedom == 5 && isnan(result.aic) && isnan(result.bic));
    result.rank = 8, result.effective = 8; /* as many unknowns as equations */
    fit_statistics(&data, &options, &result);
    assert_true(isnan(result.scale_squared) && isnan(result.quantile) && isnan(invariant_error[0]));
    assert_int_equal(cagd_fit_conic_of(&result).kind, CAGD_FIT_CONIC_UNKNOWN);
}

/* Residuals are left where they cannot be, at the ends: what counts is how many equations there are. */
static void given_ends_are_no_measurements(void **state)
{
    (void)state;
    conic(0.5);
    points[2] = points[3] = 0;      /* the first point of the curve */
    points[14] = 3, points[15] = 0; /* the last one */
    points[4] = 1, points[5] = 2;   /* an inner one, which is no end */
    fit_statistics(&data, &options, &result);
    assert_int_equal(result.degrees_of_freedom, 3);
    assert_true(near(result.scale_squared, 51 / 3.0) && near(result.aic, 6 * log(51 / 6.0) + 8));
    options.free = CAGD_FIT_END_POINTS;
    fit_statistics(&data, &options, &result);
    assert_int_equal(result.degrees_of_freedom, 5);
    options.free = 0, result.origin[0] = 1, points[2] = 1, points[14] = 4;
    fit_statistics(&data, &options, &result);
    assert_int_equal(result.degrees_of_freedom, 3);
    options.loss = CAGD_FIT_HUBER,
    options.loss_scale = 100; /* nothing is beyond: squares of the points without the ends */
    fit_statistics(&data, &options, &result);
    assert_true(near(result.scale_squared, (51 - 1 - 16) / 3.0));
}

/* The flag of the ends says nothing of a closed curve: neither is an end exact, nor a point one, as the first and the last one would be. */
static void closed_curves_have_no_ends(void **state)
{
    (void)state;
    for (int free = CAGD_FIT_INNER_POINTS; free <= CAGD_FIT_INNER_POINTS + CAGD_FIT_END_POINTS;
         free += CAGD_FIT_END_POINTS)
        for (int known = 0; known < 2; known++) {
            conic(0.5);
            points[2] = points[3] = 0;      /* where the curve begins, and */
            points[14] = 3, points[15] = 0; /* where it ends               */
            data.sigma = known ? sigma : NULL;
            options.free = free, options.closed = 1, result.period = 1;
            fit_statistics(&data, &options, &result);
            assert_int_equal(result.ends_are_exact, 0);
            assert_int_equal(result.degrees_of_freedom, 5);
            result.period = 0, options.closed = 0; /* of an open curve it says so */
            fit_statistics(&data, &options, &result);
            assert_int_equal(result.ends_are_exact, free == CAGD_FIT_INNER_POINTS);
            assert_int_equal(result.degrees_of_freedom, free == CAGD_FIT_INNER_POINTS ? 3 : 5);
        }
}

static void given_standard_deviations(void **state)
{
    (void)state;
    conic(0.5);
    data.sigma = sigma;
    fit_statistics(&data, &options, &result);
    assert_true(near(result.chi_squared, 204) && near(result.reduced_chi_squared, 204 / 5.0));
    assert_true(result.scale_squared == 1 && result.quantile == fit_normal_quantile() && covariance[0] == 0.04);
    assert_true(near(result.aic, 210) && near(result.bic, 204 + 3 * log(8)));
    determined[0] = 0;
    fit_statistics(&data, &options, &result);
    assert_true(isinf(invariant_error[0]));
    at_bound[0] = 1; /* held there: not an unknown */
    fit_statistics(&data, &options, &result);
    assert_true(isfinite(invariant_error[0]));
}

/* Residuals of length i/2, i = 1, ..., 8; beyond a = 1 Huber's psi is 1 and its derivative 0. */
static void robust_covariance(void **state)
{
    (void)state;
    conic(0.5);
    options.loss = CAGD_FIT_HUBER;
    fit_statistics(&data, &options, &result);
    double mean = 2 / 8.0, variance = mean * (1 - mean), K = 1 + 3 / 8.0 * variance / (mean * mean);
    double spread = 0.25 + 1 + 6;
    assert_true(near(result.scale_squared, K * K * spread / 5 / (mean * mean)));
    assert_true(near(result.chi_squared, 0.25 + 1 + (2 * 0.5 * (3 + 4 + 5 + 6 + 7 + 8) - 6)));
    assert_true(result.quantile == fit_student_quantile(5));
    conic(0.5);
    options.loss = CAGD_FIT_HUBER;
    result.effective = 1.2; /* a smoothing term: of the three unknowns the points determine about one */
    fit_statistics(&data, &options, &result);
    K = 1 + 1 / 8.0 * variance / (mean * mean);
    assert_int_equal(result.degrees_of_freedom, 7);
    assert_true(near(result.scale_squared, K * K * spread / 7 / (mean * mean)));
    conic(0.5); /* nothing is beyond: squares */
    options.loss = CAGD_FIT_HUBER, options.loss_scale = 100;
    fit_statistics(&data, &options, &result);
    assert_true(near(result.scale_squared, 204 / 4.0 / 5));
}

/* Estimates, standard errors 0.2, 0.3 and 0.4, intervals, a correlation of 1/6, deviations. */
static void estimates_with_their_intervals(void **state)
{
    (void)state;
    static double relative[] = {0, 0, 1, 2, 3, 0}, value[3], distances[N], spacing;
    conic(0.5);
    value[0] = log(0.5), value[1] = 1, value[2] = 2;
    data.sigma = sigma;
    result.value = value, result.relative = relative, result.distances = distances;
    result.termination = CAGD_FIT_CONVERGED;
    result.origin[0] = 1000;
    distances[3] = -2;
    fit_statistics(&data, &options, &result);
    assert_true(cagd_fit_is_minimum(&result) && result.scale_is_given && result.ends_are_exact);
    const double z = fit_normal_quantile();
    cagd_fit_estimate w = cagd_fit_unknown_estimate(&result, 0), x = cagd_fit_unknown_estimate(&result, 1);
    assert_true(near(w.value, 0.5) && near(w.error, 0.5 * 0.2) && w.origin == 0);
    assert_true(near(w.low, 0.5 * exp(-z * 0.2)) && near(w.high, 0.5 * exp(z * 0.2)));
    assert_true(x.value == 1 && near(x.error, 0.3) && x.origin == 1000);
    cagd_fit_estimate y = cagd_fit_unknown_estimate(&result, 2);
    assert_true(y.value == 2 && near(y.error, 0.4) && y.origin == 0);
    assert_true(near(x.low, 1 - z * 0.3) && near(x.high, 1 + z * 0.3));
    cagd_fit_estimate I = cagd_fit_invariant_estimate(&result, 0);
    assert_true(near(I.value, 0.25) && near(I.error, 0.25 * 0.4) && near(I.high, 0.25 * exp(z * 0.4)));
    assert_true(near(I.low, 0.25 * exp(-z * 0.4)));
    assert_true(near(cagd_fit_correlation(&result, 1, 0), 0.01 / (0.2 * 0.3)));
    assert_true(near(cagd_fit_correlation(&result, 0, 2), 0.02 / (0.2 * 0.4)));
    assert_true(near(cagd_fit_correlation(&result, 2, 0), 0.02 / (0.2 * 0.4)));
    assert_true(cagd_fit_deviation(&data, &result, 3) == 0.5 && near(cagd_fit_standardised(&data, &result, 3), -4));
    sigma[3] = 0;
    assert_true(isnan(cagd_fit_standardised(&data, &result, 3)));
    result.spacing[0] = 0.35, result.spacing[1] = 0.41;
    assert_true(cagd_fit_finest_unknown(&result, &spacing) == 1 && spacing == 0.41);
    result.spacing[0] = 0.29, result.spacing[1] = 0.39;
    assert_int_equal(cagd_fit_finest_unknown(&result, &spacing), -1);
    determined[1] = 0, at_bound[2] = 1;
    assert_true(isnan(cagd_fit_unknown_estimate(&result, 1).error) &&
                isnan(cagd_fit_unknown_estimate(&result, 2).high));
    value[0] = 800;
    assert_true(isnan(cagd_fit_unknown_estimate(&result, 0).error));
    value[0] = log(0.5);
    data.sigma = NULL;
    options.free = CAGD_FIT_END_POINTS;
    fit_statistics(&data, &options, &result);
    assert_true(!result.scale_is_given && !result.ends_are_exact);
    assert_true(near(cagd_fit_deviation(&data, &result, 0), sqrt(204 / 4.0 / 5)));
    cagd_fit_refute(&result); /* then nothing is said */
    assert_true(!cagd_fit_is_minimum(&result) && isnan(cagd_fit_unknown_estimate(&result, 0).error));
    assert_true(isnan(cagd_fit_invariant_estimate(&result, 0).low) && isnan(cagd_fit_deviation(&data, &result, 0)));
    assert_true(isnan(cagd_fit_standardised(&data, &result, 3)));
    result.refuted = 0;
    result.termination = CAGD_FIT_NOT_CONVERGED;
    assert_true(!cagd_fit_is_minimum(&result) && isnan(cagd_fit_unknown_estimate(&result, 0).error));
}

static void which_conic(void **state)
{
    (void)state;
    static const struct {
        double w;
        cagd_fit_conic_kind kind;
        cagd_conic_type type;
        const char *text;
    } expected[] = {{0.5, CAGD_FIT_CONIC_CERTAIN, CAGD_ELLIPSE, "an ellipse at 95 %"},
                    {0.8, CAGD_FIT_CONIC_UNDECIDED, CAGD_ELLIPSE, "cannot tell ellipse from parabola"},
                    {1.2, CAGD_FIT_CONIC_UNDECIDED, CAGD_HYPERBOLA, "cannot tell hyperbola from parabola"},
                    {2, CAGD_FIT_CONIC_CERTAIN, CAGD_HYPERBOLA, "a hyperbola at 95 %"}};
    for (int k = 0; k < 4; k++) {
        conic(expected[k].w);
        data.sigma = sigma;
        fit_statistics(&data, &options, &result);
        cagd_fit_conic c = cagd_fit_conic_of(&result); /* log w is known to 0.2 */
        assert_true(near(c.log_invariant, 2 * log(expected[k].w)) && near(c.error, 0.4));
        assert_int_equal(c.kind, expected[k].kind);
        assert_int_equal(c.type, expected[k].type);
        assert_string_equal(c.text, expected[k].text);
    }
    conic(0.5);
    data.sigma = sigma;
    control[3] = 0.5; /* the middle point is 0.5 above the line, its height known to 0.4 */
    fit_statistics(&data, &options, &result);
    assert_int_equal(cagd_fit_conic_of(&result).kind, CAGD_FIT_STRAIGHT);
    conic(1);
    data.sigma = sigma;
    result.unknown = unknown + 1, result.unknowns = 2, result.rank = 2, result.effective = 2; /* the weight is given */
    fit_statistics(&data, &options, &result);
    assert_string_equal(cagd_fit_conic_of(&result).text, "a parabola, by its given weights");
    result.curve.degree = 3;
    assert_int_equal(cagd_fit_conic_of(&result).kind, CAGD_FIT_NOT_QUADRATIC);
    conic(1);
    data.sigma = sigma;
    memset(covariance, 0, sizeof covariance); /* of rank 0: nothing is given, and nothing known */
    determined[0] = determined[1] = determined[2] = 0, result.rank = 0, result.effective = 0, result.flat = 3;
    fit_statistics(&data, &options, &result);
    assert_int_equal(cagd_fit_conic_of(&result).kind, CAGD_FIT_CONIC_UNKNOWN);
    assert_string_equal(cagd_fit_conic_of(&result).text, "of a type that the points do not determine");
    conic(0.5);
    data.sigma = sigma;
    at_bound[0] = 1;
    fit_statistics(&data, &options, &result);
    assert_string_equal(cagd_fit_conic_of(&result).text, "an ellipse whose weight is on its bound");
}

/* Whose logarithm is known when it is 0 in binary64: log I_1 = 2 (-800), log I_2 of a cubic 800 + 800. */
static void a_weight_that_is_zero(void **state)
{
    (void)state;
    static double value[3] = {-800, 1, 2}, four[4] = {1, 0, 1, 1}, two[2], error[2];
    conic(0);
    data.sigma = sigma;
    result.value = value;
    fit_statistics(&data, &options, &result);
    cagd_fit_conic c = cagd_fit_conic_of(&result);
    assert_true(invariant[0] == 0 && invariant_error[0] == 0 && c.log_invariant == -1600 && near(c.error, 0.4));
    result.curve.degree = 3, result.curve.count = 4, result.curve.weights = four;
    result.invariants = 2, result.invariant = two, result.invariant_error = error;
    fit_statistics(&data, &options, &result);
    assert_true(two[0] == 0 && isinf(two[1]) && isinf(error[1]));
}

/* The cubic with the cusp (1/2, 3/4) at t = 1/2, and with its middle points moved by e towards one another or apart:  C'(1/2) = (3e/2, 0) and
 * C''(1/2) = (0, -6), hence the radius 3/8 e^2. */
static void which_curves_turn_as_at_a_cusp(void **state)
{
    (void)state;
    static const double e = 0x1p-5, cubic_knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    double t = -1, P[] = {0, 0, 1, 1, 0, 1, 1, 0};
    cagd_fit_result r = {.curve = {3, 4, 2, cubic_knots, P, NULL}};
    assert_true(cagd_fit_has_cusp(&r, &t) && near(t, 0.5));
    for (int side = -1; side <= 1; side += 2) {
        P[2] = 1 + side * e, P[4] = -side * e; /* a loop for +, else a smooth turn */
        r.rms = 0, t = -1;
        assert_true(!cagd_fit_has_cusp(&r, &t) && t == -1);
    }
    P[2] = 1 - e, P[4] = e;
    r.rms = 0.99 * 3 / 8 * e * e;
    assert_true(!cagd_fit_has_cusp(&r, &t));
    r.rms = 1.01 * 3 / 8 * e * e;
    assert_true(cagd_fit_has_cusp(&r, &t) && near(t, 0.5));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(quantiles_to_the_last_digit),
                                       cmocka_unit_test(losses_have_their_derivatives),
                                       cmocka_unit_test(unknown_standard_deviations),
                                       cmocka_unit_test(given_ends_are_no_measurements),
                                       cmocka_unit_test(closed_curves_have_no_ends),
                                       cmocka_unit_test(given_standard_deviations),
                                       cmocka_unit_test(robust_covariance),
                                       cmocka_unit_test(estimates_with_their_intervals),
                                       cmocka_unit_test(which_conic),
                                       cmocka_unit_test(a_weight_that_is_zero),
                                       cmocka_unit_test(which_curves_turn_as_at_a_cusp)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
