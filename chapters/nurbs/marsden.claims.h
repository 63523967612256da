/*
# Marsden's identity (Marsden 恒等式)

A power $(x-t)^{k-1}$ is a combination of the $k$ B-splines of a span, with coefficients that are products of linear
factors: the knots inside the support of the function, put into $x-t$ one by one.  Everything that a basis has to be
able to do follows from it: it reproduces the powers of $t$, hence all polynomials.
*/
#include "chapters/nurbs/spans.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch4:formula-4.4.14
:title: The coefficients of Marsden's identity
:zh: Marsden 系数 ω
:printed: \omega_{i,k}(x)=1\ (k=1),\qquad\omega_{i,k}(x)=(x-t_{i+1})(x-t_{i+2})\cdots(x-t_{i+k-1})\ (k>1)
:definition: yes
:checked-by: marsden_coefficients_vanish_at_inner_knots
:figure: marsden_identity

For $k=1$ it is the empty product.  The number printed at it is that of the identity, see `formula-4.4.14-label`.
:::
*/

/* omega_{i,k}(x) by its letter. */
static num G(omega)(const struct G(span) * S, int i, int k, num x)
{
    num product = from_int(1);
    for (int m = i + 1; m <= i + k - 1; m++)
        product = mul(product, sub(x, S->t[m]));
    return product;
}

/* Sym_j(x_0, ..., x_{n-1}) as the sum over all subsets of j elements. */
static num G(symmetric_sum)(int n, const num x[], int j)
{
    num sum = from_int(0);
    for (int S = 0; S < 1 << n; S++) {
        num product = from_int(1);
        int size = 0;
        for (int m = 0; m < n; m++)
            if (S >> m & 1) {
                product = mul(product, x[m]);
                size++;
            }
        if (size == j)
            sum = add(sum, product);
    }
    return sum;
}

/*
As a polynomial in $x$ the coefficient vanishes at the $k-1$ knots inside the support and nowhere else; written in
powers it has the elementary symmetric functions of these knots as coefficients.

:::{claim} marsden_coefficients_vanish_at_inner_knots
:title: The kernel's coefficients are the products of x minus the inner knots
:zh: ω 的系数与零点
:given: orders $k$, the 2k knots and $x$ variables
:then: `marsden_coefficients` gives $(x-t_{i+1})\cdots(x-t_{i+k-1})$, for $k=1$ the number 1, and this is $\sum_j(-1)^j\mathrm{Sym}_j(t_{i+1},\dots,t_{i+k-1})\,x^{k-1-j}$, with
  $\mathrm{Sym}_j$ the sum over all subsets of $j$ knots
:method: The kernel against the product by its letter, and against the sum over the $2^{k-1}$ subsets of the inner knots.
:degrees: 0..6 sampled 8
:over: t#: knots; x
:defines: marsden_coefficients
:control: the knots $t_i,\dots,t_{i+k-2}$ in the place of $t_{i+1},\dots,t_{i+k-1}$
:::
*/
CLAIM(marsden_coefficients_vanish_at_inner_knots)
{
    int k = T->degree + 1;
    struct G(span) S = G(simple_span)(T, k);
    num x = unknown(T, "x", 0), w[LARGEST_ORDER];
    G(marsden_coefficients)(k - 1, S.t, S.r, x, w);
    for (int i = 0; i < k; i++) {
        num sum = from_int(0);
        for (int j = 0; j < k; j++) {
            num term = mul(G(symmetric_sum)(k - 1, fault(T, S.t + i + 1, S.t + i), j), G(power)(x, k - 1 - j));
            sum = add(sum, G(signed_by)(j, term));
        }
        about(T, "the product by its letter");
        same(T, w[i], G(omega)(&S, i, k, x));
        about(T, "the symmetric functions"); /* ω_i,k(x) = Σ_j (-1)^j Sym_j(t_i+1, ..., t_i+k-1) x^(k-1-j) */
        same(T, w[i], sum);
    }
}

/*
:::{claim} elementary_symmetric_is_sum_over_subsets
:title: The elementary symmetric functions are sums over subsets
:zh: 初等对称函数
:given: $n$ variables $x_1,\dots,x_n$
:then: `elementary_symmetric` gives for each $j$ the sum over all $i_1<\dots<i_j$ of $x_{i_1}\cdots x_{i_j}$
:method: The kernel multiplies linear factors one by one; the other side goes through the $2^n$ subsets.
:degrees: 0..7 sampled 12
:over: x#: arguments
:defines: elementary_symmetric
:control: the last variable taken twice
:::
*/
CLAIM(elementary_symmetric_is_sum_over_subsets)
{
    int n = T->degree;
    num x[13], s[13];
    for (int m = 0; m < n; m++)
        x[m] = unknown(T, "x", fault(T, m, m == n - 1 ? 0 : m));
    G(elementary_symmetric)(n, x, s);
    for (int m = 0; m < n; m++)
        x[m] = fault(T, x[m], unknown(T, "x", m));
    for (int j = 0; j <= n; j++)
        same(T, s[j], G(symmetric_sum)(n, x, j));
}

/*
:::{statement} wang-ch4:thm-4.4.2
:title: Marsden's identity
:zh: 定理 4.4.2 Marsden 恒等式
:printed: suppose $t\in[t_r,t_{r+1})$; then for all $x$ there is $(x-t)^{k-1}=\sum_{i=r-k+1}^r\omega_{i,k}(x)N_{i,k}(t)$,
  where $\omega_{i,k}(x)$ is 1 for $k=1$ and $(x-t_{i+1})(x-t_{i+2})\cdots(x-t_{i+k-1})$ for $k>1$
:holds-by: marsden_step_for_every_order outer_functions_are_made_of_outer_ones divisors_contain_the_span
:confirmed-by: marsden_identity marsden_identity_for_every_pattern
:needs: marsden_identity_ends_with_the_span | the theorem itself: $t\in[t_r,t_{r+1})$ | $t$ lies in the span whose functions are
  summed
:figure: marsden_identity
:::
*/

/*
Both sides are polynomials in $x$ and $t$.  With the knots as variables the identity is proved for simple ones, and
for coincident ones it follows, as no difference of knots on one side of the span is divided by; it is tried for them
as well.

:::{claim} marsden_identity
:title: Marsden's identity for knots, x and t as variables
:zh: Marsden 恒等式(节点为变量)
:given: orders $k$, simple knots, all variables; $x$ and $t$ variables
:then: $\sum_i\omega_{i,k}(x)N_{i,k}(t)=(x-t)^{k-1}$
:method: The B-splines by their definition.
:degrees: 0..5 sampled 7
:scope: simple knots
:over: t#: knots; x
:control: the coefficient of the first function left out
:::
*/
CLAIM(marsden_identity)
{
    int k = T->degree + 1;
    struct G(span) S = G(simple_span)(T, k);
    num x = unknown(T, "x", 0), t = parameter(T, "t"), sum = from_int(0);
    for (int i = fault(T, 0, 1); i < k; i++)
        sum = add(sum, mul(G(omega)(&S, i, k, x), G(basis_value)(&S, i, k, t)));
    /* Σ ω_i,k(x) N_i,k(t) = (x - t)^(k-1) */
    same(T, sum, G(power)(sub(x, t), k - 1));
}

#if FIELD
/* The factor of N_i,k-1 in W_i N_i,k + W_i-1 N_i-1,k by the recursion with rise and fall, against up W_i + down W_i-1. */
static void G(check_level)(trial *T, num rise, num fall, num up, num down)
{
    num N[3], W[2];
    for (int m = 0; m < 3; m++)
        N[m] = unknown(T, "N", m);
    for (int m = 0; m < 2; m++)
        W[m] = unknown(T, "W", m);
    /* N_i,k = rise N_i,k-1 + c N_i+1,k-1 and N_i-1,k = d N_i-1,k-1 + fall N_i,k-1; N[1] is N_i,k-1 */
    num right = add(mul(rise, N[1]), mul(unknown(T, "c", 0), N[2])),
        left = add(mul(unknown(T, "d", 0), N[0]), mul(fall, N[1]));
    num factor = derivative_f(add(mul(W[1], right), mul(W[0], left)), N[1]);
    about(T, "the factor of N_i,k-1");
    same(T, factor, add(mul(up, W[1]), mul(down, W[0])));
}

/*
:::{claim} one_level_in_every_order
:title: The coefficients of one order less, whatever the order
:zh: 系数的一层递推(任意阶数)
:types: field
:given: $N_{i,k-1}(t)$ and its two neighbours, the numbers $W_i^0$ and $W_{i-1}^0$, the knots $a=t_i$, $b=t_{i+k-1}$; all variables
:then: in $W_i^0N_{i,k}(t)+W_{i-1}^0N_{i-1,k}(t)$ the function $N_{i,k-1}(t)$ has the factor $W_i^1=\frac{t-a}{b-a}W_i^0+\frac{b-t}{b-a}W_{i-1}^0$
:method: Both functions of order $k$ by the recursion of Cox and de Boor, with other factors $c$, $d$ for the outer functions; the
  derivative by $N_{i,k-1}$.  On the span $N_{r-k+1,k-1}$ and $N_{r+1,k-1}$ vanish (`outer_functions_are_made_of_outer_ones`), and for
  $i=r-k+2,\dots,r$ it is $a\le t_r<t_{r+1}\le b$, whatever knots coincide (`divisors_contain_the_span`, whose $j$ is the $r$ here, on its level 1).
:degrees: all from 1
:scope: every pattern of knots
:over: a b c d: -; N# W#: -
:control: the two fractions exchanged
:::
*/
CLAIM(one_level_in_every_order)
{
    num t = parameter(T, "t"), a = unknown(T, "a", 0), b = unknown(T, "b", 0);
    num rise = div(sub(t, a), sub(b, a)), fall = div(sub(b, t), sub(b, a));
    G(check_level)(T, rise, fall, fault(T, rise, fall), fault(T, fall, rise));
}

/*
The induction of the source can be run for all orders at once.  In the sum over the functions of order $k$ the recursion puts two
functions of order $k-1$ in the place of each; $N_{i,k-1}$ then stands in two neighbouring terms, with the factor that two
neighbouring products have in common.

:::{claim} marsden_step_for_every_order
:title: From one order to the next, whatever the order
:zh: 任意阶数的归纳步
:types: field
:given: $N_{i,k-1}(t)$ and its two neighbours, the product $q=\omega_{i,k-1}(x)$, the knots $a=t_i$, $b=t_{i+k-1}$; so that
  $\omega_{i,k}(x)=q\,(x-b)$ and $\omega_{i-1,k}(x)=q\,(x-a)$; all variables
:then: in $W_iN_{i,k}(t)+W_{i-1}N_{i-1,k}(t)$ the function $N_{i,k-1}(t)$ has the factor
  $\frac{t-a}{b-a}W_i+\frac{b-t}{b-a}W_{i-1}$, and for $W_i=\omega_{i,k}(x)$, $W_{i-1}=\omega_{i-1,k}(x)$ this is $(x-t)\,q$
:method: Both functions of order $k$ by the recursion of Cox and de Boor, with other factors $c$, $d$ for the outer functions; the
  derivative by $N_{i,k-1}$.  So $\sum\omega_{i,k}N_{i,k}=(x-t)\sum\omega_{i,k-1}N_{i,k-1}$: on the span $N_{r-k+1,k-1}$ and $N_{r+1,k-1}$ vanish
  (`outer_functions_are_made_of_outer_ones`), and for $i=r-k+2,\dots,r$ it is $a\le t_r<t_{r+1}\le b$, whatever knots coincide
  (`divisors_contain_the_span`, whose $j$ is the $r$ here, on its level 1).  For $k=1$ the identity is $1=1$.
:degrees: all
:scope: every pattern of knots
:over: x; q a b c d: -; N# W#: -
:control: the factors $x-a$ and $x-b$ exchanged
:::
*/
CLAIM(marsden_step_for_every_order)
{
    num x = unknown(T, "x", 0), t = parameter(T, "t"), q = unknown(T, "q", 0), a = unknown(T, "a", 0),
        b = unknown(T, "b", 0);
    num rise = div(sub(t, a), sub(b, a)), fall = div(sub(b, t), sub(b, a));
    G(check_level)(T, rise, fall, rise, fall);
    num here = mul(q, sub(x, fault(T, b, a))), before = mul(q, sub(x, fault(T, a, b)));
    about(T, "the factor with the products");
    same(T, add(mul(rise, here), mul(fall, before)), mul(sub(x, t), q));
    about(T, "order 1");
    same(T, G(power)(sub(x, t), 0), from_int(1));
}
#endif

/*
:::{claim} outer_functions_are_made_of_outer_ones
:title: A function whose support does not contain the span is made of two such functions of the order before
:zh: 支集不含该区间的基函数由低一阶的同类函数构成
:types: field rational
:given: a span $[t_r,t_{r+1})$; $N_{i,m}$, $m\ge2$, with $i=r-m-d$ on its left, or $i=r+1+d$ on its right, $d\ge0$; all of them variables
:harmless: $d\ge0$ | these are all $i$ on either side
:then: $N_{i,m-1}$ and $N_{i+1,m-1}$ are on the same side: $r-(m-1)-i=d+1$ and $r-(m-1)-(i+1)=d$ are not negative; $i-(r+1)=d$ and $(i+1)-(r+1)=d+1$ are not negative
:method: Identities in the indices: the step of an induction on $m$, whatever knots coincide.  $N_{i,1}$ is $0$ on the span for $i\ne r$, so for $i\le r-1$ and $i\ge r+1$, and the
  recursion makes $N_{i,m}$ a sum of two multiples of $N_{i,m-1}$ and $N_{i+1,m-1}$, with $0/0=0$.
:degrees: all
:scope: every pattern of knots
:over: r m d: -
:control: $i=r-m+1-d$, which begins with a function of the span
:::
*/
CLAIM(outer_functions_are_made_of_outer_ones)
{
    num r = whole(T, "r", 20, 40), m = whole(T, "m", 2, 9), d = whole(T, "d", 0, 9), one = from_int(1);
    num left = sub(sub(r, m), fault(T, d, sub(d, one))),
        last = sub(r, sub(m, one)); /* the last index on the left of order m-1 */
    about(T, "on the left");
    same(T, sub(last, left), add(d, one));
    same(T, sub(last, add(left, one)), d);
    num right = add(add(r, one), d), first = add(r, one);
    about(T, "on the right");
    same(T, sub(right, first), d);
    same(T, sub(add(right, one), first), add(d, one));
}

/*
:::{claim} marsden_identity_for_every_pattern
:title: Marsden's identity for coincident knots
:zh: 重节点下的 Marsden 恒等式
:given: every pattern of the 2k knots around a span up to the order 4, for greater orders three random ones; the different knots, $x$ and $t$
  variables
:then: $\sum_i\omega_{i,k}(x)N_{i,k}(t)=(x-t)^{k-1}$
:method: The B-splines by their definition, with the rule $0/0=0$.
:degrees: 0..4 sampled 7
:scope: every pattern of the knots around a span up to order 4, random ones above
:over: t#: knots; x
:control: $x$ and $t$ exchanged on the right
:::
*/
CLAIM(marsden_identity_for_every_pattern)
{
    int k = T->degree + 1;
    num knots[2 * LARGEST_ORDER], x = unknown(T, "x", 0), t = parameter(T, "t"), w[LARGEST_ORDER];
    G(increasing)(T, 2 * k, knots);
    for (int count = k <= 4 ? G(patterns)(k) : 3, m = 0; m < count; m++) {
        struct G(span) S = G(span_of_pattern)(k, k <= 4 ? m : pick(T, 0, G(patterns)(k) - 1), knots);
        num sum = from_int(0);
        G(marsden_coefficients)(k - 1, S.t, S.r, x, w);
        for (int i = 0; i < k; i++)
            sum = add(sum, mul(w[i], G(basis_value)(&S, i, k, t)));
        same(T, sum, G(power)(fault(T, sub(x, t), sub(t, x)), k - 1));
    }
}

#if RATIONAL
/*
The $k$ functions are those of one span.  A step further one of them has ended and another, which is missing from the
sum, has begun.

:::{claim} marsden_identity_ends_with_the_span
:title: Outside the span the same k functions do not suffice
:zh: 区间外恒等式不成立
:kind: counterexample
:given: $k=2$, the knots $t_i$, the functions $N_{0,2}$ and $N_{1,2}$ of the span $[t_1,t_2)$, at a $t$ of the next
  span; $x$
:data: t_i = 0 1 2 3 4; t = 5/2; x = 0
:instead: t = 3/2
:then: $\sum\omega_iN_i(t)$ is not $(x-t)^1$
:result: N_0,2(t), N_1,2(t) = 0 1/2; the sum = -1; x - t = -5/2
:method: The values of the functions at $t$ are those of the span that contains $t$.
:control: a $t$ of the span
:::
*/
CLAIM(marsden_identity_ends_with_the_span)
{
    num knots[5], N[2], sum = from_int(0);
    int place[5];
    given_points(T, "t_i", 5, 1, knots);
    num t = given(T, "t"), x = given(T, "x");
    for (int i = 0; i < 5; i++)
        place[i] = i;
    for (int i = 0; i < 2; i++) {
        N[i] = G(cox_de_boor)(1, knots, place, i, compare_q(t, knots[2]) < 0 ? 1 : 2, t);
        sum = add(sum, mul(sub(x, knots[i + 1]), N[i]));
    }
    found_points(T, "N_0,2(t), N_1,2(t)", 2, 1, N);
    found(T, "the sum", sum);
    found(T, "x - t", sub(x, t));
    about(T, "the sum over the functions of [t_1,t_2), and x - t");
    same(T, sum, sub(x, t));
}
#endif

/*
:::{statement} wang-ch4:formula-4.4.13
:title: The formula of the identity, printed twice
:zh: 恒等式的公式(印两次)
:printed: (x-t)^{k-1}=\sum_{i=r-k+1}^r\omega_{i,k}(x)N_{i,k}(t),\quad\text{printed twice}
:holds-by: marsden_step_for_every_order outer_functions_are_made_of_outer_ones divisors_contain_the_span
:confirmed-by: marsden_identity marsden_identity_up_to_order_eight
:needs: marsden_identity_ends_with_the_span | theorem 4.4.2: $t\in[t_r,t_{r+1})$ | $t$ lies in the span whose functions are
  summed
:figure: marsden_identity

With the polynomials of the span in the places of the $N_{i,k}$ it holds for all $t$, not in the span alone.
:::

:::{claim} marsden_identity_up_to_order_eight
:title: Marsden's identity for greater orders
:zh: 高阶 Marsden 恒等式
:given: orders $k$ from 1 to 8, $x$, $t$ and $t_r$ variables; the other knots equidistant around $t_r$, or all
  equal on each side; the gap, of the knots or of the two sides, a variable
:then: $\sum_i\omega_{i,k}(x)N_{i,k}(t)=(x-t)^{k-1}$
:method: The B-splines from the kernel of the basis, at a variable $t$.
:degrees: 0..7 sampled 12
:scope: equidistant knots, or all equal on each side
:over: x; a: knot; h: gap
:control: the coefficient of the last function left out
:::
*/
CLAIM(marsden_identity_up_to_order_eight)
{
    int p = T->degree;
    num knots[32], N[16], w[16], x = unknown(T, "x", 0), t = parameter(T, "t");
    num start = unknown(T, "a", 0), gap = positive(T, "h", 0);
    for (int equal = 0; equal <= 1; equal++) {
        for (int m = 0; m < 2 * p + 2; m++)
            knots[m] = add(start, mul(from_int(equal ? m > p : m - p), gap));
        num sum = from_int(0);
        G(bspline_basis)(p, knots, p, t, N);
        G(marsden_coefficients)(p, knots, p, x, w);
        for (int i = 0; i <= fault(T, p, p - 1); i++)
            sum = add(sum, mul(w[i], N[i]));
        same(T, sum, G(power)(sub(x, t), p));
    }
}

/*
## The proof (证明)

The proof takes the recursion of Cox and de Boor from the functions to the coefficients: one level less for the
functions is one level of de Boor's algorithm for the coefficients.

:::{statement} wang-ch4:thm-4.4.2-proof
:title: The proof needs nothing but the recursion of de Boor
:zh: 证明只用 deBoor 递推公式
:printed: [15] proves it by induction; now we give a short new proof, which needs only de Boor's formula (2.1.1); moreover the identity will give
  another explicit representation of the coefficient matrix
:holds-by: marsden_step_for_every_order outer_functions_are_made_of_outer_ones divisors_contain_the_span
:confirmed-by: one_level_moves_to_the_coefficients one_level_takes_off_a_factor every_link_of_the_chain
:meant: the preface, item 1, where this recursion defines the curves: a definition by recursion has a beginning; (2.1.1) itself is not at hand | The recursion together with the functions of order 1: these say, by induction, that
  $N_{r-k+1,k-1}$ and $N_{r+1,k-1}$ are $0$ on the span.
:needs: marsden_identity_ends_with_the_span | theorem 4.4.2: $t\in[t_r,t_{r+1})$ | $t$ lies in the span whose functions are summed
:reading: one_level_needs_the_span | the proof needs nothing of (2.1.1) but the step of the recursion, which is true for every $t$: then (4.4.15) would be, too; the supports are used as well
:figure: marsden_identity

That one formula suffices is what is decided; the other matrix is that of `thm-4.4.3`.  That the proof is short and new, how [15] proves the identity, and that it is a
beautiful result, first used for the convergence of an approximation, are history and opinion.
:::

:::{statement} wang-ch4:thm-4.4.2-order-1
:title: For k = 1 the identity is obvious
:zh: k=1 时恒等式显然
:printed: for $k=1$ (4.4.13) is obvious
:holds-by: marsden_identity_of_order_one
:confirmed-by: marsden_identity_for_every_pattern
:needs: identity_of_order_one_ends_with_the_span | theorem 4.4.2: $t\in[t_r,t_{r+1})$ | $t$ lies in the span whose function stands on the right

It reads $(x-t)^0=\omega_{r,1}(x)N_{r,1}(t)$, which is $1=1\cdot1$ on the span; for $x=t$, too, the power without factors is 1.  That it is obvious is an opinion.
:::

:::{claim} marsden_identity_of_order_one
:title: The identity of order 1
:zh: 一阶 Marsden 恒等式
:given: $k=1$, the two knots of a span that is not empty, $x$ and a $t$ of the span, variables
:then: $\omega_{r,1}(x)N_{r,1}(t)=1$, and $(x-t)^0=1$
:method: $\omega$ by its letter, the product of no factors; the function of order 1 by the definition of the B-splines.
:degrees: 0..0
:scope: order 1
:over: t#: knots; x
:control: the product of one factor, $x-t_{r+1}$
:::
*/
CLAIM(marsden_identity_of_order_one)
{
    num knots[2], x = unknown(T, "x", 0), t = parameter(T, "t");
    G(increasing)(T, 2, knots);
    struct G(span) S = G(span_of_pattern)(1, 0, knots);
    num product = G(omega)(&S, 0, fault(T, 1, 2), x);
    same(T, mul(product, G(basis_value)(&S, 0, 1, t)), G(power)(sub(x, t), 0));
}

#if RATIONAL
/*
:::{claim} identity_of_order_one_ends_with_the_span
:title: Outside the span the function of order 1 is 0
:zh: 区间外一阶恒等式不成立
:kind: counterexample
:given: $k=1$, the knots $t_i$, the function $N_{0,1}$ of the span $[t_0,t_1)$, at a $t$ of the next span; $x$
:data: t_i = 0 1 2; t = 3/2; x = 0
:instead: t = 1/2
:then: $\omega_{0,1}(x)N_{0,1}(t)=0$, while $(x-t)^0=1$
:result: ω_0,1(x) N_0,1(t) = 0; (x - t)^0 = 1
:method: The function by the definition of the B-splines, for the span that contains $t$; $\omega$ is the product of no factors.
:control: a $t$ of the span
:::
*/
CLAIM(identity_of_order_one_ends_with_the_span)
{
    num knots[3];
    int place[3] = {0, 1, 2};
    given_points(T, "t_i", 3, 1, knots);
    num t = given(T, "t"), x = given(T, "x"), left = G(power)(sub(x, t), 0);
    num right = G(cox_de_boor)(0, knots, place, 0, compare_q(t, knots[1]) < 0 ? 0 : 1, t);
    found(T, "ω_0,1(x) N_0,1(t)", right);
    found(T, "(x - t)^0", left);
    about(T, "the product, and the power of order 0");
    same(T, right, left);
}
#endif

/*
:::{statement} wang-ch4:formula-4.4.15
:title: One level of the recursion, moved to the coefficients
:zh: 递推转移到系数
:printed: for $k>1$, by (2.1.1): $\sum_{i=r-k+1}^rW_i^0N_{i,k}(t)=\sum_{i=r-k+2}^rW_i^1N_{i,k-1}(t)$,
  $W_i^1=\frac{t-t_i}{t_{i+k-1}-t_i}W_i^0+\frac{t_{i+k-1}-t}{t_{i+k-1}-t_i}W_{i-1}^0$
:holds-by: one_level_in_every_order outer_functions_are_made_of_outer_ones divisors_contain_the_span
:confirmed-by: one_level_moves_to_the_coefficients
:needs: one_level_needs_the_span | theorem 4.4.2: $t\in[t_r,t_{r+1})$ | $t$ is in the span: there the functions at the ends,
  $N_{r-k+1,k-1}$ and $N_{r+1,k-1}$, vanish
:figure: marsden_identity

The $W_i^0$ are any numbers; $W_i^1$ is asked for with $i=r-k+2,\dots,r$, for which $t_i\le t_r<t_{r+1}\le t_{i+k-1}$, so that no denominator is 0.
:::
*/

/* W_i^1 of (4.4.15) from W_i^0 and W_{i-1}^0, with the two fractions exchanged if asked for. */
static num G(level_of_coefficients)(const struct G(span) * S, int i, int k, const num W[], num t, int exchanged)
{
    num length = sub(S->t[i + k - 1], S->t[i]);
    num rise = div(sub(t, S->t[i]), length), fall = div(sub(S->t[i + k - 1], t), length);
    return exchanged ? add(mul(fall, W[i]), mul(rise, W[i - 1])) : add(mul(rise, W[i]), mul(fall, W[i - 1]));
}

/*
Put the recursion of the B-splines into a sum with arbitrary coefficients $W_i^0$ and collect what stands with each
function of lower order: the new coefficients are those of de Boor's algorithm.  The functions at both ends are 0 on
the span, so that the sum loses one term.

:::{claim} one_level_moves_to_the_coefficients
:title: The level of the coefficients is that of de Boor's algorithm
:zh: 系数的一层递推即 de Boor 算法
:given: orders $k\ge2$, simple knots, $t$ and arbitrary numbers $W_{r-k+1}^0,\dots,W_r^0$, all variables; moreover every
  pattern of the knots up to the order 3
:then: $\sum W_i^0N_{i,k}(t)=\sum W_i^1N_{i,k-1}(t)$ with the printed $W_i^1$ and the printed limits
:method: All functions by their definition.
:degrees: 1..5 sampled 7
:scope: every pattern of the knots around a span up to order 3, simple knots above
:over: t#: knots; W#: coefficients
:control: the two fractions in $W_i^1$ exchanged
:::
*/
CLAIM(one_level_moves_to_the_coefficients)
{
    int k = T->degree + 1;
    num knots[2 * LARGEST_ORDER], W[LARGEST_ORDER], t = parameter(T, "t");
    G(increasing)(T, 2 * k, knots);
    for (int i = 0; i < k; i++)
        W[i] = unknown(T, "W", i);
    int last = G(patterns)(k) - 1;
    for (int m = k <= 3 ? 0 : last; m <= last; m++) {
        struct G(span) S = G(span_of_pattern)(k, m, knots);
        num left = from_int(0), right = from_int(0);
        for (int i = S.r - k + 1; i <= S.r; i++)
            left = add(left, mul(W[i], G(basis_value)(&S, i, k, t)));
        for (int i = S.r - k + 2; i <= S.r; i++) {
            num W1 = G(level_of_coefficients)(&S, i, k, W, t, fault(T, 0, 1));
            right = add(right, mul(W1, G(basis_value)(&S, i, k - 1, t)));
        }
        same(T, left, right);
    }
}

#if RATIONAL
/*
:::{claim} one_level_needs_the_span
:title: Outside the span the sums of one level differ
:zh: 区间外一层递推不成立
:kind: counterexample
:given: $k=2$, the knots $t_i$, the functions of the span $[t_1,t_2)$, $W_0^0=W_1^0=1$, at a $t$ of the next span
:data: t_i = 0 1 2 3 4; t = 5/2
:instead: t = 3/2
:then: the left side is $N_{0,2}(t)+N_{1,2}(t)$ and not 0, the right side $W_1^1N_{1,1}(t)=0$
:result: left side = 1/2; right side = 0
:method: The functions at $t$ are those of the span that contains $t$.
:control: a $t$ of the span
:::
*/
CLAIM(one_level_needs_the_span)
{
    num knots[5];
    int place[5];
    given_points(T, "t_i", 5, 1, knots);
    num t = given(T, "t");
    for (int i = 0; i < 5; i++)
        place[i] = i;
    int interval = compare_q(t, knots[2]) < 0 ? 1 : 2;
    num left = add(G(cox_de_boor)(1, knots, place, 0, interval, t), G(cox_de_boor)(1, knots, place, 1, interval, t));
    num right = G(cox_de_boor)(0, knots, place, 1, interval, t); /* W_1^1 = 1 when both W^0 are 1 */
    found(T, "left side", left);
    found(T, "right side", right);
    about(T, "the two sides of (4.4.15)");
    same(T, left, right);
}
#endif

/*
:::{statement} wang-ch4:thm-4.4.2-step-omega
:title: For the coefficients of the identity one level takes off a factor
:zh: ω 经一层递推降一阶
:printed: let $W_i^0=\omega_{i\,\iota}(x)$; then $W_i^1=(x-t)\,\omega_{i,k-1}(x)$
:holds-by: marsden_step_for_every_order one_level_in_every_order outer_functions_are_made_of_outer_ones divisors_contain_the_span
:confirmed-by: one_level_takes_off_a_factor
:needs: empty_span_has_no_level | theorem 4.4.2: $t\in[t_r,t_{r+1})$ | the span is not empty: otherwise a fraction of $W_i^1$ divides by 0
:meant: (4.4.14), which defines $\omega_{i,k}(x)$ | The second index of the first $\omega$, an iota in print, is the order $k$, see `notation-4.4`.
:figure: marsden_identity

For $i=r-k+2,\dots,r$, as in (4.4.15).  In the copy at hand a point stands between the indices of the second $\omega$, where all other places have a comma.
:::

For the products $\omega_{i,k}$ one such step takes $x-t$ out: two neighbouring products have all factors in common
but one, and the mean of the two different factors, with the weights of the recursion, is $x-t$.

:::{claim} one_level_takes_off_a_factor
:title: The level applied to the products
:zh: 对 ω 施行一层递推
:given: orders $k\ge2$, knots, $x$ and $t$ variables
:then: $\frac{t-t_i}{t_{i+k-1}-t_i}\omega_{i,k}(x)+\frac{t_{i+k-1}-t}{t_{i+k-1}-t_i}\omega_{i-1,k}(x)=(x-t)\,
  \omega_{i,k-1}(x)$ for $i=r-k+2,\dots,r$
:method: Both sides are products and a sum of two products.
:degrees: 1..6 sampled 8
:over: t#: knots; x
:control: $\omega_{i+1,k-1}$ on the right
:::
*/
CLAIM(one_level_takes_off_a_factor)
{
    int k = T->degree + 1;
    struct G(span) S = G(simple_span)(T, k);
    num x = unknown(T, "x", 0), t = parameter(T, "t"), W[LARGEST_ORDER];
    for (int i = 0; i < k; i++)
        W[i] = G(omega)(&S, i, k, x);
    for (int i = S.r - k + 2; i <= S.r; i++)
        /* the level of ω_i,k and ω_i-1,k at t is (x - t) ω_i,k-1 */
        same(T, G(level_of_coefficients)(&S, i, k, W, t, 0),
             mul(sub(x, t), G(omega)(&S, i + fault(T, 0, k > 2), k - 1, x)));
}

#if RATIONAL
static num G(or_zero)(num a, num b) { return is_zero_q(a) && is_zero_q(b) ? from_int(0) : div(a, b); } /* 0/0 = 0 */

/*
:::{claim} empty_span_has_no_level
:title: On an empty span one level takes off no factor
:zh: 空区间上一层递推不成立
:kind: counterexample
:given: $k=2$, four knots $t_i$, $t_r=t_{r+1}$ in the middle, $i=r=1$, $t=t_1$ and $x$; the rule $0/0=0$
:data: t_i = 0 1 1 2; t = 1; x = 0
:instead: t_i = 0 1 2 3
:then: both fractions of $W_1^1$ are $0/0$, so that it is 0 and not $(x-t)\,\omega_{1,1}(x)$
:result: W_1^1 = 0; (x - t) ω_1,1(x) = -1
:method: $W_1^1$ from $W_1^0=\omega_{1,2}(x)$ and $W_0^0=\omega_{0,2}(x)$ by its letter.
:control: simple knots
:::
*/
CLAIM(empty_span_has_no_level)
{
    struct G(span) S = {.k = 2, .r = 1};
    given_points(T, "t_i", 4, 1, S.t);
    num t = given(T, "t"), x = given(T, "x"), W[2] = {G(omega)(&S, 0, 2, x), G(omega)(&S, 1, 2, x)};
    num length = sub(S.t[2], S.t[1]);
    num level = add(mul(G(or_zero)(sub(t, S.t[1]), length), W[1]), mul(G(or_zero)(sub(S.t[2], t), length), W[0]));
    num right = mul(sub(x, t), G(omega)(&S, 1, 1, x));
    found(T, "W_1^1", level);
    found(T, "(x - t) ω_1,1(x)", right);
    about(T, "W_1^1, and (x - t) ω_1,1(x)");
    same(T, level, right);
}
#endif

/*
:::{statement} wang-ch4:thm-4.4.2-step-chain
:title: The chain of the proof
:zh: 逐层递推的等式链
:printed: using (4.4.15) recursively one has
  $\sum_{i=r-k+1}^r\omega_{i,k}(x)N_{i,k}(t)=(x-t)\sum_{i=r-k+2}^r\omega_{i,k-1}(x)N_{i,k-1}(t)=\dots=(x-t)^{k-1}\omega_{r,1}(x)
  N_{r,1}(t)=(x-t)^{k-1}$
:holds-by: marsden_step_for_every_order one_level_in_every_order outer_functions_are_made_of_outer_ones divisors_contain_the_span
:confirmed-by: every_link_of_the_chain
:needs: marsden_identity_ends_with_the_span | theorem 4.4.2: $t\in[t_r,t_{r+1})$ | $t$ lies in the span whose functions are
  summed
:figure: marsden_identity

It is written for $k>1$, as (4.4.15) is: for $k=1$ the second member would be an empty sum.  At its end $\omega_{r,1}(x)$ and, on the span, $N_{r,1}(t)$ are 1.
:::

So each step lowers the order by 1 and leaves a factor behind, until one function is left, which is 1 on the span.

:::{claim} every_link_of_the_chain
:title: Every link of the chain
:zh: 等式链逐环成立
:given: orders $k$, simple knots, $x$ and $t$ variables
:then: $(x-t)^{k-m}\sum_{i=r-m+1}^r\omega_{i,m}(x)N_{i,m}(t)=(x-t)^{k-1}$ for $m=k,k-1,\dots,1$
:method: Each sum by itself, from the definitions.
:degrees: 0..5 sampled 7
:scope: simple knots
:over: t#: knots; x
:control: the sums begin at $i=r-m+2$
:::
*/
CLAIM(every_link_of_the_chain)
{
    int k = T->degree + 1;
    struct G(span) S = G(simple_span)(T, k);
    num x = unknown(T, "x", 0), t = parameter(T, "t");
    for (int m = k; m >= 1; m--) {
        num sum = from_int(0);
        for (int i = fault(T, S.r - m + 1, S.r - m + 2); i <= S.r; i++)
            sum = add(sum, mul(G(omega)(&S, i, m, x), G(basis_value)(&S, i, m, t)));
        /* (x - t)^(k-m) Σ ω_i,m(x) N_i,m(t) = (x - t)^(k-1) */
        same(T, mul(G(power)(sub(x, t), k - m), sum), G(power)(sub(x, t), k - 1));
    }
}

/*
## The powers of t

Comparing the coefficients of the powers of $x$ on both sides gives the powers of $t$ as combinations of B-splines.

:::{statement} wang-ch4:formula-4.4.20
:title: The powers of t in the B-spline basis
:zh: 幂函数由 B 样条基表示
:printed: suppose $t\in[t_r,t_{r+1})$; comparing the coefficients of the same powers of x on both sides of (4.4.13) gives
  $t^\mu=\frac{(-1)^\mu\mu!}{(k-1)!}\sum_{i=r-k+1}^r\omega_{i,k}^{(k-1-\mu)}(0)\,N_{i,k}(t)$, $\mu=0,1,\dots,k-1$
:holds-by: marsden_step_for_every_order coefficients_of_marsden_in_every_order outer_functions_are_made_of_outer_ones divisors_contain_the_span
:confirmed-by: powers_of_t_from_derivatives
:needs: marsden_identity_ends_with_the_span | the line itself: $t\in[t_r,t_{r+1})$ | $t$ lies in the span whose functions are summed; the
  example is of (4.4.13), and at $x=0$ both of its sides are those of $\mu=1$ with the other sign
:figure: powers_from_averages
:::

:::{statement} wang-ch4:formula-4.4.21
:title: The powers of t in matrix form
:zh: 矩阵形式
:printed: (1,t,\dots,t^{k-1})=(N_{r-k+1,k}(t),N_{r-k+2,k}(t),\dots,N_{r,k}(t))\,\mathbf G_{r,k,T}^T
:holds-by: marsden_step_for_every_order coefficients_of_marsden_in_every_order
  outer_functions_are_made_of_outer_ones divisors_contain_the_span
:confirmed-by: powers_of_t_from_derivatives
:needs: marsden_identity_ends_with_the_span | (4.4.20), which it writes as a matrix: $t\in[t_r,t_{r+1})$ | $t$ lies in the span whose functions are summed; the
  example is of (4.4.13), and at $x=0$ both of its sides are those of the power $t$ with the other sign
:figure: powers_from_averages

The entries of $\mathbf G$ are (4.4.19), so that this is (4.4.20) for all $\mu$ at once.
:::

What is compared is the same for every order: a factor more, and every coefficient becomes a sum of two.

:::{claim} coefficients_of_marsden_in_every_order
:title: The coefficients of the powers of x on both sides of Marsden's identity, in every order
:zh: Marsden 恒等式两边 x 的同次幂系数(任意阶数)
:types: field rational
:given: symmetric functions $S_j=\mathrm{Sym}_j$ and $S_{j-1}$ of some numbers, one number $b$ more, $\sigma=(-1)^j$; integers $j,h\ge1$,
  $m=j+h-1$; an order $k>j$; $t$
:let: $c=\binom mj$, so that $\binom m{j-1}=c\frac jh$ and $\binom{m+1}j=c\frac{j+h}h$; $A=j!$, $B=(k-1-j)!$, $\binom{k-1}j=\frac{(k-1)!}{AB}$
:then: (1) the numbers with $b$ have $\mathrm{Sym}_j=S_j+bS_{j-1}$, and $(x-b)\bigl(\dots+\sigma S_jx^{m-j}-\sigma S_{j-1}x^{m-j+1}+\dots\bigr)$ has at $x^{m+1-j}$
  the coefficient $\sigma(S_j+bS_{j-1})$; (2) of $m+1$ numbers $t$ it is $\binom{m+1}jt^j=\binom mjt^j+t\binom m{j-1}t^{j-1}$; (3)
  $\frac{\sigma j!}{(k-1)!}\cdot\sigma(k-1-j)!\,S_j=S_j\big/\binom{k-1}j$
:method: (1) and (2) are the steps of inductions on the number of factors, in which all letters are variables; without factors both products are 1; for $j=0$
  both coefficients are 1, and for $j=m+1$, where $S_j$ and $\binom mj$ are 0, they are $\sigma bS_m$ and $t\cdot t^m$: $\omega_{i,k}(x)=\sum_j(-1)^j\mathrm{Sym}_j\,x^{k-1-j}$,
  and $(x-t)^{k-1}=\sum_j(-1)^j\binom{k-1}jt^jx^{k-1-j}$.  A polynomial that is differentiated $k-1-j$ times has at 0 the value $(k-1-j)!$ times
  its coefficient of $x^{k-1-j}$, which for $\omega_{i,k}$ is $\sigma\,\mathrm{Sym}_j$.  So by (3) the coefficients of $x^{k-1-j}$ on both sides of Marsden's
  identity, divided by $\sigma\binom{k-1}j$, are the sides of (4.4.20) for $\mu=j$ and of (4.4.22).
:degrees: all
:over: t S# b c j h A B C U: -
:control: $S_j-bS_{j-1}$ in (1)
:::
*/
CLAIM(coefficients_of_marsden_in_every_order)
{
    num S[2] = {unknown(T, "S", 0), unknown(T, "S", 1)}, b = unknown(T, "b", 0),
        t = parameter(T, "t"); /* S_j, S_{j-1} */
    num j = whole(T, "j", 1, 9), h = whole(T, "h", 1, 9), c = unknown(T, "c", 0), U = unknown(T, "U", 0);
    num more = add(S[0], mul(b, fault(T, S[1], neg(S[1]))));
    for (int odd = 0; odd <= 1; odd++) {
        num sign = from_int(odd ? -1 : 1);
        about(T, "one factor more"); /* x times the one coefficient, -b times the one before, whose sign is the other */
        same(T, sub(mul(sign, S[0]), mul(b, mul(neg(sign), S[1]))), mul(sign, more));
        num A = positive(T, "A", 0), B = positive(T, "B", 0), C = positive(T, "C", 0); /* j!, (k-1-j)!, (k-1)! */
        about(T, "derivatives and symmetric functions");
        same(T, mul(div(mul(sign, A), C), mul(mul(sign, B), S[0])), div(S[0], div(C, mul(A, B))));
    }
    about(T, "no factor"); /* Sym_0 of no numbers, and (x - t)^0 */
    same(T, G(symmetric_sum)(0, &t, 0), G(power)(t, 0));
    about(T, "equal numbers"); /* U = t^{j-1} */
    same(T, add(mul(c, mul(t, U)), mul(t, mul(div(mul(c, j), h), U))), mul(div(mul(c, add(j, h)), h), mul(t, U)));
}

#if FIELD
static num G(omega_derivative)(const struct G(span) * S, int i, int order)
{
    num x = variable_f("x"), D = G(omega)(S, i, S->k, x);
    for (int m = 0; m < order; m++)
        D = derivative_f(D, x);
    return substitute_f(D, x, from_int(0));
}

/*
:::{claim} powers_of_t_from_derivatives
:title: The powers of t from the derivatives of omega at 0
:zh: 由 ω 的导数得幂函数
:given: orders $k$, every pattern of the knots up to order 4 and the two extreme ones above, knots and $t$ variables
:then: (4.4.20) for every $\mu$; its right sides are the entries of $(N_{r-k+1,k},\dots,N_{r,k})\,G^T$ with $G=(g_{\mu
  i})$
:method: The derivatives are formal derivatives of $\omega_{i,k}(x)$ in the field, the B-splines by definition.
:types: field
:degrees: 0..5
:scope: every pattern of the knots around a span up to order 4, the two extreme ones above
:over: t#: knots; x: -
:control: the sign $(-1)^\mu$ left out
:::
*/
CLAIM(powers_of_t_from_derivatives)
{
    int k = T->degree + 1;
    num knots[2 * LARGEST_ORDER];
    G(increasing)(T, 2 * k, knots);
    for (int count = G(pattern_count)(k, 4, 2), number = 0; number < count; number++) {
        struct G(span) S = G(span_of_pattern)(k, G(which_pattern)(T, k, 4, number), knots);
        num t = parameter(T, "t"), N[LARGEST_ORDER];
        for (int i = 0; i < k; i++)
            N[i] = G(basis_value)(&S, i, k, t);
        for (int mu = 0; mu < k; mu++) {
            num sum = from_int(0);
            for (int i = 0; i < k; i++)
                sum = add(sum, mul(G(omega_derivative)(&S, i, k - 1 - mu), N[i]));
            sum = mul(div(G(factorial)(mu), G(factorial)(k - 1)), sum);
            /* t^μ = (-1)^μ μ!/(k-1)! Σ ω_i,k^(k-1-μ)(0) N_i,k(t) */
            same(T, G(power)(t, mu), G(signed_by)(fault(T, mu, 0), sum));
        }
    }
}
#endif

/*
:::{statement} wang-ch4:formula-4.4.22
:title: The powers of t with symmetric functions of the knots
:zh: 用对称函数表示的幂函数公式
:printed: t^j=\sum_{i=r-k+1}^r\mathrm{Sym}_j(t_{i+1},\dots,t_{i+k-1})\,N_{i,k}(t)\Big/\binom{k-1}j,\quad t\in[t_r,t_{r+1})
:holds-by: marsden_step_for_every_order coefficients_of_marsden_in_every_order
  outer_functions_are_made_of_outer_ones divisors_contain_the_span
:confirmed-by: powers_of_t_from_symmetric_functions
:needs: marsden_identity_ends_with_the_span | the line itself: $t\in[t_r,t_{r+1})$ | $t$ lies in the span whose functions are summed; the
  example is of (4.4.13), and at $x=0$ both of its sides are those of $j=1$ with the other sign
:figure: powers_from_averages

No range is printed for $j$; it is $0,\dots,k-1$, as that of $\mu$ in (4.4.20), of which this is another form, and beyond it $\binom{k-1}j$ is 0.  For $j=1$ the coefficients are the averages of the inner knots, the abscissae of Greville.
:::

The coefficient of $t^j$ is the symmetric function divided by the number of its terms, a mean of products of $j$ inner
knots.  This is a polar form in disguise: the control value of $t^j$ at the inner knots.

:::{claim} powers_of_t_from_symmetric_functions
:title: The powers of t from the symmetric functions of the knots
:zh: 由对称函数得幂函数
:given: orders $k$, every pattern of the knots up to the order 3, else simple knots; knots and $t$ variables
:then: (4.4.22) for every $j$
:method: The symmetric functions as sums over subsets, the B-splines by definition.
:degrees: 0..5 sampled 7
:scope: every pattern of the knots around a span up to order 3, simple knots above
:over: t#: knots
:control: the knots $t_i,\dots,t_{i+k-2}$
:::
*/
CLAIM(powers_of_t_from_symmetric_functions)
{
    int k = T->degree + 1;
    num knots[2 * LARGEST_ORDER], t = parameter(T, "t");
    G(increasing)(T, 2 * k, knots);
    int last = G(patterns)(k) - 1;
    for (int m = k <= 3 ? 0 : last; m <= last; m++) {
        struct G(span) S = G(span_of_pattern)(k, m, knots);
        num N[LARGEST_ORDER];
        for (int i = 0; i < k; i++)
            N[i] = G(basis_value)(&S, i, k, t);
        for (int j = 0; j < k; j++) {
            num sum = from_int(0);
            for (int i = 0; i < k; i++)
                sum = add(sum, mul(G(symmetric_sum)(k - 1, fault(T, S.t + i + 1, S.t + i), j), N[i]));
            /* t^j = Σ Sym_j(t_i+1, ..., t_i+k-1) N_i,k(t) / C(k-1, j) */
            same(T, G(power)(t, j), div(sum, G(choose)(k - 1, j)));
        }
    }
}

/*
:::{statement} wang-ch4:formula-4.4.22-sym
:title: The symmetric functions
:zh: 第 j 个对称函数
:printed: $\mathrm{Sym}_j(t_{i+1},\dots,t_{i+k-1})=\sum_{i+1\le i_1<\dots<i_j\le i+k-1}t_{i_1}\cdots t_{i_j}$ is the $j$-th symmetric function of the knots $t_{i+1},\dots,t_{i+k-1}$
:definition: yes
:checked-by: elementary_symmetric_is_sum_over_subsets
:figure: powers_from_averages

For $j=0$ the sum has one term, the empty product 1.
:::

:::{statement} wang-ch4:formula-4.4.22-step
:title: The derivatives of omega at 0 are symmetric functions
:zh: ω 在 0 处的导数与对称函数
:printed: because $\omega_{i,k}^{(k-1-j)}(0)=(-1)^j(k-1-j)!\,\mathrm{Sym}_j(t_{i+1},\dots,t_{i+k-1})$, (4.4.22) follows from (4.4.20)
:holds-by: coefficients_of_marsden_in_every_order
:confirmed-by: derivatives_of_omega_are_symmetric
:figure: powers_from_averages

No range is printed for $j$; it is $0,\dots,k-1$, as that of $\mu$ in (4.4.20).  By (3) the factor of $N_{i,k}(t)$ in (4.4.20) is that in (4.4.22).
:::
*/

#if FIELD
/*
That the two forms (4.4.20) and (4.4.22) agree is a matter of one derivative at 0, which picks a coefficient.

:::{claim} derivatives_of_omega_are_symmetric
:title: The derivative of order k-1-j of omega at 0
:zh: ω 的 k-1-j 阶导数
:given: orders $k$, knots variables
:then: $\omega_{i,k}^{(k-1-j)}(0)=(-1)^j(k-1-j)!\,\mathrm{Sym}_j$
:method: The formal derivative in the field against the sum over subsets.
:types: field
:degrees: 0..6
:over: t#: knots; x: -
:control: the sign $(-1)^j$ left out
:::
*/
CLAIM(derivatives_of_omega_are_symmetric)
{
    int k = T->degree + 1;
    struct G(span) S = G(simple_span)(T, k);
    for (int i = 0; i < k; i++)
        for (int j = 0; j < k; j++) {
            num size = mul(G(factorial)(k - 1 - j), G(symmetric_sum)(k - 1, S.t + i + 1, j));
            /* ω_i,k^(k-1-j)(0) = (-1)^j (k-1-j)! Sym_j */
            same(T, G(omega_derivative)(&S, i, k - 1 - j), G(signed_by)(fault(T, j, 0), size));
        }
}
#endif

#include "chapters/judge/claims_off.h"
