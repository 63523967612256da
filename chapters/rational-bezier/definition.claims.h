/*
# What a rational Bézier curve is (定义)

Give every point $R_i$ of a polygon a number $\omega_i$, its weight.  The curve is the mean of the points in
which $R_i$ counts $B_i^n(t)\,\omega_i$ times, $B_i^n(t)=\binom ni(1-t)^{n-i}t^i$.  In coordinates $(\omega x,\omega
y,\omega z,\omega)$ numerator and denominator of that mean are one polynomial Bézier curve, and this is how the
source defines it.
*/
#include "exact/record/roots.h"
#include "exact/record/sturm.h"

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

/*
## The points and their weights

:::{statement} wang-ch3:def-3.2.1
:title: Rational Bézier curve, control points, control polygon, weights
:zh: 有理 Bézier 曲线、控制顶点、控制多边形与权因子
:definition: yes
:printed: Given, in space $\mathfrak R^3$ and in homogeneous coordinates, $n+1$ points
  $\tilde{\mathbf R}_i=(X_i,Y_i,Z_i,\omega_i)=(\omega_ix_i,\omega_iy_i,\omega_iz_i,\omega_i)$, $i=0,1,\dots,n$, the rational
  parametric curve (3.2.1) of degree $n$ is called a rational Bézier curve of degree $n$, where $B_i^n(t)$ is the Bernstein basis of degree $n$; the
  $\tilde{\mathbf R}_i$ are called its control points, $\tilde{\mathbf R}_0\tilde{\mathbf R}_1\cdots\tilde{\mathbf R}_n$ its control polygon or B-net,
  the $\omega_i$ its weights.
:checked-by: homogeneous_point_determines_point_and_weight mean_grows_by_one_term
:confirmed-by: homogeneous_points_carry_their_weight common_factor_of_weights_is_free

The pair $(R_i,\omega_i)$ and the homogeneous point determine each other as long as $\omega_i\ne0$.  A common
factor of the weights, if it is not 0, does not change the curve in space.
:::

:::{claim} homogeneous_point_determines_point_and_weight
:title: A homogeneous point determines its point and its weight, and they determine it
:zh: 齐次点与带权点一一对应
:given: a point $(x,y,z)$ of space and a weight $\omega\ne0$; a homogeneous point $(X,Y,Z,W)$, $W\ne0$
:where: no weight is 0
:then: $(\omega x,\omega y,\omega z,\omega)$ has the quotients $x,y,z$ by its last coordinate, and the point $(\frac XW,\frac YW,\frac ZW)$ with the weight $W$ has
  the products $(X,Y,Z,W)$
:method: The products and quotients that the program forms are undone by the other operation, written out here.  Each point of a polygon is treated by
  itself, so that there may be any number.
:degrees: all
:over: h#: weights; H# x# y# z#: points
:control: the last coordinate without the weight
:::
*/
CLAIM(homogeneous_point_determines_point_and_weight)
{
    num w = positive(T, "h", 0), W = positive(T, "h", 1), R[3], H[4], back[3], v;
    G(free_points)(T, 0, 3, R);
    G(rational_homogenize)(0, 3, R, &w, H);
    num last = fault(T, H[3], from_int(1));
    about(T, "the quotients");
    same(T, last, w);
    for (int c = 0; c < 3; c++)
        same(T, div(H[c], last), R[c]);
    for (int c = 0; c < 3; c++)
        H[c] = unknown(T, "H", c);
    H[3] = W;
    G(rational_dehomogenize)(0, 3, H, back, &v);
    about(T, "the products");
    same(T, v, W);
    for (int c = 0; c < 3; c++)
        same(T, mul(v, back[c]), H[c]);
}

/* n+1 weights, all of them free and of either sign. */
static inline void G(free_weights)(trial *T, int n, num w[])
{
    for (int i = 0; i <= n; i++)
        w[i] = unknown(T, "w", i);
}
static inline void G(positive_weights)(trial *T, int n, num w[])
{
    for (int i = 0; i <= n; i++)
        w[i] = positive(T, "w", i);
}

/*
:::{claim} homogeneous_points_carry_their_weight
:title: Points with weights and homogeneous points determine each other
:zh: 带权点与齐次点互相确定
:given: weights $\omega_i\ne0$ and points $R_i$ of one, two and three coordinates; homogeneous points $H_i$ of as many and one more
:where: no weight is 0
:then: $(R_i,\omega_i)\mapsto(\omega_iR_i,\omega_i)$ has the quotients $R_i$ by its last coordinate, and
  $H_i\mapsto(R_i,\omega_i)$ has the products $H_i=(\omega_iR_i,\omega_i)$
:method: Each map is computed on variables and undone by the other arithmetic operation, written out here.
:degrees: 1..6 sampled 12
:defines: rational_homogenize rational_dehomogenize
:over: H#: points; h#: weights
:control: two neighbouring weights exchanged
:::
*/
CLAIM(homogeneous_points_carry_their_weight)
{
    int n = T->degree;
    for (int dim = 1; dim <= 3; dim++) {
        num w[MAX_DEGREE + 1], R[(MAX_DEGREE + 1) * 3], H[(MAX_DEGREE + 1) * MAX_DIM];
        num back[(MAX_DEGREE + 1) * 3], v[MAX_DEGREE + 1];
        G(free_weights)(T, n, w);
        G(free_points)(T, n, dim, R);
        G(rational_homogenize)(n, dim, R, w, H);
        if (T->faulty) {
            num first = w[0];
            w[0] = w[1];
            w[1] = first;
        }
        for (int i = 0; i <= n; i++) {
            same(T, H[i * (dim + 1) + dim], w[i]);
            for (int c = 0; c < dim; c++)
                same(T, div(H[i * (dim + 1) + c], w[i]), R[i * dim + c]);
        }
        for (int m = 0; m < (n + 1) * (dim + 1); m++)
            H[m] = m % (dim + 1) == dim ? positive(T, "h", m) : unknown(T, "H", m);
        G(rational_dehomogenize)(n, dim, H, back, v);
        for (int i = 0; i <= n; i++) {
            same(T, v[i], H[i * (dim + 1) + dim]);
            for (int c = 0; c < dim; c++)
                same(T, mul(v[i], back[i * dim + c]), H[i * (dim + 1) + c]);
        }
    }
}

/*
:::{claim} common_factor_of_weights_is_free
:title: A common factor of all weights does not change the curve
:zh: 权因子的公因子不影响曲线
:given: points $R_i$, weights $\omega_i$, a factor $c\ne0$
:where: the factor is not 0
:then: the weights $\omega_i$ and $c\,\omega_i$ give the same $R(t)$; so weights that are all negative give the same curve as
  their absolute values
:method: Both are one element of the field of rational functions of $t$, $c$, the weights and the points; $c$ is any number.
:degrees: 1..6 sampled 12
:over: c: factor
:control: the last weight left without the factor
:::
*/
CLAIM(common_factor_of_weights_is_free)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], v[MAX_DEGREE + 1], R[MAX_DEGREE + 1], before, after;
    num t = parameter(T, "t"), c = unknown(T, "c", 0);
    G(free_weights)(T, n, w);
    G(free_points)(T, n, 1, R);
    for (int i = 0; i <= n; i++)
        v[i] = fault(T, mul(c, w[i]), i == n ? w[i] : mul(c, w[i]));
    G(rational_point)(n, 1, R, w, t, &before);
    G(rational_point)(n, 1, R, v, t, &after);
    same(T, after, before);
}

/*
## The two formulas of the curve

In homogeneous coordinates (齐次坐标) a rational curve is a polynomial curve of one dimension more, seen from the origin: its
points are multiplied by their weights, blended, and divided by the blended weight.  One formula is as good as the other for
computing, and the claims say that they agree, with sums that are written out from the definition of the Bernstein
polynomials.

:::{statement} wang-ch3:3.2.1
:title: The curve in homogeneous coordinates
:zh: 齐次坐标下的曲线
:definition: yes
:printed: \tilde{\mathbf R}(t)=(X(t),Y(t),Z(t),\omega(t))=\sum_{i=0}^nB_i^n(t)\tilde{\mathbf R}_i,\quad 0\le t\le1
:checked-by: triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power
:confirmed-by: denominator_is_weighted_bernstein_sum rational_point_is_weighted_mean
:figure: homogeneous_line

What is checked is that de Casteljau's recursion, by which the points are computed here, gives this sum in each of the four
coordinates.  The interval of which the verdict speaks is that of a curve that is cut, in (4); the formula is for $[0,1]$.
:::
*/

/* n!/(i! (n-i)!) t^i (1-t)^{n-i}: the definition, sharing nothing with the kernels.  n <= 20. */
static inline num G(bernstein_by_definition)(int n, int i, num t)
{
    long choose = 1;
    for (int k = 1; k <= n; k++)
        choose *= k;
    for (int k = 1; k <= i; k++)
        choose /= k;
    for (int k = 1; k <= n - i; k++)
        choose /= k;
    num product = from_int(choose), s = sub(from_int(1), t);
    for (int k = 0; k < n; k++)
        product = mul(product, k < i ? t : s);
    return product;
}

/* sum B_i^n(t) w_i and sum B_i^n(t) w_i R_i by definition. */
static inline num G(weight_by_definition)(int n, const num w[], num t)
{
    num sum = from_int(0);
    for (int i = 0; i <= n; i++)
        sum = add(sum, mul(G(bernstein_by_definition)(n, i, t), w[i]));
    return sum;
}

/*
:::{claim} denominator_is_weighted_bernstein_sum
:title: The kernel's denominator is the sum of B_i ω_i
:zh: 分母即 Σ B_i ω_i
:given: weights $\omega_0,\dots,\omega_n$ and a parameter $t$
:then: $\omega(t)=\sum_i\frac{n!}{i!\,(n-i)!}\,t^i(1-t)^{n-i}\omega_i$
:method: The kernel's recursion and the sum, written out from the definition, are one element of the field.
:degrees: 1..8 sampled 16
:defines: rational_weight
:control: the weights taken in the opposite order
:::
*/
CLAIM(denominator_is_weighted_bernstein_sum)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], v[MAX_DEGREE + 1], t = parameter(T, "t");
    G(free_weights)(T, n, w);
    for (int i = 0; i <= n; i++)
        v[i] = fault(T, w[i], w[n - i]);
    same(T, G(rational_weight)(n, w, t), G(weight_by_definition)(n, v, t));
}

static inline void G(numerator_by_definition)(int n, int dim, const num R[], const num w[], num t, num P[])
{
    for (int c = 0; c < dim; c++) {
        P[c] = from_int(0);
        for (int i = 0; i <= n; i++)
            P[c] = add(P[c], mul(mul(G(bernstein_by_definition)(n, i, t), w[i]), R[i * dim + c]));
    }
}

/*
:::{claim} rational_point_is_weighted_mean
:title: A point of the curve is the mean of the points with weights B_i ω_i
:zh: 曲线上的点是以 B_i ω_i 为权的平均
:given: weights, points of one to three coordinates, a parameter $t$
:then: the point computed through homogeneous coordinates is
  $\sum_iB_i^n(t)\omega_iR_i/\sum_iB_i^n(t)\omega_i$ with $B_i^n(t)=\frac{n!}{i!\,(n-i)!}t^i(1-t)^{n-i}$
:method: Both sides are one element of the field of rational functions of $t$, all weights and all coordinates.  The sums are
  written out from the definition of the Bernstein basis; the kernel runs a recursion on homogeneous points.
:degrees: 1..6 sampled 12
:defines: rational_point
:control: the denominator without the weights
:::
*/
CLAIM(rational_point_is_weighted_mean)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], ones[MAX_DEGREE + 1], t = parameter(T, "t");
    G(free_weights)(T, n, w);
    for (int i = 0; i <= n; i++)
        ones[i] = from_int(1);
    for (int dim = 1; dim <= 3; dim++) {
        num R[(MAX_DEGREE + 1) * 3], P[3], out[3];
        G(free_points)(T, n, dim, R);
        G(numerator_by_definition)(n, dim, R, w, t, P);
        num total = G(weight_by_definition)(n, fault(T, w, ones), t);
        G(rational_point)(n, dim, R, w, t, out);
        for (int c = 0; c < dim; c++)
            /* R(t) = Σ B_i^n(t) ω_i R_i/Σ B_i^n(t) ω_i */
            same(T, out[c], div(P[c], total));
    }
}

/*
:::{statement} wang-ch3:3.2.2
:title: The curve in affine coordinates
:zh: 仿射坐标下的曲线
:printed: \mathbf R(t)=(x(t),y(t),z(t))=\left(\frac{X(t)}{\omega(t)},\frac{Y(t)}{\omega(t)},\frac{Z(t)}{\omega(t)}\right)
  =\sum_{i=0}^nB_i^n(t)\omega_i\mathbf R_i\Big/\sum_{i=0}^nB_i^n(t)\omega_i,\quad\mathbf R_i=(x_i,y_i,z_i),\ 0\le t\le1
:holds-by: mean_grows_by_one_term
:confirmed-by: homogeneous_point_determines_point_and_weight rational_point_is_weighted_mean rational_derivatives_are_formal_derivatives positive_terms_make_a_convex_mean
:needs: weights_of_both_signs_make_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  $\omega(t)\ne0$; for which positive weights suffice: otherwise there may be no point.
:figure: homogeneous_line

With $W$ and $M$ for the weight and the quotient of some of the homogeneous points $B_i^n(t)\tilde{\mathbf R}_i$ together, one more,
$c(\mathbf R_i,1)$ with $c=B_i^n(t)\omega_i$, makes the quotient $\frac{WM+c\mathbf R_i}{W+c}$; so the quotients of all $n+1$ together are those of
the two sums.
:::
*/

#if !FIELD
/*
:::{claim} rational_derivatives_are_formal_derivatives
:title: The derivatives computed by Leibniz's rule are those of the quotient
:zh: 用 Leibniz 法则算出的导矢就是商的导矢
:given: weights, points of the line, a parameter $t$; orders $0$ to $3$
:then: $R^{(r)}(t)$ of the kernel is the $r$-th derivative of $\sum B_i^n\omega_iR_i/\sum B_i^n\omega_i$
:method: In the field the quotient is formed from the definition of the Bernstein basis and differentiated formally, as a
  rational function of $t$ in which all weights and points are variables.  The other arithmetics use the quotient rule on
  coefficients of powers of $t$.  Coordinates do not mix, so one suffices; that the kernel keeps several apart is checked
  on two.
:degrees: 1..4 sampled 12
:defines: rational_derivatives rational_quotient_derivatives
:control: the term of the first derivative of the denominator taken once where it counts twice, in $R''$
:::
*/
/* c[k], the coefficient of t^k in sum B_i^n(t) b_i, each B_i^n expanded by the binomial theorem. */
static void G(power_coefficients)(int n, const num b[], num c[])
{
    for (int k = 0; k <= n; k++)
        c[k] = from_int(0);
    for (int i = 0; i <= n; i++) {
        long choose = 1; /* n!/(i! (n-i)!), then times (n-i)!/(j! (n-i-j)!) */
        for (int j = 1; j <= i; j++)
            choose = choose * (n - j + 1) / j;
        for (int j = 0; j <= n - i; j++) {
            c[i + j] = add(c[i + j], mul(from_int(j % 2 == 0 ? choose : -choose), b[i]));
            choose = choose * (n - i - j) / (j + 1);
        }
    }
}

/* The derivatives 0 ... 3 at t of N/D, polynomials of degree n <= MAX_DEGREE/4, by the quotient rule
 * (N/D^m)' = (N' D - m N D')/D^{m+1} on their coefficients. */
static void G(quotient_rule)(int n, const num N[], const num D[], num t, num out[])
{
    num A[MAX_DEGREE + 1], B[MAX_DEGREE + 1], below = from_int(0);
    int degree = n;
    for (int k = 0; k <= n; k++)
        A[k] = N[k];
    for (int k = n; k >= 0; k--)
        below = add(mul(below, t), D[k]);
    num power = below;
    for (int m = 1; m <= 4; m++) {
        num above = from_int(0);
        for (int k = degree; k >= 0; k--)
            above = add(mul(above, t), A[k]);
        out[m - 1] = div(above, power);
        if (m == 4)
            break;
        power = mul(power, below);
        for (int k = 0; k <= degree + n; k++)
            B[k] = from_int(0);
        for (int k = 0; k <= degree; k++)
            for (int j = 0; j <= n; j++) /* t^k t^j gives (k - m j) t^{k+j-1} */
                if (k + j > 0)
                    B[k + j - 1] = add(B[k + j - 1], mul(from_int(k - m * j), mul(A[k], D[j])));
        degree += n;
        for (int k = 0; k <= degree; k++)
            A[k] = B[k];
    }
}
#endif

CLAIM(rational_derivatives_are_formal_derivatives)
{
    enum { r = 3 };
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], D[r + 1], wanted[r + 1], t = parameter(T, "t");
    G(free_weights)(T, n, w);
    G(free_points)(T, n, 1, R);
    G(rational_derivatives)(n, 1, R, w, t, r, D);
#if FIELD
    num P;
    G(numerator_by_definition)(n, 1, R, w, t, &P);
    wanted[0] = div(P, G(weight_by_definition)(n, w, t));
    for (int k = 1; k <= r; k++)
        wanted[k] = derivative_f(wanted[k - 1], t);
    num slope = div(derivative_f(G(weight_by_definition)(n, w, t), t), G(weight_by_definition)(n, w, t));
#else
    num b[MAX_DEGREE + 1], N[MAX_DEGREE + 1], W[MAX_DEGREE + 1], derivative = from_int(0);
    for (int i = 0; i <= n; i++)
        b[i] = mul(w[i], R[i]);
    G(power_coefficients)(n, b, N);
    G(power_coefficients)(n, w, W);
    G(quotient_rule)(n, N, W, t, wanted);
    for (int k = n; k > 0; k--)
        derivative = add(mul(derivative, t), mul(from_int(k), W[k]));
    num slope = div(derivative, G(weight_by_definition)(n, w, t));
#endif
    D[2] = fault(T, D[2], add(D[2], mul(slope, D[1])));
    for (int k = 0; k <= r; k++)
        same(T, D[k], wanted[k]);

    num Q[(MAX_DEGREE + 1) * 2], E[(r + 1) * 2], x[MAX_DEGREE + 1], y[MAX_DEGREE + 1], Dx[r + 1], Dy[r + 1];
    for (int i = 0; i <= n; i++) {
        x[i] = Q[2 * i] = R[i];
        y[i] = Q[2 * i + 1] = from_int(pick(T, -9, 9));
    }
    G(rational_derivatives)(n, 2, Q, w, t, r, E);
    G(rational_derivatives)(n, 1, x, w, t, r, Dx);
    G(rational_derivatives)(n, 1, y, w, t, r, Dy);
    for (int k = 0; k <= r; k++) {
        same(T, E[2 * k], Dx[k]);
        same(T, E[2 * k + 1], Dy[k]);
    }
}

/*
## Positive weights

A quotient asks for a denominator that is not 0.  A sum of positive numbers is positive, so positive weights suffice; the
sentence says no more than this.  It is often remembered the other way round, and the last claim before the next heading
is for those who do.

:::{statement} wang-ch3:3.2-positive-weights
:title: What positive weights are for
:zh: 规定权为正的用意
:printed: To guarantee the convex hull property and to avoid $\omega(t)=0$ one usually prescribes $\omega_i>0$.
:holds-by: positive_terms_make_a_convex_mean mean_grows_by_one_term
:confirmed-by: positive_weights_keep_denominator_positive curve_points_are_convex_combinations
:needs: weights_of_both_signs_make_a_pole | the sentence itself: one usually prescribes $\omega_i>0$ | the weights are
  positive: for $\omega(t)\ne0$.
:needs: curve_leaves_hull_with_negative_weight | the sentence itself: one usually prescribes $\omega_i>0$ | the
  weights are positive: for the convex hull property.
:meant: the words: to guarantee, one usually prescribes | Positive weights suffice; that they are necessary is not said.
:reading: denominator_may_be_positive_with_negative_weight | Read as "only positive weights avoid $\omega(t)=0$".  The
  sentence does not say so: it says that they suffice.
:figure: weights_and_poles
:::

:::{claim} positive_weights_keep_denominator_positive
:title: With positive weights the denominator is positive on [0,1]
:zh: 权为正时分母在 [0,1] 上恒正
:given: $\omega_0,\dots,\omega_n>0$; $t=0$, $t=1$, and every $t$ between, written $t=s/(1+s)$, $s>0$
:then: $\omega(t)>0$
:method: As a quotient of polynomials in $s$ and the weights, $1/\omega(t)$ has positive coefficients only; it is
  therefore positive where all variables are, and so is $\omega(t)$.
:degrees: 1..8 sampled 16
:scope: 0 ≤ t ≤ 1
:over: s: -
:control: the sum taken with the opposite sign
:::
*/
CLAIM(positive_weights_keep_denominator_positive)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], at[] = {from_int(0), from_int(1), inside(T, "s")};
    G(positive_weights)(T, n, w);
    for (int k = 0; k < 3; k++) {
        num total = G(rational_weight)(n, w, at[k]);
        nonnegative(T, div(from_int(1), fault(T, total, neg(total))));
    }
}

#if RATIONAL
/*
:::{claim} weights_of_both_signs_make_a_pole
:title: With weights 1 and −1 the curve has no point at t = 1/2
:zh: 权为 1 与 −1 时 t = 1/2 处无点
:kind: counterexample
:data: ω = 1 -1; t = 1/2
:instead: ω = 1 1
:result: ω(t) = 0
:given: the weights of a line segment, $n=1$, and the parameter in the middle
:then: $\omega(t)$ vanishes there, so that the curve has no point
:method: The denominator is evaluated exactly.
:control: equal weights, for which it does not vanish
:::
*/
CLAIM(weights_of_both_signs_make_a_pole)
{
    num w[2];
    given_points(T, "ω", 2, 1, w);
    num total = G(rational_weight)(1, w, given(T, "t"));
    found(T, "ω(t)", total);
    about(T, "ω(t) is not 0");
    refute(T, is_zero_q(total));
}

/*
:::{claim} denominator_may_be_positive_with_negative_weight
:title: The weights 1, −1/2, 1 have a denominator without zeros
:zh: 权 1, −1/2, 1 的分母无零点
:kind: counterexample
:data: ω = 1 -1/2 1
:instead: ω = 1 -1 1
:result: ω(t) = "3*t^2 - 3*t + 1"; zeros in [0,1] = 0
:given: the weights of a curve of degree two, of which the middle one is negative
:then: "a negative weight gives $\omega(t)$ a zero in $[0,1]$" is false
:method: Descartes' rule in the Bernstein basis finds no root in $[0,1]$, and Sturm's chain none in $(-1,1]$.
:control: a middle weight for which $\omega(t)=(1-2t)^2$ has one
:::
*/
CLAIM(denominator_may_be_positive_with_negative_weight)
{
    num w[3];
    given_points(T, "ω", 3, 1, w);
    poly p = poly_from_bernstein(2, w);
    int roots = count_roots(p, from_int(0), from_int(1), CLOSED).distinct;
    found_text(T, "ω(t)", poly_to_string(p, "t"));
    found_whole(T, "zeros in [0,1]", roots);
    about(T, "the number of zeros is not 0");
    refute(T, roots == 0 && sturm_count(p, from_int(-1), from_int(1)) == 0);
}
#endif

/*
## What a growing weight does

:::{statement} wang-ch3:3.2-growing-weight
:title: A growing weight draws the curve to its point
:zh: 权增大时曲线趋近相应顶点
:printed: Experiments show that the curve approaches the point $\mathbf R_i$ when $\omega_i$ grows, which can be used to
  adjust its shape.
:holds-by: more_weight_moves_a_mean_to_its_point positive_terms_make_a_convex_mean
:confirmed-by: growing_weight_pulls_each_point_straight_to_the_vertex infinite_weight_reaches_the_vertex
:needs: growing_negative_weight_pushes_away | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive.
:meant: property 3.2.3, which keeps the ends of the curve in the end points | No point of the curve moves away from
  $R_i$, and those that move come nearer.
:reading: ends_do_not_move_with_inner_weight | Read as "every point of the curve moves".  An end point does not, here with
  an inner weight: nearer is to be read as "not farther, and nearer for $0<t<1$ unless it is there already".
:figure: growing_weight

Every point $R(t)$, $0<t<1$, that is not $R_i$ already moves on the straight line to $R_i$, all the way as $\omega_i\to\infty$.
:::

The source appeals to experiments.  The reason is one line: when $\omega_i$ grows by $\delta$, the point $R_i$ is added to
the mean once more, with the weight $\delta B_i^n(t)$.  The new point is therefore on the segment from the old one to $R_i$,
for each $t$ by itself.  Where the denominator is negative, before and after, the same addition takes the point away.

:::{claim} growing_weight_pulls_each_point_straight_to_the_vertex
:title: When ω_i grows, R(t) moves straight towards R_i
:zh: ω_i 增大时 R(t) 沿直线移向 R_i
:given: points, positive weights, $0<t<1$ written $t=s/(1+s)$; one weight $\omega_i$ replaced by $\omega_i+\delta$,
  $\delta>0$; every $i=0,\dots,n$
:let: $q=\omega(t)/(\omega(t)+\delta B_i^n(t))$, $\tilde R$ the new curve
:then: $\tilde R(t)-R_i=q\,(R(t)-R_i)$ with $0<q<1$
:method: The equality is one of field elements; $1/q$ and $1/(1-q)$ have positive coefficients only, so both are positive
  for all positive values of $s$, $\delta$ and the weights.  A coordinate is any coordinate.
:degrees: 1..6 sampled 12
:scope: 0 < t < 1
:over: d: δ; s: -
:control: the weight of the next point grows instead
:::
*/
CLAIM(growing_weight_pulls_each_point_straight_to_the_vertex)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], v[MAX_DEGREE + 1], R[MAX_DEGREE + 1], before, after;
    num t = inside(T, "s"), more = positive(T, "d", 0);
    G(positive_weights)(T, n, w);
    G(free_points)(T, n, 1, R);
    G(rational_point)(n, 1, R, w, t, &before);
    num total = G(weight_by_definition)(n, w, t);
    for (int i = 0; i <= n; i++) {
        for (int j = 0; j <= n; j++)
            v[j] = j == fault(T, i, i + 1) % (n + 1) ? add(w[j], more) : w[j];
        num share = mul(more, G(bernstein_by_definition)(n, i, t)), q = div(total, add(total, share));
        G(rational_point)(n, 1, R, v, t, &after);
        /* R̃(t) - R_i = q (R(t) - R_i) */
        same(T, sub(after, R[i]), mul(q, sub(before, R[i])));
        nonnegative(T, div(from_int(1), q));
        nonnegative(T, div(from_int(1), sub(from_int(1), q)));
    }
}

/*
:::{claim} two_middle_weights_give_two_arcs
:title: Over the corners (1,0), (0,0), (0,1) two different middle weights give two different sets of points
:zh: 顶点 (1,0)、(0,0)、(0,1) 不动, 中间权不同则曲线不同
:given: the points $(1,0)$, $(0,0)$, $(0,1)$ with the weights $1,\omega,1$ and with $1,\omega^*,1$; $\omega,\omega^*>0$
:where: $\omega\ne\omega^*$; the weights are positive
:then: each curve has one point on the line $x=y$, that of $t=\frac12$, and there $x-x^*=\frac{\omega^*-\omega}{2(1+\omega)(1+\omega^*)}$
:method: $\omega(t)(x-y)=1-2t$ at a variable $t$, and the two points; identities.
:scope: n = 2, the points (1,0), (0,0), (0,1) with the weights 1, ω, 1
:over: w#: ω
:control: $1-t$ for $1-2t$
:::
*/
CLAIM(two_middle_weights_give_two_arcs)
{
    num zero = from_int(0), one = from_int(1), half = from_ratio(1, 2), t = parameter(T, "t"), point[2], at_half[2][2];
    num R[6] = {one, zero, zero, zero, zero, one}, middle[2] = {positive(T, "w", 0), positive(T, "w", 1)};
    for (int k = 0; k < 2; k++) {
        num w[3] = {one, middle[k], one}, omega = G(weight_by_definition)(2, w, t);
        G(rational_point)(2, 2, R, w, t, point);
        about(T, "the one point on x = y");
        same(T, mul(omega, sub(point[0], point[1])), sub(one, mul(fault(T, from_int(2), one), t)));
        G(rational_point)(2, 2, R, w, half, at_half[k]);
    }
    about(T, "the two points at 1/2");
    same(T, sub(at_half[0][0], at_half[1][0]),
         div(sub(middle[1], middle[0]), mul(from_int(2), mul(add(one, middle[0]), add(one, middle[1])))));
}

/*
:::{claim} infinite_weight_reaches_the_vertex
:title: In the limit of an infinite weight the curve is at R_i
:zh: 权趋于无穷时曲线趋于 R_i
:given: points $R_j$, weights $\omega_j$, a parameter $0<t<1$; one weight $\omega_i$ replaced by $\omega_i+1/\varepsilon$; every $i=0,\dots,n$
:then: the curve is that of the weights $\varepsilon\omega_j$ ($j\ne i$) and $\varepsilon\omega_i+1$, and for
  $\varepsilon=0$ it is at $R_i$
:method: The first is an equality in the field; the second is computed at $\varepsilon=0$, where the denominator is
  $B_i^n(t)>0$, so that the quotient is continuous there and its value is the limit for $\omega_i\to\infty$.
:degrees: 1..6 sampled 12
:scope: 0 < t < 1
:over: e: ε; s: -
:control: the limit taken at the next point
:::
*/
CLAIM(infinite_weight_reaches_the_vertex)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], grown[MAX_DEGREE + 1], scaled[MAX_DEGREE + 1], limit[MAX_DEGREE + 1], R[MAX_DEGREE + 1];
    num t = inside(T, "s"), e = positive(T, "e", 0), a, b;
    G(free_weights)(T, n, w);
    G(free_points)(T, n, 1, R);
    for (int i = 0; i <= n; i++) {
        for (int j = 0; j <= n; j++) {
            grown[j] = j == i ? add(w[j], div(from_int(1), e)) : w[j];
            scaled[j] = j == i ? add(mul(e, w[j]), from_int(1)) : mul(e, w[j]);
            limit[j] = from_int(j == i);
        }
        G(rational_point)(n, 1, R, grown, t, &a);
        G(rational_point)(n, 1, R, scaled, t, &b);
        same(T, a, b);
        G(rational_point)(n, 1, R, limit, t, &a);
        same(T, a, R[fault(T, i, i + 1) % (n + 1)]);
    }
}

#if RATIONAL
/* The squared distances of a point R(t) on the line from R_1 before and after a weight has grown. */
struct G(growth) {
    num squared_before, squared_after;
};

/* Those of the data of the claim: R, ω, grown ω and t; n is the degree.  The two points are results. */
static struct G(growth) G(given_growth)(trial *T, int n)
{
    num R[3], w[3], v[3], before, after;
    given_points(T, "R", n + 1, 1, R);
    given_points(T, "ω", n + 1, 1, w);
    given_points(T, "ω, grown", n + 1, 1, v);
    num t = given(T, "t");
    G(rational_point)(n, 1, R, w, t, &before);
    G(rational_point)(n, 1, R, v, t, &after);
    found(T, "R(t)", before);
    found(T, "R(t), grown", after);
    num from = sub(before, R[1]), to = sub(after, R[1]);
    return (struct G(growth)){mul(from, from), mul(to, to)};
}
/*
:::{claim} growing_negative_weight_pushes_away
:title: Where the denominator is negative, a growing weight can push the curve away
:zh: 分母为负处权增大使曲线远离顶点
:kind: counterexample
:data: R = 0 1; ω = -1 -1; ω, grown = -1 -1/2; t = 1/2
:instead: ω = 1 1; ω, grown = 1 3/2
:result: R(t) = 1/2; R(t), grown = 1/3
:given: two points of the line, negative weights, the same with $\omega_1$ grown, and the parameter in the middle
:then: $R(t)$ moves away from $R_1$
:method: Both points are computed exactly.
:control: the same growth of a positive weight, with $\omega_0$ positive
:::
*/
CLAIM(growing_negative_weight_pushes_away)
{
    struct G(growth) g = G(given_growth)(T, 1);
    about(T, "the point is not farther from R_1 than before");
    agree(T, compare_q(g.squared_after, g.squared_before) <= 0);
}

/*
:::{claim} ends_do_not_move_with_inner_weight
:title: The end points stay where they are when an inner weight grows
:zh: 内部权增大时端点不动
:kind: counterexample
:data: R = 0 1 3; ω = 1 1 1; ω, grown = 1 2 1; t = 0
:instead: t = 1/3
:result: R(t) = 0; R(t), grown = 0
:given: three points of the line, equal weights, the same with $\omega_1$ grown, and the first parameter
:then: $R(t)$ is the same before and after: this point does not come nearer to $R_1$
:method: Both points are computed exactly.
:control: a parameter inside, whose point does
:::
*/
CLAIM(ends_do_not_move_with_inner_weight)
{
    struct G(growth) g = G(given_growth)(T, 2);
    about(T, "the point is nearer to R_1 than before");
    agree(T, compare_q(g.squared_after, g.squared_before) < 0);
}
#endif

/*
## Like a Bézier curve

:::{statement} wang-ch3:3.2-like-bezier
:title: Rational Bézier curves have properties like those of Bézier curves
:zh: 有理 Bézier 曲线具有类似 Bézier 曲线的性质
:printed: The rational Bézier curves $\mathbf R(t)$ have geometric properties similar to those of Bézier curves.
:holds-by: mean_grows_by_one_term change_of_parameter_acts_on_one_factor positive_terms_make_a_convex_mean
  first_power_decides_the_end_derivative end_direction_has_a_positive_factor bernstein_function_in_the_next_degree
  elevation_cuts_corners bernstein_sum_of_powers_is_a_power
:argued: | That two kinds of curves are similar is a judgement.  It rests here on the properties that both have: invariance, symmetry, the ends, the
  convex hull, elevation, each as in the list that follows.
:meant: the list of properties that follows | The properties 3.2.1 to 3.2.10, as far as they are true; decided here of 3.2.1 to 3.2.3, 3.2.5 and 3.2.6.
:needs: curve_leaves_hull_with_negative_weight | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive: for the convex hull.
:confirmed-by: equal_weights_give_bezier_curve affine_image_of_the_curve_is_the_curve_of_the_images
  reversed_points_and_weights_reverse_the_curve curve_leaves_its_ends_along_the_first_edges
  curve_points_are_convex_combinations elevation_keeps_rational_curve
:::

:::{claim} equal_weights_give_bezier_curve
:title: With equal weights the curve is the Bézier curve of the points
:zh: 权相等时即为 Bézier 曲线
:given: points, and weights all equal to $v\ne0$
:where: the common weight is not 0
:then: $R(t)=\sum_iB_i^n(t)R_i$
:method: Both sides are one element of the field; the right one is written out from the definition.
:degrees: 1..8 sampled 16
:over: v#: weights
:control: the last weight doubled
:::
*/
CLAIM(equal_weights_give_bezier_curve)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], ones[MAX_DEGREE + 1], R[MAX_DEGREE + 1], point, wanted;
    num t = parameter(T, "t"), v = positive(T, "v", 0);
    G(free_points)(T, n, 1, R);
    for (int i = 0; i <= n; i++) {
        w[i] = fault(T, v, i == n ? add(v, v) : v);
        ones[i] = from_int(1);
    }
    G(rational_point)(n, 1, R, w, t, &point);
    G(numerator_by_definition)(n, 1, R, ones, t, &wanted);
    same(T, point, wanted);
}

/*
## Invariance and symmetry

Both properties are read off the formula, if one asks first what a control point is.  In the definition it carries its
weight.  To map a polygon means to map the points $R_i$ and to leave the weights; to reverse it means to reverse points and
weights together.  Other readings are tried, and they fail already for a segment with two different weights.

:::{statement} wang-ch3:prop-3.2.1
:title: An affine map of the points maps the curve
:zh: 几何不变性与仿射不变性
:printed: Geometric invariance and affine invariance.
:holds-by: mean_grows_by_one_term
:confirmed-by: affine_image_of_the_curve_is_the_curve_of_the_images
:needs: weights_of_both_signs_make_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  $\omega(t)\ne0$; for which positive weights suffice: otherwise there may be no point.
:meant: (3.2.2), the curve of the properties, whose points are the $R_i$ | The curve does not depend on the coordinate system,
  and an affine map of the points $R_i$, their weights kept, maps the curve.
:reading: translated_homogeneous_points_give_no_translate | Read for the homogeneous control points $\tilde{\mathbf R}_i$
  of definition 3.2.1, to whose first three coordinates the map is applied: a translation need not
  translate the curve, when the weights are not all $1$.
:figure: affine_image

No sign of the weights is needed, only $\omega(t)\ne0$.
Geometric invariance is the case of a change of rectangular coordinates.
:::

:::{claim} affine_image_of_the_curve_is_the_curve_of_the_images
:title: An affine map of the points maps the curve
:zh: 对控制点作仿射变换等于对曲线作仿射变换
:given: points of space, weights, a parameter $t$; $f(x,y,z)=ax+by+cz+d$ with any $a,b,c,d$
:then: the curve of the values $f(R_i)$ with the same weights is $f(R(t))$
:method: Both sides are one element of the field of rational functions of everything given.  An affine map of space, of
  any rank and into any space, is a list of such $f$, one for each coordinate of the image.
:degrees: 1..6 sampled 12
:over: a# d#: affine maps
:control: $d$ added to the homogeneous points $\omega_iR_i$ without its factor $\omega_i$
:::
*/
CLAIM(affine_image_of_the_curve_is_the_curve_of_the_images)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[(MAX_DEGREE + 1) * 3], image[MAX_DEGREE + 1], P[3], wanted;
    num t = parameter(T, "t"), d = unknown(T, "d", 0), a[3];
    G(free_weights)(T, n, w);
    G(free_points)(T, n, 3, R);
    for (int c = 0; c < 3; c++)
        a[c] = unknown(T, "a", c);
    for (int i = 0; i <= n; i++) {
        image[i] = fault(T, d, div(d, w[i]));
        for (int c = 0; c < 3; c++)
            image[i] = add(image[i], mul(a[c], R[3 * i + c]));
    }
    G(rational_point)(n, 3, R, w, t, P);
    G(rational_point)(n, 1, image, w, t, &wanted);
    /* a x(t) + b y(t) + c z(t) + d */
    same(T, add(add(add(mul(a[0], P[0]), mul(a[1], P[1])), mul(a[2], P[2])), d), wanted);
}

#if RATIONAL
/*
:::{claim} translated_homogeneous_points_give_no_translate
:title: Translating the homogeneous points need not translate the curve
:zh: 平移齐次控制点并不平移曲线
:kind: counterexample
:data: R = 0 1; ω = 1 2; d = 1
:instead: ω = 1 1
:result: (X, ω) = (0,1) (2,2); (X+d, ω) = (1,1) (3,2); R(1) = 1; R(1), moved = 3/2
:given: two points of the line, weights that are not both 1, and a number $d$, which is added to the first coordinates of
  the homogeneous points $(X_i,\omega_i)$
:then: the end of the curve does not move by $d$
:method: Both curves are computed exactly at the last parameter.
:control: both weights 1
:::
*/
CLAIM(translated_homogeneous_points_give_no_translate)
{
    num R[2], w[2], H[4], moved[2], v[2], a, b;
    given_points(T, "R", 2, 1, R);
    given_points(T, "ω", 2, 1, w);
    num d = given(T, "d");
    G(rational_homogenize)(1, 1, R, w, H);
    found_points(T, "(X, ω)", 2, 2, H);
    for (int i = 0; i < 2; i++)
        H[2 * i] = add(H[2 * i], d);
    found_points(T, "(X+d, ω)", 2, 2, H);
    G(rational_dehomogenize)(1, 1, H, moved, v);
    G(rational_point)(1, 1, R, w, from_int(1), &a);
    G(rational_point)(1, 1, moved, v, from_int(1), &b);
    found(T, "R(1)", a);
    found(T, "R(1), moved", b);
    about(T, "the end of the moved curve, left as it is, right as translated");
    same(T, b, add(a, d));
}
#endif

/*
:::{statement} wang-ch3:prop-3.2.2
:title: Symmetry in t and 1−t
:zh: 关于 t 与 1−t 的对称性
:printed: Symmetry in the parameters $t$ and $(1-t)$.
:holds-by: change_of_parameter_acts_on_one_factor bernstein_sum_of_powers_is_a_power
:confirmed-by: reversed_points_and_weights_reverse_the_curve
:meant: (3.2.2), which has a weight with every point | The control points are taken backwards with their weights; they give $R(1-t)$.
:needs: weights_of_both_signs_make_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  $\omega(t)\ne0$; for which positive weights suffice on $[0,1]$: otherwise there may be no point.
:reading: reversed_points_alone_do_not_reverse_the_curve | Read for the points $R_i$ alone, the weights keeping their places.
:figure: reversed_polygon

No sign of the weights is needed: the two curves have one denominator, at $t$ and at $1-t$.
The coefficients of which the verdict speaks are the $\omega_i$ of the denominator and the $\omega_i\mathbf R_i$ of the numerator.
:::

:::{claim} reversed_points_and_weights_reverse_the_curve
:title: Points and weights in reversed order give R(1−t)
:zh: 点与权同时倒序得 R(1−t)
:given: points and weights, a parameter $t$
:then: $R_n,\dots,R_0$ with $\omega_n,\dots,\omega_0$ has at $t$ the point that $R_0,\dots,R_n$ with
  $\omega_0,\dots,\omega_n$ has at $1-t$
:method: Both are one element of the field of rational functions of $t$, the weights and the points.
:degrees: 1..8 sampled 16
:control: the weights left in their order
:::
*/
CLAIM(reversed_points_and_weights_reverse_the_curve)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], v[MAX_DEGREE + 1], R[MAX_DEGREE + 1], Q[MAX_DEGREE + 1], a, b, t = parameter(T, "t");
    G(free_weights)(T, n, w);
    G(free_points)(T, n, 1, R);
    for (int i = 0; i <= n; i++) {
        Q[i] = R[n - i];
        v[i] = fault(T, w[n - i], w[i]);
    }
    G(rational_point)(n, 1, Q, v, t, &a);
    G(rational_point)(n, 1, R, w, sub(from_int(1), t), &b);
    same(T, a, b);
}

#if RATIONAL
/*
:::{claim} reversed_points_alone_do_not_reverse_the_curve
:title: The points alone in reversed order can give another parametrisation
:zh: 仅将点倒序得不到 R(1−t)
:kind: counterexample
:data: R = 0 1; ω = 1 2; t = 1/2
:result: value for the reversed points = 1/3; R(1-t) = 2/3
:given: two points of the line, weights that are not equal, and the parameter in the middle
:then: the points in reversed order with the weights in their places have at $t$ another value than $R(1-t)$
:method: Both are computed exactly.
:control: the weights reversed as well
:::
*/
CLAIM(reversed_points_alone_do_not_reverse_the_curve)
{
    num R[2], w[2], Q[2], v[2], a, b;
    given_points(T, "R", 2, 1, R);
    given_points(T, "ω", 2, 1, w);
    num t = given(T, "t");
    G(reversed_points)(1, 1, R, Q);
    G(reversed_points)(1, 1, w, v);
    G(rational_point)(1, 1, Q, fault(T, v, w), t, &a);
    G(rational_point)(1, 1, R, w, sub(from_int(1), t), &b);
    found(T, "value for the reversed points", a);
    found(T, "R(1-t)", b);
    about(T, "left the reversed points at t, right R(1 - t)");
    same(T, a, b);
}
#endif

#include "chapters/judge/claims_off.h"
