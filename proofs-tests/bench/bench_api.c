/* bench_api.c -- what a point through the public library costs against the same kernel called directly, spans searched for in both.
 *
 * A cubic of space, with and without weights, of 4 to 100 000 points, at parameters in random order.  Ways: `kernel` on the
 * arrays as they are; `one` through a prepared curve, one parameter a call; `all` the same, all parameters in one call; `spline`
 * through cagd_spline_point, which checks the whole curve every time.  The ways take turns; medians of the rounds are printed,
 * in nanoseconds a point, and the ratios to `kernel` as medians of the ratios within a round. */
#include "core/spline.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { P = 3, DIM = 3, PARAMETERS = 4096, REPEATS = 8, ROUNDS = 41 };
enum way { KERNEL_CALL, ONE, ALL, WAYS };

/* Read when the program runs, so that no kernel is compiled for one degree and dimension alone. */
static volatile int degree = P, dim = DIM;
static double out[PARAMETERS * DIM], t[PARAMETERS], sum;

static double now(void)
{
    struct timespec at;
    clock_gettime(CLOCK_MONOTONIC, &at);
    return 1e9 * (double)at.tv_sec + (double)at.tv_nsec;
}

static double uniform(void)
{
    static unsigned long long x = 1;
    x = x * 6364136223846793005u + 1442695040888963407u;
    return (double)(x >> 11) * 0x1p-53;
}

static void kernel(const cagd_spline *s)
{
    for (int i = 0; i < PARAMETERS; i++) {
        int mu = find_span_d(s->count, s->degree, s->knots, t[i]);
        if (s->weights != NULL)
            nurbs_point_d(nurbs_on_span_d(s->degree, s->dim, s->knots, mu, s->points, s->weights), t[i], out + i * DIM);
        else
            bspline_deboor_d(on_span_d(s->degree, s->dim, s->knots, mu, s->points), t[i], out + i * DIM);
    }
}

/* Nanoseconds a point. */
static double run(enum way way, const cagd_spline *s, const cagd_curve *curve)
{
    double begin = now();
    for (int k = 0; k < REPEATS; k++) {
        if (way == KERNEL_CALL)
            kernel(s);
        for (int i = 0; way == ONE && i < PARAMETERS; i++)
            cagd_curve_point(curve, t[i], CAGD_RIGHT, out + i * DIM);
        if (way == ALL)
            cagd_curve_points(curve, PARAMETERS, t, CAGD_RIGHT, out, NULL);
        sum += out[k];
    }
    return (now() - begin) / (PARAMETERS * REPEATS);
}

static double checked_every_time(const cagd_spline *s)
{
    enum { TIMES = 20 };
    double begin = now();
    for (int i = 0; i < TIMES; i++)
        cagd_spline_point(s, t[i], CAGD_RIGHT, out);
    return (now() - begin) / TIMES;
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}
static double median(double x[])
{
    qsort(x, ROUNDS, sizeof *x, ascending);
    return x[ROUNDS / 2];
}

int main(void)
{
    static const int counts[] = {4, 10, 50, 1000, 100000};
    puts("weights   points    kernel       one       all    spline    one/kernel all/kernel");
    for (int rational = 0; rational <= 1; rational++)
        for (size_t k = 0; k < sizeof counts / sizeof *counts; k++) {
            int n = counts[k];
            double *u = malloc(sizeof *u * (size_t)(n + P + 1)), *R = malloc(sizeof *R * (size_t)n * DIM);
            double *w = malloc(sizeof *w * (size_t)n);
            if (u == NULL || R == NULL || w == NULL)
                return 1;
            for (int i = 0; i < n + P + 1; i++)
                u[i] = i <= P ? 0 : i >= n ? n - P : i - P;
            for (int m = 0; m < n * DIM; m++)
                R[m] = uniform();
            for (int i = 0; i < n; i++)
                w[i] = 0.5 + uniform();
            for (int i = 0; i < PARAMETERS; i++)
                t[i] = uniform() * (n - P);
            cagd_spline s = {degree, n, dim, u, R, rational ? w : NULL};
            cagd_curve *curve = cagd_curve_new(&s, NULL, NULL);
            if (curve == NULL)
                return 1;
            double cost[WAYS][ROUNDS], ratio[WAYS][ROUNDS];
            for (int round = 0; round < ROUNDS; round++) {
                for (int way = 0; way < WAYS; way++)
                    cost[way][round] = run((enum way)way, &s, curve);
                for (int way = 0; way < WAYS; way++)
                    ratio[way][round] = cost[way][round] / cost[KERNEL_CALL][round];
            }
            printf("%-7s %8d %9.1f %9.1f %9.1f %9.0f    %10.2f %10.2f\n", rational ? "yes" : "no", n,
                   median(cost[KERNEL_CALL]), median(cost[ONE]), median(cost[ALL]), checked_every_time(&s),
                   median(ratio[ONE]), median(ratio[ALL]));
            cagd_curve_free(curve);
            free(u), free(R), free(w);
        }
    return sum == 0;
}
