/*
# Implicitization (隐式化)

A plane rational curve has the three polynomials $A(u)=\sum\binom ni\omega_ix_iu^{n-i}$,
$B(u)=\sum\binom ni\omega_iy_iu^{n-i}$ and $W(u)=\sum\binom ni\omega_iu^{n-i}$ in a new parameter $u$: its points are
$(A/W,B/W)$.  A point $(x,y)$ is on it when $A-xW$ and $B-yW$ have a common root, and that is what a resultant (结式)
recognises.  First the tools: determinants and resultants, each against its definition.
*/
#include "exact/record/resultant.h"
#include "exact/record/roots.h"
#include "exact/record/sturm.h"

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

/* The sum over the permutations of rows i, ..., n-1 into the columns not yet used. */
static num G(leibniz)(int n, const num M[], int i, unsigned used)
{
    if (i == n)
        return from_int(1);
    num sum = from_int(0);
    int before = 0; /* free columns to the left of j: as many exchanges */
    for (int j = 0; j < n; j++)
        if (!(used >> j & 1)) {
            num term = mul(M[i * n + j], G(leibniz)(n, M, i + 1, used | 1u << j));
            sum = before++ % 2 == 0 ? add(sum, term) : sub(sum, term);
        }
    return sum;
}

/*
:::{claim} determinant_is_the_sum_over_permutations
:title: The determinant without division is Leibniz' sum
:zh: 无除法行列式等于 Leibniz 展开
:given: an $n\times n$ matrix
:then: Bird's algorithm returns $\sum_\sigma\operatorname{sgn}\sigma\prod_iM_{i,\sigma(i)}$
:method: The sum is taken over all permutations, column by column, in every arithmetic.
:defines: determinant
:degrees: 1..5 sampled 6
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

static num G(horner)(int n, const num a[], num z)
{
    num sum = a[0];
    for (int i = 1; i <= n; i++)
        sum = add(mul(sum, z), a[i]);
    return sum;
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
:::{claim} bezout_matrix_is_the_divided_difference
:title: Bézout's matrix gives the divided difference of a and b
:zh: Bézout 矩阵的定义式
:given: polynomials $a$ and $b$ of degree $n$, any $x$ and $y$
:then: $(x-y)\sum M_{ij}x^{n-1-i}y^{n-1-j}=a(x)b(y)-a(y)b(x)$
:method: With $x$ and $y$ variables the identity determines every entry.
:defines: bezout
:degrees: 1..6 sampled 10
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
    same(T, mul(fault(T, sub(x, y), add(x, y)), sum), right);
}

/*
:::{claim} resultant_is_the_product_of_differences
:title: Both resultants are the product of the differences of the roots
:zh: 结式等于根差之积
:given: $a=a_0\prod_{i\le m}(z-\alpha_i)$, $b=b_0\prod_{j\le n}(z-\beta_j)$, $m=1,\dots,n$; for Bézout's $m=n$
:then: the determinants of Sylvester and, with the sign $(-1)^{n(n-1)/2}$, of Bézout are
  $a_0^nb_0^m\prod_{i,j}(\alpha_i-\beta_j)$
:method: The coefficients are multiplied out from the roots, which are variables.
:defines: resultant bezout_resultant
:degrees: 1..4 sampled 7
:control: the power $a_0^m$
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
        num product = mul(G(power)(a0, fault(T, n, m)), G(power)(b0, m));
        for (int i = 0; i < m; i++)
            for (int j = 0; j < n; j++)
                product = mul(product, sub(alpha[i], beta[j]));
        about(T, "Sylvester's determinant");
        same(T, G(resultant)(m, a, n, b), product);
    }
    if (!T->faulty) {
        num product = mul(G(power)(a0, n), G(power)(b0, n));
        for (int k = 0; k < n * n; k++)
            product = mul(product, sub(alpha[k / n], beta[k % n]));
        about(T, "Bézout's determinant with its sign");
        same(T, G(bezout_resultant)(n, a, b), product);
    }
}

/* A rational curve of the plane in the judge's numbers. */
static void G(plane_curve)(trial *T, int n, num R[], num w[])
{
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        R[2 * i] = unknown(T, "x", i);
        R[2 * i + 1] = unknown(T, "y", i);
    }
}

/*
:::{claim} implicit_value_is_the_printed_determinant
:title: F is the determinant (3.4.1) with the entries (3.4.2)
:zh: F 即 (3.4.1) 的行列式
:given: points and weights, any $x,y$
:then: $a_i=\binom ni\omega_i(x_i-x)$, and Bézout's way to $F$ gives the determinant of the $2n\times2n$ matrix with $n$
  shifted rows $a_0,\dots,a_n$ over $n$ shifted rows $b_0,\dots,b_n$
:method: Entries by Pascal's triangle; the determinant of the large matrix as the sum over permutations, so that nothing
  is shared but the points.
:defines: implicit_coefficients implicit_value
:degrees: 1..3
:control: the rows of the $a_i$ shifted once less
:::
*/
static long G(pascal)(int n, int i)
{
    return i < 0 || i > n ? 0 : n == 0 ? 1 : G(pascal)(n - 1, i - 1) + G(pascal)(n - 1, i);
}

CLAIM(implicit_value_is_the_printed_determinant)
{
    int n = T->degree;
    num R[2 * MAX_ORDER + 2], w[MAX_ORDER + 1], a[MAX_ORDER + 1], M[MAX_ORDER * MAX_ORDER];
    num x = parameter(T, "x"), y = parameter(T, "y");
    G(plane_curve)(T, n, R, w);
    G(implicit_coefficients)(n, R, w, 0, x, a);
    for (int k = 0; k < 4 * n * n; k++)
        M[k] = from_int(0);
    for (int i = 0; i <= n; i++) {
        num factor = mul(from_int(G(pascal)(n, i)), w[i]);
        num ai = mul(factor, sub(R[2 * i], x)), bi = mul(factor, sub(R[2 * i + 1], y));
        about(T, "the entries a_i");
        same(T, a[i], ai);
        for (int k = 0; k < n; k++) {
            int column = fault(T, k + i, k > 0 ? k - 1 + i : k + i);
            M[k * 2 * n + column] = ai;
            M[(n + k) * 2 * n + k + i] = bi;
        }
    }
    about(T, "F(x, y)");
    same(T, G(implicit_value)(n, R, w, x, y), G(leibniz)(2 * n, M, 0, 0));
}

/*
## The equations of a point

:::{statement} wang-ch3:3.4.1
:title: F is the determinant of the 2n × 2n matrix of the a and the b
:zh: F(x,y) 的行列式
:printed: F(x,y)=\begin{vmatrix}a_0&a_1&\cdots&a_n\\&\ddots&&&\ddots\\b_0&b_1&\cdots&b_n\\&\ddots&&&\ddots
  \end{vmatrix}_{(2n)\times(2n)}
:definition: yes
:checked-by: implicit_value_is_the_printed_determinant

The implicit equation that the theorem speaks of is $F(x,y)=0$; the display gives $F$.
:::

:::{statement} wang-ch3:3.4.2
:title: The entries of the determinant
:zh: 行列式元素 a_i, b_i
:printed: a_i=\binom ni\omega_i(x_i-x),\quad b_i=\binom ni\omega_i(y_i-y),\quad i=0,\dots,n
:definition: yes
:checked-by: implicit_value_is_the_printed_determinant
:::

:::{statement} wang-ch3:3.4.3
:title: The change of parameter and its inverse
:zh: 参数变换及其逆
:printed: t=\frac{au+b}{u+1},\ 0\le u\le+\infty;\qquad u=\frac{b-t}{t-a},\ a\le t\le b
:holds-by: parameter_change_and_its_inverse
:needs: parameter_change_needs_two_ends | the interval is not a point, $a<b$

$t$ decreases from $b$ to $a$ while $u$ increases from $0$ to $+\infty$; the value $u=+\infty$ stands for $t=a$.
:::

:::{claim} parameter_change_and_its_inverse
:title: The two formulas are inverse to each other and map the ranges as stated
:zh: 两式互逆且区间对应
:given: $b=a+l$, $l>0$, $u>0$
:then: $t-a=\frac{b-a}{u+1}\ge0$, $b-t=\frac{u(b-a)}{u+1}\ge0$, $\frac{b-t}{t-a}=u$; and for $a<t\le b$, $t=b-ls$,
  the number $u=\frac{b-t}{t-a}\ge0$ is mapped back to $t$
:method: Identities in $a$, $l$, $u$, $s$; the signs are those of the coefficients, $s$ running through $(0,1)$.
:control: $t=(bu+a)/(u+1)$
:::
*/
CLAIM(parameter_change_and_its_inverse)
{
    num a = parameter(T, "a"), l = parameter(T, "l"), u = parameter(T, "u"), s = inside(T, "s");
    num b = add(a, l), one = from_int(1), u1 = add(u, one);
    num t = fault(T, div(add(mul(a, u), b), u1), div(add(mul(b, u), a), u1));
    about(T, "t - a and b - t");
    same(T, sub(t, a), div(l, u1));
    same(T, sub(b, t), div(mul(u, l), u1));
    nonnegative(T, div(l, u1));
    nonnegative(T, div(mul(u, l), u1));
    about(T, "from u to t and back");
    same(T, div(sub(b, t), sub(t, a)), u);
    num at = sub(b, mul(l, s)), back = div(sub(b, at), sub(at, a));
    about(T, "from t to u and back");
    nonnegative(T, div(s, sub(one, s)));
    same(T, back, div(s, sub(one, s)));
    same(T, div(add(mul(a, back), b), add(back, one)), at);
}

#if RATIONAL
/*
:::{claim} parameter_change_needs_two_ends
:title: On an interval of one point the change of parameter has no inverse
:zh: 区间退化时参数变换不可逆
:kind: counterexample
:data: a = 1; b = 1; u = 0 2
:instead: b = 3
:result: t = 1 1
:given: an interval of one point, $a=b$, and two values of $u$
:then: both give the same $t$, so no formula gives $u$ from $t$
:method: Both values of $t$ are computed; that they differ is what is compared.
:control: another end $b$
:::
*/
CLAIM(parameter_change_needs_two_ends)
{
    num a = given(T, "a"), b = given(T, "b"), u[2], t[2];
    given_points(T, "u", 2, 1, u);
    for (int k = 0; k < 2; k++)
        t[k] = div(add(mul(a, u[k]), b), add(u[k], from_int(1)));
    found_points(T, "t", 2, 1, t);
    about(T, "the two t differ");
    refute(T, equal_q(t[0], t[1]));
}
#endif

/*
:::{statement} wang-ch3:3.4.4
:title: The curve in the new parameter
:zh: 新参数下的曲线
:printed: \mathbf R(t)=(x,y)=\Bigl(\frac{\sum\binom ni\omega_ix_iu^{n-i}}{\sum\binom ni\omega_iu^{n-i}},
  \frac{\sum\binom ni\omega_iy_iu^{n-i}}{\sum\binom ni\omega_iu^{n-i}}\Bigr),\quad 0\le u\le+\infty
:holds-by: curve_in_the_new_parameter

At $u=+\infty$ it is read as a limit: $R_0=R(a)$, as $\omega_0\ne0$.
:::
*/

/* sum C(n,i) p_i u^{n-i} */
static num G(in_u)(int n, const num p[], num u)
{
    num sum = from_int(0);
    for (int i = 0; i <= n; i++)
        sum = add(sum, mul(mul(from_int(binomial(n, i)), p[i]), G(power)(u, n - i)));
    return sum;
}

/*
:::{claim} curve_in_the_new_parameter
:title: The substitution turns the Bernstein form into powers of u
:zh: 代换后的幂形式
:given: weights, one coordinate, $n\ge1$, $u$ and $\lambda=(t-a)/(b-a)=1/(1+u)$
:then: $R(t)=A(u)/W(u)$, its value at $u=0$ is $R_n$, and with $v=1/u$ its value at $v=0$ is $R_0$
:method: The left side by de Casteljau's algorithm at $1/(1+u)$, the right side as printed; $u^nA(1/u)$ and
  $u^nW(1/u)$ for the end $u=\infty$.
:degrees: 1..6 sampled 12
:control: $u^i$ in the place of $u^{n-i}$
:::
*/
CLAIM(curve_in_the_new_parameter)
{
    int n = T->degree;
    num R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], wR[MAX_DEGREE + 1], u = parameter(T, "u"), zero = from_int(0), point;
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        R[i] = unknown(T, "R", i);
        wR[i] = mul(w[i], R[i]);
    }
    G(rational_point)(n, 1, R, w, div(from_int(1), add(from_int(1), u)), &point);
    num x[MAX_DEGREE + 1], v[MAX_DEGREE + 1]; /* the coefficients in the order of the powers of 1/u */
    for (int i = 0; i <= n; i++) {
        x[i] = wR[n - i];
        v[i] = w[n - i];
    }
    about(T, "the point of the curve");
    same(T, point, fault(T, div(G(in_u)(n, wR, u), G(in_u)(n, w, u)), div(G(in_u)(n, x, u), G(in_u)(n, v, u))));
    about(T, "u = 0");
    same(T, div(G(in_u)(n, wR, zero), G(in_u)(n, w, zero)), R[n]);
    about(T, "u = ∞");
    same(T, div(G(in_u)(n, x, zero), G(in_u)(n, v, zero)), R[0]);
}

/*
:::{statement} wang-ch3:3.4.5
:title: The two polynomial equations of a point of the curve
:zh: 曲线上点所满足的两个方程
:printed: \sum_{i=0}^na_iu^{n-i}=0,\quad\sum_{i=0}^nb_iu^{n-i}=0
:holds-by: equations_of_a_point
:needs: base_point_satisfies_the_equations | the weights are positive, so that the denominator does not vanish for
  $u\ge0$; else both equations may hold for every $(x,y)$

Equivalent to (3.4.4), for the same $u$, because $\sum a_iu^{n-i}=W(u)(A/W-x)$ and $W(u)>0$.
:::

:::{claim} equations_of_a_point
:title: The two sums are the denominator times the distance from the point of the curve
:zh: 两方程等价于点在曲线上
:given: weights and points, $n\ge1$, any $x$, $u\ge0$
:then: $\sum a_iu^{n-i}=W(u)\,(X(u)-x)$ with the point $X(u)$ of the curve, and $W(u)\ge\omega_n>0$
:method: An identity in $x$ and $u$, with $X$ by de Casteljau's algorithm.  $W(u)-\omega_n$ has no negative coefficient.
  So for $u\ge0$ the sum vanishes if and only if $x=X(u)$; for $y$ the same.
:degrees: 1..6 sampled 12
:control: the binomial coefficients left out of the $a_i$
:::
*/
CLAIM(equations_of_a_point)
{
    int n = T->degree;
    num R[2 * MAX_ORDER + 2], P[MAX_ORDER + 1], w[MAX_ORDER + 1], a[MAX_ORDER + 1], point;
    num x = parameter(T, "x"), u = parameter(T, "u");
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        P[i] = R[2 * i] = unknown(T, "x", i);
        R[2 * i + 1] = from_int(0);
    }
    G(implicit_coefficients)(n, R, w, 0, x, a);
    for (int i = 0; i <= n; i++)
        a[i] = fault(T, a[i], mul(w[i], sub(P[i], x)));
    G(rational_point)(n, 1, P, w, div(from_int(1), add(from_int(1), u)), &point);
    about(T, "the left side of the first equation");
    same(T, G(horner)(n, a, u), mul(G(in_u)(n, w, u), sub(point, x)));
    about(T, "W(u) - ω_n");
    nonnegative(T, sub(G(in_u)(n, w, u), w[n]));
}

#if RATIONAL
/*
:::{claim} base_point_satisfies_the_equations
:title: Where numerators and denominator vanish together both equations hold for every point
:zh: 基点处两方程对一切点成立
:kind: counterexample
:data: R = (0,0) (0,0); ω = 1 -1; P = (5,7); u = 1
:instead: ω = 1 1
:result: a_0, a_1 = -5 5; b_0, b_1 = -7 7; the sums = 0 0
:given: $n=1$, a polygon $R$ of one point, two weights whose sum is 0, so that $A$, $B$ and $W$ vanish at the parameter $u$;
  and another point $P$
:then: $\sum a_iu^{1-i}=\sum b_iu^{1-i}=0$ although $P$ is not on the curve, which is the point $R_0$
:method: Both sums are computed; that one of them differs from 0 is what is compared.
:control: equal weights
:::
*/
CLAIM(base_point_satisfies_the_equations)
{
    num R[4], w[2], P[2], a[2], b[2];
    given_points(T, "R", 2, 2, R);
    given_points(T, "ω", 2, 1, w);
    given_points(T, "P", 1, 2, P);
    num u = given(T, "u");
    G(implicit_coefficients)(1, R, w, 0, P[0], a);
    G(implicit_coefficients)(1, R, w, 1, P[1], b);
    num sum[2] = {G(horner)(1, a, u), G(horner)(1, b, u)};
    found_points(T, "a_0, a_1", 2, 1, a);
    found_points(T, "b_0, b_1", 2, 1, b);
    found_points(T, "the sums", 2, 1, sum);
    about(T, "one of the sums differs from 0");
    refute(T, is_zero_q(sum[0]) && is_zero_q(sum[1]));
}
#endif

/*
## When is a point on the curve?

The proof says: exactly when the two equations have a common root, or $a_0=b_0=0$.  A common root, in the theory of
resultants, is any complex number.  But the parameter $u$ runs through $0\le u\le+\infty$ only, and a common root
elsewhere gives a point off the arc, or no point at all.

:::{statement} wang-ch3:thm-3.4.1-step-iff
:title: A point is on the curve if and only if the equations have a common root, or a_0 = b_0 = 0
:zh: 点在曲线上当且仅当两式有公根
:printed: $(x,y)$ is a point of the curve if and only if the two polynomials of (3.4.5) have a common root or
  $a_0=b_0=0$ ($x=x_0$, $y=y_0$)
:class: missing-hypothesis
:refuted-by: common_root_of_a_point_off_the_arc common_root_of_an_isolated_point
:reading: common_root_of_a_point_off_the_arc | a common root, real or complex
:reading: nonnegative_common_roots_are_the_points | a common root in the range $0\le u\le+\infty$ of (3.4.4), if that is
  carried over
:corrected: for positive weights $(x,y)$ is a point of the curve if and only if the two polynomials have a common root
  $u\ge0$, or $a_0=b_0=0$
:corrected-by: parameter_change_and_its_inverse equations_of_a_point nonnegative_common_roots_are_the_points
:figure: implicit_points

Only the direction from the curve to the common root is used in the proof, and that one is right.
:::

:::{claim} equation_vanishes_on_the_curve
:title: The determinant vanishes at every point of the curve, whatever the weights
:zh: 曲线上各点处 F=0
:given: weights and points, $n\ge1$, any $u$ with $W(u)\ne0$; and the point $R_0$
:then: at $(x,y)=(A(u)/W(u),B(u)/W(u))$ the matrix of (3.4.1) maps $(u^{2n-1},\dots,u,1)$ to 0; at $R_0$ its first
  column is 0; so $F=0$
:method: A square matrix that maps a vector with an entry 1 to 0 has determinant 0.  The product is formed in the
  field, the point by de Casteljau's algorithm; weights, points and $u$ are variables.
:degrees: 1..6 sampled 10
:control: the point taken at $2u$
:::
*/
CLAIM(equation_vanishes_on_the_curve)
{
    int n = T->degree;
    num R[2 * MAX_ORDER + 2], w[MAX_ORDER + 1], a[MAX_ORDER + 1], b[MAX_ORDER + 1], M[MAX_ORDER * MAX_ORDER], point[2];
    num u = parameter(T, "u"), at = fault(T, u, mul(from_int(2), u));
    G(plane_curve)(T, n, R, w);
    G(rational_point)(n, 2, R, w, div(from_int(1), add(from_int(1), at)), point);
    G(implicit_coefficients)(n, R, w, 0, point[0], a);
    G(implicit_coefficients)(n, R, w, 1, point[1], b);
    G(sylvester)(n, a, n, b, M);
    about(T, "the rows of the matrix times the powers of u");
    for (int i = 0; i < 2 * n; i++) {
        num row = from_int(0);
        for (int j = 0; j < 2 * n; j++)
            row = add(mul(row, u), M[i * 2 * n + j]);
        vanishes(T, row);
    }
    G(implicit_coefficients)(n, R, w, 0, R[0], a);
    G(implicit_coefficients)(n, R, w, 1, R[1], b);
    G(sylvester)(n, a, n, b, M);
    about(T, "the first column at the point R_0");
    for (int i = 0; i < 2 * n; i++)
        vanishes(T, M[i * 2 * n]);
}

#if !FIELD
/*
:::{claim} implicit_value_vanishes_on_the_curve
:title: The value of F at points of the curve is 0
:zh: F 在曲线上之值为零
:types: rational interval double
:given: weights and points, $n\ge1$, any parameter
:then: $F(R(t))=0$
:method: The second way: the determinant itself, by Bézout's matrix.
:degrees: 1..6 sampled 8
:control: the point moved by $(1,0)$
:::
*/
CLAIM(implicit_value_vanishes_on_the_curve)
{
    int n = T->degree;
    num R[2 * MAX_ORDER + 2], w[MAX_ORDER + 1], point[2];
    G(plane_curve)(T, n, R, w);
    G(rational_point)(n, 2, R, w, parameter(T, "t"), point);
    point[0] = fault(T, point[0], add(point[0], from_int(1)));
    vanishes(T, G(implicit_value)(n, R, w, point[0], point[1]));
}
#endif

#if RATIONAL
/* The common part in u of the two polynomials (3.4.5), from the coefficients of u^n, ..., 1. */
static poly common_in_u(int n, const num_q R[], const num_q w[], num_q x, num_q y)
{
    num_q a[MAX_ORDER + 1], b[MAX_ORDER + 1], p[MAX_ORDER + 1], q[MAX_ORDER + 1];
    implicit_coefficients_q(n, R, w, 0, x, a);
    implicit_coefficients_q(n, R, w, 1, y, b);
    for (int i = 0; i <= n; i++) {
        p[i] = a[n - i];
        q[i] = b[n - i];
    }
    return poly_gcd(poly_from_q(n + 1, p), poly_from_q(n + 1, q));
}

/* Is (x, y) on the arc 0 <= t <= 1 of the curve with positive weights?  Decided in t, in Bernstein form. */
static int on_the_arc(int n, const num_q R[], const num_q w[], num_q x, num_q y)
{
    num_q p[MAX_ORDER + 1], q[MAX_ORDER + 1];
    for (int i = 0; i <= n; i++) {
        p[i] = mul(w[i], sub(R[2 * i], x));
        q[i] = mul(w[i], sub(R[2 * i + 1], y));
    }
    poly common = poly_gcd(poly_from_bernstein(n, p), poly_from_bernstein(n, q));
    return poly_is_zero(common) || count_roots(common, from_int(0), from_int(1), CLOSED).distinct > 0;
}

/* The criterion of the proof, with any common root or with one that is >= 0. */
static int has_common_root(int n, const num_q R[], const num_q w[], num_q x, num_q y, int nonnegative_only)
{
    poly common = common_in_u(n, R, w, x, y);
    if (poly_is_zero(common) || (equal_q(x, R[0]) && equal_q(y, R[1])))
        return 1;
    if (!nonnegative_only)
        return poly_degree(common) > 0;
    num_q zero = from_int(0);
    int roots = is_zero_q(poly_value(common, zero)) || count_roots_above(common, zero).distinct > 0;
    int sturm = is_zero_q(poly_value(common, zero)) || sturm_count_above(common, zero) > 0;
    if (roots != sturm)
        region_faults |= FAULT_UNABLE;
    return roots;
}

/* For the data R, ω and P of the claim, of degree n: the criterion with any common root, in the control with one that is
 * >= 0, says of P what membership in the arc says. */
static void compare_with_the_arc(trial *T, int n)
{
    num_q R[2 * MAX_ORDER + 2], w[MAX_ORDER + 1], P[2];
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    given_points(T, "P", 1, 2, P);
    int member = on_the_arc(n, R, w, P[0], P[1]);
    found_text(T, "common factor", poly_to_string(common_in_u(n, R, w, P[0], P[1]), "u"));
    found(T, "F(P)", implicit_value_q(n, R, w, P[0], P[1]));
    found_text(T, "P is on the arc", member ? "yes" : "no");
    about(T, "a common root exists exactly if the point is on the curve");
    agree(T, has_common_root(n, R, w, P[0], P[1], fault(T, 1, 0)) == member);
}

/*
:::{claim} common_root_of_a_point_off_the_arc
:title: A point on the line, not on the segment, has a common root
:zh: 线段外的点也有公根
:kind: counterexample
:data: R = (0,0) (1,0); ω = 1 1; P = (2,0)
:result: common factor = "u+1/2"; F(P) = 0; P is on the arc = "no"
:given: $n=1$, the ends $R$ of a segment with equal weights, and a point $P$ of its line beyond $R_1$
:then: the two polynomials have a common root $u<0$, and $F$ is 0 at $P$; the point is not on the segment
:method: The common root by the greatest common divisor in $u$; membership in the arc by the roots in $[0,1]$ of the
  greatest common divisor in $t$.
:control: roots $u\ge0$ only
:::
*/
CLAIM(common_root_of_a_point_off_the_arc) { compare_with_the_arc(T, 1); }

/*
:::{claim} common_root_of_an_isolated_point
:title: An isolated point has complex common roots and is on no real arc
:zh: 孤立点有复公根而不在实弧上
:kind: counterexample
:data: R = (0,0) (0,1/3) (1/3,2/3) (1,2); ω = 1 1 1 1; P = (-1,0)
:result: common factor = "u^2 + 2*u + 2"; F(P) = 0; P is on the arc = "no"
:given: the points $R$ of the cubic $(t^2,t^3+t)$, equal weights, and the point $P$ of the parameters $t=\pm\mathrm i$
:then: the polynomials have a common factor of degree 2 with complex roots; $F$ is 0 at $P$, and the point is not on the
  curve, for no real parameter
:method: As for the point off the arc.
:control: roots $u\ge0$ only
:::
*/
CLAIM(common_root_of_an_isolated_point) { compare_with_the_arc(T, 3); }

/*
:::{claim} nonnegative_common_roots_are_the_points
:title: Common roots u ≥ 0, or R_0, are exactly the points of the arc
:zh: 非负公根与弧上的点一一对应
:kind: decision
:data: line = (0,0,1) (1,0,1); doubled line = (0,0,1) (0,0,1) (1,1,1); parabola = (0,0,1) (1/2,0,1) (1,1,1);
  quarter circle = (1,0,1) (1,1,1) (0,1,2); the same elevated = (1,0,3) (1,2/3,3) (1/2,1,4) (0,1,6);
  nodal cubic = (0,0,1) (9,8,1) (-5,8,1) (4,0,1); cubic with an isolated point = (0,0,1) (0,1/3,1) (1/3,2/3,1) (1,2,1);
  t = -2 -1/2 0 1/3 1/2 1 3/2 3; offset = 1/7; P = (-1,0)
:result: points on the arcs = 32; points off the arcs = 87
:given: seven curves, each by its points and weights $(x_i,y_i,\omega_i)$, the weights positive; for each curve the points of the
  parameters $t$ of its line of parameters, each of them moved off by the offset in the direction of the first axis, and
  the isolated point $P$ of the last curve
:then: the criterion with roots $u\ge0$ agrees with membership in the arc
:method: As above; the roots are counted in two ways.  For all curves with positive weights it follows from the
  bijection $u=(b-t)/(t-a)$ of $(a,b]$ and $[0,\infty)$ and from $\sum a_iu^{n-i}=W(u)(X(u)-x)$, $W(u)>0$.
:scope: 7 curves, 17 points each
:control: any common root
:::
*/
CLAIM(nonnegative_common_roots_are_the_points)
{
    enum { PARAMETERS = 8, MOST = 4 };
    static const struct {
        const char *name;
        int n;
    } curve[] = {{"line", 1},
                 {"doubled line", 2},
                 {"parabola", 2},
                 {"quarter circle", 2},
                 {"the same elevated", 3},
                 {"nodal cubic", 3},
                 {"cubic with an isolated point", 3}};
    int on = 0, off = 0;
    num t[PARAMETERS], isolated[2], points[3 * MOST], R[2 * MOST], w[MOST], X[2];
    given_points(T, "t", PARAMETERS, 1, t);
    num offset = given(T, "offset");
    given_points(T, "P", 1, 2, isolated);
    for (unsigned k = 0; k < sizeof curve / sizeof *curve; k++) {
        int n = curve[k].n;
        given_points(T, curve[k].name, n + 1, 3, points);
        for (int i = 0; i <= n; i++) {
            R[2 * i] = points[3 * i];
            R[2 * i + 1] = points[3 * i + 1];
            w[i] = points[3 * i + 2];
        }
        for (int p = 0; p <= 2 * PARAMETERS; p++) {
            X[0] = isolated[0], X[1] = isolated[1];
            if (p < 2 * PARAMETERS)
                rational_point_q(n, 2, R, w, t[p / 2], X);
            if (p < 2 * PARAMETERS && p % 2 == 1)
                X[0] = add(X[0], offset);
            int member = on_the_arc(n, R, w, X[0], X[1]);
            agree(T, has_common_root(n, R, w, X[0], X[1], fault(T, 1, 0)) == member);
            on += member;
            off += !member;
        }
    }
    found_whole(T, "points on the arcs", on);
    found_whole(T, "points off the arcs", off);
}
#endif

/*
## The theorem

$F$ vanishes on the curve.  Is $F=0$ then the equation of the curve?  Not if $F$ is 0 everywhere, and that happens
exactly when $A$, $B$, $W$ have a common zero, $u=\infty$ included.  It happens more often than one would think:
elevating the degree multiplies all three by $1+u$, so for every elevated curve, with positive weights, the
determinant is identically 0.

:::{statement} wang-ch3:thm-3.4.1
:title: A plane rational Bézier curve has the implicit equation F = 0
:zh: 平面有理曲线可化为隐式方程
:printed: the curve of degree $n$ with $\mathbf R_i=(x_i,y_i)$ can be turned into the implicit equation (3.4.1)
:holds-by: equation_vanishes_on_the_curve top_form_is_a_resultant
:hypothesis: elevated_curve_has_no_equation | $A$, $B$, $W$ have no common zero (no base point, $u=\infty$
  included); else $F$ is 0 for all $(x,y)$
:needs: end_weight_zero_gives_no_equation | the weights are positive; with $\omega_0=0$ the first column vanishes
:needs: space_curve_and_its_shadow | the curve is plane; for a curve of space $F=0$ is only the cylinder over its
  projection
:reading: equation_vanishes_on_the_curve | every point of the curve satisfies $F=0$: true without any hypothesis
:reading: common_root_of_a_point_off_the_arc | the points with $F=0$ are those of the curve: false; there are the
  points of the other parameters, and isolated points
:figure: implicit_elevation

That $F$ is 0 then is `common_zero_makes_the_equation_vanish`; that every elevated curve is such a one,
`elevation_multiplies_by_one_plus_u`.  An improper parametrisation does no harm as long as there is no base point: the determinant is then a power of the
equation, such as $(x-y)^2$ for the points $(0,0),(0,0),(1,1)$.  The curve of space is drawn in `implicit_shadow`.
:::

:::{claim} top_form_is_a_resultant
:title: The terms of degree n of F are Res(W, yA - xB)
:zh: F 的最高次部分
:given: polynomials $A$, $B$, $W$ of degree $n$, any $x,y,z$
:then: $x^n\operatorname{Res}(zA-xW,zB-yW)=z^n\operatorname{Res}(zA-xW,xB-yA)$ and
  $\operatorname{Res}(-xW,xB-yA)=x^n\operatorname{Res}(W,yA-xB)$
:method: $z^{-n}\operatorname{Res}(zA-xW,zB-yW)$ is $F$ made homogeneous, because $F(x/z,y/z)$ is the resultant of
  $A-\frac xzW$ and $B-\frac yzW$, whose degree in the coefficients is $n$ and $n$.  At $z=0$ it is therefore
  $\operatorname{Res}(W,yA-xB)$, the part of degree $n$ of $F$.  For $W\ne0$ that is a constant times the product of
  the forms $yA(u_j)-xB(u_j)$ over the $n$ zeros of $W$, $u=\infty$ included, so it is 0 only if one of them is a
  zero of $A$ and $B$ too.  For every $n$ the identities are the rules
  $\operatorname{Res}(p,q+\lambda p)=\operatorname{Res}(p,q)$ and
  $\operatorname{Res}(p,\lambda q)=\lambda^n\operatorname{Res}(p,q)$.
:degrees: 1..4 sampled 8
:control: $yB-xA$ in the second resultant
:::
*/
CLAIM(top_form_is_a_resultant)
{
    int n = T->degree;
    num A[MAX_ORDER + 1], B[MAX_ORDER + 1], W[MAX_ORDER + 1], p[MAX_ORDER + 1], q[MAX_ORDER + 1], s[MAX_ORDER + 1];
    num x = parameter(T, "x"), y = parameter(T, "y"), z = parameter(T, "z");
    for (int i = 0; i <= n; i++) {
        A[i] = unknown(T, "A", i);
        B[i] = unknown(T, "B", i);
        W[i] = unknown(T, "W", i);
        p[i] = sub(mul(z, A[i]), mul(x, W[i]));
        q[i] = sub(mul(z, B[i]), mul(y, W[i]));
        s[i] = fault(T, sub(mul(x, B[i]), mul(y, A[i])), sub(mul(x, A[i]), mul(y, B[i])));
    }
    num xn = G(power)(x, n), zn = G(power)(z, n);
    about(T, "F made homogeneous");
    same(T, mul(xn, G(bezout_resultant)(n, p, q)), mul(zn, G(bezout_resultant)(n, p, s)));
    for (int i = 0; i <= n; i++) {
        p[i] = neg(mul(x, W[i]));
        s[i] = sub(mul(x, B[i]), mul(y, A[i]));
        q[i] = neg(s[i]);
    }
    about(T, "the part of degree n");
    same(T, G(bezout_resultant)(n, p, s), mul(xn, G(bezout_resultant)(n, W, q)));
}

#if FIELD
/* Refuted if F of the curve (R, w) is the zero polynomial; F is a result. */
static void is_an_equation(trial *T, int n, const num_f R[], const num_f w[])
{
    num_f F = implicit_value_f(n, R, w, variable_f("x"), variable_f("y"));
    found_text(T, "F(x, y)", to_string_f(F));
    about(T, "F is not the zero polynomial");
    refute(T, is_zero_f(F));
}

/*
:::{claim} elevated_curve_has_no_equation
:title: For an elevated parabola the determinant is identically 0
:zh: 升阶抛物线的 F 恒为零
:kind: counterexample
:types: field
:data: R = (0,0) (1/2,0) (1,1); ω = 1 1 1
:result: elevated R = (0,0) (1/3,0) (2/3,1/3) (1,1); F(x, y) = "0"
:given: the points $R$ of the parabola $(t,t^2)$, equal weights, and the points of the next degree
:then: for these $F(x,y)=0$ for all $x$ and $y$
:method: The determinant with $x$ and $y$ variables; that it is not the zero polynomial is what is compared.
:control: the same curve as it is given
:::
*/
CLAIM(elevated_curve_has_no_equation)
{
    num R[6], w[3], Re[8], we[4];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    rational_elevate_f(2, 2, R, w, Re, we);
    found_points(T, "elevated R", 4, 2, Re);
    if (T->faulty)
        is_an_equation(T, 3, Re, we);
    else
        is_an_equation(T, 2, R, w);
}

/*
:::{claim} end_weight_zero_gives_no_equation
:title: With the first weight 0 the determinant is identically 0
:zh: 首权为零时 F 恒为零
:kind: counterexample
:types: field
:data: R = (0,0) (1,2) (3,1); ω = 0 1 1
:instead: ω = 1 1 1
:result: F(x, y) = "0"
:given: $n=2$, three points $R$, and weights of which the first is 0: the curve is the segment from $R_1$ to $R_2$
:then: $F(x,y)=0$ for all $x$ and $y$
:method: As for the elevated parabola.
:control: equal weights
:::
*/
CLAIM(end_weight_zero_gives_no_equation)
{
    num R[6], w[3];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    is_an_equation(T, 2, R, w);
}
#endif

#if RATIONAL
/*
:::{claim} space_curve_and_its_shadow
:title: For a curve of space F = 0 also holds beside the curve
:zh: 空间曲线的 F=0 只是投影柱面
:kind: counterexample
:data: R = (0,0,0) (1/3,0,1/3) (2/3,1/3,2/3) (1,1,2); ω = 1 1 1 1; t = 1/2; P = (1/2,0,5/8)
:instead: P = (1/2,1/4,5/8)
:result: F(x, z) at P = 0; R(t) = (1/2,1/4,5/8)
:given: the points $R$ of the space cubic $(t,t^2,t^3+t)$, equal weights, the determinant formed from $x$ and $z$, a parameter
  $t$, and a point $P$ of space with the $x$ and the $z$ of $R(t)$
:then: $F=0$ at $P$, but the only point of the curve with that $x$ is $R(t)$, which has another $y$
:method: $F$ and the curve at $t$ are computed; that the point is the curve's whenever $F=0$ is what is compared.
:control: the point $R(t)$ for $P$
:::
*/
CLAIM(space_curve_and_its_shadow)
{
    num R[12], w[4], P[3], shadow[8], point[3];
    given_points(T, "R", 4, 3, R);
    given_points(T, "ω", 4, 1, w);
    num t = given(T, "t");
    given_points(T, "P", 1, 3, P);
    for (int i = 0; i < 4; i++) {
        shadow[2 * i] = R[3 * i];
        shadow[2 * i + 1] = R[3 * i + 2];
    }
    num F = implicit_value_q(3, shadow, w, P[0], P[2]);
    rational_point_q(3, 3, R, w, t, point);
    found(T, "F(x, z) at P", F);
    found_points(T, "R(t)", 1, 3, point);
    about(T, "a point of space with F = 0 is on the curve");
    if (is_zero_q(F) && equal_q(P[0], point[0]))
        agree(T, equal_q(P[1], point[1]));
}
#endif

/*
:::{statement} wang-ch3:thm-3.4.1-step-vanishing
:title: By the theory of resultants F must be 0 at the points of the curve
:zh: 由结式理论 F 必为零
:printed: at the points of the curve the resultant $F(x,y)$ of (3.4.5) is 0
:holds-by: equation_vanishes_on_the_curve

The second way, `implicit_value_vanishes_on_the_curve`, computes the determinant itself at points of curves.
:::

:::{claim} common_zero_makes_the_equation_vanish
:title: A common zero of numerators and denominator makes F identically 0
:zh: 有公共零点时 F 恒为零
:given: $A$, $B$, $W$ with a common zero $\rho$, or $\omega_0=0$; any $x,y$
:then: the matrix of (3.4.1) maps $(\rho^{2n-1},\dots,\rho,1)$ to 0, or has a first column of zeros
:method: The three polynomials are multiplied out from $u-\rho$ and three free cofactors; everything is a variable.
:degrees: 1..6 sampled 10
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
    for (int i = 0; i < 2 * n; i++) {
        num row = from_int(0);
        for (int j = 0; j < 2 * n; j++)
            row = add(mul(row, rho), M[i * 2 * n + j]);
        vanishes(T, row);
    }
    w[0] = from_int(0);
    G(implicit_coefficients)(n, R, w, 0, x, a);
    G(implicit_coefficients)(n, R, w, 1, y, b);
    G(sylvester)(n, a, n, b, M);
    about(T, "the first column for ω_0 = 0");
    for (int i = 0; i < 2 * n; i++)
        vanishes(T, M[i * 2 * n]);
}

/*
:::{claim} elevation_multiplies_by_one_plus_u
:title: Degree elevation multiplies numerators and denominator by 1 + u
:zh: 升阶使分子分母同乘 1+u
:given: weights and one coordinate of the points, $n\ge1$, any $u$
:then: $\hat W(u)=(1+u)W(u)$ and $\hat A(u)=(1+u)A(u)$
:method: The elevated points and weights by the kernel; both sides in the field.  So every elevated curve has the common
  zero $u=-1$.  For every $n$: $\binom{n+1}i\hat\omega_i=\binom ni\omega_i+\binom n{i-1}\omega_{i-1}$.
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
    same(T, G(in_u)(n + 1, we, u), mul(factor, G(in_u)(n, w, u)));
    for (int i = 0; i <= n; i++)
        R[i] = mul(w[i], R[i]);
    for (int i = 0; i <= n + 1; i++)
        Re[i] = mul(we[i], Re[i]);
    about(T, "a numerator");
    same(T, G(in_u)(n + 1, Re, u), mul(factor, G(in_u)(n, R, u)));
}

/*
## The degree

:::{statement} wang-ch3:thm-3.4.2
:title: F is a polynomial of degree at most n
:zh: F 的次数不高于 n
:printed: the polynomial $F(x,y)$ of (3.4.1) has degree at most $n$ in the two variables
:holds-by: bezout_entries_are_linear bezout_matrix_comes_from_the_blocks sylvester_and_bezout_give_one_equation
:figure: implicit_degree

That the two determinants are one is run for the degrees of the scope and argued for every other $n$, in
`bezout_matrix_comes_from_the_blocks`; the rest is for every $n$.  The source's own proof divides by $\omega_0$; for
$\omega_0=0$ the polynomial is 0 and the bound trivial.  Sharper, and decided by `top_form_is_a_resultant`: the degree is exactly $n$, or $F$ is 0 everywhere.
:::

:::{claim} bezout_entries_are_linear
:title: The entries of Bézout's matrix are of degree one in x and y
:zh: Bézout 矩阵的元素是一次的
:given: any numbers $p,q$ in the place of $\binom ni\omega_i$, $\binom nj\omega_j$, any $x_i,y_i,x_j,y_j$
:then: $a_ib_j-a_jb_i=pq\,\bigl(x_iy_j-x_jy_i-(x_i-x_j)y+(y_i-y_j)x\bigr)$
:method: The terms with $xy$ cancel.  The entries of Bézout's matrix are sums of such differences, the matrix has
  $n$ rows, so its determinant has degree at most $n$; for every $n$ and all weights.
:scope: any two pairs of entries, in every degree
:control: $a_ib_j+a_jb_i$
:::
*/
CLAIM(bezout_entries_are_linear)
{
    num p = unknown(T, "p", 0), q = unknown(T, "q", 0), x = parameter(T, "x"), y = parameter(T, "y");
    num x0 = unknown(T, "x", 0), y0 = unknown(T, "y", 0), x1 = unknown(T, "x", 1), y1 = unknown(T, "y", 1);
    num a0 = mul(p, sub(x0, x)), b0 = mul(p, sub(y0, y)), a1 = mul(q, sub(x1, x)), b1 = mul(q, sub(y1, y));
    num left = fault(T, sub(mul(a0, b1), mul(a1, b0)), add(mul(a0, b1), mul(a1, b0)));
    num constant = sub(mul(x0, y1), mul(x1, y0)), linear = sub(mul(sub(y0, y1), x), mul(sub(x0, x1), y));
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
:scope: larger $n$ by argument: both sides have the entries $\sum_{m\le n-1-i}(a_mb_{n+j-i-m}-b_ma_{n+j-i-m})$
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
:scope: larger $n$ by the argument of `bezout_matrix_comes_from_the_blocks`
:control: the sign $(-1)^{n(n+1)/2}$
:::
*/
CLAIM(sylvester_and_bezout_give_one_equation)
{
    int n = T->degree;
    num R[2 * MAX_ORDER + 2], w[MAX_ORDER + 1], a[MAX_ORDER + 1], b[MAX_ORDER + 1], M[MAX_ORDER * MAX_ORDER];
    num x = parameter(T, "x"), y = parameter(T, "y");
    G(plane_curve)(T, n, R, w);
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
:checked-by: column_operations_give_the_corrected_recursion
:::
*/

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
:then: after the operations row $k$ of the $a$ is $a_j^{[\min(j,n-k+1)]}$, $j=0,\dots,2n-k$, from column $k$ on,
  with the corrected recursion, and so for the $b$
:method: The operations are carried out on the matrix of (3.4.1), the recursion on the entries; all entries are
  compared. An operation of this kind does not change a determinant.
:degrees: 1..6 sampled 8
:control: $\Omega_i$ as printed, 0 beyond $n$
:::
*/
CLAIM(column_operations_give_the_corrected_recursion)
{
    int n = T->degree;
    num R[2 * MAX_ORDER + 2], w[MAX_ORDER + 1], f[2][MAX_ORDER + 1], O[MAX_ORDER + 1], M[MAX_ORDER * MAX_ORDER];
    num level[MAX_ORDER / 2 + 1][2 * MAX_ORDER];
    G(plane_curve)(T, n, R, w);
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
  i=r,\dots,r+n-1; \qquad f_i^{[r]}=f_i^{[r-1]},\ i\ge r+n
:class: misprint
:refuted-by: printed_recursion_is_not_the_operations
:corrected: f_i^{[r]}=f_i^{[r-1]}-\Omega_{i-r+1}\,f_{r-1}^{[r-1]},\ i=r,\dots,r+n-1;\qquad f_i^{[r]}=f_i^{[r-1]},\
  i\ge r+n
:corrected-by: column_operations_give_the_corrected_recursion
:figure: implicit_recursion

For $r=1$ the two agree.  From $r=2$ on the printed index runs beyond $n$, where there is no $\omega_i$; even with
$\Omega_i=0$ there, the determinant changes.
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
:result: determinant by the recursion = "x^2-y^2-4*y"; F(x, y) = "x^2+2*x*y+y^2-4*y"
:given: $n=2$, the points $R$ of a parabola and equal weights; in the printed recursion $\Omega_3=0$
:then: the determinant of the staircase is another polynomial than $F$
:method: The staircase with the printed recursion is filled in and its determinant taken, with $x$ and $y$ variables.
:control: the index $i-r+1$
:::
*/
CLAIM(printed_recursion_is_not_the_operations)
{
    enum { n = 2 };
    num R[2 * n + 2], w[n + 1], O[n + 1], f[2][n + 1], M[4 * n * n];
    num level[MAX_ORDER / 2 + 1][2 * MAX_ORDER], x = variable_f("x"), y = variable_f("y");
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    omegas_f(n, w, O);
    implicit_coefficients_f(n, R, w, 0, x, f[0]);
    implicit_coefficients_f(n, R, w, 1, y, f[1]);
    for (int half = 0; half < 2; half++) {
        reduced_entries_f(n, O, f[half], fault(T, 0, 1), level);
        for (int k = 0; k < n; k++)
            for (int column = 0; column < 2 * n; column++) {
                int j = column - k, r = j < n - k ? j : n - k;
                M[(half * n + k) * 2 * n + column] = j < 0 ? from_int(0) : level[r][j];
            }
    }
    num staircase = determinant_f(2 * n, M), F = implicit_value_f(n, R, w, x, y);
    found_text(T, "determinant by the recursion", to_string_f(staircase));
    found_text(T, "F(x, y)", to_string_f(F));
    about(T, "the determinant, left with the recursion, right (3.4.1)");
    same(T, staircase, F);
}
#endif

/*
:::{statement} wang-ch3:thm-3.4.2-step-columns
:title: Step r subtracts Ω_i times column r from column i+r
:zh: 列初等变换
:printed: from column $i+1$ subtract $\Omega_i$ times column 1, $i=1,\dots,n$; then from column $i+2$ subtract
  $\Omega_i$ times column 2; at last from column $i+n$ subtract $\Omega_i$ times column $n$
:holds-by: column_operations_give_the_corrected_recursion
:needs: end_weight_zero_gives_no_equation | $\omega_0\ne0$, for $\Omega_i$ divides by it; with $\omega_0=0$ the
  determinant is 0 anyway

The columns $i+r\le2n$ exist, and the determinant does not change.
:::

:::{statement} wang-ch3:3.4.8
:title: The determinant after the operations
:zh: 变换后的行列式
:printed: a staircase of the entries $a_j^{[r]}$ over one of the $b_j^{[r]}$ whose first row begins
  $a_0,\ a_1^{[1]},\ \cdots$; the upper indices of the later entries are not legible in the text at hand, which gives
  among others $a_{n-1}^{[n]}$, $a_n^{[n-1]}$ and $a_n^{[n]}$
:reading: column_operations_give_the_corrected_recursion | what the operations give: row $k$, beginning in column
  $k$, is $a_j^{[\min(j,n-k+1)]}$, $j=0,\dots,2n-k$; so the first row is
  $a_0,a_1^{[1]},\dots,a_n^{[n]},a_{n+1}^{[n]},\dots,a_{2n-1}^{[n]}$ and the last of the $a$ is
  $a_0,a_1^{[1]},\dots,a_n^{[1]}$
:reading: an entry $a_{n-1}^{[n]}$, if it is printed: not defined by (3.4.7), which has $i\ge r$
:::

:::{statement} wang-ch3:thm-3.4.2-step-constants
:title: All entries changed at least once are constants; only a_0 and b_0 contain x and y
:zh: 变换后的元素为常数
:printed: $a_i^{[r]},b_i^{[r]}$ ($r=1,\dots,n$, $i\ge r$) are constants, hence in (3.4.8) only $a_0$ contains $x$
  and only $b_0$ contains $y$
:holds-by: changed_entries_are_constants variables_stay_in_the_first_columns
:::

:::{statement} wang-ch3:thm-3.4.2-step-same-columns
:title: a_0 and b_0 stand in the same columns, hence the degree is at most n
:zh: a_0 与 b_0 同列
:printed: $a_0$ and $b_0$ stand in the same columns of (3.4.8), hence the conclusion
:holds-by: variables_stay_in_the_first_columns

The variables stand in $n$ columns, in degree one: a product of one entry from every column has degree at most $n$.
:::

:::{claim} changed_entries_are_constants
:title: The entries of level r ≥ 1 do not depend on x
:zh: r≥1 层的元素与 x 无关
:given: weights with $\omega_0\ne0$, one coordinate of the points, $n\ge1$, two values $x$ and $x'$
:then: $f_i^{[r]}$, $1\le r\le n$, $r\le i<2n$, is the same for both, with the corrected and with the printed recursion
:method: The recursion is run for both values.  $f_i^{[1]}=\binom ni\omega_i(x_i-x_0)$, and later levels are
  combinations of such numbers.
:degrees: 1..6 sampled 10
:control: level 0 included
:::
*/
CLAIM(changed_entries_are_constants)
{
    int n = T->degree;
    num R[2 * MAX_ORDER + 2], w[MAX_ORDER + 1], O[MAX_ORDER + 1], f[MAX_ORDER + 1], g[MAX_ORDER + 1];
    num one[MAX_ORDER / 2 + 1][2 * MAX_ORDER], other[MAX_ORDER / 2 + 1][2 * MAX_ORDER];
    G(plane_curve)(T, n, R, w);
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
:then: the two matrices after the operations differ only in the entries $(k,k)$ and $(n+k,k)$, which are $a_0$ and $b_0$
:method: The operations are carried out on both matrices; all other entries are compared.
:degrees: 1..6 sampled 8
:control: the last of the $n$ steps left out
:::
*/
CLAIM(variables_stay_in_the_first_columns)
{
    int n = T->degree, steps = fault(T, n, n - 1);
    num R[2 * MAX_ORDER + 2], w[MAX_ORDER + 1], O[MAX_ORDER + 1], a[MAX_ORDER + 1], b[MAX_ORDER + 1];
    num M[MAX_ORDER * MAX_ORDER], N[MAX_ORDER * MAX_ORDER];
    G(plane_curve)(T, n, R, w);
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

#include "chapters/judge/claims_off.h"
