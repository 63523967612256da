/* test_curve_api.c -- prepared curves: bit for bit the values of the functions on the spline, one at a time, for arrays of
 * parameters and from several threads at once; what is refused, and what is left as it was. */
#include "core/api/cagd.h"

#include <float.h>
#include <math.h>
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MOST = 40, MOST_DEGREE = 7, PARAMETERS = 67, ORDER = 4, THREADS = 4, TURNS = 50 };

/* The next of a sequence of numbers in [0, 1). */
static double uniform(void)
{
    static unsigned long long x = 20201;
    x = x * 6364136223846793005u + 1442695040888963407u;
    return (double)(x >> 11) * 0x1p-53;
}

static double knots[MOST + MOST_DEGREE + 1], points[3 * MOST], weights[MOST], parameters[PARAMETERS];

/* A curve over knots of all multiplicities that the degree allows, not clamped, and parameters on and between the knots. */
static cagd_spline random_spline(int degree, int count, int dim, int rational)
{
    double u = -3.7;
    for (int i = 0, run = 1; i < count + degree + 1; i++) {
        if (run > degree || uniform() < 0.6) {
            u += 0.1 + uniform();
            run = 0;
        }
        knots[i] = u;
        run++;
    }
    if (knots[degree] == knots[count])
        knots[count] = knots[count + degree] = u += 1;
    for (int i = count; i < count + degree + 1; i++)
        knots[i] = fmax(knots[i], knots[count]);
    for (int m = 0; m < 3 * MOST; m++)
        points[m] = 10 * uniform() - 4;
    for (int i = 0; i < MOST; i++)
        weights[i] = 0.2 + 3 * uniform();
    double from = knots[degree], to = knots[count];
    for (int i = 0; i < PARAMETERS; i++)
        parameters[i] = i < count - degree ? knots[degree + i] : fmin(to, from + (to - from) * uniform());
    return (cagd_spline){degree, count, dim, knots, points, rational ? weights : NULL};
}

static void same(size_t count, const double a[], const double b[]) { assert_memory_equal(a, b, count * sizeof *a); }

/* One curve with everything that is computed of it. */
struct values {
    cagd_curve *curve;
    int dim;
    double D[PARAMETERS * (ORDER + 1) * 3], P[PARAMETERS * 3], curvature[PARAMETERS], torsion[PARAMETERS];
};

static void evaluate_all(struct values *v, cagd_side side)
{
    int where = 7;
    assert_int_equal(cagd_curve_all_derivatives(v->curve, PARAMETERS, parameters, side, ORDER, v->D, &where), CAGD_OK);
    assert_int_equal(where, -1);
    assert_int_equal(cagd_curve_points(v->curve, PARAMETERS, parameters, side, v->P, NULL), CAGD_OK);
    if (v->dim > 1)
        assert_int_equal(cagd_curve_curvatures(v->curve, PARAMETERS, parameters, side, v->curvature, NULL), CAGD_OK);
    if (v->dim == 3)
        assert_int_equal(cagd_curve_torsions(v->curve, PARAMETERS, parameters, side, v->torsion, NULL), CAGD_OK);
}

static void values_are_those_of_the_spline(void **state)
{
    (void)state;
    for (int trial = 0; trial < 200; trial++) {
        int degree = 2 + trial % (MOST_DEGREE - 1), count = degree + 1 + (int)(uniform() * 30), dim = 1 + trial % 3;
        cagd_spline s = random_spline(degree, count, dim, trial % 2);
        cagd_status status = CAGD_NULL;
        int where = 7;
        struct values v = {.curve = cagd_curve_new(&s, &status, &where), .dim = dim};
        assert_int_equal(status, CAGD_OK);
        assert_int_equal(where, -1);
        for (int side = CAGD_RIGHT; side <= CAGD_LEFT; side++) {
            evaluate_all(&v, (cagd_side)side);
            for (int i = 0; i < PARAMETERS; i++) {
                double t = parameters[i], D[(ORDER + 1) * 3], E[(ORDER + 1) * 3], x;
                size_t row = (size_t)dim, all = (ORDER + 1) * row, at = (size_t)i;
                assert_int_equal(cagd_spline_derivatives(&s, t, (cagd_side)side, ORDER, D), CAGD_OK);
                same(all, D, v.D + at * all);
                same(row, D, v.P + at * row);
                assert_int_equal(cagd_curve_derivatives(v.curve, t, (cagd_side)side, ORDER, E), CAGD_OK);
                same(all, D, E);
                assert_int_equal(cagd_curve_point(v.curve, t, (cagd_side)side, E), CAGD_OK);
                same(row, D, E);
                if (dim > 1) {
                    assert_int_equal(cagd_spline_curvature(&s, t, (cagd_side)side, &x), CAGD_OK);
                    same(1, &x, v.curvature + i);
                    assert_int_equal(cagd_curve_curvature(v.curve, t, (cagd_side)side, &x), CAGD_OK);
                    same(1, &x, v.curvature + i);
                }
                if (dim == 3 && degree > 2) {
                    assert_int_equal(cagd_spline_torsion(&s, t, (cagd_side)side, &x), CAGD_OK);
                    same(1, &x, v.torsion + i);
                    assert_int_equal(cagd_curve_torsion(v.curve, t, (cagd_side)side, &x), CAGD_OK);
                    same(1, &x, v.torsion + i);
                }
            }
        }
        cagd_curve_free(v.curve);
    }
}

/* The copy does not hang on what it was made of. */
static void the_spline_may_go(void **state)
{
    (void)state;
    cagd_spline s = random_spline(3, 12, 3, 1);
    cagd_curve *curve = cagd_curve_new(&s, NULL, NULL);
    double before[3], after[3], t = parameters[20];
    assert_int_equal(cagd_curve_point(curve, t, CAGD_RIGHT, before), CAGD_OK);
    memset(knots, 0, sizeof knots);
    memset(points, 0, sizeof points);
    memset(weights, 0, sizeof weights);
    assert_int_equal(cagd_curve_point(curve, t, CAGD_RIGHT, after), CAGD_OK);
    same(3, before, after);
    cagd_curve_free(curve);
    cagd_curve_free(NULL);
}

struct work {
    const cagd_curve *curve;
    const struct values *expected;
    int different;
};

static void *evaluate_in_thread(void *argument)
{
    struct work *w = argument;
    struct values *v = malloc(sizeof *v);
    if (v == NULL)
        return NULL;
    for (int turn = 0; turn < TURNS; turn++) {
        *v = (struct values){0};
        w->different += cagd_curve_points(w->curve, PARAMETERS, parameters, CAGD_RIGHT, v->P, NULL) != CAGD_OK;
        w->different += cagd_curve_torsions(w->curve, PARAMETERS, parameters, CAGD_RIGHT, v->torsion, NULL) != CAGD_OK;
        for (int i = 0; i < PARAMETERS; i++)
            w->different += cagd_curve_curvature(w->curve, parameters[i], CAGD_RIGHT, v->curvature + i) != CAGD_OK;
        w->different += memcmp(v->P, w->expected->P, sizeof v->P) != 0;
        w->different += memcmp(v->torsion, w->expected->torsion, sizeof v->torsion) != 0;
        w->different += memcmp(v->curvature, w->expected->curvature, sizeof v->curvature) != 0;
    }
    free(v);
    return NULL;
}

static void threads_share_a_curve(void **state)
{
    (void)state;
    cagd_spline s = random_spline(4, 25, 3, 1);
    struct values expected = {.curve = cagd_curve_new(&s, NULL, NULL), .dim = 3};
    evaluate_all(&expected, CAGD_RIGHT);
    pthread_t thread[THREADS];
    struct work work[THREADS];
    for (int k = 0; k < THREADS; k++) {
        work[k] = (struct work){expected.curve, &expected, 0};
        assert_int_equal(pthread_create(&thread[k], NULL, evaluate_in_thread, &work[k]), 0);
    }
    for (int k = 0; k < THREADS; k++) {
        assert_int_equal(pthread_join(thread[k], NULL), 0);
        assert_int_equal(work[k].different, 0);
    }
    cagd_curve_free(expected.curve);
}

static void what_is_wrong_is_refused(void **state)
{
    (void)state;
    cagd_spline s = random_spline(3, 9, 2, 1), bad = s;
    double out[64], spare[64], t[3] = {knots[3], knots[9], knots[9] + 1}, huge = HUGE_VAL;
    cagd_status status;
    int where;
    for (int i = 0; i < 64; i++)
        out[i] = spare[i] = 77;
    bad.degree = -1;
    assert_null(cagd_curve_new(&bad, &status, &where));
    assert_int_equal(status, CAGD_DEGREE);
    assert_null(cagd_curve_new(NULL, &status, NULL));
    assert_int_equal(status, CAGD_NULL);
    bad = s;
    bad.count = INT32_MAX;
    assert_null(cagd_curve_new(&bad, &status, NULL));
    assert_int_equal(status, CAGD_COUNT);
    cagd_curve *c = cagd_curve_new(&s, NULL, NULL);
    assert_int_equal(cagd_curve_point(NULL, t[0], CAGD_RIGHT, out), CAGD_NULL);
    assert_int_equal(cagd_curve_point(c, t[0], CAGD_RIGHT, NULL), CAGD_NULL);
    assert_int_equal(cagd_curve_point(c, t[2], CAGD_RIGHT, out), CAGD_OUTSIDE_DOMAIN);
    assert_int_equal(cagd_curve_point(c, knots[3] - 1, CAGD_LEFT, out), CAGD_OUTSIDE_DOMAIN);
    assert_int_equal(cagd_curve_point(c, NAN, CAGD_RIGHT, out), CAGD_NOT_FINITE);
    assert_int_equal(cagd_curve_point(c, -huge, CAGD_LEFT, out), CAGD_NOT_FINITE);
    assert_int_equal(cagd_curve_derivatives(c, t[0], CAGD_RIGHT, -1, out), CAGD_ORDER);
    assert_int_equal(cagd_curve_derivatives(c, t[0], CAGD_RIGHT, CAGD_MAX_DEGREE + 1, out), CAGD_ORDER);
    assert_int_equal(cagd_curve_torsion(c, t[0], CAGD_RIGHT, out), CAGD_DIMENSION);
    assert_int_equal(cagd_curve_points(c, -1, t, CAGD_RIGHT, out, &where), CAGD_COUNT);
    assert_int_equal(cagd_curve_points(c, 1, NULL, CAGD_RIGHT, out, &where), CAGD_NULL);
    assert_int_equal(cagd_curve_torsions(c, 1, t, CAGD_RIGHT, out, &where), CAGD_DIMENSION);
    assert_int_equal(where, -1);
    assert_int_equal(cagd_curve_points(c, 0, t, CAGD_RIGHT, out, &where), CAGD_OK);
    same(64, out, spare);
    assert_int_equal(cagd_curve_points(c, 3, t, CAGD_RIGHT, out, &where), CAGD_OUTSIDE_DOMAIN);
    assert_int_equal(where, 2);
    same(60, out + 4, spare + 4);
    cagd_curve_free(c);
    s.dim = 1;
    c = cagd_curve_new(&s, NULL, NULL);
    assert_int_equal(cagd_curve_curvature(c, t[0], CAGD_RIGHT, out), CAGD_DIMENSION);
    cagd_curve_free(c);
}

static void what_has_no_value_is_told(void **state)
{
    (void)state;
    const double line[4] = {0, 0, 1, 1}, still[4] = {2, 3, 2, 3}, cancel[2] = {1, -1},
                 far[4] = {DBL_MAX, 1, -DBL_MAX, 1};
    const double t[2] = {0.25, 0.5}, large[2] = {4, 4};
    cagd_spline s = {1, 2, 2, line, still, cancel}, r = {1, 2, 2, line, still, NULL}, f = {1, 2, 2, line, far, large};
    double out[8];
    int where;
    cagd_curve *c = cagd_curve_new(&s, NULL, NULL);
    assert_int_equal(cagd_curve_points(c, 2, t, CAGD_RIGHT, out, &where), CAGD_UNDEFINED);
    assert_int_equal(where, 1);
    assert_int_equal(cagd_curve_derivatives(c, 0.5, CAGD_RIGHT, 1, out), CAGD_UNDEFINED);
    cagd_curve_free(c);
    c = cagd_curve_new(&r, NULL, NULL);
    assert_int_equal(cagd_curve_curvature(c, 0.5, CAGD_RIGHT, out), CAGD_UNDEFINED);
    cagd_curve_free(c);
    c = cagd_curve_new(&f, NULL, NULL);
    assert_int_equal(cagd_curve_point(c, 0.5, CAGD_RIGHT, out), CAGD_OVERFLOW);
    cagd_curve_free(c);
    /* in every dimension, as a point and with derivatives, in degree 5 as in degree 1 */
    const double knot[12] = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1}, at[18] = {0}, signs[6] = {1, 1, 1, -1, -1, -1};
    for (int dim = 1; dim <= 3; dim++)
        for (int p = 1; p <= 5; p += 2) {
            const cagd_spline pole = {p, p + 1, dim, knot + 5 - p, at, signs + (5 - p) / 2};
            c = cagd_curve_new(&pole, NULL, NULL);
            assert_non_null(c);
            assert_int_equal(cagd_curve_point(c, 0.5, CAGD_RIGHT, out), CAGD_UNDEFINED);
            assert_int_equal(cagd_curve_points(c, 2, t, CAGD_RIGHT, out, &where), CAGD_UNDEFINED);
            assert_int_equal(where, 1);
            assert_int_equal(cagd_curve_derivatives(c, 0.5, CAGD_RIGHT, 1, out), CAGD_UNDEFINED);
            assert_int_equal(cagd_curve_point(c, 0.25, CAGD_RIGHT, out), CAGD_OK);
            cagd_curve_free(c);
        }
}

/* Over knots that are not clamped the domain is [3, 4]: the spans before and behind it are none, for an array of parameters as for one. */
static void outside_the_domain_is_no_span(void **state)
{
    (void)state;
    const double integers[8] = {0, 1, 2, 3, 4, 5, 6, 7}, P[4] = {2, 3, 5, 7};
    const cagd_spline s = {3, 4, 1, integers, P, NULL};
    cagd_curve *c = cagd_curve_new(&s, NULL, NULL);
    assert_non_null(c);
    for (int k = 0; k < 14; k++) {
        const double t = k / 2.0;
        const cagd_status expected = t < 3 || t > 4 ? CAGD_OUTSIDE_DOMAIN : CAGD_OK;
        for (int side = 0; side < 2; side++) {
            double out[1];
            int where;
            assert_int_equal(cagd_curve_point(c, t, side ? CAGD_LEFT : CAGD_RIGHT, out), expected);
            assert_int_equal(cagd_curve_points(c, 1, &t, side ? CAGD_LEFT : CAGD_RIGHT, out, &where), expected);
            assert_int_equal(where, expected == CAGD_OK ? -1 : 0);
        }
    }
    cagd_curve_free(c);
}

/* Of the points 0, whose total weight t/3 DBL_MAX + (3 - t)/3 DBL_MAX is rounded beyond the range for some t, and of a parabola whose third
 * coordinate alone has a second derivative that is. */
static void the_last_number_that_is_out_of_range_is_seen(void **state)
{
    (void)state;
    enum { TRIED = 1000 };
    const double line[4] = {0, 0, 3, 3}, zero[6] = {0}, largest[2] = {DBL_MAX, DBL_MAX};
    double out[9];
    int beyond = 0;
    for (int dim = 1; dim <= 3; dim++) {
        const cagd_spline s = {1, 2, dim, line, zero, largest};
        cagd_curve *c = cagd_curve_new(&s, NULL, NULL);
        assert_non_null(c);
        for (int k = 1; k < TRIED; k++) {
            const double t = 3.0 * k / TRIED;
            const cagd_status expected = isinf(t / 3 * DBL_MAX + (3 - t) / 3 * DBL_MAX) ? CAGD_OVERFLOW : CAGD_OK;
            beyond += expected == CAGD_OVERFLOW;
            assert_int_equal(cagd_curve_point(c, t, CAGD_RIGHT, out), expected);
            assert_int_equal(cagd_curve_derivatives(c, t, CAGD_RIGHT, 0, out), expected);
            assert_int_equal(cagd_curve_derivatives(c, t, CAGD_RIGHT, 1, out), expected);
        }
        cagd_curve_free(c);
    }
    assert_true(beyond > 0);
    const double knot[6] = {0, 0, 0, 1, 1, 1}, high = DBL_MAX / 4, P[9] = {1, 2, high, 3, 5, -high, 7, 4, high};
    const cagd_spline parabola = {2, 3, 3, knot, P, NULL};
    cagd_curve *c = cagd_curve_new(&parabola, NULL, NULL);
    assert_non_null(c);
    assert_int_equal(cagd_curve_derivatives(c, 0.25, CAGD_RIGHT, 1, out), CAGD_OK);
    assert_int_equal(cagd_curve_derivatives(c, 0.25, CAGD_RIGHT, 2, out), CAGD_OVERFLOW);
    assert_true(isfinite(out[7]) && isinf(out[8]));
    cagd_curve_free(c);
}

/* ---- every function of a prepared curve ----------------------------------------------------------------- */

/* One quantity at one parameter and at many, and of the spline itself. */
typedef cagd_status at_one(const cagd_curve *c, double t, cagd_side side, int order, double *out);
typedef cagd_status at_many(const cagd_curve *c, int count, const double *t, cagd_side side, int order, double *out,
                            int *where);
typedef cagd_status of_spline(const cagd_spline *s, double t, cagd_side side, int order, double *out);
#define WITHOUT_ORDER(name, one, many, spline)                                                                         \
    static cagd_status name##_one(const cagd_curve *c, double t, cagd_side side, int order, double *out)               \
    {                                                                                                                  \
        (void)order;                                                                                                   \
        return one(c, t, side, out);                                                                                   \
    }                                                                                                                  \
    static cagd_status name##_many(const cagd_curve *c, int count, const double *t, cagd_side side, int order,         \
                                   double *out, int *where)                                                            \
    {                                                                                                                  \
        (void)order;                                                                                                   \
        return many(c, count, t, side, out, where);                                                                    \
    }                                                                                                                  \
    static cagd_status name##_spline(const cagd_spline *s, double t, cagd_side side, int order, double *out)           \
    {                                                                                                                  \
        (void)order;                                                                                                   \
        return spline(s, t, side, out);                                                                                \
    }
WITHOUT_ORDER(point, cagd_curve_point, cagd_curve_points, cagd_spline_point)
WITHOUT_ORDER(curvature, cagd_curve_curvature, cagd_curve_curvatures, cagd_spline_curvature)
WITHOUT_ORDER(torsion, cagd_curve_torsion, cagd_curve_torsions, cagd_spline_torsion)

static const struct {
    at_one *one;
    at_many *many;
    of_spline *spline;
    int from_dim, has_order, is_point;
} quantities[] = {
    {point_one, point_many, point_spline, 1, 0, 1},
    {cagd_curve_derivatives, cagd_curve_all_derivatives, cagd_spline_derivatives, 1, 1, 1},
    {curvature_one, curvature_many, curvature_spline, 2, 0, 0},
    {torsion_one, torsion_many, torsion_spline, 3, 0, 0},
};
enum { QUANTITIES = 4, ROOM = PARAMETERS * (CAGD_MAX_DEGREE + 1) * 3 };
static double results[ROOM], expected[ROOM];
static void mark(double x[ROOM])
{
    for (int m = 0; m < ROOM; m++)
        x[m] = 77;
}
static void nothing_is_written(int from)
{
    for (int m = from; m < ROOM; m++)
        assert_true(results[m] == 77);
}

/* In every degree from 0 on, every dimension, order and side, in every order of parameters, those before, behind and at the ends of the domain
 * and those that are no numbers among them: status and bits are those of the functions on the spline, and the first without a value is named. */
static void every_degree_and_order_is_that_of_the_spline(void **state)
{
    (void)state;
    enum { TRIALS = 150, MANY = 24 };
    int refused[CAGD_STATUSES] = {0};
    for (int trial = 0; trial < TRIALS; trial++) {
        int degree = trial % 6, count = degree + 1 + (int)(uniform() * 8), dim = 1 + trial / 6 % 3;
        cagd_spline s = random_spline(degree, count, dim, trial / 18 % 2);
        if (cagd_spline_check(&s, NULL) != CAGD_OK)
            continue;
        if (s.weights != NULL && trial % 4 == 0)
            weights[(int)(count * uniform())] *= trial % 8 == 0 ? 0 : -1;
        cagd_curve *c = cagd_curve_new(&s, NULL, NULL);
        assert_non_null(c);
        double t[MANY];
        for (int i = 0; i < MANY; i++)
            t[i] = uniform() < 0.5 ? knots[degree + (int)((count - degree + 1) * uniform())]
                                   : parameters[(int)(PARAMETERS * uniform())];
        if (trial % 3 == 0)
            t[(int)(MANY * uniform())] = (const double[]){NAN,
                                                          INFINITY,
                                                          -INFINITY,
                                                          knots[degree] - 1,
                                                          knots[count] + 1,
                                                          nextafter(knots[count], 1e9),
                                                          nextafter(knots[degree], -1e9)}[trial / 3 % 7];
        for (int q = 0; q < QUANTITIES; q++) {
            if (dim < quantities[q].from_dim)
                continue;
            int order = quantities[q].has_order ? trial / 3 % (degree + 4) : 0,
                width = quantities[q].is_point ? (order + 1) * dim : 1;
            for (int side = CAGD_RIGHT; side <= CAGD_LEFT; side++) {
                int good = 0, where = 99;
                cagd_status status = CAGD_OK;
                mark(results), mark(expected);
                while (good < MANY && status == CAGD_OK) {
                    status = quantities[q].spline(&s, t[good], (cagd_side)side, order, expected + good * width);
                    double out[ROOM / PARAMETERS];
                    assert_int_equal(quantities[q].one(c, t[good], (cagd_side)side, order, out), status);
                    if (status == CAGD_OK)
                        same((size_t)width, out, expected + good++ * width);
                }
                refused[status]++;
                assert_int_equal(quantities[q].many(c, MANY, t, (cagd_side)side, order, results, &where), status);
                assert_int_equal(where, status == CAGD_OK ? -1 : good);
                same((size_t)(good * width), results, expected);
                nothing_is_written((good + 1) * width);
                mark(results);
                assert_int_equal(quantities[q].many(c, MANY, t, (cagd_side)side, order, results, NULL), status);
                same((size_t)(good * width), results, expected);
            }
        }
        cagd_curve_free(c);
    }
    assert_true(refused[CAGD_OK] > TRIALS && refused[CAGD_NOT_FINITE] > 5 && refused[CAGD_OUTSIDE_DOMAIN] > 5 &&
                refused[CAGD_UNDEFINED] > 5);
}

static void every_function_refuses_what_is_none(void **state)
{
    (void)state;
    for (int dim = 1; dim <= 3; dim++) {
        cagd_spline s = random_spline(3, 9, dim, 1);
        cagd_curve *c = cagd_curve_new(&s, NULL, NULL);
        const double t[2] = {parameters[20], parameters[21]};
        assert_non_null(c);
        for (int q = 0; q < QUANTITIES; q++) {
            int where, has = dim >= quantities[q].from_dim;
            mark(results);
            if (!has) {
                assert_int_equal(quantities[q].one(c, t[0], CAGD_RIGHT, 0, results), CAGD_DIMENSION);
                for (int count = 0; count < 3; count++)
                    assert_int_equal(quantities[q].many(c, count, t, CAGD_RIGHT, 0, results, (where = 9, &where)),
                                     CAGD_DIMENSION);
                assert_int_equal(where, -1);
                nothing_is_written(0);
                continue;
            }
            assert_int_equal(quantities[q].one(NULL, t[0], CAGD_RIGHT, 0, results), CAGD_NULL);
            assert_int_equal(quantities[q].one(c, t[0], CAGD_RIGHT, 0, NULL), CAGD_NULL);
            assert_int_equal(quantities[q].many(NULL, 2, t, CAGD_RIGHT, 0, results, (where = 9, &where)), CAGD_NULL);
            assert_int_equal(where, -1);
            assert_int_equal(quantities[q].many(c, 2, NULL, CAGD_RIGHT, 0, results, (where = 9, &where)), CAGD_NULL);
            assert_int_equal(where, -1);
            assert_int_equal(quantities[q].many(c, 2, t, CAGD_RIGHT, 0, NULL, (where = 9, &where)), CAGD_NULL);
            assert_int_equal(where, -1);
            assert_int_equal(quantities[q].many(c, 0, NULL, CAGD_RIGHT, 0, results, NULL), CAGD_NULL);
            for (int count = -3; count <= 0; count++) {
                assert_int_equal(quantities[q].many(c, count, t, CAGD_RIGHT, 0, results, (where = 9, &where)),
                                 count < 0 ? CAGD_COUNT : CAGD_OK);
                assert_int_equal(where, -1);
                nothing_is_written(0);
            }
            for (int order = -2; order <= CAGD_MAX_DEGREE + 2 && quantities[q].has_order; order++) {
                int good = 0 <= order && order <= CAGD_MAX_DEGREE;
                mark(results);
                assert_int_equal(quantities[q].one(c, t[0], CAGD_RIGHT, order, results), good ? CAGD_OK : CAGD_ORDER);
                nothing_is_written(good ? (order + 1) * dim : 0);
                assert_int_equal(quantities[q].many(c, 2, t, CAGD_RIGHT, order, results, (where = 9, &where)),
                                 good ? CAGD_OK : CAGD_ORDER);
                assert_int_equal(where, -1);
                nothing_is_written(good ? 2 * (order + 1) * dim : 0);
            }
        }
        cagd_curve_free(c);
    }
}

/* Of what is no spline there is no curve, with the status and the place that the check has. */
static void what_is_no_spline_is_no_curve(void **state)
{
    (void)state;
    int seen[CAGD_STATUSES] = {0};
    for (int trial = 0; trial < 300; trial++) {
        cagd_spline s = random_spline(2 + trial % 3, 10, 1 + trial % 3, 1);
        int at = (int)(10 * uniform()), where = 9, place = 9;
        switch (trial / 3 % 10) {
        case 0:
            s.degree = trial % 2 ? -1 : CAGD_MAX_DEGREE + 1;
            break;
        case 1:
            s.count = s.degree;
            break;
        case 2:
            s.dim = trial % 2 ? 0 : CAGD_MAX_DIM + 1;
            break;
        case 3:
            s.points = NULL;
            break;
        case 4:
            s.knots = NULL;
            break;
        case 5:
            points[at] = NAN;
            break;
        case 6:
            weights[at] = -INFINITY;
            break;
        case 7:
            knots[at] += 100;
            break;
        case 8:
            for (int i = 0; i <= s.degree + 1; i++)
                knots[at + i] = knots[at];
            break;
        default:
            knots[at] = INFINITY;
        }
        cagd_status expected_status = cagd_spline_check(&s, &place), status = CAGD_STATUSES;
        cagd_curve *c = cagd_curve_new(&s, &status, &where);
        assert_int_equal(status, expected_status);
        assert_int_equal(where, place);
        assert_int_equal(c != NULL, status == CAGD_OK);
        cagd_curve_free(c);
        c = cagd_curve_new(&s, NULL, NULL);
        assert_int_equal(c != NULL, status == CAGD_OK);
        cagd_curve_free(c);
        seen[status]++;
    }
    const cagd_status all[] = {CAGD_NULL,       CAGD_DEGREE,         CAGD_COUNT,         CAGD_DIMENSION,
                               CAGD_NOT_FINITE, CAGD_KNOTS_DECREASE, CAGD_KNOTS_MULTIPLE};
    for (int k = 0; k < 7; k++)
        assert_true(seen[all[k]] > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_are_those_of_the_spline),
        cmocka_unit_test(the_spline_may_go),
        cmocka_unit_test(threads_share_a_curve),
        cmocka_unit_test(what_is_wrong_is_refused),
        cmocka_unit_test(what_has_no_value_is_told),
        cmocka_unit_test(the_last_number_that_is_out_of_range_is_seen),
        cmocka_unit_test(outside_the_domain_is_no_span),
        cmocka_unit_test(every_degree_and_order_is_that_of_the_spline),
        cmocka_unit_test(every_function_refuses_what_is_none),
        cmocka_unit_test(what_is_no_spline_is_no_curve),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
