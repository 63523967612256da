/* surface_runs.tmpl.h -- the kernels on surfaces and on given values and derivatives, each once; a part of
 * kernel_runs.tmpl.h. */
#include "core/number/generic_on.h"

/* The second degree of a surface: the net of D has (n+1)(m+1) points. */
static inline int G(other_degree)(const struct G(data) * D) { return D->n <= 7 ? D->r + 1 : 1; }

/* Different nodes, as many as `count`. */
static inline void G(different_nodes)(const struct G(data) * D, int count, num tau[])
{
    tau[0] = D->x[0];
    for (int i = 1; i < count; i++)
        tau[i] = add(tau[i - 1], D->w[i]);
}

/* How often each of three nodes counts; returns the sum. */
static inline int G(three_multiplicities)(const struct G(data) * D, int l[])
{
    l[0] = 1 + D->r % 3;
    l[1] = 1;
    l[2] = 1 + D->n % 3;
    return l[0] + l[1] + l[2];
}

RUN(bezier_surface_transpose)
{
    int m = G(other_degree)(D);
    G(bezier_surface_transpose)(G(net)(D->n, m, D->dim, ALONE(D->x, (D->n + 1) * (m + 1) * D->dim)), out);
    return (D->n + 1) * (m + 1) * D->dim;
}
RUN(bezier_surface_line)
{
    int m = G(other_degree)(D);
    G(bezier_surface_line)(G(net)(D->n, m, D->dim, ALONE(D->x, (D->n + 1) * (m + 1) * D->dim)), D->t, out);
    return (m + 1) * D->dim;
}
RUN(bezier_surface_point)
{
    int m = G(other_degree)(D);
    G(bezier_surface_point)(G(net)(D->n, m, D->dim, ALONE(D->x, (D->n + 1) * (m + 1) * D->dim)), D->t, D->u, out);
    return D->dim;
}
RUN(bezier_surface_derivatives)
{
    int m = G(other_degree)(D);
    G(bezier_surface_derivatives)
    (G(net)(D->n, m, D->dim, ALONE(D->x, (D->n + 1) * (m + 1) * D->dim)), D->t, D->u, D->r, 3, out);
    return (D->r + 1) * 4 * D->dim;
}
RUN(bezier_surface_normal)
{
    int m = G(other_degree)(D);
    G(bezier_surface_normal)(G(net)(D->n, m, 3, ALONE(D->x, (D->n + 1) * (m + 1) * 3)), D->t, D->u, out);
    return 3;
}
/* Degrees that cost little; bezier_on_interval has the others. */
static inline int G(degree_of_part)(const struct G(data) * D) { return D->n <= 7 ? D->n : 7; }
RUN(bezier_surface_part)
{
    int n = G(degree_of_part)(D), m = G(other_degree)(D);
    G(bezier_surface_part)
    (G(net)(n, m, D->dim, ALONE(D->x, (n + 1) * (m + 1) * D->dim)), D->t, D->u, from_ratio(1, 4), D->t, out);
    return (n + 1) * (m + 1) * D->dim;
}
RUN(hermite_blending)
{
    G(hermite_blending)(D->x[0], add(D->x[0], G(length)(D)), D->t, D->r, out);
    return 4 * (D->r + 1);
}
RUN(hermite_cubic)
{
    G(hermite_cubic)(D->dim, D->x[0], add(D->x[0], G(length)(D)), ALONE(D->x + 1, 4 * D->dim), D->t, D->r, out);
    return (D->r + 1) * D->dim;
}
RUN(lagrange_blending)
{
    int n = D->n <= 7 ? D->n : 7;
    num tau[8];
    G(different_nodes)(D, n + 1, tau);
    G(lagrange_blending)(n, ALONE(tau, n + 1), D->t, out);
    return n + 1;
}
RUN(hermite_interpolant)
{
    int l[3], count = G(three_multiplicities)(D, l);
    num tau[3];
    G(different_nodes)(D, 3, tau);
    G(hermite_interpolant)(3, l, ALONE(tau, 3), ALONE(D->x + 1, count), out);
    return count;
}
/* Blending values, data across, data along, corners. */
RUN(coons_patch)
{
    int m = D->r % 2 == 0 ? 2 : 4;
    G(coons_patch)
    (m, D->dim, ALONE(D->x, m), ALONE(D->x + 4, m), ALONE(D->x + 8, m * D->dim), ALONE(D->x + 20, m * D->dim),
     ALONE(D->x + 32, m * m * D->dim), out);
    return D->dim;
}
RUN(hermite_tensor)
{
    G(hermite_tensor)(D->dim, ALONE(D->x, 16 * D->dim), D->t, D->u, D->r % 4, D->n % 4, out);
    return D->dim;
}
#include "core/number/generic_off.h"
