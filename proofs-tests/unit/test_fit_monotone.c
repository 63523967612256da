/* test_fit_monotone.c -- feet in the order of the points: against the least cost over all ordered parameters of a grid, found by
 * dynamic programming, which shares nothing with the fit; and what is said of the statistics. */
#include "core/fit/cagd_fit.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MOST = 60, GRID = 4000 };
static double Q[MOST * 3], sigma[MOST];
static uint32_t state_of_noise = 11;

static double noise(void)
{
    state_of_noise = state_of_noise * 1664525u + 1013904223u;
    return (double)(state_of_noise >> 8) / (1 << 23) - 1;
}

static const double U[] = {0, 0, 0, 0, 1, 1, 1, 1};
static const double plane[] = {0, 0, 3, 4, 7, -4, 10, 0}, space[] = {0, 0, 0, 3, 4, 2, 7, -4, 1, 10, 0, 3};

/* N points of a cubic with errors of `size`, the last three of every five known half as well as the others. */
static cagd_fit_data make_points(int N, int dim, double size, int known)
{
    const cagd_spline s = {3, 4, dim, U, dim == 2 ? plane : space, NULL};
    for (int i = 0; i < N; i++) {
        sigma[i] = i % 5 < 2 ? 1 : 2;
        assert_int_equal(cagd_spline_point(&s, (double)i / (N - 1), i < N - 1 ? CAGD_RIGHT : CAGD_LEFT, Q + i * dim),
                         CAGD_OK);
        for (int c = 0; c < dim; c++)
            Q[i * dim + c] += size * sigma[i] * noise();
    }
    return (cagd_fit_data){N, dim, Q, known ? sigma : NULL};
}

#define assert_near(a, b, error) assert_true(fabs((a) - (b)) <= (error))

static double weight_of(const cagd_fit_data *d, int i)
{
    return d->sigma != NULL ? 1 / (d->sigma[i] * d->sigma[i]) : 1;
}

/* Half the least sum of squares over t_0 <= ... <= t_N-1 of the grid; the first and the last one are held at the ends. */
static double least_in_order(const cagd_fit_data *d, const cagd_spline *s)
{
    static double C[(GRID + 1) * 3], best[GRID + 1];
    for (int g = 0; g <= GRID; g++)
        assert_int_equal(cagd_spline_point(s, (double)g / GRID, g < GRID ? CAGD_RIGHT : CAGD_LEFT, C + g * d->dim),
                         CAGD_OK);
    memset(best, 0, sizeof best);
    for (int i = 0; i < d->count; i++) {
        double least = HUGE_VAL;
        for (int g = 0; g <= GRID; g++) {
            double square = 0;
            for (int c = 0; c < d->dim; c++)
                square += pow(d->points[i * d->dim + c] - C[g * d->dim + c], 2);
            least = fmin(least, best[g]);
            const int held = (i == 0 && g > 0) || (i == d->count - 1 && g < GRID);
            best[g] = held ? HUGE_VAL : least + square * weight_of(d, i) / 2;
        }
    }
    double least = HUGE_VAL;
    for (int g = 0; g <= GRID; g++)
        least = fmin(least, best[g]);
    return least;
}

static cagd_fit_options options_in_order(void)
{
    cagd_fit_options o = cagd_fit_defaults();
    o.degree = 3;
    o.free = CAGD_FIT_INNER_POINTS | CAGD_FIT_END_POINTS;
    o.monotone = 1;
    return o;
}

static cagd_fit_result *fit(const cagd_fit_data *d, const cagd_fit_options *o)
{
    cagd_fit_result *r = NULL;
    assert_int_equal(cagd_fit(d, o, &r, NULL), CAGD_OK);
    assert_true(cagd_fit_is_minimum(r));
    return r;
}

/* Feet in order; residuals from them; and as many degrees of freedom as there are residuals less unknowns and different feet. */
static void check_result(const cagd_fit_data *d, const cagd_fit_result *r)
{
    int different = 1, at_ends = 0;
    double sum = 0;
    assert_int_equal(r->count, d->count);
    for (int i = 0; i < d->count; i++) {
        double C[3], square = 0;
        const double t = r->feet[i];
        assert_true(i == 0 || t >= r->feet[i - 1]);
        different += i > 0 && t > r->feet[i - 1];
        at_ends += i > 0 && t == r->feet[i - 1] && (t == 0 || t == 1);
        assert_int_equal(cagd_spline_point(&r->curve, t, t < 1 ? CAGD_RIGHT : CAGD_LEFT, C), CAGD_OK);
        for (int c = 0; c < d->dim; c++) {
            assert_near(r->residuals[i * d->dim + c], d->points[i * d->dim + c] - C[c], 1e-9);
            square += pow(r->residuals[i * d->dim + c], 2);
        }
        assert_near(fabs(r->distances[i]), sqrt(square), 1e-9);
        sum += square * weight_of(d, i);
    }
    /* feet that an end holds are equal, too, and may or may not be shared */
    assert_true(r->tied <= d->count - different && r->tied >= d->count - different - at_ends);
    assert_int_equal(r->out_of_order, 0);
    assert_near(r->chi_squared, sum, 1e-9 * sum);
    assert_near(r->cost, sum / 2, 1e-9 * sum);
    /* dim residuals a point; a foot for all that are not shared, but those at the ends are no unknowns */
    assert_int_equal(r->degrees_of_freedom, d->count * d->dim - (d->count - r->tied - 2) - r->rank);
}

static void the_cost_is_least_among_ordered_feet(void **state)
{
    (void)state;
    int shared = 0;
    for (int k = 0; k < 6; k++) {
        const int dim = k % 3 == 2 ? 3 : 2;
        const cagd_fit_data d = make_points(40 + k, dim, 0.1 + 0.1 * k, k % 2);
        const cagd_fit_options o = options_in_order();
        cagd_fit_result *r = fit(&d, &o);
        check_result(&d, r);
        shared += r->tied > 0;
        const double least = least_in_order(&d, &r->curve);
        /* no point of the curve is farther than 10/GRID from one of the grid */
        assert_true(r->cost <= least * (1 + 1e-12) && least <= r->cost * (1 + 1e-4));
        double *P = (double *)r->curve.points;
        for (int m = 0; m < 4 * dim; m++)
            for (int side = -1; side <= 1; side += 2) {
                const double was = P[m];
                P[m] += side * 0.02;
                assert_true(least_in_order(&d, &r->curve) > least);
                P[m] = was;
            }
        for (int q = 0; r->tied > 0 && q < r->unknowns; q++)
            assert_int_equal(r->interval_by[q], CAGD_FIT_INTERVAL_NOT_SOUGHT);
        cagd_fit_free(r);
    }
    assert_true(shared >= 4);
}

/* From a curve far off, on which the feet of many points fall back, pools have to be divided again. */
static void a_bad_start_does_not_matter(void **state)
{
    (void)state;
    static const double off[] = {0, 0, 12, 4, -3, -5, 10, 0};
    const cagd_spline start = {3, 4, 2, U, off, NULL};
    for (int k = 0; k < 4; k++) {
        const cagd_fit_data d = make_points(40 + k, 2, 0.1 + 0.1 * k, 0);
        cagd_fit_options o = options_in_order();
        cagd_fit_result *usual = fit(&d, &o);
        o.initial = &start;
        cagd_fit_result *r = fit(&d, &o);
        check_result(&d, r);
        const double least = least_in_order(&d, &r->curve);
        assert_true(r->cost <= least * (1 + 1e-12) && least <= r->cost * (1 + 1e-4));
        assert_near(r->cost, usual->cost, 1e-9 * usual->cost);
        cagd_fit_free(usual);
        cagd_fit_free(r);
    }
}

/* A parabola with measured ends through the means of as many feet as it has equations for, which alone have no degrees of freedom; the shared
 * foot gives two.  The covariance is that of the fit to the means, times what the points say of their deviation. */
static void feet_that_are_shared_give_degrees_of_freedom(void **state)
{
    (void)state;
    static const double P[] = {0, 0, 0.6, 0.5, 1.05, 0.62, 0.95, 0.55, 2, 0},
                        means[] = {0, 0, 0.6, 0.5, 1, 0.585, 2, 0};
    static const double of_means[] = {1, 1, 0.70710678118654752, 1};
    memcpy(Q, P, sizeof P);
    const cagd_fit_data d = {5, 2, Q, NULL}, pooled = {4, 2, means, of_means};
    cagd_fit_options o = options_in_order();
    o.degree = 2;
    cagd_fit_result *r = fit(&d, &o);
    check_result(&d, r);
    assert_int_equal(r->tied, 1);
    assert_int_equal(r->degrees_of_freedom, 2);
    assert_true(r->scale_squared > 0);
    o.monotone = 0;
    cagd_fit_result *of_pools = fit(&pooled, &o);
    assert_int_equal(of_pools->degrees_of_freedom, 0);
    assert_int_equal(r->unknowns, of_pools->unknowns);
    for (int k = 0; k < r->unknowns * r->unknowns; k++)
        assert_near(r->covariance[k], r->scale_squared * of_pools->covariance[k], 1e-9 * r->scale_squared);
    for (int k = 0; k < r->unknowns; k++)
        assert_true(cagd_fit_unknown_estimate(r, k).error > 0);
    cagd_fit_free(of_pools);
    cagd_fit_free(r);
}

/* Errors of a hundredth of the way between points put no foot out of order. */
static void points_in_order_have_the_fit_without(void **state)
{
    (void)state;
    const cagd_fit_data d = make_points(40, 2, 0.002, 0);
    cagd_fit_options o = options_in_order();
    cagd_fit_result *with = fit(&d, &o);
    o.monotone = 0;
    cagd_fit_result *without = fit(&d, &o);
    assert_int_equal(with->tied, 0);
    assert_int_equal(with->degrees_of_freedom, without->degrees_of_freedom);
    assert_near(with->cost, without->cost, 1e-12 * without->cost);
    for (int k = 0; k < with->unknowns; k++) {
        assert_near(with->value[k], without->value[k], 1e-7);
        assert_int_equal(with->interval_by[k], without->interval_by[k]);
    }
    cagd_fit_free(with);
    cagd_fit_free(without);
}

/* A circle whose points are noisy along it, from any of them on: each foot lies behind the one before, over the seam, too. */
static void closed_curves_have_a_seam(void **state)
{
    (void)state;
    enum { N = 48 };
    for (int from = 0; from < N; from += 11) {
        for (int i = 0; i < N; i++) {
            const double a = 2 * acos(-1) * (i + from + 1.2 * noise()) / N, rho = 5 + 0.05 * noise();
            Q[2 * i] = rho * cos(a), Q[2 * i + 1] = rho * sin(a);
        }
        const cagd_fit_data d = {N, 2, Q, NULL};
        cagd_fit_options o = options_in_order();
        o.closed = 1, o.count = 8;
        cagd_fit_result *r = fit(&d, &o);
        assert_true(r->tied > 0);
        for (int i = 1; i < N; i++)
            assert_true(remainder(r->feet[i - 1] - r->feet[i], 1) <= 0);
        cagd_fit_free(r);
    }
}

static void what_has_no_order_is_refused(void **state)
{
    (void)state;
    const cagd_fit_data d = make_points(20, 2, 0.1, 0);
    cagd_fit_result *r = NULL;
    cagd_fit_options o = options_in_order();
    o.unordered = 1;
    assert_int_equal(cagd_fit(&d, &o, &r, NULL), CAGD_BAD_OPTION);
    o = options_in_order();
    o.loss = CAGD_FIT_HUBER;
    assert_int_equal(cagd_fit(&d, &o, &r, NULL), CAGD_BAD_OPTION);
    o = options_in_order();
    o.monotone = 2;
    assert_int_equal(cagd_fit(&d, &o, &r, NULL), CAGD_BAD_OPTION);
    assert_null(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_cost_is_least_among_ordered_feet),         cmocka_unit_test(a_bad_start_does_not_matter),
        cmocka_unit_test(points_in_order_have_the_fit_without),         cmocka_unit_test(closed_curves_have_a_seam),
        cmocka_unit_test(feet_that_are_shared_give_degrees_of_freedom), cmocka_unit_test(what_has_no_order_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
