/* test_certified.c -- the fit on the problems whose answers are certified (NAME.json beside NAME.csv; see generate.py and
 * certify): how many digits agree, and whether these are as many as binary64 allows.
 *
 *     test_certified FOLDER [NAME ...]       without names all problems of the folder
 *
 * What is allowed.  A point of the curve is computed with a relative error of at most eps = (10 p + 8) u, u = 2^-53,
 * of the largest coordinate M: Cox and de Boor's recursion takes 4 roundings a level, all of positive terms, hence 4p; the weight
 * and the sum 2 + p; the same above and below the line, and the division: 2 (5p + 2) + 2; the exponential of the weight and
 * the subtraction from the point 2 more.  The certificate says how much the answer moves when every residual is wrong
 * by eps M: the estimates by eps `condition`, the cost by eps `cost_condition` + eps^2 `cost_floor` / 2.
 * The noise may be so large, and the valley so curved, that Gauss and Newton's steps decrease the cost too little to be told from
 * rounding while the gradient is not yet small; such a problem says "by-cost", and its estimates may be off by what a
 * change of the cost by its rounding allows, sqrt(2 eps cost_condition) `spread`.  An "undetermined" one has its cost alone compared.
 * Where there is no noise, twelve digits of the true weights are asked for besides. */
#include "core/fit/cagd_fit.h"
#include "proofs-tests/fit/options.h"

#include <dirent.h>
#include <float.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 64, NAMES = 256, WEIGHT_DIGITS = 12 };

typedef struct problem {
    char name[64];
    json_t *file;
    const json_t *certified;
    cagd_fit_data data;
    cagd_fit_options options;
    cagd_spline initial;
    double *points, *sigma, knots[MOST], start_points[3 * MOST], start_weights[MOST];
} problem;

static const json_t *at(const json_t *object, const char *key) { return json_object_get(object, key); }
static const json_t *item(const json_t *list, int k) { return json_array_get(list, (size_t)k); }
static double real(const json_t *x)
{
    return json_is_string(x) ? strtod(json_string_value(x), NULL) : json_number_value(x);
}
static int whole(const json_t *x) { return (int)json_integer_value(x); }

static int listed(const json_t *list, const char *word)
{
    for (int k = 0; k < (int)json_array_size(list); k++)
        if (strcmp(json_string_value(item(list, k)), word) == 0)
            return 1;
    return 0;
}

static int read_points(problem *it, const char *path)
{
    char line[1024];
    int room = 0, with_sigma = 0, *N = &it->data.count, *dim = &it->data.dim;
    FILE *file = fopen(path, "r");
    if (file == NULL)
        return 0;
    while (fgets(line, sizeof line, file) != NULL) {
        if (line[0] == '#')
            continue;
        if (line[0] == 'x') {
            *dim = strchr(line, 'z') != NULL ? 3 : 2, with_sigma = strstr(line, "sigma") != NULL;
            continue;
        }
        if (*N == room) {
            room = 2 * room + 64;
            it->points = realloc(it->points, (size_t)(room * *dim) * sizeof(double));
            it->sigma = realloc(it->sigma, (size_t)room * sizeof(double));
        }
        char *where = line;
        for (int c = 0; c < *dim + with_sigma; c++, where++)
            *(c < *dim ? &it->points[*N * *dim + c] : &it->sigma[*N]) = strtod(where, &where);
        ++*N;
    }
    fclose(file);
    it->data.points = it->points, it->data.sigma = with_sigma ? it->sigma : NULL;
    return *N > 0;
}

static int read_problem(problem *it, const char *folder, const char *name)
{
    char path[4096];
    json_error_t error;
    memset(it, 0, sizeof *it);
    snprintf(it->name, sizeof it->name, "%s", name);
    snprintf(path, sizeof path, "%s/%s.json", folder, name);
    it->file = json_load_file(path, 0, &error);
    if (it->file == NULL || (it->certified = at(it->file, "certified")) == NULL)
        return 0;
    snprintf(path, sizeof path, "%s/%s", folder, json_string_value(at(it->file, "data")));
    if (!read_points(it, path))
        return 0;
    const json_t *given = at(it->file, "options"), *x;
    cagd_fit_options *o = &it->options;
    *o = options_with_exact_ends();
    o->degree = whole(at(given, "degree"));
    o->free = CAGD_FIT_WEIGHTS * listed(at(given, "free"), "weights") +
              CAGD_FIT_INNER_POINTS * listed(at(given, "free"), "inner") +
              CAGD_FIT_END_POINTS * listed(at(given, "free"), "ends");
    o->count = o->degree + 1;
    if ((x = at(given, "knots")) != NULL) {
        o->count = (int)json_array_size(x) - o->degree - 1, o->knots = it->knots;
        for (int k = 0; k <= o->count + o->degree; k++)
            it->knots[k] = real(item(x, k));
    }
    if ((x = at(given, "loss")) != NULL)
        o->loss = strcmp(json_string_value(x), "huber") == 0 ? CAGD_FIT_HUBER : CAGD_FIT_CAUCHY;
    if ((x = at(given, "scale")) != NULL)
        o->loss_scale = real(x);
    if ((x = at(given, "weights-between")) != NULL)
        o->weight_low = real(item(x, 0)), o->weight_high = real(item(x, 1));
    if ((x = at(given, "starts")) != NULL)
        o->starts = whole(x);
    if ((x = at(given, "max-iterations")) != NULL)
        o->max_iterations = whole(x);
    o->unordered = json_is_true(at(given, "unordered"));
    if ((x = at(given, "initial")) != NULL) {
        if (o->knots == NULL)
            for (int k = 0; k < 2 * o->count; k++)
                it->knots[k] = k >= o->count;
        for (int j = 0; j < o->count; j++) {
            it->start_weights[j] = real(item(at(x, "weights"), j));
            for (int c = 0; c < it->data.dim; c++)
                it->start_points[j * it->data.dim + c] = real(item(item(at(x, "points"), j), c));
        }
        it->initial = (cagd_spline){o->degree, o->count, it->data.dim, it->knots, it->start_points, it->start_weights};
        o->initial = &it->initial;
    }
    return 1;
}

static void free_problem(problem *it)
{
    json_decref(it->file);
    free(it->points);
    free(it->sigma);
}

/* Digits that agree: -log10 of the error in units of what is meant, at most 16; those of coordinates count from the largest. */
static double digits_of(double x, double certified, double unit)
{
    double error = fabs(x - certified) / unit;
    return error < 1e-16 ? 16 : error < 1 ? -log10(error) : 0; /* also for what is not a number */
}
static double digits(double x, double certified)
{
    return digits_of(x, certified, certified == 0 ? 1 : fabs(certified));
}
static double fewer(double a, double b) { return a < b ? a : b; }

/* A row of the table. */
typedef struct row {
    double cost, weights, points, invariants, errors, allowed; /* digits; the share of the allowance that was used up */
    char complaint[256];
} row;

static void complain(row *r, const char *what, double x, double certified, double allowed)
{
    if (r->complaint[0] == 0)
        snprintf(r->complaint, sizeof r->complaint, "%s is %.17g, certified %.17g, allowed error %.2g", what, x,
                 certified, allowed);
}

static double allow(row *r, const char *what, double x, double certified, double allowed)
{
    double share = fabs(x - certified) / allowed;
    if (!(share <= r->allowed))
        r->allowed = share;
    if (!(share <= 1))
        complain(r, what, x, certified, allowed);
    return digits(x, certified);
}

static void compare_estimates(row *r, const problem *it, const cagd_fit_result *fit, double eps, int exact)
{
    int by_cost = at(it->file, "by-cost") != NULL; /* the reason stands in the file */
    const json_t *list = at(it->certified, "estimates"), *one, *x;
    for (int k = 0; k < (int)json_array_size(list); k++) {
        one = item(list, k);
        int is_weight = (x = at(one, "log-weight")) != NULL, c = whole(at(one, "coordinate")), u;
        int index = whole(is_weight ? x : at(one, "point"));
        double certified = real(at(one, "value")), allowed = eps * real(at(one, "condition"));
        if (by_cost)
            allowed += sqrt(2 * eps * real(at(it->certified, "cost_condition"))) * real(at(one, "spread"));
        for (u = 0; u < fit->unknowns; u++)
            if (fit->unknown[u].is_weight == is_weight && fit->unknown[u].index == index &&
                (is_weight || fit->unknown[u].coordinate == c))
                break;
        if (u == fit->unknowns) {
            complain(r, "an unknown is missing; its number", k, k, 0);
            return;
        }
        allow(r, is_weight ? "the logarithm of a weight" : "a coordinate", fit->value[u], certified, allowed);
        if (is_weight) /* digits of the weight itself */
            r->weights = fewer(r->weights, digits(exp(fit->value[u] - certified), 1));
        else
            r->points =
                fewer(r->points, digits_of(fit->value[u], certified, real(at(it->certified, "largest_coordinate"))));
        if ((x = at(one, "standard_error")) != NULL && !exact && !by_cost) {
            double error = sqrt(fit->covariance[u * fit->unknowns + u]);
            r->errors = fewer(r->errors, allow(r, "a standard error", error, real(x),
                                               eps * real(at(one, "standard_error_condition"))));
        }
    }
    list = at(it->certified, "invariants");
    for (int k = 0; k < (int)json_array_size(list) && k < fit->invariants; k++) {
        one = item(list, k);
        if (real(at(one, "condition")) > 0)
            r->invariants =
                fewer(r->invariants, allow(r, "an invariant", fit->invariant[k], real(at(one, "value")),
                                           eps * (real(at(one, "condition")) + 3 * real(at(one, "value")))));
        if ((x = at(one, "standard_error")) != NULL && !exact && real(x) > 0)
            r->errors = fewer(r->errors, allow(r, "the standard error of an invariant", fit->invariant_error[k],
                                               real(x), eps * real(at(one, "standard_error_condition"))));
    }
    if ((int)json_array_size(list) != fit->invariants)
        complain(r, "the number of invariants", fit->invariants, (double)json_array_size(list), 0);
    for (int j = 0; exact && j < it->options.count; j++) {
        long numerator = 0, denominator = 1;
        sscanf(json_string_value(item(at(at(it->file, "truth"), "weights"), j)), "%ld/%ld", &numerator, &denominator);
        double truth = (double)numerator / (double)denominator;
        if (digits(fit->curve.weights[j], truth) < WEIGHT_DIGITS)
            complain(r, "a weight that is known exactly", fit->curve.weights[j], truth,
                     truth * pow(10, -WEIGHT_DIGITS));
    }
}

/* 1 if all is as it should be. */
static int run(const char *folder, const char *name)
{
    problem it;
    if (!read_problem(&it, folder, name)) {
        printf("%-18s cannot be read\n", name);
        return 0;
    }
    row r = {16, 16, 16, 16, 16, 0, ""};
    cagd_fit_result *fit = NULL;
    cagd_status status = cagd_fit(&it.data, &it.options, &fit, NULL);
    if (status != CAGD_OK) {
        printf("%-18s %s\n", name, cagd_status_text(status));
        free_problem(&it);
        return 0;
    }
    int exact = real(at(it.file, "noise")) == 0, slides = at(it.certified, "weights") == NULL;
    int undetermined = at(it.file, "undetermined") != NULL;
    double eps = (10 * it.options.degree + 8) * (DBL_EPSILON / 2), cost = real(at(it.certified, "cost"));
    double floor =
        eps * real(at(it.certified, "cost_condition")) + eps * eps * real(at(it.certified, "cost_floor")) / 2;
    if (fit->termination != CAGD_FIT_CONVERGED)
        snprintf(r.complaint, sizeof r.complaint, "not converged: %.200s", fit->message);
    r.cost = allow(&r, "the cost", fit->cost, cost, floor);
    if (fit->rank != whole(at(it.certified, "rank")))
        complain(&r, "the rank", fit->rank, whole(at(it.certified, "rank")), 0);
    if (fit->degrees_of_freedom != whole(at(it.certified, "degrees_of_freedom")))
        complain(&r, "the number of degrees of freedom", fit->degrees_of_freedom,
                 whole(at(it.certified, "degrees_of_freedom")), 0);
    double rms = real(at(it.certified, "rms")), D[6],
           speed = 0;                         /* a mean of distances: each has the error eps M, and the */
    for (int i = 0; i < it.data.count; i++) { /* foot, rounded, u |t| |C'| along the curve          */
        cagd_spline_derivatives(&fit->curve, fit->feet[i], CAGD_RIGHT, 1, D);
        double here = 0;
        for (int c = 0; c < it.data.dim; c++)
            here += D[it.data.dim + c] * D[it.data.dim + c];
        speed = fmax(speed, sqrt(here) * fabs(fit->feet[i]));
    }
    allow(&r, "the rms", fit->rms, rms, eps * real(at(it.certified, "largest_coordinate")) + DBL_EPSILON / 2 * speed);
    if (!exact) { /* by their formulas, from the certified cost and rank */
        double k = whole(at(it.certified, "rank")), n = k + whole(at(it.certified, "degrees_of_freedom")),
               chi = 2 * cost;
        double fits = it.data.sigma != NULL ? chi : n * log(chi / n), d = it.data.sigma != NULL ? 0 : 1;
        double blur = (it.data.sigma != NULL ? 2 : n / cost) * floor + 8 * DBL_EPSILON * fabs(fits);
        allow(&r, "AIC", fit->aic, fits + 2 * (k + d), blur);
        allow(&r, "BIC", fit->bic, fits + (k + d) * log(n), blur);
        allow(&r, "chi squared", fit->chi_squared, chi, 2 * floor);
    }
    if (!slides)
        compare_estimates(&r, &it, fit, eps, exact);
    printf("%-18s %6d %4d %5.1f", name, it.data.count, fit->iterations, exact ? NAN : r.cost);
    if (undetermined) /* the reason stands in the file */
        slides = 1, r.allowed = 0, r.complaint[0] = 0, allow(&r, "the cost", fit->cost, cost, floor);
    printf(slides  ? "     -     -     -     -"
           : exact ? " %5.1f %5.1f %5.1f     -"
                   : " %5.1f %5.1f %5.1f %5.1f",
           r.weights, r.points, it.options.count > it.options.degree + 1 ? NAN : r.invariants, r.errors);
    printf("  %7.1e  %s\n", r.allowed, r.complaint[0] ? r.complaint : "ok");
    cagd_fit_free(fit);
    free_problem(&it);
    return r.complaint[0] == 0;
}

static int by_name(const void *a, const void *b) { return strcmp(*(char *const *)a, *(char *const *)b); }

int main(int argc, char **argv)
{
    char *names[NAMES];
    int count = 0, good = 0;
    if (argc < 2) {
        fprintf(stderr, "usage: test_certified FOLDER [NAME ...]\n");
        return 2;
    }
    for (int k = 2; k < argc && count < NAMES; k++)
        names[count++] = argv[k];
    DIR *folder = argc == 2 ? opendir(argv[1]) : NULL;
    for (struct dirent *entry; folder != NULL && count < NAMES && (entry = readdir(folder)) != NULL;) {
        char *dot = strstr(entry->d_name, ".json");
        if (dot != NULL) {
            names[count] = calloc(1, sizeof entry->d_name);
            memcpy(names[count++], entry->d_name, (size_t)(dot - entry->d_name));
        }
    }
    if (folder != NULL)
        closedir(folder);
    qsort(names, (size_t)count, sizeof *names, by_name);
    printf("Digits that agree with the certified answer, and the share of the allowed error that was used up\n");
    printf("%-18s %6s %4s %5s %5s %5s %5s %5s  %7s\n", "", "points", "it.", "cost", "w", "P", "I", "errors", "share");
    for (int k = 0; k < count; k++) {
        good += run(argv[1], names[k]);
        if (argc == 2)
            free(names[k]);
    }
    printf("%d of %d\n", good, count);
    return good == count && count > 0 ? 0 : 1;
}
