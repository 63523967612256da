/* bench_fit.c -- how long a fit takes, and how much memory, against other ways to the same minimum.
 *
 * The problem: N points of a rational cubic of the plane, with errors; its two inner weights and two inner points are
 * unknown, and a foot for every point.  All start from the same curve.  Every run is a process of its own, which fits several
 * times: `first` is the time of its first fit, which loads code and memory, `ms` the median of the others.  Its memory is its
 * largest resident set less that of a process that does nothing.  The runs of the methods alternate; medians are printed, and
 * how many times as long as the first method each takes.  The peers come to a minimum and say nothing of intervals; the first
 * method does the same, with standard errors.
 *
 *     bench_fit [PEERS.py]      with the path of bench_fit_peers.py: SciPy as well, where /usr/bin/python3 has it */
#include "core/fit/cagd_fit.h"
#include "proofs-tests/bench/plain_ceres.h"
#include "proofs-tests/fit/options.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#ifdef WITH_GSL
#include <gsl/gsl_blas.h>
#include <gsl/gsl_multifit_nlinear.h>
#endif

#define PYTHON "/usr/bin/python3"

static const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
static const double true_points[] = {0, 0, 1, 2.5, 3, 2, 4, -0.5}, true_weights[] = {1, 2, 0.6, 1};
static const double first_points[] = {0, 0, 1.3, 2, 2.7, 2.2, 4, -0.5}, first_weights[] = {1, 1, 1, 1};
static const cagd_spline truth = {3, 4, 2, knots, true_points, true_weights};
static const cagd_spline start = {3, 4, 2, knots, first_points, first_weights};

typedef struct outcome {
    double seconds, first, cost, mebibytes;
    int iterations, converged;
} outcome;

/* Processor time, which does not grow when others use the machine. */
static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Normal numbers by Box and Muller from a linear congruence. */
static double normal(void)
{
    static unsigned long long x = 1;
    double u[2];
    for (int k = 0; k < 2; k++) {
        x = x * 6364136223846793005u + 1442695040888963407u;
        u[k] = ((double)(x >> 11) + 0.5) * 0x1p-53;
    }
    return sqrt(-2 * log(u[0])) * cos(2 * acos(-1) * u[1]);
}

static double *make_points(int N)
{
    double *Q = malloc((size_t)N * 2 * sizeof *Q);
    for (int i = 0; Q != NULL && i < N; i++) {
        cagd_spline_point(&truth, 0.02 + 0.96 * i / (N - 1), CAGD_RIGHT, Q + 2 * i);
        Q[2 * i] += 0.01 * normal();
        Q[2 * i + 1] += 0.01 * normal();
    }
    return Q;
}

/* With all intervals, and only to the minimum and its standard errors, as the peers. */
static outcome eliminate(int N, const double *Q, int without_intervals)
{
    cagd_fit_data data = {N, 2, Q, NULL};
    cagd_fit_options options = options_with_exact_ends();
    cagd_fit_result *r;
    options.initial = &start;
    options.max_iterations = 1000;
    options.without_intervals = without_intervals;
    double begin = now();
    if (cagd_fit(&data, &options, &r, NULL) != CAGD_OK)
        return (outcome){0};
    outcome o = {.seconds = now() - begin};
    o.cost = r->cost, o.iterations = r->iterations, o.converged = r->termination == CAGD_FIT_CONVERGED;
    cagd_fit_free(r);
    return o;
}

static outcome eliminated(int N, const double *Q) { return eliminate(N, Q, 1); }
static outcome with_intervals(int N, const double *Q) { return eliminate(N, Q, 0); }

static outcome plain(int N, const double *Q)
{
    cagd_fit_data data = {N, 2, Q, NULL};
    cagd_fit_options options = options_with_exact_ends();
    plain_outcome p;
    options.initial = &start;
    options.max_iterations = 1000;
    double begin = now();
    if (plain_ceres(&data, &options, &p) != CAGD_OK)
        return (outcome){0};
    return (outcome){.seconds = now() - begin, .cost = p.cost, .iterations = p.iterations, .converged = p.converged};
}

#ifdef WITH_GSL
typedef struct gsl_problem {
    int N;
    const double *Q;
} gsl_problem;

/* Residuals and Jacobian: log w_1, log w_2, P_1, P_2, then the feet. */
static void gsl_rows(const gsl_vector *x, const gsl_problem *p, gsl_vector *f, gsl_matrix *J)
{
    double w[4] = {1, exp(gsl_vector_get(x, 0)), exp(gsl_vector_get(x, 1)), 1}, P[8];
    memcpy(P, first_points, sizeof P);
    for (int k = 0; k < 4; k++)
        P[2 + k] = gsl_vector_get(x, (size_t)k + 2);
    if (J != NULL)
        gsl_matrix_set_zero(J);
    for (int i = 0; i < p->N; i++) {
        cagd_spline s = {3, 4, 2, knots, P, w};
        double t = gsl_vector_get(x, (size_t)i + 6), r = 1 - t, D[4];
        cagd_spline_derivatives(&s, fmin(fmax(t, 0), 1), CAGD_RIGHT, 1, D);
        double B[4] = {r * r * r, 3 * r * r * t * w[1], 3 * r * t * t * w[2], t * t * t};
        double total = B[0] + B[1] + B[2] + B[3];
        for (int c = 0; c < 2; c++) {
            size_t row = (size_t)(2 * i + c);
            if (f != NULL)
                gsl_vector_set(f, row, p->Q[2 * i + c] - D[c]);
            for (size_t k = 1; J != NULL && k < 3; k++) {
                gsl_matrix_set(J, row, k - 1, -B[k] / total * (P[2 * k + (size_t)c] - D[c]));
                gsl_matrix_set(J, row, 2 * k + (size_t)c, -B[k] / total);
            }
            if (J != NULL)
                gsl_matrix_set(J, row, (size_t)i + 6, -D[2 + c]);
        }
    }
}

static int gsl_f(const gsl_vector *x, void *p, gsl_vector *f) { return gsl_rows(x, p, f, NULL), GSL_SUCCESS; }
static int gsl_df(const gsl_vector *x, void *p, gsl_matrix *J) { return gsl_rows(x, p, NULL, J), GSL_SUCCESS; }

static outcome by_gsl(int N, const double *Q)
{
    gsl_problem problem = {N, Q};
    size_t n = 2 * (size_t)N, m = (size_t)N + 6;
    gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
    gsl_multifit_nlinear_fdf fdf = {.f = gsl_f, .df = gsl_df, .n = n, .p = m, .params = &problem};
    gsl_vector *x = gsl_vector_calloc(m);
    for (size_t k = 0; k < 4; k++)
        gsl_vector_set(x, 2 + k, first_points[2 + k]);
    for (int i = 0; i < N; i++)
        gsl_vector_set(x, (size_t)i + 6, 0.02 + 0.96 * i / (N - 1));
    double begin = now(), sum;
    gsl_multifit_nlinear_workspace *w = gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, n, m);
    gsl_multifit_nlinear_init(x, &fdf, w);
    int info, status = gsl_multifit_nlinear_driver(1000, 1e-14, 1e-14, 1e-14, NULL, NULL, &info, w);
    double seconds = now() - begin;
    gsl_blas_ddot(gsl_multifit_nlinear_residual(w), gsl_multifit_nlinear_residual(w), &sum);
    outcome o = {.seconds = seconds, .cost = sum / 2, .iterations = (int)gsl_multifit_nlinear_niter(w)};
    o.converged = status == GSL_SUCCESS;
    gsl_multifit_nlinear_free(w);
    gsl_vector_free(x);
    return o;
}
#endif

static outcome nothing(int N, const double *Q)
{
    (void)N, (void)Q;
    return (outcome){.converged = 1};
}

static int by_seconds(const void *a, const void *b)
{
    const outcome *x = a, *y = b;
    return (x->seconds > y->seconds) - (x->seconds < y->seconds);
}

/* The median of the fits after a first one, at least nine and for a tenth of a second, or that one if no more are asked for. */
enum { LEAST = 9, MANY = 1000, REPEATED = 7 };
static outcome several(int N, const double *Q, outcome (*method)(int, const double *), int more)
{
    static outcome o[MANY];
    outcome first = o[0] = method(N, Q);
    int count = 0;
    for (double begin = now(); more && count < MANY && (count < LEAST || now() - begin < 0.1); count++)
        o[count] = method(N, Q);
    if (more)
        qsort(o, (size_t)count, sizeof *o, by_seconds);
    o[count / 2].first = first.seconds;
    return o[count / 2];
}

/* One run in a process of its own. */
static outcome run(int N, outcome (*method)(int, const double *), int more)
{
    int pipes[2], status;
    outcome o = {0};
    struct rusage usage;
    fflush(stdout);
    if (pipe(pipes) != 0)
        return o;
    pid_t child = fork();
    if (child == 0) {
        double *Q = make_points(N);
        if (Q != NULL)
            o = several(N, Q, method, more);
        free(Q);
        _exit(write(pipes[1], &o, sizeof o) != sizeof o);
    }
    close(pipes[1]);
    if (child < 0 || read(pipes[0], &o, sizeof o) != sizeof o)
        o = (outcome){0};
    close(pipes[0]);
    if (child > 0 && wait4(child, &status, 0, &usage) == child)
        o.mebibytes = (double)usage.ru_maxrss / 1024;
    return o;
}

static const char *peers;

/* SciPy's least squares: seconds, cost and iterations, as the script prints them. */
static outcome by_scipy(int N, const double *Q)
{
    char name[] = "/tmp/bench_fit_XXXXXX", command[4096];
    outcome o = {0};
    int file = mkstemp(name);
    FILE *out = file < 0 ? NULL : fdopen(file, "w");
    if (out == NULL)
        return o;
    for (int i = 0; i < N; i++)
        fprintf(out, "%.17g %.17g\n", Q[2 * i], Q[2 * i + 1]);
    fclose(out);
    snprintf(command, sizeof command, "%s '%s' %s", PYTHON, peers, name);
    FILE *in = popen(command, "r");
    if (in != NULL) {
        o.converged = fscanf(in, "%lf %lf %d", &o.seconds, &o.cost, &o.iterations) == 3;
        o.first = o.seconds;
        pclose(in);
    }
    unlink(name);
    return o;
}

enum { MOST = 5, IN_TURN = 3 }; /* IN_TURN: methods whose runs alternate */

static void print_row(const char *name, int N, const outcome *o, double best_cost, double base, double against)
{
    printf("%-34s %7d %9.3f %9.3f %6d %22.16g %9.1e %8.1f", name, N, 1e3 * o->first, 1e3 * o->seconds, o->iterations,
           o->cost, o->cost / best_cost - 1, o->mebibytes - base);
    printf(against > 0 ? " %8.1f\n" : "\n", o->seconds / against);
}

int main(int argc, char **argv)
{
    static const int sizes[] = {200, 2000, 20000};
    struct {
        const char *name;
        outcome (*method)(int, const double *);
        int largest;
    } methods[MOST] = {{"cagd_fit, without intervals", eliminated, 20000},
                       {"one Ceres problem", plain, 20000},
                       {"cagd_fit, with intervals", with_intervals, 20000}};
    int count = IN_TURN;
#ifdef WITH_GSL
    methods[count].name = "GSL multifit_nlinear (dense)";
    methods[count].largest = 200; /* (2N)(N+6) numbers, and a factorisation of them in each step */
    methods[count++].method = by_gsl;
#else
    puts("GSL: not installed, skipped");
#endif
    peers = argc > 1 ? argv[1] : NULL;
    if (peers != NULL && system(PYTHON " -c 'import scipy.optimize' 2>/dev/null") == 0) {
        methods[count].name = "SciPy least_squares (sparse)";
        methods[count].largest = 20000;
        methods[count++].method = by_scipy;
    } else {
        puts("SciPy: not installed or its script not named, skipped");
    }
    printf("Times are of the processor.\n%-34s %7s %9s %9s %6s %22s %9s %8s %8s\n", "method", "N", "first ms", "ms",
           "steps", "cost", "above", "MiB", "times");
    double seconds[3];
    for (int s = 0; s < 3; s++) {
        outcome runs[MOST][REPEATED], base = run(sizes[s], nothing, 0);
        for (int k = 0; k < REPEATED; k++)
            for (int m = 0; m < count; m++)
                if (sizes[s] <= methods[m].largest && (k == 0 || m < IN_TURN))
                    runs[m][k] = run(sizes[s], methods[m].method, m < IN_TURN);
        double best = HUGE_VAL;
        for (int m = 0; m < count; m++) {
            if (sizes[s] > methods[m].largest)
                continue;
            if (m < IN_TURN) {
                qsort(runs[m], REPEATED, sizeof **runs, by_seconds);
                runs[m][0] = runs[m][REPEATED / 2];
            }
            if (runs[m][0].converged && runs[m][0].cost < best)
                best = runs[m][0].cost;
        }
        for (int m = 0; m < count; m++)
            if (sizes[s] <= methods[m].largest)
                print_row(methods[m].name, sizes[s], &runs[m][0], best, base.mebibytes, m > 0 ? runs[0][0].seconds : 0);
            else
                printf("%-34s %7d   skipped: its time grows with more than N\n", methods[m].name, sizes[s]);
        seconds[s] = runs[0][0].seconds;
    }
    printf("growth from %d to %d points: %.1f times the time\n", sizes[1], sizes[2], seconds[2] / seconds[1]);
    return 0;
}
