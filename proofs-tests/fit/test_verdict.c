/* test_verdict.c -- whether a fit is called good: true models are, a nose that they pass by is not, and structure counts unless all distances are
 * beneath what the points are given to; of few points as of many, and deviations that are given wrongly are told. */
#include "core/fit/beneath.h"
#include "core/fit/cagd_fit.h"
#include "proofs-tests/fit/noise.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { POINTS = 200, DRAWS = 200, NOSES = 100 };
static const double PI = 3.14159265358979323846, NOISE = 0.02;
static double Q[2 * POINTS], sigma[POINTS];

static int failed;
static void ask(int holds, const char *what)
{
    if (!holds)
        printf("NOT so: %s\n", what);
    failed += !holds;
}

/* ---- by chance, and not by chance -------------------------------------------------------------------------- */

/* A circle of radius 1 with a nose: the radius grows by `height` e^(-50 (1 - cos a)) at the angle a from its tip. */
static void on_ring(double height, double u, double q[2])
{
    const double from_tip = 2 * PI * (u - 0.32), radius = 1 + height * exp(-50 * (1 - cos(from_tip)));
    q[0] = radius * cos(2 * PI * u), q[1] = radius * sin(2 * PI * u);
}

static void on_parabola(double u, double q[2]) { q[0] = u, q[1] = u * (1 - u); }

/* How far the curve is from q. */
static double distance_from(const cagd_spline *c, const double q[2])
{
    enum { PLACES = 2000 };
    const double a = c->knots[c->degree], b = c->knots[c->count];
    double nearest = HUGE_VAL, x[2];
    for (int i = 0; i <= PLACES; i++)
        if (cagd_spline_point(c, i < PLACES ? a + (b - a) * i / PLACES : b, i < PLACES ? CAGD_RIGHT : CAGD_LEFT, x) ==
            CAGD_OK)
            nearest = fmin(nearest, hypot(x[0] - q[0], x[1] - q[1]));
    return nearest;
}

/* How many of the draws of a ring (1) or a parabola (0) are not good or, of a nose, come within one deviation of its tip. */
static int count_seen(int ring, double height, int draws)
{
    int seen = 0;
    double tip[2];
    on_ring(height, 0.32, tip);
    for (int d = 0; d < draws; d++) {
        state = 1000003u * (uint64_t)(d + 1) + 17;
        for (int i = 0; i < POINTS; i++) {
            if (ring)
                on_ring(height, (double)i / POINTS, Q + 2 * i);
            else
                on_parabola(i / (POINTS - 1.0), Q + 2 * i);
            for (int c = 0; c < 2; c++)
                Q[2 * i + c] += NOISE * normal();
        }
        const cagd_fit_data data = {POINTS, 2, Q, NULL};
        const cagd_fit_choices choices = cagd_fit_choices_all();
        cagd_fit_options options = cagd_fit_defaults();
        cagd_fit_result *fit;
        cagd_fit_quality quality;
        options.without_intervals = 1;
        if (cagd_fit_choose(&data, &options, &choices, &fit, NULL) != CAGD_OK ||
            cagd_fit_quality_of(&data, &options, fit, &quality) != CAGD_OK) {
            ask(0, "a curve is chosen");
            return -1;
        }
        seen += !cagd_fit_is_minimum(fit) || quality.problems != 0 ||
                (height > 0 && distance_from(&fit->curve, tip) < NOISE);
        cagd_fit_free(fit);
    }
    return seen;
}

static void test_chance(void)
{
    const int circles = count_seen(1, 0, DRAWS), parabolas = count_seen(0, 0, DRAWS),
              noses = count_seen(1, 2 * NOISE, NOSES);
    printf("of %d circles %d are not good, of %d parabolas %d; of %d noses of two deviations, a twentieth of the way "
           "around, %d are seen\n",
           DRAWS, circles, DRAWS, parabolas, NOSES, noses);
    ask(20 * circles <= DRAWS && 20 * parabolas <= DRAWS, "true models are called not good one time in twenty at most");
    ask(noses >= 35, "a nose is seen by more than one of three");
}

/* Points along a straight line, as many as a conic of its own takes errors for bends of: how many are told to be one. */
static void test_lines(void)
{
    enum { LINES = 100, OF_LINE = 40 };
    int straight = 0, good = 0;
    for (int d = 0; d < LINES; d++) {
        state = 1000003u * (uint64_t)(d + 1) + 29;
        for (int i = 0; i < OF_LINE; i++) {
            const double x = 50.0 * i / (OF_LINE - 1);
            Q[2 * i] = x + 0.05 * normal();
            Q[2 * i + 1] = 3 + 0.37 * x + 0.05 * normal();
        }
        const cagd_fit_data data = {OF_LINE, 2, Q, NULL};
        const cagd_fit_choices choices = cagd_fit_choices_all();
        cagd_fit_options options = cagd_fit_defaults();
        cagd_fit_result *fit;
        cagd_fit_quality quality = {.problems = ~0};
        options.without_intervals = 1;
        if (cagd_fit_choose(&data, &options, &choices, &fit, NULL) != CAGD_OK ||
            cagd_fit_quality_of(&data, &options, fit, &quality) != CAGD_OK) {
            ask(0, "a curve is chosen");
            return;
        }
        straight += fit->curve.degree == 1;
        good += quality.problems == 0;
        cagd_fit_free(fit);
    }
    printf("of %d straight lines %d are told to be one, %d are good\n", LINES, straight, good);
    ask(straight >= 98 && good >= 95, "a straight line is told to be one");
}

/* ---- a detour between two neighbours ----------------------------------------------------------------------- */

/* A spline of twelve points (j, 0) two of which, (6 + across, up) and (5 - across, up), make it turn back.  Its ends are fitted to places of it: to all
 * that are left when those between `from` and `to` are taken out. */
static int has_detour(double across, double up, double from, double to)
{
    enum { COUNT = 12, DEGREE = 3, PLACES = 60 };
    double U[COUNT + DEGREE + 1], P[2 * COUNT];
    int n = 0;
    for (int j = 0; j < COUNT + DEGREE + 1; j++)
        U[j] = fmin(fmax(0, j - DEGREE), COUNT - DEGREE);
    for (int j = 0; j < COUNT; j++)
        P[2 * j] = j == 5 ? 6 + across : j == 6 ? 5 - across : j, P[2 * j + 1] = j == 5 || j == 6 ? up : 0;
    const cagd_spline curve = {DEGREE, COUNT, 2, U, P, NULL};
    for (int i = 0; i <= PLACES; i++) {
        const double t = (double)i / PLACES * (COUNT - DEGREE);
        if (!(t > from && t < to) &&
            cagd_spline_point(&curve, t, i < PLACES ? CAGD_RIGHT : CAGD_LEFT, Q + 2 * n) == CAGD_OK)
            n++;
    }
    const cagd_fit_data data = {n, 2, Q, NULL};
    cagd_fit_options options = cagd_fit_defaults();
    cagd_fit_result *fit;
    cagd_fit_quality quality = {0};
    options.initial = &curve;
    options.free = CAGD_FIT_END_POINTS;
    options.without_intervals = 1;
    ask(cagd_fit(&data, &options, &fit, NULL) == CAGD_OK &&
            cagd_fit_quality_of(&data, &options, fit, &quality) == CAGD_OK,
        "a fit");
    cagd_fit_free(fit);
    ask(quality.length_ratio < CAGD_FIT_LONGEST_RATIO, "the whole is no longer than its points");
    ask((quality.detour > 0) == ((quality.problems & CAGD_FIT_EXCURSIONS) != 0), "a detour is an excursion");
    return quality.detour > 0;
}

static void test_detour(void)
{
    ask(has_detour(0.2, 0.5, 3.9, 5.1), "a curve that folds back between two neighbours makes a detour");
    ask(!has_detour(0.2, 0.5, 9, 9), "none where the points fold back, too");
    ask(!has_detour(-0.5, 0.5, 3.9, 5.1), "none where it does not fold back");
}

/* ---- beneath what the points are given to ------------------------------------------------------------------ */

/* What is off by off sin 40u; of one side, 1 or -1, by narrow peaks on it alone. */
static double off_at(double u, double off, int side)
{
    return side == 0 ? off * sin(40 * u) : side * off * pow(fmax(0, sin(40 * u)), 9);
}

/* The conic through (u, height u (1-u) + off_at(u)), rounded to `unit` unless that is 0, with deviations unless these are 0. */
static cagd_fit_quality quality_of_sides(double height, double off, double unit, double deviation, int side)
{
    cagd_fit_quality quality = {.problems = ~0};
    cagd_fit_result *fit;
    for (int i = 0; i < POINTS; i++) {
        const double u = i / (POINTS - 1.0), y = height * u * (1 - u) + off_at(u, off, side);
        Q[2 * i] = unit > 0 ? rint(u / unit) * unit : u;
        Q[2 * i + 1] = unit > 0 ? rint(y / unit) * unit : y;
        sigma[i] = deviation;
    }
    const cagd_fit_data data = {POINTS, 2, Q, deviation > 0 ? sigma : NULL};
    cagd_fit_options options = cagd_fit_defaults();
    options.free &= ~CAGD_FIT_WEIGHTS;
    options.without_intervals = 1;
    ask(cagd_fit(&data, &options, &fit, NULL) == CAGD_OK &&
            cagd_fit_quality_of(&data, &options, fit, &quality) == CAGD_OK,
        "a fit");
    ask(quality.runs.probability < 0.01 || quality.runs.local_probability < 0.01, "there is structure");
    cagd_fit_free(fit);
    return quality;
}

static cagd_fit_quality quality_of(double height, double off, double unit, double deviation)
{
    return quality_of_sides(height, off, unit, deviation, 0);
}

static int is_told(cagd_fit_quality q, cagd_fit_beneath beneath)
{
    return q.beneath == beneath && !(q.problems & CAGD_FIT_STRUCTURE);
}
static int counts(cagd_fit_quality q)
{
    return q.beneath == CAGD_FIT_BENEATH_NOTHING && (q.problems & CAGD_FIT_STRUCTURE) != 0;
}

static void test_beneath(void)
{
    /* y = h u (1-u) is h/4 high over a unit; its main axis is at the mean height h/6, from which the ends are farthest */
    const double high = 1, low = 0.05, extent = FIT_OF_EXTENT * hypot(1, high / 4), width = FIT_OF_WIDTH * 2 * low / 6;
    ask(is_told(quality_of(high, extent / 100, 0, 0), CAGD_FIT_BENEATH_SIZE),
        "structure far beneath the share of the extent is told");
    ask(is_told(quality_of(high, 0.8 * extent, 0, 0), CAGD_FIT_BENEATH_SIZE), "so is one of four fifths of that share");
    ask(counts(quality_of(high, 2 * extent, 0, 0)), "twice that share counts");
    ask(is_told(quality_of(low, 0.3 * width, 0, 0), CAGD_FIT_BENEATH_SIZE),
        "of points that are nearly straight a third of the share of their width is told");
    ask(counts(quality_of(low, 3 * width, 0, 0)), "three times that share counts, beneath the share of the extent");
    ask(3 * width < FIT_OF_EXTENT, "which it is");
    ask(counts(quality_of(0, 1e-6, 0, 0)), "that of points along a straight line, which is all their form, counts");
    ask(is_told(quality_of(1, 0.001, 0, 0.0015), CAGD_FIT_BENEATH_DEVIATIONS),
        "structure within the given deviations is told");
    ask(counts(quality_of(1, 0.001, 0, 0.0005)), "beyond them it counts");
    for (int side = -1; side <= 1; side += 2) {
        ask(counts(quality_of_sides(1, 0.001, 0, 0.0005, side)), "so do points beyond them on one side alone");
        ask(is_told(quality_of_sides(1, 0.001, 0, 0.001, side), CAGD_FIT_BENEATH_DEVIATIONS),
            "which are told within them");
    }
    ask(counts(quality_of(1, 1e-7, 0, 1e-8)), "so it does where deviations are smaller than the size asks for");
    ask(is_told(quality_of(1, 0.0015, 0.01, 0), CAGD_FIT_BENEATH_DIGITS),
        "structure within the rounding of two decimal places is told");
    ask(counts(quality_of(1, 0.01, 0.01, 0)), "beyond it it counts");
}

/* ---- few points ---------------------------------------------------------------------------------------------- */

/* What is chosen for `count` points of a curve, with errors of `noise` and with deviations unless these are 0. */
static cagd_fit_quality choose_for(int count, void (*curve)(double u, double q[2]), int closed, double noise,
                                   double deviation, int draw, cagd_fit_result **fit)
{
    cagd_fit_quality quality = {.problems = ~0};
    const cagd_fit_choices choices = cagd_fit_choices_all();
    cagd_fit_options options = cagd_fit_defaults();
    state = 1000003u * (uint64_t)(draw + 1) + 29;
    for (int i = 0; i < count; i++) {
        curve(closed ? (double)i / count : i / (count - 1.0), Q + 2 * i);
        for (int c = 0; c < 2 && noise > 0; c++)
            Q[2 * i + c] += noise * normal();
        sigma[i] = deviation;
    }
    const cagd_fit_data data = {count, 2, Q, deviation > 0 ? sigma : NULL};
    options.without_intervals = 1;
    *fit = NULL;
    ask(cagd_fit_choose(&data, &options, &choices, fit, NULL) == CAGD_OK &&
            cagd_fit_quality_of(&data, &options, *fit, &quality) == CAGD_OK,
        "a curve is chosen");
    return quality;
}

static int is_spline(const cagd_fit_result *fit)
{
    return fit != NULL && !fit->found.ellipse.known && fit->curve.degree == 3;
}

static void on_egg(double u, double q[2])
{
    q[0] = 2 * cos(2 * PI * u) + 0.4 * cos(4 * PI * u), q[1] = 1.4 * sin(2 * PI * u) - 0.1 * sin(4 * PI * u);
}

static void on_cubic(double u, double q[2]) { q[0] = u, q[1] = u * (1 - u) + 0.1 * u * u * u; }
static void on_five(double u, double q[2])
{
    q[0] = 30 * u, q[1] = 0.05 * sin(12 * PI * u);
} /* five points a wave, of 31 */
static void on_circle(double u, double q[2]) { on_ring(0, u, q); }

/* Exact points, too few for the sides of neighbours to tell anything. */
static void test_few(void)
{
    cagd_fit_result *fit;
    for (int count = 20; count <= 25; count += 5) {
        cagd_fit_quality q = choose_for(count, on_egg, 1, 0, 0, 0, &fit);
        ask(is_spline(fit) && fit->rms < 0.02 && q.problems == 0, "an egg of few points is a spline, and no ellipse");
        cagd_fit_free(fit);
    }
    cagd_fit_quality q = choose_for(12, on_cubic, 0, 0, 0, 0, &fit);
    ask(is_spline(fit) && fit->rms < 1e-6 && q.problems == 0, "a cubic of twelve points is no conic");
    cagd_fit_free(fit);
    cagd_fit_options options = cagd_fit_defaults();
    options.degree = 1;
    options.free &= ~CAGD_FIT_WEIGHTS;
    for (int i = 0; i < 31; i++)
        on_five(i / 30.0, Q + 2 * i);
    const cagd_fit_data data = {31, 2, Q, NULL};
    ask(cagd_fit(&data, &options, &fit, NULL) == CAGD_OK && cagd_fit_quality_of(&data, &options, fit, &q) == CAGD_OK,
        "a line is fitted");
    ask(q.problems & CAGD_FIT_STRUCTURE && q.runs.lag == 5 && !(q.runs.probability < 0.01) &&
            !(q.runs.local_probability < 0.01),
        "a wave of five points is seen by what is five apart, though neighbours say nothing");
    cagd_fit_free(fit);
}

/* Of 25 points with noise the true model is good. */
static void test_few_by_chance(void)
{
    int circles = 0, parabolas = 0, splines = 0;
    for (int d = 0; d < DRAWS; d++) {
        cagd_fit_result *fit;
        circles += choose_for(25, on_circle, 1, NOISE, 0, d, &fit).problems != 0;
        splines += is_spline(fit);
        cagd_fit_free(fit);
        parabolas += choose_for(25, on_parabola, 0, NOISE / 4, 0, d, &fit).problems != 0;
        splines += is_spline(fit);
        cagd_fit_free(fit);
    }
    printf("of %d circles of 25 points %d are not good, of %d parabolas %d; %d are taken for splines\n", DRAWS, circles,
           DRAWS, parabolas, splines);
    ask(20 * circles <= DRAWS && 20 * parabolas <= DRAWS && 20 * splines <= 2 * DRAWS, "so are those of few points");
}

/* ---- given deviations ------------------------------------------------------------------------------------------ */

static void test_deviations(void)
{
    cagd_fit_result *fit;
    int alarms = 0;
    cagd_fit_quality q = choose_for(30, on_parabola, 0, NOISE, NOISE / 50, 0, &fit);
    ask(q.problems == CAGD_FIT_DEVIATIONS && fit->curve.degree <= 2,
        "deviations fifty times too small count, and ask for no spline");
    cagd_fit_free(fit);
    q = choose_for(30, on_parabola, 0, NOISE / 10, NOISE, 0, &fit);
    ask(q.problems == 0 && q.too_large, "deviations ten times too large are told");
    cagd_fit_free(fit);
    q = choose_for(25, on_egg, 1, 0.001, 0.001, 0, &fit);
    ask(is_spline(fit) && !(q.problems & CAGD_FIT_DEVIATIONS), "an egg with deviations is no ellipse");
    cagd_fit_free(fit);
    for (int d = 0; d < DRAWS; d++) {
        q = choose_for(30, on_parabola, 0, NOISE, NOISE, d, &fit);
        alarms += (q.problems & CAGD_FIT_DEVIATIONS) != 0 || q.too_large;
        cagd_fit_free(fit);
    }
    printf("of %d parabolas with their deviations %d are told that these are too small or too large\n", DRAWS, alarms);
    ask(50 * alarms <= DRAWS, "true deviations are called too small or too large one time in fifty at most");
}

int main(void)
{
    test_beneath();
    test_detour();
    test_lines();
    test_few();
    test_deviations();
    test_few_by_chance();
    test_chance();
    return failed > 0;
}
