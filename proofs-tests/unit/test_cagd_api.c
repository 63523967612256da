/* test_cagd_api.c -- the public functions: what they compute is the kernels' values, what they refuse
 * is refused with the stated status and without writing. */
#include "core/api/cagd.h"
#include "core/kernels/kernels_d.h"

#include <float.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

/* A rational cubic of space with nothing special about it. */
static const double R[12] = {0.31, -1.27, 2.09, 1.83, 0.71, -0.55, 2.94, 3.37, 1.13, -0.62, 2.21, 4.48};
static const double w[4] = {1.21, 0.47, 3.08, 0.93};
enum { N = 3, DIM = 3 };
static const double T = 0.3779;

static void same(int count, const double a[], const double b[])
{
    assert_memory_equal(a, b, (size_t)count * sizeof a[0]);
}

static void values_are_the_kernels(void **state)
{
    double a[32], b[32], c[32], d[32], e[32], f[32], g[32], h[32];
    (void)state;
    assert_int_equal(cagd_bernstein(N, T, a), CAGD_OK);
    bernstein_basis_d(N, T, b);
    same(4, a, b);
    assert_int_equal(cagd_bezier_point(N, DIM, R, T, a), CAGD_OK);
    bezier_casteljau_d(N, DIM, R, T, b);
    same(3, a, b);
    assert_int_equal(cagd_bezier_derivatives(N, DIM, R, T, 5, a), CAGD_OK);
    bezier_derivatives_d(N, DIM, R, T, 5, b);
    same(18, a, b);
    assert_int_equal(cagd_bezier_split(N, DIM, R, T, a, c), CAGD_OK);
    bezier_split_d(N, DIM, R, T, b, d);
    same(12, a, b);
    same(12, c, d);
    assert_int_equal(cagd_bezier_elevate(N, DIM, R, a), CAGD_OK);
    bezier_elevate_d(N, DIM, R, b);
    same(15, a, b);
    assert_int_equal(cagd_rational_point(N, DIM, R, w, T, a), CAGD_OK);
    rational_point_d(N, DIM, R, w, T, b);
    same(3, a, b);
    assert_int_equal(cagd_rational_derivatives(N, DIM, R, w, T, 4, a), CAGD_OK);
    rational_derivatives_d(N, DIM, R, w, T, 4, b);
    same(15, a, b);
    assert_int_equal(cagd_rational_split(N, DIM, R, w, T, a, c, e, g), CAGD_OK);
    rational_split_d(N, DIM, R, w, T, b, d, f, h);
    same(12, a, b);
    same(4, c, d);
    same(12, e, f);
    same(4, g, h);
    assert_int_equal(cagd_rational_elevate(N, DIM, R, w, a, c), CAGD_OK);
    rational_elevate_d(N, DIM, R, w, b, d);
    same(15, a, b);
    same(5, c, d);
    assert_int_equal(cagd_rational_reparametrize(N, w, 1.7, 0.6, a), CAGD_OK);
    rational_reparametrize_d(N, w, 1.7, 0.6, b);
    same(4, a, b);
    assert_int_equal(cagd_rational_standard_form(N, w, a), CAGD_OK);
    rational_standard_form_d(N, w, b);
    same(4, a, b);
    assert_int_equal(cagd_rational_invariants(N, w, a), CAGD_OK);
    rational_invariants_d(N, w, b);
    same(2, a, b);
    assert_int_equal(cagd_conic_implicit(R, w, a), CAGD_OK);
    conic_of_bezier_d(R, w, b);
    same(6, a, b);
}

/* Scaling a curve by a power of two s changes no bit of its curvature but divides it by s, also where s^6
 * is not in range. */
static void curvature_has_no_range_of_its_own(void **state)
{
    (void)state;
    double unit, scaled, points[12];
    assert_int_equal(cagd_rational_curvature(N, DIM, R, w, T, &unit), CAGD_OK);
    assert_true(unit == sqrt(rational_curvature_squared_d(N, DIM, R, w, T)));
    for (int e = -500; e <= 500; e += 100) {
        for (int m = 0; m < 12; m++)
            points[m] = ldexp(R[m], e);
        assert_int_equal(cagd_rational_curvature(N, DIM, points, w, T, &scaled), CAGD_OK);
        assert_true(scaled == ldexp(unit, -e));
    }
}
/* First derivatives that are nearly parallel: d1 = (2, 0) and d2 = (2, 2 h); then d1 = 3 (1, 0, 0), d2 = 6 (1, h, 0) and
 * d3 = 6 (0, -3 h, z), with h = 2^-600, whose square binary64 does not have. */
static void nearly_parallel_derivatives(void **state)
{
    (void)state;
    const double h = 0x1p-600, plane[] = {0, 0, 1, 0, 3, h}, ones[] = {1, 1, 1, 1};
    double k, tau;
    assert_int_equal(cagd_rational_curvature(2, 2, plane, ones, 0, &k), CAGD_OK);
    assert_true(k == h / 2);
    for (double z = 1; z > h * h; z *= h) {
        const double space[] = {0, 0, 0, 1, 0, 0, 3, h, 0, 6, 0, z};
        assert_int_equal(cagd_rational_curvature(3, 3, space, ones, 0, &k), CAGD_OK);
        assert_true(fabs(k / (h * 2 / 3) - 1) < 1e-15);
        assert_int_equal(cagd_rational_torsion(3, space, ones, 0, &tau), CAGD_OK);
        assert_true(fabs(tau / (z / h / 3) - 1) < 1e-15);
    }
}

/* Derivatives (4,0,0), (0,12,0), (0,0,24) at t = 0: curvature 48/64 and torsion 24/48, without rounding. */
static void curvature_and_torsion_of_a_quartic(void **state)
{
    (void)state;
    const double points[15] = {0, 0, 0, 1, 0, 0, 2, 1, 0, 3, 3, 1, 4, 6, 4}, weights[5] = {1, 1, 1, 1, 1};
    double k, tau;
    assert_int_equal(cagd_rational_curvature(4, 3, points, weights, 0, &k), CAGD_OK);
    assert_int_equal(cagd_rational_torsion(4, points, weights, 0, &tau), CAGD_OK);
    assert_true(k == 0.75 && tau == 0.5);
}

/* Each refusal once for each kind of argument; the mark in `out` shows that nothing was written. */
static void bad_arguments_are_refused(void **state)
{
    (void)state;
    double out[256], spare[256], bad[12];
    for (int i = 0; i < 256; i++)
        out[i] = spare[i] = 77;

    assert_int_equal(cagd_bernstein(N, T, NULL), CAGD_NULL);
    assert_int_equal(cagd_bernstein(-1, T, out), CAGD_DEGREE);
    assert_int_equal(cagd_bernstein(CAGD_MAX_DEGREE + 1, T, out), CAGD_DEGREE);
    assert_int_equal(cagd_bernstein(N, NAN, out), CAGD_NOT_FINITE);
    assert_int_equal(cagd_bezier_point(N, DIM, NULL, T, out), CAGD_NULL);
    assert_int_equal(cagd_bezier_point(N, 0, R, T, out), CAGD_DIMENSION);
    assert_int_equal(cagd_bezier_point(N, CAGD_MAX_DIM + 1, R, T, out), CAGD_DIMENSION);
    assert_int_equal(cagd_bezier_point(-1, DIM, R, T, out), CAGD_DEGREE);
    assert_int_equal(cagd_bezier_derivatives(N, DIM, R, T, -1, out), CAGD_ORDER);
    assert_int_equal(cagd_bezier_derivatives(N, DIM, R, T, CAGD_MAX_DEGREE + 1, out), CAGD_ORDER);
    assert_int_equal(cagd_bezier_split(N, DIM, R, T, out, NULL), CAGD_NULL);
    assert_int_equal(cagd_bezier_split(N, DIM, R, INFINITY, out, spare), CAGD_NOT_FINITE);
    assert_int_equal(cagd_bezier_elevate(CAGD_MAX_DEGREE, DIM, R, out), CAGD_DEGREE);
    assert_int_equal(cagd_rational_point(N, DIM, R, NULL, T, out), CAGD_NULL);
    assert_int_equal(cagd_rational_derivatives(N, DIM, R, w, T, -1, out), CAGD_ORDER);
    assert_int_equal(cagd_rational_curvature(N, 1, R, w, T, out), CAGD_DIMENSION);
    assert_int_equal(cagd_rational_curvature(N, DIM, R, w, T, NULL), CAGD_NULL);
    assert_int_equal(cagd_rational_torsion(N, NULL, w, T, out), CAGD_NULL);
    assert_int_equal(cagd_rational_split(N, DIM, R, w, T, out, out + 64, out + 128, NULL), CAGD_NULL);
    assert_int_equal(cagd_rational_elevate(CAGD_MAX_DEGREE, DIM, R, w, out, spare), CAGD_DEGREE);
    assert_int_equal(cagd_rational_reparametrize(N, w, -1, 1, out), CAGD_SIGN);
    assert_int_equal(cagd_rational_reparametrize(N, w, 1, 0, out), CAGD_SIGN);
    assert_int_equal(cagd_rational_reparametrize(N, w, NAN, 1, out), CAGD_NOT_FINITE);
    assert_int_equal(cagd_rational_standard_form(0, w, out), CAGD_DEGREE);
    assert_int_equal(cagd_rational_standard_form(2, (double[]){1, 1, -1}, out), CAGD_SIGN);
    assert_int_equal(cagd_rational_standard_form(2, (double[]){0, 1, 1}, out), CAGD_SIGN);
    assert_int_equal(cagd_rational_standard_form(2, (double[]){1, 1, 0}, out), CAGD_SIGN);
    assert_int_equal(cagd_rational_standard_form(2, (double[]){0, -1, -1}, out), CAGD_SIGN);
    assert_int_equal(cagd_rational_standard_form(2, (double[]){-1, -1, 0}, out), CAGD_SIGN);
    assert_int_equal(cagd_rational_invariants(1, w, out), CAGD_DEGREE);
    assert_int_equal(cagd_rational_invariants(2, (double[]){0, 1, 1}, out), CAGD_UNDEFINED);
    assert_int_equal(cagd_rational_invariants(2, (double[]){1, 1, 0}, out), CAGD_UNDEFINED);
    assert_int_equal(cagd_rational_invariants(2, (double[]){1, 0, 1}, out), CAGD_OK);
    assert_true(out[0] == 0);
    for (int zero = 0; zero <= 3; zero++) { /* in degree 3 each is in a denominator */
        double one_is_zero[4] = {1, 2, 3, 4};
        one_is_zero[zero] = 0;
        assert_int_equal(cagd_rational_invariants(3, one_is_zero, out), CAGD_UNDEFINED);
    }
    assert_int_equal(cagd_conic_implicit(NULL, w, out), CAGD_NULL);
    for (int i = 0; i < 12; i++) {
        memcpy(bad, R, sizeof bad);
        bad[i] = i % 2 == 0 ? NAN : -INFINITY;
        assert_int_equal(cagd_bezier_point(N, DIM, bad, T, out), CAGD_NOT_FINITE);
        assert_int_equal(cagd_rational_point(N, DIM, bad, w, T, out), CAGD_NOT_FINITE);
        assert_int_equal(cagd_rational_point(N, DIM, R, bad, T, out), i < 4 ? CAGD_NOT_FINITE : CAGD_OK);
        out[0] = out[1] = out[2] = 77;
    }
    same(256, out, spare);
}

/* Of curves in the plane, in space and on the line every number of the points is asked for, and none behind them. */
static void every_coordinate_is_asked_for(void **state)
{
    (void)state;
    static const struct {
        int degree, dim;
    } list[] = {{3, 2}, {1, 3}, {2, 1}};
    double bad[16], out[4];
    for (int k = 0; k < 3; k++)
        for (int i = 0; i <= (list[k].degree + 1) * list[k].dim; i++) {
            memcpy(bad, R, sizeof R);
            bad[i] = NAN;
            cagd_status expected = i < (list[k].degree + 1) * list[k].dim ? CAGD_NOT_FINITE : CAGD_OK;
            assert_int_equal(cagd_bezier_point(list[k].degree, list[k].dim, bad, T, out), expected);
            assert_int_equal(cagd_rational_point(list[k].degree, list[k].dim, bad, w, T, out), expected);
        }
}

static double *no_numbers(double x[16])
{
    for (int i = 0; i < 16; i++)
        x[i] = NAN;
    return x;
}
/* Nothing is written behind a result, and nothing behind it counts. */
static void nothing_behind_a_result_counts(void **state)
{
    (void)state;
    double a[16], b[16], c[16], d[16];
    assert_int_equal(cagd_bernstein(N, T, no_numbers(a)), CAGD_OK);
    assert_true(isfinite(a[3]) && isnan(a[4]));
    assert_int_equal(cagd_bezier_point(N, 2, R, T, no_numbers(a)), CAGD_OK);
    assert_true(isfinite(a[1]) && isnan(a[2]));
    assert_int_equal(cagd_bezier_derivatives(N, 2, R, T, 2, no_numbers(a)), CAGD_OK);
    assert_true(isfinite(a[5]) && isnan(a[6]));
    assert_int_equal(cagd_bezier_split(N, 2, R, T, no_numbers(a), no_numbers(b)), CAGD_OK);
    assert_true(isfinite(a[7]) && isnan(a[8]) && isfinite(b[7]) && isnan(b[8]));
    assert_int_equal(cagd_bezier_elevate(N, 2, R, no_numbers(a)), CAGD_OK);
    assert_true(isfinite(a[9]) && isnan(a[10]));
    assert_int_equal(cagd_rational_derivatives(N, 2, R, w, T, 2, no_numbers(a)), CAGD_OK);
    assert_true(isfinite(a[5]) && isnan(a[6]));
    assert_int_equal(cagd_rational_split(N, 2, R, w, T, no_numbers(a), no_numbers(b), no_numbers(c), no_numbers(d)),
                     CAGD_OK);
    assert_true(isfinite(a[7]) && isnan(a[8]) && isfinite(b[3]) && isnan(b[4]));
    assert_true(isfinite(c[7]) && isnan(c[8]) && isfinite(d[3]) && isnan(d[4]));
    assert_int_equal(cagd_rational_elevate(N, 2, R, w, no_numbers(a), no_numbers(b)), CAGD_OK);
    assert_true(isfinite(a[9]) && isnan(a[10]) && isfinite(b[4]) && isnan(b[5]));
    assert_int_equal(cagd_rational_reparametrize(N, w, 1.7, 0.6, no_numbers(a)), CAGD_OK);
    assert_true(isfinite(a[3]) && isnan(a[4]));
    assert_int_equal(cagd_rational_standard_form(N, w, no_numbers(a)), CAGD_OK);
    assert_true(isfinite(a[3]) && isnan(a[4]));
    assert_int_equal(cagd_rational_invariants(N, w, no_numbers(a)), CAGD_OK);
    assert_true(isfinite(a[1]) && isnan(a[2]));
    assert_int_equal(cagd_conic_implicit(R, w, no_numbers(a)), CAGD_OK);
    assert_true(isfinite(a[5]) && isnan(a[6]));
}

/* Weights that are all negative have the standard form of those that are positive. */
static void weights_below_zero_have_a_standard_form(void **state)
{
    (void)state;
    double above[3], below[3];
    assert_int_equal(cagd_rational_standard_form(2, (double[]){4, 3, 1}, above), CAGD_OK);
    assert_int_equal(cagd_rational_standard_form(2, (double[]){-4, -3, -1}, below), CAGD_OK);
    same(3, above, below);
    assert_true(above[0] == 1 && above[1] == 1.5 && above[2] == 1);
}

static void what_has_no_value_is_undefined(void **state)
{
    (void)state;
    const double cancel[2] = {1, -1}, still[6] = {2, 3, 2, 3, 2, 3}, ones[3] = {1, 1, 1};
    double out[64], a[8], b[8], c[8];
    assert_int_equal(cagd_rational_point(1, 2, R, cancel, 0.5, out), CAGD_UNDEFINED);
    assert_int_equal(cagd_rational_point(1, 2, R, cancel, 0.25, out), CAGD_OK);
    assert_int_equal(cagd_rational_split(1, 2, R, cancel, 0.5, out, a, b, c), CAGD_UNDEFINED);
    assert_int_equal(cagd_rational_elevate(1, 2, R, cancel, out, a), CAGD_UNDEFINED);
    assert_int_equal(cagd_rational_curvature(2, 2, still, ones, T, out), CAGD_UNDEFINED);
    assert_int_equal(cagd_rational_torsion(1, R, ones, T, out), CAGD_UNDEFINED);
}
static void what_leaves_binary64_is_out_of_range(void **state)
{
    (void)state;
    const double huge[4] = {DBL_MAX, -DBL_MAX, -DBL_MAX, DBL_MAX}, far[3] = {0x1p-600, 1, 0x1p600};
    double out[CAGD_MAX_DEGREE + 1];
    assert_int_equal(cagd_bezier_derivatives(1, 2, huge, T, 1, out), CAGD_OVERFLOW);
    assert_int_equal(cagd_rational_standard_form(2, far, out), CAGD_OVERFLOW);
    assert_int_equal(cagd_rational_reparametrize(2, far, 0x1p-600, 1, out), CAGD_OVERFLOW);
    assert_int_equal(cagd_bernstein(CAGD_MAX_DEGREE, 1e300, out), CAGD_OVERFLOW);
}

/* Each weight, and each coordinate, is in range or not by itself, whichever it is. */
static void whichever_number_leaves_the_range_is_seen(void **state)
{
    (void)state;
    enum { LAST = (N + 1) * DIM - 1 };
    double out[16], spare[16], a[8], b[8], ones[] = {1, 1, 1, 1};
    for (int i = 0; i <= N; i++) {
        double small[] = {1, 1, 1, 1}, large[] = {1, 1, 1, 1};
        small[i] = 0x1p-600, large[i] = 0x1p600;
        assert_int_equal(cagd_rational_reparametrize(N, small, 0x1p-200, 0x1p-200, out), CAGD_OVERFLOW);
        assert_int_equal(cagd_rational_reparametrize(N, large, 0x1p200, 0x1p200, out), CAGD_OVERFLOW);
        small[i] = 0; /* stays 0, of which nothing is lost */
        assert_int_equal(cagd_rational_reparametrize(N, small, 0x1p-200, 0x1p-200, out), CAGD_OK);
        assert_true(out[i] == 0);
    }
    /* At t = 2 the last coordinate of the left part alone; at t = -1 the first of the right part. */
    double points[LAST + 1] = {0};
    points[LAST] = DBL_MAX;
    assert_int_equal(cagd_bezier_point(N, DIM, points, 2, out), CAGD_OVERFLOW);
    assert_int_equal(cagd_bezier_split(N, DIM, points, 2, out, spare), CAGD_OVERFLOW);
    assert_int_equal(cagd_rational_split(N, DIM, points, ones, 2, out, a, spare, b), CAGD_OVERFLOW);
    points[LAST] = 0, points[0] = DBL_MAX;
    assert_int_equal(cagd_bezier_split(N, DIM, points, -1, out, spare), CAGD_OVERFLOW);
    assert_int_equal(cagd_rational_split(N, DIM, points, ones, -1, out, a, spare, b), CAGD_OVERFLOW);
    /* Elevation has a weight that is nearly 0, and there the last coordinate alone. */
    const double nearly[] = {1, 1, 1, -3 * (1 - 0x1p-50)};
    double last[LAST + 1] = {0};
    last[LAST] = 0x1p900;
    assert_int_equal(cagd_rational_elevate(N, DIM, last, nearly, out, a), CAGD_OK);
    last[LAST] = 0x1p1000;
    assert_int_equal(cagd_rational_elevate(N, DIM, last, nearly, out, a), CAGD_OVERFLOW);
    /* Of degree 0 the last point is the only one. */
    const double far[] = {0x1p600}, heavy[] = {0x1p600};
    assert_int_equal(cagd_rational_split(0, 1, far, heavy, 0.5, out, a, spare, b), CAGD_OVERFLOW);
    /* The last weight of the left part alone, whose points are 0. */
    const double zero[] = {0, 0}, opposite[] = {DBL_MAX, -DBL_MAX};
    assert_int_equal(cagd_rational_split(1, 1, zero, opposite, 2, out, a, spare, b), CAGD_OVERFLOW);
}

static cagd_conic_type type_of(double a, double b, double c)
{
    cagd_conic_type by_form, by_weights;
    const double S[6] = {a, b, c, 0.3, 0.7, -1.1}, weights[3] = {a, b, c};
    assert_int_equal(cagd_conic_classify(S, &by_form), CAGD_OK);
    if (a != 0 && b != 0 && c != 0) {
        assert_int_equal(cagd_conic_classify_weights(weights, &by_weights), CAGD_OK);
        assert_int_equal(by_weights, by_form);
    }
    return by_form;
}
/* Signs that the rounded AC - B^2 does not show: neighbours of parabolas, and products out of range. */
static void conic_types_are_exact(void **state)
{
    (void)state;
    double b = 1 + 0x1p-30, up = nextafter(b * b, 2), down = nextafter(b * b, 0);
    assert_int_equal(type_of(b, b, b), CAGD_PARABOLA);
    assert_int_equal(type_of(1, b, b * b), CAGD_HYPERBOLA); /* b * b is rounded down */
    assert_int_equal(type_of(1, b, up), CAGD_ELLIPSE);
    assert_int_equal(type_of(1, b, down), CAGD_HYPERBOLA);
    assert_int_equal(type_of(0x1p-1000, 0x1p-1000, 0x1p-1000), CAGD_PARABOLA);
    assert_int_equal(type_of(0x1p-1000, 0x1p-1000, nextafter(0x1p-1000, 1)), CAGD_ELLIPSE);
    assert_int_equal(type_of(0x1p1000, 0x1p1000, nextafter(0x1p1000, 1)), CAGD_HYPERBOLA);
    assert_int_equal(type_of(0x1p1000, 1, 0x1p-1000), CAGD_PARABOLA);
    assert_int_equal(type_of(0x1p-1074, 0x1p-1074, 0x1p-1074), CAGD_PARABOLA);
    for (int e = -1001; e <= 1001; e += 1001) /* a and c whose exponents differ by an odd number */
        for (int k = 0; k < 2; k++) {
            double a = ldexp(1, e), s = ldexp(1.5, e), c = ldexp(2.25, e);
            assert_int_equal(k ? type_of(c, s, a) : type_of(a, s, c), CAGD_PARABOLA);
            assert_int_equal(k ? type_of(nextafter(c, 0), s, a) : type_of(a, s, nextafter(c, 0)), CAGD_HYPERBOLA);
            assert_int_equal(k ? type_of(nextafter(c, DBL_MAX), s, a) : type_of(a, s, nextafter(c, DBL_MAX)),
                             CAGD_ELLIPSE);
        }
    assert_int_equal(type_of(1, 0x1p-1074, 1), CAGD_ELLIPSE);
    assert_int_equal(type_of(1, DBL_MAX, 1), CAGD_HYPERBOLA);
    assert_int_equal(type_of(-2, 0.5, -3), CAGD_ELLIPSE);
    assert_int_equal(type_of(2, 0.5, -3), CAGD_HYPERBOLA);
    assert_int_equal(type_of(0, 0x1p-600, 5), CAGD_HYPERBOLA);
    assert_int_equal(type_of(0, 0, 5), CAGD_PARABOLA);

    cagd_conic_type type;
    assert_int_equal(cagd_conic_classify((double[]){0, 0, 0, 1, 2, 3}, &type), CAGD_UNDEFINED);
    assert_int_equal(cagd_conic_classify((double[]){1, 2, 3, NAN, 2, 3}, &type), CAGD_NOT_FINITE);
    assert_int_equal(cagd_conic_classify_weights((double[]){1, 0, 1}, &type), CAGD_SIGN);
    assert_int_equal(cagd_conic_classify_weights(NULL, &type), CAGD_NULL);
}

static void every_status_has_its_own_text(void **state)
{
    (void)state;
    for (int s = CAGD_OK; s <= CAGD_STATUSES; s++)
        for (int r = CAGD_OK; r <= CAGD_STATUSES; r++)
            assert_int_equal(r == s, strcmp(cagd_status_text((cagd_status)s), cagd_status_text((cagd_status)r)) == 0);
}

static void the_header_has_the_version_of_the_library(void **state)
{
    char version[32];
    (void)state;
    snprintf(version, sizeof version, "%d.%d.%d", CAGD_VERSION_MAJOR, CAGD_VERSION_MINOR, CAGD_VERSION_PATCH);
    assert_string_equal(version, cagd_version());
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_are_the_kernels),
        cmocka_unit_test(curvature_has_no_range_of_its_own),
        cmocka_unit_test(nearly_parallel_derivatives),
        cmocka_unit_test(curvature_and_torsion_of_a_quartic),
        cmocka_unit_test(bad_arguments_are_refused),
        cmocka_unit_test(every_coordinate_is_asked_for),
        cmocka_unit_test(nothing_behind_a_result_counts),
        cmocka_unit_test(what_has_no_value_is_undefined),
        cmocka_unit_test(weights_below_zero_have_a_standard_form),
        cmocka_unit_test(what_leaves_binary64_is_out_of_range),
        cmocka_unit_test(whichever_number_leaves_the_range_is_seen),
        cmocka_unit_test(conic_types_are_exact),
        cmocka_unit_test(every_status_has_its_own_text),
        cmocka_unit_test(the_header_has_the_version_of_the_library),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
