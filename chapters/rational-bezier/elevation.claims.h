/*
# Degree elevation (升阶)

The same curve can be written with one more point.  Numerator and denominator are polynomials in
Bernstein form, and each is raised by itself; the points of the new polygon lie on the edges of the old
one.  Repeated without end the polygons converge to the curve, but slowly, like $1/N$ for degree $N$.
*/
#if RATIONAL
#include "exact/record/sign.h"

#include <stdio.h>
#endif

#include "chapters/rational-bezier/free-curve.h"

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

/*
## The formulas

One Bernstein function of degree $n$ is a sum of two of degree $n+1$,

$$B_i^n(t)=\frac{n+1-i}{n+1}B_i^{n+1}(t)+\frac{i+1}{n+1}B_{i+1}^{n+1}(t),$$

and everything below is this line, used for the denominator with the weights and for the numerator with
the products $\omega_iR_i$.

:::{statement} wang-ch3:prop-3.2.6
:title: A rational Bézier curve of degree n is one of degree n+1 as well
:zh: n 次有理 Bézier 曲线也是 n+1 次的
:printed: The formula of elevation: the curve of degree $n$ with weights $\omega_i$ and vertices $\mathbf R_i$ is the curve of degree $n+1$
  with weights $\hat\omega_i$ and vertices $\hat{\mathbf R}_i$ of (3.2.7) to (3.2.9).
:holds-by: bernstein_function_in_the_next_degree elevation_cuts_corners numbers_outside_the_polygon_do_not_matter
  positive_terms_make_a_convex_mean
:confirmed-by: elevation_keeps_rational_curve
:needs: elevated_vertex_may_be_at_infinity | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive; otherwise the new vertices need not exist, though the curve has no pole
:figure: elevation_cuts_corners
:::

:::{statement} wang-ch3:3.2.7
:title: The elevated points and weights give the same curve
:zh: 升阶前后为同一曲线
:printed: \mathbf R(t)=\frac{\sum_{i=0}^nB_i^n(t)\omega_i\mathbf R_i}{\sum_{i=0}^nB_i^n(t)\omega_i}
  =\frac{\sum_{i=0}^{n+1}B_i^{n+1}(t)\hat\omega_i\hat{\mathbf R}_i}{\sum_{i=0}^{n+1}B_i^{n+1}(t)\hat\omega_i}
:holds-by: bernstein_function_in_the_next_degree elevation_cuts_corners numbers_outside_the_polygon_do_not_matter
  positive_terms_make_a_convex_mean
:confirmed-by: elevation_keeps_rational_curve
:needs: elevated_vertex_may_be_at_infinity | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive: so that all vertices $\hat{\mathbf R}_i$ exist

The two denominators are one polynomial, so that one vanishes where the other does; with positive weights neither does for $0\le t\le1$.
:::

:::{claim} bernstein_function_in_the_next_degree
:title: A Bernstein function of degree n is a sum of two of degree n+1
:zh: n 次 Bernstein 基函数是两个 n+1 次基函数之和
:given: $0\le i\le n$, $n=i+k$; any $t$
:then: $B_i^n(t)=\frac{n+1-i}{n+1}B_i^{n+1}(t)+\frac{i+1}{n+1}B_{i+1}^{n+1}(t)$
:method: With $C(n,i)=c$ the definition by factorials gives $C(n+1,i)=c\frac{n+1}{n+1-i}$ and
  $C(n+1,i+1)=c\frac{n+1}{i+1}$; with $t^i(1-t)^{n-i}=u$ the two functions on the right are these times $u(1-t)$ and
  $ut$.  The numbers $i$, $k$, $c$, $u$, $t$ are variables, so $n$ is any degree.  Outside the field $i$ and $k$ are
  random integers, and the two binomial coefficients are compared with true ones.
  It is multiplied by $\omega_i$ and by $\omega_iR_i$; summed with such factors $b_i$ the line says $\sum_ib_iB_i^n=\sum_i\hat b_iB_i^{n+1}$ with
  $\hat b_i=(1-\frac i{n+1})b_i+\frac i{n+1}b_{i-1}$, which is formula (3.2.7).
:degrees: all
:over: i k c u: -
:control: $(i+1)/(n+1)$ taken as $i/(n+1)$
:::
*/
CLAIM(bernstein_function_in_the_next_degree)
{
    num one = from_int(1), t = parameter(T, "t"), u = positive(T, "u", 0);
#if FIELD
    num i = parameter(T, "i"), k = parameter(T, "k"), c = parameter(T, "c");
#else
    int index = pick(T, 0, 9), degree = index + pick(T, 0, 9);
    num i = from_int(index), k = from_int(degree - index), c = from_int(binomial(degree, index));
#endif
    num next = add(add(i, k), one); /* n + 1 */
    num lower = div(mul(c, next), add(k, one)), upper = div(mul(c, next), add(i, one));
#if !FIELD
    same(T, lower, from_int(binomial(degree + 1, index)));
    same(T, upper, from_int(binomial(degree + 1, index + 1)));
#endif
    num left_share = div(add(k, one), next), right_share = div(fault(T, add(i, one), i), next);
    num left = mul(mul(left_share, lower), mul(u, sub(one, t))), right = mul(mul(right_share, upper), mul(u, t));
    num w = positive(T, "w", 0), term = mul(w, unknown(T, "x", 0)); /* ω_i, ω_i R_i */
    /* (n+1-i)/(n+1) B_i^{n+1} + (i+1)/(n+1) B_{i+1}^{n+1} = B_i^n */
    about(T, "the term of the denominator");
    same(T, mul(w, add(left, right)), mul(w, mul(c, u)));
    about(T, "the term of the numerator");
    same(T, mul(term, add(left, right)), mul(term, mul(c, u)));
}

/*
:::{claim} elevation_keeps_rational_curve
:title: Degree elevation changes the polygon, not the curve
:zh: 升阶改变控制多边形而不改变曲线
:given: weights $\omega_0,\dots,\omega_n$ and points $R_0,\dots,R_n$
:where: $\hat\omega_i\ne0$; $\omega(t)\ne0$
:let: $\hat\omega_i=(1-\frac i{n+1})\omega_i+\frac i{n+1}\omega_{i-1}$ and
  $\hat\omega_i\hat R_i=(1-\frac i{n+1})\omega_iR_i+\frac i{n+1}\omega_{i-1}R_{i-1}$, $i=0,\dots,n+1$, what has
  an index outside $0,\dots,n$ being $0$
:then: the curves of $(R,\omega)$ and $(\hat R,\hat\omega)$ are one
:method: Both curves are computed at a variable $t$ as elements of one field of rational functions, with every
  weight and point a variable; equal elements are equal functions.  A coordinate is any coordinate, so one suffices.
:degrees: 1..6 sampled 12
:control: the ratio $i/(n+1)$ taken as $i/(n+2)$ in the weights
:::
*/
CLAIM(elevation_keeps_rational_curve)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], we[MAX_DEGREE + 2], Re[MAX_DEGREE + 2], before, after;
    num t = parameter(T, "t");
    G(free_curve)(T, n, 1, R, w);
    G(rational_elevate)(n, 1, R, w, Re, we);
    for (int i = 1; i <= n; i++) {
        num a = from_ratio(i, n + 2);
        we[i] = fault(T, we[i], add(mul(sub(from_int(1), a), w[i]), mul(a, w[i - 1])));
    }
    G(rational_point)(n, 1, R, w, t, &before);
    G(rational_point)(n + 1, 1, Re, we, t, &after);
    /* Σ B_i^{n+1} ω̂_i R̂_i/Σ B_i^{n+1} ω̂_i = Σ B_i^n ω_i R_i/Σ B_i^n ω_i */
    same(T, after, before);
}

#if RATIONAL
/*
The weights of the next degree are means of neighbouring weights.  Where these have opposite signs a mean may be $0$,
and then there is no vertex, though the homogeneous point is there and the curve is as before.

:::{claim} elevated_vertex_may_be_at_infinity
:title: With weights of both signs an elevated vertex need not exist
:zh: 权因子变号时升阶顶点可不存在
:kind: counterexample
:data: ω = 2 -1 2
:instead: ω = 2 1 2
:result: ω̂ = 2 0 0 2
:given: weights $\omega$ of degree $2$, of which the middle one is negative, though $\omega(t)>0$ for all $t\in[0,1]$
:then: $\hat\omega_1=\hat\omega_2=0$: the two inner vertices of the cubic form of this curve are at infinity
:method: The elevated weights are computed exactly and asked to be different from $0$; the sign of $\omega(t)$ is
  decided by counting roots.
:control: the middle weight made positive
:::
*/
CLAIM(elevated_vertex_may_be_at_infinity)
{
    enum { n = 2 };
    num w[n + 1], we[n + 2];
    given_points(T, "ω", n + 1, 1, w);
    G(bezier_elevate)(n, 1, w, we);
    found_points(T, "ω̂", n + 2, 1, we);
    int regular = sign_on(poly_from_bernstein(n, w), from_int(0), from_int(1), CLOSED) == SIGN_POSITIVE;
    about(T, "a denominator without zeros in [0,1] has elevated weights that are not 0");
    refute(T, regular && (is_zero_q(we[1]) || is_zero_q(we[2])));
}
#endif

/*
:::{statement} wang-ch3:3.2.8
:title: The elevated weights, and what stands outside the polygon
:zh: 升阶后的权因子
:printed: \hat\omega_i=\left(1-\frac i{n+1}\right)\omega_i+\frac i{n+1}\omega_{i-1},\quad i=0,1,\dots,n+1;
  \quad\omega_{-1}=\omega_{n+1}=0
:holds-by: bernstein_function_in_the_next_degree
:confirmed-by: numbers_outside_the_polygon_do_not_matter elevation_through_the_power_basis elevated_points_as_printed

The agreement $\omega_{-1}=\omega_{n+1}=0$ only gives the formula a meaning at its two ends: the factor there is $0$,
and any other numbers would do.
:::

:::{statement} wang-ch3:3.2.9
:title: The elevated vertices
:zh: 升阶后的控制顶点
:printed: \hat{\mathbf R}_i=\frac{(1-\frac i{n+1})\omega_i}{(1-\frac i{n+1})\omega_i+\frac i{n+1}\omega_{i-1}}\mathbf R_i
  +\frac{\frac i{n+1}\omega_{i-1}}{(1-\frac i{n+1})\omega_i+\frac i{n+1}\omega_{i-1}}\mathbf R_{i-1},\quad
  i=0,1,\dots,n+1;\quad\mathbf R_{-1}=\mathbf R_{n+1}=\mathbf 0
:holds-by: bernstein_function_in_the_next_degree numbers_outside_the_polygon_do_not_matter elevation_cuts_corners
:confirmed-by: elevated_points_as_printed elevation_keeps_rational_curve
:needs: elevated_vertex_may_be_at_infinity | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive: so that no denominator vanishes
:figure: elevation_cuts_corners

The agreement $\mathbf R_{-1}=\mathbf R_{n+1}=\mathbf 0$, like that of (3.2.8), only gives the formula a meaning at its two ends: the factor there is $0$.
:::

:::{statement} wang-ch3:prop-3.2.6-derivation
:title: The formulas come from raising numerator and denominator apart
:zh: 对分子分母分别升阶
:printed: The formulas can be obtained by applying the operator (1.3.9) to the numerator and to the denominator of (3.2.2).
:holds-by: bernstein_function_in_the_next_degree numbers_outside_the_polygon_do_not_matter elevation_cuts_corners
:confirmed-by: elevation_through_the_power_basis elevated_points_as_printed
:needs: elevated_vertex_may_be_at_infinity | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive: so that the numerators can be divided by the $\hat\omega_i$ for (3.2.9)
:meant: the formulas (3.2.8) and (3.2.9), which it is to give, as (1.3.9) is not in the text at hand | The operator is that of elevation,
  $b_i\mapsto(1-\frac i{n+1})b_i+\frac i{n+1}b_{i-1}$.
:::
*/

/* (3.2.8) and (3.2.9) as they are printed, for one coordinate: share is i/(n+1), the index i-1 is `before`. */
static void G(printed_elevation)(num share, num w_before, num w, num R_before, num R, num *we, num *Re)
{
    num rest = sub(from_int(1), share);
    *we = add(mul(rest, w), mul(share, w_before));
    *Re = add(mul(div(mul(rest, w), *we), R), mul(div(mul(share, w_before), *we), R_before));
}

/*
What is programmed is not (3.2.9): the kernel raises the homogeneous points $(\omega_iR_i,\omega_i)$ and divides at
the end.  The printed fractions say what comes out of this for the points themselves.

:::{claim} elevated_points_as_printed
:title: The kernels of elevation compute the printed weights and points
:zh: 升阶程序即所印公式
:given: weights $\omega_0,\dots,\omega_n$ and points of the plane $R_0,\dots,R_n$
:where: $\hat\omega_i\ne0$
:then: the kernels give $\hat\omega_i$ and $\hat R_i$ of (3.2.8) and (3.2.9); for equal weights, the polynomial elevation,
  which is also the product with the matrix $E$, $E_{i,i-1}=\frac i{n+1}$, $E_{ii}=1-\frac i{n+1}$
:method: The printed fractions are written out for each $i$; the kernels go through homogeneous coordinates and share no
  code with them.  All weights and coordinates are variables.
:degrees: 1..6 sampled 12
:defines: rational_elevate bezier_elevate bernstein_elevation_matrix
:control: the weights $\omega_i$ and $\omega_{i-1}$ exchanged in the printed fractions
:::
*/
CLAIM(elevated_points_as_printed)
{
    enum { dim = 2 };
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[dim * (MAX_DEGREE + 1)], we[MAX_DEGREE + 2], Re[dim * (MAX_DEGREE + 2)];
    num e[dim * (MAX_DEGREE + 2)], E[(MAX_DEGREE + 2) * (MAX_DEGREE + 1)], weight, point;
    G(curve_of_any_weights)(T, n, dim, R, w);
    G(rational_elevate)(n, dim, R, w, Re, we);
    G(bezier_elevate)(n, dim, R, e);
    G(bernstein_elevation_matrix)(n, E);
    for (int i = 0; i <= n + 1; i++)
        for (int c = 0; c < dim; c++) {
            num zero = from_int(0), one = from_int(1), ratio = from_ratio(i, n + 1);
            num w_before = i > 0 ? w[i - 1] : zero, w_here = i <= n ? w[i] : zero;
            num R_before = i > 0 ? R[dim * (i - 1) + c] : zero, R_here = i <= n ? R[dim * i + c] : zero;
            int exchanged = fault(T, 0, i > 0 && i <= n);
            G(printed_elevation)
            (ratio, exchanged ? w_here : w_before, exchanged ? w_before : w_here, R_before, R_here, &weight, &point);
            about(T, "weight and point of the rational curve");
            same(T, we[i], weight);
            same(T, Re[dim * i + c], point);
            about(T, "point of the polynomial curve");
            G(printed_elevation)(ratio, one, one, R_before, R_here, &weight, &point);
            same(T, e[dim * i + c], point);
            num row = zero;
            for (int j = 0; j <= n; j++)
                row = add(row, mul(E[i * (n + 1) + j], R[dim * j + c]));
            same(T, row, point);
        }
}

/*
That the curve stays the same does not determine the new weights and points, for numerator and denominator may be multiplied by any
common linear factor.  If both are to stay as polynomials, the new coefficients are determined, and these are they.

:::{claim} elevation_through_the_power_basis
:title: Elevation of the coefficients leaves the polynomial as it is
:zh: 系数升阶不改变多项式
:given: $b_0,\dots,b_n$
:then: the $n+2$ numbers $\hat b_i=(1-\frac i{n+1})b_i+\frac i{n+1}b_{i-1}$ are the Bernstein coefficients of degree
  $n+1$ of $\sum b_iB_i^n$, and no others are
:method: The polynomial is written in powers of $t$, a coefficient $0$ of $t^{n+1}$ is added, and the powers are written in
  the Bernstein basis of degree $n+1$; that way back is unique.  Applied to the $\omega_i$ and to the $\omega_iR_i$ apart
  this is formula (3.2.8), and (3.2.9) multiplied by its denominator.
:degrees: 1..10 sampled 12
:over: b#: coefficients
:control: the $n+2$ numbers moved up by one place, the first put last
:::
*/
CLAIM(elevation_through_the_power_basis)
{
    int n = T->degree;
    num b[MAX_DEGREE + 1], e[MAX_DEGREE + 2], c[MAX_DEGREE + 2], again[MAX_DEGREE + 2];
    for (int i = 0; i <= n; i++)
        b[i] = unknown(T, "b", i);
    for (int i = 0; i <= n + 1; i++) {
        num low = i > 0 ? mul(from_ratio(i, n + 1), b[i - 1]) : from_int(0);
        e[i] = i <= n ? add(low, mul(from_ratio(n + 1 - i, n + 1), b[i])) : low;
    }
    G(bernstein_to_power)(n, b, c);
    c[n + 1] = from_int(0);
    G(bernstein_from_power)(n + 1, c, again);
    for (int i = 0; i <= n + 1; i++)
        same(T, e[fault(T, i, (i + 1) % (n + 2))], again[i]);
}

/*
:::{claim} numbers_outside_the_polygon_do_not_matter
:title: Whatever stands for the weights and points before the first and behind the last, the ends stay
:zh: 首末之外的权与点取何值都不影响端点
:given: weights and points of any degree $n$, $\omega_0\ne0$ and $\omega_n\ne0$; any numbers $\omega_{-1},\omega_{n+1},R_{-1},R_{n+1}$
:where: $\omega_0\ne0$ and $\omega_n\ne0$
:then: $\hat\omega_0=\omega_0$, $\hat R_0=R_0$, $\hat\omega_{n+1}=\omega_n$, $\hat R_{n+1}=R_n$
:method: Formulas (3.2.8) and (3.2.9) at $i=0$ and $i=n+1$, with $n$, the weights and the points variables.
:degrees: all
:over: n: -; v#: weights; S#: points
:control: $n+1$ taken as $n+2$ in the ratios
:::
*/
CLAIM(numbers_outside_the_polygon_do_not_matter)
{
    num n = whole(T, "n", 1, 20), zero = from_int(0);
    num last = add(n, from_int(1)), count = add(n, from_int(fault(T, 1, 2))), we, Re;
    num w = positive(T, "w", 0), R = unknown(T, "R", 0), w_outside = unknown(T, "v", 0), R_outside = unknown(T, "S", 0);
    about(T, "the first weight and point");
    G(printed_elevation)(div(zero, count), w_outside, w, R_outside, R, &we, &Re);
    same(T, we, w);
    same(T, Re, R);
    about(T, "the last weight and point");
    G(printed_elevation)(div(last, count), w, w_outside, R, R_outside, &we, &Re);
    same(T, we, w);
    same(T, Re, R);
}

/*
## Corners are cut

(3.2.9) has two factors with the sum $1$.  If they are positive, the new vertex is on the edge between two old ones, and everything that is said
about cutting corners follows from this.
The new vertex $\hat R_i$ divides the edge $R_{i-1}R_i$, and the new edge from $\hat R_i$ to $\hat R_{i+1}$ cuts off the
corner $R_i$.

:::{statement} wang-ch3:prop-3.2.6-corner-cutting
:title: Elevation cuts the corners of the polygon
:zh: 升阶的几何意义是割角
:printed: Geometrically (3.2.9) again means that the corners of the B-net are cut.
:holds-by: elevation_cuts_corners numbers_outside_the_polygon_do_not_matter
:needs: elevated_vertex_may_leave_the_edge | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive; otherwise the new vertex may lie outside the edge
:figure: elevation_mixed_weights
:::

:::{claim} elevation_cuts_corners
:title: The new vertex is a mean of the ends of its edge, the new weight a mean of their weights
:zh: 新顶点在边上, 新权因子在两权之间
:given: positive $\omega_{i-1},\omega_i$; $1\le i\le n$, $k=n+1-i$
:then: $\hat R_i=aR_{i-1}+bR_i$ with $a,b>0$, $a+b=1$; $\hat\omega_i=\frac i{n+1}\omega_{i-1}+\frac k{n+1}\omega_i>0$
:method: In the field, with $i$, $k$ and the weights variables: $a+b-1=0$, and $a$, $b$, $\hat\omega_i$ are quotients of
  polynomials all of whose coefficients are positive; so they are positive for all positive values, in every degree.
  Hence, by induction, all weights of all later polygons are positive, and between the least and the largest of the first.
:degrees: all
:over: i k: -; v#: weights; S#: points
:control: $\omega_{i-1}$ taken for $\omega_i$ in the numerator of $b$
:::
*/
CLAIM(elevation_cuts_corners)
{
    num i = whole(T, "i", 1, 12), k = whole(T, "k", 1, 12), count = add(i, k);
    num w_before = positive(T, "v", 0), w = positive(T, "w", 0), we, Re;
    num R_before = unknown(T, "S", 0), R = unknown(T, "R", 0);
    num weight = add(mul(i, w_before), mul(k, w));
    num a = div(mul(i, w_before), weight), b = div(mul(k, fault(T, w, w_before)), weight);
    G(printed_elevation)(div(i, count), w_before, w, R_before, R, &we, &Re);
    about(T, "a + b = 1");
    same(T, add(a, b), from_int(1));
    about(T, "the printed vertex is a R_(i-1) + b R_i");
    same(T, Re, add(mul(a, R_before), mul(b, R)));
    about(T, "the printed weight");
    same(T, we, div(weight, count));
    about(T, "signs");
    G(must_be_positive)(T, a);
    G(must_be_positive)(T, b);
    G(must_be_positive)(T, we);
}

#if RATIONAL
/*
:::{claim} elevated_vertex_may_leave_the_edge
:title: With weights of both signs a corner need not be cut
:zh: 权因子变号时不再是割角
:kind: counterexample
:data: R = (-1,0) (0,1) (1,0); ω = 4 -1 4
:instead: ω = 4 1 4
:result: ω̂ = 4 2/3 2/3 4; R̂ = (-1,0) (-2,-1) (2,-1) (1,0); a = 2; b = -1
:given: the quadratic curve with points $R$ and weights $\omega$, of which the middle one is negative, though $\omega(t)>0$ for all
  $t\in[0,1]$
:then: $\hat R_1=aR_0+bR_1$ with $b<0$: it is not between $R_0$ and $R_1$
:method: $a=\frac{\omega_0}{\omega_0+2\omega_1}$ and $b=\frac{2\omega_1}{\omega_0+2\omega_1}$ are
  computed exactly and asked not to be negative; the kernel gives the same point.
:control: the middle weight made positive
:::
*/
CLAIM(elevated_vertex_may_leave_the_edge)
{
    enum { n = 2 };
    num R[2 * (n + 1)], w[n + 1], we[n + 2], Re[2 * (n + 2)], one = from_int(1);
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    G(rational_elevate)(n, 2, R, w, Re, we);
    found_points(T, "ω̂", n + 2, 1, we);
    found_points(T, "R̂", n + 2, 2, Re);
    /* a = ω_0/(ω_0 + 2 ω_1), b = 1 - a */
    num a = div(w[0], add(w[0], mul(from_int(2), w[1]))), b = sub(one, a);
    found(T, "a", a);
    found(T, "b", b);
    int regular = sign_on(poly_from_bernstein(n, w), from_int(0), one, CLOSED) == SIGN_POSITIVE;
    for (int c = 0; c < 2; c++)
        regular &= equal_q(Re[2 + c], add(mul(a, R[c]), mul(b, R[2 + c])));
    about(T, "for a denominator without zeros in [0,1], elevated R_1 = a R_0 + b R_1 with a, b >= 0");
    refute(T, regular && (sign_q(a) < 0 || sign_q(b) < 0));
}
#endif

/*
:::{statement} wang-ch3:prop-3.2.6-ratios
:title: The ratios depend on the number of the edge and on the weights
:zh: 割角系数依赖于边序号与权因子
:printed: It is only more complicated than the elevation of polynomial Bézier curves: the ratios of cutting depend not only on the number
  of the edge but on the weights $\omega_i$, too.
:holds-by: cutting_ratio_depends_on_edge_and_weights
:needs: elevated_vertex_may_be_at_infinity | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive: so that the ratio exists on every edge

Of the weights only the quotient of the two at the ends of the edge matters.  The ratio is that of the polynomial case on
exactly those edges whose two weights are equal.
:::

For a polynomial curve the ratio on the edge $R_{i-1}R_i$ is $\frac i{n+1}$ and knows the number of the edge only.  A
large weight $\omega_{i-1}$ draws the new vertex towards $R_{i-1}$; how far, the following difference says.

:::{claim} cutting_ratio_depends_on_edge_and_weights
:title: How the ratio of cutting depends on the edge and on the weights
:zh: 割角系数与边序号及权因子的关系
:given: positive $\omega'=\omega_{i-1}$, $\omega=\omega_i$; $1\le i\le n$, $k=n+1-i$
:let: $a(i,k,\omega',\omega)=\frac{i\omega'}{i\omega'+k\omega}$, the coefficient of $R_{i-1}$ in $\hat R_i$
:then: $a-\frac i{n+1}=\frac{ik(\omega'-\omega)}{(n+1)(i\omega'+k\omega)}$; $a$ grows when $\omega'$ grows, and when the
  number $i$ of the edge grows in the same degree, the two weights being the same; $a$ does not change when both weights are multiplied by one number
:method: Identities in the field with $i$, $k$, $\omega'$, $\omega$ and the increments variables; the differences have only
  positive coefficients.
:degrees: all
:over: i k d: -; v# w#: weights
:control: $\omega$ and $\omega'$ exchanged in the difference from $i/(n+1)$
:::
*/
/* a(i, k, w', w) = i w' / (i w' + k w) */
static num G(cutting_ratio)(num i, num k, num w_before, num w)
{
    return div(mul(i, w_before), add(mul(i, w_before), mul(k, w)));
}

CLAIM(cutting_ratio_depends_on_edge_and_weights)
{
    num one = from_int(1), i = whole(T, "i", 1, 12), k = whole(T, "k", 1, 12), count = add(i, k);
    num v = positive(T, "v", 0), w = positive(T, "w", 0), d = positive(T, "d", 0);
    num a = G(cutting_ratio)(i, k, v, w), difference = fault(T, sub(v, w), sub(w, v));
    about(T, "difference from the polynomial ratio");
    /* a - i/(n+1) = ik (ω' - ω)/((n+1)(iω' + kω)) */
    same(T, sub(a, div(i, count)), div(mul(mul(i, k), difference), mul(count, add(mul(i, v), mul(k, w)))));
    about(T, "a larger weight before");
    G(must_be_positive)(T, sub(G(cutting_ratio)(i, k, add(v, d), w), a));
    about(T, "the next edge: i+1 and k-1, here with k+1 and k");
    G(must_be_positive)(T, sub(G(cutting_ratio)(add(i, one), k, v, w), G(cutting_ratio)(i, add(k, one), v, w)));
    about(T, "both weights multiplied");
    same(T, G(cutting_ratio)(i, k, mul(d, v), mul(d, w)), a);
}

/*
:::{statement} wang-ch3:prop-3.2.6-for-ever
:title: Elevation can be repeated for ever
:zh: 升阶可无限次进行
:printed: In the same way elevation can be repeated without end.
:holds-by: elevation_cuts_corners numbers_outside_the_polygon_do_not_matter repeated_elevation_in_one_formula
:confirmed-by: repeated_elevation_computed mixed_weights_become_positive
:needs: elevated_vertex_may_be_at_infinity | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive; with mixed ones already the first step may fail
:figure: elevation_mixed_weights

Positive weights stay positive, since every new one is a mean of two old ones or, at the two ends, an old one.
:::

All steps together have a closed form.  Its coefficients are those of drawing without replacement: if $i$ things are
taken out of $n+m$, of which $n$ are marked, then $\binom nj\binom m{i-j}/\binom{n+m}i$ is the probability that $j$ of
them are.

:::{claim} repeated_elevation_in_one_formula
:title: All elevations at once
:zh: 多次升阶的统一公式
:given: $n,m\ge0$, $0\le j\le n$
:let: $c_j(i,m)=\binom nj\binom m{i-j}/\binom{n+m}i$, $i=0,\dots,n+m$, binomial coefficients outside their range being $0$
:then: $c_j(i,m+1)=(1-\frac i{n+m+1})\,c_j(i,m)+\frac i{n+m+1}\,c_j(i-1,m)$, and $c_j(i,0)$ is $1$ for $i=j$, else $0$; so
  after $m$ steps $\hat\omega_i=\sum_jc_j(i,m)\omega_j$ and $\hat\omega_i\hat R_i=\sum_jc_j(i,m)\omega_jR_j$
:method: Induction on $m$: both sides are divided by $\binom nj$, $p=i-j$, and every binomial coefficient is written as a
  quotient times $\binom mp$ or $\binom{n+m}i$, by the definition with factorials.  $N=n+m$, $i$, $m$, $p$ are variables.
  The two ends of the range, $p=0$ and $p=m+1$, where a quotient would be $0/0$, are compared by themselves, and so is the last
  point, $i=N+1$, where $p=m+1$ and all three binomial coefficients that are left are 1.
:degrees: all
:over: i r p q b c: -
:control: $\frac i{n+m+1}$ taken as $\frac i{n+m}$
:::
*/
CLAIM(repeated_elevation_in_one_formula)
{
    num one = from_int(1), i = whole(T, "i", 1, 9), j = whole(T, "r", 1, 9);
    num p = whole(T, "p", 1, 6), m = add(p, whole(T, "q", 1, 6));
    num N = add(i, j), next = add(N, one), count = fault(T, next, N);
    num share = div(i, count), rest = sub(one, share);
    num up = positive(T, "b", 0), down = positive(T, "c", 0); /* C(m,p) and C(N,i) */

    about(T, "inside the range, 0 < p < m + 1");
    /* (1 - i/(N+1)) C(m,p)/C(N,i) + i/(N+1) C(m,p-1)/C(N,i-1) = C(m+1,p)/C(N+1,i) */
    num up_before = div(mul(up, p), sub(add(m, one), p));         /* C(m, p-1)   */
    num down_before = div(mul(down, i), add(sub(N, i), one));     /* C(N, i-1)   */
    num up_next = div(mul(up, add(m, one)), sub(add(m, one), p)); /* C(m+1, p) */
    num down_next = div(mul(down, next), sub(next, i));           /* C(N+1, i) */
    same(T, add(mul(rest, div(up, down)), mul(share, div(up_before, down_before))), div(up_next, down_next));

    about(T, "p = 0: C(m,-1) = 0");
    same(T, mul(rest, div(one, down)), div(one, down_next));

    about(T, "p = m + 1: C(m,m+1) = 0");
    same(T, mul(share, div(one, down_before)), div(one, down_next));

    about(T, "i = N + 1: C(N,N+1) = 0, C(N,N) = C(N+1,N+1) = 1");
    same(T, mul(div(next, count), div(one, one)), div(one, one));
}

/*
:::{claim} repeated_elevation_computed
:title: Elevation step by step gives the one formula
:zh: 逐次升阶与统一公式一致
:given: weights and points of degree $n$; $m=1,2,3,4$ steps
:then: $\hat\omega_i=\sum_j\binom nj\binom m{i-j}\omega_j/\binom{n+m}i$, and the same for $\hat\omega_i\hat R_i$ with
  $\omega_jR_j$
:method: The steps are taken with the weights and points variables and compared with the formula.
:degrees: 1..5 sampled 8
:control: $\binom m{i-j}$ taken as $\binom{m+1}{i-j}$
:::
*/
CLAIM(repeated_elevation_computed)
{
    enum { STEPS = 4 };
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], we[MAX_DEGREE + 1], Re[MAX_DEGREE + 1];
    num wn[MAX_DEGREE + 1], Rn[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++) {
        w[i] = we[i] = positive(T, "w", i);
        R[i] = Re[i] = unknown(T, "R", i);
    }
    for (int m = 1; m <= STEPS; m++) {
        G(rational_elevate)(n + m - 1, 1, Re, we, Rn, wn);
        for (int i = 0; i <= n + m; i++) {
            we[i] = wn[i];
            Re[i] = Rn[i];
            num weight = from_int(0), point = from_int(0);
            for (int j = 0; j <= n; j++) {
                num c = from_ratio(binomial(n, j) * binomial(fault(T, m, m + 1), i - j), binomial(n + m, i));
                weight = add(weight, mul(c, w[j]));
                point = add(point, mul(c, mul(w[j], R[j])));
            }
            same(T, we[i], weight);
            same(T, mul(we[i], Re[i]), point);
        }
    }
}

/*
## The polygons converge

The polygon of degree $N$ is compared with the curve at the parameters $i/N$.  In degree $N$ the power $t^k$ has the
coefficients $\binom ik/\binom Nk=\prod_{l<k}\frac{i-l}{N-l}$, and each of these factors differs from $i/N$ by at most
$\frac l{N-l}$.  So for a polynomial $f=\sum_{k\le n}c_kt^k$ with coefficients $f_i^N$ in degree $N$

$$\left|f_i^N-f(i/N)\right|\le\frac{K_f}{N-n+1},\qquad K_f=\sum_{k=2}^n\frac{k(k-1)}2|c_k|,$$

for every $N\ge n$ and every $i$.  For the rational curve this is used in the numerator and in the denominator.

:::{statement} wang-ch3:prop-3.2.6-convergence
:title: The elevated polygons converge to the curve
:zh: 升阶多边形序列收敛到曲线
:printed: The sequence of the elevated B-nets converges to $\mathbf R(t)$.
:holds-by: elevated_polygons_converge powers_in_every_degree elevation_cuts_corners
  numbers_outside_the_polygon_do_not_matter
:confirmed-by: elevated_parabola_misses_by_one_over_degree elevated_polygons_within_their_bound mixed_weights_become_positive
:argued: | The bounds (1) to (4) of `elevated_polygons_converge` are put together in words: a product of $k$ factors
  is estimated factor by factor, the sums over $k$ are formed, and between two vertices polygon and curve are as near,
  since $\mathbf R$ has a bounded derivative; the bound $\frac{\text{const}}{N-n+1}$ tends to 0.
:needs: elevation_fails_at_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive: so that no polygon of the sequence lacks a vertex, and $\omega(t)$ has no zero in $[0,1]$; with a zero, as here,
  polygons of ever higher degrees may lack one
:figure: elevation_converges

The convergence is uniform and of order $1/N$, not better: for the parabola $y=x^2$ the $i$-th vertex is exactly
$x(1-x)/(N-1)$ below the curve at $x=i/N$ (`elevated_parabola_misses_by_one_over_degree`); `elevated_polygons_within_their_bound` compares other curves with the bound.
Weights of both signs with $\omega(t)>0$ on $[0,1]$ only delay the convergence: by the same estimate, with $\omega$ for $f$, all weights of a high degree are positive,
and at most finitely many polygons lack a vertex (`mixed_weights_become_positive` is an example).
:::

First the coefficients of a power of $t$ in degree $N$.  They are written down and proved by raising them once more.

:::{claim} powers_in_every_degree
:title: The Bernstein coefficients of a power of t in every degree
:zh: 幂函数在各次 Bernstein 基下的系数
:given: $0\le k\le N$
:then: $t^k=\sum_{i=0}^N\binom ik\binom Nk^{-1}B_i^N(t)$
:method: Induction on $N$.  For $N=k$ the right side is $B_k^k=t^k$.  From $N$ to $N+1$ the coefficients are elevated:
  $(1-\frac i{N+1})\binom ik+\frac i{N+1}\binom{i-1}k$ must be $\binom ik\binom Nk/\binom{N+1}k$, where
  $\binom{i-1}k=\frac{i-k}i\binom ik$ and $\binom{N+1}k=\frac{N+1}{N+1-k}\binom Nk$.  Here $i$, $k$, $N$ and $\binom ik$
  are variables, $i\ge1$; for $i=0$ both sides have the only factor $\binom0k$, which is compared too.  Outside the field
  $i$, $k$ and $N$ are random integers, and a true power, elevated by the kernel, is compared as well.
:degrees: all
:over: i k r c: -
:control: $i-k$ taken as $i-k+1$
:::
*/
CLAIM(powers_in_every_degree)
{
    num one = from_int(1);
#if FIELD
    num i = whole(T, "i", 1, 9), k = whole(T, "k", 0, 5), N = add(add(i, k), whole(T, "r", 1, 9));
    num choose = unknown(T, "c", 0); /* C(i,k), a common factor */
#else
    int index = pick(T, 1, 9), exponent = pick(T, 0, 5), degree = index + exponent + pick(T, 1, 5);
    num i = from_int(index), k = from_int(exponent), N = from_int(degree), choose = from_int(binomial(index, exponent));
    num power[2][MAX_DEGREE + 2];
    for (int j = 0; j <= exponent; j++) /* t^k in degree k */
        power[exponent % 2][j] = from_int(j == exponent);
    for (int n = exponent; n < degree; n++)
        G(bezier_elevate)(n, 1, power[n % 2], power[(n + 1) % 2]);
    about(T, "the elevated power");
    for (int j = 0; j <= degree; j++)
        same(T, power[degree % 2][j], from_ratio(binomial(j, exponent), binomial(degree, exponent)));
    about(T, "from one degree to the next");
#endif
    num next = add(N, one);
    num fewer = fault(T, sub(i, k), add(sub(i, k), one));
    num before = div(mul(choose, fewer), i), ratio = div(i, next);
    num wanted = div(mul(choose, sub(next, k)), next);
    same(T, add(mul(sub(one, ratio), choose), mul(ratio, before)), wanted);
    about(T, "i = 0: C(0,k) is 0 unless k = 0, and then both factors are 1");
    same(T, sub(one, div(from_int(0), next)), div(sub(next, from_int(0)), next));
}

/*
:::{claim} elevated_polygons_converge
:title: Elevated polygons converge to the curve, with an error of at most a constant over the degree
:zh: 升阶多边形以 1/N 的阶收敛
:given: positive weights; $N\ge n$, $x=i/N$, $0\le i\le N$
:where: the weights are positive
:let: $K_f=\sum_k\frac{k(k-1)}2|c_k|$ for a polynomial $f=\sum_kc_kt^k$; here of $\omega(t)$ and of a coordinate of $\omega(t)R(t)$
:then: the vertex $\hat R_i$ of degree $N$ has
  $|\hat R_i-R(x)|\le\frac{K_{\omega R}+|R(x)|K_\omega}{(N-n+1)\min_j\omega_j}$ in each coordinate
:method: In the field, with $i,N,l,k$ variables and positive differences between them:
  (1) $0\le x-\frac{i-l}{N-l}=\frac{l(N-i)}{N(N-l)}\le\frac l{N-l}$ for $l<i$, and for $i\le l$, where the product is $0$ and its
  factor is replaced by $0$, $x\le\frac l{N-l}$; (2) $\frac l{N-l}\le\frac l{N-k+1}$ for $l<k$; (3) $Aa-Bb=(A-B)a+B(a-b)$, so
  that products of $k$ factors of $[0,1]$ differ by at most the sum of the differences of the factors, here
  $\sum_{l<k}\frac l{N-k+1}$, which is $\frac{k(k-1)}{2(N-k+1)}$; (4) $\frac{\hat P}{\hat\omega}-\frac P\omega=
  \frac{(\hat P-P)-\frac P\omega(\hat\omega-\omega)}{\hat\omega}$, and $\hat\omega\ge\min\omega_j$ because every elevated weight is
  a mean of earlier ones.  Between the vertices the polygon is as near, since $R$ has a bounded derivative.
:degrees: all
:over: A# B#: points; a b: -; w# we#: weights; p r s l j q: -
:control: $N(N-l)$ in (1) taken as $N^2$
:::
*/
CLAIM(elevated_polygons_converge)
{
    num p = whole(T, "p", 1, 5), r = whole(T, "r", 1, 9), l = whole(T, "l", 1, 4);

    about(T, "(1), l < i");
    num beyond_i = whole(T, "s", 0, 9), i = add(l, p), N = add(i, beyond_i), x = div(i, N);
    num gap = sub(x, div(sub(i, l), sub(N, l)));
    same(T, gap, div(mul(l, beyond_i), mul(N, fault(T, sub(N, l), N))));
    nonnegative(T, gap);
    nonnegative(T, sub(div(l, sub(N, l)), gap));

    about(T, "(1), i <= l");
    num early = whole(T, "j", 0, 3), beyond = whole(T, "q", 0, 3), late = add(early, beyond), M = add(late, r);
    nonnegative(T, sub(div(late, sub(M, late)), div(early, M)));

    about(T, "(2)");
    num below = whole(T, "q", 0, 3), k = add(add(l, below), from_int(1)), L = add(sub(k, from_int(1)), r);
    nonnegative(T, sub(div(l, add(sub(L, k), from_int(1))), div(l, sub(L, l))));

    about(T, "(3)");
    num A = unknown(T, "A", 0), a = unknown(T, "a", 0), B = unknown(T, "B", 0), b = unknown(T, "b", 0);
    same(T, sub(mul(A, a), mul(B, b)), add(mul(sub(A, B), a), mul(B, sub(a, b))));

    about(T, "(4)");
    num w = positive(T, "w", 0), we = positive(T, "we", 0), R = div(A, w);
    same(T, sub(div(B, we), R), div(sub(sub(B, A), mul(R, sub(we, w))), we));
}

/*
An upper bound may be too large.  For the parabola nothing has to be estimated, and the error is of the order of the bound; so no
better power of $N$ can be had in general.

:::{claim} elevated_parabola_misses_by_one_over_degree
:title: The order 1/N is not better for the parabola
:zh: 抛物线的升阶误差恰为 1/N 阶
:given: $y=x^2$, all weights $1$, degree $N\ge2$
:then: the $i$-th vertex is $(x,\,x^2-\frac{x(1-x)}{N-1})$ with $x=i/N$
:method: The coefficients of $t$ and $t^2$ in degree $N$ are $\frac iN$ and $\frac{i(i-1)}{N(N-1)}$ by `powers_in_every_degree`; $i$ and $N$
  are variables.
:degrees: all
:over: i; r: -
:control: $N-1$ taken as $N$
:::
*/
CLAIM(elevated_parabola_misses_by_one_over_degree)
{
    num one = from_int(1), i = whole(T, "i", 0, 9);
    num N = add(add(i, whole(T, "r", 0, 9)), from_int(2)), x = div(i, N);
    num y = div(mul(i, sub(i, one)), mul(N, sub(N, one)));
    /* x² - y_i = x (1 - x)/(N-1) */
    same(T, sub(mul(x, x), y), div(mul(x, sub(one, x)), fault(T, sub(N, one), N)));
}

#if RATIONAL
/*
The bound is compared with computed errors.  That of the second curve is shown multiplied by $N$.

:::{claim} elevated_polygons_within_their_bound
:title: Computed elevations stay within the bound
:zh: 升阶误差的实际界
:kind: decision
:data: R (1) = (1,0) (1,1) (0,1); ω (1) = 1 1 2; R (2) = (-1,0) (0,1) (1,0); ω (2) = 1 3 1; R (3) = (0,0) (3,1) (1,4); ω (3) = 1 100 1;
  R (4) = (0,0) (3,1) (1,4); ω (4) = 1 1/100 1; R (5) = (0,0) (0,3) (3,3) (3,0); ω (5) = 1 5 1/5 1; R (6) = (0,0) (5,1) (-4,2) (1,3);
  ω (6) = 1/50 1 50 1/3; N = 32
:given: four quadratics and two cubics of the plane with points $R$ and positive weights $\omega$, which are about equal, large or small in the
  middle, and mixed; all degrees from $n+1$ to $N$
:then: every vertex is within the bound of `elevated_polygons_converge`
:method: The curves are elevated step by step with rational numbers; every vertex of every degree $N$ is compared with $R(i/N)$.
  For the second curve the largest error is shown, multiplied by $N$.
:scope: the six curves, degrees up to 32
:control: the bound divided by $N-n+1$ once more, as if the error were of order $1/N^2$
:::
*/
static num_q magnitude(num_q a) { return sign_q(a) < 0 ? neg_q(a) : a; }
static num_q larger(num_q a, num_q b) { return compare_q(a, b) < 0 ? b : a; }

/* K_f = sum_k k(k-1)/2 |c_k| for f = sum b_i B_i^n = sum c_k t^k. */
static num_q curving(int n, const num_q b[])
{
    num_q c[MAX_DEGREE + 1], sum = from_int_q(0);
    bernstein_to_power_q(n, b, c);
    for (int k = 2; k <= n; k++)
        sum = add_q(sum, mul_q(from_int_q(k * (k - 1) / 2), magnitude(c[k])));
    return sum;
}

CLAIM(elevated_polygons_within_their_bound)
{
    enum { MOST = 32, CURVES = 6 };
    static const int degree[CURVES] = {2, 2, 2, 2, 3, 3};
    int last = given_whole(T, "N");
    for (int example = 0; example < CURVES; example++) {
        int n = degree[example];
        char name[24];
        num w[4], R[8], we[MOST + 1], Re[2 * (MOST + 1)], wn[MOST + 1], Rn[2 * (MOST + 1)], K[3], least;
        snprintf(name, sizeof name, "R (%d)", example + 1);
        given_points(T, name, n + 1, 2, R);
        snprintf(name, sizeof name, "ω (%d)", example + 1);
        given_points(T, name, n + 1, 1, w);
        for (int i = 0; i <= n; i++) {
            we[i] = w[i];
            least = i == 0 || compare_q(w[i], least) < 0 ? w[i] : least;
            for (int c = 0; c < 2; c++)
                Re[2 * i + c] = R[2 * i + c];
        }
        for (int c = 0; c < 3; c++) {
            num b[4];
            for (int i = 0; i <= n; i++)
                b[i] = c < 2 ? mul(w[i], R[2 * i + c]) : w[i];
            K[c] = curving(n, b);
        }
        for (int N = n + 1; N <= last && last <= MOST; N++) {
            G(rational_elevate)(N - 1, 2, Re, we, Rn, wn);
            num worst = from_int(0);
            for (int i = 0; i <= N; i++) {
                num P[2];
                we[i] = wn[i];
                G(rational_point)(n, 2, R, w, from_ratio(i, N), P);
                for (int c = 0; c < 2; c++) {
                    Re[2 * i + c] = Rn[2 * i + c];
                    num error = magnitude(sub(Re[2 * i + c], P[c]));
                    /* |R̂_i - R(i/N)| <= (K_{ωR} + |R(i/N)| K_ω)/((N-n+1) min ω_j) */
                    num bound = div(add(K[c], mul(magnitude(P[c]), K[2])), mul(from_int(N - n + 1), least));
                    bound = fault(T, bound, div(bound, from_int(N - n + 1)));
                    agree(T, compare_q(error, bound) <= 0);
                    worst = larger(worst, error);
                }
            }
            if (example == 1 && (N & (N - 1)) == 0)
                show_text(T, "N · error", "%.3f for N = %d", N * to_double_q(worst), N);
        }
    }
}

/* The weights w of degree n raised to degree N <= 20. */
static void raised_weights(int n, const num_q w[], int N, num_q out[])
{
    num_q b[21];
    for (int i = 0; i <= n; i++)
        out[i] = w[i];
    for (int k = n; k < N; k++) {
        for (int i = 0; i <= k; i++)
            b[i] = out[i];
        bezier_elevate_q(k, 1, b, out);
    }
}

/*
What if some weights are not positive?  The weights of degree $N$ are near the values $\omega(i/N)$, by the estimate
above with $\omega$ for $f$.  A denominator that is positive on $[0,1]$ so has positive weights in the end, whatever
happens on the way.

:::{claim} mixed_weights_become_positive
:title: Elevated weights of a positive denominator may become positive
:zh: 正分母的权因子在高次时皆正
:kind: decision
:data: ω = 2 -1 2; N = 5
:instead: N = 4
:result: elevated ω of degree 3 = 2 0 0 2; elevated ω of degree 4 = 2 1/2 0 1/2 2; elevated ω of degree 5 = 2 4/5 1/5 1/5 4/5 2
:given: weights $\omega$ of degree $2$, of which the middle one is negative
:then: in the degrees between $2$ and $N$ some elevated weight is $0$; those of degree $N$ are all positive, and so
  are then those of every later degree
:method: Elevated exactly; a mean of positive numbers is positive.
:scope: the weights 2, -1, 2
:control: the degree before taken for $N$
:::
*/
CLAIM(mixed_weights_become_positive)
{
    num w[3], we[21];
    given_points(T, "ω", 3, 1, w);
    int last = given_whole(T, "N");
    for (int N = 3; N <= last; N++) {
        int zero = 0, positive_ones = 0;
        char name[40];
        raised_weights(2, w, N, we);
        for (int i = 0; i <= N; i++) {
            zero += is_zero_q(we[i]);
            positive_ones += sign_q(we[i]) > 0;
        }
        snprintf(name, sizeof name, "elevated ω of degree %d", N);
        found_points(T, name, N + 1, 1, we);
        agree(T, N < last ? zero > 0 : positive_ones == N + 1);
    }
}

/*
A denominator with a zero gives no such hope.  For $\omega(t)=1-2t$ the weights of degree $N$ are exactly the values
$1-2i/N$, and in every even degree one of these is the value at the zero.

:::{claim} elevation_fails_at_a_pole
:title: If the denominator vanishes, an elevated polygon may lack a vertex
:zh: 分母有零点时, 升阶多边形可缺顶点
:kind: counterexample
:data: ω = 1 -1; t = 1/2; N = 20
:instead: ω = 1 1
:result: ω(t) = 0; elevated ω of degree 2 = 1 0 -1; elevated ω of degree 4 = 1 1/2 0 -1/2 -1; polygons that lack a vertex = 10
:given: a curve of degree $1$ whose weights are opposite, so that $\omega(t)=0$; the even degrees from $2$ to $N$
:then: in each of these degrees the vertex in the middle has the weight $0$
:method: The weights are elevated exactly; it is asked that one of these polygons have all its vertices.
:control: the second weight made positive
:::
*/
CLAIM(elevation_fails_at_a_pole)
{
    num w[2], we[21];
    int lacking = 0;
    given_points(T, "ω", 2, 1, w);
    num t = given(T, "t");
    int last = given_whole(T, "N");
    found(T, "ω(t)", G(rational_weight)(1, w, t));
    for (int N = 2; N <= last; N += 2) {
        raised_weights(1, w, N, we);
        if (N == 2)
            found_points(T, "elevated ω of degree 2", N + 1, 1, we);
        else if (N == 4)
            found_points(T, "elevated ω of degree 4", N + 1, 1, we);
        lacking += is_zero_q(we[N / 2]);
    }
    found_whole(T, "polygons that lack a vertex", lacking);
    about(T, "some polygon of even degree has all its vertices");
    agree(T, lacking < last / 2);
}
#endif

#include "chapters/judge/claims_off.h"
