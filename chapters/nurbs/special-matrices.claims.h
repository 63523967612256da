/*
# Special coefficient matrices (特殊系数矩阵)

Three kinds of knots have formulas of their own: knots that are all different, equidistant knots, and the knots of a
single Bézier segment.  The source derives the first two from the divided differences, the third from Marsden's identity.
This section is about the first, the next two are about the others.  A formula with alternating signs and factorials is
easily misprinted; so each sum is computed by its letter and compared with the matrix that the recursion gives.
*/
#include "chapters/nurbs/simple-knots.h"

#include "chapters/judge/claims_on.h"

enum { CELLS = LARGEST_ORDER * LARGEST_ORDER };

/*
## Simple knots (单节点)

:::{statement} wang-ch4:simple-vandermonde
:title: For simple nodes the determinant is that of Vandermonde
:zh: 单节点时为 Vandermonde 行列式
:printed: when all knots of $T$ are simple, $\det H(T;1,t,\dots,t^k)$ is Vandermonde's determinant
:holds-by: simple_determinant_is_vandermonde
:argued: every k | A simple node has one row in $H$, that of the derivatives of order 0, which is $1,t_i,\dots,t_i^k$; the determinant of such rows
  is what is called Vandermonde's.
:::

:::{claim} simple_determinant_is_vandermonde
:title: The determinant over simple nodes
:zh: Vandermonde 行列式
:given: $k+1$ simple nodes $t_0,\dots,t_k$, variables; $H$ the matrix of (4.4.6)
:then: $\det H=\prod_{i<j}(t_j-t_i)$, and row $i$ of $H$ is $1,t_i,\dots,t_i^k$
:method: The determinant of the kernel's matrix, and its product formula, against the product of the differences.
:degrees: k = 0..5 sampled 8
:scope: simple knots
:over: t#: nodes
:control: the order of the last two nodes exchanged in the product
:::
*/
CLAIM(simple_determinant_is_vandermonde)
{
    int k = T->degree, l[LARGEST_ORDER];
    num t[LARGEST_ORDER], H[CELLS], product = from_int(1);
    G(increasing)(T, k + 1, t);
    for (int i = 0; i <= k; i++) {
        l[i] = 1;
        for (int j = i + 1; j <= k; j++)
            product = mul(product, fault(T, sub(t[j], t[i]), i == k - 1 ? sub(t[i], t[j]) : sub(t[j], t[i])));
    }
    G(confluent_vandermonde)(k + 1, l, t, H);
    about(T, "the rows");
    for (int i = 0; i <= k; i++)
        for (int c = 0; c <= k; c++)
            same(T, H[i * (k + 1) + c], G(power)(t[i], c));
    about(T, "the determinant");
    same(T, G(determinant)(k + 1, H), product);
    same(T, G(confluent_vandermonde_determinant)(k + 1, l, t), product);
}

/*
:::{statement} wang-ch4:simple-divided-difference
:title: The divided difference over simple nodes
:zh: 单节点差商公式
:printed: when all knots are simple, by lemma 4.4.1 $[t_i,t_{i+1},\dots,t_{i+k}]f=\sum_{l=i}^{i+k}\Bigl[\prod_{j=i,\,j\ne l}^{i+k}(t_j-t_l)\Bigr]^{-1}f(t_l)$
:class: misprint
:refuted-by: printed_simple_difference_has_wrong_sign
:corrected: the factors are $t_l-t_j$; there are $k$ of them, so the printed formula has the wrong sign for odd $k$ and is
  right for even $k$
:corrected-by: simple_difference_in_every_order factors_of_both_orders
:confirmed-by: simple_difference_has_factors_of_both_orders
:figure: simple_knots_sign
:::
*/

/*
For simple nodes the weights are the well-known ones of Lagrange.  Whether a factor is written $t_l-t_j$ or $t_j-t_l$
changes the sign of each of $k$ factors, hence that of the whole for odd $k$: a fault that an example with $k=2$ does
not show.

:::{claim} simple_difference_in_every_order
:title: From the divided difference over k simple nodes to that over k+1, whatever k
:zh: 单节点差商(任意阶数)
:types: field
:given: simple nodes $t_0,\dots,t_k$, $k\ge1$, among them $a=t_0$, $b=t_k$ and an inner one $y=t_l$; the value $F$ of $f$ at a node, any number $G$;
  the product $Q$ of the $1/(t_l-t_j)$ over the inner nodes $t_j$, $0<j<k$, $j\ne l$
:harmless: $j\ne l$ | the factor of the node itself is in no product
:let: $g_1$ and $g_0$ the polynomials that agree with $f$ at $t_1,\dots,t_k$ and at $t_0,\dots,t_{k-1}$
:then: (1) $\bigl((x-a)g_1(x)-(x-b)g_0(x)\bigr)/(b-a)$ agrees with $f$ at all nodes, so that
  $[t_0,\dots,t_k]f=\bigl([t_1,\dots,t_k]f-[t_0,\dots,t_{k-1}]f\bigr)/(b-a)$; (2) if in both of them $f(t_l)$ has the factor that is the product of all $1/(t_l-t_j)$, so it has
  here: $\bigl(\frac Q{y-b}-\frac Q{y-a}\bigr)\frac1{b-a}=\frac Q{(y-a)(y-b)}$, for $l=0$ it is $-\frac Q{b-a}=\frac Q{a-b}$, for $l=k$ it is $\frac Q{b-a}$
:method: The divided difference is the coefficient of $x^k$ of the polynomial of degree $k$ that agrees with $f$ at the nodes.  Steps of inductions on $k$, in which all letters are
  variables; $[t_0]f=f(t_0)$, with a product of no factors.  So $[t_0,\dots,t_k]f=\sum f(t_l)/\prod_{j\ne l}(t_l-t_j)$.
:degrees: all
:scope: simple knots
:over: t#: knots; f#: values of the function; Q: -
:control: $a-b$ for $b-a$ in (2)
:::
*/
#if FIELD
CLAIM(simple_difference_in_every_order)
{
    num a = unknown(T, "t", 0), b = unknown(T, "t", 1), y = unknown(T, "t", 2), length = sub(b, a);
    num F = unknown(T, "f", 0), G = unknown(T, "f", 1), Q = unknown(T, "Q", 0), one = from_int(1);
    about(T, "the polynomial at a node"); /* ((x - a) g_1 - (x - b) g_0) / (b - a) at a, b and y */
    same(T, div(sub(mul(sub(a, a), G), mul(sub(a, b), F)), length), F);
    same(T, div(sub(mul(sub(b, a), F), mul(sub(b, b), G)), length), F);
    same(T, div(sub(mul(sub(y, a), F), mul(sub(y, b), F)), length), F);
    num over = div(one, fault(T, length, neg(length)));
    about(T, "the factor of f at an inner node");
    same(T, mul(sub(div(Q, sub(y, b)), div(Q, sub(y, a))), over), div(Q, mul(sub(y, a), sub(y, b))));
    about(T, "the factors of f at the first node and at the last");
    same(T, mul(neg(Q), over), div(Q, sub(a, b)));
    same(T, mul(Q, over), div(Q, sub(b, a)));
}

/*
:::{claim} factors_of_both_orders
:title: Each factor with its two numbers exchanged changes the sign
:zh: 差的因子换序变号
:types: field
:given: a product $q$ of factors $t_l-t_j$, the product $\sigma q$ of the factors $t_j-t_l$, $\sigma=\pm1$; one factor more, $y-b$ and $b-y$
:then: $\sigma q\,(b-y)=-\sigma\,q\,(y-b)$
:method: The step of an induction on the number of factors; of $k$ factors $\prod(t_j-t_l)=(-1)^k\prod(t_l-t_j)$.
:degrees: all
:over: t#: knots; q: -
:control: the sign $\sigma$ on the right
:::
*/
CLAIM(factors_of_both_orders)
{
    num b = unknown(T, "t", 1), y = unknown(T, "t", 2), q = unknown(T, "q", 0);
    for (int odd = 0; odd <= 1; odd++) {
        num sigma = from_int(odd ? -1 : 1);
        same(T, mul(mul(sigma, q), sub(b, y)), mul(fault(T, neg(sigma), sigma), mul(q, sub(y, b))));
    }
}
#endif

/*
:::{claim} simple_difference_has_factors_of_both_orders
:title: The divided difference over simple nodes, and the printed one times (-1)^k
:zh: 单节点差商的正确符号
:given: $k+1$ simple nodes $t_0,\dots,t_k$ and the values of $f$, variables
:then: $[t_0,\dots,t_k]f=\sum f(t_l)/\prod_{j\ne l}(t_l-t_j)$, and the printed sum is $(-1)^k$ times this
:method: The table of divided differences against both sums.
:degrees: k = 0..6 sampled 10
:scope: simple knots
:over: t#: nodes; f#: values of the function
:control: the sign $(-1)^{k+1}$
:::
*/
CLAIM(simple_difference_has_factors_of_both_orders)
{
    int k = T->degree, l[12];
    num t[12], f[12], sum = from_int(0), printed = from_int(0);
    G(increasing)(T, k + 1, t);
    for (int i = 0; i <= k; i++) {
        l[i] = 1;
        f[i] = unknown(T, "f", i);
        sum = add(sum, div(f[i], G(product_of_differences)(t, 0, k, i, 0)));
        printed = add(printed, div(f[i], G(product_of_differences)(t, 0, k, i, 1)));
    }
    /* [t_0, ..., t_k]f = Σ f(t_l) / Π (t_l - t_j) */
    same(T, G(divided_difference)(k + 1, l, t, f), sum);
    same(T, printed, G(signed_by)(fault(T, k, k + 1), sum));
}

#if RATIONAL
/*
:::{claim} printed_simple_difference_has_wrong_sign
:title: The printed divided difference has the wrong sign
:zh: 印出的差商公式符号有误
:kind: counterexample
:given: $k=1$, two nodes $t_i$ and the values $f(t_i)$
:data: t_i = 0 1; f(t_i) = 0 1
:then: the printed sum $f(t_0)/(t_1-t_0)+f(t_1)/(t_0-t_1)$ is not $[t_0,t_1]f$ but its negative
:result: the printed sum = -1; the divided difference = 1
:method: The printed sum against the table.
:control: the factors $t_l-t_j$
:::
*/
CLAIM(printed_simple_difference_has_wrong_sign)
{
    int one[2] = {1, 1};
    num t[2], f[2], sum = from_int(0);
    given_points(T, "t_i", 2, 1, t);
    given_points(T, "f(t_i)", 2, 1, f);
    for (int l = 0; l < 2; l++)
        sum = add(sum, div(f[l], G(product_of_differences)(t, 0, 1, l, fault(T, 0, 1))));
    num difference = G(divided_difference)(2, one, t, f);
    found(T, "the printed sum", sum);
    found(T, "the divided difference", difference);
    about(T, "the printed sum, and the divided difference");
    same(T, sum, difference);
}
#endif

/*
:::{statement} wang-ch4:simple-basis
:title: The B-spline of simple knots
:zh: 单节点 B 样条基
:printed: when all knots are simple, by theorem 4.4.1 $N_{i,k}(t)=(t_{i+k}-t_i)\sum_{l=r+1}^{i+k}\alpha_l(t_l-t)^{k-1}$, $i=r-k+1,r-k+2,\dots,r$
:reading: simple_function_in_every_order | $\alpha_l$ is the weight $\alpha_{\lambda0}$ of lemma 4.4.1 at the node $t_l$, the factor of $f(t_l)$ in the divided difference, and $t$ is in the span
:reading-with: simple_difference_in_every_order
:reading: printed_weights_give_the_negative_basis | $\alpha_l$ is what the formula for the divided difference before it has in front of $f(t_l)$ as
  printed: so read it is $-N_{0,1}$ for $k=1$
:corrected: \alpha_l=\Bigl[\prod_{j=i,\,j\ne l}^{i+k}(t_l-t_j)\Bigr]^{-1}
:corrected-by: simple_function_in_every_order
:confirmed-by: simple_basis_from_weights simple_difference_has_factors_of_both_orders
:needs: polynomial_of_a_span_ends_with_it | theorem 4.4.1, from which it is taken: $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:figure: simple_knots_sign

The source does not say what $\alpha_l$ is.  Theorem 4.4.1, which it cites for the formula, has the weights of lemma 4.4.1; in the next line of the same formula, `simple-basis-expanded`,
the place of $\alpha_l$ is taken by 1 over the printed factors $t_\alpha-t_l$.
:::

The formula is true for every order, by an induction that uses the recursion of Cox and de Boor term by term: a knot that both
functions of the order before have brings two terms, which are one of the next order.

:::{claim} simple_function_in_every_order
:title: The sum over the knots to the right of the span, whatever the order
:zh: 区间右侧节点求和(任意阶数)
:types: field
:given: simple knots, an order $m\ge2$, $a=t_i$, $b=t_{i+m}$, $c=t_{i+1}$, $d=t_{i+m-1}$, a knot $y=t_l$ with $i<l<i+m$; $t$; the product $Q$ of the
  $1/(t_l-t_j)$ over $i<j<i+m$, $j\ne l$; $V=(t_l-t)^{m-2}$
:harmless: $j\ne l$ | the factor of the knot itself is in no product
:let: $\alpha_l=\bigl[\prod_{j=i,\,j\ne l}^{i+m}(t_l-t_j)\bigr]^{-1}$, for inner $l$ the $\frac Q{(y-a)(y-b)}$, and in $N_{i,m-1}$ and $N_{i+1,m-1}$ the
  $\frac Q{y-a}$ and $\frac Q{y-b}$
:then: $\frac{t-a}{d-a}(d-a)\frac Q{y-a}V+\frac{b-t}{b-c}(b-c)\frac Q{y-b}V=(b-a)\frac Q{(y-a)(y-b)}(y-t)V$; for $l=i$, which $N_{i,m-1}$ alone has,
  $\frac{t-a}{d-a}(d-a)QV=(b-a)\frac Q{a-b}(a-t)V$; for $l=i+m$, which $N_{i+1,m-1}$ alone has, $\frac{b-t}{b-c}(b-c)QV=(b-a)\frac Q{b-a}(b-t)V$
:method: The step of an induction on $m$ for $N_{i,m}(t)=(t_{i+m}-t_i)\sum\alpha_l(t_l-t)^{m-1}$ on $[t_r,t_{r+1})$, the sum over those $l=i,\dots,i+m$ with $l>r$; for every $i$,
  by the recursion of Cox and de Boor.  In both orders these are the same knots.  For $m=1$ they are none behind the function, where it is 0; $t_{i+1}$ on its span, and
  $(b-a)\frac1{b-a}=1$; both before it, and $(b-a)\bigl(\frac1{a-b}+\frac1{b-a}\bigr)=0$.  For $m=k$ and $i=r-k+1,\dots,r$ they are $l=r+1,\dots,i+k$.
:degrees: all
:scope: simple knots
:over: t; t#: knots; Q V: -
:control: $t-b$ for $b-t$
:::
*/
#if FIELD
CLAIM(simple_function_in_every_order)
{
    num a = unknown(T, "t", 0), b = unknown(T, "t", 1), c = unknown(T, "t", 2), d = unknown(T, "t", 3);
    num y = unknown(T, "t", 4), Q = unknown(T, "Q", 0), V = unknown(T, "V", 0), t = parameter(T, "t");
    num rise = div(sub(t, a), sub(d, a)), fall = div(fault(T, sub(b, t), sub(t, b)), sub(b, c));
    num first = mul(rise, sub(d, a)), second = mul(fall, sub(b, c)), length = sub(b, a), one = from_int(1);
    about(T, "a knot inside");
    same(T, add(mul(first, mul(div(Q, sub(y, a)), V)), mul(second, mul(div(Q, sub(y, b)), V))),
         mul(mul(length, div(Q, mul(sub(y, a), sub(y, b)))), mul(sub(y, t), V)));
    about(T, "the first knot");
    same(T, mul(first, mul(Q, V)), mul(mul(length, div(Q, sub(a, b))), mul(sub(a, t), V)));
    about(T, "the last knot");
    same(T, mul(second, mul(Q, V)), mul(mul(length, div(Q, sub(b, a))), mul(sub(b, t), V)));
    about(T, "order 1");
    same(T, mul(length, div(one, sub(b, a))), one);
    same(T, mul(length, add(div(one, sub(a, b)), div(one, sub(b, a)))), from_int(0));
}
#endif

/*

:::{claim} simple_basis_from_weights
:title: The sum over the knots to the right of the span
:zh: 区间右侧节点求和得 B 样条基
:given: orders $k$, simple knots and $t$ variables
:then: $(t_{i+k}-t_i)\sum_{l=r+1}^{i+k}\alpha_l(t_l-t)^{k-1}=N_{i,k}(t)$ with the weights $\alpha_l$ of lemma 4.4.1, which are
  $\bigl[\prod_{j=i,\,j\ne l}^{i+k}(t_l-t_j)\bigr]^{-1}$
:method: The weights of `divided_weights`, each against the product, and in the sum, against the B-splines by definition.
:degrees: 0..5 sampled 7
:scope: simple knots
:over: t#: knots
:control: the sum begins at $l=r$
:::
*/
CLAIM(simple_basis_from_weights)
{
    int k = T->degree + 1, l[LARGEST_ORDER + 1];
    struct G(span) S = G(simple_span)(T, k);
    num t = parameter(T, "t"), alpha[LARGEST_ORDER + 1];
    for (int m = 0; m <= k; m++)
        l[m] = 1;
    for (int i = 0; i < k; i++) {
        num sum = from_int(0);
        G(divided_weights)(k + 1, l, S.t + i, alpha);
        about(T, "the weights");
        for (int m = i; m <= i + k; m++)
            same(T, mul(alpha[m - i], G(product_of_differences)(S.t, i, k, m, 0)), from_int(1));
        about(T, "the sum");
        for (int m = fault(T, S.r + 1, S.r); m <= i + k; m++)
            sum = add(sum, mul(alpha[m - i], G(power)(sub(S.t[m], t), k - 1)));
        /* (t_i+k - t_i) Σ_{l > r} α_l (t_l - t)^(k-1) = N_i,k(t) */
        same(T, mul(sub(S.t[i + k], S.t[i]), sum), G(basis_value)(&S, i, k, t));
    }
}

#if RATIONAL
/*
:::{claim} printed_weights_give_the_negative_basis
:title: With the printed factors the formula gives the negative B-spline
:zh: 按印式得到负的 B 样条基
:kind: counterexample
:given: $k=1$ and $r=i=0$, the two knots $t_i$ of $N_{0,1}$ and a $t$ between them; $\alpha_1=1/(t_0-t_1)$, the printed factor
:data: t_i = 0 1; t = 1/2
:then: the sum $(t_1-t_0)\alpha_1(t_1-t)^0$ is the negative of $N_{0,1}(t)$
:result: the sum = -1; N_0,1(t) = 1
:method: The formula by its letter; the function by the definition of the B-splines.
:control: the factor $t_1-t_0$
:::
*/
CLAIM(printed_weights_give_the_negative_basis)
{
    num x[2];
    given_points(T, "t_i", 2, 1, x);
    num t = given(T, "t");
    struct G(span) S = G(span_of_pattern)(1, 0, x);
    num alpha = div(from_int(1), G(product_of_differences)(S.t, 0, 1, 1, fault(T, 0, 1)));
    num sum = mul(mul(sub(S.t[1], S.t[0]), alpha), G(power)(sub(S.t[1], t), 0));
    num value = G(basis_value)(&S, 0, 1, t);
    found(T, "the sum", sum);
    found(T, "N_0,1(t)", value);
    about(T, "the sum, and N_0,1(t)");
    same(T, sum, value);
}

/*
:::{claim} printed_entry_of_order_one_is_negative
:title: For k = 1 the printed entry is the negative of the only one
:zh: k=1 时印出的元素为正确元素的负值
:kind: counterexample
:given: $k=1$ and $r=i=j=0$, the two knots $t_i$ of $N_{0,1}$, numbered from 0
:data: t_i = 0 1
:then: the only entry of the matrix is $N_{0,1}(t_0)$; as printed, $a_{00}=(t_1-t_0)(t_1-t_0)^0/(t_0-t_1)$, it is the negative
:result: the printed a_00 = -1; N_0,1(t_0) = 1
:method: The printed formula by its letter; its exponent $k-l-j$, in which $l=r+1=1$, is 0, as $k-1-j$ is.
:control: the factors $t_l-t_\alpha$
:::
*/
CLAIM(printed_entry_of_order_one_is_negative)
{
    num x[2];
    given_points(T, "t_i", 2, 1, x);
    struct G(span) S = G(span_of_pattern)(1, 0, x);
    num a = G(printed_entry)(&S, 0, 0, 1, fault(T, 0, 1)), value = G(basis_value)(&S, 0, 1, x[0]);
    found(T, "the printed a_00", a);
    found(T, "N_0,1(t_0)", value);
    about(T, "the printed a_00, and N_0,1(t_0)");
    same(T, a, value);
}

/*
:::{claim} printed_expansion_gives_the_negative_basis
:title: For k = 3 the printed expansion is the negative B-spline
:zh: k=3 时印出的展开式为负的 B 样条基
:kind: counterexample
:given: $k=3$, the simple knots $t_i$, numbered from 0, the span $[t_r,t_{r+1})$, the function $N_{i,k}$ and a $u$ of the span
:data: t_i = 0 1 3 4 6 7; r = 2; i = 1; u = 1/2
:then: the printed sum of the powers $u^j$ is the negative of $N_{i,k}(t)$
:result: the sum = -5/6; N_i,k(t) = 5/6
:method: The printed formula by its letter, the exponents $k-1-j$; the B-spline by its definition.
:control: the factors $t_l-t_\alpha$
:::
*/
CLAIM(printed_expansion_gives_the_negative_basis)
{
    num x[6], sum = from_int(0);
    given_points(T, "t_i", 6, 1, x);
    int r = given_whole(T, "r"), i = given_whole(T, "i"), k = r + 1;
    num u = given(T, "u");
    struct G(span) S = G(span_of_pattern)(k, G(patterns)(k) - 1, x);
    for (int j = 0; j < k; j++)
        sum = add(sum, mul(G(printed_entry)(&S, i, j, 0, fault(T, 0, 1)), G(power)(u, j)));
    num value = G(basis_value)(&S, i, k, G(at_parameter)(&S, u));
    found(T, "the sum", sum);
    found(T, "N_i,k(t)", value);
    about(T, "the sum, and N_i,k(t)");
    same(T, sum, value);
}
#endif

/*
:::{statement} wang-ch4:simple-basis-expanded
:title: The B-spline of simple knots in powers of u
:zh: 单节点 B 样条基的展开式
:printed: when all knots are simple, $N_{i,k}(t)=\sum_{j=0}^{k-1}u^j\binom{k-1}j(t_{i+k}-t_i)(t_r-t_{r+1})^j\sum_{l=r+1}^{i+k}\Bigl[(t_l-t_r)^{k-1-j}
  \Big/\prod_{\alpha=i,\,\alpha\ne l}^{i+k}(t_\alpha-t_l)\Bigr]$, $i=r-k+1,r-k+2,\dots,r$
:class: misprint
:refuted-by: printed_expansion_gives_the_negative_basis
:corrected: the same with $t_l-t_\alpha$: as printed it is $(-1)^kN_{i,k}$
:corrected-by: simple_function_in_every_order factors_of_both_orders binomial_theorem_in_every_degree
:confirmed-by: simple_matrix_is_the_matrix printed_simple_matrix_differs_by_the_parity_sign
:needs: polynomial_of_a_span_ends_with_it | theorem 4.4.1, from which it is taken: $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:figure: simple_knots_sign

It is the formula of `simple-basis`, each $(t_l-t)^{k-1}$ written in powers of $u$ with $\tau=t_l$, and the sums over $j$ and $l$ exchanged.
:::

The wrong sign is carried on into the B-spline, its expansion in $u$ and the entries of the matrix.  The corrected
formula is computed first; then the printed one is compared with it, and the parity shows.

:::{claim} simple_matrix_is_the_matrix
:title: The corrected formula gives the coefficient matrix
:zh: 改正后的 (4.4.23)
:given: orders $k$, odd and even, simple knots and $u$ variables
:then: the columns of the sums (4.4.23) with $t_l-t_\alpha$ and the exponent $k-1-j$ are the $N_{i,k}$ in powers of $u$, and `bspline_matrix_simple` has these entries
:method: The sums by their letter against the kernel, and in powers of a variable $u$ against the definition of the B-splines.
:degrees: 0..5 sampled 7
:scope: simple knots
:over: t#: knots
:defines: bspline_matrix_simple
:control: the rows in the opposite order
:::
*/
CLAIM(simple_matrix_is_the_matrix)
{
    int k = T->degree + 1;
    struct G(span) S = G(simple_span)(T, k);
    num A[CELLS], u = parameter(T, "u");
    G(bspline_matrix_simple)(k - 1, S.t, S.r, A);
    for (int i = 0; i < k; i++) {
        num sum = from_int(0);
        about(T, "the sum by its letter and the kernel's");
        for (int j = 0; j < k; j++) {
            num a = G(printed_entry)(&S, i, fault(T, j, k - 1 - j), 0, 0);
            same(T, a, A[j * k + i]);
            sum = add(sum, mul(a, G(power)(u, j)));
        }
        about(T, "the powers of u and the B-spline");
        same(T, sum, G(basis_value)(&S, i, k, G(at_parameter)(&S, u)));
    }
}

/*
:::{claim} printed_simple_matrix_differs_by_the_parity_sign
:title: With the exponent k-1-j the printed matrix is (-1)^k times the right one
:zh: 印式与正确矩阵相差 (-1)^k
:given: orders $k$, odd and even, simple knots, variables
:then: the sum (4.4.23) with the exponent $k-1-j$ and the factors $t_\alpha-t_l$ is $(-1)^ka_{ji}$; with the factors $t_l-t_\alpha$ it is $a_{ji}$
:method: Both sums by their letter against `bspline_matrix`, which computes the $a_{ji}$ by the recursion of de Boor and Cox.
:degrees: 0..4 sampled 7
:scope: simple knots
:over: t#: knots
:control: the factor $(-1)^{k+1}$
:::
*/
CLAIM(printed_simple_matrix_differs_by_the_parity_sign)
{
    int k = T->degree + 1;
    struct G(span) S = G(simple_span)(T, k);
    num A[CELLS];
    G(bspline_matrix)(k - 1, S.t, S.r, A);
    for (int j = 0; j < k; j++)
        for (int i = 0; i < k; i++) {
            /* the printed entry is (-1)^k a_ji */
            same(T, G(printed_entry)(&S, i, j, 0, 1), G(signed_by)(fault(T, k, k + 1), A[j * k + i]));
            same(T, G(printed_entry)(&S, i, j, 0, 0), A[j * k + i]);
        }
}

/*
:::{statement} wang-ch4:formula-4.4.23
:title: The entries of the coefficient matrix for simple knots
:zh: 单节点系数矩阵的元素
:printed: when all knots are simple, the elements of the coefficient matrix are
  $a_{ji}=\binom{k-1}j(t_{i+k}-t_i)(t_r-t_{r+1})^j\sum_{l=r+1}^{i+k}\Bigl[(t_l-t_r)^{k-l-j}\Big/\prod_{\alpha=i,\,
  \alpha\ne l}^{i+k}(t_\alpha-t_l)\Bigr]$, $i=r-k+1,r-k+2,\dots,r$; $j=0,1,\dots,k-1$
:class: misprint
:refuted-by: printed_entry_of_order_one_is_negative exponent_with_the_letter_fails
:corrected: a_{ji}=\binom{k-1}j(t_{i+k}-t_i)(t_r-t_{r+1})^j\sum_{l=r+1}^{i+k}\frac{(t_l-t_r)^{k-1-j}}{\prod_{\alpha=i,\,\alpha\ne l}^{i+k}
  (t_l-t_\alpha)}
:corrected-by: simple_function_in_every_order binomial_theorem_in_every_degree
:confirmed-by: simple_matrix_is_the_matrix printed_simple_matrix_differs_by_the_parity_sign
:needs: polynomial_of_a_span_ends_with_it | (4.4.11), whose coefficients they are: $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:striking: 9
:figure: simple_knots_sign

Two faults: the factors, whose product has the wrong sign for odd $k$, and in the exponent the letter $l$ where the digit 1 has to be, which is wrong alone in the
second counterexample.  Put right, the entries are the factors of the powers of $u$ in `simple-basis-expanded`.
:::
*/

#if RATIONAL
/*
In type a letter $l$ and a digit 1 look the same.  Where a sum has a variable $l$ the difference matters: the exponent
would change from term to term, and become negative.

:::{claim} exponent_with_the_letter_fails
:title: The exponent k-l-j with the number of the knot is wrong
:zh: 指数 k-l-j 中的 l 应为 1
:kind: counterexample
:given: $k=2$, where the sign is right, the simple knots $t_i$, numbered from 0, the span $[t_r,t_{r+1})$ and the entry $a_{ji}$
:data: t_i = 0 1 3 5; r = 1; i = 1; j = 0
:then: $a_{ji}=N_{i,k}(t_r)$ is 0; with the exponents $2-l$ for the two $l$ of the sum it is not
:result: the printed a_ji = -7/8; N_i,k(t_r) = 0
:method: The printed formula by its letter; the knots are numbered from 0, so that $t_r$ is knot 1.
:control: the exponent $k-1-j$
:::
*/
CLAIM(exponent_with_the_letter_fails)
{
    num x[4];
    given_points(T, "t_i", 4, 1, x);
    int r = given_whole(T, "r"), i = given_whole(T, "i"), j = given_whole(T, "j");
    struct G(span) S = G(span_of_pattern)(2, 3, x);
    num a = G(printed_entry)(&S, i, j, fault(T, 0, 1), 1), value = G(basis_value)(&S, i, 2, x[r]);
    found(T, "the printed a_ji", a);
    found(T, "N_i,k(t_r)", value);
    about(T, "the printed a_ji, and N_i,k(t_r)");
    same(T, a, value);
}
#endif

#include "chapters/judge/claims_off.h"
