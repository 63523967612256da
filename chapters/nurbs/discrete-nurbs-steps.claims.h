/*
# Knots inserted in steps, up to the curve (分步嵌入,曲线上的点)

Refining twice is refining once: the discrete B-splines of two steps multiply like the matrices that they are.  So knots may be inserted
one after the other and in any order, and what one insertion does, cut corners, is all that ever happens.  Insert one knot often
enough, and a corner is a point of the curve.  These are the three parts of theorem 4.1.1; the third, (4.1.9), names the vertex that
becomes the point, and what has to be decided about it is the index.
*/
#include "chapters/nurbs/definition.h"
#include "chapters/nurbs/discrete.h"
#include "chapters/nurbs/patterns.h"

#include "chapters/judge/claims_on.h"

/*
## In several steps

:::{statement} wang-ch4:formula-4.1.7
:title: Inserting in two steps
:zh: 分两步嵌入节点
:printed: r_{j,k}^{(T,T')}=\sum_l\alpha_{l,k}^{(T\oplus T_1,T_2)}(j)w_{l,k}^{(T,T_1)}r_{l,k}^{(T,T_1)}\Big/
  \sum_l\alpha_{l,k}^{(T\oplus T_1,T_2)}(j)w_{l,k}^{(T,T_1)},\quad T'=T_1\oplus T_2
:holds-by: steps_of_refinement_compose discrete_bsplines_compose weights_of_both_steps_are_positive
:needs: negative_weight_loses_a_new_point | definition 4.1.1: $w_i>0$ | the weights are positive: as for (4.1.6)
:hypothesis: knot_at_a_k_fold_end_has_no_shares | every knot of $T_1$ and $T_2$ is in $(t_1,t_{n+k})$, or at $t_1$ where $t_1=t_k$: in the example, whose $T'$ is $T_1$ here,
  the last $r_l^{(T,T_1)}$ is $\frac00$, and the sum has it
:hypothesis: end_of_more_than_k_knots_has_no_shares | $t_n<t_{n+k}$: in the example, too, $T'$ is $T_1$ here, and the last $r_l^{(T,T_1)}$ is $\frac00$
:figure: insertions_commute

The weights follow the same way, which the source does not print.
:::
*/

/* Triples T, T_1, T_2; for each degree one with equal knots in both steps, and one with knots outside the domain. */
static const char *const G(triples)[][16] = {
    {NULL},
    {"2002", "0100", "0010", "212", "010", "010", "202", "100", "110", "10111", "02000", "00110", NULL},
    {"3003", "0100", "0010", "303", "010", "010", "3103", "0100", "0010", "1011111", "0100000", "0110110", "303", "100",
     "110", NULL},
    {"4004", "0100", "0010", "404", "020", "010", "4104", "0110", "0100", "2111111", "0200010", "0100010", NULL},
    {"50105", "01010", "00100", "4123", "0110", "0110", "203302", "010010", "010000", NULL},
    {"60206", "01010", "00110", "204402", "010010", "010000", NULL},
    {"70207", "01010", "00110", "205502", "010010", "010000", NULL},
};

/*
Equal knots may stand in both steps, and a knot may be inserted where the first step has put one. The proof of the source has to
speak about multisets there; a product of matrices has no such cases.

:::{claim} discrete_bsplines_compose
:title: The discrete B-splines of two steps multiply like matrices
:zh: 两步离散 B 样条按矩阵乘法复合
:given: triples $T$, $T_1$, $T_2$ of patterns, values variables, with equal knots in $T_1$ and $T_2$ among them, and with knots outside the
  domain
:then: $\alpha_{i,k}^{(T,T')}(j)=\sum_l\alpha_{l,k}^{(T\oplus T_1,T_2)}(j)\,\alpha_{i,k}^{(T,T_1)}(l)$ for all $i$ and $j$
:method: All by the recursion by its letter.
:degrees: 1..6 sampled 6
:scope: 20 triples of patterns of knots
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
For the points the matrices alone do not suffice, because each step divides by its own weights. The second step must take the
weights that the first has made. The printed formula does this, without saying what these weights are.

:::{claim} steps_of_refinement_compose
:title: Points and weights of two steps are those of one
:zh: 分步嵌入与一次嵌入所得顶点与权因子相同
:given: triples $T$, $T_1$, $T_2$ of patterns of knots, values variables; points and weights
:where: the new weights of both steps are not 0
:then: (4.1.7), and the same for the weights
:method: (4.1.6) for one step and for two, all sums by their letter.
:degrees: 1..6 sampled 6
:scope: 20 triples of patterns of knots
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
The divisors are the new weights. In the domain they are means of the old ones; in front of it and behind it the shares sum up to less than 1, but they
do not vanish.

:::{claim} weights_of_both_steps_are_positive
:title: With positive weights those of both steps are positive
:zh: 权因子为正时两步所得权因子均为正
:given: the triples $T$, $T_1$, $T_2$ of patterns of knots with any positive gaps; positive weights
:then: $w_l^{(T,T_1)}>0$ and $w_j^{(T,T')}>0$ for all $l$ and $j$
:method: (4.1.6) by its letter; signs are read off coefficients in the gaps and the weights.
:degrees: 1..6 sampled 6
:scope: 20 triples of patterns of knots
:control: all weights negative
:::
*/
/* The weights of the refinement r are positive. */
static void G(must_have_positive_weights)(trial *T, int p, const struct G(refinement) * r, const num w[])
{
    for (int j = 0; j < r->m; j++) {
        num sum = from_int(0);
        for (int i = 0; i < r->n; i++)
            sum = add(sum, mul(G(alpha)(p, r->u, r->place, r->v, r->at, i, j), w[i]));
        G(must_be_positive)(T, sum);
    }
}

CLAIM(weights_of_both_steps_are_positive)
{
    int p = T->degree;
    struct G(refinement) whole_step, first;
    num w[MOST_KNOTS];
    for (int i = 0; i < MOST_KNOTS; i++) {
        num weight = positive(T, "w", i);
        w[i] = fault(T, weight, neg(weight));
    }
    for (int k = 0; G(triples)[p][k] != NULL; k += 3) {
        const char *old = G(triples)[p][k], *one = G(triples)[p][k + 1], *two = G(triples)[p][k + 2];
        char both[MOST_KNOTS];
        G(union_of_patterns)(one, two, both);
        G(increasing_knots)(T, (int)strlen(old), 6, whole_step.x);
        first = whole_step;
        G(refine_pair)(old, both, p, &whole_step);
        G(refine_pair)(old, one, p, &first);
        about(T, "the weights of the first step");
        G(must_have_positive_weights)(T, p, &first, w);
        about(T, "the weights of both steps");
        G(must_have_positive_weights)(T, p, &whole_step, w);
    }
}

/*
:::{statement} wang-ch4:thm-4.1.1-geometry
:title: The theorem has a vivid geometric meaning
:zh: 定理 4.1.1 的几何意义
:printed: Theorem 4.1.1 has a vivid geometric meaning, as theorem 2.10.2 has
:reading: steps_of_refinement_compose | knots may be inserted one after the other, (4.1.7)
:reading: insertions_commute | two knots may be inserted in either order
:reading: insertion_cuts_the_corners | each step puts new points on the edges of the polygon before and cuts its corners
:reading: repeated_insertion_reaches_the_curve | after $k-1$ insertions of $t'$ a corner is a point of the curve, (4.1.9)
:reading: that the meaning is vivid, and like that of theorem 2.10.2: no computation decides it; section 2.10 is not at hand.
:figure: insertions_commute
:::

:::{claim} insertions_commute
:title: Two knots may be inserted in either order
:zh: 两个节点的嵌入次序可交换
:given: $T=\{x_0^k,x_1^m,x_4^k\}$, $0\le m<k$, and two knots: $x_2$, or $x_1$ where $m>0$, and $x_3$; points and weights
:where: the new weights of both steps are not 0
:then: the points, weights and knots are the same
:method: The kernel `nurbs_insert` twice, in both orders, for every $m$.
:degrees: 1..6 sampled 7
:scope: two knots in the last interval of clamped knots with one of every multiplicity below k between, or one of the two at that knot
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
:given: every segment; one knot $\tau$ strictly inside its interval, or at the left end of it, positive gaps of the knots and weights
:let: $s_i=a_iw_i/(a_iw_i+(1-a_i)w_{i-1})$ with $a_i=(\tau-t_i)/(t_{i+k-1}-t_i)$
:then: the $k-1$ new points are $(1-s_i)r_{i-1}+s_ir_i$ with $0\le s_i\le1$, the others are old ones
:method: The kernel; signs are read off coefficients.
:degrees: 1..6 sampled 7
:scope: every pattern of the knots of a segment up to order 4, k+2 of them above; the distinct knots variables up to order 5,
  numbers above
:over: s: ratio in which τ divides its interval; x: -
:control: $s_i$ without the weights
:::
*/
CLAIM(insertion_cuts_the_corners)
{
    int p = T->degree, mu = p, n = p + 1;
    struct G(knot_vector) K = {.kind = FIELD && p > 4 ? INTEGERS : LENGTHS};
    num R[MOST_KNOTS], w[MOST_KNOTS], v[MOST_KNOTS], S[MOST_KNOTS], z[MOST_KNOTS], one = from_int(1);
    for (int number = G(segment_knots)(T, p, 0, &K); number > 0; number = G(segment_knots)(T, p, number, &K)) {
        const num *u = K.u;
        G(weighted_points)(T, n, 1, R, w);
        for (int at_knot = 0; at_knot <= 1; at_knot++) {
            num knot = at_knot ? u[mu] : add(u[mu], mul(sub(u[mu + 1], u[mu]), inside(T, "s")));
            G(nurbs_insert)(nurbs(p, n, 1, u, R, w), mu, knot, v, S, z);
            about(T, "the old points");
            same(T, S[0], R[0]);
            same(T, S[n], R[n - 1]);
            for (int i = 1; i < n; i++) {
                num a = div(sub(knot, u[i]), sub(u[i + p], u[i]));
                num right = mul(a, w[i]), left = mul(sub(one, a), w[i - 1]);
                num s = fault(T, div(right, add(left, right)), a);
                about(T, "s_i is in [0, 1]");
                nonnegative(T, s);
                nonnegative(T, sub(one, s));
                about(T, "the new point");
                same(T, S[i], add(mul(sub(one, s), R[i - 1]), mul(s, R[i])));
            }
        }
    }
}

/*
## The curve itself (曲线上的点)

Insert one knot often enough and a new point is the point of the curve.

:::{statement} wang-ch4:formula-4.1.9
:title: After the (k-1)-fold insertion of t' a control point is the point of the curve
:zh: k-1 次嵌入 t' 后,曲线上的点即控制顶点
:printed: Let $t'\in(t_u,t_{u+1}]$; then $r_k(t')=r_{\mu,k}^{(T,\{t'\}^{k-1})}$
:holds-by: repeated_insertion_reaches_the_curve
:confirmed-by: point_before_a_k_fold_start_has_no_share
:meant: the index $\mu$ of the vertex, and the proof of lemma 4.2.1 | The interval is $(t_\mu,t_{\mu+1}]$; for the letter $u$ see `thm-4.1.1-index`.
:needs: negative_weight_makes_a_pole | definition 4.1.1: $w_i>0$ | the weights are positive: otherwise $w(t')$, which is the weight of $r_\mu$, may be $0$
:hypothesis: left_value_at_a_k_fold_knot | $t'$ is at most a $(k-1)$-fold knot of $T$, unless it is $t_k$ or $t_{n+1}=\dots=t_{n+k}$: at a $k$-fold one $r_\mu$ is the
  limit of the curve from the left
:hypothesis: clamped_start_has_no_such_point | $t'>t_k$ when $t_k$ is at least a $k$-fold knot: for $t_1=t_k$ it is $\mu=0$, and there is no
  $r_0$; for $t_1<t_k$ the point $r_\mu$ has no share in the curve
:reading: right_value_with_the_other_interval | with $t'\in[t_\mu,t_{\mu+1})$, the intervals of algorithm 4.1.1: for every
  multiplicity $0,\dots,k$ and at a $k$-fold $t_k$, where the value is the limit from the right; the end $t_{n+1}$ is then not included
:reading: fewer_insertions_suffice | if more than $k$ equal knots are not allowed: a knot of multiplicity $m$ is inserted $k-1-m$
  times, with the same $\mu$
:figure: insertion_to_the_curve
:striking: 41

For $m\ge2$ the printed $k-1$ insertions make an $m$-fold knot $t'$ more than $k$-fold.  For $m\le k-1$ the points $r_\mu,\dots,r_{\mu+m}$ coincide.
:::
*/

/* T with t' = x_where of multiplicity m, and t' inserted `times` times; x_1 is then the beginning of the domain, x_3 its end. */
static void G(repeated)(int p, int where, int m, int times, struct G(refinement) * r)
{
    char old[] = {(char)('1' + p), '1', '1', '1', (char)('1' + p), '\0'}, new[] = "00000";
    old[where] = (char)('0' + m);
    if (where == 1)
        old[0] = (char)('1' + p - m);
    if (where == 3)
        old[4] = (char)('1' + p - m);
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
  multiplicity $1,\dots,k-1$ after $x_0^{k-m}$, the beginning of the domain, and $t'=x_3$ of these multiplicities before $x_4^{k-m}$, the end
:where: the new weights and $w(t')$ are not 0
:then: $r_\mu^{(T,\{t'\}^{k-1})}=r(t')$, and but for $t'=x_4$ so are $r_{\mu+1},\dots,r_{\mu+m}$; for $t'=x_2$ the values from both sides agree
:method: (4.1.6) by its letter, against (4.1.2) on the intervals of the domain on the left and on the right; $\mu$ is the number of
  knots before $t'$.
:degrees: 0..6 sampled 6
:scope: a knot of every multiplicity below k between simple and clamped ones, and at both ends of the domain; the distinct knots variables up to
  order 6, numbers above
:control: $r_{\mu-1}$, or $r_2$ where $\mu=1$
:::
*/
CLAIM(repeated_insertion_reaches_the_curve)
{
    int p = T->degree;
    struct G(refinement) r;
    num R[MOST_KNOTS], w[MOST_KNOTS], S[MOST_KNOTS], z[MOST_KNOTS], value, right;
    G(distinct_knots)(T, 5, 5, r.x);
    for (int m = -p; m <= 2 * p + 1; m++) { /* first the beginning, last the right end of the domain, k-fold and less */
        int start = (m < 0), end = (m == p + 1), less = (m > p + 1);
        int where = start ? 1 : end ? 4 : less ? 3 : 2, many = start ? -m : less ? m - p - 1 : m;
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
:::{claim} point_before_a_k_fold_start_has_no_share
:title: At a k-fold start behind the first knot the printed index is that of a point without a share
:zh: 首节点之后的 k 重左端处所印指标的顶点与曲线无关
:given: $T=\{x_0^s,x_1^k,x_2,x_3^k\}$, $s=1,\dots,k-1$, whose domain begins at $t'=x_1=t_k$, so that $\mu=s$; points and weights
:where: the new weights are not 0
:then: $r_\mu^{(T,\{t'\}^{k-1})}=r_s$, and $N_{s,k}=0$ on the domain
:method: (4.1.6) by its letter, and the recursion of Cox and de Boor on every interval of the domain, at any $t$.
:degrees: 1..6 sampled 6
:scope: a k-fold start of the domain behind 1 to k-1 equal knots; the distinct knots variables up to order 6, numbers above
:control: the point and the function behind
:::
*/
CLAIM(point_before_a_k_fold_start_has_no_share)
{
    int p = T->degree;
    struct G(refinement) r;
    num R[MOST_KNOTS], w[MOST_KNOTS], S[MOST_KNOTS], z[MOST_KNOTS], t = unknown(T, "t", 0);
    G(distinct_knots)(T, 4, 5, r.x);
    for (int s = 1; s <= p; s++) {
        char old[] = {(char)('0' + s), (char)('1' + p), '1', (char)('1' + p), '\0'}, new[] = "0000";
        new[1] = (char)('0' + p);
        G(refine_pair)(old, new, p, &r);
        G(weighted_points)(T, r.n, 1, R, w);
        G(refined_by_definition)(r.n, p, 1, r.u, r.place, R, w, r.m, r.v, r.at, S, z);
        int other = fault(T, s, s + 1);
        about(T, "r_mu");
        same(T, S[G(knots_below)(&r, 1) - 1], R[other - 1]);
        about(T, "its function on the domain");
        for (int interval = r.place[p]; interval < r.place[r.n]; interval++)
            vanishes(T, G(cox_de_boor)(p, r.u, r.place, other - 1, interval, t));
    }
}

/*
:::{claim} fewer_insertions_suffice
:title: An m-fold knot has to be inserted k-1-m times only
:zh: m 重节点只需再嵌入 k-1-m 次
:given: $T$ with the ends $x_0^k$, $x_4^k$, simple knots $x_1$, $x_3$ and $x_2=t'$ of every multiplicity $m=0,\dots,k-1$; points and weights
:then: $r_\mu^{(T,\{t'\}^{k-1-m})}=r(t')$
:method: (4.1.6) by its letter, against (4.1.2) on the interval on the left; for $m=k-1$ nothing is inserted, and $r_\mu$ is an old point.
:degrees: 1..6 sampled 6
:scope: a knot of every multiplicity below k between simple and clamped ones; the distinct knots variables up to order 6, numbers above
:where: the new weights and $w(t')$ are not 0
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
:given: $T$ with the ends $x_0^k$, $x_4^k$, simple knots $x_1$, $x_3$ and $x_2=t'$ of every multiplicity $m=0,\dots,k$; points and weights; also $t'=x_0$, the $k$-fold left end; $\mu$ the number of knots up to $t'$
:then: $r_\mu^{(T,\{t'\}^{k-1})}=r(t'+)$
:method: (4.1.6) by its letter, against (4.1.2) on the interval on the right.
:degrees: 1..6 sampled 6
:scope: a knot of every multiplicity up to k between simple and clamped ones, and a clamped start; the distinct knots variables up to order 6, numbers above
:where: the new weights and $w(t')$ are not 0
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
At an inner knot of multiplicity $k$ the curve has two values, and the vertex is one of them. Which one depends on the convention
for the intervals, closed on the right in the theorem and on the left in algorithm 4.1.1. The next two claims are the cases in
which the index that is printed does not give the value that is meant.

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
:printed: Let $t'\in(t_u,t_{u+1}]$; the vertex $r_{\mu,k}^{(T,\{t'\}^{k-1})}$ of (4.1.9) has the index $\mu$
:class: misprint
:refuted-by: index_of_another_interval_is_another_point
:corrected: $t'\in(t_\mu,t_{\mu+1}]$; with the two hypotheses of `formula-4.1.9`: $t'$ is at most a $(k-1)$-fold knot of $T$, unless it is $t_k$ or $t_{n+1}=\dots=t_{n+k}$, and $t'>t_k$ when
  $t_k$ is at least a $k$-fold knot
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
:printed: Let $t'\in(t_u,t_{u+1}]$, $T'=T_1\oplus T_2$, and let the new points and weights after the insertion of $T'$ be (4.1.6), with the notation of section 2.10: then (4.1.7),
  (4.1.8) and (4.1.9)
:meant: the index $\mu$ in (4.1.9), the proof of lemma 4.2.1, and the reference to section 2.10 | $t'\in(t_\mu,t_{\mu+1}]$, see `thm-4.1.1-index`; the
  $\alpha$ of (4.1.6) with intervals closed on the left, see `formula-4.1.6`; other readings are at these entries and at `formula-4.1.9`.
:holds-by: steps_of_refinement_compose weights_of_both_steps_are_positive refined_data_give_the_same_curve repeated_insertion_reaches_the_curve
:hypothesis: knot_at_a_k_fold_end_has_no_shares | every knot of $T'$ is in $(t_1,t_{n+k})$, or at $t_1$ where $t_1=t_k$: for (4.1.6)
:hypothesis: end_of_more_than_k_knots_has_no_shares | $t_n<t_{n+k}$: for (4.1.6)
:hypothesis: left_value_at_a_k_fold_knot | $t'$ is at most a $(k-1)$-fold knot of $T$, unless it is $t_k$ or $t_{n+1}=\dots=t_{n+k}$: for (4.1.9)
:hypothesis: clamped_start_has_no_such_point | $t'>t_k$ when $t_k$ is at least a $k$-fold knot: for (4.1.9)
:needs: negative_weight_loses_a_new_point | definition 4.1.1: $w_i>0$ | the weights are positive
:figure: insertion_to_the_curve
:::
*/
#include "chapters/judge/claims_off.h"
