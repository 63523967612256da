/*
# Convexity of NURBS curves (保凸性)

The source inserts knots until the polygon is the curve.  An insertion puts one new vertex on each edge and takes the old
ones away: it cuts corners.  A convex polygon with its corners cut is convex, and so is a limit of convex polygons.

All depends on the word.  By the letter of the definition a *set* of points is convex when it is part of the boundary of a
convex set, and it does not matter how often the polygon runs there.  With that meaning lemma and theorem are false: the
polygon $(0,0),(1,0),(0,0),(0,1)$ is two sides of a triangle as a set, but as a control polygon it goes there and back, and
both the polygon with its corners cut and the curve leave the boundary.  They are true for polygons that run through the
boundary *once*; then the polygon, closed by its chord, is convex.

With that meaning there is a proof without limits.  Let $D_{ijl}$ be twice the signed area of the triangle $r_ir_jr_l$ and
let $M$ be the matrix of an insertion, which makes the new homogeneous points out of the old: row $i$ has $1-\alpha_i$ in
column $i-1$ and $\alpha_i$ in column $i$.  By Cauchy and Binet

$$w'_aw'_bw'_c\,D'_{abc}=\sum_{i<j<l}M\begin{pmatrix}a&b&c\\i&j&l\end{pmatrix}w_iw_jw_l\,D_{ijl},$$

and no minor of $M$ is negative.  A polygon is convex when all $D_{ijl}$ have one sign; so the new one is.  If three
parameters are inserted until the points of the curve there are vertices, the same holds for any three points of the curve.
*/
#include "chapters/nurbs/corner-cutting.h"
#include "chapters/nurbs/definition.h"

#include <stdio.h>

#if RATIONAL
#include "exact/record/hull.h"
#include "exact/record/polynomial.h"
#include "exact/record/sign.h"
#endif

#include "chapters/judge/claims_on.h"

enum { MOST_POINTS = 40, MOST_COORDINATES = 3 * (MOST_POINTS + 1) };

/*
:::{statement} wang-ch4:def-4.2.1
:title: When a plane curve is convex
:zh: 凸曲线的定义
:definition: yes
:printed: a continuous plane curve $\Gamma$ is called convex if it is the boundary of a convex set of the plane, or part of it
:checked-by: convex_polygons_lie_on_the_border_of_their_hull
:reading: polygon_that_turns_back_loses_convexity | by the letter, the set of points of $\Gamma$ is part of the boundary
:reading: polygon_that_overlaps_itself_loses_convexity | the same, and $\Gamma$ never turns back
:reading: turns_of_one_sign_are_not_enough | $\Gamma$ turns always to the same side, which the definition does not say but which
  is often meant
:reading: triangles_of_one_sign_make_a_polygon_convex | $\Gamma$ runs through the boundary or part of it once, coming to no
  point twice except the end to the start
:figure: what_convex_must_mean

The statements of the section are true with the last reading and false with the others.  A straight curve is convex: it is
part of the boundary of a half plane.
:::
*/

#if RATIONAL
/* All polygons of n points of a grid of `width` times `height` points, or of as many as there are. */
static int grid_width(int n) { return n <= 5 ? 3 : 2; }
static int grid_height(int n) { return n <= 4 ? 3 : 2; }
static int grid_polygons(int n)
{
    int codes = 1;
    for (int i = 0; i < n; i++)
        codes *= grid_width(n) * grid_height(n);
    return codes;
}
static void grid_polygon(int n, int code, long point[])
{
    int width = grid_width(n), places = width * grid_height(n);
    for (int i = 0; i < n; i++, code /= places) {
        point[2 * i] = code % places % width;
        point[2 * i + 1] = code % places / width;
    }
}
static void points_of(int n, const long point[], num_q R[])
{
    for (int i = 0; i < 2 * n; i++)
        R[i] = from_int_q(point[i]);
}

/*
:::{claim} triangles_of_one_sign_make_a_polygon_convex
:title: A polygon closed by its chord is convex exactly when its triangles have one sign
:zh: 凸多边形等价于各三角形同向
:kind: decision
:given: all polygons of $n$ points: of the grid $\{0,1,2\}^2$ for $n=3,4$, of $\{0,1,2\}\times\{0,1\}$ for $n=5$, of $\{0,1\}^2$
  for $n=6$
:then: the polygon is convex when closed by its chord if and only if all $D_{ijl}$, $i<j<l$, are $\ge0$ or all $\le0$, and not all are $0$
:method: Convexity by `exact/decide/hull.h`, from the turns of the edges; the areas are computed.  For all polygons: let the $D_{ijl}$ be
  $\ge0$, one of them positive.  Then no point is on the right of an edge $r_ir_{i+1}$ or of the chord $r_nr_1$, so that
  all edges are on the boundary of the hull, in its direction; and a polygon that comes round a second time has three points
  in clockwise order.  Conversely three points in order of the boundary turn left or are on one line.
:degrees: 3..6
:scope: the stated polygons; all others by the argument given
:control: only the areas of three neighbouring points are asked for, which leaves out some for $n>3$
:::
*/
static long triangle_area(const long P[], const long Q[], const long R[])
{
    return (Q[0] - P[0]) * (R[1] - P[1]) - (Q[1] - P[1]) * (R[0] - P[0]);
}

CLAIM(triangles_of_one_sign_make_a_polygon_convex)
{
    int n = T->degree;
    for (int code = 0; code < grid_polygons(n); code++) {
        long point[2 * 6];
        num R[2 * 6];
        int signs = 0;
        region_mark mark = region_open();
        grid_polygon(n, code, point);
        points_of(n, point, R);
        for (int l = 2; l < n; l++)
            for (int j = 1; j < l; j++)
                for (int i = 0; i < j; i++) {
                    long area = triangle_area(point + 2 * i, point + 2 * j, point + 2 * l);
                    if (fault(T, 1, l == j + 1 && j == i + 1))
                        signs |= area > 0 ? 1 : area < 0 ? 2 : 0;
                }
        int orientation, wanted = signs == 1 ? 1 : signs == 2 ? -1 : 0;
        (void)polygon_is_convex(n - 1, R, 1, &orientation);
        agree(T, orientation == wanted);
        region_drop(mark);
    }
}

/* No two points are on different sides of the line of an edge; R: points 0, ..., n-1. */
static int every_edge_on_the_border(int n, const num_q R[])
{
    int good = 1;
    for (int i = 0; i + 1 < n; i++) {
        int sides = 0;
        for (int j = 0; j < n; j++) {
            int side = turn_2d(R + 2 * i, R + 2 * i + 2, R + 2 * j);
            sides |= side > 0 ? 1 : side < 0 ? 2 : 0;
        }
        good &= sides != 3;
    }
    return good;
}

/*
:::{claim} convex_polygons_lie_on_the_border_of_their_hull
:title: A convex polygon is part of the boundary of its hull
:zh: 凸多边形位于其凸包边界上
:kind: decision
:given: the polygons of `triangles_of_one_sign_make_a_polygon_convex`
:then: if a polygon runs through once and is convex, then each of its edges has all vertices on one side: it is part of the boundary
  of the hull
:method: An edge is part of the boundary of the hull exactly when no two vertices are on different sides of its line.  Convexity by
  `exact/decide/hull.h`.
:degrees: 3..6
:scope: the stated polygons
:control: the converse: every polygon on the boundary of its hull runs through once
:::
*/
CLAIM(convex_polygons_lie_on_the_border_of_their_hull)
{
    int n = T->degree;
    for (int code = 0; code < grid_polygons(n); code++) {
        long point[2 * 6];
        num R[2 * 6];
        region_mark mark = region_open();
        grid_polygon(n, code, point);
        points_of(n, point, R);
        int convex = polygon_is_convex(n - 1, R, 0, NULL), border = every_edge_on_the_border(n, R);
        agree(T, fault(T, !convex || border, !border || convex));
        region_drop(mark);
    }
}

/* mu with t_mu < tau <= t_{mu+1}, and 0 if tau <= t_1. */
static int place_of(int count, const num_q t[], num_q tau)
{
    int mu = 0;
    while (mu < count && compare_q(t[mu + 1], tau) < 0)
        mu++;
    return mu;
}

/* The span, counted from 0, of a parameter of the domain t_k, ..., t_{n+1}. */
static int span_of(int n, int k, const num_q t[], num_q x)
{
    int j = k;
    while (j < n && (compare_q(t[j + 1], x) <= 0 || compare_q(t[j], t[j + 1]) == 0))
        j++;
    return j - 1;
}

/* The knots T, points r and weights w of the block, numbered from 1. */
static void given_curve(trial *T, int n, int k, num_q t[], num_q r[], num_q w[])
{
    given_points_q(T, "T", n + k, 1, t + 1);
    given_points_q(T, "r", n, 2, r + 2);
    given_points_q(T, "w", n, 1, w + 1);
}

/* Refutes for the given curve of order three with n points: part of the boundary of a convex set before the insertion of the given tau
 * is part of the boundary of one after it. */
static void lose_convexity(trial *T, int n)
{
    enum { MOST = 5 };
    num_q t[MOST + 5], r[2 * MOST + 4], w[MOST + 2], v[MOST + 5], S[2 * MOST + 4], z[MOST + 2];
    given_curve(T, n, 3, t, r, w);
    num_q tau = given_q(T, "τ");
    printed_insertion_q(n, 3, 2, t, place_of(n + 3, t, tau), tau, r, w, v, S, z);
    found_points_q(T, "r'", n + 1, 2, S + 2);
    about(T, "if every edge of the polygon is on the boundary of its hull, so is every edge of the new one");
    refute(T, every_edge_on_the_border(n, r + 2) && !every_edge_on_the_border(n + 1, S + 2));
}

/*
:::{claim} polygon_that_turns_back_loses_convexity
:title: A polygon on the boundary of a triangle that turns back, and its corners cut
:zh: 往返的多边形割角后非凸
:kind: counterexample
:given: a quadratic curve of the points $r$ and weights $w$ over the knots $T$; one knot inserted, $T'=\{\tau\}$
:data: T = 0 0 0 1 2 2 2; r = (0,0) (1,0) (0,0) (0,1); w = 1 1 1 1; τ = 3/2
:instead: r = (0,0) (1,0) (1,1) (0,1)
:then: the points of the polygon are two sides of a triangle, so part of the boundary of a convex set; the new polygon $r'$ has an edge inside
  its hull
:result: r' = (0,0) (1,0) (1/4,0) (0,1/2) (0,1)
:method: By the printed formulas; an edge is on the boundary of the hull when no two vertices are on different sides of it.  For order two
  an insertion changes no set of points, and a polygon of three points never loses convexity by the letter.
:control: the points of a square
:::
*/
CLAIM(polygon_that_turns_back_loses_convexity) { lose_convexity(T, 4); }

/*
:::{claim} polygon_that_overlaps_itself_loses_convexity
:title: A polygon that runs round a triangle and over its first side again
:zh: 首尾重叠的多边形割角后非凸
:kind: counterexample
:given: a quadratic curve of the points $r$ and weights $w$ over the knots $T$; the points go round a triangle, always turning
  left, and then over its first side again; one knot inserted, $T'=\{\tau\}$
:data: T = 0 0 0 1 2 3 3 3; r = (0,0) (2,0) (0,2) (0,0) (2,0); w = 1 1 1 1 1; τ = 1/2
:instead: r = (0,0) (2,0) (0,2) (0,1) (0,0)
:then: the points of the polygon are the sides of the triangle; the new polygon $r'$ has an edge inside its hull
:result: r' = (0,0) (1,0) (3/2,1/2) (0,2) (0,0) (2,0)
:method: As before.  With four points the three edges are different sides, if the polygon never turns back, and none runs over another.
:control: the last two points on the third side: the polygon is closed and runs round once
:::
*/
CLAIM(polygon_that_overlaps_itself_loses_convexity) { lose_convexity(T, 5); }

/*
:::{statement} wang-ch4:def-4.2.1-smallest
:title: The smallest closed convex set with the curve on its boundary
:zh: 以 Γ 为边界的最小凸闭集
:definition: yes
:printed: $A(\Gamma)$ is the smallest closed convex set that has $\Gamma$ as its boundary or as part of its boundary
:checked-by: convex_polygons_lie_on_the_border_of_their_hull
:reading: curve_inside_its_hull_has_no_smallest_set | $\Gamma$ need not be convex: then there is no such set, and $A(\Gamma)$ is
  not defined
:reading: convex_polygons_lie_on_the_border_of_their_hull | $\Gamma$ is convex: then there is one, the convex hull of $\Gamma$
:figure: where_hypotheses_are_needed

Let $\Gamma$ be compact and part of the boundary of a convex set $C$.  Every closed convex set that contains $\Gamma$ contains its
hull; the hull is closed; and a point of $\Gamma$ inside the hull would be inside $C$.  So the hull is the smallest such set,
and the only one.
:::

:::{claim} curve_inside_its_hull_has_no_smallest_set
:title: A polygon that is not convex has no convex set with it on the boundary
:zh: 非凸时 A(Γ) 不存在
:kind: counterexample
:given: a polygon of four points $r$
:data: r = (0,0) (3,0) (1,1) (0,3)
:instead: r = (0,0) (3,0) (2,2) (0,3)
:then: $r_3$ is strictly inside the triangle of the others, so inside every convex set that contains the polygon
:result: areas on the inside, twice = 3 3 3
:method: Three turns: the areas of the triangles of $r_3$ and the sides.
:control: $r_3$ on the other side of the line of its neighbours
:::
*/
CLAIM(curve_inside_its_hull_has_no_smallest_set)
{
    num P[8], area[3];
    given_points(T, "r", 4, 2, P);
    const num *corner[3] = {P, P + 2, P + 6}, *third = P + 4;
    int inside_all = 1;
    for (int i = 0; i < 3; i++) {
        const num *from = corner[i], *to = corner[(i + 1) % 3];
        num along[2] = {sub(to[0], from[0]), sub(to[1], from[1])};
        num there[2] = {sub(third[0], from[0]), sub(third[1], from[1])};
        area[i] = G(cross2)(along, there);
        inside_all &= turn_2d(from, to, third) > 0;
    }
    found_points(T, "areas on the inside, twice", 3, 1, area);
    about(T, "the third point is not inside the triangle of the others");
    refute(T, inside_all);
}
#endif

/*
:::{statement} wang-ch4:lemma-4.2.1
:title: A convex polygon stays convex when knots are inserted
:zh: 嵌节点保持控制多边形的凸性
:printed: if the control polygon $\Gamma_k^{(T)}(\Phi)$ of a plane NURBS curve is a convex curve, then $\Gamma_k^{(T)}(T')$ is a
  convex curve for every finite set $T'$ of knots
:holds-by: insertion_turns_like_its_triangles triangles_of_one_sign_make_a_polygon_convex
  insertion_ratios_are_between_zero_and_one printed_insertion_keeps_the_curve knots_outside_the_domain_cut_corners
:hypothesis: polygon_that_turns_back_loses_convexity | the polygon runs through part of the boundary of a convex set once; that it
  is there as a set is not enough
:hypothesis: knot_at_a_k_fold_end_has_no_shares | the points (4.1.6) exist: $T'$ in $(t_1,t_{n+k})$, or at $t_1$ when $t_1=t_k$
:reading: knots_outside_the_domain_cut_corners | $\Gamma_k^{(T)}(T')$ is made of (4.1.6), with intervals closed on the left: knots
  outside the domain are allowed
:reading: knot_before_the_domain_asks_for_another_point | it is made with the factors of the proof and for knots before the domain with the
  edge $r_0r_1$: then the knots have to be in the domain, $t_k\le\tau\le t_{n+1}$
:reading: insertion_at_a_clamped_start_asks_for_another_point | the same with intervals closed on the right, and $\tau=t_1$ excluded as well; when $t_k$ is a
  $k$-fold knot it is not inserted again
:needs: mixed_weights_cut_beside_the_edges | positive weights
:figure: cutting_corners

Every multiplicity is allowed, $k-1$, $k$ and more: a vertex is then repeated.  A knot outside the domain makes the weight of an end
smaller and cuts corners like the others: the first row of $M$ is $\alpha_1,0,\dots$, or the last $\dots,0,1-\alpha_{n+1}$.
$T'$ is a multiset.  The minors of an
insertion involve three rows and so six columns at most, so that their signs are decided for every $n$.
:::
*/

/* The knots of a pattern, numbered from 1: t, and place with four times the number of the distinct knot, so that new
 * knots inside interval j have the places 4j+1, 4j+2, 4j+3. */
struct G(knots) {
    int count, place[MOST_KNOTS];
    num t[MOST_KNOTS];
};
static struct G(knots) G(pattern)(trial *T, const char *pattern)
{
    struct G(knots) K;
    K.count = G(knots_of_pattern)(T, pattern, K.t + 1, K.place + 1);
    for (int i = 1; i <= K.count; i++)
        K.place[i] *= 4;
    return K;
}

/* mu with t_mu < tau <= t_{mu+1}, and 0 if tau <= t_1. */
static int G(left_of)(const struct G(knots) * K, int place)
{
    int mu = 0;
    while (mu < K->count && K->place[mu + 1] < place)
        mu++;
    return mu;
}

/* The knot at a place that has one; else a number of the interval, every name another number.  What is proved about two
 * numbers of one interval is an identity, so that their order does not matter to it. */
static num G(number_at)(trial *T, const struct G(knots) * K, int place, const char *name)
{
    for (int i = 1; i <= K->count; i++)
        if (K->place[i] == place)
            return K->t[i];
#if FIELD
    return parameter(T, name);
#else
    int mu = G(left_of)(K, place);
    num share = inside(T, name);
    return add(K->t[mu], mul(share, sub(K->t[mu + 1], K->t[mu])));
#endif
}

/* The printed insertion of the number at a place, with that place. */
static void G(insert_at)(int n, int k, int dim, const struct G(knots) * K, int place, num tau, const num r[],
                         const num w[], struct G(knots) * V, num S[], num z[])
{
    int mu = G(left_of)(K, place);
    V->count = K->count + 1;
    for (int i = 1; i <= V->count; i++)
        V->place[i] = i <= mu ? K->place[i] : i == mu + 1 ? place : K->place[i - 1];
    G(printed_insertion)(n, k, dim, K->t, mu, tau, r, w, V->t, S, z);
}

static void G(equal_weights)(int n, num w[])
{
    for (int i = 1; i <= n; i++)
        w[i] = from_int(1);
}

/*
:::{claim} printed_insertion_keeps_the_curve
:title: The printed points, weights and knots give the same curve
:zh: 所印嵌入公式不改变曲线
:given: orders $k=1,\dots,6$ (sampled to $7$): all knots simple; both ends of multiplicity $k$ and one knot between, of any
  multiplicity $1,\dots,k$; $\tau$ inside any interval of the domain, or the knot at its right end
:let: $c_i$ any numbers, weights equal
:then: $\sum_iN_{i,k}(t)c_i=\sum_iN'_{i,k}(t)c'_i$ on every interval of the domain, $c'_i=(1-\alpha_i)c_{i-1}+\alpha_ic_i$ with the
  printed $\alpha_i$
:method: Both sums by the recursion of de Boor and Cox as it is defined; $\tau$, $t$, $c_i$ and the distinct knots are
  variables.  The coordinates $w_ix_i$, $w_iy_i$, $w_i$ of the homogeneous points are such $c_i$, so that with
  `inserted_points_divide_the_edges` it holds for any weights.
:degrees: 1..6 sampled 7
:scope: n stands for the order k; the distinct knots variables for k up to 5, numbers above
:control: $\alpha_i$ taken with $t_{i+k}$ for $t_{i+k-1}$
:::
*/
static void G(compare_curves)(trial *T, int k, const struct G(knots) * K, int place)
{
    int n = K->count - k;
    struct G(knots) V;
    num c[MOST_POINTS], w[MOST_POINTS], d[MOST_POINTS], z[MOST_POINTS], x = parameter(T, "p");
    num tau = G(number_at)(T, K, place, "tau");
    for (int i = 1; i <= n; i++)
        c[i] = unknown(T, "c", i);
    G(equal_weights)(n, w);
    G(insert_at)(n, k, 1, K, place, tau, c, w, &V, d, z);
    if (T->faulty) {
        int mu = G(left_of)(K, place), i = mu > 1 ? mu : 2;
        num alpha = div(sub(tau, K->t[i]), sub(K->t[i + k < K->count ? i + k : K->count], K->t[i]));
        d[i] = add(mul(sub(from_int(1), alpha), c[i - 1]), mul(alpha, c[i]));
    }
    for (int interval = K->place[k]; interval < K->place[n + 1]; interval++) {
        int begins = interval % 4 == 0 || (interval == place && place % 4 != 0); /* with a knot, old or new */
        if (begins)
            same(T, G(spline_value)(n + 1, k - 1, 1, V.t + 1, V.place + 1, d + 1, 0, interval, x),
                 G(spline_value)(n, k - 1, 1, K->t + 1, K->place + 1, c + 1, 0, interval, x));
    }
}

CLAIM(printed_insertion_keeps_the_curve)
{
    int k = T->degree;
    char pattern[MOST_KNOTS];
    for (int m = 0; m <= k; m++) {
        if (m == 0) {
            for (int i = 0; i < 2 * k + 1; i++)
                pattern[i] = '1';
            pattern[2 * k + 1] = '\0';
        } else {
            snprintf(pattern, sizeof pattern, "%d%d%d", k, m, k);
        }
        struct G(knots) K = G(pattern)(T, pattern);
        for (int i = 1; FIELD && k > 5 && i <= K.count; i++) /* 0, 1, 3, 6, 10, ...; places are multiples of 4 */
            K.t[i] = from_int(K.place[i] / 4 * (K.place[i] / 4 + 1) / 2);
        for (int place = K.place[k]; place <= K.place[K.count - k + 1]; place += 2) /* knots, and numbers between */
            if (place > K.place[1])
                G(compare_curves)(T, k, &K, place);
    }
}

/*
:::{claim} insertion_ratios_are_between_zero_and_one
:title: The printed factors are between 0 and 1
:zh: 0≤α_i≤1
:given: order $k$; $\tau-t_\mu>0$, $t_{\mu+1}-\tau>0$ or $=0$, all other differences of neighbours among
  $t_{\mu-k+2},\dots,t_{\mu+k-1}$ positive
:then: $0\le\alpha_i\le1$ for $\mu-k+2\le i\le\mu$; for $\tau=t_{\mu+1}$ the first of them is $1$
:method: Numerators and denominators of $\alpha_i$ and $1-\alpha_i$ are sums of these differences, so that it remains true when some
  of them are $0$, knots being multiple; no denominator vanishes, as each contains $\tau-t_\mu$.
:degrees: 2..8
:scope: n stands for the order k
:control: $i=\mu+1$ taken with the formula of the middle case
:::
*/
CLAIM(insertion_ratios_are_between_zero_and_one)
{
    enum { SIZE = 32 };
    int k = T->degree, mu = k;
    for (int at_knot = 0; at_knot <= 1; at_knot++) {
        num t[SIZE], tau = from_int(0);
        t[2] = from_int(0);
        for (int i = 3; i <= mu; i++)
            t[i] = add(t[i - 1], positive(T, "h", i));
        tau = add(t[mu], positive(T, "h", 0));
        t[mu + 1] = at_knot ? tau : add(tau, positive(T, "h", mu + 1));
        for (int i = mu + 2; i < fault(T, mu + k, mu + k + 1); i++)
            t[i] = add(t[i - 1], positive(T, "h", i));
        for (int i = mu - k + 2; i <= fault(T, mu, mu + 1); i++) {
            int middle = i == mu + 1 ? mu + 1 : mu; /* the control takes the middle case one too far */
            num alpha = G(printed_alpha)(k, middle, t, tau, i);
            nonnegative(T, alpha);
            nonnegative(T, sub(from_int(1), alpha));
        }
        if (at_knot)
            same(T, G(printed_alpha)(k, mu, t, tau, mu - k + 2), from_int(1));
    }
}

/*
:::{claim} insertion_turns_like_its_triangles
:title: An insertion keeps the turn of every triangle
:zh: 嵌节点保持三角形转向
:given: $n$ points of the plane with weights, all $\alpha_i=\frac{a_i}{1+a_i}$ with $a_i>0$
:then: the determinants of three new homogeneous points are sums of those of three old ones with the $3\times3$ minors of the matrix of
  the insertion; no minor is negative
:method: The equation, that of Cauchy and Binet, with all homogeneous coordinates variables for $n\le4$; the minors by their coefficients.  Minors are polynomials in the
  $\alpha_i$, so that $\alpha_i=0$ and $1$ are included as limits.  Three rows have entries in six columns at most, and which of
  these coincide is decided by whether neighbouring rows follow one another; with $n\ge5$ all cases occur.
:degrees: 3..6
:scope: signs for every n, by the last remark
:control: two neighbouring rows exchanged in the minors
:::
*/
/* The determinant of the columns a, b, c of three rows of a matrix with `width` columns. */
static num G(minor)(int width, const num M[], int i, int j, int l, int a, int b, int c)
{
    const num *x = M + i * width, *y = M + j * width, *z = M + l * width;
    num P[3] = {x[a], x[b], x[c]}, Q[3] = {y[a], y[b], y[c]}, R[3] = {z[a], z[b], z[c]};
    return G(det3)(P, Q, R);
}

CLAIM(insertion_turns_like_its_triangles)
{
    enum { SIZE = 7 };
    int n = T->degree;
    num M[SIZE * SIZE], H[3 * SIZE], N[3 * SIZE], one = from_int(1);
    for (int i = 0; i <= n; i++) {
        num a = i > 0 && i < n ? positive(T, "a", i) : one, alpha = i == 0 ? one : div(a, add(one, a));
        alpha = i == n ? from_int(0) : alpha;
        for (int j = 0; j < n; j++)
            M[i * n + j] = j == i - 1 ? sub(one, alpha) : j == i ? alpha : from_int(0);
    }
    for (int m = 0; m < 3 * n; m++)
        H[m] = unknown(T, "x", m);
    for (int i = 0; i <= n; i++)
        for (int c = 0; c < 3; c++) {
            N[3 * i + c] = from_int(0);
            for (int j = 0; j < n; j++)
                N[3 * i + c] = add(N[3 * i + c], mul(M[i * n + j], H[3 * j + c]));
        }
    for (int l = 2; l <= n; l++)
        for (int j = 1; j < l; j++)
            for (int i = 0; i < j; i++) {
                num sum = from_int(0);
                for (int c = 2; c < n; c++)
                    for (int b = 1; b < c; b++)
                        for (int a = 0; a < b; a++) {
                            num minor = G(minor)(n, M, fault(T, i, j), fault(T, j, i), l, a, b, c);
                            nonnegative(T, minor);
                            if (n <= 4)
                                sum = add(sum, mul(minor, G(det3)(H + 3 * a, H + 3 * b, H + 3 * c)));
                        }
                if (n <= 4)
                    same(T, sum, G(det3)(N + 3 * i, N + 3 * j, N + 3 * l));
            }
}

#if RATIONAL
/*
:::{claim} knot_before_the_domain_asks_for_another_point
:title: Knots outside the domain ask for points that are not there
:zh: 定义域外的节点
:kind: counterexample
:given: the simple knots $T$ of one quadratic segment, with the domain $[t_k,t_{n+1}]$, and $\tau<t_k$
:data: T = 1 2 3 4 5 6; τ = 3/2
:instead: τ = 7/2
:then: by the printed formula $r'_1=(1-\alpha_1)r_0+\alpha_1r_1$ for equal weights, the factor of $r_0$ is not $0$, and there is no $r_0$
:result: factor of r_0 = 3/4
:method: $\alpha_1$ by the printed cases; that the factor of $r_0$ is $0$ is what is asked for.
:control: $\tau$ in the domain
:::
*/
CLAIM(knot_before_the_domain_asks_for_another_point)
{
    num t[7];
    given_points(T, "T", 6, 1, t + 1);
    num tau = given(T, "τ"), factor = sub(from_int(1), G(printed_alpha)(3, place_of(6, t, tau), t, tau, 1));
    found(T, "factor of r_0", factor);
    about(T, "the new first point does not need r_0");
    same(T, factor, from_int(0));
}

/*
:::{claim} insertion_at_a_clamped_start_asks_for_another_point
:title: At the start of a clamped curve the printed convention asks for a point before the first
:zh: 左端重节点处再嵌入
:kind: counterexample
:given: the knots $T$ of one quadratic segment, with a $k$-fold first knot, after any smaller $t_0$; $\tau=t_1=t_k$, which is in the domain
:data: T = 0 0 0 1 1 1; τ = 0
:then: $\tau\in(t_0,t_1]$, which is the interval of $\mu$, and $\alpha_1=0$: $r'_1=r_0$
:result: μ = 0; factor of r_0 = 1
:method: $\alpha_1$ by the printed cases.
:control: $\mu$ taken with $\tau\in[t_\mu,t_{\mu+1})$
:::
*/
CLAIM(insertion_at_a_clamped_start_asks_for_another_point)
{
    num t[7];
    given_points(T, "T", 6, 1, t + 1);
    num tau = given(T, "τ");
    int before = place_of(6, t, tau), up_to = before;
    while (up_to < 6 && compare_q(t[up_to + 1], tau) <= 0)
        up_to++;
    int mu = fault(T, up_to, before);
    num factor = sub(from_int(1), G(printed_alpha)(3, mu, t, tau, 1));
    found_whole(T, "μ", mu);
    found(T, "factor of r_0", factor);
    about(T, "the new first point does not need r_0");
    same(T, factor, from_int(0));
}

static int positive_on_the_interval(int n, const num_q w[])
{
    return sign_on(poly_from_bernstein(n, w), from_int_q(0), from_int_q(1), CLOSED) == SIGN_POSITIVE;
}

/*
:::{claim} mixed_weights_cut_beside_the_edges
:title: With weights of both signs the new vertices are beside the edges
:zh: 权因子变号时新顶点不在边上
:kind: counterexample
:given: a cubic segment of the points $r$, a square, over the knots $T$, with weights $w$ of both signs for which $w(t)>0$; $\tau$
:data: T = 0 0 0 0 1 1 1 1; r = (0,0) (1,0) (1,1) (0,1); w = 4 -1 4 4; τ = 1/2
:instead: w = 4 1 4 4
:then: $s_2$ is negative and $s_3$ greater than $1$, and the new polygon $r'$ is not convex
:result: s_2 = -1/3; s_3 = 4/3; r' = (0,0) (-1/3,0) (1,4/3) (1/2,1) (0,1)
:method: The printed formulas; convexity by `exact/decide/hull.h`.
:control: all weights positive
:::
*/
CLAIM(mixed_weights_cut_beside_the_edges)
{
    num t[10], r[10], w[6], v[10], S[12], z[6], s[2], weight;
    given_curve(T, 4, 4, t, r, w);
    num tau = given(T, "τ");
    int stated = positive_on_the_interval(3, w + 1) && polygon_is_convex(3, r + 2, 1, NULL);
    G(printed_insertion)(4, 4, 2, t, 4, tau, r, w, v, S, z);
    int good = polygon_is_convex(4, S + 2, 1, NULL);
    for (int i = 2; i <= 3; i++) {
        s[i - 2] = G(printed_ratio)(G(printed_alpha)(4, 4, t, tau, i), w[i - 1], w[i], &weight);
        good |= sign_q(s[i - 2]) >= 0 && compare_q(s[i - 2], from_int(1)) <= 0;
    }
    found(T, "s_2", s[0]);
    found(T, "s_3", s[1]);
    found_points(T, "r'", 5, 2, S + 2);
    about(T, "w(t) being positive and the polygon convex, a ratio is between 0 and 1 or the new polygon is convex");
    refute(T, stated && !good);
}
#endif

/*
:::{statement} wang-ch4:lemma-4.2.1-hulls
:title: The hulls decrease
:zh: 凸包递减
:printed: A(\Gamma_k^{(T)}(\Phi))\supseteq A(\Gamma_k^{(T)}(T'))
:holds-by: inserted_points_divide_the_edges insertion_ratios_are_between_zero_and_one knots_outside_the_domain_cut_corners
:needs: mixed_weights_cut_beside_the_edges | positive weights
:hypothesis: polygon_that_turns_back_loses_convexity | the polygon runs through its points once, else $A(\Gamma_k^{(T)}(T'))$ need not
  exist; or $A$ is taken as the hull
:hypothesis: knot_at_a_k_fold_end_has_no_shares | the points (4.1.6) exist, as for the lemma
:reading: knots_outside_the_domain_cut_corners | the polygon is made of (4.1.6): knots outside the domain are allowed
:reading: knot_before_the_domain_asks_for_another_point | it is made with the factors of the proof: the knots have to be in the domain
:reading: insertion_at_a_clamped_start_asks_for_another_point | the same, with $\tau=t_1$ excluded as well
:figure: hulls_of_knot_sets

Every new vertex is on an edge, hence in the hull; for hulls it is true of every polygon.
:::

:::{claim} inserted_points_divide_the_edges
:title: The new point divides the edge in the ratio of the weighted factors
:zh: 新顶点按加权比分割边
:given: $0\le\alpha\le1$, written $\alpha=\frac a{1+a}$; positive weights $w_{i-1},w_i$; points $r_{i-1},r_i$
:then: $w'=(1-\alpha)w_{i-1}+\alpha w_i$ and $r'=(1-s)r_{i-1}+sr_i$ satisfy $w'r'=(1-\alpha)w_{i-1}r_{i-1}+\alpha w_ir_i$; and
  $w'>0$, $s\ge0$, $1-s\ge0$
:method: Identities in the field, and signs of coefficients.  For $\alpha=0$ and $\alpha=1$ it is $s=\alpha$.
:control: $s$ taken as $\alpha$, without weights
:::
*/
CLAIM(inserted_points_divide_the_edges)
{
    num one = from_int(1), a = positive(T, "a", 0), alpha = div(a, add(one, a)), rest = sub(one, alpha), weight;
    num w0 = positive(T, "w", 0), w1 = positive(T, "w", 1), r0 = unknown(T, "r", 0), r1 = unknown(T, "r", 1);
    num s = G(printed_ratio)(alpha, w0, w1, &weight);
    s = fault(T, s, alpha);
    num point = add(mul(sub(one, s), r0), mul(s, r1));
    same(T, weight, add(mul(rest, w0), mul(alpha, w1)));
    same(T, mul(weight, point), add(mul(mul(rest, w0), r0), mul(mul(alpha, w1), r1)));
    nonnegative(T, weight);
    nonnegative(T, s);
    nonnegative(T, sub(one, s));
}

/*
:::{statement} wang-ch4:lemma-4.2.1-step-points
:title: The points after one insertion
:zh: 嵌入一个节点后的顶点
:printed: \boldsymbol r_{i,k}^{(T,T')}=(1-s_i)\boldsymbol r_{i-1}+s_i\boldsymbol r_i,\qquad
  s_i=\alpha_iw_i/[(1-\alpha_i)w_{i-1}+\alpha_iw_i]
:holds-by: inserted_points_divide_the_edges printed_insertion_keeps_the_curve
:needs: vanishing_weight_loses_the_new_point | positive weights
:hypothesis: knot_before_the_domain_asks_for_another_point | $\tau_1$ is in the domain: before it the edge $r_0r_1$ is asked for
:hypothesis: insertion_at_a_clamped_start_asks_for_another_point | $\tau_1>t_1$
:figure: where_hypotheses_are_needed

The same as (2.9.1) in homogeneous coordinates; the new weights are the denominators.
:::
*/

#if RATIONAL
/*
:::{claim} vanishing_weight_loses_the_new_point
:title: With weights of both signs a new point may not exist
:zh: 新权因子为零
:kind: counterexample
:given: the knots $T$ of a quadratic segment, weights $w$ of both signs for which $w(t)>0$; $\tau$
:data: T = 0 0 0 1 1 1; w = 2 -1 2; τ = 2/3
:instead: w = 2 1 2
:then: the denominator of $s_2$ vanishes
:result: denominator of s_2 = 0
:method: The denominator is computed and asked to be different from $0$.
:control: all weights positive
:::
*/
CLAIM(vanishing_weight_loses_the_new_point)
{
    num t[7], w[4];
    given_points(T, "T", 6, 1, t + 1);
    given_points(T, "w", 3, 1, w + 1);
    num alpha = G(printed_alpha)(3, 3, t, given(T, "τ"), 2);
    num weight = add(mul(sub(from_int(1), alpha), w[1]), mul(alpha, w[2]));
    found(T, "denominator of s_2", weight);
    about(T, "w(t) being positive, the denominator is not 0");
    refute(T, positive_on_the_interval(2, w + 1) && is_zero_q(weight));
}
#endif

/*
:::{statement} wang-ch4:lemma-4.2.1-step-alpha
:title: The factors of one insertion, by cases
:zh: α_i 的分段公式
:printed: \tau_1\in(t_\mu,t_{\mu+1}];\quad\alpha_i=1,\ i\le\mu-k+1;\quad\alpha_i=\frac{\tau_1-t_i}{t_{i+k-1}-t_i},\ \mu-k+2\le i\le\mu;
  \quad\alpha_i=0,\ i\ge\mu+1
:holds-by: printed_insertion_keeps_the_curve both_conventions_of_the_span_are_right
:hypothesis: insertion_at_a_clamped_start_asks_for_another_point | $\tau_1>t_1$ and $t_k\le\tau_1\le t_{n+1}$, so that neither
  $r_0$ nor $r_{n+1}$ is asked for
:reading: both_conventions_of_the_span_are_right | the formula with $\tau_1\in[t_\mu,t_{\mu+1})$ instead, as in the chapter's
  other sections
:figure: where_hypotheses_are_needed

At a knot of multiplicity $m\le k-1$ both conventions give the same numbers $\alpha_i$; for $m\ge k$ the closed end decides
which of two points is repeated.  With the end closed on the right the start of a clamped curve cannot be inserted again:
then $\mu\le0$, and $\alpha_1=0$ asks for a point $r_0$.
:::

:::{claim} both_conventions_of_the_span_are_right
:title: At a knot, both conventions of the span give the same factors, or repeat one of two points
:zh: 两种区间约定
:given: order $k$; a knot $\tau=t_{\mu+1}=\dots=t_{\mu+m}$ of multiplicity $m=1,\dots,k+1$ between knots of multiplicity $1$ each
:then: for $m\le k-1$ the factors $\alpha_i$ with $(t_\mu,t_{\mu+1}]$ are those with $[t_{\mu+m},t_{\mu+m+1})$, for all $i$; for
  $m\ge k$ the first repeats $r_\mu$, the second $r_{\mu+m-k+1}$, and the old points are all kept
:method: All $\alpha_i$ by the printed cases, with the knots variables.
:degrees: 2..6
:scope: n stands for the order k
:control: the second with $\mu+m+1$ for $\mu+m$
:::
*/
CLAIM(both_conventions_of_the_span_are_right)
{
    int k = T->degree;
    char pattern[MOST_KNOTS];
    for (int m = 1; m <= k + 1; m++) {
        for (int i = 0; i < 2 * k + 3; i++)
            pattern[i] = i == k + 1 ? (char)('0' + m) : '1';
        pattern[2 * k + 3] = '\0';
        struct G(knots) K = G(pattern)(T, pattern);
        int mu = k + 1, right = fault(T, mu + m, mu + m + 1), n = K.count - k;
        num tau = K.t[mu + 1], one = from_int(1);
        for (int i = 2; i <= n; i++) {
            num first = G(printed_alpha)(k, mu, K.t, tau, i), second = G(printed_alpha)(k, right, K.t, tau, i);
            if (m < k)
                same(T, first, second);
            else {
                same(T, first, i <= mu ? one : from_int(0));
                same(T, second, i <= mu + m - k + 1 ? one : from_int(0));
            }
        }
    }
}

/*
:::{claim} clamped_end_may_be_inserted_again
:title: At a k-fold right end the printed convention repeats the last point
:zh: 右端 k 重节点再嵌入时重复末顶点
:given: order $k$, ends of multiplicity $k$ and two simple knots between; $\tau=t_{n+1}=\dots=t_{n+k}$, which is in $(t_n,t_{n+1}]$
:then: $\alpha_i=1$ for $i\le n$ and $\alpha_{n+1}=0$: the new points are $r_1,\dots,r_n,r_n$
:method: All $\alpha_i$ by the printed cases, with the knots variables.
:degrees: 2..6
:scope: n stands for the order k
:control: $\tau=t_n$, in $(t_{n-1},t_n]$
:::
*/
CLAIM(clamped_end_may_be_inserted_again)
{
    int k = T->degree, n = k + 2, mu = fault(T, n, n - 1);
    char pattern[MOST_KNOTS];
    snprintf(pattern, sizeof pattern, "%d11%d", k, k);
    struct G(knots) K = G(pattern)(T, pattern);
    for (int i = 1; i <= n + 1; i++)
        same(T, G(printed_alpha)(k, mu, K.t, K.t[mu + 1], i), from_int(i <= n));
}

/*
:::{statement} wang-ch4:lemma-4.2.1-step-unit
:title: The ratios are between 0 and 1
:zh: s_i ∈ [0,1]
:printed: s_i\in[0,1]
:holds-by: insertion_ratios_are_between_zero_and_one inserted_points_divide_the_edges
:needs: mixed_weights_cut_beside_the_edges | positive weights
:figure: mixed_weights_and_convexity
:::

:::{statement} wang-ch4:lemma-4.2.1-step-inscribed
:title: The new polygon is inscribed in the old one
:zh: 内接折线
:printed: hence $\Gamma_k^{(T)}(T')$ is an inscribed polygon of $\Gamma_k^{(T)}(\Phi)$
:holds-by: insertion_ratios_are_between_zero_and_one inserted_points_divide_the_edges
:needs: mixed_weights_cut_beside_the_edges | positive weights
:hypothesis: knot_before_the_domain_asks_for_another_point | $\tau_1$ is in the domain: before it the edge $r_0r_1$ is asked for
:hypothesis: insertion_at_a_clamped_start_asks_for_another_point | $\tau_1>t_1$
:figure: cutting_corners

The new vertex $i$ is on the edge $r_{i-1}r_i$, one on each edge, in the order of the edges; both ends stay.
:::

:::{statement} wang-ch4:lemma-4.2.1-step-first
:title: So the lemma is true for one knot
:zh: 归纳法第一步
:printed: $\Gamma_k^{(T)}(T')$ being inscribed in the convex curve $\Gamma_k^{(T)}(\Phi)$, the lemma is true for one knot
:holds-by: insertion_turns_like_its_triangles triangles_of_one_sign_make_a_polygon_convex
  inserted_polygons_stay_convex
:hypothesis: polygon_that_turns_back_loses_convexity | the polygon runs through its points once
:hypothesis: polygon_that_overlaps_itself_loses_convexity | not turning back is not enough: its end does not run over its start
:figure: what_convex_must_mean
:::
*/

#if RATIONAL
/* Curves with convex polygons, counterclockwise. */
static const struct {
    int k, n;
    long point[2 * 7], knot[11];
} convex_curve[] = {
    {2, 4, {0, 0, 1, 0, 1, 1, 0, 1}, {0, 0, 1, 2, 3, 3}},
    {3, 4, {0, 0, 2, 0, 1, 2, 0, 0}, {0, 0, 0, 1, 2, 2, 2}},
    {3, 5, {0, 0, 3, 0, 4, 2, 2, 4, 0, 2}, {0, 1, 2, 3, 4, 5, 6, 7}},
    {3, 5, {0, 0, 3, 0, 4, 2, 2, 4, 0, 2}, {0, 0, 0, 1, 1, 3, 3, 3}},
    {4, 5, {0, 0, 4, 0, 5, 3, 2, 5, 0, 1}, {0, 1, 2, 4, 5, 6, 8, 9, 10}},
    {4, 6, {0, 0, 2, 0, 4, 0, 4, 0, 4, 3, 0, 4}, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}},
    {4, 7, {1, 0, 3, 0, 5, 1, 6, 3, 5, 5, 3, 6, 1, 5}, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2}},
};
enum { CONVEX_CURVES = sizeof convex_curve / sizeof *convex_curve, WEIGHTS = 4 };

/* Weight i, from 1: all equal, in turn, growing, small inside. */
static num_q family_weight(int family, int n, int i)
{
    long power = 1;
    for (int j = 1; j < i; j++)
        power *= 10;
    num_q weight[WEIGHTS] = {from_int_q(1), from_int_q(i % 2 == 1 ? 1000 : 1), from_int_q(power),
                             from_ratio_q(1, i == 1 || i == n ? 1 : 1000)};
    return weight[family];
}

static void designed_curve_of(int example, int family, num_q t[], num_q r[], num_q w[])
{
    int n = convex_curve[example].n, k = convex_curve[example].k;
    points_of(n, convex_curve[example].point, r + 2);
    for (int i = 1; i <= n; i++)
        w[i] = family_weight(family, n, i);
    for (int i = 1; i <= n + k; i++)
        t[i] = from_int_q(convex_curve[example].knot[i - 1]);
}

/*
:::{claim} inserted_polygons_stay_convex
:title: Designed convex polygons stay convex, and their hulls decrease
:zh: 设计算例的保凸性与凸包递减
:kind: decision
:given: seven convex polygons, among them a closed one, one with collinear and repeated vertices, one that turns by more than a half
  turn; orders $2,3,4$; simple knots, clamped ends, inner knots of multiplicity $k-1$; weights $1$, $1000$ and $1$ in turn,
  $10^i$, and $\frac1{1000}$ inside; every knot and every middle of an interval inserted $k$ times
:then: after each insertion the polygon is convex with the same orientation, and every new vertex is on its edge of the polygon before
:method: The printed formulas in rationals, $\mu$ by comparing; convexity by `exact/decide/hull.h`; on the edge: no turn, and between the ends.
:degrees: 2..4
:scope: n stands for the order k; the stated curves
:control: the second point exchanged with the third
:::
*/
/* P is on the segment QR. */
static int is_between(const num_q P[2], const num_q Q[2], const num_q R[2])
{
    num_q sum = add_q(mul_q(sub_q(P[0], Q[0]), sub_q(P[0], R[0])), mul_q(sub_q(P[1], Q[1]), sub_q(P[1], R[1])));
    return turn_2d(P, Q, R) == 0 && sign_q(sum) <= 0;
}

CLAIM(inserted_polygons_stay_convex)
{
    for (int example = 0; example < CONVEX_CURVES; example++)
        for (int family = 0; family < WEIGHTS && convex_curve[example].k == T->degree; family++) {
            region_mark mark = region_open();
            int n = convex_curve[example].n, k = convex_curve[example].k, orientation;
            num t[2][MOST_POINTS], r[2][MOST_COORDINATES], w[2][MOST_POINTS];
            designed_curve_of(example, family, t[0], r[0], w[0]);
            agree(T, polygon_is_convex(n - 1, r[0] + 2, 1, &orientation) && orientation == 1);
            long from = 2 * convex_curve[example].knot[k - 1], to = 2 * convex_curve[example].knot[n];
            int now = 0;
            for (long half = from; half <= to; half++) {
                num tau = from_ratio(half, 2);
                for (int times = 0; times < k && compare_q(t[now][1], tau) < 0 && n < MOST_POINTS - 8; times++, n++) {
                    int next = 1 - now, mu = place_of(n + k, t[now], tau);
                    G(printed_insertion)(n, k, 2, t[now], mu, tau, r[now], w[now], t[next], r[next], w[next]);
                    for (int c = 0; T->faulty && c < 2; c++) {
                        num kept = r[next][2 * 2 + c];
                        r[next][2 * 2 + c] = r[next][2 * 3 + c];
                        r[next][2 * 3 + c] = kept;
                    }
                    agree(T, polygon_is_convex(n, r[next] + 2, 1, &orientation) && orientation == 1);
                    for (int i = 2; i <= n; i++)
                        agree(T, is_between(r[next] + 2 * i, r[now] + 2 * (i - 1), r[now] + 2 * i));
                    now = next;
                }
            }
            region_drop(mark);
        }
}
#endif

/*
:::{statement} wang-ch4:lemma-4.2.1-step-induction
:title: Knots may be inserted one after the other
:zh: 归纳步
:printed: $\Gamma_k^{(T)}(T'')=\Gamma_k^{(T\oplus T')}(\{\tau_m\})$ for $T''=T'\oplus\{\tau_m\}$, and
  $\Gamma^{(T\oplus T')}(\Phi)=\Gamma_k^{(T)}(T')$
:holds-by: knots_are_inserted_in_any_order printed_insertion_keeps_the_curve
:figure: cutting_corners

With the new weights, which the notation does not show; in the second equation the index $k$ is left out.  The sum $\oplus$ keeps multiplicities.
:::

:::{claim} knots_are_inserted_in_any_order
:title: Two insertions give the same points and weights in either order, and those of the Oslo algorithm
:zh: 嵌节点次序无关
:given: orders $k=2,3,4$, ends of multiplicity $k$ and two simple knots between; two new knots, in one interval, in different
  intervals, the same knot twice, or the knots of the curve themselves
:then: the printed insertion, once for each knot, gives the same points and weights in either order; the homogeneous points are those
  of `bspline_refine`
:method: The field, all knots, weights and points variables.  For more knots by induction: every two neighbours in the order may be
  exchanged.
:degrees: 2..6 sampled 7
:scope: n stands for the order k
:control: the second knot inserted with the weights of the old polygon
:::
*/
/* Inserts at two places, one after the other. */
static void G(insert_twice)(trial *T, int n, int k, int dim, const struct G(knots) * K, const int place[2],
                            const num tau[2], const num r[], const num w[], struct G(knots) * V, num S[], num z[])
{
    struct G(knots) U;
    num P[MOST_COORDINATES], y[MOST_POINTS];
    G(insert_at)(n, k, dim, K, place[0], tau[0], r, w, &U, P, y);
    for (int i = 1; i <= n; i++)
        y[i] = fault(T, y[i], w[i]);
    G(insert_at)(n + 1, k, dim, &U, place[1], tau[1], P, y, V, S, z);
}

CLAIM(knots_are_inserted_in_any_order)
{
    static const int places[][2] = {{1, 2}, {1, 5}, {1, 9}, {4, 4}, {4, 5}, {1, 4}, {4, 8}};
    int k = T->degree, n = k + 2, p = k - 1;
    char pattern[MOST_KNOTS];
    snprintf(pattern, sizeof pattern, "%d11%d", k, k);
    struct G(knots) K = G(pattern)(T, pattern), V, U;
    num r[MOST_COORDINATES], w[MOST_POINTS], S[MOST_COORDINATES], z[MOST_POINTS], R[MOST_COORDINATES], y[MOST_POINTS];
    num H[MOST_COORDINATES], D[MOST_COORDINATES];
    for (int i = 1; i <= n; i++) {
        w[i] = positive(T, "w", i);
        r[i] = unknown(T, "r", i);
        H[2 * (i - 1)] = mul(w[i], r[i]);
        H[2 * (i - 1) + 1] = w[i];
    }
    for (size_t j = 0; j < sizeof places / sizeof *places; j++) {
        int there[2] = {places[j][0], places[j][1]}, back[2] = {there[1], there[0]}, span[MOST_POINTS];
        num tau[2] = {G(number_at)(T, &K, there[0], "tau"), G(number_at)(T, &K, there[1], "sigma")};
        num other[2] = {tau[1], tau[0]};
        G(insert_twice)(T, n, k, 1, &K, there, tau, r, w, &V, S, z);
        G(insert_twice)(T, n, k, 1, &K, back, other, r, w, &U, R, y);
        for (int i = 1; i <= n + 2; i++) {
            same(T, z[i], y[i]);
            same(T, S[i], R[i]);
        }
        for (int i = 0; i < n + 2; i++) { /* the first interval of the support of the new B-spline */
            int last = i + 1;
            while (V.place[last] == V.place[last + 1])
                last++;
            span[i] = p;
            while (K.place[span[i] + 2] <= V.place[last])
                span[i]++;
        }
        G(bspline_refine)(p, 2, K.t + 1, H, n + 2, V.t + 1, span, D);
        for (int i = 1; i <= n + 2; i++) {
            same(T, mul(z[i], S[i]), D[2 * (i - 1)]);
            same(T, z[i], D[2 * (i - 1) + 1]);
        }
    }
}

/*
:::{statement} wang-ch4:lemma-4.2.1-step-chain
:title: The chain of hulls in the induction
:zh: 凸包包含链
:printed: A(\Gamma_k^{(T)}(\Phi))\supseteq A(\Gamma_k^{(T)}(T'))\supseteq A(\Gamma_k^{(T)}(T''))
:holds-by: inserted_points_divide_the_edges insertion_ratios_are_between_zero_and_one knots_outside_the_domain_cut_corners
:hypothesis: polygon_that_turns_back_loses_convexity | as for the lemma: the polygon runs through its points once, else the
  $A$ of a refined polygon need not exist; or $A$ is taken as the hull
:needs: mixed_weights_cut_beside_the_edges | positive weights
:hypothesis: knot_at_a_k_fold_end_has_no_shares | the points (4.1.6) exist, as for the lemma
:reading: knots_outside_the_domain_cut_corners | the polygon is made of (4.1.6): knots outside the domain are allowed
:reading: knot_before_the_domain_asks_for_another_point | it is made with the factors of the proof: the knots have to be in the domain
:reading: insertion_at_a_clamped_start_asks_for_another_point | the same, with $\tau=t_1$ excluded as well
:figure: hulls_of_knot_sets
:::

:::{statement} wang-ch4:thm-4.2.1
:title: A convex polygon has a convex NURBS curve
:zh: NURBS 曲线的保凸性
:printed: if the control polygon $\Gamma_k^{(T)}(\Phi)$ is a plane convex curve, then the plane NURBS curve that belongs to it is a
  convex curve
:holds-by: insertion_turns_like_its_triangles triangles_of_one_sign_make_a_polygon_convex
  inserted_parameters_become_vertices insertion_ratios_are_between_zero_and_one
:hypothesis: curve_of_a_polygon_that_turns_back_is_not_convex | the polygon runs through part of the boundary of a convex set once
:hypothesis: knot_of_full_multiplicity_tears_the_curve | no knot inside the domain has multiplicity $k$ or more; else the curve is
  not continuous
:needs: mixed_weights_bend_both_ways | positive weights
:figure: convex_polygon_convex_spline

For three parameters insert each until its multiplicity is $k-1$: the three points of the curve are vertices, so by the
formula above they turn as the polygon does.  If all turns are $0$ the curve is on a line, and so is the polygon, as the
B-splines of the domain are linearly independent; it goes straight on, and so does the curve, since no line across is
crossed more often.
The converse is false: the curve may be convex alone (`curve_may_be_convex_alone`).  For a periodic curve the closed polygon of one period must be convex; written as
an ordinary curve it repeats $k-1$ vertices and does not run through once, but its insertions cut the corners of the closed
polygon (`periodic_curves_of_convex_polygons_are_convex`).
:::

:::{claim} inserted_parameters_become_vertices
:title: Points of the curve become vertices
:zh: 曲线上的点成为顶点
:given: orders $k=2,\dots,6$, ends of multiplicity $k$ and a knot between of multiplicity $1,\dots,k-1$; two parameters $t'_1<t'_2$, each
  inserted $k-1$ times: both in one interval, in different ones, at the inner knot, at the right end
:then: $r(t'_1)$ is the vertex number $\mu_1$ and $r(t'_2)$ the vertex number $\mu_2+k-1$, where $t'_l\in(t_{\mu_l},t_{\mu_l+1}]$
:method: The printed insertions and the curve by its definition, knots, parameters and points variables; a coordinate of the
  homogeneous points is any coordinate.  Later parameters leave the vertices of the earlier ones alone, so more than two are
  treated by repetition.  For every $k$: the vertex belongs to $k-1$ knots that are all $t'$, so it is the polar form of the curve
  at $t',\dots,t'$.
:degrees: 2..6 sampled 6
:scope: n stands for the order k
:control: the second vertex counted one too low
:::
*/
CLAIM(inserted_parameters_become_vertices)
{
    int k = T->degree;
    char pattern[MOST_KNOTS];
    for (int m = 1; m < k; m++) {
        snprintf(pattern, sizeof pattern, "%d%d%d", k, m, k);
        for (int first = 1; first <= 3; first++)
            for (int second = first; second <= 4; second++) {
                struct G(knots) K = G(pattern)(T, pattern), V;
                if (first == second && first % 2 == 0)
                    continue;
                int n = K.count - k, place[2] = {2 * first, 2 * second + (first == second)};
                num tau[2], c[MOST_POINTS], w[MOST_POINTS], d[MOST_POINTS], z[MOST_POINTS];
                struct G(knots) old = K;
                tau[0] = G(number_at)(T, &K, place[0], "tau");
                tau[1] = G(number_at)(T, &K, place[1], "sigma");
                for (int i = 1; i <= n; i++)
                    d[i] = c[i] = unknown(T, "c", i);
                int size = n;
                for (int j = 0; j < 2; j++)
                    for (int times = 1; times < k; times++, size++) {
                        num e[MOST_POINTS];
                        for (int i = 1; i <= size; i++)
                            e[i] = d[i];
                        G(equal_weights)(size, w);
                        G(insert_at)(size, k, 1, &K, place[j], tau[j], e, w, &V, d, z);
                        K = V;
                    }
                for (int j = 0; j < 2; j++) { /* the interval on the left of the parameter, or around it */
                    int mu = G(left_of)(&old, place[j]), interval = old.place[mu];
                    same(T, d[mu + j * fault(T, k - 1, k - 2)],
                         G(spline_value)(n, k - 1, 1, old.t + 1, old.place + 1, c + 1, 0, interval, tau[j]));
                }
            }
    }
}

#if RATIONAL
/*
:::{claim} curve_of_a_polygon_that_turns_back_is_not_convex
:title: The curve of a polygon that turns back is not convex
:zh: 往返多边形的曲线非凸
:kind: counterexample
:given: a quadratic curve of the points $r$ and weights $w$ over the knots $T$, three parameters $t$ and one more, $\tau$
:data: T = 0 0 0 1 2 2 2; r = (0,0) (1,0) (0,0) (0,1); w = 1 1 1 1; t = 0 2/3 2; τ = 3/2
:instead: r = (0,0) (1,0) (1,1) (0,1)
:then: $r(\tau)$ is strictly inside the triangle of the three points $r(t)$: the curve is not part of the
  boundary of any convex set
:result: r(t) = (0,0) (2/3,0) (0,1); r(τ) = (1/8,1/4)
:method: The points by the kernel; three turns decide.
:control: the points of a square
:::
*/
CLAIM(curve_of_a_polygon_that_turns_back_is_not_convex)
{
    num t[8], r[10], w[5], at[4], P[4][2];
    given_curve(T, 4, 3, t, r, w);
    given_points(T, "t", 3, 1, at);
    at[3] = given(T, "τ");
    for (int m = 0; m < 4; m++)
        G(nurbs_point)(2, 2, t + 1, span_of(4, 3, t, at[m]), r + 2, w + 1, at[m], P[m]);
    found_points(T, "r(t)", 3, 2, P[0]);
    found_points(T, "r(τ)", 1, 2, P[3]);
    int inner = 1;
    for (int i = 0; i < 3; i++)
        inner &= turn_2d(P[i], P[(i + 1) % 3], P[3]) > 0;
    about(T, "r(τ) is not inside the triangle of three other points of the curve");
    refute(T, inner);
}

/*
:::{claim} knot_of_full_multiplicity_tears_the_curve
:title: A knot of multiplicity k makes the curve discontinuous
:zh: k 重节点使曲线间断
:kind: counterexample
:given: a linear curve of the points $r$, a square, and weights $w$ over the knots $T$, and its twofold inner knot $t$
:data: T = 0 0 1 1 2 2; r = (0,0) (1,0) (1,1) (0,1); w = 1 1 1 1; t = 1
:instead: T = 0 0 1 3/2 2 2
:then: the curve is two opposite sides: $r(t-)$ from the left and $r(t+)$ from the right are different points
:result: r(t-) = (1,0); r(t+) = (1,1)
:method: Both limits by the kernel.
:control: the second of the two equal knots moved to the right
:::
*/
CLAIM(knot_of_full_multiplicity_tears_the_curve)
{
    num t[7], r[10], w[5], left[2], right[2];
    given_curve(T, 4, 2, t, r, w);
    num knot = given(T, "t");
    G(nurbs_point)(1, 2, t + 1, place_of(6, t, knot) - 1, r + 2, w + 1, knot, left);
    G(nurbs_point)(1, 2, t + 1, span_of(4, 2, t, knot), r + 2, w + 1, knot, right);
    found_points(T, "r(t-)", 1, 2, left);
    found_points(T, "r(t+)", 1, 2, right);
    about(T, "the polygon being convex, the curve is continuous at t");
    refute(T, polygon_is_convex(3, r + 2, 1, NULL) && (!equal_q(left[0], right[0]) || !equal_q(left[1], right[1])));
}

/* det(P, P', P'') on the interval that begins with knot mu, which is not empty; u and R from 0. */
static poly turning_of_span(int p, const num_q u[], int mu, const num_q R[], const num_q w[], poly *weight)
{
    num_q H[MOST_COORDINATES], b[MOST_COORDINATES], one[MAX_DEGREE + 1];
    nurbs_homogenize_q(p, 2, mu, R, w, H + 3 * (mu - p));
    bspline_to_bezier_q(p, 3, u, mu, H, b);
    poly P[3][3], sum = poly_constant(from_int_q(0));
    for (int c = 0; c < 3; c++) {
        for (int i = 0; i <= p; i++)
            one[i] = b[3 * i + c];
        P[0][c] = poly_from_bernstein(p, one);
        P[1][c] = poly_derivative(P[0][c]);
        P[2][c] = poly_derivative(P[1][c]);
    }
    for (int c = 0; c < 3; c++) {
        int i = (c + 1) % 3, j = (c + 2) % 3;
        poly minor = poly_sub(poly_mul(P[1][i], P[2][j]), poly_mul(P[1][j], P[2][i]));
        sum = poly_add(sum, poly_mul(P[0][c], minor));
    }
    if (weight != NULL)
        *weight = P[0][2];
    return sum;
}
static enum cagd_sign_pattern sign_of_span(poly p) { return sign_on(p, from_int_q(0), from_int_q(1), CLOSED); }

/*
:::{claim} mixed_weights_bend_both_ways
:title: With weights of both signs the spline of a convex polygon bends both ways
:zh: 权因子变号时曲线有拐点
:kind: counterexample
:given: a cubic curve of two segments, of the convex points $r$ and weights $w$ of both signs, over the knots $T$
:data: T = 0 0 0 0 1 2 2 2 2; r = (0,0) (2,0) (3,2) (1,4) (0,3); w = 8 -1 8 8 8
:instead: w = 8 1 8 8 8
:then: $w(t)>0$ on the domain, and $\det(P,P',P'')$ takes both signs on the first segment
:result: det(P,P',P'') on [0,1] = "-12960*t^3 + 12096*t^2 + 2304*t - 2304"
:method: The polynomials of the interval; their signs by counting roots.
:control: all weights positive
:::
*/
CLAIM(mixed_weights_bend_both_ways)
{
    num t[10], r[12], w[6];
    poly weight[2];
    given_curve(T, 5, 4, t, r, w);
    poly turn = turning_of_span(3, t + 1, 3, r + 2, w + 1, &weight[0]);
    (void)turning_of_span(3, t + 1, 4, r + 2, w + 1, &weight[1]);
    int stated = polygon_is_convex(4, r + 2, 1, NULL);
    stated &= sign_of_span(weight[0]) == SIGN_POSITIVE && sign_of_span(weight[1]) == SIGN_POSITIVE;
    found_text(T, "det(P,P',P'') on [0,1]", poly_to_string(turn, "t"));
    about(T, "w(t) being positive and the polygon convex, the curve turns to one side on the first segment");
    refute(T, stated && sign_of_span(turn) == SIGN_MIXED);
}

/*
:::{statement} wang-ch4:thm-4.2.1-step-intersection
:title: The hulls of a growing sequence of knots
:zh: 凸包之交
:printed: A(\Gamma_k^{(T)}(T_m'))=\bigcap_{i=1}^mA(\Gamma_k^{(T)}(T_i'))
:holds-by: inserted_points_divide_the_edges insertion_ratios_are_between_zero_and_one
:hypothesis: polygon_that_turns_back_loses_convexity | as for the lemma: the polygon runs through its points once, else the
  $A$ of a refined polygon need not exist; or $A$ is taken as the hull
:needs: hulls_of_unrelated_knots_are_not_nested | the sets of knots increase
:figure: hulls_of_knot_sets

In a decreasing sequence of sets the intersection of the first $m$ is the last.
:::

:::{statement} wang-ch4:thm-4.2.1-step-nested
:title: The sets of knots in the intersection
:zh: T_i 应为 T'_i
:printed: $T_{i+1}\supseteq T_i$, where the $A(\Gamma_k^{(T)}(T_i))$ are plane convex closed sets, $i=1,2,\dots,m$
:class: misprint
:refuted-by: hulls_of_unrelated_knots_are_not_nested
:corrected: $T'_{i+1}\supseteq T'_i$, and the $A(\Gamma_k^{(T)}(T'_i))$
:corrected-by: inserted_points_divide_the_edges insertion_ratios_are_between_zero_and_one
:figure: hulls_of_knot_sets

$T_1$ and $T_2$ are in theorem 4.1.1 the two parts of one set of knots, and need not contain one another; the sequence of
corollary 4.1.1 is that of the $T'_m$.
:::

:::{statement} wang-ch4:thm-4.2.1-step-limit
:title: The limit of the hulls is closed and convex
:zh: 凸包的极限
:printed: A\equiv\lim_{m\to\infty}A(\Gamma_k^{(T)}(T_m'))=\bigcap_{i=1}^{+\infty}A(\Gamma_k^{(T)}(T_i'))
:holds-by: inserted_polygons_stay_convex inserted_points_divide_the_edges insertion_ratios_are_between_zero_and_one
:hypothesis: polygon_that_turns_back_loses_convexity | as for the lemma: the polygon runs through its points once, else the
  $A$ of a refined polygon need not exist; or $A$ is taken as the hull
:needs: hulls_of_unrelated_knots_are_not_nested | the sets of knots increase
:figure: hulls_of_knot_sets

What is decided is that the sets decrease.  The limit of a decreasing sequence of compact sets is their intersection, and
an intersection of closed convex sets is closed and convex.
:::

:::{claim} hulls_of_unrelated_knots_are_not_nested
:title: The hulls of sets of knots that are not nested are not nested
:zh: 无包含关系的节点集
:kind: counterexample
:given: a quadratic segment of the points $r$ and weights $w$ over the knots $T$; $T_1=\{\tau_1\}$, $T_2=\{\tau_2\}$
:data: T = 0 0 0 1 1 1; r = (0,0) (4,0) (0,4); w = 1 1 1; τ = 1/4 3/4
:then: the second vertex of $\Gamma(T_2)$ is not in $A(\Gamma(T_1))$
:result: Γ(T_1) = (0,0) (1,0) (3,1) (0,4); Γ(T_2) = (0,0) (3,0) (1,3) (0,4)
:method: The printed formulas; the hull by `exact/decide/hull.h`, with a separating line.
:control: $T_2=\{\tau_1,\tau_2\}$
:::
*/
CLAIM(hulls_of_unrelated_knots_are_not_nested)
{
    num t[9], r[8], w[5], tau[2], v[2][9], S[2][12], z[2][6];
    given_curve(T, 3, 3, t, r, w);
    given_points(T, "τ", 2, 1, tau);
    G(printed_insertion)(3, 3, 2, t, 3, tau[0], r, w, v[0], S[0], z[0]);
    int count = fault(T, 5, 4);
    if (T->faulty)
        G(printed_insertion)(3, 3, 2, t, 3, tau[1], r, w, v[1], S[1], z[1]);
    else /* both knots */
        G(printed_insertion)(4, 3, 2, v[0], 4, tau[1], S[0], z[0], v[1], S[1], z[1]);
    found_points(T, "Γ(T_1)", 4, 2, S[0] + 2);
    found_points(T, "Γ(T_2)", count, 2, S[1] + 2);
    about(T, "the hull of the second polygon is part of that of the first");
    for (int i = 1; i <= count; i++)
        agree(T, hull_membership(2, 4, S[0] + 2, S[1] + 2 * i).inside);
}

/*
:::{statement} wang-ch4:thm-4.2.1-step-boundary
:title: The curve is on the boundary of the limit
:zh: 极限曲线位于极限凸集的边界
:printed: by (4.1.10), $A$ is the smallest closed convex set $A(\boldsymbol r_k(t))$ with $\boldsymbol r_k(t)$ as boundary or part of the
  boundary, so $\boldsymbol r_k(t)$ is convex
:holds-by: convex_polygons_lie_on_the_border_of_their_hull convex_polygons_have_splines_of_one_turn
:hypothesis: knot_of_full_multiplicity_tears_the_curve | no inner knot has multiplicity $k$; else the polygons converge to the curve
  together with the segment over which it jumps
:reading: limit_of_convex_polygons_may_run_back | as a step about the limits of any convex polygons, convex meaning run through once
:reading: convex_polygons_have_splines_of_one_turn | as a step about NURBS curves
:figure: where_hypotheses_are_needed

The reason is not given.  It is this: let polygon points $P_m\to P$, $P$ inside $A$.  Some disc about $P$ is in $A$, so in every
$A(\Gamma_k^{(T)}(T'_m))$, and for large $m$ the point $P_m$ is inside it, not on the boundary.  Hence $P$ is on the boundary, and
$A$, the limit of the hulls, is the hull of the limit.  That the curve runs there once is another matter: convex polygons can
flatten to a segment that is run through twice.  A NURBS curve on a line has its polygon on that line, which settles it.
:::

:::{claim} convex_polygons_have_splines_of_one_turn
:title: NURBS curves of convex polygons never turn to the other side
:zh: 设计算例曲线的转向
:kind: decision
:given: the curves of `inserted_polygons_stay_convex`
:then: $\det(P,P',P'')\ge0$ on every interval of knots, and any three of thirteen points of the curve, equally spaced in the
  parameter, turn left in their order or are on one line
:method: The homogeneous Bézier points of each interval; the sign of the polynomial by counting its roots.  The points by the
  kernel, the areas exactly.
:degrees: 2..4
:scope: n stands for the order k; the stated curves
:control: the third point thrown across the line of the first two
:::
*/
CLAIM(convex_polygons_have_splines_of_one_turn)
{
    for (int example = 0; example < CONVEX_CURVES; example++)
        for (int family = 0; family < WEIGHTS && convex_curve[example].k == T->degree; family++) {
            region_mark mark = region_open();
            int n = convex_curve[example].n, k = convex_curve[example].k;
            num t[MOST_POINTS], r[MOST_COORDINATES], w[MOST_POINTS];
            designed_curve_of(example, family, t, r, w);
            r[2 * 3 + 1] = fault(T, r[2 * 3 + 1], sub(from_int(-9), r[2 * 3 + 1]));
            agree(T, fault(T, 1, !polygon_is_convex(n - 1, r + 2, 1, NULL) || k == 2));
            for (int j = k; j <= n; j++)
                if (compare_q(t[j], t[j + 1]) < 0) {
                    enum cagd_sign_pattern sign =
                        sign_of_span(turning_of_span(k - 1, t + 1, j - 1, r + 2, w + 1, NULL));
                    agree(T, sign == SIGN_POSITIVE || sign == SIGN_NONNEGATIVE || sign == SIGN_ZERO);
                }
            enum { POINTS = 13 };
            num P[2 * POINTS];
            for (int m = 0; m < POINTS; m++) {
                num x = add(t[k], mul(from_ratio(m, POINTS - 1), sub(t[n + 1], t[k])));
                G(nurbs_point)(k - 1, 2, t + 1, span_of(n, k, t, x), r + 2, w + 1, x, P + 2 * m);
            }
            for (int c = 2; c < POINTS; c++)
                for (int b = 1; b < c; b++)
                    for (int a = 0; a < b; a++)
                        agree(T, turn_2d(P + 2 * a, P + 2 * b, P + 2 * c) >= 0);
            if (k == 2) { /* the curve is the polygon */
                int orientation;
                agree(T, polygon_is_convex(n - 1, r + 2, 1, &orientation) && orientation == 1);
            }
            region_drop(mark);
        }
}

/*
:::{claim} periodic_curves_of_convex_polygons_are_convex
:title: A closed polygon that is convex has a convex periodic curve
:zh: 闭合周期曲线的保凸性
:kind: decision
:given: convex polygons of $3$, $4$ and $5$ points, closed; orders $3$ and $4$; a period of different intervals; weights $1$, $1000$ and $1$
  in turn, and $1,10,100,\dots$
:then: the Bézier points of all intervals, joined, are a closed convex polygon that runs round once
:method: That polygon is what one gets by inserting every knot until its multiplicity is $k-1$; it is a polygon for which the
  theorem holds.  Convexity by `exact/decide/hull.h`.
:degrees: 3..4
:scope: n stands for the order k; the stated curves
:control: the second point moved across the line of its neighbours
:::
*/
CLAIM(periodic_curves_of_convex_polygons_are_convex)
{
    static const long point[3][2 * 5] = {{0, 0, 3, 0, 1, 2}, {0, 0, 3, 0, 3, 3, 0, 1}, {0, 0, 4, 0, 5, 3, 2, 5, 0, 1}};
    static const long knot[] = {0, 2, 3, 5, 6, 7};
    enum { SIZE = 16 };
    int p = T->degree - 1;
    for (int m = 3; m <= 5; m++)
        for (int family = 0; family < 3; family++) {
            num u[SIZE], R[2 * SIZE], H[3 * SIZE], v[SIZE], D[3 * SIZE], w[SIZE], b[3 * SIZE], joined[2 * 5 * SIZE];
            region_mark mark = region_open();
            points_of(m, point[m - 3], R);
            R[3] = fault(T, R[3], add(from_int(9), R[5]));
            for (int i = 0; i <= m; i++) {
                u[i] = from_int(knot[i]);
                w[i] = family_weight(family, m, i + 1);
            }
            G(rational_homogenize)(m - 1, 2, R, w, H);
            G(bspline_periodic)(m, p, 3, u, H, v, D);
            for (int j = 0; j < m; j++) {
                G(bspline_to_bezier)(p, 3, v, p + j, D, b);
                G(rational_dehomogenize)(p - 1, 2, b, joined + 2 * j * p, w);
            }
            int orientation;
            agree(T, fault(T, polygon_is_convex(m - 1, R, 1, &orientation) && orientation == 1, 1));
            agree(T, polygon_is_convex(m * p - 1, joined, 1, &orientation) && orientation == 1);
            region_drop(mark);
        }
}

/*
:::{claim} limit_of_convex_polygons_may_run_back
:title: Convex polygons with decreasing hulls, whose limit runs to and fro
:zh: 凸多边形的极限可往返
:kind: counterexample
:given: the rectangles $(0,0),(1,0),(1,h),(0,h)$ for a decreasing sequence of $h$, and their limit for $h\to h_\infty$
:data: h = 1 1/2 1/4 1/8 1/16 1/32 1/64; h_∞ = 0
:instead: h_∞ = 1
:then: the polygons are convex and each hull contains the next; the limit goes from $(0,0)$ to $(1,0)$ and back
:result: limit = (0,0) (1,0) (1,0) (0,0)
:method: Convexity of them and of the limit by `exact/decide/hull.h`.
:control: the limit for $h\to1$
:::
*/
CLAIM(limit_of_convex_polygons_may_run_back)
{
    enum { SIZE = 7 };
    int convex = 1, decreasing = 1;
    num R[] = {from_int(0), from_int(0), from_int(1), from_int(0), from_int(1), from_int(1), from_int(0), from_int(1)};
    num h[SIZE];
    given_points(T, "h", SIZE, 1, h);
    for (int m = 0; m < SIZE; m++) {
        R[5] = R[7] = h[m];
        convex &= polygon_is_convex(3, R, 0, NULL);
        decreasing &= m == 0 || compare_q(h[m], h[m - 1]) < 0;
    }
    R[5] = R[7] = given(T, "h_∞");
    found_points(T, "limit", 4, 2, R);
    about(T, "the polygons being convex and their heights decreasing, the limit runs through its points once");
    refute(T, convex && decreasing && !polygon_is_convex(3, R, 0, NULL));
}
#endif

#include "chapters/judge/claims_off.h"
