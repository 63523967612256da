/*
# The curve stays in the hull of its points (凸包性)

The share of $R_i$ in the mean $R(t)$ is $B_i^n(t)\,\omega_i/\omega(t)$.  Shares that are not negative and have the sum $1$
make a point of the convex hull; this is the whole proof, and positive weights are what it rests on.
*/
#include "exact/record/hull.h"
#include "exact/record/roots.h"

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch3:prop-3.2.5
:title: The curve lies in the convex hull of its control points
:zh: 凸包性
:printed: The convex hull property.
:holds-by: positive_terms_make_a_convex_mean mean_grows_by_one_term
:confirmed-by: curve_points_are_convex_combinations curve_points_have_hull_certificates
:needs: curve_leaves_hull_with_negative_weight | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the
  weights are positive; that $\omega(t)$ has no zero is not enough.
:needs: curve_leaves_hull_outside_the_interval | (3.2.2): $0\le t\le1$ | $0\le t\le1$.
:reading: no_hull_property_with_weights_of_both_signs | Read as a property of the weights, which § 3.2 prescribes to be positive for its sake: "whatever
  the points are, the curve stays in their hull".  Where $\omega(t)$ has no zero in $[0,1]$ this is so exactly when no two weights have opposite signs, hence for positive ones. | $B_i^n(t)>0$; a common factor
  $-1$ of the weights changes nothing; weights without opposite signs make all shares nonnegative.
:figure: convex_hull

The claim
`curve_points_have_hull_certificates` decides the membership without the shares, as a linear problem, for some polygons.
:::

:::{statement} wang-ch3:prop-3.2.5-nonnegative
:title: The shares are not negative
:zh: 各系数非负
:printed: B_i^n(t)\,\omega_i/\omega(t)\ge0
:holds-by: positive_terms_make_a_convex_mean
:confirmed-by: curve_points_are_convex_combinations
:needs: share_with_negative_weight_is_negative | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the
  weights are positive.
:needs: curve_leaves_hull_outside_the_interval | (3.2.2): $0\le t\le1$ | $0\le t\le1$.
:figure: convex_hull
:::
*/

/* B_i^n(t) = C(n,i) t^i (1-t)^{n-i} */
static num G(bernstein_function)(int n, int i, num t)
{
    num product = from_int(binomial(n, i)), s = sub(from_int(1), t);
    for (int k = 0; k < n; k++)
        product = mul(product, k < i ? t : s);
    return product;
}

/*
To see the sign of a share for all $t$ at once, $t$ is written $s/(1+s)$: between $0$ and $1$ the new parameter $s$ is
any positive number, and the share becomes a quotient of polynomials in $s$ and the weights, whose coefficients can be
looked at.  The two ends, where $s$ is $0$ or infinite, are taken by themselves.

:::{claim} curve_points_are_convex_combinations
:title: Every point of the curve is a convex combination of the control points
:zh: 曲线上每点都是控制点的凸组合
:given: points, positive weights; $t=0$, $t=1$, and every $t$ between, written $t=s/(1+s)$, $s>0$
:let: $\lambda_i=B_i^n(t)\omega_i/\omega(t)$
:then: $R(t)=\sum\lambda_iR_i$, $\sum\lambda_i=1$, $\lambda_i\ge0$
:method: Two equalities of field elements.  As quotients of polynomials in $s$ and the weights the $\lambda_i$ have no negative
  coefficient, so they are not negative where these variables are positive.  A coordinate is any coordinate.
:degrees: 1..6 sampled 12
:scope: 0 ≤ t ≤ 1
:over: s: -
:control: $\omega_1$ taken with the opposite sign in $\lambda_1$
:::
*/
CLAIM(curve_points_are_convex_combinations)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], at[] = {from_int(0), from_int(1), inside(T, "s")};
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        R[i] = unknown(T, "R", i);
    }
    for (int k = 0; k < 3; k++) {
        num total = G(rational_weight)(n, w, at[k]), sum = from_int(0), mean = from_int(0), point;
        for (int i = 0; i <= n; i++) {
            num weight = fault(T, w[i], i == 1 ? neg(w[i]) : w[i]);
            num share = div(mul(G(bernstein_function)(n, i, at[k]), weight), total);
            nonnegative(T, share);
            sum = add(sum, share);
            mean = add(mean, mul(share, R[i]));
        }
        G(rational_point)(n, 1, R, w, at[k], &point);
        same(T, sum, from_int(1));
        same(T, mean, point);
    }
}

/*
:::{statement} wang-ch3:prop-3.2.5-sum
:title: The shares have the sum 1
:zh: 各系数之和为 1
:printed: \sum_{i=0}^n\left[B_i^n(t)\,\omega_i/\omega(t)\right]=1
:holds-by: mean_grows_by_one_term
:confirmed-by: shares_sum_to_one

This needs no sign of the weights, only $\omega(t)\ne0$.
:::

:::{claim} shares_sum_to_one
:title: The shares B_i ω_i/ω have the sum 1
:zh: B_i ω_i/ω 之和为 1
:given: weights of any sign, a parameter $t$, $\omega(t)\ne0$
:where: $\omega(t)\ne0$
:then: $\sum_iB_i^n(t)\omega_i/\omega(t)=1$
:method: The sum is $1$ in the field; $\omega(t)$ is computed by the kernel, the $B_i^n(t)$ from their definition.
:degrees: 1..8 sampled 16
:control: the last share left out
:::
*/
CLAIM(shares_sum_to_one)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], t = parameter(T, "t"), sum = from_int(0);
    for (int i = 0; i <= n; i++)
        w[i] = positive(T, "w", i);
    num total = G(rational_weight)(n, w, t);
    /* Σ B_i^n(t) ω_i/ω(t) */
    for (int i = 0; i <= fault(T, n, n - 1); i++)
        sum = add(sum, div(mul(G(bernstein_function)(n, i, t), w[i]), total));
    same(T, sum, from_int(1));
}

/*
## Decided by certificates

The same without the formula of the shares: whether a point is in the hull of others is a linear problem, and its
answer comes with a certificate, either a convex combination or a line (plane) that separates the point from all the
others.  What has to be looked out for are polygons whose hull has no inner points, and weights so large, so small or
$0$ that a point of the curve nearly is, or is, on the border.
*/

#if RATIONAL
/*
:::{claim} curve_points_have_hull_certificates
:title: Points of the curve pass an independent test of membership in the hull
:zh: 曲线点通过独立的凸包隶属检验
:kind: decision
:data: t = 0 1/3 1/2 1; ε = 0x1p-30
:given: plane and space polygons that are convex, zigzag, folded on a line, one point, closed with repetitions, on the moment curve, in
  a plane of space; weights that are equal, of ratios $2^{40}$, one huge, one tiny, with zeros between the ends, mixed;
  the four parameters $t$, and $\varepsilon$ and $1-\varepsilon$ near the ends
:then: $R(t)$ is in the convex hull of the points
:method: A convex combination is found by the simplex method over the rationals and checked by multiplying out; the formula of the shares
  is not used.
:degrees: 1..6
:scope: 7 polygons with 6 sets of weights at 6 parameters for each n
:control: the weight of the first point counted twice in the denominator
:::
*/
enum { POLYGONS = 7, PLANE_POLYGONS = 5, WEIGHTINGS = 6 };

/* None of the hulls contains the origin. */
static void G(designed_polygon)(int kind, int n, int *dim, num R[])
{
    *dim = kind < PLANE_POLYGONS ? 2 : 3;
    for (int i = 0; i <= n; i++) {
        long p[POLYGONS][3] = {{i, (long)i * (n - i)},                               /* convex                       */
                               {i, i % 2 == 0 ? -3 : 5},                             /* zigzag                       */
                               {i * 5 % 7, 2 * (i * 5 % 7)},                         /* on a line, to and fro        */
                               {4, 4},                                               /* one point                    */
                               {i % n == 0 ? 2 : i / 2, i % n == 0 ? 0 : i / 2 * 3}, /* closed, points twice */
                               {i, (long)i * i, (long)i * i * i},
                               {i, i % 3, 2 * i - i % 3}}; /* in the plane z = 2 x - y     */
        for (int c = 0; c < *dim; c++)
            R[i * *dim + c] = from_int(p[kind][c] + (c == 0 ? 10 : 0));
    }
}
static void G(designed_weights)(trial *T, int kind, int n, num w[])
{
    for (int i = 0; i <= n; i++) {
        int inner = i > 0 && i < n;
        w[i] = kind == 0            ? from_int(1)
               : kind == 1          ? (i % 2 == 0 ? from_int(1L << 20) : from_ratio(1, 1L << 20))
               : kind == 2          ? from_int(i == n / 2 ? 1L << 40 : 1)
               : kind == 3          ? (i == n / 2 ? from_ratio(1, 1L << 40) : from_int(1))
               : kind == 4 && inner ? from_int(0)
                                    : positive(T, "w", i);
    }
}

CLAIM(curve_points_have_hull_certificates)
{
    int n = T->degree, dim;
    num R[(MAX_DEGREE + 1) * 3], w[MAX_DEGREE + 1], x[3], at[6];
    given_points(T, "t", 4, 1, at);
    at[4] = given(T, "ε");
    at[5] = sub(from_int(1), at[4]);
    for (int polygon = 0; polygon < POLYGONS; polygon++)
        for (int weighting = 0; weighting < WEIGHTINGS; weighting++)
            for (int k = 0; k < 6; k++) {
                G(designed_polygon)(polygon, n, &dim, R);
                G(designed_weights)(T, weighting, n, w);
                G(rational_point)(n, dim, R, w, at[k], x);
                num total = G(rational_weight)(n, w, at[k]);
                num first = mul(w[0], G(bernstein_function)(n, 0, at[k]));
                for (int c = 0; c < dim; c++)
                    x[c] = fault(T, x[c], mul(x[c], div(total, add(total, first))));
                struct cagd_hull_certificate found = hull_membership(dim, n + 1, R, x);
                agree(T, found.inside && hull_certificate_holds(dim, n + 1, R, x, found));
            }
}
#endif

/*
## Without positive weights, and outside [0,1]

The shares have the sum $1$ whatever the weights are.  What a negative weight spoils is their sign: a point with a
negative share does not attract the curve but repels it, and the curve may pass on the other side of the other
points.  That $\omega(t)$ has no zero is not enough; it only keeps the curve finite.
*/

#if RATIONAL
/*
:::{claim} curve_leaves_hull_with_negative_weight
:title: With the weights 1, −1/2, 1 the curve leaves the triangle
:zh: 权为 1, −1/2, 1 时曲线越出三角形
:kind: counterexample
:data: R = (0,0) (1,2) (2,0); ω = 1 -1/2 1; t = 1/2
:instead: ω = 1 1/2 1
:result: zeros of ω(t) in [0,1] = 0; R(t) = (1,-2)
:given: the quadratic curve with points $R$ and weights $\omega$, of which the middle one is negative, though $\omega(t)$ has no zero in $[0,1]$;
  a parameter $t$ of $[0,1]$
:then: $R(t)$ is outside the triangle
:method: A linear function that is at most the offset on the three points and larger at $R(t)$ is found and checked exactly.
:control: the middle weight made positive
:::
*/
CLAIM(curve_leaves_hull_with_negative_weight)
{
    num R[6], w[3], x[2];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    num t = given(T, "t");
    G(rational_point)(2, 2, R, w, t, x);
    struct cagd_hull_certificate hull = hull_membership(2, 3, R, x);
    int zeros = count_roots(poly_from_bernstein(2, w), from_int(0), from_int(1), CLOSED).distinct;
    found_whole(T, "zeros of ω(t) in [0,1]", zeros);
    found_points(T, "R(t)", 1, 2, x);
    if (!hull.inside)
        show_text(T, "separated by", "(%s) x + (%s) y, at most %s on the triangle", to_string_q(hull.normal[0]),
                  to_string_q(hull.normal[1]), to_string_q(hull.offset));
    about(T, "where ω has no zero, R(t) is in the hull");
    refute(T, zeros == 0 && !hull.inside && hull_certificate_holds(2, 3, R, x, hull));
}

/*
:::{claim} share_with_negative_weight_is_negative
:title: With the weights 1, −1/2, 1 the share of the middle point is −1
:zh: 权为 1, −1/2, 1 时中间系数为 −1
:kind: counterexample
:data: ω = 1 -1/2 1; t = 1/2
:instead: ω = 1 1/2 1
:result: ω(t) = 1/4; share of R_1 = -1
:given: a quadratic curve with weights $\omega$, of which the middle one is negative, and a parameter $t$ of $[0,1]$
:then: $B_1^2(t)\,\omega_1/\omega(t)<0$, although $\omega(t)>0$
:method: The share is computed exactly.
:control: the middle weight made positive
:::
*/
CLAIM(share_with_negative_weight_is_negative)
{
    num w[3];
    given_points(T, "ω", 3, 1, w);
    num t = given(T, "t"), total = G(rational_weight)(2, w, t);
    num share = div(mul(G(bernstein_function)(2, 1, t), w[1]), total);
    found(T, "ω(t)", total);
    found(T, "share of R_1", share);
    about(T, "the share of R_1 is not negative");
    nonnegative(T, share);
}

/*
Beyond the interval it is the Bernstein functions that are negative.  Already a segment shows it.

:::{claim} curve_leaves_hull_outside_the_interval
:title: Beyond t = 1 a curve can leave the hull
:zh: t > 1 时曲线越出凸包
:kind: counterexample
:data: R = 0 1; ω = 1 1; t = 2
:instead: t = 1/2
:result: R(t) = 2; share of R_0 = -1
:given: the segment with points $R$ of the line and weights $\omega$; a parameter $t>1$
:then: the share $B_0^1(t)\,\omega_0/\omega(t)$ of $R_0$ is negative, and $R(t)$ is not between $R_0$ and $R_1$
:method: The share is computed, a separating number is found and checked exactly.
:control: a parameter between $0$ and $1$
:::
*/
CLAIM(curve_leaves_hull_outside_the_interval)
{
    num R[2], w[2], x;
    given_points(T, "R", 2, 1, R);
    given_points(T, "ω", 2, 1, w);
    num t = given(T, "t");
    G(rational_point)(1, 1, R, w, t, &x);
    num share = div(mul(G(bernstein_function)(1, 0, t), w[0]), G(rational_weight)(1, w, t));
    struct cagd_hull_certificate hull = hull_membership(1, 2, R, &x);
    found(T, "R(t)", x);
    found(T, "share of R_0", share);
    about(T, "R(t) is in the hull, or the share of R_0 is not negative");
    refute(T, sign_q(share) < 0 && !hull.inside && hull_certificate_holds(1, 2, R, &x, hull));
}
#endif

/*
These examples are about certain polygons.  For given weights one may ask whether the curve stays in the hull whatever
the points are.  If two weights have opposite signs the answer is no, and the polygon that shows it is a simple one:
one point at $1$, all the others at $0$.

:::{claim} no_hull_property_with_weights_of_both_signs
:title: With weights of both signs some polygon does not contain its curve
:zh: 权有异号时必有多边形不包含其曲线
:given: weights of which one, $\omega_i=-v$, is negative and the others are any numbers, with $W$ for the sum of their $B_j^n(t)\omega_j$; the points
  $R_i=1$ and $R_j=0$, $j\ne i$, of the line; $0<t<1$, so that $B=B_i^n(t)>0$
:then: $\omega(t)=W-Bv$ and $R(t)\,\omega(t)=-Bv<0$; if $\omega(t)$ has no zero in $[0,1]$ and some weight is positive, the hull property fails
:method: Of the mean of the two points 0 and 1 with the weights $W$ and $-Bv$; $B$, $v$ and $W$ are variables, so that $n$ is any degree.  $R(t)$ and $\omega(t)$ have
  opposite signs.  Where $\omega(t)>0$ this puts $R(t)$ below the hull $[0,1]$.  Where $\omega(t)<0$ throughout, a common factor
  $-1$ turns a positive weight into a negative one and $\omega(t)$ positive.  Conversely, weights without opposite signs make
  all shares nonnegative.  Outside the field the curve itself, of a random degree, is computed as well.
:degrees: all
:scope: 0 < t < 1
:harmless: $j\ne i$ | the other indices
:over: s v B W: -
:control: $\omega_i=v$
:::
*/
CLAIM(no_hull_property_with_weights_of_both_signs)
{
    num v = positive(T, "v", 0), B = positive(T, "B", 0), W = unknown(T, "W", 0), own = fault(T, neg(v), v);
    num total = add(W, mul(B, own)), mean = div(mul(B, own), total);
    about(T, "R(t) ω(t)");
    same(T, mul(mean, total), neg(mul(B, v)));
    G(must_be_positive)(T, neg(mul(mean, total)));
#if !FIELD
    int n = pick(T, 1, 8), i = pick(T, 0, n);
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], t = inside(T, "s"), point;
    for (int j = 0; j <= n; j++) {
        w[j] = j == i ? own : unknown(T, "w", j);
        R[j] = from_int(j == i);
    }
    G(rational_point)(n, 1, R, w, t, &point);
    about(T, "R(t) ω(t) of a curve");
    same(T, mul(point, G(rational_weight)(n, w, t)), neg(mul(G(bernstein_function)(n, i, t), v)));
#endif
}
#include "chapters/judge/claims_off.h"
