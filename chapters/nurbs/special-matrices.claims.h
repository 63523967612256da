/*
# Special coefficient matrices (特殊系数矩阵)

Three kinds of knots have formulas of their own: knots that are all different, equidistant knots, and the knots of a
single Bézier segment.  The source derives the first two from the divided differences, which is what this section is
about, the third from Marsden's identity.  A formula with alternating signs and factorials is easily misprinted; so
each sum is computed by its letter and compared with the matrix that the recursion gives.
*/
#include "chapters/nurbs/spans.h"

#include "chapters/judge/claims_on.h"

enum { CELLS = LARGEST_ORDER * LARGEST_ORDER };

/*
## Simple knots (单节点)

:::{statement} wang-ch4:simple-vandermonde
:title: For simple nodes the determinant is that of Vandermonde
:zh: 单节点时为 Vandermonde 行列式
:printed: when all knots of $T$ are simple, $\det H(T;1,t,\dots,t^k)$ is Vandermonde's determinant
:holds-by: simple_determinant_is_vandermonde
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
:printed: [t_i,t_{i+1},\dots,t_{i+k}]f=\sum_{l=i}^{i+k}\Bigl[\prod_{j=i,\,j\ne l}^{i+k}(t_j-t_l)\Bigr]^{-1}f(t_l)
:class: misprint
:refuted-by: printed_simple_difference_has_wrong_sign
:corrected: the factors are $t_l-t_j$; there are $k$ of them, so the printed formula has the wrong sign for odd $k$ and is
  right for even $k$
:corrected-by: simple_difference_has_factors_of_both_orders
:figure: simple_knots_sign
:::
*/

/* The product over all m = i, ..., i+k but l of t_m - t_l (as printed), or of t_l - t_m. */
static num G(product_of_differences)(const num t[], int i, int k, int l, int as_printed)
{
    num product = from_int(1);
    for (int m = i; m <= i + k; m++)
        if (m != l)
            product = mul(product, as_printed ? sub(t[m], t[l]) : sub(t[l], t[m]));
    return product;
}

/*
For simple nodes the weights are the well-known ones of Lagrange.  Whether a factor is written $t_l-t_j$ or $t_j-t_l$
changes the sign of each of $k$ factors, hence that of the whole for odd $k$: a fault that an example with $k=2$ does
not show.

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
:printed: N_{i,k}(t)=(t_{i+k}-t_i)\sum_{l=r+1}^{i+k}\alpha_l(t_l-t)^{k-1},\quad i=r-k+1,r-k+2,\dots,r
:reading: simple_basis_from_weights | $\alpha_l$ is the weight $\alpha_{\lambda0}$ of lemma 4.4.1 at the node $t_l$
:reading: printed_weights_give_the_negative_basis | $\alpha_l$ is what the formula for the divided difference before it has in front of $f(t_l)$ as
  printed: so read it is $-N_{0,1}$ for $k=1$
:corrected: \alpha_l=\Bigl[\prod_{j=i,\,j\ne l}^{i+k}(t_l-t_j)\Bigr]^{-1}
:corrected-by: simple_basis_from_weights
:confirmed-by: simple_difference_has_factors_of_both_orders
:needs: polynomial_of_a_span_ends_with_it | theorem 4.4.1, from which it is taken: $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:figure: simple_knots_sign

Nothing in the source says what $\alpha_l$ is.
:::

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

/* (4.4.23) by its letter, but for the exponent, which is given: k-1-j, or k-l-j with the number l of the knot. */
static num G(printed_entry)(const struct G(span) * S, int i, int j, int letter, int as_printed)
{
    int k = S->k, r = S->r;
    num sum = from_int(0), step = sub(S->t[r], S->t[r + 1]);
    for (int l = r + 1; l <= i + k; l++) {
        int exponent = letter ? k - l - j : k - 1 - j;
        num gap = sub(S->t[l], S->t[r]);
        num power = exponent >= 0 ? G(power)(gap, exponent) : div(from_int(1), G(power)(gap, -exponent));
        sum = add(sum, div(power, G(product_of_differences)(S->t, i, k, l, as_printed)));
    }
    return mul(mul(G(choose)(k - 1, j), sub(S->t[i + k], S->t[i])), mul(G(power)(step, j), sum));
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
:printed: N_{i,k}(t)=\sum_{j=0}^{k-1}u^j\binom{k-1}j(t_{i+k}-t_i)(t_r-t_{r+1})^j\sum_{l=r+1}^{i+k}\Bigl[(t_l-t_r)^{k-1-j}
  \Big/\prod_{\alpha=i,\,\alpha\ne l}^{i+k}(t_\alpha-t_l)\Bigr],\quad i=r-k+1,r-k+2,\dots,r
:class: misprint
:refuted-by: printed_expansion_gives_the_negative_basis
:corrected: the same with $t_l-t_\alpha$: as printed it is $(-1)^kN_{i,k}$
:corrected-by: simple_matrix_is_the_matrix printed_simple_matrix_differs_by_the_parity_sign
:needs: polynomial_of_a_span_ends_with_it | theorem 4.4.1, from which it is taken: $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:figure: simple_knots_sign
:::

The wrong sign is carried on into the B-spline, its expansion in $u$ and the entries of the matrix.  The corrected
formula is proved first; then the printed one is compared with it, and the parity shows.

:::{claim} simple_matrix_is_the_matrix
:title: The corrected formula gives the coefficient matrix
:zh: 改正后的 (4.4.23)
:given: orders $k$, odd and even, simple knots and $u$ variables
:then: the columns of `bspline_matrix_simple`, the sums (4.4.23) with $t_l-t_\alpha$ and the exponent $k-1-j$, are the $N_{i,k}$ in powers of $u$
:method: The kernel's sums against the definition of the B-splines, as functions of a variable $u$.
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
        for (int j = 0; j < k; j++)
            sum = add(sum, mul(A[fault(T, j, k - 1 - j) * k + i], G(power)(u, j)));
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
:printed: a_{ji}=\binom{k-1}j(t_{i+k}-t_i)(t_r-t_{r+1})^j\sum_{l=r+1}^{i+k}\Bigl[(t_l-t_r)^{k-l-j}\Big/\prod_{\alpha=i,\,
  \alpha\ne l}^{i+k}(t_\alpha-t_l)\Bigr],\quad i=r-k+1,r-k+2,\dots,r;\ j=0,1,\dots,k-1
:class: misprint
:refuted-by: printed_entry_of_order_one_is_negative exponent_with_the_letter_fails
:corrected: a_{ji}=\binom{k-1}j(t_{i+k}-t_i)(t_r-t_{r+1})^j\sum_{l=r+1}^{i+k}\frac{(t_l-t_r)^{k-1-j}}{\prod_{\alpha=i,\,\alpha\ne l}^{i+k}
  (t_l-t_\alpha)}
:corrected-by: simple_matrix_is_the_matrix printed_simple_matrix_differs_by_the_parity_sign
:striking: 9
:figure: simple_knots_sign

Two faults: the factors, whose product has the wrong sign for odd $k$, and in the exponent the letter $l$ where the digit 1 has to be, which is wrong alone in the
second counterexample.
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

/*
## Equidistant knots (等距节点)

With $t_i=i$ the products are factorials.  The source derives the matrix by a chain of four sums: the knots put in, then
$i=r-k+1+s$, then $v=l-r-1$, then $l=s-v$.

:::{statement} wang-ch4:uniform-wlog
:title: Equidistant knots may be taken as the integers
:zh: 等距时不妨设 t_i=i
:printed: when the knots of $T$ are equidistant, one may put $t_i=i$
:holds-by: uniform_matrix_is_the_matrix
:confirmed-by: coefficient_matrix_is_affinely_invariant
:figure: uniform_matrices

The knots are $a+hi$, and the matrix is that of $a=0$, $h=1$.
:::

:::{claim} uniform_matrix_is_the_matrix
:title: The formula for equidistant knots gives the coefficient matrix
:zh: 等距节点系数矩阵公式
:given: orders $k$, the knots $t_i=a+hi$ with variables $a$ and $h$, $u$ variable
:then: the columns of the matrix of the printed sums, in which neither $a$ nor $h$ stands, are the $N_{i,k}$ in powers of $u$
:method: The kernel's sums against the definition of the B-splines, as functions of a variable $u$.
:degrees: 0..6 sampled 8
:over: a: first knot; h: gap
:defines: bspline_matrix_uniform
:control: the columns in the opposite order
:::
*/
CLAIM(uniform_matrix_is_the_matrix)
{
    int k = T->degree + 1;
    struct G(span) S = {.k = k, .r = k - 1};
    num A[CELLS], u = parameter(T, "u"), a = unknown(T, "a", 0), h = positive(T, "h", 0);
    for (int m = 0; m < 2 * k; m++) {
        S.t[m] = add(a, mul(from_int(m), h));
        S.group[m] = m;
    }
    G(bspline_matrix_uniform)(k - 1, A);
    for (int i = 0; i < k; i++)
        same(T, G(column_value)(k, A, fault(T, i, k - 1 - i), u), G(basis_value)(&S, i, k, G(at_parameter)(&S, u)));
}

/*
:::{statement} wang-ch4:uniform-start
:title: The chain begins with formula 4.4.23
:zh: 推导以 (4.4.23) 为起点
:printed: with $t_i=i$ formula (4.4.23) becomes the first sum of the chain, $a_{ji}=\binom{k-1}jk\sum_{l=r+1}^{i+k}\frac{(-1)^{j+k+l-i}(l-r)^{k-l-j}}{(l-i)!\,(i+k-l)!}$
:class: invalid-proof
:refuted-by: uniform_chain_does_not_follow
:corrected: it follows from (4.4.23) with the factors $t_l-t_\alpha$ and, in both, the exponent $k-1-j$
:corrected-by: corrected_entry_becomes_the_first_sum
:confirmed-by: uniform_chain_gives_the_matrix
:figure: simple_knots_sign
:::
*/

/* (a)^exponent for any integer exponent. */
static num G(any_power)(int a, int exponent)
{
    num size = G(power)(from_int(a), exponent < 0 ? -exponent : exponent);
    return exponent < 0 ? div(from_int(1), size) : size;
}

/* The four sums.  `one` stands where the source has the letter l for the digit 1 in the exponent: 1, or 0 for the
 * letter; in line 3, where it is no variable of the sum, the value of the letter. */
static num G(uniform_line)(int line, int k, int r, int i, int j, int one)
{
    int s = i - r + k - 1;
    num sum = from_int(0), front = mul(G(choose)(k - 1, j), from_int(k));
    if (line == 1)
        for (int l = r + 1; l <= i + k; l++) {
            num below = mul(G(factorial)(l - i), G(factorial)(i + k - l));
            sum = add(sum, G(signed_by)(j + k + l - i, div(G(any_power)(l - r, k - (one ? 1 : l) - j), below)));
        }
    if (line == 2)
        for (int l = r + 1; l <= r + 1 + s; l++) {
            num below = mul(G(factorial)(l + k - r - 1 - s), G(factorial)(one ? r + s + 1 - l : r + s + l - l));
            sum = add(sum, G(signed_by)(l + r + s + 1 + j, div(G(any_power)(l - r, k - 1 - j), below)));
        }
    if (line == 3)
        for (int v = 0; v <= s; v++) {
            num below = mul(G(factorial)(v + k - s), G(factorial)(s - v));
            sum = add(sum, G(signed_by)(v + s + j, div(G(any_power)(v + 1, k - one - j), below)));
        }
    if (line == 4)
        for (int l = 0; l <= s; l++) {
            num below = mul(G(factorial)(k - l), G(factorial)(l));
            sum = add(sum, G(signed_by)(l + j, div(G(any_power)(s - l + 1, k - (one ? 1 : l) - j), below)));
        }
    return mul(front, sum);
}

/*
:::{claim} corrected_entry_becomes_the_first_sum
:title: Formula 4.4.23, its factors put right, becomes the first sum
:zh: 改正后的 (4.4.23) 化为第一式
:given: orders $k$, the knots $t_{r-k+1},\dots,t_{r+k}$, which are $a,a+1,\dots,a+2k-1$ with a variable $a$
:then: for all $i$ and $j$ the sum (4.4.23) with the factors $t_l-t_\alpha$ and the exponent $k-1-j$ is the first sum with this exponent
:method: Both sums by their letter.  In the first sum only differences of $l$, $i$ and $r$ stand, so that $r$ may be taken as $k-1$.
:degrees: 0..6 sampled 8
:over: a: first knot
:control: the factors $t_\alpha-t_l$
:::
*/
CLAIM(corrected_entry_becomes_the_first_sum)
{
    int k = T->degree + 1;
    struct G(span) S = {.k = k, .r = k - 1};
    num a = unknown(T, "a", 0);
    for (int m = 0; m < 2 * k; m++) {
        S.t[m] = add(a, from_int(m));
        S.group[m] = m;
    }
    for (int j = 0; j < k; j++)
        for (int i = 0; i < k; i++)
            same(T, G(printed_entry)(&S, i, j, 0, fault(T, 0, 1)), G(uniform_line)(1, k, S.r, i, j, 1));
}

#if RATIONAL
/* The 2k equidistant knots of the span [r, r+1), and the place of i among their functions. */
static struct G(span) G(uniform_span)(int k, int r)
{
    struct G(span) S = {.k = k, .r = k - 1};
    for (int m = 0; m < 2 * k; m++) {
        S.t[m] = from_int(r - k + 1 + m);
        S.group[m] = m;
    }
    return S;
}

/*
Each of the four sums is computed twice, with the digit and with the letter.  With the digit all four are the entries
of the matrix.  The sign with which the chain begins is the right one, so it does not come from the printed (4.4.23).

:::{claim} uniform_chain_gives_the_matrix
:title: The four sums, with the digit 1, are the entries of the matrix
:zh: 改正后四式均为矩阵元素
:kind: decision
:given: the orders $k$, $r=0$ and $r=k+2$, the knots $t_i=i$
:then: for all $i$ and $j$ the four sums are $a_{ji}$, the first also when it is computed from (4.4.23) with the factors
  $t_l-t_\alpha$
:method: Every sum by its letter, with the digit 1 where the letter $l$ stands for it; the degree below is $k-1$.
:degrees: 0..8
:scope: r = 0 and r = k+2
:control: the sign $(-1)^s$ left out of the third sum
:::
*/
CLAIM(uniform_chain_gives_the_matrix)
{
    int k = T->degree + 1;
    num A[CELLS];
    G(bspline_matrix_uniform)(k - 1, A);
    for (int r = 0; r <= k + 2; r += k + 2) {
        struct G(span) S = G(uniform_span)(k, r);
        for (int j = 0; j < k; j++)
            for (int s = 0; s < k; s++) {
                agree(T, equal_q(G(printed_entry)(&S, s, j, 0, 0), A[j * k + s]));
                for (int line = 1; line <= 4; line++) {
                    num sum = G(uniform_line)(line, k, r, r - k + 1 + s, j, 1);
                    if (T->faulty && line == 3)
                        sum = G(signed_by)(s, sum);
                    agree(T, equal_q(sum, A[j * k + s]));
                }
            }
    }
}

/*
The last sum knows nothing of $r$, and each term of the others is one of its terms, whatever $r$ is.

:::{claim} last_sum_gives_the_uniform_matrix
:title: The fourth sum, with the digit 1, is the entry of the matrix
:zh: 第四式即矩阵元素
:kind: decision
:given: the orders $k$
:then: for all $s$ and $j$ the fourth sum with the exponent $k-1-j$ is the entry of row $j$ and column $s$ of the kernel's matrix; $r$ is in neither
:method: The sum by its letter, with the digit 1 where the letter $l$ stands for it; that the kernel's matrix is that of equidistant knots is
  `uniform_matrix_is_the_matrix`.
:degrees: 0..8
:control: the sign $(-1)^{s+1}$ put before the sum
:::
*/
CLAIM(last_sum_gives_the_uniform_matrix)
{
    int k = T->degree + 1;
    num A[CELLS];
    G(bspline_matrix_uniform)(k - 1, A);
    for (int j = 0; j < k; j++)
        for (int s = 0; s < k; s++) {
            num sum = G(uniform_line)(4, k, k - 1, s, j, 1);
            agree(T, equal_q(fault(T, sum, G(signed_by)(s + 1, sum)), A[j * k + s]));
        }
}

/*
:::{claim} uniform_chain_does_not_follow
:title: From the printed formula 4.4.23 the first sum does not follow
:zh: 由印出的 (4.4.23) 推不出第一式
:kind: counterexample
:given: $t_i=i$; the order $k$, the span $[t_r,t_{r+1})$ and the entry $a_{ji}$
:data: k = 3; r = 2; i = 1; j = 0
:then: (4.4.23) gives the negative of the first sum of the chain, with the printed exponents $k-l-j$ in both and with $k-1-j$ in both
:result: (4.4.23) = 5/4; the first sum = -5/4; with k-1-j: (4.4.23) = -1/2; with k-1-j: the first sum = 1/2
:method: Both by their letter.
:control: the factors $t_l-t_\alpha$ in (4.4.23)
:::
*/
CLAIM(uniform_chain_does_not_follow)
{
    int k = given_whole(T, "k"), r = given_whole(T, "r"), i = given_whole(T, "i"), j = given_whole(T, "j");
    struct G(span) S = G(uniform_span)(k, r);
    static const char *const name[][2] = {{"(4.4.23)", "the first sum"},
                                          {"with k-1-j: (4.4.23)", "with k-1-j: the first sum"}};
    for (int digit = 0; digit <= 1; digit++) { /* the letter l in the exponents, then 1; r is k-1 */
        num entry = G(printed_entry)(&S, i - r + k - 1, j, !digit, fault(T, 0, 1)),
            sum = G(uniform_line)(1, k, r, i, j, digit);
        found(T, name[digit][0], entry);
        found(T, name[digit][1], sum);
        about(T, "(4.4.23), and the first sum of the chain");
        same(T, entry, sum);
    }
}

/*
:::{statement} wang-ch4:uniform-line-1
:title: First sum: the knots put in
:zh: 等距情形第一式
:printed: a_{ji}=\binom{k-1}jk\sum_{l=r+1}^{i+k}\frac{(-1)^{j+k+l-i}(l-r)^{k-l-j}}{(l-i)!\,(i+k-l)!}
:class: misprint
:refuted-by: uniform_letter_one_fails
:corrected: the exponent is $k-1-j$; everything else is right
:corrected-by: last_sum_gives_the_uniform_matrix uniform_terms_pass_into_one_another uniform_matrix_is_the_matrix
:confirmed-by: uniform_chain_gives_the_matrix
:figure: uniform_letter
:::
*/

/* The order, the span, the function and the power of one entry a_{ji} of the matrix of equidistant knots, from a block. */
struct indices {
    int k, r, i, j;
};
static struct indices given_indices(trial *T)
{
    struct indices at;
    at.k = given_whole(T, "k");
    at.r = given_whole(T, "r");
    at.i = given_whole(T, "i");
    at.j = given_whole(T, "j");
    return at;
}

static num G(uniform_entry)(struct indices at)
{
    num A[CELLS];
    G(bspline_matrix_uniform)(at.k - 1, A);
    return A[at.j * at.k + at.i - at.r + at.k - 1];
}

/* Compare: the printed sum of a line, whose name is given, with the entry of the matrix.  `letter`: what stands for the digit 1
 * in the exponent, as `uniform_line` takes it. */
static void G(compare_line)(trial *T, const char *name, int line, int letter, struct indices at)
{
    num sum = G(uniform_line)(line, at.k, at.r, at.i, at.j, fault(T, 1, letter));
    found(T, name, sum);
    same(T, sum, G(uniform_entry)(at));
}

/*
With the letter the sums differ from the entries already for the smallest orders, and each in its own way; for every
sum one entry is enough.

:::{claim} uniform_letter_one_fails
:title: The exponent k-l-j of the first sum is wrong
:zh: 第一式中指数 k-l-j 有误
:kind: counterexample
:given: $t_i=i$; the order $k$, the span $[t_r,t_{r+1})$ and the entry $a_{ji}$
:data: k = 2; r = 1; i = 1; j = 0
:then: $a_{ji}=0$; the first sum, of which one exponent is 0 and the other negative, is not 0
:result: the first sum = -3/2; a_ji = 0
:method: The sum by its letter.
:control: the exponent $k-1-j$
:::
*/
CLAIM(uniform_letter_one_fails)
{
    struct indices at = given_indices(T);
    about(T, "the first sum, and a_ji");
    G(compare_line)(T, "the first sum", 1, 0, at);
    found(T, "a_ji", G(uniform_entry)(at));
}

/*
:::{statement} wang-ch4:uniform-line-2
:title: Second sum: i = r-k+1+s
:zh: 等距情形第二式
:printed: a_{ji}=\dots=\binom{k-1}jk(-1)^j\sum_{l=r+1}^{r+l+s}\frac{(-1)^{l+r+s+1}(l-r)^{k-l-j}}{(l+k-r-1-s)!\,(r+s+l-l)!}
:class: misprint
:refuted-by: uniform_letter_in_factorial_fails
:corrected: the upper limit is $r+1+s$, the exponent $k-1-j$ and the last factorial $(r+s+1-l)!$: three letters $l$ for the
  digit 1
:corrected-by: last_sum_gives_the_uniform_matrix uniform_terms_pass_into_one_another uniform_matrix_is_the_matrix
:confirmed-by: uniform_chain_gives_the_matrix
:figure: uniform_letter

With $l$ in its own upper limit the sum has no meaning; with the limit and the exponent put right the factorial is still wrong.
:::

:::{claim} uniform_letter_in_factorial_fails
:title: The factorial (r+s+l-l)! of the second sum is wrong
:zh: 第二式中阶乘 (r+s+l-l)! 有误
:kind: counterexample
:given: $t_i=i$; the order $k$, the span $[t_r,t_{r+1})$ and the entry $a_{ji}$, so that $s=i-r+k-1=0$; the upper limit and the exponent taken with the digit 1
:data: k = 1; r = 2; i = 2; j = 0
:then: the only term of the second sum has $(r+s)!$ in the place of $0!$, so that it is not $a_{ji}$
:result: the second sum = 1/2; a_ji = 1
:method: The sum by its letter but for limit and exponent, which have to be read with the digit to have a meaning.
:control: $(r+s+1-l)!$
:::
*/
CLAIM(uniform_letter_in_factorial_fails)
{
    struct indices at = given_indices(T);
    about(T, "the second sum, and a_ji");
    G(compare_line)(T, "the second sum", 2, 0, at);
    found(T, "a_ji", G(uniform_entry)(at));
}

/*
:::{statement} wang-ch4:uniform-line-3
:title: Third sum: v = l-r-1
:zh: 等距情形第三式
:printed: a_{ji}=\dots=\binom{k-1}jk(-1)^j\sum_{v=0}^s\frac{(-1)^{v+s}(v+1)^{k-l-j}}{(v+k-s)!\,(s-v)!}
:class: misprint
:refuted-by: uniform_letter_is_free_in_the_third_sum
:corrected: the exponent is $k-1-j$
:corrected-by: last_sum_gives_the_uniform_matrix uniform_terms_pass_into_one_another uniform_matrix_is_the_matrix
:confirmed-by: uniform_chain_gives_the_matrix
:figure: uniform_letter

By the letter the sum has no value: $l$, the variable of the second sum, is bound nowhere here.  In the example it is $a_{ji}$ with $l=1$, and not with $l=2$.
:::

:::{claim} uniform_letter_is_free_in_the_third_sum
:title: In the third sum the letter l is free, and with l = 2 it is no entry of the matrix
:zh: 第三式中的字母 l 无所指
:kind: counterexample
:given: $t_i=i$; the order $k$, the span $[t_r,t_{r+1})$ and the entry $a_{ji}$, so that $s=i-r+k-1=1$; a value of $l$, which nothing says
:data: k = 2; r = 1; i = 1; j = 0; l = 2
:then: $a_{ji}=0$; the third sum with this $l$ is not 0, and with $l=1$ it is 0
:result: the third sum = -1; a_ji = 0
:method: The sum by its letter, $l$ being a number.
:control: $l=1$, the exponent $k-1-j$
:::
*/
CLAIM(uniform_letter_is_free_in_the_third_sum)
{
    struct indices at = given_indices(T);
    about(T, "the third sum, and a_ji");
    G(compare_line)(T, "the third sum", 3, given_whole(T, "l"), at);
    found(T, "a_ji", G(uniform_entry)(at));
}

/*
:::{statement} wang-ch4:uniform-line-4
:title: Fourth sum: l = s-v
:zh: 等距情形第四式
:printed: a_{ji}=\dots=\binom{k-1}jk(-1)^j\sum_{l=0}^s\frac{(-1)^l(s-l+1)^{k-l-j}}{(k-l)!\,l!}
:class: misprint
:refuted-by: uniform_letter_in_last_sum_fails
:corrected: the exponent is $k-1-j$
:corrected-by: last_sum_gives_the_uniform_matrix uniform_matrix_is_the_matrix
:confirmed-by: uniform_chain_gives_the_matrix
:figure: uniform_letter
:::

:::{claim} uniform_letter_in_last_sum_fails
:title: The exponent k-l-j of the fourth sum is wrong
:zh: 第四式中指数 k-l-j 有误
:kind: counterexample
:given: $t_i=i$; the order $k$, the span $[t_r,t_{r+1})$ and the entry $a_{ji}$, so that $s=i-r+k-1=1$
:data: k = 2; r = 1; i = 1; j = 0
:then: $a_{ji}=0$; the fourth sum with the exponents $k-l-j$ is not 0
:result: the fourth sum = 2; a_ji = 0
:method: The sum by its letter.
:control: the exponent $k-1-j$
:::
*/
CLAIM(uniform_letter_in_last_sum_fails)
{
    struct indices at = given_indices(T);
    about(T, "the fourth sum, and a_ji");
    G(compare_line)(T, "the fourth sum", 4, 0, at);
    found(T, "a_ji", G(uniform_entry)(at));
}
#endif

/*
:::{statement} wang-ch4:uniform-substitutions
:title: The three substitutions
:zh: 三次变量替换
:printed: changing the variables in (4.4.23), one puts in turn $i=r-k+1+s$, $v=l-r-1$, $l=s-v$
:holds-by: uniform_terms_pass_into_one_another
:confirmed-by: uniform_chain_gives_the_matrix
:meant: the words in turn (依次) | The last $l$ is a new one, $r+1+s$ minus the old.
:figure: uniform_matrices

Each term of a sum is one of the next where the digit 1 stands for the letter $l$ that is printed in the exponents.
:::

:::{claim} uniform_terms_pass_into_one_another
:title: Each substitution takes every term of a sum to a term of the next
:zh: 三次替换逐项成立
:given: $k$, $r$, $s$ and $v$, variables; $i=r-k+1+s$, $l=r+1+v$ for the old $l$, $s-v$ for the new one
:then: base, factorials and exponents of the term $l$ of the first sum are those of the term $l$ of the second, $v$ of the third and $s-v$ of the fourth, and the exponents of $-1$ differ by even
  numbers; the terms $l=r+1,\dots,i+k$ are $l=r+1,\dots,r+1+s$, then $v=0,\dots,s$, then $s,\dots,0$
:method: Identities in the four letters, factor by factor, the digit 1 where the letter $l$ stands for it.  The factor $(-1)^j$, the binomial coefficient, $k$ and the exponent $k-1-j$ stand in
  all four.
:degrees: all
:over: r s v: -; k: -
:control: $i=r-k+s$
:::
*/
CLAIM(uniform_terms_pass_into_one_another)
{
    num k = whole(T, "k", 9, 20), r = whole(T, "r", 0, 30), s = whole(T, "s", 4, 8), v = whole(T, "v", 0, 3);
    num one = from_int(1), two = from_int(2), i = add(sub(add(r, s), k), fault(T, one, from_int(0)));
    num l = add(add(r, one), v), fourth = sub(s, v);
    about(T, "the base");
    same(T, sub(l, r), add(v, one));
    same(T, add(v, one), add(sub(s, fourth), one));
    about(T, "the first factorial");
    same(T, sub(l, i), sub(sub(sub(add(l, k), r), one), s));
    same(T, sub(l, i), sub(add(v, k), s));
    same(T, sub(l, i), sub(k, fourth));
    about(T, "the second factorial");
    same(T, sub(add(i, k), l), sub(add(add(r, s), one), l));
    same(T, sub(add(i, k), l), fourth);
    about(T, "the exponents of -1"); /* j+k+l-i, then j and l+r+s+1, v+s, l */
    num sign[] = {sub(add(k, l), i), add(add(add(l, r), s), one), add(v, s), fourth};
    same(T, sub(sign[0], sign[1]), mul(two, sub(sub(sub(k, r), s), one)));
    same(T, sub(sign[1], sign[2]), mul(two, add(r, one)));
    same(T, sub(sign[2], sign[3]), mul(two, v));
    about(T, "the last term");
    same(T, add(i, k), add(add(r, one), s));
}

/*

:::{statement} wang-ch4:uniform-matrix
:title: The coefficient matrix of equidistant knots
:zh: 等距节点的系数矩阵
:printed: simplified and rearranged, on the interval $[t_r,t_{r+1})=[r,r+1)$ the elements of $\mathbf A_{r,t,T}$ are
  $a_{j,r-k+1+i}=(-1)^j\frac{\binom{k-1}j}{(k-1)!}\sum_{l=0}^i(-1)^l\binom kl(i-l+1)^{k-1-j}$, $i,j=0,1,\dots,k-1$
:holds-by: uniform_matrix_is_the_matrix
:meant: (4.4.3), whose indices are $r,k,T$ | The matrix is $\mathbf A_{r,k,T}$, see `notation-4.4`.
:figure: uniform_matrices

Here the exponent is printed right.
:::

:::{statement} wang-ch4:uniform-matrix-independent
:title: The matrix is the same on every span
:zh: 与 r 无关
:printed: the entries do not depend on $r$
:holds-by: uniform_matrix_is_the_matrix
:confirmed-by: coefficient_matrix_is_affinely_invariant
:figure: uniform_matrices

Another $r$ is another first knot: around $[r,r+1)$ it is $r-k+1$.
:::
*/

#include "chapters/judge/claims_off.h"
