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
:printed: In imitation of (2.10.1) and (2.10.2) the discrete rational B-spline curve $\Gamma_k^{(T)}(T')$ of order $k$ can be defined
:checked-by: refined_data_give_the_same_curve discrete_bsplines_are_shares
:figure: nurbs_polygons_converge

Printed is $\Gamma_\iota^{(T)}(T')$, see the next entry.  Read as the polygon of the points (4.1.6).  For $T'=\Phi$, nothing inserted, it is the control polygon, and $\alpha_{i,k}(j)$ is $1$ for
$i=j$ and $0$ otherwise.
:::
*/

/* Pairs T, T' over common values for each degree. */
static const char *const G(pairs)[][16] = {
    {NULL},
    {"202", "010", "1111", "0010", "2112", "0100", "2012", "0220", "202", "100", NULL},
    {"3003", "0110", "30103", "01010", "111111", "000100", "3103", "0120", "31103", "02010", "313", "030", "303", "110",
     NULL},
    {"4004", "0110", "40104", "01010", "4204", "0120", "11111111", "00001000", NULL},
    {"50105", "01010", "50205", "02100", NULL},
    {"60106", "01010", "60306", "02100", NULL},
    {"70107", "01010", "70307", "02110", NULL},
};

/*
:::{claim} discrete_bsplines_are_shares
:title: The discrete B-splines of a point are nonnegative and sum up to 1
:zh: 离散 B 样条非负且和为一
:given: the same pairs with any positive gaps, all inserted knots in the domain; every new point $j$
:then: $\alpha_{i,k}(j)\ge0$ and $\sum_{i=1}^n\alpha_{i,k}(j)=1$; so with positive weights $w_j^{(T,T')}$ is between the least and
  the greatest of them
:method: The recursion by its letter; signs are read off coefficients in the gaps.
:degrees: 1..6 sampled 6
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
:::{claim} refined_data_give_the_same_curve
:title: The new points, weights and knots give the same curve
:zh: 新的顶点、权因子与节点给出同一条曲线
:given: the same pairs; weights and points; every interval of the domain, any $t$
:then: (4.1.8) with the points and weights of (4.1.6) is (4.1.2), and so is its denominator
:method: All sums by their letter.
:degrees: 1..6 sampled 6
:scope: the knots variables for $p\le5$, numbers above
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
:printed: In 4.1 the discrete curve of order $k$ is $\Gamma_\iota^{(T)}(T')$; in lemma 4.2.1 the polygon of order $k$ is
  $\Gamma^{(T\oplus T')}(\Phi)$; in lemma 4.2.2 the NURBS curve is $r_t(t)$
:class: misprint
:refuted-by: three_names_lack_the_order
:corrected: $\Gamma_k^{(T)}(T')$, $\Gamma_k^{(T\oplus T')}(\Phi)$ and $r_k(t)$
:corrected-by: names_carry_the_order
:::
*/

#if RATIONAL
/* Whether the index, in each of the three places, is k. */
static int indices_are_the_order(trial *T)
{
    static const char *const place[] = {"index in 4.1", "index in lemma 4.2.1", "index in lemma 4.2.2"};
    int all = 1;
    for (int m = 0; m < 3; m++)
        all &= strcmp(given_text(T, place[m]), "k") == 0;
    about(T, "the index is the order k");
    return all;
}

/*
:::{claim} three_names_lack_the_order
:title: Three names have another index than the order
:zh: 三处记号的下标不是阶数
:kind: counterexample
:given: the indices, in these three places, of what is called $\Gamma_k^{(T)}$ and $r_k$ everywhere else in these sections
:data: index in 4.1 = "ι"; index in lemma 4.2.1 = "none"; index in lemma 4.2.2 = "t"
:instead: index in 4.1 = "k"; index in lemma 4.2.1 = "k"; index in lemma 4.2.2 = "k"
:then: none of the three is $k$
:method: Index by index.
:control: the three indices corrected
:::
*/
CLAIM(three_names_lack_the_order) { agree(T, indices_are_the_order(T)); }

/*
:::{claim} names_carry_the_order
:title: With the three indices corrected the names are those of the other formulas
:zh: 更正后记号一致
:kind: decision
:given: the three indices, corrected
:data: index in 4.1 = "k"; index in lemma 4.2.1 = "k"; index in lemma 4.2.2 = "k"
:instead: index in 4.1 = "ι"; index in lemma 4.2.1 = "none"; index in lemma 4.2.2 = "t"
:then: each is $k$
:method: Index by index.
:control: the indices as printed
:::
*/
CLAIM(names_carry_the_order) { agree(T, indices_are_the_order(T)); }
#endif

/*
:::{statement} wang-ch4:formula-4.1.6
:title: The control points and weights after the insertion of knots
:zh: 嵌入节点后的控制顶点与权因子
:printed: r_{j,k}^{(T,T')}=\sum_i\alpha_{i,k}^{(T,T')}(j)w_{i,k}^{(T)}r_{i,k}^{(T)}\Big/\sum_i\alpha_{i,k}^{(T,T')}(j)w_{i,k}^{(T)},
  \quad w_{j,k}^{(T,T')}=\sum_i\alpha_{i,k}^{(T,T')}(j)w_{i,k}^{(T)}
:holds-by: refined_data_give_the_same_curve discrete_bsplines_are_shares
:needs: negative_weight_loses_a_new_point | positive weights: otherwise a new weight may be $0$, and there is no new point though the
  curve is there
:hypothesis: knot_at_a_k_fold_end_has_no_shares | $T'$ in $(t_1,t_{n+k})$, or at $t_1$ when $t_1=t_k$: otherwise all
  $\alpha_{i,k}(j)$, $1\le i\le n$, may be $0$ for some points, and (4.1.6) is $0/0$
:hypothesis: knot_at_an_outer_end_has_no_shares | the same at ends that are single knots
:reading: knots_outside_the_domain_cut_corners | with the $\alpha$ of 2.10 as they are read here, intervals closed on the left: true for
  $T'$ outside the domain, too
:reading: insertion_at_a_clamped_start_asks_for_another_point | with the $\alpha_i$ that the proof of lemma 4.2.1 prints, intervals
  closed on the right: then $\tau=t_1$ is excluded
:reading: clamped_end_may_be_inserted_again | with the same: and a $k$-fold right end may be inserted, which repeats $r_n$
:figure: nurbs_polygons_converge

With positive weights and $T'$ in the domain all new weights lie between the least and the greatest of the old ones; one knot
outside makes the weight of an end smaller, several also those next to it, and all stay positive.
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
  $r_1'=r_1$ with $\alpha_{1,k}(1)=\frac{\tau-t_1}{t_k-t_1}$ or $1$ and $r_{n+1}'=r_n$ with
  $\alpha_{n,k}(n+1)=\frac{t_{n+k}-\tau}{t_{n+k}-t_{n+1}}$ or $1$; and (4.1.8) is (4.1.2) on the domain
:method: (4.1.6) and both curves by their letter; signs are read off coefficients in the gaps.  The shares are
  quotients of sums of gaps, whose denominators contain a gap next to $\tau$; it stays positive when others are 0, so that the same is
  true of multiple knots.  More knots one after the other, by (4.1.7).
:types: field rational
:degrees: 1..6 sampled 7
:scope: the knots variables for $p\le3$, numbers above
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
            num sum = one;
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
:defines: nurbs_insert
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
:::{claim} knot_at_a_k_fold_end_has_no_shares
:title: A knot inserted at a k-fold right end makes a point without shares
:zh: 在 k 重右端点嵌入节点所得顶点无意义
:kind: counterexample
:given: the knots $T$ of one linear segment, whose last knot is inserted again; weights $w$; the last of the new points, number $j$
:data: T = 0 0 2 2; T' = 2; w = 1 1
:instead: T' = 1
:then: all $\alpha_{i,2}(j)$ vanish, and so does $w_j^{(T,T')}$
:result: w_3^(T,T') = 0
:method: (4.1.6) by its letter.
:control: the inserted knot inside
:::
*/
CLAIM(knot_at_a_k_fold_end_has_no_shares)
{
    struct G(refinement) r;
    num w[2];
    G(given_refinement)(T, 1, 4, 1, &r);
    given_points(T, "w", 2, 1, w);
    num sum = G(new_weight)(1, &r, w, r.m - 1);
    found(T, "w_3^(T,T')", sum);
    about(T, "the new weight is positive");
    agree(T, sign_q(sum) > 0);
}

/*
:::{claim} knot_at_an_outer_end_has_no_shares
:title: A knot inserted at a single first or last knot makes a point without shares
:zh: 在单重首末节点处嵌入节点所得顶点无意义
:kind: counterexample
:given: simple knots $T$ of a quadratic curve, weights $w$; $\tau_1$, the first knot, is inserted again, and then instead of it $\tau_2$, the
  last; the first of the new points, and the last
:data: T = 0 1 2 3 4 5; τ = 0 5; w = 1 1 1
:instead: τ = 1/2 9/2
:then: all $\alpha_{i,3}(j)$ of these two points vanish, and so do their weights
:result: w_1^(T,{τ_1}) = 0; w_4^(T,{τ_2}) = 0
:method: (4.1.6) by its letter.
:control: the inserted knots next to the ends, inside
:::
*/
CLAIM(knot_at_an_outer_end_has_no_shares)
{
    struct G(refinement) first, last;
    num u[6], tau[2], w[3];
    given_points(T, "T", 6, 1, u);
    given_points(T, "τ", 2, 1, tau);
    given_points(T, "w", 3, 1, w);
    G(refine_knots)(2, 6, u, 1, tau, &first);
    G(refine_knots)(2, 6, u, 1, tau + 1, &last);
    num first_weight = G(new_weight)(2, &first, w, 0), last_weight = G(new_weight)(2, &last, w, last.m - 1);
    found(T, "w_1^(T,{τ_1})", first_weight);
    found(T, "w_4^(T,{τ_2})", last_weight);
    about(T, "one of the new weights is positive");
    agree(T, (sign_q(first_weight) > 0) + (sign_q(last_weight) > 0) > fault(T, 1, 0));
}
#endif

/*
:::{statement} wang-ch4:formula-4.1.8
:title: The new points and weights belong to the same curve
:zh: 嵌入节点后曲线不变
:printed: r_k(t)=\sum_jN_{j,k}^{(T\oplus T')}(t)w_{j,k}^{(T,T')}r_{j,k}^{(T,T')}\Big/\sum_jN_{j,k}^{(T\oplus T')}(t)w_{j,k}^{(T,T')}
:holds-by: refined_data_give_the_same_curve discrete_bsplines_refine_the_basis
:reading: refined_data_give_the_same_curve | a knot of $T\oplus T'$ may become more than $k$-fold: still true, the new $N_{j,k}$ between its
  copies being zero; such $r_j$ do not count and are points of the curve
:hypothesis: knot_at_a_k_fold_end_has_no_shares | the points of (4.1.6) exist, as there; otherwise a term of the sum is
  $0\cdot\frac00$
:reading: knots_outside_the_domain_cut_corners | $T'$ outside the domain, in $(t_1,t_{n+k})$: true
:figure: insertions_commute
:::

:::{claim} discrete_bsplines_refine_the_basis
:title: The discrete B-splines express the old basis in the new one
:zh: 离散 B 样条把旧基表为新基的组合
:given: every pair of patterns $T$, $T'$ of the list, values variables, with knots inserted between knots and at knots, at the ends
  of the domain, up to the multiplicity $k$ and beyond; every interval of the domain, any $t$
:then: $N_{i,k}^{(T)}(t)=\sum_j\alpha_{i,k}^{(T,T')}(j)\,N_{j,k}^{(T\oplus T')}(t)$ for all $i$
:method: Both recursions by their letter.
:degrees: 1..6 sampled 6
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
:given: the same pairs; every $j$ with $v_j$ in the domain
:then: `bspline_discrete` gives $\alpha_{i,k}(j)$ for the $k$ values $i$ of the interval of $v_j$, and the others are $0$
:method: The kernel, one level for each new knot $v_{j+1},\dots,v_{j+k-1}$, against the recursion by its letter.
:degrees: 1..6 sampled 6
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

/*
## In several steps

:::{statement} wang-ch4:formula-4.1.7
:title: Inserting in two steps
:zh: 分两步嵌入节点
:printed: r_{j,k}^{(T,T')}=\sum_l\alpha_{l,k}^{(T\oplus T_1,T_2)}(j)w_{l,k}^{(T,T_1)}r_{l,k}^{(T,T_1)}\Big/
  \sum_l\alpha_{l,k}^{(T\oplus T_1,T_2)}(j)w_{l,k}^{(T,T_1)},\quad T'=T_1\oplus T_2
:holds-by: steps_of_refinement_compose discrete_bsplines_compose
:hypothesis: knot_at_a_k_fold_end_has_no_shares | the points of (4.1.6) exist, for $T_1$ and for $T'$, as there: a knot of $T_1$ at a
  $k$-fold right end gives an $r_l^{(T,T_1)}$ that is $\frac00$, and the sum has it
:figure: insertions_commute

The weights follow the same way, which the source does not print.
:::
*/

/* Triples T, T_1, T_2. */
static const char *const G(triples)[][16] = {
    {NULL},
    {"2002", "0100", "0010", "212", "010", "010", "202", "100", "110", "1011", "0200", "0010", NULL},
    {"3003", "0100", "0010", "303", "010", "010", "3103", "0100", "0010", "101111", "010000", "011010", "303", "100",
     "110", NULL},
    {"4004", "0100", "0010", "404", "020", "010", "4104", "0110", "0100", "2111111", "0200010", "0100010", NULL},
    {"50105", "01010", "00100", "4123", "0110", "0110", NULL},
    {"60206", "01010", "00110", NULL},
    {"70207", "01010", "00110", NULL},
};

/*
:::{claim} discrete_bsplines_compose
:title: The discrete B-splines of two steps multiply like matrices
:zh: 两步离散 B 样条按矩阵乘法复合
:given: triples $T$, $T_1$, $T_2$ of patterns, values variables, with equal knots in $T_1$ and $T_2$ among them, and with knots outside the
  domain
:then: $\alpha_{i,k}^{(T,T')}(j)=\sum_l\alpha_{l,k}^{(T\oplus T_1,T_2)}(j)\,\alpha_{i,k}^{(T,T_1)}(l)$ for all $i$ and $j$
:method: All by the recursion by its letter.
:degrees: 1..6 sampled 6
:control: $T_1$ and $T_2$ exchanged in the second factor only
:::
*/
CLAIM(discrete_bsplines_compose)
{
    int p = T->degree;
    struct G(refinement) whole_step, first, second;
    for (int k = 0; G(triples)[p][k] != NULL; k += 3) {
        const char *old = G(triples)[p][k], *one = G(triples)[p][k + 1], *two = G(triples)[p][k + 2];
        char between[MOST_KNOTS], both[MOST_KNOTS];
        G(union_of_patterns)(old, fault(T, one, two), between);
        G(union_of_patterns)(one, two, both);
        G(distinct_knots)(T, (int)strlen(old), 6, whole_step.x);
        first = second = whole_step;
        G(refine_pair)(old, both, p, &whole_step);
        G(refine_pair)(old, one, p, &first);
        G(refine_pair)(between, fault(T, two, one), p, &second);
        for (int i = 0; i < first.n; i++)
            for (int j = 0; j < whole_step.m; j++) {
                num sum = from_int(0);
                for (int l = 0; l < first.m; l++)
                    sum = add(sum, mul(G(alpha)(p, second.u, second.place, second.v, second.at, l, j),
                                       G(alpha)(p, first.u, first.place, first.v, first.at, i, l)));
                same(T, sum, G(alpha)(p, whole_step.u, whole_step.place, whole_step.v, whole_step.at, i, j));
            }
    }
}

/*
:::{claim} steps_of_refinement_compose
:title: Points and weights of two steps are those of one
:zh: 分步嵌入与一次嵌入所得顶点与权因子相同
:given: the same triples; points and weights
:then: (4.1.7), and the same for the weights
:method: (4.1.6) for one step and for two, all sums by their letter.
:degrees: 1..6 sampled 6
:control: the weights after the first step taken as 1
:::
*/
CLAIM(steps_of_refinement_compose)
{
    int p = T->degree;
    struct G(refinement) whole_step, first, second;
    for (int k = 0; G(triples)[p][k] != NULL; k += 3) {
        const char *old = G(triples)[p][k], *one = G(triples)[p][k + 1], *two = G(triples)[p][k + 2];
        char between[MOST_KNOTS], both[MOST_KNOTS];
        num R[MOST_KNOTS], w[MOST_KNOTS], S[MOST_KNOTS], z[MOST_KNOTS], S1[MOST_KNOTS], z1[MOST_KNOTS];
        num S2[MOST_KNOTS], z2[MOST_KNOTS];
        G(union_of_patterns)(old, one, between);
        G(union_of_patterns)(one, two, both);
        G(distinct_knots)(T, (int)strlen(old), 6, whole_step.x);
        first = second = whole_step;
        G(refine_pair)(old, both, p, &whole_step);
        G(refine_pair)(old, one, p, &first);
        G(refine_pair)(between, two, p, &second);
        G(weighted_points)(T, first.n, 1, R, w);
        G(refined_by_definition)
        (first.n, p, 1, whole_step.u, whole_step.place, R, w, whole_step.m, whole_step.v, whole_step.at, S, z);
        G(refined_by_definition)(first.n, p, 1, first.u, first.place, R, w, first.m, first.v, first.at, S1, z1);
        for (int l = 0; l < first.m; l++)
            z1[l] = fault(T, z1[l], from_int(1));
        G(refined_by_definition)(first.m, p, 1, second.u, second.place, S1, z1, second.m, second.v, second.at, S2, z2);
        for (int j = 0; j < whole_step.m; j++) {
            about(T, "the new points");
            same(T, S2[j], S[j]);
            about(T, "the new weights");
            same(T, z2[j], z[j]);
        }
    }
}

/*
:::{statement} wang-ch4:thm-4.1.1-geometry
:title: The theorem has a vivid geometric meaning
:zh: 定理 4.1.1 的几何意义
:printed: Theorem 4.1.1 has a vivid geometric meaning, as theorem 2.10.2 has
:holds-by: insertion_cuts_the_corners insertions_commute
:figure: insertions_commute

Read as: knots may be inserted one after the other and in any order; each step puts new points on the edges of the polygon before and
cuts its corners; after $k-1$ of them a corner is a point of the curve.  Section 2.10 is not at hand.
:::

:::{claim} insertions_commute
:title: Two knots may be inserted in either order
:zh: 两个节点的嵌入次序可交换
:given: $T=\{x_0^k,x_1^m,x_4^k\}$, $0\le m<k$, and two knots $x_1$ or $x_2$, and $x_3$; points and weights
:then: the points, weights and knots are the same
:method: The kernel `nurbs_insert` twice, in both orders, for every $m$.
:degrees: 1..6 sampled 7
:control: the second order with another second knot
:::
*/
CLAIM(insertions_commute)
{
    int p = T->degree, place[MOST_KNOTS];
    for (int m = 0; m <= p; m++)
        for (int at_knot = 0; at_knot <= (m > 0); at_knot++) {
            char pattern[] = {(char)('1' + p), (char)('0' + m), '0', '0', (char)('1' + p), '\0'};
            num x[5], u[MOST_KNOTS], R[MOST_KNOTS], w[MOST_KNOTS], v[2][MOST_KNOTS], S[2][MOST_KNOTS], z[2][MOST_KNOTS];
            G(distinct_knots)(T, 5, 6, x);
            int n = G(knots_at)(pattern, x, u, place) - p - 1, mu = p + m;
            num first = x[at_knot ? 1 : 2], last = x[3];
            G(weighted_points)(T, n, 1, R, w);
            for (int order = 0; order < 2; order++) {
                num one = order == 0 ? first : last, two = order == 0 ? last : first;
                num v1[MOST_KNOTS], S1[MOST_KNOTS], z1[MOST_KNOTS];
                if (T->faulty && order == 1)
                    two = add(two, from_int(1));
                G(nurbs_insert)(nurbs(p, n, 1, u, R, w), mu, one, v1, S1, z1);
                /* The smaller knot first: then the larger lies one span further; not so the other way. */
                G(nurbs_insert)
                (nurbs(p, n + 1, 1, v1, S1, z1), order == 0 ? mu + 1 : mu, two, v[order], S[order], z[order]);
            }
            about(T, "the knots");
            for (int i = 0; i <= n + p + 2; i++)
                same(T, v[1][i], v[0][i]);
            for (int j = 0; j < n + 2; j++) {
                about(T, "the weights");
                same(T, z[1][j], z[0][j]);
                about(T, "the points");
                same(T, S[1][j], S[0][j]);
            }
        }
}

/*
:::{claim} insertion_cuts_the_corners
:title: Each inserted knot cuts corners of the polygon
:zh: 每嵌入一个节点即割去控制多边形的若干角
:given: one knot $\tau$ strictly inside an interval between simple knots, positive gaps and weights
:let: $s_i=a_iw_i/(a_iw_i+(1-a_i)w_{i-1})$ with $a_i=(\tau-t_i)/(t_{i+k-1}-t_i)$
:then: the $k-1$ new points are $(1-s_i)r_{i-1}+s_ir_i$ with $0\le s_i\le1$, the others are old ones
:method: The kernel; signs are read off coefficients.
:degrees: 1..6 sampled 7
:control: $s_i$ without the weights
:::
*/
CLAIM(insertion_cuts_the_corners)
{
    int p = T->degree, mu = p, n = p + 1;
    num u[MOST_KNOTS], R[MOST_KNOTS], w[MOST_KNOTS], v[MOST_KNOTS], S[MOST_KNOTS], z[MOST_KNOTS];
    G(increasing_knots)(T, 2 * p + 2, 6, u);
    G(weighted_points)(T, n, 1, R, w);
    num one = from_int(1), knot = add(u[mu], mul(sub(u[mu + 1], u[mu]), inside(T, "s")));
    G(nurbs_insert)(nurbs(p, n, 1, u, R, w), mu, knot, v, S, z);
    about(T, "the old points");
    same(T, S[0], R[0]);
    same(T, S[n], R[n - 1]);
    for (int i = 1; i < n; i++) {
        num a = div(sub(knot, u[i]), sub(u[i + p], u[i])), right = mul(a, w[i]), left = mul(sub(one, a), w[i - 1]);
        num s = fault(T, div(right, add(left, right)), a);
        about(T, "s_i is in [0, 1]");
        nonnegative(T, s);
        nonnegative(T, sub(one, s));
        about(T, "the new point");
        same(T, S[i], add(mul(sub(one, s), R[i - 1]), mul(s, R[i])));
    }
}

/*
## The curve itself (曲线上的点)

Insert one knot often enough and a new point is the point of the curve.

:::{statement} wang-ch4:formula-4.1.9
:title: After the (k-1)-fold insertion of t' a control point is the point of the curve
:zh: k-1 次嵌入 t' 后,曲线上的点即控制顶点
:printed: $r_k(t')=r_{\mu,k}^{(T,\{t'\}^{k-1})}$ for $t'$ of the interval of the theorem, which is read as $(t_\mu,t_{\mu+1}]$
:holds-by: repeated_insertion_reaches_the_curve
:hypothesis: left_value_at_a_k_fold_knot | inside the domain $t'$ is at most a $(k-1)$-fold knot of $T$: at a $k$-fold one $r_\mu$ is the
  limit of the curve from the left
:hypothesis: clamped_start_has_no_such_point | $t'>t_k$ when $t_k$ is a $k$-fold knot: there $\mu=0$, and there is no
  $r_0$; or, if copies of $t_k$ follow on an earlier $t_1$, it is the left limit, from outside the domain
:reading: right_value_with_the_other_interval | with $t'\in[t_\mu,t_{\mu+1})$, the intervals of algorithm 4.1.1: true for every
  multiplicity $0,\dots,k$ and at $t_k$, where the value is the limit from the right; the end $t_{n+1}$ is then not included
:reading: fewer_insertions_suffice | if more than $k$ equal knots are not allowed: for a knot of multiplicity $m$ insert it $k-1-m$
  times; true with the same $\mu$
:figure: insertion_to_the_curve
:striking: 41

For $m\ge2$ the printed $k-1$ insertions make $t'$ more than $k$-fold, and some of the new B-splines are zero.  The points
$r_\mu,\dots,r_{\mu+m}$ then coincide if $m\le k-1$.
:::
*/

/* T with t' = x_where of multiplicity m, and t' inserted `times` times; x_1 is then the beginning of the domain. */
static void G(repeated)(int p, int where, int m, int times, struct G(refinement) * r)
{
    char old[] = {(char)('1' + p), '1', '1', '1', (char)('1' + p), '\0'}, new[] = "00000";
    old[where] = (char)('0' + m);
    if (where == 1)
        old[0] = (char)('1' + p - m);
    new[where] = (char)('0' + times);
    G(refine_pair)(old, new, p, r);
}

/* The number of knots of T at places below the given one. */
static int G(knots_below)(const struct G(refinement) * r, int place)
{
    int below = 0;
    for (int i = 0; i < r->count; i++)
        below += r->place[i] < place;
    return below;
}

/*
:::{claim} repeated_insertion_reaches_the_curve
:title: The point with the index of (4.1.9) is the point of the curve, for every multiplicity below k
:zh: 对每个小于 k 的重数 (4.1.9) 成立
:given: $T$ with the ends $x_0^k$, $x_4^k$, simple knots $x_1$, $x_3$ and $x_2=t'$ of every multiplicity $m=0,\dots,k-1$, values
  variables; points and weights; also $t'=x_4$, the $k$-fold right end, with the first $\mu$ points, and $t'=x_1$ of the
  multiplicity $1,\dots,k-1$ after $x_0^{k-m}$, the beginning of the domain
:then: $r_\mu^{(T,\{t'\}^{k-1})}=r(t')$, and so are $r_{\mu+1},\dots,r_{\mu+m}$; the values from both sides agree
:method: (4.1.6) by its letter, against (4.1.2) on the intervals of the domain on the left and on the right; $\mu$ is the number of
  knots before $t'$.
:degrees: 0..6 sampled 6
:scope: the knots variables for $p\le5$, numbers above
:control: $r_{\mu-1}$, or $r_2$ where $\mu=1$
:::
*/
CLAIM(repeated_insertion_reaches_the_curve)
{
    int p = T->degree;
    struct G(refinement) r;
    num R[MOST_KNOTS], w[MOST_KNOTS], S[MOST_KNOTS], z[MOST_KNOTS], value, right;
    G(distinct_knots)(T, 5, 5, r.x);
    for (int m = -p; m <= p + 1; m++) { /* first the beginning, last the right end of the domain */
        int start = (m < 0), end = (m > p), where = start ? 1 : end ? 4 : 2, many = start ? -m : m;
        G(repeated)(p, where, many, p, &r);
        G(weighted_points)(T, r.n, 1, R, w);
        int mu = G(knots_below)(&r, where); /* the printed index, from 1 */
        G(refined_by_definition)(r.n, p, 1, r.u, r.place, R, w, end ? mu : r.m, r.v, r.at, S, z);
        G(nurbs_by_definition)(r.n, p, 1, r.u, r.place, R, w, start ? where : where - 1, r.x[where], &value);
        about(T, start ? "r_mu and the curve from the right" : "r_mu and the curve from the left");
        same(T, S[fault(T, mu - 1, mu > 1 ? mu - 2 : 1)], value);
        if (where == 2) {
            G(nurbs_by_definition)(r.n, p, 1, r.u, r.place, R, w, where, r.x[where], &right);
            about(T, "both sides");
            same(T, value, right);
        }
        about(T, "the other points at t'");
        for (int j = mu + 1; j <= mu + many && !end; j++)
            same(T, S[j - 1], value);
    }
}

/*
:::{claim} fewer_insertions_suffice
:title: An m-fold knot has to be inserted k-1-m times only
:zh: m 重节点只需再嵌入 k-1-m 次
:given: the same knots; $m=0,\dots,k-1$
:then: $r_\mu^{(T,\{t'\}^{k-1-m})}=r(t')$
:method: As before; for $m=k-1$ nothing is inserted, and $r_\mu$ is an old point.
:degrees: 1..6 sampled 6
:scope: the knots variables for $p\le5$, numbers above
:control: one insertion less, for $m<k-1$
:::
*/
CLAIM(fewer_insertions_suffice)
{
    int p = T->degree;
    struct G(refinement) r;
    num R[MOST_KNOTS], w[MOST_KNOTS], S[MOST_KNOTS], z[MOST_KNOTS], left;
    G(distinct_knots)(T, 5, 5, r.x);
    for (int m = 0; m <= p; m++) {
        G(repeated)(p, 2, m, fault(T, p - m, m < p ? p - m - 1 : p - m), &r);
        G(weighted_points)(T, r.n, 1, R, w);
        G(refined_by_definition)(r.n, p, 1, r.u, r.place, R, w, r.m, r.v, r.at, S, z);
        G(nurbs_by_definition)(r.n, p, 1, r.u, r.place, R, w, 1, r.x[2], &left);
        same(T, S[G(knots_below)(&r, 2) - 1], left);
    }
}

/*
:::{claim} right_value_with_the_other_interval
:title: With the index of the interval that begins at or before t' the point is the limit from the right
:zh: 取 t'∈[t_μ,t_{μ+1}) 时得到右极限
:given: the same knots, $m=0,\dots,k$; also $t'=x_0$, the $k$-fold left end; $\mu$ the number of knots up to $t'$
:then: $r_\mu^{(T,\{t'\}^{k-1})}=r(t'+)$
:method: As before.
:degrees: 1..6 sampled 6
:scope: the knots variables for $p\le5$, numbers above
:control: the value from the left
:::
*/
CLAIM(right_value_with_the_other_interval)
{
    int p = T->degree;
    struct G(refinement) r;
    num R[MOST_KNOTS], w[MOST_KNOTS], S[MOST_KNOTS], z[MOST_KNOTS], value;
    G(distinct_knots)(T, 5, 5, r.x);
    for (int m = 0; m <= p + 2; m++) {
        int start = m > p + 1, where = start ? 0 : 2; /* the last case is the left end */
        G(repeated)(p, where, start ? p + 1 : m, p, &r);
        G(weighted_points)(T, r.n, 1, R, w);
        G(refined_by_definition)(r.n, p, 1, r.u, r.place, R, w, r.m, r.v, r.at, S, z);
        int side = fault(T, where, !start ? where - 1 : where);
        G(nurbs_by_definition)(r.n, p, 1, r.u, r.place, R, w, side, r.x[where], &value);
        same(T, S[G(knots_below)(&r, where + 1) - 1], value);
    }
}

#if RATIONAL
/*
:::{claim} left_value_at_a_k_fold_knot
:title: At a k-fold knot the printed index gives the limit from the left
:zh: k 重节点处所印指标给出左极限
:kind: counterexample
:given: a linear curve of the points $r$ and weights $w$ over the knots $T$, and $t'$, a twofold one of them, which is inserted again;
  $t'\in(t_\mu,t_{\mu+1}]$
:data: T = 0 0 1 1 2 2; T' = 1; r = (0,0) (1,1) (2,1) (3,0); w = 1 1 1 1
:instead: T = 0 0 1 3/2 2 2
:then: $r_\mu^{(T,\{t'\})}$ is the limit from the left, while $r(t')$, by the half-open intervals of the definition, is that from the right
:result: μ = 2; r_μ after the insertion = (1,1); r(t') = (2,1)
:method: (4.1.6) and (4.1.2) by their letter.
:control: the second of the two equal knots moved to the right
:::
*/
CLAIM(left_value_at_a_k_fold_knot)
{
    struct G(refinement) r;
    num R[8], w[4], S[10], z[5], P[2];
    G(given_refinement)(T, 1, 6, 1, &r);
    given_points(T, "r", 4, 2, R);
    given_points(T, "w", 4, 1, w);
    G(refined_by_definition)(r.n, 1, 2, r.u, r.place, R, w, r.m, r.v, r.at, S, z);
    G(nurbs_by_definition)(r.n, 1, 2, r.u, r.place, R, w, r.at[2], r.v[2], P);
    int mu = G(knots_below)(&r, r.at[2]);
    found_whole(T, "μ", mu);
    found_points(T, "r_μ after the insertion", 1, 2, S + 2 * (mu - 1));
    found_points(T, "r(t')", 1, 2, P);
    about(T, "r_μ and the curve");
    for (int c = 0; c < 2; c++)
        same(T, S[2 * (mu - 1) + c], P[c]);
}

/*
:::{claim} clamped_start_has_no_such_point
:title: At a k-fold left end the printed index is 0
:zh: 左端为 k 重节点时所印指标为零
:kind: counterexample
:given: the knots $T$ of one quadratic segment after any smaller knot $t_0$; $t'=t_k$, the left end of the domain
:data: T = 0 0 0 1 1 1
:instead: T = -1 0 0 1 1 1
:then: $t'\in(t_0,t_1]$, so that $\mu$ is not the number of a point: points are numbered from 1
:result: t' = 0; μ = 0
:method: $\mu$ is the number of knots before $t'$.
:control: the first knot smaller than the others
:::
*/
CLAIM(clamped_start_has_no_such_point)
{
    enum { k = 3 };
    num u[2 * k];
    int mu = 0;
    given_points(T, "T", 2 * k, 1, u);
    while (compare_q(u[mu], u[k - 1]) < 0)
        mu++;
    found(T, "t'", u[k - 1]);
    found_whole(T, "μ", mu);
    about(T, "μ is the index of a point");
    agree(T, mu >= 1);
}

/*
:::{statement} wang-ch4:thm-4.1.1-index
:title: The interval of the theorem
:zh: 定理 4.1.1 中 t' 所在区间的下标
:printed: Let $t'\in(t_u,t_{u+1}]$; then $r_k(t')=r_{\mu,k}^{(T,\{t'\}^{k-1})}$
:class: misprint
:refuted-by: index_of_another_interval_is_another_point
:corrected: $t'\in(t_\mu,t_{\mu+1}]$
:corrected-by: repeated_insertion_reaches_the_curve
:figure: insertion_to_the_curve

As printed nothing ties $\mu$ to the interval; $u$ does not occur again in 4.1.  The proof of lemma 4.2.1 has $\mu$ in both places.
:::

:::{claim} index_of_another_interval_is_another_point
:title: With the index of another interval the vertex is another point
:zh: 下标与 t' 所在区间不符时得到另一点
:kind: counterexample
:given: a quadratic curve of the points $r$ and weights $w$ over the knots $T$; $t'$, inserted twice; and an index $\mu$ whose interval
  $(t_\mu,t_{\mu+1}]$ does not contain $t'$
:data: T = 0 0 0 1 2 2 2; T' = 1/2 1/2; r = (0,0) (0,2) (2,2) (2,0); w = 1 1 1 1; μ = 4
:instead: μ = 3
:then: $r_\mu^{(T,T')}$ is another point than $r(t')$
:result: r_μ after the insertions = (1/2,2); r(t') = (1/4,3/2)
:method: (4.1.6) and (4.1.2) by their letter.
:control: the index of the interval that contains $t'$
:::
*/
CLAIM(index_of_another_interval_is_another_point)
{
    struct G(refinement) r;
    num R[8], w[4], S[12], z[6], P[2];
    G(given_refinement)(T, 2, 7, 2, &r);
    given_points(T, "r", 4, 2, R);
    given_points(T, "w", 4, 1, w);
    const num *vertex = S + 2 * (given_whole(T, "μ") - 1);
    G(refined_by_definition)(r.n, 2, 2, r.u, r.place, R, w, r.m, r.v, r.at, S, z);
    G(nurbs_by_definition)(r.n, 2, 2, r.u, r.place, R, w, r.at[3], r.v[3], P);
    found_points(T, "r_μ after the insertions", 1, 2, vertex);
    found_points(T, "r(t')", 1, 2, P);
    about(T, "r_μ is the point of the curve");
    agree(T, equal_q(vertex[0], P[0]) && equal_q(vertex[1], P[1]));
}
#endif

/*
:::{statement} wang-ch4:thm-4.1.1
:title: The discrete structure of NURBS curves
:zh: NURBS 曲线的离散结构
:printed: Let $t'\in(t_u,t_{u+1}]$, read as $(t_\mu,t_{\mu+1}]$, $T'=T_1\oplus T_2$, and let the new points and weights be (4.1.6): then (4.1.7), (4.1.8) and (4.1.9)
:holds-by: steps_of_refinement_compose refined_data_give_the_same_curve repeated_insertion_reaches_the_curve
:hypothesis: knot_at_a_k_fold_end_has_no_shares | for (4.1.6): $T'$ in $(t_1,t_{n+k})$, or at $t_1$ when $t_1=t_k$
:hypothesis: left_value_at_a_k_fold_knot | for (4.1.9): inside the domain $t'$ is at most a $(k-1)$-fold knot
:hypothesis: clamped_start_has_no_such_point | for (4.1.9): $t'>t_k$ when $t_k$ is a $k$-fold knot
:needs: negative_weight_loses_a_new_point | positive weights
:figure: insertion_to_the_curve
:::
*/
#include "chapters/judge/claims_off.h"
