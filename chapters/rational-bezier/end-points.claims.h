/*
# What happens at the ends (端点性质)

A rational Bézier curve starts in its first point and ends in its last.  If the first $k$ points
coincide, the curve starts with a derivative of order $k$; the source prints that derivative, and
the one of order $h$ at the other end, side by side.

:::{statement} wang-ch3:3.2.3
:title: With repeated end points the first derivatives vanish
:zh: 端点重合时低阶导矢为零
:printed: \mathbf R(0)=\mathbf R_0,\ \mathbf R(1)=\mathbf R_n,\ \mathbf R^{(l)}(0)=\mathbf R^{(m)}(1)=\mathbf 0,\
  l=1,\dots,k-1,\ m=1,\dots,h-1
:holds-by: end_derivatives_with_repeated_points
:::

:::{statement} wang-ch3:3.2.4
:title: The first derivative that does not vanish, at both ends
:zh: 端点处首个非零导矢
:printed: \mathbf R^{(k)}(0)=\frac{n!}{(n-k)!}\frac{\omega_k}{\omega_0}(\mathbf R_k-\mathbf R_0),\quad
  \mathbf R^{(h)}(1)=\frac{n!}{(n-k)!}\frac{\omega_{n-h}}{\omega_n}(\mathbf R_n-\mathbf R_{n-h})
:class: misprint
:refuted-by: printed_end_derivative_at_one_is_wrong
:corrected: \mathbf R^{(k)}(0)=\frac{n!}{(n-k)!}\frac{\omega_k}{\omega_0}(\mathbf R_k-\mathbf R_0),\quad
  \mathbf R^{(h)}(1)=(-1)^{h+1}\frac{n!}{(n-h)!}\frac{\omega_{n-h}}{\omega_n}(\mathbf R_n-\mathbf R_{n-h})
:corrected-by: end_derivatives_with_repeated_points

The formula at $t=0$ is right.  The one at $t=1$ carries two slips: the factor is $n!/(n-h)!$, which is
the printed one only for $h=k$; and the sign $(-1)^{h+1}$ is missing, so that for even $h$ the
derivative points the other way even when $h=k$.
:::

:::{claim} end_derivatives_with_repeated_points
:title: End derivatives when the first k and the last h points coincide
:zh: 首 k 点、末 h 点重合时的端点导矢
:given: weights $\omega_0,\dots,\omega_n$, $\omega_0\omega_n\ne0$, and points with $R_0=\dots=R_{k-1}$ and
  $R_n=\dots=R_{n-h+1}$, for all $k,h\ge1$ with $k\le n$, $h\le n$
:then: $R^{(l)}(0)=0$ for $0<l<k$, $R^{(m)}(1)=0$ for $0<m<h$,
  $R^{(k)}(0)=\frac{n!}{(n-k)!}\frac{\omega_k}{\omega_0}(R_k-R_0)$ and
  $R^{(h)}(1)=(-1)^{h+1}\frac{n!}{(n-h)!}\frac{\omega_{n-h}}{\omega_n}(R_n-R_{n-h})$
:method: In the field of rational functions of the weights and the points both sides are one element.  The
  two ends are taken one at a time, so that every other point is free; a coordinate is any coordinate, so
  one suffices.
:degrees: 1..6 sampled 10
:control: the sign $(-1)^{h+1}$ left out
:::
*/
#include "chapters/frame/claims_on.h"

/* n!/(n-k)! */
static long G(falling)(int n, int k) { return k == 0 ? 1 : n * G(falling)(n - 1, k - 1); }

CLAIM(end_derivatives_with_repeated_points)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], D[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++)
        w[i] = positive(T, "w", i);

    for (int k = 1; k <= n; k++) { /* at t = 0 */
        for (int i = 0; i <= n; i++)
            R[i] = i < k && i > 0 ? R[0] : unknown(T, "R", i);
        G(rational_derivatives)(n, 1, R, w, from_int(0), k, D);
        about(T, "R^(l)(0)");
        for (int l = 1; l < k; l++)
            vanishes(T, D[l]);
        about(T, "R^(k)(0)");
        same(T, D[k], mul(mul(from_int(G(falling)(n, k)), div(w[k], w[0])), sub(R[k], R[0])));
    }
    for (int h = 1; h <= n; h++) { /* at t = 1 */
        for (int i = n; i >= 0; i--)
            R[i] = i > n - h && i < n ? R[n] : unknown(T, "R", i);
        G(rational_derivatives)(n, 1, R, w, from_int(1), h, D);
        about(T, "R^(m)(1)");
        for (int m = 1; m < h; m++)
            vanishes(T, D[m]);
        about(T, "R^(h)(1)");
        long sign = h % 2 == 1 || T->planted ? 1 : -1;
        same(T, D[h], mul(mul(from_int(sign * G(falling)(n, h)), div(w[n - h], w[n])), sub(R[n], R[n - h])));
    }
}

#if RATIONAL
/*
:::{claim} printed_end_derivative_at_one_is_wrong
:title: At t = 1 the printed derivative has the wrong factor and the wrong sign
:zh: t=1 处所印导矢的系数与符号均误
:kind: counterexample
:given: the quadratic over the interval $[0,1]$ of the real line with points $0,1,1$ and weights $1$: $k=1$, $h=2$
:then: the printed $R''(1)=\frac{2!}{1!}\frac{\omega_0}{\omega_2}(R_2-R_0)$ is not the second derivative
:method: Both sides are computed exactly.
:control: the factor taken with $h$ for $k$, and the sign $(-1)^{h+1}$ supplied
:::
*/
CLAIM(printed_end_derivative_at_one_is_wrong)
{
    enum { n = 2, k = 1, h = 2 };
    num w[n + 1], R[n + 1] = {from_int(0), from_int(1), from_int(1)}, D[h + 1];
    for (int i = 0; i <= n; i++)
        w[i] = from_int(1);
    show_points(T, "R", n + 1, 1, R);
    show_points(T, "ω", n + 1, 1, w);
    about(T, "R''(1), left as it is, right as printed");
    G(rational_derivatives)(n, 1, R, w, from_int(1), h, D);
    long factor = T->planted ? -G(falling)(n, h) : G(falling)(n, k);
    same(T, D[h], mul(mul(from_int(factor), div(w[n - h], w[n])), sub(R[n], R[n - h])));
}
#endif
#include "chapters/frame/claims_off.h"
