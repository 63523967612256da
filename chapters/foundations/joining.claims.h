/*
# Joining curves (曲线段的连接)

Two pieces that meet in a point may look like one curve although their parameters know nothing of each other.  The source
gives three conditions at the joint, of order 0, 1 and 2.  What they guarantee together is one sentence: after a change of
the parameter on the second piece the two are one curve with continuous derivatives up to that order.
*/
#include "chapters/foundations/definition.h"

#if RATIONAL
#include "exact/record/sign.h"
#endif

#include "chapters/judge/claims_on.h"

enum { dim = 2, space = 3 };

/*
:::{statement} hu-1987:1-2-class-names
:title: Continuity of position, slope and curvature is called C0, C1, C2
:zh: 位置、斜率、曲率连续与 C0、C1、C2
:printed: In general the pieces should reach continuity of position, slope and curvature, called $C^0$, $C^1$, $C^2$ continuity, as the case demands.
:reading: continuous_slope_with_another_speed | where position and slope are continuous at a joint the curve is $C^1$ there, as section 1-4 of the same book defines it, with
  continuous derivatives, in the parameters that the pieces have
:reading: conditions_make_one_curve_in_another_parameter | where position, slope and curvature are continuous at a joint the curve is $C^0$, $C^1$, $C^2$ there after a change of the
  parameter of one piece, slope and curvature being the unit tangent and the vector of curvature
:reading-with: equal_unit_tangents_fix_the_ratio curvature_vector_forces_the_condition second_derivative_splits_along_the_first
  curvature_vector_is_the_turning_of_the_tangent
:reading: $C^0$, $C^1$, $C^2$ are here no more than names of the three properties, by the word "called" (称为): a choice of words, of which nothing is to be
  decided
:figure: joints_of_order
:::
*/

#if RATIONAL
static int same_point(const num P[], const num Q[]) { return equal_q(P[0], Q[0]) && equal_q(P[1], Q[1]); }

/*
:::{claim} continuous_slope_with_another_speed
:title: A straight joint with a jump of the derivative
:zh: 斜率连续而导矢不连续
:kind: counterexample
:given: two pieces of one straight line, $P_{\mathrm I}$ and $P_{\mathrm{II}}$, by their coefficients of $1,t,t^2,\dots$
:data: P_I = (0,0) (1,0); P_II = (1,0) (2,0)
:instead: P_II = (1,0) (1,0)
:then: the pieces meet and both slopes are 0, but $P_{\mathrm I}'(1)\ne P_{\mathrm{II}}'(0)$
:result: P_I(1), P_I'(1) = (1,0) (1,0); P_II(0), P_II'(0) = (1,0) (2,0)
:method: The derivatives of both, by the kernel.
:control: a second piece of the same speed
:::
*/
CLAIM(continuous_slope_with_another_speed)
{
    num first[4], second[4], D[4], E[4];
    given_points(T, "P_I", 2, 2, first);
    given_points(T, "P_II", 2, 2, second);
    G(power_derivatives)(1, dim, first, from_int(1), 1, D);
    G(power_derivatives)(1, dim, second, from_int(0), 1, E);
    found_points(T, "P_I(1), P_I'(1)", 2, 2, D);
    found_points(T, "P_II(0), P_II'(0)", 2, 2, E);
    int smooth = same_point(D, E) && is_zero_q(div(D[3], D[2])) && is_zero_q(div(E[3], E[2]));
    about(T, "position and slope being the same, whether the derivatives are the same");
    refute(T, smooth && !equal_q(D[2], E[2]));
}
#endif

/*
The names are the first trap.  A derivative is a property of the parameter, a slope is one of the curve, and a joint can
be straight although the speed jumps.  What is meant by a continuous slope is that some other parameter would make the
derivative continuous; the three conditions of the source say what this requires of the derivatives at hand.

## Order 0, 1, 2

:::{statement} hu-1987:1-5-1
:title: The condition for continuous position
:zh: 位置连续条件
:printed: P_x(0)=P_x(1)
:refuted-by: joined_pieces_are_not_closed
:class: misprint
:corrected: P_{\mathrm{II}}(0)=P_{\mathrm I}(1)
:corrected-by: quotient_of_a_power_tends_to_its_derivative polynomial_without_constant_is_small_near_zero
:confirmed-by: pieces_tend_to_their_ends
:figure: joined_and_closed

One letter stands for both curves; the condition printed is that of one closed curve.

For polynomials $P_{\mathrm{I}}(1-u)-P_{\mathrm{I}}(1)$ is by `quotient_of_a_power_tends_to_its_derivative`, with $t=1$ and $h=-u$, a polynomial in $u$ without
a constant, and so is $P_{\mathrm{II}}(u)-P_{\mathrm{II}}(0)$.  Both are small near 0 by `polynomial_without_constant_is_small_near_zero`: the pieces tend to
$P_{\mathrm{I}}(1)$ and $P_{\mathrm{II}}(0)$, and position is continuous exactly where these are equal.
:::

:::{claim} pieces_tend_to_their_ends
:title: At the joint the two pieces tend to P_I(1) and P_II(0)
:zh: 两段曲线在连接点处的极限
:given: two curves of degree $n$ in the plane, any $u$; $c_0,\dots,c_n$ the coefficients of the first, $q_k=c_{k+1}+\dots+c_n$
:then: $P_{\mathrm I}(1-u)-P_{\mathrm I}(1)=-u\sum_{k<n}q_k(1-u)^k$, and $P_{\mathrm{II}}(u)-P_{\mathrm{II}}(0)=u\sum_{k<n}d_{k+1}u^k$ with the coefficients $d$ of the
  second; so both tend to 0 with $u$, and position is continuous exactly where $P_{\mathrm{II}}(0)=P_{\mathrm I}(1)$
:method: The points by the kernel, the values at the joint and the quotients by sums of powers; everything a variable.
:degrees: 1..6 sampled 12
:argued: all polynomials | A polynomial less its value at a place is divisible by the distance from it.
:over: x# y#: coefficients; v#: coefficients; u
:control: the first coefficient taken for the first quotient
:::
*/
CLAIM(pieces_tend_to_their_ends)
{
    int n = T->degree;
    num c[(MAX_DEGREE + 1) * dim], d[(MAX_DEGREE + 1) * dim], q[MAX_DEGREE * dim], before[dim], after[dim];
    num u = parameter(T, "u"), one = from_int(1), back = sub(one, u);
    G(free_points)(T, n, dim, c);
    for (int k = 0; k < (n + 1) * dim; k++)
        d[k] = unknown(T, "v", k);
    for (int k = n - 1; k >= 0; k--)
        for (int j = 0; j < dim; j++)
            q[k * dim + j] = k + 1 < n ? add(c[(k + 1) * dim + j], q[(k + 1) * dim + j]) : c[(k + 1) * dim + j];
    G(power_point)(n, dim, c, back, before);
    G(power_point)(n, dim, d, u, after);
    for (int j = 0; j < dim; j++) {
        q[j] = fault(T, q[j], c[j]);
        about(T, "the first piece");
        same(T, sub(before[j], G(power_sum)(n, dim, c, j, one)), neg(mul(u, G(power_sum)(n - 1, dim, q, j, back))));
        about(T, "the second piece");
        same(T, sub(after[j], d[j]), mul(u, G(power_sum)(n - 1, dim, d + dim, j, u)));
    }
}

#if RATIONAL
/*
:::{claim} joined_pieces_are_not_closed
:title: Two segments in a row are joined, and neither is closed
:zh: 相连的两段并不自闭
:kind: counterexample
:given: two segments in a row, $P_{\mathrm I}$ and $P_{\mathrm{II}}$, by their coefficients of $1,t,t^2,\dots$
:data: P_I = (0,0) (1,0); P_II = (1,0) (1,0)
:then: $P_{\mathrm{II}}(0)=P_{\mathrm I}(1)$, but $P(0)\ne P(1)$ for both
:result: P_I(0), P_I(1) = (0,0) (1,0); P_II(0), P_II(1) = (1,0) (2,0)
:method: The points at the ends, exactly.
:control: the condition between the two curves
:::
*/
CLAIM(joined_pieces_are_not_closed)
{
    num c[2][4], ends[2][4];
    given_points(T, "P_I", 2, 2, c[0]);
    given_points(T, "P_II", 2, 2, c[1]);
    for (int piece = 0; piece < 2; piece++)
        for (int end = 0; end < 2; end++)
            G(power_point)(1, dim, c[piece], from_int(end), ends[piece] + end * dim);
    found_points(T, "P_I(0), P_I(1)", 2, 2, ends[0]);
    found_points(T, "P_II(0), P_II(1)", 2, 2, ends[1]);
    int joined = same_point(ends[0] + dim, ends[1]), first_is_closed = same_point(ends[0], ends[0] + dim);
    int condition = same_point(ends[1], fault(T, ends[0] + dim, ends[1] + dim));
    about(T, "the pieces being joined, whether one of them satisfies the condition");
    refute(T, joined && !first_is_closed && !condition);
}
#endif

#if FIELD
/*
:::{claim} conditions_make_one_curve_in_another_parameter
:title: The conditions are those of one smooth curve in another parameter
:zh: 连接条件等价于适当参数下的光滑性
:given: $P,P',P''$ of the first piece at the joint, $\lambda>0$, any $\beta$; $P_{\mathrm{II}}$ with $P$, $\lambda P'$,
  $\lambda^2P''+\beta P'$ and any third derivative
:where: $\lambda>0$
:then: $S(u)=P_{\mathrm{II}}(\phi(u))$ with $\phi(u)=\frac u\lambda-\frac\beta{2\lambda^3}u^2$ has $S(0)=P$, $S'(0)=P'$, $S''(0)=P''$
:method: $S$ is formed as a polynomial in $u$ from the cubic $P_{\mathrm{II}}$; its derivatives at 0 are compared, everything a
  variable.  A further term of $P_{\mathrm{II}}$ has the factor $\phi^3$, so $u^3$, and changes none of them.  As $\phi(0)=0$ and $\phi'(0)=\frac1\lambda>0$, $\phi$ is a
  change of the parameter near the joint.
:types: field
:over: p#: points; v# w# z#: derivatives; l: λ; b: β; u
:control: $\phi(u)=\frac u\lambda$
:::
*/
CLAIM(conditions_make_one_curve_in_another_parameter)
{
    num u = variable_f("u"), lambda = variable_f("l"), beta = variable_f("b"), half = from_ratio(1, 2);
    num bend = div(mul(half, beta), G(power)(lambda, 3)),
        phi = fault(T, sub(div(u, lambda), mul(bend, mul(u, u))), div(u, lambda));
    for (int j = 0; j < space; j++) {
        num P = unknown(T, "p", j), d1 = unknown(T, "v", j), d2 = unknown(T, "w", j);
        num second = mul(half, add(mul(mul(lambda, lambda), d2), mul(beta, d1)));
        num c[4] = {P, mul(lambda, d1), second, unknown(T, "z", j)};
        num Q = G(power_sum)(3, 1, c, 0, phi), wanted[3] = {P, d1, d2};
        for (int k = 0; k < 3; k++, Q = derivative_f(Q, u))
            same(T, substitute_f(Q, u, from_int(0)), wanted[k]);
    }
}
#endif

/*
The second piece is followed with the parameter $\phi(u)$ in the place of $u$, and the chain rule is read backwards: the
first derivative of $\phi$ can undo one factor $\lambda$, the second one can undo one multiple $\beta$ of the tangent.
So each of the two orders brings one free number, and no more.  With this sentence in mind the conditions need not be
learned by heart.

:::{statement} hu-1987:1-5-2
:title: The condition for continuous slope
:zh: 斜率连续条件
:printed: As the unit tangent vectors are equal, the condition to be satisfied is $\dot P_x(0)=\frac{\alpha_2}{\alpha_1}\dot P_{\mathrm I}(1)=\lambda\,\dot P_{\mathrm I}(1)$,
  $\lambda=\frac{\alpha_2}{\alpha_1}$, where $\alpha_1,\alpha_2$ are the lengths of the tangent vectors of $P_{\mathrm I}$
  and $P_{\mathrm{II}}$ at the joint.
:holds-by: equal_unit_tangents_fix_the_ratio
:needs: negative_ratio_turns_back | the line itself, where $\lambda$ is the quotient of the lengths of tangent vectors | $\lambda>0$; as for a quotient
  of lengths: with $\lambda<0$ the curve turns on its heel.
:needs: singular_end_has_no_ratio | the line itself, with unit tangent vectors of both pieces | neither derivative is 0 at the
  joint; as where there are unit tangent vectors: with $\dot P_{\mathrm I}(1)=0$ the tangents may be one although there is no $\lambda$, and with
  $\dot P_{\mathrm{II}}(0)=0$ alone $\lambda=0$, whatever the tangents are.
:meant: the other side of the equation, which is about the first piece, I | The index $x$ is II, that of the second piece.
:figure: joints_of_order
:::

:::{claim} equal_unit_tangents_fix_the_ratio
:title: Equal unit tangents mean derivatives in the ratio of their lengths
:zh: 单位切矢相等的充要条件
:given: a vector $U$ of space, $\alpha_1,\alpha_2>0$, $\lambda=\frac{\alpha_2}{\alpha_1}$; the condition
  $\dot P_{\mathrm{II}}=\lambda\dot P_{\mathrm I}$
:where: neither derivative is 0 at the joint
:harmless: $\alpha_1,\alpha_2>0$ | the lengths of derivatives that are not 0
:then: $\dot P_{\mathrm I}=\alpha_1U$ and $\dot P_{\mathrm{II}}=\alpha_2U$ satisfy the condition; conversely, the condition makes
  $\dot P_{\mathrm{II}}/\alpha_2=\dot P_{\mathrm I}/\alpha_1$, and $|\dot P_{\mathrm{II}}|=\lambda|\dot P_{\mathrm I}|$
:method: Identities in $U$, $\alpha_1$, $\alpha_2$ and $\dot P_{\mathrm I}$.
:over: a#: -; u# v#: derivatives
:control: $\lambda$ inverted
:::
*/
CLAIM(equal_unit_tangents_fix_the_ratio)
{
    num first = positive(T, "a", 1), second = positive(T, "a", 2), U[space], V[space], W[space];
    num lambda = fault(T, div(second, first), div(first, second));
    for (int j = 0; j < space; j++) {
        U[j] = unknown(T, "u", j);
        same(T, mul(second, U[j]), mul(lambda, mul(first, U[j])));
        V[j] = unknown(T, "v", j);
        W[j] = mul(lambda, V[j]);
        same(T, div(W[j], second), div(V[j], first));
    }
    same(T, G(norm_squared)(space, W), mul(mul(lambda, lambda), G(norm_squared)(space, V)));
}

#if RATIONAL
/*
:::{claim} negative_ratio_turns_back
:title: With a negative ratio the slope is continuous and the curve goes back
:zh: 负比值使曲线折返
:kind: counterexample
:given: a first piece $P_{\mathrm I}$, by its coefficients of $1$ and $t$, and $\dot P_{\mathrm{II}}(0)=\lambda\,\dot P_{\mathrm I}(1)$
:data: P_I = (0,0) (1,0); λ = -1
:instead: λ = 2
:then: the unit tangents of the two pieces are not equal
:result: unit tangents = (1,0) (-1,0)
:method: Both, exactly.
:control: a positive $\lambda$
:::
*/
CLAIM(negative_ratio_turns_back)
{
    num c[4], D[4], unit[4];
    given_points(T, "P_I", 2, 2, c);
    num lambda = given(T, "λ");
    G(power_derivatives)(1, dim, c, from_int(1), 1, D);
    num after[2] = {mul(lambda, D[2]), mul(lambda, D[3])};
    for (int j = 0; j < dim; j++) {
        unit[j] = div(D[dim + j], root(2, G(norm_squared)(dim, D + dim)));
        unit[dim + j] = div(after[j], root(2, G(norm_squared)(dim, after)));
    }
    found_points(T, "unit tangents", 2, 2, unit);
    about(T, "the coordinates of the unit tangents");
    for (int j = 0; j < dim; j++)
        same(T, unit[dim + j], unit[j]);
}

/*
:::{claim} singular_end_has_no_ratio
:title: At a singular end of a straight piece no positive ratio satisfies the condition
:zh: 奇异端点处条件失效
:kind: counterexample
:given: two pieces that run forward along the $x$-axis and meet, $P_{\mathrm I}$ and $P_{\mathrm{II}}$, and two others, $R_{\mathrm I}$ and
  $R_{\mathrm{II}}$, by their coefficients of $1,t,t^2,\dots$
:data: P_I = (-1,0) (2,0) (-1,0); P_II = (0,0) (1,0) (0,0); R_I = (-1,0) (1,0) (0,0); R_II = (0,0) (0,0) (1,0)
:instead: P_I = (-1,0) (1,0) (0,0); R_II = (0,0) (1,0) (0,0)
:then: $\dot P_{\mathrm I}(1)$ is 0, and $\dot P_{\mathrm{II}}(0)$ is no multiple of it; and $\dot R_{\mathrm{II}}(0)$ is 0, so that it is a multiple of
  $\dot R_{\mathrm I}(1)$ with the factor 0 only; yet there is no corner, $y=0$ and $x'>0$ on $(0,1)$ for every piece
:result: P_I'(1) = (0,0); P_II'(0) = (1,0); R_I'(1) = (1,0); R_II'(0) = (0,0)
:method: The points and derivatives at the joint by the kernel; the sign of $x'$ on $(0,1)$, exactly.
:control: every piece with its natural parameter
:::
*/
/* Whether the curve runs forward along this axis: the derivative of its coordinate is positive on (0,1), that of the other 0. */
static int runs_forward(int degree, const num c[], int axis)
{
    num along[MAX_DEGREE + 1];
    int straight = 1;
    for (int k = 0; k <= degree; k++) {
        along[k] = c[dim * k + axis];
        straight &= k == 0 || is_zero_q(c[dim * k + 1 - axis]);
    }
    poly speed = poly_derivative(poly_from_q(degree + 1, along));
    return straight && sign_on(speed, from_int(0), from_int(1), OPEN) == SIGN_POSITIVE;
}

CLAIM(singular_end_has_no_ratio)
{
    static const char *const piece[4] = {"P_I", "P_II", "R_I", "R_II"}, *const slope[4] = {"P_I'(1)", "P_II'(0)",
                                                                                           "R_I'(1)", "R_II'(0)"};
    num c[6], D[4][4];
    int forward = 1;
    for (int k = 0; k < 4; k++) {
        given_points(T, piece[k], 3, 2, c);
        forward &= runs_forward(2, c, 0);
        G(power_derivatives)(2, dim, c, from_int(k % 2 == 0), 1, D[k]);
    }
    for (int k = 0; k < 4; k++)
        found_points(T, slope[k], 1, 2, D[k] + dim);
    int no_ratio = is_zero_q(D[0][2]) && !is_zero_q(D[1][2]), ratio_is_zero = !is_zero_q(D[2][2]) && is_zero_q(D[3][2]);
    int joined = same_point(D[0], D[1]) && same_point(D[2], D[3]);
    about(T, "there being no corner, whether P' of a second piece is a multiple of that of the first, with a factor "
             "that is not 0");
    refute(T, forward && joined && no_ratio && ratio_is_zero);
}
#endif

/*
The ratio must be a quotient of lengths, and this hides three exclusions: it is positive, it is not 0, and it exists.
Each of them is tried in this section, and each fails in its own way.  With a negative ratio the curve turns on its
heel, without one a straight line violates the condition, and with the ratio 0 the condition of order two allows a
curvature that grows without bound.

:::{statement} hu-1987:1-5-3-sufficient
:title: The condition of order two makes the curvature continuous
:zh: 曲率连续的充分条件
:printed: Condition for a continuous curvature (曲率连续条件), after those for position and slope: $\ddot P_x(0)=\bigl(\frac{\alpha_2}{\alpha_1}\bigr)^2\ddot P_{\mathrm
  I}(1)+\beta\dot P_{\mathrm I}(1)=\lambda^2\ddot P_{\mathrm I}(1)+\beta\dot P_{\mathrm I}(1)$
:holds-by: condition_keeps_the_curvature_vector curvature_vector_is_the_turning_of_the_tangent
:needs: zero_ratio_has_unbounded_curvature | (1-5-2), with unit tangent vectors and lengths of tangent vectors | $\lambda\ne0$; as
  for a quotient of lengths of vectors with directions: with $\alpha_2=0$ the curvature of the second piece need not be bounded.
:needs: vanishing_derivatives_hide_a_jump_of_curvature | (1-5-2), with unit tangent vectors and lengths of tangent vectors | $\dot P_{\mathrm
  I}(1)\ne0$; as where there is a unit tangent vector.
:meant: the other side of the equation, which is about the first piece, I | The index $x$ is II, that of the second piece.
:figure: joints_of_order

Decided is that the condition suffices.
:::

:::{statement} hu-1987:1-5-3-beta
:title: The factor of the tangent is free
:zh: β 为任意标量
:printed: In (1-5-3) $\beta$ is an arbitrary scalar.
:holds-by: condition_keeps_the_curvature_vector curvature_vector_is_the_turning_of_the_tangent
:needs: zero_ratio_has_unbounded_curvature | (1-5-2), with unit tangent vectors and lengths of tangent vectors | $\lambda\ne0$; as
  for a quotient of lengths of vectors with directions: with $\alpha_2=0$ the curvature of the second piece need not be bounded.
:needs: vanishing_derivatives_hide_a_jump_of_curvature | (1-5-2), with unit tangent vectors and lengths of tangent vectors | $\dot P_{\mathrm
  I}(1)\ne0$; as where there is a unit tangent vector.
:figure: joints_of_order

With II for the printed index $x$, (1-5-3) is $\ddot P_{\mathrm{II}}(0)=\lambda^2\ddot P_{\mathrm I}(1)+\beta\dot P_{\mathrm I}(1)$, where
$\dot P_{\mathrm{II}}(0)=\lambda\,\dot P_{\mathrm I}(1)$ by (1-5-2).
:::

:::{claim} condition_keeps_the_curvature_vector
:title: The vector of curvature is the same on both sides, for every beta
:zh: 曲率矢量连续
:given: $P'\ne0$ and $P''$ of the first piece in space, $\lambda\ne0$, any $\beta$; $\lambda P'$ and $\lambda^2P''+\beta P'$ for the second
:where: $\dot P_{\mathrm I}(1)\ne0$; $\lambda\ne0$
:then: $\frac{(P'\times P'')\times P'}{|P'|^4}$, the derivative of the unit tangent by the arc length, is the same for both, so is
  $K^2$; $P'\times P''$ is multiplied by $\lambda^3$
:method: Both sides with everything a variable; neither contains $\beta$.
:over: u# v#: derivatives; l: λ; b: β
:control: $\lambda$ in the place of $\lambda^2$
:::
*/
/* out = (d1 x d2) x d1 / |d1|^4 */
static void G(curvature_vector)(const num d1[], const num d2[], num out[])
{
    num n[space], speed = G(norm_squared)(space, d1);
    G(cross3)(d1, d2, n);
    G(cross3)(n, d1, out);
    for (int j = 0; j < space; j++)
        out[j] = div(out[j], mul(speed, speed));
}

CLAIM(condition_keeps_the_curvature_vector)
{
    num d1[space], d2[space], e1[space], e2[space], k[space], m[space], n[space], p[space];
    num lambda = positive(T, "l", 0), beta = unknown(T, "b", 0), square = fault(T, mul(lambda, lambda), lambda);
    for (int j = 0; j < space; j++) {
        d1[j] = unknown(T, "u", j);
        d2[j] = unknown(T, "v", j);
        e1[j] = mul(lambda, d1[j]);
        e2[j] = add(mul(square, d2[j]), mul(beta, d1[j]));
    }
    G(curvature_vector)(d1, d2, k);
    G(curvature_vector)(e1, e2, m);
    G(cross3)(d1, d2, n);
    G(cross3)(e1, e2, p);
    for (int j = 0; j < space; j++) {
        same(T, m[j], k[j]);
        same(T, p[j], mul(G(power)(lambda, 3), n[j]));
    }
    same(T, G(curvature_squared)(space, e1, e2), G(curvature_squared)(space, d1, d2));
}

/*
:::{claim} curvature_vector_is_the_turning_of_the_tangent
:title: The vector of curvature is the derivative of the unit tangent by the arc length
:zh: 曲率矢量是单位切矢对弧长的导数
:given: $\dot P=\alpha U$, with a unit vector $U$ of space and $\alpha>0$, both functions of the parameter; so $\ddot P=\dot\alpha\,U+\alpha\,\dot U$
:where: $\dot P\ne0$
:harmless: $\alpha>0$ | the length of a derivative that is not 0
:then: $\frac{(\dot P\times\ddot P)\times\dot P}{|\dot P|^4}=\frac1\alpha\,\dot U$, and the square of its length is $K^2$
:method: $U=\frac Nw$ with $N=(2(ac+bd),\,2(bc-ad),\,a^2+b^2-c^2-d^2)$ and $w=a^2+b^2+c^2+d^2$, which is every unit vector, differentiated as a quotient;
  $a,b,c,d$, their derivatives, $\alpha$ and $\dot\alpha$ are variables.
:over: q# r# a#: derivatives
:control: $\frac1{\alpha^2}\,\dot U$
:::
*/
/* N and w of a unit vector N/w, as symmetric forms in q and r: their values for r = q, and half their derivatives for r = q'. */
static void G(sphere_forms)(const num q[4], const num r[4], num form[4])
{
    num first = add(mul(q[0], r[0]), mul(q[1], r[1])), last = add(mul(q[2], r[2]), mul(q[3], r[3]));
    form[0] = add(add(mul(q[0], r[2]), mul(q[2], r[0])), add(mul(q[1], r[3]), mul(q[3], r[1])));
    form[1] = sub(add(mul(q[1], r[2]), mul(q[2], r[1])), add(mul(q[0], r[3]), mul(q[3], r[0])));
    form[2] = sub(first, last);
    form[3] = add(first, last);
}

CLAIM(curvature_vector_is_the_turning_of_the_tangent)
{
    num q[4], r[4], N[4], half[4], d1[space], d2[space], turn[space], k[space];
    num speed = positive(T, "a", 0), change = unknown(T, "a", 1), two = from_int(2);
    for (int j = 0; j < 4; j++) {
        q[j] = unknown(T, "q", j);
        r[j] = unknown(T, "r", j);
    }
    G(sphere_forms)(q, q, N);
    G(sphere_forms)(q, r, half);
    num w = N[3], one = from_int(0);
    for (int j = 0; j < space; j++) {
        num U = div(N[j], w), slope = div(mul(two, sub(half[j], mul(U, half[3]))), w);
        one = add(one, mul(U, U));
        d1[j] = mul(speed, U);
        d2[j] = add(mul(change, U), mul(speed, slope));
        turn[j] = div(slope, fault(T, speed, mul(speed, speed)));
    }
    about(T, "the length of the unit tangent");
    same(T, one, from_int(1));
    G(curvature_vector)(d1, d2, k);
    about(T, "the vector of curvature");
    for (int j = 0; j < space; j++)
        same(T, k[j], turn[j]);
    about(T, "the square of its length");
    same(T, G(norm_squared)(space, k), G(curvature_squared)(space, d1, d2));
}

#if RATIONAL
/* Whether P = E, P' = lambda P', P'' = lambda^2 P'' + beta P' for two pieces with P, P', P'' in D and in E. */
static int conditions_hold(const num D[], const num E[], num lambda, num beta)
{
    int hold = 1;
    for (int j = 0; j < dim; j++) {
        num second = add(mul(mul(lambda, lambda), D[2 * dim + j]), mul(beta, D[dim + j]));
        hold &= equal_q(E[j], D[j]) && equal_q(E[dim + j], mul(lambda, D[dim + j])) && equal_q(E[2 * dim + j], second);
    }
    return hold;
}

/*
:::{claim} zero_ratio_has_unbounded_curvature
:title: With the ratio 0 the conditions hold and the curvature is unbounded
:zh: 比值为零时曲率无界
:kind: counterexample
:given: a straight first piece, and a second one that begins like a cusp, $P_{\mathrm I}$ and $P_{\mathrm{II}}$, by their coefficients of $1,t,t^2,\dots$;
  $\lambda$ and $\beta$
:data: P_I = (0,0) (1,0); P_II = (1,0) (0,0) (1,0) (0,1) (0,0); λ = 0; β = 2
:instead: P_II = (1,0) (0,0) (1,0) (0,0) (0,1)
:then: (1-5-1) to (1-5-3) hold and $K=0$ on the first piece; on the second the limit of $t^2K^2$ for $t\to0$ is not 0
:result: P_I, P_I', P_I'' = (1,0) (1,0) (0,0); P_II, P_II', P_II'' = (1,0) (0,0) (2,0); P_II' × P_II'' = "6*t^2"; limit of t²K² = 9/16
:method: The conditions by the kernel.  With $P'=t\,U$ and $P'\times P''=t^2v$, divided as polynomials, $t^2K^2=v^2/|U|^6$; that it is 0
  at $t=0$, as for a bounded $K$, is refuted.
:control: a second piece that begins like a parabola, of bounded curvature
:::
*/
/* Of a curve with the coefficients c that begins with P' = t^k U and P' x P'' = t^m v: v^2/|U|^6, the limit of t^(6k-2m) K^2 for t -> 0.
 * *product is P' x P''; *divided says whether the powers of t below the k-th and the m-th do not occur. */
static num limit_of_squared_curvature(int degree, const num c[], int k, int m, poly *product, int *divided)
{
    poly component[2], turn[2];
    num U[2], of_axis[MAX_DEGREE + 1];
    *divided = 1;
    for (int j = 0; j < dim; j++) {
        for (int i = 0; i <= degree; i++)
            of_axis[i] = c[dim * i + j];
        component[j] = poly_derivative(poly_from_q(degree + 1, of_axis));
        turn[j] = poly_derivative(component[j]);
        U[j] = poly_coefficient(component[j], k);
        for (int i = 0; i < k; i++)
            *divided &= is_zero_q(poly_coefficient(component[j], i));
    }
    *product = poly_sub(poly_mul(component[0], turn[1]), poly_mul(component[1], turn[0]));
    for (int i = 0; i < m; i++)
        *divided &= is_zero_q(poly_coefficient(*product, i));
    num v = poly_coefficient(*product, m);
    return div(mul(v, v), G(power)(G(norm_squared)(dim, U), 3));
}

CLAIM(zero_ratio_has_unbounded_curvature)
{
    enum { degree = 4 };
    num first[4], second[2 * (degree + 1)], D[6], E[6];
    poly product;
    int divided;
    given_points(T, "P_I", 2, 2, first);
    given_points(T, "P_II", degree + 1, 2, second);
    num lambda = given(T, "λ"), beta = given(T, "β");
    G(power_derivatives)(1, dim, first, from_int(1), 2, D);
    G(power_derivatives)(degree, dim, second, from_int(0), 2, E);
    found_points(T, "P_I, P_I', P_I''", 3, 2, D);
    found_points(T, "P_II, P_II', P_II''", 3, 2, E);
    num limit = limit_of_squared_curvature(degree, second, 1, 2, &product, &divided);
    found_text(T, "P_II' × P_II''", poly_to_string(product, "t"));
    found(T, "limit of t²K²", limit);
    about(T, "the conditions holding, whether t²K² tends to 0");
    refute(T, conditions_hold(D, E, lambda, beta) && divided && !is_zero_q(limit));
}

/*
:::{claim} vanishing_derivatives_hide_a_jump_of_curvature
:title: Where the first two derivatives vanish the conditions hold and the curvature jumps
:zh: 一、二阶导矢为零时条件成立而曲率间断
:kind: counterexample
:given: a first piece on the $x$-axis, and a second one along the parabola $y=x^2$, which touches that axis, $P_{\mathrm I}$ and $P_{\mathrm{II}}$, by their coefficients of
  $1,t,t^2,\dots$; $\lambda$ and $\beta$
:data: P_I = (-1,0) (3,0) (-3,0) (1,0); P_II = (0,0) (0,0) (0,0) (1,0) (0,0) (0,0) (0,1); λ = 1; β = 0
:instead: P_II = (0,0) (0,0) (0,0) (1,0) (0,0) (0,0) (0,0)
:then: (1-5-1) to (1-5-3) hold, every vector in them being 0; $K=0$ on the first piece, and on the second the limit of $K^2$ for $t\to0$ is not 0
:result: P_I, P_I', P_I'' = (0,0) (0,0) (0,0); P_II, P_II', P_II'' = (0,0) (0,0) (0,0); P_II' × P_II'' = "54*t^6"; limit of K² = 4
:method: The conditions by the kernel; the first piece has $y=0$.  With $P'=t^2U$ and $P'\times P''=t^6v$, divided as polynomials, $K^2=v^2/|U|^6$; that it is 0 at
  $t=0$, as on the first piece, is refuted.
:control: a second piece on the axis as well
:::
*/
CLAIM(vanishing_derivatives_hide_a_jump_of_curvature)
{
    enum { degree = 6 };
    num first[8], second[2 * (degree + 1)], D[6], E[6];
    poly product;
    int divided, straight = 1;
    given_points(T, "P_I", 4, 2, first);
    given_points(T, "P_II", degree + 1, 2, second);
    num lambda = given(T, "λ"), beta = given(T, "β");
    G(power_derivatives)(3, dim, first, from_int(1), 2, D);
    G(power_derivatives)(degree, dim, second, from_int(0), 2, E);
    found_points(T, "P_I, P_I', P_I''", 3, 2, D);
    found_points(T, "P_II, P_II', P_II''", 3, 2, E);
    for (int k = 0; k < 4; k++)
        straight &= is_zero_q(first[dim * k + 1]);
    num limit = limit_of_squared_curvature(degree, second, 2, 6, &product, &divided);
    found_text(T, "P_II' × P_II''", poly_to_string(product, "t"));
    found(T, "limit of K²", limit);
    about(T, "the conditions holding, whether K² tends to that of the first piece");
    refute(T, conditions_hold(D, E, lambda, beta) && straight && divided && !is_zero_q(limit));
}

/*
:::{claim} vanishing_derivatives_hide_a_corner
:title: Where the first two derivatives vanish the conditions hold at a corner
:zh: 一、二阶导矢为零时条件成立而有角点
:kind: counterexample
:given: two cubic pieces on the axes, $P_{\mathrm I}$ and $P_{\mathrm{II}}$, by their coefficients of $1,t,t^2,\dots$; $\lambda$ and $\beta$
:data: P_I = (-1,0) (3,0) (-3,0) (1,0); P_II = (0,0) (0,0) (0,0) (0,1); λ = 1; β = 0
:instead: P_II = (0,0) (0,0) (0,0) (1,0)
:then: (1-5-1) to (1-5-3) hold, every vector in them being 0; the first piece runs along the $x$-axis, $x'>0$ on $(0,1)$, the second
  along the $y$-axis, $y'>0$: a corner of a right angle
:result: P_I, P_I', P_I'' = (0,0) (0,0) (0,0); P_II, P_II', P_II'' = (0,0) (0,0) (0,0)
:method: The conditions by the kernel; the directions by the signs of $x'$ and $y'$, exactly.  That there is no right angle is
  refuted.
:control: a second piece along the $x$-axis
:::
*/
CLAIM(vanishing_derivatives_hide_a_corner)
{
    num first[8], second[8], D[6], E[6];
    given_points(T, "P_I", 4, 2, first);
    given_points(T, "P_II", 4, 2, second);
    num lambda = given(T, "λ"), beta = given(T, "β");
    G(power_derivatives)(3, dim, first, from_int(1), 2, D);
    G(power_derivatives)(3, dim, second, from_int(0), 2, E);
    found_points(T, "P_I, P_I', P_I''", 3, 2, D);
    found_points(T, "P_II, P_II', P_II''", 3, 2, E);
    about(T, "the conditions holding, whether there is no right angle between the pieces");
    refute(T, conditions_hold(D, E, lambda, beta) && runs_forward(3, first, 0) && runs_forward(3, second, 1));
}

/*
The converse is the more delicate direction.  The curvature (曲率) of the source is a length over a power of a length; it
has no sign, and the word "continuous" can be true of it where nobody would call the joint smooth.  What the condition
secures is more: the vector of curvature (曲率矢量), which knows to which side the curve bends.

:::{statement} hu-1987:1-5-3-necessary
:title: For a continuous curvature the condition has to be satisfied
:zh: 曲率连续的必要性
:printed: The curvature is to vary continuously at the joint, so the condition (1-5-3) has to be satisfied.
:refuted-by: equal_curvatures_to_different_sides
:class: false
:corrected: Let $\dot P_{\mathrm I}(1)\ne0$ and $\dot P_{\mathrm{II}}(0)\ne0$.  The conditions (1-5-2) and (1-5-3), with one $\lambda>0$ and some $\beta$, are together
  necessary and sufficient for continuity of the unit tangent and of the vector of curvature; for plane curves, of the unit tangent and of the
  curvature with its sign.
:corrected-by: equal_unit_tangents_fix_the_ratio curvature_vector_forces_the_condition condition_keeps_the_curvature_vector
  second_derivative_splits_along_the_first curvature_vector_is_the_turning_of_the_tangent signed_curvature_is_that_of_the_vector
:confirmed-by: signed_curvature_is_the_turning_of_the_tangent
:needs: vanishing_derivatives_hide_a_corner | (1-5-2), with unit tangent vectors and lengths of tangent vectors | $\dot P_{\mathrm
  I}(1)\ne0$; as where there is a unit tangent vector: without it the conditions of the correction do not suffice.
:needs: singular_end_has_no_ratio | (1-5-2), with unit tangent vectors of both pieces | $\dot P_{\mathrm{II}}(0)\ne0$; as where there is a unit tangent vector: without
  it the unit tangent may be continuous although there is no $\lambda>0$, as with $R_{\mathrm I}$ and $R_{\mathrm{II}}$.
:meant: the formula of section 1-4, by which the curvature is a number without a sign | The curvature is $K$.
:reading: equal_curvatures_to_different_sides | where the curvature $K$ is continuous, (1-5-3) holds
:reading: curvature_vector_forces_the_condition | where the unit tangent and the vector of curvature are continuous, (1-5-3) holds with some $\beta$
:reading-with: equal_unit_tangents_fix_the_ratio second_derivative_splits_along_the_first curvature_vector_is_the_turning_of_the_tangent
:reading: signed_curvature_is_that_of_the_vector | in the plane, where the unit tangent and the curvature with its sign are continuous, (1-5-3) holds with some $\beta$,
  because then the vector of curvature is continuous, too
:reading-with: equal_unit_tangents_fix_the_ratio curvature_vector_forces_the_condition second_derivative_splits_along_the_first
  curvature_vector_is_the_turning_of_the_tangent
:needs: negative_ratio_turns_back | (1-5-2), where $\lambda$ is the quotient of the lengths of tangent vectors | $\lambda>0$; as for a quotient of lengths.
:figure: same_curvature_other_side
:striking: 43

$K=|\dot P\times\ddot P|/\dot s^3$ has no sign and no direction: it can be continuous where the curve changes its side.

With II for the printed index $x$, (1-5-2) is $\dot P_{\mathrm{II}}(0)=\lambda\,\dot P_{\mathrm I}(1)$, and (1-5-3) is
$\ddot P_{\mathrm{II}}(0)=\lambda^2\ddot P_{\mathrm I}(1)+\beta\dot P_{\mathrm I}(1)$.
:::

:::{claim} equal_curvatures_to_different_sides
:title: Two parabolas with one tangent and one curvature, bent to different sides
:zh: 曲率相等而弯向相反
:kind: counterexample
:given: two parabolas that meet, $P_{\mathrm I}$ and $P_{\mathrm{II}}$, by their coefficients of $1,t,t^2,\dots$
:data: P_I = (-1,1) (1,-2) (0,1); P_II = (0,0) (1,0) (0,-1)
:instead: P_II = (0,0) (1,0) (0,1)
:then: at the joint $P$, $P'$ and $K$ are the same for both, so $\lambda=1$; but $P_{\mathrm{II}}''-P_{\mathrm I}''$ is no multiple $\beta P'$
:result: P_I, P_I', P_I'' = (0,0) (1,0) (0,2); P_II, P_II', P_II'' = (0,0) (1,0) (0,-2); K² = 4 4; P_II'' - P_I'' = (0,-4)
:method: Derivatives and $K^2$ by the kernels; the determinant of the difference and $P'$ should vanish.
:control: a second parabola bent to the same side
:::
*/
CLAIM(equal_curvatures_to_different_sides)
{
    num first[6], second[6], D[6], E[6];
    given_points(T, "P_I", 3, 2, first);
    given_points(T, "P_II", 3, 2, second);
    G(power_derivatives)(2, dim, first, from_int(1), 2, D);
    G(power_derivatives)(2, dim, second, from_int(0), 2, E);
    num square[2] = {G(curvature_squared)(2, D + 2, D + 4), G(curvature_squared)(2, E + 2, E + 4)};
    num gap[2] = {sub(E[4], D[4]), sub(E[5], D[5])};
    found_points(T, "P_I, P_I', P_I''", 3, 2, D);
    found_points(T, "P_II, P_II', P_II''", 3, 2, E);
    found_points(T, "K²", 2, 1, square);
    found_points(T, "P_II'' - P_I''", 1, 2, gap);
    int joined = same_point(D, E) && same_point(D + 2, E + 2) && equal_q(square[0], square[1]);
    about(T, "position, tangent and curvature being the same, whether the difference of the second derivatives is "
             "parallel to P'");
    refute(T, joined && !is_zero_q(G(cross2)(gap, D + 2)));
}
#endif

/*
:::{claim} curvature_vector_forces_the_condition
:title: With one unit tangent and one vector of curvature the condition holds
:zh: 曲率矢量连续蕴涵条件
:given: vectors $U$ and $k$ of space, $\alpha_1,\alpha_2>0$, $\mu_1,\mu_2$: $P_i'=\alpha_iU$, $P_i''=\alpha_i^2k+\mu_iU$, as every curve
  with unit tangent $U$, curvature vector $k$ and speed $\alpha_i$ has
:where: neither derivative is 0 at the joint
:harmless: $\alpha_1,\alpha_2>0$ | the lengths of derivatives that are not 0
:then: $P_{\mathrm{II}}''=\lambda^2P_{\mathrm I}''+\beta P_{\mathrm I}'$ with $\beta=\frac{\mu_2-\lambda^2\mu_1}{\alpha_1}$
:method: An identity with everything a variable.  That every curve has such derivatives is
  $|P'|^2P''=(P'\cdot P'')\,P'+(P'\times P'')\times P'$, which is `second_derivative_splits_along_the_first`, divided by $|P'|^2$.
:over: a#: lengths; u# k#: vectors; m#: numbers μ
:control: $\beta=\frac{\mu_2-\mu_1}{\alpha_1}$
:::
*/
CLAIM(curvature_vector_forces_the_condition)
{
    num a1 = positive(T, "a", 1), a2 = positive(T, "a", 2), mu1 = unknown(T, "m", 1), mu2 = unknown(T, "m", 2);
    num lambda = div(a2, a1), square = mul(lambda, lambda);
    num beta = div(sub(mu2, fault(T, mul(square, mu1), mu1)), a1);
    for (int j = 0; j < space; j++) {
        num U = unknown(T, "u", j), k = unknown(T, "k", j);
        num first = add(mul(mul(a1, a1), k), mul(mu1, U)), second = add(mul(mul(a2, a2), k), mul(mu2, U));
        /* P_II'' = λ² P_I'' + β P_I' */
        same(T, second, add(mul(square, first), mul(beta, mul(a1, U))));
    }
}

/*
:::{claim} signed_curvature_is_that_of_the_vector
:title: In the plane the vector of curvature is the curvature with its sign times the normal
:zh: 平面曲线的曲率矢量为带号曲率乘法矢
:given: $P'\ne0$ and $P''$ of a curve in the $xy$-plane
:where: neither derivative is 0 at the joint
:then: $\frac{(P'\times P'')\times P'}{|P'|^4}$ is $\frac{x'y''-x''y'}{|P'|^4}\,(-y',x')$: the curvature with its sign, $\frac{x'y''-x''y'}{|P'|^3}$, times the
  unit tangent turned to the left by a right angle; so with one unit tangent the one is continuous exactly where the other is
:method: The vector products in space with the third coordinates 0, everything a variable.
:over: u# v#: derivatives
:control: the normal on the other side
:::
*/
CLAIM(signed_curvature_is_that_of_the_vector)
{
    num zero = from_int(0), d1[space] = {unknown(T, "u", 0), unknown(T, "u", 1), zero}, k[space];
    num d2[space] = {unknown(T, "v", 0), unknown(T, "v", 1), zero}, speed = G(norm_squared)(space, d1);
    num left[space] = {neg(d1[1]), d1[0], zero}, factor = div(G(cross2)(d1, d2), mul(speed, speed));
    factor = fault(T, factor, neg(factor));
    G(curvature_vector)(d1, d2, k);
    for (int j = 0; j < space; j++)
        same(T, k[j], mul(factor, left[j]));
}

#include "chapters/judge/claims_off.h"
