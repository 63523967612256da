/*
# A convex polygon has a convex curve (曲线的保凸性)

The source lets the polygons converge.  There is a way without a limit: if three parameters are inserted until the points of the curve
there are vertices, the formula for the triangles holds for any three points of the curve.  The steps that the source takes are decided
all the same: the hulls must be those of a growing sequence of knots, and a limit of convex polygons need not be run through once.
*/
#include "chapters/nurbs/convexity.h"
#include "chapters/nurbs/discrete.h"

#include <stdio.h>

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch4:thm-4.2.1
:title: A convex polygon has a convex NURBS curve
:zh: NURBS 曲线的保凸性
:printed: if the control polygon $\Gamma_k^{(T)}(\Phi)$ is a plane convex curve, then the plane NURBS curve that belongs to it is a
  convex curve
:holds-by: insertion_turns_like_its_triangles triangles_of_one_sign_make_a_polygon_convex
  inserted_parameters_become_vertices insertion_ratios_are_between_zero_and_one inserted_points_divide_the_edges
:hypothesis: curve_of_a_polygon_that_turns_back_is_not_convex | the polygon runs through part of the boundary of a convex set once
:hypothesis: knot_of_full_multiplicity_tears_the_curve | no knot inside the domain has multiplicity $k$ or more, or the points there
  coincide; else the curve is not continuous
:confirmed-by: periodic_curves_of_convex_polygons_are_convex
:needs: mixed_weights_bend_both_ways | definition 4.1.1: $w_i>0$ | the weights are positive
:meant: the sentence, which goes from the polygon to the curve | From the polygon to the curve, not back.
:reading: curve_may_be_convex_alone | from the polygon to the curve only: the converse, which is not printed, fails
:argued: | Insert three parameters $k-1$ times each: the three points of the curve are vertices, and they turn as
  the polygon does; the start $t_1=t_k$ and knots that are $k$-fold are not inserted, where the point of the curve is a vertex already.  So any finitely many points of the curve are, in their order, a convex polygon, unless they are on a line, and none is inside their hull; a point
  inside the hull of the curve would be inside that of finitely many.  If all turns are $0$, the curve is on a line, and so are the points whose B-splines are not $0$ on the
  domain, as these are linearly independent there; this part of the polygon goes straight on, and so does each polygon with parameters inserted, whose new vertices are on
  the edges before, one on each and in their order: three points of the curve, being vertices, follow one another on the line.
:figure: convex_polygon_convex_spline
:::

:::{claim} inserted_parameters_become_vertices
:title: Points of the curve become vertices
:zh: 曲线上的点成为顶点
:given: orders $k=2,\dots,6$; ends of multiplicity $k$ and a knot between of multiplicity $1,\dots,k$, and for $k\le4$ every pattern of $2k+1$ knots, none more than $k$-fold;
  two parameters of the domain behind $t_1$, in their order $t'_1$ and $t'_2$, each inserted $k-1$ times: both in one interval, in different ones, at knots that are not $k$-fold, at a $k$-fold right end
:then: $r(t'_1)$ is the vertex number $\mu_1$ and $r(t'_2)$ the vertex number $\mu_2+k-1$, where $t'_l\in(t_{\mu_l},t_{\mu_l+1}]$; and so for
  the points (4.1.6), if no parameter is a $k$-fold right end
:method: The printed insertions, (4.1.6) by its letter, intervals closed on the left, and the curve by its definition, knots, parameters and points variables; a
  coordinate of the homogeneous points is any coordinate.
:degrees: k = 2..6 sampled 6
:argued: every number of parameters, every order and all knots | In homogeneous coordinates point $i$ is the polar form of the curve at $t_{i+1},\dots,t_{i+k-1}$, before an insertion and
  after it; when these are $t'$ alone it is the point of the curve.  Later parameters leave it alone.
:scope: clamped ends with one knot of every multiplicity between, and every pattern of 2k+1 at most k-fold knots up to order 4
:control: the second vertex counted one too low
:::
*/
/* Inserts the parameters at two places, in increasing order, k-1 times each, and compares the vertices with the curve. */
static void G(compare_vertices)(trial *T, int k, const struct G(knot_vector) * old, const int place[2])
{
    struct G(knot_vector) K = *old, V;
    int n = K.count - k, size = n, at_the_end = place[1] == K.place[K.count];
    num tau[2], c[MOST_POINTS], w[MOST_POINTS], d[MOST_POINTS], z[MOST_POINTS];
    tau[0] = G(number_at)(T, &K, place[0], "tau");
    tau[1] = G(number_at)(T, &K, place[1], "sigma");
    for (int i = 1; i <= n; i++)
        d[i] = c[i] = unknown(T, "c", i);
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
        int mu = G(left_of)(old, place[j]), interval = old->place[mu], vertex = mu + j * fault(T, k - 1, k - 2);
        num value = G(spline_value)(n, k - 1, 1, old->t + 1, old->place + 1, c + 1, 0, interval, tau[j]);
        about(T, "the vertex by the printed insertions");
        same(T, d[vertex], value);
        num sum = from_int(0);
        for (int i = 1; i <= n && !at_the_end; i++)
            sum = add(sum,
                      mul(c[i], G(alpha)(k - 1, old->t + 1, old->place + 1, K.t + 1, K.place + 1, i - 1, vertex - 1)));
        about(T, "the vertex (4.1.6)");
        if (!at_the_end)
            same(T, sum, value);
    }
}

/* May a parameter at this place be inserted?  Behind t_1, and at no k-fold knot but the last. */
static int G(may_be_inserted)(int k, const struct G(knot_vector) * K, int place)
{
    int times = 0;
    for (int i = 1; i <= K->count; i++)
        times += K->place[i] == place;
    return place > K->place[1] && (times < k || place == K->place[K->count]);
}

CLAIM(inserted_parameters_become_vertices)
{
    int k = T->degree;
    char pattern[MOST_KNOTS];
    for (int m = k <= ALL_PATTERNS ? 0 : 1, next; (next = G(pattern_of_insertion)(k, m, pattern)) > 0; m = next) {
        struct G(knot_vector) K = G(pattern)(T, pattern);
        int n = K.count - k;
        for (int first = K.place[k]; first <= K.place[n + 1]; first += 2) /* knots, and numbers between */
            for (int second = first + (first % 4 != 0 ? 1 : 2); second <= K.place[n + 1]; second += 2 - second % 2)
                if (G(may_be_inserted)(k, &K, first) && G(may_be_inserted)(k, &K, second))
                    G(compare_vertices)(T, k, &K, (int[]){first, second});
    }
}

/*
A parameter may be a knot already, and inserted $k-1$ times it may become more than $k$-fold. Such knots are no new case: all but $k$ of
the equal ones only leave out points that had no share, and repeat new points.

:::{claim} knots_above_k_fold_repeat_new_points
:title: Knots that are more than k-fold leave out points without a share and repeat new points
:zh: 超过 k 重的节点只丢失无份额的顶点、重复新顶点
:given: both ends of multiplicity $k$ and one knot between, of any multiplicity $1,\dots,k$; for $k\le4$ every pattern of $2k+1$ knots, too, none more than $k$-fold; one or more of their
  $k$-fold knots, but not the last knot, are made $(k+q)$-fold, $q=1,2$; $\tau$ inside any interval between $t_1$ and $t_{n+k}$, or any knot there, or $t_1$ if it is $k$-fold
:then: $\alpha_{i,k}^{(T,\{\tau\})}(j)$ is $0$ for $t_i=t_{i+k}$, the first $q$ of the $k+q$ equal knots; the others are those of the vector in which these $q$ knots are left out, and each of the
  $q$ new points that belong to them repeats the next one
:method: The recursion of the discrete B-splines by its letter, intervals closed on the left, for both vectors of knots.  The reason: $\alpha_{i,k}(j)$ is made of $t_i,\dots,t_{i+k}$ and of the knots
  $j,\dots,j+k-1$ of $T\oplus T'$ alone, and one of more than $k$ equal knots left out takes with it one $i$ with $t_i=t_{i+k}$ and one $j$ whose $k$ knots are those of the next.
:degrees: k = 2..6 sampled 6
:scope: k-fold knots but the last made (k+1)- or (k+2)-fold, in every pattern of 2k+1 at most k-fold knots up to order 4 and between clamped ends; the distinct knots variables up to order 5, numbers above
:control: the repeated points counted one too few
:::
*/
/* K with q more of each of its knots that are k-fold and marked; extra says which knots are more, the first of the equal ones. */
static struct G(knot_vector) G(raised)(int k, const struct G(knot_vector) * K, int marked, int q, int extra[])
{
    struct G(knot_vector) L = {.count = 0};
    int seen = 0;
    for (int s = 1; s <= K->count; s++) {
        int starts = s + k - 1 <= K->count && K->place[s] == K->place[s + k - 1] && K->place[s] < K->place[K->count];
        for (int more = starts && marked >> seen & 1 ? q : 0; more >= 0; more--) {
            L.count++;
            L.t[L.count] = K->t[s];
            L.place[L.count] = K->place[s];
            extra[L.count] = more > 0;
        }
        seen += starts;
    }
    return L;
}

/* The knots with tau after those up to it; the marks with them. */
static struct G(knot_vector)
    G(with_knot_at)(const struct G(knot_vector) * K, int place, num tau, const int old[], int extra[])
{
    struct G(knot_vector) V = {.count = K->count + 1};
    int mu = 0;
    while (mu < K->count && K->place[mu + 1] <= place)
        mu++;
    for (int i = 1; i <= V.count; i++) {
        V.t[i] = i <= mu ? K->t[i] : i == mu + 1 ? tau : K->t[i - 1];
        V.place[i] = i <= mu ? K->place[i] : i == mu + 1 ? place : K->place[i - 1];
        extra[i] = old != NULL && i != mu + 1 && old[i <= mu ? i : i - 1];
    }
    return V;
}

static void G(compare_with_fewer_knots)(trial *T, int k, const struct G(knot_vector) * K,
                                        const struct G(knot_vector) * L, const int extra[], int place, num tau)
{
    int none[MOST_KNOTS], more[MOST_KNOTS];
    struct G(knot_vector) V = G(with_knot_at)(K, place, tau, NULL, none),
                          W = G(with_knot_at)(L, place, tau, extra, more);
    for (int j = 1, at = fault(T, 1, 0); j <= W.count - k;
         at += !more[j], j++) /* at: j without the knots that are more */
        for (int i = 1, from = 1; i <= L->count - k; from += !extra[i], i++) {
            num share = G(alpha)(k - 1, L->t + 1, L->place + 1, W.t + 1, W.place + 1, i - 1, j - 1);
            if (extra[i])
                same(T, share, from_int(0));
            else if (at > 0)
                same(T, share, G(alpha)(k - 1, K->t + 1, K->place + 1, V.t + 1, V.place + 1, from - 1, at - 1));
        }
}

CLAIM(knots_above_k_fold_repeat_new_points)
{
    int k = T->degree;
    char pattern[MOST_KNOTS];
    for (int m = 1, next; (next = G(pattern_of_insertion)(k, m, pattern)) > 0; m = next) {
        struct G(knot_vector) K = G(pattern)(T, pattern);
        int full = 0, extra[MOST_KNOTS];
        G(numbers_for_knots)(k, &K);
        for (int s = 1; s + k - 1 < K.count; s++)
            full += K.place[s] == K.place[s + k - 1] && K.place[s] < K.place[K.count];
        for (int marked = 1; marked < 1 << full; marked++)
            for (int q = 1; q <= 2; q++) {
                struct G(knot_vector) L = G(raised)(k, &K, marked, q, extra);
                for (int place = K.place[1] + (K.place[1] < K.place[k] ? 2 : 0); place < K.place[K.count]; place += 2)
                    G(compare_with_fewer_knots)(T, k, &K, &L, extra, place, G(number_at)(T, &K, place, "tau"));
            }
    }
}

#if RATIONAL
/*
The three conditions are tried by leaving them out. A polygon that is convex as a set only: the curve of the example of the last
section but one has a point inside the triangle of three others. A $k$-fold knot: two opposite sides of a square are a curve that
is not continuous. A negative weight: the curve of a convex polygon gets an inflection, although its denominator stays positive.

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
        G(nurbs_point)(G(nurbs_on_span)(2, 2, t + 1, span_of(4, 3, t, at[m]), r + 2, w + 1), at[m], P[m]);
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
    G(nurbs_point)(G(nurbs_on_span)(1, 2, t + 1, place_of(6, t, knot) - 1, r + 2, w + 1), knot, left);
    G(nurbs_point)(G(nurbs_on_span)(1, 2, t + 1, span_of(4, 2, t, knot), r + 2, w + 1), knot, right);
    found_points(T, "r(t-)", 1, 2, left);
    found_points(T, "r(t+)", 1, 2, right);
    about(T, "the polygon being convex, the curve is continuous at t");
    refute(T, polygon_is_convex(3, r + 2, 1, NULL) && (!equal_q(left[0], right[0]) || !equal_q(left[1], right[1])));
}

/* det(P, P', P'') on the interval that begins with knot mu, which is not empty; u and R from 0. */
static poly turning_of_span(int p, const num_q u[], int mu, const num_q R[], const num_q w[], poly *weight)
{
    num_q H[MOST_COORDINATES], b[MOST_COORDINATES], one[MAX_DEGREE + 1];
    nurbs_homogenize_q(nurbs_on_span_q(p, 2, NULL, mu, R, w), H + 3 * (mu - p));
    bspline_to_bezier_q(on_span_q(p, 3, u, mu, H), b);
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
:let: $P=(wx,wy,w)$, the curve in homogeneous coordinates
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
The proof of the source intersects the hulls of the polygons. This is right for a growing sequence of knots, where each hull
contains the next; the letters that stand for its members in one place are those of two parts of one set, which do not contain one
another.

:::{statement} wang-ch4:thm-4.2.1-step-intersection
:title: The hulls of a growing sequence of knots
:zh: 凸包之交
:printed: for the sequence of corollary 4.1.1, by lemma 4.2.1: $A(\Gamma_k^{(T)}(T_m'))=\bigcap_{i=1}^mA(\Gamma_k^{(T)}(T_i'))$
:holds-by: inserted_points_divide_the_edges insertion_ratios_are_between_zero_and_one printed_factors_are_the_discrete_shares
  clamped_start_inserted_again_repeats_the_first_point steps_of_refinement_compose weights_of_both_steps_are_positive knots_above_k_fold_repeat_new_points
:needs: mixed_weights_cut_beside_the_edges | definition 4.1.1: $w_i>0$ | the weights are positive
:hypothesis: polygon_that_turns_back_loses_convexity | the polygon runs through its points once: as for the lemma; else the $A$
  of a refined polygon need not exist; or $A$ is taken as the hull
:hypothesis: end_of_more_than_k_knots_has_no_shares | $t_n<t_{n+k}$: for (4.1.6)
:needs: hulls_of_unrelated_knots_are_not_nested | corollary 4.1.1: $T'_m\subseteq T'_{m+1}$ | the sets of knots
  increase
:argued: | One knot after another gives $T'_{i+1}$ from $T'_i$, by (4.1.7), and each makes the hull smaller or leaves it: the identities of one insertion have the
  knots as variables, and hold for equal ones, too, where they divide by no 0; where a knot is more than $k$-fold, points without a share are left out.  In a decreasing
  sequence of sets the intersection of the first $m$ is the last.
:figure: hulls_of_knot_sets

The knots of corollary 4.1.1 may be taken in $(t_1,t_{n+k})$, where (4.1.6) gives every new point.
:::

:::{statement} wang-ch4:thm-4.2.1-step-nested
:title: The sets of knots in the intersection
:zh: T_i 应为 T'_i
:printed: $T_{i+1}\supseteq T_i$, where the $A(\Gamma_k^{(T)}(T_i))$ are plane convex closed sets, $i=1,2,\dots,m$
:class: misprint
:refuted-by: hulls_of_unrelated_knots_are_not_nested
:corrected: $T'_{i+1}\supseteq T'_i$, and the $A(\Gamma_k^{(T)}(T'_i))$ decrease, for knots in $(t_1,t_{n+k})$, a $t_{n+k}$ that is at most $k$-fold, and a polygon that runs through its points once, or with the hulls for the $A$
:corrected-by: inserted_points_divide_the_edges insertion_ratios_are_between_zero_and_one printed_factors_are_the_discrete_shares
  clamped_start_inserted_again_repeats_the_first_point steps_of_refinement_compose weights_of_both_steps_are_positive knots_above_k_fold_repeat_new_points
:needs: mixed_weights_cut_beside_the_edges | definition 4.1.1: $w_i>0$ | the weights are positive
:argued: | One knot after another gives $T'_{i+1}$ from $T'_i$, by (4.1.7), and each makes the hull smaller or leaves it: the identities of one insertion have the
  knots as variables, and hold for equal ones, too, where they divide by no 0; where a knot is more than $k$-fold, points without a share are left out.
:figure: hulls_of_knot_sets

$T_1$ and $T_2$ are in theorem 4.1.1 the two parts of one set of knots, and need not contain one another; the sequence of
corollary 4.1.1 is that of the $T'_m$.
:::

:::{statement} wang-ch4:thm-4.2.1-step-limit
:title: The limit of the hulls is closed and convex
:zh: 凸包的极限
:printed: hence $A\equiv\lim_{m\to\infty}A(\Gamma_k^{(T)}(T_m'))=\bigcap_{i=1}^{+\infty}A(\Gamma_k^{(T)}(T_i'))$ is a closed convex set, too
:holds-by: inserted_points_divide_the_edges insertion_ratios_are_between_zero_and_one printed_factors_are_the_discrete_shares
  clamped_start_inserted_again_repeats_the_first_point steps_of_refinement_compose weights_of_both_steps_are_positive knots_above_k_fold_repeat_new_points
:confirmed-by: inserted_polygons_stay_convex
:needs: mixed_weights_cut_beside_the_edges | definition 4.1.1: $w_i>0$ | the weights are positive
:hypothesis: polygon_that_turns_back_loses_convexity | the polygon runs through its points once: as for the lemma; else the $A$
  of a refined polygon need not exist; or $A$ is taken as the hull
:hypothesis: end_of_more_than_k_knots_has_no_shares | $t_n<t_{n+k}$: for (4.1.6)
:needs: hulls_of_unrelated_knots_are_not_nested | corollary 4.1.1: $T'_m\subseteq T'_{m+1}$ | the sets of knots increase: with
  the two sets here in turn the hulls have no limit; or the polygons converge by (4.1.10), when limit and intersection are the hull of the curve
:argued: | One knot after another gives $T'_{i+1}$ from $T'_i$, by (4.1.7), and each makes the hull smaller or leaves it; where a knot is more than $k$-fold, points without a share are left out.  The limit of a decreasing sequence of compact sets is their
  intersection, and an intersection of closed convex sets is closed and convex.
:figure: hulls_of_knot_sets

The knots of corollary 4.1.1 may be taken in $(t_1,t_{n+k})$, where (4.1.6) gives every new point.
:::

:::{claim} hulls_of_unrelated_knots_are_not_nested
:title: The hulls of sets of knots that are not nested are not nested
:zh: 无包含关系的节点集
:kind: counterexample
:given: a quadratic segment of the points $r$ and weights $w$ over the knots $T$; $T_1=\{\tau_1\}$, $T_2=\{\tau_2\}$
:data: T = 0 0 0 1 1 1; r = (0,0) (4,0) (0,4); w = 1 1 1; τ = 1/4 3/4
:then: $T_2$ does not contain $T_1$, and the second vertex of $\Gamma(T_2)$ is not in $A(\Gamma(T_1))$
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
:holds-by: convex_polygons_lie_on_the_border_of_their_hull triangles_of_one_sign_make_a_polygon_convex
:confirmed-by: convex_polygons_have_splines_of_one_turn
:hypothesis: knot_of_full_multiplicity_tears_the_curve | no knot inside the domain has multiplicity $k$ or more, or the points
  there coincide; else the polygons converge to the curve
  together with the segment over which it jumps
:hypothesis: simple_start_keeps_the_first_vertex | $t_2=t_k$: so the polygon begins with the curve, as for corollary 4.1.1, (4.1.10) being the limit of the whole
  polygon; else $A$ may have more than the curve, as here a vertex to the left of it
:hypothesis: idle_start_keeps_the_first_vertex | $t_k<t_{k+1}$: else $r_1$ may have no share in the curve
:hypothesis: simple_end_keeps_the_last_vertex | the knots $t_{n+1},\dots,t_{n+k-1}$ are equal: so the polygon ends with the curve; else $A$ may have a vertex to the right of it
:hypothesis: idle_end_keeps_the_last_vertex | the interval $[t_n,t_{n+1})$ is not empty: else $r_n$ may have no share in the curve
:hypothesis: curve_of_a_polygon_that_turns_back_is_not_convex | the polygon runs through its points once: as for the theorem; else
  the $A$ of a refined polygon need not exist
:needs: mixed_weights_bend_both_ways | definition 4.1.1: $w_i>0$ | the weights are positive
:meant: the step itself, which names $\boldsymbol r_k(t)$ | The polygons are those of one NURBS curve.
:reading: limit_of_convex_polygons_may_run_back | as a step about the limits of any convex polygons, convex meaning run through once
:reading: convex_polygons_have_splines_of_one_turn | as a step about NURBS curves
:argued: | The polygons are convex by lemma 4.2.1, and converge by (4.1.10).  Let polygon points $P_m\to P$, $P$ inside $A$.  Some disc about $P$ is in $A$, so in every
  $A(\Gamma_k^{(T)}(T'_m))$, and for large $m$ the point $P_m$ is inside it, not on the boundary.  Hence $P$ is on the boundary, and
  $A$, the limit of the hulls, is the hull of the limit.  The triangle of three points of the curve, in their order, is a limit of triangles of points of the polygons,
  which have one sign; so the curve runs through the boundary once, unless it is on a line.  Then the points whose B-splines are not 0 are on that line, too, and
  this part of the polygon goes straight on, and so does the curve: theorem 4.2.1.
:figure: where_hypotheses_are_needed
:::

:::{claim} convex_polygons_have_splines_of_one_turn
:title: Designed NURBS curves of convex polygons never turn to the other side
:zh: 设计算例曲线的转向
:kind: decision
:given: seven designed curves of the orders 2 to 4 with convex polygons, and four families of positive weights
:let: $P=(wx,wy,w)$, the curve in homogeneous coordinates
:then: $\det(P,P',P'')\ge0$ on every interval of knots, and any three of thirteen points of the curve, equally spaced in the
  parameter, turn left in their order or are on one line
:method: The homogeneous Bézier points of each interval; the sign of the polynomial by counting its roots.  The points by the
  kernel, the areas exactly.
:degrees: k = 2..4
:scope: the stated curves
:harmless: convex polygons | they are those of the stated curves
:harmless: positive weights | they are those of the stated curves
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
                    poly turn = turning_of_span(k - 1, t + 1, j - 1, r + 2, w + 1, NULL);
                    agree(T, is_nonnegative_on(turn, from_int(0), from_int(1)));
                }
            enum { POINTS = 13 };
            num P[2 * POINTS];
            for (int m = 0; m < POINTS; m++) {
                num x = add(t[k], mul(from_ratio(m, POINTS - 1), sub(t[n + 1], t[k])));
                G(nurbs_point)(G(nurbs_on_span)(k - 1, 2, t + 1, span_of(n, k, t, x), r + 2, w + 1), x, P + 2 * m);
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
A closed curve without an end is not covered by the theorem as it stands, since its polygon, written for the kernels, overlaps
itself. Cutting the corners of the closed polygon works as before, and this is what is decided for the curves below.

:::{claim} periodic_curves_of_convex_polygons_are_convex
:title: Three closed convex polygons have convex periodic curves
:zh: 三个闭合凸多边形的周期曲线为凸
:kind: decision
:given: a triangle, a quadrilateral and a pentagon, convex and closed; orders $3$ and $4$; the first knots of $T$ as a period of different
  intervals; weights equal, large and small in turn, and growing
:data: triangle = (0,0) (3,0) (1,2); quadrilateral = (0,0) (3,0) (3,3) (0,1); pentagon = (0,0) (4,0) (5,3) (2,5) (0,1); T = 0 2 3 5 6 7
:then: the Bézier points of all intervals, joined, are a closed convex polygon that runs round once
:method: The Bézier points of each interval by the kernel.  Convexity by `exact/decide/hull.h`.
:degrees: k = 3..4
:scope: the stated curves
:control: the second point moved across the line of its neighbours
:::
*/
CLAIM(periodic_curves_of_convex_polygons_are_convex)
{
    enum { SIZE = 16, FEWEST = 3, MOST = 5 };
    static const char *const name[] = {"triangle", "quadrilateral", "pentagon"};
    int p = T->degree - 1;
    num knot[MOST + 1], point[MOST + 1][2 * MOST];
    for (int m = FEWEST; m <= MOST; m++)
        given_points(T, name[m - FEWEST], m, 2, point[m]);
    given_points(T, "T", MOST + 1, 1, knot);
    for (int m = FEWEST; m <= MOST; m++)
        for (int family = 0; family < 3; family++) {
            num H[3 * SIZE], v[SIZE], D[3 * SIZE], w[SIZE], b[3 * SIZE], joined[2 * MOST * SIZE], *R = point[m];
            region_mark mark = region_open();
            num kept = R[3];
            R[3] = fault(T, R[3], add(from_int(9), R[5]));
            for (int i = 0; i < m; i++)
                w[i] = family_weight(family, m, i + 1);
            G(rational_homogenize)(m - 1, 2, R, w, H);
            G(bspline_periodic)(m, p, 3, knot, H, v, D);
            for (int j = 0; j < m; j++) {
                G(bspline_to_bezier)(G(on_span)(p, 3, v, p + j, D), b);
                G(rational_dehomogenize)(p - 1, 2, b, joined + 2 * j * p, w);
            }
            int orientation;
            agree(T, fault(T, polygon_is_convex(m - 1, R, 1, &orientation) && orientation == 1, 1));
            agree(T, polygon_is_convex(m * p - 1, joined, 1, &orientation) && orientation == 1);
            R[3] = kept;
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
