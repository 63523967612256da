/*
# Knot insertion (插入节点)

A knot more makes the space of splines larger by one dimension and leaves the curve as it is.  Boehm's algorithm computes the
new points; only $p$ of them are new, and they divide edges of the polygon in the ratio in which the knot divides the lengths
$u_{i+p}-u_i$.
*/
#include "chapters/nurbs/definition.h"
#include "chapters/nurbs/patterns.h"

#include "chapters/judge/claims_on.h"

enum { dim = FIELD ? 1 : 2 }; /* every formula is taken coordinate by coordinate: the field takes one */

/* Compare, for several segments over knots of that kind and a new knot in every place: the knots, and both splines on every
 * interval. */
static void G(check_boehm_insertion_keeps_curve)(trial *T, int kind)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = kind}, L;
    num c[MOST_KNOTS * dim], d[MOST_KNOTS * dim], v[MOST_KNOTS];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, dim, c);
        for (int place = K.place[p]; place < K.place[K.n]; place++) {
            if (G(multiplicity_at)(&K, place) > p)
                continue;
            num x = G(knot_for)(T, &K, place, "s");
            G(put_knot)(&K, place, x, &L);
            int mu = G(span_of_interval)(K.count, K.place, place);
            G(bspline_insert)(over(&K, dim, c), mu, x, v, d);
            if (T->faulty && p > 0)
                for (int e = 0; e < dim; e++)
                    d[mu * dim + e] = d[(mu - 1) * dim + e];
            about(T, "the knots");
            for (int i = 0; i < L.count; i++)
                same(T, v[i], L.u[i]);
            about(T, "the curve");
            G(same_spline)(T, dim, &K, c, &L, d);
        }
    }
}

/*
:::{claim} boehm_insertion_keeps_curve
:title: Boehm's insertion changes the points, not the curve
:zh: Boehm 插入节点不改变曲线
:given: several segments, the distinct knots variables, points; a new knot $x$ in every interval of the domain and at every knot
  of it of multiplicity at most $p$
:then: the knots of `bspline_insert` are the old ones and $x$; the spline of its $n+1$ points is the old one on every interval
:method: Both splines in powers of $t$ minus the knot on the left of each new interval, from the recursion of de Boor and Cox
  by its letter; $x$, knots and points are variables.
:degrees: 0..4 sampled 8
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3
:over: s: new knot
:defines: bspline_insert
:control: the last of the new points is replaced by its neighbour
:::
*/
CLAIM(boehm_insertion_keeps_curve) { G(check_boehm_insertion_keeps_curve)(T, 0); }

#if FIELD
/*
:::{claim} boehm_insertion_in_higher_degrees
:title: Boehm's insertion in higher degrees
:zh: 高次时的插入节点
:given: several segments over the knots $0,1,3,6,10,\dots$ with simple and with clamped ends; points, variables; a new knot $x$, a variable, in every interval of the domain and at every knot
  of it of multiplicity at most $p$
:then: the knots of `bspline_insert` are the old ones and $x$; the spline of its $n+1$ points is the old one on every interval
:method: Both splines in powers of $t$ minus the knot on the left of each new interval, from the recursion of de Boor and Cox
  by its letter.
:types: field
:degrees: 6..6
:scope: an inner knot of every multiplicity up to k between simple and clamped ends;
  the distinct knots $0,1,3,6,10,\dots$
:over: s: new knot
:control: the last of the new points is replaced by its neighbour
:::
*/
CLAIM(boehm_insertion_in_higher_degrees) { G(check_boehm_insertion_keeps_curve)(T, INTEGERS); }
#endif

/*
Two insertions in either order give the same points, because the curve and its knots determine the points, where the B-splines
over the finer knots are independent. As a test of the kernel it is sharper than it looks, for the second insertion finds $x$ and
$y$ in different spans and with different multiplicities, depending on which came first.

:::{claim} bspline_insertions_commute
:title: The order of insertions does not matter
:zh: 插入节点的次序无关
:given: several segments, the distinct knots variables, points; new knots $x$ and $y$ in any two places of the domain, also in
  one interval with $x<y$, also the same knot
:then: inserting $x$ and then $y$ gives the points that inserting $y$ and then $x$ gives
:method: Both by `bspline_insert`, everything a variable.
:degrees: 0..6 sampled 8
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:harmless: with $x<y$ | also the same knot, and the other order is what is compared
:over: r s q: new knot
:control: the second order inserts $y$ at the mean of $x$ and $y$
:::
*/
CLAIM(bspline_insertions_commute)
{
    int p = T->degree;
    struct G(knot_vector) K = {0}, X, Y;
    num c[MOST_KNOTS * dim], d[MOST_KNOTS * dim], e[MOST_KNOTS * dim], f[MOST_KNOTS * dim], v[MOST_KNOTS],
        w[MOST_KNOTS];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, dim, c);
        for (int at = K.place[p]; at < K.place[K.n]; at++)
            for (int then = at; then < K.place[K.n]; then++) {
                if (G(multiplicity_at)(&K, at) + (at == then) > p || G(multiplicity_at)(&K, then) > p)
                    continue;
                int mu = G(span_of_interval)(K.count, K.place, at), nu = G(span_of_interval)(K.count, K.place, then);
                num x = G(knot_for)(T, &K, at, "s"), y = G(knot_for)(T, &K, then, "r");
                if (at == then && at % 2 == 1)
                    y = add(x, mul(parameter(T, "q"), sub(K.u[mu + 1], x)));
                G(put_knot)(&K, at, x, &X);
                G(bspline_insert)(over(&K, dim, c), mu, x, v, d);
                G(bspline_insert)(over(&X, dim, d), nu + 1, y, v, e);
                y = fault(T, y, mul(from_ratio(1, 2), add(x, y)));
                G(put_knot)(&K, then, y, &Y);
                G(bspline_insert)(over(&K, dim, c), nu, y, v, d);
                G(bspline_insert)(over(&Y, dim, d), mu, x, w, f);
                for (int i = 0; i < (K.n + 2) * dim; i++)
                    same(T, f[i], e[i]);
            }
    }
}

/*
If a knot is inserted again and again, fewer points are new each time, until, at the multiplicity $p$, one of them lies on the
curve. The triangle that arises is de Boor's: to evaluate and to insert a knot are one computation (重复插入节点).

:::{claim} repeated_insertion_is_deboor
:title: After insertion up to the multiplicity p the curve is a control point
:zh: 重复插入节点至 p 重得曲线上的点
:given: several segments, the distinct knots variables, points, $p\ge1$; $x$ in every interval and at every knot of multiplicity
  $s\le p$ of the domain
:then: after $r$ insertions of $x$, $r=1,\dots,p-s$, the points $\mu-p+r,\dots,\mu-s$ are those of level $r$ of de Boor's triangle at $x$; after $p-s$ of them
  one of the points is $s(x)$
:method: The kernel again and again, against `bspline_deboor_level`; in the end the point with the index of the last knot of the span in which $x$ was, minus $s$, against
  the sum of all B-splines from the recursion by its letter.
:degrees: 1..6 sampled 8
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:harmless: $s\le p$ | a knot of multiplicity $p+1$ needs no insertion
:over: s: new knot
:control: the next point
:::
*/
CLAIM(repeated_insertion_is_deboor)
{
    int p = T->degree;
    struct G(knot_vector) K = {0}, L;
    num c[MOST_KNOTS * dim], d[MOST_KNOTS * dim], e[MOST_KNOTS * dim], w[MOST_KNOTS], level[(MAX_DEGREE + 1) * dim];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, dim, c);
        for (int place = K.place[p]; place < K.place[K.n]; place++) {
            int s = G(multiplicity_at)(&K, place), mu = G(span_of_interval)(K.count, K.place, place);
            if (s > p || mu - s < p)
                continue;
            num x = G(knot_for)(T, &K, place, "s");
            for (int i = 0; i < K.n * dim; i++)
                d[i] = c[i];
            for (int i = 0; i < (p + 1) * dim; i++)
                level[i] = c[(mu - p) * dim + i];
            L = K;
            about(T, "the levels of de Boor's triangle");
            for (int more = 0; more < p - s; more++) {
                G(bspline_insert)(spline(p, K.n + more, dim, L.u, d), mu + more, x, w, e);
                G(put_knot)(&L, place, x, &L);
                for (int i = 0; i < (K.n + more + 1) * dim; i++)
                    d[i] = e[i];
                int r = more + 1, first = mu - p + r;
                G(bspline_deboor_level)(G(on_span)(p, dim, K.u, mu, NULL), r, level, x);
                for (int i = 0; i < (mu - s - first + 1) * dim; i++)
                    same(T, d[first * dim + i], level[i]);
            }
            about(T, "the point of the curve");
            for (int i = 0; i < dim; i++)
                same(T, d[fault(T, mu - s, mu - s + 1) * dim + i],
                     G(spline_value)(K.n, p, dim, K.u, K.place, c, i, place, x));
        }
    }
}

#if FIELD || RATIONAL
/*
Each new point lies on an edge of the polygon before, strictly between its ends if the knot is new. So insertion cuts corners
(割角), and the new polygon lies in the hull of the old one. The sections on convexity and on variation use the same ratios, with
weights.

:::{claim} inserted_points_divide_edges
:title: A new point divides an edge from the inside
:zh: 插入节点即割角
:given: several segments, the lengths between distinct knots positive variables; a knot $x$ inside an interval of the domain, at
  positive distances from its ends
:then: the new points are $d_i=(1-a_i)c_{i-1}+a_ic_i$ with $0\le a_i\le1$, and $0<a_i<1$ for the $p$ points $i=\mu-p+1,\dots,\mu$:
  the insertion cuts corners of the polygon
:method: The kernel applied to the points $c_i=1$ and all others $0$ gives the coefficients of $c_i$ one after the other; they are
  fractions with positive coefficients only, and the two of a new point sum to 1.
:types: field rational
:degrees: 1..6 sampled 8
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:over: x: -; a b: distance of the new knot from the ends of its interval
:control: the coefficient of the point before
:::
*/
CLAIM(inserted_points_divide_edges)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = LENGTHS};
    num c[MOST_KNOTS], d[MOST_KNOTS], sum[MOST_KNOTS], v[MOST_KNOTS];
    for (int k = G(segment_knots)(T, p, 0, &K); k > 0; k = G(segment_knots)(T, p, k, &K)) {
        num a = positive(T, "a", 0), b = positive(T, "b", 0), x = add(K.u[p], a);
        num shift = sub(add(x, b), K.u[p + 1]); /* the interval has the length a+b */
        for (int i = p + 1; i < K.count; i++)
            K.u[i] = add(K.u[i], shift);
        for (int i = 0; i <= K.n; i++)
            sum[i] = from_int(0);
        for (int one = 0; one < K.n; one++) {
            for (int i = 0; i < K.n; i++)
                c[i] = from_int(i == one);
            G(bspline_insert)(over(&K, 1, c), p, x, v, d);
            for (int i = 0; i <= K.n; i++) {
                sum[i] = add(sum[i], d[i]);
                if ((i == one || i == fault(T, one + 1, one + 2)) && 0 < i && i < K.n)
                    G(must_be_positive)(T, d[i]);
                else if (!(i == 0 && one == 0) && !(i == K.n && one == K.n - 1))
                    vanishes(T, d[i]);
                else
                    same(T, d[i], from_int(1));
            }
        }
        for (int i = 0; i <= K.n; i++)
            same(T, sum[i], from_int(1));
    }
}
#endif

/*
## Refinement

Over a finer knot vector every point is a value of the polar form at consecutive knots.  The Oslo algorithm computes each of
them on its own, Boehm's algorithm one knot after the other.
*/

/* The knots that are added, one after the other, to K and to the points c, by Boehm's insertion. */
static void G(refined)(trial *T, const struct G(knot_vector) * K, const num c[], struct G(knot_vector) * L, num d[])
{
    int p = K->p, lowest = K->place[p], highest = K->place[K->n];
    num e[MOST_KNOTS * dim], v[MOST_KNOTS], x = from_int(0);
    *L = *K;
    for (int i = 0; i < K->n * dim; i++)
        d[i] = c[i];
    for (int place = lowest; place < highest; place++) {
        int inside = place % 2 == 1, last = place == highest - 1;
        int times = inside ? (place == lowest + 1) + 2 * last : place > lowest && G(multiplicity_at)(K, place) <= p;
        for (int more = 0; more < times && G(multiplicity_at)(L, place) <= p; more++) {
            if (more == 0)
                x = G(knot_for)(T, K, place, last ? "r" : "s");
            G(bspline_insert)(over(L, dim, d), G(span_of_interval)(L->count, L->place, place), x, v, e);
            G(put_knot)(L, place, x, L);
            for (int i = 0; i < L->n * dim; i++)
                d[i] = e[i];
        }
    }
}

/* Compare, for several segments over knots of that kind: the points of the Oslo algorithm with those of repeated insertion,
 * for the first and the last admissible spans; and both splines. */
static void G(check_refinement_keeps_curve)(trial *T, int kind)
{
    int p = T->degree, span[MOST_KNOTS];
    struct G(knot_vector) K = {.kind = kind}, L;
    num c[MOST_KNOTS * dim], d[MOST_KNOTS * dim], boehm[MOST_KNOTS * dim];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, dim, c);
        G(refined)(T, &K, c, &L, boehm);
        for (int last = 0; last <= 1; last++) {
            if (!G(spans_over)(&K, L.n, p, L.place, last, span))
                continue;
            G(bspline_refine)(over(&K, dim, c), L.n, L.u, span, d);
            if (T->faulty && L.n > p + 1)
                G(bspline_blossom)(G(on_span)(p, dim, K.u, span[p], c), L.u + p, d + p * dim);
            about(T, "the points of repeated insertion");
            for (int i = 0; i < L.n * dim; i++)
                same(T, d[i], boehm[i]);
        }
        about(T, "the curve");
        if (G(spans_over)(&K, L.n, p, L.place, 0, span))
            G(same_spline)(T, dim, &K, c, &L, d);
    }
}

/*
A point over the finer knots does not depend on the order in which they were inserted, only on the knots $v_{j+1},\dots,v_{j+p}$
next to it. That the two algorithms agree point by point is therefore a second proof of both. It also does not matter from which
segment a point is computed, though neighbouring segments have different polar forms: at the knots of the point they agree.

:::{claim} refinement_keeps_curve
:title: The Oslo algorithm changes the points, not the curve, and agrees with repeated insertion
:zh: Oslo 算法加细节点不改变曲线
:given: several segments, each point with a span in the domain, the distinct knots variables, points; to the knots of the domain are added: one in the first interval,
  two equal ones in the last, and one more at each inner knot of multiplicity at most $p$
:then: the spline of the points of `bspline_refine` is the old one; its points are those of inserting one knot after the other;
  it does not matter which admissible span a point is computed from
:method: Both splines in powers, from the recursion by its letter; the points against those of `bspline_insert`; once with the
  first admissible span for every point, once with the last.
:degrees: 0..4 sampled 8
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3
:over: s r: new knot
:defines: bspline_refine
:control: one point computed with the knots of its neighbour
:::
*/
CLAIM(refinement_keeps_curve) { G(check_refinement_keeps_curve)(T, 0); }

#if FIELD
/*
:::{claim} refinement_in_higher_degrees
:title: The Oslo algorithm in higher degrees
:zh: 高次时的 Oslo 算法
:given: several segments over the knots $0,1,3,6,10,\dots$ with simple and with clamped ends; points, variables; to the knots of the domain are added: one in the first interval,
  two equal ones in the last, and one more at each inner knot of multiplicity at most $p$
:then: the spline of the points of `bspline_refine` is the old one; its points are those of inserting one knot after the other;
  it does not matter which admissible span a point is computed from
:method: Both splines in powers, from the recursion by its letter; the points against those of `bspline_insert`; once with the
  first admissible span for every point, once with the last.
:types: field
:degrees: 6..6
:scope: an inner knot of every multiplicity up to k between simple and clamped ends;
  the distinct knots $0,1,3,6,10,\dots$
:over: s r: new knot
:control: one point computed with the knots of its neighbour
:::
*/
CLAIM(refinement_in_higher_degrees) { G(check_refinement_keeps_curve)(T, INTEGERS); }
#endif

#include "chapters/judge/claims_off.h"
