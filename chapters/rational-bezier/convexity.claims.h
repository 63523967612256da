/*
# Convexity (保凸性)

The source says that a plane rational Bézier curve preserves convexity and points to the proof of theorem 1.4.2, with
(3.3.1) for the subdivision.  Chapter 1 is not at hand, and what it calls a convex polygon with it.  Two meanings are in
use, and they are not the same for polygons that turn by more than a half turn:

* the polygon *closed by its chord* $R_nR_0$ is convex;
* the polygon turns always to the same side.

With the first meaning the property is true, for every degree and all positive weights.  With the second it is false: a
hook of four points that always turns left can have a curve with two inflections.

The proof is one formula.  Let $D_{ijk}$ be twice the signed area of the triangle $R_iR_jR_k$ and $P=(\omega x,\omega y,\omega)$
the homogeneous curve.  Then for all $t_1,t_2,t_3$ (Cauchy and Binet)

$$\det\bigl(P(t_1),P(t_2),P(t_3)\bigr)=\sum_{i<j<k}\det\begin{pmatrix}B_i(t_1)&B_j(t_1)&B_k(t_1)\\B_i(t_2)&B_j(t_2)&B_k(t_2)\\
B_i(t_3)&B_j(t_3)&B_k(t_3)\end{pmatrix}\omega_i\omega_j\omega_k D_{ijk},$$

and the determinants of Bernstein functions are positive for $t_1<t_2<t_3$.  The vertices of a convex polygon, run through
counterclockwise, have all $D_{ijk}\ge0$; so any three points of the curve turn left as well, unless everything is on one line.
When $t_1,t_2,t_3$ move together the formula becomes one for the curvature.
*/
#if RATIONAL
#include "exact/record/hull.h"
#include "exact/record/sign.h"
#include "exact/record/sturm.h"
#endif

#include "chapters/judge/elementary.h"
#include "chapters/rational-bezier/free-curve.h"

#include "chapters/judge/claims_on.h"

/*
The formula has two kinds of factors, and each has a claim of its own: the $D_{ijk}$ belong to the polygon and have
one sign if it is convex; the determinants of Bernstein functions belong to the degree and are positive whatever the
curve is.  The weights come in as products of three, so that positive ones cannot disturb a sign.

:::{statement} wang-ch3:prop-3.2.8
:title: A convex polygon has a convex curve
:zh: 保凸性
:printed: A plane rational Bézier curve preserves convexity.
:holds-by: determinant_of_three_sums_goes_by_triples means_of_powers_go_one_way three_powers_have_a_positive_determinant
  positive_terms_make_a_convex_mean
:confirmed-by: curve_turns_like_its_triangles wronskian_of_three_bernstein_functions curvature_is_a_sum_over_triangles
  designed_convex_polygons_have_convex_curves convex_polygons_have_triangles_of_one_sign curve_may_be_convex_alone
:needs: mixed_weights_lose_convexity | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive
:hypothesis: curve_of_a_polygon_that_turns_back_has_inflections | the polygon, closed by its chord, runs through the
  boundary of a convex region once.  By the letter of definition 4.2.1 of the same book, the only one at hand, its
  points need only be part of the boundary.
:argued: | Let the polygon run counterclockwise; otherwise all is mirrored.  Three of its vertices, taken in order, turn left or are on one line, $D_{ijk}\ge0$, and, the
  region having inner points, not all $D_{ijk}$ are $0$; so, as $\omega(t)>0$, three points of the curve turn left
  whenever their parameters are in order; so the curve, closed by its chord, runs through the boundary of its hull once.
:reading: turns_of_one_sign_are_not_enough | If the polygon always turns to the same side, so does its curve.
:meant: definition 4.2.1 of the same book, the only one at hand | The points of a convex polygon are the boundary of a convex set or part of it; one
  that only turns to one side is not meant.  Of the polygons that are meant the hypothesis leaves out those that come to a
  piece of the boundary twice, and those on a line.
:figure: convex_polygon_convex_curve

The property goes one way only: the curve may be convex and the polygon not (`curve_may_be_convex_alone`).  Where all vertices are on one line the curve is a segment of it.
:::

For the curvature the determinant is that of three Bernstein functions and their first two derivatives.  Divided by
the functions themselves it is a determinant of Vandermonde's kind in $i$, $j$, $k$, which is why the degree can stay
a variable.

:::{claim} wronskian_of_three_bernstein_functions
:title: The Wronskian of three Bernstein functions is positive
:zh: 三个 Bernstein 基函数的 Wronski 行列式为正
:given: $0\le i<j<k\le n$, $0<t<1$
:then: $\det\begin{pmatrix}B_i&B_j&B_k\\B_i'&B_j'&B_k'\\B_i''&B_j''&B_k''\end{pmatrix}
  =\frac{(j-i)(k-i)(k-j)}{t^3(1-t)^3}B_iB_jB_k>0$
:method: $\lambda_m=B_m'/B_m=\frac mt-\frac{n-m}{1-t}$ and $B_m''/B_m=\lambda_m'+\lambda_m^2$; the determinant divided by
  $B_iB_jB_k$ is computed in the field with $i$, $j-i$, $k-j$, $n-k$ and $t$ variables; for the sign $t=\frac s{1+s}$.
:degrees: all
:scope: 0 < t < 1
:over: i p q r s: -
:control: $t^3(1-t)^3$ taken as $t^2(1-t)^2$
:::
*/
CLAIM(wronskian_of_three_bernstein_functions)
{
    num one = from_int(1), t = inside(T, "s"), rest = sub(one, t), row[3][3];
    num index[3], n;
    index[0] = whole(T, "i", 0, 5);
    index[1] = add(index[0], whole(T, "p", 1, 5));
    index[2] = add(index[1], whole(T, "q", 1, 5));
    n = add(index[2], whole(T, "r", 0, 5));
    for (int c = 0; c < 3; c++) { /* lambda, and its derivative */
        num m = index[c], left = div(m, t), right = div(sub(n, m), rest), lambda = sub(left, right);
        num slope = neg(add(div(left, t), div(right, rest)));
        row[c][0] = one;
        row[c][1] = lambda;
        row[c][2] = add(slope, mul(lambda, lambda));
    }
    num det = G(det3)(row[0], row[1], row[2]), both = mul(t, rest);
    num product = mul(mul(sub(index[1], index[0]), sub(index[2], index[0])), sub(index[2], index[1]));
    num wanted = div(product, fault(T, mul(both, mul(both, both)), mul(both, both)));
    /* det/(B_i B_j B_k) = (j-i)(k-i)(k-j)/(t³ (1-t)³) */
    same(T, det, wanted);
    G(must_be_positive)(T, wanted);
}

/* The determinant of three homogeneous points of the plane. */
static num G(triple)(const num P[], const num Q[], const num R[]) { return G(det3)(P, Q, R); }

/* D_ijk of three affine points: twice the signed area. */
static num G(triangle)(const num P[], const num Q[], const num R[])
{
    num a[2] = {sub(Q[0], P[0]), sub(Q[1], P[1])}, b[2] = {sub(R[0], P[0]), sub(R[1], P[1])};
    return G(cross2)(a, b);
}

/* The determinant of the columns i, j, k of a matrix of three rows of n+1 numbers. */
static num G(minor_of_columns)(int n, const num M[], int i, int j, int k)
{
    num row[3][3];
    for (int l = 0; l < 3; l++) {
        row[l][0] = M[l * (n + 1) + i];
        row[l][1] = M[l * (n + 1) + j];
        row[l][2] = M[l * (n + 1) + k];
    }
    return G(det3)(row[0], row[1], row[2]);
}

/* The sum over i < j < k of the minors of M, three rows of n+1 numbers, times w_i w_j w_k D_ijk. */
static num G(sum_over_triangles)(int n, const num M[], const num w[], const num R[], int first)
{
    num sum = from_int(0);
    for (int k = 2 + first; k <= n; k++)
        for (int j = 1; j < k; j++)
            for (int i = 0; i < j; i++) {
                num D = G(triangle)(R + 2 * i, R + 2 * j, R + 2 * k);
                num weight = mul(mul(w[i], w[j]), w[k]);
                sum = add(sum, mul(G(minor_of_columns)(n, M, i, j, k), mul(weight, D)));
            }
    return sum;
}

/*
With the $D_{ijk}$ and the weights as factors the Wronskians add up to the curvature, but for a positive factor.  So a
polygon whose triangles all turn left has, with positive weights, a curve that always turns left.

:::{claim} curvature_is_a_sum_over_triangles
:title: The sign of the curvature is that of a sum over the triangles of the polygon
:zh: 曲率符号由控制三角形有向面积之和决定
:where: $\omega(t)\ne0$
:given: a curve of the plane with weights $\omega_i$ and points $(x_i,y_i)$; $\Delta_{ijk}$ the determinant of
  $B_i,B_j,B_k$ and their first two derivatives
:let: $D_{ijk}=\det\bigl((x_i,y_i,1),(x_j,y_j,1),(x_k,y_k,1)\bigr)$ for the points $(x_i,y_i)$
:then: $\omega^3(x'y''-y'x'')=\sum_{i<j<k}\Delta_{ijk}\,\omega_i\omega_j\omega_k D_{ijk}$
:method: The sum is $\det(P,P',P'')$, by expansion; in the field with all weights, coordinates and $t$ variables, with derivatives
  of the Bernstein functions on one side and of the homogeneous curve on the other.  That $\omega^3(x'y''-y'x'')$ is
  $\det(P,P',P'')$ is proved with the nine values of $P,P',P''$ as variables, hence for any curve.
:degrees: 2..5 sampled 8
:over: v#: -
:control: the triangle $R_0R_1R_2$ left out
:::
*/
CLAIM(curvature_is_a_sum_over_triangles)
{
    enum { SIZE = 9 };
    int n = T->degree;
    num w[SIZE], R[2 * SIZE], H[3 * SIZE], P[3 * 3], B[3 * SIZE], t = parameter(T, "t");
    G(free_curve)(T, n, 2, R, w);
    G(rational_homogenize)(n, 2, R, w, H);
    G(bezier_derivatives)(n, 3, H, t, 2, P);
    G(bernstein_derivatives)(n, t, 2, B);
    about(T, "det(P, P', P'') is the sum over the triangles");
    /* det(P, P', P'') = Σ Δ_ijk ω_i ω_j ω_k D_ijk */
    same(T, G(triple)(P, P + 3, P + 6), G(sum_over_triangles)(n, B, w, R, fault(T, 0, 1)));

    about(T, "it is ω³ (x'y'' - y'x'')");
    num V[9], d1[2], d2[2]; /* X, Y, W, and the first and second derivatives */
    for (int c = 0; c < 9; c++)
        V[c] = c == 2 ? positive(T, "v", c) : unknown(T, "v", c);
    for (int c = 0; c < 2; c++) {
        num x = div(V[c], V[2]);
        d1[c] = div(sub(V[3 + c], mul(V[5], x)), V[2]);
        d2[c] = div(sub(sub(V[6 + c], mul(V[8], x)), mul(from_int(2), mul(V[5], d1[c]))), V[2]);
    }
    same(T, mul(mul(V[2], mul(V[2], V[2])), G(cross2)(d1, d2)), G(triple)(V, V + 3, V + 6));
}

/*
Curvature of one sign is a local matter: a spiral has it, too, and does not bound a convex region.  The formula for
three separate parameters says more.

:::{claim} curve_turns_like_its_triangles
:title: Three points of the curve turn as the triangles of the polygon do
:zh: 曲线上三点的转向由控制三角形决定
:given: $0<t_1<t_2<t_3<1$, weights $\omega_i$
:let: $D_{ijk}=\det\bigl((x_i,y_i,1),(x_j,y_j,1),(x_k,y_k,1)\bigr)$ for the points $(x_i,y_i)$; $P(t)=\sum_iB_i(t)\omega_i(x_i,y_i,1)$
:then: $\det(P(t_1),P(t_2),P(t_3))=\sum_{i<j<k}M_{ijk}\,\omega_i\omega_j\omega_k D_{ijk}$ with the $3\times3$ minors $M_{ijk}$ of
  $(B_m(t_l))$, and every $M_{ijk}>0$
:method: The equation, that of Cauchy and Binet, holds for any numbers in the place of the $B_m(t_l)$: in the field they, the
  weights and the points are variables.  The minors by their coefficients, with $t_l=\frac{s_l}{1+s_l}$, $s_1=p_0$, $s_2=s_1+p_1$, $s_3=s_2+p_2$, row $l$
  multiplied by $(1+s_l)^n$.
:degrees: 2..6
:scope: any three parameters inside $(0,1)$, in order
:over: b# p#: -
:control: $t_1$ and $t_2$ exchanged in the minors
:::
*/
CLAIM(curve_turns_like_its_triangles)
{
    enum { SIZE = 7 };
    int n = T->degree;
    num w[SIZE], R[2 * SIZE], H[3 * SIZE], M[3 * SIZE], P[3 * 3], s = from_int(0), one = from_int(1);
    G(free_curve)(T, n, 2, R, w);
    G(rational_homogenize)(n, 2, R, w, H);
    about(T, "Cauchy and Binet");
    /* det(P(t_1), P(t_2), P(t_3)) = Σ M_ijk ω_i ω_j ω_k D_ijk */
    for (int l = 0; l < 3 * (n + 1); l++)
        M[l] = unknown(T, "b", l);
    for (int l = 0; l < 3; l++)
        for (int c = 0; c < 3; c++) {
            P[3 * l + c] = from_int(0);
            for (int m = 0; m <= n; m++)
                P[3 * l + c] = add(P[3 * l + c], mul(M[l * (n + 1) + m], H[3 * m + c]));
        }
    same(T, G(triple)(P, P + 3, P + 6), G(sum_over_triangles)(n, M, w, R, 0));

    about(T, "signs of the minors");
    for (int l = 0; l < 3; l++) {
        s = add(s, positive(T, "p", l));
        num *row = M + fault(T, l, l < 2 ? 1 - l : l) * (n + 1);
        G(bernstein_basis)(n, div(s, add(one, s)), row);
        for (int m = 0; m <= n; m++)
            row[m] = mul(row[m], G(power)(add(one, s), n));
    }
    for (int k = 2; k <= n; k++)
        for (int j = 1; j < k; j++)
            for (int i = 0; i < j; i++) {
                num minor = G(minor_of_columns)(n, M, i, j, k);
                nonnegative(T, minor);
#if FIELD || RATIONAL
                agree(T, !G(is_zero)(minor));
#endif
            }
}

#if RATIONAL
static void points_from(int count, const long point[], num_q R[])
{
    for (int i = 0; i < 2 * count; i++)
        R[i] = from_int_q(point[i]);
}

/*
On the side of the polygon it has to be said which polygons have all $D_{ijk}\ge0$.  Those that are convex when closed
do.  To turn left at every inner vertex is not enough for it: that is a condition on the triangles $R_{i-1}R_iR_{i+1}$
only.

:::{claim} convex_polygons_have_triangles_of_one_sign
:title: The triangles of designed convex polygons turn to one side
:zh: 凸多边形的所有三角形同向
:kind: decision
:given: all polygons of $n+1$ points of the grid $\{0,1,2\}^2$ for $n=2,3$; for $n=4,5$ all that run once round the eight
  points on the border of the grid, stopping or starting anywhere
:let: $D_{ijk}=\det\bigl((x_i,y_i,1),(x_j,y_j,1),(x_k,y_k,1)\bigr)$ for the points $(x_i,y_i)$
:then: if the polygon closed by its chord is convex and counterclockwise, then $D_{ijk}\ge0$ for all $i<j<k$, and not all
  are $0$
:method: Convexity is decided by `exact/decide/hull.h`, from the turns of the edges; the areas are computed.
:degrees: 2..5
:scope: the stated polygons
:control: polygons that need only turn left at each inner vertex
:::
*/
/* 2 (signed area of the triangle), in integers. */
static long area(const long P[], const long Q[], const long R[])
{
    return (Q[0] - P[0]) * (R[1] - P[1]) - (Q[1] - P[1]) * (R[0] - P[0]);
}

/* One polygon: if it is convex and counterclockwise, all its triangles are, and one has an area. */
static void check_triangles(trial *T, int n, const long point[])
{
    num_q R[2 * 6];
    int orientation, least = 0, most = 0, left_turns = 1;
    region_mark mark = region_open();
    points_from(n + 1, point, R);
    int convex = polygon_is_convex(n, R, 1, &orientation) && orientation == 1;
    region_drop(mark);
    for (int k = 2; k <= n; k++)
        for (int j = 1; j < k; j++)
            for (int i = 0; i < j; i++) {
                long D = area(point + 2 * i, point + 2 * j, point + 2 * k);
                least |= D < 0;
                most |= D > 0;
                left_turns &= D >= 0 || j != i + 1 || k != j + 1;
            }
    if (fault(T, convex, left_turns && most))
        agree(T, !least && most);
}

/* Polygons that go on by step[1], ..., step[n] >= 0, at most 8 in all, among the border points. */
static void run_round(trial *T, int n, int at, int left, int index, long point[])
{
    static const long border[8][2] = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    point[2 * index] = border[at % 8][0];
    point[2 * index + 1] = border[at % 8][1];
    if (index == n)
        check_triangles(T, n, point);
    else
        for (int step = 0; step <= left; step++)
            run_round(T, n, at + step, left - step, index + 1, point);
}

CLAIM(convex_polygons_have_triangles_of_one_sign)
{
    int n = T->degree, codes = 1;
    long point[2 * 6];
    if (n >= 4) {
        for (int start = 0; start < 8; start++)
            run_round(T, n, start, 8, 0, point);
        return;
    }
    for (int i = 0; i <= n; i++)
        codes *= 9;
    for (int code = 0; code < codes; code++) {
        for (int i = 0, rest = code; i <= n; i++, rest /= 9) {
            point[2 * i] = rest % 9 % 3;
            point[2 * i + 1] = rest % 9 / 3;
        }
        check_triangles(T, n, point);
    }
}

/* det(P, P', P''), whose sign is that of the curvature where the weight is positive. */
static poly turning(int n, const num_q R[], const num_q w[])
{
    poly P[3][3];
    num_q b[MAX_DEGREE + 1];
    for (int c = 0; c < 3; c++) {
        for (int i = 0; i <= n; i++)
            b[i] = c < 2 ? mul_q(w[i], R[2 * i + c]) : w[i];
        P[0][c] = poly_from_bernstein(n, b);
        P[1][c] = poly_derivative(P[0][c]);
        P[2][c] = poly_derivative(P[1][c]);
    }
    poly sum = poly_constant(from_int_q(0));
    for (int c = 0; c < 3; c++) {
        int i = (c + 1) % 3, j = (c + 2) % 3;
        poly minor = poly_sub(poly_mul(P[1][i], P[2][j]), poly_mul(P[1][j], P[2][i]));
        sum = poly_add(sum, poly_mul(P[0][c], minor));
    }
    return sum;
}

/* Polygons that are convex and counterclockwise when closed. */
static const struct {
    int n;
    long point[2 * 5];
} convex_polygon[] = {{2, {0, 0, 3, 0, 1, 2}},
                      {3, {0, 0, 1, 0, 1, 1, 0, 1}},
                      {3, {0, 0, 1, 0, 2, 0, 1, 2}},
                      {3, {0, 0, 2, 0, 2, 0, 1, 2}},
                      {3, {0, 0, 3, 0, 3, 3, 0, 1}},
                      {4, {0, 0, 4, 0, 5, 3, 2, 5, 0, 1}},
                      {4, {0, 0, 1, 0, 2, 0, 2, 2, 0, 2}},
                      {4, {0, 0, 0, 0, 3, 0, 3, 3, 0, 3}}};
enum { CONVEX_POLYGONS = sizeof convex_polygon / sizeof *convex_polygon };

/* The weights number `code`, 0 <= code < 3^(n+1), each 1/1000, 1 or 1000. */
static int weight_codes(int n) { return n < 0 ? 1 : 3 * weight_codes(n - 1); }
static void extreme_weights(int code, int n, num_q w[])
{
    for (int i = 0; i <= n; i++, code /= 3)
        w[i] = code % 3 == 0 ? from_ratio_q(1, 1000) : from_int_q(code % 3 == 1 ? 1 : 1000);
}

/*
The property is also tried directly, with weights that differ by a factor of a million, which press the curve into one
corner after the other.

:::{claim} designed_convex_polygons_have_convex_curves
:title: Curves of designed convex polygons, under extreme weights, have curvature of one sign
:zh: 极端权因子下的保凸性
:kind: decision
:given: polygons that are convex when closed, among them a square, a polygon with collinear and one with repeated vertices, one
  that turns by more than a half turn; all weights from $\frac1{1000},1,1000$
:let: $P=(\omega x,\omega y,\omega)$, the curve in homogeneous coordinates
:then: $\det(P,P',P'')>0$ for $0<t<1$
:method: The sign of the polynomial is decided by counting its roots, by Descartes' rule and by Sturm's theorem.
:degrees: 2..4
:scope: the stated polygons and weights
:harmless: convex when closed | the polygons are the stated ones
:control: the last vertex moved across the first edge
:::
*/
CLAIM(designed_convex_polygons_have_convex_curves)
{
    int n = T->degree;
    num R[2 * 5], w[5], one = from_int(1);
    for (int example = 0; example < CONVEX_POLYGONS; example++)
        for (int code = 0; code < weight_codes(n) && convex_polygon[example].n == n; code++) {
            region_mark mark = region_open();
            points_from(n + 1, convex_polygon[example].point, R);
            extreme_weights(code, n, w);
            R[2 * n + 1] = fault(T, R[2 * n + 1], sub(neg(one), R[2 * n + 1]));
            agree(T, fault(T, polygon_is_convex(n, R, 1, NULL), 1));
            poly p = turning(n, R, w);
            agree(T, sign_on(p, from_int(0), from_int(1), OPEN) == SIGN_POSITIVE);
            agree(T, poly_is_zero(p) || sturm_count(p, from_int(0), one) == is_zero_q(poly_value(p, one)));
            region_drop(mark);
        }
}

/*
And here is what happens under the other meaning of the word.  A hook turns by more than a half turn, and some
$D_{ijk}$ whose vertices are not all neighbours is negative.

:::{claim} turns_of_one_sign_are_not_enough
:title: A polygon that always turns left, and a curve with two inflections
:zh: 处处左转的多边形, 曲线却有两个拐点
:kind: counterexample
:data: R = (0,0) (12,0) (11,5) (11,2); ω = 1 1 1 1; t = 2/3 3/4 10/11
:instead: R = (0,0) (12,0) (11,5) (1,5)
:result: x'y'' - y'x'' = "1782*t^2 - 2808*t + 1080"; x'y'' - y'x'' at t = 0 -189/8 0; inflections in (0,1) = 2
:given: the cubic curve with points $R$ and equal weights $\omega$, whose polygon turns left at both inner vertices and does not meet itself;
  three parameters $t_1<t_2<t_3$
:then: $x'y''-y'x''$ changes its sign at $t_1$ and $t_3$ and nowhere else in $(0,1)$, and is negative at $t_2$
:method: The polynomial is computed and evaluated; its roots are counted.
:control: the last point moved to the left, so that the polygon is convex when closed
:::
*/
CLAIM(turns_of_one_sign_are_not_enough)
{
    enum { n = 3 };
    num R[2 * (n + 1)], w[n + 1], t[3], value[3];
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    given_points(T, "t", 3, 1, t);
    poly p = turning(n, R, w);
    for (int k = 0; k < 3; k++)
        value[k] = poly_value(p, t[k]);
    int turns_left = turn_2d(R, R + 2, R + 4) > 0 && turn_2d(R + 2, R + 4, R + 6) > 0;
    int simple = sign_q(R[5]) > 0 && sign_q(R[7]) > 0; /* the last edge is above the first */
    found_text(T, "x'y'' - y'x''", poly_to_string(p, "t"));
    found_points(T, "x'y'' - y'x'' at t", 3, 1, value);
    found_whole(T, "inflections in (0,1)", count_roots(p, from_int(0), from_int(1), OPEN).crossings);
    about(T, "a polygon that turns left and does not meet itself has a curve that turns left");
    refute(T, turns_left && simple && sign_on(p, from_int(0), from_int(1), OPEN) != SIGN_POSITIVE);
}

/*
By the letter of definition 4.2.1 of the book a curve is convex if it is part of the boundary of a convex set.  A polygon that runs along
one side of a triangle, back, and along another, is part of the boundary.

:::{claim} curve_of_a_polygon_that_turns_back_has_inflections
:title: A polygon on the boundary of a triangle that turns back, and its cubic with an inflection
:zh: 往返的多边形与有拐点的三次曲线
:kind: counterexample
:data: R = (1,0) (2,0) (0,0) (0,1); ω = 1 1 1 1; t = 1/3
:instead: R = (1,0) (2,0) (2,1) (0,1)
:result: det(P,P',P'') = "-54*t^2 + 18*t"; det(P,P',P'') at t = 0; inflections in (0,1) = 1
:given: the cubic curve with points $R$ and equal weights $\omega$; all points of the polygon are on two sides of a triangle; a parameter $t$
:let: $P=(\omega x,\omega y,\omega)$, the curve in homogeneous coordinates
:then: $\det(P,P',P'')$ changes its sign at $t$
:method: The polynomial is computed, its sign decided by counting roots.  A convex curve has curvature of one sign.
:control: the third point moved, so that the polygon bounds a convex region with its chord
:::
*/
CLAIM(curve_of_a_polygon_that_turns_back_has_inflections)
{
    enum { n = 3 };
    num R[2 * (n + 1)], w[n + 1];
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    poly p = turning(n, R, w);
    found_text(T, "det(P,P',P'')", poly_to_string(p, "t"));
    found(T, "det(P,P',P'') at t", poly_value(p, given(T, "t")));
    found_whole(T, "inflections in (0,1)", count_roots(p, from_int(0), from_int(1), OPEN).crossings);
    about(T, "the curve of a polygon on the boundary of a triangle turns to one side");
    refute(T, sign_on(p, from_int(0), from_int(1), OPEN) == SIGN_MIXED);
}

/*
A negative weight makes products $\omega_i\omega_j\omega_k$ negative, and the sum over the triangles may have either
sign although all $D_{ijk}$ are positive.

:::{claim} mixed_weights_lose_convexity
:title: With weights of both signs a square can have a curve with inflections
:zh: 权因子变号时正方形对应的曲线有拐点
:kind: counterexample
:data: R = (0,0) (1,0) (1,1) (0,1); ω = 4 -1 4 4
:instead: ω = 4 1 4 4
:result: det(P,P',P'') = "-1440*t^3 + 864*t^2 + 576*t - 288"; inflections in (0,1) = 2
:given: the cubic curve with the corners $R$ of a square and weights $\omega$, of which one is negative, though $\omega(t)>0$ on $[0,1]$
:let: $P=(\omega x,\omega y,\omega)$, the curve in homogeneous coordinates
:then: $\det(P,P',P'')$ changes its sign twice in $(0,1)$
:method: The polynomial is computed, its sign decided by counting roots.
:control: the negative weight made positive
:::
*/
CLAIM(mixed_weights_lose_convexity)
{
    enum { n = 3 };
    num R[2 * (n + 1)], w[n + 1];
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    poly p = turning(n, R, w);
    int regular = sign_on(poly_from_bernstein(n, w), from_int(0), from_int(1), CLOSED) == SIGN_POSITIVE;
    found_text(T, "det(P,P',P'')", poly_to_string(p, "t"));
    found_whole(T, "inflections in (0,1)", count_roots(p, from_int(0), from_int(1), OPEN).crossings);
    about(T, "a curve without poles whose polygon is convex turns to one side");
    refute(T, regular && polygon_is_convex(n, R, 1, NULL) && sign_on(p, from_int(0), from_int(1), OPEN) == SIGN_MIXED);
}
#endif

/*
:::{statement} wang-ch3:prop-3.2.8-route
:title: The way of proof: subdivide, and cut corners
:zh: 证明途径: 离散割角
:printed: The property can be proved by (3.3.1), imitating the proof of theorem 1.4.2.
:holds-by: one_cut_of_corners_has_no_negative_minor determinant_of_three_sums_goes_by_triples cut_coefficients_are_convex
:confirmed-by: subdivided_polygon_turns_like_its_triangles subdivided_convex_polygons_are_convex
:needs: subdivision_fails_for_mixed_weights | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive
:hypothesis: curve_of_a_polygon_that_turns_back_has_inflections | the polygon, closed by its chord, runs through the
  boundary of a convex region once: as for the property itself, which fails without it and so has no proof
:argued: | The points of such a polygon have no triangle that turns to the other side.  Repeated at a fixed ratio, the subdivided polygons converge to
  the curve (`wang-ch3:rem-3.3.1-uniform`; with ratios that change they need not), and a limit of convex polygons is convex.
:meant: the words before (3.3.1), by which a curve is generated by subdivision | (3.3.1) with its right branch as corrected in `wang-ch3:3.3.1-right`.
:reading: printed_right_half_has_the_wrong_argument | The property can be proved by (3.3.1) with the right branch that is printed.
:figure: convex_halves

Theorem 1.4.2 is not at hand.  What is decided is that the two polygons of the halves, joined, have no triangle that turns to the
other side.
:::

:::{claim} subdivided_polygon_turns_like_its_triangles
:title: Subdivision keeps the turn of every triangle
:zh: 离散后的多边形保持三角形转向
:given: $0<\lambda<1$; the $2n+1$ points of the two halves, joined, as combinations of the $n+1$ points of the whole
:let: $D_{ijk}=\det\bigl((x_i,y_i,1),(x_j,y_j,1),(x_k,y_k,1)\bigr)$ for the points $(x_i,y_i)$
:then: every $3\times3$ minor of the matrix of these combinations is $\ge0$; so with positive weights, if all $D_{ijk}\ge0$ for the
  whole, then the same for the joined polygon
:method: The columns are the subdivisions of the unit vectors.  The minors are computed in the field with $\lambda=\frac s{1+s}$:
  quotients of polynomials whose coefficients are not negative.  By Cauchy and Binet the determinants of three of the new
  homogeneous points are sums of the old ones with these minors.
:degrees: 2..4
:scope: 0 < λ < 1
:over: s: -
:control: the left half run through backwards
:::
*/
CLAIM(subdivided_polygon_turns_like_its_triangles)
{
    enum { SIZE = 5, ROWS = 2 * SIZE - 1 };
    int n = T->degree;
    num row[ROWS][SIZE], unit[SIZE], left[SIZE], right[SIZE], s = positive(T, "s", 0);
    num sum = add(from_int(1), s), lambda = div(s, sum), scale = G(power)(sum, n);
    for (int j = 0; j <= n; j++) {
        for (int i = 0; i <= n; i++)
            unit[i] = from_int(i == j);
        G(bezier_split)(n, 1, unit, lambda, left, right);
        for (int a = 0; a <= n; a++) {
            row[n + a][j] = mul(scale, right[a]);
            row[a][j] = mul(scale, left[fault(T, a, n - a)]);
        }
    }
    for (int c = 2; c <= 2 * n; c++)
        for (int b = 1; b < c; b++)
            for (int a = 0; a < b; a++) {
                num M[3 * SIZE];
                for (int j = 0; j <= n; j++) {
                    M[j] = row[a][j];
                    M[n + 1 + j] = row[b][j];
                    M[2 * (n + 1) + j] = row[c][j];
                }
                for (int k = 2; k <= n; k++)
                    for (int j = 1; j < k; j++)
                        for (int i = 0; i < j; i++)
                            nonnegative(T, G(minor_of_columns)(n, M, i, j, k));
            }
}

#if RATIONAL
/*
Rows of this matrix are the new points as means of the old ones.  That all its minors of three rows are nonnegative is
again a statement on the degree alone; for polygons and weights it is tried once more.

:::{claim} subdivided_convex_polygons_are_convex
:title: The polygon of the two halves of a designed convex polygon is convex
:zh: 凸多边形离散后仍凸
:kind: decision
:data: λ = 1/3
:given: the polygons and weights of `designed_convex_polygons_have_convex_curves`, and a ratio $\lambda$
:then: the joined polygons of the two halves, closed by the chord, are convex
:method: Computed exactly with the rational subdivision; decided by `exact/decide/hull.h`.
:degrees: 2..4
:scope: the stated polygons and weights
:control: the left half run through backwards
:::
*/
CLAIM(subdivided_convex_polygons_are_convex)
{
    int n = T->degree;
    num R[2 * 5], w[5], left[2 * 5], right[2 * 5], wl[5], wr[5], joined[2 * 9], lambda = given(T, "λ");
    for (int example = 0; example < CONVEX_POLYGONS; example++)
        for (int code = 0; code < weight_codes(n) && convex_polygon[example].n == n; code++) {
            int orientation;
            region_mark mark = region_open();
            points_from(n + 1, convex_polygon[example].point, R);
            extreme_weights(code, n, w);
            G(rational_split)(n, 2, R, w, lambda, left, wl, right, wr);
            for (int a = 0; a <= n; a++)
                for (int c = 0; c < 2; c++) {
                    joined[2 * (n + a) + c] = right[2 * a + c];
                    joined[2 * a + c] = left[2 * fault(T, a, n - a) + c];
                }
            agree(T, polygon_is_convex(2 * n, joined, 1, &orientation) && orientation == 1);
            region_drop(mark);
        }
}

/*
The way of proof needs positive weights for the same reason as elevation did: a mean of weights of both signs may vanish.

:::{claim} subdivision_fails_for_mixed_weights
:title: With weights of both signs the halves need not exist
:zh: 权因子变号时离散顶点可不存在
:kind: counterexample
:data: ω = 2 -1 2; λ = 2/3
:instead: ω = 2 1 2
:result: weights of the left half = 2 0 2/3
:given: weights $\omega$ of degree $2$, of which the middle one is negative, though $\omega(t)>0$ on $[0,1]$; a ratio $\lambda$
:then: $\omega_1^1=(1-\lambda)\omega_0+\lambda\omega_1=0$: the middle point of the left half is at infinity
:method: The weights of the left half are computed and asked to be different from $0$.
:control: the middle weight made positive
:::
*/
CLAIM(subdivision_fails_for_mixed_weights)
{
    num w[3], left[3], right[3];
    given_points(T, "ω", 3, 1, w);
    G(bezier_split)(2, 1, w, given(T, "λ"), left, right);
    found_points(T, "weights of the left half", 3, 1, left);
    int regular = sign_on(poly_from_bernstein(2, w), from_int(0), from_int(1), CLOSED) == SIGN_POSITIVE;
    about(T, "a denominator without zeros has halves without points at infinity");
    refute(T, regular && is_zero_q(left[1]));
}

/*
The converse is not claimed by the source, and it is false, for a curve may smooth out a dent of its polygon.

:::{claim} curve_may_be_convex_alone
:title: A convex curve may have a polygon that is not convex
:zh: 曲线凸而控制多边形不凸
:kind: decision
:data: R = (0,0) (1,2) (2,1) (3,2) (4,0); ω = 1 1 1 1 1
:instead: R = (0,0) (1,2) (2,-1) (3,2) (4,0)
:result: x(t) = "4*t"; x'y'' - y'x'' = "-480*t^2 + 480*t - 144"
:given: the quartic curve with points $R$ and equal weights $\omega$
:let: $P=(\omega x,\omega y,\omega)$, the curve in homogeneous coordinates
:then: $\det(P,P',P'')<0$ for $0<t<1$ and $x(t)$ increases, so that the curve with its chord bounds a convex region; the polygon turns to
  both sides
:method: The sign of the polynomial is decided by counting roots; convexity by `exact/decide/hull.h`.
:scope: this curve
:control: the middle point moved down
:::
*/
CLAIM(curve_may_be_convex_alone)
{
    enum { n = 4 };
    num R[2 * (n + 1)], w[n + 1], x[n + 1];
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    for (int i = 0; i <= n; i++)
        x[i] = R[2 * i];
    poly p = turning(n, R, w);
    found_text(T, "x(t)", poly_to_string(poly_from_bernstein(n, x), "t"));
    found_text(T, "x'y'' - y'x''", poly_to_string(p, "t"));
    agree(T, sign_on(p, from_int(0), from_int(1), OPEN) == SIGN_NEGATIVE);
    agree(T, turn_2d(R, R + 2, R + 4) < 0 && turn_2d(R + 2, R + 4, R + 6) > 0);
    agree(T, !polygon_is_convex(n, R, 1, NULL));
}
#endif

#include "chapters/judge/claims_off.h"
