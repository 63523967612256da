/*
# The envelope (包络)

De Casteljau's triangle at the parameter $c$ passes through the levels $r=0,1,\dots,n$.  Level $r$ has $n-r+1$
points with weights; they are a control polygon, and its curve, of degree $n-r$, is the *member* $c$ of a family.
This section asks how the curve and the members of its family touch.

Everything follows from one remark.  Write $P(t)=(\omega(t)R(t),\omega(t))$ for the curve in homogeneous
coordinates and $p$ for its polar form (极形式): symmetric in $n$ arguments, of degree one in each, with
$p(t,\dots,t)=P(t)$.  Then the member is

$$P^{[n-r]}(t,c)=p(\underbrace{c,\dots,c}_r,\underbrace{t,\dots,t}_{n-r}),$$

written $p(c^r,t^{n-r})$, and the curve is what one gets for $t=c$.  The direction $\delta=1-0$ may stand in the
place of an argument: $p(\delta,\cdot)=p(1,\cdot)-p(0,\cdot)$.  The interval is taken as $[0,1]$; for $[a,b]$ the
numbers $t$ and $c$ stand for $(t-a)/(b-a)$ and $(c-a)/(b-a)$.
*/
#include "exact/record/roots.h"

#include "chapters/rational-bezier/free-curve.h"
#include "chapters/rational-bezier/polar-form.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch3:3.3.4
:title: The family of curves of degree n-r
:zh: 曲线族的定义
:printed: \mathbf R^{[n-r]}(t,c)=\frac{\sum_{i=0}^{n-r}B_i^{n-r}(\frac{t-a}{b-a})\,\omega_{i+r}^r(c)\,\mathbf
  R_{i+r}^r(c)} {\sum_{i=0}^{n-r}B_i^{n-r}(\frac{t-a}{b-a})\,\omega_{i+r}^r(c)},\quad a\le t\le b,\ a\le c\le b
:definition: yes
:checked-by: triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power weighted_points_are_cut_like_the_weights
  cut_coefficients_are_convex
:confirmed-by: member_is_a_polar_curve
:needs: member_may_lose_a_point | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive; else a weight $\omega_i^r(c)$ may vanish and its point does not exist
:needs: cut_outside_can_fail | the formula: $a\le c\le b$ | $a\le c\le b$: outside a weight of the triangle may vanish although all $\omega_i>0$
:needs: member_may_have_a_pole_outside | the formula: $a\le t\le b$ | $a\le t\le b$: outside the denominator may vanish although all $\omega_i>0$
:figure: envelope_families

In the source this is the member of the set of which $\mathbf R(t)$ is said to be the envelope.  The indices are in range: level $r$ has the indices $r,\dots,n$.  With positive weights the denominator
does not vanish: it is the last weight of the triangle that begins with the $\omega_{i+r}^r(c)$ and divides at $t$.
:::
*/

/*
:::{claim} member_is_a_polar_curve
:title: The member is the polar form with r arguments c and n-r arguments t
:zh: 族曲线即极形式 p(c^r, t^{n-r})
:given: weights $\omega_0,\dots,\omega_n$ and points $R_0,\dots,R_n$, any $t$ and $c$, every $r=0,\dots,n$
:then: $\sum B_i^{n-r}(t)\,\omega_{i+r}^r(c)\,(R_{i+r}^r(c),1)=p(c^r,t^{n-r})$
:method: The left side runs the recursion (3.3.2), (3.3.3), which divides by weights, and then sums; the right side
  evaluates the polar form of the homogeneous points.  A coordinate is any coordinate, so one suffices.
:degrees: 1..6 sampled 10
:over: c
:control: one argument $c$ of the polar form replaced by $t$
:::
*/
CLAIM(member_is_a_polar_curve)
{
    int n = T->degree;
    num R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], H[2 * MAX_DEGREE + 2], c = parameter(T, "c"), t = parameter(T, "t");
    G(free_curve)(T, n, 1, R, w);
    G(rational_homogenize)(n, 1, R, w, H);
    for (int r = 0; r <= n; r++) {
        num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], Hr[2 * MAX_DEGREE + 2], sum[2], p[2];
        G(rational_casteljau)(n, 1, R, w, c, r, Rr, wr);
        G(rational_homogenize)(n - r, 1, Rr, wr, Hr);
        G(bezier_casteljau)(n - r, 2, Hr, t, sum);
        G(polar)(n, 2, H, fault(T, r, r > 0 ? r - 1 : r), c, n - r, t, t, t, p);
        about(T, "numerator and denominator of the member");
        same(T, sum[0], p[0]);
        same(T, sum[1], p[1]);
    }
}

/*
Who evaluates a point throws the middle of the triangle away.  It is worth keeping: each level, with its weights, is a
control polygon, and the polar form says of which curve.

:::{statement} wang-ch3:thm-3.3.2-vertices
:title: What the points of an intermediate level mean
:zh: 离散中间层顶点的几何意义
:printed: The geometric meaning of the vertices of an intermediate step of cutting: for $n\ge2$, (3.3.2) and (3.3.3) determine a family of rational Bézier curves of degree
  $n-r$, $r=1,2,\dots,n-1$, (3.3.4), one for each $c$, $a\le c\le b$.
:holds-by: triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power weighted_points_are_cut_like_the_weights
  cut_coefficients_are_convex
:confirmed-by: member_is_a_polar_curve
:needs: member_may_lose_a_point | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive; else a weight $\omega_i^r(c)$ may vanish and its point does not exist
:needs: cut_outside_can_fail | the formula (3.3.4): $a\le c\le b$ | $a\le c\le b$: outside a weight of the triangle may vanish although all $\omega_i>0$
:needs: member_may_have_a_pole_outside | the formula (3.3.4): $a\le t\le b$ | $a\le t\le b$: outside the denominator may vanish although all $\omega_i>0$
:figure: triangle_point_at_infinity

The vertices $\mathbf R_{r+i}^r(c)$, $i=0,\dots,n-r$, with the weights $\omega_{r+i}^r(c)$ are the control polygon of the curve of the parameter $c$.  With positive weights the denominator of (3.3.4) does not vanish: it is the last weight of the triangle that begins with the $\omega_{i+r}^r(c)$ and divides at $t$.
:::
*/

#if RATIONAL
/*
:::{claim} member_may_lose_a_point
:title: With a negative weight a control point of a member may be missing
:zh: 权为负时族曲线可能缺控制顶点
:kind: counterexample
:data: ω = 1 -1/2 1; c = 2/3
:instead: ω = 1 1/2 1
:result: real zeros of ω(t) = 0; ω_1^1, ω_2^1 = 0 1/2
:given: $n=2$, three weights $\omega$, the middle one negative, whose $\omega(t)$ has no real zero; $r=1$ and a
  parameter $c$
:then: $\omega_1^1(c)=0$, so that $R_1^1(c)$ is not defined although $\omega(t)$ has no real zero
:method: The zeros of $\omega(t)$ are counted, and the weights of level 1 are computed exactly; that they are not 0 is
  what is compared.
:control: the middle weight with the other sign
:::
*/
CLAIM(member_may_lose_a_point)
{
    num w[3];
    given_points(T, "ω", 3, 1, w);
    num c = given(T, "c");
    int zeros = count_roots_line(poly_from_bernstein(2, w)).distinct;
    G(bezier_casteljau_level)(2, 1, w, c);
    found_whole(T, "real zeros of ω(t)", zeros);
    found_points(T, "ω_1^1, ω_2^1", 2, 1, w);
    about(T, "the weights of level 1 are not 0");
    refute(T, zeros == 0 && (is_zero_q(w[0]) || is_zero_q(w[1])));
}

/*
:::{claim} member_may_have_a_pole_outside
:title: Outside the interval the denominator of a member may vanish
:zh: 区间外族曲线的分母可为零
:kind: counterexample
:data: ω = 1 1 2; c = 1/2; t = -2
:instead: t = 1/2
:result: ω_1^1, ω_2^1 = 1 3/2; denominator = 0
:given: $n=2$, three positive weights $\omega$, $[a,b]=[0,1]$; $r=1$, a parameter $c$ inside and a $t$ outside
:then: $(1-t)\,\omega_1^1(c)+t\,\omega_2^1(c)=0$, and the member has no point there
:method: The weights of level 1 and the denominator are computed exactly; that it is not 0 is what is compared.
:control: $t$ inside the interval
:::
*/
CLAIM(member_may_have_a_pole_outside)
{
    num w[3];
    given_points(T, "ω", 3, 1, w);
    num c = given(T, "c"), t = given(T, "t");
    G(bezier_casteljau_level)(2, 1, w, c);
    num denominator = add(mul(sub(from_int(1), t), w[0]), mul(t, w[1]));
    found_points(T, "ω_1^1, ω_2^1", 2, 1, w);
    found(T, "denominator", denominator);
    about(T, "the denominator is not 0");
    refute(T, is_zero_q(denominator));
}
#endif

/*
## R touches every member

At $t=c$ the member and the curve have a common point, and their derivatives there are parallel: they differ by
the factor $(n-r)/n$.  So wherever the curve has a tangent at all, the member has the same one.

:::{statement} wang-ch3:thm-3.3.2-touch
:title: The curve and the member of parameter c touch at t = c
:zh: 曲线与族曲线在 t=c 处相切
:printed: The point of contact of the curve $\mathbf R(t)$, of degree $n\ge2$, and the curve $\mathbf R^{[n-r]}(t,c)$ of the family, $r=1,2,\dots,n-1$, $a\le c\le b$, is at
  $c=t$.
:holds-by: members_are_flatter_powers triangle_of_powers_consists_of_powers cut_coefficients_are_convex
  bernstein_sum_of_powers_is_a_power
:confirmed-by: member_touches_curve
:hypothesis: member_shrinks_at_a_cusp | $\mathbf R'(c)\ne0$; where it vanishes the member may be a single point
:needs: member_may_lose_a_point | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive
:needs: cut_outside_can_fail | the formula (3.3.4): $a\le c\le b$ | $a\le c\le b$: outside a weight of the triangle may vanish, as $\omega_1^1$ in the example, whatever the other weights are
:meant: the words point of contact (接触点) | A point that both curves have, and in which they have one tangent.
:figure: envelope_cusp

The two derivatives are parallel and, for $r\ge1$ and $R'(c)\ne0$, not equal.
That they touch nowhere else is not claimed: a tangent, the member of $r=n-1$, may touch the curve in a second point.
:::

:::{claim} member_touches_curve
:title: At t = c the member has the point of the curve and (n-r)/n of its derivative
:zh: t=c 处族曲线与曲线同点，导矢之比为 (n-r)/n
:given: weights and points, $n\ge2$, any $c$, every $r=1,\dots,n-1$
:then: $R^{[n-r]}(c,c)=R(c)$ and $\partial_tR^{[n-r]}(t,c)=\frac{n-r}nR'(c)$ at $t=c$
:method: Both sides, with the recursion for the member, are one element of the field of rational functions of $c$, the
  weights and the points.  Where $R'(c)\ne0$ both curves have that direction as tangent.
:degrees: 2..6 sampled 10
:over: c
:control: the factor $(n-r)/n$ left out
:::
*/
CLAIM(member_touches_curve)
{
    int n = T->degree;
    num R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], D[2], c = parameter(T, "c");
    G(free_curve)(T, n, 1, R, w);
    G(rational_derivatives)(n, 1, R, w, c, 1, D);
    for (int r = 1; r < n; r++) {
        num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], E[2];
        G(rational_casteljau)(n, 1, R, w, c, r, Rr, wr);
        G(rational_derivatives)(n - r, 1, Rr, wr, c, 1, E);
        about(T, "the common point");
        same(T, E[0], D[0]);
        about(T, "the derivatives at t = c");
        /* ∂R^{[n-r]}/∂t = (n-r)/n R'(c) */
        same(T, E[1], fault(T, mul(from_ratio(n - r, n), D[1]), D[1]));
    }
}

#if RATIONAL
/*
The factor $(n-r)/n$ does not turn a direction, but it presupposes one.  At a cusp of the curve $R'$ is 0 and nothing
is left to agree in.

:::{claim} member_shrinks_at_a_cusp
:title: Where the derivative of the curve vanishes the line of the family may be a point
:zh: 尖点处的族直线退化为点
:kind: counterexample
:data: R = (1,-1) (-1/3,1) (-1/3,-1) (1,1); ω = 1 1 1 1; r = 2; c = 1/2
:instead: c = 3/4
:result: R'(c) = (0,0); the member's points = (0,0) (0,0)
:given: the points $R$ of the cubic $(\tau^2,\tau^3)$, $-1\le\tau\le1$, equal weights, the last level $r<n$, and the
  parameter $c$ of the cusp
:then: the member, of degree 1, is a point: it has no tangent that could be common
:method: The two control points of the member are computed exactly; that they differ is what is compared.
:control: a parameter beside the cusp
:::
*/
CLAIM(member_shrinks_at_a_cusp)
{
    num R[8], w[4], Rr[4], wr[2], D[4];
    given_points(T, "R", 4, 2, R);
    given_points(T, "ω", 4, 1, w);
    int r = given_whole(T, "r");
    num c = given(T, "c");
    G(rational_derivatives)(3, 2, R, w, c, 1, D);
    found_points(T, "R'(c)", 1, 2, D + 2);
    G(rational_casteljau)(3, 2, R, w, c, r, Rr, wr);
    found_points(T, "the member's points", 2, 2, Rr);
    about(T, "the two control points of the member differ");
    refute(T, equal_q(Rr[0], Rr[2]) && equal_q(Rr[1], Rr[3]));
}
#endif

/*
:::{statement} wang-ch3:thm-3.3.2-range
:title: The levels 1, ..., n-1 of a curve of degree at least 2
:zh: r 与 n 的取值范围
:printed: The theorem is about degree $n\ge2$ and the levels $r=1,2,\dots,n-1$.
:definition: yes
:checked-by: triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power cut_coefficients_are_convex
:confirmed-by: extreme_levels_are_curve_and_point
:needs: member_may_lose_a_point | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive; else a weight $\omega_i^r(c)$ may vanish and its point does not exist

A range is set, not claimed.  What is checked is that it leaves out what is no family of curves: for $r=0$ every member is the curve itself, for $r=n$ a point of
it, and for $n=1$ nothing is left.
:::

:::{claim} extreme_levels_are_curve_and_point
:title: Level 0 gives the curve for every c, level n its point R(c)
:zh: 第 0 层即曲线，第 n 层即点 R(c)
:given: weights and points, any $t$ and $c$
:then: $R^{[n]}(t,c)=R(t)$ and $R^{[0]}(t,c)=R(c)$
:method: Recursion for the left sides, the formula of the curve for the right sides.
:degrees: 1..6 sampled 10
:over: c
:control: level $n-1$ in the place of level $n$
:::
*/
CLAIM(extreme_levels_are_curve_and_point)
{
    int n = T->degree;
    num R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], member, point;
    num c = parameter(T, "c"), t = parameter(T, "t");
    G(free_curve)(T, n, 1, R, w);
    G(rational_casteljau)(n, 1, R, w, c, 0, Rr, wr);
    G(rational_point)(n, 1, Rr, wr, t, &member);
    G(rational_point)(n, 1, R, w, t, &point);
    same(T, member, point);
    int last = fault(T, n, n - 1);
    G(rational_casteljau)(n, 1, R, w, c, last, Rr, wr);
    G(rational_point)(n - last, 1, Rr, wr, t, &member);
    G(rational_point)(n, 1, R, w, c, &point);
    same(T, member, point);
}

#include "chapters/judge/claims_off.h"
