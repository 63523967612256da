/*
# Elevation

:::{statement} my-paper:2.1
:title: Elevated points
:printed: \hat P_i = \frac{i}{n+1} P_{i-1} + \left(1 - \frac{i}{n}\right) P_i
:refuted-by: printed_points_leave_the_curve
:class: misprint
:corrected: \hat P_i = \frac{i}{n+1} P_{i-1} + \left(1 - \frac{i}{n+1}\right) P_i
:corrected-by: elevated_points_keep_the_curve

The second fraction lacks a $+1$.
:::

:::{statement} my-paper:2.2
:title: A bound
:printed: 2t(1-t) \le \frac{1}{2}, \quad 0 \le t \le 1
:holds-by: middle_function_is_at_most_one_half
:::
*/
#include "exact/record/sign.h"

#include "chapters/judge/claims_on.h"

/* The points Q of degree n + 1 as the formula has them, m being the denominator of its second fraction. */
static void G(elevated)(int n, int m, const num P[], num Q[])
{
    Q[0] = P[0];
    for (int i = 1; i <= n; i++)
        Q[i] = add(mul(from_ratio(i, n + 1), P[i - 1]), mul(sub(from_int(1), from_ratio(i, m)), P[i]));
    Q[n + 1] = P[n];
}

/*
:::{claim} elevated_points_keep_the_curve
:title: The elevated points give the same curve
:given: a Bézier curve of degree $n$ with points $P_0,…,P_n$
:then: the curve of degree $n+1$ with the corrected points is the same
:method: Both are evaluated at $t$ by the algorithm of de Casteljau.
:degrees: 1..4
:control: the formula as it is printed
:::
*/
CLAIM(elevated_points_keep_the_curve)
{
    int n = T->degree;
    num P[5], Q[6], left, right, t = parameter(T, "t");
    for (int i = 0; i <= n; i++)
        P[i] = unknown(T, "P", i);
    G(elevated)(n, fault(T, n + 1, n), P, Q);
    G(bezier_casteljau)(n, 1, P, t, &left);
    G(bezier_casteljau)(n + 1, 1, Q, t, &right);
    same(T, left, right);
}

/*
:::{claim} printed_points_leave_the_curve
:title: The printed points do not give the same curve
:kind: counterexample
:data: P = 0 1; t = 1/2
:result: curve = 1/2; elevated = 1/4
:given: the curve of degree 1 from $P_0=0$ to $P_1=1$
:then: the curve with the printed points is elsewhere
:method: Both are evaluated at $t$ by the algorithm of de Casteljau.
:control: the corrected formula
:::
*/
CLAIM(printed_points_leave_the_curve)
{
    num P[2], Q[3], left, right, t = given(T, "t");
    given_points(T, "P", 2, 1, P);
    G(elevated)(1, fault(T, 2, 1), P, Q);
    G(bezier_casteljau)(1, 1, P, t, &left);
    G(bezier_casteljau)(2, 1, Q, t, &right);
    found(T, "curve", left);
    found(T, "elevated", right);
    about(T, "the curve and the elevated one at t");
    same(T, left, right);
}

#if RATIONAL
/*
:::{claim} middle_function_is_at_most_one_half
:title: The middle quadratic Bernstein function is at most one half
:kind: decision
:data: c = 1/2
:instead: c = 1/3
:given: $B_1^2(t) = 2t(1-t)$ on $[0, 1]$
:then: $B_1^2 \le c$, and no smaller $c$ is a bound
:method: $c - B_1^2$ is decided to be nonnegative on the closed interval and $0$ somewhere in it.
:scope: $0 \le t \le 1$
:control: a third, which the function exceeds
:::
*/
CLAIM(middle_function_is_at_most_one_half)
{
    num b[] = {from_int(0), from_int(1), from_int(0)};
    poly gap = poly_sub(poly_constant(given(T, "c")), poly_from_bernstein(2, b));
    agree(T, sign_on(gap, from_int(0), from_int(1), CLOSED) == SIGN_NONNEGATIVE);
}
#endif

#include "chapters/judge/claims_off.h"
