/*
# Piece by piece (分段三次 Hermite 插值)

The degree of the polynomial with all data grows with the data.  Instead the cubic with the four data of $[t_i,t_{i+1}]$ is
taken on each interval.  Neighbours share a value and a derivative at the node between them, so the curve has a
continuous first derivative whatever the data are; the second derivative is another matter.
*/
#include "chapters/hermite-coons/definition.h"

#if RATIONAL
#include "exact/record/polynomial.h"
#endif

#include "chapters/judge/claims_on.h"

/*
## The pieces

The notation has two indices: $g_{i0}$ and $g_{i1}$ belong to the interval from $t_i$, and to its two ends.  To have one function for each
datum, the two pieces that know of it, on both sides of $t_i$, are glued together.

:::{statement} slides-ch4:2-piece
:title: The cubic on one interval
:zh: 第 i 段三次 Hermite 插值
:printed: $P_i(t)=f(t_i)g_{i0}(t)+f(t_{i+1})g_{i1}(t)+f'(t_i)h_{i0}(t)(t_{i+1}-t_i)+f'(t_{i+1})h_{i1}(t)(t_{i+1}-t_i)$, $i=0,\dots,n-1$, with
  $g_{i0}=\bigl(1-2\frac{t-t_i}{t_i-t_{i+1}}\bigr)\bigl(\frac{t-t_{i+1}}{t_i-t_{i+1}}\bigr)^2$,
  $g_{i1}=\bigl(1-2\frac{t-t_{i+1}}{t_{i+1}-t_i}\bigr)\bigl(\frac{t-t_i}{t_{i+1}-t_i}\bigr)^2$,
  $h_{i0}=\frac{t-t_i}{t_{i+1}-t_i}\bigl(\frac{t-t_{i+1}}{t_i-t_{i+1}}\bigr)^2$, $h_{i1}=\frac{t-t_{i+1}}{t_{i+1}-t_i}\bigl(\frac{t-t_i}{t_{i+1}-t_i}\bigr)^2$
:holds-by: hermite_kernel_blends_four_data
:confirmed-by: base_functions_interpolate_once_continuously
:needs: equal_ends_have_no_cubic | the words: on the interval $[t_i,t_{i+1}]$ (在区间 $[t_i,t_{i+1}]$) | $t_i\ne t_{i+1}$: the
  functions divide by $t_{i+1}-t_i$, and at equal ends no others will do
:figure: nodes_that_meet

In the text at hand the formulas have no signs and no primes; with those shown here each piece has its four data.
:::

:::{statement} slides-ch4:2-base-functions
:title: The functions of one datum on the whole interval
:zh: 整体基函数
:printed: $a_{i,0}$ is $g_{i-1,1}$ on $[t_{i-1},t_i]$, $g_{i,0}$ on $[t_i,t_{i+1}]$ and 0 elsewhere; $a_{i,1}$ is
  $h_{i-1,1}(t)(t_i-t_{i-1})$, $h_{i,0}(t)(t_{i+1}-t_i)$ and 0; for $i=0$ and $i=n$ the piece outside $[t_0,t_n]$ is left out
:definition: yes
:checked-by: base_functions_interpolate_once_continuously
:needs: overlapping_intervals_miss_the_data | the words: in the interval $[t_0,t_n]$, and the ranges of the printed cases |
  $t_0<t_1<\dots<t_n$: intervals $[t_i,t_{i+1}]$ of $[t_0,t_n]$
:figure: piecewise_base_functions
:::

:::{claim} base_functions_interpolate_once_continuously
:title: The sum over all data is, on each interval, the cubic of its four data, and the pieces meet in C1
:zh: 分段插值的一阶连续性
:given: nodes $t_0<\dots<t_n$, any data, any $t$
:then: on each of the $n$ intervals the sum of the $2n+2$ terms is what `hermite_cubic` gives for four data; at each node its value
  and derivative are the data, from both sides
:method: The functions $a_{i,j}$ as printed, with the lengths, interval by interval, all $2n+2$ summed as polynomials; everything variable.  Of points and
  vectors each coordinate is computed by itself.
:degrees: intervals = 1..4 sampled 8
:argued: every number of intervals | On an interval all functions but the four of its two ends are 0, by their definition, whatever stands on
  the other intervals.
:over: t# h#: increasing nodes; f# d#: data; p: t
:control: in $a_{0,1}$ the function of the other end
:::
*/
/* What a_{i,order} is on [t_s, t_{s+1}], by the printed cases. */
static struct G(poly) G(base_piece)(const num t[], int i, int order, int s)
{
    if (s == i - 1)
        return G(printed_term)(t[s], t[s + 1], 2 * order + 1);
    if (s == i)
        return G(printed_term)(t[s], t[s + 1], 2 * order);
    return G(constant)(from_int(0));
}

CLAIM(base_functions_interpolate_once_continuously)
{
    enum { most = 10 };
    int n = T->degree;
    num t[most], f[2][most], p = parameter(T, "p");
    t[0] = unknown(T, "t", 0);
    for (int i = 0; i <= n; i++) {
        if (i > 0)
            t[i] = add(t[i - 1], positive(T, "h", i));
        f[0][i] = unknown(T, "f", i);
        f[1][i] = unknown(T, "d", i);
    }
    for (int s = 0; s < n; s++) {
        struct G(poly) sum = G(constant)(from_int(0));
        for (int i = 0; i <= n; i++)
            for (int order = 0; order < 2; order++) {
                int wrong = fault(T, 0, order == 1 && i == 0 && s == 0);
                struct G(poly) a = wrong ? G(printed_term)(t[0], t[1], 3) : G(base_piece)(t, i, order, s);
                sum = G(plus)(sum, G(times)(G(constant)(f[order][i]), a));
            }
        for (int end = s; end <= s + 1; end++)
            for (int order = 0; order < 2; order++) {
                about(T, order == 0 ? "the value at a node" : "the derivative at a node");
                same(T, G(at)(sum, order, t[end]), f[order][end]);
            }
        num four[4] = {f[0][s], f[0][s + 1], f[1][s], f[1][s + 1]}, value;
        G(hermite_cubic)(1, t[s], t[s + 1], four, p, 0, &value);
        about(T, "the piece");
        same(T, G(at)(sum, 0, p), value);
    }
}

/*
The sum has $2n+2$ terms, but at each $t$ at most four of them are not 0.  This is true on intervals that lie one after the other: the nodes
must not only differ but increase.

:::{statement} slides-ch4:2-piecewise
:title: The whole curve
:zh: 完整的插值多项式
:printed: $P(t)=\sum_{i=0}^n[f(t_i)a_{i,0}(t)+f'(t_i)a_{i,1}(t)]$ on $[t_0,t_n]$ has just four terms on each $[t_i,t_{i+1}]$ and
  satisfies $P(t_i)=f(t_i)$, $P'(t_i)=f'(t_i)$, $i=0,1,\dots,n$
:holds-by: base_functions_interpolate_once_continuously
:argued: every number of intervals | On an interval none of the four functions of its two ends is 0 everywhere, since by `base_functions_interpolate_once_continuously` each has at one end of it
  the value or the derivative 1; all others are 0 there by their definition.
:needs: overlapping_intervals_miss_the_data | the words: in the interval $[t_0,t_n]$, and the ranges of the printed cases |
  $t_0<t_1<\dots<t_n$: intervals $[t_i,t_{i+1}]$ of $[t_0,t_n]$
:figure: nodes_that_meet

The slides call $P$ an interpolating polynomial, and say that it is defined piece by piece.  A polynomial it is on each interval; over two of them it
need not be one, for its second derivative may jump, `pieces_need_not_have_one_curvature`.
:::
*/

#if RATIONAL
/*
:::{claim} overlapping_intervals_miss_the_data
:title: If the nodes go back, two pieces lie over one interval
:zh: 节点不递增则各段重叠
:kind: counterexample
:data: t = 0 2 1; f = 0 0 1; f' = 0 0 0
:instead: f = 0 0 0
:result: P(t_2) = 0
:given: three different nodes $t$, of which the last lies between the first two, with the values $f$ and the derivatives $f'$
:then: over $[t_0,t_1]$ the curve is the first piece, which is 0, so that $P(t_2)$ is not the value prescribed there
:method: The kernel on $[t_0,t_1]$, at $t_2$.
:control: the value of the first piece is prescribed at $t_2$
:::
*/
CLAIM(overlapping_intervals_miss_the_data)
{
    num t[3], f[3], slope[3], value;
    given_points(T, "t", 3, 1, t);
    given_points(T, "f", 3, 1, f);
    given_points(T, "f'", 3, 1, slope);
    hermite_cubic_q(1, t[0], t[1], (num[]){f[0], f[1], slope[0], slope[1]}, t[2], 0, &value);
    found(T, "P(t_2)", value);
    about(T, "the first piece at t_2, and the value prescribed there");
    same(T, value, f[2]);
}

/*
:::{statement} slides-ch4:2-piece-of-curve
:title: The curve on one interval, in points and tangents
:zh: 单段的四项表示
:printed: The piece $P_i(t)$ is defined on $[t_i,t_{i+1}]$ only: $P_i(t)=P_ia_{i,0}(t)+P_{i+1}a_{i+1,0}(t)+P_i'a_{i,1}(t)+P_{i+1}'a_{i+1,1}(t)=P_ig_{i,0}(t)+P_{i+1}g_{i,1}(t)+[P_i'h_{i,0}(t)+P_{i+1}'h_{i,1}(t)](t_{i+1}-t_i)$
:holds-by: base_functions_interpolate_once_continuously
:needs: overlapping_intervals_miss_the_data | the words: in the interval $[t_0,t_n]$, and the ranges of the printed cases |
  $t_0<t_1<\dots<t_n$: intervals $[t_i,t_{i+1}]$ of $[t_0,t_n]$
:meant: the factor $t_{i+1}-t_i$ in the same line, and the sum before it, to which it is equal | $P_i'=f'(t_i)$, and the factor belongs to both derivatives.
:reading: base_functions_interpolate_once_continuously | $P_i'=f'(t_i)$, and the factor belongs to both derivatives
:reading: factor_beside_the_second_derivative_loses_the_first | $P_i'=f'(t_i)$, and the factor belongs to the second derivative alone, the sum having no bracket
:reading: scaled_tangent_is_not_scaled_again | $P_i'=f'(t_i)(t_{i+1}-t_i)$, as for the piece over the unit interval
:figure: piecewise_base_functions

In the text at hand, which keeps no square brackets, the formula has none.
:::

:::{claim} factor_beside_the_second_derivative_loses_the_first
:title: If only the second derivative is multiplied by the length the first one is lost
:zh: 区间长度须同乘两个导数
:kind: counterexample
:data: t = 0 2; f'(t_0) = 1
:instead: t = 0 1
:result: derivative there = 1/2
:given: the nodes $t$ and the derivative $f'(t_0)$, the other data being 0; $P_0'=f'(t_0)$
:then: $P_0'h_{0,0}(t)$, without a factor, has at $t_0$ another derivative than $f'(t_0)$
:method: The printed function, multiplied out and differentiated.
:control: an interval of length 1
:::
*/
CLAIM(factor_beside_the_second_derivative_loses_the_first)
{
    num t[2];
    given_points(T, "t", 2, 1, t);
    num slope = given(T, "f'(t_0)"), derivative = mul(slope, G(at)(G(printed_blending)(t[0], t[1], 2), 1, t[0]));
    found(T, "derivative there", derivative);
    about(T, "the derivative at t_0, and f'(t_0)");
    same(T, derivative, slope);
}

/*
:::{claim} scaled_tangent_is_not_scaled_again
:title: A tangent that contains the length must not be multiplied by it again
:zh: 切向量不可重复缩放
:kind: counterexample
:data: t = 0 2; f'(t_0) = 1
:instead: t = 0 1
:result: P_0' = 2; derivative there = 2
:given: the nodes $t$ and the derivative $f'(t_0)$, the other data being 0; $P_0'=f'(t_0)(t_1-t_0)$
:then: $P_0'h_{0,0}(t)(t_1-t_0)$ has at $t_0$ another derivative than $f'(t_0)$
:method: The printed function, multiplied out and differentiated.
:control: an interval of length 1
:::
*/
CLAIM(scaled_tangent_is_not_scaled_again)
{
    num t[2];
    given_points(T, "t", 2, 1, t);
    num slope = given(T, "f'(t_0)"), scaled = mul(slope, sub(t[1], t[0]));
    /* d/dt of P_0' h_{0,0}(t) (t_1 - t_0) */
    num derivative = mul(scaled, G(at)(G(printed_term)(t[0], t[1], 2), 1, t[0]));
    found(T, "P_0'", scaled);
    found(T, "derivative there", derivative);
    about(T, "the derivative at t_0, and f'(t_0)");
    same(T, derivative, slope);
}

/*
How smooth is a curve that is joined smoothly?  Value and slope are shared at a node and nothing else is.  For the second derivatives to
agree there is one linear condition at each inner node; the curves that satisfy all of them are the cubic splines.

:::{statement} slides-ch4:2-smooth
:title: The pieces join smoothly
:zh: 逐段光滑连接
:printed: The cubics are joined smoothly, piece by piece.
:holds-by: base_functions_interpolate_once_continuously
:needs: overlapping_intervals_miss_the_data | the words: in the interval $[t_0,t_n]$, and the ranges of the printed cases |
  $t_0<t_1<\dots<t_n$: intervals $[t_i,t_{i+1}]$ of $[t_0,t_n]$
:meant: the data, which are values and first derivatives | With a continuous first derivative, $C^1$.
:reading: base_functions_interpolate_once_continuously | $C^1$, for all data
:reading: pieces_turn_where_a_derivative_vanishes | a continuous tangent, for all points and tangent vectors of curves: where a vector is 0 the tangent may turn
:reading: pieces_need_not_have_one_curvature | $C^2$, for all data
:reading: second_derivatives_meet_on_a_condition | $C^2$, if one linear condition holds at each inner node, and only then
:figure: piecewise_is_not_c2
:::

:::{claim} pieces_need_not_have_one_curvature
:title: The second derivative may jump at a node
:zh: 二阶导数可以间断
:kind: counterexample
:data: t = 0 1 2; f = 0 1 1; f' = 0 0 0
:instead: f = 0 1 0
:result: P''(t_1-) = -6; P''(t_1+) = 0
:given: three nodes $t$ with the values $f$ and the derivatives $f'$, and the curve $P$ of two pieces
:then: the second derivative at the inner node is not the same from the left as from the right
:method: The kernel on both intervals.
:control: values that are symmetric about the inner node
:::
*/
CLAIM(pieces_need_not_have_one_curvature)
{
    num t[3], f[3], slope[3], side[2][3];
    given_points(T, "t", 3, 1, t);
    given_points(T, "f", 3, 1, f);
    given_points(T, "f'", 3, 1, slope);
    for (int s = 0; s < 2; s++)
        hermite_cubic_q(1, t[s], t[s + 1], (num[]){f[s], f[s + 1], slope[s], slope[s + 1]}, t[1], 2, side[s]);
    found(T, "P''(t_1-)", side[0][2]);
    found(T, "P''(t_1+)", side[1][2]);
    about(T, "P'' at t_1 from the left and from the right");
    same(T, side[0][2], side[1][2]);
}
#endif

#if RATIONAL
/*
:::{claim} pieces_turn_where_a_derivative_vanishes
:title: Where the derivative at a node is 0 the tangent may turn by a right angle
:zh: 节点导矢为零处切向可转直角
:kind: counterexample
:data: t = 0 1 2; P = (0,0) (1,0) (1,1); P' = (0,0) (0,0) (0,0); h = 1/10
:instead: P' = (0,0) (1,1) (0,0)
:result: P'(t_1-h) = (27/50,0); P'(t_1+h) = (0,27/50); P'(t_1-s) P'(t_1+s) = "0"
:given: three nodes $t$ with the points $P$ and the derivatives $P'$, and the curve of two pieces; a small $h$
:then: the tangents before and after the inner node are at a right angle, however near to it: $P'(t_1-s)\cdot P'(t_1+s)=0$ for every $s$, while neither is 0 at $h$
:method: The kernel on both intervals at $h$; at every $s$ by the coefficients of the two pieces, from the base functions.
:control: a derivative at the node that is not $0$
:::
*/
CLAIM(pieces_turn_where_a_derivative_vanishes)
{
    num t[3], P[6], slope[6], before[4], after[4], h = given(T, "h");
    given_points(T, "t", 3, 1, t);
    given_points(T, "P", 3, 2, P);
    given_points(T, "P'", 3, 2, slope);
    num first[8] = {P[0], P[1], P[2], P[3], slope[0], slope[1], slope[2], slope[3]};
    num second[8] = {P[2], P[3], P[4], P[5], slope[2], slope[3], slope[4], slope[5]};
    hermite_cubic_q(2, t[0], t[1], first, sub(t[1], h), 1, before);
    hermite_cubic_q(2, t[1], t[2], second, add(t[1], h), 1, after);
    found_points(T, "P'(t_1-h)", 1, 2, before + 2);
    found_points(T, "P'(t_1+h)", 1, 2, after + 2);
    poly product = poly_constant(from_int(0));
    for (int c = 0; c < 2;
         c++) { /* intervals of length 1: P_0 + m_0 x + (3 d - 2 m_0 - m_1) x^2 + (m_0 + m_1 - 2 d) x^3 */
        poly piece[2];
        for (int k = 0; k < 2; k++) {
            num d = sub(P[2 * k + 2 + c], P[2 * k + c]), m0 = slope[2 * k + c], m1 = slope[2 * k + 2 + c];
            num square = sub(sub(mul(from_int(3), d), mul(from_int(2), m0)), m1);
            piece[k] = poly_from_q(4, (num[]){P[2 * k + c], m0, square, sub(add(m0, m1), mul(from_int(2), d))});
        }
        poly back = poly_compose(poly_derivative(piece[0]), poly_from_q(2, (num[]){from_int(1), from_int(-1)}));
        product = poly_add(product, poly_mul(back, poly_derivative(piece[1])));
    }
    found_text(T, "P'(t_1-s) P'(t_1+s)", poly_to_string(product, "s"));
    about(T, "the product of the two derivatives at h");
    same(T, add(mul(before[2], after[2]), mul(before[3], after[3])), poly_value(product, h));
    about(T, "whether the tangents are at a right angle, however near to the node");
    refute(T, poly_is_zero(product) && !is_zero_q(before[2]) && !is_zero_q(after[3]));
}
#endif

/*
:::{claim} second_derivatives_meet_on_a_condition
:title: The jump of the second derivative
:zh: 二阶连续的条件
:given: $t_{i-1}<t_i<t_{i+1}$ with the distances $h_{i-1}$ and $h_i$, any values $f_i$ and derivatives $f_i'$ there, and the curve $P$ of the two pieces
:then: $\frac12\bigl(P''(t_i+)-P''(t_i-)\bigr)$ is
  $3\frac{f_{i+1}-f_i}{h_i^2}+3\frac{f_i-f_{i-1}}{h_{i-1}^2}-\frac{f'_{i+1}}{h_i}-2f'_i\bigl(\frac1{h_{i-1}}+\frac1{h_i}\bigr)-\frac{f'_{i-1}}{h_{i-1}}$
:method: The kernel on both intervals, against the formula; everything variable.
:over: t# h#: increasing nodes; f# d#: data
:control: $2f_i'$ replaced by $f_i'$
:::
*/
CLAIM(second_derivatives_meet_on_a_condition)
{
    num f[3], d[3], h[2] = {positive(T, "h", 0), positive(T, "h", 1)}, side[2], sum = from_int(0);
    num t[3] = {unknown(T, "t", 0)}, out[3];
    for (int i = 0; i < 3; i++) {
        f[i] = unknown(T, "f", i);
        d[i] = unknown(T, "d", i);
    }
    for (int s = 0; s < 2; s++) {
        t[s + 1] = add(t[s], h[s]);
        num four[4] = {f[s], f[s + 1], d[s], d[s + 1]};
        G(hermite_cubic)(1, t[s], t[s + 1], four, t[1], 2, out);
        side[s] = out[2];
        num slope = div(sub(f[s + 1], f[s]), mul(h[s], h[s]));
        num tangents = add(d[2 * s], mul(from_int(fault(T, 2, 1)), d[1]));
        sum = add(sum, sub(mul(from_int(3), slope), div(tangents, h[s])));
    }
    /* half of P''(t_i+) - P''(t_i-) is the sum over both intervals of 3 (f_{s+1} - f_s)/h_s^2 - (f'_{2s} + 2 f'_1)/h_s */
    same(T, div(sub(side[1], side[0]), from_int(2)), sum);
}

/*
## One parameter for each piece

Over the unit interval a piece has the tangents $f'(t_i)$ times the length of its interval.  Two neighbours of different lengths
have two different vectors at their common node.  The slides call both $P_i'$.

:::{statement} slides-ch4:2-piece-over-unit
:title: The piece over the unit interval
:zh: 单段变换到单位区间
:printed: $u=\frac{t-t_i}{t_{i+1}-t_i}$, $t=t_i+u(t_{i+1}-t_i)$:
  $P_i(u)=P_i(2u^3-3u^2+1)+P_{i+1}(-2u^3+3u^2)+P_i'(u^3-2u^2+u)+P_{i+1}'(u^3-u^2)$, and the same by the matrix
:holds-by: unit_blending_functions
:confirmed-by: one_choice_of_signs_in_the_matrix
:needs: equal_ends_have_no_cubic | the transformation, which is that of the interval $[t_i,t_{i+1}]$ | $t_i\ne t_{i+1}$: $u$
  is a quotient by $t_{i+1}-t_i$, and at equal ends none or infinitely many cubics have the data
:meant: the line below the formula, which begins with "where" (其中) | $P_i'$ and $P_{i+1}'$ are the derivatives times $t_{i+1}-t_i$.
:reading: unit_blending_functions | $P_i'=f'(t_i)(t_{i+1}-t_i)$, as in the line below
:reading: tangent_over_the_unit_interval_is_scaled | $P_i'=f'(t_i)$, as for the piece over its own interval
:figure: one_tangent_two_lengths

In the text at hand the formula has no signs and no primes; with those shown here it is true.
:::

:::{statement} slides-ch4:2-scaled-tangents
:title: The tangents of the piece over the unit interval
:zh: 单段端点切向量的缩放
:printed: where $P_i=P(t_i)=f(t_i)$, $P_{i+1}=P(t_{i+1})=f(t_{i+1})$, $P_i'=f'(t_i)(t_{i+1}-t_i)$, $P_{i+1}'=f'(t_{i+1})(t_{i+1}-t_i)$
:holds-by: unit_blending_functions
:needs: equal_ends_have_no_cubic | the transformation, which is that of the interval $[t_i,t_{i+1}]$ | $t_i\ne t_{i+1}$: the parameter
  $u=\frac{t-t_i}{t_{i+1}-t_i}$ of the unit interval is a quotient by $t_{i+1}-t_i$
:meant: the word "where" (其中) below the formula of the piece $P_i(u)$ | The vectors $P_i'$ and $P_{i+1}'$ are those of the one piece over $[t_i,t_{i+1}]$.
:reading: unit_blending_functions | the vectors of one piece
:reading: one_scaled_tangent_for_two_pieces_makes_a_jump | one vector $P_i'$ for both pieces that meet at $t_i$
:figure: one_tangent_two_lengths

In the text at hand the formulas have no signs and no primes.
The same letter is used for the tangent at the end of one piece, $f'(t_i)(t_i-t_{i-1})$, and at the start of the next, and before, in the sum
over all $P_ia_{i,0}+P_i'a_{i,1}$, for $f'(t_i)$ itself.
:::
*/

#if RATIONAL
/*
:::{claim} tangent_over_the_unit_interval_is_scaled
:title: Over the unit interval the derivative by t itself makes another curve
:zh: 单位区间上须用缩放的切向量
:kind: counterexample
:data: t = 0 2; f'(t_0) = 1
:instead: t = 0 1
:result: dP/dt there = 1/2
:given: the nodes $t$ and the derivative $f'(t_0)$, the other data being 0; the piece over the unit interval with $P_0'=f'(t_0)$
:then: at $t_0$ it has another derivative with respect to $t$ than $f'(t_0)$
:method: The kernel over the unit interval, its derivative divided by the length.
:control: an interval of length 1
:::
*/
CLAIM(tangent_over_the_unit_interval_is_scaled)
{
    num t[2], zero = from_int(0), one = from_int(1), slope = given(T, "f'(t_0)"), out[2];
    given_points(T, "t", 2, 1, t);
    hermite_cubic_q(1, zero, one, (num[]){zero, zero, slope, zero}, zero, 1, out);
    num derivative = div(out[1], sub(t[1], t[0]));
    found(T, "dP/dt there", derivative);
    about(T, "the derivative at t_0, and f'(t_0)");
    same(T, derivative, slope);
}

/*
:::{claim} one_scaled_tangent_for_two_pieces_makes_a_jump
:title: With the scaled tangent of the piece before, the derivative jumps
:zh: 混用相邻段的缩放切向量使导数间断
:kind: counterexample
:data: t = 0 1 3; f'(t_1) = 1
:instead: t = 0 1 2
:result: P_1' = 1; dP/dt before = 1; dP/dt after = 1/2
:given: three nodes $t$ with intervals of different lengths, and the derivative $f'(t_1)$; $P_1'=f'(t_1)(t_1-t_0)$, the tangent at the end of
  the first piece over the unit interval
:then: the second piece with this $P_1'$ starts with $\frac{dP}{dt}=\frac{P_1'}{t_2-t_1}$, which is not $f'(t_1)$
:method: The kernel over the unit interval, its derivative divided by the length.
:control: intervals of one length
:::
*/
CLAIM(one_scaled_tangent_for_two_pieces_makes_a_jump)
{
    num t[3], zero = from_int(0), one = from_int(1), slope[2];
    given_points(T, "t", 3, 1, t);
    num tangent = mul(given(T, "f'(t_1)"), sub(t[1], t[0]));
    for (int s = 0; s < 2; s++) {
        num four[4] = {one, one, tangent, tangent}, out[2]; /* P_1' ends the one piece and begins the other */
        hermite_cubic_q(1, zero, one, four, s == 0 ? one : zero, 1, out);
        slope[s] = div(out[1], sub(t[s + 1], t[s]));
    }
    found(T, "P_1'", tangent);
    found(T, "dP/dt before", slope[0]);
    found(T, "dP/dt after", slope[1]);
    about(T, "dP/dt at t_1 from the left and from the right");
    same(T, slope[0], slope[1]);
}
#endif

#include "chapters/judge/claims_off.h"
