/*
# Other parameters (曲线的参数变换)

A piece of a curve is a curve, and is given the unit interval again; a quotient of linear functions does more.  The source has
the first with all its formulas, and breaks off before those of the second.
*/
#include "chapters/foundations/definition.h"

#include "chapters/judge/claims_on.h"

enum { dim = 2, space = 3 };

/*
## A piece of a curve as a curve (参数规范化)

:::{statement} hu-1987:1-5-4
:title: The parameter of a piece
:zh: 参数的线性变换
:printed: For the piece from $t_0$ to $t_1$ and $0\le t^*\le1$: $t=(1-t^*)t_0+t^*t_1=t_0+(t_1-t_0)t^*$
:holds-by: linear_change_runs_through_the_interval
:confirmed-by: pieces_in_new_powers
:figure: piece_of_a_cubic
:::

:::{claim} linear_change_runs_through_the_interval
:title: The linear change of the parameter takes 0 and 1 to the ends of the interval, and keeps the order
:zh: 线性参数变换
:given: any $t_0$ and $t_1$, any $u$; and an interval, $t_1=t_0+h$, $h>0$
:then: $(1-u)t_0+ut_1=t_0+(t_1-t_0)u$, which is $t_0$ for $u=0$ and $t_1$ for $u=1$; of two values of $u$ the larger one gives the larger value
  where $t_0<t_1$, and $t_0\le t\le t_1$ is the value at $u=\frac{t-t_0}{t_1-t_0}$, which is in $[0,1]$: so $0\le u\le1$ is taken to $t_0\le t\le t_1$, each value once
:method: Identities with everything a variable; the difference of two values is $h$ times that of the parameters, with $h>0$; $t$ is so written that it divides the
  interval into two parts of any lengths.
:over: r s u: parameter value; d h e#: -
:control: $t_0$ and $t_1$ exchanged in the first form
:::
*/
CLAIM(linear_change_runs_through_the_interval)
{
    num t0 = parameter(T, "r"), t1 = parameter(T, "s"), u = parameter(T, "u"), zero = from_int(0), one = from_int(1);
    num places[3] = {u, zero, one}, values[3] = {add(t0, mul(sub(t1, t0), u)), t0, t1};
    for (int k = 0; k < 3; k++) {
        num first = fault(T, t0, t1), last = fault(T, t1, t0);
        about(T, k == 0 ? "the two forms" : "an end");
        same(T, add(mul(sub(one, places[k]), first), mul(places[k], last)), values[k]);
    }
    num h = positive(T, "h", 0), later = positive(T, "d", 0),
        gap = sub(add(t0, mul(h, add(u, later))), add(t0, mul(h, u)));
    about(T, "the order");
    G(must_be_positive)(T, gap);
    same(T, gap, mul(h, later));
    num before = positive(T, "e", 0), after = positive(T, "e", 1), length = add(before, after), t = add(t0, before);
    num place = div(sub(t, t0), length);
    about(T, "the parameter of a value");
    same(T, add(t0, mul(length, place)), t);
    nonnegative(T, place);
    nonnegative(T, sub(one, place));
}

/*
:::{claim} pieces_in_new_powers
:title: The kernel gives the piece between two parameters, in a parameter from 0 to 1
:zh: 截取曲线段
:given: any coefficients of degree $n$ in the plane, any $t_0$, $t_1$ and $u$
:then: the curve of `power_on_interval` at $u$ is $P((1-u)t_0+ut_1)$, and that is $P(t_0+(t_1-t_0)u)$
:method: The kernel's coefficients in the sum of powers, against the sum of powers at either parameter; everything a variable.
:degrees: 1..6 sampled 12
:over: x# y#: coefficients; r s: parameter value; u: parameter value
:defines: power_on_interval
:control: $t_0$ and $t_1$ exchanged
:::
*/
CLAIM(pieces_in_new_powers)
{
    int n = T->degree;
    num c[(MAX_DEGREE + 1) * dim], piece[(MAX_DEGREE + 1) * dim];
    num t0 = parameter(T, "r"), t1 = parameter(T, "s"), u = parameter(T, "u");
    G(free_points)(T, n, dim, c);
    G(power_on_interval)(n, dim, c, fault(T, t0, t1), fault(T, t1, t0), piece);
    num mean = add(mul(sub(from_int(1), u), t0), mul(u, t1)), along = add(t0, mul(sub(t1, t0), u));
    for (int j = 0; j < dim; j++) {
        num value = G(power_sum)(n, dim, piece, j, u);
        same(T, value, G(power_sum)(n, dim, c, j, mean));
        same(T, value, G(power_sum)(n, dim, c, j, along));
    }
}

/*
A piece that is cut out of a curve has to be given the unit interval again.  For points this is the insertion of a
linear function; for coefficients it is Taylor's formula at $t_0$ with the unit of length $t_1-t_0$, and the four
printed rows are its four terms.

:::{statement} hu-1987:1-5-5
:title: The coefficients of a piece
:zh: 截取曲线段的系数
:printed: P(t^*)=[t^{*3}\;t^{*2}\;t^*\;1]\begin{bmatrix}(t_1-t_0)^3A\\3(t_1-t_0)^2t_0A+(t_1-t_0)^2B\\3(t_1-t_0)t_0^2A+2(t_1-t_0)t_0B+(t_1-t_0)C\\t_0^3A+t_0^2B+t_0C+D\end{bmatrix}=[t^{*3}\;t^{*2}\;t^*\;1]\,[A^*\;B^*\;C^*\;D^*]^T
:holds-by: coefficients_of_a_piece_are_as_printed
:confirmed-by: pieces_in_new_powers
:figure: piece_of_a_cubic

The second expression gives the four rows names.  On the left $P(t^*)$ is the point of the curve at $t_0+(t_1-t_0)t^*$, the letter being kept.
:::

:::{claim} coefficients_of_a_piece_are_as_printed
:title: The four rows are the coefficients of the piece of a cubic
:zh: 三次曲线段的四个系数
:given: any $A,B,C,D$ of space, any $t_0$, $t_1$ and $u$
:then: $u^3$, $u^2$, $u$, $1$ times the four printed rows have the sum $P(t_0+(t_1-t_0)u)$; and the rows are the coefficients by the kernel
:method: The sum of the rows against $P$, and each row, everything a variable.
:degrees: 3..3
:over: x# y# z#: coefficients; r s u: parameter value
:control: the factor 2 in the place of the 3 of the second row
:::
*/
CLAIM(coefficients_of_a_piece_are_as_printed)
{
    num c[4 * space], piece[4 * space], t0 = parameter(T, "r"), t1 = parameter(T, "s"), h = sub(t1, t0);
    num u = parameter(T, "u"), t = add(t0, mul(h, u));
    G(free_points)(T, 3, space, c);
    G(power_on_interval)(3, space, c, t0, t1, piece);
    num three = from_int(3), h2 = mul(h, h), h3 = mul(h2, h), t2 = mul(t0, t0), t3 = mul(t2, t0);
    for (int j = 0; j < space; j++) {
        num D = c[j], C = c[space + j], B = c[2 * space + j], A = c[3 * space + j];
        num linear = add(add(mul(mul(three, mul(h, t2)), A), mul(mul(from_int(2), mul(h, t0)), B)), mul(h, C));
        num rows[4] = {add(add(mul(t3, A), mul(t2, B)), add(mul(t0, C), D)), linear,
                       add(mul(mul(fault(T, three, from_int(2)), mul(h2, t0)), A), mul(h2, B)), mul(h3, A)};
        about(T, "P(t) and the sum of the printed rows");
        same(T, G(power_sum)(3, 1, rows, 0, u), G(power_sum)(3, space, c, j, t));
        about(T, "a row and the coefficient by the kernel");
        for (int k = 0; k <= 3; k++)
            same(T, piece[k * space + j], rows[k]);
    }
}

/*
While the new parameter runs from 0 to 1, the old one runs through the length $t_1-t_0$ only, so each derivative brings
one such factor.  That is why tangent vectors cannot be carried over from a curve to its piece: their directions stay,
their lengths do not.

:::{statement} hu-1987:1-5-6
:title: The derivatives in the new parameter
:zh: 新参数下的导矢
:printed: \frac{dP}{dt^*}=(t_1-t_0)\frac{dP}{dt},\qquad\frac{d^2P}{dt^{*2}}=(t_1-t_0)^2\frac{d^2P}{dt^2}
:holds-by: derivatives_of_a_piece
:figure: piece_of_a_cubic
:::

:::{claim} derivatives_of_a_piece
:title: The k-th derivative of a piece has the k-th power of the length of its interval
:zh: 曲线段的各阶导矢
:given: any coefficients of degree 3 in space, any $t_0$, $t_1$ and $u$, $k=0,1,2,3$
:then: the $k$-th derivative of the piece at $u$ is $(t_1-t_0)^kP^{(k)}(t_0+(t_1-t_0)u)$; the square of the length of the first one is
  $(t_1-t_0)^2|P'|^2$
:method: Both derivatives by the definition, everything a variable.
:degrees: 3..3
:over: x# y# z#: coefficients; r s u: parameter value
:control: the first power for every $k$
:::
*/
CLAIM(derivatives_of_a_piece)
{
    num c[4 * space], piece[4 * space], t0 = parameter(T, "r"), t1 = parameter(T, "s"), u = parameter(T, "u");
    num h = sub(t1, t0), t = add(t0, mul(h, u)), speed = from_int(0), before = from_int(0);
    G(free_points)(T, 3, space, c);
    G(power_on_interval)(3, space, c, t0, t1, piece);
    for (int j = 0; j < space; j++)
        for (int k = 0; k <= 3; k++) {
            num there = G(power_sum_derivative)(3, space, c, j, k, t),
                here = G(power_sum_derivative)(3, space, piece, j, k, u);
            /* d^k P/du^k = (t_1 - t_0)^k d^k P/dt^k */
            same(T, here, mul(G(power)(h, fault(T, k, k > 0 ? 1 : k)), there));
            if (k == 1) {
                speed = add(speed, mul(here, here));
                before = add(before, mul(there, there));
            }
        }
    same(T, speed, mul(mul(h, h), before));
}

/*
:::{statement} hu-1987:1-5-range
:title: The length of the interval of a piece
:zh: 参数区间长度的范围
:printed: 0\le(t_1-t_0)\le1
:holds-by: length_of_a_piece_is_at_most_one
:needs: backward_piece_has_negative_length | the words before (1-5-4), the piece from $t_0$ to $t_1$ | $t_0\le t_1$: otherwise the piece is taken backward.
:needs: piece_beyond_the_curve_is_longer | the words before (1-5-4), a piece of the curve with $t\in[0,1]$ | $t_0$ and $t_1$ are in $[0,1]$: otherwise it is
  no piece of the curve that is taken.
:figure: piece_of_a_cubic
:::

:::{claim} length_of_a_piece_is_at_most_one
:title: The interval of a piece out of the unit interval is no longer than 1
:zh: 区间长度不超过一
:given: $0\le t_0\le t_1\le1$ as $t_0=a$, $t_1=a+b$, $1=a+b+c$ in units of $a+b+c$; $a,b,c\ge0$, not all 0
:then: $t_1-t_0\ge0$ and $1-(t_1-t_0)\ge0$
:method: Both have no negative coefficient in $a,b,c$; every pair of parameters with $t_0\le t_1$ is of this form, $a$, $b$, $c$ being the lengths of the three
  parts of $[0,1]$, of which any may be 0.
:scope: any two parameters
:where: $t_0\le t_1$; $t_0$ and $t_1$ are in $[0,1]$
:harmless: $a,b,c\ge0$, not all 0 | it is $0\le t_0\le t_1\le1$
:over: a b c: -
:control: $t_0-t_1$
:::
*/
CLAIM(length_of_a_piece_is_at_most_one)
{
    num a = positive(T, "a", 0), b = positive(T, "b", 0), rest = positive(T, "c", 0);
    num whole_length = add(a, add(b, rest));
    num t0 = div(a, whole_length), t1 = div(add(a, b), whole_length), length = fault(T, sub(t1, t0), sub(t0, t1));
    nonnegative(T, length);
    nonnegative(T, sub(from_int(1), length));
}

#if RATIONAL
/*
:::{claim} backward_piece_has_negative_length
:title: A piece taken backward has a negative factor
:zh: 反向截取
:kind: counterexample
:given: two parameters of $[0,1]$, the later one first
:data: t_0 = 3/4; t_1 = 1/4
:instead: t_0 = 1/4; t_1 = 3/4
:then: $t_1-t_0$ is negative, so that it is neither a length nor a quotient of lengths
:result: t_1 - t_0 = -1/2
:method: The number, exactly.
:control: $t_0$ and $t_1$ exchanged
:::
*/
CLAIM(backward_piece_has_negative_length)
{
    num t0 = given(T, "t_0"), t1 = given(T, "t_1"), length = sub(t1, t0);
    found(T, "t_1 - t_0", length);
    about(T, "t_1 - t_0, which should not be negative");
    nonnegative(T, length);
}

/*
:::{claim} piece_beyond_the_curve_is_longer
:title: What goes on beyond an end of the curve may be longer than 1
:zh: 超出参数区间的一段
:kind: counterexample
:given: two pairs of parameters $t_0<t_1$: $t_0$ of $[0,1]$ and $t_1$ not, and $t_1$ of $[0,1]$ and $t_0$ not
:data: t_0 = 1/4 -1/2; t_1 = 3/2 3/4
:instead: t_0 = 1/4 0; t_1 = 1 3/4
:then: $t_1-t_0$ is more than 1 for both
:result: t_1 - t_0 = 5/4 5/4
:method: The numbers, exactly; that one of them is at most 1 is refuted.
:control: the parameters that are not of $[0,1]$ moved to the end of the curve
:::
*/
CLAIM(piece_beyond_the_curve_is_longer)
{
    num t0[2], t1[2], length[2];
    given_points(T, "t_0", 2, 1, t0);
    given_points(T, "t_1", 2, 1, t1);
    for (int k = 0; k < 2; k++)
        length[k] = sub(t1[k], t0[k]);
    found_points(T, "t_1 - t_0", 2, 1, length);
    about(T, "whether one of the two differences is at most 1");
    refute(T, compare_q(length[0], from_int(1)) > 0 && compare_q(length[1], from_int(1)) > 0);
}
#endif

/*
:::{statement} hu-1987:1-5-tangent-length
:title: The tangents are multiplied by the length of the interval
:zh: 切矢长度的变化
:printed: The length of the tangent vector is $(t_1-t_0)$ times that of the original curve with the parameter $t$.
:holds-by: derivatives_of_a_piece
:needs: backward_piece_has_negative_length | the range printed before it, $0\le(t_1-t_0)\le1$ | $t_0\le t_1$: otherwise $(t_1-t_0)$ times a length
  that is not 0 is negative, and no length is.
:figure: piece_of_a_cubic
:::

## A rational change of the parameter

A linear change of the parameter leaves the degree alone, and nothing to choose once the ends are fixed.
One number of freedom is gained by a quotient of linear functions (双线性变换): the ends stay, and the points crowd towards
one of them.  The price is that the curve becomes a rational one, whose weights are products of powers of two numbers.

:::{statement} hu-1987:1-5-rational-change
:title: The parameter can be changed by a fractional linear map
:zh: 双线性(同形)参数变换
:printed: More generally the parameter can be changed by, for example, a bilinear or homographic transformation, a rational one, as in the formula
  that follows.
:holds-by: fractional_linear_change_makes_a_rational_curve
:confirmed-by: bernstein_sum_of_powers_is_a_power change_of_parameter_acts_on_one_factor fractional_change_of_a_power_curve
  fractional_change_keeps_curve
:hypothesis: fractional_change_with_a_pole | the denominator has no zero on the interval: where it is 0, no $t$ belongs to the new parameter.
:figure: fractional_parameter

That the change is not constant is no further hypothesis: it belongs to the meaning of such a transformation.

The text that is at hand ends before the formula, beside which the hypothesis may stand.
:::

:::{claim} fractional_linear_change_makes_a_rational_curve
:title: Any fractional linear change makes a polynomial curve rational, and takes different parameters to different ones, in every degree
:zh: 一般分式线性参数变换(任意次数)
:given: $t=\frac{pu+q}{ru+s}$, $w=ru+s$; a sum $\sum_{k\le n}c_kt^k$ of some terms, which is $\frac N{w^n}$, one more coefficient $c$, and $V=(pu+q)^{n+1}$; and two
  parameters $u_0$, $u_1$
:where: the change is not constant
:then: with the term $c\,t^{n+1}$ the sum is $\frac{Nw+cV}{w^{n+1}}$: so, from $c_0$ on, $P(t)$ is a polynomial in $u$ over a power of $w$; and
  $t_1-t_0=\frac{(ps-qr)(u_1-u_0)}{w_0w_1}$, so that where $w$ has no zero on the interval and $ps\ne qr$ the new parameter runs through the old one
  once and never back
:method: Identities with everything a variable; by induction for any number of terms.
:degrees: all
:over: p q r s: fractional linear change; N# c#: coefficients; w V: -; u#: parameter values
:control: $ps+qr$
:::
*/
CLAIM(fractional_linear_change_makes_a_rational_curve)
{
    num p = unknown(T, "p", 0), q = unknown(T, "q", 0), r = unknown(T, "r", 0), s = unknown(T, "s", 0);
    num N = unknown(T, "N", 0), c = unknown(T, "c", 0), V = unknown(T, "V", 0), before = unknown(T, "w", 0); /* w^n */
    num u[2], t[2], w[2];
    for (int k = 0; k < 2; k++) {
        u[k] = unknown(T, "u", k);
        w[k] = add(mul(r, u[k]), s);
        t[k] = div(add(mul(p, u[k]), q), w[k]);
    }
    num power = mul(before, w[0]), sum = add(div(N, before), mul(c, div(V, power)));
    about(T, "one term more");
    same(T, mul(sum, power), add(mul(N, w[0]), mul(c, V)));
    num ps = mul(p, s), qr = mul(q, r), determinant = fault(T, sub(ps, qr), add(ps, qr));
    about(T, "the difference of two values");
    same(T, sub(t[1], t[0]), div(mul(determinant, sub(u[1], u[0])), mul(w[0], w[1])));
}

/*

:::{claim} fractional_change_of_a_power_curve
:title: A fractional change of the parameter makes the curve rational and keeps its points
:zh: 分式线性变换下的曲线
:given: any coefficients of degree $n$ in the plane, $t=\frac{pu}{pu+q(1-u)}$ with $p,q>0$
:where: $p,q>0$
:then: the rational Bézier curve with the Bézier points of $P$ and the weights $p^iq^{n-i}$ is $P(t)$ at $u$; the derivatives of $t$ at the
  ends, $\frac pq$ and $\frac qp$, have the product 1
:method: The Bézier points by `bernstein_from_power`, the curve by the rational kernel, the weights by `rational_reparametrize`, against
  the sum of powers; the derivatives as limits of quotients, $\frac{t}{u}$ at 0 and $\frac{1-t}{1-u}$ at 1, which are
  $\frac p{pu+q(1-u)}$ and $\frac q{pu+q(1-u)}$.
:degrees: 1..6 sampled 8
:over: x# y#: coefficients; p; q; u
:control: the weights $p^{n-i}q^i$
:::
*/
CLAIM(fractional_change_of_a_power_curve)
{
    int n = T->degree;
    num c[(MAX_DEGREE + 1) * dim], line[MAX_DEGREE + 1], R[(MAX_DEGREE + 1) * dim], w[MAX_DEGREE + 1], P[dim];
    num p = positive(T, "p", 0), q = positive(T, "q", 0), u = parameter(T, "u"), one = from_int(1);
    num below = add(mul(p, u), mul(q, sub(one, u))), t = div(mul(p, u), below);
    G(free_points)(T, n, dim, c);
    for (int j = 0; j < dim; j++) {
        for (int k = 0; k <= n; k++)
            line[k] = c[k * dim + j];
        G(bernstein_from_power)(n, line, line);
        for (int k = 0; k <= n; k++)
            R[k * dim + j] = line[k];
    }
    for (int k = 0; k <= n; k++)
        w[k] = one;
    G(rational_reparametrize)(n, w, fault(T, p, q), fault(T, q, p), w);
    G(rational_point)(n, dim, R, w, u, P);
    for (int j = 0; j < dim; j++)
        same(T, P[j], G(power_sum)(n, dim, c, j, t));
    about(T, "the speeds at the ends");
    same(T, div(t, u), div(p, below));
    same(T, div(sub(one, t), sub(one, u)), div(q, below));
}

#if RATIONAL
/*
:::{claim} fractional_change_with_a_pole
:title: With factors of different signs the parameter has a pole
:zh: 异号时参数变换有极点
:kind: counterexample
:given: the change $t=\frac{pu}{pu+q(1-u)}$ with factors $p$ and $q$ of different signs, and a parameter $u$ of $(0,1)$
:data: p = 1; q = -1; u = 1/2
:instead: q = 1
:then: the denominator $pu+q(1-u)$ vanishes
:result: p u + q (1 - u) = 0
:method: The denominator, exactly; that it is not 0 is refuted.
:control: $p=q$
:::
*/
CLAIM(fractional_change_with_a_pole)
{
    num p = given(T, "p"), q = given(T, "q"), u = given(T, "u");
    num below = add(mul(p, u), mul(q, sub(from_int(1), u)));
    found(T, "p u + q (1 - u)", below);
    about(T, "whether the denominator is not zero");
    refute(T, is_zero_q(below));
}
#endif

#include "chapters/judge/claims_off.h"
