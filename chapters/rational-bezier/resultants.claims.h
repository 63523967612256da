/*
# Determinants and resultants (行列式与结式)

To find the equation of a curve its parameter is eliminated from two polynomials, and the tool for this is their
resultant (结式): a determinant of the coefficients, which is 0 when the polynomials have a common root.  Two matrices
serve the purpose.  Sylvester's has $m+n$ rows, and each entry is a coefficient or 0; Bézout's has only $n$, and each
entry is a sum of products.  This section holds the determinants that the next one computes with against their
definitions.

A determinant of numbers may be found by elimination.  Here the entries are polynomials in $x$ and $y$, so the kernel uses
an algorithm without division, and the other side of its comparison is the sum over all permutations.
*/
#include "chapters/judge/elementary.h"
#include "chapters/rational-bezier/determinants.h"

#include "chapters/judge/claims_on.h"

/*
:::{claim} determinant_is_the_sum_over_permutations
:title: The determinant without division is Leibniz' sum
:zh: 无除法行列式等于 Leibniz 展开
:given: an $n\times n$ matrix
:then: Bird's algorithm returns $\sum_\sigma\operatorname{sgn}\sigma\prod_iM_{i,\sigma(i)}$
:method: The sum is taken over all permutations, column by column, in every arithmetic.
:defines: determinant
:degrees: 1..5 sampled 6
:over: m#: entries
:control: two columns of the sum exchanged
:::
*/
CLAIM(determinant_is_the_sum_over_permutations)
{
    int n = T->degree;
    num M[MAX_ORDER * MAX_ORDER];
    for (int k = 0; k < n * n; k++)
        M[k] = unknown(T, "m", k);
    num det = G(determinant)(n, M);
    for (int i = 0; T->faulty && n > 1 && i < n; i++) {
        num held = M[i * n];
        M[i * n] = M[i * n + 1];
        M[i * n + 1] = held;
    }
    same(T, det, G(leibniz)(n, M, 0, 0));
}

/*
:::{claim} sylvester_rows_are_shifted_polynomials
:title: Row by row Sylvester's matrix is a polynomial times a power
:zh: Sylvester 矩阵的各行
:given: polynomials $a$ of degree $m=1,\dots,n$ and $b$ of degree $n$, any $z$
:then: the matrix times $(z^{m+n-1},\dots,z,1)$ is $(z^{n-1}a(z),\dots,a(z),z^{m-1}b(z),\dots,b(z))$
:method: With $z$ a variable the products determine every entry.  The polynomials are evaluated by Horner's rule.
:defines: sylvester
:degrees: 1..6 sampled 8
:over: a# b#: coefficients; z
:control: $a$ and $b$ exchanged on the right side
:::
*/
CLAIM(sylvester_rows_are_shifted_polynomials)
{
    int n = T->degree;
    num a[MAX_ORDER + 1], b[MAX_ORDER + 1], M[MAX_ORDER * MAX_ORDER], z = parameter(T, "z");
    for (int i = 0; i <= n; i++) {
        a[i] = unknown(T, "a", i);
        b[i] = unknown(T, "b", i);
    }
    for (int m = 1; m <= n; m++) {
        G(sylvester)(m, a, n, b, M);
        for (int i = 0; i < m + n; i++) {
            int upper = fault(T, i < n, i >= n), shift = i < n ? n - 1 - i : m + n - 1 - i;
            num row = from_int(0), value = upper ? G(horner)(m, a, z) : G(horner)(n, b, z);
            for (int j = 0; j < m + n; j++)
                row = add(row, mul(M[i * (m + n) + j], G(power)(z, m + n - 1 - j)));
            same(T, row, mul(G(power)(z, shift), value));
        }
    }
}

/*
In Sylvester's matrix a common root $z$ is seen at once: it makes all rows vanish on the vector of its powers.
Bézout's matrix starts from another remark.  The polynomial $a(x)b(y)-a(y)b(x)$ is 0 for $x=y$, so $x-y$ divides it;
the entries are the coefficients of the quotient.

:::{claim} bezout_matrix_is_the_divided_difference
:title: Bézout's matrix gives the divided difference of a and b
:zh: Bézout 矩阵的定义式
:given: polynomials $a$ and $b$ of degree $n$, any $x$ and $y$
:then: $(x-y)\sum M_{ij}x^{n-1-i}y^{n-1-j}=a(x)b(y)-a(y)b(x)$
:method: With $x$ and $y$ variables the identity determines every entry.
:defines: bezout
:degrees: 1..6 sampled 10
:over: a# b#: coefficients; x; y
:control: $x+y$ in the place of $x-y$
:::
*/
CLAIM(bezout_matrix_is_the_divided_difference)
{
    int n = T->degree;
    num a[MAX_ORDER + 1], b[MAX_ORDER + 1], M[MAX_ORDER * MAX_ORDER], x = parameter(T, "x"), y = parameter(T, "y");
    for (int i = 0; i <= n; i++) {
        a[i] = unknown(T, "a", i);
        b[i] = unknown(T, "b", i);
    }
    G(bezout)(n, a, b, M);
    num sum = from_int(0);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            sum = add(sum, mul(M[i * n + j], mul(G(power)(x, n - 1 - i), G(power)(y, n - 1 - j))));
    num right = sub(mul(G(horner)(n, a, x), G(horner)(n, b, y)), mul(G(horner)(n, a, y), G(horner)(n, b, x)));
    /* (x - y) Σ M_ij x^{n-1-i} y^{n-1-j} = a(x) b(y) - a(y) b(x) */
    same(T, mul(fault(T, sub(x, y), add(x, y)), sum), right);
}

/*
What the two determinants are worth is said by the roots.  From the product of the differences one reads that they
vanish exactly for a common root, when the leading coefficients do not vanish, and how their degrees in the
coefficients arise.

:::{claim} resultant_is_the_product_of_differences
:title: Both resultants are the product of the differences of the roots
:zh: 结式等于根差之积
:given: $a=a_0\prod_{i\le m}(z-\alpha_i)$, $b=b_0\prod_{j\le n}(z-\beta_j)$, $m=1,\dots,n$; for Bézout's $m=n$
:then: the determinants of Sylvester and, with the sign $(-1)^{n(n-1)/2}$, of Bézout are
  $a_0^nb_0^m\prod_{i,j}(\alpha_i-\beta_j)$
:method: The coefficients are multiplied out from the roots, which are variables.
:defines: resultant bezout_resultant
:degrees: 1..4 sampled 7
:over: a# b#: leading coefficients; p# q#: roots
:control: the power $a_0^{n-1}$
:::
*/
/* The coefficients of lead (z - root_0) ... (z - root_{n-1}), the leading one first. */
static void G(from_roots)(int n, num lead, const num roots[], num a[])
{
    a[0] = lead;
    for (int k = 0; k < n; k++) {
        a[k + 1] = from_int(0);
        for (int i = k + 1; i > 0; i--)
            a[i] = sub(a[i], mul(roots[k], a[i - 1]));
    }
}

CLAIM(resultant_is_the_product_of_differences)
{
    int n = T->degree;
    num alpha[MAX_ORDER], beta[MAX_ORDER], a[MAX_ORDER + 1], b[MAX_ORDER + 1];
    num a0 = positive(T, "a", 0), b0 = positive(T, "b", 0);
    for (int i = 0; i < n; i++) {
        alpha[i] = unknown(T, "p", i);
        beta[i] = unknown(T, "q", i);
    }
    G(from_roots)(n, b0, beta, b);
    for (int m = 1; m <= n; m++) {
        G(from_roots)(m, a0, alpha, a);
        /* a_0^n b_0^m Π (α_i - β_j) */
        num product = mul(G(power)(a0, fault(T, n, n - 1)), G(power)(b0, m));
        for (int i = 0; i < m; i++)
            for (int j = 0; j < n; j++)
                product = mul(product, sub(alpha[i], beta[j]));
        about(T, "Sylvester's determinant");
        same(T, G(resultant)(m, a, n, b), product);
    }
    num product = mul(G(power)(a0, fault(T, n, n - 1)), G(power)(b0, n));
    for (int k = 0; k < n * n; k++)
        product = mul(product, sub(alpha[k / n], beta[k % n]));
    about(T, "Bézout's determinant with its sign");
    same(T, G(bezout_resultant)(n, a, b), product);
}

#include "chapters/judge/claims_off.h"
