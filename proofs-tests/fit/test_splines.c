/* test_splines.c -- random splines with noise: by default every fit comes to a minimum, near its points, without excursions.
 *
 * Cubic splines with 5 to 40 control points that wander, twelve points for each of them, over uneven parameters, with normal errors of 1/100 of the
 * way between control points; the fit is given the number of control points and nothing else. */
#include "core/fit/cagd_fit.h"
#include "proofs-tests/fit/noise.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#ifndef CURVES
#define CURVES 200
#endif
enum { FEWEST = 5, MOST = 40, EACH = 12, DEGREE = 3 };
static const double NOISE = 0.01;

/* A walk whose steps turn by at most 60 degrees, and N points of the spline over it. */
static int make_points(int count, double Q[])
{
    double P[2 * MOST] = {0}, U[MOST + DEGREE + 1], direction = 0;
    for (int j = 1; j < count; j++) {
        direction += 2.1 * (uniform() - 0.5);
        P[2 * j] = P[2 * j - 2] + cos(direction);
        P[2 * j + 1] = P[2 * j - 1] + sin(direction);
    }
    for (int i = 0; i < count + DEGREE + 1; i++)
        U[i] = i <= DEGREE ? 0 : i >= count ? 1 : (double)(i - DEGREE) / (count - DEGREE);
    cagd_spline curve = {DEGREE, count, 2, U, P, NULL};
    const int points = EACH * count;
    for (int i = 0; i < points; i++) {
        double t = i == 0 ? 0 : i == points - 1 ? 1 : (i + 0.8 * (uniform() - 0.5)) / (points - 1);
        if (cagd_spline_point(&curve, t, t < 1 ? CAGD_RIGHT : CAGD_LEFT, Q + 2 * i) != CAGD_OK)
            return 0;
        Q[2 * i] += NOISE * normal();
        Q[2 * i + 1] += NOISE * normal();
    }
    return points;
}

int main(void)
{
    static double Q[2 * MOST * EACH];
    int failed = 0, smoothed = 0, weighted = 0;
    state = 20261123;
    for (int k = 0; k < CURVES; k++) {
        const int count = FEWEST + k % (MOST - FEWEST + 1), points = make_points(count, Q);
        cagd_fit_data data = {points, 2, Q, NULL};
        cagd_fit_options options = cagd_fit_defaults();
        cagd_fit_choices choices = {.weights = 1, .smooth = 2};
        cagd_fit_result *fit = NULL;
        options.degree = DEGREE, options.count = count;
        options.free &= ~CAGD_FIT_WEIGHTS;
        cagd_status status = cagd_fit_choose(&data, &options, &choices, &fit, NULL);
        const int good = points > 0 && status == CAGD_OK && cagd_fit_is_minimum(fit) && fit->curve.count == count &&
                         fit->rms < 1.5 * NOISE && cagd_fit_length_ratio(&data, fit) < CAGD_FIT_LONGEST_RATIO;
        if (!good) {
            printf("curve %d, %d control points: %s, rms %g, length %g\n", k, count,
                   fit != NULL ? fit->message : cagd_status_text(status), fit != NULL ? fit->rms : NAN,
                   fit != NULL ? cagd_fit_length_ratio(&data, fit) : NAN);
            failed++;
        } else {
            smoothed += fit->found.smoothed > 0;
            weighted += fit->found.weights == 1;
        }
        cagd_fit_free(fit);
    }
    printf("%d splines, %d without a good minimum; %d smoothed, %d with weights\n", CURVES, failed, smoothed, weighted);
    return failed > 0;
}
