/*
# A space curve and two cylinders (空间曲线与柱面)

One sentence of the list is about curves in space, and says more than it seems to.

In space one equation is a surface, and two are needed.  The slides think of cylinders, each over a projection of the curve to a plane of two
axes.  Every point of the curve is on both; the question is what else is.  For two graphs over one axis nothing else is.  For an ellipse and two
of its cylinders, and for a circle that is tilted against all three axes and any two of them, there is a second curve.
*/
#include "chapters/hermite-coons/definition.h"

#include "chapters/judge/claims_on.h"

enum { space = 3 };

/*
:::{statement} slides-ch4:1-space-curve
:title: A space curve as an intersection of two cylinders
:zh: 空间曲线与两张柱面的交线
:printed: Explicit equations without a parameter describe plane curves only; a space curve has to be defined as the intersection of two
  cylinders.
:holds-by: both_equations_hold_at_one_point
:hypothesis: closed_curve_is_no_pair_of_graphs | one coordinate has different values at different points: so it is for explicit equations
  $y=f(x)$, $z=g(x)$, and for those of two coordinates by another one
:meant: the first half of the sentence, on explicit equations (显示方程) | Of explicit equations each has two of the coordinates and is a cylinder; two of
  them are needed, and define the curve.
:reading: both_equations_hold_at_one_point | by two explicit equations $y=f(x)$, $z=g(x)$, each of them a cylinder
:reading: surfaces_that_are_no_cylinders_meet_in_a_curve | in no other way: surfaces that have just the curve in common are cylinders
:reading: no_two_projections_give_the_circle | by the cylinders over some two of its projections along the axes, for every curve
:reading: two_cylinders_hold_more_than_the_curve | by the cylinders over any two of its projections along the axes, for every curve for which some two of them will do
:confirmed-by: graphs_over_one_axis_meet_in_one_curve graphs_over_two_axes_meet_in_a_closed_curve two_cylinders_are_two_ellipses
  two_cylinders_of_the_circle_hold_an_ellipse
:figure: two_cylinders

The condition is enough and not necessary: $z=x^2$ and $z=1-y^2$ are explicit equations and meet in a closed curve,
`graphs_over_two_axes_meet_in_a_closed_curve`.  The cylinders over the projections of the ellipse $x^2+y^2=1$, $z=y$ along $z$ and $y$ have more in common than the ellipse:
the ellipses of $z=y$ and of $z=-y$, `two_cylinders_are_two_ellipses`.  Two of the cylinders of the
circle $x^2+y^2+z^2=2$, $x+y+z=0$ have in common the circle and an ellipse of a plane in which two coordinates are equal,
`two_cylinders_of_the_circle_hold_an_ellipse`.
:::

:::{claim} both_equations_hold_at_one_point
:title: For each value of x the equations of the two cylinders hold at one point, that of the curve
:zh: 两显式方程对每个 x 恰有一公共点
:given: any functions $f$ and $g$ of $x$, with the values $f$ and $g$ at $t$; any point $(t,y,z)$
:then: $(y-f)^2+(z-g)^2$ is the square of its distance from $(t,f,g)$: so $y=f(x)$ and $z=g(x)$ hold both exactly where it is that point
:method: An identity, the values of the functions variables; a sum of two squares is 0 only where both are.
:scope: all functions f and g
:over: t y z f g: -
:control: another abscissa of the point of the curve
:::
*/
CLAIM(both_equations_hold_at_one_point)
{
    num t = parameter(T, "t"), y = unknown(T, "y", 0), z = unknown(T, "z", 0);
    num f = unknown(T, "f", 0), g = unknown(T, "g", 0), a = sub(y, f), b = sub(z, g);
    num gap[space] = {sub(t, fault(T, t, add(t, from_int(1)))), a, b};
    same(T, G(norm_squared)(space, gap), add(mul(a, a), mul(b, b)));
}

/*
:::{claim} graphs_over_one_axis_meet_in_one_curve
:title: Two graphs over one axis are two cylinders that meet in one curve
:zh: 两个显式方程所表示的柱面之交线
:given: $y=f(x)$ and $z=g(x)$ with polynomials of degree $n$ whose Bernstein coefficients are $f_i$ and $g_i$, any $f$, $g$ and $t$
:then: the curve of the points $(\frac in,f_i,g_i)$ is at $(t,f(t),g(t))$: on both cylinders, with one point for each $x$
:method: The point by `bezier_casteljau`, the functions by their powers, everything a variable.  Of the points with $x=t$ no other satisfies
  both equations.
:degrees: 1..6 sampled 10
:over: f# g#: coefficients
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

/*
:::{claim} graphs_over_two_axes_meet_in_a_closed_curve
:title: Two graphs over different axes meet in a closed curve
:zh: 不同轴上的两个显式方程交于一闭曲线
:given: any $x,y,z$
:then: $(z-(1-y^2))-(z-x^2)=x^2+y^2-1$
:method: An identity.  Where $z=x^2$ and $z=1-y^2$ the right side is 0; and where it is 0 and $z=x^2$ the other equation holds.  So the two graphs meet
  in the curve of the points $(x,y,x^2)$ with $x^2+y^2=1$, which is closed.
:over: x# y# z#: points
:control: $z=y^2$ in the place of $z=1-y^2$
:::
*/
CLAIM(graphs_over_two_axes_meet_in_a_closed_curve)
{
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), z = unknown(T, "z", 0), one = from_int(1);
    num squares[2] = {mul(x, x), mul(y, y)}, second = sub(z, fault(T, sub(one, squares[1]), squares[1]));
    same(T, sub(second, sub(z, squares[0])), sub(add(squares[0], squares[1]), one));
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
:over: x#: points
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
:::{claim} surfaces_that_are_no_cylinders_meet_in_a_curve
:title: Two surfaces that are no cylinders have just a space curve in common
:zh: 两张非柱面的曲面交于一空间曲线
:kind: counterexample
:data: F = (0,1,0,-1) (-1,1,1,-1)
:instead: F = (0,1,0,-1) (-1,0,1,0)
:result: determinants = 1 1; F_2 on the first surface = -1 0 1
:given: two surfaces $F_k=ax^2+bxy+dy+ez=0$ by their coefficients $a,b,d,e$, of which the first is $z=xy$; the curve $(t,t^2,t^3)$
:then: both equations hold along the curve, and, since $F_2$ is on the first surface a multiple of $y-x^2$, nowhere else; neither surface is a cylinder
:method: The equations by powers of $t$; the coefficients of $x^2$, $xy$ and $y$ in $F_2$ where $z$ is that of the first surface.  With $e\ne0$ a surface is a
  cylinder in the direction $(p,q,r)$ only if $(2ax+by)p+(bx+d)q+er=0$ for all $x$ and $y$, which are three equations for $p,q,r$; the direction is not
  $(0,0,0)$, so that their determinant is 0.
:control: the second surface is the cylinder $y=x^2$
:::
*/
CLAIM(surfaces_that_are_no_cylinders_meet_in_a_curve)
{
    num F[2 * 4], determinants[2], on[3], zero = from_int(0);
    given_points(T, "F", 2, 4, F);
    about(T, "the equations along the curve");
    for (int k = 0; k < 2; k++) {
        const num *c = F + 4 * k; /* a, b, d, e; along the curve x^2 and y are t^2, xy and z are t^3 */
        vanishes(T, add(c[0], c[2]));
        vanishes(T, add(c[1], c[3]));
        num rows[9] = {mul(from_int(2), c[0]), c[1], zero, c[1], zero, zero, zero, c[2], c[3]};
        determinants[k] = determinant_q(3, rows);
    }
    for (int j = 0; j < 3; j++)
        on[j] = sub(F[4 + j], mul(div(F[7], F[3]), F[j]));
    found_points(T, "determinants", 2, 1, determinants);
    found_points(T, "F_2 on the first surface", 3, 1, on);
    about(T, "whether one of the surfaces is a cylinder, or more than the curve is on both");
    refute(T, !is_zero_q(determinants[0]) && !is_zero_q(determinants[1]) && is_zero_q(on[1]) && !is_zero_q(on[2]));
}

/*
:::{claim} two_cylinders_hold_more_than_the_curve
:title: A point of both cylinders that is not on the curve
:zh: 两柱面交线多于原曲线
:kind: counterexample
:data: (x, y, z) = (0,1,-1)
:instead: (x, y, z) = (0,1,1)
:given: the ellipse $x^2+y^2=1$, $z=y$, which its projections along the axes $z$ and $x$ determine; those along $z$ and $y$ are the circles $x^2+y^2=1$ and
  $x^2+z^2=1$; a point of space
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
:title: The ellipse has two points for one x, for one y and for one z
:zh: 闭曲线不是显式方程组
:kind: counterexample
:data: p = (3/5,4/5,4/5) (3/5,-4/5,-4/5) (-3/5,4/5,4/5)
:instead: p = (3/5,4/5,4/5) (3/5,4/5,4/5) (3/5,4/5,4/5)
:given: the ellipse $x^2+y^2=1$, $z=y$ and three of its points $p$: the first two with one $x$, the first and the third with one $y$ and one $z$
:then: with $y=f(x)$ the first two would have one $y$, with $z=f(x)$ one $z$, with $x=f(y)$ or $x=f(z)$ the first and the third one $x$, and they have
  not
:method: The points on the ellipse, exactly; their coordinates.  Of explicit equations $y=f(z)$ and $z=f(y)$ remain, in which there is no $x$: no two
  equations, of whatever coordinates, define the ellipse.
:control: the first point three times
:::
*/
CLAIM(closed_curve_is_no_pair_of_graphs)
{
    num points[3 * space];
    given_points(T, "p", 3, space, points);
    for (int k = 0; k < 3; k++) {
        const num *p = points + k * space;
        about(T, "the ellipse");
        same(T, add(mul(p[0], p[0]), mul(p[1], p[1])), from_int(1));
        same(T, p[2], p[1]);
    }
    const num *second = points + space, *third = points + 2 * space;
    about(T, "x of the first two points, y and z of the first and the third");
    same(T, points[0], second[0]);
    same(T, points[1], third[1]);
    same(T, points[2], third[2]);
    about(T, "whether there is one point for each value of x, or of y, or of z");
    refute(T, !equal_q(points[1], second[1]) && !equal_q(points[2], second[2]) && !equal_q(points[0], third[0]));
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
:over: x# y# z#: points
:control: $(y-z)^2$ on the right
:::
*/
CLAIM(two_cylinders_are_two_ellipses)
{
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), z = unknown(T, "z", 0), one = from_int(1);
    num first = sub(add(mul(x, x), mul(y, y)), one), second = sub(add(mul(x, x), mul(z, z)), one);
    same(T, sub(first, second), mul(sub(y, z), fault(T, add(y, z), sub(y, z))));
}

#include "chapters/judge/claims_off.h"
