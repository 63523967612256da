/*
# The envelope of a NURBS curve (NURBS 曲线的包络)

De Boor's triangle at the parameter $\tau$ passes through the levels $r=0,1,\dots,k-1$.  On the span
$[t_j,t_{j+1})$ level $r$ has $k-r$ points with weights; over the same knots they are a curve of order $k-r$, the
*member* $\tau$ of a family.  As for rational Bézier curves everything follows from one remark: if
$P(t)=(p(t),w(t))$ is the curve in homogeneous coordinates and $f$ its polar form (极形式) on the span, the member is

$$P^{[r]}(t,\tau)=f[\underbrace{\tau,\dots,\tau}_r,\underbrace{t,\dots,t}_{k-1-r}].$$

The knots have disappeared from this formula: they say which points stand for the segment, not what the segment and its
families are.
*/
#include "chapters/nurbs/family.h"

#include "chapters/judge/elementary.h"

#include <stdio.h>

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch4:formula-4.3.1
:title: Numerator and denominator of a segment
:zh: 一段曲线的分子与分母
:printed: \mathbf p(t)=\sum_{i=j-k+1}^jN_{i,k}(t)\,w_i\mathbf r_i,\qquad w(t)=\sum_{i=j-k+1}^jN_{i,k}(t)\,w_i
:definition: yes
:checked-by: segment_needs_the_points_of_its_span
:figure: nurbs_envelope_families

On $[t_j,t_{j+1})$ these are the numerator and the denominator of (4.1.2): the other terms are 0.
:::

Everything below happens on one span, with its $k$ points and weights.  That the other terms of the sums are 0 is the
first thing to be sure of, and it is not quite obvious at knots of high multiplicity, where the recursion meets
quotients $0/0$.

:::{claim} segment_needs_the_points_of_its_span
:title: On a span the sum over all points is the sum over the k points of the span
:zh: 在一段上全部项之和即该段 k 项之和
:given: order $k$; points and weights over knots of these patterns: simple ones, among which one inside the domain has any multiplicity
  $1,\dots,k$, and $k$-fold ends with two simple knots between; every span $[t_j,t_{j+1})$ of the domain; any $t$
:then: $\sum_{i=1}^nN_{i,k}(t)w_ir_i=\sum_{i=j-k+1}^jN_{i,k}(t)w_ir_i$, and the same for $w$
:method: The left side runs through all indices by the recursion of de Boor and Cox as it is defined; the right side is
  the sum of the kernel's values on the span.
:degrees: 1..6 sampled 7
:scope: an inner knot of every multiplicity up to k among simple ones, and clamped ends; the distinct knots variables up to
  order 5, numbers above
:argued: every order and all knots | By the recursion $N_{i,k}$ is made of $N_{i,1},\dots,N_{i+k-1,1}$, of which on the span $N_{j,1}$ alone is not 0: so $N_{i,k}$ is 0
  there unless $i\le j\le i+k-1$.
:control: the first point of the span left out
:::
*/
CLAIM(segment_needs_the_points_of_its_span)
{
    int p = T->degree;
    for (int many = 1; many <= p + 2; many++) {
        char pattern[MOST_KNOTS] = {0};
        int n = p + 1 + (many > 1 && many <= p + 1 ? many : 2); /* spans on both sides of the knot */
        if (many > p + 1)
            snprintf(pattern, sizeof pattern, "%d11%d", p + 1, p + 1);
        else
            for (int i = 0; i < n + p + 2 - many; i++)
                pattern[i] = (char)('0' + (i == p + 1 ? many : 1));
        num u[MOST_KNOTS], R[MOST_KNOTS], w[MOST_KNOTS], H[MOST_KNOTS], S[2], t = parameter(T, "t");
        int place[MOST_KNOTS], count = G(knots_of_pattern)(T, pattern, u, place);
        G(numbers_above)(4, p, count, place, u);
        G(free_curve)(T, n - 1, 1, R, w);
        for (int i = 0; i < n; i++)
            H[i] = mul(w[i], R[i]);
        for (int interval = place[p]; interval < place[n]; interval++) {
            int mu = G(span_of_interval)(count, place, interval), low = mu - p, skip = fault(T, 0, 1);
            num kept[MAX_DEGREE + 1];
            for (int m = 0; m <= p; m++)
                kept[m] = m < skip ? from_int(0) : w[low + m];
            G(sums)(p, 1, u, mu, R + low, kept, t, S);
            /* Σ over the span = Σ over all i, for N_i,k(t) w_i r_i and for N_i,k(t) w_i */
            same(T, S[0], G(spline_value)(n, p, 1, u, place, H, 0, interval, t));
            same(T, S[1], G(spline_value)(n, p, 1, u, place, w, 0, interval, t));
        }
    }
}

/*
:::{statement} wang-ch4:formula-4.3.3
:title: The family of curves of order k-r on one span
:zh: 一段上的 k-r 阶曲线族
:printed: \mathbf r^{[k-r]}(t,\tau)=\sum_{i=j-k+r+1}^jN_{i,k-r}(t)\,w_i^{[r]}(\tau)\,\mathbf r_i^{[r]}(\tau)\Big/
  \sum_{i=j-k+r+1}^jN_{i,k-r}(t)\,w_i^{[r]}(\tau),\quad t_j\le t,\tau<t_{j+1}
:definition: yes
:checked-by: member_of_span_is_polar extrapolated_members_keep_positive_weights_inside
:confirmed-by: divisors_contain_the_span
:needs: weight_of_a_level_may_vanish | definition 4.1.1: $w_i>0$ | the weights are positive: otherwise a weight of a level may vanish
:figure: nurbs_envelope_families

Level $r$ has the indices $j-k+r+1,\dots,j$ of the sums, and its divisors are $t_{i+k-r}-t_i\ge t_{j+1}-t_j>0$.
:::

The definition looks as if it depended on the knots in a complicated way.  The next claim says that it does not:
(4.1.3) is the recursion of de Boor for the weights, (4.1.3) and (4.1.4) together that for the weighted points, and
$r$ steps of it put $r$ arguments $\tau$ into the polar form.  Summing with the B-splines of order $k-r$ puts $t$ into
the places that are left.

:::{claim} member_of_span_is_polar
:title: The member is the polar form with r arguments τ and k-1-r arguments t
:zh: 族曲线即极形式
:given: order $k$; a span of simple knots, one with a double knot, one whose ends are $(k-1)$-fold, and for $k\le4$ all patterns,
  the distinct
  knots variables for $k\le5$ and numbers above; weights and points, any $t$ and $\tau$, every $r=0,\dots,k-1$
:where: the weights of the levels are not 0
:let: $f$ the polar form of the segment in homogeneous coordinates, $f[\tau^r,t^{k-1-r}]$ its value for $r$ arguments $\tau$ and the others $t$
:then: $\sum N_{i,k-r}(t)\,w_i^{[r]}(\tau)\,(r_i^{[r]}(\tau),1)=f[\tau^r,t^{k-1-r}]$
:method: The left side runs the recursion (4.1.3), (4.1.4), which divides by weights, and sums with the B-splines of
  order $k-r$; the right side is the kernel's polar form of the homogeneous points.  A coordinate is any coordinate,
  so one suffices.
:degrees: 1..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:argued: every order and all knots | The polar form is affine in each argument, and $\tau$ is $\frac{\tau-t_i}{t_{i+k-r}-t_i}\,t_{i+k-r}+\frac{t_{i+k-r}-\tau}{t_{i+k-r}-t_i}\,t_i$: so by (4.1.3)
  $w_i^{[r]}(r_i^{[r]},1)=f[\tau^r,t_{i+1},\dots,t_{i+k-1-r}]$, and these are the points over the same knots of the polynomial $f[\tau^r,t^{k-1-r}]$ in $t$.
:control: one argument $\tau$ of the polar form replaced by $t$
:::
*/
CLAIM(member_of_span_is_polar)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num H[2 * (MAX_DEGREE + 1)];
        G(knots_of_span)(T, p, shape, u, place);
        G(rational_homogenize)(p, 1, R, w, H);
        for (int r = 0; r <= p; r++) {
            num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], S[2], f[2], x[MAX_DEGREE];
            G(level_of_curve)(p, 1, u, mu, R, w, r, tau, Rr, wr);
            G(sums)(p - r, 1, u, mu, Rr, wr, t, S);
            for (int k = 0; k < p; k++)
                x[k] = k < r - fault(T, 0, r > 0) ? tau : t;
            G(bspline_blossom)(G(span_alone)(p, 2, u, mu, H), x, f);
            /* Σ N_i,k-r(t) w_i[r](τ) (r_i[r](τ), 1) = f[τ, ..., τ, t, ..., t] */
            same(T, S[0], f[0]);
            same(T, S[1], f[1]);
        }
    }
}

#if FIELD || RATIONAL
/*
:::{claim} extrapolated_members_keep_positive_weights_inside
:title: On its own span every weight of every level and every denominator of a member is positive
:zh: 在本段内各层权及族曲线分母恒正
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, and for $k\le4$ all
  patterns; positive
  weights; $t$ and $\tau$ inside the span or at its left end
:then: $w_i^{[r]}(\tau)>0$ for all $r=1,\dots,k-2$ and $i=j-k+r+1,\dots,j$, and $\sum N_{i,k-r}(t)w_i^{[r]}(\tau)>0$
:method: With $t=(t_j+t_{j+1}x)/(1+x)$, $\tau$ likewise with $y$, and the gaps of the knots, the weights, $x$ and $y$
  as variables or $x=0$, $y=0$, numerators and denominators have positive coefficients only.
:types: field rational
:degrees: 2..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 4, numbers above
:over: y#: ratios in which the parameters divide the span; x#: -
:argued: every order and all knots | For a $\tau$ of the span, its left end included, the factors of (4.1.3) are not negative and that of $w_{i-1}^{[r-1]}$ is positive; the
  $N_{i,k-r}(t)$ are not negative and sum up to 1.
:control: the weights negative
:::
*/
CLAIM(extrapolated_members_keep_positive_weights_inside)
{
    int p = T->degree, mu = p;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], a[2];
    for (int i = 0; i <= p; i++) {
        w[i] = fault(T, positive(T, "w", i), neg(positive(T, "w", i)));
        R[i] = from_int(1);
    }
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num u[MOST_KNOTS];
        G(gaps_of_span)(T, p, shape, u);
        for (int ends = 0; ends < 4; ends++) { /* which of t and tau are at the left end */
            for (int k = 0; k < 2; k++) {
                num x = ends >> k & 1 ? from_int(0) : positive(T, "y", k);
                a[k] = div(add(u[mu], mul(x, u[mu + 1])), add(from_int(1), x));
            }
            for (int r = 1; r < p; r++) {
                num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], S[2];
                G(level_of_curve)(p, 1, u, mu, R, w, r, a[1], Rr, wr);
                about(T, "the weights of level r");
                for (int m = 0; m <= p - r; m++)
                    G(must_be_positive)(T, wr[m]);
                about(T, "the denominator of the member");
                G(sums)(p - r, 1, u, mu, Rr, wr, a[0], S);
                G(must_be_positive)(T, S[1]);
            }
        }
    }
}
#endif

/*
## R touches every member

:::{statement} wang-ch4:thm-4.3.1-range
:title: The levels 1, ..., k-2 of a curve of order at least 3
:zh: r 与 k 的取值范围
:printed: the families are considered for $k\ge3$ and $r=1,2,\dots,k-2$
:definition: yes
:checked-by: member_of_extreme_levels
:figure: nurbs_envelope_families

The range leaves out what is no family of curves: for $r=0$ every member is the curve itself, for $r=k-1$ a point of
it.
:::

:::{claim} member_of_extreme_levels
:title: Level 0 gives the curve for every τ, level k-1 its point
:zh: 第 0 层即曲线,第 k-1 层即曲线上的点
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, and for $k\le4$ all
  patterns; weights and
  points, any $t$ and $\tau$
:where: the weights of the curve, the levels and the member are not 0
:then: $r^{[k]}(t,\tau)=r(t)$ and $r^{[1]}(t,\tau)=r(\tau)$
:method: The recursion for the members, the kernel of the point for the curve.
:degrees: 2..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:argued: every order and all knots | No argument of the polar form is $\tau$ at level 0, and all are at level $k-1$.
:control: level $k-2$ in the place of level $k-1$
:::
*/
CLAIM(member_of_extreme_levels)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], S[2], point;
        G(knots_of_span)(T, p, shape, u, place);
        G(level_of_curve)(p, 1, u, mu, R, w, 0, tau, Rr, wr);
        G(sums)(p, 1, u, mu, Rr, wr, t, S);
        G(nurbs_point)(G(nurbs_on_span)(p, 1, u, mu, R, w), t, &point);
        about(T, "level 0");
        same(T, div(S[0], S[1]), point);
        int last = fault(T, p, p - 1);
        G(level_of_curve)(p, 1, u, mu, R, w, last, tau, Rr, wr);
        G(sums)(p - last, 1, u, mu, Rr, wr, t, S);
        G(nurbs_point)(G(nurbs_on_span)(p, 1, u, mu, R, w), tau, &point);
        about(T, "level k-1");
        same(T, div(S[0], S[1]), point);
    }
}

/*
The proof of contact compares the value and the derivative of the member with those of the curve at $t=\tau$.  On the
diagonal all arguments of the polar form are equal, so the values agree on every level.  A derivative by $t$ sees only
the $k-1-r$ arguments that are $t$: that is where the factors $\frac{k-r-1}{k-1}$ come from.

:::{statement} wang-ch4:formula-4.3.4
:title: On the diagonal the denominators of all levels agree
:zh: t=τ 时各层分母相等
:printed: \sum_{i=j-k+r+1}^jN_{i,k-r}(t)\,w_i^{[r]}(t)=\sum_{i=j-k+r}^jN_{i,k-r+1}(t)\,w_i^{[r-1]}(t)=\dots=w(t),
  \quad t_j\le t<t_{j+1},\ j=k,k+1,\dots,n
:holds-by: levels_keep_the_weight
:confirmed-by: levels_keep_weight_and_point
:figure: nurbs_envelope_growing

No weight is divided by: it is true for weights of any sign.
:::

:::{statement} wang-ch4:formula-4.3.5
:title: On the diagonal the numerators of all levels agree
:zh: t=τ 时各层分子相等
:printed: \sum_{i=j-k+r+1}^jN_{i,k-r}(t)\,w_i^{[r]}(t)\mathbf r_i^{[r]}(t)=\sum_{i=j-k+r}^jN_{i,k-r+1}(t)\,
  w_i^{[r-1]}(t)\mathbf r_i^{[r-1]}(t)=\dots=\mathbf p(t),
  \quad t_j\le t<t_{j+1},\ j=k,k+1,\dots,n
:holds-by: levels_keep_weight_and_point
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:needs: weight_of_a_level_may_vanish | definition 4.1.1: $w_i>0$ | the weights are positive: otherwise a weight of a level may vanish
:figure: nurbs_envelope_growing

Positive weights $w_i$ make the weights of the levels positive for $t$ and $\tau$ in the span: `extrapolated_members_keep_positive_weights_inside`.
:::

:::{claim} levels_keep_the_weight
:title: At τ = t the weights of every level sum up to the same
:zh: τ=t 时各层权之和相同
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, and for $k\le4$ all
  patterns; any numbers $w_i$, any $t$, every $r=1,\dots,k-2$
:then: the sum of the $w_i^{[r]}(t)$ with the $N_{i,k-r}(t)$ is that of level $r-1$ with the $N_{i,k-r+1}(t)$, and $w(t)$
:method: (4.1.3) by its letter, the sums as printed.
:degrees: 2..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:argued: every order and all knots | By (4.1.3) the sum of level $r$, put in the order of the $w_i^{[r-1]}$, has them with the factors $\frac{t-t_i}{t_{i+k-r}-t_i}N_{i,k-r}
  +\frac{t_{i+k-r+1}-t}{t_{i+k-r+1}-t_{i+1}}N_{i+1,k-r}=N_{i,k-r+1}$; what is 0 on the span falls away.
:control: the recursion of the level at $\tau=t+1$
:::
*/
/* One step of (4.1.3) for the weights of a span, from level - 1 to level, in place: w_0, ..., w_{p-level}. */
static void G(printed_level)(int p, const num u[], int mu, int level, num w[], num tau)
{
    for (int m = 0; m <= p - level; m++) { /* i = mu-p+level+m */
        num left = u[mu - p + level + m], right = u[mu + 1 + m], length = sub(right, left);
        w[m] = add(mul(div(sub(tau, left), length), w[m + 1]), mul(div(sub(right, tau), length), w[m]));
    }
}

/* sum N_{i,q+1}(t) w_i on the span, q the degree, or with the derivatives of the N. */
static num G(sum_of_weights)(int q, const num u[], int mu, const num w[], num t, int derivative)
{
    num N[2 * (MAX_DEGREE + 1)], sum = from_int(0);
    G(bspline_basis_derivatives)(q, u, mu, t, 1, N);
    for (int m = 0; m <= q; m++)
        sum = add(sum, mul(N[(derivative ? q + 1 : 0) + m], w[m]));
    return sum;
}

CLAIM(levels_keep_the_weight)
{
    int p = T->degree, mu = p, place[MOST_KNOTS];
    num u[MOST_KNOTS], w[MAX_DEGREE + 1], t = parameter(T, "t"), tau = fault(T, t, add(t, from_int(1)));
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        G(knots_of_span)(T, p, shape, u, place);
        for (int i = 0; i <= p; i++)
            w[i] = unknown(T, "w", i);
        num first = G(sum_of_weights)(p, u, mu, w, t, 0), before = first;
        for (int r = 1; r <= p - 1; r++) {
            G(printed_level)(p, u, mu, r, w, tau);
            num sum = G(sum_of_weights)(p - r, u, mu, w, t, 0);
            about(T, "the level before");
            same(T, sum, before);
            about(T, "the denominator of the curve");
            same(T, sum, first);
            before = sum;
        }
    }
}

/*
:::{claim} levels_keep_weight_and_point
:title: At τ = t every level sums up to the same weight and the same point
:zh: τ=t 时各层之和相同
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, and for $k\le4$ all
  patterns; weights and
  points, any $t$, every $r=1,\dots,k-2$
:where: the weights of the levels are not 0
:then: both sums of level $r$ over $N_{i,k-r}(t)$ are those of level $r-1$ over $N_{i,k-r+1}(t)$ and those of level 0,
  $w(t)$ and $p(t)$
:method: The levels by (4.1.3), (4.1.4), the sums as printed.
:degrees: 2..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:argued: every order and all knots | By (4.1.3) the sum of level $r$, put in the order of the $w_i^{[r-1]}$, has them with the factors $\frac{t-t_i}{t_{i+k-r}-t_i}N_{i,k-r}
  +\frac{t_{i+k-r+1}-t}{t_{i+k-r+1}-t_{i+1}}N_{i+1,k-r}=N_{i,k-r+1}$; what is 0 on the span falls away.
:control: the recursion of the level at $\tau=t+1$
:::
*/
CLAIM(levels_keep_weight_and_point)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t");
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num S[2], before[2], first[2];
        G(knots_of_span)(T, p, shape, u, place);
        G(sums)(p, 1, u, mu, R, w, t, first);
        before[0] = first[0], before[1] = first[1];
        for (int r = 1; r < p; r++) {
            num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1];
            G(level_of_curve)(p, 1, u, mu, R, w, r, fault(T, t, add(t, from_int(1))), Rr, wr);
            G(sums)(p - r, 1, u, mu, Rr, wr, t, S);
            for (int c = 0; c < 2; c++) {
                about(T, "the level before");
                same(T, S[c], before[c]);
                about(T, "the sums of the curve");
                same(T, S[c], first[c]);
                before[c] = S[c];
            }
        }
    }
}

/*
:::{statement} wang-ch4:formula-4.3.6
:title: The derivative of the basis at each level gives a fixed part of w'
:zh: 各层基函数求导所得为 w' 的固定倍数
:printed: \sum_{i=j-k+r+1}^jN_{i,k-r}'(t)\,w_i^{[r]}(t)=\frac{k-r-1}{k-r}\sum_{i=j-k+r}^jN_{i,k-r+1}'(t)\,
  w_i^{[r-1]}(t)=\dots=\frac{k-r-1}{k-1}w'(t),
  \quad t_j\le t<t_{j+1},\ j=k,k+1,\dots,n
:holds-by: levels_shrink_the_derivative_of_the_weight
:confirmed-by: levels_shrink_the_derivative
:figure: nurbs_envelope_contact

No weight is divided by: it is true for weights of any sign.  At $t=t_j$ the derivatives are those from the right, see `thm-4.3.1-right-limit`.
:::

:::{statement} wang-ch4:formula-4.3.7
:title: The derivative of the basis at each level gives a fixed part of p'
:zh: 各层基函数求导所得为 p' 的固定倍数
:printed: \sum_{i=j-k+r+1}^jN_{i,k-r}'(t)\,w_i^{[r]}(t)\mathbf r_i^{[r]}(t)=\frac{k-r-1}{k-r}
  \sum_{i=j-k+r}^jN_{i,k-r+1}'(t)\,w_i^{[r-1]}(t)\mathbf r_i^{[r-1]}(t)=\dots=\frac{k-r-1}{k-1}\mathbf p'(t),
  \quad t_j\le t<t_{j+1},\ j=k,k+1,\dots,n
:holds-by: levels_shrink_the_derivative
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:needs: weight_of_a_level_may_vanish | definition 4.1.1: $w_i>0$ | the weights are positive: otherwise a weight of a level may vanish
:figure: nurbs_envelope_contact

Positive weights $w_i$ make the weights of the levels positive for $t$ and $\tau$ in the span: `extrapolated_members_keep_positive_weights_inside`.
At $t=t_j$ the derivatives are those from the right, see `thm-4.3.1-right-limit`.
:::

:::{claim} levels_shrink_the_derivative_of_the_weight
:title: The derivative of the basis alone gives, of the weights, (k-r-1)/(k-r) of the level before and (k-r-1)/(k-1) of w'
:zh: 仅对基函数求导所得 w' 的比例
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, and for $k\le4$ all
  patterns; any numbers $w_i$, any $t$, every $r=1,\dots,k-2$
:then: the display (4.3.6), each equality
:method: (4.1.3) by its letter, the sums as printed, with the derivatives of the B-splines; $w'$ by those of order $k$.
:degrees: 2..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:argued: every order and all knots | With the polar form $f$ of $w$ on the span the sums of level $r$ are $f[\tau^r,t^{k-1-r}]$, since the polar form is affine in each argument; the derivative
  by $t$ is $(k-1-r)\,f[\tau^r,t^{k-2-r},\delta]$, $\delta$ being the direction, and for $\tau=t$ the same $f[t^{k-2},\delta]$ on each level.
:control: the factor $\frac{k-r}{k-r+1}$ for one level
:::
*/
CLAIM(levels_shrink_the_derivative_of_the_weight)
{
    int p = T->degree, k = p + 1, mu = p, place[MOST_KNOTS];
    num u[MOST_KNOTS], w[MAX_DEGREE + 1], t = parameter(T, "t");
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        G(knots_of_span)(T, p, shape, u, place);
        for (int i = 0; i <= p; i++)
            w[i] = unknown(T, "w", i);
        num first = G(sum_of_weights)(p, u, mu, w, t, 1), before = first;
        for (int r = 1; r <= k - 2; r++) {
            G(printed_level)(p, u, mu, r, w, t);
            num sum = G(sum_of_weights)(p - r, u, mu, w, t, 1);
            about(T, "the level before");
            same(T, sum, mul(fault(T, from_ratio(k - r - 1, k - r), from_ratio(k - r, k - r + 1)), before));
            about(T, "the derivative of the denominator");
            same(T, sum, mul(from_ratio(k - r - 1, k - 1), first));
            before = sum;
        }
    }
}

/*
:::{claim} levels_shrink_the_derivative
:title: The derivative of the basis alone gives (k-r-1)/(k-r) of the level before and (k-r-1)/(k-1) of the curve
:zh: 仅对基函数求导所得的比例
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, and for $k\le4$ all
  patterns; weights and
  points, any $t$, every $r=1,\dots,k-2$
:where: the weights of the levels are not 0
:then: the displays (4.3.6) and (4.3.7), each equality
:method: The levels by (4.1.3), (4.1.4), the sums as printed, with the derivatives of the B-splines; $w'$ and $p'$ by the derivatives of the basis of order $k$.
:degrees: 2..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:argued: every order and all knots | With the polar form $f$ of the segment in homogeneous coordinates the sums of level $r$ are $f[\tau^r,t^{k-1-r}]$, since the polar form is affine in each argument; the derivative
  by $t$ is $(k-1-r)\,f[\tau^r,t^{k-2-r},\delta]$, $\delta$ being the direction, and for $\tau=t$ the same $f[t^{k-2},\delta]$ on each level.
:control: the factor $\frac{k-r}{k-r+1}$ for one level
:::
*/
CLAIM(levels_shrink_the_derivative)
{
    int p = T->degree, k = p + 1, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t");
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num S[2], before[2], first[2];
        G(knots_of_span)(T, p, shape, u, place);
        G(derivative_sums)(p, 1, u, mu, R, w, t, first);
        before[0] = first[0], before[1] = first[1];
        for (int r = 1; r <= k - 2; r++) {
            num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1];
            num step = fault(T, from_ratio(k - r - 1, k - r), from_ratio(k - r, k - r + 1));
            G(level_of_curve)(p, 1, u, mu, R, w, r, t, Rr, wr);
            G(derivative_sums)(p - r, 1, u, mu, Rr, wr, t, S);
            for (int c = 0; c < 2; c++) {
                about(T, "the level before");
                /* Σ N'_i,k-r w_i[r] = (k-r-1)/(k-r) Σ N'_i,k-r+1 w_i[r-1] */
                same(T, S[c], mul(step, before[c]));
                about(T, "the derivatives of numerator and denominator");
                /* Σ N'_i,k-r w_i[r] = (k-r-1)/(k-1) w' */
                same(T, S[c], mul(from_ratio(k - r - 1, k - 1), first[c]));
                before[c] = S[c];
            }
        }
    }
}

/*
:::{statement} wang-ch4:thm-4.3.1-point
:title: At τ = t the member has the point of the curve
:zh: τ=t 时族曲线上的点即曲线上的点
:printed: \mathbf r^{[k-r]}(t,\tau)|_{\tau=t}=\mathbf p(t)/w(t)=\mathbf r(t),\quad t_j\le t<t_{j+1}
:holds-by: member_of_span_touches_curve
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:needs: weight_of_a_level_may_vanish | definition 4.1.1: $w_i>0$ | the weights are positive: otherwise a weight of a level may vanish
:figure: nurbs_envelope_growing

Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span: `extrapolated_members_keep_positive_weights_inside`.
:::

:::{statement} wang-ch4:thm-4.3.1-derivative
:title: At τ = t the derivative of the member is a fixed part of that of the curve
:zh: τ=t 时族曲线的导矢与曲线的导矢平行
:printed: \frac{\partial\mathbf r^{[k-r]}(t,\tau)}{\partial t}\Big|_{\tau=t}=\frac{k-r-1}{k-1}\,
  \frac{w(t)\mathbf p'(t)-w'(t)\mathbf p(t)}{w^2(t)}=\frac{k-r-1}{k-1}\mathbf r'(t)\parallel\mathbf r'(t),
  \quad t_j\le t<t_{j+1}
:holds-by: member_of_span_touches_curve
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:needs: weight_of_a_level_may_vanish | definition 4.1.1: $w_i>0$ | the weights are positive: otherwise a weight of a level may vanish
:figure: nurbs_envelope_contact

Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span: `extrapolated_members_keep_positive_weights_inside`.
Where $\mathbf r'(t)=0$ both derivatives vanish, and there is no direction.

In the copy at hand a torn line stands before the display, $\tau=k-r-1\ w(t)\mathbf p'(t)-w'(t)\mathbf p(t)\ k-r-1$: numerators of its fractions, once more.  It says
nothing by itself.
:::
*/

/* p+1 points of one coordinate and weights, everything free.  In the field the variables are the coefficients of
 * numerator and denominator in powers about t, and the points are polar values of the segment that they give: every
 * segment is of this kind, and its value and derivative at t are short. */
static void G(curve_about)(trial *T, int p, num t, const num u[], num R[], num w[])
{
#if FIELD
    num a[MAX_DEGREE + 1], b[MAX_DEGREE + 1], x[MAX_DEGREE + 1];
    for (int m = 0; m <= p; m++) {
        a[m] = unknown(T, "a", m);
        b[m] = unknown(T, "w", m);
    }
    for (int i = 0; i <= p; i++) {
        for (int m = 0; m < p; m++)
            x[m] = sub(u[i + 1 + m], t);
        w[i] = G(polar_of_powers)(p, b, x);
        R[i] = div(G(polar_of_powers)(p, a, x), w[i]);
    }
#else
    (void)t, (void)u;
    G(free_curve)(T, p, 1, R, w);
#endif
}

/*
The quotient rule turns the four sums into a statement on the curve of the plane or of space: numerator and
denominator are shortened by the same factor, so the direction of the derivative is not changed.  The middle term of
the display is compared too.

:::{claim} member_of_span_touches_curve
:title: At τ = t the member has the point of the curve and (k-r-1)/(k-1) of its derivative
:zh: τ=t 处族曲线与曲线同点,导矢之比为 (k-r-1)/(k-1)
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, and for $k\le4$ all
  patterns; weights and
  points, any $t$, every $r=1,\dots,k-2$
:where: the weights of the curve, the levels and the member are not 0
:then: $r^{[k-r]}(t,t)=r(t)$ and
  $\partial_tr^{[k-r]}(t,\tau)=\frac{k-r-1}{k-1}r'(t)=\frac{k-r-1}{k-1}\frac{wp'-w'p}{w^2}$ at $\tau=t$
:method: Member and curve by the kernels of rational derivatives, and the middle term by its letter.  $t$ is any
  number, so the ends of the span are covered, with the derivatives of its polynomials.
:degrees: 2..6 sampled 6
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:argued: every order and all knots | With the polar form $f$ of the segment in homogeneous coordinates the sums of level $r$ are $f[\tau^r,t^{k-1-r}]$, since the polar form is affine in each argument; value and
  derivative by $t$ are at $\tau=t$ those of the curve, the derivative with the factor $\frac{k-1-r}{k-1}$; then the quotient rule.
:control: the factor left out
:::
*/
CLAIM(member_of_span_touches_curve)
{
    int p = T->degree, k = p + 1, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t");
    int place[MOST_KNOTS];
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num D[2], S[2], S1[2];
        G(knots_of_span)(T, p, shape, u, place);
        G(curve_about)(T, p, t, u, R, w);
        G(curve_derivatives)(p, 1, u, mu, R, w, t, 1, D);
        G(sums)(p, 1, u, mu, R, w, t, S);
        G(derivative_sums)(p, 1, u, mu, R, w, t, S1);
        num middle = div(sub(mul(S[1], S1[0]), mul(S1[1], S[0])), mul(S[1], S[1]));
        for (int r = 1; r <= k - 2; r++) {
            num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], E[2];
            num factor = fault(T, from_ratio(k - r - 1, k - 1), from_int(1));
            G(level_of_curve)(p, 1, u, mu, R, w, r, t, Rr, wr);
            G(curve_derivatives)(p - r, 1, u, mu, Rr, wr, t, 1, E);
            about(T, "the common point");
            same(T, E[0], D[0]);
            about(T, "the derivatives");
            /* ∂_t r[k-r] = (k-r-1)/(k-1) (w p' - w' p)/w² = (k-r-1)/(k-1) r' */
            same(T, E[1], mul(factor, middle));
            same(T, E[1], mul(factor, D[1]));
        }
    }
}

/*
At a knot of multiplicity $k-1$ a curve may have two tangents, one on each side.  The member belongs to the span on
the right and knows nothing of the other; the source says so in passing, and it is needed.

:::{statement} wang-ch4:thm-4.3.1-right-limit
:title: At a knot the derivatives are limits from the right
:zh: 节点处的偏导矢取右极限
:printed: here the partial derivatives at a point $t_i$ are understood as limits from the right
:holds-by: member_of_span_touches_curve
:needs: corner_has_two_tangents | the sentence itself, 右极限值 | the limit is from the right; from the left the
  curve may have, at a $(k-1)$-fold knot, another direction than the member of the span on the right
:meant: the proof, which is about the span of $t_j$ and counts the terms of its sums by $i$ | The knot is $t_j$, the left end of the span.
:figure: knot_sides
:::
*/

#if RATIONAL
/*
:::{claim} corner_has_two_tangents
:title: At a (k-1)-fold knot the curve may have a corner; the member of the span on the right has the right tangent
  only
:zh: k-1 重节点处曲线可有尖角
:kind: counterexample
:given: a quadratic spline curve with the points $r_i$, equal weights and the knots $t_i$, an inner one of which,
  $\tau$, is double; $r=1$; the member $\tau$ of the span to the right of the knot
:data: t_i = 0 0 0 1 1 2 2 2; r_i = (0,0) (1,0) (2,2) (3,0) (4,0); τ = 1
:then: its derivative at $t=\tau$ is not parallel to that of the curve from the left
:result: derivative of the curve = (2,4); derivative of the member = (1,-2)
:method: Both derivatives are computed exactly; their determinant is compared with 0.
:control: the derivative of the curve from the right
:::
*/
CLAIM(corner_has_two_tangents)
{
    num u[8], R[10], w[5], Rr[6], wr[3], D[4], E[4];
    given_points(T, "t_i", 8, 1, u);
    given_points(T, "r_i", 5, 2, R);
    num tau = given(T, "τ");
    for (int i = 0; i < 5; i++)
        w[i] = from_int(1);
    int left = 2, right = 4; /* the spans on the two sides of the knot */
    G(nurbs_derivatives)(G(nurbs_on_span)(2, 2, u, fault(T, right, left), R, w), tau, 1, D);
    G(level_of_curve)(2, 2, u, right, R + 4, w + 2, 1, tau, Rr, wr);
    G(curve_derivatives)(1, 2, u, right, Rr, wr, tau, 1, E);
    found_points(T, "derivative of the curve", 1, 2, D + 2);
    found_points(T, "derivative of the member", 1, 2, E + 2);
    about(T, "the determinant of the two derivatives");
    vanishes(T, G(cross2)(D + 2, E + 2));
}
#endif

/*
:::{statement} wang-ch4:thm-4.3.1
:title: On a span the NURBS curve is an envelope of its family of order k-r
:zh: 一段 NURBS 曲线是其 k-r 阶曲线族的包络
:printed: with $w_i^{[r]}(\tau)$, $\mathbf r_i^{[r]}(\tau)$ by (4.1.3), (4.1.4) for $t=\tau$ and with (4.3.1), a segment $\mathbf r(t)$, $t_j\le t<t_{j+1}$, of the NURBS curve (4.1.2) of
  order $k\ge3$ is the envelope of a family of NURBS curves of order $k-r$, $r=1,2,\dots,k-2$:
  $\mathbf r(t)=\mathbf p(t)/w(t)=\operatorname{env}\{\mathbf r^{[k-r]}(t,\tau),\ t_j\le t<t_{j+1}\mid
  t_j\le\tau<t_{j+1}\}$, $j=k,k+1,\dots,n$, with (4.3.3)
:holds-by: member_of_span_touches_curve envelope_condition_holds_on_the_diagonal
:confirmed-by: span_derivatives_are_parallel curvatures_have_a_fixed_ratio extrapolated_members_keep_positive_weights_inside
:hypothesis: span_member_shrinks_at_a_cusp | $\mathbf r'\ne0$; where it vanishes the member may be a single point
:needs: negative_weight_takes_a_point_away | definition 4.1.1: $w_i>0$ | the weights are positive
:meant: the headings 4.3.1 and 4.3.2, on existence and on uniqueness of the envelope | That the segment is an envelope, the first reading; whether it is the only one is theorem 4.3.2.
:reading: member_of_span_touches_curve | "an envelope": a curve that in each of its points is touched by a member, wherever $\mathbf r'\ne0$
:reading: inflected_cubic_has_second_envelope | "the envelope", all joint solutions of (4.3.3) and of the condition of an envelope, as the sign of equality says
:figure: nurbs_envelope_families

Every member touches the curve, in the point of its own parameter.  Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and
$\tau$ in the span: `extrapolated_members_keep_positive_weights_inside`.  For $t_j=t_{j+1}$ the span is empty and nothing is claimed.  The contact is of order 1 where the curvature is not 0,
for every $r$: `span_derivatives_are_parallel`, `curvatures_have_a_fixed_ratio`.
:::

By the usual definition a curve $X(t,\tau(t))$ is an envelope (包络) if it meets the condition $X_t\times X_\tau=0$.
The derivative by $\tau$ sees the other $r$ arguments, so the two derivatives at $t=\tau$ are $\frac{k-r-1}{k-1}$ and
$\frac r{k-1}$ of $\mathbf r'$.  They are parallel, and where $\mathbf r'=0$ both vanish: a cusp (尖点) is the exception
to look out for.

:::{claim} envelope_condition_holds_on_the_diagonal
:title: On the diagonal the derivatives of the member by t and by τ are parallel
:zh: 对角线上族曲线对 t, τ 的偏导矢平行
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, and for $k\le4$ all
  patterns; weights and
  points, any $t$, every $r=1,\dots,k-2$
:where: the weights of the curve, the levels and the member are not 0
:then: at $\tau=t$: $\partial_\tau r^{[k-r]}=\frac r{k-1}r'$ and $\partial_tr^{[k-r]}=\frac{k-r-1}{k-1}r'$, so that
  $\partial_\tau r^{[k-r]}\times\partial_tr^{[k-r]}=0$
:method: The derivative by $\tau$ in two ways: of (4.1.3) for the $w_ir_i$ and the $w_i$, step by step; and of the Bézier curve of degree $r$ that the point, in homogeneous
  coordinates, is in $\tau$; one coordinate.  The two factors add up to 1, as they must: $r^{[k-r]}(t,t)=r(t)$.
:degrees: 2..6 sampled 6
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:argued: every order and all knots | With the polar form $f$ of the segment in homogeneous coordinates the sums of level $r$ are $f[\tau^r,t^{k-1-r}]$, since the polar form is affine in each argument; at $\tau=t$
  the derivatives by $t$ and $\tau$ have $k-1-r$ and $r$ of the $k-1$ equal parts of that of the curve; then the quotient rule.
:control: the factors of the two derivatives exchanged and increased by 1
:::
*/
/* The derivative by tau of the member tau of level r at t, one coordinate: (4.1.3) for the w_i r_i and the w_i, differentiated step by
 * step, h_i = a h_i + (1-a) h_{i-1} with a = (tau - t_i)/(t_{i+k-r} - t_i); then the sums, and the quotient rule. */
static num G(derivative_by_tau)(int p, const num u[], int mu, const num R[], const num w[], int r, num tau, num t)
{
    num h[2][MAX_DEGREE + 1], d[2][MAX_DEGREE + 1], N[MAX_DEGREE + 1], S[2], S1[2];
    for (int i = 0; i <= p; i++) {
        h[0][i] = mul(w[i], R[i]), h[1][i] = w[i];
        d[0][i] = d[1][i] = from_int(0);
    }
    for (int level = 1; level <= r; level++)
        for (int m = 0; m <= p - level; m++) { /* i = mu-p+level+m */
            int i = mu - p + level + m;
            num length = sub(u[i + p + 1 - level], u[i]), a = div(sub(tau, u[i]), length), b = sub(from_int(1), a);
            for (int c = 0; c < 2; c++) {
                num change = div(sub(h[c][m + 1], h[c][m]), length);
                d[c][m] = add(change, add(mul(a, d[c][m + 1]), mul(b, d[c][m])));
                h[c][m] = add(mul(a, h[c][m + 1]), mul(b, h[c][m]));
            }
        }
    G(bspline_basis)(p - r, u, mu, t, N);
    for (int c = 0; c < 2; c++) {
        S[c] = S1[c] = from_int(0);
        for (int m = 0; m <= p - r; m++) {
            S[c] = add(S[c], mul(N[m], h[c][m]));
            S1[c] = add(S1[c], mul(N[m], d[c][m]));
        }
    }
    return div(sub(mul(S1[0], S[1]), mul(S[0], S1[1])), mul(S[1], S[1]));
}

CLAIM(envelope_condition_holds_on_the_diagonal)
{
    int p = T->degree, k = p + 1, mu = p, more = fault(T, 0, 1);
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t");
    int place[MOST_KNOTS];
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num D[2];
        G(knots_of_span)(T, p, shape, u, place);
        G(curve_about)(T, p, t, u, R, w);
        G(curve_derivatives)(p, 1, u, mu, R, w, t, 1, D);
        for (int r = 1; r <= k - 2; r++) {
            num E[3];
            G(family_derivatives)(p, 1, u, mu, R, w, r, t, t, E);
            about(T, "the derivative by t");
            /* ∂_t r[k-r] = (k-r-1)/(k-1) r' */
            same(T, E[1], mul(from_ratio(more ? r + 1 : k - r - 1, k - 1), D[1]));
            about(T, "the derivative by τ");
            /* ∂_τ r[k-r] = r/(k-1) r' */
            num part = mul(from_ratio(more ? k - r : r, k - 1), D[1]);
            same(T, E[2], part);
            about(T, "the derivative by τ of (4.1.3)");
            same(T, G(derivative_by_tau)(p, u, mu, R, w, r, t, t), part);
        }
    }
}

#if RATIONAL
/*
:::{claim} span_member_shrinks_at_a_cusp
:title: Where the derivative of the curve vanishes the line of the family may be a point
:zh: 尖点处的族直线退化为点
:kind: counterexample
:given: the cubic $\sum a_mt^m$, which is $(t^2,t^3)$, as a segment over the uniform knots $t_i$, weights 1; $r=2$,
  $\tau$
:data: t_i = -7 -5 -3 -1 1 3 5 7; a = (0,0) (0,0) (1,0) (0,1); τ = 0
:instead: τ = 1/2
:then: the member, a line by rights, is a point: it has no tangent that could be common
:result: r_i = (23/3,-15) (-1/3,3) (-1/3,-3) (23/3,15); the two points of the member = (0,0) (0,0)
:method: The two points of the level are computed exactly; that they differ is what is compared.
:control: a parameter where the curve has no cusp
:::
*/
CLAIM(span_member_shrinks_at_a_cusp) { G(line_shrinks_to_a_point)(T); }

/*
:::{claim} negative_weight_takes_a_point_away
:title: With a negative weight a point of a level may be missing
:zh: 权为负时某层控制顶点可能不存在
:kind: counterexample
:given: a quadratic segment over the simple knots $t_i$ with weights $w_i$ of both signs, whose $w(t)$ is positive on
  the closed span; $r=1$, $\tau$
:data: t_i = 0 1 2 3 4 5; w_i = 5 -1 5; τ = 8/3
:instead: w_i = 5 1 5
:then: a weight of level 1 is 0, so that its point is not defined
:result: weights of level 1 = 0 1
:method: The sign of $w$ is decided as that of a polynomial; that no weight of level 1 is 0 is what is compared.
:control: a positive weight in the middle
:::
*/
CLAIM(negative_weight_takes_a_point_away)
{
    num u[6], w[3], level[3], b[3];
    given_points(T, "t_i", 6, 1, u);
    given_points(T, "w_i", 3, 1, w);
    num tau = given(T, "τ");
    for (int i = 0; i < 3; i++)
        level[i] = w[i];
    G(bspline_to_bezier)(G(on_span)(2, 1, u, 2, w), b);
    G(bspline_deboor_level)(G(on_span)(2, 1, u, 2, NULL), 1, level, tau);
    found_points(T, "weights of level 1", 2, 1, level);
    if (sign_on(poly_from_bernstein(2, b), from_int(0), from_int(1), CLOSED) != SIGN_POSITIVE)
        return;
    about(T, "the weights of level 1 are not 0");
    refute(T, is_zero_q(level[0]) || is_zero_q(level[1]));
}
#endif

#include "chapters/judge/claims_off.h"
