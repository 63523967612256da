/*
# Regular and singular points (正则点与奇异点)

A parameter $t_0$ is regular when $P'(t_0)\ne0$.  It is a property of a parameter, not of a point of the plane, and two
things are often confused with it: that the point set is smooth there, which may hold although $P'=0$, and that the point set
has one tangent, which may fail although $P'\ne0$.
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
:method: All 8 choices of components that are 0; the kernel's square of the norm has only positive coefficients in the others.
  Signs do not matter for squares.
:control: the square of the last component subtracted
:::
*/
/* Compare: a > 0, in the field by its coefficients, the variables being positive; elsewhere it can only be refuted. */
static void G(is_positive)(trial *T, num a)
{
    nonnegative(T, a);
#if FIELD
    agree(T, !is_zero_f(a));
#elif RATIONAL
    agree(T, !is_zero_q(a));
#endif
}

CLAIM(regularity_is_a_sum_of_squares)
{
    for (int present = 0; present < 8; present++) {
        num v[3], sum = from_int(0);
        for (int j = 0; j < 3; j++) {
            v[j] = present >> j & 1 ? positive(T, "v", j) : from_int(0);
            num square = mul(v[j], v[j]);
            sum = fault(T, add(sum, square), j == 2 ? sub(sum, square) : add(sum, square));
        }
        same(T, G(norm_squared)(3, v), sum);
        if (present != 0)
            G(is_positive)(T, G(norm_squared)(3, v));
        else
            vanishes(T, sum);
    }
}

/*
:::{statement} hu-1987:1-4-class
:title: Curves of class r
:zh: 曲线的 C^r 级
:definition: yes
:printed: If all derivatives of $x(t),y(t),z(t)$ of positive order up to $r$ exist and are continuous, and the regularity condition
  holds, the curve is of class $C^r$.
:checked-by: cusp_of_the_example_is_a_cusp
:figure: cusp_and_its_derivative

By this definition the cusp below, whose coordinates are polynomials, is of no class at all at $t=\frac12$.
:::

:::{statement} hu-1987:1-4-unique-tangent
:title: At a regular point there is one tangent
:zh: 正则点处切线唯一
:printed: At regular points of a curve a unique tangent can be determined.
:holds-by: chord_turns_into_the_derivative
:reading: chord_turns_into_the_derivative | A regular point is a parameter, as in the definition: it has one tangent.
:reading: double_point_has_two_tangents | It is a point of the plane: one that is passed twice, at a loop, has a tangent for each passage, though
  both parameters are regular.
:figure: regular_double_point
:::
*/

#if FIELD
/*
:::{claim} chord_turns_into_the_derivative
:title: Chords through a regular point turn into the derivative
:zh: 割线趋于切线
:given: any coefficients of degree $n$ in space, any $t$ and $h\ne0$
:then: $\frac{P(t+h)-P(t)}h$ is a polynomial in $h$ whose value for $h=0$ is $P'(t)$; so the direction of the chord has the limit
  $P'(t)$ from both sides wherever this is not 0
:method: The quotient is formed in the field, $h=0$ put in, and compared with the derivative by the kernel.
:types: field
:degrees: 1..6
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
:given: $P(t)=(t^2-1,t^3-t)$, $t=-1$ and $t=1$
:then: both parameters give the origin, $P'(-1)=(-2,2)$ and $P'(1)=(2,2)$ are not 0, and not parallel
:method: The points and derivatives by the kernel; that the two directions are one is refuted.
:control: $t=1$ twice
:::
*/
CLAIM(double_point_has_two_tangents)
{
    num c[8] = {from_int(-1), from_int(0), from_int(0), from_int(-1),
                from_int(1),  from_int(0), from_int(0), from_int(1)};
    num D[2][4];
    for (int side = 0; side < 2; side++)
        G(power_derivatives)(3, dim, c, from_int(fault(T, 1, side ? 1 : -1)), 1, D[side]);
    show_points(T, "the points", 2, 2, (num[]){D[0][0], D[0][1], D[1][0], D[1][1]});
    show_points(T, "P' at both", 2, 2, (num[]){D[0][2], D[0][3], D[1][2], D[1][3]});
    about(T, "whether the points differ, or a derivative is 0, or the derivatives are parallel");
    int different = !equal_q(D[0][0], D[1][0]) || !equal_q(D[0][1], D[1][1]);
    int singular = is_zero_q(G(norm_squared)(2, D[0] + 2)) || is_zero_q(G(norm_squared)(2, D[1] + 2));
    refute(T, !different && !singular && !is_zero_q(G(cross2)(D[0] + 2, D[1] + 2)));
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
:printed: At the cusp $\dot P(t)$ is the zero vector, that is $\dot x=0$, $\dot y=0$.
:holds-by: cusp_of_the_example_is_a_cusp
:figure: cusp_and_its_derivative
:::
*/

/* D, C, B, A of the example. */
static void G(cusp_curve)(int square, num c[])
{
    const int coefficients[8] = {0, 0, 3, 3, square, -3, 4, 0};
    for (int m = 0; m < 8; m++)
        c[m] = from_int(coefficients[m]);
}

/*
:::{claim} cusp_of_the_example_is_a_cusp
:title: The curve of the example is a semicubical parabola
:zh: 例中曲线为半立方抛物线
:given: $t=\frac12+u$, any $u$
:then: $x-\frac12=4u^3$ and $y-\frac34=-3u^2$, so $(x-\frac12)^2=-\frac{16}{27}(y-\frac34)^3$; $P'=(12u^2,-6u)$ is 0 exactly for $u=0$, and
  its direction $(2u,-1)$ times the sign of $u$ turns over there
:method: The polynomials as printed, at a variable $u$, and their derivatives by the kernel.
:control: the coefficient $-5$ in the place of $-6$
:::
*/
CLAIM(cusp_of_the_example_is_a_cusp)
{
    num c[8], D[4], u = unknown(T, "u", 0), half = from_ratio(1, 2);
    G(cusp_curve)(fault(T, -6, -5), c);
    G(power_derivatives)(3, dim, c, add(half, u), 1, D);
    num x = sub(D[0], half), y = sub(D[1], from_ratio(3, 4)), uu = mul(u, u);
    same(T, x, mul(from_int(4), mul(u, uu)));
    same(T, y, mul(from_int(-3), uu));
    same(T, mul(x, x), mul(from_ratio(-16, 27), G(power)(y, 3)));
    same(T, D[2], mul(from_int(12), uu));
    same(T, D[3], mul(from_int(-6), u));
}

/*
:::{statement} hu-1987:1-4-cusp-continuity
:title: At the cusp the derivative is discontinuous
:zh: 尖点处导矢不连续
:printed: At the cusp $\dot P(t)$ will be discontinuous and equal to the zero vector.
:refuted-by: derivative_is_continuous_at_the_cusp
:class: false
:corrected: $\dot P$ is continuous, as polynomials are, and zero at the cusp; the unit tangent $\dot P/|\dot P|$ has no limit there: it jumps
  from $(0,1)$ to $(0,-1)$.
:corrected-by: unit_tangent_jumps_at_the_cusp
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
:given: the curve of the example, $t=\frac12+u$
:then: $x'=12u^2$ and $y'=-6u$ as polynomials in $u$; their limits for $u\to0$ from either side are their values there, $(0,0)$
:method: The limits of a polynomial from both sides are its constant coefficient; that one of them differs from $P'(\frac12)$ is
  refuted.
:control: the signs of $y'$ taken as its values
:::
*/
CLAIM(derivative_is_continuous_at_the_cusp)
{
    num c[8], at[2], x[3], y[3];
    G(cusp_curve)(-6, c);
    for (int k = 0; k < 3; k++) {
        x[k] = mul(from_int(k + 1), c[2 * (k + 1)]);
        y[k] = mul(from_int(k + 1), c[2 * (k + 1) + 1]);
    }
    poly shift = poly_add(poly_variable(), poly_constant(from_ratio(1, 2)));
    poly dx = poly_compose(poly_from_q(3, x), shift), dy = poly_compose(poly_from_q(3, y), shift);
    at[0] = poly_value(poly_from_q(3, x), from_ratio(1, 2));
    at[1] = poly_value(poly_from_q(3, y), from_ratio(1, 2));
    show_text(T, "x', y'", "%s, %s", poly_to_string(dx, "u"), poly_to_string(dy, "u"));
    show_points(T, "P' at the cusp", 1, 2, at);
    num sign_from_the_left = neg(from_int(sign_q(poly_coefficient(dy, 1)))); /* of y' */
    num limit = fault(T, sign_from_the_left, poly_coefficient(dy, 0));
    about(T, "whether a one-sided limit of P' differs from P' at the cusp");
    refute(T, equal_q(poly_coefficient(dx, 0), at[0]) && equal_q(limit, at[1]));
}
#endif

/*
:::{claim} unit_tangent_jumps_at_the_cusp
:title: The unit tangent turns over at the cusp
:zh: 单位切矢在尖点处反向
:given: the curve of the example at $t=\frac12-u$ and $t=\frac12+u$, $u>0$
:then: $P'=6u\,(2u,1)$ before and $P'=6u\,(2u,-1)$ after; the factors $6u$ are positive, and the directions tend to $(0,1)$ and
  $(0,-1)$ with $u$
:method: Identities in $u$.
:control: the same direction on both sides
:::
*/
CLAIM(unit_tangent_jumps_at_the_cusp)
{
    num c[8], D[4], u = positive(T, "u", 0), half = from_ratio(1, 2), factor = mul(from_int(6), u);
    G(cusp_curve)(-6, c);
    for (int side = -1; side <= 1; side += 2) {
        G(power_derivatives)(3, dim, c, add(half, mul(from_int(side), u)), 1, D);
        same(T, D[2], mul(factor, mul(from_int(2), u)));
        same(T, D[3], mul(factor, from_int(fault(T, -side, -1))));
    }
}

/*
:::{statement} hu-1987:1-4-singular-anomalies
:title: At singular points all kinds of anomalies appear
:zh: 奇异点处出现异常情况
:printed: At singular points, however, all kinds of abnormal cases will appear.
:holds-by: cusp_of_the_example_is_a_cusp point_moves_forward_back_and_forward
:hypothesis: singular_point_of_a_plain_segment | No other parameter makes the curve regular and runs in the same sense: otherwise the point only
  stands still for a moment, and nothing is seen.
:figure: singular_point_of_a_segment

The source's own anomalies are a change of direction: at the cusp, and twice on the line that follows.
:::
*/

#if RATIONAL
/*
:::{claim} singular_point_of_a_plain_segment
:title: A segment run once and forward, with a singular point in the middle
:zh: 含奇异点的普通线段
:kind: counterexample
:given: $x=y=\phi_1(t)=4t^3-6t^2+3t$, the abscissa of the example with the cusp
:then: $\phi_1'=3(2t-1)^2$: the curve is singular at $t=\frac12$ only, runs from $(0,0)$ to $(1,1)$ once and never back, and has the tangent $(1,1)$
  everywhere
:method: $\phi_1$ at the ends, the sign of $\phi_1'$ and its zeros on $[0,1]$ by root counts; that it is singular nowhere, or goes back somewhere,
  is refuted.
:control: the line that follows, $10t^3-15t^2+6t$
:::
*/
CLAIM(singular_point_of_a_plain_segment)
{
    static const int coefficients[2][4] = {{0, 3, -6, 4}, {0, 6, -15, 10}};
    num c[4], zero = from_int(0), one = from_int(1);
    for (int k = 0; k < 4; k++)
        c[k] = from_int(coefficients[fault(T, 1, 0)][k]);
    poly run = poly_from_q(4, c), speed = poly_derivative(run);
    int whole_segment = is_zero_q(poly_value(run, zero)) && equal_q(poly_value(run, one), one);
    int singular = count_roots(speed, zero, one, CLOSED).distinct;
    show_text(T, "x = y", "%s", poly_to_string(run, "t"));
    show_text(T, "x' = y'", "%s", poly_to_string(speed, "t"));
    show_text(T, "singular parameters in [0,1]", "%d", singular);
    about(T, "a point being singular, whether the curve goes back somewhere");
    refute(T, whole_segment && singular != 0 && sign_on(speed, zero, one, CLOSED) == SIGN_NONNEGATIVE);
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
:given: $x=y=t$, any $t$
:then: $P'=(1,1)$
:method: The kernel at a variable $t$.
:control: $x=y=t^2$
:::
*/
CLAIM(natural_line_is_regular)
{
    num c[6], D[4], t = parameter(T, "t");
    for (int m = 0; m < 6; m++)
        c[m] = from_int(m / 2 == fault(T, 1, 2));
    G(power_derivatives)(2, dim, c, t, 1, D);
    for (int j = 0; j < dim; j++)
        same(T, D[dim + j], from_int(1));
}

/*
:::{statement} hu-1987:1-4-line-same
:title: The cubic parameter describes the same line
:zh: 同一条直线的另一参数
:printed: $x=y=\phi(t)=10t^3-15t^2+6t$ represents the same curve as $x=y=t$.
:holds-by: cubic_parameter_stays_on_the_segment
:figure: one_line_two_parameters
:::
*/

#if RATIONAL
/*
:::{claim} cubic_parameter_stays_on_the_segment
:title: The other parameter covers the segment and nothing else
:zh: 另一参数恰好走遍线段
:kind: decision
:given: $\phi=10t^3-15t^2+6t$ on $[0,1]$
:then: $\phi(0)=0$, $\phi(1)=1$, $0\le\phi\le1$: by continuity the same segment; moreover $\phi(1-t)=1-\phi(t)$
:method: Signs of $\phi$ and $1-\phi$ on the interval by root counts; the symmetry as polynomials.
:scope: t from 0 to 1
:control: the coefficient 7 in the place of 6
:::
*/
CLAIM(cubic_parameter_stays_on_the_segment)
{
    num c[4] = {from_int(0), from_int(fault(T, 6, 7)), from_int(-15), from_int(10)}, zero = from_int(0),
        one = from_int(1);
    poly phi = poly_from_q(4, c), rest = poly_sub(poly_constant(one), phi);
    poly back = poly_compose(phi, poly_sub(poly_constant(one), poly_variable()));
    agree(T, is_zero_q(poly_value(phi, zero)) && equal_q(poly_value(phi, one), one));
    agree(T,
          sign_on(phi, zero, one, CLOSED) == SIGN_NONNEGATIVE && sign_on(rest, zero, one, CLOSED) == SIGN_NONNEGATIVE);
    agree(T, poly_equal(back, rest));
}
#endif

/*
:::{statement} hu-1987:1-4-line-singular
:title: The other parameter has two singular points
:zh: 两个奇异点
:printed: From $\dot x=0$ and $\dot y=0$ two singular points are found: $t=(5\pm\sqrt5)/10$.
:holds-by: singular_parameters_of_the_line
:figure: one_line_two_parameters
:::

:::{claim} singular_parameters_of_the_line
:title: The derivative vanishes at the two printed parameters
:zh: 导数的两个零点
:given: $t=\frac{5+w}{10}$
:then: $\phi'(t)=\frac3{10}(w^2-5)$; so $\phi'=0$ exactly for $w=\pm\sqrt5$; at these $\phi(t)=\frac{5-w}{10}$, the other one of the two
:method: Identities in $w$: $\phi-\frac{5-w}{10}=\frac{w(w^2-5)}{100}$.
:control: $\frac{5+w}9$
:::
*/
/* 10 t^3 - 15 t^2 + 6 t */
static num G(phi)(num t)
{
    num c[4] = {from_int(0), from_int(6), from_int(-15), from_int(10)};
    return G(power_sum)(3, 1, c, 0, t);
}

CLAIM(singular_parameters_of_the_line)
{
    num w = unknown(T, "w", 0), five = from_int(5), ten = from_int(10),
        t = div(add(five, w), fault(T, ten, from_int(9)));
    num c[4] = {from_int(0), from_int(6), from_int(-15), from_int(10)}, D[2], zero_at = sub(mul(w, w), five);
    G(power_derivatives)(3, 1, c, t, 1, D);
    same(T, D[1], mul(from_ratio(3, 10), zero_at));
    same(T, sub(G(phi)(t), div(sub(five, w), ten)), div(mul(w, zero_at), from_int(100)));
}

/*
:::{statement} hu-1987:1-4-line-motion
:title: How the point moves along the line
:zh: 点沿直线的运动
:printed: From $t=0$ the point moves forward along the line with growing $t$; after $t$ has grown to $t_2=(5+\sqrt5)/10$, it continues to
  move forward until $t=1$.
:refuted-by: point_moves_backward_in_between
:class: misprint
:corrected: The point moves forward on $[0,t_1]$, backward on $[t_1,t_2]$, and forward again on $[t_2,1]$, with
  $t_{1,2}=(5\mp\sqrt5)/10$.
:corrected-by: point_moves_forward_back_and_forward
:figure: one_line_two_parameters

A clause about the way back, between the two singular points, is missing; the word "again" at the end of the sentence still
refers to it.
:::
*/

#if RATIONAL
/*
:::{claim} point_moves_backward_in_between
:title: Between the singular points the point moves backward
:zh: 两奇异点之间点后退
:kind: counterexample
:given: $\phi=10t^3-15t^2+6t$, $t=\frac12<t_2$
:then: $\phi'(\frac12)=-\frac32$
:method: The derivative, exactly; that it is not negative before $t_2$ is refuted.
:control: $t=\frac15<t_1$
:::
*/
CLAIM(point_moves_backward_in_between)
{
    num c[4] = {from_int(0), from_int(6), from_int(-15), from_int(10)}, D[2];
    G(power_derivatives)(3, 1, c, fault(T, from_ratio(1, 5), from_ratio(1, 2)), 1, D);
    show(T, "φ'", D[1]);
    about(T, "whether the point does not move backward");
    nonnegative(T, D[1]);
}

/*
:::{claim} point_moves_forward_back_and_forward
:title: The derivative changes its sign exactly twice
:zh: 导数恰好变号两次
:kind: decision
:given: $\phi'=6(5t^2-5t+1)$ on $[0,1]$
:then: it is positive at 0 and at 1, negative at $\frac12$, and has two roots, both changes of sign, in $(0,1)$
:method: Root counts and values, exactly.
:scope: t from 0 to 1
:control: the constant 2 in the place of 1
:::
*/
CLAIM(point_moves_forward_back_and_forward)
{
    num c[3] = {from_int(fault(T, 1, 2)), from_int(-5), from_int(5)}, zero = from_int(0), one = from_int(1);
    poly speed = poly_from_q(3, c);
    struct cagd_root_count roots = count_roots(speed, zero, one, OPEN);
    agree(T, roots.distinct == 2 && roots.crossings == 2);
    agree(T, sign_q(poly_value(speed, zero)) > 0 && sign_q(poly_value(speed, one)) > 0);
    agree(T, sign_q(poly_value(speed, from_ratio(1, 2))) < 0);
}
#endif

/*
:::{statement} hu-1987:1-4-many-parameters
:title: A curve has many parameters
:zh: 参数与点的对应多种多样
:printed: For one and the same curve the correspondence between parameters and points can be of many kinds.
:holds-by: cubic_parameter_stays_on_the_segment natural_line_is_regular
:figure: one_line_two_parameters
:::

:::{statement} hu-1987:1-4-point
:title: A curve may degenerate to a point
:zh: 曲线退化为一点
:printed: As a special example a curve may degenerate to a point.
:holds-by: constant_curve_is_a_point
:::

:::{claim} constant_curve_is_a_point
:title: With coefficients 0 the curve is a point, singular everywhere
:zh: 退化为点的曲线
:given: any $D$, $A=B=C=0$, any $t$
:then: $P(t)=D$, $P'(t)=0$
:method: The kernel at a variable $t$.
:control: $C=(1,0)$
:::
*/
CLAIM(constant_curve_is_a_point)
{
    num c[8], D[4], t = parameter(T, "t");
    for (int m = 0; m < 8; m++)
        c[m] = m < 2 ? unknown(T, "x", m) : from_int(fault(T, 0, m == 2));
    G(power_derivatives)(3, dim, c, t, 1, D);
    for (int j = 0; j < dim; j++) {
        same(T, D[j], c[j]);
        vanishes(T, D[dim + j]);
    }
}

#include "chapters/judge/claims_off.h"
