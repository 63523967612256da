/* matrix_runs.tmpl.h -- divided differences and coefficient matrices, each kernel once; a part of kernel_runs.tmpl.h. */
#include "core/number/generic_on.h"

/* n+1 <= 7 nodes in d different places, of multiplicities 1, 2 and 3 in turn. */
struct G(nodes) {
    int n, d, l[8];
    num tau[8];
};

static inline struct G(nodes) G(nodes_of)(const struct G(data) * D)
{
    struct G(nodes) S = {.n = D->n < 6 ? D->n : 6};
    for (int left = S.n + 1; left > 0; left -= S.l[S.d++]) {
        int times = 1 + (S.d + D->r) % 3;
        S.l[S.d] = times < left ? times : left;
        S.tau[S.d] = S.d == 0 ? D->x[0] : add(S.tau[S.d - 1], D->w[S.d]);
    }
    return S;
}

/* The same data with simple knots. */
static inline struct G(knotted) G(simple_knotted_of)(const struct G(data) * D)
{
    struct G(data) simple = *D;
    simple.r = 2;
    return G(knotted_of)(&simple);
}

RUN(divided_difference)
{
    struct G(nodes) S = G(nodes_of)(D);
    out[0] = G(divided_difference)(S.d, S.l, ALONE(S.tau, S.d), ALONE(D->x + 1, S.n + 1));
    return 1;
}
RUN(confluent_vandermonde)
{
    struct G(nodes) S = G(nodes_of)(D);
    G(confluent_vandermonde)(S.d, S.l, ALONE(S.tau, S.d), out);
    return (S.n + 1) * (S.n + 1);
}
RUN(confluent_vandermonde_determinant)
{
    struct G(nodes) S = G(nodes_of)(D);
    out[0] = G(confluent_vandermonde_determinant)(S.d, S.l, ALONE(S.tau, S.d));
    return 1;
}
RUN(divided_weights)
{
    struct G(nodes) S = G(nodes_of)(D);
    G(divided_weights)(S.d, S.l, ALONE(S.tau, S.d), out);
    return S.n + 1;
}
RUN(bspline_matrix)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(bspline_matrix)(S.p, ALONE(S.u, S.n + S.p + 1), S.mu, out);
    return (S.p + 1) * (S.p + 1);
}
RUN(bspline_column_by_differences)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(bspline_column_by_differences)(S.p, ALONE(S.u, S.n + S.p + 1), S.place, S.mu - D->r % (S.p + 1), S.mu, out);
    return S.p + 1;
}
RUN(bspline_matrix_by_differences)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(bspline_matrix_by_differences)(S.p, ALONE(S.u, S.n + S.p + 1), S.place, S.mu, out);
    return (S.p + 1) * (S.p + 1);
}
RUN(marsden_coefficients)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(marsden_coefficients)(S.p, ALONE(S.u, S.n + S.p + 1), S.mu, D->x[1], out);
    return S.p + 1;
}
RUN(elementary_symmetric)
{
    int n = D->n < 7 ? D->n : 7;
    G(elementary_symmetric)(n, ALONE(D->x, n), out);
    return n + 1;
}
RUN(marsden_matrix)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(marsden_matrix)(S.p, ALONE(S.u, S.n + S.p + 1), S.mu, out);
    return (S.p + 1) * (S.p + 1);
}
RUN(marsden_determinant)
{
    struct G(knotted) S = G(knotted_of)(D);
    out[0] = G(marsden_determinant)(S.p, ALONE(S.u, S.n + S.p + 1), S.mu);
    return 1;
}
RUN(cofactor)
{
    int n = D->n < 6 ? D->n : 6;
    out[0] = G(cofactor)(n, ALONE(D->x, n * n), D->r % n, D->dim % n);
    return 1;
}
RUN(bspline_matrix_by_marsden)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(bspline_matrix_by_marsden)(S.p, ALONE(S.u, S.n + S.p + 1), S.mu, out);
    return (S.p + 1) * (S.p + 1);
}
RUN(bspline_matrix_simple)
{
    struct G(knotted) S = G(simple_knotted_of)(D);
    G(bspline_matrix_simple)(S.p, ALONE(S.u, S.n + S.p + 1), S.mu, out);
    return (S.p + 1) * (S.p + 1);
}
RUN(bspline_matrix_uniform)
{
    int p = D->n < 6 ? D->n : 6;
    G(bspline_matrix_uniform)(p, out);
    return (p + 1) * (p + 1);
}
RUN(bernstein_matrix)
{
    int p = D->n < 8 ? D->n : 8;
    G(bernstein_matrix)(p, out);
    return (p + 1) * (p + 1);
}
#include "core/number/generic_off.h"
