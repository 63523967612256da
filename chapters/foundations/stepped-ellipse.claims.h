/*
# The step that uses what is there (用新横坐标的递推)

The second formula may use the new $x$, which is already there.  That this is no loss of care but a gain is the point of
the second way: the determinant becomes 1, the points no longer drift, and the spiral becomes an ellipse.
*/
#include "chapters/foundations/turning.h"

#include <stdio.h>

#include "chapters/judge/claims_on.h"

/*
:::{statement} hu-1987:1-3-second-substitution
:title: The second formula with the new abscissa
:zh: 用新横坐标代入
:printed: With $x_{n+1}=x_n-\varepsilon y_n$ in the place of $x_n$ in the second formula of (1-3-4), $y_{n+1}=\varepsilon x_{n+1}+y_n=\varepsilon x_n+(1-\varepsilon^2)y_n$
:holds-by: second_step_uses_the_new_abscissa
:figure: ellipse_of_the_second_way
:::

:::{statement} hu-1987:1-3-second-matrix
:title: The matrix of the second way
:zh: 第二种方法的矩阵
:printed: $x_{n+1}=x_n-\varepsilon y_n$, $y_{n+1}=\varepsilon x_n+(1-\varepsilon^2)y_n$, in matrices $P_{n+1}=P_nT$ with the $2\times2$ matrix
  $T=\begin{pmatrix}1&\varepsilon\\-\varepsilon&1-\varepsilon^2\end{pmatrix}$
:holds-by: second_step_uses_the_new_abscissa
:figure: ellipse_of_the_second_way
:::

:::{claim} second_step_uses_the_new_abscissa
:title: The matrix of the second way, and its determinant
:zh: 第二种方法的矩阵及其行列式
:given: any point, any $\varepsilon$
:let: $T=\begin{bmatrix}1&\varepsilon\\-\varepsilon&1-\varepsilon^2\end{bmatrix}$
:then: the row $(x,y)$ times $T$ is $x'=x-\varepsilon y$, $y'=y+\varepsilon x'$; $\det T=1$, the trace of $T$ is $2-\varepsilon^2$
:method: Identities in $x$, $y$ and $\varepsilon$.
:over: x y: point; e: ε
:control: $y'=y+\varepsilon x$
:::
*/
CLAIM(second_step_uses_the_new_abscissa)
{
    num P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, epsilon = unknown(T, "e", 0), M[4], next[2];
    G(second_step)(epsilon, M);
    G(row_times)(P, M, next);
    num x = sub(P[0], mul(epsilon, P[1]));
    same(T, next[0], x);
    same(T, next[1], add(P[1], mul(epsilon, fault(T, x, P[0]))));
    about(T, "determinant and trace");
    same(T, G(cross2)(M, M + 2), from_int(1));
    same(T, add(M[0], M[3]), sub(from_int(2), mul(epsilon, epsilon)));
}

/*
A determinant 1 is not enough for a closed curve: for $\varepsilon=2$ the points run away along two lines.  The trace
decides.  For $0<\varepsilon<2$ it is between $-2$ and 2, as that of a rotation, and the step is a rotation in other
coordinates.  The source shows these coordinates in an elegant way, by two sequences whose angles are half a step apart:
the abscissa takes the cosine before, the ordinate the sine after the half step.

:::{statement} hu-1987:1-3-second-difference-equations
:title: The difference equations of the ellipse
:zh: 椭圆的差分方程
:printed: The step of the second way can be described by the difference equations of an ellipse: with $x_n=r\cos\theta$, $y_n=r\sin(\theta+\frac{\Delta\theta}2)$, $\varepsilon=2\sin\frac{\Delta\theta}2$:
  $x_{n+1}=r\cos(\theta+\Delta\theta)=r\cos\theta-2r\sin\frac{\Delta\theta}2\sin(\theta+\frac{\Delta\theta}2)=x_n-\varepsilon y_n$,
  $y_{n+1}=r\sin(\theta+\Delta\theta+\frac{\Delta\theta}2)=r\sin(\theta+\frac{\Delta\theta}2)+2r\sin\frac{\Delta\theta}2\cos(\theta+\Delta\theta)=y_n+\varepsilon
  x_{n+1}$
:holds-by: second_orbit_has_equal_angles second_step_is_a_rotation_in_other_coordinates
:needs: second_step_of_two_has_no_angle | $\varepsilon=2^{-m}$, $m$ a positive whole number, from (1-3-4) on | $|\varepsilon|<2$: then every point can be written
  so
:figure: ellipse_of_the_second_way
:::

:::{claim} second_orbit_has_equal_angles
:title: Along the orbit of the second way an angle grows evenly
:zh: 第二种方法的等角参数
:given: any $r$, $\theta$ and $\delta=\frac{\Delta\theta}2$, by the directions $(a_0,a_1)\ne(0,0)$ and $(b_0,b_1)\ne(0,0)$ of the halves of $\theta$ and $\delta$
:harmless: $(a_0,a_1)\ne(0,0)$ and $(b_0,b_1)\ne(0,0)$ | so is the half of every angle
:then: with $\varepsilon=2\sin\delta$ the step $x_{n+1}=x_n-\varepsilon y_n$, $y_{n+1}=y_n+\varepsilon x_{n+1}$ takes $(r\cos\theta,r\sin(\theta+\delta))$ to
  $(r\cos(\theta+2\delta),r\sin(\theta+3\delta))$, and the middle terms of both chains are equal to the outer ones
:method: All sums of angles from the directions of their halves, as $(a_0b_0-a_1b_1,\,a_0b_1+a_1b_0)$ for $\theta+\delta$; the five numbers are variables.
:over: a# b#: angles; r: radius
:control: $\varepsilon=2\sin\Delta\theta$
:::
*/
CLAIM(second_orbit_has_equal_angles)
{
    struct G(half) a = G(free_half)(T, "a"), b = G(free_half)(T, "b"), once = G(sum_of)(a, b),
                   twice = G(sum_of)(once, b);
    struct G(turn) theta = G(turn_of)(a), delta = G(turn_of)(b), one = G(turn_of)(once), full = G(turn_of)(twice),
                   last = G(turn_of)(G(sum_of)(twice, b));
    num r = positive(T, "r", 0), two = from_int(2);
    num sine = fault(T, delta.sin, mul(two, mul(delta.sin, delta.cos)));
    num epsilon = mul(two, sine), M[4], next[2], P[2] = {mul(r, theta.cos), mul(r, one.sin)}, twice_r = mul(two, r);
    G(second_step)(epsilon, M);
    G(row_times)(P, M, next);
    about(T, "x_{n+1}");
    same(T, next[0], mul(r, full.cos));
    /* r cos(θ + Δθ) = r cos θ - 2r sin(Δθ/2) sin(θ + Δθ/2) */
    same(T, mul(r, full.cos), sub(mul(r, theta.cos), mul(mul(twice_r, delta.sin), one.sin)));
    about(T, "y_{n+1}");
    same(T, next[1], mul(r, last.sin));
    /* r sin(θ + 3Δθ/2) = r sin(θ + Δθ/2) + 2r sin(Δθ/2) cos(θ + Δθ) */
    same(T, mul(r, last.sin), add(mul(r, one.sin), mul(mul(twice_r, delta.sin), full.cos)));
}

/*
:::{claim} second_step_is_a_rotation_in_other_coordinates
:title: With one of its coordinates changed the step of the second way is a rotation, from every point
:zh: 换坐标后第二种方法为旋转
:given: any point $(x,y)$, any $\delta=\frac{\Delta\theta}2$, by the direction $(b_0,b_1)$ of its half, $\varepsilon=2\sin\delta$, $|\varepsilon|<2$
:where: $|\varepsilon|<2$
:let: $X=x$ and $Y=\frac{y-x\sin\delta}{\cos\delta}$
:then: $y=X\sin\delta+Y\cos\delta$, so that for $X=r\cos\theta$, $Y=r\sin\theta$ the point is $(r\cos\theta,r\sin(\theta+\delta))$; the step takes $(X,Y)$ to
  $(X\cos\Delta\theta-Y\sin\Delta\theta,\,X\sin\Delta\theta+Y\cos\Delta\theta)$
:method: The step on $(x,y)$, and the two coordinates of the result; $x$, $y$, $b_0$, $b_1$ variables.  Every $(X,Y)$ has an $r$ and a $\theta$.
:over: x y: point; b#: angles
:control: $\varepsilon=\sin\delta$
:::
*/
CLAIM(second_step_is_a_rotation_in_other_coordinates)
{
    num P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, Q[2] = {P[0], P[1]}, M[4];
    struct G(half) b = G(free_half)(T, "b");
    struct G(turn) delta = G(turn_of)(b), full = G(turn_of)(G(sum_of)(b, b));
    num X = P[0], Y = div(sub(P[1], mul(P[0], delta.sin)), delta.cos);
    about(T, "y from the new coordinates");
    same(T, add(mul(X, delta.sin), mul(Y, delta.cos)), P[1]);
    G(second_step)(mul(from_int(fault(T, 2, 1)), delta.sin), M);
    G(steps)(1, M, Q);
    about(T, "the coordinates after a step");
    same(T, Q[0], sub(mul(X, full.cos), mul(Y, full.sin)));
    same(T, div(sub(Q[1], mul(Q[0], delta.sin)), delta.cos), add(mul(X, full.sin), mul(Y, full.cos)));
}

#if RATIONAL
/*
:::{claim} second_step_of_two_has_no_angle
:title: With the step 2 a point has no angle and radius
:zh: 步长为二时点不能如此表示
:kind: counterexample
:given: $\varepsilon=2\sin\frac{\Delta\theta}2$ and a point $P_0=(x,y)$
:data: ε = 2; P_0 = (1,0)
:instead: ε = 1
:then: for $x=r\cos\theta$, $y=r\sin(\theta+\frac{\Delta\theta}2)$ the form $x^2+y^2-\varepsilon xy$ would be
  $r^2\cos^2\frac{\Delta\theta}2=0$ for every $r$, and it is not 0
:result: cos²(Δθ/2) = 0; x² + y² - εxy = 1
:method: Both numbers, exactly; that some $r^2$ times the first is the second is refuted.
:control: a step for which there is such an $r$
:::
*/
CLAIM(second_step_of_two_has_no_angle)
{
    num P[2], epsilon = given(T, "ε");
    given_points(T, "P_0", 1, 2, P);
    num square = sub(from_int(1), div(mul(epsilon, epsilon), from_int(4))); /* cos²(Δθ/2) = 1 - ε²/4 */
    num form = sub(G(norm_squared)(2, P), mul(epsilon, mul(P[0], P[1])));
    found(T, "cos²(Δθ/2)", square);
    found(T, "x² + y² - εxy", form);
    about(T, "whether x² + y² - εxy is cos²(Δθ/2) times some r²");
    agree(T, is_zero_q(form) || sign_q(square) * sign_q(form) > 0);
}
#endif

/*
When the angle is eliminated an equation remains, and it is that of an ellipse with its axes on the diagonals.  More can
be said than that the points of one orbit are on it: the quadratic form on its left is invariant under the step,
whatever the first point is, so every orbit has its own ellipse of the same shape.

:::{statement} hu-1987:1-3-ellipse
:title: The equation of the ellipse
:zh: 椭圆方程
:printed: The difference equations of the second way, without $\theta$ and with $x$, $y$ for $x_{n+1}$, $y_{n+1}$, become the equation of an ellipse, $\frac{x^2}{(r\cos\frac{\Delta\theta}2)^2}+\frac{y^2}{(r\cos\frac{\Delta\theta}2)^2}-\frac{2\sin\frac{\Delta\theta}2}{(r\cos\frac{\Delta\theta}2)^2}\,xy=1$
:holds-by: second_orbit_satisfies_the_printed_equation second_form_is_invariant second_form_is_an_ellipse
:figure: ellipse_of_the_second_way
:::

:::{claim} second_orbit_satisfies_the_printed_equation
:title: The points of the difference equations are on the printed ellipse
:zh: 差分方程的点满足椭圆方程
:given: any radius $r>0$ and angle $\theta$, and $\delta=\frac{\Delta\theta}2$ with $\cos\delta\ne0$, by the directions $(a_0,a_1)\ne(0,0)$ and
  $(b_0,b_1)\ne(0,0)$ of the halves of $\theta$ and $\delta$
:scope: 0 < Δθ < π
:harmless: $\cos\delta\ne0$, by the directions $(a_0,a_1)\ne(0,0)$ and $(b_0,b_1)\ne(0,0)$ | the cosine is not 0 for $0<\Delta\theta<\pi$, and the half of every angle has a direction
:then: $x=r\cos\theta$, $y=r\sin(\theta+\delta)$ satisfy the printed equation
:method: An identity in the five numbers, term by term as printed.
:over: a#: θ; b#: -; r: radius
:control: the factor 2 of the product $xy$ left out
:::
*/
CLAIM(second_orbit_satisfies_the_printed_equation)
{
    struct G(half) a = G(free_half)(T, "a"), b = G(free_half)(T, "b");
    struct G(turn) theta = G(turn_of)(a), delta = G(turn_of)(b), shifted = G(turn_of)(G(sum_of)(a, b));
    num r = positive(T, "r", 0);
    num x = mul(r, theta.cos), y = mul(r, shifted.sin), below = mul(r, delta.cos);
    num square = mul(below, below), factor = mul(from_int(fault(T, 2, 1)), delta.sin);
    num left = sub(add(div(mul(x, x), square), div(mul(y, y), square)), mul(div(factor, square), mul(x, y)));
    /* x²/(r cos δ)² + y²/(r cos δ)² - 2 sin δ/(r cos δ)² xy = 1,  δ = Δθ/2 */
    same(T, left, from_int(1));
}

/*
:::{claim} second_form_is_invariant
:title: A quadratic form is the same along the orbit
:zh: 不变二次型
:given: any point $P_n$, any $\varepsilon$; the step of the second way, $x_{n+1}=x_n-\varepsilon y_n$, $y_{n+1}=y_n+\varepsilon x_{n+1}$
:then: $x_{n+1}^2+y_{n+1}^2-\varepsilon x_{n+1}y_{n+1}=x_n^2+y_n^2-\varepsilon x_ny_n$; so it is the same for all $n$
:method: One step, with the point and $\varepsilon$ variables; then induction.
:scope: every number of steps
:over: x y: point; e: ε
:control: the form $x^2+y^2$
:::
*/
CLAIM(second_form_is_invariant)
{
    num P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, Q[2] = {P[0], P[1]}, epsilon = unknown(T, "e", 0), M[4];
    num mixed = fault(T, epsilon, from_int(0));
    G(second_step)(epsilon, M);
    G(steps)(1, M, Q);
    /* x_{n+1}² + y_{n+1}² - ε x_{n+1} y_{n+1} = x_n² + y_n² - ε x_n y_n */
    same(T, sub(G(norm_squared)(2, Q), mul(mixed, mul(Q[0], Q[1]))),
         sub(G(norm_squared)(2, P), mul(mixed, mul(P[0], P[1]))));
}

/*
:::{claim} second_form_is_an_ellipse
:title: The invariant form is positive: the curve is an ellipse with its axes on the diagonals
:zh: 不变二次型正定
:given: $0<s<1$, $s=\frac\varepsilon2$
:then: $x^2+y^2-2sxy=\frac{1-s}2(x+y)^2+\frac{1+s}2(x-y)^2$, both coefficients positive
:method: An identity in $s$, $x$, $y$; $s=\frac\sigma{1+\sigma}$ with $\sigma>0$ for the signs.
:scope: 0 < Δθ < π
:harmless: $0<s<1$ | it is $0<\Delta\theta<\pi$, $s=\sin\frac{\Delta\theta}2$
:over: x y: point; s: -
:control: $1-s$ and $1+s$ exchanged
:::
*/
CLAIM(second_form_is_an_ellipse)
{
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), s = inside(T, "s"), one = from_int(1);
    num plus = G(power)(add(x, y), 2), minus = G(power)(sub(x, y), 2);
    num low = mul(from_ratio(1, 2), sub(one, s)), high = mul(from_ratio(1, 2), add(one, s));
    num form = sub(add(mul(x, x), mul(y, y)), mul(mul(from_int(2), s), mul(x, y)));
    /* x² + y² - 2s xy = (1 - s)/2 (x + y)² + (1 + s)/2 (x - y)² */
    same(T, form, fault(T, add(mul(low, plus), mul(high, minus)), add(mul(high, plus), mul(low, minus))));
    G(must_be_positive)(T, low);
    G(must_be_positive)(T, high);
}

/*
## How far the ellipse is from the circle

An error needs a direction.  The ellipse leaves the circle outwards on one diagonal and inwards on the other, and the
two deviations are not equal; the formula that is printed is the outward one, which is the smaller.  The difference is
of second order, and both are half the sine to first order.

:::{statement} hu-1987:1-3-error
:title: The error of the ellipse
:zh: 椭圆与圆的误差公式
:printed: If $\varepsilon=2^{-m}=2\sin\frac{\Delta\theta}2$, then $E=\Bigl(\cos\frac{\Delta\theta}2\Big/\sqrt{1-\sin\frac{\Delta\theta}2}-1\Bigr)\times100(\%)$ is the error between the ellipse
  and the exact circle.
:holds-by: ellipse_lies_between_two_circles
:confirmed-by: inward_error_of_the_ellipse_is_larger
:meant: the formula itself, in which $\cos\frac{\Delta\theta}2\big/\sqrt{1-\sin\frac{\Delta\theta}2}$ is the largest radius of the ellipse over $r$ | The
  error is counted outwards, relative to the radius $r$ of the circle.
:reading: ellipse_lies_between_two_circles | the error is the largest distance outwards
:reading: ellipse_leaves_the_circle_by_more | the error is the largest distance of all, outwards or inwards
:figure: ellipse_of_the_second_way

With $s=\sin\frac{\Delta\theta}2$ the ellipse is between the radii $r\sqrt{1-s}$ and $r\sqrt{1+s}$.  Inwards the error is $1-\sqrt{1-s}$, and for every $s$
of $(0,1)$ this is larger than $\sqrt{1+s}-1$, the printed one: `inward_error_of_the_ellipse_is_larger`.
:::

:::{claim} ellipse_lies_between_two_circles
:title: The largest and the smallest radius of the ellipse
:zh: 椭圆的最大与最小半径
:given: $s=\sin\frac{\Delta\theta}2$, $c^2=1-s^2$, $0<s<1$, any point on $x^2+y^2-2sxy=r^2c^2$
:then: $r^2(1+s)-(x^2+y^2)=\frac s{1-s}(x-y)^2$ and $(x^2+y^2)-r^2(1-s)=\frac s{1+s}(x+y)^2$; so the radius is between
  $r\sqrt{1-s}$ and $r\sqrt{1+s}$, both reached, on the diagonals, and $\frac{c^2}{1-s}=1+s$ makes $E=\sqrt{1+s}-1$
:method: $r^2$ is eliminated by the equation; identities in $s$, $x$, $y$; the two factors $\frac s{1-s}$ and $\frac s{1+s}$ are positive, with
  $s=\frac\sigma{1+\sigma}$, $\sigma>0$.
:scope: 0 < Δθ < π
:harmless: $0<s<1$ | it is $0<\Delta\theta<\pi$, $s=\sin\frac{\Delta\theta}2$
:over: x y: point; s: -
:control: the two circles exchanged
:::
*/
CLAIM(ellipse_lies_between_two_circles)
{
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), s = inside(T, "s"), one = from_int(1);
    num high = add(one, s), low = sub(one, s), cc = sub(one, mul(s, s)), radius = add(mul(x, x), mul(y, y));
    num rr = div(sub(radius, mul(mul(from_int(2), s), mul(x, y))), cc);
    num outer = fault(T, high, low), inner = fault(T, low, high);
    /* r² (1 + s) - (x² + y²) = s/(1 - s) (x - y)²,   (x² + y²) - r² (1 - s) = s/(1 + s) (x + y)² */
    same(T, sub(mul(rr, outer), radius), mul(div(s, low), G(power)(sub(x, y), 2)));
    same(T, sub(radius, mul(rr, inner)), mul(div(s, high), G(power)(add(x, y), 2)));
    about(T, "the two factors");
    G(must_be_positive)(T, div(s, low));
    G(must_be_positive)(T, div(s, high));
    about(T, "the square of 1 + E");
    same(T, div(cc, low), high);
}

/* The square of 1 + E with the printed E, the quotient of cos(Δθ/2) and √(1 - sin(Δθ/2)), for s = sin(Δθ/2), 0 < s < 1:
 *     (1 - s^2)/(1 - s) */
static num G(square_of_the_quotient)(num s)
{
    num one = from_int(1);
    return div(sub(one, mul(s, s)), sub(one, s));
}

/* (1 + k)^2 - square */
static num G(square_above)(num k, num square) { return sub(G(power)(add(from_int(1), k), 2), square); }

/*
:::{claim} inward_error_of_the_ellipse_is_larger
:title: The ellipse leaves the circle farther inwards than outwards
:zh: 向内误差大于向外误差
:given: $0<s<1$; the printed $E=\frac c{\sqrt{1-s}}-1$ with $s=\sin\frac{\Delta\theta}2$, $c=\cos\frac{\Delta\theta}2$
:then: $E<\frac s2<1-\sqrt{1-s}$
:method: $(1+\frac s2)^2-\frac{1-s^2}{1-s}$ and $(1-\frac s2)^2-(1-s)$ are both $\frac{s^2}4$, and positive.
:scope: 0 < Δθ < π
:harmless: $0<s<1$ | it is $0<\Delta\theta<\pi$, $s=\sin\frac{\Delta\theta}2$
:over: s: -
:control: $\frac s4$ in the place of $\frac s2$
:::
*/
CLAIM(inward_error_of_the_ellipse_is_larger)
{
    num s = inside(T, "s"), half = mul(from_ratio(1, fault(T, 2, 4)), s), gap = mul(from_ratio(1, 4), mul(s, s));
    same(T, G(square_above)(half, G(square_of_the_quotient)(s)), gap);
    same(T, G(square_above)(neg(half), sub(from_int(1), s)), gap);
    G(must_be_positive)(T, gap);
}

#if RATIONAL
/*
:::{claim} ellipse_leaves_the_circle_by_more
:title: Inwards the ellipse leaves the circle by more than the printed error
:zh: 椭圆向内偏离大于印刷的误差
:kind: counterexample
:given: $s=\sin\frac{\Delta\theta}2$, as in the source's example; in units of $r$, $\sqrt{1+s}-1$ is the printed error, which is that outwards, and $1-\sqrt{1-s}$
  the one inwards; $a=1+s$
:data: s = 1/32
:instead: s = 0
:then: $1-\sqrt{1-s}\le\sqrt{1+s}-1$ is false: it says $2-\sqrt a\le\sqrt{2-a}$, with both sides positive, and squared twice this is $(1+a)^2-2\cdot2a\le0$; so
  the error inwards is the larger one
:result: (1 + a)² - 4a = 1/1024
:method: It says $2-\sqrt a\le\sqrt{2-a}$; both sides are positive, and squaring twice it becomes $(1-a)^2\le0$.
:control: the circle
:::
*/
CLAIM(ellipse_leaves_the_circle_by_more)
{
    num a = add(from_int(1), given(T, "s")), once = add(from_int(1), a);
    /* 2 - √a <= √(2-a)  squared:  1 + a <= 2 √a;  squared again:  (1 + a)^2 - 4a = (1 - a)^2 <= 0 */
    num gap = sub(mul(once, once), mul(from_int(4), a));
    found(T, "(1 + a)² - 4a", gap);
    about(T, "whether the inward error is at most the outward one");
    agree(T, sign_q(gap) <= 0);
}

/*
The next line of the source halves nothing where it should.  From $\sqrt{1+s}\approx1+\frac s2$ and $s=2^{-m-1}$ one has
to divide by 2 once more.  The example that follows is right, so the slip is one of the exponent, and one sees it by
putting in the example's $m$.

:::{statement} hu-1987:1-3-error-approximation
:title: The error is about the reciprocal of a power of two
:zh: 误差的近似值
:printed: For $\varepsilon=2^{-m}=2\sin\frac{\Delta\theta}2$: $E=\Bigl(\cos\frac{\Delta\theta}2\Big/\sqrt{1-\sin\frac{\Delta\theta}2}-1\Bigr)\times100(\%)\approx\frac1{2^{m+1}}\times100(\%)$.
:refuted-by: printed_error_is_twice_the_error
:class: misprint
:corrected: $E\approx\frac1{2^{m+2}}\times100(\%)$; more exactly, and without the per cent, $\frac s2-\frac{s^2}8<E<\frac s2$ with
  $s=2^{-m-1}$
:corrected-by: error_is_half_the_sine
:figure: error_of_the_second_way
:striking: 41

The source's own example, $m=4$, is that of the corrected exponent.
:::
*/

/*
:::{claim} printed_error_is_twice_the_error
:title: For m = 4 the printed approximation is about twice the error
:zh: 近似式给出两倍的误差
:kind: counterexample
:given: the $m$ of the source's example, $s=\sin\frac{\Delta\theta}2=2^{-m-1}$, $c=\cos\frac{\Delta\theta}2$
:data: m = 4
:then: in per cent, rounded to one decimal, the printed $2^{-(m+1)}$ is not the printed $E=\frac c{\sqrt{1-s}}-1$, but about twice as much
:result: 2^-(m+1) = "3.1 %"; E = "1.6 %"
:method: A number is rounded to $k$ tenths of a per cent when it is between the numbers half a tenth below and above, which is decided for
  $E$ after squaring, with $c^2=1-s^2$.
:control: $2^{-(m+2)}$
:::
*/
/* The border between k and k + 1 tenths of a per cent: (k + 1/2)/1000. */
static num border_above(int k) { return from_ratio(2 * k + 1, 2000); }

/* x >= 0 in tenths of a per cent, rounded. */
static int in_tenths(num x)
{
    int k = 0;
    while (compare_q(x, border_above(k)) >= 0)
        k++;
    return k;
}

/* sqrt(a) - 1 in tenths of a per cent, rounded; a >= 1. */
static int excess_of_root_in_tenths(num a)
{
    int k = 0;
    while (compare_q(a, G(power)(add(from_int(1), border_above(k)), 2)) >= 0)
        k++;
    return k;
}

/* The number of tenths of a per cent is the result of that name. */
static void found_percent(trial *T, const char *name, int tenths)
{
    char text[32];
    snprintf(text, sizeof text, "%d.%d %%", tenths / 10, tenths % 10);
    found_text(T, name, text);
}

CLAIM(printed_error_is_twice_the_error)
{
    int m = given_whole(T, "m");
    num s = from_ratio(1, 1L << (m + 1));
    int printed = in_tenths(fault(T, from_ratio(1, 1L << (m + 2)), s));
    int error = excess_of_root_in_tenths(G(square_of_the_quotient)(s));
    found_percent(T, "2^-(m+1)", printed);
    found_percent(T, "E", error);
    about(T, "tenths of a per cent");
    same(T, from_int(printed), from_int(error));
}
#endif

/*
:::{claim} error_is_half_the_sine
:title: The error is half the sine, to second order
:zh: 误差的二阶估计
:given: $0<s<1$; the printed $E=\frac c{\sqrt{1-s}}-1$ with $s=\sin\frac{\Delta\theta}2$, $c=\cos\frac{\Delta\theta}2$
:then: $\frac s2-\frac{s^2}8<E<\frac s2$; for $s=2^{-m-1}$ the upper bound is $2^{-m-2}$
:method: With $(1+E)^2=\frac{1-s^2}{1-s}$, $(1+\frac s2)^2-(1+E)^2=\frac{s^2}4$ and $(1+E)^2-(1+\frac s2-\frac{s^2}8)^2=\frac{s^3(8-s)}{64}$; both positive.
:scope: 0 < Δθ < π
:harmless: $0<s<1$ | it is $0<\Delta\theta<\pi$, $s=\sin\frac{\Delta\theta}2$
:over: s: -
:control: $\frac{s^2}{16}$ in the place of $\frac{s^2}8$
:::
*/
CLAIM(error_is_half_the_sine)
{
    num s = inside(T, "s"), half = mul(from_ratio(1, 2), s), ss = mul(s, s);
    num lower = sub(half, mul(from_ratio(1, fault(T, 8, 16)), ss));
    num below = div(mul(mul(s, ss), sub(from_int(8), s)), from_int(64)), above = mul(from_ratio(1, 4), ss);
    num square = G(square_of_the_quotient)(s);
    same(T, G(square_above)(half, square), above);
    same(T, neg(G(square_above)(lower, square)), below);
    G(must_be_positive)(T, above);
    G(must_be_positive)(T, below);
}

/*
:::{statement} hu-1987:1-3-error-example
:title: The error for m = 4
:zh: m=4 时的误差
:printed: For $m=4$, $E=1.6\%$.
:holds-by: error_for_four_is_as_printed
:figure: error_of_the_second_way

It is the error itself; by the approximation before it, `1-3-error-approximation`, it would be $\frac1{32}$, which is 3.1 %.
:::
*/

#if RATIONAL
/*
:::{claim} error_for_four_is_as_printed
:title: The error for m = 4 is the printed one, to its digits
:zh: m=4 时误差与印刷数值一致
:kind: decision
:given: the $m$ of the source, $s=\sin\frac{\Delta\theta}2=2^{-m-1}$, $c=\cos\frac{\Delta\theta}2$, and the printed error $p$ in per cent, with half a unit $h$ of its last digit
:data: m = 4; p = 1.6; h = 0.05
:instead: m = 3
:then: the printed $E=\frac c{\sqrt{1-s}}-1$ is between $p-h$ and $p+h$ per cent, and inwards $1-\sqrt{1-s}$ is so as well
:result: s = 1/32
:method: The four comparisons after squaring, with $c^2=1-s^2$, in rationals.
:control: a longer step
:::
*/
/* lo < sqrt(a) < hi for positive lo */
static int root_is_between(num lo, num a, num hi)
{
    return compare_q(mul(lo, lo), a) < 0 && compare_q(a, mul(hi, hi)) < 0;
}

CLAIM(error_for_four_is_as_printed)
{
    num s = from_ratio(1, 1L << (given_whole(T, "m") + 1)), p = given(T, "p"), h = given(T, "h");
    num one = from_int(1), percent = from_ratio(1, 100), low = mul(percent, sub(p, h)), high = mul(percent, add(p, h));
    found(T, "s", s);
    agree(T, root_is_between(add(one, low), G(square_of_the_quotient)(s), add(one, high)));
    agree(T, root_is_between(sub(one, high), sub(one, s), sub(one, low)));
}
#endif

/*
## Does the second way close?

The source says only of the first way that it does not close.  The ellipse of the second way is a closed curve, and the
points stay on it for ever; but from any first point except the origin they never come back to where they were.
*/

#if RATIONAL
/*
:::{claim} second_orbit_never_closes
:title: The orbit of the second way never returns to its first point
:zh: 第二种方法的点列永不重复
:kind: decision
:given: $\varepsilon=2^{-m}$, $m=1,\dots,M$; traces $V_k$ of $T^k$ for $k=1,\dots,K$, $V_{k+1}=(2-\varepsilon^2)V_k-V_{k-1}$, $V_0=2$; a first point $P_0\ne(0,0)$
:where: $P_0\ne(0,0)$
:data: M = 6; K = 48
:then: $2^{2mk}V_k$ is an odd integer; so $V_k\ne2$.  A point that returned after $k$ steps would belong to
  the eigenvalue 1 of $T^k$; the other one would be 1, too, because $\det T=1$, and their sum $V_k$ would be 2
:method: The traces by the recursion, exactly.
:argued: every m and k | $V_k$ is a polynomial in $2-\varepsilon^2$ of degree $k$ with whole coefficients and leading coefficient 1, and
  $2-\varepsilon^2=(2^{2m+1}-1)/2^{2m}$ is in lowest terms, so $2^{2mk}V_k$ is odd.
:scope: m = 1 to 6, k = 1 to 48 steps
:control: $\varepsilon=1$, where $V_6=2$
:::
*/
/* 2^bits V is an odd integer. */
static int has_exactly_the_bits(num V, int bits)
{
    num scaled = mul(G(power)(from_int(2), bits), V);
    return is_whole_q(scaled) && !is_whole_q(mul(from_ratio(1, 2), scaled));
}

CLAIM(second_orbit_never_closes)
{
    int largest = given_whole(T, "M"), steps = given_whole(T, "K");
    for (int m = 1; m <= largest; m++) {
        num M[4], before = from_int(2);
        G(second_step)(fault(T, from_ratio(1, 1L << m), from_int(1)), M);
        num trace = add(M[0], M[3]), V = trace;
        for (int k = 1; k <= steps; k++) {
            agree(T, has_exactly_the_bits(V, fault(T, 2 * m * k, 0)));
            agree(T, !equal_q(V, from_int(2)));
            num next = sub(mul(trace, V), before); /* V_{k+1} = (2 - ε²) V_k - V_{k-1} */
            before = V, V = next;
        }
    }
}
#endif

/*
:::{claim} second_step_of_one_closes_after_six
:title: With the step 1 the second way closes after six points
:zh: 步长为一时六步闭合
:given: any first point, $\varepsilon$, and an even number $n$ of steps
:data: ε = 1; n = 6
:instead: n = 5
:then: $P_n=P_0$, and $P_{n/2}=-P_0$
:method: All steps with variable $P_0$.
:over: x y: first point
:control: one step less
:::
*/
CLAIM(second_step_of_one_closes_after_six)
{
    num M[4], P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, Q[2] = {P[0], P[1]};
    G(second_step)(given(T, "ε"), M);
    int n = given_whole(T, "n");
    G(steps)(n / 2, M, Q);
    for (int j = 0; j < 2; j++)
        same(T, Q[j], neg(P[j]));
    G(steps)(n - n / 2, M, Q);
    for (int j = 0; j < 2; j++)
        same(T, Q[j], P[j]);
}

#include "chapters/judge/claims_off.h"
