/*
# Closed curves, surfaces, and what a point costs (封闭曲线、曲面与计算量)

What is left of the paper are its applications, closed curves and a surface, and a remark on what a point costs.  Little of
it is new.  The surface is a curve of curves, so that it inherits most of what is true of the curve, and all that is false.
*/
#if RATIONAL
#include "exact/record/hull.h"
#include "exact/record/sign.h"

#include "chapters/judge/counting.h"

/* The kernels of Bézier curves once more in the number type that counts. */
#undef G
#define G(name) name##_c
#include "core/kernels/bezier.tmpl.h"
#undef G
#define G(name) name##_q
#endif

#include "chapters/shape-parameter/definition.h"
#include "chapters/shape-parameter/distance.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} deng-zhang-2022:sec-4-closed
:title: A closed curve when first and last point coincide
:zh: 起点与终点重合得封闭曲线
:printed: when the first and the last point coincide a closed curve is obtained, as with the Bézier curve of degree seven
:holds-by: end_points_and_end_derivatives
:figure: petals
:degree: 7
:::

:::{statement} deng-zhang-2022:fig-3
:title: The petals of closed curves
:zh: 图 3 花瓣图形
:printed: figure 3 shows the petals (花瓣图形) of the closed curves for $\beta=1,0,-1,-2,-3,-4,-5,-6,-7$
:degree: 7
:reading: that they look like petals: the polygon is not given, so that nothing is there to be decided
:reading: end_points_and_end_derivatives | that the curves are closed: for $P_0=P_7$ each of them begins and ends in this point, with the printed functions
  and with the corrected ones (`sec-2-properties`)
:confirmed-by: printed_points_move_evenly_with_beta points_move_evenly_with_beta
:figure: petals

For any polygon the points of one $t$ on the nine curves are on a straight line in equal distances, or are one point, with the printed functions and with the
corrected ones (`sec-2-properties`).
:::

## The surface (张量积曲面)

A point of the surface is found in two rounds: the curves of the rows at $v$ give eight points, and their curve at $u$ is
the point.  In the field this shows that the double sum (22) is what the kernel computes.

:::{statement} deng-zhang-2022:def-5.1
:title: The tensor product surface
:zh: 双八次 β-Bezier 曲面，式 (22)
:printed: $B_1(u,v)=\sum_{i=0}^7\sum_{j=0}^7P_{ij}B_{i,7}(u)B_{j,7}(v)$ for $8\times8$ control points $P_{ij}\in\mathbb R^d$, $d=2,3$, $u,v\in[0,1]$, $-7\le\beta\le1$,
  is called the β-Bézier surface of degree eight in both directions on $[0,1]\times[0,1]$
:definition: yes
:checked-by: printed_surface_is_a_curve_of_curves
:confirmed-by: surface_kernel_gives_the_double_sum
:figure: shape_surface

One $\beta$ serves both directions.  A coordinate of the
surface comes from that coordinate of the points alone, and so the same is true in every $\mathbb R^d$.
:::
*/

static num G(any_beta)(trial *T) { return unknown(T, "beta", 0); }

/*
:::{claim} printed_surface_is_a_curve_of_curves
:title: The surface with the printed functions, row by row
:zh: 按式 (1)、(22) 的曲面
:given: the 64 nets of one point 1 and all others 0, any $\beta$, $u$ and $v$
:then: the points at $v$ of the printed curves of the eight rows are eight points whose printed curve has at $u$ the point
  $\sum_i\sum_jP_{ij}\hat B_i(u)\hat B_j(v)$
:method: `shape_point_printed` twice against the printed formulas; $\beta$, $u$, $v$ are variables.  Both sides are linear in the points.
:degrees: 7..7
:control: $u$ and $v$ exchanged
:::
*/
CLAIM(printed_surface_is_a_curve_of_curves)
{
    num beta = G(any_beta)(T), u = parameter(T, "u"), v = parameter(T, "v");
    for (int i = 0; i <= 7; i++)
        for (int j = 0; j <= 7; j++) {
            num row[8], points[8], at;
            for (int r = 0; r <= 7; r++) {
                for (int c = 0; c <= 7; c++)
                    row[c] = from_int(r == i && c == j);
                G(shape_point_printed)(1, row, beta, fault(T, v, u), points + r);
            }
            G(shape_point_printed)(1, points, beta, fault(T, u, v), &at);
            same(T, at, mul(G(printed)(i, beta, u), G(printed)(j, beta, v)));
        }
}

/*
:::{claim} surface_kernel_gives_the_double_sum
:title: The kernel computes the surface
:zh: 核函数即双重和
:given: degrees $n$ and 2 in the two directions, any points, parameters $\beta$ and $\gamma$, any $u$ and $v$
:then: `shape_surface_point` gives $\sum_i\sum_jP_{ij}B_{i,n}(u)B_{j,2}(v)$
:method: The double sum of the formulas, everything a variable.
:degrees: 2..6 sampled 7
:defines: shape_surface_point
:control: $\beta$ and $\gamma$ exchanged
:::
*/
CLAIM(surface_kernel_gives_the_double_sum)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * 3], at, sum = from_int(0), beta = G(any_beta)(T), gamma = unknown(T, "gamma", 0);
    num u = parameter(T, "u"), v = parameter(T, "v");
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= 2; j++) {
            P[i * 3 + j] = unknown(T, "z", i * 3 + j);
            /* Σ Σ P_ij B_{i,n}(u) B_{j,2}(v) */
            sum = add(sum, mul(P[i * 3 + j], mul(G(corrected)(n, i, beta, u), G(corrected)(2, j, gamma, v))));
        }
    G(shape_surface_point)(n, 2, 1, P, fault(T, beta, gamma), fault(T, gamma, beta), u, v, &at);
    same(T, at, sum);
}

/*
:::{statement} deng-zhang-2022:sec-5-properties
:title: The surface has properties like those of the curve
:zh: 曲面具有与曲线类似的性质
:printed: it can be proved that the surface has geometric properties similar to those of the curve
:refuted-by: printed_surface_leaves_a_single_point surface_leaves_the_hull_at_minus_seven
:class: false
:corrected: with the printed functions as with the corrected ones (`sec-2-properties`) the corners are $P_{00},P_{07},P_{70},P_{77}$ and the border
  curves those of the first and last row and column; the derivative by $u$ is $(7+\beta)\sum_j(P_{1j}-P_{0j})B_{j,7}(v)$ at $u=0$ and
  $(7+\beta)\sum_j(P_{7j}-P_{6j})B_{j,7}(v)$ at $u=1$, and likewise that by $v$, in a corner $7+\beta$ times the edge of the net; with the corrected ones
  symmetry and affine maps for every $\beta$, the convex hull exactly for $-\frac{21}4\le\beta\le1$; with the printed ones these three only for $\beta=0$
:corrected-by: functions_vanish_to_their_orders_at_the_ends surface_derivatives_across_the_border corrected_functions_are_mirror_images
  printed_outer_functions_are_mirror_images surface_functions_sum_to_one nonnegative_exactly_in_the_range
:confirmed-by: surface_has_the_corner_points_and_boundary_curves reversed_net_reverses_the_surface
  net_of_straight_lines_gives_a_saddle
:reading: surface_of_convex_rows_and_columns_is_not_convex | preservation of convexity, a net being called convex when its rows
  and columns are: the surface may be convex to no side
:reading: larger_beta_takes_the_surface_away_from_its_net | approximation of the net (property 3.5), points of the surface being compared by their largest
  distance from the net
:reading: preservation of convexity for a net that is convex as a whole, and variation diminution: the text does not say
  what they are for a net, so that nothing is there to be decided
:meant: the word "similar", after the properties of section 3 | The properties that section 3 prints for the curve,
  said of the surface.
:figure: shape_surface

With the printed functions the 64 products add up to $(1-4\beta(1-u)^3u^4)(1-4\beta(1-v)^3v^4)$.  With the corrected ones the surface of the net
$P_{ij}=(i,j,ij)$, whose rows and columns are straight, is a saddle, $z=xy$, for every $\beta$ (`net_of_straight_lines_gives_a_saddle`).

A function of the surface is a product $B_i(u)B_j(v)$.  At $u=0$ all $B_i(u)$ but the first are 0, so that the border is the
curve of the first row; mirror images, the sum 1 (with it affine maps) and the sign pass from the factors to the products.  For $\beta$ outside the
range some $B_i(u)<0$, and this is the value of the surface of the net that is 1 in row $i$ and 0 elsewhere.  With the printed functions and $\beta\ne0$ the
surface of 64 equal points that are not the origin is no point, and the surface of a net that is 0 but for $P_{30}$ is not that of the reversed net
backwards.
:::

The statement names no property, so what section 3 prints for the curve is taken one by one.  What is at the ends of the curve is at the
border of the surface; symmetry passes to it with the corrected functions.  The two counterexamples are those of the curve, multiplied: 64 equal points ask
for the sum, a net with one row different from 0 for a sign.

:::{claim} reversed_net_reverses_the_surface
:title: The net reversed in both directions gives the surface backwards
:zh: 控制网反序,曲面反向
:given: degrees 3 and 2, any points, $\beta$, $\gamma$, $u$ and $v$; corrected functions
:then: the surface of the points $P_{3-i,2-j}$ at $(1-u,1-v)$ is that of the $P_{ij}$ at $(u,v)$; the same for one
  direction alone
:method: Both by the kernel, everything a variable.
:scope: degrees 3 and 2
:control: $v$ in the place of $1-v$
:::
*/
CLAIM(reversed_net_reverses_the_surface)
{
    num P[4 * 3], R[4 * 3], here, there, beta = G(any_beta)(T), gamma = unknown(T, "gamma", 0);
    num u = parameter(T, "u"), v = parameter(T, "v"), one = from_int(1);
    for (int m = 0; m < 4 * 3; m++)
        P[m] = unknown(T, "z", m);
    G(shape_surface_point)(3, 2, 1, P, beta, gamma, u, v, &here);
    for (int turned = 1; turned <= 3; turned++) {
        int in_u = turned & 1, in_v = turned >> 1;
        for (int i = 0; i <= 3; i++)
            for (int j = 0; j <= 2; j++)
                R[i * 3 + j] = P[(in_u ? 3 - i : i) * 3 + (in_v ? 2 - j : j)];
        num back = fault(T, in_v ? sub(one, v) : v, v);
        G(shape_surface_point)(3, 2, 1, R, beta, gamma, in_u ? sub(one, u) : u, back, &there);
        same(T, there, here);
    }
}

#if RATIONAL
/*
:::{claim} printed_surface_leaves_a_single_point
:title: The printed surface of 64 equal points is no point
:zh: 64 个顶点重合时按式 (1) 的曲面不是一点
:kind: counterexample
:data: β = 1; P_{ij} for all i and j = 1; number of points = 64; u = 1/2; v = 1/2
:result: surface at (u, v) = 961/1024
:given: the right end of the range of $\beta$, one number for all $P_{ij}$, which may be a coordinate, and the middle of
  the square; printed functions
:then: the surface has there another value than its points
:method: The double sum of the printed functions.
:control: the corrected functions
:::
*/
CLAIM(printed_surface_leaves_a_single_point)
{
    num beta = given(T, "β"), P = given(T, "P_{ij} for all i and j"), U[8], V[8], sum = from_int(0);
    int printed_ones = fault(T, 0, 1), points = given_whole(T, "number of points");
    G(functions_of)(printed_ones, 7, beta, given(T, "u"), U);
    G(functions_of)(printed_ones, 7, beta, given(T, "v"), V);
    for (int m = 0; m < points; m++)
        sum = add(sum, mul(P, mul(U[m / 8], V[m % 8])));
    found(T, "surface at (u, v)", sum);
    about(T, "the surface and the one value of its points");
    same(T, sum, P);
}

/*
:::{claim} surface_leaves_the_hull_at_minus_seven
:title: At beta = -7 the surface leaves the convex hull of its net
:zh: β=-7 时曲面越出凸包
:kind: counterexample
:data: β = -7; i = 2; P_{ij} for all j = 1; P of the other points = 0; u = 1/20; v = 1/2
:instead: β = -21/4
:result: surface at (u, v), corrected = -190659623/25600000000; surface at (u, v), printed = -7435725297/819200000000
:given: the left end of the printed range, and a net of numbers that are positive in one row and 0 in all others; a small
  $u$, and $v$ in the middle
:then: the value of the surface is negative, with the corrected and with the printed functions
:method: The double sum.
:control: the left end of the true range
:::
*/
CLAIM(surface_leaves_the_hull_at_minus_seven)
{
    static const char *const surface_of[] = {"surface at (u, v), corrected", "surface at (u, v), printed"};
    num beta = given(T, "β");
    int row = given_whole(T, "i"), inside = 0;
    num in_row = given(T, "P_{ij} for all j"), elsewhere = given(T, "P of the other points");
    num u = given(T, "u"), v = given(T, "v");
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        num U[8], V[8], sum = from_int(0);
        G(functions_of)(printed_ones, 7, beta, u, U);
        G(functions_of)(printed_ones, 7, beta, v, V);
        for (int i = 0; i <= 7; i++)
            for (int j = 0; j <= 7; j++)
                sum = add(sum, mul(i == row ? in_row : elsewhere, mul(U[i], V[j])));
        found(T, surface_of[printed_ones], sum);
        inside += sign_q(sum) >= 0;
    }
    about(T, "the surface is not negative, as its points are not");
    agree(T, inside > 0);
}

/*
:::{claim} larger_beta_takes_the_surface_away_from_its_net
:title: A larger beta takes a surface away from its net
:zh: β 增大而曲面远离控制网
:kind: counterexample
:data: P = (-1,-1) (2,0) (2,-2) (1,-2) (1,-2) (0,0) (2,2) (2,1); β = 0 1; r² = 23/50; u = 3/16; v = 0
:instead: β = 1 0
:result: surface at (u, v), corrected = (5535206357/4294967296,-559496945/536870912);
  surface at (u, v), printed = (5523817109/4294967296,-556649633/536870912)
:given: the net $P_{ij}=P_i$, whose columns are one polygon and whose rows are single points; two values of $\beta$, the square of a distance, a $u$ and a $v$; printed and
  corrected functions
:then: for the first $\beta$ every point of the surface is nearer to the polygon, which is the whole net, than $r$; for the second the point of $u$ and $v$ is farther
:method: The surface is $q(u)\sum_jB_j(v)$ with the curve $q$ of the polygon.  For the first $\beta$ the sum is 1, as its nine coefficients are, so that the surface
  is the curve, and nearer than $r$ as a curve is (`distance.h`); the farther point by the double sum, against all seven edges.
:control: the two values of $\beta$ exchanged
:::
*/
CLAIM(larger_beta_takes_the_surface_away_from_its_net)
{
    static const char *const surface_of[] = {"surface at (u, v), corrected", "surface at (u, v), printed"};
    num P[8 * dim], beta[2], r_squared = given(T, "r²"), one = from_int(1), ones[8], coefficients[9];
    int farther = 1;
    given_points(T, "P", 8, dim, P);
    given_points(T, "β", 2, 1, beta);
    num u = given(T, "u"), v = given(T, "v");
    for (int j = 0; j <= 7; j++)
        ones[j] = one;
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        num U[8], V[8], at[dim] = {from_int(0), from_int(0)};
        G(bezier_points_of)(printed_ones, 7, 1, ones, beta[0], coefficients);
        for (int k = 0; k <= 8; k++)
            farther = farther && equal_q(coefficients[k], one);
        struct G(path) q = G(path_in)(printed_ones, 7, P, beta[0]);
        farther = farther && G(nearer_than)(q, 7, P, r_squared, from_int(0), one, 9);
        G(functions_of)(printed_ones, 7, beta[1], u, U);
        G(functions_of)(printed_ones, 7, beta[1], v, V);
        for (int m = 0; m < 64; m++)
            for (int c = 0; c < dim; c++)
                at[c] = add(at[c], mul(P[m / 8 * dim + c], mul(U[m / 8], V[m % 8])));
        found_points(T, surface_of[printed_ones], 1, dim, at);
        farther = farther && compare_q(G(distance_squared)(7, P, at), r_squared) > 0;
    }
    about(T, "with one of the two families the surface of the larger beta is not farther");
    refute(T, farther);
}
#endif

/*
:::{claim} surface_has_the_corner_points_and_boundary_curves
:title: Corners and boundary curves of the surface
:zh: 曲面的角点与边界曲线
:given: degrees 3 and 2, any points, $\beta$, $\gamma$ and $v$; printed functions, degrees 7 and 7, any points, $\beta$
  and $v$
:then: for $u=0$ and $u=1$ the surface is the curve of the first and of the last row of points, corrected with the
  parameter $\gamma$; the ends of these are the corners
:method: The surface kernel, and `shape_point_printed` twice, against the formulas of the curves; everything a variable.
:scope: corrected functions of degrees 3 and 2, printed ones of degree 7
:over: z# w#: points; gamma
:control: the second row in the place of the last
:::
*/
CLAIM(surface_has_the_corner_points_and_boundary_curves)
{
    num P[4 * 3], at, beta = G(any_beta)(T), gamma = unknown(T, "gamma", 0), v = parameter(T, "v");
    for (int m = 0; m < 4 * 3; m++)
        P[m] = unknown(T, "z", m);
    for (int end = 0; end <= 1; end++) {
        int row = end == 0 ? 0 : fault(T, 3, 1);
        G(shape_surface_point)(3, 2, 1, P, beta, gamma, from_int(end), v, &at);
        same(T, at, G(corrected_curve)(2, 1, P + row * 3, 0, gamma, v));
        for (int corner = 0; corner <= 1; corner++) {
            G(shape_surface_point)(3, 2, 1, P, beta, gamma, from_int(end), from_int(corner), &at);
            same(T, at, P[row * 3 + 2 * corner]);
        }
    }
    num R[8 * 8], column[8], points[8];
    for (int m = 0; m < 8 * 8; m++)
        R[m] = unknown(T, "w", m);
    for (int end = 0; end <= 1; end++) {
        int row = end == 0 ? 0 : fault(T, 7, 1);
        for (int j = 0; j <= 7; j++) {
            for (int i = 0; i <= 7; i++)
                column[i] = R[i * 8 + j];
            G(shape_point_printed)(1, column, beta, from_int(end), points + j);
        }
        G(shape_point_printed)(1, points, beta, v, &at);
        same(T, at, G(printed_curve)(1, R + row * 8, 0, beta, v));
        for (int corner = 0; corner <= 1; corner++) {
            G(shape_point_printed)(1, points, beta, from_int(corner), &at);
            same(T, at, R[row * 8 + 7 * corner]);
        }
    }
}

/*
:::{claim} surface_derivatives_across_the_border
:title: The derivatives of the surface across two of its border curves
:zh: 曲面在边界处的跨界导矢
:given: degrees 7 and 7, any points, one coordinate of each, any $\beta$ and $v$; printed and corrected functions
:then: the derivative by $u$ is $(7+\beta)\sum_j(P_{1j}-P_{0j})B_j(v)$ at $u=0$, $(7+\beta)\sum_j(P_{7j}-P_{6j})B_j(v)$ at $u=1$
:method: For fixed $v$ the surface is the curve of the points $\sum_jP_{ij}B_j(v)$; its derivatives by the Bézier points of degree 8, the functions of the
  other side by the formulas; everything a variable.  The surface is the same in both directions.
:degrees: 7..7
:control: 7 in the place of $7+\beta$
:::
*/
CLAIM(surface_derivatives_across_the_border)
{
    num P[8 * 8], B[8], row[8], Q[9], D[2], beta = G(any_beta)(T), v = parameter(T, "v"), seven = from_int(7);
    for (int m = 0; m < 8 * 8; m++)
        P[m] = unknown(T, "z", m);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        G(functions_of)(printed_ones, 7, beta, v, B);
        for (int i = 0; i <= 7; i++) {
            row[i] = from_int(0);
            for (int j = 0; j <= 7; j++)
                row[i] = add(row[i], mul(P[i * 8 + j], B[j]));
        }
        G(bezier_points_of)(printed_ones, 7, 1, row, beta, Q);
        for (int end = 0; end <= 1; end++) {
            int i = end ? 6 : 0;
            num sum = from_int(0);
            for (int j = 0; j <= 7; j++) {
                num function = printed_ones ? G(printed)(j, beta, v) : G(corrected)(7, j, beta, v);
                sum = add(sum, mul(sub(P[(i + 1) * 8 + j], P[i * 8 + j]), function));
            }
            G(bezier_derivatives)(8, 1, Q, from_int(end), 1, D);
            same(T, D[1], mul(fault(T, add(seven, beta), seven), sum));
        }
    }
}

/*
:::{claim} surface_functions_sum_to_one
:title: The products of functions add up to one
:zh: 曲面基函数的权性
:given: degrees $7$ and $7$, any $\beta$, $u$ and $v$
:then: the corrected products add up to 1, the printed ones to $(1-4\beta(1-u)^3u^4)(1-4\beta(1-v)^3v^4)$
:method: The double sum of products of the kernels' functions, everything a variable.
:degrees: 7..7
:control: the second factor left out
:::
*/
CLAIM(surface_functions_sum_to_one)
{
    num beta = G(any_beta)(T), u = parameter(T, "u"), v = parameter(T, "v"), one = from_int(1), four = from_int(4);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        num U[8], V[8], in_u = from_int(0), in_v = from_int(0);
        G(functions_of)(printed_ones, 7, beta, u, U);
        G(functions_of)(printed_ones, 7, beta, v, V);
        for (int i = 0; i <= 7; i++) {
            in_u = add(in_u, U[i]);
            in_v = add(in_v, V[i]);
        }
        num first = sub(one, mul(four, mul(beta, G(product_of_powers)(3, 4, u))));
        num second = fault(T, sub(one, mul(four, mul(beta, G(product_of_powers)(3, 4, v)))), one);
        /* Σ Σ B̂_i(u) B̂_j(v) = (1 - 4β (1-u)³ u⁴)(1 - 4β (1-v)³ v⁴) */
        same(T, mul(in_u, in_v), printed_ones ? mul(first, second) : one);
    }
}

/*
Convexity is the one property that does not pass from curves to surfaces, and this has nothing to do with $\beta$.  Rows and
columns may all be straight, and the surface a saddle; or all convex and never straight, and the surface convex to no side.

:::{claim} net_of_straight_lines_gives_a_saddle
:title: A net of straight rows and columns whose surface is a saddle
:zh: 行列皆直的控制网生成鞍面
:given: $P_{ij}=(i,j,ij)$, degrees $n$ and $n$, any $\beta$, $u$ and $v$
:then: the surface satisfies $z=xy$, the equation of a hyperbolic paraboloid
:method: The three coordinates by the surface kernel, $\beta$, $u$, $v$ variables.
:degrees: 2..7 sampled 7
:control: the corner $P_{00}$ moved to $(1,0,0)$
:::
*/
CLAIM(net_of_straight_lines_gives_a_saddle)
{
    int n = T->degree;
    num P[8 * 8 * 3], at[3], beta = G(any_beta)(T), u = parameter(T, "u"), v = parameter(T, "v");
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j++) {
            num *point = P + (i * (n + 1) + j) * 3;
            point[0] = from_int(fault(T, i, i + j == 0 ? 1 : i));
            point[1] = from_int(j);
            point[2] = from_int(i * j);
        }
    G(shape_surface_point)(n, n, 3, P, beta, beta, u, v, at);
    same(T, at[2], mul(at[0], at[1]));
}

#if RATIONAL
/*
:::{claim} surface_of_convex_rows_and_columns_is_not_convex
:title: A surface of convex rows and columns may be above one diagonal and below the other
:zh: 行列皆凸的控制网,其曲面可以不凸
:kind: counterexample
:data: β = -7 -21/4 0 1; coefficients of i², ij, j² in the height = 1 4 1; u = 1/2; v = 1/2
:instead: coefficients of i², ij, j² in the height = 1 0 1
:result: points of the surfaces = (7/2,7/2,161/2) (7/2,7/2,637/8) (7/2,7/2,77) (7/2,7/2,153/2); middles of the two chords = (7/2,7/2,147) (7/2,7/2,49)
:given: the net of the points $P_{ij}=(i,j,z_{ij})$, whose height $z_{ij}$ is a quadratic form of $i$ and $j$ with
  positive coefficients of $i^2$ and $j^2$, so that each row and each column is on a parabola, in order, and convex; four values of $\beta$, corrected functions;
  the middle of the square
:then: for each $\beta$ the point of the surface is below the middle of the chord of the corners $P_{00},P_{77}$ and above that of $P_{07},P_{70}$; so the
  surface is convex to no side
:method: The points of the surfaces and the middles of the two chords, which are above one another, and their heights.  The control: a net on a paraboloid,
  which is convex.
:control: a sum of squares for the height
:::
*/
CLAIM(surface_of_convex_rows_and_columns_is_not_convex)
{
    num beta[4], form[3], P[8 * 8 * 3], at[4 * 3], half = from_ratio(1, 2), chord[2 * 3];
    int one_side = 0, above = 1;
    given_points(T, "β", 4, 1, beta);
    given_points(T, "coefficients of i², ij, j² in the height", 3, 1, form);
    for (int m = 0; m < 64; m++) {
        int i = m / 8, j = m % 8;
        P[m * 3] = from_int(i);
        P[m * 3 + 1] = from_int(j);
        P[m * 3 + 2] =
            add(mul(form[0], from_int(i * i)), add(mul(form[1], from_int(i * j)), mul(form[2], from_int(j * j))));
    }
    num u = given(T, "u"), v = given(T, "v");
    for (int c = 0; c < 3; c++) {
        chord[c] = mul(half, add(P[c], P[63 * 3 + c]));
        chord[3 + c] = mul(half, add(P[7 * 3 + c], P[56 * 3 + c]));
    }
    for (int k = 0; k < 4; k++) {
        num *point = at + 3 * k;
        G(shape_surface_point)(7, 7, 3, P, beta[k], beta[k], u, v, point);
        one_side += sign_q(sub(point[2], chord[2])) * sign_q(sub(point[2], chord[5])) > 0;
        for (int c = 0; c < 2; c++)
            above = above && equal_q(point[c], chord[c]) && equal_q(point[c], chord[3 + c]);
    }
    found_points(T, "points of the surfaces", 4, 3, at);
    found_points(T, "middles of the two chords", 2, 3, chord);
    about(T, "for some beta the point is not above or below the middles, or on one side of both");
    refute(T, above && one_side == 0);
}

/*
:::{statement} deng-zhang-2022:sec-5-adjustable
:title: The shape of the surface can be adjusted
:zh: 形状可调的曲面
:printed: the tensor product gives a surface whose shape can be adjusted
:holds-by: nets_that_do_not_move
:hypothesis: surface_that_does_not_move | the net is not constant on four blocks, with the corrected functions, and not $k_ik_jw$, with the printed
  ones: these nets $P_{ij}$, the blocks being $i,j\le3$, $i\le3<j$, $j\le3<i$ and $i,j\ge4$, $k=(0,0,0,0,5,1,1,1)$ and $w$ any vector, have one
  surface for all $\beta$
:meant: definition 5.1, in which both directions have one $\beta$ and the surface is a function of $u$ and $v$ | One $\beta$ is taken in both directions, and
  surfaces are different when they are different functions of $u$ and $v$.
:figure: shape_surface

Decided is that the surface is not the same for all $\beta$; single
values of $\beta$ are not compared, nor the surfaces as sets of points.  The corrected functions are those of `sec-2-properties`.
:::

:::{claim} nets_that_do_not_move
:title: The nets that have the same surface for all beta
:zh: 与 β 无关的控制网
:kind: decision
:data: k, corrected functions = 1 1 1 1 0 0 0 0; k', corrected functions = 0 0 0 0 1 1 1 1;
  k, printed functions = 0 0 0 0 5 1 1 1
:result: rank, corrected functions = 60; rank, printed functions = 63
:given: all nets of numbers $P_{ij}$, one $\beta$ for both directions, printed and corrected functions
:then: $\sum_i\sum_jP_{ij}B_i(u)B_j(v)$ is the same for all $\beta$ exactly for the combinations of $k_ik_j$, $k_ik'_j$,
  $k'_ik_j$, $k'_ik'_j$ with the corrected functions, that is for nets that are constant on each of four blocks, and for
  the multiples of $k_ik_j$ with the printed ones
:method: With $B_i=e_i+\beta d_i$ the coefficients of $\beta$ and $\beta^2$ are $\sum\sum P_{ij}(e_id_j+d_ie_j)$ and
  $\sum\sum P_{ij}d_id_j$.  The
  nets named are in the kernel of the matrix of their Bernstein coefficients, and its rank leaves room for no others.
:degrees: 7..7
:scope: every real β, all nets
:control: the coefficient of $\beta^2$ alone
:::
*/
/* To out are added the 81 Bernstein coefficients of f_i(u) h_j(v), of columns of two matrices. */
static void G(add_product)(const num F[], const num H[], int i, int j, num out[])
{
    for (int r = i; r <= i + 1; r++)
        for (int c = j; c <= j + 1; c++)
            out[r * 9 + c] = add(out[r * 9 + c], mul(F[r * 8 + i], H[c * 8 + j]));
}

CLAIM(nets_that_do_not_move)
{
    static const char *const rank_of[] = {"rank, corrected functions", "rank, printed functions"};
    num k[3][8];
    given_points(T, "k, corrected functions", 8, 1, k[0]);
    given_points(T, "k', corrected functions", 8, 1, k[1]);
    given_points(T, "k, printed functions", 8, 1, k[2]);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        static num M[162 * 64];
        num E[9 * 8], D[9 * 8], first[81], second[81], zero = from_int(0);
        G(matrix_in_beta)(printed_ones, E, D);
        for (int i = 0; i <= 7; i++)
            for (int j = 0; j <= 7; j++) {
                for (int r = 0; r < 81; r++)
                    first[r] = second[r] = zero;
                G(add_product)(E, D, i, j, first);
                G(add_product)(D, E, i, j, first);
                G(add_product)(D, D, i, j, second);
                for (int r = 0; r < 81; r++) {
                    M[r * 64 + i * 8 + j] = fault(T, first[r], zero);
                    M[(81 + r) * 64 + i * 8 + j] = second[r];
                }
            }
        for (int a = printed_ones ? 2 : 0; a <= (printed_ones ? 2 : 1); a++)
            for (int b = printed_ones ? 2 : 0; b <= (printed_ones ? 2 : 1); b++)
                for (int r = 0; r < 162; r++) {
                    num sum = from_int(0);
                    for (int m = 0; m < 64; m++)
                        if (!is_zero_q(M[r * 64 + m]))
                            sum = add(sum, mul(M[r * 64 + m], mul(k[a][m / 8], k[b][m % 8])));
                    vanishes(T, sum);
                }
        int rank = G(rank)(162, 64, M);
        agree(T, rank == (printed_ones ? 64 - 1 : 64 - 4));
        found_whole(T, rank_of[printed_ones], rank);
    }
}

/*
:::{claim} surface_that_does_not_move
:title: Nets with the same surface for two values of beta
:zh: 两个 β 值给出同一曲面的控制网
:kind: counterexample
:data: β = 0 1; f, corrected functions = 0 0 0 0 1 1 1 1; f, printed functions = 0 0 0 0 5 1 1 1
:instead: f, corrected functions = 0 0 0 0 0 1 1 1; f, printed functions = 0 0 0 0 1 1 1 1
:result: coefficients, corrected = 0 0 0 0 1/2 1 1 1 1; coefficients, printed = 0 0 0 0 5/2 7/2 1 1 1
:given: two values of $\beta$; with the corrected functions $P_{ij}=(f_i,f_j,f_if_j)$, with the printed ones $P_{ij}=f_if_j$
:then: the surfaces are the same for both
:method: Row $k$ of the matrix gives coefficient $k$ of $\sum f_iB_i$; the surface is $(x,y,z)$ with $x=\sum f_iB_i(u)$,
  $y=\sum f_jB_j(v)$, $z=xy$, since the functions have the sum 1.  The printed ones need no sum.  That the coefficients of
  $\sum f_iB_i$ differ for one of the two is asked.
:control: $f_4$ changed
:::
*/
CLAIM(surface_that_does_not_move)
{
    static const char *const f_of[] = {"f, corrected functions", "f, printed functions"};
    static const char *const coefficients_of[] = {"coefficients, corrected", "coefficients, printed"};
    num beta[2], f[2][8], before[9], after[9];
    int differ[2] = {0, 0};
    given_points(T, "β", 2, 1, beta);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++)
        given_points(T, f_of[printed_ones], 8, 1, f[printed_ones]);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        G(bezier_points_of)(printed_ones, 7, 1, f[printed_ones], beta[0], before);
        G(bezier_points_of)(printed_ones, 7, 1, f[printed_ones], beta[1], after);
        for (int k = 0; k <= 8; k++)
            differ[printed_ones] += !equal_q(before[k], after[k]);
        found_points(T, coefficients_of[printed_ones], 9, 1, after);
    }
    about(T, "some of the coefficients differ");
    agree(T, fault(T, differ[0] > 0 && differ[1] > 0, differ[0] > 0 || differ[1] > 0));
}
#endif

/*
## What a point costs (计算量)

Whether a curve of degree eight "takes more computation" depends on what is compared.  The kernels are run once more in a
number type that counts its operations.

:::{statement} deng-zhang-2022:sec-6-horner
:title: The curve can be computed by Horner's rule
:zh: 海纳算法
:printed: the curve takes more computation than the Bézier curve of degree seven, and can be computed by Horner's rule
:holds-by: horner_rule_computes_the_curve degree_eight_takes_more_operations
:hypothesis: horner_for_nine_points_beats_de_casteljau_for_eight | both curves are computed by the same algorithm, de Casteljau's
  or Horner's rule: from their nine and their eight Bézier points
:figure: operations_for_a_point
:degree: 7

What it takes to find the nine points is not counted.
:::

:::{claim} horner_rule_computes_the_curve
:title: Horner's rule on the nine Bézier points gives the curve
:zh: Horner 法则求曲线上的点
:given: points $P_0,\dots,P_n$ of the plane, any $\beta$ and $t$; for $n=7$ the printed functions as well as the corrected ones
:then: Horner's rule with the $n+2$ Bézier points of the curve, which the matrix of the functions gives, is $\sum P_iB_{i,n}(t)$
:method: Kernels against the formula, everything a variable.
:degrees: 2..7 sampled 14
:control: $t$ and $1-t$ exchanged
:::
*/
CLAIM(horner_rule_computes_the_curve)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], Q[(MAX_DEGREE + 1) * dim], at[dim], beta = G(any_beta)(T), t = parameter(T, "t");
    G(free_points)(T, n, dim, P);
    for (int printed_ones = 0; printed_ones <= (n == 7); printed_ones++) {
        G(bezier_points_of)(printed_ones, n, dim, P, beta, Q);
        G(bezier_horner)(n + 1, dim, Q, fault(T, t, sub(from_int(1), t)), at);
        about(T, printed_ones ? "the printed functions" : "the corrected functions");
        for (int c = 0; c < dim; c++)
            same(T, at[c],
                 printed_ones ? G(printed_curve)(dim, P, c, beta, t) : G(corrected_curve)(n, dim, P, c, beta, t));
    }
}

#if RATIONAL
enum method { HORNER, DE_CASTELJAU };

/* What a point of n+1 Bézier points of `coordinates` coordinates costs, in the type that counts, and in rationals for others. */
static struct operations cost_of_point(trial *T, enum method method, int n, int coordinates)
{
    num_c b[(MAX_DEGREE + 1) * MAX_DIM], P[MAX_DIM], some_number = {0};
    num_q x[(MAX_DEGREE + 1) * MAX_DIM], at[MAX_DIM], t = parameter_q(T, "t");
    for (int m = 0; m < (n + 1) * coordinates; m++) {
        b[m] = some_number;
        x[m] = unknown_q(T, "x", m);
    }
    (method == HORNER ? bezier_horner_q : bezier_casteljau_q)(n, coordinates, x, t, at);
    counted = (struct operations){0};
    (method == HORNER ? bezier_horner_c : bezier_casteljau_c)(n, coordinates, b, some_number, P);
    note_cost(coordinates, at, counted);
    return counted;
}
static int products(struct operations cost) { return cost.multiplications + cost.shifts; }

/*
:::{claim} degree_eight_takes_more_operations
:title: By the same algorithm a point of a curve of degree eight takes more operations than one of degree seven
:zh: 用同一算法, 八次曲线上点的运算次数多于七次
:kind: decision
:data: lower degree = 7; higher degree = 8
:given: two degrees $n$, one to three coordinates $d$; Horner's rule and de Casteljau's algorithm
:then: with $n$ for the degree, Horner's rule takes $2(d+1)n$ products and $dn+1$ sums, de Casteljau's algorithm $dn(n+1)$ products and
  $n+\frac{dn(n+1)}2$ sums; all are more for the higher degree
:method: The kernels are run in the number type that counts; products with powers of two are counted with the others.
:scope: one to three coordinates
:control: the lower degree in both places
:::
*/
CLAIM(degree_eight_takes_more_operations)
{
    int degree[2];
    degree[0] = given_whole(T, "lower degree");
    degree[1] = given_whole(T, "higher degree");
    for (int d = 1; d <= 3; d++) {
        for (int n = degree[0]; n <= degree[1]; n++) {
            struct operations horner = cost_of_point(T, HORNER, n, d), triangle = cost_of_point(T, DE_CASTELJAU, n, d);
            agree(T, products(horner) == 2 * (d + 1) * n && horner.additions == d * n + 1);
            agree(T, products(triangle) == d * n * (n + 1) && 2 * (triangle.additions - n) == d * n * (n + 1));
        }
        for (enum method method = HORNER; method <= DE_CASTELJAU; method++) {
            struct operations higher = cost_of_point(T, method, degree[fault(T, 1, 0)], d);
            struct operations lower = cost_of_point(T, method, degree[0], d);
            agree(T, products(higher) > products(lower) && higher.additions > lower.additions);
        }
    }
}

/*
:::{claim} horner_for_nine_points_beats_de_casteljau_for_eight
:title: Horner's rule for degree eight takes fewer operations than de Casteljau's algorithm for degree seven
:zh: 不同算法之间八次反而更省
:kind: counterexample
:data: degree by Horner's rule = 8; degree by de Casteljau's algorithm = 7
:result: products = 48 112; sums = 17 63
:given: the plane; Horner's rule in the higher degree, de Casteljau's algorithm in the lower one
:then: the first takes fewer products and fewer sums than the second
:method: The kernels are run in the number type that counts.
:control: `bezier_casteljau` in both degrees
:::
*/
CLAIM(horner_for_nine_points_beats_de_casteljau_for_eight)
{
    int high = given_whole(T, "degree by Horner's rule"), low = given_whole(T, "degree by de Casteljau's algorithm");
    struct operations eight = cost_of_point(T, fault(T, DE_CASTELJAU, HORNER), high, dim);
    struct operations seven = cost_of_point(T, DE_CASTELJAU, low, dim);
    found_points(T, "products", 2, 1, (num[]){from_int(products(eight)), from_int(products(seven))});
    found_points(T, "sums", 2, 1, (num[]){from_int(eight.additions), from_int(seven.additions)});
    about(T, "whether degree 8 takes more products and more sums");
    agree(T, products(eight) > products(seven) && eight.additions > seven.additions);
}
#endif

#include "chapters/judge/claims_off.h"
