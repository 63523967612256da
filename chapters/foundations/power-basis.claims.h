/*
# Points of a cubic, fast (曲线上点的计算)

A cubic in powers of its parameter is computed for many equidistant parameters.  The source gives three ways: the powers
as they stand, the rule of Horner (秦九韶算法), and a table of forward differences (向前差分) that needs additions only.  This
section says what such a curve is good for, and counts the first two; the table has the two sections that follow.
*/
#include "chapters/foundations/definition.h"

#if RATIONAL
#include "chapters/foundations/counted.h"
#include "exact/record/roots.h"
#include "exact/record/sign.h"
#endif

#include "chapters/judge/claims_on.h"

/*
## Descriptions

:::{statement} hu-1987:1-4-slopes
:title: Infinite slopes and several values, the problem of the form that is not parametric
:zh: 非参数形式的无穷斜率与多值问题
:printed: In the fitting of curves the form that is not parametric has the problem of slopes $dy/dx=\infty$, that of several
  values, and so on (等等).
:holds-by: parabola_across_has_no_slope
:meant: the slope $dy/dx$, which is that of a function $y$ of $x$ | The form that is not parametric is $y=f(x)$.
:example: two problems are named that can occur, and one curve has both.
:figure: infinite_slope_and_two_values

A function of $x$ has one value at an $x$, and a graph no vertical tangent where the function has a derivative; this curve has two points over $x=\frac14$, and
a vertical tangent at $t=\frac12$.
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
:result: P'(t) = (0,1); numbers of points over the two abscissas = 2 0
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
    found_points(T, "numbers of points over the two abscissas", 2, 1, points);
    agree(T, is_zero_q(D[2]) && !is_zero_q(D[3]));
    same(T, points[0], from_int(2));
    same(T, points[1], from_int(0));
}

/*
A graph $y=f(x)$ has at most one point over each $x$, and no vertical tangent where $f$ has a derivative: it cannot lie across.  A
parameter removes both restrictions at once, since $x$ becomes one coordinate among others.  What it costs is that the
extent of the curve has to be said in the parameter, and this turns out to be an advantage: two intervals separate what
one abscissa cannot.

:::{statement} hu-1987:1-4-advantage-extent
:title: The extent of a curve is given by an interval of its parameter
:zh: 用参数区间指定曲线的延伸范围
:printed: Where there are several values, the extent of a curve can be given conveniently: the piece of the curve in the plane that is studied
  has $t=a$ for its beginning and $t=b$ for its end, $a\le t\le b$.
:holds-by: linear_change_runs_through_the_interval
:confirmed-by: intervals_of_the_parameter_separate_the_values pieces_in_new_powers
:meant: the interval $a\le t\le b$, which is all that is given | Conveniently is: by two numbers, the parameters of the two ends.
:figure: infinite_slope_and_two_values

With $t_0=a$ and $t_1=b$ the two numbers give every $t$ of the piece once, from its beginning to its end; over which $x$ they lie does not matter.
:::

:::{claim} intervals_of_the_parameter_separate_the_values
:title: Two intervals of the parameter separate the two values
:zh: 参数区间分开多值
:kind: decision
:given: a parabola, whose abscissa has the coefficients $c$, on $[0,s]$ and on $[s,1]$
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
:printed: Points of a surface (曲面) are easily computed: for a space curve $P(t)=[x(t)\;y(t)\;z(t)]$ its $x$, $y$, $z$ are explicit functions of the parameter
  $t$, so that they are easy to compute.
:holds-by: horner_step_keeps_the_sum
:confirmed-by: horner_computes_the_sum_of_powers
:meant: the reason that is given, a curve whose coordinates are explicit functions of $t$, and what follows, curves given by polynomials | Of a curve, easy
  is: by inserting $t$, without an equation to be solved; the functions are polynomials.

The word printed is "surface", the reason is one for curves.
:::

The source says that curves of degree below three do not occur.  They do, as parabolas, and in a section of its own
table of contents.  What is meant can be saved: three is the first degree at which a curve leaves its plane, and the
first at which it changes its side within the plane.  Lines have to be excepted, whose curvature is 0 everywhere.

:::{statement} hu-1987:1-4-lowest-degree
:title: The lowest degree of a polynomial curve in CAGD is three
:zh: 参数多项式曲线最低为三次
:printed: In CAGD the lowest degree of parametric curves given by polynomials is three.
:refuted-by: quadratic_curve_is_in_use
:class: false
:corrected: Three is the lowest degree of the polynomial curves that leave every plane, and of the plane ones that are no lines and have an inflection.
:corrected-by: quadratics_are_plane_and_turn_to_one_side cubics_leave_the_plane_and_inflect
:meant: the words, curves given by polynomials, with nothing added | All polynomial curves that are in use.
:reading: quadratic_curve_is_in_use | three is the lowest degree of all polynomial curves that are in use
:reading: quadratics_are_plane_and_turn_to_one_side | three is the lowest degree of polynomial curves that leave every plane, and of plane ones that are no
  lines and have an inflection
:reading-with: cubics_leave_the_plane_and_inflect
:figure: degrees_two_and_three

The table of contents of the source has a section on uniform quadratic and cubic B-spline surfaces (§ 6-2); the parameter lines of a quadratic one are curves of
pieces of degree 2, so that these are in use.  Lines are excepted in the correction, as their curvature is 0 everywhere.
:::

:::{claim} quadratic_curve_is_in_use
:title: The parabola is a polynomial curve of degree two
:zh: 二次曲线段
:kind: counterexample
:given: the parabola $P(t)=\sum_kc_kt^k$; the degree $n$ that is printed as the lowest, and a parameter $t$
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
:method: The derivatives by the kernel, everything a variable.  $c_1\times c_2=0$ makes $P(t)-c_0$ a multiple of one vector, so the curve
  is on a line; otherwise $c_1\times c_2$ is the normal of a plane that has the curve, and $P'\times P''$ is nowhere 0.
:scope: degree at most 2
:over: x# y# z#: coefficients
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
:title: A line with parameters of degree one and two has curvature zero
:zh: 一、二次直线的曲率恒为零
:kind: counterexample
:given: two curves along one line for $0\le t\le1$, $P$ and $Q$, by their coefficients of $1,t,t^2,t^3$
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
        G(cubic_inflection_polynomial)(minors, f);
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
:given: a cubic in space and one in the plane, with the coefficients $S$ and $P$, and two parameters $t$ between 0 and 1
:data: S = (0,0,0) (1,0,0) (0,1,0) (0,0,1); P = (0,-1) (1,6) (0,-12) (0,8); t = 1/3 2/3
:instead: S = (0,0,0) (1,0,0) (0,1,1) (0,0,0); P = (0,0) (1,0) (0,1) (0,0)
:then: the determinant $(S',S'',S''')$ is not 0; $P'\times P''$ changes its sign between the two, and $P'\ne0$ everywhere, as $x'=1$
:result: (S',S'',S''') = 12; P' × P''(t) = -8 8
:method: The kernels, at the two parameters; the determinant of a cubic does not depend on $t$.  That $x'=1$ is read from the coefficients of $x$.
:control: coefficients of degree 2
:::
*/
CLAIM(cubics_leave_the_plane_and_inflect)
{
    num space[12], plane[8], D[12], t[2], sides[2];
    given_points(T, "S", 4, 3, space);
    given_points(T, "P", 4, 2, plane);
    given_points(T, "t", 2, 1, t);
    G(power_derivatives)(3, 3, space, t[0], 3, D);
    num volume = G(det3)(D + 3, D + 6, D + 9);
    for (int side = 0; side < 2; side++) {
        G(power_derivatives)(3, 2, plane, t[side], 2, D);
        sides[side] = G(cross2)(D + 2, D + 4);
    }
    found(T, "(S',S'',S''')", volume);
    found_points(T, "P' × P''(t)", 2, 1, sides);
    agree(T, !is_zero_q(volume));
    agree(T, sign_q(sides[0]) < 0 && sign_q(sides[1]) > 0);
    agree(T, equal_q(plane[2], from_int(1)) && is_zero_q(plane[4]) && is_zero_q(plane[6])); /* x' = 1 */
}
#endif

/*
## Horner's rule (秦九韶算法)

Horner's rule (秦九韶算法) takes the powers apart: the cubic is written in brackets, and every bracket is multiplied by $t$ once.

:::{statement} hu-1987:1-4-1
:title: A cubic in powers
:zh: 参数三次曲线
:definition: yes
:printed: P(t)=At^3+Bt^2+Ct+D\qquad(0\le t\le1)
:checked-by: horner_computes_the_sum_of_powers
:degree: 3
:::

:::{statement} hu-1987:1-4-2
:title: The cubic by Horner's rule
:zh: 三次曲线的嵌套形式
:printed: P(t)=[(At+B)t+C]t+D
:holds-by: brackets_of_a_cubic_are_the_sum
:confirmed-by: horner_step_keeps_the_sum horner_computes_the_sum_of_powers
:::

:::{claim} brackets_of_a_cubic_are_the_sum
:title: The cubic in brackets is the cubic in powers
:zh: 三次曲线的嵌套形式即幂形式
:given: any $A,B,C,D$ in space, any $t$
:then: $[(At+B)t+C]t+D=At^3+Bt^2+Ct+D$
:method: The printed brackets against the sum of powers, each by repeated multiplication; everything a variable.
:degrees: 3..3
:over: x# y# z#: coefficients
:control: $A$ in the place of $B$ in the inner bracket
:::
*/
CLAIM(brackets_of_a_cubic_are_the_sum)
{
    enum { space = 3 };
    num c[4 * space], t = parameter(T, "t");
    G(free_points)(T, 3, space, c);
    for (int j = 0; j < space; j++) {
        num D = c[j], C = c[space + j], B = c[2 * space + j], A = c[3 * space + j];
        num inner = add(mul(A, t), fault(T, B, A));
        /* [(At + B)t + C]t + D */
        same(T, add(mul(add(mul(inner, t), C), t), D), G(power_sum)(3, space, c, j, t));
    }
}

/*
What the brackets do to a cubic, a step of the rule does to any number of terms.

:::{claim} horner_step_keeps_the_sum
:title: Horner's step takes the sum of the terms so far to the sum with one term more, in every degree
:zh: 秦九韶算法的一步(任意次数)
:given: the sum $S=\sum_{k<j}c_kt^k$ of some terms, one more coefficient $c$ and power $p=t^j$, a further coefficient $d$, any $t$
:then: $(S+cp)\,t+d=(St+d)+c\,(pt)$: if $d+t\sum_{k<j}c_kt^k$ is the sum with the coefficients $d,c_0,\dots,c_{j-1}$, the same is true with $c$ behind
  them
:method: An identity, everything a variable; by induction for any number of terms.  So each step of Horner's rule multiplies by $t$ once, adds one
  coefficient, and after $n$ steps has $\sum_kc_kt^k$.
:degrees: all
:over: S# c# d#: coefficients; p: -
:control: $d$ multiplied by $t$ as well
:::
*/
CLAIM(horner_step_keeps_the_sum)
{
    num S = unknown(T, "S", 0), c = unknown(T, "c", 0), d = unknown(T, "d", 0), p = unknown(T, "p", 0);
    num t = parameter(T, "t"), constant = fault(T, d, mul(d, t));
    same(T, add(mul(add(S, mul(c, p)), t), constant), add(add(mul(S, t), d), mul(c, mul(p, t))));
}

/*
The same step keeps a bound, so that over the unit interval a polynomial is never greater than its coefficients together.

:::{claim} one_factor_and_one_term_keep_a_bound
:title: Over the unit interval a polynomial is bounded by its coefficients, in every degree
:zh: 单位区间上多项式以系数绝对值之和为界
:given: $-M\le q\le M$ and $-C\le c\le C$, any numbers; $0\le t\le1$
:harmless: $-M\le q\le M$ and $-C\le c\le C$ | $M$ is the bound of the polynomial of one degree less, $C$ the absolute value of $c$
:harmless: $0\le t\le1$ | the interval of the statement
:then: $-(M+C)\le tq+c\le M+C$
:method: $M-q$, $M+q$, $C-c$, $C+c$ are each a positive variable or 0, in every combination, and $M+C-(tq+c)=(1-t)M+t(M-q)+(C-c)$, likewise with the other sign; signs of
  coefficients for $t=\frac s{1+s}$, $s>0$, and once more at $t=0$ and $t=1$.  A constant
  $c_n$ has the bound $|c_n|$, and a polynomial is built from it by $p\mapsto tp+c_k$: so by induction $|p(t)|\le\sum_k|c_k|$ for every degree.
:degrees: all
:over: a b d e: -; s: -
:types: field rational
:control: the share $(1-t)M$ left out
:::
*/
CLAIM(one_factor_and_one_term_keep_a_bound)
{
    static const char *const name[] = {"a", "b", "d", "e"};
    num room[4], two = from_int(2), t[3] = {inside(T, "s"), from_int(0), from_int(1)};
    for (int i = 0; i < 4; i++)
        room[i] = positive(T, name[i], 0);
    for (int run = 0; run < 16 * 3; run++) { /* which of the four are 0, and which t */
        int k = run % 3;
        num r[4];
        for (int i = 0; i < 4; i++)
            r[i] = run / 3 >> i & 1 ? from_int(0) : room[i];
        num a = r[0], b = r[1], d = r[2], e = r[3];
        num M = div(add(a, b), two), q = div(sub(b, a), two);                    /* M - q = a, M + q = b */
        num C = div(add(d, e), two), c = div(sub(e, d), two), bound = add(M, C); /* C - c = d, C + c = e */
        num value = add(mul(t[k], q), c), kept = mul(sub(from_int(1), fault(T, t[k], from_int(1))), M);
        for (int sign = -1; sign <= 1; sign += 2) {
            num left = add(bound, mul(from_int(sign), value));
            about(T, sign < 0 ? "below the bound" : "above the bound with the other sign");
            nonnegative(T, left);
            same(T, left, add(kept, add(mul(t[k], sign < 0 ? a : b), sign < 0 ? d : e)));
        }
    }
}

/*
:::{claim} horner_computes_the_sum_of_powers
:title: Horner's rule computes the point of the curve
:zh: 秦九韶算法求曲线上的点
:given: any coefficients in space, any $t$
:then: `power_point` gives $\sum_kc_kt^k$
:method: The kernel against the sum of powers, each by repeated multiplication; everything a variable.
:degrees: 0..7 sampled 16
:over: x# y# z#: coefficients
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
A count depends on what one would have done otherwise.  Six multiplications become three if every power is multiplied
out anew; whoever computes $t^3$ from $t^2$ needs only five, and then five become three.  The number type of these
claims carries no values at all and counts the operations of the very kernel that computes the points.

:::{statement} hu-1987:1-4-horner-count
:title: Horner's rule saves half of the multiplications
:zh: 乘法次数由六次减为三次
:printed: In this way, by (1-4-2), the number of multiplications in computing is reduced from the former 6 to 3.
:holds-by: multiplications_are_six_and_three
:confirmed-by: multiplications_with_kept_powers
:meant: the count of 6, which only powers multiplied out one by one have | The powers of $At^3+Bt^2+Ct+D$ are multiplied out one by one, and one
  coordinate is counted.
:reading: multiplications_are_six_and_three | powers multiplied out one by one, $A\cdot t\cdot t\cdot t+B\cdot t\cdot t+C\cdot
  t+D$, one coordinate: 6 become 3
:reading: kept_powers_need_five | $t^2$ and $t^3=t^2\cdot t$ kept, one coordinate: it is 5 that become 3

With the powers kept $2+3d$ multiplications become $3d$ for $d$ coordinates, counted for $d=1,2,3$: `multiplications_with_kept_powers`.
:::
*/

#if RATIONAL
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
:given: the degrees $k$ up to 12, one coordinate; and the degree $n=3$ of the source
:data: N = 12; n = 3
:then: for degree $k$ the sum of powers takes $\frac{k(k+1)}2$ multiplications and $k$ additions, Horner's rule $k$ and $k$
:result: multiplications of the sum = 6; of Horner's rule = 3
:method: The definition's loop and the kernel are run in a number type that counts, for every degree up to 12; the source speaks of
  the cubic.
:scope: n = 3, one coordinate
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
:given: degree $n=3$, one to three coordinates
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

#include "chapters/judge/claims_off.h"
