/*
# The rational quadratic curve (有理二次曲线)

The two ratios of the last section have a constant product, so they are functions of one parameter $t$, and the
rational Bézier curve of degree 2 appears.  Coordinates are again those of the frame of the triangle.
*/
#include "exact/record/sign.h"

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"
#include "chapters/rational-bezier/conics.h"

/*
:::{statement} wang-ch3:3.1-xy-from-g
:title: The coordinates from the two ratios
:zh: 由 g_1,g_2 反解 x,y
:printed: x=\frac{g_1}{g_1+2+g_2},\quad y=\frac{g_2}{g_1+2+g_2}
:holds-by: signed_ratios_give_the_point ratios_of_lengths_inside_the_triangle ratios_on_the_curve
:hypothesis: lengths_give_another_point | $R$ lies inside the triangle, or the ratios have signs.
:needs: end_has_but_one_ratio | § 3.1: the tangent at $R$ meets $l_1=0$ and $l_2=0$ in $A$ and $B$ | both ratios exist: $R\ne
  R_0,R_2$.
:needs: tangent_parallel_to_the_first_side | § 3.1: the tangent at $R$ meets $l_1=0$ and $l_2=0$ in $A$ and $B$ | both ratios exist: the tangent is
  parallel to neither $l_1=0$ nor $l_2=0$.
:::

:::{statement} wang-ch3:3.1-R-from-g
:title: The point from the two ratios
:zh: 由 g_1,g_2 表示点 R
:printed: \mathbf R=\frac{g_1\mathbf R_0+2\mathbf R_1+g_2\mathbf R_2}{g_1+2+g_2}
:holds-by: signed_ratios_give_the_point ratios_of_lengths_inside_the_triangle ratios_on_the_curve
:hypothesis: lengths_give_another_point | $R$ lies inside the triangle, or the ratios have signs; the example compares the
  coordinate $x$ of the point.
:needs: end_has_but_one_ratio | § 3.1: the tangent at $R$ meets $l_1=0$ and $l_2=0$ in $A$ and $B$ | both ratios exist: $R\ne
  R_0,R_2$.
:needs: tangent_parallel_to_the_first_side | § 3.1: the tangent at $R$ meets $l_1=0$ and $l_2=0$ in $A$ and $B$ | both ratios exist: the tangent is
  parallel to neither $l_1=0$ nor $l_2=0$.
:::

:::{claim} signed_ratios_give_the_point
:title: The signed ratios determine the point
:zh: 带符号的比确定点
:given: a triangle, and a point with $x+y\ne1$, whose ratios are $g_1=\frac{-2x}{x+y-1}$ and $g_2=\frac{-2y}{x+y-1}$
:where: $x+y\ne1$
:then: $g_1+2+g_2=\frac{-2}{x+y-1}\ne0$, $x=\frac{g_1}{g_1+2+g_2}$, $y=\frac{g_2}{g_1+2+g_2}$ and
  $R_1+x(R_0-R_1)+y(R_2-R_1)=\frac{g_1R_0+2R_1+g_2R_2}{g_1+2+g_2}$
:method: Identities in $x$, $y$ and one coordinate of the triangle; the other coordinate is the same.  That the ratios are these is
  `ratios_on_the_curve`.
:control: 1 for 2 in the denominators
:::
*/
CLAIM(signed_ratios_give_the_point)
{
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), R[3], two = from_int(2), s = sub(add(x, y), from_int(1));
    for (int i = 0; i < 3; i++)
        R[i] = unknown(T, "R", i);
    num g1 = div(mul(from_int(-2), x), s), g2 = div(mul(from_int(-2), y), s);
    num total = add(add(g1, from_int(fault(T, 2, 1))), g2);
    /* g_1 + 2 + g_2 = -2/s, x = g_1/(g_1 + 2 + g_2), y = g_2/(g_1 + 2 + g_2) */
    same(T, total, div(from_int(-2), s));
    same(T, div(g1, total), x);
    same(T, div(g2, total), y);
    /* R_1 + x (R_0 - R_1) + y (R_2 - R_1) = (g_1 R_0 + 2 R_1 + g_2 R_2)/(g_1 + 2 + g_2) */
    num point = add(R[1], add(mul(x, sub(R[0], R[1])), mul(y, sub(R[2], R[1]))));
    same(T, point, div(add(add(mul(g1, R[0]), mul(two, R[1])), mul(g2, R[2])), total));
}

#if RATIONAL
/*
:::{claim} lengths_give_another_point
:title: Outside the triangle the ratios of lengths can lead to another point
:zh: 三角形外由长度之比得到另一点
:kind: counterexample
:data: λ = 1/2; R = (1,1)
:result: (g_1, g_2) = (2,2); x as printed = 1/3
:given: a $\lambda$ between 0 and 1, and a point $R=(x,y)$ of the curve (3.1.4) with the minus sign, outside the triangle, with its ratios of lengths
  $(g_1,g_2)$
:then: the printed $x$ is not that of the point
:method: The tangent is intersected with the sides, and the lengths are taken along these.
:control: the ratios with their signs
:::
*/
CLAIM(lengths_give_another_point)
{
    num lambda = given(T, "λ"), R[2], g[2], S[6];
    given_points(T, "R", 1, 2, R);
    G(frame_conic)(lambda, -1, S);
    ratios(lambda, -1, R[0], R[1], g);
    for (int c = 0; c < 2; c++)
        g[c] = fault(T, g[c], length(g[c]));
    num printed = div(g[0], add(add(g[0], from_int(2)), g[1]));
    found_points(T, "(g_1, g_2)", 1, 2, g);
    found(T, "x as printed", printed);
    about(T, "x, left as printed, right the point's");
    if (is_zero_q(G(form)(S, R[0], R[1])))
        same(T, printed, R[0]);
}
#endif

/*
Two positive numbers with a fixed product are one number and what is left.  The choice of the source is to let $\frac{1-t}t$
run through the positive numbers: it comes as a factor in $g_1$ and upside down in $g_2$, and the constants before it are
written as quotients of three weights (权因子), of which only the one ratio $\frac{\omega_0\omega_2}{\omega_1^2}$ matters.

:::{statement} wang-ch3:3.1-g-of-t
:title: A parameter for the two ratios
:zh: 令 g_1,g_2 为参数 t 的函数
:printed: Since $g_1g_2$ is constant, one may put $g_1=\frac{\omega_0(1-t)}{\omega_1t}$,
  $g_2=\frac{\omega_2t}{\omega_1(1-t)}$ with constants $\omega_0,\omega_1,\omega_2$.
:holds-by: each_pair_of_ratios_has_one_parameter
:needs: ratios_of_lengths_need_weights_of_one_sign | § 3.1, which introduces $g_1$, $g_2$ as quotients of lengths and says
  $\omega_0\omega_2/\omega_1^2>0$ below (3.1.5) | the weights are of one sign: $g_1$ and $g_2$ are ratios of lengths.
:needs: ratios_do_not_exist_at_the_ends | the sentence itself, by which $g_1g_2$ is constant, so that both ratios exist | $0<t<1$;
  the ends $R_0$ and $R_2$ come back in (3.1.5), where $0\le t\le1$.

Three negative weights have the ratios of their absolute values, so that weights of one sign may be taken positive.
:::
*/

/* omega_0 omega_2/omega_1^2 */
static inline num G(constant)(const num w[]) { return div(mul(w[0], w[2]), mul(w[1], w[1])); }

/* g_1 and g_2 at t; without_weight: omega_1 left out of g_2. */
static void G(ratios_at)(const num w[], num t, int without_weight, num g[])
{
    num s = sub(from_int(1), t);
    g[0] = div(mul(w[0], s), mul(w[1], t));
    g[1] = div(mul(w[2], t), without_weight ? s : mul(w[1], s));
}

/*
:::{claim} each_pair_of_ratios_has_one_parameter
:title: The pairs of positive numbers with one product, each at one t
:zh: 每对 (g_1,g_2) 对应唯一 t
:given: positive weights $\omega_0,\omega_1,\omega_2$, $t\in(0,1)$, and a number $g>0$
:let: $c=\frac{\omega_0\omega_2}{\omega_1^2}$ and $t_g=\frac{\omega_0}{\omega_0+\omega_1g}$
:then: $g_1g_2=c$; $0<t_g<1$, and at $t_g$ the ratios are $g$ and $c/g$; from $g=g_1(t)$ follows $t_g=t$; and every positive
  number $g$ is such a $c$, that of the weights $g,1,1$
:method: Identities in the weights, $t$ and $g$; $t_g$ and $1-t_g$ have positive coefficients.
:over: g t: -
:control: $\omega_1$ left out of $g_2$
:::
*/
CLAIM(each_pair_of_ratios_has_one_parameter)
{
    num w[3], t = parameter(T, "t"), ratio = positive(T, "g", 0), one = from_int(1), g[2];
    G(three_weights)(T, w);
    num c = G(constant)(w), tg = div(w[0], add(w[0], mul(w[1], ratio)));
    G(ratios_at)(w, t, fault(T, 0, 1), g);
    about(T, "the product");
    same(T, mul(g[0], g[1]), c);
    about(T, "t from g1");
    /* t = ω_0/(ω_0 + ω_1 g_1) */
    same(T, div(w[0], add(w[0], mul(w[1], g[0]))), t);
    G(must_be_positive)(T, tg);
    G(must_be_positive)(T, sub(one, tg));
    G(ratios_at)(w, tg, fault(T, 0, 1), g);
    about(T, "the ratios at t_g");
    same(T, g[0], ratio);
    same(T, g[1], div(c, ratio));
    about(T, "weights with a given constant");
    same(T, G(constant)((num[]){ratio, one, one}), ratio);
}

#if RATIONAL
/*
:::{claim} ratios_do_not_exist_at_the_ends
:title: At t = 0 and t = 1 one of the ratios does not exist
:zh: t=0,1 处的比不存在
:kind: counterexample
:data: ω_1 = 1; t = 0 1
:instead: t = 1/2 1/2
:result: denominators of the first ratio = 0 1; denominators of the second ratio = 1 0
:given: a weight $\omega_1$, and the first and the last parameter
:then: the denominator $\omega_1t$ of $g_1$ is 0 at the first, and that of $g_2$, $\omega_1(1-t)$, at the last parameter
:method: The denominators are computed at both parameters.
:control: the parameter in the middle
:::
*/
CLAIM(ratios_do_not_exist_at_the_ends)
{
    num w = given(T, "ω_1"), t[2], first[2], second[2];
    int missing = 0;
    given_points(T, "t", 2, 1, t);
    for (int k = 0; k < 2; k++) {
        first[k] = mul(w, t[k]);
        second[k] = mul(w, sub(from_int(1), t[k]));
        missing += is_zero_q(first[k]) || is_zero_q(second[k]);
    }
    found_points(T, "denominators of the first ratio", 2, 1, first);
    found_points(T, "denominators of the second ratio", 2, 1, second);
    about(T, "whether both ratios exist at one of the two parameters");
    refute(T, missing == 2);
}

/*
:::{claim} ratios_of_lengths_need_weights_of_one_sign
:title: Weights of both signs can give negative ratios
:zh: 权异号时 g_1,g_2 可为负
:kind: counterexample
:data: ω = 1 -1 1; t = 1/2
:instead: ω = 1 1 1
:result: (g_1, g_2) = (-1,-1); g_1 g_2 = 1
:given: weights $\omega$ of which the middle one is negative, and the parameter $t$ in the middle
:then: $g_1<0$ is no ratio of lengths, although $g_1g_2>0$
:method: The ratios are computed.
:control: positive weights
:::
*/
CLAIM(ratios_of_lengths_need_weights_of_one_sign)
{
    num w[3], g[2];
    given_points(T, "ω", 3, 1, w);
    G(ratios_at)(w, given(T, "t"), 0, g);
    found_points(T, "(g_1, g_2)", 1, 2, g);
    found(T, "g_1 g_2", mul(g[0], g[1]));
    about(T, "whether both ratios are positive");
    agree(T, sign_q(g[0]) > 0 && sign_q(g[1]) > 0);
}
#endif

/*
## The rational quadratic

:::{statement} wang-ch3:3.1.5
:title: The arc of the conic as a rational quadratic curve
:zh: 圆锥曲线段的有理二次参数表示
:printed: $\mathbf R=\mathbf R(t)=\frac{(1-t)^2\omega_0\mathbf R_0+2(1-t)t\omega_1\mathbf R_1+t^2\omega_2\mathbf R_2}
  {(1-t)^2\omega_0+2(1-t)t\omega_1+t^2\omega_2}$, $0\le t\le1$, represents the arc of the conic that the three points
  $R_0,R_1,R_2$ determine; it carries a constant, $g_1g_2=\frac{\omega_0\omega_2}{\omega_1^2}>0$.
:holds-by: rational_quadratic_of_the_arc every_point_of_the_arc_is_reached each_pair_of_ratios_has_one_parameter
:meant: the second half of the sentence, by which the representation carries a constant, and the ratios of lengths that lead to it, which tell the points inside the triangle |
  The three points and the constant determine the arc, which lies in the triangle.
:needs: complementary_arc_leaves_the_triangle | § 3.1, which introduces $g_1$, $g_2$ as quotients of lengths and says
  $\omega_0\omega_2/\omega_1^2>0$ below (3.1.5) | the weights are of one sign: $g_1$ and $g_2$ are ratios of lengths.
:needs: segment_does_not_fix_the_constant | the affine frame $\{R_1;R_1R_0,R_1R_2\}$ of § 3.1 | $R_0$, $R_1$, $R_2$ do not lie
  on a line.
:reading: rational_quadratic_of_the_arc | The arc inside the triangle, from $R_0$ to $R_2$, of the conic of the pencil that has this constant.
:reading-with: every_point_of_the_arc_is_reached each_pair_of_ratios_has_one_parameter
:reading: points_alone_do_not_determine_the_arc | The three points alone determine the arc; but two constants have
  two arcs.
:figure: tangent_ratios

The arc goes from $R_0$ to $R_2$ inside the triangle, and is all of the conic that is inside.  Three negative weights give the curve of their absolute values, so
that weights of one sign may be taken positive.
:::

Put $g_1$ and $g_2$ into the point and multiply numerator and denominator by $\omega_1t(1-t)$.  What comes out has the
Bernstein polynomials of degree 2 before the weights, and at $t=0$ and $t=1$ it has the values that the ratios did not have.

:::{claim} rational_quadratic_of_the_arc
:title: The ratios, put into the point, give the rational quadratic, which lies on the conic
:zh: 有理二次曲线及其所在的二次曲线
:given: a triangle, weights $\omega_0,\omega_1,\omega_2$ and $t$
:let: $g_1=\frac{\omega_0(1-t)}{\omega_1t}$, $g_2=\frac{\omega_2t}{\omega_1(1-t)}$,
  $\lambda=\frac{\omega_0\omega_2}{4\omega_1^2+\omega_0\omega_2}$
:then: $\frac{g_1R_0+2R_1+g_2R_2}{g_1+2+g_2}$ is the rational Bézier curve $R(t)$ of degree 2 with the points $R_i$ and
  weights $\omega_i$; in the frame it lies on (3.1.4) with the minus sign and this $\lambda$, for which
  $\frac{4\lambda}{1-\lambda}=\frac{\omega_0\omega_2}{\omega_1^2}$; for positive weights and $0<t<1$ it lies inside the
  triangle; $R(0)=R_0$, $R(1)=R_2$
:method: Identities in the weights, one coordinate of the points, and $t$; the coordinates of the frame are
  those of the curve with $R_0=(1,0)$, $R_1=(0,0)$, $R_2=(0,1)$; inside means that these two and $1-x-y$ are quotients
  with positive coefficients in $\frac t{1-t}$ and the weights.
:scope: 0 ≤ t ≤ 1
:over: t: -
:control: 1 for 2 before $R_1$
:::
*/
CLAIM(rational_quadratic_of_the_arc)
{
    num w[3], R[3], g[2], S[6], t = inside(T, "t"), zero = from_int(0), one = from_int(1), two = from_int(2), point;
    G(three_weights)(T, w);
    for (int i = 0; i < 3; i++)
        R[i] = unknown(T, "R", i);
    G(ratios_at)(w, t, 0, g);
    /* (g_1 R_0 + 2 R_1 + g_2 R_2)/(g_1 + 2 + g_2) = R(t) */
    num top = add(add(mul(g[0], R[0]), mul(fault(T, two, one), R[1])), mul(g[1], R[2]));
    G(rational_point)(2, 1, R, w, t, &point);
    about(T, "the point from the ratios; the rational curve");
    same(T, div(top, add(add(g[0], two), g[1])), point);

    num frame[6] = {one, zero, zero, zero, zero, one}, P[2];
    G(rational_point)(2, 2, frame, w, t, P);
    num outer = mul(w[0], w[2]), middle = mul(w[1], w[1]), lambda = div(outer, add(mul(from_int(4), middle), outer));
    G(frame_conic)(lambda, -1, S);
    about(T, "the conic along the curve");
    vanishes(T, G(form)(S, P[0], P[1]));
    /* 4λ/(1-λ) = ω_0 ω_2/ω_1² */
    same(T, div(mul(from_int(4), lambda), sub(one, lambda)), div(outer, middle));
    about(T, "inside the triangle");
    G(must_be_positive)(T, P[0]);
    G(must_be_positive)(T, P[1]);
    G(must_be_positive)(T, sub(one, add(P[0], P[1])));
    about(T, "the ends");
    G(rational_point)(2, 1, R, w, zero, &point);
    same(T, point, R[0]);
    G(rational_point)(2, 1, R, w, one, &point);
    same(T, point, R[2]);
}

/*
:::{claim} every_point_of_the_arc_is_reached
:title: Every point of the conic inside the triangle is a point of the curve
:zh: 三角形内二次曲线上的每一点都在曲线上
:given: positive weights; a point $x=\frac a{1+a+b}$, $y=\frac b{1+a+b}$ inside the triangle with $a>0$ and
  $b=\frac{\omega_0\omega_2}{4\omega_1^2a}$
:let: $\lambda=\frac{\omega_0\omega_2}{4\omega_1^2+\omega_0\omega_2}$, $t=\frac{\omega_0}{\omega_0+2\omega_1a}$
:then: $\frac{xy}{(x+y-1)^2}=ab=\frac\lambda{1-\lambda}$, and every point with $x>0$, $y>0$, $x+y<1$ has such $a$ and $b$, so
  that these are the points inside of (3.1.4) with the minus sign and this $\lambda$; $0<t<1$, and $R(t)$ is the point
:method: Identities in $a$ and the weights, in the frame $R_0=(1,0)$, $R_1=(0,0)$, $R_2=(0,1)$; $t$ and $1-t$ have positive
  coefficients.
:over: a: -
:control: $\omega_1$ for $2\omega_1$ in $t$
:::
*/
CLAIM(every_point_of_the_arc_is_reached)
{
    num w[3], a = positive(T, "a", 0), zero = from_int(0), one = from_int(1), two = from_int(2), P[2];
    G(three_weights)(T, w);
    num outer = mul(w[0], w[2]), middle = mul(from_int(4), mul(w[1], w[1])), b = div(outer, mul(middle, a));
    num total = add(one, add(a, b)), x = div(a, total), y = div(b, total), s = sub(add(x, y), one);
    num lambda = div(outer, add(middle, outer)), t = div(w[0], add(w[0], mul(fault(T, two, one), mul(w[1], a))));
    about(T, "the conic on which the point is");
    /* xy/(x+y-1)² = ab = λ/(1-λ) */
    same(T, div(mul(x, y), mul(s, s)), mul(a, b));
    same(T, mul(a, b), div(lambda, sub(one, lambda)));
    about(T, "t and 1 - t");
    G(must_be_positive)(T, t);
    G(must_be_positive)(T, sub(one, t));
    num frame[6] = {one, zero, zero, zero, zero, one};
    G(rational_point)(2, 2, frame, w, t, P);
    about(T, "the point and R(t)");
    same(T, P[0], x);
    same(T, P[1], y);
}

#if RATIONAL
/*
:::{claim} complementary_arc_leaves_the_triangle
:title: With a negative middle weight a point of the curve can be outside the triangle
:zh: 中间权为负时曲线可在三角形外
:kind: counterexample
:data: R = (1,0) (0,0) (0,1); ω = 2 -1 2; t = 1/2
:instead: ω = 2 1 2
:result: R(t) = (1,1)
:given: the points $R$ of the triangle in its frame, weights $\omega$ of which the middle one is negative, and the parameter in the middle
:then: $R(t)$ is outside the triangle
:method: The point is computed.
:control: the middle weight made positive
:::
*/
CLAIM(complementary_arc_leaves_the_triangle)
{
    num R[6], w[3], P[2];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    G(rational_point)(2, 2, R, w, given(T, "t"), P);
    found_points(T, "R(t)", 1, 2, P);
    about(T, "whether the point is in the triangle");
    agree(T, sign_q(P[0]) >= 0 && sign_q(P[1]) >= 0 && compare_q(add(P[0], P[1]), from_int(1)) <= 0);
}
#endif

#if RATIONAL
/*
:::{claim} points_alone_do_not_determine_the_arc
:title: Two constants, two arcs between the same three points
:zh: 三点相同而常量不同的两段弧
:kind: counterexample
:data: R = (1,0) (0,0) (0,1); ω = 1 1 1; ω* = 1 2 1; t = 1/2
:instead: ω* = 2 2 2
:result: constants = 1 1/4; R(t) = (1/4,1/4); R*(t) = (1/6,1/6)
:given: the points $R$ of the triangle in its frame, positive weights $\omega$ and $\omega^*$ of two curves, and the parameter $t$ in the middle
:then: the constants $\frac{\omega_0\omega_2}{\omega_1^2}$ differ, and so do the points of the two curves with $x=y$, of which each has one
:method: On either curve $x:y=\omega_0(1-t)^2:\omega_2t^2$, which is 1 in the middle, $\omega_0$ and $\omega_2$ being equal.
:control: weights of the same constant
:::
*/
CLAIM(points_alone_do_not_determine_the_arc)
{
    num R[6], w[3], v[3], P[2], Q[2], constant[2];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    given_points(T, "ω*", 3, 1, v);
    num t = given(T, "t");
    constant[0] = G(constant)(w);
    constant[1] = G(constant)(v);
    G(rational_point)(2, 2, R, w, t, P);
    G(rational_point)(2, 2, R, v, t, Q);
    found_points(T, "constants", 2, 1, constant);
    found_points(T, "R(t)", 1, 2, P);
    found_points(T, "R*(t)", 1, 2, Q);
    about(T, "x of the point with x = y on the two arcs");
    if (equal_q(P[0], P[1]) && equal_q(Q[0], Q[1]))
        same(T, P[0], Q[0]);
}
#endif

/*
:::{statement} wang-ch3:3.1-weights-may-vary
:title: The weights may change, but not their constant
:zh: 权可变而常量不变
:printed: The $\omega_i$ can be changed to change the form of (3.1.5), but the value of
  $g_1g_2=\frac{\omega_0\omega_2}{\omega_1^2}>0$ cannot be changed.
:holds-by: weights_with_one_constant_give_one_curve constant_is_read_off_the_curve
:needs: segment_does_not_fix_the_constant | the affine frame $\{R_1;R_1R_0,R_1R_2\}$ of § 3.1 | $R_0$, $R_1$, $R_2$ do not lie
  on a line.
:needs: sign_of_the_middle_weight_changes_the_arc | § 3.1, which introduces $g_1$, $g_2$ as quotients of lengths; the new
  weights have to give such, too | the new weights, too, are of one sign.
:meant: the sentence before, by which (3.1.5) represents one arc | The arc stays the same: what changes is its representation, and what does not is the constant.
:figure: middle_weight_sign

Three negative weights give the curve of their absolute values, so that weights of one sign may be taken positive.
:::

So the weights may be changed as long as the constant stays.  The curve is then the same, run through at another pace.
Conversely the constant is seen in every point of the curve between its ends, so that another constant gives another curve.  Both directions
have a condition: the sign of $\omega_1$ does not show in the constant, and on a line there is no frame in which the
constant could be seen.

:::{claim} weights_with_one_constant_give_one_curve
:title: Weights with the same constant give the same curve, with another parameter
:zh: 常量相同的权给出同一曲线
:given: positive weights $\omega_i$ and $\omega_i^*$ with
  $\frac{\omega_0\omega_2}{\omega_1^2}=\frac{\omega_0^*\omega_2^*}{(\omega_1^*)^2}$, points $R_i$, and $u\in[0,1]$
:let: $k=\frac{\omega_0\omega_1^*}{\omega_0^*\omega_1}>0$ and $t=\frac{ku}{ku+1-u}$
:then: $R^*(u)=R(t)$; $t$ grows from 0 to 1 with $u$: $0\le t\le1$, and $u=\frac t{t+k(1-t)}$
:method: Identities in $\omega_0,\omega_1,\omega_2,\omega_0^*,\omega_1^*$, from which $\omega_2^*$ follows, one coordinate
  of the points, and $u$ between the ends, where $t$ and $1-t$ have positive coefficients; and at both ends.
:over: v#: weights; u: -
:control: $k$ upside down
:::
*/
CLAIM(weights_with_one_constant_give_one_curve)
{
    num w[3], v[3], R[3], one = from_int(1), at[3] = {from_int(0), inside(T, "u"), one};
    for (int i = 0; i < 3; i++) {
        w[i] = positive(T, "w", i);
        v[i] = i < 2 ? positive(T, "v", i) : one;
        R[i] = unknown(T, "R", i);
    }
    /* with v for ω*: v_2 = ω_0 ω_2 v_1²/(ω_1² v_0), k = ω_0 v_1/(v_0 ω_1) */
    v[2] = div(mul(mul(w[0], w[2]), mul(v[1], v[1])), mul(mul(w[1], w[1]), v[0]));
    num k = div(mul(w[0], v[1]), mul(v[0], w[1]));
    k = fault(T, k, div(one, k));
    for (int m = 0; m < 3; m++) {
        /* t = ku/(ku + 1 - u) */
        num u = at[m], t = div(mul(k, u), add(mul(k, u), sub(one, u))), before, after;
        G(rational_point)(2, 1, R, v, u, &before);
        G(rational_point)(2, 1, R, w, t, &after);
        about(T, "R*(u) and R(t)");
        same(T, before, after);
        about(T, "t and u");
        nonnegative(T, t);
        nonnegative(T, sub(one, t));
        /* u = t/(t + k (1-t)) */
        same(T, div(t, add(t, mul(k, sub(one, t)))), u);
    }
}

/*
:::{claim} constant_is_read_off_the_curve
:title: Every point of the curve between its ends tells the constant
:zh: 由曲线上任一点读出常量
:given: a triangle, weights, and the point $R(t)$, $0<t<1$
:harmless: $0<t<1$ | one point between the ends tells the constant of the curve
:let: $x$ and $y$ be its coordinates in the frame, found from areas
:then: $\frac{4xy}{(x+y-1)^2}=\frac{\omega_0\omega_2}{\omega_1^2}$, so one curve cannot have two constants
:method: An identity in the six coordinates, the weights and $t$; at the ends numerator and denominator of
  the left side are 0.
:control: 2 for 4
:::
*/
CLAIM(constant_is_read_off_the_curve)
{
    num w[3], R[6], P[2], t = parameter(T, "t"), from[2], a[2], b[2];
    G(six)(T, "R", R);
    G(three_weights)(T, w);
    G(rational_point)(2, 2, R, w, t, P);
    for (int c = 0; c < 2; c++) {
        from[c] = sub(P[c], R[2 + c]);
        a[c] = sub(R[c], R[2 + c]);
        b[c] = sub(R[4 + c], R[2 + c]);
    }
    num d = G(cross2)(a, b), x = div(G(cross2)(from, b), d), y = div(G(cross2)(a, from), d);
    num s = sub(add(x, y), from_int(1));
    /* 4xy/(x+y-1)² = ω_0 ω_2/ω_1² */
    same(T, div(mul(from_int(fault(T, 4, 2)), mul(x, y)), mul(s, s)), G(constant)(w));
}

#if RATIONAL
/*
:::{claim} sign_of_the_middle_weight_changes_the_arc
:title: Two curves with one constant
:zh: 常量相同而曲线不同
:kind: counterexample
:data: R = (1,0) (0,0) (0,1); ω = 2 1 2; ω* = 2 -1 2; t = 1/2; t* = 1/2
:instead: ω* = 1 1 4; t* = 1/3
:result: constants = 4 4; R(t) = (1/3,1/3); R*(t*) = (1,1)
:given: the points $R$ of the triangle in its frame, weights $\omega$ and $\omega^*$ of two curves that differ in the sign of the middle one, and a parameter of
  either curve
:then: the constants $\frac{\omega_0\omega_2}{\omega_1^2}$ are equal, and the points of the two curves with $x=y$, $R(t)$
  and $R^*(t^*)$, are not
:method: On either curve $x:y=\omega_0(1-t)^2:\omega_2t^2$, so each has one point with $x=y$ in $0\le t\le1$.
:control: positive weights of the same constant
:::
*/
CLAIM(sign_of_the_middle_weight_changes_the_arc)
{
    num R[6], w[3], v[3], P[2], Q[2], constant[2];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    given_points(T, "ω*", 3, 1, v);
    num t = given(T, "t"), u = given(T, "t*");
    constant[0] = G(constant)(w);
    constant[1] = G(constant)(v);
    G(rational_point)(2, 2, R, w, t, P);
    G(rational_point)(2, 2, R, v, u, Q);
    found_points(T, "constants", 2, 1, constant);
    found_points(T, "R(t)", 1, 2, P);
    found_points(T, "R*(t*)", 1, 2, Q);
    about(T, "x of the point with x = y on the two curves");
    if (equal_q(constant[0], constant[1]) && equal_q(P[0], P[1]) && equal_q(Q[0], Q[1]))
        same(T, P[0], Q[0]);
}

/*
:::{claim} segment_does_not_fix_the_constant
:title: On a line the constant may change
:zh: 三点共线时常量可变
:kind: counterexample
:data: R = 0 1 2; ω = 1 1 1; ω* = 1 2 1
:instead: ω* = 1 2 4
:result: constants = 1 1/4
:given: three points $R$ in order on a line, and weights $\omega$ and $\omega^*$ of two curves
:then: both curves run through the segment from $R_0$ to $R_2$, each point once, with different constants
:method: Both derivatives are positive on $[0,1]$: with $R=N/\omega$ the sign of $N'\omega-N\omega'$ is decided.
:control: weights of the same constant
:::
*/
CLAIM(segment_does_not_fix_the_constant)
{
    num R[3], w[2][3], constant[2];
    int monotone = 1;
    given_points(T, "R", 3, 1, R);
    given_points(T, "ω", 3, 1, w[0]);
    given_points(T, "ω*", 3, 1, w[1]);
    for (int k = 0; k < 2; k++) {
        num N[3];
        for (int i = 0; i < 3; i++)
            N[i] = mul(w[k][i], R[i]);
        poly top = poly_from_bernstein(2, N), bottom = poly_from_bernstein(2, w[k]);
        poly turn = poly_sub(poly_mul(poly_derivative(top), bottom), poly_mul(top, poly_derivative(bottom)));
        monotone &= sign_on(turn, from_int(0), from_int(1), CLOSED) == SIGN_POSITIVE;
        constant[k] = G(constant)(w[k]);
    }
    found_points(T, "constants", 2, 1, constant);
    about(T, "the constants of the two curves");
    if (monotone)
        same(T, constant[0], constant[1]);
}
#endif

#include "chapters/judge/claims_off.h"
