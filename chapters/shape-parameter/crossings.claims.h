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
#include "exact/record/hull.h"
#include "exact/record/resultant.h"
#include "exact/record/roots.h"
#include "exact/record/total_positivity.h"

#include "chapters/shape-parameter/definition.h"
#include "chapters/shape-parameter/distance.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} deng-zhang-2022:property-3.6
:title: No line crosses the curve more often than the polygon
:zh: 变差缩减性
:printed: the curve is variation diminishing, $-7\le\beta\le1$
:refuted-by: printed_curve_crosses_a_line_off_its_polygon curve_at_minus_seven_crosses_a_line_off_its_polygon
  curve_on_a_line_that_its_polygon_crosses
:class: false
:corrected: true for the corrected functions exactly when $-\frac{21}4<\beta\le1$, at $\beta=-\frac{21}4$ for crossings, and for common
  points unless the curve is on $L$ and the polygon is not; for the printed functions only for $\beta=0$
:corrected-by: totally_positive_exactly_in_the_range minors_are_products_of_entries corrected_functions_sum_to_one
  functions_are_independent_but_for_two_values
  roots_are_at_most_sign_changes averages_between_neighbours_keep_sign_changes
  third_function_has_a_zero_for_every_smaller_beta first_function_has_a_zero_for_every_larger_beta
  printed_sum_in_closed_form
:figure: crossings_off_the_polygon
:striking: 12
:::
*/

#if FIELD || RATIONAL
/*
:::{claim} minors_are_products_of_entries
:title: A minor of a matrix with two neighbouring diagonals is the product of its diagonal
:zh: 双对角矩阵的子式
:given: any $(n+2)\times(n+1)$ matrix whose entries are $0$ but for $E_{i,i}$ and $E_{i+1,i}$, which are variables
:then: every minor is the product of the entries on its own diagonal
:method: All minors, by an elimination with pivots.  For every $n$: of two rows $r<r'$ and columns $c'<c$ the entries $(r,c)$ and
  $(r',c')$ cannot both be different from 0, since that would need $c\le r<r'\le c'+1\le c$; so only the identity counts among
  the permutations.
:types: field rational
:degrees: 2..4 sampled 5
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
:given: all real $\beta$; corrected functions of degree $n$, for $n=7$ also the printed ones
:then: the matrix of Bernstein coefficients has no negative minor exactly for $l_n\le\beta\le1$, where $l_7=-\frac{21}4$ and $l_n$ is
  the greatest $\beta$ at which some $\nu_i$ vanishes from above
:method: The minors are products of entries, and these are linear in $\beta$; so the signs of all minors are constant between the
  neighbouring roots of the entries.  At every root and once in every gap the elimination of `total_positivity.h` decides.
:degrees: 2..12
:scope: all real $\beta$
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
    num low = G(lower_end)(n), high = from_int(1);
    if (n == 7)
        agree(T, equal_q(low, from_ratio(-21, 4)));
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
:::{claim} third_function_has_a_zero_for_every_smaller_beta
:title: For every beta below the range the third function has a zero inside
:zh: β<-21/4 时 B_2 在 (0,1/2) 内有零点
:given: any $\beta=-\frac{21}4-b$, $b>0$; printed and corrected functions
:then: $B_2$ vanishes at $t=\frac{4b}{9(21/4+b)}$, which is in $(0,\frac49)$ and not a root of the other factors
:method: The value of the kernel at this $t$, $b$ a variable; the two bounds have coefficients of one sign.  So with
  $k=(0,0,1,0,\dots)$ there is a root and no change of sign, and the triangle $(0,0),(1,1),(2,0)$ with the points of
  `curve_of_a_triangle_meets_a_line_three_times` has three common points with the line $y=0$.
:types: field rational
:control: $b$ replaced by $2b$ in the parameter
:::
*/
CLAIM(third_function_has_a_zero_for_every_smaller_beta)
{
    num b = positive(T, "b", 0), quarter = from_ratio(21, 4), four = from_int(4);
    num beta = neg(add(quarter, b)), given = fault(T, b, mul(from_int(2), b));
    num t = div(mul(four, given), mul(from_int(9), add(quarter, given))), B[8];
    G(shape_basis)(7, beta, t, B);
    vanishes(T, B[2]);
    G(shape_basis_printed)(beta, t, B);
    vanishes(T, B[2]);
    nonnegative(T, t);
    nonnegative(T, sub(from_ratio(4, 9), t));
}

/*
:::{claim} first_function_has_a_zero_for_every_larger_beta
:title: For every beta above 1 the first function has a zero inside
:zh: β>1 时 B_0 在 (0,1) 内有零点
:given: any $\beta=1+b$, $b>0$; printed and corrected functions
:then: $B_0$ vanishes at $t=\frac1{1+b}$, which is in $(0,1)$
:method: The value of the kernel at this $t$, $b$ a variable; with $k=(1,0,\dots,0)$ there is a root and no change of sign.
:types: field rational
:control: $b$ replaced by $2b$ in the parameter
:::
*/
CLAIM(first_function_has_a_zero_for_every_larger_beta)
{
    num b = positive(T, "b", 0), one = from_int(1), B[8];
    num beta = add(one, b), t = div(one, add(one, fault(T, b, add(b, b))));
    G(shape_basis)(7, beta, t, B);
    vanishes(T, B[0]);
    G(shape_basis_printed)(beta, t, B);
    vanishes(T, B[0]);
    nonnegative(T, sub(one, t));
}
#endif

#if RATIONAL
/* side[i] = u . (X_i - Q) for n+1 points X */
static void G(sides)(int n, const num X[], const num Q[], const num u[], num side[])
{
    for (int i = 0; i <= n; i++) {
        num w[dim] = {sub(X[i * dim], Q[0]), sub(X[i * dim + 1], Q[1])};
        side[i] = G(dot)(dim, u, w);
    }
}

/* The line through the point Q with the normal vector u, from the data of the claim. */
static struct cagd_line G(given_line)(trial *T)
{
    num Q[dim], u[dim];
    given_points(T, "Q", 1, dim, Q);
    given_points(T, "u", 1, dim, u);
    return (struct cagd_line){u[0], u[1], neg(G(dot)(dim, u, Q))};
}

/* How the curve of eight points, printed or corrected functions, meets the line. */
static struct cagd_curve_meets_line G(curve_meets)(int printed_ones, const num P[], num beta, struct cagd_line L)
{
    num points[9 * dim], w[9];
    for (int k = 0; k <= 8; k++)
        w[k] = from_int(1);
    G(bezier_points_of)(printed_ones, 7, dim, P, beta, points);
    return curve_meets_line(8, points, w, L);
}

/* A curve of the family, its polygon, and how both meet a line; side[i] = u . (P_i - Q). */
struct G(meeting) {
    num beta, P[8 * dim], side[8];
    struct cagd_curve_meets_line curve;
    struct cagd_polygon_meets_line polygon;
};

/* That of the data of the claim: β, eight points P, the point Q and the normal vector u. */
static struct G(meeting) G(given_meeting)(trial *T, int printed_ones)
{
    struct G(meeting) m = {.beta = given(T, "β")};
    given_points(T, "P", 8, dim, m.P);
    struct cagd_line L = G(given_line)(T);
    for (int i = 0; i <= 7; i++)
        m.side[i] = add(add(mul(L.a, m.P[i * dim]), mul(L.b, m.P[i * dim + 1])), L.c);
    m.curve = G(curve_meets)(printed_ones, m.P, m.beta, L);
    m.polygon = polygon_meets_line(7, m.P, L);
    return m;
}

/*
:::{claim} curve_on_a_line_that_its_polygon_crosses
:title: At beta = -21/4 a curve is on a line that its polygon crosses three times
:zh: β=-21/4 时曲线全在一条直线上而控制多边形与之相交
:kind: counterexample
:data: β = -21/4; P = (0,0) (0,0) (1,-1) (2,27/5) (3,-27/5) (4,1) (5,0) (5,0); Q = (0,0); u = (0,1)
:instead: β = -5
:result: the curve is on the line = "yes"; common points of the polygon = 5; crossings of the polygon = 3
:given: the left end of the true range, a polygon, and the line through $Q$ with the normal vector $u$; corrected functions
:then: the whole curve, from $P_0$ to $P_7$, is on the line; the polygon crosses the line and has single points on it, no edge
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
    about(T, "the polygon crossing the line and having no edge on it, whether the curve is not on it");
    refute(T, crossed && m.curve.contained);
}

/*
:::{claim} printed_curve_crosses_a_line_off_its_polygon
:title: The printed curve crosses a line that does not meet its polygon
:zh: 按式 (1) 的曲线穿过与多边形不交的直线
:kind: counterexample
:data: β = 1; P = (0,1) (1,1) (2,1) (3,1) (4,1) (5,1) (6,1) (7,1); Q = (0,63/64); u = (0,1)
:result: crossings of the curve = 2; crossings of the polygon = 0; roots of (20) in (0,1) = 0
:given: the right end of the range of $\beta$, points on a line, and the line through $Q$ with the normal vector $u$, a little below
:then: the line does not meet the polygon, $SA=0$, and the curve crosses it; $\sum\hat B_j(P_j-Q)\cdot u$ has no root
:method: The crossings are counted exactly by `crossings.h`, the roots of the polynomial by `roots.h`.
:control: the corrected functions
:::
*/
CLAIM(printed_curve_crosses_a_line_off_its_polygon)
{
    struct G(meeting) m = G(given_meeting)(T, fault(T, 0, 1));
    found_whole(T, "crossings of the curve", m.curve.crossings);
    found_whole(T, "crossings of the polygon", m.polygon.crossings);
    poly f = G(combination)(fault(T, 0, 1), 7, m.beta, m.side);
    found_whole(T, "roots of (20) in (0,1)", count_roots(f, from_int(0), from_int(1), OPEN).distinct);
    about(T, "the curve crosses the line no more often than the polygon");
    agree(T, m.curve.crossings <= m.polygon.crossings);
}

/*
:::{claim} curve_at_minus_seven_crosses_a_line_off_its_polygon
:title: At beta = -7 the curve crosses a line that does not meet its polygon
:zh: β=-7 时曲线穿过与多边形不交的直线
:kind: counterexample
:data: β = -7; P = (0,0) (0,0) (1,1) (2,0) (2,0) (2,0) (2,0) (2,0); Q = (0,-1/200); u = (0,1)
:instead: β = -21/4
:result: crossings of the curve = 2; crossings of the polygon = 0
:given: the left end of the printed range, the three corners of a triangle with the first and the last repeated, and the line through $Q$ with the
  normal vector $u$, a little below its side; corrected functions
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

/*
:::{statement} deng-zhang-2022:property-3.6-SA
:title: Roots in (0,1) and changes of sign
:zh: 根的个数与变号数，式 (13)、(14)、(16)、(17)
:printed: $f=\sum k_i\hat B_i$ for the functions (13) and constants (14); $Z(f)$ is the number of roots of $f$ in $(0,1)$,
  $SA(k_0,\dots,k_7)$ the number of changes of sign
:definition: yes
:checked-by: combination_begins_and_ends_with_its_coefficients

Roots may be counted with or without multiplicity: what is decided below holds for both, and the counterexamples have simple
roots.
:::
*/

#if FIELD || RATIONAL
/*
:::{claim} combination_begins_and_ends_with_its_coefficients
:title: A combination of the functions has its first and its last coefficient as values at the ends
:zh: 组合函数的端点值为首末系数
:given: any $k_0,\dots,k_7$ and $\beta$; printed and corrected functions
:then: $f(0)=k_0$, $f(1)=k_7$; so when these have different signs, the number of roots in $(0,1)$, counted with multiplicity, is odd, and
  of a polynomial of degree 8 at most 7
:method: The kernels at the two integers, everything a variable.  A polynomial changes its sign exactly at the roots of odd multiplicity.
:types: field rational
:control: the last two coefficients exchanged
:::
*/
CLAIM(combination_begins_and_ends_with_its_coefficients)
{
    num k[8], B[8], beta = unknown(T, "beta", 0);
    for (int i = 0; i <= 7; i++)
        k[i] = unknown(T, "k", i);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++)
        for (int end = 0; end <= 1; end++) {
            num sum = from_int(0);
            G(functions_of)(printed_ones, 7, beta, from_int(end), B);
            for (int i = 0; i <= 7; i++)
                sum = add(sum, mul(k[fault(T, i, i >= 6 ? 13 - i : i)], B[i]));
            same(T, sum, k[end ? 7 : 0]);
        }
}
#endif

#if RATIONAL
/*
:::{claim} parity_of_the_roots
:title: The number of roots is even or odd as the ends have equal or different signs
:zh: 根的个数的奇偶性
:given: random $k$ with $k_0>0$ and alternating signs, any $\beta$; corrected functions
:then: $f(0)=k_0$, $f(1)=k_7$, the number of roots of $f$ in $(0,1)$, each counted as often as its multiplicity, is odd and at
  most 7
:method: The roots of the exact polynomial are counted.  In general: $f$ changes its sign at a root exactly when the multiplicity
  is odd.
:types: rational
:control: the last sign is changed
:::
*/
CLAIM(parity_of_the_roots)
{
    num k[8], beta = unknown(T, "beta", 0), size;
    for (int i = 0; i <= 7; i++) {
        size = positive(T, "k", i);
        k[i] = fault(T, i % 2 == 0, i % 2 == 0 || i == 7) ? size : neg(size);
    }
    poly f = G(combination)(0, 7, mul(from_int(7), beta), k);
    struct cagd_root_count roots = count_roots(f, from_int(0), from_int(1), OPEN);
    same(T, poly_value(f, from_int(0)), k[0]);
    same(T, poly_value(f, from_int(1)), k[7]);
    agree(T, roots.counted % 2 == 1 && roots.counted <= 7);
}

/*
:::{statement} deng-zhang-2022:eq-15
:title: The rule of Descartes for the eight functions
:zh: 笛卡尔符号法则，式 (15)
:printed: Z_{(0,1)}\Bigl(\sum k_i\hat B_i\Bigr)\le SA(k_0,\dots,k_7)
:refuted-by: positive_coefficients_with_two_roots a_combination_vanishes
:class: false
:corrected: for printed and for corrected functions: true exactly for $-\frac{21}4<\beta\le1$ and $k\ne0$; at
  $\beta=-\frac{21}4$ true unless $f$ is the zero function, which it is for some $k\ne0$
:corrected-by: totally_positive_exactly_in_the_range minors_are_products_of_entries
  averages_between_neighbours_keep_sign_changes roots_are_at_most_sign_changes
  functions_are_independent_but_for_two_values third_function_has_a_zero_for_every_smaller_beta
  first_function_has_a_zero_for_every_larger_beta
:figure: crossings_off_the_polygon

The sum of the functions plays no part here, so that the misprints do no harm.
:::
*/

/* f = sum k_i B_i, printed functions, for β and k from the data of the claim. */
static poly G(given_combination)(trial *T, num k[])
{
    num beta = given(T, "β");
    given_points(T, "k", 8, 1, k);
    return G(combination)(1, 7, beta, k);
}

/* Whether f has no more roots in (0,1) than k has changes of sign, SA; both numbers are results. */
static int G(no_more_roots_than_changes)(trial *T, poly f, const num k[])
{
    struct cagd_root_count roots = count_roots(f, from_int(0), from_int(1), OPEN);
    int changes = G(sign_changes)(7, k);
    found_whole(T, "roots in (0,1)", roots.distinct);
    found_whole(T, "SA", changes);
    return roots.counted <= changes;
}

/*
:::{claim} positive_coefficients_with_two_roots
:title: At beta = -7 positive coefficients give two roots
:zh: β=-7 时正系数组合有两个根
:kind: counterexample
:data: β = -7; k = 1 1 200 1 1 1 1 1
:instead: β = -21/4
:result: roots in (0,1) = 2; SA = 0
:given: the left end of the printed range, and positive coefficients $k$, of which $k_2$ is large; printed functions
:then: there is no change of sign in $k$, and $f=\sum k_i\hat B_i$ has roots in $(0,1)$
:method: The roots of the exact polynomial are counted.
:control: the left end of the true range
:::
*/
CLAIM(positive_coefficients_with_two_roots)
{
    num k[8];
    poly f = G(given_combination)(T, k);
    int no_more = G(no_more_roots_than_changes)(T, f, k);
    about(T, "no more roots than changes of sign");
    agree(T, no_more);
}

/*
:::{statement} deng-zhang-2022:property-3.6-wlog
:title: Without loss of generality the first coefficient is positive
:zh: 不妨设 k_0>0
:printed: without loss of generality $k_0>0$; then $SA$ is one of $7,6,5,4,3,2,1,0$
:refuted-by: no_sign_makes_the_first_coefficient_positive
:class: invalid-proof
:corrected: for $k\ne0$ the first $k_i$ that is not 0 may be taken positive; for $-\frac{21}4<\beta\le1$ the sum has the sign of this $k_i$ for small
  $t>0$, and in the same way that of the last one near $t=1$
:corrected-by: first_coefficient_gives_the_sign
:figure: zero_at_the_beginning

The signs of $f(0)=k_0$ and $f(1)=k_7$, on which the proof rests, say nothing when one of them is 0.  With $SA=7$ all eight are
different from 0; in the other cases they need not be.
:::

:::{claim} no_sign_makes_the_first_coefficient_positive
:title: When the first coefficient is 0 neither k nor -k begins with a positive number
:zh: k_0=0 时不能假设 k_0>0
:kind: counterexample
:data: k = 0 -1 1 1 1 1 1 1
:instead: k = -1 -1 1 1 1 1 1 1
:result: SA = 1
:given: coefficients $k$ that begin with 0
:then: the first coefficients of $k$ and of $-k$ are 0, although the sign changes
:method: The two signs; that one of them is positive is refuted.
:control: a negative first coefficient
:::
*/
CLAIM(no_sign_makes_the_first_coefficient_positive)
{
    num k[8];
    given_points(T, "k", 8, 1, k);
    found_whole(T, "SA", G(sign_changes)(7, k));
    about(T, "k_0 > 0 or -k_0 > 0");
    refute(T, sign_q(k[0]) <= 0 && sign_q(neg(k[0])) <= 0);
}

/*
:::{claim} first_coefficient_gives_the_sign
:title: Near the beginning the sum has the sign of its first coefficient that is not 0
:zh: t→0+ 时组合函数的符号由首个非零系数决定
:kind: decision
:given: $-\frac{21}4<\beta\le1$, printed and corrected functions
:then: $\nu_0,\dots,\nu_6>0$, $\nu_7\ge0$ and $\varphi_7>0$; so $f=t^i(k_i\nu_i+\dots)$ has the sign of the first $k_i\ne0$ for small $t>0$, for
  $i=7$ everywhere in $(0,1)$; likewise $\varphi_1,\dots,\varphi_7>0$, $\varphi_0\ge0$ and $\nu_0>0$ for the other end
:method: The signs of linear polynomials in $\beta$ on the interval.
:scope: beta from -21/4, which is left out, to 1
:control: the interval with its left end
:::
*/
CLAIM(first_coefficient_gives_the_sign)
{
    enum cagd_ends ends = fault(T, OPEN_LEFT, CLOSED);
    num low = from_ratio(-21, 4), high = from_int(1);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        poly near[8], far[8];
        G(factors_in_beta)(printed_ones, 7, near, far);
        for (int i = 0; i <= 6; i++)
            agree(T, sign_on(near[i], low, high, ends) == SIGN_POSITIVE &&
                         sign_on(far[7 - i], low, high, ends) == SIGN_POSITIVE);
        agree(T, G(never_negative)(near[7], low, high) && G(never_negative)(far[0], low, high));
    }
}

/*
:::{statement} deng-zhang-2022:property-3.6-case-1
:title: Seven changes of sign: at most seven roots
:zh: 情形 1
:printed: for $k_0>0$ and $SA=7$: $k_7<0$, so that eight roots are impossible
:holds-by: combination_begins_and_ends_with_its_coefficients
:figure: roots_at_minus_seven

Right for every $\beta$: a polynomial of degree 8 has at most eight roots, and their number, counted with multiplicity, is odd
when $f(0)=k_0$ and $f(1)=k_7$ have different signs.  The lemma that is cited for $k_7<0$ is not in the text, and not needed: seven
changes among eight signs leave no other sign for $k_7$.
:::

:::{statement} deng-zhang-2022:property-3.6-case-2
:title: The cases of six to one changes of sign by the same method
:zh: 情形 2
:printed: for $SA=6,5,4,3,2,1$ it is proved by the same method
:refuted-by: one_change_of_sign_and_three_roots one_change_of_sign_and_two_roots
:class: invalid-proof
:corrected: the method, the signs at the ends, excludes $SA+1$ roots counted with multiplicity when $k_7\ne0$, not $SA+2$; when $k_7=0$
  it excludes nothing; for $-\frac{21}4<\beta\le1$ the conclusion is true by total positivity
:corrected-by: totally_positive_exactly_in_the_range averages_between_neighbours_keep_sign_changes
  roots_are_at_most_sign_changes
:figure: roots_at_minus_seven

The method makes no use of the range of $\beta$, and in the range of the text the conclusion is false.
:::

:::{claim} one_change_of_sign_and_three_roots
:title: At beta = -7 one change of sign gives three roots
:zh: β=-7 时一次变号而有三个根
:kind: counterexample
:data: β = -7; k = 1 1 200 1 1 1 1 -1
:instead: β = -21/4
:result: roots in (0,1) = 3; SA = 1
:given: the left end of the printed range, and coefficients $k$ with $k_0>0>k_7$; printed functions
:then: $f=\sum k_i\hat B_i$ has more roots in $(0,1)$ than $k$ has changes of sign, by two; the signs at the ends allow this
:method: The roots of the exact polynomial are counted.
:control: the left end of the true range
:::
*/
CLAIM(one_change_of_sign_and_three_roots)
{
    num k[8];
    poly f = G(given_combination)(T, k);
    int no_more = G(no_more_roots_than_changes)(T, f, k);
    about(T, "no more roots than changes of sign");
    agree(T, no_more);
}

/*
:::{claim} one_change_of_sign_and_two_roots
:title: At beta = -7 one change of sign gives two roots when the last coefficient is 0
:zh: β=-7、k_7=0 时一次变号而有两个根
:kind: counterexample
:data: β = -7; k = 1 1 1 1 1 -10 -1 0
:instead: β = -21/4
:result: roots in (0,1) = 2; SA = 1; f(t)/(t-1)² = "630*t^6 - 638*t^5 + 33*t^4 + 4*t^3 + 3*t^2 + 2*t + 1"
:given: the left end of the printed range, and coefficients $k$ with $k_0>0$ and $k_7=0$; printed functions
:then: $f=\sum k_i\hat B_i$ has a double root at 1 and, in $(0,1)$, more roots than $k$ has changes of sign; $f(1)=0$ says nothing
:method: The roots of the exact polynomial are counted, and it is divided by $(t-1)^2$.
:control: the left end of the true range
:::
*/
CLAIM(one_change_of_sign_and_two_roots)
{
    num k[8], one = from_int(1);
    poly f = G(given_combination)(T, k), double_root = poly_from_q(3, (num[]){one, from_int(-2), one});
    int no_more = G(no_more_roots_than_changes)(T, f, k);
    int divides = poly_divides(double_root, f);
    found_text(T, "f(t)/(t-1)²", divides ? poly_to_string(poly_quotient(f, double_root), "t") : "no polynomial");
    about(T, "no more roots than changes of sign");
    agree(T, no_more);
}
#endif

/*
:::{statement} deng-zhang-2022:property-3.6-case-0
:title: No change of sign: obviously no root
:zh: 情形 SA=0
:printed: for $SA=0$ the inequality is obvious
:refuted-by: positive_coefficients_with_two_roots
:class: false
:corrected: obvious where the functions are positive in $(0,1)$, which is for $-\frac{21}4\le\beta\le1$
:corrected-by: nonnegative_exactly_in_the_range
:figure: roots_at_minus_seven
:::

:::{statement} deng-zhang-2022:property-3.6-line
:title: The line through a point with a normal vector
:zh: 过点 Q、法向量为 u 的直线
:printed: let $L$ be the line (or plane) through the point $Q$ with the normal vector $u$
:holds-by: points_of_a_line_by_its_normal
:hypothesis: no_normal_no_line | $u\ne0$
:figure: line_along_an_edge

In the plane; in space $u\cdot(X-Q)=0$ is in the same way a plane.
:::

:::{claim} points_of_a_line_by_its_normal
:title: The points with u.(X-Q) = 0 are a line
:zh: 由法向量确定的直线
:given: any points $X$, $Q$ and vector $u$ of the plane, $w=X-Q$, $u^\perp=(-u_2,u_1)$
:then: $(u\cdot u)w=(u\cdot w)u+(u^\perp\cdot w)u^\perp$
:method: Everything is a variable.  So for $u\ne0$ the points with $u\cdot w=0$ are the points $Q+\lambda u^\perp$, and all of these are such.
:control: $u^\perp=(u_2,u_1)$
:::
*/
CLAIM(points_of_a_line_by_its_normal)
{
    num w[dim], u[dim] = {unknown(T, "u", 0), unknown(T, "u", 1)};
    for (int c = 0; c < dim; c++)
        w[c] = sub(unknown(T, "x", c), unknown(T, "q", c));
    num across[dim] = {fault(T, neg(u[1]), u[1]), u[0]};
    for (int c = 0; c < dim; c++)
        same(T, mul(G(dot)(dim, u, u), w[c]),
             add(mul(G(dot)(dim, u, w), u[c]), mul(G(dot)(dim, across, w), across[c])));
}

#if RATIONAL
/*
:::{claim} no_normal_no_line
:title: With the normal vector 0 every point is on L
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
:printed: if $L$ meets the edge between $P_j$ and $P_{j+1}$ then these two points are on different sides of $L$, and
  $u\cdot(P_j-Q)$, $u\cdot(P_{j+1}-Q)$ have different signs
:holds-by: sign_changes_are_polygon_crossings
:hypothesis: line_through_an_edge_has_no_two_sides | neither of the two points is on $L$
:figure: line_along_an_edge
:::

:::{claim} line_through_an_edge_has_no_two_sides
:title: A line that contains an edge meets it and has neither end on a side
:zh: 边在直线上时两端不在两侧
:kind: counterexample
:data: P = (0,0) (1,6) (2,10) (3,12) (4,12) (5,10) (6,6) (7,0); j = 3; Q = (7/2,12); u = (0,1)
:instead: u = (1,0)
:result: u·(P_j-Q) = 0; u·(P_{j+1}-Q) = 0
:given: a polygon, one of its edges, and the line through a point $Q$ of this edge whose normal vector $u$ is orthogonal to it
:then: the line meets the edge in all its points, and the two numbers $u\cdot(P_j-Q)$, $u\cdot(P_{j+1}-Q)$ are 0
:method: The signs at the two ends are computed; different signs are asked for.
:control: the line through $Q$ across the edge
:::
*/
CLAIM(line_through_an_edge_has_no_two_sides)
{
    num P[8 * dim], u[dim], Q[dim], side[8];
    given_points(T, "P", 8, dim, P);
    int j = given_whole(T, "j");
    given_points(T, "Q", 1, dim, Q);
    given_points(T, "u", 1, dim, u);
    G(sides)(7, P, Q, u, side);
    found(T, "u·(P_j-Q)", side[j]);
    found(T, "u·(P_{j+1}-Q)", side[j + 1]);
    about(T, "the two numbers have different signs");
    agree(T, sign_q(side[j]) * sign_q(side[j + 1]) < 0);
}

/*
:::{statement} deng-zhang-2022:eq-19
:title: The changes of sign are at most the intersections of the polygon
:zh: 式 (19)
:printed: $SA\{u\cdot(P_0-Q),\dots,u\cdot(P_7-Q)\}$ is at most the number of intersections of $L$ with the polygon
:holds-by: sign_changes_are_polygon_crossings
:hypothesis: polygon_that_crosses_itself_on_the_line | intersections are counted along the polygon; as points of the plane they
  may be fewer
:figure: polygon_crossing_itself
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
    about(T, "no more changes of sign than points");
    agree(T, m.crossings <= m.components);
}

/*
:::{statement} deng-zhang-2022:eq-20
:title: The intersections of the curve with a line are roots
:zh: 式 (20)
:printed: the number of intersections of $B_1(t)$ with $L$ is $Z_{(0,1)}\bigl(\sum\hat B_j(t)(P_j-Q)\cdot u\bigr)$
:refuted-by: printed_curve_crosses_a_line_off_its_polygon curve_and_line_share_an_end
:class: misprint
:corrected: for the corrected functions the function is $(q(t)-Q)\cdot u$ and its roots in $(0,1)$ are the parameters of the
  common points other than the ends; for the printed functions it is so only for $\beta=0$ or $Q\cdot u=0$
:corrected-by: line_function_of_the_curve
:figure: crossings_off_the_polygon

The step uses the sum 1.  It also leaves out $t=0$ and $t=1$, where $P_0$ or $P_7$ may be on $L$.
:::

:::{statement} deng-zhang-2022:eq-21
:title: The intersections of the curve are at most the changes of sign
:zh: 式 (21)
:printed: the number of intersections of $B_1(t)$ with $L$ is at most $SA\{u\cdot(P_0-Q),\dots,u\cdot(P_7-Q)\}$
:refuted-by: printed_curve_crosses_a_line_off_its_polygon curve_and_line_share_an_end
  curve_on_a_line_that_its_polygon_crosses
:class: false
:corrected: true for the corrected functions and $-\frac{21}4\le\beta\le1$ for the common points with $0<t<1$, when the curve is not on
  $L$
:corrected-by: totally_positive_exactly_in_the_range averages_between_neighbours_keep_sign_changes
  roots_are_at_most_sign_changes line_function_of_the_curve
:figure: crossings_off_the_polygon
:::

:::{claim} curve_and_line_share_an_end
:title: A line through an end meets the curve without a root in (0,1)
:zh: 过端点的直线
:kind: counterexample
:data: β = 0; P = (0,0) (1,1) (2,2) (3,3) (4,4) (5,5) (6,6) (7,7); Q = (0,0); u = (0,1)
:instead: Q = (0,7/2)
:result: common points of the curve = 1; roots in (0,1) = 0; SA = 0
:given: the $\beta$ of the Bézier curve, points on a line, and the line through $Q=P_0$ with the normal vector $u$
:then: curve and line have the point $P_0$ in common; the function of formula (20) has no root in $(0,1)$, and its coefficients no change of sign
:method: The common points of the closed curve are compared with those of the open one.
:control: a line through the middle of the polygon
:::
*/
CLAIM(curve_and_line_share_an_end)
{
    struct G(meeting) m = G(given_meeting)(T, 0);
    found_whole(T, "common points of the curve", m.curve.common_closed);
    found_whole(T, "roots in (0,1)", m.curve.common_open);
    found_whole(T, "SA", m.polygon.crossings);
    about(T, "as many common points as roots in (0,1), and no more than changes of sign");
    agree(T, m.curve.common_closed == m.curve.common_open && m.curve.common_closed <= m.polygon.crossings);
}
#endif

/*
:::{claim} line_function_of_the_curve
:title: With the sum 1 the function of the proof is the distance of the curve from the line
:zh: 曲线与直线的函数
:given: points $P_i$ and $Q$ of the plane, any $u$, $\beta$ and $t$
:then: $\sum B_{j,n}(t)(P_j-Q)\cdot u=(q(t)-Q)\cdot u$; for the printed functions the difference of the two sides is
  $4\beta(1-t)^3t^4\,Q\cdot u$
:method: Everything is a variable.
:degrees: 2..7 sampled 12
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
        if (printed_ones)
            G(shape_point_printed)(dim, P, beta, t, at);
        else
            G(shape_point)(n, dim, P, beta, t, at);
        for (int j = 0; j <= n; j++) {
            num w[dim] = {sub(P[j * dim], Q[0]), sub(P[j * dim + 1], Q[1])};
            sum = add(sum, mul(B[j], fault(T, G(dot)(dim, w, u), j == 0 ? G(dot)(dim, P, u) : G(dot)(dim, w, u))));
        }
        num gap[dim] = {sub(at[0], Q[0]), sub(at[1], Q[1])}, value = G(dot)(dim, gap, u);
        if (printed_ones)
            value = add(value, mul(mul(from_int(4), mul(beta, G(product_of_powers)(3, 4, t))), G(dot)(dim, Q, u)));
        same(T, sum, value);
    }
}

/*
:::{statement} deng-zhang-2022:property-3.7
:title: Convex polygons have convex curves
:zh: 保凸性
:printed: when the control polygon is convex, a line of the plane meets the curve at most twice, $-7\le\beta\le1$
:refuted-by: printed_curve_of_a_convex_polygon_meets_a_line_four_times
  curve_of_a_triangle_meets_a_line_three_times
:class: false
:corrected: true for the corrected functions and $-\frac{21}4\le\beta\le1$, if the polygon is convex when closed and not on a line, and
  common points are counted as points of the plane; false for every $\beta$ with $-7\le\beta<-\frac{21}4$
:corrected-by: totally_positive_exactly_in_the_range averages_between_neighbours_keep_sign_changes
  roots_are_at_most_sign_changes four_vertices_of_a_convex_polygon_do_not_alternate third_function_has_a_zero_for_every_smaller_beta
:reading: closed_polygon_has_three_parameters_on_a_line | common points counted by their parameters, $P_0=P_7$: three are possible,
  at $\beta=-\frac{21}4,0,1$
:figure: convexity_lost

A line has at most two changes of sign along a convex polygon; with $P_0$ on the line at most one, with $P_0\ne P_7$ both on it
none; so together with the ends there are never more than two common points.  With $P_0=P_7$ on the line one change is possible, and
$t=0$, $t=1$ are one point of the curve.  That the whole curve is on a line, at $\beta=-\frac{21}4$, needs three changes.
:::

:::{statement} deng-zhang-2022:property-3.7-reason
:title: A line meets a convex polygon at most twice
:zh: 直线与凸控制多边形的交点
:printed: a line meets the (convex) control polygon at most twice
:holds-by: four_vertices_of_a_convex_polygon_do_not_alternate sign_changes_are_polygon_crossings
:hypothesis: line_through_an_edge_has_no_two_sides | the line contains no edge; crossings are at most two in any case
:figure: line_along_an_edge
:::
*/

#if RATIONAL
/*
:::{claim} closed_polygon_has_three_parameters_on_a_line
:title: The curve of a closed convex polygon may have three parameters on a line
:zh: 首末点重合的凸多边形:曲线在一直线上有三个参数
:kind: counterexample
:data: β = -21/4 0 1; P = (0,0) (2,-1) (4,0) (5,2) (4,4) (2,5) (0,3) (0,0); Q = (0,0); u = (1,-1)
:instead: Q = (0,1/2)
:result: parameters on the line = 3 3 3; those in (0,1) = 1 1 1
:given: three values of $\beta$, a convex heptagon with $P_7=P_0$, and the line through $Q=P_0$ with the normal vector $u$; corrected
  functions
:then: for each $\beta$ the parameters $t=0$, $t=1$ and one in $(0,1)$ are on the line: three parameters, two points
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
:::{claim} curve_of_a_triangle_meets_a_line_three_times
:title: At beta = -7 the curve of a triangle meets a line three times
:zh: β=-7 时凸多边形的曲线与直线有三个交点
:kind: counterexample
:data: β = -7; P = (0,0) (0,0) (1,1) (2,0) (2,0) (2,0) (2,0) (2,0); Q = (0,0); u = (0,1); t = 0 1/9 1
:instead: β = -21/4
:result: common points of the curve = 3; y(t) = 0 0 0
:given: the left end of the printed range, the three corners of a triangle with the first and the last repeated, the line through $Q$ with the
  normal vector $u$, on which one side is, and three parameters; corrected functions
:then: the polygon is convex, and the curve meets the line at the three parameters and nowhere else
:method: The common points are counted exactly; `hull.h` decides that the polygon is convex.
:control: the left end of the true range
:::
*/
CLAIM(curve_of_a_triangle_meets_a_line_three_times)
{
    struct G(meeting) m = G(given_meeting)(T, 0);
    num t[3], y[3];
    given_points(T, "t", 3, 1, t);
    found_whole(T, "common points of the curve", m.curve.common_closed);
    for (int k = 0; k < 3; k++) {
        num at[dim];
        G(curve_point)(0, 7, dim, m.P, m.beta, t[k], at);
        y[k] = at[1];
    }
    found_points(T, "y(t)", 3, 1, y);
    about(T, "the polygon is not convex, or there are at most two common points");
    refute(T, polygon_is_convex(7, m.P, 1, NULL) && m.curve.common_closed > 2);
}

/*
:::{claim} printed_curve_of_a_convex_polygon_meets_a_line_four_times
:title: The printed curve of a convex polygon meets a line four times
:zh: 按式 (1) 凸多边形的曲线与直线有四个交点
:kind: counterexample
:data: β = 1; P = (0,100) (1,101) (2,101) (3,101) (4,101) (5,101) (6,101) (7,100); Q = (0,401/4); u = (0,1)
:result: common points of the curve = 4; crossings of the curve = 4; crossings of the polygon = 2
:given: the right end of the range of $\beta$, a flat convex polygon, and the line through $Q$ with the normal vector $u$, a little above its ends
:then: the polygon is convex, and the curve crosses the line twice as often as the polygon
:method: As before.
:control: the corrected functions
:::
*/
CLAIM(printed_curve_of_a_convex_polygon_meets_a_line_four_times)
{
    struct G(meeting) m = G(given_meeting)(T, fault(T, 0, 1));
    found_whole(T, "common points of the curve", m.curve.common_closed);
    found_whole(T, "crossings of the curve", m.curve.crossings);
    found_whole(T, "crossings of the polygon", m.polygon.crossings);
    about(T, "the polygon is not convex, or there are at most two common points");
    refute(T, polygon_is_convex(7, m.P, 0, NULL) && m.curve.common_closed > 2);
}
#endif

/*
:::{claim} four_vertices_of_a_convex_polygon_do_not_alternate
:title: Four vertices of a convex polygon are not on alternate sides of a line
:zh: 凸多边形的四个顶点不会交替位于直线两侧
:given: any $P_i,P_j,P_k,P_l$ of the plane, any line function $f(x,y)=ax+by+c$; $D_{ijk}$ the determinant of $P_j-P_i$ and $P_k-P_i$
:then: $D_{jkl}f(P_i)+D_{ijl}f(P_k)=D_{ikl}f(P_j)+D_{ijk}f(P_l)$
:method: An identity in the coordinates.  For $i<j<k<l$ in a polygon that is convex, counterclockwise, the four determinants are not
  negative.  With $f(P_i),f(P_k)\ge0\ge f(P_j),f(P_l)$ both sides are 0: every product is.  So when the signs are strict the four points
  are on one line, to and fro, and the polygon is not convex; hence there are no three changes of sign.  With $f(P_i)=0$ two changes
  among the other three, and with $f(P_i)=f(P_l)=0$, $P_i\ne P_l$, one, are excluded in the same way; with $P_i=P_l$ one is possible.
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
    num left = add(mul(G(turn)(j, k, l), f[0]), mul(fault(T, ijl, ikl), f[2]));
    same(T, left, add(mul(fault(T, ikl, ijl), f[1]), mul(G(turn)(i, j, k), f[3])));
}

#include "chapters/judge/claims_off.h"
