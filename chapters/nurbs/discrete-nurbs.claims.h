/*
# Discrete NURBS curves (有理离散 B 样条曲线)

Insert knots $T'$ into the knots $T$: every spline over $T$ is one over $T\oplus T'$ (union with multiplicities, 节点的并), and its
new points are means of the old ones, in which $r_i$ counts as often as the discrete B-spline (离散 B 样条)
$\alpha_{i,k}^{(T,T')}(j)$ says,

$$N_{i,k}^{(T)}=\sum_j\alpha_{i,k}^{(T,T')}(j)\,N_{j,k}^{(T\oplus T')}.$$

With weights the means are weighted, and the new polygon is the discrete NURBS curve $\Gamma_k^{(T)}(T')$.  The section of the source
on discrete B-splines, 2.10, is not in the text at hand; its $\alpha$ are read as those of [cohen-lyche-riesenfeld-1980], which
begin with $\alpha_{i,1}(j)=1$ for $t_i\le t'_j<t_{i+1}$, $t'_j$ the knots of $T\oplus T'$: intervals closed on the left.
*/
#include "chapters/nurbs/definition.h"
#include "chapters/nurbs/discrete.h"

#include "chapters/judge/claims_on.h"

/*
## New points and weights

:::{statement} wang-ch4:def-4.1-discrete-curve
:title: The discrete rational B-spline curve
:zh: 有理离散 B 样条曲线的定义
:definition: yes
:printed: Likewise, in imitation of (2.10.1) and (2.10.2), the discrete rational B-spline curve $\Gamma_\iota^{(T)}(T')$ of order $k$ can be defined, and with (2.10.4)
  theorem 4.1.1 results, which describes the discrete structure of NURBS curves
:checked-by: refined_data_give_the_same_curve discrete_bsplines_are_shares
:confirmed-by: nothing_inserted_changes_nothing
:needs: negative_weight_loses_a_new_point | definition 4.1.1: $w_i>0$ | the weights are positive: otherwise a vertex may not exist
:meant: theorem 4.1.1, whose points (4.1.6) are the new control points | The polygon of the points (4.1.6); its index, an iota in print, is the order $k$, see
  `notation-order`.
:figure: nurbs_polygons_converge

For $T'=\Phi$, nothing inserted, and knots that are at most $k$-fold it is the control polygon, and $\alpha_{i,k}(j)$ is $1$ for
$i=j$ and $0$ otherwise; where $t_j=t_{j+k}<t_{n+k}$ the point $r_j$, which has no share in the curve, gives way to another.  For which $T$ and $T'$ all vertices exist is the matter of `formula-4.1.6`.
:::
*/

/* Pairs T, T' over common values for each degree; in one of them at least a knot becomes more than k-fold. */
static const char *const G(pairs)[][16] = {
    {NULL},
    {"202", "010", "1111", "0010", "2112", "0100", "2012", "0220", "202", "100", NULL},
    {"3003", "0110", "30103", "01010", "111111", "000100", "3103", "0120", "31103", "02010", "313", "030", "303", "110",
     NULL},
    {"4004", "0110", "40104", "01010", "4204", "0120", "11111111", "00001000", "414", "040", NULL},
    {"50105", "01010", "50205", "02100", "515", "150", NULL},
    {"60106", "01010", "60306", "02100", "616", "160", NULL},
    {"70107", "01010", "70307", "02110", "717", "170", NULL},
};

/*
New points and new weights are two statements in one: the weights are refined like a function, and the points are means with the
shares $\alpha_i(j)w_i$. For these to be means the $\alpha_i(j)$ must not be negative, and must not all vanish.

:::{claim} discrete_bsplines_are_shares
:title: The discrete B-splines of a point are nonnegative and sum up to 1
:zh: 离散 B 样条非负且和为一
:given: pairs $T$, $T'$ of patterns of knots with any positive gaps, all inserted knots in the domain; every new point $j$
:then: $\alpha_{i,k}(j)\ge0$ and $\sum_{i=1}^n\alpha_{i,k}(j)=1$; so with positive weights $w_j^{(T,T')}$ is between the least and
  the greatest of the $w_i$
:method: The recursion by its letter; signs are read off coefficients in the gaps.
:degrees: 1..6 sampled 6
:scope: 26 pairs of patterns of knots, all inserted knots in the domain
:control: the share of $r_1$ left out of the sum
:::
*/
CLAIM(discrete_bsplines_are_shares)
{
    int p = T->degree;
    struct G(refinement) r;
    for (int k = 0; G(pairs)[p][k] != NULL; k += 2) {
        G(increasing_knots)(T, (int)strlen(G(pairs)[p][k]), 6, r.x);
        G(refine_pair)(G(pairs)[p][k], G(pairs)[p][k + 1], p, &r);
        for (int j = 0; j < r.m; j++) {
            num sum = from_int(0);
            for (int i = 0; i < r.n; i++) {
                num a = G(alpha)(p, r.u, r.place, r.v, r.at, i, j);
                about(T, "the sign of alpha_i(j)");
                nonnegative(T, a);
                if (fault(T, 1, i > 0))
                    sum = add(sum, a);
            }
            about(T, "the sum of the alpha_i(j)");
            same(T, sum, from_int(1));
        }
    }
}

/*
:::{claim} nothing_inserted_changes_nothing
:title: With no knot inserted every point has the share 1 in itself
:zh: 不嵌节点时离散 B 样条为单位阵
:given: the knots $T$ of 26 pairs $T$, $T'$ of patterns, and $T'=\Phi$ in the place of theirs; every $i$ and $j$
:then: $\alpha_{i,k}^{(T,\Phi)}(j)$ is $1$ for $i=j$ and $0$ otherwise, so that the points and weights of (4.1.6) are the given ones
:method: The recursion by its letter, the knots variables.
:degrees: 1..6 sampled 6
:scope: the knots of 26 pairs of patterns
:control: $\alpha_{i,k}(j)$ taken at $j+1$
:::
*/
CLAIM(nothing_inserted_changes_nothing)
{
    int p = T->degree;
    struct G(refinement) r;
    for (int k = 0; G(pairs)[p][k] != NULL; k += 2) {
        const char *old = G(pairs)[p][k];
        char none[MOST_KNOTS] = {0};
        memset(none, '0', strlen(old));
        G(distinct_knots)(T, (int)strlen(old), 6, r.x);
        G(refine_pair)(old, none, p, &r);
        for (int j = 0; j < r.m; j++)
            for (int i = 0; i < r.n; i++) {
                int taken = fault(T, j, j + 1 < r.m ? j + 1 : j - 1);
                same(T, G(alpha)(p, r.u, r.place, r.v, r.at, i, taken), from_int(i == j));
            }
    }
}

/*
That the curve stays the same is a statement about the homogeneous curve, so about the numerator and about the denominator each by
itself. It is stronger than the equality of the quotients, which a common factor could produce too.

:::{claim} refined_data_give_the_same_curve
:title: The new points, weights and knots give the same curve
:zh: 新的顶点、权因子与节点给出同一条曲线
:given: pairs $T$, $T'$ of patterns of knots; weights and points; every interval of the domain, any $t$
:where: the new weights and $w(t)$ are not 0
:then: (4.1.8) with the points and weights of (4.1.6) is (4.1.2), and so is its denominator
:method: All sums by their letter.
:degrees: 1..6 sampled 6
:scope: 26 pairs of patterns of knots, all inserted knots in the domain; the distinct knots variables up to order 6, numbers above
:control: the new weights taken as 1 in (4.1.8)
:::
*/
CLAIM(refined_data_give_the_same_curve)
{
    int p = T->degree;
    struct G(refinement) r;
    num R[MOST_KNOTS], w[MOST_KNOTS], S[MOST_KNOTS], z[MOST_KNOTS], P, Q, t = unknown(T, "t", 0);
    for (int k = 0; G(pairs)[p][k] != NULL; k += 2) {
        G(distinct_knots)(T, (int)strlen(G(pairs)[p][k]), 5, r.x);
        G(refine_pair)(G(pairs)[p][k], G(pairs)[p][k + 1], p, &r);
        G(weighted_points)(T, r.n, 1, R, w);
        G(refined_by_definition)(r.n, p, 1, r.u, r.place, R, w, r.m, r.v, r.at, S, z);
        for (int j = 0; j < r.m; j++)
            z[j] = fault(T, z[j], from_int(1));
        for (int interval = r.place[p]; interval < r.place[r.n]; interval++) {
            num total = G(nurbs_by_definition)(r.n, p, 1, r.u, r.place, R, w, interval, t, &P);
            num refined = G(nurbs_by_definition)(r.m, p, 1, r.v, r.at, S, z, interval, t, &Q);
            about(T, "the curve");
            same(T, Q, P);
            about(T, "its denominator");
            same(T, refined, total);
        }
    }
}

/*
:::{statement} wang-ch4:notation-order
:title: The order as index of curve and polygon
:zh: 曲线与多边形记号中的阶数下标
:printed: In 4.1 the discrete curve of order $k$ is $\Gamma_\iota^{(T)}(T')$; in the proof of lemma 4.2.1 the polygon of order $k$ is
  $\Gamma^{(T\oplus T')}(\Phi)$; in lemma 4.2.2 the NURBS curve is $r_t(t)$
:class: misprint
:refuted-by: three_names_lack_the_order
:corrected: $\Gamma_k^{(T)}(T')$, $\Gamma_k^{(T\oplus T')}(\Phi)$ and $r_k(t)$
:corrected-by: names_carry_the_order
:example: the three names that are printed.
:::
*/

#if RATIONAL
/* In how many of the three places the index is k. */
static int indices_that_are_the_order(trial *T)
{
    static const char *const place[] = {"index in 4.1", "index in lemma 4.2.1", "index in lemma 4.2.2"};
    int right = 0;
    for (int m = 0; m < 3; m++)
        right += strcmp(given_text(T, place[m]), "k") == 0;
    found_whole(T, "indices that are k", right);
    return right;
}

/*
:::{claim} three_names_lack_the_order
:title: In three names the index is not the order
:zh: 三处记号的下标不是阶数
:kind: counterexample
:given: the indices, in these three places, of what is called $\Gamma_k^{(T)}$ everywhere else in these sections, and $r_k$ wherever else the name of the curve has an index
:data: index in 4.1 = "ι"; index in lemma 4.2.1 = "none"; index in lemma 4.2.2 = "t"
:instead: index in 4.1 = "k"; index in lemma 4.2.1 = "k"; index in lemma 4.2.2 = "k"
:then: none of the three is $k$
:result: indices that are k = 0
:method: Index by index.
:control: the three indices corrected
:::
*/
CLAIM(three_names_lack_the_order)
{
    int right = indices_that_are_the_order(T);
    about(T, "one of the indices is the order k");
    agree(T, right > 0);
}

/*
:::{claim} names_carry_the_order
:title: With the three indices corrected the names are those of the other formulas
:zh: 更正后记号一致
:kind: decision
:given: the three indices, corrected
:data: index in 4.1 = "k"; index in lemma 4.2.1 = "k"; index in lemma 4.2.2 = "k"
:instead: index in 4.1 = "ι"; index in lemma 4.2.1 = "none"; index in lemma 4.2.2 = "t"
:then: each is $k$
:result: indices that are k = 3
:method: Index by index.
:control: the indices as printed
:::
*/
CLAIM(names_carry_the_order)
{
    int right = indices_that_are_the_order(T);
    about(T, "the indices are the order k");
    agree(T, right == 3);
}
#endif

/*
The formula is printed for every $T'$. Three things can make it meaningless. A negative weight can take a new weight to $0$. A
knot outside the support of every function has no shares at all. And there is the question which interval is closed at a knot,
which the later proof answers in another way than the definition of the $\alpha$.

:::{statement} wang-ch4:formula-4.1.6
:title: The control points and weights after the insertion of knots
:zh: 嵌入节点后的控制顶点与权因子
:printed: The new control points and weights after the transformation that inserts the knots $T'$ are
  $r_{j,k}^{(T,T')}=\sum_i\alpha_{i,k}^{(T,T')}(j)w_{i,k}^{(T)}r_{i,k}^{(T)}\Big/\sum_i\alpha_{i,k}^{(T,T')}(j)w_{i,k}^{(T)}$,
  $w_{j,k}^{(T,T')}=\sum_i\alpha_{i,k}^{(T,T')}(j)w_{i,k}^{(T)}$, all notation being that of section 2.10
:holds-by: refined_data_give_the_same_curve discrete_bsplines_are_shares
:needs: negative_weight_loses_a_new_point | definition 4.1.1: $w_i>0$ | the weights are positive: otherwise a new weight may be
  $0$, and there is no new point though the curve is there
:hypothesis: knot_at_a_k_fold_end_has_no_shares | every knot of $T'$ is in $(t_1,t_{n+k})$, or at $t_1$ where $t_1=t_k$: otherwise all
  $\alpha_{i,k}(j)$, $1\le i\le n$, may be $0$ for some points, and (4.1.6) is $0/0$
:hypothesis: end_of_more_than_k_knots_has_no_shares | $t_n<t_{n+k}$: with more than $k$ equal knots at the end there are such points, whatever is inserted
:meant: the line after (4.1.6): all notation is that of 2.10 | The $\alpha$ of 2.10, which is not in the text at hand: here those of Cohen, Lyche and
  Riesenfeld, with intervals closed on the left.
:reading: knots_outside_the_domain_cut_corners | with these $\alpha$, for one knot outside the domain, too, over simple knots
:reading: knot_at_an_outer_end_has_no_shares | with these $\alpha$, for a knot inserted at $t_1$ or at $t_{n+k}$ where these are single knots: the first or the last new weight is 0
:reading: insertion_at_a_clamped_start_asks_for_another_point | with the $\alpha_i$ that the proof of lemma 4.2.1 prints, intervals
  closed on the right, for a knot at the start of a clamped curve: $\tau=t_1$ has to be excluded
:reading: clamped_end_may_be_inserted_again | with the same $\alpha_i$ a $k$-fold right end may be inserted, which repeats $r_n$
:figure: nurbs_polygons_converge

With positive weights and $T'$ in the domain, but not at a $k$-fold $t_{n+1}$, all new weights lie between the least and the greatest of the old
ones: `discrete_bsplines_are_shares`.
:::
*/

#if FIELD || RATIONAL
/*
:::{claim} knots_outside_the_domain_cut_corners
:title: A knot outside the domain cuts corners of the polygon as well, and keeps the curve
:zh: 定义域外的节点同样割角且不改变曲线
:given: simple knots, $n=k+1$; one knot $\tau$ inside an interval of $(t_1,t_k)$ or $(t_{n+1},t_{n+k})$, or at one of the knots there; positive
  gaps and weights
:then: new point $j$ has no share but in $r_{j-1}$ and $r_j$, and both shares are nonnegative; they sum up to $1$ for $1<j\le n$, while
  the first is $r_1$, with $\alpha_{1,k}(1)=\frac{\tau-t_1}{t_k-t_1}$ or $1$, and the last, number $n+1$, is $r_n$, with
  $\alpha_{n,k}(n+1)=\frac{t_{n+k}-\tau}{t_{n+k}-t_{n+1}}$ or $1$; and (4.1.8) is (4.1.2) on the domain
:method: (4.1.6) and both curves by their letter; signs are read off coefficients in the gaps.
:types: field rational
:degrees: 1..6 sampled 7
:scope: one knot outside the domain of k+1 points over simple knots; the distinct knots variables up to order 4, numbers above
:where: the weights are positive
:control: the first or the last share, that which is less than $1$, taken as $1$
:::
*/
CLAIM(knots_outside_the_domain_cut_corners)
{
    int p = T->degree, n = p + 2;
    struct G(refinement) r;
    num R[MOST_KNOTS], w[MOST_KNOTS], S[MOST_KNOTS], z[MOST_KNOTS], P, Q, t = unknown(T, "t", 0), one = from_int(1);
    for (int which = 0; which < 4 * p; which++) { /* p gaps on either side, and their ends towards the domain */
        int right = which % 2, at_knot = which / 2 % 2, gap = which / 4;
        int before = right ? n + gap + 1 : gap + 1; /* so many knots are before the gap */
        char old[MOST_KNOTS] = {0}, new[MOST_KNOTS] = {0};
        if (at_knot && gap + 1 == p)
            continue; /* t_k is in the domain, and t_{n+k} is excluded */
        for (int i = 0; i < n + p + 2; i++) {
            old[i] = (char)('0' + (i != before));
            new[i] = (char)('0' + (i == before + at_knot));
        }
        G(increasing_knots)(T, n + p + 2, 3, r.x);
        G(refine_pair)(old, new, p, &r);
        G(weighted_points)(T, n, 1, R, w);
        num tau = r.x[before + at_knot];
        for (int j = 0; j < r.m; j++) {
            num share[MOST_KNOTS], both = from_int(0);
            for (int i = 0; i < n; i++) {
                share[i] = G(alpha)(p, r.u, r.place, r.v, r.at, i, j);
                about(T, "the shares of the neighbours");
                if (i == j - 1 || i == j) {
                    nonnegative(T, share[i]);
                    both = add(both, share[i]);
                } else {
                    same(T, share[i], from_int(0));
                }
            }
            num sum = one; /* but (τ - t_1)/(t_k - t_1) for the first, (t_{n+k} - τ)/(t_{n+k} - t_{n+1}) for the last */
            if (fault(T, j == 0 && !right, 0))
                sum = div(sub(tau, r.u[0]), sub(r.u[p], r.u[0]));
            if (fault(T, j == n && right, 0))
                sum = div(sub(r.u[n + p], tau), sub(r.u[n + p], r.u[n]));
            about(T, "their sum");
            same(T, both, sum);
        }
        G(refined_by_definition)(n, p, 1, r.u, r.place, R, w, r.m, r.v, r.at, S, z);
        for (int interval = r.place[p]; interval < r.place[n]; interval++) {
            num total = G(nurbs_by_definition)(n, p, 1, r.u, r.place, R, w, interval, t, &P);
            num refined = G(nurbs_by_definition)(r.m, p, 1, r.v, r.at, S, z, interval, t, &Q);
            about(T, "the curve");
            same(T, Q, P);
            about(T, "its denominator");
            same(T, refined, total);
        }
    }
}
#endif

/*
:::{claim} nurbs_insertion_is_one_discrete_step
:title: Boehm's insertion with weights is (4.1.6) for one knot
:zh: 带权的 Boehm 嵌入公式即单节点的 (4.1.6)
:given: one knot inserted between knots and at a knot of every multiplicity below $k$; points and weights, values variables
:then: `nurbs_insert` gives the knots $T\oplus\{\tau\}$ and the points and weights of (4.1.6)
:method: The kernel against all sums by their letter.
:degrees: 1..6 sampled 7
:scope: clamped ends with one knot of every multiplicity below k between
:defines: nurbs_insert
:where: the new weights are not 0
:control: the knot inserted at the next value
:::
*/
CLAIM(nurbs_insertion_is_one_discrete_step)
{
    int p = T->degree;
    struct G(refinement) r;
    for (int times = 0; times <= p; times++) { /* the multiplicity of x_1 before */
        char old[] = {(char)('1' + p), (char)('0' + times), '0', (char)('1' + p), '\0'};
        num R[2 * MOST_KNOTS], w[MOST_KNOTS], S[2 * MOST_KNOTS], z[MOST_KNOTS];
        num v[MOST_KNOTS], kernel_S[2 * MOST_KNOTS], kernel_z[MOST_KNOTS];
        G(distinct_knots)(T, 4, 6, r.x);
        G(refine_pair)(old, "0100", p, &r);
        G(weighted_points)(T, r.n, 2, R, w);
        G(refined_by_definition)(r.n, p, 2, r.u, r.place, R, w, r.m, r.v, r.at, S, z);
        num knot = r.x[fault(T, 1, 2)];
        G(nurbs_insert)(nurbs(p, r.n, 2, r.u, R, w), p + times, knot, v, kernel_S, kernel_z);
        about(T, "the knots");
        for (int i = 0; i <= r.m + p; i++)
            same(T, v[i], r.v[i]);
        about(T, "the weights and points");
        for (int j = 0; j < r.m; j++) {
            same(T, kernel_z[j], z[j]);
            for (int c = 0; c < 2; c++)
                same(T, kernel_S[2 * j + c], S[2 * j + c]);
        }
    }
}

#if RATIONAL
/* All alpha_i(j), j from 0. */
static void G(shares_of_point)(int p, const struct G(refinement) * r, int j, num share[])
{
    for (int i = 0; i < r->n; i++)
        share[i] = G(alpha)(p, r->u, r->place, r->v, r->at, i, j);
}

/* w_j^{(T,T')} of (4.1.6): the sum of alpha_i(j) w_i, j from 0. */
static num G(new_weight)(int p, const struct G(refinement) * r, const num w[], int j)
{
    num sum = from_int(0);
    for (int i = 0; i < r->n; i++)
        sum = add(sum, mul(G(alpha)(p, r->u, r->place, r->v, r->at, i, j), w[i]));
    return sum;
}

/*
:::{claim} negative_weight_loses_a_new_point
:title: With a negative weight a new point may not exist
:zh: 权因子为负时新顶点可能不存在
:kind: counterexample
:given: the knots $T$ of one quadratic segment, weights $w$ of which one is negative; one knot inserted, $T'=\{\tau\}$
:data: T = 0 0 0 2 2 2; T' = 1; w = 1 -1 2
:instead: w = 1 1 2
:then: $w_2^{(T,T')}$ vanishes, while $w(\tau)$ does not
:result: w_2^(T,T') = 0; w(τ) = 1/4
:method: (4.1.6) and the denominator of (4.1.2) by their letter.
:control: all weights positive
:::
*/
CLAIM(negative_weight_loses_a_new_point)
{
    struct G(refinement) r;
    num w[3], total = from_int(0);
    G(given_refinement)(T, 2, 6, 1, &r);
    given_points(T, "w", 3, 1, w);
    num tau = r.v[3], new_weight = G(new_weight)(2, &r, w, 1);
    for (int i = 0; i < r.n; i++)
        total = add(total, mul(w[i], G(cox_de_boor)(2, r.u, r.place, i, r.at[2], tau)));
    found(T, "w_2^(T,T')", new_weight);
    found(T, "w(τ)", total);
    about(T, "if w(τ) is not 0, then the new weight is not 0");
    refute(T, sign_q(total) != 0 && sign_q(new_weight) == 0);
}

/*
:::{claim} negative_weight_loses_a_vertex_beside_the_common_point
:title: With a negative weight the polygon through a point of the curve may lack another vertex
:zh: 权因子为负时过交点的多边形可能缺另一顶点
:kind: counterexample
:given: the knots $T$ of one quadratic segment, its points $r$, all above the line $y=0$, and weights $w$, of which one is negative; the parameter $\tau$
  of a point of the curve on the line is inserted $k-1$ times, $T'=\{\tau\}^{k-1}$
:data: T = 0 0 0 2 2 2; T' = 1 1; r = (0,2) (1,2) (2,1); w = 1 -1 2
:instead: w = 1 1 2
:then: $w(\tau)\ne0$ and $r(\tau)$ is on the line, but $w_2^{(T,T')}$ vanishes, so that $\Gamma_k^{(T)}(T')$ has no second vertex
:result: w(τ) = 1/4; r(τ) = (2,0); new weights = 1 0 1/4 1/2 2
:method: (4.1.6) and (4.1.2) by their letter.
:control: all weights positive
:::
*/
CLAIM(negative_weight_loses_a_vertex_beside_the_common_point)
{
    struct G(refinement) r;
    num point[3 * 2], w[3], new[5], total = from_int(0), at[2] = {from_int(0), from_int(0)};
    G(given_refinement)(T, 2, 6, 2, &r);
    given_points(T, "r", 3, 2, point);
    given_points(T, "w", 3, 1, w);
    num tau = r.v[3];
    for (int i = 0; i < r.n; i++) {
        num share = mul(w[i], G(cox_de_boor)(2, r.u, r.place, i, r.at[2], tau));
        total = add(total, share);
        for (int c = 0; c < 2; c++)
            at[c] = add(at[c], mul(share, point[2 * i + c]));
    }
    for (int c = 0; c < 2; c++)
        at[c] = div(at[c], total);
    int missing = 0;
    for (int j = 0; j < r.m; j++) {
        new[j] = G(new_weight)(2, &r, w, j);
        missing += sign_q(new[j]) == 0;
    }
    found(T, "w(τ)", total);
    found_points(T, "r(τ)", 1, 2, at);
    found_points(T, "new weights", r.m, 1, new);
    about(T, "if w(τ) is not 0, then no new weight is 0");
    refute(T, sign_q(total) != 0 && missing > 0);
}

/*
:::{claim} knot_at_a_k_fold_end_has_no_shares
:title: A knot inserted at a k-fold right end makes a point without shares
:zh: 在 k 重右端点嵌入节点所得顶点无意义
:kind: counterexample
:given: the knots $T$ of one linear segment, whose last knot is inserted again; weights $w$; the last of the new points, number $j$
:data: T = 0 0 2 2; T' = 2; w = 1 1
:instead: T' = 1
:then: all $\alpha_{i,2}(j)$ vanish, and so does $w_j^{(T,T')}$
:result: α_i,2(j) = 0 0; w_3^(T,T') = 0
:method: (4.1.6) by its letter.
:control: the inserted knot inside
:::
*/
/* Of the given linear curve with n points, one knot inserted: whether the weight of the last new point, called `name`, is positive. */
static int G(last_new_weight_is_positive)(trial *T, int n, const char *name)
{
    struct G(refinement) r;
    num w[3], share[3];
    G(given_refinement)(T, 1, n + 2, 1, &r);
    given_points(T, "w", n, 1, w);
    G(shares_of_point)(1, &r, r.m - 1, share);
    found_points(T, "α_i,2(j)", n, 1, share);
    num sum = G(new_weight)(1, &r, w, r.m - 1);
    found(T, name, sum);
    about(T, "the new weight is positive");
    return sign_q(sum) > 0;
}

CLAIM(knot_at_a_k_fold_end_has_no_shares) { agree(T, G(last_new_weight_is_positive)(T, 2, "w_3^(T,T')")); }

/*
:::{claim} end_of_more_than_k_knots_has_no_shares
:title: More than k equal knots at the end make a point without shares
:zh: 末端节点超过 k 重时所得顶点无意义
:kind: counterexample
:given: the knots $T$ of a linear curve, of which the last three are equal; a knot inserted inside the domain; weights $w$; the last of the new points,
  number $j$
:data: T = 0 0 2 2 2; T' = 1; w = 1 1 1
:instead: T = 0 0 2 2 3
:then: all $\alpha_{i,2}(j)$ vanish, and so does $w_j^{(T,T')}$
:result: α_i,2(j) = 0 0 0; w_4^(T,T') = 0
:method: (4.1.6) by its letter.
:control: the last knot greater than the others
:::
*/
CLAIM(end_of_more_than_k_knots_has_no_shares) { agree(T, G(last_new_weight_is_positive)(T, 3, "w_4^(T,T')")); }

/*
:::{claim} knot_at_an_outer_end_has_no_shares
:title: A knot inserted at a single first or last knot makes a point without shares
:zh: 在单重首末节点处嵌入节点所得顶点无意义
:kind: counterexample
:given: the knots $T$ of a quadratic segment, of which the first and the last are single, weights $w$; $\tau_1$, the first knot, is inserted again, and then instead of it $\tau_2$, the
  last; the first of the new points, and the last
:data: T = 0 1 1 2 2 3; τ = 0 3; w = 1 1 1
:instead: τ = 1/2 5/2
:then: all $\alpha_{i,3}(j)$ of these two points vanish, and so do their weights
:result: α_i,3(1), τ_1 = 0 0 0; α_i,3(4), τ_2 = 0 0 0; w_1^(T,{τ_1}) = 0; w_4^(T,{τ_2}) = 0
:method: (4.1.6) by its letter.
:control: the inserted knots next to the ends, inside
:::
*/
CLAIM(knot_at_an_outer_end_has_no_shares)
{
    struct G(refinement) first, last;
    num u[6], tau[2], w[3], first_share[3], last_share[3];
    given_points(T, "T", 6, 1, u);
    given_points(T, "τ", 2, 1, tau);
    given_points(T, "w", 3, 1, w);
    G(refine_knots)(2, 6, u, 1, tau, &first);
    G(refine_knots)(2, 6, u, 1, tau + 1, &last);
    G(shares_of_point)(2, &first, 0, first_share);
    G(shares_of_point)(2, &last, last.m - 1, last_share);
    found_points(T, "α_i,3(1), τ_1", 3, 1, first_share);
    found_points(T, "α_i,3(4), τ_2", 3, 1, last_share);
    num first_weight = G(new_weight)(2, &first, w, 0), last_weight = G(new_weight)(2, &last, w, last.m - 1);
    found(T, "w_1^(T,{τ_1})", first_weight);
    found(T, "w_4^(T,{τ_2})", last_weight);
    about(T, "one of the new weights is positive");
    agree(T, (sign_q(first_weight) > 0) + (sign_q(last_weight) > 0) > fault(T, 1, 0));
}
#endif

/*
The equation behind everything is that the old functions are combinations of the new ones. It holds with every multiplicity, even
beyond $k$, where some of the new functions are $0$ and some of the new points do not matter.

:::{statement} wang-ch4:formula-4.1.8
:title: The new points and weights belong to the same curve
:zh: 嵌入节点后曲线不变
:printed: r_k(t)=\sum_jN_{j,k}^{(T\oplus T')}(t)w_{j,k}^{(T,T')}r_{j,k}^{(T,T')}\Big/\sum_jN_{j,k}^{(T\oplus T')}(t)w_{j,k}^{(T,T')}
:holds-by: refined_data_give_the_same_curve discrete_bsplines_refine_the_basis discrete_bsplines_are_shares
:needs: negative_weight_loses_a_new_point | definition 4.1.1: $w_i>0$ | the weights are positive: as for (4.1.6)
:reading: refined_data_give_the_same_curve | a knot of $T\oplus T'$ may become more than $k$-fold: the new $N_{j,k}$ between its
  copies are zero, and such $r_j$ do not count
:hypothesis: knot_at_a_k_fold_end_has_no_shares | every knot of $T'$ is in $(t_1,t_{n+k})$, or at $t_1$ where $t_1=t_k$: otherwise a term of the sum is
  $0\cdot\frac00$
:hypothesis: end_of_more_than_k_knots_has_no_shares | $t_n<t_{n+k}$: otherwise, too, a term is $0\cdot\frac00$
:reading: knots_outside_the_domain_cut_corners | for one knot outside the domain, in $(t_1,t_{n+k})$, too, over simple knots
:figure: insertions_commute
:::

:::{claim} discrete_bsplines_refine_the_basis
:title: The discrete B-splines express the old basis in the new one
:zh: 离散 B 样条把旧基表为新基的组合
:given: every pair of patterns $T$, $T'$ of the list, values variables, with knots inserted between knots and at knots, at an end
  of the domain, up to the multiplicity $k$ and beyond; every interval of the domain, any $t$
:then: $N_{i,k}^{(T)}(t)=\sum_j\alpha_{i,k}^{(T,T')}(j)\,N_{j,k}^{(T\oplus T')}(t)$ for all $i$
:method: Both recursions by their letter.
:degrees: 1..6 sampled 6
:scope: 26 pairs of patterns of knots, all inserted knots in the domain
:control: $\alpha_{i,k}(j)$ taken at $j+1$
:::
*/
CLAIM(discrete_bsplines_refine_the_basis)
{
    int p = T->degree;
    struct G(refinement) r;
    num t = unknown(T, "t", 0);
    for (int k = 0; G(pairs)[p][k] != NULL; k += 2) {
        G(distinct_knots)(T, (int)strlen(G(pairs)[p][k]), 6, r.x);
        G(refine_pair)(G(pairs)[p][k], G(pairs)[p][k + 1], p, &r);
        for (int interval = r.place[p]; interval < r.place[r.n]; interval++)
            for (int i = 0; i < r.n; i++) {
                num sum = from_int(0);
                for (int j = 0; j < r.m; j++) {
                    int taken = fault(T, j, j + 1 < r.m ? j + 1 : j);
                    sum = add(sum, mul(G(alpha)(p, r.u, r.place, r.v, r.at, i, taken),
                                       G(cox_de_boor)(p, r.v, r.at, j, interval, t)));
                }
                same(T, sum, G(cox_de_boor)(p, r.u, r.place, i, interval, t));
            }
    }
}

/*
:::{claim} discrete_bsplines_follow_definition
:title: The kernel for discrete B-splines computes those that do not vanish
:zh: 核函数所算即非零的离散 B 样条
:given: pairs $T$, $T'$ of patterns of knots; every $j$ with $v_j$ in the domain
:then: `bspline_discrete` gives $\alpha_{i,k}(j)$ for the $k$ values $i$ of the interval of $v_j$, and the others are $0$
:method: The kernel, one level for each new knot $v_{j+1},\dots,v_{j+k-1}$, against the recursion by its letter.
:degrees: 1..6 sampled 6
:scope: 26 pairs of patterns of knots, all inserted knots in the domain
:defines: bspline_discrete
:control: $v_{j+1}$ replaced by $v_j$
:::
*/
/* Is v_j in the domain, in an interval [v_j, v_{j+1}) of which a point may be named? */
static int G(in_domain)(int p, const struct G(refinement) * r, int j)
{
    return r->place[p] <= r->at[j] && r->at[j] < r->place[r->n];
}

CLAIM(discrete_bsplines_follow_definition)
{
    int p = T->degree;
    struct G(refinement) r;
    for (int k = 0; G(pairs)[p][k] != NULL; k += 2) {
        G(distinct_knots)(T, (int)strlen(G(pairs)[p][k]), 6, r.x);
        G(refine_pair)(G(pairs)[p][k], G(pairs)[p][k + 1], p, &r);
        for (int j = 0; j < r.m; j++) {
            num a[MAX_DEGREE + 1], arguments[MAX_DEGREE + 1];
            if (!G(in_domain)(p, &r, j))
                continue;
            int mu = G(span_of_interval)(r.count, r.place, r.at[j]);
            for (int l = 0; l < p; l++)
                arguments[l] = r.v[fault(T, j + 1 + l, l == 0 ? j : j + 1 + l)];
            G(bspline_discrete)(p, r.u, mu, arguments, a);
            for (int i = 0; i < r.n; i++)
                same(T, mu - p <= i && i <= mu ? a[i - mu + p] : from_int(0),
                     G(alpha)(p, r.u, r.place, r.v, r.at, i, j));
        }
    }
}

#include "chapters/judge/claims_off.h"
