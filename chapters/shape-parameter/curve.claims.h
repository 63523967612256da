/*
# The curve (曲线)

The curve is $q_\beta(t)=\sum P_iB_{i,n}(t)$.  In the Bernstein basis of degree $n+1$ it has the points

$$Q_k=\frac{\varphi_{k-1}P_{k-1}+\nu_kP_k}{\binom{n+1}k},\qquad k=0,\dots,n+1,$$

and with the corrected functions $\varphi_{k-1}+\nu_k=\binom{n+1}k$: every inner $Q_k$ is on the line of an edge of the
polygon, and $\beta$ moves it along that line, but for a middle one, which stays.  For $\beta=0$ this is degree
elevation (升阶).  With the printed functions $Q_4$ and $Q_5$ leave their lines, and the curve depends on the place of the origin.
*/
#include "exact/record/hull.h"

#include "chapters/shape-parameter/definition.h"
#include "chapters/shape-parameter/distance.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} deng-zhang-2022:def-3.1
:title: The curve of eight points
:zh: 八次 β-Bezier 曲线，式 (10)
:printed: $B_1=\sum_{i=0}^7P_iB_{i,7}(t)$ for eight control points $P_i\in\mathbb R^d$, $d=2,3$, $t\in[0,1]$
:definition: yes
:checked-by: printed_curve_kernel_is_the_sum curve_kernels_give_the_sum
:meant: formula (11) | The left side is $B_1(t)$.
:figure: curves_for_several_beta

A coordinate of the curve comes from that coordinate of the points alone,
so that what the claims compute for points of the plane, coordinate by coordinate, is true in every $\mathbb R^d$.
:::
*/

static num G(any_beta)(trial *T) { return unknown(T, "beta", 0); }

/*
:::{claim} printed_curve_kernel_is_the_sum
:title: The kernel computes the curve with the printed functions
:zh: 核函数即式 (10)
:given: points $P_0,\dots,P_7$ of the plane, any $\beta$ and $t$
:then: `shape_point_printed` gives $\sum P_i\hat B_i(t)$
:method: The eight formulas written out one by one, everything a variable.
:degrees: 7..7
:defines: shape_point_printed
:control: the polygon taken backwards
:::
*/
CLAIM(printed_curve_kernel_is_the_sum)
{
    num P[8 * dim], at[dim], beta = G(any_beta)(T), t = parameter(T, "t"), R[8 * dim];
    G(free_points)(T, 7, dim, P);
    G(reversed_points)(7, dim, P, R);
    G(shape_point_printed)(dim, fault(T, P, R), beta, t, at);
    for (int c = 0; c < dim; c++)
        same(T, at[c], G(printed_curve)(dim, P, c, beta, t));
}

/*
:::{claim} curve_kernels_give_the_sum
:title: The kernel computes the curve with the corrected functions
:zh: 核函数即修正后的曲线
:given: points $P_0,\dots,P_n$ of the plane, any $\beta$ and $t$
:then: `shape_point` gives $\sum P_iB_{i,n}(t)$
:method: The formula of the functions, everything a variable.
:degrees: 2..7 sampled 14
:defines: shape_point
:control: $-\beta$ in the place of $\beta$
:::
*/
CLAIM(curve_kernels_give_the_sum)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], at[dim], beta = G(any_beta)(T), t = parameter(T, "t");
    G(free_points)(T, n, dim, P);
    G(shape_point)(n, dim, P, fault(T, beta, neg(beta)), t, at);
    for (int c = 0; c < dim; c++)
        same(T, at[c], G(corrected_curve)(n, dim, P, c, beta, t));
}

/*
:::{statement} deng-zhang-2022:sec-3-degree
:title: It is called a curve of degree eight
:zh: 八次曲线之称
:printed: the curve of (10) is called the Bézier curve of degree eight with the shape parameter $\beta$, in short the β-Bézier curve of degree eight
:definition: yes
:checked-by: horner_rule_computes_the_curve
:confirmed-by: bezier_points_divide_the_edges beta_zero_gives_the_bezier_curve
:figure: curves_for_several_beta
:degree: 7

The name is true in this sense: with the printed functions and with the corrected ones (`sec-2-properties`) the curve of $n+1=8$ points is a Bézier curve
of $n+2=9$ points; computed coordinate by coordinate for points of the plane, and so in every dimension.  As a polynomial it has at most degree 8, for
$\beta=0$ at most 7; when the functions themselves have degree 8 is said in `def-2.1-degree`.
:::

:::{claim} bezier_points_divide_the_edges
:title: The inner Bézier points of the curve are on the lines of the edges of the polygon
:zh: 曲线的内 Bézier 点在控制多边形各边所在的直线上
:given: points $P_0,\dots,P_n$ of the plane, any $\beta$ and $t$
:then: the curve of degree $n+1$ of the points of `shape_bezier_points` is $\sum P_iB_{i,n}(t)$; they are the rows of
  `shape_matrix` applied to the $P_i$; and
    $Q_k-P_{k-1}=\bigl(\frac{n+1-k}{n+1}+\beta\frac{a_k}{\binom{n+1}k}\bigr)(P_k-P_{k-1})$ for $1\le k\le n$, where $a_k=0$ exactly for $k=\frac{n+1}2$
:method: The points as coefficients of Bernstein polynomials of degree $n+1$ against the formula of the functions,
  everything a variable.
:degrees: 2..7 sampled 14
:defines: shape_bezier_points shape_matrix
:control: $-\beta$ in the place of $\beta$
:::
*/
CLAIM(bezier_points_divide_the_edges)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], Q[(MAX_DEGREE + 1) * dim], R[(MAX_DEGREE + 1) * dim];
    num beta = G(any_beta)(T), t = parameter(T, "t");
    G(free_points)(T, n, dim, P);
    G(shape_bezier_points)(n, dim, P, fault(T, beta, neg(beta)), Q);
    G(bezier_points_of)(0, n, dim, P, beta, R);
    for (int c = 0; c < dim; c++) {
        num sum = from_int(0);
        for (int k = 0; k <= n + 1; k++)
            sum = add(sum, mul(Q[k * dim + c], mul(G(choose)(n + 1, k), G(product_of_powers)(n + 1 - k, k, t))));
        about(T, "the curve");
        same(T, sum, G(corrected_curve)(n, dim, P, c, beta, t));
        for (int k = 0; k <= n + 1; k++) {
            about(T, "the rows of the matrix");
            same(T, Q[k * dim + c], R[k * dim + c]);
            if (k == 0 || k > n)
                continue;
            about(T, "the middle point stays, the others do not");
            if (2 * k == n + 1)
                vanishes(T, G(shift)(n, k));
            else
                G(must_be_positive)(T, mul(G(shift)(n, k), from_int(n + 1 - 2 * k)));
            about(T, "the ratio on the edge");
            /* Q_k - P_{k-1} = ((n+1-k)/(n+1) + β a_k/C(n+1,k)) (P_k - P_{k-1}) */
            num ratio = add(from_ratio(n + 1 - k, n + 1), mul(beta, div(G(shift)(n, k), G(choose)(n + 1, k))));
            num edge = sub(P[k * dim + c], P[(k - 1) * dim + c]);
            same(T, sub(Q[k * dim + c], P[(k - 1) * dim + c]), mul(ratio, edge));
        }
    }
}

/*
:::{statement} deng-zhang-2022:sec-3-beta-0
:title: For beta = 0 the curve is the Bézier curve of degree seven
:zh: β=0 时退化为七次 Bezier 曲线
:printed: for $\beta=0$ the curve degenerates to the Bézier curve of degree seven
:holds-by: beta_zero_gives_the_bezier_curve
:figure: curves_for_several_beta
:degree: 7
:::

:::{claim} beta_zero_gives_the_bezier_curve
:title: For beta = 0 the curve is the Bézier curve
:zh: β=0 时为 Bézier 曲线
:given: points of the plane, any $t$
:then: $\sum P_iB_{i,n}(t)$ for $\beta=0$ and, for $n=7$, $\sum P_i\hat B_i(t)$ are the point of de Casteljau's algorithm
:method: The kernel, and the eight printed formulas, against that algorithm, everything a variable; coordinate by coordinate, so that it is true in
  every dimension.
:degrees: 2..7 sampled 14
:control: $\beta=1$
:::
*/
CLAIM(beta_zero_gives_the_bezier_curve)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], at[dim], bezier[dim], beta = from_int(fault(T, 0, 1)), t = parameter(T, "t");
    G(free_points)(T, n, dim, P);
    G(bezier_casteljau)(n, dim, P, t, bezier);
    G(shape_point)(n, dim, P, beta, t, at);
    for (int c = 0; c < dim; c++)
        same(T, at[c], bezier[c]);
    if (n == 7) {
        G(curve_point)(1, 7, dim, P, beta, t, at);
        for (int c = 0; c < dim; c++)
            same(T, at[c], bezier[c]);
    }
}

/*
## How the curve moves with the parameter

In the functions $\beta$ occurs to the first power.  So for fixed $t$ the point of the curve is a linear function of
$\beta$: it runs on a straight line, with a velocity that depends on the polygon and on $t$ alone.  This velocity is a sum
of the edges $P_k-P_{k-1}$ with the factors $a_ks^{n+1-k}t^k$.  For $n=7$ the numbers $a_1,\dots,a_7$ are
$1,4,5,0,-5,-4,-1$: the first three edges push one way, the last three the other way, and the middle edge does not push at
all.  A polygon that has no other edge gives one curve for all $\beta$, and this is the exception to the adjustable shape.

:::{statement} deng-zhang-2022:fig-2
:title: The curves of several beta from right to left
:zh: 图 2
:printed: figure 2 shows, from right to left, the curves for $\beta=1,0,-1,-2,-3,-4,-5,-6,-7$
:degree: 7
:reading: that this order is from right to left: the polygon is not given, so that nothing is there to be decided
:reading: printed_points_move_evenly_with_beta | that the order is that of $\beta$, with the printed functions: for each $t$ the points of the nine curves stand on a straight
  line in this order, in equal distances, or are one point; which end is the right one is a matter of the polygon
:reading: points_move_evenly_with_beta | that the order is that of $\beta$, with the corrected functions (`sec-2-properties`): for each $t$ the points of the nine curves
  stand on a straight line in this order, in equal distances, or are one point
:figure: curves_for_several_beta
:::

:::{claim} points_move_evenly_with_beta
:title: The point of a parameter moves on a straight line, evenly with beta
:zh: 曲线上的点随 β 匀速直线移动
:given: points $P_0,\dots,P_n$ of the plane, any $\beta$, $h$ and $t$; the curves $q_\beta$ of the corrected functions; $s=1-t$, $a_k=\binom{n-2}{k-1}-\binom{n-2}{k-2}$
:then: $q_{\beta+h}(t)-q_\beta(t)=h\sum_{k=1}^na_k(P_k-P_{k-1})s^{n+1-k}t^k$
:method: The kernel at $\beta+h$ and $\beta$, everything a variable; coordinate by coordinate, so that it is true in every dimension.
:degrees: 2..7 sampled 12
:over: h: step of β
:control: the first edge left out
:::
*/
CLAIM(points_move_evenly_with_beta)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], before[dim], after[dim];
    num beta = G(any_beta)(T), h = unknown(T, "h", 0), t = parameter(T, "t");
    G(free_points)(T, n, dim, P);
    G(shape_point)(n, dim, P, beta, t, before);
    G(shape_point)(n, dim, P, add(beta, h), t, after);
    for (int c = 0; c < dim; c++) {
        num sum = from_int(0);
        for (int k = fault(T, 1, 2); k <= n; k++) {
            num edge = sub(P[k * dim + c], P[(k - 1) * dim + c]);
            sum = add(sum, mul(mul(G(shift)(n, k), edge), G(product_of_powers)(n + 1 - k, k, t)));
        }
        /* q_{β+h}(t) - q_β(t) = h Σ a_k (P_k - P_{k-1}) s^{n+1-k} t^k */
        same(T, sub(after[c], before[c]), mul(h, sum));
    }
}

/*
:::{claim} printed_points_move_evenly_with_beta
:title: With the printed functions, too, the point of a parameter moves on a straight line, evenly with beta
:zh: 按式 (1) 曲线上的点亦随 β 匀速直线移动
:given: eight points of the plane, any $\beta$, $h$ and $t$; the curves $\hat q_\beta$ of the printed functions
:then: $\hat q_{\beta+h}(t)-\hat q_\beta(t)=h\,(\hat q_1(t)-\hat q_0(t))$
:method: The printed functions at $\beta+h$, $\beta$, 1 and 0, everything a variable; coordinate by coordinate, so that it is true in every dimension.
:degrees: 7..7
:over: h: step of β
:control: $\hat q_2$ in the place of $\hat q_1$
:::
*/
CLAIM(printed_points_move_evenly_with_beta)
{
    num P[8 * dim], at[4][dim], h = unknown(T, "h", 0), t = parameter(T, "t"), first = G(any_beta)(T);
    num beta[4] = {add(first, h), first, from_int(fault(T, 1, 2)), from_int(0)};
    G(free_points)(T, 7, dim, P);
    for (int k = 0; k < 4; k++)
        G(curve_point)(1, 7, dim, P, beta[k], t, at[k]);
    for (int c = 0; c < dim; c++)
        same(T, sub(at[0][c], at[1][c]), mul(h, sub(at[2][c], at[3][c])));
}

/*
:::{statement} deng-zhang-2022:abstract-adjustable
:title: For a fixed polygon different beta give different curves
:zh: 形状可调性
:printed: with the vertices of the control polygon unchanged, different curves that approximate the polygon can be produced by adjusting the parameter
:holds-by: points_move_evenly_with_beta printed_points_move_evenly_with_beta polygons_that_do_not_move
:hypothesis: edges_that_do_not_move | the polygon is not $0,0,0,0,5v,v,v,v$ (printed functions) or $P,P,P,P,Q,Q,Q,Q$ (corrected
  ones): these polygons $P_0,\dots,P_7$, any $v$, $P$ and $Q$, have one curve for all $\beta$
:meant: definition 3.1, where the curve is a function of $t$ | Curves are different when they are different functions of $t$.
:figure: edges_that_do_not_move

As sets of points curves that are different functions may be one: with the corrected functions (`sec-2-properties`) and $-\frac{21}4\le\beta\le1$ the curve of
points of a segment from $P_0$ to $P_7$ is this segment, which is the hull.  They are different sets with the corrected functions where the first
coordinates of the points are $0,0,0,0,1,1,1,1$ and the polygon is not excepted: then the first coordinate of the curve is the same for all $\beta$, and
rises with $t$.  Other polygons are not asked for sets.  That the curves approximate the polygon is not decided here: how near they are is asked by property 3.5.
:::
*/

#if RATIONAL
/*
:::{claim} polygons_that_do_not_move
:title: The polygons that have the same curve for all beta
:zh: 与 β 无关的控制多边形
:kind: decision
:data: k, corrected functions = 1 1 1 1 0 0 0 0; k', corrected functions = 0 0 0 0 1 1 1 1;
  k, printed functions = 0 0 0 0 5 1 1 1
:result: rank, corrected functions = 6; rank, printed functions = 7
:given: all sequences of eight coefficients, and those that are named, printed and corrected functions
:then: $\sum k_iB_i$ is the same for all $\beta$ exactly for the combinations of $k$ and $k'$ with the corrected
  functions, that is for $k_0=\dots=k_3$, $k_4=\dots=k_7$, and for the multiples of $k$ with the printed ones
:method: The functions are linear in $\beta$.  The sequences named are in the kernel of the matrix of the Bernstein
  coefficients of their slopes, and its rank leaves room for no others.  Coordinate by coordinate this is a statement on
  polygons.
:degrees: 7..7
:scope: every real β, all polygons
:control: $k_4=k_3$ in the sequences named
:::
*/
CLAIM(polygons_that_do_not_move)
{
    static const char *const rank_of[] = {"rank, corrected functions", "rank, printed functions"};
    num still[3][8];
    given_points(T, "k, corrected functions", 8, 1, still[0]);
    given_points(T, "k', corrected functions", 8, 1, still[1]);
    given_points(T, "k, printed functions", 8, 1, still[2]);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        num E[9 * 8], D[9 * 8];
        G(matrix_in_beta)(printed_ones, E, D);
        for (int m = printed_ones ? 2 : 0; m <= (printed_ones ? 2 : 1); m++)
            for (int r = 0; r <= 8; r++) {
                num sum = from_int(0);
                for (int i = 0; i <= 7; i++)
                    sum = add(sum, mul(D[r * 8 + i], still[m][fault(T, i, i == 4 ? 3 : i)]));
                vanishes(T, sum);
            }
        int rank = G(rank)(9, 8, D);
        agree(T, rank == (printed_ones ? 8 - 1 : 8 - 2));
        found_whole(T, rank_of[printed_ones], rank);
    }
}

/*
:::{claim} edges_that_do_not_move
:title: Two polygons, one for each family of functions, with the same curve for two values of beta
:zh: 两个 β 值给出同一曲线的控制多边形
:kind: counterexample
:data: β = 0 1; P, corrected functions = (0,0) (0,0) (0,0) (0,0) (1,2) (1,2) (1,2) (1,2);
  P, printed functions = (0,0) (0,0) (0,0) (0,0) (5,10) (1,2) (1,2) (1,2)
:instead: P, corrected functions = (0,0) (0,0) (0,0) (0,0) (0,0) (1,2) (1,2) (1,2);
  P, printed functions = (0,0) (0,0) (0,0) (0,0) (0,0) (1,2) (1,2) (1,2)
:result: Q, corrected functions = (0,0) (0,0) (0,0) (0,0) (1/2,1) (1,2) (1,2) (1,2) (1,2);
  Q, printed functions = (0,0) (0,0) (0,0) (0,0) (5/2,5) (7/2,7) (1,2) (1,2) (1,2)
:given: two values of $\beta$ and a polygon for each family of functions
:then: the Bézier points $Q$, and so the curves, are the same for both values of $\beta$
:method: Both sets of nine points are computed and compared; that they differ somewhere is asked, of either family.
:control: $P_4$ moved to the four points before it
:::
*/
CLAIM(edges_that_do_not_move)
{
    static const char *const P_of[] = {"P, corrected functions", "P, printed functions"};
    static const char *const Q_of[] = {"Q, corrected functions", "Q, printed functions"};
    num beta[2], P[2][8 * dim];
    int differ = 0;
    given_points(T, "β", 2, 1, beta);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++)
        given_points(T, P_of[printed_ones], 8, dim, P[printed_ones]);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        num Q[9 * dim], R[9 * dim];
        int moved = 0;
        G(bezier_points_of)(printed_ones, 7, dim, P[printed_ones], beta[0], Q);
        G(bezier_points_of)(printed_ones, 7, dim, P[printed_ones], beta[1], R);
        for (int m = 0; m < 9 * dim; m++)
            moved += !equal_q(Q[m], R[m]);
        found_points(T, Q_of[printed_ones], 9, dim, R);
        differ += moved > 0;
    }
    about(T, "some of the Bézier points differ");
    agree(T, differ > 0);
}
#endif

/*
## The ends (端点性质)

The curve begins in $Q_0=P_0$ towards $Q_1$, and $Q_1-P_0=\frac{\nu_1}8(P_1-P_0)$.  Hence the factor $7+\beta$ of the
derivative, in which no misprint takes part.  Hence, too, what the source overlooks at the left end of its range: for
$\beta=-7$ the point $Q_1$ falls on $P_0$, the first derivative is the zero vector, and the tangent is no longer that of the
edge.

:::{statement} deng-zhang-2022:property-3.1
:title: Points and derivatives at the ends
:zh: 端点性质，式 (11)
:printed: B_1(0)=P_0,\quad B_1(1)=P_7,\quad B_1'(0)=(\beta+7)(P_1-P_0),\quad B_1'(1)=(\beta+7)(P_7-P_6)
:holds-by: end_points_and_end_derivatives
:confirmed-by: functions_vanish_to_their_orders_at_the_ends
:figure: end_edges
:degree: 7

True for all real $\beta$, with the printed functions as with the corrected ones (`sec-2-properties`): the two misprinted ones, $B_{3,7}$ and $B_{4,7}$, vanish at
least threefold at both ends.
:::

:::{claim} end_points_and_end_derivatives
:title: The ends of the curve and the derivatives there
:zh: 端点与端点导矢
:given: points $P_0,\dots,P_n$ of the plane, any $\beta$
:then: $q(0)=P_0$, $q(1)=P_n$, $q'(0)=(n+\beta)(P_1-P_0)$, $q'(1)=(n+\beta)(P_n-P_{n-1})$; for $n=7$ also with the printed
  functions
:method: The derivatives of the Bézier curve of degree $n+1$ at the two integers, everything a variable; coordinate by coordinate, so that it is true in every
  dimension.
:degrees: 2..8 sampled 14
:control: $n$ in the place of $n+\beta$
:::
*/
CLAIM(end_points_and_end_derivatives)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], Q[(MAX_DEGREE + 1) * dim], D[2 * dim], beta = G(any_beta)(T);
    num factor = fault(T, add(from_int(n), beta), from_int(n));
    G(free_points)(T, n, dim, P);
    for (int printed_ones = 0; printed_ones <= (n == 7); printed_ones++) {
        G(bezier_points_of)(printed_ones, n, dim, P, beta, Q);
        for (int end = 0; end <= 1; end++) {
            G(bezier_derivatives)(n + 1, dim, Q, from_int(end), 1, D);
            const num *first = P + (end ? n - 1 : 0) * dim, *point = P + (end ? n : 0) * dim;
            for (int c = 0; c < dim; c++) {
                about(T, "the end point");
                same(T, D[c], point[c]);
                about(T, "the derivative");
                /* q'(0) = (n+β)(P_1 - P_0), q'(1) = (n+β)(P_n - P_{n-1}) */
                same(T, D[dim + c], mul(factor, sub(first[dim + c], first[c])));
            }
        }
    }
}

#if !FIELD
/*
:::{claim} derivatives_of_the_curve
:title: The kernel computes the derivatives of the curve
:zh: 曲线的各阶导矢
:given: numbers $P_0,\dots,P_n$, any $\beta$ and $t$
:then: row $k$ of `shape_derivatives` is the $k$-th derivative of $\sum P_iB_{i,n}$ at $t$, $0\le k\le n+2$
:method: In the field the formula of the curve is differentiated with respect to $t$; in the other number types the formula
  is differentiated as a product of powers by Leibniz's rule.
:degrees: 2..7 sampled 10
:defines: shape_derivatives
:control: $-\beta$ in the place of $\beta$
:::
*/
/* (d/dt)^k of (1-t)^a t^b, by Leibniz. */
static num G(product_derivative)(int a, int b, int k, num t)
{
    num sum = from_int(0);
    for (int j = 0; j <= k; j++) {
        if (j > a || k - j > b)
            continue;
        num term = mul(from_int(G(falling_factorial)(a, j) * G(falling_factorial)(b, k - j)),
                       G(product_of_powers)(a - j, b - k + j, t));
        term = mul(G(choose)(k, j), term);
        sum = j % 2 == 0 ? add(sum, term) : sub(sum, term);
    }
    return sum;
}
#endif

CLAIM(derivatives_of_the_curve)
{
    int n = T->degree;
    num P[MAX_DEGREE + 1], D[MAX_DEGREE + 3], beta = G(any_beta)(T), t = parameter(T, "t");
    G(free_points)(T, n, 1, P);
    G(shape_derivatives)(n, 1, P, fault(T, beta, neg(beta)), t, n + 2, D);
#if FIELD
    num value = G(corrected_curve)(n, 1, P, 0, beta, t);
    for (int k = 0; k <= n + 2; k++) {
        same(T, D[k], value);
        value = derivative_f(value, t);
    }
#else
    for (int k = 0; k <= n + 2; k++) {
        num sum = from_int(0);
        for (int i = 0; i <= n; i++) {
            num slope = sub(mul(G(shift)(n, i), G(product_derivative)(n + 1 - i, i, k, t)),
                            mul(G(shift)(n, i + 1), G(product_derivative)(n - i, i + 1, k, t)));
            num bernstein = mul(G(choose)(n, i), G(product_derivative)(n - i, i, k, t));
            sum = add(sum, mul(P[i], add(bernstein, mul(beta, slope))));
        }
        same(T, D[k], sum);
    }
#endif
}

/*
:::{statement} deng-zhang-2022:property-3.1-tangent
:title: The curve interpolates the end points and touches the end edges
:zh: 端点插值与端边相切
:printed: the curve interpolates the first and last control point and is tangent to the first and last edge (definition 2.1: $-7\le\beta\le1$)
:holds-by: end_points_and_end_derivatives
:confirmed-by: functions_vanish_to_their_orders_at_the_ends second_derivative_takes_over_at_minus_seven
:hypothesis: edge_is_not_tangent_at_minus_seven | $\beta\ne-7$
:hypothesis: double_end_point_has_no_end_edge | the end edges are not 0
:figure: end_edges
:degree: 7

That the curve begins in $P_0$ and ends in $P_7$ needs neither hypothesis.
:::
*/

#if RATIONAL
/*
:::{claim} edge_is_not_tangent_at_minus_seven
:title: At beta = -7 the curve does not touch its first edge
:zh: β=-7 时曲线不与首边相切
:kind: counterexample
:data: β = -7; P = (0,0) (1,0) (2,2) (3,3) (4,3) (5,2) (6,0) (7,0)
:instead: β = -6
:result: q'(0) = (0,0) (0,0); q''(0) = (42,-28) (42,-28); determinant of the edge and the tangent = -28 -28
:given: the left end of the printed range, and a polygon; printed and corrected functions
:then: for both the first derivative at 0 vanishes, the second gives the tangent, and the determinant of $P_1-P_0$ and this
  tangent is not 0
:method: The first derivative at 0 that is not the zero vector, computed exactly, and its determinant with the edge.
:control: a larger $\beta$
:::
*/
CLAIM(edge_is_not_tangent_at_minus_seven)
{
    num beta = given(T, "β"), P[8 * dim], Q[9 * dim], D[3 * dim], edge[dim], first[2 * dim], second[2 * dim],
        determinant[2];
    given_points(T, "P", 8, dim, P);
    for (int c = 0; c < dim; c++)
        edge[c] = sub(P[dim + c], P[c]);
    for (int corrected = 0; corrected <= 1; corrected++) {
        G(bezier_points_of)(!corrected, 7, dim, P, beta, Q);
        G(bezier_derivatives)(8, dim, Q, from_int(0), 2, D);
        for (int c = 0; c < dim; c++)
            first[corrected * dim + c] = D[dim + c], second[corrected * dim + c] = D[2 * dim + c];
        int order = is_zero_q(D[dim]) && is_zero_q(D[dim + 1]) ? 2 : 1;
        determinant[corrected] = G(cross2)(edge, D + order * dim);
    }
    found_points(T, "q'(0)", 2, dim, first);
    found_points(T, "q''(0)", 2, dim, second);
    found_points(T, "determinant of the edge and the tangent", 2, 1, determinant);
    about(T, "one of the two determinants of the first edge and the tangent is 0");
    refute(T, !is_zero_q(determinant[0]) && !is_zero_q(determinant[1]));
}
#endif

/*
What takes over is the second derivative, for any polygon.

:::{claim} second_derivative_takes_over_at_minus_seven
:title: At beta = -7 the second derivatives at the ends
:zh: β=-7 时端点的二阶导矢
:given: points $P_0,\dots,P_7$ of the plane, $\beta=-7$; printed and corrected functions
:then: $q'(0)=q'(1)=0$, $q''(0)=14(5P_1-P_2-4P_0)$, $q''(1)=14(5P_6-P_5-4P_7)$
:method: The derivatives of the Bézier curve of degree 8 at the two integers, all points variables.
:degrees: 7..7
:control: the neighbour of the end point counted once less
:::
*/
CLAIM(second_derivative_takes_over_at_minus_seven)
{
    num P[8 * dim], Q[9 * dim], D[3 * dim];
    G(free_points)(T, 7, dim, P);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        G(bezier_points_of)(printed_ones, 7, dim, P, from_int(-7), Q);
        for (int end = 0; end <= 1; end++) {
            const num *point = P + (end ? 7 : 0) * dim, *next = P + (end ? 6 : 1) * dim,
                      *other = P + (end ? 5 : 2) * dim;
            G(bezier_derivatives)(8, dim, Q, from_int(end), 2, D);
            for (int c = 0; c < dim; c++) {
                about(T, "the first derivative");
                vanishes(T, D[dim + c]);
                about(T, "the second derivative");
                num sum = sub(mul(from_int(fault(T, 5, 4)), next[c]), add(other[c], mul(from_int(4), point[c])));
                same(T, D[2 * dim + c], mul(from_int(14), sum));
            }
        }
    }
}

/*
## Convex hull, symmetry, invariance (凸包性, 对称性, 几何不变性)

The remaining properties are printed with the reason that the functions have properties of their own.  The hull needs two of
them: functions that are not negative, and the sum 1.  The two examples below tell them apart.  Eight equal points ask for
the sum and for nothing else; a triangle with its base on the $x$-axis asks for the sign of one function, since the height
of the curve is $B_2(t)$.

:::{statement} deng-zhang-2022:property-3.2
:title: The curve lies in the convex hull of its points
:zh: 凸包性
:printed: by property 2.1 the curve lies in the convex hull of the control points (definition 2.1: $-7\le\beta\le1$)
:refuted-by: printed_curve_leaves_a_single_point corrected_curve_leaves_the_hull_at_minus_seven
:class: false
:corrected: true for the corrected functions (`sec-2-properties`) exactly when $-\frac{21}4\le\beta\le1$; for the printed ones only for $\beta=0$
:corrected-by: corrected_functions_sum_to_one nonnegative_exactly_in_the_range printed_sum_in_closed_form
:figure: hull_and_sum

For $\beta$ outside the range some $B_i(t)<0$; the curve of $P_i=(1,0)$ and all other points $(0,0)$ is then outside its
hull.  For the printed functions and $\beta\ne0$ the curve of eight equal points that are not the origin is no point.
:::
*/

#if RATIONAL
/*
:::{claim} printed_curve_leaves_a_single_point
:title: The printed curve of eight equal points is no point
:zh: 八点重合时按式 (1) 的曲线不是一点
:kind: counterexample
:data: β = 1; P = (1,1) (1,1) (1,1) (1,1) (1,1) (1,1) (1,1) (1,1); t = 1/2
:result: q(t) = (31/32,31/32)
:given: the right end of the range of $\beta$, eight equal points, and the middle of the interval; printed functions
:then: the point of the curve is not the one point of the polygon
:method: The point of the printed formulas; `hull.h` is asked whether it is in the hull.
:control: the corrected functions
:::
*/
CLAIM(printed_curve_leaves_a_single_point)
{
    num beta = given(T, "β"), P[8 * dim], at[dim];
    given_points(T, "P", 8, dim, P);
    G(curve_point)(fault(T, 0, 1), 7, dim, P, beta, given(T, "t"), at);
    found_points(T, "q(t)", 1, dim, at);
    about(T, "the point is in the hull");
    agree(T, hull_membership(dim, 8, P, at).inside);
}

/*
:::{claim} corrected_curve_leaves_the_hull_at_minus_seven
:title: At beta = -7 the curve leaves the convex hull
:zh: β=-7 时曲线越出凸包
:kind: counterexample
:data: β = -7; P = (0,0) (0,0) (1,1) (2,0) (2,0) (2,0) (2,0) (2,0); t = 1/20
:instead: β = -5
:result: q(t) = (-171625953/25600000000,-190659623/25600000000)
:given: the left end of the printed range, the three corners of a triangle with the first and the last repeated, and a
  small $t$; corrected functions
:then: $y(t)=B_2(t)<0$ while all points have $y\ge0$
:method: The point of the corrected curve; `hull.h` is asked whether it is in the hull.
:control: a $\beta$ of the true range
:::
*/
CLAIM(corrected_curve_leaves_the_hull_at_minus_seven)
{
    num beta = given(T, "β"), P[8 * dim], at[dim];
    given_points(T, "P", 8, dim, P);
    G(curve_point)(0, 7, dim, P, beta, given(T, "t"), at);
    found_points(T, "q(t)", 1, dim, at);
    about(T, "the point is in the hull");
    agree(T, hull_membership(dim, 8, P, at).inside);
}

/*
:::{statement} deng-zhang-2022:property-3.3
:title: The reversed polygon has the same curve backwards
:zh: 对称性
:printed: the curve of $P_7,\dots,P_0$ is the curve of $P_0,\dots,P_7$ with the opposite direction
:refuted-by: printed_curve_is_not_reversed
:class: misprint
:corrected: true for the corrected functions (`sec-2-properties`) for every $\beta$, for the printed ones only for $\beta=0$
:corrected-by: reversed_polygon_reverses_the_curve printed_outer_functions_are_mirror_images
:confirmed-by: printed_sum_in_closed_form derivative_of_a_function_factors first_function_falls_and_last_rises
:figure: two_directions_two_curves

What is compared is the point at $1-t$ with that at $t$, as in (12), and for all polygons together.  For $-7\le\beta\le1$ it is the same with sets of points:
for $\beta\ne0$ the printed curve of $P_0=\dots=P_6=(0,1)$, $P_7=(1,1)$ is $(\hat B_7(t),\,1-4\beta s^3t^4)$, that of the reversed polygon at $s=1-t$ is
$(\hat B_7(t),\,1-4\beta s^4t^3)$, and $\hat B_7$ rises: two sets.
:::

:::{claim} printed_curve_is_not_reversed
:title: The printed curve of the reversed polygon is another curve
:zh: 按式 (1) 反序不得原曲线
:kind: counterexample
:data: β = -1; P = (0,0) (1,6) (2,10) (3,12) (4,12) (5,10) (6,6) (7,1); t = 1/4
:result: q(t) = (27487/16384,493639/65536); reversed curve at 1-t = (28189/16384,504007/65536);
  degree of the common divisor = 0
:given: $\beta$, a $t$, and a convex polygon; printed functions
:then: the curve of the reversed polygon at $1-t$ is not the curve at $t$; nor is any other point of the reversed curve, since
  its two coordinates minus those of $q(t)$, polynomials of the parameter, have no common root
:method: Both points by the printed formulas; the greatest common divisor of the two polynomials has degree 0.  `hull.h` decides that the polygon is
  convex.
:control: the corrected functions
:::
*/
CLAIM(printed_curve_is_not_reversed)
{
    num beta = given(T, "β"), P[8 * dim], R[8 * dim], forward[dim], backward[dim];
    int printed_ones = fault(T, 0, 1);
    given_points(T, "P", 8, dim, P);
    num t = given(T, "t"), s = sub(from_int(1), t);
    G(reversed_points)(7, dim, P, R);
    G(curve_point)(printed_ones, 7, dim, P, beta, t, forward);
    G(curve_point)(printed_ones, 7, dim, R, beta, s, backward);
    struct G(path) reversed = G(path_in)(printed_ones, 7, R, beta);
    poly across = poly_sub(reversed.x, poly_constant(forward[0])), up = poly_sub(reversed.y, poly_constant(forward[1]));
    int common = poly_degree(poly_gcd(across, up));
    found_points(T, "q(t)", 1, dim, forward);
    found_points(T, "reversed curve at 1-t", 1, dim, backward);
    found_whole(T, "degree of the common divisor", common);
    about(T, "the polygon is not convex, or the reversed curve comes to q(t), at 1-t or elsewhere");
    refute(T, polygon_is_convex(7, P, 1, NULL) && !equal_q(backward[0], forward[0]) && common == 0);
}
#endif

/*
:::{claim} reversed_polygon_reverses_the_curve
:title: The reversed polygon gives the corrected curve backwards
:zh: 控制顶点反序,曲线反向
:given: points of the plane, any $\beta$ and $t$
:then: the curve of $P_n,\dots,P_0$ at $1-t$ is $q(t)$
:method: Both by the kernel, everything a variable; coordinate by coordinate, so that it is true in every dimension.
:degrees: 2..7 sampled 12
:control: the curve of the reversed polygon at $t$
:::
*/
CLAIM(reversed_polygon_reverses_the_curve)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], R[(MAX_DEGREE + 1) * dim], at[dim], back[dim];
    num beta = G(any_beta)(T), t = parameter(T, "t");
    G(free_points)(T, n, dim, P);
    G(reversed_points)(n, dim, P, R);
    G(shape_point)(n, dim, P, beta, t, at);
    G(shape_point)(n, dim, R, beta, fault(T, sub(from_int(1), t), t), back);
    for (int c = 0; c < dim; c++)
        same(T, back[c], at[c]);
}

/*
:::{statement} deng-zhang-2022:eq-12
:title: The chain that proves the symmetry
:zh: 式 (12)
:printed: B_1(1-t)=\sum_{i=0}^7P_{7-i}B_{i,7}(1-t)=\sum_{j=0}^7P_jB_{j,7}(t)=B_1(t)
:refuted-by: curve_is_not_its_own_reverse printed_curve_is_not_reversed
:class: misprint
:corrected: $\tilde B(1-t)=\sum P_{7-i}B_{i,7}(1-t)=\sum P_jB_{j,7}(t)=q(t)$, where $\tilde B$ on the left is the curve of the
  reversed polygon, $q$ that of the polygon, and the functions are the corrected ones (`sec-2-properties`)
:corrected-by: reversed_polygon_reverses_the_curve
:figure: two_directions_two_curves
:degree: 7

As printed, with one meaning of $B_1$, the ends of the chain say that every curve is its own reverse.  With the printed functions and
$\beta\ne0$ the equation in the middle fails for some polygons, too: the left sum is the point of the reversed polygon at $1-t$, the right one that at $t$.
:::
*/

#if RATIONAL
/*
:::{claim} curve_is_not_its_own_reverse
:title: B(1-t) is not B(t)
:zh: 式 (12) 首尾不等
:kind: counterexample
:data: β = -1; P = 0 1 2 3 4 5 6 7; t = 0
:result: q(1-t), printed and corrected = 7 7; q(t), printed and corrected = 0 0
:given: points on an axis, one coordinate of each, and the first parameter; printed and corrected functions
:then: $q(1-t)\ne q(t)$: they are the last and the first point
:method: The two ends of the chain are computed.
:control: the curve of the reversed polygon on the left
:::
*/
CLAIM(curve_is_not_its_own_reverse)
{
    num beta = given(T, "β"), P[8], R[8], left[2], right[2];
    given_points(T, "P", 8, 1, P);
    num t = given(T, "t");
    G(reversed_points)(7, 1, P, R);
    for (int corrected = 0; corrected <= 1; corrected++) {
        G(curve_point)(!corrected, 7, 1, fault(T, R, P), beta, sub(from_int(1), t), left + corrected);
        G(curve_point)(!corrected, 7, 1, P, beta, t, right + corrected);
    }
    found_points(T, "q(1-t), printed and corrected", 2, 1, left);
    found_points(T, "q(t), printed and corrected", 2, 1, right);
    about(T, "the two ends of the chain are one point, for the printed or the corrected functions");
    refute(T, !equal_q(left[0], right[0]) && !equal_q(left[1], right[1]));
}

/*
Invariance (几何不变性) is the sum once more: points on the $x$-axis, moved up by 1, give a curve whose height is the sum of the
functions.  With the printed functions a translation therefore bends the curve, while linear maps, which leave the origin
where it is, do no harm.

:::{statement} deng-zhang-2022:property-3.4
:title: The curve does not depend on the coordinate system
:zh: 几何不变性
:printed: the curve depends only on the control points and not on the position and direction of the coordinate system, that is, its shape stays
  the same after translations and rotations of the coordinates (definition 2.1: $-7\le\beta\le1$)
:refuted-by: printed_curve_changes_under_translation
:class: misprint
:corrected: true for the corrected functions (`sec-2-properties`) for every $\beta$; the printed curve of the points $P_i+v$ is the old one
  moved by $(1-4\beta(1-t)^3t^4)v$, so it moves along only for $\beta=0$ or $v=0$; linear maps, rotations about the origin
  among them, take the printed curve along
:corrected-by: curve_moves_with_its_points printed_curve_follows_linear_maps_only
:figure: hull_and_sum
:striking: 10
:::

:::{statement} deng-zhang-2022:property-3.4-affine
:title: An affine map of the polygon is the same map of the curve
:zh: 仿射不变性
:printed: after scaling, shearing and other affine maps of the control polygon the new curve is the image of the old one under
  the same map (definition 2.1: $-7\le\beta\le1$)
:refuted-by: printed_curve_changes_under_translation
:class: misprint
:corrected: true for the corrected functions (`sec-2-properties`) for every $\beta$; with the printed ones for linear maps, for all affine maps
  only if $\beta=0$
:corrected-by: curve_moves_with_its_points printed_curve_follows_linear_maps_only
:figure: hull_and_sum
:::

:::{claim} printed_curve_changes_under_translation
:title: The printed curve does not move with its points
:zh: 平移后按式 (1) 的曲线形状改变
:kind: counterexample
:data: β = 1; P = (0,0) (1,0) (2,0) (3,0) (4,0) (5,0) (6,0) (7,0); v = (0,1); t = 1/2
:result: curve of P at t = (217/64,0); curve of P + v at t = (217/64,31/32); turns = 0 1
:given: the right end of the range of $\beta$, points on a line, a vector $v$ across it, and the middle of the interval; printed functions
:then: the point of the second curve is not that of the first moved by $v$; and the shapes differ, since at 0, $t$ and 1 the first curve
  has points of a line and the second turns left
:method: The points by the printed formulas; the turn is the sign of a determinant.
:control: the corrected functions
:::
*/
CLAIM(printed_curve_changes_under_translation)
{
    num beta = given(T, "β"), P[8 * dim], R[8 * dim], v[dim], before[3][dim], after[3][dim];
    int printed_ones = fault(T, 0, 1);
    given_points(T, "P", 8, dim, P);
    given_points(T, "v", 1, dim, v);
    num at[3] = {from_int(0), given(T, "t"), from_int(1)};
    for (int m = 0; m < 8 * dim; m++)
        R[m] = add(P[m], v[m % dim]);
    for (int k = 0; k < 3; k++) {
        G(curve_point)(printed_ones, 7, dim, P, beta, at[k], before[k]);
        G(curve_point)(printed_ones, 7, dim, R, beta, at[k], after[k]);
    }
    int first = turn_2d(before[0], before[1], before[2]), second = turn_2d(after[0], after[1], after[2]);
    found_points(T, "curve of P at t", 1, dim, before[1]);
    found_points(T, "curve of P + v at t", 1, dim, after[1]);
    found_points(T, "turns", 2, 1, (num[]){from_int(first), from_int(second)});
    about(T, "y of the second curve is that of the first moved, or the shapes may be the same");
    refute(T, !equal_q(after[1][1], add(before[1][1], v[1])) && first == 0 && second > 0);
}
#endif

/* The image of a point under the map x -> M x + factor v. */
static num G(image)(const num M[], const num v[], num factor, const num P[], int c)
{
    return add(add(mul(M[c * dim], P[0]), mul(M[c * dim + 1], P[1])), mul(factor, v[c]));
}

static void G(free_map)(trial *T, num M[], num v[])
{
    for (int m = 0; m < dim * dim; m++)
        M[m] = unknown(T, "m", m);
    for (int c = 0; c < dim; c++)
        v[c] = unknown(T, "v", c);
}

/*
:::{claim} curve_moves_with_its_points
:title: An affine map of the points is the same map of the corrected curve
:zh: 仿射不变性
:given: points of the plane, any affine map, any $\beta$ and $t$
:then: the curve of the images of the points is the image of the curve
:method: Map, points, $\beta$ and $t$ are variables.  A coordinate of the image is a linear function of the coordinates plus a number,
  one summand for each of them: with a third coordinate it is the same in space.
:degrees: 2..7 sampled 12
:over: m# v#: affine maps
:control: the last point is not moved
:::
*/
CLAIM(curve_moves_with_its_points)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], R[(MAX_DEGREE + 1) * dim], M[dim * dim], v[dim], at[dim], moved[dim];
    num beta = G(any_beta)(T), t = parameter(T, "t");
    G(free_points)(T, n, dim, P);
    G(free_map)(T, M, v);
    for (int i = 0; i <= n; i++)
        for (int c = 0; c < dim; c++)
            R[i * dim + c] = fault(T, 0, i == n) ? P[i * dim + c] : G(image)(M, v, from_int(1), P + i * dim, c);
    G(shape_point)(n, dim, P, beta, t, at);
    G(shape_point)(n, dim, R, beta, t, moved);
    for (int c = 0; c < dim; c++)
        same(T, moved[c], G(image)(M, v, from_int(1), at, c));
}

/*
:::{claim} printed_curve_follows_linear_maps_only
:title: What a translation and a linear map do to the printed curve
:zh: 按式 (1) 的曲线在平移与线性变换下的变化
:given: points $P_0,\dots,P_7$ of the plane, any linear map $M$ and vector $v$, any $\beta$ and $t$
:then: the printed curve of the points $MP_i+v$ is $M\hat q(t)+(1-4\beta(1-t)^3t^4)v$
:method: Map, points, $\beta$ and $t$ are variables.  In space a coordinate of $MP_i$ has one summand more, of the same form.
:degrees: 7..7
:over: m# v#: affine maps
:control: $v$ without its factor
:::
*/
CLAIM(printed_curve_follows_linear_maps_only)
{
    num P[8 * dim], R[8 * dim], M[dim * dim], v[dim], at[dim], moved[dim];
    num beta = G(any_beta)(T), t = parameter(T, "t"), one = from_int(1);
    G(free_points)(T, 7, dim, P);
    G(free_map)(T, M, v);
    for (int i = 0; i <= 7; i++)
        for (int c = 0; c < dim; c++)
            R[i * dim + c] = G(image)(M, v, one, P + i * dim, c);
    G(curve_point)(1, 7, dim, P, beta, t, at);
    G(curve_point)(1, 7, dim, R, beta, t, moved);
    /* M q̂(t) + (1 - 4β (1-t)³ t⁴) v */
    num factor = sub(one, mul(from_int(4), mul(beta, G(product_of_powers)(3, 4, t))));
    for (int c = 0; c < dim; c++)
        same(T, moved[c], G(image)(M, v, fault(T, factor, one), at, c));
}
#include "chapters/judge/claims_off.h"
