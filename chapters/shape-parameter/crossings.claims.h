/*
# Crossing a line (变差缩减性)

The corrected functions are the Bernstein polynomials of degree $n+1$ times a matrix $E$ with two diagonals.  A minor of
such a matrix is the product of the entries on its own diagonal, so that $E$ is totally nonnegative exactly when none of
its entries is negative, and this was decided: for $-\frac{21}4\le\beta\le1$.  The Bernstein polynomials are totally positive
on $(0,1)$, and the product of totally nonnegative matrices is one.  So there the eight functions are *normalized totally
positive* (规范全正基), and what the source wants to prove, follows.  Outside the range one function changes its sign, a
minor of order one is negative, and everything fails.

With $k_0,\dots,k_7$ for the coefficients, $f=\sum k_iB_i$ has the Bernstein coefficients $c_j=E_{j,j-1}k_{j-1}+E_{j,j}k_j$ of
degree 8, and $Z(f)\le V(c)\le V(k)$.
*/
#include "exact/record/crossings.h"
#include "exact/record/resultant.h"
#include "exact/record/roots.h"
#include "exact/record/total_positivity.h"

#include "chapters/shape-parameter/definition.h"
#include "chapters/shape-parameter/meeting.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} deng-zhang-2022:property-3.6
:title: No line crosses the curve more often than the polygon
:zh: 变差缩减性
:printed: the curve is variation diminishing (definition 2.1: $-7\le\beta\le1$)
:refuted-by: printed_curve_crosses_a_line_off_its_polygon curve_at_minus_seven_crosses_a_line_off_its_polygon
  curve_on_a_line_that_its_polygon_crosses
:class: false
:corrected: true for the corrected functions (`sec-2-properties`), crossings of a line $L$, in space a plane, and common points with it being counted along the
  curve and along the polygon, exactly when $-\frac{21}4<\beta\le1$, at $\beta=-\frac{21}4$ for crossings, and for common points unless the curve is on $L$
  and the polygon is not; for the printed functions only for $\beta=0$
:corrected-by: totally_positive_exactly_in_the_range inversions_of_two_diagonals_meet_a_zero corrected_functions_sum_to_one
  functions_are_independent_but_for_two_values linear_factor_adds_a_change_of_sign
  averages_between_neighbours_keep_sign_changes third_function_has_a_zero_for_every_smaller_beta
  first_function_has_a_zero_for_every_larger_beta printed_sum_in_closed_form
  combination_begins_and_ends_with_its_coefficients sign_changes_are_counted_one_by_one
:confirmed-by: roots_are_at_most_sign_changes
:meant: the proof, which counts changes of sign along the polygon in (19) and parameters of the curve in (20) | Intersections are counted along the curve and along the polygon.
:reading: self_crossing_polygon_has_fewer_points_on_a_line | common points counted as points of the plane: a polygon that crosses itself on $L$
  may have fewer than its curve, already than the Bézier curve of $\beta=0$
:figure: crossings_off_the_polygon
:striking: 12

With two neighbours $k_{i-1},k_i$ each Bernstein coefficient of $\sum k_iB_i$ is a multiple of an average of the two, not a negative one, where the entries of the
matrix are not negative: so the coefficients have no more changes of sign than $k$, and the roots in $(0,1)$ are no more than these.
With the sum 1 this is said of $k_i=u\cdot(P_i-Q)$ and of the distance of the curve from $L$.  Every change of sign is a crossing of the polygon, with
a common point or edge of its own; an end of the curve is on $L$ when that end of the polygon is.  Below the range and above it one function has a zero inside,
where it changes its sign: with its point at the height 1 and all others on the line $y=0$ the curve crosses this line, and the polygon does not.
With the printed functions and $\beta\ne0$ the curve of eight equal points
$P$ that are not the origin is $(1-4\beta(1-t)^3t^4)P$, and meets lines that do not meet $P$.
:::
*/

#if FIELD || RATIONAL
/*
The way to the correction has two steps.  Algebra first: with two neighbouring diagonals every minor is a product of
entries, so that the signs of thousands of minors are decided by the signs of sixteen entries.  Then the range: the entries
are linear in $\beta$, and between the neighbouring roots nothing can change.

A minor is a sum over permutations.  All but the identity exchange somewhere the order of two rows, and such a pair of
entries lies so far apart that two diagonals cannot hold both.

:::{claim} inversions_of_two_diagonals_meet_a_zero
:title: Where two rows take their columns in the other order one of the two entries is 0
:zh: 双对角矩阵的子式中仅恒等排列有贡献
:given: a matrix of any size whose entries $(r,c)$ are 0 but for $r-c=0$ and $r-c=1$; two rows $r<r'$ and two columns $c<c'$
:harmless: two rows $r<r'$ and two columns $c<c'$ | of two rows one comes first
:then: if the entry $(r,c')$ is not 0, then $r'-c>1$, and the entry $(r',c)$ is 0; so of the sum over the permutations that is a minor
  only the product of its own diagonal is left
:method: With $r'=r+1+a$, $c'=c+1+b$ and $r-c'=e$, which is 0 or 1: $r'-c-1=e+1+a+b$ is positive for all $a,b\ge0$.  Every
  permutation but the identity exchanges the order of some two rows.
:types: field rational
:degrees: all
:over: a b: -
:control: both orders reversed, $r'=r-1-a$ and $c'=c-1-b$
:::
*/
CLAIM(inversions_of_two_diagonals_meet_a_zero)
{
    num a = positive(T, "a", 0), b = positive(T, "b", 0), one = from_int(1);
    num rows_apart = fault(T, add(one, a), neg(add(one, a))), columns_apart = fault(T, add(one, b), neg(add(one, b)));
    for (int e = 0; e <= 1; e++) {
        /* r' - c = (r' - r) + (r - c') + (c' - c) */
        num below = add(rows_apart, add(from_int(e), columns_apart));
        G(must_be_positive)(T, sub(below, one));
    }
}

/*

:::{claim} minors_are_products_of_entries
:title: A minor of a matrix with two neighbouring diagonals is the product of its diagonal
:zh: 双对角矩阵的子式
:given: any $(n+2)\times(n+1)$ matrix whose entries are $0$ but for $E_{i,i}$ and $E_{i+1,i}$, which are variables
:then: every minor is the product of the entries on its own diagonal
:method: All minors, by an elimination with pivots.
:types: field rational
:degrees: 2..4 sampled 5
:over: v# w#: entries
:control: an entry above the diagonal is not 0
:::
*/
CLAIM(minors_are_products_of_entries)
{
    int n = T->degree, rows = n + 2, columns = n + 1;
    num E[8 * 7], M[7 * 7];
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++)
            E[i * columns + j] = i == j ? unknown(T, "v", i) : i == j + 1 ? unknown(T, "w", j) : from_int(0);
    E[1] = fault(T, E[1], from_int(1));
    for (int r = 1; r < 1 << rows; r++)
        for (int c = 1; c < 1 << columns; c++) {
            int row[8], column[8], order = 0, width = 0;
            for (int i = 0; i < rows; i++)
                if (r >> i & 1)
                    row[order++] = i;
            for (int j = 0; j < columns; j++)
                if (c >> j & 1)
                    column[width++] = j;
            if (order != width)
                continue;
            num diagonal = from_int(1);
            for (int i = 0; i < order; i++) {
                diagonal = mul(diagonal, E[row[i] * columns + column[i]]);
                for (int j = 0; j < order; j++)
                    M[i * order + j] = E[row[i] * columns + column[j]];
            }
            same(T, G(pivoted_determinant)(order, M), diagonal);
        }
}
#endif

#if RATIONAL
/*
:::{claim} totally_positive_exactly_in_the_range
:title: The matrix of the functions is totally nonnegative exactly in the true range
:zh: 规范全正的充要条件
:kind: decision
:data: l_7 = -21/4
:given: all real $\beta$; corrected functions of degree $n$, for the degree of the source also the printed ones
:then: the matrix of Bernstein coefficients has no negative minor exactly for $l_n\le\beta\le1$, where $l_n$ is the
  greatest $\beta$ at which some $\nu_i$ vanishes from above; $l_7=-\frac{21}4$
:method: The minors are products of entries, and these are linear in $\beta$; so the signs of all minors are constant
  between the neighbouring roots of the entries.  At every root and once in every gap the elimination of
  `total_positivity.h` decides.
:degrees: 2..12
:scope: every real β
:control: the range taken to begin 1 below
:::
*/
/* The greatest root of a near_i whose slope is positive: below it the functions of degree n are not all nonnegative. */
static num G(lower_end)(int n)
{
    poly near[MAX_DEGREE + 1], far[MAX_DEGREE + 1];
    num end = from_int(-8);
    G(factors_in_beta)(0, n, near, far);
    for (int i = 0; i <= n; i++)
        if (sign_q(poly_coefficient(near[i], 1)) > 0) {
            num zero = neg(div(poly_coefficient(near[i], 0), poly_coefficient(near[i], 1)));
            end = compare_q(zero, end) > 0 ? zero : end;
        }
    return end;
}

CLAIM(totally_positive_exactly_in_the_range)
{
    int n = T->degree;
    num low = G(lower_end)(n), high = from_int(1), of_seven = given(T, "l_7");
    if (n == 7)
        agree(T, equal_q(low, of_seven));
    low = fault(T, low, sub(low, from_int(1)));
    for (int printed_ones = 0; printed_ones <= (n == 7); printed_ones++) {
        poly near[MAX_DEGREE + 1], far[MAX_DEGREE + 1];
        num at[2 * MAX_DEGREE + 4];
        int roots = 0;
        G(factors_in_beta)(printed_ones, n, near, far);
        for (int i = 0; i <= 2 * n + 1; i++) { /* the roots of the entries, in order */
            poly entry = i <= n ? near[i] : far[i - n - 1];
            if (is_zero_q(poly_coefficient(entry, 1)))
                continue;
            num zero = neg(div(poly_coefficient(entry, 0), poly_coefficient(entry, 1)));
            int k = roots++;
            for (; k > 0 && compare_q(at[k - 1], zero) > 0; k--)
                at[k] = at[k - 1];
            at[k] = zero;
        }
        for (int k = 0; k <= 2 * roots; k++) { /* gap, root, gap, ..., gap */
            num E[14 * 13], one = from_int(1), beta;
            if (k % 2 == 1)
                beta = at[k / 2];
            else if (k == 0)
                beta = sub(at[0], one);
            else if (k == 2 * roots)
                beta = add(at[roots - 1], one);
            else
                beta = div(add(at[k / 2 - 1], at[k / 2]), from_int(2));
            G(matrix_of)(printed_ones, n, beta, E);
            int inside_range = compare_q(low, beta) <= 0 && compare_q(beta, high) <= 0;
            agree(T, is_totally_nonnegative(n + 2, n + 1, E) == inside_range);
        }
    }
}
#endif

#if FIELD || RATIONAL
/*
"Exactly" in the correction asks for the other direction, too: that beyond each end of the range the property fails for
every $\beta$ and not only for the one of an example.  One function with a root inside the interval is enough.  Its
coefficients are 0 but for one, so they do not change their sign.

:::{claim} third_function_has_a_zero_for_every_smaller_beta
:title: For every beta below the range the third function has a zero inside
:zh: β<-21/4 时 B_2 在 (0,4/9) 内有零点
:given: any $\beta=-\frac{21}4-b$, $b>0$; printed and corrected functions
:then: $B_2$ vanishes at $t=\frac{4b}{9(21/4+b)}$, which is in $(0,\frac49)$ and not a root of the other factors
:method: The values of the function at this $t$, $b$ a variable; the two bounds have coefficients of one sign.  So with
  $k=(0,0,1,0,\dots)$ there is a root and no change of sign.  With the points
  $(0,0),(0,0),(1,1),(2,0),\dots,(2,0)$ the height of the curve is $B_2$, and it has $t=0$, this $t$ and $t=1$ on the line $y=0$.
:types: field rational
:degrees: 7..7
:scope: every β < −21/4
:harmless: $b>0$ | it is $\beta<-\frac{21}4$
:over: b: -
:control: $b$ replaced by $2b$ in the parameter
:::
*/
CLAIM(third_function_has_a_zero_for_every_smaller_beta)
{
    num b = positive(T, "b", 0), quarter = from_ratio(21, 4), four = from_int(4);
    num beta = neg(add(quarter, b)), given = fault(T, b, mul(from_int(2), b));
    /* t = 4b/(9 (21/4 + b)) */
    num t = div(mul(four, given), mul(from_int(9), add(quarter, given))), B[8];
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        G(functions_of)(printed_ones, 7, beta, t, B);
        vanishes(T, B[2]);
    }
    G(must_be_positive)(T, t);
    G(must_be_positive)(T, sub(from_ratio(4, 9), t));
}

/*
:::{claim} first_function_has_a_zero_for_every_larger_beta
:title: For every beta above 1 the first function has a zero inside
:zh: β>1 时 B_0 在 (0,1) 内有零点
:given: any $\beta=1+b$, $b>0$; printed and corrected functions
:then: $B_0$ vanishes at $t=\frac1{1+b}$, which is in $(0,1)$
:method: The values of the function at this $t$, $b$ a variable; with $k=(1,0,\dots,0)$ there is a root and no change of sign.
:types: field rational
:degrees: 7..7
:scope: every β > 1
:harmless: $b>0$ | it is $\beta>1$
:over: b: -
:control: $b$ replaced by $2b$ in the parameter
:::
*/
CLAIM(first_function_has_a_zero_for_every_larger_beta)
{
    num b = positive(T, "b", 0), one = from_int(1), B[8];
    num beta = add(one, b), t = div(one, add(one, fault(T, b, add(b, b))));
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        G(functions_of)(printed_ones, 7, beta, t, B);
        vanishes(T, B[0]);
    }
    G(must_be_positive)(T, t);
    G(must_be_positive)(T, sub(one, t));
}
#endif

#if RATIONAL
/*
What is counted matters, too.  Where the polygon crosses itself on the line, two parameters of it are one point of the plane, and the
curve, already the Bézier curve, may have two.

:::{claim} self_crossing_polygon_has_fewer_points_on_a_line
:title: The curve of a polygon that crosses itself on a line has more points there
:zh: 控制多边形在直线上自交时曲线与直线的公共点更多
:kind: counterexample
:data: β = 0; P = (-15,63) (-15,15) (17,-17) (17,-33) (-17,-33) (-17,-17) (15,15) (15,63); Q = (0,0); u = (0,1); t = 1/4 3/4
:instead: P = (-15,63) (-15,15) (17,-17) (17,-33) (-17,-33) (-17,-17) (17,15) (15,63)
:result: q(t) = (831/2048,0) (-831/2048,0); points of the curve on the line = 2; points of the polygon on the line = 1
:given: the Bézier curve of a polygon whose second and last edge but one cross in $Q$, the line through $Q$ with the normal vector $u$, and two
  parameters $t$
:then: the points of the two parameters differ and are all that the curve has on the line; the polygon has one point there, which it passes twice
:method: The points by the kernel; the intersections of curve and polygon are counted exactly.
:control: a polygon that passes two points
:::
*/
CLAIM(self_crossing_polygon_has_fewer_points_on_a_line)
{
    struct G(meeting) m = G(given_meeting)(T, 0);
    num t[2], q[2 * dim];
    given_points(T, "t", 2, 1, t);
    for (int k = 0; k < 2; k++)
        G(curve_point)(0, 7, dim, m.P, m.beta, t[k], q + k * dim);
    found_points(T, "q(t)", 2, dim, q);
    int of_curve = 1 + !equal_q(q[0], q[dim]),
        all = m.curve.common_closed == 2 && is_zero_q(q[1]) && is_zero_q(q[dim + 1]);
    found_whole(T, "points of the curve on the line", of_curve);
    found_whole(T, "points of the polygon on the line", m.polygon.components);
    about(T, "the curve, with these points and no others on the line, has no more of them than the polygon");
    refute(T, all && of_curve > m.polygon.components);
}

/*
Three curves show the three ways in which the print fails.  At the left end of the true range the functions are dependent,
and a combination that vanishes is a curve that lies on a line; it crosses nothing, but has all its points in common with
the line.  The printed functions, having another sum than 1, leave a polygon that is straight.  At $\beta=-7$ the negative
values of $B_2$ take the curve below its triangle.

:::{claim} curve_on_a_line_that_its_polygon_crosses
:title: At beta = -21/4 a curve is on a line that its polygon crosses three times
:zh: β=-21/4 时曲线全在一条直线上而控制多边形与之相交
:kind: counterexample
:data: β = -21/4; P = (0,0) (0,0) (1,-1) (2,27/5) (3,-27/5) (4,1) (5,0) (5,0); Q = (0,0); u = (0,1)
:instead: β = -5
:result: the curve is on the line = "yes"; common points of the polygon = 5; crossings of the polygon = 3
:given: the least $\beta$ for which the functions are nonnegative, a polygon, and the line through $Q$ with the normal vector $u$; corrected functions
:then: the whole curve, from $P_0$ to $P_7$, is on the line; the polygon crosses the line and has single points on it, no edge of positive length
:method: The curve's Bézier points; `crossings.h` counts the components of the polygon's common points.
:control: a $\beta$ inside the range
:::
*/
CLAIM(curve_on_a_line_that_its_polygon_crosses)
{
    struct G(meeting) m = G(given_meeting)(T, 0);
    found_text(T, "the curve is on the line", m.curve.contained ? "yes" : "no");
    found_whole(T, "common points of the polygon", m.polygon.components);
    found_whole(T, "crossings of the polygon", m.polygon.crossings);
    int crossed = m.polygon.contained_edges == 0 && m.polygon.crossings > 0;
    about(T, "the curve is not on the line, which the polygon crosses and of which it has single points only");
    refute(T, crossed && m.curve.contained);
}

/*
:::{claim} printed_curve_crosses_a_line_off_its_polygon
:title: The printed curve crosses a line that does not meet its polygon
:zh: 按式 (1) 的曲线穿过与多边形不交的直线
:kind: counterexample
:data: β = 1; P = (0,1) (1,1) (2,1) (3,1) (4,1) (5,1) (6,1) (7,1); Q = (0,63/64); u = (0,1)
:result: crossings of the curve = 2; crossings of the polygon = 0; roots of (20) in (0,1) = 0
:given: the right end of the range of $\beta$, points on a line, and the line through $Q$ with the normal vector $u$, a
  little below; printed functions $\hat B_j$
:then: the line does not cross the polygon, and the curve crosses it; $\sum\hat B_j(P_j-Q)\cdot u$ has no root
:method: The crossings are counted exactly by `crossings.h`, the roots of the polynomial by `roots.h`; that the first are no more than those of the
  polygon, or than the roots, is asked.
:control: the corrected functions
:::
*/
CLAIM(printed_curve_crosses_a_line_off_its_polygon)
{
    struct G(meeting) m = G(given_meeting)(T, fault(T, 0, 1));
    found_whole(T, "crossings of the curve", m.curve.crossings);
    found_whole(T, "crossings of the polygon", m.polygon.crossings);
    poly f = G(combination)(fault(T, 0, 1), 7, m.beta, m.side);
    int roots = count_roots(f, from_int(0), from_int(1), OPEN).distinct;
    found_whole(T, "roots of (20) in (0,1)", roots);
    about(T, "the curve crosses the line no more often than the polygon, or than (20) has roots");
    agree(T, m.curve.crossings <= m.polygon.crossings || m.curve.crossings <= roots);
}

/*
:::{claim} curve_at_minus_seven_crosses_a_line_off_its_polygon
:title: At beta = -7 the curve crosses a line that does not meet its polygon
:zh: β=-7 时曲线穿过与多边形不交的直线
:kind: counterexample
:data: β = -7; P = (0,0) (0,0) (1,1) (2,0) (2,0) (2,0) (2,0) (2,0); Q = (0,-1/200); u = (0,1)
:instead: β = -21/4
:result: crossings of the curve = 2; crossings of the polygon = 0
:given: the left end of the printed range, the three corners of a triangle with the first and the last repeated, and the
  line through $Q$ with the normal vector $u$, a little below its side; corrected functions
:then: the polygon is above the line, the curve crosses it
:method: The crossings are counted exactly.
:control: the left end of the true range
:::
*/
CLAIM(curve_at_minus_seven_crosses_a_line_off_its_polygon)
{
    struct G(meeting) m = G(given_meeting)(T, 0);
    found_whole(T, "crossings of the curve", m.curve.crossings);
    found_whole(T, "crossings of the polygon", m.polygon.crossings);
    about(T, "the curve crosses the line no more often than the polygon");
    agree(T, m.curve.crossings <= m.polygon.crossings);
}
#endif

#include "chapters/judge/claims_off.h"
