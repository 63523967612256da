/* test_circle.c -- are measured arcs of circles told as such, with intervals that hold the truth, and arcs of ellipses not?
 *
 *     test_circle [DRAWS]        so many measurements of each kind, 400 unless given
 *
 * Arcs of 20 to 200 degrees, errors of 0.001 and 0.003 of the radius, 50 and 200 points, are fitted as cagd fit does without options.  A circle is
 * told of at least 9 in 10 of the arcs, within three standard deviations of
 * chance; of these the 95 % intervals of radius and centre hold the truth in 93 to 97 %, within as much.  Of ellipses whose axes the points tell apart it is told of at most 1 in 20, and so of a straight line.  F is what its
 * definition says. */
#include "core/fit/cagd_fit.h"
#include "proofs-tests/fit/noise.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST = 200 };

/* Points of an arc of the ellipse with semi-axes 1 and `minor`, of a line where that is 0, turned by 0.4 and moved; the arc begins at `from` degrees. */
typedef struct setting {
    int points;
    double sigma, from, sweep, minor;
} setting;

static const double PI = 3.14159265358979323846, centre[2] = {3, -1};

static void measure(const setting *s, double points[])
{
    for (int i = 0; i < s->points; i++) {
        const double a = (s->from + s->sweep * i / (s->points - 1)) * PI / 180, x = cos(a), y = s->minor * sin(a);
        points[2 * i] = centre[0] + cos(0.4) * x - sin(0.4) * y + s->sigma * normal();
        points[2 * i + 1] = centre[1] + sin(0.4) * x + cos(0.4) * y + s->sigma * normal();
    }
}

/* What is told of the points: 0 no circle, 1 a conic that may be one, 2 an arc of more than half a turn. */
static int circle_of(const cagd_fit_data *data, cagd_fit_number of[3])
{
    cagd_fit_options o = cagd_fit_defaults();
    cagd_fit_choices all = cagd_fit_choices_all();
    cagd_fit_result *r = NULL;
    cagd_fit_circle circle = {0};
    int found = 0;
    if (cagd_fit_choose(data, &o, &all, &r, NULL) == CAGD_OK && cagd_fit_circle_of(data, &o, r, &circle) == CAGD_OK) {
        const cagd_fit_ellipse *e = &r->found.ellipse;
        found = circle.known ? 1 : e->known && e->circle ? 2 : 0;
        of[0] = found == 1 ? circle.radius : e->radius;
        for (int c = 0; c < 2; c++)
            of[1 + c] = found == 1 ? circle.centre[c] : e->circle_centre[c];
    }
    cagd_fit_free(r);
    return found;
}

/* Of so many draws a circle is told of `told`; each of its numbers has `with` intervals, of which so many are right. */
typedef struct tally {
    int told, with[3], right[3];
} tally;

static tally count(const setting *s, int draws)
{
    static double points[2 * MOST];
    const double truth[3] = {1, centre[0], centre[1]};
    tally t = {0};
    for (int draw = 0; draw < draws; draw++) {
        const cagd_fit_data data = {s->points, 2, points, NULL};
        cagd_fit_number of[3];
        measure(s, points);
        if (!circle_of(&data, of))
            continue;
        t.told++;
        for (int k = 0; k < 3; k++)
            if (isfinite(of[k].low) && isfinite(of[k].high))
                t.with[k]++, t.right[k] += of[k].low <= truth[k] && truth[k] <= of[k].high;
    }
    return t;
}

static int circles(int draws)
{
    static const double sweep[] = {20, 30, 60, 90, 120, 200}, sigma[] = {0.001, 0.003};
    int bad = 0;
    for (int k = 0; k < 24; k++) {
        const setting s = {k / 2 % 2 ? 200 : 50, sigma[k % 2], 10, sweep[k / 4], 1};
        const tally t = count(&s, draws);
        printf("%3.0f degrees, %.3f, %3d points: a circle %d of %d", s.sweep, s.sigma, s.points, t.told, draws);
        bad += t.told < 0.9 * draws - 3 * sqrt(0.9 * 0.1 * draws);
        for (int q = 0; q < 3; q++) {
            const double share = (double)t.right[q] / t.with[q], chance = 3 * sqrt(0.95 * 0.05 / t.with[q]);
            const int off = 10 * t.with[q] < 9 * t.told || share < 0.93 - chance || share > 0.97 + chance;
            printf(", %.1f %% of %d%s", 100 * share, t.with[q], off ? " (!)" : "");
            bad += off;
        }
        puts("");
        fflush(stdout);
    }
    return bad;
}

static int others(int draws)
{
    static const setting all[] = {{50, 0.001, 10, 90, 0.8},  {50, 0.001, 10, 120, 0.9},  {200, 0.001, 45, 60, 0.7},
                                  {50, 0.003, 10, 120, 0.8}, {200, 0.003, 0, 200, 0.97}, {50, 0.001, 30, 120, 0},
                                  {200, 0.003, 60, 60, 0}};
    int bad = 0;
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) {
        const setting *s = &all[k];
        const tally t = count(s, draws);
        printf("%3.0f degrees of an ellipse, %.2f, %.3f, %3d points: a circle %d of %d\n", s->sweep, s->minor, s->sigma,
               s->points, t.told, draws);
        fflush(stdout);
        bad += 20 * t.told > draws;
    }
    return bad;
}

/* F, its probability and the distances by their definitions, from radius and centre; with deviations that differ and without. */
static int by_definition(void)
{
    const setting s = {60, 0.002, 20, 80, 1};
    static double points[2 * MOST], sigma[MOST];
    int bad = 0;
    for (int weighted = 0; weighted < 2; weighted++) {
        measure(&s, points);
        for (int i = 0; i < s.points; i++)
            sigma[i] = i % 3 == 0 ? 0.004 : 0.002;
        const cagd_fit_data data = {s.points, 2, points, weighted ? sigma : NULL};
        const cagd_fit_options o = cagd_fit_defaults();
        cagd_fit_result *r = NULL;
        cagd_fit_circle c = {0};
        if (cagd_fit(&data, &o, &r, NULL) != CAGD_OK || cagd_fit_circle_of(&data, &o, r, &c) != CAGD_OK || !c.known)
            return 1;
        double round = 0, conic = 0, squares = 0;
        for (int i = 0; i < s.points; i++) {
            const double off =
                hypot(points[2 * i] - c.centre[0].value, points[2 * i + 1] - c.centre[1].value) - c.radius.value;
            const double weight = weighted ? 1 / (sigma[i] * sigma[i]) : 1;
            round += weight * off * off, conic += weight * r->distances[i] * r->distances[i], squares += off * off;
        }
        /* A distance is a difference of numbers of the size of the centre, in some ten operations; chi_squared is as exact, twice, for distances
         * of the size of their errors; and F is a difference of two, times `freedom`. */
        const int freedom = s.points - 5;
        const double of_distance = 10 * DBL_EPSILON * hypot(centre[0], centre[1]), of_sum = 2 * of_distance / s.sigma;
        const double f = (round - conic) / 2 / (conic / freedom), none = pow(1 + 2 * f / freedom, -freedom / 2.0);
        const double of_f = freedom * of_sum * (1 + f);
        bad += c.freedom != freedom || !(fabs(c.ratio - f) <= of_f) || !(fabs(c.probability - none) <= of_f) ||
               !(fabs(c.rms - sqrt(squares / s.points)) <= of_distance);
        printf("F by its definition %.9f, told %.9f; chance %.9f, told %.9f\n", f, c.ratio, none, c.probability);
        cagd_fit_free(r);
    }
    return bad;
}

int main(int argc, char **argv)
{
    const int draws = argc > 1 ? atoi(argv[1]) : 400;
    state = argc > 2 ? strtoull(argv[2], NULL, 10) : 20261129;
    int bad = circles(draws);
    bad += others((draws + 1) / 2);
    bad += by_definition();
    printf("%d numbers are not as they should be\n", bad);
    return bad > 0;
}
