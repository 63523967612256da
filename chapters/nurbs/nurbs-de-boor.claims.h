/*
# De Boor's algorithm with weights (递推求值)

On an interval $[t_j,t_{j+1})$ the point of parameter $t$ is reached from $r_{j-k+1},\dots,r_j$ in $k-1$ levels.  Each level
divides the edges of the polygon before; the ratio in which an edge is divided is that of de Boor's algorithm, multiplied by the
ratio of the weights at its ends.
*/
#include "chapters/nurbs/definition.h"
#include "chapters/nurbs/discrete.h"
#include "chapters/nurbs/patterns.h"

#include "chapters/judge/claims_on.h"

/*
## The recursion

:::{statement} wang-ch4:formula-4.1.3
:title: The weights of the levels
:zh: 各层的权因子
:definition: yes
:printed: w_i^{[r]}(t)=w_i,\ r=0;\ i=j-k+1,j-k+2,\dots,j,\qquad w_i^{[r]}(t)=\frac{t-t_i}{t_{i+k-r}-t_i}w_i^{[r-1]}(t)+\frac{t_{i+k-r}-t}{t_{i+k-r}-t_i}
  w_{i-1}^{[r-1]}(t),\ r=1,2,\dots,k-1;\ i=j-k+r+1,j-k+r+2,\dots,j
:checked-by: weights_of_levels_are_those_of_de_boor divisors_contain_the_span
:confirmed-by: rational_triangle_follows_the_recursion weights_of_levels_are_positive rational_triangle_gives_the_point
:figure: deboor_triangle

The weights are de Boor's algorithm on the numbers $w_i$, so that $w_j^{[k-1]}(t)=w(t)$.
:::

:::{statement} wang-ch4:formula-4.1.4
:title: The points of the levels
:zh: 各层的顶点
:definition: yes
:printed: r_i^{[r]}(t)=r_i,\ r=0;\ i=j-k+1,j-k+2,\dots,j,\qquad
  r_i^{[r]}(t)=\frac{(t-t_i)w_i^{[r-1]}(t)}{(t-t_i)w_i^{[r-1]}(t)+(t_{i+k-r}-t)w_{i-1}^{[r-1]}(t)}r_i^{[r-1]}(t)
  +\frac{(t_{i+k-r}-t)w_{i-1}^{[r-1]}(t)}{(t-t_i)w_i^{[r-1]}(t)+(t_{i+k-r}-t)w_{i-1}^{[r-1]}(t)}r_{i-1}^{[r-1]}(t),
  \ r=1,2,\dots,k-1;\ i=j-k+r+1,j-k+r+2,\dots,j
:checked-by: rational_triangle_follows_the_recursion divisors_contain_the_span weights_of_levels_are_positive
:needs: weight_of_a_level_may_vanish | definition 4.1.1: $w_i>0$ | the weights are positive: otherwise a weight of a level may
  vanish and stop the algorithm, where the curve has a point
:needs: weight_of_a_level_vanishes_outside_the_interval | algorithm 4.1.1: $t\in[t_i,t_{i+1})$, whose $i$ is the $j$ of `alg-4.1.1-interval` | $t$ is in
  $[t_j,t_{j+1})$: outside it a weight of a level may vanish, though the given ones are positive
:figure: deboor_triangle
:::
*/

/* (4.1.3) by its letter: w_i^[r](t), indices from 1, order k. */
static num G(printed_weight)(int k, const num u[], const num w[], int r, int i, num t)
{
    if (r == 0)
        return w[i - 1];
    num from = u[i - 1], to = u[i + k - r - 1], length = sub(to, from);
    return add(mul(div(sub(t, from), length), G(printed_weight)(k, u, w, r - 1, i, t)),
               mul(div(sub(to, t), length), G(printed_weight)(k, u, w, r - 1, i - 1, t)));
}

/* (4.1.4) by its letter: coordinate c of r_i^[r](t). */
static num G(printed_point)(int k, int dim, const num u[], const num R[], const num w[], int r, int i, int c, num t)
{
    if (r == 0)
        return R[(i - 1) * dim + c];
    num a = mul(sub(t, u[i - 1]), G(printed_weight)(k, u, w, r - 1, i, t));
    num b = mul(sub(u[i + k - r - 1], t), G(printed_weight)(k, u, w, r - 1, i - 1, t)), sum = add(a, b);
    return add(mul(div(a, sum), G(printed_point)(k, dim, u, R, w, r - 1, i, c, t)),
               mul(div(b, sum), G(printed_point)(k, dim, u, R, w, r - 1, i - 1, c, t)));
}

/*
The two formulas are read by their letter, in the indices of the source and one call for each term. The kernel overwrites one
array from level to level. What is compared is every entry of every level, since a wrong index in the middle can cancel at the
end.

:::{claim} rational_triangle_follows_the_recursion
:title: The levels of the kernel are those of (4.1.3) and (4.1.4)
:zh: 核函数各层即 (4.1.3)、(4.1.4)
:given: every segment, the distinct knots variables; weights and points of space, any $t$; every level
:where: the weights of the levels are not 0
:then: `nurbs_deboor_level`, level after level, gives $w_i^{[r]}$ and $r_i^{[r]}$; the last point and weight of the level before
  stay where they were
:method: The kernel against the two recursions by their letter, in the indices of the source.
:degrees: 1..6 sampled 7
:scope: every pattern of the knots of a segment up to order 4, k+2 of them above; the distinct knots variables up to order 5,
  numbers above
:defines: nurbs_deboor_level
:control: the last level is given the weights 1
:::
*/
CLAIM(rational_triangle_follows_the_recursion)
{
    enum { dim = 3 };
    int p = T->degree, k = p + 1, j = k;
    struct G(knot_vector) K = {0};
    num R[dim * MOST_KNOTS], w[MOST_KNOTS], P[dim * MOST_KNOTS], v[MOST_KNOTS], t = unknown(T, "t", 0);
    G(weighted_points)(T, k, dim, R, w);
    for (int number = G(segment_knots)(T, p, 0, &K); number > 0; number = G(segment_knots)(T, p, number, &K)) {
        for (int m = 0; m < k; m++) {
            v[m] = w[m];
            for (int c = 0; c < dim; c++)
                P[dim * m + c] = R[dim * m + c];
        }
        for (int r = 1; r <= p; r++) {
            int points = k - r; /* after this level */
            num last = v[points], end[dim];
            for (int c = 0; c < dim; c++)
                end[c] = P[dim * points + c];
            for (int m = 0; T->faulty && r == p && m <= points; m++)
                v[m] = last = from_int(1);
            G(nurbs_deboor_level)(G(nurbs_on_span)(p, dim, K.u, j - 1, NULL, NULL), r, P, v, t);
            for (int m = 0; m < points; m++) {
                int i = j - k + r + 1 + m;
                about(T, "w_i^[r]");
                same(T, v[m], G(printed_weight)(k, K.u, w, r, i, t));
                about(T, "r_i^[r]");
                for (int c = 0; c < dim; c++)
                    same(T, P[dim * m + c], G(printed_point)(k, dim, K.u, R, w, r, i, c, t));
            }
            about(T, "the last of the level before");
            same(T, v[points], last);
            for (int c = 0; c < dim; c++)
                same(T, P[dim * points + c], end[c]);
        }
    }
}

/*
The weights alone follow a recursion of their own, in which no weight is divided by.

:::{claim} weights_of_levels_are_those_of_de_boor
:title: The weights of the levels are de Boor's algorithm on the numbers w_i
:zh: 各层权因子即对 w_i 施行 deBoor 算法
:given: every segment, the distinct knots variables; any numbers $w_i$, any $t$; every level
:then: `bspline_deboor_level`, level after level, gives $w_i^{[r]}$
:method: The kernel against (4.1.3) by its letter, in the indices of the source.
:degrees: 1..6 sampled 7
:scope: every pattern of the knots of a segment up to order 4, k+2 of them above; the distinct knots variables up to order 5,
  numbers above
:control: the last level is given the numbers 1
:::
*/
CLAIM(weights_of_levels_are_those_of_de_boor)
{
    int p = T->degree, k = p + 1, j = k;
    struct G(knot_vector) K = {0};
    num w[MOST_KNOTS], v[MOST_KNOTS], t = unknown(T, "t", 0);
    for (int i = 0; i < k; i++)
        w[i] = unknown(T, "w", i);
    for (int number = G(segment_knots)(T, p, 0, &K); number > 0; number = G(segment_knots)(T, p, number, &K)) {
        for (int m = 0; m < k; m++)
            v[m] = w[m];
        for (int r = 1; r <= p; r++) {
            for (int m = 0; T->faulty && r == p && m <= k - r; m++)
                v[m] = from_int(1);
            G(bspline_deboor_level)(G(on_span)(p, 1, K.u, j - 1, NULL), r, v, t);
            for (int m = 0; m < k - r; m++)
                same(T, v[m], G(printed_weight)(k, K.u, w, r, j - k + r + 1 + m, t));
        }
    }
}

/*
That these numbers are defined at all depends on the range of $i$, which is printed with care: one index lower, and the divisor
belongs to an interval that does not contain $[t_j,t_{j+1}]$, and may be $0$. Inside the range all knots but $t_j<t_{j+1}$ may
coincide.

:::{claim} divisors_contain_the_span
:title: In the ranges of (4.1.3) no divisor vanishes
:zh: 所列指标范围内分母不为零
:types: field rational
:given: the order $k$, the span $[t_j,t_{j+1})$ and the level $r$ of (4.1.3); an index $i=j-k+r+1+m$ of its range, $m\ge0$, and so $i=j-l$ with $l=k-r-1-m\ge0$; all of them variables
:then: $j-i=l$ and $(i+k-r)-(j+1)=m$, so that $i\le j<j+1\le i+k-r$: the interval $[t_i,t_{i+k-r}]$ contains $[t_j,t_{j+1}]$, and the divisor is at least
  $t_{j+1}-t_j>0$, whatever knots coincide outside; for $i=j-k+r$ it is $i+k-r=j$, and the interval does not contain it
:method: Identities in the indices, for every $k$ at once.
:degrees: all
:over: j k r m: -
:control: the range begun at $i=j-k+r$
:::
*/
CLAIM(divisors_contain_the_span)
{
    num j = whole(T, "j", 40, 60), r = whole(T, "r", 1, 9), m = whole(T, "m", 0, 9), one = from_int(1);
    num k = add(add(r, m), whole(T, "k", 1, 9)), l = sub(sub(k, r), add(m, one));
    num lowest = add(sub(j, k), fault(T, add(r, one), r)), i = add(lowest, m), end = sub(add(i, k), r);
    about(T, "i <= j");
    same(T, sub(j, i), l);
    about(T, "j + 1 <= i + k - r");
    same(T, sub(end, add(j, one)), m);
    about(T, "one index below the range");
    same(T, sub(add(sub(lowest, one), k), r), j);
}

/*
:::{statement} wang-ch4:formula-4.1.5
:title: The last point of the recursion is the point of the curve
:zh: 递推的最后一点即曲线上的点
:printed: r(t)=r_i^{[k-1]}(t)
:holds-by: rational_triangle_gives_the_point
:needs: weight_of_a_level_may_vanish | definition 4.1.1: $w_i>0$ | the weights are positive: otherwise the recursion may stop before the point, though the curve has it
:needs: other_interval_gives_other_point | algorithm 4.1.1: $t\in[t_i,t_{i+1})$, whose $i$ is the $j$ of `alg-4.1.1-interval` | $t$ is in
  $[t_j,t_{j+1})$: with the $j$ of another interval the last point is one of another segment
:reading: rational_triangle_gives_the_point | $i$ is the only index that the level $k-1$ has, $i=j$
:confirmed-by: weights_of_levels_are_positive
:figure: deboor_triangle

With positive weights and $t$ in the interval the weights of all levels are positive, so not 0: `weights_of_levels_are_positive`.
:::

:::{claim} rational_triangle_gives_the_point
:title: After k-1 levels the point of the curve is reached
:zh: k-1 层之后得到曲线上的点
:given: several segments, the distinct knots variables; every interval $[t_j,t_{j+1})$ of the domain; weights, points, any $t$
:where: the weights of the levels are not 0
:then: $r_j^{[k-1]}(t)=r(t)$ and $w_j^{[k-1]}(t)=w(t)$, by the recursion and by the kernel
:method: The recursions by their letter, and the kernel, against the sums of all terms of (4.1.2).  Both sides are rational functions
  of $t$: at the right end of a closed interval the recursion gives the limit from the left.
:degrees: 1..6 sampled 6
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:defines: nurbs_deboor
:control: the point $r_{j-1}^{[k-2]}(t)$
:::
*/
CLAIM(rational_triangle_gives_the_point)
{
    int p = T->degree, k = p + 1;
    struct G(knot_vector) K = {0};
    num R[MOST_KNOTS], w[MOST_KNOTS], point, out, t = unknown(T, "t", 0);
    for (int m = G(several_knots)(T, p, 0, &K); m > 0; m = G(several_knots)(T, p, m, &K)) {
        const num *u = K.u;
        G(weighted_points)(T, K.n, 1, R, w);
        for (int interval = K.place[p]; interval < K.place[K.n]; interval += 2) {
            int j = G(span_of_interval)(K.count, K.place, interval) + 1;
            num total = G(nurbs_by_definition)(K.n, p, 1, u, K.place, R, w, interval, t, &point);
            about(T, "the point by the recursion");
            int r = fault(T, p, p - 1), i = fault(T, j, j - 1);
            same(T, G(printed_point)(k, 1, u, R, w, r, i, 0, t), point);
            about(T, "the weight by the recursion");
            same(T, G(printed_weight)(k, u, w, r, i, t), total);
            about(T, "the point by the kernel");
            G(nurbs_deboor)(G(nurbs_on_span)(p, 1, u, j - 1, R, w), t, &out);
            same(T, out, point);
        }
    }
}

/*
## Where it may be used

The recursion computes a rational function of $t$, the same for every $t$ once $j$ is chosen. Nothing in it notices that $t$ has left the
interval: it goes on drawing the segment beyond its ends. So the sentence that ties $j$ to $t$ is part of the algorithm, and just
this sentence has the wrong letter.

:::{statement} wang-ch4:alg-4.1.1-interval
:title: The interval of the algorithm
:zh: 算法 4.1.1 的参数区间
:printed: For the curve (4.1.2) and any fixed parameter $t\in[t_i,t_{i+1})$, $k\le j\le n$, compute recursively $w_i^{[r]}(t)$ and $r_i^{[r]}(t)$ by (4.1.3) and (4.1.4), where
  $i=j-k+r+1,\dots,j$; then (4.1.5)
:refuted-by: other_interval_gives_other_point
:class: misprint
:corrected: For any fixed $t\in[t_j,t_{j+1})$, $k\le j\le n$
:corrected-by: rational_triangle_gives_the_point divisors_contain_the_span
:reading: rational_triangle_gives_the_point | the index of the interval is the $j$ of the ranges, as it is when it is the $i$ of (4.1.5)
:figure: wrong_interval

The printed $i$ of the interval is the running index of the ranges as well.  Only (4.1.5), printed with $i$ too, ties $j$ to the interval: the level
$k-1$ has no index but $j$.
:::
*/

#if RATIONAL
/*
:::{claim} other_interval_gives_other_point
:title: With the j of another interval the recursion gives another point
:zh: j 与 t 所在区间不符时得到另一点
:kind: counterexample
:given: a quadratic curve of the points $r$ and weights $w$ over the knots $T$, a parameter $t$ of its domain, and an index $j$ with
  $k\le j\le n$ whose interval $[t_j,t_{j+1})$ does not contain $t$
:data: T = 1 2 3 4 5 6 7; r = (0,0) (1,2) (2,0) (3,2); w = 1 1 1 3; t = 7/2; j = 4
:instead: j = 3
:then: $r_j^{[2]}(t)$ is another point than $r(t)$: a point of the next segment, continued backwards
:result: r(t) = (1,3/2); r_j^[2](t) = (7/5,12/5)
:method: The recursion by its letter against the definition.
:control: the $j$ of the interval that contains $t$
:::
*/
CLAIM(other_interval_gives_other_point)
{
    num u[7], R[8], w[4], Q[2], P[2];
    int place[7];
    G(given_knots)(T, "T", 7, u, place);
    given_points(T, "r", 4, 2, R);
    given_points(T, "w", 4, 1, w);
    num t = given(T, "t");
    int j = given_whole(T, "j");
    G(nurbs_by_definition)(4, 2, 2, u, place, R, w, G(interval_after)(7, u, place, t), t, P);
    for (int c = 0; c < 2; c++)
        Q[c] = G(printed_point)(3, 2, u, R, w, 2, j, c, t);
    found_points(T, "r(t)", 1, 2, P);
    found_points(T, "r_j^[2](t)", 1, 2, Q);
    about(T, "the coordinates of the two points");
    for (int c = 0; c < 2; c++)
        same(T, Q[c], P[c]);
}

/*
:::{statement} wang-ch4:alg-4.1.1-end
:title: The algorithm is for every parameter of the half-open intervals
:zh: 算法适用于各半开区间内的任意参数
:printed: De Boor's algorithm 2.4.1 for the values of B-splines can be extended to NURBS curves: algorithm 4.1.1 is for the curve (4.1.2), $t_k\le t\le t_{n+1}$, and any
  fixed $t$ of an interval half-open on the right, $k\le j\le n$
:holds-by: rational_triangle_gives_the_point
:needs: weight_of_a_level_may_vanish | definition 4.1.1: $w_i>0$ | the weights are positive: otherwise the recursion may stop before the point, though the curve has it
:meant: the intervals, which are printed | The parameters of the printed intervals.
:reading: rational_triangle_gives_the_point | for the parameters of the printed intervals
:reading: end_is_in_no_interval | for every $t$ of the curve, its end included, though that is not printed: none of the intervals contains $t_{n+1}$
:confirmed-by: weights_of_levels_are_positive
:figure: missing_end

With positive weights and $t$ in the interval the weights of all levels are positive, so not 0: `weights_of_levels_are_positive`.
:::

:::{claim} end_is_in_no_interval
:title: The right end of the curve is in none of the intervals
:zh: 曲线右端参数不属于任一区间
:kind: counterexample
:given: the knots $T$ of a quadratic curve with $n$ points; $t=t_{n+1}$, a parameter of the curve
:data: T = 0 0 0 1 2 2 2; n = 4
:then: no $j$ with $k\le j\le n$ has $t_j\le t<t_{j+1}$
:result: t_{n+1} = 2; intervals that contain it = 0
:method: Every $j$.
:control: the last interval $[t_n,t_{n+1}]$ closed
:::
*/
CLAIM(end_is_in_no_interval)
{
    enum { k = 3 };
    num u[7];
    given_points(T, "T", 7, 1, u);
    int n = given_whole(T, "n"), contained = 0;
    for (int j = k; j <= n; j++) { /* u[j] is t_{j+1} */
        int begun = compare_q(u[j - 1], u[n]) <= 0, ended = compare_q(u[j], u[n]);
        contained += fault(T, begun && (ended > 0 || (j == n && ended == 0)), begun && ended > 0);
    }
    found(T, "t_{n+1}", u[n]);
    found_whole(T, "intervals that contain it", contained);
    about(T, "an interval contains the end");
    agree(T, contained > 0);
}

/*
:::{claim} weight_of_a_level_may_vanish
:title: With a negative weight the algorithm may stop before the curve
:zh: 权因子为负时递推可能中断
:kind: counterexample
:given: the knots $T$ of one quadratic segment, weights $w$ of which one is negative, and $t$
:data: T = 0 0 0 1 1 1; w = 1 -1 2; t = 1/2
:instead: w = 1 1 2
:then: $w(t)$ is not $0$, so that the curve has a point, but $w_2^{[1]}(t)$ vanishes and $r_2^{[1]}$ does not exist
:result: w_2^[1](t) = 0; w(t) = 1/4
:method: The weights of the levels by the recursion.
:control: all weights positive
:::
*/
/* Refutes for the first segment of the given quadratic curve of n points: if the last weight of the levels is not 0, then w_2^[1]
 * is not 0. */
static void weight_of_the_first_level(trial *T, int n, const char *last, const char *refuted)
{
    num_q u[7], w[4];
    given_points_q(T, "T", n + 3, 1, u);
    given_points_q(T, "w", n, 1, w);
    num_q t = given_q(T, "t");
    num_q level = printed_weight_q(3, u, w, 1, 2, t), total = printed_weight_q(3, u, w, 2, 3, t);
    found_q(T, "w_2^[1](t)", level);
    found_q(T, last, total);
    about(T, refuted);
    refute(T, sign_q(total) != 0 && sign_q(level) == 0);
}

CLAIM(weight_of_a_level_may_vanish)
{
    weight_of_the_first_level(T, 3, "w(t)", "if w(t) is not 0, then w_2^[1] is not 0");
}

/*
:::{claim} weight_of_a_level_vanishes_outside_the_interval
:title: Outside its interval the algorithm subtracts positive weights
:zh: 参数在区间之外时各层权因子可相消为零
:kind: counterexample
:given: the knots $T$ of two quadratic segments, positive weights $w$, and $t$ in the interval of the second, $[t_4,t_5)$; the levels with $j=3$, of the first
:data: T = 0 0 0 1 2 2 2; w = 3 1 1 1; t = 3/2
:instead: t = 1/2
:then: $w_2^{[1]}(t)=(1-t)w_1+t\,w_2$ is a difference and vanishes, while $w_3^{[2]}(t)$, the polynomial $w$ of the first segment continued, does not
:result: w_2^[1](t) = 0; w_3^[2](t) = 3/2
:method: The weights of the levels by the recursion.
:control: $t$ in the interval of the first segment
:::
*/
CLAIM(weight_of_a_level_vanishes_outside_the_interval)
{
    weight_of_the_first_level(T, 4, "w_3^[2](t)", "if w_3^[2] is not 0, then w_2^[1] is not 0");
}
#endif

/*
## What it means (几何意义)

Each level of the rational triangle is a polygon, with its vertices on the edges of the one before (割角). The ratio is not that of
the knots, as the weights at both ends of an edge pull the point to the heavier one. It stays between $0$ and $1$ as long as the
weights of the levels, which are means of the given ones, are positive.

:::{statement} wang-ch4:alg-4.1.1-corner-cutting
:title: Geometrically the algorithm cuts the corners of the polygon in k-1 levels
:zh: 几何意义为对控制多边形的 k-1 层割角
:printed: Geometrically algorithm 4.1.1, too, means $k-1$ levels of corner cutting of the control polygon
:holds-by: every_level_divides_its_edges weights_of_levels_are_positive divisors_contain_the_span
:needs: negative_weight_divides_outside | definition 4.1.1: $w_i>0$ | the weights are positive: with others an edge may be
  divided outside
:needs: other_interval_divides_outside | algorithm 4.1.1: $t\in[t_i,t_{i+1})$, whose $i$ is the $j$ of `alg-4.1.1-interval` | $t$ is in
  $[t_j,t_{j+1})$: with the $j$ of another interval an edge may be divided outside, too
:figure: deboor_triangle

Level $r$ puts one point on each of the $k-r$ edges of the polygon of level $r-1$ that belongs to the interval.
:::

:::{claim} every_level_divides_its_edges
:title: The points of a level divide the edges of the level before
:zh: 各层顶点分割上一层的边
:given: every segment with any positive gaps of its knots, $t=t_j+(t_{j+1}-t_j)\frac s{1+s}$, $s>0$, or $t=t_j$; positive weights
:let: $\lambda=(t-t_i)w_i^{[r-1]}/[(t-t_i)w_i^{[r-1]}+(t_{i+k-r}-t)w_{i-1}^{[r-1]}]$
:then: $r_i^{[r]}=(1-\lambda)\,r_{i-1}^{[r-1]}+\lambda\,r_i^{[r-1]}$ with $0\le\lambda\le1$, on every level
:method: The kernel's levels; signs are read off coefficients in $s$, the gaps and the weights.
:degrees: 1..6 sampled 6
:scope: every pattern of the knots of a segment up to order 4, k+2 of them above; the distinct knots variables up to order 5,
  numbers above
:over: s: ratio in which t divides its interval; x: -
:control: $\lambda$ and $1-\lambda$ exchanged
:::
*/
CLAIM(every_level_divides_its_edges)
{
    int p = T->degree, k = p + 1, mu = p;
    struct G(knot_vector) K = {.kind = FIELD && p > 4 ? INTEGERS : LENGTHS};
    num R[2 * MOST_KNOTS], w[MOST_KNOTS], P[2 * MOST_KNOTS], v[MOST_KNOTS];
    for (int number = G(segment_knots)(T, p, 0, &K); number > 0; number = G(segment_knots)(T, p, number, &K)) {
        const num *u = K.u;
        for (int knot = 0; knot <= 1; knot++) { /* inside, and at the left end */
            num t = knot ? u[mu] : add(u[mu], mul(sub(u[mu + 1], u[mu]), inside(T, "s")));
            G(weighted_points)(T, k, 2, R, w);
            for (int r = 1; r <= p; r++) {
                for (int m = 0; m <= k - r; m++) {
                    v[m] = w[m];
                    P[2 * m] = R[2 * m];
                    P[2 * m + 1] = R[2 * m + 1];
                }
                G(nurbs_deboor_level)(G(nurbs_on_span)(p, 2, u, mu, NULL, NULL), r, R, w, t);
                for (int m = 0; m < k - r; m++) {
                    int i = mu - p + r + m;
                    /* λ = (t - t_i) w_i / ((t - t_i) w_i + (t_{i+k-r} - t) w_{i-1}) */
                    num right = mul(sub(t, u[i]), v[m + 1]), left = mul(sub(u[i + p + 1 - r], t), v[m]);
                    num lambda = div(fault(T, right, left), add(left, right)), rest = sub(from_int(1), lambda);
                    about(T, "the ratio is in [0, 1]");
                    nonnegative(T, lambda);
                    nonnegative(T, rest);
                    about(T, "the new point");
                    for (int c = 0; c < 2; c++)
                        same(T, R[2 * m + c], add(mul(rest, P[2 * m + c]), mul(lambda, P[2 * m + 2 + c])));
                }
            }
        }
    }
}

/*
:::{claim} weights_of_levels_are_positive
:title: The weights of all levels are positive
:zh: 各层权因子均为正
:given: every segment with any positive gaps of its knots, $t$ inside it or at its left end, positive weights
:then: $w_i^{[r]}(t)>0$ for all $r$ and $i$ of the ranges
:method: The recursion by its letter; signs are read off coefficients.
:degrees: 1..6 sampled 6
:scope: every pattern of the knots of a segment up to order 4, k+2 of them above; the distinct knots variables up to order 5,
  numbers above
:over: s: ratio in which t divides its interval; x: -
:control: all weights negative
:::
*/
CLAIM(weights_of_levels_are_positive)
{
    int p = T->degree, k = p + 1, j = k;
    struct G(knot_vector) K = {.kind = FIELD && p > 4 ? INTEGERS : LENGTHS};
    num w[MOST_KNOTS];
    for (int i = 0; i < k; i++) {
        num weight = positive(T, "w", i);
        w[i] = fault(T, weight, neg(weight));
    }
    for (int number = G(segment_knots)(T, p, 0, &K); number > 0; number = G(segment_knots)(T, p, number, &K)) {
        for (int knot = 0; knot <= 1; knot++) { /* inside, and at the left end */
            num t = knot ? K.u[j - 1] : add(K.u[j - 1], mul(sub(K.u[j], K.u[j - 1]), inside(T, "s")));
            for (int r = 0; r <= p; r++)
                for (int i = j - k + r + 1; i <= j; i++)
                    G(must_be_positive)(T, G(printed_weight)(k, K.u, w, r, i, t));
        }
    }
}

#if RATIONAL
/*
:::{claim} negative_weight_divides_outside
:title: With a negative weight an edge is divided outside
:zh: 权因子为负时外分
:kind: counterexample
:given: a linear segment from $0$ to $1$ on the line, the points $r$, over the knots $T$, with weights $w$ of which one is negative, and $t$
:data: T = 0 0 1 1; r = 0 1; w = 1 -1/2; t = 1/4
:instead: w = 1 1/2
:then: the ratio $\lambda$ in which the edge is divided is negative, so outside $[0,1]$
:result: λ = -1/5
:method: The level of the kernel; the point is $\lambda$.
:control: all weights positive
:::
*/
/* Whether the ratio in which the first edge of the given linear curve of n points is divided is in [0, 1]. */
static int G(edge_is_divided_inside)(trial *T, int n)
{
    num u[5], P[3], w[3];
    given_points(T, "T", n + 2, 1, u);
    given_points(T, "r", n, 1, P);
    given_points(T, "w", n, 1, w);
    G(nurbs_deboor_level)(G(nurbs_on_span)(1, 1, u, 1, NULL, NULL), 1, P, w, given(T, "t"));
    found(T, "λ", P[0]);
    about(T, "0 <= λ <= 1");
    return sign_q(P[0]) >= 0 && sign_q(sub(from_int(1), P[0])) >= 0;
}

CLAIM(negative_weight_divides_outside) { agree(T, G(edge_is_divided_inside)(T, 2)); }

/*
:::{claim} other_interval_divides_outside
:title: With the index of another interval an edge is divided outside
:zh: 区间下标不符时外分
:kind: counterexample
:given: two linear segments on the line, of the points $r$ over the knots $T$, with positive weights $w$; a parameter $t$ of the second, and the edge from $0$ to $1$
  of the first
:data: T = 0 0 1 2 2; r = 0 1 2; w = 1 1/2 1; t = 3/2
:instead: t = 1/4
:then: the ratio $\lambda$ in which the edge is divided is greater than $1$, so outside $[0,1]$
:result: λ = 3
:method: The level of the kernel; the point is $\lambda$.
:control: $t$ in the interval of the first segment
:::
*/
CLAIM(other_interval_divides_outside) { agree(T, G(edge_is_divided_inside)(T, 3)); }
#endif

/*
:::{statement} wang-ch4:alg-4.1.1-coefficients
:title: The coefficients of the cutting depend on the weights, too
:zh: 割角系数也与权因子有关
:printed: The coefficients of corner cutting depend on the parameter $t$, the knots, the level $r$ and the number $i$ of the edge, and
  also on the weights of the curve
:holds-by: weights_enter_the_coefficients every_level_divides_its_edges
:confirmed-by: coefficients_differ_by_level_and_edge
:figure: deboor_triangle

On the level and the edge the coefficients depend through the knots $t_i$ and $t_{i+k-r}$ and the weights: those of one $t$ may all be different,
`coefficients_differ_by_level_and_edge`, while over the knots of Bézier and with equal weights all are the same number.
With equal weights the coefficients are those of de Boor's algorithm, and conversely the edge $i$ of level $r$ is divided as without
weights only if $w_{i-1}^{[r-1]}=w_i^{[r-1]}$ or at its ends.
:::

:::{claim} weights_enter_the_coefficients
:title: The ratio of an edge is de Boor's ratio times the ratio of the weights
:zh: 割角比等于 deBoor 割角比乘以权因子之比
:given: $t$, the knots $t_i$ and $t_{i+k-r}$; the weights $v=w_{i-1}^{[r-1]}$, $w=w_i^{[r-1]}$ at the ends of the edge
:let: $a=(t-t_i)/(t_{i+k-r}-t_i)$, the coefficient of de Boor's algorithm; $\lambda=(t-t_i)w/[(t-t_i)w+(t_{i+k-r}-t)v]$, that of (4.1.4)
:then: $\frac\lambda{1-\lambda}=\frac a{1-a}\cdot\frac wv$, and $\lambda-a=a(1-a)(w-v)/(a\,w+(1-a)\,v)$
:method: $\lambda$ as the level of the kernel divides an edge of length 1; $t$, the knots, $v$ and $w$ variables.
:over: v w: weight; x#: knots
:where: no divisor is 0
:control: $v$ and $w$ exchanged
:::
*/
CLAIM(weights_enter_the_coefficients)
{
    num v = positive(T, "v", 0), w = positive(T, "w", 0), from = unknown(T, "x", 0), one = from_int(1);
#if FIELD
    num to = unknown(T, "x", 1), t = unknown(T, "t", 0);
#else
    num to = add(from, positive(T, "h", 1)), t = add(from, mul(sub(to, from), parameter(T, "t")));
#endif
    num a = div(sub(t, from), sub(to, from)), b = sub(one, a);
    num u[] = {sub(from, one), from, to, add(to, one)}, P[] = {from_int(0), one}, weights[] = {v, w};
    G(nurbs_deboor_level)(G(nurbs_on_span)(1, 1, u, 1, NULL, NULL), 1, P, weights, t);
    if (T->faulty) {
        num kept = v;
        v = w;
        w = kept;
    }
    /* λ/(1-λ) = a/(1-a) w/v, and λ - a = a (1-a) (w-v) / (a w + (1-a) v) */
    same(T, div(P[0], sub(one, P[0])), mul(div(a, b), div(w, v)));
    same(T, sub(P[0], a), div(mul(mul(a, b), sub(w, v)), add(mul(a, w), mul(b, v))));
}

#if RATIONAL
/*
:::{claim} coefficients_differ_by_level_and_edge
:title: The coefficients of one t may differ from level to level and from edge to edge
:zh: 割角系数可随层数与边序号而异
:kind: decision
:given: a quadratic segment over the knots $T$ with equal weights $w$; $t$ in its interval, so that $j=3$
:data: T = 1 2 3 4 5 6; w = 1 1 1; t = 7/2
:instead: T = 0 0 0 1 1 1; t = 1/2
:then: the three ratios $\lambda$ of (4.1.4), on the edges $i=2,3$ of level $1$ and $i=3$ of level $2$, are different
:result: λ = 3/4 1/4 1/2
:method: The ratio by its letter, each with each.
:control: the knots of Bézier, over which all three are one number
:::
*/
CLAIM(coefficients_differ_by_level_and_edge)
{
    static const int level[] = {1, 1, 2}, edge[] = {2, 3, 3};
    num u[6], w[3], ratio[3];
    given_points(T, "T", 6, 1, u);
    given_points(T, "w", 3, 1, w);
    num t = given(T, "t");
    for (int m = 0; m < 3; m++) {
        int r = level[m], i = edge[m];
        num second = mul(sub(t, u[i - 1]), G(printed_weight)(3, u, w, r - 1, i, t));
        num first = mul(sub(u[i + 3 - r - 1], t), G(printed_weight)(3, u, w, r - 1, i - 1, t));
        ratio[m] = div(second, add(first, second));
    }
    found_points(T, "λ", 3, 1, ratio);
    about(T, "no two of the ratios are equal");
    agree(T, compare_q(ratio[0], ratio[1]) != 0 && compare_q(ratio[0], ratio[2]) != 0 &&
                 compare_q(ratio[1], ratio[2]) != 0);
}
#endif

#include "chapters/judge/claims_off.h"
