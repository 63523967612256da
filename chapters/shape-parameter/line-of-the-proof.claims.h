/*
# From roots to a line (由根的个数到直线)

The second step of the proof takes a line $L$ through a point $Q$ with the normal vector $u$ and puts $k_j=u\cdot(P_j-Q)$.
Then four numbers are compared in a chain: the common points of the curve and $L$; the roots of $\sum k_jB_j$ in $(0,1)$;
the changes of sign among the $k_j$; the intersections of the polygon with $L$.

Each link has its small print.  The first, (20), uses that the functions add up to 1, and forgets the ends $t=0$ and $t=1$.
The second, (21), is the rule of Descartes.  The third, (19), depends on how intersections are counted: an edge may lie on
$L$, and the polygon may pass twice through one point of $L$.  None of this is deep, but a theorem on "the number of
intersections" is true or false according to what is counted.
*/
#include "exact/record/crossings.h"
#include "exact/record/hull.h"

#include "chapters/shape-parameter/definition.h"
#include "chapters/shape-parameter/meeting.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} deng-zhang-2022:property-3.6-line
:title: The line through a point with a normal vector
:zh: 过点 Q、法向量为 u 的直线
:printed: let $L$ be the line (or plane) through the point $Q$ with the normal vector $u$
:definition: yes
:checked-by: points_of_a_line_by_its_normal
:needs: no_normal_no_line | the words themselves, since a normal vector is not 0 | $u\ne0$
:figure: line_along_an_edge
:::

:::{claim} points_of_a_line_by_its_normal
:title: For u not 0 the points with u.(X-Q) = 0 are a line, in space a plane
:zh: 由法向量确定的直线或平面
:given: any points $X$, $Q$ and vector $u$ of the plane, $w=X-Q$, $u^\perp=(-u_2,u_1)$; and any of space, and any vector $v$
:then: $(u\cdot u)w=(u\cdot w)u+(u^\perp\cdot w)u^\perp$ and $u\cdot u^\perp=0$ in the plane; $(u\cdot u)w=(u\cdot w)u+(u\times w)\times u$ and $u\cdot(v\times u)=0$ in space
:method: Everything is a variable.  So for $u\ne0$ the points with $u\cdot w=0$ are the points $Q+\lambda u^\perp$ in the plane, and
  all of these are such; in space they are the points $Q+v\times u$, with any vector $v$, and all of these are such.
:over: x# q#: points; u#: normal vectors; v#: -
:control: $u^\perp=(u_2,u_1)$, and in space $u\times(u\times w)$
:::
*/
CLAIM(points_of_a_line_by_its_normal)
{
    num w[dim], u[dim] = {unknown(T, "u", 0), unknown(T, "u", 1)};
    for (int c = 0; c < dim; c++)
        w[c] = sub(unknown(T, "x", c), unknown(T, "q", c));
    num across[dim] = {fault(T, neg(u[1]), u[1]), u[0]};
    for (int c = 0; c < dim; c++)
        /* (u·u) w = (u·w) u + (u⊥·w) u⊥ */
        same(T, mul(G(dot)(dim, u, u), w[c]),
             add(mul(G(dot)(dim, u, w), u[c]), mul(G(dot)(dim, across, w), across[c])));
    vanishes(T, G(dot)(dim, u, across));
    num to[3], normal[3], turned[3], beside[3], v[3], aside[3];
    for (int c = 0; c < 3; c++) {
        to[c] = sub(unknown(T, "x", c), unknown(T, "q", c));
        normal[c] = unknown(T, "u", c), v[c] = unknown(T, "v", c);
    }
    G(cross3)(v, normal, aside);
    vanishes(T, G(dot)(3, normal, aside));
    G(cross3)(normal, to, turned);
    G(cross3)(turned, normal, beside);
    for (int c = 0; c < 3; c++)
        /* (u·u) w = (u·w) u + (u×w)×u */
        same(T, mul(G(dot)(3, normal, normal), to[c]),
             add(mul(G(dot)(3, normal, to), normal[c]), fault(T, beside[c], neg(beside[c]))));
}

/*
Between two points on one side of $L$ there is no point of $L$.  That is what the proof needs of an edge.

:::{claim} points_between_two_on_one_side_are_on_it
:title: Between two points on one side of a line or plane there is no point of it
:zh: 同侧两点之间的线段不与直线(平面)相交
:given: points $A$, $B$ and $Q$ of space, any vector $u$, a point $X=A+\lambda(B-A)$, $0<\lambda<1$; and two numbers $a,b>0$
:harmless: a point $X=A+\lambda(B-A)$, $0<\lambda<1$ | the points of the edge but its ends are these
:harmless: two numbers $a,b>0$ | the values at two ends off the line are such, or their negatives are
:then: $u\cdot(X-Q)=(1-\lambda)\,u\cdot(A-Q)+\lambda\,u\cdot(B-Q)$, and $(1-\lambda)a+\lambda b>0$; with the values $a$ and $-b$ at the ends it is
  $(1-\lambda)a-\lambda b=(a+b)\bigl(\frac a{a+b}-\lambda\bigr)$, 0 for one $\lambda$ and positive before it and negative behind
:method: Everything is a variable, $\lambda=s/(1+s)$ with $s>0$; in the plane the third coordinates are 0.  So with both ends strictly on one side, $a$ and $b$ being
  their values or the negatives of them, the whole edge is; an edge that meets $L$ and has no end on it has its ends on two sides.
:over: q#: points; u#: normal vectors; a b s: -
:control: $\lambda$ and $1-\lambda$ exchanged
:::
*/
CLAIM(points_between_two_on_one_side_are_on_it)
{
    enum { space = 3 };
    num P[2 * space], Q[space], u[space], to[3][space], one = from_int(1);
    num s = positive(T, "s", 0), lambda = div(s, add(one, s)), other = sub(one, lambda);
    G(free_points)(T, 1, space, P);
    for (int c = 0; c < space; c++) {
        Q[c] = unknown(T, "q", c), u[c] = unknown(T, "u", c);
        num X = add(P[c], mul(lambda, sub(P[space + c], P[c])));
        to[0][c] = sub(P[c], Q[c]), to[1][c] = sub(P[space + c], Q[c]), to[2][c] = sub(X, Q[c]);
    }
    num of_first = fault(T, other, lambda), of_second = fault(T, lambda, other);
    /* u·(X - Q) = (1-λ) u·(A - Q) + λ u·(B - Q) */
    same(T, G(dot)(space, u, to[2]),
         add(mul(of_first, G(dot)(space, u, to[0])), mul(of_second, G(dot)(space, u, to[1]))));
    num a = positive(T, "a", 0), b = positive(T, "b", 0);
    about(T, "two ends on one side");
    G(must_be_positive)(T, add(mul(other, a), mul(lambda, b)));
    about(T, "two ends on two sides");
    /* (1-λ) a - λ b = (a + b)(a/(a+b) - λ) */
    same(T, sub(mul(other, a), mul(lambda, b)), mul(add(a, b), sub(div(a, add(a, b)), lambda)));
}

#if RATIONAL
/*
:::{claim} no_normal_no_line
:title: With the normal vector 0 three points that are not on a line are on L
:zh: 法向量为零时不成直线
:kind: counterexample
:data: X = (0,0) (1,0) (0,1); Q = (0,0); u = (0,0)
:instead: u = (0,1)
:result: u·(X-Q) = 0 0 0
:given: three points $X$ that are not on a line, a point $Q$, and $u=0$
:then: all three have $u\cdot(X-Q)=0$
:method: The three products.
:control: a vector that is not 0
:::
*/
CLAIM(no_normal_no_line)
{
    num X[3 * dim], Q[dim], u[dim], side[3];
    given_points(T, "X", 3, dim, X);
    given_points(T, "Q", 1, dim, Q);
    given_points(T, "u", 1, dim, u);
    G(sides)(2, X, Q, u, side);
    found_points(T, "u·(X-Q)", 3, 1, side);
    int all_on_it = is_zero_q(side[0]) && is_zero_q(side[1]) && is_zero_q(side[2]);
    about(T, "the three points are not all on L, or they are on a line");
    refute(T, all_on_it && turn_2d(X, X + dim, X + 2 * dim) != 0);
}

/*
:::{statement} deng-zhang-2022:property-3.6-sides
:title: A line that meets an edge has its ends on two sides
:zh: 边的两端在 L 两侧
:printed: if $L$ meets the edge between $P_j$ and $P_{j+1}$ then these two points are on the two sides of $L$, and
  $u\cdot(P_j-Q)$, $u\cdot(P_{j+1}-Q)$ have opposite signs
:holds-by: points_between_two_on_one_side_are_on_it
:confirmed-by: sign_changes_are_polygon_crossings
:hypothesis: line_through_an_edge_has_no_two_sides | neither of the two points is on $L$
:figure: line_along_an_edge
:::

An edge that meets $L$ has its ends on two sides, the text says.  It may also have one or both ends on $L$.

:::{claim} line_through_an_edge_has_no_two_sides
:title: A line that contains an edge, and one through its end, meet it and have no two sides with an end on each
:zh: 边在直线上、直线过边的端点时两端不在两侧
:kind: counterexample
:data: P = (0,0) (1,6) (2,10) (3,12) (4,12) (5,10) (6,6) (7,0); j = 3; Q = (7/2,12) (3,12); u = (0,1) (1,0)
:instead: Q = (7/2,12) (13/4,12); u = (1,0) (1,0)
:result: u·(P_j-Q) = 0 0; u·(P_{j+1}-Q) = 0 1
:given: a polygon, one of its edges, and two lines, each through a point $Q$ of this edge: one whose normal vector $u$ is orthogonal to the edge, and one
  across the edge in its end $P_j$
:then: the first line meets the edge in all its points, the second in its end; of the first the two numbers $u\cdot(P_j-Q)$, $u\cdot(P_{j+1}-Q)$ are 0, of
  the second one of them is
:method: The signs at the two ends are computed for both lines; opposite signs are asked for, of one of them.
:control: two lines across the edge between its ends
:::
*/
CLAIM(line_through_an_edge_has_no_two_sides)
{
    num P[8 * dim], u[2 * dim], Q[2 * dim], side[8], first[2], second[2];
    given_points(T, "P", 8, dim, P);
    int j = given_whole(T, "j"), opposite = 0;
    given_points(T, "Q", 2, dim, Q);
    given_points(T, "u", 2, dim, u);
    for (int line = 0; line < 2; line++) {
        G(sides)(7, P, Q + line * dim, u + line * dim, side);
        first[line] = side[j], second[line] = side[j + 1];
        opposite += sign_q(first[line]) * sign_q(second[line]) < 0;
    }
    found_points(T, "u·(P_j-Q)", 2, 1, first);
    found_points(T, "u·(P_{j+1}-Q)", 2, 1, second);
    about(T, "of one of the two lines the two numbers have opposite signs");
    agree(T, opposite > 0);
}

/*
:::{statement} deng-zhang-2022:eq-19
:title: The changes of sign are at most the intersections of the polygon
:zh: 式 (19)
:printed: $SA\{u\cdot(P_0-Q),\dots,u\cdot(P_7-Q)\}$ is at most the number of intersections of $L$ with the polygon
:holds-by: sign_changes_are_polygon_crossings points_between_two_on_one_side_are_on_it
:meant: the sentence before (19), which takes the edges between $P_j$ and $P_{j+1}$ one by one | Intersections are counted along the polygon.
:reading: polygon_that_crosses_itself_on_the_line | intersections counted as points of the plane: a polygon that crosses itself on $L$ may have fewer than
  changes of sign
:figure: polygon_crossing_itself
:degree: 7
:::

:::{claim} polygon_that_crosses_itself_on_the_line
:title: A polygon that crosses itself on the line has more changes of sign than points there
:zh: 控制多边形在直线上自交
:kind: counterexample
:data: P = (-2,2) (2,-2) (2,-3) (1,-3) (-1,-3) (-2,-3) (-2,-2) (2,2); Q = (0,0); u = (0,1)
:instead: P = (-2,2) (2,-2) (2,-3) (1,-3) (-1,-3) (-2,-3) (-2,-2) (3,2)
:result: SA = 2; points on the line = 1
:given: a polygon whose first and last edge cross in $Q$, and the line through $Q$ with the normal vector $u$
:then: the sign of $u\cdot(P_j-Q)$ changes twice, and the polygon has one point on the line, which it passes twice
:method: Changes of sign, and the connected components of the common points in the plane, counted exactly.
:control: the last point moved, so that the edges cross elsewhere
:::
*/
CLAIM(polygon_that_crosses_itself_on_the_line)
{
    num P[8 * dim];
    given_points(T, "P", 8, dim, P);
    struct cagd_polygon_meets_line m = polygon_meets_line(7, P, G(given_line)(T));
    found_whole(T, "SA", m.crossings);
    found_whole(T, "points on the line", m.components);
    about(T, "there are no more changes of sign than points");
    agree(T, m.crossings <= m.components);
}

/*
:::{statement} deng-zhang-2022:eq-20
:title: The intersections of the curve with a line are roots
:zh: 式 (20)
:printed: the number of intersections of $B_1(t)$ with $L$ is Zero$(0,1)\{\sum_{j=0}^7B_{j,7}(t)(P_j-Q)\cdot u\}$
  (definition 2.1: $-7\le\beta\le1$)
:refuted-by: printed_curve_crosses_a_line_off_its_polygon curve_and_line_share_an_end
:class: false
:corrected: for the corrected functions (`sec-2-properties`) the function is $(q(t)-Q)\cdot u$ with the curve $q$, and its roots in $(0,1)$ are the parameters $t$ of common
  points with $0<t<1$; with the printed functions the function is $(q(t)-Q)\cdot u$ only for $\beta=0$ or $Q\cdot u=0$
:corrected-by: line_function_of_the_curve
:figure: crossings_off_the_polygon
:degree: 7

The step uses the sum 1.  It also leaves out $t=0$ and $t=1$, where $P_0$ or $P_7$ may be on $L$.
:::

:::{statement} deng-zhang-2022:eq-21
:title: The intersections of the curve are at most the changes of sign
:zh: 式 (21)
:printed: the number of intersections of $B_1(t)$ with $L$ is at most $SA\{u\cdot(P_0-Q),\dots,u\cdot(P_7-Q)\}$
  (definition 2.1: $-7\le\beta\le1$)
:refuted-by: printed_curve_crosses_a_line_off_its_polygon curve_and_line_share_an_end
  curve_on_a_line_that_its_polygon_crosses
:class: false
:corrected: for the common points with $0<t<1$, when the curve is not on $L$: true for the corrected functions (`sec-2-properties`) exactly if
  $-\frac{21}4\le\beta\le1$, for the printed ones only for $\beta=0$
:corrected-by: totally_positive_exactly_in_the_range inversions_of_two_diagonals_meet_a_zero nonnegative_exactly_in_the_range averages_between_neighbours_keep_sign_changes
  linear_factor_adds_a_change_of_sign line_function_of_the_curve third_function_has_a_zero_for_every_smaller_beta first_function_has_a_zero_for_every_larger_beta
  printed_sum_in_closed_form
:confirmed-by: roots_are_at_most_sign_changes
:figure: crossings_off_the_polygon

Below the range and above it one function has a zero inside: with $u\cdot(P_i-Q)=1$ for this $i$ and 0 for the others it is a common point, and $SA$ is 0.  With the
printed functions and $\beta\ne0$ the curve of eight equal points $P$ that are not the origin is $(1-4\beta(1-t)^3t^4)P$, and meets lines for which all
$u\cdot(P-Q)$ are equal and not 0.
:::

:::{claim} curve_and_line_share_an_end
:title: A line through an end meets the curve without a root in (0,1)
:zh: 过端点的直线
:kind: counterexample
:data: β = 0; P = (0,0) (1,6) (2,10) (3,12) (4,12) (5,10) (6,6) (7,1); Q = (0,0); u = (0,1)
:instead: Q = (0,7/2)
:result: common points of the curve = 1; roots in (0,1) = 0; SA = 0
:given: the $\beta$ of the Bézier curve, a convex polygon, and a line through $Q=P_0$ with the normal vector $u$, on one side of which the polygon is
:then: curve and line have the point $P_0$ in common; the function of formula (20) has no root in $(0,1)$, and its
  coefficients no change of sign
:method: The common points of the closed curve are compared with those of the open one, the roots, and with the changes of sign; that one of the two is
  as printed is asked.
:control: a line through the middle of the polygon
:::
*/
CLAIM(curve_and_line_share_an_end)
{
    struct G(meeting) m = G(given_meeting)(T, 0);
    found_whole(T, "common points of the curve", m.curve.common_closed);
    found_whole(T, "roots in (0,1)", m.curve.common_open);
    found_whole(T, "SA", m.polygon.crossings);
    about(T, "as many common points as roots in (0,1), or no more than changes of sign");
    agree(T, m.curve.common_closed == m.curve.common_open || m.curve.common_closed <= m.polygon.crossings);
}
#endif

/*
What is right about (20) is an identity.  It also shows by how much the printed functions miss: the difference is a multiple
of $Q\cdot u$, so a line through the origin would not have shown it.

:::{claim} line_function_of_the_curve
:title: With the sum 1 the function of the proof is (q(t)-Q).u
:zh: 曲线与直线的函数
:given: points $P_i$ and $Q$ of the plane, any $u$, $\beta$ and $t$
:then: $\sum B_{j,n}(t)(P_j-Q)\cdot u=(q(t)-Q)\cdot u$; for $n=7$ and the printed functions the difference of the two sides is
  $4\beta(1-t)^3t^4\,Q\cdot u$
:method: Everything is a variable.  In space each side has one summand more, of the same form.
:degrees: 2..7 sampled 12
:over: q#: points; u#: normal vectors
:control: $P_0$ left without $Q$
:::
*/
CLAIM(line_function_of_the_curve)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], B[MAX_DEGREE + 1], at[dim], beta = unknown(T, "beta", 0), t = parameter(T, "t");
    num Q[dim] = {unknown(T, "q", 0), unknown(T, "q", 1)}, u[dim] = {unknown(T, "u", 0), unknown(T, "u", 1)};
    G(free_points)(T, n, dim, P);
    for (int printed_ones = 0; printed_ones <= (n == 7); printed_ones++) {
        num sum = from_int(0);
        G(functions_of)(printed_ones, n, beta, t, B);
        G(curve_point)(printed_ones, n, dim, P, beta, t, at);
        for (int j = 0; j <= n; j++) {
            num w[dim] = {sub(P[j * dim], Q[0]), sub(P[j * dim + 1], Q[1])};
            sum = add(sum, mul(B[j], fault(T, G(dot)(dim, w, u), j == 0 ? G(dot)(dim, P, u) : G(dot)(dim, w, u))));
        }
        num gap[dim] = {sub(at[0], Q[0]), sub(at[1], Q[1])}, value = G(dot)(dim, gap, u);
        if (printed_ones)
            value = add(value, mul(mul(from_int(4), mul(beta, G(product_of_powers)(3, 4, t))), G(dot)(dim, Q, u)));
        /* Σ B_j (P_j - Q)·u = (q(t) - Q)·u, for the printed functions + 4β (1-t)³ t⁴ Q·u */
        same(T, sum, value);
    }
}

#include "chapters/judge/claims_off.h"
