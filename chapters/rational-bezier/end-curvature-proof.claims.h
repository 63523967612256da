/*
# The proof of the end formulas (端点曲率与挠率的证明)

The proof writes $R=P/\omega$, differentiates $P=\omega R$ three times, solves for the derivatives of $R$, and puts
$t=0$.  Then the edges come in, and of the many terms only three are needed.
*/
#include "chapters/judge/elementary.h"
#include "chapters/rational-bezier/free-curve.h"
#include "chapters/rational-bezier/taylor.h"

#include "chapters/judge/claims_on.h"

/*
## Derivatives of a quotient

$P=\omega R$ differentiated twice is $P''=\omega''R+2\omega'R'+\omega R''$, and once more $P'''=\omega'''R+3\omega''R'+3\omega'R''+\omega R'''$.
In every term the orders of the two factors have the same sum.  A reader who counts them finds both misprints of the
source without any computation.  Moving the origin is a second test: if $c$ is added to $R$, then $\omega c$ is added
to $P$, and $R''$ must stay as it is.  It finds the first misprint, but not the second, whose wrong term contains
derivatives of $R$ only.

:::{statement} wang-ch3:prop-3.2.4-step-1
:title: First derivative of the quotient
:zh: 商的一阶导矢
:printed: Let the curve be $\mathbf R(t)=\mathbf P(t)/\omega(t)$, so that $\mathbf P=\omega\mathbf R$; differentiated and solved this gives
  $\mathbf R'=(\mathbf P'-\omega'\mathbf R)/\omega$.
:holds-by: derivatives_of_a_quotient
:::

:::{claim} derivatives_of_a_quotient
:title: The derivatives of R = P/ω up to the third
:zh: R = P/ω 的前三阶导矢
:given: any two functions $P$, $\omega$ with three derivatives, $\omega\ne0$
:where: $\omega(t)\ne0$
:then: $R'=(P'-\omega'R)/\omega$, $R''=(P''-\omega''R-2\omega'R')/\omega$, $R'''=(P'''-\omega'''R-3\omega''R'-3\omega'R'')/\omega$
:method: The formulas at a point depend on the values of $P,\omega$ and their three derivatives there only, so cubic polynomials with free coefficients stand
  for all functions.  In the field their quotient is differentiated formally; elsewhere it is divided as a power series.
:over: p# w#: derivatives; t: -
:control: $\omega'$ for $\omega''$ in $R''$, as printed
:::
*/
CLAIM(derivatives_of_a_quotient)
{
    num P[4], W[4], R[4]; /* derivatives 0 ... 3 at t = 0 */
    W[0] = positive(T, "w", 0);
    for (int k = 0; k < 4; k++) {
        P[k] = unknown(T, "p", k);
        W[k] = k > 0 ? unknown(T, "w", k) : W[0];
    }
    num taylor[] = {from_int(1), from_int(1), from_ratio(1, 2), from_ratio(1, 6)};
#if FIELD
    num t = variable_f("t"), above = from_int(0), below = from_int(0);
    for (int k = 3; k >= 0; k--) {
        above = add(mul(above, t), mul(taylor[k], P[k]));
        below = add(mul(below, t), mul(taylor[k], W[k]));
    }
    num quotient = div(above, below);
    for (int k = 0; k < 4; k++, quotient = derivative_f(quotient, t))
        R[k] = substitute_f(quotient, t, from_int(0));
#else
    G(series) p, w;
    for (int k = 0; k < 4; k++) {
        p.c[k] = mul(taylor[k], P[k]);
        w.c[k] = mul(taylor[k], W[k]);
    }
    for (int k = 0; k < 4; k++)
        R[k] = div(G(series_div)(p, w).c[k], taylor[k]);
#endif
    num two = from_int(2), three = from_int(3);
    /* ω'R; ω''R + 2ω'R'; ω'''R + 3ω''R' + 3ω'R'' */
    num first = mul(W[1], R[0]), second = add(mul(fault(T, W[2], W[1]), R[0]), mul(two, mul(W[1], R[1])));
    num third = add(mul(W[3], R[0]), mul(three, add(mul(W[2], R[1]), mul(W[1], R[2]))));
    same(T, R[0], div(P[0], W[0]));
    same(T, R[1], div(sub(P[1], first), W[0]));
    same(T, R[2], div(sub(P[2], second), W[0]));
    same(T, R[3], div(sub(P[3], third), W[0]));
}

/*
:::{statement} wang-ch3:prop-3.2.4-step-2
:title: Second derivative of the quotient
:zh: 商的二阶导矢
:printed: \mathbf R''=(\mathbf P''-\omega'\mathbf R-2\omega'\mathbf R')/\omega
:class: misprint
:refuted-by: printed_second_derivative_of_quotient_is_wrong
:corrected: \mathbf R''=(\mathbf P''-\omega''\mathbf R-2\omega'\mathbf R')/\omega
:corrected-by: derivatives_of_a_quotient
:figure: quotient_derivatives

A prime is missing.  In each term the orders of the derivatives have the sum $2$; in the printed $\omega'\mathbf R$ it is $1$.  As printed the vector
even depends on the origin of the coordinates, as the example shows.
:::
*/

#if RATIONAL
/* The derivatives 0 ... r of P, of omega and of R = P/omega at t = 0, for points of the line. */
static void G(derivatives_at_zero)(int n, const num R[], const num w[], int r, num P[], num W[], num D[])
{
    num H[(MAX_DEGREE + 1) * 2], HD[(MAX_DEGREE + 1) * 2];
    G(rational_homogenize)(n, 1, R, w, H);
    G(bezier_derivatives)(n, 2, H, from_int(0), r, HD);
    for (int k = 0; k <= r; k++) {
        P[k] = HD[2 * k];
        W[k] = HD[2 * k + 1];
    }
    G(rational_derivatives)(n, 1, R, w, from_int(0), r, D);
}

/*
For the missing prime a segment is enough: there $\omega''=0$, so that the term with $\omega''R$ should not be there
at all, and the printed one is.

:::{claim} printed_second_derivative_of_quotient_is_wrong
:title: The printed R'' of the segment from 1 to 2 with weights 1, 2
:zh: 线段 1→2（权 1, 2）的 R″ 与所印不符
:kind: counterexample
:data: R = 1 2; ω = 1 2; c = 1
:result: P, P', P'' = 1 3 0; ω, ω', ω'' = 1 1 0; R, R', R'' = 1 2 -4; R'' as printed = -5; R'' of R + c as printed = -6
:given: the segment of the line with points $R$ and weights $\omega$, $P=\omega R$; $t=0$; the same with the origin moved by $c$
:then: $R''(0)$ is not $(P''-\omega'R-2\omega'R')/\omega$, which is not even the same for the points $R+c$
:method: All derivatives are computed exactly.
:control: $\omega''R$ for $\omega'R$
:::
*/
CLAIM(printed_second_derivative_of_quotient_is_wrong)
{
    num R[2], w[2], P[3], W[3], D[3], value[2], second = from_int(0);
    given_points(T, "R", 2, 1, R);
    given_points(T, "ω", 2, 1, w);
    num c = given(T, "c");
    for (int moved = 1; moved >= 0; moved--) { /* the points R + c, and R */
        num at[2] = {moved ? add(R[0], c) : R[0], moved ? add(R[1], c) : R[1]};
        G(derivatives_at_zero)(1, at, w, 2, P, W, D);
        /* (P'' - ω' R - 2 ω' R')/ω */
        num sum = add(mul(fault(T, W[2], W[1]), D[0]), mul(from_int(2), mul(W[1], D[1])));
        value[moved] = div(sub(P[2], sum), W[0]);
        second = D[2];
    }
    found_points(T, "P, P', P''", 3, 1, P);
    found_points(T, "ω, ω', ω''", 3, 1, W);
    found_points(T, "R, R', R''", 3, 1, D);
    found(T, "R'' as printed", value[0]);
    found(T, "R'' of R + c as printed", value[1]);
    about(T, "R''(0), left as it is, right as printed");
    same(T, second, value[0]);
}

/*
:::{statement} wang-ch3:prop-3.2.4-step-3
:title: Third derivative of the quotient
:zh: 商的三阶导矢
:printed: \mathbf R'''=(\mathbf P'''-\omega'''\mathbf R-3\omega''\mathbf R''-3\omega'\mathbf R'')/\omega
:class: misprint
:refuted-by: printed_third_derivative_of_quotient_is_wrong
:corrected: \mathbf R'''=(\mathbf P'''-\omega'''\mathbf R-3\omega''\mathbf R'-3\omega'\mathbf R'')/\omega
:corrected-by: derivatives_of_a_quotient
:figure: quotient_derivatives

A prime too many: the orders in $\omega''\mathbf R''$ have the sum $4$.
:::

The second slip needs $\omega''\ne0$, hence degree $2$.  With $\omega'(0)=0$ nothing else is left of the formula but
the term in question.

:::{claim} printed_third_derivative_of_quotient_is_wrong
:title: The printed R''' of (2t + 2t²)/(1 + t²)
:zh: (2t + 2t²)/(1 + t²) 的 R‴ 与所印不符
:kind: counterexample
:data: R = 0 1 2; ω = 1 1 2
:result: P, P', P'', P''' = 0 2 4 0; ω, ω', ω'', ω''' = 1 0 2 0; R, R', R'', R''' = 0 2 4 -12; R''' as printed = -24
:given: the quadratic curve of the line with points $R$ and weights $\omega$, $P=\omega R$, which is $R(t)=\frac{2t+2t^2}{1+t^2}$; $t=0$
:then: $R'''(0)$ is not the printed right side, but the half of it
:method: All derivatives are computed exactly.
:control: $\omega''R'$ for $\omega''R''$
:::
*/
CLAIM(printed_third_derivative_of_quotient_is_wrong)
{
    num R[3], w[3], P[4], W[4], D[4];
    given_points(T, "R", 3, 1, R);
    given_points(T, "ω", 3, 1, w);
    G(derivatives_at_zero)(2, R, w, 3, P, W, D);
    found_points(T, "P, P', P'', P'''", 4, 1, P);
    found_points(T, "ω, ω', ω'', ω'''", 4, 1, W);
    found_points(T, "R, R', R'', R'''", 4, 1, D);
    /* (P''' - ω''' R - 3 ω'' R'' - 3 ω' R'')/ω */
    num sum = add(mul(W[2], fault(T, D[1], D[2])), mul(W[1], D[2]));
    num printed = div(sub(P[3], add(mul(W[3], D[0]), mul(from_int(3), sum))), W[0]);
    found(T, "R''' as printed", printed);
    about(T, "R'''(0), left as it is, right as printed");
    same(T, D[3], printed);
}
#endif

/*
## The derivatives at the ends

At $t=0$ the derivatives of $P$ and $\omega$ are differences of the first coefficients times $n$, $n(n-1)$,
$n(n-1)(n-2)$; with $R_1=R_0+a_1$, $R_2=R_0+a_1+a_2$ and so on, $R_0$ drops out and the edges are left.  The source
does not compute the numbers $f_1$, $g_1$, $g_2$ in front of the older edges, and the proof does not need them.  Here
they are written out, so that the statement that they depend on $n$ and the weights only can be decided and not just
believed.

:::{statement} wang-ch3:prop-3.2.4-step-4
:title: The first derivative at t = 0
:zh: t=0 处一阶导矢
:printed: \mathbf R'(0)=n\,\omega_1\mathbf a_1/\omega_0
:holds-by: derivative_vectors_at_zero_in_every_degree bernstein_sum_begins_with_its_differences
:confirmed-by: end_derivative_vectors_at_both_ends
:::

:::{statement} wang-ch3:prop-3.2.4-step-5
:title: The second derivative at t = 0
:zh: t=0 处二阶导矢
:printed: \mathbf R''(0)=n(n-1)\,\omega_2\mathbf a_2/\omega_0+f_1\mathbf a_1
:holds-by: derivative_vectors_at_zero_in_every_degree bernstein_sum_begins_with_its_differences
:confirmed-by: end_derivative_vectors_at_both_ends

The source takes this value from its formula for $\mathbf R''$.  It is that of the formula as corrected in `wang-ch3:prop-3.2.4-step-2`; the printed one has
$(\omega''(0)-\omega'(0))\mathbf R_0/\omega_0$ more.
:::

:::{statement} wang-ch3:prop-3.2.4-step-6
:title: The third derivative at t = 0
:zh: t=0 处三阶导矢
:printed: \mathbf R'''(0)=n(n-1)(n-2)\,\omega_3\mathbf a_3/\omega_0+g_2\mathbf a_2+g_1\mathbf a_1
:holds-by: derivative_vectors_at_zero_in_every_degree bernstein_sum_begins_with_its_differences
:confirmed-by: end_derivative_vectors_at_both_ends

The source takes this value from its formula for $\mathbf R'''$.  It is that of the formula as corrected in `wang-ch3:prop-3.2.4-step-3`; the printed one, with the right
$\mathbf R''(0)$ in it, has $3\omega''(0)(\mathbf R'(0)-\mathbf R''(0))/\omega_0$ more, which changes $g_1$ and $g_2$ only.
:::

:::{statement} wang-ch3:prop-3.2.4-step-7
:title: What the coefficients f_1, g_1, g_2 depend on
:zh: f_1、g_1、g_2 的依赖关系
:printed: Here $f_1$, $g_2$, $g_1$ are determined by the weights and $n$.
:holds-by: derivative_vectors_at_zero_in_every_degree bernstein_sum_begins_with_its_differences
:confirmed-by: end_derivative_vectors_at_both_ends
:::
*/

/* The right sides at t = 0, D[1], D[2], D[3], from w_0 ... w_3 and a[1], a[2], a[3]. */
static inline void G(end_vectors)(num n, const num w[], const num a[], int factor, num D[])
{
    num n1 = sub(n, from_int(1)), n2 = sub(n, from_int(2)), two = from_int(2), three = from_int(3);
    num second = mul(n, n1), third = mul(second, n2);
    /* ω' = n (ω_1 - ω_0), ω'' = n(n-1)(ω_2 - 2ω_1 + ω_0) */
    num dw = mul(n, sub(w[1], w[0])), ddw = mul(second, add(sub(w[2], mul(two, w[1])), w[0]));
    /* ω_0 f_1 = n(n-1)(ω_2 - 2ω_1) - 2n ω' ω_1/ω_0, and so on as in the claim below */
    num f1 = mul(second, sub(w[2], mul(from_int(factor), w[1])));
    f1 = div(sub(f1, div(mul(mul(two, n), mul(dw, w[1])), w[0])), w[0]);
    num g2 = mul(third, sub(w[3], mul(three, w[2])));
    g2 = div(sub(g2, div(mul(mul(three, second), mul(dw, w[2])), w[0])), w[0]);
    num g1 = mul(third, add(sub(w[3], mul(three, w[2])), mul(three, w[1])));
    g1 = sub(sub(g1, mul(three, mul(dw, f1))), div(mul(mul(three, n), mul(ddw, w[1])), w[0]));
    g1 = div(g1, w[0]);
    D[1] = mul(div(mul(n, w[1]), w[0]), a[1]);
    D[2] = add(mul(div(mul(second, w[2]), w[0]), a[2]), mul(f1, a[1]));
    D[3] = add(add(mul(div(mul(third, w[3]), w[0]), a[3]), mul(g2, a[2])), mul(g1, a[1]));
}

/*
:::{claim} derivative_vectors_at_zero_in_every_degree
:title: The first three derivatives at t = 0 in terms of the edges, for every n
:zh: t=0 处前三阶导矢用边矢表示（任意 n）
:given: any $n$; weights, $\omega_0\ne0$; $R_0$ and the edges $a_1,a_2,a_3$
:where: $\omega_0\ne0$
:let: $\omega_0f_1=n(n-1)(\omega_2-2\omega_1)-2n\omega'\omega_1/\omega_0$, $\omega_0g_2=n(n-1)(n-2)(\omega_3-3\omega_2)-3n(n-1)\omega'\omega_2/\omega_0$,
  $\omega_0g_1=n(n-1)(n-2)(\omega_3-3\omega_2+3\omega_1)-3\omega'f_1-3n\omega''\omega_1/\omega_0$ with $\omega'=n(\omega_1-\omega_0)$ and
  $\omega''=n(n-1)(\omega_2-2\omega_1+\omega_0)$
:then: $R'(0)=\frac{n\omega_1}{\omega_0}a_1$, $R''(0)=\frac{n(n-1)\omega_2}{\omega_0}a_2+f_1a_1$,
  $R'''(0)=\frac{n(n-1)(n-2)\omega_3}{\omega_0}a_3+g_2a_2+g_1a_1$
:method: $\sum B_i^n(t)c_i$ has at $0$ the Taylor coefficients $\binom nj\Delta^jc_0$;
  numerator and denominator are divided as power series, with $n$ a
  variable of the field.  What does not exist for $n<3$ has a factor $0$.  A coordinate is any coordinate.
:degrees: all
:over: n: -; a#: edges
:control: $-\omega_1$ for $-2\omega_1$ in $f_1$
:::
*/
/* The derivatives at t = 0, end = 0, or at t = 1, end = 1, by power series, against the right sides. */
static inline void G(compare_end_vectors)(trial *T, int end)
{
    num n = positive(T, "n", 0), w[4], R[4], a[4], D[4], p[4], v[4], choose = from_int(1);
    for (int i = 0; i < 4; i++) {
        w[i] = positive(T, "w", i);
        a[i] = unknown(T, "a", i); /* a_0 stands for the end point */
    }
    G(end_vectors)(n, w, a, fault(T, 2, 1), D);
    G(series) P, W;
    for (int i = 0; i < 4; i++) {
        num edge = end == 0 ? a[i] : neg(a[i]);
        R[i] = i > 0 ? add(R[i - 1], edge) : a[0];
        p[i] = mul(w[i], R[i]);
        v[i] = w[i];
    }
    for (int j = 0; j < 4; j++) {
        P.c[j] = mul(choose, p[0]);
        W.c[j] = mul(choose, v[0]);
        choose = mul(choose, div(sub(n, from_int(j)), from_int(j + 1)));
        for (int i = 0; i < 3 - j; i++) {
            p[i] = sub(p[i + 1], p[i]);
            v[i] = sub(v[i + 1], v[i]);
        }
    }
    G(series) curve = G(series_div)(P, W);
    num sign = from_int(end == 0 ? 1 : -1); /* of the derivatives of odd order */
    /* k! times the coefficient of t^k, or of (1-t)^k */
    same(T, curve.c[0], R[0]);
    same(T, mul(sign, curve.c[1]), D[1]);
    same(T, mul(from_int(2), curve.c[2]), mul(sign, D[2]));
    same(T, mul(mul(sign, from_int(6)), curve.c[3]), D[3]);
}

CLAIM(derivative_vectors_at_zero_in_every_degree) { G(compare_end_vectors)(T, 0); }

/*
At $t=1$ the same expressions hold for the polygon in reversed order, whose curve is $R(1-t)$; the derivatives of odd
order change their sign, and so do the edges.  That leaves a sign in $R''(1)$ only, which is easily forgotten.

:::{claim} derivative_vectors_at_one_in_every_degree
:title: The first three derivatives at t = 1 in terms of the edges, for every n
:zh: t=1 处前三阶导矢用边矢表示（任意 n）
:given: any $n$; weights, $\omega_n\ne0$; $R_n$ and the edges $a_n,a_{n-1},a_{n-2}$
:where: $\omega_n\ne0$
:let: $\omega_0f_1=n(n-1)(\omega_2-2\omega_1)-2n\omega'\omega_1/\omega_0$, $\omega_0g_2=n(n-1)(n-2)(\omega_3-3\omega_2)-3n(n-1)\omega'\omega_2/\omega_0$,
  $\omega_0g_1=n(n-1)(n-2)(\omega_3-3\omega_2+3\omega_1)-3\omega'f_1-3n\omega''\omega_1/\omega_0$ with $\omega'=n(\omega_1-\omega_0)$ and
  $\omega''=n(n-1)(\omega_2-2\omega_1+\omega_0)$;
  $\tilde f_1,\tilde g_1,\tilde g_2$ the same with $\omega_n,\omega_{n-1},\dots$ for $\omega_0,\omega_1,\dots$
:then: $R'(1)=\frac{n\omega_{n-1}}{\omega_n}a_n$, $R''(1)=-\frac{n(n-1)\omega_{n-2}}{\omega_n}a_{n-1}-\tilde f_1a_n$,
  $R'''(1)=\frac{n(n-1)(n-2)\omega_{n-3}}{\omega_n}a_{n-2}+\tilde g_2a_{n-1}+\tilde g_1a_n$
:method: As at the beginning, in $s=1-t$ with the polygon reversed, where $R_{n-i}=R_n-a_n-\dots-a_{n-i+1}$, and a derivative of odd order by $t$ is minus that by $s$.
  That reversed coefficients give the sum at $1-t$, for every $n$, is enough for $b_i=Z^i$, where $\sum B_i^n(t)b_i=(1-t+tZ)^n$: it is
  the $n$-th power of $1-s+sZ=Z(1-t+t/Z)$, an identity in $t$ and $Z$.
:degrees: all
:over: n t Z: -; a#: edges
:control: $-\omega_{n-1}$ for $-2\omega_{n-1}$ in $\tilde f_1$
:::
*/
CLAIM(derivative_vectors_at_one_in_every_degree)
{
    about(T, "reversed coefficients");
    num t = parameter(T, "t"), Z = positive(T, "Z", 0), s = sub(from_int(1), t);
    /* 1 - s + sZ = Z (1 - t + t/Z) */
    same(T, add(sub(from_int(1), s), mul(s, Z)), mul(Z, add(s, div(t, Z))));
    about(T, "the derivatives");
    G(compare_end_vectors)(T, 1);
}

/*
:::{claim} end_derivative_vectors_at_both_ends
:title: The first three derivatives at both ends in terms of the edges
:zh: 两端前三阶导矢用边矢表示
:given: weights and points
:where: $\omega_0\ne0$ and $\omega_n\ne0$
:let: $\omega_0f_1=n(n-1)(\omega_2-2\omega_1)-2n\omega'\omega_1/\omega_0$, $\omega_0g_2=n(n-1)(n-2)(\omega_3-3\omega_2)-3n(n-1)\omega'\omega_2/\omega_0$,
  $\omega_0g_1=n(n-1)(n-2)(\omega_3-3\omega_2+3\omega_1)-3\omega'f_1-3n\omega''\omega_1/\omega_0$ with $\omega'=n(\omega_1-\omega_0)$ and
  $\omega''=n(n-1)(\omega_2-2\omega_1+\omega_0)$; $\tilde f_1,\tilde g_1,\tilde g_2$ the same with $\omega_n,\omega_{n-1},\dots$ for $\omega_0,\omega_1,\dots$
:then: $R'(0)=\frac{n\omega_1}{\omega_0}a_1$, $R''(0)=\frac{n(n-1)\omega_2}{\omega_0}a_2+f_1a_1$,
  $R'''(0)=\frac{n(n-1)(n-2)\omega_3}{\omega_0}a_3+g_2a_2+g_1a_1$; $R'(1)=\frac{n\omega_{n-1}}{\omega_n}a_n$, $R''(1)=-\frac{n(n-1)\omega_{n-2}}{\omega_n}a_{n-1}-\tilde f_1a_n$,
  $R'''(1)=\frac{n(n-1)(n-2)\omega_{n-3}}{\omega_n}a_{n-2}+\tilde g_2a_{n-1}+\tilde g_1a_n$
:method: The kernel is asked at $t=0$ and at $t=1$; both sides are one element of the field of rational functions of the weights and the points.
:degrees: 3..6 sampled 10
:control: the sign of $R''(1)$ as that of $R''(0)$
:::
*/
CLAIM(end_derivative_vectors_at_both_ends)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], a[4], v[4], D[4], wanted[4];
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        R[i] = unknown(T, "x", i);
    }
    for (int i = 1; i <= 3; i++)
        G(edge)(1, R, i, &a[i]);
    G(rational_derivatives)(n, 1, R, w, from_int(0), 3, D);
    G(end_vectors)(from_int(n), w, a, 2, wanted);
    for (int k = 1; k <= 3; k++)
        same(T, D[k], wanted[k]);

    for (int i = 0; i <= 3; i++) { /* the same at t = 1, the weights and the edges from the end */
        v[i] = w[n - i];
        if (i > 0)
            G(edge)(1, R, n + 1 - i, &a[i]);
    }
    G(rational_derivatives)(n, 1, R, w, from_int(1), 3, D);
    G(end_vectors)(from_int(n), v, a, 2, wanted);
    for (int k = 1; k <= 3; k++)
        same(T, D[k], fault(T, k == 2 ? neg(wanted[k]) : wanted[k], wanted[k]));
}

/*
Now $R'$, $R''$, $R'''$ are put into the formulas for curvature and torsion.

:::{statement} wang-ch3:prop-3.2.4-step-8
:title: Substitution gives the curvature and the torsion at t = 0
:zh: 代入曲率与挠率公式
:printed: Put into the formulas of the curvature and torsion of a parametric curve, these three give $\kappa(0)$ and $\tau(0)$.
:holds-by: curvature_and_torsion_follow_at_zero_in_every_degree factor_of_the_curvature_is_positive
  curvature_belongs_to_arc_length torsion_belongs_to_arc_length
:needs: negative_weight_makes_printed_curvature_negative | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  the weights are positive for the curvature.
:needs: repeated_first_points_leave_curvature_undetermined | property 3.2.4: no control points coincide | $\mathbf a_1\ne\mathbf
  0$.
:hypothesis: collinear_first_points_leave_torsion_undetermined | $\mathbf a_1\times\mathbf a_2\ne\mathbf 0$ for the torsion.

Nothing of $f_1$, $g_1$, $g_2$ is used but that they are numbers.
:::

:::{claim} curvature_and_torsion_follow_at_zero_in_every_degree
:title: The derivatives at t = 0 give the printed curvature and torsion, for every n and in any dimension
:zh: 由 t=0 处导矢得所印曲率与挠率（任意 n，任意维数）
:given: any $n$; weights; vectors $a_1,a_2,a_3$ of space; any numbers $f_1,g_1,g_2$; and, for the curvature in any dimension, only the products
  $a_1\cdot a_1$, $a_1\cdot a_2$, $a_2\cdot a_2$
:let: $R'=\frac{n\omega_1}{\omega_0}a_1$, $R''=\frac{n(n-1)\omega_2}{\omega_0}a_2+f_1a_1$, $R'''=\frac{n(n-1)(n-2)\omega_3}{\omega_0}a_3+g_2a_2+g_1a_1$
:then: $\kappa^2$ and $\tau$ of these are $\left(\frac{n-1}n\frac{\omega_0\omega_2}{\omega_1^2}\right)^2\frac{|a_1\times a_2|^2}{|a_1|^6}$ and
  $\frac{n-2}n\frac{\omega_0\omega_3}{\omega_1\omega_2}\frac{(a_1,a_2,a_3)}{|a_1\times a_2|^2}$
:method: Equality in the field in which $n$, the weights, the coordinates, the products and $f_1,g_1,g_2$ are variables.  The area $|a_1\times a_2|^2$ is
  $|a_1|^2|a_2|^2-(a_1\cdot a_2)^2$ in any dimension.  The quotients exist where $a_1$ is not $0$; that of the torsion where $a_1\times a_2$ is not $0$
  and $n>1$, for a segment has no torsion.
:degrees: all
:where: $\omega_0\omega_1\omega_2\ne0$
:over: n: -; x# y# z#: edges; f# g# p q r: -
:control: the factor $(n-1)/n$ in the torsion
:::
*/
/* Curvature and torsion of the vectors at t = 0, end = 0, or at t = 1, end = 1, where the second one has the other sign and a_n, a_{n-1}, a_{n-2}
 * stand for a_1, a_2, a_3. */
static inline void G(compare_end_curvature_and_torsion)(trial *T, int end)
{
    /* n > 2; in binary64 the factors stay away from 0 */
    num one = from_int(1), two = from_int(2), n = add(positive(T, "n", 0), two), w[4], a[3][3], D[3][3];
    num f1 = unknown(T, "f", 1), g1 = unknown(T, "g", 1), g2 = unknown(T, "g", 2), n1 = sub(n, one), n2 = sub(n, two);
    for (int i = 0; i < 4; i++)
        w[i] = positive(T, "w", i);
    num A = div(mul(n, w[1]), w[0]), B = div(mul(mul(n, n1), w[2]), w[0]),
        C = div(mul(mul(mul(n, n1), n2), w[3]), w[0]);
    for (int c = 0; c < 3; c++) {
        static const char *const axis[] = {"x", "y", "z"};
        for (int i = 0; i < 3; i++)
            a[i][c] = unknown(T, axis[c], i + 1);
        num second = add(mul(B, a[1][c]), mul(f1, a[0][c]));
        D[0][c] = mul(A, a[0][c]);
        D[1][c] = end == 0 ? second : neg(second);
        D[2][c] = add(add(mul(C, a[2][c]), mul(g2, a[1][c])), mul(g1, a[0][c]));
    }
    num x[3];
    G(cross3)(a[0], a[1], x);
    num area = G(norm_squared)(3, x), g = G(norm_squared)(3, a[0]);
    num factor = mul(div(n1, n), div(mul(w[0], w[2]), mul(w[1], w[1])));
    about(T, "curvature squared, in space");
    /* κ² = ((n-1)/n ω_0 ω_2/ω_1²)² |a_1 × a_2|²/|a_1|⁶ */
    same(T, G(curvature_squared)(3, D[0], D[1]), mul(mul(factor, factor), div(area, mul(g, mul(g, g)))));
    about(T, "torsion");
    num other = mul(div(fault(T, n2, n1), n), div(mul(w[0], w[3]), mul(w[1], w[2])));
    num volume = end == 0 ? G(det3)(a[0], a[1], a[2]) : G(det3)(a[2], a[1], a[0]);
    /* τ = (n-2)/n ω_0 ω_3/(ω_1 ω_2) (a_1, a_2, a_3)/|a_1 × a_2|² */
    same(T, G(torsion)(D[0], D[1], D[2]), mul(other, div(volume, area)));

    /* p = a_1.a_1, q = a_1.a_2, r = a_2.a_2; the sign of the second derivative is in d12 only, which is squared */
    num p = positive(T, "p", 0), q = unknown(T, "q", 0), r = positive(T, "r", 0);
    num d11 = mul(mul(A, A), p), d12 = mul(A, add(mul(B, q), mul(f1, p)));
    num d22 = add(mul(mul(B, B), r), add(mul(mul(two, mul(B, f1)), q), mul(mul(f1, f1), p)));
    d12 = end == 0 ? d12 : neg(d12);
    num gram = sub(mul(d11, d22), mul(d12, d12));
    about(T, "curvature squared, from scalar products");
    same(T, div(gram, mul(d11, mul(d11, d11))),
         mul(mul(factor, factor), div(sub(mul(p, r), mul(q, q)), mul(p, mul(p, p)))));
}

CLAIM(curvature_and_torsion_follow_at_zero_in_every_degree) { G(compare_end_curvature_and_torsion)(T, 0); }

/*
:::{claim} curvature_and_torsion_follow_at_one_in_every_degree
:title: The derivatives at t = 1 give the printed curvature and torsion, for every n and in any dimension
:zh: 由 t=1 处导矢得所印曲率与挠率（任意 n，任意维数）
:given: any $n$; weights; vectors $a_n,a_{n-1},a_{n-2}$ of space; any numbers $f_1,g_1,g_2$; and, for the curvature in any dimension, only the products
  $a_n\cdot a_n$, $a_n\cdot a_{n-1}$, $a_{n-1}\cdot a_{n-1}$
:let: $R'=\frac{n\omega_{n-1}}{\omega_n}a_n$, $R''=-\frac{n(n-1)\omega_{n-2}}{\omega_n}a_{n-1}-f_1a_n$,
  $R'''=\frac{n(n-1)(n-2)\omega_{n-3}}{\omega_n}a_{n-2}+g_2a_{n-1}+g_1a_n$
:then: $\kappa^2$ and $\tau$ of these are $\left(\frac{n-1}n\frac{\omega_{n-2}\omega_n}{\omega_{n-1}^2}\right)^2\frac{|a_{n-1}\times a_n|^2}{|a_n|^6}$ and
  $\frac{n-2}n\frac{\omega_{n-3}\omega_n}{\omega_{n-2}\omega_{n-1}}\frac{(a_{n-2},a_{n-1},a_n)}{|a_{n-1}\times a_n|^2}$
:method: As at the beginning of the curve, with the other sign of the second derivative and the mixed product in the order printed.  The quotients exist
  where $a_n$ is not $0$; that of the torsion where $a_{n-1}\times a_n$ is not $0$ and $n>1$.
:degrees: all
:where: $\omega_{n-2}\omega_{n-1}\omega_n\ne0$
:over: n: -; x# y# z#: edges; f# g# p q r: -
:control: the factor $(n-1)/n$ in the torsion
:::
*/
CLAIM(curvature_and_torsion_follow_at_one_in_every_degree) { G(compare_end_curvature_and_torsion)(T, 1); }

/*
What is compared is $\kappa^2$.  That $\kappa$ is the printed side and not its negative is where positive weights are used.

:::{claim} factor_of_the_curvature_is_positive
:title: With positive weights the factor of the end curvature is positive, for every n
:zh: 正权时端点曲率公式的系数为正(任意次数)
:given: $n>1$, positive weights $\omega_0,\omega_1,\omega_2$, or $\omega_n,\omega_{n-1},\omega_{n-2}$ in their places
:then: $\frac{n-1}n\frac{\omega_0\omega_2}{\omega_1^2}>0$, so that $\kappa(0)$, or $\kappa(1)$, and the printed side, two numbers that are not negative and
  have the same square, are equal
:method: A quotient of products of positive numbers, $n-1$ among them.  For $n=1$ the factor is 0.
:degrees: all
:over: n: -
:control: $1-n$ for $n-1$
:::
*/
CLAIM(factor_of_the_curvature_is_positive)
{
    num more = whole(T, "n", 1, 9), n = add(more, from_int(1)), w[3];
    for (int i = 0; i < 3; i++)
        w[i] = positive(T, "w", i);
    num share = div(fault(T, more, neg(more)), n);
    G(must_be_positive)(T, mul(share, div(mul(w[0], w[2]), mul(w[1], w[1]))));
}

/*
:::{statement} wang-ch3:prop-3.2.4-step-9
:title: The same at t = 1
:zh: t=1 处同理
:printed: In the same way one has $\kappa(1)$ and $\tau(1)$.
:holds-by: curvature_and_torsion_follow_at_one_in_every_degree derivative_vectors_at_one_in_every_degree
  factor_of_the_curvature_is_positive bernstein_sum_begins_with_its_differences curvature_belongs_to_arc_length
  torsion_belongs_to_arc_length
:confirmed-by: end_derivative_vectors_at_both_ends end_curvature_at_one end_torsion_at_one
:needs: negative_weight_makes_printed_curvature_negative | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  the weights are positive for the curvature; the example is read in reversed order.
:needs: repeated_first_points_leave_curvature_undetermined | property 3.2.4: no control points coincide | $\mathbf a_n\ne\mathbf
  0$; the example is read in reversed order.
:hypothesis: collinear_first_points_leave_torsion_undetermined | $\mathbf a_{n-1}\times\mathbf a_n\ne\mathbf 0$ for the torsion;
  the example is read in reversed order.

The same up to a sign: $\mathbf R''(1)$ has $-\mathbf a_{n-1}$ where $\mathbf R''(0)$ has $\mathbf a_2$.  The curvature does not see it, and in the torsion it
puts the edges into the order $(\mathbf a_{n-2},\mathbf a_{n-1},\mathbf a_n)$ of the print.
:::
*/
#include "chapters/judge/claims_off.h"
