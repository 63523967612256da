/* test_coverage.c -- do the 95 % intervals of the fit cover the truth 95 times in a hundred (置信区间的覆盖率)?
 *
 * Where the points hardly determine the curve, the intervals are those by the profile of the cost, and where none is printed a draw
 * does not count.  Ends are given, or measured as the other points are; points that are given ends count for nothing.  For each of the settings below a known curve is measured DRAWS times, each time with other noise, and fitted.  For every
 * unknown and every invariant two things are counted: how often its interval holds the truth, and the mean of z^2,
 * z = (estimate - truth)/standard error.
 *
 * What chance allows.  The share covered among n draws has the standard deviation sqrt(0.95 0.05/n): 0.34 % for n = 4096, so that 93 to
 * 97 % are six of them.  z^2 is the square of a normal number or, with unknown standard deviation, of Student's t: its mean is d/(d-2),
 * its variance 2 d^2 (d-1)/((d-2)^2 (d-4)) (2 and 1 as d grows), and the mean over the draws may differ by five standard deviations,
 * which happens by chance once in two million times.  The noise is small against the curvature of the curves,
 * so that what is not linear stays below that; draws are seeded and the outcome is always the same.
 *
 *     test_coverage               the test
 *     test_coverage --factor F    with all standard errors multiplied by F: a control
 *     test_coverage --quantile Q  with Q for the quantile: another control
 *
 * Exit status 0: all settings are within their bounds. */
#include "core/fit/cagd_fit.h"
#include "proofs-tests/fit/noise.h"
#include "proofs-tests/fit/options.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DRAWS = 4096, HARD = 1024, FEW = 512, MOST_POINTS = 32, MOST_UNKNOWNS = 16, FAILURES = 0 };

/* The points lie between the ends, begin and end there and are measured there as elsewhere, or are the given ends there, without noise. */
enum { BETWEEN, MEASURED, EXACT };

typedef struct setting {
    const char *name;
    int dim, degree, count, known_sigma;
    double sigma; /* of the first point; the others' go up to twice that where they are known */
    double points[12], weights[6];
    int ends;
    int draws; /* HARD, FEW: the cost is far from quadratic, and most intervals are by its profile */
} setting;

static const setting settings[] = {
    {"plane, known", 2, 2, 14, 1, 0.0005, {0, 0, 1, 2, 3, 0.5}, {1, 0.7, 1}, BETWEEN, DRAWS},
    {"plane, unknown", 2, 2, 12, 0, 0.0005, {0, 0, 1, 2, 3, 0.5}, {1, 1.6, 1}, BETWEEN, DRAWS},
    {"space, known", 3, 2, 10, 1, 0.001, {0, 0, 0, 1, 2, 1, 3, 0.5, -1}, {1, 1.3, 1}, BETWEEN, DRAWS},
    {"space, unknown", 3, 3, 12, 0, 0.001, {0, 0, 0, 1, 2, 0, 2, -1, 2, 3, 1, 3}, {1, 1.5, 0.8, 1}, BETWEEN, DRAWS},
    {"parabola, ends", 2, 2, 24, 0, 0.0005, {0, 0, 0.5, 0.5, 1, 0}, {1, 1, 1}, MEASURED, DRAWS},
    {"conic, ends", 2, 2, 14, 1, 0.0005, {0, 0, 1, 2, 3, 0.5}, {1, 1.6, 1}, MEASURED, DRAWS},
    {"cubic, ends", 2, 3, 20, 0, 0.0002, {0, 0, 1, 2, 2, -1, 3, 1}, {1, 1.5, 0.8, 1}, MEASURED, HARD},
    {"noisy, ends", 2, 2, 12, 0, 0.03, {0, 0, 1, 2, 3, 0.5}, {1, 1.6, 1}, MEASURED, HARD},
    {"quartic, ends", 2, 4, 30, 0, 0.00002, {0, 0, 1, 2, 2, -1, 3, 1, 4, 3}, {1, 1.5, 0.8, 1.3, 1}, MEASURED, FEW},
    {"quintic, ends",
     2,
     5,
     32,
     0,
     0.000002,
     {0, 0, 1, 2, 2, -1, 3, 1, 4, 3, 5, -1},
     {1, 1.5, 0.8, 1.3, 0.7, 1},
     MEASURED,
     FEW},
    {"plane, exact ends", 2, 2, 10, 0, 0.0005, {0, 0, 1, 2, 3, 0.5}, {1, 1.6, 1}, EXACT, DRAWS},
    {"space, exact ends", 3, 3, 9, 0, 0.0005, {0, 0, 0, 1, 2, 0, 2, -1, 2, 3, 1, 3}, {1, 1.5, 0.8, 1}, EXACT, DRAWS},
    {"space, ends", 3, 3, 16, 1, 0.0002, {0, 0, 0, 1, 2, 0, 2, -1, 2, 3, 1, 3}, {1, 1.5, 0.8, 1}, MEASURED, DRAWS},
};

typedef struct tally {
    int draws, covered, linear; /* linear: intervals that are value +- quantile * error */
    double squares;
} tally;

/* Intervals as they are printed; where none is, the draw does not count. */
static void count_interval(tally *t, cagd_fit_estimate e, double truth)
{
    if (!isfinite(e.error))
        return;
    t->draws++, t->covered += e.low <= truth && truth <= e.high, t->linear += e.by == CAGD_FIT_INTERVAL_LINEAR;
}

static void count_in(tally *t, double estimate, double truth, double error, double quantile)
{
    double z = (estimate - truth) / error;
    t->draws++, t->linear++, t->covered += fabs(z) <= quantile, t->squares += z * z;
}

static int judge(const char *setting_name, const char *what, const tally *t, int draws, int freedom)
{
    double share = (double)t->covered / t->draws, mean = t->squares / t->draws, d = freedom;
    double expected = freedom > 0 ? d / (d - 2) : 1;
    double variance = freedom > 0 ? 2 * d * d * (d - 1) / ((d - 2) * (d - 2) * (d - 4)) : 2;
    double off = (mean - expected) / sqrt(variance / t->draws);
    int all_linear = t->linear == t->draws && t->squares > 0;
    int good = share >= 0.93 && share <= 0.97 && (!all_linear || fabs(off) <= 5) && t->draws > 0;
    if (!all_linear) {
        printf("%-15s %-14s %6.2f %% +- %.2f   %5.1f %% by profile, %5.1f %% none  %s\n", setting_name, what,
               100 * share, 100 * sqrt(0.95 * 0.05 / t->draws), 100.0 * (t->draws - t->linear) / draws,
               100.0 * (draws - t->draws) / draws, good ? "ok" : "FAILS");
        return good;
    }
    printf("%-15s %-14s %6.2f %% +- %.2f   mean of z^2 %6.3f, expected %5.3f: %+5.1f standard deviations  %s\n",
           setting_name, what, 100 * share, 100 * sqrt(0.95 * 0.05 / t->draws), mean, expected, off,
           good ? "ok" : "FAILS");
    return good;
}

/* The number of settings' quantities that are out of bounds, and of fits that did not converge. */
static int run(const setting *s, double factor, double quantile)
{
    double measured[3 * MOST_POINTS], sigma[MOST_POINTS], exact[3 * MOST_POINTS], start[12], knots[12];
    cagd_fit_data data = {s->count, s->dim, measured, s->known_sigma ? sigma : NULL};
    cagd_fit_options options = s->ends == MEASURED ? cagd_fit_defaults() : options_with_exact_ends();
    int n = s->degree + 1, failures = 0, unknowns = 0, freedom = 0, bad = 0;
    tally unknown[MOST_UNKNOWNS], invariant[4];
    char names[MOST_UNKNOWNS][32];
    memset(unknown, 0, sizeof unknown), memset(invariant, 0, sizeof invariant);
    memcpy(start, s->points, sizeof start);
    for (int k = 0; k < 2 * n; k++)
        knots[k] = k >= n;
    double ones[6] = {1, 1, 1, 1, 1, 1};
    cagd_spline initial = {s->degree, n, s->dim, knots, start, ones};
    options.degree = s->degree, options.initial = &initial, options.max_iterations = 100;
    for (int i = 0; i < s->count; i++) {
        double t = (i + 0.5 + 0.3 * sin(3.0 * i)) / s->count; /* not even, and off the ends */
        const int end = i == 0 || i == s->count - 1;
        if (end && s->ends != BETWEEN)
            t = i == 0 ? 0 : 1;
        cagd_rational_point(s->degree, s->dim, s->points, s->weights, t, exact + i * s->dim);
        if (end && s->ends == EXACT)
            memcpy(exact + i * s->dim, s->points + (i == 0 ? 0 : s->degree * s->dim), (size_t)s->dim * sizeof *exact);
        sigma[i] =
            (end && s->ends == EXACT ? 0 : s->sigma) * (s->known_sigma ? 1 + (i * 7 % s->count) / (double)s->count : 1);
    }
    const int printed = s->ends == MEASURED && factor == 1 && quantile == 0;
    state = (uint64_t)s->name[0] * 1000003 + (uint64_t)s->name[strlen(s->name) - 3];
    for (int draw = 0; draw < s->draws; draw++) {
        cagd_fit_result *fit = NULL;
        for (int k = 0; k < s->count * s->dim; k++)
            measured[k] = exact[k] + sigma[k / s->dim] * normal();
        if (cagd_fit(&data, &options, &fit, NULL) != CAGD_OK || fit->termination != CAGD_FIT_CONVERGED) {
            failures++;
            cagd_fit_free(fit);
            continue;
        }
        unknowns = fit->unknowns, freedom = s->known_sigma ? 0 : fit->degrees_of_freedom;
        for (int k = 0; k < unknowns; k++) {
            cagd_fit_unknown u = fit->unknown[k];
            double truth = u.is_weight ? log(s->weights[u.index]) : s->points[u.index * s->dim + u.coordinate];
            if (printed)
                count_interval(&unknown[k], cagd_fit_unknown_estimate(fit, k), u.is_weight ? exp(truth) : truth);
            else
                count_in(&unknown[k], fit->value[k], truth, factor * sqrt(fit->covariance[k * unknowns + k]),
                         quantile > 0 ? quantile : fit->quantile);
            if (u.is_weight)
                snprintf(names[k], sizeof names[k], "log w_%d", u.index);
            else
                snprintf(names[k], sizeof names[k], "P_%d, %c", u.index, "xyz"[u.coordinate]);
        }
        for (int j = 0; j < fit->invariants; j++) {
            double truth = s->weights[j + 1] * s->weights[j + 1] / (s->weights[j] * s->weights[j + 2]);
            if (printed)
                count_interval(&invariant[j], cagd_fit_invariant_estimate(fit, j), truth);
            else
                count_in(&invariant[j], fit->invariant[j], truth, factor * fit->invariant_error[j],
                         quantile > 0 ? quantile : fit->quantile);
        }
        cagd_fit_free(fit);
    }
    for (int k = 0; k < unknowns; k++)
        bad += !judge(s->name, names[k], &unknown[k], s->draws, freedom);
    for (int j = 0; j < s->degree - 1; j++)
        snprintf(names[0], sizeof names[0], "I_%d", j + 1),
            bad += !judge(s->name, names[0], &invariant[j], s->draws, freedom);
    if (failures > FAILURES)
        printf("%-15s %d of %d fits did not converge\n", s->name, failures, s->draws);
    return bad + (failures > FAILURES) + (unknowns == 0);
}

int main(int argc, char **argv)
{
    double factor = 1, quantile = 0;
    if (argc == 3 && strcmp(argv[1], "--factor") == 0)
        factor = atof(argv[2]);
    else if (argc == 3 && strcmp(argv[1], "--quantile") == 0)
        quantile = atof(argv[2]);
    else if (argc != 1) {
        fprintf(stderr, "usage: test_coverage [--factor F | --quantile Q]\n");
        return 2;
    }
    int bad = 0;
    for (size_t k = 0; k < sizeof settings / sizeof *settings; k++) /* a control is of linear intervals */
        bad += settings[k].draws < DRAWS && (factor != 1 || quantile > 0) ? 0 : run(&settings[k], factor, quantile);
    printf("%s\n", bad == 0 ? "All intervals cover as they say" : "Some intervals do not cover as they say");
    return bad != 0;
}
