/*
# Closed curves, surfaces, and the summary (封闭曲线、曲面与结论)

:::{statement} deng-zhang-2022:sec-4-closed
:title: A closed curve when first and last point coincide
:zh: 起点与终点重合得封闭曲线
:printed: when the first and the last point coincide a closed curve is obtained, as with the Bézier curve of degree seven
:holds-by: end_points_and_end_derivatives
:figure: petals

For $\beta\ne-7$ and end edges that are not 0 its tangent is continuous at that point exactly when $P_1$, $P_0=P_7$ and $P_6$ are on a
line, $P_0$ between the others.  At $\beta=-7$ the first derivatives at the ends are 0, and the second ones give the tangents.
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
:holds-by: horner_rule_computes_the_curve degree_eight_takes_more_operations
:hypothesis: horner_for_nine_points_beats_de_casteljau_for_eight | both curves are computed by the same method
:figure: operations_for_a_point

By Horner's rule the degree $n$ takes $2(d+1)n$ products and $dn+1$ sums for $d$ coordinates, by de Casteljau's algorithm $dn(n+1)$ products
and $\frac12dn(n+1)+n$ sums; here $n=8$ against $n=7$.  In addition the nine Bézier points have to be computed once for each $\beta$.
For $\beta=0$ the curve is the one of degree seven, and whoever knows it has no more to compute.
:::

:::{statement} deng-zhang-2022:sec-6-meaning
:title: The parameter has a clear geometric meaning
:zh: β 的几何意义
:printed: the geometric meaning of $\beta$ is clear: the larger $\beta$ in $-7\le\beta\le1$, the closer the curve to the control
  polygon
:refuted-by: larger_beta_takes_the_curve_away_from_its_polygon larger_beta_is_worse_for_a_convex_polygon
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
:corrected: with the corrected functions and $-\frac{21}4<\beta\le1$ all of them hold, tangency to the end edges that are not 0; at
  $\beta=-\frac{21}4$ too, but variation diminution only for crossings
:corrected-by: end_points_and_end_derivatives corrected_functions_sum_to_one nonnegative_exactly_in_the_range
  reversed_polygon_reverses_the_curve totally_positive_exactly_in_the_range averages_between_neighbours_keep_sign_changes
  roots_are_at_most_sign_changes functions_are_independent_but_for_two_values
:figure: ranges_of_beta
:::

:::{statement} deng-zhang-2022:sec-6-better
:title: The summary on approximation
:zh: 结论中的逼近性
:printed: from the point of view of approximation the curve is better than the Bézier curve of degree seven
:refuted-by: convex_polygon_prefers_the_bezier_curve larger_beta_takes_the_curve_away_from_its_polygon
:class: false
:corrected: for $n=2$ and $0<\beta\le1$ no point is farther from the polygon than the point of the Bézier curve; for $n=7$,
  $\beta=1$ it depends on the polygon
:corrected-by: quadratic_distance_to_a_line_shrinks quadratic_distance_to_an_end_shrinks convex_polygon_prefers_beta_one
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
:corrected: with the corrected functions and $-\frac{21}4<\beta\le1$ all of them hold, tangency to the end edges that are not 0,
  convexity in the sense of property 3.7, for polygons convex when closed and not on a line; at $\beta=-\frac{21}4$ too, but variation
  diminution only for crossings
:corrected-by: end_points_and_end_derivatives corrected_functions_sum_to_one nonnegative_exactly_in_the_range
  totally_positive_exactly_in_the_range averages_between_neighbours_keep_sign_changes roots_are_at_most_sign_changes
  four_vertices_of_a_convex_polygon_do_not_alternate functions_are_independent_but_for_two_values
:figure: ranges_of_beta
:::

:::{statement} deng-zhang-2022:abstract-better
:title: Better approximation, in the abstract and the introduction
:zh: 摘要与引言中的"更好的逼近性"
:printed: the curve has better adjustability and better approximation than the Bézier curve of degree seven
:refuted-by: convex_polygon_prefers_the_bezier_curve larger_beta_takes_the_curve_away_from_its_polygon
:class: false
:corrected: adjustable it is, but for the polygons of `abstract-adjustable`; whether the curve of $\beta=1$ is nearer to its
  polygon than that of $\beta=0$ depends on the polygon; for $n=2$, $0<\beta\le1$ it is at least as near
:corrected-by: points_move_evenly_with_beta convex_polygon_prefers_beta_one quadratic_distance_to_a_line_shrinks quadratic_distance_to_an_end_shrinks
:figure: closer_or_not
:::

:::{statement} deng-zhang-2022:sec-1-unique
:title: Control points and Bernstein polynomials leave no freedom
:zh: 控制顶点与 Bernstein 基唯一确定 Bezier 曲线
:printed: given the control points the Bézier curve is fixed; to change its shape one has to move control points
:holds-by: beta_zero_gives_the_bezier_curve
:figure: curves_for_several_beta
:::

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
:degrees: 2..6 sampled 7
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

:::{claim} degree_eight_takes_more_operations
:title: A point of a curve of degree eight takes more operations than one of degree seven
:zh: 八次曲线上点的运算次数多于七次
:kind: decision
:given: the degrees 7 and 8, one to three coordinates $d$; `horner_bernstein` and `decasteljau`
:then: with $n$ for the degree, Horner's rule takes $2(d+1)n$ products and $dn+1$ sums, de Casteljau's algorithm $dn(n+1)$ and
  $\frac12dn(n+1)+n$; all are more for $n=8$ than for $n=7$
:method: The kernels are run in the number type that counts; products with powers of two are counted with the others.
:scope: one to three coordinates
:control: the degree 7 in both places
:::

:::{claim} horner_for_nine_points_beats_de_casteljau_for_eight
:title: Horner's rule for degree eight takes fewer operations than de Casteljau's algorithm for degree seven
:zh: 不同算法之间八次反而更省
:kind: counterexample
:given: the plane; `horner_bernstein` in degree 8, `decasteljau` in degree 7
:then: 48 products against 112, and 17 sums against 63
:method: The kernels are run in the number type that counts.
:control: `decasteljau` in degree 8
:::
*/
#include "chapters/shape-parameter/definition.h"

#if RATIONAL
#include "chapters/frame/counting.h"

/* The kernels of Bézier curves once more in the number type that counts. */
#undef G
#define G(name) name##_c
#include "core/bezier.tmpl.h"
#undef G
#define G(name) name##_q
#endif

#include "chapters/frame/claims_on.h"

enum { dim = 2 }; /* the plane: every formula is taken coordinate by coordinate */

static num G(any_beta)(trial *T) { return unknown(T, "beta", 0); }

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
    (method == HORNER ? horner_bernstein_q : decasteljau_q)(n, coordinates, x, t, at);
    counted = (struct operations){0};
    (method == HORNER ? horner_bernstein_c : decasteljau_c)(n, coordinates, b, some_number, P);
    note_cost(coordinates, at, counted);
    return counted;
}
static int products(struct operations cost) { return cost.multiplications + cost.shifts; }

CLAIM(degree_eight_takes_more_operations)
{
    for (int d = 1; d <= 3; d++) {
        for (int n = 7; n <= 8; n++) {
            struct operations horner = cost_of_point(T, HORNER, n, d), triangle = cost_of_point(T, DE_CASTELJAU, n, d);
            agree(T, products(horner) == 2 * (d + 1) * n && horner.additions == d * n + 1);
            agree(T, products(triangle) == d * n * (n + 1) && 2 * (triangle.additions - n) == d * n * (n + 1));
        }
        for (enum method method = HORNER; method <= DE_CASTELJAU; method++) {
            struct operations eight = cost_of_point(T, method, T->planted ? 7 : 8, d);
            struct operations seven = cost_of_point(T, method, 7, d);
            agree(T, products(eight) > products(seven) && eight.additions > seven.additions);
        }
    }
}

CLAIM(horner_for_nine_points_beats_de_casteljau_for_eight)
{
    struct operations eight = cost_of_point(T, T->planted ? DE_CASTELJAU : HORNER, 8, dim);
    struct operations seven = cost_of_point(T, DE_CASTELJAU, 7, dim);
    show_text(T, "degree 8", "%d products, %d sums", products(eight), eight.additions);
    show_text(T, "degree 7", "%d products, %d sums", seven.multiplications + seven.shifts, seven.additions);
    about(T, "whether degree 8 takes more products and more sums");
    agree(T, products(eight) > products(seven) && eight.additions > seven.additions);
}
#endif
#include "chapters/frame/claims_off.h"
