/*
# What happens at the ends (端点性质)

A rational Bézier curve starts in its first point, in the direction of the first edge, and ends in its last point, in the
direction of the last edge.  If the first $k$ points coincide, the derivatives of order $1,\dots,k-1$ vanish at $t=0$ and
the edge $R_0R_k$ takes over.  The source prints what the derivatives of order $k$ and $h$ are at both ends, side by side;
the right one carries two slips, both invisible in the usual case $k=h=1$.
*/
#include "exact/record/roots.h"

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

/*
## End points and end tangents

:::{statement} wang-ch3:prop-3.2.3
:title: The curve joins the end points and is tangent to the end edges
:zh: 端点插值性
:printed: Interpolation of the end points: the curve passes through the end points of its B-net and is tangent to the end edges of the B-net.
:holds-by: first_power_decides_the_end_derivative mean_grows_by_one_term end_direction_has_a_positive_factor
:confirmed-by: curve_leaves_its_ends_along_the_first_edges end_derivatives_at_zero_with_repeated_points
  end_derivatives_at_one_with_repeated_points
:needs: zero_end_weight_loses_the_end_point | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  $\omega_0\ne0$ and $\omega_n\ne0$: for the curve to pass through the end points.
:needs: zero_weight_turns_the_end_tangent | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\omega_k\ne0$
  and $\omega_{n-h}\ne0$: at simple ends $\omega_1$ and $\omega_{n-1}$; for the tangent to be that of the edge.  With $n=2$, as in the example,
  $\omega_1$ is both; points and weights are symmetric there, so that the curve is not tangent to the last edge either.
:needs: negative_weight_reverses_the_end_tangent | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  $\omega_k/\omega_0>0$ and $\omega_{n-h}/\omega_n>0$: for the curve to leave towards $R_k$ and to arrive from $R_{n-h}$:
  otherwise the edge is on the tangent, but behind the end point.
:meant: the formulas (3.2.3) and (3.2.4), which stand below it and have multiple end points and, for positive weights, positive factors | The end edges are the
  first and the last of positive length, $R_0R_k$ and $R_{n-h}R_n$, and the curve goes along them, not against them.
:figure: end_tangents

Where all points coincide there is neither an edge nor a tangent, and the curve is that point.
:::
*/

/* dim coordinates of points of which R_0 = ... = R_{k-1}, and nothing else is asked. */
static inline void G(repeated_at_start)(trial *T, int n, int dim, int k, num R[])
{
    static const char *const axis[] = {"x", "y"};
    for (int i = 0; i <= n; i++)
        for (int c = 0; c < dim; c++)
            R[i * dim + c] = i > 0 && i < k ? R[c] : unknown(T, axis[c], i);
}

/*
"Tangent to the end edge" means two things: the edge is on the tangent, and it points the way the curve goes.  The
derivative that decides it is the first one that is not 0, of order $k$ when the first $k$ points coincide.  At $t=1$ it has
to be taken with the sign $(-1)^{h+1}$, since the curve is followed towards the end.

:::{claim} curve_leaves_its_ends_along_the_first_edges
:title: The first derivative that does not vanish points along the first edge of positive length
:zh: 首个非零导矢沿首条非零边
:given: points of the plane with $R_0=\dots=R_{k-1}$ (and in reversed order $R_n=\dots=R_{n-h+1}$), positive weights, all
  $k,h\ge1$ with $k\le n$, $h\le n$
:then: $R^{(k)}(0)\times(R_k-R_0)=0$ and $R^{(k)}(0)\cdot(R_k-R_0)/|R_k-R_0|^2>0$; the same for $(-1)^{h+1}R^{(h)}(1)$ and
  $R_n-R_{n-h}$
:method: The first is $0$ in the field; the second has positive coefficients in the weights and contains nothing else.
  With (3.2.3) the curve is $R_0+\frac{t^k}{k!}R^{(k)}(0)$ up to higher powers of $t$, and
  $R_n-\frac{(1-t)^h}{h!}(-1)^{h+1}R^{(h)}(1)$ at the other end, so these vectors are the directions in which it leaves
  and arrives.
:degrees: 1..5 sampled 10
:control: the sign $(-1)^{h+1}$ left out
:::
*/
/* The polygon and its weights in the opposite order. */
static inline void G(reverse)(int n, int dim, num R[], num w[])
{
    for (int i = 0, j = n; i < j; i++, j--) {
        num kept = w[i];
        w[i] = w[j];
        w[j] = kept;
        for (int c = 0; c < dim; c++) {
            kept = R[i * dim + c];
            R[i * dim + c] = R[j * dim + c];
            R[j * dim + c] = kept;
        }
    }
}

CLAIM(curve_leaves_its_ends_along_the_first_edges)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[(MAX_DEGREE + 1) * 2], D[(MAX_DEGREE + 1) * 2], edge[2];
    for (int i = 0; i <= n; i++)
        w[i] = positive(T, "w", i);
    for (int end = 0; end <= 1; end++)
        for (int k = 1; k <= n; k++) {
            G(repeated_at_start)(T, n, 2, k, R);
            int first = 0, other = k;
            if (end == 1) {
                G(reverse)(n, 2, R, w);
                first = n, other = n - k;
            }
            G(rational_derivatives)(n, 2, R, w, from_int(end), k, D);
            for (int c = 0; c < 2; c++) /* from the end point away, at both ends */
                edge[c] = sub(R[other * 2 + c], R[first * 2 + c]);
            num direction[] = {D[2 * k], D[2 * k + 1]}; /* at t = 1 away from the end: (-1)^h R^(h)(1) */
            for (int c = 0; c < 2 && end == 1 && fault(T, k % 2 == 1, 1); c++)
                direction[c] = neg(direction[c]);
            about(T, "direction x edge");
            vanishes(T, G(cross2)(direction, edge));
            about(T, "direction . edge / edge . edge > 0");
            nonnegative(T, div(G(norm_squared)(2, edge), G(dot)(2, direction, edge)));
        }
}

#if RATIONAL
/*
Each weight that occurs in the derivative can spoil it.  If $\omega_1$ is 0, the first edge loses its influence, and the
next point takes over; if it is negative, the curve leaves in the opposite direction; and if $\omega_0$ is 0, it does not
even begin in $R_0$.

:::{claim} zero_weight_turns_the_end_tangent
:title: With ω_1 = 0 the curve is not tangent to its first edge
:zh: ω_1 = 0 时曲线不切于首边
:kind: counterexample
:data: R = (0,0) (1,2) (2,0); ω = 1 0 1
:instead: ω = 1 1 1
:result: R'(0) = (0,0); R''(0) = (4,0)
:given: the quadratic curve with points $R$ and weights $\omega$
:then: $R''(0)$ is the first derivative that does not vanish, and it is along the chord $R_0R_2$
:method: The derivatives are computed exactly; the first that is not $0$ is compared with the first edge.
:control: equal weights, where already $R'(0)$ is along the edge
:::
*/
CLAIM(zero_weight_turns_the_end_tangent)
{
    num R[6], w[3], D[6], edge[2];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    G(rational_derivatives)(2, 2, R, w, from_int(0), 2, D);
    int order = is_zero_q(D[2]) && is_zero_q(D[3]) ? 2 : 1;
    for (int c = 0; c < 2; c++)
        edge[c] = sub(R[2 + c], R[c]);
    found_points(T, "R'(0)", 1, 2, D + 2);
    found_points(T, "R''(0)", 1, 2, D + 4);
    about(T, "cross product of the first edge and the first derivative that is not 0");
    vanishes(T, G(cross2)(edge, D + 2 * order));
}

/*
:::{claim} negative_weight_reverses_the_end_tangent
:title: With the weights 1, −1/2, 1 the curve leaves R_0 away from R_1
:zh: 权为 1, −1/2, 1 时曲线自 R_0 背离 R_1
:kind: counterexample
:data: R = (0,0) (1,2) (2,0); ω = 1 -1/2 1
:instead: ω = 1 1/2 1
:result: zeros of ω(t) in [0,1] = 0; R'(0) = (-1,-2); R'(1) = (-1,2)
:given: the quadratic curve with points $R$ and weights $\omega$, the middle one of which is negative
:then: $\omega(t)$ has no zero in $[0,1]$, $R'(0)$ is opposite to the first edge, and $R'(1)$ to the last one
:method: The derivatives are computed exactly.
:control: the middle weight made positive
:::
*/
CLAIM(negative_weight_reverses_the_end_tangent)
{
    num R[6], w[3], D[4], edge[2];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    int zeros = count_roots(poly_from_bernstein(2, w), from_int(0), from_int(1), CLOSED).distinct;
    int against = 0;
    found_whole(T, "zeros of ω(t) in [0,1]", zeros);
    for (int end = 0; end < 2; end++) {
        G(rational_derivatives)(2, 2, R, w, from_int(end), 1, D);
        for (int c = 0; c < 2; c++)
            edge[c] = sub(R[2 * end + 2 + c], R[2 * end + c]);
        found_points(T, end == 0 ? "R'(0)" : "R'(1)", 1, 2, D + 2);
        against += zeros == 0 && sign_q(G(dot)(2, edge, D + 2)) < 0;
    }
    about(T, "whether the scalar product of the edge and the derivative is not negative, at one of the two ends");
    agree(T, against <= fault(T, 0, 1)); /* the control: at both */
}
#endif

#if FIELD
/*
:::{claim} zero_end_weight_loses_the_end_point
:title: With ω_0 = 0 the curve does not pass through R_0, with ω_n = 0 not through R_n
:zh: ω_0 = 0 时曲线不过 R_0, ω_n = 0 时不过 R_n
:kind: counterexample
:types: field
:data: R = R0 R1; ω = 0 w1; ω* = w0 0
:instead: ω = 1 w1; ω* = w0 1
:result: R(t) = R1; R(t), continued to the start = R1; R*(t) = R0; R*(t), continued to the end = R0
:given: $n=1$, any points $R_0,R_1$, weights $\omega$ of which the first is 0 and the other any $\omega_1\ne0$, and weights $\omega^*$ of which the last is 0 and the other any
  $\omega_0\ne0$
:then: $R(t)=\omega_1R_1t/(\omega_1t)$ is $R_1$ for every $t\ne0$; at $t=0$ this quotient is $0/0$ and its continuation is
  $R_1$, not $R_0$; so $R^*(t)$ is $R_0$ for every $t\ne1$, and its continuation to $t=1$ is $R_0$, not $R_1$
:method: In the field of rational functions $R(t)$ is the constant $R_1$, and $R^*(t)$ the constant $R_0$.
:control: weights at the ends that are not 0, and $t=0$ and $t=1$ put into the quotients
:::
*/
CLAIM(zero_end_weight_loses_the_end_point)
{
    num R[2], w[2][2], t = parameter(T, "t"), point[2], continued[2];
    given_points(T, "R", 2, 1, R);
    given_points(T, "ω", 2, 1, w[0]);
    given_points(T, "ω*", 2, 1, w[1]);
    for (int end = 0; end < 2; end++) {
        G(rational_point)(1, 1, R, w[end], t, &point[end]);
        continued[end] = substitute_f(point[end], t, from_int(end));
    }
    found(T, "R(t)", point[0]);
    found(T, "R(t), continued to the start", continued[0]);
    found(T, "R*(t)", point[1]);
    found(T, "R*(t), continued to the end", continued[1]);
    about(T, "whether R(t), continued to t = 0, is R_0, or R*(t), continued to t = 1, is R_1");
    int lost = !is_zero_f(sub(continued[0], R[0])) + !is_zero_f(sub(continued[1], R[1]));
    agree(T, lost <= fault(T, 0, 1)); /* the control: both */
}
#endif

/*
:::{statement} wang-ch3:3.2.3-multiplicities
:title: How many points coincide at each end
:zh: 两端的重点数
:definition: yes
:printed: \mathbf R_0=\mathbf R_1=\dots=\mathbf R_{k-1}\ne\mathbf R_k,\quad\mathbf R_n=\mathbf R_{n-1}=\dots=\mathbf
  R_{n-h+1}\ne\mathbf R_{n-h},\quad k,h\ge1
:checked-by: two_multiplicities_leave_an_edge
:confirmed-by: multiplicities_fit_into_the_polygon
:meant: the formulas (3.2.3) and (3.2.4) behind it | The line is the condition of what follows it, when …, then …; in the text at hand a stray sign of
  equality stands before it and a quantifier over $t$ behind it.

The numbers $k$ and $h$ exist unless all points coincide, and then $k+h\le n+1$.
:::

:::{claim} two_multiplicities_leave_an_edge
:title: With a first and a last change, k + h ≤ n + 1
:zh: 有首末变化处时 k + h ≤ n + 1
:given: a polygon $R_0,\dots,R_n$ of which not all points coincide; $R_k$ the first point that differs from the one before it, $R_l$ the last one, so that
  $l=k+m$, $m\ge0$
:where: not all points coincide
:then: the last $h=n+1-l$ points coincide, $R_{n-h}\ne R_{n-h+1}$, and $n+1-(k+h)=m\ge0$
:method: Where not all points coincide there is a first and a last change, and the first one does not stand behind the last.  The numbers are variables.
:degrees: all
:over: k m r: -
:control: one point counted at both ends
:::
*/
CLAIM(two_multiplicities_leave_an_edge)
{
    num one = from_int(1), k = whole(T, "k", 1, 6), m = whole(T, "m", 0, 6), behind = whole(T, "r", 0, 6);
    num l = add(k, m), n = add(l, behind), h = sub(add(n, one), l);
    num left = sub(add(n, one), add(k, fault(T, h, add(h, one))));
    about(T, "what is left of n + 1");
    same(T, left, m);
    nonnegative(T, m);
    about(T, "the last change is between the numbers n - h and n - h + 1");
    same(T, sub(n, h), sub(l, one));
}

#if RATIONAL
/*
For the lower degrees all patterns can be visited.

:::{claim} multiplicities_fit_into_the_polygon
:title: Unless all points coincide, k and h exist and k + h ≤ n + 1
:zh: 除非全部重合，k 与 h 存在且 k + h ≤ n + 1
:kind: decision
:given: every pattern of equal and different neighbours in a polygon of $n+1$ points
:then: $k$ is the number of points before the first $R_i\ne R_{i-1}$, $h$ the number after the last one; they exist unless
  the pattern has none, and $k+h\le n+1$
:method: All $2^n$ patterns are visited.
:degrees: 1..12
:scope: all patterns of equal neighbours
:control: the bound $n$ for $k+h$
:::
*/
CLAIM(multiplicities_fit_into_the_polygon)
{
    int n = T->degree;
    for (int differs = 0; differs < 1 << n; differs++) { /* bit i-1: R_i is not R_{i-1} */
        int k = 1, h = 1;
        while (k <= n && !(differs >> (k - 1) & 1))
            k++;
        while (h <= n && !(differs >> (n - h) & 1))
            h++;
        int exist = k <= n && h <= n;
        agree(T, exist == (differs != 0));
        agree(T, !exist || k + h <= fault(T, n + 1, n));
    }
}
#endif

/*
## End derivatives with repeated points

:::{statement} wang-ch3:3.2.3-left
:title: At t = 0: the end point, and derivatives that vanish
:zh: t=0 处的端点与零导矢
:printed: When $\mathbf R_0=\mathbf R_1=\dots=\mathbf R_{k-1}\ne\mathbf R_k$, $k\ge1$:
  $\mathbf R(0)=\mathbf R_0,\quad\mathbf R^{(l)}(0)=\mathbf 0,\quad l=1,2,\dots,k-1$
:holds-by: first_power_decides_the_end_derivative mean_grows_by_one_term
:confirmed-by: end_derivatives_in_every_degree end_derivatives_at_zero_with_repeated_points
:needs: zero_end_weight_loses_the_end_point | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  $\omega_0=\omega(0)\ne0$.
:::
*/

/*
The number before $\frac{\omega_k}{\omega_0}(R_k-R_0)$ is the product of $k$ factors $n(n-1)\cdots$, not a binomial
coefficient; for $k=1$ the two are the same, and a slip would not be seen.

:::{claim} end_derivatives_at_zero_with_repeated_points
:title: End derivatives when the first k points coincide
:zh: 首 k 点重合时的端点导矢
:given: weights $\omega_0,\dots,\omega_n$, $\omega_0\ne0$, and points with $R_0=\dots=R_{k-1}$, for all $k$ from $1$ to $n$
:where: $\omega_0\ne0$
:then: $R(0)=R_0$, $R^{(l)}(0)=0$ for $0<l<k$, and $R^{(k)}(0)=\frac{n!}{(n-k)!}\frac{\omega_k}{\omega_0}(R_k-R_0)$
:method: In the field of rational functions of the weights and the points both sides are one element.  A coordinate is any
  coordinate, so one suffices.
:degrees: 1..6 sampled 10
:control: the factor $\binom nk$ for $n!/(n-k)!$, a slip that only $k\ge2$ shows
:::
*/
CLAIM(end_derivatives_at_zero_with_repeated_points)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], D[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++)
        w[i] = positive(T, "w", i);
    for (int k = 1; k <= n; k++) {
        G(repeated_at_start)(T, n, 1, k, R);
        G(rational_derivatives)(n, 1, R, w, from_int(0), k, D);
        about(T, "R(0)");
        same(T, D[0], R[0]);
        about(T, "R^(l)(0)");
        for (int l = 1; l < k; l++)
            vanishes(T, D[l]);
        about(T, "R^(k)(0)");
        long factor = G(falling_factorial)(n, k) / fault(T, 1, G(falling_factorial)(k, k));
        /* R^(k)(0) = n!/(n-k)! ω_k/ω_0 (R_k - R_0) */
        same(T, D[k], mul(mul(from_int(factor), div(w[k], w[0])), sub(R[k], R[0])));
    }
}

/*
:::{statement} wang-ch3:3.2.3-right
:title: At t = 1: the end point, and derivatives that vanish
:zh: t=1 处的端点与零导矢
:printed: When $\mathbf R_n=\mathbf R_{n-1}=\dots=\mathbf R_{n-h+1}\ne\mathbf R_{n-h}$, $h\ge1$:
  $\mathbf R(1)=\mathbf R_n,\quad\mathbf R^{(m)}(1)=\mathbf 0,\quad m=1,2,\dots,h-1$
:holds-by: first_power_decides_the_end_derivative mean_grows_by_one_term
:confirmed-by: end_derivatives_in_every_degree end_derivatives_at_one_with_repeated_points
:needs: zero_end_weight_loses_the_end_point | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  $\omega_n=\omega(1)\ne0$.
:::

:::{claim} end_derivatives_at_one_with_repeated_points
:title: End derivatives when the last h points coincide
:zh: 末 h 点重合时的端点导矢
:given: weights $\omega_0,\dots,\omega_n$, $\omega_n\ne0$, and points with $R_n=\dots=R_{n-h+1}$, for all $h$ from $1$ to $n$
:where: $\omega_n\ne0$
:then: $R(1)=R_n$, $R^{(m)}(1)=0$ for $0<m<h$, and
  $R^{(h)}(1)=(-1)^{h+1}\frac{n!}{(n-h)!}\frac{\omega_{n-h}}{\omega_n}(R_n-R_{n-h})$
:method: In the field of rational functions of the weights and the points both sides are one element.
:degrees: 1..6 sampled 10
:control: the sign $(-1)^{h+1}$ left out
:::
*/
CLAIM(end_derivatives_at_one_with_repeated_points)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], D[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++)
        w[i] = positive(T, "w", i);
    for (int h = 1; h <= n; h++) {
        for (int i = n; i >= 0; i--)
            R[i] = i > n - h && i < n ? R[n] : unknown(T, "x", i);
        G(rational_derivatives)(n, 1, R, w, from_int(1), h, D);
        about(T, "R(1)");
        same(T, D[0], R[n]);
        about(T, "R^(m)(1)");
        for (int m = 1; m < h; m++)
            vanishes(T, D[m]);
        about(T, "R^(h)(1)");
        long sign = fault(T, h % 2 == 1 ? 1 : -1, 1);
        /* R^(h)(1) = (-1)^{h+1} n!/(n-h)! ω_{n-h}/ω_n (R_n - R_{n-h}) */
        same(T, D[h], mul(mul(from_int(sign * G(falling_factorial)(n, h)), div(w[n - h], w[n])), sub(R[n], R[n - h])));
    }
}

/*
:::{statement} wang-ch3:3.2.4-left
:title: At t = 0: the first derivative that does not vanish
:zh: t=0 处首个非零导矢
:printed: When $\mathbf R_0=\mathbf R_1=\dots=\mathbf R_{k-1}\ne\mathbf R_k$, $k\ge1$:
  $\mathbf R^{(k)}(0)=\frac{n!}{(n-k)!}\frac{\omega_k}{\omega_0}(\mathbf R_k-\mathbf R_0)$
:holds-by: first_power_decides_the_end_derivative mean_grows_by_one_term
:confirmed-by: end_derivatives_in_every_degree end_derivatives_at_zero_with_repeated_points
:needs: zero_end_weight_loses_the_end_point | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  $\omega_0=\omega(0)\ne0$: the formula divides by it, and without it the curve need not begin in $R_0$.
:figure: end_tangents
:::

:::{statement} wang-ch3:3.2.4-right
:title: At t = 1: the first derivative that does not vanish
:zh: t=1 处首个非零导矢
:printed: When $\mathbf R_0=\mathbf R_1=\dots=\mathbf R_{k-1}\ne\mathbf R_k$, $\mathbf R_n=\mathbf R_{n-1}=\dots=\mathbf
  R_{n-h+1}\ne\mathbf R_{n-h}$, $k,h\ge1$: $\mathbf R^{(h)}(1)=\frac{n!}{(n-k)!}\frac{\omega_{n-h}}{\omega_n}(\mathbf R_n-\mathbf R_{n-h})$
:class: misprint
:refuted-by: printed_end_derivative_at_one_has_the_wrong_sign printed_end_derivative_at_one_has_the_wrong_factor
:corrected: \mathbf R^{(h)}(1)=(-1)^{h+1}\frac{n!}{(n-h)!}\frac{\omega_{n-h}}{\omega_n}(\mathbf R_n-\mathbf R_{n-h})
:corrected-by: first_power_decides_the_end_derivative mean_grows_by_one_term
:confirmed-by: end_derivatives_in_every_degree end_derivatives_at_one_with_repeated_points two_multiplicities_leave_an_edge
:needs: zero_end_weight_loses_the_end_point | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  $\omega_n=\omega(1)\ne0$: the formula divides by it, and without it the curve need not end in $R_n$.
:striking: 3
:figure: end_derivatives

Two slips that do not depend on each other.  The factor is $n!/(n-h)!$; since $k+h\le n+1$, the printed one differs from it
for the first time at $n=3$.  And the sign $(-1)^{h+1}$ is missing: for even $h$ the derivative points the other way.  The
print is right for $h=k$ odd, in particular for simple end points, and for $h=1$, $k=2$, $n=2$.
:::

### In every degree

At $t=0$ the sum $\sum B_i^n(t)c_i$ has the Taylor coefficients $\binom nj\Delta^jc_0$, which are polynomials in $n$.  So
the derivatives of low order are rational functions of $n$, too, and $n$ itself can be a variable.

:::{claim} end_derivatives_in_every_degree
:title: The end derivatives hold for every n
:zh: 端点导矢公式对任意 n 成立
:given: any $n$; $k=1,\dots,5$, $k\le n$; weights and points with $R_0=\dots=R_{k-1}$; the same polygon in reversed order
:then: $R^{(l)}(0)=0$ for $0<l<k$ and $R^{(k)}(0)=n(n-1)\cdots(n-k+1)\frac{\omega_k}{\omega_0}(R_k-R_0)$; for the reversed
  polygon, whose curve is $R(1-t)$, these are $(-1)^lR^{(l)}(1)$, which gives the sign at $t=1$
:method: Numerator and denominator are expanded at $t=0$ up to $t^k$, with $\binom nj=n(n-1)\cdots(n-j+1)/j!$ as a
  polynomial in the variable $n$, and divided as power series.  For an integer $n<j$ that binomial coefficient is $0$, so
  the points that do not exist do not matter.
:degrees: all
:scope: k and h from 1 to 5
:over: n: -
:control: $\binom{n-1}j$ for $\binom nj$ in the numerator
:::
*/
/* c_0 ... c_k -> C(n,j) times the j-th forward difference of c at 0, j = 0 ... k, for any number n. */
static inline void G(series_of_bernstein_sum)(num n, int k, const num c[], num out[])
{
    num choose = from_int(1), d[MAX_DEGREE + 1];
    for (int j = 0; j <= k; j++)
        d[j] = c[j];
    for (int j = 0; j <= k; j++) {
        out[j] = mul(choose, d[0]);
        choose = mul(choose, div(sub(n, from_int(j)), from_int(j + 1)));
        for (int i = 0; i < k - j; i++)
            d[i] = sub(d[i + 1], d[i]);
    }
}

CLAIM(end_derivatives_in_every_degree)
{
    enum { K = 5 };
    num n = add(positive(T, "n", 0), from_int(K)), w[K + 1], R[K + 1], b[K + 1], P[K + 1], W[K + 1], Q[K + 1];
    for (int i = 0; i <= K; i++)
        w[i] = positive(T, "w", i);
    for (int k = 1; k <= K; k++) {
        for (int i = 0; i <= K; i++)
            R[i] = i > 0 && i < k ? R[0] : unknown(T, "x", i);
        for (int i = 0; i <= K; i++)
            b[i] = mul(w[i], R[i]);
        G(series_of_bernstein_sum)(fault(T, n, sub(n, from_int(1))), k, b, P);
        G(series_of_bernstein_sum)(n, k, w, W);
        for (int l = 0; l <= k; l++) { /* P = W Q */
            Q[l] = P[l];
            for (int j = 1; j <= l; j++)
                Q[l] = sub(Q[l], mul(W[j], Q[l - j]));
            Q[l] = div(Q[l], W[0]);
        }
        same(T, Q[0], R[0]);
        for (int l = 1; l < k; l++)
            vanishes(T, Q[l]);
        num factor = from_int(1);
        for (int j = 0; j < k; j++)
            factor = mul(factor, sub(n, from_int(j)));
        /* R^(k)(0) = n (n-1) ... (n-k+1) ω_k/ω_0 (R_k - R_0) */
        num wanted = mul(mul(factor, div(w[k], w[0])), sub(R[k], R[0]));
        same(T, mul(from_int(G(falling_factorial)(k, k)), Q[k]), wanted); /* R^(k) = k! Q_k */
    }
}

/*
### The two slips at t = 1
*/

#if RATIONAL
/* A curve on the line whose first k and last h points coincide. */
struct G(last_end) {
    int n, k, h;
    num R[4], w[4];
};

/* That of the data of the claim; n is its degree. */
static struct G(last_end) G(given_last_end)(trial *T, int n)
{
    struct G(last_end) e = {.n = given_whole(T, "n")};
    e.k = given_whole(T, "k");
    e.h = given_whole(T, "h");
    given_points(T, "R", n + 1, 1, e.R);
    given_points(T, "ω", n + 1, 1, e.w);
    return e;
}

/* Compares R^(h)(1) with factor ω_{n-h}/ω_n (R_n - R_{n-h}); both are results. */
static void G(compare_last_derivative)(trial *T, struct G(last_end) e, long factor)
{
    num D[4], edge = sub(e.R[e.n], e.R[e.n - e.h]);
    G(rational_derivatives)(e.n, 1, e.R, e.w, from_int(1), e.h, D);
    num printed = mul(mul(from_int(factor), div(e.w[e.n - e.h], e.w[e.n])), edge);
    found(T, "R^(h)(1)", D[e.h]);
    found(T, "R^(h)(1) as printed", printed);
    about(T, "R^(h)(1), left as it is, right as printed");
    same(T, D[e.h], printed);
}

/*
Each slip has its own example.  For the sign, $h=2$ in the least degree, where $(n-k)!$ and $(n-h)!$ agree.  For the factor,
$h=1$, where the sign is right, in the least degree in which $k$ and $h$ can give different factorials.

:::{claim} printed_end_derivative_at_one_has_the_wrong_sign
:title: At t = 1 the printed derivative of even order has the wrong sign
:zh: t=1 处所印偶数阶导矢符号有误
:kind: counterexample
:data: n = 2; k = 1; h = 2; R = 0 1 1; ω = 1 1 1
:result: R^(h)(1) = -2; R^(h)(1) as printed = 2
:given: a quadratic curve on the line with equal weights, whose last two points coincide, $h=n$, while $k$ is as small as
  it can be
:then: $R^{(h)}(1)$ is the negative of what is printed, although $(n-k)!$ and $(n-h)!$ do not differ
:method: Both sides are computed exactly.
:control: the sign $(-1)^{h+1}$ supplied
:::
*/
CLAIM(printed_end_derivative_at_one_has_the_wrong_sign)
{
    struct G(last_end) e = G(given_last_end)(T, 2);
    int sign = fault(T, e.h % 2 == 0 ? -1 : 1, 1);
    G(compare_last_derivative)(T, e, sign * G(falling_factorial)(e.n, e.k));
}

/*
:::{claim} printed_end_derivative_at_one_has_the_wrong_factor
:title: At t = 1 the printed derivative has the wrong factor
:zh: t=1 处所印导矢系数有误
:kind: counterexample
:data: n = 3; k = 2; h = 1; R = 0 0 1 2; ω = 1 1 1 1
:result: R^(h)(1) = 3; R^(h)(1) as printed = 6; pairs k, h with different factors in a smaller degree = 0
:given: a cubic curve on the line with equal weights, whose first $k$ points coincide, while the last point is simple
:then: $R^{(h)}(1)$ is smaller than what is printed, with the right sign; in no smaller degree has a pair $k,h\ge1$, $k+h\le n+1$, two different factors
  $\frac{n!}{(n-k)!}$ and $\frac{n!}{(n-h)!}$
:method: Both sides are computed exactly.  No smaller degree shows this slip: for $n\le2$ all pairs with $k+h\le n+1$ are visited, and
  $\frac{n!}{(n-k)!}=\frac{n!}{(n-h)!}$.
:control: the factor $n!/(n-h)!$
:::
*/
CLAIM(printed_end_derivative_at_one_has_the_wrong_factor)
{
    struct G(last_end) e = G(given_last_end)(T, 3);
    int two_factors = 0;
    for (int n = 1; n < e.n; n++)
        for (int k = 1; k <= n; k++)
            for (int h = 1; k + h <= n + 1; h++)
                two_factors += G(falling_factorial)(n, k) != G(falling_factorial)(n, h);
    found_whole(T, "pairs k, h with different factors in a smaller degree", two_factors);
    G(compare_last_derivative)(T, e, G(falling_factorial)(e.n, fault(T, e.h, e.k)));
}
#endif

/*
## The expansion behind it

:::{statement} wang-ch3:3.2.4-expansion
:title: The curve expanded about its first point
:zh: 曲线在首点处的展开式
:printed: When $\mathbf R_0=\mathbf R_1=\dots=\mathbf R_{k-1}\ne\mathbf R_k$, $k\ge1$:
  $\mathbf R(t)=\mathbf R_0+\left\{t^k\left[\binom nk(1-t)^{n-k}\omega_k(\mathbf R_k-\mathbf R_0)\right]
  +t^{k+1}\sum_{i=k+1}^n\binom ni(1-t)^{n-i}t^{i-k-1}\omega_i(\mathbf R_i-\mathbf R_0)\right\}\Big/\omega(t)$
:holds-by: mean_grows_by_one_term
:confirmed-by: curve_expands_about_its_first_point first_power_decides_the_end_derivative
:needs: weights_of_both_signs_make_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  $\omega(t)\ne0$; for which positive weights suffice: otherwise there may be no point.

The differences $\mathbf R_i-\mathbf R_0$ have the same mean as the points, less $\mathbf R_0$: this is the claim with $f(X)=X-\mathbf R_0$, coordinate by
coordinate.  Those with $i<k$ are 0, and $B_i^n(t)=\binom ni(1-t)^{n-i}t^i$ is written out.
:::

:::{claim} curve_expands_about_its_first_point
:title: R(t) − R_0 begins with the power t^k
:zh: R(t) − R_0 以 t^k 开始
:given: weights, points with $R_0=\dots=R_{k-1}$, a parameter $t$, all $k$ from $1$ to $n$
:then: the printed expansion, in which the sum is empty for $k=n$
:method: Both sides are one element of the field of rational functions of $t$, the weights and the points.
:degrees: 1..6 sampled 10
:control: the power $t^{i-k}$ in the sum
:::
*/
CLAIM(curve_expands_about_its_first_point)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], point, t = parameter(T, "t"), s = sub(from_int(1), t);
    for (int i = 0; i <= n; i++)
        w[i] = positive(T, "w", i);
    for (int k = 1; k <= n; k++) {
        G(repeated_at_start)(T, n, 1, k, R);
        G(rational_point)(n, 1, R, w, t, &point);
        num low = from_int(1), high = from_int(0); /* t^k, the braces */
        for (int j = 0; j < k; j++)
            low = mul(low, t);
        for (int i = k; i <= n; i++) {
            num term = mul(from_int(binomial(n, i)), mul(w[i], sub(R[i], R[0])));
            for (int j = 0; j < n - i; j++)
                term = mul(term, s);
            for (int j = 0; j < fault(T, i - k - 1, i - k); j++)
                term = mul(term, t);
            high = add(high, i == k ? mul(low, term) : mul(mul(low, t), term));
        }
        /* R(t) = R_0 + Σ C(n,i) (1-t)^{n-i} t^i ω_i (R_i - R_0)/ω(t), i from k to n */
        same(T, point, add(R[0], div(high, G(rational_weight)(n, w, t))));
    }
}
#include "chapters/judge/claims_off.h"
