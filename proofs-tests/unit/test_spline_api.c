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

/* ---- every function by one table ---------------------------------------------------------------------- */

/* The arguments of all functions, of which each takes its own. */
struct arguments {
    cagd_spline s;
    const cagd_spline *spline;
    double t;
    cagd_side side;
    int order, span;
    double *out[6];
    int *whole[2];
};
typedef struct arguments *A;
enum { MOST_DEGREE = 6, MOST_POINTS = 20, LONGEST = 256, RESULTS = 6 };

static cagd_status span_of(A x) { return cagd_spline_span(x->spline, x->t, x->side, x->whole[0]); }
static cagd_status basis(A x) { return cagd_spline_basis(x->spline, x->t, x->side, x->order, x->whole[0], x->out[0]); }
static cagd_status point(A x) { return cagd_spline_point(x->spline, x->t, x->side, x->out[0]); }
static cagd_status derivatives(A x) { return cagd_spline_derivatives(x->spline, x->t, x->side, x->order, x->out[0]); }
static cagd_status curvature(A x) { return cagd_spline_curvature(x->spline, x->t, x->side, x->out[0]); }
static cagd_status torsion(A x) { return cagd_spline_torsion(x->spline, x->t, x->side, x->out[0]); }
static cagd_status insert(A x) { return cagd_spline_insert(x->spline, x->t, x->out[0], x->out[1], x->out[2]); }
static cagd_status bezier(A x) { return cagd_spline_bezier(x->spline, x->span, x->out[0], x->out[1]); }
static cagd_status split_counts(A x) { return cagd_spline_split_counts(x->spline, x->t, x->whole[0], x->whole[1]); }
static cagd_status split(A x)
{
    return cagd_spline_split(x->spline, x->t, x->out[0], x->out[1], x->out[2], x->out[3], x->out[4], x->out[5]);
}
static cagd_status elevated_count(A x) { return cagd_spline_elevated_count(x->spline, x->whole[0]); }
static cagd_status elevate(A x) { return cagd_spline_elevate(x->spline, x->out[0], x->out[1], x->out[2]); }

/* What a function takes: T a parameter, O an order, P the points.  How many results, the bits of those that are weights, and how many whole numbers. */
static const struct {
    cagd_status (*run)(A);
    const char *takes;
    int from_dim, results, weights, whole;
} functions[] = {
    {span_of, "T", 1, 0, 0, 1},       {basis, "TO", 1, 1, 0, 1},        {point, "TP", 1, 1, 0, 0},
    {derivatives, "TPO", 1, 1, 0, 0}, {curvature, "TP", 2, 1, 0, 0},    {torsion, "TP", 3, 1, 0, 0},
    {insert, "TP", 1, 3, 4, 0},       {bezier, "P", 1, 2, 2, 0},        {split_counts, "T", 1, 0, 0, 2},
    {split, "TP", 1, 6, 36, 0},       {elevated_count, "", 1, 0, 0, 1}, {elevate, "P", 1, 3, 4, 0},
};
enum { FUNCTIONS = sizeof functions / sizeof functions[0] };
static int takes(int k, char what) { return strchr(functions[k].takes, what) != NULL; }

static double uniform(void)
{
    static unsigned long long x = 60317;
    x = x * 6364136223846793005u + 1442695040888963407u;
    return (double)(x >> 11) * 0x1p-53;
}

static double u_of[MOST_POINTS + MOST_DEGREE + 2], P_of[3 * MOST_POINTS + 1], w_of[MOST_POINTS + 1],
    results[RESULTS][LONGEST];
static int whole[2];
static void mark(void)
{
    for (int r = 0; r < RESULTS; r++)
        for (int m = 0; m < LONGEST; m++)
            results[r][m] = 77;
    whole[0] = whole[1] = 77;
}
static void nothing_is_written(void)
{
    for (int r = 0; r < RESULTS; r++)
        for (int m = 0; m < LONGEST; m++)
            assert_true(results[r][m] == 77);
    assert_true(whole[0] == 77 && whole[1] == 77);
}
static void so_many_are_written(int r, int length)
{
    for (int m = 0; m < LONGEST; m++)
        assert_int_equal(results[r][m] != 77, m < length);
}

/* Knots of all multiplicities that the degree allows, clamped or not, and a parameter inside the domain that is no knot; weights are powers of two. */
static struct arguments some_spline(int degree, int count, int dim, int rational, int clamped)
{
    do {
        double u = -2.3;
        for (int i = 0, run = 1; i <= count + degree; i++) {
            int end = clamped && (i <= degree || i >= count);
            if (i == 0 || (clamped && (i == degree + 1 || i == count)) || (!end && (run > degree || uniform() < 0.6))) {
                u += 0.1 + uniform();
                run = 0;
            }
            u_of[i] = u;
            run++;
        }
    } while (!(u_of[degree] < u_of[count]));
    u_of[count + degree + 1] = NAN; /* nobody looks behind the last */
    for (int m = 0; m < 3 * MOST_POINTS; m++)
        P_of[m] = 10 * uniform() - 4;
    for (int i = 0; i < MOST_POINTS; i++)
        w_of[i] = (const double[]){1, 0.5, 4, 2, 0.25}[(int)(5 * uniform())];
    P_of[count * dim] = w_of[count] = NAN;
    int span = degree;
    while (!(u_of[span] < u_of[span + 1]) || (span < count - 1 && uniform() < 0.5 && u_of[span + 1] < u_of[count]))
        span++;
    return (struct arguments){.s = {degree, count, dim, u_of, P_of, rational ? w_of : NULL},
                              .t = u_of[span] + (u_of[span + 1] - u_of[span]) * (0.1 + 0.8 * uniform()),
                              .order = 2,
                              .span = span,
                              .out = {results[0], results[1], results[2], results[3], results[4], results[5]},
                              .whole = {whole, whole + 1}};
}

/* Homogeneous points of a curve; of one without weights the points. */
static int homogeneous(const cagd_spline *s, double H[])
{
    if (s->weights != NULL)
        rational_homogenize_d(s->count - 1, s->dim, s->points, s->weights, H);
    else
        memcpy(H, s->points, (size_t)(s->count * s->dim) * sizeof *H);
    return s->dim + (s->weights != NULL);
}
/* Results r of points, and behind them of weights, are these homogeneous points. */
static void are_points(const cagd_spline *s, int r, int count, const double H[])
{
    double R[LONGEST], w[LONGEST];
    if (s->weights != NULL) {
        rational_dehomogenize_d(count - 1, s->dim, H, R, w);
        same(count, results[r + 1], w);
        so_many_are_written(r + 1, count);
    } else {
        memcpy(R, H, (size_t)(count * s->dim) * sizeof *R);
        so_many_are_written(r + 1, 0);
    }
    same(count * s->dim, results[r], R);
    so_many_are_written(r, count * s->dim);
}

/* In degrees 0, ..., 6, of dimension 1 to 3, clamped or not, with weights or without, at knots of every multiplicity and between: the results
 * are the kernel's, as many as the header says. */
static void every_degree_and_dimension_has_the_kernels_values(void **state)
{
    (void)state;
    enum { TRIALS = 252 };
    int at_knots = 0, full = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        int p = trial % (MOST_DEGREE + 1), n = p + 1 + (int)(uniform() * 10), dim = 1 + trial / 7 % 3, size;
        struct arguments x = some_spline(p, n, dim, trial / 21 % 2, trial / 42 % 2);
        const cagd_spline *s = x.spline = &x.s;
        double H[LONGEST], a[LONGEST], b[LONGEST], c[LONGEST], d[LONGEST];
        size = homogeneous(s, H);
        const struct spline_d h = {p, n, size, u_of, H, NULL};
        for (int knot = p - 1; knot <= n; knot++) {
            if (knot >= p)
                x.t = u_of[knot];
            x.side = knot % 2 ? CAGD_LEFT : CAGD_RIGHT;
            x.order = (knot + 1 + trial) % (p + 3);
            int first = p, last = n - 1, mu = p, times = 0; /* the span by its definition */
            while (!(u_of[first] < u_of[first + 1]))
                first++;
            while (!(u_of[last] < u_of[last + 1]))
                last--;
            for (int i = first; i <= last; i++)
                if (x.side == CAGD_LEFT ? u_of[i] < x.t : u_of[i] <= x.t)
                    mu = i;
            mu = mu < first ? first : mu > last ? last : mu;
            while (!(u_of[mu] < u_of[mu + 1]))
                mu--;
            for (int i = 0; i <= n + p; i++)
                times += u_of[i] == x.t;
            int right = mu; /* the span on the right of t */
            while (right < last && u_of[right + 1] <= x.t)
                right++;
            at_knots += times > 0;
            full += times == p + 1 && u_of[p] < x.t && x.t < u_of[n];
            mark();
            assert_int_equal(span_of(&x), CAGD_OK);
            assert_int_equal(whole[0], mu);
            mark();
            assert_int_equal(basis(&x), CAGD_OK);
            assert_int_equal(whole[0], mu);
            bspline_basis_derivatives_d(p, u_of, mu, x.t, x.order, a);
            same((x.order + 1) * (p + 1), results[0], a);
            so_many_are_written(0, (x.order + 1) * (p + 1));
            if (s->weights != NULL)
                nurbs_derivatives_d(nurbs_on_span_d(p, dim, u_of, mu, P_of, w_of), x.t, x.order < 3 ? 3 : x.order, a);
            else
                bspline_derivatives_d(on_span_d(p, dim, u_of, mu, P_of), x.t, x.order < 3 ? 3 : x.order, a);
            mark();
            assert_int_equal(derivatives(&x), CAGD_OK);
            same((x.order + 1) * dim, results[0], a);
            so_many_are_written(0, (x.order + 1) * dim);
            mark();
            assert_int_equal(point(&x), CAGD_OK);
            same(dim, results[0], a);
            so_many_are_written(0, dim);
            if (dim > 1 && p > 1) {
                mark();
                assert_int_equal(curvature(&x), CAGD_OK);
                so_many_are_written(0, 1);
                assert_true(fabs(results[0][0] - curvature_d(dim, a + dim, a + 2 * dim)) <= 1e-9 * results[0][0]);
            }
            if (dim > 2 && p > 2) {
                mark();
                assert_int_equal(torsion(&x), CAGD_OK);
                so_many_are_written(0, 1);
                assert_true(fabs(results[0][0] - torsion_d(a + 3, a + 6, a + 9)) <= 1e-6 * fabs(results[0][0]));
            }
            mark();
            cagd_status expected = !(x.t < u_of[n]) ? CAGD_OUTSIDE_DOMAIN : times > p ? CAGD_KNOTS_MULTIPLE : CAGD_OK;
            assert_int_equal(insert(&x), expected);
            if (expected != CAGD_OK)
                nothing_is_written();
            else {
                if (s->weights != NULL)
                    nurbs_insert_d(s, right, x.t, b, a, c);
                else
                    bspline_insert_d(s, right, x.t, b, a);
                same(n + p + 2, results[0], b);
                same((n + 1) * dim, results[1], a);
                so_many_are_written(0, n + p + 2);
                so_many_are_written(1, (n + 1) * dim);
                so_many_are_written(2, s->weights != NULL ? n + 1 : 0);
                if (s->weights != NULL)
                    same(n + 1, results[2], c);
            }
            mark();
            expected = u_of[p] < x.t && x.t < u_of[n] ? CAGD_OK : CAGD_OUTSIDE_DOMAIN;
            assert_int_equal(split_counts(&x), expected);
            if (expected == CAGD_OK) {
                assert_int_equal(whole[0], right - times + 1);
                assert_int_equal(whole[1], n - right + p);
                mark();
                assert_int_equal(split(&x), CAGD_OK);
                bspline_split_d(&h, right, times, x.t, a, b, c, d);
                same(right - times + p + 2, results[0], a);
                so_many_are_written(0, right - times + p + 2);
                are_points(s, 1, right - times + 1, b);
                same(n - right + 2 * p + 1, results[3], c);
                so_many_are_written(3, n - right + 2 * p + 1);
                are_points(s, 4, n - right + p, d);
            } else {
                nothing_is_written();
                assert_int_equal(split(&x), CAGD_OUTSIDE_DOMAIN);
                nothing_is_written();
            }
        }
        for (x.span = p - 2; x.span <= n + 1; x.span++) {
            int is_span = p <= x.span && x.span < n && u_of[x.span] < u_of[x.span + 1];
            mark();
            assert_int_equal(bezier(&x), is_span ? CAGD_OK : CAGD_OUTSIDE_DOMAIN);
            if (is_span) {
                bspline_to_bezier_d(on_span_d(p, size, u_of, x.span, H), a);
                are_points(s, 0, p + 1, a);
            } else
                nothing_is_written();
        }
        int m, span[LONGEST];
        mark();
        assert_int_equal(elevated_count(&x), CAGD_OK);
        m = whole[0];
        assert_int_equal(elevate(&x), CAGD_OK);
        so_many_are_written(0, m + p + 2);
        double
            raised[LONGEST]; /* every knot once more; of them p+2 up to the last u_p, and p+2 from the first u_n on */
        int all = 0, start = 0, end = 0;
        for (int i = 0; i <= n + p; i++)
            for (int copies = i == n + p || u_of[i] < u_of[i + 1] ? 2 : 1; copies > 0; copies--)
                raised[all++] = u_of[i];
        for (int i = 0; i < all; i++) {
            start = raised[i] == u_of[p] ? i - p - 1 : start;
            end += raised[i] < u_of[n];
        }
        assert_int_equal(m, end - start);
        same(m + p + 2, results[0], raised + start);
        assert_true(spans_of_points_d(n, p, u_of, m, p + 1, results[0], span));
        bspline_elevate_d(&h, m, results[0], span, a);
        are_points(s, 1, m, a);
    }
    assert_true(at_knots > TRIALS && full > 10);
}

/* Each pointer to a result, and the spline, its knots and, where they are looked at, its points; a place for weights where there are any. */
static void no_pointer_may_be_missing(void **state)
{
    (void)state;
    for (int k = 0; k < FUNCTIONS; k++)
        for (int rational = 0; rational < 2; rational++)
            for (int which = -3; which < functions[k].results + functions[k].whole; which++) {
                struct arguments x = some_spline(3, 9, 3, rational, 1);
                int optional = which == -1 ? !takes(k, 'P')
                                           : which >= 0 && which < functions[k].results && !rational &&
                                                 (functions[k].weights >> which & 1);
                x.spline = which == -3 ? NULL : &x.s;
                if (which == -2)
                    x.s.knots = NULL;
                else if (which == -1)
                    x.s.points = NULL;
                else if (which >= functions[k].results)
                    x.whole[which - functions[k].results] = NULL;
                else if (which >= 0)
                    x.out[which] = NULL;
                mark();
                assert_int_equal(functions[k].run(&x), optional ? CAGD_OK : CAGD_NULL);
                if (!optional)
                    nothing_is_written();
            }
}

static void every_range_has_two_ends(void **state)
{
    (void)state;
    static double clamped[4 * CAGD_MAX_DEGREE], P_of_many[3 * (2 * CAGD_MAX_DEGREE)],
        many[CAGD_MAX_DEGREE + 2][LONGEST];
    for (int k = 0; k < FUNCTIONS; k++) {
        for (int degree = -2; degree <= CAGD_MAX_DEGREE + 2; degree++)
            for (int more = -1; more <= 1; more++) {
                struct arguments x = some_spline(3, 9, 3, 0, 1);
                for (int i = 0; i < 2 * degree + 2 + more && i < 4 * CAGD_MAX_DEGREE; i++)
                    clamped[i] = i <= degree ? 0 : i >= degree + 1 + more ? 1 : 0.5;
                for (int m = 0; m < 3 * (2 * CAGD_MAX_DEGREE); m++)
                    P_of_many[m] = uniform();
                x.s = (cagd_spline){degree, degree + 1 + more, 3, clamped, P_of_many, NULL};
                x.spline = &x.s;
                x.t = 0.25, x.span = degree, x.order = 0;
                for (int r = 0; r < RESULTS; r++)
                    x.out[r] = many[10 * r]; /* ten lines for each result */
                int highest = functions[k].run == elevate || functions[k].run == elevated_count ? CAGD_MAX_DEGREE - 1
                                                                                                : CAGD_MAX_DEGREE;
                cagd_status status = functions[k].run(&x), expected = degree < 0 || degree > highest ? CAGD_DEGREE
                                                                      : more < 0                     ? CAGD_COUNT
                                                                                                     : CAGD_OK;
                if (degree > highest && more < 0)
                    assert_true(status == CAGD_DEGREE || status == CAGD_COUNT);
                else if (expected != CAGD_OK || (degree > 2 && degree < 20))
                    assert_int_equal(status, expected);
                else
                    assert_true(status == CAGD_OK || ((functions[k].run == curvature || functions[k].run == torsion) &&
                                                      status == CAGD_UNDEFINED));
            }
        for (int dim = -1; dim <= CAGD_MAX_DIM + 2; dim++) {
            struct arguments x = some_spline(3, 9, 3, 1, 1);
            x.spline = &x.s;
            x.s.dim = dim;
            mark();
            int has = !takes(k, 'P') || (functions[k].from_dim <= dim && dim <= CAGD_MAX_DIM);
            assert_int_equal(functions[k].run(&x), has ? CAGD_OK : CAGD_DIMENSION);
            if (!has)
                nothing_is_written();
        }
        for (int order = -2; order <= CAGD_MAX_DEGREE + 2 && takes(k, 'O'); order++) {
            struct arguments x = some_spline(3, 9, 3, 1, 1);
            x.spline = &x.s;
            x.order = order;
            mark();
            int has = 0 <= order && order <= CAGD_MAX_DEGREE;
            assert_int_equal(functions[k].run(&x), has ? CAGD_OK : CAGD_ORDER);
            if (!has)
                nothing_is_written();
        }
        for (int clamp = 0; clamp < 2 && takes(k, 'T'); clamp++)
            for (int which = 0; which < 7; which++) {
                struct arguments x = some_spline(3, 9, 3, 1, clamp);
                double from = u_of[3], to = u_of[9];
                x.spline = &x.s;
                x.side = which % 2 ? CAGD_LEFT : CAGD_RIGHT;
                x.t = (double[]){
                    nextafter(from, -9), nextafter(to, 99), -DBL_MAX, DBL_MAX, NAN, INFINITY, -INFINITY}[which];
                mark();
                assert_int_equal(functions[k].run(&x), which < 4 ? CAGD_OUTSIDE_DOMAIN : CAGD_NOT_FINITE);
                nothing_is_written();
            }
    }
}

/* Whichever knot, coordinate or weight it is, and none behind the last. */
static void every_number_is_asked_for(void **state)
{
    (void)state;
    const double none[] = {NAN, INFINITY, -INFINITY};
    for (int p = 0; p < 4; p++)
        for (int dim = 1; dim <= 3; dim++)
            for (int k = -1; k < FUNCTIONS; k++) {
                struct arguments x = some_spline(p, p + 4, dim, 1, 1);
                x.spline = &x.s;
                if (k >= 0 && dim < functions[k].from_dim)
                    continue;
                for (int kind = 0; kind < 3; kind++) {
                    double *of = kind == 0 ? u_of : kind == 1 ? P_of : w_of;
                    int count = kind == 0 ? 2 * p + 5 : (p + 4) * (kind == 1 ? dim : 1), where = 7;
                    for (int i = 0; i < count; i++) {
                        double keep = of[i];
                        of[i] = none[(i + kind + k + 1) % 3];
                        mark();
                        if (k < 0) {
                            assert_int_equal(cagd_spline_check(&x.s, &where), CAGD_NOT_FINITE);
                            assert_int_equal(where, i);
                        } else if (kind == 0 || takes(k, 'P')) {
                            assert_int_equal(functions[k].run(&x), CAGD_NOT_FINITE);
                            nothing_is_written();
                        }
                        of[i] = keep;
                    }
                }
                if (k < 0) {
                    int where = 7;
                    assert_int_equal(cagd_spline_check(&x.s, &where), CAGD_OK);
                    assert_int_equal(where, -1);
                }
            }
}

/* Of knots 0, 1, 2, ... any one may be smaller than the one before it, or one too many of its kind; a curve over a domain without length is none. */
static void every_knot_is_compared(void **state)
{
    (void)state;
    for (int p = 0; p < 4; p++) {
        enum { MORE = 5 };
        int n = p + MORE, last = n + p, where;
        struct arguments x = some_spline(p, n, 2, 0, 1);
        for (int i = 1; i <= last; i++) {
            for (int j = 0; j <= last; j++)
                u_of[j] = j;
            u_of[i] = i - 1.5;
            where = 7;
            assert_int_equal(cagd_spline_check(&x.s, &where), CAGD_KNOTS_DECREASE);
            assert_int_equal(where, i);
            for (int j = 0; j <= last; j++) /* p+2 knots that are equal, the last of them i */
                u_of[j] = j > i || j < i - p - 1 ? j : i;
            where = 7;
            assert_int_equal(cagd_spline_check(&x.s, &where), i > p ? CAGD_KNOTS_MULTIPLE : CAGD_OK);
            assert_int_equal(where, i > p ? i : -1);
            for (int j = 0; j <= last; j++) /* p+1 of them */
                u_of[j] = j > i || j < i - p ? j : i;
            assert_int_equal(cagd_spline_check(&x.s, &where), CAGD_OK);
        }
        for (int j = 0; j <= 2 * p + 1;
             j++) /* the domain is [u_p, u_{p+1}]; in degree 0 its ends are equal once too often */
            u_of[j] = j <= p ? j : j - 1;
        x.s.count = p + 1;
        assert_int_equal(cagd_spline_check(&x.s, &where), p > 0 ? CAGD_KNOTS_EMPTY : CAGD_KNOTS_MULTIPLE);
        assert_int_equal(where, p > 0 ? p : 1);
    }
}

/* Weights that are 0, in any place, are no weights of a part, of a segment or of the same curve in another form. */
static void a_weight_of_a_result_is_not_zero(void **state)
{
    (void)state;
    for (int zero = 0; zero < 6; zero++) {
        const double lines[] = {0, 0, 1, 2, 3, 4, 5, 5};
        struct arguments x = some_spline(1, 6, 3, 1, 1);
        x.spline = &x.s;
        memcpy(u_of, lines, sizeof lines);
        for (int i = 0; i < 6; i++)
            w_of[i] = i != zero;
        for (int span = 1; span < 6; span++) {
            x.span = span;
            assert_int_equal(bezier(&x), zero == span - 1 || zero == span ? CAGD_UNDEFINED : CAGD_OK);
            x.t = span - 0.5; /* between two points, of which none is replaced */
            assert_int_equal(split(&x), CAGD_UNDEFINED);
            assert_int_equal(insert(&x), CAGD_UNDEFINED);
        }
        assert_int_equal(elevate(&x), CAGD_UNDEFINED);
        for (int k = 0; k <= 5; k++) { /* the point at t = k has weight k alone */
            x.t = k;
            assert_int_equal(point(&x), k == zero ? CAGD_UNDEFINED : CAGD_OK);
            assert_int_equal(derivatives(&x), k == zero ? CAGD_UNDEFINED : CAGD_OK);
            x.side = CAGD_LEFT;
            assert_int_equal(point(&x), k == zero ? CAGD_UNDEFINED : CAGD_OK);
            x.side = CAGD_RIGHT;
        }
    }
}

/* Of numbers near both ends of binary64, over knots that are close or far apart: what is said to be good is a number, and no weight of it is 0. */
static void what_is_good_is_a_number(void **state)
{
    (void)state;
    const double values[] = {0, 1, -2, DBL_MAX, -DBL_MAX, 0x1p-1040, 0x1p1000, -0x1p-600, 0.75};
    enum { TRIED = 1500 };
    for (int k = 0; k < FUNCTIONS; k++) {
        int seen[CAGD_STATUSES] = {0};
        for (int trial = 0; trial < TRIED; trial++) {
            int p = trial % 4, n = p + 1 + trial / 4 % 4, dim = 1 + trial / 16 % 3;
            struct arguments x = some_spline(p, n, dim, trial / 48 % 2, trial / 96 % 2);
            x.spline = &x.s;
            x.order = trial % 5;
            x.side = uniform() < 0.5 ? CAGD_LEFT : CAGD_RIGHT;
            int scale = (int)(3 * uniform()) * 500 - 500,
                tame = (int)(3 * uniform()); /* of neither, of points, of weights */
            for (int i = 0; i <= n + p; i++)
                u_of[i] = ldexp(u_of[i], scale);
            x.t = ldexp(x.t, scale);
            for (int m = 0; m < n * dim && tame != 1; m++)
                P_of[m] = uniform() < 0.3 ? values[(int)(9 * uniform())] : 0;
            for (int i = 0; i < n && tame != 2; i++)
                w_of[i] = uniform() < 0.3 ? values[(int)(9 * uniform())] : 1;
            if (dim < functions[k].from_dim)
                continue;
            mark();
            cagd_status status = functions[k].run(&x);
            seen[status]++;
            assert_true(status == CAGD_OK || status == CAGD_OVERFLOW || status == CAGD_UNDEFINED);
            for (int r = 0; r < functions[k].results && status == CAGD_OK; r++)
                for (int m = 0; m < LONGEST; m++) {
                    assert_true(isfinite(results[r][m]));
                    assert_true(results[r][m] != 0 || !(functions[k].weights >> r & 1));
                }
        }
        assert_true(seen[CAGD_OK] > TRIED / 100);
        assert_true(seen[CAGD_OVERFLOW] > 2 || functions[k].results == 0);
    }
}

/* The second derivatives alone of quadratics over [0, 2^-600] are beyond the range, and the first and the values are not, in the middle of the row as at its ends. */
static void derivatives_of_a_basis_that_are_out_of_range(void **state)
{
    (void)state;
    for (int order = 0; order <= 4; order++)
        for (int p = 1; p <= 3; p++) {
            struct arguments x = some_spline(p, p + 1, 1, 0, 1);
            x.spline = &x.s;
            for (int i = 0; i < 2 * p + 2; i++)
                u_of[i] = i <= p ? 0 : 0x1p-600;
            x.t = 0x1p-601;
            x.order = order;
            assert_int_equal(basis(&x), order < 2 || p < 2 ? CAGD_OK : CAGD_OVERFLOW);
        }
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
        cmocka_unit_test(every_degree_and_dimension_has_the_kernels_values),
        cmocka_unit_test(no_pointer_may_be_missing),
        cmocka_unit_test(every_range_has_two_ends),
        cmocka_unit_test(every_number_is_asked_for),
        cmocka_unit_test(every_knot_is_compared),
        cmocka_unit_test(a_weight_of_a_result_is_not_zero),
        cmocka_unit_test(what_is_good_is_a_number),
        cmocka_unit_test(derivatives_of_a_basis_that_are_out_of_range),
    };
    return cmocka_run_group_tests(tests, setup, NULL);
}
