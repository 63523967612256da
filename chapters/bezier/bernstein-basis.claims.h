/*
# The Bernstein basis (Bernstein 基)

The Bernstein polynomials of degree $n$ are the terms of the binomial expansion of $((1-t)+t)^n$,

$$B_i^n(t)=\binom ni(1-t)^{n-i}t^i,\qquad i=0,\dots,n.$$

What a Bézier curve does, it does because of them: it lies in the hull of its points since they are positive with
sum $1$, it is symmetric since they are, and one can write any polynomial with them.

The library computes them by their recurrence, without a binomial coefficient.
*/
#include "chapters/bezier/definition.h"

#include "chapters/judge/claims_on.h"

/*
The first claim ties the recurrence to the binomial terms; from then on either may stand for the other.  It is a claim about
finitely many degrees, because a kernel runs for one degree at a time.

:::{claim} bernstein_is_binomial_form
:title: The kernel computes the terms of the binomial expansion
:zh: 内核所算即二项展开式各项
:given: any $t$
:then: `bernstein_basis` gives $B_i^n(t)=\binom ni(1-t)^{n-i}t^i$, $i=0,\dots,n$
:method: The kernel runs through the degrees with $B_i^k=(1-t)B_i^{k-1}+tB_{i-1}^{k-1}$; the other side is
  $\frac{n!}{i!(n-i)!}$ times powers.  At a variable $t$ both are elements of one field.
:degrees: 0..8 sampled 20
:defines: bernstein_basis
:control: the binomial coefficient taken as $\binom{n+1}i$
:::
*/
CLAIM(bernstein_is_binomial_form)
{
    int n = T->degree;
    num t = parameter(T, "t"), B[MAX_DEGREE + 1];
    G(bernstein_basis)(n, t, B);
    for (int i = 0; i <= n; i++) {
        num term = mul(G(power)(sub(from_int(1), t), n - i), G(power)(t, i));
        same(T, B[i], mul(G(choose)(fault(T, n, n + 1), i), term));
    }
}

/*
## Relations between neighbours, for every degree

In these the degree itself is a variable.  What makes that possible is the ratio of neighbouring terms: if $c$ is
one binomial coefficient, the ones beside it are $c$ times a quotient of $n$ and $i$, and the powers of $t$ and of
$1-t$ that both sides share are two more variables.  An identity in all these variables holds for all integers.

:::{claim} bernstein_recurrence
:title: The recurrence of the Bernstein polynomials
:zh: Bernstein 基的递推关系
:given: integers $1\le i\le n$, any $t$
:let: $c=\binom{n-1}{i-1}$, so that $\binom{n-1}i=c\frac{n-i}i$ and $\binom ni=c\frac ni$; $U=(1-t)^{n-i}$, $V=t^{i-1}$
:then: $B_i^n(t)=(1-t)B_i^{n-1}(t)+tB_{i-1}^{n-1}(t)$
:method: The three terms are $c\frac ni\,UtV$, $c\frac{n-i}i\,UtV$ and $c\,UtV$, compared with $n-i$, $i$, $t$, $c$,
  $U$, $V$ all variables.  For $i=0$ the relation is $(1-t)^n=(1-t)(1-t)^{n-1}$.
:degrees: all from 1
:over: i n_minus_i c: i; t U V: t
:control: $\binom{n-1}i$ taken as $c\frac{n-i}{i+1}$
:::
*/
CLAIM(bernstein_recurrence)
{
    num i = whole(T, "i", 1, 20), rest = whole(T, "n_minus_i", 0, 20), n = add(i, rest);
    num t = parameter(T, "t"), c = parameter(T, "c"), U = parameter(T, "U"), V = parameter(T, "V");
    num shared = mul(mul(U, V), t), below = fault(T, i, add(i, from_int(1)));
    num stays = mul(mul(c, div(rest, below)), shared), comes = mul(c, shared);
    same(T, mul(mul(c, div(n, i)), shared), add(stays, comes));
}

/*
The recurrence climbs from degree $n-1$ to $n$.  The next relation climbs as well, but keeps the polynomial: it writes the
same function one degree higher, and is the whole reason why the degree of a curve can be raised without changing the curve.

:::{claim} bernstein_raised_by_one_degree
:title: A Bernstein polynomial is a combination of two of the next degree
:zh: n 次基由两个 n+1 次基表示
:given: integers $0\le i\le n$, any $t$
:let: $c=\binom ni$, so that $\binom{n+1}i=c\frac{n+1}{n+1-i}$ and $\binom{n+1}{i+1}=c\frac{n+1}{i+1}$;
  $U=(1-t)^{n-i}$, $V=t^i$
:then: $(1-t)B_i^n=\frac{n+1-i}{n+1}B_i^{n+1}$ and $tB_i^n=\frac{i+1}{n+1}B_{i+1}^{n+1}$, hence
  $B_i^n=(1-\frac i{n+1})B_i^{n+1}+\frac{i+1}{n+1}B_{i+1}^{n+1}$
:method: With $n-i$, $i$, $t$, $c$, $U$, $V$ variables, both sides of each relation are one element of the field.
:degrees: all
:over: i n_minus_i c: i; t U V: t
:control: the factor $\frac{i+1}{n+1}$ taken as $\frac i{n+1}$
:::
*/
CLAIM(bernstein_raised_by_one_degree)
{
    num one = from_int(1), i = whole(T, "i", 0, 20), rest = whole(T, "n_minus_i", 0, 20);
    num next = add(add(i, rest), one), t = parameter(T, "t"), s = sub(one, t);
    num c = parameter(T, "c"), U = parameter(T, "U"), V = parameter(T, "V"), B = mul(c, mul(U, V));
    num lower = mul(mul(c, div(next, add(rest, one))), mul(mul(s, U), V));
    num upper = mul(mul(c, div(next, add(i, one))), mul(U, mul(t, V)));
    num left = mul(div(add(rest, one), next), lower);
    num right = mul(div(fault(T, add(i, one), i), next), upper);
    about(T, "(1-t) B_i^n");
    same(T, left, mul(s, B));
    about(T, "t B_i^n");
    same(T, right, mul(t, B));
    about(T, "B_i^n");
    same(T, add(left, right), B);
}

/*
:::{claim} bernstein_derivative
:title: The derivative of a Bernstein polynomial
:zh: Bernstein 基的导数
:given: integers $0\le i\le n$, $n\ge1$, any $t$
:let: $c=\binom ni$, so that $\binom{n-1}{i-1}=c\frac in$ and $\binom{n-1}i=c\frac{n-i}n$; $W=t^{i-1}$, $X=(1-t)^{n-i-1}$
:then: $(B_i^n)'=n(B_{i-1}^{n-1}-B_i^{n-1})$ and $t(1-t)\,(B_i^n)'=(i-nt)\,B_i^n$
:method: A value and its derivative are one number $x+x'\varepsilon$ with $\varepsilon^2=0$.  The power $t^i+i\,W\varepsilon$ times
  $t+\varepsilon$ is $t^{i+1}+(i+1)\,t^i\varepsilon$, likewise for the powers of $1-t-\varepsilon$: by induction these are the
  derivatives of the powers, and that of $t^i(1-t)^{n-i}$ is $i\,W(1-t)X-(n-i)\,tWX$.  With $n-i$, $i$, $t$, $c$, $W$, $X$
  variables both relations are equalities in the field.  For $i=0$ and $i=n$ one term is absent, and its factor $i$ or $n-i$ is $0$.
:degrees: all from 1
:over: i n_minus_i c: i; t W X: t
:control: the sign between the two terms of the derivative
:::
*/
/* x + x' e with e^2 = 0, and the product of two such numbers. */
struct G(dual) {
    num value, slope;
};
static struct G(dual) G(dual_product)(struct G(dual) a, struct G(dual) b)
{
    return (struct G(dual)){mul(a.value, b.value), add(mul(a.value, b.slope), mul(a.slope, b.value))};
}

CLAIM(bernstein_derivative)
{
    num one = from_int(1), i = whole(T, "i", 1, 20), rest = whole(T, "n_minus_i", 1, 20);
    num n = add(i, rest), t = parameter(T, "t"), s = sub(one, t);
    num c = parameter(T, "c"), W = parameter(T, "W"), X = parameter(T, "X");
    struct G(dual) of_t = {mul(t, W), mul(i, W)}, of_s = {mul(s, X), neg(mul(rest, X))}; /* t^i, (1-t)^{n-i} */
    struct G(dual) next_t = G(dual_product)(of_t, (struct G(dual)){t, one});
    struct G(dual) next_s = G(dual_product)(of_s, (struct G(dual)){s, neg(one)});
    about(T, "the derivatives of the next powers");
    same(T, next_t.slope, mul(add(i, one), of_t.value));
    same(T, next_s.slope, neg(mul(add(rest, one), of_s.value)));
    of_s.slope = fault(T, of_s.slope, neg(of_s.slope));
    num D = mul(c, G(dual_product)(of_t, of_s).slope);
    num left = mul(mul(c, div(i, n)), mul(mul(W, s), X));     /* B_{i-1}^{n-1} */
    num right = mul(mul(c, div(rest, n)), mul(mul(t, W), X)); /* B_i^{n-1} */
    about(T, "(B_i^n)'");
    same(T, D, mul(n, sub(left, right)));
    num B = mul(c, mul(mul(t, W), mul(s, X)));
    about(T, "t (1-t) (B_i^n)'");
    same(T, mul(mul(t, s), D), mul(sub(i, mul(n, t)), B));
}

/*
The second relation of the last claim says where a Bernstein polynomial is largest: in $(0,1)$ it is positive, so
its derivative has the sign of $i-nt$.

:::{claim} bernstein_largest_at_its_node
:title: A Bernstein polynomial increases up to i/n and decreases after it
:zh: 基函数在 i/n 处取唯一最大值
:given: integers $0\le i\le n$, $n\ge1$
:let: $t=\frac in\cdot\frac s{1+s}$ for a point of $(0,\frac in)$, $t=\frac in+\frac{n-i}n\cdot\frac s{1+s}$ for one of
  $(\frac in,1)$, $s>0$
:then: $i-nt$ is positive in the first interval and negative in the second, so that $\frac in$ is the only maximum of
  $B_i^n$ in $[0,1]$
:method: Inside the interval the derivative has the sign of $i-nt$ by `bernstein_derivative`.  The numerators and denominators of $\pm(i-nt)$ are polynomials in $i$, $n-i$ and $s$ with positive
  coefficients.  If $i=0$ or $i=n$ one of the two intervals is empty.
:degrees: all
:scope: 0 < i < n, 0 < t < 1
:over: i n_minus_i s: -
:control: the sign after the node expected as before it
:::
*/
CLAIM(bernstein_largest_at_its_node)
{
    num one = from_int(1), i = whole(T, "i", 1, 20), rest = whole(T, "n_minus_i", 1, 20);
    num n = add(i, rest), share = inside(T, "s");
    num node = div(i, n), after = add(node, mul(sub(one, node), share));
    about(T, "i - n t before the node");
    G(must_be_positive)(T, sub(i, mul(n, mul(node, share))));
    about(T, "n t - i after the node");
    num falling = sub(mul(n, after), i);
    G(must_be_positive)(T, fault(T, falling, neg(falling)));
    about(T, "i - n t at the node");
    vanishes(T, sub(i, mul(n, node)));
}

/*
## Sum, sign, symmetry

What follows is true of degree 0, where the only function is 1, and each step of the recurrence keeps it: so it is true of
every degree.

:::{claim} recurrence_keeps_sum_sign_ends_and_symmetry
:title: The recurrence keeps the sum 1, the signs, the bound 1, the values at the ends and the symmetry
:zh: 递推保持规范性、非负性、上界 1、端点值与对称性
:given: $a=B_i^{n-1}(t)$ and $b=B_{i-1}^{n-1}(t)$, so that $B_i^n(t)=(1-t)a+tb$; $S=\sum_iB_i^{n-1}(t)$; any $t$
:then: $\sum_iB_i^n(t)=(1-t)S+tS=S$; for $t$ in $(0,1)$ and $a,b>0$, or one of them absent, $B_i^n(t)>0$;
  $1-B_i^n(t)=(1-t)(1-a)+t(1-b)$, so that if no function of degree $n-1$ is greater than 1 in $[0,1]$, none of degree $n$ is; $B_i^n(0)=a$ for $t=0$ and
  $B_i^n(1)=b$ for $t=1$, so that $B_0^n(0)=B_n^n(1)=1$ and the others are 0 there; and with $a'=B_i^{n-1}(1-t)$, $b'=B_{i-1}^{n-1}(1-t)$, the
  mirror images of $b$ and $a$ of index $n-i$, $B_i^n(1-t)=(1-(1-t))a'+(1-t)b'=(1-t)b'+ta'=B_{n-i}^n(t)$
:method: The recurrence once, `bernstein_recurrence`, with the values of degree $n-1$ variables, $t=\frac s{1+s}$, $s>0$, for the signs; $B_0^0=1$
  has all these properties, and the step is an induction.
:degrees: all
:over: t; s a b S: -
:control: $1-t$ and $t$ exchanged
:::
*/
/* (1-t) a + t b */
static num G(blend)(num t, num a, num b) { return add(mul(sub(from_int(1), t), a), mul(t, b)); }

CLAIM(recurrence_keeps_sum_sign_ends_and_symmetry)
{
    num t = parameter(T, "t"), inside_t = inside(T, "s"), zero = from_int(0), one = from_int(1);
    num a = positive(T, "a", 0), b = positive(T, "b", 0), S = unknown(T, "S", 0);
    about(T, "the sum");
    same(T, G(blend)(t, S, S), S);
    about(T, "the values at the ends");
    same(T, G(blend)(fault(T, zero, one), a, b), a);
    same(T, G(blend)(fault(T, one, zero), a, b), b);
    about(T, "the mirror image");
    same(T, G(blend)(sub(one, t), a, b), G(blend)(t, b, a));
    about(T, "the distance from 1");
    same(T, sub(one, G(blend)(t, a, b)), G(blend)(t, sub(one, a), sub(one, b)));
    about(T, "the sign");
    G(must_be_positive)(T, G(blend)(inside_t, a, b));
    G(must_be_positive)(T, G(blend)(inside_t, a, zero));
    G(must_be_positive)(T, G(blend)(inside_t, zero, b));
}

/*
Here is the kernel, degree by degree.

:::{claim} bernstein_sums_to_one
:title: The Bernstein polynomials of one degree sum to 1
:zh: 规范性:基函数之和为一
:given: any $t$
:then: $\sum_{i=0}^nB_i^n(t)=1$
:method: The sum of the kernel's values at a variable $t$ is the constant $1$ of the field.
:degrees: 0..12 sampled 24
:control: $B_0^n$ left out
:::
*/
CLAIM(bernstein_sums_to_one)
{
    int n = T->degree;
    num t = parameter(T, "t"), B[MAX_DEGREE + 1], sum = from_int(0);
    G(bernstein_basis)(n, t, B);
    for (int i = fault(T, 0, 1); i <= n; i++)
        sum = add(sum, B[i]);
    same(T, sum, from_int(1));
}

/*
The sum says that a point $\sum b_iB_i^n(t)$ is an affine combination of the $b_i$; it holds for every $t$.  Only the sign makes it
a weighted average, and the sign is right inside the unit interval alone.  Both together are the convex hull property.

:::{claim} bernstein_positive_inside
:title: Inside the unit interval every Bernstein polynomial is positive
:zh: 在开区间内恒正
:given: $t=\frac s{1+s}$ with $s>0$, that is, any $t\in(0,1)$
:then: $B_i^n(t)>0$ for $i=0,\dots,n$
:method: Each value of the kernel, as a quotient of polynomials in $s$, has positive coefficients only.
:degrees: 0..10 sampled 20
:scope: 0 < t < 1
:harmless: $s>0$ | it is $0<t<1$
:over: s: -
:control: $t$ taken as $-\frac s{1+s}$
:::
*/
CLAIM(bernstein_positive_inside)
{
    int n = T->degree;
    num t = inside(T, "s"), B[MAX_DEGREE + 1];
    G(bernstein_basis)(n, fault(T, t, neg(t)), B);
    for (int i = 0; i <= n; i++)
        G(must_be_positive)(T, B[i]);
}

/*
Outside the unit interval the signs alternate, and the sum is still $1$: there a curve may leave the hull of its
points.

:::{claim} bernstein_alternates_outside
:title: Outside the unit interval the signs alternate
:zh: 区间之外基函数符号交错
:given: any $s>0$
:then: $(-1)^iB_i^n(-s)>0$ and $(-1)^{n-i}B_i^n(1+s)>0$ for $i=0,\dots,n$
:method: As polynomials in $s$ these have positive coefficients only.
:degrees: 0..10 sampled 20
:scope: t < 0 and t > 1
:harmless: any $s>0$ | it is $t=-s<0$ or $t=1+s>1$
:over: s: -
:control: the sign $(-1)^i$ at $1+s$ as well
:::
*/
CLAIM(bernstein_alternates_outside)
{
    int n = T->degree;
    num s = positive(T, "s", 0), one = from_int(1), before[MAX_DEGREE + 1], after[MAX_DEGREE + 1];
    G(bernstein_basis)(n, neg(s), before);
    G(bernstein_basis)(n, add(one, s), after);
    for (int i = 0; i <= n; i++) {
        G(must_be_positive)(T, i % 2 == 0 ? before[i] : neg(before[i]));
        int exponent = fault(T, n - i, i);
        G(must_be_positive)(T, exponent % 2 == 0 ? after[i] : neg(after[i]));
    }
}

/*
:::{claim} bernstein_at_ends
:title: At the ends one Bernstein polynomial is 1 and the others are 0
:zh: 端点处的值
:given: $t=0$ and $t=1$
:then: $B_i^n(0)$ is $1$ for $i=0$ and $0$ otherwise; $B_i^n(1)$ is $1$ for $i=n$ and $0$ otherwise
:method: The kernel's values at the two integers, one case for each $n$.
:degrees: 0..12 sampled 24
:control: the values at $1$ expected in the order of those at $0$
:::
*/
CLAIM(bernstein_at_ends)
{
    int n = T->degree;
    num B[MAX_DEGREE + 1];
    G(bernstein_basis)(n, from_int(0), B);
    for (int i = 0; i <= n; i++)
        same(T, B[i], from_int(i == 0));
    G(bernstein_basis)(n, from_int(1), B);
    for (int i = 0; i <= n; i++)
        same(T, B[i], from_int(fault(T, i == n, i == 0)));
}

/*
:::{claim} bernstein_is_symmetric
:title: Reversing the parameter reverses the basis
:zh: 对称性
:given: any $t$
:then: $B_i^n(1-t)=B_{n-i}^n(t)$
:method: The kernel at a variable $t$ and at $1-t$.
:degrees: 0..8 sampled 20
:control: $B_i^n(t)$ on the right
:::
*/
CLAIM(bernstein_is_symmetric)
{
    int n = T->degree;
    num t = parameter(T, "t"), B[MAX_DEGREE + 1], reversed[MAX_DEGREE + 1];
    G(bernstein_basis)(n, t, B);
    G(bernstein_basis)(n, sub(from_int(1), t), reversed);
    for (int i = 0; i <= n; i++)
        same(T, reversed[i], B[fault(T, n - i, i)]);
}

/*
## Derivatives and integrals

:::{claim} bernstein_derivatives_of_every_order
:title: The kernel computes the derivatives of the basis, of every order
:zh: 基函数的各阶导数
:given: any $t$, orders $0,\dots,n+1$
:then: `bernstein_derivatives` gives $\frac{d^k}{dt^k}B_i^n(t)$, $0$ for $k>n$
:method: The kernel goes up from degree $n-k$ by differences; the other side differentiates $\binom ni(1-t)^{n-i}t^i$,
  in the field as a rational function, in the other number types power by power.
:degrees: 0..6 sampled 10
:defines: bernstein_derivatives
:control: the factor $n!/(n-k)!$ short of its factor $n$
:::
*/
CLAIM(bernstein_derivatives_of_every_order)
{
    int n = T->degree;
    num t = parameter(T, "t"), B[(MAX_DEGREE + 1) * (MAX_DEGREE + 2)];
    G(bernstein_derivatives)(n, t, n + 1, B);
    for (int k = 0; k <= n + 1; k++)
        for (int i = 0; i <= n; i++) {
            num D = G(basis_derivative)(n, i, k, t);
            same(T, B[k * (n + 1) + i], fault(T, D, k > 0 ? div(D, from_int(n + 1)) : D));
        }
}

/*
Differentiation lowers the degree by differences of neighbours, so integration must raise it by sums of them.  All
Bernstein polynomials of one degree turn out to have the same area, however different their graphs are.

:::{claim} bernstein_primitive
:title: A primitive of a Bernstein polynomial; all of them have the same area
:zh: 原函数与积分
:given: any $t$
:then: $\int_0^tB_i^n=\frac1{n+1}\sum_{j=i+1}^{n+1}B_j^{n+1}(t)$, in particular $\int_0^1B_i^n=\frac1{n+1}$
:method: The left side is integrated power by power, the right side is the kernel's.
:degrees: 0..7 sampled 12
:control: the sum from $j=i$ on
:::
*/
CLAIM(bernstein_primitive)
{
    int n = T->degree;
    num t = parameter(T, "t"), B[MAX_DEGREE + 2];
    G(bernstein_basis)(n + 1, t, B);
    for (int i = 0; i <= n; i++) {
        num area = from_int(0), whole = from_int(0), sum = from_int(0);
        for (int k = i; k <= n; k++) {
            num c = div(G(basis_coefficient)(n, i, k), from_int(k + 1));
            area = add(area, mul(c, G(power)(t, k + 1)));
            whole = add(whole, c);
        }
        for (int j = fault(T, i + 1, i); j <= n + 1; j++)
            sum = add(sum, B[j]);
        about(T, "the integral up to t");
        same(T, div(sum, from_int(n + 1)), area);
        about(T, "the integral over [0,1]");
        same(T, from_ratio(1, n + 1), whole);
    }
}

/*
## A basis

Between the Bernstein form and the powers of $t$ one passes by a triangular matrix, without a zero in its diagonal:
the Bernstein polynomials of degree $n$ are independent and span all polynomials of degree at most $n$.  A
polynomial that vanishes on an interval therefore has no coefficient different from $0$.

:::{claim} bernstein_to_power_keeps_polynomial
:title: From the Bernstein form to powers
:zh: Bernstein 形式化为幂形式
:given: any coefficients $b_0,\dots,b_n$, any $t$
:then: the coefficients $c$ of `bernstein_to_power` have $\sum c_kt^k=\sum b_iB_i^n(t)$
:method: Both sums at a variable $t$, the $b_i$ variables, the right one from the definition.
:degrees: 0..7 sampled 12
:over: x#: coefficients
:defines: bernstein_to_power
:control: the last coefficient with the other sign
:::
*/
CLAIM(bernstein_to_power_keeps_polynomial)
{
    int n = T->degree;
    num b[MAX_DEGREE + 1], c[MAX_DEGREE + 1], sum = from_int(0), t = parameter(T, "t");
    G(free_points)(T, n, 1, b);
    G(bernstein_to_power)(n, b, c);
    c[n] = fault(T, c[n], neg(c[n]));
    for (int k = 0; k <= n; k++)
        sum = add(sum, mul(c[k], G(power)(t, k)));
    same(T, sum, G(curve)(n, 1, b, 0, t));
}

/*
:::{claim} power_to_bernstein_keeps_polynomial
:title: From powers to the Bernstein form
:zh: 幂形式化为 Bernstein 形式
:given: any coefficients $c_0,\dots,c_n$, any $t$
:then: the coefficients $b$ of `bernstein_from_power` have $\sum b_iB_i^n(t)=\sum c_kt^k$
:method: Both sums at a variable $t$, the $c_k$ variables, the left one from the definition.
:degrees: 0..7 sampled 12
:over: x#: coefficients
:defines: bernstein_from_power
:control: the last coefficient with the other sign
:::
*/
CLAIM(power_to_bernstein_keeps_polynomial)
{
    int n = T->degree;
    num b[MAX_DEGREE + 1], c[MAX_DEGREE + 1], sum = from_int(0), t = parameter(T, "t");
    G(free_points)(T, n, 1, c);
    G(bernstein_from_power)(n, c, b);
    b[n] = fault(T, b[n], neg(b[n]));
    for (int k = 0; k <= n; k++)
        sum = add(sum, mul(c[k], G(power)(t, k)));
    same(T, G(curve)(n, 1, b, 0, t), sum);
}

/*
:::{claim} bernstein_and_power_forms_are_inverse
:title: The two conversions undo each other
:zh: 两种转换互逆
:given: any $n+1$ numbers
:then: `bernstein_from_power` after `bernstein_to_power`, and the other way round, give them back
:method: Both compositions on variables; the kernels are also called with their result in place of their argument.
:degrees: 0..10 sampled 16
:over: x#: coefficients
:control: the coefficients reversed between the two conversions
:::
*/
CLAIM(bernstein_and_power_forms_are_inverse)
{
    int n = T->degree;
    num b[MAX_DEGREE + 1], there[MAX_DEGREE + 1], back[MAX_DEGREE + 1];
    G(free_points)(T, n, 1, b);
    for (int order = 0; order < 2; order++) {
        (order == 0 ? G(bernstein_to_power) : G(bernstein_from_power))(n, b, there);
        for (int i = 0; i <= n; i++)
            back[i] = there[fault(T, i, n - i)];
        (order == 0 ? G(bernstein_from_power) : G(bernstein_to_power))(n, back, back);
        for (int i = 0; i <= n; i++)
            same(T, back[i], b[i]);
    }
}

/*
:::{claim} bernstein_basis_is_independent
:title: The Bernstein polynomials of degree n are independent
:zh: 线性无关性
:given: the matrix whose row $i$ holds the coefficients of $1,t,\dots,t^n$ in $B_i^n$
:then: its determinant is $\prod_{i=0}^n\binom ni\ne0$
:method: The rows are what `bernstein_to_power` makes of unit vectors; the determinant is computed without division.
:degrees: 0..8 sampled 10
:control: the second row made equal to the first
:::
*/
CLAIM(bernstein_basis_is_independent)
{
    int n = T->degree;
    num M[MAX_ORDER * MAX_ORDER], unit[MAX_DEGREE + 1], product = from_int(1);
    for (int i = 0; i <= n; i++) {
        for (int k = 0; k <= n; k++)
            unit[k] = from_int(k == fault(T, i, i == 1 ? 0 : i));
        G(bernstein_to_power)(n, unit, M + i * (n + 1));
        product = mul(product, G(choose)(n, i));
    }
    same(T, G(determinant)(n + 1, M), product);
    G(must_be_positive)(T, product);
}

/*
Which coefficients belong to the simplest polynomial that is not constant?  Those at equal steps.  The graph of a polynomial with the
coefficients $b_i$ is therefore the plane Bézier curve of the points $(\frac in,b_i)$, and what is said of curves is said of functions too.

:::{claim} linear_precision
:title: Coefficients in arithmetic progression give the linear function
:zh: 线性精度
:given: any $t$
:then: $\sum_{i=0}^n\frac inB_i^n(t)=t$
:method: The sum of the kernel's values, each with its factor, at a variable $t$.
:degrees: 1..12 sampled 24
:control: the coefficients $\frac{i+1}{n+1}$
:::
*/
CLAIM(linear_precision)
{
    int n = T->degree;
    num t = parameter(T, "t"), B[MAX_DEGREE + 1], sum = from_int(0);
    G(bernstein_basis)(n, t, B);
    for (int i = 0; i <= n; i++)
        sum = add(sum, mul(from_ratio(fault(T, i, i + 1), fault(T, n, n + 1)), B[i]));
    same(T, sum, t);
}

/*
## Products and elevation

:::{claim} bernstein_product_is_product
:title: The coefficients of a product
:zh: 乘积的系数
:given: any coefficients $a_0,\dots,a_n$ and $b_0,\dots,b_m$, $m=0,\dots,\min(n,3)$, any $t$
:then: the coefficients $c$ of `bernstein_product` have
  $\sum c_kB_k^{n+m}(t)=\sum a_iB_i^n(t)\cdot\sum b_jB_j^m(t)$
:method: The three sums from the definition, at a variable $t$, all coefficients variables; for every pair of the
  degrees, and with the factors exchanged.
:degrees: 0..5 sampled 8
:over: a# b#: coefficients
:defines: bernstein_product
:control: the factor $\frac1{\binom{n+m}0}$ of $c_0$ taken as $\frac12$
:::
*/
CLAIM(bernstein_product_is_product)
{
    int n = T->degree;
    num a[MAX_DEGREE + 1], b[MAX_DEGREE + 1], c[MAX_DEGREE + 1], t = parameter(T, "t");
    for (int i = 0; i <= n; i++)
        a[i] = unknown(T, "a", i);
    for (int m = 0; m <= n && m <= 3; m++) {
        b[m] = unknown(T, "b", m);
        num product = mul(G(curve)(n, 1, a, 0, t), G(curve)(m, 1, b, 0, t));
        for (int exchanged = 0; exchanged < 2; exchanged++) {
            if (exchanged)
                G(bernstein_product)(m, b, n, a, c);
            else
                G(bernstein_product)(n, a, m, b, c);
            c[0] = fault(T, c[0], div(c[0], from_int(2)));
            same(T, G(curve)(n + m, 1, c, 0, t), product);
        }
    }
}

/*
The last claim puts the relation from degree $n$ to $n+1$ into a matrix.  Its rows are weights of averages, and that will
be used twice: the elevated polygon cuts the corners of the old one, and no new change of sign can appear.

:::{claim} elevation_matrix_raises_the_basis
:title: The elevation matrix writes the basis in the next degree
:zh: 升阶矩阵
:given: any $t$
:then: $B_j^n(t)=\sum_iE_{ij}B_i^{n+1}(t)$ for every column $j$ of `bernstein_elevation_matrix`; every row of $E$ has entries that
  are not negative, and sum $1$
:method: Both sides from the definition at a variable $t$.  The entries are numbers.
:degrees: 0..8 sampled 16
:defines: bernstein_elevation_matrix
:control: the matrix of degree $n+1$ in the place of that of degree $n$
:::
*/
CLAIM(elevation_matrix_raises_the_basis)
{
    int n = T->degree;
    num t = parameter(T, "t"), E[(MAX_DEGREE + 2) * (MAX_DEGREE + 2)];
    int columns = fault(T, n + 1, n + 2);
    G(bernstein_elevation_matrix)(columns - 1, E);
    for (int j = 0; j <= n; j++) {
        num sum = from_int(0);
        for (int i = 0; i <= n + 1; i++)
            sum = add(sum, mul(E[i * columns + j], G(basis)(n + 1, i, t)));
        about(T, "a column");
        same(T, sum, G(basis)(n, j, t));
    }
    for (int i = 0; i <= n + 1; i++) {
        num row = from_int(0);
        about(T, "a row");
        for (int j = 0; j <= n; j++) {
            nonnegative(T, E[i * columns + j]);
            row = add(row, E[i * columns + j]);
        }
        same(T, row, from_int(1));
    }
}
#include "chapters/judge/claims_off.h"
