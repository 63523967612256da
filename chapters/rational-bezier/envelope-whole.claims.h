/*
# The whole envelope (整个包络)

A point $X(t,c)$ of the member is a point of the envelope, in the sense of the differential geometry of plane
families, when the two derivatives $X_t$ and $X_c$ are parallel.  In homogeneous coordinates this says
$\det(P,P_t,P_c)=0$.  With $q(x,y)=p(c^{r-1},t^{n-r-1},x,y)$, what is left of the polar form, it factors for every $n$
and $r$:

$$\det(P,P_t,P_c)=r(n-r)\,(t-c)\;w_r(c,t),\qquad w_r(c,t)=\det\bigl(q(0,0),q(0,\delta),q(\delta,\delta)\bigr).$$

The factor $t-c$ is the curve itself.  The other factor, when it has zeros, gives further envelopes.
*/
#include "exact/record/resultant.h"
#include "exact/record/sign.h"

#include "chapters/judge/elementary.h"
#include "chapters/rational-bezier/free-curve.h"
#include "chapters/rational-bezier/polar-form.h"

#include "chapters/judge/claims_on.h"
#include "chapters/rational-bezier/plane-polynomials.h"

/*
:::{statement} wang-ch3:thm-3.3.2
:title: The curve is the envelope of the family
:zh: 曲线是族的包络
:printed: The rational Bézier curve $\mathbf R(t)$ of degree $n$ ($n\ge2$) on the left of (3.3.1) is the envelope of the family of rational Bézier curves of degree
  $n-r$ ($r=1,2,\dots,n-1$) that (3.3.2), (3.3.3) determine, that is
  $\mathbf R(t)=\operatorname{env}\{\mathbf R^{[n-r]}(t,c),\ a\le t\le b\mid a\le c\le b\}$ with the curves of (3.3.4).
:reading: members_are_flatter_powers | "an envelope", a curve that in each of its points is touched by a member,
  wherever $\mathbf R'\ne0$; that it is touched is the step of the correction on the members and the curve at the contact, and what decides this reading shows that the members exist
:reading-with: triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power cut_coefficients_are_convex
:reading: cubic_family_has_another_envelope | "the envelope", all points that satisfy the envelope condition, as the equality sign says; the condition is
  that the derivatives of the point of the member by $t$ and by $c$ are parallel, and already the cubic $(\tau,\tau^3)$ has another such point
:reading: convex_quartic_has_another_envelope | all points that satisfy the envelope condition, for curves without inflections
:reading: flat_point_has_another_envelope | all points that satisfy the envelope condition, for $r=1$ and curves with $\mathbf R'\times\mathbf R''\ge0$
:corrected: For a plane curve with the homogeneous points $P_i=(\omega_i\mathbf R_i,\omega_i)$, $c$ and $t$ counted in $[0,1]$, the polar form $p$ of the $P_i$, $q(x,y)=p(c^{r-1},t^{n-r-1},x,y)$, $\delta=1-0$ and
  $w_r(c,t)=\det(q(0,0),q(0,\delta),q(\delta,\delta))$ the points that satisfy the envelope condition are $\mathbf R$ together with the points of the pairs $(c,t)$ with $w_r(c,t)=0$; with positive weights they are
  $\mathbf R$ alone when the $\mathbf R_i$ are, in this order, the corners of a strictly convex polygon, so always for $n=2$ and a true triangle; for $r=1$
  and for $r=n-1$ they are $\mathbf R$ alone when $\mathbf R'\times\mathbf R''\ne0$ on $[a,b]$
:corrected-by: envelope_condition_factors envelope_condition_of_points members_are_flatter_powers
  triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power convex_polygon_has_one_envelope_in_every_degree
  corners_of_a_strictly_convex_polygon_turn_one_way determinant_of_three_sums_goes_by_triples wronskian_decides_the_outer_levels
  triangle_has_one_envelope
:confirmed-by: polar_derivatives convex_polygon_has_one_envelope inflections_give_the_other_envelopes
:needs: member_may_lose_a_point | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive; else (3.3.3) may give no point, and no member with it
:needs: cut_outside_can_fail | the theorem: $a\le c\le b$ | $a\le c\le b$: outside a weight of the triangle may vanish, as $\omega_1^1$ in the example, whatever the other weights are
:needs: member_may_have_a_pole_outside | the theorem: $a\le t\le b$ | $a\le t\le b$: outside the denominator may vanish although all $\omega_i>0$
:figure: envelope_extra

The text has something of both readings: the word, and the contact at $c=t$ that follows, speak for the first, the sign of equality for the second; what
$\operatorname{env}$ means is not said in this chapter.  Each example shows one point.  For the cubic such points lie on the axis $y=0$, for the quartic of reading 3
on a parabola; the two equations are found by eliminating $c$.
:::

The factorization takes three steps.  The condition is first brought from points to homogeneous vectors, where it is a
determinant.  Then the derivatives by $t$ and by $c$ turn out to be polar forms too, with $\delta$ in the place of one
argument.  Then all three columns are linear combinations of the same three vectors, and the determinant of the
coefficients comes out as a factor.

:::{claim} envelope_condition_of_points
:title: The points satisfy the envelope condition when three homogeneous vectors are dependent
:zh: 包络条件的齐次形式
:given: a plane family $X=(P_1,P_2)/P_3$ and the values $P$, $P_t$, $P_c$ of its homogeneous vector and of the two
  derivatives
:then: $\det(X_t,X_c)=\det(P,P_t,P_c)/P_3^3$
:method: The quotient rule gives $X_t$ and $X_c$; nine variables stand for the three vectors.
:over: Pt# Pc#: -
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
    /* det(X_t, X_c) = det(P, P_t, P_c)/P_3³ */
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
:over: H#: points; c
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
        /* P_t = (n-r) p(c^r, t^{n-r-1}, δ) */
        same(T, D[1], mul(from_int(fault(T, m, r)), sub(up, down)));
        about(T, "the derivative by c");
        G(polar)(n, 1, H, r - 1, c, m, t, one, one, &up);
        G(polar)(n, 1, H, r - 1, c, m, t, zero, zero, &down);
        /* P_c = r p(c^{r-1}, t^{n-r}, δ) */
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
:over: n a# b# d#: -; r; c; t
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
    /* det(P, P_t, P_c) = r (n-r) (t-c) det(q(0,0), q(0,δ), q(δ,δ)) */
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
:title: In the family of the cubic (τ, τ³) a point off the curve satisfies the envelope condition
:zh: 三次曲线 (τ,τ³) 的族在曲线外一点满足包络条件
:kind: counterexample
:data: R = (-1,-1) (-1/3,1) (1/3,-1) (1,1); r = 1; c = 3/4; t = 1/2
:instead: t = 3/4
:result: point of the member = (1/6,0); X_t, X_c = (4/3,0) (2/3,0); F at the point = -64/27
:given: the points $R$ of $(\tau,\tau^3)$, $-1\le\tau\le1$, with equal weights; the member $c$ of level $r$, and its
  point at the parameter $t$ of the inflection, both counted in $[0,1]$
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
:title: In the family of a quartic without inflections a point off the curve satisfies the envelope condition
:zh: 无拐点的四次曲线，其族在曲线外一点满足包络条件
:kind: counterexample
:data: R = (-1,5/2) (-1/2,-1) (0,1/2) (1/2,-1) (1,5/2); r = 2; c = 3/4; t = 1/4
:instead: t = 3/4
:result: point of the member = (0,-1/16); X_t, X_c = (1,0) (1,0); F at the point = 4096
:given: the points $R$ of a quartic, equal weights; the member $c$ of level $r$, and its point at $t=1-c$, both counted in
  $[0,1]$
:then: there the envelope condition is satisfied at a point that is not on the curve; the curve's curvature is positive
  throughout
:method: $X_t$ comes from the member's control points, $X_c$ from the Bézier curve that the point is in $c$; the value of (3.4.1) at the point is compared with 0.  That $R'\times R''$ is positive on the closed interval is decided first, by its sign as a
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
:title: In the family of (τ, τ⁴), which is flat at 0 and bends to one side, a point off the curve satisfies the envelope condition
:zh: 曲线 (τ,τ⁴) 无拐点而在 0 处平坦，其族在曲线外一点满足包络条件
:kind: counterexample
:data: R = (-1,1) (-1/2,-1) (0,1) (1/2,-1) (1,1); r = 1; c = 3/4; t = 1/2
:instead: t = 3/4
:result: point of the member = (1/8,0); X_t, X_c = (3/2,0) (1/2,0); F at the point = 16
:given: the points $R$ of $(\tau,\tau^4)$, $-1\le\tau\le1$, with equal weights; the member $c$ of level $r$, and its
  point at the parameter $t$ of the flat point, both counted in $[0,1]$
:then: there the envelope condition is satisfied at a point that is not on the curve; $R'\times R''\ge0$ throughout
:method: $X_t$ comes from the member's control points, $X_c$ from the Bézier curve that the point is in $c$; the value of (3.4.1) at the point is compared with 0.  That $R'\times R''$ is nowhere negative is decided first, by its sign as a polynomial.
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
These are not stray points: the equations of the second envelopes are found by eliminating $c$.

:::{claim} second_envelopes_by_elimination
:title: Eliminating c gives the curve and the second envelope
:zh: 消去 c 得到曲线与另一包络
:types: field
:data: R of the cubic = (-1,-1) (-1/3,1) (1/3,-1) (1,1); the cubic's level = 1; the cubic's curve = (1,3,0) (-1,0,1);
  the cubic's envelope = (1,0,1); R of the quartic = (-1,5/2) (-1/2,-1) (0,1/2) (1/2,-1) (1,5/2); the quartic's level
  = 2; the quartic's curve = (2,4,0) (3,2,0) (-2,0,1); the quartic's envelope = (16,2,0) (-16,0,1) (-1,0,0)
:instead: the cubic's curve = (1,3,0) (1,0,1); the quartic's envelope = (16,2,0) (-16,0,1) (1,0,0)
:given: the families of the cubic $(\tau,\tau^3)$ and of a convex quartic, each by its points and the level of its
  members; for each two polynomials in $x$ and $y$ by their terms $(\alpha,i,j)$, $\alpha x^iy^j$: one is 0 on the
  curve, the other on the further envelope, an axis for the cubic and a parabola for the quartic; the member $c$
  written as $f(x,y,c)=0$
:then: $\operatorname{Res}_c(f,f_c)$ is, up to a constant factor, the product of the two polynomials for the cubic,
  and for the quartic the product of the curve's and the square of the envelope's
:method: The member's equation is the determinant (3.4.1) of its control polygon, as a polynomial in $x$, $y$, $c$;
  the resultant by $c$ is a polynomial in $x$ and $y$, divided by the one stated.  The quotient is a constant.  The
  determinant has a factor in $c$ alone, the leading coefficient of $y$ in $t$, because $x$ is of lower degree in $t$; it is
  divided out first.
:scope: the two families
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
:title: With three points on a line every point of every member satisfies the envelope condition
:zh: 顶点共线时包络条件恒成立
:kind: counterexample
:data: R = (0,0) (1,1) (4,4); ω = 1 2 1
:instead: R = (0,0) (1,2) (4,4)
:result: w_1 = 0
:given: $n=2$, three points $R$ on a line with positive weights, $r=1$, any $c\ne t$
:then: the determinant $w_1$ of $q(0,0)$, $q(0,\delta)$, $q(\delta,\delta)$ is 0 although $t\ne c$
:method: For $n=2$ the determinant is that of the three homogeneous points and does not depend on $c$ and $t$.  For
  collinear points they lie in the plane of $R^3$ over that line, so that it vanishes for all $c$ and $t$ and singles
  out nothing.
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
When does $w_r$ have no zero?  For $n=2$ it is a constant.  For $r=1$ it depends on $t$ alone, for $r=n-1$ on $c$
alone, and its zeros are those of $R'\times R''$, such as inflections and cusps.  In between inflections do not
decide, but the control polygon does: write $\beta_i$ for the coefficients of $(1-c+cz)^{r-1}(1-t+tz)^{n-r-1}$; then

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
    G(free_curve)(T, 2, 2, R, w);
    G(rational_homogenize)(2, 2, R, w, H);
    G(polar)(2, 3, H, 0, zero, 0, zero, zero, zero, q);
    G(polar)(2, 3, H, 0, zero, 0, zero, zero, one, q + 3);
    G(polar)(2, 3, H, 0, zero, 0, zero, one, one, q + 6);
    for (int k = 0; k < 2; k++) {
        a[k] = sub(R[2 + k], R[k]);
        b[k] = sub(R[4 + k], R[k]);
    }
    num weights = mul(w[0], fault(T, mul(w[1], w[2]), w[2]));
    /* w_1 = ω_0 ω_1 ω_2 (R_1 - R_0) × (R_2 - R_0) */
    same(T, G(det3)(q, q + 3, q + 6), mul(weights, G(cross2)(a, b)));
}

/*
:::{claim} wronskian_decides_the_outer_levels
:title: For r = 1 and r = n-1 the second factor is, up to a number, the Wronskian of the curve, in every degree
:zh: r=1 与 r=n-1 时另一因子即曲线的 Wronski 行列式(任意次数)
:given: $b_i=Z^i$, whose polar form is the product of the $D(x)=1-x+xZ$ of its arguments, with $D(\delta)=Z-1$; $n\ge2$, any $t$; $U=D(t)^{n-2}$, so $q(x,y)=UD(x)D(y)$; three vectors
  $a=q(0,0)$, $b=q(0,\delta)$, $d=q(\delta,\delta)$ of space, the third coordinate the weight
:then: $P=D^2U=q(t,t)$, $P'=n(Z-1)DU=n\,q(t,\delta)$, $P''=n(n-1)(Z-1)^2U=n(n-1)\,q(\delta,\delta)$; $\det(q(t,t),q(t,\delta),q(\delta,\delta))=\det(a,b,d)$; and
  $\det(P,P',P'')=\omega^3\,\mathbf R'\times\mathbf R''$ for any $P=(\omega\mathbf R,\omega)$
:method: An equation that is linear in the $b_i$ holds for all of them when it holds for $b_i=Z^i$ with a variable $Z$.  The derivatives are taken by the rule
  $(D^m)'=mD^{m-1}D'$, with $U$ a variable.  Together $n^2(n-1)\,w_1(t)=\omega(t)^3\,(\mathbf R'\times\mathbf R'')(t)$, so that for $\omega>0$ the zeros of $w_1$ are the points where
  $\mathbf R'\times\mathbf R''$ is 0.  For $r=n-1$ the arguments $c$ and $t$ change their places.
:degrees: all
:over: Z#: points; U#: weights; n a# b# d# w#: -
:control: the factor $n^2$ in the place of $n(n-1)$
:::
*/
CLAIM(wronskian_decides_the_outer_levels)
{
    num one = from_int(1), Z = unknown(T, "Z", 0), U = positive(T, "U", 0), t = parameter(T, "t"),
        n = whole(T, "n", 2, 8);
    num D = add(sub(one, t), mul(t, Z)), slope = sub(Z, one), n1 = sub(n, one);
#if FIELD
    num by_t = derivative_f(D, t);
#else
    num by_t = slope;
#endif
    about(T, "P, P', P'' by the polar form");
    num at_t = D, first = mul(mul(n, by_t), mul(D, U)), second = mul(mul(mul(n, n1), mul(by_t, by_t)), U);
    same(T, first, mul(n, mul(U, mul(at_t, slope))));
    same(T, second, mul(mul(n, fault(T, n1, n)), mul(U, mul(slope, slope))));
    num a[3], b[3], d[3], P[3], P1[3], R1[2], R2[2];
    for (int k = 0; k < 3; k++) {
        a[k] = k < 2 ? unknown(T, "a", k) : positive(T, "w", 0);
        b[k] = unknown(T, "b", k);
        d[k] = unknown(T, "d", k);
        P1[k] = add(b[k], mul(t, d[k]));
        P[k] = add(add(a[k], mul(mul(from_int(2), t), b[k])), mul(mul(t, t), d[k]));
    }
    about(T, "the determinant of q(t,t), q(t,δ), q(δ,δ)");
    same(T, G(det3)(P, P1, d), G(det3)(a, b, d));
    num w = a[2];
    for (int k = 0; k < 2; k++) { /* (a, b, d) = (wR, w), (wR, w)', (wR, w)'' */
        num R = div(a[k], w);
        R1[k] = div(sub(b[k], mul(b[2], R)), w);
        R2[k] = div(sub(sub(d[k], mul(d[2], R)), mul(mul(from_int(2), b[2]), R1[k])), w);
    }
    about(T, "the determinant of P, P', P''");
    /* det(P, P', P'') = ω³ R' × R'' */
    same(T, G(det3)(a, b, d), mul(mul(w, mul(w, w)), G(cross2)(R1, R2)));
}

/*
The same for curves of low degree, computed by the polar form of their points:

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
:argued: every n | With geometric coefficients $P=D(t)^n$, and the equations are those of its derivatives $n\delta
  D^{n-1}$ and $n(n-1)\delta^2D^{n-2}$.
:over: H#: points; a# b# d#: -
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
    /* P = q(t,t), P' = n q(t,δ), P'' = n (n-1) q(δ,δ) */
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
    /* det(P, P', P'') = ω³ R' × R'' */
    same(T, G(det3)(V, V1, V2), mul(mul(w, mul(w, w)), G(cross2)(R1, R2)));
}

/*
:::{claim} corners_of_a_strictly_convex_polygon_turn_one_way
:title: Any three corners of a strictly convex polygon, in their order, turn to the side of its edges
:zh: 严格凸多边形依次任取三顶点转向相同
:given: vectors $p$, $a$, $b$, $c$ of the plane; positive numbers $A$, $B$, $C$, $E$, $F$ in the place of $p\times a$, $p\times b$, $p\times c$, $a\times b$, $b\times c$
:harmless: positive numbers $A$, $B$, $C$, $E$, $F$ | the sides of the edges of a strictly convex polygon that turns to the left
:then: $(p\times b)(a\times c)=(p\times a)(b\times c)+(p\times c)(a\times b)$, and $\frac{AF+CE}B>0$
:method: A polygon is strictly convex if all corners but two are strictly on one side of each of its edges, here the left one: $D_{i,i+1,k}>0$ and $D_{i,k,k+1}>0$.  With $p=R_{i+1}-R_i$,
  $a=R_j-R_i$, $b=R_k-R_i$ and $c=R_{k+1}-R_i$ it is the step of an induction on $k$: from $D_{ijk}>0$ follows $D_{i,j,k+1}>0$, $i+1<j<k$; it begins with $D_{i,j,j+1}>0$, and for
  $j=i+1$ nothing is left to be shown.  So all $D_{ijk}$, $i<j<k$, are positive; for a polygon that turns to the right, with its corners in the opposite order, all are negative.
:degrees: all
:over: p# a# b# c#: points; A B C E F: -
:control: $(p\times c)(a\times b)$ with the other sign
:::
*/
CLAIM(corners_of_a_strictly_convex_polygon_turn_one_way)
{
    num p[2], a[2], b[2], c[2];
    for (int k = 0; k < 2; k++) {
        p[k] = unknown(T, "p", k);
        a[k] = unknown(T, "a", k);
        b[k] = unknown(T, "b", k);
        c[k] = unknown(T, "c", k);
    }
    num first = mul(G(cross2)(p, a), G(cross2)(b, c)), second = mul(G(cross2)(p, c), G(cross2)(a, b));
    about(T, "four vectors of the plane");
    same(T, mul(G(cross2)(p, b), G(cross2)(a, c)), fault(T, add(first, second), sub(first, second)));
    num A = positive(T, "A", 0), B = positive(T, "B", 0), C = positive(T, "C", 0), E = positive(T, "E", 0),
        F = positive(T, "F", 0);
    about(T, "the sign");
    G(must_be_positive)(T, div(add(mul(A, F), mul(C, E)), B));
}

/*
:::{claim} convex_polygon_has_one_envelope_in_every_degree
:title: A strictly convex polygon with positive weights has the curve as its only envelope, in every degree and for every level
:zh: 严格凸控制多边形且权为正时包络只有曲线本身(任意次数、任意层)
:given: the coefficients $\beta_i$ of $\beta(z)=(1-c+cz)^{r-1}(1-t+tz)^{n-r-1}$, $0\le c,t\le1$, and the columns $B_i=(\beta_i,\beta_{i-1},\beta_{i-2})$; one more factor $1-x+xz$; $i<j<k$
:then: (1) with the factor, column $i$ becomes $(1-x)B_i+xB_{i-1}$, and the determinant of the new columns $i,j,k$ is the sum of eight determinants of old ones, each with a factor
  $(1-x)^{3-m}x^m\ge0$; (2) $w_r=\det(\sum\beta_iP_i,\sum\beta_{i-1}P_i,\sum\beta_{i-2}P_i)$
:method: (1) The eight have columns in the same order, or two equal ones, when $j-1=i$ or $k-1=j$.  So no determinant $\det(B_i,B_j,B_k)$, $i<j<k$, is negative: there is none for $\beta=1$, whose only one
  that is not 0 is $\det(B_0,B_1,B_2)=1$, and so on factor by factor; and $\det(B_0,B_1,B_2)=(1-c)^{3(r-1)}(1-t)^{3(n-r-1)}>0$.  (2) The polar form of $b_i=Z^i$ is the product of the $D(x)=1-x+xZ$; so
  $q(0,0)$, $q(0,\delta)$, $q(\delta,\delta)$ are $\beta(Z)$ times $1$, $Z-1$, $(Z-1)^2$, and the determinant with these columns is the one with $1$, $Z$, $Z^2$.  By
  `determinant_of_three_sums_goes_by_triples` $w_r$ is the sum of the $\det(B_i,B_j,B_k)\,\omega_i\omega_j\omega_kD_{ijk}$, which all have one strict sign by
  `corners_of_a_strictly_convex_polygon_turn_one_way`; so $w_r\ne0$ for $c,t<1$, and by symmetry for $c,t>0$; for $c=0$, $t=1$ and the like $\beta$ is a power of $z$ and one determinant is 1.
:degrees: all
:over: A# B# C# L# M# N# a# b# d# s: -
:scope: 0 ≤ c ≤ 1; 0 ≤ t ≤ 1
:control: one of the eight determinants left out
:::
*/
CLAIM(convex_polygon_has_one_envelope_in_every_degree)
{
    static const char *const name[2][3] = {{"A", "B", "C"}, {"L", "M", "N"}};
    num column[2][3][3], new[3][3], x = inside(T, "s"), rest = sub(from_int(1), x), sum = from_int(0);
    for (int l = 0; l < 3; l++)
        for (int m = 0; m < 3; m++) {
            for (int before = 0; before < 2; before++)
                column[before][l][m] = unknown(T, name[before][l], m);
            new[l][m] = add(mul(rest, column[0][l][m]), mul(x, column[1][l][m]));
        }
    for (int code = 0; code < fault(T, 8, 7); code++) {
        int i = code & 1, j = code >> 1 & 1, k = code >> 2;
        num factor = mul(i ? x : rest, mul(j ? x : rest, k ? x : rest));
        about(T, "the factor of one of the eight");
        G(must_be_positive)(T, factor);
        sum = add(sum, mul(factor, G(det3)(column[i][0], column[j][1], column[k][2])));
    }
    about(T, "the eight together");
    same(T, G(det3)(new[0], new[1], new[2]), sum);
    num a[3], b[3], d[3], slope[3], bend[3];
    for (int m = 0; m < 3; m++) { /* β, Zβ, Z²β */
        a[m] = unknown(T, "a", m);
        b[m] = unknown(T, "b", m);
        d[m] = unknown(T, "d", m);
        slope[m] = sub(b[m], a[m]);
        bend[m] = add(sub(d[m], add(b[m], b[m])), a[m]);
    }
    about(T, "the determinant w_r");
    same(T, G(det3)(a, slope, bend), G(det3)(a, b, d));
}

/*
For low degrees all minors are computed:

:::{claim} convex_polygon_has_one_envelope
:title: A convex polygon with positive weights has the curve as its only envelope, for every r
:zh: 凸控制多边形且权为正时包络只有曲线本身
:given: homogeneous points $P_i$, $n\ge2$, every $r=1,\dots,n-1$; $c,t$ of $(0,1)$ for the signs
:let: $\beta_i$ be the coefficients of $(1-c+cz)^{r-1}(1-t+tz)^{n-r-1}$
:then: $w_r(c,t)=\sum_{i<j<k}\begin{vmatrix}\beta_i&\beta_j&\beta_k\\\beta_{i-1}&\beta_{j-1}&\beta_{k-1}\\
  \beta_{i-2}&\beta_{j-2}&\beta_{k-2}\end{vmatrix}\det(P_i,P_j,P_k)$, and every $3\times3$ minor in it is nonnegative, that of
  $i,j,k=0,1,2$ positive
:method: The sum is Cauchy-Binet; it is computed in the field.  With $c=s/(1+s)$, $t=v/(1+v)$ the minors have no
  negative coefficient in $s$ and $v$, so they are nonnegative for $c,t\in[0,1]$; that of $0,1,2$ is $\beta_0^3$.  If $R_0,\dots,R_n$ are the corners of a convex polygon
  in this order and the weights are positive, all
  $\det(P_i,P_j,P_k)=\omega_i\omega_j\omega_k(R_j-R_i)\times(R_k-R_i)$, $i<j<k$, have one strict sign, hence
  $w_r\ne0$.
:degrees: 2..6 sampled 9
:scope: 0 < c < 1; 0 < t < 1
:argued: every n | The minors are Schur polynomials by the formula of Jacobi and Trudi, which have no negative
  coefficient.
:over: s v: -
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
#if FIELD || RATIONAL
                    if (k == 2)
                        agree(T, !G(is_zero)(minor));
#endif
                    sum = add(sum, mul(minor, G(det3)(H + 3 * i, H + 3 * j, H + 3 * k)));
                }
        about(T, "the factor w_r as a sum over the triangles of control points");
        same(T, G(det3)(q, q + 3, q + 6), sum);
    }
}

#include "chapters/judge/claims_off.h"
