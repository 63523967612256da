/*
# The B-spline basis (B 样条基)

A B-spline is a piecewise polynomial that is as smooth as its knots allow and vanishes outside the shortest interval on
which it can: $N_{i,p}$ lives on $[u_i,u_{i+p+1}]$.  The recursion of de Boor and Cox defines it,

$$N_{i,0}=\begin{cases}1,&u_i\le t<u_{i+1}\\0,&\text{otherwise}\end{cases},\qquad
N_{i,p}(t)=\frac{t-u_i}{u_{i+p}-u_i}N_{i,p-1}(t)+\frac{u_{i+p+1}-t}{u_{i+p+1}-u_{i+1}}N_{i+1,p-1}(t),$$

where a fraction with the denominator $0$ counts as $0$.  On a span only $p+1$ of these functions do not vanish; the
kernel computes just these, and on the span no denominator is $0$.

Which knots coincide is enumerated by a program, `patterns.h`, in this section and in those that follow.  *Every segment* of
degree $p\le3$ means all $4^{p-1}$ patterns of the $p$ knots on either side of an interval; for larger $p$ it means simple
knots, clamped ends, and each multiplicity of one end against the complementary one of the other.  *Several segments* means an
inner knot of every multiplicity $0,\dots,p+1$ between ends that are simple, clamped, or clamped and double, and for $p\le2$
all patterns of $2p+3$ knots with a domain and none more than $(p+1)$-fold as well; where it is said that two knots are $0$ and $1$, the simple and the clamped ends.  The field meets all of them; where numbers are random, so is a selection of the
patterns.
*/
#include "chapters/nurbs/definition.h"
#include "chapters/nurbs/patterns.h"
#include "exact/record/total_positivity.h"

#include "chapters/judge/claims_on.h"

/*
The recursion by its letter looks at all $n$ functions and at every half-open interval. The kernel does not: it starts from the
span and never tests whether a denominator is $0$. That both agree is therefore no matter of course; the kernels of the later
sections rest on it.

:::{claim} bspline_basis_follows_definition
:title: The values of the kernel are the B-splines of the span, and the others vanish there
:zh: 核函数所算的值即该区间上的 B 样条基
:given: several segments, the distinct knots variables; every interval of the domain; any $t$
:then: `bspline_basis` gives $N_{\mu-p,p}(t),\dots,N_{\mu,p}(t)$, and $N_{i,p}=0$ on the span for every other $i$
:method: The kernel against the recursion of de Boor and Cox by its letter, for each index $i$ of the knot vector.
:degrees: 0..6 sampled 7
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:defines: bspline_basis_level bspline_basis
:control: the span of the interval replaced by its neighbour on the left or, in the first interval, on the right
:::
*/
CLAIM(bspline_basis_follows_definition)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num N[MAX_DEGREE + 1], t = parameter(T, "t");
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K))
        for (int interval = K.place[p]; interval < K.place[K.n]; interval += 2) {
            int mu = G(span_of_interval)(K.count, K.place, interval), used = mu;
            if (T->faulty && interval + 2 < K.place[K.n])
                used = G(span_of_interval)(K.count, K.place, interval + 2);
            else if (T->faulty && interval > K.place[p])
                used = G(span_of_interval)(K.count, K.place, interval - 2);
            G(bspline_basis)(p, K.u, used, t, N);
            about(T, "N_i on the span");
            for (int i = 0; i < K.n; i++) {
                num value = i < mu - p || i > mu ? from_int(0) : N[i - mu + p];
                same(T, value, G(cox_de_boor)(p, K.u, K.place, i, interval, t));
            }
        }
}

/*
The same functions have a definition without a recursion, as divided differences of a truncated power.  For simple knots it
is a sum over the knots.

:::{claim} bspline_is_divided_difference
:title: A B-spline is a divided difference of the truncated power
:zh: B 样条是截断幂函数的差商
:given: simple knots $u_0<\dots<u_{p+1}$, each of the $p+3$ intervals that they make, any $t$
:then: $N_{0,p}(t)=(u_{p+1}-u_0)\sum_j\frac{(u_j-t)_+^p}{\prod_{l\ne j}(u_j-u_l)}$
:method: On an interval a truncated power is the power or $0$.  The sum against the recursion by its letter; to the left of
  all knots, where every power counts, the sum must be $0$.
:degrees: 0..5 sampled 9
:scope: the distinct knots variables up to order 5, numbers above
:harmless: $u_0<\dots<u_{p+1}$ | the distinct knots are variables in their order
:control: the first truncated power left out
:::
*/
CLAIM(bspline_is_divided_difference)
{
    int p = T->degree, count = p + 2, place[MOST_KNOTS];
    num u[MOST_KNOTS], t = parameter(T, "t");
    char simple[MOST_KNOTS];
    G(pattern_of_bits)(count, (1 << (count - 1)) - 1, simple);
    G(knots_of_pattern)(T, simple, u, place);
    for (int interval = -1; interval < count; interval++) {
        num sum = from_int(0);
        for (int j = fault(T, interval + 1, interval + 2); j < count; j++) {
            num term = sub(u[count - 1], u[0]);
            for (int k = 0; k < p; k++)
                term = mul(term, sub(u[j], t));
            for (int l = 0; l < count; l++)
                if (l != j)
                    term = div(term, sub(u[j], u[l]));
            sum = add(sum, term);
        }
        same(T, G(cox_de_boor)(p, u, place, 0, interval, t), sum);
    }
}

/*
## Partition of unity, sign, support

:::{claim} bspline_basis_sums_to_one
:title: The B-splines sum to one on the domain
:zh: B 样条基的规范性
:given: several segments, the distinct knots variables; every interval of the domain
:then: $\sum_{i=0}^{n-1}N_{i,p}=1$
:method: All $n$ polynomials of the interval, from the recursion by its letter, are added; the sum must have the coefficients
  $1,0,\dots,0$.
:degrees: 0..6 sampled 9
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:control: the first B-spline of the span left out
:::
*/
CLAIM(bspline_basis_sums_to_one)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num N[MOST_KNOTS * (HIGHEST + 1)];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K))
        for (int interval = K.place[p]; interval < K.place[K.n]; interval += 2) {
            int mu = G(span_of_interval)(K.count, K.place, interval);
            G(basis_powers)(p, K.count, K.u, K.place, interval, K.u[mu], N);
            for (int r = 0; r <= p; r++) {
                num sum = from_int(0);
                for (int i = 0; i < K.n; i++)
                    if (fault(T, 1, i != mu - p))
                        sum = add(sum, N[i * (p + 1) + r]);
                same(T, sum, from_int(r == 0));
            }
        }
}

#if RATIONAL
/*
The proof of the sum needs $p+1$ functions on the interval. To the left of $u_p$ some of them would have to begin before the first
knot, and they are not there: this is why the domain of a spline over $u_0,\dots,u_{n+p}$ is $[u_p,u_n]$ and not the whole of
$[u_0,u_{n+p}]$.

:::{claim} bspline_basis_sums_to_less_outside_the_domain
:title: Outside the domain the sum of the B-splines is not one
:zh: 定义域外 B 样条之和不为 1
:kind: counterexample
:given: the quadratic B-splines over the knots $u$, and $t$ in the interval on the left of the domain $[u_p,u_n]$
:data: u = 0 1 2 3 4 5; t = 3/2
:instead: t = 5/2
:then: $\sum_iN_{i,2}(t)$ is less than $1$: the B-spline that begins one knot earlier is missing
:result: ΣN_i(t) = 7/8
:method: All the B-splines of these knots from the recursion by its letter; that their sum is 1 is what is compared.
:control: $t$ in the domain
:::
*/
CLAIM(bspline_basis_sums_to_less_outside_the_domain)
{
    enum { p = 2, n = 3, count = n + p + 1 };
    num u[count], sum = from_int(0);
    int place[count];
    G(given_knots)(T, "u", count, u, place);
    num t = given(T, "t");
    int interval = G(interval_after)(count, u, place, t);
    for (int i = 0; i < n; i++)
        sum = add(sum, G(cox_de_boor)(p, u, place, i, interval, t));
    found(T, "ΣN_i(t)", sum);
    about(T, "the sum of the B-splines, and 1");
    same(T, sum, from_int(1));
}
#endif

/*
On the domain the B-splines are thus weights of a mean, provided that none is negative. The recursion shows it: where one of its
two functions does not vanish, the fraction in front of it lies between $0$ and $1$ on the support (支撑). Here the sign is read off
a polynomial in the lengths of the intervals, all of whose coefficients are positive, so that it is decided for all knots at once.
What remains are the knots themselves.

:::{claim} bspline_is_positive_inside_its_support
:title: A B-spline is positive between the ends of its support and vanishes outside
:zh: B 样条的非负性与局部支撑
:given: several segments, the lengths between distinct knots positive variables; every interval between knots, and $t$ inside
  it at the positive distances $a$ and $b$ from its ends
:then: $N_{i,p}(t)>0$ for $u_i<t<u_{i+p+1}$, $N_{i,p}(t)=0$ for $t<u_i$ and for $t>u_{i+p+1}$: so $N_{i,p}\ge0$, and its
  support is $[u_i,u_{i+p+1}]$ and no less
:method: The recursion by its letter, also outside the domain.  With $u_{j+1}-u_j=a+b$ on the interval of $t$ every value is
  a fraction of polynomials in the lengths with positive coefficients only; at a knot inside the support a value is the
  limit from the right, whose sign `bspline_at_its_knots` decides.
:degrees: 0..4 sampled 7
:over: x: -; a b: distance of t from the ends of its interval
:control: the B-spline before is taken
:::
*/
CLAIM(bspline_is_positive_inside_its_support)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = LENGTHS};
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K))
        for (int interval = 0; interval < K.place[K.count - 1]; interval += 2) {
            num a = positive(T, "a", 0), b = positive(T, "b", 0), x = unknown(T, "x", 0), t = x;
            for (int i = 0; i < K.count; i++) {
                if (i > 0 && K.place[i - 1] == interval && K.place[i] > interval)
                    t = add(x, a), x = add(t, b);
                else if (i > 0 && K.place[i - 1] < K.place[i])
                    x = add(x, positive(T, "h", K.place[i] / 2));
                K.u[i] = x;
            }
            for (int i = 0; i < K.n; i++) {
                num value = G(cox_de_boor)(p, K.u, K.place, fault(T, i, i > 0 ? i - 1 : i), interval, t);
                if (K.place[i] <= interval && interval < K.place[i + p + 1])
                    G(must_be_positive)(T, value);
                else
                    vanishes(T, value);
            }
        }
}

#if FIELD || RATIONAL
/*
:::{claim} bspline_at_its_knots
:title: Where a B-spline vanishes at its knots
:zh: B 样条在节点处的零点
:given: several segments, the lengths between distinct knots positive variables; every knot $\xi$ but the last, values being
  limits from the right
:then: for $u_i\le\xi<u_{i+p+1}$ the value $N_{i,p}(\xi)$ is positive, except at $\xi=u_i$: there it is $1$ if
  $u_i,\dots,u_{i+p}$ are one knot, and otherwise $0$
:method: The polynomials of the interval on the right of $\xi$ in powers of $t-\xi$, from the recursion by its letter: the
  constant coefficient.
:types: field rational
:degrees: 0..4 sampled 7
:over: x: -
:control: the next B-spline is taken
:::
*/
CLAIM(bspline_at_its_knots)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = LENGTHS};
    num N[MOST_KNOTS * (HIGHEST + 1)];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        for (int interval = 0; interval < K.place[K.count - 1]; interval += 2) {
            int mu = G(span_of_interval)(K.count, K.place, interval);
            G(basis_powers)(p, K.count, K.u, K.place, interval, K.u[mu], N);
            for (int i = 0; i < fault(T, K.n, K.n - 1); i++) {
                num value = N[fault(T, i, i + 1) * (p + 1)];
                if (interval < K.place[i] || K.place[i + p + 1] <= interval)
                    vanishes(T, value);
                else if (K.place[i] == interval)
                    same(T, value, from_int(K.place[i + p] == interval));
                else
                    G(must_be_positive)(T, value);
            }
        }
    }
}
#endif

/*
## Independence

Marsden's identity, which has a section of its own, writes every power of a variable point in B-splines.  On one span it has
$p+1$ of them, and they give all of the $p+1$ dimensions of the polynomials of degree $p$: so they are independent there.  The
determinant says it once more.
*/

#if FIELD || RATIONAL
/*
:::{claim} bsplines_of_a_span_are_independent
:title: The p+1 B-splines of a span are linearly independent, and so are all of them
:zh: B 样条基的线性无关性
:given: every segment, the lengths between distinct knots positive variables
:then: the determinant of the coefficients of $N_{\mu-p,p},\dots,N_{\mu,p}$ in powers of $t-u_\mu$ is not $0$ for any such
  knots
:method: The coefficients from the recursion by its letter; the determinant without division has coefficients of one sign
  only.  It is the Wronskian of the $p+1$ polynomials, which is constant, over $1!\,2!\cdots p!$.  If a
  combination of all $n$ vanishes on the domain it does on each span, so every coefficient of it is $0$, as each $N_{i,p}$,
  $0\le i<n$, belongs to a span of the domain when $u_p<u_{p+1}$ and $u_{n-1}<u_n$.
:degrees: 0..4 sampled 7
:types: field rational
:over: x: -
:control: the first B-spline taken twice
:::
*/
CLAIM(bsplines_of_a_span_are_independent)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = LENGTHS};
    num N[MOST_KNOTS * (HIGHEST + 1)];
    for (int k = G(segment_knots)(T, p, 0, &K); k > 0; k = G(segment_knots)(T, p, k, &K)) {
        G(basis_powers)(p, K.count, K.u, K.place, K.place[p], K.u[p], N);
        if (T->faulty && p > 0)
            for (int r = 0; r <= p; r++)
                N[p + 1 + r] = N[r];
        G(must_be_positive)(T, G(determinant)(p + 1, N));
    }
}
#endif

#if RATIONAL
/*
All of them are independent on the domain only if each has a span there. With $u_p=u_{p+1}$ the first has lost its own: its
support ends where the domain begins.

:::{claim} bsplines_without_a_span_are_dependent
:title: On the domain a B-spline without a span there is lost
:zh: 支撑不含定义域区间的 B 样条
:kind: counterexample
:types: rational
:given: the linear B-splines over the knots $u$, of which $u_p$ and $u_{p+1}$ are equal, so that the domain $[u_p,u_n]$ has one interval
:data: u = 0 1 1 2 3
:instead: u = 0 1 3/2 2 3
:then: $N_{0,1}$ vanishes on the domain, so that the B-splines are not linearly independent there
:result: N_0, in powers of t - u_1 = 0 0
:method: Value and slope of $N_{0,1}$ on the interval from the recursion by its letter; that one of them is not $0$
  is what is compared.
:control: the second of the two equal knots moved to the right
:::
*/
CLAIM(bsplines_without_a_span_are_dependent)
{
    enum { p = 1, n = 3, count = n + p + 1 };
    num u[count], N[(count - 1) * (p + 1)];
    int place[count];
    G(given_knots)(T, "u", count, u, place);
    G(basis_powers)(p, count, u, place, place[p], u[p], N);
    found_points(T, "N_0, in powers of t - u_1", p + 1, 1, N);
    about(T, "N_0 is not 0 on the domain");
    refute(T, is_zero_q(N[0]) && is_zero_q(N[1]));
}
#endif

/*
## Smoothness

At a knot that occurs $m$ times among its knots $u_i,\dots,u_{i+p+1}$ a B-spline has $p-m$ continuous derivatives, and the next
one jumps.  The jump is known exactly, and it is never $0$.

:::{claim} bspline_jumps_exactly_after_order
:title: At a knot of multiplicity m the derivatives up to order p-m are continuous and the next one jumps
:zh: m 重节点处 B 样条恰为 p-m 阶连续
:given: several segments, the distinct knots variables; every B-spline; every knot $\xi$ of the domain, its ends included, $m\ge0$ times
  among $u_i,\dots,u_{i+p+1}$
:then: the derivatives of $N_{i,p}$ from both sides of $\xi$ agree up to the order $p-m$; for $m\ge1$ that of order $p-m+1$
  jumps from left to right by
  $(-1)^{p-m}\frac{p!}{(m-1)!}\,(u_{i+p+1}-u_i)\big/\prod_{u_l\ne\xi}(\xi-u_l)\ne0$
:method: The polynomials of both intervals in powers of $t-\xi$, from the recursion by its letter.
:degrees: 0..6 sampled 7
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:control: the jump asked for one order lower
:::
*/
CLAIM(bspline_jumps_exactly_after_order)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num left[MOST_KNOTS * (HIGHEST + 1)], right[MOST_KNOTS * (HIGHEST + 1)];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K))
        for (int at = K.place[p]; at <= K.place[K.n]; at += 2) {
            if (at == 0 || at == K.place[K.count - 1])
                continue;
            num xi = K.u[G(span_of_interval)(K.count, K.place, at)];
            G(basis_powers)(p, K.count, K.u, K.place, at - 2, xi, left);
            G(basis_powers)(p, K.count, K.u, K.place, at, xi, right);
            for (int i = 0; i < K.n; i++) {
                int m = 0;
                num jump = sub(K.u[i + p + 1], K.u[i]);
                for (int l = i; l <= i + p + 1; l++)
                    if (K.place[l] == at)
                        m++;
                    else
                        jump = div(jump, sub(xi, K.u[l]));
                for (int j = m; j <= p; j++)
                    jump = mul(jump, from_int(j > 0 ? j : 1)); /* p!/(m-1)! */
                about(T, "the continuous derivatives");
                for (int r = 0; r <= fault(T, p - m, p - m + 1) && r <= p; r++)
                    same(T, right[i * (p + 1) + r], left[i * (p + 1) + r]);
                if (m == 0)
                    continue;
                about(T, "the jump");
                int r = p - m + 1;
                num found = sub(G(derivative_of_powers)(p, right + i * (p + 1), r),
                                G(derivative_of_powers)(p, left + i * (p + 1), r));
                same(T, found, (p - m) % 2 == 0 ? jump : neg(jump));
            }
        }
}

/*
## Derivatives and integrals

The derivative of a B-spline is a difference of two B-splines of one degree less, in the same form as the recursion but with
constants in the place of the linear factors. So all derivatives come from the triangle that gives the values. Integration goes
the other way; that the integral depends on the support alone, however the knots lie in it, is what makes
$(p+1)N_{i,p}/(u_{i+p+1}-u_i)$ a density.

:::{claim} bspline_basis_derivatives_follow_definition
:title: The kernel computes all derivatives of the basis
:zh: B 样条基的各阶导数
:given: every segment, the distinct knots variables; any $t$; orders $0,\dots,p+1$
:then: row $r$ of `bspline_basis_derivatives` is $N^{(r)}_{\mu-p,p}(t),\dots,N^{(r)}_{\mu,p}(t)$; in particular
  $N_{i,p}'=p\bigl(\frac{N_{i,p-1}}{u_{i+p}-u_i}-\frac{N_{i+1,p-1}}{u_{i+p+1}-u_{i+1}}\bigr)$, which `bspline_basis_derivative_level` is
:method: The rows at $t$ against the coefficients in powers about the same $t$, from the recursion by its letter; the level
  applied to the values of degree $p-1$ must give the first row.
:degrees: 0..6 sampled 7
:scope: the distinct knots variables up to order 5, numbers above
:defines: bspline_basis_derivative_level bspline_basis_derivatives
:control: the first and the last function exchanged
:::
*/
CLAIM(bspline_basis_derivatives_follow_definition)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num N[MOST_KNOTS * (HIGHEST + 1)], D[(HIGHEST + 2) * (HIGHEST + 1)], level[HIGHEST + 1], t = parameter(T, "t");
    for (int k = G(segment_knots)(T, p, 0, &K); k > 0; k = G(segment_knots)(T, p, k, &K)) {
        G(basis_powers)(p, K.count, K.u, K.place, K.place[p], t, N);
        G(bspline_basis_derivatives)(p, K.u, p, t, p + 1, D);
        for (int r = 0; r <= p + 1; r++)
            for (int i = 0; i <= p; i++) {
                int other = fault(T, i, p - i);
                same(T, D[r * (p + 1) + i], G(derivative_of_powers)(p, N + other * (p + 1), r));
            }
        if (p == 0)
            continue;
        about(T, "the level of the derivative");
        G(bspline_basis)(p - 1, K.u, p, t, level);
        G(bspline_basis_derivative_level)(p, K.u, p, level);
        for (int i = 0; i <= p; i++)
            same(T, level[i], N[i * (p + 1) + (p > 0)]);
    }
}

/*
:::{claim} bspline_integral
:title: The integral of a B-spline is the length of its support over p+1
:zh: B 样条的积分
:given: several segments, the distinct knots variables
:then: $\int N_{i,p}\,dt=\frac{u_{i+p+1}-u_i}{p+1}$
:method: The polynomial of each interval, from the recursion by its letter, integrated power by power; also outside the domain.
:degrees: 0..6 sampled 7
:scope: the distinct knots variables up to order 5, numbers above
:control: divided by $p$ or, for $p=0$, by 2
:::
*/
CLAIM(bspline_integral)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num N[MOST_KNOTS * (HIGHEST + 1)], integral[MOST_KNOTS];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        for (int i = 0; i < K.n; i++)
            integral[i] = from_int(0);
        for (int interval = 0; interval < K.place[K.count - 1]; interval += 2) {
            int mu = G(span_of_interval)(K.count, K.place, interval);
            num h = sub(K.u[mu + 1], K.u[mu]), power = from_int(1);
            G(basis_powers)(p, K.count, K.u, K.place, interval, K.u[mu], N);
            for (int r = 0; r <= p; r++) {
                power = mul(power, h);
                for (int i = 0; i < K.n; i++)
                    integral[i] = add(integral[i], mul(N[i * (p + 1) + r], div(power, from_int(r + 1))));
            }
        }
        for (int i = 0; i < K.n; i++)
            same(T, integral[i], div(sub(K.u[i + p + 1], K.u[i]), from_int(fault(T, p + 1, p > 0 ? p : 2))));
    }
}

/*
## Greville abscissae (Greville 横坐标)

A coefficient $c_i$ belongs to a place on the axis: to the one that makes the straight line the spline of its own values. This is
not the middle of the support, but the mean of the $p$ knots inside it. The polygon of the points $(\xi_i,c_i)$ is what is drawn
as the control polygon of a function, and what the section on convergence compares with the spline.

:::{claim} greville_abscissae_are_the_identity
:title: The Greville abscissae are the points of s(t) = t
:zh: Greville 横坐标是恒等函数的控制系数
:given: several segments, the distinct knots variables; every interval of the domain
:then: with the numbers $\xi_i=\frac1p(u_{i+1}+\dots+u_{i+p})$ of `bspline_greville`, $\sum_i\xi_iN_{i,p}(t)=t$
:method: The coefficients of the sum in powers of $t-u_\mu$, from the recursion by its letter, must be $u_\mu,1,0,\dots,0$.
  As the B-splines are independent no other numbers have this property.
:degrees: 1..6 sampled 9
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:defines: bspline_greville
:control: the abscissae of the next points
:::
*/
CLAIM(greville_abscissae_are_the_identity)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num c[MOST_KNOTS], s[HIGHEST + 1];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        for (int i = 0; i < K.n; i++)
            c[i] = G(bspline_greville)(p, K.u, fault(T, i, i + 1 < K.n ? i + 1 : i));
        for (int interval = K.place[p]; interval < K.place[K.n]; interval += 2) {
            num a = K.u[G(span_of_interval)(K.count, K.place, interval)];
            G(spline_powers)(K.n, p, 1, K.u, K.place, c, 0, interval, a, s);
            for (int r = 0; r <= p; r++)
                same(T, s[r], r == 0 ? a : from_int(r == 1));
        }
    }
}
#include "chapters/judge/claims_off.h"
