/*
# Special coordinates and the standard form (特殊坐标系与标准形)

Before it classifies the curves (3.1.5) the source brings them into a simple position, by a motion of the plane,
and gives them simple weights, by a change of the parameter.
*/
#include "exact/record/roots.h"

#include "chapters/judge/claims_on.h"
#include "chapters/rational-bezier/conics.h"

/*
:::{statement} wang-ch3:3.5-coordinates
:title: Special coordinates of the triangle
:zh: 特殊坐标系
:printed: A special coordinate system is taken in which $R_0=(-l,0)$, $R_1=(x_1,y_1)$, $R_2=(l,0)$; by the geometric
  invariance it suffices to determine the class of the curve there.
:holds-by: special_coordinates_exist kind_in_any_coordinates directions_at_infinity
:needs: flat_triangle_is_no_conic | § 3.1: the affine frame $\{R_1;R_1R_0,R_1R_2\}$ | $R_0$, $R_1$, $R_2$ do not lie on
  a line: else there is no class to be determined.
:needs: weight_zero_is_a_segment | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | no weight is 0: positive ones are not.
:::

:::{claim} special_coordinates_exist
:title: A motion brings the chord onto the first axis, its middle to the origin
:zh: 经运动可将弦置于 x 轴
:given: points $R_0\ne R_2$ with the middle $M$ and $R_2-R_0=2(p,q)$, and two more points $P$ and $Q$
:where: $R_0\ne R_2$
:let: $l^2=p^2+q^2$, and let a point $P$ have the coordinates $X=\frac{(P-M)\cdot(p,q)}l$, $Y=\frac{(p,q)\times(P-M)}l$
:then: $R_0$ and $R_2$ have the coordinates $(\mp l,0)$, and distances and the determinant of two differences are those
  of the plane
:method: All are multiplied by $l$ or $l^2$, so that no root is taken; identities in $M$, $p$, $q$, $P$, $Q$.
:over: p# q# M#: points
:control: $Y$ with $p$ and $q$ exchanged
:::
*/
CLAIM(special_coordinates_exist)
{
    num M[2], P[4], e[2] = {unknown(T, "p", 0), unknown(T, "q", 0)}, ll = add(mul(e[0], e[0]), mul(e[1], e[1]));
    num X[4], Y[4]; /* l times the coordinates of R_0, R_2, P, Q */
    for (int c = 0; c < 2; c++) {
        M[c] = unknown(T, "M", c);
        P[c] = unknown(T, "P", c);
        P[2 + c] = unknown(T, "Q", c);
    }
    num R[8] = {sub(M[0], e[0]), sub(M[1], e[1]), add(M[0], e[0]), add(M[1], e[1]), P[0], P[1], P[2], P[3]};
    for (int k = 0; k < 4; k++) {
        num d[2] = {sub(R[2 * k], M[0]), sub(R[2 * k + 1], M[1])};
        X[k] = add(mul(d[0], e[0]), mul(d[1], e[1]));
        Y[k] = fault(T, sub(mul(e[0], d[1]), mul(e[1], d[0])), sub(mul(e[1], d[1]), mul(e[0], d[0])));
    }
    about(T, "l X and l Y of the ends of the chord");
    same(T, X[0], neg(ll));
    same(T, X[1], ll);
    vanishes(T, Y[0]);
    vanishes(T, Y[1]);
    num dX = sub(X[3], X[2]), dY = sub(Y[3], Y[2]), dx = sub(P[2], P[0]), dy = sub(P[3], P[1]);
    about(T, "l² times a squared distance");
    same(T, add(mul(dX, dX), mul(dY, dY)), mul(ll, add(mul(dx, dx), mul(dy, dy))));
    about(T, "l² times a determinant of differences");
    /* (X_Q - X_P)(Y_2 - Y_P) - (Y_Q - Y_P)(X_2 - X_P) */
    num here = sub(mul(dX, sub(Y[1], Y[2])), mul(dY, sub(X[1], X[2])));
    same(T, here, mul(ll, sub(mul(dx, sub(R[3], P[1])), mul(dy, sub(R[2], P[0])))));
}

/*
Three weights carry one essential number.  A common factor changes nothing; and a fractional linear change of the
parameter that keeps 0 and 1 multiplies the weights by $1,\rho,\rho^2$, so that $\rho$ can be chosen to make the outer
ones equal.  This also tells how the formula must look before it is read: $t$ has to be a quotient of linear functions
of $u$, and $u$ can stand under no root.

:::{statement} wang-ch3:3.5.1
:title: The change of parameter that leads to the standard form
:zh: 化为标准形的参数变换
:printed: $t=\frac{\sqrt{\omega_0u}}{\sqrt{\omega_0u}+\sqrt{\omega_2(1-u)}}$, $0\le u\le1$, turns the curve into the
  rational Bézier curve $R^*(u)$ with the same control points and the weights $\left(1,\omega,1\right)$,
  $\omega=\frac{\omega_1}{\sqrt{\omega_0\omega_2}}$.
:class: misprint
:refuted-by: roots_over_the_parameter_are_wrong
:corrected: $t=\frac{\sqrt{\omega_0}\,u}{\sqrt{\omega_0}\,u+\sqrt{\omega_2}\,(1-u)}$, $0\le u\le1$, turns the curve into
  the rational Bézier curve $R^*(u)$ with the same control points and the weights $\left(1,\omega,1\right)$,
  $\omega=\frac{\omega_1}{\sqrt{\omega_0\omega_2}}$.
:corrected-by: standard_form_by_a_change_of_parameter standard_parameter_runs_through_the_interval
:confirmed-by: printed_change_has_the_root_of_a_product
:needs: negative_weights_lose_their_sign | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive.
:figure: standard_parameter

The roots belong over the weights alone; in the text at hand they cover $u$ and $1-u$ too.  With the printed roots the
three terms are as $1-u:2\omega\sqrt{u(1-u)}:u$, with the root of a quadratic polynomial in the middle.
:::
*/

/* a u / (a u + c (1-u)) */
static num G(fraction_of)(num a, num c, num u)
{
    num top = mul(a, u);
    return div(top, add(top, mul(c, sub(from_int(1), u))));
}

/*
:::{claim} standard_form_by_a_change_of_parameter
:title: The fractional linear change of parameter gives the weights 1, omega, 1
:zh: 分式线性变换给出标准形
:given: points $R_0,R_1,R_2$, weights $\omega_0,\omega_1,\omega_2>0$ and $u\in(0,1)$
:where: the weights are positive
:let: $\omega=\frac{\omega_1}{\sqrt{\omega_0\omega_2}}$,
  $t=\frac{\sqrt{\omega_0}\,u}{\sqrt{\omega_0}\,u+\sqrt{\omega_2}\,(1-u)}$
:then: the curve with the weights $\omega_i$ has at $t$ the point that the curve with the weights $1,\omega,1$ has at $u$;
  $\omega^2=\omega_1^2/(\omega_0\omega_2)$
:method: The weights are $\omega_0=a^2$, $\omega_1$ and $\omega_2=c^2$ with $a,c>0$ variables, so every pair of positive
  weights is reached; identities in these, one coordinate of the points, and $u$.
:over: a# c#: weights
:control: $a$ and $c$ exchanged in $t$
:::
*/
CLAIM(standard_form_by_a_change_of_parameter)
{
    num a, c, w[3], R[3], u = inside(T, "u"), one = from_int(1), before, after, I[1];
    G(square_ends)(T, &a, &c, w);
    for (int i = 0; i < 3; i++)
        R[i] = unknown(T, "R", i);
    num omega = div(w[1], mul(a, c)), v[3] = {one, omega, one};
    num t = fault(T, G(fraction_of)(a, c, u), G(fraction_of)(c, a, u));
    G(rational_point)(2, 1, R, w, t, &before);
    G(rational_point)(2, 1, R, v, u, &after);
    about(T, "R(t) and R*(u)");
    same(T, before, after);
    about(T, "ω² and I_1");
    G(rational_invariants)(2, w, I);
    same(T, mul(omega, omega), I[0]);
}

/*
:::{claim} printed_change_has_the_root_of_a_product
:title: With the roots as printed the middle term has the root of u(1-u)
:zh: 印出的根号使中项含 u(1-u) 的平方根
:given: weights $\omega_0=a^2$, $\omega_1$, $\omega_2=c^2$ with $a,c>0$; $p$ and $q$ for the roots of $u$ and $1-u$
:where: the weights are positive
:let: $t=\frac{ap}{ap+cq}$, as printed; $\omega=\frac{\omega_1}{ac}$
:then: $(1-t)^2\omega_0$, $2t(1-t)\omega_1$ and $t^2\omega_2$ are $q^2$, $2\omega pq$ and $p^2$ times one number
:method: Identities in $a$, $c$, $\omega_1$, $p$ and $q$; the number is $\left(\frac{ac}{ap+cq}\right)^2$.
:over: a# c#: weights; p q: -
:control: $\omega_1$ for $\omega$
:::
*/
CLAIM(printed_change_has_the_root_of_a_product)
{
    num a, c, w[3], p = positive(T, "p", 0), q = positive(T, "q", 0), one = from_int(1), two = from_int(2);
    G(square_ends)(T, &a, &c, w);
    num below = add(mul(a, p), mul(c, q)), t = div(mul(a, p), below), rest = sub(one, t);
    num number = div(mul(a, c), below), omega = fault(T, div(w[1], mul(a, c)), w[1]);
    num square = mul(number, number);
    about(T, "the first term");
    same(T, mul(mul(rest, rest), w[0]), mul(square, mul(q, q)));
    about(T, "the middle term");
    same(T, mul(mul(two, mul(t, rest)), w[1]), mul(square, mul(mul(two, omega), mul(p, q))));
    about(T, "the last term");
    same(T, mul(mul(t, t), w[2]), mul(square, mul(p, p)));
}

#if RATIONAL
/*
:::{claim} roots_over_the_parameter_are_wrong
:title: With roots over the parameter too, the point is another one
:zh: 根号罩住参数时得到另一点
:kind: counterexample
:data: R = (-1,0) (0,1) (1,0); ω = 1 1 1; u = 9/25
:result: t = 3/7; R(t) = (-1/7,24/49); R*(u) = (-7/25,288/625)
:given: the points $R$, equal weights, which are standard, and a parameter $u$ such that $u$ and $1-u$ are squares
:then: with the printed $t$ the point $R(t)$ is not $R^*(u)=R(u)$
:method: Both points are computed.
:control: the roots over the weights alone, so that $t=u$
:::
*/
CLAIM(roots_over_the_parameter_are_wrong)
{
    num R[6], w[3], P[2], Q[2], one = from_int(1);
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    num u = given(T, "u");
    num top = fault(T, mul(root(2, w[0]), u), root(2, mul(w[0], u)));
    num rest = fault(T, mul(root(2, w[2]), sub(one, u)), root(2, mul(w[2], sub(one, u))));
    num t = div(top, add(top, rest));
    G(rational_point)(2, 2, R, w, t, P);
    G(rational_point)(2, 2, R, w, u, Q);
    found(T, "t", t);
    found_points(T, "R(t)", 1, 2, P);
    found_points(T, "R*(u)", 1, 2, Q);
    about(T, "the first coordinates of R(t) and R*(u)");
    same(T, P[0], Q[0]);
}

/*
:::{statement} wang-ch3:3.5.2
:title: The standard weights
:zh: 标准形的权
:printed: The curve then becomes the rational Bézier curve $R^*(u)$ with the same control points and the weights
  $(\omega_0^*,\omega_1^*,\omega_2^*)=\left(1,\ \omega=\frac{\omega_1}{\sqrt{\omega_0\omega_2}},\ 1\right)$.
:meant: (3.5.1), the change of parameter to which the word then points | The change of parameter is (3.5.1) with the roots over the weights alone.
:holds-by: standard_form_by_a_change_of_parameter standard_parameter_runs_through_the_interval
:needs: negative_weights_lose_their_sign | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive.

With the roots as printed in (3.5.1) the curve does not become this one.
:::

:::{claim} negative_weights_lose_their_sign
:title: With outer weights that are negative the formula can take the wrong arc
:zh: 首末权为负时公式可能取另一段弧
:kind: counterexample
:data: R = (-1,0) (0,1) (1,0); ω = -1 1/2 -1; u = 1/2
:instead: ω = 1 1/2 1
:result: standard weights = 1 1/2 1; R(u) = (0,-1); R*(u) = (0,1/3)
:given: the points $R$ and weights $\omega$ whose outer ones are negative, the middle one positive; the parameter $u$
  in the middle
:then: the standard weight is positive, and the curve of the standard weights has at $u$ another point than the curve itself
:method: Both points are computed.
:control: all weights positive
:::
*/
CLAIM(negative_weights_lose_their_sign)
{
    num R[6], w[3], P[2], Q[2], one = from_int(1);
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    num u = given(T, "u"), v[3] = {one, G(conic_standard_weight)(w), one};
    G(rational_point)(2, 2, R, w, u, P);
    G(rational_point)(2, 2, R, v, u, Q);
    found_points(T, "standard weights", 3, 1, v);
    found_points(T, "R(u)", 1, 2, P);
    found_points(T, "R*(u)", 1, 2, Q);
    about(T, "the second coordinate, left of the curve, right with the weights (3.5.2)");
    same(T, P[1], Q[1]);
}
#endif

/*
To change the sign of all three weights leaves the curve as it is, but (3.5.2) does not notice: the product
$\omega_0\omega_2$ is the same, and $\omega_1$ has changed its sign.  Where the outer weights are negative all signs
are to be changed first.

:::{statement} wang-ch3:3.5-same-shape
:title: The standard form has the same shape
:zh: 标准形的形状不变
:printed: By theorem 3.2.1 the shape of this curve, $R^*(u)$, is the same as that of (3.1.5).
:holds-by: standard_form_by_a_change_of_parameter standard_parameter_runs_through_the_interval
:needs: negative_weights_lose_their_sign | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive: else it may be the other arc; in the example $R(u)$ is below the base, where the arc of the positive standard weights has no point.

What is used of theorem 3.2.1 is that equal invariants suffice, property 3.2.10.  That direction asks nothing of the
points, so it also serves where they lie on a line and the theorem says nothing.
:::

:::{claim} standard_parameter_runs_through_the_interval
:title: The change of parameter runs once through the interval
:zh: 参数变换是区间的一一映射
:given: weights $\omega_0=a^2>0$, $\omega_2=c^2>0$ and $u\in(0,1)$
:let: $t=\frac{au}{au+c(1-u)}$
:then: $0\le t\le1$, and $u=\frac{ct}{ct+a(1-t)}$; $t=0$ at $u=0$ and $t=1$ at $u=1$
:method: $t$ and $1-t$ have positive coefficients in $a$, $c$ and $\frac u{1-u}$; the rest are identities.
:scope: 0 ≤ u ≤ 1
:over: a# c#: weights; u: -
:control: $a$ for $c$ in the inverse
:::
*/
CLAIM(standard_parameter_runs_through_the_interval)
{
    num a, c, w[3], u = inside(T, "u"), one = from_int(1), zero = from_int(0);
    G(square_ends)(T, &a, &c, w);
    num t = G(fraction_of)(a, c, u);
    nonnegative(T, t);
    nonnegative(T, sub(one, t));
    about(T, "u from t");
    same(T, G(fraction_of)(fault(T, c, a), a, t), u);
    about(T, "the ends");
    same(T, G(fraction_of)(a, c, zero), zero);
    same(T, G(fraction_of)(a, c, one), one);
}

#include "chapters/judge/claims_off.h"
