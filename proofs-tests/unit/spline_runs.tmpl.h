/* spline_runs.tmpl.h -- the kernels on B-splines and NURBS curves, each once; a part of kernel_runs.tmpl.h.
 *
 * The spline of the data: degree p <= 5, p+4 points, four intervals in the domain, or three with a double knot in the
 * middle; the ends simple or clamped.  place says which knots are equal. */
#include "core/number/generic_on.h"

struct G(knotted) {
    int p, n, mu, place[24];
    num u[24], t; /* u_mu < t < u_{mu+1} */
};

static inline struct G(knotted) G(knotted_of)(const struct G(data) * D)
{
    struct G(knotted) S;
    int p = S.p = D->n < 5 ? D->n : 5, n = S.n = p + 4, clamped = D->r % 3 == 0, twice = D->r % 2 == 1;
    S.mu = p + 2;
    S.u[0] = D->x[0];
    S.place[0] = 0;
    for (int i = 1; i <= n + p; i++) {
        int same = (clamped && (i <= p || i > n)) || (twice && i == p + 2);
        S.u[i] = same ? S.u[i - 1] : add(S.u[i - 1], D->w[i]);
        S.place[i] = S.place[i - 1] + !same;
    }
    num part = add(from_ratio(1, 4), mul(from_ratio(1, 2), D->t));
    S.t = add(S.u[S.mu], mul(part, sub(S.u[S.mu + 1], S.u[S.mu])));
    return S;
}

/* The knots of the spline with t twice; n+2 points.  v_j lies in the span of span[j], or ends beyond it. */
static inline void G(refined_knots)(const struct G(knotted) * S, num v[], int span[])
{
    for (int i = 0; i <= S->n + S->p + 2; i++)
        v[i] = i <= S->mu ? S->u[i] : i <= S->mu + 2 ? S->t : S->u[i - 2];
    for (int j = 0; j < S->n + 2;
         j++) { /* a span between v_j and v_{j+p+1}: the nearest of u on the right of u_j, or of t */
        int at = j <= S->mu ? j : j <= S->mu + 2 ? S->mu : j - 2;
        at = at < S->p ? S->p : at;
        while (S->place[at] == S->place[at + 1])
            at++;
        span[j] = at;
    }
}

/* The knots of degree p+1, every knot of the domain once more; returns the number of points. */
static inline int G(elevated_knots)(const struct G(knotted) * S, num v[], int span[])
{
    int count = 0, from[48];
    for (int i = 0; i <= S->n + S->p; i++) {
        int last = i == S->n + S->p || S->place[i] < S->place[i + 1];
        int inside = S->place[S->p] <= S->place[i] && S->place[i] <= S->place[S->n];
        for (int times = 1 + (last && inside); times > 0; times--) {
            from[count] = i;
            v[count++] = S->u[i];
        }
    }
    int m = count - S->p - 2;
    for (int j = 0; j < m; j++) {
        int l = j < S->p + 1 ? S->p + 1 : j;
        while (S->place[from[l]] == S->place[from[l + 1]])
            l++;
        span[j] = from[l];
    }
    return m;
}

RUN(bezier_reduce)
{
    num defect[MAX_DIM];
    G(bezier_reduce)(D->n, D->dim, ALONE(D->x, (D->n + 1) * D->dim), out, defect);
    for (int c = 0; c < D->dim; c++)
        out[D->n * D->dim + c] = defect[c];
    return (D->n + 1) * D->dim;
}
RUN(bspline_basis)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(bspline_basis)(S.p, ALONE(S.u, S.n + S.p + 1), S.mu, S.t, out);
    return S.p + 1;
}
RUN(bspline_basis_derivatives)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(bspline_basis_derivatives)(S.p, ALONE(S.u, S.n + S.p + 1), S.mu, S.t, D->r, out);
    return (D->r + 1) * (S.p + 1);
}
RUN(bspline_discrete)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(bspline_discrete)(S.p, ALONE(S.u, S.n + S.p + 1), S.mu, ALONE(D->x, S.p), out);
    return S.p + 1;
}
RUN(bspline_blossom)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(bspline_blossom)
    (G(on_span)(S.p, D->dim, ALONE(S.u, S.n + S.p + 1), S.mu, ALONE(D->x, S.n * D->dim)), ALONE(D->w, S.p), out);
    return D->dim;
}
RUN(bspline_deboor)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(bspline_deboor)(G(on_span)(S.p, D->dim, ALONE(S.u, S.n + S.p + 1), S.mu, ALONE(D->x, S.n * D->dim)), S.t, out);
    return D->dim;
}
RUN(bspline_derivatives)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(bspline_derivatives)
    (G(on_span)(S.p, D->dim, ALONE(S.u, S.n + S.p + 1), S.mu, ALONE(D->x, S.n * D->dim)), S.t, D->r, out);
    return (D->r + 1) * D->dim;
}
/* The derivative at t of the spline of the difference points. */
RUN(bspline_difference)
{
    struct G(knotted) S = G(knotted_of)(D);
    num e[64];
    if (D->r % 2 == 1 && S.p == 1) { /* the double knot would be one of multiplicity p+1 */
        out[0] = from_int(0);
        return 1;
    }
    G(bspline_difference)(S.n, S.p, D->dim, ALONE(S.u, S.n + S.p + 1), ALONE(D->x, S.n * D->dim), e);
    G(bspline_deboor)(G(on_span)(S.p - 1, D->dim, S.u + 1, S.mu - 1, e), S.t, out);
    return D->dim;
}
RUN(bspline_greville)
{
    struct G(knotted) S = G(knotted_of)(D);
    for (int i = 0; i < S.n; i++)
        out[i] = G(bspline_greville)(S.p, ALONE(S.u, S.n + S.p + 1), i);
    return S.n;
}
RUN(bspline_insert)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(bspline_insert)
    (spline(S.p, S.n, D->dim, ALONE(S.u, S.n + S.p + 1), ALONE(D->x, S.n * D->dim)), S.mu, S.t, out,
     out + S.n + S.p + 2);
    return S.n + S.p + 2 + (S.n + 1) * D->dim;
}
/* What was inserted is removed. */
RUN(bspline_remove)
{
    struct G(knotted) S = G(knotted_of)(D);
    num u[32], c[64], *b = out + S.n + S.p + 1;
    G(bspline_insert)(spline(S.p, S.n, D->dim, ALONE(S.u, S.n + S.p + 1), ALONE(D->x, S.n * D->dim)), S.mu, S.t, u, c);
    G(bspline_remove)
    (spline(S.p, S.n + 1, D->dim, ALONE(u, S.n + S.p + 2), ALONE(c, (S.n + 1) * D->dim)), S.mu + 1, 1, out, b,
     b + S.n * D->dim);
    return S.n + S.p + 1 + (S.n + 1) * D->dim;
}
RUN(bspline_refine)
{
    struct G(knotted) S = G(knotted_of)(D);
    num v[32];
    int span[32];
    G(refined_knots)(&S, v, span);
    G(bspline_refine)
    (spline(S.p, S.n, D->dim, ALONE(S.u, S.n + S.p + 1), ALONE(D->x, S.n * D->dim)), S.n + 2, ALONE(v, S.n + S.p + 3),
     span, out);
    return (S.n + 2) * D->dim;
}
/* The point at t of the elevated spline. */
RUN(bspline_elevate)
{
    struct G(knotted) S = G(knotted_of)(D);
    num v[48], d[128];
    int span[48], m = G(elevated_knots)(&S, v, span), nu = 0;
    G(bspline_elevate)
    (spline(S.p, S.n, D->dim, ALONE(S.u, S.n + S.p + 1), ALONE(D->x, S.n * D->dim)), m, ALONE(v, m + S.p + 2), span, d);
    for (int j = 0; j < m; j++)
        nu = span[j] == S.mu ? j : nu; /* the last knot of v at u_mu is the last with this span */
    G(bspline_deboor)(G(on_span)(S.p + 1, D->dim, v, nu, d), S.t, out);
    return D->dim;
}
/* What was elevated is reduced. */
RUN(bspline_reduce)
{
    struct G(knotted) S = G(knotted_of)(D);
    num v[48], d[128];
    int span[48], down[32] = {0}, m = G(elevated_knots)(&S, v, span);
    G(bspline_elevate)
    (spline(S.p, S.n, D->dim, ALONE(S.u, S.n + S.p + 1), ALONE(D->x, S.n * D->dim)), m, ALONE(v, m + S.p + 2), span, d);
    for (int j = 0; j < S.n; j++) { /* the span of v in which the first interval of point j lies */
        int at = j < S.p ? S.p : j;
        while (S.place[at] == S.place[at + 1])
            at++;
        for (int l = 0; l < m; l++)
            down[j] = span[l] == at ? l : down[j];
    }
    G(bspline_reduce)
    (spline(S.p + 1, m, D->dim, ALONE(v, m + S.p + 2), ALONE(d, m * D->dim)), S.n, ALONE(S.u, S.n + S.p + 1), down,
     out);
    return S.n * D->dim;
}
RUN(bspline_to_bezier)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(bspline_to_bezier)(G(on_span)(S.p, D->dim, ALONE(S.u, S.n + S.p + 1), S.mu, ALONE(D->x, S.n * D->dim)), out);
    return (S.p + 1) * D->dim;
}
RUN(bspline_point_of_bezier)
{
    num to = add(D->x[0], G(length)(D));
    int p = D->n < 7 ? D->n : 7;
    G(bspline_point_of_bezier)(p, D->dim, ALONE(D->x, (p + 1) * D->dim), D->x[0], to, ALONE(D->w, p), out);
    return D->dim;
}
/* The points of both parts. */
RUN(bspline_split)
{
    struct G(knotted) S = G(knotted_of)(D);
    num v[32], w[32];
    int left = (S.mu + 1) * D->dim, right = (S.n - S.mu + S.p) * D->dim;
    G(bspline_split)
    (spline(S.p, S.n, D->dim, ALONE(S.u, S.n + S.p + 1), ALONE(D->x, S.n * D->dim)), S.mu, 0, S.t, v, out, w,
     out + left);
    return left + right;
}
RUN(bspline_periodic)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(bspline_periodic)
    (S.n, S.p, D->dim, ALONE(S.u, S.n + S.p + 1), ALONE(D->x, S.n * D->dim), out, out + S.n + 2 * S.p + 1);
    return S.n + 2 * S.p + 1 + (S.n + S.p) * D->dim;
}
RUN(nurbs_weight)
{
    struct G(knotted) S = G(knotted_of)(D);
    out[0] = G(nurbs_weight)(G(nurbs_on_span)(S.p, 0, ALONE(S.u, S.n + S.p + 1), S.mu, NULL, ALONE(D->w, S.n)), S.t);
    return 1;
}
RUN(nurbs_point)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(nurbs_point)
    (G(nurbs_on_span)(S.p, D->dim, ALONE(S.u, S.n + S.p + 1), S.mu, ALONE(D->x, S.n * D->dim), ALONE(D->w, S.n)), S.t,
     out);
    return D->dim;
}
RUN(nurbs_deboor)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(nurbs_deboor)
    (G(nurbs_on_span)(S.p, D->dim, ALONE(S.u, S.n + S.p + 1), S.mu, ALONE(D->x, S.n * D->dim), ALONE(D->w, S.n)), S.t,
     out);
    return D->dim;
}
RUN(nurbs_derivatives)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(nurbs_derivatives)
    (G(nurbs_on_span)(S.p, D->dim, ALONE(S.u, S.n + S.p + 1), S.mu, ALONE(D->x, S.n * D->dim), ALONE(D->w, S.n)), S.t,
     D->r, out);
    return (D->r + 1) * D->dim;
}
RUN(nurbs_curvature_squared)
{
    struct G(knotted) S = G(knotted_of)(D);
    out[0] = G(nurbs_curvature_squared)(
        G(nurbs_on_span)(S.p, 3, ALONE(S.u, S.n + S.p + 1), S.mu, ALONE(D->x, 3 * S.n), ALONE(D->w, S.n)), S.t);
    return 1;
}
RUN(nurbs_torsion)
{
    struct G(data) E = *D;
    E.n = D->n < 3 ? 3 : D->n;
    struct G(knotted) S = G(knotted_of)(&E);
    out[0] = G(nurbs_torsion)(
        G(nurbs_on_span)(S.p, 3, ALONE(S.u, S.n + S.p + 1), S.mu, ALONE(D->x, 3 * S.n), ALONE(D->w, S.n)), S.t);
    return 1;
}
RUN(nurbs_insert)
{
    struct G(knotted) S = G(knotted_of)(D);
    num v[32];
    G(nurbs_insert)
    (nurbs(S.p, S.n, D->dim, ALONE(S.u, S.n + S.p + 1), ALONE(D->x, S.n * D->dim), ALONE(D->w, S.n)), S.mu, S.t, v, out,
     out + (S.n + 1) * D->dim);
    return (S.n + 1) * (D->dim + 1);
}
RUN(nurbs_basis)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(nurbs_basis)(G(nurbs_on_span)(S.p, 0, ALONE(S.u, S.n + S.p + 1), S.mu, NULL, ALONE(D->w, S.n)), S.t, D->r, out);
    return (D->r + 1) * (S.p + 1);
}
RUN(nurbs_basis_by_weights)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(nurbs_basis_by_weights)
    (G(nurbs_on_span)(S.p, 0, ALONE(S.u, S.n + S.p + 1), S.mu, NULL, ALONE(D->w, S.n)), S.t, out);
    return (S.p + 1) * (S.p + 1);
}
RUN(nurbs_by_weights)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(nurbs_by_weights)
    (G(nurbs_on_span)(S.p, D->dim, ALONE(S.u, S.n + S.p + 1), S.mu, ALONE(D->x, S.n * D->dim), ALONE(D->w, S.n)), S.t,
     D->r, out);
    return (D->r + 1) * (S.p + 1) * D->dim;
}
RUN(nurbs_by_two_weights)
{
    struct G(knotted) S = G(knotted_of)(D);
    G(nurbs_by_two_weights)
    (G(nurbs_on_span)(S.p, D->dim, ALONE(S.u, S.n + S.p + 1), S.mu, ALONE(D->x, S.n * D->dim), ALONE(D->w, S.n)), S.t,
     out);
    return (S.p + 1) * (S.p + 1) * D->dim;
}
#include "core/number/generic_off.h"
