/* test_fit_parts.c -- what a fit is made of, each part against its definition. */
#include "proofs-tests/fit/options.h"

#include "core/fit/by_feet.h"
#include "core/fit/candidate.h"
#include "core/fit/ellipse.h"
#include "core/fit/ellipse_result.h"
#include "core/fit/feet.h"
#include "core/fit/means.h"
#include "core/fit/model.h"
#include "core/fit/order.h"
#include "core/fit/outliers.h"
#include "core/fit/problem.h"
#include "core/fit/sample.h"
#include "core/fit/strategy.h"
#include "core/fit/unknowns.h"
#include "core/number/limits.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* The roundings of some thirty operations on numbers of the size of 1. */
static const double ROUNDINGS = 32 * DBL_EPSILON;

static const double conic_knots[] = {0, 0, 0, 1, 1, 1}, line_knots[] = {0, 0, 1, 1};
static const double spline_knots[] = {0, 0, 0, 0, 0.4, 0.7, 1, 1, 1, 1};
static const double spline_points[] = {0, 0, 0, 1, 2, -1, 2, -1, 2, 3, 1, 1, 4, 1.5, -1, 5, 0, 0};
static const double spline_weights[] = {1, 2, 0.7, 1.4, 0.8, 1.3};
static const cagd_spline in_space = {3, 6, 3, spline_knots, spline_points, spline_weights};

/* A problem with all free and its initial curve in working coordinates. */
struct made {
    fit_problem p;
    fit_curve *curve;
};

static struct made make(const cagd_fit_data *data, const cagd_spline *initial, int unordered)
{
    struct made m;
    int where;
    cagd_fit_options o = options_with_exact_ends();
    o.initial = initial;
    o.free = CAGD_FIT_WEIGHTS | CAGD_FIT_INNER_POINTS | CAGD_FIT_END_POINTS;
    o.unordered = unordered;
    assert_int_equal(fit_problem_make(data, &o, &fit_usual_strategy, &m.p, &where), CAGD_OK);
    m.curve = fit_curve_new(m.p.degree, m.p.count, 0, m.p.dim, m.p.knots);
    assert_non_null(m.curve);
    fit_problem_curve(&m.p, initial, m.curve);
    return m;
}

static void release(struct made *m)
{
    fit_curve_free(m->curve);
    fit_problem_free(&m->p);
}

/* Points around the curve, with standard deviations of their own. */
enum { N = 40 };
static double Q[3 * N], sigma[N];
static cagd_fit_data around(int dim, double far)
{
    for (int i = 0; i < N; i++) {
        sigma[i] = 0.5 + (i * 7 % 5) / 4.0;
        for (int c = 0; c < dim; c++)
            Q[i * dim + c] = far + 2 + 3 * sin(1.0 + 7 * i + 3 * c + i * c);
    }
    return (cagd_fit_data){N, dim, Q, sigma};
}

static void unknowns_are_the_curve(void **state)
{
    (void)state;
    cagd_fit_data data = around(3, 0);
    struct made m = make(&data, &in_space, 0), other = make(&data, &in_space, 0);
    fit_problem *p = &m.p;
    double x[64];
    assert_int_equal(p->unknowns, 6 * 3 + 5); /* the first weight is 1 */
    for (int k = 0, j = 0; j < 6; j++) {
        if (j > 0) {
            assert_true(p->unknown[k].is_weight && p->unknown[k].index == j);
            assert_true(fabs(m.curve->weights[j] / spline_weights[j] - 1) < ROUNDINGS / 16);
            k++;
        }
        for (int c = 0; c < 3; c++, k++) {
            double coordinate = m.curve->points[3 * j + c] * p->unit + p->centre[c];
            assert_true(!p->unknown[k].is_weight && p->unknown[k].index == j && p->unknown[k].coordinate == c);
            assert_true(fabs(coordinate - spline_points[3 * j + c]) < ROUNDINGS / 16);
        }
    }
    for (int j = 0; j < 6; j++)
        other.curve->weights[j] = 1 + (j > 0) * 0.25 * j;
    for (int i = 0; i < 18; i++)
        other.curve->points[i] = 0.125 * i;
    fit_unknowns_of_curve(p, m.curve, other.curve, x); /* w (P - B), and w = b (1 + y) */
    for (int k = 0; k < p->unknowns; k++) {
        int j = p->unknown[k].index, c = 3 * j + p->unknown[k].coordinate;
        double w = 1 + (j > 0) * 0.25 * j,
               wanted = p->unknown[k].is_weight ? w / m.curve->weights[j] - 1 : w * (0.125 * c - m.curve->points[c]);
        assert_true(x[k] < -0.5 || fabs(x[k] - wanted) < ROUNDINGS);
    }
    fit_unknowns_to_curve(p, m.curve, x, m.curve);
    for (int i = 0; i < 18; i++)
        assert_true(fabs(m.curve->points[i] - 0.125 * i) < ROUNDINGS);
    for (int j = 1; j < 6; j++)
        assert_true(fabs(m.curve->weights[j] / (1 + 0.25 * j) - 1) < ROUNDINGS / 16);
    release(&m);
    release(&other);
}

/* sum |r_i| b_i + b_i^2/2 by Cauchy and Schwarz, and the rounding of the sum. */
static void the_error_of_a_cost_is_what_is_said(void **state)
{
    (void)state;
    for (int far = 0; far <= 100; far += 20) {
        cagd_fit_data data = around(3, far);
        struct made m = make(&data, &in_space, 0);
        double size = 2, squares = 0, cost = 3.25;
        for (int i = 0; i < N; i++)
            for (int c = 0; c < 3; c++)
                size = fmax(size, fabs(Q[3 * i + c] - m.p.centre[c]) / m.p.unit);
        for (int i = 0; i < N; i++)
            squares += pow((2 * 3 + 2) * DBL_EPSILON * size * m.p.unit / sigma[i], 2);
        double wanted = sqrt(2 * cost) * sqrt(squares) + squares / 2 + N * DBL_EPSILON * cost;
        assert_true(fabs(fit_problem_cost_error(&m.p, cost) / wanted - 1) < 1e-12);
        assert_true(fabs(fit_problem_cost_error(&m.p, 0) / (squares / 2) - 1) < 1e-12);
        release(&m);
    }
}

/* On a line the mean of points, by their precision, lies over the mean of their feet. */
static void means_are_weighted_by_precision(void **state)
{
    static const double P[] = {-1, -1, 1, 1};
    static const cagd_spline line = {1, 2, 2, line_knots, P, NULL};
    (void)state;
    cagd_fit_data data = around(2, 0);
    for (int i = 0; i < 2 * N; i++)
        Q[i] = (Q[i] - 2) / 4;
    struct made m = make(&data, &line, 0);
    double t[N], feet[4], D[9];
    for (int i = 0; i < N; i++)
        t[i] = (i + 0.5) / N;
    fit_problem few;
    assert_true(fit_sample_means(&m.p, m.curve, t, 4, &few, feet));
    assert_int_equal(few.points, 4);
    for (int g = 0; g < 4; g++) {
        double share = 0, foot = 0, off[2] = {0, 0};
        for (int i = g * N / 4; i < (g + 1) * N / 4; i++) {
            double weight = pow(m.p.unit / sigma[i], 2);
            share += weight;
            foot += weight * t[i];
            for (int c = 0; c < 2; c++)
                off[c] += weight * ((Q[2 * i + c] - m.p.centre[c]) / m.p.unit - (2 * t[i] - 1) / m.p.unit);
        }
        assert_true(fabs(feet[g] - foot / share) < ROUNDINGS);
        assert_true(fabs(few.precision[g] / sqrt(share) - 1) < ROUNDINGS);
        fit_curve_derivatives(m.curve, feet[g], D);
        for (int c = 0; c < 2; c++)
            assert_true(fabs(few.Q[2 * g + c] - D[c] - off[c] / share) < ROUNDINGS);
    }
    fit_sample_free(&few);
    assert_true(fit_sample_every(&m.p, 7, &few)); /* 0, 7, ..., 35, and 39 */
    assert_int_equal(few.points, 7);
    for (int k = 0; k < 7; k++) {
        int i = k < 6 ? 7 * k : 39;
        assert_true(few.precision[k] == m.p.precision[i] && few.Q[2 * k] == m.p.Q[2 * i] &&
                    few.Q[2 * k + 1] == m.p.Q[2 * i + 1]);
    }
    fit_sample_free(&few);
    release(&m);
}

/* Points in no order, of which each guess finds the order of one kind: along a line, around a centre, from neighbour to neighbour;
 * all of them where 0 is not. */
static void orders_are_found(void **state)
{
    static const double P[] = {0, 0, 1, 1};
    static const cagd_spline line = {1, 2, 2, line_knots, P, NULL};
    (void)state;
    for (int guess = 0; guess < FIT_ORDERS; guess++)
        for (int turn = 0; turn < 4; turn++) {
            int order[N];
            for (int i = 0; i < N; i++) {
                int k = i * 17 % N; /* the i-th given is the k-th along the curve */
                double s = (double)k / (N - 1),
                       angle = guess == 0   ? 0
                               : guess == 1 ? 0.3 + 5.2 * s
                                            : 9 * s,
                       radius = guess == 1 ? 1 : 0.3 + 0.7 * s;
                double x = guess == 0 ? 2 * s - 1 : radius * cos(angle + turn),
                       y = guess == 0 ? 0.1 * s * s : radius * sin(angle + turn);
                double a = guess == 0 ? turn * 0.7 : 0;
                Q[2 * i] = 2.3 + cos(a) * x - sin(a) * y;
                Q[2 * i + 1] = -2.1 + sin(a) * x + cos(a) * y;
            }
            cagd_fit_data data = {N, 2, Q, NULL};
            struct made m = make(&data, &line, 1);
            assert_true(m.p.centre[0] == 0 && m.p.centre[1] == 0);
            assert_true(fit_order(&m.p, (enum fit_order_kind)guess, order));
            int forward = order[0] * 17 % N == 0;
            for (int k = 0; k < N; k++)
                assert_int_equal(order[k] * 17 % N, forward ? k : N - 1 - k);
            release(&m);
        }
}

/* What the search says it gains is the difference of the costs. */
static void what_better_feet_gain(void **state)
{
    static const double k[] = {0, 0, 1 / 3.0, 2 / 3.0, 1, 1}, P[] = {-1, 10, -1, 0, 1, 0, 1, 10};
    static const cagd_spline u = {1, 4, 2, k, P, NULL};
    (void)state;
    for (int i = 0; i < N; i++) {
        sigma[i] = 0.5 + (i * 7 % 5) / 4.0;
        Q[2 * i] = 0.8 * sin(3.0 * i + 1);
        Q[2 * i + 1] = 1 + 9.0 * i / N;
    }
    cagd_fit_data data = {N, 2, Q, sigma};
    struct made m = make(&data, &u, 1);
    double known[N], t[N], best[N], gain, cost, D[9], before = 0, after = 0;
    for (int i = 0; i < N; i++) /* on the left side, or the right one */
        known[i] = i % 3 == 0 ? Q[2 * i + 1] / 30 + 2 / 3.0 : (10 - Q[2 * i + 1]) / 30;
    assert_true(fit_feet_search(&m.p, m.curve, best, &cost));
    assert_true(fit_feet_improve(&m.p, m.curve, known, t, &gain));
    for (int i = 0; i < N; i++) {
        double weight = pow(m.p.precision[i], 2) / 2;
        assert_true(fabs(t[i] - best[i]) < ROUNDINGS);
        assert_true(Q[2 * i] < 0 ? t[i] < 1 / 3.0 || Q[2 * i + 1] < 1 + Q[2 * i] : t[i] > 1 / 3.0);
        fit_curve_derivatives(m.curve, known[i], D);
        before += weight * fit_distance_squared(2, D, m.p.Q + 2 * i);
        fit_curve_derivatives(m.curve, t[i], D);
        after += weight * fit_distance_squared(2, D, m.p.Q + 2 * i);
    }
    assert_true(fabs(cost / after - 1) < 1e-13 && fabs(gain / (before - after) - 1) < 1e-12 && gain > 1);
    release(&m);
}

/* Beside the axis of a conic that is symmetric, with a parameter that is not, the two feet are nearly as near; so they are on a polygon that
 * is inscribed in it, on which the other one may be nearer. */
static void the_nearer_of_two_feet_is_found(void **state)
{
    static const double P[] = {0, 0, 1.5, 3, 3, 0};
    (void)state;
    for (int k = -6; k <= 6; k++) {
        double factor = exp(0.35 * k), w[] = {1, 0.9 * factor, factor * factor};
        const cagd_spline conic = {2, 3, 2, conic_knots, P, w};
        for (int i = 0; i < N; i++) { /* above the chord, below the centre of curvature at the vertex */
            double off = exp(-1 - i % 10 * 1.5) * (i % 2 ? 1 : -1);
            Q[2 * i] = 1.5 + off;
            Q[2 * i + 1] = -0.2 + 0.02 * i;
        }
        cagd_fit_data data = {N, 2, Q, NULL};
        cagd_fit_options o = options_with_exact_ends();
        cagd_fit_result *r;
        o.initial = &conic;
        o.free = 0;
        assert_int_equal(cagd_fit(&data, &o, &r, NULL), CAGD_OK);
        for (int i = 0; i < N; i++) {
            double foot = Q[2 * i] - r->residuals[2 * i];
            assert_true(Q[2 * i] < 1.5 ? foot < 1.5 : foot > 1.5);
        }
        cagd_fit_free(r);
    }
}

/* Where C'' = 0 and C''' is large, Taylor's polynomial of second order is no curve for long: what is told of the foot of the cubic (s, 32 (s -
 * 1/2)^3) at s = 1/2 is the curve at the parameter that is told, from wherever Newton's method comes and however long the domain is. */
static void the_foot_is_on_the_curve(void **state)
{
    static const double P[] = {0, -4, 1 / 3.0, 4, 2 / 3.0, -4, 1, 4};
    (void)state;
    for (int scale = -20; scale <= 20; scale += 10) {
        double length = ldexp(1, scale), knots[] = {0, 0, 0, 0, length, length, length, length}, q[] = {0.5, 0.125};
        fit_curve *c = fit_curve_new(3, 4, 0, 2, knots);
        assert_non_null(c);
        memcpy(c->points, P, sizeof P);
        fit_curve_update(c);
        for (int i = 0; i < 60; i++) {
            double D[9], E[9], t = length * (0.5 + ldexp(i % 2 ? 0.7 : -0.9, -9 - i / 2));
            assert_int_equal(fit_foot(c, q, &t, D), FOOT_ORTHOGONAL);
            fit_curve_derivatives(c, t, E);
            for (int m = 0; m < 2; m++)
                assert_true(fabs(D[m] - E[m]) <= 16 * DBL_EPSILON);
            assert_true(fabs(t / length - 0.5) <
                        16 * FOOT_EXACT * FOOT_EXACT); /* half of the second derivative of phi is 12 */
        }
        fit_curve_free(c);
    }
}

/* The largest degree has its place in all arrays, which the sanitizers see; the points of a line are its own feet. */
static void the_largest_degree(void **state)
{
    enum { DEGREE = CAGD_MAX_DEGREE };
    double k[2 * DEGREE + 2], P[2 * (DEGREE + 1)];
    (void)state;
    for (int i = 0; i <= DEGREE; i++) {
        k[i] = 0, k[DEGREE + 1 + i] = 1;
        P[2 * i] = (double)i / DEGREE, P[2 * i + 1] = 2 * P[2 * i];
    }
    for (int i = 0; i < N; i++)
        Q[2 * i] = (i + 0.5) / N, Q[2 * i + 1] = (2 * i + 1.0) / N;
    const cagd_spline line = {DEGREE, DEGREE + 1, 2, k, P, NULL};
    cagd_fit_data data = {N, 2, Q, NULL};
    cagd_fit_options o = options_with_exact_ends();
    cagd_fit_result *r;
    o.initial = &line;
    for (int free = 0; free <= CAGD_FIT_END_POINTS; free += CAGD_FIT_END_POINTS) {
        o.free = free;
        assert_int_equal(cagd_fit(&data, &o, &r, NULL), CAGD_OK);
        assert_true(r->rms < 1e-13);
        for (int i = 0; i < N && free == 0; i++)
            assert_true(fabs(r->feet[i] - (i + 0.5) / N) < 1e-12);
        cagd_fit_free(r);
    }
}

/* R = (1 0 0; 0 1 1; 0 0 e): its rank is 2 when e is nothing, and 3, by R itself, when it is small.  Second derivatives are left out where the
 * model would end below zero. */
static void the_model_keeps_to_rank_and_cost(void **state)
{
    (void)state;
    for (int tiny = 0; tiny < 2; tiny++)
        for (int held = 0; held < 3; held++) {
            double e = tiny ? 0x1p-56 : 0x1p-20, R[3 * 4] = {1, 0, 0, 1, 0, 1, 1, 2, 0, 0, e, 3 * e}, S[9] = {0}, x[3];
            int fixed[3] = {held & 1, held & 2, 0};
            fit_problem p = {.points = N, .dim = 2, .degree = 3, .unknowns = 3};
            fit_objective f = {.problem = &p, .triangle = R, .curvature = S, .cost = 100};
            fit_model m;
            assert_true(fit_model_of(&f, fixed, &m));
            assert_int_equal(m.rank, held == 2 ? 2 : 3 - tiny - (held > 0));
            fit_model_step(&m, x);
            if (held == 0 && !tiny) /* R x + z = 0; in the last two unknowns a rounding counts 1/e times */
                assert_true(fabs(x[0] + 1) < ROUNDINGS && fabs(x[1] - 1) < 4 * DBL_EPSILON / e &&
                            fabs(x[2] + 3) < 4 * DBL_EPSILON / e);
            else if (held == 0) /* the shortest of |x_1 + x_2 + 2| = 0 in columns of length 1 */
                for (int k = 0; k < 3; k++)
                    assert_true(fabs(x[k] + 1) < ROUNDINGS);
            else
                assert_true(x[held - 1] == 0);
            fit_model_free(&m);
        }
    for (int far = 0; far < 2; far++) { /* what is small counts against the length of its column */
        double R[2 * 3] = {1, far ? 0x1p40 : 1, 1, 0, 0x1p-20, 1}, S[4] = {0};
        int fixed[2] = {0, 0};
        fit_problem p = {.points = N, .dim = 2, .degree = 3, .unknowns = 2};
        fit_objective f = {.problem = &p, .triangle = R, .curvature = S, .cost = 100};
        fit_model m;
        assert_true(fit_model_of(&f, fixed, &m));
        assert_int_equal(m.rank, far ? 1 : 2);
        fit_model_free(&m);
    }
    for (int below = 0; below < 2; below++) { /* |y|^2 = 2 with the second derivative, 1 without */
        double R[2] = {1, 1}, S = -0.5, x;
        int fixed = 0;
        fit_problem p = {.points = N, .dim = 2, .degree = 3, .unknowns = 1};
        fit_objective f = {.problem = &p, .triangle = R, .curvature = &S, .cost = below ? 0.6 : 1.5};
        fit_model m;
        assert_true(fit_model_of(&f, &fixed, &m));
        assert_true(fabs(m.decrement * m.decrement - (below ? 1 : 2)) < ROUNDINGS);
        fit_model_step(&m, &x);
        assert_true(fabs(x + (below ? 1 : 2)) < ROUNDINGS);
        fit_model_free(&m);
    }
}

/* Points in order along a loop keep to their leg where another one is nearer. */
static void feet_in_order_keep_to_their_leg(void **state)
{
    enum { MANY = 500 };
    static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1}, P[] = {0, 0, 4, 3, -3, 3, 1, 0};
    static const cagd_spline loop = {3, 4, 2, knots, P, NULL};
    static double on[2 * MANY];
    (void)state;
    for (int i = 0; i < MANY; i++) {
        double t = i / (MANY - 1.0), *q = on + 2 * i;
        assert_int_equal(cagd_spline_point(&loop, t, CAGD_RIGHT, q), CAGD_OK);
        q[0] += 0.08; /* near the crossing this is across the other leg */
    }
    cagd_fit_data data = {MANY, 2, on, NULL};
    struct made ordered = make(&data, &loop, 0), any = make(&data, &loop, 1);
    double t[MANY], cost;
    int astray = 0;
    assert_true(fit_feet_search(&any.p, any.curve, t, &cost));
    for (int i = 0; i < MANY; i++)
        astray += fabs(t[i] - i / (MANY - 1.0)) > 0.2;
    assert_true(astray > 4); /* otherwise this would test nothing */
    assert_true(fit_feet_search(&ordered.p, ordered.curve, t, &cost));
    for (int i = 0; i < MANY; i++) {
        double s = i / (MANY - 1.0), D[9];
        assert_true(fabs(t[i] - s) < 0.2);
        const double *q = ordered.p.Q + 2 * i;
        fit_foot(ordered.curve, q, &s, D);
        /* Both are zeros of f(t) = (C - Q) C' but for its roundings, and f' = C'^2 + (C - Q) C''.  The last steps to them were
         * shorter than FOOT_EXACT of the domain, and Newton's method squares the error. */
        double slope = 0, size = 0;
        for (int c = 0; c < 2; c++) {
            slope += D[2 + c] * D[2 + c] + (D[c] - q[c]) * D[4 + c];
            size += (fabs(D[c]) + fabs(q[c])) * fabs(D[2 + c]);
        }
        assert_true(fabs(t[i] - s) < 2 * FOOT_EXACT * FOOT_EXACT + ROUNDINGS * size / slope);
    }
    release(&ordered);
    release(&any);
}

/* Points one apart on a line, scattered across it by s and back: (-1)^i s.  Three together have the mean +-s/3. */
static void zigzag(int n, double s, double points[])
{
    for (int i = 0; i < n; i++) {
        points[2 * i] = i;
        points[2 * i + 1] = i % 2 ? -s : s;
    }
}

static void neighbours_are_taken_together_where_points_scatter(void **state)
{
    (void)state;
    enum { MANY = 600 };
    double points[2 * MANY];
    const cagd_fit_data data = {MANY, 2, points, NULL};
    /* a side is sqrt(1 + 4 s^2) long, and sqrt(9 + 4 s^2/9) that of the means, which stands for three: less than 0.75 of these from s = 0.446
     * on, and 0.9 from 9 and 81 times 0.244 on */
    static const struct {
        double s;
        int neighbours;
    } of[] = {{0, 1},   {0.43, 1}, {0.46, 3},  {1.9, 3},
              {2.3, 9}, {16, 9},   {20.5, 27}, {1e6, 27}}; /* 600/81 are too few */
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        zigzag(MANY, of[k].s, points);
        assert_int_equal(fit_neighbours(&data), of[k].neighbours);
    }
    zigzag(59, 10, points);
    assert_int_equal(fit_neighbours(&(cagd_fit_data){59, 2, points, NULL}), 1);
    assert_int_equal(fit_neighbours(&(cagd_fit_data){60, 2, points, NULL}), 3);
}

static void means_of_neighbours(void **state)
{
    (void)state;
    enum { EIGHT = 8 };
    double points[2 * EIGHT], deviation[EIGHT] = {1, 1, 0.5, 1, 2, 1, 1, 1};
    zigzag(EIGHT, 3, points);
    const cagd_fit_data data = {EIGHT, 2, points, deviation}, plain = {EIGHT, 2, points, NULL};
    cagd_fit_data means;
    assert_int_equal(fit_means(&data, 3, &means), CAGD_OK);
    assert_int_equal(means.count, 2); /* of 3 and of 5 */
    const double x[] = {(0 + 1 + 4 * 2) / 6.0, (3 + 0.25 * 4 + 5 + 6 + 7) / 4.25};
    const double y[] = {(3 - 3 + 4 * 3) / 6.0, (-3 + 0.25 * 3 - 3 + 3 - 3) / 4.25};
    for (int g = 0; g < 2; g++) {
        assert_true(fabs(means.points[2 * g] - x[g]) < 1e-14 && fabs(means.points[2 * g + 1] - y[g]) < 1e-14);
        assert_true(fabs(means.sigma[g] - 1 / sqrt(g == 0 ? 6 : 4.25)) < 1e-15);
    }
    fit_means_free(&means);
    assert_int_equal(fit_means(&plain, 4, &means), CAGD_OK);
    assert_true(means.count == 2 && means.sigma == NULL && means.points[0] == 1.5 && means.points[1] == 0);
    fit_means_free(&means);
}

/* The median of distances 1, ..., 50 over that of normal errors, times sqrt(n/(n - k)): with a smoothing term k is what the points
 * determine of the unknowns, and not how many these are. */
static void the_robust_deviation_counts_what_is_determined(void **state)
{
    (void)state;
    enum { POINTS = 50 };
    double distances[POINTS], place[2 * POINTS] = {0};
    for (int i = 0; i < POINTS; i++)
        distances[i] = (i % 2 ? 1 : -1) * (1 + i * 7 % POINTS);
    const cagd_fit_data data = {POINTS, 2, place, NULL};
    cagd_fit_result r = {.count = POINTS, .distances = distances, .unknowns = 120, .rank = 120, .effective = 9.8};
    r.degrees_of_freedom = POINTS - 10;
    const double normal = 25.5 / 0.67448975019608174;
    assert_true(fabs(fit_robust_deviation(&data, &r) / (normal * sqrt(50 / 40.0)) - 1) < ROUNDINGS);
    r.unknowns = r.rank = 12, r.effective = 12, r.degrees_of_freedom = POINTS - 12; /* without one, the rank */
    assert_true(fabs(fit_robust_deviation(&data, &r) / (normal * sqrt(50 / 38.0)) - 1) < ROUNDINGS);
    r.effective = NAN; /* a matrix that is singular: every unknown counts */
    assert_true(fabs(fit_robust_deviation(&data, &r) / (normal * sqrt(50 / 38.0)) - 1) < ROUNDINGS);
    r.degrees_of_freedom = 0;
    assert_true(fit_robust_deviation(&data, &r) == 0);
}

/* Whatever belongs to a point goes with it where points are put in the order of their feet; what was there is left as it was. */
static void all_of_a_point_goes_by_its_foot(void **state)
{
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int known = 0; known < 2; known++) {
            double feet[N], distances[N], residuals[3 * N];
            int at_end[N], outlier[N];
            cagd_fit_data data = around(dim, 0);
            data.sigma = known ? sigma : NULL;
            for (int i = 0; i < N; i++) {
                feet[i] = i * 17 % N / (N - 1.0), distances[i] = i + 0.5;
                at_end[i] = i % 3 == 0, outlier[i] = i % 7 == 0;
                for (int c = 0; c < dim; c++)
                    residuals[i * dim + c] = 100 * i + c;
            }
            const cagd_fit_result r = {.count =
                                           N - 1, /* the last point is left out, as one that repeats the first is */
                                       .feet = feet,
                                       .distances = distances,
                                       .residuals = residuals,
                                       .foot_at_end = at_end,
                                       .outlier = known ? outlier : NULL,
                                       .end_points = {5, -1},
                                       .largest_at = 11,
                                       .rms = 2.5};
            fit_by_feet s;
            assert_true(fit_by_feet_of(&data, &r, &s));
            assert_true(s.data.count == N - 1 && s.data.dim == dim && (s.data.sigma != NULL) == known);
            assert_true(s.result.count == N - 1 && s.result.rms == 2.5 && (s.result.outlier != NULL) == known);
            for (int j = 0; j < N - 1; j++) {
                const int i = (int)(s.result.distances[j] - 0.5);
                assert_true(j == 0 || s.result.feet[j] > s.result.feet[j - 1]);
                assert_true(s.result.feet[j] == feet[i] && s.result.foot_at_end[j] == at_end[i]);
                assert_memory_equal(s.result.residuals + j * dim, residuals + i * dim, (size_t)dim * sizeof *residuals);
                assert_memory_equal(s.data.points + j * dim, Q + i * dim, (size_t)dim * sizeof *Q);
                assert_true(!known || (s.data.sigma[j] == sigma[i] && s.result.outlier[j] == outlier[i]));
                assert_int_equal(s.result.end_points[0] == j, i == 5);
                assert_int_equal(s.result.largest_at == j, i == 11);
            }
            assert_int_equal(s.result.end_points[1], -1);
            assert_true(feet[1] == 17 / (N - 1.0) && r.end_points[0] == 5);
            fit_by_feet_free(&s);
        }
}

/* The score as cagd_fit.h prints it: of N points in space n = 2 N; two of the 9 unknowns are of measured ends, and an unknown deviation is one
 * more. */
static void scores_are_as_printed(void **state)
{
    (void)state;
    const cagd_fit_result r = {.effective = 9, .end_points = {0, N - 1}, .chi_squared = 3.25};
    const double n = 2 * N;
    for (int known = 0; known < 2; known++) {
        const cagd_fit_data data = {N, 3, Q, known ? sigma : NULL};
        const double k = known ? 7 : 8, more = k * log(n) * n / (n - k - 2);
        const double score = known ? r.chi_squared + more : n * log(r.chi_squared / n) + more;
        assert_true(fabs(fit_score(&data, &r) / score - 1) < ROUNDINGS);
    }
    const cagd_fit_data few = {4, 3, Q, NULL}; /* n - k - 2 < 0 */
    assert_true(isinf(fit_score(&few, &r)));
}

/* Points near an ellipse, in the plane and in space, with standard deviations of their own or without: how far they are from the circle that
 * comes closest is a length in their unit. */
static void the_distances_from_a_circle_are_lengths(void **state)
{
    (void)state;
    const double turn = 2 * acos(-1) / N;
    for (int dim = 2; dim <= 3; dim++)
        for (int known = 0; known < 2; known++)
            for (int unit = 1; unit <= 1000; unit += 999) {
                for (int i = 0; i < N; i++) {
                    const double x[3] = {3 * cos(turn * i), 2 * sin(turn * i), 0.02 * cos(7.0 * i)};
                    sigma[i] = unit * (0.5 + (i * 7 % 5) / 4.0) / 100;
                    for (int c = 0; c < dim; c++)
                        Q[i * dim + c] = unit * (x[c] + 0.01 * sin(5.0 * i + c));
                }
                const cagd_fit_data data = {N, dim, Q, known ? sigma : NULL};
                cagd_fit_options o = cagd_fit_defaults();
                cagd_fit_result *r;
                fit_ellipse round;
                double phi[N], sum = 0;
                o.closed = 1;
                assert_int_equal(fit_ellipse_result(&data, &o, &r), CAGD_OK);
                assert_true(r != NULL && r->found.ellipse.known && !r->found.ellipse.circle);
                assert_true(fit_ellipse_of(&data, 1, NULL, &round, phi) && round.converged);
                for (int i = 0; i < N; i++)
                    for (int c = 0; c < dim; c++) {
                        const double *a = round.x + dim, *b = a + dim;
                        sum += pow(Q[i * dim + c] - round.x[c] - a[c] * cos(phi[i]) - b[c] * sin(phi[i]), 2);
                    }
                assert_true(fabs(r->found.ellipse.circle_rms / sqrt(sum / N) - 1) < 1e-12);
                cagd_fit_free(r);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unknowns_are_the_curve),
        cmocka_unit_test(the_error_of_a_cost_is_what_is_said),
        cmocka_unit_test(means_are_weighted_by_precision),
        cmocka_unit_test(orders_are_found),
        cmocka_unit_test(what_better_feet_gain),
        cmocka_unit_test(the_nearer_of_two_feet_is_found),
        cmocka_unit_test(the_foot_is_on_the_curve),
        cmocka_unit_test(the_largest_degree),
        cmocka_unit_test(the_model_keeps_to_rank_and_cost),
        cmocka_unit_test(feet_in_order_keep_to_their_leg),
        cmocka_unit_test(neighbours_are_taken_together_where_points_scatter),
        cmocka_unit_test(means_of_neighbours),
        cmocka_unit_test(the_robust_deviation_counts_what_is_determined),
        cmocka_unit_test(the_distances_from_a_circle_are_lengths),
        cmocka_unit_test(scores_are_as_printed),
        cmocka_unit_test(all_of_a_point_goes_by_its_foot),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
