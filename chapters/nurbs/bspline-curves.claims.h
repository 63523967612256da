/*
# B-spline curves (B 样条曲线)

A B-spline curve is $s(t)=\sum_ic_iN_{i,p}(t)$.  On a span it is one polynomial, and a polynomial has one polar form (极形式)
$f[x_1,\dots,x_p]$: symmetric, affine in each argument, with $f[t,\dots,t]=s(t)$.  De Boor's algorithm is this polar form,
computed from the points; and the points are its values at consecutive knots, $c_i=f[u_{i+1},\dots,u_{i+p}]$.
*/
#include "chapters/nurbs/definition.h"
#include "chapters/nurbs/patterns.h"

#include "chapters/judge/claims_on.h"

enum { dim = FIELD ? 1 : 2 }; /* every formula is taken coordinate by coordinate: the field takes one */

/* Compare, for every segment over knots of that kind (patterns.h): f[x_0, ..., x_{p-1}] by the kernel and by definition. */
static void G(check_blossom_of_a_segment_is_its_polar_form)(trial *T, int kind)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = kind};
    num c[MOST_KNOTS * dim], s[HIGHEST + 1], x[HIGHEST + 1], P[dim], Q[dim];
    for (int k = G(segment_knots)(T, p, 0, &K); k > 0; k = G(segment_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, dim, c);
        for (int r = 0; r < p; r++)
            x[r] = unknown(T, "a", r);
        G(bspline_blossom)(G(span_alone)(p, dim, K.u, p, c), x, Q);
        if (T->faulty && p > 1)
            x[0] = x[p - 1];
        G(bspline_blossom)(G(on_span)(p, dim, K.u, p, c), x, P);
        for (int i = 0; i < dim; i++) {
            about(T, "the polar form");
            G(spline_powers)(K.n, p, dim, K.u, K.place, c, i, K.place[p], K.u[p], s);
            if (T->faulty && p > 1)
                x[0] = unknown(T, "a", 0);
            same(T, P[i], G(polar_of_powers)(p, s, K.u[p], x));
            about(T, "the same from the points of the span");
            same(T, Q[i], P[i]);
        }
    }
}

/*
:::{claim} blossom_of_a_segment_is_its_polar_form
:title: The triangle of de Boor with a parameter for every level is the polar form
:zh: de Boor 三角阵即极形式
:given: every segment, the distinct knots variables, points, arguments $x_0,\dots,x_{p-1}$
:then: `bspline_blossom` gives $f[x_0,\dots,x_{p-1}]$
:method: The polynomial of the interval in powers of $t-u_\mu$ comes from the recursion of de Boor and Cox by its letter; its
  polar form is written in elementary symmetric polynomials of the arguments.  Knots, arguments and points are variables;
  the points of the span alone give the same.
:degrees: 0..4 sampled 9
:over: a#: arguments
:defines: bspline_blossom
:control: the last argument taken as the first as well
:::
*/
CLAIM(blossom_of_a_segment_is_its_polar_form) { G(check_blossom_of_a_segment_is_its_polar_form)(T, 0); }

#if FIELD
/*
:::{claim} blossom_is_polar_form_in_higher_degrees
:title: The polar form of a segment of higher degree
:zh: 高次时的极形式
:given: a segment over the knots $0,1,3,6,10,\dots$ in each of the patterns; points and arguments $x_0,\dots,x_{p-1}$, variables
:then: `bspline_blossom` gives $f[x_0,\dots,x_{p-1}]$
:method: The kernel against the polar form of the segment, written in elementary symmetric polynomials of the arguments; the segment from the recursion of de Boor and Cox
  by its letter.
:types: field
:degrees: 5..7
:scope: the distinct knots $0,1,3,6,10,\dots$
:over: a#: arguments
:control: the last argument taken as the first as well
:::
*/
CLAIM(blossom_is_polar_form_in_higher_degrees) { G(check_blossom_of_a_segment_is_its_polar_form)(T, INTEGERS); }
#endif

/*
What a single level of the triangle means is seen when its arguments are not all the same. After $r$ levels at $\tau$ the points
are those of the polynomial in which $r$ arguments are fixed at $\tau$ and the others are left free, a spline of degree $p-r$ over
the same knots. Evaluation fixes all $p$ of them at one $t$ (de Boor 算法); the insertion of a knot, in the next section, stops
after the first level.

:::{claim} deboor_level_gives_points_of_lower_degree
:title: A level of the triangle is a spline of lower degree with the same polar form
:zh: de Boor 三角阵一层的意义
:given: every segment, the distinct knots variables, points, any $\tau$ and $t$
:then: after the levels $1,\dots,r$ at $\tau$ the points $d_i^r$ are those of the polynomial
  $f[\tau^r,t^{p-r}]=\sum_{i=\mu-p+r}^{\mu}d_i^r\,N_{i,p-r}(t)$; the last point of each level is left as it was
:method: The sum, with the B-splines from the recursion by its letter, against the polar form in elementary symmetric
  polynomials.  As the $N_{i,p-r}$ of a span are independent, this says what every $d_i^r$ is.
:degrees: 1..6 sampled 9
:scope: the distinct knots variables up to order 5, numbers above
:over: a: tau
:defines: bspline_deboor_level
:control: the parameter of the last level is $t$
:::
*/
CLAIM(deboor_level_gives_points_of_lower_degree)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num c[MOST_KNOTS * dim], d[MOST_KNOTS * dim], s[HIGHEST + 1], x[HIGHEST + 1], N[HIGHEST + 1];
    num tau = unknown(T, "a", 0), t = parameter(T, "t");
    for (int k = G(segment_knots)(T, p, 0, &K); k > 0; k = G(segment_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, dim, c);
        for (int i = 0; i < (p + 1) * dim; i++)
            d[i] = c[i];
        for (int r = 1; r <= p; r++) {
            num last[dim];
            for (int i = 0; i < dim; i++)
                last[i] = d[(p + 1 - r) * dim + i];
            G(bspline_deboor_level)(G(on_span)(p, dim, K.u, p, NULL), r, d, fault(T, tau, r == p ? t : tau));
            for (int m = 0; m <= p - r; m++)
                N[m] = G(cox_de_boor)(p - r, K.u, K.place, r + m, K.place[p], t);
            for (int m = 0; m < p; m++)
                x[m] = m < r ? tau : t;
            for (int i = 0; i < dim; i++) {
                num sum = from_int(0);
                for (int m = 0; m <= p - r; m++)
                    sum = add(sum, mul(d[m * dim + i], N[m]));
                G(spline_powers)(K.n, p, dim, K.u, K.place, c, i, K.place[p], K.u[p], s);
                about(T, "the polynomial of the level");
                same(T, sum, G(polar_of_powers)(p, s, K.u[p], x));
                about(T, "the last point");
                same(T, d[(p + 1 - r) * dim + i], last[i]);
            }
        }
    }
}

/*
:::{claim} deboor_evaluates_bspline_curve
:title: De Boor's algorithm computes the point of the curve
:zh: de Boor 算法求 B 样条曲线上的点
:given: several segments, the distinct knots variables, points; every interval of the domain; any $t$
:then: `bspline_deboor` gives $s(t)=\sum_{i=0}^{n-1}c_iN_{i,p}(t)$
:method: The kernel against the sum of all $n$ terms, the B-splines from the recursion by its letter; the
  points of the span alone give the same.
:degrees: 0..6 sampled 7
:scope: the distinct knots variables up to order 5, numbers above
:defines: bspline_deboor
:control: the points taken backwards
:::
*/
CLAIM(deboor_evaluates_bspline_curve)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num c[MOST_KNOTS * dim], b[MOST_KNOTS * dim], P[dim], Q[dim], t = parameter(T, "t");
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, dim, c);
        for (int i = 0; i < K.n; i++)
            for (int e = 0; e < dim; e++)
                b[i * dim + e] = c[fault(T, i, K.n - 1 - i) * dim + e];
        for (int mu = p; mu < K.n; mu++)
            if (K.place[mu] < K.place[mu + 1]) {
                G(bspline_deboor)(G(on_span)(p, dim, K.u, mu, b), t, P);
                G(bspline_deboor)(G(span_alone)(p, dim, K.u, mu, b + (mu - p) * dim), t, Q);
                for (int e = 0; e < dim; e++) {
                    num value = G(spline_value)(K.n, p, dim, K.u, K.place, c, e, K.place[mu], t);
                    same(T, P[e], value);
                    same(T, Q[e], value);
                }
            }
    }
}

/*
Now the triangle can be read backwards. Put consecutive knots in the place of the arguments: the value is a control point. This
sentence carries most of the algorithms of this chapter, since whoever wants the points of the same curve over other knots, or in
another degree, only has to evaluate its polar form there.

:::{claim} bspline_points_are_values_of_the_blossom
:title: The points are the values of the polar form at consecutive knots
:zh: 控制顶点即极形式在相邻节点处的值
:given: several segments, the distinct knots variables; every interval of the domain, $f$ the polar form of its segment
:then: $c_i=f[u_{i+1},\dots,u_{i+p}]$ for $i=\mu-p,\dots,\mu$
:method: The polynomial of the interval from the recursion by its letter, its polar form in elementary symmetric polynomials,
  against the variables $c_i$.
:degrees: 0..6 sampled 8
:scope: the distinct knots variables up to order 5, numbers above
:control: the knots taken one too low
:::
*/
CLAIM(bspline_points_are_values_of_the_blossom)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num c[MOST_KNOTS], s[HIGHEST + 1];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, 1, c);
        for (int mu = p; mu < K.n; mu++) {
            if (K.place[mu] == K.place[mu + 1])
                continue;
            G(spline_powers)(K.n, p, 1, K.u, K.place, c, 0, K.place[mu], K.u[mu], s);
            for (int i = mu - p; i <= mu; i++)
                same(T, G(polar_of_powers)(p, s, K.u[mu], K.u + i + fault(T, 1, 0)), c[i]);
        }
    }
}

/*
:::{claim} bspline_blossom_is_symmetric_and_affine
:title: The polar form is symmetric and affine in each argument
:zh: 极形式的对称性与多重仿射性
:given: every segment, the distinct knots variables, numbers $c_i$, arguments $x_0,\dots,x_{p-1}$, and $v$, $b$
:then: exchanging two neighbouring arguments of `bspline_blossom` changes nothing, hence no permutation does; and
  $f[\dots,(1-b)x_k+bv,\dots]=(1-b)f[\dots,x_k,\dots]+b\,f[\dots,v,\dots]$ for every $k$
:method: The values of the kernel, everything a variable.
:degrees: 1..6 sampled 9
:scope: the distinct knots variables up to order 5, numbers above
:over: a# v#: arguments; b: ratio
:control: the factors $1-b$ and $b$ exchanged
:::
*/
CLAIM(bspline_blossom_is_symmetric_and_affine)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num c[MOST_KNOTS], x[HIGHEST + 1], P, Q, between;
    num b = parameter(T, "b"), b1 = sub(from_int(1), b), v = unknown(T, "v", 0);
    for (int k = G(segment_knots)(T, p, 0, &K); k > 0; k = G(segment_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, 1, c);
        for (int r = 0; r < p; r++)
            x[r] = unknown(T, "a", r);
        G(bspline_blossom)(G(on_span)(p, 1, K.u, p, c), x, &P);
        for (int r = 0; r < p; r++) {
            num kept = x[r];
            if (r + 1 < p) {
                about(T, "two arguments exchanged");
                x[r] = x[r + 1], x[r + 1] = kept;
                G(bspline_blossom)(G(on_span)(p, 1, K.u, p, c), x, &Q);
                same(T, Q, P);
                x[r + 1] = x[r], x[r] = kept;
            }
            about(T, "affine");
            x[r] = v;
            G(bspline_blossom)(G(on_span)(p, 1, K.u, p, c), x, &Q);
            x[r] = add(mul(b1, kept), mul(b, v));
            G(bspline_blossom)(G(on_span)(p, 1, K.u, p, c), x, &between);
            same(T, between, fault(T, add(mul(b1, P), mul(b, Q)), add(mul(b, P), mul(b1, Q))));
            x[r] = kept;
        }
    }
}

/*
The sum of the B-splines is 1 on the domain, so that a curve is a mean of its points, and moves with them under every affine map
(仿射不变性).

:::{claim} bspline_curve_moves_with_its_points
:title: An affine map of the points is the same map of the curve
:zh: B 样条曲线的仿射不变性
:given: every segment, the distinct knots variables, points, any affine map, any $t$
:then: the curve of the mapped points is the mapped curve
:method: Map, knots, points and $t$ are variables; by `bspline_deboor`.
:degrees: 0..6 sampled 9
:scope: the distinct knots variables up to order 5, numbers above
:over: m# v#: affine maps
:control: the last point is not moved
:::
*/
CLAIM(bspline_curve_moves_with_its_points)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num c[MOST_KNOTS * dim], moved[MOST_KNOTS * dim], M[dim * dim], v[dim], P[dim], Q[dim], t = parameter(T, "t");
    for (int m = 0; m < dim * dim; m++)
        M[m] = unknown(T, "m", m);
    for (int e = 0; e < dim; e++)
        v[e] = unknown(T, "v", e);
    for (int k = G(segment_knots)(T, p, 0, &K); k > 0; k = G(segment_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, dim, c);
        for (int i = 0; i < K.n; i++)
            for (int e = 0; e < dim; e++) {
                num image = v[e];
                for (int j = 0; j < dim; j++)
                    image = add(image, mul(M[e * dim + j], c[i * dim + j]));
                moved[i * dim + e] = fault(T, image, i == K.n - 1 ? c[i * dim + e] : image);
            }
        G(bspline_deboor)(G(on_span)(p, dim, K.u, p, c), t, P);
        G(bspline_deboor)(G(on_span)(p, dim, K.u, p, moved), t, Q);
        for (int e = 0; e < dim; e++) {
            num image = v[e];
            for (int j = 0; j < dim; j++)
                image = add(image, mul(M[e * dim + j], P[j]));
            same(T, Q[e], image);
        }
    }
}

/*
## Values and derivatives at knots

A value from the left at a knot is that of the span on the left.  Both spans give the same derivatives up to the order $p-m$
at a knot of multiplicity $m$, and in general different ones after it.
*/

#if FIELD
/*
:::{claim} bspline_curve_is_smooth_at_knots
:title: At a knot of multiplicity m the spans on both sides agree up to the order p-m, and only so far
:zh: 节点处左右两段的连续阶
:given: several segments, the distinct knots variables, numbers $c_i$; every knot of multiplicity $m\le p$ inside the domain
:then: `bspline_derivatives` of both spans at the knot agree in the orders $0,\dots,p-m$; those of order $p-m+1$ are different
  linear forms of the points
:method: Both rows of derivatives by the kernel, everything a variable; the difference of the next order is not the zero element
  of the field.
:types: field
:degrees: 1..6
:scope: the distinct knots variables up to order 5, numbers above
:control: one order more
:::
*/
CLAIM(bspline_curve_is_smooth_at_knots)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num c[MOST_KNOTS], L[HIGHEST + 2], R[HIGHEST + 2];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, 1, c);
        for (int at = K.place[p] + 2; at < K.place[K.n]; at += 2) {
            int m = G(multiplicity_at)(&K, at), right = G(span_of_interval)(K.count, K.place, at);
            if (m > p)
                continue;
            G(bspline_derivatives)(G(on_span)(p, 1, K.u, right - m, c), K.u[right], p, L);
            G(bspline_derivatives)(G(on_span)(p, 1, K.u, right, c), K.u[right], p, R);
            for (int r = 0; r <= fault(T, p - m, p - m + 1); r++)
                same(T, R[r], L[r]);
            agree(T, !is_zero_f(sub(R[p - m + 1], L[p - m + 1])));
        }
    }
}
#endif

/*
A curve does not reach the ends of its polygon unless the knots make it. With $p+1$ equal knots at an end, only one B-spline does
not vanish there; the derivative in the end point sees one more, and so has the direction of the first edge, with a factor in
which the length of the first interval stands and not that of the domain.

:::{claim} clamped_ends_interpolate
:title: At an end of multiplicity p+1 the curve begins in its first point, in the direction of the first edge
:zh: 端节点 p+1 重时的端点性质
:given: two simple inner knots, the first knot of the domain of multiplicity $p+1$, the last as well, points variables
:then: $s(u_p)=c_0$, $s(u_n)=c_{n-1}$, $s'(u_p)=\frac p{u_{p+1}-u_p}(c_1-c_0)$,
  $s'(u_n)=\frac p{u_n-u_{n-1}}(c_{n-1}-c_{n-2})$
:method: Values and derivatives from the recursion by its letter.
:degrees: 1..6 sampled 8
:scope: the distinct knots variables up to order 5, numbers above
:control: the points at the end taken one too low
:::
*/
CLAIM(clamped_ends_interpolate)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    char pattern[] = {(char)('1' + p), '1', '1', (char)('1' + p), '\0'};
    num c[MOST_KNOTS], s[HIGHEST + 1];
    (void)G(knots_good)(T, p, pattern, &K);
    G(free_control_points)(T, K.n, 1, c);
    G(spline_powers)(K.n, p, 1, K.u, K.place, c, 0, K.place[p], K.u[p], s);
    same(T, s[0], c[0]);
    same(T, s[1], mul(div(from_int(p), sub(K.u[p + 1], K.u[p])), sub(c[1], c[0])));
    G(spline_powers)(K.n, p, 1, K.u, K.place, c, 0, K.place[K.n - 1], K.u[K.n], s);
    int last = fault(T, K.n - 1, K.n - 2);
    same(T, s[0], c[last]);
    same(T, s[1], mul(div(from_int(p), sub(K.u[K.n], K.u[K.n - 1])), sub(c[last], c[last - 1])));
}

/*
## Derivatives (导矢)

:::{claim} bspline_difference_is_derivative_spline
:title: The derivative is the spline of the divided differences of the points
:zh: B 样条曲线的导曲线
:given: several segments without a knot of multiplicity $p+1$ inside the knot vector, the distinct knots variables, points of
  the plane; every interval of the domain
:then: the points $e_i=p\,\frac{c_{i+1}-c_i}{u_{i+p+1}-u_{i+1}}$ of `bspline_difference`, over $u_1,\dots,u_{n+p-1}$ in degree
  $p-1$, are those of $s'$; and `bspline_hodograph` gives the ones of a span, its last point left as it was
:method: The coefficients of both splines in powers of $t-u_\mu$, from the recursion by its letter; the points of the second
  kernel against those of the first.
:degrees: 1..6 sampled 9
:scope: the distinct knots variables up to order 5, numbers above
:defines: bspline_difference bspline_hodograph
:control: the factor $p$ taken as $p+1$
:::
*/
CLAIM(bspline_difference_is_derivative_spline)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num c[MOST_KNOTS * dim], e[MOST_KNOTS * dim], d[MOST_KNOTS * dim], s[HIGHEST + 1], r[HIGHEST + 1];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        int torn = 0;
        for (int i = 1; i + 1 < K.n + 1 && i + p < K.count - 1; i++)
            torn += K.place[i] == K.place[i + p];
        if (torn)
            continue;
        G(free_control_points)(T, K.n, dim, c);
        G(bspline_difference)(K.n, p, dim, K.u, c, e);
        for (int i = 0; i < (K.n - 1) * dim; i++)
            e[i] = fault(T, e[i], mul(e[i], from_ratio(p + 1, p)));
        for (int mu = p; mu < K.n; mu++) {
            if (K.place[mu] == K.place[mu + 1])
                continue;
            for (int i = 0; i < dim; i++) {
                about(T, "the derivative");
                G(spline_powers)(K.n, p, dim, K.u, K.place, c, i, K.place[mu], K.u[mu], s);
                G(spline_powers)(K.n - 1, p - 1, dim, K.u + 1, K.place + 1, e, i, K.place[mu], K.u[mu], r);
                for (int j = 0; j < p; j++)
                    same(T, r[j], mul(from_int(j + 1), s[j + 1]));
            }
            for (int i = 0; i < (p + 1) * dim; i++)
                d[i] = c[(mu - p) * dim + i];
            G(bspline_hodograph)(p, dim, K.u, mu, d);
            about(T, "the points of the span, and its last");
            for (int i = 0; i < (p + 1) * dim; i++)
                same(T, d[i], i < p * dim ? e[(mu - p) * dim + i] : c[(mu - p) * dim + i]);
        }
    }
}

/* Compare, for every segment over knots of that kind: s^(r)(t), r = 0, ..., p+1, by the kernels and from the powers about t. */
static void G(check_bspline_derivatives_of_every_order)(trial *T, int kind)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = kind};
    num c[MOST_KNOTS * dim], b[MOST_KNOTS * dim], s[HIGHEST + 1], t = parameter(T, "t");
    num D[(HIGHEST + 2) * dim], E[(HIGHEST + 2) * dim];
    for (int k = G(segment_knots)(T, p, 0, &K); k > 0; k = G(segment_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, dim, c);
        for (int i = 0; i <= p; i++)
            for (int e = 0; e < dim; e++)
                b[i * dim + e] = c[fault(T, i, p - i) * dim + e];
        G(bspline_derivatives)(G(on_span)(p, dim, K.u, p, b), t, p + 1, D);
        G(bspline_derivatives)(G(span_alone)(p, dim, K.u, p, b), t, p + 1, E);
        for (int e = 0; e < dim; e++) {
            G(spline_powers)(K.n, p, dim, K.u, K.place, c, e, K.place[p], t, s);
            for (int r = 0; r <= p + 1; r++) {
                same(T, D[r * dim + e], G(derivative_of_powers)(p, s, r));
                same(T, E[r * dim + e], G(derivative_of_powers)(p, s, r));
            }
        }
    }
}

/*
The derivative, too, is a spline, over the same knots without the first and the last. Differences of points, each over the length
of the $p$ intervals that its two B-splines share: where these are all empty, at a knot of multiplicity $p+1$, the quotient does
not exist, and the curve has a jump which no derivative describes. The kernel for one parameter avoids the question, since it
stays in one span.

:::{claim} bspline_derivatives_of_every_order
:title: The kernel computes all derivatives of a segment
:zh: B 样条曲线的各阶导矢
:given: every segment, the distinct knots variables, points, any $t$, orders $0,\dots,p+1$
:then: `bspline_derivatives` gives $s^{(r)}(t)$, $0$ for $r>p$; the points of the span alone give the same
:method: The kernel against the coefficients in powers about the same $t$, from the recursion by its letter.
:degrees: 0..4 sampled 8
:defines: bspline_derivatives
:control: the derivatives of the reversed points
:::
*/
CLAIM(bspline_derivatives_of_every_order) { G(check_bspline_derivatives_of_every_order)(T, 0); }

#if FIELD
/*
:::{claim} bspline_derivatives_in_higher_degrees
:title: The derivatives of a segment of higher degree
:zh: 高次时的导矢
:given: a segment over the knots $0,1,3,6,10,\dots$ in each of the patterns; points and $t$, variables; orders $0,\dots,p+1$
:then: `bspline_derivatives` gives $s^{(r)}(t)$, $0$ for $r>p$; the points of the span alone give the same
:method: The kernel against the coefficients in powers about the same $t$, from the recursion by its letter.
:types: field
:degrees: 6..6
:scope: the distinct knots $0,1,3,6,10,\dots$
:control: the derivatives of the reversed points
:::
*/
CLAIM(bspline_derivatives_in_higher_degrees) { G(check_bspline_derivatives_of_every_order)(T, INTEGERS); }
#endif

#include "chapters/judge/claims_off.h"
