/*
# The coefficient matrix of a span (系数矩阵)

On one span a B-spline curve is a polynomial curve, and a polynomial can be written in powers.  The matrix that leads
from the control points to the coefficients of the powers is the coefficient matrix of the span.  It depends on the
knots only.  This section defines it, and decides the first of the two explicit formulas for it: that by divided
differences.

In this and the next sections the order is $k$, the span $[t_r,t_{r+1})$ is not empty, the functions on it are
$N_{i,k}$, $i=r-k+1,\dots,r$, and $u=(t-t_r)/(t_{r+1}-t_r)$.  The degree that a claim names is $k-1$.
*/
#include "chapters/nurbs/spans.h"

#include "chapters/judge/claims_on.h"

enum { CELLS = LARGEST_ORDER * LARGEST_ORDER };

/*
:::{statement} wang-ch4:formula-4.4.1
:title: The parameter of the span
:zh: 规范化参数变换
:printed: u=(t-t_r)/(t_{r+1}-t_r),\quad t_r\le t<t_{r+1}
:holds-by: span_parameter_is_a_bijection
:needs: empty_span_has_no_parameter | the line itself: $t_r\le t<t_{r+1}$, which no $t$ satisfies otherwise; and definition 4.4.1, by the word nonempty | the span
  $[t_r,t_{r+1})$ is not empty
:figure: matrices_of_merging_knots
:::

:::{claim} span_parameter_is_a_bijection
:title: u runs from 0 to 1 as t runs through the span
:zh: 参数变换为双射
:given: any two different knots $t_r,t_{r+1}$, any $s$
:then: $t=t_r+s(t_{r+1}-t_r)$ has the parameter $u=s$; so $u$ is 0 at $t_r$, 1 at $t_{r+1}$ and between them in between
:method: The formula at the $t$ of a variable $s$, which gives $s$ again: of two affine maps of a line one then undoes the other.
:over: t#: knots; s: u
:control: the roles of the two knots exchanged
:::
*/
CLAIM(span_parameter_is_a_bijection)
{
    num t[2], s = parameter(T, "s");
    G(increasing)(T, 2, t);
    int a = fault(T, 0, 1), b = 1 - a;
    num at = add(t[0], mul(s, sub(t[1], t[0])));
    same(T, div(sub(at, t[a]), sub(t[b], t[a])), s);
    same(T, div(sub(t[0], t[a]), sub(t[b], t[a])), from_int(0));
    same(T, div(sub(t[1], t[a]), sub(t[b], t[a])), from_int(1));
}

#if RATIONAL
/*
:::{claim} empty_span_has_no_parameter
:title: On an empty span the formula of the parameter divides by 0
:zh: 空区间上无参数变换
:kind: counterexample
:given: two knots $t_r=t_{r+1}$
:data: t_r = 1; t_r+1 = 1
:instead: t_r+1 = 2
:then: no $u$ has $t_r+u(t_{r+1}-t_r)\ne t_r$; the length by which (4.4.1) divides is 0
:result: length of the span = 0
:method: The length is computed; that it is not 0 is what is compared.
:control: two different knots
:::
*/
CLAIM(empty_span_has_no_parameter)
{
    num left = given(T, "t_r"), right = given(T, "t_r+1"), length = sub(right, left);
    found(T, "length of the span", length);
    about(T, "the length of the span is not 0");
    refute(T, is_zero_q(length));
}
#endif

/*
:::{statement} wang-ch4:def-4.4.1
:title: The representation in powers and the coefficient matrix
:zh: 幂基表示与系数矩阵
:printed: if, for a segment of the NURBS curve (4.1.1), in homogeneous coordinates, on the nonempty interval $[t_r,t_{r+1})$, the normalised parameter (4.4.1) is introduced, so
  that it becomes (4.4.2), then (4.4.2) is called the representation of the curve (4.1.1) on $[t_r,t_{r+1})$ in the power basis, and (4.4.3) its coefficient matrix
:definition: yes
:checked-by: matrix_holds_the_powers_of_the_basis
:argued: every order and every pattern of knots | By the recursion every $N_{i,k}$ is a polynomial of degree $k-1$ in $t$ on the span, whatever knots coincide, and so one in $u$; its
  coefficients are a column of the matrix.
:confirmed-by: coefficient_matrix_is_affinely_invariant
:argued: its being the only one | The points are arbitrary, and the powers of $u$ independent.
:needs: empty_span_has_no_parameter | definition 4.4.1: the interval $[t_r,t_{r+1})$ is not empty | the span is not empty
:needs: polynomial_of_a_span_ends_with_it | (4.4.1): $t_r\le t<t_{r+1}$ | $t$ lies in the span
:figure: matrices_of_merging_knots
:::
*/

/*
A kernel computes the matrix by the recursion, with polynomials in $u$ in the place of numbers.  It is the reference
for all formulas of these sections, so it is itself compared with the definition of the B-splines first, for every
pattern of coincident knots.

:::{claim} matrix_holds_the_powers_of_the_basis
:title: Column i of the matrix has the coefficients of N_{i,k} in the powers of u
:zh: 矩阵各列为基函数的幂系数
:given: every pattern of the 2k knots around a span up to the order 4, the different knots variables; for greater
  orders in the field the two extreme patterns, and random patterns in the other number types
:then: $\sum_ja_{ji}u^j=N_{i,k}(t_r+u(t_{r+1}-t_r))$ with the matrix of `bspline_matrix`, for all $i$ and any $u$, with the polynomials of the span for the $N_{i,k}$
:method: The kernel multiplies polynomials; the other side is the recursion of Cox and de Boor at a variable $u$, with
  the rule $0/0=0$ decided by the pattern.
:degrees: 0..5 sampled 7
:scope: every pattern of the knots around a span up to order 4, the two extreme ones above
:over: t#: knots
:defines: bspline_matrix
:control: the matrix of the span before
:::
*/
CLAIM(matrix_holds_the_powers_of_the_basis)
{
    int k = T->degree + 1;
    num x[2 * LARGEST_ORDER], A[CELLS], u = parameter(T, "u");
    G(increasing)(T, 2 * k, x);
    for (int count = G(pattern_count)(k, 4, 2), m = 0; m < count; m++) {
        struct G(span) S = G(span_of_pattern)(k, G(which_pattern)(T, k, 4, m), x);
        int shift = fault(T, 0, k > 1 && S.group[S.r - 1] != S.group[S.r]);
        G(bspline_matrix)(k - 1, S.t, S.r - shift, A);
        for (int i = 0; i < k; i++)
            /* Σ_j a_ji u^j = N_i,k(t_r + u (t_r+1 - t_r)) */
            same(T, G(column_value)(k, A, i, u), G(basis_value)(&S, i, k, G(at_parameter)(&S, u)));
    }
}

/*
Two simple properties help later.  The parameter $u$ does not notice an affine map of the knots, so equidistant knots
may be taken as integers; and that the B-splines have the sum 1 is a property of the rows.

:::{claim} coefficient_matrix_is_affinely_invariant
:title: The knots at + b have the same matrix
:zh: 系数矩阵的仿射不变性
:given: orders $k$, simple knots $t_i$, numbers $a>0$ and $b$, all variables
:then: the matrix of the knots $a\,t_i+b$ is that of the $t_i$
:method: The two matrices of the kernel.
:degrees: 0..5 sampled 7
:scope: simple knots
:where: the factor of the knots is positive
:over: t#: knots; a: factor; b: shift
:control: the first inner knot is not moved
:::
*/
CLAIM(coefficient_matrix_is_affinely_invariant)
{
    int k = T->degree + 1;
    struct G(span) S = G(simple_span)(T, k);
    num A[CELLS], B[CELLS], moved[2 * LARGEST_ORDER], a = positive(T, "a", 0), b = unknown(T, "b", 0);
    for (int m = 0; m < 2 * k; m++)
        moved[m] = fault(T, add(mul(a, S.t[m]), b), m == 1 ? S.t[m] : add(mul(a, S.t[m]), b));
    G(bspline_matrix)(k - 1, S.t, S.r, A);
    G(bspline_matrix)(k - 1, moved, S.r, B);
    for (int m = 0; m < k * k; m++)
        same(T, B[m], A[m]);
}

/*
:::{statement} wang-ch4:formula-4.4.2
:title: The curve of a span in powers
:zh: 曲线段的幂基表示
:printed: \mathbf r^*(u)=\sum_{i=r-k+1}^rN_{i,k}(t)\mathbf r_i=(1,u,\dots,u^{k-1})\,\mathbf A_{r,k,T}\,(\mathbf
  r_{r-k+1},\mathbf r_{r-k+2},\dots,\mathbf r_r)^T,\quad 0\le u<1
:holds-by: matrix_gives_homogeneous_curve
:argued: every k and every pattern of knots | By the recursion every $N_{i,k}$ is a polynomial of degree $k-1$ in $t$ on the span, whatever knots coincide, and so one in $u$; its
  coefficients are a column of the matrix.
:confirmed-by: quotient_of_the_matrix_sums_is_the_affine_curve
:needs: empty_span_has_no_parameter | definition 4.4.1: the interval $[t_r,t_{r+1})$ is not empty | the span is not empty
:needs: polynomial_of_a_span_ends_with_it | the line itself: $0\le u<1$ | $t$ lies in the span
:meant: definition 4.4.1: the NURBS curve (4.1.1), in homogeneous coordinates | The $\mathbf r_i$ are the
  $\tilde{\mathbf r}_i=(w_i\mathbf r_i,w_i)$ of (4.1.1); only the tilde is left out.
:reading: affine_points_need_the_weights | with the affine points $\mathbf r_i$ and the affine curve $\mathbf r(t)$, which have these letters in (4.1.2): where the weights
  of the span differ it may be another curve
:figure: matrix_and_weights

The affine curve is the quotient of $(1,\dots,u^{k-1})\,\mathbf A\,(w_i\mathbf r_i)^T$ and $(1,\dots,u^{k-1})\,\mathbf A\,(w_i)^T$, where the second is not 0:
`quotient_of_the_matrix_sums_is_the_affine_curve`.
:::

:::{claim} matrix_gives_homogeneous_curve
:title: The matrix applied to homogeneous points gives the homogeneous curve
:zh: 齐次坐标下的矩阵表示
:given: orders $k$, every pattern of the knots up to order 4 and the two extreme ones above, points and weights variables, $u$ variable
:then: $(1,\dots,u^{k-1})A\,(\tilde r_{r-k+1},\dots,\tilde r_r)^T=\sum_iN_{i,k}\tilde r_i$ for $\tilde r_i=(w_ir_i,w_i)$
:method: The sum of all $u^ja_{ji}\tilde r_i$, against the B-splines by the recursion of Cox and de Boor.  A coordinate
  is any coordinate, so one suffices beside the weight.
:degrees: 0..4 sampled 7
:scope: every pattern of the knots around a span up to order 4, the two extreme ones above
:over: t#: knots; x#: points
:control: the last weight left out of $w_ir_i$
:::
*/
/* The homogeneous curve of every pattern by the matrix and by the definition; its two coordinates are compared, or the quotient of them. */
static void G(compare_curve_of_span)(trial *T, int affine)
{
    int k = T->degree + 1;
    num knots[2 * LARGEST_ORDER];
    G(increasing)(T, 2 * k, knots);
    for (int count = G(pattern_count)(k, 4, 2), number = 0; number < count; number++) {
        struct G(span) S = G(span_of_pattern)(k, G(which_pattern)(T, k, 4, number), knots);
        num A[CELLS], u = parameter(T, "u"), t = G(at_parameter)(&S, u), left[2], right[2];
        num x[LARGEST_ORDER], w[LARGEST_ORDER];
        G(bspline_matrix)(k - 1, S.t, S.r, A);
        left[0] = left[1] = right[0] = right[1] = from_int(0);
        for (int i = 0; i < k; i++) {
            x[i] = unknown(T, "x", i);
            w[i] = positive(T, "w", i);
            num N = G(basis_value)(&S, i, k, t);
            right[0] = add(right[0], mul(N, mul(w[i], x[i])));
            right[1] = add(right[1], mul(N, w[i]));
        }
        for (int j = 0; j < k; j++)
            for (int i = 0; i < k; i++) {
                num share = mul(G(power)(u, j), A[j * k + i]), weight = fault(T, w[i], i == k - 1 ? from_int(1) : w[i]);
                left[0] = add(left[0], mul(share, mul(weight, x[i])));
                left[1] = add(left[1], mul(share, w[i]));
            }
        if (affine) {
            same(T, div(left[0], left[1]), div(right[0], right[1]));
        } else {
            same(T, left[0], right[0]);
            same(T, left[1], right[1]);
        }
    }
}

CLAIM(matrix_gives_homogeneous_curve) { G(compare_curve_of_span)(T, 0); }

/*
:::{claim} quotient_of_the_matrix_sums_is_the_affine_curve
:title: The quotient of what the matrix gives for the two coordinates is the affine curve
:zh: 两个齐次坐标之商为仿射曲线
:given: orders $k$, every pattern of the knots up to order 4 and the two extreme ones above, points and weights variables, $u$ variable
:then: $(1,\dots,u^{k-1})A\,(w_ir_i)^T\big/(1,\dots,u^{k-1})A\,(w_i)^T=\sum N_{i,k}w_ir_i\big/\sum N_{i,k}w_i$
:method: As in `matrix_gives_homogeneous_curve`, with the quotients of both sides.
:degrees: 0..4 sampled 7
:scope: every pattern of the knots around a span up to order 4, the two extreme ones above
:over: t#: knots; x#: points
:where: $w(t)\ne0$
:control: the last weight left out of the numerator
:::
*/
CLAIM(quotient_of_the_matrix_sums_is_the_affine_curve) { G(compare_curve_of_span)(T, 1); }

#if RATIONAL
/*
An affine point of a curve with different weights is a mean of the affine control points, too, but with quotients of polynomials as its shares, and
the matrix gives polynomials.  One has to apply it in homogeneous coordinates and to divide at the end.

:::{claim} affine_points_need_the_weights
:title: Applied to affine points the matrix does not give the affine curve
:zh: 对仿射控制顶点须计入权因子
:kind: counterexample
:given: $k=2$, two affine points $r_i$ of one coordinate with the weights $w_i$, the span in the middle of the knots
  $t_i$; $u$
:data: t_i = -1 0 1 2; r_i = 0 1; w_i = 1 2; u = 1/2
:instead: w_i = 1 1
:then: the matrix applied to the affine points does not give the point of the affine curve
:result: the matrix applied to the affine points = 1/2; the affine curve = 2/3
:method: Both by exact arithmetic.
:control: equal weights
:::
*/
CLAIM(affine_points_need_the_weights)
{
    num knots[4], r[2], w[2], A[4], sum = from_int(0), above = from_int(0), below = from_int(0);
    given_points(T, "t_i", 4, 1, knots);
    given_points(T, "r_i", 2, 1, r);
    given_points(T, "w_i", 2, 1, w);
    num u = given(T, "u");
    G(bspline_matrix)(1, knots, 1, A);
    for (int i = 0; i < 2; i++) {
        num N = G(column_value)(2, A, i, u);
        sum = add(sum, mul(N, r[i]));
        above = add(above, mul(N, mul(w[i], r[i])));
        below = add(below, mul(N, w[i]));
    }
    num curve = div(above, below);
    found(T, "the matrix applied to the affine points", sum);
    found(T, "the affine curve", curve);
    about(T, "the matrix applied to the affine points, and the affine curve (4.1.2)");
    same(T, sum, curve);
}
#endif

/*
:::{statement} wang-ch4:formula-4.4.3
:title: The rows and columns of the coefficient matrix
:zh: 系数矩阵的行列标号
:printed: \mathbf A_{r,k,T}=(a_{j,i})_{k\times k}=\begin{pmatrix}a_{0,r-k+1}&a_{0,r-k+2}&\dots&a_{0,r}\\a_{1,r-k+1}&a_{1,r-k+2}&\dots&a_{1,r}\\
  \dots&\dots&\dots&\dots\\a_{k-1,r-k+1}&a_{k-1,r-k+2}&\dots&a_{k-1,r}\end{pmatrix}
:definition: yes
:checked-by: matrix_holds_the_powers_of_the_basis
:argued: every k and every pattern of knots | By the recursion every $N_{i,k}$ is a polynomial of degree $k-1$ in $t$ on the span, whatever knots coincide, and so one in $u$; its
  coefficients are a column of the matrix.
:confirmed-by: coefficient_rows_have_fixed_sums
:needs: empty_span_has_no_parameter | definition 4.4.1: the interval $[t_r,t_{r+1})$ is not empty | the span is not empty
:needs: polynomial_of_a_span_ends_with_it | (4.4.2), whose matrix it is: $0\le u<1$ | $t$ lies in the span
:figure: matrices_of_merging_knots

Row $j$ belongs to $u^j$, column $i$ to $N_{i,k}$.
:::

:::{claim} coefficient_rows_have_fixed_sums
:title: The entries of row 0 have the sum 1, those of every other row the sum 0
:zh: 系数矩阵各行之和
:given: orders $k$, simple knots, variables
:then: $\sum_ia_{0,i}=1$ and $\sum_ia_{j,i}=0$ for $j\ge1$: the $N_{i,k}$ have the sum 1
:method: The sums of the entries of the kernel.
:degrees: 0..5 sampled 7
:scope: simple knots
:over: t#: knots
:control: the last column left out
:::
*/
CLAIM(coefficient_rows_have_fixed_sums)
{
    int k = T->degree + 1;
    struct G(span) S = G(simple_span)(T, k);
    num A[CELLS];
    G(bspline_matrix)(k - 1, S.t, S.r, A);
    for (int j = 0; j < k; j++) {
        num sum = from_int(0);
        for (int i = 0; i < fault(T, k, k - 1); i++)
            sum = add(sum, A[j * k + i]);
        same(T, sum, from_int(j == 0));
    }
}

/*
## By divided differences (theorem 4.4.1)

A B-spline of order $k$ is a divided difference of order $k$,

$$N_{i,k}(t)=(t_{i+k}-t_i)\,[t_i,\dots,t_{i+k}](x-t)_+^{k-1},$$

where $(x-t)_+$ is $x-t$ for $x>t$ and 0 otherwise.  Written out with the weights $\alpha$ of the last section only the
knots right of $t$ are left, and these are the knots right of $t_r$.

A column of the matrix depends on the $k+1$ knots of its own function and on the place of the span among them, on
nothing else.  There are $k\,2^{k-1}$ such cases; the claims go through all of them up to the order 5 with variables for
the different knots.  So they settle every multiplicity of the knots around a span.

:::{statement} wang-ch4:formula-4.4.10
:title: The knots of one function grouped by their values
:zh: 单个基函数的节点分组
:printed: suppose that the B-spline $N_{i,k}(t)$ of order $k$ is defined on the knot vector $T_i=\{t_i,t_{i+1},\dots,t_{i+k}\}$, that is $\tau_1(T_i)$ taken $l_1(T_i)$ times, …,
  $\tau_{d(T_i)}(T_i)$ taken $l_{d(T_i)}(T_i)$ times, where $l_a(T_i)>0$, $q=1,2,\dots,d(T_i)$; $l_1(T_i)+l_2(T_i)+\dots+l_{d(T_i)}(T_i)=k+1$,
  $\tau_1(T_i)<\tau_2(T_i)<\dots<\tau_{d(T_i)}(T_i)$
:definition: yes
:checked-by: compositions_are_all_multiplicities
:meant: the range $q=1,2,\dots,d(T_i)$ behind it | $l_q(T_i)>0$, where $l_a$ is printed, see `notation-4.4`.
:figure: matrices_of_merging_knots

For $d(T_i)=1$ the knots are all equal, and $N_{i,k}$ is 0; of the functions of a span that is not empty none has such knots.  In the copy at hand a point stands between the
indices of $N$, where all other places have a comma.
:::

:::{statement} wang-ch4:formula-4.4.11
:title: On a span a B-spline is a polynomial of u
:zh: B 样条基在区间上为 u 的多项式
:printed: for $i=r-k+1,r-k+2,\dots,r$ there is $N_{i,k}(t)=N_{i,k}^*(u)=\sum_{j=0}^{k-1}a_{ji}u^j$, $u=(t-t_r)/(t_{r+1}-t_r)\in[0,1)$, $t\in[t_r,t_{r+1})$
:holds-by: printed_double_sum_gives_the_basis
:argued: every k | Summed over the $\tau_\lambda>t_r$ alone, the lines of the proof are true for every $k$ (`thm-4.4.1-step-1`, `thm-4.4.1-step-2`, `thm-4.4.1-step-expansion`,
  `thm-4.4.1-step-collect`).
:needs: empty_span_has_no_parameter | theorem 4.4.1: the interval $[t_r,t_{r+1})$ is not empty | the span is not
  empty
:needs: polynomial_of_a_span_ends_with_it | the line itself: $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:figure: both_matrices
:::
*/

/*
:::{claim} printed_double_sum_gives_the_basis
:title: The printed coefficients are those of the B-spline
:zh: (4.4.12) 的二重和给出 B 样条基
:given: every pattern of the $k+1$ knots of a function and every span among them, the different knots and $u$ variables;
  random patterns for greater $k$
:then: $\sum_ja_{ji}u^j=N_{i,k}(t)$, with $a_{ji}$ by (4.4.12), limits and all, and $\alpha$ from the cofactors (4.4.9)
:method: The double sum by its letter, against the recursion of Cox and de Boor.
:degrees: 0..4 sampled 5
:scope: every multiplicity of the knots of a function
:over: t#: knots
:control: the upper limit one less for double knots and more
:::
*/
/* Formula (4.4.12) by its letter, i = 0.  `short_by` shortens the inner sum where l > 1. */
static num G(printed_coefficient)(const struct G(span) * S, const struct G(nodes) * n, num alpha[][LARGEST_ORDER + 1],
                                  int j, int short_by)
{
    int k = S->k;
    num sum = from_int(0), t_r = S->t[S->r];
    for (int lambda = 0; lambda < n->d; lambda++) {
        if (!n->right[lambda])
            continue;
        int l = n->l[lambda], limit = k - 1 - (j > k - l ? j : k - l);
        for (int mu = 0; mu <= limit - (l > 1 ? short_by : 0); mu++) {
            num factor = div(G(factorial)(k - 1), mul(G(factorial)(j), G(factorial)(k - 1 - mu - j)));
            num power = G(power)(sub(n->tau[lambda], t_r), k - 1 - mu - j);
            sum = add(sum, mul(alpha[lambda][mu], mul(factor, power)));
        }
    }
    return mul(mul(sub(S->t[k], S->t[0]), G(power)(sub(t_r, S->t[S->r + 1]), j)), sum);
}

CLAIM(printed_double_sum_gives_the_basis)
{
    int k = T->degree + 1;
    num x[LARGEST_ORDER + 1], u = parameter(T, "u");
    G(increasing)(T, k + 1, x);
    for (int count = G(function_patterns)(k), m = 0; m < count; m++) {
        int pattern = G(function_pattern)(T, k, m), groups = 1;
        for (int a = 0; a < k; a++)
            groups += pattern >> a & 1;
        num alpha[LARGEST_ORDER + 1][LARGEST_ORDER + 1];
        for (int g = 0; g + 1 < groups; g++) {
            struct G(span) S = G(span_of_function)(k, pattern, g, x);
            struct G(nodes) n = G(nodes_of)(&S);
            num sum = from_int(0);
            if (g == 0)
                G(cofactor_weights)(&n, k, alpha);
            for (int j = 0; j < k; j++)
                sum = add(sum, mul(G(printed_coefficient)(&S, &n, alpha, j, fault(T, 0, 1)), G(power)(u, j)));
            same(T, sum, G(basis_value)(&S, 0, k, G(at_parameter)(&S, u)));
        }
    }
}

/*
The formula of the theorem has three sources: the weights of the last section, the derivatives of the power of
$\tau-t$, and the expansion of that power about $t_r$.  Its limits look strange, but they only combine what each of
the sums has room for.

:::{statement} wang-ch4:thm-4.4.1
:title: The coefficients by divided differences
:zh: 定理 4.4.1 基于差商的系数矩阵
:printed: suppose that $N_{i,k}(t)$ is defined on (4.4.10) and that $[t_r,t_{r+1})$ is not empty; then for $i=r-k+1,r-k+2,\dots,r$ there is (4.4.11) with
  $a_{ji}=(t_{i+k}-t_i)(t_r-t_{r+1})^j\sum_{\lambda=1,\ \tau_\lambda>t_r}^{d(T_i)}\
  \sum_{\mu=0}^{k-1-\max(j,k-l_\lambda)}\alpha_{\lambda\mu}(T_i)\frac{(k-1)!}{j!(k-1-\mu-j)!}(\tau_\lambda-t_r)^{k-1-\mu-j}$,
  $j=0,1,\dots,k-1$
:holds-by: printed_double_sum_gives_the_basis
:argued: every k | Summed over the $\tau_\lambda>t_r$ alone, the lines of the proof are true for every $k$ (`thm-4.4.1-step-1`, `thm-4.4.1-step-2`, `thm-4.4.1-step-expansion`,
  `thm-4.4.1-step-collect`).
:confirmed-by: column_by_differences_is_the_function
:needs: polynomial_of_a_span_ends_with_it | (4.4.11): $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:needs: empty_span_has_no_parameter | theorem 4.4.1: the interval $[t_r,t_{r+1})$ is not empty | the span is not
  empty
:figure: matrices_of_merging_knots

The condition $\tau_\lambda>t_r$ is a part of the formula: without it the sum is another one, see `thm-4.4.1-step-2`.
:::

:::{claim} column_by_differences_is_the_function
:title: The kernel for one column gives the B-spline
:zh: 差商法逐列计算
:given: every pattern of the $k+1$ knots of a function and every span among them, the different knots and $u$ variables;
  random patterns for greater $k$
:then: the coefficients of `bspline_column_by_differences` are those of $N_{i,k}$ on the span
:method: The kernel, which takes its weights from power series and sums by Horner's rule, against the recursion of Cox and de Boor.
:degrees: 0..4 sampled 7
:scope: every multiplicity of the knots of a function
:over: t#: knots
:defines: bspline_column_by_differences
:control: the span taken as the last one of the function
:::
*/
CLAIM(column_by_differences_is_the_function)
{
    int k = T->degree + 1;
    num x[LARGEST_ORDER + 1], a[LARGEST_ORDER], u = parameter(T, "u");
    G(increasing)(T, k + 1, x);
    for (int count = G(function_patterns)(k), m = 0; m < count; m++) {
        int pattern = G(function_pattern)(T, k, m), groups = 1;
        for (int b = 0; b < k; b++)
            groups += pattern >> b & 1;
        for (int g = 0; g + 1 < groups; g++) {
            struct G(span) S = G(span_of_function)(k, pattern, g, x),
                           last = G(span_of_function)(k, pattern, groups - 2, x);
            G(bspline_column_by_differences)(k - 1, S.t, S.group, 0, fault(T, S.r, last.r), a);
            num sum = from_int(0);
            for (int j = 0; j < k; j++)
                sum = add(sum, mul(a[j], G(power)(u, j)));
            same(T, sum, G(basis_value)(&S, 0, k, G(at_parameter)(&S, u)));
        }
    }
}

/*
:::{statement} wang-ch4:formula-4.4.12
:title: The coefficients as a double sum, and its limits
:zh: (4.4.12) 系数的二重和及其求和上限
:printed: a_{ji}=(t_{i+k}-t_i)(t_r-t_{r+1})^j\sum_{\lambda=1,\ \tau_\lambda>t_r}^{d(T_i)}\
  \sum_{\mu=0}^{k-1-\max(j,k-l_\lambda)}\alpha_{\lambda\mu}(T_i)\frac{(k-1)!}{j!(k-1-\mu-j)!}(\tau_\lambda-t_r)^{k-1-\mu-j},\quad
  i=r-k+1,r-k+2,\dots,r;\ j=0,1,\dots,k-1
:holds-by: printed_double_sum_gives_the_basis
:argued: every k | Summed over the $\tau_\lambda>t_r$ alone, the lines of the proof are true for every $k$ (`thm-4.4.1-step-1`, `thm-4.4.1-step-2`, `thm-4.4.1-step-expansion`,
  `thm-4.4.1-step-collect`).
:confirmed-by: summation_orders_agree
:needs: polynomial_of_a_span_ends_with_it | (4.4.11), whose coefficients they are: $t\in[t_r,t_{r+1})$ | $t$ lies in the span
:needs: empty_span_has_no_parameter | theorem 4.4.1: the interval $[t_r,t_{r+1})$ is not empty | the span is not
  empty
:figure: both_matrices

The $a_{ji}$ are the coefficients of $N_{i,k}^*(u)$ in (4.4.11).  The condition $\tau_\lambda>t_r$ is a part of the formula: without it the sum is another one, see
`thm-4.4.1-step-2`.  How the upper limits come about is `thm-4.4.1-step-collect`.
:::

:::{statement} wang-ch4:thm-4.4.1-curve
:title: So the curve has the coefficient matrix of these entries
:zh: 由此得 NURBS 曲线的系数矩阵表示
:printed: this gives the representation (4.4.2) of the NURBS curve (4.1.1) on $[t_r,t_{r+1})$
:holds-by: printed_double_sum_gives_the_basis matrix_holds_the_powers_of_the_basis matrix_gives_homogeneous_curve
:argued: every order and every pattern of knots | The columns are those of theorem 4.4.1 for every $k$, and the curve is the sum of the points times the functions.
:confirmed-by: matrix_by_differences_is_the_matrix
:needs: empty_span_has_no_parameter | theorem 4.4.1: the interval $[t_r,t_{r+1})$ is not empty | the span is not
  empty
:needs: polynomial_of_a_span_ends_with_it | the line itself: on $[t_r,t_{r+1})$ | $t$ lies in the span
:figure: matrix_and_weights

For the homogeneous curve (4.1.1).  The columns of (4.4.12) and of the matrix have the same polynomials of $u$, so they are the same.
:::

:::{claim} matrix_by_differences_is_the_matrix
:title: The matrix by divided differences is the matrix of the powers
:zh: 差商法系数矩阵与幂基展开一致
:given: every pattern of the 2k knots around a span up to the order 3, variables; greater orders with simple knots and
  with the knots of Bernstein in the field, with random patterns in the other number types
:then: `bspline_matrix_by_differences` and `bspline_matrix` give the same matrix
:method: Entry by entry.
:degrees: 0..4 sampled 7
:scope: every pattern of the knots around a span up to order 3, the two extreme ones above
:over: t#: knots
:defines: bspline_matrix_by_differences
:control: the last two columns exchanged
:::
*/
CLAIM(matrix_by_differences_is_the_matrix)
{
    int k = T->degree + 1;
    num x[2 * LARGEST_ORDER], A[CELLS], B[CELLS];
    G(increasing)(T, 2 * k, x);
    for (int count = G(pattern_count)(k, 3, 2), m = 0; m < count; m++) {
        struct G(span) S = G(span_of_pattern)(k, G(which_pattern)(T, k, 3, m), x);
        G(bspline_matrix)(k - 1, S.t, S.r, A);
        G(bspline_matrix_by_differences)(k - 1, S.t, S.group, S.r, B);
        for (int j = 0; j < k; j++)
            for (int i = 0; i < k; i++) {
                int from = fault(T, i, k > 1 && i >= k - 2 ? 2 * k - 3 - i : i);
                same(T, B[j * k + from], A[j * k + i]);
            }
    }
}

#include "chapters/judge/claims_off.h"
