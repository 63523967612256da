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
static double knots[] = {0, 0, 0, 1, 1, 1}, control[10], weights[3]; /* room for a quartic */
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

/* P(F > x), m and d degrees of freedom: with m = 2 it is (1 + 2x/d)^(-d/2), with m = 4 and y = d/(d + 4x) it is y^(d/2) (1 + d/2 (1 - y)); F with
 * m = 1 is the square of Student's t; and 1/F has the distribution with m and d exchanged. */
static void probabilities_of_f(void **state)
{
    (void)state;
    static const double at[] = {0.01, 0.3, 1, 1.7, 4, 25};
    for (int d = 1; d <= 40; d += d < 5 ? 1 : 7)
        for (int k = 0; k < 6; k++) {
            const double x = at[k], y = d / (d + 4 * x);
            assert_true(fabs(fit_f_probability(x, 2, d) / pow(1 + 2 * x / d, -d / 2.0) - 1) < 1e-12);
            assert_true(fabs(fit_f_probability(x, 4, d) / (pow(y, d / 2.0) * (1 + d / 2.0 * (1 - y))) - 1) < 1e-12);
            assert_true(fabs(fit_f_probability(x, 3, d) + fit_f_probability(1 / x, d, 3) - 1) < 1e-13);
        }
    for (int nu = 1; nu < 200; nu += 1 + nu / 3) {
        const double t = fit_student_quantile(nu);
        assert_true(fabs(fit_f_probability(t * t, 1, nu) - 0.05) < 1e-13);
        assert_true(fabs(fit_f_probability(1, nu, nu) - 0.5) < 1e-12);
    }
    assert_true(fit_f_probability(0, 3, 5) == 1 && fit_f_probability(INFINITY, 3, 5) == 0);
}

/* rho itself, at both sides of where Huber's loss bends and there. */
static void losses_are_what_they_are_called(void **state)
{
    (void)state;
    static const double a = 1.5, at[] = {0, 1, 2.25, 4, 100};
    for (int k = 0; k < 5; k++) {
        double value[3], s = at[k];
        fit_loss(CAGD_FIT_SQUARES, a, s, value);
        assert_true(value[0] == s && value[1] == 1 && value[2] == 0);
        fit_loss(CAGD_FIT_CAUCHY, a, s, value);
        assert_true(fabs(value[0] - 2.25 * log(1 + s / 2.25)) < 1e-14 * (1 + s));
        assert_true(near(value[1], 2.25 / (2.25 + s)) && near(value[2], -2.25 / ((2.25 + s) * (2.25 + s))));
        fit_loss(CAGD_FIT_HUBER, a, s, value);
        assert_true(fabs(value[0] - (s <= 2.25 ? s : 3 * sqrt(s) - 2.25)) < 1e-14 * (1 + s));
        assert_true(near(value[1], s <= 2.25 ? 1 : 1.5 / sqrt(s)) && (value[2] == 0) == (s <= 2.25));
    }
}

/* In space there are two residuals a point across the curve, and three of an end that is measured; a closed curve has no ends that are given, and a foot that is
 * shared is an equation more.  Huber's factor has the two directions in it. */
static void equations_of_space_and_of_closed_curves(void **state)
{
    (void)state;
    static double in_space[3 * N], relative[9] = {0, 0, 0, 1, 2, 1, 3, 0, 0};
    static const cagd_fit_loss losses[] = {CAGD_FIT_CAUCHY, CAGD_FIT_HUBER};
    conic(0.5);
    for (int i = 0; i < N; i++)
        for (int c = 0; c < 3; c++)
            in_space[3 * i + c] = 10 + i + c, residuals[3 * i + c] = (c == 0 ? 2 : c == 1 ? -1 : 2) / 6.0 * (i + 1);
    data = (cagd_fit_data){N, 3, in_space, NULL}; /* residuals of length (i+1)/2 */
    result.curve.dim = 3, result.curve.points = relative, result.relative = relative;
    fit_statistics(&data, &options, &result);
    assert_true(result.degrees_of_freedom == 13 && near(result.chi_squared, 51) &&
                near(result.scale_squared, 51 / 13.0));
    assert_true(near(result.aic, 16 * log(51 / 16.0) + 8) && near(result.bic, 16 * log(51 / 16.0) + 4 * log(16)));
    result.end_points[0] = 0, result.end_points[1] = 7;
    fit_statistics(&data, &options, &result);
    assert_int_equal(result.degrees_of_freedom, 15);
    result.end_points[0] = 3;
    fit_statistics(&data, &options, &result);
    assert_int_equal(result.degrees_of_freedom, 15);
    result.end_points[0] = result.end_points[1] = -1, result.tied = 4;
    fit_statistics(&data, &options, &result);
    assert_int_equal(result.degrees_of_freedom, 17);
    result.tied = 0;
    for (int c = 0; c < 3; c++) /* one point is the given start, and one differs from it in the last coordinate */
        in_space[6 + c] = relative[c], in_space[15 + c] = relative[c] + (c == 2);
    fit_statistics(&data, &options, &result);
    assert_int_equal(result.degrees_of_freedom, 11);
    result.period = 3;
    fit_statistics(&data, &options, &result);
    assert_int_equal(result.degrees_of_freedom, 13);
    for (int l = 0; l < 2; l++)
        for (int given = 0; given < 2; given++) {
            double spread = 0, mean = 0, variance = 0, m[N], value[3], sum = 0;
            options = (cagd_fit_options){.loss = losses[l], .loss_scale = 1.25};
            data.sigma = given ? sigma : NULL;
            for (int i = 0; i < N; i++) {
                sigma[i] = 0.5 + i % 3;
                const double r = (i + 1) / 2.0 / (given ? sigma[i] : 1), s = r * r;
                fit_loss(losses[l], 1.25, s, value);
                m[i] = value[1] + s * value[2], mean += m[i] / N, spread += value[1] * value[1] * s, sum += value[0];
            }
            for (int i = 0; i < N; i++)
                variance += (m[i] - mean) * (m[i] - mean) / N;
            const double K = 1 + 3 / 16.0 * variance / (mean * mean);
            fit_statistics(&data, &options, &result);
            assert_true(near(result.chi_squared, sum) && !result.scale_is_given);
            assert_true(near(result.scale_squared, K * K * spread / 13 / (mean * mean)));
            assert_true(result.quantile == fit_student_quantile(13));
        }
}

/* A quartic with three free weights: I_j depends on the weights beside w_j as well, and is not determined where one of the three is not. */
static void invariants_depend_on_three_weights(void **state)
{
    (void)state;
    enum { W = 3 };
    static const double slope[W][W] = {{2, -1, 0}, {-1, 2, -1}, {0, -1, 2}}, value[W] = {8, 1 / 24.0, 18};
    static double w[] = {1, 2, 0.5, 3, 1}, I[W], error[W];
    static cagd_fit_unknown weight[W] = {{1, 1, 0}, {1, 2, 0}, {1, 3, 0}};
    conic(0.5);
    data.sigma = sigma;
    result.curve.degree = 4, result.curve.count = 5, result.curve.weights = w;
    result.unknown = weight, result.invariants = W, result.invariant = I, result.invariant_error = error;
    fit_statistics(&data, &options, &result);
    for (int j = 0; j < W; j++) {
        double variance = 0;
        for (int a = 0; a < W; a++)
            for (int b = 0; b < W; b++)
                variance += slope[j][a] * slope[j][b] * covariance[a * W + b];
        assert_true(near(I[j], value[j]) && fabs(error[j] / (value[j] * sqrt(variance)) - 1) < 1e-14);
    }
    for (int a = 0; a < W; a++)
        for (int bound = 0; bound < 2; bound++) {
            determined[0] = determined[1] = determined[2] = 1, at_bound[0] = at_bound[1] = at_bound[2] = 0;
            determined[a] = 0, at_bound[a] = bound;
            fit_statistics(&data, &options, &result);
            for (int j = 0; j < W; j++)
                assert_int_equal(isinf(error[j]) != 0, !bound && slope[j][a] != 0);
        }
    result.curve.weights = NULL;
    fit_statistics(&data, &options, &result);
    assert_true(I[0] == 1 && I[1] == 1 && I[2] == 1);
    covariance[0] = covariance[4] = covariance[8] = -1; /* what rounding may leave of a variance of 0 */
    fit_statistics(&data, &options, &result);
    assert_true(error[1] == 0 || isinf(error[1]));
}

/* The interval of the logarithm of I_1, wherever it comes from, and only that one, says whether a type is certain; where there is none no type is. */
static void a_type_is_as_certain_as_its_interval(void **state)
{
    (void)state;
    static cagd_fit_interval by[4];
    static double interval[8];
    static const struct {
        cagd_fit_interval by;
        double low, high;
        cagd_fit_conic_kind kind;
    } of[] = {{CAGD_FIT_INTERVAL_LINEAR, -1, 1, CAGD_FIT_CONIC_CERTAIN},
              {CAGD_FIT_INTERVAL_NONE, -2, -1, CAGD_FIT_CONIC_UNDECIDED},
              {CAGD_FIT_INTERVAL_NOT_SOUGHT, -2, -1, CAGD_FIT_CONIC_UNDECIDED},
              {CAGD_FIT_INTERVAL_PROFILE, -2, -0.1, CAGD_FIT_CONIC_CERTAIN},
              {CAGD_FIT_INTERVAL_PROFILE, -2, 0, CAGD_FIT_CONIC_UNDECIDED},
              {CAGD_FIT_INTERVAL_PROFILE, -2, 0.1, CAGD_FIT_CONIC_UNDECIDED},
              {CAGD_FIT_INTERVAL_PROFILE, 0, 1, CAGD_FIT_CONIC_UNDECIDED},
              {CAGD_FIT_INTERVAL_PROFILE, 0.1, 1, CAGD_FIT_CONIC_CERTAIN}};
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        conic(0.5);
        data.sigma = sigma, result.interval_by = by, result.interval = interval;
        const int certain = of[k].kind == CAGD_FIT_CONIC_CERTAIN;
        for (int q = 0; q < 3; q++) /* those of the unknowns would say the opposite */
            by[q] = CAGD_FIT_INTERVAL_PROFILE, interval[2 * q] = certain ? -1 : 1, interval[2 * q + 1] = 2;
        by[3] = of[k].by, interval[6] = of[k].low, interval[7] = of[k].high;
        fit_statistics(&data, &options, &result);
        assert_int_equal(cagd_fit_conic_of(&result).kind, of[k].kind);
    }
    for (int side = -1; side <= 1; side += 2) { /* 2 |log w| against 0.4 z, a little more and a little less */
        conic(exp(-0.2 * fit_normal_quantile() * (1 + side * 1e-9)));
        data.sigma = sigma;
        fit_statistics(&data, &options, &result);
        assert_int_equal(cagd_fit_conic_of(&result).kind, side > 0 ? CAGD_FIT_CONIC_CERTAIN : CAGD_FIT_CONIC_UNDECIDED);
    }
}

static const char *type_of(double w)
{
    (void)w;
    data.sigma = sigma;
    fit_statistics(&data, &options, &result);
    return cagd_fit_conic_of(&result).text;
}

static void what_is_known_of_the_type(void **state)
{
    (void)state;
    static const struct {
        double w;
        const char *given, *on_bound;
    } of[] = {{0.5, "an ellipse, by its given weights", "an ellipse whose weight is on its bound"},
              {2, "a hyperbola, by its given weights", "a hyperbola whose weight is on its bound"}};
    for (int k = 0; k < 2; k++) {
        conic(of[k].w);
        at_bound[0] = 1;
        assert_string_equal(type_of(of[k].w), of[k].on_bound);
        conic(of[k].w);
        result.unknown = unknown + 1, result.unknowns = 2, result.rank = 2, result.effective = 2;
        assert_string_equal(type_of(of[k].w), of[k].given);
    }
    conic(1);
    assert_string_equal(type_of(1), "a parabola, as far as can be told");
    conic(0.5);
    result.curve.count = 4;
    assert_string_equal(type_of(0.5), "not a curve of degree 2 in one span");
    conic(0.5);
    result.curve.weights = NULL, result.unknown = unknown + 1, result.unknowns = 2, result.rank = 2,
    result.effective = 2;
    assert_string_equal(type_of(1), "a parabola, by its given weights");
    conic(0.5);
    control[3] = 0; /* the three points are on a line, whatever their errors */
    memset(covariance, 0, sizeof covariance);
    assert_string_equal(type_of(0.5), "cannot tell a conic from a straight line");
    conic(0.5);
    data.sigma = NULL, result.rank = 8, result.effective = 8;
    fit_statistics(&data, &options, &result);
    assert_string_equal(cagd_fit_conic_of(&result).text,
                        "of a type whose uncertainty is unknown: there are no degrees of freedom");
    /* Ends that slide leave the type as it is, in their two directions and no more; of ends that do not move nothing slides. */
    for (int end = 0; end <= 2; end++)
        for (int flat = 1; flat <= 3; flat++) {
            cagd_fit_unknown with_ends[3] = {{1, 1, 0}, {0, end, 0}, {0, 1, 1}};
            conic(0.5);
            result.unknown = with_ends, determined[0] = 0, result.flat = flat;
            assert_string_equal(type_of(0.5), end != 1 && flat <= 2 ? "an ellipse at 95 %"
                                                                    : "of a type that the points do not determine");
        }
}

/* h = 2 is the height of (1, 2) over the chord from (0, 0) to (3, 0), F = (1, 0) with s = 1/3: along y it changes by -2/3, 1 and -1/3, along x not at all.  In space
 * the height over the same chord is along (0, 1, 1). */
static void a_line_is_told_by_the_height_of_the_middle_point(void **state)
{
    (void)state;
    static const double share[3] = {2 / 3.0, 1, 1 / 3.0};
    const double z = fit_normal_quantile();
    for (int j = 0; j < 3; j++)
        for (int c = 0; c < 2; c++)
            for (int side = -1; side <= 1; side += 2) {
                cagd_fit_unknown one[1] = {{0, j, c}};
                conic(0.5);
                covariance[0] = pow((1 + side * 1e-9) * 2 / (share[j] * z), 2);
                result.unknown = one, result.unknowns = 1, result.rank = 1, result.effective = 1;
                assert_string_equal(type_of(0.5), c == 1 && side > 0 ? "cannot tell a conic from a straight line"
                                                                     : "an ellipse, by its given weights");
            }
    static double relative[] = {0, 0, 0, 1, 2, 2, 3, 0, 0}, in_space[3 * N];
    for (int c = 0; c < 3; c++)
        for (int side = -1; side <= 1; side += 2) {
            cagd_fit_unknown one[1] = {{0, 1, c}};
            conic(0.5);
            for (int k = 0; k < 3 * N; k++)
                in_space[k] = 10 + k;
            data = (cagd_fit_data){N, 3, in_space, sigma};
            result.curve.dim = 3, result.curve.points = relative, result.relative = side < 0 ? NULL : relative;
            options.free = CAGD_FIT_END_POINTS;
            covariance[0] = pow((1 + side * 1e-9) * sqrt(8) / (sqrt(0.5) * z), 2);
            result.unknown = one, result.unknowns = 1, result.rank = 1, result.effective = 1;
            fit_statistics(&data, &options, &result);
            assert_int_equal(cagd_fit_conic_of(&result).kind == CAGD_FIT_STRAIGHT, c > 0 && side > 0);
        }
}

/* Interval and error as they were found: of each unknown its own, and of the invariants those behind the unknowns. */
static void intervals_are_as_they_were_found(void **state)
{
    (void)state;
    static double value[3], interval[] = {-1, -0.5, 0.25, 1.75, 1.5, 2.25, -1.75, -1.25};
    static cagd_fit_interval by[4];
    conic(0.5);
    value[0] = log(0.5), value[1] = 1, value[2] = 2;
    data.sigma = sigma;
    result.value = value, result.termination = CAGD_FIT_CONVERGED, result.interval_by = by, result.interval = interval;
    fit_statistics(&data, &options, &result);
    static const double error[] = {0.1, 0.3, 0.4, 0.1};
    for (int kind = 0; kind < 4; kind++)
        for (int q = 0; q < 4; q++) {
            for (int other = 0; other < 4; other++)
                by[other] = other == q ? (cagd_fit_interval)kind : CAGD_FIT_INTERVAL_LINEAR;
            for (int k = 0; k < 4; k++) {
                const cagd_fit_estimate e =
                    k < 3 ? cagd_fit_unknown_estimate(&result, k) : cagd_fit_invariant_estimate(&result, 0);
                const int is_log = k == 0 || k == 3, own = k == q ? kind : CAGD_FIT_INTERVAL_LINEAR;
                assert_int_equal(e.by, own);
                assert_true(own == CAGD_FIT_INTERVAL_NONE ? isnan(e.error) : near(e.error, error[k]));
                if (own == CAGD_FIT_INTERVAL_PROFILE) {
                    assert_true(e.low == (is_log ? exp(interval[2 * k]) : interval[2 * k]));
                    assert_true(e.high == (is_log ? exp(interval[2 * k + 1]) : interval[2 * k + 1]));
                } else if (own == CAGD_FIT_INTERVAL_LINEAR) {
                    assert_true(e.low < e.value && e.value < e.high);
                } else {
                    assert_true(isnan(e.low) && isnan(e.high));
                }
            }
        }
    for (int q = 0; q < 4; q++)
        by[q] = CAGD_FIT_INTERVAL_PROFILE;
    cagd_fit_refute(&result); /* no interval either */
    assert_true(isnan(cagd_fit_unknown_estimate(&result, 1).low) && isnan(cagd_fit_unknown_estimate(&result, 0).high));
    assert_true(isnan(cagd_fit_invariant_estimate(&result, 0).error) &&
                isnan(cagd_fit_invariant_estimate(&result, 0).low));
    assert_true(cagd_fit_deviation(&data, &result, 3) == 0.5); /* a given deviation stays */
    result.refuted = 0;
    for (int k = 0; k < 2; k++) {
        invariant[0] = k ? INFINITY : 0;
        const cagd_fit_estimate I = cagd_fit_invariant_estimate(&result, 0);
        assert_true(I.value == invariant[0] && isnan(I.error) && isnan(I.low) && isnan(I.high));
    }
    value[0] = -800;
    assert_true(cagd_fit_unknown_estimate(&result, 0).value == 0 && isnan(cagd_fit_unknown_estimate(&result, 0).error));
}

/* The third coordinate has its own origin and its own spacing; the widest spacing is told, the smallest error named, of those that are smaller than the spacing. */
static void the_finest_coordinate(void **state)
{
    (void)state;
    static double value[3] = {0, 1, 2}, relative[] = {0, 0, 0, 1, 2, 7, 3, 0, 0}, spacing;
    static cagd_fit_unknown coordinate[3] = {{0, 1, 0}, {0, 1, 1}, {0, 1, 2}};
    static const double wide[6][3] = {{0.5, 0.6, 0.7}, {0.7, 0.6, 0.5}, {0.6, 0.7, 0.5},
                                      {0.1, 0.2, 0.5}, {0.1, 0.7, 0.1}, {0, 0, 0}};
    static const int finest[6] = {0, 0, 0, 2, 1, -1};
    static const double widest[6] = {0.7, 0.7, 0.7, 0.5, 0.7, 0};
    conic(0.5);
    data.sigma = sigma;
    result.value = value, result.unknown = coordinate, result.termination = CAGD_FIT_CONVERGED, result.invariants = 0;
    result.curve.dim = 3, result.relative = relative, result.quantile = 2;
    result.origin[0] = 10, result.origin[1] = 20, result.origin[2] = 30; /* errors 0.2, 0.3, 0.4 */
    for (int k = 0; k < 3; k++) {
        const cagd_fit_estimate e = cagd_fit_unknown_estimate(&result, k);
        assert_true(e.origin == 10 * (k + 1) && e.value == relative[3 + k] && near(e.error, 0.2 + 0.1 * k));
    }
    for (int k = 0; k < 6; k++) {
        memcpy(result.spacing, wide[k], sizeof wide[k]);
        assert_int_equal(cagd_fit_finest_unknown(&result, &spacing), finest[k]);
        assert_true(spacing == widest[k]);
    }
    covariance[0] = 0.25, covariance[4] = 0.16, covariance[8] = 0.01;
    memcpy(result.spacing, wide[0], sizeof wide[0]);
    result.spacing[0] = 0.75;
    assert_true(cagd_fit_finest_unknown(&result, &spacing) == 2 && spacing == 0.75);
    result.spacing[2] = cagd_fit_unknown_estimate(&result, 2).error; /* as wide as the error is no wider */
    assert_true(cagd_fit_finest_unknown(&result, &spacing) == 1 && spacing == 0.75);
}

/* The cubic with a cusp over the second of two spans, in the plane and in space, beside one that turns on a radius of 3/8 e^2, before it or behind it: the
 * sharpest turn is told, at its parameter. */
static void the_sharpest_turn_is_told(void **state)
{
    (void)state;
    static const double two[] = {2, 2, 2, 2, 3, 3, 3, 5, 5, 5, 5};
    for (int dim = 2; dim <= 3; dim++)
        for (int first = 0; first < 2; first++) {
            const double e = 0x1p-7;
            double P[21], t = -1;
            for (int k = 0; k < 7; k++) {
                const int second = k >= 3, m = second ? k - 3 : k;
                const double off = second == first ? e : 0; /* a smooth turn */
                double x = (m == 1 ? 1 - off : m == 2 ? off : m == 3) - !second, y = m == 1 || m == 2;
                P[k * dim] = x, P[k * dim + 1] = dim == 2 ? y : 0.6 * y;
                if (dim == 3)
                    P[k * dim + 2] = 0.8 * y;
            }
            cagd_fit_result r = {.curve = {3, 7, dim, two, P, NULL}, .rms = 1e-3};
            assert_true(cagd_fit_has_cusp(&r, &t));
            assert_true(fabs(t - (first ? 2.5 : 4)) < 1e-6);
            r.rms = 1e-9, t = -1;
            assert_true(cagd_fit_has_cusp(&r, &t) && fabs(t - (first ? 2.5 : 4)) < 1e-6);
        }
    double line[] = {0, 0, 1, 0, 2, 0, 3, 0}, t = -1;
    static const double one[] = {0, 0, 0, 0, 1, 1, 1, 1};
    cagd_fit_result r = {.curve = {3, 4, 2, one, line, NULL}, .rms = 100};
    assert_true(!cagd_fit_has_cusp(&r, &t) && t == -1); /* the speed is the same everywhere */
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
                                       cmocka_unit_test(which_curves_turn_as_at_a_cusp),
                                       cmocka_unit_test(probabilities_of_f),
                                       cmocka_unit_test(losses_are_what_they_are_called),
                                       cmocka_unit_test(equations_of_space_and_of_closed_curves),
                                       cmocka_unit_test(invariants_depend_on_three_weights),
                                       cmocka_unit_test(a_type_is_as_certain_as_its_interval),
                                       cmocka_unit_test(what_is_known_of_the_type),
                                       cmocka_unit_test(a_line_is_told_by_the_height_of_the_middle_point),
                                       cmocka_unit_test(intervals_are_as_they_were_found),
                                       cmocka_unit_test(the_finest_coordinate),
                                       cmocka_unit_test(the_sharpest_turn_is_told)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
