/*
# Points of a cubic, fast (曲线上点的计算)

A cubic in powers of its parameter is computed for many equidistant parameters.  The source gives three ways: the powers as
they stand, the rule of Horner (秦九韶算法), and a table of forward differences (向前差分) that needs additions only.
*/
#include "chapters/foundations/definition.h"

#if RATIONAL
#include "chapters/judge/counting.h"
#include "exact/record/roots.h"
#include "exact/record/sign.h"

/* The kernels in binary64, and those of this section once more in the number type that counts. */
#undef G
#include "core/kernels/kernels_d.h"
#define G(name) name##_c
#include "core/kernels/power.tmpl.h"
#undef G
#define G(name) name##_q
#endif

#include "chapters/judge/claims_on.h"

/*
## Descriptions

:::{statement} hu-1987:1-4-slopes
:title: A curve as the graph of a function has infinite slopes and several values
:zh: 非参数形式的无穷斜率与多值问题
:printed: In the fitting of curves the form that is not parametric has the problem of slopes $dy/dx=\infty$, and that of several
  values.
:holds-by: parabola_across_has_no_slope
:figure: infinite_slope_and_two_values
:::
*/

#if RATIONAL
/*
:::{claim} parabola_across_has_no_slope
:title: A parametric curve with a vertical tangent and two values
:zh: 竖直切线与多值
:kind: decision
:given: a parabola that lies across, with the coefficients $c$, on $[0,1]$; a parameter $t$; two abscissas $x$
:data: c = (1,0) (-4,1) (4,0); t = 1/2; x = 1/4 -1/4
:instead: c = (-1,0) (2,1) (0,0)
:then: at $t$ the component $x'$ is 0 and $P'\ne0$; over the first abscissa there are two points, over the second none
:result: P'(t) = (0,1); points over x = 2 0
:method: The derivatives by the kernel; the parameters with $x(t)=x$ are counted as roots.
:control: a line in the place of the parabola
:::
*/
CLAIM(parabola_across_has_no_slope)
{
    num c[6], D[4], x[2], points[2];
    given_points(T, "c", 3, 2, c);
    num t = given(T, "t");
    given_points(T, "x", 2, 1, x);
    G(power_derivatives)(2, 2, c, t, 1, D);
    poly abscissa = poly_from_q(3, (num[]){c[0], c[2], c[4]});
    for (int k = 0; k < 2; k++) {
        poly gap = poly_sub(abscissa, poly_constant(x[k]));
        points[k] = from_int(count_roots(gap, from_int(0), from_int(1), CLOSED).distinct);
    }
    found_points(T, "P'(t)", 1, 2, D + 2);
    found_points(T, "points over x", 2, 1, points);
    agree(T, is_zero_q(D[2]) && !is_zero_q(D[3]));
    same(T, points[0], from_int(2));
    same(T, points[1], from_int(0));
}

/*
:::{statement} hu-1987:1-4-advantage-extent
:title: The extent of a curve is given by an interval of its parameter
:zh: 用参数区间指定曲线的延伸范围
:printed: A piece of a curve is the part from $t=a$ to $t=b$, $a\le t\le b$; also where there are several values its extent can be given
  conveniently.
:holds-by: intervals_of_the_parameter_separate_the_values
:figure: infinite_slope_and_two_values
:::

:::{claim} intervals_of_the_parameter_separate_the_values
:title: Two intervals of the parameter separate the two values
:zh: 参数区间分开多值
:kind: decision
:given: the same parabola, whose abscissa has the coefficients $c$, on $[0,s]$ and on $[s,1]$
:data: c = 1 -4 4; s = 1/2
:instead: s = 3/4
:then: each piece has one point over every $x$ of $[0,1]$: $x$ falls on the first piece and rises on the second
:result: x(0), x(s), x(1) = 1 0 1
:method: The sign of $x'$ on the two open intervals, and $x$ at the ends, exactly.
:control: a later $s$
:::
*/
CLAIM(intervals_of_the_parameter_separate_the_values)
{
    num c[3], zero = from_int(0), one = from_int(1);
    given_points(T, "c", 3, 1, c);
    num s = given(T, "s");
    poly x = poly_from_q(3, c), slope = poly_derivative(x);
    num ends[3] = {poly_value(x, zero), poly_value(x, s), poly_value(x, one)};
    found_points(T, "x(0), x(s), x(1)", 3, 1, ends);
    agree(T, sign_on(slope, zero, s, OPEN) == SIGN_NEGATIVE && sign_on(slope, s, one, OPEN) == SIGN_POSITIVE);
    same(T, ends[0], one);
    same(T, ends[1], zero);
    same(T, ends[2], one);
}

/*
:::{statement} hu-1987:1-4-advantage-points
:title: Points of a parametric curve are easily computed
:zh: 曲线上点的计算容易
:printed: For a curve $P(t)=[x(t)\;y(t)\;z(t)]$ the coordinates are explicit functions of $t$, so points are easily computed.
:holds-by: horner_computes_the_sum_of_powers

The word printed is "surface", the example is a curve; for a polynomial curve the points cost the operations that are counted below.
:::

:::{statement} hu-1987:1-4-lowest-degree
:title: The lowest degree of a polynomial curve in CAGD is three
:zh: 参数多项式曲线最低为三次
:printed: In CAGD the lowest degree of parametric curves given by polynomials is three.
:refuted-by: quadratic_curve_is_in_use
:class: false
:corrected: Three is the lowest degree of a polynomial curve that leaves every plane, and of a plane one, no line, with an inflection.
:corrected-by: quadratics_are_plane_and_turn_to_one_side cubics_leave_the_plane_and_inflect
:hypothesis: lines_of_lower_degree_have_curvature_zero | No line, in the correction: a line has curvature 0 everywhere.
:figure: degrees_two_and_three

The table of contents of the source has a section on uniform quadratic B-spline surfaces.
:::

:::{claim} quadratic_curve_is_in_use
:title: The parabola is a polynomial curve of degree two
:zh: 二次曲线段
:kind: counterexample
:given: the parabola with the coefficients $c$; the degree $n$ that is printed as the lowest, and a parameter $t$
:data: c = (0,0) (1,0) (0,1) (0,0); n = 3; t = 1/3
:instead: c = (0,0) (1,0) (0,0) (0,1)
:then: its degree is less than $n$, and it is no line
:result: degree = 2; P' × P''(t) = 2
:method: The highest coefficient that is not 0, and $P'\times P''\ne0$.
:control: a cubic
:::
*/
CLAIM(quadratic_curve_is_in_use)
{
    int degree = 3;
    num c[8], D[6];
    given_points(T, "c", 4, 2, c);
    int lowest = given_whole(T, "n");
    G(power_derivatives)(3, 2, c, given(T, "t"), 2, D);
    while (is_zero_q(c[2 * degree]) && is_zero_q(c[2 * degree + 1]))
        degree--;
    num turning = G(cross2)(D + 2, D + 4);
    found_whole(T, "degree", degree);
    found(T, "P' × P''(t)", turning);
    about(T, "whether the degree is at least n, or the curve is a line");
    refute(T, degree < lowest && !is_zero_q(turning));
}
#endif

/*
:::{claim} quadratics_are_plane_and_turn_to_one_side
:title: A quadratic curve is plane and, unless it is a line, has no inflection
:zh: 二次曲线为平面曲线,非直线时无拐点
:given: any $P(t)=c_0+c_1t+c_2t^2$ in space, any $t$
:then: $P'\times P''=2\,c_1\times c_2$ does not depend on $t$, and $(c_1\times c_2)\cdot(P(t)-c_0)=0$
:method: The derivatives by the kernel, everything a variable.  $c_1\times c_2=0$ makes $P(t)-c_0$ a multiple of one vector, so the curve is a line.
:control: a coefficient $c_3$ added
:::
*/
CLAIM(quadratics_are_plane_and_turn_to_one_side)
{
    enum { space = 3 };
    num c[4 * space], D[3 * space], t = parameter(T, "t"), bend[space], normal[space], gone[space], at[space];
    int n = fault(T, 2, 3);
    G(free_points)(T, n, space, c);
    G(power_derivatives)(n, space, c, t, 2, D);
    G(cross3)(D + space, D + 2 * space, bend);
    G(cross3)(c + space, c + 2 * space, normal);
    G(power_point)(n, space, c, t, at);
    for (int j = 0; j < space; j++) {
        same(T, bend[j], mul(from_int(2), normal[j]));
        gone[j] = sub(at[j], c[j]);
    }
    vanishes(T, G(dot)(space, normal, gone));
}

#if RATIONAL
/*
:::{claim} lines_of_lower_degree_have_curvature_zero
:title: Lines of degree one and two have curvature zero everywhere
:zh: 一、二次直线的曲率恒为零
:kind: counterexample
:given: two parameters of one line on $[0,1]$, with the coefficients $P$ and $Q$
:data: P = (0,0) (1,0) (0,0) (0,0); Q = (0,0) (1,0) (1,0) (0,0)
:instead: P = (0,0) (1,0) (0,1) (0,0)
:then: $P'\ne0$ and $P'\times P''=0$ everywhere, and so for $Q$
:result: P' × P'' = "0"; Q' × Q'' = "0"
:method: The kernels for cubics, with the third coefficients 0, and the sign of $x'$; that the vector product is not 0 everywhere is refuted.
:control: a parabola in the place of the first line
:::
*/
CLAIM(lines_of_lower_degree_have_curvature_zero)
{
    static const char *const curve[2] = {"P", "Q"}, *const product[2] = {"P' × P''", "Q' × Q''"};
    num c[2][8], minors[3], f[3];
    int everywhere = 1;
    for (int k = 0; k < 2; k++)
        given_points(T, curve[k], 4, 2, c[k]);
    for (int k = 0; k < 2; k++) {
        G(cubic_minors)(c[k], minors);
        G(inflection_polynomial)(minors, f);
        poly x = poly_from_q(3, (num[]){c[k][0], c[k][2], c[k][4]}), turning = poly_from_q(3, f);
        found_text(T, product[k], poly_to_string(turning, "t"));
        everywhere = everywhere && poly_is_zero(turning) &&
                     sign_on(poly_derivative(x), from_int(0), from_int(1), CLOSED) == SIGN_POSITIVE;
    }
    about(T, "whether the vector product is not 0 somewhere");
    refute(T, everywhere);
}

/*
:::{claim} cubics_leave_the_plane_and_inflect
:title: A cubic can leave every plane, and a plane one can have an inflection
:zh: 三次曲线可不在平面内,可有拐点
:kind: decision
:given: a cubic in space and one in the plane, with the coefficients $S$ and $P$, and $t>0$
:data: S = (0,0,0) (1,0,0) (0,1,0) (0,0,1); P = (0,0) (1,0) (0,0) (0,1); t = 1/3
:instead: S = (0,0,0) (1,0,0) (0,1,1) (0,0,0); P = (0,0) (1,0) (0,1) (0,0)
:then: the determinant $(S',S'',S''')$ is not 0; $P'\times P''$ changes its sign between $-t$ and $t$
:result: (S',S'',S''') = 12; P' × P'' at -t and t = -2 2
:method: The kernels, at $t$ and at $\pm t$.
:control: coefficients of degree 2
:::
*/
CLAIM(cubics_leave_the_plane_and_inflect)
{
    num space[12], plane[8], D[12], sides[2];
    given_points(T, "S", 4, 3, space);
    given_points(T, "P", 4, 2, plane);
    num t = given(T, "t");
    G(power_derivatives)(3, 3, space, t, 3, D);
    num volume = G(det3)(D + 3, D + 6, D + 9);
    for (int side = 0; side < 2; side++) {
        G(power_derivatives)(3, 2, plane, side ? t : neg(t), 2, D);
        sides[side] = G(cross2)(D + 2, D + 4);
    }
    found(T, "(S',S'',S''')", volume);
    found_points(T, "P' × P'' at -t and t", 2, 1, sides);
    agree(T, !is_zero_q(volume));
    agree(T, sign_q(sides[0]) < 0 && sign_q(sides[1]) > 0);
}
#endif

/*
## Horner's rule (秦九韶算法)

:::{statement} hu-1987:1-4-1
:title: A cubic in powers
:zh: 参数三次曲线
:definition: yes
:printed: P(t)=At^3+Bt^2+Ct+D\qquad(0\le t\le1)
:checked-by: horner_computes_the_sum_of_powers
:::

:::{statement} hu-1987:1-4-2
:title: The cubic by Horner's rule
:zh: 三次曲线的嵌套形式
:printed: P(t)=[(At+B)t+C]t+D
:holds-by: horner_computes_the_sum_of_powers
:::

:::{claim} horner_computes_the_sum_of_powers
:title: Horner's rule computes the point of the curve
:zh: 秦九韶算法求曲线上的点
:given: any coefficients in space, any $t$
:then: `power_point` gives $\sum_kc_kt^k$
:method: The kernel against the sum of powers, each by repeated multiplication; everything a variable.
:degrees: 0..7 sampled 16
:defines: power_point
:control: the coefficients taken backwards
:::
*/
CLAIM(horner_computes_the_sum_of_powers)
{
    enum { space = 3 };
    int n = T->degree;
    num c[(MAX_DEGREE + 1) * space], used[(MAX_DEGREE + 1) * space], P[space], t = parameter(T, "t");
    G(free_points)(T, n, space, c);
    for (int k = 0; k <= n; k++)
        for (int j = 0; j < space; j++)
            used[k * space + j] = c[fault(T, k, n - k) * space + j];
    G(power_point)(n, space, used, t, P);
    for (int j = 0; j < space; j++)
        same(T, P[j], G(power_sum)(n, space, c, j, t));
}

/*
:::{statement} hu-1987:1-4-horner-count
:title: Horner's rule saves half of the multiplications
:zh: 乘法次数由六次减为三次
:printed: So the number of multiplications for a point is reduced from 6 to 3.
:holds-by: multiplications_are_six_and_three
:reading: multiplications_are_six_and_three | Powers multiplied out one by one, $A\cdot t\cdot t\cdot t+B\cdot t\cdot t+C\cdot t+D$, one coordinate: 6
  become 3.
:reading: kept_powers_need_five | With $t^2$ and $t^3=t^2\cdot t$ kept, it is 5 that become 3 for one coordinate, and
  $2+3d$ that become $3d$ for $d$ coordinates.
:::
*/

#if RATIONAL
static const num_c some_number = {0};

/* sum c_k t^k for dim coordinates as it is written: with the powers kept, each is computed once for all coordinates. */
#define SUM_OF_POWERS(S)                                                                                               \
    static void sum_of_powers_##S(int n, int dim, int kept, const num_##S c[], num_##S t, num_##S P[])                 \
    {                                                                                                                  \
        num_##S power[MAX_DEGREE + 1];                                                                                 \
        power[1] = t;                                                                                                  \
        for (int k = 2; kept && k <= n; k++)                                                                           \
            power[k] = mul_##S(power[k - 1], t);                                                                       \
        for (int j = 0; j < dim; j++) {                                                                                \
            P[j] = c[j];                                                                                               \
            for (int k = 1; k <= n; k++) {                                                                             \
                num_##S term = c[k * dim + j];                                                                         \
                for (int i = 0; i < (kept ? 1 : k); i++)                                                               \
                    term = mul_##S(term, kept ? power[k] : t);                                                         \
                P[j] = add_##S(P[j], term);                                                                            \
            }                                                                                                          \
        }                                                                                                              \
    }
SUM_OF_POWERS(c)
SUM_OF_POWERS(q)

/* Both are run in the type that counts, and in rationals for others to count. */
static struct operations cost_of_powers(trial *T, int n, int dim, int kept)
{
    num_c c[(MAX_DEGREE + 1) * MAX_DIM], P[MAX_DIM];
    num_q x[(MAX_DEGREE + 1) * MAX_DIM], at[MAX_DIM];
    for (int m = 0; m < (n + 1) * dim; m++) {
        c[m] = some_number;
        x[m] = unknown_q(T, "c", m);
    }
    sum_of_powers_q(n, dim, kept, x, parameter_q(T, "t"), at);
    counted = (struct operations){0};
    sum_of_powers_c(n, dim, kept, c, some_number, P);
    note_cost(dim, at, counted);
    return counted;
}

static struct operations cost_of_horner(trial *T, int n, int dim)
{
    num_c c[(MAX_DEGREE + 1) * MAX_DIM], P[MAX_DIM];
    num_q x[(MAX_DEGREE + 1) * MAX_DIM], at[MAX_DIM];
    for (int m = 0; m < (n + 1) * dim; m++) {
        c[m] = some_number;
        x[m] = unknown_q(T, "c", m);
    }
    power_point_q(n, dim, x, parameter_q(T, "t"), at);
    counted = (struct operations){0};
    power_point_c(n, dim, c, some_number, P);
    note_cost(dim, at, counted);
    return counted;
}

/*
:::{claim} multiplications_are_six_and_three
:title: The multiplications of the two forms, counted
:zh: 两种形式的乘法次数
:kind: decision
:given: degrees up to $N$, one coordinate; and the degree $n$ of the source
:data: N = 12; n = 3
:then: for degree $k$ the sum of powers takes $\frac{k(k+1)}2$ multiplications and $k$ additions, Horner's rule $k$ and $k$
:result: multiplications of the sum = 6; of Horner's rule = 3
:method: The definition's loop and the kernel are run in a number type that counts.
:scope: degrees 1 to 12
:control: the powers kept from term to term
:::
*/
CLAIM(multiplications_are_six_and_three)
{
    int largest = given_whole(T, "N"), n = given_whole(T, "n");
    for (int k = 1; k <= largest; k++) {
        struct operations powers = cost_of_powers(T, k, 1, fault(T, 0, 1)), horner = cost_of_horner(T, k, 1);
        agree(T, powers.multiplications == k * (k + 1) / 2 && powers.additions == k);
        agree(T, horner.multiplications == k && horner.additions == k && horner.shifts == 0);
        if (k == n) {
            found_whole(T, "multiplications of the sum", powers.multiplications);
            found_whole(T, "of Horner's rule", horner.multiplications);
        }
    }
}

/*
:::{claim} kept_powers_need_five
:title: With the powers kept five multiplications are enough before Horner's rule
:zh: 保留幂次时只需五次乘法
:kind: counterexample
:given: degree $n$, one coordinate, $t^2$ and $t^3$ computed once; the number of multiplications that is printed
:data: n = 3; printed = 6
:then: fewer multiplications than are printed
:result: multiplications = 5
:method: The loop is run in the number type that counts.
:control: every power multiplied out anew
:::
*/
CLAIM(kept_powers_need_five)
{
    int n = given_whole(T, "n"), printed = given_whole(T, "printed");
    int multiplications = cost_of_powers(T, n, 1, fault(T, 0, 1)).multiplications;
    found_whole(T, "multiplications", multiplications);
    about(T, "the multiplications before Horner's rule");
    same(T, from_int(multiplications), from_int(printed));
}

/*
:::{claim} multiplications_with_kept_powers
:title: The multiplications when the powers are kept
:zh: 保留幂次时的乘法次数
:kind: decision
:given: degree $n$, one to $D$ coordinates
:data: n = 3; D = 3
:then: for $d$ coordinates, with $t^2$ and $t^3$ computed once, $n-1+nd$ multiplications; Horner's rule $nd$
:method: Both loops are run in the number type that counts.
:scope: degree 3, one to three coordinates
:control: the powers computed anew for every coordinate
:::
*/
CLAIM(multiplications_with_kept_powers)
{
    int n = given_whole(T, "n"), most = given_whole(T, "D");
    for (int d = 1; d <= most; d++) {
        agree(T, cost_of_powers(T, n, d, fault(T, 1, 0)).multiplications == n - 1 + n * d);
        agree(T, cost_of_horner(T, n, d).multiplications == n * d);
    }
}
#endif

/*
## Forward differences (向前差分)

:::{statement} hu-1987:1-4-difference-1-definition
:title: The first forward difference
:zh: 一阶向前差分的定义
:printed: \Delta P(t)=P(t-\delta)-P(t)
:refuted-by: printed_first_difference_looks_back
:class: misprint
:corrected: \Delta P(t)=P(t+\delta)-P(t)
:corrected-by: differences_of_a_cubic
:figure: forward_differences

The sign of $\delta$: the formula printed beside it is that of the forward difference.
:::

:::{statement} hu-1987:1-4-difference-1
:title: The first difference of the cubic
:zh: 一阶差分
:printed: \Delta P(t)=3A\delta t^2+(3A\delta^2+2B\delta)t+A\delta^3+B\delta^2+C\delta
:holds-by: differences_of_a_cubic
:figure: forward_differences
:::

:::{statement} hu-1987:1-4-difference-2
:title: The second difference of the cubic
:zh: 二阶差分
:printed: \Delta^2P(t)=\Delta P(t+\delta)-\Delta P(t)=6A\delta^2t+6A\delta^3+2B\delta^2
:holds-by: differences_of_a_cubic
:figure: forward_differences
:::
*/

/* The printed expressions of the differences of order 1, 2, 3 for c = (D, C, B, A). */
static num G(printed_difference)(int order, const num c[], num t, num delta)
{
    num A = c[3], B = c[2], C = c[1], d2 = mul(delta, delta), d3 = mul(d2, delta);
    if (order == 1) {
        num linear = add(mul(from_int(3), mul(A, d2)), mul(from_int(2), mul(B, delta)));
        num constant = add(add(mul(A, d3), mul(B, d2)), mul(C, delta));
        return add(add(mul(mul(from_int(3), mul(A, delta)), mul(t, t)), mul(linear, t)), constant);
    }
    num Ad3 = mul(from_int(6), mul(A, d3));
    if (order == 3)
        return Ad3;
    return add(add(mul(mul(from_int(6), mul(A, d2)), t), Ad3), mul(from_int(2), mul(B, d2)));
}

/*
:::{claim} differences_of_a_cubic
:title: The three forward differences of a cubic
:zh: 三次曲线的各阶向前差分
:given: any $A$, $B$, $C$, $D$, any $t$ and $\delta$
:then: $P(t+\delta)-P(t)$, $\Delta P(t+\delta)-\Delta P(t)$ and $\Delta^2P(t+\delta)-\Delta^2P(t)$ are the three printed expressions
:method: The differences of the sums of powers at $t,\dots,t+3\delta$, everything a variable; one coordinate, any one.
:control: $t-\delta$ in the place of $t+\delta$
:::
*/
CLAIM(differences_of_a_cubic)
{
    num c[4], t = parameter(T, "t"), delta = parameter(T, "d"), D[4][4];
    G(free_points)(T, 3, 1, c);
    num step = fault(T, delta, neg(delta));
    for (int i = 0; i <= 3; i++)
        D[0][i] = G(power_sum)(3, 1, c, 0, add(t, mul(from_int(i), step)));
    for (int k = 1; k <= 3; k++) {
        for (int i = 0; i <= 3 - k; i++)
            D[k][i] = sub(D[k - 1][i + 1], D[k - 1][i]);
        same(T, D[k][0], G(printed_difference)(k, c, t, delta));
    }
}

#if RATIONAL
/*
:::{claim} printed_first_difference_looks_back
:title: With the printed argument the first difference has another sign
:zh: 印刷的一阶差分符号有误
:kind: counterexample
:given: the line with the coefficients $c$, from $D$ to $A$; $t$ and $\delta$
:data: c = 0 1 0 0; t = 0; δ = 1
:then: $P(t-\delta)-P(t)$ is not the expression that is printed for it
:result: P(t-δ) - P(t) = -1; printed expression = 1
:method: Both sides of the printed line, exactly.
:control: $P(t+\delta)$
:::
*/
CLAIM(printed_first_difference_looks_back)
{
    num c[4];
    given_points(T, "c", 4, 1, c);
    num t = given(T, "t"), delta = given(T, "δ"), other = fault(T, add(t, delta), sub(t, delta));
    num difference = sub(G(power_sum)(3, 1, c, 0, other), G(power_sum)(3, 1, c, 0, t));
    num printed = G(printed_difference)(1, c, t, delta);
    found(T, "P(t-δ) - P(t)", difference);
    found(T, "printed expression", printed);
    about(T, "the difference, and the expression printed for it");
    same(T, difference, printed);
}

/*
:::{statement} hu-1987:1-4-difference-3-definition
:title: The third forward difference
:zh: 三阶差分的定义
:printed: \Delta^3P(t)=\Delta^2P(t-\delta)-\Delta^2P(t)=6A\delta^3
:refuted-by: printed_third_difference_has_the_other_sign
:class: misprint
:corrected: \Delta^3P(t)=\Delta^2P(t+\delta)-\Delta^2P(t)=6A\delta^3
:corrected-by: differences_of_a_cubic
:figure: forward_differences
:::

:::{claim} printed_third_difference_has_the_other_sign
:title: With the printed argument the third difference is the negative
:zh: 印刷的三阶差分符号有误
:kind: counterexample
:given: the cubic with the coefficients $c$, from $D$ to $A$; $t$ and $\delta$
:data: c = 0 0 0 1; t = 0; δ = 1
:then: $\Delta^2P(t-\delta)-\Delta^2P(t)$ is the negative of the value that is printed for it
:result: Δ²P(t-δ) - Δ²P(t) = -6; printed value = 6
:method: Both sides, with the printed $\Delta^2P(t)$, which is right.
:control: $\Delta^2P(t+\delta)$
:::
*/
CLAIM(printed_third_difference_has_the_other_sign)
{
    num c[4];
    given_points(T, "c", 4, 1, c);
    num t = given(T, "t"), delta = given(T, "δ"), other = fault(T, add(t, delta), sub(t, delta));
    num difference = sub(G(printed_difference)(2, c, other, delta), G(printed_difference)(2, c, t, delta));
    num printed = G(printed_difference)(3, c, t, delta);
    found(T, "Δ²P(t-δ) - Δ²P(t)", difference);
    found(T, "printed value", printed);
    about(T, "the difference, and the value printed for it");
    same(T, difference, printed);
}
#endif

/*
:::{statement} hu-1987:1-4-constant-difference
:title: The n-th difference of a curve of degree n is constant
:zh: n 次多项式的 n 阶差分为常矢量
:printed: The third difference is a vector that does not depend on the parameter; in general the $n$-th difference of a polynomial
  of degree $n$ is a constant vector.
:holds-by: differences_by_alternating_sums
:figure: forward_differences
:::
*/

/* The alternating sum of order k at t, coordinate j. */
static num G(alternating_sum)(int n, int dim, const num c[], int j, int k, num t, num delta)
{
    num sum = from_int(0);
    for (int i = 0; i <= k; i++) {
        num value = G(power_sum)(n, dim, c, j, add(t, mul(from_int(i), delta)));
        num term = mul(from_int(binomial(k, i)), value);
        sum = (k - i) % 2 == 0 ? add(sum, term) : sub(sum, term);
    }
    return sum;
}

/*
:::{claim} differences_by_alternating_sums
:title: The kernel's table holds the forward differences; the last is constant
:zh: 差分表与末阶差分
:given: any coefficients in the plane, any $\delta$
:then: row $k$ of `power_differences` is $\sum_i(-1)^{k-i}\binom kiP(i\delta)$, and its last row is $n!\,c_n\,\delta^n$, which does not
  depend on the place: at any $t$ the alternating sum of $P(t),\dots,P(t+n\delta)$ is the same
:method: The kernel against alternating sums of the definition, at 0 and at a variable $t$.
:degrees: 1..6 sampled 12
:defines: power_differences
:control: the place $t$ taken in the difference of order $n-1$
:::
*/
CLAIM(differences_by_alternating_sums)
{
    enum { dim = 2 };
    int n = T->degree;
    num c[(MAX_DEGREE + 1) * dim], d[(MAX_DEGREE + 1) * dim], t = parameter(T, "t"), delta = parameter(T, "d");
    G(free_points)(T, n, dim, c);
    G(power_differences)(n, dim, c, delta, d);
    for (int j = 0; j < dim; j++) {
        for (int k = 0; k <= n; k++)
            same(T, d[k * dim + j], G(alternating_sum)(n, dim, c, j, k, from_int(0), delta));
        num last = mul(c[n * dim + j], G(power)(delta, n));
        for (int k = 2; k <= n; k++)
            last = mul(last, from_int(k));
        same(T, d[n * dim + j], last);
        int order = fault(T, n, n - 1);
        same(T, G(alternating_sum)(n, dim, c, j, order, t, delta), d[order * dim + j]);
    }
}

/*
### Stepping

:::{statement} hu-1987:1-4-3-places
:title: The place of the differences with the index 1
:zh: 下标 1 的差分所在参数
:printed: $P_1,\Delta P_1,\Delta^2P_1,\Delta^3P_1$ are the differences at $t=i\delta$, and $P_1=P_0+\Delta P_0$.
:refuted-by: step_from_zero_reaches_one_step_only
:class: misprint
:corrected: They are the differences at $t=\delta$.
:corrected-by: additions_step_along_the_curve
:figure: forward_differences

For $i=1$ it is true.
:::
*/

#if RATIONAL
/*
:::{claim} step_from_zero_reaches_one_step_only
:title: One step from 0 does not reach the second place
:zh: 一步不能到达第 i 点
:kind: counterexample
:given: the line with the coefficients $c$, $\delta$ and $i$
:data: c = 0 1; δ = 1; i = 2
:instead: i = 1
:then: $P_0+\Delta P_0$ is not $P(i\delta)$
:result: P_0 + ΔP_0 = 1; P(iδ) = 2
:method: Both values, exactly.
:control: the first place
:::
*/
CLAIM(step_from_zero_reaches_one_step_only)
{
    num c[2], d[2];
    given_points(T, "c", 2, 1, c);
    num delta = given(T, "δ"), place = mul(given(T, "i"), delta), there = G(power_sum)(1, 1, c, 0, place);
    G(power_differences)(1, 1, c, delta, d);
    G(difference_step)(1, 1, d);
    found(T, "P_0 + ΔP_0", d[0]);
    found(T, "P(iδ)", there);
    about(T, "P_0 + ΔP_0, and P(iδ)");
    same(T, d[0], there);
}
#endif

/*
:::{claim} additions_step_along_the_curve
:title: The table runs along the curve
:zh: 差分表沿曲线前进
:given: any coefficients in the plane, any $\delta$, 12 steps
:then: after $i$ steps the first row is $P(i\delta)$
:method: `power_differences`, then `difference_step` again and again, against the sum of powers.
:degrees: 1..6 sampled 8
:control: the last difference taken as 0
:::
*/
CLAIM(additions_step_along_the_curve)
{
    enum { dim = 2 };
    int n = T->degree;
    num c[(MAX_DEGREE + 1) * dim], d[(MAX_DEGREE + 1) * dim], delta = parameter(T, "d");
    G(free_points)(T, n, dim, c);
    G(power_differences)(n, dim, c, delta, d);
    d[n * dim] = fault(T, d[n * dim], from_int(0));
    for (int i = 0; i <= 12; i++) {
        for (int j = 0; j < dim; j++)
            same(T, d[j], G(power_sum)(n, dim, c, j, mul(from_int(i), delta)));
        G(difference_step)(n, dim, d);
    }
}

/*
:::{statement} hu-1987:1-4-3
:title: One step of the table
:zh: 差分递推
:printed: P_1=P_0+\Delta P_0,\quad\Delta P_1=\Delta P_0+\Delta^2P_0,\quad\Delta^2P_1=\Delta^2P_0+\Delta^3P_0,\quad\Delta^3P_1=\Delta^3P_0
:holds-by: step_takes_differences_to_the_next_place
:figure: forward_differences
:::

:::{claim} step_takes_differences_to_the_next_place
:title: The step of the table takes the differences at one place to those at the next
:zh: 差分表前进一步
:given: any coefficients in the plane, any $t$ and $\delta$
:then: `difference_step`, and with the rows divided by $\delta^k$ `scaled_difference_step`, take the differences at $t$ to those
  at $t+\delta$
:method: The kernels on the alternating sums at $t$, against those at $t+\delta$.
:degrees: 1..6 sampled 12
:defines: difference_step scaled_difference_step
:control: the differences at $t+2\delta$
:::
*/
CLAIM(step_takes_differences_to_the_next_place)
{
    enum { dim = 2 };
    int n = T->degree;
    num c[(MAX_DEGREE + 1) * dim], d[(MAX_DEGREE + 1) * dim], e[(MAX_DEGREE + 1) * dim];
    num t = parameter(T, "t"), delta = positive(T, "d", 0), next = add(t, delta);
    G(free_points)(T, n, dim, c);
    for (int k = 0; k <= n; k++)
        for (int j = 0; j < dim; j++) {
            d[k * dim + j] = G(alternating_sum)(n, dim, c, j, k, t, delta);
            e[k * dim + j] = div(d[k * dim + j], G(power)(delta, k));
        }
    G(difference_step)(n, dim, d);
    G(scaled_difference_step)(n, dim, delta, e);
    next = fault(T, next, add(next, delta));
    for (int k = 0; k <= n; k++)
        for (int j = 0; j < dim; j++) {
            num there = G(alternating_sum)(n, dim, c, j, k, next, delta);
            same(T, d[k * dim + j], there);
            same(T, e[k * dim + j], div(there, G(power)(delta, k)));
        }
}

/*
:::{statement} hu-1987:1-4-stepping
:title: All points by repeated additions
:zh: 反复加法求各点
:printed: If the differences at $t=0$ are known, the points of the curve at $t=\delta,2\delta,\dots,i\delta,\dots$ are found one after the other by
  repeated additions.
:holds-by: additions_step_along_the_curve
:figure: forward_differences
:::

:::{statement} hu-1987:1-4-no-multiplications
:title: With differences no multiplication is left
:zh: 差分法不用乘法
:printed: With differences multiplications are not needed at all, only shifts and additions.
:holds-by: step_costs_additions_only table_costs_shifts_and_additions
:needs: other_steps_need_multiplications | The step is a power of two, $\delta=2^{-m}$, and the differences are divided by its powers as
  in (1-4-4) and (1-4-5).  For another step the table has to be begun with multiplications.
:figure: stepping_and_rounding
:::
*/

#if RATIONAL
static struct operations cost_of_step(trial *T, int n, int dim, int scaled, int power_of_two)
{
    num_c d[(MAX_DEGREE + 1) * MAX_DIM], delta = {power_of_two};
    num_q x[(MAX_DEGREE + 1) * MAX_DIM], step = power_of_two ? from_ratio_q(1, 256) : parameter_q(T, "d");
    for (int m = 0; m < (n + 1) * dim; m++) {
        d[m] = some_number;
        x[m] = unknown_q(T, "e", m);
    }
    counted = (struct operations){0};
    if (scaled) {
        scaled_difference_step_c(n, dim, delta, d);
        scaled_difference_step_q(n, dim, step, x);
    } else {
        difference_step_c(n, dim, d);
        difference_step_q(n, dim, x);
    }
    note_cost((n + 1) * dim, x, counted);
    return counted;
}

/*
:::{claim} step_costs_additions_only
:title: A step costs n additions for each coordinate, and, scaled, n shifts
:zh: 每步的加法与移位次数
:kind: decision
:given: degrees $n=1,\dots,12$, one to three coordinates $d$, $\delta=2^{-m}$
:then: `difference_step` costs $nd$ additions and nothing else, `scaled_difference_step` $nd$ additions and $nd$ shifts
:method: The kernels are run in the number type that counts.
:scope: degrees 1 to 12, one to three coordinates
:control: a step that is no power of two
:::
*/
CLAIM(step_costs_additions_only)
{
    for (int n = 1; n <= 12; n++)
        for (int d = 1; d <= 3; d++) {
            struct operations plain = cost_of_step(T, n, d, 0, 1), scaled = cost_of_step(T, n, d, 1, fault(T, 1, 0));
            agree(T, plain.additions == n * d && plain.multiplications == 0 && plain.shifts == 0);
            agree(T, scaled.additions == n * d && scaled.multiplications == 0 && scaled.shifts == n * d);
        }
}

/*
:::{claim} table_costs_shifts_and_additions
:title: The table of a cubic costs shifts and additions
:zh: 建立差分表的运算次数
:kind: decision
:given: one coordinate, $\delta$ a power of two, the rows of (1-4-5) as $D$, $(A\delta+B)\delta+C$, $2(A'\delta+B)$ and $2A'$ with $A'=2A+A$
:data: δ = 1/256
:then: shifts and additions, and no multiplication
:result: shifts = 6; additions = 4; multiplications = 0
:method: The rows are formed in the number type that counts, and in rationals for any $A,B,C,D$, where they are the
  printed ones.
:control: a step that is no power of two
:::
*/
/* (1-4-5) as shifts and additions: e from c = (D, C, B, A), 3A as 2A + A. */
#define TABLE_BY_SHIFTS(S)                                                                                             \
    static void table_by_shifts_##S(const num_##S c[], num_##S delta, num_##S e[])                                     \
    {                                                                                                                  \
        num_##S two = from_int_##S(2), three_A = add_##S(mul_##S(two, c[3]), c[3]);                                    \
        e[0] = c[0];                                                                                                   \
        e[1] = add_##S(mul_##S(add_##S(mul_##S(c[3], delta), c[2]), delta), c[1]);                                     \
        e[2] = mul_##S(two, add_##S(mul_##S(three_A, delta), c[2]));                                                   \
        e[3] = mul_##S(two, three_A);                                                                                  \
    }
TABLE_BY_SHIFTS(c)
TABLE_BY_SHIFTS(q)

CLAIM(table_costs_shifts_and_additions)
{
    num_c c[4] = {some_number, some_number, some_number, some_number}, e[4], step = {fault(T, 1, 0)};
    num x[4], d[4], table[4], delta = given(T, "δ"), power = from_int(1);
    for (int k = 0; k < 4; k++)
        x[k] = unknown(T, "c", k);
    table_by_shifts_q(x, delta, table);
    counted = (struct operations){0};
    table_by_shifts_c(c, step, e);
    if (!T->faulty)
        note_cost(4, table, counted);
    found_whole(T, "shifts", counted.shifts);
    found_whole(T, "additions", counted.additions);
    found_whole(T, "multiplications", counted.multiplications);
    agree(T, counted.multiplications == 0 && counted.divisions == 0);
    G(power_differences)(3, 1, x, delta, d);
    for (int k = 0; k < 4; k++, power = mul(power, delta))
        same(T, table[k], div(d[k], power));
}

/*
:::{claim} other_steps_need_multiplications
:title: For other steps the products remain
:zh: 一般步长仍需乘法
:kind: counterexample
:given: a step that is no power of two, degree $n$, one coordinate, one step of (1-4-4)
:data: n = 3
:then: a multiplication for each difference
:result: multiplications = 3
:method: The kernel is run in the number type that counts.
:control: a power of two
:::
*/
CLAIM(other_steps_need_multiplications)
{
    struct operations step = cost_of_step(T, given_whole(T, "n"), 1, 1, fault(T, 1, 0));
    found_whole(T, "multiplications", step.multiplications);
    about(T, "that there is no multiplication");
    agree(T, step.multiplications == 0);
}
#endif

/*
### The scaled table

:::{statement} hu-1987:1-4-small-differences
:title: The differences after the third are small
:zh: 高阶差分已相当小
:printed: For $\delta=1/2^8$ the differences after $\Delta^3P_0$ have become rather small.
:holds-by: third_difference_loses_three_bytes
:reading: third_difference_loses_three_bytes | those of order 4 and more: they are 0, for every $\delta$
:reading: third_difference_loses_three_bytes | from the third on, against the coefficients: true, $6A/2^{24}$
:reading: third_difference_exceeds_the_first | from the third on, against the differences before it: false
:figure: forward_differences
:::

:::{claim} third_difference_loses_three_bytes
:title: The size of the differences for the step 1/256
:zh: 步长 1/256 时各阶差分的大小
:given: $P(t)=At^3+Bt^2+Ct+D$, $\delta=\frac1n$ with $n=2^m$, any coefficients
:data: n = 256; m = 8
:instead: n = 128
:then: $\Delta^3P_0$ is six times $A/2^{3m}$, and the differences of order 4 and more are 0
:method: The table of a cubic as one of degree four by the kernel, so that the fourth difference comes from five points; everything but the
  step a variable.
:control: twice the step
:::
*/
CLAIM(third_difference_loses_three_bytes)
{
    num c[5], d[5], delta = div(from_int(1), given(T, "n")), scale = from_ratio(1, 1L << 3 * given_whole(T, "m"));
    for (int k = 0; k < 4; k++)
        c[k] = unknown(T, "c", k);
    c[4] = from_int(0);
    G(power_differences)(4, 1, c, delta, d);
    same(T, d[3], mul(c[3], mul(from_int(6), scale))); /* Δ³P_0 = 6 A δ³ */
    vanishes(T, d[4]);
}

#if RATIONAL
/*
:::{claim} third_difference_exceeds_the_first
:title: The third difference is six times the first
:zh: 三阶差分为一阶差分的六倍
:kind: counterexample
:given: the cubic with the coefficients $c$, from $D$ to $A$, and $\delta$
:data: c = 0 0 0 1; δ = 1/256
:instead: c = 0 1 0 1
:then: $\Delta^3P_0$ is larger than $\Delta P_0$
:result: P_0, ΔP_0, Δ²P_0, Δ³P_0 = 0 1/16777216 3/8388608 3/8388608; Δ³P_0 / ΔP_0 = 6
:method: The table by the kernel; that the third is less than the first is refuted.
:control: a cubic with a linear term
:::
*/
CLAIM(third_difference_exceeds_the_first)
{
    num c[4], d[4];
    given_points(T, "c", 4, 1, c);
    G(power_differences)(3, 1, c, given(T, "δ"), d);
    found_points(T, "P_0, ΔP_0, Δ²P_0, Δ³P_0", 4, 1, d);
    found(T, "Δ³P_0 / ΔP_0", div(d[3], d[1]));
    about(T, "whether the third difference is less than the first");
    agree(T, compare_q(d[3], d[1]) < 0);
}
#endif

/*
:::{statement} hu-1987:1-4-4
:title: The step of the scaled table
:zh: 规格化差分的递推
:printed: P_1=P_0+\delta(\tfrac1\delta\Delta P_0),\ \ \tfrac1\delta\Delta P_1=\tfrac1\delta\Delta P_0+\delta(\tfrac1{\delta^2}\Delta^2P_0),\ \
  \tfrac1{\delta^2}\Delta^2P_1=\tfrac1{\delta^2}\Delta^2P_0+\delta(\tfrac1{\delta^3}\Delta^3P_0),\ \ \tfrac1{\delta^3}\Delta^3P_1=\tfrac1{\delta^3}\Delta^3P_0
:holds-by: step_takes_differences_to_the_next_place
:figure: forward_differences
:::

:::{statement} hu-1987:1-4-5
:title: The table to begin with
:zh: 初始差分矩阵
:printed: \begin{bmatrix}P_0\\\frac1\delta\Delta P_0\\\frac1{\delta^2}\Delta^2P_0\\\frac1{\delta^3}\Delta^3P_0\end{bmatrix}=\begin{bmatrix}D\\A\delta^2+B\delta+C\\6A\delta+2B\\6A\end{bmatrix}
:holds-by: scaled_table_is_as_printed
:figure: forward_differences
:::

:::{claim} scaled_table_is_as_printed
:title: The rows of the table to begin with
:zh: 初始差分
:given: any $A,B,C,D$ in space, any $\delta\ne0$
:then: the rows of `power_differences`, divided by $1,\delta,\delta^2,\delta^3$, are the printed ones
:method: The kernel against the printed expressions, everything a variable.
:control: $3A$ in the last row
:::
*/
CLAIM(scaled_table_is_as_printed)
{
    enum { space = 3 };
    num c[4 * space], d[4 * space], delta = positive(T, "d", 0), power = from_int(1);
    G(free_points)(T, 3, space, c);
    G(power_differences)(3, space, c, delta, d);
    for (int k = 0; k <= 3; k++, power = mul(power, delta))
        for (int j = 0; j < space; j++) {
            num D = c[j], C = c[space + j], B = c[2 * space + j], A = c[3 * space + j], six_A = mul(from_int(6), A);
            num rows[4] = {D, add(add(mul(A, mul(delta, delta)), mul(B, delta)), C),
                           add(mul(six_A, delta), mul(from_int(2), B)), fault(T, six_A, mul(from_int(3), A))};
            same(T, div(d[k * space + j], power), rows[k]);
        }
}

/*
:::{statement} hu-1987:1-4-difference-matrix
:title: The matrix of differences
:zh: 差分矩阵
:printed: Written as a matrix, the formulas above give the $4\times3$ matrix of differences (1-4-5).
:holds-by: scaled_table_is_as_printed
:reading: scaled_table_is_as_printed | the differences at $t=0$ as rows, in three coordinates: true; in the plane the matrix is $4\times2$
:reading: step_multiplies_by_a_square_matrix | the step (1-4-4), which stands above, as a matrix: that one is $4\times4$
:figure: forward_differences
:::

:::{claim} step_multiplies_by_a_square_matrix
:title: The step of the scaled table is a matrix with four rows and four columns
:zh: 差分递推的方阵
:given: any four rows $d_0,\dots,d_3$ with three coordinates, any $\delta$
:then: `scaled_difference_step` multiplies them from the left by the matrix with 1 in the diagonal and $\delta$ to the right of it
:method: The kernel against the product of the matrices, everything a variable.
:control: $\delta$ to the left of the diagonal
:::
*/
CLAIM(step_multiplies_by_a_square_matrix)
{
    enum { space = 3 };
    num d[4 * space], next[4 * space], delta = parameter(T, "d");
    G(free_points)(T, 3, space, d);
    for (int k = 0; k < 4; k++)
        for (int j = 0; j < space; j++) {
            num sum = from_int(0);
            for (int i = 0; i < 4; i++) {
                num entry = i == k ? from_int(1) : i == fault(T, k + 1, k - 1) ? delta : from_int(0);
                sum = add(sum, mul(entry, d[i * space + j]));
            }
            next[k * space + j] = sum;
        }
    G(scaled_difference_step)(3, space, delta, d);
    for (int m = 0; m < 4 * space; m++)
        same(T, d[m], next[m]);
}

/*
:::{statement} hu-1987:1-4-fast
:title: With powers of two the points are computed at high speed
:zh: 步长为 2 的幂时高速计算
:printed: With $\delta=1/2^m$, $m$ a positive whole number, the points of the curve are computed at high speed by these formulas.
:holds-by: step_costs_additions_only table_costs_shifts_and_additions stepping_reaches_the_other_end
:hypothesis: short_words_lose_the_end | The words are long enough: $3m$ binary places more than the coefficients have.  Binary64 has
  them for coefficients of 20 bits and $m=8$; words with 16 places have not.
:figure: stepping_and_rounding
:::

### What rounding does to the table

A step has no multiplication, but every point inherits the errors of all points before it.  With $\delta=2^{-m}$ there may be
none: the numbers that occur have $3m$ binary places more than the coefficients.  With $\delta=1/n$ for other $n$, the
differences are rounded before the first step, and an error of $\Delta^3P_0$ is multiplied by $\binom n3$ on the way.  How large it is
depends on how the table is begun: differences of rounded points inherit the roundoff of the points, and the rows of (1-4-5) only
that of their own, small, size.

:::{claim} stepping_reaches_the_other_end
:title: After as many steps as there are pieces the table is at the other end
:zh: 差分法到达终点
:given: any coefficients of degree 3, $\delta=2^{-m}$, $2^m$ steps; $m$ is the degree
:then: the first row is $P(1)=A+B+C+D$
:method: The table and its steps; in binary64 within the running error bound.
:degrees: 1..6 sampled 8
:control: one step less
:::
*/
CLAIM(stepping_reaches_the_other_end)
{
    int pieces = 1 << T->degree;
    num c[4], d[4], end = from_int(0);
    G(free_points)(T, 3, 1, c);
    for (int k = 0; k < 4; k++)
        end = add(end, c[k]);
    G(power_differences)(3, 1, c, from_ratio(1, pieces), d);
    for (int k = 0; k < fault(T, pieces, pieces - 1); k++)
        G(difference_step)(3, 1, d);
    same(T, d[0], end);
}

#if RATIONAL
/*
:::{claim} stepping_is_exact_for_short_coefficients
:title: For coefficients of 20 bits and 256 steps binary64 steps without any error
:zh: 短系数时双精度差分无误差
:kind: decision
:given: 50 random cubics with coefficients of 20 binary places in $[-1,1]$, $\delta=2^{-8}$, 256 steps
:then: every one of the $50\times257$ points by `difference_step` in binary64 is the exact value
:method: The same kernel in binary64 and in rationals; the values are compared as rationals.  They are multiples of $2^{-44}$ below
  $2^8$, and so have at most 52 bits.
:scope: 50 random cubics
:control: $\delta=\frac1{255}$, 255 steps
:::
*/
CLAIM(stepping_is_exact_for_short_coefficients)
{
    int pieces = fault(T, 256, 255);
    for (int cubic = 0; cubic < 50; cubic++) {
        num c[4], d[4];
        double rounded[4], steps[4];
        for (int k = 0; k < 4; k++) {
            c[k] = unknown(T, "c", k);
            rounded[k] = to_double_q(c[k]);
        }
        G(power_differences)(3, 1, c, from_ratio(1, pieces), d);
        power_differences_d(3, 1, rounded, 1.0 / pieces, steps);
        for (int i = 0; i <= pieces; i++) {
            agree(T, equal_q(from_double_q(steps[0]), d[0]));
            G(difference_step)(3, 1, d);
            difference_step_d(3, 1, steps);
        }
    }
}
#endif

/*
:::{claim} errors_of_the_table_grow_with_the_cube
:title: An error of the third difference grows with the cube of the number of steps
:zh: 三阶差分的误差按三次增长
:given: errors $e_0,e_1,e_2,e_3$ in the four rows, $n$ steps
:then: the error of the point is $e_0+ne_1+\binom n2e_2+\binom n3e_3$
:method: The table is linear: the kernel on the errors alone, $n$ steps, against the sum.
:degrees: 1..24
:control: $\binom n3$ left out
:::
*/
CLAIM(errors_of_the_table_grow_with_the_cube)
{
    int n = T->degree;
    num e[4], sum = from_int(0);
    for (int k = 0; k < 4; k++) {
        e[k] = unknown(T, "e", k);
        int counted_in = fault(T, k <= n, k <= n && k != 3);
        sum = add(sum, mul(from_int(counted_in ? binomial(n, k) : 0), e[k]));
    }
    for (int k = 0; k < n; k++)
        G(difference_step)(3, 1, e);
    same(T, e[0], sum);
}

#if RATIONAL
/*
:::{claim} stepping_loses_what_horner_keeps
:title: A table begun with rounded points loses half of the digits, one begun with the coefficients does not
:zh: 差分表的舍入误差取决于起始方式
:kind: decision
:given: the cubic with the coefficients $c$, from $D$ to $A$; $\delta=\frac1n$, $n$ steps in binary64; the table begun with the differences of the first four points, and
  with (1-4-5); two bounds
:data: c = 1 0 0 1; n = 1000; many = 10000000; few = 1000
:instead: n = 1024
:then: in units of the roundoff $2^{-53}$ the last point has an error of more than many the first way, of less than few the second way, and
  none by Horner's rule
:result: error by points = 409928008; error by coefficients = 36; error by Horner's rule = 0
:method: The kernels in binary64, compared exactly as rationals with $P(1)$.
:control: a power of two, where all are exact
:::
*/
/* |value - exact| in units of 2^-53 */
static num units_of_error(double value, num exact)
{
    num gap = sub(from_double_q(value), exact);
    return mul(sign_q(gap) < 0 ? neg(gap) : gap, from_double_q(0x1p53));
}

CLAIM(stepping_loses_what_horner_keeps)
{
    num coefficient[4];
    given_points(T, "c", 4, 1, coefficient);
    int pieces = given_whole(T, "n");
    num many = given(T, "many"), few = given(T, "few"), exact = G(power_sum)(3, 1, coefficient, 0, from_int(1));
    double c[4], delta = 1.0 / pieces, points[4], end, scale = 1;
    for (int k = 0; k < 4; k++)
        c[k] = to_double_q(coefficient[k]);
    double table[4] = {c[0], c[1] + (c[2] + c[3] * delta) * delta, 6 * c[3] * delta + 2 * c[2], 6 * c[3]};
    power_differences_d(3, 1, c, delta, points);
    for (int k = 0; k <= 3; k++, scale *= delta)
        table[k] *= scale;
    for (int k = 0; k < pieces; k++) {
        difference_step_d(3, 1, points);
        difference_step_d(3, 1, table);
    }
    power_point_d(3, 1, c, 1, &end);
    num by_points = units_of_error(points[0], exact), by_table = units_of_error(table[0], exact);
    num by_horner = units_of_error(end, exact);
    found(T, "error by points", by_points);
    found(T, "error by coefficients", by_table);
    found(T, "error by Horner's rule", by_horner);
    agree(T, compare_q(by_points, many) > 0);
    agree(T, compare_q(by_table, few) < 0);
    agree(T, is_zero_q(by_horner));
}

/*
:::{claim} short_words_lose_the_end
:title: Words of 16 binary places lose the cubic term
:zh: 字长不足时丢失三次项
:kind: counterexample
:given: the cubic with the coefficients $c$, from $D$ to $A$; $\delta$; differences kept to so many binary places, the rest cut off; $n$ steps
:data: c = 0 0 0 1/8; δ = 1/256; places = 16; n = 256
:instead: places = 27
:then: the second and the third difference are cut to 0, and so is the first: the last point is $P(0)$ in the place of $P(1)$
:result: table, cut = 0 0 0 0; last point = 0; P(1) = 1/8
:method: The table with each difference cut, then exact steps.
:control: places enough to hold $\Delta^3P_0$
:::
*/
/* a >= 0 with all binary places after the first `places` cut off */
static num cut(num a, int places)
{
    mpz_t whole_part;
    mpz_init(whole_part);
    num unit = from_ratio(1, 1L << places), scaled = div(a, unit);
    mpz_fdiv_q(whole_part, mpq_numref(scaled.at), mpq_denref(scaled.at));
    num kept = mul(from_int(mpz_get_si(whole_part)), unit);
    mpz_clear(whole_part);
    return kept;
}

CLAIM(short_words_lose_the_end)
{
    num c[4], d[4];
    given_points(T, "c", 4, 1, c);
    num delta = given(T, "δ"), end = G(power_sum)(3, 1, c, 0, from_int(1));
    int places = given_whole(T, "places"), steps = given_whole(T, "n");
    G(power_differences)(3, 1, c, delta, d);
    for (int k = 0; k < 4; k++)
        d[k] = cut(d[k], places);
    found_points(T, "table, cut", 4, 1, d);
    for (int k = 0; k < steps; k++)
        G(difference_step)(3, 1, d);
    found(T, "last point", d[0]);
    found(T, "P(1)", end);
    about(T, "the last point, and P(1)");
    same(T, d[0], end);
}
#endif

#include "chapters/judge/claims_off.h"
