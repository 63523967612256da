/*
# From two curves of one point less (递推与曲线的绘制)

The slides draw a curve in two ways: by many of its points, joined by segments, and by the recursion that makes a curve of
$n+1$ points from two of $n$ points each.  The recursion is de Casteljau's; its levels are the subject of another section of this
chapter.  Here are the sentences of the slides, and their proof line by line.
*/
#include "chapters/bezier/definition.h"

#if RATIONAL
#include "exact/record/sign.h"
#endif

#include "chapters/judge/claims_on.h"

enum { dim = 2 };

/*
## Many points

:::{statement} slides-ch4:4-polyline
:title: With more points the polyline can come as near to the curve as one likes
:zh: 折线逼近曲线
:printed: To draw the curve by its definition, enough values of $t$ are chosen, and the points of the curve joined by segments; with more points
  the polyline and the curve can come arbitrarily near to each other.
:holds-by: differences_over_a_part_are_means polygon_and_curve_are_near_the_chord bernstein_recurrence
  recurrence_keeps_sum_sign_ends_and_symmetry bernstein_raised_by_one_degree enough_equal_steps_bring_the_polyline_near
:confirmed-by: second_differences_of_a_piece linear_precision
:meant: the word "can" (可以) | More and more points can be chosen so that the polyline comes near: with steps that tend to 0.
:reading: enough_equal_steps_bring_the_polyline_near | they can be so chosen: enough of them, in equal steps
:reading-with: bernstein_raised_by_one_degree bernstein_recurrence differences_over_a_part_are_means polygon_and_curve_are_near_the_chord
  recurrence_keeps_sum_sign_ends_and_symmetry
:reading: many_points_may_crowd | however they are chosen: many points are not enough
:figure: crowded_points

A piece over a step $h$ of the parameter is at most $\frac{n^2}8h^2\max_j|\Delta^2P_j|$ away from its chord.
:::

A chord is as far from its piece of the curve as the second differences of the piece allow, and these shrink with the square of the
step.  So many points are enough if the steps tend to 0.  To have many points is not enough: on the parabola that follows
they are in the wrong place.

:::{claim} second_differences_of_a_piece
:title: The second differences of a piece shrink with the square of its length
:zh: 曲线段的二阶差分与区间长度平方成正比
:given: numbers $b_0,\dots,b_n$, any $u$ and $v$; $c_0,\dots,c_n$ the points of the piece over $[u,v]$
:then: $\Delta^2c_i=(v-u)^2\,d_i$ where $d_i$ is the value at $n-2-i$ arguments $u$ and $i$ arguments $v$ of the blossom of the $n-1$ numbers
  $\Delta^2b_j$: for $u,v$ in $[0,1]$ an average of these
:method: The piece by `bezier_on_interval`, the blossom by its sum over subsets of arguments, everything a variable.
:degrees: 2..6 sampled 9
:over: x#: coefficients; u v: parameter value
:control: the first power of $v-u$
:::
*/
CLAIM(second_differences_of_a_piece)
{
    int n = T->degree, m = n - 2;
    num b[MAX_DEGREE + 1], c[MAX_DEGREE + 1], D[MAX_DEGREE + 1];
    num u = parameter(T, "u"), v = parameter(T, "v"), one = from_int(1), step = sub(v, u);
    G(free_points)(T, n, 1, b);
    G(bezier_on_interval)(n, 1, b, u, v, c);
    for (int j = 0; j <= m; j++)
        D[j] = G(difference)(1, b, 0, j, 2);
    for (int i = 0; i <= m; i++) {
        num average = from_int(0);
        for (int S = 0; S < 1 << m; S++) {
            num product = one;
            int size = 0;
            for (int k = 0; k < m; k++) {
                num x = k < i ? v : u;
                product = mul(product, S >> k & 1 ? x : sub(one, x));
                size += S >> k & 1;
            }
            average = add(average, mul(product, D[size]));
        }
        /* Delta^2 c_i = (v-u)^2 d_i */
        same(T, G(difference)(1, c, 0, i, 2), mul(fault(T, mul(step, step), step), average));
    }
}

/*
:::{claim} enough_equal_steps_bring_the_polyline_near
:title: With enough equal steps the distance of curve and polyline is as small as one likes
:zh: 等步长步数足够多时折线任意接近曲线
:given: the degree $n\ge1$, the length $M\ge0$ of the longest second difference of the points, 0 for $n=1$, where there is none, $\varepsilon>0$, and $N$ steps of one length with
  $N^2=\frac{n^2M}{8\varepsilon}+p$, $p>0$
:harmless: $\varepsilon>0$ | the distance that one likes
:then: $\varepsilon-\frac{n^2}8\cdot\frac M{N^2}=\frac{p\,\varepsilon}{N^2}>0$, where the second number is a bound of the distance
:method: An identity, everything a variable, once with $M>0$ and once with $M=0$.  Over a step of the length $\frac1N$ the second differences are means of those of the points, divided by $N^2$,
  `differences_over_a_part_are_means`, and the piece is at most $\frac{n^2}8$ times the longest of them away from its chord,
  `polygon_and_curve_are_near_the_chord`.  There $\sum_kB_k^n=1$ and $\sum_k\frac knB_k^n=t$ are used, which follow from `bernstein_recurrence` by
  `recurrence_keeps_sum_sign_ends_and_symmetry`, and from this and $\frac knB_k^n=tB_{k-1}^{n-1}$, in `bernstein_raised_by_one_degree`.
:degrees: all from 1
:over: n M e p: -
:control: $\frac{n^2}4$ in the place of $\frac{n^2}8$
:::
*/
CLAIM(enough_equal_steps_bring_the_polyline_near)
{
    num n = whole(T, "n", 1, 20), epsilon = positive(T, "e", 0), p = positive(T, "p", 0);
    num longest[2] = {positive(T, "M", 0), from_int(0)};
    for (int k = 0; k < 2; k++) {
        num above = mul(mul(n, n), longest[k]), steps = add(div(above, mul(from_int(8), epsilon)), p); /* N² */
        num bound = div(above, mul(from_int(fault(T, 8, 4)), steps)), left = div(mul(p, epsilon), steps);
        same(T, sub(epsilon, bound), left);
        G(must_be_positive)(T, left);
    }
}

#if RATIONAL
/*
:::{claim} many_points_may_crowd
:title: Points that crowd at one end leave a chord where it was
:zh: 点数增多而折线不收敛
:kind: counterexample
:data: R = (0,0) (1/2,0) (1,1); a = 1/2; ε = 1/100
:instead: a = 999/1000
:result: t = 3/4; δ = 1/16
:given: the parabola $(t,t^2)$, whose points are $R$, and a polyline through its points at $t=0$ and $t=2^{-k}$ for as many $k=0,1,2,\dots$
  as one likes; its last chord begins at the parameter $a$ and ends at 1; $\varepsilon$, the distance that one likes
:then: that chord stays where it is, however many points there are, and half way between its ends, at $t$, it lies above the curve by $\delta$; no
  point of the whole curve is within $\varepsilon$ of the middle of the chord
:method: The point of the curve and that of the chord; then the square of the distance of the middle of the chord from the curve, less $\varepsilon^2$, a
  polynomial whose sign on $[0,1]$ is found by root counts.  That it is not positive somewhere is refuted.
:control: the last chord of a thousand equal steps
:::
*/
CLAIM(many_points_may_crowd)
{
    num R[3 * dim], P[3][dim], one = from_int(1), half = from_ratio(1, 2);
    given_points(T, "R", 3, dim, R);
    num a = given(T, "a"), most = given(T, "ε"), t = mul(half, add(a, one));
    G(bezier_casteljau)(2, dim, R, a, P[0]);
    G(bezier_casteljau)(2, dim, R, one, P[1]);
    G(bezier_casteljau)(2, dim, R, t, P[2]);
    poly beyond = poly_constant(neg(mul(most, most))); /* |P(s) - middle|² - ε² */
    num middle[dim];
    for (int c = 0; c < dim; c++) {
        middle[c] = mul(half, add(P[0][c], P[1][c]));
        poly gone =
            poly_sub(poly_from_bernstein(2, (num[]){R[c], R[dim + c], R[2 * dim + c]}), poly_constant(middle[c]));
        beyond = poly_add(beyond, poly_mul(gone, gone));
    }
    found(T, "t", t);
    found(T, "δ", sub(middle[1], P[2][1]));
    about(T, "whether a point of the curve is within ε of the middle of the chord");
    refute(T, sign_on(beyond, from_int(0), one, CLOSED) == SIGN_POSITIVE);
}
#endif

/*
## The recursion

:::{statement} slides-ch4:4-recursion-notation
:title: What P_k,l is
:zh: P_{k,l}(t) 的定义
:printed: $P_{k,l}(t)$, $0\le t\le1$, is the Bézier curve of the points $P_k,P_{k+1},\dots,P_{k+l}$; then $P_{0,n}(t)=(1-t)P_{0,n-1}(t)+tP_{1,n}(t)$
:refuted-by: one_point_too_many_breaks_the_recursion
:class: misprint
:corrected: $P_{k,l}$ is the curve of $P_k,P_{k+1},\dots,P_l$; with it the recursion is true.
:corrected-by: bernstein_recurrence
:confirmed-by: curve_blends_two_curves_of_one_point_less
:figure: two_curves_of_one_point_less

With the last index as it is in the text at hand, $P_{1,n}$ in the recursion would use a point $P_{n+1}$, which there is not; the example has
one point more, and then the recursion is false.  Or the definition is kept, and the recursion has $P_{1,n-1}$; but $P_{1,n}$ is printed in both of its forms.
:::

:::{statement} slides-ch4:4-recursion
:title: The recursion
:zh: Bézier 曲线的递推关系
:printed: P_{0,n}(t)=(1-t)P_{0,n-1}(t)+tP_{1,n}(t)
:holds-by: bernstein_recurrence
:confirmed-by: curve_blends_two_curves_of_one_point_less
:meant: $P_{1,n}$, which would use a point $P_{n+1}$ that there is not | $P_{k,l}$ is the curve of $P_k,\dots,P_l$, as `slides-ch4:4-recursion-notation` is corrected.
:figure: two_curves_of_one_point_less

The two sides are sums over the points; the coefficients of each point on both sides are those of the recurrence of the
Bernstein polynomials.
:::

:::{statement} slides-ch4:4-recursion-difference
:title: The recursion with one product
:zh: 递推关系的另一形式
:printed: P_{0,n}(t)=P_{0,n-1}(t)+t\bigl(P_{1,n}(t)-P_{0,n-1}(t)\bigr)
:holds-by: bernstein_recurrence
:confirmed-by: curve_blends_two_curves_of_one_point_less
:meant: $P_{1,n}$, which would use a point $P_{n+1}$ that there is not | $P_{k,l}$ is the curve of $P_k,\dots,P_l$, as `slides-ch4:4-recursion-notation` is corrected.
:figure: two_curves_of_one_point_less

It is `slides-ch4:4-recursion` with $(1-t)P+tQ=P+t(Q-P)$.
:::

:::{claim} curve_blends_two_curves_of_one_point_less
:title: The point of a curve divides the segment between those of two curves of one point less in the ratio t : (1-t)
:zh: n 次曲线由两条 n-1 次曲线线性组合
:given: points $P_0,\dots,P_n$ of the plane, any $t$, all $0\le k<l\le n$
:then: $P_{k,l}=(1-t)P_{k,l-1}+tP_{k+1,l}=P_{k,l-1}+t(P_{k+1,l}-P_{k,l-1})$, $P_{k,l}$ being the curve of $P_k,\dots,P_l$
:method: The three curves from the definition, everything a variable.
:degrees: 1..6 sampled 10
:control: $t$ and $1-t$ exchanged
:::
*/
CLAIM(curve_blends_two_curves_of_one_point_less)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * dim], t = parameter(T, "t"), s = sub(from_int(1), t);
    G(free_points)(T, n, dim, b);
    for (int k = 0; k < n; k++)
        for (int l = k + 1; l <= n; l++)
            for (int c = 0; c < dim; c++) {
                num P = G(curve)(l - k, dim, b + k * dim, c, t), near = G(curve)(l - 1 - k, dim, b + k * dim, c, t);
                num far = G(curve)(l - 1 - k, dim, b + (k + 1) * dim, c, t), share = fault(T, t, s);
                about(T, "with two products"); /* (1-t) P_{k,l-1} + t P_{k+1,l} */
                same(T, add(mul(sub(from_int(1), share), near), mul(share, far)), P);
                about(T, "with one product"); /* P_{k,l-1} + t (P_{k+1,l} - P_{k,l-1}) */
                same(T, add(near, mul(share, sub(far, near))), P);
            }
}

#if RATIONAL
/*
:::{claim} one_point_too_many_breaks_the_recursion
:title: With one point more the recursion is false
:zh: 多取一点则递推不成立
:kind: counterexample
:data: P = 0 1 5; t = 1/2; points of P_1,1 = 2
:instead: points of P_1,1 = 1
:result: P_0,1(t) = 1/2; right side = 3/2
:given: the points $P$ of a line, a parameter $t$; $n=1$, and $P_{1,1}$ as the curve of the two points $P_1,P_2$
:then: $P_{0,1}(t)$ is not $(1-t)P_{0,0}(t)+tP_{1,1}(t)$
:method: The curves by the kernel.
:control: $P_{1,1}$ as the curve of $P_1$ alone
:::
*/
CLAIM(one_point_too_many_breaks_the_recursion)
{
    num P[3], curve, far;
    given_points(T, "P", 3, 1, P);
    num t = given(T, "t"), s = sub(from_int(1), t);
    G(bezier_casteljau)(1, 1, P, t, &curve);
    G(bezier_casteljau)(given_whole(T, "points of P_1,1") - 1, 1, P + 1, t, &far);
    num blend = add(mul(s, P[0]), mul(t, far)); /* (1-t) P_{0,0} + t P_{1,1} */
    found(T, "P_0,1(t)", curve);
    found(T, "right side", blend);
    about(T, "P_{0,1} and the right side");
    same(T, curve, blend);
}
#endif

/*
The slides prove the recursion by comparing coefficients.  The only thing they need to know about binomial coefficients is Pascal's rule;
everything else is a shift of an index.

:::{statement} slides-ch4:4-recursion-pascal
:title: The sum of two binomial coefficients
:zh: 组合恒等式
:printed: C_n^i=C_{n-1}^i+C_{n-1}^{i-1}
:holds-by: binomials_add_up

In the proof it is used for $1\le i\le n-1$.  For $i=0$ and $i=n$ it is true with $C_{n-1}^{-1}=C_{n-1}^n=0$.
:::

:::{claim} binomials_add_up
:title: Pascal's rule
:zh: Pascal 恒等式
:given: integers $1\le i\le n$
:let: $c=\binom{n-1}{i-1}$, so that $\binom{n-1}i=c\frac{n-i}i$ and $\binom ni=c\frac ni$
:then: $\binom ni=\binom{n-1}i+\binom{n-1}{i-1}$; for $i=0$ it says $1=1+0$
:method: With $i$, $n-i$ and $c$ variables both sides are one element of the field; for $i=n$ the factor $n-i$ makes $\binom{n-1}n=0$.
:degrees: all from 1
:over: i n_minus_i c: i
:control: $\binom{n-1}i$ taken as $c\frac{n-i}{i+1}$
:::
*/
CLAIM(binomials_add_up)
{
    num i = whole(T, "i", 1, 20), rest = whole(T, "n_minus_i", 0, 20), c = parameter(T, "c");
    num stays = mul(c, div(rest, fault(T, i, add(i, from_int(1)))));
    same(T, mul(c, div(add(i, rest), i)), add(stays, c));
}

/*
:::{claim} each_point_has_one_coefficient_in_every_line
:title: Each point has one coefficient in every line of the proof
:zh: 证明各行中同一控制顶点的系数相同
:given: an integer $n\ge1$, any $t$; integers $1\le i\le n-1$, where there are such
:let: $c=\binom{n-1}{i-1}$, so that $\binom{n-1}i=c\frac{n-i}i$ and $\binom ni=c\frac ni$; $U=(1-t)^{n-1-i}$, $V=t^{i-1}$; $X=(1-t)^{n-1}$,
  $Y=t^{n-1}$
:then: the coefficient of $P_i$ is $(1-t)\binom{n-1}it^i(1-t)^{n-1-i}+t\binom{n-1}{i-1}t^{i-1}(1-t)^{n-i}$ in the last two expressions of the proof, the one with brackets and the one behind it,
  $\bigl(\binom{n-1}i+\binom{n-1}{i-1}\bigr)t^i(1-t)^{n-i}$ in the two before them, $\binom nit^i(1-t)^{n-i}$ in the first, and these are one; those of $P_0$ and $P_n$ are $(1-t)(1-t)^{n-1}$ and $t\,t^{n-1}$ in the last two
  expressions and $(1-t)^n$ and $t^n$ in the others, and these are one as well
:method: With $i$, $n-i$, $t$, $c$, $U$, $V$, $X$, $Y$ variables; $(1-t)^n$ is $X$ once more multiplied by $1-t$, and $t^n$ is $Y$ multiplied by $t$.  For
  $n=1$ there are no other points than these two.
:degrees: all from 1
:over: i n_minus_i c: i; t U V X Y: t
:control: $t^i$ in the place of $t^{i-1}$ in the second product
:::
*/
CLAIM(each_point_has_one_coefficient_in_every_line)
{
    num i = whole(T, "i", 1, 20), rest = whole(T, "n_minus_i", 1, 20), t = parameter(T, "t"), s = sub(from_int(1), t);
    num c = parameter(T, "c"), U = parameter(T, "U"), V = parameter(T, "V"), C = mul(c, div(rest, i));
    num near = mul(s, mul(C, mul(mul(t, V), U))), far = mul(t, mul(c, mul(fault(T, V, mul(t, V)), mul(s, U))));
    num powers = mul(mul(t, V), mul(s, U)); /* t^i (1-t)^{n-i} */
    about(T, "the last two expressions and those before");
    same(T, add(near, far), mul(add(C, c), powers));
    about(T, "the middle of the chain and its beginning");
    same(T, mul(add(C, c), powers), mul(mul(c, div(add(i, rest), i)), powers));
    num X = parameter(T, "X"), Y = parameter(T, "Y");
    about(T, "the first point and the last");
    same(T, mul(s, X), mul(X, s));
    same(T, mul(t, Y), mul(Y, t));
}

/*
:::{statement} slides-ch4:4-recursion-proof
:title: The proof of the recursion
:zh: 递推关系的证明
:printed: the left side is $\sum_{i=0}^nC_n^it^i(1-t)^{n-i}P_i$
  $=(1-t)^nP_0+\sum_{i=1}^{n-1}(C_{n-1}^i+C_{n-1}^{i-1})t^i(1-t)^{n-i}P_i+t^nP_n$
  $=(1-t)^nP_0+\sum_{i=1}^{n-1}C_{n-1}^it^i(1-t)^{n-i}P_i+\sum_{i=1}^{n-1}C_{n-1}^{i-1}t^i(1-t)^{n-i}P_i+t^nP_n$ $=\dots$
  $=(1-t)\sum_{i=0}^{n-1}C_{n-1}^it^i(1-t)^{n-1-i}P_i+t\sum_{i=0}^{n-1}C_{n-1}^it^i(1-t)^{n-1-i}P_{i+1}$, the right side
:holds-by: each_point_has_one_coefficient_in_every_line binomials_add_up
:confirmed-by: proof_of_the_recursion_line_by_line
:figure: two_curves_of_one_point_less

In the place of the dots stands another line, `slides-ch4:4-recursion-proof-line-2`.  For $n=1$ the sums from 1 to $n-1$ are empty.
:::

:::{claim} proof_of_the_recursion_line_by_line
:title: All lines of the proof are the curve
:zh: 证明的每一步均成立
:given: numbers $P_0,\dots,P_n$, any $t$
:then: each of the five expressions is $P_{0,n}(t)$
:method: Each expression as printed, against the definition, everything a variable.
:degrees: 1..6 sampled 10
:over: x#: points
:control: $t^i$ in the place of $t^{i-1}$ in the second sum of the line with brackets; for $n=1$, where there is none, the last point left out
:::
*/
CLAIM(proof_of_the_recursion_line_by_line)
{
    int n = T->degree;
    num P[MAX_DEGREE + 1], t = parameter(T, "t"), s = sub(from_int(1), t), zero = from_int(0);
    G(free_points)(T, n, 1, P);
    num near = zero, far = zero, low = zero, high = zero, both[2] = {zero, zero}, joined = zero;
    for (int i = 0; i < n; i++) {
        num B = mul(G(choose)(n - 1, i), mul(G(power)(t, i), G(power)(s, n - 1 - i)));
        near = add(near, mul(B, P[i]));
        far = add(far, mul(B, P[i + 1]));
    }
    for (int i = 1; i < n; i++) {
        num C = G(choose)(n - 1, i), C1 = G(choose)(n - 1, i - 1),
            whole_power = mul(G(power)(t, i), G(power)(s, n - i));
        low = add(low, mul(mul(C, mul(G(power)(t, i), G(power)(s, n - 1 - i))), P[i]));
        high = add(high, mul(mul(C1, mul(G(power)(t, fault(T, i - 1, i)), G(power)(s, n - i))), P[i]));
        both[0] = add(both[0], mul(mul(C, whole_power), P[i]));
        both[1] = add(both[1], mul(mul(C1, whole_power), P[i]));
        joined = add(joined, mul(mul(add(C, C1), whole_power), P[i]));
    }
    num last = fault(T, P[n], n == 1 ? zero : P[n]), left = G(curve)(n, 1, P, 0, t);
    num first_power = mul(G(power)(s, n), P[0]), last_power = mul(G(power)(t, n), P[n]);
    about(T, "the right side"); /* (1-t) P_{0,n-1} + t P_{1,n} */
    same(T, add(mul(s, near), mul(t, far)), left);
    about(T, "the line with brackets");
    num second = mul(s, add(mul(G(power)(s, n - 1), P[0]), low));
    same(T, add(second, mul(t, add(high, mul(G(power)(t, n - 1), last)))), left);
    about(T, "the line with two sums");
    same(T, add(add(first_power, both[0]), add(both[1], last_power)), left);
    about(T, "the line with one sum");
    same(T, add(add(first_power, joined), last_power), left);
    num sum = zero;
    for (int i = 0; i <= n; i++)
        sum = add(sum, mul(mul(G(choose)(n, i), mul(G(power)(t, i), G(power)(s, n - i))), P[i]));
    about(T, "the left side");
    same(T, sum, left);
}

/*
Whoever checks such a line by eye counts exponents: in every term of degree $n$ those of $t$ and of $1-t$ have the sum $n$, within
a bracket that is multiplied by $t$ or by $1-t$ the sum $n-1$.

:::{statement} slides-ch4:4-recursion-proof-line-2
:title: The line of the proof in which 1-t and t stand before brackets
:zh: 证明中提取公因子的一行
:printed: in the proof of the recursion, the line before the last:
  $\dots=(1-t)\Bigl((1-t)^{n-1}P_0+\sum_{i=1}^{n-1}C_{n-1}^it^i(1-t)^{n-1-i}P_i\Bigr)+t\Bigl(\sum_{i=1}^{n-1}C_{n-1}^{i-1}t^{i-1}(1-t)^{n-i}P_i+t^{n-1}P_n\Bigr)$
:holds-by: each_point_has_one_coefficient_in_every_line
:confirmed-by: proof_of_the_recursion_line_by_line
:figure: two_curves_of_one_point_less

In the text at hand the exponent of $1-t$ consists of $n$, $i$ and 1 in the first sum and of $n$ and
$i$ in the second, whose power of $t$ has the 1; the minus signs between them are not there.  The other lines are in `slides-ch4:4-recursion-proof`.
:::
*/

#include "chapters/judge/claims_off.h"
