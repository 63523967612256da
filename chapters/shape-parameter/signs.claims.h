/*
# Signs, maxima, and slopes (非负性、单峰性、对 β 的单调性)
*/
#include "exact/record/roots.h"

#include "chapters/shape-parameter/definition.h"

#include "chapters/judge/claims_on.h"

/*
Three properties are printed for all $\beta$ from $-7$ to 1: the functions are not negative, each has one maximum, and each
grows or falls with $\beta$.  All three are questions about signs, and all three come down to the two numbers $\nu_i$ and
$\varphi_i$ of each function.  These are linear in $\beta$.  So what looks like a question about eight polynomials of degree
eight and a parameter is one about sixteen straight lines, and can be answered exactly.

## Nonnegativity (非负性)

Function $i$ has the sign of $\nu_is+\varphi_it$ in $(0,1)$.  So it is nonnegative exactly when $\nu_i\ge0$ and
$\varphi_i\ge0$, and these are sixteen inequalities in $\beta$.  Those of $i=0$ and $i=7$ say $\beta\le1$, those of $i=1$ and
$i=6$ say $\beta\ge-7$; the source stops there.  Those of $i=2$ and $i=5$ say $21+4\beta\ge0$.

:::{statement} deng-zhang-2022:property-2.1
:title: The functions are not negative
:zh: 非负性，式 (2)
:printed: $B_{i,7}\ge0$, $i=0,\dots,7$ (definition 2.1: $t\in[0,1]$, $-7\le\beta\le1$)
:refuted-by: third_function_is_negative
:class: false
:corrected: all eight functions, printed or corrected (`sec-2-properties`), are nonnegative on $[0,1]$ exactly for $-\frac{21}4\le\beta\le1$
:corrected-by: nonnegative_exactly_in_the_range
:confirmed-by: range_of_every_degree
:figure: negative_function
:striking: 8
:::
*/

#if RATIONAL
/*
:::{claim} third_function_is_negative
:title: At beta = -7 the third function is negative near t = 0
:zh: β=-7 时 B_2 在 t=0 附近为负
:kind: counterexample
:data: β = -7; t = 1/10
:instead: β = -21/4
:result: B_2(t) = -413343/100000000
:given: the left end of the printed range of $\beta$, and a small $t$
:then: $\hat B_2(t)<0$
:method: The value of the printed formula.
:control: the left end of the true range
:::
*/
CLAIM(third_function_is_negative)
{
    num beta = given(T, "β"), B[8];
    G(functions_of)(1, 7, beta, given(T, "t"), B);
    found(T, "B_2(t)", B[2]);
    about(T, "B_2(t) >= 0");
    nonnegative(T, B[2]);
}

/*
One negative value refutes the print.  The true range needs both directions: no line is below 0 in it, and at each end
some line passes through 0.  At the left end this is $\nu_2$, and not $\nu_1$, with which the source has stopped.

:::{claim} nonnegative_exactly_in_the_range
:title: The functions are nonnegative exactly for beta from -21/4 to 1
:zh: 非负的充要条件 -21/4≤β≤1
:kind: decision
:data: range of β = -21/4 1
:instead: range of β = -7 1
:given: all real $\beta$; the printed and the corrected functions $(\nu_is+\varphi_it)s^{7-i}t^i$ with $s=1-t$
:then: all $\nu_i\ge0$, $\varphi_i\ge0$ for $-\frac{21}4\le\beta\le1$; $\nu_2<0$ for every smaller and $\varphi_0<0$ for every
  larger $\beta$
:method: Function $i$ is $\nu_is+\varphi_it$ times powers that are positive in $(0,1)$, so it is nonnegative on $[0,1]$ exactly when both numbers
  are.  The sixteen factors are linear polynomials in $\beta$; their signs are decided on the interval, those of $\nu_2$ and
  $\varphi_0$ on the two half-lines by their roots and slopes.
:degrees: 7..7
:scope: every real β
:control: the printed range
:::
*/
CLAIM(nonnegative_exactly_in_the_range)
{
    num range[2];
    given_points(T, "range of β", 2, 1, range);
    num low = range[0], high = range[1];
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        poly near[8], far[8];
        G(factors_in_beta)(printed_ones, 7, near, far);
        for (int i = 0; i <= 7; i++)
            agree(T, is_nonnegative_on(near[i], low, high) && is_nonnegative_on(far[i], low, high));
        agree(T, is_zero_q(poly_value(near[2], low)) && sign_q(poly_coefficient(near[2], 1)) > 0);
        agree(T, is_zero_q(poly_value(far[0], high)) && sign_q(poly_coefficient(far[0], 1)) < 0);
    }
}
#endif

/*
## One maximum (单峰性)

The derivative of function $i$, $1\le i\le n-1$, is $s^{n-i-1}t^{i-1}$ times

$$i\,\nu_i\,s^2+\bigl((i+1)\varphi_i-(n+1-i)\nu_i\bigr)st-(n-i)\,\varphi_i\,t^2.$$

Divided by $st$ it is a function of $t/s$ that falls when $\nu_i,\varphi_i\ge0$, not both $0$.  At $t=\frac i{n+1}$ the summand with
$\nu_i$ has its own maximum and that with $\varphi_i$ still rises, at $t=\frac{i+1}{n+1}$ the first falls and the second has its maximum: the
one maximum of the function is between these two.

:::{statement} deng-zhang-2022:property-2.5
:title: Each function has one local maximum
:zh: 单峰性
:printed: having one peak (单峰性): each of the basis functions has a local maximum on $[0,1]$ (definition 2.1: $-7\le\beta\le1$)
:refuted-by: third_function_has_two_maxima
:class: false
:corrected: for $-\frac{21}4\le\beta\le1$ each function, printed or corrected (`sec-2-properties`), has exactly one local maximum on $[0,1]$ and
  no inner local minimum; for $-7\le\beta<-\frac{21}4$ this is so for all but $B_2$ and $B_5$, which take negative values
  and have one inner maximum, one inner minimum and a maximum at an end
:corrected-by: derivative_of_a_function_factors quadratic_factor_changes_its_sign_once each_function_rises_then_falls
  third_function_falls_then_rises_below_the_range first_function_falls_and_last_rises
:meant: the heading, one peak | Each function has exactly one local maximum on $[0,1]$.
:reading: third_function_falls_then_rises_below_the_range | local maxima in the open interval only, of the functions $i=1,\dots,6$: each has
  exactly one there; $B_0$, which falls, and $B_7$, which rises, have none
:reading-with: derivative_of_a_function_factors quadratic_factor_changes_its_sign_once each_function_rises_then_falls first_function_falls_and_last_rises
:reading: third_function_falls_then_rises_below_the_range | at least one local maximum on $[0,1]$, which every continuous function has: each of the eight
  has one
:reading-with: derivative_of_a_function_factors quadratic_factor_changes_its_sign_once each_function_rises_then_falls first_function_falls_and_last_rises
:figure: negative_function
:::

:::{statement} deng-zhang-2022:property-2.5-proof
:title: One maximum is seen from figure 1 and verified by the derivatives
:zh: 单峰性的论证
:printed: that each function has one local maximum on $[0,1]$ can be judged from figure 1 and verified by differentiating the functions
  (definition 2.1: $-7\le\beta\le1$)
:refuted-by: third_function_has_two_maxima
:class: invalid-proof
:corrected: figure 1 is for one value of $\beta$, $-1$, for which each function, printed or corrected (`sec-2-properties`), has exactly one local
  maximum; the derivatives verify this for $-\frac{21}4\le\beta\le1$, and for $-7\le\beta<-\frac{21}4$ they refute it for $B_2$ and $B_5$
:corrected-by: derivative_of_a_function_factors quadratic_factor_changes_its_sign_once each_function_rises_then_falls
  third_function_falls_then_rises_below_the_range first_function_falls_and_last_rises
:figure: negative_function
:::

:::{claim} derivative_of_a_function_factors
:title: The derivative is a product of powers and a quadratic polynomial
:zh: 基函数导数的分解
:given: any $\nu$ and $\varphi$, $F=(\nu s+\varphi t)s^{n-i}t^i$ with $s=1-t$, $0\le i\le n$
:then: $F'=s^{n-i-1}t^{i-1}\bigl(i\nu s^2+((i+1)\varphi-(n+1-i)\nu)st-(n-i)\varphi t^2\bigr)$ for $1\le i\le n-1$; for $i=0$
  $F'=s^{n-1}\bigl((\varphi-(n+1)\nu)s-n\varphi t\bigr)$, for $i=n$ $F'=t^{n-1}\bigl(n\nu s+((n+1)\varphi-\nu)t\bigr)$
:method: The derivative of the Bézier polynomial with the two coefficients of $F$ against the products; $\nu$, $\varphi$
  and $t$ are variables.
:degrees: 2..9 sampled 14
:over: v w: linear factor
:control: the factor $i+1$ replaced by $i$
:::
*/
CLAIM(derivative_of_a_function_factors)
{
    int n = T->degree;
    num near = unknown(T, "v", 0), far = unknown(T, "w", 0), t = parameter(T, "t"), s = sub(from_int(1), t);
    for (int i = 0; i <= n; i++) {
        num column[MAX_DEGREE + 2], D[2], value;
        for (int k = 0; k <= n + 1; k++)
            column[k] = from_int(0);
        column[i] = div(near, G(choose)(n + 1, i));
        column[i + 1] = div(far, G(choose)(n + 1, i + 1));
        G(bezier_derivatives)(n + 1, 1, column, t, 1, D);
        int up = fault(T, i + 1, i);
        num last = mul(from_int(-(n - i)), far);
        if (i == 0) {
            /* F' = s^{n-1} ((φ - (n+1) ν) s - n φ t) */
            num first = sub(mul(from_int(up), far), mul(from_int(n + 1), near));
            value = mul(G(product_of_powers)(n - 1, 0, t), add(mul(first, s), mul(last, t)));
        } else if (i == n) {
            /* F' = t^{n-1} (n ν s + ((n+1) φ - ν) t) */
            num first = mul(from_int(n), near), middle = sub(mul(from_int(up), far), near);
            value = mul(G(product_of_powers)(0, n - 1, t), add(mul(first, s), mul(middle, t)));
        } else {
            /* F' = s^{n-i-1} t^{i-1} (i ν s² + ((i+1) φ - (n+1-i) ν) st - (n-i) φ t²) */
            num first = mul(from_int(i), near), middle = sub(mul(from_int(up), far), mul(from_int(n + 1 - i), near));
            num quadratic = add(mul(first, mul(s, s)), add(mul(middle, mul(s, t)), mul(last, mul(t, t))));
            value = mul(G(product_of_powers)(n - i - 1, i - 1, t), quadratic);
        }
        same(T, D[1], value);
    }
}

#if FIELD || RATIONAL
/*
:::{claim} quadratic_factor_changes_its_sign_once
:title: Between 0 and 1 the quadratic factor changes its sign once, from plus to minus
:zh: 二次因子在 (0,1) 内恰由正变负一次
:given: integers $0<i<n$; $\nu,\varphi\ge0$, not both 0; $x=\frac ts>0$ and $h>0$
:then: the factor divided by $st$, $g(x)=\frac{i\nu}x+(i+1)\varphi-(n+1-i)\nu-(n-i)\varphi x$, has $g(x)>g(x+h)$; at $t=\frac i{n+1}$ it is
  $\frac{n+1}{n+1-i}\cdot\varphi$, at $t=\frac{i+1}{n+1}$ it is $-\frac{n+1}{i+1}\cdot\nu$
:method: $i$, $n-i$, $\nu$, $\varphi$, $x$, $h$ are positive variables; then one of $\nu$, $\varphi$ is 0.  The difference has coefficients of one
  sign, the two values are identities.  A function that falls, is not negative at one place and not positive at a later one, changes its
  sign once from the one to the other.
:types: field rational
:degrees: all from 2
:over: i j: -; v w: linear factor; x h: -
:control: $x$ and $x+h$ exchanged
:::
*/
CLAIM(quadratic_factor_changes_its_sign_once)
{
    num i = positive(T, "i", ALONE), j = positive(T, "j", ALONE), x = positive(T, "x", ALONE),
        h = positive(T, "h", ALONE);
    num one = from_int(1), zero = from_int(0), next = add(i, one), before = add(j, one), n_and_one = add(i, before);
    for (int left_out = 0; left_out <= 2; left_out++) { /* neither; ν; φ */
        num near = left_out == 1 ? zero : positive(T, "v", 0), far = left_out == 2 ? zero : positive(T, "w", 0);
        num at[4] = {fault(T, x, add(x, h)), fault(T, add(x, h), x), div(i, before), div(next, j)}, g[4];
        for (int k = 0; k < 4; k++) {
            /* g(x) = i ν/x + (i+1) φ - (n+1-i) ν - (n-i) φ x */
            num constant = sub(mul(next, far), mul(before, near));
            g[k] = add(div(mul(i, near), at[k]), sub(constant, mul(mul(j, far), at[k])));
        }
        about(T, "how much the quotient falls");
        G(must_be_positive)(T, sub(g[0], g[1]));
        about(T, "its values at t = i/(n+1) and (i+1)/(n+1)");
        same(T, g[2], div(mul(n_and_one, far), before));
        same(T, g[3], neg(div(mul(n_and_one, near), next)));
    }
}
#endif

#if RATIONAL
/*
:::{claim} each_function_rises_then_falls
:title: For beta from -21/4 to 1 each of the six inner functions rises and then falls
:zh: -21/4≤β≤1 时 B_1,…,B_6 单峰
:kind: decision
:data: range of β = -21/4 1
:instead: range of β = -7 1
:given: $-\frac{21}4\le\beta\le1$, the printed and the corrected functions $(\nu_is+\varphi_it)s^{n-i}t^i$
:then: for $0<i<n$: $\nu_i\ge0$, $\varphi_i\ge0$ and $\nu_i+\varphi_i>0$, so that the quadratic factor of the derivative changes its sign once
  in $(0,1)$, from plus to minus; function $i$, which is 0 at both ends, rises and then falls
:method: The signs of linear polynomials in $\beta$, decided on the interval.
:degrees: 7..7
:scope: −21/4 ≤ β ≤ 1
:control: the printed range
:::
*/
CLAIM(each_function_rises_then_falls)
{
    num range[2];
    given_points(T, "range of β", 2, 1, range);
    num low = range[0], high = range[1];
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        poly near[8], far[8];
        G(factors_in_beta)(printed_ones, 7, near, far);
        for (int i = 1; i <= 6; i++) {
            agree(T, is_nonnegative_on(near[i], low, high) && is_nonnegative_on(far[i], low, high));
            agree(T, sign_on(poly_add(near[i], far[i]), low, high, CLOSED) == SIGN_POSITIVE);
        }
    }
}

/*
The first and the last function need less: the factor of their derivative is linear, and its two values have one sign in all of the
printed range.

:::{claim} first_function_falls_and_last_rises
:title: In the printed range the first function falls and the last one rises
:zh: -7≤β≤1 时 B_0 递减、B_7 递增
:kind: decision
:data: range of β = -7 1
:instead: range of β = -8 1
:given: the printed range of $\beta$, the printed and the corrected functions, $n=7$
:then: $\varphi_0-(n+1)\nu_0\le0$ and $-n\varphi_0\le0$, not both 0, so that the linear factor of the derivative is negative in $(0,1)$, and
  $\nu_0=1$: $B_0$ falls from 1 to 0; $n\nu_n\ge0$ and $(n+1)\varphi_n-\nu_n\ge0$, not both 0, and $\varphi_n=1$: $B_n$ rises from 0 to 1
:method: The signs of linear polynomials in $\beta$, decided on the interval.
:degrees: 7..7
:scope: −7 ≤ β ≤ 1
:control: a range that begins 1 below
:::
*/
CLAIM(first_function_falls_and_last_rises)
{
    num range[2], minus_seven = from_int(-7), eight = from_int(8);
    given_points(T, "range of β", 2, 1, range);
    num low = range[0], high = range[1];
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        poly near[8], far[8];
        G(factors_in_beta)(printed_ones, 7, near, far);
        poly falls[2] = {poly_sub(far[0], poly_scale(near[0], eight)), poly_scale(far[0], minus_seven)};
        poly rises[2] = {poly_scale(near[7], from_int(7)), poly_sub(poly_scale(far[7], eight), near[7])};
        agree(T, is_nonnegative_on(poly_neg(falls[0]), low, high) && is_nonnegative_on(poly_neg(falls[1]), low, high));
        agree(T, sign_on(poly_add(falls[0], falls[1]), low, high, CLOSED) == SIGN_NEGATIVE);
        agree(T, is_nonnegative_on(rises[0], low, high) && is_nonnegative_on(rises[1], low, high));
        agree(T, sign_on(poly_add(rises[0], rises[1]), low, high, CLOSED) == SIGN_POSITIVE);
        agree(T, poly_equal(near[0], poly_constant(from_int(1))) && poly_equal(far[7], poly_constant(from_int(1))));
    }
}

/*
Below the true range the argument breaks for $i=2$ and $i=5$ alone: $\nu_2$ and $\varphi_5$ are negative.  Function 2 then begins with 0,
falls, and has to rise again.

:::{claim} third_function_falls_then_rises_below_the_range
:title: For beta from -7 to below -21/4 two of the six inner functions have an inner minimum too, the other four one inner maximum alone
:zh: -7≤β<-21/4 时的极值
:kind: decision
:data: range of β = -7 -21/4
:instead: range of β = -7 -5
:given: $-7\le\beta<-\frac{21}4$; the corrected and the printed functions $(\nu_is+\varphi_it)s^{n-i}t^i$ with $s=1-t$
:then: $\nu_2<0<\varphi_2$, so that $B_2$ falls from $B_2(0)=0$, rises and falls again to $B_2(1)=0$: one inner minimum,
  one inner maximum, and a local maximum at $t=0$; $\varphi_5<0<\nu_5$, so that $B_5$ rises from 0, falls and rises again to 0, with a
  local maximum at $t=1$; for all other $i$ with $0<i<n$ still $\nu_i,\varphi_i\ge0$ and not both $0$, so that function $i$ rises and then falls
:method: Signs of linear and quadratic polynomials in $\beta$ on the interval.  The quadratic factor of the derivative divided by $s^2$ is
  $i\nu_i+mx-(n-i)\varphi_ix^2$ with $m=(i+1)\varphi_i-(n+1-i)\nu_i$ and $x=\frac ts$.  For $i=2$ and $i=5$ its discriminant
  is positive, and $m$ has the sign of $\varphi_i$, the other one than $\nu_i$: two different roots, with positive sum and product,
  so both are positive, and at each the sign changes.
:degrees: 7..7
:scope: −7 ≤ β < −21/4
:control: an interval that reaches into the true range
:::
*/
CLAIM(third_function_falls_then_rises_below_the_range)
{
    num range[2];
    given_points(T, "range of β", 2, 1, range);
    num low = range[0], high = range[1];
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        poly near[8], far[8];
        G(factors_in_beta)(printed_ones, 7, near, far);
        agree(T, sign_on(near[2], low, high, OPEN_RIGHT) == SIGN_NEGATIVE);
        agree(T, sign_on(far[2], low, high, CLOSED) == SIGN_POSITIVE);
        agree(T, sign_on(near[5], low, high, CLOSED) == SIGN_POSITIVE);
        agree(T, sign_on(far[5], low, high, OPEN_RIGHT) == SIGN_NEGATIVE);
        for (int i = 2; i <= 5; i += 3) {
            poly middle = poly_sub(poly_scale(far[i], from_int(i + 1)), poly_scale(near[i], from_int(8 - i)));
            poly product = poly_scale(poly_mul(near[i], far[i]), from_int(4 * i * (7 - i)));
            agree(T, sign_on(middle, low, high, CLOSED) == (i == 2 ? SIGN_POSITIVE : SIGN_NEGATIVE));
            agree(T, sign_on(poly_add(poly_mul(middle, middle), product), low, high, CLOSED) == SIGN_POSITIVE);
        }
        for (int i = 1; i <= 6; i++)
            if (i != 2 && i != 5) {
                agree(T, is_nonnegative_on(near[i], low, high) && is_nonnegative_on(far[i], low, high));
                agree(T, sign_on(poly_add(near[i], far[i]), low, high, CLOSED) == SIGN_POSITIVE);
            }
    }
}

/*
:::{claim} third_function_has_two_maxima
:title: At beta = -7 the third function has two local maxima on [0,1]
:zh: β=-7 时 B_2 在 [0,1] 上有两个局部极大值
:kind: counterexample
:data: β = -7
:instead: β = -1
:result: B_2'(t) = "-504*t^7 + 2254*t^6 - 3990*t^5 + 3500*t^4 - 1540*t^3 + 294*t^2 - 14*t"; its roots in (0,1) = 2;
  local maxima on [0,1] = 2
:given: the left end of the printed range, and $\hat B_2$
:then: the derivative is negative near $t=0$ and changes its sign at both roots in $(0,1)$: the local maxima on $[0,1]$ are
  $t=0$ and the last root
:method: The roots of the exact derivative and its changes of sign are counted, and its sign near 0 is that of its first coefficient that is not 0.
:control: the value of figure 1
:::
*/
CLAIM(third_function_has_two_maxima)
{
    poly D = poly_derivative(G(function)(1, 7, 2, given(T, "β")));
    struct cagd_root_count roots = count_roots(D, from_int(0), from_int(1), OPEN);
    int falls_first = 0;
    for (int k = poly_degree(D); k >= 0; k--)
        if (!is_zero_q(poly_coefficient(D, k)))
            falls_first = sign_q(poly_coefficient(D, k)) < 0;
    int maxima = falls_first + (roots.crossings + !falls_first) / 2;
    found_text(T, "B_2'(t)", poly_to_string(D, "t"));
    found_whole(T, "its roots in (0,1)", roots.distinct);
    found_whole(T, "local maxima on [0,1]", maxima);
    about(T, "there is one local maximum on [0,1]: the inner ones and t = 0 together");
    agree(T, maxima == 1);
}
#endif

/*
## Monotone in the parameter (对 β 的单调性)

For fixed $t$ every function is linear in $\beta$, with the slope $(a_is-a_{i+1}t)s^{n-i}t^i$.  The slope changes its sign at
$t=\frac{a_i}{a_i+a_{i+1}}$ when $a_i$ and $a_{i+1}$ have one sign.

:::{statement} deng-zhang-2022:property-2.6
:title: How the functions depend on beta
:zh: 对 β 的单调性
:printed: for fixed $t$, $B_{0,7}(t)$ and $B_{7,7}(t)$ are decreasing functions of $\beta$, and $B_{1,7}(t),\dots,B_{6,7}(t)$ increasing ones
  (definition 2.1: $t\in[0,1]$, $-7\le\beta\le1$)
:refuted-by: second_function_decreases
:class: false
:corrected: for $0<t<1$: $B_0$ and $B_7$ decrease; $B_1$ increases exactly for $t<\frac15$, $B_2$ for $t<\frac49$, $B_5$ for
  $t>\frac59$, $B_6$ for $t>\frac45$, and on the other side of these points they decrease; the corrected $B_3$ and $B_4$ (`sec-2-properties`) increase.  Of the
  printed ones $\hat B_4$ increases, and $\hat B_3$ exactly for $t<\frac59$
:corrected-by: slopes_in_beta signs_of_the_slopes
:figure: slopes_in_beta
:striking: 9

Five of the eight printed functions do not behave as printed: $\hat B_1,\hat B_2,\hat B_3,\hat B_5,\hat B_6$.
:::
*/

#if RATIONAL
/*
:::{claim} second_function_decreases
:title: At t = 1/2 the second function decreases with beta
:zh: t=1/2 时 B_1 随 β 递减
:kind: counterexample
:data: t = 1/2; β = 0 1
:instead: t = 1/6
:result: B_1(t) = 7/128 11/256
:given: the middle of the interval, and two values of $\beta$
:then: $\hat B_1(t)$ is smaller for the larger $\beta$
:method: Both values of the printed formula; their difference is asked to be nonnegative.
:control: a $t$ to the left of the point where the slope in $\beta$ changes its sign
:::
*/
CLAIM(second_function_decreases)
{
    num t = given(T, "t"), beta[2], value[2], B[8];
    given_points(T, "β", 2, 1, beta);
    for (int k = 0; k < 2; k++) {
        G(functions_of)(1, 7, beta[k], t, B);
        value[k] = B[1];
    }
    found_points(T, "B_1(t)", 2, 1, value);
    about(T, "B_1(t) does not decrease");
    nonnegative(T, sub(value[1], value[0]));
}
#endif

/*
One decreasing value is enough against the print; where exactly each function grows is read off the slopes, which are the
functions at one $\beta$ minus those at another.  The $b_i$ and $c_i$ of this claim are again the printed numbers before
$\beta$ and $\beta t$.

:::{claim} slopes_in_beta
:title: The functions are linear in beta
:zh: 基函数关于 β 是线性的
:data: b = 0 1 4 5 0 -5 -4 -1; c, printed functions = -1 -5 -9 -9 1 9 5 1; c, corrected functions = -1 -5 -9 -5 5 9 5 1
:instead: b = 0 -1 4 5 0 -5 -4 -1
:given: any $\beta$, $h$ and $t$; $b_i$ and $c_i$, the numbers before $\beta$ and $\beta t$ in the linear factor of function $i$, printed or corrected; $s=1-t$
:then: $\hat B_i$ at $\beta+h$ minus $\hat B_i$ at $\beta$ is $h(b_i+c_it)s^{7-i}t^i$; likewise for the corrected
  functions
:method: The kernels at $\beta+h$ and $\beta$, all variables.
:degrees: 7..7
:over: h: step of β
:control: the sign of $b_1$
:::
*/
CLAIM(slopes_in_beta)
{
    num b[8], c[2][8];
    given_points(T, "b", 8, 1, b);
    given_points(T, "c, corrected functions", 8, 1, c[0]);
    given_points(T, "c, printed functions", 8, 1, c[1]);
    num beta = unknown(T, "beta", 0), h = unknown(T, "h", 0), t = parameter(T, "t"), low[2][8], high[2][8];
    G(shape_basis)(7, beta, t, low[0]);
    G(shape_basis)(7, add(beta, h), t, high[0]);
    G(functions_of)(1, 7, beta, t, low[1]);
    G(functions_of)(1, 7, add(beta, h), t, high[1]);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++)
        for (int i = 0; i <= 7; i++) {
            /* h (b_i + c_i t) s^{7-i} t^i */
            num slope = mul(add(b[i], mul(c[printed_ones][i], t)), G(product_of_powers)(7 - i, i, t));
            same(T, sub(high[printed_ones][i], low[printed_ones][i]), mul(h, slope));
        }
}

#if RATIONAL
/*
:::{claim} signs_of_the_slopes
:title: Where each function increases with beta
:zh: 各基函数随 β 的增减区间
:kind: decision
:data: change, corrected functions = 0 1/5 4/9 0 0 5/9 4/5 0; change, printed functions = 0 1/5 4/9 5/9 0 5/9 4/5 0;
  sign before = -1 1 1 1 1 -1 -1 -1
:instead: change, corrected functions = 0 1/6 4/9 0 0 5/9 4/5 0; change, printed functions = 0 1/6 4/9 5/9 0 5/9 4/5 0
:given: the slopes in $\beta$ of the linear factors of the printed and the corrected functions, $b_i+c_it$ with $0<t<1$; for each $i$ a number of
  this interval, or 0 for none, and a sign
:then: the slope has the sign up to the number and the other sign behind it; without a number it has the sign in the whole
  interval
:method: The slopes are the differences of the factors at $\beta=1$ and $\beta=0$; the sign of a linear polynomial on the two
  intervals.
:degrees: 7..7
:scope: every real β, 0 < t < 1
:control: another number for the change of $i=1$
:::
*/
CLAIM(signs_of_the_slopes)
{
    num changes[2][8], signs[8];
    given_points(T, "change, corrected functions", 8, 1, changes[0]);
    given_points(T, "change, printed functions", 8, 1, changes[1]);
    given_points(T, "sign before", 8, 1, signs);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        poly near[8], far[8];
        G(factors_in_beta)(printed_ones, 7, near, far);
        for (int i = 0; i <= 7; i++) {
            num b = poly_coefficient(near[i], 1), c = sub(poly_coefficient(far[i], 1), b);
            poly slope = poly_from_q(2, (num[]){b, c});
            num change = changes[printed_ones][i];
            enum cagd_sign_pattern before = sign_q(signs[i]) > 0 ? SIGN_POSITIVE : SIGN_NEGATIVE;
            enum cagd_sign_pattern after = before == SIGN_POSITIVE ? SIGN_NEGATIVE : SIGN_POSITIVE;
            if (is_zero_q(change)) {
                agree(T, sign_on(slope, from_int(0), from_int(1), OPEN) == before);
            } else {
                agree(T, sign_on(slope, from_int(0), change, OPEN) == before);
                agree(T, sign_on(slope, change, from_int(1), OPEN) == after);
            }
        }
    }
}
#endif

#include "chapters/judge/claims_off.h"
