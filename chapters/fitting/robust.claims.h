/*
# Losses and criteria (稳健损失与信息准则)

A wrong point pulls with the square of its distance.  Huber's loss stops the pull from growing, Cauchy's lets go.  With
$s=|D|^2/\sigma^2$ and the scale $a>0$

$$\rho_{\text{Huber}}(s)=\begin{cases}s&s\le a^2\\2a\sqrt s-a^2&s\ge a^2\end{cases}\qquad\rho_{\text{Cauchy}}(s)=a^2\log\Bigl(1+\frac s{a^2}\Bigr).$$

The pull on the curve is $\rho'(s)\sqrt s$, up to a factor: $\sqrt s$ for squares.
*/
#include "chapters/fitting/definition.h"

#if RATIONAL
#include "exact/record/roots.h"
#endif

#include "chapters/judge/claims_on.h"

/*
## Losses
*/

#if FIELD
/*
:::{claim} huber_pull_is_bounded_and_continuous
:title: Huber's loss is continuous with its slope, its second derivative jumps, its pull ends at a
:zh: Huber 损失的连续性与有界拉力
:types: field
:given: $a>0$ and $s=r^2$, $r>0$
:where: $a>0$ and $r>0$
:then: at $r=a$ both pieces have the value $a^2$ and the slope $1$; $\rho''$ is $0$ before and $-\frac1{2a^2}$ after it; for $r\ge a$ the pull is $a$
:method: Derivatives by $s$ are those by $r$ over $2r$, taken in the field.
:over: a; r
:control: the second piece without its $-a^2$
:::
*/
/* d/ds of a function of r = sqrt(s) */
static num by_square(num f, num r) { return div(derivative_f(f, r), mul(from_int(2), r)); }

CLAIM(huber_pull_is_bounded_and_continuous)
{
    num a = positive(T, "a", 0), r = positive(T, "r", 0), near = mul(r, r),
        far = fault(T, sub(mul(mul(from_int(2), a), r), mul(a, a)), mul(mul(from_int(2), a), r));
    num slope = by_square(far, r);
    about(T, "at r = a");
    same(T, substitute_f(far, r, a), substitute_f(near, r, a));
    same(T, substitute_f(slope, r, a), substitute_f(by_square(near, r), r, a));
    vanishes(T, by_square(by_square(near, r), r));
    same(T, substitute_f(by_square(slope, r), r, a), div(from_int(-1), mul(from_int(2), mul(a, a))));
    about(T, "the pull");
    same(T, mul(slope, r), a);
}
#endif

/*
Huber's pull never fades: a point at any distance pulls as one at the distance $a$.  Cauchy's reaches its greatest value there and
then tends to 0, so that a point far away is forgotten.

:::{claim} cauchy_pull_has_its_greatest_value_at_its_scale
:title: Cauchy's pull is at most a/2, at the distance a, and fades beyond
:zh: Cauchy 损失的拉力以 a/2 为界
:given: $a>0$ and $r\ge0$
:where: $a>0$ and $r\ge0$
:let: $\rho'(s)=\frac1{1+s/a^2}$ at $s=r^2$, so that the pull is $\frac{r}{1+r^2/a^2}$
:then: $\frac a2-\frac r{1+r^2/a^2}=\frac{(a-r)^2}{2a\,(1+r^2/a^2)}\ge0$; and $\frac{a^2}r-\frac r{1+r^2/a^2}=\frac{a^2}{r\,(1+r^2/a^2)}>0$ for $r>0$, so that
  the pull tends to 0
:method: The identities in the field; what is squared is not negative.
:over: a; r
:control: $a$ in the place of $\frac a2$
:::
*/
CLAIM(cauchy_pull_has_its_greatest_value_at_its_scale)
{
    num a = positive(T, "a", 0), r = positive(T, "r", 0), one = from_int(1), two = from_int(2);
    num below = add(one, div(mul(r, r), mul(a, a))), gap = sub(a, r);
    num bound = fault(T, div(a, two), a);
    /* a/2 - r/(1 + r^2/a^2) = (a-r)^2 / (2a (1 + r^2/a^2)) */
    about(T, "the greatest value");
    same(T, sub(bound, div(r, below)), div(mul(gap, gap), mul(mul(two, a), below)));
    about(T, "far away");
    same(T, sub(div(mul(a, a), r), div(r, below)), div(mul(a, a), mul(r, below))); /* a²/r - r/(1 + r²/a²) > 0 */
}

#if RATIONAL
/*
A pull that fades has a price: where points disagree, there are several minima, and the one that is found depends on the start.

:::{claim} cauchy_has_one_minimum
:title: Cauchy's loss has several stationary points where points disagree
:zh: Cauchy 损失可有多个驻点
:kind: counterexample
:data: a = 1; Q = -3 3
:instead: a = 4
:result: numerator of F' = "2*x^3 - 16*x"; stationary points = 3
:given: the scale $a$ and two points $Q_1,Q_2$ of a line, to which one number $x$ is fitted
:then: $2F(x)=\rho((x-Q_1)^2)+\rho((x-Q_2)^2)$ has more than one stationary point
:method: $F'=\sum_i\frac{x-Q_i}{1+(x-Q_i)^2/a^2}$ has the signs of its numerator, since the denominators are positive.  The real roots of the numerator
  are counted exactly; that there is one is refuted.
:control: a scale that is greater than the distance of the points from their middle
:::
*/
CLAIM(cauchy_has_one_minimum)
{
    num a = given(T, "a"), aa = mul(a, a), Q[2], one = from_int(1);
    given_points(T, "Q", 2, 1, Q);
    poly square = poly_constant(aa), D[2], below[2]; /* x - Q_i, a^2 + (x - Q_i)^2 */
    for (int i = 0; i < 2; i++) {
        D[i] = poly_from_q(2, (num[]){neg(Q[i]), one});
        below[i] = poly_add(square, poly_mul(D[i], D[i]));
    }
    poly slope = poly_add(poly_mul(D[0], below[1]), poly_mul(D[1], below[0]));
    struct cagd_root_count real = count_roots_line(slope);
    int roots = real.crossings + real.touches;
    found_text(T, "numerator of F'", poly_to_string(slope, "x"));
    found_whole(T, "stationary points", roots);
    about(T, "stationary points");
    same(T, from_int(roots), one);
}
#endif

/*
## Criteria

With $n=N(\dim-1)$ equations and $k$ unknowns that are determined, $\mathrm{AIC}=-2\log L+2k$ and $\mathrm{BIC}=-2\log L+k\log n$, $L$ being the greatest likelihood.
For given standard deviations $-2\log L=\chi^2$ but for a constant.  When $\sigma$ is unknown, it is one of the unknowns:
*/

#if FIELD
/*
For a given mean square of the residuals $-2\log L$ is a function of the one unknown $v=\sigma^2$, and its minimum is found by one derivative.

:::{claim} likelihood_chooses_the_mean_square
:title: The likelihood of an unknown standard deviation is greatest at the mean square of the residuals
:zh: 方差的极大似然估计
:types: field
:given: $n,\chi^2,v>0$, and $g(v)=n\log v+\chi^2/v$, which is $-2\log L$ but for a constant
:where: $n,\chi^2,v>0$
:then: $g'(v)=\frac{n\,(v-\chi^2/n)}{v^2}$: $g$ falls before $v=\chi^2/n$ and grows after it.  There it is $n\log\frac{\chi^2}n+n$, hence
  $\mathrm{AIC}=n\log\frac{\chi^2}n+2(k+1)$ but for a constant, and $\mathrm{BIC}$ the same with $\log n$ in the place of $2$
:method: $g'=n/v+(\chi^2/v)'$, the second derivative taken in the field, the first one being that of the logarithm.
:degrees: all
:over: n: -; c: χ²; v
:control: the mean over $n-1$
:::
*/
CLAIM(likelihood_chooses_the_mean_square)
{
    num n = positive(T, "n", 0), chi = positive(T, "c", 0), v = positive(T, "v", 0);
    num slope = add(div(n, v), derivative_f(div(chi, v), v));
    num mean = div(chi, fault(T, n, sub(n, from_int(1))));
    /* g'(v) = n (v - chi^2/n)/v^2 */
    same(T, slope, div(mul(n, sub(v, mean)), mul(v, v)));
}
#endif

/*
## Student's distribution (学生 t 分布)

The 95 % intervals are estimate plus and minus $t$ standard errors.  With $\nu$ degrees of freedom and $t=\sqrt\nu\tan\theta$ the density of $\theta$ is
proportional to $\cos^{\nu-1}\theta$, and its integral is elementary:
*/

#if FIELD || RATIONAL
/*
So no table and no numerical integration is needed: for whole $\nu$ the probability is a sum of $\nu/2$ terms or so.

:::{claim} student_probability_is_a_finite_sum
:title: The probability of Student's distribution is a finite sum of powers of the cosine
:zh: t 分布函数的有限和
:types: field rational
:given: $\nu=n$, $s=\sin\theta$, $c=\cos\theta$
:let: $A=s\,(1+\frac12c^2+\frac{1\cdot3}{2\cdot4}c^4+\dots)$ up to $c^{\nu-2}$ for even $\nu$; $A=\theta+s\,(c+\frac23c^3+\frac{2\cdot4}{3\cdot5}c^5+\dots)$ up to $c^{\nu-2}$ for odd $\nu$
:then: $\frac{dA}{d\theta}=\frac{3\cdot5\cdots(\nu-1)}{2\cdot4\cdots(\nu-2)}c^{\nu-1}$ for even $\nu$, $\frac{2\cdot4\cdots(\nu-1)}{3\cdot5\cdots(\nu-2)}c^{\nu-1}$ for odd $\nu$
:method: $\frac{dc}{d\theta}=-s$, $\frac{ds}{d\theta}=c$, $s^2=1-c^2$: the derivative is a polynomial in $c$, term by term $(c^{j}s)'=(j+1)c^{j+1}-jc^{j-1}$.
:degrees: 2..12 sampled 24
:over: c: angle
:control: the last coefficient doubled
:::
*/
CLAIM(student_probability_is_a_finite_sum)
{
    int nu = T->degree, odd = nu % 2;
    num c = parameter(T, "c"), slope = from_int(odd), coefficient = from_int(1), factor = from_int(1), power[26];
    for (int k = 0; k < nu; k++)
        power[k] = k == 0 ? from_int(1) : mul(c, power[k - 1]);
    for (int j = odd; j <= nu - 2; j += 2) {
        if (j > odd)
            coefficient = mul(coefficient, from_ratio(j - 1, j));
        num used = fault(T, coefficient, j == nu - 2 ? mul(from_int(2), coefficient) : coefficient);
        slope = add(slope, mul(used, mul(from_int(j + 1), power[j + 1])));
        if (j > 0)
            slope = sub(slope, mul(used, mul(from_int(j), power[j - 1])));
    }
    for (int j = nu - 1; j > 1; j -= 2) /* the numbers above and below the fraction */
        factor = div(mul(factor, from_int(j)), j > 2 ? from_int(j - 1) : from_int(1));
    num value = power[nu - 1];
    same(T, slope, mul(factor, value));
}
#endif

#include "chapters/judge/claims_off.h"
