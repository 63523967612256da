/*
# Regular and singular points (正则点与奇异点)

A parameter $t_0$ is regular when $P'(t_0)\ne0$.  It is a property of a parameter, not of a point of the plane, and two
things are often confused with it: that the point set is smooth there, which may hold although $P'=0$, and that the
point set has one tangent, which may fail although $P'\ne0$.
*/
#include "chapters/foundations/definition.h"

#if RATIONAL
#include "exact/record/sign.h"
#endif

#include "chapters/judge/claims_on.h"

enum { dim = 2 };

/*
:::{statement} hu-1987:1-4-regular
:title: Regular and singular points
:zh: 正则点与奇异点的定义
:definition: yes
:printed: If $\dot P(t_0)\ne0$ the curve is regular at $t=t_0$; a regular point is called ordinary, one that is not regular
  singular.
:checked-by: regularity_is_a_sum_of_squares
:figure: cusp_and_its_derivative
:::

:::{statement} hu-1987:1-4-regular-squares
:title: Regularity as a sum of squares
:zh: 正则条件的平方和形式
:printed: Regularity means that $\dot x(t_0)$, $\dot y(t_0)$, $\dot z(t_0)$ are not all zero, that is
  $[\dot x(t_0)]^2+[\dot y(t_0)]^2+[\dot z(t_0)]^2>0$.
:holds-by: regularity_is_a_sum_of_squares
:::

:::{claim} regularity_is_a_sum_of_squares
:title: A sum of squares of the components is positive unless all are zero
:zh: 平方和大于零
:given: any vector of three positive numbers, with any signs and with any of them replaced by 0
:then: $|v|^2$ is the sum of the squares of the components, positive when one of them is not 0, and 0 for the zero vector
:method: All 27 choices of a positive, a negative component or 0; the kernel's square of the norm has only positive coefficients in the positive numbers.
:scope: all vectors of space
:harmless: three positive numbers | with any signs and zeros these are all vectors
:over: v#: -
:control: the square of the last component subtracted
:::
*/
CLAIM(regularity_is_a_sum_of_squares)
{
    for (int choice = 0; choice < 27; choice++) {
        int sign[3] = {choice % 3 - 1, choice / 3 % 3 - 1, choice / 9 - 1};
        num v[3], sum = from_int(0);
        for (int j = 0; j < 3; j++) {
            v[j] = mul(from_int(sign[j]), positive(T, "v", j));
            num square = mul(v[j], v[j]);
            sum = fault(T, add(sum, square), j == 2 ? sub(sum, square) : add(sum, square));
        }
        same(T, G(norm_squared)(3, v), sum);
        if (sign[0] != 0 || sign[1] != 0 || sign[2] != 0)
            G(must_be_positive)(T, G(norm_squared)(3, v));
        else
            vanishes(T, sum);
    }
}

/*
A sum of squares is the shortest way to say that three numbers are not all 0, and it is the speed, squared.  So a
regular point (正则点) is one that the moving point passes without standing still, and at the cusp of the example, as on
the line that turns back, the trouble begins where the point stands still.

:::{statement} hu-1987:1-4-class
:title: Curves of class r
:zh: 曲线的 C^r 级
:definition: yes
:printed: If for a curve $P(t)$ ($a\le t\le b$) all derivatives of $x(t),y(t),z(t)$ "of order $r$ that are positive" (所有 r 阶为正的导数) exist and are
  continuous, and the regularity condition above is satisfied, the curve is called continuous of class $C^r$.
:checked-by: cusp_of_the_example_is_a_cusp
:confirmed-by: natural_line_is_regular
:example: a curve whose coordinates are polynomials, and which is of no class on $[0,1]$.
:meant: the usual notion of the class $C^r$, as the words are out of order | The derivatives of the orders 1 to $r$.
:figure: cusp_and_its_derivative

The curve of the example has the derivative 0 at $t=\frac12$, so that by this definition it is of no class on an interval that contains this parameter.
The line $x=y=t$ has the derivative $(1,1)$ and all further ones 0, so that it is of every class $C^r$, $r\ge1$, on every interval:
`natural_line_is_regular`.
:::

The source next asks what regularity is good for, and answers: for a tangent.  That is the limit of chords, which have
the direction of the derivative in the limit, because the quotient of chord and time tends to it; for a polynomial that
quotient is again a polynomial, and the limit is put in like a number.  The sentence is
about "points of a curve", and here the two meanings of the word part.  A loop comes back to a point with another
direction; each of the two parameters has its one tangent, the point has two.

:::{statement} hu-1987:1-4-unique-tangent
:title: At a regular point there is one tangent
:zh: 正则点处切线唯一
:printed: At regular points of a curve a unique tangent can be determined.
:holds-by: direction_is_near_where_the_vector_is
:confirmed-by: quotient_of_a_power_tends_to_its_derivative polynomial_without_constant_is_small_near_zero chord_turns_into_the_derivative
:meant: the definition just before it, which is of a parameter $t_0$ | A regular point is a parameter of the curve, and its tangent the limit of the chords.
:reading: direction_is_near_where_the_vector_is | at a regular point, a parameter as in the definition, there is one tangent
:reading: double_point_has_two_tangents | at a point of the plane or of space that is passed at regular parameters only, there is one tangent
:figure: regular_double_point

A point that is passed twice, at a loop, has a tangent for each passage, though both parameters are regular.
:::
*/

/*
:::{claim} quotient_of_a_power_tends_to_its_derivative
:title: The quotient of differences of a power tends to its derivative, for every power
:zh: 幂函数差商的极限(任意次数)
:given: any $k\ge1$, $t$ and $h$; $p=t^k$, and $q$ with $(t+h)^k-t^k=hq$
:then: $(t+h)^{k+1}-t^{k+1}=h\,\bigl((t+h)\,q+p\bigr)$; and where $q=k\,t^{k-1}$ for $h=0$, that bracket is $(k+1)\,t^k$ for $h=0$
:method: One step from a power to the next, with $k$, $t^{k-1}$, $q$, $h$, $t$ variables; for $k=1$, $q=1$.  By induction the quotient
  $\frac{P(t+h)-P(t)}h$ of every polynomial is a polynomial in $h$ whose value for $h=0$ is $P'(t)$; so the direction of the chord has the limit $P'(t)$ from
  both sides wherever this is not 0, coordinate by coordinate.
:degrees: all
:scope: polynomial curves
:over: k q p: -; h; t
:control: $t$ in the place of $t+h$ in the bracket
:::
*/
CLAIM(quotient_of_a_power_tends_to_its_derivative)
{
    num k = whole(T, "k", 1, 9), t = parameter(T, "t"), h = positive(T, "h", 0), q = unknown(T, "q", 0);
    num before = unknown(T, "p", 0), p = mul(before, t), there = add(p, mul(h, q)); /* t^{k-1}, t^k, (t+h)^k */
    about(T, "the difference of the next power");
    num bracket = add(mul(fault(T, add(t, h), t), q), p);
    same(T, sub(mul(there, add(t, h)), mul(p, t)), mul(h, bracket));
    about(T, "the bracket for h = 0");
    same(T, add(mul(t, mul(k, before)), p), mul(add(k, from_int(1)), p));
}

/*
:::{claim} polynomial_without_constant_is_small_near_zero
:title: A polynomial without a constant is as small as one likes near zero, in every degree
:zh: 无常数项的多项式在零附近任意小(任意次数)
:given: $0<h<1$, the size of the argument; a sum of some terms $c_k(\pm h)^k$, $k\ge1$, of a size of at most $E$, the sum $S$ of the sizes of their coefficients, $hS-E=g\ge0$; one more
  coefficient, of the size $a>0$, and power $h\,p$, $p=h^{k-1}$, $0<p<1$ or, for $k=1$, $p=1$; and $\varepsilon>0$, $0<y<1$
:harmless: $hS-E=g\ge0$ | the induction keeps it
:harmless: $\varepsilon>0$, $0<y<1$ | as small as one likes
:harmless: $a>0$ | a coefficient 0 changes nothing
:then: $h(S+a)-(E+a\,h\,p)=g+a\,h\,(1-p)\ge0$, so $|\sum c_k(\pm h)^k|\le h\sum|c_k|$; and for $h=y\,\frac\varepsilon S$ that is less than $\varepsilon$ by
  $\varepsilon\,(1-y)$, where $S\ne0$; with $S=0$ the sum is 0
:method: One step with everything a variable; then induction over the terms.
:degrees: all
:over: h g S a p e y: -
:control: $h\,(S-a)$ in the place of $h\,(S+a)$
:::
*/
CLAIM(polynomial_without_constant_is_small_near_zero)
{
    num h = inside(T, "h"), S = positive(T, "S", 0), a = positive(T, "a", 0), one = from_int(1);
    num sum = add(S, fault(T, a, neg(a)));
    for (int choice = 0; choice < 4; choice++) {
        int first = choice % 2;
        num g = choice < 2 ? positive(T, "g", 0) : from_int(0), E = sub(mul(h, S), g);
        num p = first ? one : inside(T, "p"), left = add(g, mul(mul(a, h), sub(one, p)));
        about(T, first ? "the first term" : "a further term");
        same(T, sub(mul(h, sum), add(E, mul(mul(a, h), p))), left);
        nonnegative(T, left);
    }
    num epsilon = positive(T, "e", 0), y = inside(T, "y"), rest = mul(epsilon, sub(one, y));
    about(T, "as small as one likes");
    same(T, sub(epsilon, mul(div(mul(y, epsilon), S), S)), rest);
    G(must_be_positive)(T, rest);
}

/*
:::{claim} direction_is_near_where_the_vector_is
:title: A vector that differs little from another one has nearly its direction
:zh: 矢量相近则方向相近
:given: a vector $d\ne0$ of space, and another one, $q=d+e$, any $e$
:where: $\dot P\ne0$
:then: $q\times d=e\times d$ and $|e|^2|d|^2-|e\times d|^2=(e\cdot d)^2\ge0$, so that the sine of the angle of $q$ and $d$, $\frac{|q\times d|}{|q||d|}$, is at most
  $\frac{|e|}{|q|}$, where $|q|\ge|d|-|e|$; and $q\cdot d=|d|^2+e\cdot d$, so that the angle is acute for $|e|<|d|$.
  For any $\eta>0$ the sine is less than $\eta$ where $|e|<\frac\eta{1+\eta}\cdot|d|$
:method: Identities in the six coordinates.  With $|d|=b$ and $|e|=\frac{y\eta}{1+\eta}\cdot b$, $0<y<1$, the difference $\eta(b-|e|)-|e|=\eta(1-y)b$ is positive.  For
  $d=\dot P(t_0)$ and $q=\frac{P(t_0+h)-P(t_0)}h$ the derivative is that vector $d$ for which $|e|$ is less than any given number where $h$ is small enough, of either
  sign: so the sine is less than any $\eta>0$ there.  The direction of the chords has that of $d$ for its limit, and no other.
:scope: curves with a derivative
:over: u# v# b y n: -
:control: the vector product taken in the other order
:::
*/
CLAIM(direction_is_near_where_the_vector_is)
{
    enum { space = 3 };
    num d[space], e[space], q[space], of_q[space], of_e[space];
    for (int j = 0; j < space; j++) {
        d[j] = unknown(T, "u", j);
        e[j] = unknown(T, "v", j);
        q[j] = add(d[j], e[j]);
    }
    G(cross3)(q, d, of_q);
    if (T->faulty)
        G(cross3)(d, e, of_e);
    else
        G(cross3)(e, d, of_e);
    about(T, "the vector products");
    for (int j = 0; j < space; j++)
        same(T, of_q[j], of_e[j]);
    num along = G(dot)(space, e, d), squares = mul(G(norm_squared)(space, e), G(norm_squared)(space, d));
    about(T, "the square of the vector product");
    same(T, sub(squares, G(norm_squared)(space, of_e)), mul(along, along));
    about(T, "the scalar product");
    same(T, G(dot)(space, q, d), add(G(norm_squared)(space, d), along));
    num b = positive(T, "b", 0), eta = positive(T, "n", 0), y = inside(T, "y"), one = from_int(1);
    num size = mul(div(mul(y, eta), add(one, eta)), b), room = mul(mul(eta, sub(one, y)), b);
    about(T, "as small as one likes");
    same(T, sub(mul(eta, sub(b, size)), size), room);
    G(must_be_positive)(T, room);
}

#if FIELD
/*
:::{claim} chord_turns_into_the_derivative
:title: Chords through a regular point turn into the derivative
:zh: 割线趋于切线
:given: any coefficients of degree $n$ in space, any $t$ and $h\ne0$
:where: $h\ne0$
:then: $\frac{P(t+h)-P(t)}h$ is a polynomial in $h$ whose value for $h=0$ is $P'(t)$; so the direction of the chord has the limit
  $P'(t)$ from both sides wherever this is not 0
:method: The quotient is formed in the field, $h=0$ put in, and compared with the derivative by the kernel.
:types: field
:degrees: 1..6
:over: x# y# z#: coefficients; h
:defines: power_hodograph power_derivatives
:control: $P'(t)$ with the coefficient $n-1$ in the place of $n$
:::
*/
CLAIM(chord_turns_into_the_derivative)
{
    enum { space = 3 };
    int n = T->degree;
    num c[(MAX_DEGREE + 1) * space], D[(MAX_DEGREE + 3) * space], t = variable_f("t"), h = variable_f("h");
    num e[(MAX_DEGREE + 1) * space], value[space];
    G(free_points)(T, n, space, c);
    G(power_derivatives)(n, space, c, t, n + 1, D);
    for (int m = 0; m < (n + 1) * space; m++)
        e[m] = c[m];
    G(power_hodograph)(n, space, e);
    G(power_point)(n - 1, space, e, t, value);
    for (int j = 0; j < space; j++) {
        num at = G(power_sum)(n, space, c, j, t), there = G(power_sum)(n, space, c, j, add(t, h));
        num slope = substitute_f(div(sub(there, at), h), h, from_int(0));
        slope = fault(T, slope, mul(slope, from_ratio(n - 1, n)));
        about(T, "P'");
        same(T, D[space + j], slope);
        same(T, value[j], slope);
        about(T, "the last coefficient");
        same(T, e[n * space + j], c[n * space + j]);
        about(T, "the higher derivatives");
        num formal = at;
        for (int k = 0; k <= n + 1; k++) {
            same(T, D[k * space + j], formal);
            formal = derivative_f(formal, t);
        }
    }
}
#endif

#if RATIONAL
/*
:::{claim} double_point_has_two_tangents
:title: A loop has two tangents at its double point
:zh: 二重点处有两条切线
:kind: counterexample
:given: the plane cubic $P(t)=\sum_kc_kt^k$, and two parameters $t$
:data: c = (3,-6) (-16,44) (16,-96) (0,64); t = 1/4 3/4
:instead: t = 3/4 3/4
:then: both parameters give one point, and the derivatives there are not 0, and not parallel
:result: P(t) = (0,0) (0,0); P'(t) = (-8,8) (8,8)
:method: The points and derivatives by the kernel; that the two directions are one is refuted.
:control: one parameter twice
:::
*/
CLAIM(double_point_has_two_tangents)
{
    num c[8], t[2], D[2][4];
    given_points(T, "c", 4, 2, c);
    given_points(T, "t", 2, 1, t);
    for (int k = 0; k < 2; k++)
        G(power_derivatives)(3, dim, c, t[k], 1, D[k]);
    found_points(T, "P(t)", 2, 2, (num[]){D[0][0], D[0][1], D[1][0], D[1][1]});
    found_points(T, "P'(t)", 2, 2, (num[]){D[0][2], D[0][3], D[1][2], D[1][3]});
    about(T, "whether the points differ, or a derivative is 0, or the derivatives are parallel");
    int one_point = equal_q(D[0][0], D[1][0]) && equal_q(D[0][1], D[1][1]);
    int regular = !is_zero_q(G(norm_squared)(2, D[0] + 2)) && !is_zero_q(G(norm_squared)(2, D[1] + 2));
    refute(T, one_point && regular && !is_zero_q(G(cross2)(D[0] + 2, D[1] + 2)));
}
#endif

/*
## The cusp of the example

:::{statement} hu-1987:1-4-cusp
:title: A curve with a cusp
:zh: 具有尖点的曲线
:printed: $x=4t^3-6t^2+3t$, $y=-3t^2+3t$ has a cusp at $t=0.5$, with the coordinates $[0.5,0.75]$.
:holds-by: cusp_of_the_example_is_a_cusp
:figure: cusp_and_its_derivative
:::

:::{statement} hu-1987:1-4-cusp-zero
:title: At the cusp both derivatives vanish
:zh: 尖点处导数为零
:printed: At the cusp of $x=4t^3-6t^2+3t$, $y=-3t^2+3t$ the derivative $\dot P(t)$ is the zero vector, that is $\dot x=0$, $\dot y=0$.
:holds-by: cusp_of_the_example_is_a_cusp
:example: the sentence is about the cusp of this one curve.
:figure: cusp_and_its_derivative
:::
*/

/*
:::{claim} cusp_of_the_example_is_a_cusp
:title: The curve of the example is a semicubical parabola
:zh: 例中曲线为半立方抛物线
:given: the curve of the example, $P(t)=\sum_kc_kt^k$; the parameter $t$ of the cusp; any $u$
:data: c = (0,0) (3,3) (-6,-3) (4,0); t = 1/2
:instead: c = (0,0) (3,3) (-5,-3) (4,0)
:then: $P(t+u)=(x_0+\kappa u^3,\;y_0+\mu u^2)$ with $(x_0,y_0)=e_0$, $(0,\mu)=e_2$, $(\kappa,0)=e_3$; so
  $\mu^3(x-x_0)^2=\kappa^2(y-y_0)^3$.  The derivative $u\,(3\kappa u,2\mu)$ is 0 exactly for $u=0$, and its direction, $(3\kappa u,2\mu)$
  times the sign of $u$, turns over there
:result: e = (1/2,3/4) (0,0) (0,-3) (4,0)
:method: $e_k$ is the $k$-th derivative at $t$, by the definition, over $k!$.  The polynomials as printed, at a variable $u$, and their
  derivatives by the kernel.
:scope: the stated curve
:over: u: -
:control: another coefficient of $t^2$ in $x$
:::
*/
CLAIM(cusp_of_the_example_is_a_cusp)
{
    num c[8], e[8], D[4], u = unknown(T, "u", 0), uu = mul(u, u);
    given_points(T, "c", 4, 2, c);
    num t = given(T, "t");
    for (int k = 0; k <= 3; k++)
        for (int j = 0; j < dim; j++)
            e[k * dim + j] = div(G(power_sum_derivative)(3, dim, c, j, k, t), G(factorial)(k));
    found_points(T, "e", 4, 2, e);
    G(power_derivatives)(3, dim, c, add(t, u), 1, D);
    num x = sub(D[0], e[0]), y = sub(D[1], e[1]), mu = e[5], kappa = e[6];
    same(T, x, mul(kappa, mul(u, uu)));
    same(T, y, mul(mu, uu));
    /* μ³ (x - x_0)² = κ² (y - y_0)³ */
    same(T, mul(G(power)(mu, 3), mul(x, x)), mul(mul(kappa, kappa), G(power)(y, 3)));
    /* P' = (3κu², 2μu) */
    same(T, D[2], mul(mul(from_int(3), kappa), uu));
    same(T, D[3], mul(mul(from_int(2), mu), u));
}

/*
The printed sentence about the cusp names the right place and the wrong quantity.  Polynomials are continuous, and so
are their derivatives; the velocity at a cusp (尖点) shrinks to nothing, and grows again, without a jump.  What jumps is
the direction, the velocity divided by its length, and this quotient is undefined just where the length is 0.

:::{statement} hu-1987:1-4-cusp-continuity
:title: At the cusp the derivative is discontinuous
:zh: 尖点处导矢不连续
:printed: At the cusp of $x=4t^3-6t^2+3t$, $y=-3t^2+3t$ the derivative $\dot P(t)$ will be discontinuous and equal to the zero vector.
:refuted-by: derivative_is_continuous_at_the_cusp
:class: false
:corrected: $\dot P$ is continuous, as polynomials are, and zero at the cusp; the unit tangent $\dot P/|\dot P|$ has no limit there: it jumps
  from $(0,1)$ to $(0,-1)$.
:corrected-by: unit_tangent_jumps_at_the_cusp cusp_of_the_example_is_a_cusp
:example: the sentence is about the cusp of this one curve.
:figure: cusp_and_its_derivative
:striking: 42
:::
*/

#if RATIONAL
/*
:::{claim} derivative_is_continuous_at_the_cusp
:title: At the cusp the derivative has its own value as the limit from both sides
:zh: 尖点处导矢连续
:kind: counterexample
:given: the curve of the example, $P(t)=\sum_kc_kt^k$; the parameter $t$ of the cusp
:data: c = (0,0) (3,3) (-6,-3) (4,0); t = 1/2
:then: $x'$ and $y'$ are polynomials in the distance $u$ from $t$, whose limits for $u\to0$ from either side are their values there
:result: x'(t + u) = "12*u^2"; y'(t + u) = "-6*u"; P'(t) = (0,0)
:method: The limits of a polynomial from both sides are its constant coefficient; that one of them differs from $P'(t)$ is
  refuted.
:control: the signs of $y'$ taken as its values
:::
*/
CLAIM(derivative_is_continuous_at_the_cusp)
{
    num c[8], at[2];
    given_points(T, "c", 4, 2, c);
    num t = given(T, "t");
    poly shift = poly_add(poly_variable(), poly_constant(t)), near[2];
    for (int j = 0; j < dim; j++) {
        poly speed = poly_derivative(poly_from_q(4, (num[]){c[j], c[2 + j], c[4 + j], c[6 + j]}));
        near[j] = poly_compose(speed, shift);
        at[j] = poly_value(speed, t);
    }
    found_text(T, "x'(t + u)", poly_to_string(near[0], "u"));
    found_text(T, "y'(t + u)", poly_to_string(near[1], "u"));
    found_points(T, "P'(t)", 1, 2, at);
    num sign_from_the_left = neg(from_int(sign_q(poly_coefficient(near[1], 1)))); /* of y' */
    num limit = fault(T, sign_from_the_left, poly_coefficient(near[1], 0));
    about(T, "whether a one-sided limit of P' differs from P' at the cusp");
    refute(T, equal_q(poly_coefficient(near[0], 0), at[0]) && equal_q(limit, at[1]));
}
#endif

/*
:::{claim} unit_tangent_jumps_at_the_cusp
:title: The unit tangent turns over at the cusp
:zh: 单位切矢在尖点处反向
:given: the curve of the example, $P(t)=\sum_kc_kt^k$, at $t-u$ and $t+u$, where $t$ is the parameter of the cusp and $u>0$
:data: c = (0,0) (3,3) (-6,-3) (4,0); t = 1/2
:then: $P'=6u\,(2u,1)$ before and $P'=6u\,(2u,-1)$ after; the factors $6u$ are positive.  The sine of the angle between $P'$ and $(0,1)$ before, $(0,-1)$ after, is
  $\frac{2u}{\sqrt{1+4u^2}}<2u$, as small as one likes with $u$
:method: Identities in $u$; the squares of $2u$ and of the sine differ by $\frac{(2u)^4}{1+(2u)^2}$, which is positive.  The angles are acute, as the second
  components have the signs of $1$ and $-1$.
:scope: the stated curve
:over: u: -
:control: the same direction on both sides
:::
*/
CLAIM(unit_tangent_jumps_at_the_cusp)
{
    num c[8], D[4], u = positive(T, "u", 0), factor = mul(from_int(6), u);
    given_points(T, "c", 4, 2, c);
    num t = given(T, "t");
    for (int side = -1; side <= 1; side += 2) {
        G(power_derivatives)(3, dim, c, add(t, mul(from_int(side), u)), 1, D);
        same(T, D[2], mul(factor, mul(from_int(2), u)));
        same(T, D[3], mul(factor, from_int(fault(T, -side, -1))));
        num fourfold = mul(from_int(4), mul(u, u)), length = G(norm_squared)(2, D + 2);
        num gap = div(mul(fourfold, fourfold), add(from_int(1), fourfold));
        about(T, "the squares of 2u and of the sine");
        same(T, sub(fourfold, div(mul(D[2], D[2]), length)), gap);
        G(must_be_positive)(T, gap);
    }
}

/*
A singular point (奇异点) is not always seen.  The abscissa of the cusp alone, taken for both coordinates, draws a straight
segment: the point slows down, stands still for a moment and goes on as before.  Whether a stop is an anomaly is decided
by what the point does after it, and this leads to the source's last example, where it turns back.

:::{statement} hu-1987:1-4-singular-anomalies
:title: At singular points all kinds of anomalies appear
:zh: 奇异点处出现异常情况
:printed: At singular points, however, all kinds of abnormal cases will appear.
:holds-by: cusp_of_the_example_is_a_cusp point_moves_forward_back_and_forward
:meant: the examples that follow, each with an anomaly of its own | There are singular points with such cases, of more than one kind.
:reading: cusp_of_the_example_is_a_cusp | there are singular points where the curve is abnormal: at a cusp its direction turns over
:reading: point_moves_forward_back_and_forward | there are singular points where the motion is abnormal: on a line the point turns back
:reading: singular_point_of_a_plain_segment | at every singular point something abnormal is seen
:figure: singular_point_of_a_segment
:::
*/

#if RATIONAL
/*
:::{claim} singular_point_of_a_plain_segment
:title: A segment run once and forward, with a singular point in the middle
:zh: 含奇异点的普通线段
:kind: counterexample
:given: the curve $x=y=\phi(t)=\sum_kc_kt^k$, the abscissa of the example with the cusp; a parameter $t$
:data: c = 0 3 -6 4; t = 1/2
:instead: c = 0 6 -15 10
:then: $\phi'$ is not negative on $[0,1]$ and vanishes at $t$ only, where the curve is singular; the curve runs from $(0,0)$ to $(1,1)$
  once and never back, and has the tangent $(1,1)$ everywhere
:result: φ' = "12*t^2 - 12*t + 3"; φ'(t) = 0; number of zeros of φ' = 1
:method: $\phi$ at the ends, the sign of $\phi'$ and its zeros on $[0,1]$ by root counts; that it is singular nowhere, or goes back
  somewhere, is refuted.
:control: a cubic that goes back
:::
*/
CLAIM(singular_point_of_a_plain_segment)
{
    num c[4], zero = from_int(0), one = from_int(1);
    given_points(T, "c", 4, 1, c);
    num t = given(T, "t");
    poly run = poly_from_q(4, c), speed = poly_derivative(run);
    int whole_segment = is_zero_q(poly_value(run, zero)) && equal_q(poly_value(run, one), one);
    int zeros = count_roots(speed, zero, one, CLOSED).distinct;
    found_text(T, "φ'", poly_to_string(speed, "t"));
    found(T, "φ'(t)", poly_value(speed, t));
    found_whole(T, "number of zeros of φ'", zeros);
    about(T, "a point being singular, whether the curve goes back somewhere");
    refute(T, whole_segment && zeros > 0 && sign_on(speed, zero, one, CLOSED) == SIGN_NONNEGATIVE);
}
#endif

/*
## One line, two parameters

:::{statement} hu-1987:1-4-line-regular
:title: A line in its natural parameter is regular
:zh: 直线 x=y=t 处处正则
:printed: The line $x=y=t$ has $\dot P(t)\ne0$; so the curve is regular on the whole interval.
:holds-by: natural_line_is_regular
:figure: one_line_two_parameters
:::

:::{claim} natural_line_is_regular
:title: The derivative of the line is (1, 1) everywhere
:zh: 直线的导矢为常矢量
:given: the line $x=y=t$, that is $P(t)=\sum_kc_kt^k$, at any $t$
:data: c = (0,0) (1,1) (0,0)
:instead: c = (0,0) (0,0) (1,1)
:then: $P'(t)=(1,1)$, which is not $(0,0)$, for every $t$
:result: P'(t) = (1,1)
:method: The kernel at a variable $t$; every component is 1.
:control: $x=y=t^2$
:::
*/
CLAIM(natural_line_is_regular)
{
    num c[6], D[4], t = parameter(T, "t");
    given_points(T, "c", 3, 2, c);
    G(power_derivatives)(2, dim, c, t, 1, D);
    found_points(T, "P'(t)", 1, 2, D + dim);
    for (int j = 0; j < dim; j++)
        same(T, D[dim + j], from_int(1));
}

/*
:::{statement} hu-1987:1-4-line-same
:title: The cubic parameter describes the same line
:zh: 同一条直线的另一参数
:printed: $x=y=\phi(t)=10t^3-15t^2+6t$ represents the same line (直线) as $x=y=t$.
:holds-by: cubic_parameter_stays_on_the_segment
:meant: the beginning $t=0$ (起点) and the end $t=1$ (终点) of the sentences behind it | The line is its segment of $0\le t\le1$.
:figure: one_line_two_parameters
:::
*/

#if RATIONAL
/*
:::{claim} cubic_parameter_stays_on_the_segment
:title: The other parameter covers the segment and nothing else
:zh: 另一参数恰好走遍线段
:kind: decision
:given: the printed $\phi(t)=\sum_kc_kt^k$ on $[0,1]$
:data: c = 0 6 -15 10
:instead: c = 0 7 -15 10
:then: $0\le\phi\le1$, and both ends are reached: every $x$ of $[0,1]$ is a value, as $\phi-x$ is not positive at 0 and not negative at 1, and so
  has a zero between; moreover $\phi(1-t)=1-\phi(t)$
:result: φ(0), φ(1) = 0 1
:method: Signs of $\phi$ and $1-\phi$ on the interval by root counts; the symmetry as polynomials.
:scope: the stated line
:where: $0\le t\le1$
:control: another coefficient of $t$
:::
*/
CLAIM(cubic_parameter_stays_on_the_segment)
{
    num c[4], zero = from_int(0), one = from_int(1);
    given_points(T, "c", 4, 1, c);
    poly phi = poly_from_q(4, c), rest = poly_sub(poly_constant(one), phi);
    poly back = poly_compose(phi, poly_sub(poly_constant(one), poly_variable()));
    num ends[2] = {poly_value(phi, zero), poly_value(phi, one)};
    found_points(T, "φ(0), φ(1)", 2, 1, ends);
    agree(T, is_zero_q(ends[0]) && equal_q(ends[1], one));
    agree(T,
          sign_on(phi, zero, one, CLOSED) == SIGN_NONNEGATIVE && sign_on(rest, zero, one, CLOSED) == SIGN_NONNEGATIVE);
    agree(T, poly_equal(back, rest));
}
#endif

/*
The same segment has been given two parameters, and it is regular in one of them and singular twice in the other.
Regularity is therefore no property of the point set.  The two singular parameters are also mirror images, since
$\phi(1-t)=1-\phi(t)$, and the next claim finds a curiosity: $\phi$ takes each of them to the other.

:::{statement} hu-1987:1-4-line-singular
:title: The other parameter has two singular points
:zh: 两个奇异点
:printed: For $x=y=\phi(t)=10t^3-15t^2+6t$ two singular points are found from $\dot x=0$ and $\dot y=0$: $t=(5\pm\sqrt5)/10$.
:holds-by: singular_parameters_of_the_line
:figure: one_line_two_parameters
:::

:::{claim} singular_parameters_of_the_line
:title: The derivative vanishes at the two printed parameters
:zh: 导数的两个零点
:given: the printed $\phi(t)=\sum_kc_kt^k$ at $t=\frac{p+w}q$, any $w$
:data: c = 0 6 -15 10; p = 5; q = 10; k = 3/10
:instead: q = 9
:then: $\phi'(t)=k\,(w^2-p)$; so $\phi'=0$ exactly for $w=\pm\sqrt p$; at these $\phi(t)=\frac{p-w}q$, the other one of the two
:method: Identities in $w$: $\phi-\frac{p-w}q=\frac{w(w^2-p)}{q^2}$.
:scope: the stated line
:over: w: -
:control: another denominator of $t$
:::
*/
CLAIM(singular_parameters_of_the_line)
{
    num c[4], D[2], w = unknown(T, "w", 0);
    given_points(T, "c", 4, 1, c);
    num p = given(T, "p"), q = given(T, "q"), k = given(T, "k"), t = div(add(p, w), q), zero_at = sub(mul(w, w), p);
    G(power_derivatives)(3, 1, c, t, 1, D);
    same(T, D[1], mul(k, zero_at));
    /* φ - (p - w)/q = w (w² - p)/q² */
    same(T, sub(G(power_sum)(3, 1, c, 0, t), div(sub(p, w), q)), div(mul(w, zero_at), mul(q, q)));
}

/*
The derivative $\phi'$ is positive at both ends and changes its sign at either of the two zeros, so between them it is
negative: the point goes back.  The sentence printed about the motion has lost just this part, as its own word "again"
shows.

:::{statement} hu-1987:1-4-line-motion
:title: How the point moves along the line
:zh: 点沿直线的运动
:printed: On $x=y=\phi(t)=10t^3-15t^2+6t$ the point moves forward along the line from $t=0$ with growing $t$; after $t$ has grown to $t_2=(5+\sqrt5)/10$, it again
  moves on forward along the line until the end, $t=1$.
:refuted-by: point_moves_backward_in_between
:class: misprint
:corrected: The point moves forward on $[0,t_1]$, backward on $[t_1,t_2]$, and forward again on $[t_2,1]$, with
  $t_{1,2}=(5\mp\sqrt5)/10$.
:corrected-by: point_moves_forward_back_and_forward singular_parameters_of_the_line
:meant: the word again (又), which has nothing to refer to as it stands | Between the two motions forward the point moves back, in a clause that is missing.
:figure: one_line_two_parameters
:::
*/

#if RATIONAL
/*
:::{claim} point_moves_backward_in_between
:title: Between the singular points the point moves backward
:zh: 两奇异点之间点后退
:kind: counterexample
:given: the printed $\phi(t)=\sum_kc_kt^k$, and a parameter $t<t_2$
:data: c = 0 6 -15 10; t = 1/2
:instead: t = 1/5
:then: $\phi'(t)$ is negative, so that the point moves backward there
:result: φ'(t) = -3/2
:method: The derivative, exactly; that it is not negative before $t_2$ is refuted.
:control: a parameter before $t_1$
:::
*/
CLAIM(point_moves_backward_in_between)
{
    num c[4], D[2];
    given_points(T, "c", 4, 1, c);
    G(power_derivatives)(3, 1, c, given(T, "t"), 1, D);
    found(T, "φ'(t)", D[1]);
    about(T, "φ'(t), which should not be negative where the point does not move backward");
    nonnegative(T, D[1]);
}

/*
:::{claim} point_moves_forward_back_and_forward
:title: The derivative changes its sign exactly twice
:zh: 导数恰好变号两次
:kind: decision
:given: the printed $\phi(t)=\sum_kc_kt^k$ on $[0,1]$, and three parameters $t$
:data: c = 0 6 -15 10; t = 0 1/2 1
:instead: c = 0 12 -15 10
:then: $\phi'$ is positive at the ends, negative in the middle, and has two roots, both changes of sign, in $(0,1)$
:result: φ'(t) = 6 -3/2 6; numbers of roots, of changes of sign = 2 2
:method: Root counts and values, exactly.
:scope: the stated line
:where: $0\le t\le1$
:control: twice the coefficient of $t$
:::
*/
CLAIM(point_moves_forward_back_and_forward)
{
    num c[4], t[3], slope[3];
    given_points(T, "c", 4, 1, c);
    given_points(T, "t", 3, 1, t);
    poly speed = poly_derivative(poly_from_q(4, c));
    struct cagd_root_count roots = count_roots(speed, from_int(0), from_int(1), OPEN);
    for (int k = 0; k < 3; k++)
        slope[k] = poly_value(speed, t[k]);
    found_points(T, "φ'(t)", 3, 1, slope);
    found_points(T, "numbers of roots, of changes of sign", 2, 1,
                 (num[]){from_int(roots.distinct), from_int(roots.crossings)});
    agree(T, roots.distinct == 2 && roots.crossings == 2);
    agree(T, sign_q(slope[0]) > 0 && sign_q(slope[2]) > 0);
    agree(T, sign_q(slope[1]) < 0);
}
#endif

/*
:::{statement} hu-1987:1-4-many-parameters
:title: A curve has many parameters
:zh: 参数与点的对应多种多样
:printed: For one and the same curve the correspondence between parameters and points can be of many kinds.
:holds-by: segment_has_endlessly_many_parameters
:confirmed-by: cubic_parameter_stays_on_the_segment natural_line_is_regular
:example: one curve has a parameter for every number between -1 and 1.
:figure: one_line_two_parameters
:::

:::{claim} segment_has_endlessly_many_parameters
:title: One segment has a parameter for every number between -1 and 1
:zh: 同一线段的无穷多种参数
:given: $x=y=\phi(t)=t+at(1-t)$ with $-1<a<1$ as $a=1-2q$; any $t$ of $(0,1)$
:then: $\phi(0)=0$, $\phi(1)=1$, $\phi'(t)=2(1-q)(1-t)+2qt>0$, so that the segment from $(0,0)$ to $(1,1)$ is run through once and never back; and
  $\phi(\frac12)=\frac12+\frac a4$, so that no two of these functions are one
:method: Values and derivative by the kernel, $q$ and $t$ variables of $(0,1)$.
:scope: one segment, x = y = t + at(1 − t) with −1 < a < 1
:over: q t: -
:control: the sign of $a$ in the derivative
:::
*/
CLAIM(segment_has_endlessly_many_parameters)
{
    num q = inside(T, "q"), t = inside(T, "t"), zero = from_int(0), one = from_int(1), two = from_int(2);
    num a = sub(one, mul(two, q)), c[3] = {zero, add(one, a), neg(a)}, D[2], at_end[2];
    G(power_derivatives)(2, 1, c, t, 1, D);
    about(T, "the function");
    same(T, D[0], add(t, mul(a, mul(t, sub(one, t)))));
    num p = fault(T, q, sub(one, q));
    about(T, "the derivative");
    same(T, D[1], mul(two, add(mul(sub(one, p), sub(one, t)), mul(p, t))));
    G(must_be_positive)(T, D[1]);
    about(T, "the ends and the middle");
    for (int end = 0; end <= 1; end++) {
        G(power_derivatives)(2, 1, c, from_int(end), 1, at_end);
        same(T, at_end[0], from_int(end));
    }
    G(power_derivatives)(2, 1, c, div(one, two), 1, at_end);
    same(T, at_end[0], add(div(one, two), div(a, from_int(4))));
}

/*
:::{statement} hu-1987:1-4-point
:title: A curve may degenerate to a point
:zh: 曲线退化为一点
:printed: As a special example a curve may degenerate to a point.
:holds-by: constant_curve_is_a_point
:::

:::{claim} constant_curve_is_a_point
:title: With coefficients 0 the curve is a point, singular everywhere
:zh: 退化为点的曲线
:given: any $D$ in space, $A=B=C=0$, any $t$
:then: $P(t)=D$, $P'(t)=0$
:method: The kernel at a variable $t$.
:control: $C=(1,0,0)$
:::
*/
CLAIM(constant_curve_is_a_point)
{
    enum { space = 3 };
    num c[4 * space], D[2 * space], t = parameter(T, "t");
    G(free_points)(T, 0, space, c);
    for (int m = space; m < 4 * space; m++)
        c[m] = from_int(fault(T, 0, m == space));
    G(power_derivatives)(3, space, c, t, 1, D);
    for (int j = 0; j < space; j++) {
        same(T, D[j], c[j]);
        vanishes(T, D[space + j]);
    }
}

#include "chapters/judge/claims_off.h"
