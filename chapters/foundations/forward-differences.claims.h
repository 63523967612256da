/*
# A table of differences (向前差分)

A polynomial of degree $n$ loses a degree with each difference (差分), and the $n$-th difference is constant.  Whoever
knows one column of the table, the point and its $n$ differences at one place, finds the next column by $n$ additions.
*/
#include "chapters/foundations/definition.h"

#if RATIONAL
#include "chapters/foundations/counted.h"
#endif

#include "chapters/judge/claims_on.h"

/*
:::{statement} hu-1987:1-4-difference-1-definition
:title: The first forward difference
:zh: 一阶向前差分的定义
:printed: \Delta P(t)=P(t-\delta)-P(t)=3A\delta t^2+(3A\delta^2+2B\delta)t+A\delta^3+B\delta^2+C\delta
:refuted-by: printed_first_difference_looks_back
:class: misprint
:corrected: \Delta P(t)=P(t+\delta)-P(t)=3A\delta t^2+(3A\delta^2+2B\delta)t+A\delta^3+B\delta^2+C\delta
:corrected-by: differences_of_a_cubic
:figure: forward_differences

:::

:::{statement} hu-1987:1-4-difference-1
:title: The first difference of the cubic
:zh: 一阶差分
:printed: \Delta P(t)=3A\delta t^2+(3A\delta^2+2B\delta)t+A\delta^3+B\delta^2+C\delta
:holds-by: differences_of_a_cubic
:meant: the words before it, forward differences (向前差分) | $\Delta P(t)=P(t+\delta)-P(t)$, and not the
  $P(t-\delta)-P(t)$ that is printed for it in the same line: see `hu-1987:1-4-difference-1-definition`.
:figure: forward_differences
:::

:::{statement} hu-1987:1-4-difference-2
:title: The second difference of the cubic
:zh: 二阶差分
:printed: \Delta^2P(t)=\Delta P(t+\delta)-\Delta P(t)=6A\delta^2t+6A\delta^3+2B\delta^2
:holds-by: differences_of_a_cubic
:meant: the words before it, forward differences (向前差分) | $\Delta P(t)=P(t+\delta)-P(t)$.
:figure: forward_differences
:::
*/

/* The printed expressions of the differences of order 1, 2, 3 for c = (D, C, B, A). */
static num G(printed_difference)(int order, const num c[], num t, num delta)
{
    num A = c[3], B = c[2], C = c[1], d2 = mul(delta, delta), d3 = mul(d2, delta);
    if (order == 1) {
        num linear = add(mul(from_int(3), mul(A, d2)), mul(from_int(2), mul(B, delta)));
        num constant = add(add(mul(A, d3), mul(B, d2)), mul(C, delta));
        return add(add(mul(mul(from_int(3), mul(A, delta)), mul(t, t)), mul(linear, t)), constant);
    }
    num Ad3 = mul(from_int(6), mul(A, d3));
    if (order == 3)
        return Ad3;
    return add(add(mul(mul(from_int(6), mul(A, d2)), t), Ad3), mul(from_int(2), mul(B, d2)));
}

/*
:::{claim} differences_of_a_cubic
:title: The three forward differences of a cubic
:zh: 三次曲线的各阶向前差分
:given: the cubic $P(t)=At^3+Bt^2+Ct+D$ with any $A$, $B$, $C$, $D$; any $t$ and $\delta$
:then: $P(t+\delta)-P(t)$, $\Delta P(t+\delta)-\Delta P(t)$ and $\Delta^2P(t+\delta)-\Delta^2P(t)$ are the three printed expressions
:method: The differences of the sums of powers at $t,\dots,t+3\delta$, everything a variable; one coordinate, any one.
:over: x#: coefficients; d: δ
:control: $t-\delta$ in the place of $t+\delta$
:::
*/
CLAIM(differences_of_a_cubic)
{
    num c[4], t = parameter(T, "t"), delta = parameter(T, "d"), D[4][4];
    G(free_points)(T, 3, 1, c);
    num step = fault(T, delta, neg(delta));
    for (int i = 0; i <= 3; i++)
        D[0][i] = G(power_sum)(3, 1, c, 0, add(t, mul(from_int(i), step)));
    for (int k = 1; k <= 3; k++) {
        for (int i = 0; i <= 3 - k; i++)
            D[k][i] = sub(D[k - 1][i + 1], D[k - 1][i]);
        same(T, D[k][0], G(printed_difference)(k, c, t, delta));
    }
}

#if RATIONAL
/*
:::{claim} printed_first_difference_looks_back
:title: With the printed argument the first difference is another one
:zh: 印刷的一阶差分是另一个差分
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$, that is with the coefficients $c$ from $D$ to $A$; $t$ and $\delta$
:data: c = 0 0 0 1; t = 1/2; δ = 1/2
:then: $P(t-\delta)-P(t)$ is not the expression that is printed for it
:result: P(t-δ) - P(t) = -1/8; printed expression = 7/8
:method: Both sides of the printed line, exactly.
:control: $P(t+\delta)$
:::
*/
CLAIM(printed_first_difference_looks_back)
{
    num c[4];
    given_points(T, "c", 4, 1, c);
    num t = given(T, "t"), delta = given(T, "δ"), other = fault(T, add(t, delta), sub(t, delta));
    num difference = sub(G(power_sum)(3, 1, c, 0, other), G(power_sum)(3, 1, c, 0, t));
    num printed = G(printed_difference)(1, c, t, delta);
    found(T, "P(t-δ) - P(t)", difference);
    found(T, "printed expression", printed);
    about(T, "the difference, and the expression printed for it");
    same(T, difference, printed);
}

/*
:::{statement} hu-1987:1-4-difference-3-definition
:title: The third forward difference
:zh: 三阶差分的定义
:printed: \Delta^3P(t)=\Delta^2P(t-\delta)-\Delta^2P(t)=6A\delta^3
:refuted-by: printed_third_difference_has_the_other_sign
:class: misprint
:corrected: \Delta^3P(t)=\Delta^2P(t+\delta)-\Delta^2P(t)=6A\delta^3
:corrected-by: differences_of_a_cubic
:figure: forward_differences
:::

:::{claim} printed_third_difference_has_the_other_sign
:title: With the printed argument the third difference is the negative
:zh: 印刷的三阶差分符号有误
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$, that is with the coefficients $c$ from $D$ to $A$; $t$ and $\delta$
:data: c = 0 0 0 1; t = 1/4; δ = 1/4
:then: $\Delta^2P(t-\delta)-\Delta^2P(t)$ is the negative of the value that is printed for it
:result: Δ²P(t-δ) - Δ²P(t) = -3/32; printed value = 3/32
:method: Both sides, with the printed $\Delta^2P(t)$, which is right.
:control: $\Delta^2P(t+\delta)$
:::
*/
CLAIM(printed_third_difference_has_the_other_sign)
{
    num c[4];
    given_points(T, "c", 4, 1, c);
    num t = given(T, "t"), delta = given(T, "δ"), other = fault(T, add(t, delta), sub(t, delta));
    num difference = sub(G(printed_difference)(2, c, other, delta), G(printed_difference)(2, c, t, delta));
    num printed = G(printed_difference)(3, c, t, delta);
    found(T, "Δ²P(t-δ) - Δ²P(t)", difference);
    found(T, "printed value", printed);
    about(T, "the difference, and the value printed for it");
    same(T, difference, printed);
}
#endif

/*
Two of the three definitions are printed with $t-\delta$ in the place of $t+\delta$.  One sees it without computing: the
formula beside the first begins with $+3A\delta t^2$, and a difference that looks back would begin with a minus sign.
The second definition and all formulas are those of forward differences.

:::{statement} hu-1987:1-4-constant-difference
:title: The n-th difference of a curve of degree n is constant
:zh: n 次多项式的 n 阶差分为常矢量
:printed: The third difference is a vector that does not depend on the parameter; in general the $n$-th difference of a polynomial
  of degree $n$ is a constant vector.
:holds-by: differences_lower_the_newton_functions
:confirmed-by: differences_by_alternating_sums
:figure: forward_differences
:::
*/

/* The alternating sum of order k at t, coordinate j. */
static num G(alternating_sum)(int n, int dim, const num c[], int j, int k, num t, num delta)
{
    num sum = from_int(0);
    for (int i = 0; i <= k; i++) {
        num value = G(power_sum)(n, dim, c, j, add(t, mul(from_int(i), delta)));
        num term = mul(from_int(binomial(k, i)), value);
        sum = (k - i) % 2 == 0 ? add(sum, term) : sub(sum, term);
    }
    return sum;
}

/*
:::{claim} differences_lower_the_newton_functions
:title: A difference takes each of Newton's functions to the one before
:zh: 差分将 Newton 基函数降一次
:given: any $k\ge1$ and $x$, $c=\binom x{k-1}$, so that $\binom xk=c\frac{x-k+1}k$ and $\binom{x+1}k=c\frac{x+1}k$
:then: $\binom{x+1}k-\binom xk=\binom x{k-1}$, and $\binom{x+1}0-\binom x0=0$; $x\binom xk=(k+1)\binom x{k+1}+k\binom xk$, and $x\binom x0=\binom x1$, so that the
  powers of $x$ are sums of these functions, one after the other; so the $n$-th difference of $\sum_{k\le n}a_k\binom{t/\delta}k$ with the
  step $\delta\ne0$ is the constant $a_n$, and every further one is 0
:method: Identities with $k$, $x$ and $c$ variables, $x=t/\delta$.  By that of $x\binom xk$ every polynomial of degree at most $n$ in $t$ is a sum of
  $\binom{t/\delta}0,\dots,\binom{t/\delta}n$, by induction; each coordinate of a vector alone.  With $\delta=0$ all differences of order 1 and more
  are 0.
:degrees: all
:over: k c: -; x: t
:control: $\frac{x-k}k$ in the place of $\frac{x-k+1}k$
:::
*/
CLAIM(differences_lower_the_newton_functions)
{
    num k = whole(T, "k", 1, 20), x = unknown(T, "x", 0), c = unknown(T, "c", 0), one = from_int(1);
    num here = mul(c, div(sub(x, fault(T, sub(k, one), k)), k)), there = mul(c, div(add(x, one), k));
    about(T, "the difference");
    same(T, sub(there, here), c);
    num next = mul(here, div(sub(x, k), add(k, one))); /* binom(x, k+1) */
    about(T, "the next power");
    same(T, mul(x, here), add(mul(add(k, one), next), mul(k, here)));
}

/*
:::{claim} differences_by_alternating_sums
:title: The kernel's table holds the forward differences; the last is constant
:zh: 差分表与末阶差分
:given: any coefficients in the plane, any $\delta$
:then: row $k$ of `power_differences` is $\sum_i(-1)^{k-i}\binom kiP(i\delta)$, and its last row is $n!\,c_n\,\delta^n$, which does not
  depend on the place: at any $t$ the alternating sum of $P(t),\dots,P(t+n\delta)$ is the same
:method: The kernel against alternating sums of the definition, at 0 and at a variable $t$.
:degrees: 1..6 sampled 12
:over: x# y#: coefficients; d: δ
:defines: power_differences
:control: the place $t$ taken in the difference of order $n-1$
:::
*/
CLAIM(differences_by_alternating_sums)
{
    enum { dim = 2 };
    int n = T->degree;
    num c[(MAX_DEGREE + 1) * dim], d[(MAX_DEGREE + 1) * dim], t = parameter(T, "t"), delta = parameter(T, "d");
    G(free_points)(T, n, dim, c);
    G(power_differences)(n, dim, c, delta, d);
    for (int j = 0; j < dim; j++) {
        for (int k = 0; k <= n; k++)
            same(T, d[k * dim + j], G(alternating_sum)(n, dim, c, j, k, from_int(0), delta));
        num last = mul(c[n * dim + j], G(power)(delta, n));
        for (int k = 2; k <= n; k++)
            last = mul(last, from_int(k));
        same(T, d[n * dim + j], last);
        int order = fault(T, n, n - 1);
        same(T, G(alternating_sum)(n, dim, c, j, order, t, delta), d[order * dim + j]);
    }
}

/*
## Stepping

:::{statement} hu-1987:1-4-3-places
:title: The place of the differences with the index 1
:zh: 下标 1 的差分所在参数
:printed: The differences at $t=0$ and $t=i\delta$ are $P_0,\Delta P_0,\Delta^2P_0,\Delta^3P_0$ and $P_1,\Delta P_1,\Delta^2P_1,\Delta^3P_1$; then $P_1=P_0+\Delta P_0$.
:refuted-by: step_from_zero_reaches_one_step_only
:class: misprint
:corrected: $P_1,\Delta P_1,\Delta^2P_1,\Delta^3P_1$ are the differences at $t=\delta$; then $P_1=P_0+\Delta P_0$.
:corrected-by: printed_lines_step_a_cubic
:confirmed-by: step_takes_differences_to_the_next_place additions_step_along_the_curve
:figure: forward_differences

:::
*/

#if RATIONAL
/*
:::{claim} step_from_zero_reaches_one_step_only
:title: One step from 0 does not reach the second place
:zh: 一步不能到达第 i 点
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$, the step $\delta$ and $i$; $P_0$ and $\Delta P_0$ belong to $t=0$
:data: c = 0 0 0 1; δ = 1/2; i = 2
:instead: i = 1
:then: $P_0+\Delta P_0$ is not $P(i\delta)$
:result: P_0 + ΔP_0 = 1/8; P(iδ) = 1
:method: Both values, exactly.
:control: the first place
:::
*/
CLAIM(step_from_zero_reaches_one_step_only)
{
    num c[4], d[4];
    given_points(T, "c", 4, 1, c);
    num delta = given(T, "δ"), place = mul(given(T, "i"), delta), there = G(power_sum)(3, 1, c, 0, place);
    G(power_differences)(3, 1, c, delta, d);
    G(power_difference_step)(3, 1, d);
    found(T, "P_0 + ΔP_0", d[0]);
    found(T, "P(iδ)", there);
    about(T, "P_0 + ΔP_0, and P(iδ)");
    same(T, d[0], there);
}
#endif

/*
:::{claim} additions_step_along_the_curve
:title: The table runs along the curve
:zh: 差分表沿曲线前进
:given: any coefficients in the plane, any $\delta$, 12 steps
:then: after $i$ steps the first row is $P(i\delta)$
:method: `power_differences`, then `power_difference_step` again and again, against the sum of powers.
:degrees: 1..6 sampled 8
:over: x# y#: coefficients; d: δ
:control: the last difference taken as 0
:::
*/
CLAIM(additions_step_along_the_curve)
{
    enum { dim = 2 };
    int n = T->degree;
    num c[(MAX_DEGREE + 1) * dim], d[(MAX_DEGREE + 1) * dim], delta = parameter(T, "d");
    G(free_points)(T, n, dim, c);
    G(power_differences)(n, dim, c, delta, d);
    d[n * dim] = fault(T, d[n * dim], from_int(0));
    for (int i = 0; i <= 12; i++) {
        for (int j = 0; j < dim; j++)
            same(T, d[j], G(power_sum)(n, dim, c, j, mul(from_int(i), delta)));
        G(power_difference_step)(n, dim, d);
    }
}

/*
The index of a place is the second trap.  A step takes the differences at one place to those at the next one, from 0 to
$\delta$; the places $i\delta$ are reached by $i$ steps and not by one.

:::{statement} hu-1987:1-4-3
:title: One step of the table
:zh: 差分递推
:printed: P_1=P_0+\Delta P_0,\quad\Delta P_1=\Delta P_0+\Delta^2P_0,\quad\Delta^2P_1=\Delta^2P_0+\Delta^3P_0,\quad\Delta^3P_1=\Delta^3P_0
:holds-by: printed_lines_step_a_cubic
:confirmed-by: step_takes_differences_to_the_next_place
:meant: the lines themselves, one addition each, and the sentence behind them, by which additions lead from $t=0$ to $\delta,2\delta,\dots$ one after the other |
  $P_1,\Delta P_1,\Delta^2P_1,\Delta^3P_1$ are the differences at $t=\delta$, the next place, not at the $t=i\delta$ that is printed for them.
:figure: forward_differences
:::

:::{claim} step_takes_differences_to_the_next_place
:title: The step of the table takes the differences at one place to those at the next
:zh: 差分表前进一步
:given: any coefficients in space, any $t$ and $\delta\ne0$
:where: $\delta\ne0$
:then: `power_difference_step`, and with the rows divided by $\delta^k$ `power_scaled_difference_step`, take the differences at $t$ to those
  at $t+\delta$
:method: The kernels on the alternating sums at $t$, against those at $t+\delta$.
:degrees: 1..6 sampled 12
:over: x# y# z#: coefficients; d: δ
:defines: power_difference_step power_scaled_difference_step
:control: the differences at $t+2\delta$
:::
*/
CLAIM(step_takes_differences_to_the_next_place)
{
    enum { dim = 3 };
    int n = T->degree;
    num c[(MAX_DEGREE + 1) * dim], d[(MAX_DEGREE + 1) * dim], e[(MAX_DEGREE + 1) * dim];
    num t = parameter(T, "t"), delta = positive(T, "d", 0), next = add(t, delta);
    G(free_points)(T, n, dim, c);
    for (int k = 0; k <= n; k++)
        for (int j = 0; j < dim; j++) {
            d[k * dim + j] = G(alternating_sum)(n, dim, c, j, k, t, delta);
            e[k * dim + j] = div(d[k * dim + j], G(power)(delta, k));
        }
    G(power_difference_step)(n, dim, d);
    G(power_scaled_difference_step)(n, dim, delta, e);
    next = fault(T, next, add(next, delta));
    for (int k = 0; k <= n; k++)
        for (int j = 0; j < dim; j++) {
            num there = G(alternating_sum)(n, dim, c, j, k, next, delta);
            same(T, d[k * dim + j], there);
            same(T, e[k * dim + j], div(there, G(power)(delta, k)));
        }
}

/*
:::{claim} printed_lines_step_a_cubic
:title: The four lines of the table for a cubic
:zh: 三次曲线差分表的四式
:given: any coefficients of a cubic in space, any $t$ and $\delta$; $P_0,\Delta P_0,\Delta^2P_0,\Delta^3P_0$ the differences at $t$,
  $P_1,\dots,\Delta^3P_1$ those at $t+\delta$
:then: $\Delta^kP_1=\Delta^kP_0+\Delta^{k+1}P_0$ for $k=0,1,2$ and $\Delta^3P_1=\Delta^3P_0$
:method: Both sides by the alternating sums of the definition; no kernel is used.
:degrees: 3..3
:over: x# y# z#: coefficients; d: δ
:control: the differences at $t+2\delta$
:::
*/
/* The four lines, or each divided by the power of delta of its order. */
static void G(compare_lines)(trial *T, int divided)
{
    enum { dim = 3, last = 3 };
    num c[(last + 1) * dim], t = parameter(T, "t"), zero = from_int(0);
    num delta = divided ? positive(T, "d", 0) : parameter(T, "d");
    num next = add(t, fault(T, delta, add(delta, delta)));
    G(free_points)(T, last, dim, c);
    for (int j = 0; j < dim; j++)
        for (int k = 0; k <= last; k++) {
            num here = G(alternating_sum)(last, dim, c, j, k, t, delta);
            num there = G(alternating_sum)(last, dim, c, j, k, next, delta);
            num above = k < last ? G(alternating_sum)(last, dim, c, j, k + 1, t, delta) : zero;
            if (!divided) {
                same(T, there, add(here, above));
                continue;
            }
            num scale = G(power)(delta, k), scaled = div(above, G(power)(delta, k + 1));
            same(T, div(there, scale), add(div(here, scale), mul(delta, scaled)));
        }
}

CLAIM(printed_lines_step_a_cubic) { G(compare_lines)(T, 0); }

/*
:::{claim} printed_divided_lines_step_a_cubic
:title: The four lines of the table for a cubic, divided by the powers of the step
:zh: 三次曲线规格化差分表的四式
:given: any coefficients of a cubic in space, any $t$ and $\delta\ne0$; the differences at $t$ and at $t+\delta$
:where: $\delta\ne0$
:then: $\frac1{\delta^k}\cdot\Delta^kP_1=\frac1{\delta^k}\cdot\Delta^kP_0+\delta\cdot\frac1{\delta^{k+1}}\cdot\Delta^{k+1}P_0$ for $k=0,1,2$ and
  $\frac1{\delta^3}\cdot\Delta^3P_1=\frac1{\delta^3}\cdot\Delta^3P_0$
:method: Both sides by the alternating sums of the definition; no kernel is used.
:degrees: 3..3
:over: x# y# z#: coefficients; d: δ
:control: the differences at $t+2\delta$
:::
*/
CLAIM(printed_divided_lines_step_a_cubic) { G(compare_lines)(T, 1); }

/*
:::{statement} hu-1987:1-4-stepping
:title: All points by repeated additions
:zh: 反复加法求各点
:printed: If the differences at $t=0$ are known, the points of the curve at $t=\delta,2\delta,\dots,i\delta,\dots$ are found one after the
  other by repeated additions.
:holds-by: differences_of_a_cubic printed_lines_step_a_cubic table_after_any_number_of_steps
:confirmed-by: step_takes_differences_to_the_next_place additions_step_along_the_curve
:figure: forward_differences
:::

:::{claim} table_after_any_number_of_steps
:title: The table of a cubic after any number of steps, and at the other end
:zh: 任意步之后的差分表
:given: any four rows $d_0,\dots,d_3$, one coordinate, any number $i$ of steps, $\binom ij$ as a polynomial in $i$; and the differences of a cubic at
  $t=0$, $D$, $A\delta^3+B\delta^2+C\delta$, $6A\delta^3+2B\delta^2$, $6A\delta^3$, any $A,B,C,D$ and $\delta$
:then: if the rows after $i$ steps are $\sum_j\binom ijd_{k+j}$, as they are for $i=0$, they are these sums with $i+1$ after one more; the first row of the cubic is then
  $P(i\delta)$, so for $i\delta=1$ it is $P(1)=A+B+C+D$
:method: No step, and one step of the table with everything a variable; then induction.
:degrees: 3..3
:scope: every number of steps
:over: d#: differences; i e: -; c#: coefficients
:control: $\binom i3$ left out
:::
*/
/* binom(i, j) for j <= 3 */
static num G(binomial_in)(num i, int j)
{
    num product = from_int(1);
    for (int m = 0; m < j; m++)
        product = mul(product, div(sub(i, from_int(m)), from_int(m + 1)));
    return product;
}

/* Row k after i steps. */
static num G(row_after)(const trial *T, const num d[4], int k, num i)
{
    num sum = from_int(0);
    for (int j = 0; k + j <= 3; j++)
        if (!fault(T, 0, j == 3))
            sum = add(sum, mul(G(binomial_in)(i, j), d[k + j]));
    return sum;
}

CLAIM(table_after_any_number_of_steps)
{
    num d[4], row[4], c[4], i = whole(T, "i", 0, 40), next = add(i, from_int(1)), delta = unknown(T, "e", 0);
    for (int k = 0; k < 4; k++) {
        d[k] = unknown(T, "d", k);
        c[k] = unknown(T, "c", k);
    }
    about(T, "no step");
    for (int k = 0; k < 4; k++) {
        same(T, G(row_after)(T, d, k, from_int(0)), d[k]);
        row[k] = G(row_after)(T, d, k, i);
    }
    G(power_difference_step)(3, 1, row);
    about(T, "one more step");
    for (int k = 0; k < 4; k++)
        same(T, row[k], G(row_after)(T, d, k, next));
    num square = mul(delta, delta), cube = mul(square, delta), six_A = mul(from_int(6), mul(c[3], cube));
    num of_cubic[4] = {c[0], add(add(mul(c[3], cube), mul(c[2], square)), mul(c[1], delta)),
                       add(six_A, mul(from_int(2), mul(c[2], square))), six_A};
    about(T, "the first row of a cubic");
    same(T, G(row_after)(T, of_cubic, 0, i), G(power_sum)(3, 1, c, 0, mul(i, delta)));
}

/*

So a point costs $n$ additions for each coordinate.  The claim of the source that multiplications are not needed at all
is about more than the step, because the table has to be begun.  With $\delta=2^{-m}$ its first column is made by shifts
and additions; with another step it is not.

:::{statement} hu-1987:1-4-no-multiplications
:title: With differences no multiplication is left
:zh: 差分法不用乘法
:printed: With differences multiplications are not needed at all, only shifts and additions, so that the curve wanted can be generated at high speed.
:holds-by: step_costs_additions_only table_costs_shifts_and_additions rows_by_shifts_are_the_table step_takes_differences_to_the_next_place
  table_after_any_number_of_steps table_is_whole_in_units_of_the_cube
:meant: the words "so that" (从而) | High speed is: without multiplications.
:needs: other_steps_need_multiplications | the sentence behind (1-4-4), $\delta=1/2^m$ with a positive whole number $m$ | $\delta=2^{-m}$: so that the
  table (1-4-5) is begun by shifts, and the divided step (1-4-4) takes shifts.  The step (1-4-3) without division has additions only, whatever
  $\delta$ is.
:hypothesis: short_words_lose_the_end | the machine's words are long enough: a shift that drops bits is no product, and the curve would be another one.  With $3m$ binary
  places behind the point more than the coefficients have, and room before it, they hold every row exactly.  Words with 8 places may lose the end.
:figure: stepping_and_rounding

The table is made for each coordinate alone.  Products with a sum of few powers of two, such as $\frac34$, are shifts and additions as
well; a step $\delta=\frac1n$ with a whole $n$ is such a sum only if it is a power of two itself.
:::
*/

/* (1-4-5) as shifts and additions: e from c = (D, C, B, A), 3A as 2A + A. */
#define TABLE_BY_SHIFTS(S)                                                                                             \
    static void table_by_shifts_##S(const num_##S c[], num_##S delta, num_##S e[])                                     \
    {                                                                                                                  \
        num_##S two = from_int_##S(2), three_A = add_##S(mul_##S(two, c[3]), c[3]);                                    \
        e[0] = c[0];                                                                                                   \
        e[1] = add_##S(mul_##S(add_##S(mul_##S(c[3], delta), c[2]), delta), c[1]);                                     \
        e[2] = mul_##S(two, add_##S(mul_##S(three_A, delta), c[2]));                                                   \
        e[3] = mul_##S(two, three_A);                                                                                  \
    }
#if FIELD
TABLE_BY_SHIFTS(f)
#endif
#if RATIONAL
TABLE_BY_SHIFTS(q)
TABLE_BY_SHIFTS(c)
#endif
#if INTERVAL
TABLE_BY_SHIFTS(i)
#endif
#if DOUBLE
TABLE_BY_SHIFTS(m)
#endif

/*
:::{claim} rows_by_shifts_are_the_table
:title: The rows that are formed by shifts are the table to begin with, for every δ
:zh: 移位所得各行即初始差分表
:given: the cubic $P(t)=At^3+Bt^2+Ct+D$ with any $A,B,C,D$, one coordinate, any $\delta\ne0$; the rows $D$, $(A\delta+B)\delta+C$, $2(A'\delta+B)$ and $2A'$ with $A'=2A+A$
:where: $\delta\ne0$
:then: they are $P_0$, $\frac1\delta\cdot\Delta P_0$, $\frac1{\delta^2}\cdot\Delta^2P_0$, $\frac1{\delta^3}\cdot\Delta^3P_0$
:method: The table by the kernel, divided by the powers of $\delta$, everything a variable.
:degrees: 3..3
:over: c#: coefficients; d: δ
:control: the coefficients taken backwards
:::
*/
CLAIM(rows_by_shifts_are_the_table)
{
    num x[4], used[4], table[4], d[4], delta = positive(T, "d", 0), power = from_int(1);
    for (int k = 0; k < 4; k++)
        x[k] = unknown(T, "c", k);
    for (int k = 0; k < 4; k++)
        used[k] = x[fault(T, k, 3 - k)];
    G(table_by_shifts)(used, delta, table);
    G(power_differences)(3, 1, x, delta, d);
    for (int k = 0; k < 4; k++, power = mul(power, delta))
        same(T, table[k], div(d[k], power));
}

#if RATIONAL
static struct operations cost_of_step(trial *T, int n, int dim, int scaled, int power_of_two)
{
    num_c d[(MAX_DEGREE + 1) * MAX_DIM], delta = {power_of_two};
    num_q x[(MAX_DEGREE + 1) * MAX_DIM], step = power_of_two ? from_ratio_q(1, 256) : parameter_q(T, "d");
    for (int m = 0; m < (n + 1) * dim; m++) {
        d[m] = some_number;
        x[m] = unknown_q(T, "e", m);
    }
    counted = (struct operations){0};
    if (scaled) {
        power_scaled_difference_step_c(n, dim, delta, d);
        power_scaled_difference_step_q(n, dim, step, x);
    } else {
        power_difference_step_c(n, dim, d);
        power_difference_step_q(n, dim, x);
    }
    note_cost((n + 1) * dim, x, counted);
    return counted;
}

/*
:::{claim} step_costs_additions_only
:title: A step costs n additions for each coordinate, and, scaled, n shifts
:zh: 每步的加法与移位次数
:kind: decision
:given: degree $n$, $d=1,2,3$ coordinates, $\delta=2^{-m}$
:where: $\delta=2^{-m}$
:data: D = 3
:then: `power_difference_step` costs $nd$ additions and nothing else, `power_scaled_difference_step` $nd$ additions and $nd$ shifts
:method: The kernels are run in the number type that counts, which knows of $\delta$ only that it is a power of two.
:degrees: 1..12
:scope: one to three coordinates
:control: one addition more in the unscaled step, one shift more in the scaled one
:::
*/
CLAIM(step_costs_additions_only)
{
    int n = T->degree, most = given_whole(T, "D"), wrong = fault(T, 0, 1); /* one addition too many is expected */
    for (int d = 1; d <= most; d++) {
        struct operations plain = cost_of_step(T, n, d, 0, 1), scaled = cost_of_step(T, n, d, 1, 1);
        agree(T, plain.additions == n * d + wrong && plain.multiplications == 0 && plain.shifts == 0);
        agree(T, scaled.additions == n * d && scaled.multiplications == 0 && scaled.shifts == n * d + wrong);
    }
}

/*
:::{claim} table_costs_shifts_and_additions
:title: The table of a cubic costs shifts and additions
:zh: 建立差分表的运算次数
:kind: decision
:given: one coordinate, $\delta=2^{-m}$, the rows of (1-4-5) as $D$, $(A\delta+B)\delta+C$, $2(A'\delta+B)$ and $2A'$ with $A'=2A+A$
:where: $\delta=2^{-m}$
:data: δ = 1/256
:then: shifts and additions, and no multiplication
:result: shifts = 6; additions = 4; multiplications = 0
:method: The rows are formed in the number type that counts, which knows of $\delta$ only that it is a power of two, and beside it in rationals for
  one $\delta$.  That they are the printed ones for every $\delta$ is `rows_by_shifts_are_the_table`.
:degrees: 3..3
:control: a step that is no power of two
:::
*/
CLAIM(table_costs_shifts_and_additions)
{
    num_c c[4] = {some_number, some_number, some_number, some_number}, e[4], step = {fault(T, 1, 0)};
    num x[4], table[4];
    for (int k = 0; k < 4; k++)
        x[k] = unknown(T, "c", k);
    table_by_shifts_q(x, given(T, "δ"), table);
    counted = (struct operations){0};
    table_by_shifts_c(c, step, e);
    if (!T->faulty)
        note_cost(4, table, counted);
    agree(T, counted.multiplications == 0 && counted.divisions == 0);
    found_whole(T, "shifts", counted.shifts);
    found_whole(T, "additions", counted.additions);
    found_whole(T, "multiplications", counted.multiplications);
}

/*
:::{claim} other_steps_need_multiplications
:title: For other steps the products remain
:zh: 一般步长仍需乘法
:kind: counterexample
:given: a step $\delta$ that is no power of two, a curve of degree $n$, one coordinate, the beginning of the table (1-4-5) and one step of (1-4-4)
:data: n = 3
:then: the products with $\delta$ in the table, and one for each difference in the step, are multiplications
:result: products of the table = 3; products of the step = 3
:method: The rows as in `table_costs_shifts_and_additions` and the kernel are run in the number type that counts.
:control: a power of two
:::
*/
CLAIM(other_steps_need_multiplications)
{
    num_c c[4] = {some_number, some_number, some_number, some_number}, e[4], delta = {fault(T, 1, 0)};
    counted = (struct operations){0};
    table_by_shifts_c(c, delta, e);
    int of_table = counted.multiplications;
    struct operations step = cost_of_step(T, given_whole(T, "n"), 1, 1, fault(T, 1, 0));
    found_whole(T, "products of the table", of_table);
    found_whole(T, "products of the step", step.multiplications);
    about(T, "the table or the step has no multiplication");
    agree(T, of_table == 0 || step.multiplications == 0);
}
#endif

#include "chapters/judge/claims_off.h"
