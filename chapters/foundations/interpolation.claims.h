/*
# Through the data, or near them (插值与逼近)

Section 1-1 of the source distinguishes two ways to make a curve from data, and gives both one name.  They are different
requirements: a curve through all data may be none of the simple curves that are nearest to them, and the nearest simple one
may meet none of them.
*/
#include "chapters/foundations/definition.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} hu-1987:1-1-interpolation
:title: Interpolation
:zh: 插值的定义
:definition: yes
:printed: To construct a function that passes through the given data one after the other is called interpolation; the curve passes through
  all of them strictly.
:checked-by: one_cubic_passes_through_four_data
:figure: through_and_near
:::

:::{claim} one_cubic_passes_through_four_data
:title: Through n+1 data at the parameters 0, 1, ..., n passes one curve of degree n
:zh: n+1 个型值点唯一确定 n 次插值曲线
:given: data $p_0,\dots,p_n$, any numbers
:then: $P(t)=\sum_k\binom tk\Delta^kp_0$ has $P(i)=p_i$; and the data of any curve of degree $n$ give that curve back, so there is no other
:method: The differences of the data by $n$ passes of subtraction, $\binom tk=\frac{t(t-1)\cdots(t-k+1)}{k!}$; at the $n+1$ places, and at a
  variable $t$ for the values of a curve with variable coefficients.  Other parameters and other kinds of data need other formulas.
:degrees: 1..6 sampled 10
:control: the last difference left out
:::
*/
/* t (t-1) ... (t-k+1) / k! */
static num G(binomial_of)(num t, int k)
{
    num product = from_int(1);
    for (int i = 0; i < k; i++)
        product = mul(product, div(sub(t, from_int(i)), from_int(i + 1)));
    return product;
}

/* The sum of binom(t, k) d_k. */
static num G(newton_sum)(int n, const num d[], num t)
{
    num sum = from_int(0);
    for (int k = 0; k <= n; k++)
        sum = add(sum, mul(G(binomial_of)(t, k), d[k]));
    return sum;
}

/* The data become their differences at the first place. */
static void G(differences_of_data)(int n, num p[])
{
    for (int k = 1; k <= n; k++)
        for (int i = n; i >= k; i--)
            p[i] = sub(p[i], p[i - 1]);
}

CLAIM(one_cubic_passes_through_four_data)
{
    int n = T->degree;
    num p[MAX_DEGREE + 1], d[MAX_DEGREE + 1], c[MAX_DEGREE + 1], t = parameter(T, "t");
    for (int i = 0; i <= n; i++)
        d[i] = p[i] = unknown(T, "p", i);
    G(differences_of_data)(n, d);
    d[n] = fault(T, d[n], from_int(0));
    for (int i = 0; i <= n; i++)
        same(T, G(newton_sum)(n, d, from_int(i)), p[i]);
    G(free_points)(T, n, 1, c);
    for (int i = 0; i <= n; i++)
        d[i] = G(power_sum)(n, 1, c, 0, from_int(i));
    G(differences_of_data)(n, d);
    same(T, G(newton_sum)(n, d, t), G(power_sum)(n, 1, c, 0, t));
}

/*
:::{statement} hu-1987:1-1-approximation
:title: Approximation
:zh: 逼近的定义
:definition: yes
:printed: Approximation does not require that the curve passes through all data strictly, but only that it is nearest to them as a whole.
:checked-by: nearest_line_meets_no_datum
:figure: through_and_near

What "nearest as a whole" means has to be said; here it is the least sum of squares.
:::

:::{statement} hu-1987:1-1-fitting
:title: Fitting is the common name of both
:zh: 拟合的定义
:definition: yes
:printed: Interpolation and approximation of curves and surfaces together are called fitting.
:checked-by: one_cubic_passes_through_four_data nearest_line_meets_no_datum
:figure: through_and_near
:::
*/

#if RATIONAL
/*
:::{claim} nearest_line_meets_no_datum
:title: The line nearest to three data meets none of them
:zh: 最小二乘直线不过型值点
:kind: decision
:given: the data 0, 1, 0 at $t=0,1,2$; lines $a+bt$
:then: with $a=\frac13+\alpha$, $b=\beta$ the sum of the squares of the distances is $\frac23+3\alpha^2+6\alpha\beta+5\beta^2$, and
  $3\alpha^2+6\alpha\beta+5\beta^2=3(\alpha+\beta)^2+2\beta^2$: the line $\frac13$ is the only nearest one, and meets no datum
:method: The two expressions are compared at 6 pairs $(\alpha,\beta)$ that determine a polynomial of degree 2 in two variables; the
  distances of the line from the data are not 0.
:control: the line $\frac12$
:::
*/
CLAIM(nearest_line_meets_no_datum)
{
    static const int data[3] = {0, 1, 0}, pairs[6][2] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {-1, 0}, {0, -1}};
    num level = fault(T, from_ratio(1, 3), from_ratio(1, 2));
    for (int k = 0; k < 6; k++) {
        num alpha = from_int(pairs[k][0]), beta = from_int(pairs[k][1]), sum = from_int(0);
        for (int t = 0; t < 3; t++) {
            num gap = sub(add(add(level, alpha), mul(beta, from_int(t))), from_int(data[t]));
            sum = add(sum, mul(gap, gap));
        }
        num both = add(alpha, beta);
        num squares = add(mul(from_int(3), mul(both, both)), mul(from_int(2), mul(beta, beta)));
        same(T, sum, add(from_ratio(2, 3), squares));
    }
    for (int t = 0; t < 3; t++)
        agree(T, !equal_q(level, from_int(data[t])));
}
#endif

#include "chapters/judge/claims_off.h"
