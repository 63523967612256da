/*
# Curvature and torsion at the ends (端点曲率与挠率)

At $t=0$ the derivatives of order $1$, $2$, $3$ are combinations of the first edges $a_1$, $a_2$, $a_3$ of the
polygon.  Curvature and torsion see only the newest edge in each of them, so the complicated coefficients drop out,
and what is left are two short formulas.  The formulas are right.  Their proof, of whose three lines on quotients two
are printed wrongly, has the next section to itself.

We write $a_i=R_i-R_{i-1}$, and start with what curvature and torsion are.  The source writes $k$ for $\kappa$ from
this section on; here $k$ stays a number of points.
*/
#include "exact/record/roots.h"

#include "chapters/judge/elementary.h"
#include "chapters/rational-bezier/free-curve.h"
#include "chapters/rational-bezier/taylor.h"

#include "chapters/judge/claims_on.h"

/*
## Curvature and torsion

Both belong to the curve and not to its parameter: with the arc length $s$, $\kappa=|R_{ss}|$, and $\tau$ says how
fast the plane of $R_s$ and $R_{ss}$ turns.  The kernels have the usual formulas in $R'$, $R''$, $R'''$.  They are
compared with the definitions, which need no root because $\frac{d}{ds}=\frac1{\sqrt g}\frac{d}{dt}$, $g=|R'|^2$,
gives $R_{ss}=\frac{R''}g-\frac{(R'\cdot R'')R'}{g^2}$.

A function is here its Taylor polynomial of order 3 in $\varepsilon$ at $t$, four coefficients.
*/

/* |R_ss|^2 and, in space, -(R_s x R_ss)_s . R_ss / |R_ss|^2 = -N . B_s, at epsilon = 0. */
static inline void G(by_arc_length)(int dim, const G(series) R[], num *curvature_squared, num *torsion)
{
    G(series) v[3], N[3];
    for (int c = 0; c < dim; c++) {
        v[c] = G(series_derivative)(R[c]);
        N[c] = G(series_derivative)(v[c]);
    }
    G(series) g = G(series_dot)(dim, v, v), h = G(series_dot)(dim, v, N);
    G(series) minus = {{from_int(-1), from_int(0), from_int(0), from_int(0)}};
    for (int c = 0; c < dim; c++) {
        G(series) along = G(series_div)(G(series_mul)(h, v[c]), G(series_mul)(g, g));
        N[c] = G(series_add)(G(series_div)(N[c], g), G(series_mul)(minus, along));
    }
    *curvature_squared = G(series_dot)(dim, N, N).c[0];
    if (dim != 3)
        return;
    num turning = from_int(0);
    for (int c = 0; c < 3; c++) { /* the derivative of (v x N)_c, times N_c */
        int i = (c + 1) % 3, j = (c + 2) % 3;
        num slope = sub(G(series_mul)(v[i], N[j]).c[1], G(series_mul)(v[j], N[i]).c[1]);
        turning = sub(turning, mul(slope, N[c].c[0]));
    }
    *torsion = div(turning, mul(g.c[0], *curvature_squared));
}

/*
:::{claim} curvature_belongs_to_arc_length
:title: The formula in R' and R'' is the curvature of the arc length
:zh: 曲率公式与弧长定义一致
:given: derivatives $R'\ne0$ and $R''$ of a curve, in the plane and in space
:where: the first derivative is not 0
:then: $\frac{|R'|^2|R''|^2-(R'\cdot R'')^2}{|R'|^6}=|R_{ss}|^2$
:method: The definition is expanded at the point as Taylor polynomials; both sides are one element of the field of rational functions of the
  coordinates of $R',R''$, and of $R'''$, which drops out.
:defines: curvature_squared
:over: u# v# w#: derivatives
:control: $R'''$ for $R''$
:::
*/
/* Derivatives of a curve with dim coordinates, all of them variables, and what the definitions by arc length give for them. */
static inline void G(free_derivatives)(trial *T, int dim, num d[3][3], num *curvature_squared, num *torsion)
{
    G(series) R[3];
    for (int c = 0; c < dim; c++) {
        static const char *const name[] = {"u", "v", "w"};
        for (int k = 0; k < 3; k++)
            d[k][c] = unknown(T, name[k], c);
        R[c] = (G(series)){{from_int(0), d[0][c], div(d[1][c], from_int(2)), div(d[2][c], from_int(6))}};
    }
    G(by_arc_length)(dim, R, curvature_squared, torsion);
}

CLAIM(curvature_belongs_to_arc_length)
{
    for (int dim = 2; dim <= 3; dim++) {
        num d[3][3], curvature_squared, torsion;
        G(free_derivatives)(T, dim, d, &curvature_squared, &torsion);
        same(T, G(curvature_squared)(dim, d[0], d[fault(T, 1, 2)]), curvature_squared);
    }
}

/*
:::{claim} torsion_belongs_to_arc_length
:title: The formula in R', R'', R''' is the torsion of the arc length
:zh: 挠率公式与弧长定义一致
:given: derivatives $R',R'',R'''$ of a curve in space, $R'\times R''\ne0$
:where: the first two derivatives are not parallel
:harmless: $R'\times R''\ne0$ | that the first two derivatives are not parallel is said by the scope
:then: $\frac{(R',R'',R''')}{|R'\times R''|^2}=-N\cdot B_s$, where $N=R_{ss}/\kappa$, $B=R_s\times N$
:method: The definitions are expanded at the point as Taylor polynomials; both sides are one element of the field of rational functions of the
  coordinates of $R',R'',R'''$.  Differentiating $\kappa B=R_s\times R_{ss}$ gives $-N\cdot B_s=-(R_s\times R_{ss})_s\cdot R_{ss}/\kappa^2$.
:defines: torsion
:over: u# v# w#: derivatives
:control: the two last derivatives exchanged
:::
*/
CLAIM(torsion_belongs_to_arc_length)
{
    num d[3][3], curvature_squared, torsion;
    G(free_derivatives)(T, 3, d, &curvature_squared, &torsion);
    int second = fault(T, 1, 2);
    same(T, G(torsion)(d[0], d[second], d[3 - second]), torsion);
}

/*
Three kinds of products occur in these formulas.  In the plane $a\times b$ is a number, in space a vector; either way
its size is the area of the parallelogram of $a$ and $b$, which Gram's determinant gives from scalar products alone,
and so in any dimension.

:::{claim} vector_products_are_determinants
:title: Scalar, cross and mixed products and Gram's determinant
:zh: 数量积、向量积、混合积与 Gram 行列式
:given: vectors $a,b,c$ of one to four coordinates, of the plane, of space
:then: $a\cdot b=\sum a_ib_i$; the cross product of the plane is $\det(a,b)$; $a\times b$ has the coordinates $\det(a,b,e_i)$; the mixed product is
  $\det(a,b,c)$; Gram's determinant is $|a|^2|b|^2-(a\cdot b)^2$, in space $|a\times b|^2$
:method: Determinants are written out as sums over permutations; equality in the field of the coordinates.
:defines: dot norm_squared cross2 cross3 det3 gram
:over: a# b# c#: vectors
:control: one sign of the sum over permutations of three
:::
*/
/* The sum over the permutations of 0, 1, 2. */
static inline num G(determinant_by_permutations)(const num a[], const num b[], const num c[], int last_is_even)
{
    static const int p[6][4] = {{0, 1, 2, 1}, {1, 2, 0, 1}, {2, 0, 1, 1}, {0, 2, 1, -1}, {2, 1, 0, -1}, {1, 0, 2, -1}};
    num sum = from_int(0);
    for (int k = 0; k < 6; k++) {
        int sign = k == 5 && last_is_even ? 1 : p[k][3];
        sum = add(sum, mul(from_int(sign), mul(mul(a[p[k][0]], b[p[k][1]]), c[p[k][2]])));
    }
    return sum;
}

CLAIM(vector_products_are_determinants)
{
    num a[4], b[4], c[3], x[3], gram[4];
    for (int i = 0; i < 4; i++) {
        a[i] = unknown(T, "a", i);
        b[i] = unknown(T, "b", i);
    }
    num aa = from_int(0), ab = from_int(0), bb = from_int(0);
    for (int dim = 1; dim <= 4; dim++) {
        aa = add(aa, mul(a[dim - 1], a[dim - 1]));
        ab = add(ab, mul(a[dim - 1], b[dim - 1]));
        bb = add(bb, mul(b[dim - 1], b[dim - 1]));
        same(T, G(dot)(dim, a, b), ab);
        same(T, G(norm_squared)(dim, a), aa);
        gram[dim - 1] = sub(mul(aa, bb), mul(ab, ab));
        same(T, G(gram)(dim, a, b), gram[dim - 1]);
    }
    num zero = from_int(0), e2[] = {zero, zero, from_int(1)}, a2[] = {a[0], a[1], zero}, b2[] = {b[0], b[1], zero};
    same(T, G(cross2)(a, b), G(determinant_by_permutations)(a2, b2, e2, 0));
    G(cross3)(a, b, x);
    num xx = from_int(0);
    for (int i = 0; i < 3; i++) {
        num e[] = {from_int(i == 0), from_int(i == 1), from_int(i == 2)};
        same(T, x[i], G(determinant_by_permutations)(a, b, e, fault(T, 0, 1)));
        xx = add(xx, mul(x[i], x[i]));
        c[i] = unknown(T, "c", i);
    }
    same(T, xx, gram[2]);
    same(T, G(det3)(a, b, c), G(determinant_by_permutations)(a, b, c, fault(T, 0, 1)));
}

/*
In the plane the curvature can be given a sign, positive where the curve turns to the left.  The source means the
absolute value, as the norms in (3.2.5) show.

:::{claim} signed_curvature_is_the_turning_of_the_tangent
:title: The signed curvature of a plane curve is the turning of its tangent by arc length
:zh: 平面曲线的带号曲率是切线转角对弧长的导数
:given: $R'=(p^2-q^2,2pq)$, whose length $p^2+q^2$ is rational, and any $R''$
:let: $m=y'/x'$ the slope, so that the direction $\theta=\arctan m$ has $\theta'=m'/(1+m^2)$
:then: the signed curvature times $|R'|$ is $\theta'$; the curvature is its absolute value
:method: Equality in the field, the curvature compared by its square; in the other arithmetics it is also not negative.
:defines: signed_curvature curvature
:over: p# q# x# y#: derivatives
:control: the factor $1/(1+m^2)$ left out
:::
*/
CLAIM(signed_curvature_is_the_turning_of_the_tangent)
{
    num p = unknown(T, "p", 0), q = unknown(T, "q", 0), two = from_int(2), one = from_int(1);
    num d1[] = {sub(mul(p, p), mul(q, q)), mul(two, mul(p, q))}, d2[] = {unknown(T, "x", 2), unknown(T, "y", 2)};
    num m = div(d1[1], d1[0]), slope = div(sub(d2[1], mul(m, d2[0])), d1[0]); /* y' = m x' differentiated */
    num turning = fault(T, div(slope, add(one, mul(m, m))), slope);
    num k = G(signed_curvature)(d1, d2), size = G(curvature)(2, d1, d2);
    num length = root(2, add(mul(d1[0], d1[0]), mul(d1[1], d1[1])));
    same(T, mul(k, length), turning);
    same(T, mul(size, size), mul(k, k));
#if !FIELD
    nonnegative(T, size);
    same(T, length, add(mul(p, p), mul(q, q)));
#endif
}

/*
For a rational curve only the division by $\omega(t)$ is added.  The kernels differentiate numerator and denominator
and solve for $R'$, $R''$, $R'''$; here both polynomials are expanded at $t$ and divided as power series, so that a
slip in the one way cannot hide in the other.

:::{claim} rational_curvature_and_torsion_belong_to_arc_length
:title: Curvature and torsion of a rational Bézier curve, at any parameter
:zh: 有理 Bézier 曲线任意参数处的曲率与挠率
:given: any parameter; weights and points of the plane and of space drawn at random from small integers
:then: the kernels' $\kappa^2$ and $\tau$ are those of the definition by arc length
:method: The curve is expanded at $t$ from the definition of the Bernstein basis and divided as power series; nothing is shared with the kernels.
  That weights and points may be anything is decided where derivatives, curvature and torsion are decided one by one.
:types: rational interval double
:degrees: 2..5 sampled 8
:defines: rational_curvature_squared rational_torsion
:control: the weights equal in the denominator of the expansion
:::
*/
/* The coordinates of the curve at t + epsilon. */
static inline void G(expand)(int n, int dim, const num R[], const num w[], num t, int without_weights, G(series) out[])
{
    num zero = from_int(0), one = from_int(1);
    G(series) T = {{t, one, zero, zero}}, S = {{sub(one, t), from_int(-1), zero, zero}}, W = {{zero, zero, zero, zero}};
    for (int c = 0; c < dim; c++)
        out[c] = W;
    for (int i = 0; i <= n; i++) {
        G(series) B = {{from_int(binomial(n, i)), zero, zero, zero}};
        for (int k = 0; k < n; k++)
            B = G(series_mul)(B, k < i ? T : S);
        for (int c = 0; c < dim; c++) {
            G(series) weight = {{mul(w[i], R[i * dim + c]), zero, zero, zero}};
            out[c] = G(series_add)(out[c], G(series_mul)(B, weight));
        }
        G(series) weight = {{without_weights ? one : w[i], zero, zero, zero}};
        W = G(series_add)(W, G(series_mul)(B, weight));
    }
    for (int c = 0; c < dim; c++)
        out[c] = G(series_div)(out[c], W);
}

CLAIM(rational_curvature_and_torsion_belong_to_arc_length)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], t = parameter(T, "t");
    for (int i = 0; i <= n; i++)
        w[i] = from_int(pick(T, 1, 9));
    for (int dim = 2; dim <= 3; dim++) {
        num R[(MAX_DEGREE + 1) * 3], curvature_squared, torsion;
        G(series) curve[3];
        for (int m = 0; m < (n + 1) * dim; m++)
            R[m] = from_int(pick(T, -9, 9));
        G(expand)(n, dim, R, w, t, fault(T, 0, 1), curve);
        G(by_arc_length)(dim, curve, &curvature_squared, &torsion);
        same(T, G(rational_curvature_squared)(n, dim, R, w, t), curvature_squared);
        if (dim == 3)
            same(T, G(rational_torsion)(n, R, w, t), torsion);
    }
}

/*
## The two formulas

$R'(0)$ is a multiple of $a_1$; $R''(0)$ is a multiple of $a_2$ and something along $a_1$; $R'''(0)$ is a multiple of $a_3$ and something in the
plane of $a_1$ and $a_2$.  In $R'\times R''$ and in $(R',R'',R''')$ what is added drops out.  So the numbers in
(3.2.5) and (3.2.6) can be read off the multiples $n\frac{\omega_1}{\omega_0}$, $n(n-1)\frac{\omega_2}{\omega_0}$,
$n(n-1)(n-2)\frac{\omega_3}{\omega_0}$: in $\kappa=|R'\times R''|/|R'|^3$ they are
$\frac{n\cdot n(n-1)}{n^3}=\frac{n-1}n$ and
$\frac{\omega_1\omega_2}{\omega_0^2}\cdot\frac{\omega_0^3}{\omega_1^3}=\frac{\omega_0\omega_2}{\omega_1^2}$, and in the torsion $(R',R'',R''')/|R'\times
R''|^2$ they are $\frac{n-2}n$ and $\frac{\omega_0\omega_3}{\omega_1\omega_2}$.

:::{statement} wang-ch3:prop-3.2.4
:title: Curvature and torsion at the ends, for control points without repetition
:zh: 端点曲率与挠率（控制顶点无重点）
:printed: The curvature $\kappa$ and the torsion $\tau$ at the ends: let no control points coincide, $\mathbf a_i=\mathbf R_i-\mathbf R_{i-1}$, $i=1,2,\dots,n$; then
  (3.2.5) and (3.2.6).
:holds-by: curvature_and_torsion_follow_at_zero_in_every_degree derivative_vectors_at_zero_in_every_degree
  curvature_and_torsion_follow_at_one_in_every_degree derivative_vectors_at_one_in_every_degree
  factor_of_the_curvature_is_positive bernstein_sum_begins_with_its_differences curvature_belongs_to_arc_length
  torsion_belongs_to_arc_length
:confirmed-by: end_curvature_at_zero end_curvature_at_one end_torsion_at_zero end_torsion_at_one
:needs: repeated_first_points_leave_curvature_undetermined | the property itself: no control points coincide | $\mathbf
  a_1\ne\mathbf 0$ and $\mathbf a_n\ne\mathbf 0$; that is all that the formulas of the curvature use of the hypothesis; other
  points may coincide.  At $t=1$ this example and those below are read in reversed order.
:needs: negative_weight_makes_printed_curvature_negative | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  the weights are positive for (3.2.5); in general its right sides need $|\omega_0\omega_2|$ and $|\omega_{n-2}\omega_n|$.
:hypothesis: collinear_first_points_leave_torsion_undetermined | $\mathbf a_1\times\mathbf a_2\ne\mathbf 0$ and $\mathbf
  a_{n-1}\times\mathbf a_n\ne\mathbf 0$ for (3.2.6): at $t=0$ and at $t=1$, which distinct points do not ensure.
:reading: missing_points_have_the_factor_zero | Read for $n=1$ in (3.2.5) and for $n=2$ in (3.2.6), where some of the weights and edges do not exist:
  whatever stands for them, the factors $n-1$ and $n-2$ make it $0$.
:figure: end_formulas_undetermined
:::

:::{statement} wang-ch3:3.2.5-left
:title: Curvature at t = 0
:zh: t=0 处的曲率
:printed: For control points of which none coincide and $\mathbf a_i=\mathbf R_i-\mathbf R_{i-1}$: $\kappa(0)=\frac{n-1}n\frac{\omega_0\omega_2}{\omega_1^2}\frac{\|\mathbf
  a_1\times\mathbf a_2\|}{\|\mathbf a_1\|^3}$.
:holds-by: curvature_and_torsion_follow_at_zero_in_every_degree derivative_vectors_at_zero_in_every_degree
  factor_of_the_curvature_is_positive bernstein_sum_begins_with_its_differences curvature_belongs_to_arc_length
:confirmed-by: end_curvature_at_zero
:needs: repeated_first_points_leave_curvature_undetermined | property 3.2.4: no control points coincide | $\mathbf
  R_0\ne\mathbf R_1$.
:needs: negative_weight_makes_printed_curvature_negative | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  the weights are positive; in general the right side needs $|\omega_0\omega_2|$.
:reading: missing_points_have_the_factor_zero | Read for $n=1$, where $\omega_2$ and $\mathbf a_2$ do not exist: whatever stands for them, the factor $n-1$
  makes it $0$, the curvature of a segment.
:figure: end_curvature

$\|\mathbf a\times\mathbf b\|$ is the area of the parallelogram of $\mathbf a$ and $\mathbf b$; with this meaning the formula holds in any
dimension, as $\mathbf R'(0)$ and $\mathbf R''(0)$ are combinations of $\mathbf a_1$ and $\mathbf a_2$.
:::

:::{statement} wang-ch3:3.2.5-right
:title: Curvature at t = 1
:zh: t=1 处的曲率
:printed: For control points of which none coincide and $\mathbf a_i=\mathbf R_i-\mathbf R_{i-1}$: $\kappa(1)=\frac{n-1}n\frac{\omega_{n-2}\omega_n}{\omega_{n-1}^2}\frac{\|\mathbf
  a_{n-1}\times\mathbf a_n\|}{\|\mathbf a_n\|^3}$.
:holds-by: curvature_and_torsion_follow_at_one_in_every_degree derivative_vectors_at_one_in_every_degree
  factor_of_the_curvature_is_positive bernstein_sum_begins_with_its_differences curvature_belongs_to_arc_length
:confirmed-by: end_curvature_at_one
:needs: repeated_first_points_leave_curvature_undetermined | property 3.2.4: no control points coincide | $\mathbf
  R_{n-1}\ne\mathbf R_n$; the example is read in reversed order.
:needs: negative_weight_makes_printed_curvature_negative | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  the weights are positive; in general the right side needs $|\omega_{n-2}\omega_n|$; the example is read in reversed order.
:reading: missing_points_have_the_factor_zero | Read for $n=1$, where $\omega_{n-2}$ and $\mathbf a_{n-1}$ do not exist: whatever stands for them, the factor
  $n-1$ makes it $0$, the curvature of a segment.
:figure: end_curvature
:::

:::{statement} wang-ch3:3.2.6-left
:title: Torsion at t = 0
:zh: t=0 处的挠率
:printed: For control points of which none coincide and $\mathbf a_i=\mathbf R_i-\mathbf R_{i-1}$: $\tau(0)=\frac{n-2}n\frac{\omega_0\omega_3}{\omega_1\omega_2}\frac{(\mathbf a_1,\mathbf
  a_2,\mathbf a_3)}{\|\mathbf a_1\times\mathbf a_2\|^2}$.
:holds-by: curvature_and_torsion_follow_at_zero_in_every_degree derivative_vectors_at_zero_in_every_degree
  bernstein_sum_begins_with_its_differences torsion_belongs_to_arc_length
:confirmed-by: end_torsion_at_zero
:hypothesis: collinear_first_points_leave_torsion_undetermined | $\mathbf a_1\times\mathbf a_2\ne\mathbf 0$: the first three points are not on a line.
:reading: missing_points_have_the_factor_zero | Read for $n=2$, where $\omega_3$ and $\mathbf a_3$ do not exist: whatever stands for them, the factor $n-2$
  makes it $0$, the torsion of a plane curve.  For $n=1$, and for $n=2$ with the three points on a line, the curve is in a line
  and has no torsion.
:figure: end_formulas_undetermined

The sign of the weights does not matter here, as long as $\omega_0,\omega_1,\omega_2$ are not $0$.
:::

:::{statement} wang-ch3:3.2.6-right
:title: Torsion at t = 1
:zh: t=1 处的挠率
:printed: For control points of which none coincide and $\mathbf a_i=\mathbf R_i-\mathbf R_{i-1}$: $\tau(1)=\frac{n-2}n\frac{\omega_{n-3}\omega_n}{\omega_{n-2}\omega_{n-1}}\frac{(\mathbf
  a_{n-2},\mathbf a_{n-1},\mathbf a_n)}{\|\mathbf a_{n-1}\times\mathbf a_n\|^2}$.
:holds-by: curvature_and_torsion_follow_at_one_in_every_degree derivative_vectors_at_one_in_every_degree
  bernstein_sum_begins_with_its_differences torsion_belongs_to_arc_length
:confirmed-by: end_torsion_at_one
:hypothesis: collinear_first_points_leave_torsion_undetermined | $\mathbf a_{n-1}\times\mathbf a_n\ne\mathbf 0$: the last three points are not on a line; the example is
  read in reversed order.
:reading: missing_points_have_the_factor_zero | Read for $n=2$, where $\omega_{n-3}$ and $\mathbf a_{n-2}$ do not exist: whatever stands for them, the factor
  $n-2$ makes it $0$, the torsion of a plane curve.  For $n=1$, and for $n=2$ with the three points on a line, the curve is in a line
  and has no torsion.

The sign of the weights does not matter here, as long as $\omega_n,\omega_{n-1},\omega_{n-2}$ are not $0$.
:::
*/

/* Compares the curvature at t with factor |a x b| / |a|^3, in which `length` is |a|^2. */
static inline void G(compare_curvature)(trial *T, int n, int dim, const num R[], const num w[], num t, num factor,
                                        const num a[], const num b[], num length)
{
    num x[3], area = from_int(0), cube = mul(length, mul(length, length));
    if (dim == 2) {
        area = G(cross2)(a, b);
        area = mul(area, area);
    } else {
        G(cross3)(a, b, x);
        area = G(norm_squared)(3, x);
    }
    about(T, "curvature squared");
    /* κ² = factor² |a × b|²/|a|⁶ */
    same(T, G(rational_curvature_squared)(n, dim, R, w, t), mul(mul(factor, factor), div(area, cube)));
    about(T, "1/factor");
    nonnegative(T, div(from_int(1), factor));
#if INTERVAL || DOUBLE
    num D[3 * 3];
    G(rational_derivatives)(n, dim, R, w, t, 2, D);
    about(T, "curvature");
    same(T, G(curvature)(dim, D + dim, D + 2 * dim), mul(factor, div(root(2, area), mul(length, root(2, length)))));
#endif
}

/*
Curvatures are compared by their squares, because a field of rational functions has no square roots.  For the sign it is shown in
addition that the factor in front is positive, and this is the place where positive weights are used.

:::{claim} end_curvature_at_zero
:title: The curvature at t = 0 is the printed one
:zh: t=0 处曲率公式成立
:given: points of the plane and of space with $a_1\ne0$ and otherwise free, positive weights
:where: $\mathbf a_1\ne\mathbf 0$
:then: $\kappa(0)^2=\left(\frac{n-1}n\frac{\omega_0\omega_2}{\omega_1^2}\right)^2\frac{|a_1\times a_2|^2}{|a_1|^6}$ and the factor that is squared is
  positive
:method: The squares are one element of the field of rational functions of the weights and the coordinates; both $\kappa(0)$ and the printed side are not
  negative, so they are equal.  Intervals and binary64 also compare the roots.
:degrees: 2..6 sampled 10
:control: the factor $n/(n-1)$
:::
*/
CLAIM(end_curvature_at_zero)
{
    int n = T->degree;
    for (int dim = 2; dim <= 3; dim++) {
        num w[MAX_DEGREE + 1], R[(MAX_DEGREE + 1) * 3], a1[3], a2[3];
        G(free_curve)(T, n, dim, R, w);
        G(edge)(dim, R, 1, a1);
        G(edge)(dim, R, 2, a2);
        num factor = mul(fault(T, from_ratio(n - 1, n), from_ratio(n, n - 1)), div(mul(w[0], w[2]), mul(w[1], w[1])));
        G(compare_curvature)(T, n, dim, R, w, from_int(0), factor, a1, a2, G(norm_squared)(dim, a1));
    }
}

/*
:::{claim} end_curvature_at_one
:title: The curvature at t = 1 is the printed one
:zh: t=1 处曲率公式成立
:given: points of the plane and of space with $a_n\ne0$ and otherwise free, positive weights
:where: $\mathbf a_n\ne\mathbf 0$
:then: $\kappa(1)^2=\left(\frac{n-1}n\frac{\omega_{n-2}\omega_n}{\omega_{n-1}^2}\right)^2\frac{|a_{n-1}\times a_n|^2}{|a_n|^6}$ and the factor that is
  squared is positive
:method: The squares are one element of the field of rational functions of the weights and the coordinates; both $\kappa(1)$ and the printed side are not
  negative, so they are equal.  The curve is not reversed, the kernel is asked at $t=1$; intervals and binary64 also compare the roots.
:degrees: 2..6 sampled 10
:control: the length $|a_{n-1}|$ in place of $|a_n|$
:::
*/
CLAIM(end_curvature_at_one)
{
    int n = T->degree;
    for (int dim = 2; dim <= 3; dim++) {
        num w[MAX_DEGREE + 1], R[(MAX_DEGREE + 1) * 3], last[3], before[3];
        G(free_curve)(T, n, dim, R, w);
        G(edge)(dim, R, n, last);
        G(edge)(dim, R, n - 1, before);
        num factor = mul(from_ratio(n - 1, n), div(mul(w[n - 2], w[n]), mul(w[n - 1], w[n - 1])));
        num length = G(norm_squared)(dim, fault(T, last, before));
        G(compare_curvature)(T, n, dim, R, w, from_int(1), factor, last, before, length);
    }
}

/*
:::{claim} end_torsion_at_zero
:title: The torsion at t = 0 is the printed one
:zh: t=0 处挠率公式成立
:given: points of space with $a_1\times a_2\ne0$ and otherwise free, weights of which $\omega_0,\omega_1,\omega_2$ are not $0$
:where: $\mathbf a_1\times\mathbf a_2\ne\mathbf 0$; $\omega_0\omega_1\omega_2\ne0$
:then: $\tau(0)=\frac{n-2}n\frac{\omega_0\omega_3}{\omega_1\omega_2}\frac{(a_1,a_2,a_3)}{|a_1\times a_2|^2}$
:method: Both sides are one element of the field of rational functions of the weights and the coordinates.
:degrees: 3..6 sampled 10
:control: the factor $(n-1)/n$
:::
*/
CLAIM(end_torsion_at_zero)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[(MAX_DEGREE + 1) * 3], a[3][3], x[3];
    G(free_curve)(T, n, 3, R, w);
    for (int i = 0; i < 3; i++)
        G(edge)(3, R, i + 1, a[i]);
    G(cross3)(a[0], a[1], x);
    num factor = mul(from_ratio(fault(T, n - 2, n - 1), n), div(mul(w[0], w[3]), mul(w[1], w[2])));
    /* τ(0) = (n-2)/n ω_0 ω_3/(ω_1 ω_2) (a_1, a_2, a_3)/|a_1 × a_2|² */
    same(T, G(rational_torsion)(n, R, w, from_int(0)),
         mul(factor, div(G(det3)(a[0], a[1], a[2]), G(norm_squared)(3, x))));
}

/*
:::{claim} end_torsion_at_one
:title: The torsion at t = 1 is the printed one
:zh: t=1 处挠率公式成立
:given: points of space with $a_{n-1}\times a_n\ne0$ and otherwise free, weights of which $\omega_{n-2},\omega_{n-1},\omega_n$ are not $0$
:where: $\mathbf a_{n-1}\times\mathbf a_n\ne\mathbf 0$; $\omega_{n-2}\omega_{n-1}\omega_n\ne0$
:then: $\tau(1)=\frac{n-2}n\frac{\omega_{n-3}\omega_n}{\omega_{n-2}\omega_{n-1}}\frac{(a_{n-2},a_{n-1},a_n)}{|a_{n-1}\times a_n|^2}$
:method: Both sides are one element of the field of rational functions of the weights and the coordinates; the curve is not reversed, the kernel is
  asked at $t=1$.
:degrees: 3..6 sampled 10
:control: the edges in the order $(a_n,a_{n-1},a_{n-2})$, the sign that a thoughtless reversal gives
:::
*/
CLAIM(end_torsion_at_one)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[(MAX_DEGREE + 1) * 3], a[3][3], x[3];
    G(free_curve)(T, n, 3, R, w);
    for (int i = 0; i < 3; i++)
        G(edge)(3, R, n - 2 + i, a[i]);
    G(cross3)(a[1], a[2], x);
    num factor = mul(from_ratio(n - 2, n), div(mul(w[n - 3], w[n]), mul(w[n - 2], w[n - 1])));
    num volume = fault(T, G(det3)(a[0], a[1], a[2]), G(det3)(a[2], a[1], a[0]));
    /* τ(1) = (n-2)/n ω_{n-3} ω_n/(ω_{n-2} ω_{n-1}) (a_{n-2}, a_{n-1}, a_n)/|a_{n-1} × a_n|² */
    same(T, G(rational_torsion)(n, R, w, from_int(1)), mul(factor, div(volume, G(norm_squared)(3, x))));
}

/*
:::{statement} wang-ch3:prop-3.2.4-letter
:title: The letter of the curvature
:zh: 曲率的记号
:definition: yes
:printed: By the usual practice the curvature is also written $k$; in this book it is written $k$ from here on.

In (3.2.3) and (3.2.4) $k$ is a number of points.
:::

### What the formulas need

The formulas divide by $|a_1|$ and by $|a_1\times a_2|$.  The hypothesis of the source, that no two points coincide,
is more than the first formula asks, since points may be repeated elsewhere, and less than the second one asks, since
three different points may be on a line.  In the two examples below the curvature and the torsion have limits at the
end, and these are not $0$: it is the formula that fails there, not the curve.  A factor $n-1$ or $n-2$, on the other
hand, makes good sense where the points that it stands for do not exist.
:::{claim} missing_points_have_the_factor_zero
:title: Segments have end curvature 0, and quadratics end torsion 0
:zh: 线段曲率为零，二次曲线挠率为零
:given: in space, two points with weights ($n=1$), and three points with weights ($n=2$)
:where: $\mathbf R_0\ne\mathbf R_1$ for $n=1$; no weight is 0
:then: $\kappa(0)=\kappa(1)=0$ for $n=1$, and $(R',R'',R''')=0$ at both ends for $n=2$: what the factors $n-1$ and $n-2$ say
:method: Both are $0$ in the field of the weights and the coordinates.
:control: the same with one point more
:::
*/
CLAIM(missing_points_have_the_factor_zero)
{
    for (int end = 0; end <= 1; end++) {
        num w[4], R[4 * 3], D[4 * 3];
        G(free_curve)(T, 3, 3, R, w);
        vanishes(T, G(rational_curvature_squared)(fault(T, 1, 2), 3, R, w, from_int(end)));
        G(rational_derivatives)(fault(T, 2, 3), 3, R, w, from_int(end), 3, D);
        vanishes(T, G(det3)(D + 3, D + 6, D + 9));
    }
}

#if FIELD
/*
:::{claim} repeated_first_points_leave_curvature_undetermined
:title: A parabola that starts with a repeated point has curvature 2 there; the formula says 0/0
:zh: 首点重合的抛物线弧起点曲率为 2，公式给出 0/0
:kind: counterexample
:types: field
:data: R = (0,0) (0,0) (1/6,0) (1/2,0) (1,1); ω = 1 1 1 1 1
:instead: R = (0,0) (1/8,0) (1/6,0) (1/2,0) (1,1)
:result: x(t) = "t^2"; y(t) = "t^4"; κ(0)² = 4; |a_1 × a_2|² = 0; |a_1|⁶ = 0; κ(1)² of R reversed = 4; |a_3 × a_4|² of R reversed = 0;
  |a_4|⁶ of R reversed = 0
:given: the arc $x=t^2$, $y=t^4$ of the parabola $y=x^2$ as a curve of degree $n=4$ with points $R$ and equal weights: $R_0=R_1$
:then: $\kappa(t)\to2$ for $t\to0$, but the denominator $\|a_1\|^3$ of (3.2.5) is $0$, and so is the numerator; with the points in reversed
  order the same at $t=1$, with $\|a_n\|^3$
:method: $\kappa^2$ is computed at a variable $t$, and the rational function is evaluated at the end: where its value is $4$, the
  denominator of the formula is asked to be different from $0$.
:control: the point $R_1$ moved away from $R_0$
:::
*/
CLAIM(repeated_first_points_leave_curvature_undetermined)
{
    num R[10], w[5], a1[2], a2[2], P[2], t = variable_f("t");
    given_points(T, "R", 5, 2, R);
    given_points(T, "ω", 5, 1, w);
    G(rational_point)(4, 2, R, w, t, P);
    found_text(T, "x(t)", to_string_f(P[0]));
    found_text(T, "y(t)", to_string_f(P[1]));
    num squared = G(rational_curvature_squared)(4, 2, R, w, t);
    show(T, "κ(t)²", squared);
    found(T, "κ(0)²", substitute_f(squared, t, from_int(0)));
    G(edge)(2, R, 1, a1);
    G(edge)(2, R, 2, a2);
    num area = G(cross2)(a1, a2), length = G(norm_squared)(2, a1);
    found(T, "|a_1 × a_2|²", mul(area, area));
    found(T, "|a_1|⁶", mul(mul(length, length), length));
    num reversed[10], b[2], last[2];
    G(reversed_points)(4, 2, R, reversed);
    squared = G(rational_curvature_squared)(4, 2, reversed, w, t);
    found(T, "κ(1)² of R reversed", substitute_f(squared, t, from_int(1)));
    G(edge)(2, reversed, 3, b);
    G(edge)(2, reversed, 4, last);
    num area_at_one = G(cross2)(b, last), length_at_one = G(norm_squared)(2, last);
    found(T, "|a_3 × a_4|² of R reversed", mul(area_at_one, area_at_one));
    found(T, "|a_4|⁶ of R reversed", mul(mul(length_at_one, length_at_one), length_at_one));
    about(T, "the denominator |a_1|⁶, or |a_4|⁶ of R reversed, is not 0");
    refute(T, is_zero_f(length) && is_zero_f(length_at_one));
}

/* Of a quartic in space, at t = 0 or at t = 1: the torsion, and of (3.2.6) the triple product of the three edges there and the square of the
 * product of the two at the end, by these names.  Whether that square is 0. */
static int torsion_formula_divides_by_zero(trial *T, const num R[], const num w[], num t, int end,
                                           const char *const name[3])
{
    num a[3][3], x[3];
    found(T, name[0], substitute_f(G(rational_torsion)(4, R, w, t), t, from_int(end)));
    for (int i = 0; i < 3; i++)
        G(edge)(3, R, end + i + 1, a[i]);
    G(cross3)(a[end], a[end + 1], x);
    num area = G(norm_squared)(3, x);
    found(T, name[1], G(det3)(a[0], a[1], a[2]));
    found(T, name[2], area);
    return is_zero_f(area);
}

/*
:::{claim} collinear_first_points_leave_torsion_undetermined
:title: Points without repetition, torsion 2 at the start; the formula says 0/0
:zh: 无重点而首三点共线：起点挠率为 2，公式给出 0/0
:kind: counterexample
:types: field
:data: R = (0,0,0) (1/4,0,0) (1/2,0,0) (3/4,1/4,0) (1,1,1); ω = 1 1 1 1 1
:instead: R = (0,0,0) (1/4,0,0) (1/2,1/4,0) (3/4,1/4,0) (1,1,1)
:result: x(t) = "t"; y(t) = "t^3"; z(t) = "t^4"; pairs of equal points = 0; τ(0) = 2; (a_1, a_2, a_3) = 0; |a_1 × a_2|² = 0;
  τ(1) of R reversed = 2; (a_2, a_3, a_4) of R reversed = 0; |a_3 × a_4|² of R reversed = 0
:given: $x=t$, $y=t^3$, $z=t^4$ as a curve of degree $n=4$ with equal weights; its points $R$ are all different, the first three on a line
:then: $\tau(t)\to2$ for $t\to0$, but the denominator $\|a_1\times a_2\|^2$ of (3.2.6) is $0$, and so is the numerator; with the points in
  reversed order the same at $t=1$, with $\|a_{n-1}\times a_n\|^2$
:method: $\tau$ is computed at a variable $t$, and the rational function is evaluated at the end: where its value is $2$, the
  denominator of the formula is asked to be different from $0$.
:control: the point $R_2$ moved off the line of $R_0$ and $R_1$
:::
*/
CLAIM(collinear_first_points_leave_torsion_undetermined)
{
    num R[15], w[5], P[3], t = variable_f("t");
    given_points(T, "R", 5, 3, R);
    given_points(T, "ω", 5, 1, w);
    G(rational_point)(4, 3, R, w, t, P);
    found_text(T, "x(t)", to_string_f(P[0]));
    found_text(T, "y(t)", to_string_f(P[1]));
    found_text(T, "z(t)", to_string_f(P[2]));
    int equal = 0;
    for (int j = 1; j < 5; j++)
        for (int i = 0; i < j; i++)
            equal += equal_f(R[3 * i], R[3 * j]) && equal_f(R[3 * i + 1], R[3 * j + 1]) &&
                     equal_f(R[3 * i + 2], R[3 * j + 2]);
    found_whole(T, "pairs of equal points", equal);
    num reversed[15];
    G(reversed_points)(4, 3, R, reversed);
    show(T, "τ(t)", G(rational_torsion)(4, R, w, t));
    int at_zero = torsion_formula_divides_by_zero(T, R, w, t, 0,
                                                  (const char *const[]){"τ(0)", "(a_1, a_2, a_3)", "|a_1 × a_2|²"}),
        at_one = torsion_formula_divides_by_zero(
            T, reversed, w, t, 1,
            (const char *const[]){"τ(1) of R reversed", "(a_2, a_3, a_4) of R reversed", "|a_3 × a_4|² of R reversed"});
    about(T, "the denominator |a_1 × a_2|², or |a_3 × a_4|² of R reversed, is not 0");
    refute(T, at_zero && at_one);
}
#endif

#if RATIONAL
/*
If just one of the weights $\omega_0$ and $\omega_2$ is negative, the factor is negative, and the right side of (3.2.5)
with it, while a curvature is not.  The curve itself may be quite regular.

:::{claim} negative_weight_makes_printed_curvature_negative
:title: With a negative weight the printed curvature can be negative
:zh: 权为负时所印曲率为负
:kind: counterexample
:data: R = (0,0) (1,0) (1,1) (0,1); ω = 1 1 -1/4 1
:instead: ω = 1 1 1/4 1
:result: zeros of ω(t) in [0,1] = 0; κ(0) = 1/6; κ(0) as printed = -1/6; κ(1) of R and ω reversed = 1/6; κ(1) as printed = -1/6
:given: the cubic curve with the corners $R$ of a square and weights $\omega$, of which one is negative, though $\omega(t)$ has no zero in $[0,1]$
:then: the printed side of (3.2.5) is $-\kappa(0)$; with points and weights in reversed order that at $t=1$ is $-\kappa(1)$
:method: $\kappa(0)$ and $\kappa(1)$ are the roots of their exact squares.
:control: the negative weight made positive
:::
*/
CLAIM(negative_weight_makes_printed_curvature_negative)
{
    enum { n = 3 };
    num R[2 * (n + 1)], w[n + 1], a1[2], a2[2], zero = from_int(0);
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    int zeros = count_roots(poly_from_bernstein(n, w), zero, from_int(1), CLOSED).distinct;
    found_whole(T, "zeros of ω(t) in [0,1]", zeros);
    G(edge)(2, R, 1, a1);
    G(edge)(2, R, 2, a2);
    num curvature = root(2, G(rational_curvature_squared)(n, 2, R, w, zero));
    num length = root(2, G(norm_squared)(2, a1)), area = root(2, G(gram)(2, a1, a2));
    num factor = mul(from_ratio(n - 1, n), div(mul(w[0], w[2]), mul(w[1], w[1])));
    /* (n-1)/n ω_0 ω_2/ω_1² |a_1 × a_2|/|a_1|³ */
    num printed = mul(factor, div(area, mul(length, mul(length, length))));
    found(T, "κ(0)", curvature);
    found(T, "κ(0) as printed", printed);
    num S[2 * (n + 1)], v[n + 1]; /* the same backwards, at t = 1 */
    G(reversed_points)(n, 2, R, S);
    G(reversed_points)(n, 1, w, v);
    G(edge)(2, S, n - 1, a2);
    G(edge)(2, S, n, a1);
    found(T, "κ(1) of R and ω reversed", root(2, G(rational_curvature_squared)(n, 2, S, v, from_int(1))));
    length = root(2, G(norm_squared)(2, a1));
    factor = mul(from_ratio(n - 1, n), div(mul(v[n - 2], v[n]), mul(v[n - 1], v[n - 1])));
    found(T, "κ(1) as printed", mul(factor, div(root(2, G(gram)(2, a1, a2)), mul(length, mul(length, length)))));
    about(T, "left κ(0), right as printed");
    if (zeros == 0)
        same(T, curvature, printed);
}
#endif

#include "chapters/judge/claims_off.h"
