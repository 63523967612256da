/*
# When the shape determines the weights (形状与不变量)

Equal invariants give the same curve in every degree.  Theorem 3.2.1 is the converse for
$n=2,\dots,5$: with the points fixed, the curve determines the invariants.  The idea is short.  At an end
the curvature contains one invariant and the torsion two; up to $n=5$ both ends together see them all.

Below, $a_i=R_i-R_{i-1}$, and "same shape" has to be made precise first: the same point set; the same point
set run in the same direction; the same map of the parameter; or congruent curves.
*/
#include "exact/record/hull.h"
#include "exact/record/sign.h"

#include "chapters/judge/elementary.h"
#include "chapters/rational-bezier/free-curve.h"
#include "chapters/rational-bezier/one-map.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch3:thm-3.2.1
:title: For n = 2, ..., 5 the same shape means the same invariants
:zh: n=2,3,4,5 时形状相同当且仅当不变量相同
:printed: Let $n=2,3,4,5$, let neither the first nor the last three control points be collinear, and for $n\ge3$
  neither the first nor the last three edge vectors be coplanar.  Then (3.2.2) and (3.2.13) have the same shape if
  and only if (3.2.12) holds: $I_i=I_i^*$, $i=1,\dots,n-1$.
:holds-by: backward_run_flattens_the_first_edges derivative_vectors_at_zero_in_every_degree derivative_vectors_at_one_in_every_degree
  curvature_and_torsion_follow_at_zero_in_every_degree curvature_and_torsion_follow_at_one_in_every_degree
  factor_of_the_curvature_is_positive end_factors_are_reciprocals_of_invariants
  equal_invariants_mean_geometric_ratios factors_make_a_geometric_sequence fractional_change_term_by_term
  larger_numbers_have_larger_powers fractional_change_runs_once
  bernstein_sum_of_powers_is_a_power change_of_parameter_acts_on_one_factor mean_grows_by_one_term weight_can_be_divided_out
:confirmed-by: end_curvature_contains_one_invariant end_torsion_contains_two_invariants equal_invariants_give_same_curve
  plane_cubic_cannot_run_backwards congruent_curves_beyond_cubics
:meant: property 3.2.10, which the theorem turns round, and the sentence before it, by which only the distribution of
  the parameter differs | The same shape is the same point set.
:reading: equal_invariants_other_speed | same map of the parameter; then "if" fails, as the parameter is distributed
  differently; the source excludes this reading
:reading: congruent_cubics_with_other_invariants | congruent curves; then "only if" fails, as the motion may exchange the
  ends, and with them the weights; the example has $n=3$, and there are such examples for $n=4,5$ as well
:needs: equal_invariants_reach_the_other_arc | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive: for "if"
:needs: segment_has_two_invariants | the theorem | at both ends three points are not collinear, and for $n=3,4,5$ three edges not
  coplanar; the example has $n=2$ and points of a line; for $n=3$ coplanar edges do no harm, and for $n=3,4,5$ one end is enough, as is said below
:needs: palindromes_of_degree_four | the theorem | for $n=4$ the edges are not coplanar at one end at least; without it the
  point set, run backwards, can have other invariants
:needs: common_factor_hides_the_weights | the theorem | for $n=5$ the edges are not coplanar at one end at least; a plane quintic can be one and the
  same map for weights with different invariants
:needs: space_palindromes_beyond_degree_five | the theorem | $n\le5$: for $n=6$ to 9 there are examples, where the point set, run backwards,
  has other invariants
:cites: [sendra-winkler-perez-diaz-2008]: two proper parametrizations of one rational curve differ by a fractional
  linear change of the parameter | It is used in step (1).
:argued: | (1) Two curves with one point set $T$ are proper and correspond to each other.  For $n=2$, $T$ is an arc of a proper conic.  For $n\ge3$, $T$ is in no plane, since its points $R_i$ would be in
  that plane, too (property 3.2.9); so its algebraic curve has at least the degree 3.  When common factors are removed, each parametrization has a degree of at most 5 that is a
  multiple of it (each of the points in which a general plane meets the curve has equally many parameters), hence equal to it: the curve is run once.  By the cited theorem the two differ by a projective map $\varphi$ of the parameter line, which maps $[0,1]$ onto itself.
:argued: | (2) They have one direction.  If $\varphi$ exchanged $0$ and $1$, then $R_0=R_n$, $a_1\parallel a_n$, and for $n=5$ the planes of $a_1,a_2$ and of $a_{n-1},a_n$ would
  be one; by `backward_run_flattens_the_first_edges` the first edges would then be dependent, against the hypothesis.
:argued: | (3) Only if: curvature and torsion agree at corresponding ends.  By the claims they determine $I_1$, $I_1I_2$, $I_{n-1}$, $I_{n-2}I_{n-1}$, as $a_1\times a_2$ and, for $n\ge3$,
  $(a_1,a_2,a_3)$ are not 0, and so at the other end: for $n\le5$ these give every invariant.  If: this is property 3.2.10, by `equal_invariants_mean_geometric_ratios`, `factors_make_a_geometric_sequence`, `fractional_change_term_by_term`,
  `larger_numbers_have_larger_powers` and `fractional_change_runs_once`, and needs nothing but positive weights.
:figure: shape_and_invariants

For $n=3$ the edges may be coplanar, when at both ends three points are not collinear: $T$ is on no line, as its points $R_i$ would be on that line, too; its algebraic
curve has the degree 2 or 3, and a degree of at most 3 that is a multiple of it is equal to it.  So both curves are proper, by
`plane_cubic_cannot_run_backwards` they have one direction, and the curvatures at the two ends give $I_1$ and $I_2$.  Three points that are not collinear at one end are enough here, too, as below: with $\omega_i^*=\omega_i$ for $i\le2$ there is the factor $t^3$, and $p$ has at least the degree 2, $g^*-g$ at most 1.

For $n=4,5$ three edges that are not coplanar at one end, say at the start, are enough.  With them $T$ is in no plane, and the curves are proper and have one direction by steps (1) and (2), which ask for independent edges at
one end.  Curvature and torsion at the start give $I_1$ and $I_2$; so after a change (3.2.10), by which the two become one map, $\omega_i^*=\omega_i$ for $i\le3$, when a common factor is divided out.  Their homogeneous coordinates are then
$g\,p$ and $g^*p$ with polynomials $g$, $g^*$ and coordinates $p$ without a common factor, of a degree of at least 3 as $T$ is in no plane; $(g^*-g)\,p$ has the factor $t^4$, and so has $g^*-g$, whose degree is at most $n-3\le2$: so $g^*=g$, and all weights agree.
:::
*/

/*
By property 3.2.4 the curvature at $t=0$ contains the weights as $\frac{\omega_0\omega_2}{\omega_1^2}=\frac1{I_1}$ and
the torsion as $\frac{\omega_0\omega_3}{\omega_1\omega_2}=\frac1{I_1I_2}$.  So each end gives two invariants, if the
geometric factors beside them are not $0$, and both ends give four: just enough for $n=5$.

:::{claim} end_curvature_contains_one_invariant
:title: The curvature at an end contains exactly the first invariant
:zh: 端点曲率只含一个不变量
:given: positive weights $\omega_0,\dots,\omega_n$ and points $R_0,\dots,R_n$ of space, $a_1\ne0$, $a_n\ne0$
:where: the weights are positive; $\mathbf a_1\ne\mathbf 0$ and $\mathbf a_n\ne\mathbf 0$
:then: $\kappa(0)^2I_1^2\|a_1\|^6=(\frac{n-1}n)^2\|a_1\times a_2\|^2$ and
  $\kappa(1)^2I_{n-1}^2\|a_n\|^6=(\frac{n-1}n)^2\|a_{n-1}\times a_n\|^2$
:method: The curvatures are computed from the derivatives of the curve; both sides are rational functions of the
  weights and the coordinates.  Plane curves are included.  As the invariants are positive, the curvature at $0$
  together with the points determines $I_1$ as soon as $a_1\times a_2\ne0$; likewise at $1$.
:degrees: 2..6 sampled 10
:control: $I_2$ for $I_1$; for $n=2$, $I_1$ doubled
:::
*/
CLAIM(end_curvature_contains_one_invariant)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[3 * (MAX_DEGREE + 1)], I[MAX_DEGREE], a[3], b[3];
    num factor = mul(from_ratio(n - 1, n), from_ratio(n - 1, n));
    G(free_curve)(T, n, 3, R, w);
    G(rational_invariants)(n, w, I);
    for (int end = 0; end < 2; end++) {
        G(edge)(3, R, end ? n : 1, a);
        G(edge)(3, R, end ? n - 1 : 2, b);
        num square = G(rational_curvature_squared)(n, 3, R, w, from_int(end));
        num g = G(norm_squared)(3, a), J = I[end ? n - 2 : 0];
        J = fault(T, J, n == 2 ? add(J, J) : I[end ? n - 3 : 1]);
        about(T, end ? "at t = 1" : "at t = 0");
        /* κ² I² |a|⁶ = ((n-1)/n)² |a × b|² */
        same(T, mul(mul(square, mul(J, J)), mul(g, mul(g, g))), mul(factor, G(gram)(3, a, b)));
    }
}

/*
:::{claim} end_torsion_contains_two_invariants
:title: The torsion at an end contains exactly the product of the first two invariants
:zh: 端点挠率含前两个不变量之积
:given: positive weights $\omega_0,\dots,\omega_n$ and points $R_0,\dots,R_n$ of space, $a_1\times a_2\ne0$,
  $a_{n-1}\times a_n\ne0$
:where: the weights are positive; $\mathbf a_1\times\mathbf a_2\ne\mathbf 0$ and $\mathbf a_{n-1}\times\mathbf a_n\ne\mathbf 0$
:then: $\tau(0)I_1I_2\|a_1\times a_2\|^2=\frac{n-2}n(a_1,a_2,a_3)$ and
  $\tau(1)I_{n-2}I_{n-1}\|a_{n-1}\times a_n\|^2=\frac{n-2}n(a_{n-2},a_{n-1},a_n)$
:method: The torsions are computed from the derivatives of the curve; both sides are rational functions of the weights and the coordinates.  When $(a_1,a_2,a_3)\ne0$, curvature and torsion
  at $0$ determine $I_1$ and $I_2$; when $(a_{n-2},a_{n-1},a_n)\ne0$, those at $1$ determine $I_{n-1}$ and
  $I_{n-2}$.
:degrees: 3..6 sampled 10
:control: $I_1$ for $I_1I_2$
:::
*/
CLAIM(end_torsion_contains_two_invariants)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[3 * (MAX_DEGREE + 1)], I[MAX_DEGREE], a[3], b[3], c[3];
    G(free_curve)(T, n, 3, R, w);
    G(rational_invariants)(n, w, I);
    for (int end = 0; end < 2; end++) {
        int first = end ? n - 2 : 1;
        G(edge)(3, R, first, a);
        G(edge)(3, R, first + 1, b);
        G(edge)(3, R, first + 2, c);
        num torsion = G(rational_torsion)(n, R, w, from_int(end));
        num area = end ? G(gram)(3, b, c) : G(gram)(3, a, b);
        num J = fault(T, mul(end ? I[n - 2] : I[0], end ? I[n - 3] : I[1]), end ? I[n - 2] : I[0]);
        about(T, end ? "at t = 1" : "at t = 0");
        /* τ I I' |a × b|² = (n-2)/n (a, b, c); at t = 1, |b × c|² */
        same(T, mul(torsion, mul(J, area)), mul(from_ratio(n - 2, n), G(det3)(a, b, c)));
    }
}

/*
Before curvatures at $t=0$ are compared it must be known that both curves start at the same end of the point set.  The
source takes this for granted.  Under the hypotheses it is true up to degree $5$, and the reason is that a curve over a polygon which
closes up so smoothly has no room for independent first edges.

:::{claim} backward_run_flattens_the_first_edges
:title: For n at most 5 the curve cannot be the other one run backwards
:zh: n≤5 时两曲线不可能反向重合
:given: edges $a_1,\dots,a_n$ with $a_1+\dots+a_n=0$; for $n\ge4$ also $a_n=c\,a_1$; for $n=5$ also
  $a_4=d\,a_1+e\,a_2$
:then: $a_1\times a_2=0$ for $n=2$, and $(a_1,a_2,a_3)=0$ for $n=3,4,5$
:method: If $R^*(u)=R(\varphi(u))$ with $\varphi(0)=1$, then $R_0=R_n$, and there the tangents, and the osculating
  planes, of the two curves agree: these are the relations given.  In each case the determinant is the zero
  polynomial in what is left free.
:degrees: 2..5
:over: a#: edges; c d e: -
:control: the relation $a_1+\dots+a_n=0$ left out
:::
*/
CLAIM(backward_run_flattens_the_first_edges)
{
    int n = T->degree;
    num a[6][3], product[3], c = unknown(T, "c", 0), d = unknown(T, "d", 0), e = unknown(T, "e", 0);
    int solved = n < 3 ? n : 3; /* the edge that the sum determines */
    for (int k = 0; k < 3; k++) {
        a[1][k] = unknown(T, "a1", k);
        a[2][k] = unknown(T, "a2", k);
        a[n][k] = n >= 4 ? mul(c, a[1][k]) : a[n < 3 ? n : 2][k];
        if (n == 5)
            a[4][k] = add(mul(d, a[1][k]), mul(e, a[2][k]));
        num sum = from_int(0);
        for (int i = 1; i <= n; i++)
            if (i != solved)
                sum = add(sum, a[i][k]);
        a[solved][k] = fault(T, neg(sum), unknown(T, "free", k));
    }
    if (n == 2) {
        G(cross3)(a[1], a[2], product);
        for (int k = 0; k < 3; k++)
            vanishes(T, product[k]);
    } else {
        vanishes(T, G(det3)(a[1], a[2], a[3]));
    }
}

/*
## Without the hypotheses

How much of the hypotheses is needed?  For $n=3$ the direction is fixed without the condition on three edges.

:::{claim} plane_cubic_cannot_run_backwards
:title: A cubic with three points not collinear at its start is not the other one run backwards
:zh: 三次曲线:首三点不共线即不可能反向重合
:given: $n=3$, $a_1+a_2+a_3=0$ and $a_3=c\,a_1$
:then: $a_1\times a_2=0$
:method: $a_2=-(1+c)a_1$.  If one cubic is the other run backwards, then $R_0=R_3$, and there the tangents of the two agree:
  these are the relations given.
:scope: n = 3
:over: a#: edges; c: -
:control: $a_3=c\,a_1$ left out
:::
*/
CLAIM(plane_cubic_cannot_run_backwards)
{
    num a[3], b[3], product[3], c = unknown(T, "c", 0);
    for (int k = 0; k < 3; k++) {
        a[k] = unknown(T, "a", k);
        num last = fault(T, mul(c, a[k]), unknown(T, "free", k));
        b[k] = neg(add(a[k], last));
    }
    G(cross3)(a, b, product);
    for (int k = 0; k < 3; k++)
        vanishes(T, product[k]);
}

/*
For $n=5$ the condition is needed.  A quintic over the polygon $P_0,P_1,P_2,P_0,P_1,P_2$ of a triangle run through twice can be a
quadratic in disguise, with weights in which a number $c$ is free.

:::{claim} common_factor_hides_the_weights
:title: One map for every c, though the invariants depend on c
:zh: 公因子掩盖权:同一映射而不变量不同
:given: $m=1,2,3$, $n=2m+1$; points $P_0,\dots,P_m$, the points $P_0,\dots,P_m,P_0,\dots,P_m$ of degree $n$, and the
  weights $\binom ni\omega_i=\binom mi$, $\binom ni\omega_i=c\binom m{i-m-1}$ for $i\le m$, $i>m$
:then: $R(t)=\sum_{i=0}^mB_i^m(t)P_i$ for every $c$, while $c\,I_m$ and $I_{m+1}/c$ do not depend on $c$
:method: The common factor is $(1-t)^{m+1}+c\,t^{m+1}>0$.  Both sides are rational functions of $t$, $c$ and the
  points.  For $m=2$ the points are in a plane, the first and the last three not collinear when $P$ is a triangle;
  for $m=3$ the first and the last three edges are independent when $P$ is a tetrahedron.
:scope: n = 3 on a line, n = 5 in a plane, n = 7 in space
:over: c
:control: the weight $\omega_n$ doubled
:::
*/
CLAIM(common_factor_hides_the_weights)
{
    num t = parameter(T, "t"), c = positive(T, "c", ALONE);
    for (int m = 1; m <= 3; m++) {
        int n = 2 * m + 1;
        num P[4], R[8], w[8], one[8], I[8], J[8], left, right;
        for (int i = 0; i <= m; i++)
            P[i] = unknown(T, "P", i);
        for (int i = 0; i <= n; i++) {
            int k = i <= m ? i : i - m - 1;
            R[i] = P[k];
            one[i] = from_ratio(binomial(m, k), binomial(n, i));
            w[i] = i <= m ? one[i] : mul(c, one[i]);
        }
        w[n] = fault(T, w[n], add(w[n], w[n]));
        G(rational_point)(n, 1, R, w, t, &left);
        G(bezier_casteljau)(m, 1, P, t, &right);
        same(T, left, right);
        G(rational_invariants)(n, w, I);
        if (m == 2) {
            show_points(T, "ω, n = 5", n + 1, 1, w);
            show_points(T, "I, n = 5", n - 1, 1, I);
        }
        G(rational_invariants)(n, one, J);
        same(T, mul(c, I[m - 1]), J[m - 1]);
        same(T, I[m], mul(c, J[m]));
    }
}

#if RATIONAL
/* Have two sets of weights different invariants?  found_invariants_differ also finds them as the results I and I*. */
static int G(invariants_differ)(int n, const num w[], const num v[])
{
    num I[MAX_DEGREE], J[MAX_DEGREE];
    int different = 0;
    G(rational_invariants)(n, w, I);
    G(rational_invariants)(n, v, J);
    for (int i = 1; i < n; i++)
        different |= !equal_q(I[i - 1], J[i - 1]);
    return different;
}
static int G(found_invariants_differ)(trial *T, int n, const num w[], const num v[])
{
    num I[MAX_DEGREE], J[MAX_DEGREE];
    G(rational_invariants)(n, w, I);
    G(rational_invariants)(n, v, J);
    found_points(T, "I", n - 1, 1, I);
    found_points(T, "I*", n - 1, 1, J);
    return G(invariants_differ)(n, w, v);
}

/*
On a line even the quadratic is undetermined, without any common factor: different weights run through one segment, at
speeds that no change of parameter (3.2.10) carries into each other.

:::{claim} segment_has_two_invariants
:title: On a line the point set does not determine the invariant
:zh: 共线时点集不能确定不变量
:kind: decision
:data: R = 0 1 2; ω = 1 2 1; ω* = 1 3 1
:instead: ω* = 1 2 1
:result: I = 4; I* = 9
:given: $n=2$, the points $R$ of a line, and two sets of weights, $\omega$ and $\omega^*$
:then: both curves run monotonically from $R_0$ to $R_2$, so that their point set is this segment, and neither
  has a common factor; but $I_1\ne I_1^*$
:method: The numerators of the derivatives are positive on $[0,1]$, decided exactly; numerator and denominator of
  each curve have degree $2$ and a constant greatest common divisor.
:control: the same weights twice
:::
*/
CLAIM(segment_has_two_invariants)
{
    enum { n = 2 };
    num R[n + 1], w[2][n + 1], zero = from_int(0), one = from_int(1);
    given_points(T, "R", n + 1, 1, R);
    given_points(T, "ω", n + 1, 1, w[0]);
    given_points(T, "ω*", n + 1, 1, w[1]);
    agree(T, G(found_invariants_differ)(T, n, w[0], w[1]));
    for (int k = 0; k < 2; k++) {
        num x[n + 1];
        for (int i = 0; i <= n; i++)
            x[i] = mul(w[k][i], R[i]);
        poly N = poly_from_bernstein(n, x), D = poly_from_bernstein(n, w[k]);
        /* N' D - N D', the numerator of R' */
        poly slope = poly_sub(poly_mul(poly_derivative(N), D), poly_mul(N, poly_derivative(D)));
        agree(T, sign_on(slope, zero, one, CLOSED) == SIGN_POSITIVE);
        agree(T, poly_degree(N) == n && poly_degree(D) == n && poly_degree(poly_gcd(N, D)) == 0);
    }
}

/*
Over a polygon that reads the same backwards the direction gets lost.  If the invariants do not read the same, the
reversed weights have other ones, and the same point set.

:::{claim} palindromes_of_degree_four
:title: A plane quartic over a palindromic polygon, run backwards, can have other invariants
:zh: 四次平面回文多边形:反向后不变量不同
:kind: decision
:data: R = (0,0) (1,0) (0,1) (1,0) (0,0); ω = 1 2 1 1 1
:instead: ω = 1 2 1 2 1
:result: I = 4 1/2 1; I* = 1 1/2 4
:given: the quartic curve of the plane with points $R$ and weights $\omega$, and $\omega^*$, which is $\omega$ in reverse order
:then: $R^*(t)=R(1-t)$, so that the point sets are one; the first and the last three points are not collinear; but
  $I$ and $I^*$ differ
:method: The polynomials of the two curves are compared; the rest is exact arithmetic.
:control: weights that do not change in reverse order
:::
*/
/* Whether the curve over a palindromic polygon, run backwards, is one map with other invariants; its points and both weights. */
static void G(check_palindrome)(trial *T, int n, num R[], num w[], num v[])
{
    num S[2 * (MAX_DEGREE + 1)];
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    G(reversed_points)(n, 2, R, S);
    G(reversed_points)(n, 1, w, v);
    agree(T, G(one_map)(n, 2, R, v, S, v));
    agree(T, turn_2d(R, R + 2, R + 4) != 0 && turn_2d(R + 2 * (n - 2), R + 2 * (n - 1), R + 2 * n) != 0);
    agree(T, G(found_invariants_differ)(T, n, w, v));
}

CLAIM(palindromes_of_degree_four)
{
    enum { n = 4 };
    num R[2 * (n + 1)], w[n + 1], v[n + 1];
    G(check_palindrome)(T, n, R, w, v);
}

/*
:::{claim} palindromes_of_degree_five
:title: A plane quintic over a palindromic polygon, run backwards, can have other invariants
:zh: 五次平面回文多边形:反向后不变量不同
:kind: decision
:data: R = (0,0) (1,0) (0,1) (0,1) (1,0) (0,0); ω = 1 2 1 1 1 1
:instead: ω = 1 2 1 1 2 1
:result: I = 4 1/2 1 1; I* = 1 1 1/2 4; κ(0)², κ*(0)² = 1/25 16/25
:given: the quintic curve of the plane with points $R$ and weights $\omega$, and $\omega^*$, which is $\omega$ in reverse order
:then: $R^*(t)=R(1-t)$, so that the point sets are one; the first and the last three points are not collinear; but
  $I$ and $I^*$ differ, $I_1$ and $I_1^*$ among them, and so do the curvatures at the start
:method: The polynomials of the two curves are compared; the rest is exact arithmetic, the squared curvatures from the derivatives.
:control: weights that do not change in reverse order
:::
*/
CLAIM(palindromes_of_degree_five)
{
    enum { n = 5 };
    num R[2 * (n + 1)], w[n + 1], v[n + 1], zero = from_int(0);
    G(check_palindrome)(T, n, R, w, v);
    num square[2] = {G(rational_curvature_squared)(n, 2, R, w, zero), G(rational_curvature_squared)(n, 2, R, v, zero)};
    found_points(T, "κ(0)², κ*(0)²", 2, 1, square);
    agree(T, !equal_q(square[0], square[1]));
}

/* (a_i, a_j, a_k) of the edges of points of space. */
static num G(edges_det)(const num R[], int i, int j, int k)
{
    num a[3], b[3], c[3];
    G(edge)(3, R, i, a);
    G(edge)(3, R, j, b);
    G(edge)(3, R, k, c);
    return G(det3)(a, b, c);
}

/*
In space such a polygon can have independent first edges if it is long enough: out and back it takes three edges each
way, hence degree $6$.

:::{claim} space_palindromes_beyond_degree_five
:title: In degrees 6 to 9 the point set need not determine the invariants
:zh: 六至九次时点集未必能确定不变量
:kind: decision
:data: e = (0,0,0) (1,0,0) (0,1,0) (0,0,1); ω_1 = 2
:result: I_1, I_(n-1) = 4 1; I*_1, I*_(n-1) = 1 4
:given: $n=6,\dots,9$; the points $e_0,e_1,e_2,e_3$ of space; $R$ the points
  $e_0,e_1,e_2,e_3,\dots,e_3,e_2,e_1,e_0$; $\omega=(1,\omega_1,1,\dots,1)$ and $\omega^*=(1,\dots,1,\omega_1,1)$
:then: $R^*(t)=R(1-t)$, so that the point sets are one; the first and the last three edges are not coplanar; but
  $I_1\ne I_1^*$ and $I_{n-1}\ne I_{n-1}^*$
:method: The polynomials of the two curves are compared; the rest is exact arithmetic.
:degrees: 6..9
:control: the weight $\omega_1$ at both places in both
:::
*/
CLAIM(space_palindromes_beyond_degree_five)
{
    enum { SIZE = 10 };
    int n = T->degree;
    num e[12], R[3 * SIZE], S[3 * SIZE], w[SIZE], v[SIZE], I[SIZE], J[SIZE];
    given_points(T, "e", 4, 3, e);
    num heavy = given(T, "ω_1");
    for (int i = 0; i <= n; i++) {
        int k = i < n - i ? i : n - i;
        for (int c = 0; c < 3; c++)
            R[3 * i + c] = e[3 * (k < 3 ? k : 3) + c];
        w[i] = fault(T, i == 1, i == 1 || i == n - 1) ? heavy : from_int(1);
    }
    show_points(T, "R", n + 1, 3, R);
    show_points(T, "ω", n + 1, 1, w);
    G(reversed_points)(n, 3, R, S);
    G(reversed_points)(n, 1, w, v);
    agree(T, G(one_map)(n, 3, R, v, S, v));
    agree(T, !is_zero_q(G(edges_det)(R, 1, 2, 3)) && !is_zero_q(G(edges_det)(R, n - 2, n - 1, n)));
    G(rational_invariants)(n, w, I);
    G(rational_invariants)(n, v, J);
    found_points(T, "I_1, I_(n-1)", 2, 1, (num[]){I[0], I[n - 2]});
    found_points(T, "I*_1, I*_(n-1)", 2, 1, (num[]){J[0], J[n - 2]});
    agree(T, !equal_q(I[0], J[0]) && !equal_q(I[n - 2], J[n - 2]));
}

/*
The last examples are about the word shape.  If it meant the map $t\mapsto R(t)$, equal invariants would not be enough.

:::{claim} equal_invariants_other_speed
:title: Equal invariants do not mean the same map of the parameter
:zh: 不变量相等时参数分布可以不同
:kind: counterexample
:data: R = (-1,0) (0,1) (1,0); ω = 1 1 1; ω* = 1 2 4; t = 1/2
:instead: ω* = 1 1 1
:result: I = 1; I* = 1; R(t) = (0,1/2); R*(t) = (1/3,4/9)
:given: the quadratic curves with points $R$ and weights $\omega$ and $\omega^*$, and a parameter $t$
:then: $I_1=I_1^*$, the hypotheses of the theorem hold, and $R(t)\ne R^*(t)$
:method: Computed exactly.
:control: the same weights twice
:::
*/
CLAIM(equal_invariants_other_speed)
{
    enum { n = 2 };
    num R[2 * (n + 1)], w[n + 1], v[n + 1], P[2], Q[2];
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    given_points(T, "ω*", n + 1, 1, v);
    num t = given(T, "t");
    int different = G(found_invariants_differ)(T, n, w, v);
    G(rational_point)(n, 2, R, w, t, P);
    G(rational_point)(n, 2, R, v, t, Q);
    found_points(T, "R(t)", 1, 2, P);
    found_points(T, "R*(t)", 1, 2, Q);
    about(T, "the first coordinates of R(t) and R*(t)");
    if (!different && turn_2d(R, R + 2, R + 4) != 0)
        same(T, P[0], Q[0]);
}

/* Is the curve of (R, v) the half turn (x,y,z) -> (-x,-y,z) of the curve of (R, w) run backwards, and are neither the first
 * nor the last three edges coplanar?  n <= 5. */
static int G(is_half_turn_backwards)(int n, const num R[], const num w[], const num v[])
{
    num S[3 * 6], back[6];
    G(reversed_points)(n, 3, R, S);
    G(reversed_points)(n, 1, w, back);
    for (int i = 0; i <= n; i++)
        for (int c = 0; c < 2; c++)
            S[3 * i + c] = neg(S[3 * i + c]);
    return G(one_map)(n, 3, R, v, S, back) && !is_zero_q(G(edges_det)(R, 1, 2, 3)) &&
           !is_zero_q(G(edges_det)(R, n - 2, n - 1, n));
}

/*
If it meant congruent curves, equal shape would not be enough: a motion that carries the polygon into itself in
reverse order carries the curve of the weights $\omega$ into that of the reversed weights.

:::{claim} congruent_cubics_with_other_invariants
:title: Two congruent cubics over one polygon with different invariants
:zh: 同一控制多边形上全等而不变量不同的三次曲线
:kind: counterexample
:data: R = (1,0,0) (0,1,1) (0,-1,1) (-1,0,0); ω = 1 1 2 1
:instead: ω = 1 2 2 1
:result: I = 1/2 4; I* = 4 1/2
:given: the cubic curve with points $R$ and weights $\omega$, and $\omega^*$, which is $\omega$ in reverse order
:then: $R^*(t)=h(R(1-t))$ with the half turn $h(x,y,z)=(-x,-y,z)$, so that the curves are congruent; the edges are not
  coplanar; but $I$ and $I^*$ differ
:method: That the second curve is the half turn of the first run backwards is decided by comparing polynomials,
  before the invariants are compared.
:control: weights that do not change in reverse order
:::
*/
CLAIM(congruent_cubics_with_other_invariants)
{
    enum { n = 3 };
    num R[3 * (n + 1)], w[n + 1], v[n + 1], I[n - 1], J[n - 1];
    given_points(T, "R", n + 1, 3, R);
    given_points(T, "ω", n + 1, 1, w);
    G(reversed_points)(n, 1, w, v);
    (void)G(found_invariants_differ)(T, n, w, v);
    G(rational_invariants)(n, w, I);
    G(rational_invariants)(n, v, J);
    about(T, "I_1 and I_1^*");
    if (G(is_half_turn_backwards)(n, R, w, v))
        same(T, I[0], J[0]);
}

/*
:::{claim} congruent_curves_beyond_cubics
:title: Congruent quartics and quintics over one polygon with different invariants
:zh: 四、五次的同类例子
:kind: decision
:data: R (quartic) = (1,0,0) (0,1,1) (0,0,2) (0,-1,1) (-1,0,0); ω (quartic) = 1 1 1 2 1;
  R (quintic) = (1,0,0) (0,1,1) (1,1,2) (-1,-1,2) (0,-1,1) (-1,0,0); ω (quintic) = 1 1 1 1 2 1
:instead: ω (quartic) = 1 2 1 2 1; ω (quintic) = 1 2 1 1 2 1
:given: for $n=4$ and for $n=5$ a curve with points $R$ and weights $\omega$, and $\omega^*$, which is $\omega$ in reverse order
:then: $R^*(t)=h(R(1-t))$ with the half turn $h(x,y,z)=(-x,-y,z)$; the first and the last three edges are not
  coplanar; but the invariants differ
:method: The polynomials of the two curves are compared; the rest is exact arithmetic.
:degrees: 4..5
:control: weights that do not change in reverse order
:::
*/
CLAIM(congruent_curves_beyond_cubics)
{
    int n = T->degree;
    num R[2][3 * 6], w[2][6], v[6];
    given_points(T, "R (quartic)", 5, 3, R[0]);
    given_points(T, "ω (quartic)", 5, 1, w[0]);
    given_points(T, "R (quintic)", 6, 3, R[1]);
    given_points(T, "ω (quintic)", 6, 1, w[1]);
    G(reversed_points)(n, 1, w[n - 4], v);
    agree(T, G(is_half_turn_backwards)(n, R[n - 4], w[n - 4], v));
    agree(T, G(invariants_differ)(n, w[n - 4], v));
}
#endif

/*
## The printed proof

The source proves the case $n=5$.  It compares curvature and torsion at the start, gets $I_1$ and $I_2$, and leaves
the other end to symmetry.

:::{statement} wang-ch3:thm-3.2.1-sufficiency
:title: One direction is property 3.2.10
:zh: 充分性即性质 3.2.10
:printed: The sufficiency is property 3.2.10.
:holds-by: equal_invariants_mean_geometric_ratios factors_make_a_geometric_sequence fractional_change_term_by_term
  larger_numbers_have_larger_powers fractional_change_runs_once
:confirmed-by: equal_invariants_give_same_curve
:needs: equal_invariants_reach_the_other_arc | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive
:::

:::{statement} wang-ch3:thm-3.2.1-proof-start
:title: Curvature and torsion agree at the start
:zh: 曲线始端的曲率与挠率相等
:printed: As the curves have the same shape, the curvature or the torsion agrees all along, and in particular the
  curvature or the torsion at the start.
:holds-by: backward_run_flattens_the_first_edges derivative_vectors_at_zero_in_every_degree derivative_vectors_at_one_in_every_degree
  bernstein_sum_of_powers_is_a_power
  change_of_parameter_acts_on_one_factor mean_grows_by_one_term weight_can_be_divided_out
:meant: the sentence before the theorem, by which curves of one shape differ in their parameter alone | The same shape
  is the same point set.
:reading: congruent_cubics_with_other_invariants | congruent curves, of which the starts need not correspond
:needs: palindromes_of_degree_five | theorem 3.2.1, where the first three points are not collinear, and the first three edges not coplanar for
  $n\ge3$ | the first edges are independent: $\mathbf a_1\times\mathbf a_2\ne\mathbf 0$ for $n=2$ and $(\mathbf a_1,\mathbf a_2,\mathbf a_3)\ne0$
  for $n\ge3$.  Otherwise the point set may be run backwards, and the start of one curve is the end of the other.  In the example the last three edges
  are coplanar, too, and the torsions agree, both being 0, but not the curvatures.  For $n=3$ it is enough that $\mathbf a_1\times\mathbf a_2\ne\mathbf 0$, as is said at theorem 3.2.1.
:cites: [sendra-winkler-perez-diaz-2008]: two proper parametrizations of one rational curve differ by a fractional
  linear change of the parameter | It is used for the two curves, which step (1) of theorem 3.2.1 shows to be proper.
:argued: | The two parameters differ by a projective map that takes $[0,1]$ onto itself.  If it exchanged the ends, the first edges would be dependent by
  `backward_run_flattens_the_first_edges`, as the end derivatives have the directions of the edges; so start corresponds to start.  The source takes this for granted.  Curvature and torsion do not depend on the parameter.

As printed, with "or", the sentence says less than what is true and used: curvature and torsion agree, at all corresponding points where they exist, and at the start they do.
:::
*/

#if RATIONAL
/*
The curvatures at the ends contain $I_1$ and $I_{n-1}$.  From $n=4$ on an invariant lies between, which only the torsions see.

:::{claim} curvatures_alone_miss_the_middle_invariant
:title: The curvatures at both ends do not determine the middle invariant
:zh: 仅端点曲率不能确定中间的不变量
:kind: counterexample
:data: R = (0,0,0) (1,0,0) (1,1,0) (1,1,1) (0,1,1); ω = 1 1 1 1 1; ω* = 1 1 1 2 4
:instead: ω* = 1 1 1 1 1
:result: κ(0)², κ(1)² = 9/16 9/16; κ*(0)², κ*(1)² = 9/16 9/16; I = 1 1 1; I* = 1 1/2 1
:given: the quartic curves with points $R$ and weights $\omega$ and $\omega^*$
:then: $\kappa(0)=\kappa^*(0)$ and $\kappa(1)=\kappa^*(1)$, but $I_2\ne I_2^*$
:method: The squared curvatures are computed from the derivatives of the curves, and are equal; then the invariants
  are compared.
:control: the same weights twice
:::
*/
CLAIM(curvatures_alone_miss_the_middle_invariant)
{
    enum { n = 4 };
    num R[3 * (n + 1)], w[n + 1], v[n + 1], I[n], J[n], first[2], second[2];
    given_points(T, "R", n + 1, 3, R);
    given_points(T, "ω", n + 1, 1, w);
    given_points(T, "ω*", n + 1, 1, v);
    for (int end = 0; end < 2; end++) {
        first[end] = G(rational_curvature_squared)(n, 3, R, w, from_int(end));
        second[end] = G(rational_curvature_squared)(n, 3, R, v, from_int(end));
    }
    found_points(T, "κ(0)², κ(1)²", 2, 1, first);
    found_points(T, "κ*(0)², κ*(1)²", 2, 1, second);
    (void)G(found_invariants_differ)(T, n, w, v);
    G(rational_invariants)(n, w, I);
    G(rational_invariants)(n, v, J);
    about(T, "I_2 and I_2^*");
    if (equal_q(first[0], second[0]) && equal_q(first[1], second[1]))
        same(T, I[1], J[1]);
}

#endif

/*
:::{statement} wang-ch3:thm-3.2.1-proof-display
:title: The differences of curvature and torsion at the start, n = 5
:zh: 始端曲率与挠率之差(n=5)
:printed: By property 3.2.4
  $\frac45\Bigl(\frac{\omega_0\omega_2}{\omega_1^2}-\frac{\omega_0^*\omega_2^*}{\omega_1^{*2}}\Bigr)
  \frac{\|\mathbf a_1\times\mathbf a_2\|}{\|\mathbf a_1\|^3}
  =\frac35\Bigl(\frac{\omega_0\omega_3}{\omega_1\omega_2}-\frac{\omega_0^*\omega_3^*}{\omega_1^*\omega_2^*}\Bigr)
  \frac{(\mathbf a_1,\mathbf a_2,\mathbf a_3)}{\|\mathbf a_1\times\mathbf a_3\|^2}=0$
:class: misprint
:refuted-by: printed_torsion_denominator_is_wrong
:corrected: \kappa(0)-\kappa^*(0)=\frac45\Bigl(\frac{\omega_0\omega_2}{\omega_1^2}-
  \frac{\omega_0^*\omega_2^*}{\omega_1^{*2}}\Bigr)\frac{\|\mathbf a_1\times\mathbf a_2\|}{\|\mathbf a_1\|^3}=0,\quad
  \tau(0)-\tau^*(0)=\frac35\Bigl(\frac{\omega_0\omega_3}{\omega_1\omega_2}-
  \frac{\omega_0^*\omega_3^*}{\omega_1^*\omega_2^*}\Bigr)
  \frac{(\mathbf a_1,\mathbf a_2,\mathbf a_3)}{\|\mathbf a_1\times\mathbf a_2\|^2}=0
:corrected-by: quintic_starts_with_these_factors factor_of_the_curvature_is_positive backward_run_flattens_the_first_edges
  derivative_vectors_at_zero_in_every_degree derivative_vectors_at_one_in_every_degree bernstein_sum_of_powers_is_a_power
  change_of_parameter_acts_on_one_factor mean_grows_by_one_term weight_can_be_divided_out
:confirmed-by: end_torsion_contains_two_invariants end_curvature_contains_one_invariant
:needs: palindromes_of_degree_five | theorem 3.2.1: the first three edges are not coplanar | $(\mathbf a_1,\mathbf a_2,\mathbf a_3)\ne0$; otherwise
  the point set may be run backwards, in the example with the last three edges coplanar, too, and the start of one curve is the end of the other
:cites: [sendra-winkler-perez-diaz-2008]: two proper parametrizations of one rational curve differ by a fractional
  linear change of the parameter | It is used for the two curves, which step (1) of theorem 3.2.1 shows to be proper.
:argued: | That both differences are 0: the two parameters differ by a projective map that takes $[0,1]$ onto itself; if it exchanged the ends, the first edges would be
  dependent by `backward_run_flattens_the_first_edges`, as the end derivatives have the directions of the edges; so start corresponds to start, and curvature and torsion agree there.
:figure: torsion_misprint

One index: the denominator is $\|a_1\times a_2\|^2$, by (3.2.6).  The counterexample
has two curves of different shape, while the display stands under the hypothesis of one shape, under which it reads $0=0$; what it refutes is that the second
expression is the difference of the torsions.  The two expressions are the differences of the curvatures
and of the torsions, without their left sides.
:::

The two factors are those of $n=5$:

:::{claim} quintic_starts_with_these_factors
:title: Curvature and torsion at the start of a quintic
:zh: 五次曲线始端的曲率与挠率
:given: $n=5$, weights $\omega_0,\dots,\omega_5$ and points $R_0,\dots,R_5$ of space, $a_1\times a_2\ne0$
:where: $\mathbf a_1\times\mathbf a_2\ne\mathbf 0$; no weight is 0
:then: $\kappa(0)^2=\left(\frac45\frac{\omega_0\omega_2}{\omega_1^2}\right)^2\frac{\|a_1\times a_2\|^2}{\|a_1\|^6}$ and
  $\tau(0)=\frac35\frac{\omega_0\omega_3}{\omega_1\omega_2}\frac{(a_1,a_2,a_3)}{\|a_1\times a_2\|^2}$
:method: From the derivatives of the curve, with all weights and coordinates variables.  The difference of two curves over the same points is that of their weights' factors times
  the geometric ones.
:degrees: 5..5
:control: $\|a_1\times a_3\|^2$ in the torsion, as printed
:::
*/
/* Curvature and torsion of a quintic at t = end, 0 or 1, with its three edges and four weights from that end on. */
static void G(compare_the_end_of_a_quintic)(trial *T, int end)
{
    enum { n = 5 };
    num w[n + 1], v[4], R[3 * (n + 1)], a[3][3], t = from_int(end);
    G(free_curve)(T, n, 3, R, w);
    for (int k = 0; k < 4; k++)
        v[k] = w[end ? n - k : k];
    for (int k = 0; k < 3; k++)
        G(edge)(3, R, end ? n - k : k + 1, a[k]);
    num g = G(norm_squared)(3, a[0]), area = G(gram)(3, a[0], a[1]), volume = G(det3)(a[0], a[1], a[2]);
    num factor = mul(from_ratio(4, 5), div(mul(v[0], v[2]), mul(v[1], v[1])));
    about(T, "curvature squared");
    same(T, mul(G(rational_curvature_squared)(n, 3, R, w, t), mul(g, mul(g, g))), mul(mul(factor, factor), area));
    about(T, "torsion");
    num other = mul(from_ratio(3, 5), div(mul(v[0], v[3]), mul(v[1], v[2])));
    num below = fault(T, area, G(gram)(3, a[0], a[2]));
    same(T, mul(G(rational_torsion)(n, R, w, t), below), mul(other, end ? neg(volume) : volume));
}

CLAIM(quintic_starts_with_these_factors) { G(compare_the_end_of_a_quintic)(T, 0); }

/*
:::{claim} quintic_ends_with_these_factors
:title: Curvature and torsion at the end of a quintic
:zh: 五次曲线末端的曲率与挠率
:given: $n=5$, weights $\omega_0,\dots,\omega_5$ and points $R_0,\dots,R_5$ of space, $a_4\times a_5\ne0$
:where: $\mathbf a_4\times\mathbf a_5\ne\mathbf 0$; no weight is 0
:then: $\kappa(1)^2=\left(\frac45\frac{\omega_5\omega_3}{\omega_4^2}\right)^2\frac{\|a_4\times a_5\|^2}{\|a_5\|^6}$ and
  $\tau(1)=\frac35\frac{\omega_5\omega_2}{\omega_4\omega_3}\frac{(a_3,a_4,a_5)}{\|a_4\times a_5\|^2}$
:method: From the derivatives of the curve, with all weights and coordinates variables.  The difference of two curves over the same points is that of their weights' factors times
  the geometric ones.
:degrees: 5..5
:control: $\|a_3\times a_5\|^2$ in the torsion
:::
*/
CLAIM(quintic_ends_with_these_factors) { G(compare_the_end_of_a_quintic)(T, 1); }

#if RATIONAL
/*
To see the wrong index, the first three edges are taken at right angles, with $|a_2|\ne|a_3|$.

:::{claim} printed_torsion_denominator_is_wrong
:title: The torsion has the first two edges in its denominator, not the first and the third
:zh: 挠率之差的分母误印
:kind: counterexample
:data: R = (0,0,0) (1,0,0) (1,1,0) (1,1,2) (2,1,2) (2,2,2); ω = 1 1 1 1 1 1; ω* = 1 1 1 2 1 1
:result: τ(0) - τ*(0) = -6/5; as printed = -3/10
:given: the quintic curves with points $R$ and weights $\omega$ and $\omega^*$; $a_i=R_i-R_{i-1}$
:then: the printed expression, with $\|a_1\times a_3\|^2$ in the denominator, is not $\tau(0)-\tau^*(0)$
:method: The torsions are computed from the derivatives of the curves.
:control: $\|a_1\times a_2\|^2$ in the denominator
:::
*/
CLAIM(printed_torsion_denominator_is_wrong)
{
    enum { n = 5 };
    num R[3 * (n + 1)], w[n + 1], v[n + 1], a[3][3], zero = from_int(0);
    given_points(T, "R", n + 1, 3, R);
    given_points(T, "ω", n + 1, 1, w);
    given_points(T, "ω*", n + 1, 1, v);
    for (int k = 0; k < 3; k++)
        G(edge)(3, R, k + 1, a[k]);
    num difference = sub(G(rational_torsion)(n, R, w, zero), G(rational_torsion)(n, R, v, zero));
    /* (n-2)/n (ω_0 ω_3/(ω_1 ω_2) - ω*_0 ω*_3/(ω*_1 ω*_2)) (a_1, a_2, a_3)/|a_1 × a_3|² */
    num change = sub(div(mul(w[0], w[3]), mul(w[1], w[2])), div(mul(v[0], v[3]), mul(v[1], v[2])));
    num area = G(gram)(3, a[0], fault(T, a[1], a[2]));
    num printed = mul(from_ratio(n - 2, n), mul(change, div(G(det3)(a[0], a[1], a[2]), area)));
    found(T, "τ(0) - τ*(0)", difference);
    found(T, "as printed", printed);
    about(T, "τ(0) - τ*(0), left as it is, right as printed");
    same(T, difference, printed);
}
#endif

/*
:::{statement} wang-ch3:thm-3.2.1-proof-nonzero
:title: The geometric factors do not vanish, so the weights' factors do
:zh: 几何因子非零故权因子之差为零
:printed: As $R_0,R_1,R_2$ are not collinear and $a_1,a_2,a_3$ not coplanar, $a_1\times a_2\ne0$ and
  $(a_1,a_2,a_3)\ne0$; hence $I_1=I_1^*$ and
  $\omega_0\omega_3/(\omega_1\omega_2)=\omega_0^*\omega_3^{*}/(\omega_1^*\omega_2^*)$.
:holds-by: quintic_starts_with_these_factors factor_of_the_curvature_is_positive end_factors_are_reciprocals_of_invariants
:confirmed-by: end_curvature_contains_one_invariant end_torsion_contains_two_invariants
:needs: common_factor_hides_the_weights | the sentence itself | $(\mathbf a_1,\mathbf a_2,\mathbf a_3)\ne0$; in a plane one and the same quintic can have
  several $I_2$, and both torsions are 0.  In the example the last three edges are coplanar, too.

The proof is for $n=5$.  In the two differences, of the curvatures and of the torsions, which are 0, the geometric factors are not 0, so that the factors of the weights are.  The
quotient of the second equation is $1/(I_1I_2)$.
:::

:::{statement} wang-ch3:thm-3.2.1-proof-product
:title: The product of the two equations gives the second invariant
:zh: 两式相乘得第二个不变量
:printed: Multiplying $I_1=I_1^*$ and
  $(\omega_0\omega_3)/(\omega_1\omega_2)=(\omega_0^*\omega_3^*)/(\omega_1^*\omega_2^*)$ gives $I_2=I_2^*$
:holds-by: product_is_the_inverse_second_invariant

The product is $1/I_2$, which does as well.
:::

:::{claim} end_factors_are_reciprocals_of_invariants
:title: The weights in the end curvature and torsion are 1/I_1 and 1/(I_1 I_2), in every degree
:zh: 端点曲率与挠率中的权因子之比即不变量的倒数(任意次数)
:given: weights $\omega_0,\dots,\omega_3$, none of them 0; or $\omega_n,\dots,\omega_{n-3}$ in their places
:where: no weight is 0
:then: $I_1\frac{\omega_0\omega_2}{\omega_1^2}=1$ and $I_1I_2\frac{\omega_0\omega_3}{\omega_1\omega_2}=1$; at the other end with $I_{n-1}$ and $I_{n-2}$
:method: Identities of rational functions of the four weights; the degree of the curve does not matter.  For $n=2$ only the first one has a meaning.
:degrees: all
:control: $I_1$ for $I_1I_2$
:::
*/
CLAIM(end_factors_are_reciprocals_of_invariants)
{
    num w[4], I[3], one = from_int(1);
    for (int i = 0; i < 4; i++)
        w[i] = unknown(T, "w", i);
    G(rational_invariants)(3, w, I);
    about(T, "curvature");
    same(T, mul(I[0], div(mul(w[0], w[2]), mul(w[1], w[1]))), one);
    about(T, "torsion");
    same(T, mul(mul(I[0], fault(T, I[1], one)), div(mul(w[0], w[3]), mul(w[1], w[2]))), one);
}

/*

:::{claim} product_is_the_inverse_second_invariant
:title: The product of the two quotients is the reciprocal of the second invariant
:zh: 乘积即第二不变量的倒数
:given: weights $\omega_0,\dots,\omega_3$, none of them $0$
:then: $I_1\frac{\omega_0\omega_3}{\omega_1\omega_2}=\frac{\omega_1\omega_3}{\omega_2^2}=\frac1{I_2}$
:method: An identity of rational functions of the four weights; the degree of the curve does not matter.
:scope: every degree from 3 on
:where: no weight is 0
:control: $I_2$ for $1/I_2$
:::
*/
CLAIM(product_is_the_inverse_second_invariant)
{
    num w[4], I[3];
    for (int i = 0; i < 4; i++)
        w[i] = unknown(T, "w", i);
    G(rational_invariants)(3, w, I);
    num product = mul(I[0], div(mul(w[0], w[3]), mul(w[1], w[2])));
    /* I_1 ω_0 ω_3/(ω_1 ω_2) = ω_1 ω_3/ω_2² = 1/I_2 */
    same(T, product, div(mul(w[1], w[3]), mul(w[2], w[2])));
    same(T, product, fault(T, div(from_int(1), I[1]), I[1]));
}

/*
:::{statement} wang-ch3:thm-3.2.1-proof-symmetry
:title: The other end gives the other two invariants
:zh: 由对称性得另两个不变量
:printed: By the symmetry of the curve also $I_4=I_4^*$, $I_3=I_3^*$
:holds-by: quintic_ends_with_these_factors factor_of_the_curvature_is_positive end_factors_are_reciprocals_of_invariants
  backward_run_flattens_the_first_edges derivative_vectors_at_zero_in_every_degree derivative_vectors_at_one_in_every_degree
  bernstein_sum_of_powers_is_a_power change_of_parameter_acts_on_one_factor mean_grows_by_one_term weight_can_be_divided_out
:confirmed-by: reversal_exchanges_invariants end_curvature_contains_one_invariant end_torsion_contains_two_invariants
:needs: common_factor_hides_the_weights | the theorem | the last three edges are not coplanar: so the last three points are not on a line; in a plane
  one and the same quintic can have several $I_3$.  In the example the first three edges are coplanar, too.
:cites: [sendra-winkler-perez-diaz-2008]: two proper parametrizations of one rational curve differ by a fractional
  linear change of the parameter | It is used for the two curves, which step (1) of theorem 3.2.1 shows to be proper.
:argued: | That the curvatures and the torsions agree at the end: the two parameters differ by a projective map that takes $[0,1]$ onto itself; if it exchanged the ends, the last edges
  would be dependent by `backward_run_flattens_the_first_edges` for the reversed polygon, as the end derivatives have the directions of the edges; so end corresponds to end.

The proof is for $n=5$.  That the curvatures and the torsions agree at the other end, too, the source leaves to the symmetry.
Reversing points and weights exchanges the two ends, $I_i$ with $I_{n-i}$, and the hypotheses with each other.  That the last three edges are not coplanar is what this argument needs; that $I_3=I_3^*$ and $I_4=I_4^*$ follows
from the first three edges alone as well, as is said at theorem 3.2.1.
:::

:::{statement} wang-ch3:thm-3.2.1-proof-other-degrees
:title: The necessity is proved for n = 5 only
:zh: 仅就 n=5 证明必要性
:printed: Now the necessity is proved for $n=5$ only.
:holds-by: backward_run_flattens_the_first_edges derivative_vectors_at_zero_in_every_degree derivative_vectors_at_one_in_every_degree
  curvature_and_torsion_follow_at_zero_in_every_degree curvature_and_torsion_follow_at_one_in_every_degree
  factor_of_the_curvature_is_positive end_factors_are_reciprocals_of_invariants
  bernstein_sum_of_powers_is_a_power change_of_parameter_acts_on_one_factor mean_grows_by_one_term weight_can_be_divided_out
:confirmed-by: end_curvature_contains_one_invariant end_torsion_contains_two_invariants
:meant: the theorem, which is stated for $n=2,3,4,5$ | The proof for $n=5$ contains those for the other $n$.
:needs: segment_has_two_invariants | the theorem | at both ends three points are not collinear, and for $n=3,4,5$ three edges not
  coplanar; the example has $n=2$ and points of a line; what of it $n=3,4,5$ need is said at theorem 3.2.1
:cites: [sendra-winkler-perez-diaz-2008]: two proper parametrizations of one rational curve differ by a fractional
  linear change of the parameter | It is used for the two curves, which step (1) of theorem 3.2.1 shows to be proper.
:argued: | The two parameters differ by a projective map that takes $[0,1]$ onto itself; if it exchanged the ends, the first edges would be dependent by
  `backward_run_flattens_the_first_edges`, as the end derivatives have the directions of the edges; so start corresponds to start and end to end, and curvatures and torsions agree there.

$n=2$: $\kappa(0)$ gives $I_1$.  $n=3$: $\kappa(0),\kappa(1)$ give $I_1,I_2$.  $n=4$: these give $I_1,I_3$, and
$\tau(0)$ gives $I_2$.
:::
*/
#include "chapters/judge/claims_off.h"
