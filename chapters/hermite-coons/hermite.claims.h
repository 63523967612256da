/*
# Values and derivatives (Hermite 插值)
*/
#include "chapters/hermite-coons/definition.h"

#include "chapters/judge/claims_on.h"

/*
## The cubic with two points and two tangents

The case that matters is the cubic with two values and two slopes.  The slides solve the four equations by brute force and print the
coefficients as sums of many terms.  Such sums are hard to read and easy to misprint; a single missing prime is found by the
simplest data of all, those of a constant.

:::{statement} slides-ch4:2-cubic-system
:title: The four equations for the coefficients of a cubic
:zh: 三次多项式系数的线性方程组
:printed: $P(t)=a_3t^3+a_2t^2+a_1t+a_0$, $t\in[t_0,t_1]$; $f(t_i)=a_3t_i^3+a_2t_i^2+a_1t_i+a_0$,
  $f'(t_i)=3a_3t_i^2+2a_2t_i+a_1$ for $i=0,1$
:holds-by: cubic_equations_are_the_conditions
:figure: nodes_that_meet

In the text at hand the equations have no signs and no primes; those shown here are the four conditions.
:::

:::{claim} cubic_equations_are_the_conditions
:title: The four equations have the determinant (t1 - t0)^4
:zh: 方程组行列式
:given: any $t_0,t_1$ and $a_0,\dots,a_3$
:then: the four right sides are $P(t_0),P(t_1),P'(t_0),P'(t_1)$; ordered as $P(t_0),P'(t_0),P(t_1),P'(t_1)$ their determinant is
  $(t_1-t_0)^4$, so there is exactly one solution if $t_0\ne t_1$ and not otherwise
:method: Everything variable; the right sides against the power form, the determinant by Bird's algorithm.
:over: t#: nodes; a#: coefficients
:control: $t_1^2$ in the place of $2t_1$ in the last equation
:::
*/
CLAIM(cubic_equations_are_the_conditions)
{
    num t[2] = {unknown(T, "t", 0), unknown(T, "t", 1)}, M[16];
    struct G(poly) p = G(free_poly)(T, "a", 3);
    for (int i = 0; i < 2; i++) {
        num square = mul(t[i], t[i]), *row = M + 8 * i;
        num twice = fault(T, mul(from_int(2), t[i]), i == 1 ? square : mul(from_int(2), t[i]));
        row[0] = from_int(1), row[1] = t[i], row[2] = square, row[3] = mul(square, t[i]);
        row[4] = from_int(0), row[5] = from_int(1), row[6] = twice, row[7] = mul(from_int(3), square);
        for (int r = 0; r < 2; r++) {
            num sum = from_int(0);
            for (int k = 0; k < 4; k++)
                sum = add(sum, mul(row[4 * r + k], p.c[k]));
            same(T, sum, G(at)(p, r, t[i]));
        }
    }
    num gap = sub(t[1], t[0]), square = mul(gap, gap);
    about(T, "the determinant");
    same(T, G(determinant)(4, M), mul(square, square));
}

/*
:::{statement} slides-ch4:2-cubic-coefficients
:title: Three of the four coefficients of the cubic
:zh: 系数 a3、a1、a0 的公式
:printed: $a_3=\frac{-(f'(t_1)+f'(t_0))t_0+f'(t_0)t_1+f'(t_1)t_1+2f(t_0)-2f(t_1)}{(t_1-t_0)^3}$;
  $a_1=\frac{(2f'(t_1)t_1^2+f'(t_0)t_1^2-6f(t_1)t_1+6f(t_0)t_1)t_0+f'(t_0)t_1^3}{(t_1-t_0)^3}-\frac{f'(t_1)t_0^3+(f'(t_1)t_1+2f'(t_0)t_1)t_0^2}{(t_1-t_0)^3}$;
  $a_0=-\frac{(f'(t_0)t_1^3+3f(t_0)t_1^2)t_0-f(t_0)t_1^3}{(t_1-t_0)^3}+\frac{(f'(t_1)t_1-f(t_1))t_0^3+(f'(t_0)t_1^2-f'(t_1)t_1^2+3f(t_1)t_1)t_0^2}{(t_1-t_0)^3}$
:holds-by: cubic_coefficients_by_monomials
:needs: equal_ends_have_no_cubic | the problem, which is posed on an interval $[t_0,t_1]$ | $t_0\ne t_1$: the formula divides by $t_1-t_0$, and at equal ends no other will do
:figure: nodes_that_meet

In the text at hand the three formulas have no signs, primes and fraction bars; with those shown here they satisfy the four conditions.
:::
*/

/* A monomial: sign, which of f(t_0), f(t_1), f'(t_0), f'(t_1), and the powers of t_0 and t_1. */
struct G(monomial) {
    int factor, datum, p0, p1;
};

/* The list of a_k, k = 0, ..., 3. */
static const struct G(monomial) G(printed_sum)[4][10] = {
    {{-1, 2, 1, 3},
     {1, 2, 2, 2},
     {-1, 3, 2, 2},
     {1, 3, 3, 1},
     {1, 0, 0, 3},
     {-3, 0, 1, 2},
     {3, 1, 2, 1},
     {-1, 1, 3, 0}},
    {{1, 2, 0, 3},
     {1, 2, 1, 2},
     {-2, 2, 2, 1},
     {2, 3, 1, 2},
     {-1, 3, 2, 1},
     {-1, 3, 3, 0},
     {6, 0, 1, 1},
     {-6, 1, 1, 1}},
    {{-2, 2, 0, 2},
     {1, 2, 1, 1},
     {1, 2, 2, 0},
     {-1, 3, 0, 2},
     {-1, 3, 1, 1},
     {2, 3, 2, 0},
     {-3, 0, 0, 1},
     {-3, 0, 1, 0},
     {3, 1, 0, 1},
     {3, 1, 1, 0}},
    {{1, 2, 0, 1}, {-1, 2, 1, 0}, {1, 3, 0, 1}, {-1, 3, 1, 0}, {2, 0, 0, 0}, {-2, 1, 0, 0}},
};

static num G(value_of)(struct G(monomial) term, num t0, num t1, const num data[4])
{
    num value = mul(from_int(term.factor), data[term.datum]);
    for (int i = 0; i < term.p0; i++)
        value = mul(value, t0);
    for (int i = 0; i < term.p1; i++)
        value = mul(value, t1);
    return value;
}

/* The cubic with these coefficients.  The first monomial of a_2 is multiplied by sign. */
static struct G(poly) G(cubic_of_sums)(num t0, num t1, const num data[4], int sign)
{
    struct G(poly) p = {.n = 3};
    num length = sub(t1, t0), cube = mul(length, mul(length, length));
    for (int k = 0; k <= 3; k++) {
        num sum = from_int(0);
        for (int m = 0; m < 10; m++) {
            struct G(monomial) term = G(printed_sum)[k][m];
            term.factor *= k == 2 && m == 0 ? sign : 1;
            sum = add(sum, G(value_of)(term, t0, t1, data));
        }
        p.c[k] = div(sum, cube);
    }
    return p;
}

/* Compare: the determinant of the four conditions is (t1 - t0)^4, so that no other cubic has the data. */
static void G(no_other_cubic)(trial *T, num t0, num t1)
{
    num M[16], gap = sub(t1, t0), square = mul(gap, gap), one = from_int(1);
    for (int i = 0; i < 2; i++) {
        num t = i == 0 ? t0 : t1, *row = M + 8 * i, tt = mul(t, t);
        row[0] = one, row[1] = t, row[2] = tt, row[3] = mul(tt, t);
        row[4] = from_int(0), row[5] = one, row[6] = add(t, t), row[7] = mul(from_int(3), tt);
    }
    about(T, "the determinant of the conditions");
    same(T, G(determinant)(4, M), mul(square, square));
}

/* The cubic with the coefficients as they are printed, the missing prime of a_2 added. */
static struct G(poly) G(cubic_with_brackets)(num t0, num t1, const num data[4])
{
    num f0 = data[0], f1 = data[1], d0 = data[2], d1 = data[3], two = from_int(2), three = from_int(3),
        six = from_int(6);
    num t00 = mul(t0, t0), t11 = mul(t1, t1), length = sub(t1, t0), cube = mul(length, mul(length, length));
    num a3 = sub(mul(two, f0), mul(two, f1));
    a3 = add(add(neg(mul(add(d1, d0), t0)), add(mul(d0, t1), mul(d1, t1))), a3);
    num first = add(mul(d1, t11), mul(two, mul(d0, t11)));
    first = add(first, sub(mul(three, mul(f0, t1)), mul(three, mul(f1, t1))));
    num bracket = add(sub(mul(d0, t1), mul(d1, t1)), sub(mul(three, f1), mul(three, f0)));
    num a2 = sub(add(mul(add(d0, mul(two, d1)), t00), mul(bracket, t0)), first);
    bracket = add(mul(two, mul(d1, t11)), mul(d0, t11));
    bracket = add(sub(bracket, mul(six, mul(f1, t1))), mul(six, mul(f0, t1)));
    first = add(mul(bracket, t0), mul(d0, mul(t11, t1)));
    num a1 = sub(first, add(mul(d1, mul(t00, t0)), mul(add(mul(d1, t1), mul(two, mul(d0, t1))), t00)));
    bracket = add(mul(d0, mul(t11, t1)), mul(three, mul(f0, t11)));
    first = sub(mul(bracket, t0), mul(f0, mul(t11, t1)));
    bracket = add(sub(mul(d0, t11), mul(d1, t11)), mul(three, mul(f1, t1)));
    num a0 = sub(add(mul(sub(mul(d1, t1), f1), mul(t00, t0)), mul(bracket, t00)), first);
    return (struct G(poly)){3, {div(a0, cube), div(a1, cube), div(a2, cube), div(a3, cube)}};
}

/*
:::{claim} cubic_coefficients_by_monomials
:title: The coefficients of the interpolating cubic, as printed and as sums of monomials
:zh: 三次插值系数的公式及其单项式展开
:given: $t_0\ne t_1$, values $f(t_0),f(t_1)$ and derivatives $f'(t_0),f'(t_1)$
:then: the cubic with the four printed coefficients, in $a_2$ the prime added, satisfies the four conditions; so does it with the sums of monomials that they become when the brackets
  are multiplied out; and no other cubic does
:method: Everything variable; the formulas are entered with their brackets, and once more as lists of monomials.  The conditions have the determinant $(t_1-t_0)^4\ne0$.
:over: t# h#: different nodes; f#: data
:control: the sign of the first monomial of $a_2$ reversed
:::
*/
CLAIM(cubic_coefficients_by_monomials)
{
    num t0, t1, data[4];
    G(interval)(T, &t0, &t1);
    G(four_data)(T, data);
    struct G(poly) sums = G(cubic_of_sums)(t0, t1, data, fault(T, 1, -1)),
                   printed = G(cubic_with_brackets)(t0, t1, data);
    G(osculates)(T, sums, t0, t1, data);
    G(osculates)(T, printed, t0, t1, data);
    for (int k = 0; k <= 3; k++) {
        about(T, "a coefficient as printed, and multiplied out");
        same(T, printed.c[k], sums.c[k]);
    }
    G(no_other_cubic)(T, t0, t1);
}

/*
:::{statement} slides-ch4:2-cubic-a2
:title: The coefficient of the square
:zh: 系数 a2 的公式
:printed: a_2=-\frac{f'(t_1)t_1^2+2f(t_0)t_1^2+3f(t_0)t_1-3f(t_1)t_1}{(t_1-t_0)^3}+\frac{(f'(t_0)+2f'(t_1))t_0^2+(f'(t_0)t_1-f'(t_1)t_1-3f(t_0)+3f(t_1))t_0}{(t_1-t_0)^3}
:refuted-by: square_needs_the_prime
:class: misprint
:corrected: a_2=-\frac{f'(t_1)t_1^2+2f'(t_0)t_1^2+3f(t_0)t_1-3f(t_1)t_1}{(t_1-t_0)^3}+\frac{(f'(t_0)+2f'(t_1))t_0^2+(f'(t_0)t_1-f'(t_1)t_1-3f(t_0)+3f(t_1))t_0}{(t_1-t_0)^3}
:corrected-by: cubic_coefficients_by_monomials
:needs: equal_ends_have_no_cubic | the problem, which is posed on an interval $[t_0,t_1]$ | $t_0\ne t_1$: the formula divides by $t_1-t_0$, and at equal ends no other will do
:figure: square_without_its_prime

In the text at hand the formula has no signs, primes and fraction bars, but values and derivatives can be told apart: a prime tears the letter and its bracket apart, as in
$2f'(t_1)$ of the second fraction, and in $2f(t_0)t_1^2$ they are together, as in $3f(t_0)t_1$.  Multiplied out the formula has ten terms.  Whatever signs these are given, and so
whatever signs its terms, brackets and fractions have, it is false: all $2^{10}$ choices were run, and two are
shown; with a prime and the signs shown here it is true.
:::
*/

#if RATIONAL
/*
:::{claim} square_needs_the_prime
:title: With f(t0) for f'(t0) in one term the curve misses its data
:zh: 漏一撇则插值失败
:kind: counterexample
:data: t = 0 1; f = 1 1; f' = 0 0
:result: P(t_1) with -2f(t_0) = -1; P(t_1) with +2f(t_0) = 3
:given: the nodes $t$, and the values $f$ and derivatives $f'$ of a constant
:then: whatever signs the ten terms of the printed $a_2$ have when it is multiplied out, the curve does not end in $f(t_1)$
:method: The printed sums, that of $a_2$ with all $2^{10}$ choices of signs; the value at $t_1$.  It is shown for the signs of the correct formula and for those
  with another sign of the first term.
:control: the term with its prime
:::
*/
CLAIM(square_needs_the_prime)
{
    num t[2], data[4];
    given_points(T, "t", 2, 1, t);
    given_points(T, "f", 2, 1, data);
    given_points(T, "f'", 2, 1, data + 2);
    struct G(poly) p = G(cubic_of_sums)(t[0], t[1], data, 1); /* and with 0 for a_2 its value at t_1 is `rest` */
    num length = sub(t[1], t[0]), cube = mul(length, mul(length, length)), square = mul(t[1], t[1]), value[10];
    num rest = sub(G(at)(p, 0, t[1]), mul(p.c[2], square));
    for (int m = 0; m < 10; m++) {
        struct G(monomial) term = G(printed_sum)[2][m];
        term.datum = m == 0 ? fault(T, 2, 0) : term.datum;
        value[m] = div(mul(square, G(value_of)(term, t[0], t[1], data)), cube);
    }
    int hits = 0;
    for (int turned = 0; turned < 1 << 10; turned++) { /* term m has the other sign where bit m is 1 */
        num end = rest;
        for (int m = 0; m < 10; m++)
            end = add(end, turned >> m & 1 ? neg(value[m]) : value[m]);
        if (turned < 2)
            found(T, turned == 0 ? "P(t_1) with -2f(t_0)" : "P(t_1) with +2f(t_0)", end);
        hits += equal_q(end, data[1]);
    }
    about(T, "whether some choice of the signs gives f(t_1)");
    agree(T, hits > 0);
}
#endif

/*
## The four blending functions (混合函数)

Ordered by the data in the place of the powers of $t$, the same cubic is short.  Each datum is multiplied by a function of its own, and the
function can be written down without solving anything: a double root at the other node, and a linear factor that makes value and
slope right at its own.

:::{statement} slides-ch4:2-cubic-by-data
:title: The interpolating cubic, ordered by its data
:zh: 按型值整理的三次插值多项式
:printed: $P(t)=f(t_0)\frac{(t-t_1)^2(-2t+3t_0-t_1)}{(t_0-t_1)^3}+f(t_1)\frac{(t-t_0)^2(-2t+3t_1-t_0)}{(t_1-t_0)^3}+f'(t_0)\frac{(t-t_1)^2(t-t_0)}{(t_1-t_0)^2}+f'(t_1)\frac{(t-t_0)^2(t-t_1)}{(t_1-t_0)^2}$, $t\in[t_0,t_1]$
:holds-by: cubic_ordered_by_data
:needs: equal_ends_have_no_cubic | the problem, which is posed on an interval $[t_0,t_1]$ | $t_0\ne t_1$: the formula divides by $t_1-t_0$, and at equal ends no other will do
:figure: nodes_that_meet

In the text at hand the sum has no signs and no primes; with those shown here it satisfies the four conditions.
:::

:::{claim} cubic_ordered_by_data
:title: The four fractions, multiplied by the data, satisfy the conditions
:zh: 四个分式之和满足插值条件
:given: $t_0\ne t_1$ and any data
:then: the printed sum has the values and derivatives prescribed at $t_0$ and $t_1$, and no other cubic has them
:method: The sum as a polynomial in $t$; everything variable.  The four conditions have the determinant $(t_1-t_0)^4\ne0$.
:over: t# h#: different nodes; f#: data
:control: the cube $(t_0-t_1)^3$ under both values
:::
*/
CLAIM(cubic_ordered_by_data)
{
    num t0, t1, data[4];
    G(interval)(T, &t0, &t1);
    G(four_data)(T, data);
    num length = sub(t1, t0), back = neg(length), square = mul(length, length);
    num two = from_int(2), three = from_int(3);
    struct G(poly) up = {1, {neg(t0), from_int(1)}}, down = {1, {neg(t1), from_int(1)}}; /* t - t0, t - t1 */
    struct G(poly)
        factor[4] = {{1, {sub(mul(three, t0), t1), neg(two)}}, {1, {sub(mul(three, t1), t0), neg(two)}}, up, down};
    num under[4] = {mul(square, back), mul(square, fault(T, length, back)), square, square};
    struct G(poly) sum = G(constant)(from_int(0));
    for (int i = 0; i < 4; i++) {
        struct G(poly) far = i % 2 == 0 ? down : up;
        struct G(poly) product = G(times)(factor[i], G(times)(far, far));
        sum = G(plus)(sum, G(times)(G(constant)(div(data[i], under[i])), product));
    }
    G(osculates)(T, sum, t0, t1, data);
    G(no_other_cubic)(T, t0, t1);
}

/*
:::{statement} slides-ch4:2-blending
:title: The blending functions over an interval
:zh: 区间上的混合函数
:printed: $P_0(t)=f(t_0)g_{00}(t)+f(t_1)g_{01}(t)+f'(t_0)h_{00}(t)(t_1-t_0)+f'(t_1)h_{01}(t)(t_1-t_0)$ with
  $g_{00}=\bigl(1-2\frac{t-t_0}{t_0-t_1}\bigr)\bigl(\frac{t-t_1}{t_0-t_1}\bigr)^2$,
  $g_{01}=\bigl(1-2\frac{t-t_1}{t_1-t_0}\bigr)\bigl(\frac{t-t_0}{t_1-t_0}\bigr)^2$,
  $h_{00}=\frac{t-t_0}{t_1-t_0}\bigl(\frac{t-t_1}{t_0-t_1}\bigr)^2$, $h_{01}=\frac{t-t_1}{t_1-t_0}\bigl(\frac{t-t_0}{t_1-t_0}\bigr)^2$
:holds-by: hermite_kernel_blends_four_data
:needs: equal_ends_have_no_cubic | the problem, which is posed on an interval $[t_0,t_1]$ | $t_0\ne t_1$: the functions divide by $t_1-t_0$, and
  at equal ends no others will do
:figure: hermite_blending_functions

In the text at hand the formulas have no signs and no primes; with those shown here the sum has the four data.
:::

:::{claim} hermite_kernel_blends_four_data
:title: The printed functions blend the data to the interpolating cubic and all its derivatives
:zh: 混合函数给出三次插值曲线及其各阶导数
:given: two nodes $t_0\ne t_1$ in any order, any data, any $t$, orders 0 to 4
:then: the kernel `hermite_blending` gives the derivatives of $g_{00}$, $g_{01}$, $h_{00}(t)(t_1-t_0)$, $h_{01}(t)(t_1-t_0)$, `hermite_cubic` those of
  the printed sum, and that sum has the data, which no other cubic has
:method: The printed functions are multiplied out as polynomials in $t$, and differentiated power by power; everything variable.  The four conditions have the determinant
  $(t_1-t_0)^4\ne0$.
:defines: hermite_blending hermite_cubic
:over: t# h#: different nodes; f#: data; p: t
:control: the two derivatives exchanged
:::
*/
CLAIM(hermite_kernel_blends_four_data)
{
    num t0, t1, data[4], B[20], out[5], t = parameter(T, "p");
    t0 = unknown(T, "t", 0);
    t1 = add(t0, unknown(T, "h", 0)); /* on either side */
    G(four_data)(T, data);
    struct G(poly) sum = G(constant)(from_int(0));
    G(hermite_blending)(t0, t1, t, 4, B);
    for (int i = 0; i < 4; i++) {
        struct G(poly) g = G(printed_term)(t0, t1, fault(T, i, i >= 2 ? 5 - i : i));
        about(T, "the blending functions");
        for (int k = 0; k <= 4; k++)
            same(T, B[4 * k + i], G(at)(g, k, t));
        sum = G(plus)(sum, G(times)(G(constant)(data[i]), g));
    }
    G(hermite_cubic)(1, t0, t1, data, t, 4, out);
    about(T, "the curve");
    for (int k = 0; k <= 4; k++)
        same(T, out[k], G(at)(sum, k, t));
    G(osculates)(T, sum, t0, t1, data);
    G(no_other_cubic)(T, t0, t1);
}

/*
What characterizes the four functions is a table of sixteen numbers.  Each has one of the four data, and the three others are 0.

:::{statement} slides-ch4:2-blending-ends
:title: Values and derivatives of the blending functions at the ends
:zh: 混合函数的端点性质
:printed: $g_{00}(t_0)=1$, $g_{00}(t_1)=0$, $g_{01}(t_0)=0$, $g_{01}(t_1)=1$, $h_{00}(t_0)=h_{00}(t_1)=h_{01}(t_0)=h_{01}(t_1)=0$;
  $g_{00}'(t_0)=g_{00}'(t_1)=g_{01}'(t_0)=g_{01}'(t_1)=0$, $h_{00}'(t_0)=\frac1{t_1-t_0}$, $h_{00}'(t_1)=0$, $h_{01}'(t_0)=0$, $h_{01}'(t_1)=\frac1{t_1-t_0}$
:holds-by: blending_functions_are_dual_to_the_data
:needs: equal_ends_have_no_cubic | the problem, which is posed on an interval $[t_0,t_1]$ | $t_0\ne t_1$: the functions divide by $t_1-t_0$, and at equal ends no cubics have this table
:figure: hermite_blending_functions

In the text at hand the table has no primes; with those shown here it is true.
:::

:::{statement} slides-ch4:3-blending-ends
:title: Values and derivatives at the ends of the functions over the unit interval
:zh: 单位区间上四个混合函数的端点性质
:printed: The functions $q_{00},q_{01},q_{10},q_{11}$ of section 2 are cubic polynomials, continuously differentiable, and satisfy $q_{00}(0)=1$, $q_{01}(0)=q_{10}(0)=q_{11}(0)=0$; $q_{01}(1)=1$, $q_{00}(1)=q_{10}(1)=q_{11}(1)=0$; $q_{10}'(0)=1$,
  $q_{00}'(0)=q_{01}'(0)=q_{11}'(0)=0$; $q_{11}'(1)=1$, $q_{00}'(1)=q_{01}'(1)=q_{10}'(1)=0$
:holds-by: unit_functions_are_dual_to_the_data
:figure: hermite_blending_functions

In the text at hand the table has no primes; with those shown here it is true.
:::

:::{claim} blending_functions_are_dual_to_the_data
:title: Each blending function has one datum different from 0, and its three others are 0
:zh: 四函数与四型值对偶
:given: $t_0<t_1$
:harmless: $t_0<t_1$ | the identities are those of two different nodes, in any order
:then: of the sixteen values and derivatives of the printed functions at $t_0$ and $t_1$ it is so that $g_{00}(t_0)=g_{01}(t_1)=1$,
  $h_{00}'(t_0)=h_{01}'(t_1)=\frac1{t_1-t_0}$, and the twelve others are 0
:method: The printed functions multiplied out and differentiated; $t_0$ and $t_1$ variables.
:over: t# h#: different nodes
:control: $h_{00}$ taken for $h_{01}$
:::
*/
CLAIM(blending_functions_are_dual_to_the_data)
{
    num t0, t1, unit[4];
    G(interval)(T, &t0, &t1);
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 4; k++)
            unit[k] = k != i ? from_int(0) : i < 2 ? from_int(1) : div(from_int(1), sub(t1, t0));
        G(osculates)(T, G(printed_blending)(t0, t1, fault(T, i, i == 3 ? 2 : i)), t0, t1, unit);
    }
}

/*
:::{claim} unit_functions_are_dual_to_the_data
:title: Over the unit interval the table of values and derivatives is the unit matrix
:zh: 单位区间上四函数与四型值对偶
:given: the functions $q_{00},q_{01},q_{10},q_{11}$ by their coefficients of $u^3,u^2,u,1$, which are the columns of the matrix printed in section 2, and once more as
  $g_{00},g_{01},h_{00},h_{01}$ over the interval $t_0=0$, $t_1=1$
:then: each is a polynomial of degree 3 with one of the four data $q(0),q(1),q'(0),q'(1)$ equal to 1 and the others equal to 0
:method: The polynomials and their derivatives at the two integers; the coefficient of $u^3$ is $2q(0)-2q(1)+q'(0)+q'(1)$, so it is
  $2,-2,1,1$, and not 0.
:scope: the four functions
:control: $q_{10}$ taken for $q_{11}$
:::
*/
CLAIM(unit_functions_are_dual_to_the_data)
{
    num zero = from_int(0), one = from_int(1), unit[4];
    for (int i = 0; i < 4; i++) {
        int taken = fault(T, i, i == 3 ? 2 : i);
        struct G(poly) column = {3, {zero, zero, zero, zero}};
        for (int k = 0; k < 4; k++) {
            unit[k] = from_int(k == i);
            column.c[k] = from_int(G(printed_matrix)(3 - k, taken));
        }
        about(T, "the columns of the matrix");
        G(osculates)(T, column, zero, one, unit);
        about(T, "the functions over an interval");
        G(osculates)(T, G(printed_blending)(zero, one, taken), zero, one, unit);
        about(T, "the degree");
        num rise = sub(unit[0], unit[1]);
        same(T, column.c[3], add(add(rise, rise), add(unit[2], unit[3])));
    }
}

/*
## Four points (Lagrange 插值)

With values alone, at as many nodes, the same idea gives Lagrange's functions.

:::{statement} slides-ch4:2-lagrange
:title: The cubic through four points
:zh: 过四点的三次 Lagrange 插值
:printed: $P(t)=\sum_{i=0}^3f(t_i)g_i(t)$ with $g_i(t)=\prod_{j\ne i}\frac{t-t_j}{t_i-t_j}$, written out for $i=0,1,2,3$
:holds-by: lagrange_functions_keep_every_polynomial
:needs: two_equal_nodes_of_four_have_no_cubic | the words: four different points (四个不同的点) | the four points are different
:figure: lagrange_blending_functions
:degree: 3

In the text at hand the formulas have no signs; with those shown here they give the values.
:::

:::{claim} lagrange_functions_keep_every_polynomial
:title: The sum of the values with Lagrange's functions is the polynomial
:zh: Lagrange 混合函数
:given: different nodes $\tau_0,\dots,\tau_n$, any polynomial of degree at most $n$, any $t$
:then: `lagrange_blending` gives $g_i(t)=\prod_{j\ne i}(t-\tau_j)\big/\prod_{j\ne i}(\tau_i-\tau_j)$, functions with $g_i(\tau_j)=1$ for $i=j$ and 0 otherwise, and
  $\sum_ip(\tau_i)g_i(t)=p(t)$
:method: Nodes and $t$ variables, numerator and denominator each multiplied out; the polynomial each of $1,\ t-\tau_0,\ (t-\tau_0)(t-\tau_1),\dots$ up to degree $n$; both sides are
  linear in the polynomial, and every other one is a sum of multiples of these.
:degrees: 0..6 sampled 10
:over: t#: different nodes; p: t
:defines: lagrange_blending
:control: the first value that is not 0 left out
:::
*/
CLAIM(lagrange_functions_keep_every_polynomial)
{
    int n = T->degree;
    num tau[MAX_ORDER], g[MAX_ORDER], t = parameter(T, "p");
    G(different_nodes)(T, n + 1, tau);
    for (int j = 0; j <= n; j++) {
        G(lagrange_blending)(n, tau, tau[j], g);
        about(T, "g_i at the nodes");
        for (int i = 0; i <= n; i++)
            same(T, g[i], from_int(i == j));
    }
    G(lagrange_blending)(n, tau, t, g);
    about(T, "the printed fractions");
    for (int i = 0; i <= n; i++) {
        num above = from_int(1), below = from_int(1);
        for (int j = 0; j <= n; j++)
            if (j != i)
                above = mul(above, sub(t, tau[j])), below = mul(below, sub(tau[i], tau[j]));
        same(T, mul(g[i], below), above);
    }
    about(T, "p(t)");
    for (int k = 0; k <= n; k++) { /* p(t) = (t - tau_0) ... (t - tau_{k-1}) */
        num sum = from_int(0), at_t = from_int(1);
        for (int i = fault(T, k, k + 1); i <= n; i++) {
            num value = from_int(1);
            for (int m = 0; m < k; m++)
                value = mul(value, sub(tau[i], tau[m]));
            sum = add(sum, mul(value, g[i]));
        }
        for (int m = 0; m < k; m++)
            at_t = mul(at_t, sub(t, tau[m]));
        same(T, sum, at_t);
    }
}

/*
## The unit interval

Nobody wants to carry $t_0$ and $t_1$ along.  With $u$ in the place of $t$ the interval becomes $[0,1]$ and the functions become fixed cubics.
The price is that a derivative by $u$ is the derivative by $t$ times the length of the interval; it is paid again and again in what
follows, and the slides do not always keep the two apart.

:::{statement} slides-ch4:2-substitution
:title: The blending functions over the unit interval
:zh: 变换到单位区间
:printed: So that $t_0\le t\le t_1$ becomes $0\le u\le1$: $u=\frac{t-t_0}{t_1-t_0}$, $t=t_0+(t_1-t_0)u$; $g_{00}(t)=(1+2u)(u-1)^2=2u^3-3u^2+1=q_{00}(u)$,
  $g_{01}(t)=(3-2u)u^2=-2u^3+3u^2=q_{01}(u)$, $h_{00}(t)=u(u-1)^2=u^3-2u^2+u=q_{10}(u)$, $h_{01}(t)=(u-1)u^2=u^3-u^2=q_{11}(u)$; so
  $P_0(t_0+(t_1-t_0)u)=f(t_0)q_{00}(u)+f(t_1)q_{01}(u)+f'(t_0)(t_1-t_0)q_{10}(u)+f'(t_1)(t_1-t_0)q_{11}(u)$
:holds-by: unit_blending_functions
:needs: equal_ends_have_no_cubic | the problem, which is posed on an interval $[t_0,t_1]$ | $t_0\ne t_1$: $u$ and the functions divide by $t_1-t_0$, and at equal ends no others will do
:figure: hermite_blending_functions

In the text at hand the formulas have no signs and no primes; those shown here are true.
:::

:::{statement} slides-ch4:2-unit-derivatives
:title: The data over the unit interval
:zh: 导数随参数区间长度缩放
:printed: $\varphi(0)=f(t_0)$, $\varphi(1)=f(t_1)$, $\varphi'(0)=f'(t_0)(t_1-t_0)$, $\varphi'(1)=f'(t_1)(t_1-t_0)$, and
  $P(u)=\varphi(0)q_{00}(u)+\varphi(1)q_{01}(u)+\varphi'(0)q_{10}(u)+\varphi'(1)q_{11}(u)$
:holds-by: unit_blending_functions
:needs: equal_ends_have_no_cubic | the problem, which is posed on an interval $[t_0,t_1]$ | $t_0\ne t_1$: $u=\frac{t-t_0}{t_1-t_0}$ divides by $t_1-t_0$, and at equal ends none or infinitely many cubics have the data
:meant: the arguments 0 and 1 in the place of $t_0$ and $t_1$ | $\varphi$ is the polynomial as a function of $u$.
:figure: hermite_blending_functions

In the text at hand the formulas have no signs and no primes; those
shown here are true.  For $\varphi$ it has the letter $f$, with a mark that is lost.
:::

:::{claim} unit_blending_functions
:title: In the parameter of the unit interval derivatives are multiplied by the length of the interval
:zh: 单位区间上的混合函数
:given: $t_0<t_1$, any data, any $u$, $t=t_0+(t_1-t_0)u$
:harmless: $t_0<t_1$ | the identities are those of two different nodes, in any order
:then: $u=\frac{t-t_0}{t_1-t_0}$, which runs from 0 to 1 while $t$ runs from $t_0$ to $t_1$; the printed functions of $t$ are those of $u$ in all three forms, in factors, in powers and as the columns of the $4\times4$ matrix, and the sum with the derivatives times $t_1-t_0$ is the
  interpolating cubic; as a function of $u$ it has at $u=0$ and $u=1$ the values $f(t_0)$, $f(t_1)$ and the derivatives $f'(t_0)(t_1-t_0)$, $f'(t_1)(t_1-t_0)$
:method: The functions of $t$ multiplied out, the others evaluated as printed; everything variable.  Of points and vectors each coordinate is computed by itself.
:over: t# h#: different nodes; f#: data
:control: the derivatives not multiplied by the length
:::
*/
CLAIM(unit_blending_functions)
{
    num t0, t1, data[4], u = parameter(T, "u"), one = from_int(1), two = from_int(2), sum = from_int(0);
    G(interval)(T, &t0, &t1);
    G(four_data)(T, data);
    num length = sub(t1, t0), t = add(t0, mul(length, u)), uu = mul(u, u), uuu = mul(uu, u), v = sub(u, one);
    num q[4] = {add(sub(mul(two, uuu), mul(from_int(3), uu)), one), sub(mul(from_int(3), uu), mul(two, uuu)),
                add(sub(uuu, mul(two, uu)), u), sub(uuu, uu)};
    num factored[4] = {mul(mul(v, v), add(mul(two, u), one)), mul(uu, sub(from_int(3), mul(two, u))), mul(u, mul(v, v)),
                       mul(uu, v)};
    num cubic = from_int(0), scaled[4];
    about(T, "u from t");
    same(T, div(sub(t, t0), length), u);
    struct G(poly) of_u = G(constant)(from_int(0)); /* the sum as a polynomial in u, by the columns of the matrix */
    for (int i = 0; i < 4; i++) {
        struct G(poly) g = G(printed_blending)(t0, t1, i), in_u = {.n = 3};
        num scale = fault(T, i < 2 ? one : length, one), power = one, column = from_int(0);
        about(T, "the functions");
        same(T, G(at)(g, 0, t), q[i]);
        same(T, factored[i], q[i]);
        for (int k = 0; k < 4; k++, power = mul(power, u)) {
            in_u.c[k] = from_int(G(printed_matrix)(3 - k, i));
            column = add(column, mul(in_u.c[k], power));
        }
        same(T, column, q[i]);
        scaled[i] = mul(i < 2 ? one : length, data[i]);
        of_u = G(plus)(of_u, G(times)(G(constant)(mul(scale, data[i])), in_u));
        sum = add(sum, mul(mul(scale, data[i]), q[i]));
        cubic = add(cubic, mul(data[i], G(at)(G(printed_term)(t0, t1, i), 0, t)));
    }
    about(T, "the curve");
    same(T, sum, cubic);
    G(osculates)(T, of_u, from_int(0), one, scaled);
}

/*
:::{statement} slides-ch4:2-matrix
:title: The cubic as a product of matrices
:zh: 三次 Hermite 曲线的矩阵形式
:printed: $P(u)=[u^3\;u^2\;u\;1]\begin{bmatrix}2&-2&1&1\\-3&3&-2&-1\\0&0&1&0\\1&0&0&0\end{bmatrix}\begin{bmatrix}\varphi(0)\\\varphi(1)\\\varphi'(0)\\\varphi'(1)\end{bmatrix}$, which is
  the row $[q_{00}(u)\;q_{01}(u)\;q_{10}(u)\;q_{11}(u)]=[2u^3-3u^2+1,\;-2u^3+3u^2,\;u^3-2u^2+u,\;u^3-u^2]$ times the same column
:holds-by: unit_blending_functions
:confirmed-by: one_choice_of_signs_in_the_matrix
:needs: equal_ends_have_no_cubic | the problem, which is posed on an interval $[t_0,t_1]$ | $t_0\ne t_1$: $u=\frac{t-t_0}{t_1-t_0}$ divides by $t_1-t_0$, and at equal ends none or infinitely many cubics have the data
:meant: the arguments 0 and 1 in the place of $t_0$ and $t_1$ | $\varphi$ is the polynomial as a function of $u$.
:figure: hermite_blending_functions

In the text at hand the column has the letter $f$, with a mark that is lost, for $\varphi$, and the matrix has no signs; of all choices of them the one shown is the only true one: `one_choice_of_signs_in_the_matrix`.
:::
*/

#if RATIONAL
/* Do the coefficients, that of u^3 first, have the data P(0), P(1), P'(0), P'(1)? */
static int has_data(const int c[4], const int data[4])
{
    return c[3] == data[0] && c[0] + c[1] + c[2] + c[3] == data[1] && c[2] == data[2] &&
           3 * c[0] + 2 * c[1] + c[2] == data[3];
}

/* Row i gives datum i, of P(0), P(1), P'(0), P'(1), from the coefficients of u^3, u^2, u, 1. */
static const int data_rows[4][4] = {{0, 0, 0, 1}, {1, 1, 1, 1}, {0, 0, 1, 0}, {3, 2, 1, 0}};

/* Compare: the coefficients have these data; and no others have, the determinant of the rows being different from 0. */
static void only_these_have_the_data(trial *T, const int c[4], const int data[4])
{
    num rows[16];
    for (int i = 0; i < 4; i++) {
        num sum = from_int(0);
        for (int k = 0; k < 4; k++) {
            rows[4 * i + k] = from_int(data_rows[i][k]);
            sum = add(sum, mul(rows[4 * i + k], from_int(c[k])));
        }
        same(T, sum, from_int(data[i]));
    }
    agree(T, !is_zero_q(determinant_q(4, rows)));
}

/*
:::{claim} one_choice_of_signs_in_the_matrix
:title: One choice of signs makes the columns the blending functions
:zh: 矩阵的符号唯一
:kind: decision
:given: the absolute values of the printed matrix, with all $2^{10}$ choices of signs
:then: exactly one has columns with the unit data at 0 and 1, and it is the matrix that is printed here
:method: A column $c_3u^3+c_2u^2+c_1u+c_0$ has the data $c_0$, $c_0+c_1+c_2+c_3$, $c_1$, $c_1+2c_2+3c_3$.  The printed columns have the unit
  data; no others have, because the determinant of the four data is not 0.  All choices are tried in integers as well.
:control: the printed matrix with its first entry negative
:::
*/
CLAIM(one_choice_of_signs_in_the_matrix)
{
    int choices = 0, printed = 0;
    for (int j = 0; j < 4; j++) {
        int column[4], unit[4] = {j == 0, j == 1, j == 2, j == 3};
        for (int i = 0; i < 4; i++)
            column[i] = G(printed_matrix)(i, j);
        only_these_have_the_data(T, column, unit);
    }
    for (int signs = 0; signs < 1 << 10; signs++) {
        int M[4][4], bit = 0, good = 1, is_printed = 1;
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++) {
                int given = G(printed_matrix)(i, j), size = given < 0 ? -given : given;
                M[i][j] = size != 0 && signs >> bit++ & 1 ? -size : size;
                is_printed = is_printed && M[i][j] == fault(T, given, i + j == 0 ? -given : given);
            }
        for (int j = 0; j < 4; j++) {
            int column[4] = {M[0][j], M[1][j], M[2][j], M[3][j]}, unit[4] = {j == 0, j == 1, j == 2, j == 3};
            good = good && has_data(column, unit);
        }
        choices += good;
        printed += good && is_printed;
    }
    agree(T, choices == 1);
    agree(T, printed == 1);
}

/*
The example has eight coefficients whose signs are lost.  They can be put back in one way only, and the result is the sum of the four
data with their blending functions.

:::{statement} slides-ch4:2-worked-curve
:title: The worked curve
:zh: 三次 Hermite 曲线算例
:printed: $P(u)=[u^3\;u^2\;u\;1]\begin{bmatrix}2&-2&1&1\\-3&3&-2&-1\\0&0&1&0\\1&0&0&0\end{bmatrix}\begin{bmatrix}1&1\\4&2\\1&1\\1&-1\end{bmatrix}=[u^3\;u^2\;u\;1]\begin{bmatrix}-4&-2\\6&2\\1&1\\1&1\end{bmatrix}$
  for $P_0=(1,1)$, $P_1=(4,2)$, $P_0'=(1,1)$, $P_1'=(1,-1)$: $x(u)=-4u^3+6u^2+u+1$, $y(u)=-2u^3+2u^2+u+1$
:holds-by: worked_hermite_curve
:figure: worked_hermite_curve

In the text at hand the matrices and coefficients have no signs, and the tangents no primes; of all choices of signs of the coefficients the one shown is the only one that has the
data.
:::

:::{claim} worked_hermite_curve
:title: The curve of the example has the points and tangents asked for, and only with these signs
:zh: 算例验证
:kind: decision
:data: x, x' = 1 4 1 1; y, y' = 1 2 1 -1; x(u) = -4 6 1 1; y(u) = -2 2 1 1
:instead: y, y' = 1 2 1 1
:given: the data of the example, coordinate by coordinate: the values at the two ends and then the derivatives there; the coefficients that are printed,
  that of $u^3$ first, with all $2^8$ choices of their signs
:then: exactly one choice has the data, the printed one, and it is what `hermite_cubic` and the product of the $4\times4$ matrix with the data give
:method: Values and derivatives at 0 and 1, which determine a cubic because their determinant is not 0; all choices in integers as
  well; the kernel at as many parameters as determine a cubic.
:control: the second tangent goes up
:::
*/
CLAIM(worked_hermite_curve)
{
    static const char *const of_axis[2][2] = {{"x, x'", "x(u)"}, {"y, y'", "y(u)"}};
    int choices[2] = {0, 0};
    for (int axis = 0; axis < 2; axis++) {
        num four[4], c[4], out;
        int data[4], size[4];
        given_points(T, of_axis[axis][0], 4, 1, four);
        given_points(T, of_axis[axis][1], 4, 1, c);
        for (int k = 0; k < 4; k++)
            data[k] = (int)to_double_q(four[k]), size[k] = (int)to_double_q(c[k]);
        only_these_have_the_data(T, size, data);
        for (int i = 0; i < 4; i++) {
            num sum = from_int(0);
            for (int k = 0; k < 4; k++)
                sum = add(sum, mul(from_int(G(printed_matrix)(i, k)), four[k]));
            same(T, sum, c[i]);
        }
        for (int signs = 0; signs < 1 << 4; signs++) {
            int chosen[4];
            for (int k = 0; k < 4; k++)
                chosen[k] = signs >> k & 1 ? -size[k] : size[k];
            choices[axis] += has_data(chosen, data);
        }
        for (int k = 0; k < 4; k++) {
            num u = from_int(k);
            hermite_cubic_q(1, from_int(0), from_int(1), four, u, 0, &out);
            same(T, out, add(mul(add(mul(add(mul(c[0], u), c[1]), u), c[2]), u), c[3]));
        }
    }
    agree(T, choices[0] * choices[1] == 1);
}
#endif

#include "chapters/judge/claims_off.h"
