/*
# Convexity (保凸性)

That a curve is convex when its polygon is (保凸性) follows from what was said about crossings, if two things are kept apart.
Along a convex polygon the sign of a line function changes at most twice; this is the identity on four vertices at the end
of this section.  So where no line crosses the curve more often than the polygon, it crosses the curve at most twice.

The source speaks of common points, however, and these are more than crossings: an end of the curve may lie on the line.
With $P_0$ on the line one of the two changes of sign is used up, so that the count comes out right; but if the polygon is
closed, $P_0=P_7$, there are two parameters for this one point.  At $\beta=-7$ the conclusion is false in the plainest
sense, for a triangle and its base.
*/
#include "exact/record/crossings.h"
#include "exact/record/hull.h"

#include "chapters/shape-parameter/definition.h"
#include "chapters/shape-parameter/meeting.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} deng-zhang-2022:property-3.7
:title: Convex polygons have convex curves
:zh: 保凸性
:printed: by property 3.6, when the control polygon is convex, any line of the plane has not more than two points of intersection with the curve
  (definition 2.1: $-7\le\beta\le1$)
:refuted-by: printed_curve_of_a_convex_polygon_meets_a_line_four_times
  curve_of_a_triangle_meets_a_line_three_times
:class: false
:corrected: true for the corrected functions (`sec-2-properties`) and $-\frac{21}4\le\beta\le1$, if the polygon is convex when closed and not
  on a line, and common points are counted as points of the plane; false for every $\beta$ with $-7\le\beta<-\frac{21}4$; with the printed functions false for
  every $\beta$ of the printed range but 0
:corrected-by: totally_positive_exactly_in_the_range inversions_of_two_diagonals_meet_a_zero averages_between_neighbours_keep_sign_changes
    linear_factor_adds_a_change_of_sign four_vertices_of_a_convex_polygon_do_not_alternate
  triangle_has_three_points_on_its_base_below_the_range printed_curves_of_convex_polygons_meet_lines_four_times
  functions_are_independent_but_for_two_values line_function_of_the_curve combination_begins_and_ends_with_its_coefficients
:confirmed-by: roots_are_at_most_sign_changes third_function_has_a_zero_for_every_smaller_beta
:meant: the reason that follows, of a line and the polygon, which for $P_0=P_7$ is true of points of the plane only | Common points are counted as points of the
  plane.
:reading: closed_polygon_has_three_parameters_on_a_line | common points counted by their parameters, $P_0=P_7$: three are
  possible
:figure: convexity_lost

As in property 3.6 each Bernstein coefficient of $f=\sum k_iB_i$ is a multiple, not a negative one, of an average of two neighbours $k_{i-1},k_i$, where the
entries of the matrix are not negative: the coefficients have no more changes of sign than $k$, and $f$ no more roots in $(0,1)$.
A line has at most two changes of sign along a convex polygon; with $P_0$ on the line at most one, with $P_0\ne P_7$ both on
it none; so together with the ends there are never more than two common points.  With $P_0=P_7$ on the line one change is
possible, and $t=0$, $t=1$ are one point of the curve.  In the range all of $f$ is 0 only for $k=0$, the polygon then being on the line, and
at $\beta=-\frac{21}4$ for multiples of coefficients that change their sign three times.
:::

:::{statement} deng-zhang-2022:property-3.7-reason
:title: A line meets a convex polygon at most twice
:zh: 直线与凸控制多边形的交点
:printed: this is because a line and the (convex) control polygon have at most two points of intersection
:holds-by: vertex_off_a_line_puts_a_point_between_two four_vertices_of_a_convex_polygon_do_not_alternate sign_changes_are_polygon_crossings
  points_between_two_on_one_side_are_on_it
:meant: the number two, which for $P_0=P_7$ is true of points of the plane only | Points of intersection are counted as points of the plane.
:hypothesis: line_along_an_edge_has_three_points_of_a_convex_polygon | the line contains no edge; crossings are at most two in any case
:figure: line_along_an_edge
:degree: 7

Convex is a polygon that is run through once in the boundary of its convex hull: the edge $P_7P_0$ closes it convexly, or it lies on a line and never
turns back.  One that only turns always to the same side may be a spiral, which a line meets more often.
:::
*/

#if RATIONAL
/*
:::{claim} line_along_an_edge_has_three_points_of_a_convex_polygon
:title: A line along an edge has three points in common with a convex polygon
:zh: 沿边的直线与凸多边形有三个公共点
:kind: counterexample
:data: P = (0,0) (1,6) (2,10) (3,12) (4,12) (5,10) (6,6) (7,0); j = 3; λ = 0 1/2 1; Q = (7/2,12); u = (0,1)
:instead: u = (1,0)
:result: X = (3,12) (7/2,12) (4,12); u·(X-Q) = 0 0 0
:given: a convex polygon, three points $X=P_j+\lambda(P_{j+1}-P_j)$ of one of its edges, and the line through $Q$ with the normal vector $u$,
  orthogonal to this edge
:then: the three points are different and on the line
:method: Points and products, exactly; `hull.h` decides that the polygon is convex.
:control: the line through $Q$ across the edge
:::
*/
CLAIM(line_along_an_edge_has_three_points_of_a_convex_polygon)
{
    num P[8 * dim], lambda[3], Q[dim], u[dim], X[3 * dim], side[3];
    given_points(T, "P", 8, dim, P);
    int j = given_whole(T, "j"), on_it = 0;
    given_points(T, "λ", 3, 1, lambda);
    given_points(T, "Q", 1, dim, Q);
    given_points(T, "u", 1, dim, u);
    const num *A = P + j * dim, *B = A + dim;
    for (int m = 0; m < 3 * dim; m++)
        X[m] = add(A[m % dim], mul(lambda[m / dim], sub(B[m % dim], A[m % dim])));
    G(sides)(2, X, Q, u, side);
    found_points(T, "X", 3, dim, X);
    found_points(T, "u·(X-Q)", 3, 1, side);
    for (int m = 0; m < 3; m++)
        on_it += is_zero_q(side[m]);
    int in_order = compare_q(X[0], X[dim]) < 0 && compare_q(X[dim], X[2 * dim]) < 0;
    about(T, "the polygon is not convex, or at most two of the points are different and on the line");
    refute(T, polygon_is_convex(7, P, 0, NULL) && in_order && on_it > 2);
}

/*
:::{claim} closed_polygon_has_three_parameters_on_a_line
:title: The curve of a closed convex polygon may have three parameters on a line
:zh: 首末点重合的凸多边形:曲线在一直线上有三个参数
:kind: counterexample
:data: β = -21/4 0 1; P = (0,0) (2,-1) (4,0) (5,2) (4,4) (2,5) (0,3) (0,0); Q = (0,0); u = (1,-1)
:instead: Q = (0,1/2)
:result: parameters on the line = 3 3 3; those in (0,1) = 1 1 1
:given: three values of $\beta$, a convex heptagon with $P_7=P_0$, and the line through $Q=P_0$ with the normal vector
  $u$; corrected functions
:then: for each $\beta$ three parameters are on the line, one of them in $(0,1)$
:method: The common points are counted exactly by their parameters; `hull.h` decides that the polygon is convex.
:control: a line beside the corner
:::
*/
CLAIM(closed_polygon_has_three_parameters_on_a_line)
{
    num P[8 * dim], beta[3], closed[3], open[3];
    int most_two = 0;
    given_points(T, "β", 3, 1, beta);
    given_points(T, "P", 8, dim, P);
    struct cagd_line L = G(given_line)(T);
    for (int m = 0; m < 3; m++) {
        struct cagd_curve_meets_line curve = G(curve_meets)(0, P, beta[m], L);
        closed[m] = from_int(curve.common_closed);
        open[m] = from_int(curve.common_open);
        most_two += curve.common_closed <= 2;
    }
    found_points(T, "parameters on the line", 3, 1, closed);
    found_points(T, "those in (0,1)", 3, 1, open);
    about(T, "the polygon is not convex, or there are at most two common parameters");
    refute(T, polygon_is_convex(7, P, 1, NULL) && most_two == 0);
}

/*
The triangle of the next claim has its base on the line.  Its first and its last corner are repeated, so that only $P_2$ is
above the line and the height of the curve is $B_2(t)$, which at $\beta=-7$ has a root inside.

:::{claim} curve_of_a_triangle_meets_a_line_three_times
:title: At beta = -7 the curve of a triangle meets a line three times
:zh: β=-7 时凸多边形的曲线与直线有三个交点
:kind: counterexample
:data: β = -7; P = (0,0) (0,0) (1,1) (2,0) (2,0) (2,0) (2,0) (2,0); Q = (0,0); u = (0,1); t = 0 1/9 1
:instead: β = -21/4
:result: common points of the curve = 3; q(t) = (0,0) (634498/43046721,0) (2,0)
:given: the left end of the printed range, the three corners of a triangle with the first and the last repeated, the line
  through $Q$ with the normal vector $u$, on which one side is, and three parameters; corrected functions
:then: the polygon is convex, and the curve meets the line at the three parameters, in three points of the plane, and nowhere else
:method: The parameters of common points are counted exactly, and the points of the three computed; `hull.h` decides that the polygon is convex.
:control: the left end of the true range
:::
*/
CLAIM(curve_of_a_triangle_meets_a_line_three_times)
{
    struct G(meeting) m = G(given_meeting)(T, 0);
    num t[3], q[3 * dim];
    int on_the_line = 1;
    given_points(T, "t", 3, 1, t);
    found_whole(T, "common points of the curve", m.curve.common_closed);
    for (int k = 0; k < 3; k++) {
        G(curve_point)(0, 7, dim, m.P, m.beta, t[k], q + k * dim);
        on_the_line = on_the_line && is_zero_q(q[k * dim + 1]);
    }
    found_points(T, "q(t)", 3, dim, q);
    int in_order = compare_q(q[0], q[dim]) < 0 && compare_q(q[dim], q[2 * dim]) < 0;
    about(T, "the polygon is not convex, or there are at most two common points");
    refute(T, polygon_is_convex(7, m.P, 1, NULL) && on_the_line && in_order && m.curve.common_closed > 2);
}

#endif

#if FIELD || RATIONAL
/*
:::{claim} triangle_has_three_points_on_its_base_below_the_range
:title: For every beta of the printed range below the true one the curve of a triangle has three points on its base
:zh: -7≤β<-21/4 时三角形的曲线与底边有三个公共点
:given: $\beta=-\frac{21}4-b$, $0<b\le\frac74$; the points $(0,0),(0,0),(1,1),(2,0),\dots,(2,0)$, a convex polygon; corrected functions
:harmless: $0<b\le\frac74$ | it is $-7\le\beta<-\frac{21}4$
:harmless: convex polygon | it is the one whose points stand there
:then: for $t=\frac{4b}{9(21/4+b)}$ the curve has $y(t)=B_2(t)=0$ and $0<x(t)<2$: with its ends it has three points on the base
:method: The curve from its Bézier points, $b=\frac74\cdot\frac r{1+r}$ with $r>0$ a variable, and $b=\frac74$; $x$ and $2-x$ are quotients with coefficients of
  one sign.
:types: field rational
:degrees: 7..7
:scope: −7 ≤ β < −21/4
:over: r: -
:control: $b$ replaced by $2b$ in the parameter
:::
*/
CLAIM(triangle_has_three_points_on_its_base_below_the_range)
{
    static const int corners[8 * dim] = {0, 0, 0, 0, 1, 1, 2, 0, 2, 0, 2, 0, 2, 0, 2, 0};
    num P[8 * dim], at[dim], r = positive(T, "r", 0), one = from_int(1), most = from_ratio(7, 4);
    for (int m = 0; m < 8 * dim; m++)
        P[m] = from_int(corners[m]);
#if RATIONAL
    about(T, "the polygon is convex");
    agree(T, polygon_is_convex(7, P, 1, NULL));
#endif
    for (int end = 0; end <= 1; end++) {
        num b = end ? most : mul(most, div(r, add(one, r))), above = from_ratio(21, 4);
        num used = fault(T, b, add(b, b)), t = div(mul(from_int(4), used), mul(from_int(9), add(above, used)));
        G(shape_point)(7, dim, P, neg(add(above, b)), t, at);
        about(T, "y(t)");
        vanishes(T, at[1]);
        about(T, "x(t) and 2 - x(t)");
        G(must_be_positive)(T, at[0]);
        G(must_be_positive)(T, sub(from_int(2), at[0]));
    }
}
#endif

#if RATIONAL
/*
:::{claim} printed_curve_of_a_convex_polygon_meets_a_line_four_times
:title: The printed curve of a convex polygon meets a line four times
:zh: 按式 (1) 凸多边形的曲线与直线有四个交点
:kind: counterexample
:data: β = 1; P = (0,100) (1,101) (2,101) (3,101) (4,101) (5,101) (6,101) (7,100); Q = (0,401/4); u = (0,1)
:result: common points of the curve = 4; crossings of the curve = 4; crossings of the polygon = 2; x'(t) > 0 on [0,1] = "yes"
:given: the right end of the range of $\beta$, a flat convex polygon, and the line through $Q$ with the normal vector $u$,
  a little above its ends; printed functions
:then: the polygon is convex, and the curve crosses the line twice as often as the polygon, in four points of the plane
:method: The common points and the crossings are counted exactly, by their parameters; as $x$ grows with $t$, which the sign of $x'$ on $[0,1]$
  decides, they are different points.  `hull.h` decides that the polygon is convex.
:control: the corrected functions
:::
*/
CLAIM(printed_curve_of_a_convex_polygon_meets_a_line_four_times)
{
    int printed_ones = fault(T, 0, 1);
    struct G(meeting) m = G(given_meeting)(T, printed_ones);
    num Q[9 * dim], x[9];
    found_whole(T, "common points of the curve", m.curve.common_closed);
    found_whole(T, "crossings of the curve", m.curve.crossings);
    found_whole(T, "crossings of the polygon", m.polygon.crossings);
    G(bezier_points_of)(printed_ones, 7, dim, m.P, m.beta, Q);
    for (int k = 0; k <= 8; k++)
        x[k] = Q[k * dim];
    int grows = sign_on(poly_derivative(poly_from_bernstein(8, x)), from_int(0), from_int(1), CLOSED) == SIGN_POSITIVE;
    found_text(T, "x'(t) > 0 on [0,1]", grows ? "yes" : "no");
    about(T, "the polygon is not convex, or there are at most two common points");
    refute(T, polygon_is_convex(7, m.P, 0, NULL) && grows && m.curve.common_closed > 2);
}
#endif

#if FIELD || RATIONAL
/*
The polygon of this example may be moved nearer to the origin, or to the other side of it, when $\beta$ is another; so it is
with every $\beta$ but 0.

:::{claim} printed_curves_of_convex_polygons_meet_lines_four_times
:title: For every beta of the printed range but 0 the printed curve of a convex polygon has four points on a line
:zh: -7≤β≤1、β≠0 时按式 (1) 凸多边形的曲线与直线有四个公共点
:given: $-7\le\beta\le1$, $\beta\ne0$, $c=\frac{40}\beta$; the points $(0,c),(1,c+1),(2,c+1),\dots,(6,c+1),(7,c)$, a convex polygon, and the line $y=c+\frac1{1000}$;
  printed functions
:harmless: convex polygon | it is the one whose points stand there
:then: at $t=0,\frac1{100},\frac12,\frac{99}{100},1$ the curve is below the line, above, below, above and below it, and $x'>0$ in $(0,1)$: it crosses the line in at
  least four points of the plane
:method: The printed curve at the five parameters, $\beta=-7+\frac{8r}{1+r}$ with $r>0$ a variable, and $\beta=-7$ and $1$: the distances from the line, being linear in
  $\beta$, are quotients with coefficients of one sign.  $x'$ is linear in $\beta$ too, and its sign on $(0,1)$ is decided for $-7$ and $1$.
:types: field rational
:degrees: 7..7
:scope: −7 ≤ β ≤ 1, β ≠ 0
:over: r: -
:control: $c=\frac{30}\beta$
:::
*/
CLAIM(printed_curves_of_convex_polygons_meet_lines_four_times)
{
    static const int place[] = {0, 1, 50, 99, 100}; /* hundredths */
    num P[8 * dim], at[dim], r = positive(T, "r", 0), one = from_int(1), low = from_int(-7);
    num beta[3] = {low, add(low, mul(from_int(8), div(r, add(one, r)))), one};
    for (int b = 0; b < 3; b++) {
        num c = div(from_int(fault(T, 40, 30)), beta[b]), line = add(c, from_ratio(1, 1000));
        for (int i = 0; i <= 7; i++) {
            P[i * dim] = from_int(i);
            P[i * dim + 1] = i % 7 == 0 ? c : add(c, one);
        }
        for (int k = 0; k < 5; k++) {
            G(curve_point)(1, 7, dim, P, beta[b], from_ratio(place[k], 100), at);
            num above = sub(at[1], line);
            about(T, k % 2 == 1 ? "how far the curve is above the line" : "how far the curve is below the line");
            G(must_be_positive)(T, k % 2 == 1 ? above : neg(above));
        }
#if RATIONAL
        num Q[9 * dim], x[9];
        about(T, "the polygon is convex");
        agree(T, polygon_is_convex(7, P, 1, NULL));
        G(bezier_points_of)(1, 7, dim, P, beta[b], Q);
        for (int k = 0; k <= 8; k++)
            x[k] = Q[k * dim];
        about(T, "x grows");
        agree(T, sign_on(poly_derivative(poly_from_bernstein(8, x)), from_int(0), one, OPEN) == SIGN_POSITIVE);
#endif
    }
}
#endif

/*
:::{claim} four_vertices_of_a_convex_polygon_do_not_alternate
:title: Four vertices of a convex polygon are not on alternate sides of a line
:zh: 凸多边形的四个顶点不会交替位于直线两侧
:given: any $P_i,P_j,P_k,P_l$ of the plane, any line function $f(x,y)=ax+by+c$; $D_{ijk}$ the determinant of $P_j-P_i$ and
  $P_k-P_i$
:then: $D_{jkl}f(P_i)+D_{ijl}f(P_k)=D_{ikl}f(P_j)+D_{ijk}f(P_l)$
:method: An identity in the coordinates.  For $i<j<k<l$ in a polygon that is convex, counterclockwise, the four
  determinants are not negative.  With $f(P_i),f(P_k)\ge0\ge f(P_j),f(P_l)$ both sides are 0: every product is.  So when
  the signs are strict the four points are on one line, to and fro, and the polygon is not convex; hence there are no
  three changes of sign.  With $f(P_i)=0$ two changes among the other three, and with $f(P_i)=f(P_l)=0$, $P_i\ne P_l$,
  one, are excluded in the same way; with $P_i=P_l$ one is possible.
:over: a b c: line
:control: $D_{ikl}$ and $D_{ijl}$ exchanged
:::
*/
/* The determinant of Q - P and R - P. */
static num G(turn)(const num P[], const num Q[], const num R[])
{
    num q[dim] = {sub(Q[0], P[0]), sub(Q[1], P[1])}, r[dim] = {sub(R[0], P[0]), sub(R[1], P[1])};
    return G(cross2)(q, r);
}

CLAIM(four_vertices_of_a_convex_polygon_do_not_alternate)
{
    num P[4 * dim], f[4], a = unknown(T, "a", 0), b = unknown(T, "b", 0), c = unknown(T, "c", 0);
    G(free_points)(T, 3, dim, P);
    const num *i = P, *j = P + dim, *k = P + 2 * dim, *l = P + 3 * dim;
    for (int m = 0; m < 4; m++)
        f[m] = add(mul(a, P[m * dim]), add(mul(b, P[m * dim + 1]), c));
    num ikl = G(turn)(i, k, l), ijl = G(turn)(i, j, l);
    /* D_jkl f(P_i) + D_ijl f(P_k) = D_ikl f(P_j) + D_ijk f(P_l) */
    num left = add(mul(G(turn)(j, k, l), f[0]), mul(fault(T, ijl, ikl), f[2]));
    same(T, left, add(mul(fault(T, ikl, ijl), f[1]), mul(G(turn)(i, j, k), f[3])));
}

/*
That is said of crossings.  For points in common three of them are enough, and one vertex that is off the line.

:::{claim} vertex_off_a_line_puts_a_point_between_two
:title: The determinants of three points on a line and a vertex off it
:zh: 直线上三点与线外一顶点的行列式
:given: points $X$, $Y=X+\lambda d$, $Z=X+\mu d$ of a line of the plane, any points $V,W,A,B$; $D_{ijk}$ the determinant of $P_j-P_i$ and
  $P_k-P_i$; $c=D_{X,X+d,V}$
:then: $D_{XVY}=-\lambda c$, $D_{VYZ}=(\mu-\lambda)c$, $D_{XVZ}=-\mu c$, $D_{XYV}=\lambda c$, $D_{YVZ}=(\lambda-\mu)c$; and for $E=A+\lambda(B-A)$
  $D_{EVW}=(1-\lambda)D_{AVW}+\lambda D_{BVW}$
:method: Everything is a variable.  In a polygon that is convex, counterclockwise, no determinant of three vertices in their order is negative, and by the
  last equation none becomes negative when points of its edges are counted with the vertices.  Let $X,Y,Z$ be three different points that it has on a
  line, in its order.  If a vertex $V$ between $X$ and $Y$ is off the line, $c\ne0$, the first three determinants say that $\mu$ is between $0$ and
  $\lambda$, that is $Z$ between $X$ and $Y$; if one between $Y$ and $Z$ is, the third and the last two say that $0$ is between $\lambda$ and $\mu$, that is $X$
  between $Y$ and $Z$.  Not both can be; so from $X$ to $Y$ or from $Y$ to $Z$ the polygon is on the line, which contains an edge.
:over: a b l m: -; x# y#: points
:control: $\lambda$ and $\mu$ exchanged on the right
:::
*/
CLAIM(vertex_off_a_line_puts_a_point_between_two)
{
    num P[5 * dim], X[3 * dim], E[dim], end[dim], step[dim] = {unknown(T, "a", 0), unknown(T, "b", 0)};
    num lambda = unknown(T, "l", 0), mu = unknown(T, "m", 0), one = from_int(1);
    G(free_points)(T, 4, dim, P); /* X, V, W, A, B */
    const num *V = P + dim, *W = V + dim, *A = W + dim, *B = A + dim, *Y = X + dim, *Z = Y + dim;
    for (int c = 0; c < dim; c++) {
        X[c] = P[c];
        X[dim + c] = add(P[c], mul(lambda, step[c])), X[2 * dim + c] = add(P[c], mul(mu, step[c]));
        end[c] = add(P[c], step[c]), E[c] = add(A[c], mul(lambda, sub(B[c], A[c])));
    }
    num c = G(turn)(X, end, V), l = fault(T, lambda, mu), m = fault(T, mu, lambda);
    about(T, "a vertex between X and Y");
    same(T, G(turn)(X, V, Y), neg(mul(l, c)));
    same(T, G(turn)(V, Y, Z), mul(sub(m, l), c));
    same(T, G(turn)(X, V, Z), neg(mul(m, c)));
    about(T, "a vertex between Y and Z");
    same(T, G(turn)(X, Y, V), mul(l, c));
    same(T, G(turn)(Y, V, Z), mul(sub(l, m), c));
    about(T, "a point of an edge");
    same(T, G(turn)(E, V, W), add(mul(sub(one, lambda), G(turn)(A, V, W)), mul(lambda, G(turn)(B, V, W))));
}

#include "chapters/judge/claims_off.h"
