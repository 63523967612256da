/*
# Cubics that are joined (分段三次 Bézier 曲线的光滑连接)

Two cubics with the polygons $P_0P_1P_2P_3$ and $Q_0Q_1Q_2Q_3$ are to be one smooth curve.  The slides give a condition on
the points for the position, for the tangent, and for the second derivative.  Each is right about the derivatives that it
names.  What the second and the third guarantee depends on something that is not said: the edges at the joint must not have
length 0, and the third condition speaks of $C^2$ only for curves that are $C^1$, and not for those that are merely $G^1$, which
are the ones just treated.
*/
#include "chapters/bezier/definition.h"

#include "chapters/judge/claims_on.h"

enum { dim = 2 };

/*
Position costs nothing: both curves pass through the ends of their polygons.  For the tangent the two derivatives at the joint need
only point in one direction, which is one number $a>0$ less than equality; the slides turn this into a condition on two edges.

:::{statement} slides-ch4:4-joint-position
:title: The cubics meet
:zh: 位置连续条件
:printed: Obviously the condition for the Bézier curves of the polygons $P_0P_1P_2P_3$ and $Q_0Q_1Q_2Q_3$ to be continuous at the joint is $P_3=Q_0$.
:holds-by: bernstein_recurrence recurrence_keeps_sum_sign_ends_and_symmetry
:confirmed-by: end_derivatives_are_end_differences
:figure: joint_of_cubics
:degree: 3
:::

:::{statement} slides-ch4:4-joint-derivatives
:title: The derivatives at the joint
:zh: 连接点处的导矢
:printed: $Q_0'=3(Q_1-Q_0)$, $P_3'=3(P_3-P_2)$
:holds-by: bernstein_recurrence recurrence_keeps_sum_sign_ends_and_symmetry bernstein_derivative
  sums_by_parts_give_the_edges
:confirmed-by: end_derivatives_are_end_differences
:figure: joint_of_cubics
:degree: 3

$Q_0'$ is $Q'(0)$ and $P_3'$ is $P'(1)$.
:::

:::{statement} slides-ch4:4-joint-g1
:title: G1 by proportional derivatives
:zh: G1 连续要求导矢成比例
:printed: $G^1$ at the joint, that is, geometric continuity of the first derivative, requires $Q_0'=aP_3'$, where $a$ should be a positive number.
:holds-by: equal_unit_tangents_fix_the_ratio
:needs: negative_ratio_turns_back | the line itself: $a>0$ | $a>0$: with a negative ratio the derivatives are proportional and the curve turns back
:needs: equal_derivatives_across_a_gap | the condition before it, $P_3=Q_0$ | the curves meet: in the example $Q_0'=aP_3'$ with $a=1$, and $P_3\ne Q_0$
:hypothesis: zero_edges_hide_a_corner | $P_3'\ne0$ and $Q_0'\ne0$: with both 0 the condition does not suffice
:hypothesis: singular_end_has_no_ratio | $P_3'\ne0$ and $Q_0'\ne0$: with one of them 0, whichever it is, the condition is not necessary
:meant: the definition of $G^k$ by the arc length, `slides-ch4:1-gk-definition`, and the sentence behind it, which calls this the condition (条件) for $G^1$ |
  $G^1$ says that the curves meet, and that the two unit tangents at the joint are equal; the joint is $G^1$ if and only if there is such an $a$.
:figure: joint_of_cubics

$Q_0'$ is $Q'(0)$ and $P_3'$ is $P'(1)$.  In the first example $\lambda$ is $a$.  Pieces of degree 1 or 2 are cubics when they are raised in degree.
:::

The step from derivatives to edges is a division by 3, and nothing can go wrong in it.  What can go wrong was there before: a derivative
that is 0 has no direction.  The two counterexamples below are of two kinds.  In the first the condition holds and the curve has a corner;
in the second the curve is as smooth as a curve can be and the condition fails.

:::{statement} slides-ch4:4-joint-g1-edges
:title: G1 by the edges at the joint
:zh: G1 连续的控制顶点条件
:printed: The condition for $G^1$ at the joint is $Q_1-Q_0=a(P_3-P_2)$.
:holds-by: edges_in_a_ratio_give_tangents_in_that_ratio equal_unit_tangents_fix_the_ratio
:meant: the definition of $G^k$ by the arc length, `slides-ch4:1-gk-definition`, and the word condition (条件) |
  $G^1$ says that the curves meet, and that the two unit tangents at the joint are equal; the joint is $G^1$ if and only if there is an $a$ with which the condition holds.
:needs: equal_derivatives_across_a_gap | the condition before it, $P_3=Q_0$ | the curves meet: in the example the condition holds with $a=1$, and $P_3\ne Q_0$
:needs: negative_ratio_of_edges_turns_back | the condition by derivatives, `slides-ch4:4-joint-g1`: $a>0$ | $a>0$
:hypothesis: zero_edges_hide_a_corner | $P_2\ne P_3$ and $Q_0\ne Q_1$: with two edges of length 0 the condition does not suffice
:hypothesis: straight_joint_with_a_zero_edge | $P_2\ne P_3$ and $Q_0\ne Q_1$: with one edge of length 0, whichever it is, the condition is not necessary
:figure: corner_without_edges
:degree: 3
:::

:::{statement} slides-ch4:4-joint-g1-point
:title: The joint divides the segment from P2 to Q1
:zh: 连接点为 P2Q1 的定比分点
:printed: from $Q_1-Q_0=a(P_3-P_2)$: $Q_0=P_3=\frac{Q_1+aP_2}{1+a}$
:holds-by: edges_in_a_ratio_give_tangents_in_that_ratio
:needs: equal_derivatives_across_a_gap | the condition before it, $P_3=Q_0$ | the curves meet: in the example the condition holds with $a=1$, and $Q_0=P_3$, the first part of what follows, is false
:needs: ratio_minus_one_has_no_quotient | the condition by derivatives, `slides-ch4:4-joint-g1`: $a>0$ | $a>0$; of all other ratios $a=-1$ alone has no quotient
:figure: joint_of_cubics
:degree: 3
:::

:::{claim} edges_in_a_ratio_give_tangents_in_that_ratio
:title: The three forms of the condition are one
:zh: G1 条件的三种形式等价
:given: two curves of degree $n$ of the plane, the points $p_0,\dots,p_n$ of the first, $q_1,\dots,q_n$ of the second any, $q_0=p_n$; $a>0$
:where: the curves meet; $a>0$
:then: the derivatives at the joint have $Q'-aP'=n\bigl(q_1-q_0-a(p_n-p_{n-1})\bigr)$, so that $Q'=aP'$ and $q_1-q_0=a(p_n-p_{n-1})$ are one condition;
  with it $q_0=\frac{q_1+a\,p_{n-1}}{1+a}$, and with $q_0$ from this formula, $q_1$ and $p_{n-1}$ being free, $q_1-q_0=a(q_0-p_{n-1})$
:method: Derivatives at the ends by the kernel; everything a variable.  Each coordinate is compared by itself: in space the same is true.
:degrees: 1..6 sampled 10
:over: u# v# w#: points; a
:control: $\frac{a\,q_1+p_{n-1}}{1+a}$
:::
*/
CLAIM(edges_in_a_ratio_give_tangents_in_that_ratio)
{
    int n = T->degree;
    num p[(MAX_DEGREE + 1) * dim], q[(MAX_DEGREE + 1) * dim], D[2 * dim], E[2 * dim];
    num a = positive(T, "a", 0), whole_ratio = add(from_int(1), a);
    G(free_points)(T, n, dim, p);
    for (int i = 1; i <= n; i++)
        for (int c = 0; c < dim; c++)
            q[i * dim + c] = unknown(T, c == 0 ? "u" : "v", i);
    for (int c = 0; c < dim; c++)
        q[c] = p[n * dim + c];
    G(bezier_derivatives)(n, dim, p, from_int(1), 1, D);
    G(bezier_derivatives)(n, dim, q, from_int(0), 1, E);
    for (int c = 0; c < dim; c++) {
        num before = p[(n - 1) * dim + c], edge = mul(a, sub(q[c], before)), after = add(q[c], edge),
            other = unknown(T, "w", c);
        about(T, "the derivatives at the joint");
        /* Q'(0) - a P'(1) = n (q_1 - q_0 - a (p_n - p_{n-1})) */
        num gap = sub(sub(q[dim + c], q[c]), edge);
        same(T, sub(E[dim + c], mul(a, D[dim + c])), mul(from_int(n), gap));
        about(T, "the joint");
        /* q_0 = (q_1 + a p_{n-1})/(1+a) */
        num joint = fault(T, add(after, mul(a, before)), add(mul(a, after), before));
        same(T, div(joint, whole_ratio), q[c]);
        joint = div(add(other, mul(a, before)), whole_ratio);
        about(T, "the edges of that joint");
        /* q_1 - q_0 = a (q_0 - p_{n-1}) for that q_0 */
        same(T, sub(other, joint), mul(a, sub(joint, before)));
    }
}

#if RATIONAL
/*
:::{claim} ratio_minus_one_has_no_quotient
:title: For the ratio -1 the quotient is none
:zh: a=-1 时分母为零
:kind: counterexample
:data: a = -1
:instead: a = 1
:given: the ratio $a$ of the edges
:then: the denominator $1+a$ is 0
:method: The denominator; that it is not 0 is refuted.
:control: a positive ratio
:::
*/
CLAIM(ratio_minus_one_has_no_quotient)
{
    num a = given(T, "a");
    about(T, "whether the denominator 1 + a is not 0");
    refute(T, is_zero_q(add(from_int(1), a)));
}

/*
:::{claim} zero_edges_hide_a_corner
:title: Edges of length 0 satisfy the condition and hide a corner
:zh: 零边满足条件而曲线有尖角
:kind: counterexample
:data: P = (-2,0) (-1,0) (0,0) (0,0); Q = (0,0) (0,0) (0,1) (1,2)
:instead: Q = (0,0) (0,0) (1,0) (1,2)
:result: P''(1) = (-6,0); Q''(0) = (0,6)
:given: two cubics with the polygons $P$ and $Q$, whose edges at the joint have length 0: $P_2=P_3=Q_0=Q_1$, so that $Q_1-Q_0=a(P_3-P_2)$
  for every $a$
:then: $P'(1)=Q'(0)=0$, and near the joint $P'(1-u)=-u\,P''(1)+\cdots$, $Q'(u)=u\,Q''(0)+\cdots$: the curve arrives along one axis and
  leaves along the other
:method: First derivatives, which vanish, and second ones at the joint by the kernel; the directions $-P''(1)$ and $Q''(0)$ should have
  the determinant 0.
:control: the second edge of $Q$ goes on along the first axis
:::
*/
CLAIM(zero_edges_hide_a_corner)
{
    num P[4 * dim], Q[4 * dim], D[3 * dim], E[3 * dim];
    given_points(T, "P", 4, dim, P);
    given_points(T, "Q", 4, dim, Q);
    bezier_derivatives_q(3, dim, P, from_int(1), 2, D);
    bezier_derivatives_q(3, dim, Q, from_int(0), 2, E);
    found_points(T, "P''(1)", 1, dim, D + 2 * dim);
    found_points(T, "Q''(0)", 1, dim, E + 2 * dim);
    about(T, "the first derivatives");
    for (int c = 0; c < dim; c++) {
        same(T, D[dim + c], from_int(0));
        same(T, E[dim + c], from_int(0));
    }
    num arrives[dim] = {neg(D[2 * dim]), neg(D[2 * dim + 1])};
    about(T, "the determinant of the directions");
    vanishes(T, cross2_q(arrives, E + 2 * dim));
}

/*
:::{claim} straight_joint_with_a_zero_edge
:title: A straight line with one zero edge at the joint has no ratio of the edges
:zh: 一侧为零边的直线连接无比值
:kind: counterexample
:data: P = (-3,0) (-2,0) (-1,0) (0,0); Q = (0,0) (0,0) (1,0) (3,0); R = (-3,0) (-1,0) (0,0) (0,0); S = (0,0) (1,0) (2,0) (3,0)
:instead: Q = (0,0) (1,0) (1,0) (3,0); R = (-3,0) (-1,0) (-1,0) (0,0)
:result: a = 0; R_3 - R_2 = (0,0); S_1 - S_0 = (1,0)
:given: two cubics with the polygons $P$ and $Q$, and two others, with $R$ and $S$, in the places of $P$ and $Q$; all points lie on one axis; $Q_0=P_3$, and the first edge of
  $Q$ has length 0; $S_0=R_3$, and the last edge of $R$ has length 0
:then: the two of each pair are parts of one straight line, run through in one direction, so by arc length $G^k$ for every $k$; but
  $Q_1-Q_0=a(P_3-P_2)$ only for $a=0$, and $S_1-S_0=a(R_3-R_2)$ for no $a$, so neither for a positive $a$
:method: All second coordinates are 0, the first coordinates of the points do not decrease, $Q_0=P_3$, $S_0=R_3$, and each polygon has two different
  ends.  There is a positive $a$ where the two edges at the joint point in one direction and neither is 0; that one of the two joints has it is refuted.
:control: $Q_1$ is moved to $Q_2$, and $R_2$ to $R_1$
:::
*/
/* Whether all points lie on the axis, in one order, and the curves meet. */
static int in_one_direction(const num P[], const num Q[])
{
    int straight = equal_q(Q[0], P[6]) && sign_q(sub(P[6], P[0])) > 0 && sign_q(sub(Q[6], Q[0])) > 0;
    for (int i = 0; i <= 3; i++) {
        straight = straight && is_zero_q(P[2 * i + 1]) && is_zero_q(Q[2 * i + 1]);
        if (i < 3)
            straight = straight && sign_q(sub(P[2 * i + 2], P[2 * i])) >= 0 && sign_q(sub(Q[2 * i + 2], Q[2 * i])) >= 0;
    }
    return straight;
}

CLAIM(straight_joint_with_a_zero_edge)
{
    num P[4 * dim], Q[4 * dim], R[4 * dim], S[4 * dim];
    given_points(T, "P", 4, dim, P);
    given_points(T, "Q", 4, dim, Q);
    given_points(T, "R", 4, dim, R);
    given_points(T, "S", 4, dim, S);
    num a = div(sub(Q[2], Q[0]), sub(P[6], P[4]));
    num edges[2 * dim] = {sub(R[6], R[4]), sub(R[7], R[5]), sub(S[2], S[0]), sub(S[3], S[1])};
    found(T, "a", a);
    found_points(T, "R_3 - R_2", 1, dim, edges);
    found_points(T, "S_1 - S_0", 1, dim, edges + dim);
    int straight = in_one_direction(P, Q) && in_one_direction(R, S);
    int has_ratio = sign_q(a) > 0 || sign_q(mul(edges[0], edges[dim])) > 0;
    about(T, "the joined curves being straight lines, whether a is positive for one of them");
    agree(T, straight ? has_ratio : fault(T, 0, 1)); /* otherwise nothing is shown */
}

/*
:::{claim} negative_ratio_of_edges_turns_back
:title: With a negative ratio of the edges the curve goes back
:zh: 边之比为负时曲线折返
:kind: counterexample
:data: P = (-3,3) (-2,1) (-1,0) (0,0); a = -2; Q_2 = (-3,1); Q_3 = (-4,4)
:instead: a = 2
:result: Q_1 = (-2,0); unit tangents = (1,0) (-1,0)
:given: a cubic with the points $P$, and the next one with $Q_0=P_3$ and $Q_1=Q_0+a(P_3-P_2)$; no edge at the joint is 0
:then: the condition holds with a negative $a$, and the unit tangents of the two curves at the joint are not equal
:method: The derivatives at the ends by the kernel, divided by their lengths.
:control: a positive $a$
:::
*/
CLAIM(negative_ratio_of_edges_turns_back)
{
    num P[4 * dim], Q[4 * dim], D[2 * dim], E[2 * dim], unit[4];
    given_points(T, "P", 4, dim, P);
    given_points(T, "Q_2", 1, dim, Q + 2 * dim);
    given_points(T, "Q_3", 1, dim, Q + 3 * dim);
    num a = given(T, "a");
    for (int c = 0; c < dim; c++) {
        Q[c] = P[3 * dim + c];
        Q[dim + c] = add(Q[c], mul(a, sub(P[3 * dim + c], P[2 * dim + c])));
    }
    bezier_derivatives_q(3, dim, P, from_int(1), 1, D);
    bezier_derivatives_q(3, dim, Q, from_int(0), 1, E);
    for (int c = 0; c < dim; c++) {
        unit[c] = div(D[dim + c], root(2, norm_squared_q(dim, D + dim)));
        unit[dim + c] = div(E[dim + c], root(2, norm_squared_q(dim, E + dim)));
    }
    found_points(T, "Q_1", 1, dim, Q + dim);
    found_points(T, "unit tangents", 2, dim, unit);
    about(T, "the coordinates of the unit tangents");
    for (int c = 0; c < dim; c++)
        same(T, unit[dim + c], unit[c]);
}
#endif

/*
## The second derivative

:::{statement} slides-ch4:4-second-derivative
:title: The second derivative of a cubic
:zh: 三次曲线的二阶导矢
:printed: P''(t)=[6t\;\;2]\begin{bmatrix}-1&3&-3&1\\3&-6&3&0\end{bmatrix}\begin{bmatrix}P_0\\P_1\\P_2\\P_3\end{bmatrix}=(-6t+6)P_0+(18t-12)P_1+(-18t+6)P_2+6tP_3
:holds-by: second_derivative_of_a_cubic
:figure: second_derivatives_alone

In the text at hand the seven numbers of the matrix that are not 0 have no signs: of the 128 choices one alone gives the second derivative.
:::

:::{statement} slides-ch4:4-second-derivative-ends
:title: The second derivatives at the joint
:zh: 连接点处的二阶导矢
:printed: $P''(1)=6P_3-12P_2+6P_1$, $Q''(0)=6Q_0-12Q_1+6Q_2$
:holds-by: second_derivative_of_a_cubic
:figure: second_derivatives_alone
:::

:::{claim} second_derivative_of_a_cubic
:title: The second derivative in its two printed forms, and at the ends
:zh: 二阶导矢的两种形式
:given: four points of the plane, any $t$
:then: both forms are $P''(t)$; at $t=1$ and $t=0$ they are the printed differences
:method: Against the second derivative of the definition, everything a variable.  Each coordinate is compared by itself: in space the same is true.
:scope: cubic curves
:control: $18t+12$ beside $P_1$
:::
*/
CLAIM(second_derivative_of_a_cubic)
{
    static const int M[2][4] = {{-1, 3, -3, 1}, {3, -6, 3, 0}}, slope[4] = {-6, 18, -18, 6},
                     constant[4] = {6, -12, 6, 0};
    num b[4 * dim], t = parameter(T, "t");
    G(free_points)(T, 3, dim, b);
    for (int place = 0; place < 3; place++) { /* at t, at 1 and at 0 */
        num u = place == 0 ? t : from_int(place == 1);
        for (int c = 0; c < dim; c++) {
            num D = G(curve_derivative)(3, dim, b, c, 2, u), product = from_int(0), sum = from_int(0);
            for (int j = 0; j <= 3; j++) {
                num first = mul(mul(from_int(6), u), from_int(M[0][j])), second = from_int(2 * M[1][j]);
                product = add(product, mul(add(first, second), b[j * dim + c]));
                int at_zero = fault(T, constant[j], j == 1 ? 12 : constant[j]);
                sum = add(sum, mul(add(mul(from_int(slope[j]), u), from_int(at_zero)), b[j * dim + c]));
            }
            about(T, "the matrix");
            same(T, product, D);
            about(T, "the sum");
            same(T, sum, D);
        }
    }
    about(T, "the differences at the ends");
    for (int end = 0; end < 2; end++)
        for (int c = 0; c < dim; c++) {
            const num *first = b + end * dim + c;
            /* 6 P_0 - 12 P_1 + 6 P_2 at 0, 6 P_1 - 12 P_2 + 6 P_3 at 1 */
            num outer = mul(from_int(6), add(first[0], first[2 * dim]));
            num D = G(curve_derivative)(3, dim, b, c, 2, from_int(end));
            same(T, sub(outer, mul(from_int(12), first[dim])), D);
        }
}

/*
Now the second derivative.  Its equality is a condition on three points of each polygon.  One should ask what it is good for
when the first derivatives are only proportional, which is the case just treated.  With $Q'=aP'\ne0$, $Q''=P''$ and $a\ne1$ the joint is not
$C^2$, and the curvature jumps as well, unless it is 0.

:::{statement} slides-ch4:4-joint-c2
:title: C2 by equal second derivatives
:zh: C2 连续条件
:printed: The condition for $C^2$ at the joint, that is, for continuity of the second derivative by the parameter: $P''(1)=Q''(0)$ is required, that is
  $Q_0-2Q_1+Q_2=P_3-2P_2+P_1$.
:holds-by: second_derivative_of_a_cubic three_points_make_c2
:confirmed-by: printed_condition_divides_the_curvature
:needs: equal_derivatives_across_a_gap | the first of the conditions, $P_3=Q_0$ | $P_3=Q_0$
:hypothesis: equal_second_derivatives_with_unequal_first | $P'(1)=Q'(0)$: the conditions before it ask only for $Q'(0)=aP'(1)$ with some $a>0$
:reading: second_derivative_of_a_cubic | it is required, whatever else is: at a joint that is $C^2$ the second derivatives are equal by definition, and that is the condition on the points
:reading: second_derivative_of_a_cubic | it is the condition for equal second derivatives alone, whether or not the first ones are equal
:reading: equal_second_derivatives_with_unequal_first | it is enough for $C^2$ where the curves meet with $Q'(0)=aP'(1)$, $a>0$
:meant: the word condition (条件), and the definition `slides-ch4:1-ck-definition` | $C^2$ says that the values and the first two derivatives are equal; the joint is $C^2$ if and
  only if the condition holds.
:figure: second_derivatives_alone
:striking: 45

With $Q'(0)=aP'(1)\ne0$, $a>0$, the condition for $G^1$, in the place of equal first derivatives, the square of the curvature behind the joint is that before it, divided by $a^4$:
`printed_condition_divides_the_curvature`.
:::

:::{claim} three_points_make_c2
:title: With three points the next cubic joins in C2, and only so
:zh: C2 连接由三点确定
:given: any $P_0,\dots,P_3$, $Q_3$ of the plane; $Q_0=P_3$, $Q_1=2P_3-P_2$, $Q_2=P_1+2(Q_1-P_2)$
:then: $Q^{(r)}(0)=P^{(r)}(1)$ for $r=0,1,2$, and $Q_2=P_1-4P_2+4P_3$; conversely, if $Q_0=P_3$ and $Q_1$, $Q_2$ are any points, then
  $Q'(0)-P'(1)=3(Q_1-2P_3+P_2)$ and $Q''(0)-P''(1)=6(Q_2-P_1-2(Q_1-P_2))$
:method: Derivatives at the ends by the kernel; everything a variable.  Each coordinate is compared by itself: in space the same is true.
:scope: cubic curves
:over: q#: points
:control: $Q_2=P_1-2(Q_1-P_2)$
:::
*/
CLAIM(three_points_make_c2)
{
    num p[4 * dim], q[4 * dim], D[3 * dim], E[3 * dim], two = from_int(2), four = from_int(4);
    G(free_points)(T, 3, dim, p);
    for (int smooth = 1; smooth >= 0; smooth--) {
        for (int c = 0; c < dim; c++) {
            q[c] = p[3 * dim + c];
            q[dim + c] = smooth ? sub(mul(two, q[c]), p[2 * dim + c]) : unknown(T, "q", 2 + c);
            num step = mul(two, sub(q[dim + c], p[2 * dim + c]));
            num second = fault(T, add(p[dim + c], step), sub(p[dim + c], step));
            q[2 * dim + c] = smooth ? second : unknown(T, "q", 4 + c);
            q[3 * dim + c] = unknown(T, "q", 6 + c);
            about(T, "the second point");
            if (smooth)
                same(T, second, add(p[dim + c], mul(four, sub(p[3 * dim + c], p[2 * dim + c]))));
        }
        G(bezier_derivatives)(3, dim, p, from_int(1), 2, D);
        G(bezier_derivatives)(3, dim, q, from_int(0), 2, E);
        about(T, smooth ? "the derivatives at the joint" : "the gaps of the derivatives");
        for (int c = 0; c < dim; c++) {
            for (int k = 0; k <= 2 && smooth; k++)
                same(T, E[k * dim + c], D[k * dim + c]);
            if (smooth)
                continue;
            /* Q'(0) - P'(1) = 3 (Q_1 - 2P_3 + P_2),   Q''(0) - P''(1) = 6 (Q_2 - P_1 - 2 (Q_1 - P_2)) */
            num first = add(sub(q[dim + c], mul(two, p[3 * dim + c])), p[2 * dim + c]);
            num wanted = add(p[dim + c], mul(two, sub(q[dim + c], p[2 * dim + c])));
            same(T, sub(E[dim + c], D[dim + c]), mul(from_int(3), first));
            same(T, sub(E[2 * dim + c], D[2 * dim + c]), mul(from_int(6), sub(q[2 * dim + c], wanted)));
        }
    }
}

#if RATIONAL
/*
:::{claim} equal_derivatives_across_a_gap
:title: Equal derivatives of two curves that do not meet
:zh: 导矢相等而曲线不相接
:kind: counterexample
:data: P = 0 1 3 4; Q = 5 6 6 4
:instead: Q = 4 5 5 3
:result: P(1) = 4; P'(1) = 3; P''(1) = -6; Q(0) = 5; Q'(0) = 3; Q''(0) = -6
:given: two cubics of a line with the points $P$ and $Q$; $P_3\ne Q_0$
:then: the first and the second derivatives at the joint are equal, and the values are not
:method: The kernel at the ends.
:control: $Q$ moved to $P_3$
:::
*/
CLAIM(equal_derivatives_across_a_gap)
{
    static const char *const before[3] = {"P(1)", "P'(1)", "P''(1)"}, *const after[3] = {"Q(0)", "Q'(0)", "Q''(0)"};
    num P[4], Q[4], D[3], E[3];
    given_points(T, "P", 4, 1, P);
    given_points(T, "Q", 4, 1, Q);
    bezier_derivatives_q(3, 1, P, from_int(1), 2, D);
    bezier_derivatives_q(3, 1, Q, from_int(0), 2, E);
    for (int k = 0; k <= 2; k++)
        found(T, before[k], D[k]);
    for (int k = 0; k <= 2; k++)
        found(T, after[k], E[k]);
    about(T, "the derivatives");
    same(T, E[1], D[1]);
    same(T, E[2], D[2]);
    about(T, "the values");
    same(T, E[0], D[0]);
}

/*
:::{claim} equal_second_derivatives_with_unequal_first
:title: Equal second derivatives at a joint that is not C1
:zh: 连接点处二阶导矢相等而非 C1
:kind: counterexample
:data: P = (-3,3) (-2,1) (-1,0) (0,0); Q_1 = (2,0); Q_3 = (6,3)
:instead: Q_1 = (1,0)
:result: Q_2 = (4,1); P'(1) = (3,0); P''(1) = (0,6); Q'(0) = (6,0); Q''(0) = (0,6); κ² before = 4/9; κ² after = 1/36
:given: a cubic with the points $P$, and the next one with $Q_0=P_3$, the point $Q_1$ on the line of the last edge, twice as far from the
  joint as $P_2$, so that $a=2$, and $Q_2=P_1+2(Q_1-P_2)$ by the printed formula
:then: the second derivatives at the joint are equal, and the first are not; the curvature $\kappa$ jumps
:method: The kernels at the ends.
:control: $Q_1$ as far from the joint as $P_2$, that is $a=1$
:::
*/
CLAIM(equal_second_derivatives_with_unequal_first)
{
    num P[4 * dim], Q[4 * dim], D[3 * dim], E[3 * dim], two = from_int(2);
    given_points(T, "P", 4, dim, P);
    given_points(T, "Q_1", 1, dim, Q + dim);
    given_points(T, "Q_3", 1, dim, Q + 3 * dim);
    for (int c = 0; c < dim; c++) {
        Q[c] = P[3 * dim + c];
        Q[2 * dim + c] = add(P[dim + c], mul(two, sub(Q[dim + c], P[2 * dim + c]))); /* Q_2 = P_1 + 2 (Q_1 - P_2) */
    }
    bezier_derivatives_q(3, dim, P, from_int(1), 2, D);
    bezier_derivatives_q(3, dim, Q, from_int(0), 2, E);
    found_points(T, "Q_2", 1, dim, Q + 2 * dim);
    found_points(T, "P'(1)", 1, dim, D + dim);
    found_points(T, "P''(1)", 1, dim, D + 2 * dim);
    found_points(T, "Q'(0)", 1, dim, E + dim);
    found_points(T, "Q''(0)", 1, dim, E + 2 * dim);
    found(T, "κ² before", curvature_squared_q(dim, D + dim, D + 2 * dim));
    found(T, "κ² after", curvature_squared_q(dim, E + dim, E + 2 * dim));
    about(T, "the second derivatives");
    for (int c = 0; c < dim; c++)
        same(T, E[2 * dim + c], D[2 * dim + c]);
    about(T, "the first derivatives");
    for (int c = 0; c < dim; c++)
        same(T, E[dim + c], D[dim + c]);
}
#endif

/*
How wrong it is can be said exactly, for the curvature depends on the two derivatives by a formula of its own: the numerator is linear
in each, the denominator is the third power of the length of the first.

:::{claim} printed_condition_divides_the_curvature
:title: With the ratio a the printed condition divides the curvature by the square of a
:zh: 导矢之比为 a 且二阶导矢相等时曲率为原来的 1/a^2
:given: $P'\ne0$ and $P''$ at the joint, in the plane and in space, $a>0$; $Q'=aP'$, $Q''=P''$
:where: $a>0$; $P'\ne0$
:then: $Q'\times Q''=a\,P'\times P''$, and the square of the curvature is divided by $a^4$
:method: An identity with everything a variable.
:over: u# v#: derivatives; a
:control: divided by $a^2$
:::
*/
CLAIM(printed_condition_divides_the_curvature)
{
    enum { space = 3 };
    num d1[space], d2[space], e1[space], before[space], after[space], a = positive(T, "a", 0), square = mul(a, a);
    for (int c = 0; c < space; c++) {
        d1[c] = unknown(T, "u", c);
        d2[c] = unknown(T, "v", c);
        e1[c] = mul(a, d1[c]);
    }
    /* Q' x Q'' = a P' x P'', and a^4 times the square of the one curvature is that of the other */
    same(T, G(cross2)(e1, d2), mul(a, G(cross2)(d1, d2)));
    G(cross3)(d1, d2, before);
    G(cross3)(e1, d2, after);
    for (int c = 0; c < space; c++)
        same(T, after[c], mul(a, before[c]));
    num factor = fault(T, mul(square, square), square);
    for (int coordinates = dim; coordinates <= space; coordinates++)
        same(T, mul(factor, G(curvature_squared)(coordinates, e1, d2)), G(curvature_squared)(coordinates, d1, d2));
}

/*
:::{statement} slides-ch4:4-joint-c2-point
:title: The second point of the next polygon
:zh: C2 条件下的 Q2
:printed: from $Q_0-2Q_1+Q_2=P_3-2P_2+P_1$, with $Q_0=P_3$: $Q_2=P_1+2(Q_1-P_2)$
:holds-by: second_derivative_of_a_cubic three_points_make_c2
:needs: open_joint_has_no_second_point | the line itself, with $Q_0=P_3$, the first of the conditions before it | $Q_0=P_3$
:figure: second_derivatives_alone

It is true for any $Q_1$.  With $Q_1=2P_3-P_2$, that is, with equal first derivatives, it is $Q_2=P_1-4P_2+4P_3$.
:::
*/

#if RATIONAL
/*
:::{claim} open_joint_has_no_second_point
:title: Without a common point the formula for Q2 misses the condition
:zh: 不相接时公式不成立
:kind: counterexample
:data: P_1 = 0; P_2 = 1; P_3 = 2; Q_0 = 3; Q_1 = 4
:instead: Q_0 = 2
:result: Q_2 = 6; P_1 - 2P_2 + P_3 = 0; Q_0 - 2Q_1 + Q_2 = 1
:given: points of a line with $Q_0\ne P_3$, and $Q_2=P_1+2(Q_1-P_2)$ by the printed formula
:then: the two second differences are not equal
:method: Both sides of the condition.
:control: $Q_0=P_3$
:::
*/
CLAIM(open_joint_has_no_second_point)
{
    num P_1 = given(T, "P_1"), P_2 = given(T, "P_2"), P_3 = given(T, "P_3"), two = from_int(2);
    num Q_0 = given(T, "Q_0"), Q_1 = given(T, "Q_1"), Q_2 = add(P_1, mul(two, sub(Q_1, P_2)));
    num before = add(sub(P_1, mul(two, P_2)), P_3), after = add(sub(Q_0, mul(two, Q_1)), Q_2);
    found(T, "Q_2", Q_2);
    found(T, "P_1 - 2P_2 + P_3", before);
    found(T, "Q_0 - 2Q_1 + Q_2", after);
    about(T, "the second differences of the two polygons");
    same(T, after, before);
}
#endif

#include "chapters/judge/claims_off.h"
