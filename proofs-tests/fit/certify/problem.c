/* problem.c -- the two files of a problem. */
#include "proofs-tests/fit/certify/problem.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct problem problem;
struct found found;

static double entry(const json_t *a, size_t k) { return json_number_value(json_array_get(a, k)); }
static void fraction(num a, const json_t *entry_text)
{
    mpq_t q;
    mpq_init(q);
    if (mpq_set_str(q, json_string_value(entry_text), 10) != 0)
        stop("the true curve has an entry that is no rational number");
    mpfr_set_q(a, q, MPFR_RNDN);
    mpq_clear(q);
}

static void read_points(const char *path)
{
    FILE *file = fopen(path, "r");
    char line[1024];
    int room = 0;
    if (file == NULL)
        stop("%s: cannot be read", path);
    while (fgets(line, sizeof line, file) != NULL) {
        if (line[0] == '#')
            continue;
        if (line[0] == 'x') { /* the header */
            problem.dim = strstr(line, "z") != NULL ? 3 : 2, problem.known_sigma = strstr(line, "sigma") != NULL;
            continue;
        }
        if (problem.N == room) {
            room = 2 * room + 64;
            problem.Q = realloc(problem.Q, (size_t)(room * problem.dim) * sizeof *problem.Q),
            problem.sigma = realloc(problem.sigma, (size_t)room * sizeof *problem.sigma);
        }
        char *at = line;
        for (int c = 0; c < problem.dim + problem.known_sigma; c++) {
            double x = strtod(at, &at);
            if (*at != (c < problem.dim + problem.known_sigma - 1 ? ',' : '\n'))
                stop("%s: row %d is not as expected", path, problem.N + 1);
            at++;
            *(c < problem.dim ? &problem.Q[problem.N * problem.dim + c] : &problem.sigma[problem.N]) = x;
        }
        if (!problem.known_sigma)
            problem.sigma[problem.N] = 1;
        problem.N++;
    }
    fclose(file);
}

static int listed(const json_t *list, const char *word)
{
    for (size_t k = 0; k < json_array_size(list); k++)
        if (strcmp(json_string_value(json_array_get(list, k)), word) == 0)
            return 1;
    return 0;
}

static void hold(int is_weight, int index, int coordinate)
{
    for (int k = 0; k < problem.m; k++)
        if (problem.unknown[k].is_weight == is_weight && problem.unknown[k].index == index &&
            problem.unknown[k].coordinate == coordinate)
            problem.held[k] = 1;
}

static void read_question(const json_t *file)
{
    const json_t *options = json_object_get(file, "options"), *truth = json_object_get(file, "truth"), *knots, *word,
                 *start = json_object_get(options, "initial"), *free_ones = json_object_get(options, "free"), *pins;
    problem.p = (int)json_integer_value(json_object_get(options, "degree"));
    problem.count = (int)json_array_size(json_object_get(truth, "weights"));
    knots = json_object_get(options, "knots");
    problem.weight = numbers((size_t)problem.count), problem.points = numbers((size_t)(problem.count * problem.dim));
    problem.knot = numbers((size_t)(problem.count + problem.p + 1)), found.value = numbers(MOST);
    for (int j = 0; j <= problem.count + problem.p; j++)
        mpfr_set_d(problem.knot[j], knots != NULL ? entry(knots, (size_t)j) : j > problem.p, MPFR_RNDN);
    int fixed_ends = !listed(free_ones, "ends"), fixed_inner = !listed(free_ones, "inner"), last = problem.count - 1;
    for (int j = 0; j < problem.count; j++) {
        fraction(problem.weight[j], json_array_get(json_object_get(truth, "weights"), (size_t)j));
        for (int c = 0; c < problem.dim; c++) {
            const json_t *P = json_array_get(json_object_get(truth, "points"), (size_t)j);
            fraction(problem.points[j * problem.dim + c], json_array_get(P, (size_t)c));
            int fixed = j == 0 || j == last ? fixed_ends : fixed_inner;
            if (fixed && start != NULL)
                mpfr_set_d(problem.points[j * problem.dim + c],
                           entry(json_array_get(json_object_get(start, "points"), (size_t)j), (size_t)c), MPFR_RNDN);
            else if (fixed)
                mpfr_set_d(problem.points[j * problem.dim + c],
                           problem.Q[(j == 0 ? 0 : problem.N - 1) * problem.dim + c], MPFR_RNDN);
            if (!fixed) {
                problem.unknown[problem.m].index = j, problem.unknown[problem.m].coordinate = c;
                set(found.value[problem.m++], problem.points[j * problem.dim + c]);
            }
        }
    }
    const json_t *bounds = json_object_get(options, "weights-between");
    problem.low = bounds != NULL ? entry(bounds, 0) : 0, problem.high = bounds != NULL ? entry(bounds, 1) : INFINITY;
    for (int j = 1; j < (problem.count == problem.p + 1 ? last : problem.count) && listed(free_ones, "weights"); j++) {
        double w = mpfr_get_d(problem.weight[j], MPFR_RNDN), bound = w < problem.low    ? problem.low
                                                                     : w > problem.high ? problem.high
                                                                                        : w;
        if (w != bound) {
            problem.at_bound[problem.m] = problem.held[problem.m] = 1;
            mpfr_set_d(problem.weight[j], bound, MPFR_RNDN);
        }
        problem.unknown[problem.m].is_weight = 1, problem.unknown[problem.m].index = j;
        size_t mark = used;
        set(found.value[problem.m++], logarithm(problem.weight[j]));
        used = mark;
    }
    if ((word = json_object_get(options, "loss")) != NULL)
        problem.loss = strcmp(json_string_value(word), "huber") == 0 ? HUBER : CAUCHY;
    problem.scale = problem.loss == SQUARES ? 1 : json_number_value(json_object_get(options, "scale"));
    if ((pins = json_object_get(file, "hold")) != NULL) /* coordinates of ends that slide */
        for (size_t k = 0; k < json_array_size(pins); k++)
            hold(0, (int)json_integer_value(json_array_get(json_array_get(pins, k), 0)),
                 (int)json_integer_value(json_array_get(json_array_get(pins, k), 1)));
    for (int k = 0; k < problem.m; k++)
        if (!problem.held[k])
            problem.varied[problem.n++] = k;
    found.foot = numbers((size_t)problem.N), found.at_end = calloc((size_t)problem.N, sizeof *found.at_end),
    found.gradient = numbers(1)[0];
    if (found.at_end == NULL)
        stop("no memory");
    problem.largest_coordinate = numbers(1)[0], problem.smallest_span = numbers(1)[0];
    double most = 0;
    for (int k = 0; k < problem.N * problem.dim; k++)
        most = fmax(most, fabs(problem.Q[k]));
    for (int j = 0; j < problem.count * problem.dim; j++)
        most = fmax(most, fabs(mpfr_get_d(problem.points[j], MPFR_RNDA)));
    mpfr_set_d(problem.largest_coordinate, most, MPFR_RNDN);
    mpfr_sub(problem.smallest_span, problem.knot[problem.count], problem.knot[problem.p], MPFR_RNDN);
    for (int s = problem.p; s < problem.count; s++) {
        size_t mark = used;
        if (less(sub(problem.knot[s + 1], problem.knot[s]), problem.smallest_span))
            set(problem.smallest_span, sub(problem.knot[s + 1], problem.knot[s]));
        used = mark;
    }
}

void read_problem(const char *path, json_t *file)
{
    const char *data = json_string_value(json_object_get(file, "data")), *slash = strrchr(path, '/');
    char beside[4096];
    snprintf(beside, sizeof beside, "%.*s%s", slash != NULL ? (int)(slash - path) + 1 : 0, path, data);
    read_points(beside);
    read_question(file);
}
