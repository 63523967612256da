/* test_fit.c -- curves fitted to points: the parts against their definitions, known curves found again, what is refused. */
#include "core/fit/batch.h"
#include "core/fit/cagd_fit.h"
#include "core/fit/feet.h"
#include "core/fit/objective.h"
#include "core/fit/rank.h"
#include "core/fit/reduction.h"
#include "core/fit/strategy.h"
#include "core/kernels/kernels_d.h"
#include "proofs-tests/bench/plain_ceres.h"
#include "proofs-tests/fit/options.h"

#include <float.h>
#include <limits.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MOST = 1000 };
static double Q[MOST * 3];
static uint32_t state_of_noise;

/* Even between -1 and 1. */
static double noise(void)
{
    state_of_noise = state_of_noise * 1664525u + 1013904223u;
    return (double)(state_of_noise >> 8) / (1 << 23) - 1;
}

/* N points of the curve at parameters that are even between `from` and `to`, off by up to `size` in every coordinate. */
static cagd_fit_data sample(const cagd_spline *s, int N, double from, double to, double size)
{
    state_of_noise = 7;
    for (int i = 0; i < N; i++) {
        assert_int_equal(cagd_spline_point(s, from + (to - from) * i / (N - 1), CAGD_RIGHT, Q + i * s->dim), CAGD_OK);
        for (int c = 0; c < s->dim; c++)
            Q[i * s->dim + c] += size * noise();
    }
    return (cagd_fit_data){N, s->dim, Q, NULL};
}

static const double bezier_knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
static const double cubic_points[] = {0, 0, 1, 2.5, 3, 2, 4, -0.5}, cubic_weights[] = {1, 2, 0.6, 1};
static const cagd_spline cubic = {3, 4, 2, bezier_knots, cubic_points, cubic_weights};
static const double conic_points[] = {0, 0, 1, 2, 3, 0}, conic_weights[] = {1, 0.7, 1};
static const cagd_spline conic = {2, 3, 2, bezier_knots + 1, conic_points, conic_weights};
static const double space_points[] = {0, 0, 0, 1, 2, -1, 3, 1, 2, 4, -1, 1};
static const cagd_spline in_space = {3, 4, 3, bezier_knots, space_points, cubic_weights};
static const double spline_knots[] = {0, 0, 0, 0, 0.4, 0.7, 1, 1, 1, 1};
static const double spline_points[] = {0, 0, 1, 2, 2, -1, 3, 1, 4, 1.5, 5, 0},
                    spline_weights[] = {1, 2, 0.7, 1.4, 0.8, 1.3};
static const cagd_spline spline = {3, 6, 2, spline_knots, spline_points, spline_weights};

static cagd_fit_result *fit(const cagd_fit_data *data, const cagd_fit_options *options)
{
    cagd_fit_result *r;
    assert_int_equal(cagd_fit(data, options, &r, NULL), CAGD_OK);
    assert_non_null(r);
    return r;
}

static fit_curve *curve_of(const cagd_spline *s)
{
    fit_curve *c = fit_curve_new(s->degree, s->count, 0, s->dim, s->knots);
    assert_non_null(c);
    memcpy(c->points, s->points, (size_t)(s->count * s->dim) * sizeof *c->points);
    memcpy(c->weights, s->weights, (size_t)s->count * sizeof *c->weights);
    fit_curve_update(c);
    return c;
}

/* ---- Parts ------------------------------------------------------------------------------------------------- */

static void derivatives_are_those_of_the_kernels(void **state)
{
    const cagd_spline *curves[] = {&conic, &cubic, &in_space, &spline};
    (void)state;
    for (int k = 0; k < 4; k++) {
        const cagd_spline *s = curves[k];
        fit_curve *c = curve_of(s);
        double D[9], E[9], R[4], R1[4];
        for (int i = 0; i <= 40; i++) {
            double t = i / 40.0;
            fit_curve_derivatives(c, t, D);
            assert_int_equal(cagd_spline_derivatives(s, t, CAGD_RIGHT, 2, E), CAGD_OK);
            for (int m = 0; m < 3 * s->dim; m++) /* values up to 200 by cancellation, some 60 roundings */
                assert_true(fabs(D[m] - E[m]) <= 64 * DBL_EPSILON * 200);
            int piece = fit_curve_piece(c, t), low = c->span[piece] - s->degree;
            fit_curve_shares(c, piece, t, R, R1);
            for (int x = 0; x < s->dim; x++) {
                double sum = 0, slope = 0;
                for (int m = 0; m <= s->degree; m++) {
                    sum += R[m] * s->points[(low + m) * s->dim + x];
                    slope += R1[m] * s->points[(low + m) * s->dim + x];
                }
                assert_true(fabs(sum - E[x]) <= 64 * DBL_EPSILON * 5);
                assert_true(fabs(slope - E[s->dim + x]) <= 64 * DBL_EPSILON * 200);
            }
        }
        fit_curve_free(c);
    }
}

/* Q is put where its foot is known: on the normal at t. */
static void feet_are_orthogonal(void **state)
{
    const cagd_spline *curves[] = {&conic, &cubic, &spline};
    (void)state;
    for (int k = 0; k < 3; k++) {
        fit_curve *c = curve_of(curves[k]);
        double D[9], q[2];
        for (int i = 1; i < 20; i++)
            for (int side = -1; side <= 1; side++) {
                double t = i / 20.0 + 0.003, s = t + 0.02;
                fit_curve_derivatives(c, t, D);
                double length = hypot(D[2], D[3]);
                q[0] = D[0] - side * 0.05 * D[3] / length;
                q[1] = D[1] + side * 0.05 * D[2] / length;
                assert_int_equal(fit_foot(c, q, &s, D), FOOT_ORTHOGONAL);
                assert_true(fabs(s - t) <= 256 * DBL_EPSILON);
                assert_true(fabs(hypot(q[0] - D[0], q[1] - D[1]) - abs(side) * 0.05) <= 256 * DBL_EPSILON * length);
            }
        double before[2] = {-1, -0.5}, s = 0.5;
        fit_foot_kind kind = fit_foot(c, before, &s, D);
        assert_true(kind == FOOT_AT_END && s == 0);
        fit_curve_free(c);
    }
}

/* The triangle T of rows A: T^T T = A^T A. */
static void triangles_keep_the_normal_equations(void **state)
{
    enum { N = 5, SIDES = 2, ROWS = 301 };
    static int first[] = {0, 3, 7}, reach[] = {0, 1, 3, 1, 2, 3, 4};
    const fit_support support = {N, 2, first, reach};
    double sum[N + SIDES][N + SIDES] = {{0}};
    (void)state;
    state_of_noise = 3;
    fit_reduction *r = fit_reduction_new(&support, SIDES);
    assert_non_null(r);
    for (int again = 0; again < 2; again++) {
        fit_reduction_clear(r);
        memset(sum, 0, sizeof sum);
        for (int i = 0; i < ROWS; i++) {
            int piece = i % 3 == 0, stride;
            double whole[N + SIDES] = {0}, *row = fit_reduction_row(r, piece, &stride);
            for (int j = first[piece]; j < first[piece + 1] + SIDES; j++, row += stride)
                whole[j < first[piece + 1] ? reach[j] : N + j - first[piece + 1]] = *row = noise();
            for (int a = 0; a < N + SIDES; a++)
                for (int b = 0; b < N + SIDES; b++)
                    sum[a][b] += whole[a] * whole[b];
        }
        const double *T = fit_reduction_triangle(r);
        for (int a = 0; a < N + SIDES; a++)
            for (int b = 0; b < N + SIDES; b++) {
                double product = 0;
                for (int k = 0; k < N + SIDES; k++)
                    product += T[k * (N + SIDES) + a] * T[k * (N + SIDES) + b];
                assert_true(fabs(product - sum[a][b]) <= ROWS * 4 * DBL_EPSILON * ROWS);
                assert_true(a <= b || T[a * (N + SIDES) + b] == 0);
            }
    }
    fit_reduction_free(r);
}

/* R^T R and what is left out of it are the second derivatives of F: central differences of the gradient, by steps h, are off by h^2 and
 * by roundings over h.  Plane curves of one span, others, and a robust loss take different ways. */
static void the_model_has_the_second_derivatives(void **state)
{
    enum { MOST_UNKNOWNS = 20 };
    const cagd_spline *curves[] = {&conic, &cubic, &in_space, &spline};
    const double h = 1e-5;
    (void)state;
    for (int k = 0; k < 4; k++)
        for (int variant = 0; variant < 4;
             variant++) { /* low: weights a half of the base and less, where phi is bent */
            int low = variant / 2;
            cagd_fit_loss loss = variant % 2 ? CAGD_FIT_CAUCHY : CAGD_FIT_SQUARES;
            cagd_fit_data data = sample(curves[k], 43, 0.1, 0.9, 0.05);
            cagd_fit_options o = options_with_exact_ends();
            fit_problem p;
            int where, n;
            double H[MOST_UNKNOWNS][MOST_UNKNOWNS] = {{0}}, x[MOST_UNKNOWNS], slope[2][MOST_UNKNOWNS], cost,
                   largest = 0;
            o.initial = curves[k], o.loss = loss, o.loss_scale = 0.05;
            assert_int_equal(fit_problem_make(&data, &o, &fit_usual_strategy, &p, &where), CAGD_OK);
            fit_objective *f = fit_objective_new(&p);
            fit_curve *c = fit_curve_new(p.degree, p.count, 0, p.dim, p.knots);
            double *feet = malloc((size_t)p.points * sizeof *feet);
            assert_true(f != NULL && c != NULL && feet != NULL);
            fit_problem_curve(&p, curves[k], c);
            assert_true(fit_feet_search(&p, c, feet, &cost));
            n = p.unknowns;
            f->newton = 1;
            fit_objective_begin(f, c, feet);
            memcpy(x, f->x, (size_t)n * sizeof *x);
            if (low) {
                for (int a = 0; a < n; a++)
                    x[a] = p.unknown[a].is_weight ? -0.75 : x[a];
                fit_objective_evaluate(f, x, FIT_ROWS);
                fit_objective_accept(f);
            }
            for (int a = 0; a < n; a++)
                for (int b = 0; b < n; b++) {
                    H[a][b] = f->curvature[a * n + b];
                    for (int i = 0; i < n; i++)
                        H[a][b] += f->triangle[i * (n + 1) + a] * f->triangle[i * (n + 1) + b];
                    largest = fmax(largest, fabs(H[a][b]));
                }
            for (int a = 0; a < n; a++) {
                for (int side = 0; side < 2; side++) {
                    x[a] = f->x[a] + (side ? h : -h);
                    fit_objective_evaluate(f, x, FIT_ROWS);
                    for (int b = 0; b < n; b++)
                        slope[side][b] = fit_objective_gradient(f, b);
                }
                x[a] = f->x[a];
                for (int b = 0; b < n; b++)
                    assert_true(fabs((slope[1][b] - slope[0][b]) / (2 * h) - H[a][b]) < 1e-6 * largest);
            }
            fit_objective_free(f);
            fit_curve_free(c);
            fit_problem_free(&p);
            free(feet);
        }
}

/* Two nearly parallel columns of length 1 have the singular values sqrt(1 + c) and sqrt(1 - c), c the cosine between them. */
static void rank_is_that_of_the_stated_threshold(void **state)
{
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        int rows = 300, roundings = 28;
        double threshold = DBL_EPSILON / 2 * sqrt(2) * (rows + roundings) * sqrt(2),
               wanted = threshold * (1 + side * 0.05);
        double angle = 2 * asin(wanted / sqrt(2)), R[] = {3, 5 * cos(angle), 0, 5 * sin(angle)}; /* lengths 3 and 5 */
        static const int fixed[2] = {0, 0}, one_fixed[2] = {0, 1};
        fit_rank r;
        assert_true(fit_rank_of(2, rows, roundings, R, 2, fixed, &r));
        assert_true(fabs(r.smallest / threshold - 1) < 1e-12);
        assert_int_equal(r.rank, side > 0 ? 2 : 1);
        assert_int_equal(r.flat, 2 - r.rank);
        if (side < 0) { /* flat is x_0 : x_1 = 5 : -3, and neither of the two is determined */
            double covariance[4], flat[2];
            int determined[2];
            fit_rank_report(&r, fixed, covariance, flat, determined);
            assert_true(fabs(flat[0] * 3 + flat[1] * 5) < 1e-12 && fabs(hypot(flat[0], flat[1]) - 1) < 1e-15);
            assert_true(!determined[0] && !determined[1]);
            /* of the scaled columns, both 1: (1/2 1/2)^T (1/2 1/2)/... the generalised inverse of [1 1; 1 1] is a quarter of it */
            assert_true(fabs(covariance[0] * 9 - 0.25) < 1e-9 && fabs(covariance[1] * 15 - 0.25) < 1e-9 &&
                        fabs(covariance[3] * 25 - 0.25) < 1e-9);
        }
        fit_rank_free(&r);
        assert_true(fit_rank_of(2, rows, roundings, R, 2, one_fixed, &r));
        assert_true(r.rank == 1 && r.flat == 0);
        fit_rank_free(&r);
    }
}

/* Two points between the sides of a U, each nearer to the side that comes too early or too late for the other: both get feet on the
 * side that the better known one is nearer to. */
static void order_is_kept_for_the_sake_of_what_is_known_best(void **state)
{
    static const double k[] = {0, 0, 1 / 3.0, 2 / 3.0, 1, 1}, P[] = {-1, 10, -1, 0, 1, 0, 1, 10};
    static const double between[] = {0.2, 5, -0.2, 5};
    const cagd_spline u = {1, 4, 2, k, P, NULL};
    (void)state;
    for (int best = 0; best < 2; best++) {
        double sigma[2] = {best == 0 ? 0.5 : 1, best == 1 ? 0.5 : 1}, t[2], cost;
        cagd_fit_data data = {2, 2, between, sigma};
        cagd_fit_options o = options_with_exact_ends();
        fit_problem p;
        int where;
        o.initial = &u;
        o.free = CAGD_FIT_WEIGHTS;
        assert_int_equal(fit_problem_make(&data, &o, &fit_usual_strategy, &p, &where), CAGD_OK);
        fit_curve *c = fit_curve_new(p.degree, p.count, 0, p.dim, p.knots);
        assert_non_null(c);
        fit_problem_curve(&p, &u, c);
        assert_true(fit_feet_search(&p, c, t, &cost));
        for (int i = 0; i < 2; i++)
            assert_true(best == 0 ? t[i] > 2 / 3.0 : t[i] < 1 / 3.0);
        /* squares 0.8^2 and 1.2^2, the former over a variance of 1/4 */
        assert_true(fabs(2 * cost - (0.64 * 4 + 1.44)) < 1e-12);
        fit_curve_free(c);
        fit_problem_free(&p);
    }
}

/* Points in vectors of every width that the processor has: the same numbers, with rows or without; and one by one: the same but for rounding.  On short
 * domains, too, with feet that are taken from Taylor's polynomial, and on a curve that bends so little that only the length of a step can
 * say whether it is the last. */
static void vectors_of_any_width_give_the_same(void **state)
{
    enum { N = 43, MOST_NUMBERS = 2 * 7 * 7 + N + 1 };
    static const double even_points[] = {0, 0, 1 / 3.0, 1e-6, 2 / 3.0, -1e-6, 1.00001, 0},
                        even_weights[] = {1, 1, 1, 1};
    static const cagd_spline nearly_even = {3, 4, 2, bezier_knots, even_points, even_weights};
    const cagd_spline *curves[] = {&conic, &cubic, &nearly_even};
    static const int widths[] = {2, 4, 8, 0};
    static const double lengths[] = {1, 5, 0x1p-30};
    (void)state;
    for (int k = 0; k < 18; k++) {
        const int shape = k / 6, rough = k / 3 % 2;
        cagd_fit_data data = sample(curves[shape], N, 0.1, 0.9, shape < 2 ? 0.05 : 0.001);
        cagd_fit_options o = options_with_exact_ends();
        cagd_spline initial = *curves[shape];
        fit_problem p;
        int where, compared = 0;
        double number[4][MOST_NUMBERS], cost, feet[N], stretched[8], length = lengths[k % 3];
        for (int i = 0; i < initial.degree + initial.count + 1; i++)
            stretched[i] = length * initial.knots[i];
        initial.knots = stretched;
        o.initial = &initial;
        assert_int_equal(fit_problem_make(&data, &o, &fit_usual_strategy, &p, &where), CAGD_OK);
        fit_curve *c = fit_curve_new(p.degree, p.count, 0, p.dim, p.knots);
        assert_non_null(c);
        fit_problem_curve(&p, &initial, c);
        assert_true(fit_feet_search(&p, c, feet, &cost));
        for (int i = 0; i < N; i++) /* a few steps from the feet, some more than others */
            feet[i] += 0.004 * (i % 5 - 2) * length;
        for (int w = 0; w < 4; w++) {
            if (widths[w] > fit_batch_widest())
                continue;
            fit_objective *f = fit_objective_new(&p);
            size_t n = (size_t)p.unknowns, triangle = (n + 1) * (n + 1), all = triangle + n * n + N + 1;
            assert_non_null(f);
            f->newton = 1;
            f->width = widths[w];
            f->limit = rough ? p.strategy.taylor_reach : FOOT_EXACT;
            fit_objective_begin(f, c, feet);
            assert_true(all <= MOST_NUMBERS);
            for (size_t a = 0; a <= n; a++) /* R^T R, and R^T z; R itself may be known less well */
                for (size_t b = 0; b <= n; b++) {
                    number[w][a * (n + 1) + b] = 0;
                    for (size_t i = 0; i <= n; i++)
                        number[w][a * (n + 1) + b] += f->triangle[i * (n + 1) + a] * f->triangle[i * (n + 1) + b];
                }
            memcpy(number[w] + triangle, f->curvature, n * n * sizeof(double));
            for (size_t i = 0; i < N; i++)
                number[w][triangle + n * n + i] = f->feet[i] / length;
            number[w][all - 1] = f->cost;
            assert_true(fit_objective_cost(f, c, feet) == number[w][all - 1]); /* without rows the same cost and feet */
            for (size_t i = 0; i < N; i++)
                assert_true(f->feet[i] / length == number[w][triangle + n * n + i]);
            for (size_t i = 0; w > 0 && i < all; i++, compared++)
                if (widths[w] > 0)
                    assert_true(number[w][i] == number[0][i]);
                else
                    assert_true(fabs(number[w][i] - number[0][i]) < 1e-12 * fmax(1, fabs(number[0][i])));
            fit_objective_free(f);
        }
        assert_true(compared > 0);
        fit_curve_free(c);
        fit_problem_free(&p);
    }
}

/* The radius of curvature of this cubic at 1/2, where it is slowest, is 3/8 e^2: C' = (-3e/2, 0), C'' = (0, -6).  Whether the curve turns as
 * at a cusp is decided by 8 u times its size, or by the distances when they are larger. */
static void a_cusp_is_one_from_the_stated_radius_on(void **state)
{
    (void)state;
    for (int side = -1; side <= 1; side += 2)
        for (int rounding = 0; rounding < 2; rounding++) {
            double rms = rounding ? 0 : 1e-6, threshold = rounding ? 8 * DBL_EPSILON : rms;
            double e = sqrt(threshold * (1 + side * 0.01) * 8 / 3), t = -1;
            double P[] = {0, 0, 1 + e, 1, -e, 1, 1, 0}, w[] = {1, 1, 1, 1};
            cagd_fit_result r = {.curve = {3, 4, 2, bezier_knots, P, w}, .relative = P, .rms = rms};
            assert_int_equal(cagd_fit_has_cusp(&r, &t), side < 0);
            assert_true(side < 0 ? fabs(t - 0.5) < 1e-7 : t == -1);
        }
    /* Wherever it is: |C'|^2 has its minimum there, to the last bits. */
    double t, low[9], high[9];
    cagd_fit_result r = {.curve = spline, .relative = (double *)spline_points, .rms = 1};
    assert_int_equal(cagd_fit_has_cusp(&r, &t), 1);
    cagd_spline_derivatives(&spline, t - 1e-9, CAGD_RIGHT, 2, low);
    cagd_spline_derivatives(&spline, t + 1e-9, CAGD_RIGHT, 2, high);
    assert_true(low[2] * low[4] + low[3] * low[5] < 0 && high[2] * high[4] + high[3] * high[5] > 0);
}

/* ---- Known curves ------------------------------------------------------------------------------------------ */

static void noise_free_curves_come_back(void **state)
{
    const cagd_spline *curves[] = {&conic, &cubic, &in_space, &spline};
    (void)state;
    for (int k = 0; k < 4; k++) {
        const cagd_spline *s = curves[k];
        cagd_fit_data data = sample(s, 60, 0, 1, 0);
        cagd_fit_options o = options_with_exact_ends();
        o.degree = s->degree;
        o.count = s->count;
        o.knots = s->knots;
        cagd_fit_result *r = fit(&data, &o);
        assert_int_equal(r->termination, CAGD_FIT_CONVERGED);
        assert_int_equal(r->rank, r->unknowns);
        assert_true(r->rms < 1e-13);
        for (int i = 0; i < s->count; i++)
            assert_true(fabs(r->curve.weights[i] / s->weights[i] - 1) < 1e-11);
        for (int i = 1; i < r->count; i++)
            assert_true(r->feet[i] > r->feet[i - 1]);
        cagd_fit_free(r);
    }
}

static void free_ends_slide(void **state)
{
    cagd_fit_data data = sample(&conic, 50, 0, 1, 0.001);
    cagd_fit_options o = options_with_exact_ends();
    (void)state;
    o.free |= CAGD_FIT_END_POINTS;
    cagd_fit_result *r = fit(&data, &o);
    assert_int_equal(r->unknowns, 7);
    assert_int_equal(r->rank, 5);
    assert_int_equal(r->flat, 2);
    for (int a = 0; a < 2; a++)
        for (int b = 0; b < 2; b++) {
            double product = 0;
            for (int k = 0; k < 7; k++)
                product += r->free_directions[a * 7 + k] * r->free_directions[b * 7 + k];
            assert_true(fabs(product - (a == b)) < 1e-12);
        }
    assert_false(r->determined[2]); /* the weight */
    cagd_fit_free(r);
}

/* The curve between measured ends is the one whose ends slide, cut off at the feet of the first and the last point: the
 * cost and the distances are the same.  The errors of these two along the curve are in the covariance. */
static void measured_ends_cut_the_curve(void **state)
{
    (void)state;
    for (int space = 0; space < 2; space++)
        for (int any_order = 0; any_order < 2; any_order++) {
            const cagd_spline *curve = space ? &in_space : &conic;
            cagd_fit_data data = sample(curve, 50, 0, 1, 0.001);
            cagd_fit_options o = cagd_fit_defaults();
            o.degree = curve->degree;
            cagd_fit_options slides = o;
            slides.ends = CAGD_FIT_ENDS_SLIDE;
            slides.initial = curve;
            o.unordered = any_order;
            cagd_fit_result *r = fit(&data, &o), *slid = fit(&data, &slides);
            const int dim = curve->dim, last = curve->count - 1, turned = r->end_points[0] != 0;
            assert_int_equal(r->end_points[turned], 0);
            assert_int_equal(r->end_points[!turned], 49);
            assert_int_equal(r->rank, r->unknowns);
            assert_int_equal(r->degrees_of_freedom, 50 * (dim - 1) + 2 - r->rank);
            assert_true(fabs(r->cost / slid->cost - 1) < 1e-9);
            assert_true(r->feet[turned ? 49 : 0] == 0 && r->feet[turned ? 0 : 49] == 1);
            for (int i = 0; i < 50; i++)
                assert_true(fabs(fabs(r->distances[i]) - fabs(slid->distances[i])) < 1e-9);
            for (int end = 0; end < 2; end++) { /* orthogonal, though nothing but the minimum says so */
                int at = end ? last : 0, to = end ? last - 1 : 1, i = r->end_points[end];
                double along = 0;
                for (int c = 0; c < dim; c++)
                    along += r->residuals[i * dim + c] * (r->relative[to * dim + c] - r->relative[at * dim + c]);
                assert_true(fabs(along) < 1e-10);
            }
            for (int k = 0; k < r->unknowns; k++) {
                double error = sqrt(r->covariance[k * r->unknowns + k]);
                int end = !r->unknown[k].is_weight && r->unknown[k].index % last == 0;
                assert_true(!end || (error > 0.0003 && error < 0.003)); /* that of one point, or little less */
            }
            assert_true(r->determined[0] && !r->ends_are_exact);
            cagd_fit_free(r);
            cagd_fit_free(slid);
        }
}

static void the_plain_formulation_finds_the_same_minimum(void **state)
{
    const cagd_spline *curves[] = {&cubic, &in_space, &spline};
    (void)state;
    for (int k = 0; k < 3; k++) { /* no foot is at an end */
        cagd_fit_data data = sample(curves[k], 300, 0.02, 0.98, 0.003);
        cagd_fit_options o = options_with_exact_ends();
        o.initial = curves[k];
        cagd_fit_result *fast = fit(&data, &o);
        plain_outcome plain;
        o.max_iterations = 500;
        assert_int_equal(plain_ceres(&data, &o, &plain), CAGD_OK);
        assert_true(plain.converged);
        assert_true(fabs(fast->cost / plain.cost - 1) < 1e-9);
        assert_true(fast->gradient_norm < 1e-12);
        cagd_fit_free(fast);
    }
}

static void order_does_not_matter_when_there_is_none(void **state)
{
    cagd_fit_data data = sample(&conic, 101, 0, 1, 0.001);
    cagd_fit_options o = options_with_exact_ends();
    (void)state;
    o.initial = &conic;
    cagd_fit_result *ordered = fit(&data, &o);
    double shuffled[101 * 2];
    for (int i = 0; i < 101; i++)
        memcpy(shuffled + i * 37 % 101 * 2, Q + i * 2, 2 * sizeof *Q);
    cagd_fit_data in_any = {101, 2, shuffled, NULL};
    o.unordered = 1;
    cagd_fit_result *any = fit(&in_any, &o);
    assert_true(fabs(any->cost / ordered->cost - 1) < 1e-12);
    o.initial = NULL;
    o.free |= CAGD_FIT_END_POINTS;
    cagd_fit_result *found = fit(&in_any, &o);
    assert_true(found->cost < any->cost);
    /* Fixed ends are those which the guessed order has, and the curve is the one whose residuals are told. */
    o.free &= ~CAGD_FIT_END_POINTS;
    cagd_fit_result *fixed = fit(&in_any, &o);
    for (int i = 0; i < 101; i++) {
        double P[2];
        cagd_spline_point(&fixed->curve, fixed->feet[i], CAGD_RIGHT, P);
        for (int c = 0; c < 2; c++)
            assert_true(fabs(P[c] + fixed->residuals[2 * i + c] - shuffled[2 * i + c]) < 1e-12);
    }
    cagd_fit_free(fixed);
    cagd_fit_free(ordered);
    cagd_fit_free(any);
    cagd_fit_free(found);
}

static void bounds_hold(void **state)
{
    cagd_fit_data data = sample(&cubic, 60, 0, 1, 0);
    cagd_fit_options o = options_with_exact_ends();
    (void)state;
    o.degree = 3;
    o.weight_high = 1.5;
    cagd_fit_result *r = fit(&data, &o);
    assert_true(r->curve.weights[1] <= 1.5 * (1 + 4 * DBL_EPSILON) &&
                r->curve.weights[2] <= 1.5 * (1 + 4 * DBL_EPSILON));
    int bound = 0;
    for (int k = 0; k < r->unknowns; k++)
        bound += r->at_bound[k];
    assert_int_equal(bound + r->rank + r->flat, r->unknowns);
    assert_true(bound >= 1);
    cagd_fit_free(r);
}

static void a_robust_loss_leaves_outliers_out(void **state)
{
    (void)state;
    for (int loss = CAGD_FIT_HUBER; loss <= CAGD_FIT_CAUCHY; loss++) {
        cagd_fit_data data = sample(&conic, 101, 0, 1, 0.001);
        for (int i = 10; i < 101; i += 20)
            Q[2 * i + 1] += 0.5;
        cagd_fit_options o = options_with_exact_ends();
        cagd_fit_result *squares = fit(&data, &o);
        o.loss = (cagd_fit_loss)loss;
        o.loss_scale = 0.002;
        cagd_fit_result *robust = fit(&data, &o);
        assert_int_equal(robust->termination, CAGD_FIT_CONVERGED);
        assert_true(fabs(robust->curve.weights[1] - 0.7) < 0.01);
        assert_true(fabs(squares->curve.weights[1] - 0.7) > 0.02);
        cagd_fit_free(squares);
        cagd_fit_free(robust);
    }
}

/* Of good points an end is left out once in 20 N times; of bad ones, twenty standard deviations away, always, in space too. */
static void an_end_is_left_out_where_it_is_an_outlier(void **state)
{
    enum { N = 51, DRAWS = 60 };
    int left_out = 0;
    (void)state;
    for (int draw = 0; draw < 2 * DRAWS; draw++) {
        const int space = draw % 2, end = draw / 2 % 2, bad = draw < DRAWS, dim = 2 + space;
        cagd_fit_data data = sample(space ? &in_space : &conic, N, 0, 1, 0);
        cagd_fit_options o = cagd_fit_defaults();
        state_of_noise = (uint32_t)(104729 * draw + 1);
        for (int m = 0; m < N * dim; m++)
            Q[m] += 0.003 * (noise() + noise() + noise()); /* of standard deviation 0.003 and nearly normal */
        if (bad)
            Q[(end == 0 ? 0 : N - 1) * dim + 1] += 0.06;
        o.loss = draw % 3 ? CAGD_FIT_HUBER : CAGD_FIT_CAUCHY, o.loss_scale = 0;
        o.degree = space ? 3 : 2;
        cagd_fit_result *r = fit(&data, &o);
        assert_int_equal(r->count, N);
        assert_true(r->end_is_judged[0] && r->end_is_judged[1]);
        if (bad) {
            assert_int_equal(r->left_out[end], 1);
            assert_int_equal(r->outlier[end == 0 ? 0 : N - 1], 1);
            assert_int_equal(r->end_points[end], end == 0 ? 1 : N - 2);
        }
        left_out += r->left_out[0] + r->left_out[1] - bad;
        cagd_fit_free(r);
    }
    assert_true(left_out <= 2); /* of 180 good ends, 0.2 are expected */
}

/* Far from the origin and in any unit the same curve. */
static void place_and_unit_do_not_matter(void **state)
{
    cagd_fit_data data = sample(&cubic, 80, 0, 1, 0.002);
    cagd_fit_options o = options_with_exact_ends();
    (void)state;
    o.degree = 3;
    cagd_fit_result *here = fit(&data, &o);
    for (int m = 0; m < 160; m++)
        Q[m] = Q[m] * 1024 + (m % 2 ? 4096 : -8192);
    cagd_fit_result *there = fit(&data, &o);
    for (int i = 0; i < 4; i++)
        assert_true(fabs(here->curve.weights[i] - there->curve.weights[i]) < 1e-9);
    assert_true(fabs(there->cost / here->cost / 0x1p20 - 1) < 1e-9);
    cagd_fit_free(here);
    cagd_fit_free(there);
}

/* x - c without rounding: what two-sum finds of it is zero (moller-1965). */
static int is_exact_difference(double x, double c, double d)
{
    double back = d - x;
    return (x - (d - back)) + (-c - back) == 0;
}

/* Working coordinates lose nothing, however far away the points are, and wherever the nearest of them is. */
static void working_coordinates_are_exact(void **state)
{
    const cagd_fit_options o = options_with_exact_ends();
    (void)state;
    state_of_noise = 5;
    for (int k = 0; k < 4000; k++) {
        enum { N = 12 };
        /* of all sizes, and a half of them near the threshold, 3 h */
        double far = k % 2 ? 3 + 0.01 * noise() + 2 * (k % 4 == 1) : exp(32 * noise()), scale = exp(30 * noise());
        fit_problem p;
        int where;
        for (int i = 0; i < N; i++)
            for (int c = 0; c < 2; c++)
                Q[2 * i + c] =
                    (c ? 1 : -1) * scale * (far + 1 + (i < 2 ? 2 * i - 1 : noise() * exp(20 * noise() - 20)));
        cagd_fit_data data = {N, 2, Q, NULL};
        assert_int_equal(fit_problem_make(&data, &o, &fit_usual_strategy, &p, &where), CAGD_OK);
        for (int m = 0; m < 2 * N; m++) {
            assert_true(is_exact_difference(Q[m], p.centre[m % 2], p.Q[m] * p.unit));
            assert_true(fabs(p.Q[m]) <= p.size && p.size <= 5);
        }
        fit_problem_free(&p);
    }
}

/* Coordinates that are multiples of 2^-12 can be shifted by 1e12, where binary64 has steps of 2^-13, without rounding.  Then everything is
 * the same, standard errors with it, and the points of the curve are where they were from the shifted origin, to the precision of
 * those that are near, or where they are hardly known to a small part of their standard errors;
 * these agree to six digits. */
static double error_of(const cagd_fit_result *r, int index, int is_weight, int coordinate)
{
    for (int k = 0; k < r->unknowns; k++)
        if (r->unknown[k].index == index && r->unknown[k].is_weight == is_weight &&
            (is_weight || r->unknown[k].coordinate == coordinate))
            return sqrt(r->covariance[k * (r->unknowns + 1)]);
    return 0;
}

static void shifts_change_nothing(void **state)
{
    static const double shifts[] = {0, 1e6, 1e12};
    const cagd_spline *curves[] = {&conic, &cubic, &in_space, &spline};
    (void)state;
    for (int k = 0; k < 4; k++)
        for (int unit = -40; unit <= 0; unit += 40) {
            const cagd_spline *s = curves[k];
            int dim = s->dim, N = 70;
            double near[3 * 70];
            sample(s, N, 0, 1, 0.01);
            for (int m = 0; m < N * dim; m++)
                near[m] = ldexp(rint(ldexp(Q[m], 12)), -12);
            cagd_fit_options o = options_with_exact_ends();
            o.degree = s->degree, o.count = s->count, o.knots = s->knots;
            cagd_fit_result *first = NULL;
            for (int j = 0; j < 3; j++) {
                double shift[3] = {shifts[j], -shifts[j], shifts[j] / 2};
                for (int m = 0; m < N * dim; m++)
                    Q[m] = ldexp(near[m] + shift[m % dim], unit);
                cagd_fit_data data = {N, dim, Q, NULL};
                cagd_fit_result *r = fit(&data, &o);
                first = j == 0 ? r : first;
                assert_int_equal(r->termination, CAGD_FIT_CONVERGED);
                assert_true(r->rank == first->rank && r->largest_at == first->largest_at);
                assert_true(fabs(r->cost / first->cost - 1) < 1e-12 && fabs(r->rms / first->rms - 1) < 1e-12);
                for (int m = 0; m < s->count * dim; m++) {
                    int c = m % dim;
                    double from_shift = ldexp(r->relative[m], -unit) + (ldexp(r->origin[c], -unit) - shift[c]);
                    double error = ldexp(error_of(first, m / dim, 0, c), -unit);
                    assert_true(fabs(from_shift - ldexp(first->curve.points[m], -unit)) < 1e-11 + 1e-8 * error);
                    assert_true(r->curve.points[m] == r->origin[c] + r->relative[m]);
                }
                for (int i = 0; i < s->count; i++)
                    assert_true(fabs(r->curve.weights[i] / first->curve.weights[i] - 1) <
                                1e-11 + 1e-8 * error_of(first, i, 1, 0));
                for (int a = 0; a < r->unknowns; a++)
                    assert_true(fabs(r->covariance[a * r->unknowns + a] / first->covariance[a * r->unknowns + a] - 1) <
                                1e-6);
                cagd_fit_conic here = cagd_fit_conic_of(r), there = cagd_fit_conic_of(first);
                assert_true(here.kind == there.kind && here.type == there.type);
                double t;
                assert_int_equal(cagd_fit_has_cusp(r, &t), 0);
                if (j > 0)
                    cagd_fit_free(r);
            }
            cagd_fit_free(first);
        }
}

static void the_same_again(void **state)
{
    cagd_fit_data data = sample(&spline, MOST, 0, 1, 0.01);
    cagd_fit_options o = options_with_exact_ends();
    (void)state;
    o.degree = 3;
    o.count = 6;
    o.starts = 2;
    cagd_fit_result *a = fit(&data, &o), *b = fit(&data, &o);
    assert_memory_equal(a->value, b->value, (size_t)a->unknowns * sizeof *a->value);
    assert_memory_equal(a->feet, b->feet, MOST * sizeof *a->feet);
    assert_true(a->agreeing_starts >= 1 && a->agreeing_starts <= 2);
    cagd_fit_free(a);
    cagd_fit_free(b);
}

/* Random cubics with weights between 1/4 and 4, through points without noise: the curve is found again, or one with the same points,
 * nearly always without any knowledge. */
static void random_cubics_come_back(void **state)
{
    enum { POINTS = 60 };
    int found = 0;
    (void)state;
    for (int k = 0; k < CURVES; k++) {
        double P[8], w[4] = {1, 1, 1, 1};
        state_of_noise = (uint32_t)(7919 * k + 1);
        for (int m = 0; m < 8; m++)
            P[m] = noise();
        for (int m = 1; m < 3; m++)
            w[m] = exp(noise() * log(4));
        const cagd_spline s = {3, 4, 2, bezier_knots, P, w};
        cagd_fit_data data = sample(&s, POINTS, 0, 1, 0);
        cagd_fit_options o = options_with_exact_ends();
        o.degree = 3;
        cagd_fit_result *r = fit(&data, &o);
        found += r->rms < 1e-10;
        cagd_fit_free(r);
    }
    print_message("%d of %d cubics found\n", found, CURVES);
    assert_true(100 * found >= 95 * CURVES);
}

/* The domain is any interval: feet go with it, and nothing else changes but by roundings. */
static void the_domain_may_be_any_interval(void **state)
{
    const cagd_spline *curves[] = {&conic, &cubic, &in_space, &spline};
    (void)state;
    for (int k = 0; k < 8; k++) {
        const double low = k < 4 ? 2 : 0, length = k < 4 ? 5 : 0x1p-30;
        const cagd_spline *s = curves[k % 4];
        cagd_fit_data data = sample(s, 50, 0, 1, 0.01);
        cagd_fit_options o = options_with_exact_ends();
        double knots[16];
        o.degree = s->degree, o.count = s->count, o.knots = s->knots;
        cagd_fit_result *usual = fit(&data, &o);
        for (int i = 0; i < s->count + s->degree + 1; i++)
            knots[i] = low + length * s->knots[i];
        o.knots = knots;
        cagd_fit_result *other = fit(&data, &o);
        assert_int_equal(other->termination, CAGD_FIT_CONVERGED);
        assert_true(fabs(other->cost / usual->cost - 1) < 1e-12 && other->rank == usual->rank);
        for (int i = 0; i < 50; i++)
            assert_true(fabs((other->feet[i] - low) / length - usual->feet[i]) < 1e-9);
        for (int a = 0; a < usual->unknowns; a++)
            assert_true(fabs(other->value[a] - usual->value[a]) < 1e-9);
        assert_true(usual->iterations + 4 >= other->iterations && other->iterations + 4 >= usual->iterations);
        cagd_fit_free(usual);
        cagd_fit_free(other);
    }
}

/* Every number of the strategy, halved and doubled, with few points and with many, with and without a curve to start from: cost and
 * estimates are the same. */
static void the_strategy_does_not_change_the_result(void **state)
{
    (void)state;
    for (int many = 0; many < 2; many++)
        for (int given = 0; given < 2; given++) {
            cagd_fit_data data = sample(&cubic, many ? MOST : 70, 0, 1, 0.002);
            cagd_fit_options o = options_with_exact_ends();
            o.degree = 3;
            o.initial = given ? &cubic : NULL;
            cagd_fit_result *usual = fit(&data, &o), *r;
            for (int change = 0; change < 26; change++) {
                fit_strategy s = fit_usual_strategy;
                double factor = change % 2 ? 2 : 0.5,
                       *real[] = {&s.handover, &s.taylor_reach, &s.guess_accuracy, &s.weight_spread};
                int *whole[] = {&s.points_per_unknown, &s.means_factor, &s.anchors,      &s.sides,       &s.guesses,
                                &s.guess_steps,        &s.chord_groups, &s.alternations, &s.extra_starts};
                if (change / 2 < 4)
                    *real[change / 2] *= factor;
                else
                    *whole[change / 2 - 4] = (int)(factor * *whole[change / 2 - 4]);
                assert_int_equal(fit_with_strategy(&data, &o, &s, &r, NULL), CAGD_OK);
                assert_int_equal(r->termination, CAGD_FIT_CONVERGED);
                assert_true(fabs(r->cost / usual->cost - 1) < 1e-12);
                for (int k = 0; k < r->unknowns; k++)
                    assert_true(fabs(r->value[k] - usual->value[k]) < 1e-9);
                cagd_fit_free(r);
            }
            cagd_fit_free(usual);
        }
}

/* ---- Nothing free ------------------------------------------------------------------------------------------- */

/* A quarter of an ellipse in no gauge, a cubic with a loop, one with a cusp, a polygon, and one whose sides lie closer to each other
 * than the ends of the pieces into which a search divides them. */
static const double other_weights[] = {2, 1, 3, 0.5}, loop_points[] = {0, 0, 4, 3, -1, 3, 3, 0},
                    cusp_points[] = {0, 0, 1, 1, 0, 1, 1, 0};
static const cagd_spline ungauged = {2, 3, 2, bezier_knots + 1, conic_points, other_weights};
static const cagd_spline ungauged_cubic = {3, 4, 2, bezier_knots, cubic_points, other_weights};
static const cagd_spline loop = {3, 4, 2, bezier_knots, loop_points, NULL};
static const cagd_spline cusp = {3, 4, 2, bezier_knots, cusp_points, NULL};
static const double polygon_knots[] = {0, 0, 0.25, 0.5, 1, 1};
static const cagd_spline polygon = {1, 4, 2, polygon_knots, cubic_points, NULL};
static const double hairpin_knots[] = {0, 0, 0.5, 1, 1}, hairpin_points[] = {-2, 0, 4, 0x1p-5, -2, 0x1p-4};
static const cagd_spline hairpin = {1, 3, 2, hairpin_knots, hairpin_points, NULL};

/* No point of the curve among very many is nearer than the foot, which is where the parameter says on the curve as it was given. */
static void feet_on_a_given_curve_are_nearest_points(void **state)
{
    enum { N = 60 };
    const cagd_spline *curves[] = {&ungauged, &ungauged_cubic, &in_space, &spline, &loop, &cusp, &polygon, &hairpin};
    (void)state;
    for (int k = 0; k < 8; k++) {
        const cagd_spline *s = curves[k];
        int dim = s->dim;
        double P[3], sum = 0, largest = 0;
        state_of_noise = (uint32_t)(11 + k);
        for (int m = 0; m < N * dim; m++)
            Q[m] = (1 + 3 * noise()) * (s == &hairpin && m % 2 == 1 ? 0x1p-6 : 1);
        cagd_fit_data data = {N, dim, Q, NULL};
        cagd_fit_options o = options_with_exact_ends();
        o.free = 0;
        o.initial = s;
        o.starts = 3;
        cagd_fit_result *r = fit(&data, &o);
        assert_int_equal(r->termination, CAGD_FIT_CONVERGED);
        assert_true(r->unknowns == 0 && r->rank == 0 && r->flat == 0 && r->iterations == 0 && r->steps == 0);
        assert_int_equal(r->degrees_of_freedom, N * (dim - 1));
        assert_memory_equal(r->curve.points, s->points, (size_t)(s->count * dim) * sizeof *Q);
        for (int j = 0; j < s->count; j++)
            assert_true(r->curve.weights[j] == (s->weights != NULL ? s->weights[j] : 1));
        int overtaking = 0;
        for (int i = 0; i < N; i++) {
            double square = 0, distance = fabs(r->distances[i]);
            assert_int_equal(cagd_spline_point(s, r->feet[i], CAGD_RIGHT, P), CAGD_OK);
            for (int c = 0; c < dim; c++) {
                assert_true(fabs(Q[i * dim + c] - P[c] - r->residuals[i * dim + c]) < 1e-13);
                square += (Q[i * dim + c] - P[c]) * (Q[i * dim + c] - P[c]);
            }
            assert_true(fabs(distance - sqrt(square)) < 1e-13);
            sum += square;
            overtaking += i > 0 && r->feet[i] < r->feet[i - 1];
            if (distance > largest) {
                largest = distance;
                assert_true(fabs(r->distances[r->largest_at]) >= largest);
            }
            for (int f = 0; f <= FINE; f++) {
                assert_int_equal(cagd_spline_point(s, (double)f / FINE, CAGD_RIGHT, P), CAGD_OK);
                assert_true(fit_distance_squared(dim, P, Q + i * dim) >= square * (1 - 0x1p-40) - 0x1p-80);
            }
        }
        assert_true(fabs(r->rms / sqrt(sum / N) - 1) < 1e-13 && r->largest == largest);
        assert_true(fabs(r->chi_squared / sum - 1) < 1e-13 && fabs(2 * r->cost / sum - 1) < 1e-13);
        assert_int_equal(r->out_of_order, overtaking);
        cagd_fit_free(r);
    }
}

/* The nearest of FINE + 1 points of the curve, and its squared distance. */
static int nearest_of_many(const cagd_spline *s, const double q[], double *square)
{
    int nearest = 0;
    double P[3];
    *square = HUGE_VAL;
    for (int f = 0; f <= FINE; f++) {
        assert_int_equal(cagd_spline_point(s, (double)f / FINE, CAGD_RIGHT, P), CAGD_OK);
        double d = fit_distance_squared(s->dim, P, q);
        if (d < *square)
            *square = d, nearest = f;
    }
    return nearest;
}

/* Points that are nearly as far from two parts of a curve: between two points with feet far from each other, by halving. */
static void feet_of_points_between_two_parts_are_nearest_points(void **state)
{
    enum { PAIRS = 12, HALVINGS = 16 };
    const cagd_spline *curves[] = {&ungauged_cubic, &spline, &loop, &polygon, &hairpin};
    int between = 0;
    (void)state;
    for (int k = 0; k < 5; k++) {
        const cagd_spline *s = curves[k];
        int count = 0;
        double square;
        state_of_noise = (uint32_t)(101 + k);
        while (count < 2 * PAIRS) {
            double *a = Q + 2 * count, *b = a + 2;
            for (int m = 0; m < 4; m++)
                a[m] = (1 + 3 * noise()) * (s == &hairpin && m % 2 == 1 ? 0x1p-6 : 1);
            int from = nearest_of_many(s, a, &square), to = nearest_of_many(s, b, &square);
            for (int h = 0; h < HALVINGS && abs(to - from) > FINE / 16; h++) {
                double middle[2] = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
                int there = nearest_of_many(s, middle, &square);
                if (abs(there - from) < abs(there - to))
                    memcpy(a, middle, sizeof middle), from = there;
                else
                    memcpy(b, middle, sizeof middle), to = there;
            }
            between += abs(to - from) > FINE / 16;
            count += 2;
        }
        cagd_fit_data data = {count, 2, Q, NULL};
        cagd_fit_options o = options_with_exact_ends();
        o.free = 0;
        o.initial = s;
        cagd_fit_result *r = fit(&data, &o);
        for (int i = 0; i < count; i++) {
            nearest_of_many(s, Q + 2 * i, &square);
            assert_true(r->distances[i] * r->distances[i] <= square * (1 + 0x1p-40) + 0x1p-80);
        }
        cagd_fit_free(r);
    }
    assert_true(between > PAIRS);
}

/* One point suffices, anywhere, also when the curve is but a point; weights of any size are no other curve. */
static void a_single_point_has_its_distance(void **state)
{
    static const double equal[] = {1, 1, 1, 1, 1, 1};
    double q[] = {1.5, 9}, huge[3];
    cagd_spline point = {2, 3, 2, bezier_knots + 1, equal, NULL}, heavy = ungauged;
    cagd_fit_data data = {1, 2, q, NULL};
    cagd_fit_options o = options_with_exact_ends();
    (void)state;
    o.free = 0;
    o.initial = &ungauged;
    cagd_fit_result *r = fit(&data, &o), *s;
    for (int j = 0; j < 3; j++)
        huge[j] = ldexp(other_weights[j], 1020);
    heavy.weights = huge;
    o.initial = &heavy;
    s = fit(&data, &o);
    assert_true(s->distances[0] == r->distances[0] && s->feet[0] == r->feet[0]);
    assert_memory_equal(s->curve.weights, huge, sizeof huge);
    cagd_fit_free(r);
    cagd_fit_free(s);
    o.initial = &point;
    r = fit(&data, &o);
    assert_true(fabs(fabs(r->distances[0]) - sqrt(64.25)) < 1e-14);
    cagd_fit_free(r);
    q[0] = q[1] = 1;
    assert_int_equal(cagd_fit(&data, &o, &r, NULL), CAGD_ALL_EQUAL);
    data.count = 0;
    assert_int_equal(cagd_fit(&data, &o, &r, NULL), CAGD_TOO_FEW);
}

/* ---- Refusals ---------------------------------------------------------------------------------------------- */

static void refused(const cagd_fit_data *data, const cagd_fit_options *o, cagd_status expected, int place)
{
    cagd_fit_result *r = (cagd_fit_result *)&Q;
    int where = 99;
    assert_int_equal(cagd_fit(data, o, &r, &where), expected);
    assert_null(r);
    assert_int_equal(where, place);
    assert_true(strlen(cagd_status_text(expected)) > 0);
}

static void bad_arguments_are_refused(void **state)
{
    const cagd_fit_options good = options_with_exact_ends();
    const cagd_fit_data data = sample(&conic, 20, 0, 1, 0);
    double sigma[20], points[40];
    (void)state;
#define OPTION(change, status)                                                                                         \
    do {                                                                                                               \
        cagd_fit_options o = good;                                                                                     \
        change;                                                                                                        \
        refused(&data, &o, status, -1);                                                                                \
    } while (0)
    OPTION(o.free = 0, CAGD_BAD_OPTION);
    OPTION((o.degree = 1, o.free = 0), CAGD_BAD_OPTION);
    OPTION(o.free = 8, CAGD_BAD_OPTION);
    OPTION(o.free = CAGD_FIT_WEIGHTS, CAGD_BAD_OPTION);
    OPTION(o.degree = 0, CAGD_BAD_OPTION);
    OPTION(o.degree = CAGD_MAX_DEGREE + 1, CAGD_BAD_OPTION);
    OPTION(o.count = 2, CAGD_BAD_OPTION);
    OPTION(o.loss = (cagd_fit_loss)7, CAGD_BAD_OPTION);
    OPTION(o.loss_scale = -1, CAGD_BAD_OPTION);
    OPTION(o.loss_scale = NAN, CAGD_BAD_OPTION);
    OPTION(o.weight_low = -1, CAGD_BAD_OPTION);
    OPTION(o.weight_low = 1, CAGD_BAD_OPTION);
    OPTION(o.weight_low = NAN, CAGD_BAD_OPTION);
    OPTION(o.weight_high = 1, CAGD_BAD_OPTION);
    OPTION(o.weight_high = NAN, CAGD_BAD_OPTION);
    OPTION(o.starts = 0, CAGD_BAD_OPTION);
    OPTION(o.starts = INT_MAX, CAGD_BAD_OPTION);
    OPTION(o.count = INT_MAX, CAGD_BAD_OPTION);
    OPTION(o.tolerance = 0, CAGD_BAD_OPTION);
    OPTION(o.tolerance = INFINITY, CAGD_BAD_OPTION);
    OPTION(o.max_iterations = 0, CAGD_BAD_OPTION);
    OPTION((o.degree = 1, o.free = CAGD_FIT_WEIGHTS), CAGD_BAD_OPTION);

    static const double decreasing[] = {0, 0, 0, 0.7, 0.4, 1, 1, 1}, open[] = {0, 0.1, 0.2, 0.4, 0.7, 1, 1, 1};
    static const double torn[] = {0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1}, infinite[] = {0, 0, 0, 0.4, 0.7, INFINITY, 1, 1};
    OPTION((o.count = 5, o.knots = decreasing), CAGD_BAD_CURVE);
    OPTION((o.count = 5, o.knots = open), CAGD_BAD_CURVE);
    OPTION((o.count = 5, o.knots = infinite), CAGD_BAD_CURVE);
    OPTION((o.count = 6, o.knots = torn), CAGD_BAD_CURVE);
    static const double zero[] = {1, 0, 1}, not_finite[] = {0, 0, INFINITY, 2, 3, 0};
    cagd_spline curve = conic;
    curve.weights = zero;
    OPTION(o.initial = &curve, CAGD_BAD_CURVE);
    curve = conic;
    curve.points = not_finite;
    OPTION(o.initial = &curve, CAGD_BAD_CURVE);
    curve = conic;
    curve.dim = 3;
    OPTION(o.initial = &curve, CAGD_BAD_CURVE);
    curve = conic;
    curve.degree = 3;
    OPTION(o.initial = &curve, CAGD_BAD_CURVE);
    curve = conic;
    curve.knots = NULL;
    OPTION(o.initial = &curve, CAGD_BAD_CURVE);
    OPTION((o.degree = 8, o.count = 40), CAGD_TOO_FEW);

    cagd_fit_data d = data;
    d.count = 1;
    refused(&d, &good, CAGD_TOO_FEW, -1);
    d.count = 2; /* three unknowns */
    refused(&d, &good, CAGD_TOO_FEW, -1);
    d = data;
    d.dim = 4;
    refused(&d, &good, CAGD_BAD_DATA, -1);
    d = data;
    d.points = NULL;
    refused(&d, &good, CAGD_NULL, -1);
    refused(NULL, &good, CAGD_NULL, -1);
    refused(&data, NULL, CAGD_NULL, -1);
    assert_int_equal(cagd_fit(&data, &good, NULL, NULL), CAGD_NULL);
    d = data;
    d.count = INT_MAX;
    refused(&d, &good, CAGD_BAD_DATA, -1);
    memcpy(points, Q, sizeof points);
    d = data;
    d.points = points;
    points[13] = NAN;
    refused(&d, &good, CAGD_BAD_DATA, 6);
    for (int m = 0; m < 40; m++)
        points[m] = 1 + m % 2;
    refused(&d, &good, CAGD_ALL_EQUAL, -1);
    for (int i = 0; i < 20; i++)
        sigma[i] = 1;
    d = data;
    d.sigma = sigma;
    sigma[17] = 0;
    refused(&d, &good, CAGD_BAD_DATA, 17);
    sigma[17] = INFINITY;
    refused(&d, &good, CAGD_BAD_DATA, 17);
    sigma[17] = 1e-200;
    refused(&d, &good, CAGD_OVERFLOW, 17);
    for (int sign = -1; sign <= 1; sign += 2) {
        for (int m = 0; m < 40; m++)
            points[m] = ldexp(Q[m], 500 * sign);
        d = (cagd_fit_data){20, 2, points, NULL};
        refused(&d, &good, CAGD_OVERFLOW, -1);
    }
    cagd_fit_free(NULL);
}

/* The middle point lies on one side of the chord, all measured points on the other: the smaller the weight the better. */
static void a_weight_that_goes_to_zero_is_no_minimum(void **state)
{
    (void)state;
    static const double knots[] = {0, 0, 0, 1, 1, 1}, P[] = {0, 0, 0.5, 0.5, 1, 0}, w[] = {1, 1, 1};
    static const cagd_spline above = {2, 3, 2, knots, P, w};
    double below[40];
    for (int i = 0; i < 20; i++) {
        double x = (i + 0.5) / 20;
        below[2 * i] = x, below[2 * i + 1] = -0.1 * x * (1 - x);
    }
    cagd_fit_data data = {20, 2, below, NULL};
    cagd_fit_options o = options_with_exact_ends();
    cagd_fit_result *r;
    o.initial = &above;
    o.free = CAGD_FIT_WEIGHTS;
    assert_int_equal(cagd_fit(&data, &o, &r, NULL), CAGD_OK);
    assert_int_equal(r->termination, CAGD_FIT_FAILED);
    assert_non_null(strstr(r->message, "weight 1"));
    cagd_fit_free(r);
    o.weight_low = 0.01; /* then the bound is the minimum */
    assert_int_equal(cagd_fit(&data, &o, &r, NULL), CAGD_OK);
    assert_int_equal(r->termination, CAGD_FIT_CONVERGED);
    assert_true(r->at_bound[0]);
    cagd_fit_free(r);
}

/* Without intervals the curve and its standard errors are the same; no type of a conic is certain. */
static void intervals_may_be_left_out(void **state)
{
    (void)state;
    for (int i = 0; i < 30; i++) {
        double t = (i + 0.5) / 30;
        Q[2 * i] = 3 * t + 0.002 * sin(9.0 * i), Q[2 * i + 1] = t * (1 - t) * (2 + t) + 0.002 * cos(7.0 * i);
    }
    cagd_fit_data data = {30, 2, Q, NULL};
    cagd_fit_options o = cagd_fit_defaults();
    cagd_fit_result *with, *without;
    assert_int_equal(cagd_fit(&data, &o, &with, NULL), CAGD_OK);
    o.without_intervals = 1;
    assert_int_equal(cagd_fit(&data, &o, &without, NULL), CAGD_OK);
    assert_memory_equal(with->value, without->value, (size_t)with->unknowns * sizeof *with->value);
    for (int k = 0; k < with->unknowns; k++) {
        cagd_fit_estimate a = cagd_fit_unknown_estimate(with, k), b = cagd_fit_unknown_estimate(without, k);
        assert_true(a.by != CAGD_FIT_INTERVAL_NOT_SOUGHT && b.by == CAGD_FIT_INTERVAL_NOT_SOUGHT);
        assert_true(isfinite(b.error) && isnan(b.low) && isnan(b.high) && (isnan(a.error) || a.error == b.error));
    }
    assert_true(isnan(cagd_fit_invariant_estimate(without, 0).low));
    assert_int_not_equal(cagd_fit_conic_of(without).kind, CAGD_FIT_CONIC_CERTAIN);
    cagd_fit_free(with);
    cagd_fit_free(without);
}

/* Points in no order, some neighbours of which are outliers.  Whether there is structure in the distances from a curve that was tried does not
 * depend on the order in which the points are told: what is said of the trial is what is said of the same fit. */
static void trials_of_points_in_no_order_are_seen_as_they_are(void **state)
{
    (void)state;
    enum { POINTS = 61, STEP = 25, OUTLIERS = 4 };
    const cagd_fit_choices nothing = {0};
    int with_structure = 0, without = 0;
    state_of_noise = 3;
    for (int k = 0; k < POINTS; k++) { /* the k-th along the curve */
        const int i = k * STEP % POINTS;
        Q[2 * i] = 10.0 * k / (POINTS - 1);
        Q[2 * i + 1] = 2 * sin(0.6 * Q[2 * i]) + 0.02 * (noise() + noise() + noise());
        Q[2 * i + 1] += k >= POINTS / 2 && k < POINTS / 2 + OUTLIERS ? 0.6 : 0;
    }
    const cagd_fit_data data = {POINTS, 2, Q, NULL};
    cagd_fit_options o = cagd_fit_defaults();
    cagd_fit_quality quality = {.problems = CAGD_FIT_STRUCTURE};
    cagd_fit_cures cures;
    o.unordered = 1, o.loss = CAGD_FIT_HUBER, o.loss_scale = 0, o.without_intervals = 1;
    cagd_fit_result *r = fit(&data, &o);
    assert_int_equal(cagd_fit_cures_of(&data, &o, &nothing, r, &quality, &cures), CAGD_OK);
    cagd_fit_free(r);
    for (int k = 0; k < cures.count; k++) {
        const cagd_fit_trial *t = &cures.trial[k];
        if (!t->minimum)
            continue;
        assert_int_equal(cagd_fit_choose(&data, &t->options, &t->choices, &r, NULL), CAGD_OK);
        assert_int_equal(cagd_fit_quality_of(&data, &t->options, r, &quality), CAGD_OK);
        assert_int_equal(t->problems & CAGD_FIT_STRUCTURE, quality.problems & CAGD_FIT_STRUCTURE);
        *(t->problems & CAGD_FIT_STRUCTURE ? &with_structure : &without) += 1;
        cagd_fit_free(r);
    }
    assert_true(with_structure > 0 && without > 0);
}

/* Of a number of control points that is given those degrees from 2 to 5 are tried that cagd_fit takes it for, of closed curves as of open ones. */
static void degrees_are_tried_that_the_number_of_points_allows(void **state)
{
    (void)state;
    const cagd_fit_choices degrees[] = {{.closed = 0, .degree = 1}, {.closed = 1, .degree = 1}};
    const double turn = acos(-1) / 30;
    for (int i = 0; i < 60; i++)
        Q[2 * i] = 3 * cos(turn * i) + 0.01 * sin(9.0 * i), Q[2 * i + 1] = 2 * sin(turn * i) + 0.01 * cos(7.0 * i);
    cagd_fit_data data = {60, 2, Q, NULL};
    for (int closed = 0; closed <= 1; closed++)
        for (int count = 1; count <= 7; count++) {
            cagd_fit_options o = cagd_fit_defaults();
            cagd_fit_result *r = NULL;
            int allowed = 0;
            o.count = count, o.closed = closed, o.without_intervals = 1;
            o.free = CAGD_FIT_INNER_POINTS | CAGD_FIT_END_POINTS;
            for (o.degree = 2; o.degree <= 5; o.degree++) {
                allowed += cagd_fit(&data, &o, &r, NULL) == CAGD_OK;
                cagd_fit_free(r);
            }
            assert_int_equal(allowed, count < 3 ? 0 : count < 6 ? count - 2 : 4);
            o.closed = 0;
            const cagd_status status = cagd_fit_choose(&data, &o, &degrees[closed], &r, NULL);
            assert_int_equal(status, allowed > 0 ? CAGD_OK : CAGD_BAD_OPTION);
            assert_int_equal(r != NULL ? r->found.candidates : 0, allowed);
            assert_true(r == NULL || (r->period > 0) == closed);
            cagd_fit_free(r);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(intervals_may_be_left_out),
        cmocka_unit_test(a_weight_that_goes_to_zero_is_no_minimum),
        cmocka_unit_test(derivatives_are_those_of_the_kernels),
        cmocka_unit_test(feet_are_orthogonal),
        cmocka_unit_test(triangles_keep_the_normal_equations),
        cmocka_unit_test(the_model_has_the_second_derivatives),
        cmocka_unit_test(rank_is_that_of_the_stated_threshold),
        cmocka_unit_test(order_is_kept_for_the_sake_of_what_is_known_best),
        cmocka_unit_test(a_cusp_is_one_from_the_stated_radius_on),
        cmocka_unit_test(vectors_of_any_width_give_the_same),
        cmocka_unit_test(noise_free_curves_come_back),
        cmocka_unit_test(free_ends_slide),
        cmocka_unit_test(measured_ends_cut_the_curve),
        cmocka_unit_test(the_plain_formulation_finds_the_same_minimum),
        cmocka_unit_test(order_does_not_matter_when_there_is_none),
        cmocka_unit_test(bounds_hold),
        cmocka_unit_test(a_robust_loss_leaves_outliers_out),
        cmocka_unit_test(an_end_is_left_out_where_it_is_an_outlier),
        cmocka_unit_test(place_and_unit_do_not_matter),
        cmocka_unit_test(working_coordinates_are_exact),
        cmocka_unit_test(shifts_change_nothing),
        cmocka_unit_test(the_same_again),
        cmocka_unit_test(random_cubics_come_back),
        cmocka_unit_test(the_domain_may_be_any_interval),
        cmocka_unit_test(the_strategy_does_not_change_the_result),
        cmocka_unit_test(feet_on_a_given_curve_are_nearest_points),
        cmocka_unit_test(feet_of_points_between_two_parts_are_nearest_points),
        cmocka_unit_test(a_single_point_has_its_distance),
        cmocka_unit_test(bad_arguments_are_refused),
        cmocka_unit_test(degrees_are_tried_that_the_number_of_points_allows),
        cmocka_unit_test(trials_of_points_in_no_order_are_seen_as_they_are),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
