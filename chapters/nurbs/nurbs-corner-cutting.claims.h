/*
# A convex polygon with its corners cut (割角保凸)

A polygon is convex when the triangles of its vertices, three at a time and in order, have one sign.  This makes a proof without limits
possible.  Let $D_{ijl}$ be twice the signed area of the triangle $r_ir_jr_l$ and
let $M$ be the matrix of an insertion, which makes the new homogeneous points out of the old: row $i$ has $1-\alpha_i$ in
column $i-1$ and $\alpha_i$ in column $i$.  By Cauchy and Binet

$$w'_aw'_bw'_c\,D'_{abc}=\sum_{i<j<l}M\begin{pmatrix}a&b&c\\i&j&l\end{pmatrix}w_iw_jw_l\,D_{ijl},$$

and no minor of $M$ is negative.  So where all $D_{ijl}$ have one sign, the new ones have it too.
*/
#include "chapters/nurbs/convexity.h"
#include "chapters/nurbs/discrete.h"

#include <stdio.h>

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch4:lemma-4.2.1
:title: A convex polygon stays convex when knots are inserted
:zh: 嵌节点保持控制多边形的凸性
:printed: let $\Phi$ be the empty set, and let the initial control polygon $\Gamma_k^{(T)}(\Phi)$ of the plane NURBS curve (4.1.2) be a convex curve; then for every
  finite set $T'$ of knots $\Gamma_k^{(T)}(T')$ is a convex curve, too, and $A(\Gamma_k^{(T)}(\Phi))\supseteq A(\Gamma_k^{(T)}(T'))$
:holds-by: insertion_turns_like_its_triangles triangles_of_one_sign_make_a_polygon_convex
  insertion_ratios_are_between_zero_and_one printed_factors_are_the_discrete_shares knots_outside_the_domain_cut_corners
  inserted_points_divide_the_edges clamped_start_inserted_again_repeats_the_first_point steps_of_refinement_compose weights_of_both_steps_are_positive
  knots_above_k_fold_repeat_new_points
:confirmed-by: printed_insertion_keeps_the_curve
:hypothesis: polygon_that_turns_back_loses_convexity | the polygon runs through part of the boundary of a convex set once; that it
  is there as a set is not enough
:hypothesis: knot_at_a_k_fold_end_has_no_shares | every knot of $T'$ is in $(t_1,t_{n+k})$, or at $t_1$ where $t_1=t_k$: for (4.1.6)
:hypothesis: end_of_more_than_k_knots_has_no_shares | $t_n<t_{n+k}$: for (4.1.6)
:meant: section 4.1, which defines $\Gamma_k^{(T)}(T')$, and definition 4.2.1, which speaks of a set | The polygon of the points (4.1.6), and that its set of points is a convex curve.
:reading: knots_outside_the_domain_cut_corners | of (4.1.6), intervals closed on the left, for one knot outside the domain, too, over simple knots
:reading: triangle_with_a_lost_point_runs_back | that the new polygon, too, runs through part of the boundary of a convex set once, where a knot of $T$ is more than $k$-fold: it may turn back on a line
:reading: knot_before_the_domain_asks_for_another_point | of the factors of the proof, for a knot before or behind the domain: an edge $r_0r_1$ or $r_nr_{n+1}$ would be needed
:reading: insertion_at_a_clamped_start_asks_for_another_point | of the factors of the proof, intervals closed on the right, for a $k$-fold $t_1$: it cannot be inserted
  again
:needs: mixed_weights_cut_beside_the_edges | definition 4.1.1: $w_i>0$ | the weights are positive
:argued: straight polygons, every order and every number of points and knots | The knots are inserted one after the other, by (4.1.7), and the triangles and the
  identities of one insertion are the same for every order and every number of points.  If the new points are on one line, so are the old ones: of
  these $r_1$, then $r_2$ and so on up to the last or $r_\mu$ are found from $r'_1,r'_2,\dots$, whose $\alpha_i$ are positive, and those behind are new ones; where
  a point is repeated, all are.  So where not all triangles are 0, not all new ones are.  Where all triangles are 0, the polygon goes straight on; its
  new vertices are on its edges, one on each and in their order, so that the new polygon does.  A knot that becomes more than $k$-fold by the insertion repeats a point, and one of the equal points is
  without a share afterwards.  Where a knot of $T$ is more than $k$-fold, points without a share are left out first: the triangles of the others are among the old ones, and where
  all of these are 0, all new points are on one line, and the polygon is as a set a segment or a point.  The new vertices being on edges of the polygon before, they are in its hull, which is $A$.
:figure: cutting_corners

$T'$ is a multiset.  Where no knot of $T$ is more than $k$-fold, the new polygon runs through part of the boundary once, too.
:::
*/

/*
The source proves the lemma knot by knot, with formulas of its own for one insertion. They have to be decided first: that they
give the same curve, that their factors lie between $0$ and $1$, and for which knots they ask for points that exist.

:::{claim} printed_insertion_keeps_the_curve
:title: The printed points, weights and knots give the same curve
:zh: 所印嵌入公式不改变曲线
:given: orders $k=1,\dots,6$ (sampled to $7$): $2k+1$ knots, for $k\le4$ every pattern of them, none more than $k$-fold, for $k>4$ simple ones; both ends of
  multiplicity $k$ and one knot between, of any multiplicity $1,\dots,k$; $\tau$ inside any interval of the domain, or any knot of the domain but $t_1$
:let: $c_i$ any numbers, weights equal
:then: $\sum_iN_{i,k}(t)c_i=\sum_iN'_{i,k}(t)c'_i$ on every interval of the domain, $c'_i=(1-\alpha_i)c_{i-1}+\alpha_ic_i$ with the
  printed $\alpha_i$
:method: Both sums by the recursion of de Boor and Cox as it is defined; $\tau$, $t$, $c_i$ and the distinct knots are
  variables.  The coordinates $w_ix_i$, $w_iy_i$, $w_i$ of the homogeneous points are such $c_i$, so that with
  `inserted_points_divide_the_edges` it holds for any weights.
:degrees: k = 1..6 sampled 7
:scope: every pattern of 2k+1 at most k-fold knots up to order 4, simple ones above, and clamped ends with one knot between; the distinct knots variables up to order 5,
  numbers above
:control: $\alpha_i$ taken with $t_{i+k}$ for $t_{i+k-1}$
:::
*/
static void G(compare_curves)(trial *T, int k, const struct G(knot_vector) * K, int place)
{
    int n = K->count - k;
    struct G(knot_vector) V;
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
    for (int m = 0, next; (next = G(pattern_of_insertion)(k, m, pattern)) > 0; m = next) {
        struct G(knot_vector) K = G(pattern)(T, pattern);
        G(numbers_for_knots)(k, &K);
        for (int place = K.place[k]; place <= K.place[K.count - k + 1]; place += 2) /* knots, and numbers between */
            if (place > K.place[1])
                G(compare_curves)(T, k, &K, place);
    }
}

/*
:::{claim} printed_factors_are_the_discrete_shares
:title: The factors of lemma 4.2.1 are the discrete B-splines of one knot
:zh: 所印因子即单节点的离散 B 样条
:given: $2k+1$ knots, for $k\le4$ every pattern of them, none more than $k$-fold, for $k>4$ simple ones; both ends of multiplicity $k$ and one knot between, of any
  multiplicity $1,\dots,k$; $\tau$ inside any interval between $t_1$ and $t_{n+k}$, or a knot there of a multiplicity below $k$; the factors $\alpha_j$ that the proof of lemma 4.2.1 prints
:then: for $1\le i\le n$ and $1\le j\le n+1$, $\alpha_{i,k}^{(T,\{\tau\})}(j)$ is $\alpha_j$ for $i=j$, $1-\alpha_j$ for $i=j-1$, and $0$ for all other $i$; so
  that (4.1.6) is the printed mean of two points, for $\tau$ outside the domain at the ends $r_1$ and $r_n$ alone
:method: The recursion of the discrete B-splines by its letter, intervals closed on the left, against the printed cases.
:degrees: k = 1..6 sampled 7
:scope: every pattern of 2k+1 at most k-fold knots up to order 4, simple ones above, and clamped ends with one knot between, the new knot of a multiplicity below k before; the distinct knots variables up to order 5, numbers above
:control: $\alpha_j$ and $1-\alpha_j$ exchanged
:::
*/
CLAIM(printed_factors_are_the_discrete_shares)
{
    int k = T->degree;
    char pattern[MOST_KNOTS];
    for (int m = 0, next; (next = G(pattern_of_insertion)(k, m, pattern)) > 0; m = next) {
        struct G(knot_vector) K = G(pattern)(T, pattern), V;
        int n = K.count - k;
        G(numbers_for_knots)(k, &K);
        for (int place = K.place[1] + 2; place < K.place[K.count]; place += 2) {
            num tau = G(number_at)(T, &K, place, "tau");
            int times = 0, mu = G(left_of)(&K, place);
            for (int i = 1; i <= K.count; i++)
                times += K.place[i] == place;
            if (times >= k)
                continue;
            for (int i = 1; i <= K.count + 1; i++) {
                V.t[i] = i <= mu ? K.t[i] : i == mu + 1 ? tau : K.t[i - 1];
                V.place[i] = i <= mu ? K.place[i] : i == mu + 1 ? place : K.place[i - 1];
            }
            for (int j = 1; j <= n + 1; j++) {
                num here = G(printed_alpha)(k, mu, K.t, tau, j), rest = sub(from_int(1), here);
                for (int i = 1; i <= n; i++) {
                    num share = i == j ? fault(T, here, rest) : i == j - 1 ? fault(T, rest, here) : from_int(0);
                    same(T, G(alpha)(k - 1, K.t + 1, K.place + 1, V.t + 1, V.place + 1, i - 1, j - 1), share);
                }
            }
        }
    }
}

/*
:::{claim} clamped_start_inserted_again_repeats_the_first_point
:title: At a k-fold knot, the start or an inner one, the points (4.1.6) repeat a point
:zh: k 重节点(左端或内节点)再嵌入时 (4.1.6) 重复一个顶点
:given: both ends of multiplicity $k$ and one knot between, of any multiplicity $1,\dots,k$; for $k\le4$ every pattern of $2k+1$ knots, too, none more than $k$-fold; $T'$ is $q$
  times a $k$-fold knot $t_s=t_{s+k-1}$ that is not the last, $q=1,\dots,k$
:then: $\alpha_{i,k}^{(T,T')}(j)$ is $1$ for $i=j$, $j<s$, and for $i=\max(s,j-q)$, $j\ge s$, and $0$ for all other $i$: $r_s$ is repeated $q$ times, the other points stay
:method: The recursion of the discrete B-splines by its letter, intervals closed on the left.
:degrees: k = 1..6 sampled 7
:scope: clamped ends with one knot of every multiplicity between, and every pattern of 2k+1 at most k-fold knots up to order 4
:control: $i=\max(s,j-q+1)$
:::
*/
/* The knot t_s = t_{s+k-1} is inserted q times. */
static void G(compare_with_a_repeated_point)(trial *T, int k, const struct G(knot_vector) * K, int s, int q)
{
    struct G(knot_vector) V = {.count = K->count + q};
    int n = K->count - k;
    for (int j = 1; j <= V.count; j++) {
        int old = j < s ? j : j - q > s ? j - q : s;
        V.t[j] = K->t[old];
        V.place[j] = K->place[old];
    }
    for (int j = 1; j <= n + q; j++)
        for (int i = 1; i <= n; i++) {
            int left = fault(T, q, q - 1), old = j < s ? j : j - left > s ? j - left : s;
            same(T, G(alpha)(k - 1, K->t + 1, K->place + 1, V.t + 1, V.place + 1, i - 1, j - 1), from_int(i == old));
        }
}

CLAIM(clamped_start_inserted_again_repeats_the_first_point)
{
    int k = T->degree;
    char pattern[MOST_KNOTS];
    for (int m = 1, next; (next = G(pattern_of_insertion)(k, m, pattern)) > 0; m = next) {
        struct G(knot_vector) K = G(pattern)(T, pattern);
        for (int s = 1; s <= K.count - k; s++)
            for (int q = 1; q <= k && K.place[s] == K.place[s + k - 1]; q++)
                G(compare_with_a_repeated_point)(T, k, &K, s, q);
    }
}

/*
:::{claim} insertion_ratios_are_between_zero_and_one
:title: The factors of lemma 4.2.1 are between 0 and 1
:zh: 0≤α_i≤1
:given: $\tau\in(t_\mu,t_{\mu+1}]$; an index $i=\mu-k+2+m$ for which the proof of lemma 4.2.1 prints a quotient as factor, $m\ge0$, and so $i+k-1=\mu+1+m$; the distances $a=t_\mu-t_i$, $b=\tau-t_\mu$, $c=t_{\mu+1}-\tau$ and
  $d=t_{i+k-1}-t_{\mu+1}$, with $b>0$ and each of the others positive or $0$
:let: $\alpha_i=\frac{\tau-t_i}{t_{i+k-1}-t_i}$
:harmless: with $b>0$ and each of the others positive | knots in order, of which the scope tells that $\tau$ is behind $t_\mu$
:then: $0<\alpha_i\le1$; and for $c=d=0$, as for $\tau=t_{\mu+1}$ and $m=0$, it is $\alpha_i=1$
:method: $\alpha_i=\frac{a+b}{a+b+c+d}$, whose divisor is not $0$, since $b>0$.  Nothing else of the knots enters, so this is for every $k$ and all knots,
  multiple ones among them.
:degrees: all
:scope: every knot, simple or multiple, with $t_\mu<\tau\le t_{\mu+1}$
:over: g# mu k m: -
:control: $i=\mu+1$ taken with the formula of the middle case
:::
*/
CLAIM(insertion_ratios_are_between_zero_and_one)
{
    num zero = from_int(0), one = from_int(1), gap[4];
    num mu = whole(T, "mu", 30, 40), k = whole(T, "k", 2, 20), m = whole(T, "m", 0, 9);
    num i = add(add(sub(mu, k), from_int(2)), m);
    about(T, "i + k - 1 = mu + 1 + m");
    same(T, sub(add(i, k), one), add(add(mu, one), m));
    for (int g = 0; g < 4; g++)
        gap[g] = positive(T, "g", g);
    for (int bits = 0; bits < 8; bits++) { /* which of a, c, d are not 0 */
        num a = bits & 1 ? gap[0] : zero, b = gap[1], c = bits & 2 ? gap[2] : zero, d = bits & 4 ? gap[3] : zero;
        num above = add(a, b), alpha = div(above, add(above, add(c, d)));
        alpha = fault(T, alpha, div(neg(gap[2]), gap[3])); /* i = mu+1: (tau - t_{mu+1}) / (t_{mu+k} - t_{mu+1}) */
        about(T, "the factor is positive and at most 1");
        G(must_be_positive)(T, alpha);
        nonnegative(T, sub(one, alpha));
        about(T, "the factor at a knot");
        if (!(bits & 2) && !(bits & 4))
            same(T, alpha, one);
    }
}

/*
Now the three new vertices are means of six old ones at most. The triangle of the new vertices is a combination of triangles of
the old ones, and the coefficients are minors of the matrix of the insertion. No drawing is needed, and no distinction of where
the corners are cut.

:::{claim} insertion_turns_like_its_triangles
:title: An insertion keeps the turn of the triangles where all turn one way
:zh: 嵌节点保持三角形转向
:given: $n$ points of the plane with weights; new homogeneous points, $1-\alpha_i$ times point $i-1$ plus $\alpha_i$ times point $i$, all $\alpha_i=\frac{a_i}{1+a_i}$ with $a_i>0$; the first and the last new point are the old one times a positive share, which is $1$,
  or less for a knot outside the domain
:then: the determinants of three new homogeneous points are sums of those of three old ones with the $3\times3$ minors of the matrix of
  the insertion; no minor is negative
:method: The equation, that of Cauchy and Binet, with all homogeneous coordinates variables; the minors by their coefficients, and again with $\alpha_i=0$
  or $\alpha_i=1$ in any of their rows.  With $n=6$ all cases of three rows occur.
:degrees: points = 3..6
:argued: every number of points | The equation is the formula of Cauchy and Binet; three rows have entries in six columns at most,
  and which of these coincide is decided by whether neighbouring rows follow one another.
:scope: every ratio of division, 0 and 1 among them
:over: a#: -; e#: shares of the ends; x#: homogeneous points
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

/* The minor is not negative either where one, two or all three of its rows have the ratio 0 or 1. */
static void G(minor_at_the_ends_of_the_ratios)(trial *T, int n, const num M[], int i, int j, int l, int a, int b, int c)
{
    int row[] = {i, j, l}, column[] = {a, b, c};
    for (int ends = 1; ends < 27; ends++) {
        num N[9];
        int inner = 1;
        for (int x = 0, code = ends; x < 3; x++, code /= 3) {
            inner &= code % 3 == 0 || (row[x] > 0 && row[x] < n);
            for (int y = 0; y < 3; y++) /* column row - 1 has 1 - alpha, column row has alpha */
                N[3 * x + y] = code % 3 == 0 ? M[row[x] * n + column[y]] : from_int(column[y] == row[x] - 2 + code % 3);
        }
        if (inner)
            nonnegative(T, G(minor)(3, N, 0, 1, 2, 0, 1, 2));
    }
}

CLAIM(insertion_turns_like_its_triangles)
{
    enum { SIZE = 7 };
    int n = T->degree;
    num M[SIZE * SIZE], H[3 * SIZE], N[3 * SIZE], one = from_int(1);
    for (int i = 0; i <= n; i++) {
        int end = i == 0 || i == n;
        num a = end ? positive(T, "e", i == n) : positive(T, "a", i), alpha = end ? a : div(a, add(one, a));
        for (int j = 0; j < n; j++)
            M[i * n + j] = j == i - 1 ? (end ? a : sub(one, alpha)) : j == i ? alpha : from_int(0);
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
                            G(minor_at_the_ends_of_the_ratios)(T, n, M, fault(T, i, j), fault(T, j, i), l, a, b, c);
                            sum = add(sum, mul(minor, G(det3)(H + 3 * a, H + 3 * b, H + 3 * c)));
                        }
                same(T, sum, G(det3)(N + 3 * i, N + 3 * j, N + 3 * l));
            }
}

#if RATIONAL
/*
The lemma is printed for any set of knots. By the cases of the proof, a knot to the left of the domain has a first factor less
than 1, and the rest belongs to a point before the first; to the right it is the same with a point behind the last. The formula (4.1.6) has no such term, since it sums over the points that
there are: the two parts of the source disagree about the knots outside the domain.

:::{claim} knot_before_the_domain_asks_for_another_point
:title: Knots outside the domain ask for points that are not there
:zh: 定义域外的节点
:kind: counterexample
:given: the simple knots $T$ of one quadratic segment, with the domain $[t_k,t_{n+1}]$; $\tau<t_k$ and $\sigma>t_{n+1}$; equal weights
:data: T = 1 2 3 4 5 6; τ = 3/2; σ = 11/2
:instead: τ = 7/2; σ = 7/2
:then: by the printed formula $r'_1=(1-\alpha_1)r_0+\alpha_1r_1$ for $\tau$, and $r'_{n+1}=(1-\alpha_{n+1})r_n+\alpha_{n+1}r_{n+1}$ for $\sigma$; the factors of $r_0$ and of $r_{n+1}$ are
  not $0$, and there are no such points
:result: factor of r_0 = 3/4; factor of r_{n+1} = 3/4
:method: $\alpha_1$ and $\alpha_{n+1}$ by the printed cases; that the factors of $r_0$ and $r_{n+1}$ are $0$ is what is asked for.
:control: $\tau$ and $\sigma$ in the domain
:::
*/
CLAIM(knot_before_the_domain_asks_for_another_point)
{
    num t[7];
    given_points(T, "T", 6, 1, t + 1);
    num tau = given(T, "τ"), sigma = given(T, "σ"); /* k = n = 3 */
    num before = sub(from_int(1), G(printed_alpha)(3, place_of(6, t, tau), t, tau, 1));
    num behind = G(printed_alpha)(3, place_of(6, t, sigma), t, sigma, 4);
    found(T, "factor of r_0", before);
    found(T, "factor of r_{n+1}", behind);
    about(T, "the factor of r_0 in the new first point, and 0");
    same(T, before, from_int(0));
    about(T, "the factor of r_{n+1} in the new last point, and 0");
    same(T, behind, from_int(0));
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
    about(T, "the factor of r_0 in the new first point, and 0");
    same(T, factor, from_int(0));
}

/*
:::{claim} triangle_with_a_lost_point_runs_back
:title: With a knot that is more than k-fold the points (4.1.6) of a triangle run to and fro
:zh: 节点超过 k 重时 (4.1.6) 丢失一个顶点
:kind: counterexample
:given: a linear curve of the points $r$, a closed triangle, and weights $w$ over the knots $T$, of which one is threefold; $T'$
:data: T = 0 1 1 1 2 3; r = (0,0) (1,0) (0,1) (0,0); w = 1 1 1 1; T' = 3/2
:instead: T = 0 1 1 7/4 2 3
:then: the polygon $r$ runs through a triangle once; $N_{2,2}=0$, and in the points $r'$ of (4.1.6) $r_2$ is left out: they run on one line, there and back
:result: r' = (0,0) (0,1) (0,1) (0,1/2) (0,0)
:method: (4.1.6) by its letter, intervals closed on the left; convexity by `exact/decide/hull.h`.
:control: the third of the equal knots moved to the right
:::
*/
CLAIM(triangle_with_a_lost_point_runs_back)
{
    struct G(refinement) f;
    num R[8], w[4], S[10], z[5];
    G(given_refinement)(T, 1, 6, 1, &f);
    given_points(T, "r", 4, 2, R);
    given_points(T, "w", 4, 1, w);
    G(refined_by_definition)(4, 1, 2, f.u, f.place, R, w, f.m, f.v, f.at, S, z);
    found_points(T, "r'", 5, 2, S);
    about(T, "the polygon running through its points once, so does the new one");
    refute(T, polygon_is_convex(3, R, 0, NULL) && !polygon_is_convex(4, S, 0, NULL));
}

/*
:::{claim} printed_points_keep_a_point_without_a_share
:title: With a knot that is more than k-fold the printed points are not those of (4.1.6)
:zh: 节点超过 k 重时所印顶点与 (4.1.6) 不同
:kind: counterexample
:given: a linear curve of the points $r$ and weights $w$ over the knots $T$, of which one is threefold; $T'$, one knot in the domain
:data: T = 0 1 1 1 2 3; r = (0,0) (1,0) (0,1) (0,0); w = 1 1 1 1; T' = 3/2
:instead: T = 0 1 1 7/4 2 3
:then: $N_{2,2}=0$; by the printed cases $r_2$ is the second of the new points, while in the points of (4.1.6) it is left out
:result: r' as printed = (0,0) (1,0) (0,1) (0,1/2) (0,0); r' of (4.1.6) = (0,0) (0,1) (0,1) (0,1/2) (0,0)
:method: The printed formulas; and (4.1.6) by its letter, intervals closed on the left.
:control: the third of the equal knots moved to the right
:::
*/
CLAIM(printed_points_keep_a_point_without_a_share)
{
    struct G(refinement) f;
    num t[7], R[10], w[5], v[8], P[12], y[6], S[10], z[5];
    G(given_refinement)(T, 1, 6, 1, &f);
    given_points(T, "r", 4, 2, R + 2);
    given_points(T, "w", 4, 1, w + 1);
    for (int i = 0; i < 6; i++)
        t[1 + i] = f.u[i];
    int mu = 0;
    while (equal_q(f.u[mu], f.v[mu]))
        mu++;
    G(printed_insertion)(4, 2, 2, t, mu, f.v[mu], R, w, v, P, y);
    G(refined_by_definition)(4, 1, 2, f.u, f.place, R + 2, w + 1, f.m, f.v, f.at, S, z);
    found_points(T, "r' as printed", 5, 2, P + 2);
    found_points(T, "r' of (4.1.6)", 5, 2, S);
    int different = 0;
    for (int c = 0; c < 10; c++)
        different |= !equal_q(P[2 + c], S[c]);
    about(T, "the printed points are those of (4.1.6)");
    refute(T, different);
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
:given: a cubic segment of the points $r$, a square, over the knots $T$, with weights $w$ of both signs for which $w(t)>0$; $\tau$ is inserted,
  which divides the edge $r_{i-1}r_i$ in the ratio $s_i:(1-s_i)$
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
:holds-by: inserted_points_divide_the_edges insertion_ratios_are_between_zero_and_one printed_factors_are_the_discrete_shares
  clamped_start_inserted_again_repeats_the_first_point steps_of_refinement_compose weights_of_both_steps_are_positive knots_above_k_fold_repeat_new_points
:needs: mixed_weights_cut_beside_the_edges | definition 4.1.1: $w_i>0$ | the weights are positive
:hypothesis: polygon_that_turns_back_loses_convexity | the polygon runs through its points once; else $A(\Gamma_k^{(T)}(T'))$
  need not exist; or $A$ is taken as the hull
:hypothesis: knot_at_a_k_fold_end_has_no_shares | every knot of $T'$ is in $(t_1,t_{n+k})$, or at $t_1$ where $t_1=t_k$: for (4.1.6)
:hypothesis: end_of_more_than_k_knots_has_no_shares | $t_n<t_{n+k}$: for (4.1.6)
:meant: section 4.1, which defines $\Gamma_k^{(T)}(T')$ | The polygon of the points (4.1.6).
:reading: knots_outside_the_domain_cut_corners | of (4.1.6), intervals closed on the left, for one knot outside the domain, too, over simple knots
:reading: knot_before_the_domain_asks_for_another_point | of the factors of the proof, for a knot before or behind the domain: an edge $r_0r_1$ or $r_nr_{n+1}$ would be needed
:reading: insertion_at_a_clamped_start_asks_for_another_point | of the factors of the proof, intervals closed on the right, for a $k$-fold $t_1$: it cannot be inserted
  again
:argued: | One knot after the other, by (4.1.7): the identities of one insertion have the knots as variables, and hold for equal ones, too, where they divide by no 0. The new vertices are on edges of the polygon before, hence in its hull, and the hull of points of a convex set is part of
  the set.  Where a knot is more than $k$-fold, they are on edges of the polygon without the points that have no share, whose hull is part of the hull of all.
:figure: hulls_of_knot_sets
:::

:::{claim} inserted_points_divide_the_edges
:title: The new point divides the edge in the ratio of the weighted factors
:zh: 新顶点按加权比分割边
:given: $0\le\alpha\le1$, written $\alpha=\frac a{1+a}$, or $0$, or $1$; positive weights $w_{i-1},w_i$; points $r_{i-1},r_i$
:let: $w'=(1-\alpha)w_{i-1}+\alpha w_i$, $s=\frac{\alpha w_i}{w'}$, $r'=(1-s)r_{i-1}+sr_i$
:then: $w'r'=(1-\alpha)w_{i-1}r_{i-1}+\alpha w_ir_i$; and
  $w'>0$, $s\ge0$, $1-s\ge0$
:method: Identities in the field, and signs of coefficients; for $\alpha=0$ and $\alpha=1$ also that $s=\alpha$.
:scope: every ratio of division, 0 and 1 among them
:over: a#: -; r#: points
:control: $s$ taken as $\alpha$, without weights
:::
*/
CLAIM(inserted_points_divide_the_edges)
{
    num one = from_int(1), a = positive(T, "a", 0), ratio[] = {div(a, add(one, a)), from_int(0), one};
    num w0 = positive(T, "w", 0), w1 = positive(T, "w", 1), r0 = unknown(T, "r", 0), r1 = unknown(T, "r", 1);
    for (int end = 0; end < 3; end++) { /* inside the edge, at its start and at its end */
        num alpha = ratio[end], rest = sub(one, alpha), weight, s = G(printed_ratio)(alpha, w0, w1, &weight);
        s = fault(T, s, alpha);
        num point = add(mul(sub(one, s), r0), mul(s, r1));
        same(T, weight, add(mul(rest, w0), mul(alpha, w1)));
        same(T, mul(weight, point), add(mul(mul(rest, w0), r0), mul(mul(alpha, w1), r1)));
        if (end > 0)
            same(T, s, alpha);
        G(must_be_positive)(T, weight);
        nonnegative(T, s);
        nonnegative(T, sub(one, s));
    }
}

/*
:::{statement} wang-ch4:lemma-4.2.1-step-points
:title: The points after one insertion
:zh: 嵌入一个节点后的顶点
:printed: for $T'=\{\tau_1\}$, $\tau_1\in(t_\mu,t_{\mu+1}]$, in imitation of (2.9.1): $\boldsymbol r_{i,k}^{(T,T')}=(1-s_i)\boldsymbol r_{i-1}+s_i\boldsymbol r_i$,
  $s_i=\alpha_iw_i/[(1-\alpha_i)w_{i-1}+\alpha_iw_i]$
:holds-by: inserted_points_divide_the_edges printed_factors_are_the_discrete_shares
:confirmed-by: printed_insertion_keeps_the_curve
:needs: vanishing_weight_loses_the_new_point | definition 4.1.1: $w_i>0$ | the weights are positive
:hypothesis: knot_before_the_domain_asks_for_another_point | $\tau_1$ is in the domain: before it the edge $r_0r_1$ is asked for, behind it $r_nr_{n+1}$
:hypothesis: insertion_at_a_clamped_start_asks_for_another_point | $\tau_1>t_1$
:hypothesis: printed_points_keep_a_point_without_a_share | no knot of $T$ is more than $k$-fold: else (4.1.6) leaves out a point whose B-spline is 0, which the printed cases keep
:reading: both_conventions_of_the_span_are_right | at a knot of multiplicity $k$ or more: the printed cases repeat another of two points than intervals closed on the left, by
  which (4.1.6) is read here
:figure: where_hypotheses_are_needed

The $\alpha_i$ are those of the three cases that are printed below (`lemma-4.2.1-step-alpha`).  The points are those of (4.1.6) for one knot, the new weights are the denominators.  (2.9.1) is not in the text at hand.
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
:holds-by: printed_insertion_keeps_the_curve printed_factors_are_the_discrete_shares inserted_points_divide_the_edges
:hypothesis: knot_before_the_domain_asks_for_another_point | $\tau_1$ is in the domain: before it the edge $r_0r_1$ is asked for, behind it $r_nr_{n+1}$
:hypothesis: insertion_at_a_clamped_start_asks_for_another_point | $\tau_1>t_1$
:hypothesis: printed_points_keep_a_point_without_a_share | no knot of $T$ is more than $k$-fold: else (4.1.6) leaves out a point whose B-spline is 0, which the printed cases keep
:reading: both_conventions_of_the_span_are_right | with $\tau_1\in[t_\mu,t_{\mu+1})$ instead, as in algorithm 4.1.1, the formula gives the same factors, or repeats another of two points
:figure: where_hypotheses_are_needed
:::

In one place the intervals are closed on the left, in another on the right. At a knot this changes $\mu$ by the multiplicity, but
hardly the factors: those that change from the middle case to an outer one are $0$ or $1$ in both. Only at a $k$-fold knot can one
see it in the points.

:::{claim} both_conventions_of_the_span_are_right
:title: At a knot, both conventions of the span give the same factors, or repeat one of two points
:zh: 两种区间约定
:given: order $k$; a knot $\tau=t_{\mu+1}=\dots=t_{\mu+m}$ of multiplicity $m=1,\dots,k+1$ between knots of multiplicity $1$ each
:then: for $m\le k-1$ the factors $\alpha_i$ with $(t_\mu,t_{\mu+1}]$ are those with $[t_{\mu+m},t_{\mu+m+1})$, for
  $2\le i\le n$; for $m\ge k$ the first repeats $r_\mu$, the second $r_{\mu+m-k+1}$
:method: All $\alpha_i$ by the printed cases, with the knots variables.
:degrees: k = 2..6
:scope: a multiple knot among simple ones
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
        struct G(knot_vector) K = G(pattern)(T, pattern);
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
:degrees: k = 2..6
:scope: clamped ends with two simple knots between
:control: $\tau=t_n$, in $(t_{n-1},t_n]$
:::
*/
CLAIM(clamped_end_may_be_inserted_again)
{
    int k = T->degree, n = k + 2, mu = fault(T, n, n - 1);
    char pattern[MOST_KNOTS];
    snprintf(pattern, sizeof pattern, "%d11%d", k, k);
    struct G(knot_vector) K = G(pattern)(T, pattern);
    for (int i = 1; i <= n + 1; i++)
        same(T, G(printed_alpha)(k, mu, K.t, K.t[mu + 1], i), from_int(i <= n));
}

/*
:::{statement} wang-ch4:lemma-4.2.1-step-unit
:title: The ratios are between 0 and 1
:zh: s_i ∈ [0,1]
:printed: s_i\in[0,1]
:holds-by: insertion_ratios_are_between_zero_and_one inserted_points_divide_the_edges
:needs: mixed_weights_cut_beside_the_edges | definition 4.1.1: $w_i>0$ | the weights are positive
:figure: mixed_weights_and_convexity

This is about the $s_i$ that exist.
:::

:::{statement} wang-ch4:lemma-4.2.1-step-inscribed
:title: The new polygon is inscribed in the old one
:zh: 内接折线
:printed: hence $\Gamma_k^{(T)}(T')$ is an inscribed polygon of $\Gamma_k^{(T)}(\Phi)$
:holds-by: insertion_ratios_are_between_zero_and_one inserted_points_divide_the_edges
:confirmed-by: insertion_cuts_the_corners
:needs: mixed_weights_cut_beside_the_edges | definition 4.1.1: $w_i>0$ | the weights are positive
:hypothesis: knot_before_the_domain_asks_for_another_point | $\tau_1$ is in the domain: before it the edge $r_0r_1$ is asked for, behind it $r_nr_{n+1}$
:hypothesis: insertion_at_a_clamped_start_asks_for_another_point | $\tau_1>t_1$
:figure: cutting_corners

By the formula of the proof the new vertex $i$ is on the edge $r_{i-1}r_i$, one on each edge, in the order of the edges; both ends stay.
:::

:::{statement} wang-ch4:lemma-4.2.1-step-first
:title: So the lemma is true for one knot
:zh: 归纳法第一步
:printed: $\Gamma_k^{(T)}(T')$ being inscribed in the convex curve $\Gamma_k^{(T)}(\Phi)$, the lemma is true for one knot; and by the same method, $\Gamma_k^{(T)}(T')$ being convex for
  $m-1$ knots, $\Gamma_k^{(T)}(T'')$ is convex for $m$
:holds-by: insertion_turns_like_its_triangles triangles_of_one_sign_make_a_polygon_convex
  insertion_ratios_are_between_zero_and_one inserted_points_divide_the_edges printed_factors_are_the_discrete_shares
  clamped_start_inserted_again_repeats_the_first_point knots_above_k_fold_repeat_new_points
:confirmed-by: inserted_polygons_stay_convex
:needs: mixed_weights_cut_beside_the_edges | definition 4.1.1: $w_i>0$ | the weights are positive
:hypothesis: polygon_that_turns_back_loses_convexity | the polygon does not turn back
:hypothesis: polygon_that_overlaps_itself_loses_convexity | the end of the polygon does not run over its start: not turning back
  is not enough for running through its points once
:hypothesis: knot_at_a_k_fold_end_has_no_shares | every knot of $T''$ is in $(t_1,t_{n+k})$, or at $t_1$ where $t_1=t_k$: for (4.1.6)
:hypothesis: end_of_more_than_k_knots_has_no_shares | $t_n<t_{n+k}$: for (4.1.6)
:meant: section 4.1, which defines $\Gamma_k^{(T)}(T')$, and definition 4.2.1, which speaks of a set | The polygon of the points (4.1.6), and that its set of points is a convex curve.
:reading: triangle_with_a_lost_point_runs_back | that the new polygon, too, runs through part of the boundary of a convex set once, where a knot of $T$ is more than $k$-fold: it may turn back on a line
:argued: straight polygons, every order and every number of points | The triangles and the identities of one insertion are the same for every order and every
  number of points.  If the new points are on one line, so are the old ones, as for the lemma: so where not all triangles are 0, not all new ones are.  Where all triangles are 0, the polygon goes straight on; its new vertices are on its edges, one on each and in
  their order, so that the new polygon does.  A knot that $T'$ has made more than $k$-fold repeats a point, and one of the equal points is without a share afterwards.
  Where a knot of $T$ is more than $k$-fold, points without a share are left out first: the triangles of the others are among the old ones, and where all of these are 0, all
  new points are on one line, and the polygon is as a set a segment or a point.  The new vertices being on edges of the polygon before, they are in its
  hull, which is $A$.
:figure: what_convex_must_mean
:::
*/

#if RATIONAL

/*
:::{claim} inserted_polygons_stay_convex
:title: Designed convex polygons stay convex, and their hulls decrease
:zh: 设计算例的保凸性与凸包递减
:kind: decision
:given: seven convex polygons, among them a closed one, one with collinear and repeated vertices, one that turns by more than a half
  turn; orders $2,3,4$; simple knots, clamped ends, inner knots of multiplicity $k-1$; weights $1$, $1000$ and $1$ in turn,
  $10^i$, and $\frac1{1000}$ inside; the multiples of $\frac12$ in the domain, $t_1$ left out, inserted $k$ times each, all knots of the domain among them
:then: after each insertion the polygon is convex with the same orientation, and every new vertex is on its edge of the polygon before
:method: The printed formulas in rationals, $\mu$ by comparing; convexity by `exact/decide/hull.h`; on the edge: no turn, and between the ends.
:degrees: k = 2..4
:scope: the stated curves
:harmless: seven convex polygons | they are the stated ones
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
One knot being inserted, the rest is said to be induction. It is, if the polygon that one insertion leaves is the control polygon
of the same curve over the knots with the new one, with its new weights, and if the order does not matter.

:::{statement} wang-ch4:lemma-4.2.1-step-induction
:title: Knots may be inserted one after the other
:zh: 归纳步
:printed: for $T'=\{\tau_1,\tau_2,\dots,\tau_{m-1}\}$ and $T''=T'\oplus\{\tau_m\}$: $\Gamma_k^{(T)}(T'')=\Gamma_k^{(T\oplus T')}(\{\tau_m\})$, and
  $\Gamma^{(T\oplus T')}(\Phi)=\Gamma_k^{(T)}(T')$
:holds-by: steps_of_refinement_compose weights_of_both_steps_are_positive nothing_inserted_changes_nothing
:confirmed-by: knots_are_inserted_in_any_order
:hypothesis: knot_at_a_k_fold_end_has_no_shares | every knot of $T''$ is in $(t_1,t_{n+k})$, or at $t_1$ where $t_1=t_k$: for (4.1.6)
:hypothesis: end_of_more_than_k_knots_has_no_shares | $t_n<t_{n+k}$: for (4.1.6)
:needs: negative_weight_loses_a_new_point | definition 4.1.1: $w_i>0$ | the weights are positive
:meant: section 4.1, by which such a polygon has the order as its index | The polygon $\Gamma_k^{(T\oplus T')}(\Phi)$, of which the $k$ is left out,
  see `notation-order`.
:figure: cutting_corners

The first is (4.1.7) for $T_1=T'$, $T_2=\{\tau_m\}$, the second (4.1.6) for the refined data with nothing inserted: both with the new weights, which the notation does
not show.  The sum $\oplus$ keeps multiplicities.
:::

:::{claim} knots_are_inserted_in_any_order
:title: Two insertions give the same points and weights in either order, and those of the Oslo algorithm
:zh: 嵌节点次序无关
:given: ends of multiplicity $k$ and two simple knots between; two new knots, in one interval, in different
  intervals, the same knot twice, or the knots of the curve themselves
:then: the printed insertion, once for each knot, gives the same points and weights in either order; the homogeneous points are those
  of `bspline_refine`
:method: The field, all knots, weights and points variables.
:degrees: k = 2..6 sampled 7
:scope: clamped ends with two simple knots between
:over: r#: points
:control: the second knot inserted with the weights of the old polygon
:::
*/
/* Inserts at two places, one after the other. */
static void G(insert_twice)(trial *T, int n, int k, int dim, const struct G(knot_vector) * K, const int place[2],
                            const num tau[2], const num r[], const num w[], struct G(knot_vector) * V, num S[], num z[])
{
    struct G(knot_vector) U;
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
    struct G(knot_vector) K = G(pattern)(T, pattern), V, U;
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
        G(bspline_refine)(spline(p, n, 2, K.t + 1, H), n + 2, V.t + 1, span, D);
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
:holds-by: inserted_points_divide_the_edges insertion_ratios_are_between_zero_and_one printed_factors_are_the_discrete_shares
  clamped_start_inserted_again_repeats_the_first_point steps_of_refinement_compose weights_of_both_steps_are_positive knots_above_k_fold_repeat_new_points
:hypothesis: polygon_that_turns_back_loses_convexity | the polygon runs through its points once: as for the lemma; else the $A$
  of a refined polygon need not exist; or $A$ is taken as the hull
:needs: mixed_weights_cut_beside_the_edges | definition 4.1.1: $w_i>0$ | the weights are positive
:hypothesis: knot_at_a_k_fold_end_has_no_shares | every knot of $T''$ is in $(t_1,t_{n+k})$, or at $t_1$ where $t_1=t_k$: for (4.1.6)
:hypothesis: end_of_more_than_k_knots_has_no_shares | $t_n<t_{n+k}$: for (4.1.6)
:meant: section 4.1, which defines $\Gamma_k^{(T)}(T')$ | The polygon of the points (4.1.6).
:reading: knots_outside_the_domain_cut_corners | of (4.1.6), intervals closed on the left, for one knot outside the domain, too, over simple knots
:reading: knot_before_the_domain_asks_for_another_point | of the factors of the proof, for a knot before or behind the domain: an edge $r_0r_1$ or $r_nr_{n+1}$ would be needed
:reading: insertion_at_a_clamped_start_asks_for_another_point | of the factors of the proof, intervals closed on the right, for a $k$-fold $t_1$: it cannot be inserted
  again
:argued: | One knot after the other, by (4.1.7): the new vertices are on edges of the polygon before, hence in its hull, and the hull of points of a convex set is part of
  the set.  Where a knot is more than $k$-fold, they are on edges of the polygon without the points that have no share, whose hull is part of the hull of all.
:figure: hulls_of_knot_sets
:::
*/

#include "chapters/judge/claims_off.h"
