/* certify.c -- the certified answers of the fit (参考解), by another way than the fit's.
 *
 *     certify PROBLEM.json ...        adds the object "certified" to each file; the points stand beside it
 *
 * Numbers have 512 bits (MPFR).  All unknowns, the foot points among them, are varied together by Newton's method from
 * the true curve, and the only formulas below are that of the curve and that of the cost:
 *
 *     phi(theta, t) = rho(|Q - C(t; theta)|^2 / s^2) / 2.
 *
 * Every derivative is a quotient of differences with the step h = 2^-128, hence right to a relative 2^-256 (first
 * ones, central) or 2^-128 (second ones, which steer the iteration and condition numbers alone).  As a foot is
 * coupled to the curve and to no other foot, the Newton matrix is an arrow, and the feet are eliminated one by one;
 * after a step each goes on by itself to where its distance is stationary.  The iteration ends when no component of
 * the gradient exceeds 1e-40; the point found is a strict minimum when all pivots are positive, which is checked. */
#include "proofs-tests/fit/certify/curve.h"
#include "proofs-tests/fit/certify/feet.h"
#include "proofs-tests/fit/certify/newton.h"
#include "proofs-tests/fit/certify/statistics.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static json_t *text(num a, int digits)
{
    char *s;
    mpfr_asprintf(&s, "%.*Re", digits - 1, a);
    json_t *result = json_string(s);
    mpfr_free_str(s);
    return result;
}

/* A weight on its bound: the cost must fall beyond it. */
static void check_bounds(void)
{
    for (int k = 0; k < problem.m; k++)
        if (problem.at_bound[k]) {
            size_t mark = used;
            num theta[MOST], here = cost(found.value, found.foot);
            memcpy(theta, found.value, (size_t)problem.m * sizeof *theta);
            int above = mpfr_get_d(found.value[k], MPFR_RNDN) > 0;
            theta[k] = add(found.value[k], power2(real(above ? 1 : -1), STEP));
            if (!less(cost(theta, found.foot), here))
                stop("the bound of a weight does not bind");
            used = mark;
        }
}

static json_t *answer(int iterations, const struct statistics *s)
{
    int N = problem.N, dim = problem.dim, count = problem.count, n = problem.n;
    enum { DIGITS = 20, FEW = 4 };
    json_t *a = json_object(), *list, *row;
    int dof = measurements() * (dim - 1) - n + s->missing, ends = 0, slides = 0;
    for (int k = 0; k < problem.m; k++)
        slides |= problem.held[k] && !problem.at_bound[k];
    for (int i = 0; i < N; i++)
        ends += found.at_end[i];
    json_object_set_new(a, "bits", json_integer(BITS));
    json_object_set_new(a, "iterations", json_integer(iterations));
    json_object_set_new(a, "gradient", text(found.gradient, 2));
    json_object_set_new(a, "count", json_integer(N));
    json_object_set_new(a, "feet_at_end", json_integer(ends));
    json_object_set_new(a, "unknowns", json_integer(problem.m));
    json_object_set_new(a, "rank", json_integer(n - s->missing));
    json_object_set_new(a, "degrees_of_freedom", json_integer(dof));
    json_object_set_new(a, "cost", text(cost(found.value, found.foot), DIGITS));
    json_object_set_new(a, "cost_condition", text(s->cost_condition, FEW));
    json_object_set_new(a, "cost_floor", text(s->cost_floor, FEW));
    json_object_set_new(a, "largest_coordinate", text(problem.largest_coordinate, DIGITS));
    json_object_set_new(a, "rms", text(root(quo(s->squares, real(N))), DIGITS));
    if (s->missing == 0)
        json_object_set_new(a, "scale_squared", text(scale_squared(), DIGITS));
    if (slides) /* only the cost is the same for all curves that are slid */
        return a;
    num *curve = numbers((size_t)(count * (dim + 1)));
    curve_of(found.value, curve);
    json_object_set_new(a, "weights", list = json_array());
    for (int j = 0; j < count; j++)
        json_array_append_new(list, text(curve[j], DIGITS));
    json_object_set_new(a, "points", list = json_array());
    for (int j = 0; j < count; j++) {
        json_array_append_new(list, row = json_array());
        for (int c = 0; c < dim; c++)
            json_array_append_new(row, text(quo(curve[count + j * dim + c], curve[j]), DIGITS));
    }
    json_t *estimates;
    json_object_set_new(a, "estimates", estimates = json_array());
    for (int k = 0; k < n; k++) {
        int u = problem.varied[k];
        json_array_append_new(estimates, row = json_object());
        json_object_set_new(row, problem.unknown[u].is_weight ? "log-weight" : "point",
                            json_integer(problem.unknown[u].index));
        if (!problem.unknown[u].is_weight)
            json_object_set_new(row, "coordinate", json_integer(problem.unknown[u].coordinate));
        json_object_set_new(row, "value", text(found.value[u], DIGITS));
        json_object_set_new(row, "condition", text(s->condition[k], FEW));
        json_object_set_new(row, "spread", text(s->spread[k], FEW));
        if (s->missing == 0) {
            json_object_set_new(row, "standard_error", text(s->error[k], DIGITS));
            json_object_set_new(row, "standard_error_condition", text(s->error_condition[k], FEW));
        }
    }
    if (invariants() == 0)
        return a;
    json_object_set_new(a, "invariants", list = json_array());
    for (int j = 1; j <= invariants(); j++) {
        num I = quo(mul(curve[j], curve[j]), mul(curve[j - 1], curve[j + 1])), moves = real(0);
        int v[MOST], f = n + j - 1;
        invariant_form(j, v);
        for (int k = 0; k < n; k++)
            increase(moves, mul(real(abs(v[k])), s->condition[k]));
        json_array_append_new(list, row = json_object());
        json_object_set_new(row, "value", text(I, DIGITS));
        json_object_set_new(row, "condition", text(mul(I, moves), FEW));
        if (s->missing > 0)
            continue;
        json_object_set_new(row, "standard_error", text(mul(I, s->error[f]), DIGITS));
        json_object_set_new(row, "standard_error_condition",
                            text(mul(I, add(s->error_condition[f], mul(s->error[f], moves))), FEW));
    }
    return a;
}

static void certify(const char *path)
{
    json_error_t error;
    json_t *file = json_load_file(path, 0, &error);
    if (file == NULL)
        stop("%s: %s", path, error.text);
    read_problem(path, file);
    num *curve = numbers((size_t)(problem.count * (problem.dim + 1)));
    curve_of(found.value, curve);
    find_feet(curve);
    int iterations = minimise();
    struct statistics statistics = statistics_of_minimum();
    check_bounds();
    json_object_set_new(file, "certified", answer(iterations, &statistics));
    if (json_dump_file(file, path, JSON_INDENT(1)) != 0)
        stop("%s: cannot be written", path);
    json_decref(file);
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: certify PROBLEM.json\n");
        return 2;
    }
    certify(argv[1]);
    return 0;
}
