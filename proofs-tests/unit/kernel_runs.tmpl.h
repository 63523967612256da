/* kernel_runs.tmpl.h -- each kernel once, on given data, for every number type.
 *
 * A run of the data D writes results to out and returns how many.  kernel_references.h computes the
 * same results from definitions. */
#include "core/number/generic_on.h"

struct G(data) {
    int n, dim, r;    /* 1 <= n <= MAX_DEGREE, 1 <= dim <= MAX_DIM, 0 <= r <= 5 */
    const num *x, *w; /* x: not 0; w: squares, positive; of rational curves the ends may be below 0 */
    num t, u;         /* u in [0,1], t mostly                                  */
};
typedef int G(runner)(const struct G(data) * D, num out[]);

/* Of an interval, which may be turned round. */
static inline num G(length)(const struct G(data) * D) { return D->r % 2 == 1 ? neg(D->w[0]) : D->w[0]; }

/* a[0] z^n + ... + a[n] = leading (z - z_1) ... (z - z_n). */
static inline void G(from_roots)(int n, num leading, const num z[], num a[])
{
    a[0] = leading;
    for (int k = 1; k <= n; k++) {
        a[k] = from_int(0);
        for (int i = k; i > 0; i--)
            a[i] = sub(a[i], mul(z[k - 1], a[i - 1]));
    }
}

/* The isosceles triangle M - v, M + k v', M + v, where v' is v turned by a right angle. */
static inline void G(isosceles)(const num M[], const num v[], num k, num R[])
{
    num turned[2] = {neg(v[1]), v[0]};
    for (int c = 0; c < 2; c++) {
        R[c] = sub(M[c], v[c]);
        R[2 + c] = add(M[c], mul(k, turned[c]));
        R[4 + c] = add(M[c], v[c]);
    }
}

/* The numbers that the contract of a kernel names, in a place of their own: a sanitizer sees what is read beyond them. */
#define ALONE(a, count) ((const num *)alone((a), (size_t)(count) * sizeof(num)))

#define RUN(name) static int G(run_##name)(const struct G(data) * D, num out[])

RUN(bernstein_basis)
{
    G(bernstein_basis)(D->n, D->t, out);
    return D->n + 1;
}
RUN(bernstein_derivatives)
{
    G(bernstein_derivatives)(D->n, D->t, D->r, out);
    return (D->r + 1) * (D->n + 1);
}
RUN(bernstein_product)
{
    int m = D->n + D->r <= MAX_DEGREE ? D->r : 0;
    G(bernstein_product)(D->n, ALONE(D->x, D->n + 1), m, ALONE(D->x + D->n + 1, m + 1), out);
    return D->n + m + 1;
}
RUN(bernstein_elevation_matrix)
{
    G(bernstein_elevation_matrix)(D->n, out);
    return (D->n + 2) * (D->n + 1);
}
RUN(bernstein_to_power)
{
    G(bernstein_to_power)(D->n, ALONE(D->x, D->n + 1), out);
    return D->n + 1;
}
RUN(bernstein_from_power)
{
    G(bernstein_from_power)(D->n, ALONE(D->x, D->n + 1), out);
    return D->n + 1;
}
RUN(bernstein_on_interval)
{
    G(bernstein_on_interval)(D->n, D->x[0], add(D->x[0], G(length)(D)), ALONE(D->x + 1, D->n + 1), D->t, D->u, out);
    return D->n + 1;
}
RUN(bezier_casteljau)
{
    G(bezier_casteljau)(D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), D->t, out);
    return D->dim;
}
RUN(bezier_horner)
{
    G(bezier_horner)(D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), D->t, out);
    return D->dim;
}
RUN(bezier_differences)
{
    int r = D->r % (D->n + 1);
    G(bezier_differences)(D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), r, out);
    return (D->n - r + 1) * D->dim;
}
RUN(bezier_derivatives)
{
    G(bezier_derivatives)(D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), D->t, D->r, out);
    return (D->r + 1) * D->dim;
}
RUN(bezier_split)
{
    int size = (D->n + 1) * D->dim;
    G(bezier_split)(D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), D->t, out, out + size);
    return 2 * size;
}
RUN(bezier_elevate)
{
    G(bezier_elevate)(D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), out);
    return (D->n + 2) * D->dim;
}
RUN(bezier_blossom)
{
    G(bezier_blossom)(D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), ALONE(D->w, D->n), out);
    return D->dim;
}
RUN(bezier_on_interval)
{
    G(bezier_on_interval)(D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), D->t, D->u, out);
    return (D->n + 1) * D->dim;
}

RUN(rational_homogenize)
{
    G(rational_homogenize)(D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), ALONE(D->w, D->n + 1), out);
    return (D->n + 1) * (D->dim + 1);
}
RUN(rational_dehomogenize)
{
    G(rational_dehomogenize)(D->n, D->dim, ALONE(D->x, (D->n + 1) * (D->dim + 1)), out, out + (D->n + 1) * D->dim);
    return (D->n + 1) * (D->dim + 1);
}
RUN(rational_weight)
{
    out[0] = G(rational_weight)(D->n, ALONE(D->w, D->n + 1), D->t);
    return 1;
}
RUN(rational_point)
{
    G(rational_point)(D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), ALONE(D->w, D->n + 1), D->t, out);
    return D->dim;
}
RUN(rational_derivatives)
{
    G(rational_derivatives)(D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), ALONE(D->w, D->n + 1), D->t, D->r, out);
    return (D->r + 1) * D->dim;
}
RUN(rational_casteljau)
{
    int r = D->r % (D->n + 1), count = D->n - r + 1;
    G(rational_casteljau)
    (D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), ALONE(D->w, D->n + 1), D->t, r, out, out + count * D->dim);
    return count * (D->dim + 1);
}
RUN(rational_split)
{
    int points = (D->n + 1) * D->dim, all = (D->n + 1) * (D->dim + 1);
    G(rational_split)
    (D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), ALONE(D->w, D->n + 1), D->t, out, out + points, out + all,
     out + all + points);
    return 2 * all;
}
RUN(rational_elevate)
{
    int n = D->n < MAX_DEGREE ? D->n : MAX_DEGREE - 1;
    G(rational_elevate)(n, D->dim, ALONE(D->x, (n + 1) * D->dim), ALONE(D->w, n + 1), out, out + (n + 2) * D->dim);
    return (n + 2) * (D->dim + 1);
}
RUN(rational_reparametrize)
{
    G(rational_reparametrize)(D->n, ALONE(D->w, D->n + 1), D->x[0], D->x[1], out);
    return D->n + 1;
}
RUN(rational_invariants)
{
    G(rational_invariants)(D->n, ALONE(D->w, D->n + 1), out);
    return D->n - 1;
}
/* Degree 2, where q has the root; see test_standard_form for other degrees. */
RUN(rational_standard_form)
{
    G(rational_standard_form)(2, ALONE(D->w, 3), out);
    return 3;
}

RUN(dot)
{
    out[0] = G(dot)(D->dim, ALONE(D->x, D->dim), ALONE(D->x + D->dim, D->dim));
    return 1;
}
RUN(norm_squared)
{
    out[0] = G(norm_squared)(D->dim, ALONE(D->x, D->dim));
    return 1;
}
RUN(cross2)
{
    out[0] = G(cross2)(ALONE(D->x, 2), ALONE(D->x + 2, 2));
    return 1;
}
RUN(cross3)
{
    G(cross3)(ALONE(D->x, 3), ALONE(D->x + 3, 3), out);
    return 3;
}
RUN(det3)
{
    out[0] = G(det3)(ALONE(D->x, 3), ALONE(D->x + 3, 3), ALONE(D->x + 6, 3));
    return 1;
}
RUN(gram)
{
    out[0] = G(gram)(D->dim, ALONE(D->x, D->dim), ALONE(D->x + D->dim, D->dim));
    return 1;
}
RUN(curvature_squared)
{
    out[0] = G(curvature_squared)(D->dim, ALONE(D->x, D->dim), ALONE(D->x + D->dim, D->dim));
    return 1;
}
/* d1 = a (1,2,2) and d2 = b (2,1,-2) + c d1 are chosen so that every root is rational. */
RUN(curvature)
{
    num a = D->x[0], b = D->x[1], c = D->x[2], two = from_int(2);
    num d1[3] = {a, mul(two, a), mul(two, a)}, across[3] = {mul(two, b), b, mul(from_int(-2), b)}, d2[3];
    for (int i = 0; i < 3; i++)
        d2[i] = add(across[i], mul(c, d1[i]));
    out[0] = G(curvature)(3, d1, d2);
    return 1;
}
/* d1 = a (3,4), d2 = b (-4,3) + c d1, a > 0. */
RUN(signed_curvature)
{
    num a = D->w[0], b = D->x[1], c = D->x[2];
    num d1[2] = {mul(from_int(3), a), mul(from_int(4), a)};
    num d2[2] = {add(mul(from_int(-4), b), mul(c, d1[0])), add(mul(from_int(3), b), mul(c, d1[1]))};
    out[0] = G(signed_curvature)(d1, d2);
    return 1;
}
RUN(torsion)
{
    out[0] = G(torsion)(ALONE(D->x, 3), ALONE(D->x + 3, 3), ALONE(D->x + 6, 3));
    return 1;
}
RUN(rational_curvature_squared)
{
    int n = D->n + (D->n == 1);
    out[0] = G(rational_curvature_squared)(n, 3, ALONE(D->x, 3 * (n + 1)), ALONE(D->w, n + 1), D->t);
    return 1;
}
RUN(rational_torsion)
{
    int n = D->n < 3 ? 3 : D->n;
    out[0] = G(rational_torsion)(n, ALONE(D->x, 3 * (n + 1)), ALONE(D->w, n + 1), D->t);
    return 1;
}

RUN(line_through)
{
    G(line_through)(ALONE(D->x, 2), ALONE(D->x + 2, 2), out);
    return 3;
}
RUN(line_pair)
{
    G(line_pair)(ALONE(D->x, 3), ALONE(D->x + 3, 3), out);
    return 6;
}
RUN(conic_pencil)
{
    G(conic_pencil)(D->t, ALONE(D->x, 6), ALONE(D->x + 6, 6), out);
    return 6;
}
RUN(conic_liming)
{
    G(conic_liming)(D->t, ALONE(D->x, 3), ALONE(D->x + 3, 3), ALONE(D->x + 6, 3), out);
    return 6;
}
RUN(conic_value)
{
    out[0] = G(conic_value)(ALONE(D->x, 6), D->x[6], D->x[7]);
    return 1;
}
RUN(conic_gradient)
{
    G(conic_gradient)(ALONE(D->x, 6), D->x[6], D->x[7], out);
    return 2;
}
RUN(conic_delta)
{
    out[0] = G(conic_delta)(ALONE(D->x, 6));
    return 1;
}
RUN(conic_determinant)
{
    out[0] = G(conic_determinant)(ALONE(D->x, 6));
    return 1;
}
RUN(conic_of_bezier)
{
    G(conic_of_bezier)(ALONE(D->x, 6), ALONE(D->w, 3), out);
    return 6;
}
RUN(conic_standard_weight)
{
    out[0] = G(conic_standard_weight)(ALONE(D->w, 3));
    return 1;
}
RUN(conic_shoulder_point)
{
    G(conic_shoulder_point)(ALONE(D->x, 6), ALONE(D->w, 3), out);
    return 2;
}
RUN(circular_arc_invariant)
{
    out[0] = G(circular_arc_invariant)(D->x[0], D->x[1]);
    return 1;
}
/* l = p^2 - q^2, h = 2pq with p > q > 0: then l^2 + h^2 is a square. */
RUN(circular_arc_weights)
{
    num q = D->w[0], p = add(q, D->w[1]);
    G(circular_arc_weights)(sub(mul(p, p), mul(q, q)), mul(from_int(2), mul(p, q)), out);
    return 3;
}
RUN(circular_arc_circle)
{
    num R[6];
    G(isosceles)(D->x, D->x + 2, D->w[0], R);
    out[2] = G(circular_arc_circle)(ALONE(R, 6), out);
    return 3;
}

RUN(determinant)
{
    int n = matrix_order(D->n);
    out[0] = G(determinant)(n, ALONE(D->x, n * n));
    return 1;
}
RUN(sylvester)
{
    int order = matrix_order(D->n), m = (order + 1) / 2;
    G(sylvester)(m, ALONE(D->x, m + 1), order - m, ALONE(D->x + m + 1, order - m + 1), out);
    return order * order;
}
RUN(bezout)
{
    int n = matrix_order(D->n);
    G(bezout)(n, ALONE(D->x, n + 1), ALONE(D->x + n + 1, n + 1), out);
    return n * n;
}
/* a and b with the leading coefficients w[0] and w[1] and the roots x and x + m. */
RUN(resultant)
{
    int order = matrix_order(D->n), m = (order + 1) / 2, n = order - m;
    num a[MAX_ORDER + 1], b[MAX_ORDER + 1];
    G(from_roots)(m, D->w[0], D->x, a);
    G(from_roots)(n, D->w[1], D->x + m, b);
    out[0] = G(resultant)(m, ALONE(a, m + 1), n, ALONE(b, n + 1));
    return 1;
}
RUN(bezout_resultant)
{
    int n = matrix_order(D->n) / 2 + 1;
    num a[MAX_ORDER + 1], b[MAX_ORDER + 1];
    G(from_roots)(n, D->w[0], D->x, a);
    G(from_roots)(n, D->w[1], D->x + n, b);
    out[0] = G(bezout_resultant)(n, ALONE(a, n + 1), ALONE(b, n + 1));
    return 1;
}
RUN(implicit_coefficients)
{
    G(implicit_coefficients)(D->n, ALONE(D->x, 2 * (D->n + 1)), ALONE(D->w, D->n + 1), 1, D->t, out);
    return D->n + 1;
}
RUN(implicit_value)
{
    int n = (matrix_order(D->n) + 1) / 2;
    out[0] = G(implicit_value)(n, ALONE(D->x, 2 * (n + 1)), ALONE(D->w, n + 1), D->t, D->x[2 * n + 2]);
    return 1;
}

RUN(power_point)
{
    G(power_point)(D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), D->t, out);
    return D->dim;
}
RUN(power_hodograph)
{
    for (int m = 0; m < (D->n + 1) * D->dim; m++)
        out[m] = D->x[m];
    G(power_hodograph)(D->n, D->dim, out);
    return (D->n + 1) * D->dim;
}
RUN(power_derivatives)
{
    G(power_derivatives)(D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), D->t, D->r, out);
    return (D->r + 1) * D->dim;
}
/* Degrees of a size whose differences keep digits in binary64. */
static inline int G(degree_of_table)(const struct G(data) * D) { return D->n <= 7 ? D->n : 7; }
RUN(power_differences)
{
    int n = G(degree_of_table)(D);
    G(power_differences)(n, D->dim, ALONE(D->x, (n + 1) * D->dim), D->t, out);
    return (n + 1) * D->dim;
}
/* The table of any numbers x, r steps on. */
RUN(power_difference_step)
{
    int n = G(degree_of_table)(D);
    for (int m = 0; m < (n + 1) * D->dim; m++)
        out[m] = D->x[m];
    for (int k = 0; k < D->r; k++)
        G(power_difference_step)(n, D->dim, out);
    return (n + 1) * D->dim;
}
RUN(power_scaled_difference_step)
{
    int n = G(degree_of_table)(D);
    for (int m = 0; m < (n + 1) * D->dim; m++)
        out[m] = D->x[m];
    for (int k = 0; k < D->r; k++)
        G(power_scaled_difference_step)(n, D->dim, D->t, out);
    return (n + 1) * D->dim;
}
RUN(power_on_interval)
{
    G(power_on_interval)(D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), D->t, D->u, out);
    return (D->n + 1) * D->dim;
}
/* Plane cubics with the coefficients x. */
RUN(cubic_minors)
{
    G(cubic_minors)(ALONE(D->x, 8), out);
    return 3;
}
RUN(cubic_inflection_polynomial)
{
    num m[3];
    G(cubic_minors)(ALONE(D->x, 8), m);
    G(cubic_inflection_polynomial)(ALONE(m, 3), out);
    return 3;
}
RUN(cubic_delta)
{
    num m[3];
    G(cubic_minors)(ALONE(D->x, 8), m);
    out[0] = G(cubic_delta)(ALONE(m, 3));
    return 1;
}
RUN(cubic_double_point_polynomial)
{
    num m[3];
    G(cubic_minors)(ALONE(D->x, 8), m);
    G(cubic_double_point_polynomial)(ALONE(m, 3), out);
    return 3;
}
/* A cubic with a double point in x[0], x[1]: (t - x_2)(t - x_3)(L t + M) + N. */
RUN(cubic_double_point)
{
    num m[3], c[8], sum = add(D->x[2], D->x[3]), product = mul(D->x[2], D->x[3]);
    for (int j = 0; j < 2; j++) {
        num L = D->w[j], M = D->x[6 + j];
        c[j] = add(mul(product, M), D->x[j]);
        c[2 + j] = sub(mul(product, L), mul(sum, M));
        c[4 + j] = sub(M, mul(sum, L));
        c[6 + j] = L;
    }
    G(cubic_minors)(ALONE(c, 8), m);
    G(cubic_double_point)(ALONE(c, 8), ALONE(m, 3), out);
    return 2;
}

/* Degrees of the family with a shape parameter: 2 to MAX_DEGREE - 1. */
static inline int G(shape_degree)(int n) { return n < 2 ? 2 : n < MAX_DEGREE ? n : MAX_DEGREE - 1; }

RUN(shape_factors)
{
    int n = G(shape_degree)(D->n);
    G(shape_factors)(n, D->x[0], out, out + n + 1);
    return 2 * n + 2;
}
RUN(shape_factors_printed)
{
    G(shape_factors_printed)(D->x[0], out, out + 8);
    return 16;
}
RUN(shape_basis)
{
    int n = G(shape_degree)(D->n);
    G(shape_basis)(n, D->x[0], D->t, out);
    return n + 1;
}
RUN(shape_basis_printed)
{
    G(shape_basis_printed)(D->x[0], D->t, out);
    return 8;
}
RUN(shape_matrix)
{
    int n = G(shape_degree)(D->n);
    G(shape_matrix)(n, ALONE(D->x, n + 1), ALONE(D->x + n + 1, n + 1), out);
    return (n + 2) * (n + 1);
}
RUN(shape_bezier_points)
{
    int n = G(shape_degree)(D->n);
    G(shape_bezier_points)(n, D->dim, ALONE(D->x + 1, (n + 1) * D->dim), D->x[0], out);
    return (n + 2) * D->dim;
}
RUN(shape_point)
{
    int n = G(shape_degree)(D->n);
    G(shape_point)(n, D->dim, ALONE(D->x + 1, (n + 1) * D->dim), D->x[0], D->t, out);
    return D->dim;
}
RUN(shape_point_printed)
{
    G(shape_point_printed)(D->dim, ALONE(D->x + 1, 8 * D->dim), D->x[0], D->t, out);
    return D->dim;
}
RUN(shape_derivatives)
{
    int n = G(shape_degree)(D->n);
    G(shape_derivatives)(n, D->dim, ALONE(D->x + 1, (n + 1) * D->dim), D->x[0], D->t, D->r, out);
    return (D->r + 1) * D->dim;
}
RUN(shape_surface_point)
{
    G(shape_surface_point)(3, 2, D->dim, ALONE(D->x + 2, 12 * D->dim), D->x[0], D->x[1], D->t, D->u, out);
    return D->dim;
}

#include "core/number/generic_off.h"
#include "core/number/generic_on.h"
#include "proofs-tests/unit/spline_runs.tmpl.h"
#include "proofs-tests/unit/matrix_runs.tmpl.h"
#include "proofs-tests/unit/surface_runs.tmpl.h"

#define ENTRY(name) G(run_##name),
static G(runner) *const G(runs)[] = {ALL_KERNELS(ENTRY)};
#undef ENTRY
#undef RUN
#undef ALONE
#include "core/number/generic_off.h"
