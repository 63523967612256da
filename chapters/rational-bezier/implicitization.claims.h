/*
# Implicitization (隐式化)

A plane rational curve has the three polynomials $A(u)=\sum\binom ni\omega_ix_iu^{n-i}$,
$B(u)=\sum\binom ni\omega_iy_iu^{n-i}$ and $W(u)=\sum\binom ni\omega_iu^{n-i}$ in a new parameter $u$: its points are
$(A/W,B/W)$.  A point $(x,y)$ is on it when $A-xW$ and $B-yW$ have a common root, and that is what a resultant (结式)
recognises.
*/
#include "exact/record/resultant.h"
#include "exact/record/roots.h"
#include "exact/record/sturm.h"

#include "chapters/judge/elementary.h"
#include "chapters/rational-bezier/determinants.h"
#include "chapters/rational-bezier/free-curve.h"

#include "chapters/judge/claims_on.h"

/*
## The equations of a point

:::{statement} wang-ch3:3.4.1
:title: F is the determinant of the 2n × 2n matrix of the a and the b
:zh: F(x,y) 的行列式
:printed: F(x,y)=\begin{vmatrix}a_0&a_1&\cdots&a_n\\&\ddots&&&\ddots\\b_0&b_1&\cdots&b_n\\&\ddots&&&\ddots
  \end{vmatrix}_{(2n)\times(2n)}
:definition: yes
:checked-by: rows_of_the_determinant_are_shifted_equations
:confirmed-by: implicit_value_is_the_printed_determinant

There are $n$ rows of the $a$ and $n$ of the $b$, each shifted by one place against the one above it.  What is checked is that such a row is one of the two
equations (3.4.5) times a power of $u$.  The implicit equation that the theorem speaks of is $F(x,y)=0$; the display gives $F$.
:::

:::{statement} wang-ch3:3.4.2
:title: The entries of the determinant
:zh: 行列式元素 a_i, b_i
:printed: a_i=\binom ni\omega_i(x_i-x),\quad b_i=\binom ni\omega_i(y_i-y),\quad i=0,1,\dots,n
:definition: yes
:checked-by: sums_are_the_denominator_times_a_difference
:confirmed-by: implicit_value_is_the_printed_determinant

What is checked is what they are for: the sums $\sum a_iu^{n-i}$ and $\sum b_iu^{n-i}$ are the denominator of (3.4.4) times the differences of the
coordinates of its point and of $(x,y)$.
:::

:::{claim} implicit_value_is_the_printed_determinant
:title: F is the determinant (3.4.1) with the entries (3.4.2)
:zh: F 即 (3.4.1) 的行列式
:given: points and weights, any $x,y$
:then: $a_i=\binom ni\omega_i(x_i-x)$, and Bézout's way to $F$ gives the determinant of the $2n\times2n$ matrix with $n$
  shifted rows $a_0,\dots,a_n$ over $n$ shifted rows $b_0,\dots,b_n$
:method: Entries by factorials; the determinant of the large matrix as the sum over permutations, so that nothing
  is shared but the points.
:defines: implicit_coefficients implicit_value
:degrees: 1..3
:over: x# y#: points; x; y
:control: the rows of the $a_i$ shifted once less
:::
*/
CLAIM(implicit_value_is_the_printed_determinant)
{
    int n = T->degree;
    num R[2 * MAX_ORDER + 2], w[MAX_ORDER + 1], a[MAX_ORDER + 1], M[MAX_ORDER * MAX_ORDER];
    num x = parameter(T, "x"), y = parameter(T, "y");
    G(curve_of_any_weights)(T, n, 2, R, w);
    G(implicit_coefficients)(n, R, w, 0, x, a);
    for (int k = 0; k < 4 * n * n; k++)
        M[k] = from_int(0);
    for (int i = 0; i <= n; i++) {
        num factor = mul(G(choose)(n, i), w[i]);
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
A resultant asks for powers, and the curve is given in Bernstein polynomials.  The substitution $u=(b-t)/(t-a)$
changes the one into the other: $B_i^n$ becomes $\binom niu^{n-i}$ over $(1+u)^n$, and the common denominator cancels
in the quotient.  The interval becomes the half line $u\ge0$, with $t=a$ at infinity.  Both should be kept in mind,
the half line and its end: what goes wrong further on goes wrong there.

:::{statement} wang-ch3:3.4.3
:title: The change of parameter and its inverse
:zh: 参数变换及其逆
:printed: t=\frac{au+b}{u+1},\ 0\le u\le+\infty;\qquad u=\frac{b-t}{t-a},\ a\le t\le b
:holds-by: parameter_change_and_its_inverse large_parameters_lead_to_the_left_end
:needs: parameter_change_needs_two_ends | theorem 3.3.1: $c\in(a,b)$ | $a<b$: for $a=b$ the interval is a point
:meant: the second formula, which divides by 0 for $t=a$ | The value $u=+\infty$ stands for $t=a$, as a limit.

$t$ decreases from $b$ to $a$ while $u$ increases from $0$ to $+\infty$.
:::

:::{claim} parameter_change_and_its_inverse
:title: The two formulas are inverse to each other and map the ranges as stated
:zh: 两式互逆且区间对应
:given: $b=a+l$, $l>0$, $u\ge0$
:then: $t-a=\frac{b-a}{u+1}\ge0$, $b-t=\frac{u(b-a)}{u+1}\ge0$, $\frac{b-t}{t-a}=u$; and for $a<t\le b$, $t=b-ls$,
  the number $u=\frac{b-t}{t-a}\ge0$ is mapped back to $t$
:method: Identities in $a$, $l$, $u$, $s$; the signs are those of the coefficients, $s$ running through $[0,1)$.
:scope: u ≥ 0 and a < t ≤ b
:over: a l0 u0 s: -
:control: $t=(bu+a)/(u+1)$
:::
*/
CLAIM(parameter_change_and_its_inverse)
{
    num a = parameter(T, "a"), l = positive(T, "l", 0), u = positive(T, "u", 0), s = inside(T, "s");
    num b = add(a, l), one = from_int(1), u1 = add(u, one);
    num t = fault(T, div(add(mul(a, u), b), u1), div(add(mul(b, u), a), u1));
    about(T, "t - a and b - t");
    /* t - a = (b-a)/(u+1), b - t = u (b-a)/(u+1) */
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
:printed: (3.4.3) gives $\mathbf R(t)=(x,y)=\Bigl(\frac{\sum_{i=0}^n\binom ni\omega_ix_iu^{n-i}}{\sum_{i=0}^n\binom ni\omega_iu^{n-i}},
  \frac{\sum_{i=0}^n\binom ni\omega_iy_iu^{n-i}}{\sum_{i=0}^n\binom ni\omega_iu^{n-i}}\Bigr)$, $0\le u\le+\infty$.
:holds-by: parameter_change_and_its_inverse change_of_parameter_acts_on_one_factor bernstein_sum_of_powers_is_a_power
  quotients_of_large_parameters_lead_to_the_first_point positive_denominator_times_a_difference
:confirmed-by: curve_in_the_new_parameter
:needs: weights_of_both_signs_make_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive: so that the denominator does not vanish for $u\ge0$
:meant: (3.4.3), where $u=+\infty$ stands for $t=a$ | At $u=+\infty$ the quotients are limits, the coordinates of $R_0=R(a)$.

With $\frac{t-a}{b-a}=\frac1{u+1}$ the Bernstein sums of (3.3.1) become powers of $u$.
:::
*/

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
:printed: (3.4.4) says that $\sum_{i=0}^na_iu^{n-i}=0$, $\sum_{i=0}^nb_iu^{n-i}=0$.
:holds-by: positive_denominator_times_a_difference
:confirmed-by: equations_of_a_point
:needs: base_point_satisfies_the_equations | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive: so that the denominator does not vanish for $u\ge0$; else both equations may hold at a point off the curve
:needs: start_is_the_point_of_no_number | theorem 3.4.1, its proof: or $a_0=b_0=0$ ($x=x_0$, $y=y_0$) | $u\ne+\infty$: for $u=+\infty$,
  the point of $t=a$, the equations have no meaning but $a_0=b_0=0$

Equivalent to (3.4.4), for the same $u$: the sums are its denominator, which is positive, times the differences of the coordinates.
:::

:::{claim} sums_are_the_denominator_times_a_difference
:title: The sums of (3.4.5) are the denominator times the difference from the curve, in every degree
:zh: (3.4.5) 的和等于分母乘以坐标差(任意次数)
:given: the first terms of the sums in (3.4.4), the highest powers of $u$ first: $W$ of the denominator, $A$ of the numerator of the first coordinate, $E=A-xW$ of
  $\sum a_iu^{n-i}$; one term more, of weight $c=\binom ni\omega_i$ and with the coordinate $x_i$; any $x$ and $u$
:then: $W'=uW+c$, $A'=uA+cx_i$ and $E'=uE+c(x_i-x)$ again have $E'=A'-xW'$; and $A-xW=W\,(\frac AW-x)$
:where: the denominator of (3.4.4) is not 0
:method: Horner's scheme: the step of an induction on the number of terms, which begins with $c(x_0-x)=cx_0-xc$.  So for every $n$ the sum $\sum a_iu^{n-i}$ is the
  denominator of (3.4.4) times the difference of the first coordinate and $x$; for $b_i$ and $y$ it is the same.
:degrees: all
:over: W# c#: weights; A# x# x: points; u: -
:control: $x_i+x$ in the new term
:::
*/
/* The identities of one more term c of the sums (3.4.4), (3.4.5); returned is the new denominator. */
static num G(one_more_term)(trial *T, num u, num c)
{
    num W = positive(T, "W", 0), A = unknown(T, "A", 0), xi = unknown(T, "x", 0), x = parameter(T, "x");
    num E = sub(A, mul(x, W)), next = add(mul(u, W), c);
    about(T, "one more term");
    same(T, add(mul(u, E), mul(c, fault(T, sub(xi, x), add(xi, x)))), sub(add(mul(u, A), mul(c, xi)), mul(x, next)));
    about(T, "the difference of the coordinates");
    same(T, E, mul(W, sub(div(A, W), x)));
    return next;
}

CLAIM(sums_are_the_denominator_times_a_difference) { G(one_more_term)(T, parameter(T, "u"), unknown(T, "c", 0)); }

/*
:::{claim} equations_of_a_point
:title: The two sums are the denominator times the difference from the point of the curve
:zh: 两方程等价于点在曲线上
:given: weights and points, $n\ge1$, any $x$, $u\ge0$
:then: $\sum a_iu^{n-i}=W(u)\,(X(u)-x)$ with the point $X(u)$ of the curve, and $W(u)\ge\omega_n>0$
:method: An identity in $x$ and $u$, with $X$ by de Casteljau's algorithm.  $W(u)-\omega_n$ has no negative coefficient.
  So for $u\ge0$ the sum vanishes if and only if $x=X(u)$; for $y$ the same.
:degrees: 1..6 sampled 12
:over: x#: points; x; u0: u
:control: the binomial coefficients left out of the $a_i$
:::
*/
CLAIM(equations_of_a_point)
{
    int n = T->degree;
    num R[2 * MAX_ORDER + 2], P[MAX_ORDER + 1], w[MAX_ORDER + 1], a[MAX_ORDER + 1], point;
    num x = parameter(T, "x"), u = positive(T, "u", 0);
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
    /* Σ a_i u^{n-i} = W(u) (X(u) - x) */
    same(T, G(horner)(n, a, u), mul(G(in_u)(n, w, u), sub(point, x)));
    about(T, "W(u) - ω_n");
    nonnegative(T, sub(G(in_u)(n, w, u), w[n]));
}

/*
With positive weights the denominator never vanishes for $u\ge0$:

:::{claim} positive_denominator_times_a_difference
:title: With positive weights the sums of (3.4.5) are 0 for u ≥ 0 exactly at the point of u, in every degree
:zh: 正权时 u≥0 处两和为零当且仅当为曲线上的点(任意次数)
:given: $u\ge0$; the first terms of the sums in (3.4.4): $W>0$ of the denominator, $A$ of the numerator of the first coordinate, $E=A-xW$ of
  $\sum a_iu^{n-i}$; one term more, $c=\binom ni\omega_i>0$, with the coordinate $x_i$
:then: $W'=uW+c$, $A'=uA+cx_i$ and $E'=uE+c(x_i-x)$ again have $E'=A'-xW'$, $W'\ge c>0$; and $A-xW=W\,(\frac AW-x)$
:where: the weights are positive
:method: Horner's scheme: the step of an induction on the number of terms, which begins with $W=c>0$ and $c(x_0-x)=cx_0-xc$.  So for every $n$ and every $u\ge0$ the
  sum $\sum a_iu^{n-i}$ is a positive number times the difference of the first coordinate of (3.4.4) and $x$, and 0 only if the two are equal; for $b_i$ and $y$ it is the same.
:degrees: all
:scope: u ≥ 0
:over: W# c#: weights; A# x# x: points; u0: -
:control: $x_i+x$ in the new term
:::
*/
CLAIM(positive_denominator_times_a_difference)
{
    num c = positive(T, "c", 0), u = positive(T, "u", 0);
    num W = G(one_more_term)(T, u, c);
    about(T, "the denominator");
    nonnegative(T, sub(W, c));
    G(must_be_positive)(T, c);
}

#if RATIONAL
/*
:::{claim} start_is_the_point_of_no_number
:title: The point of t = a need not satisfy the two equations for any number u
:zh: 始点未必对应有限的 u
:kind: counterexample
:data: R = (0,0) (1,0); ω = 1 1; t = 0
:instead: t = 1/2
:result: a_0, a_1 = 0 1; b_0, b_1 = 0 0
:given: $n=1$, points and weights, and the point $(x,y)$ of the curve at $t$, $a=0$, $b=1$
:then: $a_0=b_0=0$, and $a_0u+a_1=a_1\ne0$ for every number $u$
:method: The coefficients are computed; that a number $u$ satisfies both equations is refuted where $a_0=0$ and $a_1\ne0$.
:control: the middle of the curve, where $u=1$
:::
*/
CLAIM(start_is_the_point_of_no_number)
{
    num R[4], w[2], P[2], a[2], b[2];
    given_points(T, "R", 2, 2, R);
    given_points(T, "ω", 2, 1, w);
    G(rational_point)(1, 2, R, w, given(T, "t"), P);
    G(implicit_coefficients)(1, R, w, 0, P[0], a);
    G(implicit_coefficients)(1, R, w, 1, P[1], b);
    found_points(T, "a_0, a_1", 2, 1, a);
    found_points(T, "b_0, b_1", 2, 1, b);
    about(T, "whether some number u satisfies both equations");
    refute(T, is_zero_q(a[0]) && !is_zero_q(a[1]));
}

/*
:::{claim} base_point_satisfies_the_equations
:title: Where numerators and denominator vanish together both equations hold at a point off the curve
:zh: 基点处两方程对曲线外的点也成立
:kind: counterexample
:data: R = (0,0) (1,0) (0,-1) (1,1); ω = 1 1/3 -1/3 -1; P = (5,7); u = 1
:instead: ω = 1 1 1 1
:result: a_0, …, a_3 = -5 -4 5 4; b_0, …, b_3 = -7 -7 8 6; the sums = 0 0
:given: a cubic of four different points $R$ that are not on a line, with weights of both signs, for which the curve is on the parabola $y=x^2$ and numerators and denominator of
  (3.4.4) vanish at the parameter $u$; and a point $P$ off the parabola
:then: $\sum a_iu^{n-i}=\sum b_iu^{n-i}=0$ although $P$ is not on the curve
:method: Both sums are computed; that one of them differs from 0 is what is compared, where the numerators $X$, $Y$ and the denominator $W$ satisfy $YW=X^2$ and the
  coordinates of $P$ do not satisfy $y=x^2$.
:control: equal weights
:::
*/
CLAIM(base_point_satisfies_the_equations)
{
    enum { n = 3 };
    num R[2 * n + 2], w[n + 1], P[2], a[n + 1], b[n + 1], x[n + 1], y[n + 1];
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    given_points(T, "P", 1, 2, P);
    num u = given(T, "u");
    G(implicit_coefficients)(n, R, w, 0, P[0], a);
    G(implicit_coefficients)(n, R, w, 1, P[1], b);
    num sum[2] = {G(horner)(n, a, u), G(horner)(n, b, u)};
    for (int i = 0; i <= n; i++) {
        x[i] = mul(w[i], R[2 * i]);
        y[i] = mul(w[i], R[2 * i + 1]);
    }
    poly X = poly_from_bernstein(n, x), Y = poly_from_bernstein(n, y), W = poly_from_bernstein(n, w);
    int on_parabola = poly_equal(poly_mul(Y, W), poly_mul(X, X)), off = !equal_q(P[1], mul(P[0], P[0]));
    found_points(T, "a_0, …, a_3", n + 1, 1, a);
    found_points(T, "b_0, …, b_3", n + 1, 1, b);
    found_points(T, "the sums", 2, 1, sum);
    about(T, "one of the sums differs from 0");
    refute(T, on_parabola && off && is_zero_q(sum[0]) && is_zero_q(sum[1]));
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
  $a_0=b_0=0$ ($x=x_0$, $y=y_0$).
:meant: (3.4.5), which is printed without a range, and the conclusion drawn by the theory of resultants, for which any common root counts | A
  common root of the two polynomials, real or complex.
:class: missing-hypothesis
:reading: positive_denominator_times_a_difference | a common root $u\ge0$, the range of (3.4.4) being carried over to (3.4.5): then it is right for positive weights
:reading-with: parameter_change_and_its_inverse change_of_parameter_acts_on_one_factor bernstein_sum_of_powers_is_a_power
  quotients_of_large_parameters_lead_to_the_first_point
:reading: common_root_of_a_point_off_the_arc | a common root, as it is printed, real or complex
:refuted-by: common_root_of_a_point_off_the_arc common_root_of_an_isolated_point
:corrected: for positive weights $(x,y)$ is a point of the curve if and only if the two polynomials have a common root
  $u\ge0$, or $a_0=b_0=0$
:corrected-by: parameter_change_and_its_inverse positive_denominator_times_a_difference
  change_of_parameter_acts_on_one_factor bernstein_sum_of_powers_is_a_power quotients_of_large_parameters_lead_to_the_first_point
:confirmed-by: equations_of_a_point nonnegative_common_roots_are_the_points
:figure: implicit_points

By (3.4.3) $u=\frac{b-t}{t-a}$ maps $(a,b]$ once onto $[0,\infty)$; $a_0=b_0=0$ says $x=x_0$, $y=y_0$, as $\omega_0\ne0$, and $\mathbf R_0$ is the point of $t=a$, where
of the Bernstein sums only the first terms are left.  Only the direction from the curve to the common root is
used in the proof, and that one is right.
:::

The direction that the theorem needs asks nothing of the weights: at a point of the curve the powers of its parameter
are a vector that the matrix maps to 0.  For the other direction two examples show what a common root can be besides a
point of the arc.

:::{claim} equation_vanishes_on_the_curve
:title: The determinant vanishes at every point of the curve, whatever the weights
:zh: 曲线上各点处 F=0
:given: weights and points, $n\ge1$, any $u$ with $W(u)\ne0$; and the point $R_0$
:where: $W(u)\ne0$
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
    G(free_curve)(T, n, 2, R, w);
    G(rational_point)(n, 2, R, w, div(from_int(1), add(from_int(1), at)), point);
    G(implicit_coefficients)(n, R, w, 0, point[0], a);
    G(implicit_coefficients)(n, R, w, 1, point[1], b);
    G(sylvester)(n, a, n, b, M);
    about(T, "the rows of the matrix times the powers of u");
    for (int i = 0; i < 2 * n; i++)
        vanishes(T, G(horner)(2 * n - 1, &M[i * 2 * n], u));
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
    G(free_curve)(T, n, 2, R, w);
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
:then: the two polynomials (3.4.5) in $u$ have a common root $u<0$, and $F$ is 0 at $P$; the point is not on the segment
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
:then: the polynomials (3.4.5) in $u$ have a common factor of degree 2 with complex roots; $F$ is 0 at $P$, and no parameter
  in $[0,1]$ gives this point
:method: The common root by the greatest common divisor in $u$; membership in the arc by the roots in $[0,1]$ of that in $t$.
:control: roots $u\ge0$ only
:::
*/
CLAIM(common_root_of_an_isolated_point) { compare_with_the_arc(T, 3); }

/*
:::{claim} nonnegative_common_roots_are_the_points
:title: Common roots u ≥ 0, or R_0, are exactly the points of the arc, on designed curves
:zh: 非负公根与弧上的点一一对应
:kind: decision
:data: line = (0,0,1) (1,0,1); doubled line = (0,0,1) (0,0,1) (1,1,1); parabola = (0,0,1) (1/2,0,1) (1,1,1);
  quarter circle = (1,0,1) (1,1,1) (0,1,2); the same elevated = (1,0,3) (1,2/3,3) (1/2,1,4) (0,1,6);
  nodal cubic = (0,0,1) (9,8,1) (-5,8,1) (4,0,1); cubic with an isolated point = (0,0,1) (0,1/3,1) (1/3,2/3,1) (1,2,1);
  t = -2 -1/2 0 1/3 1/2 1 3/2 3; offset = 1/7; P = (-1,0)
:result: points on the arcs = 32; points off the arcs = 87
:given: seven curves, each by its points and weights $(x_i,y_i,\omega_i)$, the weights positive; for each curve the
  points of the parameters $t$, inside and outside of $[0,1]$, the same moved off by the offset in the direction of
  the first axis, and the point $P$, isolated on the last curve
:then: the criterion with roots $u\ge0$ agrees with membership in the arc
:method: The common root by the greatest common divisor in $u$, membership in the arc by that in $t$; the roots are counted in two ways.
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
:printed: The rational Bézier curve of degree $n$ on the left of (3.3.1), $a\le t\le b$, can be turned into the implicit equation (3.4.1) when the
  $\mathbf R_i=(x_i,y_i)$, $i=0,1,\dots,n$, are coplanar.
:holds-by: rows_of_the_determinant_are_shifted_equations sums_are_the_denominator_times_a_difference
  change_of_parameter_acts_on_one_factor bernstein_sum_of_powers_is_a_power top_form_is_a_resultant_row_by_row
:confirmed-by: parameter_change_and_its_inverse equation_vanishes_on_the_curve top_form_is_a_resultant
  common_zero_makes_the_equation_vanish elevation_multiplies_by_one_plus_u
:argued: | The point of $t\ne a$ is that of $u=\frac{b-t}{t-a}$, by (3.4.3); a square matrix that takes a vector that is not 0 to 0 has the determinant 0, and at $\mathbf R_0$, the point of
  $t=a$, its first column is 0.  If the terms of degree $n$ vanished, so would a resultant for every $x:y$, and one zero of the denominator would be a zero of both numerators.  Where $F=0$ the rows are
  dependent: $gp+hq=0$ with $p=A-xW$, $q=B-yW$ and $g$, $h$ of degree less than $n$, not both 0; so $p$ is 0, or one of its $n$ zeros, $u=\infty$ included, is one of $q$, as $h$ has fewer.  At the
  common zero $W\ne0$, for else $A=B=0$, too: it is the parameter of the point.
:hypothesis: elevated_curve_has_no_equation | the two numerators and the denominator of (3.4.4) have no common zero, real or complex; else $F$ is 0
  for all $(x,y)$
:needs: end_weight_zero_gives_no_equation | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\omega_0\ne0$; with $\omega_0=0$ the first
  column vanishes, and $u=\infty$ is a common zero
:needs: space_curve_and_its_shadow | the theorem, in which the $\mathbf R_i$ are coplanar | the curve is plane; for a curve of
  space $F=0$ is the equation of a projection, and holds at points that belong to no parameter, as in the example
:meant: the proof, in which $F$ is the resultant of (3.4.5), and the word equation | $F=0$ at every point of the curve, $F$ is not the zero polynomial, and every point with $F=0$ is that of a parameter
  $u$, real, complex or $\infty$.
:reading: rows_of_the_determinant_are_shifted_equations | every point of the curve satisfies $F=0$; this needs none of the hypotheses on weights and common zeros | At the
  point of $t\ne a$, which is that of $u=\frac{b-t}{t-a}$ by (3.4.3), the sums of (3.4.5) are 0; a square matrix that takes a vector that is not 0 to 0 has the determinant 0.  At
  $\mathbf R_0$, the point of $t=a$ and of no $u$, the first column is 0.
:reading-with: sums_are_the_denominator_times_a_difference change_of_parameter_acts_on_one_factor
  bernstein_sum_of_powers_is_a_power
:reading: common_root_of_a_point_off_the_arc | the points with $F=0$ are those of the curve and no others; but a point of a parameter outside of the interval may
  be one
:figure: implicit_elevation

No common zero and $\omega_0\ne0$ together say that there is no base point, $u=\infty$ included.  That $F$ is 0 where there is a common zero is, for $n=1$ to 6, `common_zero_makes_the_equation_vanish`; that elevated curves have one,
`elevation_multiplies_by_one_plus_u`.  The curve of space is drawn in `implicit_shadow`.
:::

:::{claim} top_form_is_a_resultant_row_by_row
:title: The terms of degree n of F are Res(W, yA - xB), in every degree
:zh: F 的最高次部分(任意次数)
:given: polynomials $A$, $B$, $W$ of degree $n$ in $u$, any $x,y,z$; $p=zA-xW$, $q=zB-yW$, $s=xB-yA$
:then: $xq=zs+yp$, and $p=-xW$ for $z=0$; so $x^n\operatorname{Res}(p,q)=z^n\operatorname{Res}(p,s)$, and
  $\operatorname{Res}(-xW,s)=x^n\operatorname{Res}(W,yA-xB)$
:method: Identities for each coefficient.  In the determinant of the $n$ shifted rows of $p$ over the $n$ shifted rows of $q$ each row of $q$ times $x$ is the same row of $s$ times $z$ plus the same row of
  $p$ times $y$; rows of $p$ added to it do not change a determinant, and a factor of $n$ rows is a factor to the power $n$, for every $n$.  Now $z^{-n}\operatorname{Res}(p,q)=x^{-n}\operatorname{Res}(p,s)$ is $F$ made
  homogeneous, as $F(x/z,y/z)$ is the resultant of $A-\frac xzW$ and $B-\frac yzW$; at $z=0$ it is $\operatorname{Res}(W,yA-xB)$, the part of degree $n$ of $F$.  If this were 0 for all $x,y$, its rows would be
  dependent, $gW+h(yA-xB)=0$ with polynomials $g,h$ of degree less than $n$, not both 0; as $h$ has fewer zeros than $W$, one of the $n$ zeros of $W$, $u=\infty$ included, is one of $yA-xB$, and one zero is so for
  infinitely many $x:y$: it is a zero of $A$, $B$ and $W$.
:degrees: all
:over: A# B# W#: coefficients; x y z: -
:control: $xA-yB$ for $s$
:::
*/
CLAIM(top_form_is_a_resultant_row_by_row)
{
    num A = unknown(T, "A", 0), B = unknown(T, "B", 0), W = unknown(T, "W", 0);
    num x = parameter(T, "x"), y = parameter(T, "y"), z = parameter(T, "z"), none = from_int(0);
    num p = sub(mul(z, A), mul(x, W)), q = sub(mul(z, B), mul(y, W));
    num s = fault(T, sub(mul(x, B), mul(y, A)), sub(mul(x, A), mul(y, B)));
    about(T, "a row of q, times x");
    same(T, mul(x, q), add(mul(z, s), mul(y, p)));
    about(T, "a row of p for z = 0");
    same(T, sub(mul(none, A), mul(x, W)), neg(mul(x, W)));
    about(T, "the two signs of the part of degree n");
    same(T, mul(neg(x), s), mul(x, sub(mul(y, A), mul(x, B))));
}

/*
For low degrees the resultants are computed:

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
:over: A# B# W#: coefficients; x; y; z
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
    /* x^n Res(zA - xW, zB - yW) = z^n Res(zA - xW, xB - yA) */
    same(T, mul(xn, G(bezout_resultant)(n, p, q)), mul(zn, G(bezout_resultant)(n, p, s)));
    for (int i = 0; i <= n; i++) {
        p[i] = neg(mul(x, W[i]));
        s[i] = sub(mul(x, B[i]), mul(y, A[i]));
        q[i] = neg(s[i]);
    }
    about(T, "the part of degree n");
    /* Res(-xW, xB - yA) = x^n Res(W, yA - xB) */
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
:given: the points $R$ of the parabola $(t,t^2)$, equal weights, and the points of the same curve elevated by one degree
:then: for the elevated points $F(x,y)=0$ for all $x$ and $y$
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
:method: The determinant with $x$ and $y$ variables; that it is not the zero polynomial is what is compared.
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
:title: For a curve of space F = 0 can also hold beside the curve
:zh: 空间曲线的 F=0 只是投影柱面
:kind: counterexample
:data: R = (0,0,0) (1/3,0,1/3) (2/3,1/3,2/3) (1,1,2); ω = 1 1 1 1; t = 1/2; P = (1/2,0,5/8)
:instead: P = (1/2,1/4,5/8)
:result: F(x, z) at P = 0; R(t) = (1/2,1/4,5/8)
:given: the points $R$ of the space cubic $(t,t^2,t^3+t)$, equal weights, the determinant formed from $x$ and $z$, a
  parameter $t$, and a point $P$ of space with the $x$ and the $z$ of $R(t)$
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
:::{claim} rows_of_the_determinant_are_shifted_equations
:title: Every row of the determinant is one of the two equations, times a power of u
:zh: 行列式各行是方程乘以 u 的幂(任意次数)
:given: the entries $a_i$ of a row that begins in column $k$, as a sum of two parts: one entry $a$ at a power $V=u^{n-i}$, and the others, together
  $r=\sum a_ju^{n-j}$ without it; $U=u^{n-k}$
:then: the row, applied to $(u^{2n-1},\dots,u,1)$, is $U(aV+r)$, one entry after the other
:method: Distributivity, with any number of entries by induction; the place of $a_i$ in the row is $k+i$, so its power is $u^{2n-k-i}=UV$.  A square matrix that maps a
  vector with an entry 1 to 0 has the determinant 0; at $R_0$, where $u=\infty$, the first column is 0.
:degrees: all
:over: a V U r: -
:control: the entry left out of the shifted sum
:::
*/
CLAIM(rows_of_the_determinant_are_shifted_equations)
{
    num a = unknown(T, "a", 0), V = unknown(T, "V", 0), U = unknown(T, "U", 0), r = unknown(T, "r", 0);
    same(T, add(mul(a, mul(U, V)), mul(U, r)), mul(U, fault(T, add(mul(a, V), r), r)));
}

/*
:::{statement} wang-ch3:thm-3.4.1-step-vanishing
:title: By the theory of resultants F must be 0 at the points of the curve
:zh: 由结式理论 F 必为零
:printed: By the theory of the resultant of polynomials the resultant $F(x,y)$ of (3.4.5) must be 0, at the points of the curve.
:holds-by: rows_of_the_determinant_are_shifted_equations sums_are_the_denominator_times_a_difference
  change_of_parameter_acts_on_one_factor bernstein_sum_of_powers_is_a_power
:argued: | The point of $t\ne a$ is that of $u=\frac{b-t}{t-a}$, by (3.4.3); a square matrix that takes a vector that is not 0 to 0 has the determinant 0, and at $\mathbf R_0$, the point of
  $t=a$, its first column is 0.
:confirmed-by: parameter_change_and_its_inverse equation_vanishes_on_the_curve implicit_value_vanishes_on_the_curve

The second way, `implicit_value_vanishes_on_the_curve`, computes the determinant itself at points of curves.
:::
*/

#include "chapters/judge/claims_off.h"
