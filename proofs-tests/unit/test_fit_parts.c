/* test_fit_parts.c -- what a fit is made of, each part against its definition. */
#include "proofs-tests/fit/options.h"

#include "core/fit/arguments.h"
#include "core/fit/attempt.h"
#include "core/fit/beneath.h"
#include "core/fit/by_feet.h"
#include "core/fit/candidate.h"
#include "core/fit/closing.h"
#include "core/fit/curvature.h"
#include "core/fit/detour.h"
#include "core/fit/ellipse.h"
#include "core/fit/ellipse_result.h"
#include "core/fit/feet.h"
#include "core/fit/knots.h"
#include "core/fit/means.h"
#include "core/fit/model.h"
#include "core/fit/order.h"
#include "core/fit/outliers.h"
#include "core/fit/polygon.h"
#include "core/fit/problem.h"
#include "core/fit/quantile.h"
#include "core/fit/rank.h"
#include "core/fit/sample.h"
#include "core/fit/search.h"
#include "core/fit/smoothing.h"
#include "core/fit/starts.h"
#include "core/fit/strategy.h"
#include "core/fit/unknowns.h"
#include "core/number/limits.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
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

/* ---- what is asked for -------------------------------------------------------------------------------------- */

/* Every option at its bounds: what is on the bound, or just beyond it, and what goes together. */
static void options_at_their_bounds(void **state)
{
    (void)state;
    const cagd_fit_options good = cagd_fit_defaults();
    static const double knots[] = {0, 0, 0, 1, 1, 1}, P[6] = {0, 0, 1, 2, 3, 0};
    cagd_spline given = {2, 3, 2, knots, P, NULL};
#define OPTION(change, status)                                                                                         \
    do {                                                                                                               \
        cagd_fit_options o = good;                                                                                     \
        change;                                                                                                        \
        assert_int_equal(fit_check_options(&o), status);                                                               \
    } while (0)
    OPTION(o.free = 7, CAGD_OK);
    OPTION(o.free = 8 + 7, CAGD_BAD_OPTION);
    OPTION(o.free = CAGD_FIT_INNER_POINTS, CAGD_OK);
    OPTION(o.free = CAGD_FIT_END_POINTS, CAGD_BAD_OPTION);
    OPTION((o.free = CAGD_FIT_END_POINTS, o.degree = 1), CAGD_OK);
    OPTION((o.free = CAGD_FIT_END_POINTS, o.initial = &given), CAGD_OK);
    OPTION((o.free = 0, o.initial = &given), CAGD_OK);
    OPTION(o.ends = CAGD_FIT_ENDS_SLIDE, CAGD_OK);
    OPTION(o.ends = (cagd_fit_ends)2, CAGD_BAD_OPTION);
    OPTION(o.loss = CAGD_FIT_HUBER, CAGD_OK);
    OPTION(o.loss = CAGD_FIT_CAUCHY, CAGD_OK);
    OPTION(o.loss = (cagd_fit_loss)3, CAGD_BAD_OPTION);
    OPTION(o.loss_scale = 0, CAGD_OK);
    OPTION(o.loss_scale = -DBL_MIN, CAGD_BAD_OPTION);
    OPTION(o.loss_scale = INFINITY, CAGD_BAD_OPTION);
    OPTION(o.weight_low = 0.9999, CAGD_OK);
    OPTION(o.weight_low = 1, CAGD_BAD_OPTION);
    OPTION(o.weight_low = -DBL_MIN, CAGD_BAD_OPTION);
    OPTION(o.weight_high = 1.0001, CAGD_OK);
    OPTION(o.weight_high = 1, CAGD_BAD_OPTION);
    OPTION(o.starts = CAGD_FIT_MAX_STARTS, CAGD_OK);
    OPTION(o.starts = CAGD_FIT_MAX_STARTS + 1, CAGD_BAD_OPTION);
    OPTION(o.starts = 0, CAGD_BAD_OPTION);
    OPTION(o.max_iterations = 1, CAGD_OK);
    OPTION(o.max_iterations = 0, CAGD_BAD_OPTION);
    OPTION(o.tolerance = DBL_MIN, CAGD_OK);
    OPTION(o.tolerance = -1, CAGD_BAD_OPTION);
    OPTION(o.tolerance = NAN, CAGD_BAD_OPTION);
    OPTION((o.smooth = 1, o.free = 6), CAGD_OK);
    OPTION(o.smooth = 1, CAGD_BAD_OPTION); /* weights are free */
    OPTION((o.smooth = -1, o.free = 6), CAGD_BAD_OPTION);
    OPTION((o.smooth = INFINITY, o.free = 6), CAGD_BAD_OPTION);
    OPTION((o.smooth = NAN, o.free = 6), CAGD_BAD_OPTION);
    OPTION(o.closed = 1, CAGD_OK);
    OPTION(o.closed = 2, CAGD_BAD_OPTION);
    OPTION(o.closed = -1, CAGD_BAD_OPTION);
    OPTION(o.monotone = 1, CAGD_OK);
    OPTION(o.monotone = 2, CAGD_BAD_OPTION);
    OPTION(o.monotone = -1, CAGD_BAD_OPTION);
    OPTION((o.monotone = 1, o.unordered = 1), CAGD_BAD_OPTION);
    OPTION((o.monotone = 1, o.loss = CAGD_FIT_HUBER), CAGD_BAD_OPTION);
    OPTION((o.monotone = 1, o.loss = CAGD_FIT_CAUCHY), CAGD_BAD_OPTION);
    OPTION((o.monotone = 1, o.free = 0, o.initial = &given), CAGD_BAD_OPTION);
    OPTION(o.count = CAGD_FIT_MAX_CONTROL_POINTS, CAGD_OK);
    OPTION(o.count = CAGD_FIT_MAX_CONTROL_POINTS + 1, CAGD_BAD_OPTION);
    given.count = CAGD_FIT_MAX_CONTROL_POINTS;
    OPTION(o.initial = &given, CAGD_OK);
    given.count++;
    OPTION(o.initial = &given, CAGD_BAD_CURVE);
#undef OPTION
}

/* The first and the last number, in every coordinate, and what is wrong with the last deviation. */
static void data_at_their_ends(void **state)
{
    (void)state;
    double points[12], deviations[4];
    int where;
    for (int dim = 2; dim <= 3; dim++) {
        cagd_fit_data d = {4, dim, points, deviations};
        for (int k = 0; k < 12; k++)
            points[k] = k % dim;
        for (int i = 0; i < 4; i++)
            deviations[i] = 0.5;
        assert_int_equal(fit_check_data(&d, 0, &where), CAGD_ALL_EQUAL);
        assert_int_equal(where, -1);
        assert_int_equal(fit_check_data(&d, 1, &where), CAGD_OK);
        for (int k = 0; k < 4 * dim; k++) { /* one number alone tells them apart, one alone is none */
            const double before = points[k];
            points[k] = before + 1;
            assert_int_equal(fit_check_data(&d, 0, &where), CAGD_OK);
            assert_int_equal(where, -1);
            points[k] = k % 2 ? NAN : -INFINITY;
            assert_int_equal(fit_check_data(&d, 0, &where), CAGD_BAD_DATA);
            assert_int_equal(where, k / dim);
            points[k] = before;
        }
        points[1] += 1;
        for (int i = 0; i < 4; i++) {
            static const double wrong[] = {0, -1, NAN, INFINITY};
            for (int k = 0; k < 4; k++) {
                deviations[i] = wrong[k];
                assert_int_equal(fit_check_data(&d, 0, &where), CAGD_BAD_DATA);
                assert_int_equal(where, i);
            }
            deviations[i] = DBL_MIN;
            assert_int_equal(fit_check_data(&d, 0, &where), CAGD_OK);
        }
        d.count = 2;
        assert_int_equal(fit_check_data(&d, 0, &where), CAGD_OK);
        d.count = 1;
        assert_int_equal(fit_check_data(&d, 0, &where), CAGD_TOO_FEW);
        assert_int_equal(fit_check_data(&d, 1, &where), CAGD_OK);
        d.count = 0;
        assert_int_equal(fit_check_data(&d, 1, &where), CAGD_TOO_FEW);
        d.count = -1;
        assert_int_equal(fit_check_data(&d, 1, &where), CAGD_BAD_DATA);
        d.count = CAGD_FIT_MAX_POINTS + 1;
        assert_int_equal(fit_check_data(&d, 0, &where), CAGD_BAD_DATA);
        d.count = 4, d.dim = 1;
        assert_int_equal(fit_check_data(&d, 0, &where), CAGD_BAD_DATA);
        d.dim = 4;
        assert_int_equal(fit_check_data(&d, 0, &where), CAGD_BAD_DATA);
    }
}

/* ---- knots ---------------------------------------------------------------------------------------------------- */

static void knots_are_spelt(void **state)
{
    (void)state;
    fit_knots k;
    double U[16];
    fit_knots_even(3, &k);
    assert_true(k.inner == 3 && k.u[0] == 0.25 && k.u[1] == 0.5 && k.u[2] == 0.75);
    fit_knots_insert(&k, 0.9);
    fit_knots_insert(&k, 0.1);
    fit_knots_insert(&k, 0.6);
    static const double inserted[] = {0.1, 0.25, 0.5, 0.6, 0.75, 0.9};
    assert_int_equal(k.inner, 6);
    assert_memory_equal(k.u, inserted, sizeof inserted);
    static const double moved[6][4][5] = {{{0.25, 0.5, 0.6, 0.75, 0.9}, {0}, {0.175, 0.5, 0.6, 0.75, 0.9}, {0}},
                                          {{0.1, 0.5, 0.6, 0.75, 0.9},
                                           {0.175, 0.5, 0.6, 0.75, 0.9},
                                           {0.1, 0.375, 0.6, 0.75, 0.9},
                                           {0.175, 0.375, 0.6, 0.75, 0.9}}};
    for (int i = 0; i < 6; i++)
        for (int shift = 0; shift < 4; shift++) {
            if ((i == 0 && shift & 1) || (i == 5 && shift & 2))
                continue;
            const fit_knots less = fit_knots_without(&k, i, shift);
            assert_int_equal(less.inner, 5);
            for (int m = 0; m < 5; m++) {
                double wanted = inserted[m < i ? m : m + 1];
                if ((shift & 1 && m == i - 1) || (shift & 2 && m == i))
                    wanted = (wanted + inserted[i]) / 2;
                assert_true(less.u[m] == wanted && (i > 1 || fabs(wanted - moved[i][shift][m]) < DBL_EPSILON));
            }
        }
    k = (fit_knots){2, {0.25, 0.75}};
    static const double open[] = {0, 0, 0, 0, 0.25, 0.75, 1, 1, 1, 1},
                        closed[] = {-1, -0.75, -0.25, 0, 0.25, 0.75, 1, 1.25, 1.75, 2};
    assert_int_equal(fit_knots_count(&k, 3, 0), 6);
    assert_int_equal(fit_knots_count(&k, 3, 1), 3);
    fit_knots_spell(&k, 3, 0, U);
    assert_memory_equal(U, open, sizeof open);
    fit_knots_spell(&k, 3, 1, U);
    assert_memory_equal(U, closed, sizeof closed);
    static const double closed_by_seven[] = {-3, -2.5, -2, -1.5, -1, -0.5, 0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4};
    k = (fit_knots){1, {0.5}};
    double V[17];
    fit_knots_spell(&k, 7, 1, V);
    assert_memory_equal(V + 1, closed_by_seven, sizeof closed_by_seven);
}

/* Over knots of which those before are a part the curve is the same, open or closed, in the plane and in space. */
static void a_spline_on_finer_knots_is_the_same(void **state)
{
    (void)state;
    enum { MOST = 16 };
    static const double fine[] = {0.1, 0.3, 0.4, 0.55, 0.7, 0.9};
    for (int closed = 0; closed < 2; closed++)
        for (int p = 1; p <= 3; p++)
            for (int dim = 2; dim <= 3; dim++) {
                const fit_knots coarse = {4, {0.3, 0.4, 0.7, 0.9}};
                fit_knots k = {6, {0}};
                memcpy(k.u, fine, sizeof fine);
                double U[2 * MOST], V[2 * MOST], P[3 * MOST], R[3 * MOST], a[3], b[3];
                const int own = fit_knots_count(&coarse, p, closed), old = own + (closed ? p : 0),
                          count = fit_knots_count(&k, p, closed) + (closed ? p : 0);
                for (int i = 0; i < old * dim; i++)
                    P[i] = sin(1.0 + 3 * (i % (own * dim)));
                fit_knots_spell(&coarse, p, closed, U);
                fit_knots_spell(&k, p, closed, V);
                const cagd_spline from = {p, old, dim, U, P, NULL}, to = {p, count, dim, V, R, NULL};
                fit_respace(&from, closed ? own : 0, V, count, R);
                for (int i = 0; i <= 50; i++) {
                    const cagd_side side = i < 50 ? CAGD_RIGHT : CAGD_LEFT;
                    assert_int_equal(cagd_spline_point(&from, i / 50.0, side, a), CAGD_OK);
                    assert_int_equal(cagd_spline_point(&to, i / 50.0, side, b), CAGD_OK);
                    for (int c = 0; c < dim; c++)
                        assert_true(fabs(a[c] - b[c]) < 64 * ROUNDINGS);
                }
            }
}

/* ---- whether points come back ----------------------------------------------------------------------------------- */

enum { MOST_AROUND = 400 };
static double ring[3 * MOST_AROUND];

/* So many points around a circle, from the angle `from` on, `turn` degrees from one to the next, in a plane of space for dim 3. */
static cagd_fit_data on_circle(int n, int dim, double from, double turn)
{
    for (int i = 0; i < n; i++) {
        const double phi = (from + turn * i) * acos(-1) / 180, x = 7 + 2 * cos(phi), y = -3 + 2 * sin(phi);
        ring[i * dim] = x, ring[i * dim + 1] = dim == 2 ? y : 0.6 * y;
        if (dim == 3)
            ring[i * dim + 2] = 0.8 * y;
    }
    return (cagd_fit_data){n, dim, ring, NULL};
}

static cagd_fit_closing closing_of(int n, const double P[])
{
    return cagd_fit_closing_of(&(cagd_fit_data){n, 2, P, NULL}, 0);
}

static void points_come_back(void **state)
{
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int n = 8; n <= 360; n += 88) {
            cagd_fit_data d = on_circle(n, dim, 30, 360.0 / n);
            assert_int_equal(cagd_fit_closing_of(&d, 0), CAGD_FIT_AROUND);
            assert_false(fit_repeats_first(&d));
            d = on_circle(n + 1, dim, 30, 360.0 / n);
            assert_int_equal(cagd_fit_closing_of(&d, 0), CAGD_FIT_REPEATED);
            assert_true(fit_repeats_first(&d));
            ring[n * dim + dim - 1] += 0x1p-39 * 4; /* the farthest one is 4 from the first, or hardly less */
            assert_false(fit_repeats_first(&d));
            d = on_circle(n, dim, 30, 270.0 / n);
            assert_int_equal(cagd_fit_closing_of(&d, 0), CAGD_FIT_OPEN);
        }
    const double straight[] = {0, 0, 1, 0, 2, 0, 3, 0, 0, 0, 0, 0};
    assert_true(fit_repeats_first(&(cagd_fit_data){6, 2, straight, NULL}));
    assert_false(fit_repeats_first(&(cagd_fit_data){5, 2, straight, NULL})); /* too few for that */
    const double star[] = {0, 2, -1.9, 0.6, -1.2, -1.6, 1.2, -1.6, 1.9, 0.6};
    assert_int_equal(closing_of(5, star), CAGD_FIT_AROUND);
    assert_int_equal(closing_of(4, star), CAGD_FIT_OPEN);
    /* Around a rectangle: steps 2, 2, 2, 1, 2, 2 and the way back 3, one and a half times as long; then a little longer; and so where the first, the last
     * step is the longer one of the two. */
    const double box[] = {0, 0, 2, 0, 4, 0, 4, 2, 4, 3, 2, 3, 0, 3},
                 farther[] = {0, 0, 2, 0, 4, 0, 4, 2, 4, 3, 2, 3, 0, 3.01};
    assert_int_equal(closing_of(7, box), CAGD_FIT_AROUND);
    assert_int_equal(closing_of(7, farther), CAGD_FIT_OPEN);
    const double first[] = {0, 0, 4, 0, 4, 2, 4, 4, 4, 6, 2, 6, 0, 6},
                 last[] = {0, 0, 2, 0, 4, 0, 4, 2, 4, 4, 4, 6, 0, 6};
    assert_int_equal(closing_of(7, first), CAGD_FIT_AROUND);
    assert_int_equal(closing_of(7, last), CAGD_FIT_AROUND);
    const double neither[] = {0, 0, 2, 0, 4, 0, 4, 3, 4, 6, 2, 6, 0, 6};
    assert_int_equal(closing_of(7, neither), CAGD_FIT_OPEN);
}

/* A drop comes back with a corner, whether its tip is repeated or not; a short way back across the curve has no direction of its own. */
static void a_corner_where_points_come_back(void **state)
{
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int repeated = 0; repeated < 2; repeated++) {
            const int n = 40 + repeated;
            for (int i = 0; i < n; i++) {
                const double t = 2 * acos(-1) * i / 40, x = 5 * sin(t / 2), y = 2 * sin(t); /* at the tip 77 degrees */
                ring[i * dim] = dim == 2 ? y : 3, ring[i * dim + 1] = x;
                if (dim == 3)
                    ring[i * dim + 2] = y;
            }
            assert_int_equal(cagd_fit_closing_of(&(cagd_fit_data){n, dim, ring, NULL}, 0), CAGD_FIT_CORNER);
        }
    cagd_fit_data d = on_circle(20, 2, 0, 18.9);
    ring[38] = 9.02, ring[39] = -3.01; /* beside the first one, (9, -3), and farther out */
    assert_int_equal(cagd_fit_closing_of(&d, 0), CAGD_FIT_AROUND);
    /* Where all corners are as sharp, that of the seam is none; where it is sharper by half, it is one. */
    const double box[] = {0, 0, 2, 0, 4, 0, 4, 2, 4, 4, 2, 4, 0, 4, 0, 2};
    assert_int_equal(closing_of(8, box), CAGD_FIT_AROUND);
    const double sharp[] = {0,   0,   2,   0.2, 4,   1,   5.5, 2.6, 6, 4.7, 5.3, 6.9,
                            3.8, 8.4, 1.6, 9.2, 0.4, 7.6, 0.1, 5.4, 0, 3.5, 0,   1.7};
    assert_int_equal(closing_of(12, sharp), CAGD_FIT_AROUND); /* 96 degrees, and another one of 73 */
    double rounder[24];
    memcpy(rounder, sharp, sizeof sharp);
    rounder[14] = 2, rounder[15] = 8.9, rounder[16] = 0.7; /* the other one has 61 */
    assert_int_equal(closing_of(12, rounder), CAGD_FIT_CORNER);
    for (int sharper = 0; sharper < 2; sharper++) { /* 56 degrees and 64 */
        for (int i = 0; i < 40; i++) {
            const double t = 2 * acos(-1) * i / 40;
            ring[2 * i] = (sharper ? 2.5 : 2.1) * sin(t / 2), ring[2 * i + 1] = 2 * sin(t);
        }
        assert_int_equal(closing_of(40, ring), sharper ? CAGD_FIT_CORNER : CAGD_FIT_AROUND);
    }
}

/* Points in no order go around where no gap is wider than a sixth of a turn, over the angle pi or elsewhere, and where they lie along a ring. */
static void points_around_a_centre(void **state)
{
    (void)state;
    for (int turn = 0; turn < 360; turn += 45) {
        for (int n = 11; n <= 100; n += n < 13 ? 1 : 29) {
            on_circle(n, 2, turn, 360.0 / n);
            double mixed[200];
            for (int i = 0; i < n; i++)
                memcpy(mixed + 2 * i, ring + 2 * (i * 7 % n), 2 * sizeof *mixed);
            const cagd_fit_data d = {n, 2, n % 7 ? mixed : ring, NULL};
            assert_int_equal(cagd_fit_closing_of(&d, 1), n < 12 ? CAGD_FIT_OPEN : CAGD_FIT_AROUND);
        }
        cagd_fit_data d = on_circle(60, 2, turn, 4);
        assert_int_equal(cagd_fit_closing_of(&d, 1), CAGD_FIT_OPEN);
        d = on_circle(60, 2, turn, 5.3); /* the gap of 47 degrees is seen from the mean as one of 57 or less */
        assert_int_equal(cagd_fit_closing_of(&d, 1), CAGD_FIT_AROUND);
        for (int off = 0; off < 2; off++) { /* a ring that scatters by a tenth, and by six tenths of its radius */
            d = on_circle(80, 2, turn, 4.5);
            for (int i = 0; i < 80; i += 2)
                for (int c = 0; c < 2; c++)
                    ring[2 * i + c] += (off ? -0.75 : -0.2) * (ring[2 * i + c] - (c == 0 ? 7 : -3));
            assert_int_equal(cagd_fit_closing_of(&d, 1), off ? CAGD_FIT_OPEN : CAGD_FIT_AROUND);
        }
        d = on_circle(80, 2, turn, 4.5);
        for (int i = 0; i < 80; i++)
            ring[2 * i] *= 3; /* an ellipse of three to one, whose radius changes along each group */
        assert_int_equal(cagd_fit_closing_of(&d, 1), CAGD_FIT_AROUND);
    }
    const cagd_fit_data space = on_circle(40, 3, 0, 9);
    assert_int_equal(cagd_fit_closing_of(&space, 1), CAGD_FIT_OPEN);
}

/* ---- what is said of a result, against results made by hand ------------------------------------------------------- */

/* A polygon as a spline of degree 1 over 0, 1, 2, ..., and points with feet and distances of them. */
enum { CORNERS = 24, TOLD = 128 };
static double polygon_points[3 * CORNERS], polygon_knots[CORNERS + 2];
static double feet_told[TOLD], distances_told[TOLD], residuals_told[3 * TOLD], points_told[3 * TOLD], sigma_told[TOLD];
static int at_end_told[TOLD], outlier_told[TOLD];

static cagd_fit_result told(int dim, int corners, const double P[], int n)
{
    memcpy(polygon_points, P, (size_t)(dim * corners) * sizeof *P);
    for (int k = 0; k < corners + 2; k++)
        polygon_knots[k] = k == 0 ? 0 : k > corners ? corners - 1 : k - 1;
    memset(at_end_told, 0, sizeof at_end_told);
    memset(outlier_told, 0, sizeof outlier_told);
    memset(residuals_told, 0, sizeof residuals_told);
    memset(distances_told, 0, sizeof distances_told);
    return (cagd_fit_result){.curve = {1, corners, dim, polygon_knots, polygon_points, NULL},
                             .relative = polygon_points,
                             .count = n,
                             .feet = feet_told,
                             .distances = distances_told,
                             .residuals = residuals_told,
                             .foot_at_end = at_end_told,
                             .outlier = outlier_told,
                             .end_points = {-1, -1},
                             .degrees_of_freedom = n - 2,
                             .effective = 2,
                             .termination = CAGD_FIT_CONVERGED};
}

/* The points of that: at their feet, and off by their residuals, which in the plane are the distances along y. */
static cagd_fit_data points_of(const cagd_fit_result *r)
{
    const int dim = r->curve.dim;
    for (int i = 0; i < r->count; i++) {
        assert_int_equal(cagd_spline_point(&r->curve, feet_told[i],
                                           feet_told[i] < r->curve.count - 1 ? CAGD_RIGHT : CAGD_LEFT,
                                           points_told + i * dim),
                         CAGD_OK);
        if (dim == 2)
            residuals_told[2 * i] = 0, residuals_told[2 * i + 1] = distances_told[i];
        for (int c = 0; c < dim; c++)
            points_told[i * dim + c] += residuals_told[i * dim + c];
    }
    return (cagd_fit_data){r->count, dim, points_told, NULL};
}

static const double along_x[6] = {0, 0, 0, 10, 0, 0}, along_x_of_plane[4] = {0, 0, 10, 0};

/* Pairs of neighbours in the order of their feet, P(X >= same) by halves; a distance of 0 is on no side. */
static void sides_are_counted(void **state)
{
    (void)state;
    static const double side[] = {1, 2, -1, 0, 3, 1, 1, -2, -1};
    const cagd_fit_options o = cagd_fit_defaults();
    cagd_fit_runs runs;
    for (int mixed = 0; mixed < 2; mixed++) {
        cagd_fit_result r = told(2, 2, along_x_of_plane, 9);
        for (int i = 0; i < 9; i++) {
            const int k = mixed ? i * 4 % 9 : i;
            feet_told[i] = k / 8.0, distances_told[i] = side[k];
        }
        const cagd_fit_data d = points_of(&r);
        assert_int_equal(cagd_fit_runs_of(&d, &o, &r, &runs), CAGD_OK);
        assert_int_equal(runs.pairs, 6);
        assert_int_equal(runs.same, 4);
        assert_true(fabs(runs.probability - (15 + 6 + 1) / 64.0) < 1e-14);
        assert_true(isnan(runs.local_probability) && isnan(runs.next_probability) && isnan(runs.lag_probability));
    }
    cagd_fit_result r = told(2, 2, along_x_of_plane, 9); /* all on the curve */
    const cagd_fit_data d = points_of(&r);
    assert_int_equal(cagd_fit_runs_of(&d, &o, &r, &runs), CAGD_OK);
    assert_true(runs.pairs == 0 && runs.same == 0 && isnan(runs.probability));
    r = told(3, 2, along_x, 5);
    static const double off[5][2] = {{1, 0}, {0, 1}, {1, 1}, {-1, 0.5}, {-2, 2}}; /* products 0, 1, -0.5, 3 */
    for (int i = 0; i < 5; i++) {
        feet_told[i] = i / 4.0, distances_told[i] = hypot(off[i][0], off[i][1]);
        residuals_told[3 * i + 1] = off[i][0], residuals_told[3 * i + 2] = off[i][1];
    }
    const cagd_fit_data space = points_of(&r);
    assert_int_equal(cagd_fit_runs_of(&space, &o, &r, &runs), CAGD_OK);
    assert_true(runs.pairs == 3 && runs.same == 2 && fabs(runs.probability - 0.5) < 1e-14);
}

/* The distances of `n` points in deviations and clipped, without those that say nothing: v[j*across + c], at the feet t. */
static int told_values(const cagd_fit_data *d, const cagd_fit_result *r, double scale, double v[], double t[])
{
    const int across = r->curve.dim == 2 ? 1 : 3;
    int count = 0;
    for (int i = 0; i < r->count; i++) {
        const double unit = scale * (d->sigma != NULL ? d->sigma[i] : 1), size = fabs(r->distances[i]) / unit;
        if (i == r->end_points[0] || i == r->end_points[1] || r->foot_at_end[i] || r->outlier[i])
            continue;
        for (int c = 0; c < across; c++)
            v[count * across + c] =
                (across == 1 ? r->distances[i] : r->residuals[3 * i + c]) / unit * fmin(1, 2.5 / size);
        t[count++] = r->feet[i];
    }
    return count;
}

/* The sum of products over its deviation for points k apart, and over the sum of squares. */
static double z_of_lag(int n, int across, const double v[], int k, double *correlation)
{
    double sum = 0, squares = 0, all = 0;
    for (int j = 0; j < n; j++) {
        double product = 0;
        for (int c = 0; c < across; c++) {
            product += j + k < n ? v[j * across + c] * v[(j + k) * across + c] : 0;
            all += v[j * across + c] * v[j * across + c];
        }
        sum += product, squares += product * product;
    }
    *correlation = sum / all;
    return sum / sqrt(squares);
}

/* Lags and windows of distances that are made up, in the plane and in space, with deviations and without, of squares and of a robust loss, against sums from
 * their definition.  Without a bend, the curve is straight. */
static void waves_and_windows_are_those_of_the_definition(void **state)
{
    (void)state;
    for (int variant = 0; variant < 32; variant++) {
        const int dim = 2 + (variant & 1), given = variant & 2, robust = variant & 4, n = variant & 8 ? 16 : 70,
                  across = dim == 2 ? 1 : 3;
        cagd_fit_result r = told(dim, 2, dim == 2 ? along_x_of_plane : along_x, n);
        cagd_fit_options o = cagd_fit_defaults();
        cagd_fit_runs runs;
        double sum = 0, v[3 * TOLD], t[TOLD], correlation;
        for (int i = 0; i < n; i++) {
            const double wave = variant & 16 ? sin(2.1 * i) : i % 23 < 9 ? 0.8 : -0.3, noise_here = sin(37.0 * i * i);
            double *left = residuals_told + i * dim;
            sigma_told[i] = 0.5 + i % 3;
            feet_told[i] = (i + 0.5) / n;
            left[1] = (wave + noise_here + (i == n / 3 ? 30 : 0)) * (given ? sigma_told[i] : 1);
            if (dim == 3)
                left[2] = (sin(2.1 * i + 1) + sin(29.0 * i * i)) * (given ? sigma_told[i] : 1);
            distances_told[i] = dim == 2 ? left[1] : hypot(left[1], left[2]);
            r.rms += distances_told[i] * distances_told[i] / n;
            sum += pow(distances_told[i] / (given ? sigma_told[i] : 1), 2);
        }
        r.rms = sqrt(r.rms), r.deviation = 0.9;
        if (n > 16) {
            r.end_points[0] = 0, r.end_points[1] = n - 1, at_end_told[1] = 1, at_end_told[n - 2] = 1,
            outlier_told[40] = 1;
        }
        o.loss = robust ? (variant & 16 ? CAGD_FIT_HUBER : CAGD_FIT_CAUCHY) : CAGD_FIT_SQUARES;
        cagd_fit_data d = points_of(&r);
        d.sigma = given ? sigma_told : NULL;
        assert_int_equal(cagd_fit_runs_of(&d, &o, &r, &runs), CAGD_OK);
        const double scale = robust ? 0.9 : sqrt(sum / r.degrees_of_freedom);
        const int count = told_values(&d, &r, scale, v, t);
        double z = z_of_lag(count, across, v, 1, &correlation), most = 0, excess = 0;
        assert_true(fabs(runs.next_correlation - correlation) < 1e-12);
        assert_true(fabs(runs.next_probability - erfc(z / sqrt(2)) / 2) < 1e-12);
        int lag = 0, points = 0, from = 0, windows = 0;
        double at_lag = 0;
        for (int k = 2; k <= count / 3; k++)
            if ((z = z_of_lag(count, across, v, k, &correlation)) > most)
                most = z, lag = k, at_lag = correlation;
        assert_int_equal(runs.lag, lag);
        assert_true(fabs(runs.lag_correlation - at_lag) < 1e-12);
        assert_true(fabs(runs.lag_probability - fmin(1, (count / 3 - 1) * erfc(most / sqrt(2)) / 2)) < 1e-12);
        for (int m = 4; m <= count / 2; m *= 2)
            for (int i = 0; i + m <= count; i += m / 4, windows++) {
                const int low = i > 32 ? i - 32 : 0, high = i + m + 32 < count ? i + m + 32 : count;
                double square = 0, scatter = 0;
                for (int c = 0; c < across; c++) {
                    double mean = 0;
                    for (int j = i; j < i + m; j++)
                        mean += v[j * across + c] / m;
                    square += mean * mean;
                    for (int j = low + 1; j < high; j++)
                        scatter += pow(v[j * across + c] - v[(j - 1) * across + c], 2) / 2 / (high - low - 1) /
                                   (across == 1 ? 1 : 2);
                }
                z = sqrt(square * m / fmax(1, scatter));
                if (z > excess + 1e-12)
                    excess = z, points = m, from = i;
            }
        assert_true(fabs(runs.excess - excess) < 1e-10);
        assert_int_equal(runs.points, points);
        assert_true(runs.from == t[from] && runs.to == t[from + points - 1]);
        const double all = windows * (across == 1 ? erfc(excess / sqrt(2)) : exp(-excess * excess / 2));
        if (all <= 0.001)
            assert_true(fabs(runs.local_probability / all - 1) < 1e-6);
        else
            assert_true(runs.local_probability > 0 && runs.local_probability <= fmin(1, all) * (1 + 1e-9));
    }
}

/* Fifteen points are too few for windows, sixteen are enough, and seventeen of which two are ends say nothing of a wave. */
static void windows_need_sixteen_points(void **state)
{
    (void)state;
    const cagd_fit_options o = cagd_fit_defaults();
    for (int n = 15; n <= 17; n++)
        for (int ends = 0; ends < 2; ends++) {
            cagd_fit_runs runs;
            cagd_fit_result r = told(2, 2, along_x_of_plane, n);
            for (int i = 0; i < n; i++)
                feet_told[i] = (i + 0.5) / n, distances_told[i] = i < n / 2 ? 1 : -1;
            if (ends)
                r.end_points[0] = 0, r.end_points[1] = n - 1;
            r.rms = 1;
            const cagd_fit_data d = points_of(&r);
            assert_int_equal(cagd_fit_runs_of(&d, &o, &r, &runs), CAGD_OK);
            assert_int_equal(isnan(runs.next_probability) != 0, n - 2 * ends < 16);
            assert_int_equal(isnan(runs.local_probability) != 0, n < 16);
            r.degrees_of_freedom = 0; /* no deviation, and nothing in units of it */
            assert_int_equal(cagd_fit_runs_of(&d, &o, &r, &runs), CAGD_OK);
            assert_true(isnan(runs.next_probability) && isnan(runs.local_probability) && runs.pairs == n - 1);
        }
    /* All orders of equal distances are the same, and reach what one of them does. */
    cagd_fit_runs runs;
    cagd_fit_result r = told(2, 2, along_x_of_plane, 16);
    for (int i = 0; i < 16; i++)
        feet_told[i] = (i + 0.5) / 16, distances_told[i] = 0.5;
    r.rms = 0.5;
    const cagd_fit_data d = points_of(&r);
    assert_int_equal(cagd_fit_runs_of(&d, &o, &r, &runs), CAGD_OK);
    assert_true(runs.points == 8 && runs.excess > 0 && runs.local_probability <= 1);
    assert_true(runs.same == 15 && fabs(runs.probability - 0x1p-15) < 1e-18);
}

/* On a quarter of a circle of radius R the bend makes s/R of a mean in deviations s; nothing is said where R is less than five of them. */
static void the_bend_of_the_curve_is_taken_off(void **state)
{
    (void)state;
    const cagd_fit_options o = cagd_fit_defaults();
    static const double knots[] = {0, 0, 0, 1, 1, 1};
    const double w[] = {1, sqrt(0.5), 1};
    for (int dim = 2; dim <= 3; dim++)
        for (int bent = 0; bent < 3; bent++) {
            const double R = bent == 0 ? 1e6 : bent == 1 ? 25 : 4.9;
            double P[9] = {0}, v[TOLD];
            P[0] = R, P[dim] = R, P[dim + 1] = R, P[2 * dim + 1] = R;
            cagd_fit_runs runs;
            cagd_fit_result r = told(2, 2, along_x_of_plane, 32);
            r.curve = (cagd_spline){2, 3, dim, knots, P, w}, r.relative = P;
            for (int i = 0; i < 32; i++) {
                feet_told[i] = (i + 0.5) / 32, distances_told[i] = v[i] = i % 8 < 4 ? 1 : -1;
                if (dim == 3)
                    residuals_told[3 * i] = 0, residuals_told[3 * i + 1] = 0, residuals_told[3 * i + 2] = v[i];
            }
            r.rms = 1, r.degrees_of_freedom = 32;
            for (int i = 0; i < 2 * 32; i++)
                points_told[i] = 0;
            const cagd_fit_data d = {32, dim, points_told, NULL};
            assert_int_equal(cagd_fit_runs_of(&d, &o, &r, &runs), CAGD_OK);
            assert_int_equal(runs.points, bent == 2 ? 0 : 4);
            assert_true(fabs(runs.excess - (bent == 2 ? 0 : 2 - 2 / R)) < 1e-12);
        }
}

/* The polygon of points and curve: open, closed, in space, of pairs of points where they scatter. */
static void lengths_are_those_of_the_polygons(void **state)
{
    (void)state;
    static const double flat[] = {0, 0, 3, 0, 3, 4}, high[] = {0, 0, 0, 1, 2, 2, 1, 2, 5, 5, 2, 5};
    cagd_fit_result r = told(2, 3, flat, 2);
    feet_told[0] = 0, feet_told[1] = 2;
    cagd_fit_data d = points_of(&r);
    assert_true(fabs(cagd_fit_length_ratio(&d, &r) - 7 / 5.0) < 1e-14);
    r = told(2, 3, flat, 3);
    feet_told[1] = 1, feet_told[2] = 2;
    d = points_of(&r);
    assert_true(fabs(cagd_fit_length_ratio(&d, &r) - 1) < 1e-14);
    r.period = 2; /* as if it were closed: the way back counts as well */
    assert_true(fabs(cagd_fit_length_ratio(&d, &r) - 7 / 12.0) < 1e-14);
    r = told(3, 4, high, 4); /* 3, 3, 4 */
    for (int i = 0; i < 4; i++)
        feet_told[i] = i;
    d = points_of(&r);
    assert_true(fabs(cagd_fit_length_ratio(&d, &r) - 1) < 1e-14);
    feet_told[1] = 0, feet_told[2] = 3;
    d = points_of(&r);
    assert_true(fabs(cagd_fit_length_ratio(&d, &r) - 10 / sqrt(25 + 4 + 25)) < 1e-14);
    /* (i, +-s): sides of sqrt(1 + 4 s^2); of 2, 4, ... together of 2, 4, ..., as soon as these are 4 rms sqrt(2/size). */
    static const double s[] = {0.1, 0.3, 1, 2};
    static const int size[] = {1, 2, 4, 4};
    for (int k = 0; k < 4; k++) {
        double P[4] = {0, 0, 63, 0};
        r = told(2, 2, P, 64);
        for (int i = 0; i < 64; i++)
            feet_told[i] = i / 63.0, distances_told[i] = i % 2 ? -s[k] : s[k];
        d = points_of(&r);
        r.rms = s[k];
        const double wanted = size[k] == 1 ? 63 * sqrt(1 + 4 * s[k] * s[k]) : 64 - size[k];
        assert_true(fabs(cagd_fit_length_ratio(&d, &r) * wanted / 63 - 1) < 1e-12);
    }
    polygon_points[2] = INFINITY;
    assert_true(isnan(cagd_fit_length_ratio(&d, &r)));
}

/* Distances against the last place that is written, given deviations, extent and width, in the plane and in space. */
static void what_distances_are_beneath(void **state)
{
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int places = 0; places <= 10; places++) {
            const double unit = pow(10, -places);
            cagd_fit_result r = told(2, 2, along_x_of_plane, 40);
            for (int i = 0; i < 40; i++)
                for (int c = 0; c < dim; c++)
                    points_told[i * dim + c] = (c == 0 ? 100 * i + 3 : 37 * i * (c + i) % 4001 + 11) / pow(10, places);
            const cagd_fit_data d = {40, dim, points_told, NULL};
            for (int side = -1; side <= 1; side += 2) {
                r.largest = unit * sqrt(dim) / 2 * (1 + side * 1e-9);
                assert_int_equal(fit_beneath(&d, &r),
                                 side < 0 && places <= 9 ? CAGD_FIT_BENEATH_DIGITS : CAGD_FIT_BENEATH_NOTHING);
            }
        }
    /* Digits of a fiftieth of the extent or more are no rounding: 49 and 51 cells. */
    static const double coarse[] = {0, 0, 49, 0, 3, 1, 4, 2}, fine[] = {0, 0, 51, 0, 3, 1, 4, 2};
    cagd_fit_result r = told(2, 2, along_x_of_plane, 4);
    r.largest = 0.5;
    assert_int_equal(fit_beneath(&(cagd_fit_data){4, 2, coarse, NULL}, &r), CAGD_FIT_BENEATH_NOTHING);
    assert_int_equal(fit_beneath(&(cagd_fit_data){4, 2, fine, NULL}, &r), CAGD_FIT_BENEATH_DIGITS);
    /* Deviations: every one, the first and the last. */
    double points[40], deviation[20];
    for (int i = 0; i < 20; i++)
        points[2 * i] = i + 1 / 3.0, points[2 * i + 1] = sqrt(i), deviation[i] = 0.1 + i % 2;
    r = told(2, 2, along_x_of_plane, 20), r.largest = 1.1;
    for (int i = -1; i < 20; i++) {
        for (int k = 0; k < 20; k++)
            distances_told[k] = (k % 3 ? 1 : -1) * deviation[k] * (k == i ? 1 + 1e-9 : 1);
        assert_int_equal(fit_beneath(&(cagd_fit_data){20, 2, points, deviation}, &r),
                         i < 0 ? CAGD_FIT_BENEATH_DEVIATIONS : CAGD_FIT_BENEATH_NOTHING);
    }
    /* An arch in a tilted plane: 4/3 of its height from the axis, and the box about it. */
    for (int dim = 2; dim <= 3; dim++) {
        for (int i = 0; i < 40; i++) {
            const double x = sqrt(2) + i / 39.0, y = 1e3 + 0.03 * ((i == 0 || i == 39) ? 1 : i % 2 ? 1 : -1);
            points_told[i * dim] = x, points_told[i * dim + dim - 1] = y;
            if (dim == 3)
                points_told[i * dim + 1] = 5 + x; /* along (1, 1, 0) */
        }
        double middle[3];
        const cagd_fit_data d = {40, dim, points_told, NULL};
        const double extent = hypot(dim == 2 ? 1 : sqrt(2), 0.06);
        assert_true(fabs(fit_extent_of(&d, middle) / extent - 1) < 1e-9);
        assert_true(fabs(middle[0] - sqrt(2) - 0.5) < 1e-12 && fabs(middle[dim - 1] - 1e3) < 1e-9);
        double u[40], v[40], uu = 0, uv = 0, vv = 0, mean[2] = {0},
                             width = 0; /* along and across, in the plane of the points */
        for (int i = 0; i < 40; i++) {
            u[i] = (points_told[i * dim] - sqrt(2)) * (dim == 2 ? 1 : sqrt(2)),
            v[i] = points_told[i * dim + dim - 1] - 1e3;
            mean[0] += u[i] / 40, mean[1] += v[i] / 40;
        }
        for (int i = 0; i < 40; i++)
            u[i] -= mean[0], v[i] -= mean[1], uu += u[i] * u[i], uv += u[i] * v[i], vv += v[i] * v[i];
        const double angle = atan2(2 * uv, uu - vv) / 2;
        for (int i = 0; i < 40; i++)
            width = fmax(width, 2 * fabs(cos(angle) * v[i] - sin(angle) * u[i]));
        assert_true(FIT_OF_WIDTH * width < FIT_OF_EXTENT * extent);
        for (int side = -1; side <= 1; side += 2) {
            r = told(2, 2, along_x_of_plane, 40);
            r.largest = FIT_OF_WIDTH * width * (1 + side * 1e-6);
            assert_int_equal(fit_beneath(&d, &r), side < 0 ? CAGD_FIT_BENEATH_SIZE : CAGD_FIT_BENEATH_NOTHING);
        }
    }
}

/* Of an octagon with a spike between two of its feet, over the seam or not; the chords beside turn by 45 degrees to either side. */
static void detours_of_an_octagon(void **state)
{
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int at = 0; at < 8; at++)
            for (int closed = 0; closed < 2; closed++)
                for (int far = 0; far < 2;
                     far++) { /* another spike, which is shorter or longer, two sides further on */
                    const int n = 8, other = (at + 2) % 8;
                    const double height[2] = {2, far ? 2.5 : 1.9};
                    double P[3 * CORNERS], knot[CORNERS];
                    int corners = 0, foot = 0;
                    for (int k = 0; k <= n; k++) {
                        const double phi = acos(-1) / 4 * k, middle = phi + acos(-1) / 8;
                        const int spike = k < n && (k == at || k == other);
                        feet_told[foot] = corners, foot += k < n;
                        for (int s = 0; s <= spike; s++, corners++) {
                            const double R = s ? height[k == other] : 1, a = s ? middle : phi;
                            P[corners * dim] = R * cos(a), P[corners * dim + 1] = R * sin(a);
                            if (dim == 3)
                                P[corners * dim + 2] = 4;
                        }
                    }
                    memcpy(knot, feet_told, (size_t)n * sizeof *knot);
                    cagd_fit_result r = told(dim, corners, P, n);
                    fit_detour detour;
                    const double chord = 2 * sin(acos(-1) / 8), most = chord / cos(acos(-1) / 4),
                                 inner_side = cos(acos(-1) / 8);
                    for (int big = 0; big < 2; big++) { /* of 10 rms all is an excess, or nothing is */
                        const int seam = n - 1, larger = far ? other : at, smaller = far ? at : other,
                                  seen = larger != seam || closed ? larger : smaller;
                        /* an open curve: the last side has no chord behind it, nor the first one before it */
                        const int end = seen == n - 2 || seen == 0;
                        const double bound = !closed && end ? chord / cos(acos(-1) / 8) : most;
                        const double length = 2 * hypot(height[seen == other] - inner_side, chord / 2);
                        if (!closed && seen == seam)
                            continue;
                        r.rms = big ? (length - bound) / 10 * (1 + 1e-9) : 0;
                        assert_int_equal(fit_detour_of(&r, closed, &detour), CAGD_OK);
                        if (big && closed) {
                            assert_true(detour.length == 0 && detour.excess == 0);
                        } else if (!big && (closed || (at != seam && other != seam && at != 0 && other != 0 &&
                                                       at != n - 2 && other != n - 2))) {
                            assert_true(fabs(detour.length - length) < 1e-12 &&
                                        fabs(detour.excess - length + bound) < 1e-12);
                            assert_true(detour.from == knot[seen] && detour.to == knot[(seen + 1) % n]);
                        }
                    }
                }
    /* A curve that goes straight on makes none, however few its feet; nor does one whose chords turn back. */
    static const double back[] = {0, 0, 5, 0, 5, 1, 0, 1};
    cagd_fit_result r = told(2, 4, back, 4);
    fit_detour detour;
    for (int i = 0; i < 4; i++)
        feet_told[i] = i;
    assert_int_equal(fit_detour_of(&r, 0, &detour), CAGD_OK);
    assert_true(detour.length == 0);
    r.count = 0;
    assert_int_equal(fit_detour_of(&r, 0, &detour), CAGD_OK);
    assert_true(detour.length == 0);
    r.count = 1;
    assert_int_equal(fit_detour_of(&r, 1, &detour), CAGD_OK);
}

static cagd_fit_quality quality_told(const cagd_fit_data *d, const cagd_fit_options *o, const cagd_fit_result *r)
{
    cagd_fit_quality q;
    assert_int_equal(cagd_fit_quality_of(d, o, r, &q), CAGD_OK);
    return q;
}

static cagd_fit_quality quality_here(const cagd_fit_result *r)
{
    const cagd_fit_data d = points_of(r);
    const cagd_fit_options o = cagd_fit_defaults();
    return quality_told(&d, &o, r);
}

static const double straight_line[] = {0, 0, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0, 7, 0, 8, 0, 9, 0, 10, 0};

/* Feet `step` apart but for one gap, behind foot `before`, in the order of an index that is mixed. */
static cagd_fit_result with_gap(int n, double from, double step, int before, double gap)
{
    cagd_fit_result r = told(2, 11, straight_line, n);
    for (int i = 0; i < n; i++)
        feet_told[i * 7 % n] = from + step * i + (i > before ? gap - step : 0);
    return r;
}

/* A tenth of the length and four times the usual step, among the first feet, the last ones and over the seam. */
static void gaps_between_feet(void **state)
{
    (void)state;
    cagd_fit_options o = cagd_fit_defaults();
    o.unordered = 1;
    for (int before = 0; before < 19; before += 6)
        for (int wide = 0; wide < 4; wide++) {
            const double step = wide < 2 ? 0.2 : 0.3, gap = wide == 0   ? 0.99
                                                            : wide == 1 ? 1.01
                                                            : wide == 2 ? 1.19
                                                                        : 1.21;
            cagd_fit_result r = with_gap(20, 0.5, step, before, gap);
            const cagd_fit_data d = points_of(&r);
            const cagd_fit_quality q = quality_told(&d, &o, &r);
            assert_true(fabs(q.gap - gap / 10) < 1e-12);
            assert_true(fabs(q.gap_from - (0.5 + step * before)) < 1e-12 && fabs(q.gap_to - q.gap_from - gap) < 1e-12);
            assert_int_equal((q.problems & CAGD_FIT_GAPS) != 0, wide % 2);
        }
    for (int kind = 0; kind < 3; kind++) { /* over the seam of a closed spline or a whole ellipse */
        cagd_fit_result r = with_gap(20, 1, 0.4, 3, 0.6);
        r.period = kind == 1, r.found.ellipse.whole = kind == 2;
        const cagd_fit_data d = points_of(&r);
        const cagd_fit_quality q = quality_told(&d, &o, &r);
        assert_true(fabs(q.gap - (kind ? 0.22 : 0.06)) < 1e-12 && fabs(q.gap_to - (kind ? 1 : 2.8)) < 1e-12);
        assert_int_equal((q.problems & CAGD_FIT_GAPS) != 0, kind > 0);
        assert_true(kind ? q.gap_from > q.gap_to : q.gap_from < q.gap_to);
    }
    cagd_fit_result r = told(2, 11, straight_line, 2); /* two feet have no usual step */
    feet_told[0] = 1, feet_told[1] = 9;
    const cagd_fit_data d = points_of(&r);
    const cagd_fit_quality q = quality_told(&d, &o, &r);
    assert_true(fabs(q.gap - 0.8) < 1e-12 && !(q.problems & CAGD_FIT_GAPS));
    r.count = 1;
    assert_true(quality_told(&d, &o, &r).gap == 0);
}

/* Feet that fall back by more than 6 rms count, one in twenty is too many, and one alone is by 12 rms and a tenth of the length. */
static void feet_that_fall_back(void **state)
{
    (void)state;
    static const struct {
        int count;
        double back, rms;
        int counted, problem;
    } of[] = {{1, 0.5, 0.08, 1, 0},  {1, 0.5, 0.09, 0, 0},  {2, 0.5, 0.08, 2, 1},   {2, 0.5, 0.09, 0, 0},
              {1, 1.01, 0.08, 1, 1}, {1, 0.99, 0.08, 1, 0}, {1, 1.01, 0.085, 1, 0}, {2, 1.01, 0.17, 0, 0}};
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        cagd_fit_result r = told(2, 11, straight_line, 40);
        for (int i = 0; i < 40; i++)
            feet_told[i] = 0.2 * i;
        for (int m = 0; m < of[k].count; m++) /* the last foot, and the second one, or the one before the last */
            feet_told[m == 0 ? 39 : 20] = feet_told[m == 0 ? 38 : 19] - of[k].back;
        r.rms = of[k].rms;
        const cagd_fit_quality q = quality_here(&r);
        assert_int_equal(q.backwards, of[k].counted);
        assert_int_equal((q.problems & CAGD_FIT_BACKWARDS) != 0, of[k].problem);
    }
    for (int kind = 0; kind < 3; kind++) { /* over the seam nothing falls back */
        cagd_fit_result r = told(2, 11, straight_line, 40);
        for (int i = 0; i < 40; i++)
            feet_told[i] = fmod(0.25 * i + 7, 10);
        r.rms = 0.01, r.period = kind == 1, r.found.ellipse.whole = kind == 2;
        const cagd_fit_quality q = quality_here(&r);
        assert_int_equal(q.backwards, kind == 0);
        assert_int_equal((q.problems & CAGD_FIT_BACKWARDS) != 0, kind == 0);
    }
    cagd_fit_result r = told(2, 11, straight_line, 40);
    for (int i = 0; i < 40; i++)
        feet_told[i] = 9 - 0.2 * i;
    const cagd_fit_data d = points_of(&r);
    cagd_fit_options o = cagd_fit_defaults();
    assert_true(quality_told(&d, &o, &r).problems & CAGD_FIT_BACKWARDS);
    o.unordered = 1; /* where there is no order nothing falls back, nor has the polygon a length */
    cagd_fit_quality q = quality_told(&d, &o, &r);
    assert_true(q.problems == 0 && q.backwards == 0 && isnan(q.length_ratio));
    o.unordered = 0, o.free = 0;
    q = quality_told(&d, &o, &r);
    assert_true(q.problems == 0 && q.backwards == 0 && isnan(q.length_ratio));
}

/* A curve that crosses itself once or twice between its points, which do not; the last side of a closed one meets the first. */
static void crossings_of_curve_and_points(void **state)
{
    (void)state;
    static const double once[] = {0, 0, 4, 0, 4, 2, 2.13, 2, 2.13, -1.7, 8, -1.7},
                        twice[] = {0, 0, 6, 0, 6, 2, 2.13, 2, 2.13, -1.7, 4.21, -1.7, 4.21, 2.9, 9, 2.9};
    for (int k = 0; k < 2; k++)
        for (int seen = 0; seen < 2; seen++) {
            const int corners = k ? 8 : 6, n = seen ? 4 * (corners - 1) + 1 : 2;
            cagd_fit_result r = told(2, corners, k ? twice : once, n);
            for (int i = 0; i < n; i++)
                feet_told[i] = (double)(corners - 1) * i / (n - 1);
            const cagd_fit_quality q = quality_here(&r);
            assert_int_equal(q.crossings, k ? 3 : 1);
            assert_int_equal(q.crossings_of_points, seen ? (k ? 3 : 1) : 0);
            assert_int_equal((q.problems & CAGD_FIT_LOOPS) != 0, !seen);
        }
    static const double eight[] = {0, 0, 4, 4, 4, 0.3, 0, 3.1, 0, 0}, box[] = {0, 0, 4, 0, 4, 4, 0, 4, 0, 0};
    for (int closed = 0; closed < 3; closed++)
        for (int k = 0; k < 2; k++) {
            cagd_fit_result r = told(2, 5, k ? eight : box, 4);
            for (int i = 0; i < 4; i++)
                feet_told[i] = i;
            r.period = closed == 1 ? 4 : 0, r.found.ellipse.whole = closed == 2;
            const cagd_fit_quality q = quality_here(&r);
            assert_int_equal(q.crossings, k);
            assert_true(closed == 2 || q.crossings_of_points == k);
        }
    /* Two ends that cross within 6 rms of one another, and that go on beyond it. */
    for (int out = 0; out < 2; out++) {
        const double ends[] = {-0.1 * (1 + 9 * out), 0, 5, 0.2, 8, 3, 5, 4, 4, 3, 0, 0.05, -0.1, -0.05};
        cagd_fit_result r = told(2, 7, ends, 2);
        feet_told[0] = 0, feet_told[1] = 6, r.rms = 0.05;
        assert_int_equal(quality_here(&r).crossings, out);
        r.rms = 0;
        assert_int_equal(quality_here(&r).crossings, 1);
    }
}

/* A control point farther than one and a half diagonals from the middle of the points: of several the farthest.  Distances of a fiftieth of the extent are coarse
 * where nothing tells noise. */
static void what_is_far_or_coarse(void **state)
{
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int k = 0; k < 6; k++) {
            double P[3 * 6] = {0};
            static const double out[6] = {0, 14.9, 15.1, 15.1, 15.1, 15.1};
            for (int j = 0; j < 6; j++)
                P[j * dim] = 1000 + 2 * j;
            P[4 * dim] = 1000 + 5, P[4 * dim + dim - 1] += out[k]; /* from (1005, 0) */
            if (k == 3 || k == 4)
                P[(k == 3 ? 1 : 5) * dim] = 1005 + (k == 3 ? 16 : 14.5);
            cagd_fit_result r = told(dim, 6, P, 11);
            cagd_fit_options o = cagd_fit_defaults();
            o.unordered = 1;
            for (int i = 0; i < 11 * dim; i++)
                points_told[i] = i % dim == 0 ? 1000 + i / dim : 0;
            for (int i = 0; i < 11; i++)
                feet_told[i] = i / 3.0;
            const cagd_fit_data d = {11, dim, points_told, NULL};
            r.found.ellipse.known = k == 5;
            for (int j = 0; j < 6; j++)
                polygon_points[j * dim] -= k == 2 ? 1000 : 0;
            r.origin[0] = k == 2 ? 1000 : 0;
            const cagd_fit_quality q = quality_told(&d, &o, &r);
            assert_int_equal(q.far, k < 2 || k == 5 ? -1 : k == 3 ? 1 : 4);
            assert_int_equal((q.problems & CAGD_FIT_FAR) != 0, q.far >= 0);
        }
    for (int n = 30; n <= 31; n++) /* 29 pairs, or 30 */
        for (int k = 0; k < 8; k++) {
            const int large = k & 1, given = k & 2, smooth = k & 4;
            cagd_fit_result r = told(2, 11, straight_line, n);
            for (int i = 0; i < r.count; i++)
                feet_told[i] = 10.0 * i / (r.count - 1), distances_told[i] = i % 2 ? 0.1 : -0.1, sigma_told[i] = 0.1;
            r.rms = 0.02 * hypot(10, 0.2) * (large ? 1 + 1e-9 : 1 - 1e-9), r.roughness = smooth ? 1 : 0;
            cagd_fit_data d = points_of(&r);
            d.sigma = given ? sigma_told : NULL;
            const cagd_fit_options o = cagd_fit_defaults();
            assert_int_equal((quality_told(&d, &o, &r).problems & CAGD_FIT_COARSE) != 0,
                             large && !given && (smooth || n == 30));
        }
}

/* Distances of 0.1, and some of 3: alone, two or three together, four, many; the first three are named. */
static void points_that_are_far_off(void **state)
{
    (void)state;
    static const struct {
        int far[8], count, strays, named[3];
    } of[] = {{{0}, 1, 1, {0}},
              {{59}, 1, 1, {59}},
              {{30}, 1, 1, {30}},
              {{30, 31}, 2, 2, {30, 31}},
              {{30, 31, 32}, 3, 3, {30, 31, 32}},
              {{30, 31, 32, 33}, 4, 0, {0}},
              {{0, 1}, 2, 0, {0}}, /* before the first one nothing is quiet */
              {{58, 59}, 2, 0, {0}},
              {{10, 11, 30, 59}, 4, 4, {10, 11, 30}},
              {{5, 15, 25, 35, 45, 55}, 6, 6, {5, 15, 25}},
              {{5, 15, 25, 35, 45, 55, 58}, 7, 0, {0}}, /* more than a tenth */
              {{10, 20, 21, 22, 23}, 5, 0, {0}},
              {{10, 40, 50, 21, 22, 23}, 6, 6, {10, 21, 22}}};
    for (size_t k = 0; k < sizeof of / sizeof *of; k++)
        for (int given = 0; given < 2; given++) {
            cagd_fit_result r = told(2, 11, straight_line, 60);
            cagd_fit_options o = cagd_fit_defaults();
            for (int i = 0; i < 60; i++) {
                sigma_told[i] = given ? 0.5 + i % 2 : 1;
                feet_told[i] = i / 6.0, distances_told[i] = (i % 2 ? 0.1 : -0.1) * sigma_told[i];
            }
            for (int m = 0; m < of[k].count; m++)
                distances_told[of[k].far[m]] *= 30;
            cagd_fit_data d = points_of(&r);
            d.sigma = given ? sigma_told : NULL;
            cagd_fit_quality q = quality_told(&d, &o, &r);
            assert_int_equal(q.strays, of[k].strays);
            for (int m = 0; m < 3 && m < of[k].strays; m++)
                assert_int_equal(q.stray[m], of[k].named[m]);
            r.points_on_curve = 1;
            assert_int_equal(quality_told(&d, &o, &r).strays, 0);
            r.points_on_curve = 0, r.degrees_of_freedom = 29;
            assert_int_equal(quality_told(&d, &o, &r).strays, 0);
            r.degrees_of_freedom = 30, o.loss = CAGD_FIT_HUBER, r.deviation = 0.1;
            assert_int_equal(quality_told(&d, &o, &r).strays, 0);
        }
    /* Beside a jump the neighbours are within two deviations; ten are not more than ten. */
    for (int side = 0; side < 2; side++)
        for (int k = 0; k < 4; k++) {
            cagd_fit_result r = told(2, 11, straight_line, 60);
            for (int i = 0; i < 60; i++)
                feet_told[i] = i / 6.0, distances_told[i] = i % 2 ? 0.1 : -0.1;
            const double deviation = 0.1 / 0.67448975019608174;
            r.effective = 0, r.degrees_of_freedom = 1000000; /* no unknowns */
            const int first = side ? 30 : 29;
            distances_told[29] = 3,
            distances_told[30] = side ? 3 : 6 * deviation; /* one that is half as far belongs to the jump */
            distances_told[28] = k == 0 ? 1.99 * deviation : k == 1 ? 2.01 * deviation : 0.1;
            distances_told[31] = k == 2 ? 1.99 * deviation : k == 3 ? 2.01 * deviation : 0.1;
            const cagd_fit_quality q = quality_here(&r);
            assert_int_equal(q.strays, side ? (k % 2 ? 0 : 2) : 1); /* a single one is a jump whatever is beside it */
            assert_true(!q.strays || q.stray[0] == first - side);
            distances_told[29] = distances_told[30] = 0.1,
            distances_told[10] = 10 * deviation * (k % 2 ? 1 + 1e-9 : 1 - 1e-9);
            assert_int_equal(quality_here(&r).strays, k % 2);
        }
}

/* Chi-squared on d degrees of freedom whose cube root, by Wilson and Hilferty, is off by a little less or more than what happens once in a thousand times. */
static void deviations_that_are_given_wrongly(void **state)
{
    (void)state;
    const double once = 3.0902323061678132; /* of a normal number on one side */
    for (int d = 3; d <= 60; d += 19)
        for (int sign = -1; sign <= 1; sign += 2)
            for (int beyond = 0; beyond < 2; beyond++) {
                cagd_fit_result r = told(2, 11, straight_line, 60);
                cagd_fit_options o = cagd_fit_defaults();
                for (int i = 0; i < 60; i++)
                    feet_told[i] = i / 6.0, distances_told[i] = i % 2 ? 0.1 : -0.1, sigma_told[i] = 0.1;
                const double part = 2 / (9.0 * d), z = sign * once * (beyond ? 1.0001 : 0.9999);
                r.degrees_of_freedom = d, r.chi_squared = d * pow(1 - part + z * sqrt(part), 3);
                cagd_fit_data data = points_of(&r);
                data.sigma = sigma_told;
                cagd_fit_quality q = quality_told(&data, &o, &r);
                assert_int_equal((q.problems & CAGD_FIT_DEVIATIONS) != 0, sign > 0 && beyond);
                assert_int_equal(q.too_large, sign < 0 && beyond);
                data.sigma = NULL;
                q = quality_told(&data, &o, &r);
                assert_true(!(q.problems & CAGD_FIT_DEVIATIONS) && !q.too_large);
                data.sigma = sigma_told, o.loss = CAGD_FIT_HUBER, r.deviation = 1;
                q = quality_told(&data, &o, &r);
                assert_true(!(q.problems & CAGD_FIT_DEVIATIONS) && !q.too_large);
            }
}

/* Sides, parts, the next one and the k-th further on: each alone is structure, unless the points are on the curve; waves of many unknowns are none. */
static void structure_of_every_kind(void **state)
{
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        cagd_fit_result r = told(2, 11, straight_line, 100);
        const cagd_fit_options o = cagd_fit_defaults();
        for (int i = 0; i < 100; i++) {
            feet_told[i] = i / 10.0;
            distances_told[i] =
                kind == 0   ? (i % 12 < 6 ? 1 : -1) * (0.1 + 0.07 * (i * 7 % 10)) /* runs of six */
                : kind == 1 ? (i >= 40 && i < 48 ? 1.2 : (i * i * 31 % 101 < 50 ? 0.4 : -0.5) + 0.03 * (i % 7))
                : kind == 2 ? sin(2 * acos(-1) * i / 3 + 0.5) /* a wave of three */
                            : (i % 2 ? 0.5 : -0.5); /* alternating: the other side always, the same two further on */
            r.rms = 0.6;
        }
        cagd_fit_data d = points_of(&r);
        r.largest = 2;
        cagd_fit_quality q = quality_told(&d, &o, &r);
        if (kind == 0)
            assert_true(q.runs.probability < 0.01);
        if (kind == 2 || kind == 3)
            assert_true(!(q.runs.probability < 0.01) && !(q.runs.next_probability < 0.01) &&
                        q.runs.lag_probability < 0.001 && q.runs.lag == (kind == 2 ? 3 : 2));
        assert_int_equal((q.problems & CAGD_FIT_STRUCTURE) != 0,
                         q.runs.probability < 0.01 || q.runs.local_probability < 0.01 || kind >= 2);
        if (kind >= 2) {
            r.effective = 25;
            assert_true(quality_told(&d, &o, &r).problems & CAGD_FIT_STRUCTURE);
            r.effective = 25.1;
            const cagd_fit_quality many = quality_told(&d, &o, &r);
            assert_true(many.runs.local_probability < 0.01 || !(many.problems & CAGD_FIT_STRUCTURE));
        }
        r.effective = 2, r.points_on_curve = 1;
        assert_true(!(quality_told(&d, &o, &r).problems & CAGD_FIT_STRUCTURE));
    }
}

/* n chi-squared and unknowns of Schwarz's criterion with the correction for few points, and where there are too few for it. */
static void scores_of_candidates(void **state)
{
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int given = 0; given < 2; given++)
            for (int ends = 0; ends < 4; ends++) {
                cagd_fit_result r = told(2, 2, along_x_of_plane, 20);
                cagd_fit_data d = {20, dim, points_told, given ? sigma_told : NULL};
                r.effective = 6.5, r.chi_squared = 3.25;
                r.end_points[0] = ends & 1 ? 0 : -1, r.end_points[1] = ends & 2 ? 19 : -1;
                const double n = 20 * (dim - 1), unknowns = 6.5 - (ends & 1) - (ends >> 1), k = unknowns + !given;
                assert_true(fit_equations_of(&d) == n && fit_unknowns_of(&r) == unknowns);
                const double more = k * log(n) * n / (n - k - 2);
                assert_true(fabs(fit_score(&d, &r) - (given ? 3.25 : n * log(3.25 / n)) - more) < 1e-12 * more);
                r.effective = n - 2 - !given + (ends & 1) + (ends >> 1);
                assert_true(isinf(fit_score(&d, &r)));
                r.effective -= 0.5;
                assert_true(isfinite(fit_score(&d, &r)));
            }
    /* Whether one counts: a minimum, a sum of squares that is a number, no excursion. */
    static const double spike[] = {0, 0, 4, 0, 4.5, 2, 5, 0, 10, 0};
    for (int unordered = 0; unordered < 2; unordered++) {
        cagd_fit_result r = told(2, 5, spike, 20);
        cagd_fit_options o = cagd_fit_defaults();
        int problems, beneath;
        o.unordered = unordered;
        for (int i = 0; i < 20; i++) {
            const int k = unordered ? i * 7 % 20 : i;
            feet_told[i] = k < 10 ? k / 10.0 : 3 + (k - 9) / 10.0;
        }
        const cagd_fit_data d = points_of(&r);
        r.chi_squared = 1;
        assert_int_equal(fit_is_good(&d, &o, &r), 0); /* 10 + 2 (2.06 - 0.5) over 10 */
        assert_int_equal(fit_problems_of(&d, &o, &r, &problems, &beneath), CAGD_OK);
        assert_true(problems == ~0 && beneath == 0);
        polygon_points[5] = 0.5;
        assert_int_equal(fit_is_good(&d, &o, &r), 1);
        r.termination = CAGD_FIT_NOT_CONVERGED;
        assert_int_equal(fit_is_good(&d, &o, &r), 0);
        r.termination = CAGD_FIT_CONVERGED, r.chi_squared = INFINITY;
        assert_int_equal(fit_is_good(&d, &o, &r), 0);
        r.chi_squared = 1, r.refuted = 1;
        assert_int_equal(fit_is_good(&d, &o, &r), 0);
    }
}

/* Room for a curve: half of the equations, of a dense one all; a closed curve has fewer points, more knots at least. */
static void room_for_knots(void **state)
{
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int closed = 0; closed < 2; closed++)
            for (int dense = 0; dense < 2; dense++)
                for (int n = 10; n <= 40; n += 3) {
                    cagd_fit_data d = {n, dim, points_told, NULL};
                    cagd_fit_options o = cagd_fit_defaults();
                    o.degree = 3, o.closed = closed;
                    const fit_search s = {.data = &d, .options = &o, .dense = dense};
                    assert_int_equal(fit_search_fewest_knots(&s), closed ? 3 : 0);
                    for (int inner = 0; inner <= FIT_MOST_KNOTS; inner++) {
                        const fit_knots k = {.inner = inner};
                        const int unknowns = (closed ? inner + 1 : inner + 4) * dim,
                                  equations = n * (dim - 1) + 2 * dim;
                        assert_int_equal(fit_search_has_room(&s, &k),
                                         inner < FIT_MOST_KNOTS && (dense ? unknowns : 2 * unknowns) <= equations);
                    }
                }
    double deviation[] = {0.5, 2, 1};
    assert_true(fit_precision_of(&(cagd_fit_data){3, 2, points_told, deviation}) == 4 + 0.25 + 1);
    assert_true(fit_precision_of(&(cagd_fit_data){3, 2, points_told, NULL}) == 3);
}

/* With a tolerance: as many knots as there are where the distance is kept, and else the distance; what is best takes knots and score. */
static void scores_with_a_tolerance(void **state)
{
    (void)state;
    cagd_fit_result r = told(2, 11, straight_line, 20), better = r;
    cagd_fit_options o = cagd_fit_defaults();
    const cagd_fit_choices choices = {.within = 0.5};
    int without_memory = 0;
    for (int i = 0; i < 20; i++)
        feet_told[i] = i / 2.0;
    const cagd_fit_data d = points_of(&r);
    fit_search s = {.data = &d, .options = &o, .choices = &choices, .without_memory = &without_memory, .within = 0.5};
    const fit_knots k = {.inner = 7};
    r.largest = 0.5;
    assert_true(fit_search_is_within(&s, &r) && fit_search_score(&s, &k, &r) == 7 - 1e6);
    r.largest = nextafter(0.5, 1);
    assert_true(!fit_search_is_within(&s, &r) && fit_search_score(&s, &k, &r) == r.largest);
    assert_true(fit_search_is_best(&s, &k, &r) && s.best == NULL && s.score == r.largest && s.at.inner == 7);
    s.best = &r;
    const fit_knots more = {.inner = 8};
    assert_true(!fit_search_is_best(&s, &more, &r) && s.at.inner == 7); /* as good is not better */
    better.largest = 0.1;
    assert_true(fit_search_is_best(&s, &more, &better) && s.at.inner == 8 && s.score == 8 - 1e6);
    better.termination = CAGD_FIT_NOT_CONVERGED;
    assert_true(fit_search_score(&s, &more, &better) == HUGE_VAL);
    s.within = 0;
    assert_true(!fit_search_is_within(&s, &r));
}

/* The median of an odd and of an even number of distances, in the plane and in space, with deviations; and what is farther than once in twenty times by chance. */
static void outliers_by_the_median(void **state)
{
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int n = 9; n <= 10; n++)
            for (int given = 0; given < 2; given++) {
                cagd_fit_result r = told(dim, 2, dim == 2 ? along_x_of_plane : along_x, n);
                cagd_fit_options o = cagd_fit_defaults();
                double sum = 0;
                for (int i = 0; i < n; i++) {
                    const int k = i * 7 % n;
                    sigma_told[i] = given ? 0.25 + i % 2 : 1;
                    distances_told[i] = (i % 2 ? -1 : 1) * (k == n - 1 ? 500.0 : k + 1) * sigma_told[i];
                    sum += k == n - 1 ? 0 : distances_told[i] * distances_told[i];
                }
                const cagd_fit_data d = {n, dim, points_told, given ? sigma_told : NULL};
                r.rank = 3, r.effective = 3, r.degrees_of_freedom = 6, r.rms = 77;
                const double median = n == 9 ? 5 : 5.5, of_normal = dim == 2 ? 0.67448975019608174 : sqrt(2 * log(2));
                const double wanted = median / of_normal * sqrt(1 + 3 / 6.0);
                assert_true(fabs(fit_robust_deviation(&d, &r) / wanted - 1) < 1e-14);
                assert_int_equal(fit_outliers(&d, &o, &r), 1);
                assert_true(r.rms_of_others == 77 && r.outliers == 0 && r.deviation == 0);
                o.loss = CAGD_FIT_CAUCHY;
                assert_int_equal(fit_outliers(&d, &o, &r), 1);
                assert_true(fabs(r.deviation / wanted - 1) < 1e-14);
                const double z = r.outlier_limit;
                assert_true(fabs(n * (dim == 2 ? erfc(z / sqrt(2)) : exp(-z * z / 2)) - 0.05) < 1e-12);
                assert_int_equal(r.outliers, 1);
                for (int i = 0; i < n; i++)
                    assert_int_equal(outlier_told[i], fabs(distances_told[i]) > 100);
                assert_true(fabs(r.rms_of_others - sqrt(sum / (n - 1))) < 1e-12);
                for (int i = 0; i < n; i++) /* on the limit none is one */
                    if (outlier_told[i])
                        distances_told[i] = z * r.deviation * sigma_told[i] * (1 - 1e-12);
                r.outliers = 0;
                assert_int_equal(fit_outliers(&d, &o, &r), 1);
                assert_int_equal(r.outliers, 0);
                distances_told[0] = 1e9, r.points_on_curve = 1, r.outliers = 0;
                assert_int_equal(fit_outliers(&d, &o, &r), 1);
                assert_int_equal(r.outliers, 0);
                r.degrees_of_freedom = 0;
                assert_true(fit_robust_deviation(&d, &r) == 0);
            }
    assert_true(fit_loss_scale_of(CAGD_FIT_HUBER, 2) == 2.69 && fit_loss_scale_of(CAGD_FIT_CAUCHY, 2) == 4.77);
}

/* ---- smoothing, polygons, matrices ------------------------------------------------------------------------------ */

/* lambda integral |S''|^2 over u from 0 to 1, by differences of the spline and Simpson's rule, which is exact for the square of S'' up to degree 3 and near it with
 * many nodes beyond. */
static void the_smoothing_term_is_the_integral(void **state)
{
    (void)state;
    enum { SIMPSON = 400 };
    for (int p = 2; p <= 6; p++)
        for (int dim = 2; dim <= 3; dim++)
            for (int closed = 0; closed < 2; closed++) {
                const fit_knots k = {4, {0.2, 0.3, 0.55, 0.9}};
                double U[32], P[64];
                fit_knots_spell(&k, p, closed, U);
                const int own = fit_knots_count(&k, p, closed), count = own + (closed ? p : 0);
                if (closed && own <= p)
                    continue;
                for (int i = 0; i <= count + p; i++)
                    U[i] = 3 + 5 * U[i]; /* the domain is [3, 8] */
                fit_curve *c = fit_curve_new(p, count, closed ? own : 0, dim, U);
                assert_non_null(c);
                for (int i = 0; i < own * dim; i++)
                    c->points[i] = P[i] = sin(1.0 + 3 * i + i * i);
                fit_curve_update(c);
                const fit_problem problem = {.degree = p, .count = count, .dim = dim, .smooth = 0.7};
                double sum = 0, D[9], rows = 0;
                for (int piece = 0; piece < c->pieces; piece++) {
                    const double a = U[c->span[piece]], b = U[c->span[piece] + 1];
                    for (int i = 0; i <= SIMPSON; i++) {
                        const double t = a + (b - a) * i / SIMPSON, inside = fmin(t, b - (b - a) * 1e-12);
                        double square = 0;
                        assert_int_equal(cagd_spline_derivatives(&c->spline, inside, CAGD_RIGHT, 2, D), CAGD_OK);
                        for (int x = 0; x < dim; x++)
                            square += D[2 * dim + x] * D[2 * dim + x] * 625; /* by u */
                        sum += square * (b - a) / 5 * (i == 0 || i == SIMPSON ? 1 : i % 2 ? 4 : 2) / (3.0 * SIMPSON);
                    }
                    for (int g = 0; g < fit_smoothing_nodes(&problem); g++) {
                        double row[CAGD_MAX_DEGREE + 1];
                        fit_smoothing_row(&problem, c, piece, g, row);
                        for (int x = 0; x < dim; x++)
                            rows += pow(fit_smoothing_residual(&problem, c, piece, row, x), 2);
                    }
                }
                assert_int_equal(fit_smoothing_nodes(&problem), p - 1);
                assert_true(fabs(fit_smoothing_square(&problem, c) / (0.7 * sum) - 1) < 1e-8);
                assert_true(fabs(rows / (0.7 * sum) - 1) < 1e-8);
                const fit_problem none = {.degree = p, .count = count, .dim = dim};
                assert_true(fit_smoothing_nodes(&none) == 0 && fit_smoothing_square(&none, c) == 0);
                fit_curve_free(c);
            }
}

/* For matrices N and K of 3 by 3: H = N + K, the trace of H^-1 N, and H X H = N for the sandwich X, H X = N without. */
static void the_sandwich_of_a_smoothed_curve(void **state)
{
    (void)state;
    static const double N0[9] = {4, 1, 0.5, 1, 3, -0.25, 0.5, -0.25, 2},
                        K[9] = {1, -0.5, 0.125, -0.5, 2, 0.75, 0.125, 0.75, 5};
    for (int sandwich = 0; sandwich < 2; sandwich++) {
        double X[9], H[9], sum[9], trace = 0, solved[9];
        memcpy(X, N0, sizeof X);
        const double told_trace = fit_smoothing_sandwich(3, X, K, H, sandwich);
        for (int i = 0; i < 9; i++)
            sum[i] = N0[i] + K[i];
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                double once = 0;
                for (int k = 0; k < 3; k++)
                    once += sum[i * 3 + k] * X[k * 3 + j];
                solved[i * 3 + j] = once;
            }
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                double twice = 0;
                for (int k = 0; k < 3; k++)
                    twice += solved[i * 3 + k] * sum[k * 3 + j];
                assert_true(fabs((sandwich ? twice : solved[i * 3 + j]) - N0[i * 3 + j]) < 1e-13);
                trace += i == j ? X[i * 3 + j] : 0;
            }
        static double first_trace;
        if (!sandwich)
            first_trace = trace;
        assert_true(fabs(told_trace - first_trace) < 1e-14);
    }
    double X[4] = {1, 2, 2, 1}, H[4];
    static const double none[4] = {0};
    assert_true(isnan(fit_smoothing_sandwich(2, X, none, H, 1)));
    double Y[4] = {1, 0, 0, 0};
    assert_true(isnan(fit_smoothing_sandwich(2, Y, none, H, 1)));
}

/* The polygon of a curve: distances from its sides against distances from their points, how deep the curve is, and where it begins. */
static void polygons_of_curves(void **state)
{
    (void)state;
    for (int dim = 2; dim <= 3; dim++) {
        fit_curve *c = fit_curve_new(3, 6, 0, dim, spline_knots);
        assert_non_null(c);
        for (int j = 0; j < 6; j++) {
            for (int x = 0; x < dim; x++)
                c->points[j * dim + x] = spline_points[3 * j + x];
            c->weights[j] = spline_weights[j];
        }
        fit_curve_update(c);
        fit_polygon g;
        assert_true(fit_polygon_new(c, 32, &g));
        assert_true(g.dim == dim && g.sides >= 32 && g.t[0] == 0 && g.t[g.sides] == 1);
        double whole = 0, D[9], q[3] = {1.3, 0.4, -0.2}, square[2048];
        for (int k = 0; k < g.sides; k++) {
            const double *a = g.point + k * dim, *b = a + dim, length = sqrt(fit_distance_squared(dim, a, b));
            whole += length;
            assert_true(g.t[k] < g.t[k + 1] && fabs(g.inverse[k] * length * length - 1) < 1e-12);
            fit_curve_point(c, g.t[k], D);
            for (int x = 0; x < dim; x++) {
                assert_true(D[x] == a[x] && g.begin[x][k] == a[x] && g.vector[x][k] == b[x] - a[x]);
            }
            fit_curve_point(c, g.t[k] + (g.t[k + 1] - g.t[k]) / 2, D);
            const double way = sqrt(fit_distance_squared(dim, a, D)) + sqrt(fit_distance_squared(dim, D, b));
            assert_true(fabs(g.depth[k] - sqrt(fmax(0, way * way - length * length))) < 1e-12);
            for (int i = 1; i < 8; i++) { /* over the side the curve is no farther from it than that */
                fit_curve_point(c, g.t[k] + (g.t[k + 1] - g.t[k]) * i / 8, D);
                fit_polygon_distances(&g, D, k, k, square);
                assert_true(sqrt(square[k]) <= g.depth[k] + 1e-15);
            }
        }
        for (int k = 0; k < g.sides; k++)
            assert_true(sqrt(1 / g.inverse[k]) <= whole / 32 * 1.05);
        for (int many = 0; many < 2; many++) /* of a few sides, and of all */
            for (int first = 0; first + 4 <= g.sides; first += 5) {
                const int last = many ? g.sides - 1 : first + 3;
                fit_polygon_distances(&g, q, first, last, square);
                for (int k = first; k <= last; k++) {
                    const double *a = g.point + k * dim;
                    double nearest = HUGE_VAL, place = 0, P[3];
                    for (int i = 0; i <= 1000; i++) {
                        for (int x = 0; x < dim; x++)
                            P[x] = a[x] + (a[dim + x] - a[x]) * i / 1000;
                        const double here = fit_distance_squared(dim, P, q);
                        if (here < nearest)
                            nearest = here, place = i / 1000.0;
                    }
                    assert_true(square[k] <= nearest + 1e-12 && square[k] > nearest - 1e-4);
                    const double t = fit_polygon_parameter(&g, k, q);
                    assert_true(fabs(t - g.t[k] - place * (g.t[k + 1] - g.t[k])) <= (g.t[k + 1] - g.t[k]) / 999);
                }
            }
        const int m = g.sides;
        for (int k = 0; k < m; k++) {
            const int low = k > 0 ? k - 1 : 0, high = k + 2 < m ? k + 2 : m;
            assert_true(fit_polygon_is_beside(&g, k, g.t[low]) && fit_polygon_is_beside(&g, k, g.t[high]));
            assert_true(!fit_polygon_is_beside(&g, k, nextafter(g.t[low], -1)) &&
                        !fit_polygon_is_beside(&g, k, nextafter(g.t[high], 2)));
        }
        double t[2048], depth[2048];
        memcpy(t, g.t, (size_t)(m + 1) * sizeof *t);
        memcpy(depth, g.depth, (size_t)m * sizeof *depth);
        const int first = m / 3;
        assert_true(fit_polygon_begin_at(&g, first) && g.sides == m);
        for (int k = 0; k <= m; k++)
            assert_true(fabs(g.t[k] - (first + k < m ? t[first + k] : t[first + k - m] + 1)) < 1e-15);
        for (int k = 0; k < m; k++) {
            assert_true(g.depth[k] == depth[(first + k) % m]);
            if (first + k != m) /* of this curve, which is open, corner 0 takes the place of the last one */
                for (int x = 0; x < dim; x++)
                    assert_true(g.begin[x][k] == g.point[k * dim + x]);
        }
        fit_polygon_free(&g);
        fit_curve_free(c);
    }
    for (int n = 1; n <= 40; n++)
        for (int at = 0; at < n; at++) {
            double x[40];
            for (int i = 0; i < n; i++)
                x[i] = i == at || (i > at && i % 3 == 0) ? -1 : i % 5; /* several of the smallest: the first one */
            assert_int_equal(fit_smallest_of(n, x), at);
        }
}

/* (A^T A)^-1 of a triangle and of a square matrix by rows of more numbers than columns; nothing where a column depends on the others. */
static void inverses_of_regular_matrices(void **state)
{
    (void)state;
    enum { M = 4, STRIDE = 6 };
    double A[M * STRIDE], N0[M][M], C[M * M];
    for (int variant = 0; variant < 4; variant++) {
        for (int i = 0; i < M; i++)
            for (int j = 0; j < STRIDE; j++)
                A[i * STRIDE + j] = j >= M ? 1e6
                                    : variant == 0 && i > j
                                        ? 0
                                        : (i == j ? 3 : 0) * (variant == 1 ? -1 : 1) + sin(7.0 * i + 3 * j);
        if (variant == 3)
            for (int i = 0; i < M; i++)
                A[i * STRIDE + 3] = A[i * STRIDE] - 2 * A[i * STRIDE + 1];
        for (int a = 0; a < M; a++)
            for (int b = 0; b < M; b++) {
                N0[a][b] = 0;
                for (int i = 0; i < M; i++)
                    N0[a][b] += A[i * STRIDE + a] * A[i * STRIDE + b];
            }
        assert_int_equal(fit_rank_regular(M, 100, 30, A, STRIDE, C), variant != 3);
        for (int a = 0; a < M && variant != 3; a++)
            for (int b = 0; b < M; b++) {
                double sum = 0;
                for (int k = 0; k < M; k++)
                    sum += N0[a][k] * C[k * M + b];
                assert_true(fabs(sum - (a == b)) < 1e-12 && C[a * M + b] == C[b * M + a]);
            }
    }
}

/* The sum of the products of pairs over pieces that have unknowns in common, of fewer and of many more than are added up at once. */
static void curvatures_are_sums_of_products(void **state)
{
    (void)state;
    enum { U = 5 };
    static int first[] = {0, 3, 7}, reach[] = {0, 1, 3, 1, 2, 3, 4};
    const fit_support support = {U, 2, first, reach};
    fit_curvature *c = fit_curvature_new(&support);
    assert_non_null(c);
    for (int pairs = 1; pairs <= 700; pairs += 127 + pairs) {
        double sum[U][U] = {{0}};
        fit_curvature_clear(c);
        for (int again = 0, i = 0; again < pairs; again++) {
            const int piece = again % 3 == 0, count = 1 + again % 5, n = first[piece + 1] - first[piece];
            int stride;
            double *x = fit_curvature_pairs(c, piece, count, &stride), *y = x + n * stride;
            for (int m = 0; m < count; m++)
                for (int j = 0; j < n; j++)
                    x[j * stride + m] = sin(3.0 * ++i), y[j * stride + m] = 0;
            for (int m = 0; m < count; m++) /* the sum is symmetric: y = x, half of the time with the other sign */
                for (int j = 0; j < n; j++) {
                    y[j * stride + m] = (m % 2 ? -1 : 1) * x[j * stride + m];
                    for (int k = 0; k < n; k++)
                        sum[reach[first[piece] + j]][reach[first[piece] + k]] +=
                            (m % 2 ? -1 : 1) * x[j * stride + m] * x[k * stride + m];
                }
        }
        const double *matrix = fit_curvature_matrix(c);
        for (int a = 0; a < U; a++)
            for (int b = 0; b < U; b++)
                assert_true(fabs(matrix[a * U + b] - sum[a][b]) < 1e-11);
    }
    fit_curvature_free(c);
}

/* Samples of a problem whose ends are measured: the points of the ends stay, as far as they are among every stride-th one; in space as in the plane. */
static void samples_keep_the_points_of_the_ends(void **state)
{
    static const double knots[] = {0, 0, 0, 0, 0.4, 0.7, 1, 1, 1, 1};
    (void)state;
    for (int dim = 2; dim <= 3; dim++) {
        cagd_fit_data data = around(dim, 0);
        double P[18];
        for (int j = 0; j < 6; j++)
            for (int x = 0; x < dim; x++)
                P[j * dim + x] = spline_points[3 * j + x];
        const cagd_spline initial = {3, 6, dim, knots, P, spline_weights};
        cagd_fit_options o = cagd_fit_defaults();
        fit_problem p, s;
        int where;
        o.initial = &initial;
        assert_int_equal(fit_problem_make(&data, &o, &fit_usual_strategy, &p, &where), CAGD_OK);
        fit_curve *c = fit_curve_new(3, 6, 0, dim, knots);
        assert_non_null(c);
        fit_problem_curve(&p, &initial, c);
        assert_int_equal(fit_problem_equations(&p), N * (dim - 1) + 2);
        assert_true(p.end_point[0] == 0 && p.end_point[1] == N - 1);
        p.smooth = 8;
        for (int stride = 1; stride <= 9; stride++)
            for (int other = 0; other < 2; other++) {
                p.end_point[0] = other ? 12 : 0, p.end_point[1] = other ? -1 : N - 1;
                assert_true(fit_sample_every(&p, stride, &s));
                const int count = (N - 1) / stride + 1 + ((N - 1) % stride != 0);
                assert_int_equal(s.points, count);
                assert_true(fabs(s.smooth - 8.0 * count / N) < 1e-14);
                for (int k = 0; k < count; k++) {
                    const int i = k < count - 1 ? k * stride : N - 1;
                    assert_memory_equal(fit_point(&s, k), fit_point(&p, i), (size_t)dim * sizeof(double));
                    assert_true(s.precision[k] == p.precision[i]);
                }
                assert_int_equal(s.end_point[0], !other ? 0 : 12 % stride == 0 ? 12 / stride : -1);
                assert_int_equal(s.end_point[1], other ? -1 : count - 1);
                fit_sample_free(&s);
            }
        double t[N], feet[16], D[9];
        for (int i = 0; i < N; i++)
            t[i] = i < 3 ? -1e-9 : i > N - 4 ? 1 : 0.02 + 0.45 * i / N + (i > 20 ? 0.4 : 0);
        p.end_point[0] = 5, p.end_point[1] = 31;
        assert_true(fit_sample_means(&p, c, t, 8, &s, feet));
        int groups = 0;
        for (int g = 0; g < 8; g++) {
            double weight = 0, foot = 0, off[3] = {0};
            for (int i = 0; i < N; i++) {
                const int own = t[i] < 0 ? 0 : t[i] >= 1 ? 7 : (int)(t[i] * 8);
                if (own != g || i == 5 || i == 31)
                    continue;
                const double w = p.precision[i] * p.precision[i];
                weight += w, foot += w * t[i];
                fit_curve_point(c, t[i], D);
                for (int x = 0; x < dim; x++)
                    off[x] += w * (fit_point(&p, i)[x] - D[x]);
            }
            if (weight == 0)
                continue;
            assert_true(fabs(feet[groups] - foot / weight) < ROUNDINGS &&
                        fabs(s.precision[groups] / sqrt(weight) - 1) < ROUNDINGS);
            fit_curve_point(c, feet[groups], D);
            for (int x = 0; x < dim; x++)
                assert_true(fabs(fit_point(&s, groups)[x] - D[x] - off[x] / weight) < ROUNDINGS);
            groups++;
        }
        assert_true(groups > 4 && groups < 8 && s.points == groups + 2); /* some parts have none */
        for (int end = 0; end < 2; end++) {
            const int at = groups + end, i = end ? 31 : 5;
            assert_int_equal(s.end_point[end], at);
            assert_memory_equal(fit_point(&s, at), fit_point(&p, i), (size_t)dim * sizeof(double));
            assert_true(s.precision[at] == p.precision[i] && feet[at] == end);
        }
        fit_sample_free(&s);
        fit_curve_free(c);
        fit_problem_free(&p);
    }
}

/* Random weights: between 1/16 and 16 or the bounds, where they are free; others for another number and another seed, and the same again for the same. */
static void random_weights_are_within_their_bounds(void **state)
{
    (void)state;
    static const double bounds[4][2] = {{0, INFINITY}, {0.5, INFINITY}, {0, 2}, {0.25, 100}};
    for (int k = 0; k < 4; k++) {
        const double low = fmax(bounds[k][0], 1 / 16.0), high = fmin(bounds[k][1], 16);
        double least = HUGE_VAL, most = 0, seen[400], again[6] = {0};
        int count = 0;
        for (int number = -20; number < 20; number++)
            for (unsigned long seed = 1; seed <= 2; seed++) {
                cagd_fit_data data = around(3, 0);
                struct made m = make(&data, &in_space, 0);
                cagd_fit_options o = cagd_fit_defaults();
                o.seed = seed;
                m.p.options = &o, m.p.low = bounds[k][0], m.p.high = bounds[k][1];
                fit_random_weights(&m.p, number, m.curve);
                assert_true(m.curve->weights[0] == 1);
                for (int j = 1; j < 6; j++) {
                    const double w = m.curve->weights[j];
                    assert_true(w >= low * (1 - 1e-12) && w <= high * (1 + 1e-12));
                    least = fmin(least, w), most = fmax(most, w);
                    for (int i = 0; i < count; i++)
                        assert_true(seen[i] != w);
                    seen[count++] = w, again[j] = w;
                }
                fit_random_weights(&m.p, number, m.curve);
                for (int j = 1; j < 6; j++)
                    assert_true(again[j] == m.curve->weights[j]);
                release(&m);
            }
        assert_true(least < low * pow(high / low, 0.1) && most > low * pow(high / low, 0.9));
    }
}

/* ---- circles and ellipses ------------------------------------------------------------------------------------------- */

/* Points around a circle, whole turn or arc, with given deviations: errors and bias of centre and radius from sums over the points. */
static void errors_of_whole_circles(void **state)
{
    (void)state;
    enum { MANY = 36 };
    for (int dim = 2; dim <= 3; dim++)
        for (int given = 0; given < 2; given++) {
            double P[3 * MANY], s[MANY], phi[MANY], weight = 0;
            for (int i = 0; i < MANY; i++) {
                const double a = 2 * acos(-1) * i / MANY, x = 100 + 5 * cos(a), y = -40 + 5 * sin(a);
                P[i * dim] = x, P[i * dim + 1] = dim == 2 ? y : 0.6 * y;
                if (dim == 3)
                    P[i * dim + 2] = 0.8 * y;
                s[i] = given ? 0.5 : 1;
                weight += 1 / (s[i] * s[i]);
            }
            const cagd_fit_data d = {MANY, dim, P, given ? s : NULL};
            fit_ellipse e;
            assert_true(fit_ellipse_of(&d, 1, NULL, &e, phi));
            assert_true(e.converged && e.circle && e.dim == dim && e.unknowns == (dim == 2 ? 3 : 6) &&
                        e.chi_squared < 1e-20);
            const int n = 3 * dim;
            const double *a = e.x + dim, *b = a + dim;
            double g[9] = {0}, variance = 0, bias = 0, inner_product = 0, A = 0, B = 0;
            for (int c = 0; c < dim; c++)
                inner_product += a[c] * b[c], A += a[c] * a[c], B += b[c] * b[c];
            assert_true(fabs(A - 25) < 1e-9 && fabs(B - 25) < 1e-9 && fabs(inner_product) < 1e-9);
            assert_true(fabs(e.x[0] - 100) < 1e-9 && fabs(e.x[1] + (dim == 2 ? 40 : 24)) < 1e-9);
            for (int c = 0; c < dim; c++)
                g[dim + c] = a[c] / 5;
            for (int k = 0; k < n; k++) {
                bias += g[k] * e.bias[k];
                for (int l = 0; l < n; l++)
                    variance += g[k] * e.inverse[k * n + l] * g[l];
            }
            assert_true(fabs(variance * weight - 1) <
                        1e-9); /* of the radius 1/sum 1/s^2, of a coordinate of the centre in the plane twice that */
            assert_true(fabs(e.inverse[0] * weight - 2) < 1e-9);
            assert_true(fabs(bias - (given ? 0.25 : 1) / (2 * 5)) < 1e-9);
        }
}

/* The arc of an ellipse as a curve: on the ellipse, no segment longer than a quarter turn, a whole turn closed to the last bit. */
static void arcs_of_ellipses(void **state)
{
    (void)state;
    static const double turns[] = {10, 89, 90, 91, 180, 181, 269, 350, 360};
    static const int segments[] = {1, 1, 1, 2, 2, 3, 3, 4, 4};
    for (int dim = 2; dim <= 3; dim++)
        for (int k = 0; k < 9; k++) {
            fit_ellipse e = {.dim = dim};
            cagd_spline c;
            double *P, D[3], high = acos(-1) / 180 * turns[k];
            for (int x = 0; x < dim; x++)
                e.x[x] = 3 + x,
                e.x[dim + x] = x == 0   ? 5
                               : x == 1 ? 1
                                        : -2,
                e.x[2 * dim + x] = x == 0   ? -1
                                   : x == 1 ? 4
                                            : 0.5;
            assert_true(fit_ellipse_curve(&e, 0.7, 0.7 + high, &c, &P));
            assert_true(c.degree == 2 && c.dim == dim && c.count == 2 * segments[k] + 1);
            for (int i = 0; i <= 40; i++) {
                assert_int_equal(cagd_spline_point(&c, i / 40.0, i < 40 ? CAGD_RIGHT : CAGD_LEFT, D), CAGD_OK);
                /* in the plane of a and b: u a + v b, u^2 + v^2 = 1 */
                const double aa = 26 + (dim == 3 ? 4 : 0), bb = 17 + (dim == 3 ? 0.25 : 0),
                             ab = -5 + 4 - (dim == 3 ? 1 : 0);
                double da = 0, db = 0;
                for (int x = 0; x < dim; x++)
                    da += (D[x] - e.x[x]) * e.x[dim + x], db += (D[x] - e.x[x]) * e.x[2 * dim + x];
                const double u = (da * bb - db * ab) / (aa * bb - ab * ab),
                             v = (db * aa - da * ab) / (aa * bb - ab * ab);
                assert_true(fabs(u * u + v * v - 1) < 1e-12);
                if (i == 0 || i == 40 || i == 20) {
                    const double phi = 0.7 + high * i / 40;
                    assert_true(fabs(u - cos(phi)) < 1e-12 && fabs(v - sin(phi)) < 1e-12);
                }
            }
            if (turns[k] >= 360)
                for (int x = 0; x < dim; x++)
                    assert_true(c.points[x] == c.points[(c.count - 1) * dim + x]);
            free(P);
        }
}

/* Gauss's elimination: X becomes A^-1, n <= 5. */
static void invert(int n, double A[5][5], double X[5][5])
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            X[i][j] = i == j;
    for (int k = 0; k < n; k++) {
        const double pivot = A[k][k]; /* of a positive definite matrix */
        for (int j = 0; j < n; j++)
            A[k][j] /= pivot, X[k][j] /= pivot;
        for (int i = 0; i < n; i++) {
            const double share = A[i][k];
            for (int j = 0; j < n && i != k; j++)
                A[i][j] -= share * A[k][j], X[i][j] -= share * X[k][j];
        }
    }
}

/* The covariance of n numbers on which the distances depend by rows[], one over the deviations in them, and what distances that are all `off` make of them. */
static void least_squares(int n, int count, double rows[][5], const double off[], double V[5][5], double moved[5])
{
    double A[5][5] = {{0}}, right[5] = {0};
    for (int i = 0; i < count; i++)
        for (int a = 0; a < n; a++) {
            right[a] += rows[i][a] * off[i];
            for (int b = 0; b < n; b++)
                A[a][b] += rows[i][a] * rows[i][b];
        }
    invert(n, A, V);
    for (int a = 0; a < n; a++) {
        moved[a] = 0;
        for (int b = 0; b < n; b++)
            moved[a] += V[a][b] * right[b];
    }
}

/* As good as normal, of variance 1, the same for every i: the sum of twelve even numbers, by splitmix64. */
static double noise_told(int i)
{
    double sum = -6;
    for (int k = 0; k < 12; k++) {
        uint64_t z = ((uint64_t)i * 12 + (uint64_t)k + 1) * 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        sum += (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }
    return sum;
}

/* The form of Fieller's theorem for coordinate c of the centre at x, M its point in the middle of the arc. */
static double form_of(const double of[3], const double M[2], int c, double x)
{
    const double away[2] = {of[0] - M[0], of[1] - M[1]}, far = hypot(away[0], away[1]), R = of[2];
    return (x - M[c]) / R - (1 + (far - R) / R) * away[c] / far;
}

/* Errors, bias and intervals of an arc of a circle from the normal equations of centre and radius: a point that is off by s in all directions is by s^2/(2 R) farther
 * out. */
static void circles_have_their_errors(void **state)
{
    (void)state;
    enum { MANY = 40 };
    for (int variant = 0; variant < 4; variant++) {
        const int given = variant & 1;
        const double size = variant & 2 ? 0.02 : 0.002, turn = acos(-1) / 180;
        double P[2 * MANY], s[MANY], rows[MANY][5], off[MANY], V[5][5], moved[5];
        for (int i = 0; i < MANY; i++) {
            const double a = (200 + 70.0 * i / (MANY - 1)) * turn;
            s[i] = given ? size * (i % 3 ? 0.5 : 1) : 1;
            P[2 * i] = 3 + cos(a) + size * noise_told(2 * i) * (given ? s[i] / size : 1) / 1.5;
            P[2 * i + 1] = -1 + sin(a) + size * noise_told(2 * i + 1) * (given ? s[i] / size : 1) / 1.5;
        }
        const cagd_fit_data d = {MANY, 2, P, given ? s : NULL};
        const cagd_fit_options o = cagd_fit_defaults();
        cagd_fit_result *r;
        cagd_fit_circle c;
        assert_int_equal(cagd_fit(&d, &o, &r, NULL), CAGD_OK);
        assert_int_equal(cagd_fit_circle_of(&d, &o, r, &c), CAGD_OK);
        assert_true(c.known && c.freedom == MANY - 5);
        double sum = 0, squares = 0, slope[3] = {0}, mean[2] = {0}, low = 0, high = 0;
        const double R = c.radius.value, centre[2] = {c.centre[0].value, c.centre[1].value};
        for (int i = 0; i < MANY; i++) {
            const double x = P[2 * i] - centre[0], y = P[2 * i + 1] - centre[1], far = hypot(x, y);
            rows[i][0] = x / far / s[i], rows[i][1] = y / far / s[i], rows[i][2] = 1 / s[i];
            for (int k = 0; k < 3; k++)
                slope[k] += rows[i][k] * (far - R) / s[i];
            sum += pow((far - R) / s[i], 2), squares += pow(far - R, 2);
            mean[0] += x / MANY, mean[1] += y / MANY;
            off[i] = s[i] / (2 * R);
        }
        const double scale = given ? 1 : sum / (MANY - 3),
                     q = given ? fit_normal_quantile() : fit_student_quantile(MANY - 3);
        for (int k = 0; k < 3; k++)
            assert_true(fabs(slope[k]) < 1e-7 / size / (given ? size : 1)); /* the least sum */
        assert_true(fabs(c.rms / sqrt(squares / MANY) - 1) < 1e-9);
        const double ratio = (sum - r->chi_squared) / 2 / (r->chi_squared / (MANY - 5));
        assert_true(fabs(c.ratio - ratio) < 1e-6 * (1 + ratio));
        assert_true(fabs(c.probability - fit_f_probability(c.ratio, 2, MANY - 5)) < 1e-12 && c.probability > 0.05);
        least_squares(3, MANY, rows, off, V, moved);
        const cagd_fit_number of[3] = {c.centre[0], c.centre[1], c.radius};
        double best[3], M[2];
        for (int k = 0; k < 3; k++) {
            assert_true(fabs(of[k].error / sqrt(scale * V[k][k]) - 1) < 1e-6);
            best[k] = of[k].value - scale * moved[k];
        }
        const double length = hypot(mean[0], mean[1]), to_mean[2] = {mean[0] / length, mean[1] / length};
        for (int k = 0; k < 2; k++)
            M[k] = best[k] + best[2] * to_mean[k];
        const double s_k = sqrt(scale * V[2][2]) / (best[2] * best[2]);
        assert_true(fabs(c.radius.low * (1 / best[2] + q * s_k) - 1) < 1e-6 &&
                    fabs(c.radius.high * (1 / best[2] - q * s_k) - 1) < 1e-6);
        for (int k = 0; k < 2; k++)
            for (int end = 0; end < 2; end++) { /* where the form differs from 0 by q of its errors */
                const double x = end ? c.centre[k].high : c.centre[k].low, h = 1e-6;
                double g[3], variance = 0;
                for (int a = 0; a < 3; a++) {
                    double up[3], down[3];
                    memcpy(up, best, sizeof up), memcpy(down, best, sizeof down);
                    up[a] += h, down[a] -= h;
                    g[a] = (form_of(up, M, k, x) - form_of(down, M, k, x)) / (2 * h);
                }
                for (int a = 0; a < 3; a++)
                    for (int b = 0; b < 3; b++)
                        variance += scale * g[a] * V[a][b] * g[b];
                const double form = form_of(best, M, k, x);
                assert_true(fabs(fabs(form) / (q * sqrt(variance)) - 1) < 1e-4);
                assert_true((form < 0) == (x < best[k]) && c.centre[k].low < best[k] && best[k] < c.centre[k].high);
            }
        for (int i = 0; i < MANY; i++) { /* as the points are seen from the centre */
            const double x = P[2 * i] - best[0], y = P[2 * i + 1] - best[1],
                         a = atan2(to_mean[0] * y - to_mean[1] * x, to_mean[0] * x + to_mean[1] * y);
            low = fmin(low, a), high = fmax(high, a);
        }
        assert_true(fabs(c.sweep - (high - low) / turn) < 1e-6);
        /* Nothing is told of what is no free conic by squares. */
        cagd_fit_options other[5] = {o, o, o, o, o};
        other[0].free = CAGD_FIT_WEIGHTS | CAGD_FIT_INNER_POINTS, other[1].loss = CAGD_FIT_HUBER,
        other[2].loss = CAGD_FIT_CAUCHY, other[3].smooth = 1, other[4].monotone = 1;
        for (int k = 0; k < 5; k++) {
            assert_int_equal(cagd_fit_circle_of(&d, &other[k], r, &c), CAGD_OK);
            assert_true(!c.known && c.radius.value == 0 && c.freedom == 0);
        }
        for (int k = 0; k < r->unknowns; k++) {
            r->at_bound[k] = 1;
            assert_int_equal(cagd_fit_circle_of(&d, &o, r, &c), CAGD_OK);
            assert_true(!c.known);
            r->at_bound[k] = 0;
        }
        r->refuted = 1;
        assert_int_equal(cagd_fit_circle_of(&d, &o, r, &c), CAGD_OK);
        assert_true(!c.known);
        cagd_fit_free(r);
    }
}

/* The same of an ellipse, whole or an arc, whichever way the points go around: centre, axes and angle by the normal equations of these five numbers. */
static void ellipses_have_their_errors(void **state)
{
    (void)state;
    enum { MANY = 60 };
    for (int variant = 0; variant < 16; variant++) {
        const int given = variant & 1, whole = variant & 2, back = variant & 4, mixed = variant & 8;
        const double turn = acos(-1) / 180,
                     tilt = (variant % 3 == 0   ? 35
                             : variant % 3 == 1 ? 120
                                                : -70) *
                            turn,
                     size = 0.01;
        double P[2 * MANY], s[MANY], rows[MANY][5], off[MANY], V[5][5], moved[5];
        for (int k = 0; k < MANY; k++) {
            const int i = mixed ? k * 7 % MANY : k;
            const double a = (back ? -1 : 1) * (20 + (whole ? 360.0 / MANY : 4.5) * i) * turn, x = 3 * cos(a),
                         y = 2 * sin(a);
            s[k] = given ? size * (i % 3 ? 0.5 : 1) : 1;
            P[2 * k] = 7 + cos(tilt) * x - sin(tilt) * y + size * noise_told(2 * i) * (given ? s[k] / size : 1) / 1.5;
            P[2 * k + 1] =
                4 + sin(tilt) * x + cos(tilt) * y + size * noise_told(2 * i + 1) * (given ? s[k] / size : 1) / 1.5;
        }
        const cagd_fit_data d = {MANY, 2, P, given ? s : NULL};
        cagd_fit_options o = cagd_fit_defaults();
        cagd_fit_result *r;
        o.closed = whole, o.unordered = mixed;
        assert_int_equal(fit_ellipse_result(&d, &o, &r), CAGD_OK);
        assert_non_null(r);
        const cagd_fit_ellipse *e = &r->found.ellipse;
        assert_true(e->known && !e->whole == !whole && !e->circle && e->freedom == MANY - 5);
        assert_true(fabs(e->sweep - (whole ? 360 : 4.5 * (MANY - 1))) < 1);
        const double A = e->major.value, B = e->minor.value, theta = e->angle.value * turn;
        assert_true(fabs(A - 3) < 0.02 && fabs(B - 2) < 0.02 && e->angle.value > -90 && e->angle.value <= 90 &&
                    fabs(remainder(theta - tilt, acos(-1))) < 1 * turn);
        double sum = 0, slope[5] = {0};
        for (int i = 0; i < MANY; i++) { /* the foot in the axes of the ellipse by bisection of (E - q) E' */
            const double X = P[2 * i] - e->centre[0].value, Y = P[2 * i + 1] - e->centre[1].value,
                         x = cos(theta) * X + sin(theta) * Y, y = cos(theta) * Y - sin(theta) * X;
            double low = 0, high = acos(-1) / 2;
            for (int k = 0; k < 80; k++) {
                const double m = (low + high) / 2,
                             f = -A * sin(m) * (A * cos(m) - fabs(x)) + B * cos(m) * (B * sin(m) - fabs(y));
                *(f < 0 ? &low : &high) = m;
            }
            const double u = copysign(cos(low), x), v = copysign(sin(low), y), length = hypot(B * u, A * v),
                         nx = B * u / length, ny = A * v / length, away = nx * (x - A * u) + ny * (y - B * v);
            rows[i][0] = (cos(theta) * nx - sin(theta) * ny) / s[i],
            rows[i][1] = (sin(theta) * nx + cos(theta) * ny) / s[i];
            rows[i][2] = nx * u / s[i], rows[i][3] = ny * v / s[i], rows[i][4] = (ny * A * u - nx * B * v) / s[i];
            off[i] = s[i] / 2 * A * B / pow(A * A * v * v + B * B * u * u, 1.5);
            sum += away * away / (s[i] * s[i]);
            for (int k = 0; k < 5; k++)
                slope[k] += rows[i][k] * away / s[i];
            assert_true(fabs(fabs(r->distances[i]) - fabs(away)) < 1e-9);
        }
        for (int k = 0; k < 5; k++)
            assert_true(fabs(slope[k]) < 1e-5 * sqrt(sum) / (given ? size : 1));
        assert_true(fabs(r->chi_squared / sum - 1) < 1e-9 && r->degrees_of_freedom == MANY - 5 &&
                    fabs(r->cost / (sum / 2) - 1) < 1e-9);
        assert_true(r->effective == 5 && fabs(r->reduced_chi_squared / (sum / (MANY - 5)) - 1) < 1e-9);
        assert_true(fabs(r->aic - (given ? sum + 10 : MANY * log(sum / MANY) + 12)) < 1e-6);
        assert_true(fabs(r->bic - (given ? sum + 5 * log(MANY) : MANY * log(sum / MANY) + 6 * log(MANY))) < 1e-6);
        const double scale = given ? 1 : sum / (MANY - 5),
                     q = given ? fit_normal_quantile() : fit_student_quantile(MANY - 5);
        assert_true(r->scale_is_given == given && r->quantile == q && fabs(r->scale_squared / scale - 1) < 1e-9);
        least_squares(5, MANY, rows, off, V, moved);
        const cagd_fit_number of[5] = {e->centre[0], e->centre[1], e->major, e->minor, e->angle};
        for (int k = 0; k < 5; k++) {
            const double unit = k == 4 ? 1 / turn : 1, error = sqrt(scale * V[k][k]) * unit;
            assert_true(fabs(of[k].error / error - 1) < 1e-5);
            const double middle = of[k].value - scale * moved[k] * unit;
            assert_true(fabs(of[k].low - (middle - q * error)) < 1e-4 * error &&
                        fabs(of[k].high - (middle + q * error)) < 1e-4 * error);
        }
        for (int i = 1; i < MANY && !mixed; i++) /* the curve goes the way of its points */
            assert_true(r->feet[i] > r->feet[i - 1] || whole);
        cagd_fit_free(r);
    }
}

/* The axis of points is the longest one of the three, whichever coordinate it is along, and where the points are symmetric about all of them. */
static void the_longest_axis_of_three(void **state)
{
    (void)state;
    for (int longest = 0; longest < 3; longest++)
        for (int middle = 0; middle < 3; middle++) {
            if (middle == longest)
                continue;
            double points[3 * 6] = {0},
                              width = 2e-4 * sqrt(2); /* of a point with a middle coordinate of sqrt(2) 10^-4 */
            for (int i = 0; i < 6; i++) {
                const int c = i / 2 == 0 ? longest : i / 2 == 1 ? middle : 3 - longest - middle;
                points[3 * i + c] = (i % 2 ? -1 : 1) * (c == longest ? 1 : c == middle ? 1e-4 : 1e-5) * sqrt(2);
            }
            cagd_fit_result r = told(2, 2, along_x_of_plane, 6);
            for (int side = -1; side <= 1; side += 2) {
                r.largest = FIT_OF_WIDTH * width * (1 + side * 1e-6);
                assert_int_equal(fit_beneath(&(cagd_fit_data){6, 3, points, NULL}, &r),
                                 side < 0 ? CAGD_FIT_BENEATH_SIZE : CAGD_FIT_BENEATH_NOTHING);
            }
        }
}

/* Structure counts beside a curve without where it is beneath deviations or size, and not where it is beneath the digits that are written. */
static void structure_beneath_counts_beside(void **state)
{
    (void)state;
    for (int kind = 0; kind < 4; kind++) { /* nothing, digits, deviations, size */
        cagd_fit_result r = told(2, 11, straight_line, 100);
        const cagd_fit_options o = cagd_fit_defaults();
        int problems, beneath;
        const double size = kind == 1 ? 0.04 : kind == 3 ? 1e-5 : 0.01;
        for (int i = 0; i < 100; i++) {
            feet_told[i] = i / 10.0, sigma_told[i] = 0.05;
            distances_told[i] = size * (i % 20 < 10 ? 1 : -1) * (i % 3 ? 1 : 0.5);
        }
        cagd_fit_data d = points_of(&r);
        for (int i = 0; i < 100; i++) {
            points_told[2 * i + 1] = kind == 1 ? 0 : (i % 2 ? 1.2345 : -1.2345) / 3 + sqrt(i); /* digits, or none */
            points_told[2 * i] += kind == 1 ? 0 : sqrt(i) / 1000;
        }
        r.relative = polygon_points, r.rms = size, r.largest = size,
        r.chi_squared = kind == 2 ? 100 * pow(size / 0.05, 2) : 1;
        r.degrees_of_freedom = 98;
        d.sigma = kind == 2 ? sigma_told : NULL;
        cagd_fit_options any = o;
        any.unordered = 1; /* nothing is said of the order of these points */
        const cagd_fit_quality q = quality_told(&d, &any, &r);
        assert_true(q.runs.probability < 0.01);
        assert_int_equal(q.beneath, kind == 0   ? CAGD_FIT_BENEATH_NOTHING
                                    : kind == 1 ? CAGD_FIT_BENEATH_DIGITS
                                    : kind == 2 ? CAGD_FIT_BENEATH_DEVIATIONS
                                                : CAGD_FIT_BENEATH_SIZE);
        assert_int_equal((q.problems & CAGD_FIT_STRUCTURE) != 0, kind == 0);
        for (int i = 0; i < 100; i++) /* a polygon that the curve is no longer than */
            points_told[2 * i] = kind == 1 ? i / 10.0 : points_told[2 * i];
        assert_int_equal(fit_problems_of(&d, &any, &r, &problems, &beneath), CAGD_OK);
        assert_int_equal(beneath, kind >= 2);
        assert_int_equal((problems & CAGD_FIT_STRUCTURE) != 0, kind != 1);
    }
}

/* Six points are enough for a conic and one degree of freedom; points on a circle but for rounding are told as one, whatever their F is. */
static void exact_circles_and_six_points(void **state)
{
    (void)state;
    for (int k = 0; k < 24; k++) {
        const int n = k % 2 ? 6 : 30;
        const double R = 1 + 7.3 * k, from = 0.3 * k, turn = 0.9 + 0.05 * k;
        double P[60];
        for (int i = 0; i < n; i++) {
            const double a = from + turn * i / (n - 1);
            P[2 * i] = 3 * R + R * cos(a), P[2 * i + 1] = R * sin(a) - R;
        }
        const cagd_fit_data d = {n, 2, P, NULL};
        const cagd_fit_options o = cagd_fit_defaults();
        cagd_fit_result *r;
        cagd_fit_circle c;
        assert_int_equal(cagd_fit(&d, &o, &r, NULL), CAGD_OK);
        assert_int_equal(cagd_fit_circle_of(&d, &o, r, &c), CAGD_OK);
        assert_true(c.known && c.freedom == n - 5 && c.ratio >= 0 && c.probability >= 0 && c.probability <= 1);
        assert_true(fabs(c.radius.value / R - 1) < 1e-9 && fabs(c.sweep * acos(-1) / 180 - turn) < 1e-9);
        cagd_fit_free(r);
    }
}

/* What a run did is added behind what was done before: its steps with their numbers, its iterations, how it ended; and single steps, with the largest component of
 * the gradient, whatever its sign. */
static void an_attempt_counts_on(void **state)
{
    (void)state;
    cagd_fit_data data = around(3, 0);
    struct made m = make(&data, &in_space, 0);
    cagd_fit_options o = options_with_exact_ends();
    m.p.options = &o;
    fit_attempt a;
    assert_true(fit_attempt_new(&m.p, &a));
    assert_true(a.max_iterations == o.max_iterations && a.outcome.steps == 0);
    for (int run = 0; run < 3; run++) {
        fit_outcome more = {0};
        more.history = calloc(3, sizeof *more.history);
        assert_non_null(more.history);
        for (int i = 0; i < 2 + run % 2; i++)
            more.history[i] = (cagd_fit_step){i, i % 2, 10.0 * run + i, 2, 3, 4};
        more.steps = 2 + run % 2, more.iterations = 5,
        more.termination = run == 1 ? CAGD_FIT_NOT_CONVERGED : CAGD_FIT_CONVERGED;
        snprintf(more.message, sizeof more.message, "run %d", run);
        assert_true(fit_attempt_append(&a, &more));
        assert_null(more.history);
        assert_int_equal(a.outcome.termination, run == 1 ? CAGD_FIT_NOT_CONVERGED : CAGD_FIT_CONVERGED);
        assert_int_equal(a.outcome.iterations, 5 * (run + 1));
        assert_true(a.outcome.message[4] == '0' + run);
    }
    assert_int_equal(a.outcome.steps, 7);
    static const int number[] = {0, 1, 5, 6, 7, 10, 11};
    for (int i = 0; i < 7; i++)
        assert_int_equal(a.outcome.history[i].iteration, number[i]);
    assert_true(a.outcome.history[4].cost == 12 && a.outcome.history[6].cost == 21 &&
                a.outcome.history[3].accepted == 1);
    const int n = m.p.unknowns, rows = n + 1;
    for (int side = -1; side <= 1; side += 2)
        for (int accepted = 0; accepted < 2; accepted++) {
            for (int k = 0; k < rows * rows; k++)
                a.objective->triangle[k] = 0;
            for (int k = 0; k < n; k++) /* the last column but one has the largest product with the last one */
                a.objective->triangle[k * rows + k] = 1,
                                                 a.objective->triangle[k * rows + n] = k == n - 2 ? side * 7 : 0.5;
            a.objective->cost = 42;
            assert_true(fit_attempt_step(&a, accepted, 0.25));
            const cagd_fit_step *last = &a.outcome.history[a.outcome.steps - 1];
            assert_int_equal(last->accepted, accepted);
            assert_true(last->cost == 42 && last->step_norm == 0.25);
            assert_true(last->gradient_norm == 7);
            assert_true(isinf(last->trust_radius) && last->iteration == a.outcome.iterations);
        }
    assert_true(a.outcome.steps == 11 && a.outcome.iterations == 19);
    fit_attempt_free(&a);
    release(&m);
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
        cmocka_unit_test(options_at_their_bounds),
        cmocka_unit_test(data_at_their_ends),
        cmocka_unit_test(knots_are_spelt),
        cmocka_unit_test(a_spline_on_finer_knots_is_the_same),
        cmocka_unit_test(points_come_back),
        cmocka_unit_test(a_corner_where_points_come_back),
        cmocka_unit_test(points_around_a_centre),
        cmocka_unit_test(sides_are_counted),
        cmocka_unit_test(waves_and_windows_are_those_of_the_definition),
        cmocka_unit_test(windows_need_sixteen_points),
        cmocka_unit_test(the_bend_of_the_curve_is_taken_off),
        cmocka_unit_test(lengths_are_those_of_the_polygons),
        cmocka_unit_test(what_distances_are_beneath),
        cmocka_unit_test(detours_of_an_octagon),
        cmocka_unit_test(gaps_between_feet),
        cmocka_unit_test(feet_that_fall_back),
        cmocka_unit_test(crossings_of_curve_and_points),
        cmocka_unit_test(what_is_far_or_coarse),
        cmocka_unit_test(points_that_are_far_off),
        cmocka_unit_test(deviations_that_are_given_wrongly),
        cmocka_unit_test(structure_of_every_kind),
        cmocka_unit_test(scores_of_candidates),
        cmocka_unit_test(room_for_knots),
        cmocka_unit_test(scores_with_a_tolerance),
        cmocka_unit_test(outliers_by_the_median),
        cmocka_unit_test(the_smoothing_term_is_the_integral),
        cmocka_unit_test(the_sandwich_of_a_smoothed_curve),
        cmocka_unit_test(polygons_of_curves),
        cmocka_unit_test(inverses_of_regular_matrices),
        cmocka_unit_test(curvatures_are_sums_of_products),
        cmocka_unit_test(samples_keep_the_points_of_the_ends),
        cmocka_unit_test(random_weights_are_within_their_bounds),
        cmocka_unit_test(errors_of_whole_circles),
        cmocka_unit_test(arcs_of_ellipses),
        cmocka_unit_test(circles_have_their_errors),
        cmocka_unit_test(ellipses_have_their_errors),
        cmocka_unit_test(the_longest_axis_of_three),
        cmocka_unit_test(structure_beneath_counts_beside),
        cmocka_unit_test(exact_circles_and_six_points),
        cmocka_unit_test(an_attempt_counts_on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
