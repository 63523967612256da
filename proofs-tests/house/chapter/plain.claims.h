/*
# Elevation

:::{statement} my-paper:2.1
:title: Elevated points
:printed: \hat P_i = \frac{i}{n+1} P_{i-1} + \left(1 - \frac{i}{n}\right) P_i
:holds-by: elevated_points_keep_the_curve
:::
*/
#include "chapters/judge/claims_on.h"

/*
:::{claim} elevated_points_keep_the_curve
:title: The elevated points give the same curve
:given: a Bézier curve of degree $n$ with points $P_0,…,P_n$
:then: the curve of degree $n+1$ with the printed points is the same
:method: Both are evaluated at $t$ by the algorithm of de Casteljau.
:degrees: 1..4
:control: the first new point is $0$
:::
*/
CLAIM(elevated_points_keep_the_curve)
{
    int n = T->degree;
    num P[5], Q[6], left, right, t = parameter(T, "t");
    for (int i = 0; i <= n; i++)
        P[i] = unknown(T, "P", i);
    Q[0] = fault(T, 1, 0) ? P[0] : from_int(0);
    for (int i = 1; i <= n; i++)
        Q[i] = add(mul(from_ratio(i, n + 1), P[i - 1]), mul(sub(from_int(1), from_ratio(i, n)), P[i]));
    Q[n + 1] = P[n];
    G(bezier_casteljau)(n, 1, P, t, &left);
    G(bezier_casteljau)(n + 1, 1, Q, t, &right);
    about(T, "the curve and the elevated one at t");
    same(T, left, right);
}

#include "chapters/judge/claims_off.h"
