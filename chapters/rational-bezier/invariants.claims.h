/*
# The invariants of a curve (有理 Bézier 曲线的不变量)

The quotients $I_i=\omega_i^2/(\omega_{i-1}\omega_{i+1})$ do not notice a fractional linear change of the parameter.  This section decides
definition 3.2.2, which calls them invariants of the curve, and whether they belong to the curve itself: the same arc may have
other points and weights, and with them other quotients.
*/
#include "exact/record/sign.h"

#include "chapters/judge/elementary.h"
#include "chapters/rational-bezier/free-curve.h"
#include "chapters/rational-bezier/one-map.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch3:def-3.2.2
:title: The quotients are invariants of the fractional linear change of parameter
:zh: 分式线性变换下的不变量
:printed: The quantities $I_i$, $i=1,2,\dots,n-1$, of (3.2.12) are called the invariants of the rational Bézier curve (3.2.2) of degree $n$ under the
  shape-preserving fractional linear transformation (3.2.10).
:definition: yes
:checked-by: equal_invariants_mean_geometric_ratios factors_make_a_geometric_sequence fractional_change_term_by_term
:confirmed-by: invariants_survive_fractional_change equal_invariants_give_same_curve
:needs: equal_invariants_can_make_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  $au+b(1-u)\ne0$: positive weights give it, as $a,b>0$; otherwise the denominator can vanish inside $[0,1]$
:::

Of the definition this much is sure: the numbers belong to points and weights up to a change of the parameter.

:::{claim} invariants_survive_fractional_change
:title: The change of parameter does not change the quotients
:zh: 参数变换不改变不变量
:given: weights $\omega_0,\dots,\omega_n$, $a$ and $b$, none of them $0$
:where: no weight is 0
:then: $(a^ib^{n-i}\omega_i)_i$ has the same quotients $I_1,\dots,I_{n-1}$ as $(\omega_i)_i$
:method: Both are computed as rational functions of the weights, $a$ and $b$.
:degrees: 2..8 sampled 16
:over: a; b
:control: $\omega_1$ of the new weights doubled
:::
*/
CLAIM(invariants_survive_fractional_change)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], v[MAX_DEGREE + 1], I[MAX_DEGREE], J[MAX_DEGREE];
    num a = unknown(T, "a", 0), b = unknown(T, "b", 0);
    for (int i = 0; i <= n; i++)
        w[i] = unknown(T, "w", i);
    G(rational_reparametrize)(n, w, a, b, v);
    v[1] = fault(T, v[1], add(v[1], v[1]));
    G(rational_invariants)(n, w, I);
    G(rational_invariants)(n, v, J);
    for (int i = 1; i < n; i++)
        same(T, J[i - 1], I[i - 1]);
}

#if RATIONAL
/*
With weights of both signs the change of parameter may leave the curve, while the numbers stay.

:::{claim} equal_invariants_can_make_a_pole
:title: Weights of both signs can have the invariants of equal ones, and a pole
:zh: 异号权可与等权有相同的不变量而有极点
:kind: decision
:data: ω = 1 1 1 1; ω* = 1 -1 1 -1; a = -1; b = 1; u = 1/2
:instead: ω* = 1 1 1 1; a = 1
:result: I = 1 1; I* = 1 1; a u + b (1-u) = 0; ω*(u) = 0
:given: two times four weights, $\omega$ and $\omega^*$, of cubic curves, the numbers $a$ and $b$ of (3.2.11), and a parameter $u$ of $[0,1]$
:then: $I_i=I_i^*$ and $a^ib^{n-i}\omega_i=\omega_i^*$ for all $i$, but the denominators of (3.2.10) and of (3.2.13) vanish at $u$
:method: Computed exactly; for odd $n$ the real root of a negative number is negative.
:control: equal weights $\omega^*$ and $a=b$
:::
*/
CLAIM(equal_invariants_can_make_a_pole)
{
    enum { n = 3 };
    num w[n + 1], v[n + 1], changed[n + 1], I[n - 1], J[n - 1];
    given_points(T, "ω", n + 1, 1, w);
    given_points(T, "ω*", n + 1, 1, v);
    num a = given(T, "a"), b = given(T, "b"), u = given(T, "u");
    G(rational_invariants)(n, w, I);
    G(rational_invariants)(n, v, J);
    found_points(T, "I", n - 1, 1, I);
    found_points(T, "I*", n - 1, 1, J);
    G(rational_reparametrize)(n, w, a, b, changed);
    for (int i = 0; i <= n; i++)
        same(T, changed[i], v[i]);
    for (int i = 1; i < n; i++)
        same(T, J[i - 1], I[i - 1]);
    num below = add(mul(a, u), mul(b, sub(from_int(1), u))), total = G(rational_weight)(n, v, u);
    found(T, "a u + b (1-u)", below);
    found(T, "ω*(u)", total);
    vanishes(T, below);
    vanishes(T, total);
}
#endif

/*
:::{statement} wang-ch3:def-3.2.2-intrinsic
:title: The invariants belong to the curve
:zh: 不变量是曲线的内在几何量
:printed: The $I_i$ are intrinsic geometric quantities of the curve (3.2.2).
:meant: the words intrinsic and geometric | They belong to the curve, as a map or as a set of points run through in one direction, and not only to the points and weights that
  describe it; this asks for the three hypotheses.
:holds-by: equal_invariants_mean_geometric_ratios projective_change_of_unit_interval_is_fractional
  factors_make_a_geometric_sequence fractional_change_term_by_term
:confirmed-by: invariants_survive_fractional_change fractional_change_keeps_curve reversal_exchanges_invariants
:hypothesis: same_map_on_a_line_has_two_invariants | numerators and denominator of the curve have no common factor:
  otherwise one and the same map has several sets of points and weights of the degree $n$, with different $I_i$
:hypothesis: arc_of_lower_degree_has_two_invariant_sets | numerators and denominator are not all of a lower degree than $n$ in the parameter:
  otherwise the same arc, with other points, can have other $I_i$, even without a common factor
:hypothesis: segment_has_two_invariants | the parametrization is proper: a general point of the algebraic curve comes from one
  parameter, complex ones included; otherwise two curves with one point set, the same control points and no common factor may
  differ in $I_i$
:reading: equal_invariants_mean_geometric_ratios | belonging to the points and weights, up to (3.2.10)
:reading-with: factors_make_a_geometric_sequence fractional_change_term_by_term
:reading: same_parabola_has_two_invariant_sets | belonging to the curve as a map or as a set of points, without the hypotheses; the example is
  an arc of a parabola written as a cubic
:cites: [sendra-winkler-perez-diaz-2008]: two proper parametrizations of one rational curve differ by a fractional
  linear change of the parameter | It is used for two parametrizations of degree $n$ of one arc.
:argued: | With the hypotheses two parametrizations of degree $n$ of the same arc, in the same direction, differ by a
  projective change of the parameter, which maps the unit interval onto itself, hence is (3.2.10); of the degree $n$ and without a common factor the
  homogeneous coordinates are then proportional, so the points are equal and the weights are those of (3.2.14), with the same $I_i$.
:figure: same_parabola_two_sets

Run backwards, a curve has $I_{n-i}$ for $I_i$ (`reversal_exchanges_invariants`).
:::
*/

#if RATIONAL
/*
That they belong to the curve is more.  If numerator and denominator have a common factor, the curve does not show it,
but points and weights do.  The simplest case is a segment, written as a quadratic in two ways.

:::{claim} same_map_on_a_line_has_two_invariants
:title: One map, two sets of quotients: the segment as a quadratic
:zh: 同一映射的两组不变量:二次线段
:kind: decision
:data: R = 0 1/4 1; ω = 1 2 3; R* = 0 1/3 1; ω* = 1 3/2 2
:instead: ω* = 1 1 2
:result: I = 4/3; I* = 9/8; ω(t) = "2*t+1"; ω*(t) = "t+1"
:given: $n=2$; the points $R$ with weights $\omega$, and the points $R^*$ with weights $\omega^*$
:then: both curves are $R(t)=t$ for every $t$, but $I_1\ne I_1^*$
:method: Numerator and denominator are $t$ and $1$ times $1+2t$, and times $1+t$, so of the degree $n$: the numerators are compared with $t$ times the
  denominators as polynomials.
:control: the middle one of the weights $\omega^*$ taken as $1$
:::
*/
CLAIM(same_map_on_a_line_has_two_invariants)
{
    static const char *const name[2][4] = {{"R", "ω", "I", "ω(t)"}, {"R*", "ω*", "I*", "ω*(t)"}};
    num I[2];
    for (int k = 0; k < 2; k++) {
        num R[3], w[3], x[3];
        given_points(T, name[k][0], 3, 1, R);
        given_points(T, name[k][1], 3, 1, w);
        for (int i = 0; i < 3; i++)
            x[i] = mul(w[i], R[i]);
        poly below = poly_from_bernstein(2, w);
        G(rational_invariants)(2, w, I + k);
        found(T, name[k][2], I[k]);
        found_text(T, name[k][3], poly_to_string(below, "t"));
        agree(T, poly_equal(poly_from_bernstein(2, x), poly_mul(poly_variable(), below)));
    }
    agree(T, !equal_q(I[0], I[1]));
}

/*
One might think that only curves on a line are so undetermined.  But a regular arc of a parabola, raised from degree
$2$ to $3$ in two ways, once as it is and once multiplied by $1+t$, has two sets of quotients as well.

:::{claim} same_parabola_has_two_invariant_sets
:title: One map, two sets of quotients: an arc of a parabola as a cubic
:zh: 同一映射的两组不变量:三次形式的抛物线弧
:kind: counterexample
:data: R = (0,0) (2/3,0) (2/3,1/3) (0,1); ω = 1 1 1 1; R* = (0,0) (1/2,0) (4/5,1/5) (0,1); ω* = 1 4/3 5/3 2
:instead: R* = (0,0) (2/3,0) (2/3,1/3) (0,1); ω* = 1 1 1 1
:result: R(t) in powers of t = (0,0) (2,0) (-2,1) (0,0); I = 1 1; I* = 16/15 25/24
:given: cubic curves of the plane: the points $R$ with equal weights $\omega$, and the points $R^*$ with weights $\omega^*$
:then: both curves are $(2t(1-t),t^2)$ for every $t$, but the quotients $I$ and $I^*$ are not the same
:method: The second numerators and denominator are the first ones times $1+t$: the cross products are compared as
  polynomials, and are equal; then the quotients are compared.
:control: the first points and weights both times
:::
*/
CLAIM(same_parabola_has_two_invariant_sets)
{
    enum { n = 3, dim = 2 };
    num R[dim * (n + 1)], w[n + 1], S[dim * (n + 1)], v[n + 1], I[n - 1], J[n - 1], b[n + 1], power[n + 1],
        P[dim * (n + 1)];
    given_points(T, "R", n + 1, dim, R);
    given_points(T, "ω", n + 1, 1, w);
    given_points(T, "R*", n + 1, dim, S);
    given_points(T, "ω*", n + 1, 1, v);
    for (int c = 0; c < dim; c++) {
        for (int i = 0; i <= n; i++)
            b[i] = R[i * dim + c];
        G(bernstein_to_power)(n, b, power);
        for (int i = 0; i <= n; i++)
            P[i * dim + c] = power[i];
    }
    found_points(T, "R(t) in powers of t", n + 1, dim, P);
    G(rational_invariants)(n, w, I);
    G(rational_invariants)(n, v, J);
    found_points(T, "I", n - 1, 1, I);
    found_points(T, "I*", n - 1, 1, J);
    about(T, "I_1 of the two");
    if (G(one_map)(n, dim, R, w, S, v))
        same(T, I[0], J[0]);
}

/*
A common factor may also hide at $t=\infty$: the arc has a lower degree than $n$, and nothing is left over to be cancelled.  Let the
parabola run at two speeds, related by (3.2.10), and raise both from degree 2 to 3: raising does not multiply the weights as (3.2.14) does.

:::{claim} arc_of_lower_degree_has_two_invariant_sets
:title: One arc without common factors, two sets of quotients: a parabola raised to a cubic at two speeds
:zh: 两种速度的抛物线弧升为三次:无公因子而不变量不同
:kind: decision
:data: R = (0,0) (2/3,0) (2/3,1/3) (0,1); ω = 1 1 1 1; R* = (0,0) (4/5,0) (1/2,1/2) (0,1); ω* = 1 5/3 8/3 4; q = 2
:instead: R* = (0,0) (2/3,0) (2/3,1/3) (0,1); ω* = 1 2 4 8
:result: degrees of the homogeneous coordinates = 2 2 0 2 2 2; I = 1 1; I* = 25/24 16/15
:given: cubic curves of the plane: the points $R$ with equal weights $\omega$, and the points $R^*$ with weights $\omega^*$; a number $q$
:then: $R^*(u)=R(t)$ with $t=\frac{qu}{qu+1-u}$, so that both run once through one arc, from one end to the other; neither has a common factor of numerators
  and denominator, which all are of degree 2 at most; but the quotients $I$ and $I^*$ differ
:method: $R(t)$ is the curve of the points $R$ with the weights $q^i\omega_i$, by `fractional_change_term_by_term`; it is compared with $R^*(u)$ by
  cross products as polynomials.  Common factors by greatest common divisors.
:control: the same points with the weights $q^i\omega_i$, which have the same quotients
:::
*/
/* The degrees of the numerators of a plane cubic and of its denominator; have they a constant greatest common divisor? */
static int G(no_common_factor)(const num R[], const num w[], num degrees[])
{
    poly divisor = poly_from_bernstein(3, w);
    degrees[2] = from_int(poly_degree(divisor));
    for (int c = 0; c < 2; c++) {
        num x[4];
        for (int i = 0; i <= 3; i++)
            x[i] = mul(w[i], R[2 * i + c]);
        poly numerator = poly_from_bernstein(3, x);
        degrees[c] = from_int(poly_degree(numerator));
        divisor = poly_gcd(divisor, numerator);
    }
    return poly_degree(divisor) == 0;
}

CLAIM(arc_of_lower_degree_has_two_invariant_sets)
{
    enum { n = 3 };
    num R[2 * (n + 1)], w[n + 1], S[2 * (n + 1)], v[n + 1], changed[n + 1], I[n - 1], J[n - 1], degrees[6];
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    given_points(T, "R*", n + 1, 2, S);
    given_points(T, "ω*", n + 1, 1, v);
    num q = given(T, "q");
    for (int i = 0; i <= n; i++)
        changed[i] = mul(G(power)(q, i), w[i]);
    agree(T, G(one_map)(n, 2, R, changed, S, v));
    int first = G(no_common_factor)(R, w, degrees), second = G(no_common_factor)(S, v, degrees + 3);
    found_points(T, "degrees of the homogeneous coordinates", 6, 1, degrees);
    agree(T, first && second);
    G(rational_invariants)(n, w, I);
    G(rational_invariants)(n, v, J);
    found_points(T, "I", n - 1, 1, I);
    found_points(T, "I*", n - 1, 1, J);
    agree(T, !equal_q(I[0], J[0]));
}
#endif

/*
And the point set does not know in which direction it is run through.

:::{claim} reversal_exchanges_invariants
:title: Run backwards, the curve has the quotients in reverse order
:zh: 反向后不变量次序颠倒
:given: weights $\omega_0,\dots,\omega_n$ and points $R_0,\dots,R_n$
:then: $(R_{n-i},\omega_{n-i})_i$ is the curve $R(1-t)$, and its $i$-th quotient is $I_{n-i}$
:method: Both sides are computed as rational functions of all the data.
:degrees: 2..6 sampled 12
:control: the points reversed, the weights not
:::
*/
CLAIM(reversal_exchanges_invariants)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], v[MAX_DEGREE + 1], S[MAX_DEGREE + 1], I[MAX_DEGREE], J[MAX_DEGREE];
    num t = parameter(T, "t"), there, back;
    G(free_curve)(T, n, 1, R, w);
    for (int i = 0; i <= n; i++) {
        S[i] = R[n - i];
        v[i] = fault(T, w[n - i], w[i]);
    }
    G(rational_point)(n, 1, R, w, sub(from_int(1), t), &there);
    G(rational_point)(n, 1, S, v, t, &back);
    same(T, back, there);
    G(rational_invariants)(n, w, I);
    G(rational_invariants)(n, v, J);
    for (int i = 1; i < n; i++)
        same(T, J[i - 1], I[n - i - 1]);
}

/*
:::{statement} wang-ch3:def-3.2.2-first-invariant
:title: For n = 2 the invariant has the geometric meaning of section 3.1
:zh: n=2 时不变量的几何意义
:printed: For $n=2$ the geometric meaning of $I_1$ has been discussed in section 3.1.
:holds-by: first_invariant_is_the_tangent_ratio
:needs: end_weights_of_both_signs_give_no_product_of_lengths | § 3.1, which introduces $g_1$, $g_2$ as quotients of lengths and says
  $\omega_0\omega_2/\omega_1^2>0$ below (3.1.5) | $\omega_0\omega_2>0$: otherwise $1/I_1$ is negative, and the product of two ratios of lengths is not
:needs: ratios_do_not_exist_at_the_ends | § 3.1, by which $g_1g_2$ is constant, so that both ratios exist | $0<t<1$
:needs: segment_does_not_fix_the_constant | the affine frame $\{R_1;R_1R_0,R_1R_2\}$ of § 3.1 | $R_0$, $R_1$, $R_2$ do not lie
  on a line

What section 3.1 calls $g_1g_2=\omega_0\omega_2/\omega_1^2$ is the reciprocal, $1/I_1$.
:::

For $n=2$ the source refers to a ratio that is measured on the triangle.  Its product $g_1g_2$ is $1/I_1$ and not $I_1$.

:::{claim} first_invariant_is_the_tangent_ratio
:title: Every tangent cuts the legs of the triangle in ratios with one product, the reciprocal of the invariant
:zh: 切线在两边上截得比之积等于 1/I_1
:given: the quadratic with points $R_0=(1,0)$, $R_1=(0,0)$, $R_2=(0,1)$ and positive weights, and $0<t<1$
:let: the tangent at $R(t)$ meets $R_0R_1$ in $A$ and $R_1R_2$ in $B$
:then: $\frac{R_1A}{AR_0}\cdot\frac{R_1B}{BR_2}=\frac1{I_1}$
:method: The tangent is the line through $R(t)$ in the direction of $R'(t)$; everything is a rational function of
  $t$ and the weights.  Ratios on lines and tangents are affine invariants, so every triangle is included.
:scope: n = 2
:where: the weights are positive; $0<t<1$
:control: $I_1$ for $1/I_1$
:::
*/
CLAIM(first_invariant_is_the_tangent_ratio)
{
    num zero = from_int(0), one = from_int(1), R[] = {one, zero, zero, zero, zero, one}, w[3], D[4], I[1];
    num t = parameter(T, "t");
    for (int i = 0; i < 3; i++)
        w[i] = positive(T, "w", i);
    G(rational_derivatives)(2, 2, R, w, t, 1, D);
    num A = sub(D[0], mul(D[1], div(D[2], D[3]))), B = sub(D[1], mul(D[0], div(D[3], D[2])));
    num product = mul(div(A, sub(one, A)), div(B, sub(one, B)));
    G(rational_invariants)(2, w, I);
    /* R_1A/AR_0 · R_1B/BR_2 = 1/I_1 */
    same(T, product, fault(T, div(one, I[0]), I[0]));
}

#if RATIONAL
/*
With end weights of different signs $1/I_1$ is negative, which a product of lengths never is.

:::{claim} end_weights_of_both_signs_give_no_product_of_lengths
:title: When the first and the last weight have different signs 1/I_1 is no product of ratios of lengths
:zh: 首末权异号时 1/I_1 不是长度比之积
:kind: counterexample
:data: R = (1,0) (0,0) (0,1); ω = 1 1 -1; t = 1/3
:instead: ω = 1 1 1
:result: R_1A/AR_0, R_1B/BR_2 = 2 -1/2; 1/I_1 = -1
:given: the quadratic with points $R$ and weights $\omega$ of which the last is negative, and a parameter $t$ with $\omega(t)\ne0$; the tangent at $R(t)$ meets $R_0R_1$
  in $A$ and $R_1R_2$ in $B$
:then: $B$ is not between $R_1$ and $R_2$: the lengths have the ratios $2$ and $\frac12$ with the product $1$, but $1/I_1=-1$
:method: Computed exactly, the tangent from the derivative; the product of the absolute values of the ratios is compared with $1/I_1$.
:control: positive weights
:::
*/
CLAIM(end_weights_of_both_signs_give_no_product_of_lengths)
{
    num one = from_int(1), R[6], w[3], D[4], I[1], ratio[2];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    G(rational_derivatives)(2, 2, R, w, given(T, "t"), 1, D);
    num A = sub(D[0], mul(D[1], div(D[2], D[3]))), B = sub(D[1], mul(D[0], div(D[3], D[2])));
    ratio[0] = div(A, sub(one, A));
    ratio[1] = div(B, sub(one, B));
    G(rational_invariants)(2, w, I);
    num product = mul(ratio[0], ratio[1]), constant = div(one, I[0]);
    found_points(T, "R_1A/AR_0, R_1B/BR_2", 2, 1, ratio);
    found(T, "1/I_1", constant);
    about(T, "the product of the ratios of lengths and 1/I_1");
    same(T, sign_q(product) < 0 ? neg(product) : product, constant);
}
#endif

/*
:::{statement} wang-ch3:prop-3.2.10-same-shape
:title: Equal invariants: the same shape, another distribution of the parameter
:zh: 不变量相等时形状相同而参数分布不同
:printed: When $I_i=I_i^*$, $i=1,2,\dots,n-1$, the curves (3.2.2) and (3.2.13) have the same shape, and only the
  parameter is distributed differently along the curve.
:holds-by: equal_invariants_mean_geometric_ratios factors_make_a_geometric_sequence fractional_change_term_by_term
  larger_numbers_have_larger_powers fractional_change_runs_once
:confirmed-by: equal_invariants_give_same_curve
:needs: equal_invariants_reach_the_other_arc | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive
:figure: reparametrization

The distribution need not differ: for $\omega_i^*=c\,\omega_i$ it is the same, as $q=1$.
:::
*/
#include "chapters/judge/claims_off.h"
