/*
# Cutting corners (割角)

In the triangle of the last section each point $R_i^r$ lies on an edge of the level before.  Passing from one level to the
next therefore cuts the corners of a polygon, and after $n$ levels one point is left, the point of the curve.  For a
polynomial curve every edge is cut in the ratio $\lambda:1-\lambda$.  Here the weights at the two ends of the edge take
part in the ratio, and the question of this section is what becomes of the cutting: whether the new points stay on their
edges, and on what the ratio depends.
*/
#include "exact/record/roots.h"

#include "chapters/judge/elementary.h"
#include "chapters/rational-bezier/free-curve.h"

#include "chapters/judge/claims_on.h"

/*
## Equal weights

:::{statement} wang-ch3:rem-3.3.1-generalises
:title: The theorem generalises the polynomial one
:zh: 多项式情形的推广
:printed: This theorem is a generalisation of theorem 1.4.1.
:holds-by: equal_weights_stay_equal triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power
:confirmed-by: equal_weights_give_polynomial_triangle
:meant: the formulas of theorem 3.3.1, as theorem 1.4.1 is not in the text at hand | Theorem 1.4.1 says that the triangle of de Casteljau gives the
  two parts of a polynomial curve.

Theorem 1.4.1 is the case of equal weights.  Only (3.3.2) and (3.3.3) are used, and not the display of theorem 3.3.1 with its slip.
:::

:::{claim} equal_weights_stay_equal
:title: Equal weights stay equal on every level, and the points are then cut as in de Casteljau's triangle
:zh: 权相等时各层权仍相等, 割角与多项式情形相同
:given: two neighbouring weights $\omega\ne0$ of any level, their points $R$ and $S$, and $\lambda$
:where: the common weight is not 0
:then: $(1-\lambda)\omega+\lambda\omega=\omega$ and $\frac{(1-\lambda)\omega}\omega R+\frac{\lambda\omega}\omega S=(1-\lambda)R+\lambda S$
:method: The step of an induction on the level, for (3.3.2) and (3.3.3) with all weights equal; $\omega$, $\lambda$ and one coordinate of the points are variables.
:degrees: all
:over: w#: weights; R# S#: points; lambda
:control: the second weight doubled
:::
*/
CLAIM(equal_weights_stay_equal)
{
    num w = positive(T, "w", 0), other = fault(T, w, add(w, w)), lambda = parameter(T, "lambda"),
        mu = sub(from_int(1), lambda);
    num R = unknown(T, "R", 0), S = unknown(T, "S", 0), left = mul(mu, w), right = mul(lambda, other),
        v = add(left, right);
    about(T, "the weight");
    same(T, v, w);
    about(T, "the point");
    same(T, add(mul(div(left, v), R), mul(div(right, v), S)), add(mul(mu, R), mul(lambda, S)));
}

/*
The same for whole triangles of low degree:

:::{claim} equal_weights_give_polynomial_triangle
:title: For equal weights the triangle is de Casteljau's
:zh: 权相等时即 de Casteljau 三角阵
:given: points $R_0,\dots,R_n$ with one weight $\omega\ne0$, and $\lambda$
:where: the common weight is not 0
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
:printed: From it one can also derive the recursive formula of evaluation of rational Bézier curves and the theorem of their geometric construction.
:holds-by: triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power weighted_points_are_cut_like_the_weights
  cut_coefficients_are_convex
:confirmed-by: triangle_ends_on_the_curve triangle_level_by_level
:needs: intermediate_weight_can_vanish | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive: otherwise a point of the construction may be missing
:needs: cut_outside_can_fail | theorem 3.3.1: $c\in(a,b)$ | $c\in(a,b)$; the ends do no harm, but outside $[a,b]$ a weight of the triangle may
  vanish although all $\omega_i>0$

The evaluation is $\mathbf R(c)=\mathbf R_n^n(c)$; the construction divides each edge in the ratio
$\lambda\omega_i^{r-1}:(1-\lambda)\omega_{i-1}^{r-1}$.
:::

:::{claim} triangle_ends_on_the_curve
:title: The last point of the triangle is the point of the curve
:zh: 三角阵末点即曲线上的点
:given: positive weights, points $R_0,\dots,R_n$, $\lambda$
:where: the weights are positive
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
    G(free_curve)(T, n, 1, R, w);
    G(bernstein_basis)(n, lambda, B);
    for (int i = 0; i <= n; i++) {
        num share = mul(B[i], w[i]);
        down = add(down, share);
        up = add(up, mul(share, R[fault(T, i, i == n ? n - 1 : i)]));
    }
    G(rational_casteljau)(n, 1, R, w, lambda, n, &P, &v);
    same(T, v, down);
    /* R_n^n = Σ B_i^n(λ) ω_i R_i / Σ B_i^n(λ) ω_i */
    same(T, P, div(up, down));
}

/*
The new point divides its edge in the ratio $\lambda\omega_i^{r-1}:(1-\lambda)\omega_{i-1}^{r-1}$.  While both weights
have one sign it lies between the old points, drawn towards the heavier one.  The new weight is itself a mean of the
two old ones; so positive weights stay positive through all levels, and looking at $\omega_0,\dots,\omega_n$ once
answers for the whole triangle.  With a negative weight one step is enough to leave the edge, and the curve need not
have a pole for that.

:::{statement} wang-ch3:rem-3.3.1-convex
:title: Each new point is a convex combination of two old ones
:zh: 凸线性组合
:printed: By (3.3.3), $\mathbf R_i^r(c)$ is a convex linear combination of $\mathbf R_{i-1}^{r-1}(c)$ and $\mathbf
  R_i^{r-1}(c)$.
:holds-by: cut_coefficients_are_convex
:needs: negative_weight_breaks_convexity | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive: otherwise a coefficient may be negative although $\omega(t)$ has no real zero
:needs: cut_outside_has_a_negative_coefficient | theorem 3.3.1: $c\in(a,b)$ | $c\in(a,b)$; the ends do no harm, but outside $[a,b]$ a coefficient
  may be negative although all $\omega_i>0$
:figure: cut_leaves_the_edge
:::

:::{statement} wang-ch3:rem-3.3.1-cutting
:title: Geometrically the theorem cuts corners, level after level
:zh: 几何意义:递归割角
:printed: Hence the geometric meaning of the theorem is again recursive corner cutting.
:holds-by: cut_coefficients_are_convex weighted_points_are_cut_like_the_weights triangle_of_powers_consists_of_powers
  bernstein_sum_of_powers_is_a_power
:confirmed-by: triangle_level_by_level
:needs: negative_weight_breaks_convexity | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive
:needs: cut_outside_has_a_negative_coefficient | theorem 3.3.1: $c\in(a,b)$ | $c\in(a,b)$; the ends do no harm, but outside $[a,b]$ a coefficient
  may be negative although all $\omega_i>0$
:::

:::{claim} cut_coefficients_are_convex
:title: Between positive weights the coefficients are positive with sum 1
:zh: 割角系数为正且和为一
:given: two neighbouring weights $p,q>0$ of any level, $0\le\lambda\le1$
:let: $v=(1-\lambda)p+\lambda q$
:then: $v>0$; $(1-\lambda)p/v>0$, $\lambda q/v>0$ for $0<\lambda<1$, with sum $1$; and $(v-p)(q-v)=\lambda(1-\lambda)(q-p)^2\ge0$, so
  that $v$ lies between $p$ and $q$
:method: With $\lambda=s/(1+s)$, $s>0$, all coefficients are positive; for $\lambda=0$ and $\lambda=1$ it is $v=p$ and $v=q$.  By induction on the level all $\omega_i^r$
  are positive, for every $n$, and none is less than the least or more than the largest $\omega_i$.
:scope: every point of division
:over: p# q#: weights; s: -
:control: the second coefficient with $1-\lambda$ for $\lambda$
:degrees: all
:::
*/
CLAIM(cut_coefficients_are_convex)
{
    num p = positive(T, "p", 0), q = positive(T, "q", 0), lambda = inside(T, "s"), mu = sub(from_int(1), lambda);
    num left = mul(mu, p), right = mul(lambda, q), v = add(left, right), gap = sub(q, p);
    num first = div(left, v), second = div(fault(T, right, mul(mu, q)), v);
    G(must_be_positive)(T, v);
    G(must_be_positive)(T, first);
    G(must_be_positive)(T, second);
    same(T, add(first, second), from_int(1));
    about(T, "λ = 0 and λ = 1");
    num none = from_int(0), whole_share = from_int(1);
    same(T, add(mul(whole_share, p), mul(none, q)), p);
    same(T, add(mul(none, p), mul(whole_share, q)), q);
    about(T, "between the two");
    /* (v - p)(q - v) = λ (1-λ) (q - p)² */
    same(T, mul(sub(v, p), sub(q, v)), mul(mul(lambda, mu), mul(gap, gap)));
}

#if RATIONAL
/*
:::{claim} cut_outside_has_a_negative_coefficient
:title: Outside the interval the point of the triangle leaves its edge though the weights are positive
:zh: 分割点在区间外时割角点离开边
:kind: decision
:data: ω = 1 1; c = -1
:instead: c = 1/2
:result: coefficients of R_0, R_1 = 2 -1
:given: two positive weights $\omega$, $[a,b]=[0,1]$, and a parameter $c$ outside
:then: in $R_1^1$ the point $R_1$ has a negative coefficient
:method: The coefficients are $R_1^1$ for the points $1,0$ and $0,1$ of the line.
:control: $c$ in the middle of the interval
:::
*/
CLAIM(cut_outside_has_a_negative_coefficient)
{
    num w[2], share[2], v[2], P[2];
    given_points(T, "ω", 2, 1, w);
    num c = given(T, "c");
    for (int k = 0; k < 2; k++) {
        num R[2] = {from_int(k == 0), from_int(k == 1)};
        G(rational_casteljau)(1, 1, R, w, c, 1, P, v);
        share[k] = P[0];
    }
    found_points(T, "coefficients of R_0, R_1", 2, 1, share);
    about(T, "R_1^1 lies outside the edge, before R_0");
    agree(T, sign_q(share[1]) < 0);
}

/*
:::{claim} negative_weight_breaks_convexity
:title: With a negative weight a point of the triangle can leave its edge
:zh: 异号权时割角点离开边
:kind: decision
:data: ω = 1 -1/4 1; λ = 1/2
:instead: ω = 1 1/4 1
:result: real zeros of ω(t) = 0; coefficients of R_0, R_1 = 4/3 -1/3
:given: three weights $\omega$, the middle one negative, and $\lambda$ in the middle
:then: $\omega(t)>0$ for every real $t$, but in $R_1^1$ the point $R_1$ has a negative coefficient, and $R_0$ one above 1
:method: The roots of $\omega(t)$ are counted exactly; the coefficients are $R_1^1$ for the points $1,0$ and $0,1$ of
  the line.
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
    agree(T, zeros == 0 && sign_q(w[0]) > 0);
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
For a polynomial curve one ratio is marked on a strip of paper and copied to all edges of all levels.  Here the strip
would have to be marked anew for each edge.  One triangle with three weights shows that parameter, level, edge and weights matter
each by itself: the coefficients that are compared differ in one of the four only.  There are weights for which the
strip still serves, and they are found by asking when two neighbouring edges are cut alike: the geometric sequences.

:::{statement} wang-ch3:rem-3.3.1-coefficients
:title: The cut depends on level, edge and weights, not on the parameter alone
:zh: 割角系数的依赖关系
:printed: But it should be noted that the cut coefficients depend here not only on the parameter $\lambda$ of the point of division, but also on the level of cutting of the
  polygon, the number $i$ of the edge and the weights $\omega_i$.
:holds-by: cut_depends_on_level_edge_and_weights
:example: that a number depends on something is shown by one instance in which it changes with that alone; here there is one for each of parameter, level, edge and weights.
:reading: geometric_weights_cut_evenly | the number of the edge matters, on level 1 already, for all weights but the geometric ones
  $\omega_i=\omega_0q^i$; for these, equal ones among them, one ratio cuts all edges of all levels, as for polynomials
:::

:::{claim} cut_depends_on_level_edge_and_weights
:title: Each of parameter, level, edge and weights changes the ratio
:zh: 参数、层数、边序号、权均影响割角系数
:kind: decision
:data: ω = 1 1 2; other ω = 1 1 1; λ = 1/2; other λ = 1/3
:instead: ω = 1 1 1
:result: α_2^1 = 2/3; α_2^1 at the other λ = 1/2; α_1^1 = 1/2; α_2^2 = 3/5; α_2^1 of the other ω = 1/2
:given: two triples of weights, $\lambda$ in the middle, and another $\lambda$
:let: $\alpha_i^r=\lambda\omega_i^{r-1}/\omega_i^r$, the coefficient of the second point in (3.3.3)
:then: $\alpha_2^1$ differs from $\alpha_2^1$ at the other $\lambda$; from $\alpha_1^1$, which has another edge; from $\alpha_2^2$, which has another
  level; and from $\alpha_2^1$ of the other weights
:method: The weights of the triangle are computed exactly; each of the four differs from $\alpha_2^1$ in one thing only.
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
    num elsewhere = G(second_coefficient)(w, given(T, "other λ"), 1, 2);
    found(T, "α_2^1", here);
    found(T, "α_2^1 at the other λ", elsewhere);
    found(T, "α_1^1", edge);
    found(T, "α_2^2", level);
    found(T, "α_2^1 of the other ω", weights);
    about(T, "whether parameter, edge, level and weights, each by itself, change the coefficient");
    agree(T, !equal_q(here, elsewhere));
    agree(T, !equal_q(here, edge));
    agree(T, !equal_q(here, level));
    agree(T, !equal_q(here, weights));
}
#endif

/*
:::{claim} geometric_weights_cut_evenly
:title: Exactly geometric weights are cut at one ratio everywhere
:zh: 等比权时各边割角系数相同
:given: three neighbouring weights of level $r-1$, $\omega,\omega q,\omega q^2$ or any $x,y,z$, and $\lambda$; the coefficients are those of the second points
:then: for $\omega,\omega q,\omega q^2$ the coefficient is $\lambda q/(1-\lambda+\lambda q)$ on both edges, and the
  two weights of the next level again have the quotient $q$; for any three weights $x,y,z$ the coefficients on the
  two edges differ by $\lambda(1-\lambda)(xz-y^2)$ over the product of the two new weights
:method: Identities of rational functions.  By induction on the level geometric weights are cut at one ratio; and if
  the ratio is one on all edges of level 1 for one $\lambda\in(0,1)$, then $\omega_{i-1}\omega_{i+1}=\omega_i^2$ for
  all $i$.
:where: $0<\lambda<1$; the new weights are not 0
:scope: any three neighbouring weights of any level
:over: x# y# z#: weights; q
:control: $q^3$ for $q^2$
:degrees: all
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
    /* λ q/(1 - λ + λ q) */
    num expected = G(cut_coefficient)(one, q, lambda);
    same(T, G(cut_coefficient)(v[0], v[1], lambda), expected);
    same(T, G(cut_coefficient)(v[1], v[2], lambda), expected);
    G(bezier_casteljau_level)(2, 1, v, lambda);
    /* the next level has the quotient q */
    same(T, div(v[1], v[0]), q);

    num y = positive(T, "y", 0), z = positive(T, "z", 0), any[] = {x, y, z};
    num gap = sub(G(cut_coefficient)(y, z, lambda), G(cut_coefficient)(x, y, lambda));
    G(bezier_casteljau_level)(2, 1, any, lambda);
    /* the coefficients differ by λ (1-λ) (x z - y²) over the product of the new weights */
    same(T, mul(gap, mul(any[0], any[1])), mul(mul(lambda, sub(one, lambda)), sub(mul(x, z), mul(y, y))));
}

#include "chapters/judge/claims_off.h"
