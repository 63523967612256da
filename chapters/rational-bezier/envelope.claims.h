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
#include "exact/record/resultant.h"
#include "exact/record/sign.h"

#include "chapters/judge/claims_on.h"
#include "chapters/rational-bezier/plane-polynomials.h"

/*
:::{statement} wang-ch3:3.3.4
:title: The family of curves of degree n-r
:zh: 曲线族的定义
:printed: \mathbf R^{[n-r]}(t,c)=\frac{\sum_{i=0}^{n-r}B_i^{n-r}(\frac{t-a}{b-a})\,\omega_{i+r}^r(c)\,\mathbf
  R_{i+r}^r(c)} {\sum_{i=0}^{n-r}B_i^{n-r}(\frac{t-a}{b-a})\,\omega_{i+r}^r(c)},\quad a\le t\le b,\ a\le c\le b
:definition: yes
:checked-by: member_is_a_polar_curve
:figure: envelope_families

The indices are in range: level $r$ has the indices $r,\dots,n$.
:::
*/

/* out = p(c^r, t^k, ...): the polar form of the points H with r arguments c, k arguments t and then x, y,
 * as many of these as places are left; r + k = n-2, n-1 or n. */
static void G(polar)(int n, int dim, const num H[], int r, num c, int k, num t, num x, num y, num out[])
{
    num u[MAX_DEGREE];
    for (int i = 0; i < n; i++)
        u[i] = i < r ? c : i < r + k ? t : i == r + k ? x : y;
    G(bezier_blossom)(n, dim, H, u, out);
}

/* A rational curve of the judge's numbers: n+1 points of dim coordinates, and weights. */
static void G(any_curve)(trial *T, int n, int dim, num R[], num w[])
{
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        for (int k = 0; k < dim; k++)
            R[i * dim + k] = unknown(T, k == 0 ? "x" : k == 1 ? "y" : "z", i);
    }
}

/*
:::{claim} member_is_a_polar_curve
:title: The member is the polar form with r arguments c and n-r arguments t
:zh: 族曲线即极形式 p(c^r, t^{n-r})
:given: weights $\omega_0,\dots,\omega_n$ and points $R_0,\dots,R_n$, any $t$ and $c$, every $r=0,\dots,n$
:then: $\sum B_i^{n-r}(t)\,\omega_{i+r}^r(c)\,(R_{i+r}^r(c),1)=p(c^r,t^{n-r})$
:method: The left side runs the recursion (3.3.2), (3.3.3), which divides by weights, and then sums; the right side
  evaluates the polar form of the homogeneous points.  A coordinate is any coordinate, so one suffices.
:degrees: 1..6 sampled 10
:control: one argument $c$ of the polar form replaced by $t$
:::
*/
CLAIM(member_is_a_polar_curve)
{
    int n = T->degree;
    num R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], H[2 * MAX_DEGREE + 2], c = parameter(T, "c"), t = parameter(T, "t");
    G(any_curve)(T, n, 1, R, w);
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
:::{statement} wang-ch3:thm-3.3.2-vertices
:title: What the points of an intermediate level mean
:zh: 离散中间层顶点的几何意义
:printed: the points of level $r$ of the recursion, with their weights, are the control polygon of a rational curve
  of degree $n-r$ that belongs to the parameter $c$
:holds-by: member_is_a_polar_curve
:needs: member_may_lose_a_point | the weights are positive; else a weight $\omega_i^r(c)$ may vanish and its point
  does not exist
:figure: triangle_point_at_infinity
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
:given: $n=2$, three weights $\omega$, the middle one negative, whose $\omega(t)$ has no real zero; $r=1$ and a parameter $c$
:then: $\omega_1^1(c)=0$, so that $R_1^1(c)$ is not defined although the curve is regular everywhere
:method: The zeros of $\omega(t)$ are counted, and the weights of level 1 are computed exactly; that they are not 0 is what is
  compared.
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
#endif

/*
## R touches every member

At $t=c$ the member and the curve have a common point, and their derivatives there are parallel: they differ by
the factor $(n-r)/n$.  So wherever the curve has a tangent at all, the member has the same one.

:::{statement} wang-ch3:thm-3.3.2-touch
:title: The curve and the member of parameter c touch at t = c
:zh: 曲线与族曲线在 t=c 处相切
:printed: for $n\ge2$ and $r=1,\dots,n-1$ the curve $\mathbf R(t)$ and the member $\mathbf R^{[n-r]}(t,c)$ are in
  contact at $t=c$, for every $c$ of $[a,b]$
:holds-by: member_touches_curve
:hypothesis: member_shrinks_at_a_cusp | $\mathbf R'(c)\ne0$; where it vanishes the member may be a single point
:needs: member_may_lose_a_point | the weights are positive
:figure: envelope_cusp

The two derivatives are parallel and, for $r\ge1$ and $R'(c)\ne0$, not equal.
:::

:::{claim} member_touches_curve
:title: At t = c the member has the point of the curve and (n-r)/n of its derivative
:zh: t=c 处族曲线与曲线同点，导矢之比为 (n-r)/n
:given: weights and points, $n\ge2$, any $c$, every $r=1,\dots,n-1$
:then: $R^{[n-r]}(c,c)=R(c)$ and $\partial_tR^{[n-r]}(t,c)=\frac{n-r}nR'(c)$ at $t=c$
:method: Both sides, with the recursion for the member, are one element of the field of rational functions of $c$, the
  weights and the points.  Where $R'(c)\ne0$ both curves have that direction as tangent.
:degrees: 2..6 sampled 10
:control: the factor $(n-r)/n$ left out
:::
*/
CLAIM(member_touches_curve)
{
    int n = T->degree;
    num R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], D[2], c = parameter(T, "c");
    G(any_curve)(T, n, 1, R, w);
    G(rational_derivatives)(n, 1, R, w, c, 1, D);
    for (int r = 1; r < n; r++) {
        num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], E[2];
        G(rational_casteljau)(n, 1, R, w, c, r, Rr, wr);
        G(rational_derivatives)(n - r, 1, Rr, wr, c, 1, E);
        about(T, "the common point");
        same(T, E[0], D[0]);
        about(T, "the derivatives at t = c");
        same(T, E[1], fault(T, mul(from_ratio(n - r, n), D[1]), D[1]));
    }
}

#if RATIONAL
/*
:::{claim} member_shrinks_at_a_cusp
:title: Where the derivative of the curve vanishes the line of the family may be a point
:zh: 尖点处的族直线退化为点
:kind: counterexample
:data: R = (1,-1) (-1/3,1) (-1/3,-1) (1,1); ω = 1 1 1 1; r = 2; c = 1/2
:instead: c = 3/4
:result: R'(c) = (0,0); the member's points = (0,0) (0,0)
:given: the points $R$ of the cubic $(\tau^2,\tau^3)$, $-1\le\tau\le1$, equal weights, the last level $r<n$, and the parameter
  $c$ of the cusp
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
:printed: the family is considered for $n\ge2$ and $r=1,2,\dots,n-1$
:holds-by: extreme_levels_are_curve_and_point

The range leaves out what is no family of curves: for $r=0$ every member is the curve itself, for $r=n$ a point of
it, and for $n=1$ nothing is left.
:::

:::{claim} extreme_levels_are_curve_and_point
:title: Level 0 gives the curve for every c, level n its point R(c)
:zh: 第 0 层即曲线，第 n 层即点 R(c)
:given: weights and points, any $t$ and $c$
:then: $R^{[n]}(t,c)=R(t)$ and $R^{[0]}(t,c)=R(c)$
:method: Recursion for the left sides, the formula of the curve for the right sides.
:degrees: 1..6 sampled 10
:control: level $n-1$ in the place of level $n$
:::
*/
CLAIM(extreme_levels_are_curve_and_point)
{
    int n = T->degree;
    num R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], member, point;
    num c = parameter(T, "c"), t = parameter(T, "t");
    G(any_curve)(T, n, 1, R, w);
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

/*
## Is R the envelope, or only part of it?

A point $X(t,c)$ of the member is a point of the envelope, in the sense of the differential geometry of plane
families, when the two derivatives $X_t$ and $X_c$ are parallel.  In homogeneous coordinates this says
$\det(P,P_t,P_c)=0$.  With $q(x,y)=p(c^{r-1},t^{n-r-1},x,y)$, what is left of the polar form, it factors for every $n$
and $r$:

$$\det(P,P_t,P_c)=r(n-r)\,(t-c)\;w_r(c,t),\qquad w_r(c,t)=\det\bigl(q(0,0),q(0,\delta),q(\delta,\delta)\bigr).$$

The factor $t-c$ is the curve itself.  The other factor, when it has zeros, gives further envelopes.

:::{statement} wang-ch3:thm-3.3.2
:title: The curve is the envelope of the family
:zh: 曲线是族的包络
:printed: \mathbf R(t)=\operatorname{env}\{\mathbf R^{[n-r]}(t,c)\mid a\le c\le b\},\quad r=1,\dots,n-1,\ n\ge2
:reading: member_touches_curve | "an envelope", a curve that in each of its points is touched by a member: true,
  wherever $\mathbf R'\ne0$
:reading: cubic_family_has_another_envelope | "the envelope", all points that satisfy the envelope condition, as the
  equality sign says: false, already for the cubic $(\tau,\tau^3)$
:reading: convex_quartic_has_another_envelope | the same with the restriction to curves without inflections: false from
  $n=4$ on
:corrected: the envelope is $\mathbf R$ together with the points of the pairs $(c,t)$ with $w_r(c,t)=0$; it is
  $\mathbf R$ alone when the control polygon is strictly convex, so always for $n=2$ and a true triangle; for $r=1$
  and for $r=n-1$ it is $\mathbf R$ alone when $\mathbf R'\times\mathbf R''\ne0$ on $[a,b]$
:corrected-by: envelope_condition_factors envelope_condition_of_points polar_derivatives
  convex_polygon_has_one_envelope inflections_give_the_other_envelopes triangle_has_one_envelope
:figure: envelope_extra

When all points lie on a line the condition holds everywhere and the envelope loses its meaning
(`flat_polygon_has_no_envelope`).  The further envelopes are curves of their own: for $r=1$ a segment of the tangent at
a $\tau$ where $R'\times R''=0$ and $R'\ne0$, run through by $p(c,\tau^{n-1})$; for $r=n-1$ the member that is this tangent.  Such a
$\tau$ is mostly an inflection; but a curve may be flat there and not change its side (`flat_point_has_another_envelope`).
:::

:::{claim} envelope_condition_of_points
:title: The points satisfy the envelope condition when three homogeneous vectors are dependent
:zh: 包络条件的齐次形式
:given: a plane family $X=(P_1,P_2)/P_3$ and the values $P$, $P_t$, $P_c$ of its homogeneous vector and of the two
  derivatives
:then: $\det(X_t,X_c)=\det(P,P_t,P_c)/P_3^3$
:method: The quotient rule gives $X_t$ and $X_c$; nine variables stand for the three vectors.
:control: the power $P_3^2$
:::
*/
CLAIM(envelope_condition_of_points)
{
    num P[3], Pt[3], Pc[3], Xt[2], Xc[2];
    for (int k = 0; k < 3; k++) {
        P[k] = positive(T, "P", k);
        Pt[k] = unknown(T, "Pt", k);
        Pc[k] = unknown(T, "Pc", k);
    }
    num square = mul(P[2], P[2]);
    for (int k = 0; k < 2; k++) {
        Xt[k] = div(sub(mul(Pt[k], P[2]), mul(P[k], Pt[2])), square);
        Xc[k] = div(sub(mul(Pc[k], P[2]), mul(P[k], Pc[2])), square);
    }
    same(T, G(cross2)(Xt, Xc), div(G(det3)(P, Pt, Pc), fault(T, mul(square, P[2]), square)));
}

/*
:::{claim} polar_derivatives
:title: The derivatives of the member by t and by c are polar forms with the direction δ
:zh: 族曲线对 t, c 的偏导
:given: points $H_0,\dots,H_n$ (any homogeneous coordinate), $n\ge2$, every $r=1,\dots,n-1$
:then: for $P=p(c^r,t^{n-r})$: $P_t=(n-r)\,p(c^r,t^{n-r-1},\delta)$ and $P_c=r\,p(c^{r-1},t^{n-r},\delta)$
:method: In the field the left sides are formal derivatives; in the other numbers they are the derivatives of the
  Bézier curves that $P$ is in $t$ and in $c$.  For every $n$ it is the product rule for a form that is symmetric and
  of degree one in each argument.
:degrees: 2..6 sampled 12
:control: the factor $r$ in the place of $n-r$
:::
*/
CLAIM(polar_derivatives)
{
    int n = T->degree;
    num H[MAX_DEGREE + 1], c = parameter(T, "c"), t = parameter(T, "t"), zero = from_int(0), one = from_int(1);
    for (int i = 0; i <= n; i++)
        H[i] = unknown(T, "H", i);
    for (int r = 1; r < n; r++) {
        int m = n - r;
        num in_t[MAX_DEGREE + 1], in_c[MAX_DEGREE + 1], u[MAX_DEGREE], D[2], E[2], up, down;
        for (int i = 0; i <= m; i++) { /* the Bézier points of P as a curve in t, and then in c */
            for (int k = 0; k < n; k++)
                u[k] = k < r ? c : k < r + i ? one : zero;
            G(bezier_blossom)(n, 1, H, u, &in_t[i]);
        }
        for (int i = 0; i <= r; i++) {
            for (int k = 0; k < n; k++)
                u[k] = k < m ? t : k < m + i ? one : zero;
            G(bezier_blossom)(n, 1, H, u, &in_c[i]);
        }
        G(bezier_derivatives)(m, 1, in_t, t, 1, D);
        G(bezier_derivatives)(r, 1, in_c, c, 1, E);
#if FIELD
        D[1] = derivative_f(D[0], t);
        E[1] = derivative_f(E[0], c);
#endif
        about(T, "the derivative by t");
        G(polar)(n, 1, H, r, c, m - 1, t, one, one, &up);
        G(polar)(n, 1, H, r, c, m - 1, t, zero, zero, &down);
        same(T, D[1], mul(from_int(fault(T, m, r)), sub(up, down)));
        about(T, "the derivative by c");
        G(polar)(n, 1, H, r - 1, c, m, t, one, one, &up);
        G(polar)(n, 1, H, r - 1, c, m, t, zero, zero, &down);
        same(T, E[1], mul(from_int(r), sub(up, down)));
    }
}

/*
:::{claim} envelope_condition_factors
:title: The envelope condition is r(n-r)(t-c) times a second factor
:zh: 包络条件的因式分解
:given: the three vectors $q(0,0)$, $q(0,\delta)$, $q(\delta,\delta)$ of a form $q(x,y)$ that is symmetric and of
  degree one in each argument, so $q(x,y)=q(0,0)+(x+y)q(0,\delta)+xy\,q(\delta,\delta)$; any $n$, $r$, $c$, $t$
:then: $\det(q(c,t),(n-r)q(c,\delta),r\,q(t,\delta))=r(n-r)(t-c)\det(q(0,0),q(0,\delta),q(\delta,\delta))$
:method: An identity between polynomials in 13 variables, $n$ and $r$ among them.  With the derivatives of the member
  in the place of the three columns it is the factorization of the envelope condition.
:degrees: all
:control: $t+c$ in the place of $t-c$
:::
*/
CLAIM(envelope_condition_factors)
{
    num q[3][3], column[3][3], n = parameter(T, "n"), r = parameter(T, "r"), c = parameter(T, "c"),
                               t = parameter(T, "t");
    num m = sub(n, r);
    for (int k = 0; k < 3; k++) {
        q[0][k] = unknown(T, "a", k);
        q[1][k] = unknown(T, "b", k);
        q[2][k] = unknown(T, "d", k);
        column[0][k] = add(q[0][k], add(mul(add(c, t), q[1][k]), mul(mul(c, t), q[2][k])));
        column[1][k] = mul(m, add(q[1][k], mul(c, q[2][k])));
        column[2][k] = mul(r, add(q[1][k], mul(t, q[2][k])));
    }
    num factor = mul(mul(r, m), fault(T, sub(t, c), add(t, c)));
    same(T, G(det3)(column[0], column[1], column[2]), mul(factor, G(det3)(q[0], q[1], q[2])));
}

#if RATIONAL
/* The point D[0..1] of the member c of level r, its derivatives by t, D[2..3], and by c, D[4..5]; weights 1. */
static void G(member_derivatives)(int n, const num R[], int r, num c, num t, num D[])
{
    num w[MAX_DEGREE + 1], Rr[2 * MAX_DEGREE + 2], wr[MAX_DEGREE + 1], in_c[2 * MAX_DEGREE + 2], u[MAX_DEGREE], E[4];
    for (int i = 0; i <= n; i++)
        w[i] = from_int(1);
    G(rational_casteljau)(n, 2, R, w, c, r, Rr, wr);
    G(rational_derivatives)(n - r, 2, Rr, wr, t, 1, D);
    for (int i = 0; i <= r; i++) {
        for (int k = 0; k < n; k++)
            u[k] = k < n - r ? t : from_int(k < n - r + i);
        G(bezier_blossom)(n, 2, R, u, in_c + 2 * i);
    }
    G(bezier_derivatives)(r, 2, in_c, c, 1, E);
    D[4] = E[2];
    D[5] = E[3];
}

/* For the data r, c and t of the claim: compares with 0 the polynomial F of the curve (R, 1) at the point of the member c at
 * t, if that point satisfies the envelope condition. */
static void G(envelope_point_on_curve)(trial *T, int n, const num R[])
{
    num w[MAX_DEGREE + 1], D[6];
    int r = given_whole(T, "r");
    num c = given(T, "c"), t = given(T, "t");
    for (int i = 0; i <= n; i++)
        w[i] = from_int(1);
    G(member_derivatives)(n, R, r, c, t, D);
    num F = G(implicit_value)(n, R, w, D[0], D[1]);
    found_points(T, "point of the member", 1, 2, D);
    found_points(T, "X_t, X_c", 2, 2, D + 2);
    found(T, "F at the point", F);
    if (!is_zero_q(G(cross2)(D + 2, D + 4)))
        return;
    about(T, "F at the point, which is 0 on the curve");
    vanishes(T, F);
}

/*
Two families show the other factor at work.

:::{claim} cubic_family_has_another_envelope
:title: The family of the cubic (τ, τ³) has the axis y = 0 as a second envelope
:zh: 三次曲线 (τ,τ³) 的族以 y=0 为另一包络
:kind: counterexample
:data: R = (-1,-1) (-1/3,1) (1/3,-1) (1,1); r = 1; c = 3/4; t = 1/2
:instead: t = 3/4
:result: point of the member = (1/6,0); X_t, X_c = (4/3,0) (2/3,0); F at the point = -64/27
:given: the points $R$ of $(\tau,\tau^3)$, $-1\le\tau\le1$, with equal weights; the member $c$ of level $r$, and its point at
  the parameter $t$ of the inflection, both counted in $[0,1]$
:then: there the envelope condition $\det(X_t,X_c)=0$ is satisfied at a point that is not on the curve
:method: $X_t$ comes from the member's control points, $X_c$ from the Bézier curve that the point is in $c$.  The
  condition is checked first; compared is the value at the point of the polynomial $F$ of (3.4.1), which vanishes on the
  curve.
:control: the same member at $t=c$
:::
*/
CLAIM(cubic_family_has_another_envelope)
{
    num R[8];
    given_points(T, "R", 4, 2, R);
    G(envelope_point_on_curve)(T, 3, R);
}

/* The sign of R' x R'' on [0,1] for the polynomial curve R of degree n. */
static enum cagd_sign_pattern G(turning)(int n, const num R[])
{
    num x[MAX_DEGREE + 1], y[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++) {
        x[i] = R[2 * i];
        y[i] = R[2 * i + 1];
    }
    poly x1 = poly_derivative(poly_from_bernstein(n, x)), y1 = poly_derivative(poly_from_bernstein(n, y));
    poly turn = poly_sub(poly_mul(x1, poly_derivative(y1)), poly_mul(y1, poly_derivative(x1)));
    return sign_on(turn, from_int(0), from_int(1), CLOSED);
}

/*
:::{claim} convex_quartic_has_another_envelope
:title: A convex curve without inflections whose family has a parabola as a second envelope
:zh: 无拐点的凸四次曲线，其族另有抛物线为包络
:kind: counterexample
:data: R = (-1,5/2) (-1/2,-1) (0,1/2) (1/2,-1) (1,5/2); r = 2; c = 3/4; t = 1/4
:instead: t = 3/4
:result: point of the member = (0,-1/16); X_t, X_c = (1,0) (1,0); F at the point = 4096
:given: the points $R$ of a quartic, equal weights; the member $c$ of level $r$, and its point at $t=1-c$, both counted in
  $[0,1]$; the equation of the quartic is given in `second_envelopes_by_elimination`
:then: there the envelope condition is satisfied at a point that is not on the curve; the curve's curvature is positive
  throughout
:method: As for the cubic; that $R'\times R''$ is positive on the closed interval is decided first, by its sign as a
  polynomial.
:control: the same member at $t=c$
:::
*/
CLAIM(convex_quartic_has_another_envelope)
{
    num R[10];
    given_points(T, "R", 5, 2, R);
    if (G(turning)(4, R) == SIGN_POSITIVE)
        G(envelope_point_on_curve)(T, 4, R);
}

/*
:::{claim} flat_point_has_another_envelope
:title: The family of (τ, τ⁴), which is flat at 0 and bends to one side, has the axis y = 0 as a second envelope
:zh: 曲线 (τ,τ⁴) 无拐点而在 0 处平坦，其族以 y=0 为另一包络
:kind: counterexample
:data: R = (-1,1) (-1/2,-1) (0,1) (1/2,-1) (1,1); r = 1; c = 3/4; t = 1/2
:instead: t = 3/4
:result: point of the member = (1/8,0); X_t, X_c = (3/2,0) (1/2,0); F at the point = 16
:given: the points $R$ of $(\tau,\tau^4)$, $-1\le\tau\le1$, with equal weights; the member $c$ of level $r$, and its point at the
  parameter $t$ of the flat point, both counted in $[0,1]$
:then: there the envelope condition is satisfied at a point that is not on the curve; $R'\times R''\ge0$ throughout
:method: As for the cubic; that $R'\times R''$ is nowhere negative is decided first, by its sign as a polynomial.
:control: the same member at $t=c$
:::
*/
CLAIM(flat_point_has_another_envelope)
{
    num R[10];
    given_points(T, "R", 5, 2, R);
    if (G(turning)(4, R) == SIGN_NONNEGATIVE)
        G(envelope_point_on_curve)(T, 4, R);
}
#endif

#if FIELD
/*
These are not stray points: the whole second envelopes are found by eliminating $c$.

:::{claim} second_envelopes_by_elimination
:title: Eliminating c gives the curve and the second envelope
:zh: 消去 c 得到曲线与另一包络
:types: field
:data: R of the cubic = (-1,-1) (-1/3,1) (1/3,-1) (1,1); the cubic's level = 1; the cubic's curve = (1,3,0) (-1,0,1); the cubic's envelope = (1,0,1);
  R of the quartic = (-1,5/2) (-1/2,-1) (0,1/2) (1/2,-1) (1,5/2); the quartic's level = 2;
  the quartic's curve = (2,4,0) (3,2,0) (-2,0,1); the quartic's envelope = (16,2,0) (-16,0,1) (-1,0,0)
:instead: the cubic's curve = (1,3,0) (1,0,1); the quartic's envelope = (16,2,0) (-16,0,1) (1,0,0)
:given: the families of the cubic and of the quartic above, by points and level; for each two polynomials in $x$ and $y$ by their terms $(\alpha,i,j)$, $\alpha x^iy^j$: that of the curve, and that of the
  envelope, $y$ for the cubic, a parabola for the quartic; the member $c$ written as $f(x,y,c)=0$
:then: $\operatorname{Res}_c(f,f_c)$ is, up to a constant factor, the product of the two polynomials for the cubic, and for the
  quartic the product of the curve's and the square of the envelope's
:method: The member's equation is the determinant (3.4.1) of its control polygon, as a polynomial in $x$, $y$, $c$;
  the resultant by $c$ is a polynomial in $x$ and $y$, divided by the one stated.  The quotient is a constant.  The
  determinant has a factor in $c$ alone, the leading coefficient of $y$ in $t$, because $x$ is of lower degree in $t$; it is
  divided out first.
:control: another sign in each of the two products
:::
*/
/* Does Res_c(f, f_c) equal a constant times `product`?  f is the member (3.4.1) of level n-2 of the curve (R, 1), of degree
 * 2, divided by the leading coefficient of y in t, which the determinant has as a factor. */
static int eliminates_to(int n, const num_f R[], int r, num_f product)
{
    num_f w[MAX_DEGREE + 1], Rr[2 * MAX_DEGREE + 2], wr[MAX_DEGREE + 1], c = variable_f("c");
    for (int i = 0; i <= n; i++)
        w[i] = from_int(1);
    rational_casteljau_f(n, 2, R, w, c, r, Rr, wr);
    num_f leading = add(sub(Rr[1], add(Rr[3], Rr[3])), Rr[5]); /* y_0 - 2 y_1 + y_2 */
    num_f f = div(implicit_value_f(n - r, Rr, wr, variable_f("x"), variable_f("y")), leading);
    num_f quotient = div(resultant_by_f(f, derivative_f(f, c), c), product);
    return is_constant_f(quotient, NULL) && !is_zero_f(quotient);
}

CLAIM(second_envelopes_by_elimination)
{
    num R[8], S[10];
    given_points(T, "R of the cubic", 4, 2, R);
    int level = given_whole(T, "the cubic's level");
    num curve = given_polynomial(T, "the cubic's curve", 2), envelope = given_polynomial(T, "the cubic's envelope", 1);
    about(T, "the envelopes of the cubic's family");
    agree(T, eliminates_to(3, R, level, mul(envelope, curve)));
    given_points(T, "R of the quartic", 5, 2, S);
    level = given_whole(T, "the quartic's level");
    curve = given_polynomial(T, "the quartic's curve", 3);
    envelope = given_polynomial(T, "the quartic's envelope", 3);
    about(T, "the envelopes of the quartic's family");
    agree(T, eliminates_to(4, S, level, mul(mul(envelope, envelope), curve)));
}
#endif

#if RATIONAL
/*
:::{claim} flat_polygon_has_no_envelope
:title: With all points on a line every point of every member satisfies the envelope condition
:zh: 顶点共线时包络条件恒成立
:kind: counterexample
:data: R = (0,0) (1,1) (4,4); ω = 1 2 1
:instead: R = (0,0) (1,2) (4,4)
:result: w_1 = 0
:given: $n=2$, three points $R$ on a line with positive weights, $r=1$, any $c\ne t$
:then: the determinant $w_1$ of $q(0,0)$, $q(0,\delta)$, $q(\delta,\delta)$ is 0 although $t\ne c$
:method: For $n=2$ the determinant is that of the three homogeneous points and does not depend on $c$ and $t$.  For collinear
  points they lie in the plane of $R^3$ over that line, so that it vanishes for all $c$ and $t$ and singles out nothing.
:control: the middle point moved off the line
:::
*/
CLAIM(flat_polygon_has_no_envelope)
{
    num R[6], w[3], H[9];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    G(rational_homogenize)(2, 2, R, w, H);
    num determinant = G(det3)(H, H + 3, H + 6);
    found(T, "w_1", determinant);
    about(T, "the determinant w_1 differs from 0");
    refute(T, is_zero_q(determinant));
}
#endif

/*
When does $w_r$ have no zero?  For $n=2$ it is a constant.  For $r=1$ it depends on $t$ alone, for $r=n-1$ on $c$ alone,
and its zeros are those of $R'\times R''$, such as inflections and cusps.  In between inflections do not decide, but the control polygon does: write
$\beta_i$ for the coefficients of $(1-c+cz)^{r-1}(1-t+tz)^{n-r-1}$; then

$$w_r(c,t)=\sum_{i<j<k}\begin{vmatrix}\beta_i&\beta_j&\beta_k\\\beta_{i-1}&\beta_{j-1}&\beta_{k-1}\\
\beta_{i-2}&\beta_{j-2}&\beta_{k-2}\end{vmatrix}\det(P_i,P_j,P_k),$$

and all the minors are nonnegative: the $\beta_i$ come from a polynomial with negative roots only.

:::{claim} triangle_has_one_envelope
:title: For n = 2 the second factor is a constant, 0 only for points on a line
:zh: n=2 时另一因子为常数
:given: weights $\omega_0,\omega_1,\omega_2$, points of the plane, $n=2$, $r=1$
:then: $w_1(c,t)=\omega_0\omega_1\omega_2\,(R_1-R_0)\times(R_2-R_0)$
:method: Both sides in the field, with all weights and coordinates variables.  With weights that are not 0 the right
  side vanishes only for three points on a line.
:control: the weight $\omega_1$ left out
:::
*/
CLAIM(triangle_has_one_envelope)
{
    num R[6], w[3], H[9], q[9], a[2], b[2], zero = from_int(0), one = from_int(1);
    G(any_curve)(T, 2, 2, R, w);
    G(rational_homogenize)(2, 2, R, w, H);
    G(polar)(2, 3, H, 0, zero, 0, zero, zero, zero, q);
    G(polar)(2, 3, H, 0, zero, 0, zero, zero, one, q + 3);
    G(polar)(2, 3, H, 0, zero, 0, zero, one, one, q + 6);
    for (int k = 0; k < 2; k++) {
        a[k] = sub(R[2 + k], R[k]);
        b[k] = sub(R[4 + k], R[k]);
    }
    num weights = mul(w[0], fault(T, mul(w[1], w[2]), w[2]));
    same(T, G(det3)(q, q + 3, q + 6), mul(weights, G(cross2)(a, b)));
}

/*
:::{claim} inflections_give_the_other_envelopes
:title: For r = 1 and r = n-1 the second factor is the Wronskian of the curve
:zh: r=1 与 r=n-1 时另一因子即曲线的 Wronski 行列式
:given: the homogeneous points of a plane curve, $n\ge2$, any $t$; $r=1$, so $q(x,y)=p(t^{n-2},x,y)$
:then: $P=q(t,t)$, $P'=n\,q(t,\delta)$, $P''=n(n-1)\,q(\delta,\delta)$,
  $\det(q(t,t),q(t,\delta),q(\delta,\delta))=w_1$ and $\det(P,P',P'')=\omega^3\,R'\times R''$, so that
  $n^2(n-1)\,w_1(t)=\omega(t)^3\,(R'\times R'')(t)$
:method: Four identities in the field; the first needs one coordinate.  So for $\omega>0$ the zeros of $w_1$ are the
  points where $R'\times R''$ is 0.  For $r=n-1$ the arguments $c$ and $t$ change their places.
:degrees: 2..6 sampled 12
:control: the factor $n^2$ in the place of $n(n-1)$
:::
*/
CLAIM(inflections_give_the_other_envelopes)
{
    int n = T->degree;
    num H[MAX_DEGREE + 1], D[3], q[3], t = parameter(T, "t"), zero = from_int(0), one = from_int(1);
    for (int i = 0; i <= n; i++)
        H[i] = unknown(T, "H", i);
    G(polar)(n, 1, H, 0, t, n - 2, t, zero, zero, &q[0]);
    G(polar)(n, 1, H, 0, t, n - 2, t, zero, one, &q[1]);
    G(polar)(n, 1, H, 0, t, n - 2, t, one, one, &q[2]);
    num q1 = sub(q[1], q[0]), q2 = add(sub(q[2], add(q[1], q[1])), q[0]); /* q(0,δ), q(δ,δ) */
    num slope = add(q1, mul(t, q2));                                      /* q(t,δ)          */
    G(bezier_derivatives)(n, 1, H, t, 2, D);
    about(T, "P, P', P'' by the polar form");
    same(T, D[0], add(add(q[0], mul(mul(from_int(2), t), q1)), mul(mul(t, t), q2)));
    same(T, D[1], mul(from_int(n), slope));
    same(T, D[2], mul(from_int(n * fault(T, n - 1, n)), q2));

    num a[3], b[3], d[3], P[3], P1[3];
    for (int k = 0; k < 3; k++) {
        a[k] = unknown(T, "a", k);
        b[k] = unknown(T, "b", k);
        d[k] = unknown(T, "d", k);
        P1[k] = add(b[k], mul(t, d[k]));
        P[k] = add(add(a[k], mul(mul(from_int(2), t), b[k])), mul(mul(t, t), d[k]));
    }
    about(T, "the determinant of q(t,t), q(t,δ), q(δ,δ)");
    same(T, G(det3)(P, P1, d), G(det3)(a, b, d));

    num w = positive(T, "w", 0), R1[2], R2[2], V[3], V1[3], V2[3];
    for (int k = 0; k < 2; k++) { /* V = (wR, w): R' = (V' - w'R)/w, R'' = (V'' - w''R - 2w'R')/w */
        num R = div(a[k], w);
        R1[k] = div(sub(b[k], mul(b[2], R)), w);
        R2[k] = div(sub(sub(d[k], mul(d[2], R)), mul(mul(from_int(2), b[2]), R1[k])), w);
    }
    for (int k = 0; k < 3; k++) {
        V[k] = k < 2 ? a[k] : w;
        V1[k] = b[k];
        V2[k] = d[k];
    }
    about(T, "the determinant of P, P', P''");
    same(T, G(det3)(V, V1, V2), mul(mul(w, mul(w, w)), G(cross2)(R1, R2)));
}

/*
:::{claim} convex_polygon_has_one_envelope
:title: A convex polygon with positive weights has the curve as its only envelope, for every r
:zh: 凸控制多边形且权为正时包络只有曲线本身
:given: homogeneous points $P_i$, $n\ge2$, every $r=1,\dots,n-1$; $c,t$ of $(0,1)$ for the signs
:let: $\beta$ as above
:then: the displayed sum for $w_r$, and every $3\times3$ minor in it is nonnegative
:method: The sum is Cauchy-Binet; it is computed in the field.  With $c=s/(1+s)$, $t=v/(1+v)$ the minors have no
  negative coefficient in $s$ and $v$, so they are nonnegative for $c,t\in[0,1]$.  There $\beta\ne0$, its three
  shifted rows are independent, and one minor is positive.  If $R_0,\dots,R_n$ are the corners of a convex polygon
  in this order and the weights are positive, all
  $\det(P_i,P_j,P_k)=\omega_i\omega_j\omega_k(R_j-R_i)\times(R_k-R_i)$, $i<j<k$, have one strict sign, hence
  $w_r\ne0$.  For every $n$ the minors are Schur polynomials by Jacobi and Trudi, which have no negative
  coefficient.
:degrees: 2..6 sampled 9
:control: $\beta$ from $(1-c-cz)^{r-1}(1-t-tz)^{n-r-1}$
:::
*/
/* b[0..n]: the coefficients of the powers of z in (1-c+cz)^(r-1) (1-t+tz)^(m-1), 0 beyond; with minus the signs
 * of the z are changed. */
static void G(coefficients_of_the_rest)(int n, int r, num c, num t, int minus, num b[])
{
    for (int i = 0; i <= n; i++)
        b[i] = from_int(i == 0);
    for (int k = 0; k < n - 2; k++) {
        num x = k < r - 1 ? c : t, low = sub(from_int(1), x), high = minus ? neg(x) : x;
        for (int i = n; i >= 0; i--)
            b[i] = i > 0 ? add(mul(low, b[i]), mul(high, b[i - 1])) : mul(low, b[i]);
    }
}

CLAIM(convex_polygon_has_one_envelope)
{
    int n = T->degree;
    num H[3 * MAX_DEGREE + 3], c = inside(T, "s"), t = inside(T, "v"), zero = from_int(0), one = from_int(1);
    for (int i = 0; i <= n; i++)
        for (int k = 0; k < 3; k++)
            H[3 * i + k] = unknown(T, k == 0 ? "x" : k == 1 ? "y" : "w", i);
    for (int r = 1; r < n; r++) {
        num b[MAX_DEGREE + 1], q[9], sum = zero;
        G(coefficients_of_the_rest)(n, r, c, t, fault(T, 0, 1), b);
        G(polar)(n, 3, H, r - 1, c, n - r - 1, t, zero, zero, q);
        G(polar)(n, 3, H, r - 1, c, n - r - 1, t, zero, one, q + 3);
        G(polar)(n, 3, H, r - 1, c, n - r - 1, t, one, one, q + 6);
        for (int i = 0; i <= n; i++)
            for (int j = i + 1; j <= n; j++)
                for (int k = j + 1; k <= n; k++) {
                    num M[9];
                    for (int row = 0; row < 3; row++) {
                        M[3 * row] = i >= row ? b[i - row] : zero;
                        M[3 * row + 1] = j >= row ? b[j - row] : zero;
                        M[3 * row + 2] = k >= row ? b[k - row] : zero;
                    }
                    num minor = G(det3)(M, M + 3, M + 6);
                    about(T, "a minor of the matrix of the β");
                    nonnegative(T, minor);
                    sum = add(sum, mul(minor, G(det3)(H + 3 * i, H + 3 * j, H + 3 * k)));
                }
        about(T, "the factor w_r as a sum over the triangles of control points");
        same(T, G(det3)(q, q + 3, q + 6), sum);
    }
}

/*
## The order of contact

Two plane curves with a common point have contact of order $k$ there when, after a change of the parameter of one,
their derivatives up to order $k$ agree; as graphs $y(x)$ over the common tangent, when their Taylor coefficients
agree up to order $k$.  The printed claim is order $n-r$.  In truth the order does not depend on $r$: it is that of
the curve and its own tangent line, so 1 wherever the curvature is not 0.

Let $p_k=p(c^{n-k},\delta^k)$.  Then $P(c+h)=\sum_k\binom nkh^kp_k$ and the member of level $r$ is, with the same
vectors, $P^{[n-r]}(c+h,c)=\sum_k\binom{n-r}kh^kp_k$.  So everything about the contact follows from the two rows of
binomial coefficients.

:::{statement} wang-ch3:thm-3.3.2-contact
:title: The curve and the member have contact of order n-r
:zh: 曲线与族曲线在接触点 n-r 阶切触
:printed: $\mathbf R(t)$ and $\mathbf R^{[n-r]}(t,c)$ have contact of order $n-r$ at the point of contact $c=t$
:class: false
:refuted-by: cubic_member_has_other_curvature
:reading: member_runs_slower_than_the_curve | equal derivatives in $t$: fails from the first on, the ratio is $(n-r)/n$
:reading: cubic_member_has_other_curvature | equal derivatives after a change of parameter, the usual meaning: fails
  whenever $n-r\ge2$ and $\kappa\ne0$
:reading: cubic_member_meets_the_curve_twice | $n-r+1$ coincident intersections: fails, there are two
:reading: quartic_member_meets_the_curve_twice | $n-r$ coincident intersections, as some count: fails, there are two for $n-r=3$
  and for $n-r=1$ as well
:reading: weighted_member_has_other_directions | parallel derivatives up to order $n-r$: true for equal weights
  (`unweighted_derivatives_are_parallel`), false for others
:reading: osculating_flats_agree | the same osculating line, plane, ... up to dimension $n-r$: true for all weights,
  and in the plane empty from dimension 2 on
:corrected: at $t=c$ with $\mathbf R'(c)\ne0$ the contact has for every $r\ge1$ the order of contact of $\mathbf R$
  with its tangent: it is 1 where $\kappa\ne0$, and there
  $\frac{\kappa^{[n-r]}}{\kappa}=\frac{n(n-r-1)}{(n-r)(n-1)}<1$
:corrected-by: member_is_flatter_by_a_fixed_ratio member_is_flatter_in_every_order expansion_about_the_contact
:figure: envelope_contact
:striking: 1

For $r=n-1$ the member is the tangent line and the printed order 1 is right where $\kappa\ne0$.  The ratio holds in
space as well as in the plane; `curvature_of_the_member` computes both curvatures, as the second way.
:::

:::{claim} expansion_about_the_contact
:title: Curve and member have one Taylor expansion up to the binomial coefficients
:zh: 曲线与族曲线的展开只差二项式系数
:given: any homogeneous coordinate of the points $H_0,\dots,H_n$, any $c$ and $h$, every $r=0,\dots,n$
:let: $p_k=p(c^{n-k},\delta^k)$
:then: $p(c^r,(c+h)^{n-r})=\sum_{k=0}^{n-r}\binom{n-r}kh^kp_k$
:method: The left side by the polar form, $p_k$ as the derivative of order $k$ of the curve at $c$ divided by
  $n!/(n-k)!$.  For every $n$: expand $(c+h)^{n-r}$ in the symmetric form.
:degrees: 1..6 sampled 12
:control: $\binom nk$ in the place of $\binom{n-r}k$
:::
*/
CLAIM(expansion_about_the_contact)
{
    int n = T->degree;
    num H[MAX_DEGREE + 1], D[MAX_DEGREE + 1], c = parameter(T, "c"), h = unknown(T, "h", 0);
    for (int i = 0; i <= n; i++)
        H[i] = unknown(T, "H", i);
    G(bezier_derivatives)(n, 1, H, c, n, D);
    for (int r = 0; r <= n; r++) {
        num left, right = from_int(0), power = from_int(1), falling = from_int(1);
        G(polar)(n, 1, H, r, c, n - r, add(c, h), c, c, &left);
        for (int k = 0; k <= n - r; k++) {
            long choose = binomial(fault(T, n - r, n), k);
            right = add(right, mul(mul(from_int(choose), power), div(D[k], falling)));
            power = mul(power, h);
            falling = mul(falling, from_int(n - k));
        }
        same(T, left, right);
    }
}

/*
:::{claim} member_is_flatter_by_a_fixed_ratio
:title: The curvatures of member and curve have the ratio n(n-r-1)/((n-r)(n-1)), in any dimension
:zh: 曲率比为 n(n-r-1)/((n-r)(n-1))
:given: the expansion above to second order with weights $w_0\ne0$, $w_1$, $w_2$ and one coordinate of
  $p_0,p_1,p_2$; any $n$ and $m=n-r$; two vectors $X,Y$ of space
:then: $R_m'=\frac mnR'$ and $R_m''=\frac{m(m-1)}{n(n-1)}R''+\mu R'$ with one $\mu$ for all coordinates; and
  $\kappa^2$ of $(aX,bY+\mu X)$ is $(b/a^2)^2$ times that of $(X,Y)$, which for these $a,b$ gives the ratio
:method: All in the field with $n$ and $m$ variables; the derivatives by Leibniz' rule, $\kappa^2$ by the kernel in the
  plane and in space.  The ratio is less than 1 because $(n-r)(n-1)-n(n-r-1)=r$.
:degrees: all
:control: the ratio $\frac{n-r-1}{n-1}$
:::
*/
CLAIM(member_is_flatter_by_a_fixed_ratio)
{
    num n = parameter(T, "n"), m = parameter(T, "m"), one = from_int(1), two = from_int(2);
    num w[3], p[3], degree[2] = {n, m}, R1[2], R2[2];
    for (int k = 0; k < 3; k++) {
        w[k] = positive(T, "w", k);
        p[k] = unknown(T, "p", k);
    }
    for (int j = 0; j < 2; j++) { /* derivatives of the quotient of P = p_0 + d h p_1 + d(d-1)/2 h^2 p_2 + ... */
        num d = degree[j], second = mul(d, sub(d, one)), R = div(p[0], w[0]);
        R1[j] = div(sub(mul(d, p[1]), mul(mul(d, w[1]), R)), w[0]);
        num rest = sub(mul(second, p[2]), mul(mul(second, w[2]), R));
        R2[j] = div(sub(rest, mul(mul(two, mul(d, w[1])), R1[j])), w[0]);
    }
    num a = div(m, n), b = div(mul(m, sub(m, one)), mul(n, sub(n, one)));
    num mu = mul(div(mul(two, w[1]), w[0]), sub(div(mul(m, sub(m, one)), sub(n, one)), div(mul(m, m), n)));
    about(T, "the first derivatives");
    same(T, R1[1], mul(a, R1[0]));
    about(T, "the second derivatives");
    same(T, R2[1], add(mul(b, R2[0]), mul(mu, R1[0])));

    num ratio = fault(T, mul(div(n, m), div(sub(m, one), sub(n, one))), div(sub(m, one), sub(n, one)));
    for (int dim = 2; dim <= 3; dim++) {
        num X[3], Y[3], aX[3], bY[3], nu = unknown(T, "mu", 0);
        for (int k = 0; k < dim; k++) {
            X[k] = positive(T, "X", k);
            Y[k] = unknown(T, "Y", k);
            aX[k] = mul(a, X[k]);
            bY[k] = add(mul(b, Y[k]), mul(nu, X[k]));
        }
        about(T, "the squares of the curvatures");
        same(T, G(curvature_squared)(dim, aX, bY), mul(mul(ratio, ratio), G(curvature_squared)(dim, X, Y)));
    }
}

/*
:::{claim} member_is_flatter_in_every_order
:title: The first coefficient off the tangent is smaller for the member than for the curve
:zh: 离开切线的首项系数，族曲线严格较小
:given: $P=\sum\binom nkh^kp_k$ and the member $\sum\binom mkh^kp_k$, $m=n-r$, in the basis $p_0,p_1,e$ where $p_k$
  is the first vector outside the span of $p_0,p_1$: as graphs $y=\frac{\binom nk}{n^k}x^k+\dots$ and
  $y=\frac{\binom mk}{m^k}x^k+\dots$
:then: $\binom nk/n^k=\frac1{k!}\prod_{j<k}(1-\frac jn)$, $k=2,\dots,6$, and
  $(1-\frac jn)-(1-\frac jm)=\frac{jr}{mn}\ge0$
:method: Identities with $n$, $m$ and $j$ variables; $n=m+r$ with $m,r,j>0$ for the sign, strict for $r>0$.  The
  first factor with $j=1$ is strictly smaller for $m$; the others, for $m\ge k$, are positive and not larger, and
  for $m<k$ the member's coefficient is 0.  So the coefficients of $x^k$ differ and those before agree: order
  exactly $k-1$.
:degrees: all
:scope: orders k = 2 to 6
:control: $n-1$ in the place of $n$ in the products
:::
*/
CLAIM(member_is_flatter_in_every_order)
{
    num m = positive(T, "m", 0), r = positive(T, "r", 0), n = add(m, r), one = from_int(1);
    for (int k = 2; k <= 6; k++) {
        num choose = one, product = one, power = one;
        for (int j = 0; j < k; j++) {
            choose = mul(choose, div(sub(n, from_int(j)), from_int(j + 1)));
            product = mul(product, div(sub(one, div(from_int(j), fault(T, n, sub(n, one)))), from_int(j + 1)));
            power = mul(power, n);
        }
        about(T, "C(n,k)/n^k as a product");
        same(T, div(choose, power), product);
    }
    num j = positive(T, "j", 0), gap = div(mul(j, r), mul(m, n));
    about(T, "one factor of the products");
    same(T, sub(sub(one, div(j, n)), sub(one, div(j, m))), gap);
    nonnegative(T, gap);
}

#if !FIELD
/*
:::{claim} curvature_of_the_member
:title: The ratio of the curvatures, measured on curves of the plane and of space
:zh: 曲率比的直接计算
:types: rational interval double
:given: weights and points of the plane and of space, $n\ge2$, any $c$, every $r=1,\dots,n-1$
:then: $((n-r)(n-1))^2\,\kappa_{n-r}^2(c)=(n(n-r-1))^2\,\kappa^2(c)$
:method: The second way: the recursion (3.3.2), (3.3.3) for the control points of the member, and the curvatures of both
  curves by the kernel.
:degrees: 2..6 sampled 10
:control: the ratio $\frac{n-r-1}{n-1}$
:::
*/
CLAIM(curvature_of_the_member)
{
    int n = T->degree;
    for (int dim = 2; dim <= 3; dim++)
        for (int r = 1; r < n; r++) {
            num R[3 * MAX_DEGREE + 3], w[MAX_DEGREE + 1], Rr[3 * MAX_DEGREE + 3], wr[MAX_DEGREE + 1];
            num c = parameter(T, "c");
            G(any_curve)(T, n, dim, R, w);
            G(rational_casteljau)(n, dim, R, w, c, r, Rr, wr);
            num left = G(rational_curvature_squared)(n - r, dim, Rr, wr, c);
            num right = G(rational_curvature_squared)(n, dim, R, w, c);
            int p = fault(T, n - r, 1) * (n - 1), q = fault(T, n, 1) * (n - r - 1);
            same(T, mul(from_int((long)p * p), left), mul(from_int((long)q * q), right));
        }
}
#endif

/* n!/(n-k)! */
static long G(factorial_part)(int n, int k) { return k == 0 ? 1 : n * G(factorial_part)(n - 1, k - 1); }

/*
:::{claim} unweighted_derivatives_are_parallel
:title: With equal weights the derivatives of member and curve are parallel in every order
:zh: 权相等时各阶导矢平行
:given: $n\ge1$, points, equal weights, any $c$, every $r=0,\dots,n$ and $k=0,\dots,n-r$
:then: $\frac{n!}{(n-k)!}\,\partial_t^kR^{[n-r]}(c,c)=\frac{(n-r)!}{(n-r-k)!}\,R^{(k)}(c)$
:method: The member by the recursion, the derivatives by those of Bézier curves; one coordinate.
:degrees: 1..6 sampled 12
:control: the factors left out
:::
*/
CLAIM(unweighted_derivatives_are_parallel)
{
    int n = T->degree;
    num R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], D[MAX_DEGREE + 1], c = parameter(T, "c");
    for (int i = 0; i <= n; i++) {
        R[i] = unknown(T, "R", i);
        w[i] = from_int(1);
    }
    G(rational_derivatives)(n, 1, R, w, c, n, D);
    for (int r = 0; r <= n; r++) {
        num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], E[MAX_DEGREE + 1];
        G(rational_casteljau)(n, 1, R, w, c, r, Rr, wr);
        G(rational_derivatives)(n - r, 1, Rr, wr, c, n - r, E);
        for (int k = 0; k <= n - r; k++) {
            long p = fault(T, G(factorial_part)(n, k), 1), q = fault(T, G(factorial_part)(n - r, k), 1);
            same(T, mul(from_int(p), E[k]), mul(from_int(q), D[k]));
        }
    }
}

/*
:::{claim} osculating_flats_agree
:title: The homogeneous derivatives of member and curve are parallel: their osculating flats agree
:zh: 齐次导矢平行，密切空间重合
:given: weights and points, any $c$, every $r=0,\dots,n$ and $k=0,\dots,n-r$
:then: $\frac{n!}{(n-k)!}\,\partial_t^kP^{[n-r]}(c,c)=\frac{(n-r)!}{(n-r-k)!}\,P^{(k)}(c)$ for the coordinate and
  for the weight
:method: The member's points and weights by the recursion (3.3.2), (3.3.3); one coordinate.  The factors are not 0, so
  $P,\dots,P^{(k)}$ and the member's derivatives span the same spaces, and the flats of $R$ in them are the same.
:degrees: 1..6 sampled 10
:control: the weights of the member taken as 1
:::
*/
CLAIM(osculating_flats_agree)
{
    int n = T->degree;
    num R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], H[2 * MAX_DEGREE + 2], D[2 * MAX_DEGREE + 2], c = parameter(T, "c");
    G(any_curve)(T, n, 1, R, w);
    G(rational_homogenize)(n, 1, R, w, H);
    G(bezier_derivatives)(n, 2, H, c, n, D);
    for (int r = 0; r <= n; r++) {
        num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], Hr[2 * MAX_DEGREE + 2], E[2 * MAX_DEGREE + 2];
        G(rational_casteljau)(n, 1, R, w, c, r, Rr, wr);
        for (int i = 0; T->faulty && i <= n - r; i++)
            wr[i] = from_int(1);
        G(rational_homogenize)(n - r, 1, Rr, wr, Hr);
        G(bezier_derivatives)(n - r, 2, Hr, c, n - r, E);
        for (int k = 0; k < 2 * (n - r + 1); k++)
            same(T, mul(from_int(G(factorial_part)(n, k / 2)), E[k]),
                 mul(from_int(G(factorial_part)(n - r, k / 2)), D[k]));
    }
}

#if RATIONAL
/*
:::{claim} cubic_member_has_other_curvature
:title: The cubic and its quadratic member do not osculate
:zh: 三次曲线与其二次族曲线不密切
:kind: counterexample
:data: R = (0,0) (1/3,0) (2/3,0) (1,1); ω = 1 1 1 1; c = 1
:result: the member's points = (1/3,0) (2/3,0) (1,1); κ² of the curve = 9/250; κ² of the member = 81/4000
:given: the points $R$ of the cubic $(\tau,\tau^3)$ on $[0,1]$, equal weights, and the end $c$; $r=1$, so that the member is a
  quadratic, $n-r=2$
:then: $\kappa^2$ of the curve and of the member differ, so that the contact is not of order 2
:method: The curvatures at the common point are computed exactly.
:control: the curvature of the member multiplied by $\frac{(n-r)(n-1)}{n(n-r-1)}$
:::
*/
CLAIM(cubic_member_has_other_curvature)
{
    enum { n = 3, r = 1 };
    num R[8], w[4], Rr[6], wr[3];
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    num c = given(T, "c"), ratio = fault(T, from_ratio((n - r) * (n - 1), n * (n - r - 1)), from_int(1));
    G(rational_casteljau)(n, 2, R, w, c, r, Rr, wr);
    num curve = G(rational_curvature_squared)(n, 2, R, w, c);
    num member = G(rational_curvature_squared)(n - r, 2, Rr, wr, c);
    found_points(T, "the member's points", n - r + 1, 2, Rr);
    found(T, "κ² of the curve", curve);
    found(T, "κ² of the member", member);
    about(T, "the squared curvature, left of the curve, right of the member");
    same(T, curve, mul(mul(ratio, ratio), member));
}

/*
:::{claim} member_runs_slower_than_the_curve
:title: The derivative of the member at the contact is not that of the curve
:zh: 接触点处族曲线的导矢不等于曲线的导矢
:kind: counterexample
:data: R = (0,0) (1,2) (2,0); ω = 1 1 1; c = 1/2
:result: R' of the curve = (2,0); R' of the member = (1,0)
:given: $n=2$, the points $R$ of a parabola, equal weights, the parameter $c$ in the middle, and $r=1$
:then: the derivatives of curve and member at $t=c$ are parallel and not equal
:method: Both are computed exactly; their first coordinates are compared.
:control: the factor $n/(n-r)$ supplied
:::
*/
CLAIM(member_runs_slower_than_the_curve)
{
    enum { n = 2, r = 1 };
    num R[6], w[3], Rr[4], wr[2], D[4], E[4];
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    num c = given(T, "c");
    G(rational_casteljau)(n, 2, R, w, c, r, Rr, wr);
    G(rational_derivatives)(n, 2, R, w, c, 1, D);
    G(rational_derivatives)(n - r, 2, Rr, wr, c, 1, E);
    found_points(T, "R' of the curve", 1, 2, D + 2);
    found_points(T, "R' of the member", 1, 2, E + 2);
    about(T, "the first coordinates of the derivatives");
    same(T, D[2], fault(T, mul(from_ratio(n, n - r), E[2]), E[2]));
}

/* How often τ = c is a root of the equation of the member c of level r of the curve (R, 1) when the point R(τ) is put into
 * it; that polynomial in τ is the result of the given name. */
static int G(multiplicity_of_the_contact)(trial *T, int n, const num R[], int r, num c, const char *name)
{
    num w[MAX_DEGREE + 1], Rr[2 * MAX_DEGREE + 2], wr[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++)
        w[i] = from_int(1);
    G(rational_casteljau)(n, 2, R, w, c, r, Rr, wr);
    poly value = poly_constant(from_int(0)), linear = poly_sub(poly_variable(), poly_constant(c));
    int degree = n * (n - r), multiplicity = 0;
    for (int k = 0; k <= degree; k++) { /* Lagrange's interpolation at τ = 0, ..., degree */
        num point[2];
        G(rational_point)(n, 2, R, w, from_int(k), point);
        poly basis = poly_constant(G(implicit_value)(n - r, Rr, wr, point[0], point[1]));
        for (int j = 0; j <= degree; j++)
            if (j != k)
                basis = poly_mul(basis, poly_from_q(2, (num[]){from_ratio(-j, k - j), from_ratio(1, k - j)}));
        value = poly_add(value, basis);
    }
    found_text(T, name, poly_to_string(value, "τ"));
    for (; poly_degree(value) > 0 && poly_divides(linear, value); multiplicity++)
        value = poly_quotient(value, linear);
    return multiplicity;
}

/*
:::{claim} cubic_member_meets_the_curve_twice
:title: At the contact the cubic and its member have two coincident intersections, not three
:zh: 接触点处的交点重数为二
:kind: counterexample
:data: R = (0,0) (1/3,0) (2/3,0) (1,1); c = 1/2; r = 1
:result: f(τ) = "-2/9*τ^3 + 1/4*τ^2 - 1/12*τ + 1/144"; multiplicity = 2
:given: the points $R$ of $(\tau,\tau^3)$ on $[0,1]$ with equal weights, the parameter $c$ in the middle, and the level $r$
:let: $f(\tau)$ be the left side of the equation of the member, with the point of the curve inserted
:then: $f$ has $\tau=c$ as a root of multiplicity 2, which is less than $n-r+1$
:method: The equation is the determinant (3.4.1) of the member's control points; its value on the curve is a polynomial
  of degree at most $n(n-r)$, found from one value more; the multiplicity is the number of times $\tau-c$ divides it.
:control: the multiplicity 2
:::
*/
CLAIM(cubic_member_meets_the_curve_twice)
{
    enum { n = 3 };
    num R[2 * n + 2];
    given_points(T, "R", n + 1, 2, R);
    num c = given(T, "c");
    int r = given_whole(T, "r"), multiplicity = G(multiplicity_of_the_contact)(T, n, R, r, c, "f(τ)");
    found_whole(T, "multiplicity", multiplicity);
    about(T, "the multiplicity is n-r+1");
    agree(T, multiplicity == fault(T, 2, n - r + 1));
}

/*
:::{claim} quartic_member_meets_the_curve_twice
:title: At the contact the quartic has two coincident intersections with its members of degree 3 and 1
:zh: 四次曲线与其三次、一次族曲线的接触重数均为二
:kind: counterexample
:data: R = (0,0) (1/4,0) (1/2,0) (3/4,0) (1,1); c = 1/2; r = 1 3
:result: f(τ) = "27/256*τ^4 - 1/8*τ^3 + 3/64*τ^2 - 3/512*τ + 1/4096"; g(τ) = "1/4*τ^4 - 1/8*τ + 3/64"; multiplicities = 2 2
:given: the points $R$ of $(\tau,\tau^4)$ on $[0,1]$ with equal weights, the parameter $c$ in the middle, and two levels $r$
:let: $f(\tau)$ and $g(\tau)$ be the left sides of the equations of the two members, with the point of the curve inserted
:then: both have $\tau=c$ as a root of multiplicity 2, which is not $n-r$
:method: As for the cubic.
:control: the multiplicity 2
:::
*/
CLAIM(quartic_member_meets_the_curve_twice)
{
    enum { n = 4 };
    static const char *const name[2] = {"f(τ)", "g(τ)"};
    num R[2 * n + 2], level[2], found[2];
    given_points(T, "R", n + 1, 2, R);
    num c = given(T, "c");
    given_points(T, "r", 2, 1, level);
    int as_printed = 0;
    for (int k = 0; k < 2; k++) {
        int r = (int)to_double_q(level[k]), multiplicity = G(multiplicity_of_the_contact)(T, n, R, r, c, name[k]);
        found[k] = from_int(multiplicity);
        as_printed += multiplicity == fault(T, 2, n - r);
    }
    found_points(T, "multiplicities", 2, 1, found);
    about(T, "whether one of the two multiplicities is n-r");
    agree(T, as_printed > 0);
}

/*
:::{claim} weighted_member_has_other_directions
:title: With weights the second derivatives of curve and member are not parallel
:zh: 有权时二阶导矢不平行
:kind: counterexample
:data: R = (0,0) (1,0) (1,1) (0,1); ω = 1 2 1 1; c = 0
:instead: ω = 1 1 1 1
:result: R'' of the curve = (-54,6); R'' of the member = (-22,2); determinant = 24
:given: four points $R$, weights $\omega$ that are not equal, the first parameter $c$, and $r=1$
:then: $R''(c)\times\partial_t^2R^{[n-r]}(c,c)\ne0$
:method: Both derivatives are computed exactly.
:control: equal weights
:::
*/
CLAIM(weighted_member_has_other_directions)
{
    enum { n = 3, r = 1 };
    num R[8], w[4], Rr[6], wr[3], D[6], E[6];
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    num c = given(T, "c");
    G(rational_casteljau)(n, 2, R, w, c, r, Rr, wr);
    G(rational_derivatives)(n, 2, R, w, c, 2, D);
    G(rational_derivatives)(n - r, 2, Rr, wr, c, 2, E);
    num determinant = G(cross2)(D + 4, E + 4);
    found_points(T, "R'' of the curve", 1, 2, D + 4);
    found_points(T, "R'' of the member", 1, 2, E + 4);
    found(T, "determinant", determinant);
    about(T, "the determinant of the two second derivatives");
    vanishes(T, determinant);
}
#endif

#include "chapters/judge/claims_off.h"
