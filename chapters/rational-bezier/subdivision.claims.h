/*
# Cutting the curve (离散构造)

De Casteljau's triangle, applied to numerator and denominator, cuts a rational curve at any parameter
$c$ into two curves of the same degree.  The points of the triangle are $R_i^r$ with weights $\omega_i^r$,
$r=0,\dots,n$, $i=r,\dots,n$; over $[a,b]$ everything depends on $\lambda=(c-a)/(b-a)$.
*/
#include "exact/record/sign.h"

#include "chapters/judge/claims_on.h"

/*
## The triangle

:::{statement} wang-ch3:3.3.2
:title: The weights of the triangle
:zh: 权因子的递推
:printed: \omega_i^0(c)=\omega_i,\quad\omega_i^r(c)=(1-\lambda)\omega_{i-1}^{r-1}(c)+\lambda\omega_i^{r-1}(c),\quad
  r=1,\dots,n,\ i=r,\dots,n
:definition: yes
:checked-by: triangle_in_closed_form triangle_level_by_level
:::
*/

/* n+1 free weights and points; one coordinate stands for all. */
static void G(free_curve)(trial *T, int n, num R[], num w[])
{
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        R[i] = unknown(T, "R", i);
    }
}

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
    G(free_curve)(T, n, R, w);
    for (int r = 0; r <= n; r++) {
        G(rational_casteljau)(n, 1, R, w, lambda, r, Rr, wr);
        G(bernstein_basis)(r, fault(T, lambda, sub(from_int(1), lambda)), B);
        for (int i = r; i <= n; i++) {
            num weight = from_int(0), point = from_int(0);
            for (int k = 0; k <= r; k++) {
                weight = add(weight, mul(B[k], w[i - r + k]));
                point = add(point, mul(B[k], mul(w[i - r + k], R[i - r + k])));
            }
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
    G(free_curve)(T, n, R, w);
    for (int r = 1; r <= n; r++) {
        G(rational_casteljau)(n, 1, R, w, lambda, r - 1, P, v);
        G(rational_casteljau)(n, 1, R, w, lambda, r, Rr, wr);
        for (int i = r; i <= n; i++) {
            int j = i - r; /* where index i of level r, and index i-1 of level r-1, are stored */
            num left = mul(behind, v[j]), right = mul(ahead, v[j + 1]);
            same(T, wr[j], add(left, right));
            same(T, Rr[j], add(mul(div(left, wr[j]), P[j]), mul(div(right, wr[j]), P[j + 1])));
            same(T, mul(sub(Rr[j], P[j]), left), mul(sub(P[j + 1], Rr[j]), right));
        }
    }
}

/*
:::{statement} wang-ch3:3.3.3
:title: The points of the triangle
:zh: 顶点的递推
:printed: \mathbf R_i^0(c)=\mathbf R_i,\quad\mathbf
  R_i^r(c)=\frac{(1-\lambda)\omega_{i-1}^{r-1}(c)}{\omega_i^r(c)}\mathbf
  R_{i-1}^{r-1}(c)+\frac{\lambda\omega_i^{r-1}(c)}{\omega_i^r(c)}\mathbf R_i^{r-1}(c)
:definition: yes
:checked-by: triangle_in_closed_form triangle_level_by_level
:needs: intermediate_weight_can_vanish | positive weights: otherwise $\omega_i^r$ may be $0$ on a perfectly regular
  curve
:figure: triangle_point_at_infinity

The range of $r$ and $i$, which is not repeated, is that of (3.3.2), and $\omega_i^r$ stands for the sum printed in
the denominators.
:::
*/

#if RATIONAL
/*
:::{claim} intermediate_weight_can_vanish
:title: A regular curve whose triangle has a point at infinity
:zh: 曲线正则而三角阵中权为零
:kind: decision
:data: ω = 1 -1/2 1; λ = 2/3 1/3
:instead: λ = 1/2 1/2
:result: ω(t) = "3*t^2 - 3*t + 1"; real zeros of ω(t) = 0; ω_1^1 at the first λ, ω_2^1 at the second = 0 0
:given: three weights $\omega$, the middle one negative, and two parameters $\lambda$
:then: $\omega(t)>0$ for every real $t$, but $\omega_1^1=0$ for the first $\lambda$, so that $R_1^1$, a point of the left part,
  does not exist; and $\omega_2^1=0$ for the second, so that $R_2^1$, one of the right part, does not
:method: The real zeros of $\omega(t)$ are counted exactly, and it is positive at $0$; the two weights are computed by one step
  of the recursion.
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

:::{statement} wang-ch3:thm-3.3.1
:title: Any interior parameter cuts the curve into two of the same degree
:zh: 离散生成定理
:printed: For every $c\in(a,b)$, with $\lambda=(c-a)/(b-a)$, the parts of $\mathbf R(t)$ over $[a,c]$ and $[c,b]$
  are rational Bézier curves of degree $n$ with weights and points from the triangle (3.3.2), (3.3.3)
:holds-by: subdivision_left_half subdivision_right_half
:needs: intermediate_weight_can_vanish | positive weights
:needs: cut_at_an_end_is_empty | $c\in(a,b)$: for $c=a$ the left formula has the argument $(t-a)/0$, and its points
  all coincide; for $c=b$ likewise the right one
:needs: cut_outside_can_fail | $c\in(a,b)$: outside $[a,b]$ a weight of the triangle may vanish although all
  $\omega_i>0$
:figure: subdivision_triangle

The formulas (3.3.1) themselves follow, one branch at a time.
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

/*
:::{claim} subdivision_left_half
:title: The left side of the triangle carries the curve over [a,c]
:zh: 三角阵左边给出左段曲线
:given: positive weights, points $R_0,\dots,R_n$, $a$, $b=a+h$, $c=a+\lambda h$ and $t=a+x(c-a)$, with $h>0$
:then: the curve over $[a,b]$ at $t$ is the curve of $(R_i^i,\omega_i^i)$ at $(t-a)/(c-a)$
:method: Both sides are rational functions of $a,h,\lambda,x$, the weights and the points; every $a<b$, $c\ne a$ and
  $t$ is of the given form.
:degrees: 1..6 sampled 12
:control: the basis argument $(t-a)/(b-a)$ on both sides
:::
*/
CLAIM(subdivision_left_half)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], Rl[MAX_DEGREE + 1], wl[MAX_DEGREE + 1], Rr[MAX_DEGREE + 1],
        wr[MAX_DEGREE + 1];
    num a = unknown(T, "a", 0), h = positive(T, "h", 0), lambda = parameter(T, "lambda"), x = parameter(T, "x"), left,
        right;
    G(free_curve)(T, n, R, w);
    num b = add(a, h), c = add(a, mul(lambda, h)), t = add(a, mul(x, sub(c, a)));
    num whole = div(sub(t, a), sub(b, a)), part = div(sub(t, a), sub(c, a));
    G(triangle_sides)(n, R, w, div(sub(c, a), sub(b, a)), Rl, wl, Rr, wr);
    G(rational_point)(n, 1, R, w, whole, &left);
    G(rational_point)(n, 1, Rl, wl, fault(T, part, whole), &right);
    same(T, right, left);
}

/*
:::{claim} subdivision_right_half
:title: The right side of the triangle carries the curve over [c,b]
:zh: 三角阵右边给出右段曲线
:given: positive weights, points $R_0,\dots,R_n$, $a$, $b=a+h$, $c=a+\lambda h$ and $t=c+x(b-c)$, with $h>0$
:then: the curve over $[a,b]$ at $t$ is the curve of $(R_n^{n-i},\omega_n^{n-i})$ at $(t-c)/(b-c)$
:method: Both sides are rational functions of $a,h,\lambda,x$, the weights and the points; every $a<b$, $c\ne b$ and
  $t$ is of the given form.
:degrees: 1..6 sampled 12
:control: the basis argument $(t-a)/(b-a)$ on both sides
:::
*/
CLAIM(subdivision_right_half)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], Rl[MAX_DEGREE + 1], wl[MAX_DEGREE + 1], Rr[MAX_DEGREE + 1],
        wr[MAX_DEGREE + 1];
    num a = unknown(T, "a", 0), h = positive(T, "h", 0), lambda = parameter(T, "lambda"), x = parameter(T, "x"), left,
        right;
    G(free_curve)(T, n, R, w);
    num b = add(a, h), c = add(a, mul(lambda, h)), t = add(c, mul(x, sub(b, c)));
    num whole = div(sub(t, a), sub(b, a)), part = div(sub(t, c), sub(b, c));
    G(triangle_sides)(n, R, w, div(sub(c, a), sub(b, a)), Rl, wl, Rr, wr);
    G(rational_point)(n, 1, R, w, whole, &left);
    G(rational_point)(n, 1, Rr, wr, fault(T, part, whole), &right);
    same(T, right, left);
}

/*
:::{claim} cut_at_an_end_is_empty
:title: Cut at an end, one part is a point and the other the whole curve
:zh: 在端点处离散:一段退缩为点
:given: positive weights and points $R_0,\dots,R_n$
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
    G(free_curve)(T, n, R, w);
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
:title: Outside the interval positive weights do not suffice
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
#endif

/*
:::{statement} wang-ch3:thm-3.3.1-proof
:title: Apply the polynomial theorem to numerator and denominator
:zh: 对分子分母分别应用多项式情形
:printed: Theorem 1.4.1, applied to the numerator and the denominator of (3.2.2), gives the theorem
:holds-by: numerator_and_denominator_are_cut_alike

Chapter 1 of the source is not at hand; its theorem is taken to be subdivision by de Casteljau.
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
    G(free_curve)(T, n, R, w);
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
:::{statement} wang-ch3:3.3.1-left
:title: The left part of the curve, over [a,c]
:zh: 离散公式左段
:printed: \mathbf R(t)=\frac{\sum_{i=0}^nB_i^n\bigl(\frac{t-a}{b-a}\bigr)\omega_i\mathbf
  R_i}{\sum_{i=0}^nB_i^n\bigl(\frac{t-a}{b-a}\bigr)
  \omega_i}=\frac{\sum_{i=0}^nB_i^n\bigl(\frac{t-a}{c-a}\bigr)\omega_i^i(c)\mathbf R_i^i(c)}
  {\sum_{i=0}^nB_i^n\bigl(\frac{t-a}{c-a}\bigr)\omega_i^i(c)},\quad a\le t\le c
:holds-by: subdivision_left_half
:needs: intermediate_weight_can_vanish | positive weights

As an identity it holds for every $t$.
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
:corrected-by: subdivision_right_half
:needs: intermediate_weight_can_vanish | positive weights
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
:result: R(t) = 3/4; printed quotient = 7/8
:given: two points of the line with equal weights, $[a,b]=[0,1]$, the cut $c$ and a parameter $t$ of the right part; the
  weights in the numerator taken as they should be
:then: the printed quotient is not $R(t)$
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
    found(T, "printed quotient", printed);
    about(T, "left the curve, right the printed quotient");
    same(T, curve, printed);
}

/*
:::{claim} printed_right_half_has_the_wrong_weight
:title: The numerator's weights are not those of the denominator
:zh: 右段分子的权误印
:kind: counterexample
:data: R = 0 1/2 1; ω = 1 2 3; c = 1/2; t = 3/4
:result: ω_1^1, ω_2^1 = 3/2 5/2; R(t) = 33/40; printed quotient = 133/200
:given: three points of the line, their weights, $[a,b]=[0,1]$, the cut $c$ and a parameter $t$ of the right part; in the
  numerator the argument is taken as it should be, and for $i=0$ the weight too, since $\omega_0^2$ is not defined
:then: $\omega_1^1$, the printed weight of $R_2^1$ in the numerator, is not $\omega_2^1$, the one in the denominator, and the
  printed quotient is not $R(t)$
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
    found(T, "printed quotient", printed);
    about(T, "left the curve, right the printed quotient");
    same(T, curve, printed);
}
#endif

/*
## What follows

:::{statement} wang-ch3:rem-3.3.1-generalises
:title: The theorem generalises the polynomial one
:zh: 多项式情形的推广
:printed: The theorem is a generalisation of theorem 1.4.1
:holds-by: equal_weights_give_polynomial_triangle

Theorem 1.4.1 is taken as in the entry on the proof.
:::

:::{claim} equal_weights_give_polynomial_triangle
:title: For equal weights the triangle is de Casteljau's
:zh: 权相等时即 de Casteljau 三角阵
:given: points $R_0,\dots,R_n$ with one weight $\omega\ne0$, and $\lambda$
:then: $\omega_i^r=\omega$ and $R_i^r=\sum_{k=0}^rB_k^r(\lambda)R_{i-r+k}$, that is
  $R_i^r=(1-\lambda)R_{i-1}^{r-1}+\lambda R_i^{r-1}$
:method: Every level is compared as rational functions of $\lambda$, $\omega$ and the points.
:degrees: 1..8 sampled 12
:control: $\omega_n$ doubled
:::
*/
CLAIM(equal_weights_give_polynomial_triangle)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], v[MAX_DEGREE + 1], P[MAX_DEGREE + 1], B[MAX_DEGREE + 1];
    num lambda = parameter(T, "lambda"), weight = unknown(T, "w", 0);
    for (int i = 0; i <= n; i++) {
        w[i] = fault(T, weight, i == n ? add(weight, weight) : weight);
        R[i] = unknown(T, "R", i);
    }
    for (int r = 0; r <= n; r++) {
        G(rational_casteljau)(n, 1, R, w, lambda, r, P, v);
        G(bernstein_basis)(r, lambda, B);
        for (int i = r; i <= n; i++) {
            num point = from_int(0);
            for (int k = 0; k <= r; k++)
                point = add(point, mul(B[k], R[i - r + k]));
            same(T, v[i - r], weight);
            same(T, P[i - r], point);
        }
    }
}

/*
:::{statement} wang-ch3:rem-3.3.1-evaluation
:title: Evaluation by recursion, and the construction of a point
:zh: 递归求值与作图
:printed: From the theorem follow the recursive evaluation of a rational Bézier curve and its geometric construction
:holds-by: triangle_ends_on_the_curve triangle_level_by_level
:needs: intermediate_weight_can_vanish | positive weights: otherwise a point of the construction may be missing

The evaluation is $\mathbf R(c)=\mathbf R_n^n(c)$; the construction divides each edge in the ratio
$\lambda\omega_i^{r-1}:(1-\lambda)\omega_{i-1}^{r-1}$.
:::

:::{claim} triangle_ends_on_the_curve
:title: The last point of the triangle is the point of the curve
:zh: 三角阵末点即曲线上的点
:given: positive weights, points $R_0,\dots,R_n$, $\lambda$
:then: $R_n^n=\sum B_i^n(\lambda)\omega_iR_i/\sum B_i^n(\lambda)\omega_i$
:method: The triangle on the left, Bernstein polynomials on the right, compared as rational functions.
:degrees: 1..6 sampled 16
:control: $R_{n-1}$ for $R_n$ in the sum
:::
*/
CLAIM(triangle_ends_on_the_curve)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], B[MAX_DEGREE + 1], P, v, up = from_int(0), down = from_int(0);
    num lambda = parameter(T, "lambda");
    G(free_curve)(T, n, R, w);
    G(bernstein_basis)(n, lambda, B);
    for (int i = 0; i <= n; i++) {
        num share = mul(B[i], w[i]);
        down = add(down, share);
        up = add(up, mul(share, R[fault(T, i, i == n ? n - 1 : i)]));
    }
    G(rational_casteljau)(n, 1, R, w, lambda, n, &P, &v);
    same(T, v, down);
    same(T, P, div(up, down));
}

/*
:::{statement} wang-ch3:rem-3.3.1-convex
:title: Each new point is a convex combination of two old ones
:zh: 凸线性组合
:printed: By (3.3.3), $\mathbf R_i^r(c)$ is a convex combination of $\mathbf R_{i-1}^{r-1}(c)$ and $\mathbf
  R_i^{r-1}(c)$
:holds-by: cut_coefficients_are_convex
:needs: negative_weight_breaks_convexity | positive weights: otherwise, on a perfectly regular curve, a coefficient
  is negative
:figure: cut_leaves_the_edge
:::

:::{statement} wang-ch3:rem-3.3.1-cutting
:title: Geometrically the theorem cuts corners, level after level
:zh: 几何意义:递归割角
:printed: The geometric meaning of the theorem is again recursive corner cutting
:holds-by: cut_coefficients_are_convex triangle_level_by_level
:needs: negative_weight_breaks_convexity | positive weights
:::

:::{claim} cut_coefficients_are_convex
:title: Between positive weights the coefficients are positive with sum 1
:zh: 割角系数为正且和为一
:given: two neighbouring weights $p,q>0$ of any level, $0<\lambda<1$
:let: $v=(1-\lambda)p+\lambda q$
:then: $v>0$; $(1-\lambda)p/v>0$, $\lambda q/v>0$, with sum $1$; and $(v-p)(q-v)=\lambda(1-\lambda)(q-p)^2\ge0$, so
  that $v$ lies between $p$ and $q$
:method: With $\lambda=s/(1+s)$, $s>0$, all coefficients are positive.  By induction on the level all $\omega_i^r$
  are positive, and none is less than the least or more than the largest $\omega_i$.
:scope: any two neighbouring weights of any level, in every degree
:control: the second coefficient with $1-\lambda$ for $\lambda$
:::
*/
CLAIM(cut_coefficients_are_convex)
{
    num p = positive(T, "p", 0), q = positive(T, "q", 0), lambda = inside(T, "s"), mu = sub(from_int(1), lambda);
    num left = mul(mu, p), right = mul(lambda, q), v = add(left, right), gap = sub(q, p);
    num first = div(left, v), second = div(fault(T, right, mul(mu, q)), v);
    nonnegative(T, v);
    nonnegative(T, first);
    nonnegative(T, second);
    same(T, add(first, second), from_int(1));
    same(T, mul(sub(v, p), sub(q, v)), mul(mul(lambda, mu), mul(gap, gap)));
}

#if RATIONAL
/*
:::{claim} negative_weight_breaks_convexity
:title: With a negative weight a point of the triangle leaves its edge
:zh: 异号权时割角点离开边
:kind: decision
:data: ω = 1 -1/4 1; λ = 1/2
:instead: ω = 1 1/4 1
:result: real zeros of ω(t) = 0; coefficients of R_0, R_1 = 4/3 -1/3
:given: three weights $\omega$, the middle one negative, and $\lambda$ in the middle
:then: $\omega(t)>0$ for every real $t$, but in $R_1^1$ the point $R_1$ has a negative coefficient, and $R_0$ one above 1
:method: The roots of $\omega(t)$ are counted exactly; the coefficients are $R_1^1$ for the points $1,0$ and $0,1$ of the line.
:control: $\omega_1$ with the other sign
:::
*/
CLAIM(negative_weight_breaks_convexity)
{
    num w[3], v[2], P[2], coefficient[2];
    given_points(T, "ω", 3, 1, w);
    num lambda = given(T, "λ");
    int zeros = count_roots_line(poly_from_bernstein(2, w)).distinct;
    found_whole(T, "real zeros of ω(t)", zeros);
    agree(T, zeros == 0);
    for (int k = 0; k < 2; k++) {
        num unit[3] = {from_int(k == 0), from_int(k == 1), from_int(0)};
        G(rational_casteljau)(2, 1, unit, w, lambda, 1, P, v);
        coefficient[k] = P[0];
    }
    found_points(T, "coefficients of R_0, R_1", 2, 1, coefficient);
    same(T, add(coefficient[0], coefficient[1]), from_int(1));
    about(T, "R_1^1 lies outside the edge, before R_0");
    agree(T, sign_q(coefficient[1]) < 0);
}

/*
:::{statement} wang-ch3:rem-3.3.1-coefficients
:title: The cut depends on level, edge and weights, not on the parameter alone
:zh: 割角系数的依赖关系
:printed: The cut coefficients depend not only on the parameter $\lambda$ but on the level of cutting, the number
  $i$ of the edge and the weights $\omega_i$
:holds-by: cut_depends_on_level_edge_and_weights
:reading: cut_depends_on_level_edge_and_weights | as "in general": holds, each of the three by itself
:reading: geometric_weights_cut_evenly | for exactly the geometric weights $\omega_i=\omega_0q^i$, equal ones among
  them, it is as for polynomials: one ratio on all edges of all levels
:::

:::{claim} cut_depends_on_level_edge_and_weights
:title: Each of level, edge and weights changes the ratio
:zh: 层数、边序号、权均影响割角系数
:kind: decision
:data: ω = 1 1 2; other ω = 1 1 1; λ = 1/2
:instead: ω = 1 1 1
:result: α_2^1 = 2/3; α_1^1 = 1/2; α_2^2 = 3/5; α_2^1 of the other ω = 1/2
:given: two triples of weights, and $\lambda$ in the middle
:let: $\alpha_i^r=\lambda\omega_i^{r-1}/\omega_i^r$, the coefficient of the second point in (3.3.3)
:then: $\alpha_2^1$ differs from $\alpha_1^1$, which has another edge; from $\alpha_2^2$, which has another level; and from
  $\alpha_2^1$ of the other weights
:method: The weights of the triangle are computed exactly; each of the three differs from $\alpha_2^1$ in one thing only.
:control: the other weights throughout
:::
*/
/* α_i^r = λ ω_i^{r-1}/ω_i^r, from the triangle of three weights. */
static num G(second_coefficient)(const num w[], num lambda, int r, int i)
{
    num level[3] = {w[0], w[1], w[2]}; /* ω_k^s stands at k - s */
    for (int s = 1; s < r; s++)
        G(bezier_casteljau_level)(3 - s, 1, level, lambda);
    num share = mul(lambda, level[i - r + 1]);
    G(bezier_casteljau_level)(3 - r, 1, level, lambda);
    return div(share, level[i - r]);
}

CLAIM(cut_depends_on_level_edge_and_weights)
{
    num w[3], other[3];
    given_points(T, "ω", 3, 1, w);
    given_points(T, "other ω", 3, 1, other);
    num lambda = given(T, "λ"), here = G(second_coefficient)(w, lambda, 1, 2);
    num edge = G(second_coefficient)(w, lambda, 1, 1), level = G(second_coefficient)(w, lambda, 2, 2);
    num weights = G(second_coefficient)(other, lambda, 1, 2);
    found(T, "α_2^1", here);
    found(T, "α_1^1", edge);
    found(T, "α_2^2", level);
    found(T, "α_2^1 of the other ω", weights);
    about(T, "whether edge, level and weights, each by itself, change the coefficient");
    agree(T, !equal_q(here, edge));
    agree(T, !equal_q(here, level));
    agree(T, !equal_q(here, weights));
}
#endif

/*
:::{claim} geometric_weights_cut_evenly
:title: Exactly geometric weights are cut at one ratio everywhere
:zh: 等比权时各边割角系数相同
:given: three neighbouring weights of level $r-1$, and $\lambda$
:then: for $\omega,\omega q,\omega q^2$ the coefficient is $\lambda q/(1-\lambda+\lambda q)$ on both edges, and the
  two weights of the next level again have the quotient $q$; for any three weights $x,y,z$ the coefficients on the
  two edges differ by $\lambda(1-\lambda)(xz-y^2)$ over the product of the two new weights
:method: Identities of rational functions.  By induction on the level geometric weights are cut at one ratio; and if
  the ratio is one on all edges of level 1 for one $\lambda\in(0,1)$, then $\omega_{i-1}\omega_{i+1}=\omega_i^2$ for
  all $i$.
:scope: any three neighbouring weights, in every degree
:control: $q^3$ for $q^2$
:::
*/
/* lambda q / ((1-lambda) p + lambda q) */
static num G(cut_coefficient)(num p, num q, num lambda)
{
    num share = mul(lambda, q);
    return div(share, add(mul(sub(from_int(1), lambda), p), share));
}

CLAIM(geometric_weights_cut_evenly)
{
    num x = positive(T, "x", 0), q = positive(T, "q", 0), lambda = parameter(T, "lambda"), one = from_int(1);
    num v[] = {x, mul(x, q), mul(x, mul(q, q))};
    v[2] = fault(T, v[2], mul(v[2], q));
    num expected = G(cut_coefficient)(one, q, lambda);
    same(T, G(cut_coefficient)(v[0], v[1], lambda), expected);
    same(T, G(cut_coefficient)(v[1], v[2], lambda), expected);
    G(bezier_casteljau_level)(2, 1, v, lambda);
    same(T, div(v[1], v[0]), q);

    num y = positive(T, "y", 0), z = positive(T, "z", 0), any[] = {x, y, z};
    num gap = sub(G(cut_coefficient)(y, z, lambda), G(cut_coefficient)(x, y, lambda));
    G(bezier_casteljau_level)(2, 1, any, lambda);
    same(T, mul(gap, mul(any[0], any[1])), mul(mul(lambda, sub(one, lambda)), sub(mul(x, z), mul(y, y))));
}

/*
## The polygons converge

:::{statement} wang-ch3:rem-3.3.1-uniform
:title: The polygons of repeated cutting converge uniformly to the curve
:zh: 离散割角多边形序列一致收敛到原曲线
:printed: The sequence of polygons of the cut rational Bézier curve converges uniformly to the curve
:holds-by: second_differences_shrink_quadratically polygon_and_curve_are_near_the_chord
  near_homogeneous_points_are_near cut_coefficients_are_convex
:reading: quarter_circle_error_is_quartered | each piece cut at one fixed ratio, or at ratios kept away from $0$ and
  $1$: holds, with the order $h^2$ in the length $h$ of the longest piece; cut in the middle, the error is divided
  by 4 each time
:needs: crowded_cuts_do_not_converge | pieces that become short, as at a fixed ratio; with a new ratio in every step
  a piece may stay long for ever
:needs: linear_weights_of_both_signs_have_a_pole | positive weights
:figure: cut_polygons_converge

Let a piece have the parameter length $h$.  Its homogeneous second differences are at most $h^2M$, $M$ being the
largest of the curve itself; polygon and curve are then at most $\frac{n^2}4h^2M$ apart, at equal parameters; and as
no weight falls below the least $\omega_i$, the projection to points of space multiplies this by a constant.  At a
fixed ratio $\lambda$ the longest piece after $k$ steps has the length $\max(\lambda,1-\lambda)^k$.
:::

:::{claim} second_differences_shrink_quadratically
:title: Over an interval of length h second differences shrink with the square of h
:zh: 二阶差分按区间长度平方缩小
:given: a polynomial with Bernstein coefficients $b_0,\dots,b_n$ over $[0,1]$, and those over $[u,v]$, $0<u,v<1$
:then: $\Delta^2b_i^{[u,v]}=(v-u)^2\sum_j\beta_{ij}\Delta^2b_j$ with $\beta_{ij}\ge0$, $\sum_j\beta_{ij}=1$
:method: The coefficients over $[u,v]$ are values of the polar form.  $\beta_{ij}$ is the polar form of the
  polynomial with coefficients $0,\dots,1,\dots,0$ of degree $n-2$ at $n-2-i$ arguments $u$ and $i$ arguments $v$;
  with $u=r/(1+r)$, $v=s/(1+s)$ its coefficients are nonnegative.  So
  $\max|\Delta^2b^{[u,v]}|\le(v-u)^2\max|\Delta^2b|$; the ends $0$ and $1$ follow by continuity.
:degrees: 2..6 sampled 10
:control: $v-u$ for $(v-u)^2$
:::
*/
CLAIM(second_differences_shrink_quadratically)
{
    int n = T->degree;
    num b[MAX_DEGREE + 1], d[MAX_DEGREE + 1], piece[MAX_DEGREE + 1], at[MAX_DEGREE], u = inside(T, "r"),
                                                                                     v = inside(T, "s");
    num h = sub(v, u), scale = fault(T, mul(h, h), h);
    for (int i = 0; i <= n; i++)
        b[i] = unknown(T, "b", i);
    for (int j = 0; j <= n - 2; j++)
        d[j] = add(sub(b[j], add(b[j + 1], b[j + 1])), b[j + 2]);
    G(bezier_on_interval)(n, 1, b, u, v, piece);
    for (int i = 0; i <= n - 2; i++) {
        num sum = from_int(0), total = from_int(0);
        for (int k = 0; k < n - 2; k++)
            at[k] = k < i ? v : u;
        for (int j = 0; j <= n - 2; j++) {
            num e[MAX_DEGREE + 1], beta;
            for (int k = 0; k <= n - 2; k++)
                e[k] = from_int(k == j);
            G(bezier_blossom)(n - 2, 1, e, at, &beta);
            nonnegative(T, beta);
            total = add(total, beta);
            sum = add(sum, mul(beta, d[j]));
        }
        same(T, total, from_int(1));
        same(T, add(sub(piece[i], add(piece[i + 1], piece[i + 1])), piece[i + 2]), mul(scale, sum));
    }
}

/*
:::{claim} polygon_and_curve_are_near_the_chord
:title: A polygon is as near to its chord as its second differences are small
:zh: 控制多边形与弦之距由二阶差分界定
:given: variables $n,j,k$, and $b_0,b_1$, $b_{n-1},b_n$, $b_{j-1},b_j,b_{j+1}$ of a polygon
:let: $g_j=j(n-k)/n$ for $j\le k$ and $g_j=k(n-j)/n$ for $j\ge k$; $T_j=g_jb_{j+1}-g_{j+1}b_j$
:then: $g_j\Delta^2b_{j-1}-b_j\Delta^2g_{j-1}=T_j-T_{j-1}$, for any $g$; $T_{n-1}-T_0=\frac{n-k}nb_0+\frac knb_n$;
  $\Delta^2g_{j-1}$ is $0$ for $j\ne k$ and $-1$ for $j=k$; $\sum_{0<j<n}g_j=\frac{k(n-k)}2\le\frac{n^2}8$
:method: Each is computed from the formulas of $g$ at the neighbouring indices.  Added up over $0<j<n$ the first
  three give $b_k-\bigl(\frac{n-k}nb_0+\frac knb_n\bigr)=-\sum_{0<j<n}g_j\,\Delta^2b_{j-1}$ for
  all $0<k<n$, all $g_j\ge0$: the points of a polygon are at most $\frac{n^2}8\max|\Delta^2b|$ away from the chord
  at the parameters $k/n$, hence so are the polygon, by linear interpolation, and the curve, being $\sum
  B_k^n(t)b_k$ with $\sum B_k^n(t)\frac kn=t$.  Polygon and curve are at most $\frac{n^2}4\max|\Delta^2b|$ apart.
:degrees: all
:control: $g_j=j(n-k)$ for $j\le k$
:::
*/
/* g_j by the formula for j <= k, times n in the control, or by that for j >= k. */
static num G(green)(const trial *T, num n, num k, num j, int below)
{
    num product = below ? mul(j, sub(n, k)) : mul(k, sub(n, j));
    return fault(T, div(product, n), below ? product : div(product, n));
}

CLAIM(polygon_and_curve_are_near_the_chord)
{
    num n = positive(T, "n", 0), j = positive(T, "j", 0), k = positive(T, "k", 0), b[7], g[3];
    num zero = from_int(0), one = from_int(1), two = from_int(2);
    for (int i = 0; i < 7; i++) /* b_0, b_1, b_{n-1}, b_n and then b_{j-1}, b_j, b_{j+1} */
        b[i] = unknown(T, "b", i);
    for (int i = 0; i < 3; i++) /* g_{j-1}, g_j, g_{j+1} */
        g[i] = unknown(T, "g", i);
    about(T, "summation by parts");
    num bend_b = sub(add(b[4], b[6]), mul(two, b[5])), bend_g = sub(add(g[0], g[2]), mul(two, g[1]));
    num step = sub(sub(mul(g[1], b[6]), mul(g[2], b[5])), sub(mul(g[0], b[5]), mul(g[1], b[4])));
    same(T, sub(mul(g[1], bend_b), mul(b[5], bend_g)), step);
    about(T, "the second differences beside the corner");
    for (int below = 0; below < 2; below++) {
        num low = G(green)(T, n, k, sub(j, one), below), high = G(green)(T, n, k, add(j, one), below);
        same(T, add(low, high), mul(two, G(green)(T, n, k, j, below)));
    }
    about(T, "the two formulas and the second difference at the corner");
    num corner = G(green)(T, n, k, k, 1), low = G(green)(T, n, k, sub(k, one), 1);
    same(T, corner, G(green)(T, n, k, k, 0));
    same(T, sub(add(low, G(green)(T, n, k, add(k, one), 0)), mul(two, corner)), neg(one));
    about(T, "the ends and the chord");
    num first = sub(mul(G(green)(T, n, k, zero, 1), b[1]), mul(G(green)(T, n, k, one, 1), b[0]));
    num last = sub(mul(G(green)(T, n, k, sub(n, one), 0), b[3]), mul(G(green)(T, n, k, n, 0), b[2]));
    same(T, sub(last, first), div(add(mul(sub(n, k), b[0]), mul(k, b[3])), n));
    about(T, "the sum of g: its first and last value, of as many as there are, on each side of the corner");
    num rest = sub(n, k), half = from_ratio(1, 2);
    num below = mul(mul(half, k), add(G(green)(T, n, k, one, 1), corner));
    num above =
        mul(mul(half, sub(rest, one)), add(G(green)(T, n, k, add(k, one), 0), G(green)(T, n, k, sub(n, one), 0)));
    same(T, add(below, above), mul(half, mul(k, rest)));
    about(T, "the largest sum");
    num offset = sub(n, add(k, k));
    same(T, sub(div(mul(n, n), from_int(8)), add(below, above)), div(mul(offset, offset), from_int(8)));
}

/*
:::{claim} near_homogeneous_points_are_near
:title: Homogeneous points that are near, with weights kept from 0, have near images
:zh: 齐次点相近则投影点相近
:given: homogeneous points $(P,w)$, $(Q,v)$ of weights $w,v\ne0$
:then: $\frac Pw-\frac Qv=\frac1w\Bigl((P-Q)-\frac Qv(w-v)\Bigr)$
:method: An identity.  So the distance of the images is at most $(\|P-Q\|+\|Q/v\||w-v|)/w$: with $w$ at least the
  least weight and $Q/v$ in the convex hull of the points, a constant times the distance of the homogeneous points.
:scope: every degree
:control: $P/w$ for $Q/v$ on the right
:::
*/
CLAIM(near_homogeneous_points_are_near)
{
    num P = unknown(T, "P", 0), Q = unknown(T, "Q", 0), w = positive(T, "w", 0), v = positive(T, "v", 0);
    num image = fault(T, div(Q, v), div(P, w));
    same(T, sub(div(P, w), div(Q, v)), div(sub(sub(P, Q), mul(image, sub(w, v))), w));
}

#if RATIONAL
/*
:::{claim} quarter_circle_error_is_quartered
:title: The polygons of a quarter circle, cut in the middle: each cut divides the error by 4
:zh: 四分之一圆反复中点离散:误差恰为 4^{-k}
:kind: decision
:data: R = (1,0) (1,1) (0,1); ω = 1 1 2; λ = 1/2; q = 4
:instead: λ = 1/4
:result: errors = 1 1/4 1/16 1/64 1/256 1/1024 1/4096
:given: the quarter circle with points $R$ and weights $\omega$, whose pieces are all cut at $\lambda$, again and again
:then: the largest $|\|V\|^2-1|$ over all vertices $V$ of the polygons is 1 at first, and each cut divides it by $q$
:method: All pieces are computed exactly, $2^k$ of them after $k$ cuts.
:control: every piece cut nearer to its first end
:::
*/
/* The largest | |V|^2 - 1 | over the vertices, after k further cuts of the quadratic (R, w). */
static num G(largest_circle_error)(int k, const num R[], const num w[], num lambda)
{
    num worst = from_int(0), P[2][6], v[2][3];
    if (k == 0) {
        for (int i = 0; i <= 2; i++) {
            num e = sub(G(norm_squared)(2, R + 2 * i), from_int(1)), size = sign_q(e) < 0 ? neg(e) : e;
            worst = compare_q(size, worst) > 0 ? size : worst;
        }
        return worst;
    }
    G(rational_split)(2, 2, R, w, lambda, P[0], v[0], P[1], v[1]);
    for (int half = 0; half < 2; half++) {
        num e = G(largest_circle_error)(k - 1, P[half], v[half], lambda);
        worst = compare_q(e, worst) > 0 ? e : worst;
    }
    return worst;
}

CLAIM(quarter_circle_error_is_quartered)
{
    enum { CUTS = 6 };
    num R[6], w[3], error[CUTS + 1];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    num lambda = given(T, "λ"), q = given(T, "q");
    for (int k = 0; k <= CUTS; k++)
        error[k] = G(largest_circle_error)(k, R, w, lambda);
    found_points(T, "errors", CUTS + 1, 1, error);
    same(T, error[0], from_int(1));
    for (int k = 1; k <= CUTS; k++)
        same(T, mul(q, error[k]), error[k - 1]);
}
#endif

/*
:::{claim} crowded_cuts_do_not_converge
:title: Cuts that crowd one end leave a piece of length above 1/2 for ever
:zh: 分割点聚于一端时多边形不收敛
:given: the parabola $(t,t^2)$ over $[0,1]$, all pieces cut at $\lambda_k=2^{-k-1}$ in step $k=1,2,\dots$; the last
  piece, of length $h_k$
:then: $h_k\ge\frac12+2^{-k-1}$ for every $k$; the middle vertex of a piece of length $h$ lies $h^2/4$ below the
  parabola: there is always a vertex more than $\frac1{16}$ below the curve
:method: $h_1=\frac34$.  With $y=2^{-k-1}$, the step $h_{k+1}=h_k(1-\frac y2)$ and the identity $(\frac12+y)(1-\frac
  y2)-(\frac12+\frac y2)=\frac{y(1-2y)}4$, whose right side is nonnegative for $0<y\le\frac14$ ($y=1/(4+s)$,
  $s\ge0$), give the bound by induction.  The piece over $[u,u+h]$ is computed with $u$ and $h$ variable.
:scope: every number of steps
:control: $\lambda_k=\frac12$ in the step
:::
*/
CLAIM(crowded_cuts_do_not_converge)
{
    num one = from_int(1), half = from_ratio(1, 2), s = positive(T, "s", 0), y = div(one, add(from_int(4), s));
    num factor = fault(T, sub(one, mul(half, y)), half);
    num margin = sub(mul(add(half, y), factor), add(half, mul(half, y)));
    same(T, margin, div(mul(y, sub(one, add(y, y))), from_int(4)));
    show(T, "y", y);
    show(T, "new length less 1/2 + y/2, at least", margin);
    nonnegative(T, margin);
    same(T, sub(one, from_ratio(1, 4)), add(half, from_ratio(1, 4)));

    num zero = from_int(0), P[] = {zero, zero, half, zero, one, one}, piece[6];
    num u = parameter(T, "u"), h = parameter(T, "h");
    G(bezier_on_interval)(2, 2, P, u, add(u, h), piece);
    same(T, sub(mul(piece[2], piece[2]), piece[3]), div(mul(h, h), from_int(4)));
}

/*
:::{claim} linear_weights_of_both_signs_have_a_pole
:title: With weights of both signs the curve may be unbounded
:zh: 异号权时曲线可无界
:given: $n=1$, weights $p$ and $-q$, $p,q>0$
:then: $\omega(t)=0$ at $t=p/(p+q)$, which is in $(0,1)$: no sequence of bounded polygons converges there
:method: Computed as rational functions of $p$ and $q$.
:scope: n = 1
:control: the weight $+q$
:::
*/
CLAIM(linear_weights_of_both_signs_have_a_pole)
{
    num p = positive(T, "p", 0), q = positive(T, "q", 0), w[] = {p, fault(T, neg(q), q)}, t = div(p, add(p, q));
    show_points(T, "ω", 2, 1, w);
    show(T, "t", t);
    nonnegative(T, t);
    nonnegative(T, sub(from_int(1), t));
    vanishes(T, G(rational_weight)(1, w, t));
}
#include "chapters/judge/claims_off.h"
