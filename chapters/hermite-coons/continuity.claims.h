/*
# A parameter, and what is continuous (参数表示与连续性)

The slides begin with the reasons for a parameter, and with the words for two pieces that meet: $C^k$ when their derivatives
agree, $G^k$ when those by the arc length do.  The words for $k=1$ and $k=2$ are explained by derivatives that are proportional.
For the tangent this is nearly right; for the curvature it is wrong in every way to read it.
*/
#include "chapters/hermite-coons/definition.h"

#if RATIONAL
#include "exact/record/polynomial.h"
#endif

#include "chapters/judge/claims_on.h"

enum { plane = 2, space = 3 };

/*
## Why a parameter

:::{statement} slides-ch4:1-axes
:title: Equations without a parameter depend on the axes
:zh: 非参数方程依赖坐标轴
:printed: $y=f(x)$ and $f(x,y)=0$ belong to the axes and are inconvenient when the coordinates are changed.
:holds-by: turned_graph_is_no_graph
:figure: graphs_and_axes
:::
*/

#if RATIONAL
/*
:::{claim} turned_graph_is_no_graph
:title: A graph that has been turned need not be a graph
:zh: 旋转后不再是函数图形
:kind: decision
:data: x = 1 -1
:result: images = (-1,1) (-1,-1)
:given: two points of $y=x^2$ with the given $x$, turned by a right angle, $(x,y)\mapsto(-y,x)$
:then: they have one $x$ and two different $y$: no $y=f(x)$ contains both
:method: The two images, exactly.
:control: turned by two right angles
:::
*/
CLAIM(turned_graph_is_no_graph)
{
    num x[2], image[2 * plane];
    given_points(T, "x", 2, 1, x);
    for (int k = 0; k < 2; k++) {
        num y = mul(x[k], x[k]);
        image[k * plane] = neg(fault(T, y, x[k]));
        image[k * plane + 1] = fault(T, x[k], neg(y));
    }
    found_points(T, "images", 2, plane, image);
    about(T, "the two x");
    same(T, image[0], image[plane]);
    about(T, "whether the two y differ");
    agree(T, !equal_q(image[1], image[plane + 1]));
}

/*
:::{statement} slides-ch4:1-many-values
:title: Several values in both directions
:zh: 一个自变量对应多个值
:printed: In some coordinates a curve may have several $y$ for some $x$ and several $x$ for some $y$.
:holds-by: circle_has_two_values_each_way
:figure: graphs_and_axes
:::

:::{claim} circle_has_two_values_each_way
:title: The circle has two y for one x and two x for one y
:zh: 圆的多值性
:kind: decision
:data: a = 3/5; b = 4/5
:instead: b = 3/4
:given: $x^2+y^2=1$, the points $(a,\pm b)$ and $(\pm a,b)$
:then: all are on the circle; the first two have one $x$, the last two one $y$
:method: The equation at the four points; the coordinates that differ.
:control: another $b$
:::
*/
CLAIM(circle_has_two_values_each_way)
{
    num a = given(T, "a"), b = given(T, "b"), one = from_int(1);
    num points[4][2] = {{a, b}, {a, neg(b)}, {a, b}, {neg(a), b}};
    for (int k = 0; k < 4; k++)
        same(T, add(mul(points[k][0], points[k][0]), mul(points[k][1], points[k][1])), one);
    about(T, "whether two y belong to one x, and two x to one y");
    agree(T, equal_q(points[0][0], points[1][0]) && !equal_q(points[0][1], points[1][1]));
    agree(T, equal_q(points[2][1], points[3][1]) && !equal_q(points[2][0], points[3][0]));
}
#endif

/*
:::{statement} slides-ch4:1-infinite-slope
:title: Slopes may be infinite
:zh: 斜率无穷大
:printed: Without a parameter an infinite slope may occur.
:holds-by: circle_has_an_upright_tangent
:figure: graphs_and_axes
:::

:::{claim} circle_has_an_upright_tangent
:title: On the circle the derivative is never zero, also where there is no slope
:zh: 圆上竖直切线处导矢有限且非零
:data: R = (1,0) (1,1) (0,1); ω = 1 1 2
:instead: ω = 1 1 1
:result: R'(0) = (0,2)
:given: the quarter circle with the points $R$ and the weights $\omega$; any $t$
:then: $R\cdot R'=0$ and $|R'|=\frac2{1+t^2}$, which is nowhere 0; at $t=0$ the derivative is upright, and there is no slope
:method: Points and derivatives by the rational kernel; the length by its square.
:control: equal weights
:::
*/
CLAIM(circle_has_an_upright_tangent)
{
    num R[3 * plane], w[3], D[2 * plane], one = from_int(1), t = parameter(T, "t");
    given_points(T, "R", 3, plane, R);
    given_points(T, "ω", 3, 1, w);
    num speed = div(from_int(2), add(one, mul(t, t))); /* 2/(1+t^2) */
    G(rational_derivatives)(2, plane, R, w, t, 1, D);
    about(T, "R times R'");
    vanishes(T, add(mul(D[0], D[2]), mul(D[1], D[3])));
    about(T, "the square of the length of R'");
    same(T, add(mul(D[2], D[2]), mul(D[3], D[3])), mul(speed, speed));
    G(rational_derivatives)(2, plane, R, w, from_int(0), 1, D);
    found_points(T, "R'(0)", 1, plane, D + plane);
    about(T, "R'(0)");
    vanishes(T, D[plane]);
}

/*
:::{statement} slides-ch4:1-hard-to-construct
:title: Complicated shapes without a parameter
:zh: 难以灵活地构造复杂的曲线、曲面
:printed: Without a parameter it is hard to construct complicated curves and surfaces flexibly.
:holds-by: parametric_cubic_crosses_itself
:hypothesis: nodal_cubic_has_an_equation | explicit equations $y=f(x)$ are meant: a curve that crosses itself has none, but it may have an equation
  $f(x,y)=0$
:figure: graphs_and_axes

Hard and flexibly are read as what cannot be done at all.
:::
*/

#if RATIONAL
/*
:::{claim} nodal_cubic_has_an_equation
:title: The cubic that crosses itself has an equation
:zh: 自交三次曲线的隐式方程
:kind: counterexample
:data: c = (-1,0) (0,-1) (1,0) (0,1); e = 1
:instead: e = -1
:result: y^2 - x^2 (x + e) = "0"
:given: the cubic $P(t)=\sum_kc_kt^k$, and the equation $y^2=x^2(x+e)$
:then: $y^2-x^2(x+e)$ is 0 along the curve, for every $t$
:method: The difference as a polynomial in $t$; that it is not 0 is refuted.
:control: $e$ with the other sign
:::
*/
CLAIM(nodal_cubic_has_an_equation)
{
    num c[4 * plane], x[4], y[4], e;
    given_points(T, "c", 4, plane, c);
    e = given(T, "e");
    for (int k = 0; k < 4; k++)
        x[k] = c[k * plane], y[k] = c[k * plane + 1];
    poly X = poly_from_q(4, x), Y = poly_from_q(4, y), factor = poly_add(X, poly_constant(e));
    poly difference = poly_sub(poly_mul(Y, Y), poly_mul(poly_mul(X, X), factor));
    found_text(T, "y^2 - x^2 (x + e)", poly_to_string(difference, "t"));
    about(T, "whether the difference is not 0");
    refute(T, poly_is_zero(difference));
}

/*
:::{claim} parametric_cubic_crosses_itself
:title: A parametric cubic crosses itself, which no graph does
:zh: 参数三次曲线可自交
:kind: decision
:data: c = (-1,0) (0,-1) (1,0) (0,1); t = -1 1
:instead: c = (-1,0) (1,-1) (0,0) (0,1)
:result: P = (0,0) (0,0); P' = (-2,2) (2,2)
:given: the cubic $P(t)=\sum_kc_kt^k$ and two parameters $t$
:then: there $P$ is twice the same point, and the two derivatives are not parallel
:method: Points and derivatives by the power kernel, the determinant of the derivatives.
:control: a cubic whose $x$ increases with $t$
:::
*/
CLAIM(parametric_cubic_crosses_itself)
{
    num c[4 * plane], t[2], D[2][2 * plane];
    given_points(T, "c", 4, plane, c);
    given_points(T, "t", 2, 1, t);
    for (int k = 0; k < 2; k++)
        G(power_derivatives)(3, plane, c, t[k], 1, D[k]);
    found_points(T, "P", 2, plane, (num[]){D[0][0], D[0][1], D[1][0], D[1][1]});
    found_points(T, "P'", 2, plane, (num[]){D[0][2], D[0][3], D[1][2], D[1][3]});
    about(T, "the two points");
    same(T, D[0][0], D[1][0]);
    same(T, D[0][1], D[1][1]);
    about(T, "whether the derivatives are not parallel");
    agree(T, !is_zero_q(G(cross2)(D[0] + plane, D[1] + plane)));
}
#endif

/*
:::{statement} slides-ch4:1-parametric-slope
:title: With a parameter an infinite slope is easy to handle
:zh: 参数方程便于处理斜率无穷大
:printed: Parametric equations make it easy to deal with an infinite slope.
:holds-by: circle_has_an_upright_tangent
:::

:::{statement} slides-ch4:1-space-curve
:title: A space curve as an intersection of two cylinders
:zh: 空间曲线与两张柱面的交线
:printed: Explicit equations without a parameter describe plane curves only; a space curve has to be defined as the intersection of two
  cylinders.
:holds-by: graphs_over_one_axis_meet_in_one_curve
:hypothesis: closed_curve_is_no_pair_of_graphs | explicit equations $y=f(x)$, $z=g(x)$ mean one point for each $x$, or for each value of another coordinate
:hypothesis: no_two_projections_give_the_circle | where cylinders are taken over two projections, the curve is all that they have in common; for some curves no choice
  of two will do
:reading: two_cylinders_hold_more_than_the_curve | the cylinders over the projections of $x^2+y^2=1$, $z=y$ along $z$ and $y$: false, there is more
:reading: two_cylinders_are_two_ellipses | what they have in common: the ellipses of $z=y$ and of $z=-y$
:reading: two_cylinders_of_the_circle_hold_an_ellipse | for the circle of $x^2+y^2+z^2=2$, $x+y+z=0$, what two of its cylinders have in
  common: the circle and an ellipse of a plane in which two coordinates are equal
:figure: two_cylinders

The plane $z=y$ is a cylinder as well, over the projection along $x$; with it, the ellipse is what two cylinders have in common.
:::

:::{claim} graphs_over_one_axis_meet_in_one_curve
:title: Two graphs over one axis are two cylinders that meet in one curve
:zh: 两个显式方程所表示的柱面之交线
:given: $y=f(x)$ and $z=g(x)$ with polynomials of degree $n$ whose Bernstein coefficients are $f_i$ and $g_i$, any $f$, $g$ and $t$
:then: the curve of the points $(\frac in,f_i,g_i)$ is at $(t,f(t),g(t))$: on both cylinders, with one point for each $x$
:method: The point by `bezier_casteljau`, the functions by their powers, everything a variable.  Of the points with $x=t$ no other satisfies
  both equations.
:degrees: 1..6 sampled 10
:control: $f$ and $g$ exchanged
:::
*/
CLAIM(graphs_over_one_axis_meet_in_one_curve)
{
    int n = T->degree;
    num t = parameter(T, "t"), b[(MAX_DEGREE + 1) * space], P[space], low[2][MAX_DEGREE + 1];
    struct G(poly) f = G(free_poly)(T, "f", n), g = G(free_poly)(T, "g", n);
    G(bernstein_from_power)(n, fault(T, f.c, g.c), low[0]);
    G(bernstein_from_power)(n, fault(T, g.c, f.c), low[1]);
    for (int i = 0; i <= n; i++) {
        b[i * space] = from_ratio(i, n);
        b[i * space + 1] = low[0][i];
        b[i * space + 2] = low[1][i];
    }
    G(bezier_casteljau)(n, space, b, t, P);
    same(T, P[0], t);
    same(T, P[1], G(at)(f, 0, t));
    same(T, P[2], G(at)(g, 0, t));
}

#if RATIONAL
/*
:::{claim} no_two_projections_give_the_circle
:title: A circle that no two of its three projections determine
:zh: 任两张投影柱面都不能确定的圆
:kind: counterexample
:data: p = (1,0,0) (0,1,0) (0,0,1)
:instead: p = (1,0,-1) (-1,1,0) (0,-1,1)
:result: x + y + z = 1 1 1
:given: the circle $x^2+y^2+z^2=2$, $x+y+z=0$; its projections along the axes are $x^2+xy+y^2=1$, $x^2+xz+z^2=1$, $y^2+yz+z^2=1$;
  a point $p$ on each of the three axes
:then: each of the points is on two of the three cylinders, and none on the circle
:method: On the plane $z=-x-y$, and $x^2+y^2+z^2=2$ becomes the first equation, likewise the others.  The equations of two cylinders at each point;
  then $x+y+z$, which should be 0.
:control: three points of the circle
:::
*/
CLAIM(no_two_projections_give_the_circle)
{
    num points[space * space], sum[space], one = from_int(1);
    given_points(T, "p", space, space, points);
    for (int k = 0; k < space; k++) { /* the axis of the point */
        const num *p = points + k * space;
        about(T, "the equations of the two cylinders over planes with the axis of the point");
        for (int j = 1; j <= 2; j++) {
            num a = p[k], b = p[(k + j) % space];
            same(T, add(mul(a, a), add(mul(a, b), mul(b, b))), one);
        }
        sum[k] = add(p[0], add(p[1], p[2]));
        about(T, "x + y + z");
        vanishes(T, sum[k]);
    }
    found_points(T, "x + y + z", space, 1, sum);
}
#endif

/*
:::{claim} two_cylinders_of_the_circle_hold_an_ellipse
:title: Two of the three cylinders of the circle meet in it and in an ellipse
:zh: 该圆的任两张投影柱面还交于一椭圆
:given: any $x,y,z$
:then: $(x^2+xy+y^2-1)-(x^2+xz+z^2-1)=(y-z)(x+y+z)$, the same with the letters changed, and where $x+y+z=0$ twice the first bracket is
  $x^2+y^2+z^2-2$
:method: Identities.  A point of both cylinders has $x+y+z=0$, and then it is on the circle; or $y=z$, where $x^2+xy+y^2=1$ is an ellipse,
  $(x+\frac y2)^2+\frac34y^2=1$.
:control: $(y+z)(x+y+z)$ on the right
:::
*/
CLAIM(two_cylinders_of_the_circle_hold_an_ellipse)
{
    num x[space], bracket[space], sum = from_int(0), one = from_int(1); /* bracket[k]: the cylinder along axis k */
    for (int k = 0; k < space; k++) {
        x[k] = unknown(T, "x", k);
        sum = add(sum, x[k]);
    }
    for (int k = 0; k < space; k++) {
        num a = x[(k + 1) % space], b = x[(k + 2) % space];
        bracket[k] = sub(add(mul(a, a), add(mul(a, b), mul(b, b))), one);
    }
    for (int k = 0; k < space; k++) {
        num a = x[(k + 1) % space], b = x[(k + 2) % space];
        same(T, sub(bracket[(k + 2) % space], bracket[(k + 1) % space]), mul(fault(T, sub(a, b), add(a, b)), sum));
    }
    num last = neg(add(x[0], x[1])), squares = add(mul(x[0], x[0]), add(mul(x[1], x[1]), mul(last, last)));
    same(T, mul(from_int(2), bracket[2]), sub(squares, from_int(2)));
}

#if RATIONAL
/*
:::{claim} two_cylinders_hold_more_than_the_curve
:title: A point of both cylinders that is not on the curve
:zh: 两柱面交线多于原曲线
:kind: counterexample
:data: (x, y, z) = (0,1,-1)
:instead: (x, y, z) = (0,1,1)
:given: the ellipse $x^2+y^2=1$, $z=y$; its projections along the axes $z$ and $y$ are the circles $x^2+y^2=1$ and $x^2+z^2=1$; a point of space
:then: the point is on the cylinders over both, and $z\ne y$
:method: Both equations at the point; $z$ against $y$.
:control: a point with $z=y$
:::
*/
CLAIM(two_cylinders_hold_more_than_the_curve)
{
    num p[space], one = from_int(1);
    given_points(T, "(x, y, z)", 1, space, p);
    about(T, "the equations of the two cylinders");
    same(T, add(mul(p[0], p[0]), mul(p[1], p[1])), one);
    same(T, add(mul(p[0], p[0]), mul(p[2], p[2])), one);
    about(T, "z and y");
    same(T, p[2], p[1]);
}

/*
:::{claim} closed_curve_is_no_pair_of_graphs
:title: The ellipse has two points for one x
:zh: 闭曲线不是显式方程组
:kind: counterexample
:data: p = (3/5,4/5,4/5) (3/5,-4/5,-4/5)
:instead: p = (3/5,4/5,4/5) (3/5,4/5,4/5)
:given: the ellipse $x^2+y^2=1$, $z=y$ and two of its points $p$ with one $x$
:then: with $y=f(x)$ both would have one $y$, and they have not
:method: Both points on the ellipse, exactly; their $x$ and $y$.
:control: the first point twice
:::
*/
CLAIM(closed_curve_is_no_pair_of_graphs)
{
    num points[2 * space];
    given_points(T, "p", 2, space, points);
    for (int k = 0; k < 2; k++) {
        const num *p = points + k * space;
        about(T, "the ellipse");
        same(T, add(mul(p[0], p[0]), mul(p[1], p[1])), from_int(1));
        same(T, p[2], p[1]);
    }
    about(T, "x of the two points");
    same(T, points[0], points[space]);
    about(T, "y of the two points with one x");
    same(T, points[1], points[space + 1]);
}
#endif

/*
:::{claim} two_cylinders_are_two_ellipses
:title: The intersection of the two cylinders is a pair of ellipses
:zh: 两正交圆柱的交线为两椭圆
:given: any $x,y,z$
:then: $(x^2+y^2-1)-(x^2+z^2-1)=(y-z)(y+z)$
:method: An identity.  Where both brackets on the left vanish one factor on the right does; and where one factor and the first bracket
  vanish so does the second.
:control: $(y-z)^2$ on the right
:::
*/
CLAIM(two_cylinders_are_two_ellipses)
{
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), z = unknown(T, "z", 0), one = from_int(1);
    num first = sub(add(mul(x, x), mul(y, y)), one), second = sub(add(mul(x, x), mul(z, z)), one);
    same(T, sub(first, second), mul(sub(y, z), fault(T, add(y, z), sub(y, z))));
}

/*
:::{statement} slides-ch4:1-parametric
:title: Curves and surfaces with parameters, and the tangent vector
:zh: 参数曲线、切矢与参数曲面
:printed: $P(t)=[x(t)\;y(t)\;z(t)]$, $P'(t)=[x'(t)\;y'(t)\;z'(t)]$; $P(u,w)=[x(u,w)\;y(u,w)\;z(u,w)]$
:definition: yes
:::

:::{statement} slides-ch4:1-segment
:title: The parameter of a segment
:zh: 直线段的参数表示
:printed: $P(t)=P_1+(P_2-P_1)t=(1-t)P_1+tP_2$, $0\le t\le1$; $x(t)=x_1+(x_2-x_1)t$, $y(t)=y_1+(y_2-y_1)t$
:holds-by: segment_in_its_parameter
:needs: curve_leaves_hull_outside_the_interval | $0\le t\le1$: beyond, it is a point of the line and not of the segment
:::

:::{statement} slides-ch4:1-segment-tangent
:title: The tangent vector of a segment
:zh: 直线段的切矢
:printed: $P'(t)=[x'(t)\;y'(t)]=[x_2-x_1\;\;y_2-y_1]$, in the other notation $(x_2-x_1)\,i+(y_2-y_1)\,j$
:holds-by: segment_in_its_parameter
:::

:::{claim} segment_in_its_parameter
:title: Both forms of the segment are the Bézier curve of degree 1, and its derivative is constant
:zh: 直线段即一次 Bézier 曲线
:given: any points $P_1,P_2$ of the plane, any $t$
:then: $P_1+(P_2-P_1)t=(1-t)P_1+tP_2$ is the curve of `bezier_casteljau`, its derivative by `bezier_derivatives` is $P_2-P_1$, and its
  distance from $P_1$ is $t$ times the length: $|P(t)-P_1|^2=t^2|P_2-P_1|^2$
:method: Each form, everything a variable.
:control: the two points exchanged in the first form
:::
*/
CLAIM(segment_in_its_parameter)
{
    num b[4], D[4], t = parameter(T, "t"), length = from_int(0), along = from_int(0);
    for (int m = 0; m < 4; m++)
        b[m] = unknown(T, m % 2 == 0 ? "x" : "y", m / 2 + 1);
    G(bezier_derivatives)(1, plane, b, t, 1, D);
    for (int c = 0; c < plane; c++) {
        num from = b[fault(T, c, plane + c)], edge = sub(b[plane + c], b[c]), P;
        G(bezier_casteljau)(1, 1, (num[]){b[c], b[plane + c]}, t, &P);
        about(T, "the point");
        same(T, add(from, mul(edge, t)), P);
        same(T, add(mul(sub(from_int(1), t), b[c]), mul(t, b[plane + c])), D[c]);
        about(T, "the derivative");
        same(T, D[plane + c], edge);
        length = add(length, mul(edge, edge));
        along = add(along, mul(sub(P, b[c]), sub(P, b[c])));
    }
    about(T, "the distance from the first point");
    same(T, along, mul(mul(t, t), length));
}

/*
:::{statement} slides-ch4:1-parametric-transform
:title: Transformations act on the parametric equations
:zh: 可对参数方程直接进行几何变换
:printed: Translation, scaling and rotation can be applied directly to the parametric equations.
:holds-by: bezier_curve_moves_with_its_points
:::

:::{statement} slides-ch4:1-freedom
:title: More freedom for the shape
:zh: 参数形式自由度更大
:printed: With a parameter there is more freedom to control the shape of curves and surfaces, and more that can be described.
:holds-by: parametric_cubic_crosses_itself
:figure: graphs_and_axes

A parametric cubic of the plane has eight coefficients, of which the graph of a cubic, $x=t$, has four.  The claim shows a shape that no
graph has.
:::

:::{statement} slides-ch4:1-dimensions
:title: Any number of coordinates
:zh: 变量个数不限,便于扩展到高维
:printed: The variables are separated and their number is not limited, so curves and surfaces are easily taken from a space of few
  dimensions to one of more.
:holds-by: another_coordinate_changes_no_other
:::

:::{claim} another_coordinate_changes_no_other
:title: A further coordinate leaves the others as they are
:zh: 各坐标分量互不影响
:given: points of space $P_0,\dots,P_n$, any $t$; the points of the plane with their first two coordinates
:then: the first two coordinates of the curve in space are the curve in the plane
:method: The kernel in two and in three dimensions, everything a variable.
:degrees: 1..6 sampled 10
:control: the plane of the first and the third coordinate
:::
*/
CLAIM(another_coordinate_changes_no_other)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * space], flat[(MAX_DEGREE + 1) * plane], P[space], Q[plane], t = parameter(T, "t");
    for (int i = 0; i <= n; i++) {
        for (int c = 0; c < space; c++)
            b[i * space + c] = unknown(T, c == 0 ? "x" : c == 1 ? "y" : "z", i);
        flat[i * plane] = b[i * space];
        flat[i * plane + 1] = b[fault(T, i * space + 1, i * space + 2)];
    }
    G(bezier_casteljau)(n, space, b, t, P);
    G(bezier_casteljau)(n, plane, flat, t, Q);
    for (int c = 0; c < plane; c++)
        same(T, Q[c], P[c]);
}

/*
:::{statement} slides-ch4:1-matrices
:title: Vectors and matrices
:zh: 易于用矢量和矩阵表示
:printed: The geometry is easily written, and computed, with vectors and matrices.
:holds-by: unit_blending_functions small_degrees_written_out
:::

:::{statement} slides-ch4:1-bounded
:title: Over the unit interval the coordinates are bounded
:zh: 规格化参数使几何分量有界
:printed: With $t\in[0,1]$ the coordinates are bounded, and no further parameters are needed to mark the border.
:holds-by: bernstein_positive_inside bernstein_sums_to_one bernstein_at_ends
:hypothesis: weights_of_both_signs_make_a_pole | the functions have no pole in $[0,1]$; polynomials have none

For a polynomial the bound is that of its Bernstein coefficients: the value is an average of them.
:::

:::{statement} slides-ch4:1-part
:title: A part of a curve or of a surface
:zh: 用参数范围界定曲线或曲面的一部分
:printed: A part of a curve or of a surface can simply be marked off by $a\le t\le b$.
:holds-by: interval_kernel_gives_the_part surface_part_is_the_piece

For a surface this is one range for each of the two parameters, when the part is a rectangle of them.
:::

:::{statement} slides-ch4:1-pieces
:title: Pieces that are joined smoothly
:zh: 便于分段、分片描述与光顺连接
:printed: With $t\in[0,1]$ curves and surfaces are conveniently described piece by piece, and smooth joints are easy to make.
:holds-by: interval_kernel_gives_the_part surface_part_is_the_piece three_points_make_c2
:::

:::{statement} slides-ch4:1-two-kinds
:title: Curves through the points, and curves with a control polygon
:zh: 插值曲线与逼近曲线
:printed: A curve that has to pass through the points is interpolating; one that need not, and whose shape is controlled by the polygon of
  the points, is approximating.  Interpolation: a curve through the points in their order.
:definition: yes
:checked-by: one_cubic_passes_through_four_data
:::

:::{statement} slides-ch4:1-approximation
:title: Approximation is nearest in some sense
:zh: 逼近指某种意义下最佳
:printed: Approximation: a curve is constructed that is nearest to the points in some sense.
:definition: yes
:checked-by: parabola_through_the_points_is_nearer nearest_line_meets_no_datum

In which sense is left open.  By the distance from the points a Bézier curve, approximating by the words before, is no approximation, since a
curve of the same degree through the points is nearer; the least sum of squares among simpler curves is a problem with one
solution, and has no control polygon.
:::
*/

#if RATIONAL
/*
:::{claim} parabola_through_the_points_is_nearer
:title: The Bézier curve is not the nearest curve of its degree
:zh: Bézier 曲线并非最近的曲线
:kind: decision
:data: Q = (0,0) (1,1) (2,0); t = 0 1/2 1; R = (0,0) (1,2) (2,0)
:instead: R = (0,0) (1,1) (2,0)
:result: distance = 1/2
:given: the points $Q$ at the parameters $t$, and two curves of degree 2: that with the points $Q$, and that with the points $R$
:then: the Bézier curve of the points $Q$ passes straight below the second of them, and the other one passes through all three
:method: The points of both curves at the three parameters.
:control: the same curve twice
:::
*/
CLAIM(parabola_through_the_points_is_nearer)
{
    num Q[3 * plane], R[3 * plane], t[3], P[plane];
    given_points(T, "Q", 3, plane, Q);
    given_points(T, "t", 3, 1, t);
    given_points(T, "R", 3, plane, R);
    G(bezier_casteljau)(2, plane, Q, t[1], P);
    num distance = sub(Q[plane + 1], P[1]);
    found(T, "distance", distance);
    about(T, "the distance of the Bézier curve from the second point");
    same(T, P[0], Q[plane]);
    agree(T, sign_q(distance) > 0);
    about(T, "the curve through the points");
    for (int k = 0; k <= 2; k++) {
        G(bezier_casteljau)(2, plane, R, t[k], P);
        for (int c = 0; c < plane; c++)
            same(T, P[c], Q[k * plane + c]);
    }
}
#endif

/*
## Continuous derivatives (参数连续性)

:::{statement} slides-ch4:1-ck-definition
:title: Equal derivatives from the left and from the right
:zh: 参数连续性 C^k 的定义
:printed: A function that has equal left and right derivatives at $x_0$ up to the order $k$ is called $k$ times continuously differentiable
  at $x_0$, or continuous of order $k$, $C^k$.
:holds-by: equal_derivatives_leave_a_power
:hypothesis: equal_derivatives_are_not_continuous | on either side the function has $k$ continuous derivatives up to $x_0$, as pieces that
  are polynomials have
:hypothesis: equal_limits_do_not_make_a_continuous_function | the values are counted as the derivatives of order 0
:figure: differentiable_without_continuity

It is right for all curves of the slides: two polynomials with these equalities differ by a multiple of $(x-x_0)^{k+1}$.  Read with difference quotients from either side, the condition says that $f$ is differentiable at $x_0$, and not that $f'$ is continuous
there; read with limits of $f',\dots,f^{(k)}$ from either side it does not even say that $f$ is continuous.
:::
*/

#if RATIONAL
/*
:::{claim} equal_derivatives_are_not_continuous
:title: A function with equal derivatives from both sides whose derivative is not continuous
:zh: 左右导数相等而导函数不连续
:kind: counterexample
:data: n = 1000; slope = 1; bound = 1/2
:instead: slope = 1/1000
:result: f(x)/x at most = 1/3000; f'(1/n) = 1
:given: $f(0)=0$, $f(-x)=f(x)$, and on $[\frac1{n+1},\frac1n]$ the Hermite cubic with the values 0 and the slopes
  $(-1)^{n+1}$ and $(-1)^n$ at its ends
:then: $f$ is continuously differentiable for $x\ne0$, $f'(0)=0$ from both sides, and $f'(\frac1n)=(-1)^n$ is not near $f'(0)$, however large $n$ is
:method: With $h=\frac1{n(n+1)}$ the inner Bézier ordinates of a piece have the size $d$, a third of $h$, hence $|f|\le d$ and
  $\bigl|\frac{f(x)}x\bigr|\le d\,(n+1)$, a third of $\frac1n$, which tends to 0.  Computed for one even $n$: the bound of the quotient,
  and the derivative at $\frac1n$; that it differs from $f'(0)=0$ by no more than the given bound is refuted.
:control: slopes of the size $\frac1n$
:::
*/
CLAIM(equal_derivatives_are_not_continuous)
{
    num zero = from_int(0), half = from_ratio(1, 2), three = from_int(3), value, by_bezier, D[2];
    num n = from_int(given_whole(T, "n")), slope = given(T, "slope"), bound = given(T, "bound"); /* n is even */
    num right = div(from_int(1), n), left = div(from_int(1), add(n, from_int(1))), length = sub(right, left);
    num data[4] = {zero, zero, neg(slope), slope};
    hermite_cubic_q(1, left, right, data, right, 1, D);
    num ordinates[4] = {zero, mul(div(length, three), data[2]), neg(mul(div(length, three), data[3])), zero};
    hermite_cubic_q(1, left, right, data, add(left, mul(half, length)), 0, &value);
    bezier_casteljau_q(3, 1, ordinates, half, &by_bezier);
    about(T, "the piece by its Bézier ordinates");
    same(T, value, by_bezier);
    num quotient = div(div(length, three), left);
    found(T, "f(x)/x at most", quotient);
    about(T, "the bound is a third of 1/n");
    same(T, mul(three, quotient), right);
    for (int i = 1; i <= 2; i++) {
        num size = sign_q(ordinates[i]) < 0 ? neg(ordinates[i]) : ordinates[i];
        nonnegative(T, sub(quotient, div(size, left)));
    }
    found(T, "f'(1/n)", D[1]);
    about(T, "whether f'(1/n) is near f'(0) = 0");
    agree(T, compare_q(D[1], bound) <= 0);
}

/*
:::{claim} equal_limits_do_not_make_a_continuous_function
:title: Derivatives with one limit from both sides, and a jump
:zh: 导数左右极限相等而函数间断
:kind: counterexample
:data: left = 0; right = 1; k = 3
:instead: right = 0
:given: a function that has one constant value to the left of $x=0$ and another from there on
:then: all derivatives have the limit 0 from both sides, and the values differ
:method: Both pieces as polynomials, values and derivatives at 0 up to the order $k$.
:control: one value everywhere
:::
*/
CLAIM(equal_limits_do_not_make_a_continuous_function)
{
    struct G(poly) left = G(constant)(given(T, "left")), right = G(constant)(given(T, "right"));
    num zero = from_int(0);
    int k = given_whole(T, "k");
    about(T, "the derivatives at 0");
    for (int j = 1; j <= k; j++)
        same(T, G(at)(left, j, zero), G(at)(right, j, zero));
    about(T, "the values at 0");
    same(T, G(at)(left, 0, zero), G(at)(right, 0, zero));
}
#endif

/*
:::{claim} equal_derivatives_leave_a_power
:title: Polynomials with the same derivatives up to order k differ by a multiple of the next power
:zh: 左右 k 阶导数相等的充要条件
:given: any polynomial $p$ of degree 7, any $x_0$, any $r$ of degree 2; $q(x)=p(x)+(x-x_0)^{k+1}r(x)$
:then: $q^{(j)}(x_0)=p^{(j)}(x_0)$ for $j\le k$, and $q^{(k+1)}(x_0)-p^{(k+1)}(x_0)=(k+1)!\,r(x_0)$
:method: $q$ is multiplied out in powers of $x$; everything a variable.  By Taylor's formula every $q$ with these $k+1$ equalities is of
  this form with some $r$.
:degrees: 0..4 sampled 8
:control: the exponent $k$
:::
*/
CLAIM(equal_derivatives_leave_a_power)
{
    int k = T->degree;
    num x0 = unknown(T, "x", 0), factorial = from_int(1);
    struct G(poly) p = G(free_poly)(T, "p", 7), r = G(free_poly)(T, "r", 2);
    struct G(poly) gap = {1, {neg(x0), from_int(1)}}, product = r;
    for (int j = 0; j < fault(T, k + 1, k); j++)
        product = G(times)(product, gap);
    for (int j = 2; j <= k + 1; j++)
        factorial = mul(factorial, from_int(j));
    struct G(poly) q = G(plus)(p, product);
    about(T, "the derivatives up to order k");
    for (int j = 0; j <= k; j++)
        same(T, G(at)(q, j, x0), G(at)(p, j, x0));
    about(T, "the derivative of order k + 1");
    same(T, sub(G(at)(q, k + 1, x0), G(at)(p, k + 1, x0)), mul(factorial, G(at)(r, 0, x0)));
}

/*
:::{statement} slides-ch4:1-ck-shape
:title: What C0, C1 and C2 mean for the figure
:zh: C0、C1、C2 的几何意义
:printed: Geometrically $C^0$, $C^1$, $C^2$ mean that the graph of the function, the direction of its tangent, its curvature are continuous.
:holds-by: curvature_of_a_graph
:hypothesis: tangent_turns_back_at_a_smooth_parameter | $P'\ne0$ where the curve has a parameter; graphs, of which the slides speak, have it always
:reading: curvature_of_a_graph | from the class to the figure, for graphs: true
:reading: upright_tangent_is_continuous_and_not_c1 | from the figure to the class, for graphs: false
:reading: derivative_is_continuous_at_the_cusp | from the class to the figure, for curves with a parameter: false, the tangent may turn back
:reading: continuous_slope_with_another_speed | from the figure to the class, for curves with a parameter: false
:figure: upright_cube_root

A function of the class $C^1$, $C^2$ has a graph with continuous tangent, curvature: its direction is $(1,f')$, its curvature
$f''/(1+f'^2)^{3/2}$.  Conversely this holds where no tangent is upright, since $f'$ is the slope and $f''$ the curvature times
$(1+f'^2)^{3/2}$.
:::
*/

#if RATIONAL
/*
:::{claim} upright_tangent_is_continuous_and_not_c1
:title: The graph of the cube root has a continuous tangent and curvature, and the function no derivative
:zh: 立方根函数:切向与曲率连续而不可导
:kind: counterexample
:data: c = (0,0) (0,1) (0,0) (1,0); s = 1/1000; bound = 1000
:instead: s = 1/10
:result: P'(0) = (0,1); P''(0) = (0,0); f(h)/h = 1000000
:given: the cube root $f$, and its graph $P(s)=\sum_kc_ks^k$, which is at $h=s^3$ for the parameter $s$ and at the origin for $s=0$
:then: the graph has a derivative whose second coordinate is 1, hence the curvature $\frac{P'\times P''}{|P'|^3}$ for all $s$; the quotient
  $\frac{f(h)}h=\frac1{s^2}$ is beyond every bound
:method: Derivatives of the graph by the power kernel, the quotient at the one $s$; that it is not greater than the given bound
  is refuted.
:control: a point that is not so near to the origin
:::
*/
CLAIM(upright_tangent_is_continuous_and_not_c1)
{
    num c[4 * plane], D[3 * plane], P[plane];
    given_points(T, "c", 4, plane, c);
    num s = given(T, "s"), bound = given(T, "bound");
    power_derivatives_q(3, plane, c, from_int(0), 2, D);
    found_points(T, "P'(0)", 1, plane, D + plane);
    found_points(T, "P''(0)", 1, plane, D + 2 * plane);
    about(T, "whether the curvature at the origin has a denominator");
    agree(T, !is_zero_q(D[plane + 1]));
    power_point_q(3, plane, c, s, P);
    num quotient = div(P[1], P[0]);
    found(T, "f(h)/h", quotient);
    about(T, "whether the quotient is at most the bound");
    agree(T, compare_q(quotient, bound) <= 0);
}

/*
:::{claim} tangent_turns_back_at_a_smooth_parameter
:title: A polynomial curve whose tangent turns back
:zh: 多项式曲线在尖点处切向反转
:kind: counterexample
:data: c = (0,0) (0,0) (0,1) (1,0); h = 1/1000
:instead: c = (0,0) (1,0) (0,1) (1,0)
:result: P'(-h) = (3/1000000,-1/500); P'(h) = (3/1000000,1/500); P'(-s) P'(s) = "9*s^4 - 4*s^2"
:given: the cubic $P(t)=\sum_kc_kt^k=(t^3,t^2)$, which has continuous derivatives of every order, and a small $h$
:then: $P'(-h)\cdot P'(h)<0$; the product is a polynomial in $h$ whose term of the lowest degree is negative, so that however near to the origin the
  tangents before and after make an obtuse angle
:method: The derivatives by the power kernel at $h$; that their product is not negative is refuted.  The product at every $s$ by the
  coefficients.
:control: a curve that passes the origin with the derivative $(1,0)$
:::
*/
CLAIM(tangent_turns_back_at_a_smooth_parameter)
{
    num c[4 * plane], before[2 * plane], after[2 * plane];
    given_points(T, "c", 4, plane, c);
    num h = given(T, "h");
    power_derivatives_q(3, plane, c, neg(h), 1, before);
    power_derivatives_q(3, plane, c, h, 1, after);
    found_points(T, "P'(-h)", 1, plane, before + plane);
    found_points(T, "P'(h)", 1, plane, after + plane);
    poly product = poly_constant(from_int(0));
    for (int j = 0; j < plane; j++) {
        poly forth = poly_derivative(poly_from_q(4, (num[]){c[j], c[2 + j], c[4 + j], c[6 + j]}));
        poly back = poly_compose(forth, poly_from_q(2, (num[]){from_int(0), from_int(-1)}));
        product = poly_add(product, poly_mul(forth, back));
    }
    found_text(T, "P'(-s) P'(s)", poly_to_string(product, "s"));
    num at_h = add(mul(before[2], after[2]), mul(before[3], after[3]));
    about(T, "the product at h");
    same(T, at_h, poly_value(product, h));
    about(T, "whether the product of the derivatives is not negative");
    nonnegative(T, at_h);
}
#endif

/*
:::{claim} curvature_of_a_graph
:title: Slope and curvature of a graph
:zh: 函数图形的切向与曲率
:given: any values $f'$ and $f''$ of a function
:then: the curve $(x,f)$ with the derivatives $(1,f')$, $(0,f'')$ has $P'\times P''=f''$, $|P'|^2=1+f'^2$, so the square of its curvature is
  $\frac{f''^2}{(1+f'^2)^3}$
:method: The kernels of differential geometry; everything a variable.  The denominator is positive.
:control: $(1+f'^2)^2$
:::
*/
CLAIM(curvature_of_a_graph)
{
    num slope = unknown(T, "f", 1), second = unknown(T, "f", 2), one = from_int(1);
    num d1[2] = {one, slope}, d2[2] = {from_int(0), second}, speed = add(one, mul(slope, slope));
    same(T, G(cross2)(d1, d2), second);
    same(T, G(norm_squared)(plane, d1), speed);
    num below = fault(T, mul(speed, mul(speed, speed)), mul(speed, speed));
    same(T, G(curvature_squared)(plane, d1, d2), div(mul(second, second), below));
}

/*
## Continuous shape (几何连续性)

:::{statement} slides-ch4:1-gk-definition
:title: Geometric continuity by arc length
:zh: 几何连续性 G^k 的定义
:printed: Two segments are continuous of order $k$ geometrically, $G^k$, when their parametrizations by arc length are $C^k$ at the joint.
:definition: yes
:checked-by: conditions_make_one_curve_in_another_parameter

Derivatives by the arc length are found from those by another parameter where $P'\ne0$.
:::

:::{statement} slides-ch4:1-g0
:title: G0 and C0 are the same
:zh: G0 与 C0 一致
:printed: Geometric continuity of order zero is the same as parametric continuity of order zero.
:holds-by: position_has_no_parameter
:::
*/

/* P composed with phi(u) = lambda u + beta u^2. */
static struct G(poly) G(composed)(struct G(poly) p, num lambda, num beta)
{
    struct G(poly) phi = {2, {from_int(0), lambda, beta}}, sum = G(constant)(p.c[p.n]);
    for (int k = p.n - 1; k >= 0; k--)
        sum = G(plus)(G(times)(sum, phi), G(constant)(p.c[k]));
    return sum;
}

/*
:::{claim} position_has_no_parameter
:title: A change of the parameter that keeps the end keeps the point
:zh: 参数变换不改变端点位置
:given: a polynomial of degree $n$ with any coefficients, $\phi(u)=\lambda u+\beta u^2$
:then: $P(\phi(0))=P(0)$, and $(P\circ\phi)'(0)=\lambda P'(0)$: the value is kept for every $\phi$, the derivative only for $\lambda=1$
:method: $P\circ\phi$ is multiplied out in powers of $u$; everything a variable.
:degrees: 1..5 sampled 8
:control: the derivative expected to be kept
:::
*/
CLAIM(position_has_no_parameter)
{
    num lambda = unknown(T, "l", 0), beta = unknown(T, "b", 0), zero = from_int(0);
    struct G(poly) p = G(free_poly)(T, "c", T->degree), q = G(composed)(p, lambda, beta);
    about(T, "the value");
    same(T, G(at)(q, 0, zero), G(at)(p, 0, zero));
    about(T, "the derivative");
    num slope = G(at)(p, 1, zero);
    same(T, G(at)(q, 1, zero), fault(T, mul(lambda, slope), slope));
}

/*
:::{statement} slides-ch4:1-g1
:title: G1 by proportional first derivatives
:zh: G1:一阶导数成比例
:printed: $G^1$ means that the first derivatives of the two segments are proportional at the joint: equal in direction, different in size.
:holds-by: equal_unit_tangents_fix_the_ratio
:hypothesis: singular_end_has_no_ratio | neither derivative is 0 at the joint
:needs: negative_ratio_turns_back | equal in direction: proportional with a negative factor is a curve that turns back
:reading: equal_unit_tangents_fix_the_ratio | the sizes may differ: true
:reading: halves_of_a_segment_have_one_speed | the sizes do differ: false, since two halves of a segment with one speed are $G^1$ as well
:figure: joints_of_order
:::
*/

#if RATIONAL
/*
:::{claim} halves_of_a_segment_have_one_speed
:title: Two halves of a segment meet with equal derivatives
:zh: 线段两半在公共点处导矢相等
:kind: counterexample
:data: P = (0,0) (1,0); Q = (1,0) (2,0); length = 1
:instead: length = 1/2
:result: before = (1,0); after = (1,0)
:given: the two halves $P$ and $Q$ of a segment, the first over $[0,1]$, the second over an interval of the given length
:then: the derivatives at the joint are equal
:method: The derivatives by the kernel, divided by the length; that the squares of their lengths differ is refuted.
:control: the second half over a shorter interval
:::
*/
CLAIM(halves_of_a_segment_have_one_speed)
{
    num P[2 * plane], Q[2 * plane], D[2 * plane], E[2 * plane];
    given_points(T, "P", 2, plane, P);
    given_points(T, "Q", 2, plane, Q);
    num length = given(T, "length");
    bezier_derivatives_q(1, plane, P, from_int(1), 1, D);
    bezier_derivatives_q(1, plane, Q, from_int(0), 1, E);
    for (int c = 0; c < plane; c++)
        E[plane + c] = div(E[plane + c], length);
    found_points(T, "before", 1, plane, D + plane);
    found_points(T, "after", 1, plane, E + plane);
    about(T, "whether their lengths differ");
    refute(T, equal_q(norm_squared_q(plane, D + plane), norm_squared_q(plane, E + plane)));
}

/*
:::{statement} slides-ch4:1-g2
:title: G2 by proportional first and second derivatives
:zh: G2:一、二阶导数均成比例
:printed: $G^2$ means that the first and the second derivatives of the two segments are proportional at the joint.
:refuted-by: proportional_derivatives_with_another_curvature one_factor_for_both_derivatives smooth_curve_without_proportional_derivatives proportional_derivatives_by_arc_length
:class: false
:corrected: $Q'=\lambda P'$ and $Q''=\lambda^2P''+\beta P'$ with $\lambda>0$ and any $\beta$, $P'\ne0$
:corrected-by: conditions_make_one_curve_in_another_parameter condition_keeps_the_curvature_vector curvature_vector_forces_the_condition
:figure: proportional_derivatives
:striking: 44

There are four readings: two factors without relation; one factor for both; the factor of the second derivative the square of that of the
first, which is sufficient and not necessary; and derivatives by the arc length, where the first are equal and the second
proportional.  None is what the definition by arc length says.
:::
*/

/* Compare the squares of the curvatures of two curves with the given derivatives P', P'' and Q', Q''. */
static void compare_curvatures(trial *T)
{
    num P[2][plane], Q[2][plane];
    given_points(T, "P'", 1, plane, P[0]);
    given_points(T, "P''", 1, plane, P[1]);
    given_points(T, "Q'", 1, plane, Q[0]);
    given_points(T, "Q''", 1, plane, Q[1]);
    num before = curvature_squared_q(plane, P[0], P[1]), after = curvature_squared_q(plane, Q[0], Q[1]);
    found(T, "κ² before", before);
    found(T, "κ² after", after);
    about(T, "the squares of the curvatures");
    same(T, after, before);
}

/*
:::{claim} proportional_derivatives_with_another_curvature
:title: Two factors: the curvature jumps
:zh: 比例因子独立时曲率间断
:kind: counterexample
:data: P' = (1,0); P'' = (0,1); Q' = (1,0); Q'' = (0,3)
:instead: Q'' = (0,1)
:result: κ² before = 1; κ² after = 9
:given: derivatives of two curves at a joint with $Q'=P'$, and $Q''$ three times $P''$
:then: the curvature jumps
:method: `curvature_squared` of both.
:control: $Q''=P''$
:::
*/
CLAIM(proportional_derivatives_with_another_curvature) { compare_curvatures(T); }

/*
:::{claim} one_factor_for_both_derivatives
:title: One factor for both: the curvature jumps
:zh: 两阶导数用同一比例因子时曲率间断
:kind: counterexample
:data: P' = (1,0); P'' = (0,1); Q' = (2,0); Q'' = (0,2)
:instead: Q'' = (0,4)
:result: κ² before = 1; κ² after = 1/4
:given: derivatives of two curves at a joint with $Q'=2P'$, $Q''=2P''$
:then: the curvature jumps
:method: `curvature_squared` of both.
:control: $Q''=2^2P''$
:::
*/
CLAIM(one_factor_for_both_derivatives) { compare_curvatures(T); }

/*
:::{claim} smooth_curve_without_proportional_derivatives
:title: One parabola in two parameters: G2 without proportional second derivatives
:zh: 二阶导数不成比例而几何连续
:kind: counterexample
:data: λ = 1; β = 1/2
:instead: λ = 2; β = 0
:result: P'' = (0,1); Q'' = (1,1)
:given: $P(t)=(t,\frac{t^2}2)$ up to $t=0$ and from there $Q(u)=P(\lambda u+\beta u^2)$, the same parabola
:then: $P''$ and $Q''$ are not proportional, with whatever factor; the curve is a piece of one parabola
:method: $Q$ as a polynomial in $u$ by its coefficients, which satisfies $2y=x^2$; the determinant of the second derivatives should vanish.
:control: $\beta=0$
:::
*/
CLAIM(smooth_curve_without_proportional_derivatives)
{
    num zero = from_int(0), one = from_int(1), lambda = given(T, "λ"), beta = given(T, "β");
    struct G(poly) x = {1, {zero, one}}, y = {2, {zero, zero, from_ratio(1, 2)}};
    struct G(poly) u = G(composed)(x, lambda, beta), v = G(composed)(y, lambda, beta), square = G(times)(u, u);
    about(T, "2y and x^2 along the second piece");
    for (int k = 0; k <= square.n; k++)
        same(T, k <= v.n ? mul(from_int(2), v.c[k]) : zero, square.c[k]);
    num before[plane] = {G(at)(x, 2, zero), G(at)(y, 2, zero)}, after[plane] = {G(at)(u, 2, zero), G(at)(v, 2, zero)};
    found_points(T, "P''", 1, plane, before);
    found_points(T, "Q''", 1, plane, after);
    about(T, "the determinant of the second derivatives");
    vanishes(T, G(cross2)(before, after));
}

/*
:::{claim} proportional_derivatives_by_arc_length
:title: By arc length: equal tangents and proportional second derivatives
:zh: 弧长参数下二阶导数成比例仍不足
:kind: counterexample
:data: T = (1,0); P'' = (0,1); Q'' = (0,-1)
:instead: Q'' = (0,1)
:result: κ before = 1; κ after = -1
:given: unit speed and one tangent, $P'=Q'=T$, and $Q''=-P''$: circles of radius 1 on both sides of the tangent
:then: the signed curvatures are opposite
:method: $P'\times P''$ and $Q'\times Q''$, which at unit speed are the curvatures.
:control: $Q''=P''$
:::
*/
CLAIM(proportional_derivatives_by_arc_length)
{
    num tangent[plane], P2[plane], Q2[plane];
    given_points(T, "T", 1, plane, tangent);
    given_points(T, "P''", 1, plane, P2);
    given_points(T, "Q''", 1, plane, Q2);
    num before = G(cross2)(tangent, P2), after = G(cross2)(tangent, Q2);
    found(T, "κ before", before);
    found(T, "κ after", after);
    about(T, "the signed curvatures");
    same(T, after, before);
}
#endif

/*
:::{statement} slides-ch4:1-fairness
:title: Fair curves
:zh: 光顺
:printed: A fair curve has not too many inflections.  For plane curves, relatively: (1) $G^2$; (2) no superfluous inflections and singular
  points; (3) small changes of the curvature.
:definition: yes
:checked-by: unit_tangent_jumps_at_the_cusp

The words superfluous and small are not made precise.  The second condition does not follow from the first as the slides explain it: at
a cusp all derivatives of both sides are equal, hence proportional.
:::
*/
#include "chapters/judge/claims_off.h"
