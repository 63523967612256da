/*
# Degree elevation (升阶)

The same curve can be written with one more point.  The numerator and the denominator of the curve are
each a polynomial in Bernstein form, and each is elevated by itself; the points of the new polygon lie
on the edges of the old one.

:::{statement} wang-ch3:3.2.7
:title: The elevated points and weights give the same curve
:zh: 升阶公式
:printed: \mathbf R(t)=\frac{\sum_{i=0}^nB_i^n(t)\omega_i\mathbf R_i}{\sum_{i=0}^nB_i^n(t)\omega_i}
  =\frac{\sum_{i=0}^{n+1}B_i^{n+1}(t)\hat\omega_i\hat{\mathbf R}_i}{\sum_{i=0}^{n+1}B_i^{n+1}(t)\hat\omega_i}
:holds-by: elevation_keeps_rational_curve

:::

:::{claim} elevation_keeps_rational_curve
:title: Degree elevation changes the polygon, not the curve
:zh: 升阶改变控制多边形而不改变曲线
:given: weights $\omega_0,\dots,\omega_n$ and points $R_0,\dots,R_n$
:let: $\hat\omega_i=(1-\frac i{n+1})\omega_i+\frac i{n+1}\omega_{i-1}$ and
  $\hat\omega_i\hat R_i=(1-\frac i{n+1})\omega_iR_i+\frac i{n+1}\omega_{i-1}R_{i-1}$, $i=0,\dots,n+1$, what has
  an index outside $0,\dots,n$ being $0$
:then: the curves of $(R,\omega)$ and $(\hat R,\hat\omega)$ are one
:method: Both curves are computed at a variable $t$ as elements of one field of rational functions, with every
  weight and point a variable; equal elements are equal functions.
:degrees: 1..6 sampled 12
:control: the ratio $i/(n+1)$ taken as $i/(n+2)$ in the weights
:::
*/
#include "chapters/frame/claims_on.h"

CLAIM(elevation_keeps_rational_curve)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], we[MAX_DEGREE + 2], Re[MAX_DEGREE + 2], before, after;
    num t = parameter(T, "t");
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        R[i] = unknown(T, "R", i);
    }
    G(rational_elevate)(n, 1, R, w, Re, we);
    if (T->planted)
        for (int i = 1; i <= n; i++) {
            num a = from_ratio(i, n + 2);
            we[i] = add(mul(sub(from_int(1), a), w[i]), mul(a, w[i - 1]));
        }
    G(rational_point)(n, 1, R, w, t, &before);
    G(rational_point)(n + 1, 1, Re, we, t, &after);
    same(T, after, before);
}
#include "chapters/frame/claims_off.h"
