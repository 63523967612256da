/*
# Why a parameter (参数表示)

The slides begin with a list of reasons for writing curves and surfaces with a parameter.  Most of them are half sentences:
what a graph $y=f(x)$ cannot do, what an equation $f(x,y)=0$ makes inconvenient, what becomes easy with $P(t)$.  Read as
mathematics some are statements about what exists, and a curve that has it, or lacks it, decides them; some are general, and proved; and
some are opinions, of which a part can be decided and the rest is left open.  Most of what can be decided turns out to be true,
some of it only of explicit equations, or only where the derivative is not 0, or for polynomials; the sentence on space curves and
cylinders has a section of its own.
*/
#include "chapters/hermite-coons/definition.h"

#if RATIONAL
#include "exact/record/polynomial.h"
#endif

#include "chapters/judge/claims_on.h"

enum { plane = 2, space = 3 };

/*
## What an equation in coordinates cannot do

The first complaint is about the axes.  A graph is given by the axis along which $x$ is measured; two points of a parabola show that
after a turn it need not be one.

:::{statement} slides-ch4:1-axes
:title: Equations without a parameter depend on the axes
:zh: 非参数方程依赖坐标轴
:printed: $y=f(x)$ and $f(x,y)=0$ belong to the axes and are inconvenient when the coordinates are changed.
:reading: turned_graph_is_no_graph | $y=f(x)$ belongs to the axes: a turn can take a graph to what is no graph
:reading: turned_graph_is_no_graph | $f(x,y)=0$ belongs to the axes: a turn can take a curve to one that has another equation
:reading: what is inconvenient: an opinion, which no computation decides
:confirmed-by: maps_of_the_equations_are_one_matrix
:figure: graphs_and_axes

The functions $x(t)$, $y(t)$ are others after a turn, too; but they are two functions of $t$ again, found by one matrix: `maps_of_the_equations_are_one_matrix`.
:::
*/

#if RATIONAL
/*
:::{claim} turned_graph_is_no_graph
:title: A graph that has been turned need not be a graph
:zh: 旋转后不再是函数图形
:kind: decision
:data: x = 1 -1
:result: images = (-1,1) (-1,-1); y - x^2 at the images = 0 -2
:given: two points of $y=x^2$ with the given $x$, turned by a right angle, $(x,y)\mapsto(-y,x)$
:then: they have one $x$ and two different $y$: no $y=f(x)$ contains both; and the second is not on $y=x^2$, so that $y-x^2=0$ is not the equation of the
  turned curve
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
    num left[2];
    for (int k = 0; k < 2; k++)
        left[k] = sub(image[k * plane + 1], mul(image[k * plane], image[k * plane]));
    found_points(T, "images", 2, plane, image);
    found_points(T, "y - x^2 at the images", 2, 1, left);
    about(T, "the two x");
    same(T, image[0], image[plane]);
    about(T, "whether the two y differ");
    agree(T, !equal_q(image[1], image[plane + 1]));
    about(T, "whether the second image is not on the curve");
    agree(T, !is_zero_q(left[1]));
}

/*
:::{statement} slides-ch4:1-many-values
:title: Several values in both directions
:zh: 一个自变量对应多个值
:printed: If functions without a parameter are used: in some coordinates a curve has several $y$ for some $x$ and several $x$ for some $y$.
:holds-by: circle_has_two_values_each_way
:meant: the formulas $y=f(x)$ and $f(x,y)=0$ beside it | The several values are those of a curve, of which $f(x,y)=0$ may be the equation; a graph $y=f(x)$ has one $y$ at
  most for every $x$, so that it is not the whole of such a curve.
:example: it may happen, and one curve shows it.
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
A circle has an upright tangent whichever way it is turned.  As the graph of a function it has no slope there.  With a parameter the
tangent is a vector, and nothing happens: its length is never 0.

:::{statement} slides-ch4:1-infinite-slope
:title: Slopes may be infinite
:zh: 斜率无穷大
:printed: Without a parameter an infinite slope may occur.
:holds-by: circle_has_an_upright_tangent
:example: the sentence says that this may happen, and one curve shows it.
:figure: graphs_and_axes
:::

:::{claim} circle_has_an_upright_tangent
:title: On the circle the derivative is never zero, also where there is no slope
:zh: 圆上竖直切线处导矢有限且非零
:data: R = (1,0) (1,1) (0,1); ω = 1 1 2
:instead: ω = 1 1 1
:result: R'(0) = (0,2)
:given: the quarter circle with the points $R$ and the weights $\omega$; any $t$
:scope: the stated quarter circle
:then: $x^2+y^2=1$ for $R=(x,y)$, $R\cdot R'=0$ and $|R'|=\frac2{1+t^2}$, which is nowhere 0; at $t=0$ the derivative is upright, and there is no slope; for $t\ne0$ the slope
  $\frac{y'}{x'}$ is $-s$ with $2s=\frac1t-t$, and for every bound $C>0$ it is $2s\ge C$ where $0<t\le\frac1{1+C}$
:method: Points and derivatives by the rational kernel; the length by its square.  The slope at a variable $t$; the bound for $t=\frac1{1+C+e}$, $e\ge0$, where
  $\frac1t-t-C=1-t+e$: signs of coefficients for $e>0$, and once more for $e=0$.
:over: C e: -
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
    about(T, "x^2 + y^2");
    same(T, add(mul(D[0], D[0]), mul(D[1], D[1])), one);
    about(T, "R times R'");
    vanishes(T, add(mul(D[0], D[2]), mul(D[1], D[3])));
    about(T, "the square of the length of R'");
    same(T, add(mul(D[2], D[2]), mul(D[3], D[3])), mul(speed, speed));
    about(T, "twice the slope");
    same(T, mul(mul(from_int(2), t), D[3]), mul(sub(mul(t, t), one), D[2])); /* 2t y' = -(1 - t^2) x' */
    num C = positive(T, "C", 0), e = positive(T, "e", 0);
    about(T, "twice the steepness less the bound");
    for (int k = 0; k < 2; k++) {
        num above = add(one, k == 0 ? C : add(C, e)); /* 1/t */
        nonnegative(T, sub(sub(above, div(one, above)), C));
    }
    G(rational_derivatives)(2, plane, R, w, from_int(0), 1, D);
    found_points(T, "R'(0)", 1, plane, D + plane);
    about(T, "R'(0)");
    vanishes(T, D[plane]);
    same(T, D[plane + 1], from_int(2));
}

/*
What no graph $y=f(x)$ can do is to come back to the same point.  An equation $f(x,y)=0$ can, so it matters which of the two is meant by
an equation without a parameter.

:::{statement} slides-ch4:1-hard-to-construct
:title: Complicated shapes without a parameter
:zh: 难以灵活地构造复杂的曲线、曲面
:printed: Without a parameter it is hard to construct complicated curves and surfaces flexibly.
:reading: parametric_cubic_crosses_itself | hard is what an equation $y=f(x)$ cannot do at all: there is a curve, which crosses itself, that has
  none
:confirmed-by: nodal_cubic_has_an_equation
:reading: parametric_cubic_crosses_itself | of surfaces, hard is what an equation $z=f(x,y)$ cannot do at all: there is a surface that has none | The cylinder of the points
  $(x,s,z)$ with $(x,z)$ on the cubic of reading 1 and any $s$ has two points with one $x$, one $s$ and two different $z$.
:reading: what else is hard, and which curves and surfaces are complicated: an opinion, which no computation decides
:figure: graphs_and_axes

An equation $f(x,y)=0$ the cubic has, and the slides do not say that it has not.
:::
*/

#if RATIONAL
/*
:::{claim} nodal_cubic_has_an_equation
:title: The cubic that crosses itself has an equation
:zh: 自交三次曲线的隐式方程
:kind: decision
:data: c = (-1,0) (0,-1) (1,0) (0,1); e = 1
:instead: e = -1
:result: y^2 - x^2 (x + e) = "0"
:given: the cubic $P(t)=\sum_kc_kt^k$, and the equation $y^2=x^2(x+e)$
:then: $y^2-x^2(x+e)$ is 0 along the curve, for every $t$; and $P(t)=(t^2-e,\,t(t^2-e))$, so that no other point satisfies the equation
:method: The difference and the coordinates as polynomials in $t$.  A point of the equation with $x\ne0$ is $P(t)$ for $t=\frac yx$, since $t^2=x+e$; with $x=0$ it is
  $(0,0)$, which is $P(t)$ for $t^2=e$.
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
    about(T, "whether the difference is 0");
    agree(T, poly_is_zero(difference));
    num square[3] = {neg(e), from_int(0), from_int(1)}, t[2] = {from_int(0), from_int(1)};
    about(T, "whether x is t^2 - e, and y is t x");
    agree(T, poly_is_zero(poly_sub(X, poly_from_q(3, square))));
    agree(T, poly_is_zero(poly_sub(Y, poly_mul(poly_from_q(2, t), X))));
}

/*
:::{claim} parametric_cubic_crosses_itself
:title: A parametric cubic crosses itself and is no graph
:zh: 参数三次曲线可自交
:kind: decision
:data: c = (-1,0) (0,-1) (1,0) (0,1); t = -1 1; s = -1/2 1/2
:instead: c = (-1,0) (1,-1) (0,0) (0,1)
:result: P(t) = (0,0) (0,0); P'(t) = (-2,2) (2,2); P(s) = (-3/4,3/8) (-3/4,-3/8)
:given: the cubic $P(t)=\sum_kc_kt^k$, two parameters $t$ and two others, $s$
:then: at the $t$ the curve $P$ is twice the same point, and the two derivatives are not parallel; at the $s$ it has two points with one $x$ and two
  different $y$, so that no $y=f(x)$ contains it
:method: Points and derivatives by the power kernel, the determinant of the derivatives.
:control: a cubic whose $x$ increases with $t$
:::
*/
CLAIM(parametric_cubic_crosses_itself)
{
    num c[4 * plane], t[2], s[2], D[2][2 * plane], above[2 * plane];
    given_points(T, "c", 4, plane, c);
    given_points(T, "t", 2, 1, t);
    given_points(T, "s", 2, 1, s);
    for (int k = 0; k < 2; k++) {
        G(power_derivatives)(3, plane, c, t[k], 1, D[k]);
        G(power_point)(3, plane, c, s[k], above + k * plane);
    }
    found_points(T, "P(s)", 2, plane, above);
    found_points(T, "P(t)", 2, plane, (num[]){D[0][0], D[0][1], D[1][0], D[1][1]});
    found_points(T, "P'(t)", 2, plane, (num[]){D[0][2], D[0][3], D[1][2], D[1][3]});
    about(T, "the two points");
    same(T, D[0][0], D[1][0]);
    same(T, D[0][1], D[1][1]);
    about(T, "whether the derivatives are not parallel");
    agree(T, !is_zero_q(G(cross2)(D[0] + plane, D[1] + plane)));
    about(T, "whether the two points at s have one x and two y");
    agree(T, equal_q(above[0], above[plane]) && !equal_q(above[1], above[plane + 1]));
}
#endif

/*
:::{statement} slides-ch4:1-parametric-slope
:title: With a parameter an infinite slope is easy to handle
:zh: 参数方程便于处理斜率无穷大
:printed: Parametric equations make it easy to deal with an infinite slope.
:reading: tangent_needs_no_slope | the tangent is found without a slope, and no case has to be told from another, where the derivative is not $(0,0)$
:reading: cusp_has_no_equation_of_the_tangent | also where the derivative is $(0,0)$: there the slope may be infinite as well, and the equation says nothing
:reading: what is easy: an opinion, which no computation decides
:::

:::{claim} tangent_needs_no_slope
:title: The tangent line by the derivative of the parameter, where there is a slope and where there is none
:zh: 切线由参数导矢给出,与斜率是否存在无关
:given: a point $(x,y)$ of a plane curve and its derivative $(x',y')\ne(0,0)$ there, any numbers; any $\lambda$
:where: the derivative is not $(0,0)$
:then: $(X-x)\,y'-(Y-y)\,x'=0$ for $(X,Y)=(x+\lambda x',y+\lambda y')$; where $x'\ne0$ it is $x'\bigl((X-x)\frac{y'}{x'}-(Y-y)\bigr)$, which is 0 on
  the line of the slope $\frac{y'}{x'}$; where $x'=0$ it is $(X-x)\,y'=0$, the upright line
:method: Identities with everything a variable, and once more with $x'=0$; the equation is that of a line, since one of its two factors is not 0.
:over: x0 y0: point; x1 y1: derivative; X Y: -; l: -
:control: the two components of the derivative exchanged
:::
*/
CLAIM(tangent_needs_no_slope)
{
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), X = unknown(T, "X", 0), Y = unknown(T, "Y", 0);
    num lambda = unknown(T, "l", 0), dx = unknown(T, "x", 1), dy = positive(T, "y", 1), zero = from_int(0);
    for (int upright = 0; upright < 2; upright++) {
        num d[plane] = {upright ? zero : dx, dy};
        num to[plane] = {mul(lambda, fault(T, d[0], d[1])), mul(lambda, fault(T, d[1], d[0]))};
        about(T, "the points of the tangent");
        vanishes(T, G(cross2)(to, d));
        num from[plane] = {sub(X, x), sub(Y, y)}, equation = G(cross2)(from, d);
        about(T, upright ? "the upright line" : "the line with a slope");
        num with_slope = upright ? zero : mul(dx, sub(mul(from[0], div(dy, dx)), from[1]));
        same(T, equation, upright ? mul(from[0], dy) : with_slope);
    }
}

#if RATIONAL
/*
:::{claim} cusp_has_no_equation_of_the_tangent
:title: At a cusp the derivative gives no tangent
:zh: 尖点处导矢不给出切线
:kind: counterexample
:data: R = (0,0) (0,0) (0,1/3) (1,1); t = 0; Q = (1,0)
:instead: R = (0,0) (0,1/3) (0,1) (1,1)
:given: the cubic with the Bézier points $R$, which has a cusp at $t$, where the tangent is along the second derivative and upright, and a point $Q$ that is not on this
  tangent
:then: the equation $(X-x)\,y'-(Y-y)\,x'=0$ is satisfied at $Q$ all the same, both its coefficients being 0: it is not that of the tangent
:result: derivative = (0,0); second derivative = (0,2); left side of the equation = 0
:method: The kernel's point and derivatives; the first derivative put into the equation, the second compared with the way from the point to $Q$; that the equation
  is not satisfied at $Q$ is refuted.
:control: a cubic with the same point, the same second derivative and a first derivative along it
:::
*/
CLAIM(cusp_has_no_equation_of_the_tangent)
{
    num R[4 * plane], Q[plane], D[3 * plane], t = given(T, "t");
    given_points(T, "R", 4, plane, R);
    given_points(T, "Q", 1, plane, Q);
    G(bezier_derivatives)(3, plane, R, t, 2, D);
    num from[plane] = {sub(Q[0], D[0]), sub(Q[1], D[1])}, left = G(cross2)(from, D + plane);
    int upright = is_zero_q(D[2 * plane]) && !is_zero_q(D[2 * plane + 1]), beside = !is_zero_q(from[0]);
    found_points(T, "derivative", 1, plane, D + plane);
    found_points(T, "second derivative", 1, plane, D + 2 * plane);
    found(T, "left side of the equation", left);
    about(T, "whether the equation of the tangent is not satisfied at Q");
    refute(T, upright && beside && is_zero_q(left));
}
#endif

/*
The rest of the list says what is gained.  Most items are properties of Bézier curves that have claims of their own, here or in the chapter on them.

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
:needs: curve_leaves_hull_outside_the_interval | the range beside the formula | $0\le t\le1$: beyond, where $P_1\ne P_2$, it is
  a point of the line and not of the segment
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
  distances from the ends are $|t|$ and $|1-t|$ times the length: $|P(t)-P_1|^2=t^2|P_2-P_1|^2$ and $|P_2-P(t)|^2=(1-t)^2|P_2-P_1|^2$
:method: Each form, everything a variable.  For $0\le t\le1$ the two distances add up to the length, so that the point is between $P_1$ and $P_2$; and each of these points has
  its $t$, the share of its distance from $P_1$ in the length; where $P_1=P_2$ all are one point.
:over: x# y#: points
:control: the two points exchanged in the first form
:::
*/
CLAIM(segment_in_its_parameter)
{
    num b[4], D[4], t = parameter(T, "t"), s = sub(from_int(1), t);
    num length = from_int(0), along = from_int(0), left = from_int(0);
    for (int m = 0; m < 4; m++)
        b[m] = unknown(T, m % 2 == 0 ? "x" : "y", m / 2 + 1);
    G(bezier_derivatives)(1, plane, b, t, 1, D);
    for (int c = 0; c < plane; c++) {
        num from = b[fault(T, c, plane + c)], edge = sub(b[plane + c], b[c]), P;
        G(bezier_casteljau)(1, 1, (num[]){b[c], b[plane + c]}, t, &P);
        about(T, "the point");
        same(T, add(from, mul(edge, t)), P);
        same(T, add(mul(s, b[c]), mul(t, b[plane + c])), D[c]);
        about(T, "the derivative");
        same(T, D[plane + c], edge);
        length = add(length, mul(edge, edge));
        along = add(along, mul(sub(P, b[c]), sub(P, b[c])));
        left = add(left, mul(sub(b[plane + c], P), sub(b[plane + c], P)));
    }
    about(T, "the distance from the first point");
    same(T, along, mul(mul(t, t), length));
    about(T, "the distance from the last point");
    same(T, left, mul(mul(s, s), length));
}

/*
:::{statement} slides-ch4:1-parametric-transform
:title: Transformations act on the parametric equations
:zh: 可对参数方程直接进行几何变换
:printed: Geometric transformations, such as translation, scaling and rotation, can be applied directly to the parametric equations of curves
  and surfaces.
:holds-by: maps_of_the_equations_are_one_matrix
:confirmed-by: matrices_pass_to_the_points image_of_a_power_curve_is_one bezier_curve_moves_with_its_points

A matrix and a shift are applied to the vector $P(t)$ or $P(u,w)$.
:::

:::{claim} maps_of_the_equations_are_one_matrix
:title: Maps of the parametric equations give parametric equations, and two in a row are one map
:zh: 参数方程的几何变换可合成为一个矩阵
:given: the values $x,y,z$ of the parametric equations of a curve or surface, any numbers; two maps, $P\mapsto PT+m$ and $P\mapsto PS+k$, any matrices $T$, $S$ of
  three rows and any $m$, $k$
:then: $(PT+m)S+k=P\,(TS)+(mS+k)$: three equations again, in the same parameters, by one matrix and one vector
:method: Both sides entry by entry, everything a variable.  Translations, scalings and rotations are such maps; what functions $x$, $y$, $z$ are, and of how many
  parameters, is not used.
:scope: every parametric curve and surface
:over: x y z: -; t# s#: matrices; m# k#: translations
:control: the two matrices exchanged
:::
*/
/* out = v M + m */
static void G(mapped)(const num v[], const num M[], const num m[], num out[])
{
    for (int j = 0; j < space; j++) {
        out[j] = m[j];
        for (int k = 0; k < space; k++)
            out[j] = add(out[j], mul(v[k], M[k * space + j]));
    }
}

CLAIM(maps_of_the_equations_are_one_matrix)
{
    num P[space] = {unknown(T, "x", 0), unknown(T, "y", 0), unknown(T, "z", 0)}, M[9], S[9], m[space], k[space];
    for (int i = 0; i < 9; i++)
        M[i] = unknown(T, "t", i), S[i] = unknown(T, "s", i);
    for (int i = 0; i < space; i++)
        m[i] = unknown(T, "m", i), k[i] = unknown(T, "k", i);
    num once[space], twice[space], product[9], shift[space], by_one[space], zero[space];
    G(mapped)(P, M, m, once);
    G(mapped)(once, S, k, twice);
    for (int i = 0; i < space; i++)
        zero[i] = from_int(0);
    for (int i = 0; i < space; i++) /* the rows of T S, or of S T */
        G(mapped)((T->faulty ? S : M) + i * space, T->faulty ? M : S, zero, product + i * space);
    G(mapped)(m, S, k, shift);
    G(mapped)(P, product, shift, by_one);
    for (int i = 0; i < space; i++)
        same(T, by_one[i], twice[i]);
}

/*
:::{statement} slides-ch4:1-freedom
:title: More freedom for the shape
:zh: 参数形式自由度更大
:printed: With a parameter there is more freedom to control the shape of curves and surfaces, a strong power to describe and a rich power to express.
:reading: parametric_cubic_crosses_itself | curves have shapes that no graph $y=f(x)$ has
:reading: parametric_cubic_crosses_itself | surfaces have shapes that no graph $z=f(x,y)$ has | The cylinder of the points $(x,s,z)$ with $(x,z)$ on
  the cubic of reading 1 and any $s$ has two points with one $x$, one $s$ and two different $z$.
:reading: how much freedom, and whether more than with equations $f(x,y)=0$; which power is strong or rich: the slides do not say, so that nothing is there to be decided
:confirmed-by: nodal_cubic_has_an_equation
:figure: graphs_and_axes

Every graph is among the parametric curves, with $x=t$, and among the surfaces, with $x=u$ and $y=w$: so there are more shapes than those of graphs.  An equation $f(x,y)=0$
this cubic has, too: `nodal_cubic_has_an_equation`.
:::

:::{statement} slides-ch4:1-dimensions
:title: Any number of coordinates
:zh: 变量个数不限,便于扩展到高维
:printed: In parametric equations the algebraic and the geometric, the dependent and the independent variables are completely separated, and
  their number is not limited, so that it is easy to take curves and surfaces from a space of few dimensions to one of more.
:reading: matrices_pass_to_the_points | curves and surfaces can be taken from a plane to space: whatever third coordinates the points get, the curve of the plane, or the surface if the functions have two parameters, stays what the first two are, as the
  matrix that leaves the third one out shows
:reading: another_coordinate_changes_no_other | a curve can be taken from any number of coordinates to one more: it keeps those that it has
:reading: what is easy, when variables are completely separated, and which variables besides the coordinates have a number without limit: the slides do not say, so that nothing is there to be decided
:::

:::{claim} another_coordinate_changes_no_other
:title: A further coordinate leaves the others as they are
:zh: 各坐标分量互不影响
:given: points $P_0,\dots,P_n$ with $d+1$ coordinates, $d=1,\dots,5$, any $t$; the points with the first $d$ of these
:then: the first $d$ coordinates of the curve are the curve of these points
:method: The kernel in $d$ and in $d+1$ dimensions, everything a variable.
:degrees: 1..6 sampled 10
:scope: 1 to 5 coordinates
:argued: every degree and any number of coordinates | Each coordinate of the curve is a sum of its own, of the same functions times this coordinate of the points, whatever the others are.
:over: x#: points
:control: the last coordinate in the place of the one before
:::
*/
CLAIM(another_coordinate_changes_no_other)
{
    enum { most = 6 };
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * most], flat[(MAX_DEGREE + 1) * most], P[most], Q[most], t = parameter(T, "t");
    for (int d = 1; d < most; d++) {
        for (int i = 0; i <= n; i++) {
            for (int c = 0; c <= d; c++)
                b[i * (d + 1) + c] = unknown(T, "x", i * most + c);
            for (int c = 0; c < d; c++)
                flat[i * d + c] = b[i * (d + 1) + fault(T, c, c == d - 1 ? d : c)];
        }
        G(bezier_casteljau)(n, d + 1, b, t, P);
        G(bezier_casteljau)(n, d, flat, t, Q);
        for (int c = 0; c < d; c++)
            same(T, Q[c], P[c]);
    }
}

/*
:::{statement} slides-ch4:1-matrices
:title: Vectors and matrices
:zh: 易于用矢量和矩阵表示
:printed: It is easy to represent the geometry by vectors and matrices, and the computation is simple.
:reading: small_degrees_written_out | Bézier curves of the degrees 1, 2 and 3 are products with matrices
:reading: unit_blending_functions | the cubic of two points and two tangents is a product with a $4\times4$ matrix, whose columns are the functions
:reading: what is easy and what simple: an opinion, which no computation decides
:::

:::{statement} slides-ch4:1-bounded
:title: Over the unit interval the coordinates are bounded
:zh: 规格化参数使几何分量有界
:printed: With $t\in[0,1]$ the coordinates are bounded, and no further parameters are needed to mark the border.
:holds-by: one_factor_and_one_term_keep_a_bound
:confirmed-by: bernstein_positive_inside bernstein_sums_to_one bernstein_at_ends range_of_parameters_marks_a_part
:argued: a second parameter | The coefficients of a polynomial of two parameters are polynomials of the second one, and have their bounds by the same claim: so the sum of the absolute values of
  all coefficients is a bound for $0\le u,w\le1$.
:hypothesis: quotient_with_a_pole_is_unbounded | the functions are polynomials: quotients of polynomials may have a pole in $[0,1]$
:meant: the interval $[0,1]$ beside it | The border is what the ends of the interval mark: of a curve the points of $t=0$ and $t=1$, of a surface the four curves of $u=0$, $u=1$, $w=0$ and
  $w=1$.

A bound of a polynomial is the sum of the absolute values of its coefficients.  That all continuous functions are bounded on $[0,1]$ is a theorem of Weierstrass, which is not used here.
:::
*/

#if RATIONAL
/*
:::{claim} quotient_with_a_pole_is_unbounded
:title: A quotient of polynomials with a pole in the interval has no bound
:zh: 区间内有极点的有理函数无界
:kind: counterexample
:data: d = 1 -2; t = 1/2
:instead: d = 1 1
:result: d_0 + d_1 t = 0
:given: the coordinate $x(s)=\frac1{d_0+d_1s}$ for $0\le s\le1$, $s\ne t$, with any value at the given parameter $t$ of $(0,1)$
:then: the denominator is $d_1(s-t)$, so that $|x(s)|=\frac1{|d_1||s-t|}$ is more than any bound near $t$
:method: The denominator at $t$, and $d_1$, exactly; that the first is not 0, or the second is, is refuted.
:control: another denominator
:::
*/
CLAIM(quotient_with_a_pole_is_unbounded)
{
    num d[2], t = given(T, "t");
    given_points(T, "d", 2, 1, d);
    num below = add(d[0], mul(d[1], t));
    int inside_the_interval = sign_q(t) > 0 && compare_q(t, from_int(1)) < 0;
    found(T, "d_0 + d_1 t", below);
    about(T, "whether the denominator has no zero at t");
    refute(T, inside_the_interval && is_zero_q(below) && !is_zero_q(d[1]));
}
#endif

/*
:::{statement} slides-ch4:1-part
:title: A part of a curve or of a surface
:zh: 用参数范围界定曲线或曲面的一部分
:printed: A part of a curve or of a surface can simply be marked off by $a\le t\le b$.
:holds-by: range_of_parameters_marks_a_part
:confirmed-by: triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power interval_kernel_gives_the_part surface_part_is_the_piece
:meant: the formula $a\le t\le b$ beside it | Simply is: by the two numbers $a$ and $b$ alone, for each parameter; a part is what such
  ranges mark off, of a surface a rectangle of its two parameters.
:reading: range_of_parameters_marks_a_part | ranges mark off a part
:reading: triangle_of_parameters_is_no_rectangle | every part can be marked off by ranges
:::

:::{claim} range_of_parameters_marks_a_part
:title: Two numbers mark a part, whatever the functions of the parameter are
:zh: 参数区间界定曲线或曲面的一部分
:types: field rational
:given: two ranges, $[a,a+h]$ of $t$ and $[c,c+g]$ of another parameter, $h,g>0$; $0\le s\le1$
:harmless: $h,g>0$ | a range of two different numbers, in order
:harmless: $0\le s\le1$ | these are the parameters of the part
:let: $t=a+hs$
:then: $a\le t\le a+h$; $s=\frac{t-a}h$; $t=a$ for $s=0$ and $t=a+h$ for $s=1$; and the same of the other parameter
:method: Signs of coefficients for $s=\frac x{1+x}$, $x>0$, and identities.  No function of the curve or surface is in it: $P(a+hs)$ is its part from $a$ to $a+h$ over
  $[0,1]$, and $P(a+hs,c+gr)$ the part of a surface over the square of $s$ and $r$, one parameter at a time.
:scope: every parametric curve and surface
:over: a c h g x: -
:control: $s=\frac th$
:::
*/
CLAIM(range_of_parameters_marks_a_part)
{
    static const char *const begin[] = {"a", "c"}, *const extent[] = {"h", "g"};
    num s = inside(T, "x"), zero = from_int(0), one = from_int(1);
    for (int k = 0; k < 2; k++) {
        num a = unknown(T, begin[k], 0), h = positive(T, extent[k], 0), t = add(a, mul(h, s));
        about(T, "within the range");
        nonnegative(T, sub(t, a));
        nonnegative(T, sub(add(a, h), t));
        about(T, "s from t");
        same(T, div(sub(t, fault(T, a, zero)), h), s);
        about(T, "the ends");
        same(T, add(a, mul(h, zero)), a);
        same(T, add(a, mul(h, one)), add(a, h));
    }
}

#if RATIONAL
/*
:::{claim} triangle_of_parameters_is_no_rectangle
:title: A triangle of the parameters is marked off by no ranges
:zh: 参数三角形不能由参数范围界定
:kind: counterexample
:data: c = 1; corners = (0,0) (1,0) (0,1); (s,t) = (1,1)
:instead: c = 2
:result: sums of the corners = 0 1 1; s + t = 2
:given: the part of a surface where $s+t\le c$, three places of it, and a fourth place $(s,t)$
:then: ranges of the two parameters that have the three places have the fourth, which is not in the part
:method: Each of the two parameters of the fourth place is one of those of the three; the sums are compared with $c$.
:control: a part that has the fourth place
:::
*/
CLAIM(triangle_of_parameters_is_no_rectangle)
{
    num c = given(T, "c"), corners[6], place[2], sums[3];
    given_points(T, "corners", 3, 2, corners);
    given_points(T, "(s,t)", 1, 2, place);
    int in_part = 1, in_ranges[2] = {0, 0};
    for (int k = 0; k < 3; k++) {
        sums[k] = add(corners[2 * k], corners[2 * k + 1]);
        in_part &= compare_q(sums[k], c) <= 0;
        for (int m = 0; m < 2; m++)
            in_ranges[m] |= equal_q(corners[2 * k + m], place[m]);
    }
    num sum = add(place[0], place[1]);
    found_points(T, "sums of the corners", 3, 1, sums);
    found(T, "s + t", sum);
    about(T, "whether ranges that have the three places mark off the part");
    refute(T, in_part && in_ranges[0] && in_ranges[1] && compare_q(sum, c) > 0);
}
#endif

/*
:::{statement} slides-ch4:1-pieces
:title: Pieces that are joined smoothly
:zh: 便于分段、分片描述与光顺连接
:printed: With $t\in[0,1]$ curves and surfaces are conveniently described piece by piece, and smooth joints are easy to make.
:reading: triangle_of_powers_consists_of_powers | a curve of any degree is cut into curves of the same degree over $[0,1]$
:reading-with: bernstein_sum_of_powers_is_a_power
:reading: triangle_of_powers_consists_of_powers | a surface is cut into surfaces of the same degrees over $0\le u,w\le1$ | For a fixed $w$ the surface is a curve of the parameter $u$, whose
  points are those of the rows of the net at $w$; the points of its part are sums of multiples of these, with factors in which there is no $w$, so that they are the rows of a net at $w$, too.  Then $w$ is cut in the same way.  With weights all this is said of the
  weights, and of the points times their weights.
:reading-with: bernstein_sum_of_powers_is_a_power
:confirmed-by: surface_part_is_the_piece
:reading: derivatives_go_down_through_the_differences | of a curve the derivatives of any order at the ends are multiples of differences of the points next to them, so that points can be chosen for a smooth joint
:reading-with: bernstein_derivative
:reading: derivatives_go_down_through_the_differences | of a surface the derivatives across an edge are multiples of differences of the rows of points next to it | For a fixed $w$ the surface is a curve of the parameter $u$, whose points are those of the rows
  of the net at $w$; their differences are the curves of the differences of the rows, so that rows can be chosen for a joint that is smooth for every $w$.
:reading-with: bernstein_derivative
:reading: what is convenient and what easy: an opinion, which no computation decides
:::

Last come two pairs of words.  To interpolate is to pass through the points.  To approximate is used in two senses that exclude each
other: for a curve whose shape follows a control polygon, and for a curve that is nearest to the points.

:::{statement} slides-ch4:1-two-kinds
:title: Curves through the points, and curves with a control polygon
:zh: 插值曲线与逼近曲线
:printed: A curve or surface that has to pass through the points is interpolating; one that need not, and whose shape is controlled by the polygon of
  the points, is approximating.  Interpolation: a curve through the points in their order.
:definition: yes
:checked-by: one_cubic_passes_through_four_data
:confirmed-by: parabola_through_the_points_is_nearer

Checked is that a polynomial interpolates, at the parameters $0,1,\dots,n$.  A Bézier curve is of the second kind: in `parabola_through_the_points_is_nearer` it misses one of its points.
:::

:::{statement} slides-ch4:1-approximation
:title: Approximation is nearest in some sense
:zh: 逼近指某种意义下最佳
:printed: Approximation: a curve is constructed that is nearest to the points in some sense.
:definition: yes
:checked-by: parabola_through_the_points_is_nearer nearest_line_meets_no_datum
:example: two senses of nearest, and for each one set of points.

In which sense is left open.  By the distance from the points a Bézier curve, approximating by the words before, need not be an approximation: in the first
example a curve of the same degree passes through the points.  By the least sum of squares one line is nearest in the second.
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
:method: The points of both curves at the three parameters; $x=2t$ along the Bézier curve, at three parameters and so at all, so that it is at the $x$ of the
  second point nowhere else.
:control: the same curve twice
:::
*/
CLAIM(parabola_through_the_points_is_nearer)
{
    num Q[3 * plane], R[3 * plane], t[3], P[plane];
    given_points(T, "Q", 3, plane, Q);
    given_points(T, "t", 3, 1, t);
    given_points(T, "R", 3, plane, R);
    about(T, "x along the Bézier curve");
    for (int k = 0; k <= 2; k++) {
        G(bezier_casteljau)(2, plane, Q, t[k], P);
        same(T, P[0], mul(from_int(2), t[k]));
    }
    G(bezier_casteljau)(2, plane, Q, t[1], P);
    num distance = sub(Q[plane + 1], P[1]);
    found(T, "distance", distance);
    about(T, "the distance of the Bézier curve from the second point, straight down");
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

#include "chapters/judge/claims_off.h"
