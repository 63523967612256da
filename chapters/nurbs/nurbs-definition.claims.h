/*
# What a NURBS curve is (NURBS 曲线的一般定义)

Points, weights and knots make a curve: at $t$ point $r_i$ counts $N_{i,k}(t)\,w_i$ times, and the curve is the mean

$$r(t)=\sum_{i=1}^nN_{i,k}(t)\,w_ir_i\Big/\sum_{i=1}^nN_{i,k}(t)\,w_i,\qquad t_k\le t\le t_{n+1}.$$
*/
#include "chapters/nurbs/definition.h"
#include "chapters/nurbs/discrete.h"
#include "chapters/nurbs/patterns.h"

#include "chapters/judge/claims_on.h"

/*
## The definition

:::{statement} wang-ch4:def-4.1.1
:title: NURBS curve, control points and control polygon
:zh: NURBS 曲线、控制顶点与控制多边形
:definition: yes
:printed: Given, in homogeneous coordinates, $n$ points of $\Re^3$, $\tilde r_i=(w_ix_i,w_iy_i,w_iz_i,w_i)$, $w_i>0$, $i=1,2,\dots,n$, and a nonuniform
  partition $T=\{t_i\}_{i=-\infty}^\infty$ of the $t$-axis, $t_j\le t_{j+1}$, with the B-splines $N_{i,k}(t)$ of order $k$ of
  $T$: the rational parametric curve (4.1.1), $t_k\le t\le t_{n+1}$, $n\ge k$, is called the nonuniform rational B-spline curve of order $k$ (degree $k-1$) of the
  knot vector $T$, the $\tilde r_i$ are called its control points and
  $\tilde r_i\tilde r_2\cdots\tilde r_n$ its control polygon
:checked-by: basis_is_a_partition_of_unity nurbs_point_is_the_weighted_mean
:needs: negative_weight_makes_a_pole | definition 4.1.1: $w_i>0$ | the weights are positive: with a negative one the denominator
  may vanish
:reading: outer_knots_do_not_count | the partition is without end; $t_2,\dots,t_{n+k-1}$ are all that counts on the domain
:reading: control_point_of_space_is_not_enough | the points are points of space in homogeneous coordinates: the factor of the
  coordinates counts, so that a control point is a point together with its weight
:meant: the name control polygon of the $\tilde r_i$, $i=1,2,\dots,n$ | The polygon is $\tilde r_1\tilde r_2\cdots\tilde r_n$, see
  `def-4.1.1-polygon`.
:figure: nurbs_definition

For which knots the curve is there on the whole range of $t$, its right end included, is the matter of `def-4.1.1-interval`.
:::
*/

/* A parameter strictly inside the interval of a span. */
static num G(parameter_inside)(trial *T, const num u[], int mu)
{
    return add(u[mu], mul(sub(u[mu + 1], u[mu]), inside(T, "s")));
}

/*
A definition cannot be wrong, but it can define nothing. For a quotient to be a curve, its denominator must not vanish, and this
is where the condition $w_i>0$ comes from: a mean of positive numbers is positive, as long as the $N_{i,k}$ are the shares of a
mean.

:::{claim} basis_is_a_partition_of_unity
:title: On the domain the B-splines are nonnegative and sum up to 1, so positive weights have a positive mean
:zh: 定义域内 B 样条基非负且和为一,故分母为正
:given: several segments, with any positive gaps of the knots; any interval $[x_m,x_{m+1}]$ of the domain;
  $t=x_m+(x_{m+1}-x_m)\frac s{1+s}$, $s>0$, or $t=x_m$, or $t=x_{m+1}$, where the limit from the left is taken; and $t=t_{n+1}$ as a point of the
  interval behind it, as the definition has it, where there is one: unless $t_{n+1}=\dots=t_{n+k}$
:then: $N_{i,k}(t)\ge0$ for all $i$ and $\sum_{i=1}^nN_{i,k}(t)=1$; so the denominator of (4.1.2) is at least the least
  weight
:method: The recursion by its letter.  Signs are read off coefficients in $s$ and the gaps.
:degrees: 1..6 sampled 6
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:over: s: ratio in which t divides its interval; x: -
:control: the first of the points of the interval left out
:::
*/
/* No N_i is negative at t, a point of this interval, and they sum up to 1. */
static void G(compare_with_shares_at)(trial *T, const struct G(knot_vector) * K, int interval, num t)
{
    int first = G(span_of_interval)(K->count, K->place, interval) - K->p;
    num sum = from_int(0);
    for (int i = 0; i < K->n; i++) {
        num N = G(cox_de_boor)(K->p, K->u, K->place, i, interval, t);
        about(T, "the sign of N_i");
        nonnegative(T, N);
        if (fault(T, 1, i != first))
            sum = add(sum, N);
    }
    about(T, "the sum of the N_i");
    same(T, sum, from_int(1));
}

/* Over the knots K: in every interval of the domain and at its ends, and at the end of the domain by the interval behind it. */
static void G(compare_with_shares)(trial *T, const struct G(knot_vector) * K)
{
    const int behind = K->place[K->n];
    for (int interval = K->place[K->p]; interval < behind; interval += 2) {
        int mu = G(span_of_interval)(K->count, K->place, interval);
        G(compare_with_shares_at)(T, K, interval, G(parameter_inside)(T, K->u, mu));
        G(compare_with_shares_at)(T, K, interval, K->u[mu]);
        G(compare_with_shares_at)(T, K, interval, K->u[mu + 1]);
    }
    if (behind < K->place[K->count - 1])
        G(compare_with_shares_at)(T, K, behind, K->u[K->n]);
}

CLAIM(basis_is_a_partition_of_unity)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = FIELD && p > 4 ? INTEGERS : LENGTHS};
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K))
        G(compare_with_shares)(T, &K);
}

/*
:::{claim} basis_beside_a_too_multiple_knot_sums_to_one
:title: Beside a knot that is more than k-fold the B-splines are nonnegative and sum up to 1 as well
:zh: 超过 k 重的节点两侧 B 样条基仍非负且和为一
:given: a knot of multiplicity $k+1$ or $k+2$ between simple or clamped ends, with any positive gaps of the knots; both intervals of the domain;
  $t=x_m+(x_{m+1}-x_m)\frac s{1+s}$, $s>0$, or $t=x_m$, or $t=x_{m+1}$, where the limit from the left is taken; and $t=t_{n+1}$ as a point of the
  interval behind it, unless $t_{n+1}=\dots=t_{n+k}$
:then: $N_{i,k}(t)\ge0$ for all $i$ and $\sum_{i=1}^nN_{i,k}(t)=1$
:method: The recursion by its letter.  Signs are read off coefficients in $s$ and the gaps.
:degrees: 1..6 sampled 6
:scope: an inner knot of multiplicity k+1 or k+2 between simple and clamped ends; the distinct knots variables up to order 5, numbers above
:over: s: ratio in which t divides its interval; x: -
:control: the first of the points of the interval left out
:::
*/
CLAIM(basis_beside_a_too_multiple_knot_sums_to_one)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = FIELD && p > 4 ? INTEGERS : LENGTHS};
    for (int clamped = 0; clamped < 2; clamped++)
        for (int more = 1; more <= 2; more++) {
            char pattern[MOST_KNOTS];
            int many = clamped ? 1 : p + 1, at = 0;
            for (int end = 0; end < 2; end++) {
                for (int i = 0; i < many; i++)
                    pattern[at++] = (char)(clamped ? '1' + p : '1');
                if (end == 0)
                    pattern[at++] = (char)('1' + p + more);
            }
            pattern[at] = '\0';
            (void)G(knots_good)(T, p, pattern, &K); /* it is not, and the knots are there all the same */
            G(compare_with_shares)(T, &K);
        }
}

#if RATIONAL
/* The sum of all functions and, if there are weights, of their products, in the interval named. */
static num G(denominator)(int n, int p, const num u[], const int place[], const num w[], int interval, num t)
{
    num sum = from_int(0);
    for (int i = 0; i < n; i++) {
        num N = G(cox_de_boor)(p, u, place, i, interval, t);
        sum = add(sum, w != NULL ? mul(w[i], N) : N);
    }
    return sum;
}

/*
:::{claim} negative_weight_makes_a_pole
:title: With a negative weight the denominator may vanish
:zh: 权因子为负时分母可为零
:kind: counterexample
:given: the knots $T$ of one quadratic segment, weights $w$ of which one is negative, and $t$
:data: T = 0 0 0 1 1 1; w = 1 -1 1; t = 1/2
:instead: w = 1 1 1
:then: $w(t)=\sum_iN_{i,3}(t)\,w_i$ vanishes, so that (4.1.2) has a pole at $t$
:result: w(t) = 0
:method: The denominator of (4.1.2), all terms.
:control: all weights positive
:::
*/
CLAIM(negative_weight_makes_a_pole)
{
    num u[6], w[3];
    int place[6];
    G(given_knots)(T, "T", 6, u, place);
    given_points(T, "w", 3, 1, w);
    num total = G(denominator)(3, 2, u, place, w, 0, given(T, "t"));
    found(T, "w(t)", total);
    about(T, "the denominator is not zero");
    agree(T, sign_q(total) != 0);
}
#endif

/*
The partition is printed as a sequence without end, and then only $n$ functions of it are used. These have $n+k$ knots; on the
domain even the first and the last of these do not matter, since they enter only through functions of lower order that vanish
there. The matter is not idle: it decides what a program may ask for, and conventions differ by just these two knots.

:::{claim} outer_knots_do_not_count
:title: On the domain the curve does not depend on the first and the last knot, nor on any beyond
:zh: 首末两个节点不影响定义域内的曲线
:given: simple knots, their values variables; any $t$; every interval of the domain $[t_k,t_{n+1}]$, $n=k+1$
:then: $N_{i,k}$, $i=1,\dots,n$, stays the same when $t_1$ and $t_{n+k}$ are replaced by other numbers
:method: The recursion by its letter with both knots and with two other variables.  The $N_{i,k}$ with $1\le i\le n$ contain
  $t_1,\dots,t_{n+k}$ only.
:degrees: 1..6 sampled 6
:scope: simple knots
:over: y#: other outer knots
:control: the second knot replaced as well
:::
*/
CLAIM(outer_knots_do_not_count)
{
    int p = T->degree, count = 2 * p + 3, n = count - p - 1, place[MOST_KNOTS];
    num u[MOST_KNOTS], t = unknown(T, "t", 0);
    G(simple_knots)(T, count, 6, u, place);
    for (int interval = p; interval < n; interval++) {
        num before[MOST_KNOTS];
        for (int i = 0; i < n; i++)
            before[i] = G(cox_de_boor)(p, u, place, i, interval, t);
        num first = u[0], second = u[1], last = u[count - 1];
        u[0] = unknown(T, "y", 0);
        u[count - 1] = unknown(T, "y", 1);
        u[1] = fault(T, u[1], unknown(T, "y", 2));
        for (int i = 0; i < n; i++)
            same(T, G(cox_de_boor)(p, u, place, i, interval, t), before[i]);
        u[0] = first, u[1] = second, u[count - 1] = last;
    }
}

/*
:::{claim} control_point_of_space_is_not_enough
:title: The factor of a homogeneous point changes the curve
:zh: 齐次坐标的公因子影响曲线
:given: $k=2$ and any knots; the point $r_2$ of space given by homogeneous coordinates $(w_2r_2,w_2)$ and by
  $\lambda$ times these
:then: the curve changes with $\lambda$: its value at $\lambda$ minus that at $1$ is a product of
  $(\lambda-1)\,w_1w_2\,(r_2-r_1)$, of $N_{1,2}N_{2,2}$, and of the reciprocals of both denominators
:method: The curve from the definition on the span, everything a variable.
:scope: k = 2 on one span
:where: both denominators are not 0
:control: both points multiplied by $\lambda$
:::
*/
CLAIM(control_point_of_space_is_not_enough)
{
    num x[4], u[4], R[2], w[2], v[2], before, after, t = unknown(T, "t", 0), factor = positive(T, "lambda", 0);
    int place[4];
    G(distinct_knots)(T, 4, 6, x);
    G(knots_at)("1111", x, u, place);
    G(weighted_points)(T, 2, 1, R, w);
    v[0] = fault(T, w[0], mul(factor, w[0]));
    v[1] = mul(factor, w[1]);
    num total = G(nurbs_by_definition)(2, 1, 1, u, place, R, w, 1, t, &before);
    num other = G(nurbs_by_definition)(2, 1, 1, u, place, R, v, 1, t, &after);
    /* (λ-1) w_1 w_2 (r_2 - r_1) N_1 N_2 over both denominators */
    num shares = mul(G(cox_de_boor)(1, u, place, 0, 1, t), G(cox_de_boor)(1, u, place, 1, 1, t));
    num change = mul(mul(sub(factor, from_int(1)), mul(w[0], w[1])), mul(sub(R[1], R[0]), shares));
    same(T, sub(after, before), div(change, mul(total, other)));
}

/*
:::{statement} wang-ch4:def-4.1.1-polygon
:title: The first point of the control polygon
:zh: 控制多边形的首顶点
:printed: $\tilde r_i\tilde r_2\cdots\tilde r_n$ is the control polygon
:class: misprint
:refuted-by: polygon_begun_elsewhere_misses_the_start
:corrected: $\tilde r_1\tilde r_2\cdots\tilde r_n$
:corrected-by: leg_of_every_polygon_is_the_curve_of_order_two outer_functions_are_made_of_outer_ones
:confirmed-by: polygon_is_the_curve_of_order_two moved_point_changes_its_support clamped_end_is_the_first_point
:argued: every order | The control points are $\tilde r_1,\dots,\tilde r_n$ by the beginning of the sentence, and the polygon is that of definition 4.3.1, whose curve of
  order 2 is $r_1r_2\cdots r_n$ whatever the order of the curve that it controls.
:figure: polygon_begun_elsewhere
:::
*/

#if RATIONAL
/*
:::{claim} polygon_begun_elsewhere_misses_the_start
:title: A polygon that begins with another point than the first does not begin with the curve
:zh: 多边形首顶点有误时不含曲线起点
:kind: counterexample
:given: order two, knots $T$, points $r$, weights $w$, for which the curve is the polygon; and an index $i$
:data: T = 0 0 1 2 2; r = (0,0) (1,1) (2,0); w = 1 1 1; i = 2
:instead: i = 1
:then: $r_i$, in which the polygon $r_ir_2\cdots r_n$ begins, is not the beginning $r(t_k)$ of the curve
:result: r_i = (1,1); r(t_k) = (0,0)
:method: The point of the curve from the definition.
:control: the first point
:::
*/
CLAIM(polygon_begun_elsewhere_misses_the_start)
{
    num u[5], w[3], R[6], P[2];
    int place[5];
    G(given_knots)(T, "T", 5, u, place);
    given_points(T, "r", 3, 2, R);
    given_points(T, "w", 3, 1, w);
    const num *begins = R + 2 * (given_whole(T, "i") - 1);
    G(nurbs_by_definition)(3, 1, 2, u, place, R, w, 0, u[1], P);
    found_points(T, "r_i", 1, 2, begins);
    found_points(T, "r(t_k)", 1, 2, P);
    about(T, "the polygon begins where the curve begins");
    agree(T, equal_q(begins[0], P[0]) && equal_q(begins[1], P[1]));
}

/*
Half-open intervals are what makes the B-splines of a sequence without end sum to 1 at the knots, each value counted once. But a
curve ends, and at a $k$-fold last knot all of its functions have ended before. Every program repairs this, usually without a
word; the definition does not.

:::{statement} wang-ch4:def-4.1.1-interval
:title: The curve is defined for nondecreasing knots
:zh: 节点向量非减即可定义曲线
:printed: With $t_j\le t_{j+1}$, $n\ge k$ and nothing more about the knots the curve is given for $t_k\le t\le t_{n+1}$
:holds-by: basis_is_a_partition_of_unity
:confirmed-by: basis_beside_a_too_multiple_knot_sums_to_one
:needs: negative_weight_makes_a_pole | definition 4.1.1: $w_i>0$ | the weights are positive
:hypothesis: no_interval_no_curve | $t_k<t_{n+1}$: otherwise the domain is one value of $t$, at which every $N_{i,k}$,
  $1\le i\le n$, may be zero
:hypothesis: right_end_belongs_to_no_interval | at $t=t_{n+1}$ the limit from the left is meant, when
  $t_{n+1}=\dots=t_{n+k}$: by the half-open intervals of the definition of $N_{i,1}$ all $N_{i,k}$ are zero there
:figure: missing_end

Inside the domain a knot may be more than $k$-fold, too: beside $k+1$ or $k+2$ equal knots the $N_{i,k}$ sum up to 1 as well.
:::

:::{claim} no_interval_no_curve
:title: Without an interval all functions may vanish
:zh: 无非空区间时基函数可全为零
:kind: counterexample
:given: order and number of points two, knots $T$, which do not decrease; $t=t_k=t_{n+1}$ is the whole domain
:data: T = 1 1 1 1; t = 1
:instead: T = 0 0 2 2
:then: $N_{1,2}(t)+N_{2,2}(t)$ vanishes, taken from the left and taken from the right, so that (4.1.2) is $0/0$
:result: sum from the left = 0; sum from the right = 0
:method: The recursion by its letter for the interval before and for the interval after $t$.
:control: knots with an interval around $t$
:::
*/
CLAIM(no_interval_no_curve)
{
    num u[4];
    int place[4];
    G(given_knots)(T, "T", 4, u, place);
    num t = given(T, "t");
    num left = G(denominator)(2, 1, u, place, NULL, G(interval_before)(4, u, place, t), t);
    num right = G(denominator)(2, 1, u, place, NULL, G(interval_after)(4, u, place, t), t);
    found(T, "sum from the left", left);
    found(T, "sum from the right", right);
    about(T, "the denominator is not zero");
    refute(T, sign_q(left) <= 0 && sign_q(right) <= 0);
}

/*
:::{claim} right_end_belongs_to_no_interval
:title: At a k-fold right end all functions vanish by the letter of the definition
:zh: 右端为 k 重节点时按半开区间定义基函数全为零
:kind: counterexample
:given: a quadratic curve with $n$ points over the knots $T$, after whose last knot $t_{n+k}$ a larger one follows; $t=t_{n+1}$, which lies in
  $[t_j,t_{j+1})$ and in no interval before
:data: T = 0 0 0 1 2 2 2 3; n = 4; t = 2; j = 7
:instead: j = 4
:then: $\sum_{i=1}^nN_{i,3}(t)$ vanishes
:result: ΣN_i(t) = 0
:method: The recursion by its letter for the interval $[t_j,t_{j+1})$.
:control: the last interval of the domain, which gives the limit from the left
:::
*/
CLAIM(right_end_belongs_to_no_interval)
{
    num u[8];
    int place[8];
    G(given_knots)(T, "T", 8, u, place);
    int n = given_whole(T, "n");
    num t = given(T, "t");
    num sum = G(denominator)(n, 2, u, place, NULL, place[given_whole(T, "j") - 1], t);
    found(T, "ΣN_i(t)", sum);
    about(T, "the denominator is not zero");
    agree(T, sign_q(sum) > 0);
}
#endif

/*
:::{statement} wang-ch4:def-4.1.1-multiplicity
:title: Which control points have a share in the curve
:zh: 哪些控制顶点影响曲线
:definition: yes
:printed: $t_j\le t_{j+1}$, and the $\tilde r_i$ are called the control points of the curve
:checked-by: every_point_counts
:meant: the sentence, which gives a name | Nothing is said about a share in the curve; the readings say when the points that are called so have one.
:reading: too_multiple_knot_loses_a_point | knots of any multiplicity, and every point has a share: for $t_i=t_{i+k}$ the function
  $N_{i,k}$ is zero and $r_i$ has none
:reading: multiple_first_knot_loses_a_point | knots at most $k$-fold, and every point has a share: without $t_k<t_{k+1}$
  the support of the first function meets the domain in no interval
:reading: every_point_counts | with knots at most $k$-fold, $t_k<t_{k+1}$ and $t_n<t_{n+1}$ every point has a share
:figure: idle_point
:::
*/

#if FIELD || RATIONAL
/*
:::{claim} every_point_counts
:title: With knots at most k-fold, and the end knots of the domain not repeated inside, every point counts
:zh: 节点重数不超过阶数时各顶点均起作用
:types: field rational
:given: several segments over knots that are at most $k$-fold, with $t_k<t_{k+1}$, $t_n<t_{n+1}$, any positive gaps, any $t$ inside an interval of the
  domain
:then: $N_{i,k}(t)>0$ exactly if the interval is in $[t_i,t_{i+k})$, and every $i=1,\dots,n$ has such an interval
:method: The recursion by its letter; signs are read off coefficients in the gaps and in $s$, $t=x_m+(x_{m+1}-x_m)\frac s{1+s}$.
:degrees: 1..6 sampled 6
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:where: $t_k<t_{k+1}$ and $t_n<t_{n+1}$
:over: s: ratio in which t divides its interval; x: -
:control: $N_{i,k}$ compared with the support of $N_{i+1,k}$
:::
*/
CLAIM(every_point_counts)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = FIELD && p > 4 ? INTEGERS : LENGTHS};
    const int *place = K.place;
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        if (place[p] == place[p + 1] || place[K.n - 1] == place[K.n])
            continue;
        for (int i = 0; i < K.n; i++) {
            int counts = 0, shift = fault(T, 0, i + 1 < K.n);
            for (int interval = place[p]; interval < place[K.n]; interval += 2) {
                int mu = G(span_of_interval)(K.count, place, interval);
                num N = G(cox_de_boor)(p, K.u, place, i, interval, G(parameter_inside)(T, K.u, mu));
#if FIELD
                int positive_there = coefficients_sign_f(N) == 1;
#else
                int positive_there = sign_q(N) > 0;
#endif
                nonnegative(T, N);
                agree(T, positive_there == (place[i + shift] <= interval && interval < place[i + p + 1 + shift]));
                counts |= positive_there;
            }
            agree(T, counts);
        }
    }
}
#endif

#if RATIONAL
/* Whether N_{i,2} of the given knots, `count` of them, and of the given i is not 0 somewhere in the domain; its values in the middle of
 * the intervals are what is found. */
static int G(linear_function_counts)(trial *T, int count)
{
    num u[MOST_KNOTS], value[MOST_KNOTS];
    int place[MOST_KNOTS], n = count - 2, intervals = 0, counts = 0;
    G(given_knots)(T, "T", count, u, place);
    int i = given_whole(T, "i") - 1;
    for (int mu = 1; mu < n; mu++)
        if (place[mu] < place[mu + 1]) {
            num t = div(add(u[mu], u[mu + 1]), from_int(2));
            value[intervals] = G(cox_de_boor)(1, u, place, i, place[mu], t);
            counts |= sign_q(value[intervals++]) != 0;
        }
    found_points(T, "N_i in the middle of each", intervals, 1, value);
    about(T, "N_i is not zero somewhere in the domain");
    return counts;
}

/*
:::{claim} too_multiple_knot_loses_a_point
:title: Between k+1 equal knots a point has no share in the curve
:zh: k+1 个相等节点之间的控制顶点不起作用
:kind: counterexample
:given: order two and knots $T$ with $t_i=t_{i+k}$; all intervals of the domain
:data: T = 0 0 1 1 1 2 2; i = 3
:instead: T = 0 0 1/2 1 1 2 2
:then: $N_{i,2}$ vanishes in every interval
:result: N_i in the middle of each = 0 0
:method: The recursion by its letter in the middle of each interval; a nondecreasing sequence of knots would have to give every point
  a share.
:control: the first of the equal knots moved to the left
:::
*/
CLAIM(too_multiple_knot_loses_a_point) { agree(T, G(linear_function_counts)(T, 7)); }

/*
:::{claim} multiple_first_knot_loses_a_point
:title: A domain that begins with the first of two equal knots leaves the first point idle
:zh: 定义域左端为重节点之首时首顶点不起作用
:kind: counterexample
:given: order two and knots $T$ with $t_k=t_{k+1}$; all intervals of the domain, and the first point, $i=1$
:data: T = 0 1 1 2 3 4; i = 1
:instead: T = 0 1 2 2 3 4
:then: $N_{i,2}$, of support $[t_1,t_3]$, vanishes in every interval
:result: N_i in the middle of each = 0 0
:method: The recursion by its letter in the middle of each interval of the domain.
:control: the second of the equal knots moved to the right
:::
*/
CLAIM(multiple_first_knot_loses_a_point) { agree(T, G(linear_function_counts)(T, 6)); }
#endif

/*
## The two formulas (齐次表示与仿射表示)

:::{statement} wang-ch4:formula-4.1.1
:title: The curve in homogeneous coordinates
:zh: 齐次坐标下的表示
:definition: yes
:printed: \tilde r(t)=(X(t),Y(t),Z(t),w(t))=\sum_{i=1}^nN_{i,k}(t)\tilde r_i,\quad t_k\le t\le t_{n+1},\ n\ge k
:checked-by: nurbs_point_is_the_weighted_mean
:figure: nurbs_definition

This is a polynomial spline in four-dimensional space, whatever the weights are; the rational curve is its central projection, for which
$w(t)\ne0$ is needed.  What the range of $t$ asks for is the matter of `def-4.1.1-interval`.
:::

:::{statement} wang-ch4:formula-4.1.2
:title: The curve in affine coordinates
:zh: 仿射坐标下的表示
:printed: r(t)=(x(t),y(t),z(t))=\left(\frac{X(t)}{w(t)},\frac{Y(t)}{w(t)},\frac{Z(t)}{w(t)}\right)=\sum_{i=1}^nN_{i,k}(t)w_ir_i\Big/
  \sum_{i=1}^nN_{i,k}(t)w_i,\quad r_i=(x_i,y_i,z_i),\quad t_k\le t\le t_{n+1},\ n\ge k
:holds-by: nurbs_point_is_the_weighted_mean basis_is_a_partition_of_unity
:needs: negative_weight_makes_a_pole | definition 4.1.1: $w_i>0$ | the weights are positive
:figure: nurbs_definition

The equation of both forms is true wherever $w(t)\ne0$.  What the range of $t$ asks for is the matter of
`def-4.1.1-interval`: an interval that is not empty, and at its end the limit from the left.
:::

:::{claim} nurbs_point_is_the_weighted_mean
:title: A point of the curve is the mean of the points with weights N_i w_i
:zh: 曲线上的点是以 N_i w_i 为权的平均
:given: several segments, the distinct knots variables; weights and points; any interval of the domain, any $t$
:where: $w(t)\ne0$
:then: the projection of the homogeneous spline, computed on the span by de Boor's algorithm, is
  $\sum_{i=1}^nN_{i,k}(t)w_ir_i/\sum_{i=1}^nN_{i,k}(t)w_i$
:method: The kernel against all $n$ terms of the recursion by its letter.  The numerators are linear in the points, coordinate by
  coordinate.
:degrees: 1..6 sampled 6
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:defines: nurbs_homogenize nurbs_weight nurbs_point
:control: the last weight of the span increased by 1 for the kernel
:::
*/
CLAIM(nurbs_point_is_the_weighted_mean)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num R[3 * MOST_KNOTS], w[MOST_KNOTS], P[3], Q[3], t = unknown(T, "t", 0);
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        int dim = 1 + k % 3;
        const num *u = K.u;
        G(weighted_points)(T, K.n, dim, R, w);
        for (int interval = K.place[p]; interval < K.place[K.n]; interval += 2) {
            int mu = G(span_of_interval)(K.count, K.place, interval);
            num total = G(nurbs_by_definition)(K.n, p, dim, u, K.place, R, w, interval, t, P);
            num kept = w[mu];
            w[mu] = fault(T, kept, add(kept, from_int(1)));
            G(nurbs_point)(G(nurbs_on_span)(p, dim, u, mu, R, w), t, Q);
            for (int c = 0; c < dim; c++)
                same(T, Q[c], P[c]);
            about(T, "the denominator");
            same(T, G(nurbs_weight)(G(nurbs_on_span)(p, 0, u, mu, NULL, w), t), total);
            about(T, "the homogeneous points of the span");
            num H[4 * MOST_KNOTS];
            G(nurbs_homogenize)(G(nurbs_on_span)(p, dim, NULL, mu, R, w), H);
            for (int i = 0; i <= p; i++) {
                same(T, H[i * (dim + 1) + dim], w[mu - p + i]);
                for (int c = 0; c < dim; c++)
                    same(T, H[i * (dim + 1) + c], mul(w[mu - p + i], R[(mu - p + i) * dim + c]));
            }
            w[mu] = kept;
        }
    }
}

/*
## Degenerate cases (可退化性)

Two kinds of curves must come out as special cases, or the name would not be deserved. If all weights are equal they cancel
against the denominator, which is then this weight. The converse is a question of its own: points that depend on each other could
hide unequal weights, independent ones cannot.

:::{statement} wang-ch4:degenerate-bspline
:title: Equal weights give the B-spline curve
:zh: 权相等时退化为 B 样条曲线
:printed: For $w_1=w_2=\dots=w_n$ the curve (4.1.2) degenerates to the B-spline curve (2.2.1)
:holds-by: equal_weights_give_bspline
:reading: only_proportional_weights_give_the_bspline | as a criterion, span by span: no other weights of its $k$ points do, if these are affinely independent, or if $\sum N_{i,k}r_i$ is of no
  less than degree $k-1$ on it | The coefficients $N_{i,k}(w_i-w(t))$ sum up to 0, so that for affinely independent points each of them is 0; no $N_{i,k}$ of the span is 0, so every $w_i$ is $w(t)$, and all
  are equal.  In space more than 4 points are not: there the numerator, of
  degree $k-1$ at most, is $w(t)$ times a polynomial of degree $k-1$, so that $w(t)$ is constant, and the $N_{i,k}$ being linearly independent and of sum 1, every $w_i$ is this constant.
:meant: the words B-spline curve, as (2.2.1) is not in the text at hand | The curve (2.2.1) is $\sum_{i=1}^nN_{i,k}(t)r_i$.
:figure: nurbs_definition

At $t_{n+1}$ both are limits from the left, as `def-4.1.1-interval` says.
:::

:::{claim} equal_weights_give_bspline
:title: With equal weights the curve is the B-spline curve of its points
:zh: 权相等时为 B 样条曲线
:given: several segments, the distinct knots variables; one weight $w\ne0$, points; any interval and $t$
:then: $r(t)=\sum_{i=1}^nN_{i,k}(t)r_i$
:method: The rational curve by the kernel against the sum of all terms by the recursion.
:degrees: 1..6 sampled 6
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:where: the common weight is not 0
:over: w#: equal weights
:control: the weight of one point of the span doubled
:::
*/
CLAIM(equal_weights_give_bspline)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num R[MOST_KNOTS], w[MOST_KNOTS], P, t = unknown(T, "t", 0), same_weight;
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(weighted_points)(T, K.n, 1, R, w);
        same_weight = w[0];
        for (int interval = K.place[p]; interval < K.place[K.n]; interval += 2) {
            int mu = G(span_of_interval)(K.count, K.place, interval);
            for (int i = 0; i < K.n; i++)
                w[i] = fault(T, same_weight, i == mu ? add(same_weight, same_weight) : same_weight);
            G(nurbs_point)(G(nurbs_on_span)(p, 1, K.u, mu, R, w), t, &P);
            same(T, P, G(spline_value)(K.n, p, 1, K.u, K.place, R, 0, interval, t));
        }
    }
}

/*
:::{claim} only_proportional_weights_give_the_bspline
:title: For independent points the weights have to be equal
:zh: 顶点处于一般位置时权必须相等
:given: one span, the points $r_i$ independent variables, any weights
:then: the numerator of $r(t)-\sum N_{i,k}r_i$ has as coefficient of $r_i$ the number
  $N_{i,k}(t)\,(w_i-w(t))$; it vanishes for all $i$ and $t$ only if $w(t)$ is the constant $w_i$
:method: Homogeneous coordinates on a span with simple knots; the coefficients are found with the unit vectors as points.
:degrees: 1..6 sampled 8
:scope: one span of simple knots; the distinct knots variables up to order 5, numbers above
:where: $w(t)\ne0$
:control: the weight of one point doubled on one side
:::
*/
CLAIM(only_proportional_weights_give_the_bspline)
{
    int p = T->degree, count = 2 * p + 2, place[MOST_KNOTS];
    num u[MOST_KNOTS], R[MOST_KNOTS], w[MOST_KNOTS], P, t = unknown(T, "t", 0);
    G(simple_knots)(T, count, 4, u, place);
    G(weighted_points)(T, p + 1, 1, R, w);
    num N[MOST_KNOTS];
    for (int i = 0; i <= p; i++)
        N[i] = G(cox_de_boor)(p, u, place, i, p, t);
    for (int i = 0; i <= p; i++) {
        for (int k = 0; k <= p; k++)
            R[k] = from_int(k == i);
        num total = G(nurbs_of_basis)(p + 1, 1, N, R, w, &P);
        num weight = fault(T, w[i], i == p ? add(w[i], w[i]) : w[i]);
        same(T, mul(total, sub(P, N[i])), mul(N[i], sub(weight, total))); /* N_i (w_i - w(t)) */
    }
}

/*
The other special case is one single segment. Over knots that are $(k-1)$-fold at both ends the B-splines are the Bernstein
polynomials, so that points and weights keep their meaning. Over any other knots the segment is a rational Bézier curve as well,
but of other points; the star in the printed formula leaves open which is meant.

:::{statement} wang-ch4:degenerate-bezier
:title: n = k and (k-1)-fold ends give the rational Bézier curve
:zh: n=k 且两端为 k-1 重节点时退化为有理 Bézier 曲线
:printed: For $n=k$, $t_2=t_3=\dots=t_k<t_{k+1}=t_{k+2}=\dots=t_{2k-1}$ the curve (4.1.2) degenerates to the rational Bézier curve of
  degree $k-1$,
  $r(t)=\sum_{i=1}^kB_{i-1}^{k-1}[(t-t_k)/(t_{k+1}-t_k)]\,w_i^*r_i^*\Big/\sum_{i=1}^kB_{i-1}^{k-1}[(t-t_k)/(t_{k+1}-t_k)]\,w_i^*$,
  $t_k\le t\le t_{k+1}$
:holds-by: bezier_knots_give_rational_bezier
:meant: the range $t_k\le t\le t_{k+1}$, which is printed closed | At $t=t_{k+1}$ the limit from the left, as `def-4.1.1-interval` says
  once for all curves; and the starred data are the given ones, since the sentence is about a special case of (4.1.2).
:reading: bezier_knots_give_rational_bezier | the starred data are the given ones, $w_i^*=w_i$ and $r_i^*=r_i$, and the star is
  idle
:reading: bezier_end_belongs_to_no_interval | at $t=t_{k+1}$ by the letter of the half-open intervals, when $t_{2k}=t_{k+1}$:
  all $N_{i,k}$ are $0$ there, while the Bernstein polynomials are not
:reading: segment_of_any_knots_is_rational_bezier | the starred data are the Bézier points and weights of the segment, made of the given ones in homogeneous
  coordinates: over simple knots and for $k\ge3$ they may be others, over the knots of the line they are the given ones
:needs: simple_start_needs_another_point | the line itself: $t_2=\dots=t_k$ | $t_2=\dots=t_k$: otherwise the curve may begin in another point than $r_1$
:needs: simple_end_needs_another_point | the line itself: $t_{k+1}=\dots=t_{2k-1}$ | the knots $t_{k+1},\dots,t_{2k-1}$ are equal: otherwise the curve may end in another point than $r_k$
:needs: no_interval_no_curve | the line itself: $t_k<t_{k+1}$ | $t_k<t_{k+1}$: otherwise the divisor $t_{k+1}-t_k$ is $0$, and the curve may not exist
:confirmed-by: moved_point_changes_its_support
:figure: bezier_knots

The equation on $[t_k,t_{k+1}]$ does not need $n=k$, as $r_{k+1},\dots,r_n$ have no share there: `moved_point_changes_its_support`.  For $n=k$ this interval is the whole domain.
:::

:::{claim} bezier_knots_give_rational_bezier
:title: Over (k-1)-fold knots the curve is the rational Bézier curve of its points and weights
:zh: 两端 k-1 重节点时即为以原顶点与权因子的有理 Bézier 曲线
:given: $n=k$, knots $x_0,x_1^{k-1},x_2^{k-1},x_3$, values variables, also with $x_0=x_1$, with $x_2=x_3$ and with both; weights and points; any $t$
:then: $r(t)$ is the rational Bézier curve of $r_1,\dots,r_k$ and $w_1,\dots,w_k$ at $(t-t_k)/(t_{k+1}-t_k)$
:method: The curve from the definition against the kernel for rational Bézier curves.
:degrees: 1..6 sampled 9
:scope: one segment between (k-1)-fold knots
:where: $w(t)\ne0$
:control: the weights taken in the opposite order
:::
*/
CLAIM(bezier_knots_give_rational_bezier)
{
    int p = T->degree, place[MOST_KNOTS];
    num x[4], u[MOST_KNOTS], R[2 * MOST_KNOTS], w[MOST_KNOTS], v[MOST_KNOTS], P[2], Q[2], t = unknown(T, "t", 0);
    G(distinct_knots)(T, 4, 6, x);
    G(weighted_points)(T, p + 1, 2, R, w);
    for (int i = 0; i <= p; i++)
        v[i] = w[fault(T, i, p - i)];
    G(rational_point)(p, 2, R, v, div(sub(t, x[1]), sub(x[2], x[1])), Q);
    for (int joined = 0; joined < 4; joined++) { /* whether t_1 = t_2, and whether t_2k-1 = t_2k */
        int left = joined % 2, right = joined / 2;
        char pattern[] = {(char)('1' - left), (char)('0' + p + left), (char)('0' + p + right), (char)('1' - right),
                          '\0'};
        G(knots_at)(pattern, x, u, place);
        G(nurbs_by_definition)(p + 1, p, 2, u, place, R, w, 1, t, P);
        for (int c = 0; c < 2; c++)
            same(T, P[c], Q[c]);
    }
}

/*
:::{claim} segment_of_any_knots_is_rational_bezier
:title: A segment is a rational Bézier curve, over simple knots of other points and weights
:zh: 一段为有理 Bézier 曲线,单节点时顶点与权因子不同
:given: simple knots, or $x_0,x_1^{k-1},x_2^{k-1},x_3$, values variables; weights and points; the interval $[t_k,t_{k+1}]$
:then: the segment is the rational Bézier curve of the points and weights of `bspline_to_bezier` in homogeneous coordinates; over
  $x_0,x_1^{k-1},x_2^{k-1},x_3$ these are the given ones
:method: Both sides in homogeneous coordinates at a variable $t$: numerator and weight are linear, one coordinate stands for all.
:degrees: 1..6 sampled 7
:scope: one span of simple knots, or between (k-1)-fold ones; the distinct knots variables up to order 5, numbers above
:control: the given points in the place of the new ones
:::
*/
CLAIM(segment_of_any_knots_is_rational_bezier)
{
    int p = T->degree, count = 2 * p + 2, place[MOST_KNOTS];
    num u[MOST_KNOTS], H[MOST_KNOTS], b[MOST_KNOTS], value, t = unknown(T, "t", 0);
    G(simple_knots)(T, count, 4, u, place);
    for (int i = 0; i <= p; i++)
        H[i] = unknown(T, "H", i);
    G(bspline_to_bezier)(G(on_span)(p, 1, u, p, H), b);
    G(bezier_casteljau)(p, 1, fault(T, b, H), div(sub(t, u[p]), sub(u[p + 1], u[p])), &value);
    about(T, "the segment over simple knots");
    same(T, value, G(spline_value)(p + 1, p, 1, u, place, H, 0, p, t));
    char pattern[] = {'1', (char)('0' + p), (char)('0' + p), '1', '\0'};
    num x[4] = {u[0], u[1], u[2], u[3]};
    (void)G(knots_at)(pattern, x, u, place);
    G(bspline_to_bezier)(G(on_span)(p, 1, u, p, H), b);
    G(bezier_casteljau)(p, 1, b, div(sub(t, u[p]), sub(u[p + 1], u[p])), &value);
    about(T, "the segment between (k-1)-fold knots");
    same(T, value, G(spline_value)(p + 1, p, 1, u, place, H, 0, 1, t));
    about(T, "the points between (k-1)-fold knots");
    for (int i = 0; i <= p; i++)
        same(T, b[i], H[i]);
}

#if RATIONAL
/*
:::{claim} bezier_end_belongs_to_no_interval
:title: At the end of k-fold Bézier knots the quotient by B-splines is 0/0
:zh: 右端 k 重时按半开区间 Bézier 终点无定义
:kind: counterexample
:given: a quadratic segment over the knots $T$ of Bézier, after which a larger one follows; $t=t_{k+1}$, which lies in the interval up to
  that knot and in no interval before
:data: T = 0 0 0 1 1 1 2; t = 1
:instead: T = 0 0 0 1 1 2 2
:then: the sum of the $N_{i,3}(t)$ vanishes, while that of the $B_{i-1}^2(1)$ does not
:result: ΣN_i(t) = 0; ΣB_i(1) = 1
:method: The recursion by its letter for the interval that begins with $t$; the Bernstein polynomials of the kernel.
:control: $t_{2k}$ greater than $t_{k+1}$
:::
*/
CLAIM(bezier_end_belongs_to_no_interval)
{
    num u[7], B[3], sum = from_int(0);
    int place[7];
    G(given_knots)(T, "T", 7, u, place);
    num t = given(T, "t"), total = G(denominator)(3, 2, u, place, NULL, G(interval_after)(7, u, place, t), t);
    G(bernstein_basis)(2, from_int(1), B);
    for (int i = 0; i < 3; i++)
        sum = add(sum, B[i]);
    found(T, "ΣN_i(t)", total);
    found(T, "ΣB_i(1)", sum);
    about(T, "the sum of the B-splines and that of the Bernstein polynomials");
    same(T, total, sum);
}

/*
:::{claim} simple_knots_need_other_points
:title: Over simple knots the given points are not the Bézier points
:zh: 单节点时原顶点不是 Bézier 顶点
:kind: counterexample
:given: a quadratic segment of the points $r$ and weights $w$ over the simple knots $T$
:data: T = -2 -1 0 1 2 3; r = (0,0) (1,2) (2,0); w = 1 1 1
:instead: T = -2 0 0 1 1 3
:then: the segment begins in $r(t_k)$, the rational Bézier curve of the same data in its first point
:result: r(t_k) = (1/2,1); rational Bézier curve at 0 = (0,0)
:method: Both are computed exactly.
:control: the knots of the condition
:::
*/
CLAIM(simple_knots_need_other_points)
{
    num u[6], R[6], w[3], P[2], Q[2];
    given_points(T, "T", 6, 1, u);
    given_points(T, "r", 3, 2, R);
    given_points(T, "w", 3, 1, w);
    G(nurbs_point)(G(nurbs_on_span)(2, 2, u, 2, R, w), u[2], P);
    G(rational_point)(2, 2, R, w, from_int(0), Q);
    found_points(T, "r(t_k)", 1, 2, P);
    found_points(T, "rational Bézier curve at 0", 1, 2, Q);
    about(T, "the first and the second coordinate");
    same(T, P[0], Q[0]);
    same(T, P[1], Q[1]);
}

/*
:::{claim} simple_start_needs_another_point
:title: Where only the end of the domain is a multiple knot the curve begins in another point
:zh: 仅右端为重节点时曲线不始于首顶点
:kind: counterexample
:given: a quadratic segment of the points $r$ and weights $w$ over the knots $T$, with $t_2<t_3$ and $t_4=t_5$
:data: T = -2 -1 0 1 1 3; r = (0,0) (1,2) (2,0); w = 1 1 1
:instead: T = -2 0 0 1 1 3
:then: the segment begins in $r(t_3)$, the rational Bézier curve of the same data in $r_1$
:result: r(t_3) = (1/2,1); rational Bézier curve at 0 = (0,0)
:method: Both are computed exactly.
:control: the knots of the condition
:::
*/
/* One end of the given quadratic segment against that of the rational Bézier curve of the same data. */
static void G(compare_an_end)(trial *T, int last, const char *end, const char *bezier_end)
{
    num u[6], R[6], w[3], P[2], Q[2];
    given_points(T, "T", 6, 1, u);
    given_points(T, "r", 3, 2, R);
    given_points(T, "w", 3, 1, w);
    G(nurbs_point)(G(nurbs_on_span)(2, 2, u, 2, R, w), u[2 + last], P);
    G(rational_point)(2, 2, R, w, from_int(last), Q);
    found_points(T, end, 1, 2, P);
    found_points(T, bezier_end, 1, 2, Q);
    about(T, "the first and the second coordinate");
    same(T, P[0], Q[0]);
    same(T, P[1], Q[1]);
}

CLAIM(simple_start_needs_another_point) { G(compare_an_end)(T, 0, "r(t_3)", "rational Bézier curve at 0"); }

/*
:::{claim} simple_end_needs_another_point
:title: Where only the beginning of the domain is a multiple knot the curve ends in another point
:zh: 仅左端为重节点时曲线不止于末顶点
:kind: counterexample
:given: a quadratic segment of the points $r$ and weights $w$ over the knots $T$, with $t_2=t_3$ and $t_4<t_5$
:data: T = -2 0 0 1 2 3; r = (0,0) (1,2) (2,0); w = 1 1 1
:instead: T = -2 0 0 1 1 3
:then: the segment ends in $r(t_4)$, the rational Bézier curve of the same data in $r_3$
:result: r(t_4) = (3/2,1); rational Bézier curve at 1 = (2,0)
:method: Both are computed exactly.
:control: the knots of the condition
:::
*/
CLAIM(simple_end_needs_another_point) { G(compare_an_end)(T, 1, "r(t_4)", "rational Bézier curve at 1"); }
#endif

#include "chapters/judge/claims_off.h"
