/*
# Inflections of a cubic (拐点)

A plane curve changes its side where its curvature (曲率) passes through 0.  For a cubic this is decided by a polynomial
of degree two, the vector product of its first two derivatives.
*/
#include "chapters/foundations/cubic.h"

#if RATIONAL
#include "exact/record/sign.h"
#endif

#include "chapters/judge/claims_on.h"

/*
:::{statement} hu-1987:1-4-derivatives
:title: The first two derivatives of the cubic
:zh: 一、二阶导矢
:printed: \dot P(t)=[\dot x\;\dot y\;\dot z]=3At^2+2Bt+C,\qquad\ddot P(t)=[\ddot x\;\ddot y\;\ddot z]=6At+2B
:holds-by: derivatives_of_a_cubic
:figure: derivatives_with_lost_dots
:::

:::{claim} derivatives_of_a_cubic
:title: The three derivatives of a cubic
:zh: 三次曲线的各阶导矢
:given: any coefficients in space, any $t$
:then: $P'=3At^2+2Bt+C$, $P''=6At+2B$, $P'''=6A$
:method: The sum of powers differentiated term by term, and the kernel, against the printed expressions, everything a variable.
:over: x# y# z#: coefficients
:control: $3At$ in the place of $3At^2$
:::
*/
CLAIM(derivatives_of_a_cubic)
{
    num c[4 * space], D[4 * space], t = parameter(T, "t");
    G(free_points)(T, 3, space, c);
    G(power_derivatives)(3, space, c, t, 3, D);
    for (int j = 0; j < space; j++) {
        num C = c[space + j], B = c[2 * space + j], A = c[3 * space + j], tt = fault(T, mul(t, t), t);
        /* P' = 3At² + 2Bt + C,   P'' = 6At + 2B,   P''' = 6A */
        num printed[] = {add(add(mul(mul(from_int(3), A), tt), mul(mul(from_int(2), B), t)), C),
                         add(mul(mul(from_int(6), A), t), mul(from_int(2), B)), mul(from_int(6), A)};
        for (int r = 1; r <= 3; r++) {
            same(T, G(power_sum_derivative)(3, space, c, j, r, t), printed[r - 1]);
            same(T, D[r * space + j], printed[r - 1]);
        }
    }
}

/*
The dots that count derivatives are lost in print most easily, and the third one first.  A constant vector $6A$ can be
only the third derivative of a cubic; a second derivative that is constant would make it a parabola or a line.

:::{statement} hu-1987:1-4-third-derivative
:title: The third derivative of the cubic
:zh: 三阶导矢
:printed: \ddot P(t)=[\ddot x\;\ddot y\;\ddot z]=6A
:refuted-by: second_derivative_is_not_constant
:class: misprint
:corrected: \dddot P(t)=[\dddot x\;\dddot y\;\dddot z]=6A
:corrected-by: derivatives_of_a_cubic
:figure: derivatives_with_lost_dots

:::
*/

#if RATIONAL
/*
:::{claim} second_derivative_is_not_constant
:title: The second derivative of a cubic is not six times its first coefficient
:zh: 二阶导矢不等于 6A
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$, that is with the coefficients $c$ from $D$ to $A$, and $t$
:data: c = 0 0 0 1; t = 1/3
:then: $P''$ is not six times $A$
:result: P''(t) = 2; 6A = 6
:method: The kernel, exactly.
:control: the third derivative
:::
*/
CLAIM(second_derivative_is_not_constant)
{
    num c[4], D[4];
    given_points(T, "c", 4, 1, c);
    G(power_derivatives)(3, 1, c, given(T, "t"), 3, D);
    num derivative = D[fault(T, 3, 2)], printed = mul(from_int(6), c[3]);
    found(T, "P''(t)", derivative);
    found(T, "6A", printed);
    about(T, "the derivative, and 6A");
    same(T, derivative, printed);
}

/*
:::{claim} curvature_divides_by_zero_at_a_cusp
:title: At a cusp the formula of the curvature divides by zero
:zh: 尖点处曲率公式的分母为零
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$, which has a cusp, and the parameter $t$ of the cusp
:data: c = (0,0) (0,0) (1,0) (0,1); t = 0
:instead: t = 1
:then: the speed, whose third power is the denominator, is 0
:result: P'(t) = (0,0)
:method: The derivative by the kernel; that its length is not 0 is refuted.
:control: another parameter
:::
*/
CLAIM(curvature_divides_by_zero_at_a_cusp)
{
    num c[8], D[4];
    given_points(T, "c", 4, 2, c);
    G(power_derivatives)(3, dim, c, given(T, "t"), 1, D);
    found_points(T, "P'(t)", 1, 2, D + 2);
    about(T, "whether the speed is not 0");
    refute(T, is_zero_q(G(norm_squared)(2, D + 2)));
}

/*
:::{statement} hu-1987:1-4-curvature
:title: The formula of the curvature
:zh: 曲率公式
:printed: K=\frac{|\dot P\times\ddot P|}{s^3}
:refuted-by: printed_letter_spoils_the_curvature
:class: misprint
:corrected: $K=\frac{|\dot P\times\ddot P|}{\dot s^3}$, where $\dot s=|\dot P|$ is the speed, at points with $\dot P\ne0$
:corrected-by: curvature_by_the_vector_product curvature_belongs_to_arc_length
:meant: the letter, and the formula of the torsion in the same part, where a dot is lost, too: $\ddot P$ for the third derivative | $s$ is the length of the arc, and a dot
  over it is missing.
:reading: printed_letter_spoils_the_curvature | the quotient is the curvature, $s$ being the length of the arc
:reading: curvature_by_the_vector_product | the quotient is the curvature, $s=|\dot P|$ being the speed, at points with $\dot P\ne0$; the source leaves the others out behind
  the formula, for $\ddot P=g\dot P$
:reading-with: curvature_belongs_to_arc_length
:hypothesis: curvature_divides_by_zero_at_a_cusp | $\dot P\ne0$: in the correction; elsewhere it is divided by 0
:figure: curvature_and_the_speed
:::

:::{claim} printed_letter_spoils_the_curvature
:title: With the length of the arc in the place of the speed the quotient is not the curvature
:zh: 以弧长代替速率时曲率公式不成立
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$ in space; $t$; the polynomial $\sum_kl_kt^k$
:data: c = (0,0,0) (3,0,0) (0,3,0) (0,0,2); t = 1; l = 0 3 0 2
:then: $s(t)=\sum_kl_kt^k$ is the length of the arc from 0 to $t$, because $s(0)=0$ and its derivative is $|\dot P|$; and the printed
  quotient is not the curvature $K$
:result: s(t) = 5; s'(t) = 9; printed quotient = 54/125; K = 2/27
:method: The squares of $s'$ and of the speed are compared at five parameters, which determine a polynomial of degree four, and $s'>0$;
  then both numbers, exactly.
:control: the speed
:::
*/
CLAIM(printed_letter_spoils_the_curvature)
{
    num c[12], l[4], D[9], turning[space];
    int is_the_length = 1;
    given_points(T, "c", 4, 3, c);
    num t = given(T, "t");
    given_points(T, "l", 4, 1, l);
    poly length = poly_from_q(4, l), growth = poly_derivative(length);
    for (int k = 0; k < 5; k++) {
        num slope = poly_value(growth, from_int(k));
        G(power_derivatives)(3, space, c, from_int(k), 2, D);
        is_the_length = is_the_length && equal_q(mul(slope, slope), G(norm_squared)(space, D + space));
    }
    is_the_length = is_the_length && is_zero_q(l[0]);
    is_the_length = is_the_length && sign_on(growth, from_int(0), t, CLOSED) == SIGN_POSITIVE;
    G(power_derivatives)(3, space, c, t, 2, D);
    G(cross3)(D + space, D + 2 * space, turning);
    num arc = poly_value(length, t), speed = root(2, G(norm_squared)(space, D + space));
    num curvature = root(2, G(curvature_squared)(space, D + 3, D + 6));
    /* |P' x P''| / s^3, as printed, and / s'^3 */
    num quotient = div(root(2, G(norm_squared)(space, turning)), G(power)(fault(T, speed, arc), 3));
    found(T, "s(t)", arc);
    found(T, "s'(t)", speed);
    found(T, "printed quotient", quotient);
    found(T, "K", curvature);
    about(T, "the letter being the length of the arc, whether the quotient is the curvature");
    refute(T, is_the_length && !equal_q(quotient, curvature));
}
#endif

/*
:::{claim} curvature_by_the_vector_product
:title: The square of the curvature is that of the vector product over the sixth power of the speed
:zh: 用矢量积表示的曲率
:given: derivatives $P'\ne0$ and $P''$ of a curve, in the plane and in space
:where: $\dot P\ne0$
:then: $\frac{|P'\times P''|^2}{|P'|^6}=\frac{|P'|^2|P''|^2-(P'\cdot P'')^2}{|P'|^6}$, so that with $\dot s=|P'|$ the root of the one is that of the other, and $K=0$ where
  $P'\times P''=0$ and nowhere else
:method: The determinant in the plane and the vector product in space, against the kernel of the square of the curvature, everything a variable.
:over: u# v#: derivatives
:control: the fourth power of the speed
:::
*/
CLAIM(curvature_by_the_vector_product)
{
    for (int coordinates = dim; coordinates <= space; coordinates++) {
        num d1[space], d2[space], n[space], square;
        for (int j = 0; j < coordinates; j++) {
            d1[j] = unknown(T, "u", j);
            d2[j] = unknown(T, "v", j);
        }
        if (coordinates == dim) {
            square = G(power)(G(cross2)(d1, d2), 2);
        } else {
            G(cross3)(d1, d2, n);
            square = G(norm_squared)(space, n);
        }
        num speed = G(power)(G(norm_squared)(coordinates, d1), fault(T, 3, 2)); /* |P'|^6 */
        same(T, div(square, speed), G(curvature_squared)(coordinates, d1, d2));
    }
}

/*
In the curvature the dot is lost on the speed $\dot s$.  A quotient that should not depend on the parameter, but has the
length of the arc in its denominator, depends on where the length begins.  The example is chosen so that the length is a
polynomial and everything can be compared in rational numbers.

:::{statement} hu-1987:1-4-inflection
:title: An inflection is a point of curvature zero
:zh: 拐点的定义
:definition: yes
:printed: By the formula of the curvature, where $K=0$ the point is called an inflection.
:checked-by: curvature_belongs_to_arc_length curvature_by_the_vector_product turning_of_a_cubic_is_quadratic
:confirmed-by: sign_of_delta_tells_the_form merged_inflections_are_a_cusp fourth_power_has_curvature_zero_on_one_side
:figure: forms_of_a_cubic

For plane cubics with $A\times B\ne0$ a double zero of the quadratic $\dot P\times\ddot P$, whose discriminant is $12\delta$ with
$\delta=3b^2-4ac$ by `sign_of_delta_tells_the_form`, is a cusp by `merged_inflections_are_a_cusp`.  A curve of higher degree may have $K=0$
and stay on one side of its tangent, as $(t,t^4)$ at $t=0$.
:::

:::{statement} hu-1987:1-4-inflection-parallel
:title: At an inflection the second derivative is parallel to the first
:zh: 拐点处二阶导矢平行于切矢
:printed: An inflection is a point with $\dot P\times\ddot P=0$; points with $\dot P=0$ not considered, $\ddot P=g\dot P$ with a scalar $g$.
:holds-by: curvature_belongs_to_arc_length curvature_by_the_vector_product second_derivative_splits_along_the_first
:needs: cusp_has_no_such_factor | the sentence itself, which leaves out the points with $\dot P=0$ | $\dot P\ne0$: where
  $\dot P=0\ne\ddot P$ there is no $g$.
:figure: forms_of_a_cubic
:::

:::{claim} second_derivative_splits_along_the_first
:title: The second derivative is a multiple of the first plus what the vector product measures
:zh: 二阶导矢的分解
:given: any $P'\ne0$ and $P''$ in space
:where: $\dot P\ne0$
:then: $|P'|^2P''=(P'\cdot P'')\,P'+(P'\times P'')\times P'$; so $P'\times P''=0$ gives $P''=gP'$ with $g=\frac{P'\cdot P''}{|P'|^2}$, and
  conversely $P'\times gP'=0$
:method: Identities in the six components and $g$.
:over: u# v#: derivatives; g
:control: $P'\times(P'\times P'')$
:::
*/
CLAIM(second_derivative_splits_along_the_first)
{
    num d1[space], d2[space], n[space], back[space], g = unknown(T, "g", 0), scaled[space];
    for (int j = 0; j < space; j++) {
        d1[j] = unknown(T, "u", j);
        d2[j] = unknown(T, "v", j);
        scaled[j] = mul(g, d1[j]);
    }
    G(cross3)(d1, d2, n);
    if (T->faulty)
        G(cross3)(d1, n, back);
    else
        G(cross3)(n, d1, back);
    for (int j = 0; j < space; j++)
        /* |P'|² P'' = (P' · P'') P' + (P' × P'') × P' */
        same(T, mul(G(norm_squared)(space, d1), d2[j]), add(mul(G(dot)(space, d1, d2), d1[j]), back[j]));
    G(cross3)(d1, scaled, n);
    for (int j = 0; j < space; j++)
        vanishes(T, n[j]);
}

#if RATIONAL
/*
:::{claim} cusp_has_no_such_factor
:title: At a cusp the vector product vanishes and the second derivative is no multiple of the first
:zh: 尖点处不存在标量 g
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$, which has a cusp, and the parameter $t$ of the cusp
:data: c = (0,0) (0,0) (1,0) (0,1); t = 0
:instead: c = (0,0) (1,0) (1,0) (0,1)
:then: $P'\times P''=0$, and $P''\ne gP'=0$ for every $g$
:result: P'(t), P''(t) = (0,0) (2,0)
:method: The derivatives by the kernel.
:control: a cubic with an inflection there, where $P''$ is twice $P'$
:::
*/
CLAIM(cusp_has_no_such_factor)
{
    num c[8], D[6];
    given_points(T, "c", 4, 2, c);
    G(power_derivatives)(3, dim, c, given(T, "t"), 2, D);
    found_points(T, "P'(t), P''(t)", 2, 2, D + 2);
    int parallel = is_zero_q(G(cross2)(D + 2, D + 4));
    about(T, "P' × P'' being 0, whether P' is not 0, or P'' is 0");
    refute(T, parallel && is_zero_q(G(norm_squared)(2, D + 2)) && !is_zero_q(G(norm_squared)(2, D + 4)));
}
#endif

/*
The factor $g$ of the source comes from the vector that is split along $\dot P$.  Where $\dot P=0$ there is nothing to
split along, so cusps have to be looked at on their own.  Everywhere else the condition is one polynomial equation, and
the question how many inflections there are becomes the question for its degree.  The cubic terms of $\dot P\times\ddot
P$ cancel, because $A\times A=0$; the quadratic one is $A\times B$, and it can vanish as well.

:::{statement} hu-1987:1-4-inflection-quadratic
:title: The inflections are given by a quadratic equation
:zh: 拐点满足二次方程
:printed: This is a quadratic equation of $t$, the parameter running over $[0,1]$.
:holds-by: turning_of_a_cubic_is_quadratic
:meant: the two forms before it, $\dot P\times\ddot P=0$ and $\ddot P=g\dot P$ with an unknown $g$ | The equation is the one without $g$: $\dot P\times\ddot P=0$.
:hypothesis: graph_of_a_cubic_turns_linearly | $A\times B\ne0$.  Otherwise the equation is of lower degree, as for the graph $(t,t^3)$, with one
  inflection.
:figure: degrees_two_and_three

For a plane cubic it is one equation; in space there is one for each coordinate of the vector product, of degree 2 in those where $A\times B$
is not 0.
:::

:::{claim} turning_of_a_cubic_is_quadratic
:title: The vector product of the two derivatives of a cubic
:zh: 三次曲线的转向多项式
:given: any plane cubic, and any cubic in space, any $t$; $a=A\times B$, $b=A\times C$, $c=B\times C$
:then: $P'\times P''=-2(3at^2+3bt+c)$, of degree 2 or less, in the plane and, with vector products $a,b,c$, in space; the kernels give
  the numbers $a,b,c$ and the three coefficients
:method: The derivatives of the definition, multiplied, against the polynomial, everything a variable; $a,b,c$ as determinants
  written out.  In space each of the three coordinates of the vector product is such a polynomial; where all of them are 0 everywhere,
  $a,b,c$ are, so $A,B,C$ are parallel and the cubic is on a line.
:defines: cubic_minors cubic_inflection_polynomial
:scope: cubic curves
:over: x# y# d#: coefficients
:control: the factor 2 in the place of the first 3
:::
*/
CLAIM(turning_of_a_cubic_is_quadratic)
{
    num c[4 * dim], D[2][dim], m[3], f[3], t = parameter(T, "t");
    G(free_points)(T, 3, dim, c);
    G(cubic_minors)(c, m);
    for (int k = 0; k < 3; k++) { /* A x B, A x C, B x C */
        int i = k < 2 ? 3 : 2, h = k == 0 ? 2 : 1;
        same(T, m[k], sub(mul(c[2 * i], c[2 * h + 1]), mul(c[2 * i + 1], c[2 * h])));
    }
    G(cubic_inflection_polynomial)(m, f);
    for (int j = 0; j < dim; j++)
        for (int r = 1; r <= 2; r++)
            D[r - 1][j] = G(power_sum_derivative)(3, dim, c, j, r, t);
    num product = sub(mul(D[0][0], D[1][1]), mul(D[0][1], D[1][0]));
    same(T, G(power_sum)(2, 1, f, 0, t), product);
    num inner = add(add(mul(mul(from_int(fault(T, 3, 2)), m[0]), mul(t, t)), mul(mul(from_int(3), m[1]), t)), m[2]);
    /* P' × P'' = -2 (3at² + 3bt + c) */
    same(T, product, mul(from_int(-2), inner));

    num d[4 * space], first[space], second[space], turning[space], pairs[3][space];
    about(T, "in space");
    for (int k = 0; k < 4 * space; k++)
        d[k] = unknown(T, "d", k);
    for (int j = 0; j < space; j++) {
        first[j] = G(power_sum_derivative)(3, space, d, j, 1, t);
        second[j] = G(power_sum_derivative)(3, space, d, j, 2, t);
    }
    G(cross3)(first, second, turning);
    for (int k = 0; k < 3; k++)
        G(cross3)(d + (k < 2 ? 3 : 2) * space, d + (k == 0 ? 2 : 1) * space, pairs[k]);
    for (int j = 0; j < space; j++) {
        num quadratic = add(mul(from_int(3), mul(t, add(mul(t, pairs[0][j]), pairs[1][j]))), pairs[2][j]);
        same(T, turning[j], mul(from_int(-2), quadratic));
    }
}

#if RATIONAL
/*
:::{claim} fourth_power_has_curvature_zero_on_one_side
:title: A curve of degree four with curvature 0 where it does not change its side
:zh: 四次曲线曲率为零而不变凹凸
:kind: decision
:given: the curve $P(t)=\sum_kc_kt^k$, and $t$
:data: c = (0,0) (1,0) (0,0) (0,0) (0,1); t = 0
:instead: c = (0,0) (1,0) (0,0) (0,1) (0,0)
:then: $P'\times P''$ is 0 at $t$ and positive on both sides of it; the curve touches the $x$-axis there and is above it on both sides
:result: P' × P'' = "12*t^2"
:method: Signs on the intervals from $-1$ to $t$ and from $t$ to 1 by root counts; the derivative at $t$.
:control: the third power
:::
*/
CLAIM(fourth_power_has_curvature_zero_on_one_side)
{
    enum { degree = 4 };
    num c[2 * (degree + 1)], D[4], one = from_int(1);
    given_points(T, "c", degree + 1, 2, c);
    num t = given(T, "t");
    poly at[2], speed[2], turn[2];
    for (int j = 0; j < dim; j++) {
        at[j] = poly_from_q(degree + 1, (num[]){c[j], c[2 + j], c[4 + j], c[6 + j], c[8 + j]});
        speed[j] = poly_derivative(at[j]);
        turn[j] = poly_derivative(speed[j]);
    }
    poly turning = poly_sub(poly_mul(speed[0], turn[1]), poly_mul(speed[1], turn[0]));
    found_text(T, "P' × P''", poly_to_string(turning, "t"));
    G(power_derivatives)(degree, dim, c, t, 1, D);
    about(T, "the tangent along the axis");
    agree(T, is_zero_q(poly_value(turning, t)) && is_zero_q(D[1]) && is_zero_q(D[3]) && !is_zero_q(D[2]));
    about(T, "the sides");
    for (int side = 0; side < 2; side++) {
        num from = side ? t : neg(one), to = side ? one : t;
        agree(T, sign_on(turning, from, to, OPEN) == SIGN_POSITIVE && sign_on(at[1], from, to, OPEN) == SIGN_POSITIVE);
    }
}

/*
:::{claim} graph_of_a_cubic_turns_linearly
:title: For the graph of a cubic function the equation of the inflections is linear
:zh: 三次函数图形的拐点方程是一次的
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$, which is the graph of a cubic function
:data: c = (0,0) (1,0) (0,0) (0,1)
:instead: c = (0,0) (1,0) (1,0) (0,1)
:then: $P'\times P''$ has degree 1: one inflection, at 0, and no second root anywhere
:result: P' × P'' = "6*t"
:method: The kernels; that the coefficient of $t^2$ is not 0 is refuted.
:control: a cubic that is no graph
:::
*/
CLAIM(graph_of_a_cubic_turns_linearly)
{
    num c[8];
    given_points(T, "c", 4, 2, c);
    poly turning = turning_of(c);
    found_text(T, "P' × P''", poly_to_string(turning, "t"));
    about(T, "whether the coefficient of t² is not 0");
    refute(T, is_zero_q(poly_coefficient(turning, 2)));
}

/*
:::{statement} hu-1987:1-4-two-inflections
:title: A cubic has at most two inflections
:zh: 参数三次曲线至多有两个拐点
:printed: So a parametric cubic has at most two inflections.
:holds-by: turning_of_a_cubic_is_quadratic
:confirmed-by: each_form_occurs
:hypothesis: line_has_curvature_zero_everywhere | the cubic is on no line.  On a line $\dot P\times\ddot P$ is 0 everywhere.
:figure: forms_of_a_cubic

Two do occur: `each_form_occurs`.
:::

:::{claim} line_has_curvature_zero_everywhere
:title: Along a line the vector product is zero for every parameter
:zh: 直线上矢量积处处为零
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$, which runs on a line
:data: c = (0,0) (1,0) (0,0) (1,0)
:instead: c = (0,0) (1,0) (0,0) (1,1)
:then: $P'\times P''=0$ as a polynomial: more than two parameters
:result: P' × P'' = "0"
:method: The kernels; that not all three coefficients vanish is refuted.
:control: a cubic that leaves the line
:::
*/
CLAIM(line_has_curvature_zero_everywhere)
{
    num c[8];
    given_points(T, "c", 4, 2, c);
    poly turning = turning_of(c);
    found_text(T, "P' × P''", poly_to_string(turning, "t"));
    about(T, "whether P' × P'' has finitely many zeros");
    refute(T, poly_is_zero(turning));
}
#endif

#include "chapters/judge/claims_off.h"
