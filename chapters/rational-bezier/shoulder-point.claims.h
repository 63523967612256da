/*
# The shoulder point (肩点)

A designer sees $\omega$: it is the ratio in which the curve divides the median of its triangle.
*/
#include "exact/record/roots.h"

#include "chapters/judge/claims_on.h"
#include "chapters/rational-bezier/conics.h"

/*
:::{statement} wang-ch3:3.5-shoulder
:title: The shoulder point
:zh: 肩点公式
:printed: By the proof of theorem 3.5.1 $\mathbf R_s=\mathbf R^*(u)_{u=1/2}=\frac1{1+\omega}\left(\frac{\mathbf R_0}2+\frac{\mathbf R_2}2\right)
  +\frac\omega{1+\omega}\mathbf R_1$.
:holds-by: shoulder_point_of_the_curve
:needs: shoulder_point_at_infinity | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive: so $\omega\ne-1$.
:figure: shoulder_point

On (3.1.5) itself this is the point of $t=\frac{\sqrt{\omega_0}}{\sqrt{\omega_0}+\sqrt{\omega_2}}$, which is $\frac12$ only
for $\omega_0=\omega_2$.
:::

:::{claim} shoulder_point_of_the_curve
:title: The point of parameter 1/2 of the standard form
:zh: 标准形参数 1/2 处的点
:given: points $R_0,R_1,R_2$ and positive weights $\omega_0=a^2$, $\omega_1$, $\omega_2=c^2$
:where: the weights are positive
:let: $\omega=\frac{\omega_1}{ac}$
:then: the kernel's standard weight is $\omega$; its shoulder point is the point at $\frac12$ of the curve with the weights
  $1,\omega,1$, the point at $\frac a{a+c}$ of the curve itself, and
  $\frac1{1+\omega}\frac{R_0+R_2}2+\frac\omega{1+\omega}R_1$
:method: Identities in $a$, $\omega_1$, $c$ and the six coordinates; every pair of positive outer weights is reached.
:defines: conic_standard_weight conic_shoulder_point
:over: a# c#: weights
:control: the point at $\frac12$ of the curve itself
:::
*/
CLAIM(shoulder_point_of_the_curve)
{
    num R[6], a, c, w[3], P[2], Q[2], shoulder[2], one = from_int(1), half = from_ratio(1, 2);
    G(six)(T, "R", R);
    G(square_ends)(T, &a, &c, w);
    num omega = div(w[1], mul(a, c)), v[3] = {one, omega, one}, total = add(one, omega);
    about(T, "the standard weight");
    same(T, G(conic_standard_weight)(w), omega);
    G(conic_shoulder_point)(R, w, shoulder);
    G(rational_point)(2, 2, R, v, half, P);
    G(rational_point)(2, 2, R, w, fault(T, div(a, add(a, c)), half), Q);
    for (int k = 0; k < 2; k++) {
        about(T, "the shoulder point and R*(1/2)");
        same(T, shoulder[k], P[k]);
        about(T, "the shoulder point and R(t)");
        same(T, shoulder[k], Q[k]);
        about(T, "the shoulder point as printed");
        /* (R_0 + R_2)/2/(1 + ω) + ω/(1 + ω) R_1 */
        num middle = div(mul(half, add(R[k], R[4 + k])), total);
        same(T, shoulder[k], add(middle, mul(div(omega, total), R[2 + k])));
    }
}

#if RATIONAL
/*
:::{claim} shoulder_point_at_infinity
:title: For the weight -1 there is no shoulder point
:zh: ω=-1 时无肩点
:kind: counterexample
:data: ω = 1 -1 1; u = 1/2
:instead: ω = 1 1 1
:result: ω(u) = 0
:given: standard weights with $\omega_1=-1$, and the parameter $u$ in the middle
:then: the denominator at $u$ is 0
:method: The denominator is computed.
:control: the middle weight with the other sign
:::
*/
CLAIM(shoulder_point_at_infinity)
{
    num w[3];
    given_points(T, "ω", 3, 1, w);
    num bottom = G(rational_weight)(2, w, given(T, "u"));
    found(T, "ω(u)", bottom);
    about(T, "whether R(u) exists");
    refute(T, is_zero_q(bottom));
}
#endif

/*
The point is a mean of $M$, the middle of the chord, and of the vertex $R_1$, with the weights 1 and $\omega$.  So it
stands on the median, and the heavier vertex draws it up.  Which of the two parts of the median is the 1 and which the
$\omega$ has to be said, and a print that does not say it can be read either way.

:::{statement} wang-ch3:3.5-median
:title: The curve divides the median in the ratio 1 to omega
:zh: 曲线将中线分成 1:ω
:printed: The point $R_s$ lies just on the median of the base of $\triangle R_1R_0R_2$, and this median is divided by the curve into two parts
  in the ratio $1:\omega$.
:holds-by: curve_divides_the_median
:needs: flat_triangle_may_have_no_median | the sentence, which names the triangle and its median | $R_0$, $R_1$, $R_2$ do not lie on a line.
:needs: negative_weight_leaves_the_median | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive: so $\omega>0$.
:meant: corollary 3.5.1, which names the parts | The parts are taken from the vertex.
:reading: curve_divides_the_median | The parts are taken from the vertex, $\|R_1R_s\|:\|R_sM\|=1:\omega$, as in corollary
  3.5.1.
:reading: median_from_the_base_is_the_other_way | The parts are taken from the base.
:figure: shoulder_point
:::

:::{claim} curve_divides_the_median
:title: The shoulder point on the median, and no other point of the curve
:zh: 肩点分中线，且曲线与中线只交一次
:given: a true triangle $R_0R_1R_2$, the weights $1,\omega,1$, $\omega>0$, and $u\in[0,1]$
:where: $R_0$, $R_1$, $R_2$ do not lie on a line; the weights are positive
:let: $M=\frac{R_0+R_2}2$ and $w(u)=(1-u)^2+2\omega u(1-u)+u^2$
:then: $R_s-M=\frac\omega{1+\omega}(R_1-M)$ and $R_1-R_s=\frac1{1+\omega}(R_1-M)$, so $\|R_1R_s\|:\|R_sM\|=1:\omega$; and
  $w(u)\,(R_1-M)\times(R^*(u)-M)=(1-2u)\,(R_1-M)\times(R_0-M)$, so the curve meets the line $R_1M$ only for $u=\frac12$
:method: Identities in the six coordinates, $\omega$ and $u$; the cross product on the right is not 0 for a true
  triangle.
:over: u: -
:control: the point $M$ at one third of the chord
:::
*/
CLAIM(curve_divides_the_median)
{
    num R[6], P[2], shoulder[2], M[2], one = from_int(1), two = from_int(2), omega = positive(T, "w", 1);
    num u = parameter(T, "u"), w[3] = {one, omega, one}, total = add(one, omega);
    G(six)(T, "R", R);
    G(rational_point)(2, 2, R, w, u, P);
    G(rational_point)(2, 2, R, w, from_ratio(1, 2), shoulder);
    for (int c = 0; c < 2; c++) {
        M[c] = fault(T, div(add(R[c], R[4 + c]), two), div(add(add(R[c], R[c]), R[4 + c]), from_int(3)));
        num median = sub(R[2 + c], M[c]);
        about(T, "R_s - M");
        /* R_s - M = ω/(1 + ω) (R_1 - M) */
        same(T, sub(shoulder[c], M[c]), mul(div(omega, total), median));
        about(T, "R_1 - R_s");
        /* R_1 - R_s = (R_1 - M)/(1 + ω) */
        same(T, sub(R[2 + c], shoulder[c]), div(median, total));
    }
    about(T, "the side of the median on which R*(u) lies");
    num weight = G(rational_weight)(2, w, u);
    /* w(u) (R_1 - M) × (R*(u) - M) = (1 - 2u) (R_1 - M) × (R_0 - M) */
    same(T, mul(weight, G(area)(M, R + 2, P)), mul(sub(one, mul(two, u)), G(area)(M, R + 2, R)));
}

#if RATIONAL
/* M = (R_0 + R_2)/2 */
static void G(middle_of_the_chord)(const num R[], num M[])
{
    for (int c = 0; c < 2; c++)
        M[c] = mul(from_ratio(1, 2), add(R[c], R[4 + c]));
}

/*
:::{claim} flat_triangle_may_have_no_median
:title: With the vertex in the middle of the base the median is a point
:zh: 顶点在底边中点时中线退化为一点
:kind: counterexample
:data: R = (-1,0) (0,0) (1,0); ω = 1 1/2 1
:instead: R = (-1,0) (0,1) (1,0)
:result: M = (0,0); R_s = (0,0)
:given: three points $R$ of a line, $R_1$ in the middle of $R_0R_2$, and standard weights with $0<\omega_1<1$
:then: $R_1=R_s=M$: both parts have the length 0, and no ratio
:method: The points are computed; that $R_1$ differs from $M$ is what is compared.
:control: $R_1$ moved off the line
:::
*/
CLAIM(flat_triangle_may_have_no_median)
{
    num R[6], w[3], M[2], P[2];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    G(middle_of_the_chord)(R, M);
    G(conic_shoulder_point)(R, w, P);
    found_points(T, "M", 1, 2, M);
    found_points(T, "R_s", 1, 2, P);
    about(T, "whether the median has a length");
    refute(T, equal_q(R[2], M[0]) && equal_q(R[3], M[1]));
}

/*
:::{claim} negative_weight_leaves_the_median
:title: With a negative weight the shoulder point need not be between vertex and base
:zh: ω<0 时肩点可不在中线段上
:kind: counterexample
:data: R = (-1,0) (0,1) (1,0); ω = 1 -1/2 1
:instead: ω = 1 1/2 1
:result: M = (0,0); R_s = (0,-1)
:given: the points $R$ of a triangle and standard weights with $-1<\omega_1<0$
:then: $R_s$ is below the base: the median is not divided
:method: The point is computed; the median lies on the second axis.
:control: the middle weight with the other sign
:::
*/
CLAIM(negative_weight_leaves_the_median)
{
    num R[6], w[3], M[2], P[2];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    G(middle_of_the_chord)(R, M);
    G(conic_shoulder_point)(R, w, P);
    found_points(T, "M", 1, 2, M);
    found_points(T, "R_s", 1, 2, P);
    about(T, "whether R_s lies between M and R_1");
    agree(T, equal_q(P[0], M[0]) && compare_q(P[1], M[1]) >= 0 && compare_q(P[1], R[3]) <= 0);
}

/*
:::{claim} median_from_the_base_is_the_other_way
:title: From the base the ratio is omega to 1
:zh: 自底边起为 ω:1
:kind: counterexample
:data: R = (-1,0) (0,1) (1,0); ω = 1 1/2 1
:result: M = (0,0); R_s = (0,1/3); ‖MR_s‖ : ‖R_sR_1‖ = 1/2; 1 : ω_1 = 2
:given: the points $R$ of a triangle and standard weights with $\omega_1\ne1$
:then: $\|MR_s\|:\|R_sR_1\|$ is $\omega_1$, which is not $1:\omega_1$
:method: The point is computed; the median lies on the second axis.
:control: $\|R_1R_s\|:\|R_sM\|$
:::
*/
CLAIM(median_from_the_base_is_the_other_way)
{
    num R[6], w[3], M[2], P[2];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    G(middle_of_the_chord)(R, M);
    G(conic_shoulder_point)(R, w, P);
    num lower = sub(P[1], M[1]), upper = sub(R[3], P[1]), ratio = div(lower, upper), printed = div(from_int(1), w[1]);
    found_points(T, "M", 1, 2, M);
    found_points(T, "R_s", 1, 2, P);
    found(T, "‖MR_s‖ : ‖R_sR_1‖", ratio);
    found(T, "1 : ω_1", printed);
    about(T, "the ratio of the parts from the base, and 1 : ω");
    same(T, fault(T, div(upper, lower), ratio), printed);
}
#endif

/*
So a drawing tells the kind of the conic without any equation: one compares the two parts of the median.  For a
parabola the shoulder point is in the middle, for an ellipse nearer to the chord, for a hyperbola nearer to the
vertex.

:::{statement} wang-ch3:cor-3.5.1
:title: Classification by the shoulder point
:zh: 推论 3.5.1：按肩点分类
:printed: Let the rational quadratic Bézier curve (3.1.5) meet the median $R_1M$ of $\triangle R_1R_0R_2$ to the base
  $R_0R_2$ in the shoulder point $R_s$.  If $\frac{\|R_sM\|}{\|R_1R_s\|}=\omega$, the curve is an ellipse, a parabola or a
  hyperbola for $\omega<1$, $\omega=1$ or $\omega>1$.
:holds-by: shoulder_ratio_is_the_root_of_the_invariant sign_of_the_discriminant kind_in_any_coordinates
  directions_at_infinity
:needs: flat_triangle_has_a_shoulder_point | the corollary, which names the triangle and its median | $R_0$, $R_1$, $R_2$ do not
  lie on a line.
:needs: weight_zero_has_ratio_zero | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive: so $\omega_1\ne0$.
:meant: theorem 3.5.2, whose circular arcs have $I_1<1$ | A circle is an ellipse.
:figure: shoulder_point

The ratio is $\frac{\omega_1}{\sqrt{\omega_0\omega_2}}=\sqrt{I_1}$ for all positive weights, not only for standard ones.
:::

:::{claim} shoulder_ratio_is_the_root_of_the_invariant
:title: The square of the shoulder ratio is the invariant
:zh: 肩点比的平方等于 I_1
:given: a true triangle and positive weights $\omega_0=a^2$, $\omega_1$, $\omega_2=c^2$
:where: $R_0$, $R_1$, $R_2$ do not lie on a line; the weights are positive
:let: $R_s$ be the point of the curve on the median, $t=\frac a{a+c}$, and $M=\frac{R_0+R_2}2$
:then: $\|R_sM\|^2=I_1\|R_1R_s\|^2$; and $\omega(u)\,(R_1-M)\times(R(u)-M)=(a(1-u)-cu)(a(1-u)+cu)\,(R_1-M)\times(R_0-M)$, so the curve
  meets the line $R_1M$ only for $u=t$, and $R_s-M=\frac{\omega_1}{ac+\omega_1}(R_1-M)$ is between
:method: The point is taken on the curve (3.1.5) itself; identities in the six coordinates, $a$, $\omega_1$, $c$ and $u$.  Both
  ratios are positive, so that $\omega=\sqrt{I_1}$, and $\omega<1$, $=1$, $>1$ with $I_1$.
:over: a# c#: weights; u: -
:control: $I_1$ upside down
:::
*/
CLAIM(shoulder_ratio_is_the_root_of_the_invariant)
{
    num R[6], a, c, w[3], P[2], I[1], half = from_ratio(1, 2), base = from_int(0), vertex = base;
    G(six)(T, "R", R);
    G(square_ends)(T, &a, &c, w);
    G(rational_point)(2, 2, R, w, div(a, add(a, c)), P);
    G(rational_invariants)(2, w, I);
    num M[2], Q[2], share = div(w[1], add(mul(a, c), w[1])), u = parameter(T, "u"), rest = sub(from_int(1), u);
    for (int k = 0; k < 2; k++) {
        M[k] = mul(half, add(R[k], R[4 + k]));
        num down = sub(P[k], M[k]), up = sub(R[2 + k], P[k]);
        base = add(base, mul(down, down));
        vertex = add(vertex, mul(up, up));
        about(T, "R_s - M");
        /* R_s - M = ω_1/(ac + ω_1) (R_1 - M) */
        same(T, down, mul(share, sub(R[2 + k], M[k])));
    }
    about(T, "the two parts of the median");
    /* ‖R_sM‖² = I_1 ‖R_1R_s‖² */
    same(T, base, fault(T, mul(I[0], vertex), div(vertex, I[0])));
    about(T, "the side of the median on which R(u) lies");
    G(rational_point)(2, 2, R, w, u, Q);
    num side = mul(sub(mul(a, rest), mul(c, u)), add(mul(a, rest), mul(c, u)));
    /* ω(u) (R_1 - M) × (R(u) - M) = (a(1-u) - cu)(a(1-u) + cu) (R_1 - M) × (R_0 - M) */
    same(T, mul(G(rational_weight)(2, w, u), G(area)(M, R + 2, Q)), mul(side, G(area)(M, R + 2, R)));
}

#if RATIONAL
/* For the data R and ω of the claim: refutes that a shoulder ratio below 1 makes the conic an ellipse. */
static void ellipse_by_shoulder(trial *T)
{
    num R[6], w[3], S[6], P[2], M[2];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    G(middle_of_the_chord)(R, M);
    G(conic_shoulder_point)(R, w, P);
    G(conic_of_bezier)(R, w, S);
    num base = from_int(0), vertex = base;
    for (int c = 0; c < 2; c++) {
        base = add(base, mul(sub(P[c], M[c]), sub(P[c], M[c])));
        vertex = add(vertex, mul(sub(R[2 + c], P[c]), sub(R[2 + c], P[c])));
    }
    found_points(T, "M", 1, 2, M);
    found_points(T, "R_s", 1, 2, P);
    found(T, "square of the ratio", div(base, vertex));
    found_points(T, "A, …, F", 6, 1, S);
    found(T, "AC-B²", G(conic_delta)(S));
    about(T, "whether the conic is an ellipse");
    refute(T, compare_q(base, vertex) < 0 && sign_q(G(conic_delta)(S)) <= 0);
}

/*
:::{claim} flat_triangle_has_a_shoulder_point
:title: On a line there is a shoulder ratio but no ellipse
:zh: 三点共线时有肩点比而非椭圆
:kind: counterexample
:data: R = (-2,0) (3,0) (2,0); ω = 1 1/2 1
:instead: R = (-2,0) (3,1) (2,0)
:result: M = (0,0); R_s = (1,0); square of the ratio = 1/4; A, …, F = 0 0 21/4 0 0 0; AC-B² = 0
:given: three points $R$ of a line and standard weights with $0<\omega_1<1$; the conic of these by the $A,\dots,F$ of (3.1.1)
:then: the ratio of $R_sM$ to $R_1R_s$ is below 1, but the curve lies on a line
:method: The point and the conic are computed.
:control: $R_1$ moved off the line
:::
*/
CLAIM(flat_triangle_has_a_shoulder_point) { ellipse_by_shoulder(T); }

/*
:::{claim} weight_zero_has_ratio_zero
:title: The weight 0 has the ratio 0 and gives no ellipse
:zh: ω_1=0 时肩点比为 0 而非椭圆
:kind: counterexample
:data: R = (-1,0) (0,1) (1,0); ω = 1 0 1
:instead: ω = 1 1/2 1
:result: M = (0,0); R_s = (0,0); square of the ratio = 0; A, …, F = 0 0 1 0 0 0; AC-B² = 0
:given: the points $R$ of a triangle, and the weights $\omega$ with $\omega_1=0$; the conic of these by the $A,\dots,F$ of (3.1.1)
:then: $R_s=M$, the ratio is 0, but $AC-B^2=0$: the conic $y^2=0$ is no ellipse
:method: The point and the conic are computed.
:control: a positive middle weight
:::
*/
CLAIM(weight_zero_has_ratio_zero) { ellipse_by_shoulder(T); }
#endif

#include "chapters/judge/claims_off.h"
