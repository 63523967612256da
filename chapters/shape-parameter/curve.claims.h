/*
# The curve (曲线)

The curve is $q_\beta(t)=\sum P_iB_{i,n}(t)$.  In the Bernstein basis of degree $n+1$ it has the points

$$Q_k=\frac{\varphi_{k-1}P_{k-1}+\nu_kP_k}{\binom{n+1}k},\qquad k=0,\dots,n+1,$$

and with the corrected functions $\varphi_{k-1}+\nu_k=\binom{n+1}k$: every $Q_k$ divides an edge of the polygon, and $\beta$
moves it along that edge.  For $\beta=0$ this is degree elevation (升阶).  With the printed functions $Q_4$ and $Q_5$ leave
their edges, and the curve depends on the place of the origin.

:::{statement} deng-zhang-2022:def-3.1
:title: The curve of eight points
:zh: 八次 β-Bezier 曲线，式 (10)
:printed: $B_1=\sum_{i=0}^7P_i\hat B_i(t)$ for $P_i\in\mathbb R^d$, $d=2,3$, $t\in[0,1]$
:definition: yes
:checked-by: printed_curve_kernel_is_the_sum curve_kernels_give_the_sum
:figure: curves_for_several_beta

The left side stands for $B_1(t)$, as (11) writes it.
:::

:::{statement} deng-zhang-2022:sec-3-degree
:title: It is called a curve of degree eight
:zh: 八次曲线之称
:printed: the curve of (10) is called the β-Bézier curve of degree eight
:definition: yes
:checked-by: bezier_points_divide_the_edges

Its degree is at most 8; for $\beta=0$ it is at most 7.
:::

:::{statement} deng-zhang-2022:sec-3-beta-0
:title: For beta = 0 the curve is the Bézier curve of degree seven
:zh: β=0 时退化为七次 Bezier 曲线
:printed: for $\beta=0$ the curve degenerates to the Bézier curve of degree seven
:holds-by: beta_zero_gives_the_bezier_curve
:::

:::{claim} printed_curve_kernel_is_the_sum
:title: The kernel computes the curve with the printed functions
:zh: 核函数即式 (10)
:given: points $P_0,\dots,P_7$ of the plane, any $\beta$ and $t$
:then: `shape_point_printed` gives $\sum P_i\hat B_i(t)$
:method: The eight formulas written out one by one, everything a variable.
:defines: shape_point_printed
:control: the polygon taken backwards
:::

:::{claim} curve_kernels_give_the_sum
:title: The kernel computes the curve with the corrected functions
:zh: 核函数即修正后的曲线
:given: points $P_0,\dots,P_n$ of the plane, any $\beta$ and $t$
:then: `shape_point` gives $\sum P_iB_{i,n}(t)$
:method: The formula of the functions, everything a variable.  The kernel uses de Casteljau's algorithm and no function of
  degree above 3.
:degrees: 2..7 sampled 14
:defines: shape_point
:control: $-\beta$ in the place of $\beta$
:::

:::{claim} bezier_points_divide_the_edges
:title: The Bézier points of the curve divide the edges of the polygon
:zh: 曲线的 Bézier 点分割控制多边形的边
:given: points $P_0,\dots,P_n$ of the plane, any $\beta$ and $t$
:then: the curve of degree $n+1$ of the points of `shape_bezier_points` is $\sum P_iB_{i,n}(t)$; they are the rows of
  `shape_matrix` applied to the $P_i$; and
  $Q_k-P_{k-1}=\bigl(\tfrac{n+1-k}{n+1}+\beta\frac{a_k}{\binom{n+1}k}\bigr)(P_k-P_{k-1})$
:method: The points as coefficients of Bernstein polynomials of degree $n+1$ against the formula of the functions,
  everything a variable.
:degrees: 2..7 sampled 14
:defines: shape_bezier_points shape_matrix
:control: $-\beta$ in the place of $\beta$
:::

:::{claim} beta_zero_gives_the_bezier_curve
:title: For beta = 0 both kernels give the Bézier curve
:zh: β=0 时为 Bézier 曲线
:given: points of the plane, any $t$
:then: `shape_point` and, for $n=7$, `shape_point_printed` give the point of de Casteljau's algorithm
:method: The kernels side by side, everything a variable.
:degrees: 2..7 sampled 14
:control: $\beta=1$
:::
*/
#include "exact/hull.h"

#include "chapters/shape-parameter/definition.h"
#include "chapters/shape-parameter/distance.h"

#include "chapters/frame/claims_on.h"

static num G(any_beta)(trial *T) { return unknown(T, "beta", 0); }

CLAIM(printed_curve_kernel_is_the_sum)
{
    num P[8 * dim], at[dim], beta = G(any_beta)(T), t = parameter(T, "t"), R[8 * dim];
    G(free_points)(T, 7, dim, P);
    for (int i = 0; i <= 7; i++)
        for (int c = 0; c < dim; c++)
            R[i * dim + c] = P[(T->planted ? 7 - i : i) * dim + c];
    G(shape_point_printed)(dim, R, beta, t, at);
    for (int c = 0; c < dim; c++)
        same(T, at[c], G(printed_curve)(dim, P, c, beta, t));
}

CLAIM(curve_kernels_give_the_sum)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], at[dim], beta = G(any_beta)(T), t = parameter(T, "t");
    G(free_points)(T, n, dim, P);
    G(shape_point)(n, dim, P, T->planted ? neg(beta) : beta, t, at);
    for (int c = 0; c < dim; c++)
        same(T, at[c], G(corrected_curve)(n, dim, P, c, beta, t));
}

CLAIM(bezier_points_divide_the_edges)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], Q[(MAX_DEGREE + 1) * dim], R[(MAX_DEGREE + 1) * dim];
    num beta = G(any_beta)(T), t = parameter(T, "t");
    G(free_points)(T, n, dim, P);
    G(shape_bezier_points)(n, dim, P, T->planted ? neg(beta) : beta, Q);
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
            about(T, "the ratio on the edge");
            num ratio = add(from_ratio(n + 1 - k, n + 1), mul(beta, div(G(shift)(n, k), G(choose)(n + 1, k))));
            num edge = sub(P[k * dim + c], P[(k - 1) * dim + c]);
            same(T, sub(Q[k * dim + c], P[(k - 1) * dim + c]), mul(ratio, edge));
        }
    }
}

CLAIM(beta_zero_gives_the_bezier_curve)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], at[dim], bezier[dim], beta = from_int(T->planted), t = parameter(T, "t");
    G(free_points)(T, n, dim, P);
    G(decasteljau)(n, dim, P, t, bezier);
    G(shape_point)(n, dim, P, beta, t, at);
    for (int c = 0; c < dim; c++)
        same(T, at[c], bezier[c]);
    if (n == 7) {
        G(shape_point_printed)(dim, P, beta, t, at);
        for (int c = 0; c < dim; c++)
            same(T, at[c], bezier[c]);
    }
}

/*
## How the curve moves with the parameter

:::{statement} deng-zhang-2022:fig-2
:title: The curves of several beta from right to left
:zh: 图 2
:printed: figure 2 shows, from right to left, the curves for $\beta=1,0,-1,\dots,-7$
:reading: points_move_evenly_with_beta | the points of one $t$ stand on a straight line in equal distances, in the order of
  $\beta$; on which side is a matter of the polygon, which the text does not give
:figure: curves_for_several_beta

The last two curves of the figure, $\beta=-6$ and $-7$, are outside the true range.
:::

:::{statement} deng-zhang-2022:abstract-adjustable
:title: For a fixed polygon different beta give different curves
:zh: 形状可调性
:printed: with the control points fixed, different curves are produced by changing the parameter
:holds-by: points_move_evenly_with_beta
:hypothesis: edges_that_do_not_move | the vector $\sum_ka_k(P_k-P_{k-1})s^{8-k}t^k$ does not vanish for all $t$, that is, not
  all edges but $P_3P_4$ are 0 (corrected functions, $n=7$); and the points are not all on a line, where only the
  parametrization may change

For $n=7$ the number $a_4$ is 0.
:::

:::{claim} points_move_evenly_with_beta
:title: The point of a parameter moves on a straight line, evenly with beta
:zh: 曲线上的点随 β 匀速直线移动
:given: points $P_0,\dots,P_n$ of the plane, any $\beta$, $h$ and $t$
:then: $q_{\beta+h}(t)-q_\beta(t)=h\sum_{k=1}^na_k(P_k-P_{k-1})s^{n+1-k}t^k$
:method: The kernel at $\beta+h$ and $\beta$, everything a variable.
:degrees: 2..7 sampled 12
:control: the first edge left out
:::

:::{claim} edges_that_do_not_move
:title: A polygon of one middle edge has one curve for all beta
:zh: 仅有中间一边的控制多边形与 β 无关
:kind: counterexample
:given: $P_0=\dots=P_3=(0,0)$, $P_4=\dots=P_7=(1,2)$, $\beta=0$ and $\beta=1$
:then: the Bézier points of degree 8, and so the curves, are the same
:method: Both sets of nine points are computed and compared; that they differ somewhere is asked.
:control: $P_4=(0,0)$
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
        for (int k = T->planted ? 2 : 1; k <= n; k++) {
            num edge = sub(P[k * dim + c], P[(k - 1) * dim + c]);
            sum = add(sum, mul(mul(G(shift)(n, k), edge), G(product_of_powers)(n + 1 - k, k, t)));
        }
        same(T, sub(after[c], before[c]), mul(h, sum));
    }
}

#if RATIONAL
CLAIM(edges_that_do_not_move)
{
    num P[8 * dim], Q[9 * dim], R[9 * dim];
    int differ = 0;
    for (int i = 0; i <= 7; i++) {
        P[i * dim] = from_int(i >= 4 + T->planted);
        P[i * dim + 1] = from_int(2 * (i >= 4 + T->planted));
    }
    G(shape_bezier_points)(7, dim, P, from_int(0), Q);
    G(shape_bezier_points)(7, dim, P, from_int(1), R);
    for (int m = 0; m < 9 * dim; m++)
        differ += !equal_q(Q[m], R[m]);
    show_points(T, "P", 8, dim, P);
    show_points(T, "Q, beta = 0", 9, dim, Q);
    show_points(T, "Q, beta = 1", 9, dim, R);
    about(T, "some of the Bézier points differ");
    agree(T, differ > 0);
}
#endif

/*
## The ends (端点性质)

:::{statement} deng-zhang-2022:property-3.1
:title: Points and derivatives at the ends
:zh: 端点性质，式 (11)
:printed: B_1(0)=P_0,\quad B_1(1)=P_7,\quad B_1'(0)=(\beta+7)(P_1-P_0),\quad B_1'(1)=(\beta+7)(P_7-P_6)
:holds-by: end_points_and_end_derivatives
:figure: end_edges

True for all real $\beta$, with the printed functions as with the corrected ones: the two wrong functions vanish threefold at
both ends.
:::

:::{statement} deng-zhang-2022:property-3.1-tangent
:title: The curve interpolates the end points and touches the end edges
:zh: 端点插值与端边相切
:printed: the curve interpolates the first and last control point and is tangent to the first and last edge
:holds-by: end_points_and_end_derivatives
:hypothesis: edge_is_not_tangent_at_minus_seven | $\beta\ne-7$, and the end edges are not 0
:figure: end_edges

At $\beta=-7$, an end of the printed range, the curve leaves $P_0$ towards $\frac14(5P_1-P_2)$; below $-7$ it would leave
against the edge.
:::

:::{claim} end_points_and_end_derivatives
:title: The ends of the curve and the derivatives there
:zh: 端点与端点导矢
:given: points $P_0,\dots,P_n$ of the plane, any $\beta$
:then: $q(0)=P_0$, $q(1)=P_n$, $q'(0)=(n+\beta)(P_1-P_0)$, $q'(1)=(n+\beta)(P_n-P_{n-1})$; for $n=7$ also with the printed
  functions
:method: The derivatives of the Bézier curve of degree $n+1$ at the two integers, everything a variable.
:degrees: 2..8 sampled 14
:control: $n$ in the place of $n+\beta$
:::

:::{claim} derivatives_of_the_curve
:title: The kernel computes the derivatives of the curve
:zh: 曲线的各阶导矢
:given: numbers $P_0,\dots,P_n$, any $\beta$ and $t$
:then: row $k$ of `shape_derivatives` is the $k$-th derivative of $\sum P_iB_{i,n}$ at $t$, $0\le k\le n+2$
:method: In the field the formula of the curve is differentiated with respect to $t$; in the other number types the formula
  is differentiated as a product of powers by Leibniz's rule.
:degrees: 2..6 sampled 10
:defines: shape_derivatives
:control: $-\beta$ in the place of $\beta$
:::

:::{claim} edge_is_not_tangent_at_minus_seven
:title: At beta = -7 the curve does not touch its first edge
:zh: β=-7 时曲线不与首边相切
:kind: counterexample
:given: $\beta=-7$, $P=(0,0),(1,0),(2,2),(3,3),(4,3),(5,2),(6,0),(7,0)$
:then: $q'(0)=0$ and the determinant of $P_1-P_0$ and $q''(0)$, which then gives the tangent, is not 0
:method: The first derivative at 0 that is not the zero vector, computed exactly; its determinant with the edge is asked to
  vanish.
:control: $\beta=-6$
:::
*/
CLAIM(end_points_and_end_derivatives)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], Q[(MAX_DEGREE + 1) * dim], D[2 * dim], beta = G(any_beta)(T);
    num factor = T->planted ? from_int(n) : add(from_int(n), beta);
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
                same(T, D[dim + c], mul(factor, sub(first[dim + c], first[c])));
            }
        }
    }
}

#if !FIELD
/* n (n-1) ... (n-k+1) */
static num G(falling)(int n, int k)
{
    num product = from_int(1);
    for (int j = 0; j < k; j++)
        product = mul(product, from_int(n - j));
    return product;
}

/* (d/dt)^k of (1-t)^a t^b, by Leibniz. */
static num G(product_derivative)(int a, int b, int k, num t)
{
    num sum = from_int(0);
    for (int j = 0; j <= k; j++) {
        if (j > a || k - j > b)
            continue;
        num term = mul(mul(G(falling)(a, j), G(falling)(b, k - j)), G(product_of_powers)(a - j, b - k + j, t));
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
    G(shape_derivatives)(n, 1, P, T->planted ? neg(beta) : beta, t, n + 2, D);
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

#if RATIONAL
CLAIM(edge_is_not_tangent_at_minus_seven)
{
    static const int at[] = {0, 0, 1, 0, 2, 2, 3, 3, 4, 3, 5, 2, 6, 0, 7, 0};
    num P[8 * dim], D[3 * dim], beta = from_int(T->planted ? -6 : -7), edge[dim];
    G(integer_points)(8, at, P);
    G(shape_derivatives)(7, dim, P, beta, from_int(0), 2, D);
    for (int c = 0; c < dim; c++)
        edge[c] = sub(P[dim + c], P[c]);
    int order = is_zero_q(D[dim]) && is_zero_q(D[dim + 1]) ? 2 : 1;
    show(T, "beta", beta);
    show_points(T, "P", 8, dim, P);
    show_points(T, "q'(0)", 1, dim, D + dim);
    show_points(T, "q''(0)", 1, dim, D + 2 * dim);
    about(T, "the determinant of the first edge and the tangent");
    vanishes(T, G(cross2)(edge, D + order * dim));
}
#endif

/*
## Convex hull, symmetry, invariance (凸包性, 对称性, 几何不变性)

:::{statement} deng-zhang-2022:property-3.2
:title: The curve lies in the convex hull of its points
:zh: 凸包性
:printed: by property 2.1 the curve lies in the convex hull of the control points
:refuted-by: printed_curve_leaves_a_single_point corrected_curve_leaves_the_hull_at_minus_seven
:class: false
:corrected: true for the corrected functions exactly when $-\frac{21}4\le\beta\le1$; for the printed ones only for $\beta=0$
:corrected-by: corrected_functions_sum_to_one nonnegative_exactly_in_the_range printed_sum_in_closed_form
:figure: hull_and_sum

For $\beta$ outside the range some $B_i(t)<0$; the curve of $P_i=(1,0)$ and all other points $(0,0)$ is then outside its
hull.  For the printed functions and $\beta\ne0$ the curve of eight equal points is no point.
:::

:::{statement} deng-zhang-2022:property-3.3
:title: The reversed polygon has the same curve backwards
:zh: 对称性
:printed: the curve of $P_7,\dots,P_0$ is the curve of $P_0,\dots,P_7$ with the opposite direction
:refuted-by: printed_curve_is_not_reversed
:class: misprint
:corrected: true for the corrected functions for every $\beta$, for the printed ones only for $\beta=0$
:corrected-by: reversed_polygon_reverses_the_curve printed_outer_functions_are_mirror_images
:::

:::{statement} deng-zhang-2022:eq-12
:title: The chain that proves the symmetry
:zh: 式 (12)
:printed: B_1(1-t)=\sum P_{7-i}B_i(1-t)=\sum P_jB_j(t)=B_1(t)
:refuted-by: curve_is_not_its_own_reverse
:class: misprint
:corrected: $\tilde B(1-t)=\sum P_{7-i}B_{i,7}(1-t)=\sum P_jB_{j,7}(t)=q(t)$, where $\tilde B$ on the left is the curve of the
  reversed polygon and the functions are the corrected ones
:corrected-by: reversed_polygon_reverses_the_curve

As printed, with one meaning of $B_1$, the ends of the chain say that every curve is its own reverse.
:::

:::{statement} deng-zhang-2022:property-3.4
:title: The curve does not depend on the coordinate system
:zh: 几何不变性
:printed: the curve depends only on the control points; its shape stays the same under translations and rotations
:refuted-by: printed_curve_changes_under_translation
:class: misprint
:corrected: true for the corrected functions for every $\beta$; the printed curve of the points $P_i+v$ is the old one moved by
  $(1-4\beta(1-t)^3t^4)v$, so it moves along only for $\beta=0$ or $v=0$; linear maps, rotations about the origin among them,
  do no harm
:corrected-by: curve_moves_with_its_points printed_curve_follows_linear_maps_only
:figure: hull_and_sum
:striking: 10
:::

:::{statement} deng-zhang-2022:property-3.4-affine
:title: An affine map of the polygon is the same map of the curve
:zh: 仿射不变性
:printed: after scaling, shearing and other affine maps of the control polygon the new curve is the image of the old one under
  the same map
:refuted-by: printed_curve_changes_under_translation
:class: misprint
:corrected: true for the corrected functions for every $\beta$; with the printed ones for linear maps, for all affine maps only
  if $\beta=0$
:corrected-by: curve_moves_with_its_points printed_curve_follows_linear_maps_only
:::

:::{claim} printed_curve_leaves_a_single_point
:title: The printed curve of eight equal points is no point
:zh: 八点重合时按式 (1) 的曲线不是一点
:kind: counterexample
:given: $P_0=\dots=P_7=(1,1)$, $\beta=1$, $t=\frac12$
:then: the point of the curve is $(\frac{31}{32},\frac{31}{32})$
:method: The point of the printed formulas; `hull.h` is asked whether it is in the hull.
:control: the corrected functions
:::

:::{claim} corrected_curve_leaves_the_hull_at_minus_seven
:title: At beta = -7 the curve leaves the convex hull
:zh: β=-7 时曲线越出凸包
:kind: counterexample
:given: $\beta=-7$, $P_0=P_1=(0,0)$, $P_2=(1,1)$, $P_3=\dots=P_7=(2,0)$, $t=\frac1{20}$; printed and corrected functions have the
  same $y$
:then: $y(t)=B_2(t)<0$ while all points have $y\ge0$
:method: The point of the corrected curve; `hull.h` is asked whether it is in the hull.
:control: $\beta=-5$
:::

:::{claim} printed_curve_is_not_reversed
:title: The printed curve of the reversed polygon is another curve
:zh: 按式 (1) 反序不得原曲线
:kind: counterexample
:given: $\beta=-1$, $P_3=(1,1)$ and all other points $(0,0)$, $t=\frac14$
:then: the curve of the reversed polygon at $1-t$ is not the curve at $t$
:method: Both points by the printed formulas; their first coordinates are compared.
:control: the corrected functions
:::

:::{claim} curve_is_not_its_own_reverse
:title: B(1-t) is not B(t)
:zh: 式 (12) 首尾不等
:kind: counterexample
:given: $P_i=(i,0)$, any $\beta$, here $-1$; $t=0$
:then: $q(1-t)=(7,0)$ and $q(t)=(0,0)$
:method: The two ends of the chain are computed.
:control: the curve of the reversed polygon on the left
:::

:::{claim} printed_curve_changes_under_translation
:title: The printed curve does not move with its points
:zh: 平移后按式 (1) 的曲线形状改变
:kind: counterexample
:given: $\beta=1$, $P_i=(i,0)$ and $P_i+(0,1)$, $t=\frac12$
:then: the $y$ of the second curve is $\frac{31}{32}$, not 1
:method: Both points by the printed formulas.
:control: the corrected functions
:::

:::{claim} reversed_polygon_reverses_the_curve
:title: The reversed polygon gives the corrected curve backwards
:zh: 控制顶点反序,曲线反向
:given: points of the plane, any $\beta$ and $t$
:then: the curve of $P_n,\dots,P_0$ at $1-t$ is $q(t)$
:method: Both by the kernel, everything a variable.
:degrees: 2..7 sampled 12
:control: the curve of the reversed polygon at $t$
:::

:::{claim} curve_moves_with_its_points
:title: An affine map of the points is the same map of the corrected curve
:zh: 仿射不变性
:given: points of the plane, any affine map, any $\beta$ and $t$
:then: the curve of the images of the points is the image of the curve
:method: Map, points, $\beta$ and $t$ are variables.
:degrees: 2..7 sampled 12
:control: the last point is not moved
:::

:::{claim} printed_curve_follows_linear_maps_only
:title: What a translation and a linear map do to the printed curve
:zh: 按式 (1) 的曲线在平移与线性变换下的变化
:given: points $P_0,\dots,P_7$ of the plane, any linear map $M$ and vector $v$, any $\beta$ and $t$
:then: the printed curve of the points $MP_i+v$ is $M\hat q(t)+(1-4\beta(1-t)^3t^4)v$
:method: Map, points, $\beta$ and $t$ are variables.
:control: $v$ without its factor
:::
*/
#if RATIONAL
CLAIM(printed_curve_leaves_a_single_point)
{
    num P[8 * dim], at[dim], beta = from_int(1), t = from_ratio(1, 2);
    for (int m = 0; m < 8 * dim; m++)
        P[m] = from_int(1);
    if (T->planted)
        G(shape_point)(7, dim, P, beta, t, at);
    else
        G(shape_point_printed)(dim, P, beta, t, at);
    show_points(T, "P", 8, dim, P);
    show_points(T, "the point of t = 1/2", 1, dim, at);
    about(T, "the point is in the hull");
    agree(T, hull_membership(dim, 8, P, at).inside);
}

CLAIM(corrected_curve_leaves_the_hull_at_minus_seven)
{
    static const int points[] = {0, 0, 0, 0, 1, 1, 2, 0, 2, 0, 2, 0, 2, 0, 2, 0};
    num P[8 * dim], at[dim], beta = from_int(T->planted ? -5 : -7), t = from_ratio(1, 20);
    G(integer_points)(8, points, P);
    G(shape_point)(7, dim, P, beta, t, at);
    show(T, "beta", beta);
    show_points(T, "P", 8, dim, P);
    show_points(T, "the point of t = 1/20", 1, dim, at);
    about(T, "the point is in the hull");
    agree(T, hull_membership(dim, 8, P, at).inside);
}

CLAIM(printed_curve_is_not_reversed)
{
    num P[8 * dim], R[8 * dim], forward[dim], backward[dim], beta = from_int(-1), t = from_ratio(1, 4);
    num s = sub(from_int(1), t);
    for (int m = 0; m < 8 * dim; m++) {
        P[m] = from_int(m / dim == 3);
        R[m] = from_int(7 - m / dim == 3);
    }
    if (T->planted) {
        G(shape_point)(7, dim, P, beta, t, forward);
        G(shape_point)(7, dim, R, beta, s, backward);
    } else {
        G(shape_point_printed)(dim, P, beta, t, forward);
        G(shape_point_printed)(dim, R, beta, s, backward);
    }
    show_points(T, "P", 8, dim, P);
    about(T, "the reversed curve at 1-t and the curve at t");
    same(T, backward[0], forward[0]);
}

CLAIM(curve_is_not_its_own_reverse)
{
    num P[8 * dim], left[dim], right[dim], beta = from_int(-1);
    for (int i = 0; i <= 7; i++) {
        P[i * dim] = from_int(T->planted ? 7 - i : i);
        P[i * dim + 1] = from_int(0);
    }
    G(shape_point)(7, dim, P, beta, from_int(1), left);
    for (int i = 0; i <= 7; i++)
        P[i * dim] = from_int(i);
    G(shape_point)(7, dim, P, beta, from_int(0), right);
    show_points(T, "P", 8, dim, P);
    about(T, "the two ends of the chain at t = 0");
    same(T, left[0], right[0]);
}

CLAIM(printed_curve_changes_under_translation)
{
    num P[8 * dim], R[8 * dim], before[dim], after[dim], beta = from_int(1), t = from_ratio(1, 2);
    for (int i = 0; i <= 7; i++) {
        P[i * dim] = R[i * dim] = from_int(i);
        P[i * dim + 1] = from_int(0);
        R[i * dim + 1] = from_int(1);
    }
    if (T->planted) {
        G(shape_point)(7, dim, P, beta, t, before);
        G(shape_point)(7, dim, R, beta, t, after);
    } else {
        G(shape_point_printed)(dim, P, beta, t, before);
        G(shape_point_printed)(dim, R, beta, t, after);
    }
    show_points(T, "P", 8, dim, P);
    show_points(T, "P + (0,1)", 8, dim, R);
    about(T, "y of the second curve and y of the first plus 1");
    same(T, after[1], add(before[1], from_int(1)));
}
#endif

CLAIM(reversed_polygon_reverses_the_curve)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], R[(MAX_DEGREE + 1) * dim], at[dim], back[dim];
    num beta = G(any_beta)(T), t = parameter(T, "t");
    G(free_points)(T, n, dim, P);
    for (int i = 0; i <= n; i++)
        for (int c = 0; c < dim; c++)
            R[i * dim + c] = P[(n - i) * dim + c];
    G(shape_point)(n, dim, P, beta, t, at);
    G(shape_point)(n, dim, R, beta, T->planted ? t : sub(from_int(1), t), back);
    for (int c = 0; c < dim; c++)
        same(T, back[c], at[c]);
}

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

CLAIM(curve_moves_with_its_points)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], R[(MAX_DEGREE + 1) * dim], M[dim * dim], v[dim], at[dim], moved[dim];
    num beta = G(any_beta)(T), t = parameter(T, "t");
    G(free_points)(T, n, dim, P);
    G(free_map)(T, M, v);
    for (int i = 0; i <= n; i++)
        for (int c = 0; c < dim; c++)
            R[i * dim + c] = T->planted && i == n ? P[i * dim + c] : G(image)(M, v, from_int(1), P + i * dim, c);
    G(shape_point)(n, dim, P, beta, t, at);
    G(shape_point)(n, dim, R, beta, t, moved);
    for (int c = 0; c < dim; c++)
        same(T, moved[c], G(image)(M, v, from_int(1), at, c));
}

CLAIM(printed_curve_follows_linear_maps_only)
{
    num P[8 * dim], R[8 * dim], M[dim * dim], v[dim], at[dim], moved[dim];
    num beta = G(any_beta)(T), t = parameter(T, "t"), one = from_int(1);
    G(free_points)(T, 7, dim, P);
    G(free_map)(T, M, v);
    for (int i = 0; i <= 7; i++)
        for (int c = 0; c < dim; c++)
            R[i * dim + c] = G(image)(M, v, one, P + i * dim, c);
    G(shape_point_printed)(dim, P, beta, t, at);
    G(shape_point_printed)(dim, R, beta, t, moved);
    num factor = sub(one, mul(from_int(4), mul(beta, G(product_of_powers)(3, 4, t))));
    for (int c = 0; c < dim; c++)
        same(T, moved[c], G(image)(M, v, T->planted ? one : factor, at, c));
}

/*
## Closer to the polygon? (逼近性)

A curve may be near its polygon in several senses: the largest distance of a point of the curve from the polygon; the
largest distance of a control point from the curve; the distance of the point of one $t$.  In the first two senses a larger
$\beta$ can make the curve worse, in the true range of $\beta$ and even for a convex polygon.

:::{statement} deng-zhang-2022:property-3.5
:title: The larger beta, the closer the curve to its polygon
:zh: β 越大越逼近控制多边形
:printed: when $\beta$ grows the curve approximates the control polygon better
:refuted-by: larger_beta_takes_the_curve_away_from_its_polygon larger_beta_is_worse_for_a_convex_polygon
:class: false
:corrected: for fixed $t$ the point moves with $\beta$ evenly on the straight line through it with the direction
  $b_1-(s\,b_0+t\,b_2)$, where $b_0,b_1,b_2$ is level $n-2$ of de Casteljau's triangle; for $-2\le\beta\le1$ it is in the
  triangle $b_0b_1b_2$, its weight at $b_1$ grows and those at $b_0$ and $b_2$ fall; for $n=2$, and in general only then, no
  point moves away from the polygon while $-2\le\beta\le1$
:corrected-by: curve_is_a_blend_of_three_points blend_is_convex_from_minus_two_to_one
  quadratic_distance_to_a_line_shrinks quadratic_distance_to_an_end_shrinks
:figure: closer_or_not
:striking: 11

The first refutation is for both senses at once.  Three points and a cubic are treated in `every-degree`.
:::

:::{statement} deng-zhang-2022:property-3.5-bezier
:title: The curve is closer to its polygon than the Bézier curve of degree seven
:zh: 比七次 Bezier 曲线更优
:printed: the approximation of the control polygon is better than that of the Bézier curve of degree seven
:refuted-by: larger_beta_takes_the_curve_away_from_its_polygon convex_polygon_prefers_the_bezier_curve
:class: false
:corrected: the Bézier curve is $\beta=0$; so for $\beta<0$ the sentence contradicts property 3.5, and for $0<\beta\le1$ it holds
  for some polygons and fails for others, convex ones among them; for $n=2$ it is true for $0<\beta\le1$
:corrected-by: beta_zero_gives_the_bezier_curve quadratic_distance_to_a_line_shrinks quadratic_distance_to_an_end_shrinks
:figure: closer_or_not
:::

:::{statement} deng-zhang-2022:property-3.5-c-bezier
:title: The curve is closer than the C-Bézier curve of degree seven
:zh: 比七次 C-Bezier 曲线更优
:printed: so the curve approximates better than the C-Bézier curve of degree seven
:reading: larger_beta_takes_the_curve_away_from_its_polygon | C-Bézier for Bézier, as the word "so" suggests: false
:reading: C-Bézier curves, built with sines and cosines: neither defined nor compared in the text, so that nothing is there
  to be decided; as their parameter goes to 0 they become Bézier curves

The conclusion "so" has no premise about C-Bézier curves.
:::

:::{claim} larger_beta_takes_the_curve_away_from_its_polygon
:title: A larger beta takes a curve away from its polygon, in two senses at once
:zh: β 增大而曲线远离控制多边形
:kind: counterexample
:given: $P=(-1,-1),(2,0),(2,-2),(1,-2),(1,-2),(0,0),(2,2),(2,1)$, $\beta=0$ and $\beta=1$, corrected functions
:then: for $\beta=0$ every point of the curve is nearer to the polygon than $r$, $r^2=\frac{23}{50}$, for $\beta=1$ some point is
  farther; for $\beta=0$ every control point is nearer to the curve than $R$, $R^2=\frac{21}{25}$, for $\beta=1$ one is farther
:method: Nearer on all of $[0,1]$: the interval is cut until on each piece one edge is near, decided by the signs of three
  polynomials (the foot on the edge, the distance to its line).  Farther: one rational $t$ and all seven edges; for a control
  point the sign of $|q(t)-P_i|^2-R^2$ on $[0,1]$.
:control: the two values of $\beta$ exchanged
:::

:::{claim} larger_beta_is_worse_for_a_convex_polygon
:title: From the left end of the range to its right end a curve goes away from its convex polygon
:zh: 凸多边形:β 由 -21/4 增至 1 时曲线远离多边形
:kind: counterexample
:given: the convex polygon $(-1,-2),(2,0),(3,1),(4,3),(-2,4),(-4,-2),(-4,-3),(-3,-3)$, $\beta=-\frac{21}4$ and $\beta=1$,
  corrected functions
:then: for $\beta=-\frac{21}4$ every point of the curve is nearer to the polygon than 2, for $\beta=1$ some point is farther
:method: As before; `hull.h` decides that the polygon is convex.
:control: the two values of $\beta$ exchanged
:::

:::{claim} convex_polygon_prefers_the_bezier_curve
:title: A convex polygon to which the Bézier curve is closer
:zh: 凸多边形:七次 Bezier 曲线更近
:kind: counterexample
:given: the convex polygon $(-3,-3),(-3,-4),(-2,-4),(5,0),(4,5),(3,5),(2,4),(-2,-1)$, $\beta=0$ and $\beta=1$, corrected functions
:then: for $\beta=0$ every point of the curve is nearer to the polygon than $r$, $r^2=\frac{93}{20}$, for $\beta=1$ some point is
  farther
:method: As before.
:control: the two values of $\beta$ exchanged
:::
*/
#if RATIONAL
CLAIM(larger_beta_takes_the_curve_away_from_its_polygon)
{
    static const int at[] = {-1, -1, 2, 0, 2, -2, 1, -2, 1, -2, 0, 0, 2, 2, 2, 1};
    num P[8 * dim], small = from_int(T->planted), large = from_int(!T->planted), R_squared = from_ratio(21, 25);
    G(integer_points)(8, at, P);
    about(T, "the larger beta is not farther from the polygon");
    agree(T, !G(larger_is_farther)(T, 7, P, from_int(0), from_int(1), from_ratio(23, 50)));
    struct G(path) before = G(path_of)(7, P, small), after = G(path_of)(7, P, large);
    int away_before = 0, away_after = 0;
    for (int i = 0; i <= 7; i++) {
        away_before += G(curve_stays_away)(before, P + i * dim, R_squared);
        away_after += G(curve_stays_away)(after, P + i * dim, R_squared);
    }
    about(T, "no control point is farther from the curve of the larger beta");
    agree(T, !(away_before == 0 && away_after > 0));
}

CLAIM(larger_beta_is_worse_for_a_convex_polygon)
{
    static const int at[] = {-1, -2, 2, 0, 3, 1, 4, 3, -2, 4, -4, -2, -4, -3, -3, -3};
    num P[8 * dim];
    G(integer_points)(8, at, P);
    about(T, "the polygon is not convex, or the larger beta is not farther");
    int worse = G(larger_is_farther)(T, 7, P, from_ratio(-21, 4), from_int(1), from_int(4));
    agree(T, !(polygon_is_convex(7, P, 1, NULL) && worse));
}

CLAIM(convex_polygon_prefers_the_bezier_curve)
{
    static const int at[] = {-3, -3, -3, -4, -2, -4, 5, 0, 4, 5, 3, 5, 2, 4, -2, -1};
    num P[8 * dim];
    G(integer_points)(8, at, P);
    about(T, "the polygon is not convex, or the larger beta is not farther");
    int worse = G(larger_is_farther)(T, 7, P, from_int(0), from_int(1), from_ratio(93, 20));
    agree(T, !(polygon_is_convex(7, P, 1, NULL) && worse));
}
#endif

/*
## Applications (应用实例)

:::{statement} deng-zhang-2022:sec-4-closed
:title: A closed curve when first and last point coincide
:zh: 起点与终点重合得封闭曲线
:printed: when the first and the last point coincide a closed curve is obtained, as with the Bézier curve of degree seven
:holds-by: end_points_and_end_derivatives

The closed curve is smooth at that point only when $P_1$, $P_0=P_7$ and $P_6$ are on a line, $P_0$ between the others.
:::

:::{statement} deng-zhang-2022:fig-3
:title: The petals of closed curves
:zh: 图 3 花瓣图形
:printed: figure 3 shows the closed curves of $\beta=1,0,-1,\dots,-7$
:reading: points_move_evenly_with_beta | the polygon is not given; for any polygon the points of one $t$ on the nine curves
  are on a straight line in equal distances
:figure: petals
:::

:::{statement} deng-zhang-2022:def-5.1
:title: The tensor product surface
:zh: 双八次 β-Bezier 曲面，式 (22)
:printed: $B_1(u,v)=\sum_{i=0}^7\sum_{j=0}^7P_{ij}\hat B_i(u)\hat B_j(v)$, $u,v\in[0,1]$, $-7\le\beta\le1$
:definition: yes
:checked-by: surface_kernel_gives_the_double_sum
:figure: shape_surface

One parameter serves both directions; the kernel has one for each.  The points are in $\mathbb R^d$, $d=2,3$.
:::

:::{statement} deng-zhang-2022:sec-5-properties
:title: The surface has properties like those of the curve
:zh: 曲面具有与曲线类似的性质
:printed: it can be proved that the surface has geometric properties similar to those of the curve
:reading: surface_has_the_corner_points_and_boundary_curves | corners and boundary curves: true, for printed and corrected
  functions, because the functions other than the first and the last vanish at the ends
:reading: surface_functions_sum_to_one | hull and affine maps: true with the corrected functions, for both parameters in the
  true range, resp. all; with the printed ones the sum is $(1-4\beta(1-u)^3u^4)(1-4\beta(1-v)^3v^4)$
:reading: net_of_straight_lines_gives_a_saddle | preservation of convexity: false; the rows and columns of a net may all be
  straight and the surface be a saddle, which is convex to no side, for every $\beta$
:figure: shape_surface
:::

:::{statement} deng-zhang-2022:sec-6-horner
:title: The curve can be computed by Horner's rule
:zh: 海纳算法
:printed: the curve takes more computation than the Bézier curve of degree seven, and can be computed by Horner's rule
:holds-by: horner_rule_computes_the_curve

A curve of degree eight has one term more.  The nine Bézier points have to be computed once for each $\beta$.
:::

:::{statement} deng-zhang-2022:sec-6-meaning
:title: The parameter has a clear geometric meaning
:zh: β 的几何意义
:printed: the geometric meaning of $\beta$ is clear: the larger $\beta$ in $-7\le\beta\le1$, the closer the curve to the control
  polygon
:refuted-by: larger_beta_is_worse_for_a_convex_polygon larger_beta_takes_the_curve_away_from_its_polygon
:class: false
:corrected: $\beta$ moves each Bézier point $Q_k$ on its edge $P_{k-1}P_k$, and each point of the curve on a straight line, evenly
:corrected-by: bezier_points_divide_the_edges points_move_evenly_with_beta curve_is_a_blend_of_three_points
:figure: closer_or_not
:::

:::{statement} deng-zhang-2022:sec-6-features
:title: The curve has the features of the Bézier curve of degree seven
:zh: 具有七次 Bezier 曲线的特征
:printed: end properties, tangency to the end edges, convex hull, symmetry and variation diminution hold as for the Bézier curve
  of degree seven, $-7\le\beta\le1$
:refuted-by: printed_curve_leaves_a_single_point corrected_curve_leaves_the_hull_at_minus_seven
  edge_is_not_tangent_at_minus_seven
:class: false
:corrected: with the corrected functions and $-\frac{21}4\le\beta\le1$ all of them hold
:corrected-by: end_points_and_end_derivatives corrected_functions_sum_to_one nonnegative_exactly_in_the_range
  reversed_polygon_reverses_the_curve totally_positive_exactly_in_the_range
:::

:::{statement} deng-zhang-2022:sec-6-better
:title: The summary on approximation
:zh: 结论中的逼近性
:printed: from the point of view of approximation the curve is better than the Bézier curve of degree seven
:refuted-by: convex_polygon_prefers_the_bezier_curve larger_beta_takes_the_curve_away_from_its_polygon
:class: false
:corrected: for $n=2$ and $0<\beta\le1$ no point is farther from the polygon than the point of the Bézier curve; for $n=7$ it
  depends on the polygon
:corrected-by: quadratic_distance_to_a_line_shrinks quadratic_distance_to_an_end_shrinks
:figure: closer_or_not
:::

:::{statement} deng-zhang-2022:abstract-features
:title: The features that the abstract names
:zh: 摘要所列特性
:printed: the curve has the features of the Bézier curve of degree seven, such as tangency to the end edges, convex hull,
  preservation of convexity and variation diminution
:refuted-by: printed_curve_leaves_a_single_point corrected_curve_leaves_the_hull_at_minus_seven
  edge_is_not_tangent_at_minus_seven curve_of_a_triangle_meets_a_line_three_times
:class: false
:corrected: with the corrected functions and $-\frac{21}4\le\beta\le1$ all of them hold
:corrected-by: end_points_and_end_derivatives corrected_functions_sum_to_one nonnegative_exactly_in_the_range
  totally_positive_exactly_in_the_range
:::

:::{statement} deng-zhang-2022:abstract-better
:title: Better approximation, in the abstract and the introduction
:zh: 摘要与引言中的"更好的逼近性"
:printed: the curve has better adjustability and better approximation than the Bézier curve of degree seven
:refuted-by: convex_polygon_prefers_the_bezier_curve larger_beta_takes_the_curve_away_from_its_polygon
:class: false
:corrected: adjustable it is; whether a curve with $\beta\ne0$ is nearer to its polygon than the one with $\beta=0$ depends on the
  polygon, and for $n=2$, $0<\beta\le1$ it always is at least as near
:corrected-by: points_move_evenly_with_beta quadratic_distance_to_a_line_shrinks quadratic_distance_to_an_end_shrinks
:figure: closer_or_not
:::

:::{statement} deng-zhang-2022:sec-1-unique
:title: Control points and Bernstein polynomials leave no freedom
:zh: 控制顶点与 Bernstein 基唯一确定 Bezier 曲线
:printed: given the control points the Bézier curve is fixed; to change its shape one has to move control points
:holds-by: beta_zero_gives_the_bezier_curve
:::

:::{claim} surface_kernel_gives_the_double_sum
:title: The kernel computes the surface
:zh: 核函数即双重和
:given: degrees $n$ and 2 in the two directions, any points, parameters $\beta$ and $\gamma$, any $u$ and $v$
:then: `shape_surface_point` gives $\sum_i\sum_jP_{ij}B_{i,n}(u)B_{j,2}(v)$
:method: The double sum of the formulas, everything a variable.
:degrees: 2..4 sampled 7
:defines: shape_surface_point
:control: $\beta$ and $\gamma$ exchanged
:::

:::{claim} surface_has_the_corner_points_and_boundary_curves
:title: Corners and boundary curves of the surface
:zh: 曲面的角点与边界曲线
:given: degrees 3 and 2, any points, $\beta$, $\gamma$ and $v$
:then: for $u=0$ and $u=1$ the surface is the curve with the parameter $\gamma$ of the first and of the last row of points;
  the ends of these are the corners
:method: The surface kernel against the formula of the curve; everything a variable.
:control: the second row in the place of the last
:::

:::{claim} surface_functions_sum_to_one
:title: The products of functions add up to one
:zh: 曲面基函数的权性
:given: degrees $7$ and $7$, any $\beta$, $u$ and $v$
:then: the corrected products add up to 1, the printed ones to $(1-4\beta(1-u)^3u^4)(1-4\beta(1-v)^3v^4)$
:method: The double sum of products of the kernels' functions, everything a variable.
:control: the second factor left out
:::

:::{claim} net_of_straight_lines_gives_a_saddle
:title: A net of straight rows and columns whose surface is a saddle
:zh: 行列皆直的控制网生成鞍面
:given: $P_{ij}=(i,j,ij)$, degrees $n$ and $n$, any $\beta$, $u$ and $v$
:then: the surface satisfies $z=xy$: it lies on a hyperbolic paraboloid, which is convex to no side
:method: The three coordinates by the surface kernel, $\beta$, $u$, $v$ variables.
:degrees: 2..5 sampled 7
:control: the corner $P_{00}$ moved to $(1,0,0)$
:::

:::{claim} horner_rule_computes_the_curve
:title: Horner's rule on the nine Bézier points gives the curve
:zh: Horner 法则求曲线上的点
:given: points $P_0,\dots,P_n$ of the plane, any $\beta$ and $t$
:then: `horner_bernstein` with the points of `shape_bezier_points` gives $\sum P_iB_{i,n}(t)$
:method: Kernels against the formula, everything a variable.
:degrees: 2..7 sampled 14
:control: $t$ and $1-t$ exchanged
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
            sum = add(sum, mul(P[i * 3 + j], mul(G(corrected)(n, i, beta, u), G(corrected)(2, j, gamma, v))));
        }
    G(shape_surface_point)(n, 2, 1, P, T->planted ? gamma : beta, T->planted ? beta : gamma, u, v, &at);
    same(T, at, sum);
}

CLAIM(surface_has_the_corner_points_and_boundary_curves)
{
    num P[4 * 3], at, beta = G(any_beta)(T), gamma = unknown(T, "gamma", 0), v = parameter(T, "v");
    for (int m = 0; m < 4 * 3; m++)
        P[m] = unknown(T, "z", m);
    for (int end = 0; end <= 1; end++) {
        int row = end == 0 ? 0 : T->planted ? 1 : 3;
        G(shape_surface_point)(3, 2, 1, P, beta, gamma, from_int(end), v, &at);
        same(T, at, G(corrected_curve)(2, 1, P + row * 3, 0, gamma, v));
        for (int corner = 0; corner <= 1; corner++) {
            G(shape_surface_point)(3, 2, 1, P, beta, gamma, from_int(end), from_int(corner), &at);
            same(T, at, P[row * 3 + 2 * corner]);
        }
    }
}

CLAIM(surface_functions_sum_to_one)
{
    num beta = G(any_beta)(T), u = parameter(T, "u"), v = parameter(T, "v"), one = from_int(1), four = from_int(4);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        num U[8], V[8], in_u = from_int(0), in_v = from_int(0);
        if (printed_ones) {
            G(shape_basis_printed)(beta, u, U);
            G(shape_basis_printed)(beta, v, V);
        } else {
            G(shape_basis)(7, beta, u, U);
            G(shape_basis)(7, beta, v, V);
        }
        for (int i = 0; i <= 7; i++) {
            in_u = add(in_u, U[i]);
            in_v = add(in_v, V[i]);
        }
        num first = sub(one, mul(four, mul(beta, G(product_of_powers)(3, 4, u))));
        num second = T->planted ? one : sub(one, mul(four, mul(beta, G(product_of_powers)(3, 4, v))));
        same(T, mul(in_u, in_v), printed_ones ? mul(first, second) : one);
    }
}

CLAIM(net_of_straight_lines_gives_a_saddle)
{
    int n = T->degree;
    num P[8 * 8 * 3], at[3], beta = G(any_beta)(T), u = parameter(T, "u"), v = parameter(T, "v");
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j++) {
            num *point = P + (i * (n + 1) + j) * 3;
            point[0] = from_int(T->planted && i + j == 0 ? 1 : i);
            point[1] = from_int(j);
            point[2] = from_int(i * j);
        }
    G(shape_surface_point)(n, n, 3, P, beta, beta, u, v, at);
    same(T, at[2], mul(at[0], at[1]));
}

CLAIM(horner_rule_computes_the_curve)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], Q[(MAX_DEGREE + 1) * dim], at[dim], beta = G(any_beta)(T), t = parameter(T, "t");
    G(free_points)(T, n, dim, P);
    G(shape_bezier_points)(n, dim, P, beta, Q);
    G(horner_bernstein)(n + 1, dim, Q, T->planted ? sub(from_int(1), t) : t, at);
    for (int c = 0; c < dim; c++)
        same(T, at[c], G(corrected_curve)(n, dim, P, c, beta, t));
}
#include "chapters/frame/claims_off.h"
