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

/* The quartic with derivatives (4,0,0), (0,12,0), (0,0,24) at t = 0, its axes renamed: curvature 3/4 whichever they are, and the torsion
 * -1/2 where right and left are exchanged; the plane of the first two axes, turning right, has the same curvature.  Of points times 2^e
 * the first two derivatives go with any powers, and where the quotient leaves binary64 that is told. */
static void curvature_and_torsion_in_every_direction(void **state)
{
    (void)state;
    const double points[15] = {0, 0, 0, 1, 0, 0, 2, 1, 0, 3, 3, 1, 4, 6, 4}, ones[5] = {1, 1, 1, 1, 1};
    const int axes[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
    double k, tau, turned[15];
    for (int a = 0; a < 6; a++)
        for (int mirrored = 0; mirrored < 2; mirrored++) {
            for (int m = 0; m < 15; m++)
                turned[m / 3 * 3 + axes[a][m % 3]] = mirrored && m % 3 == 1 ? -points[m] : points[m];
            assert_int_equal(cagd_rational_curvature(4, 3, turned, ones, 0, &k), CAGD_OK);
            assert_int_equal(cagd_rational_torsion(4, turned, ones, 0, &tau), CAGD_OK);
            assert_true(k == 0.75 && tau == ((a < 3) == !mirrored ? 0.5 : -0.5));
        }
    for (int a = 0; a < 4; a++) { /* to the left and to the right, along either axis */
        const double flat[6] = {0, 0, a % 2, 1 - a % 2, a % 2 ? 1.5 : a - 1, a % 2 ? a - 2 : 1.5};
        assert_int_equal(cagd_rational_curvature(2, 2, flat, ones, 0, &k), CAGD_OK);
        assert_true(k == 0.5);
    }
    /* d1 = 2 (x, 0, 0), d2 = 2 (-2x, y, 0): curvature y/(2 x^2); d3 = 6 (x, -y, z): torsion of the cubic z/(...) by the powers alone */
    for (int e = -400; e <= 400; e += 100)
        for (int f = -400; f <= 400; f += 100) {
            const double x = ldexp(1, e), y = ldexp(1, f), flat[6] = {0, 0, x, 0, 0, y};
            int power = f - 2 * e - 1;
            cagd_status status = cagd_rational_curvature(2, 2, flat, ones, 0, &k);
            assert_int_equal(status, power > 1023 ? CAGD_OVERFLOW : CAGD_OK);
            if (power <= 1023)
                assert_true(k == ldexp(1, power));
            /* d1 = 3 (x,0,0), d2 = 6 (0,x,0), d3 = 6 (0,0,y): torsion 18 x^2 6 y/(18 x^2)^2 = y/(3 x^2) */
            const double cubic[12] = {0, 0, 0, x, 0, 0, 2 * x, x, 0, 3 * x, 3 * x, y};
            status = cagd_rational_torsion(3, cubic, ones, 0, &tau);
            power = f - 2 * e - 1;
            assert_int_equal(status, power > 1024 ? CAGD_OVERFLOW : CAGD_OK);
            if (power <= 1024 && power > -1020)
                assert_true(fabs(ldexp(tau, -power) - 2.0 / 3) < 1e-15);
        }
}

/* What has curvature or torsion has them where derivatives of lower order are 0 in one coordinate, and a point, a line and a plane curve have none. */
static void curvature_and_torsion_that_are_none(void **state)
{
    (void)state;
    const double ones[4] = {1, 1, 1, 1}, line[12] = {1, 2, 3, 2, 4, 6, 3, 6, 9, 4, 8, 12},
                 flat[12] = {0, 0, 5, 1, 0, 5, 2, 1, 5, 3, 3, 5};
    double out = 77;
    for (int dim = 2; dim <= 3; dim++)
        assert_int_equal(cagd_rational_curvature(0, dim, line, ones, T, &out), CAGD_UNDEFINED);
    assert_int_equal(cagd_rational_torsion(3, line, ones, 0, &out), CAGD_UNDEFINED);
    assert_int_equal(cagd_rational_torsion(1, line, ones, 0, &out), CAGD_UNDEFINED);
    assert_int_equal(cagd_rational_torsion(0, line, ones, 0, &out), CAGD_UNDEFINED);
    assert_int_equal(cagd_rational_curvature(3, 3, line, ones, 0, &out), CAGD_OK);
    assert_true(out == 0);
    assert_int_equal(cagd_rational_torsion(3, flat, ones, 0, &out), CAGD_OK);
    assert_true(out == 0);
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
    const double not_above[] = {0, -0.0, -0x1p-1074, -1, -DBL_MAX};
    for (int i = 0; i < 5; i++) {
        assert_int_equal(cagd_rational_reparametrize(N, w, not_above[i], 1, out), CAGD_SIGN);
        assert_int_equal(cagd_rational_reparametrize(N, w, 1, not_above[i], out), CAGD_SIGN);
        assert_int_equal(cagd_rational_reparametrize(N, w, not_above[i], not_above[i], out), CAGD_SIGN);
    }
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
    /* Of a conic whose coordinates grow by s the six numbers grow by s^2, s^3 and s^4: the last is the first that leaves the range. */
    const double triangle[] = {1, 2, 3, 5, 7, 4};
    for (int e = 200; e <= 600; e += 20) {
        double large[6], conic[6];
        for (int m = 0; m < 6; m++)
            large[m] = ldexp(triangle[m], e);
        assert_int_equal(cagd_conic_implicit(large, ones, conic), e < 260 ? CAGD_OK : CAGD_OVERFLOW);
        assert_true(e < 260 ? isfinite(conic[5]) : !isfinite(conic[5]));
        if (e <= 320)
            assert_true(isfinite(conic[3]) && isfinite(conic[4]));
    }
    /* Of degree 0 the last point is the only one. */
    const double far[] = {0x1p600}, heavy[] = {0x1p600};
    assert_int_equal(cagd_rational_split(0, 1, far, heavy, 0.5, out, a, spare, b), CAGD_OVERFLOW);
    /* The last weight of the left part alone, whose points are 0. */
    const double zero[] = {0, 0}, opposite[] = {DBL_MAX, -DBL_MAX};
    assert_int_equal(cagd_rational_split(1, 1, zero, opposite, 2, out, a, spare, b), CAGD_OVERFLOW);
}

/* ---- every function by one table ---------------------------------------------------------------------- */

/* The arguments of all functions, of which each takes its own. */
struct arguments {
    int degree, dim, order;
    double t, a, b;
    const double *points, *weights;
    double *out[4];
};
typedef const struct arguments *A;
enum { LONGEST = (CAGD_MAX_DEGREE + 2) * CAGD_MAX_DIM };

/* For every function the same three: what the library says, what the kernel computes, and how many numbers are in each result. */
static cagd_status bernstein(A x) { return cagd_bernstein(x->degree, x->t, x->out[0]); }
static void bernstein_by_kernel(A x) { bernstein_basis_d(x->degree, x->t, x->out[0]); }
static cagd_status point(A x) { return cagd_bezier_point(x->degree, x->dim, x->points, x->t, x->out[0]); }
static void point_by_kernel(A x) { bezier_casteljau_d(x->degree, x->dim, x->points, x->t, x->out[0]); }
static cagd_status derivatives(A x)
{
    return cagd_bezier_derivatives(x->degree, x->dim, x->points, x->t, x->order, x->out[0]);
}
static void derivatives_by_kernel(A x)
{
    bezier_derivatives_d(x->degree, x->dim, x->points, x->t, x->order, x->out[0]);
}
static cagd_status split(A x) { return cagd_bezier_split(x->degree, x->dim, x->points, x->t, x->out[0], x->out[1]); }
static void split_by_kernel(A x) { bezier_split_d(x->degree, x->dim, x->points, x->t, x->out[0], x->out[1]); }
static cagd_status elevate(A x) { return cagd_bezier_elevate(x->degree, x->dim, x->points, x->out[0]); }
static void elevate_by_kernel(A x) { bezier_elevate_d(x->degree, x->dim, x->points, x->out[0]); }
static cagd_status rational_point(A x)
{
    return cagd_rational_point(x->degree, x->dim, x->points, x->weights, x->t, x->out[0]);
}
static void rational_point_by_kernel(A x)
{
    rational_point_d(x->degree, x->dim, x->points, x->weights, x->t, x->out[0]);
}
static cagd_status rational_derivatives(A x)
{
    return cagd_rational_derivatives(x->degree, x->dim, x->points, x->weights, x->t, x->order, x->out[0]);
}
static void rational_derivatives_by_kernel(A x)
{
    rational_derivatives_d(x->degree, x->dim, x->points, x->weights, x->t, x->order, x->out[0]);
}
static cagd_status rational_split(A x)
{
    return cagd_rational_split(x->degree, x->dim, x->points, x->weights, x->t, x->out[0], x->out[1], x->out[2],
                               x->out[3]);
}
static void rational_split_by_kernel(A x)
{
    rational_split_d(x->degree, x->dim, x->points, x->weights, x->t, x->out[0], x->out[1], x->out[2], x->out[3]);
}
static cagd_status rational_elevate(A x)
{
    return cagd_rational_elevate(x->degree, x->dim, x->points, x->weights, x->out[0], x->out[1]);
}
static void rational_elevate_by_kernel(A x)
{
    rational_elevate_d(x->degree, x->dim, x->points, x->weights, x->out[0], x->out[1]);
}
static cagd_status reparametrize(A x)
{
    return cagd_rational_reparametrize(x->degree, x->weights, x->a, x->b, x->out[0]);
}
static void reparametrize_by_kernel(A x) { rational_reparametrize_d(x->degree, x->weights, x->a, x->b, x->out[0]); }
static cagd_status standard_form(A x) { return cagd_rational_standard_form(x->degree, x->weights, x->out[0]); }
static void standard_form_by_kernel(A x) { rational_standard_form_d(x->degree, x->weights, x->out[0]); }
static cagd_status invariants(A x) { return cagd_rational_invariants(x->degree, x->weights, x->out[0]); }
static void invariants_by_kernel(A x) { rational_invariants_d(x->degree, x->weights, x->out[0]); }
static cagd_status implicit(A x) { return cagd_conic_implicit(x->points, x->weights, x->out[0]); }
static void implicit_by_kernel(A x) { conic_of_bezier_d(x->points, x->weights, x->out[0]); }
static cagd_status curvature(A x)
{
    return cagd_rational_curvature(x->degree, x->dim, x->points, x->weights, x->t, x->out[0]);
}
static cagd_status torsion(A x) { return cagd_rational_torsion(x->degree, x->points, x->weights, x->t, x->out[0]); }
static cagd_status classify(A x)
{
    cagd_conic_type type = CAGD_HYPERBOLA, *to = x->out[0] == NULL ? NULL : &type;
    cagd_status status = cagd_conic_classify(x->points, to);
    if (status == CAGD_OK)
        x->out[0][0] = type;
    else
        assert_int_equal(type, CAGD_HYPERBOLA);
    return status;
}
static cagd_status classify_weights(A x)
{
    cagd_conic_type type = CAGD_HYPERBOLA, *to = x->out[0] == NULL ? NULL : &type;
    cagd_status status = cagd_conic_classify_weights(x->weights, to);
    if (status == CAGD_OK)
        x->out[0][0] = type;
    else
        assert_int_equal(type, CAGD_HYPERBOLA);
    return status;
}

enum length { NO, ONE, DIMENSION, ROWS, ORDERS, HIGHER_ORDERS, INNER, POINTS, HIGHER_POINTS, SIX };
static int numbers_in(enum length length, A x)
{
    switch (length) {
    case NO:
        return 0;
    case ONE:
        return 1;
    case DIMENSION:
        return x->dim;
    case ROWS:
        return (x->order + 1) * x->dim;
    case ORDERS:
        return x->degree + 1;
    case HIGHER_ORDERS:
        return x->degree + 2;
    case INNER:
        return x->degree - 1;
    case POINTS:
        return (x->degree + 1) * x->dim;
    case HIGHER_POINTS:
        return (x->degree + 2) * x->dim;
    case SIX:
        return 6;
    }
    return 0;
}

/* What a function takes beside: T the parameter, O an order, P points, W weights, R the two numbers of a reparametrization.  A
 * dimension of which there is only one, and a degree, are no arguments. */
static const struct {
    cagd_status (*run)(A);
    void (*kernel)(A);
    int lowest, highest, from_dim, to_dim;
    const char *takes;
    enum length results[4];
} functions[] = {
    {bernstein, bernstein_by_kernel, 0, CAGD_MAX_DEGREE, 1, 1, "T", {ORDERS}},
    {point, point_by_kernel, 0, CAGD_MAX_DEGREE, 1, 3, "TP", {DIMENSION}},
    {derivatives, derivatives_by_kernel, 0, CAGD_MAX_DEGREE, 1, 3, "TPO", {ROWS}},
    {split, split_by_kernel, 0, CAGD_MAX_DEGREE, 1, 3, "TP", {POINTS, POINTS}},
    {elevate, elevate_by_kernel, 0, CAGD_MAX_DEGREE - 1, 1, 3, "P", {HIGHER_POINTS}},
    {rational_point, rational_point_by_kernel, 0, CAGD_MAX_DEGREE, 1, 3, "TPW", {DIMENSION}},
    {rational_derivatives, rational_derivatives_by_kernel, 0, CAGD_MAX_DEGREE, 1, 3, "TPWO", {ROWS}},
    {rational_split, rational_split_by_kernel, 0, CAGD_MAX_DEGREE, 1, 3, "TPW", {POINTS, ORDERS, POINTS, ORDERS}},
    {rational_elevate, rational_elevate_by_kernel, 0, CAGD_MAX_DEGREE - 1, 1, 3, "PW", {HIGHER_POINTS, HIGHER_ORDERS}},
    {reparametrize, reparametrize_by_kernel, 0, CAGD_MAX_DEGREE, 1, 1, "WR", {ORDERS}},
    {standard_form, standard_form_by_kernel, 1, CAGD_MAX_DEGREE, 1, 1, "W", {ORDERS}},
    {invariants, invariants_by_kernel, 2, CAGD_MAX_DEGREE, 1, 1, "W", {INNER}},
    {implicit, implicit_by_kernel, 2, 2, 2, 2, "PW", {SIX}},
    {curvature, NULL, 2, CAGD_MAX_DEGREE, 2, 3, "TPW", {ONE}},
    {torsion, NULL, 3, CAGD_MAX_DEGREE, 3, 3, "TPW", {ONE}},
    {classify, NULL, 2, 2, 2, 2, "P", {ONE}},
    {classify_weights, NULL, 2, 2, 2, 2, "W", {ONE}},
};
enum { FUNCTIONS = sizeof functions / sizeof functions[0] };

static int takes(int k, char what) { return strchr(functions[k].takes, what) != NULL; }

/* The next of a sequence of numbers in [0, 1). */
static double uniform(void)
{
    static unsigned long long x = 40507;
    x = x * 6364136223846793005u + 1442695040888963407u;
    return (double)(x >> 11) * 0x1p-53;
}

static double some_points[LONGEST + 1], some_weights[CAGD_MAX_DEGREE + 2], results[4][2 * LONGEST],
    expected[4][2 * LONGEST];
static void mark(double x[4][2 * LONGEST])
{
    for (int r = 0; r < 4; r++)
        for (int m = 0; m < 2 * LONGEST; m++)
            x[r][m] = 77;
}
static struct arguments good(int degree, int dim, double into[4][2 * LONGEST])
{
    for (int m = 0; m <= LONGEST; m++)
        some_points[m] = 10 * uniform() - 4;
    for (int i = 0; i < CAGD_MAX_DEGREE + 2; i++)
        some_weights[i] = 0.3 + uniform();
    return (struct arguments){
        degree, dim, 3, T, 1.1, 0.9, some_points, some_weights, {into[0], into[1], into[2], into[3]}};
}
static void nothing_is_written(void)
{
    for (int r = 0; r < 4; r++)
        for (int m = 0; m < 2 * LONGEST; m++)
            assert_true(results[r][m] == 77);
}

/* In every degree and dimension, and to every order, the numbers are the kernel's, as many as the header says and no more. */
static void every_degree_and_dimension_has_the_kernels_values(void **state)
{
    (void)state;
    for (int k = 0; k < FUNCTIONS; k++)
        for (int degree = functions[k].lowest; degree <= functions[k].highest; degree += degree < 6 ? 1 : 29)
            for (int dim = functions[k].from_dim; dim <= functions[k].to_dim; dim++)
                for (int order = takes(k, 'O') ? 0 : 3; order <= 3 || (takes(k, 'O') && order <= CAGD_MAX_DEGREE);
                     order += order < 7 ? 1 : 57) {
                    struct arguments x = good(degree, dim, results), y = x;
                    for (int r = 0; r < 4; r++)
                        y.out[r] = expected[r];
                    mark(results);
                    mark(expected);
                    x.order = y.order = order;
                    assert_int_equal(functions[k].run(&x), CAGD_OK);
                    for (int r = 0; r < 4; r++) {
                        int length = numbers_in(functions[k].results[r], &x);
                        for (int m = 0; m < 2 * LONGEST; m++)
                            assert_int_equal(results[r][m] != 77, m < length);
                    }
                    if (functions[k].kernel == NULL)
                        continue;
                    functions[k].kernel(&y);
                    same(4 * 2 * LONGEST, results[0], expected[0]);
                }
}

static void no_pointer_may_be_missing(void **state)
{
    (void)state;
    for (int k = 0; k < FUNCTIONS; k++) {
        const struct arguments x = good(3 < functions[k].highest ? 3 : 2, functions[k].to_dim, results);
        mark(results);
        for (int which = 0; which < 6; which++) {
            struct arguments bad = x;
            if (which < 4 ? functions[k].results[which] == NO : !takes(k, which == 4 ? 'P' : 'W'))
                continue;
            if (which < 4)
                bad.out[which] = NULL;
            else if (which == 4)
                bad.points = NULL;
            else
                bad.weights = NULL;
            assert_int_equal(functions[k].run(&bad), CAGD_NULL);
            nothing_is_written();
        }
    }
}

static void every_range_has_two_ends(void **state)
{
    (void)state;
    for (int k = 0; k < FUNCTIONS; k++) {
        int lowest = functions[k].kernel == NULL ? 0 : functions[k].lowest;
        for (int degree = -2; degree <= CAGD_MAX_DEGREE + 2 && functions[k].highest > 2; degree++) {
            struct arguments x = good(degree, functions[k].to_dim, results);
            mark(results);
            cagd_status status = functions[k].run(&x);
            if (lowest <= degree && degree <= functions[k].highest) {
                assert_true(status == CAGD_OK || (status == CAGD_UNDEFINED && degree < functions[k].lowest));
            } else {
                assert_int_equal(status, CAGD_DEGREE);
                nothing_is_written();
            }
        }
        for (int dim = -1; dim <= CAGD_MAX_DIM + 2 && functions[k].from_dim < functions[k].to_dim; dim++) {
            struct arguments x = good(3, dim, results);
            int has = functions[k].from_dim <= dim && dim <= functions[k].to_dim;
            mark(results);
            assert_int_equal(functions[k].run(&x), has ? CAGD_OK : CAGD_DIMENSION);
            if (!has)
                nothing_is_written();
        }
        for (int order = -2; order <= CAGD_MAX_DEGREE + 2 && takes(k, 'O'); order++) {
            struct arguments x = good(3, functions[k].to_dim, results);
            x.order = order;
            mark(results);
            int has = 0 <= order && order <= CAGD_MAX_DEGREE;
            assert_int_equal(functions[k].run(&x), has ? CAGD_OK : CAGD_ORDER);
            if (!has)
                nothing_is_written();
        }
    }
}

/* Whichever number it is, from the first to the last and none behind it. */
static void every_number_is_asked_for(void **state)
{
    (void)state;
    const double none[] = {NAN, INFINITY, -INFINITY};
    for (int k = 0; k < FUNCTIONS; k++)
        for (int degree = functions[k].lowest; degree <= functions[k].highest && degree < 5; degree++)
            for (int dim = functions[k].from_dim; dim <= functions[k].to_dim; dim++)
                for (int n = 0; n < 3; n++) {
                    const struct arguments x = good(degree, dim, results);
                    mark(results);
                    for (int m = 0; m <= (degree + 1) * dim && takes(k, 'P'); m++) {
                        double keep = some_points[m];
                        some_points[m] = none[n];
                        int behind = m == (degree + 1) * dim;
                        assert_int_equal(functions[k].run(&x), behind ? CAGD_OK : CAGD_NOT_FINITE);
                        if (!behind)
                            nothing_is_written();
                        some_points[m] = keep;
                    }
                    mark(results);
                    for (int i = 0; i <= degree + 1 && takes(k, 'W'); i++) {
                        double keep = some_weights[i];
                        some_weights[i] = none[n];
                        assert_int_equal(functions[k].run(&x), i > degree ? CAGD_OK : CAGD_NOT_FINITE);
                        if (i <= degree)
                            nothing_is_written();
                        some_weights[i] = keep;
                    }
                    mark(results);
                    struct arguments bad[] = {x, x, x};
                    bad[0].t = bad[1].a = bad[2].b = none[n];
                    for (int j = 0; j < 3; j++)
                        if (takes(k, j == 0 ? 'T' : 'R')) {
                            assert_int_equal(functions[k].run(&bad[j]), CAGD_NOT_FINITE);
                            nothing_is_written();
                        }
                }
}

/* Of numbers near both ends of binary64: there is a result if and only if all of the kernel's numbers are numbers, a total weight and a weight of a
 * result are not 0, and a weight that is scaled is 0 only where it was. */
static void what_the_kernel_cannot_hold_is_out_of_range(void **state)
{
    (void)state;
    const double values[] = {0, 1, -2, DBL_MAX, -DBL_MAX, 0x1p-1040, 0x1p1000, -0x1p-600, 0.75},
                 at[] = {T, 2, -1, 0.5, 0, 1, -1e300};
    enum { TRIED = 3000 };
    for (int k = 0; k < FUNCTIONS && functions[k].kernel != NULL; k++) {
        int seen[CAGD_STATUSES] = {0};
        for (int trial = 0; trial < TRIED; trial++) {
            int lowest = functions[k].lowest, most = functions[k].highest < 5 ? functions[k].highest : 5;
            struct arguments x =
                good(lowest + trial % (most - lowest + 1),
                     functions[k].from_dim + trial / 7 % (functions[k].to_dim - functions[k].from_dim + 1), expected);
            int tame = trial % 3; /* neither, points or weights are ordinary */
            for (int m = 0; m < LONGEST; m++)
                some_points[m] = tame == 1 ? some_points[m] : values[(int)(9 * uniform())] * (uniform() < 0.2);
            for (int i = 0; i < CAGD_MAX_DEGREE + 2; i++)
                some_weights[i] = tame == 2         ? 1 - 2 * (uniform() < 0.2)
                                  : uniform() < 0.3 ? 1
                                                    : values[(int)(9 * uniform())];
            x.t = at[(int)(7 * uniform())];
            x.a = fabs(values[3 + (int)(6 * uniform())]);
            x.b = fabs(values[3 + (int)(6 * uniform())]);
            x.order = (int)(5 * uniform());
            double first = some_weights[0], last = some_weights[x.degree];
            int undefined = 0, overflow = 0,
                excluded = functions[k].run == standard_form && !((first > 0 && last > 0) || (first < 0 && last < 0));
            functions[k].kernel(&x);
            if (takes(k, 'W') && takes(k, 'T')) {
                double total = rational_weight_d(x.degree, x.weights, x.t);
                int whole = functions[k].results[1] == ORDERS; /* parts, of which no weight is 0 */
                undefined |= !whole && total == 0;
                overflow |= !whole && !isfinite(total);
            }
            if (functions[k].run == invariants)
                for (int i = 1; i < x.degree; i++)
                    undefined |= some_weights[i - 1] == 0 || some_weights[i + 1] == 0;
            if (functions[k].run == standard_form)
                overflow |= !isnormal(first / last);
            for (int r = 0; r < 4; r++)
                for (int m = 0; m < numbers_in(functions[k].results[r], &x); m++) {
                    enum length of = functions[k].results[r];
                    /* a point has none where its weight is 0: that is told first */
                    int part = functions[k].results[1] == ORDERS || functions[k].results[1] == HIGHER_ORDERS;
                    int lost = part && r % 2 == 0 && expected[r + 1][m / x.dim] == 0;
                    overflow |= !lost && !isfinite(expected[r][m]);
                    undefined |=
                        takes(k, 'P') && takes(k, 'W') && (of == ORDERS || of == HIGHER_ORDERS) && expected[r][m] == 0;
                    overflow |=
                        !takes(k, 'P') && takes(k, 'W') && of == ORDERS && expected[r][m] == 0 && some_weights[m] != 0;
                }
            struct arguments y = x;
            for (int r = 0; r < 4; r++)
                y.out[r] = results[r];
            cagd_status status = functions[k].run(&y);
            seen[status]++;
            if (excluded)
                assert_int_equal(status, CAGD_SIGN);
            else if (undefined && overflow)
                assert_true(status == CAGD_UNDEFINED || status == CAGD_OVERFLOW);
            else
                assert_int_equal(status, undefined ? CAGD_UNDEFINED : overflow ? CAGD_OVERFLOW : CAGD_OK);
        }
        assert_true(seen[CAGD_OK] > TRIED / 100);
        assert_true(seen[CAGD_OVERFLOW] > TRIED / 100 || functions[k].run == elevate);
    }
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

/* The type of A, B, C = a 2^x, b 2^((x + y)/2), c 2^y for whole a, b, c below 2^52 by a product of 104 bits; b is often the root of ac or beside it. */
static void conic_types_are_those_of_whole_numbers(void **state)
{
    (void)state;
    int seen[3] = {0};
    for (int trial = 0; trial < 20000; trial++) {
        int bits = 1 + trial % 26, x = (int)(600 * uniform()) - 300, y = x + 2 * ((int)(300 * uniform()) - 150);
        long long p = (long long)ldexp(uniform(), bits), r = (long long)ldexp(uniform(), bits), a = p * p, c = r * r,
                  b = p * r + (long long)(3 * uniform()) - 1;
        if (trial % 5 == 0) /* powers that differ by an odd number: 2 a b^2 has no whole root */
            a *= 2;
        if (trial % 3 == 0)
            b = -b;
        if (trial % 7 == 0)
            a = -a, c = -c;
        else if (trial % 11 == 0)
            c = -c;
        if (a == 0 && b == 0 && c == 0)
            continue;
        __extension__ typedef __int128 wide;
        wide delta = (wide)a * c - (wide)b * b;
        cagd_conic_type type = type_of(ldexp((double)a, x), ldexp((double)b, (x + y) / 2), ldexp((double)c, y));
        assert_int_equal(type, delta > 0 ? CAGD_ELLIPSE : delta < 0 ? CAGD_HYPERBOLA : CAGD_PARABOLA);
        seen[type]++;
    }
    assert_true(seen[CAGD_ELLIPSE] > 1000 && seen[CAGD_HYPERBOLA] > 1000 && seen[CAGD_PARABOLA] > 1000);
    cagd_conic_type type;
    assert_int_equal(cagd_conic_classify((double[]){0, 1, 0, 1, 2, 3}, &type), CAGD_OK);
    assert_int_equal(type, CAGD_HYPERBOLA);
    assert_int_equal(type_of(5, 0, 0), CAGD_PARABOLA);
    assert_int_equal(type_of(5, 1, 0), CAGD_HYPERBOLA);
    assert_int_equal(type_of(0, 1, 5), CAGD_HYPERBOLA);
    for (int zero = 0; zero < 3; zero++) {
        double weights[3] = {1, -2, 3};
        weights[zero] = 0;
        assert_int_equal(cagd_conic_classify_weights(weights, &type), CAGD_SIGN);
    }
}

/* What the header says of a status, in one word of it; a sentence has no full stop and no line end. */
static void every_status_says_what_it_is(void **state)
{
    (void)state;
    static const char *const words[CAGD_STATUSES] = {[CAGD_OK] = "no error",
                                                     [CAGD_NULL] = "NULL",
                                                     [CAGD_NO_MEMORY] = "not enough memory",
                                                     [CAGD_DEGREE] = "the degree is out of",
                                                     [CAGD_DIMENSION] = "the dimension is out of",
                                                     [CAGD_ORDER] = "order of derivation is out of",
                                                     [CAGD_COUNT] = "more points than its degree",
                                                     [CAGD_NOT_FINITE] = "infinite or not a number",
                                                     [CAGD_SIGN] = "excluded",
                                                     [CAGD_OUTSIDE_DOMAIN] = "outside the domain",
                                                     [CAGD_KNOTS_DECREASE] = "smaller than the one before",
                                                     [CAGD_KNOTS_MULTIPLE] = "more than degree + 1 times",
                                                     [CAGD_KNOTS_EMPTY] = "domain of the spline is empty",
                                                     [CAGD_UNDEFINED] = "a divisor is zero",
                                                     [CAGD_OVERFLOW] = "binary64",
                                                     [CAGD_NO_KNOT] = "no such knot",
                                                     [CAGD_CHANGES] = "another",
                                                     [CAGD_BAD_DATA] = "standard deviation is not positive",
                                                     [CAGD_BAD_OPTION] = "an option is outside",
                                                     [CAGD_BAD_CURVE] = "initial curve or the knots",
                                                     [CAGD_TOO_FEW] = "fewer equations than unknowns",
                                                     [CAGD_ALL_EQUAL] = "all points are equal"};
    for (int s = CAGD_OK; s < CAGD_STATUSES; s++) {
        const char *text = cagd_status_text((cagd_status)s);
        assert_non_null(words[s]);
        assert_non_null(strstr(text, words[s]));
        assert_true(strlen(text) > 7 && strpbrk(text, ".\n\t") == NULL);
    }
    assert_string_equal(cagd_status_text(CAGD_STATUSES), "unknown status");
    assert_string_equal(cagd_status_text((cagd_status)(CAGD_STATUSES + 1)), "unknown status");
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
        cmocka_unit_test(curvature_and_torsion_in_every_direction),
        cmocka_unit_test(curvature_and_torsion_that_are_none),
        cmocka_unit_test(bad_arguments_are_refused),
        cmocka_unit_test(every_coordinate_is_asked_for),
        cmocka_unit_test(nothing_behind_a_result_counts),
        cmocka_unit_test(what_has_no_value_is_undefined),
        cmocka_unit_test(weights_below_zero_have_a_standard_form),
        cmocka_unit_test(what_leaves_binary64_is_out_of_range),
        cmocka_unit_test(whichever_number_leaves_the_range_is_seen),
        cmocka_unit_test(every_degree_and_dimension_has_the_kernels_values),
        cmocka_unit_test(no_pointer_may_be_missing),
        cmocka_unit_test(every_range_has_two_ends),
        cmocka_unit_test(every_number_is_asked_for),
        cmocka_unit_test(what_the_kernel_cannot_hold_is_out_of_range),
        cmocka_unit_test(conic_types_are_exact),
        cmocka_unit_test(conic_types_are_those_of_whole_numbers),
        cmocka_unit_test(every_status_has_its_own_text),
        cmocka_unit_test(every_status_says_what_it_is),
        cmocka_unit_test(the_header_has_the_version_of_the_library),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
