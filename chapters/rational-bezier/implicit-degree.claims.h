/*
# The degree of the implicit equation (隐式方程的次数)

The determinant (3.4.1) has $2n$ rows, and $x$ and $y$ stand in every one of them; by this alone $F$ could have the degree
$2n$.  It has at most the degree $n$, the degree of the curve.  Bézout's matrix shows it at a glance, as it has $n$ rows and
entries of degree one; the source takes another way, by operations on columns, and this way is followed afterwards.
*/
#include "exact/record/resultant.h"

#include "chapters/rational-bezier/determinants.h"
#include "chapters/rational-bezier/free-curve.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch3:thm-3.4.2
:title: F is a polynomial of degree at most n
:zh: F 的次数不高于 n
:printed: $F(x,y)$ in (3.4.1) is a polynomial in two variables of degree at most $n$.
:holds-by: column_operations_free_all_entries_but_the_first
:confirmed-by: bezout_entries_are_linear bezout_matrix_comes_from_the_blocks sylvester_and_bezout_give_one_equation
  variables_stay_in_the_first_columns common_zero_makes_the_equation_vanish
:figure: implicit_degree

The claim is the proof of the source, with the recursion corrected: after its column operations $x$ and $y$ stand in $n$ columns only, in degree one, and a product of one
entry from every column has degree at most $n$.  It divides by $\omega_0$; for $\omega_0=0$ the first column of (3.4.1) is 0, and $F$ is the zero polynomial.
:::

:::{claim} bezout_entries_are_linear
:title: The entries of Bézout's matrix are of degree one in x and y
:zh: Bézout 矩阵的元素是一次的
:given: any numbers $p,q$ in the place of $\binom ni\omega_i$, $\binom nj\omega_j$, any $x_i,y_i,x_j,y_j$
:then: $a_ib_j-a_jb_i=pq\,\bigl(x_iy_j-x_jy_i-(x_i-x_j)y+(y_i-y_j)x\bigr)$
:method: The terms with $xy$ cancel.  The entries of Bézout's matrix are sums of such differences, the matrix has
  $n$ rows, so its determinant has degree at most $n$; for every $n$ and all weights.
:scope: any two pairs of entries
:over: p# q#: weights; x# y#: points; x; y
:control: $a_ib_j+a_jb_i$
:degrees: all
:::
*/
CLAIM(bezout_entries_are_linear)
{
    num p = unknown(T, "p", 0), q = unknown(T, "q", 0), x = parameter(T, "x"), y = parameter(T, "y");
    num x0 = unknown(T, "x", 0), y0 = unknown(T, "y", 0), x1 = unknown(T, "x", 1), y1 = unknown(T, "y", 1);
    num a0 = mul(p, sub(x0, x)), b0 = mul(p, sub(y0, y)), a1 = mul(q, sub(x1, x)), b1 = mul(q, sub(y1, y));
    num left = fault(T, sub(mul(a0, b1), mul(a1, b0)), add(mul(a0, b1), mul(a1, b0)));
    num constant = sub(mul(x0, y1), mul(x1, y0)), linear = sub(mul(sub(y0, y1), x), mul(sub(x0, x1), y));
    /* a_i b_j - a_j b_i = p q (x_i y_j - x_j y_i - (x_i - x_j) y + (y_i - y_j) x) */
    same(T, left, mul(mul(p, q), add(constant, linear)));
}

/*
:::{claim} bezout_matrix_comes_from_the_blocks
:title: Bézout's matrix comes from the four blocks of Sylvester's
:zh: Bézout 矩阵与 Sylvester 矩阵的分块
:given: polynomials $a$ and $b$ of degree $n$; $A_1,A_2$ over $B_1,B_2$, the $n\times n$ blocks of Sylvester's matrix
:then: $A_1B_1=B_1A_1$, and $A_1B_2-B_1A_2$ is Bézout's matrix with its rows in reverse order
:method: All $2n+2$ coefficients are variables.  Multiplied from the left by the blocks $I,0$ over $-B_1,A_1$
  Sylvester's matrix becomes $A_1,A_2$ over $0,A_1B_2-B_1A_2$; as $\det A_1=a_0^n$ is not the zero polynomial, the two
  determinants are equal up to the sign $(-1)^{n(n-1)/2}$ of the reversal.
:degrees: 1..6 sampled 12
:argued: every n | Both sides have the entries $\sum_{m\le n-1-i}(a_mb_{n+j-i-m}-b_ma_{n+j-i-m})$.
:over: a# b#: coefficients
:control: $A_2$ and $B_2$ exchanged
:::
*/
CLAIM(bezout_matrix_comes_from_the_blocks)
{
    int n = T->degree, second = fault(T, 0, n); /* the rows of the block that stands for A_2 */
    num a[MAX_ORDER + 1], b[MAX_ORDER + 1], S[MAX_ORDER * MAX_ORDER], M[MAX_ORDER * MAX_ORDER];
    for (int i = 0; i <= n; i++) {
        a[i] = unknown(T, "a", i);
        b[i] = unknown(T, "b", i);
    }
    G(sylvester)(n, a, n, b, S);
    G(bezout)(n, a, b, M);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            num commutator = from_int(0), entry = from_int(0);
            for (int k = 0; k < n; k++) {
                num A1 = S[i * 2 * n + k], B1 = S[(n + i) * 2 * n + k];
                commutator = add(commutator, mul(A1, S[(n + k) * 2 * n + j]));
                commutator = sub(commutator, mul(B1, S[k * 2 * n + j]));
                entry = add(entry, mul(A1, S[(n - second + k) * 2 * n + n + j]));
                entry = sub(entry, mul(B1, S[(second + k) * 2 * n + n + j]));
            }
            about(T, "the first two blocks commute");
            vanishes(T, commutator);
            about(T, "Bézout's matrix");
            same(T, entry, M[(n - 1 - i) * n + j]);
        }
}

/*
:::{claim} sylvester_and_bezout_give_one_equation
:title: The 2n × 2n determinant and Bézout's n × n determinant are the same F
:zh: 两种行列式给出同一 F
:given: weights and points, any $x,y$
:then: the determinant (3.4.1) is $(-1)^{n(n-1)/2}$ times the determinant of Bézout's matrix
:method: Both determinants without division, all numbers variables.
:degrees: 1..4 sampled 8
:over: x# y#: points; x; y
:control: the sign $(-1)^{n(n+1)/2}$
:::
*/
CLAIM(sylvester_and_bezout_give_one_equation)
{
    int n = T->degree;
    num R[2 * MAX_ORDER + 2], w[MAX_ORDER + 1], a[MAX_ORDER + 1], b[MAX_ORDER + 1], M[MAX_ORDER * MAX_ORDER];
    num x = parameter(T, "x"), y = parameter(T, "y");
    G(free_curve)(T, n, 2, R, w);
    G(implicit_coefficients)(n, R, w, 0, x, a);
    G(implicit_coefficients)(n, R, w, 1, y, b);
    G(bezout)(n, a, b, M);
    num det = G(determinant)(n, M);
    int half = fault(T, n * (n - 1) / 2, n * (n + 1) / 2);
    same(T, G(resultant)(n, a, n, b), half % 2 == 0 ? det : neg(det));
}

/*
The source proves the bound by column operations.  Write $f$ for $a$ or $b$, and
$\Omega_i=\binom ni\omega_i/\omega_0$. The operations are described in words, then as a recursion for the entries,
then as the resulting determinant.  Words and recursion do not agree.

:::{statement} wang-ch3:3.4.6
:title: The entries before the first step
:zh: 初始元素
:printed: f_i^{[0]}=f_i\ (i=0,\dots,n),\qquad f_i^{[0]}=0\ (i\ge n+1)
:definition: yes
:checked-by: column_operations_free_all_entries_but_the_first
:confirmed-by: column_operations_give_the_corrected_recursion

Here $f$ stands for the $a$ or the $b$ of (3.4.2).  In the text at hand the line is printed twice, the second time with the recursion (3.4.7).
:::

A row of the matrix is best read as a polynomial in a letter $z$ that marks the columns.  An operation is then the same for all rows, and needs no $n$.

:::{claim} column_operations_free_all_entries_but_the_first
:title: The column operations leave x only in the first entry of each row, in every degree
:zh: 列变换后各行仅首元素含 x(任意次数)
:given: $n\ge1$, $\omega_0\ne0$; row $k$ of the $a$ as the polynomial $z^{k-1}f(z)$, where $z^{j-1}$ marks column $j$ and $f(z)=\sum a_iz^i=X(z)-x\,\omega_0\Omega(z)$ with
  $X(z)=\sum\binom ni\omega_ix_iz^i$, $\Omega(z)=1+\Omega_1z+\dots+\Omega_nz^n$; step $r$ takes a row $g(z)$ to $g(z)-g_rz^{r-1}(\Omega(z)-1)$, $g_r$ being its entry in column $r$
:where: $\omega_0\ne0$
:then: (1) step $r=k$ takes $f$ to $a_0+X(z)-x_0\omega_0\Omega(z)$, in which $x$ is only in $a_0$; (2) in row $k$, with $\rho=r-k+1$, column $r+i$ has the entry with the index $j=r+i-k$, and $j-\rho+1=i$, so that step $r$ is
  $f_j^{[\rho]}=f_j^{[\rho-1]}-\Omega_{j-\rho+1}f_{\rho-1}^{[\rho-1]}$
:method: $z^{r-1}\Omega_iz^i$ marks column $r+i$, so that these are the operations in the words of the source; the steps $r<k$ do not change row $k$, as its entry in column $r$ is 0,
  and the steps $r>k$ change its entries by products of numbers that do not contain $x$.
  $X$, $\Omega$, $\omega_0$, $x_0$, $x$ and another value $x'$ are variables, and so are the indices.  So after the $n$ steps $x$ stands in the entries $(k,k)$, and $y$, by the same for the $b$, in
  the entries $(n+k,k)$, $k=1,\dots,n$: in $n$ columns, as $a_0$ and $b_0$.  An operation of this kind does not change a determinant.
:degrees: all
:over: x#: points; c#: weights; X O r k i x x' : -
:control: $\Omega$ for $\Omega-1$ in step $k$
:::
*/
CLAIM(column_operations_free_all_entries_but_the_first)
{
    num one = from_int(1), X = unknown(T, "X", 0), O = unknown(T, "O", 0), c = positive(T, "c", 0),
        x0 = unknown(T, "x", 0);
    num at[2] = {parameter(T, "x"), parameter(T, "x'")}, changed[2];
    for (int k = 0; k < 2; k++) {
        num first = mul(c, sub(x0, at[k])), f = sub(X, mul(at[k], mul(c, O)));
        num step = sub(f, mul(first, fault(T, sub(O, one), O)));
        about(T, "step k in row k");
        same(T, step, add(first, sub(X, mul(x0, mul(c, O)))));
        changed[k] = sub(step, first);
    }
    about(T, "what it leaves behind the first entry, for two values of x");
    same(T, changed[0], changed[1]);
    about(T, "an index");
    num k = whole(T, "k", 1, 5), r = add(k, whole(T, "r", 0, 4)), i = whole(T, "i", 1, 5);
    num j = sub(add(r, i), k), rho = add(sub(r, k), one);
    same(T, add(sub(j, rho), one), i);
    about(T, "the column of the entry j of row k");
    same(T, add(k, j), add(r, i));
}

/* Omega_i, i = 0, ..., n. */
static void G(omegas)(int n, const num w[], num O[])
{
    for (int i = 0; i <= n; i++)
        O[i] = mul(from_int(binomial(n, i)), div(w[i], w[0]));
}

/* f[r][i] = f_i^{[r]}, i < 2n, by (3.4.6) and (3.4.7): with Omega_{i-r+1}, or as printed. */
static void G(reduced_entries)(int n, const num O[], const num f[], int printed, num out[][2 * MAX_ORDER])
{
    for (int i = 0; i < 2 * n; i++)
        out[0][i] = i <= n ? f[i] : from_int(0);
    for (int r = 1; r <= n; r++)
        for (int i = r; i < 2 * n; i++) {
            int k = printed ? i : i - r + 1;
            num change = i < r + n && k <= n ? mul(O[k], out[r - 1][r - 1]) : from_int(0);
            out[r][i] = sub(out[r - 1][i], change);
        }
}

/* The matrix of (3.4.1) after the first `steps` steps of column operations. */
static void G(operate)(int n, const num O[], const num a[], const num b[], int steps, num M[])
{
    G(sylvester)(n, a, n, b, M);
    for (int r = 1; r <= steps; r++)
        for (int i = 1; i <= n; i++)
            for (int row = 0; row < 2 * n; row++) {
                num *entry = &M[row * 2 * n + (i + r - 1)];
                *entry = sub(*entry, mul(O[i], M[row * 2 * n + (r - 1)]));
            }
}

/*
:::{claim} column_operations_give_the_corrected_recursion
:title: The column operations, done one by one, give the recursion with Ω_{i-r+1} and do not change F
:zh: 逐列变换与更正后的递推一致
:given: weights with $\omega_0\ne0$ and points, $n\ge1$, any $x,y$
:where: $\omega_0\ne0$
:then: after the operations row $k$ of the $a$ is $a_j^{[\min(j,n-k+1)]}$, $j=0,\dots,2n-k$, from column $k$ on,
  with the corrected recursion, and so for the $b$
:method: The operations are carried out on the matrix of (3.4.1), the recursion on the entries; all entries are
  compared. An operation of this kind does not change a determinant.
:degrees: 1..6 sampled 8
:over: x# y#: points; x; y
:control: $\Omega_i$ as printed, 0 beyond $n$
:::
*/
CLAIM(column_operations_give_the_corrected_recursion)
{
    int n = T->degree;
    num R[2 * MAX_ORDER + 2], w[MAX_ORDER + 1], f[2][MAX_ORDER + 1], O[MAX_ORDER + 1], M[MAX_ORDER * MAX_ORDER];
    num level[MAX_ORDER / 2 + 1][2 * MAX_ORDER];
    G(free_curve)(T, n, 2, R, w);
    G(implicit_coefficients)(n, R, w, 0, parameter(T, "x"), f[0]);
    G(implicit_coefficients)(n, R, w, 1, parameter(T, "y"), f[1]);
    G(omegas)(n, w, O);
    G(operate)(n, O, f[0], f[1], n, M);
    for (int half = 0; half < 2; half++) {
        G(reduced_entries)(n, O, f[half], fault(T, 0, 1), level);
        for (int k = 0; k < n; k++) /* row k+1 of the source */
            for (int column = 0; column < 2 * n; column++) {
                int j = column - k, r = j < n - k ? j : n - k;
                same(T, M[(half * n + k) * 2 * n + column], j < 0 ? from_int(0) : level[r][j]);
            }
    }
}

/*
:::{statement} wang-ch3:3.4.7
:title: The recursion of the column operations
:zh: 列变换的递推式
:printed: f_i^{[r]}=f_i^{[r-1]}-\Omega_i\,f_{r-1}^{[r-1]},\ \Omega_i=\binom ni\frac{\omega_i}{\omega_0},\
  i=r,\dots,r+n-1; \qquad f_i^{[r]}=f_i^{[r-1]},\ i\ge r+n;
  \qquad r=1,2,\dots,n
:class: misprint
:refuted-by: printed_recursion_is_not_the_operations
:corrected: f_i^{[r]}=f_i^{[r-1]}-\Omega_{i-r+1}\,f_{r-1}^{[r-1]},\ i=r,\dots,r+n-1;\qquad f_i^{[r]}=f_i^{[r-1]},\
  i\ge r+n;\qquad r=1,2,\dots,n
:corrected-by: column_operations_free_all_entries_but_the_first
:confirmed-by: column_operations_give_the_corrected_recursion
:needs: end_weight_zero_gives_no_equation | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\omega_0\ne0$:
  $\Omega_i$ divides by it; in the example with $\omega_0=0$ the determinant is 0
:figure: implicit_recursion

For $r=1$ the two agree.  From $r=2$ on the printed index runs beyond $n$, where there is no $\omega_i$; even with
$\Omega_i=0$ there, the determinant of the example changes.
:::
*/

#if FIELD
/*
:::{claim} printed_recursion_is_not_the_operations
:title: With the printed index the determinant is another polynomial
:zh: 按所印下标行列式改变
:kind: counterexample
:types: field
:data: R = (0,0) (1,0) (1,1); ω = 1 1 1
:result: determinant by the recursion = "x^2-y^2-4*y"; F(x, y) = "x^2+2*x*y+y^2-4*y"; determinant at R_2 = -4; F(R_2) = 0
:given: $n=2$, the points $R$ of a parabola and equal weights; in the printed recursion $\Omega_3=0$
:then: the determinant (3.4.8), filled in by this recursion, is another polynomial than $F$: in the end point $R_2$ of the curve it is not $0$
:method: The rows of (3.4.8) are $a_j^{[\min(j,n-k+1)]}$ and $b_j^{[\min(j,n-k+1)]}$ from column $k$ on, by the printed recursion; the determinant is taken with $x$ and $y$ variables.
:control: the index $i-r+1$
:::
*/
/* The determinant after the column operations of the curve of degree 2, with the printed index or the right one. */
static num staircase_f(const num R[], const num w[], num x, num y, int printed)
{
    enum { n = 2 };
    num O[n + 1], f[2][n + 1], M[4 * n * n], level[MAX_ORDER / 2 + 1][2 * MAX_ORDER];
    omegas_f(n, w, O);
    implicit_coefficients_f(n, R, w, 0, x, f[0]);
    implicit_coefficients_f(n, R, w, 1, y, f[1]);
    for (int half = 0; half < 2; half++) {
        reduced_entries_f(n, O, f[half], printed, level);
        for (int k = 0; k < n; k++)
            for (int column = 0; column < 2 * n; column++) {
                int j = column - k, r = j < n - k ? j : n - k;
                M[(half * n + k) * 2 * n + column] = j < 0 ? from_int(0) : level[r][j];
            }
    }
    return determinant_f(2 * n, M);
}

CLAIM(printed_recursion_is_not_the_operations)
{
    enum { n = 2 };
    num R[2 * n + 2], w[n + 1], x = variable_f("x"), y = variable_f("y");
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    int printed = fault(T, 0, 1);
    num determinant = staircase_f(R, w, x, y, printed), F = implicit_value_f(n, R, w, x, y);
    found_text(T, "determinant by the recursion", to_string_f(determinant));
    found_text(T, "F(x, y)", to_string_f(F));
    const num *end = R + 2 * n;
    found(T, "determinant at R_2", staircase_f(R, w, end[0], end[1], printed));
    found(T, "F(R_2)", implicit_value_f(n, R, w, end[0], end[1]));
    about(T, "the determinant, left with the recursion, right (3.4.1)");
    same(T, determinant, F);
}
#endif

/*
:::{statement} wang-ch3:thm-3.4.2-step-columns
:title: Step r subtracts Ω_i times column r from column i+r
:zh: 列初等变换
:printed: Elementary operations are carried out on the determinant in (3.4.1): from column $i+1$ subtract $\Omega_i$ times column 1, $i=1,2,\dots,n$; then from column
  $i+2$ subtract $\Omega_i$ times column 2, $i=1,2,\dots,n$; at last from column $i+n$ subtract $\Omega_i$ times column $n$, $i=1,2,\dots,n$.
:holds-by: column_operations_free_all_entries_but_the_first
:confirmed-by: column_operations_give_the_corrected_recursion
:needs: end_weight_zero_gives_no_equation | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\omega_0\ne0$:
  $\Omega_i$ divides by it; in the example with $\omega_0=0$ the determinant is 0

The columns $i+r\le2n$ exist, and the determinant does not change.  The text at hand has the sentence twice, the second time with gaps.
:::

:::{statement} wang-ch3:3.4.8
:title: The determinant after the operations
:zh: 变换后的行列式
:printed: a staircase of the entries $a_j^{[r]}$ over one of the $b_j^{[r]}$ whose first row begins
  $a_0,\ a_1^{[1]},\ \cdots$; the upper indices of the later entries are not legible in the text at hand, which gives
  among others $a_{n-1}^{[n]}$, $a_n^{[n-1]}$ and $a_n^{[n]}$
:reading: column_operations_free_all_entries_but_the_first | what the operations give: row $k$, beginning in column
  $k$, is $a_j^{[\min(j,n-k+1)]}$, $j=0,\dots,2n-k$; so the first row is
  $a_0,a_1^{[1]},\dots,a_n^{[n]},a_{n+1}^{[n]},\dots,a_{2n-1}^{[n]}$ and the last of the $a$ is
  $a_0,a_1^{[1]},\dots,a_n^{[1]}$
:reading: an entry $a_{n-1}^{[n]}$, if it is printed: not defined by (3.4.7), which has $i\ge r$
:needs: end_weight_zero_gives_no_equation | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\omega_0\ne0$:
  $\Omega_i$ divides by it; in the example with $\omega_0=0$ the determinant is 0
:::

What the operations are good for is seen in the first one: $a_i-\Omega_ia_0=\binom ni\omega_i(x_i-x_0)$ is free of
$x$, and no later operation brings $x$ back.  So the variables stay only where no operation has been, in the entries
$a_0$ and $b_0$; and of these there is one pair in each of the first $n$ columns.

:::{statement} wang-ch3:thm-3.4.2-step-constants
:title: All entries changed at least once are constants; only a_0 and b_0 contain x and y
:zh: 变换后的元素为常数
:printed: By (3.4.7) all $a_i^{[r]}$, $b_i^{[r]}$ ($r=1,2,\dots,n$; $i\ge r$) are constants, hence in the determinant (3.4.8) only $a_0$ contains $x$
  and only $b_0$ contains $y$.
:holds-by: column_operations_free_all_entries_but_the_first
:confirmed-by: changed_entries_are_constants variables_stay_in_the_first_columns
:meant: the column operations, whose recursion it is | (3.4.7) is the recursion with $\Omega_{i-r+1}$.
:needs: end_weight_zero_gives_no_equation | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\omega_0\ne0$:
  $\Omega_i$ divides by it; in the example with $\omega_0=0$ the determinant is 0

The first row of the $a$ is the one of the recursion; the entry $j$ of row $k$ is $a_j^{[r]}$ with $r=\min(j,n-k+1)$.  With the printed recursion,
which is not the one of the operations, they are constants, too: its first level is the same, and every later one is made of entries of level 1 and more;
for $n=1$ to $6$ this is run in `changed_entries_are_constants`.
:::

:::{statement} wang-ch3:thm-3.4.2-step-same-columns
:title: a_0 and b_0 stand in the same columns, hence the degree is at most n
:zh: a_0 与 b_0 同列
:printed: And because $a_0$ and $b_0$ stand in the same columns, the conclusion of the theorem holds.
:holds-by: column_operations_free_all_entries_but_the_first
:confirmed-by: variables_stay_in_the_first_columns
:needs: end_weight_zero_gives_no_equation | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\omega_0\ne0$:
  $\Omega_i$ divides by it, and without it there is no (3.4.8); the conclusion alone holds in the example, too, where $F$ is 0

The variables stand in $n$ columns, in degree one: a product of one entry from every column has degree at most $n$.
:::

:::{claim} changed_entries_are_constants
:title: The entries of level r ≥ 1 do not depend on x
:zh: r≥1 层的元素与 x 无关
:given: weights with $\omega_0\ne0$, one coordinate of the points, $n\ge1$, two values $x$ and $x'$
:where: $\omega_0\ne0$
:then: $f_i^{[r]}$, $1\le r\le n$, $r\le i<2n$, is the same for both, with the corrected and with the printed recursion
:method: The recursion is run for both values.  $f_i^{[1]}=\binom ni\omega_i(x_i-x_0)$, and later levels are
  combinations of such numbers.
:degrees: 1..6 sampled 10
:argued: every n | $f_i^{[1]}$ is as in the method for $i\le n$ and 0 beyond; for $r\ge2$ both recursions form $f_i^{[r]}$, $i\ge r$, from $f_i^{[r-1]}$ and
  $f_{r-1}^{[r-1]}$, which are of level $r-1\ge1$.
:over: x#: points; x; x'
:control: level 0 included
:::
*/
CLAIM(changed_entries_are_constants)
{
    int n = T->degree;
    num R[2 * MAX_ORDER + 2], w[MAX_ORDER + 1], O[MAX_ORDER + 1], f[MAX_ORDER + 1], g[MAX_ORDER + 1];
    num one[MAX_ORDER / 2 + 1][2 * MAX_ORDER], other[MAX_ORDER / 2 + 1][2 * MAX_ORDER];
    G(free_curve)(T, n, 2, R, w);
    G(omegas)(n, w, O);
    G(implicit_coefficients)(n, R, w, 0, parameter(T, "x"), f);
    G(implicit_coefficients)(n, R, w, 0, parameter(T, "x'"), g);
    for (int printed = 0; printed < 2; printed++) {
        G(reduced_entries)(n, O, f, printed, one);
        G(reduced_entries)(n, O, g, printed, other);
        for (int r = fault(T, 1, 0); r <= n; r++)
            for (int i = r; i < 2 * n; i++)
                same(T, one[r][i], other[r][i]);
    }
}

/*
:::{claim} variables_stay_in_the_first_columns
:title: After the operations x and y stand only in entry (k,k) and entry (n+k,k), k = 1, ..., n
:zh: 变换后变量只在前 n 列
:given: weights with $\omega_0\ne0$ and points, $n\ge1$, two points $(x,y)$ and $(x',y')$
:where: $\omega_0\ne0$
:then: the two matrices after the operations differ only in the entries $(k,k)$ and $(n+k,k)$, which are $a_0$ and $b_0$
:method: The operations are carried out on both matrices; all other entries are compared.
:degrees: 1..6 sampled 8
:over: x# y#: points; x; y; x'; y'
:control: the last of the $n$ steps left out
:::
*/
CLAIM(variables_stay_in_the_first_columns)
{
    int n = T->degree, steps = fault(T, n, n - 1);
    num R[2 * MAX_ORDER + 2], w[MAX_ORDER + 1], O[MAX_ORDER + 1], a[MAX_ORDER + 1], b[MAX_ORDER + 1];
    num M[MAX_ORDER * MAX_ORDER], N[MAX_ORDER * MAX_ORDER];
    G(free_curve)(T, n, 2, R, w);
    G(omegas)(n, w, O);
    G(implicit_coefficients)(n, R, w, 0, parameter(T, "x"), a);
    G(implicit_coefficients)(n, R, w, 1, parameter(T, "y"), b);
    G(operate)(n, O, a, b, steps, M);
    G(implicit_coefficients)(n, R, w, 0, parameter(T, "x'"), a);
    G(implicit_coefficients)(n, R, w, 1, parameter(T, "y'"), b);
    G(operate)(n, O, a, b, steps, N);
    for (int row = 0; row < 2 * n; row++)
        for (int column = 0; column < 2 * n; column++)
            if (column != row % n)
                same(T, M[row * 2 * n + column], N[row * 2 * n + column]);
            else
                same(T, N[row * 2 * n + column], row < n ? a[0] : b[0]);
}

/*
Where a base point is, $F$ has no degree at all. Its parameter is a common root of the two polynomials for every
$x$ and $y$, so the same vector of powers is mapped to 0 everywhere.  Elevation makes such a parameter, $u=-1$,
without anybody noticing, as it lies outside the half line.

:::{claim} common_zero_makes_the_equation_vanish
:title: A common zero of numerators and denominator makes F identically 0
:zh: 有公共零点时 F 恒为零
:given: $A$, $B$, $W$ with a common zero $\rho$, or $\omega_0=0$; any $x,y$
:then: the matrix of (3.4.1) maps $(\rho^{2n-1},\dots,\rho,1)$ to 0, or has a first column of zeros
:method: The three polynomials are multiplied out from $u-\rho$ and three free cofactors; everything is a variable.
:degrees: 1..6 sampled 10
:over: a# b# c#: coefficients; rho; x; y
:control: the zero of $B$ moved to $\rho+1$
:::
*/
CLAIM(common_zero_makes_the_equation_vanish)
{
    int n = T->degree;
    num p[3][MAX_ORDER + 1], R[2 * MAX_ORDER + 2], w[MAX_ORDER + 1], a[MAX_ORDER + 1], b[MAX_ORDER + 1];
    num M[MAX_ORDER * MAX_ORDER], rho = parameter(T, "rho"), x = parameter(T, "x"), y = parameter(T, "y");
    for (int k = 0; k < 3; k++) { /* (u - rho) times a polynomial of degree n-1 */
        num zero = fault(T, rho, k == 1 ? add(rho, from_int(1)) : rho), before = from_int(0);
        for (int i = 0; i <= n; i++) {
            num c = i < n ? positive(T, k == 0 ? "a" : k == 1 ? "b" : "c", i) : from_int(0);
            p[k][i] = sub(c, mul(zero, before));
            before = c;
        }
    }
    for (int i = 0; i <= n; i++) {
        w[i] = div(p[2][i], from_int(binomial(n, i)));
        R[2 * i] = div(p[0][i], p[2][i]);
        R[2 * i + 1] = div(p[1][i], p[2][i]);
    }
    G(implicit_coefficients)(n, R, w, 0, x, a);
    G(implicit_coefficients)(n, R, w, 1, y, b);
    G(sylvester)(n, a, n, b, M);
    about(T, "the rows of the matrix times the powers of the common zero");
    for (int i = 0; i < 2 * n; i++)
        vanishes(T, G(horner)(2 * n - 1, &M[i * 2 * n], rho));
    w[0] = from_int(0);
    G(implicit_coefficients)(n, R, w, 0, x, a);
    G(implicit_coefficients)(n, R, w, 1, y, b);
    G(sylvester)(n, a, n, b, M);
    about(T, "the first column for ω_0 = 0");
    for (int i = 0; i < 2 * n; i++)
        vanishes(T, M[i * 2 * n]);
}

/*
Every elevated curve has one.

:::{claim} elevation_multiplies_by_one_plus_u
:title: Degree elevation multiplies numerators and denominator by 1 + u
:zh: 升阶使分子分母同乘 1+u
:given: weights and one coordinate of the points, $n\ge1$, any $u$
:then: $\hat W(u)=(1+u)W(u)$ and $\hat A(u)=(1+u)A(u)$
:method: The elevated points and weights by the kernel; both sides in the field.  So the elevated curve has the common
  zero $u=-1$.
:degrees: 1..6 sampled 12
:control: the factor $1-u$
:::
*/
CLAIM(elevation_multiplies_by_one_plus_u)
{
    int n = T->degree;
    num R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], Re[MAX_DEGREE + 1], we[MAX_DEGREE + 1], u = parameter(T, "u");
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        R[i] = unknown(T, "R", i);
    }
    G(rational_elevate)(n, 1, R, w, Re, we);
    num factor = fault(T, add(from_int(1), u), sub(from_int(1), u));
    about(T, "the denominator");
    /* W of the elevated curve is (1+u) W(u) */
    same(T, G(in_u)(n + 1, we, u), mul(factor, G(in_u)(n, w, u)));
    for (int i = 0; i <= n; i++)
        R[i] = mul(w[i], R[i]);
    for (int i = 0; i <= n + 1; i++)
        Re[i] = mul(we[i], Re[i]);
    about(T, "a numerator");
    same(T, G(in_u)(n + 1, Re, u), mul(factor, G(in_u)(n, R, u)));
}

#include "chapters/judge/claims_off.h"
