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

:::{claim} segment_needs_the_points_of_its_span
:title: On a span the sum over all points is the sum over the k points of the span
:zh: 在一段上全部项之和即该段 k 项之和
:given: $k=p+1$; $p+3$ points and weights over knots of these patterns: an inner knot of every multiplicity $1,\dots,k$ among
  simple ones, and $k$-fold ends with two simple knots between; every span; any $t$
:then: $\sum_{i=1}^nN_{i,k}(t)w_ir_i=\sum_{i=j-k+1}^jN_{i,k}(t)w_ir_i$, and the same for $w$
:method: The left side runs through all indices by the recursion of de Boor and Cox as it is defined; the right side is
  the sum of the kernel's values on the span.
:degrees: 1..6 sampled 7
:scope: the distinct knots variables for $p\le4$, numbers above
:control: the first point of the span left out
:::
*/
CLAIM(segment_needs_the_points_of_its_span)
{
    int p = T->degree, n = p + 3;
    for (int many = 1; many <= p + 2; many++) {
        char pattern[MOST_KNOTS] = {0};
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
:figure: nurbs_envelope_families

The indices are in range, level $r$ having the indices $j-k+r+1,\dots,j$, and so are the divisors
$t_{i+k-r}-t_i\ge t_{j+1}-t_j$.  With positive weights nothing is undefined.
:::

:::{claim} member_of_span_is_polar
:title: The member is the polar form with r arguments τ and k-1-r arguments t
:zh: 族曲线即极形式
:given: $k=p+1$; a span of simple knots, one with a double knot, and one whose ends are $(k-1)$-fold, the distinct
  knots variables for $k\le5$ and numbers above; weights and points, any $t$ and $\tau$, every $r=0,\dots,k-1$
:then: $\sum N_{i,k-r}(t)\,w_i^{[r]}(\tau)\,(r_i^{[r]}(\tau),1)=f[\tau^r,t^{k-1-r}]$
:method: The left side runs the recursion (4.1.3), (4.1.4), which divides by weights, and sums with the B-splines of
  order $k-r$; the right side is the kernel's polar form of the homogeneous points.  A coordinate is any coordinate,
  so one suffices.
:degrees: 1..6 sampled 7
:scope: the knots variables for $p\le4$, numbers above
:control: one argument $\tau$ of the polar form replaced by $t$
:::
*/
CLAIM(member_of_span_is_polar)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    for (int shape = 0; shape < SHAPES; shape++) {
        num H[2 * (MAX_DEGREE + 1)];
        G(knots_of_span)(T, p, shape, u, place);
        G(rational_homogenize)(p, 1, R, w, H);
        for (int r = 0; r <= p; r++) {
            num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], S[2], f[2], x[MAX_DEGREE];
            G(level_of_curve)(p, 1, u, mu, R, w, r, tau, Rr, wr);
            G(sums)(p - r, 1, u, mu, Rr, wr, t, S);
            for (int k = 0; k < p; k++)
                x[k] = k < r - fault(T, 0, r > 0) ? tau : t;
            G(bspline_span_blossom)(p, 2, u, mu, H, x, f);
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
:given: $k=p+1$; knots of these three shapes; positive weights; $t$ and $\tau$ inside the span
:then: $w_i^{[r]}(\tau)>0$ for all $r=1,\dots,k-2$ and $i=j-k+r+1,\dots,j$, and $\sum N_{i,k-r}(t)w_i^{[r]}(\tau)>0$
:method: With $t=(t_j+t_{j+1}x)/(1+x)$, $\tau$ likewise with $y$, and the gaps of the knots, the weights, $x$ and $y$
  as variables, numerators and denominators have positive coefficients only.  At $t=t_j$ and $\tau=t_j$, that is
  $x=0$, $y=0$, they are positive too: $a\in[0,1]$ in every step of (4.1.3), and a mean of positive numbers is
  positive.
:types: field rational
:degrees: 2..6 sampled 7
:scope: the knots variables for $p\le3$, numbers above
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
    for (int shape = 0; shape < SHAPES; shape++) {
        num u[MOST_KNOTS];
        G(gaps_of_span)(T, p, shape, u);
        for (int k = 0; k < 2; k++) {
            num x = positive(T, "y", k);
            a[k] = div(add(u[mu], mul(x, u[mu + 1])), add(from_int(1), x));
        }
        for (int r = 1; r < p; r++) {
            num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], S[2];
            G(level_of_curve)(p, 1, u, mu, R, w, r, a[1], Rr, wr);
            about(T, "the weights of level r");
            for (int m = 0; m <= p - r; m++)
                nonnegative(T, wr[m]);
            about(T, "the denominator of the member");
            G(sums)(p - r, 1, u, mu, Rr, wr, a[0], S);
            nonnegative(T, S[1]);
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
:holds-by: member_of_extreme_levels
:figure: nurbs_envelope_families

The range leaves out what is no family of curves: for $r=0$ every member is the curve itself, for $r=k-1$ a point of
it.
:::

:::{claim} member_of_extreme_levels
:title: Level 0 gives the curve for every τ, level k-1 its point
:zh: 第 0 层即曲线,第 k-1 层即曲线上的点
:given: $k=p+1$; knots of these three shapes; weights and points, any $t$ and $\tau$
:then: $r^{[k]}(t,\tau)=r(t)$ and $r^{[1]}(t,\tau)=r(\tau)$
:method: The recursion for the members, the kernel of the point for the curve.
:degrees: 1..6 sampled 7
:scope: the knots variables for $p\le4$, numbers above
:control: level $k-2$ in the place of level $k-1$
:::
*/
CLAIM(member_of_extreme_levels)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    for (int shape = 0; shape < SHAPES; shape++) {
        num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], S[2], point;
        G(knots_of_span)(T, p, shape, u, place);
        G(level_of_curve)(p, 1, u, mu, R, w, 0, tau, Rr, wr);
        G(sums)(p, 1, u, mu, Rr, wr, t, S);
        G(nurbs_point)(p, 1, u, mu, R, w, t, &point);
        about(T, "level 0");
        same(T, div(S[0], S[1]), point);
        int last = fault(T, p, p - 1);
        G(level_of_curve)(p, 1, u, mu, R, w, last, tau, Rr, wr);
        G(sums)(p - last, 1, u, mu, Rr, wr, t, S);
        G(nurbs_point)(p, 1, u, mu, R, w, tau, &point);
        about(T, "level k-1");
        same(T, div(S[0], S[1]), point);
    }
}

/*
:::{statement} wang-ch4:formula-4.3.4
:title: On the diagonal the denominators of all levels agree
:zh: t=τ 时各层分母相等
:printed: \sum_{i=j-k+r+1}^jN_{i,k-r}(t)\,w_i^{[r]}(t)=\sum_{i=j-k+r}^jN_{i,k-r+1}(t)\,w_i^{[r-1]}(t)=\dots=w(t)
:holds-by: levels_keep_weight_and_point
:figure: nurbs_envelope_growing
:::

:::{statement} wang-ch4:formula-4.3.5
:title: On the diagonal the numerators of all levels agree
:zh: t=τ 时各层分子相等
:printed: \sum_{i=j-k+r+1}^jN_{i,k-r}(t)\,w_i^{[r]}(t)\mathbf r_i^{[r]}(t)=\sum_{i=j-k+r}^jN_{i,k-r+1}(t)\,
  w_i^{[r-1]}(t)\mathbf r_i^{[r-1]}(t)=\dots=\mathbf p(t)
:holds-by: levels_keep_weight_and_point
:figure: nurbs_envelope_growing
:::

:::{claim} levels_keep_weight_and_point
:title: At τ = t every level sums up to the same weight and the same point
:zh: τ=t 时各层之和相同
:given: $k=p+1$; knots of these three shapes; weights and points, any $t$, every $r=1,\dots,k-2$
:then: both sums of level $r$ over $N_{i,k-r}(t)$ are those of level $r-1$ over $N_{i,k-r+1}(t)$ and those of level 0,
  $w(t)$ and $p(t)$
:method: The levels by (4.1.3), (4.1.4), the sums as printed.
:degrees: 2..6 sampled 7
:scope: the knots variables for $p\le4$, numbers above
:control: the recursion of the level at $\tau=t+1$
:::
*/
CLAIM(levels_keep_weight_and_point)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t");
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    for (int shape = 0; shape < SHAPES; shape++) {
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
  w_i^{[r-1]}(t)=\dots=\frac{k-r-1}{k-1}w'(t)
:holds-by: levels_shrink_the_derivative
:figure: nurbs_envelope_contact

The factors $\frac{k-r-1}{k-r}\cdot\frac{k-r}{k-r+1}\cdots\frac{k-2}{k-1}$ telescope.
:::

:::{statement} wang-ch4:formula-4.3.7
:title: The derivative of the basis at each level gives a fixed part of p'
:zh: 各层基函数求导所得为 p' 的固定倍数
:printed: \sum_{i=j-k+r+1}^jN_{i,k-r}'(t)\,w_i^{[r]}(t)\mathbf r_i^{[r]}(t)=\frac{k-r-1}{k-r}
  \sum_{i=j-k+r}^jN_{i,k-r+1}'(t)\,w_i^{[r-1]}(t)\mathbf r_i^{[r-1]}(t)=\dots=\frac{k-r-1}{k-1}\mathbf p'(t)
:holds-by: levels_shrink_the_derivative
:figure: nurbs_envelope_contact
:::

:::{claim} levels_shrink_the_derivative
:title: The derivative of the basis alone gives (k-r-1)/(k-r) of the level before and (k-r-1)/(k-1) of the curve
:zh: 仅对基函数求导所得的比例
:given: $k=p+1$; knots of these three shapes; weights and points, any $t$, every $r=1,\dots,k-2$
:then: the displays (4.3.6) and (4.3.7), each equality
:method: As before with the derivatives of the B-splines; $w'$ and $p'$ by the derivatives of the basis of order $k$.
:degrees: 2..6 sampled 7
:scope: the knots variables for $p\le4$, numbers above
:control: the factor $\frac{k-r}{k-r+1}$ for one level
:::
*/
CLAIM(levels_shrink_the_derivative)
{
    int p = T->degree, k = p + 1, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t");
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    for (int shape = 0; shape < SHAPES; shape++) {
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
                same(T, S[c], mul(step, before[c]));
                about(T, "the derivatives of numerator and denominator");
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
:figure: nurbs_envelope_growing
:::

:::{statement} wang-ch4:thm-4.3.1-derivative
:title: At τ = t the derivative of the member is a fixed part of that of the curve
:zh: τ=t 时族曲线的导矢与曲线的导矢平行
:printed: \frac{\partial\mathbf r^{[k-r]}(t,\tau)}{\partial t}\Big|_{\tau=t}=\frac{k-r-1}{k-1}\,
  \frac{w(t)\mathbf p'(t)-w'(t)\mathbf p(t)}{w^2(t)}=\frac{k-r-1}{k-1}\mathbf r'(t)\parallel\mathbf r'(t)
:holds-by: member_of_span_touches_curve
:figure: nurbs_envelope_contact
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
:::{claim} member_of_span_touches_curve
:title: At τ = t the member has the point of the curve and (k-r-1)/(k-1) of its derivative
:zh: τ=t 处族曲线与曲线同点,导矢之比为 (k-r-1)/(k-1)
:given: $k=p+1$; knots of these three shapes; weights and points, any $t$, every $r=1,\dots,k-2$
:then: $r^{[k-r]}(t,t)=r(t)$ and
  $\partial_tr^{[k-r]}(t,\tau)=\frac{k-r-1}{k-1}r'(t)=\frac{k-r-1}{k-1}\frac{wp'-w'p}{w^2}$ at $\tau=t$
:method: Member and curve by the kernels of rational derivatives, and the middle term by its letter.  $t$ is any
  number, so the ends of the span are covered, with the derivatives of its polynomials.
:degrees: 2..6 sampled 6
:scope: the knots variables for $p\le4$, numbers above
:control: the factor left out
:::
*/
CLAIM(member_of_span_touches_curve)
{
    int p = T->degree, k = p + 1, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t");
    int place[MOST_KNOTS];
    for (int shape = 0; shape < SHAPES; shape++) {
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
            same(T, E[1], mul(factor, middle));
            same(T, E[1], mul(factor, D[1]));
        }
    }
}

/*
:::{statement} wang-ch4:thm-4.3.1-right-limit
:title: At a knot the derivatives are limits from the right
:zh: 节点处的偏导矢取右极限
:printed: the partial derivatives at a point $t_i$ are understood as limits from the right
:holds-by: member_of_span_touches_curve
:needs: corner_has_two_tangents | the limit is from the right; from the left the curve has, at a $(k-1)$-fold knot,
  another direction than the member of the span on the right
:figure: knot_sides

The knot is $t_j$, the left end of the span that the proof is about; the letter $i$ counts the terms of its sums.
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
    G(nurbs_derivatives)(2, 2, u, fault(T, right, left), R, w, tau, 1, D);
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
:printed: \mathbf r(t)=\mathbf p(t)/w(t)=\operatorname{env}\{\mathbf r^{[k-r]}(t,\tau),\ t_j\le t<t_{j+1}\mid
  t_j\le\tau<t_{j+1}\},\quad j=k,k+1,\dots,n,\ r=1,\dots,k-2,\ k\ge3
:holds-by: member_of_span_touches_curve envelope_condition_holds_on_the_diagonal
:hypothesis: span_member_shrinks_at_a_cusp | $\mathbf r'\ne0$; where it vanishes the member may be a single point
:needs: negative_weight_takes_a_point_away | the weights are positive
:figure: nurbs_envelope_families

This is existence: every member touches the curve, in the point of its own parameter, and nothing else is said here;
that there may be other envelopes is the matter of theorems 4.3.2 and 4.3.3.  Formula (4.3.2) covers the half-open
spans, so that the last point $t_{n+1}$ of the curve is in none of them; the polynomials of the last span reach it. 
For $t_j=t_{j+1}$ the span is empty and nothing is claimed.  The contact is of order 1 where the curvature is not 0,
for every $r$: `curvatures_have_a_fixed_ratio`.
:::

:::{claim} envelope_condition_holds_on_the_diagonal
:title: On the diagonal the derivatives of the member by t and by τ are parallel
:zh: 对角线上族曲线对 t, τ 的偏导矢平行
:given: $k=p+1$; knots of these three shapes; weights and points, any $t$, every $r=1,\dots,k-2$
:then: at $\tau=t$: $\partial_\tau r^{[k-r]}=\frac r{k-1}r'$ and $\partial_tr^{[k-r]}=\frac{k-r-1}{k-1}r'$, so that
  $\partial_\tau r^{[k-r]}\times\partial_tr^{[k-r]}=0$
:method: The derivative by $\tau$ is that of the Bézier curve of degree $r$ that the point, in homogeneous
  coordinates, is in $\tau$; one coordinate.  The two factors add up to 1, as they must: $r^{[k-r]}(t,t)=r(t)$.
:degrees: 2..6 sampled 6
:scope: the knots variables for $p\le4$, numbers above
:control: the factors of the two derivatives exchanged and increased by 1
:::
*/
CLAIM(envelope_condition_holds_on_the_diagonal)
{
    int p = T->degree, k = p + 1, mu = p, more = fault(T, 0, 1);
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t");
    int place[MOST_KNOTS];
    for (int shape = 0; shape < SHAPES; shape++) {
        num D[2];
        G(knots_of_span)(T, p, shape, u, place);
        G(curve_about)(T, p, t, u, R, w);
        G(curve_derivatives)(p, 1, u, mu, R, w, t, 1, D);
        for (int r = 1; r <= k - 2; r++) {
            num E[3];
            G(family_derivatives)(p, 1, u, mu, R, w, r, t, t, E);
            about(T, "the derivative by t");
            same(T, E[1], mul(from_ratio(more ? r + 1 : k - r - 1, k - 1), D[1]));
            about(T, "the derivative by τ");
            same(T, E[2], mul(from_ratio(more ? k - r : r, k - 1), D[1]));
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
CLAIM(span_member_shrinks_at_a_cusp)
{
    num u[8], R[8], w[4], Rr[4 * 2], wr[4], tau = given(T, "τ");
    G(given_curve_of_powers)(T, 3, 2, u, R, w);
    G(level_of_curve)(3, 2, u, 3, R, w, 2, tau, Rr, wr);
    found_points(T, "the two points of the member", 2, 2, Rr);
    about(T, "the two points of the member differ");
    refute(T, equal_q(Rr[0], Rr[2]) && equal_q(Rr[1], Rr[3]));
}

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
    G(bspline_to_bezier)(2, 1, u, 2, w, b);
    G(bspline_deboor_level)(2, 1, u, 2, 1, level, tau);
    found_points(T, "weights of level 1", 2, 1, level);
    if (sign_on(poly_from_bernstein(2, b), from_int(0), from_int(1), CLOSED) != SIGN_POSITIVE)
        return;
    about(T, "the weights of level 1 are not 0");
    refute(T, is_zero_q(level[0]) || is_zero_q(level[1]));
}
#endif

/*
## The whole curve at once

:::{statement} wang-ch4:thm-4.3.1-whole
:title: The whole curve is an envelope of the families with all points
:zh: 整条曲线的包络
:printed: for the whole curve put $t,\tau\in[t_k,t_{n+1}]$ in (4.1.3) and (4.1.4), take $[t_k,t_{n+1}]$ as the domain
  in (4.3.2) and (4.3.3) and let the sums of (4.3.3) run from $r+1$ to $n$; the same holds
:holds-by: whole_member_is_polar_on_every_span member_of_span_touches_curve
:hypothesis: extrapolated_weight_vanishes | $w_i^{[\rho]}(\tau)\ne0$ for all $\tau$ and $i=\rho+1,\dots,n$, $\rho=r$; outside its
  own span the recursion extrapolates, and a point of the member may not exist although all weights are positive
:hypothesis: lower_level_lacks_a_point | and for the levels $\rho=1,\dots,r-1$ as well, since (4.1.4) asks for their points; or the
  products $w_i^{[\rho]}\mathbf r_i^{[\rho]}$ are computed by (4.1.3)
:hypothesis: extrapolated_member_has_a_pole | no denominator of a member vanishes; with a negative $w_i^{[r]}(\tau)$
  it may
:hypothesis: high_knot_leaves_a_point_undefined | the knots inside are at most $(k-r)$-fold, or the terms with $t_i=t_{i+k-r}$,
  whose $N_{i,k-r}$ is 0, are left out; else (4.1.3) divides by 0
:hypothesis: whole_member_ends_in_no_interval | at $t=t_{n+1}$ the limit from the left is meant, when $t_{n+1}=\dots=t_{n+k-r}$:
  otherwise (4.3.3) is $0/0$ there
:hypothesis: span_member_shrinks_at_a_cusp | $\mathbf r'\ne0$
:figure: nurbs_envelope_whole

On the span of $t$ the member $\tau$ is the polar form of *that* segment, continued to a $\tau$ of another span.  On
the span of $\tau$ it is the member of that span, so it touches the curve there.  For equal weights the first three
hypotheses are fulfilled: all $w_i^{[r]}$ are equal.  What is left out is not asked for elsewhere: if $t_i=t_{i+k-r+1}$, then
$t_i=t_{i+k-r}$ and $t_{i+1}=t_{i+1+k-r}$, and the points of the next level that would need $i$ are left out too.
:::
*/

/* The level r of (4.1.3) for all indices, in place: h_i, i = 0, ..., n-1, in the numbering from 0, become the h_i of
 * i = r, ..., n-1; those below stay.  Where a divisor is 0 there is no result, and none is asked for (h_i is set to 0). */
static void G(whole_level)(int n, int p, const num u[], const int place[], int r, num h[], num tau)
{
    for (int i = n - 1; i >= r; i--) {
        int far = i + p + 1 - r;
        if (place[i] == place[far]) {
            h[i] = from_int(0);
            continue;
        }
        num length = sub(u[far], u[i]);
        h[i] = add(mul(div(sub(tau, u[i]), length), h[i]), mul(div(sub(u[far], tau), length), h[i - 1]));
    }
}

/*
:::{claim} whole_member_is_polar_on_every_span
:title: On every span the whole member is the polar form of the segment of that span
:zh: 整条族曲线在每一段上都是该段的极形式
:given: $k=p+1$; points with weights over simple knots, and over knots one of which, inside, is double, $(k-1)$-fold or
  $k$-fold; any $\tau$, $t$ in each span; $r=1,\dots,k-2$
:then: $\sum_{i=r+1}^nN_{i,k-r}(t)\,w_i^{[r]}(\tau)\,(r_i^{[r]}(\tau),1)=f[\tau^r,t^{k-1-r}]$ with the polar form $f$
  of the segment that contains $t$
:method: The recursion (4.1.3) for all indices $i=r+1,\dots,n$, by its letter, in homogeneous coordinates, without the $i$ with
  $t_i=t_{i+k-r}$; the sum of the other terms by the recursion of de Boor and Cox as it is defined; the right side by the kernel.
:degrees: 2..6 sampled 6
:scope: the distinct knots variables for $p\le4$, numbers above
:control: the polar form of the first segment for every span
:::
*/
CLAIM(whole_member_is_polar_on_every_span)
{
    int p = T->degree;
    for (int kind = 0; kind < 4; kind++) {
        char pattern[MOST_KNOTS] = {0};
        int many = kind < 2 ? kind + 1 : p + kind - 2, n = kind < 2 ? p + 3 : p + many + 1;
        for (int i = 0; i < n + p + 2 - many; i++)
            pattern[i] = (char)('0' + (i == p + 1 ? many : 1));
        num u[MOST_KNOTS], H[2 * MOST_KNOTS], h[2][MOST_KNOTS], t = parameter(T, "t"), tau = parameter(T, "s");
        int place[MOST_KNOTS], count = G(knots_of_pattern)(T, pattern, u, place);
        G(numbers_above)(4, p, count, place, u);
        for (int m = 0; m < 2 * n; m++) {
            H[m] = unknown(T, "H", m);
            h[m % 2][m / 2] = H[m];
        }
        for (int r = 1; r <= p - 1; r++) {
            for (int c = 0; c < 2; c++)
                G(whole_level)(n, p, u, place, r, h[c], tau);
            for (int interval = place[p]; interval < place[n]; interval++) {
                int mu = G(span_of_interval)(count, place, fault(T, interval, place[p]));
                num x[MAX_DEGREE], f[2];
                for (int k = 0; k < p; k++)
                    x[k] = k < r ? tau : t;
                G(bspline_blossom)(p, 2, u, mu, H, x, f);
                for (int c = 0; c < 2; c++) {
                    num sum = from_int(0);
                    for (int i = r; i < n; i++)
                        if (place[i] < place[i + p + 1 - r])
                            sum = add(sum, mul(h[c][i], G(cox_de_boor)(p - r, u, place, i, interval, t)));
                    same(T, sum, f[c]);
                }
            }
        }
    }
}

#if RATIONAL
/*
:::{claim} extrapolated_weight_vanishes
:title: With positive weights a point of a member of the whole curve may be missing
:zh: 权全为正时整条曲线的族曲线也可能缺控制顶点
:kind: counterexample
:given: a quadratic curve of four points with the positive weights $w_i$ over the simple knots $t_i$, of two spans;
  $r=1$, and $\tau=t_3$, the start of the domain
:data: t_i = 1 2 3 4 5 6 7; w_i = 1 1 1 3; τ = 3
:instead: w_i = 1 1 1 2
:then: $w_4^{[1]}(\tau)=\frac{\tau-t_4}{t_6-t_4}w_4+\frac{t_6-\tau}{t_6-t_4}w_3=0$, so that $\mathbf r_4^{[1]}(\tau)$
  is not defined; it is a point of the member on $[t_4,t_5]$
:result: weights of level 1 = 1 1 0
:method: (4.1.3) for all indices, exactly; that no weight is 0 is what is compared.
:control: a smaller last weight
:::
*/
CLAIM(extrapolated_weight_vanishes)
{
    num u[7], w[4];
    int place[7];
    given_points(T, "t_i", 7, 1, u);
    given_points(T, "w_i", 4, 1, w);
    num tau = given(T, "τ");
    G(places_of)(7, u, place);
    G(whole_level)(4, 2, u, place, 1, w, tau);
    found_points(T, "weights of level 1", 3, 1, w + 1);
    about(T, "the weights of level 1 are not 0");
    refute(T, is_zero_q(w[1]) || is_zero_q(w[2]) || is_zero_q(w[3]));
}

/*
:::{claim} lower_level_lacks_a_point
:title: A point of a lower level may be missing although no weight of the level vanishes
:zh: 本层权均不为零时低层仍可能缺控制顶点
:kind: counterexample
:given: a cubic curve of five points with the positive weights $w_i$ over the simple knots $t_i$, of two spans; $r=2$,
  and $\tau=t_4$, the start of the domain
:data: t_i = 1 2 3 4 5 6 7 8 9; w_i = 1 1 1 1 4; τ = 4
:instead: w_i = 1 1 1 1 2
:then: no weight of level 2 is 0, but $w_5^{[1]}(\tau)=0$: $\mathbf r_5^{[1]}(\tau)$ is not defined, and $\mathbf
  r_5^{[2]}(\tau)$ is a mean of it and $\mathbf r_4^{[1]}(\tau)$
:result: weights of level 1 = 1 1 1 0; weights of level 2 = 1 1 3/2
:method: (4.1.3) for all indices, exactly; that with the weights of level 2 those of level 1 are not 0 is what is compared.
:control: a smaller last weight
:::
*/
CLAIM(lower_level_lacks_a_point)
{
    num u[9], w[5];
    int place[9], level_two = 1, level_one = 1; /* no weight of the level is 0 */
    given_points(T, "t_i", 9, 1, u);
    given_points(T, "w_i", 5, 1, w);
    num tau = given(T, "τ");
    G(places_of)(9, u, place);
    G(whole_level)(5, 3, u, place, 1, w, tau);
    found_points(T, "weights of level 1", 4, 1, w + 1);
    for (int i = 1; i < 5; i++)
        level_one &= !is_zero_q(w[i]);
    G(whole_level)(5, 3, u, place, 2, w, tau);
    found_points(T, "weights of level 2", 3, 1, w + 2);
    for (int i = 2; i < 5; i++)
        level_two &= !is_zero_q(w[i]);
    about(T, "the weights of level 2 not being 0, those of level 1 are not 0");
    refute(T, level_two && !level_one);
}

/*
:::{claim} whole_member_ends_in_no_interval
:title: At the end of a clamped curve numerator and denominator of a member are 0
:zh: 端点为重节点时族曲线在右端为 0/0
:kind: counterexample
:given: a clamped cubic curve of five points with equal weights over the knots $t_i$, and one knot more; $r=1$, and
  $t=\tau=t_{n+1}$, which lies in $[t_9,t_{10})$ and in no interval before
:data: t_i = 0 0 0 0 1 2 2 2 2 3; t = 2
:then: $\sum_{i=2}^5N_{i,3}(t)w_i^{[1]}(\tau)=0$
:result: weights of level 1 = 1 1 1 1; denominator at t = 0
:method: Both recursions by their letter, for the interval that contains $t$.
:control: the interval before, which is the limit from the left
:::
*/
CLAIM(whole_member_ends_in_no_interval)
{
    num u[10], w[5], sum = from_int(0);
    int place[10];
    given_points(T, "t_i", 10, 1, u);
    num t = given(T, "t");
    G(places_of)(10, u, place);
    int interval = G(interval_of)(10, u, place, t), before = interval - 1;
    for (int i = 0; i < 5; i++)
        w[i] = from_int(1);
    G(whole_level)(5, 3, u, place, 1, w, t);
    for (int i = 1; i < 5; i++)
        sum = add(sum, mul(w[i], G(cox_de_boor)(2, u, place, i, fault(T, before, interval), t)));
    found_points(T, "weights of level 1", 4, 1, w + 1);
    found(T, "denominator at t", sum);
    about(T, "the denominator of the member is not 0");
    refute(T, is_zero_q(sum));
}

/*
:::{claim} extrapolated_member_has_a_pole
:title: With positive weights a member of the whole curve may run to infinity
:zh: 权全为正时整条曲线的族曲线也可能有极点
:kind: counterexample
:given: a curve as in `extrapolated_weight_vanishes`, the last weight still larger; $r=1$, $\tau=t_3$, and a $t$ of
  the last span
:data: t_i = 1 2 3 4 5 6 7; w_i = 1 1 1 5; τ = 3; t = 9/2
:instead: w_i = 1 1 1 2
:then: no weight of level 1 is 0, but $\sum_{i=2}^4N_{i,2}(t)w_i^{[1]}(\tau)=0$
:result: weights of level 1 = 1 1 -1; denominator = 0
:method: The weights of level 1 by (4.1.3), their sum with the B-splines of order 2; compared with 0.
:control: a smaller last weight
:::
*/
CLAIM(extrapolated_member_has_a_pole)
{
    num u[7], w[4], sum = from_int(0);
    int place[7];
    given_points(T, "t_i", 7, 1, u);
    given_points(T, "w_i", 4, 1, w);
    num tau = given(T, "τ"), t = given(T, "t");
    G(places_of)(7, u, place);
    G(whole_level)(4, 2, u, place, 1, w, tau);
    for (int i = 1; i < 4; i++)
        sum = add(sum, mul(w[i], G(cox_de_boor)(1, u, place, i, G(interval_of)(7, u, place, t), t)));
    found_points(T, "weights of level 1", 3, 1, w + 1);
    found(T, "denominator", sum);
    about(T, "the denominator of the member is not 0");
    refute(T, is_zero_q(sum));
}

/*
:::{claim} high_knot_leaves_a_point_undefined
:title: At a knot of multiplicity k-r+1 the recursion for all indices divides by 0
:zh: 内节点重数达 k-r+1 时递推分母为零
:kind: counterexample
:given: a clamped curve of order $k$, two segments, with $n$ points and the knots $t_i$; $r$; a $\tau$ of the second
  segment
:data: k = 4; n = 7; t_i = 0 0 0 0 1 1 1 2 2 2 2; r = 2; τ = 3/2
:instead: n = 6; t_i = 0 0 0 0 1 1 2 2 2 2
:then: $t_{i+k-r}-t_i=0$ for an index $i$ of $r+1,\dots,n$, and at $\tau$ the numerator of the printed coefficient of
  $w_i^{[r-1]}$ is not 0
:result: divisors that are 0 = 1; i = 5; τ - t_i = 1/2
:method: All divisors of (4.1.3) for $i=r+1,\dots,n$ are computed; that none is 0 is what is compared.
:control: the inner knot double
:::
*/
CLAIM(high_knot_leaves_a_point_undefined)
{
    enum { MOST = 11 };
    int k = given_whole(T, "k"), n = given_whole(T, "n"), zeros = 0, index = 0;
    num t[MOST + 1], numerator = from_int(0);
    given_points(T, "t_i", n + k, 1, t + 1);
    int r = given_whole(T, "r");
    num tau = given(T, "τ");
    for (int i = r + 1; i <= n; i++)
        if (equal_q(t[i + k - r], t[i])) {
            zeros++;
            index = i;
            numerator = sub(tau, t[i]);
        }
    found_whole(T, "divisors that are 0", zeros);
    found_whole(T, "i", index);
    found(T, "τ - t_i", numerator);
    about(T, "no divisor t_{i+k-r} - t_i is 0, or no numerator is left");
    refute(T, zeros > 0 && !is_zero_q(numerator));
}
#endif

/*
## Special cases

:::{statement} wang-ch4:cor-4.3.1-polynomial
:title: With equal weights the family is that of the B-spline curve
:zh: 权相等时即 B 样条曲线的包络定理
:printed: when the $w_i$ are constant, theorem 2.2.2 results
:holds-by: equal_weights_give_the_polynomial_family
:figure: nurbs_envelope_contact

Theorem 2.2.2 is not among the sources at hand; it is taken to be the same theorem for B-spline curves and their
recursion.
:::

:::{claim} equal_weights_give_the_polynomial_family
:title: With equal weights all levels have these weights, and their points are those of de Boor's algorithm
:zh: 权相等时各层权不变
:given: $k=p+1$; knots of these three shapes; one weight $w_1$ for all points; any $\tau$, $r=1,\dots,k-1$
:then: $w_i^{[r]}(\tau)=w_1$, and $r_i^{[r]}(\tau)$ is the point of level $r$ of de Boor's triangle without weights
:method: The rational recursion against the kernel of de Boor's levels, one coordinate.
:degrees: 1..6 sampled 7
:scope: the knots variables for $p\le4$, numbers above
:control: the first weight different
:::
*/
CLAIM(equal_weights_give_the_polynomial_family)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], tau = parameter(T, "s"), all = positive(T, "w", 1);
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    for (int i = 0; i <= p; i++)
        w[i] = fault(T, all, i == 0 ? add(all, from_int(1)) : all);
    for (int shape = 0; shape < SHAPES; shape++) {
        num d[MAX_DEGREE + 1], Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1];
        G(knots_of_span)(T, p, shape, u, place);
        for (int i = 0; i <= p; i++)
            d[i] = R[i];
        for (int r = 1; r <= p; r++) {
            G(bspline_deboor_level)(p, 1, u, mu, r, d, tau);
            G(level_of_curve)(p, 1, u, mu, R, w, r, tau, Rr, wr);
            for (int m = 0; m <= p - r; m++) {
                same(T, wr[m], all);
                same(T, Rr[m], d[m]);
            }
        }
    }
}

/*
:::{statement} wang-ch4:cor-4.3.1-bezier
:title: Between (k-1)-fold knots the theorem on rational Bézier curves results
:zh: 两端均为 k-1 重节点时得出有理 Bézier 曲线的包络定理
:printed: when $t_j$ and $t_{j+1}$ are both $(k-1)$-fold knots, theorem 3.3.2 results
:reading: bezier_span_gives_the_bezier_family | the family is that of theorem 3.3.2: true
:reading: member_of_span_touches_curve | the envelope is that of theorem 3.3.2, a curve that every member touches: true, wherever
  $\mathbf r'\ne0$
:reading: cubic_member_has_other_curvature | the whole of theorem 3.3.2, with contact of order $n-r$, $n=k-1$: false, there as here
:figure: bezier_knots
:::

:::{claim} bezier_span_gives_the_bezier_family
:title: Between (k-1)-fold knots level r is level r of the rational de Casteljau triangle, and the basis is Bernstein's
:zh: k-1 重节点之间的族即有理 Bézier 曲线族
:given: $k=p+1$; a span whose ends are $(k-1)$-fold knots; weights and points, any $t$ and $\tau$, $r=0,\dots,k-1$
:then: with $\lambda=\frac{\tau-t_j}{t_{j+1}-t_j}$: $w_i^{[r]}$ and $r_i^{[r]}$ are the weights and points of level
  $r$ of the rational de Casteljau triangle at $\lambda$, and
  $N_{i,k-r}(t)=B_{i-j+k-r-1}^{k-r-1}\bigl(\frac{t-t_j}{t_{j+1}-t_j}\bigr)$
:method: Kernel against kernel: the recursion over knots, and the recursion and the basis of chapter 3, which know
  nothing of knots.
:degrees: 1..6 sampled 7
:scope: the knots variables for $p\le4$, numbers above
:control: $1-\lambda$ in the place of $\lambda$
:::
*/
CLAIM(bezier_span_gives_the_bezier_family)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    G(knots_of_span)(T, p, 1, u, place);
    num length = sub(u[mu + 1], u[mu]), lambda = div(sub(tau, u[mu]), length), local = div(sub(t, u[mu]), length);
    lambda = fault(T, lambda, sub(from_int(1), lambda));
    for (int r = 0; r <= p; r++) {
        num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], Br[MAX_DEGREE + 1], br[MAX_DEGREE + 1];
        num N[MAX_DEGREE + 1], B[MAX_DEGREE + 1];
        G(level_of_curve)(p, 1, u, mu, R, w, r, tau, Rr, wr);
        G(rational_casteljau)(p, 1, R, w, lambda, r, Br, br);
        G(bspline_basis)(p - r, u, mu, t, N);
        G(bernstein_basis)(p - r, local, B);
        for (int m = 0; m <= p - r; m++) {
            about(T, "points and weights of level r");
            same(T, Rr[m], Br[m]);
            same(T, wr[m], br[m]);
            about(T, "the basis of order k-r");
            same(T, N[m], B[m]);
        }
    }
}

/*
:::{statement} wang-ch4:formula-4.3.8
:title: The lines of the family of order 2
:zh: 直线族的方程
:printed: \mathbf r^{[2]}(t,\tau)=\frac{(t_{j+1}-t)w_{j-1}^{[k-2]}(\tau)\mathbf
  r_{j-1}^{[k-2]}(\tau)+(t-t_j)w_j^{[k-2]}(\tau)\mathbf
  r_j^{[k-2]}(\tau)}{(t_{j+1}-t)w_{j-1}^{[k-2]}(\tau)+(t-t_j)w_j^{[k-2]}(\tau)},\quad t_j\le t,\tau<t_{j+1}
:holds-by: lines_of_the_family_by_two_points
:figure: nurbs_envelope_families
:::

:::{statement} wang-ch4:cor-4.3.1-lines
:title: For k-r = 2 the curve is an envelope of straight lines
:zh: k-r=2 时曲线是直线族的包络
:printed: for $k-r=2$ the curve $\mathbf r(t)$ is the envelope of the family of straight lines (4.3.8)
:holds-by: member_of_span_touches_curve lines_of_the_family_by_two_points
:hypothesis: span_member_shrinks_at_a_cusp | $\mathbf r'\ne0$; at a cusp the line is a point
:figure: nurbs_envelope_families

The lines are segments, the legs that de Boor's algorithm draws last.
:::

:::{claim} lines_of_the_family_by_two_points
:title: The member of order 2 is the printed quotient of two points
:zh: 二阶族曲线即所印的两点之商
:given: $k=p+1$; knots of these three shapes; weights and points, any $t$ and $\tau$; $r=k-2$
:then: (4.3.3) is (4.3.8)
:method: Both quotients by their letter, one coordinate.
:degrees: 2..6 sampled 7
:scope: the knots variables for $p\le4$, numbers above
:control: $t-t_j$ and $t_{j+1}-t$ exchanged
:::
*/
CLAIM(lines_of_the_family_by_two_points)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    for (int shape = 0; shape < SHAPES; shape++) {
        num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], S[2];
        G(knots_of_span)(T, p, shape, u, place);
        G(level_of_curve)(p, 1, u, mu, R, w, p - 1, tau, Rr, wr);
        G(sums)(1, 1, u, mu, Rr, wr, t, S);
        num up = sub(t, u[mu]), down = sub(u[mu + 1], t);
        num left = mul(fault(T, down, up), wr[0]), right = mul(fault(T, up, down), wr[1]);
        same(T, div(S[0], S[1]), div(add(mul(left, Rr[0]), mul(right, Rr[1])), add(left, right)));
    }
}

/*
## The order of contact

The source says that the derivatives are parallel, and no more; rightly.  Let $m=k-1-r$ be the degree of the member and
$n=k-1$ that of the curve.  The homogeneous derivatives of member and curve at $\tau=t$ are parallel in every order,
with the factors $\frac{m!/(m-i)!}{n!/(n-i)!}$, which do not depend on the knots.  So the contact is what it is for
rational Bézier curves: it is of order 1 wherever the curvature is not 0, and the member is always flatter than the
curve.

:::{claim} span_derivatives_are_parallel
:title: The homogeneous derivatives of member and curve are parallel in every order
:zh: 族曲线与曲线的各阶齐次导矢平行
:given: $k=p+1$; knots of these three shapes; weights and points, any $t$, every $r=0,\dots,k-1$ and $i=0,\dots,k-1-r$
:then: with $n=k-1$, $m=n-r$: $\frac{n!}{(n-i)!}\,\partial_t^iP^{[r]}(t,t)=\frac{m!}{(m-i)!}\,P^{(i)}(t)$ for the
  coordinate and for the weight
:method: The levels of de Boor's triangle in homogeneous coordinates, and the kernel of the derivatives of a segment.
:degrees: 1..6 sampled 7
:scope: the knots variables for $p\le4$, numbers above
:control: the factors left out
:::
*/
/* n!/(n-k)! */
static long G(falling)(int n, int k) { return k == 0 ? 1 : n * G(falling)(n - 1, k - 1); }

CLAIM(span_derivatives_are_parallel)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], H[2 * (MAX_DEGREE + 1)], t = parameter(T, "t");
    int place[MOST_KNOTS];
    for (int m = 0; m < 2 * (p + 1); m++)
        H[m] = unknown(T, "H", m);
    for (int shape = 0; shape < SHAPES; shape++) {
        num D[2 * (MAX_DEGREE + 1)], E[2 * (MAX_DEGREE + 1)], d[2 * (MAX_DEGREE + 1)];
        G(knots_of_span)(T, p, shape, u, place);
        G(bspline_span_derivatives)(p, 2, u, mu, H, t, p, D);
        for (int m = 0; m < 2 * (p + 1); m++)
            d[m] = H[m];
        for (int r = 0; r <= p; r++) {
            if (r > 0)
                G(bspline_deboor_level)(p, 2, u, mu, r, d, t);
            G(bspline_span_derivatives)(p - r, 2, u, mu, d, t, p - r, E);
            for (int m = 0; m < 2 * (p - r + 1); m++) {
                long a = fault(T, G(falling)(p, m / 2), 1), b = fault(T, G(falling)(p - r, m / 2), 1);
                same(T, mul(from_int(a), E[m]), mul(from_int(b), D[m]));
            }
        }
    }
}

/*
:::{claim} curvatures_have_a_fixed_ratio
:title: Member and curve turn in a fixed ratio, which depends on k and r only
:zh: 族曲线与曲线的曲率之比只与 k, r 有关
:given: the derivatives $P,P',P''$ of a curve with weight $w>0$, two coordinates, and those of the member,
  $P$, $\frac mnP'$, $\frac{m(m-1)}{n(n-1)}P''$; any $n$ and $m$
:then: $r_m'=\frac mnr'$ and $r_m'\times r_m''=\frac{m^2(m-1)}{n^2(n-1)}\,r'\times r''$, hence
  $\frac{\kappa_m}{\kappa}=\frac{n(m-1)}{m(n-1)}$, which is less than 1 for $m<n$: the contact is of order 1 where
  $\kappa\ne0$
:method: Quotient rule with $n$ and $m$ as variables.  The two coordinates are any two, so it holds in space as well.
  $m(n-1)-n(m-1)=n-m=r$.
:degrees: all
:control: the ratio $\frac{m(m-1)}{n(n-1)}$ for the determinants
:::
*/
CLAIM(curvatures_have_a_fixed_ratio)
{
    num n = parameter(T, "n"), m = parameter(T, "m"), one = from_int(1), R[2][6];
    num first = div(m, n), second = div(mul(m, sub(m, one)), mul(n, sub(n, one)));
    num P[9];
    for (int i = 0; i < 9; i++)
        P[i] = i == 2 ? positive(T, "w", 0) : unknown(T, "P", i);
    for (int j = 0; j < 2; j++) {
        num D[9];
        for (int i = 0; i < 9; i++)
            D[i] = mul(j == 0 || i < 3 ? one : i < 6 ? first : second, P[i]);
        G(rational_quotient_derivatives)(2, D, 2, R[j]);
    }
    about(T, "the first derivatives");
    same(T, R[1][2], mul(first, R[0][2]));
    num ratio = fault(T, mul(first, second), second);
    about(T, "the determinants of the derivatives");
    same(T, G(cross2)(R[1] + 2, R[1] + 4), mul(ratio, G(cross2)(R[0] + 2, R[0] + 4)));
}

#if !FIELD
/*
:::{claim} curvature_of_the_span_member
:title: The ratio of the curvatures, measured on curves of the plane and of space
:zh: 曲率比的直接计算
:types: rational interval double
:given: $k=p+1$; the three shapes of knots, weights and points of the plane and of space, any $t$, $r=1,\dots,k-2$
:then: $((k-r-1)(k-2))^2\,\kappa^2_{k-r}(t)=((k-1)(k-r-2))^2\,\kappa^2(t)$
:method: The second way: the points of the member by (4.1.3), (4.1.4), and the curvatures of both curves by their
  derivatives.
:degrees: 2..4 sampled 5
:control: the ratio $\frac{k-r-2}{k-2}$
:::
*/
CLAIM(curvature_of_the_span_member)
{
    int p = T->degree, k = p + 1, mu = p;
    num u[MOST_KNOTS], R[3 * (MAX_DEGREE + 1)], w[MAX_DEGREE + 1];
    int place[MOST_KNOTS];
    for (int dim = 2; dim <= 3; dim++)
        for (int shape = 0; shape < SHAPES; shape++) {
            num t = parameter(T, "t"), D[9], E[9];
            G(free_curve)(T, p, dim, R, w);
            G(knots_of_span)(T, p, shape, u, place);
            t = add(u[mu], mul(t, sub(u[mu + 1], u[mu])));
            G(curve_derivatives)(p, dim, u, mu, R, w, t, 2, D);
            for (int r = 1; r <= k - 2; r++) {
                num Rr[3 * (MAX_DEGREE + 1)], wr[MAX_DEGREE + 1];
                G(level_of_curve)(p, dim, u, mu, R, w, r, t, Rr, wr);
                G(curve_derivatives)(p - r, dim, u, mu, Rr, wr, t, 2, E);
                int a = fault(T, k - r - 1, 1) * (k - 2), b = fault(T, k - 1, 1) * (k - r - 2);
                same(T, mul(from_int((long)a * a), G(curvature_squared)(dim, E + dim, E + 2 * dim)),
                     mul(from_int((long)b * b), G(curvature_squared)(dim, D + dim, D + 2 * dim)));
            }
        }
}
#endif

#include "chapters/judge/claims_off.h"
