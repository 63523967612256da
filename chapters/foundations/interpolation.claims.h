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
:checked-by: newton_sum_of_every_degree_interpolates
:confirmed-by: one_cubic_passes_through_four_data
:figure: through_and_near
:::

:::{claim} one_cubic_passes_through_four_data
:title: Through n+1 data at the parameters 0, 1, ..., n passes one curve of degree n or less
:zh: n+1 个型值点唯一确定不超过 n 次的插值曲线
:given: data $p_0,\dots,p_n$, any numbers
:then: $P(t)=\sum_k\binom tk\Delta^kp_0$ has $P(i)=p_i$; and the data of any curve of degree $n$ or less give that curve back, so there is no other
:method: The differences of the data by $n$ passes of subtraction, $\binom tk=\frac{t(t-1)\cdots(t-k+1)}{k!}$; at the $n+1$ places, and at a
  variable $t$ for the values of a curve with variable coefficients.
:degrees: 1..6 sampled 10
:over: p#: data; x#: coefficients
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
:::{claim} newton_sum_of_every_degree_interpolates
:title: Through n+1 data at the parameters 0, 1, ..., n passes one curve of degree n or less, for every n
:zh: n+1 个型值点唯一确定不超过 n 次的插值曲线(任意 n)
:given: $b=\binom t{k-1}$, so that $\binom tk=b\,\frac{t-k+1}k$ and $\binom{t+1}k=b\,\frac{t+1}k$, any $t$ and integer $k\ge1$
:then: (1) $\binom{t+1}k-\binom tk=\binom t{k-1}$; (2) $t\binom t{k-1}=k\binom tk+(k-1)\binom t{k-1}$; (3) $\binom tk=0$ at $t=0$
:method: With $t$, $k$ and $b$ variables; (3) for $k=1$, where $b=1$, and then every further one has the one before as a factor.  By (1) the step
  $P(t+1)-P(t)$ of $P(t)=\sum_{k=0}^nd_k\binom tk$ is $\sum_{k=1}^nd_k\binom t{k-1}$, and by (3) $P(0)=d_0$.  So the $k$-th difference at 0 is $d_k$, and
  with $d_k=\Delta^kp_0$ the values at $0,1,\dots,n$, which these differences determine by addition, are the data.  By (2) and
  induction every polynomial of degree $n$ or less is such a sum, and so the one with these $d_k$.
:degrees: all
:over: t; k b: -
:control: $\binom{t+1}k$ taken as $b\,\frac tk$
:::
*/
CLAIM(newton_sum_of_every_degree_interpolates)
{
    num t = parameter(T, "t"), b = unknown(T, "b", ALONE), k = whole(T, "k", 1, 20), one = from_int(1);
    num before = sub(k, one), next = mul(b, div(sub(t, before), k));
    num later = mul(b, div(fault(T, add(t, one), t), k));
    about(T, "the difference of a binomial coefficient");
    same(T, sub(later, next), b);
    about(T, "the product with t");
    same(T, mul(t, b), add(mul(k, next), mul(before, b)));
    about(T, "the first of them at 0");
    vanishes(T, G(binomial_of)(from_int(0), 1));
}

/*
A table of data determines the curve of degree $n$ through it, and nothing remains to be chosen.  That is the strength
of interpolation (插值) and its weakness: an error of one datum is followed as faithfully as the others, and each further
datum raises the degree.  The other requirement, approximation (逼近), leaves the degree alone and gives up the data.  It
needs one thing that interpolation does without, a measure of the distance from all data together.

:::{statement} hu-1987:1-1-approximation
:title: Approximation
:zh: 逼近的定义
:definition: yes
:printed: Approximation does not require that the curve or surface passes through all data strictly, but only that the curve found is nearest
  to them as a whole.
:checked-by: nearest_line_meets_no_datum
:example: of all straight lines the nearest one to three data, for which the sum of the squares of the upright distances is least, passes through none of them.
:figure: through_and_near
:::

Three data that go up and down again are enough to see the difference.  A parabola passes through them.  The nearest of
all straight lines is level, between the lower data and the higher one, and touches neither: a curve can be nearest to
the data as a whole although it is far from each of them.

:::{statement} hu-1987:1-1-fitting
:title: Fitting is the common name of both
:zh: 拟合的定义
:definition: yes
:printed: In study and discussion interpolation and approximation of curves and surfaces together are usually called fitting.
:figure: through_and_near
:::
*/

/*
The plainest description needs neither: a curve can be kept as many points, joined by segments.

:::{statement} hu-1987:1-1-point-sets
:title: A curve as a set of points takes much memory, and has other disadvantages
:zh: 点集与折线表示的缺点
:printed: In geometric design curves and surfaces can be represented by point sets, and a curve be approximated by a polyline of small
  pieces.  The disadvantages: it takes much memory, is mathematically inconvenient, and the shape is not easily controlled.
:reading: polyline_of_a_parabola_needs_many_points | it takes much memory: a polyline with its corners on a parabola needs the more pieces
  the less it may err, $N$ pieces on $y=x^2$ over $[0,1]$ err by $\frac1{4N^2}$ at least, measured upright, and three coefficients keep the parabola
  exactly
:reading: how much is much, what is inconvenient and what not easy: opinions, which no computation decides
:figure: through_and_near
:::

:::{claim} polyline_of_a_parabola_needs_many_points
:title: A piece of a polyline leaves the parabola, measured upright, by a quarter of the square of the length of its interval
:zh: 折线与抛物线的偏差
:given: the parabola $y=x^2$ and its chord over $[a,a+h]$, any $a$, $h$ and $s$; $N$ pieces that are together shorter than $Nh$ by $g$, and one more, of the
  length $h-d$
:then: at $a+s$ the chord is $s(h-s)$ above the curve, which is less than $\frac{h^2}4$ by $(\frac h2-s)^2$; the $N+1$ pieces are together shorter than
  $(N+1)h$ by $g+d$; so of $N$ pieces over $[0,1]$ one is not shorter than $\frac1N$, and the error is at least $\frac1{4N^2}$, and no more when all have one
  length
:method: Identities, everything a variable; the pieces by induction, $h$ being the length of the longest, so that no $d$ is negative.
:scope: every number of pieces
:over: a h s N g d: -
:control: the chord from $a$ to $a+2h$
:::
*/
CLAIM(polyline_of_a_parabola_needs_many_points)
{
    num a = unknown(T, "a", 0), h = unknown(T, "h", 0), s = unknown(T, "s", 0);
    num end = add(a, fault(T, h, add(h, h))), x = add(a, s), half = mul(from_ratio(1, 2), h);
    num chord = add(mul(a, a), mul(s, add(a, end))), gap = mul(s, sub(h, s));
    about(T, "the chord above the curve");
    same(T, sub(chord, mul(x, x)), gap); /* s (h - s) */
    same(T, sub(mul(half, half), gap), G(power)(sub(half, s), 2));
    num N = whole(T, "N", 1, 20), g = positive(T, "g", 0), d = positive(T, "d", 0);
    num together = add(sub(mul(N, h), g), sub(h, d));
    about(T, "the length of one piece more");
    same(T, sub(mul(add(N, from_int(1)), h), together), add(g, d));
}

#if RATIONAL
/*
:::{claim} nearest_line_meets_no_datum
:title: The line nearest to three data meets none of them
:zh: 最小二乘直线不过型值点
:kind: decision
:given: the data $p_t$ at $t=0,1,2$; the level line of height $a$, and all lines $a+\alpha+\beta t$; distances measured upright, $|a+\alpha+\beta t-p_t|$
:data: p = 0 1 0; a = 1/3
:instead: a = 1/2
:then: the sum of the squares of the distances is $m+q_0\alpha^2+q_1\alpha\beta+q_2\beta^2$, where the form with the coefficients $q$ is
  positive for $(\alpha,\beta)\ne(0,0)$: the level line is the only nearest one, and meets no datum
:result: m = 2/3; q = 3 6 5
:method: $m$ is the sum for $\alpha=\beta=0$, and $q_0,q_1,q_2$ are the sums of $1$, $2t$ and $t^2$.  The two expressions are compared at
  six pairs $(\alpha,\beta)$ that determine a polynomial of degree 2 in two variables; the distances of the line from the data are not 0.
:control: a higher line
:::
*/
/* The sum over t of (a + alpha + beta t - p_t)^2. */
static num sum_of_squares(const num p[], num a, num alpha, num beta)
{
    num sum = from_int(0);
    for (int t = 0; t < 3; t++) {
        num gap = sub(add(add(a, alpha), mul(beta, from_int(t))), p[t]);
        sum = add(sum, mul(gap, gap));
    }
    return sum;
}

CLAIM(nearest_line_meets_no_datum)
{
    static const int pairs[6][2] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {-1, 0}, {0, -1}};
    num p[3], q[3] = {from_int(0), from_int(0), from_int(0)};
    given_points(T, "p", 3, 1, p);
    num a = given(T, "a"), m = sum_of_squares(p, a, from_int(0), from_int(0));
    for (int t = 0; t < 3; t++) {
        q[0] = add(q[0], from_int(1));
        q[1] = add(q[1], from_int(2 * t));
        q[2] = add(q[2], from_int(t * t));
    }
    found(T, "m", m);
    found_points(T, "q", 3, 1, q);
    for (int k = 0; k < 6; k++) {
        num alpha = from_int(pairs[k][0]), beta = from_int(pairs[k][1]);
        num form = add(add(mul(q[0], mul(alpha, alpha)), mul(q[1], mul(alpha, beta))), mul(q[2], mul(beta, beta)));
        same(T, sum_of_squares(p, a, alpha, beta), add(m, form));
    }
    for (int t = 0; t < 3; t++)
        agree(T, !equal_q(a, p[t]));
    /* The form is positive: q_0 > 0 and 4 q_0 q_2 > q_1^2. */
    agree(T, sign_q(q[0]) > 0 && compare_q(mul(from_int(4), mul(q[0], q[2])), mul(q[1], q[1])) > 0);
}
#endif

#include "chapters/judge/claims_off.h"
