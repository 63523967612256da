/* test_stationary.c -- the check in intervals: problems whose answer is known exactly, and what must be refused. */
#include "unit_exact.h"

#include "exact/fit/stationary.h"
#include "exact/number/region.h"
#include "exact/words.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { MOST = 20000 };

static double points[3 * MOST], sigma[MOST], feet[MOST], knots[32], control[3 * 16], weights[16];
static cagd_fit_unknown unknown[64];
static cagd_fit_data data;
static cagd_spline curve;
static cagd_stationary_problem problem;

/* ---- A quarter of the circle of radius 65 with points of integer coordinates ----------------------- */

/* (x, y) = 65 ((1-t^2), 2t)/(1+t^2): weights 1, 1, 2 over the points (65,0), (65,65), (0,65). */
static const int pythagorean[][2] = {{63, 16}, {60, 25}, {56, 33}, {52, 39}, {39, 52}, {33, 56}, {25, 60}, {16, 63}};
enum { PYTHAGOREAN = sizeof pythagorean / sizeof pythagorean[0] };

/* The points themselves, or each of them twice, nearer to the centre and farther from it by the factor 1 -+ 1/16.
 * Their feet are the points; the residuals cancel in pairs, so that the circle is stationary for every loss. */
static void circle(int pairs)
{
    static const double k[] = {0, 0, 0, 1, 1, 1}, P[] = {65, 0, 65, 65, 0, 65}, w[] = {1, 1, 2};
    memcpy(knots, k, sizeof k);
    memcpy(control, P, sizeof P);
    memcpy(weights, w, sizeof w);
    int count = 0;
    for (int i = 0; i < PYTHAGOREAN; i++)
        for (int side = pairs ? -1 : 0; side <= pairs; side += 2) {
            double factor = 1 + side * 0x1p-4;
            for (int c = 0; c < 2; c++)
                points[2 * count + c] = factor * pythagorean[i][c];
            feet[count++] = pythagorean[i][1] / (65.0 + pythagorean[i][0]);
        }
    unknown[0] = (cagd_fit_unknown){1, 1, 0};
    unknown[1] = (cagd_fit_unknown){0, 1, 0};
    unknown[2] = (cagd_fit_unknown){0, 1, 1};
    data = (cagd_fit_data){count, 2, points, NULL};
    curve = (cagd_spline){2, 3, 2, knots, control, weights};
    problem = (cagd_stationary_problem){
        .data = &data, .loss_scale = 8, .curve = &curve, .feet = feet, .unknowns = 3, .unknown = unknown};
}

static void the_circle_is_found_at_its_place(void **state)
{
    (void)state;
    static const cagd_fit_loss losses[] = {CAGD_FIT_SQUARES, CAGD_FIT_HUBER, CAGD_FIT_CAUCHY};
    for (int pairs = 0; pairs < 2; pairs++)
        for (int l = 0; l < 3; l++) {
            circle(pairs);
            problem.loss = losses[l];
            cagd_stationary_verdict v = cagd_stationary_check(&problem);
            if (!v.verified || !v.minimum)
                print_error("pairs %d, loss %d: %s\n", pairs, l, v.verified ? "no minimum" : v.reason);
            assert_true(v.verified && v.minimum && v.dimension == 3 && v.where == -1);
            assert_true(v.weight_radius < 0x1p-80 && v.point_radius < 0x1p-70); /* a gradient of 0, in 128 bits */
            assert_true(v.weight_alone > 0x1p-26 && v.point_alone > 0x1p-20);
        }
}

/* Cauchy's loss bends the other way beyond its scale: the circle between far pairs is stationary, and no minimum. */
static void what_is_no_minimum_is_not_called_one(void **state)
{
    (void)state;
    circle(1);
    problem.loss = CAGD_FIT_CAUCHY;
    problem.loss_scale = 2;
    cagd_stationary_verdict v = cagd_stationary_check(&problem);
    assert_true(v.verified && !v.minimum && v.weight_radius < 0x1p-80);
}

/* A segment between pairs of points, of which those at one end, at the other, at both or at none are so far apart that Cauchy's loss bends the other way
 * there: one direction that falls is enough for no minimum, whichever it is. */
static void one_direction_that_falls_is_enough(void **state)
{
    (void)state;
    for (int far = 0; far < 4; far++) {
        static const double line[] = {0, 0, 1, 1};
        memcpy(knots, line, sizeof line);
        memset(control, 0, sizeof control);
        control[2] = 8;
        for (int i = 0; i < 4; i++) {
            points[2 * i] = i < 2 ? 1 : 7;
            points[2 * i + 1] = (i % 2 ? -1 : 1) * (far >> (i / 2) & 1 ? 4 : 0.25);
            feet[i] = points[2 * i] / 8;
        }
        curve = (cagd_spline){1, 2, 2, knots, control, NULL};
        data = (cagd_fit_data){4, 2, points, NULL};
        for (int turn = 0; turn < 2; turn++) {
            unknown[turn] = (cagd_fit_unknown){0, 0, 1}, unknown[1 - turn] = (cagd_fit_unknown){0, 1, 1};
            problem = (cagd_stationary_problem){.data = &data,
                                                .loss = CAGD_FIT_CAUCHY,
                                                .loss_scale = 1,
                                                .curve = &curve,
                                                .feet = feet,
                                                .unknowns = 2,
                                                .unknown = unknown};
            cagd_stationary_verdict v = cagd_stationary_check(&problem);
            assert_true(v.verified && v.dimension == 2 && v.minimum == (far == 0));
        }
    }
}

static void a_reported_circle_that_is_a_little_off_has_the_true_one_in_its_radius(void **state)
{
    (void)state;
    for (int e = -45; e <= -25; e += 10)
        for (int a = 0; a < 3; a++) {
            circle(1);
            double shift = ldexp(1, e);
            if (a == 0)
                weights[1] = exp(shift);
            else
                control[1 + a] += shift;
            cagd_stationary_verdict v = cagd_stationary_check(&problem);
            if (!v.verified || !v.minimum)
                print_error("shift 2^%d of unknown %d: %s\n", e, a, v.reason);
            assert_true(v.verified && v.minimum);
            double radius = a == 0 ? v.weight_radius : v.point_radius;
            assert_true(radius >= shift * (1 - DBL_EPSILON) && radius < 2 * shift);
            assert_true(a == 0 ? v.weight_alone > shift : v.point_alone > shift);
        }
}

/* The arc from (63, 16) to (16, 63), whose middle point has the coordinates 65^2/(63+16), and whose weight is 79/(65 sqrt 2): no numbers in
 * binary64.  How far the nearest one is from them belongs to the radius, though it is less than half of a last digit. */
static void a_place_between_two_numbers(void **state)
{
    (void)state;
    circle(1);
    control[0] = control[5] = 63, control[1] = control[4] = 16, control[2] = control[3] = 4225.0 / 79;
    weights[1] = 79 / (65 * sqrt(2)), weights[2] = 1;
    data.count -= 4; /* without the ends of the arc, each twice */
    memmove(points, points + 4, (size_t)data.count * 2 * sizeof *points);
    for (int i = 0; i < data.count; i++) { /* (1-t)^2 (63 y - 16 x) + 2 t (1-t) w m (y - x) + t^2 (16 y - 63 x) = 0 */
        double low = 0, high = 1, x = points[2 * i], y = points[2 * i + 1];
        for (int k = 0; k < 60; k++) {
            double t = (low + high) / 2;
            double side = (1 - t) * (1 - t) * (63 * y - 16 * x) + t * t * (16 * y - 63 * x) +
                          2 * t * (1 - t) * weights[1] * control[2] * (y - x);
            *(side > 0 ? &low : &high) = t;
        }
        feet[i] = low;
    }
    num_q off = sub_q(from_double_q(control[2]), from_ratio_q(4225, 79));
    if (cagd_sign_q(off) < 0)
        off = neg_q(off);
    assert_true(cagd_sign_q(off) > 0);
    cagd_stationary_verdict v = cagd_stationary_check(&problem);
    if (!v.verified)
        print_error("%s\n", v.reason);
    assert_true(v.verified && v.minimum);
    assert_true(cagd_compare_q(from_double_q(v.point_radius), off) >= 0 && v.point_radius < 0x1p-46);
}

/* One unknown alone: the box has one direction. */
static void one_unknown_is_enough(void **state)
{
    (void)state;
    for (int a = 0; a < 3; a++) {
        circle(1);
        problem.unknown = unknown + a;
        problem.unknowns = 1;
        cagd_stationary_verdict v = cagd_stationary_check(&problem);
        assert_true(v.verified && v.minimum && v.dimension == 1);
        assert_true(v.weight_radius < 0x1p-80 && v.point_radius < 0x1p-70);
    }
}

/* What a fit says of itself: points less the origin, the weight free, on a bound, or on the other one. */
static void a_fit_is_checked_about_its_origin(void **state)
{
    (void)state;
    for (int bound = -1; bound <= 1; bound++) {
        circle(1);
        double value[3] = {0, 65, 65}, there[2 * 3], moved[2 * 2 * PYTHAGOREAN];
        int at_bound[3] = {bound != 0, 0, 0};
        for (int m = 0; m < 2 * data.count; m++)
            moved[m] = points[m] + (m % 2 == 0 ? 1024 : -4096);
        for (int m = 0; m < 6; m++)
            there[m] = control[m] + (m % 2 == 0 ? 1024 : -4096);
        const cagd_fit_data elsewhere = {data.count, 2, moved, NULL};
        const cagd_fit_options options = {
            .weight_low = bound < 0 ? 1 : 0.25, .weight_high = bound > 0 ? 1 : 4, .tolerance = 1e-10};
        const cagd_fit_result result = {.curve = {2, 3, 2, knots, there, weights},
                                        .origin = {1024, -4096},
                                        .relative = control,
                                        .feet = feet,
                                        .count = data.count,
                                        .loss_scale = 1,
                                        .unknowns = 3,
                                        .rank = 3 - at_bound[0],
                                        .unknown = unknown,
                                        .value = value,
                                        .at_bound = at_bound};
        cagd_stationary_verdict v = cagd_stationary_check_fit(&elsewhere, &options, &result);
        assert_true(v.verified && v.dimension == 3 - at_bound[0] && v.point_radius < 0x1p-70);
        assert_true(v.minimum == (bound == 0)); /* of the circle the multiplier is 0, which is not told from others */
        assert_int_equal(v.bounds, bound == 0 ? CAGD_STATIONARY_NO_BOUNDS : CAGD_STATIONARY_OPEN);
    }
}

/* So far off that the centre has to move first; x, y and the weights are of different sizes. */
static void a_circle_elsewhere_is_found_from_farther_away(void **state)
{
    (void)state;
    for (int e = -20; e <= -12; e += 2)
        for (int a = 0; a < 3; a++) {
            circle(1);
            for (int i = 0; i < data.count; i++)
                points[2 * i] += 1024, points[2 * i + 1] -= 4096;
            for (int i = 0; i < curve.count; i++)
                control[2 * i] += 1024, control[2 * i + 1] -= 4096;
            double shift = ldexp(1, e);
            if (a == 0)
                weights[1] = exp(shift);
            else
                control[1 + a] += shift;
            cagd_stationary_verdict v = cagd_stationary_check(&problem);
            if (!v.verified || !v.minimum)
                print_error("shift 2^%d of unknown %d: %s\n", e, a, v.reason);
            assert_true(v.verified && v.minimum);
            double radius = a == 0 ? v.weight_radius : v.point_radius;
            assert_true(radius >= shift * (1 - DBL_EPSILON) && radius < 8 * shift);
            assert_true((a == 0 ? v.point_radius / 65 : v.weight_radius) < shift);
        }
}

static void what_is_not_near_is_refused(void **state)
{
    (void)state;
    circle(1);
    weights[1] = 1.5;
    cagd_stationary_verdict v = cagd_stationary_check(&problem);
    assert_true(!v.verified && !v.minimum && v.reason != NULL);
    circle(1);
    control[2] = 80;
    v = cagd_stationary_check(&problem);
    assert_true(!v.verified && v.reason != NULL);
}

static void wrong_feet_are_refused(void **state)
{
    (void)state;
    circle(1);
    feet[5] = 0.9;
    cagd_stationary_verdict v = cagd_stationary_check(&problem);
    assert_true(!v.verified && v.where == 5 && v.reason != NULL);
    circle(1);
    feet[3] = 1.25; /* outside the domain */
    v = cagd_stationary_check(&problem);
    assert_true(!v.verified && v.where == 3);
    circle(1);
    feet[7] = NAN;
    v = cagd_stationary_check(&problem);
    assert_true(!v.verified && v.where == 7);
}

/* The point nearest to the end of the curve is the end: stays there. */
static void feet_at_the_ends(void **state)
{
    (void)state;
    circle(1);
    int last = data.count;
    points[2 * last] = 65, points[2 * last + 1] = 0, feet[last] = 0; /* the fixed end itself */
    points[2 * last + 2] = 66, points[2 * last + 3] = -3, feet[last + 1] = 0;
    points[2 * last + 4] = -2, points[2 * last + 5] = 65, feet[last + 2] = 1;
    data.count += 3;
    cagd_stationary_verdict v = cagd_stationary_check(&problem);
    assert_true(v.verified && v.minimum && v.weight_radius < 0x1p-80);
    points[2 * last + 2] = 66, points[2 * last + 3] = 0; /* its foot is the end, but only just */
    v = cagd_stationary_check(&problem);
    assert_true(v.verified && v.minimum && v.weight_radius < 0x1p-80);
    feet[last + 1] = 0x1p-60; /* nearly the end */
    v = cagd_stationary_check(&problem);
    assert_true(v.verified && v.minimum && v.weight_radius < 0x1p-80);
    points[2 * last] = 65 - 0x1p-40, points[2 * last + 1] = 0; /* nearly the fixed end */
    v = cagd_stationary_check(&problem);
    assert_true(v.verified && v.minimum && v.weight_radius < 0x1p-80);
    points[2 * last + 2] = 66, points[2 * last + 3] = 3, feet[last + 1] = 0; /* its foot is inside: no minimum here */
    v = cagd_stationary_check(&problem);
    assert_true(!v.verified);
}

/* Of the points below, on and above the normal at the end (65, 0), the box has feet at the end and inside; gradients
 * at its corners, where every foot is one or the other, and the way between corners, are in the enclosures. */
static void a_foot_at_the_end_or_inside(void **state)
{
    (void)state;
    enum { CORNERS = 8 };
    static const double h = 0x1p-10, none[3] = {0, 0, 0}, box[3] = {0x1p-10, 0x1p-10, 0x1p-10};
    double low[3], high[3], hessian_low[9], hessian_high[9], g[CORNERS][3], above[3], unused_low[9], unused_high[9];
    int where, inside = 0;
    circle(1);
    data.count = 1;
    for (int place = -1; place <= 1; place++) {
        points[0] = 77, points[1] = place * 0x1p-14;
        feet[0] = 0;
        assert_true(cagd_stationary_enclosures(&problem, box, low, high, hessian_low, hessian_high, &where));
        for (int k = 0; k < CORNERS; k++) {
            double step[3];
            for (int a = 0; a < 3; a++)
                step[a] = k >> a & 1 ? h : -h;
            weights[1] = exp(step[0]), control[2] = 65 + step[1], control[3] = 65 + step[2];
            assert_true(cagd_stationary_enclosures(&problem, none, g[k], above, unused_low, unused_high, &where));
            inside += g[k][1] != 0;
            for (int a = 0; a < 3; a++)
                assert_true(low[a] <= g[k][a] && above[a] <= high[a]);
        }
        circle(1);
        data.count = 1;
        for (int k = 0; k < CORNERS; k++)
            for (int l = 0; l < CORNERS; l++)
                for (int a = 0; a < 3; a++) { /* g(k) - g(l) is in H (k - l) */
                    double least = 0, most = 0, rounding = 0x1p-40;
                    for (int b = 0; b < 3; b++) {
                        double way = h * ((k >> b & 1) - (l >> b & 1)) * 2;
                        least += way * (way > 0 ? hessian_low : hessian_high)[3 * a + b];
                        most += way * (way > 0 ? hessian_high : hessian_low)[3 * a + b];
                    }
                    assert_true(least - rounding <= g[k][a] - g[l][a] && g[k][a] - g[l][a] <= most + rounding);
                }
    }
    assert_true(0 < inside && inside < 3 * CORNERS);
}

/* Where the ends may slide along the circle, no curve is alone; across these directions it is. */
static void free_directions_are_left_out(void **state)
{
    (void)state;
    circle(1);
    /* the ends are (65,0) and (0,65); the tangents there are vertical and horizontal */
    unknown[3] = (cagd_fit_unknown){0, 0, 1};
    unknown[4] = (cagd_fit_unknown){0, 2, 0};
    problem.unknowns = 5;
    cagd_stationary_verdict v = cagd_stationary_check(&problem);
    assert_false(v.verified);
    /* Weights in the gauge w_0 = 1, w_2 = 2.  With the end (65 cos a, 65 sin a) instead of (65, 0), a small: the
     * middle point (65, 65) becomes (65 - 65 a, 65) to first order, where the tangents meet; the end (65, 65 a); and
     * I_1 = w_1^2/2 = cos^2 of half the angle pi/2 - a, which is (1 + sin a)/2, so that log w_1 grows by a/2.  The
     * same at the other end, with coordinates exchanged. */
    static const double directions[] = {0.5, -65, 0, 65, 0, 0.5, 0, -65, 0, 65};
    problem.free_directions = directions;
    problem.free_count = 2;
    v = cagd_stationary_check(&problem);
    if (!v.verified)
        print_error("%s at %d\n", v.reason, v.where);
    assert_true(v.verified && v.minimum && v.dimension == 3);
    static const int held[] = {0, 0, 0, 1, 1};
    problem.free_directions = NULL;
    problem.free_count = 0;
    problem.held = held;
    v = cagd_stationary_check(&problem);
    assert_true(v.verified && v.dimension == 3);
}

/* ---- Derivatives of F against F ---------------------------------------------------------------------- */

/* A foot of Q near t by Newton's method, inside the domain. */
static double foot_of(const double Q[], double t, int *at_end)
{
    double d[9], first = knots[curve.degree], last = knots[curve.count];
    for (int step = 0; step < 50; step++) {
        double phi = 0, slope = 0;
        cagd_spline_derivatives(&curve, t, CAGD_RIGHT, 2, d);
        for (int c = 0; c < curve.dim; c++) {
            phi += (d[c] - Q[c]) * d[curve.dim + c];
            slope += d[curve.dim + c] * d[curve.dim + c] + (d[c] - Q[c]) * d[2 * curve.dim + c];
        }
        double next = fmin(last, fmax(first, t - phi / slope));
        if (fabs(next - t) < 0x1p-51)
            break;
        t = next;
    }
    *at_end = t == first || t == last;
    return t;
}

/* F, with feet near those that are there, which are replaced; the loss by its definition. */
static double cost(void)
{
    double F = 0, P[3];
    for (int i = 0; i < data.count; i++) {
        int at_end;
        const double *Q = points + i * curve.dim;
        double s = 0, a = problem.loss_scale;
        feet[i] = foot_of(Q, feet[i], &at_end);
        cagd_spline_point(&curve, feet[i], CAGD_RIGHT, P);
        for (int c = 0; c < curve.dim; c++)
            s += (P[c] - Q[c]) * (P[c] - Q[c]) / (sigma[i] * sigma[i]);
        F += problem.loss == CAGD_FIT_SQUARES  ? s
             : problem.loss == CAGD_FIT_CAUCHY ? a * a * log1p(s / (a * a))
             : s <= a * a                      ? s
                                               : 2 * a * sqrt(s) - a * a;
    }
    return F / 2;
}

/* A cubic of three segments with high-entropy data, every weight but the first and every coordinate unknown. */
static void spline_on(const double k[10], int dim, cagd_fit_loss loss)
{
    int at_end, count = 40;
    memcpy(knots, k, 10 * sizeof *k);
    curve = (cagd_spline){3, 6, dim, knots, control, weights};
    problem = (cagd_stationary_problem){
        .data = &data, .loss = loss, .loss_scale = 1.5, .curve = &curve, .feet = feet, .unknown = unknown};
    for (int i = 0; i < 6; i++) {
        weights[i] = i == 0 ? 1 : random_int(600, 1900) / 1000.0;
        for (int c = 0; c < dim; c++) {
            control[i * dim + c] = (c == 0 ? 2.0 * i : 0) + random_int(-1000, 1000) / 999.0;
            unknown[problem.unknowns++] = (cagd_fit_unknown){0, i, c};
        }
        if (i > 0)
            unknown[problem.unknowns++] = (cagd_fit_unknown){1, i, 0};
    }
    for (int i = 0; i < count; i++) {
        double t = k[3] + (k[6] - k[3]) * (i + 0.5) / count, P[3];
        cagd_spline_point(&curve, t, CAGD_RIGHT, P);
        sigma[i] = random_int(50, 100) / 1001.0;
        for (int c = 0; c < dim; c++)
            points[i * dim + c] = P[c] + random_int(-1000, 1000) / 9999.0;
        feet[i] = foot_of(points + i * dim, t, &at_end);
    }
    data = (cagd_fit_data){count, dim, points, sigma};
}
static const double clamped[] = {0, 0, 0, 0, 0.4, 0.7, 1, 1, 1, 1};
static void spline(int dim, cagd_fit_loss loss) { spline_on(clamped, dim, loss); }

static void move(int a, double by)
{
    const cagd_fit_unknown *u = &unknown[a];
    if (u->is_weight)
        weights[u->index] *= exp(by);
    else
        control[u->index * curve.dim + u->coordinate] += by;
}

/* By the mean value theorem F(theta + h) - F(theta) lies in h times the gradient over the box between, and so do the
 * differences of the gradient in h times the Hessian. */
static void the_enclosures_hold_the_differences(void **state)
{
    (void)state;
    enum { N = 64 };
    static double radius[N], zero[N], low[N], high[N], g_low[N], g_high[N], H_low[N * N], H_high[N * N], H[2][N * N];
    static const cagd_fit_loss losses[] = {CAGD_FIT_SQUARES, CAGD_FIT_HUBER, CAGD_FIT_CAUCHY};
    const double h = 0x1p-14;
    int done = 0, where;
    for (int round = 0; round < 12; round++) {
        spline(2 + round % 2, losses[round % 3]);
        int n = problem.unknowns, a = random_int(0, n - 1);
        double before = cost(), Q[3], s = 0;
        cagd_spline_point(&curve, feet[3], CAGD_RIGHT, Q);
        for (int c = 0; c < curve.dim; c++)
            s += (Q[c] - points[3 * curve.dim + c]) * (Q[c] - points[3 * curve.dim + c]) / (sigma[3] * sigma[3]);
        problem.loss_scale = sqrt(s); /* where the loss of Huber is bent, inside the box */
        before = cost();
        assert_true(cagd_stationary_enclosures(&problem, zero, low, high, H[0], H[1], &where));
        for (int b = 0; b < n; b++)
            radius[b] = b == a ? h : 0;
        assert_true(cagd_stationary_enclosures(&problem, radius, g_low, g_high, H_low, H_high, &where));
        double was[2][N];
        memcpy(was[0], low, sizeof low), memcpy(was[1], high, sizeof high);
        move(a, h);
        double change = cost() - before;
        if (!(h * g_low[a] <= change && change <= h * g_high[a]))
            print_error("round %d unknown %d: %g not in [%g, %g]\n", round, a, change / h, g_low[a], g_high[a]);
        assert_true(h * g_low[a] <= change && change <= h * g_high[a]);
        assert_true(cagd_stationary_enclosures(&problem, zero, low, high, H[0], H[1], &where));
        for (int b = 0; b < n; b++) {
            assert_true(high[b] - was[0][b] >= h * H_low[b * n + a] && low[b] - was[1][b] <= h * H_high[b * n + a]);
            assert_true(H_low[b * n + a] == H_low[a * n + b]);
            /* a weight is moved to a rounded number, so that only orders of magnitude say how sharp this is */
            if (problem.loss == CAGD_FIT_CAUCHY)
                done +=
                    H_high[b * n + a] - H_low[b * n + a] < 0.2 * fmax(fabs(H_low[a * n + a]), fabs(H_high[a * n + a]));
        }
    }
    assert_true(done > 20);
}

/* Gradient and Hessian in points against differences of F and of the gradient, over 2^-14 to both sides: with feet inside the domain and at
 * its ends, where the curve ends in its first and last point and where it does not, and deviations that differ. */
static void derivatives_are_limits_of_differences(void **state)
{
    (void)state;
    enum { N = 64 };
    static double none[N], g[2][N], H[2][N * N], side[2][2][N], unused[2][N * N];
    static const double uniform[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    static const cagd_fit_loss losses[] = {CAGD_FIT_SQUARES, CAGD_FIT_HUBER, CAGD_FIT_CAUCHY};
    const double h = 0x1p-14;
    int where, at_end, inside = 0, beyond = 0, at_ends = 0;
    for (int round = 0; round < 12; round++) {
        const int dim = 2 + round % 2;
        spline_on(round < 6 ? clamped : uniform, dim, losses[round % 3]);
        for (int end = 0; end < 2; end++) { /* two points behind each end of the curve */
            double t = knots[end ? curve.count : curve.degree], d[6];
            cagd_spline_derivatives(&curve, t, end ? CAGD_LEFT : CAGD_RIGHT, 1, d);
            for (int more = 1; more <= 2; more++) {
                int i = end ? data.count - more : more - 1;
                for (int c = 0; c < dim; c++)
                    points[i * dim + c] =
                        d[c] + (end ? 1 : -1) * more * 0x1p-6 * d[dim + c] + random_int(-99, 99) / 9999.0;
                feet[i] = t;
            }
        }
        const int n = problem.unknowns;
        cost();
        problem.loss_scale = 1.25;
        assert_true(cagd_stationary_enclosures(&problem, none, g[0], g[1], H[0], H[1], &where));
        for (int i = 0; i < data.count; i++) {
            double s = 0, P[3];
            cagd_spline_point(&curve, foot_of(points + i * dim, feet[i], &at_end), CAGD_RIGHT, P);
            for (int c = 0; c < dim; c++)
                s += (P[c] - points[i * dim + c]) * (P[c] - points[i * dim + c]) / (sigma[i] * sigma[i]);
            *(s < 1.25 * 1.25 ? &inside : &beyond) += 1;
            at_ends += at_end;
        }
        double size = 0;
        for (int m = 0; m < n * n; m++)
            size = fmax(size, fabs(H[0][m]));
        for (int a = 0; a < n; a++) {
            double F[2], kept_control[18], kept_weights[6];
            memcpy(kept_control, control, sizeof kept_control), memcpy(kept_weights, weights, sizeof kept_weights);
            for (int k = 0; k < 2; k++) {
                move(a, k == 0 ? -h : h);
                F[k] = cost();
                assert_true(
                    cagd_stationary_enclosures(&problem, none, side[k][0], side[k][1], unused[0], unused[1], &where));
                memcpy(control, kept_control, sizeof kept_control), memcpy(weights, kept_weights, sizeof kept_weights);
            }
            cost();
            double slope = (F[1] - F[0]) / (2 * h);
            if (!(fabs(slope - g[0][a]) <= 0x1p-16 * size))
                print_error("round %d, gradient %d: %.9g for %.9g\n", round, a, g[0][a], slope);
            assert_true(fabs(slope - g[0][a]) <= 0x1p-16 * size);
            for (int b = 0; b < n; b++) {
                double bend = (side[1][0][b] - side[0][0][b]) / (2 * h);
                for (int k = 0; k < 2; k++) {
                    if (!(fabs(bend - H[k][b * n + a]) <= 0x1p-16 * size))
                        print_error("round %d, Hessian %d %d: %.9g for %.9g, size %g\n", round, b, a, H[k][b * n + a],
                                    bend, size);
                    assert_true(fabs(bend - H[k][b * n + a]) <= 0x1p-16 * size);
                }
            }
        }
    }
    assert_true(inside > 100 && beyond > 100 && at_ends > 30);
}

/* Points nearer to the centre than the circle, on it, or farther away: the weight, which alone is unknown, ought to
 * be smaller, what it is, or larger.  On its low bound it must be larger, on its high one smaller. */
static void what_a_bound_forbids_alone(void **state)
{
    (void)state;
    for (int side = -1; side <= 1; side++)
        for (int hold = CAGD_STATIONARY_HELD; hold <= CAGD_STATIONARY_AT_HIGH; hold++) {
            circle(0);
            for (int m = 0; m < 2 * data.count; m++)
                points[m] *= 1 + side * 0x1p-7;
            problem.unknowns = 1;
            problem.held = &hold;
            cagd_stationary_verdict v = cagd_stationary_check(&problem);
            assert_true(v.dimension == 0 && v.weight_radius == 0);
            if (hold == CAGD_STATIONARY_HELD) {
                assert_true(!v.verified && !v.minimum && v.bounds == CAGD_STATIONARY_NO_BOUNDS && v.reason != NULL);
                continue;
            }
            int grows = hold == CAGD_STATIONARY_AT_LOW ? -side : side;
            assert_true(v.verified && v.minimum == (grows > 0) && v.bound == (grows > 0 ? -1 : 0));
            assert_int_equal(v.bounds, grows > 0   ? CAGD_STATIONARY_GROWS
                                       : grows < 0 ? CAGD_STATIONARY_FALLS
                                                   : CAGD_STATIONARY_OPEN);
        }
}

/* The points (63,16) and (16,63) moved along their normals by 16 e and -63 e: by symmetry they pull P1 in x by as much as each
 * other, in opposite ways, and not the weight.  A multiplier that is not known, 0, does not hide one that falls; an unknown that is
 * merely held is asked for nothing. */
static void several_bounds_at_once(void **state)
{
    (void)state;
    for (int side = -1; side <= 1; side += 2)
        for (int first_low = 0; first_low < 2; first_low++)
            for (int swapped = 0; swapped < 2; swapped++) {
                circle(0);
                data.count = 2;
                double by[2] = {1 + side * 16 * 0x1p-12, 1 - side * 63 * 0x1p-12};
                for (int i = 0; i < 2; i++) {
                    const int *on = pythagorean[i == 0 ? 0 : PYTHAGOREAN - 1];
                    for (int c = 0; c < 2; c++)
                        points[2 * i + c] = by[i] * on[c];
                    feet[i] = on[1] / (65.0 + on[0]);
                }
                unknown[0] = (cagd_fit_unknown){0, 1, 1};
                unknown[1 + swapped] = (cagd_fit_unknown){1, 1, 0};
                unknown[2 - swapped] = (cagd_fit_unknown){0, 1, 0};
                int held[3] = {CAGD_STATIONARY_HELD, CAGD_STATIONARY_AT_LOW, CAGD_STATIONARY_AT_LOW};
                held[1 + swapped] = first_low ? CAGD_STATIONARY_AT_LOW : CAGD_STATIONARY_AT_HIGH;
                problem.held = held;
                cagd_stationary_verdict v = cagd_stationary_check(&problem);
                int falls = (side < 0) != (first_low == 0); /* on the whole the points are farther out for side < 0 */
                assert_true(v.verified && !v.minimum);
                assert_int_equal(v.bounds, falls ? CAGD_STATIONARY_FALLS : CAGD_STATIONARY_OPEN);
                assert_int_equal(v.bound, falls ? 1 + swapped : 2 - swapped);
            }
}

/* Newton's method for the middle point, the weight being what it is. */
static void settle_the_middle_point(void)
{
    static const double none[3] = {0, 0, 0};
    for (int step = 0; step < 20; step++) {
        double g[3], above[3], H[9], H_above[9];
        int where, at_end;
        for (int i = 0; i < data.count; i++)
            feet[i] = foot_of(points + 2 * i, feet[i], &at_end);
        assert_true(cagd_stationary_enclosures(&problem, none, g, above, H, H_above, &where));
        double det = H[4] * H[8] - H[5] * H[7];
        control[2] -= (H[8] * g[1] - H[5] * g[2]) / det;
        control[3] -= (H[4] * g[2] - H[7] * g[1]) / det;
    }
}

/* The weight of the circle is 1: where it is kept from growing to 1, or from falling to 1, the bound holds it. */
static void what_a_bound_forbids_beside_free_points(void **state)
{
    (void)state;
    for (int side = -1; side <= 1; side++)
        for (int hold = CAGD_STATIONARY_HELD; hold <= CAGD_STATIONARY_AT_HIGH; hold++) {
            int held[3] = {hold, CAGD_STATIONARY_FREE, CAGD_STATIONARY_FREE};
            circle(1);
            weights[1] = 1 + side * 0x1p-5;
            settle_the_middle_point();
            problem.held = held;
            cagd_stationary_verdict v = cagd_stationary_check(&problem);
            assert_true(v.verified && v.dimension == 2 && v.reason == NULL && v.point_radius < 0x1p-30);
            int grows = hold == CAGD_STATIONARY_HELD ? 1 : hold == CAGD_STATIONARY_AT_LOW ? side : -side;
            assert_true(v.minimum == (grows > 0) && v.bound == (grows > 0 ? -1 : 0));
            assert_int_equal(v.bounds, hold == CAGD_STATIONARY_HELD ? CAGD_STATIONARY_NO_BOUNDS
                                       : grows > 0                  ? CAGD_STATIONARY_GROWS
                                       : grows < 0                  ? CAGD_STATIONARY_FALLS
                                                                    : CAGD_STATIONARY_OPEN);
        }
}

/* The first and the last point that a fit is of measure its ends: their feet are held there, though nearer points of the curve are inside.
 * Three points before them and two behind them are left out, whatever they are; each pair of points has a deviation of its own. */
static void a_fit_without_some_points_at_its_ends(void **state)
{
    (void)state;
    enum { BEFORE = 3, BEHIND = 2, FEW = 2 * PYTHAGOREAN + 2, ALL = BEFORE + FEW + BEHIND };
    for (int left_out = 0; left_out < 2; left_out++) {
        circle(1);
        const int before = left_out ? BEFORE : 0, behind = left_out ? BEHIND : 0, all = before + FEW + behind;
        double some[2 * ALL], deviation[ALL], their_feet[ALL], value[3] = {0, 65, 65};
        int at_bound[3] = {0};
        for (int i = 0; i < all; i++) {
            some[2 * i] = 1000 + 64 * i, some[2 * i + 1] = -500, their_feet[i] = 0.5, deviation[i] = 0x1p-8;
            if (i < before || i >= before + FEW)
                continue;
            const int own = i - before, pair = own - 1; /* the ends around the pairs */
            deviation[i] = own == 0 ? 1 : ldexp(1, (pair / 2) % 3);
            for (int c = 0; c < 2; c++)
                some[2 * i + c] = own == 0         ? (c == 0 ? 65 : 3)
                                  : own == FEW - 1 ? (c == 0 ? 3 : 65)
                                                   : points[2 * pair + c];
            their_feet[i] = own == 0 ? 0 : own == FEW - 1 ? 1 : feet[pair];
        }
        const cagd_fit_data measured = {all, 2, some, deviation};
        const cagd_fit_options options = {.weight_low = 0.25, .weight_high = 4, .tolerance = 1e-10};
        cagd_fit_result result = {.curve = {2, 3, 2, knots, control, weights},
                                  .relative = control,
                                  .feet = their_feet,
                                  .count = all,
                                  .loss_scale = 1,
                                  .left_out = {before, behind},
                                  .end_points = {before, before + FEW - 1},
                                  .unknowns = 3,
                                  .rank = 3,
                                  .unknown = unknown,
                                  .value = value,
                                  .at_bound = at_bound};
        cagd_stationary_verdict v = cagd_stationary_check_fit(&measured, &options, &result);
        if (!v.verified)
            print_error("left out %d, point %d: %s\n", left_out, v.where, v.reason);
        assert_true(v.verified && v.minimum && v.dimension == 3 && v.point_radius < 0x1p-70);
        for (int end = 0; end < 2; end++) { /* a point that measures no end has a foot inside */
            result.end_points[end] = -1;
            v = cagd_stationary_check_fit(&measured, &options, &result);
            assert_true(!v.verified && v.where == (end == 0 ? 0 : FEW - 1));
            result.end_points[end] = end == 0 ? before : before + FEW - 1;
        }
        result.tied = 1;
        v = cagd_stationary_check_fit(&measured, &options, &result);
        assert_true(!v.verified && !v.minimum && v.bound == -1 && v.where == -1);
        assert_non_null(strstr(v.reason, "share a foot"));
    }
}

/* A fit says with which loss it was made, what it left undetermined, and how much it was smoothed: as asked for, or as found. */
static void what_a_fit_was_asked_for(void **state)
{
    (void)state;
    static double directions[] = {0.5, -65, 0, 65, 0, 0.5, 0, -65, 0, 65};
    circle(1);
    double value[5] = {0, 65, 65, 0, 0};
    int at_bound[5] = {0};
    cagd_fit_options options = {.weight_low = 0.25, .weight_high = 4, .tolerance = 1e-10, .loss = CAGD_FIT_CAUCHY};
    cagd_fit_result result = {.curve = {2, 3, 2, knots, control, weights},
                              .relative = control,
                              .feet = feet,
                              .count = data.count,
                              .loss_scale = 2,
                              .end_points = {-1, -1},
                              .unknowns = 3,
                              .rank = 3,
                              .unknown = unknown,
                              .value = value,
                              .at_bound = at_bound};
    cagd_stationary_verdict v = cagd_stationary_check_fit(&data, &options, &result);
    assert_true(v.verified && !v.minimum); /* as above: far pairs under Cauchy's loss */
    result.loss_scale = 8;
    v = cagd_stationary_check_fit(&data, &options, &result);
    assert_true(v.verified && v.minimum);
    options.loss = CAGD_FIT_SQUARES;
    unknown[3] = (cagd_fit_unknown){0, 0, 1}, unknown[4] = (cagd_fit_unknown){0, 2, 0};
    result.unknowns = 5, result.flat = 2, result.free_directions = directions;
    v = cagd_stationary_check_fit(&data, &options, &result);
    assert_true(v.verified && v.minimum && v.dimension == 3);

    /* The middle point of a smoothed curve, by Newton's method. */
    circle(1);
    problem.unknown = unknown + 1, problem.unknowns = 2, problem.smooth = 0x1p-12;
    for (int step = 0; step < 30; step++) {
        static const double none[2] = {0, 0};
        double g[2], above[2], H[4], H_above[4];
        int where, at_end;
        for (int i = 0; i < data.count; i++)
            feet[i] = foot_of(points + 2 * i, feet[i], &at_end);
        assert_true(cagd_stationary_enclosures(&problem, none, g, above, H, H_above, &where));
        double det = H[0] * H[3] - H[1] * H[2];
        control[2] -= (H[3] * g[0] - H[1] * g[1]) / det;
        control[3] -= (H[0] * g[1] - H[2] * g[0]) / det;
    }
    assert_true(fabs(control[2] - 65) > 0x1p-6);
    result.unknowns = result.rank = 2, result.unknown = unknown + 1, result.flat = 0, result.free_directions = NULL;
    for (int way = 0; way < 4; way++) { /* asked for; found; both, of which the first counts; not at all */
        options.smooth = way == 0 || way == 2 ? 0x1p-12 : 0;
        result.found.smooth = way == 1 ? 0x1p-12 : way == 2 ? 1 : 0;
        v = cagd_stationary_check_fit(&data, &options, &result);
        assert_true(way < 3 ? v.verified && v.minimum && v.point_radius < 0x1p-36
                            : !v.verified || v.point_radius > 0x1p-7);
    }
}

/* A closed quadratic B-spline with knots 0, 1, 2, ...: at multiples of 1/16 that are no knots point and derivative are numbers in binary64, and so are pairs of points to
 * both sides along the normal, between which the curve is stationary for every choice of unknowns. */
enum { OWN = 5, REPEATED = 2, UNKNOWNS = 3 * OWN - 1 };
static void closed_curve(const int turns)
{
    static const double P[2 * OWN] = {0, 0, 64, -16, 96, 48, 32, 96, -32, 48};
    int count = 0, unknowns = 0;
    for (int k = 0; k < OWN + REPEATED + 3; k++)
        knots[k] = k;
    for (int i = 0; i < OWN + REPEATED; i++) {
        weights[i] = 1;
        for (int c = 0; c < 2; c++)
            control[2 * i + c] = P[2 * (i % OWN) + c];
    }
    curve = (cagd_spline){2, OWN + REPEATED, 2, knots, control, weights};
    for (int k = 1; k < 16 * OWN; k += 1 + (k % 16 == 15)) {
        double t = 2 + k / 16.0, d[4];
        cagd_spline_derivatives(&curve, t, CAGD_RIGHT, 1, d);
        for (int side = -1; side <= 1; side += 2) {
            sigma[count] = ldexp(1, count / 2 % 3);
            points[2 * count] = d[0] + side * 0x1p-6 * d[3];
            points[2 * count + 1] = d[1] - side * 0x1p-6 * d[2];
            feet[count++] = t;
        }
    }
    for (int i = 0; i < OWN; i++) {
        const int own = (i + turns) % OWN;
        unknown[unknowns++] = (cagd_fit_unknown){0, own, 1};
        if (own > 0)
            unknown[unknowns++] = (cagd_fit_unknown){1, own, 0};
        unknown[unknowns++] = (cagd_fit_unknown){0, own, 0};
    }
    data = (cagd_fit_data){count, 2, points, sigma};
}

static void closed_curves_are_checked(void **state)
{
    (void)state;
    for (int turns = 0; turns < OWN; turns += 3)
        for (int moved = -1; moved < (turns == 0 ? UNKNOWNS : 3); moved++) {
            closed_curve(turns);
            double value[UNKNOWNS] = {0};
            int at_bound[UNKNOWNS] = {0};
            const cagd_fit_options options = {.weight_low = 0.25, .weight_high = 4, .tolerance = 1e-10};
            const cagd_fit_result result = {.curve = curve,
                                            .period = OWN,
                                            .relative = control,
                                            .feet = feet,
                                            .count = data.count,
                                            .loss_scale = 1,
                                            .end_points = {-1, -1},
                                            .unknowns = UNKNOWNS,
                                            .rank = UNKNOWNS,
                                            .unknown = unknown,
                                            .value = value,
                                            .at_bound = at_bound};
            const double shift = 0x1p-14;
            for (int i = 0; moved >= 0 && i < OWN + REPEATED; i++)
                if (i % OWN == unknown[moved].index) {
                    if (unknown[moved].is_weight)
                        weights[i] = exp(shift);
                    else
                        control[2 * i + unknown[moved].coordinate] += shift;
                }
            cagd_stationary_verdict v = cagd_stationary_check_fit(&data, &options, &result);
            if (!v.verified || !v.minimum)
                print_error("turns %d, moved %d, point %d: %s\n", turns, moved, v.where, v.reason);
            assert_true(v.verified && v.minimum && v.dimension == UNKNOWNS);
            double radius = moved >= 0 && unknown[moved].is_weight ? v.weight_radius : v.point_radius;
            if (moved < 0)
                assert_true(v.weight_radius < 0x1p-70 && v.point_radius < 0x1p-60);
            else
                assert_true(radius >= shift * (1 - 0x1p-20) && radius < 2 * shift);
            if (moved < 0)
                continue;
            /* the same where nothing else is unknown: it is this point that moves back, and no neighbour */
            cagd_fit_result alone = result;
            alone.unknowns = alone.rank = 1, alone.unknown = unknown + moved;
            v = cagd_stationary_check_fit(&data, &options, &alone);
            radius = unknown[moved].is_weight ? v.weight_radius : v.point_radius;
            assert_true(v.verified && v.dimension == 1 && radius >= shift * (1 - 0x1p-20) && radius < 2 * shift);
        }
}

/* What of a foot at a knot is known: nothing where the curve may have a corner, a knot as often as the degree; everything where it has
 * none. */
static void feet_at_knots(void **state)
{
    (void)state;
    static const struct {
        int degree, multiplicity;
    } list[] = {{1, 1}, {2, 1}, {2, 2}, {3, 1}, {3, 2}, {3, 3}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        const int p = list[k].degree, many = list[k].multiplicity, count = p + 1 + many;
        for (int j = 0; j < count + p + 1; j++)
            knots[j] = j <= p ? 0 : j <= p + many ? 1 : 2;
        for (int i = 0; i < count; i++)
            control[2 * i] = 8 * i, control[2 * i + 1] = i * (count - 1 - i), unknown[i] = (cagd_fit_unknown){0, i, 1};
        curve = (cagd_spline){p, count, 2, knots, control, NULL};
        data = (cagd_fit_data){1, 2, points, NULL};
        problem = (cagd_stationary_problem){
            .data = &data, .loss_scale = 1, .curve = &curve, .feet = feet, .unknowns = count, .unknown = unknown};
        double d[4], none[8] = {0}, low[8], high[8], H[64], H_high[64];
        int where;
        cagd_spline_derivatives(&curve, 1, CAGD_RIGHT, 1, d);
        points[0] = d[0] - d[3] / 64, points[1] = d[1] + d[2] / 64, feet[0] = 1;
        const int is_known = many < p;
        assert_int_equal(cagd_stationary_enclosures(&problem, none, low, high, H, H_high, &where), is_known);
        assert_int_equal(where, is_known ? -1 : 0);
        double sum = 0; /* F is (d_2/64)^2 (1 + (d_1/d_0)^2)/2 or so: its gradient sums up to the normal's part in y */
        for (int i = 0; i < count && is_known; i++) {
            assert_true(low[i] <= high[i] && high[i] - low[i] < 0x1p-30);
            sum += low[i];
        }
        if (is_known)
            assert_true(fabs(sum - (d[1] - points[1])) < 0x1p-30);
        else
            assert_non_null(strstr(cagd_stationary_check(&problem).reason, "corner"));
    }
}

/* A point in which the curve ends is 0 to F as long as that end is known in all coordinates, and is the end. */
static void points_at_the_ends(void **state)
{
    (void)state;
    static const double none[2] = {0, 0};
    double low[2], high[2], H[4], H_high[4];
    int where;
    for (int end = 0; end < 2; end++)
        for (int c = 0; c < 2; c++) {
            circle(1);
            data.count = 1;
            problem.unknowns = 1;
            points[0] = control[end ? 4 : 0], points[1] = control[end ? 5 : 1], feet[0] = end;
            unknown[0] = (cagd_fit_unknown){0, 1, c};
            assert_true(cagd_stationary_enclosures(&problem, none, low, high, H, H_high, &where));
            assert_true(low[0] == 0 && high[0] == 0 && H[0] == 0 && H_high[0] == 0);
            /* An end that may move, along the curve: backward the point is on the curve, forward it is as far as the end has moved. */
            unknown[0] = (cagd_fit_unknown){0, end ? 2 : 0, c};
            assert_true(cagd_stationary_enclosures(&problem, none, low, high, H, H_high, &where));
            if (c != end)
                assert_true(H[0] <= 0 && H_high[0] >= 1);
            else /* across it */
                assert_true(H[0] <= 1 && H_high[0] >= 1 && H[0] > 0.5);
            /* The point is beside the end, inside. */
            circle(1);
            for (int i = 0; i < 2; i++)
                points[2 * data.count + i] = i == end ? 65 : 3;
            feet[data.count++] = end;
            cagd_stationary_verdict v = cagd_stationary_check(&problem);
            assert_true(!v.verified || v.point_radius > 0x1p-20);
            /* unless it is the end that was measured */
            int ends[2] = {-1, -1};
            ends[end] = data.count - 1;
            problem.end_points = ends;
            v = cagd_stationary_check(&problem);
            assert_true(v.verified && v.minimum && v.point_radius < 0x1p-60);
            ends[1 - end] = ends[end], ends[end] = -1;
            v = cagd_stationary_check(&problem);
            assert_true(!v.verified || v.point_radius > 0x1p-20);
        }
    /* The same in space, along each axis: a point that differs in one coordinate is none in which the segment ends, and a coordinate that is not
     * known makes the end unknown. */
    for (int end = 0; end < 2; end++)
        for (int along = 0; along < 3; along++) {
            static const double line[] = {0, 0, 1, 1};
            memcpy(knots, line, sizeof line);
            memset(control, 0, sizeof control), memset(points, 0, 3 * sizeof *points);
            control[3 * (1 - end) + along] = 8;
            curve = (cagd_spline){1, 2, 3, knots, control, NULL};
            data = (cagd_fit_data){1, 3, points, NULL};
            feet[0] = end;
            problem = (cagd_stationary_problem){
                .data = &data, .curve = &curve, .feet = feet, .unknowns = 1, .unknown = unknown};
            for (int c = 0; c < 3; c++) {
                unknown[0] = (cagd_fit_unknown){0, end, c};
                assert_true(cagd_stationary_enclosures(&problem, none, low, high, H, H_high, &where));
                assert_true(H[0] <= 1 && H_high[0] >= 1);
            }
            unknown[0] = (cagd_fit_unknown){0, 1 - end, (along + 1) % 3}; /* by 1/16 from the end its part is 1/16 */
            assert_true(cagd_stationary_enclosures(&problem, none, low, high, H, H_high, &where));
            assert_true(H[0] == 0 && H_high[0] == 0);
            points[along] = 0.5;
            assert_true(cagd_stationary_enclosures(&problem, none, low, high, H, H_high, &where));
            assert_true(H[0] <= 0x1p-8 && H_high[0] >= 0x1p-8 && H_high[0] - H[0] < 0x1p-16);
        }
    /* An end without a tangent is an end. */
    for (int end = 0; end < 2; end++) {
        static const double bezier[] = {0, 0, 0, 1, 1, 1};
        memcpy(knots, bezier, sizeof bezier);
        memset(control, 0, sizeof control), memset(points, 0, 2 * sizeof *points);
        control[end ? 0 : 4] = 8, control[end ? 1 : 5] = 3;
        curve = (cagd_spline){2, 3, 2, knots, control, NULL};
        data = (cagd_fit_data){1, 2, points, NULL};
        feet[0] = end;
        unknown[0] = (cagd_fit_unknown){0, end ? 0 : 2, 1};
        problem =
            (cagd_stationary_problem){.data = &data, .curve = &curve, .feet = feet, .unknowns = 1, .unknown = unknown};
        assert_true(cagd_stationary_enclosures(&problem, none, low, high, H, H_high, &where));
        assert_true(low[0] == 0 && high[0] == 0 && H[0] == 0 && H_high[0] == 0);
    }
    /* Knots 0, 0, 1, 2, ...: the curve begins in no point of its polygon, and ends in none. */
    for (int end = 0; end < 2; end++)
        for (int equal = 0; equal < 2; equal++) {
            static const double P[] = {0, 0, 2, 1, 5, 1, 8, -3};
            for (int i = 0; i < 7; i++)
                knots[i] = i;
            if (equal)
                knots[end ? 6 : 0] = knots[end ? 5 : 1];
            memcpy(control, P, sizeof P);
            curve = (cagd_spline){2, 4, 2, knots, control, NULL};
            data = (cagd_fit_data){1, 2, points, NULL};
            points[0] = P[end ? 6 : 0], points[1] = P[end ? 7 : 1], feet[0] = end ? 4 : 2;
            unknown[0] = (cagd_fit_unknown){0, end ? 2 : 1, 0};
            problem = (cagd_stationary_problem){
                .data = &data, .curve = &curve, .feet = feet, .unknowns = 1, .unknown = unknown};
            assert_true(cagd_stationary_enclosures(&problem, none, low, high, H, H_high, &where));
            double C[2], part = (knots[end ? 5 : 2] - knots[end ? 4 : 1]) / (knots[end ? 5 : 3] - knots[end ? 3 : 1]);
            cagd_spline_point(&curve, feet[0], CAGD_RIGHT, C);
            assert_true(fabs(low[0] - part * (C[0] - points[0])) < 0x1p-40 && high[0] - low[0] < 0x1p-40);
            assert_true(fabs(low[0]) > 0.25);
        }
}

/* Bounds in every order: one that falls, one that grows, one that is not known.  F grows from both bounds where they are asked for one
 * by one, and it is a minimum only where it grows from all. */
static void the_weakest_of_several_bounds(void **state)
{
    (void)state;
    /* Points outside the circle along x and y: F falls with growing x of the middle point, and with growing y. */
    static const int kinds[] = {CAGD_STATIONARY_AT_LOW, CAGD_STATIONARY_AT_HIGH};
    for (int first = 0; first < 2; first++)
        for (int second = 0; second < 2; second++)
            for (int third = 0; third < 2; third++) {
                circle(0);
                for (int m = 0; m < 2 * data.count; m++)
                    points[m] *= 1 + 0x1p-7;
                const int held[3] = {kinds[first], kinds[second], kinds[third]};
                problem.held = held;
                cagd_stationary_verdict v = cagd_stationary_check(&problem);
                const int grows = first && second && third;
                assert_true(v.verified && v.minimum == grows);
                assert_int_equal(v.bounds, grows ? CAGD_STATIONARY_GROWS : CAGD_STATIONARY_FALLS);
                assert_int_equal(v.bound, grows ? -1 : !first ? 0 : !second ? 1 : 2);
            }
}

/* Points near each of three spans, in the plane and in space, with weights: one foot that is not the nearest is told of, whichever it is, and one
 * that is farther by less than what is allowed has that excess. */
static void the_nearest_points_of_several_spans(void **state)
{
    (void)state;
    for (int dim = 2; dim <= 3; dim++) {
        spline(dim, CAGD_FIT_SQUARES);
        for (int i = 0; i < data.count; i++) { /* near the curve, where no other span is as near */
            double d[6];
            int at_end;
            cagd_spline_derivatives(&curve, (i + 0.5) / data.count, CAGD_RIGHT, 1, d);
            for (int c = 0; c < dim; c++)
                points[i * dim + c] = d[c] + random_int(-99, 99) / 99999.0;
            feet[i] = foot_of(points + i * dim, (i + 0.5) / data.count, &at_end);
        }
        cagd_nearest_verdict v = cagd_stationary_nearest(&data, &curve, feet);
        assert_true(v.verified && v.where == -1);
        for (int i = 0; i < data.count; i++) {
            double kept = feet[i];
            feet[i] = feet[(i + 13) % data.count];
            v = cagd_stationary_nearest(&data, &curve, feet);
            assert_true(v.refuted && !v.verified && v.where == i);
            feet[i] = kept;
        }
    }
    /* A segment of length 2^20 along one axis, beside which a point is at the distance 3: with a foot by 2^-13 away from its own it is farther by
     * 2^-26/6 or so, which is less than 2^-44 of the length. */
    static const double line[] = {0, 0, 1, 1};
    for (int dim = 2; dim <= 3; dim++)
        for (int along = 0; along < dim; along++)
            for (int off = 0; off < 3; off++) {
                memcpy(knots, line, sizeof line);
                memset(control, 0, sizeof control), memset(points, 0, sizeof points);
                control[dim + along] = 0x1p20;
                curve = (cagd_spline){1, 2, dim, knots, control, NULL};
                data = (cagd_fit_data){3, dim, points, NULL};
                for (int i = 0; i < 3; i++) {
                    feet[i] = (i + 1) / 4.0;
                    points[i * dim + along] = feet[i] * 0x1p20;
                    points[i * dim + (along + 1) % dim] = 3;
                }
                feet[off] += 0x1p-33;
                cagd_nearest_verdict v = cagd_stationary_nearest(&data, &curve, feet);
                assert_true(v.verified && v.excess >= 0x1p-26 / 6 * (1 - 0x1p-20) && v.excess <= 0x1p-24);
                feet[off] += 0x1p-28;
                v = cagd_stationary_nearest(&data, &curve, feet);
                assert_true(v.refuted && v.where == off);
            }
}

/* A box in which the loss of Huber is bent has the derivatives of either side: those of squares, and those of the loss where it grows as the
 * distance. */
static void where_the_loss_of_Huber_is_bent(void **state)
{
    (void)state;
    static const double none[3] = {0}, box[3] = {0x1p-12, 0x1p-12, 0x1p-12};
    double g[2][3], H[2][9], one_g[2][3], one_H[2][9];
    int where;
    circle(0);
    data.count = 1;
    points[0] = 1.0625 * 33, points[1] = 1.0625 * 56, feet[0] = 56 / 98.0; /* at the distance 65/16 */
    problem.loss = CAGD_FIT_HUBER, problem.loss_scale = 65 / 16.0;
    assert_true(cagd_stationary_enclosures(&problem, box, g[0], g[1], H[0], H[1], &where));
    for (int side = 0; side < 2; side++) {
        problem.loss_scale = 65 / 16.0 + (side ? 0x1p-20 : -0x1p-20);
        assert_true(cagd_stationary_enclosures(&problem, none, one_g[0], one_g[1], one_H[0], one_H[1], &where));
        for (int m = 0; m < 9; m++)
            assert_true(H[0][m] <= one_H[0][m] + 0x1p-10 && one_H[1][m] - 0x1p-10 <= H[1][m]);
        for (int a = 0; a < 3; a++)
            assert_true(g[0][a] <= one_g[0][a] + 0x1p-10 && one_g[1][a] - 0x1p-10 <= g[1][a]);
        problem.loss = CAGD_FIT_SQUARES;
        if (side == 1) /* there it is that of squares */
            for (int m = 0; m < 9; m++) {
                double low[3], high[3], H_low[9], H_high[9];
                assert_true(cagd_stationary_enclosures(&problem, none, low, high, H_low, H_high, &where));
                assert_true(fabs(H_low[m] - one_H[0][m]) < 0x1p-30);
            }
        problem.loss = CAGD_FIT_HUBER;
    }
}

static void many_points_take_seconds(void **state)
{
    (void)state;
    circle(0);
    data.count = MOST;
    for (int i = 0; i < MOST; i++) {
        double t = (i / 2 + 1) / (MOST / 2 + 2.0), factor = i % 2 == 0 ? 1.0625 : 0.9375;
        points[2 * i] = factor * 65 * (1 - t * t) / (1 + t * t);
        points[2 * i + 1] = factor * 65 * 2 * t / (1 + t * t);
        feet[i] = t;
    }
    cagd_stationary_verdict v = cagd_stationary_check(&problem);
    assert_true(v.verified && v.minimum && v.weight_radius < 0x1p-45);
}

/* Points of the circle moved in and out have their feet there, and the centre, from which all points are as far, is left undecided; any other foot is refused as soon as it
 * is farther from the point than its place says. */
static void the_nearest_points_of_a_circle(void **state)
{
    (void)state;
    for (int pairs = 0; pairs < 2; pairs++) {
        circle(pairs);
        cagd_nearest_verdict v = cagd_stationary_nearest(&data, &curve, feet);
        assert_true(v.verified && !v.refuted && v.where == -1 && v.reason == NULL && v.excess <= 65 * 0x1p-44);
        for (int i = 0; i < data.count; i += 3) {
            double good = feet[i];
            for (int side = -1; side <= 1; side += 2) {
                feet[i] = good + side * 0x1p-12;
                v = cagd_stationary_nearest(&data, &curve, feet);
                assert_true(!v.verified && v.refuted && v.where == i && v.reason != NULL);
                feet[i] = good + side * 0x1p-46; /* farther by less than what is allowed */
                assert_true(cagd_stationary_nearest(&data, &curve, feet).verified || !pairs);
            }
            feet[i] = good < 0.5 ? 1 : 0;
            assert_true(cagd_stationary_nearest(&data, &curve, feet).refuted);
            feet[i] = 2;
            v = cagd_stationary_nearest(&data, &curve, feet);
            assert_true(!v.verified && !v.refuted && v.where == i);
            feet[i] = good;
        }
    }
    data.count = 1;
    points[0] = points[1] = 0;
    feet[0] = 0.375;
    cagd_nearest_verdict v = cagd_stationary_nearest(&data, &curve, feet);
    assert_true(!v.verified && !v.refuted && v.where == 0 && v.reason != NULL);
}

/* What is allowed is a share of the widest side of the box of all points and of the curve: not of how far away they are, nor of the
 * points alone. */
static void how_much_farther_a_foot_may_be(void **state)
{
    (void)state;
    circle(1);
    data.count = 1;
    assert_true(cagd_stationary_nearest(&data, &curve, feet).verified);
    feet[0] += 0x1p-40; /* farther by about 2^-70 */
    assert_true(cagd_stationary_nearest(&data, &curve, feet).verified);
    circle(0);
    for (int i = 0; i < data.count; i++)
        points[2 * i] += 0x1p20;
    for (int i = 0; i < curve.count; i++)
        control[2 * i] += 0x1p20;
    assert_true(cagd_stationary_nearest(&data, &curve, feet).verified);
    feet[2] += 0x1p-40;
    cagd_nearest_verdict v = cagd_stationary_nearest(&data, &curve, feet);
    assert_true(v.refuted && v.where == 2);
}

/* Knots 0, 1, ..., 6: the curve begins in (P0 + P1)/2 and ends in (P2 + P3)/2.  A point at P0 has its foot at the beginning, and pulls:
 * the gradient for P1 is (P1 - P0)/4. */
static void curves_that_do_not_begin_in_their_first_point(void **state)
{
    (void)state;
    static const double P[] = {0, 0, 2, 1, 5, 1, 8, -3}, none[2] = {0, 0};
    for (int i = 0; i < 7; i++)
        knots[i] = i;
    memcpy(control, P, sizeof P);
    curve = (cagd_spline){2, 4, 2, knots, control, NULL};
    data = (cagd_fit_data){1, 2, points, NULL};
    points[0] = P[0], points[1] = P[1], feet[0] = 2;
    unknown[0] = (cagd_fit_unknown){0, 1, 0}, unknown[1] = (cagd_fit_unknown){0, 1, 1};
    problem =
        (cagd_stationary_problem){.data = &data, .curve = &curve, .feet = feet, .unknowns = 2, .unknown = unknown};
    double low[2], high[2], H[4], H_above[4];
    int where;
    assert_true(cagd_stationary_enclosures(&problem, none, low, high, H, H_above, &where));
    assert_true(low[0] <= 0.5 && 0.5 <= high[0] && low[1] <= 0.25 && 0.25 <= high[1] && high[0] - low[0] < 0x1p-60);
    points[0] = 6.5 + 9, points[1] = -1 - 12, feet[0] = 4;
    assert_true(cagd_stationary_nearest(&data, &curve, feet).verified);
    feet[0] = 3.75;
    assert_true(cagd_stationary_nearest(&data, &curve, feet).refuted);
}

/* The nearest point of a polygon is its corner: there the foot has no derivative, and the check says so. */
static void a_foot_at_a_corner_is_refused(void **state)
{
    (void)state;
    static const double k[] = {0, 0, 0.5, 1, 1}, P[] = {0, 0, 1, 1, 2, 0}, Q[] = {1, 5, 0.25, 0.5, 1.75, 0.5};
    memcpy(knots, k, sizeof k);
    memcpy(control, P, sizeof P);
    memcpy(points, Q, sizeof Q);
    curve = (cagd_spline){1, 3, 2, knots, control, NULL};
    data = (cagd_fit_data){3, 2, points, NULL};
    feet[0] = 0.5, feet[1] = 0.1875, feet[2] = 0.8125;
    unknown[0] = (cagd_fit_unknown){0, 1, 0}, unknown[1] = (cagd_fit_unknown){0, 1, 1};
    problem =
        (cagd_stationary_problem){.data = &data, .curve = &curve, .feet = feet, .unknowns = 2, .unknown = unknown};
    cagd_stationary_verdict v = cagd_stationary_check(&problem);
    assert_true(!v.verified && v.where == 0);
    assert_non_null(strstr(v.reason, "corner"));
}

/* A polygon with corners, and a curve that crosses itself: the nearest point may be a corner, an end, or on the other branch. */
static void the_nearest_points_at_corners_and_crossings(void **state)
{
    static const double corner[] = {0, 0, 0.5, 1, 1}, angle[] = {0, 0, 1, 1, 2, 0};
    static const double knots_of_loop[] = {0, 0, 0, 0, 1, 1, 1, 1}, loop[] = {0, 0, 4, 3, -1, 3, 3, 0};
    (void)state;
    curve = (cagd_spline){1, 3, 2, corner, angle, NULL};
    data = (cagd_fit_data){3, 2, points, NULL};
    static const double Q[] = {1, 5, -3, -1, 1, 0}, at[] = {0.5, 0, 0.25};
    memcpy(points, Q, sizeof Q);
    memcpy(feet, at, sizeof at);
    assert_true(cagd_stationary_nearest(&data, &curve, feet).verified);
    feet[2] = 0.75; /* as near */
    assert_true(cagd_stationary_nearest(&data, &curve, feet).verified);
    feet[0] = 1;
    assert_true(cagd_stationary_nearest(&data, &curve, feet).refuted);
    /* By symmetry both branches are as near to a point of the axis x = 3/2, and elsewhere one of them is nearer. */
    curve = (cagd_spline){3, 4, 2, knots_of_loop, loop, NULL};
    data.count = 1;
    for (int side = -1; side <= 1; side++) {
        double t = 0.125, left = 1 - t;
        double C[2] = {3 * t * left * left * 4 - 3 * t * t * left + 3 * t * t * t, 9 * t * left};
        points[0] = C[0] + side * 0x1p-20;
        points[1] = C[1];
        feet[0] = t;
        cagd_nearest_verdict v = cagd_stationary_nearest(&data, &curve, feet);
        assert_true(side == 0 ? v.verified : v.refuted);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_circle_is_found_at_its_place),
        cmocka_unit_test(what_is_no_minimum_is_not_called_one),
        cmocka_unit_test(one_direction_that_falls_is_enough),
        cmocka_unit_test(a_reported_circle_that_is_a_little_off_has_the_true_one_in_its_radius),
        cmocka_unit_test(a_place_between_two_numbers),
        cmocka_unit_test(one_unknown_is_enough),
        cmocka_unit_test(a_fit_is_checked_about_its_origin),
        cmocka_unit_test(a_circle_elsewhere_is_found_from_farther_away),
        cmocka_unit_test(what_is_not_near_is_refused),
        cmocka_unit_test(wrong_feet_are_refused),
        cmocka_unit_test(feet_at_the_ends),
        cmocka_unit_test(a_foot_at_the_end_or_inside),
        cmocka_unit_test(free_directions_are_left_out),
        cmocka_unit_test(the_enclosures_hold_the_differences),
        cmocka_unit_test(derivatives_are_limits_of_differences),
        cmocka_unit_test(what_a_bound_forbids_alone),
        cmocka_unit_test(what_a_bound_forbids_beside_free_points),
        cmocka_unit_test(several_bounds_at_once),
        cmocka_unit_test(the_nearest_points_of_several_spans),
        cmocka_unit_test(where_the_loss_of_Huber_is_bent),

        cmocka_unit_test(a_fit_without_some_points_at_its_ends),
        cmocka_unit_test(what_a_fit_was_asked_for),
        cmocka_unit_test(closed_curves_are_checked),
        cmocka_unit_test(feet_at_knots),
        cmocka_unit_test(points_at_the_ends),
        cmocka_unit_test(the_weakest_of_several_bounds),

        cmocka_unit_test(how_much_farther_a_foot_may_be),
        cmocka_unit_test(curves_that_do_not_begin_in_their_first_point),
        cmocka_unit_test(a_foot_at_a_corner_is_refused),
        cmocka_unit_test(the_nearest_points_of_a_circle),
        cmocka_unit_test(the_nearest_points_at_corners_and_crossings),
        cmocka_unit_test(many_points_take_seconds)};
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    cagd_thread_end();
    return failed;
}
