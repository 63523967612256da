/* test_kernels.c -- every kernel on high-entropy data, in all number types at once:
 *
 *     q   equals the reference, which is computed from a definition;
 *     m   has bit for bit the values of d, and its bound is finite and true;
 *     i   contains q;
 *     f   is the constant q.
 *
 * The seed is the kernel's name; a failure prints the trial. */
#include "core/kernels/kernels_d.h"
#include "core/kernels/kernels_m.h"
#include "exact/kernels_f.h"
#include "exact/kernels_i.h"
#include "exact/kernels_q.h"
#include "exact/words.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* clang-format off */
#define ALL_KERNELS(_)                                                                                                 \
    _(bernstein_basis) _(bernstein_derivatives) _(bernstein_product) _(bernstein_elevation_matrix) _(bernstein_to_power)               \
    _(bernstein_from_power) _(bernstein_on_interval) _(bezier_casteljau) _(bezier_horner) _(bezier_differences)            \
    _(bezier_derivatives) _(bezier_split) _(bezier_elevate) _(bezier_blossom) _(bezier_on_interval) _(rational_homogenize)    \
    _(rational_dehomogenize) _(rational_weight) _(rational_point) _(rational_derivatives) _(rational_casteljau)      \
    _(rational_split) _(rational_elevate) _(rational_reparametrize) _(rational_invariants) _(rational_standard_form)   \
    _(dot) _(norm_squared) _(cross2) _(cross3) _(det3) _(gram) _(curvature_squared) _(curvature) _(signed_curvature)   \
    _(torsion) _(rational_curvature_squared) _(rational_torsion) _(line_through) _(line_pair) _(conic_pencil)          \
    _(conic_liming) _(conic_value) _(conic_gradient) _(conic_delta) _(conic_determinant) _(conic_of_bezier)                  \
    _(conic_standard_weight) _(conic_shoulder_point) _(circular_arc_invariant) _(circular_arc_weights) _(circular_arc_circle)      \
    _(determinant) _(sylvester) _(bezout) _(resultant) _(bezout_resultant) _(implicit_coefficients) _(implicit_value)  \
    _(power_point) _(power_hodograph) _(power_derivatives) _(power_differences) _(power_difference_step)                     \
    _(power_scaled_difference_step) _(power_on_interval) _(cubic_minors) _(cubic_inflection_polynomial) _(cubic_delta)             \
    _(cubic_double_point_polynomial) _(cubic_double_point) _(shape_factors) _(shape_factors_printed) _(shape_basis)          \
    _(shape_basis_printed) _(shape_matrix) _(shape_bezier_points) _(shape_point) _(shape_point_printed)                \
    _(shape_derivatives) _(shape_surface_point) _(bezier_reduce) _(bspline_basis) _(bspline_basis_derivatives)         \
    _(bspline_discrete) _(bspline_blossom) _(bspline_deboor) _(bspline_derivatives) _(bspline_difference) _(bspline_greville)         \
    _(bspline_insert) _(bspline_remove) _(bspline_refine) _(bspline_elevate) _(bspline_reduce) _(bspline_to_bezier)    \
    _(bspline_point_of_bezier) _(bspline_split) _(bspline_periodic) _(nurbs_weight) _(nurbs_point) _(nurbs_deboor)     \
    _(nurbs_derivatives) _(nurbs_curvature_squared) _(nurbs_torsion) _(nurbs_insert) _(nurbs_basis)                    \
    _(nurbs_basis_by_weights) _(nurbs_by_weights) _(nurbs_by_two_weights) _(bezier_surface_transpose)                  \
    _(bezier_surface_line) _(bezier_surface_point) _(bezier_surface_derivatives) _(bezier_surface_normal)              \
    _(bezier_surface_part) _(hermite_blending) _(hermite_cubic) _(lagrange_blending) _(hermite_interpolant)            \
    _(coons_patch) _(hermite_tensor) _(divided_difference) _(confluent_vandermonde)                                    \
    _(confluent_vandermonde_determinant) _(divided_weights) _(bspline_matrix) _(bspline_column_by_differences)         \
    _(bspline_matrix_by_differences) _(marsden_coefficients) _(elementary_symmetric) _(marsden_matrix)                 \
    _(marsden_determinant) _(cofactor) _(bspline_matrix_by_marsden) _(bspline_matrix_simple) _(bspline_matrix_uniform) \
    _(bernstein_matrix)
/* clang-format on */

#define ENTRY(name) #name,
static const char *const names[] = {ALL_KERNELS(ENTRY)};
#undef ENTRY
enum {
    KERNELS = sizeof names / sizeof names[0],
    NUMBERS = MAX_ORDER * MAX_ORDER,
    WEIGHTS = MAX_DEGREE + 1,
    RESULTS = (MAX_DEGREE + 2) * (MAX_DEGREE + 1)
};
static int matrix_order(int n) { return n < MAX_ORDER ? n : MAX_ORDER; }

/* Copies of what a run reads, freed after it. */
static void *copies[64];
static int copied;
static const void *alone(const void *from, size_t bytes)
{
    assert_true(copied < (int)(sizeof copies / sizeof copies[0]));
    void *copy = copies[copied++] = malloc(bytes > 0 ? bytes : 1);
    assert_non_null(copy);
    return memcpy(copy, from, bytes);
}
static void free_copies(void)
{
    while (copied > 0)
        free(copies[--copied]);
}

#define G(name) name##_d
#include "proofs-tests/unit/kernel_runs.tmpl.h"
#undef G
#define G(name) name##_m
#include "proofs-tests/unit/kernel_runs.tmpl.h"
#undef G
#define G(name) name##_q
#include "proofs-tests/unit/kernel_runs.tmpl.h"
#undef G
#define G(name) name##_i
#include "proofs-tests/unit/kernel_runs.tmpl.h"
#undef G
#define G(name) name##_f
#include "proofs-tests/unit/kernel_runs.tmpl.h"
#undef G
#include "proofs-tests/unit/kernel_references.h"

static uint64_t seed_of(const char *name)
{
    uint64_t seed = 1469598103934665603u;
    while (*name != '\0')
        seed = (seed ^ (unsigned char)*name++) * 1099511628211u;
    return seed;
}
/* An integer in [low, high] (splitmix64). */
static int pick(uint64_t *seed, int low, int high)
{
    uint64_t z = (*seed += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return low + (int)((z ^ (z >> 31)) % (uint64_t)(high - low + 1));
}

/* The data of a trial are short dyadic numbers: the same in every number type.  Points and weights, which take long to be
 * put into all number types, are those of all kernels; degree, dimension, order and parameters are drawn for each kernel.
 * The first trials have t = 0, t = 1, the largest degree and dimension, and the least degree with most derivatives. */
static struct {
    double x_d[NUMBERS], w_d[WEIGHTS];
    num_m x_m[NUMBERS], w_m[WEIGHTS];
    num_q x_q[NUMBERS], w_q[WEIGHTS];
    num_i x_i[NUMBERS], w_i[WEIGHTS];
    num_f x_f[NUMBERS], w_f[WEIGHTS];
} drawn[TRIALS];

static void draw_points_and_weights(int trial)
{
    uint64_t seed = seed_of("points and weights") + (uint64_t)trial;
    for (int i = 0; i < NUMBERS; i++)
        drawn[trial].x_d[i] = (2 * pick(&seed, 0, 1) - 1) * pick(&seed, 1, 4095) * 0x1p-10;
    for (int i = 0; i < WEIGHTS; i++) {
        double square_root = pick(&seed, 3, 63) * 0x1p-4;
        drawn[trial].w_d[i] = square_root * square_root;
    }
#define IN_ALL_TYPES(name, count)                                                                                      \
    for (int i = 0; i < count; i++) {                                                                                  \
        drawn[trial].name##_m[i] = exact_m(drawn[trial].name##_d[i]);                                                  \
        drawn[trial].name##_q[i] = from_double_q(drawn[trial].name##_d[i]);                                            \
        drawn[trial].name##_i[i] = from_rational_i(drawn[trial].name##_q[i]);                                          \
        drawn[trial].name##_f[i] = from_rational_f(drawn[trial].name##_q[i]);                                          \
    }
    IN_ALL_TYPES(x, NUMBERS)
    IN_ALL_TYPES(w, WEIGHTS)
}

/* Kernels of rational curves put the weight beside the coordinates. */
static int largest_dim(const char *name)
{
    return strncmp(name, "rational_", 9) == 0 || strncmp(name, "nurbs_", 6) == 0 ? MAX_DIM - 1 : MAX_DIM;
}
static struct data_d draw(const char *name, int trial)
{
    uint64_t seed = seed_of(name) + (uint64_t)trial;
    int most = largest_dim(name);
    struct data_d D = {.x = drawn[trial].x_d, .w = drawn[trial].w_d};
    D.n = trial == 2 ? MAX_DEGREE : trial == 3 ? 1 : pick(&seed, 1, 7);
    D.dim = trial == 2 ? most : pick(&seed, 1, most);
    D.r = trial == 3 ? 5 : pick(&seed, 0, 5);
    int outside = trial % 3 == 2 && trial > 2;
    D.t = trial == 0 ? 0 : trial == 1 ? 1 : pick(&seed, outside ? -1023 : 1, outside ? 2047 : 1023) * 0x1p-10;
    D.u = pick(&seed, 1, 1023) * 0x1p-10;
    return D;
}

/* In every second trial the first and the last weight of a rational curve are below 0; a kernel that takes a root wants squares. */
static int has_negative_ends(const char *name, int trial)
{
    return trial % 2 == 1 &&
           (strncmp(name, "rational_", 9) == 0 || strncmp(name, "nurbs_", 6) == 0 ||
            strncmp(name, "implicit_", 9) == 0) &&
           strcmp(name, "rational_standard_form") != 0;
}
static double ends_d[WEIGHTS];
static num_m ends_m[WEIGHTS];
static num_q ends_q[WEIGHTS];
static num_i ends_i[WEIGHTS];
static num_f ends_f[WEIGHTS];

static num_i from_double_i(double x) { return from_rational_i(from_double_q(x)); }
static num_f from_double_f(double x) { return from_rational_f(from_double_q(x)); }

/* The same data in another number type. */
#define DATA_IN(suffix, from_double, D, trial)                                                                         \
    (struct data_##suffix)                                                                                             \
    {                                                                                                                  \
        (D).n, (D).dim, (D).r, drawn[trial].x_##suffix, drawn[trial].w_##suffix, from_double((D).t),                   \
            from_double((D).u)                                                                                         \
    }

/* |v - exact| <= bound, decided in rationals. */
static int within(double v, double bound, num_q exact)
{
    num_q gap = sub_q(from_double_q(v), exact);
    return cagd_compare_q(cagd_sign_q(gap) < 0 ? neg_q(gap) : gap, from_double_q(bound)) <= 0;
}

static num_d d[RESULTS];
static num_m m[RESULTS];
static num_q q[RESULTS], definition[RESULTS];
static num_i interval[RESULTS];
static num_f f[RESULTS];

static void kernel_agrees(void **state)
{
    int kernel = (int)(*(const char *const **)state - names), compared = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        region_mark mark = region_open();
        region_faults = 0;
        struct data_d D = draw(names[kernel], trial);
        struct data_m D_m = DATA_IN(m, exact_m, D, trial);
        struct data_q D_q = DATA_IN(q, from_double_q, D, trial);
        struct data_i D_i = DATA_IN(i, from_double_i, D, trial);
        struct data_f D_f = DATA_IN(f, from_double_f, D, trial);
#define NEGATIVE_ENDS(S, data, negative)                                                                               \
    memcpy(ends_##S, (data).w, sizeof ends_##S);                                                                       \
    ends_##S[0] = negative(ends_##S[0]);                                                                               \
    if (strncmp(names[kernel], "nurbs_", 6) != 0) /* there the others are distances of knots as well */                \
        ends_##S[D.n] = negative(ends_##S[D.n]);                                                                       \
    (data).w = ends_##S;
        if (has_negative_ends(names[kernel], trial)) {
            NEGATIVE_ENDS(d, D, neg_d)
            NEGATIVE_ENDS(m, D_m, neg_m)
            NEGATIVE_ENDS(q, D_q, neg_q)
            NEGATIVE_ENDS(i, D_i, neg_i)
            NEGATIVE_ENDS(f, D_f, neg_f)
        }
        int count = runs_d[kernel](&D, d);
        assert_int_equal(runs_m[kernel](&D_m, m), count);
        /* Room for these results and no more, so that a sanitizer sees what is written behind them. */
        num_q *exactly = malloc((size_t)count * sizeof exactly[0]);
        assert_int_equal(runs_q[kernel](&D_q, exactly), count);
        memcpy(q, exactly, (size_t)count * sizeof q[0]);
        free(exactly);
        assert_int_equal(runs_f[kernel](&D_f, f), count);
        references[kernel](&D_q, definition);
        if (region_faults != 0)
            fail_msg("%s, trial %d: faults %u", names[kernel], trial, region_faults);
        assert_int_equal(runs_i[kernel](&D_i, interval), count);
        free_copies();

        for (int k = 0; k < count; k++, compared++) {
            num_q constant;
            const char *wrong = !cagd_equal_q(q[k], definition[k])         ? "q is not the definition"
                                : memcmp(&d[k], &m[k].v, sizeof d[k]) != 0 ? "m is not d"
                                : !isfinite(error_bound_m(m[k]))           ? "no bound in m"
                                : !within(d[k], error_bound_m(m[k]), q[k]) ? "the bound of m is false"
                                : !contains_i(interval[k], q[k])           ? "i does not contain q"
                                : !is_constant_f(f[k], &constant) || !cagd_equal_q(constant, q[k]) ? "f is not q"
                                                                                                   : NULL;
            if (wrong != NULL)
                fail_msg("%s, trial %d (n %d, dim %d, r %d), result %d: %s", names[kernel], trial, D.n, D.dim, D.r, k,
                         wrong);
        }
        region_drop(mark);
    }
    assert_true(compared > 0);
}

/* In degree n the standard form has a rational root when w_0/w_n is an n-th power. */
static void standard_form_in_every_degree(void **state)
{
    (void)state;
    for (int n = 1; n <= 7; n++) {
        region_mark mark = region_open();
        num_q w[8], out[8], ratio = from_ratio_q(-1, 1);
        for (int i = 0; i < n; i++)
            w[i] = from_ratio_q(7 * i + 3, 5 + i);
        w[n] = w[0];
        for (int i = 0; i < n; i++)
            w[n] = mul_q(w[n], from_ratio_q(3, 2));
        region_faults = 0;
        rational_standard_form_q(n, w, out);
        assert_int_equal(region_faults, 0);
        assert_true(cagd_equal_q(out[0], from_int_q(1)) && cagd_equal_q(out[n], from_int_q(1)));
        /* The ratios out_i/w_i are a geometric progression with quotient 2/3. */
        for (int i = 1; i <= n; i++) {
            ratio = div_q(mul_q(out[i], w[i - 1]), mul_q(w[i], out[i - 1]));
            assert_true(cagd_equal_q(ratio, from_ratio_q(2, 3)));
        }
        region_drop(mark);
    }
}

static void assert_numbers(int count, const num_q got[], const int expected[], int over)
{
    for (int k = 0; k < count; k++)
        assert_true(cagd_equal_q(got[k], from_ratio_q(expected[k], over)));
}

/* Nodes 1, 1, 2, 2: a divided difference of t^5 of order 3 is the sum of all products of two nodes, 23. */
static void divided_differences_by_hand(void **state)
{
    (void)state;
    int two_double[2] = {2, 2}, double_and_simple[2] = {2, 1}, triple_and_simple[2] = {3, 1}, one = 1, three = 3;
    num_q tau[2] = {from_int_q(1), from_int_q(2)}, out[16];
    num_q fifth[4] = {from_int_q(1), from_int_q(5), from_int_q(32), from_int_q(80)};
    region_faults = 0;
    out[0] = divided_difference_q(2, two_double, tau, fifth);
    assert_numbers(1, out, (int[]){23}, 1);
    confluent_vandermonde_q(2, two_double, tau, out);
    assert_numbers(16, out, (int[]){1, 1, 1, 1, 0, 1, 2, 3, 1, 2, 4, 8, 0, 1, 4, 12}, 1);
    tau[1] = from_int_q(3);
    out[0] = confluent_vandermonde_determinant_q(2, two_double, tau);
    out[1] = confluent_vandermonde_determinant_q(2, triple_and_simple, tau);
    assert_numbers(2, out, (int[]){16, 16}, 1);
    /* [0,0,2]f = ((f(2) - f(0))/2 - f'(0))/2 */
    tau[0] = from_int_q(0), tau[1] = from_int_q(2);
    divided_weights_q(2, double_and_simple, tau, out);
    assert_numbers(3, out, (int[]){-1, -2, 1}, 4);
    /* One node: the value, and half of the second derivative. */
    out[0] = divided_difference_q(1, &one, tau, fifth);
    out[1] = divided_difference_q(1, &three, tau, fifth);
    divided_weights_q(1, &three, tau, out + 2);
    assert_numbers(5, out, (int[]){2, 32, 0, 0, 1}, 2);
    divided_weights_q(1, &one, tau, out);
    confluent_vandermonde_q(1, &one, tau, out + 1);
    out[2] = confluent_vandermonde_determinant_q(1, &one, tau);
    assert_numbers(3, out, (int[]){1, 1, 1}, 1);
    assert_int_equal(region_faults, 0);
    /* Two nodes that are said to be different and are not. */
    tau[1] = tau[0];
    out[0] = confluent_vandermonde_determinant_q(2, two_double, tau);
    assert_numbers(1, out, (int[]){0}, 1);
    assert_int_equal(region_faults, 0);
    divided_difference_q(2, two_double, tau, fifth);
    assert_int_equal(region_faults, FAULT_UNDEFINED);
    region_faults = 0;
    divided_weights_q(2, two_double, tau, out);
    assert_int_equal(region_faults, FAULT_UNDEFINED);
    region_faults = 0;
}

/* The cubic matrices of equidistant knots and of Bézier, as every textbook has them. */
static void matrices_by_hand(void **state)
{
    (void)state;
    static const int uniform[16] = {1, 4, 1, 0, -3, 0, 3, 0, 3, -6, 3, 0, -1, 3, -3, 1};
    static const int bezier[16] = {1, 0, 0, 0, -3, 3, 0, 0, 3, -6, 3, 0, -1, 3, -3, 1};
    num_q u[8], out[16], x[3] = {from_int_q(1), from_int_q(2), from_int_q(3)};
    int group[8];
    region_faults = 0;
    for (int kind = 0; kind < 2; kind++) {
        const int *expected = kind == 0 ? uniform : bezier, over = kind == 0 ? 6 : 1;
        for (int i = 0; i < 8; i++) {
            group[i] = kind == 0 ? i : i > 3;
            u[i] =
                from_ratio_q(5 * group[i] - 7, 3); /* the matrix does not see where the knots are, and how far apart */
        }
        bspline_matrix_q(3, u, 3, out);
        assert_numbers(16, out, expected, over);
        bspline_matrix_by_differences_q(3, u, group, 3, out);
        assert_numbers(16, out, expected, over);
        bspline_matrix_by_marsden_q(3, u, 3, out);
        assert_numbers(16, out, expected, over);
        if (kind == 0) {
            bspline_matrix_simple_q(3, u, 3, out);
            assert_numbers(16, out, expected, over);
            bspline_matrix_uniform_q(3, out);
        } else {
            bernstein_matrix_q(3, out);
        }
        assert_numbers(16, out, expected, over);
    }
    elementary_symmetric_q(3, x, out);
    assert_numbers(4, out, (int[]){1, 6, 11, 6}, 1);
    /* Knots 0, 1, ..., 5 and the span [2, 3]: t = 3/2 N_0 + 5/2 N_1 + 7/2 N_2, det = 2 1 2 / 2. */
    for (int i = 0; i < 6; i++)
        u[i] = from_int_q(group[i] = i);
    marsden_matrix_q(2, u, 2, out);
    assert_numbers(9, out, (int[]){2, 2, 2, 3, 5, 7, 4, 12, 24}, 2);
    out[1] = cofactor_q(3, out, 0, 1); /* -(3/2 12 - 7/2 2) */
    out[0] = marsden_determinant_q(2, u, 2);
    assert_numbers(2, out, (int[]){2, -11}, 1);
    marsden_coefficients_q(2, u, 2, from_int_q(10), out);
    assert_numbers(3, out, (int[]){72, 56, 42}, 1);
    /* Degree 0: one function, which is 1. */
    bspline_matrix_q(0, u, 0, out);
    bspline_matrix_by_differences_q(0, u, group, 0, out + 1);
    bspline_matrix_by_marsden_q(0, u, 0, out + 2);
    bspline_matrix_simple_q(0, u, 0, out + 3);
    bspline_matrix_uniform_q(0, out + 4);
    bernstein_matrix_q(0, out + 5);
    marsden_matrix_q(0, u, 0, out + 6);
    out[7] = marsden_determinant_q(0, u, 0);
    out[8] = cofactor_q(1, u, 0, 0);
    elementary_symmetric_q(0, u, out + 9);
    assert_numbers(10, out, (int[]){1, 1, 1, 1, 1, 1, 1, 1, 1, 1}, 1);
    assert_int_equal(region_faults, 0);
    /* The formula for simple knots: with two equal ones to the left of the span it is right, to the right undefined. */
    num_q same[9];
    u[1] = u[0];
    bspline_matrix_simple_q(2, u, 2, out);
    bspline_matrix_q(2, u, 2, same);
    assert_int_equal(region_faults, 0);
    for (int k = 0; k < 9; k++)
        assert_true(cagd_equal_q(out[k], same[k]));
    u[4] = u[3];
    bspline_matrix_simple_q(2, u, 2, out);
    assert_int_equal(region_faults, FAULT_UNDEFINED);
    region_faults = 0;
    /* An empty span. */
    out[0] = marsden_determinant_q(1, u, 0);
    assert_numbers(1, out, (int[]){0}, 1);
    assert_int_equal(region_faults, 0);
    for (int i = 0; i < 4; i++)
        u[i] = from_int_q(i - (i > 1));
    bspline_matrix_by_marsden_q(1, u, 1, out);
    assert_int_equal(region_faults, FAULT_UNDEFINED);
    region_faults = 0;
}

/* The line s(t) = t over simple knots 0, 1, 3, 4, 6, 7, 9, in degree 2; in degree 1 over 2, 3, 6, 7 its points are the inner knots. */
static void reduction_over_simple_knots(void **state)
{
    (void)state;
    static const int knots[] = {0, 1, 3, 4, 6, 7, 9}, lower[] = {2, 3, 6, 7}, span[] = {2, 3};
    num_q u[7], v[4], c[4], reduced[2];
    for (int i = 0; i < 7; i++)
        u[i] = from_int_q(knots[i]);
    for (int i = 0; i < 4; i++)
        v[i] = from_int_q(lower[i]), c[i] = from_ratio_q(knots[i + 1] + knots[i + 2], 2);
    struct spline_q s = {.degree = 2, .count = 4, .dim = 1, .knots = u, .points = c};
    region_faults = 0;
    bspline_reduce_q(&s, 2, v, span, reduced);
    assert_numbers(2, reduced, (int[]){3, 6}, 1);
    assert_int_equal(region_faults, 0);
}

/* What has no value is UNDEFINED; a root that is not rational is UNABLE. */
static void faults_are_told_apart(void **state)
{
    (void)state;
    num_q R[4] = {from_int_q(0), from_int_q(1), from_int_q(4), from_int_q(2)}, out[2];
    num_q cancel[2] = {from_int_q(1), from_int_q(-1)}, two[3] = {from_int_q(1), from_int_q(1), from_int_q(2)};
    region_faults = 0;
    rational_point_q(1, 2, R, cancel, from_ratio_q(1, 2), out);
    assert_int_equal(region_faults, FAULT_UNDEFINED);
    region_faults = 0;
    conic_standard_weight_q(two);
    assert_true(region_faults & FAULT_UNABLE);
    region_faults = 0;
}

static int open_numbers(void **state)
{
    (void)state;
    field_open(1);
    for (int trial = 0; trial < TRIALS; trial++)
        draw_points_and_weights(trial);
    return 0;
}
static int close_numbers(void **state)
{
    (void)state;
    region_free_all();
    field_close();
    mpfr_free_cache();
    return 0;
}

int main(void)
{
    struct CMUnitTest tests[KERNELS + 5] = {
        [KERNELS] = cmocka_unit_test(standard_form_in_every_degree),
        [KERNELS + 1] = cmocka_unit_test(faults_are_told_apart),
        [KERNELS + 2] = cmocka_unit_test(divided_differences_by_hand),
        [KERNELS + 3] = cmocka_unit_test(matrices_by_hand),
        [KERNELS + 4] = cmocka_unit_test(reduction_over_simple_knots),
    };
    for (int k = 0; k < KERNELS; k++)
        tests[k] = (struct CMUnitTest){names[k], kernel_agrees, NULL, NULL, (void *)&names[k]};
    return cmocka_run_group_tests(tests, open_numbers, close_numbers);
}
