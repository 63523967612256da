/*
# Every degree at once (任意次数)

Most formulas of this chapter are linear in the coefficients of a Bernstein sum $\sum B_i^n(t)b_i$, once for the denominator,
$b_i=\omega_i$, and once for the numerator, $b_i=\omega_iR_i$.  Such a formula holds for all $b_0,\dots,b_n$ when it holds
for $b_i=Z^i$ with a variable $Z$, because the powers $1,Z,\dots,Z^n$ are linearly independent.  And for these the
sum is a power,

$$\sum_{i=0}^nB_i^n(t)Z^i=(1-t+tZ)^n=D(t)^n,\qquad D(t)=1-t+tZ,$$

so that a formula for every $n$ becomes one for the factor $D$, in which no $n$ is left.
*/
#include "chapters/judge/elementary.h"
#include "chapters/rational-bezier/crossings.h"

#include "chapters/judge/claims_on.h"

/* D(t) = 1 - t + t Z */
static inline num G(factor_at)(num t, num Z) { return add(sub(from_int(1), t), mul(t, Z)); }

/*
:::{claim} bernstein_sum_of_powers_is_a_power
:title: With geometric coefficients the Bernstein sum is a power, in every degree
:zh: 系数成等比数列时 Bernstein 和是一个幂
:given: $n\ge0$, any $t$ and $Z$
:then: $\sum_{i=0}^nB_i^n(t)Z^i=(1-t+tZ)^n$
:method: Induction on $n$, which begins with $1=1$ for $n=0$: multiplied by $1-t+tZ$ the sum of degree $n$ has at $Z^i$ the factor
  $(1-t)B_i^n(t)+tB_{i-1}^n(t)$, which must be $B_i^{n+1}(t)$.  With $C(n,i)=c$ and $k=n+1-i$ the definition by factorials
  gives $C(n,i-1)=c\frac ik$ and $C(n+1,i)=c\frac{i+k}k$; $i$, $k$, $c$, $t$ and $t^{i-1}(1-t)^{k-1}=u$ are variables.  For
  $i=0$ and $i=n+1$ there is one term on either side.  Outside the field $i$ and $k$ are random integers, the binomial
  coefficients are compared with true ones, and the sum is computed by de Casteljau's algorithm as well.
:degrees: all
:over: i k c u: -; t
:control: $i+1$ for $i$ in $C(n,i-1)$
:::
*/
/* C(n,i), C(n,i-1) and C(n+1,i), of which the two last are c i/k and c (i+k)/k with c = C(n,i), k = n + 1 - i, by the definition. */
struct G(pascal) {
    int n;
    num here, before, next;
};
static struct G(pascal) G(neighbouring_binomials)(trial *T)
{
    num one = from_int(1);
#if FIELD
    num i = whole(T, "i", 1, 5), k = whole(T, "k", 1, 5), c = unknown(T, "c", 0);
    int n = 0;
#else
    int index = pick(T, 1, 5), last = pick(T, 1, 5), n = index + last - 1;
    num i = from_int(index), k = from_int(last), c = from_int(binomial(n, index));
#endif
    struct G(pascal) p = {n, c, div(mul(c, fault(T, i, add(i, one))), k), div(mul(c, add(i, k)), k)};
#if !FIELD
    about(T, "binomial coefficients");
    same(T, p.before, from_int(binomial(n, index - 1)));
    same(T, p.next, from_int(binomial(n + 1, index)));
#endif
    return p;
}

/* (1-t) B_i^n + t B_{i-1}^n = B_i^{n+1}, with u = t^{i-1} (1-t)^{k-1} */
static void G(next_bernstein_function)(trial *T, struct G(pascal) p, num t)
{
    num u = unknown(T, "u", 0), rest = sub(from_int(1), t);
    num here = mul(p.here, mul(t, u)), there = mul(p.before, mul(rest, u));
    about(T, "from one degree to the next");
    same(T, add(mul(rest, here), mul(t, there)), mul(p.next, mul(mul(t, rest), u)));
}

CLAIM(bernstein_sum_of_powers_is_a_power)
{
    num t = parameter(T, "t");
    struct G(pascal) p = G(neighbouring_binomials)(T);
    G(next_bernstein_function)(T, p, t);
#if !FIELD
    num Z = unknown(T, "Z", 0), b[MAX_DEGREE + 1], value;
    for (int j = 0; j <= p.n; j++)
        b[j] = G(power)(Z, j);
    G(bezier_casteljau)(p.n, 1, b, t, &value);
    about(T, "the sum and the power");
    same(T, value, G(power)(G(factor_at)(t, Z), p.n));
#endif
}

/*
:::{claim} bernstein_sum_begins_with_its_differences
:title: The Taylor coefficients of a Bernstein sum at its beginning, in every degree
:zh: Bernstein 和在起点的 Taylor 系数(任意次数)
:given: $b_i=Z^i$, whose differences are $\Delta^jb_0=(Z-1)^j$; $n\ge0$
:then: $\sum_iB_i^n(t)b_i=\sum_j\binom nj\Delta^jb_0\,t^j$
:method: Induction on $n$, which begins with $b_0=b_0$ for $n=0$: the step multiplies either side by $1-t+tZ=1+t(Z-1)$.  On the left it makes $B_i^{n+1}(t)=(1-t)B_i^n(t)+tB_{i-1}^n(t)$ the factor of $Z^i$, on the right
  $\binom nj+\binom n{j-1}=\binom{n+1}j$ that of $t^j(Z-1)^j$.  With $C(n,i)=c$ and $k=n+1-i$ the definition by factorials gives $C(n,i-1)=c\frac ik$ and
  $C(n+1,i)=c\frac{i+k}k$; $i$, $k$, $c$, $t$, $Z$ and $t^{i-1}(1-t)^{k-1}=u$ are variables.  For $i=0$ and $i=n+1$ there is one term on either side.  The equation is linear in
  the $b_i$ and holds for all of them, since the powers of $Z$ are independent.  Outside the field $i$ and $k$ are random integers, and the two sums are compared as well.
:degrees: all
:over: i k c u Z t: -
:control: $i+1$ for $i$ in $C(n,i-1)$
:::
*/
CLAIM(bernstein_sum_begins_with_its_differences)
{
    num t = parameter(T, "t"), Z = unknown(T, "Z", 0), delta = sub(Z, from_int(1));
    struct G(pascal) p = G(neighbouring_binomials)(T);
    G(next_bernstein_function)(T, p, t);
    about(T, "the factor of the step");
    same(T, G(factor_at)(t, Z), add(from_int(1), mul(t, delta)));
    about(T, "Pascal's rule");
    same(T, add(p.here, p.before), p.next);
#if !FIELD
    num b[MAX_DEGREE + 1], value, sum = from_int(0);
    for (int j = 0; j <= p.n; j++) {
        b[j] = G(power)(Z, j);
        sum = add(sum, mul(from_int(binomial(p.n, j)), G(power)(mul(t, delta), j)));
    }
    G(bezier_casteljau)(p.n, 1, b, t, &value);
    about(T, "the two sums");
    same(T, value, sum);
#endif
}

/*
:::{claim} change_of_parameter_acts_on_one_factor
:title: What a change of the parameter does to a Bernstein sum, in every degree
:zh: 参数变换对 Bernstein 和的作用(任意次数)
:given: $D(t)=1-t+tZ$, any $Z$, $t$, $a$, $b$, $u$ for which the fractions below exist
:then: (1) $D(1-t)=Z\,(1-t+\frac tZ)$; (2) $D(t)=(1-t)(1+sZ)$ with $s=\frac t{1-t}$; (3) $D(t)=\frac{u+Z}{u+1}$ with
  $t=\frac1{1+u}$; (4) $D(t)=\frac{b(1-u)+auZ}{b(1-u)+au}$ with $t=\frac{au}{au+b(1-u)}$; (5) $D(t)=1$ for $Z=1$;
  (6) $D(t)=1+t(Z-1)$
:method: An equation that is linear in the $b_i$ holds for all of them when it holds for $b_i=Z^i$ with a variable
  $Z$, since the powers of $Z$ are independent.  Raised to the power $n$ and read as Bernstein sums of $b_i=Z^i$ these
  are, for every $n$: (1) reversed coefficients give the sum at $1-t$; (2) $\sum B_i^n(t)b_i=(1-t)^n\sum\binom
  nis^ib_i$; (3) $(1+u)^n\sum B_i^n(t)b_i=\sum\binom niu^{n-i}b_i$; (4) the sum at $t$ is that of $a^ib^{n-i}b_i$ at
  $u$, divided by the $n$-th power of the denominator; (5) $\sum B_i^n(t)=1$; (6) $\sum B_i^n(t)b_i=\sum\binom
  nj\Delta^jb_0\,t^j$.  That a Bernstein sum, or by the same rule of Pascal any sum with binomial coefficients, of the
  powers of $Z$ is a power, is `bernstein_sum_of_powers_is_a_power`.
:degrees: all
:over: Z#: coefficients; a b u: -; t
:control: $a$ and $b$ exchanged in the new coefficients of (4)
:::
*/
CLAIM(change_of_parameter_acts_on_one_factor)
{
    num one = from_int(1), Z = positive(T, "Z", 0), t = parameter(T, "t"), u = parameter(T, "u");
    num a = positive(T, "a", 0), b = positive(T, "b", 0), rest = sub(one, t), D = G(factor_at)(t, Z);
    about(T, "reversed coefficients");
    same(T, G(factor_at)(rest, Z), mul(Z, add(rest, div(t, Z))));
    about(T, "powers of t/(1-t)");
    same(T, D, mul(rest, add(one, mul(div(t, rest), Z))));
    about(T, "powers of u, t = 1/(1+u)");
    same(T, G(factor_at)(div(one, add(one, u)), Z), div(add(u, Z), add(u, one)));
    about(T, "a fractional linear change");
    num left = mul(fault(T, b, a), sub(one, u)), right = mul(fault(T, a, b), u);
    num old_rest = mul(b, sub(one, u)), share = mul(a, u), below = add(share, old_rest);
    same(T, G(factor_at)(div(share, below), Z), div(add(left, mul(right, Z)), below));
    about(T, "equal coefficients");
    same(T, G(factor_at)(t, one), one);
    about(T, "powers of t");
    same(T, D, add(one, mul(t, sub(Z, one))));
}

/*
The numbers $u\ge0$ of (3) leave out the start, $t=0$ or, on an interval $[a,b]$, $t=a$: it belongs to $u=+\infty$.

:::{claim} large_parameters_lead_to_the_left_end
:title: The larger u is, the nearer t is to a, and the other way round
:zh: u 趋于无穷时 t 趋于 a
:given: $b=a+l$, $l>0$, $v>0$, $u=\frac1v$
:then: $\frac{au+b}{u+1}=\frac{a+bv}{1+v}$ is greater than $a$, by less than $lv=\frac lu$; and $\frac{b-t}{t-a}=u-1$ at $t=a+\frac lu$
:method: Identities in $a$, $l$ and $v$; the signs are those of the coefficients.  For $u\to+\infty$ the first difference tends to 0, and for $t\to a$ the $u$ of the second
  formula grows beyond every bound.
:scope: u = +∞ and t = a
:harmless: $v>0$ | $u$ tends to $+\infty$, and is positive
:over: a l0 v0: -
:control: $t=(bu+a)/(u+1)$
:::
*/
CLAIM(large_parameters_lead_to_the_left_end)
{
    num a = parameter(T, "a"), l = positive(T, "l", 0), v = positive(T, "v", 0), b = add(a, l), one = from_int(1);
    num u = div(one, v), u1 = add(u, one), v1 = add(one, v);
    num t = fault(T, div(add(mul(a, u), b), u1), div(add(mul(b, u), a), u1));
    about(T, "t by u and by v");
    same(T, t, div(add(a, mul(b, v)), v1));
    about(T, "t - a and lv - (t - a)");
    /* t - a = l v/(1+v), l v - (t-a) = l v²/(1+v) */
    same(T, sub(t, a), div(mul(l, v), v1));
    same(T, sub(mul(l, v), sub(t, a)), div(mul(l, mul(v, v)), v1));
    G(must_be_positive)(T, div(mul(l, v), v1));
    G(must_be_positive)(T, div(mul(l, mul(v, v)), v1));
    num near = add(a, mul(l, v));
    about(T, "u near a");
    same(T, div(sub(b, near), sub(near, a)), sub(u, one));
}

/*
:::{claim} quotients_of_large_parameters_lead_to_the_first_point
:title: For u that grows beyond every bound the quotient tends to the first coordinate, in every degree
:zh: u 趋于无穷时商趋于首顶点的坐标
:given: $v=\frac1u$; the sums of (3.4.4) divided by $u^n$, which are $\omega_0x_0+vA$ and $\omega_0+vW$ with polynomials $A$, $W$ in $v$, any numbers here; $\omega_0>0$
:where: the weights are positive
:then: $\frac{\omega_0x_0+vA}{\omega_0+vW}-x_0=v\,\frac{A-x_0W}{\omega_0+vW}$, in which for $v=0$ the divisor is $\omega_0\ne0$
:method: An identity in five variables.  For $v\to0$ the polynomials tend to numbers, and the right side to 0: the quotient tends to $x_0$.
:degrees: all
:scope: u = +∞ and t = a
:over: x#: points; A# W#: coefficients; v: -
:control: $A+x_0W$
:::
*/
CLAIM(quotients_of_large_parameters_lead_to_the_first_point)
{
    num w = positive(T, "w", 0), x = unknown(T, "x", 0), A = unknown(T, "A", 0), W = unknown(T, "W", 0);
    num v = parameter(T, "v"), bottom = add(w, mul(v, W)), top = add(mul(w, x), mul(v, A)), xW = mul(x, W);
    about(T, "the quotient less x_0");
    same(T, sub(div(top, bottom), x), mul(v, div(fault(T, sub(A, xW), add(A, xW)), bottom)));
}

/*
:::{claim} triangle_of_powers_consists_of_powers
:title: The triangle of de Casteljau and the two parts of a cut, in every degree
:zh: 割角三角阵列与离散(任意次数)
:given: $b_i=Z^i$, any $Z$, $\lambda$, $x$; an interval $[a,a+h]$
:let: $D(t)=1-t+tZ$; any $U$
:then: (1) $(1-\lambda)U+\lambda ZU=D(\lambda)U$, so level $r$ of the triangle is $b_i^r=Z^{i-r}D(\lambda)^r$; (2)
  $1-x+xD(\lambda)=D(\lambda x)$; (3) $(1-x)D(\lambda)+xZ=D(\lambda+x(1-\lambda))$; (4) with $c=a+\lambda h$ these
  arguments of $D$ are $\frac{t-a}h$ for $t=a+x(c-a)$ and for $t=c+x(a+h-c)$
:method: An equation that is linear in the $b_i$ holds for all of them when it holds for $b_i=Z^i$ with a variable
  $Z$, since the powers of $Z$ are independent.  (1) is the step of an induction on $r$.  To the power $n$ (2) is
  $\sum B_i^n(x)b_i^i=\sum B_i^n(\lambda x)b_i$, the left part, and (3) is $\sum B_i^n(x)b_n^{n-i}=\sum
  B_i^n(\lambda+x(1-\lambda))b_i$, the right one, for every $n$, by `bernstein_sum_of_powers_is_a_power`; by the same
  claim $b_i^r=\sum_kB_k^r(\lambda)b_{i-r+k}$, $b_n^n$ is the point of the parameter $\lambda$, and
  $\sum_iB_i^{n-r}(t)b_{i+r}^r=D(t)^{n-r}D(\lambda)^r$.  Outside the field the triangle of a random degree is computed
  by the kernel that cuts.
:degrees: all
:over: Z#: points; U#: weights; lambda: -; a h: interval; x: t
:control: $D(\lambda)$ for $D(\lambda x)$ in (2)
:::
*/
CLAIM(triangle_of_powers_consists_of_powers)
{
    num one = from_int(1), Z = unknown(T, "Z", 0), U = unknown(T, "U", 0), lambda = parameter(T, "lambda");
    num x = parameter(T, "x"), a = unknown(T, "a", 0), h = positive(T, "h", 0), D = G(factor_at)(lambda, Z);
    num left = mul(lambda, x), right = add(lambda, mul(x, sub(one, lambda)));
    about(T, "one step of the recursion");
    same(T, add(mul(sub(one, lambda), U), mul(lambda, mul(Z, U))), mul(D, U));
    about(T, "the left part");
    same(T, add(sub(one, x), mul(x, D)), G(factor_at)(fault(T, left, lambda), Z));
    about(T, "the right part");
    same(T, add(mul(sub(one, x), D), mul(x, Z)), G(factor_at)(right, Z));
    about(T, "the parameters");
    num b = add(a, h), c = add(a, mul(lambda, h));
    same(T, div(sub(add(a, mul(x, sub(c, a))), a), h), left);
    same(T, div(sub(add(c, mul(x, sub(b, c))), a), h), right);
#if !FIELD
    int n = pick(T, 1, 8);
    num power[MAX_DEGREE + 1], first[MAX_DEGREE + 1], second[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++)
        power[i] = G(power)(Z, i);
    G(bezier_split)(n, 1, power, lambda, first, second);
    about(T, "the two sides of the triangle");
    for (int i = 0; i <= n; i++) {
        same(T, first[i], G(power)(D, i));
        same(T, second[i], mul(power[i], G(power)(D, n - i)));
    }
#endif
}

/*
:::{claim} members_are_flatter_powers
:title: The members of the family and the curve at the contact, in every degree and for every level
:zh: 曲线族成员在切触处的导数(任意次数、任意层)
:given: $b_i=Z^i$, $m,r\ge1$, $n=m+r$, the member $D(c)^rD(t)^m$, any $Z$, $c$, $t$, $h$; numbers $N$, $N'$, $W\ne0$, $W'$
:where: $\omega(c)\ne0$
:let: $D(t)=1-t+tZ$; $\delta=Z-1$, which is $D'(t)$; $U=D(c)^{r-1}D(t)^{m-1}$
:then: (1) $D(c+h)=D(c)+h\delta$; (2) the derivatives of the member by $t$ and by $c$ are $m\delta\,D(c)U$ and
  $r\delta\,D(t)U$; (3) if numerator and denominator of a quotient have $\frac mnN'$ and $\frac mnW'$ for derivatives, the
  quotient has $\frac mn$ times the derivative that belongs to $N'$ and $W'$
:method: An equation that is linear in the $b_i$ holds for all of them when it holds for $b_i=Z^i$ with a variable
  $Z$, since the powers of $Z$ are independent.  In the field the factors are differentiated formally, with
  $D(c)^{r-1}D(t)^{m-1}$ a variable and the rule $(D^m)'=mD^{m-1}D'$.  At $t=c$ the member is $D(c)^n$, as the curve
  is, and its derivative $m\delta D(c)^{n-1}$ is $\frac mn$ of that of the curve; by (3) so is the derivative of the
  quotient.  By (1) and the binomial theorem the member at $c+h$ is $\sum_k\binom mkh^k\delta^kD(c)^{n-k}$, with the
  same $\delta^kD(c)^{n-k}=p(c^{n-k},\delta^k)$ for every $m$.
:degrees: all
:over: Z#: points; U#: weights; N# W# m t h r c: -
:control: $m$ for $\frac mn$ in (3)
:::
*/
CLAIM(members_are_flatter_powers)
{
    num one = from_int(1), Z = unknown(T, "Z", 0), U = unknown(T, "U", 0), c = parameter(T, "c"), t = parameter(T, "t");
    num h = unknown(T, "h", 0), m = whole(T, "m", 1, 6), r = whole(T, "r", 1, 6), n = add(m, r), delta = sub(Z, one);
    num at_c = G(factor_at)(c, Z), at_t = G(factor_at)(t, Z);
    about(T, "the factor at c + h");
    same(T, G(factor_at)(add(c, h), Z), add(at_c, mul(h, delta)));
    about(T, "the derivatives of the member");
#if FIELD
    num by_t = derivative_f(at_t, t), by_c = derivative_f(at_c, c);
#else
    num by_t = delta, by_c = delta;
#endif
    /* (D(t)^m)' D(c)^r and D(t)^m (D(c)^r)', divided by U */
    same(T, mul(mul(m, by_t), mul(at_c, U)), mul(mul(m, delta), mul(at_c, U)));
    same(T, mul(mul(r, by_c), mul(at_t, U)), mul(mul(r, delta), mul(at_t, U)));
    about(T, "the derivative of a quotient");
    num N = unknown(T, "N", 0), N1 = unknown(T, "N", 1), W = positive(T, "W", 0), W1 = unknown(T, "W", 1);
    num share = div(m, n), slope = div(sub(mul(N1, W), mul(N, W1)), mul(W, W));
    num member = div(sub(mul(mul(share, N1), W), mul(N, mul(share, W1))), mul(W, W));
    same(T, member, mul(fault(T, share, m), slope));
}

/*
## Means

What is not linear in the products $\omega_iR_i$ is a property of the mean, and means are made of means: of a mean $M$ of weight
$W$ and one more point $R$ of weight $c$ comes the mean $\frac{WM+cR}{W+c}$ of weight $W+c$.  The number of terms is then the
number of steps.

:::{claim} mean_grows_by_one_term
:title: Means of any number of points: affine maps, a common factor, the sum of the shares
:zh: 任意多个点的加权平均: 仿射变换与公因子
:given: a point $M$ of weight $W$, a point $R$ of space of weight $c$, $W+c\ne0$; $f(x,y,z)=a_0x+a_1y+a_2z+d$; a factor $k\ne0$
:where: $\omega(t)\ne0$
:let: $M'=\frac{WM+cR}{W+c}$
:then: $f(M')=\frac{Wf(M)+cf(R)}{W+c}$; the weights $kW$ and $kc$ give the same $M'$; $\frac W{W+c}+\frac c{W+c}=1$
:method: Each is the step of an induction on the number of terms, and trivial for one term.  So for every $n$ and all weights with
  $\omega(t)\ne0$, the terms being $B_i^n(t)\omega_i$: an affine map of the points maps the curve, and $\omega(t)f(R(t))=\sum
  B_i^n(t)\omega_if(R_i)$; a common factor of the weights does not matter; the shares have the sum 1.  Taken in the order
  in which those of the sign of $\omega(t)$ come first no partial sum of the weights is 0.
:degrees: all
:over: W# c#: weights; M# R#: points; a# d# k: -
:control: $d$ added without its factor to $cR$
:::
*/
CLAIM(mean_grows_by_one_term)
{
    num W = positive(T, "W", 0), c = positive(T, "c", 0), k = positive(T, "k", 0), d = unknown(T, "d", 0);
    num total = add(W, c), image = d, of_mean = d, of_point = d;
    for (int j = 0; j < 3; j++) {
        num M = unknown(T, "M", j), R = unknown(T, "R", j), a = unknown(T, "a", j);
        num mean = div(add(mul(W, M), mul(c, R)), total);
        about(T, "a common factor");
        same(T, div(add(mul(mul(k, W), M), mul(mul(k, c), R)), add(mul(k, W), mul(k, c))), mean);
        image = add(image, mul(a, mean));
        of_mean = add(of_mean, mul(a, M));
        of_point = add(of_point, mul(a, R));
    }
    about(T, "the image of the mean");
    num wanted = add(mul(W, of_mean), mul(c, of_point));
    wanted = fault(T, wanted, add(sub(wanted, mul(c, d)), d));
    same(T, image, div(wanted, total));
    about(T, "the shares");
    same(T, add(div(W, total), div(c, total)), from_int(1));
}

/*
:::{claim} positive_terms_make_a_convex_mean
:title: With positive weights a Bernstein sum is positive and the mean is convex, in every degree
:zh: 正权时 Bernstein 和为正, 平均为凸组合(任意次数)
:given: $0<t<1$; a term $v>0$; positive weights $W$ and $c$
:then: $tv>0$ and $(1-t)v>0$; a sum of two positive numbers is positive; $\frac W{W+c}>0$ and $\frac c{W+c}>0$
:method: The steps of inductions.  $\binom ni>0$ by Pascal's rule and $t^i(1-t)^{n-i}>0$, one factor after the other, so
  $B_i^n(t)>0$ for $0<t<1$; at $t=0$ and $t=1$ one of them is 1 and the others are 0.  So with positive weights $\omega(t)>0$ on
  $[0,1]$, and the share of every point is not negative: $R(t)$ is a convex combination of the points.  With $t=\frac s{1+s}$ all
  are quotients of polynomials with coefficients of one sign.
:degrees: all
:scope: 0 ≤ t ≤ 1
:over: W# c#: weights; s v: -
:control: $t-1$ for $1-t$
:::
*/
CLAIM(positive_terms_make_a_convex_mean)
{
    num one = from_int(1), t = inside(T, "s"), v = positive(T, "v", 0), W = positive(T, "W", 0),
        c = positive(T, "c", 0);
    num rest = fault(T, sub(one, t), sub(t, one)), total = add(W, c);
    about(T, "one more factor");
    G(must_be_positive)(T, mul(t, v));
    G(must_be_positive)(T, mul(rest, v));
    about(T, "one more term");
    G(must_be_positive)(T, total);
    G(must_be_positive)(T, div(W, total));
    G(must_be_positive)(T, div(c, total));
}

/*
:::{claim} more_weight_moves_a_mean_to_its_point
:title: One weight grows: the mean moves straight to its point, and in the limit it is there
:zh: 一权增大时平均沿直线移向该点, 极限为该点
:given: a mean $M$ of weight $W>0$ of any number of points, one of which, $R$, gets $c>0$ more weight; $\varepsilon=\frac1c$
:let: $M'=\frac{WM+cR}{W+c}$, $q=\frac W{W+c}$
:then: $M'-R=q(M-R)$ with $0<q<1$; $M'=\frac{\varepsilon WM+R}{\varepsilon W+1}$, which is $R$ for $\varepsilon=0$
:method: Identities in $W$, $c$ and one coordinate of $M$ and $R$.  With $W=\omega(t)$, $M=R(t)$ and $c=\delta B_i^n(t)$ it is the curve
  whose weight $\omega_i$ has grown by $\delta$, for every $n$; a quotient of polynomials in $\varepsilon$ with a denominator that is not
  0 at $\varepsilon=0$ is continuous there, so its value is the limit for $\omega_i\to\infty$.
:degrees: all
:over: W#: weights; c: increase of a weight; M# R#: points
:control: $1-q$ for $q$
:::
*/
CLAIM(more_weight_moves_a_mean_to_its_point)
{
    num one = from_int(1), W = positive(T, "W", 0), c = positive(T, "c", 0), M = unknown(T, "M", 0);
    num R = unknown(T, "R", 0), total = add(W, c), q = div(W, total), e = div(one, c);
    num moved = div(add(mul(W, M), mul(c, R)), total);
    about(T, "straight to the point");
    same(T, sub(moved, R), mul(fault(T, q, sub(one, q)), sub(M, R)));
    G(must_be_positive)(T, q);
    G(must_be_positive)(T, sub(one, q));
    about(T, "a large weight");
    same(T, div(add(mul(mul(e, W), M), R), add(mul(e, W), one)), moved);
    about(T, "the limit");
    num none = from_int(0);
    same(T, div(add(mul(mul(none, W), M), R), add(mul(none, W), one)), R);
}

/*
## Derivatives of every order at an end

:::{claim} first_power_decides_the_end_derivative
:title: The derivative of the order of the first power, for every order
:zh: 首项幂次决定端点导矢(任意阶)
:given: $k\ge1$, a function $g$ with the value $g$ and the derivative $g'$ at $t$; $n\ge k$
:then: $(t^kg)'=t^{k-1}(kg+tg')$, where $kg+tg'$ is $kg(0)$ at $t=0$; with $C(n,k)=\frac{n!}{k!\,(n-k)!}$ it is
  $k!\,C(n,k)=\frac{n!}{(n-k)!}$; and with $s=1-t$ in place of $t$, if the derivative of order $k-1$ by $t$ is $\sigma$ times that by $s$, the next one
  is $-\sigma$ times that by $s$, and $-\sigma(R_{n-k}-R_n)=\sigma(R_n-R_{n-k})$
:method: The step of an induction on $k$: $t^kg$ has at $0$ the derivatives $0,\dots,0$ and, of order $k$, $k!\,g(0)$.  With
  $t^{k-1}$ and the factorials variables.  If $R_0=\dots=R_{k-1}$, then by `mean_grows_by_one_term`
  $R(t)-R_0=\sum_{i\ge k}B_i^n(t)\omega_i(R_i-R_0)/\omega(t)$, which is $t^kg$ with $g(0)=\binom nk\frac{\omega_k}{\omega_0}(R_k-R_0)$.  At
  $t=1$ the same with $s=1-t$ in place of $t$ and the polygon reversed.  The sign $\sigma$ begins with 1, so that it is $(-1)^h$ for the order $h$, and
  $-(-1)^h=(-1)^{h+1}$ is what stands before $R_n-R_{n-h}$.
:degrees: all
:scope: every multiplicity of the end points
:over: k g# U F# t E: -; x#: points
:control: $k-1$ for $k$
:::
*/
CLAIM(first_power_decides_the_end_derivative)
{
    num k = whole(T, "k", 1, 6), t = parameter(T, "t"), g = unknown(T, "g", 0), slope = unknown(T, "g", 1);
    num before = unknown(T, "U", 0), power = mul(t, before), zero = from_int(0); /* t^{k-1}, t^k */
    num factor = fault(T, k, sub(k, from_int(1)));
    about(T, "one derivative");
    /* (t^k g)' = k t^{k-1} g + t^k g' */
    same(T, add(mul(k, mul(before, g)), mul(power, slope)), mul(before, add(mul(factor, g), mul(t, slope))));
    about(T, "at t = 0");
    same(T, add(mul(k, g), mul(zero, slope)), mul(factor, g));
    about(T, "the factorials");
    num all = positive(T, "F", 0), of_k = positive(T, "F", 1), of_rest = positive(T, "F", 2);
    same(T, mul(of_k, div(all, mul(of_k, of_rest))), div(all, of_rest));
    num s = sub(from_int(1), t), sign = unknown(T, "E", 0);
#if FIELD
    num inner = derivative_f(s, t);
#else
    num inner = from_int(-1);
#endif
    about(T, "the sign at t = 1");
    /* d/dt σ (s^k g) = -σ d/ds (s^k g), and -σ (R_{n-k} - R_n) = σ (R_n - R_{n-k}) */
    num by_s = mul(before, add(mul(factor, g), mul(s, slope)));
    same(T, mul(sign, mul(inner, add(mul(k, mul(before, g)), mul(mul(s, before), slope)))), mul(neg(sign), by_s));
    num other = unknown(T, "x", 0), last = unknown(T, "x", 1);
    same(T, mul(neg(sign), sub(other, last)), mul(sign, sub(last, other)));
}

/*
:::{claim} end_direction_has_a_positive_factor
:title: Towards the next point, for positive weights and every degree
:zh: 正权时首个非零导矢指向下一个顶点
:given: positive weights $\omega_0,\omega_k$; $n\ge k\ge1$ by their factorials
:then: the factor $\frac{n!}{(n-k)!}\frac{\omega_k}{\omega_0}$ of $R_k-R_0$ is positive
:method: A quotient of products of positive numbers.  With `first_power_decides_the_end_derivative` the curve is $R_0$ plus $t^k$ times a positive
  multiple of $R_k-R_0$, up to higher powers of $t$; likewise at $t=1$, followed towards the end, with $\omega_n$ and $\omega_{n-h}$.
:degrees: all
:scope: every multiplicity of the end points
:over: w#: weights; F#: -
:control: a weight with the sign $-$
:::
*/
CLAIM(end_direction_has_a_positive_factor)
{
    num first = positive(T, "w", 0), other = positive(T, "w", 1), all = positive(T, "F", 0), rest = positive(T, "F", 1);
    G(must_be_positive)(T, mul(div(all, rest), div(fault(T, other, neg(other)), first)));
}

/*
## Parts of a curve

:::{claim} differences_over_a_part_are_means
:title: Second differences over a part of the interval, in every degree
:zh: 子区间上的二阶差分(任意次数)
:given: $b_i=Z^i$ over $[0,1]$, and the coefficients $D(u)^{n-i}D(v)^i$ of the same polynomial over $[u,v]$, $0\le u,v\le1$
:let: $D(t)=1-t+tZ$; $\delta=Z-1$
:then: $D(u+x(v-u))=(1-x)D(u)+xD(v)$ for every $x$; $D(v)-D(u)=(v-u)\delta$, so that $\Delta^2b_i^{[u,v]}=D(u)^{n-2-i}D(v)^i\,(v-u)^2\delta^2$; multiplied by $D(u)$ or $D(v)$ a polynomial in
  $Z$ with coefficients that are not negative keeps such coefficients, and $D(u)=D(v)=1$ for $Z=1$
:method: To the power $n$ the first equation says that the coefficients over $[u,v]$ are those given.  $\delta^2Z^j$ stands for $\Delta^2b_j$.  The product $D(u)^{n-2-i}D(v)^i$ has $n-2$ factors $1-u+uZ$, $1-v+vZ$, so it is $\sum_j\beta_{ij}Z^j$ with
  $\beta_{ij}\ge0$ and $\sum_j\beta_{ij}=1$, for every $n$: $\Delta^2b_i^{[u,v]}=(v-u)^2\sum_j\beta_{ij}\Delta^2b_j$.  The first two equations are computed in the field;
  a coefficient of the product is $(1-u)p+uq$ with the coefficients $p$, $q$ of two neighbouring powers, for $u=0$ and $u=1$ as well.
:degrees: all
:scope: every interval of [0,1]
:harmless: $0\le u,v\le1$ | these are the intervals of $[0,1]$
:over: r s Z p q x: -
:control: $v+u$ for $v-u$
:::
*/
CLAIM(differences_over_a_part_are_means)
{
    num one = from_int(1), Z = unknown(T, "Z", 0), u = inside(T, "r"), v = inside(T, "s"),
        place[3] = {u, from_int(0), one};
    num p = positive(T, "p", 0), q = positive(T, "q", 0);
    num length = fault(T, sub(v, u), add(v, u)), x = unknown(T, "x", ALONE);
    num start = G(factor_at)(u, Z), end = G(factor_at)(v, Z);
    about(T, "the factor over the part");
    same(T, G(factor_at)(add(u, mul(x, sub(v, u))), Z), add(mul(sub(one, x), start), mul(x, end)));
    about(T, "the difference of the two factors");
    same(T, sub(end, start), mul(length, sub(Z, one)));
    for (int k = 0; k < 3; k++) {
        about(T, "a coefficient of the product");
        nonnegative(T, add(mul(sub(one, place[k]), p), mul(place[k], q)));
        about(T, "the sum of the coefficients");
        same(T, G(factor_at)(place[k], one), one);
    }
}

/*
:::{claim} larger_numbers_have_larger_powers
:title: Of two positive numbers the larger one has the larger n-th power
:zh: 正数的 n 次幂保持大小
:given: $p>0$, $q=p+d$, $d>0$, and two powers $U=p^n>0$, $q^n=U+V$, $V>0$
:harmless: $p>0$, $q=p+d$, $d>0$, and two powers $U=p^n>0$, $q^n=U+V$, $V>0$ | of two positive numbers that differ one is the
  smaller; the weights of the statements are positive
:then: $q(U+V)-pU>0$
:method: The step of an induction on $n$; for $n=1$ it is $d>0$.  So positive numbers with equal $n$-th powers are equal, for every $n$: of $q^n=(a/b)^n$ with $q,a,b>0$
  the consequence is $q=a/b$.
:degrees: all
:over: p d U V: -
:control: the difference the other way round
:::
*/
CLAIM(larger_numbers_have_larger_powers)
{
    num p = positive(T, "p", 0), d = positive(T, "d", 0), U = positive(T, "U", 0), V = positive(T, "V", 0);
    num larger = mul(add(p, d), add(U, V)), smaller = mul(p, U);
    G(must_be_positive)(T, fault(T, sub(larger, smaller), sub(smaller, larger)));
}

/*
## Determinants of three sums

:::{claim} determinant_of_three_sums_goes_by_triples
:title: The determinant of three sums is a sum over triples of terms, whatever their number
:zh: 三个和的行列式按三元组展开
:given: three terms $H_1,H_2,H_3$ of space and three rows of factors $m_{l1},m_{l2},m_{l3}$; three points $(x_i,y_i)$ of the plane with weights
  $\omega_i$
:then: $\sum_\sigma m_{1\sigma(1)}m_{2\sigma(2)}m_{3\sigma(3)}\det(H_{\sigma(1)},H_{\sigma(2)},H_{\sigma(3)})=\det(m)\det(H)$; and
  $\det(\omega_i(x_i,y_i,1))=\omega_1\omega_2\omega_3D$ with $D$ twice the signed area of the triangle, where $\omega_1\omega_2\omega_3>0$ for positive weights
:method: The determinant of $\sum_im_{1i}H_i$, $\sum_jm_{2j}H_j$, $\sum_km_{3k}H_k$ is linear in every place; its terms with two equal indices are 0,
  and those with the indices $i<j<k$ in some order are the sum on the left.  So the formula of Cauchy and Binet for three rows holds for
  every number of terms.
:degrees: all
:over: m# H#: -
:control: one of the six orders left out
:::
*/
CLAIM(determinant_of_three_sums_goes_by_triples)
{
    static const int order[6][4] = {{0, 1, 2, 1},  {1, 2, 0, 1},  {2, 0, 1, 1},
                                    {0, 2, 1, -1}, {2, 1, 0, -1}, {1, 0, 2, -1}};
    num m[3][3], H[3][3], P[3][3], x[3], y[3], w[3], sum = from_int(0);
    for (int i = 0; i < 3; i++) {
        x[i] = unknown(T, "x", i);
        y[i] = unknown(T, "y", i);
        w[i] = positive(T, "w", i);
        for (int j = 0; j < 3; j++) {
            m[i][j] = unknown(T, "m", 3 * i + j);
            H[i][j] = unknown(T, "H", 3 * i + j);
        }
        P[i][0] = mul(w[i], x[i]);
        P[i][1] = mul(w[i], y[i]);
        P[i][2] = w[i];
    }
    num volume = G(det3)(H[0], H[1], H[2]);
    for (int k = 0; k < fault(T, 6, 5); k++) {
        const int *to = order[k];
        num term = mul(mul(m[0][to[0]], m[1][to[1]]), m[2][to[2]]);
        about(T, "the sign of an order");
        same(T, G(det3)(H[to[0]], H[to[1]], H[to[2]]), mul(from_int(to[3]), volume));
        sum = add(sum, mul(term, G(det3)(H[to[0]], H[to[1]], H[to[2]])));
    }
    about(T, "the six orders together");
    same(T, sum, mul(G(det3)(m[0], m[1], m[2]), volume));
    about(T, "homogeneous points");
    num a[2] = {sub(x[1], x[0]), sub(y[1], y[0])}, b[2] = {sub(x[2], x[0]), sub(y[2], y[0])};
    num weights = mul(w[0], mul(w[1], w[2]));
    same(T, G(det3)(P[0], P[1], P[2]), mul(weights, G(cross2)(a, b)));
    G(must_be_positive)(T, weights);
}

/*
The minors in that sum have one sign.  Divided by $\binom ni\binom nj\binom nk$ and by powers of the $1-t_l$ they are determinants of three powers of
$x_l=\frac{t_l}{1-t_l}$, and these grow in the right order because the means of $1,r,r^2,\dots$ do.

:::{claim} means_of_powers_go_one_way
:title: The mean of the first m powers falls with m for r < 1 and grows for r > 1
:zh: 前 m 个幂的平均随 m 单调
:given: $r>0$, $S_m=1+r+\dots+r^{m-1}$, $U=r^m$; two numbers $0<p<q$, $1\le a<b$
:harmless: two numbers $0<p<q$, $1\le a<b$ | the factors of the method, of two parameters in order
:let: $D_m=S_m-mr^m$
:then: $D_1=1-r$, $D_{m+1}-D_m=(m+1)U(1-r)$, and $mS_{m+1}-(m+1)S_m=-D_m$; with $r=\frac pq$ it is
  $b\,q^{b-a}(q^a-p^a)-a(q^b-p^b)=q^b(1-r)(bS_a-aS_b)>0$, with $r=\frac qp$ it is $a(q^b-p^b)-b\,p^{b-a}(q^a-p^a)=p^b(r-1)(aS_b-bS_a)>0$
:method: Induction on $m$, with $m$, $S_m$, $r$ and $U$ variables: all $D_m$ have the sign of $1-r$.  So $\frac{S_m}m$ falls with $m$ for $r<1$ and grows for $r>1$, for all
  exponents, and $bS_a-aS_b$ has the sign of $1-r$.  In the two equations $r^a=1-(1-r)S_a$, $r^b=1-(1-r)S_b$.  Outside the field the sums are those of a random number of powers.
:degrees: all
:over: m a b S# U# r d Q: -
:control: $m$ for $m+1$
:::
*/
CLAIM(means_of_powers_go_one_way)
{
    num one = from_int(1), d = positive(T, "d", 0);
    for (int side = 0; side < 2; side++) { /* r < 1, r > 1 */
        num r = side == 0 ? div(one, add(one, d)) : add(one, d), rest = sub(one, r);
#if FIELD
        num m = whole(T, "m", 1, 6), S = unknown(T, "S", 0), U = positive(T, "U", 0);
#else
        int count = pick(T, 1, 6);
        num m = from_int(count), S = from_int(0), U = G(power)(r, count);
        for (int k = 0; k < count; k++)
            S = add(S, G(power)(r, k));
#endif
        num next = add(S, U), D = sub(S, mul(m, U)), D_next = sub(next, mul(add(m, one), mul(U, r)));
        about(T, "from one number of powers to the next");
        same(T, sub(D_next, D), mul(mul(fault(T, add(m, one), m), U), rest));
        about(T, "the means");
        same(T, sub(mul(m, next), mul(add(m, one), S)), neg(D));
        about(T, "one power");
        same(T, sub(one, mul(one, r)), rest);
        about(T, "the sign");
        G(must_be_positive)(T, side == 0 ? rest : neg(rest));
        G(must_be_positive)(T, mul(mul(add(m, one), U), side == 0 ? rest : neg(rest)));
        /* r^a = 1 - (1-r) S_a, r^b = 1 - (1-r) S_b; Q = q^b for r < 1, p^b for r > 1 */
        num a = whole(T, "a", 1, 3), b = add(a, whole(T, "b", 1, 3)), Q = positive(T, "Q", 0);
        num of_a = unknown(T, "S", 1), of_b = unknown(T, "S", 2);
        num power_a = sub(one, mul(rest, of_a)), power_b = sub(one, mul(rest, of_b));
        num scaled = mul(b, mul(Q, sub(one, power_a))), whole_gap = mul(a, mul(Q, sub(one, power_b)));
        about(T, "differences of powers");
        same(T, sub(scaled, whole_gap), mul(mul(Q, rest), sub(mul(b, of_a), mul(a, of_b))));
    }
}

/*
:::{claim} three_powers_have_a_positive_determinant
:title: Three Bernstein functions at three parameters have a positive determinant, in every degree
:zh: 三个 Bernstein 基函数在三个参数处的行列式为正(任意次数)
:given: $0\le i<j<k\le n$, $0<t_1<t_2<t_3<1$; numbers $u_1<u_2<u_3$ and $v_l$ with $v_2-v_1=c(u_2-u_1)-f$, $v_3-v_2=c(u_3-u_2)+e$, $c,e,f>0$
:then: $\det(1,u_l,v_l)=e(u_2-u_1)+f(u_3-u_2)>0$; and the minor $M_{ijk}$ of $(B_m(t_l))$ is a positive number times such a determinant, with
  $u_l=x_l^{j-i}$, $v_l=x_l^{k-i}$, $x_l=\frac{t_l}{1-t_l}$; so $M_{ijk}>0$
:method: $B_m(t_l)=\binom nm(1-t_l)^nx_l^m$: the columns have the factors $\binom nm$, the rows $(1-t_l)^nx_l^i$.  The $x_l$ grow with $t_l$, and with $c=\frac{k-i}{j-i}x_2^{k-j}$
  the inequalities $e,f>0$ are those of `means_of_powers_go_one_way` for the pairs $x_1<x_2$ and $x_2<x_3$, $a=j-i$, $b=k-i$.  Outside the field the minors of a random
  degree are computed from the Bernstein functions and compared with this product.
:degrees: all
:scope: any three parameters inside $(0,1)$, in order
:over: u v p q c e f s: -
:control: the two differences of $v$ exchanged
:::
*/
CLAIM(three_powers_have_a_positive_determinant)
{
    num one = from_int(1), u = unknown(T, "u", 0), v = unknown(T, "v", 0), p = positive(T, "p", 0),
        q = positive(T, "q", 0);
    num c = positive(T, "c", 0), e = positive(T, "e", 0), f = positive(T, "f", 0);
    num less = sub(mul(c, p), f), more = add(mul(c, q), e), row[3][3] = {{one, u, v}};
    num first = fault(T, less, more), second = fault(T, more, less);
    row[1][0] = one;
    row[1][1] = add(u, p);
    row[1][2] = add(v, first);
    row[2][0] = one;
    row[2][1] = add(row[1][1], q);
    row[2][2] = add(row[1][2], second);
    num determinant = add(mul(e, p), mul(f, q));
    about(T, "the determinant");
    same(T, G(det3)(row[0], row[1], row[2]), determinant);
    G(must_be_positive)(T, determinant);
    num s = inside(T, "s"); /* t_1 = s, t_2 = s + p (1 - s)/(1 + p), and so t_2 for t_1: x grows */
    num later = add(s, mul(sub(one, s), div(p, add(one, p))));
    about(T, "x grows with t");
    G(must_be_positive)(T, sub(div(later, sub(one, later)), div(s, sub(one, s))));
#if !FIELD
    int i = pick(T, 0, 2), j = i + pick(T, 1, 2), k = j + pick(T, 1, 2), n = k + pick(T, 0, 2);
    num basis[MAX_DEGREE + 1], M[3][3], powers[3][3], t = s, factor = from_int(1);
    for (int l = 0; l < 3; l++) {
        num rest = sub(one, t), x = div(t, rest);
        G(bernstein_basis)(n, t, basis);
        const int index[3] = {i, j, k};
        for (int m = 0; m < 3; m++) {
            M[l][m] = basis[index[m]];
            powers[l][m] = G(power)(x, index[m] - i);
            factor = l == 0 ? mul(factor, from_int(binomial(n, index[m]))) : factor;
        }
        factor = mul(factor, mul(G(power)(rest, n), G(power)(x, i)));
        t = add(t, mul(rest, from_ratio(2, 5)));
    }
    about(T, "a minor of the Bernstein functions");
    same(T, G(det3)(M[0], M[1], M[2]), mul(factor, G(det3)(powers[0], powers[1], powers[2])));
    about(T, "its sign");
    nonnegative(T, G(det3)(M[0], M[1], M[2]));
#endif
}

/*
A cut of corners makes new points of neighbouring old ones.  Its matrix has two numbers in each row, one place further to the right from row to row.

:::{claim} one_cut_of_corners_has_no_negative_minor
:title: A matrix that cuts corners once has no negative minor of three rows
:zh: 一次割角矩阵的三阶子式非负
:given: three rows of a matrix whose row $l$ has the entries $p_l\ge0$ and $q_l\ge0$ in the columns $l-1$ and $l$ and 0 elsewhere; rows that are neighbours or not
:then: every $3\times3$ minor is $\ge0$
:method: Rows that are not neighbours have no column in common, whatever their distance, so that distances of 1 and 2 are all; columns in which the three rows have nothing
  make the minor 0.  All minors of the other columns are computed, with the entries variables.  De Casteljau's step from one level to the next, on the whole polygon $b_0^0,\dots,b_r^r,\dots,b_n^r,\dots,b_n^0$, is
  such a matrix with $p_l=1-\lambda$, $q_l=\lambda$ or with one entry 1, and by `determinant_of_three_sums_goes_by_triples` the determinants of three new points are sums of such minors times those of three
  old ones.  So, step after step, if no determinant of three of the points of a polygon is negative, then none of the two halves joined is, for every $n$.
:degrees: all
:scope: every point of division
:harmless: $p_l\ge0$ and $q_l\ge0$ | they are $1-\lambda$ and $\lambda$ times positive weights, $0\le\lambda\le1$
:over: p# q#: -
:control: one entry negative, as for $\lambda>1$
:::
*/
CLAIM(one_cut_of_corners_has_no_negative_minor)
{
    enum { COLUMNS = 6 };
    for (int gaps = 0; gaps < 4; gaps++) {
        num row[3][COLUMNS];
        for (int l = 0, at = 0; l < 3; l++, at += 1 + (l == 1 ? gaps & 1 : gaps >> 1)) {
            for (int m = 0; m < COLUMNS; m++)
                row[l][m] = from_int(0);
            num p = positive(T, "p", l), q = positive(T, "q", l);
            row[l][at] = fault(T, p, l == 0 ? neg(p) : p);
            row[l][at + 1] = q;
        }
        for (int k = 2; k < COLUMNS; k++)
            for (int j = 1; j < k; j++)
                for (int i = 0; i < j; i++) {
                    num minor[3][3];
                    for (int l = 0; l < 3; l++) {
                        minor[l][0] = row[l][i];
                        minor[l][1] = row[l][j];
                        minor[l][2] = row[l][k];
                    }
                    nonnegative(T, G(det3)(minor[0], minor[1], minor[2]));
                }
    }
}

/*
## Changes of sign, one by one

Descartes' rule comes from multiplying by $s-\rho$, one positive root $\rho$ after the other: each adds a change of sign.

:::{claim} factor_of_a_positive_root_adds_a_sign_change
:title: Multiplied by s − ρ a polynomial has one change of sign more, at least
:zh: 乘以正根因子至少增加一次变号
:given: $q(s)=\sum q_ms^m$, not 0, of any degree, $\rho>0$, $p(s)=(s-\rho)q(s)$, so $p_m=q_{m-1}-\rho q_m$; positive numbers $a$, $b$
:harmless: positive numbers $a$, $b$ | absolute values of coefficients that are not 0
:harmless: not 0, of any degree | the polynomial with no roots to count is left out by the rule itself
:let: $V$ the number of changes of sign, where zeros are left out
:then: $a+\rho b>0$ and $\rho a>0$; so $V[p]\ge V[q]+1$, and by induction a polynomial has no more positive roots, counted with multiplicity, than
  changes of sign
:method: Read from the highest power downwards.  $p$ begins with the first coefficient of $q$.  Where $q$ changes its sign from $\sigma$ to $-\sigma$, let $q_i=-\sigma a$ be the
  first coefficient of the new sign; $q_{i+1}$ is 0 or $\sigma b$, and $p_{i+1}=q_i-\rho q_{i+1}$ is $-\sigma a$ or $-\sigma(a+\rho b)$, of the sign of $q_i$.  And if $q_i=\sigma a$ is the last
  coefficient that is not 0, then $p_i=-\rho q_i$ has the other sign.  These coefficients of $p$ have $V[q]+1$ changes of sign, and leaving out numbers does not add
  any (`averages_between_neighbours_keep_sign_changes`).  Outside the field the changes of sign of random polynomials are counted as well.
:degrees: all
:over: a b r: -
:control: $\rho$ negative, where nothing need be added
:::
*/
CLAIM(factor_of_a_positive_root_adds_a_sign_change)
{
    num a = positive(T, "a", 0), b = positive(T, "b", 0), r = positive(T, "r", 0), root = fault(T, r, neg(r));
    about(T, "where the sign changes");
    G(must_be_positive)(T, add(a, mul(r, b)));
    about(T, "the last coefficient, turned");
    G(must_be_positive)(T, mul(root, a));
#if RATIONAL
    int n = pick(T, 1, 9);
    int of_q[11], of_p[11];
    num q[11], p[11];
    for (int m = 0; m <= n; m++)
        q[m] = from_int(m < n ? pick(T, -2, 2) : 1);
    for (int m = 0; m <= n + 1; m++) {
        num high = m > 0 ? q[m - 1] : from_int(0), low = m <= n ? mul(root, q[m]) : from_int(0);
        p[m] = sub(high, low);
    }
    signs_of(n + 1, q, of_q);
    signs_of(n + 2, p, of_p);
    agree(T, sign_changes(n + 2, of_p) >= sign_changes(n + 1, of_q) + 1);
#endif
}

#if RATIONAL
/*

A change of sign in a sequence is noticed at one number: it is where the number has a sign, and the last sign before is the other one.  So a
statement on sequences of every length is one about a number and the last sign before.

:::{claim} sign_changes_are_counted_one_by_one
:title: Changes of sign in sequences of every length
:zh: 任意长数列的变号数
:kind: decision
:given: the last sign $l\in\{-1,0,1\}$ in a sequence, 0 where there is none yet, and the next number, of sign $s\in\{-1,0,1\}$
:then: (1) when both are multiplied by positive numbers, a change stays a change, and no change comes in; (2) when the signs up to the first change of sign are
  reversed and those behind it kept, that change disappears and all others stay; (3) a point that runs along an edge from height $a$ to height $s$, having been
  last on side $l$, $l=a$ if $a\ne0$, changes sides once if $ls<0$, else not at all, and is then on side $s$, or still on $l$ for $s=0$
:method: All cases of $l$, $s$, $a$ and of their places before or behind the first change are visited.  Added up over a sequence of any length: (1) gives
  $V[c_iy_i]=V[y_i]$ for all $c_i>0$; (2) $V[(m-\alpha)c_m]=V[c_m]-1$ for $\alpha$ between the two places of the first change; (3) $V[y_i]$ is how often
  the polygon with the heights $y_i$ changes sides.  In (3) the sides at $\frac14$ and $\frac34$ of the edge are read, for the heights $-1$, 0 and 1; heights of
  other size and the same signs change sides as often, since along an edge the height is linear.
:degrees: all
:control: the signs behind the first change reversed too
:::
*/
CLAIM(sign_changes_are_counted_one_by_one)
{
    for (int l = -1; l <= 1; l++)
        for (int s = -1; s <= 1; s++) {
            int change = l * s < 0;
            num scaled[2] = {mul(from_ratio(2, 7), from_int(l)), mul(from_int(5), from_int(s))};
            agree(T, (sign_q(scaled[0]) * sign_q(scaled[1]) < 0) == change);
            for (int behind = 0; behind <= 2; behind++) { /* how many of the two are behind the first change */
                int first = behind < 2 ? -l : l, second = behind < 1 ? -s : s;
                if (fault(T, 0, 1))
                    first = -l, second = -s;
                int is_first = behind == 1 && change;
                int possible = behind == 2 || (behind == 1 ? l != 0 && (change || s == 0) : !change);
                agree(T, !possible || (first * second < 0) == change - is_first);
            }
            for (int a = -1; a <= 1; a++) {
                int side = l, changes = 0;
                if (a != 0 && a != l)
                    continue;
                for (int quarter = 1; quarter <= 3; quarter += 2) {
                    int height = (4 - quarter) * a + quarter * s; /* four times the height there */
                    changes += height * side < 0;
                    side = height != 0 ? height : side;
                }
                agree(T, changes == change && (side > 0) - (side < 0) == (s != 0 ? s : l));
            }
        }
}
#endif

#include "chapters/judge/claims_off.h"
