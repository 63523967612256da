/*
# Properties, one side and the other of a knot (性质,节点两侧)

The source passes the properties (性质) over with a word, "similar". Most of what B-spline curves have carries over because a NURBS
curve is one in homogeneous coordinates; what needs a mean, like the hull, needs positive weights besides, and what is said about
the curve itself rather than about its homogeneous form has to be carried through the quotient.
*/
#include "exact/record/hull.h"

#include "chapters/nurbs/definition.h"
#include "chapters/nurbs/discrete.h"
#include "chapters/nurbs/patterns.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch4:properties-2.3
:title: Properties similar to those of B-spline curves
:zh: 与 B 样条曲线性质 2.3.1-2.3.7 类似的性质
:printed: The curve (4.1.2) also has properties similar to 2.3.1-2.3.7; as those of its special cases are treated in the chapters before, they can easily be written down
  one by one (preface)
:reading: moved_point_changes_its_support | local control: moving $r_i$, or changing $w_i$, changes the curve on
  $[t_i,t_{i+k}]$ only
:reading: point_is_in_the_hull_of_k_points | convex hull, span by span, for positive weights
:reading: negative_weight_leaves_the_hull | convex hull for weights of both signs
:reading: sides_agree_up_to_order_less_multiplicity | continuity of order $k-1-m$ at a knot of multiplicity $m$ | Where the derivatives of the basis functions agree, those
  of numerator and denominator do, and where $w(t)\ne0$ by the rule for quotients those of the curve.
:reading: one_order_more_jumps | continuity of one order more
:reading: nurbs_moves_with_its_points | affine invariance
:reading: end_points_of_clamped_knots | the polygon begins with the curve, when $t_2=\dots=t_k<t_{k+1}$; and ends with it when
  $t_n<t_{n+1}=\dots=t_{n+k-1}$
:reading: simple_knots_need_other_points | the polygon begins with the curve over simple knots
:reading: reversed_data_reverse_the_nurbs | symmetry
:reading: periodic_data_close_the_curve | periodic data give a closed curve, as smooth at the seam as elsewhere | Where the derivatives of numerator and
  denominator agree, those of the curve do where $w(t)\ne0$, by the rule for quotients.
:figure: knot_vectors

Chapter 2 of the source is not part of the text at hand, so that the seven numbers cannot be matched one by one.
:::
*/

/*
:::{claim} moved_point_changes_its_support
:title: A moved point and a changed weight act on k intervals of knots only
:zh: 局部性
:given: several segments, the distinct knots variables; points, weights; any $\Delta$, positive $\delta$; every $i$, interval and $t$
:then: $r_i+\Delta$ in the place of $r_i$ changes $r(t)$ by $N_{i,k}w_i\Delta/w(t)$; $w_i+\delta$ in the place of $w_i$ changes it
  by $N_{i,k}\delta\,(r_i-r(t))/(w(t)+N_{i,k}\delta)$, towards $r_i$; both are $0$ on the intervals
  outside $[t_i,t_{i+k}]$
:method: All terms of the definition, before and after.
:degrees: 1..6 sampled 6
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 3, numbers above
:over: d: shift of a point; e: positive increment of a weight
:where: $w(t)\ne0$ with the old and with the new weight
:control: $\Delta$ doubled on the right
:::
*/
CLAIM(moved_point_changes_its_support)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = FIELD && p > 2 ? INTEGERS : 0};
    num R[MOST_KNOTS], w[MOST_KNOTS], P, Q, t = unknown(T, "t", 0);
    num move = unknown(T, "d", 0), more = positive(T, "e", 0), applied = fault(T, move, add(move, move));
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        int n = K.n;
        G(weighted_points)(T, n, 1, R, w);
        for (int interval = K.place[p]; interval < K.place[n]; interval += 2) {
            num N[MOST_KNOTS];
            for (int i = 0; i < n; i++)
                N[i] = G(cox_de_boor)(p, K.u, K.place, i, interval, t);
            num total = G(nurbs_of_basis)(n, 1, N, R, w, &P);
            for (int i = 0; i < n; i++) {
                num old = R[i], weight = w[i];
                R[i] = add(old, move);
                G(nurbs_of_basis)(n, 1, N, R, w, &Q);
                about(T, "the point moved"); /* by N_i w_i Δ / w(t) */
                same(T, sub(Q, P), div(mul(mul(N[i], weight), applied), total));
                R[i] = old;
                w[i] = add(weight, more);
                num greater = G(nurbs_of_basis)(n, 1, N, R, w, &Q);
                about(T, "the weight changed"); /* N_i δ (r_i - r(t)) / (w(t) + N_i δ) */
                same(T, sub(Q, P), div(mul(mul(N[i], more), sub(old, P)), greater));
                w[i] = weight;
                if (interval < K.place[i] || K.place[i + p + 1] <= interval) {
                    about(T, "outside the support");
                    vanishes(T, N[i]);
                }
            }
        }
    }
}

#if FIELD || RATIONAL
/*
:::{claim} point_is_in_the_hull_of_k_points
:title: A point of the curve is a mean of the k points of its span, with shares that are not negative
:zh: 分段凸包性
:types: field rational
:given: several segments, with any positive gaps of the knots; positive weights, points of space; $t=x_m+(x_{m+1}-x_m)\frac s{1+s}$, $s>0$, in each interval, and both its ends, the right one as a limit from the left
:then: $r(t)=\sum_{i=j-k+1}^j\lambda_ir_i$ with $\lambda_i=N_{i,k}(t)w_i/w(t)\ge0$ and $\sum_{i=j-k+1}^j\lambda_i=1$: $r(t)$ is in the convex hull of
  $r_{j-k+1},\dots,r_j$
:method: The point by the kernel; the shares by the recursion by its letter, $w(t)$ being the sum of all $n$ terms; signs are read off coefficients in $s$, the gaps and
  the weights.
:degrees: 1..5
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:over: s: ratio in which t divides its interval; x: -
:control: the share of the first of the $k$ points given to the second as well
:::
*/
CLAIM(point_is_in_the_hull_of_k_points)
{
    enum { dim = 3 };
    int p = T->degree;
    struct G(knot_vector) K = {.kind = FIELD && p > 4 ? INTEGERS : LENGTHS};
    num R[dim * MOST_KNOTS], w[MOST_KNOTS], P[dim];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(weighted_points)(T, K.n, dim, R, w);
        for (int interval = K.place[p]; interval < K.place[K.n]; interval += 2) {
            int mu = G(span_of_interval)(K.count, K.place, interval), first = mu - p;
            num at[3] = {add(K.u[mu], mul(sub(K.u[mu + 1], K.u[mu]), inside(T, "s"))), K.u[mu], K.u[mu + 1]};
            for (int end = 0; end < 3; end++) { /* inside, and at both ends */
                num t = at[end];
                num total = G(spline_value)(K.n, p, 1, K.u, K.place, w, 0, interval, t), sum = from_int(0);
                num mean[dim] = {sum, sum, sum};
                for (int i = first; i <= mu; i++) {
                    int from = fault(T, i, i == first + 1 ? first : i);
                    num share = div(mul(G(cox_de_boor)(p, K.u, K.place, from, interval, t), w[from]), total);
                    about(T, "the sign of a share");
                    nonnegative(T, share);
                    sum = add(sum, share);
                    for (int c = 0; c < dim; c++)
                        mean[c] = add(mean[c], mul(share, R[dim * i + c]));
                }
                about(T, "the sum of the shares");
                same(T, sum, from_int(1));
                about(T, "the point");
                G(nurbs_point)(G(nurbs_on_span)(p, dim, K.u, mu, R, w), t, P);
                for (int c = 0; c < dim; c++)
                    same(T, P[c], mean[c]);
            }
        }
    }
}
#endif

#if RATIONAL
/*
:::{claim} negative_weight_leaves_the_hull
:title: With a negative weight the curve leaves the hull
:zh: 负权因子破坏凸包性
:kind: counterexample
:given: a quadratic segment of the points $r$, a triangle, over the knots $T$, with weights $w$ of which one is negative, and $t$
:data: T = 0 0 0 1 1 1; r = (0,0) (1,1) (2,0); w = 1 -1/2 1; t = 1/2
:instead: w = 1 1/2 1
:then: $r(t)$ is not in the triangle
:result: r(t) = (1,-1)
:method: Membership is decided with a certificate.
:control: all weights positive
:::
*/
CLAIM(negative_weight_leaves_the_hull)
{
    num u[6], R[6], w[3], P[2];
    given_points(T, "T", 6, 1, u);
    given_points(T, "r", 3, 2, R);
    given_points(T, "w", 3, 1, w);
    G(nurbs_point)(G(nurbs_on_span)(2, 2, u, 2, R, w), given(T, "t"), P);
    found_points(T, "r(t)", 1, 2, P);
    about(T, "the point is in the hull");
    agree(T, hull_membership(2, 3, R, P).inside);
}
#endif

/*
An affine map acts on the points and leaves the weights alone. This is the reason for keeping the two apart: in homogeneous
coordinates the translation of a point also changes $w_ix_i$ in proportion to its weight.

:::{claim} nurbs_moves_with_its_points
:title: An affine map of the points is the same map of the curve
:zh: 仿射不变性
:given: several segments, the distinct knots variables; weights, points of space; any interval of the domain; an affine map, of whose coordinates
  one is taken, $m_0x+m_1y+m_2z+v$; any $t$
:then: the curve of the mapped points with the same weights is the mapped curve
:method: The definition, everything a variable; every coordinate of an affine map is such a form.
:degrees: 1..6 sampled 6
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 3, numbers above
:over: m# v#: affine maps
:where: $w(t)\ne0$
:control: the last point of the span is not moved
:::
*/
CLAIM(nurbs_moves_with_its_points)
{
    enum { dim = 3 };
    int p = T->degree;
    struct G(knot_vector) K = {.kind = FIELD && p > 2 ? INTEGERS : 0};
    num R[dim * MOST_KNOTS], S[MOST_KNOTS], w[MOST_KNOTS], m[dim], P[dim], Q;
    num v = unknown(T, "v", 0), t = unknown(T, "t", 0);
    for (int c = 0; c < dim; c++)
        m[c] = unknown(T, "m", c);
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(weighted_points)(T, K.n, dim, R, w);
        for (int interval = K.place[p]; interval < K.place[K.n]; interval += 2) {
            int mu = G(span_of_interval)(K.count, K.place, interval);
            for (int i = 0; i < K.n; i++) {
                S[i] = v;
                for (int c = 0; c < dim; c++)
                    S[i] = add(S[i], mul(m[c], R[dim * i + c]));
                S[i] = fault(T, S[i], i == mu ? R[dim * i] : S[i]);
            }
            G(nurbs_by_definition)(K.n, p, dim, K.u, K.place, R, w, interval, t, P);
            G(nurbs_by_definition)(K.n, p, 1, K.u, K.place, S, w, interval, t, &Q);
            num image = v;
            for (int c = 0; c < dim; c++)
                image = add(image, mul(m[c], P[c]));
            same(T, Q, image);
        }
    }
}

/*
:::{claim} reversed_data_reverse_the_nurbs
:title: Points, weights and knots in the opposite order give the curve backwards
:zh: 数据反序,曲线反向
:given: several segments, the distinct knots variables; points, weights; any interval of the domain, any $t$
:then: the curve of $r_n,\dots,r_1$, $w_n,\dots,w_1$ and knots $-t_{n+k},\dots,-t_1$ at $-t$ is $r(t)$
:method: The definition, everything a variable.
:degrees: 1..6 sampled 6
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:where: $w(t)\ne0$
:control: the weights are not reversed
:::
*/
CLAIM(reversed_data_reverse_the_nurbs)
{
    int p = T->degree, place[MOST_KNOTS];
    struct G(knot_vector) K = {0};
    num R[MOST_KNOTS], w[MOST_KNOTS], P, Q, t = unknown(T, "t", 0);
    num y[MOST_KNOTS], S[MOST_KNOTS], z[MOST_KNOTS];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        int n = K.n, last = K.place[K.count - 1];
        G(weighted_points)(T, n, 1, R, w);
        for (int i = 0; i < K.count; i++) {
            y[i] = neg(K.u[K.count - 1 - i]);
            place[i] = last - K.place[K.count - 1 - i];
        }
        for (int i = 0; i < n; i++) {
            S[i] = R[n - 1 - i];
            z[i] = w[fault(T, n - 1 - i, i)];
        }
        for (int interval = K.place[p]; interval < K.place[n]; interval += 2) { /* backwards from last - 2 */
            G(nurbs_by_definition)(n, p, 1, K.u, K.place, R, w, interval, t, &P);
            G(nurbs_by_definition)(n, p, 1, y, place, S, z, last - 2 - interval, neg(t), &Q);
            same(T, Q, P);
        }
    }
}

/*
## At a knot (节点处的单侧值)

:::{claim} sides_agree_up_to_order_less_multiplicity
:title: At an m-fold knot the first k-1-m derivatives from both sides agree
:zh: m 重节点处两侧 k-1-m 阶以内的导数相等
:given: $k\ge2$, an $m$-fold knot, $1\le m\le k-1$, with $k$ simple knots on either side, values variables
:then: for all $i$ and $0\le r\le k-1-m$ the derivatives $N_{i,k}^{(r)}$ from the left and from the right are equal; hence so are
  the derivatives of numerator and denominator, and by the rule for quotients those of the NURBS curve
:method: The derivatives by the kernel on the two spans that meet at the knot; functions that do not count on a span are $0$ there.
:degrees: 1..6 sampled 8
:scope: a knot of every multiplicity below k among simple ones
:control: the order $k-m$ as well
:::
*/
CLAIM(sides_agree_up_to_order_less_multiplicity)
{
    int p = T->degree, place[MOST_KNOTS];
    num x[MOST_KNOTS], u[MOST_KNOTS], left[81], right[81];
    G(distinct_knots)(T, 2 * p + 3, 6, x);
    for (int m = 1; m <= p; m++) {
        char pattern[MOST_KNOTS] = "";
        memset(pattern, '1', (size_t)(2 * p + 3));
        pattern[p + 1] = (char)('0' + m);
        G(knots_at)(pattern, x, u, place);
        int before = p, after = p + m, orders = fault(T, p - m + 1, p - m + 2);
        G(bspline_basis_derivatives)(p, u, before, x[p + 1], orders - 1, left);
        G(bspline_basis_derivatives)(p, u, after, x[p + 1], orders - 1, right);
        for (int r = 0; r < orders; r++)
            for (int i = 0; i <= after; i++) {
                num from_left = i <= before ? left[r * (p + 1) + i] : from_int(0);
                num from_right = i >= m ? right[r * (p + 1) + i - m] : from_int(0);
                same(T, from_left, from_right);
            }
    }
}

#if !FIELD
/*
For the basis this is a statement about single functions. Numerator and denominator then have the same derivatives from both
sides, and the rule for quotients gives those of the curve from them. Curvature needs two and torsion three of them. The
next claim shows a quadratic curve with a simple knot where the next derivative jumps, and the curvature with it.

:::{claim} nurbs_sides_agree
:title: Value, derivatives, curvature and torsion of the curve from both sides
:zh: 曲线在节点两侧的值、导矢、曲率与挠率
:types: rational interval double
:given: random knots, weights and points of space; an $m$-fold inner knot, $1\le m\le k-1$
:then: the derivatives of $r$ up to order $k-1-m$ agree; for $m\le k-3$ so do the curvatures, for $m\le k-4$ the torsions
:method: The kernels for the rational curve on both spans.
:degrees: 1..4 sampled 6
:control: one of the weights on the right of the knot changed
:::
*/
CLAIM(nurbs_sides_agree)
{
    int p = T->degree;
    for (int m = 1; m <= p; m++) {
        num u[MOST_KNOTS], R[3 * MOST_KNOTS], w[MOST_KNOTS], left[3 * MAX_DEGREE], right[3 * MAX_DEGREE];
        int before = p, after = p + m;
        u[0] = unknown(T, "x", 0);
        for (int i = 1; i <= 2 * p + m + 1; i++)
            u[i] = p + 1 < i && i <= p + m ? u[i - 1] : add(u[i - 1], positive(T, "h", i));
        G(weighted_points)(T, p + m + 1, 3, R, w);
        num t = u[p + 1];
        G(nurbs_derivatives)(G(nurbs_on_span)(p, 3, u, before, R, w), t, p - m, left);
        w[p] = fault(T, w[p], add(w[p], from_int(1)));
        G(nurbs_derivatives)(G(nurbs_on_span)(p, 3, u, after, R, w), t, p - m, right);
        about(T, "the derivatives");
        for (int r = 0; r < 3 * (p - m + 1); r++)
            same(T, left[r], right[r]);
        if (p - m >= 2) {
            about(T, "the squares of the curvatures");
            num from_left = G(nurbs_curvature_squared)(G(nurbs_on_span)(p, 3, u, before, R, w), t);
            same(T, from_left, G(nurbs_curvature_squared)(G(nurbs_on_span)(p, 3, u, after, R, w), t));
        }
        if (p - m >= 3) {
            about(T, "the torsions");
            num from_left = G(nurbs_torsion)(G(nurbs_on_span)(p, 3, u, before, R, w), t);
            same(T, from_left, G(nurbs_torsion)(G(nurbs_on_span)(p, 3, u, after, R, w), t));
        }
    }
}
#endif

#if RATIONAL
/*
:::{claim} one_order_more_jumps
:title: The next derivative may jump, and with it the curvature
:zh: 高一阶的导矢一般间断
:kind: counterexample
:given: a quadratic curve of the points $r$ and weights $w$ over the knots $T$; its simple inner knot $t$, where derivatives are continuous
  up to the order $k-1-m=1$; and the next order
:data: T = 0 0 0 1 2 2 2; r = (0,0) (1,0) (2,1) (2,3); w = 1 1 1 1; t = 1; order = 2
:instead: order = 1
:then: the derivative of that order, and $\kappa^2$ with it, is different on the two sides
:result: derivative from the left = (-1,1); derivative from the right = (-1,3); κ² from the left = 1/2; κ² from the right = 2
:method: Both sides by the kernels.
:control: the order before
:::
*/
CLAIM(one_order_more_jumps)
{
    num u[7], R[8], w[4], left[6], right[6];
    given_points(T, "T", 7, 1, u);
    given_points(T, "r", 4, 2, R);
    given_points(T, "w", 4, 1, w);
    num t = given(T, "t");
    int order = given_whole(T, "order");
    const num *from_left = left + 2 * order, *from_right = right + 2 * order;
    G(nurbs_derivatives)(G(nurbs_on_span)(2, 2, u, 2, R, w), t, 2, left);
    G(nurbs_derivatives)(G(nurbs_on_span)(2, 2, u, 3, R, w), t, 2, right);
    num bent_left = G(nurbs_curvature_squared)(G(nurbs_on_span)(2, 2, u, 2, R, w), t);
    num bent_right = G(nurbs_curvature_squared)(G(nurbs_on_span)(2, 2, u, 3, R, w), t);
    found_points(T, "derivative from the left", 1, 2, from_left);
    found_points(T, "derivative from the right", 1, 2, from_right);
    found(T, "κ² from the left", bent_left);
    found(T, "κ² from the right", bent_right);
    int agrees = equal_q(from_left[0], from_right[0]) && equal_q(from_left[1], from_right[1]);
    about(T, "the derivative, or at least the curvature, is the same from both sides");
    refute(T, !agrees && !equal_q(bent_left, bent_right));
}

/*
:::{claim} k_fold_knot_tears_the_curve
:title: At a k-fold knot the curve has two values
:zh: k 重节点处曲线断开
:kind: counterexample
:given: a linear curve of the points $r$ and weights $w$ over the knots $T$, and its twofold inner knot $t$
:data: T = 0 0 1 1 2 2; r = (0,0) (1,1) (2,1) (3,0); w = 1 1 1 1; t = 1
:instead: r = (0,0) (1,1) (1,1) (3,0)
:then: the values $r(t-)$ from the left and $r(t+)$ from the right are different points
:result: r(t-) = (1,1); r(t+) = (2,1)
:method: Both sides from the definition.
:control: the points on both sides of the knot the same
:::
*/
CLAIM(k_fold_knot_tears_the_curve)
{
    int place[6];
    num u[6], R[8], w[4], left[2], right[2];
    G(given_knots)(T, "T", 6, u, place);
    given_points(T, "r", 4, 2, R);
    given_points(T, "w", 4, 1, w);
    num t = given(T, "t");
    G(nurbs_by_definition)(4, 1, 2, u, place, R, w, G(interval_before)(6, u, place, t), t, left);
    G(nurbs_by_definition)(4, 1, 2, u, place, R, w, G(interval_after)(6, u, place, t), t, right);
    found_points(T, "r(t-)", 1, 2, left);
    found_points(T, "r(t+)", 1, 2, right);
    about(T, "the values from the left and from the right");
    for (int c = 0; c < 2; c++)
        same(T, left[c], right[c]);
}
#endif

#if FIELD
/*
:::{claim} nurbs_derivatives_are_derivatives
:title: Derivatives, curvature and torsion of the kernels are those of the rational functions
:zh: 核函数所算的导矢、曲率与挠率
:types: field
:given: the middle $2k$ of the knots $T$, weights and points, any $t$; orders of differentiation up to that of the torsion
:data: T = -4 -3 -2 0 0 1 3 3 4 6; w = 1 3 2 5 7; τ = 1/3
:then: `nurbs_derivatives` gives the derivatives of (4.1.2); `nurbs_curvature_squared` and `nurbs_torsion` give
  $|r'\times r''|^2/|r'|^6$ and $(r',r'',r^{(3)})/|r'\times r''|^2$
:method: Derivatives of the quotient of sums as rational functions of $t$, for any weights; curvature and torsion at $t=\tau$ with the first
  $k$ of the weights $w$ and points of which one coordinate is a variable.
:degrees: 2..4
:scope: the given knots
:defines: nurbs_derivatives nurbs_curvature_squared nurbs_torsion
:control: the weights 1 for the kernels
:::
*/
CLAIM(nurbs_derivatives_are_derivatives)
{
    enum { order = 3, dim = 3, most = 4, all_knots = 2 * most + 2 };
    int p = T->degree, all_places[all_knots];
    num all[all_knots], weight[most + 1], ones[most + 1], R[dim * (most + 1)], w[most + 1];
    num D[dim * (order + 1)], formal[dim * (order + 1)], t = variable_f("t");
    G(given_knots)(T, "T", all_knots, all, all_places);
    given_points(T, "w", most + 1, 1, weight);
    num tau = given(T, "τ");
    const num *u = all + most - p;
    const int *place = all_places + most - p, interval = place[p];
    for (int i = 0; i <= p; i++)
        ones[i] = from_int(1);

    G(weighted_points)(T, p + 1, 1, R, w);
    G(nurbs_by_definition)(p + 1, p, 1, u, place, R, w, interval, t, formal);
    G(nurbs_derivatives)(G(nurbs_on_span)(p, 1, u, p, R, fault(T, w, ones)), t, order, D);
    about(T, "the derivatives");
    for (int k = 0; k <= order; k++) {
        same(T, D[k], formal[0]);
        formal[0] = derivative_f(formal[0], t);
    }

    for (int i = 0; i <= p; i++) {
        R[dim * i] = unknown(T, "a", i);
        R[dim * i + 1] = from_int(i * i);
        R[dim * i + 2] = from_int(i * i * i - 2 * i);
    }
    G(nurbs_by_definition)(p + 1, p, dim, u, place, R, weight, interval, t, formal);
    for (int m = dim; m < dim * (order + 1); m++)
        formal[m] = derivative_f(formal[m - dim], t);
    for (int m = 0; m < dim * (order + 1); m++)
        formal[m] = substitute_f(formal[m], t, tau);
    num square = from_int(0), speed = from_int(0), mixed = from_int(0);
    for (int c = 0; c < dim; c++) { /* |r' x r''|^2, |r'|^2 and (r', r'', r''') */
        int i = (c + 1) % dim, j = (c + 2) % dim;
        num cross = sub(mul(formal[dim + i], formal[2 * dim + j]), mul(formal[dim + j], formal[2 * dim + i]));
        square = add(square, mul(cross, cross));
        speed = add(speed, mul(formal[dim + c], formal[dim + c]));
        mixed = add(mixed, mul(cross, formal[3 * dim + c]));
    }
    about(T, "the square of the curvature");
    same(T, G(nurbs_curvature_squared)(G(nurbs_on_span)(p, dim, u, p, R, fault(T, weight, ones)), tau),
         div(square, mul(speed, mul(speed, speed))));
    about(T, "the torsion");
    same(T, G(nurbs_torsion)(G(nurbs_on_span)(p, 3, u, p, R, fault(T, weight, ones)), tau), div(mixed, square));
}
#endif

/*
## At an end (端点)

At the end of a clamped curve the formulas are those of a rational Bézier curve, except that lengths of knot intervals appear. The
interval after the first counts in the curvature, through $\Delta_2$, and one more in the torsion, although the first interval
alone carries the segment: its points are shared with the next ones.

:::{claim} clamped_end_is_the_first_point
:title: Point, tangent, curvature and torsion at a clamped end
:zh: 端点的位置、切向、曲率与挠率
:given: $t_2=\dots=t_k<t_{k+1}<t_{k+2}<\dots$, values variables; weights, points; $a=r_2-r_1$, $b=r_3-r_2$, $c=r_4-r_3$,
  $\Delta_i=t_{k+i}-t_k$; $a\ne0$ for the curvature, $a\times b\ne0$ for the torsion
:then: $r(t_k)=r_1$, $r'(t_k)=\frac{k-1}{\Delta_1}\frac{w_2}{w_1}a$, in the plane
  $\kappa^2(t_k)=\bigl(\frac{k-2}{k-1}\frac{\Delta_1}{\Delta_2}\frac{w_1w_3}{w_2^2}\bigr)^2\frac{(a\times b)^2}{|a|^6}$, and in
  space $\tau(t_k)=\frac{k-3}{k-1}\frac{\Delta_1}{\Delta_3}\frac{w_1w_4}{w_2w_3}\frac{(a,b,c)}{|a\times b|^2}$
:method: The kernels at $t=t_k$; for $k=3$ without the torsion.
:degrees: 2..6 sampled 7
:scope: a start of multiplicity k-1, simple knots behind it
:where: the gaps of the knots are positive; no weight is 0
:over: x: -
:control: $\Delta_1/\Delta_2$ left out
:::
*/
CLAIM(clamped_end_is_the_first_point)
{
    int p = T->degree;
    num u[MOST_KNOTS], R[2 * MOST_KNOTS], S[3 * MOST_KNOTS], w[MOST_KNOTS], D[4];
    u[0] = unknown(T, "x", 0);
    for (int i = 1; i <= 2 * p + 1; i++)
        u[i] = 1 < i && i <= p ? u[1] : add(u[i - 1], positive(T, "h", i));
    G(weighted_points)(T, p + 1, 2, R, w);
    num one = u[p], length1 = sub(u[p + 1], one), length2 = sub(u[p + 2], one), a[3], b[3], c[3];
    G(nurbs_derivatives)(G(nurbs_on_span)(p, 2, u, p, R, w), one, 1, D);
    num speed = mul(div(from_int(p), length1), div(w[1], w[0])); /* (k-1)/Δ_1 w_2/w_1 */
    for (int k = 0; k < 2; k++) {
        a[k] = sub(R[2 + k], R[k]);
        b[k] = sub(R[4 + k], R[2 + k]);
        about(T, "the point");
        same(T, D[k], R[k]);
        about(T, "the derivative");
        same(T, D[2 + k], mul(speed, a[k]));
    }
    /* (k-2)/(k-1) Δ_1/Δ_2 w_1 w_3/w_2², times a x b, squared, over |a|⁶ */
    num factor = mul(from_ratio(p - 1, p), div(mul(w[0], w[2]), mul(w[1], w[1]))), area = G(cross2)(a, b);
    factor = fault(T, mul(factor, div(length1, length2)), factor);
    num square = G(norm_squared)(2, a), part = mul(factor, area);
    about(T, "the square of the curvature");
    same(T, G(nurbs_curvature_squared)(G(nurbs_on_span)(p, 2, u, p, R, w), one),
         div(mul(part, part), mul(square, mul(square, square))));
    if (p < 3)
        return;
    G(weighted_points)(T, p + 1, 3, S, w);
    for (int k = 0; k < 3; k++) {
        a[k] = sub(S[3 + k], S[k]);
        b[k] = sub(S[6 + k], S[3 + k]);
        c[k] = sub(S[9 + k], S[6 + k]);
    }
    /* (k-3)/(k-1) Δ_1/Δ_3 w_1 w_4/(w_2 w_3), times (a, b, c)/|a x b|² */
    factor = mul(mul(from_ratio(p - 2, p), div(length1, sub(u[p + 3], one))), div(mul(w[0], w[3]), mul(w[1], w[2])));
    about(T, "the torsion");
    same(T, G(nurbs_torsion)(G(nurbs_on_span)(p, 3, u, p, S, w), one),
         mul(factor, div(G(det3)(a, b, c), G(gram)(3, a, b))));
}

/*
The point itself asks for less: whatever knots stand between, and at either end.

:::{claim} end_points_of_clamped_knots
:title: Over (k-1)-fold ends the curve begins and ends with the polygon
:zh: 两端 k-1 重节点时曲线首末点即首末顶点
:given: $t_2=t_k<t_{k+1}$ and $t_n<t_{n+1}=t_{n+k-1}$, with $t_1$ and $t_{n+k}$ equal to these knots or not, and an inner knot of every multiplicity $0,\dots,k$,
  values variables; weights and points
:harmless: $t_2=t_k<t_{k+1}$ and $t_n<t_{n+1}=t_{n+k-1}$ | the scope tells the multiplicities of the ends
:then: $r(t_k)=r_1$, and $r(t_{n+1})=r_n$ as a limit from the left
:method: All terms of the definition.
:degrees: 1..6 sampled 6
:scope: an inner knot of every multiplicity up to k between (k-1)-fold or k-fold ends; the distinct knots variables up to order 5, numbers above
:where: $w_1$ and $w_n$ are not 0
:control: the second point from either end
:::
*/
CLAIM(end_points_of_clamped_knots)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num R[MOST_KNOTS], w[MOST_KNOTS], P;
    for (int m = 0; m < 2 * (p + 2); m++) {
        char pattern[MOST_KNOTS];
        int whole_end = m % 2, inner = m / 2, at = 0;
        if (!whole_end)
            pattern[at++] = '1';
        pattern[at++] = (char)('0' + p + whole_end);
        if (inner > 0)
            pattern[at++] = (char)('0' + inner);
        pattern[at++] = (char)('0' + p + whole_end);
        if (!whole_end)
            pattern[at++] = '1';
        pattern[at] = '\0';
        (void)G(knots_good)(T, p, pattern, &K);
        G(weighted_points)(T, K.n, 1, R, w);
        about(T, "the beginning");
        G(nurbs_by_definition)(K.n, p, 1, K.u, K.place, R, w, K.place[p], K.u[p], &P);
        same(T, P, R[fault(T, 0, 1)]);
        about(T, "the end");
        G(nurbs_by_definition)(K.n, p, 1, K.u, K.place, R, w, K.place[K.n - 1], K.u[K.n], &P);
        same(T, P, R[fault(T, K.n - 1, K.n - 2)]);
    }
}

/*
## Closed curves (周期节点)

:::{claim} periodic_data_close_the_curve
:title: Periodic points, weights and knots close the curve as smoothly as it is elsewhere
:zh: 周期数据给出封闭光滑曲线
:given: $m$ points and $m+1$ knots of one period, $m=k$ or $k+1$, all simple, continued periodically; values variables
:then: at the two ends of the domain the derivatives of orders $0,\dots,k-2$ of numerator and denominator agree, hence those of the
  curve
:method: The kernel `bspline_periodic` for the continuation, the derivatives by the kernel on the first and on the last span;
  homogeneous coordinates, one coordinate.
:degrees: 1..6 sampled 7
:scope: periods of k or k+1 simple knots; the distinct knots variables up to order 5, numbers above
:control: the order $k-1$ as well
:::
*/
CLAIM(periodic_data_close_the_curve)
{
    int p = T->degree;
    for (int m = p + 1; m <= p + 2; m++) {
        num u[MOST_KNOTS], c[MOST_KNOTS], v[MOST_KNOTS], d[MOST_KNOTS], first[MAX_DEGREE], last[MAX_DEGREE];
        G(distinct_knots)(T, m + 1, 4, u);
        for (int i = 0; i < m; i++)
            c[i] = unknown(T, "H", i);
        G(bspline_periodic)(m, p, 1, u, c, v, d);
        int orders = fault(T, p, p + 1);
        G(bspline_derivatives)(G(on_span)(p, 1, v, p, d), v[p], orders - 1, first);
        G(bspline_derivatives)(G(on_span)(p, 1, v, p + m - 1, d), v[p + m], orders - 1, last);
        for (int r = 0; r < orders; r++)
            same(T, first[r], last[r]);
    }
}
#include "chapters/judge/claims_off.h"
