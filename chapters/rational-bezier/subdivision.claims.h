/*
# Cutting the curve (离散构造)

De Casteljau's triangle, applied to numerator and denominator, cuts a rational curve at any parameter
$c$ into two curves of the same degree.  The points of the triangle are $R_i^r$ with weights $\omega_i^r$,
$r=0,\dots,n$, $i=r,\dots,n$; over $[a,b]$ everything depends on $\lambda=(c-a)/(b-a)$.
*/
#include "exact/record/roots.h"

#include "chapters/rational-bezier/free-curve.h"

#include "chapters/judge/claims_on.h"

/*
## The triangle

:::{statement} wang-ch3:3.3.2
:title: The weights of the triangle
:zh: 权因子的递推
:printed: With $c\in(a,b)$, $\lambda=(c-a)/(b-a)$: $\omega_i^r(c)=\omega_i$ for $r=0$, $i=0,1,\dots,n$; $\omega_i^r(c)=(1-\lambda)\omega_{i-1}^{r-1}(c)+\lambda\omega_i^{r-1}(c)$ for
  $r=1,2,\dots,n$, $i=r,r+1,\dots,n$.
:definition: yes
:checked-by: triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power
:confirmed-by: triangle_in_closed_form triangle_level_by_level

In the text at hand the recursion is printed twice, first with its number and then with that of (3.3.1); the recursion
of the points then has the number (3.3.2), which the next sentences call (3.3.3).
:::
*/

/*
:::{claim} triangle_in_closed_form
:title: Level r of the triangle in Bernstein polynomials of degree r
:zh: 三角阵第 r 层的闭式
:given: weights $\omega_0,\dots,\omega_n$, points $R_0,\dots,R_n$, $\lambda$
:then: $\omega_i^r=\sum_{k=0}^rB_k^r(\lambda)\omega_{i-r+k}$ and
  $\omega_i^rR_i^r=\sum_{k=0}^rB_k^r(\lambda)\omega_{i-r+k}R_{i-r+k}$ for all $r\le n$, $i=r,\dots,n$
:method: The left sides come from the recursion, the right sides from the Bernstein polynomials; both are rational
  functions of $\lambda$, the weights and the points.
:degrees: 1..6 sampled 10
:defines: rational_casteljau
:control: $1-\lambda$ for $\lambda$
:::
*/
CLAIM(triangle_in_closed_form)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], Rr[MAX_DEGREE + 1], B[MAX_DEGREE + 1];
    num lambda = parameter(T, "lambda");
    G(curve_of_any_weights)(T, n, 1, R, w);
    for (int r = 0; r <= n; r++) {
        G(rational_casteljau)(n, 1, R, w, lambda, r, Rr, wr);
        G(bernstein_basis)(r, fault(T, lambda, sub(from_int(1), lambda)), B);
        for (int i = r; i <= n; i++) {
            num weight = from_int(0), point = from_int(0);
            for (int k = 0; k <= r; k++) {
                weight = add(weight, mul(B[k], w[i - r + k]));
                point = add(point, mul(B[k], mul(w[i - r + k], R[i - r + k])));
            }
            /* ω_i^r = Σ B_k^r(λ) ω_{i-r+k}, and the same with the points */
            same(T, wr[i - r], weight);
            same(T, mul(wr[i - r], Rr[i - r]), point);
        }
    }
}

/*
:::{claim} triangle_level_by_level
:title: Each level follows from the one before as printed
:zh: 逐层递推
:given: weights $\omega_0,\dots,\omega_n$, points $R_0,\dots,R_n$, $\lambda$
:then: the two recursions hold for all $r=1,\dots,n$, $i=r,\dots,n$, and the point $R_i^r$ divides the edge in the
  ratio $(R_i^r-R_{i-1}^{r-1}):(R_i^{r-1}-R_i^r)=\lambda\omega_i^{r-1}:(1-\lambda)\omega_{i-1}^{r-1}$
:method: Two levels of the triangle are computed and put into the printed equations.
:degrees: 1..6 sampled 10
:control: $\lambda$ and $1-\lambda$ exchanged
:::
*/
CLAIM(triangle_level_by_level)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], v[MAX_DEGREE + 1], P[MAX_DEGREE + 1], wr[MAX_DEGREE + 1],
        Rr[MAX_DEGREE + 1];
    num lambda = parameter(T, "lambda"), mu = sub(from_int(1), lambda);
    num ahead = fault(T, lambda, mu), behind = fault(T, mu, lambda);
    G(free_curve)(T, n, 1, R, w);
    for (int r = 1; r <= n; r++) {
        G(rational_casteljau)(n, 1, R, w, lambda, r - 1, P, v);
        G(rational_casteljau)(n, 1, R, w, lambda, r, Rr, wr);
        for (int i = r; i <= n; i++) {
            int j = i - r; /* where index i of level r, and index i-1 of level r-1, are stored */
            num left = mul(behind, v[j]), right = mul(ahead, v[j + 1]);
            /* ω_i^r = (1-λ) ω_{i-1}^{r-1} + λ ω_i^{r-1} */
            same(T, wr[j], add(left, right));
            /* ω_i^r R_i^r = (1-λ) ω_{i-1}^{r-1} R_{i-1}^{r-1} + λ ω_i^{r-1} R_i^{r-1} */
            same(T, Rr[j], add(mul(div(left, wr[j]), P[j]), mul(div(right, wr[j]), P[j + 1])));
            /* (R_i^r - R_{i-1}^{r-1}) : (R_i^{r-1} - R_i^r) = λ ω_i^{r-1} : (1-λ) ω_{i-1}^{r-1} */
            same(T, mul(sub(Rr[j], P[j]), left), mul(sub(P[j + 1], Rr[j]), right));
        }
    }
}

/*
In homogeneous coordinates the triangle is de Casteljau's own, and nothing in it can fail.  The points of space come
from it by division by $\omega_i^r$, and this is where care is needed.  The recursion of the weights does not look at
the points: run first, it tells where the division is not possible.

:::{statement} wang-ch3:3.3.3
:title: The points of the triangle
:zh: 顶点的递推
:printed: With $c\in(a,b)$, $\lambda=(c-a)/(b-a)$: $\mathbf R_i^r(c)=\mathbf R_i$ for $r=0$, $i=0,1,\dots,n$; else $\mathbf
  R_i^r(c)=\frac{(1-\lambda)\omega_{i-1}^{r-1}(c)}{(1-\lambda)\omega_{i-1}^{r-1}(c)+\lambda\omega_i^{r-1}(c)}\mathbf
  R_{i-1}^{r-1}(c)+\frac{\lambda\omega_i^{r-1}(c)}{(1-\lambda)\omega_{i-1}^{r-1}(c)+\lambda\omega_i^{r-1}(c)}\mathbf R_i^{r-1}(c)$.
:definition: yes
:checked-by: triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power weighted_points_are_cut_like_the_weights
  cut_coefficients_are_convex
:confirmed-by: triangle_in_closed_form triangle_level_by_level
:needs: intermediate_weight_can_vanish | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive: otherwise $\omega_i^r$ may be $0$ although $\omega(t)$ has no real zero
:needs: cut_outside_can_fail | theorem 3.3.1: $c\in(a,b)$ | $c\in(a,b)$; the ends do no harm, but outside $[a,b]$ a weight of the triangle may
  vanish although all $\omega_i>0$
:figure: triangle_point_at_infinity

The range of $r$ and $i$ in the second line, which is not repeated, is that of (3.3.2); the denominators are $\omega_i^r(c)$.  In the text at hand this
formula has the number (3.3.2), and the next sentences call it (3.3.3).
:::
*/

/*
:::{claim} weighted_points_are_cut_like_the_weights
:title: The points of the triangle, times their weights, follow the recursion of the weights, in every degree
:zh: 顶点乘以权后满足权的递推(任意次数)
:given: two neighbouring points $P$, $Q$ of any level and their weights $p,q>0$; $0\le\lambda\le1$
:where: the weights are positive
:let: $v=(1-\lambda)p+\lambda q$ and $X=\frac{(1-\lambda)p}{(1-\lambda)p+\lambda q}P+\frac{\lambda q}{(1-\lambda)p+\lambda q}Q$, as in (3.3.2) and (3.3.3)
:then: $vX=(1-\lambda)pP+\lambda qQ$, and $(1-\lambda)p\,(X-P)=\lambda q\,(Q-X)$
:method: Identities of rational functions; a coordinate is any coordinate.  By induction on the level the $\omega_i^r\mathbf R_i^r$ and the $\omega_i^r$ are the triangles of de Casteljau for the
  numerator and the denominator of the curve, for every $n$; and the new point divides its edge in the ratio $\lambda q:(1-\lambda)p$.
:degrees: all
:scope: every point of division
:over: P# Q#: points; p# q#: weights; lambda: -
:control: the weights of the two points exchanged
:::
*/
CLAIM(weighted_points_are_cut_like_the_weights)
{
    num P = unknown(T, "P", 0), Q = unknown(T, "Q", 0), p = positive(T, "p", 0), q = positive(T, "q", 0);
    num lambda = parameter(T, "lambda"), mu = sub(from_int(1), lambda), first = mul(mu, p), second = mul(lambda, q);
    num v = add(first, second),
        X = add(mul(div(fault(T, first, mul(mu, q)), v), P), mul(div(fault(T, second, mul(lambda, p)), v), Q));
    about(T, "the weighted point");
    same(T, mul(v, X), add(mul(first, P), mul(second, Q)));
    about(T, "the ratio on the edge");
    same(T, mul(first, sub(X, P)), mul(second, sub(Q, X)));
}

#if RATIONAL
/*
:::{claim} intermediate_weight_can_vanish
:title: A curve without poles whose triangle has a point at infinity
:zh: 曲线正则而三角阵中权为零
:kind: decision
:data: ω = 1 -1/2 1; λ = 2/3 1/3
:instead: λ = 1/2 1/2
:result: ω(t) = "3*t^2 - 3*t + 1"; real zeros of ω(t) = 0; ω_1^1 at the first λ, ω_2^1 at the second = 0 0
:given: three weights $\omega$, the middle one negative, and two parameters $\lambda$
:then: $\omega(t)>0$ for every real $t$, but $\omega_1^1=0$ for the first $\lambda$, so that $R_1^1$, a point of the
  left part, does not exist; and $\omega_2^1=0$ for the second, so that $R_2^1$, one of the right part, does not
:method: The real zeros of $\omega(t)$ are counted exactly, and it is positive at $0$; the two weights are computed by
  one step of the recursion.
:control: $\lambda$ in the middle
:::
*/
CLAIM(intermediate_weight_can_vanish)
{
    num w[3], lambda[2], vanishing[2];
    given_points(T, "ω", 3, 1, w);
    given_points(T, "λ", 2, 1, lambda);
    poly denominator = poly_from_bernstein(2, w);
    int zeros = count_roots_line(denominator).distinct;
    for (int side = 0; side < 2; side++) {
        num level[3] = {w[0], w[1], w[2]};
        G(bezier_casteljau_level)(2, 1, level, lambda[side]);
        vanishing[side] = level[side];
    }
    found_text(T, "ω(t)", poly_to_string(denominator, "t"));
    found_whole(T, "real zeros of ω(t)", zeros);
    found_points(T, "ω_1^1 at the first λ, ω_2^1 at the second", 2, 1, vanishing);
    about(T, "ω(t) > 0 for every real t");
    agree(T, zeros == 0 && sign_q(w[0]) > 0);
    about(T, "the weights ω_1^1 and ω_2^1");
    vanishes(T, vanishing[0]);
    vanishes(T, vanishing[1]);
}
#endif

/*
## The theorem

Two sides of the triangle carry the two parts of the curve.  On the left side, $R_0^0,R_1^1,\dots,R_n^n$, both indices
grow together; on the right side, $R_n^n,R_n^{n-1},\dots,R_n^0$, the lower index stays $n$ and the upper one falls.
The two sides meet in $R_n^n$, the point of the curve at $c$.

:::{statement} wang-ch3:thm-3.3.1
:title: Any interior parameter cuts the curve into two of the same degree
:zh: 离散生成定理
:printed: For any point $c\in(a,b)$, with $\lambda=(c-a)/(b-a)$, the curve $\mathbf R(t)=\sum_{i=0}^n
  B_i^n\bigl(\frac{t-a}{b-a}\bigr)\omega_i\mathbf R_i\big/\sum_{i=0}^nB_i^n\bigl(\frac{t-a}{b-a}\bigr)\omega_i$ is (3.3.1) $\sum_{i=0}^n
  B_i^n\bigl(\frac{t-a}{c-a}\bigr)\omega_i^i(c)\mathbf R_i^i(c)\big/\sum_{i=0}^n
  B_i^n\bigl(\frac{t-a}{c-a}\bigr)\omega_i^i(c)$ for $a\le t\le c$, and $\sum_{i=0}^n
  B_i^n\bigl(\frac{t-a}{b-a}\bigr)\omega_i^{n-i}(c)\mathbf R_n^{n-i}(c)\big/\sum_{i=0}^n
  B_i^n\bigl(\frac{t-c}{b-c}\bigr)\omega_n^{n-i}(c)$ for $c\le t\le b$, with the weights (3.3.2) and the points
  (3.3.3).
:class: misprint
:refuted-by: printed_right_half_has_the_wrong_argument printed_right_half_has_the_wrong_weight
:corrected: For every $c\in(a,b)$ the part of $\mathbf R(t)$ over $[a,c]$ is the rational Bézier curve of degree $n$ with the weights $\omega_i^i(c)$ and points $\mathbf R_i^i(c)$, at the
  parameter $\frac{t-a}{c-a}$, and that over $[c,b]$ the one with the weights $\omega_n^{n-i}(c)$ and points $\mathbf R_n^{n-i}(c)$, at the parameter $\frac{t-c}{b-c}$.
:corrected-by: triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power weighted_points_are_cut_like_the_weights
  cut_coefficients_are_convex
:confirmed-by: subdivision_left_half subdivision_right_half
:needs: intermediate_weight_can_vanish | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive
:needs: cut_at_an_end_is_empty | the theorem: $c\in(a,b)$ | $c\in(a,b)$: for $c=a$ the left formula has the argument
  $(t-a)/0$, and its points all coincide; for $c=b$ likewise the right one
:needs: cut_outside_can_fail | the theorem: $c\in(a,b)$ | $c\in(a,b)$: outside $[a,b]$ a weight of the triangle may
  vanish although all $\omega_i>0$
:needs: curve_may_have_a_pole_outside | the formula (3.3.1): $a\le t\le c$ and $c\le t\le b$ | $a\le t\le b$: outside $[a,b]$ the denominator of $\mathbf R(t)$ may vanish although
  all $\omega_i>0$
:figure: subdivision_triangle

The left branch is true; the numerator of the right one has two slips.  With positive weights the denominator of $\mathbf R(t)$ does not vanish for $a\le t\le b$: it is $\omega_n^n(t)$, a weight of the triangle at $t$.
:::
*/

/* From the triangle at lambda: R_i^i with omega_i^i, and R_n^{n-i} with omega_n^{n-i}. */
static void G(triangle_sides)(int n, const num R[], const num w[], num lambda, num left[], num wl[], num right[],
                              num wr[])
{
    num P[MAX_DEGREE + 1], v[MAX_DEGREE + 1];
    for (int r = 0; r <= n; r++) {
        G(rational_casteljau)(n, 1, R, w, lambda, r, P, v);
        left[r] = P[0];
        wl[r] = v[0];
        right[n - r] = P[n - r];
        wr[n - r] = v[n - r];
    }
}

/* Compares the curve over [a, b] with its part over [a, c], or on the right over [c, b], at a point t of the part. */
static void G(compare_with_the_part)(trial *T, int right)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], P[2][MAX_DEGREE + 1], v[2][MAX_DEGREE + 1], curve, part;
    num a = unknown(T, "a", 0), h = positive(T, "h", 0), lambda = parameter(T, "lambda"), x = parameter(T, "x");
    G(free_curve)(T, n, 1, R, w);
    num b = add(a, h), c = add(a, mul(lambda, h)), from = right ? c : a, length = right ? sub(b, c) : sub(c, a);
    num t = add(from, mul(x, length)), whole = div(sub(t, a), sub(b, a));
    G(triangle_sides)(n, R, w, div(sub(c, a), sub(b, a)), P[0], v[0], P[1], v[1]);
    G(rational_point)(n, 1, R, w, whole, &curve);
    /* the argument of the part: (t - a)/(c - a), or (t - c)/(b - c) */
    G(rational_point)(n, 1, P[right], v[right], fault(T, div(sub(t, from), length), whole), &part);
    same(T, part, curve);
}

/*
:::{claim} subdivision_left_half
:title: The left side of the triangle carries the curve over [a,c]
:zh: 三角阵左边给出左段曲线
:given: positive weights, points $R_0,\dots,R_n$, $a$, $b=a+h$, $c=a+\lambda h$ and $t=a+x(c-a)$, with $h>0$
:where: the weights are positive
:then: the curve over $[a,b]$ at $t$ is the curve of $(R_i^i,\omega_i^i)$ at $(t-a)/(c-a)$
:method: Both sides are rational functions of $a,h,\lambda,x$, the weights and the points; every $a<b$, $c\ne a$ and
  $t$ is of the given form.
:degrees: 1..6 sampled 12
:over: a h: interval; x: t
:control: the basis argument $(t-a)/(b-a)$ on both sides
:::
*/
CLAIM(subdivision_left_half) { G(compare_with_the_part)(T, 0); }

/*
:::{claim} subdivision_right_half
:title: The right side of the triangle carries the curve over [c,b]
:zh: 三角阵右边给出右段曲线
:given: positive weights, points $R_0,\dots,R_n$, $a$, $b=a+h$, $c=a+\lambda h$ and $t=c+x(b-c)$, with $h>0$
:where: the weights are positive
:then: the curve over $[a,b]$ at $t$ is the curve of $(R_n^{n-i},\omega_n^{n-i})$ at $(t-c)/(b-c)$
:method: Both sides are rational functions of $a,h,\lambda,x$, the weights and the points; every $a<b$, $c\ne b$ and
  $t$ is of the given form.
:degrees: 1..6 sampled 12
:over: a h: interval; x: t
:control: the basis argument $(t-a)/(b-a)$ on both sides
:::
*/
CLAIM(subdivision_right_half) { G(compare_with_the_part)(T, 1); }

/*
:::{claim} cut_at_an_end_is_empty
:title: Cut at an end, one part is a point and the other the whole curve
:zh: 在端点处离散:一段退缩为点
:given: positive weights and points $R_0,\dots,R_n$
:where: the weights are positive
:then: for $\lambda=0$ all $R_i^i=R_0$, $\omega_i^i=\omega_0$, while $R_n^{n-i}=R_i$, $\omega_n^{n-i}=\omega_i$; for
  $\lambda=1$ all $R_n^{n-i}=R_n$, $\omega_n^{n-i}=\omega_n$, while $R_i^i=R_i$, $\omega_i^i=\omega_i$
:method: The triangle is computed as rational functions.  So for $c=a$ the left formula, whatever its argument
  $(t-a)/0$ is taken to be, gives $R_0$, and the right one the whole curve.
:degrees: 1..6 sampled 10
:control: $\lambda=\frac12$
:::
*/
CLAIM(cut_at_an_end_is_empty)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], P[2][MAX_DEGREE + 1], v[2][MAX_DEGREE + 1];
    G(free_curve)(T, n, 1, R, w);
    for (int end = 0; end < 2; end++) {
        G(triangle_sides)(n, R, w, fault(T, from_int(end), from_ratio(1, 2)), P[0], v[0], P[1], v[1]);
        show_points(T, end ? "c = b: left points" : "c = a: left points", n + 1, 1, P[0]);
        show_points(T, end ? "c = b: right points" : "c = a: right points", n + 1, 1, P[1]);
        for (int i = 0; i <= n; i++) {
            same(T, P[end][i], R[end ? n : 0]);
            same(T, v[end][i], w[end ? n : 0]);
            same(T, P[1 - end][i], R[i]);
            same(T, v[1 - end][i], w[i]);
        }
    }
}

#if RATIONAL
/*
:::{claim} cut_outside_can_fail
:title: Outside the interval positive weights need not suffice
:zh: 分割点在区间外时正权亦不足
:kind: decision
:data: ω = 1 2; c = -1
:instead: c = 1/2
:result: ω_1^1 = 0
:given: two positive weights $\omega$, $[a,b]=[0,1]$, and a parameter $c$ outside
:then: $\omega_1^1=0$, so that $R_1^1$ does not exist
:method: Computed exactly.
:control: $c$ in the middle of the interval
:::
*/
CLAIM(cut_outside_can_fail)
{
    num w[2];
    given_points(T, "ω", 2, 1, w);
    num weight = G(rational_weight)(1, w, given(T, "c"));
    found(T, "ω_1^1", weight);
    vanishes(T, weight);
}

/*
:::{claim} curve_may_have_a_pole_outside
:title: Outside the interval positive weights do not keep the denominator from 0
:zh: 区间外正权曲线的分母可为零
:kind: counterexample
:data: ω = 1 2; t = -1
:instead: t = 1/2
:result: ω(t) = 0
:given: two positive weights $\omega$, $[a,b]=[0,1]$, and a parameter $t$ outside
:then: $\omega(t)=0$, so that there is no point $R(t)$
:method: The denominator is computed exactly; that it is not 0 is what is compared.
:control: $t$ in the middle of the interval
:::
*/
CLAIM(curve_may_have_a_pole_outside)
{
    num w[2];
    given_points(T, "ω", 2, 1, w);
    num total = G(rational_weight)(1, w, given(T, "t"));
    found(T, "ω(t)", total);
    about(T, "the denominator is not 0");
    refute(T, is_zero_q(total));
}
#endif

/*
:::{statement} wang-ch3:thm-3.3.1-proof
:title: Apply the polynomial theorem to numerator and denominator
:zh: 对分子分母分别应用多项式情形
:printed: Theorem 1.4.1, applied to the numerator and to the denominator of the curve (3.2.2), gives theorem 3.3.1, by which the rational Bézier curve is
  generated by subdivision.
:holds-by: triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power weighted_points_are_cut_like_the_weights
  cut_coefficients_are_convex
:confirmed-by: numerator_and_denominator_are_cut_alike
:meant: the words by which the curve is generated by subdivision | Theorem 3.3.1 is the theorem with its right branch as corrected there; theorem 1.4.1, which is
  not in the text at hand, is subdivision by de Casteljau.
:reading: printed_right_half_has_the_wrong_argument | theorem 3.3.1 by the letter
:needs: intermediate_weight_can_vanish | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive: so that all points $\mathbf R_i^r(c)$ exist
:needs: cut_at_an_end_is_empty | theorem 3.3.1: $c\in(a,b)$ | $c\in(a,b)$: for $c=a$ the left formula has the argument
  $(t-a)/0$; for $c=b$ the right one has $(t-b)/0$
:needs: cut_outside_can_fail | theorem 3.3.1: $c\in(a,b)$ | $c\in(a,b)$: outside $[a,b]$ a weight of the triangle may
  vanish although all $\omega_i>0$
:needs: curve_may_have_a_pole_outside | theorem 3.3.1: $a\le t\le c$ and $c\le t\le b$ | $a\le t\le b$: outside $[a,b]$ the denominator of $\mathbf R(t)$ may vanish although
  all $\omega_i>0$
:::

:::{claim} numerator_and_denominator_are_cut_alike
:title: The polynomial cut of numerator and denominator has the points and weights of the triangle
:zh: 分子分母的离散即三角阵两边
:given: weights $\omega_0,\dots,\omega_n$, points $R_0,\dots,R_n$, $\lambda$
:then: cutting the polynomials $\sum B_i^n\omega_iR_i$ and $\sum B_i^n\omega_i$ at $\lambda$ gives, on the left, the
  coefficients $\omega_i^iR_i^i$ and $\omega_i^i$, on the right $\omega_n^{n-i}R_n^{n-i}$ and $\omega_n^{n-i}$
:method: The cut in homogeneous coordinates and the triangle of weighted points are two programs; their results are
  compared as rational functions.
:degrees: 1..6 sampled 12
:defines: rational_split
:control: the right half read from the triangle as $R_i^{n-i}$
:::
*/
CLAIM(numerator_and_denominator_are_cut_alike)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], lambda = parameter(T, "lambda");
    num P[2][MAX_DEGREE + 1], v[2][MAX_DEGREE + 1], Q[2][MAX_DEGREE + 1], q[2][MAX_DEGREE + 1];
    G(curve_of_any_weights)(T, n, 1, R, w);
    G(rational_split)(n, 1, R, w, lambda, P[0], v[0], P[1], v[1]);
    G(triangle_sides)(n, R, w, lambda, Q[0], q[0], Q[1], q[1]);
    for (int half = 0; half < 2; half++)
        for (int i = 0; i <= n; i++) {
            int j = fault(T, i, half == 1 ? n - i : i);
            same(T, v[half][i], q[half][j]);
            same(T, P[half][i], Q[half][j]);
        }
}

/*
The source writes the result as one formula (3.3.1) with two branches, and the right one has suffered in print.  Two
questions find such slips without any computing.  Does the argument of the basis run from 0 to 1 while $t$ runs
through the part?  And are the weights of numerator and denominator the same list?  If not, a polygon whose points all
coincide would not give that point.

:::{statement} wang-ch3:3.3.1-left
:title: The left part of the curve, over [a,c]
:zh: 离散公式左段
:printed: \mathbf R(t)=\frac{\sum_{i=0}^nB_i^n\bigl(\frac{t-a}{b-a}\bigr)\omega_i\mathbf
  R_i}{\sum_{i=0}^nB_i^n\bigl(\frac{t-a}{b-a}\bigr)
  \omega_i}=\frac{\sum_{i=0}^nB_i^n\bigl(\frac{t-a}{c-a}\bigr)\omega_i^i(c)\mathbf R_i^i(c)}
  {\sum_{i=0}^nB_i^n\bigl(\frac{t-a}{c-a}\bigr)\omega_i^i(c)},\quad a\le t\le c
:holds-by: triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power weighted_points_are_cut_like_the_weights
  cut_coefficients_are_convex
:confirmed-by: subdivision_left_half
:needs: intermediate_weight_can_vanish | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive
:needs: cut_at_an_end_is_empty | theorem 3.3.1: $c\in(a,b)$ | $c\in(a,b)$: for $c=a$ the formula has the argument $(t-a)/0$
:needs: cut_outside_can_fail | theorem 3.3.1: $c\in(a,b)$ | $c\in(a,b)$: outside $[a,b]$ a weight of the triangle may
  vanish although all $\omega_i>0$
:needs: curve_may_have_a_pole_outside | the formula: $a\le t\le c$ | $a\le t\le c$: outside $[a,b]$ the denominator of $\mathbf R(t)$ may vanish although
  all $\omega_i>0$

With positive weights the denominator of $\mathbf R(t)$ does not vanish for $a\le t\le b$: it is $\omega_n^n(t)$, a weight of the triangle at $t$.
:::

:::{statement} wang-ch3:3.3.1-right
:title: The right part of the curve, over [c,b]
:zh: 离散公式右段
:printed: \mathbf R(t)=\frac{\sum_{i=0}^nB_i^n\bigl(\frac{t-a}{b-a}\bigr)\omega_i^{n-i}(c)\mathbf R_n^{n-i}(c)}
  {\sum_{i=0}^nB_i^n\bigl(\frac{t-c}{b-c}\bigr)\omega_n^{n-i}(c)},\quad c\le t\le b
:class: misprint
:refuted-by: printed_right_half_has_the_wrong_argument printed_right_half_has_the_wrong_weight
:corrected: \mathbf R(t)=\frac{\sum_{i=0}^nB_i^n\bigl(\frac{t-c}{b-c}\bigr)\omega_n^{n-i}(c)\mathbf R_n^{n-i}(c)}
  {\sum_{i=0}^nB_i^n\bigl(\frac{t-c}{b-c}\bigr)\omega_n^{n-i}(c)},\quad c\le t\le b
:corrected-by: triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power weighted_points_are_cut_like_the_weights
  cut_coefficients_are_convex
:confirmed-by: subdivision_right_half
:needs: intermediate_weight_can_vanish | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive
:needs: cut_at_an_end_is_empty | theorem 3.3.1: $c\in(a,b)$ | $c\in(a,b)$: for $c=b$ the formula has the argument $(t-b)/0$
:needs: cut_outside_can_fail | theorem 3.3.1: $c\in(a,b)$ | $c\in(a,b)$: outside $[a,b]$ a weight of the triangle may
  vanish although all $\omega_i>0$
:needs: curve_may_have_a_pole_outside | the formula: $c\le t\le b$ | $c\le t\le b$: outside $[a,b]$ the denominator of $\mathbf R(t)$ may vanish although
  all $\omega_i>0$
:striking: 6
:figure: right_half_misprint

Two slips in the numerator, each wrong by itself: the argument $(t-a)/(b-a)$, which should be $(t-c)/(b-c)$; and the
weight $\omega_i^{n-i}$, which should be $\omega_n^{n-i}$.  The denominator has both right.  For $i<n-i$ the printed
weight is not even defined by (3.3.2).
:::
*/

#if RATIONAL
/*
:::{claim} printed_right_half_has_the_wrong_argument
:title: The numerator's basis argument is not that of the right part
:zh: 右段分子的基函数自变量误印
:kind: counterexample
:data: R = 0 1; ω = 1 1; c = 1/2; t = 3/4
:result: R(t) = 3/4; quotient with the printed argument = 7/8
:given: two points of the line with equal weights, $[a,b]=[0,1]$, the cut $c$ and a parameter $t$ of the right part; the
  weights in the numerator taken as they should be
:then: with the printed argument in the numerator the quotient is not $R(t)$
:method: Both sides are computed exactly.
:control: $(t-c)/(b-c)$ in the numerator too
:::
*/
CLAIM(printed_right_half_has_the_wrong_argument)
{
    num R[2], w[2], Rl[2], wl[2], Rr[2], wr[2], up[2], curve, numerator;
    given_points(T, "R", 2, 1, R);
    given_points(T, "ω", 2, 1, w);
    num c = given(T, "c"), t = given(T, "t"), part = div(sub(t, c), sub(from_int(1), c));
    G(triangle_sides)(1, R, w, c, Rl, wl, Rr, wr);
    for (int i = 0; i < 2; i++)
        up[i] = mul(wr[i], Rr[i]);
    G(bezier_horner)(1, 1, up, fault(T, part, t), &numerator);
    G(rational_point)(1, 1, R, w, t, &curve);
    num printed = div(numerator, G(rational_weight)(1, wr, part));
    found(T, "R(t)", curve);
    found(T, "quotient with the printed argument", printed);
    about(T, "left the curve, right the quotient with the printed argument");
    same(T, curve, printed);
}

/*
:::{claim} printed_right_half_has_the_wrong_weight
:title: The numerator's weights are not those of the denominator
:zh: 右段分子的权误印
:kind: counterexample
:data: R = 0 1/2 1; ω = 1 2 3; c = 1/2; t = 3/4
:result: ω_1^1, ω_2^1 = 3/2 5/2; R(t) = 33/40; quotient with the printed weight = 133/200
:given: three points of the line, their weights, $[a,b]=[0,1]$, the cut $c$ and a parameter $t$ of the right part; in the
  numerator the argument is taken as it should be, and for $i=0$ the weight too, since $\omega_0^2$ is not defined
:then: $\omega_1^1$, the printed weight of $R_2^1$ in the numerator, is not $\omega_2^1$, the one in the denominator,
  and with it, the rest of the numerator taken as it should be, the quotient is not $R(t)$
:method: Both sides are computed exactly, the weights from the recursion (3.3.2).
:control: $\omega_2^1$ in the numerator too
:::
*/
CLAIM(printed_right_half_has_the_wrong_weight)
{
    num R[3], w[3], Rl[3], wl[3], Rr[3], wr[3], P[3], v[3], up[3], curve, numerator;
    given_points(T, "R", 3, 1, R);
    given_points(T, "ω", 3, 1, w);
    num c = given(T, "c"), t = given(T, "t"), part = div(sub(t, c), sub(from_int(1), c));
    G(triangle_sides)(2, R, w, c, Rl, wl, Rr, wr);
    for (int i = 0; i <= 2; i++) {
        int r = 2 - i; /* the printed weight is ω_i^r, stored at i - r where it is defined */
        G(rational_casteljau)(2, 1, R, w, c, r, P, v);
        up[i] = mul(fault(T, wr[i], i < r ? wr[i] : v[i - r]), Rr[i]);
        if (i == 1)
            found_points(T, "ω_1^1, ω_2^1", 2, 1, v);
    }
    G(bezier_horner)(2, 1, up, part, &numerator);
    G(rational_point)(2, 1, R, w, t, &curve);
    num printed = div(numerator, G(rational_weight)(2, wr, part));
    found(T, "R(t)", curve);
    found(T, "quotient with the printed weight", printed);
    about(T, "left the curve, right the quotient with the printed weight");
    same(T, curve, printed);
}
#endif

#include "chapters/judge/claims_off.h"
