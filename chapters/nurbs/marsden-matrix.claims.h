/*
# The coefficient matrix by Marsden's identity (基于 Marsden 恒等式的系数矩阵)

The powers of $t$ are combinations of the B-splines with the matrix $G$ of (4.4.18).  The inverse of this matrix, with
cofactors written out, gives the B-splines in powers of $t$; one more expansion gives them in powers of $u$.
*/
#include "chapters/nurbs/spans.h"

#include "chapters/judge/claims_on.h"

enum { CELLS = LARGEST_ORDER * LARGEST_ORDER };

/*
:::{statement} wang-ch4:formula-4.4.18
:title: The matrix G
:zh: 矩阵 G
:printed: \mathbf G_{r,k,T}=\begin{pmatrix}g_{0,r-k+1}&g_{0,r-k+2}&\dots&g_{0,r}\\g_{1,r-k+1}&g_{1,r-k+2}&\dots&g_{1,r}\\
  \dots&\dots&\dots&\dots\\g_{k-1,r-k+1}&g_{k-1,r-k+2}&\dots&g_{k-1,r}\end{pmatrix}
:definition: yes
:checked-by: marsden_matrix_holds_derivatives
:figure: both_matrices
:::

:::{statement} wang-ch4:formula-4.4.19
:title: The entries of G
:zh: 矩阵 G 的元素
:printed: g_{\mu i}=\frac{(-1)^\mu\mu!}{(k-1)!}\omega_{i,k}^{(k-1-\mu)}(0),\quad\mu=0,1,\dots,k-1;\ i=r-k+1,r-k+2,\dots,r
:definition: yes
:checked-by: marsden_matrix_holds_derivatives
:figure: both_matrices
:::
*/

#if FIELD
/*
:::{claim} marsden_matrix_holds_derivatives
:title: The kernel's matrix has the printed entries
:zh: 矩阵 G 元素的核对
:given: orders $k$, knots variables
:let: $\omega_{i,k}$ the product (4.4.14)
:then: `marsden_matrix` has the entries $\frac{(-1)^\mu\mu!}{(k-1)!}\omega_{i,k}^{(k-1-\mu)}(0)$
:method: The kernel divides symmetric functions by binomial coefficients; the other side takes formal derivatives of the
  product $\omega_{i,k}$ in the field.
:types: field
:degrees: 0..6
:over: t#: knots; x: -
:defines: marsden_matrix
:control: the derivatives of order $\mu$
:::
*/
CLAIM(marsden_matrix_holds_derivatives)
{
    int k = T->degree + 1;
    struct G(span) S = G(simple_span)(T, k);
    num g[CELLS], x = variable_f("x");
    G(marsden_matrix)(k - 1, S.t, S.r, g);
    for (int i = 0; i < k; i++)
        for (int mu = 0; mu < k; mu++) {
            num D = from_int(1);
            for (int m = i + 1; m <= i + k - 1; m++)
                D = mul(D, sub(x, S.t[m]));
            for (int m = 0; m < fault(T, k - 1 - mu, mu); m++)
                D = derivative_f(D, x);
            D = mul(div(G(factorial)(mu), G(factorial)(k - 1)), substitute_f(D, x, from_int(0)));
            /* g_μi = (-1)^μ μ!/(k-1)! ω_i,k^(k-1-μ)(0) */
            same(T, g[mu * k + i], G(signed_by)(mu, D));
        }
}
#endif

/*
The formula of the theorem contains cofactors and a determinant.  A kernel computes cofactors by leaving out a row and
a column; to be sure that sign and place are right they are compared with another description, a determinant with a
column replaced.

:::{claim} cofactor_is_signed_minor
:title: The cofactors of a column are what expands the determinant by it
:zh: 代数余子式
:given: all entries of an $n\times n$ matrix, variables
:then: the cofactor of a place is the determinant, as a sum over permutations, of the matrix with that column replaced
  by the unit vector of the row
:method: `cofactor` leaves out row and column; the other side keeps all $n$ rows.
:degrees: rows = 1..4 sampled 6
:over: m#: entries
:defines: cofactor
:control: the unit vector of the next row
:::
*/
CLAIM(cofactor_is_signed_minor)
{
    int n = T->degree;
    num M[CELLS], replaced[CELLS];
    for (int m = 0; m < n * n; m++)
        M[m] = unknown(T, "m", m);
    for (int row = 0; row < n; row++)
        for (int column = 0; column < n; column++) {
            int one = fault(T, row, (row + 1) % n);
            for (int i = 0; i < n; i++)
                for (int j = 0; j < n; j++)
                    replaced[i * n + j] = j == column ? from_int(i == one) : M[i * n + j];
            same(T, G(cofactor)(n, M, row, column), G(leibniz)(n, 0, 0, replaced));
        }
}

/*
:::{statement} wang-ch4:formula-4.4.16
:title: On a span a B-spline is a polynomial of u
:zh: B 样条基的幂基表示
:printed: if the interval $[t_r,t_{r+1})$ is not empty, then for $i=r-k+1,r-k+2,\dots,r$ there is
  $N_{i,k}(t)=N_{i,k}^*(u)=\sum_{j=0}^{k-1}\bar a_{ji}u^j$, $u=\frac{t-t_r}{t_{r+1}-t_r}\in[0,1)$, $t\in[t_r,t_{r+1})$
:holds-by: printed_cofactor_formula_gives_the_basis marsden_step_for_every_order coefficients_of_marsden_in_every_order
  outer_functions_are_made_of_outer_ones divisors_contain_the_span
  power_of_t_in_every_degree
:argued: every k and every pattern of knots | (4.4.21) is true for every $k$, and so is $\det\mathbf G\ne0$: $\mathbf G^Tc=0$ gives $\sum c_\mu t^\mu=0$, and so
  $c=0$.  The inverse matrix by its cofactors solves (4.4.21) for the $N_{i,k}$, and their powers of $t$ are written in powers of $u$.
:needs: empty_span_makes_g_singular | theorem 4.4.3: the interval $[t_r,t_{r+1})$ is not empty | the span is not
  empty
:needs: polynomial_of_a_span_ends_with_it | the line itself: $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:figure: both_matrices

The $\bar a_{ji}$ are those of (4.4.17), see `thm-4.4.3`.
:::

:::{statement} wang-ch4:thm-4.4.3
:title: The coefficients by Marsden's identity
:zh: 定理 4.4.3 基于 Marsden 恒等式的系数矩阵
:printed: if the interval $[t_r,t_{r+1})$ is not empty, the $\bar a_{ji}$ of (4.4.16) are $\frac{(t_{r+1}-t_r)^j}{\det\mathbf G_{r,k,T}}\sum_{\mu=j}^{k-1}\binom\mu jt_r^{\mu-j}g^*_{\mu i}$, $j=0,1,\dots,k-1$, where
  $\mathbf G_{r,k,T}$ is the $k\times k$ matrix (4.4.18), (4.4.19), $g_\mu^*$ is the cofactor of its element $g_\mu$, and $\omega_{i,k}$ is as in (4.4.14)
:holds-by: printed_cofactor_formula_gives_the_basis marsden_step_for_every_order coefficients_of_marsden_in_every_order
  outer_functions_are_made_of_outer_ones divisors_contain_the_span
  power_of_t_in_every_degree
:argued: every k and every pattern of knots | (4.4.21) is true for every $k$, and so is $\det\mathbf G\ne0$: $\mathbf G^Tc=0$ gives $\sum c_\mu t^\mu=0$, and so
  $c=0$.  The inverse matrix by its cofactors solves (4.4.21) for the $N_{i,k}$, and their powers of $t$ are written in powers of $u$.
:needs: empty_span_makes_g_singular | theorem 4.4.3: the interval $[t_r,t_{r+1})$ is not empty | the span is not
  empty
:needs: polynomial_of_a_span_ends_with_it | (4.4.16): $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:meant: (4.4.17) and (4.4.19), in which both have two indices | $g^*_{\mu i}$ is the cofactor of $g_{\mu i}$: both have lost the index $i$, see
  `notation-4.4`.
:figure: both_matrices

For $t_r=0$ the power $t_r^0$ is 1.
:::
*/

/* G by (4.4.19): the derivative of order k-1-mu of omega_{i,k} at 0 is (k-1-mu)! times its coefficient of that power of x. */
static void G(matrix_g)(const struct G(span) * S, num g[])
{
    int k = S->k;
    for (int i = 0; i < k; i++) {
        num c[LARGEST_ORDER]; /* the coefficients of omega_{i,k}, by its factors x - t_m one by one */
        for (int power = 0; power < k; power++)
            c[power] = from_int(power == 0);
        for (int m = i + 1; m <= i + k - 1; m++) {
            for (int power = k - 1; power > 0; power--)
                c[power] = sub(c[power - 1], mul(S->t[m], c[power]));
            c[0] = neg(mul(S->t[m], c[0]));
        }
        for (int mu = 0; mu < k; mu++) {
            num derivative = mul(G(factorial)(k - 1 - mu), c[k - 1 - mu]);
            g[mu * k + i] = G(signed_by)(mu, mul(div(G(factorial)(mu), G(factorial)(k - 1)), derivative));
        }
    }
}

/*
In (4.4.17) the inverse of $G$ gives the B-splines in powers of $t$, and the binomial theorem turns these into powers
of $u$.  The formula is computed as it stands, with determinants over all permutations, at variable knots.

:::{claim} printed_cofactor_formula_gives_the_basis
:title: The printed coefficients from the cofactors of G are those of the B-spline
:zh: (4.4.17) 给出 B 样条基
:given: every pattern of the 2k knots around a span up to the order 4, the order 5 with simple knots and those of
  Bernstein; the different knots and $u$ variables; random patterns in the other number types
:then: $\sum_j\bar a_{ji}u^j=N_{i,k}(t)$, with $\bar a_{ji}$ by (4.4.17), and `bspline_matrix_by_marsden` has these
  entries
:method: (4.4.17) by its letter, with $G$ by (4.4.19) and its determinant and cofactors as sums over all permutations; the
  B-splines by their definition.
:degrees: 0..4 sampled 4
:scope: every pattern of the knots around a span up to order 4, the two extreme ones above
:over: t#: knots
:defines: bspline_matrix_by_marsden
:control: the cofactors transposed
:::
*/
/* The cofactor of place (row, column) as a sum over permutations. */
static num G(leibniz_cofactor)(int n, const num M[], int row, int column)
{
    num replaced[CELLS];
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            replaced[i * n + j] = j == column ? from_int(i == row) : M[i * n + j];
    return G(leibniz)(n, 0, 0, replaced);
}

CLAIM(printed_cofactor_formula_gives_the_basis)
{
    int k = T->degree + 1;
    num x[2 * LARGEST_ORDER], g[CELLS], star[CELLS], A[CELLS], u = parameter(T, "u");
    G(increasing)(T, 2 * k, x);
    for (int count = G(pattern_count)(k, 4, 2), m = 0; m < count; m++) {
        struct G(span) S = G(span_of_pattern)(k, G(which_pattern)(T, k, 4, m), x);
        num t_r = S.t[S.r], h = sub(S.t[S.r + 1], t_r);
        G(matrix_g)(&S, g);
        num det = G(leibniz)(k, 0, 0, g);
        for (int mu = 0; mu < k; mu++)
            for (int i = 0; i < k; i++)
                star[mu * k + i] = fault(T, G(leibniz_cofactor)(k, g, mu, i), G(leibniz_cofactor)(k, g, i, mu));
        G(bspline_matrix_by_marsden)(k - 1, S.t, S.r, A);
        for (int i = 0; i < k; i++) {
            num N = from_int(0);
            for (int j = 0; j < k; j++) {
                num sum = from_int(0);
                for (int mu = j; mu < k; mu++)
                    sum = add(sum, mul(mul(G(choose)(mu, j), G(power)(t_r, mu - j)), star[mu * k + i]));
                num a = mul(div(G(power)(h, j), det), sum);
                about(T, "the printed coefficient and the kernel's");
                same(T, a, A[j * k + i]);
                N = add(N, mul(a, G(power)(u, j)));
            }
            about(T, "the sum of the powers and the B-spline");
            same(T, N, G(basis_value)(&S, i, k, G(at_parameter)(&S, u)));
        }
    }
}

#if RATIONAL
/*
The $\bar a_{ji}$ are those of one span.  Behind it the B-spline is another polynomial, or 0.

:::{claim} polynomial_of_a_span_ends_with_it
:title: Outside the span the B-spline is not the polynomial of the span
:zh: 区间外 B 样条基不是该区间的多项式
:kind: counterexample
:given: $k=1$, the knots $t_i$ of $N_{0,1}$, the span $[t_0,t_1)$, and a $t$ behind it
:data: t_i = 0 1; t = 3/2
:instead: t = 1/2
:then: the polynomial of the span is $1$: by (4.4.17), by the sum $(t_1-t_0)\alpha_1(t_1-t)^0$ over the knot right of $t_0$, with $\alpha_1=1/(t_1-t_0)$, and as the
  Bernstein polynomial $B_0^0$; but $N_{0,1}(t)=0$
:result: the polynomial = 1; the sum over the knot right of t_0 = 1; B_0^0(t) = 1; N_0,1(t) = 0
:method: The three formulas at $t$; the function by the definition of the B-splines, for the interval that contains $t$.
:control: a $t$ of the span
:::
*/
CLAIM(polynomial_of_a_span_ends_with_it)
{
    num knots[2], A[1];
    int place[2] = {0, 1};
    given_points(T, "t_i", 2, 1, knots);
    num t = given(T, "t"), length = sub(knots[1], knots[0]);
    G(bspline_matrix_by_marsden)(0, knots, 0, A);
    num polynomial = G(column_value)(1, A, 0, div(sub(t, knots[0]), length));
    num alpha = div(from_int(1), length), sum = mul(mul(length, alpha), G(power)(sub(knots[1], t), 0));
    num bernstein = mul(G(choose)(0, 0), mul(G(power)(sub(from_int(1), t), 0), G(power)(t, 0)));
    num value = G(cox_de_boor)(0, knots, place, 0, compare_q(t, knots[1]) < 0 ? 0 : 1, t);
    found(T, "the polynomial", polynomial);
    found(T, "the sum over the knot right of t_0", sum);
    found(T, "B_0^0(t)", bernstein);
    found(T, "N_0,1(t)", value);
    about(T, "the polynomial of the span, and N_0,1(t)");
    same(T, polynomial, value);
    same(T, sum, value);
    same(T, bernstein, value);
}
#endif

/*
:::{statement} wang-ch4:formula-4.4.17
:title: The entries from the cofactors of G
:zh: 由 G 的代数余子式给出矩阵元素
:printed: \bar a_{ji}=\frac{(t_{r+1}-t_r)^j}{\det\mathbf G_{r,k,T}}\sum_{\mu=j}^{k-1}\binom\mu jt_r^{\mu-j}g^*_{\mu i},\quad j=0,1,\dots,k-1
:holds-by: printed_cofactor_formula_gives_the_basis marsden_step_for_every_order coefficients_of_marsden_in_every_order
  outer_functions_are_made_of_outer_ones divisors_contain_the_span
  power_of_t_in_every_degree
:confirmed-by: both_explicit_matrices_agree coefficient_matrix_is_affinely_invariant
:argued: every k and every pattern of knots | (4.4.21) is true for every $k$, and so is $\det\mathbf G\ne0$: $\mathbf G^Tc=0$ gives $\sum c_\mu t^\mu=0$, and so
  $c=0$.  The inverse matrix by its cofactors solves (4.4.21) for the $N_{i,k}$, and their powers of $t$ are written in powers of $u$.
:needs: empty_span_makes_g_singular | theorem 4.4.3: the interval $[t_r,t_{r+1})$ is not empty | the span is not
  empty
:needs: polynomial_of_a_span_ends_with_it | (4.4.16), whose coefficients they are: $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:figure: both_matrices

For $t_r=0$ the power $t_r^0$ is 1.  The entries do not change when all knots move by one number, which changes neither $u$ nor the functions, although $t_r$ stands in the formula.
:::

:::{statement} wang-ch4:thm-4.4.3-equal
:title: Two explicit matrices for the same representation
:zh: 两种显式矩阵表示
:printed: Marsden's identity gives another explicit representation of the coefficient matrix of a NURBS curve; these are two explicit matrix representations of the most general case
  (preface)
:holds-by: printed_double_sum_gives_the_basis printed_cofactor_formula_gives_the_basis
:confirmed-by: both_explicit_matrices_agree
:argued: every order and every pattern of knots | Each of the two is true for every order and every pattern of knots, by the arguments of `thm-4.4.1` and `thm-4.4.3`.
:needs: empty_span_makes_g_singular | theorem 4.4.3: the interval $[t_r,t_{r+1})$ is not empty | the span is not
  empty
:needs: polynomial_of_a_span_ends_with_it | (4.4.1), the parameter of what is represented: $t_r\le t<t_{r+1}$ | $t$ lies in the span
:figure: both_matrices

Both are computed by their letter, and each gives $N_{i,k}$ in powers of $u$, which is one polynomial; so the entries are equal.
:::

Two explicit matrices and a recursive one are now at hand.  They look nothing alike: one distinguishes cases by the
multiplicities of the knots, one does not notice them.  That they are equal is no luck, since a polynomial has one
representation in powers.

:::{claim} both_explicit_matrices_agree
:title: The matrices by divided differences, by Marsden's identity and by Cox and de Boor agree
:zh: 两种显式矩阵与 Cox–de Boor 展开一致
:given: every pattern of the 2k knots around a span up to the order 5, the knots variables; random patterns in the
  other number types
:then: `bspline_matrix_by_differences`, `bspline_matrix_by_marsden` and `bspline_matrix` give the same matrix
:method: Entry by entry.
:degrees: 0..4 sampled 6
:scope: every pattern of the knots around a span
:over: t#: knots
:control: the knot $t_{r+2}$ is moved for the second matrix
:::
*/
static void G(same_entries)(trial *T, int k, const num A[], const num B[])
{
    for (int i = 0; i < k * k; i++)
        same(T, B[i], A[i]);
}

CLAIM(both_explicit_matrices_agree)
{
    int k = T->degree + 1, all = FIELD ? 5 : 3;
    num x[2 * LARGEST_ORDER], A[CELLS], B[CELLS], C[CELLS];
    G(increasing)(T, 2 * k, x);
    for (int count = G(pattern_count)(k, all, 2), m = 0; m < count; m++) {
        struct G(span) S = G(span_of_pattern)(k, G(which_pattern)(T, k, all, m), x);
        G(bspline_matrix)(k - 1, S.t, S.r, A);
        G(bspline_matrix_by_differences)(k - 1, S.t, S.group, S.r, B);
        about(T, "by divided differences");
        G(same_entries)(T, k, A, B);
        if (T->faulty && k > 2)
            S.t[S.r + 2] = add(S.t[S.r + 2], from_int(1));
        G(bspline_matrix_by_marsden)(k - 1, S.t, S.r, C);
        about(T, "by Marsden's identity");
        G(same_entries)(T, k, A, C);
    }
}

#if RATIONAL
/*
:::{claim} both_explicit_matrices_agree_for_every_multiplicity
:title: The three matrices agree for every pattern of knots up to order 5, at rational knots
:zh: 五阶以内一切重数下三矩阵一致
:kind: decision
:given: the orders up to $K$, all $2^{2k-2}$ patterns of the $2k$ knots around a span, one increasing sequence of
  rational knots for each; the order $L$ with $m$ patterns, from simple knots to $k$-fold ones
:data: K = 5; L = 8; m = 6
:then: the three kernels give the same matrix
:method: All entries are compared.
:scope: the stated knots
:control: simple knots for the third matrix in the place of the pattern
:::
*/
CLAIM(both_explicit_matrices_agree_for_every_multiplicity)
{
    num x[2 * LARGEST_ORDER], A[CELLS], B[CELLS], C[CELLS];
    int highest = given_whole(T, "K"), large = given_whole(T, "L"), chosen = given_whole(T, "m");
    for (int k = 1; k <= large && k <= LARGEST_ORDER; k = k == highest ? large : k + 1) {
        int all = G(patterns)(k), count = k <= highest ? all : chosen;
        for (int n = 0; n < count; n++) {
            int m = k <= highest ? n : (int)((long)n * (all - 1) / (count - 1));
            for (int a = 0; a < 2 * k; a++)
                x[a] = a == 0 ? from_ratio(pick(T, -9, 9), 2) : add(x[a - 1], from_ratio(pick(T, 1, 7), 2));
            struct G(span) S = G(span_of_pattern)(k, m, x);
            G(bspline_matrix)(k - 1, S.t, S.r, A);
            G(bspline_matrix_by_differences)(k - 1, S.t, S.group, S.r, B);
            S = fault(T, S, G(span_of_pattern)(k, all - 1, x));
            G(bspline_matrix_by_marsden)(k - 1, S.t, S.r, C);
            int equal = 1;
            for (int i = 0; i < k * k; i++)
                equal &= equal_q(A[i], B[i]) && equal_q(A[i], C[i]);
            agree(T, equal);
            if (!equal)
                return;
        }
    }
}
#endif

/*
## Why G is invertible

:::{statement} wang-ch4:thm-4.4.3-step-det
:title: The determinant of G is not 0
:zh: det G ≠ 0
:printed: \det\mathbf G_{r,k,T}\ne0
:holds-by: marsden_determinant_is_product marsden_step_for_every_order coefficients_of_marsden_in_every_order
  outer_functions_are_made_of_outer_ones divisors_contain_the_span
:confirmed-by: marsden_determinant_is_positive
:argued: every k | $\mathbf G^Tc=0$ gives $\sum c_\mu t^\mu=0$ by (4.4.21), which is true for every $k$, and so $c=0$.
:needs: empty_span_makes_g_singular | theorem 4.4.3: the interval $[t_r,t_{r+1})$ is not empty | the span is not
  empty
:figure: both_matrices
:::

The determinant of $G$ can be written as a product.  Only differences of a knot on the left and a knot on the right of
the span occur, and of these only those that one B-spline sees; so coincident knots do no harm, and an empty span
does.

:::{claim} marsden_determinant_is_product
:title: The determinant of G is a product of differences of knots
:zh: det G 的乘积公式
:given: orders $k$, knots variables
:then: $\det G=\prod(t_b-t_a)/\prod_j\binom{k-1}j$ over the pairs $a\le r<b$ with $b-a\le k-1$, as `marsden_determinant`
  computes it
:method: The determinant of $G$ by (4.4.19), by Bird's algorithm and, up to $k=4$, over all permutations, too.  It and the product are polynomials of the
  knots, so that they agree for coincident ones, too.  On a span that is not empty no factor is 0: $t_a\le t_r<t_{r+1}\le t_b$.
:degrees: 0..4 sampled 7
:over: t#: knots
:defines: marsden_determinant
:control: the pairs with $b-a\le k$
:::
*/
CLAIM(marsden_determinant_is_product)
{
    int k = T->degree + 1;
    struct G(span) S = G(simple_span)(T, k);
    num g[CELLS], product = from_int(1);
    G(matrix_g)(&S, g);
    for (int a = 0; a <= S.r; a++)
        for (int b = S.r + 1; b < 2 * k; b++)
            if (b - a <= fault(T, k - 1, k))
                product = mul(product, sub(S.t[b], S.t[a]));
    for (int j = 0; j < k; j++)
        product = div(product, G(choose)(k - 1, j));
    num det = G(determinant)(k, g);
    about(T, "determinant and product");
    same(T, det, product);
    about(T, "determinant and kernel");
    same(T, det, G(marsden_determinant)(k - 1, S.t, S.r));
    about(T, "two determinants");
    if (k <= 4)
        same(T, det, G(leibniz)(k, 0, 0, g));
}

#if FIELD
/*
:::{claim} marsden_determinant_is_positive
:title: On a span that is not empty the determinant is positive, whatever the multiplicities
:zh: 非空区间上 det G>0
:given: every pattern of the 2k knots around a span up to the order 4, the steps from each different knot to the next
  positive variables
:harmless: each different knot | they are the knots of the pattern
:then: $\det G>0$
:method: Written in the steps all coefficients are positive, and there is one at least.  For the order 5 there is `marsden_determinant_is_product`, where
  every factor is positive.
:types: field
:degrees: 0..3
:over: x: -
:control: the determinant with its first two columns exchanged
:::
*/
CLAIM(marsden_determinant_is_positive)
{
    int k = T->degree + 1;
    num x[2 * LARGEST_ORDER], g[CELLS];
    x[0] = unknown(T, "x", 0);
    for (int m = 1; m < 2 * k; m++)
        x[m] = add(x[m - 1], positive(T, "h", m));
    for (int m = 0; m < G(patterns)(k); m++) {
        struct G(span) S = G(span_of_pattern)(k, m, x);
        G(marsden_matrix)(k - 1, S.t, S.r, g);
        for (int j = 0; T->faulty && k > 1 && j < k; j++) {
            num first = g[j * k];
            g[j * k] = g[j * k + 1];
            g[j * k + 1] = first;
        }
        num det = G(determinant)(k, g);
        nonnegative(T, det);
        agree(T, !is_zero_f(det));
    }
}
#endif

#if RATIONAL
/*
:::{claim} empty_span_makes_g_singular
:title: On an empty span the determinant of G is 0
:zh: 空区间上 det G=0
:kind: counterexample
:given: $k=2$, four knots $t_i$, $t_r=t_{r+1}$ in the middle
:data: t_i = 0 1 1 2
:instead: t_i = 0 1 3/2 2
:then: the columns of $G$ are equal and $\det G=0$, so (4.4.17) divides by 0
:result: rows of G = (1,1) (1,1); det G = 0
:method: The determinant is computed; that it is not 0 is what is compared.
:control: simple knots
:::
*/
CLAIM(empty_span_makes_g_singular)
{
    num t[4], g[4];
    given_points(T, "t_i", 4, 1, t);
    G(marsden_matrix)(1, t, 1, g);
    num determinant = G(determinant)(2, g);
    found_points(T, "rows of G", 2, 2, g);
    found(T, "det G", determinant);
    about(T, "det G is not 0");
    refute(T, is_zero_q(determinant));
}
#endif

/*
:::{statement} wang-ch4:thm-4.4.3-step-det-reason
:title: The reason given: linear independence of the basis
:zh: 由线性无关性推出 det G ≠ 0
:printed: by the linear independence of the basis functions $\det\mathbf G_{r,k,T}\ne0$
:holds-by: singular_g_makes_powers_dependent marsden_step_for_every_order coefficients_of_marsden_in_every_order
  outer_functions_are_made_of_outer_ones divisors_contain_the_span
:argued: every k and every pattern of knots | (4.4.21) is true for every $k$ and every pattern of knots.  Applied to a vector $c$ it is $\sum c_\mu t^\mu=\sum_i(\mathbf G^Tc)_iN_{i,k}(t)$; so
  $\mathbf G^Tc=0$ makes the polynomial vanish on the span, and $c=0$, since the powers are independent.
:meant: (4.4.21), of which the line is said and which has a basis on either side; the powers are called a basis (幂基) in definition 4.4.1 | The basis functions are those of
  (4.4.21), the powers with the B-splines.
:reading: singular_g_makes_powers_dependent | the basis functions are those on both sides of (4.4.21), and the independence of the powers is what makes $\det\mathbf G\ne0$
:reading: independent_functions_do_not_suffice | the basis functions are the $N_{i,k}$ alone: that $k$ functions are independent does not say that $k$ combinations of them are
:needs: empty_span_makes_g_singular | theorem 4.4.3: the interval $[t_r,t_{r+1})$ is not empty | the span is not
  empty

The word (基函数) stands in this line only.
:::

The rows of $G$ express the powers by the B-splines, so a dependence of the rows is one of the powers; that the B-splines are
independent does not enter.

:::{claim} singular_g_makes_powers_dependent
:title: A combination of the rows of G is the combination of the powers
:zh: G 的行组合对应幂函数组合
:given: orders $k$, every pattern of the knots up to order 4 and the two extreme ones above, $t$ and numbers $c_0,\dots,c_{k-1}$, all variables
:then: $\sum_\mu c_\mu t^\mu=\sum_i(G^Tc)_iN_{i,k}(t)$; so $G^Tc=0$ makes the polynomial vanish, and $c=0$
:method: Both sides at a variable $t$.
:degrees: 0..5 sampled 7
:scope: every pattern of the knots around a span up to order 4, the two extreme ones above
:over: t#: knots; c#: coefficients
:control: $G$ in the place of its transpose
:::
*/
CLAIM(singular_g_makes_powers_dependent)
{
    int k = T->degree + 1;
    num knots[2 * LARGEST_ORDER];
    G(increasing)(T, 2 * k, knots);
    for (int count = G(pattern_count)(k, 4, 2), number = 0; number < count; number++) {
        struct G(span) S = G(span_of_pattern)(k, G(which_pattern)(T, k, 4, number), knots);
        num g[CELLS], c[LARGEST_ORDER], t = parameter(T, "t"), left = from_int(0), right = from_int(0);
        G(matrix_g)(&S, g);
        for (int mu = 0; mu < k; mu++) {
            c[mu] = unknown(T, "c", mu);
            left = add(left, mul(c[mu], G(power)(t, mu)));
        }
        for (int i = 0; i < k; i++) {
            num sum = from_int(0);
            for (int mu = 0; mu < k; mu++)
                sum = add(sum, mul(fault(T, g[mu * k + i], g[i * k + mu]), c[mu]));
            right = add(right, mul(sum, G(basis_value)(&S, i, k, t)));
        }
        same(T, left, right);
    }
}

#if RATIONAL
/*
:::{claim} independent_functions_do_not_suffice
:title: Combinations of independent functions may be dependent
:zh: 仅由基函数无关推不出矩阵可逆
:kind: counterexample
:given: $k=2$ and a span with two independent functions $N_{r-1}$, $N_r$, such as $1-t$ and $t$; the rows of $M$ are
  the coefficients of two combinations $f_0=f_1=N_{r-1}+N_r$ of them, in the places of $1$ and $t$
:data: M = (1,1) (1,1)
:instead: M = (1,1) (0,1)
:then: $(f_0,f_1)=(N_{r-1},N_r)M^T$ with $\det M=0$
:result: det M = 0
:method: The shape is that of (4.4.21), without independent functions on the left.  That the determinant is not 0 is
  compared.
:control: $f_1=t$
:::
*/
CLAIM(independent_functions_do_not_suffice)
{
    num M[4];
    given_points(T, "M", 2, 2, M);
    num determinant = G(determinant)(2, M);
    found(T, "det M", determinant);
    about(T, "det M is not 0");
    refute(T, is_zero_q(determinant));
}
#endif

/*
:::{statement} wang-ch4:thm-4.4.3-step-inverse
:title: The B-splines in powers of t
:zh: B 样条基按 t 的幂展开
:printed: N_{i,k}(t)=\sum_{\mu=0}^{k-1}g^*_{\mu i}t^\mu/\det\mathbf G_{r,k,T}
:holds-by: cofactors_give_powers_of_t marsden_step_for_every_order coefficients_of_marsden_in_every_order
  outer_functions_are_made_of_outer_ones divisors_contain_the_span
:argued: every k and every pattern of knots | (4.4.21) is true for every $k$, and so is $\det\mathbf G\ne0$: $\mathbf G^Tc=0$ gives $\sum c_\mu t^\mu=0$, and so
  $c=0$.  The inverse matrix by its cofactors solves (4.4.21) for the $N_{i,k}$.
:needs: empty_span_makes_g_singular | theorem 4.4.3: the interval $[t_r,t_{r+1})$ is not empty | the span is not
  empty
:needs: polynomial_of_a_span_ends_with_it | the proof of theorem 4.4.3: $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:figure: both_matrices
:::

With $\det G\ne0$ the last two steps are the inverse matrix by cofactors and the binomial theorem.

:::{claim} cofactors_give_powers_of_t
:title: The cofactors give the B-splines in powers of t
:zh: 代数余子式给出 B 样条基
:given: orders $k$, every pattern of the knots up to order 4 and the two extreme ones above, knots and $t$ variables
:then: $\det G\,N_{i,k}(t)=\sum_\mu g^*_{\mu i}t^\mu$
:method: Determinants and cofactors of the kernels; the B-splines by definition.
:degrees: 0..4 sampled 7
:scope: every pattern of the knots around a span up to order 4, the two extreme ones above
:over: t#: knots
:control: the cofactors transposed
:::
*/
CLAIM(cofactors_give_powers_of_t)
{
    int k = T->degree + 1;
    num knots[2 * LARGEST_ORDER];
    G(increasing)(T, 2 * k, knots);
    for (int count = G(pattern_count)(k, 4, 2), number = 0; number < count; number++) {
        struct G(span) S = G(span_of_pattern)(k, G(which_pattern)(T, k, 4, number), knots);
        num g[CELLS], t = parameter(T, "t");
        G(matrix_g)(&S, g);
        num det = G(determinant)(k, g);
        for (int i = 0; i < k; i++) {
            num sum = from_int(0);
            for (int mu = 0; mu < k; mu++) {
                num star = fault(T, G(cofactor)(k, g, mu, i), G(cofactor)(k, g, i, mu));
                sum = add(sum, mul(star, G(power)(t, mu)));
            }
            /* det G N_i,k(t) = Σ_μ g*_μi t^μ */
            same(T, sum, mul(det, G(basis_value)(&S, i, k, t)));
        }
    }
}

/*
:::{statement} wang-ch4:thm-4.4.3-step-power
:title: The powers of t in powers of u
:zh: t 的幂按 u 的幂展开
:printed: t^\mu=\sum_{j=0}^\mu\binom\mu j(t_{r+1}-t_r)^jt_r^{\mu-j}u^j,\quad\mu=0,1,\dots,k-1
:holds-by: power_of_t_in_every_degree
:confirmed-by: power_of_t_in_powers_of_u
:needs: empty_span_has_no_parameter | theorem 4.4.3: the interval $[t_r,t_{r+1})$ is not empty | the span is not empty

$t_r^0=1$, also for $t_r=0$.
:::

:::{claim} power_of_t_in_powers_of_u
:title: The binomial theorem for t = t_r + (t_{r+1} - t_r) u
:zh: t 的幂的二项展开
:given: $\mu=0,\dots,k-1$, the two knots and $u$ variables
:then: $t^\mu=\sum_j\binom\mu j(t_{r+1}-t_r)^jt_r^{\mu-j}u^j$
:method: Both sides at a variable $u$, also with $t_r=0$, where $t_r^0=1$.
:degrees: 0..8 sampled 12
:over: t#: knots
:control: the roles of the two knots exchanged
:::
*/
CLAIM(power_of_t_in_powers_of_u)
{
    int mu = T->degree;
    num t[2], u = parameter(T, "u");
    G(increasing)(T, 2, t);
    for (int zero = 0; zero <= 1; zero++) {
        if (zero)
            t[0] = from_int(0);
        num at = add(t[0], mul(u, sub(t[1], t[0]))), sum = from_int(0);
        int a = fault(T, 0, 1), b = 1 - a;
        for (int j = 0; j <= mu; j++) {
            num factor = mul(G(power)(sub(t[b], t[a]), j), G(power)(t[a], mu - j));
            sum = add(sum, mul(G(choose)(mu, j), mul(factor, G(power)(u, j))));
        }
        /* t^μ = Σ_j C(μ, j) (t_r+1 - t_r)^j t_r^(μ-j) u^j */
        same(T, G(power)(at, mu), sum);
    }
}

#include "chapters/judge/claims_off.h"
