/*
# Piece by piece (分段三次 Hermite 插值)

The degree of the polynomial with all data grows with the data.  Instead the cubic with the four data of $[t_i,t_{i+1}]$ is
taken on each interval.  Neighbours share a value and a derivative at the node between them, so the curve has a
continuous tangent whatever the data are; the second derivative is another matter.
*/
#include "chapters/hermite-coons/definition.h"

#include "chapters/judge/claims_on.h"

/*
## The pieces

:::{statement} slides-ch4:2-piece
:title: The cubic on one interval
:zh: 第 i 段三次 Hermite 插值
:printed: $P_i(t)=f(t_i)g_{i0}(t)+f(t_{i+1})g_{i1}(t)+f'(t_i)h_{i0}(t)(t_{i+1}-t_i)+f'(t_{i+1})h_{i1}(t)(t_{i+1}-t_i)$, $i=0,\dots,n-1$, with
  $g_{i0}=\bigl(1-2\frac{t-t_i}{t_i-t_{i+1}}\bigr)\bigl(\frac{t-t_{i+1}}{t_i-t_{i+1}}\bigr)^2$,
  $g_{i1}=\bigl(1-2\frac{t-t_{i+1}}{t_{i+1}-t_i}\bigr)\bigl(\frac{t-t_i}{t_{i+1}-t_i}\bigr)^2$,
  $h_{i0}=\frac{t-t_i}{t_{i+1}-t_i}\bigl(\frac{t-t_{i+1}}{t_i-t_{i+1}}\bigr)^2$, $h_{i1}=\frac{t-t_{i+1}}{t_{i+1}-t_i}\bigl(\frac{t-t_i}{t_{i+1}-t_i}\bigr)^2$
:holds-by: base_functions_interpolate_once_continuously
:needs: equal_nodes_have_no_interpolant | an interval $[t_i,t_{i+1}]$: $t_i\ne t_{i+1}$
:figure: nodes_that_meet
:::

:::{statement} slides-ch4:2-base-functions
:title: The functions of one datum on the whole interval
:zh: 整体基函数
:printed: $a_{i,0}$ is $g_{i-1,1}$ on $[t_{i-1},t_i]$, $g_{i,0}$ on $[t_i,t_{i+1}]$ and 0 elsewhere; $a_{i,1}$ is
  $h_{i-1,1}(t)(t_i-t_{i-1})$, $h_{i,0}(t)(t_{i+1}-t_i)$ and 0; for $i=0$ and $i=n$ the piece outside $[t_0,t_n]$ is left out
:definition: yes
:checked-by: base_functions_interpolate_once_continuously
:figure: piecewise_base_functions
:::

:::{claim} base_functions_interpolate_once_continuously
:title: The sum over all data is, on each interval, the cubic of its four data, and the pieces meet in C1
:zh: 分段插值的一阶连续性
:given: nodes $t_0<\dots<t_n$, any data, any $t$
:then: on each of the $n$ intervals the sum of the $2n+2$ terms is what `hermite_cubic` gives for four data; at each node its value
  and derivative are the data, from both sides
:method: The functions $a_{i,j}$ as printed, with the lengths, interval by interval, all $2n+2$ summed as polynomials; everything variable.
:degrees: 1..4 sampled 8
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
:::{statement} slides-ch4:2-piecewise
:title: The whole curve
:zh: 完整的插值多项式
:printed: $P(t)=\sum_{i=0}^n[f(t_i)a_{i,0}(t)+f'(t_i)a_{i,1}(t)]$ on $[t_0,t_n]$ has just four terms on each $[t_i,t_{i+1}]$ and
  satisfies $P(t_i)=f(t_i)$, $P'(t_i)=f'(t_i)$
:holds-by: base_functions_interpolate_once_continuously
:needs: overlapping_intervals_miss_the_data | intervals $[t_i,t_{i+1}]$ of $[t_0,t_n]$: $t_0<t_1<\dots<t_n$
:figure: nodes_that_meet
:::
*/

#if RATIONAL
/*
:::{claim} overlapping_intervals_miss_the_data
:title: If the nodes go back, two pieces lie over one interval
:zh: 节点不递增则各段重叠
:kind: counterexample
:given: nodes 0, 2, 1, which are different, the values 0, 0, 1 and the derivatives 0
:then: over $[0,2]$ the curve is the first piece, which is 0, so that $P(t_2)=P(1)=0$, not 1
:method: The kernel on $[t_0,t_1]$, at $t_2$.
:control: the value 0 at $t_2$
:::
*/
CLAIM(overlapping_intervals_miss_the_data)
{
    num zero = from_int(0), four[4] = {zero, zero, zero, zero}, value, given = from_int(fault(T, 0, 1));
    hermite_cubic_q(1, zero, from_int(2), four, from_int(1), 0, &value);
    show_points(T, "t_0, t_1, t_2", 3, 1, (num[]){zero, from_int(2), from_int(1)});
    about(T, "the first piece at t_2, and the value prescribed there");
    same(T, value, given);
}

/*
:::{statement} slides-ch4:2-piece-of-curve
:title: The curve on one interval, in points and tangents
:zh: 单段的四项表示
:printed: P_i(t)=P_ia_{i,0}(t)+P_{i+1}a_{i+1,0}(t)+P_i'a_{i,1}(t)+P_{i+1}'a_{i+1,1}(t)=P_ig_{i,0}(t)+P_{i+1}g_{i,1}(t)+[P_i'h_{i,0}(t)+P_{i+1}'h_{i,1}(t)](t_{i+1}-t_i)
:holds-by: base_functions_interpolate_once_continuously
:reading: base_functions_interpolate_once_continuously | $P_i'=f'(t_i)$: true
:reading: scaled_tangent_is_not_scaled_again | $P_i'=f'(t_i)(t_{i+1}-t_i)$, as for the piece over the unit interval: false for other lengths than 1
:figure: piecewise_base_functions

The bracket is lost; the one factor at the end belongs to both derivatives.
:::

:::{claim} scaled_tangent_is_not_scaled_again
:title: A tangent that contains the length must not be multiplied by it again
:zh: 切向量不可重复缩放
:kind: counterexample
:given: $t_0=0$, $t_1=2$, $f'(0)=1$ and the other data 0; $P_0'=f'(0)(t_1-t_0)=2$
:then: $P_0'h_{0,0}(t)(t_1-t_0)$ has at 0 the derivative 2, not $f'(0)=1$
:method: The printed function, multiplied out and differentiated.
:control: $t_1=1$
:::
*/
CLAIM(scaled_tangent_is_not_scaled_again)
{
    num zero = from_int(0), t1 = from_int(fault(T, 1, 2)), slope = from_int(1);
    num scaled = mul(slope, t1);
    show(T, "t_1 - t_0", t1);
    show(T, "P_0'", scaled);
    about(T, "the derivative at t_0, and f'(t_0)");
    same(T, mul(scaled, G(at)(G(printed_term)(zero, t1, 2), 1, zero)), slope);
}

/*
:::{statement} slides-ch4:2-smooth
:title: The pieces join smoothly
:zh: 逐段光滑连接
:printed: The cubics are joined smoothly, piece by piece.
:holds-by: base_functions_interpolate_once_continuously
:reading: base_functions_interpolate_once_continuously | $C^1$: for all data
:reading: pieces_need_not_have_one_curvature | $C^2$: not for all data
:reading: second_derivatives_meet_on_a_condition | $C^2$: if and only if one linear condition holds at each inner node
:figure: piecewise_is_not_c2
:::

:::{claim} pieces_need_not_have_one_curvature
:title: The second derivative may jump at a node
:zh: 二阶导数可以间断
:kind: counterexample
:given: nodes 0, 1, 2 with the values 0, 1, 1 and the derivatives 0
:then: $P''(1)$ is $-6$ from the left and 0 from the right
:method: The kernel on both intervals.
:control: the values 0, 1, 0
:::
*/
CLAIM(pieces_need_not_have_one_curvature)
{
    num f[3] = {from_int(0), from_int(1), from_int(fault(T, 0, 1))}, zero = from_int(0), side[2][3];
    for (int s = 0; s < 2; s++) {
        num four[4] = {f[s], f[s + 1], zero, zero};
        hermite_cubic_q(1, from_int(s), from_int(s + 1), four, from_int(1), 2, side[s]);
    }
    show_points(T, "f(0), f(1), f(2)", 3, 1, f);
    about(T, "P''(1) from the left and from the right");
    same(T, side[0][2], side[1][2]);
}
#endif

/*
:::{claim} second_derivatives_meet_on_a_condition
:title: The jump of the second derivative
:zh: 二阶连续的条件
:given: $t_{i-1}<t_i<t_{i+1}$ with the distances $h_{i-1}$ and $h_i$, any data
:then: $\frac12\bigl(P''(t_i+)-P''(t_i-)\bigr)$ is
  $3\frac{f_{i+1}-f_i}{h_i^2}+3\frac{f_i-f_{i-1}}{h_{i-1}^2}-\frac{f'_{i+1}}{h_i}-2f'_i\bigl(\frac1{h_{i-1}}+\frac1{h_i}\bigr)-\frac{f'_{i-1}}{h_{i-1}}$
:method: The kernel on both intervals, against the formula; everything variable.
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
    same(T, div(sub(side[1], side[0]), from_int(2)), sum);
}

/*
## One parameter for each piece

:::{statement} slides-ch4:2-piece-over-unit
:title: The piece over the unit interval
:zh: 单段变换到单位区间
:printed: $u=\frac{t-t_i}{t_{i+1}-t_i}$, $t=t_i+u(t_{i+1}-t_i)$:
  $P_i(u)=P_i(2u^3-3u^2+1)+P_{i+1}(-2u^3+3u^2)+P_i'(u^3-2u^2+u)+P_{i+1}'(u^3-u^2)$, and the same by the matrix
:holds-by: unit_blending_functions one_choice_of_signs_in_the_matrix
:needs: equal_nodes_have_no_interpolant | an interval: $t_i\ne t_{i+1}$
:figure: one_tangent_two_lengths
:::

:::{statement} slides-ch4:2-scaled-tangents
:title: The tangents of the piece over the unit interval
:zh: 单段端点切向量的缩放
:printed: $P_i=f(t_i)$, $P_{i+1}=f(t_{i+1})$, $P_i'=f'(t_i)(t_{i+1}-t_i)$, $P_{i+1}'=f'(t_{i+1})(t_{i+1}-t_i)$
:holds-by: unit_blending_functions
:hypothesis: one_scaled_tangent_for_two_pieces_makes_a_jump | $P_i'$ belongs to one interval; for both intervals at $t_i$
  it is one vector only if they have one length (or $f'(t_i)=0$)
:figure: one_tangent_two_lengths

The same letter is used for the tangent at the end of one piece, $f'(t_i)(t_i-t_{i-1})$, and at the start of the next, and before, in the sum
over all $P_ia_{i,0}+P_i'a_{i,1}$, for $f'(t_i)$ itself.
:::
*/

#if RATIONAL
/*
:::{claim} one_scaled_tangent_for_two_pieces_makes_a_jump
:title: With the scaled tangent of the piece before, the derivative jumps
:zh: 混用相邻段的缩放切向量使导数间断
:kind: counterexample
:given: nodes 0, 1, 3, $f'(1)=1$; so $P_1'=1$ at the end of the first piece
:then: the second piece with $P_1'=1$ starts with $\frac{dP}{dt}=\frac{P_1'}{t_2-t_1}=\frac12$, not 1
:method: The kernel over the unit interval, its derivative divided by the length.
:control: nodes 0, 1, 2
:::
*/
CLAIM(one_scaled_tangent_for_two_pieces_makes_a_jump)
{
    num zero = from_int(0), one = from_int(1), t[3] = {zero, one, from_int(fault(T, 2, 3))}, slope[2];
    for (int s = 0; s < 2; s++) {
        num four[4] = {one, one, one, one}, out[2]; /* P_1' = 1 is the last datum of one, the third of the other */
        hermite_cubic_q(1, zero, one, four, s == 0 ? one : zero, 1, out);
        slope[s] = div(out[1], sub(t[s + 1], t[s]));
    }
    show_points(T, "t_0, t_1, t_2", 3, 1, t);
    about(T, "dP/dt at t_1 from the left and from the right");
    same(T, slope[0], slope[1]);
}
#endif

#include "chapters/judge/claims_off.h"
