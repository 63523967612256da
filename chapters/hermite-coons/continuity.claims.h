/*
# What is continuous at a joint (参数连续性与几何连续性)

Two pieces meet.  They are called $C^k$ when their derivatives agree at the joint, $G^k$ when those by the arc length do.  The
first is a property of the parametrization, the second of the figure, and the slides explain the second by derivatives that are
proportional.  For the tangent this is nearly right; for the curvature it is wrong in every way to read it.
*/
#include "chapters/hermite-coons/definition.h"

#if RATIONAL
#include "exact/record/polynomial.h"
#endif

#include "chapters/judge/claims_on.h"

enum { plane = 2 };

/*
## Continuous derivatives (参数连续性)

The definition is given for functions at a point $x_0$, by derivatives from the left and from the right.  For polynomials, to which the
slides apply it, there is no difficulty.  As a definition it has two gaps, and in each gap lives a function: one that has the derivatives without their
being continuous, one that has their limits without being continuous itself.

:::{statement} slides-ch4:1-ck-definition
:title: Equal derivatives from the left and from the right
:zh: 参数连续性 C^k 的定义
:printed: A function that has equal left and right derivatives at $x_0$ up to the order $k$ is called $k$ times continuously differentiable
  at $x_0$, or continuous of order $k$, $C^k$.
:holds-by: a_factor_raises_the_order_of_a_zero
:confirmed-by: equal_derivatives_leave_a_power
:argued: | On either side $f,f',\dots,f^{(k)}$ tend to their values at $x_0$.  Where the left and the right derivatives are equal there is one derivative, order
  by order, and it tends to one value from both sides, so that it is continuous at $x_0$.  The claim says which polynomials are joined so: those whose
  difference has the factor $(x-x_0)^{k+1}$.
:hypothesis: equal_derivatives_are_not_continuous | on either side the function has $k$ continuous derivatives up to $x_0$; as
  pieces that are polynomials have
:meant: the class $C^0$ of the next sentence, which has no other order | The order 0 is among the orders up to $k$: the values are counted as the derivatives of order 0.
:reading: a_factor_raises_the_order_of_a_zero | the orders $0,1,\dots,k$, the values being those of the order 0 | One derivative from both sides, order by order, to which both sides tend, is
  continuous at $x_0$.
:reading: equal_limits_do_not_make_a_continuous_function | the orders $1,\dots,k$ alone, by limits of $f',\dots,f^{(k)}$ from either side
:figure: differentiable_without_continuity

By difference quotients from either side the condition says that $f$ is differentiable at $x_0$, and not that $f'$ is continuous there;
by limits of $f',\dots,f^{(k)}$ from either side it does not even say that $f$ is continuous.
:::
*/

#if RATIONAL
/*
:::{claim} equal_derivatives_are_not_continuous
:title: A function with equal derivatives from both sides whose derivative is not continuous
:zh: 左右导数相等而导函数不连续
:kind: counterexample
:data: n = 1000; slope = 1; bound = 1/2
:instead: slope = 1/1000
:result: f(x)/x at most = 1/3000; f'(1/n) = 1
:given: $f(0)=0$, $f(-x)=f(x)$, and on $[\frac1{n+1},\frac1n]$, for every $n\ge1$, the Hermite cubic with the values 0 and the slopes
  $(-1)^{n+1}s$ and $(-1)^ns$ at its ends, where $s$ is the given slope; one even $n$, and a bound
:then: $f'(0)=0$ from both sides, as $\frac{f(x)}x$ tends to 0 with $x$; and for the given even $n$ the derivative $f'(\frac1n)$ is not near $f'(0)$
:method: With $h=\frac1{n(n+1)}$ and $s\le1$ the inner Bézier ordinates of a piece have at most the size $d$, a third of $h$, hence $|f|\le d$ and
  $\bigl|\frac{f(x)}x\bigr|\le d\,(n+1)$, a third of $\frac1n$, which tends to 0.  Computed for one even $n$: the bound of the quotient,
  and the derivative at $\frac1n$; that it differs from $f'(0)=0$ by no more than the given bound is refuted.
:control: slopes of the size $\frac1n$
:::
*/
CLAIM(equal_derivatives_are_not_continuous)
{
    num zero = from_int(0), half = from_ratio(1, 2), three = from_int(3), value, by_bezier, D[2];
    num n = from_int(given_whole(T, "n")), slope = given(T, "slope"), bound = given(T, "bound"); /* n is even */
    num right = div(from_int(1), n), left = div(from_int(1), add(n, from_int(1))), length = sub(right, left);
    num data[4] = {zero, zero, neg(slope), slope};
    hermite_cubic_q(1, left, right, data, right, 1, D);
    num ordinates[4] = {zero, mul(div(length, three), data[2]), neg(mul(div(length, three), data[3])), zero};
    hermite_cubic_q(1, left, right, data, add(left, mul(half, length)), 0, &value);
    bezier_casteljau_q(3, 1, ordinates, half, &by_bezier);
    about(T, "the piece by its Bézier ordinates");
    same(T, value, by_bezier);
    num quotient = div(div(length, three), left);
    found(T, "f(x)/x at most", quotient);
    about(T, "the bound is a third of 1/n");
    same(T, mul(three, quotient), right);
    for (int i = 1; i <= 2; i++) {
        num size = sign_q(ordinates[i]) < 0 ? neg(ordinates[i]) : ordinates[i];
        nonnegative(T, sub(quotient, div(size, left)));
    }
    found(T, "f'(1/n)", D[1]);
    about(T, "whether f'(1/n) is near f'(0) = 0");
    agree(T, compare_q(D[1], bound) <= 0);
}

/*
:::{claim} equal_limits_do_not_make_a_continuous_function
:title: Derivatives with one limit from both sides, and a jump
:zh: 导数左右极限相等而函数间断
:kind: counterexample
:data: values = 0 1; k = 3
:instead: values = 0 0
:given: a function that has the first of two constant values to the left of $x=0$ and the second from there on; the orders $1,\dots,k$
:then: the derivatives of these orders have one limit from both sides, and the values differ
:method: Both pieces as polynomials, values and derivatives at 0 up to the order $k$.
:control: one value everywhere
:::
*/
CLAIM(equal_limits_do_not_make_a_continuous_function)
{
    num values[2], zero = from_int(0);
    given_points(T, "values", 2, 1, values);
    struct G(poly) left = G(constant)(values[0]), right = G(constant)(values[1]);
    int k = given_whole(T, "k");
    about(T, "the derivatives at 0");
    for (int j = 1; j <= k; j++)
        same(T, G(at)(left, j, zero), G(at)(right, j, zero));
    about(T, "the values at 0");
    same(T, G(at)(left, 0, zero), G(at)(right, 0, zero));
}
#endif

/*
:::{claim} a_factor_raises_the_order_of_a_zero
:title: A factor x - x0 shifts the derivatives at x0 by one order, in every order
:zh: 乘以 x-x0 使导数升高一阶(任意阶)
:given: any function $s$, any $j\ge1$, any $x$ and $x_0$, $h=x-x_0$; the derivatives $s^{(j-1)},s^{(j)},s^{(j+1)}$ at $x$, any numbers
:then: the derivative of $h\,s^{(j)}+j\,s^{(j-1)}$ is $h\,s^{(j+1)}+(j+1)\,s^{(j)}$; so $(hs)^{(j)}=h\,s^{(j)}+j\,s^{(j-1)}$ for every $j$, and
  $j\,s^{(j-1)}(x_0)$ at $x_0$
:method: A value and its derivative are one number $v+v'\epsilon$ with $\epsilon^2=0$; one step, then induction over $j$.  Hence if the derivatives of $s$ at $x_0$
  are 0 below the order $k$, and $k!\,r(x_0)$ in the order $k$, those of $hs$ are 0 below the order $k+1$, and $(k+1)!\,r(x_0)$ there: so it is for
  $(x-x_0)^{k+1}r(x)$, by induction over $k$, and $p$ and $p+(x-x_0)^{k+1}r$ have the same derivatives at $x_0$ up to the order $k$.  By Taylor's
  formula every polynomial with these equalities is of this form.
:scope: every order
:over: s# j: -; x#: points
:control: the factor $j$ in the place of $j+1$
:::
*/
CLAIM(a_factor_raises_the_order_of_a_zero)
{
    num j = whole(T, "j", 1, 12), one = from_int(1), h = sub(unknown(T, "x", 1), unknown(T, "x", 0));
    num s[3] = {unknown(T, "s", 0), unknown(T, "s", 1), unknown(T, "s", 2)}; /* of the orders j-1, j, j+1 */
    /* (h + eps)(s_j + s_{j+1} eps) + j (s_{j-1} + s_j eps): the part with eps */
    num product = add(mul(one, s[1]), mul(h, s[2])), derivative = add(product, mul(j, s[1]));
    about(T, "the next derivative");
    same(T, derivative, add(mul(h, s[2]), mul(fault(T, add(j, one), j), s[1])));
}

/*
:::{claim} equal_derivatives_leave_a_power
:title: Polynomials with the same derivatives up to order k differ by a multiple of the next power
:zh: 左右 k 阶导数相等的充要条件
:given: any polynomial $p$ of degree 7, any $x_0$, any $r$ of degree 2, any numbers $d_0,\dots,d_k$;
  $q(x)=p(x)+\sum_{j\le k}d_j(x-x_0)^j+(x-x_0)^{k+1}r(x)$
:scope: polynomials of degree 7
:then: $q^{(j)}(x_0)-p^{(j)}(x_0)=j!\,d_j$ for $j\le k$, so that the derivatives up to the order $k$ are the same exactly when all $d_j$ are 0, and
  $q^{(k+1)}(x_0)-p^{(k+1)}(x_0)=(k+1)!\,r(x_0)$
:method: $q$ is multiplied out in powers of $x$; everything a variable.  Every polynomial of degree at most $k+3$ is such a sum in powers of $x-x_0$.
:degrees: order k = 0..4 sampled 8
:over: p# r# d#: coefficients; x: x₀
:control: the exponent $k$ beside $r$
:::
*/
CLAIM(equal_derivatives_leave_a_power)
{
    int k = T->degree;
    num x0 = unknown(T, "x", 0), factorial = from_int(1);
    struct G(poly) p = G(free_poly)(T, "p", 7), r = G(free_poly)(T, "r", 2);
    struct G(poly) gap = {1, {neg(x0), from_int(1)}}, product = r;
    for (int j = 0; j < fault(T, k + 1, k); j++)
        product = G(times)(product, gap);
    /* d_k, d_{k-1} + d_k (x - x_0), ... */
    struct G(poly) d = G(free_poly)(T, "d", k), low = G(constant)(d.c[k]);
    for (int j = k - 1; j >= 0; j--)
        low = G(plus)(G(times)(low, gap), G(constant)(d.c[j]));
    struct G(poly) q = G(plus)(p, G(plus)(low, product));
    about(T, "the derivatives up to order k");
    for (int j = 0; j <= k; j++) {
        same(T, sub(G(at)(q, j, x0), G(at)(p, j, x0)), mul(factorial, d.c[j]));
        factorial = mul(factorial, from_int(j + 1));
    }
    about(T, "the derivative of order k + 1");
    same(T, sub(G(at)(q, k + 1, x0), G(at)(p, k + 1, x0)), mul(factorial, G(at)(r, 0, x0)));
}

/*
What does the figure show of this?  For a graph, the slope is $f'$ and the curvature a formula in $f'$ and $f''$, so that smoothness of the
function is smoothness of the figure.  The way back is open only where no tangent is upright, and for a curve with a parameter there
is no way in either direction: the figure does not know how fast it is run through.

:::{statement} slides-ch4:1-ck-shape
:title: What C0, C1 and C2 mean for the figure
:zh: C0、C1、C2 的几何意义
:printed: Geometrically $C^0$, $C^1$, $C^2$ mean that the graph of the function, the direction of its tangent, its curvature are continuous.
:holds-by: curvature_of_a_graph
:argued: | The point of the graph, $(x,f)$, is continuous where $f$ is.  Slope and curvature are formed from $f'$ and $f''$ by sums, products and a
  root, divided by numbers that are not 0, and so are continuous where $f'$ and $f''$ are.
:meant: the words "of the function" (该函数的图形), and "are continuous" | From the class to the figure, for graphs.
:reading: curvature_of_a_graph | from the class to the figure, for graphs | Slope and curvature are formed from $f'$ and $f''$ by operations that keep continuity.
:reading: upright_tangent_is_continuous_and_not_c1 | from the figure to the class, for graphs
:reading: tangent_turns_back_at_a_smooth_parameter | from the class to the figure, for curves with a parameter: where $P'=0$, which graphs never have, the
  tangent may turn back
:reading: continuous_slope_with_another_speed | from the figure to the class, for curves with a parameter
:figure: upright_cube_root

A function of the class $C^1$, $C^2$ has a graph with continuous tangent, curvature: its direction is $(1,f')$, its curvature
$f''/(1+f'^2)^{3/2}$.
:::
*/

#if RATIONAL
/*
:::{claim} upright_tangent_is_continuous_and_not_c1
:title: The graph of the cube root has a continuous tangent and curvature, and the function no derivative
:zh: 立方根函数:切向与曲率连续而不可导
:kind: counterexample
:data: c = (0,0) (0,1) (0,0) (1,0); s = 1/1000; bound = 1000
:instead: s = 1/10
:result: P'(0) = (0,1); P''(0) = (0,0); f(h)/h = 1000000
:given: the cube root $f$, and its graph $P(s)=\sum_kc_ks^k=(s^3,s)$, which is at $h=s^3$ for the parameter $s$ and at the origin for $s=0$; a bound
:then: the graph has at the origin a derivative that is not 0, hence the curvature $\frac{P'\times P''}{|P'|^3}$; the quotient
  $\frac{f(h)}h=\frac1{s^2}$ is more than the given bound, and so than any for a smaller $s$
:method: Derivatives of the graph by the power kernel, the quotient at the one $s$; that it is not greater than the given bound
  is refuted.
:control: a point that is not so near to the origin
:::
*/
CLAIM(upright_tangent_is_continuous_and_not_c1)
{
    num c[4 * plane], D[3 * plane], P[plane];
    given_points(T, "c", 4, plane, c);
    num s = given(T, "s"), bound = given(T, "bound");
    power_derivatives_q(3, plane, c, from_int(0), 2, D);
    found_points(T, "P'(0)", 1, plane, D + plane);
    found_points(T, "P''(0)", 1, plane, D + 2 * plane);
    about(T, "whether the curvature at the origin has a denominator");
    agree(T, !is_zero_q(D[plane + 1]));
    power_point_q(3, plane, c, s, P);
    num quotient = div(P[1], P[0]);
    found(T, "f(h)/h", quotient);
    about(T, "whether the quotient is at most the bound");
    agree(T, compare_q(quotient, bound) <= 0);
}

/*
:::{claim} tangent_turns_back_at_a_smooth_parameter
:title: A polynomial curve whose tangent turns back
:zh: 多项式曲线在尖点处切向反转
:kind: counterexample
:data: c = (0,0) (0,0) (0,1) (1,0); h = 1/1000
:instead: c = (0,0) (1,0) (0,1) (1,0)
:result: P'(-h) = (3/1000000,-1/500); P'(h) = (3/1000000,1/500); P'(-s) P'(s) = "9*s^4 - 4*s^2"
:given: the cubic $P(t)=\sum_kc_kt^k=(t^3,t^2)$, which has continuous derivatives of every order, and a small $h$
:then: $P'(-h)\cdot P'(h)<0$; at any $s$ the product $P'(-s)\cdot P'(s)$ is a polynomial in $s$ whose term of the lowest degree is negative, so that however near to the origin the
  tangents before and after make an obtuse angle
:method: The derivatives by the power kernel at $h$; that their product is not negative is refuted.  The product at every $s$ by the
  coefficients.
:control: a curve that passes the origin with the derivative $(1,0)$
:::
*/
CLAIM(tangent_turns_back_at_a_smooth_parameter)
{
    num c[4 * plane], before[2 * plane], after[2 * plane];
    given_points(T, "c", 4, plane, c);
    num h = given(T, "h");
    power_derivatives_q(3, plane, c, neg(h), 1, before);
    power_derivatives_q(3, plane, c, h, 1, after);
    found_points(T, "P'(-h)", 1, plane, before + plane);
    found_points(T, "P'(h)", 1, plane, after + plane);
    poly product = poly_constant(from_int(0));
    for (int j = 0; j < plane; j++) {
        poly forth = poly_derivative(poly_from_q(4, (num[]){c[j], c[2 + j], c[4 + j], c[6 + j]}));
        poly back = poly_compose(forth, poly_from_q(2, (num[]){from_int(0), from_int(-1)}));
        product = poly_add(product, poly_mul(forth, back));
    }
    found_text(T, "P'(-s) P'(s)", poly_to_string(product, "s"));
    num at_h = add(mul(before[2], after[2]), mul(before[3], after[3]));
    about(T, "the product at h");
    same(T, at_h, poly_value(product, h));
    about(T, "the product of the derivatives");
    nonnegative(T, at_h);
}
#endif

/*
:::{claim} curvature_of_a_graph
:title: Slope and curvature of a graph
:zh: 函数图形的切向与曲率
:given: any values $f'$ and $f''$ of a function
:then: the curve $P=(x,f)$ with the derivatives $(1,f')$, $(0,f'')$ has $P'\times P''=f''$, $|P'|^2=1+f'^2$, so the square of its curvature is
  $\frac{f''^2}{(1+f'^2)^3}$
:method: The kernels of differential geometry; everything a variable.  The denominator is positive.
:over: f#: derivatives
:control: $(1+f'^2)^2$
:::
*/
CLAIM(curvature_of_a_graph)
{
    num slope = unknown(T, "f", 1), second = unknown(T, "f", 2), one = from_int(1);
    num d1[2] = {one, slope}, d2[2] = {from_int(0), second}, speed = add(one, mul(slope, slope));
    same(T, G(cross2)(d1, d2), second);
    same(T, G(norm_squared)(plane, d1), speed);
    num below = fault(T, mul(speed, mul(speed, speed)), mul(speed, speed));
    same(T, G(curvature_squared)(plane, d1, d2), div(mul(second, second), below));
}

/*
## Continuous shape (几何连续性)

That is why a second kind of continuity is defined, by the one parameter that belongs to the figure: the arc length.

:::{statement} slides-ch4:1-gk-definition
:title: Geometric continuity by arc length
:zh: 几何连续性 G^k 的定义
:printed: Two segments are continuous of order $k$ geometrically, $G^k$, when their parametrizations by arc length are $C^k$ at the joint.
:definition: yes
:::

:::{statement} slides-ch4:1-g0
:title: G0 and C0 are the same
:zh: G0 与 C0 一致
:printed: Geometric continuity of order zero is the same as parametric continuity of order zero.
:holds-by: end_of_a_curve_has_no_parameter
:argued: every curve | The point at the end is $P(\phi(0))=P(0)$ for any function $P$.
:confirmed-by: position_has_no_parameter
:::
*/

/* P composed with phi(u) = lambda u + beta u^2. */
static struct G(poly) G(composed)(struct G(poly) p, num lambda, num beta)
{
    struct G(poly) phi = {2, {from_int(0), lambda, beta}}, sum = G(constant)(p.c[p.n]);
    for (int k = p.n - 1; k >= 0; k--)
        sum = G(plus)(G(times)(sum, phi), G(constant)(p.c[k]));
    return sum;
}

/*
:::{claim} end_of_a_curve_has_no_parameter
:title: Whatever the parameter, the end of a curve is the same point
:zh: 任意参数变换不改变端点位置
:given: any change $\phi$ of the parameter with $\phi(0)=0$, any value $\lambda$ of $\phi'(0)$; polynomials $p$, and $q$ in $u$, with one value
  at 0, and any values of the derivatives there, related by $q'(0)=\lambda p'(0)$; any $c$
:then: $u\,p+c$ and $\phi\,q+c$ have one value at $u=0$ again, and derivatives there with the factor $\lambda$
:method: A value and its derivative are one number $v+v'\epsilon$ with $\epsilon^2=0$.  A polynomial is built by such steps from its highest coefficient on, so that
  $q=p\circ\phi$ in the end: by induction $q(0)=p(\phi(0))=p(0)$ for every degree, and the derivative is kept only for $\lambda=1$ or where it is 0.
  In the values no derivative occurs, so that $\phi$ need not have one.
:degrees: all
:scope: polynomial curves; every change of the parameter
:over: p# c#: coefficients; l: -
:control: the derivative expected to be kept
:::
*/
CLAIM(end_of_a_curve_has_no_parameter)
{
    num value = unknown(T, "p", 0), slope = unknown(T, "p", 1), c = unknown(T, "c", 0), lambda = unknown(T, "l", 0);
    num zero = from_int(0), one = from_int(1);
    /* (0 + eps)(value + slope eps) + c and (0 + lambda eps)(value + lambda slope eps) + c */
    num by_t[2] = {add(mul(zero, value), c), add(mul(one, value), mul(zero, slope))};
    num by_u[2] = {add(mul(zero, value), c), add(mul(lambda, value), mul(zero, mul(lambda, slope)))};
    about(T, "the value");
    same(T, by_u[0], by_t[0]);
    about(T, "the derivative");
    same(T, by_u[1], fault(T, mul(lambda, by_t[1]), by_t[1]));
}

/*
:::{claim} position_has_no_parameter
:title: A change of the parameter that keeps the end keeps the point
:zh: 参数变换不改变端点位置
:given: a polynomial $P$ of degree $n$ with any coefficients, $\phi(u)=\lambda u+\beta u^2$
:then: $P(\phi(0))=P(0)$, and $(P\circ\phi)'(0)=\lambda P'(0)$: the value is kept for every $\phi$
:method: $P\circ\phi$ is multiplied out in powers of $u$; everything a variable.
:degrees: 1..5 sampled 8
:over: c#: coefficients; l b: parameter change
:control: the derivative expected to be kept
:::
*/
CLAIM(position_has_no_parameter)
{
    num lambda = unknown(T, "l", 0), beta = unknown(T, "b", 0), zero = from_int(0);
    struct G(poly) p = G(free_poly)(T, "c", T->degree), q = G(composed)(p, lambda, beta);
    about(T, "the value");
    same(T, G(at)(q, 0, zero), G(at)(p, 0, zero));
    about(T, "the derivative");
    num slope = G(at)(p, 1, zero);
    same(T, G(at)(q, 1, zero), fault(T, mul(lambda, slope), slope));
}

/*
For $k=1$ the arc length can be avoided.  The unit tangents agree exactly when one derivative is a positive multiple of the other,
provided that both have a direction.

:::{statement} slides-ch4:1-g1
:title: G1 by proportional first derivatives
:zh: G1:一阶导数成比例
:printed: $G^1$ means that the first derivatives of the two segments are proportional at the joint: equal in direction, different in size.
:holds-by: equal_unit_tangents_fix_the_ratio
:hypothesis: singular_end_has_no_ratio | neither derivative is 0 at the joint
:needs: negative_ratio_turns_back | the words: equal in direction (方向相同) | the derivatives are equal in direction:
  proportional with a negative factor is a curve that turns back
:meant: the word that is explained, proportional (成比例) | The sizes may differ; that the first derivatives by the arc length agree says that the unit tangents are equal.
:reading: equal_unit_tangents_fix_the_ratio | the sizes may differ
:reading: halves_of_a_segment_have_one_speed | the sizes do differ
:figure: joints_of_order
:::
*/

#if RATIONAL
/*
:::{claim} halves_of_a_segment_have_one_speed
:title: Two halves of a segment meet with equal derivatives
:zh: 线段两半在公共点处导矢相等
:kind: counterexample
:data: P = (0,0) (1,0); Q = (1,0) (2,0); length = 1
:instead: length = 1/2
:result: before = (1,0); after = (1,0)
:given: the two halves $P$ and $Q$ of a segment, each by its two end points, the first over $[0,1]$, the second over an interval of the given length
:then: the derivatives before and after the joint are equal, and both halves have one unit tangent
:method: The derivatives by the kernel, divided by the length; that the squares of their lengths differ is refuted.
:control: the second half over a shorter interval
:::
*/
CLAIM(halves_of_a_segment_have_one_speed)
{
    num P[2 * plane], Q[2 * plane], D[2 * plane], E[2 * plane];
    given_points(T, "P", 2, plane, P);
    given_points(T, "Q", 2, plane, Q);
    num length = given(T, "length");
    bezier_derivatives_q(1, plane, P, from_int(1), 1, D);
    bezier_derivatives_q(1, plane, Q, from_int(0), 1, E);
    for (int c = 0; c < plane; c++)
        E[plane + c] = div(E[plane + c], length);
    found_points(T, "before", 1, plane, D + plane);
    found_points(T, "after", 1, plane, E + plane);
    about(T, "whether the lengths of the two derivatives differ");
    refute(T, equal_q(norm_squared_q(plane, D + plane), norm_squared_q(plane, E + plane)));
}

/*
For $k=2$ it is tempting to go on in the same way, and the slides do.  Take a change of the parameter, $t=\lambda u+\beta u^2+\cdots$: by the chain rule
$Q'=\lambda P'$ and $Q''=\lambda^2P''+2\beta P'$.  So the factor of the second derivative is not free but the square of the first, and an arbitrary
part along the tangent may be added.  Each of the four readings of the printed sentence misses something of this.

:::{statement} slides-ch4:1-g2
:title: G2 by proportional first and second derivatives
:zh: G2:一、二阶导数均成比例
:printed: $G^2$ means that the first and the second derivatives of the two segments are proportional at the joint.
:refuted-by: proportional_derivatives_with_another_curvature one_factor_for_both_derivatives smooth_curve_without_proportional_derivatives proportional_derivatives_by_arc_length
:class: false
:corrected: $G^2$ means $\dot P_{\mathrm{II}}=\lambda\dot P_{\mathrm I}$ and $\ddot P_{\mathrm{II}}=\lambda^2\ddot P_{\mathrm I}+\beta\dot P_{\mathrm I}$ at the joint of the segments $P_{\mathrm I}$
  and $P_{\mathrm{II}}$, with some $\lambda>0$ and some $\beta$, $\dot P_{\mathrm I}\ne0$
:corrected-by: conditions_make_one_curve_in_another_parameter condition_keeps_the_curvature_vector curvature_vector_forces_the_condition
  second_derivative_splits_along_the_first curvature_vector_is_the_turning_of_the_tangent
:figure: proportional_derivatives
:striking: 44

The counterexamples are to four readings: two factors without relation; one factor for both; the factor of the second derivative the square of that of the
first, which is sufficient and not necessary; and derivatives by the arc length, where the first are equal and the second
proportional: the factor may be negative, or, as in the first example, whose derivatives are those by the arc length, positive and not 1.  None is what
the definition by arc length says.
:::
*/

/* Compare the squares of the curvatures of two curves with the given derivatives P', P'' and Q', Q''. */
static void compare_curvatures(trial *T)
{
    num P[2][plane], Q[2][plane];
    given_points(T, "P'", 1, plane, P[0]);
    given_points(T, "P''", 1, plane, P[1]);
    given_points(T, "Q'", 1, plane, Q[0]);
    given_points(T, "Q''", 1, plane, Q[1]);
    num before = curvature_squared_q(plane, P[0], P[1]), after = curvature_squared_q(plane, Q[0], Q[1]);
    found(T, "κ² before", before);
    found(T, "κ² after", after);
    about(T, "the squares of the curvatures");
    same(T, after, before);
}

/*
:::{claim} proportional_derivatives_with_another_curvature
:title: Two factors: the curvature jumps
:zh: 比例因子独立时曲率间断
:kind: counterexample
:data: P' = (1,0); P'' = (0,1); Q' = (1,0); Q'' = (0,3)
:instead: Q'' = (0,1)
:result: κ² before = 1; κ² after = 9
:given: derivatives of two curves at a joint with $Q'=P'$, and $Q''$ three times $P''$
:then: the curvature jumps
:method: `curvature_squared` of both.
:control: $Q''=P''$
:::
*/
CLAIM(proportional_derivatives_with_another_curvature) { compare_curvatures(T); }

/*
:::{claim} one_factor_for_both_derivatives
:title: One factor for both: the curvature jumps
:zh: 两阶导数用同一比例因子时曲率间断
:kind: counterexample
:data: P' = (1,0); P'' = (0,1); Q' = (2,0); Q'' = (0,2)
:instead: Q'' = (0,4)
:result: κ² before = 1; κ² after = 1/4
:given: derivatives of two curves at a joint with $Q'=2P'$, $Q''=2P''$
:then: the curvature jumps
:method: `curvature_squared` of both.
:control: $Q''=2^2P''$
:::
*/
CLAIM(one_factor_for_both_derivatives) { compare_curvatures(T); }

/*
:::{claim} smooth_curve_without_proportional_derivatives
:title: One parabola in two parameters: G2 without proportional second derivatives
:zh: 二阶导数不成比例而几何连续
:kind: counterexample
:data: λ = 1; β = 1/2
:instead: λ = 2; β = 0
:result: P'' = (0,1); Q'' = (1,1)
:given: $P(t)=(t,\frac{t^2}2)$ up to $t=0$ and from there $Q(u)=P(\lambda u+\beta u^2)$, the same parabola
:then: $P''$ and $Q''$ are not proportional, with whatever factor; the curve is a piece of one parabola
:method: $Q$ as a polynomial in $u$ by its coefficients, which satisfies $2y=x^2$; the determinant of the second derivatives should vanish.
:control: $\beta=0$
:::
*/
CLAIM(smooth_curve_without_proportional_derivatives)
{
    num zero = from_int(0), one = from_int(1), lambda = given(T, "λ"), beta = given(T, "β");
    struct G(poly) x = {1, {zero, one}}, y = {2, {zero, zero, from_ratio(1, 2)}};
    struct G(poly) u = G(composed)(x, lambda, beta), v = G(composed)(y, lambda, beta), square = G(times)(u, u);
    about(T, "2y and x^2 along the second piece");
    for (int k = 0; k <= square.n; k++)
        same(T, k <= v.n ? mul(from_int(2), v.c[k]) : zero, square.c[k]);
    num before[plane] = {G(at)(x, 2, zero), G(at)(y, 2, zero)}, after[plane] = {G(at)(u, 2, zero), G(at)(v, 2, zero)};
    found_points(T, "P''", 1, plane, before);
    found_points(T, "Q''", 1, plane, after);
    about(T, "the determinant of the second derivatives");
    vanishes(T, G(cross2)(before, after));
}

/*
:::{claim} proportional_derivatives_by_arc_length
:title: By arc length: equal tangents and proportional second derivatives
:zh: 弧长参数下二阶导数成比例仍不足
:kind: counterexample
:data: T = (1,0); P'' = (0,1); Q'' = (0,-1)
:instead: Q'' = (0,1)
:result: κ before = 1; κ after = -1
:given: unit speed and one tangent, $P'=Q'=T$, and $Q''=-P''$: circles of radius 1 on both sides of the tangent
:then: the signed curvatures are opposite
:method: $P'\times P''$ and $Q'\times Q''$, which at unit speed are the curvatures.
:control: $Q''=P''$
:::
*/
CLAIM(proportional_derivatives_by_arc_length)
{
    num tangent[plane], P2[plane], Q2[plane];
    given_points(T, "T", 1, plane, tangent);
    given_points(T, "P''", 1, plane, P2);
    given_points(T, "Q''", 1, plane, Q2);
    num before = G(cross2)(tangent, P2), after = G(cross2)(tangent, Q2);
    found(T, "κ before", before);
    found(T, "κ after", after);
    about(T, "the signed curvatures");
    same(T, after, before);
}
#endif

/*
The section ends with the word fair (光顺), which is explained by three conditions.  Only the first of them is precise.

:::{statement} slides-ch4:1-fairness
:title: Fair curves
:zh: 光顺
:printed: Fairness means that a curve has not too many inflections and is smooth and flowing.  For plane curves, relatively: (1) $G^2$; (2) no superfluous inflections and singular
  points; (3) small changes of the curvature.
:reading: unit_tangent_jumps_at_the_cusp | beside $G^2$ the condition on singular points is not superfluous: $G^2$ as the slides explain it, by proportional derivatives, admits the
  singular point of a cusp, where the derivatives of both sides are equal and the tangent turns back
:reading: what is superfluous, and which change of the curvature is small: the text does not say, so that nothing is there
  to be decided
:::
*/
#include "chapters/judge/claims_off.h"
