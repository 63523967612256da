/*
# A curve and its polygon (Bézier 曲线及其性质)

Section 4 of the slides `slides-ch4` introduces Bézier curves by their sum, writes out the degrees 1, 2 and 3, and lists
what the polygon says about the curve: its ends, its tangents there, its hull, and that it does not care from which end the
points are read.  Minus signs, primes and fraction bars are lost in the text at hand.
*/
#include "chapters/bezier/definition.h"

#include "chapters/judge/claims_on.h"

enum { dim = 2 };

/*
## The sum

Everything on this page follows from one sum.  It is the first thing to read carefully: it makes a curve of the points in their order, and
what it calls the degree is the number of points less one, whether or not the polynomial needs it.

:::{statement} slides-ch4:4-definition
:title: The Bézier curve of n+1 points
:zh: n 次 Bézier 曲线的定义
:printed: the points $P_0,\dots,P_n$ determine the Bézier curve of degree $n$: $P(t)=\sum_{i=0}^nP_iB_{i,n}(t)$, $0\le t\le1$
:definition: yes
:checked-by: bernstein_recurrence
:confirmed-by: decasteljau_evaluates_bezier_curve triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power
:figure: bezier_hull

What is checked is that de Casteljau's recursion, by which the points are computed here, gives this sum, coordinate by coordinate: a step of it
makes the curve of $n+1$ points from those of the first $n$ and of the last $n$ points, and in $(1-t)P_{0,n-1}(t)+tP_{1,n}(t)$, where $P_{k,l}$ is the curve
of $P_k,\dots,P_l$, the point $P_i$ has the factor $(1-t)B_{i,n-1}(t)+tB_{i-1,n-1}(t)$.
:::

:::{statement} slides-ch4:4-degree
:title: The curve of n+1 points has degree n
:zh: 曲线的次数
:printed: what $n+1$ points determine is a Bézier curve of degree $n$
:definition: yes
:checked-by: bernstein_derivative derivatives_go_down_through_the_differences
:confirmed-by: differences_give_every_derivative bernstein_to_power_keeps_polynomial
:meant: the formula that follows, which is written with $n$ | The name of the curve: $n$ is the degree of the Bernstein polynomials in which it
  is written.
:reading: equally_spaced_points_make_a_line | $n$ is the degree of the curve as a polynomial: it is lower where the $n$-th difference
  of the points is 0
:figure: degrees_one_to_three

The $n$-th derivative is $n!$ times the $n$-th difference of the points.
:::

:::{claim} derivatives_go_down_through_the_differences
:title: Each derivative is the sum of the next differences, in every degree and order
:zh: 各阶导矢由各阶差分给出(任意次数与阶数)
:given: integers $0\le r<n$, $m=n-r$, any numbers $p_0,p_1,\dots$, one coordinate of the differences $\Delta^rP_0,\Delta^rP_1,\dots$, and
  $\beta_i=B_i^{m-1}(t)$, any numbers, $\beta_{-1}=0$; $N=n!$ and $g=(m-1)!$, any numbers, so that $m!=mg$; the sum
  $E=\sum_{i<k}\beta_i(p_{i+1}-p_i)$ of some terms
:then: $\frac N{mg}\sum_{i\le k}m(\beta_{i-1}-\beta_i)p_i=\frac Ng(E-\beta_kp_k)$ for the first term, where $E=0$, and for one more term, if it is so for
  the terms before; so with $\beta_m=0$ the derivative of $\frac{n!}{(n-r)!}\sum_iB_i^{n-r}(t)\Delta^rP_i$ is
  $\frac{n!}{(n-r-1)!}\sum_iB_i^{n-r-1}(t)\Delta^{r+1}P_i$
:method: The first term, and one step in the number of terms, everything a variable; then induction over the terms.  That $m(\beta_{i-1}-\beta_i)$ is the derivative of
  $B_i^m$ is `bernstein_derivative`.  For $r=0$ the sum is the curve, so by induction over $r$ every derivative is such a sum: the $n$-th is
  $n!\,\Delta^nP_0$, and at the ends, where one of the functions is 1 and the others are 0, the $r$-th is $\frac{n!}{(n-r)!}\Delta^rP_0$ and
  $\frac{n!}{(n-r)!}\Delta^rP_{n-r}$.
:degrees: all from 1
:over: m N g E# b# c#: -; P# Q#: points
:control: the factor $m$ of the derivative left out
:::
*/
CLAIM(derivatives_go_down_through_the_differences)
{
    num m = whole(T, "m", 1, 8), N = positive(T, "N", 0), g = positive(T, "g", 0), E = unknown(T, "E", 0);
    num p = unknown(T, "P", 0), q = unknown(T, "Q", 0); /* p_k, p_{k+1} */
    num b = unknown(T, "b", 0), c = unknown(T, "c", 0); /* beta_k, beta_{k+1} */
    num factor = fault(T, m, from_int(1)), share = div(N, mul(m, g));
    about(T, "the first term");
    same(T, mul(share, mul(mul(factor, neg(b)), p)), neg(mul(div(N, g), mul(b, p)))); /* beta_{-1} = 0, E = 0 */
    num so_far = mul(div(N, g), sub(E, mul(b, p)));                                   /* the terms up to k */
    num added = mul(share, mul(mul(factor, sub(b, c)), q));                           /* that of the function k+1 */
    about(T, "one term more");
    num edges = sub(add(E, mul(b, sub(q, p))), mul(c, q));
    same(T, add(so_far, added), mul(div(N, g), edges));
}

#if RATIONAL
/*
:::{claim} equally_spaced_points_make_a_line
:title: Points in equal steps on a line: the degree is 1
:zh: 等距共线控制顶点给出一次曲线
:kind: counterexample
:data: P = 0 1 2 3
:instead: P = 0 1 2 4
:result: c = 0 3 0 0
:given: a cubic on a line, its four points $P$ in equal steps; $c$ its coefficients of the powers of $t$, the constant first
:then: all coefficients but that of $t$ are 0: what was called a cubic has degree 1
:method: The coefficients by `bernstein_to_power`; that the last one is not 0 is refuted.
:control: the last point is one step further on
:::
*/
CLAIM(equally_spaced_points_make_a_line)
{
    num P[4], c[4];
    given_points(T, "P", 4, 1, P);
    G(bernstein_to_power)(3, P, c);
    found_points(T, "c", 4, 1, c);
    about(T, "whether the coefficient of t^3 is not 0");
    refute(T, is_zero_q(c[3]));
}

/*
:::{statement} slides-ch4:4-basis
:title: The functions of the sum
:zh: Bernstein 基函数
:printed: $B_{i,n}(t)=\frac{n!}{i!(n-i)!}t^i(1-t)^{n-i}=C_n^it^i(1-t)^{n-i}$, $i=0,1,\dots,n$
:definition: yes
:checked-by: bernstein_sum_of_powers_is_a_power
:confirmed-by: bernstein_is_binomial_form
:figure: bernstein_basis

What is checked is that these functions are the coefficients of $1,Z,\dots,Z^n$ in $(1-t+tZ)^n$, as the binomial theorem says.
:::

:::{statement} slides-ch4:4-conventions
:title: 0! and 0^0 are 1 by convention
:zh: 0! 与 0^0 约定为 1
:printed: $0!$ and $0^0$, where they occur, are by convention 1
:definition: yes
:checked-by: bernstein_recurrence recurrence_keeps_sum_sign_ends_and_symmetry
:confirmed-by: bernstein_at_ends zero_power_zero_takes_away_the_end zero_factorial_zero_divides_by_zero

What is checked is what the convention does: with it $B_{0,0}(t)=1$ for every $t$, and $B_{0,n}(0)=1$ and $B_{n,n}(1)=1$, so that the curve begins in its first
point and ends in its last.  Were $0^0$ the number 0, then the sum at $t=0$ would be the origin (`zero_power_zero_takes_away_the_end`); were $0!$ the number 0, then
the first function and the last would be divided by 0 (`zero_factorial_zero_divides_by_zero`).
:::

:::{claim} zero_power_zero_takes_away_the_end
:title: With 0^0 = 1 the sum at t = 0 is the first point, with 0^0 = 0 it is the origin
:zh: 约定 0^0=1 则曲线过首点,约定 0^0=0 则否
:kind: decision
:data: P = (1,1) (2,3); t = 0; 0^0 = 1 0
:instead: 0^0 = 0 1
:given: the segment of the points $P$ and the parameter of its first end, where $t^0$ is $0^0$; the other power with exponent 0, $(1-t)^0$, is
  $1^0=1$; two values of $0^0$
:then: with $0^0=1$ the sum at $t=0$ is $P_0$, with $0^0=0$ it is the origin
:method: The sum, with the power as told.
:control: the two values exchanged
:::
*/
CLAIM(zero_power_zero_takes_away_the_end)
{
    num P[2 * dim], zeroth[2];
    given_points(T, "P", 2, dim, P);
    given_points(T, "0^0", 2, 1, zeroth);
    num t = given(T, "t"), one = from_int(1), s = sub(one, t);
    for (int k = 0; k < 2; k++) {
        num of_t = is_zero_q(t) ? zeroth[k] : one, of_s = is_zero_q(s) ? zeroth[k] : one; /* t^0, (1-t)^0 */
        about(T, k == 0 ? "the sum and P_0" : "the sum and the origin");
        /* P(t) = t^0 (1-t) P_0 + t (1-t)^0 P_1 */
        for (int c = 0; c < dim; c++)
            same(T, add(mul(P[c], mul(of_t, s)), mul(P[dim + c], mul(t, of_s))), k == 0 ? P[c] : from_int(0));
    }
}

/*
:::{claim} zero_factorial_zero_divides_by_zero
:title: With 0! = 1 no function is divided by 0, with 0! = 0 the first and the last are
:zh: 约定 0!=1 则分母均不为零,约定 0!=0 则首末基函数分母为零
:kind: decision
:data: n = 3; 0! = 1 0
:instead: 0! = 0 1
:given: the functions $\frac{n!}{i!(n-i)!}t^i(1-t)^{n-i}$ of degree $n$ with $i=0$ and $i=n$; two values of $0!$
:then: with $0!=1$ the denominators of both are not 0, with $0!=0$ both are 0
:method: The denominators $0!\,n!$ and $n!\,0!$.
:control: the two values exchanged
:::
*/
CLAIM(zero_factorial_zero_divides_by_zero)
{
    num of_n = G(factorial)(given_whole(T, "n")), of_zero[2];
    given_points(T, "0!", 2, 1, of_zero);
    about(T, "whether the denominators are not 0");
    agree(T, !is_zero_q(mul(of_zero[0], of_n)) && !is_zero_q(mul(of_n, of_zero[0])));
    about(T, "the denominators");
    same(T, mul(of_zero[1], of_n), from_int(0));
    same(T, mul(of_n, of_zero[1]), from_int(0));
}
#endif

/*
:::{statement} slides-ch4:4-degree-1
:title: Degree 1
:zh: 一次 Bézier 曲线
:printed: P(t)=(1-t)P_0+tP_1,\quad0\le t\le1
:holds-by: small_degrees_written_out
:figure: degrees_one_to_three
:::

:::{statement} slides-ch4:4-degree-2
:title: Degree 2, as a sum and by a matrix
:zh: 二次 Bézier 曲线及其矩阵形式
:printed: P(t)=(1-t)^2P_0+2t(1-t)P_1+t^2P_2=[t^2\;t\;1]\begin{bmatrix}1&-2&1\\-2&2&0\\1&0&0\end{bmatrix}\begin{bmatrix}P_0\\P_1\\P_2\end{bmatrix},\quad0\le t\le1
:holds-by: small_degrees_written_out
:figure: degrees_one_to_three

In the text at hand the six numbers of the matrix that are not 0 have no signs.  Each column is the list of the coefficients of one Bernstein polynomial: of the 64
choices of the signs one alone gives the curve.
:::

:::{statement} slides-ch4:4-degree-3
:title: Degree 3, as a sum and by a matrix
:zh: 三次 Bézier 曲线及其矩阵形式
:printed: P(t)=(1-t)^3P_0+3t(1-t)^2P_1+3t^2(1-t)P_2+t^3P_3=[t^3\;t^2\;t\;1]\begin{bmatrix}-1&3&-3&1\\3&-6&3&0\\-3&3&0&0\\1&0&0&0\end{bmatrix}\begin{bmatrix}P_0\\P_1\\P_2\\P_3\end{bmatrix},\quad0\le t\le1
:holds-by: small_degrees_written_out
:figure: degrees_one_to_three

In the text at hand the ten numbers of the matrix that are not 0 have no signs: of the 1024 choices one alone gives the curve.
:::

:::{claim} small_degrees_written_out
:title: The sums and the matrices of the degrees 1, 2 and 3
:zh: 一、二、三次曲线的展开式与矩阵
:given: $n=1,2,3$, any points of the plane, any $t$
:then: the sums that are written out, and the products with the matrices, are the curve
:method: Against the definition by binomial coefficients, everything a variable.  The entries are compared as the coefficients of powers of
  $t$ with free points, so that no other matrix, with whatever signs, gives the curve.  Each coordinate is compared by itself: in space the same is true.
:control: the sign of the last entry of the first row of each matrix
:::
*/
/* Entry (i, j) of the matrix of degree n: the coefficient of t^{n-i} beside P_j. */
static int G(printed_entry)(int n, int i, int j)
{
    static const int M[3][4][4] = {{{-1, 1}, {1, 0}},
                                   {{1, -2, 1}, {-2, 2, 0}, {1, 0, 0}},
                                   {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}}};
    return M[n - 1][i][j];
}

CLAIM(small_degrees_written_out)
{
    static const int factor[3][4] = {{1, 1}, {1, 2, 1}, {1, 3, 3, 1}};
    num b[4 * dim], t = parameter(T, "t"), s = sub(from_int(1), t);
    G(free_points)(T, 3, dim, b);
    for (int n = 1; n <= 3; n++)
        for (int c = 0; c < dim; c++) {
            num P = G(curve)(n, dim, b, c, t), sum = from_int(0), product = from_int(0);
            for (int j = 0; j <= n; j++) {
                num term = mul(from_int(factor[n - 1][j]), mul(G(power)(t, j), G(power)(s, n - j)));
                sum = add(sum, mul(term, b[j * dim + c]));
                for (int i = 0; i <= n; i++) {
                    int entry = G(printed_entry)(n, i, j);
                    entry = fault(T, entry, i == 0 && j == n ? -entry : entry);
                    product = add(product, mul(mul(G(power)(t, n - i), from_int(entry)), b[j * dim + c]));
                }
            }
            about(T, "the sum");
            same(T, sum, P);
            about(T, "the matrix");
            same(T, product, P);
        }
}

/*
## The ends

At an end all functions but one vanish, so the curve begins in its first point and ends in its last.  The slides say so in words; the
formula beside the words has another index, and the claim below needs three points to tell the two apart.

:::{statement} slides-ch4:4-ends
:title: The curve begins and ends with the polygon
:zh: 曲线过首末控制顶点
:printed: $P(0)=P_0$; the curve passes through the starting point and the end point of the given sequence of points
:holds-by: bernstein_recurrence recurrence_keeps_sum_sign_ends_and_symmetry
:confirmed-by: end_derivatives_are_end_differences
:figure: edges_and_end_tangents
:::

:::{statement} slides-ch4:4-ends-value-at-1
:title: The value at t = 1
:zh: t=1 处的值
:printed: P(1)=P_1
:refuted-by: curve_does_not_end_in_its_second_point
:class: misprint
:corrected: P(1)=P_n
:corrected-by: bernstein_recurrence recurrence_keeps_sum_sign_ends_and_symmetry
:confirmed-by: end_derivatives_are_end_differences
:figure: edges_and_end_tangents

The words beside it, and the formula for $P'(1)$, have the last point.  For $n=1$ it is $P_1$.
:::
*/

#if RATIONAL
/*
:::{claim} curve_does_not_end_in_its_second_point
:title: With three points the curve does not end in the second
:zh: 曲线终点不是 P1
:kind: counterexample
:data: n = 2; P = 0 2 1
:instead: n = 1
:result: P(1) = 1
:given: the curve of degree $n$ on a line whose points are the first $n+1$ of the numbers $P$
:then: $P(1)$ is the last point, and the second is another
:method: The value by the kernel, against $P_1$.
:control: the segment of the first two points
:::
*/
CLAIM(curve_does_not_end_in_its_second_point)
{
    int n = given_whole(T, "n");
    num P[3], end;
    given_points(T, "P", 3, 1, P);
    G(bezier_casteljau)(n, 1, P, from_int(1), &end);
    found(T, "P(1)", end);
    about(T, "P(1) and P_1");
    same(T, end, P[1]);
}
#endif

/*
For the tangent the slides differentiate the sum and write the result in three ways: by the derivatives of the functions, as a row
of terms, and by the edges of the polygon.  The third is the one to remember.  In the first two there are terms that are not there at the
ends or for small $n$, and whoever puts in numbers meets $0^{-1}$ or a factorial of $-1$.

:::{statement} slides-ch4:4-derivative-by-basis
:title: The derivative, term by term
:zh: 导矢:逐项求导
:printed: P'(t)=\sum_{i=0}^n\frac{n!}{i!(n-i)!}\bigl(i\,t^{i-1}(1-t)^{n-i}-(n-i)\,t^i(1-t)^{n-i-1}\bigr)P_i
:holds-by: bernstein_derivative sums_by_parts_give_the_edges
:confirmed-by: derivative_in_three_steps
:hypothesis: first_term_divides_by_zero | the products with a factor $i=0$ or $n-i=0$ are left out, or $0<t<1$: at each of $t=0$ and
  $t=1$, the two places where the slides use the derivative, one product is $0\cdot0^{-1}$, of which the convention for $0^0$ says nothing
:figure: edges_and_end_tangents
:::

:::{claim} sums_by_parts_give_the_edges
:title: A sum of points with differences of the functions is a sum of edges with the functions
:zh: 分部求和:基函数之差乘点即基函数乘边
:given: any numbers $\beta_0,\beta_1,\dots$ and points $P_0,P_1,\dots$, one coordinate; $\beta_{-1}=0$; the sum
  $E=\sum_{i<k}\beta_i(P_{i+1}-P_i)$ of some terms
:then: if $\sum_{i\le k}(\beta_{i-1}-\beta_i)P_i=E-\beta_kP_k$ then the same is true of $k+1$; it is true of $k=0$, where $E=0$, so for every $n$ with
  $\beta_n=0$ $\sum_{i=0}^n(\beta_{i-1}-\beta_i)P_i=\sum_{i=0}^{n-1}\beta_i(P_{i+1}-P_i)$
:method: The first term and one step, everything a variable; then induction.  With $\beta_i=n\,B_i^{n-1}(t)$ and `bernstein_derivative` the left side is the
  derivative of $\sum_iP_iB_i^n(t)$ term by term, and the right side is that by the edges.
:degrees: all
:over: E# b# c#: -; P# Q#: points
:control: the last function with the other sign
:::
*/
CLAIM(sums_by_parts_give_the_edges)
{
    num E = unknown(T, "E", 0), P = unknown(T, "P", 0), Q = unknown(T, "Q", 0); /* P_k, P_{k+1} */
    num b = unknown(T, "b", 0), c = unknown(T, "c", 0);                         /* beta_k, beta_{k+1} */
    num so_far = sub(E, mul(b, P)), edges = add(E, mul(b, sub(Q, P)));
    about(T, "the first term");
    same(T, mul(sub(from_int(0), b), P), sub(from_int(0), mul(b, P))); /* beta_{-1} = 0, E = 0 */
    about(T, "one term more");
    same(T, add(so_far, mul(sub(b, c), Q)), sub(edges, mul(fault(T, c, neg(c)), Q)));
}

/*
:::{claim} derivative_in_three_steps
:title: The three sums are the derivative
:zh: 导矢推导链的三个式子
:given: points $P_0,\dots,P_n$ of the plane, any $t$ with $t\ne0$, $t\ne1$ in the first sum
:where: $t\ne0$ and $t\ne1$ in the first sum
:then: the sum with $t^{i-1}$ and $(1-t)^{n-i-1}$, the sum of the $2n$ terms in a row, and the sum over the edges are all $P'(t)$
:method: Each sum as printed, negative powers as quotients, against the derivative of the definition; everything a variable.
:degrees: 1..6 sampled 10
:control: the last term of the row with the other sign
:::
*/
CLAIM(derivative_in_three_steps)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * dim], t = parameter(T, "t"), s = sub(from_int(1), t);
    G(free_points)(T, n, dim, b);
    for (int c = 0; c < dim; c++) {
        num by_basis = from_int(0), row = from_int(0), by_edges = from_int(0);
        for (int i = 0; i <= n; i++) {
            num up = mul(from_int(i), mul(div(G(power)(t, i), t), G(power)(s, n - i)));
            num down = mul(from_int(n - i), mul(G(power)(t, i), div(G(power)(s, n - i), s)));
            by_basis = add(by_basis, mul(mul(G(choose)(n, i), sub(up, down)), b[i * dim + c]));
        }
        for (int i = 0; i < n; i++) { /* the two terms with n!/(i! (n-1-i)!) */
            num term = mul(mul(from_int(n), G(choose)(n - 1, i)), mul(G(power)(t, i), G(power)(s, n - 1 - i)));
            num right = mul(term, b[(i + 1) * dim + c]);
            row = sub(row, mul(term, b[i * dim + c]));
            row = fault(T, add(row, right), i == n - 1 ? sub(row, right) : add(row, right));
            by_edges = add(by_edges, mul(term, sub(b[(i + 1) * dim + c], b[i * dim + c])));
        }
        num D = G(curve_derivative)(n, dim, b, c, 1, t);
        about(T, "by the derivatives of the basis");
        same(T, by_basis, D);
        about(T, "the terms in a row");
        same(T, row, D);
        about(T, "by the edges");
        same(T, by_edges, D);
    }
}

#if RATIONAL
/*
:::{claim} first_term_divides_by_zero
:title: At t = 0 the first term of the derivative is no number, at t = 1 the last
:zh: t=0 处首项含 0^{-1},t=1 处末项亦然
:kind: counterexample
:data: t = 0 1
:instead: t = 1/2 1/2
:result: denominators = 0 0
:given: the term with $i=0$ in the first sum, whose factor $i\,t^{i-1}$ is $0\cdot t^{-1}$, at the parameter $t$ of the first end; and that with $i=n$,
  whose factor $(n-i)(1-t)^{n-i-1}$ is $0\cdot(1-t)^{-1}$, at that of the last one
:then: the denominators, $t$ and $1-t$, are 0
:method: The denominators; that they are not 0 is refuted.
:control: a parameter inside the interval
:::
*/
CLAIM(first_term_divides_by_zero)
{
    num t[2];
    given_points(T, "t", 2, 1, t);
    num below[2] = {t[0], sub(from_int(1), t[1])};
    found_points(T, "denominators", 2, 1, below);
    about(T, "whether the denominators of t^{-1} and (1-t)^{-1} are not 0");
    refute(T, is_zero_q(below[0]) && is_zero_q(below[1]));
}

/*
:::{statement} slides-ch4:4-derivative-terms
:title: The derivative, its terms in a row
:zh: 导矢:逐项展开
:printed: $P'(t)=-\frac{n!}{(n-1)!}(1-t)^{n-1}P_0+\frac{n!}{(n-1)!}(1-t)^{n-1}P_1-\frac{n!}{(n-2)!}t(1-t)^{n-2}P_1+\dots+\frac{n!}{(n-2)!}t^{n-2}(1-t)P_{n-1}-\frac{n!}{(n-1)!}t^{n-1}P_{n-1}+\frac{n!}{(n-1)!}t^{n-1}P_n$
:holds-by: bernstein_derivative sums_by_parts_give_the_edges
:confirmed-by: derivative_in_three_steps
:hypothesis: terms_in_a_row_come_twice_for_two_edges | from $n=2$ on the terms are those from the first to the last, each once: written out as
  six they are right from $n=3$ on; for $n=2$ two of them come twice
:hypothesis: terms_in_a_row_come_twice_for_one_edge | for $n=1$ only the first and the last term are taken: there is no
  $(n-2)!$, and the four terms without it, the two nearest to each end, have twice the sum of the first and the last
:figure: edges_and_end_tangents
:::

:::{claim} terms_in_a_row_come_twice_for_two_edges
:title: With two edges two of the six terms come twice
:zh: n=2 时六项中有两项重复
:kind: counterexample
:data: P = 0 1 0; t = 1/4
:result: six terms = 2; P'(t) = 1
:given: $n=2$, the points $P$ of a line, a parameter $t$
:then: the six terms have another sum than the derivative; what is too much is $-2P_1(2t-1)$
:method: The terms, against the derivative by the kernel.
:control: each term once
:::
*/
CLAIM(terms_in_a_row_come_twice_for_two_edges)
{
    num P[3], D[2], two = from_int(2);
    given_points(T, "P", 3, 1, P);
    num t = given(T, "t"), s = sub(from_int(1), t);
    /* -2(1-t) P_0 + 2(1-t) P_1 and -2t P_1 + 2t P_2: the first two terms and the last two are P'(t) already */
    num once = add(mul(mul(two, s), sub(P[1], P[0])), mul(mul(two, t), sub(P[2], P[1])));
    /* the two between, -2t P_1 and 2(1-t) P_1, are among them */
    num row = fault(T, once, add(once, mul(mul(two, sub(s, t)), P[1])));
    bezier_derivatives_q(2, 1, P, t, 1, D);
    found(T, "six terms", row);
    found(T, "P'(t)", D[1]);
    about(T, "the six terms and the derivative");
    same(T, row, D[1]);
}

/*
:::{claim} terms_in_a_row_come_twice_for_one_edge
:title: With one edge four terms are left, which are twice the derivative
:zh: n=1 时剩下的四项为导矢的两倍
:kind: counterexample
:data: P = 0 1; t = 1/4
:result: four terms = 2; P'(t) = 1
:given: $n=1$, the points $P$ of a line, a parameter $t$; the terms with $(n-2)!$, which have no meaning, are left out
:then: $-P_0+P_1-P_0+P_1$ is twice the derivative
:method: The four terms, against the derivative by the kernel.
:control: each term once
:::
*/
CLAIM(terms_in_a_row_come_twice_for_one_edge)
{
    num P[2], D[2];
    given_points(T, "P", 2, 1, P);
    bezier_derivatives_q(1, 1, P, given(T, "t"), 1, D);
    num edge = sub(P[1], P[0]), row = fault(T, edge, add(edge, edge));
    found(T, "four terms", row);
    found(T, "P'(t)", D[1]);
    about(T, "the four terms and the derivative");
    same(T, row, D[1]);
}
#endif

/*
:::{statement} slides-ch4:4-derivative
:title: The derivative by the edges of the polygon
:zh: 导矢由控制多边形的边给出
:printed: P'(t)=\sum_{i=0}^{n-1}\frac{n!}{i!(n-1-i)!}t^i(1-t)^{n-1-i}(P_{i+1}-P_i)
:holds-by: bernstein_derivative sums_by_parts_give_the_edges
:confirmed-by: derivative_in_three_steps
:figure: edges_and_end_tangents
:::

:::{statement} slides-ch4:4-end-tangents
:title: The tangents at the ends
:zh: 端点切矢
:printed: $P'(0)=n(P_1-P_0)$, $P'(1)=n(P_n-P_{n-1})$
:holds-by: bernstein_recurrence recurrence_keeps_sum_sign_ends_and_symmetry bernstein_derivative
  sums_by_parts_give_the_edges
:confirmed-by: end_derivatives_are_end_differences
:figure: edges_and_end_tangents
:::

## Symmetry

The word symmetric is used of the functions, of the sum, and then of the curve.  The functions read backwards are the same functions,
so it does not matter from which end the points are read.  That the figure is its own mirror image does not follow.

:::{statement} slides-ch4:4-basis-symmetry
:title: The symmetry of the functions
:zh: 基函数的对称性
:printed: B_{i,n}(t)=\frac{n!}{i!(n-i)!}t^i(1-t)^{n-i}=B_{n-i,n}(1-t)
:holds-by: bernstein_recurrence recurrence_keeps_sum_sign_ends_and_symmetry
:confirmed-by: bernstein_is_symmetric
:figure: bernstein_basis
:::

:::{statement} slides-ch4:4-symmetry
:title: The curve in the basis read backwards
:zh: Bézier 曲线的对称性
:printed: the symmetry of the Bézier curve (Bézier 曲线的对称性, the heading): $P(t)=B_{0,n}(t)P_0+\dots+B_{i,n}(t)P_i+\dots+B_{n-i,n}(t)P_{n-i}+\dots+B_{n,n}(t)P_n$
  $=B_{n,n}(1-t)P_0+\dots+B_{n-i,n}(1-t)P_i+\dots+B_{i,n}(1-t)P_{n-i}+\dots+B_{0,n}(1-t)P_n$
:holds-by: bernstein_recurrence recurrence_keeps_sum_sign_ends_and_symmetry
:confirmed-by: reversed_points_reverse_the_curve basis_read_backwards
:meant: the formula below the heading, which has each point with the function of the other end at $1-t$ | The points read backwards give the same curve, run backwards.
:reading: recurrence_keeps_sum_sign_ends_and_symmetry | it is symmetric in its points: read backwards they give the curve run backwards
:reading-with: bernstein_recurrence
:reading: curve_is_no_mirror_image | it is symmetric as a figure: its own mirror image, with the ends exchanged
:figure: read_from_either_end
:::

:::{claim} basis_read_backwards
:title: The sum with the basis read backwards at 1 - t
:zh: 反序基函数之和
:given: points $P_0,\dots,P_n$ of the plane, any $t$
:then: $P(t)=\sum_iB_{n-i,n}(1-t)P_i$
:method: The sum from the definition at $1-t$, against the kernel at $t$, everything a variable.
:degrees: 0..6 sampled 12
:control: $B_{i,n}(1-t)$ in the place of $B_{n-i,n}(1-t)$, for $n=0$ the value 0
:::
*/
CLAIM(basis_read_backwards)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * dim], P[dim], t = parameter(T, "t"), s = sub(from_int(1), t);
    G(free_points)(T, n, dim, b);
    G(bezier_casteljau)(n, dim, b, t, P);
    for (int c = 0; c < dim; c++) {
        num sum = from_int(0);
        for (int i = 0; i <= fault(T, n, n == 0 ? -1 : n); i++)
            sum = add(sum, mul(G(basis)(n, fault(T, n - i, i), s), b[i * dim + c]));
        same(T, sum, P[c]);
    }
}

#if RATIONAL
/*
:::{claim} curve_is_no_mirror_image
:title: A curve that is not symmetric
:zh: 曲线图形未必对称
:kind: counterexample
:data: P = (0,0) (0,1) (1,0); t = 1/2
:instead: P = (0,0) (1/2,1) (1,0)
:result: P(t) = (1/4,1/2); image = (3/4,1/2)
:given: the quadratic curve of the points $P$, of which the first and the last lie on the $x$-axis: a reflection that exchanges the
  ends of the curve and keeps the figure would exchange the ends of the chord, $x\mapsto x_0+x_2-x$
:then: the image of the point $P(t)$ is not on the curve
:method: In barycentric coordinates with respect to the three points the curve has $\tau_0=(1-t)^2$, $\tau_1=2t(1-t)$, $\tau_2=t^2$,
  so $(\frac{\tau_1}2)^2=\tau_0\tau_2$ holds on it; the equation at the image.
:control: the middle point stands over the middle of the chord
:::
*/
CLAIM(curve_is_no_mirror_image)
{
    num P[3 * dim], at[dim], tau[3];
    given_points(T, "P", 3, dim, P);
    G(bezier_casteljau)(2, dim, P, given(T, "t"), at);
    found_points(T, "P(t)", 1, dim, at);
    num image[dim] = {sub(add(P[0], P[2 * dim]), at[0]), at[1]};
    found_points(T, "image", 1, dim, image);
    /* tau_i is the area of the triangle in which the image takes the place of P_i, over the whole area */
    num edges[2 * dim], whole_area;
    for (int c = 0; c < dim; c++) {
        edges[c] = sub(P[dim + c], P[c]);
        edges[dim + c] = sub(P[2 * dim + c], P[c]);
    }
    whole_area = cross2_q(edges, edges + dim);
    for (int i = 0; i < 3; i++) {
        const num *next = P + (i + 1) % 3 * dim, *last = P + (i + 2) % 3 * dim;
        num to_next[dim] = {sub(next[0], image[0]), sub(next[1], image[1])};
        num to_last[dim] = {sub(last[0], image[0]), sub(last[1], image[1])};
        tau[i] = div(cross2_q(to_next, to_last), whole_area);
    }
    about(T, "the equation of the curve at the image");
    num half = div(tau[1], from_int(2));
    same(T, mul(half, half), mul(tau[0], tau[2]));
}
#endif

/*
## The hull

The hull is defined as the set of all weighted averages of the points, and the curve consists of such averages: this is the
whole proof.  It uses that the functions are not negative, hence $0\le t\le1$.

:::{statement} slides-ch4:4-hull-definition
:title: The convex hull of the points
:zh: 凸包的定义
:printed: for the given points $P_0,P_1,\dots,P_n$ the point set $M=\Bigl\{\sum_{i=0}^n\lambda_iP_i\Bigm|\sum_{i=0}^n\lambda_i=1,\ 0\le\lambda_i\le1\Bigr\}$
:definition: yes
:figure: bezier_hull

The text at hand does not say what $M$ is called; the heading above it is about the convex hull, `slides-ch4:4-hull`.  The bounds are for $i=0,1,\dots,n$.
:::

:::{statement} slides-ch4:4-partition
:title: The functions are not negative and their sum is 1
:zh: 基函数的非负性与规范性
:printed: $0\le B_{i,n}(t)\le1$, $\sum_{i=0}^nB_{i,n}(t)=((1-t)+t)^n\equiv1$, $0\le i\le n$, $0\le t\le1$
:holds-by: bernstein_recurrence recurrence_keeps_sum_sign_ends_and_symmetry bernstein_sum_of_powers_is_a_power
:confirmed-by: bernstein_positive_inside bernstein_sums_to_one bernstein_at_ends
:needs: function_is_negative_outside_the_interval | the line itself and the definition of the curve, $0\le t\le1$ | $0\le t\le1$;
  for the bounds 0 and 1: the sum is 1 for every $t$
:figure: bernstein_basis

The middle of the second chain is $(1-t+tZ)^n$ with $Z=1$.  That a function is at most 1 follows from the rest as well: the sum is 1, and no function is negative.
In the text at hand one $n$ is lost, the upper end of $i$ or of the sum.
:::
*/

#if RATIONAL
/*
:::{claim} function_is_negative_outside_the_interval
:title: Outside the unit interval a function is negative and another greater than 1
:zh: 区间之外基函数为负或大于 1
:kind: counterexample
:data: n = 1; t = 2
:instead: t = 1/2
:result: B = -1 2
:given: the functions $B$ of degree $n$ at the parameter $t$
:then: the first is negative, the other greater than 1
:method: The values by the kernel; that the first is not negative, or the other at most 1, is refuted.
:control: a parameter inside the interval
:::
*/
CLAIM(function_is_negative_outside_the_interval)
{
    int n = given_whole(T, "n");
    num t = given(T, "t"), B[2];
    G(bernstein_basis)(n, t, B);
    found_points(T, "B", 2, 1, B);
    about(T, "whether the first is not negative, or the second at most 1");
    refute(T, sign_q(B[0]) < 0 && sign_q(sub(B[1], from_int(1))) > 0);
}
#endif

/*

:::{statement} slides-ch4:4-hull
:title: The curve is in the hull of its points
:zh: 凸包性
:printed: the convex hull property of the curve (曲线的凸包性, the heading above the set $M$ and the two properties of the functions)
:holds-by: bernstein_recurrence recurrence_keeps_sum_sign_ends_and_symmetry
:confirmed-by: bernstein_positive_inside bernstein_sums_to_one bernstein_at_ends
:needs: curve_leaves_hull_outside_the_interval | the definition of the curve, $0\le t\le1$ | $0\le t\le1$; with equal weights,
  as in this example, the rational curve is the Bézier curve
:meant: the set $M$ and the properties of the functions, which stand below the heading | The points of the curve belong to $M$, the numbers
  $\lambda_i$ being the values of the functions.
:figure: bezier_hull

No sentence says what the property is.
:::
*/
#include "chapters/judge/claims_off.h"
