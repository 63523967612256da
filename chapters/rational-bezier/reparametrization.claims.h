/*
# Changing the parameter (分式线性参数变换)

A rational curve can be run through at another speed without leaving its class: replace $t$ by a
fractional linear function of a new parameter $u$ that maps $[0,1]$ onto itself.  The points stay where
they are, the weight $\omega_i$ is multiplied by $a^ib^{n-i}$, and the quotients
$I_i=\omega_i^2/(\omega_{i-1}\omega_{i+1})$ do not notice.  This section decides property 3.2.10, its
proof line by line; definition 3.2.2 of the $I_i$ is in the next one.
*/
#include "exact/record/sign.h"

#include "chapters/judge/elementary.h"
#include "chapters/rational-bezier/free-curve.h"
#include "chapters/rational-bezier/one-map.h"

#include "chapters/judge/claims_on.h"

/*
## The transformation

:::{statement} wang-ch3:3.2.10
:title: The change of parameter maps the unit interval onto itself
:zh: 参数变换把单位区间映到自身
:printed: t=au/[au+b(1-u)],\quad 0\le u\le1
:definition: yes
:checked-by: fractional_change_runs_once
:confirmed-by: projective_change_of_unit_interval_is_fractional
:needs: linear_curve_with_opposite_ratios_has_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the
  weights are positive: so $a,b>0$; otherwise the denominator can vanish inside $[0,1]$
:figure: reparametrization

Every projective map of the parameter line that fixes $0$ and $1$ has this form.
:::
*/

/* The parameter t = a u / (a u + b (1-u)) of formula 3.2.10. */
static num G(old_parameter)(num a, num b, num u)
{
    num share = mul(a, u);
    return div(share, add(share, mul(b, sub(from_int(1), u))));
}

#if FIELD
/*
:::{claim} fractional_change_runs_once
:title: With a, b > 0 the parameter t runs once from 0 to 1 while u does
:zh: a,b>0 时 t 随 u 从 0 单调增到 1
:types: field
:given: $a,b>0$ and $0<u<1$
:let: $t=au/(au+b(1-u))$
:then: $t=0,1$ for $u=0,1$; $0<t<1$; $dt/du>0$; and $u=bt/(bt+a(1-t))$
:method: With $u=s/(1+s)$, $s>0$, numerators and denominators of $t$, $1-t$ and $dt/du$ have positive coefficients
  only; the inverse is an identity of rational functions.
:scope: 0 ≤ u ≤ 1
:over: a b: coefficient of (3.2.10); u s: -
:control: the sign of the derivative reversed
:::
*/
CLAIM(fractional_change_runs_once)
{
    num a = positive(T, "a", 0), b = positive(T, "b", 0), u = variable_f("u"), one = from_int(1);
    num t = G(old_parameter)(a, b, u);
    about(T, "the ends");
    vanishes(T, substitute_f(t, u, from_int(0)));
    same(T, substitute_f(t, u, one), one);
    about(T, "signs inside");
    num inside_it = inside(T, "s"), values[] = {t, sub(one, t), fault(T, derivative_f(t, u), neg(derivative_f(t, u)))};
    for (int k = 0; k < 3; k++) {
        num value = substitute_f(values[k], u, inside_it);
        nonnegative(T, value);
        agree(T, !is_zero_f(value));
    }
    about(T, "the inverse");
    same(T, G(old_parameter)(b, a, t), u);
}
#endif

/*
One might ask why the new parameter has just this form.  Rational curves of degree $n$ stay of degree $n$ under the
projective maps of the parameter line, and of these the ones that fix both ends of the interval have one number at
choice, $a/b$.

:::{claim} projective_change_of_unit_interval_is_fractional
:title: A projective change of parameter that fixes 0 and 1 is of the printed form
:zh: 保持 0 与 1 的射影参数变换必为所印形式
:given: $t=(\alpha u+\beta)/(\gamma u+\delta)$ with $t(0)=0$ and $t(1)=1$
:then: $t=au/(au+b(1-u))$ with $a=\alpha$, $b=\delta$
:method: $t(0)=0$ says $\beta=0$, and then $t(1)=1$ says $\gamma=\alpha-\delta$; with these the two fractions are one
  rational function of $\alpha,\delta,u$.
:scope: all projective maps that fix 0 and 1
:over: alpha delta: -; u
:control: $t(1)=1$ solved as $\gamma=\alpha+\delta$
:::
*/
CLAIM(projective_change_of_unit_interval_is_fractional)
{
    num alpha = positive(T, "alpha", 0), delta = positive(T, "delta", 0), u = parameter(T, "u");
    num gamma = fault(T, sub(alpha, delta), add(alpha, delta));
    num t = div(mul(alpha, u), add(mul(gamma, u), delta));
    same(T, t, G(old_parameter)(alpha, delta, u));
}

/*
:::{statement} wang-ch3:3.2.14
:title: The curve in the new parameter
:zh: 新参数下的曲线
:printed: (3.2.10) put into (3.2.2) gives $\mathbf R^*(u)=\sum_{i=0}^nB_i^n(u)a^ib^{n-i}\omega_i\mathbf
  R_i\Big/\sum_{i=0}^nB_i^n(u)a^ib^{n-i}\omega_i$, $0\le u\le1$.
:holds-by: fractional_change_term_by_term
:confirmed-by: fractional_change_keeps_curve
:needs: linear_curve_with_opposite_ratios_has_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  $au+b(1-u)\ne0$: positive weights give it, as $a,b>0$; otherwise both denominators can vanish inside $[0,1]$
:needs: weights_of_both_signs_make_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\omega(t)\ne0$:
  otherwise there is no point $\mathbf R(t)$

As an identity it holds for any numbers $a$ and $b$, as long as the denominators do not vanish.
:::
*/

/*
Put into $B_i^n(t)$, the powers of $t$ bring $(au)^i$ and those of $1-t$ bring $(b(1-u))^{n-i}$, over the common
denominator $D^n$, which cancels in the quotient.  So the points stay, and the whole change is in the weights.

:::{claim} fractional_change_keeps_curve
:title: Weights multiplied by powers of a and b give the same curve in the new parameter
:zh: 权乘以 a^i b^{n-i} 后曲线不变
:given: weights $\omega_0,\dots,\omega_n$, points $R_0,\dots,R_n$, and $a,b,u$
:let: $t=au/D$, $D=au+b(1-u)$, and $\omega_i'=a^ib^{n-i}\omega_i$
:then: $\sum B_i^n(u)\omega'_i=D^n\omega(t)$, and the curve of $(R,\omega')$ at $u$ is $R(t)$
:method: Each side is an element of the field of rational functions of all the data.  As $u$ is a variable and the
  Bernstein polynomials are independent, the first equality determines every $\omega_i'$.
:degrees: 1..6 sampled 12
:defines: rational_reparametrize
:over: a; b
:control: $a$ and $b$ exchanged in the weights
:::
*/
CLAIM(fractional_change_keeps_curve)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], v[MAX_DEGREE + 1], before, after;
    num a = unknown(T, "a", 0), b = unknown(T, "b", 0), u = parameter(T, "u");
    G(curve_of_any_weights)(T, n, 1, R, w);
    num D = add(mul(a, u), mul(b, sub(from_int(1), u))), t = G(old_parameter)(a, b, u);
    G(rational_reparametrize)(n, w, fault(T, a, b), fault(T, b, a), v);
    about(T, "the denominators: ω'(u) = D^n ω(t)");
    same(T, G(rational_weight)(n, v, u), mul(G(power)(D, n), G(rational_weight)(n, w, t)));
    about(T, "the points: R'(u) = R(t)");
    G(rational_point)(n, 1, R, v, u, &after);
    G(rational_point)(n, 1, R, w, t, &before);
    same(T, after, before);
}

/*
:::{claim} fractional_change_term_by_term
:title: Each Bernstein term keeps its shape, in every degree
:zh: 逐项变换:任意次数
:given: any $a,b,u$ with $D=au+b(1-u)\ne0$; a power $E$ of $D$ and a product $F$ of as many factors, each $t$ or $1-t$; $C$ a binomial coefficient
:where: $au+b(1-u)\ne0$
:let: $t=au/D$
:then: $Dt=au$ and $D(1-t)=b(1-u)$; so $(ED)(Ft)=EF\cdot au$ and $(ED)(F(1-t))=EF\cdot b(1-u)$, and the same times $C\omega_i$ and times $C\omega_iR_i$
:method: The steps of an induction on the number of factors, which begins with $E=F=1$: with $i$ factors $t$ and $n-i$ factors $1-t$ it is
  $D^nt^i(1-t)^{n-i}=a^ib^{n-i}u^i(1-u)^{n-i}$, and so $D^nB_i^n(t)=a^ib^{n-i}B_i^n(u)$ for all $i\le n$.  Multiply by $\omega_i$ or $\omega_iR_i$ and add; $D^n$ cancels in
  the quotient.  Outside the field $n$ and $i$ are random integers, and this result is computed with true binomial coefficients.
:degrees: all
:over: a b: coefficient of (3.2.10); C E F: -
:control: $a$ and $b$ exchanged
:::
*/
CLAIM(fractional_change_term_by_term)
{
    num one = from_int(1), a = positive(T, "a", 0), b = positive(T, "b", 0), u = parameter(T, "u");
    num ahead = mul(fault(T, a, b), u), behind = mul(fault(T, b, a), sub(one, u));
    num D = add(mul(a, u), mul(b, sub(one, u))), t = G(old_parameter)(a, b, u), rest = sub(one, t);
#if !FIELD
    int index = pick(T, 0, 6), degree = index + pick(T, 0, 6);
    num old[MAX_DEGREE + 1], new[MAX_DEGREE + 1];
    about(T, "D^n B_i^n(t) = a^i b^(n-i) B_i^n(u)");
    G(bernstein_basis)(degree, t, old);
    G(bernstein_basis)(degree, u, new);
    num factor = mul(G(power)(fault(T, a, b), index), G(power)(fault(T, b, a), degree - index));
    same(T, mul(G(power)(D, degree), old[index]), mul(factor, new[index]));
#endif
    about(T, "D t and D (1-t)");
    same(T, mul(D, t), ahead);
    same(T, mul(D, rest), behind);
    num E = unknown(T, "E", 0), F = unknown(T, "F", 0), product = mul(E, F), more = mul(E, D);
    num C = unknown(T, "C", 0), w = positive(T, "w", 0), x = unknown(T, "x", 0),
        scale[] = {from_int(1), mul(C, w), mul(mul(C, w), x)};
    static const char *const of[] = {"one factor more", "the same times the weight of the term",
                                     "the same times weight and point"};
    for (int k = 0; k < 3; k++) {
        about(T, of[k]);
        same(T, mul(scale[k], mul(more, mul(F, t))), mul(scale[k], mul(product, ahead)));
        same(T, mul(scale[k], mul(more, mul(F, rest))), mul(scale[k], mul(product, behind)));
    }
}

/*
## Which weights can be reached

:::{statement} wang-ch3:3.2.12
:title: The quotients of neighbouring weights
:zh: 相邻权的比
:printed: I_i=I_i^*,\quad I_i=\frac{\omega_i^2}{\omega_{i-1}\omega_{i+1}},\quad
  I_i^*=\frac{\omega_i^{*2}}{\omega_{i-1}^*\omega_{i+1}^*},\quad i=1,\dots,n-1
:definition: yes
:checked-by: equal_invariants_mean_geometric_ratios
:confirmed-by: invariants_by_definition

Each condition is about three neighbouring weights: the claim says what it means for them.  For $n=1$ there is no condition.
:::

The weight $\omega_i$ is multiplied by $a^ib^{n-i}$, a geometric sequence.  A square divided by the product of its two
neighbours does not see such a factor, and this is how the quotients $I_i$ are found.

:::{claim} invariants_by_definition
:title: The computed quotients are those of the formula
:zh: 不变量的定义
:given: weights $\omega_0,\dots,\omega_n$, none of them $0$
:where: no weight is 0
:then: $I_i\,\omega_{i-1}\omega_{i+1}=\omega_i^2$, $i=1,\dots,n-1$
:method: The quotients are computed by the program, the products here.
:degrees: 2..8 sampled 24
:defines: rational_invariants
:control: $\omega_{i-1}$ for $\omega_{i+1}$
:::
*/
CLAIM(invariants_by_definition)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], I[MAX_DEGREE];
    for (int i = 0; i <= n; i++)
        w[i] = unknown(T, "w", i);
    G(rational_invariants)(n, w, I);
    for (int i = 1; i < n; i++)
        same(T, mul(I[i - 1], mul(w[i - 1], fault(T, w[i + 1], w[i - 1]))), mul(w[i], w[i]));
}

/*
:::{statement} wang-ch3:3.2.11
:title: The factors a and b, from the first and the last weight
:zh: 由首末权确定 a 与 b
:printed: a=\sqrt[n]{\omega_n^{*}/\omega_n},\quad b=\sqrt[n]{\omega_0^{*}/\omega_0}
:definition: yes
:checked-by: equal_invariants_mean_geometric_ratios factors_make_a_geometric_sequence larger_numbers_have_larger_powers
:confirmed-by: end_weights_give_the_factors
:needs: negated_weights_have_no_real_factors | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive: otherwise, for even $n$, the roots need not be real

The two numbers are to give $a^ib^{n-i}\omega_i=\omega_i^*$ under (3.2.12).  For $i=0$ and $i=n$ this is the definition; for the others it follows because the ratios
$\omega_i^{*}/\omega_i$ are geometric and positive numbers have one positive $n$-th root.
:::
*/

#if RATIONAL
/*
Formula (3.2.11) takes two $n$-th roots.  For positive weights they are taken of positive numbers.  But weights with a
common negative sign give the same curve, and then, for even $n$, there is no root to take.

:::{claim} negated_weights_have_no_real_factors
:title: In even degree the roots need not be real, though the curve is the same
:zh: 偶次时根可非实数而曲线相同
:kind: decision
:data: R = 0 1 3; ω = 1 2 3; ω* = -1 -2 -3; t = 1/3
:instead: ω* = -1 -2 3
:result: I_1 = 4/3; I*_1 = 4/3; R(t) = 17/15; R*(t) = 17/15; ω*_0/ω_0 = -1; ω*_2/ω_2 = -1
:given: $n=2$, points $R$ of a line, weights $\omega$, and $\omega^*=-\omega$; a parameter $t$
:then: $I_1=I_1^*$ and the curves are the same, but $\omega_0^{*}/\omega_0=\omega_2^{*}/\omega_2=-1$ has no real
  square root
:method: The two curves are compared as polynomials, by cross products of numerators and denominators, and at one parameter $t$.
:control: $\omega_2^*$ positive
:::
*/
CLAIM(negated_weights_have_no_real_factors)
{
    enum { n = 2 };
    num R[n + 1], w[n + 1], v[n + 1], I[n], J[n], before, after;
    given_points(T, "R", n + 1, 1, R);
    given_points(T, "ω", n + 1, 1, w);
    given_points(T, "ω*", n + 1, 1, v);
    num t = given(T, "t"), first = div(v[0], w[0]), last = div(v[n], w[n]);
    G(rational_invariants)(n, w, I);
    G(rational_invariants)(n, v, J);
    found(T, "I_1", I[0]);
    found(T, "I*_1", J[0]);
    same(T, J[0], I[0]);
    G(rational_point)(n, 1, R, w, t, &before);
    G(rational_point)(n, 1, R, v, t, &after);
    found(T, "R(t)", before);
    found(T, "R*(t)", after);
    same(T, after, before);
    agree(T, G(one_map)(n, 1, R, w, R, v));
    found(T, "ω*_0/ω_0", first);
    found(T, "ω*_2/ω_2", last);
    agree(T, sign_q(first) < 0 && sign_q(last) < 0);
}
#endif

/*
:::{statement} wang-ch3:prop-3.2.10
:title: Equal quotients: the weights can be exchanged without moving points or curve
:zh: 分式线性参数变换下的形状不变性
:printed: As soon as $I_i=I_i^*$, $i=1,2,\dots,n-1$, (3.2.12), the curve (3.2.2) can be carried by (3.2.10) with (3.2.11)
  into the rational Bézier curve (3.2.13) of the same degree with the parameter $u$ and the weights $\omega_i^*$, whose control points and shape
  are the same.
:holds-by: equal_invariants_mean_geometric_ratios factors_make_a_geometric_sequence fractional_change_term_by_term
  larger_numbers_have_larger_powers fractional_change_runs_once
:confirmed-by: equal_invariants_give_same_curve end_weights_give_the_factors
:needs: equal_invariants_reach_the_other_arc | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive: with a negative one the other arc of the conic has the same $I_1$
:needs: linear_curve_with_opposite_ratios_has_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the
  weights are positive: for $n=1$ there is no condition at all, and the curve may even become unbounded
:figure: equal_invariants_other_arc
:::

:::{statement} wang-ch3:3.2.13
:title: The curve that results
:zh: 变换所得曲线
:printed: When $I_i=I_i^*$, $i=1,\dots,n-1$ (3.2.12), (3.2.10) with the factors $a,b$ of (3.2.11) carries the curve (3.2.2) into $\mathbf R^*(u)=\sum_{i=0}^nB_i^n(u)\omega_i^*\mathbf R_i\Big/\sum_{i=0}^nB_i^n(u)\omega_i^*$, $0\le
  u\le1$.
:holds-by: equal_invariants_mean_geometric_ratios factors_make_a_geometric_sequence fractional_change_term_by_term
  larger_numbers_have_larger_powers fractional_change_runs_once
:confirmed-by: equal_invariants_give_same_curve
:needs: equal_invariants_reach_the_other_arc | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive: with a negative one the result may be the curve of other weights, the other arc of the conic
:::

There are $n+1$ weights and $n-1$ quotients; the two missing numbers are $a$ and $b$.  So weights with given quotients
are found by choosing two of them and computing the others, one after the other, and for all these the curve must be
one.

:::{claim} equal_invariants_give_same_curve
:title: Weights with the same quotients give the same curve at another speed
:zh: 不变量相等则曲线相同
:given: positive weights $\omega_0,\dots,\omega_n$, points $R_0,\dots,R_n$, and weights $\omega^*$ with $I_i^*=I_i$
  for $0<i<n$: $\omega_0^*,\omega_1^*$ are free and the others follow from
  $\omega_{i+1}^*=\omega_i^{*2}/(\omega_{i-1}^*I_i)$
:where: the weights are positive
:let: $q=\frac{\omega_0\omega_1^*}{\omega_1\omega_0^*}$ and $t=qu/(qu+1-u)$
:then: $R^*(u)=R(t)$ for every $u$
:method: The recursion produces every $\omega^*$ with these quotients.  Formula (3.2.10) depends on $a/b$ alone, and
  $a/b=q$ as positive numbers have one positive root; so nothing but rational functions is left, and both sides are
  one.
:degrees: 1..6 sampled 10
:over: v#: weights
:control: the last weight $\omega_n^*$ doubled
:::
*/
CLAIM(equal_invariants_give_same_curve)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], v[MAX_DEGREE + 1], I[MAX_DEGREE], before, after;
    num u = parameter(T, "u"), one = from_int(1);
    G(free_curve)(T, n, 1, R, w);
    v[0] = positive(T, "v", 0);
    v[1] = positive(T, "v", 1);
    G(rational_invariants)(n, w, I);
    for (int i = 1; i < n; i++)
        v[i + 1] = div(mul(v[i], v[i]), mul(v[i - 1], I[i - 1]));
    num q = div(div(v[1], w[1]), div(v[0], w[0]));
    v[n] = fault(T, v[n], add(v[n], v[n]));
    G(rational_point)(n, 1, R, w, G(old_parameter)(q, one, u), &before);
    G(rational_point)(n, 1, R, v, u, &after);
    same(T, after, before);
}

#if RATIONAL
/*
In the quotient $\omega_1$ stands squared.  This is enough to make the property false for weights of both signs: the
quadratic with $-\omega_1$ for $\omega_1$ runs through the other arc of its conic.

:::{claim} equal_invariants_reach_the_other_arc
:title: The square in the quotient forgets the sign of the middle weight
:zh: 中间权变号:比值相同而曲线不同
:kind: decision
:data: R = (-1,0) (0,1) (1,0); ω = 2 1 2; ω* = 2 -1 2; t = 1/2
:instead: ω* = 2 1 2
:result: I_1 = 1/4; I*_1 = 1/4; a = 1; b = 1; R(t) = (0,1/3); R*(t) = (0,-1)
:given: the quadratic curve with points $R$ and positive weights $\omega$, whose points are in $y\ge0$, and $\omega^*$, which differs from $\omega$
  in the sign of the middle weight; a parameter $t$
:then: $I_1=I_1^*$, $a=b=1$, both denominators are positive on $[0,1]$, and the second curve has a point that is
  not on the first
:method: The first curve lies in the triangle of its points, $y\ge0$, as its weights are positive.  The denominators
  are decided by their signs on $[0,1]$; $R^*(t)$ has $y<0$.
:control: $\omega_1^*$ positive
:::
*/
CLAIM(equal_invariants_reach_the_other_arc)
{
    enum { n = 2 };
    num R[2 * (n + 1)], w[n + 1], v[n + 1], I[1], J[1], P[2], Q[2], zero = from_int(0), one = from_int(1);
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    given_points(T, "ω*", n + 1, 1, v);
    num t = given(T, "t");
    G(rational_invariants)(n, w, I);
    G(rational_invariants)(n, v, J);
    found(T, "I_1", I[0]);
    found(T, "I*_1", J[0]);
    same(T, J[0], I[0]);
    found(T, "a", root(n, div(v[n], w[n])));
    found(T, "b", root(n, div(v[0], w[0])));
    G(rational_point)(n, 2, R, w, t, P);
    G(rational_point)(n, 2, R, v, t, Q);
    found_points(T, "R(t)", 1, 2, P);
    found_points(T, "R*(t)", 1, 2, Q);
    agree(T, sign_on(poly_from_bernstein(n, w), zero, one, CLOSED) == SIGN_POSITIVE);
    agree(T, sign_on(poly_from_bernstein(n, v), zero, one, CLOSED) == SIGN_POSITIVE);
    agree(T, sign_q(Q[1]) < 0);
}

/*
For $n=1$ there is no quotient, so that any two pairs of weights would have to give one segment.

:::{claim} linear_curve_with_opposite_ratios_has_a_pole
:title: In degree 1 a negative weight can send the curve to infinity
:zh: 一次时异号权可使曲线无界
:kind: decision
:data: R = 0 1; ω = 1 1; ω* = 1 -1; u_0 = 1/2; u = 1/3
:instead: ω* = 1 1
:result: a/b = -1; R*(u) = -1
:given: $n=1$, points $R$ of the line, equal weights $\omega$ and opposite ones $\omega^*$; parameters $u_0$ and $u$ of $[0,1]$
:then: there is no quotient to compare; $a/b<0$, the denominators of $t$ and of $R^*(u)$ vanish at $u_0$, and
  $R^*(u)$ is not on the segment
:method: Computed exactly.
:control: $\omega_1^*$ positive
:::
*/
CLAIM(linear_curve_with_opposite_ratios_has_a_pole)
{
    num R[2], w[2], v[2], P;
    given_points(T, "R", 2, 1, R);
    given_points(T, "ω", 2, 1, w);
    given_points(T, "ω*", 2, 1, v);
    num pole = given(T, "u_0"), u = given(T, "u"), a = div(v[1], w[1]), b = div(v[0], w[0]);
    found(T, "a/b", div(a, b));
    /* a u_0 + b (1 - u_0) and ω*(u_0) */
    vanishes(T, add(mul(a, pole), mul(b, sub(from_int(1), pole))));
    vanishes(T, G(rational_weight)(1, v, pole));
    G(rational_point)(1, 1, R, v, u, &P);
    found(T, "R*(u)", P);
    agree(T, sign_q(sub(P, R[0])) < 0);
}
#endif

/*
## The proof

:::{statement} wang-ch3:prop-3.2.10-geometric
:title: Equal quotients mean that the ratios of the weights are a geometric sequence
:zh: 不变量相等等价于权之比成等比数列
:printed: (3.2.12) is equivalent to this, that $\{\omega_0^{*}/\omega_0,\omega_1^{*}/\omega_1,\dots,\omega_n^{*}/\omega_n\}$ is a geometric sequence, that is
  $\omega_i^{*}/\omega_i=(\omega_0^{*}/\omega_0)q^i$, $i=1,2,\dots,n$, with the common quotient $q$.
:holds-by: equal_invariants_mean_geometric_ratios

True for all weights but $0$, of any sign.
:::

:::{claim} equal_invariants_mean_geometric_ratios
:title: Three neighbouring ratios are geometric exactly when the quotients agree
:zh: 三个相邻比成等比当且仅当不变量相等
:given: three neighbouring weights $\omega_{i-1},\omega_i,\omega_{i+1}$ and ratios $r_{i-1},r_i,r_{i+1}$, none of
  them $0$, with $\omega_k^*=r_k\omega_k$
:where: no weight is 0
:then: $I_i^*r_{i-1}r_{i+1}=I_ir_i^2$; so $I_i^*=I_i$ exactly when $r_{i+1}/r_i=r_i/r_{i-1}$
:method: The equality is one of rational functions.  For all $i$ together it says that the ratios have one common
  quotient $q$, so that $r_i=r_0q^i$.
:over: r#: -
:control: $r_i$ for $r_i^2$
:degrees: all
:::
*/
CLAIM(equal_invariants_mean_geometric_ratios)
{
    num w[3], r[3], v[3], I[1], J[1];
    for (int k = 0; k < 3; k++) {
        w[k] = unknown(T, "w", k);
        r[k] = unknown(T, "r", k);
        v[k] = mul(r[k], w[k]);
    }
    G(rational_invariants)(2, w, I);
    G(rational_invariants)(2, v, J);
    num square = fault(T, mul(r[1], r[1]), r[1]);
    /* I*_i r_{i-1} r_{i+1} = I_i r_i² */
    same(T, mul(J[0], mul(r[0], r[2])), mul(I[0], square));
}

/*
The numbers $a$ and $b$ enter at the two ends of that sequence, $b^n$ at the first and $a^n$ at the last place.  What lies between them
follows step by step.

:::{claim} factors_make_a_geometric_sequence
:title: From b^n to a^n the products of powers are a geometric sequence with the quotient a/b, in every degree
:zh: 由 b^n 到 a^n 的幂积成公比为 a/b 的等比数列(任意次数)
:given: $a$, $b$; $A=a^i$ and $bB=b^{n-i}$ for an index $i$ before $n$
:let: $r_i=a^ib^{n-i}$
:then: $b\,r_{i+1}=b\cdot aA\cdot B=a\cdot A\cdot bB=a\,r_i$
:method: The step of an induction on $i$, which begins with $r_0=b^n$ and ends with $r_n=a^n$: with $q=a/b$ it is $r_i=b^nq^i$ for $i=0,\dots,n$.  With (3.2.11), where
  $b^n=\omega_0^{*}/\omega_0$ and $a^n=\omega_n^{*}/\omega_n$, this says that $\omega_n^{*}/\omega_n=(\omega_0^{*}/\omega_0)q^n$, and that $\omega_i^{*}/\omega_i=(\omega_0^{*}/\omega_0)q^i$
  is $a^ib^{n-i}\omega_i=\omega_i^*$.  Outside the field $n$ is a random integer, and all $b^nq^i$ are compared with the products of powers.
:degrees: all
:over: a b A B: -
:control: $b/a$ for $a/b$
:::
*/
CLAIM(factors_make_a_geometric_sequence)
{
    num a = positive(T, "a", 0), b = positive(T, "b", 0), A = unknown(T, "A", 0), B = unknown(T, "B", 0);
    num above = fault(T, a, b), below = fault(T, b, a);
    about(T, "from one index to the next");
    same(T, mul(below, mul(mul(a, A), B)), mul(above, mul(A, mul(b, B))));
#if !FIELD
    int n = pick(T, 1, 9);
    num ratio = G(power)(b, n);
    about(T, "all terms from the first and the quotient");
    for (int i = 0; i <= n; i++, ratio = div(mul(ratio, above), below))
        same(T, ratio, mul(G(power)(a, i), G(power)(b, n - i)));
#endif
}

/*
:::{statement} wang-ch3:prop-3.2.10-quotient
:title: The last ratio gives the common quotient
:zh: 由末项求公比
:printed: For $i=n$, (3.2.11) gives $q=a/b$
:holds-by: factors_make_a_geometric_sequence larger_numbers_have_larger_powers
:confirmed-by: equal_powers_of_positive_numbers
:needs: quotient_is_lost_up_to_sign | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive; otherwise for even $n$ only $q=\pm a/b$
:::

From $q^n=(a/b)^n$ the source concludes $q=a/b$.  That is a statement on positive numbers, and for even $n$ on no others.

:::{claim} equal_powers_of_positive_numbers
:title: Positive numbers with equal n-th powers are equal
:zh: 正数的 n 次幂相等则相等
:given: $p,q>0$
:then: $q^n-p^n=(q-p)\,S$ with $S=\sum_{k<n}q^{n-1-k}p^k>0$
:method: An identity, and $S$ has positive coefficients only.  From
  $\omega_n^{*}/\omega_n=(\omega_0^{*}/\omega_0)q^n$ and (3.2.11) follows $q^n=(a/b)^n$; all ratios of positive
  weights are positive, so $q=a/b$.
:degrees: 1..8 sampled 16
:over: p; q
:control: the signs in $S$ alternate
:::
*/
CLAIM(equal_powers_of_positive_numbers)
{
    int n = T->degree;
    num p = positive(T, "p", 0), q = positive(T, "q", 0), S = from_int(0);
    for (int k = 0; k < n; k++) {
        num term = mul(G(power)(q, n - 1 - k), G(power)(p, k));
        S = fault(T, add(S, term), k % 2 == 1 ? sub(S, term) : add(S, term));
    }
    /* (q - p) Σ q^{n-1-k} p^k = q^n - p^n */
    same(T, mul(sub(q, p), S), sub(G(power)(q, n), G(power)(p, n)));
    nonnegative(T, sub(S, G(power)(q, n - 1)));
}

#if RATIONAL
/*
:::{claim} quotient_is_lost_up_to_sign
:title: In even degree the end weights do not know the sign of the quotient
:zh: 偶次时公比的符号不能由末项求得
:kind: decision
:data: ω = 2 1 2; ω* = 2 -1 2
:instead: ω* = 2 1 2
:result: I_1 = 1/4; I*_1 = 1/4; ω*_i/ω_i = 1 -1 1; q = -1; a/b = 1
:given: $n=2$, weights $\omega$, and $\omega^*$, which differs from $\omega$ in the sign of the middle weight
:then: $I_1=I_1^*$ and the ratios $\omega_i^{*}/\omega_i$ are geometric with quotient $q$, but $a/b=-q$
:method: Computed exactly.
:control: $\omega_1^*$ positive
:::
*/
CLAIM(quotient_is_lost_up_to_sign)
{
    num w[3], v[3], r[3], I[1], J[1];
    given_points(T, "ω", 3, 1, w);
    given_points(T, "ω*", 3, 1, v);
    for (int k = 0; k < 3; k++)
        r[k] = div(v[k], w[k]);
    G(rational_invariants)(2, w, I);
    G(rational_invariants)(2, v, J);
    found(T, "I_1", I[0]);
    found(T, "I*_1", J[0]);
    same(T, J[0], I[0]);
    num q = div(r[1], r[0]), quotient = div(root(2, r[2]), root(2, r[0]));
    found_points(T, "ω*_i/ω_i", 3, 1, r);
    found(T, "q", q);
    found(T, "a/b", quotient);
    agree(T, !equal_q(q, quotient));
    same(T, mul(q, q), mul(quotient, quotient));
}
#endif

/*
:::{statement} wang-ch3:prop-3.2.10-weights
:title: The factors carry the old weights into the new ones
:zh: 因子把旧权变为新权
:printed: Hence $a^ib^{n-i}\omega_i=\omega_i^*$, which shows that (3.2.14) is (3.2.13).
:holds-by: equal_invariants_mean_geometric_ratios factors_make_a_geometric_sequence larger_numbers_have_larger_powers
:confirmed-by: end_weights_give_the_factors
:needs: equal_invariants_reach_the_other_arc | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive: with a negative one the two sides may differ in their sign
:::

:::{claim} end_weights_give_the_factors
:title: The factors a and b from the end weights lead to all the new weights
:zh: 由首末权所得因子还原全部权
:given: positive weights $\omega_0,\dots,\omega_n$ and $\omega_i^*=r\,q^i\omega_i$, $r=\beta^n$, $q=\alpha/\beta$,
  with $\alpha,\beta>0$
:where: the weights are positive; $\alpha,\beta>0$
:let: $a=\sqrt[n]{\omega_n^{*}/\omega_n}$, $b=\sqrt[n]{\omega_0^{*}/\omega_0}$
:then: $a^ib^{n-i}\omega_i=\omega_i^*$, $i=0,\dots,n$
:method: Every positive geometric sequence of ratios has this form, with $\beta=\sqrt[n]r$.  The roots are taken in
  the field of rational functions, where they are the positive ones $\alpha$ and $\beta$.
:degrees: 1..8 sampled 10
:over: alpha: a; beta: b
:control: $\omega_n^*$ for $\omega_0^*$ in $b$
:::
*/
CLAIM(end_weights_give_the_factors)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], v[MAX_DEGREE + 1], out[MAX_DEGREE + 1];
    num alpha = positive(T, "alpha", 0), beta = positive(T, "beta", 0);
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        v[i] = mul(mul(G(power)(beta, n), G(power)(div(alpha, beta), i)), w[i]);
    }
    int first = fault(T, 0, n);
    num a = root(n, div(v[n], w[n])), b = root(n, div(v[first], w[first]));
    G(rational_reparametrize)(n, w, a, b, out);
    for (int i = 0; i <= n; i++)
        same(T, out[i], v[i]);
}

/*
One choice of the new weights is distinguished: $\omega_0^*=\omega_n^*=1$, the standard form.  Section 3.5 of the
source uses it for $n=2$.

:::{claim} standard_form_has_unit_ends
:title: The standard form has end weights 1 and is the same curve
:zh: 标准形:首末权为 1
:given: positive weights $\omega_0,\dots,\omega_n$ with $\omega_n=\omega_0\rho^n$, and points $R_0,\dots,R_n$
:where: the weights are positive
:then: the standard weights are $\omega_i/(\omega_0\rho^i)$, the first and the last are $1$, and with them the curve
  at $u$ is $R(t)$, $t=u/(u+\rho(1-u))$
:method: All sides are rational functions of $\rho$, the weights, the points and $u$;
  $\rho=\sqrt[n]{\omega_n/\omega_0}$ may be any positive number.
:degrees: 1..6 sampled 10
:defines: rational_standard_form
:over: rho
:control: $\rho$ for $1/\rho$
:::
*/
CLAIM(standard_form_has_unit_ends)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], out[MAX_DEGREE + 1], before, after;
    num rho = positive(T, "rho", 0), u = parameter(T, "u"), one = from_int(1);
    G(free_curve)(T, n, 1, R, w);
    w[n] = mul(w[0], G(power)(rho, n));
    G(rational_standard_form)(n, w, out);
    num factor = fault(T, div(one, rho), rho);
    for (int i = 0; i <= n; i++)
        same(T, out[i], mul(div(w[i], w[0]), G(power)(factor, i)));
    same(T, out[0], one);
    same(T, out[n], one);
    G(rational_point)(n, 1, R, w, G(old_parameter)(one, rho, u), &before);
    G(rational_point)(n, 1, R, out, u, &after);
    same(T, after, before);
}

#include "chapters/judge/claims_off.h"
