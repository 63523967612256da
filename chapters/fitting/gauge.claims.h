/*
# What the points cannot tell (规范与自由方向)

Different unknowns can give one curve, and then no measured points tell them apart.  Some of this freedom is known beforehand and
taken away by a convention, the gauge; the rest shows in the rank of the Jacobian (雅可比矩阵的秩).
*/
#include "chapters/fitting/definition.h"

#include "chapters/judge/claims_on.h"

/*
## The gauge (规范)
*/

/* The 2n+2 knots 0, ..., 0, 1, ..., 1. */
static void G(bezier_knots)(int n, num u[])
{
    for (int i = 0; i < 2 * n + 2; i++)
        u[i] = from_int(i > n);
}

/*
A rational Bézier curve does not determine its weights: all of them may be multiplied by one number, and a fractional-linear change of the parameter
multiplies them by a geometric progression.  In the derivatives these two freedoms are two combinations that do not move the curve.

:::{claim} weights_have_flat_directions
:title: Two directions in the space of weights that move no point off the curve
:zh: 权空间中的两个平坦方向
:given: a rational Bézier curve of degree $n$, weights, points of one coordinate, any $t$
:then: $\sum_i\frac{\partial C}{\partial\lambda_i}=0$ and $\sum_ii\,\frac{\partial C}{\partial\lambda_i}=t(1-t)\,C'$.  The first says that a common
  factor of the weights changes nothing, the second that the fractional-linear change of the parameter only slides along the curve: after the
  projection across the curve both columns are 0
:method: The kernel of the derivatives by the weights against that of the derivative by $t$, everything variables.
:degrees: 1..4 sampled 9
:over: y#: points
:control: $n-i$ in the place of $i$
:::
*/
CLAIM(weights_have_flat_directions)
{
    int n = T->degree;
    num u[2 * MOST_POINTS], w[MOST_POINTS], R[MOST_POINTS], by[MOST_POINTS], D[2], t = parameter(T, "t");
    num sum = from_int(0), moment = from_int(0);
    G(bezier_knots)(n, u);
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        R[i] = unknown(T, "y", i);
    }
    G(nurbs_by_weights)(G(nurbs_on_span)(n, 1, u, n, R, w), t, 0, by);
    G(rational_derivatives)(n, 1, R, w, t, 1, D);
    for (int i = 0; i <= n; i++) {
        sum = add(sum, by[i]);
        moment = add(moment, mul(from_int(fault(T, i, n - i)), by[i]));
    }
    about(T, "a common factor");
    vanishes(T, sum);
    about(T, "a change of the parameter"); /* sum of i dC/dlambda_i = t (1-t) C' */
    same(T, moment, mul(mul(t, sub(from_int(1), t)), D[1]));
}

/*
:::{claim} feet_and_distances_do_not_see_the_gauge
:title: A fractional-linear change of the parameter takes feet to feet and keeps distances
:zh: 分式线性变换保持垂足与距离
:given: a rational Bézier curve of degree $n$ in the plane; $t=\frac{au}{au+b(1-u)}$, the weights $a^ib^{n-i}w_i$; a point $Q$
:then: with $D=C-Q$ the squared distance $|D|^2$ is the same at $u$ and $t$, and $D\cdot\frac{dC}{du}=D\cdot\frac{dC}{dt}\cdot\frac{ab}{(au+b(1-u))^2}$, so that a foot is a foot
:method: The two curves by their weights, everything variables.
:degrees: 1..3 sampled 8
:over: x# y# q#: points; a b: parameter change
:control: the parameter $u$ for both
:::
*/
CLAIM(feet_and_distances_do_not_see_the_gauge)
{
    int n = T->degree;
    num w[MOST_POINTS], v[MOST_POINTS], R[2 * MOST_POINTS], Q[2], D[4], E[4], x[2], y[2];
    num a = positive(T, "a", 0), b = positive(T, "b", 0), t = parameter(T, "t"), one = from_int(1);
    num below = add(mul(a, t), mul(b, sub(one, t))), image = div(mul(a, t), below); /* t is the book's u here */
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        R[2 * i] = unknown(T, "x", i);
        R[2 * i + 1] = unknown(T, "y", i);
    }
    Q[0] = unknown(T, "q", 0), Q[1] = unknown(T, "q", 1);
    G(rational_reparametrize)(n, w, a, b, v);
    G(rational_derivatives)(n, 2, R, v, t, 1, D);
    G(rational_derivatives)(n, 2, R, w, fault(T, image, t), 1, E);
    for (int c = 0; c < 2; c++) {
        x[c] = sub(D[c], Q[c]);
        y[c] = sub(E[c], Q[c]);
    }
    about(T, "the distance");
    same(T, G(dot)(2, x, x), G(dot)(2, y, y));
    about(T, "the condition of the foot");
    same(T, G(dot)(2, x, D + 2), mul(G(dot)(2, y, E + 2), div(mul(a, b), mul(below, below))));
}

#if RATIONAL
/* Rows det(C', C_a) at t = i/(count+1) for the given unknowns: unknown -1-m is lambda_m, unknown 2m+c coordinate c of
 * point m. */
static void jacobian_across(int n, const num R[], const num w[], int count, int unknowns, const int unknown_of[],
                            num J[])
{
    for (int i = 0; i < count; i++) {
        num u[2 * MOST_POINTS], by[2 * MOST_POINTS], B[MOST_POINTS], D[4], t = from_ratio(i + 1, count + 1);
        G(bezier_knots)(n, u);
        G(nurbs_by_weights)(G(nurbs_on_span)(n, 2, u, n, R, w), t, 0, by);
        G(nurbs_basis)(G(nurbs_on_span)(n, 0, u, n, NULL, w), t, 0, B);
        G(rational_derivatives)(n, 2, R, w, t, 1, D);
        for (int k = 0; k < unknowns; k++) {
            int m = unknown_of[k];
            num e[2] = {m >= 0 && m % 2 == 0 ? B[m / 2] : from_int(0), m >= 0 && m % 2 == 1 ? B[m / 2] : from_int(0)};
            J[i * unknowns + k] = G(cross2)(D + 2, m >= 0 ? e : by + 2 * (-1 - m));
        }
    }
}

/*
Without a gauge the Hessian is therefore singular, at every curve and for all points.  With $w_0=w_n=1$, the standard form, the directions above
are gone, and so is the singularity.

:::{claim} without_gauge_the_hessian_is_singular
:title: With every weight free the rank is short by two
:zh: 全部权自由时秩亏为二
:kind: counterexample
:data: R = (0,0) (1,4) (5,4) (6,0); ω = 1 2 2 1; N = 12; first = 0; last = 3
:instead: first = 1; last = 2
:result: unknowns = 4; rank = 2
:given: the cubic with points $R$ and weights $\omega$, and $N$ points on it at equal steps of the parameter, the ends left out; the weights from
  the first to the last of the given indices are free, the control points not
:then: the rank of the reduced Jacobian is less than the number of unknowns, by two
:method: Its rows $\det(C',C_a)$, the derivatives across the curve up to a factor, are rational; Gaussian elimination over $\mathbb Q$.  That the rank
  is full is refuted; as the residuals are 0 the Hessian is $J^TJ$: singular.
:control: the weights of both ends held at 1
:::
*/
CLAIM(without_gauge_the_hessian_is_singular)
{
    num R[8], w[4];
    int free_ones[4], unknowns = 0;
    given_points(T, "R", 4, 2, R);
    given_points(T, "ω", 4, 1, w);
    int N = given_whole(T, "N"), first = given_whole(T, "first"), last = given_whole(T, "last");
    for (int i = first; i <= last && i < 4; i++)
        free_ones[unknowns++] = -1 - i;
    num *J = region_bytes((size_t)(N * unknowns) * sizeof *J);
    jacobian_across(3, R, w, N, unknowns, free_ones, J);
    int rank = rank_over_q(N, unknowns, J);
    found_whole(T, "unknowns", unknowns);
    found_whole(T, "rank", rank);
    about(T, "rank and number of unknowns");
    same(T, from_int(rank), from_int(unknowns));
}
#endif

/*
## Ends that slide (端点沿曲线滑动)

A conic is five numbers.  A rational quadratic with free points and one weight is seven: both ends may slide along the conic.
*/

#if RATIONAL
/*
:::{claim} free_ends_slide_along_the_conic
:title: With free ends the rank of an arc of a circle is five of seven
:zh: 端点自由时圆弧的秩为五
:kind: decision
:data: R = (65,0) (65,65) (0,65); ω = 1 1 2; N = 12
:result: rank = 5
:given: the arc of a circle about the origin with the points $R$ and the weights $\omega$; $N$ points on it; unknowns $\lambda_1$ and the six coordinates
:then: the reduced Jacobian has a rank that is two less than the number of unknowns, and its kernel contains the two directions in which an end slides: the
  end along its tangent by $\varepsilon$ times the radius, the middle point to where the tangents meet, by as much the other way, and $\lambda_1$ by
  $\frac\varepsilon2$
:method: Gaussian elimination over $\mathbb Q$, and the product of the Jacobian with the two directions, exactly.
:control: $\lambda_1$ by $\varepsilon$
:::
*/
CLAIM(free_ends_slide_along_the_conic)
{
    enum { UNKNOWN = 7 };
    /* lambda_1, then x_0, y_0, x_1, y_1, x_2, y_2; twice the directions, in units of the radius but for lambda_1 */
    static const int free_ones[] = {-2, 0, 1, 2, 3, 4, 5};
    static const int slide[2][UNKNOWN] = {{1, 0, 2, -2, 0, 0, 0}, {1, 0, 0, 0, -2, 2, 0}};
    num R[6], w[3];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    int N = given_whole(T, "N");
    num *J = region_bytes((size_t)(N * UNKNOWN) * sizeof *J);
    jacobian_across(2, R, w, N, UNKNOWN, free_ones, J);
    about(T, "a sliding end");
    for (int d = 0; d < 2; d++)
        for (int i = 0; i < N; i++) {
            num sum = mul(from_int(fault(T, slide[d][0], 2 * slide[d][0])), J[i * UNKNOWN]);
            for (int k = 1; k < UNKNOWN; k++)
                sum = add(sum, mul(mul(from_int(slide[d][k]), R[0]), J[i * UNKNOWN + k]));
            vanishes(T, sum);
        }
    int rank = rank_over_q(N, UNKNOWN, J);
    found_whole(T, "rank", rank);
    about(T, "the rank");
    same(T, from_int(rank), from_int(UNKNOWN - 2));
}
#endif

/*
## Points on a line (共线点)

The worst case is a line.  A point that moves along the line, or a weight that changes, leaves the figure as it is.

:::{claim} a_straight_curve_leaves_its_speed_undetermined
:title: Where the curve is straight, only the heights of its points are seen
:zh: 曲线退化为直线时仅能定出法向坐标
:given: a rational Bézier curve of degree $n$ with all points on the $x$-axis
:then: across the curve the derivatives by all weights and by all $x_m$ are 0, and those by $y_m$ are $R_m$ times the speed: of $n-1$ weights and $2n+2$ coordinates at most $n+1$ numbers are determined
:method: The determinants with $C'$, the points $x_m$, weights and $t$ variables.
:degrees: 1..4 sampled 8
:over: x#: points
:control: the last point one above the axis
:::
*/
CLAIM(a_straight_curve_leaves_its_speed_undetermined)
{
    int n = T->degree;
    num u[2 * MOST_POINTS], w[MOST_POINTS], R[2 * MOST_POINTS], by[2 * MOST_POINTS], B[MOST_POINTS], D[4];
    num t = parameter(T, "t"), zero = from_int(0);
    G(bezier_knots)(n, u);
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        R[2 * i] = unknown(T, "x", i);
        R[2 * i + 1] = from_int(fault(T, 0, i == n));
    }
    G(nurbs_by_weights)(G(nurbs_on_span)(n, 2, u, n, R, w), t, 0, by);
    G(nurbs_basis)(G(nurbs_on_span)(n, 0, u, n, NULL, w), t, 0, B);
    G(rational_derivatives)(n, 2, R, w, t, 1, D);
    for (int m = 0; m <= n; m++) {
        num ex[2] = {B[m], zero}, ey[2] = {zero, B[m]};
        about(T, "by a weight");
        vanishes(T, G(cross2)(D + 2, by + 2 * m));
        about(T, "by a coordinate along the line");
        vanishes(T, G(cross2)(D + 2, ex));
        about(T, "by a height");
        same(T, G(cross2)(D + 2, ey), mul(B[m], D[2]));
    }
}

#if RATIONAL
/*
:::{claim} points_on_a_line_leave_rank_three
:title: A conic with its points on a line has rank three of seven, and with given ends one of three
:zh: 共线点拟合二次曲线时的秩
:kind: decision
:data: R = (0,0) (2,0) (3,0); ω = 1 2 1; N = 12
:instead: R = (0,0) (2,1) (3,0)
:result: rank with free ends = 3; rank with given ends = 1
:given: the quadratic with points $R$ and weights $\omega$, which is a segment, and $N$ points on it; $\lambda_1$ and all six coordinates free, or only those
  of $R_1$
:then: the rank is the number of heights that are free
:method: Gaussian elimination over $\mathbb Q$ of the derivatives across the curve.
:control: $R_1$ above the segment
:::
*/
CLAIM(points_on_a_line_leave_rank_three)
{
    static const int all[] = {-2, 0, 1, 2, 3, 4, 5}, inner[] = {-2, 2, 3};
    num R[6], w[3];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    int N = given_whole(T, "N");
    num *J = region_bytes((size_t)(N * 7) * sizeof *J);
    jacobian_across(2, R, w, N, 7, all, J);
    int of_all = rank_over_q(N, 7, J);
    jacobian_across(2, R, w, N, 3, inner, J);
    int of_inner = rank_over_q(N, 3, J);
    found_whole(T, "rank with free ends", of_all);
    found_whole(T, "rank with given ends", of_inner);
    same(T, from_int(of_all), from_int(3)); /* y_0, y_1, y_2 */
    same(T, from_int(of_inner), from_int(1));
}
#endif

#include "chapters/judge/claims_off.h"
