/*
# Rational B-splines (有理 B 样条)

A NURBS curve is a quotient, $R(t)=\sum N_{i,p}(t)w_iR_i\big/\sum N_{i,p}(t)w_i$, and a spline in homogeneous coordinates
$(w_iR_i,w_i)$.  The kernels keep weights and points apart.
*/
#include "chapters/nurbs/definition.h"
#include "chapters/nurbs/patterns.h"

#include "chapters/judge/claims_on.h"

enum { dim = FIELD ? 1 : 2 }; /* every formula is taken coordinate by coordinate: the field takes one */

/* n free points and weights. */
static void G(free_nurbs)(trial *T, int n, int d, num R[], num w[])
{
    G(free_control_points)(T, n, d, R);
    for (int i = 0; i < n; i++)
        w[i] = unknown(T, "q", i);
}

/*
:::{claim} nurbs_point_is_the_quotient
:title: The kernel computes the quotient of the two sums
:zh: NURBS 曲线上的点
:given: several segments, the distinct knots variables, points and weights; every interval of the domain; any $t$
:then: `nurbs_homogenize` gives $(w_iR_i,w_i)$ for the points of the span, `nurbs_weight` gives $w(t)=\sum_{i=0}^{n-1}N_{i,p}(t)w_i$,
  `nurbs_point` and `nurbs_deboor` give $R(t)$
:method: The kernels against sums of all $n$ terms, with the B-splines from the recursion of de Boor and Cox by its letter.
:degrees: 0..6 sampled 7
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:over: q#: weights
:defines: nurbs_homogenize nurbs_weight nurbs_point nurbs_deboor
:control: the weights taken backwards
:::
*/
CLAIM(nurbs_point_is_the_quotient)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num R[MOST_KNOTS * dim], w[MOST_KNOTS], z[MOST_KNOTS], P[dim], Q[dim], H[(HIGHEST + 1) * (dim + 1)];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(free_nurbs)(T, K.n, dim, R, w);
        for (int i = 0; i < K.n; i++)
            z[i] = w[fault(T, i, K.n - 1 - i)];
        for (int mu = p; mu < K.n; mu++) {
            if (K.place[mu] == K.place[mu + 1])
                continue;
            num t = parameter(T, "t");
            G(nurbs_homogenize)(G(nurbs_on_span)(p, dim, NULL, mu, R, z), H);
            about(T, "homogeneous points");
            for (int m = 0; m <= p; m++) {
                same(T, H[m * (dim + 1) + dim], w[mu - p + m]);
                for (int e = 0; e < dim; e++)
                    same(T, H[m * (dim + 1) + e], mul(w[mu - p + m], R[(mu - p + m) * dim + e]));
            }
            num total = from_int(0), sum[dim];
            for (int e = 0; e < dim; e++)
                sum[e] = from_int(0);
            for (int i = 0; i < K.n; i++) {
                num share = mul(G(cox_de_boor)(p, K.u, K.place, i, K.place[mu], t), w[i]);
                total = add(total, share);
                for (int e = 0; e < dim; e++)
                    sum[e] = add(sum[e], mul(share, R[i * dim + e]));
            }
            about(T, "the weight");
            same(T, G(nurbs_weight)(G(nurbs_on_span)(p, 0, K.u, mu, NULL, z), t), total);
            about(T, "the point");
            G(nurbs_point)(G(nurbs_on_span)(p, dim, K.u, mu, R, z), t, P);
            G(nurbs_deboor)(G(nurbs_on_span)(p, dim, K.u, mu, R, z), t, Q);
            for (int e = 0; e < dim; e++) {
                same(T, mul(P[e], total), sum[e]);
                same(T, mul(Q[e], total), sum[e]);
            }
        }
    }
}

/*
There are two ways to run de Boor's algorithm on such a curve: on the four coordinates $(wR,w)$, and divide once at the end, or on
points and weights, and divide at each level. The second keeps every point in the space of the curve, where its points divide
edges; the first is cheaper. They are the same curve level by level.

:::{claim} nurbs_levels_are_levels_of_the_homogeneous_curve
:title: A level of the rational triangle is a level in homogeneous coordinates
:zh: 有理 de Boor 三角阵的一层
:given: every segment, the distinct knots variables, points and weights, any $\tau$ and $t$
:then: after the levels $1,\dots,r$ at $\tau$, $\sum_iw_i^rN_{i,p-r}(t)$ and $\sum_iw_i^rR_i^rN_{i,p-r}(t)$ are the polar forms of $w$ and of $wR$
  with $r$ arguments $\tau$ and $p-r$ arguments $t$; the last point and weight of each level are left as they were
:method: The sums, with the B-splines from the recursion by its letter, against the polar forms in elementary symmetric polynomials.
:degrees: 1..6 sampled 8
:scope: every pattern of the knots of a segment up to order 4, k+2 of them above;
  the distinct knots variables up to order 5, numbers above
:over: a: tau; q#: weights
:defines: nurbs_deboor_level
:control: the parameter of the last level is $t$
:::
*/
CLAIM(nurbs_levels_are_levels_of_the_homogeneous_curve)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num R[MOST_KNOTS * dim], w[MOST_KNOTS], S[MOST_KNOTS * dim], z[MOST_KNOTS], H[MOST_KNOTS];
    num s[HIGHEST + 1], x[HIGHEST + 1], N[HIGHEST + 1];
    for (int k = G(segment_knots)(T, p, 0, &K); k > 0; k = G(segment_knots)(T, p, k, &K)) {
        num tau = parameter(T, "a"), t = parameter(T, "t");
        G(free_nurbs)(T, K.n, dim, R, w);
        for (int i = 0; i < K.n * dim; i++)
            S[i] = R[i];
        for (int i = 0; i < K.n; i++)
            z[i] = w[i];
        for (int r = 1; r <= p; r++) {
            num last = z[p + 1 - r], last_point = S[(p + 1 - r) * dim];
            G(nurbs_deboor_level)
            (G(nurbs_on_span)(p, dim, K.u, p, NULL, NULL), r, S, z, fault(T, tau, r == p ? t : tau));
            about(T, "the last point and weight");
            same(T, z[p + 1 - r], last);
            same(T, S[(p + 1 - r) * dim], last_point);
            for (int m = 0; m <= p - r; m++)
                N[m] = G(cox_de_boor)(p - r, K.u, K.place, r + m, K.place[p], t);
            for (int m = 0; m < p; m++)
                x[m] = m < r ? tau : t;
            for (int e = 0; e <= dim; e++) {
                num sum = from_int(0);
                for (int i = 0; i < K.n; i++)
                    H[i] = e < dim ? mul(w[i], R[i * dim + e]) : w[i];
                for (int m = 0; m <= p - r; m++)
                    sum = add(sum, mul(N[m], e < dim ? mul(z[m], S[m * dim + e]) : z[m]));
                G(spline_powers)(K.n, p, 1, K.u, K.place, H, 0, K.place[p], K.u[p], s);
                about(T, e < dim ? "the points" : "the weights");
                same(T, sum, G(polar_of_powers)(p, s, K.u[p], x));
            }
        }
    }
}

/*
Insertion with weights has to change the weights as well: a new weight is a mean of two old ones, and the ratio on the edge is
that of the weights besides that of the knots. This is tested twice, against the definition in low degrees, and against the
insertion of the section before, applied to homogeneous points, in higher ones.

:::{claim} nurbs_insertion_keeps_curve
:title: Insertion with separate weights is insertion in homogeneous coordinates
:zh: NURBS 插入节点
:given: several segments, the distinct knots variables, points and weights; a new knot in every interval of the domain and at every knot of it
  of multiplicity at most $p$
:then: the knots of `nurbs_insert` are the old ones and the new one, and its weights $z_j$ and $z_jS_j$ are the points of the splines $w$ and $wR$
:method: Both pairs of splines in powers, from the recursion of de Boor and Cox by its letter.  In the field $w_iR_i$ are the variables, and $R_i$
  their quotients by the variables $w_i$.  From degree 4 on it is left to
  `nurbs_insertion_is_that_of_homogeneous_points`, whose time grows less.
:degrees: 0..3 sampled 6
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3
:over: q#: weights; s: new knot
:defines: nurbs_insert
:control: the last of the new weights is replaced by its neighbour
:::
*/
CLAIM(nurbs_insertion_keeps_curve)
{
    int p = T->degree;
    struct G(knot_vector) K = {0}, L;
    num H[MOST_KNOTS * dim], R[MOST_KNOTS * dim], w[MOST_KNOTS], S[MOST_KNOTS * dim], z[MOST_KNOTS], v[MOST_KNOTS];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(free_nurbs)(T, K.n, dim, H, w);
        for (int i = 0; i < K.n; i++)
            for (int e = 0; e < dim; e++)
                R[i * dim + e] = div(H[i * dim + e], w[i]);
        for (int place = K.place[p]; place < K.place[K.n]; place++) {
            int mu = G(span_of_interval)(K.count, K.place, place);
            if (G(multiplicity_at)(&K, place) > p)
                continue;
            num x = G(knot_for)(T, &K, place, "s");
            G(put_knot)(&K, place, x, &L);
            G(nurbs_insert)(nurbs(p, K.n, dim, K.u, R, w), mu, x, v, S, z);
            about(T, "the knots");
            for (int i = 0; i < L.count; i++)
                same(T, v[i], L.u[i]);
            for (int i = 0; i < L.n; i++)
                for (int e = 0; e < dim; e++)
                    S[i * dim + e] = mul(z[i], S[i * dim + e]);
            if (T->faulty && p > 0)
                z[mu] = z[mu - 1];
            about(T, "the weights");
            G(same_spline)(T, 1, &K, w, &L, z);
            about(T, "the points");
            G(same_spline)(T, dim, &K, H, &L, S);
        }
    }
}

/*
:::{claim} nurbs_insertion_is_that_of_homogeneous_points
:title: The weights and points after insertion are those of homogeneous points
:zh: NURBS 插入节点与齐次坐标
:given: several segments, points and weights; a new knot in every interval of the domain and at every knot of it of multiplicity at
  most $p$
:then: the weights $z_j$ of `nurbs_insert` and $z_jS_j$ are the points that `bspline_insert` gives for $w$ and for $wR$
:method: Two kernels that share no code.  That the second keeps splines is known from `boehm_insertion_keeps_curve` and
  `boehm_insertion_in_higher_degrees`, so the first keeps curves in the same degrees.
:degrees: 0..6 sampled 8
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:over: q#: weights; s: new knot
:control: the last of the new weights is replaced by its neighbour
:::
*/
CLAIM(nurbs_insertion_is_that_of_homogeneous_points)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num R[MOST_KNOTS * dim], w[MOST_KNOTS], H[MOST_KNOTS * dim], S[MOST_KNOTS * dim], z[MOST_KNOTS], v[MOST_KNOTS];
    num d[MOST_KNOTS * dim], weight[MOST_KNOTS];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(free_nurbs)(T, K.n, dim, R, w);
        for (int i = 0; i < K.n * dim; i++)
            H[i] = mul(w[i / dim], R[i]);
        for (int place = K.place[p]; place < K.place[K.n]; place++) {
            int mu = G(span_of_interval)(K.count, K.place, place);
            if (G(multiplicity_at)(&K, place) > p)
                continue;
            num x = G(knot_for)(T, &K, place, "s");
            G(nurbs_insert)(nurbs(p, K.n, dim, K.u, R, w), mu, x, v, S, z);
            if (T->faulty && p > 0)
                z[mu] = z[mu - 1];
            G(bspline_insert)(over(&K, 1, w), mu, x, v, weight);
            G(bspline_insert)(over(&K, dim, H), mu, x, v, d);
            about(T, "the weights");
            for (int i = 0; i <= K.n; i++)
                same(T, z[i], weight[i]);
            about(T, "the points");
            for (int i = 0; i < (K.n + 1) * dim; i++)
                same(T, mul(z[i / dim], S[i]), d[i]);
        }
    }
}

/*
## Derivatives, curvature, torsion
*/

/* The points and weights of one segment in d coordinates, 1 <= d <= 3: free; in the field the coefficients of the
 * homogeneous curve in powers about t are. */
static void G(segment_data)(trial *T, const struct G(knot_vector) * K, int d, num t, num R[], num w[])
{
#if FIELD
    static const char *const name[] = {"a", "b", "c"}; /* the knots are x */
    num s[HIGHEST + 1];
    for (int e = d; e >= 0; e--) { /* the weights first */
        for (int k = 0; k <= K->p; k++)
            s[k] = unknown(T, e == d ? "w" : name[e], k);
        for (int i = 0; i < K->n; i++) {
            num polar = G(polar_of_powers)(K->p, s, t, K->u + i + 1);
            if (e == d)
                w[i] = polar;
            else
                R[i * d + e] = div(polar, w[i]);
        }
    }
#else
    (void)t;
    G(free_nurbs)(T, K->n, d, R, w);
#endif
}

/*
The derivative of a quotient costs more than that of a spline: from the second order on it contains all derivatives of lower order
(Leibniz 法则). Each is found from $P^{(k)}=\sum_i\binom kiw^{(i)}R^{(k-i)}$ by solving for the term with $i=0$. Beyond the degree
of the curve numerator and denominator have no derivatives left, but their quotient has.

:::{claim} nurbs_derivatives_are_those_of_the_quotient
:title: All derivatives of a NURBS curve
:zh: NURBS 曲线的各阶导矢
:given: every segment, the distinct knots variables, points and weights, any $t$, orders $0,\dots,p+1$
:then: `nurbs_derivatives` gives $R^{(k)}(t)$
:method: The sums, with the B-splines from the recursion by its letter, in powers about $t$; the power series of numerator and denominator
  are divided, term by term, and the coefficient of order $k$ is $R^{(k)}(t)/k!$.  In the field the variables are the
  coefficients of numerator and denominator in powers about $t$, and the points are the values of their polar forms: every
  segment has such coefficients.
:degrees: 0..6 sampled 7
:scope: every pattern of the knots of a segment up to order 4, k+2 of them above;
  the distinct knots variables up to order 5, numbers above
:defines: nurbs_derivatives
:control: $w'(t)$ doubled in the division
:::
*/
CLAIM(nurbs_derivatives_are_those_of_the_quotient)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num R[MOST_KNOTS * dim], w[MOST_KNOTS], H[MOST_KNOTS], D[(HIGHEST + 2) * dim];
    num a[HIGHEST + 2], b[HIGHEST + 2], q[HIGHEST + 2];
    for (int k = G(segment_knots)(T, p, 0, &K); k > 0; k = G(segment_knots)(T, p, k, &K)) {
        num t = parameter(T, "t");
        G(segment_data)(T, &K, dim, t, R, w);
        G(nurbs_derivatives)(G(nurbs_on_span)(p, dim, K.u, p, R, w), t, p + 1, D);
        for (int e = 0; e < dim; e++) {
            for (int i = 0; i < K.n; i++)
                H[i] = mul(w[i], R[i * dim + e]);
            G(spline_powers)(K.n, p, 1, K.u, K.place, H, 0, K.place[p], t, a);
            G(spline_powers)(K.n, p, 1, K.u, K.place, w, 0, K.place[p], t, b);
            a[p + 1] = b[p + 1] = from_int(0);
            b[1] = fault(T, b[1], add(b[1], b[1]));
            for (int r = 0; r <= p + 1; r++) {
                q[r] = a[r];
                for (int j = 0; j < r; j++)
                    q[r] = sub(q[r], mul(q[j], b[r - j]));
                q[r] = div(q[r], b[0]);
                same(T, D[r * dim + e], G(derivative_of_powers)(p + 1, q, r));
            }
        }
    }
}

#if FIELD || RATIONAL
/*
:::{claim} quotient_derivatives_follow_the_field
:title: The derivatives of a quotient
:zh: 商的各阶导数
:given: $P$ and $w$ polynomials in $t$ of degree 5 with free coefficients
:then: `rational_quotient_derivatives` gives the derivatives of $P/w$ of the orders $0,\dots,r$ from those of $P$ and $w$
:method: The quotient of the two polynomials is an element of the field, which differentiates it formally $r$ times; here $r$ is the number that
  is called $n$.  In rationals the series at $t$ are divided.
:types: field rational
:degrees: r = 0..4 sampled 5
:over: y# q#: coefficients
:defines: rational_quotient_derivatives
:control: the second derivative of $w$, or for $r<2$ its value, doubled
:::
*/
CLAIM(quotient_derivatives_follow_the_field)
{
    enum { formal = 5 };
    int r = T->degree;
    num P[formal + 1], w[formal + 1], D[2 * (formal + 1)], out[formal + 1], t = parameter(T, "t");
    for (int k = 0; k <= formal;
         k++) { /* Taylor coefficients at t; in the field t is the variable, and P and w in its powers */
        P[k] = unknown(T, "y", k);
        w[k] = positive(T, "q", k);
    }
#if FIELD
    num above = from_int(0), below = from_int(0);
    for (int k = formal; k >= 0; k--) {
        above = add(mul(above, t), P[k]);
        below = add(mul(below, t), w[k]);
    }
    num value = div(above, below), quotient[formal + 1];
    for (int k = 0; k <= r; k++) {
        D[2 * k] = above, D[2 * k + 1] = below, quotient[k] = value;
        above = derivative_f(above, t), below = derivative_f(below, t), value = derivative_f(value, t);
    }
#else
    num quotient[formal + 1], q[formal + 1];
    (void)t;
    for (int k = 0; k <= r; k++) {
        D[2 * k] = G(derivative_of_powers)(formal, P, k), D[2 * k + 1] = G(derivative_of_powers)(formal, w, k);
        q[k] = P[k];
        for (int j = 0; j < k; j++)
            q[k] = sub(q[k], mul(q[j], w[k - j]));
        q[k] = div(q[k], w[0]);
        quotient[k] = G(derivative_of_powers)(formal, q, k);
    }
#endif
    int doubled = 2 * (r < 2 ? 0 : 2) + 1;
    D[doubled] = fault(T, D[doubled], mul(from_int(2), D[doubled]));
    G(rational_quotient_derivatives)(1, D, r, out);
    for (int k = 0; k <= r; k++)
        same(T, out[k], quotient[k]);
}

/* The knots of the next segment: simple ones, then in the field the clamped ones of Bézier. */
static int G(next_segment)(trial *T, int p, int k, struct G(knot_vector) * K)
{
    char pattern[MOST_KNOTS];
    int apart = k == 0 ? (1 << (2 * p + 1)) - 1 : 1 << p;
    if (k > (FIELD ? 1 : 0))
        return 0;
    G(pattern_of_bits)(2 * p + 2, apart, pattern);
    (void)G(knots_good)(T, p, pattern, K);
    return k + 1;
}

/* D[r][e], r = 0, ..., 3: derivatives at t of the d+1 homogeneous coordinates, the weight last. */
static void G(homogeneous_derivatives)(const struct G(knot_vector) * K, int d, const num R[], const num w[], num t,
                                       num D[4][4])
{
    num H[MOST_KNOTS], s[HIGHEST + 1];
    for (int e = 0; e <= d; e++) {
        for (int i = 0; i < K->n; i++)
            H[i] = e < d ? mul(w[i], R[i * d + e]) : w[i];
        G(spline_powers)(K->n, K->p, 1, K->u, K->place, H, 0, K->place[K->p], t, s);
        for (int r = 0; r < 4; r++)
            D[r][e] = G(derivative_of_powers)(K->p, s, r);
    }
}

/* The determinant of the rows 0, 1, 2 of D in the columns i, j, k. */
static num G(minor3)(num D[4][4], int i, int j, int k)
{
    num M[9];
    for (int r = 0; r < 3; r++)
        M[3 * r] = D[r][i], M[3 * r + 1] = D[r][j], M[3 * r + 2] = D[r][k];
    return G(determinant)(3, M);
}

/*
Curvature (曲率) and torsion (挠率) need no derivative of a quotient. In homogeneous coordinates the determinant of point, first and
second derivative does not change when the coordinates are multiplied by a function, except by its third power; so it is $w^3$
times the one for the curve itself. This gives a formula for the other side of the comparison that shares no step with the kernel.

:::{claim} nurbs_curvature_from_homogeneous_coordinates
:title: The squared curvature of a plane NURBS curve
:zh: 平面 NURBS 曲线的曲率
:given: weights, points of the plane, any $t$; simple knots and, in the field, clamped ones, the distinct knots variables
:then: with $P=(x,y,w)$ the homogeneous curve, `nurbs_curvature_squared` gives
  $\kappa^2=\frac{w^6\det(P,P',P'')^2}{\bigl((x'w-xw')^2+(y'w-yw')^2\bigr)^3}$
:method: The derivatives of $P$ at $t$ from the recursion of de Boor and Cox by its letter; the formula has no derivative of a quotient.
  In the field the variables are the coefficients of $P$ in powers about $t$.  In a greater degree
  there are further coefficients, on which $P$, $P'$ and $P''$ do not depend.
:types: field rational
:degrees: 1..4 sampled 6
:defines: nurbs_curvature_squared
:control: $P''$ doubled in the formula
:::
*/
CLAIM(nurbs_curvature_from_homogeneous_coordinates)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num R[MOST_KNOTS * 2], w[MOST_KNOTS], D[4][4], t = parameter(T, "t");
    for (int k = G(next_segment)(T, p, 0, &K); k > 0; k = G(next_segment)(T, p, k, &K)) {
        G(segment_data)(T, &K, 2, t, R, w);
        G(homogeneous_derivatives)(&K, 2, R, w, t, D);
        for (int e = 0; e <= 2; e++)
            D[2][e] = fault(T, D[2][e], mul(from_int(2), D[2][e]));
        /* κ² times ((x'w - xw')² + (y'w - yw')²)³ is w⁶ det(P, P', P'')² */
        num det = G(minor3)(D, 0, 1, 2), speed = from_int(0), above = mul(det, det), below = from_int(1);
        for (int e = 0; e < 2; e++) {
            num part = sub(mul(D[1][e], D[0][2]), mul(D[0][e], D[1][2]));
            speed = add(speed, mul(part, part));
        }
        for (int m = 0; m < 6; m++)
            above = mul(above, D[0][2]);
        for (int m = 0; m < 3; m++)
            below = mul(below, speed);
        same(T, mul(G(nurbs_curvature_squared)(G(nurbs_on_span)(p, 2, K.u, p, R, w), t), below), above);
    }
}

/*
:::{claim} nurbs_torsion_from_homogeneous_coordinates
:title: The torsion of a NURBS curve in space
:zh: 空间 NURBS 曲线的挠率
:given: weights, points of space, $p\ge3$, any $t$; simple knots and, in the field, clamped ones, the distinct knots variables
:then: with $P=(w,x,y,z)$ the homogeneous curve, `nurbs_torsion` gives $w^2\det(P,P',P'',P''')$ over the sum of the squares of the minors of
  $(P,P',P'')$ in the columns $yzw$, $zxw$ and $xyw$
:method: The derivatives of $P$ at $t$ from the recursion of de Boor and Cox by its letter, no derivative of a
  quotient, and in the field the coefficients of $P$ about $t$ as variables.  In a
  greater degree there are further coefficients, on which $P,\dots,P'''$ do not depend.
:types: field rational
:degrees: 3..3 sampled 7
:defines: nurbs_torsion
:control: $P''$ doubled in the formula
:::
*/
CLAIM(nurbs_torsion_from_homogeneous_coordinates)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num R[MOST_KNOTS * 3], w[MOST_KNOTS], D[4][4], M[16], t = parameter(T, "t");
    for (int k = G(next_segment)(T, p, 0, &K); k > 0; k = G(next_segment)(T, p, k, &K)) {
        G(segment_data)(T, &K, 3, t, R, w);
        G(homogeneous_derivatives)(&K, 3, R, w, t, D);
        for (int e = 0; e <= 3; e++)
            D[2][e] = fault(T, D[2][e], mul(from_int(2), D[2][e]));
        for (int r = 0; r < 4; r++)
            for (int e = 0; e < 4; e++)
                M[4 * r + (e + 1) % 4] = D[r][e];
        num below = from_int(0);
        for (int e = 0; e < 3; e++) {
            num minor = G(minor3)(D, (e + 1) % 3, (e + 2) % 3, 3);
            below = add(below, mul(minor, minor));
        }
        num above = mul(mul(D[0][3], D[0][3]), G(determinant)(4, M));
        same(T, mul(G(nurbs_torsion)(G(nurbs_on_span)(p, 3, K.u, p, R, w), t), below), above);
    }
}
#endif

/*
## Other units

Nothing changes when knots and parameters are counted from another point and in another unit.  For a kernel this is a property
that it could lack.

:::{claim} kernels_move_with_their_knots
:title: Moved and stretched together, knots and parameters give the same points
:zh: 节点与参数的仿射变换不改变结果
:given: several segments, the distinct knots variables, points and weights; a parameter in every interval of the domain; numbers
  $a\ne0$ and $b$
:then: `bspline_insert`, `bspline_split`, `bspline_refine`, `bspline_elevate`, `bspline_reduce`, `bspline_discrete`, `nurbs_point`
  and `nurbs_weight` give the same for the knots $au_i+b$ and the parameter $at+b$ as for $u_i$ and $t$
:method: Every kernel twice, elevation and reduction where there is one inner knot at most.
:degrees: 0..4 sampled 7
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3
:where: the factor of the knots is not 0
:over: a: factor; b: shift; q#: weights
:control: the parameter is moved by $b$ and not stretched; in degree 0, the points are moved
:::
*/
static void G(same_points)(trial *T, int count, const num a[], const num b[])
{
    for (int i = 0; i < count; i++)
        same(T, a[i], b[i]);
}

CLAIM(kernels_move_with_their_knots)
{
    int p = T->degree, span[MOST_KNOTS];
    struct G(knot_vector) K = {0}, F, E;
    num R[MOST_KNOTS * dim], w[MOST_KNOTS], moved[MOST_KNOTS], finer[MOST_KNOTS], a = positive(T, "a", 0);
    num b = unknown(T, "b", 0), c[2][MOST_KNOTS * dim], d[2][MOST_KNOTS * dim], v[MOST_KNOTS], v2[MOST_KNOTS];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(free_nurbs)(T, K.n, dim, R, w);
        for (int i = 0; i < K.count; i++)
            moved[i] = add(mul(a, K.u[i]), b);
        const num *knots[2] = {K.u, moved};
        for (int mu = p; mu < K.n; mu++) {
            if (K.place[mu] == K.place[mu + 1])
                continue;
            num t = G(in_interval)(T, &K, mu, "t"), at = add(fault(T, mul(a, t), t), b), x[HIGHEST + 1], weight[2];
            for (int m = 0; m < 2; m++) {
                num s = m == 0 ? t : at;
                G(nurbs_point)(G(nurbs_on_span)(p, dim, knots[m], mu, R, w), s, c[m]);
                weight[m] = G(nurbs_weight)(G(nurbs_on_span)(p, 0, knots[m], mu, NULL, w), s);
            }
            about(T, "the point and its weight");
            G(same_points)(T, dim, c[1], c[0]);
            same(T, weight[1], weight[0]);
            if (T->faulty && p == 0)
                R[0] = add(R[0], from_int(1));
            about(T, "a new knot");
            for (int m = 0; m < 2; m++)
                G(bspline_insert)(spline(p, K.n, dim, knots[m], R), mu, m == 0 ? t : at, v, c[m]);
            G(same_points)(T, (K.n + 1) * dim, c[1], c[0]);
            about(T, "both parts");
            for (int m = 0; m < 2; m++)
                G(bspline_split)(spline(p, K.n, dim, knots[m], R), mu, 0, m == 0 ? t : at, v, c[m], v2, d[m]);
            G(same_points)(T, (mu + 1) * dim, c[1], c[0]);
            G(same_points)(T, (K.n - mu + p) * dim, d[1], d[0]);
            about(T, "discrete B-splines");
            for (int m = 0; m < 2; m++) {
                for (int r = 0; r < p; r++)
                    x[r] = r == 0 ? (m == 0 ? t : at) : knots[m][mu + r];
                G(bspline_discrete)(p, knots[m], mu, x, c[m]);
            }
            G(same_points)(T, p + 1, c[1], c[0]);
            about(T, "a finer knot vector");
            G(put_knot)(&K, K.place[mu] + 1, t, &F);
            if (!G(spans_over)(&K, F.n, p, F.place, 0, span))
                continue;
            for (int i = 0; i < F.count; i++)
                finer[i] = add(mul(a, F.u[i]), b);
            for (int m = 0; m < 2; m++)
                G(bspline_refine)(spline(p, K.n, dim, knots[m], R), F.n, m == 0 ? F.u : finer, span, c[m]);
            G(same_points)(T, F.n * dim, c[1], c[0]);
        }
        if (K.n > p + 2)
            continue;
        E = K;
        for (int place = K.place[p]; place <= K.place[K.n]; place += 2)
            G(put_knot)(&E, place, K.u[G(span_of_interval)(K.count, K.place, place)], &E);
        E.p = p + 1, E.n = E.count - p - 2;
        if (!G(spans_over)(&K, E.n, p + 1, E.place, 0, span))
            continue;
        for (int i = 0; i < E.count; i++)
            finer[i] = add(mul(a, E.u[i]), b);
        about(T, "a degree more");
        for (int m = 0; m < 2; m++)
            G(bspline_elevate)(spline(p, K.n, dim, knots[m], R), E.n, m == 0 ? E.u : finer, span, c[m]);
        G(same_points)(T, E.n * dim, c[1], c[0]);
        if (p == 0 || !G(spans_over)(&E, K.n, p, K.place, 0, span))
            continue;
        about(T, "a degree less");
        G(free_control_points)(T, E.n, dim, R);
        for (int m = 0; m < 2; m++)
            G(bspline_reduce)(spline(p + 1, E.n, dim, m == 0 ? E.u : finer, R), K.n, knots[m], span, d[m]);
        G(same_points)(T, K.n * dim, d[1], d[0]);
    }
}
#include "chapters/judge/claims_off.h"
