/*
# When the shape determines the weights (形状与不变量)

Equal invariants give the same curve in every degree.  Theorem 3.2.1 is the converse for
$n=2,\dots,5$: with the points fixed, the curve determines the invariants.  The idea is short.  At an end
the curvature contains one invariant and the torsion two; up to $n=5$ both ends together see them all.

Below, $a_i=R_i-R_{i-1}$, and "same shape" has to be made precise first: the same point set; the same point
set run in the same direction; the same map of the parameter; or congruent curves.
*/
#include "exact/record/sign.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch3:thm-3.2.1
:title: For n = 2, ..., 5 the same shape means the same invariants
:zh: n=2,3,4,5 时形状相同当且仅当不变量相同
:printed: Let $n=2,3,4,5$, let neither the first nor the last three control points be collinear, and for $n\ge3$
  neither the first nor the last three edge vectors be coplanar.  Then (3.2.2) and (3.2.13) have the same shape if
  and only if $I_i=I_i^*$, $i=1,\dots,n-1$
:holds-by: backward_run_flattens_the_first_edges end_curvature_contains_one_invariant end_torsion_contains_two_invariants
  equal_invariants_give_same_curve
:reading: backward_run_flattens_the_first_edges | same point set, the reading of property 3.2.10: holds
:reading: end_torsion_contains_two_invariants | same point set in the same direction: holds
:reading: plane_cubic_cannot_run_backwards | same point set, and for $n=3$ nothing asked of the edges: holds as
  well; three points not collinear at each end suffice, as the curvatures give $I_1$ and $I_2$
:reading: equal_invariants_other_speed | same map of the parameter: "if" fails, as the parameter is distributed
  differently; the source excludes this reading
:reading: congruent_cubics_with_other_invariants | congruent curves: "only if" fails; the motion may exchange the
  ends, and with them the weights (so for $n=4,5$ as well: congruent_curves_beyond_cubics)
:needs: equal_invariants_reach_the_other_arc | positive weights, for "if"
:needs: segment_has_two_invariants | $n=2$: the three points not collinear
:needs: palindromes_of_degree_four | $n=4$: edges not coplanar at one end at least; without it the point set, run
  backwards, has other invariants
:needs: common_factor_hides_the_weights | $n=5$: edges not coplanar; a plane quintic can be one and the same map for
  weights with different invariants
:needs: space_palindromes_beyond_degree_five | $n\le5$: for $n\ge6$ the point set, run backwards, can have other
  invariants
:figure: shape_and_invariants

The direction "if" is property 3.2.10 and needs nothing but positive weights.  For "only if" let the two curves have
one point set $T$.

(1) *They are proper.* For $n=2$, $T$ is an arc of a proper conic.  For $n\ge3$, $T$ is in no plane, as its points
$R_i$ are in none, so its algebraic curve has degree at least $3$; after removal of common factors each
parametrization has a degree of at most $5$ that is a multiple of it, hence equal to it: it is run once, and the two
differ by a projective map $\varphi$ of the parameter line that maps $[0,1]$ onto itself.

(2) *They have one direction.* If $\varphi$ exchanged $0$ and $1$, then $R_0=R_n$, $a_1\parallel a_n$, and for
$n\ge5$ the planes of $a_1,a_2$ and of $a_{n-1},a_n$ would be one; each time the first edges are then dependent,
against the hypothesis.

(3) So curvature and torsion agree at corresponding ends, and they determine $I_1$, $I_1I_2$, $I_{n-1}$,
$I_{n-2}I_{n-1}$: for $n\le5$ these give every invariant.

For $n\ge3$ edges that are not coplanar make the points not collinear by themselves.  For $n=4$ one of the two
torsions suffices.  What is true in every degree stands after definition 3.2.2.
:::
*/

/* a = R_j - R_i in space. */
static void G(between)(const num R[], int i, int j, num a[3])
{
    for (int c = 0; c < 3; c++)
        a[c] = sub(R[3 * j + c], R[3 * i + c]);
}

/* n+1 points of space and weights, all free, at the end t = 0 or, in reverse order, at t = 1. */
static void G(free_space_curve)(trial *T, int n, num R[], num w[])
{
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        R[3 * i] = unknown(T, "x", i);
        R[3 * i + 1] = unknown(T, "y", i);
        R[3 * i + 2] = unknown(T, "z", i);
    }
}

/*
:::{claim} end_curvature_contains_one_invariant
:title: The curvature at an end contains exactly the first invariant
:zh: 端点曲率只含一个不变量
:given: positive weights $\omega_0,\dots,\omega_n$ and points $R_0,\dots,R_n$ of space, $a_1\ne0$, $a_n\ne0$
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
    G(free_space_curve)(T, n, R, w);
    G(rational_invariants)(n, w, I);
    for (int end = 0; end < 2; end++) {
        G(between)(R, end ? n - 1 : 0, end ? n : 1, a);
        G(between)(R, end ? n - 2 : 1, end ? n - 1 : 2, b);
        num square = G(rational_curvature_squared)(n, 3, R, w, from_int(end));
        num g = G(norm_squared)(3, a), J = I[end ? n - 2 : 0];
        J = fault(T, J, n == 2 ? add(J, J) : I[end ? n - 3 : 1]);
        about(T, end ? "at t = 1" : "at t = 0");
        same(T, mul(mul(square, mul(J, J)), mul(g, mul(g, g))), mul(factor, G(gram)(3, a, b)));
    }
}

/*
:::{claim} end_torsion_contains_two_invariants
:title: The torsion at an end contains exactly the product of the first two invariants
:zh: 端点挠率含前两个不变量之积
:given: positive weights $\omega_0,\dots,\omega_n$ and points $R_0,\dots,R_n$ of space, $a_1\times a_2\ne0$,
  $a_{n-1}\times a_n\ne0$
:then: $\tau(0)I_1I_2\|a_1\times a_2\|^2=\frac{n-2}n(a_1,a_2,a_3)$ and
  $\tau(1)I_{n-2}I_{n-1}\|a_{n-1}\times a_n\|^2=\frac{n-2}n(a_{n-2},a_{n-1},a_n)$
:method: As for the curvature, from the derivatives of the curve.  When $(a_1,a_2,a_3)\ne0$, curvature and torsion
  at $0$ determine $I_1$ and $I_2$; when $(a_{n-2},a_{n-1},a_n)\ne0$, those at $1$ determine $I_{n-1}$ and
  $I_{n-2}$: all invariants for $n\le5$, and for $n=4$ one of the torsions is enough.
:degrees: 3..6 sampled 10
:control: $I_1$ for $I_1I_2$
:::
*/
CLAIM(end_torsion_contains_two_invariants)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[3 * (MAX_DEGREE + 1)], I[MAX_DEGREE], a[3], b[3], c[3];
    G(free_space_curve)(T, n, R, w);
    G(rational_invariants)(n, w, I);
    for (int end = 0; end < 2; end++) {
        int first = end ? n - 3 : 0;
        G(between)(R, first, first + 1, a);
        G(between)(R, first + 1, first + 2, b);
        G(between)(R, first + 2, first + 3, c);
        num torsion = G(rational_torsion)(n, R, w, from_int(end));
        num area = end ? G(gram)(3, b, c) : G(gram)(3, a, b);
        num J = fault(T, mul(end ? I[n - 2] : I[0], end ? I[n - 3] : I[1]), end ? I[n - 2] : I[0]);
        about(T, end ? "at t = 1" : "at t = 0");
        same(T, mul(torsion, mul(J, area)), mul(from_ratio(n - 2, n), G(det3)(a, b, c)));
    }
}

/*
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

:::{claim} plane_cubic_cannot_run_backwards
:title: A cubic with three points not collinear at its start is not the other one run backwards
:zh: 三次曲线:首三点不共线即不可能反向重合
:given: $n=3$, $a_1+a_2+a_3=0$ and $a_3=c\,a_1$
:then: $a_1\times a_2=0$
:method: $a_2=-(1+c)a_1$.  So for $n=3$ the direction is fixed when $R_0,R_1,R_2$ are not collinear, in the plane as
  well; and a cubic that is no part of a line, common factors removed, is run once, as its degree is at most $3$ and
  that of its curve at least $2$.  The end curvatures then give $I_1$ and $I_2$: no condition on three edges is
  needed.
:scope: n = 3
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
:control: the weight $\omega_n$ doubled
:::
*/
CLAIM(common_factor_hides_the_weights)
{
    num t = parameter(T, "t"), c = positive(T, "c", 0);
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
/* Shows two sets of weights with their invariants; are these different? */
static int G(invariants_differ)(trial *T, int n, const num w[], const num v[])
{
    num I[MAX_DEGREE], J[MAX_DEGREE];
    int different = 0;
    G(rational_invariants)(n, w, I);
    G(rational_invariants)(n, v, J);
    for (int i = 1; i < n; i++)
        different |= !equal_q(I[i - 1], J[i - 1]);
    show_points(T, "ω", n + 1, 1, w);
    show_points(T, "I", n - 1, 1, I);
    show_points(T, "ω*", n + 1, 1, v);
    show_points(T, "I*", n - 1, 1, J);
    return different;
}

/*
:::{claim} segment_has_two_invariants
:title: On a line the point set does not determine the invariant
:zh: 共线时点集不能确定不变量
:kind: decision
:given: $n=2$, the points $0,1,2$ of a line, $\omega=(1,2,1)$ and $\omega^*=(1,3,1)$
:then: both curves run monotonically from $0$ to $2$, so that their point set is the segment $[0,2]$, and neither
  has a common factor; $I_1=4$ and $I_1^*=9$
:method: The numerators of the derivatives are positive on $[0,1]$, decided exactly; numerator and denominator of
  each curve have degree $2$ and a constant greatest common divisor.
:control: $\omega^*=(1,2,1)$
:::
*/
CLAIM(segment_has_two_invariants)
{
    enum { n = 2 };
    num R[] = {from_int(0), from_int(1), from_int(2)}, zero = from_int(0), one = from_int(1);
    num w[2][3] = {{one, from_int(2), one}, {one, from_int(fault(T, 3, 2)), one}};
    show_points(T, "R", n + 1, 1, R);
    agree(T, G(invariants_differ)(T, n, w[0], w[1]));
    for (int k = 0; k < 2; k++) {
        num x[n + 1];
        for (int i = 0; i <= n; i++)
            x[i] = mul(w[k][i], R[i]);
        poly N = poly_from_bernstein(n, x), D = poly_from_bernstein(n, w[k]);
        poly slope = poly_sub(poly_mul(poly_derivative(N), D), poly_mul(N, poly_derivative(D)));
        agree(T, sign_on(slope, zero, one, CLOSED) == SIGN_POSITIVE);
        agree(T, poly_degree(N) == n && poly_degree(D) == n && poly_degree(poly_gcd(N, D)) == 0);
    }
}

/* The curves of (R, w) and of (S, v) are one map of t: the cross products of numerators and denominators
 * are equal polynomials. */
static int G(one_map)(int n, int dim, const num R[], const num w[], const num S[], const num v[])
{
    int equal = 1;
    for (int c = 0; c < dim; c++) {
        num x[MAX_DEGREE + 1], y[MAX_DEGREE + 1];
        for (int i = 0; i <= n; i++) {
            x[i] = mul(w[i], R[i * dim + c]);
            y[i] = mul(v[i], S[i * dim + c]);
        }
        equal &= poly_equal(poly_mul(poly_from_bernstein(n, x), poly_from_bernstein(n, v)),
                            poly_mul(poly_from_bernstein(n, y), poly_from_bernstein(n, w)));
    }
    return equal;
}

/* S(t) = R(1-t): points and weights in reverse order. */
static void G(run_backwards)(int n, int dim, const num R[], const num w[], num S[], num v[])
{
    for (int i = 0; i <= n; i++) {
        v[i] = w[n - i];
        for (int c = 0; c < dim; c++)
            S[i * dim + c] = R[(n - i) * dim + c];
    }
}

/*
:::{claim} palindromes_of_degree_four
:title: A plane quartic over a palindromic polygon, run backwards, has other invariants
:zh: 四次平面回文多边形:反向后不变量不同
:kind: decision
:given: $n=4$, the points $(0,0),(1,0),(0,1),(1,0),(0,0)$, $\omega=(1,2,1,1,1)$ and $\omega^*=(1,1,1,2,1)$
:then: $R^*(t)=R(1-t)$, so that the point sets are one; the first and the last three points are not collinear; but
  $I=(4,\frac12,1)$ and $I^*=(1,\frac12,4)$
:method: The polynomials of the two curves are compared; the rest is exact arithmetic.
:control: the weights $\omega_1$ and $\omega_3$ both $2$
:::
*/
/* Are R_i, R_{i+1}, R_{i+2} on one line? */
static int G(three_collinear)(const num R[], int i)
{
    num a[3], b[3];
    G(between)(R, i, i + 1, a);
    G(between)(R, i + 1, i + 2, b);
    return is_zero_q(G(gram)(3, a, b));
}

CLAIM(palindromes_of_degree_four)
{
    enum { n = 4 };
    static const int point[n + 1][2] = {{0, 0}, {1, 0}, {0, 1}, {1, 0}, {0, 0}};
    num R[3 * (n + 1)], S[3 * (n + 1)], w[n + 1], v[n + 1], back[n + 1];
    for (int i = 0; i <= n; i++) {
        R[3 * i] = from_int(point[i][0]);
        R[3 * i + 1] = from_int(point[i][1]);
        R[3 * i + 2] = from_int(0);
        w[i] = from_int(fault(T, i == 1, i == 1 || i == 3) ? 2 : 1);
        v[n - i] = w[i];
    }
    show_points(T, "R", n + 1, 3, R);
    G(run_backwards)(n, 3, R, w, S, back);
    agree(T, G(one_map)(n, 3, R, v, S, back));
    agree(T, !G(three_collinear)(R, 0) && !G(three_collinear)(R, n - 2));
    agree(T, G(invariants_differ)(T, n, w, v));
}

/* (a_i, a_j, a_k) of the edges of points of space. */
static num G(edges_det)(const num R[], int i, int j, int k)
{
    num a[3], b[3], c[3];
    G(between)(R, i - 1, i, a);
    G(between)(R, j - 1, j, b);
    G(between)(R, k - 1, k, c);
    return G(det3)(a, b, c);
}

/*
:::{claim} space_palindromes_beyond_degree_five
:title: From degree 6 on the point set does not determine the invariants
:zh: 六次起点集不能确定不变量
:kind: decision
:given: $n=6,\dots,9$; $e_0=0$ and the unit points $e_1,e_2,e_3$ of space; the points
  $e_0,e_1,e_2,e_3,\dots,e_3,e_2,e_1,e_0$ with $n-5$ of them in $e_3$; $\omega=(1,2,1,\dots,1)$ and
  $\omega^*=(1,\dots,1,2,1)$
:then: $R^*(t)=R(1-t)$, so that the point sets are one; the first and the last three edges are not coplanar; but
  $I_1=4$, $I_{n-1}=1$ and $I_1^*=1$, $I_{n-1}^*=4$
:method: The polynomials of the two curves are compared; the rest is exact arithmetic.  The same points and weights
  do it for every larger $n$.
:degrees: 6..9
:control: the weights $\omega_1$ and $\omega_{n-1}$ both $2$
:::
*/
CLAIM(space_palindromes_beyond_degree_five)
{
    int n = T->degree;
    num R[3 * (MAX_DEGREE + 1)], S[3 * (MAX_DEGREE + 1)], w[MAX_DEGREE + 1], v[MAX_DEGREE + 1], back[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++) {
        int k = i < n - i ? i : n - i;
        for (int c = 0; c < 3; c++)
            R[3 * i + c] = from_int(c + 1 == (k < 3 ? k : 3));
        w[i] = from_int(fault(T, i == 1, i == 1 || i == n - 1) ? 2 : 1);
        v[n - i] = w[i];
    }
    show_points(T, "R", n + 1, 3, R);
    G(run_backwards)(n, 3, R, w, S, back);
    agree(T, G(one_map)(n, 3, R, v, S, back));
    agree(T, !is_zero_q(G(edges_det)(R, 1, 2, 3)) && !is_zero_q(G(edges_det)(R, n - 2, n - 1, n)));
    agree(T, G(invariants_differ)(T, n, w, v));
}

/*
:::{claim} equal_invariants_other_speed
:title: Equal invariants do not mean the same map of the parameter
:zh: 不变量相等时参数分布可以不同
:kind: counterexample
:given: $n=2$, the points $(-1,0),(0,1),(1,0)$, $\omega=(1,1,1)$ and $\omega^*=(1,2,4)$
:then: $I_1=I_1^*=1$, the hypotheses of the theorem hold, and $R(\frac12)\ne R^*(\frac12)$
:method: Computed exactly.
:control: $\omega^*=(1,1,1)$
:::
*/
CLAIM(equal_invariants_other_speed)
{
    enum { n = 2 };
    num R[] = {from_int(-1), from_int(0), from_int(0), from_int(1), from_int(1), from_int(0)}, w[n + 1], v[n + 1], P[2],
        Q[2];
    for (int i = 0; i <= n; i++) {
        w[i] = from_int(1);
        v[i] = from_int(fault(T, 1, 1L << i));
    }
    if (G(invariants_differ)(T, n, w, v))
        return;
    G(rational_point)(n, 2, R, w, from_ratio(1, 2), P);
    G(rational_point)(n, 2, R, v, from_ratio(1, 2), Q);
    about(T, "the first coordinates of R(1/2) and R*(1/2)");
    same(T, P[0], Q[0]);
}

/* The polygon of degree 3, 4 or 5 that the half turn (x,y,z) -> (-x,-y,z) maps to itself in reverse order, with the
 * weights w = (1,...,1,2,1) and v = (1,2,1,...,1), or both (1,2,1,...,1,2,1).  Is R*(t) the half turn of R(1-t), and
 * are the first and the last three edges not coplanar? */
static int G(half_turn_pair)(trial *T, int n, int both, num w[], num v[])
{
    static const int polygon[3][6][3] = {{{1, 0, 0}, {0, 1, 1}, {0, -1, 1}, {-1, 0, 0}},
                                         {{1, 0, 0}, {0, 1, 1}, {0, 0, 2}, {0, -1, 1}, {-1, 0, 0}},
                                         {{1, 0, 0}, {0, 1, 1}, {1, 1, 2}, {-1, -1, 2}, {0, -1, 1}, {-1, 0, 0}}};
    num R[18], S[18], back[6];
    for (int i = 0; i <= n; i++) {
        for (int c = 0; c < 3; c++)
            R[3 * i + c] = from_int(polygon[n - 3][i][c]);
        w[i] = from_int(i == n - 1 || (i == 1 && both) ? 2 : 1);
        v[n - i] = w[i];
    }
    show_points(T, "R", n + 1, 3, R);
    G(run_backwards)(n, 3, R, w, S, back);
    for (int i = 0; i <= n; i++)
        for (int c = 0; c < 2; c++)
            S[3 * i + c] = neg(S[3 * i + c]);
    return G(one_map)(n, 3, R, v, S, back) && !is_zero_q(G(edges_det)(R, 1, 2, 3)) &&
           !is_zero_q(G(edges_det)(R, n - 2, n - 1, n));
}

/*
:::{claim} congruent_cubics_with_other_invariants
:title: Two congruent cubics over one polygon with different invariants
:zh: 同一控制多边形上全等而不变量不同的三次曲线
:kind: counterexample
:given: the points $(1,0,0),(0,1,1),(0,-1,1),(-1,0,0)$, $\omega=(1,1,2,1)$ and $\omega^*=(1,2,1,1)$
:then: $R^*(t)=h(R(1-t))$ with the half turn $h(x,y,z)=(-x,-y,z)$, so that the curves are congruent; the edges are not
  coplanar; but $I=(\frac12,4)$ and $I^*=(4,\frac12)$
:method: That the second curve is the half turn of the first run backwards is decided by comparing polynomials,
  before the invariants are compared.
:control: the weights $\omega_1$ and $\omega_2$ both $2$
:::
*/
CLAIM(congruent_cubics_with_other_invariants)
{
    num w[4], v[4], I[2], J[2];
    if (!G(half_turn_pair)(T, 3, fault(T, 1, 0), w, v))
        return;
    (void)G(invariants_differ)(T, 3, w, v);
    G(rational_invariants)(3, w, I);
    G(rational_invariants)(3, v, J);
    about(T, "I_1 and I_1^*");
    same(T, I[0], J[0]);
}

/*
:::{claim} congruent_curves_beyond_cubics
:title: Congruent quartics and quintics over one polygon with different invariants
:zh: 四、五次的同类例子
:kind: decision
:given: $n=4$ with the points $(1,0,0),(0,1,1),(0,0,2),(0,-1,1),(-1,0,0)$; $n=5$ with
  $(1,0,0),(0,1,1),(1,1,2),(-1,-1,2),(0,-1,1),(-1,0,0)$; $\omega=(1,\dots,1,2,1)$ and $\omega^*=(1,2,1,\dots,1)$
:then: $R^*(t)=h(R(1-t))$ with the half turn $h(x,y,z)=(-x,-y,z)$; the first and the last three edges are not
  coplanar; but the invariants differ
:method: The polynomials of the two curves are compared; the rest is exact arithmetic.
:degrees: 4..5
:control: the weights $\omega_1$ and $\omega_{n-1}$ both $2$
:::
*/
CLAIM(congruent_curves_beyond_cubics)
{
    num w[6], v[6];
    agree(T, G(half_turn_pair)(T, T->degree, fault(T, 0, 1), w, v));
    agree(T, G(invariants_differ)(T, T->degree, w, v));
}
#endif

/*
## The printed proof

:::{statement} wang-ch3:thm-3.2.1-sufficiency
:title: One direction is property 3.2.10
:zh: 充分性即性质 3.2.10
:printed: That (3.2.12) gives the same shape is property 3.2.10
:holds-by: equal_invariants_give_same_curve
:needs: equal_invariants_reach_the_other_arc | positive weights
:::

:::{statement} wang-ch3:thm-3.2.1-proof-start
:title: Curvature and torsion agree at the start
:zh: 曲线始端的曲率与挠率相等
:printed: As the curves have the same shape, curvature and torsion agree all along, in particular at the start
:holds-by: backward_run_flattens_the_first_edges
:reading: backward_run_flattens_the_first_edges | same point set: holds, but that the start of one curve is the
  start of the other is to be shown, by steps (1) and (2) above
:reading: congruent_cubics_with_other_invariants | congruent curves: fails; the starts need not correspond
:reading: curvatures_alone_miss_the_middle_invariant | curvature or torsion, either of them: for $n=4,5$ both are
  needed

The source has "curvature or torsion"; what is used is curvature and torsion.
:::
*/

#if RATIONAL
/*
:::{claim} curvatures_alone_miss_the_middle_invariant
:title: The curvatures at both ends do not determine the middle invariant
:zh: 仅端点曲率不能确定中间的不变量
:kind: counterexample
:given: $n=4$, the points $(0,0,0),(1,0,0),(1,1,0),(1,1,1),(0,1,1)$, $\omega=(1,1,1,1,1)$ and $\omega^*=(1,1,1,2,4)$
:then: $\kappa(0)=\kappa^*(0)$ and $\kappa(1)=\kappa^*(1)$, but $I=(1,1,1)$ and $I^*=(1,\frac12,1)$
:method: The squared curvatures are computed from the derivatives of the curves, and are equal; then the invariants
  are compared.
:control: $\omega_3^*=\omega_4^*=1$
:::
*/
CLAIM(curvatures_alone_miss_the_middle_invariant)
{
    enum { n = 4 };
    static const int point[n + 1][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}};
    num R[3 * (n + 1)], w[n + 1], v[n + 1], I[n], J[n];
    for (int i = 0; i <= n; i++) {
        for (int c = 0; c < 3; c++)
            R[3 * i + c] = from_int(point[i][c]);
        w[i] = from_int(1);
        v[i] = from_int(fault(T, 1, i < 3 ? 1 : i == 3 ? 2 : 4));
    }
    show_points(T, "R", n + 1, 3, R);
    for (int end = 0; end < 2; end++)
        if (!equal_q(G(rational_curvature_squared)(n, 3, R, v, from_int(end)),
                     G(rational_curvature_squared)(n, 3, R, w, from_int(end))))
            return;
    (void)G(invariants_differ)(T, n, w, v);
    G(rational_invariants)(n, w, I);
    G(rational_invariants)(n, v, J);
    about(T, "I_2 and I_2^*");
    same(T, I[1], J[1]);
}

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
:corrected-by: end_torsion_contains_two_invariants end_curvature_contains_one_invariant
:figure: torsion_misprint

One index: the denominator is $\|a_1\times a_2\|^2$, by (3.2.6).  The two expressions are the differences of the curvatures
and of the torsions, without their left sides; as the difference of the torsions, which property 3.2.4 is said to give,
the second is wrong.  The proof does not suffer: when the curves have the same shape both are zero, with the wrong
denominator too, since $(a_1,a_2,a_3)\ne0$ gives $a_1\times a_3\ne0$.
:::

:::{claim} printed_torsion_denominator_is_wrong
:title: The torsion has the first two edges in its denominator, not the first and the third
:zh: 挠率之差的分母误印
:kind: counterexample
:given: $n=5$, $R_0=0$, $a_1=(1,0,0)$, $a_2=(0,1,0)$, $a_3=(0,0,2)$, $a_4=a_1$, $a_5=a_2$, $\omega=(1,1,1,1,1,1)$ and
  $\omega^*=(1,1,1,2,1,1)$
:then: the printed expression is not $\tau(0)-\tau^*(0)$
:method: The torsions are computed from the derivatives of the curves.
:control: $\|a_1\times a_2\|^2$ in the denominator
:::
*/
CLAIM(printed_torsion_denominator_is_wrong)
{
    enum { n = 5 };
    static const int edge[n][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {1, 0, 0}, {0, 1, 0}};
    num R[3 * (n + 1)], w[n + 1], v[n + 1], a[3][3];
    for (int i = 0; i <= n; i++) {
        for (int c = 0; c < 3; c++)
            R[3 * i + c] = i == 0 ? from_int(0) : add(R[3 * (i - 1) + c], from_int(edge[i - 1][c]));
        w[i] = from_int(1);
        v[i] = from_int(i == 3 ? 2 : 1);
    }
    for (int k = 0; k < 3; k++)
        G(between)(R, k, k + 1, a[k]);
    show_points(T, "R", n + 1, 3, R);
    show_points(T, "ω", n + 1, 1, w);
    show_points(T, "ω*", n + 1, 1, v);
    num change = sub(div(mul(w[0], w[3]), mul(w[1], w[2])), div(mul(v[0], v[3]), mul(v[1], v[2])));
    num area = G(gram)(3, a[0], fault(T, a[1], a[2]));
    num printed = mul(from_ratio(3, 5), mul(change, div(G(det3)(a[0], a[1], a[2]), area)));
    about(T, "τ(0) - τ*(0), left as it is, right as printed");
    same(T, sub(G(rational_torsion)(n, R, w, from_int(0)), G(rational_torsion)(n, R, v, from_int(0))), printed);
}
#endif

/*
:::{statement} wang-ch3:thm-3.2.1-proof-nonzero
:title: The geometric factors do not vanish, so the weights' factors do
:zh: 几何因子非零故权因子之差为零
:printed: As $R_0,R_1,R_2$ are not collinear and $a_1,a_2,a_3$ not coplanar, $a_1\times a_2\ne0$ and
  $(a_1,a_2,a_3)\ne0$; hence $I_1=I_1^*$ and
  $\omega_0\omega_3/(\omega_1\omega_2)=\omega_0^*\omega_3^{*}/(\omega_1^*\omega_2^*)$
:holds-by: end_curvature_contains_one_invariant end_torsion_contains_two_invariants

The quotient of the second equation is $1/(I_1I_2)$.
:::

:::{statement} wang-ch3:thm-3.2.1-proof-product
:title: The product of the two equations gives the second invariant
:zh: 两式相乘得第二个不变量
:printed: Multiplying $I_1=I_1^*$ and
  $(\omega_0\omega_3)/(\omega_1\omega_2)=(\omega_0^*\omega_3^*)/(\omega_1^*\omega_2^*)$ gives $I_2=I_2^*$
:holds-by: product_is_the_inverse_second_invariant

The product is $1/I_2$, which does as well.
:::

:::{claim} product_is_the_inverse_second_invariant
:title: The product of the two quotients is the reciprocal of the second invariant
:zh: 乘积即第二不变量的倒数
:given: weights $\omega_0,\dots,\omega_3$, none of them $0$
:then: $I_1\frac{\omega_0\omega_3}{\omega_1\omega_2}=\frac{\omega_1\omega_3}{\omega_2^2}=\frac1{I_2}$
:method: An identity of rational functions of the four weights; the degree of the curve does not matter.
:scope: every n from 3 on
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
    same(T, product, div(mul(w[1], w[3]), mul(w[2], w[2])));
    same(T, product, fault(T, div(from_int(1), I[1]), I[1]));
}

/*
:::{statement} wang-ch3:thm-3.2.1-proof-symmetry
:title: The other end gives the other two invariants
:zh: 由对称性得另两个不变量
:printed: By the symmetry of the curve also $I_4=I_4^*$, $I_3=I_3^*$
:holds-by: reversal_exchanges_invariants end_curvature_contains_one_invariant end_torsion_contains_two_invariants

Reversing points and weights exchanges the two ends, $I_i$ with $I_{n-i}$, and the hypotheses with each other.
:::

:::{statement} wang-ch3:thm-3.2.1-proof-other-degrees
:title: The proof for n = 5 contains those for n = 2, 3, 4
:zh: 仅就 n=5 证明必要性
:printed: Now the necessity is proved for $n=5$ only.
:holds-by: end_curvature_contains_one_invariant end_torsion_contains_two_invariants
  backward_run_flattens_the_first_edges

The theorem is stated for $n=2$ to 5, so that this proof has to contain the others, and it does.  $n=2$: $\kappa(0)$ gives $I_1$.  $n=3$: $\kappa(0),\kappa(1)$ give $I_1,I_2$.  $n=4$: these give $I_1,I_3$, and
$\tau(0)$ gives $I_2$.
:::
*/
#include "chapters/judge/claims_off.h"
