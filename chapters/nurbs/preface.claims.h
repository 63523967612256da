/*
# Why NURBS curves (本章引言)

A NURBS curve is a quotient of splines, as a rational Bézier curve is a quotient of polynomials.  The preface of the
chapter gives the reasons for it: it is adjusted locally, its order of continuity is adjustable, it represents conics
exactly, and its special cases are the curves of the chapters before.  Then it compares two ways of computing it.  What of
this can be computed is decided here.
*/
#if RATIONAL
#include "chapters/nurbs/counting.h"
#define G(name) name##_q
#endif

#include "chapters/nurbs/definition.h"
#include "chapters/nurbs/discrete.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch4:preface-generalization
:title: Piecewise polynomial generalises to piecewise rational
:zh: 由分段多项式推广到分段有理多项式
:printed: As the polynomial Bézier curve was generalised to the rational one of the chapter before, the nonuniform B-spline curve, a piecewise polynomial, is
  generalised to the piecewise rational NURBS curve
:holds-by: nurbs_point_is_the_weighted_mean
:confirmed-by: equal_weights_give_bezier_curve
:reading: nurbs_point_is_the_weighted_mean | the construction is generalised, from the curve to its projection: a NURBS curve is the quotient of two sums like the one sum of a
  B-spline curve
:reading: equal_weights_give_bspline | the curves are: the B-spline curves are NURBS curves, those with equal weights
:figure: nurbs_circle

Numerator and denominator are piecewise polynomials, being sums of the $N_{i,k}$ with constant factors.  That Bézier curves are rational ones in the same way is
`equal_weights_give_bezier_curve`.
:::

:::{statement} wang-ch4:preface-special-case-bspline
:title: B-spline curves are special cases of NURBS
:zh: B 样条曲线为 NURBS 的特例
:printed: B-spline curves are one of the two special cases of NURBS curves that the chapters before have treated
:holds-by: equal_weights_give_bspline
:figure: nurbs_circle
:::

:::{statement} wang-ch4:preface-special-case-bezier
:title: Rational Bézier curves are special cases of NURBS
:zh: 有理 Bézier 曲线为 NURBS 的特例
:printed: rational Bézier curves are one of the two special cases of NURBS curves that the chapters before have treated
:holds-by: bezier_knots_give_rational_bezier
:figure: nurbs_circle
:::

:::{statement} wang-ch4:preface-geometric-definition
:title: A geometric definition in the place of the recursion
:zh: 由包络的存在唯一性给出几何定义
:printed: One usually defines NURBS curves by the recursion of de Boor and Cox, but it lacks an intuitive geometric meaning; from the existence and
  uniqueness of the envelope of families of NURBS curves we give an entirely new, intuitive geometric definition of them, for the first time in the world; it is a
  powerful tool for their study
:reading: member_of_span_touches_curve | that the curve is an envelope of its families, as theorem 4.3.1 has it, where $\mathbf r'\ne0$
:reading-with: envelope_condition_holds_on_the_diagonal
:reading: convex_quartic_of_span_has_second_envelope | that the envelope of every such family is unique, as theorem 4.3.3 has it
:reading: that the recursion lacks an intuitive meaning, and that the definition is a powerful tool: opinions; a geometric meaning it has, for points, by
  algorithm 4.1.1: every level divides the edges of the one before
:reading: that one usually defines the curves by the recursion, and that nobody gave such a definition before: history, which no computation decides
:confirmed-by: every_level_divides_its_edges
:figure: deboor_triangle
:::

:::{statement} wang-ch4:preface-discrete
:title: Convexity and variation diminution are seen from the discrete curves
:zh: 以离散 NURBS 曲线为工具
:printed: One is used to computing with NURBS in homogeneous coordinates, but in these it is hard to infer their geometric properties in the
  three-dimensional world; we analyse its discrete structure: with the discrete NURBS curve as a tool, that convexity is kept and variation diminished is obvious
:reading: insertion_cuts_the_corners | that the discrete curves cut corners, in the space of the curve
:reading: polygon_that_turns_back_loses_convexity | that convexity is kept for every polygon that is convex by the letter of definition 4.2.1
:reading: cut_corners_meet_a_line_no_more | that variation is diminished when a corner is cut: polygons with the corner cut have no more in common with a line,
  an edge or vertices on the line counting once
:reading: insertion_turns_like_its_triangles | that homogeneous coordinates show the turn, too: by the determinants of three
  points of the plane it is seen in which sense their triangles turn, and that an insertion keeps it where all turn one way
:reading: that it is hard there and obvious here: opinions.
:figure: cutting_corners
:::

:::{statement} wang-ch4:preface-local-control
:title: The shape is locally adjustable
:zh: 形状局部可调
:printed: NURBS curves have the merit of B-spline curves that their shape can be adjusted locally
:holds-by: moved_point_changes_its_support
:figure: local_control
:::

:::{statement} wang-ch4:preface-continuity
:title: The order of continuity is adjustable
:zh: 连续阶数可调
:printed: NURBS curves have the merit of B-spline curves that their order of continuity can be adjusted
:holds-by: sides_agree_up_to_order_less_multiplicity
:meant: the word merit, as only an order that is guaranteed is one | An order of continuity that
  every such curve has.
:reading: nurbs_sides_agree | for the rational curve itself, its curvature and its torsion, where there are any
:reading: one_order_more_jumps | that every curve is continuous of one order more
:needs: negative_weight_makes_a_pole | definition 4.1.1: $w_i>0$ | the weights are positive: so that $w(t)\ne0$
:argued: | The derivatives of $P/w$ up to an order are rational functions of those of $P$ and $w$ up to it, and the divisor is a
  power of $w>0$.
:figure: knot_sides
:::

:::{statement} wang-ch4:preface-conics
:title: Rational Bézier curves, and so NURBS, represent conics exactly
:zh: 可精确表示圆锥曲线
:printed: NURBS curves have as well the property of rational Bézier curves that they can represent conic sections exactly
:holds-by: tangent_conics_are_curves_of_order_three conics_touching_two_lines_are_limings
:confirmed-by: tangent_conics_are_rational_quadratics bezier_knots_give_rational_bezier circle_is_a_nurbs_curve
  circle_is_run_through_once
:argued: | About any point of an ellipse, parabola or hyperbola there are two tangents that meet, and the frame of their two points and
  of the point where they meet may be any triangle, as an affine map takes one into the other.  For points near one another the arc between them is inside the triangle, so that $\nu/\mu<0$ and the
  weights are positive; the curve goes from one to the other without leaving the conic and the triangle, and so all along the arc.
:reading: ellipse_carries_no_polynomial_arc | as an advantage over B-spline curves, for ellipses: a polynomial arc on an ellipse is
  a point | A polynomial that is 0 for infinitely many $t$ is 0, and so is the coefficient of its highest power.
:reading: parabola_arcs_are_quadratic | for the parabola it is no advantage: polynomials of degree two run through it
:figure: nurbs_circle

A whole circle is one NURBS curve of order three with rational points and weights, over two threefold knots and three double ones between them, whatever their values are.
:::
*/

/*
:::{claim} tangent_conics_are_curves_of_order_three
:title: A conic that touches two sides of a triangle at their ends has its arc inside as a NURBS curve of order 3
:zh: 切于三角形两边端点的二次曲线,其三角形内的弧是三阶 NURBS 曲线
:given: numbers $\mu$ and $\nu$; order three, $n=3$, knots $x_0,x_1^2,x_2^2,x_3$, variables; the points $(1,0)$, $(0,0)$, $(0,1)$ with the weights
  $1,1,-\frac{4\nu}\mu$; any $t$
:where: the conic is no pair of lines; $w(t)\ne0$
:then: $\mu\,xy+\nu(x+y-1)^2=0$ with the coordinates $x,y$ of $r(t)$
:method: The point of the curve from the definition, all terms, put into the equation of the conic.  If there is an arc inside the
  triangle, it has $xy>0$, so that $\nu/\mu<0$, and the three weights are positive; else the last weight is negative.
:degrees: 2..2
:over: m: μ; k: ν; x#: knots
:control: the last weight $-2\nu/\mu$
:::
*/
CLAIM(tangent_conics_are_curves_of_order_three)
{
    enum { p = 2, n = 3 };
    int place[MOST_KNOTS];
    num zero = from_int(0), one = from_int(1), x[4], u[MOST_KNOTS], P[2];
    num mu = positive(T, "m", 0), nu = positive(T, "k", 0), t = parameter(T, "t");
    num R[2 * n] = {one, zero, zero, zero, zero, one};
    num w[n] = {one, one, mul(from_int(fault(T, -4, -2)), div(nu, mu))};
    G(distinct_knots)(T, 4, 6, x);
    G(knots_at)("1221", x, u, place);
    G(nurbs_by_definition)(n, p, 2, u, place, R, w, 1, t, P);
    num s = sub(add(P[0], P[1]), one);
    vanishes(T, add(mul(mu, mul(P[0], P[1])), mul(nu, mul(s, s))));
}

/*
Polynomials of degree two draw parabolas and straight lines, and no polynomial draws an arc of a circle at all. With weights nine points draw the whole
circle. The distinct knots may be any numbers, since each quarter is a conic for itself. That the points lie on the circle is not yet that the circle is run through; the claim after it says that.

:::{claim} circle_is_a_nurbs_curve
:title: A whole circle as one quadratic NURBS curve
:zh: 整圆可表为一条二次 NURBS 曲线
:given: order three, knots $x_0<x_1<\dots$, variables, as many of each value as `multiplicities` says; points $r$ and weights $w$
:data: multiplicities = "32223"; r = (1,0) (1,1) (0,1) (-1,1) (-1,0) (-1,-1) (0,-1) (1,-1) (1,0); w = 1 1 2 1 1 1 2 1 1
:instead: w = 1 1 1 1 1 1 1 1 1
:then: $x(t)^2+y(t)^2=1$ on each interval, and the ends are one point
:method: The point of the curve from the definition, all terms, at a variable $t$.
:control: the weights 1
:::
*/
CLAIM(circle_is_a_nurbs_curve)
{
    enum { p = 2, n = 9, count = n + p + 1, quarters = 4, dim = 2 };
    num x[quarters + 1], u[count], R[n * dim], w[n], P[dim], end[dim], t = unknown(T, "t", 0);
    int place[count];
    G(distinct_knots)(T, quarters + 1, 6, x);
    G(knots_at)(given_text(T, "multiplicities"), x, u, place);
    given_points(T, "r", n, dim, R);
    given_points(T, "w", n, 1, w);
    for (int interval = 0; interval < quarters; interval++) {
        G(nurbs_by_definition)(n, p, dim, u, place, R, w, interval, t, P);
        same(T, add(mul(P[0], P[0]), mul(P[1], P[1])), from_int(1));
    }
    about(T, "the ends");
    G(nurbs_by_definition)(n, p, dim, u, place, R, w, 0, x[0], P);
    G(nurbs_by_definition)(n, p, dim, u, place, R, w, quarters - 1, x[quarters], end);
    for (int c = 0; c < dim; c++)
        same(T, P[c], end[c]);
}

/*
:::{claim} circle_is_run_through_once
:title: The curve runs once around the circle, never back
:zh: 曲线沿圆恰好绕行一周
:given: order three, knots $x_0<x_1<\dots$ as many of each value as `multiplicities` says, points $r$ and weights $w$; $t=x_m+(x_{m+1}-x_m)\frac s{1+s}$, $s>0$, in each interval
:data: multiplicities = "32223"; r = (1,0) (1,1) (0,1) (-1,1) (-1,0) (-1,-1) (0,-1) (1,-1) (1,0); w = 1 1 2 1 1 1 2 1 1
:instead: r = (1,0) (1,-1) (0,-1) (-1,-1) (-1,0) (-1,1) (0,1) (1,1) (1,0)
:then: $x\,y'-y\,x'>0$; inside each quarter $x$ and $y$ have the signs of the middle one of its three points; and the quarters begin and end in every
  second point, from $r_1$ to $r_n$
:method: The point and its derivative by the kernel; the cross product, and $x$ and $y$ times these signs, have positive coefficients only in $s$ and the gaps of
  the knots.  So the angle grows, on each quarter within one quadrant and from one axis to the next.
:over: s: ratio in which t divides its interval
:control: the points taken in the opposite order
:::
*/
CLAIM(circle_is_run_through_once)
{
    enum { p = 2, n = 9, count = n + p + 1, quarters = 4, dim = 2 };
    num x[quarters + 1], u[count], R[n * dim], w[n], D[2 * dim], part = inside(T, "s");
    int place[count];
    G(increasing_knots)(T, quarters + 1, 6, x);
    G(knots_at)(given_text(T, "multiplicities"), x, u, place);
    given_points(T, "r", n, dim, R);
    given_points(T, "w", n, 1, w);
    for (int interval = 0; interval < quarters; interval++) {
        int mu = G(span_of_interval)(count, place, interval);
        num t = add(x[interval], mul(sub(x[interval + 1], x[interval]), part));
        G(nurbs_derivatives)(G(nurbs_on_span)(p, dim, u, mu, R, w), t, 1, D);
        about(T, "the angle grows");
        G(must_be_positive)(T, G(cross2)(D, D + dim)); /* x y' - y x' */
        about(T, "the signs of x and y");
        for (int c = 0; c < dim; c++)
            G(must_be_positive)(T, mul(D[c], R[(2 * interval + 1) * dim + c]));
        about(T, "the ends of the quarter");
        for (int end = 0; end < 2; end++) {
            G(nurbs_point)(G(nurbs_on_span)(p, dim, u, mu, R, w), x[interval + end], D);
            for (int c = 0; c < dim; c++)
                same(T, D[c], R[2 * (interval + end) * dim + c]);
        }
    }
}

/*
## How long it takes (时间复杂度)

A recursive formula need not be a slow algorithm. Written out, (4.1.3) contains two terms of the level before, each of which
contains two, and so on: but they are the same terms again and again, and a triangle of $\frac{k(k-1)}2$ numbers is all there is.
The preface confuses the size of the expression with the number of operations; both are counted here.

:::{statement} wang-ch4:preface-complexity-recursion
:title: The time of de Boor's and Boehm's recursions is exponential
:zh: deBoor 与 Boehm 递推的时间复杂度为指数式
:printed: As the recursive algorithm has to be carried out repeatedly, the time complexity [12] of de Boor's formula and of Boehm's knot
  insertion is exponential, compared with the matrix form in the power basis, of which it is polynomial
:refuted-by: recursion_is_not_exponential
:class: false
:corrected: the recursions (4.1.3), (4.1.4) take $c\,\frac{k(k-1)}2$ steps for one point with a constant $c$ that depends on the
  dimension only, and the insertion of one knot, with another such constant, takes $c\,(k-1)$ beside copying: from order $m+1$ to order $2m+1$ they grow less than fourfold, for every $m\ge1$,
  and an exponential does not
:corrected-by: recursion_is_quadratic twice_the_degree_takes_less_than_four_times_the_steps
:meant: the words, which set the algorithm that is carried out against the matrix form; it is algorithm 4.1.1 | The time of computing level after level.
:reading: plain_recursion_doubles | the recursion taken as a formula, in which each $r_i^{[r]}$ is computed again where it
  occurs again: then the time at least doubles with the order
:figure: recursion_steps
:striking: 40
:::
*/

#if RATIONAL
/*
:::{claim} recursion_is_quadratic
:title: The recursion takes k(k-1)/2 times the steps of one division of an edge
:zh: 递推求值的运算次数为阶数的二次式
:kind: decision
:given: the kernels `bspline_deboor` and `nurbs_deboor`, `nurbs_insert`, on the line, in the plane and in space, orders $k=2,\dots,17$
:then: with $c$ operations for $k=2$, they take $c\,\frac{k(k-1)}2$ for order $k$, and the insertion takes
  $c\,(k-1)$; $c$ is another number for another dimension
:method: The kernels, which never look at a number, run on numbers that count.
:degrees: 1..16
:scope: one, two and three coordinates
:argued: every k and every dimension | The loops are over $r=1,\dots,k-1$ and the $k-r$ points of level $r$, each point with the same operations, which are
  so many for each coordinate.
:control: the number of operations taken as $c\,(k-1)$ for a point and as $c\,k$ for an insertion
:::
*/
CLAIM(recursion_is_quadratic)
{
    int p = T->degree;
    for (int dim = 1; dim <= counted_coordinates; dim++) {
        long unit[3], cost[3], tree;
        counted_work(1, dim, unit, &tree);
        counted_work(p, dim, cost, &tree);
        for (int way = 0; way < 2; way++)
            agree(T, 2 * cost[way] == unit[way] * p * fault(T, p + 1, 2));
        agree(T, cost[2] == unit[2] * fault(T, p, p + 1));
        agree(T, unit[0] > 0 && unit[1] > 0 && unit[2] > 0);
    }
}

#endif

/*
:::{claim} twice_the_degree_takes_less_than_four_times_the_steps
:title: From order m+1 to order 2m+1 a number of steps c k(k-1)/2 grows less than fourfold
:zh: 阶数由 m+1 增至 2m+1 时步数不足四倍
:types: field rational
:given: $m\ge1$, the steps $c\,\frac{k(k-1)}2$ for order $k$, or $c\,(k-1)$, with $c>0$; all variables
:then: $4\,c\,\frac{(m+1)m}2-c\,\frac{(2m+1)\,2m}2=c\,m>0$, and $2m=2\cdot m$: the first are less than four times, the second twice as many
:method: Identities in $m$ and $c$.  Exponential time multiplies by a fixed factor $a>1$ with each order, so by $a^m$ from order $m+1$ to order $2m+1$, which is more than $4$ for
  great $m$.
:harmless: $c>0$ | it is a number of operations
:degrees: all
:over: m c: -
:control: three times in the place of four
:::
*/
CLAIM(twice_the_degree_takes_less_than_four_times_the_steps)
{
    num m = whole(T, "m", 1, 99), c = positive(T, "c", 0), one = from_int(1), two = from_int(2), more = add(m, m);
    num here = div(mul(c, mul(add(m, one), m)), two), there = div(mul(c, mul(add(more, one), more)), two);
    about(T, "a point");
    same(T, sub(mul(from_int(fault(T, 4, 3)), here), there), mul(c, m));
    about(T, "an insertion");
    same(T, mul(c, more), mul(two, mul(c, m)));
}

#if RATIONAL
/*
:::{claim} recursion_is_not_exponential
:title: De Boor's algorithm of order 17 is far below the smallest doubling
:zh: 十七阶 deBoor 算法的运算次数远小于指数值
:kind: counterexample
:given: one point of a plane curve in homogeneous coordinates, of the orders $k$ and $k'$
:data: k = 9; k' = 17
:then: doubling with each order means $2^{k'-k}$ times the steps for $k$, and the steps for $k'$ are fewer
:result: operations, order k = 504; operations, order k' = 1904; plain recursion, order k = 6885; plain recursion, order k' = 1769445
:method: The steps are counted in the kernel.  Other factors than 2 are the matter of the corrected statement.
:control: the plain recursion, in which everything is computed again
:::
*/
CLAIM(recursion_is_not_exponential)
{
    int k[2] = {given_whole(T, "k"), given_whole(T, "k'")};
    long cost[2][3], tree[2];
    for (int m = 0; m < 2; m++)
        counted_work(k[m] - 1, 2, cost[m], &tree[m]);
    found_whole(T, "operations, order k", (int)cost[0][0]);
    found_whole(T, "operations, order k'", (int)cost[1][0]);
    found_whole(T, "plain recursion, order k", (int)tree[0]);
    found_whole(T, "plain recursion, order k'", (int)tree[1]);
    about(T, "with each order the number of operations doubles at least");
    long factor = 1L << (k[1] - k[0]);
    agree(T, fault(T, tree[1] >= factor * tree[0], cost[1][0] >= factor * cost[0][0]));
}

/*
:::{claim} plain_recursion_doubles
:title: Without keeping what it has computed the recursion doubles with every order
:zh: 不保留中间结果的递归随阶数加倍
:kind: decision
:given: de Boor's formula for orders $k=2,\dots,17$, written out in full
:then: from order $k$ to $k+1$ the number of operations at least doubles
:method: The number of operations of the expression, common parts counted as often as they occur.
:degrees: 1..16
:argued: every k | The formula for $r^{[r]}$ contains two expressions $r^{[r-1]}$ of the level before.
:control: the number of operations of a program that keeps what it has computed
:::
*/
CLAIM(plain_recursion_doubles)
{
    long cost[2][3], tree[2];
    counted_work(T->degree, 2, cost[0], &tree[0]);
    counted_work(T->degree + 1, 2, cost[1], &tree[1]);
    agree(T, fault(T, tree[1] >= 2 * tree[0], cost[1][0] >= 2 * cost[0][0]));
}

/*
The praise that follows is justified, and the reason can be stated. Cancellation is dangerous where numbers are subtracted that
carry errors already. The recursions subtract knots and parameters, which are given; from there on, with positive weights and $t$
in its interval, they only add, multiply and divide numbers of one sign.

:::{statement} wang-ch4:preface-stability
:title: De Boor's and Boehm's recursions compute stably and simply
:zh: deBoor 与 Boehm 递推计算稳定而简单
:printed: De Boor's recursion and Boehm's insertion of a knot are main tools for the evaluation, the conversion and the like of NURBS; their merit is
  that the computation is stable and simple
:holds-by: recursion_subtracts_data_only weights_of_levels_are_positive divisors_contain_the_span insertion_ratios_are_between_zero_and_one
:meant: the word stable, which is used of computations with roundings | The rounded result is the exact one for points and weights that were changed relatively by a few
  roundings, how many depending on the order alone and not on the knots.
:reading: that they are simple, and main tools: opinions.
:needs: weight_of_a_level_may_vanish | definition 4.1.1: $w_i>0$ | the weights are positive: with
  weights of both signs a weight of a level may be a difference, even $0$
:needs: weight_of_a_level_vanishes_outside_the_interval | algorithm 4.1.1: $t\in[t_i,t_{i+1})$, whose $i$ is the $j$ of `alg-4.1.1-interval` | $t$ is in the interval: outside it a weight of a level may be a difference of
  positive weights, even $0$
:argued: | That few roundings reach the result, and that no computed number is subtracted, is counted.  That the rounded
  result is then the exact one for data that were changed relatively by so many factors $1\pm u$, and that this is what stable
  means, is said in words.
:figure: deboor_triangle
:::

:::{claim} recursion_subtracts_data_only
:title: The recursions subtract data only, and few roundings reach the result
:zh: 递推仅对原始数据作减法,舍入误差有界
:kind: decision
:given: the kernels `bspline_deboor` on homogeneous points, `nurbs_deboor` and `nurbs_insert`, in the plane and in space, orders $k=2,\dots,17$
:then: no number is subtracted that was itself computed; from a datum to the result there are at most $5(k-1)$ roundings for homogeneous
  points, $(k-1)(5k+2)$ for points with weights, and $12$ for the insertion
:method: The kernels on numbers that count.  For $t$ in the interval the differences $t-t_i$, $t_{i+k-r}-t$ and $t_{i+k-r}-t_i$ are not
  negative, each with one rounding; everything else is products, quotients and sums.  So the result is the sum of
  the points times their shares, $N_{i,k}(t)$ or $N_{i,k}(t)w_i/w(t)$, with each term changed by at most that many factors $1\pm u$ or their reciprocals, $u$ the unit of rounding.
:degrees: 1..16
:scope: curves of the plane and of space
:argued: every order | Level $r$ adds $5$ roundings, with weights $10r+2$, as each of its points is computed with the same operations.
:control: four roundings a level
:::
*/
CLAIM(recursion_subtracts_data_only)
{
    int k = T->degree + 1, homogeneous = fault(T, 5, 4) * (k - 1);
    struct counted_way way[3];
    long tree;
    for (int dim = 2; dim <= 3; dim++) {
        counted_ways(k - 1, dim, way, &tree);
        about(T, "a computed number is subtracted");
        for (int m = 0; m < 3; m++)
            agree(T, !way[m].worst.cancels);
        about(T, "the roundings");
        agree(T, way[0].worst.roundings == homogeneous);
        agree(T, way[1].worst.roundings == (k - 1) * (5 * k + 2));
        agree(T, way[2].worst.roundings == 12);
    }
}
#endif

/*
:::{statement} wang-ch4:preface-complexity-power-basis
:title: The power basis takes polynomial time and suits Horner's rule
:zh: 幂基形式的复杂度为多项式且适于秦九韶-Horner 算法
:printed: The matrix form in the power basis has polynomial time complexity and is suited to the algorithm of Qin
  Jiushao and Horner
:holds-by: horner_takes_two_operations_a_degree matrices_take_polynomial_time
:argued: | Polynomial is a word about all orders, so that the arguments of both steps, and not the orders that were counted, decide it.
:confirmed-by: determinant_written_out_is_factorial
:meant: the word time, which is that of a computation | The time of computing with the matrices, by recursion, by differences, or by determinants in polynomial time, and products.
:figure: recursion_steps

Not meant is to write $\det\mathbf G$ of (4.4.17) out as the sum over permutations that defines it: this has $k!$ terms, by
`determinant_written_out_is_factorial`.
:::
*/

#if FIELD || RATIONAL
/*
:::{claim} horner_takes_two_operations_a_degree
:title: Horner's rule takes k-1 products and k-1 sums
:zh: Horner 算法的运算次数
:types: field rational
:given: $a_0,\dots,a_p$ and $t$, with $p=k-1$
:then: $(\dots(a_pt+a_{p-1})t+\dots)t+a_0$ is $\sum a_jt^j$ and takes $2p$ operations; bringing a span to this form, a
  product with a matrix of $k\times k$ numbers, takes $2k^2-k$ a coordinate, once
:method: The rule against the sum of powers, everything a variable; rule and product on numbers that count.
:degrees: 1..8 sampled 16
:argued: every order | One product and one sum for each power, and $2k-1$ operations for each of the $k$ rows.
:over: a#: coefficients
:control: the coefficients taken in the opposite order
:::
*/
CLAIM(horner_takes_two_operations_a_degree)
{
    int p = T->degree;
    num a[MAX_DEGREE + 1], t = unknown(T, "t", 0), value, sum = from_int(0), power = from_int(1);
    for (int j = 0; j <= p; j++)
        a[j] = unknown(T, "a", j);
    value = a[fault(T, p, 0)];
    for (int j = 1; j <= p; j++)
        value = add(mul(value, t), a[fault(T, p - j, j)]);
    for (int j = 0; j <= p; j++, power = mul(power, t))
        sum = add(sum, mul(a[j], power));
    same(T, value, sum);
#if RATIONAL
    long steps = 0;
    num_n fresh = {.steps = &steps}, counted_value = fresh;
    for (int j = 1; j <= p; j++)
        counted_value = add_n(mul_n(counted_value, fresh), fresh);
    agree(T, steps == 2 * p);
    about(T, "the product with the matrix");
    steps = 0;
    for (int j = 0; j <= p; j++) {
        num_n coefficient = mul_n(fresh, fresh);
        for (int i = 1; i <= p; i++)
            coefficient = add_n(coefficient, mul_n(fresh, fresh));
        (void)coefficient;
    }
    agree(T, steps == (p + 1) * (2 * p + 1)); /* k (2k - 1) */
#endif
}
#endif

#if RATIONAL
/* The terms of a determinant of order n as the sum over permutations, counted one by one: those that take the columns not yet used. */
static long terms_of_determinant(int n, unsigned used, int row)
{
    long terms = row == n;
    for (int c = 0; c < n; c++)
        if (!(used >> c & 1))
            terms += terms_of_determinant(n, used | 1u << c, row + 1);
    return terms;
}

/*
:::{claim} determinant_written_out_is_factorial
:title: A determinant of order k written out has k! terms
:zh: 行列式按定义展开有 k! 项
:kind: decision
:given: the determinant of order $k$ as the sum over permutations
:then: from order $k-1$ to order $k$ the number of terms is multiplied by $k$, so that it is $k!$
:method: The terms are counted one by one, as they are summed.
:degrees: k = 2..8
:argued: every k | The first row offers $k$ columns, and each leaves a determinant of order $k-1$.
:control: the terms of an expansion that keeps what it has computed, twice as many
:::
*/
CLAIM(determinant_written_out_is_factorial)
{
    int k = T->degree;
    agree(T, terms_of_determinant(k, 0, 0) == fault(T, k, k > 2 ? 2 : 1) * terms_of_determinant(k - 1, 0, 0));
}
#endif

#if RATIONAL
/*
:::{claim} matrices_take_polynomial_time
:title: The coefficient matrix takes polynomial time
:zh: 系数矩阵的运算次数为多项式
:kind: decision
:data: c = 4 4 5 5; e = 3 6 4 4
:given: the kernels `bspline_matrix`, by the recursion, `bspline_matrix_by_marsden`, by the second explicit form, and `bspline_matrix_by_differences`, by the first, over simple knots and
  over the $k$-fold ones of Bézier
:then: the first takes at most $4k^3$ operations, the second at most $4k^6$, the third at most $5k^4$ over both
:method: The kernels on numbers that count.
:scope: simple knots, and the $k$-fold ones of Bézier
:degrees: k = 2..17
:argued: every order | The kernels are loops inside loops, at most six deep, each of at most $k+1$ steps.
:control: $k^2$ in the place of each power
:::
*/
CLAIM(matrices_take_polynomial_time)
{
    enum { ways = 4 };
    static const char *const name[ways] = {"by the recursion", "by Marsden's identity", "by differences, simple knots",
                                           "by differences, k-fold knots"};
    long cost[ways];
    num factor[ways], exponent[ways];
    given_points(T, "c", ways, 1, factor);
    given_points(T, "e", ways, 1, exponent);
    counted_matrices(T->degree - 1, cost);
    for (int way = 0; way < ways; way++) {
        num most = factor[way];
        for (int e = 0; compare_q(from_int(e), fault(T, exponent[way], from_int(2))) < 0; e++)
            most = mul(most, from_int(T->degree));
        show(T, name[way], from_int(cost[way]));
        agree(T, compare_q(from_int(cost[way]), most) <= 0);
    }
}
#endif

/*
## Dates and names (引文)

What the preface cites is compared with the list of the literature at the end of the chapter, with the other labels
and references.

:::{statement} wang-ch4:preface-matrices
:title: Who proposed rational B-splines, and who gave which matrix
:zh: 有理 B 样条的由来与前人的系数矩阵表示
:printed: Rational B-splines were first proposed by Versprille [2] and then studied by Piegl [3-7], Tiller [8-10], Li Hua [11] and others, while Choi [12], Grabowski [13]
  and others worked on the matrix of the coefficients of NURBS.  In form the recursions are chains of many formulas and not convenient in theory, the matrix form is concise and clear; so an explicit matrix of NURBS in the power
  basis is needed.  De Boor [14] and Schumaker [15] gave numerical algorithms for it, Cohen and Riesenfeld [16] the matrix
  for uniform knots, Ding and Davies [17] for nonuniform ones, but only of the third degree, Choi [12] and Grabowski [13] for nonuniform knots and any degree
  recursive matrix forms after the algorithms of Boehm and of de Boor, which are still not analytic; we have given two explicit matrix forms of the most general
  case, which help in the theory and the use of representation, evaluation, insertion of knots, elevation and conversion
:reading: both_explicit_matrices_agree | that the two forms of this chapter are the matrix, whatever knots coincide
:reading: that the one form is inconvenient and the other clear, and what the explicit forms help in: opinions.
:reading: as history: no computation decides it; the works are cited with these numbers.
:figure: both_matrices
:::

:::{statement} wang-ch4:preface-step
:title: In STEP, which ISO issued in 1991, NURBS are the only free-form geometry
:zh: 1991 年 ISO 正式颁布的 STEP 标准以 NURBS 为自由曲线曲面的唯一定义
:printed: Because of these merits NURBS are the only definition of free-form curves and surfaces in the STEP standard for the exchange of product data, formally
  issued by ISO in 1991 [1]; and well-known CAD companies, too, build their modelling systems first of all on the mathematical model of NURBS
:reading: as history: no computation decides it.  The work cited for it is an article of 1991 on data exchange with STEP.

That no other kind of curve is needed beside NURBS is not said.  B-spline and rational Bézier curves are among them, see
`preface-special-case-bspline` and `preface-special-case-bezier`.
:::
*/
#include "chapters/judge/claims_off.h"
