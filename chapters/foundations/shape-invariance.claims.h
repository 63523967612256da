/*
# Shapes that do not know their coordinates (形状不变性)

A curve in geometric design is a sum $P(t)=\sum_i\phi_i(t)\,Q_i$: points that a designer moves, functions that a program
knows.  The points are given by coordinates, and coordinates are chosen by somebody.  If another choice of the origin
gives another curve, the formula does not describe a shape (形状), however smooth it is.  The source shows the trap by an
example, and asks for the condition that excludes it.
*/
#include "chapters/foundations/space-rotation.h"

#if RATIONAL
#include "exact/record/sign.h"
#endif

#include "chapters/judge/claims_on.h"

enum { dim = 2, space = 3 };

/*
Two things are said of shapes before the example: that a body has its place for itself, which numbers do not know, and that
a shape is not a function.

:::{statement} hu-1987:1-2-interference
:title: That two bodies do not occupy one place has to be examined
:zh: 空间唯一性与干涉检验
:printed: Two objects cannot occupy one space at the same time; but as shapes are described in a computer by equations and data, by means of data
  structures, this is very difficult to satisfy, and interference has to be examined.
:reading: two_descriptions_may_claim_one_place | interference has to be examined: it is not excluded by the descriptions, since two bodies can each be described
  without a fault, and both contain one point
:reading: that two objects cannot occupy one space: a law of the physical world, which no computation decides
:reading: what is very difficult: an opinion, which no computation decides
:::

:::{statement} hu-1987:1-2-shape-is-no-function
:title: The properties of a shape are not those of a function
:zh: 形状的性质不等同于函数的性质
:printed: The shape meant here is a geometrically invariant notion; its properties are not altogether those of a function.
:holds-by: turned_graph_is_no_graph
:example: one shape shows a property that not all of its positions have.

To be the graph of a function is a property that a turn of the same shape can take away.
:::
*/

#if RATIONAL
/*
:::{claim} two_descriptions_may_claim_one_place
:title: Two balls, each well described, contain one point
:zh: 两球体的描述互不排斥
:kind: decision
:given: the balls about $C_0$ and $C_1$ with the radii $r_0$ and $r_1$, and a point $X$
:data: C = (0,0,0) (1,0,0); r = 1 1; X = (1/2,0,0)
:instead: C = (0,0,0) (3,0,0)
:then: $|X-C_k|^2<r_k^2$ for both: $X$ is inside of both
:result: |X - C|² = 1/4 1/4
:method: Both squares of distances, exactly.
:control: a ball farther away
:::
*/
CLAIM(two_descriptions_may_claim_one_place)
{
    num C[2 * space], r[2], X[space], from_centre[space], square[2];
    given_points(T, "C", 2, space, C);
    given_points(T, "r", 2, 1, r);
    given_points(T, "X", 1, space, X);
    for (int k = 0; k < 2; k++) {
        for (int j = 0; j < space; j++)
            from_centre[j] = sub(X[j], C[k * space + j]);
        square[k] = G(norm_squared)(space, from_centre);
    }
    found_points(T, "|X - C|²", 2, 1, square);
    agree(T, compare_q(square[0], mul(r[0], r[0])) < 0 && compare_q(square[1], mul(r[1], r[1])) < 0);
}
#endif

/*
## The example

:::{statement} hu-1987:1-2-1
:title: The curve of the example
:zh: 例:两点的参数曲线
:definition: yes
:printed: $P(t)=A_0(t)\,P_0+A_1(t)\,P_1$, $0\le t\le1$ (1-2-1); let $A_0(t)=(1-t)^3$, $A_1(t)=t^3$
:checked-by: two_cubes_begin_and_end_at_their_points
:figure: two_cubes_and_their_image
:::

:::{statement} hu-1987:1-2-example-ends
:title: The two factors of the example at the ends of the interval
:zh: 例中调和函数的端值
:printed: For $A_0(t)=(1-t)^3$, $A_1(t)=t^3$: $A_0(0)=1$, $A_0(1)=0$, $A_1(0)=0$, $A_1(1)=1$.
:holds-by: two_cubes_have_the_printed_end_values
:confirmed-by: two_cubes_begin_and_end_at_their_points
:figure: two_cubes_and_their_image
:::
*/

/* The curve of the example: (1-t)^3 P_0 + t^3 P_1. */
static num G(two_cubes)(const num P[], int j, num t)
{
    return add(mul(G(power)(sub(from_int(1), t), 3), P[j]), mul(G(power)(t, 3), P[dim + j]));
}

#if RATIONAL
/* (P_1 - P_0) x (X - P_0), which is 0 exactly where X is on the line through P_0 != P_1 */
static num beside_chord(const num P[], const num X[])
{
    num chord[dim] = {sub(P[2], P[0]), sub(P[3], P[1])}, from_first[dim] = {sub(X[0], P[0]), sub(X[1], P[1])};
    return G(cross2)(chord, from_first);
}
#endif

/*
:::{claim} two_cubes_have_the_printed_end_values
:title: The four values of the two factors at the ends
:zh: 两调和函数的四个端值
:given: $A_0=(1-t)^3$, $A_1=t^3$
:then: $A_0(0)=1$, $A_0(1)=0$, $A_1(0)=0$, $A_1(1)=1$
:method: The four numbers.
:scope: the two stated functions
:control: the two ends exchanged
:::
*/
CLAIM(two_cubes_have_the_printed_end_values)
{
    for (int end = 0; end <= 1; end++) {
        num t = from_int(fault(T, end, 1 - end));
        same(T, G(power)(sub(from_int(1), t), 3), from_int(1 - end));
        same(T, G(power)(t, 3), from_int(end));
    }
}

/*
:::{claim} two_cubes_begin_and_end_at_their_points
:title: The curve of the example begins and ends at its two points
:zh: 两端插值
:given: $A_0=(1-t)^3$, $A_1=t^3$, any two points
:then: $P(0)=P_0$ and $P(1)=P_1$ for $P=A_0P_0+A_1P_1$
:method: The sum at the two integers, the points variables.
:control: the two ends exchanged
:::
*/
CLAIM(two_cubes_begin_and_end_at_their_points)
{
    num P[2 * dim];
    G(free_points)(T, 1, dim, P);
    for (int end = 0; end <= 1; end++)
        for (int j = 0; j < dim; j++)
            same(T, G(two_cubes)(P, j, from_int(fault(T, end, 1 - end))), P[end * dim + j]);
}

/*
:::{statement} hu-1987:1-2-example-line
:title: In the first coordinates the example is the segment between its points
:zh: 原坐标系中例为直线段
:printed: $P(t)=(1-t)^3[0,0]+t^3[10,10]$ is the straight line that joins $P_0=[0,0]$ and $P_1=[10,10]$.
:holds-by: two_cubes_from_the_origin_trace_the_segment
:figure: two_cubes_and_their_image
:::

:::{claim} two_cubes_from_the_origin_trace_the_segment
:title: With one point at the origin the example is the segment
:zh: 一点为原点时得直线段
:given: $P(t)=(1-t)^3P_0+t^3P_1$ with $P_0=(0,0)$, any $P_1$, any $t$; $s\ge0$, $d>0$
:then: $P(t)=P_0+t^3(P_1-P_0)$, $P(0)=P_0$, $P(1)=P_1$; $t^3$ runs from 0 to 1 and never back, since $(s+d)^3-s^3=d\,(3s^2+3sd+d^2)>0$ for $s\ge0$,
  $d>0$: so the curve is the segment, once
:method: Identities in $t$ and $P_1$, of which $(10,10)$ is one value, and in $s$ and $d$; what comes out has positive coefficients only, that of $d^3$ among
  them.
:harmless: $s\ge0$, $d>0$ | two parameters of the interval, the later one is $s+d$
:scope: 0 ≤ t ≤ 1; every P₁, with P₀ = (0,0)
:over: x1 y1: -; s d: -
:control: the factor $t^2$ on the right
:::
*/
CLAIM(two_cubes_from_the_origin_trace_the_segment)
{
    num t = parameter(T, "t"), P[4] = {from_int(0), from_int(0), unknown(T, "x", 1), unknown(T, "y", 1)};
    for (int j = 0; j < dim; j++)
        same(T, G(two_cubes)(P, j, t), mul(G(power)(t, fault(T, 3, 2)), P[dim + j]));
    about(T, "the ends");
    for (int end = 0; end <= 1; end++)
        for (int j = 0; j < dim; j++)
            same(T, G(two_cubes)(P, j, from_int(end)), P[end * dim + j]);
    num s = positive(T, "s", 0), d = positive(T, "d", 0), three = from_int(3);
    num rise = sub(G(power)(add(s, d), 3), G(power)(s, 3));
    about(T, "the growth of the cube of the parameter");
    /* (s + d)³ - s³ = d (3s² + 3sd + d²) */
    same(T, rise, mul(d, add(mul(three, mul(s, add(s, d))), mul(d, d))));
    G(must_be_positive)(T, rise);
}

/*
The values at the ends say where a curve begins and ends, and nothing about what lies between.  The reason that the
source gives is therefore none, and the claims that follow look for the true one.  The curve begins in $P_0$ and ends in
$P_1$, but its two factors do not add up to 1: some of the weight of the mean is missing, and what is missing is put
into the origin.  So $P(t)$ is a point of the triangle of $P_0$, $P_1$ and the origin, and it can be on the chord only
where this triangle shrinks to a line.  In the printed example the origin is $P_0$ itself.

:::{statement} hu-1987:1-2-example-reason
:title: That the factors are 1 and 0 at the ends is the reason for the straight line
:zh: 由端值推出直线
:printed: For $A_0(t)=(1-t)^3$, $A_1(t)=t^3$, because $A_0(0)=1$, $A_0(1)=0$, $A_1(0)=0$, $A_1(1)=1$, the curve $P(t)=A_0(t)P_0+A_1(t)P_1$ is the straight line that joins the two points $P_0=[0,0]$ and $P_1=[10,10]$.
:refuted-by: ends_alone_leave_the_segment
:reading: ends_alone_make_no_straight_line | for any two points the four values are the reason: they say nothing of the printed ones
:meant: the two points that the sentence names, and the word joins (连结) | The printed points, and the segment between them.
:class: invalid-proof
:corrected: The curve is the segment $P_0P_1$ exactly when the origin is on this segment.  $P(t)$ is on the line through $P_0\ne P_1$
  for a $t$ of $(0,1)$ exactly when the origin is on this line: $(P_1-P_0)\times(P(t)-P_0)=3t(1-t)\,P_0\times P_1$.
:corrected-by: two_cubes_miss_the_chord_by_a_product two_cubes_fill_segments_with_the_origin
  two_cubes_from_the_origin_trace_the_segment
:figure: two_cubes_and_their_image

The conclusion is true for the printed points with the printed functions.  It does not follow from the four values: not for these functions with
other points, and not for these points with other functions.  With these points every $P(t)$ is on the line through both because $P_0$ is
the origin, so that $P(t)=A_1(t)P_1$; the four values are not the reason.
:::
*/

#if RATIONAL
/*
:::{claim} ends_alone_make_no_straight_line
:title: The same factors with other points leave the chord
:zh: 端值相同而不成直线
:kind: counterexample
:types: rational
:given: the curve $P(t)=(1-t)^3P_0+t^3P_1$ of two points $P_0$, $P_1$ on the axes, at $t$
:data: P = (1,0) (0,1); t = 1/2
:then: $P(t)$ is not on the line through $P_0$ and $P_1$
:result: P(t) = (1/8,1/8)
:method: The vector product $(P_1-P_0)\times(P(t)-P_0)$ is 0 on this line, and nowhere else.
:control: the factors $1-t$ and $t$
:::
*/
CLAIM(ends_alone_make_no_straight_line)
{
    num P[4], at[2], t;
    given_points(T, "P", 2, 2, P);
    t = given(T, "t");
    for (int j = 0; j < dim; j++)
        at[j] = fault(T, add(mul(sub(from_int(1), t), P[j]), mul(t, P[dim + j])), G(two_cubes)(P, j, t));
    found_points(T, "P(t)", 1, 2, at);
    about(T, "the vector product of the chord and of P(t) - P_0");
    vanishes(T, beside_chord(P, at));
}

/*
:::{claim} ends_alone_leave_the_segment
:title: Other factors with the same four values leave the segment between the same points
:zh: 端值相同的另两函数越出线段
:kind: counterexample
:types: rational
:given: the points $P_0$, $P_1$ of the source, $A_0(t)=1-A_1(t)$, $A_1(t)=t+k\,t(1-t)$, so that $A_0(0)=1$, $A_0(1)=0$, $A_1(0)=0$, $A_1(1)=1$; and $t$
  of $(0,1)$
:data: P = (0,0) (10,10); k = 2; t = 3/4
:instead: k = 1
:then: $P(t)=A_0(t)P_0+A_1(t)P_1$ is beyond $P_1$
:result: P(t) = (45/4,45/4)
:method: $(P_1-P(t))\cdot(P_1-P_0)$ is negative for what is beyond $P_1$.
:control: $k=1$, with which $A_1=t\,(2-t)$ stays below 1
:::
*/
CLAIM(ends_alone_leave_the_segment)
{
    num P[4], at[2], chord[2], left[2], k, t, one = from_int(1);
    given_points(T, "P", 2, 2, P);
    k = given(T, "k"), t = given(T, "t");
    num last = mul(t, add(one, mul(k, sub(one, t)))), first = sub(one, last);
    for (int j = 0; j < dim; j++) {
        at[j] = add(mul(first, P[j]), mul(last, P[dim + j]));
        chord[j] = sub(P[dim + j], P[j]);
        left[j] = sub(P[dim + j], at[j]);
    }
    found_points(T, "P(t)", 1, 2, at);
    about(T, "the product of P_1 - P(t) and P_1 - P_0, which is not negative on the segment");
    nonnegative(T, G(dot)(2, left, chord));
}
#endif

/*
:::{claim} two_cubes_miss_the_chord_by_a_product
:title: How far the example is from its chord
:zh: 例中曲线到弦的偏差
:given: any points $P_0$, $P_1$ of the plane, any $t$
:then: $(P_1-P_0)\times(P(t)-P_0)=3t(1-t)\,P_0\times P_1$
:method: An identity in $t$ and the four coordinates; $3t(1-t)\ne0$ inside the interval, and $P_0\times P_1=0$ says that
  the two points and the origin are on one line.
:scope: every P₀ and P₁
:over: x# y#: -; t
:control: the factor 2 in the place of 3
:::
*/
CLAIM(two_cubes_miss_the_chord_by_a_product)
{
    num P[2 * dim], chord[dim], from_first[dim], t = parameter(T, "t");
    G(free_points)(T, 1, dim, P);
    for (int j = 0; j < dim; j++) {
        chord[j] = sub(P[dim + j], P[j]);
        from_first[j] = sub(G(two_cubes)(P, j, t), P[j]);
    }
    num factor = mul(from_int(fault(T, 3, 2)), mul(t, sub(from_int(1), t)));
    /* (P_1 - P_0) × (P(t) - P_0) = 3t(1 - t) P_0 × P_1 */
    same(T, G(cross2)(chord, from_first), mul(factor, G(cross2)(P, P + dim)));
}

/*
:::{claim} two_cubes_fill_segments_with_the_origin
:title: On a line through the origin the example is the segment if the origin is between the points, and leaves it otherwise
:zh: 共线时曲线为线段的充要条件
:given: a line through the origin with coordinate $x$; $P_0$ at $p_0$, $P_1$ at $p_1$; $f(t)=p_0(1-t)^3+p_1t^3$; any $t$ of $(0,1)$ and
  $p,q>0$; and the places $a_0=1$, $a_1=2$ on one side of the origin, with the parameter $s=1/2$
:data: a = 1 2; s = 1/2
:then: for $p_0=-p$, $p_1=q$, $f'(t)$ is three times $p(1-t)^2+qt^2>0$, so $f$ runs from $p_0$ to $p_1$ once and never back; for
  $p_0=p$, $p_1=p+q$, $f'(0)$ is three times $-p<0$, so the curve begins by leaving the segment; for $p_0=a_0$, $p_1=a_1$ the value $f(s)$
  is outside $[a_0,a_1]$
:result: f(s) = 3/8
:method: The derivative by the definition.  $p_0=p_1=p$ is $q=0$ in the second; a point in the origin is
  `two_cubes_from_the_origin_trace_the_segment`; the other cases are these with another direction of the line, or with $t$ and $1-t$ exchanged.
:scope: 0 < t < 1; all points on a line through the origin
:over: p q: -; t: -
:control: $p_0=p$ in the first case
:::
*/
/* The coefficients of f(t) = p_0 (1-t)^3 + p_1 t^3. */
static void G(two_cubes_on_a_line)(num p0, num p1, num c[])
{
    num three = mul(from_int(3), p0);
    c[0] = p0;
    c[1] = neg(three);
    c[2] = three;
    c[3] = sub(p1, p0);
}

CLAIM(two_cubes_fill_segments_with_the_origin)
{
    num p = positive(T, "p", 0), q = positive(T, "q", 0), t = inside(T, "t"), rest = sub(from_int(1), t), a[2], c[4];
    given_points(T, "a", 2, 1, a);
    num s = given(T, "s");
    G(two_cubes_on_a_line)(fault(T, neg(p), p), q, c);
    about(T, "f'");
    /* f'(t) = 3 (p (1-t)^2 + q t^2) */
    num sum = mul(from_int(3), add(mul(p, mul(rest, rest)), mul(q, mul(t, t))));
    same(T, G(power_sum_derivative)(3, 1, c, 0, 1, t), sum);
    G(must_be_positive)(T, sum);
    G(two_cubes_on_a_line)(p, add(p, q), c);
    same(T, G(power_sum_derivative)(3, 1, c, 0, 1, from_int(0)), mul(from_int(-3), p)); /* f'(0) = -3p */
    G(two_cubes_on_a_line)(a[0], a[1], c);
    num value = G(power_sum)(3, 1, c, 0, s);
    found(T, "f(s)", value);
    about(T, "that f(s) is below a_0 < a_1");
    G(must_be_positive)(T, sub(a[0], value));
    G(must_be_positive)(T, sub(a[1], a[0]));
}

/*
Now somebody else chooses the coordinates.  The points stay where they are on the paper, the origin moves, and with it
the point in which the missing weight is put.  One should expect a curve that hangs from the chord towards the new
origin, and that is what the formula draws.

:::{statement} hu-1987:1-2-example-new-coordinates
:title: The coordinates of the two points in the new system
:zh: 新坐标系中的两点
:printed: $P_0=[0,0]$ and $P_1=[10,10]$ are $P_0^*=[-3,-2]$ and $P_1^*=[7,8]$ in a new coordinate system $O^*x^*y^*$.
:holds-by: new_coordinates_are_a_translation
:figure: two_cubes_and_their_image
:::
*/

#if RATIONAL
/*
:::{claim} new_coordinates_are_a_translation
:title: The new coordinates of the example are those of one translation
:zh: 新坐标由一次平移得到
:kind: decision
:given: the printed coordinates $P$ and $P^*$ of the two points
:data: P = (0,0) (10,10); P* = (-3,-2) (7,8)
:instead: P* = (-3,-2) (7,6)
:then: $P_i-P_i^*$ is the same for both points: a translation, which moves the origin to $O^*$ and keeps the directions of the axes, makes the new
  coordinates of the old ones
:result: O* = (3,2)
:method: Both differences, in integers.
:control: another ordinate of $P_1^*$
:::
*/
CLAIM(new_coordinates_are_a_translation)
{
    num P[4], image[4], origin[2];
    given_points(T, "P", 2, 2, P);
    given_points(T, "P*", 2, 2, image);
    for (int j = 0; j < dim; j++)
        origin[j] = sub(P[j], image[j]);
    found_points(T, "O*", 1, 2, origin);
    for (int m = 0; m < 4; m++)
        same(T, image[m], sub(P[m], origin[m % 2]));
}

/*
:::{statement} hu-1987:1-2-example-new-ends
:title: In the new coordinates the curve still begins and ends at the points
:zh: 新坐标系中曲线仍过两端点
:printed: With $A_0(t)=(1-t)^3$, $A_1(t)=t^3$ the curve $P^*(t)=A_0(t)P_0^*+A_1(t)P_1^*$ passes through $P_0^*$ for $t=0$ and through $P_1^*$ for $t=1$.
:holds-by: two_cubes_begin_and_end_at_their_points
:figure: two_cubes_and_their_image
:::

:::{statement} hu-1987:1-2-example-curve
:title: In the new coordinates the example is a curve
:zh: 新坐标系中例为曲线
:printed: For $0<t<1$, $P^*(t)=(1-t)^3[-3,-2]+t^3[7,8]$ represents a curve.
:meant: the word but (但是), which sets it against the straight line of the first coordinates | A curve that is not straight.
:holds-by: image_of_the_example_turns_everywhere
:confirmed-by: image_of_the_example_lies_on_a_cubic
:figure: two_cubes_and_their_image
:striking: 40

No part of it is straight: $P'\times P''$ is 0 at $P_0^*$ and $P_1^*$ only.
:::

:::{claim} image_of_the_example_turns_everywhere
:title: The curve of the example in the new coordinates turns to one side all the way
:zh: 新坐标系中曲线处处弯曲
:kind: decision
:given: the points $P_0^*=(-3,-2)$ and $P_1^*=(7,8)$ of the source, and their curve $P(t)=(1-t)^3P_0^*+t^3P_1^*$
:data: P* = (-3,-2) (7,8)
:instead: P* = (0,0) (7,8)
:then: $P'\times P''$ has no zero in $(0,1)$, and zeros at 0 and 1
:result: P' × P'' = "-180*t^2 + 180*t"
:method: $P'\times P''$ as a polynomial of $t$, by the kernels for cubics; its sign on the open interval by root counts, its values
  at the ends.
:scope: 0 ≤ t ≤ 1
:control: $P_0^*$ in the origin
:::
*/
/* The coefficients of (1-t)^3 P_0 + t^3 P_1. */
static void two_cubes_in_powers(const num P[], num c[])
{
    const int binomials[4] = {1, -3, 3, -1};
    for (int k = 0; k <= 3; k++)
        for (int j = 0; j < dim; j++) {
            c[k * dim + j] = mul(from_int(binomials[k]), P[j]);
            if (k == 3)
                c[k * dim + j] = add(c[k * dim + j], P[dim + j]);
        }
}

CLAIM(image_of_the_example_turns_everywhere)
{
    num P[4], c[8], minors[3], f[3];
    given_points(T, "P*", 2, 2, P);
    two_cubes_in_powers(P, c);
    G(cubic_minors)(c, minors);
    G(cubic_inflection_polynomial)(minors, f);
    poly turning = poly_from_q(3, f);
    found_text(T, "P' × P''", poly_to_string(turning, "t"));
    enum cagd_sign_pattern open = sign_on(turning, from_int(0), from_int(1), OPEN);
    agree(T, open == SIGN_POSITIVE || open == SIGN_NEGATIVE);
    agree(T, is_zero_q(poly_value(turning, from_int(0))) && is_zero_q(poly_value(turning, from_int(1))));
}
#endif

/*
:::{claim} image_of_the_example_lies_on_a_cubic
:title: The curve of two cubes is an arc of one cubic curve
:zh: 两立方调和曲线的隐式方程
:given: $p=(1-t)^3$, $q=t^3$, any $t$; and any point with $p+q=c$, any $c$
:then: $(1-p-q)^3=27pq$; and for $q=c-p$ it is $(1-p-q)^3-27pq=27p^2-27cp+(1-c)^3$
:method: Identities in $t$, and in $p$ and $c$.  When $P_0^*$ and $P_1^*$ are independent, $p$ and $q$ are affine coordinates of the plane,
  with the axes along $P_0^*$ and $P_1^*$, so that this is an equation of degree 3 of the curve.  A factor of degree 1 would be $p+q-c$, since
  $-(p+q)^3$ are the terms of degree 3, and on this line the cubic is not 0, the coefficient of $p^2$ being 27: so it is irreducible.
  On the chord, where $c=1$, it is 0 for $pq=0$ only, at the two ends.
:over: t; p c: -
:control: 26 in the place of 27
:::
*/
CLAIM(image_of_the_example_lies_on_a_cubic)
{
    num t = parameter(T, "t"), p = G(power)(sub(from_int(1), t), 3), q = G(power)(t, 3);
    num side = sub(sub(from_int(1), p), q);
    /* (1 - p - q)³ = 27pq */
    same(T, G(power)(side, 3), mul(from_int(fault(T, 27, 26)), mul(p, q)));
    num c = unknown(T, "c", 0), x = unknown(T, "p", 0), y = sub(c, x), one = from_int(1), many = from_int(27);
    num cubic = sub(G(power)(sub(sub(one, x), y), 3), mul(many, mul(x, y)));
    about(T, "the cubic on a line of the one direction that a factor could have");
    same(T, cubic, add(mul(many, mul(x, sub(x, c))), G(power)(sub(one, c), 3)));
}

/*
:::{statement} hu-1987:1-2-example-verdict
:title: The formula of the example depends on the coordinates
:zh: 式 1-2-1 不满足坐标独立性
:printed: (1-2-1) does not satisfy the condition of coordinate independence, that is, of the invariance of shape, so that it is not proper to
  describe shapes by it.
:meant: the words behind (1-2-1), let $A_0(t)=(1-t)^3$, $A_1(t)=t^3$ | (1-2-1), $P(t)=A_0(t)P_0+A_1(t)P_1$, with these two functions, $A_0(t)=(1-t)^3$ and $A_1(t)=t^3$.
:holds-by: two_cubes_from_the_origin_trace_the_segment image_of_the_example_turns_everywhere new_coordinates_are_a_translation
:confirmed-by: image_of_the_example_is_not_the_translated_curve translation_adds_the_sum_of_the_functions matrices_pass_to_the_points
:figure: two_cubes_and_their_image

For the source's own points and translation the curve is a segment in the one system and, in the other, an arc of which no part is straight: the
shape is another.  That it is not proper follows because the section demands that the invariance of shape be guaranteed.
:::

:::{claim} image_of_the_example_is_not_the_translated_curve
:title: The curve of the translated points misses the translated curve inside the interval
:zh: 平移顶点的曲线异于曲线的平移
:given: any points, any translation $m$, any $t$
:then: $P^*(t)-(P(t)+m)=-3t(1-t)\,m$, which is not 0 for $0<t<1$, $m\ne0$
:method: An identity in $t$, the points and $m$.  The source has $m=(-3,-2)$.
:over: m#: translations
:control: the last point is not translated
:::
*/
CLAIM(image_of_the_example_is_not_the_translated_curve)
{
    num P[2 * dim], image[2 * dim], m[dim], t = parameter(T, "t");
    G(free_points)(T, 1, dim, P);
    for (int j = 0; j < dim; j++) {
        m[j] = unknown(T, "m", j);
        image[j] = add(P[j], m[j]);
        image[dim + j] = fault(T, add(P[dim + j], m[j]), P[dim + j]);
    }
    num factor = mul(from_int(-3), mul(t, sub(from_int(1), t)));
    for (int j = 0; j < dim; j++)
        /* P*(t) - (P(t) + m) = -3t(1 - t) m */
        same(T, sub(G(two_cubes)(image, j, t), add(G(two_cubes)(P, j, t), m[j])), mul(factor, m[j]));
}

#if RATIONAL
/*
:::{claim} image_keeps_no_chord
:title: In the new coordinates the middle of the example is not on the chord
:zh: 新坐标系中曲线离弦
:kind: counterexample
:given: the source's two points, with the coordinates $P$ and, in the new system, $P^*$; the curves $P(t)=(1-t)^3P_0+t^3P_1$ and $P^*(t)=(1-t)^3P_0^*+t^3P_1^*$, and $t$
:data: P = (0,0) (10,10); P* = (-3,-2) (7,8); t = 1/2
:instead: P* = (0,0) (10,10)
:then: $P(t)$ is on the line through $P_0$ and $P_1$, and $P^*(t)$ is not on the line through $P_0^*$ and $P_1^*$: the curve depends on the coordinates
:result: P(t) = (5/4,5/4); P*(t) = (1/2,3/4)
:method: The vector products $(P_1-P_0)\times(P(t)-P_0)$ and $(P_1^*-P_0^*)\times(P^*(t)-P_0^*)$ are 0 on these lines, and nowhere else.
:control: the old coordinates
:::
*/
CLAIM(image_keeps_no_chord)
{
    num P[4], image[4], first[2], at[2];
    given_points(T, "P", 2, 2, P);
    given_points(T, "P*", 2, 2, image);
    num t = given(T, "t");
    for (int j = 0; j < dim; j++) {
        first[j] = G(two_cubes)(P, j, t);
        at[j] = G(two_cubes)(image, j, t);
    }
    found_points(T, "P(t)", 1, 2, first);
    found_points(T, "P*(t)", 1, 2, at);
    about(T, "the vector product of the first chord and of P(t) - P_0");
    vanishes(T, beside_chord(P, first));
    about(T, "the vector product of the chord and of P*(t) - P*_0");
    vanishes(T, beside_chord(image, at));
}
#endif

/*
## The condition

:::{statement} hu-1987:1-2-2
:title: A curve as a sum of points with functions as factors
:zh: 曲线的一般表达式
:definition: yes
:printed: $P(t)=[x(t)\;y(t)\;z(t)]=[\phi_0(t)\;\phi_1(t)\;\cdots\;\phi_n(t)]\,[Q_0\;Q_1\;\cdots\;Q_n]^T$, where $\phi_0(t),\dots,\phi_n(t)$ are polynomials of the
  parameter $t$, and $Q_0,\dots,Q_n$ the position vectors that define the curve
:checked-by: matrices_pass_to_the_points
:figure: rotations_of_the_example

:::

:::{claim} matrices_pass_to_the_points
:title: A matrix applied to the points is applied to the curve
:zh: 矩阵变换作用于顶点即作用于曲线
:given: a sum $S=\sum\phi_iQ_i$ of some terms, which may be any point of space, with one more value of $\phi$ and one more point $Q$; a
  $3\times3$ matrix $T$
:then: $ST+\phi\,(QT)=(S+\phi Q)\,T$; so, term by term, $\sum\phi_i\,(Q_iT)=\bigl(\sum\phi_iQ_i\bigr)T$, whether $T$ is a
  rotation or not
:method: Both sides with the sum, the function, the point and the 9 entries variables; by induction for any number of terms.
:degrees: all
:over: s# x# y# z#: points; f#: functions; m#: matrices
:control: the new point is not mapped
:::
*/
CLAIM(matrices_pass_to_the_points)
{
    num S[space], M[space * space], phi = unknown(T, "f", 0);
    num Q[space] = {unknown(T, "x", 0), unknown(T, "y", 0), unknown(T, "z", 0)};
    for (int m = 0; m < space * space; m++)
        M[m] = unknown(T, "m", m);
    for (int k = 0; k < space; k++)
        S[k] = unknown(T, "s", k);
    for (int j = 0; j < space; j++) {
        num of_images = from_int(0), image = from_int(0);
        for (int k = 0; k < space; k++) {
            num entry = M[k * space + j], of_point = fault(T, entry, from_int(j == k));
            of_images = add(of_images, add(mul(S[k], entry), mul(phi, mul(Q[k], of_point))));
            image = add(image, mul(add(S[k], mul(phi, Q[k])), entry));
        }
        same(T, of_images, image);
    }
}

/*
From here on the functions may be any functions, since only their sum will matter.  A change of coordinates is a matrix
and a translation, and the two behave differently.  A matrix distributes over the sum, so it passes from the curve to
the points whatever the functions are: that is the associative law of the product of three matrices.

:::{statement} hu-1987:1-2-rotation
:title: A rotation of the points is the rotation of the curve
:zh: 旋转变换下的形状不变性
:printed: For the matrix $T$ of a rotation and $Q_i^*=Q_iT$,
  $P^*(t)=[\phi_0\cdots\phi_n][Q_0^*\cdots Q_n^*]^T=[\phi_0\cdots\phi_n][Q_0T\cdots Q_nT]^T=[\phi_0\cdots\phi_n][Q_0\cdots Q_n]^TT=P(t)\,T$: after a rotation
  the shape is kept.
:holds-by: matrices_pass_to_the_points rotations_keep_products
:needs: rotation_about_a_point_moves_the_example | the words before the formulas, the matrix $T$ of the rotation (旋转变换矩阵) | the rotation is about the origin:
  such a one is a matrix.  About another point it contains a translation.
:figure: rotations_of_the_example

The first step has $P^*(t)=P(t)\,T$, the second that the shape is kept: no length, no angle and no volume between points changes.
:::

:::{claim} rotations_keep_products
:title: A rotation of space keeps lengths, angles and volumes
:zh: 空间旋转保持长度、夹角与体积
:given: the rotation $T$ of the quaternion $h$ with the four numbers $h_0,h_1,h_2,h_3$, not all 0, $v\mapsto hvh^{-1}$; any two vectors $v$, $w$ of space, from point to point
:then: $(vT)\cdot(wT)=v\cdot w$ and $(vT)\times(wT)=(v\times w)\,T$, hence $\bigl((uT)\times(vT)\bigr)\cdot(wT)=(u\times v)\cdot w$ too; and with $a=(h_1,h_2,h_3)$ there is $aT=a$, and for $p=a\times v$,
  any vector perpendicular to $a$, $p\cdot(pT)=\frac{h_0^2-|a|^2}{|h|^2}|p|^2$ and $p\times(pT)=\frac{2h_0}{|h|^2}|p|^2\,a$
:method: Identities in the four numbers and the six coordinates; the third follows by the first for $u\times v$ and $w$.  The last three say that $T$ is, for
  $a\ne0$, the rotation about the axis $a$ by the angle with the cosine $\frac{h_0^2-|a|^2}{|h|^2}$ and the sine $\frac{2h_0|a|}{|h|^2}$; any axis and any angle can be chosen
  so, and every rotation about the origin is of this kind.
:over: h#: rotations; v# w#: points
:control: $T$ without the divisor $|h|^2$
:::
*/
CLAIM(rotations_keep_products)
{
    num h[4], M[space * space], v[space], w[space], turned_v[space], turned_w[space], across[space],
        turned_across[space];
    for (int k = 0; k < 4; k++)
        h[k] = unknown(T, "h", k);
    for (int k = 0; k < space; k++) {
        v[k] = unknown(T, "v", k);
        w[k] = unknown(T, "w", k);
    }
    G(rotation_of_space)(h, fault(T, G(norm_squared)(4, h), from_int(1)), M);
    G(row_of_space_times)(v, M, turned_v);
    G(row_of_space_times)(w, M, turned_w);
    about(T, "the product of two vectors");
    same(T, G(dot)(space, turned_v, turned_w), G(dot)(space, v, w)); /* (v T)·(w T) = v·w */
    G(cross3)(v, w, across);
    G(row_of_space_times)(across, M, turned_across);
    G(cross3)(turned_v, turned_w, across);
    about(T, "the vector product");
    for (int j = 0; j < space; j++)
        same(T, across[j], turned_across[j]); /* (v T) × (w T) = (v × w) T */
    const num *axis = h + 1;
    num p[space], turned[space], square = G(norm_squared)(4, h), axis_square = G(norm_squared)(space, axis);
    about(T, "the axis, and the angle about it");
    G(row_of_space_times)(axis, M, turned);
    for (int j = 0; j < space; j++)
        same(T, turned[j], axis[j]);
    G(cross3)(axis, v, p);
    G(row_of_space_times)(p, M, turned);
    G(cross3)(p, turned, across);
    num length = div(G(norm_squared)(space, p), square);
    same(T, G(dot)(space, p, turned), mul(sub(mul(h[0], h[0]), axis_square), length));
    for (int j = 0; j < space; j++)
        same(T, across[j], mul(mul(mul(from_int(2), h[0]), length), axis[j]));
}

#if RATIONAL
/*
:::{claim} rotation_about_a_point_moves_the_example
:title: Turning the points of the example about another point makes a curve of its segment
:zh: 绕非原点旋转时形状改变
:kind: counterexample
:given: the points $P$ of the source and their curve $P(t)=(1-t)^3P_0+t^3P_1$, a segment; the rotation by a right angle about $C$, and $t$; $P^*(t)$ is the
  curve of the turned points
:data: P = (0,0) (10,10); C = (0,1); t = 1/2
:instead: C = (0,0)
:then: $P^*(t)$ is not on the line through the turned points, so the shape is not kept; and it is not the turned point $P(t)$
:result: turned P = (1,1) (-9,11); turned P(t) = (-1/4,9/4); P*(t) = (-1,3/2)
:method: The vector product of the turned chord and of $P^*(t)-P_0^*$, which is 0 on this line and nowhere else; and both points, exactly.
:control: the rotation about the origin
:::
*/
/* out = P turned to the left by a right angle about C:  C + (-(y - C_y), x - C_x) */
static void quarter_turn(const num C[], const num P[], num out[])
{
    num x = P[0], y = P[1];
    out[0] = add(C[0], sub(C[1], y));
    out[1] = add(C[1], sub(x, C[0]));
}

CLAIM(rotation_about_a_point_moves_the_example)
{
    num P[4], C[2], turned[4], at[2], image[2], there[2];
    given_points(T, "P", 2, 2, P);
    given_points(T, "C", 1, 2, C);
    num t = given(T, "t");
    quarter_turn(C, P, turned);
    quarter_turn(C, P + 2, turned + 2);
    for (int j = 0; j < dim; j++) {
        at[j] = G(two_cubes)(P, j, t);
        there[j] = G(two_cubes)(turned, j, t);
    }
    quarter_turn(C, at, image);
    found_points(T, "turned P", 2, 2, turned);
    found_points(T, "turned P(t)", 1, 2, image);
    found_points(T, "P*(t)", 1, 2, there);
    about(T, "the vector product of the turned chord and of P*(t) - P*_0");
    vanishes(T, beside_chord(turned, there));
    about(T, "the coordinates of the curve of the turned points, and of the turned point of the curve");
    for (int j = 0; j < dim; j++)
        same(T, there[j], image[j]);
}
#endif

/*
A translation does not distribute.  Every point receives the vector $m$, and the curve receives it as often as the
functions add up to.  The whole condition can be read off this one line; what has to be watched is the word "shape".
Whoever asks that the curve goes where its points go needs the sum 1 (柯西关系).  Whoever asks only that it stays congruent
to itself needs a constant sum: for points that are all in the origin the curve is a point, and that of the moved points is $(\sum\phi_i)\,m$.  The
print does not say which of the two is meant.

:::{statement} hu-1987:1-2-translation
:title: What a translation of the points does to the curve
:zh: 平移变换的推导
:printed: For a translation $m$ and $Q_i^*=Q_i+m$, $P^*(t)=[\phi_0\cdots\phi_n][Q_0^*\cdots Q_n^*]^T=[\phi_0\cdots\phi_n][Q_0+m\;\cdots\;Q_n+m]^T=P(t)+[\phi_0(t)+\phi_1(t)+\cdots+\phi_n(t)]\,m$
:holds-by: translation_adds_the_sum_of_the_functions
:figure: sums_of_functions
:::

:::{claim} translation_adds_the_sum_of_the_functions
:title: The curve of the translated points, and its distance from the translated curve
:zh: 平移顶点后曲线的变化
:given: sums $S=\sum\phi_iQ_i$ and $\sigma=\sum\phi_i$ of some terms, any numbers, with one more value of $\phi$ and one
  more $Q$, a coordinate of a point; a translation $m$
:then: $(S+\sigma m)+\phi\,(Q+m)=(S+\phi Q)+(\sigma+\phi)\,m$; so, term by term, $P^*=P+(\sum\phi_i)\,m$, and
  $P^*-(P+m)=(\sum\phi_i-1)\,m$, which vanishes for one $m\ne0$ exactly when the sum is 1, and then for every $m$
:method: Both sides with everything a variable, coordinate by coordinate; by induction for any number of terms.
:degrees: all
:over: s# x#: points; f# r#: functions; m#: translations
:control: the new function left out of the sum
:::
*/
CLAIM(translation_adds_the_sum_of_the_functions)
{
    num S = unknown(T, "s", 0), sigma = unknown(T, "r", 0), phi = unknown(T, "f", 0), Q = unknown(T, "x", 0);
    num m = unknown(T, "m", 0), after = add(add(S, mul(sigma, m)), mul(phi, add(Q, m)));
    num before = add(S, mul(phi, Q)), sum = fault(T, add(sigma, phi), sigma);
    /* P* = P + (Σφ_i) m,   P* - (P + m) = (Σφ_i - 1) m */
    same(T, after, add(before, mul(sum, m)));
    same(T, sub(after, add(before, m)), mul(sub(sum, from_int(1)), m));
}

/*
:::{claim} doubled_functions_keep_the_shape
:title: Functions with the sum 2 keep the shape and lose the place
:zh: 函数和为常数 2 时形状不变
:given: $\phi_i=2B_i^n(t)$, any points of the plane, any translation $m$
:then: $\sum\phi_i=2$, and the curve of the translated points is the curve translated by $2m$: congruent to it, not
  where the points went
:method: Both curves by de Casteljau's algorithm on doubled points, at a variable $t$ with variable points and $m$.
:degrees: 1..6 sampled 12
:over: m#: translations
:control: the curve translated by $m$
:::
*/
CLAIM(doubled_functions_keep_the_shape)
{
    int n = T->degree;
    num Q[(MAX_DEGREE + 1) * dim], doubled[(MAX_DEGREE + 1) * dim], moved[(MAX_DEGREE + 1) * dim], m[dim];
    num t = parameter(T, "t"), two = from_int(2), P[dim], image[dim];
    G(free_points)(T, n, dim, Q);
    for (int j = 0; j < dim; j++)
        m[j] = unknown(T, "m", j);
    for (int i = 0; i <= n; i++)
        for (int j = 0; j < dim; j++) {
            doubled[i * dim + j] = mul(two, Q[i * dim + j]);
            moved[i * dim + j] = mul(two, add(Q[i * dim + j], m[j]));
        }
    G(bezier_casteljau)(n, dim, doubled, t, P);
    G(bezier_casteljau)(n, dim, moved, t, image);
    for (int j = 0; j < dim; j++)
        same(T, image[j], add(P[j], mul(from_int(fault(T, 2, 1)), m[j])));
}

/*
:::{statement} hu-1987:1-2-cauchy
:title: The relation of Cauchy, for invariance under translations
:zh: 柯西关系
:printed: To guarantee the invariance under translation, $\phi_0(t)+\phi_1(t)+\cdots+\phi_n(t)\equiv1$ has to be satisfied, the relation of Cauchy.
:holds-by: translation_adds_the_sum_of_the_functions
:hypothesis: shape_is_kept_without_the_sum_one | the curve goes where its points go, $P^*(t)=P(t)+m$.  To keep its shape, of
  which the section speaks, a constant sum $s$ is enough, since $P^*(t)=P(t)+s\,m$.
:confirmed-by: doubled_functions_keep_the_shape
:figure: sums_of_functions
:::
*/

#if RATIONAL
/*
:::{claim} shape_is_kept_without_the_sum_one
:title: A segment keeps its shape although the sum of its functions is 2
:zh: 函数和为 2 的线段保持形状
:kind: counterexample
:given: the curve $P=\phi_0Q_0+\phi_1Q_1$ with $\phi_0=k(1-t)$ and $\phi_1=kt$; $P^*$ is that of the points $Q_0+m$, $Q_1+m$; three parameters $t$
:data: k = 2; Q = (0,0) (1,0); m = (1,1); t = 0 1/2 1
:instead: k = 1
:then: $P^*(t)-P(t)$ is the same for all three $t$, so the segments are congruent; $\phi_0+\phi_1$ is not 1
:result: P*(t) - P(t) = (2,2) (2,2) (2,2); φ_0 + φ_1 = 2 2 2
:method: The points, exactly; the difference is linear in $t$, and so the same for every $t$; two positions of a segment are congruent when they differ by a
  translation.
:control: $\phi_0=1-t$, $\phi_1=t$
:::
*/
CLAIM(shape_is_kept_without_the_sum_one)
{
    num k = given(T, "k"), Q[4], m[2], t[3], moved[6], sum[3];
    int kept = 1, sum_is_one = 1;
    given_points(T, "Q", 2, 2, Q);
    given_points(T, "m", 1, 2, m);
    given_points(T, "t", 3, 1, t);
    for (int i = 0; i < 3; i++) {
        num first = mul(k, sub(from_int(1), t[i])), second = mul(k, t[i]);
        sum[i] = add(first, second);
        sum_is_one = sum_is_one && equal_q(sum[i], from_int(1));
        for (int j = 0; j < dim; j++) {
            num before = add(mul(first, Q[j]), mul(second, Q[dim + j]));
            num after = add(mul(first, add(Q[j], m[j])), mul(second, add(Q[dim + j], m[j])));
            moved[i * dim + j] = sub(after, before);
            kept = kept && equal_q(moved[i * dim + j], moved[j]);
        }
    }
    found_points(T, "P*(t) - P(t)", 3, 2, moved);
    found_points(T, "φ_0 + φ_1", 3, 1, sum);
    about(T, "whether the shape is not kept, or the sum of the functions is 1");
    refute(T, kept && !sum_is_one);
}

/*
:::{statement} hu-1987:1-2-example-cauchy
:title: The example violates the relation of Cauchy
:zh: 例不满足柯西关系
:printed: In the example the relation of Cauchy is not satisfied, so that the invariance of the shape after a translation cannot be guaranteed.
:holds-by: sum_of_two_cubes_is_less_than_one two_cubes_from_the_origin_trace_the_segment image_of_the_example_turns_everywhere
  new_coordinates_are_a_translation
:confirmed-by: image_of_the_example_is_not_the_translated_curve
:reading: shape_is_kept_without_the_sum_one | of every curve that violates the relation the shape changes
:meant: the words in the example of figure 1-1 (图1-1的例子中) | The example alone.
:figure: sums_of_functions

The factors of the example have a sum that is not even constant.  A constant sum other than 1 would violate the relation as well, and keep the shape.
:::

:::{claim} sum_of_two_cubes_is_less_than_one
:title: The sum of the two cubes is 1 at the ends only
:zh: 两立方之和小于一
:kind: decision
:given: $\sigma(t)=(1-t)^3+t^3$ on $[0,1]$, and $t_0$ in its middle
:data: t_0 = 1/2
:then: $\sigma-1$ is negative on $(0,1)$ and 0 at the ends, and the smallest value of $\sigma$ is the one at $t_0$
:result: σ(t) = "3*t^2 - 3*t + 1"; σ(t_0) = 1/4
:method: Signs of two polynomials on the interval, by root counts: of $\sigma-1$, and of $\sigma-\sigma(t_0)$; the values of the first at the ends.
:scope: 0 ≤ t ≤ 1
:control: the sum $(1-t)^3+3(1-t)^2t+3(1-t)t^2+t^3$
:::
*/
CLAIM(sum_of_two_cubes_is_less_than_one)
{
    poly t = poly_variable(), s = poly_sub(poly_constant(from_int(1)), t);
    poly sum = poly_add(poly_mul(s, poly_mul(s, s)), poly_mul(t, poly_mul(t, t)));
    poly middle = poly_scale(poly_mul(poly_mul(s, t), poly_add(s, t)), from_int(3));
    sum = fault(T, sum, poly_add(sum, middle));
    num least = poly_value(sum, given(T, "t_0"));
    found_text(T, "σ(t)", poly_to_string(sum, "t"));
    found(T, "σ(t_0)", least);
    poly below_one = poly_sub(sum, poly_constant(from_int(1))), above_least = poly_sub(sum, poly_constant(least));
    agree(T, sign_on(below_one, from_int(0), from_int(1), OPEN) == SIGN_NEGATIVE);
    agree(T, is_zero_q(poly_value(below_one, from_int(0))) && is_zero_q(poly_value(below_one, from_int(1))));
    agree(T, sign_on(above_least, from_int(0), from_int(1), CLOSED) == SIGN_NONNEGATIVE);
}
#endif

#include "chapters/judge/claims_off.h"
