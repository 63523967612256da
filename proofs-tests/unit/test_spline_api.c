/* test_spline_api.c -- the public functions on splines: what they compute is the kernels' values, what they refuse is
 * refused with the stated status and without writing. */
#include "core/api/cagd.h"
#include "core/kernels/kernels_d.h"
#include "core/kernels/span.h"

#include <float.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

/* Cubics of space over kinds of knots: clamped, with inner knots of multiplicity 1, 2 and 4; not clamped; with a
 * multiple knot at the start of the domain; with an inner knot of multiplicity 3.  Weights are powers of two, so that they come back from homogeneous
 * coordinates as they were. */
enum { P = 3, DIM = 3, CURVES = 4, MOST = 16, ROOM = 256 };
static const double knots[CURVES][MOST + P + 1] = {
    {0, 0, 0, 0, 0.7, 1.1, 1.1, 2.3, 2.3, 2.3, 2.3, 3.1, 3.1, 3.1, 3.1},
    {-1.3, -0.4, 0.2, 0.9, 1.3, 2.2, 2.9, 4.1, 5.3, 5.9},
    {-2, -1, 0.5, 0.5, 1.5, 2.5, 3.5, 3.5, 3.5, 7},
    {0, 0, 0, 0, 1.3, 1.3, 1.3, 2.6, 3.1, 3.1, 3.1, 3.1},
};
static const int counts[CURVES] = {11, 6, 6, 8};
static double points[MOST * DIM], weights[MOST];
static const double inner[] = {0.95, 1.1, 1.3, 2.3, 2.6};

static cagd_spline curve(int k, int rational)
{
    return (cagd_spline){CAGD_DEGREE_OF_ORDER(P + 1), counts[k], DIM, knots[k], points, rational ? weights : NULL};
}
static int setup(void **state)
{
    (void)state;
    for (int m = 0; m < MOST * DIM; m++)
        points[m] = (double)((m * m * 37 + m * 11) % 101) / 7 - 6;
    for (int i = 0; i < MOST; i++)
        weights[i] = (const double[]){1, 0.5, 4, 2, 0.25}[i * 3 % 5];
    return 0;
}

static void same(int count, const double a[], const double b[])
{
    for (int i = 0; i < count; i++)
        assert_true(a[i] == b[i]);
}

static void values_are_the_kernels(void **state)
{
    double a[ROOM], b[ROOM], c[ROOM], d[ROOM], e[ROOM], f[ROOM];
    (void)state;
    for (int k = 0; k < CURVES; k++)
        for (int m = 0; m < 5; m++)
            for (int side = CAGD_RIGHT; side <= CAGD_LEFT; side++) {
                cagd_spline s = curve(k, 0), r = curve(k, 1);
                double t = inner[m];
                int mu = (side == CAGD_LEFT ? find_span_left_d : find_span_d)(s.count, P, s.knots, t), span;
                assert_int_equal(cagd_spline_span(&s, t, (cagd_side)side, &span), CAGD_OK);
                assert_int_equal(span, mu);
                assert_true(side == CAGD_LEFT ? s.knots[mu] < t && t <= s.knots[mu + 1]
                                              : s.knots[mu] <= t && t < s.knots[mu + 1]);
                assert_int_equal(cagd_spline_basis(&s, t, (cagd_side)side, 4, &span, a), CAGD_OK);
                bspline_basis_derivatives_d(P, s.knots, mu, t, 4, b);
                same(20, a, b);
                assert_int_equal(cagd_spline_derivatives(&s, t, (cagd_side)side, 4, a), CAGD_OK);
                bspline_derivatives_d(on_span_d(P, DIM, s.knots, mu, points), t, 4, b);
                same(15, a, b);
                assert_int_equal(cagd_spline_derivatives(&r, t, (cagd_side)side, 4, a), CAGD_OK);
                nurbs_derivatives_d(nurbs_on_span_d(P, DIM, s.knots, mu, points, weights), t, 4, b);
                same(15, a, b);
                assert_int_equal(cagd_spline_point(&r, t, (cagd_side)side, c), CAGD_OK);
                same(3, c, b);
                assert_int_equal(cagd_spline_curvature(&r, t, (cagd_side)side, c), CAGD_OK);
                assert_true(fabs(*c - curvature_d(DIM, b + 3, b + 6)) <= 64 * DBL_EPSILON * *c);
                assert_int_equal(cagd_spline_torsion(&r, t, (cagd_side)side, c), CAGD_OK);
                assert_true(fabs(*c - torsion_d(b + 3, b + 6, b + 9)) <= 64 * DBL_EPSILON * fabs(*c));
            }
    for (int k = 0; k < CURVES; k++)
        for (int mu = P; mu < counts[k]; mu++) {
            cagd_spline s = curve(k, 0), r = curve(k, 1);
            if (!(s.knots[mu] < s.knots[mu + 1])) {
                assert_int_equal(cagd_spline_bezier(&s, mu, a, NULL), CAGD_OUTSIDE_DOMAIN);
                continue;
            }
            assert_int_equal(cagd_spline_bezier(&s, mu, a, NULL), CAGD_OK);
            bspline_to_bezier_d(on_span_d(P, DIM, s.knots, mu, points), b);
            same(12, a, b);
            assert_int_equal(cagd_spline_bezier(&r, mu, a, c), CAGD_OK);
            rational_homogenize_d(s.count - 1, DIM, points, weights, d);
            bspline_to_bezier_d(on_span_d(P, DIM + 1, s.knots, mu, d), e);
            rational_dehomogenize_d(P, DIM, e, b, f);
            same(12, a, b);
            same(4, c, f);
        }
}

static void insertion_and_split_are_the_kernels(void **state)
{
    double H[ROOM], u[ROOM], d[ROOM], u2[ROOM], d2[ROOM], v[ROOM], v2[ROOM], z[ROOM], z2[ROOM], e[ROOM], g[ROOM],
        q[ROOM], q2[ROOM];
    (void)state;
    for (int k = 0; k < CURVES; k++)
        for (int m = 0; m < 5; m++) {
            cagd_spline s = curve(k, 0), r = curve(k, 1);
            double t = inner[m];
            int n = s.count, mu = find_span_d(n, P, s.knots, t), times = multiplicity_d(n + P + 1, s.knots, t);
            assert_int_equal(cagd_spline_insert(&s, t, u, d, NULL), times <= P ? CAGD_OK : CAGD_KNOTS_MULTIPLE);
            if (times <= P) {
                bspline_insert_d(&(struct spline_d){P, n, DIM, s.knots, points, NULL}, mu, t, u2, d2);
                same(n + P + 2, u, u2);
                same((n + 1) * DIM, d, d2);
                assert_int_equal(cagd_spline_insert(&r, t, u, d, z), CAGD_OK);
                nurbs_insert_d(&(struct spline_d){P, n, DIM, s.knots, points, weights}, mu, t, u2, d2, z2);
                same(n + P + 2, u, u2);
                same((n + 1) * DIM, d, d2);
                same(n + 1, z, z2);
            }
            int lefts, rights;
            assert_int_equal(cagd_spline_split_counts(&s, t, &lefts, &rights), CAGD_OK);
            assert_int_equal(lefts, mu - times + 1);
            assert_int_equal(rights, n - mu + P);
            assert_int_equal(cagd_spline_split(&s, t, u, d, NULL, v, e, NULL), CAGD_OK);
            bspline_split_d(&(struct spline_d){P, n, DIM, s.knots, points, NULL}, mu, times, t, u2, d2, v2, q);
            same(lefts + P + 1, u, u2);
            same(lefts * DIM, d, d2);
            same(rights + P + 1, v, v2);
            same(rights * DIM, e, q);
            assert_int_equal(cagd_spline_split(&r, t, u, d, z, v, e, g), CAGD_OK);
            rational_homogenize_d(n - 1, DIM, points, weights, H);
            bspline_split_d(&(struct spline_d){P, n, DIM + 1, s.knots, H, NULL}, mu, times, t, u2, d2, v2, q);
            rational_dehomogenize_d(lefts - 1, DIM, d2, q2, z2);
            same(lefts * DIM, d, q2);
            same(lefts, z, z2);
            rational_dehomogenize_d(rights - 1, DIM, q, q2, z2);
            same(rights * DIM, e, q2);
            same(rights, g, z2);
        }
}

/* The elevated curve over its own knots has the points that the kernel gives, and ends where the curve ends. */
static void elevation_is_the_kernel(void **state)
{
    double H[ROOM], E[ROOM], v[ROOM], d[ROOM], z[ROOM], b[ROOM], f[ROOM];
    int span[ROOM];
    (void)state;
    for (int k = 0; k < CURVES; k++) {
        cagd_spline s = curve(k, 0), r = curve(k, 1);
        int n = s.count, m, where;
        assert_int_equal(cagd_spline_elevated_count(&s, &m), CAGD_OK);
        assert_int_equal(cagd_spline_elevate(&s, v, d, NULL), CAGD_OK);
        assert_true(v[P + 1] == s.knots[P] && v[P + 2] > s.knots[P]);
        assert_true(v[m] == s.knots[n] && v[m - 1] < s.knots[n]);
        assert_int_equal(check_knots_d(m, P + 1, v, &where), CAGD_OK);
        for (int i = P; i <= n; i++)
            assert_true(s.knots[i] == s.knots[P] || s.knots[i] == s.knots[n] ||
                        multiplicity_d(m + P + 2, v, s.knots[i]) == multiplicity_d(n + P + 1, s.knots, s.knots[i]) + 1);
        assert_true(spans_of_points_d(n, P, s.knots, m, P + 1, v, span));
        bspline_elevate_d(&(cagd_spline){P, s.count, DIM, s.knots, points, NULL}, m, v, span, b);
        same(m * DIM, d, b);
        assert_int_equal(cagd_spline_elevate(&r, v, d, z), CAGD_OK);
        rational_homogenize_d(n - 1, DIM, points, weights, H);
        bspline_elevate_d(&(cagd_spline){P, s.count, DIM + 1, s.knots, H, NULL}, m, v, span, E);
        rational_dehomogenize_d(m - 1, DIM, E, b, f);
        same(m * DIM, d, b);
        same(m, z, f);
    }
}

static void bad_splines_are_refused(void **state)
{
    double out[ROOM], spare[ROOM], bad[MOST + P + 1];
    int where = 7, span = 77, n = counts[0];
    (void)state;
    for (int i = 0; i < ROOM; i++)
        out[i] = spare[i] = 77;
    cagd_spline good = curve(0, 1), s;
#define REFUSED(change, status, place)                                                                                 \
    do {                                                                                                               \
        s = good;                                                                                                      \
        memcpy(bad, knots[0], sizeof bad);                                                                             \
        change;                                                                                                        \
        assert_int_equal(cagd_spline_check(&s, &where), status);                                                       \
        assert_int_equal(where, place);                                                                                \
        assert_int_equal(cagd_spline_check(&s, NULL), status);                                                         \
        assert_int_equal(cagd_spline_point(&s, 0.9, CAGD_RIGHT, out), status);                                         \
        assert_int_equal(cagd_spline_insert(&s, 0.9, out, out + 64, out + 128), status);                               \
        assert_int_equal(cagd_spline_elevate(&s, out, out + 64, out + 128), status);                                   \
        assert_int_equal(cagd_spline_bezier(&s, P, out, out + 64), status);                                            \
        assert_int_equal(cagd_spline_split(&s, 0.9, out, out, out, out, out, out), status);                            \
    } while (0)
    REFUSED((void)0, CAGD_OK, -1);
    memcpy(out, spare, sizeof out);
    REFUSED(s.degree = -1, CAGD_DEGREE, -1);
    REFUSED(s.degree = CAGD_MAX_DEGREE + 1, CAGD_DEGREE, -1);
    REFUSED(s.count = P, CAGD_COUNT, -1);
    REFUSED(s.dim = 0, CAGD_DIMENSION, -1);
    REFUSED(s.dim = CAGD_MAX_DIM + 1, CAGD_DIMENSION, -1);
    REFUSED(s.knots = NULL, CAGD_NULL, -1);
    REFUSED(s.points = NULL, CAGD_NULL, -1);
    REFUSED((bad[5] = 0.6, s.knots = bad), CAGD_KNOTS_DECREASE, 5);
    REFUSED((bad[4] = 0, s.knots = bad), CAGD_KNOTS_MULTIPLE, 4);
    for (int i = 0; i < n + P + 1; i++) /* whichever it is, and none behind them */
        REFUSED((bad[i] = i % 2 ? NAN : INFINITY, s.knots = bad), CAGD_NOT_FINITE, i);
    s = good;
    memcpy(bad, (double[]){0, 1, 2, 3, 3, 4, 5, 6}, 8 * sizeof bad[0]); /* one span, and it is empty */
    s.count = P + 1;
    s.knots = bad;
    assert_int_equal(cagd_spline_check(&s, &where), CAGD_KNOTS_EMPTY);
    for (int i = 0; i < n; i++) {
        double keep = weights[i];
        weights[i] = INFINITY;
        REFUSED((void)0, CAGD_NOT_FINITE, i);
        weights[i] = keep;
    }
    assert_int_equal(cagd_spline_check(NULL, NULL), CAGD_NULL);
    assert_int_equal(cagd_spline_point(&good, 0.9, CAGD_RIGHT, NULL), CAGD_NULL);
    assert_int_equal(cagd_spline_point(&good, -0.1, CAGD_RIGHT, out), CAGD_OUTSIDE_DOMAIN);
    assert_int_equal(cagd_spline_point(&good, 3.2, CAGD_LEFT, out), CAGD_OUTSIDE_DOMAIN);
    assert_int_equal(cagd_spline_point(&good, NAN, CAGD_LEFT, out), CAGD_NOT_FINITE);
    assert_int_equal(cagd_spline_span(&good, 0.9, CAGD_LEFT, NULL), CAGD_NULL);
    assert_int_equal(cagd_spline_span(&good, 4, CAGD_LEFT, &span), CAGD_OUTSIDE_DOMAIN);
    assert_int_equal(cagd_spline_derivatives(&good, 0.9, CAGD_LEFT, -1, out), CAGD_ORDER);
    assert_int_equal(cagd_spline_basis(&good, 0.9, CAGD_LEFT, CAGD_MAX_DEGREE + 1, &span, out), CAGD_ORDER);
    assert_int_equal(cagd_spline_insert(&good, 3.1, out, out, out), CAGD_OUTSIDE_DOMAIN);
    assert_int_equal(cagd_spline_insert(&good, 2.3, out, out, out), CAGD_KNOTS_MULTIPLE);
    assert_int_equal(cagd_spline_insert(&good, 0.9, out, out, NULL), CAGD_NULL);
    assert_int_equal(cagd_spline_split(&good, 0, out, out, out, out, out, out), CAGD_OUTSIDE_DOMAIN);
    assert_int_equal(cagd_spline_split(&good, 0.9, out, out, NULL, out, out, out), CAGD_NULL);
    assert_int_equal(cagd_spline_bezier(&good, 2, out, out), CAGD_OUTSIDE_DOMAIN);
    s = good;
    s.dim = 2;
    assert_int_equal(cagd_spline_torsion(&s, 0.9, CAGD_LEFT, out), CAGD_DIMENSION);
    s.dim = 1;
    assert_int_equal(cagd_spline_curvature(&s, 0.9, CAGD_LEFT, out), CAGD_DIMENSION);
    same(ROOM, out, spare);
    assert_int_equal(span, 77);
}

static void what_has_no_value_is_undefined(void **state)
{
    const double line[4] = {0, 0, 1, 1}, cancel[2] = {1, -1}, still[6] = {2, 3, 2, 3, 2, 3},
                 knots2[6] = {0, 0, 0, 1, 1, 1};
    cagd_spline s = {1, 2, 2, line, still, cancel}, r = {2, 3, 2, knots2, still, NULL};
    double out[ROOM];
    (void)state;
    assert_int_equal(cagd_spline_point(&s, 0.5, CAGD_RIGHT, out), CAGD_UNDEFINED);
    assert_int_equal(cagd_spline_point(&s, 0.25, CAGD_RIGHT, out), CAGD_OK);
    assert_int_equal(cagd_spline_insert(&s, 0.5, out, out + 64, out + 128), CAGD_UNDEFINED);
    assert_int_equal(cagd_spline_elevate(&s, out, out + 64, out + 128), CAGD_UNDEFINED);
    assert_int_equal(cagd_spline_curvature(&r, 0.5, CAGD_RIGHT, out), CAGD_UNDEFINED);
    const double huge[4] = {DBL_MAX, -DBL_MAX, -DBL_MAX, DBL_MAX};
    s.points = huge;
    s.weights = NULL;
    assert_int_equal(cagd_spline_derivatives(&s, 0.5, CAGD_RIGHT, 1, out), CAGD_OVERFLOW);
    /* the length of the span is no number of binary64 */
    const double wide[4] = {-DBL_MAX, -DBL_MAX, DBL_MAX, DBL_MAX}, ones[2] = {1, 1}, ends[4] = {1, 2, 3, 4};
    for (int rational = 0; rational < 2; rational++) {
        s = (cagd_spline){1, 2, 2, wide, ends, rational ? ones : NULL};
        assert_int_equal(cagd_spline_point(&s, 0.5 * DBL_MAX, CAGD_RIGHT, out), CAGD_OVERFLOW);
        assert_int_equal(cagd_spline_insert(&s, 0.5 * DBL_MAX, out, out + 64, out + 128), CAGD_OVERFLOW);
    }
}

/* Over a segment of length 3 the affine combination t/3 c + (3 - t)/3 c of c = DBL_MAX is rounded beyond the range for some t: of one coordinate,
 * whichever it is, and of the weights of points that are 0. */
static void one_number_that_is_out_of_range_is_seen(void **state)
{
    (void)state;
    enum { TRIED = 1000, MOST_DIM = 3 };
    const double line[4] = {0, 0, 3, 3}, zero[2 * MOST_DIM] = {0}, largest[2] = {DBL_MAX, DBL_MAX};
    double out[ROOM];
    int beyond = 0;
    for (int k = 1; k < TRIED; k++) {
        const double t = 3.0 * k / TRIED;
        const cagd_status expected = isinf(t / 3 * DBL_MAX + (3 - t) / 3 * DBL_MAX) ? CAGD_OVERFLOW : CAGD_OK;
        beyond += expected == CAGD_OVERFLOW;
        for (int dim = 1; dim <= MOST_DIM; dim++)
            for (int which = -1; which < dim; which++) {
                double c[2 * MOST_DIM] = {0};
                for (int i = 0; i < 2 && which >= 0; i++)
                    c[i * dim + which] = DBL_MAX;
                const cagd_spline s = {1, 2, dim, line, which < 0 ? zero : c, which < 0 ? largest : NULL};
                assert_int_equal(cagd_spline_point(&s, t, CAGD_RIGHT, out), expected);
                assert_int_equal(cagd_spline_insert(&s, t, out, out + 8, out + 32), expected);
                assert_int_equal(cagd_spline_split(&s, t, out, out + 8, out + 16, out + 24, out + 32, out + 40),
                                 expected);
            }
    }
    assert_true(beyond > 0);
}

/* Of a quadratic whose weights 1 and -1 + 2^-53 nearly cancel halfway, one of the parts has a point beyond the range, and the point that
 * both have is within it. */
static void either_part_may_leave_the_range(void **state)
{
    (void)state;
    const double knots_of_one[6] = {0, 0, 0, 1, 1, 1}, far[3] = {0, 1e300, -1e300}, turned[3] = {-1e300, 1e300, 0};
    const double near_zero = -1 + DBL_EPSILON / 2, w[3] = {1, 1, near_zero}, v[3] = {near_zero, 1, 1};
    double out[ROOM];
    for (int right = 0; right < 2; right++) {
        const cagd_spline s = {2, 3, 1, knots_of_one, right ? far : turned, right ? w : v};
        assert_int_equal(cagd_spline_split(&s, 0.5, out, out + 8, out + 16, out + 24, out + 32, out + 40),
                         CAGD_OVERFLOW);
        assert_int_equal(cagd_spline_point(&s, 0.5, CAGD_RIGHT, out), CAGD_OK);
    }
}

/* A knot p+2 times at the very end is too many; of the end of the domain, a knot twice that is no end of the knots, nothing is lowered. */
static void knots_at_the_end(void **state)
{
    (void)state;
    const double good[] = {0, 0, 1, 2, 2}, bad[] = {0, 0, 2, 2, 2}, inside[] = {0, 1, 2, 2.5, 2.5, 3, 3, 4, 5};
    int where;
    assert_int_equal(check_knots_d(3, 1, good, &where), CAGD_OK);
    assert_int_equal(check_knots_d(3, 1, bad, &where), CAGD_KNOTS_MULTIPLE);
    assert_int_equal(where, 4);
    /* degree 2, six points, domain from u_2 = 2 to u_6 = 3: v is 2, 2, 2.5, 3, 3 */
    double v[8];
    assert_int_equal(check_knots_d(6, 2, inside, &where), CAGD_OK);
    assert_int_equal(lowered_knots_d(6, 2, inside, NULL), 3);
    assert_int_equal(lowered_knots_d(6, 2, inside, v), 3);
    static const double expected[] = {2, 2, 2.5, 3, 3};
    for (int k = 0; k < 5; k++)
        assert_true(v[k] == expected[k]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_are_the_kernels),
        cmocka_unit_test(insertion_and_split_are_the_kernels),
        cmocka_unit_test(elevation_is_the_kernel),
        cmocka_unit_test(bad_splines_are_refused),
        cmocka_unit_test(what_has_no_value_is_undefined),
        cmocka_unit_test(knots_at_the_end),
        cmocka_unit_test(one_number_that_is_out_of_range_is_seen),
        cmocka_unit_test(either_part_may_leave_the_range),
    };
    return cmocka_run_group_tests(tests, setup, NULL);
}
