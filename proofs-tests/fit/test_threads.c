/* test_threads.c -- several fits at once: in four threads every fit gives the numbers that it gives alone, bit for bit, and
 * nothing is written on standard error.  Built with ThreadSanitizer, which finds what one thread writes and another reads. */
#include "core/fit/cagd_fit.h"
#include "proofs-tests/fit/options.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { THREADS = 4, POINTS = 48, MOST_DIM = 3 };

/* ---- fits ------------------------------------------------------------------------------------------------- */

static const double start_knots[] = {0, 0, 0, 1, 1, 1}, start_points[] = {2, 0, 1, 1, -1.5, 0.7},
                    start_weights[] = {1, 0.7, 1}, far_points[] = {0, 0, 1e200, 1e200, 0, 1};
static const cagd_spline start = {2, 3, 2, start_knots, start_points, start_weights};
static const cagd_spline far = {2, 3, 2, start_knots, far_points, start_weights};

static void as_usual(cagd_fit_options *o) { (void)o; }
static void cubic(cagd_fit_options *o) { o->degree = 3; }
static void all_free(cagd_fit_options *o)
{
    o->free = CAGD_FIT_WEIGHTS | CAGD_FIT_INNER_POINTS | CAGD_FIT_END_POINTS;
    o->initial = &start;
}
static void spline(cagd_fit_options *o)
{
    o->count = 5;
    o->free = CAGD_FIT_INNER_POINTS;
}
static void robust(cagd_fit_options *o)
{
    o->loss = CAGD_FIT_CAUCHY;
    o->loss_scale = 0.02;
    o->weight_low = 0.5;
    o->weight_high = 2;
}
static void unordered(cagd_fit_options *o) { o->unordered = 1; }
/* The start has no distances in the range of numbers. */
static void hopeless(cagd_fit_options *o) { o->initial = &far; }

static const struct kind {
    const char *name;
    int dim, points;
    double noise;
    void (*change)(cagd_fit_options *o);
} kinds[] = {{"conic", 2, POINTS, 0.01, as_usual},
             {"cubic", 2, POINTS, 0.01, cubic},
             {"in space", 3, POINTS, 0.01, cubic},
             {"all free", 2, POINTS, 0.01, all_free},
             {"spline", 2, POINTS, 0.01, spline},
             {"robust", 2, POINTS, 0.05, robust},
             {"unordered", 2, POINTS / 3, 0.001, unordered},
             {"exact", 2, POINTS, 0, all_free},
             {"hopeless", 2, POINTS, 0.01, hopeless}};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* Points of an arc, off it by a little that no random numbers are needed for. */
static cagd_fit_result *fit(const struct kind *kind)
{
    double points[POINTS * MOST_DIM];
    int dim = kind->dim;
    for (int i = 0; i < kind->points; i++) {
        double a = 2.4 * i / (kind->points - 1), off = kind->noise * sin(7.0 * i * i);
        double at[MOST_DIM] = {(2 + off) * cos(a), (1 + off) * sin(a), a / 3 - off};
        memcpy(points + i * dim, at, (size_t)dim * sizeof *at);
    }
    cagd_fit_data data = {kind->points, dim, points, NULL};
    cagd_fit_options options = options_with_exact_ends();
    cagd_fit_result *result;
    kind->change(&options);
    return cagd_fit(&data, &options, &result, NULL) == CAGD_OK ? result : NULL;
}

/* ---- threads ---------------------------------------------------------------------------------------------- */

static cagd_fit_result *alone[KINDS];

static int same_numbers(int count, const double a[], const double b[])
{
    return memcmp(a, b, (size_t)count * sizeof *a) == 0;
}

static int same(const cagd_fit_result *a, const cagd_fit_result *b)
{
    int n = a->unknowns;
    return b != NULL && a->termination == b->termination && a->steps == b->steps && a->rank == b->rank &&
           strcmp(a->message, b->message) == 0 && same_numbers(n, a->value, b->value) &&
           same_numbers(n * n, a->covariance, b->covariance) && same_numbers(a->count, a->feet, b->feet) &&
           memcmp(&a->cost, &b->cost, sizeof a->cost) == 0;
}

/* All kinds, each thread beginning with another; returns the name of the first that came out otherwise, or NULL. */
static void *work(void *number)
{
    const char *wrong = NULL;
    for (int k = 0; k < KINDS && wrong == NULL; k++) {
        int kind = (k + 2 * *(int *)number) % KINDS;
        cagd_fit_result *result = fit(&kinds[kind]);
        if (!same(alone[kind], result))
            wrong = kinds[kind].name;
        cagd_fit_free(result);
    }
    return (void *)wrong;
}

static int fit_in_threads(void)
{
    pthread_t thread[THREADS];
    int number[THREADS], bad = 0;
    for (int k = 0; k < THREADS; k++) {
        number[k] = k;
        if (pthread_create(&thread[k], NULL, work, &number[k]) != 0)
            abort();
    }
    for (int k = 0; k < THREADS; k++) {
        void *wrong;
        pthread_join(thread[k], &wrong);
        if (wrong != NULL)
            bad += printf("thread %d: %s: not the numbers that it gives alone\n", k, (const char *)wrong) > 0;
    }
    return bad;
}

int main(void)
{
    FILE *errors = tmpfile();
    int bad = 0, before = dup(STDERR_FILENO);
    if (errors == NULL || before < 0 || dup2(fileno(errors), STDERR_FILENO) < 0)
        return 1;
    for (int k = 0; k < KINDS; k++)
        if ((alone[k] = fit(&kinds[k])) == NULL)
            bad += printf("%s: no fit\n", kinds[k].name) > 0;
    bad = bad || fit_in_threads();
    for (int k = 0; k < KINDS; k++)
        cagd_fit_free(alone[k]);
    dup2(before, STDERR_FILENO);
    rewind(errors);
    for (int c; (c = fgetc(errors)) != EOF; bad = 1)
        putchar(c);
    fclose(errors);
    if (!bad)
        printf("%d kinds of fits in each of %d threads\n", KINDS, THREADS);
    return bad;
}
