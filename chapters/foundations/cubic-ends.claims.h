/*
# A cubic by its ends (端点条件)

Four vectors determine a cubic: where it begins and ends, and with which velocities.  The source prints the four
coefficients, and loses the difference between a point and a velocity, because both have been given a dot.  Then it says
what the lengths of the velocities do.
*/
#include "chapters/foundations/cubic.h"

#if RATIONAL
#include "exact/record/sign.h"
#endif

#include "chapters/judge/claims_on.h"

/*
:::{statement} hu-1987:1-4-hermite-determined
:title: Points and tangents at both ends determine the cubic
:zh: 端点位置与切矢确定三次曲线
:printed: If of a parametric cubic the position vector and the tangent vector are given at $t=0$ and at $t=1$, the curve is completely determined.
:holds-by: end_data_determine_the_cubic
:figure: lengths_of_the_tangents
:::
*/

/*
:::{claim} end_data_determine_the_cubic
:title: The coefficients meet the data at the ends, and are the only ones
:zh: 端点数据与系数一一对应
:given: any $Q_0,\dot Q_0,Q_1,\dot Q_1$ of space
:let: $A=2(Q_0-Q_1)+\dot Q_0+\dot Q_1$, $B=3(Q_1-Q_0)-2\dot Q_0-\dot Q_1$, $C=\dot Q_0$, $D=Q_0$
:then: for $P(t)=At^3+Bt^2+Ct+D$ is $P(0)=Q_0$, $P'(0)=\dot Q_0$, $P(1)=Q_1$, $P'(1)=\dot Q_1$; and the data of any cubic give back its
  coefficients
:method: Both ways round with everything a variable: the coefficients term by term as they stand here, values and derivatives by the definition.  The
  coefficients that the other claims compute with are compared, too.
:over: q#: end points; v#: end tangents; x# y# z#: coefficients
:control: $\dot Q_1$ left out of $B$
:::
*/
/* D, C, B, A for the ends Q and the derivatives V there, term by term. */
static void G(coefficients_of_ends)(const num Q[], const num V[], num c[])
{
    num two = from_int(2), three = from_int(3);
    for (int j = 0; j < space; j++) {
        num Q0 = Q[j], Q1 = Q[space + j], V0 = V[j], V1 = V[space + j];
        c[j] = Q0;
        c[space + j] = V0;
        c[2 * space + j] = sub(sub(mul(three, sub(Q1, Q0)), mul(two, V0)), V1); /* B = 3(Q_1 - Q_0) - 2V_0 - V_1 */
        c[3 * space + j] = add(add(mul(two, sub(Q0, Q1)), V0), V1);             /* A = 2(Q_0 - Q_1) + V_0 + V_1 */
    }
}

CLAIM(end_data_determine_the_cubic)
{
    num Q[2 * space], V[2 * space], c[4 * space], others[4 * space], given[4 * space];
    for (int m = 0; m < 2 * space; m++) {
        Q[m] = unknown(T, "q", m);
        V[m] = unknown(T, "v", m);
    }
    G(coefficients_of_ends)(Q, V, c);
    G(cubic_of_ends)(space, Q, V, others);
    about(T, "the coefficients of the other claims");
    for (int m = 0; m < 4 * space; m++)
        same(T, others[m], c[m]);
    about(T, "the data from the coefficients");
    for (int j = 0; j < space; j++)
        c[2 * space + j] = fault(T, c[2 * space + j], add(c[2 * space + j], V[space + j]));
    for (int end = 0; end < 2; end++)
        for (int j = 0; j < space; j++) {
            same(T, G(power_sum)(3, space, c, j, from_int(end)), Q[end * space + j]);
            same(T, G(power_sum_derivative)(3, space, c, j, 1, from_int(end)), V[end * space + j]);
        }
    about(T, "the coefficients from the data");
    G(free_points)(T, 3, space, given);
    for (int end = 0; end < 2; end++)
        for (int j = 0; j < space; j++) {
            Q[end * space + j] = G(power_sum)(3, space, given, j, from_int(end));
            V[end * space + j] = G(power_sum_derivative)(3, space, given, j, 1, from_int(end));
        }
    G(coefficients_of_ends)(Q, V, c);
    for (int m = 0; m < 4 * space; m++)
        same(T, c[m], given[m]);
}

/*
Four unknown vectors and four conditions: the two at $t=0$ give $D$ and $C$ at once, the two at $t=1$ are linear in $A$
and $B$.  So there is one cubic for all data, and the formulas can be checked without solving anything, by putting in
the two ends.

:::{statement} hu-1987:1-4-hermite-data
:title: The names of the data at the ends
:zh: 端点数据的记号
:printed: given the position vector $\dot Q_0$ and the tangent vector $\dot Q_0$ at $t=0$, and the position vector $\dot Q_1$ and the
  tangent vector $\dot Q_1$ at $t=1$
:refuted-by: position_is_not_the_tangent
:class: misprint
:corrected: the position vector $Q_0$ and the tangent vector $\dot Q_0$ at $t=0$, and $Q_1$ and $\dot Q_1$ at $t=1$
:corrected-by: end_data_determine_the_cubic
:confirmed-by: positions_for_the_dots_miss_three_coefficients
:figure: ends_with_lost_letters

One symbol for two data.  If it means the position, of the coefficients that are printed with it $D$ alone is right
(`positions_for_the_dots_miss_three_coefficients`).
:::
*/

#if RATIONAL
/* D, C, B, A as printed, for two vectors that stand for both the dotted letters of the points and those of the tangents:
 *     A = 2 (v_0 - v_1) + v_0 + v_1,   B = 3 (v_1 - v_0) - 2 v_0 - v_1,   C = D = v_0. */
static void printed_coefficients(const num v[], num c[])
{
    c[0] = c[1] = v[0];
    c[2] = sub(sub(mul(from_int(3), sub(v[1], v[0])), mul(from_int(2), v[0])), v[1]);
    c[3] = add(mul(from_int(2), sub(v[0], v[1])), add(v[0], v[1]));
}

/*
:::{claim} position_is_not_the_tangent
:title: The position at the beginning is not the tangent there
:zh: 端点位置矢量不等于切矢
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$ on a line, that is with the coefficients $c$ from $D$ to $A$
:data: c = 0 1 0 1
:instead: c = 1 1 0 1
:then: $P(0)\ne P'(0)$: no $\dot Q_0$ is both, and $C\ne P(0)$
:result: P(0) = 0; P'(0) = 1
:method: Value and derivative by the kernel.
:control: a cubic that begins one higher
:::
*/
CLAIM(position_is_not_the_tangent)
{
    num c[4], D[2];
    given_points(T, "c", 4, 1, c);
    G(power_derivatives)(3, 1, c, from_int(0), 1, D);
    found(T, "P(0)", D[0]);
    found(T, "P'(0)", D[1]);
    about(T, "P(0) and P'(0)");
    same(T, D[0], D[1]);
}

/*
:::{claim} positions_for_the_dots_miss_three_coefficients
:title: With positions for all dotted letters three coefficients are wrong
:zh: 记号全作位置矢量时三个系数有误
:kind: decision
:given: the ends $Q_0,Q_1$ on a line, with the derivatives $V_0,V_1$; the printed coefficients with $Q_i$ for every letter
:data: Q = 0 1; V = 2 1
:instead: Q = 2 3
:then: of $D,C,B,A$ as printed $D$ alone is right
:result: printed D, C, B, A = 0 0 2 -1; corrected = 0 2 -2 1
:method: Each against the corrected one, exactly.
:control: $Q_0=V_0$, where $C$ is right, too
:::
*/
CLAIM(positions_for_the_dots_miss_three_coefficients)
{
    num Q[2], V[2], c[4], printed[4];
    given_points(T, "Q", 2, 1, Q);
    given_points(T, "V", 2, 1, V);
    G(cubic_of_ends)(1, Q, V, c);
    printed_coefficients(Q, printed);
    found_points(T, "printed D, C, B, A", 4, 1, printed);
    found_points(T, "corrected", 4, 1, c);
    for (int k = 0; k < 4; k++)
        agree(T, equal_q(c[k], printed[k]) == (k == 0));
}

/*
A dot on the wrong letter can be found by moving the curve.  If both ends are moved by one vector, the velocities stay
as they are, and so do $A$, $B$ and $C$, but $D$ has to move.  In the print no point without a dot is left: the four
coefficients would not notice where the curve is.

:::{statement} hu-1987:1-4-hermite-a
:title: The coefficient A from the data at the ends
:zh: 系数 A
:printed: A=2(\dot Q_0-\dot Q_1)+\dot Q_0+\dot Q_1
:refuted-by: dotted_first_coefficient_misses_the_end
:class: misprint
:corrected: A=2(Q_0-Q_1)+\dot Q_0+\dot Q_1
:corrected-by: end_data_determine_the_cubic
:confirmed-by: positions_for_the_dots_miss_three_coefficients
:figure: ends_with_lost_letters

With $\dot Q_i$ for the positions everywhere it is wrong, too: `positions_for_the_dots_miss_three_coefficients`.
:::
*/

/* The corrected coefficients for the ends Q and the derivatives V of the block, with coefficient k as printed, where the
 * dotted letters of the points are those of the derivatives, as everywhere else. */
static void with_printed_coefficient(trial *T, int k, num Q[], num c[])
{
    num V[2], printed[4];
    given_points(T, "Q", 2, 1, Q);
    given_points(T, "V", 2, 1, V);
    G(cubic_of_ends)(1, Q, V, c);
    printed_coefficients(V, printed);
    c[k] = fault(T, c[k], printed[k]);
    found_points(T, "D, C, B, A", 4, 1, c);
}

/*
:::{claim} dotted_first_coefficient_misses_the_end
:title: With the dotted points in A the curve does not end where it should
:zh: 印刷的 A 不满足端点条件
:kind: counterexample
:given: the ends $Q_0,Q_1$ on a line, with the derivatives $V_0,V_1$; $A$ as printed, with $\dot Q_i=V_i$ for all its letters; $B$, $C$, $D$ as corrected
:data: Q = 0 1; V = 2 1
:then: $P(1)\ne Q_1$
:result: D, C, B, A = 0 2 -2 5; P(1) = 5
:method: $P(1)=A+B+C+D$, exactly.
:control: the corrected $A$
:::
*/
CLAIM(dotted_first_coefficient_misses_the_end)
{
    num Q[2], c[4];
    with_printed_coefficient(T, 3, Q, c);
    num end = G(power_sum)(3, 1, c, 0, from_int(1));
    found(T, "P(1)", end);
    about(T, "P(1) and Q_1");
    same(T, end, Q[1]);
}

/*
:::{statement} hu-1987:1-4-hermite-b
:title: The coefficient B from the data at the ends
:zh: 系数 B
:printed: B=3(\dot Q_1-\dot Q_0)-2\dot Q_0-\dot Q_1
:refuted-by: dotted_second_coefficient_misses_the_end
:class: misprint
:corrected: B=3(Q_1-Q_0)-2\dot Q_0-\dot Q_1
:corrected-by: end_data_determine_the_cubic
:confirmed-by: positions_for_the_dots_miss_three_coefficients
:figure: ends_with_lost_letters

With $\dot Q_i$ for the positions everywhere it is wrong, too: `positions_for_the_dots_miss_three_coefficients`.
:::

:::{claim} dotted_second_coefficient_misses_the_end
:title: With the dotted points in B the curve does not end where it should
:zh: 印刷的 B 不满足端点条件
:kind: counterexample
:given: the ends $Q_0,Q_1$ on a line, with the derivatives $V_0,V_1$; $B$ as printed, with $\dot Q_i=V_i$ for all its letters; $A$, $C$, $D$ as corrected
:data: Q = 0 1; V = 2 1
:then: $P(1)\ne Q_1$
:result: D, C, B, A = 0 2 -8 1; P(1) = -5
:method: $P(1)=A+B+C+D$, exactly.
:control: the corrected $B$
:::
*/
CLAIM(dotted_second_coefficient_misses_the_end)
{
    num Q[2], c[4];
    with_printed_coefficient(T, 2, Q, c);
    num end = G(power_sum)(3, 1, c, 0, from_int(1));
    found(T, "P(1)", end);
    about(T, "P(1) and Q_1");
    same(T, end, Q[1]);
}

/*
:::{statement} hu-1987:1-4-hermite-c
:title: The coefficient C from the data at the ends
:zh: 系数 C
:printed: C=\dot Q_0
:holds-by: end_data_determine_the_cubic
:meant: the dot over it, by which section 1-4 writes derivatives | $\dot Q_0$ is the tangent vector at
  $t=0$.
:reading: end_data_determine_the_cubic | $C$ is the tangent vector at $t=0$, for which $\dot Q_0$ stands
:reading: position_is_not_the_tangent | $C$ is the position vector at $t=0$, for which $\dot Q_0$ stands, as in the next line of the source, for $D$
:figure: ends_with_lost_letters
:::

:::{statement} hu-1987:1-4-hermite-d
:title: The coefficient D from the data at the ends
:zh: 系数 D
:printed: D=\dot Q_0
:refuted-by: dotted_last_coefficient_misses_the_beginning
:class: misprint
:corrected: D=Q_0
:corrected-by: end_data_determine_the_cubic
:reading: dotted_last_coefficient_misses_the_beginning | $D$ is the tangent vector at $t=0$, for which $\dot Q_0$ stands, as in the formula of $C$
:reading: end_data_determine_the_cubic | $D$ is the position vector at $t=0$, for which $\dot Q_0$ stands, as where the data are given
:meant: the sentence in which the data are given, whose first $\dot Q_0$ is called the position vector | $\dot Q_0$ is the position vector; the dot is a slip.
:figure: ends_with_lost_letters
:::

:::{claim} dotted_last_coefficient_misses_the_beginning
:title: With the dotted point in D the curve does not begin where it should
:zh: 印刷的 D 不满足端点条件
:kind: counterexample
:given: the ends $Q_0,Q_1$ on a line, with the derivatives $V_0,V_1$; $D$ as printed, with $\dot Q_0=V_0$; $A$, $B$, $C$ as corrected
:data: Q = 0 1; V = 2 1
:then: $P(0)\ne Q_0$
:result: D, C, B, A = 2 2 -2 1; P(0) = 2
:method: $P(0)=D$.
:control: the corrected $D$
:::
*/
CLAIM(dotted_last_coefficient_misses_the_beginning)
{
    num Q[2], c[4];
    with_printed_coefficient(T, 0, Q, c);
    num beginning = G(power_sum)(3, 1, c, 0, from_int(0));
    found(T, "P(0)", beginning);
    about(T, "P(0) and Q_0");
    same(T, beginning, Q[0]);
}

/*
Two cubics with the same ends and the same directions differ by two positive numbers, the ratios of the lengths.  The
source says that other lengths give another shape.  This is nearly true.  On a line the lengths change the motion and
not the segment; and if shape means what motions keep, then a cubic that is run backward has the two lengths exchanged,
and the second curve can be the first one, turned over.

:::{statement} hu-1987:1-4-lengths-change-the-shape
:title: Tangents of other lengths give another shape
:zh: 切矢大小不同则形状不同
:printed: If two curves have the same position vectors at the beginning and at the end, and the same directions of the tangent
  vectors, but different lengths of these, the shapes of the two curves are different.
:holds-by: cubic_run_backward_exchanges_the_ends congruent_cubics_have_these_lengths
:confirmed-by: other_lengths_give_another_cubic
:argued: | A cubic that is no line is run through once: otherwise it is a curve of a smaller degree in a polynomial of a degree above 1, and 3 and 2 being
  prime, that curve is a line.  Two with one arc so are $P_2(t)=P_1(\phi(t))$ with a fractional linear $\phi$.  It has no pole, both sides being
  polynomials, and takes $[0,1]$ to itself, because $P_1$ is in one point twice only finitely often: $\phi(t)=t$ or $\phi(t)=1-t$.  The first makes the lengths
  equal.  By the second $Q_0=Q_1$, and each tangent is opposite to that of the other end of the first curve, so that one direction at each end makes all
  parallel.  Where a motion takes one arc to the other, the same holds of the moved curve: by the first the lengths are equal, by the second exchanged.
:cites: [sendra-winkler-perez-diaz-2008]: two proper parametrizations of one rational curve differ by a fractional
  linear change of the parameter | The two cubics, each run once, so correspond to each other.
:meant: the heading of the part, on the forms of parametric cubics | Both curves are parametric cubics, and the lengths are not the same at one end
  at least.
:hypothesis: tangents_along_the_chord_keep_the_segment | $Q_1-Q_0$, $\dot Q_0$ and $\dot Q_1$ are not all parallel: if they are, the curve
  can be one segment for different lengths.
:hypothesis: exchanged_lengths_turn_the_cubic | the lengths of one curve are not those of the other with the ends exchanged:
  where curves that can be moved onto each other have one shape, as in section 1-2, such a curve can be the first one, turned,
  or a mirror image.
:figure: exchanged_lengths

If the shape is the set of the points, where it is, the first hypothesis is enough.
:::

:::{claim} other_lengths_give_another_cubic
:title: The cubic of other lengths leaves the first cubic
:zh: 切矢长度不同的三次曲线不重合
:types: rational
:given: random ends and directions in the plane that are not all parallel, two different pairs of lengths, one of them or both different, longer or shorter
:where: the ends and directions are in one plane and not all parallel; the two pairs of lengths are different
:then: the second curve does not satisfy the implicit equation of the first
:method: The equation by Bézout's determinant, at ten points of the second curve, at one of which at least it is not satisfied.
:control: the lengths equal
:::
*/
/* The Bézier points of the cubic of these ends. */
static void points_of_ends(const num Q[], const num V[], num R[])
{
    for (int j = 0; j < dim; j++) {
        R[j] = Q[j];
        R[dim + j] = add(Q[j], mul(from_ratio(1, 3), V[j]));
        R[2 * dim + j] = sub(Q[dim + j], mul(from_ratio(1, 3), V[dim + j]));
        R[3 * dim + j] = Q[dim + j];
    }
}

CLAIM(other_lengths_give_another_cubic)
{
    num Q[2 * dim], V[2 * dim], W[2 * dim], R[4 * dim], c[4 * dim], P[dim], one = from_int(1);
    num weights[4] = {one, one, one, one};
    int kind = pick(T, 0, 2), leaves = 0; /* which of the two lengths differ */
    for (int m = 0; m < 2 * dim; m++)
        Q[m] = unknown(T, "q", m);
    for (int end = 0; end < 2; end++) {
        num longer = add(one, positive(T, "l", end)), other = pick(T, 0, 1) ? longer : div(one, longer);
        num factor = fault(T, kind == end ? one : other, one);
        for (int j = 0; j < dim; j++) {
            V[end * dim + j] = unknown(T, "v", end * dim + j);
            W[end * dim + j] = mul(factor, V[end * dim + j]);
        }
    }
    points_of_ends(Q, V, R);
    G(cubic_of_ends)(dim, Q, W, c);
    for (int k = 1; k <= 10; k++) {
        G(power_point)(3, dim, c, from_ratio(k, 11), P);
        leaves |= !is_zero_q(G(implicit_value)(3, R, weights, P[0], P[1]));
    }
    agree(T, leaves);
}
#endif

/*
:::{claim} cubic_run_backward_exchanges_the_ends
:title: Run backward, a cubic has its ends exchanged, and its tangents exchanged and opposite
:zh: 反向的三次曲线
:given: any cubic in space, $W(t)=P(1-t)$
:then: $W(0)=P(1)$, $W(1)=P(0)$, $W'(0)=-P'(1)$, $W'(1)=-P'(0)$
:method: The coefficients of $W$ by the kernel; values and derivatives by the definition, everything a variable.
:scope: cubic curves
:over: x# y# z#: coefficients
:control: the tangents not opposite
:::
*/
CLAIM(cubic_run_backward_exchanges_the_ends)
{
    num c[4 * space], back[4 * space];
    G(free_points)(T, 3, space, c);
    G(power_on_interval)(3, space, c, from_int(1), from_int(0), back);
    for (int end = 0; end < 2; end++)
        for (int j = 0; j < space; j++) {
            num here = from_int(end), there = from_int(1 - end),
                slope = G(power_sum_derivative)(3, space, c, j, 1, there);
            about(T, "the ends");
            same(T, G(power_sum)(3, space, back, j, here), G(power_sum)(3, space, c, j, there));
            about(T, "the tangents");
            same(T, G(power_sum_derivative)(3, space, back, j, 1, here), fault(T, neg(slope), slope));
        }
}

/* Row i of a rotation of space by the four numbers q, not all 0, of its half:  cos(θ/2) = q_0/|q|, and (q_1, q_2, q_3)/|q| is sin(θ/2)
 * times the unit vector of the axis. */
static void G(row_of_rotation)(const num q[4], int i, num row[])
{
    int j = (i + 1) % space, k = (i + 2) % space;
    num square[4], two = from_int(2);
    for (int m = 0; m < 4; m++)
        square[m] = mul(q[m], q[m]);
    num cosine = sub(square[0], add(square[1 + j], square[1 + k])), whole = G(norm_squared)(4, q);
    row[i] = div(add(cosine, square[1 + i]), whole);
    row[j] = div(mul(two, sub(mul(q[1 + i], q[1 + j]), mul(q[0], q[1 + k]))), whole);
    row[k] = div(mul(two, add(mul(q[1 + i], q[1 + k]), mul(q[0], q[1 + j]))), whole);
}

/*
:::{claim} congruent_cubics_have_these_lengths
:title: A cubic that is moved, or moved and run backward, has the same lengths, or the same with the ends exchanged
:zh: 合同的三次曲线切矢长度相同或两端互换
:given: any cubic in space; any rotation, with or without a reflection, and any translation
:then: the image of $P(t)$ has tangents of the lengths $|\dot Q_0|$, $|\dot Q_1|$ at its ends, that of $P(1-t)$ of the lengths $|\dot
  Q_1|$, $|\dot Q_0|$
:method: The squares of the lengths by the definition, everything a variable; a rotation by the cosine of half its angle and the vector along its axis whose length is
  the sine of that half, up to a common factor: four numbers, not all 0, which every rotation has.
:scope: cubic curves
:over: x# y# z#: coefficients; q#: rotations; m#: translations
:control: the lengths of $P(1-t)$ not exchanged
:::
*/
CLAIM(congruent_cubics_have_these_lengths)
{
    num c[4 * space], run[4 * space], q[4], row[space], shift[space], D[2][space];
    G(free_points)(T, 3, space, c);
    for (int m = 0; m < 4; m++)
        q[m] = unknown(T, "q", m);
    for (int j = 0; j < space; j++)
        shift[j] = unknown(T, "m", j);
    for (int end = 0; end < 2; end++)
        for (int j = 0; j < space; j++)
            D[end][j] = G(power_sum_derivative)(3, space, c, j, 1, from_int(end));
    for (int kind = 0; kind < 4; kind++) { /* run backward or not, reflected or not */
        int backward = kind / 2, reflected = kind % 2;
        num image[4 * space];
        G(power_on_interval)(3, space, c, from_int(backward), from_int(1 - backward), run);
        for (int k = 0; k < 4; k++) {
            run[space * k] = reflected ? neg(run[space * k]) : run[space * k];
            for (int i = 0; i < space; i++) {
                G(row_of_rotation)(q, i, row);
                num turned = G(dot)(space, row, run + space * k);
                image[space * k + i] = k == 0 ? add(turned, shift[i]) : turned;
            }
        }
        for (int end = 0; end < 2; end++) {
            num E[space];
            for (int j = 0; j < space; j++)
                E[j] = G(power_sum_derivative)(3, space, image, j, 1, from_int(end));
            int other = fault(T, backward ? 1 - end : end, end);
            same(T, G(norm_squared)(space, E), G(norm_squared)(space, D[other]));
        }
    }
}

#if RATIONAL
/* Whether the tangents V and U at both ends have the same directions, and at one end at least not the same length. */
static int only_the_lengths_differ(const num V[], const num U[])
{
    int directions = 1, lengths = 1;
    for (int end = 0; end < 2; end++) {
        const num *v = V + dim * end, *u = U + dim * end;
        directions = directions && is_zero_q(G(cross2)(v, u)) && sign_q(G(dot)(dim, v, u)) > 0;
        lengths = lengths && equal_q(G(norm_squared)(dim, v), G(norm_squared)(dim, u));
    }
    return directions && !lengths;
}

/*
:::{claim} exchanged_lengths_turn_the_cubic
:title: Two cubics with exchanged lengths that are the first ones, turned over
:zh: 两端长度互换得同一曲线的旋转或镜像
:kind: counterexample
:given: the ends $Q$; the cubics $P$ with the tangents $V$ there, and $W$ with the tangents $U$ of the same directions, the lengths exchanged; and $P^*$,
  $W^*$ with $V^*$, $U^*$; all four by their coefficients from $D$ to $A$
:data: Q = (0,0) (1,0); V = (1,1) (2,2); U = (2,2) (1,1); V* = (1,1) (2,-2); U* = (2,2) (1,-1)
:instead: U = (2,2) (2,2); U* = (2,2) (2,-2)
:then: $W(t)=Q_0+Q_1-P(1-t)$: $W$ is $P$ turned by two right angles about the middle of the chord; and $W^*$ is $P^*$, reflected in the
  perpendicular bisector of the chord.  Ends and directions are the same, the lengths are not, and no tangent is along the chord
:result: P = (0,0) (1,1) (-1,-4) (1,3); W = (0,0) (2,2) (-2,-5) (1,3); P* = (0,0) (1,1) (-1,0) (1,-1); W* = (0,0) (2,2) (-2,-3) (1,1)
:method: The coefficients of $P(1-t)$ by the kernel; vector and scalar products and squares for the directions and lengths.  That the second curve is no image
  of the first is refuted.
:control: the tangents of the second curve both of the length of the longer one
:::
*/
/* Whether W is P(1-t) with both coordinates turned over between Q_0 and Q_1, or only the abscissa: x -> Q_0x + Q_1x - x. */
static int is_turned_over(const num Q[], const num P[], const num W[], int only_the_abscissa)
{
    num back[8];
    int same_curve = 1;
    G(power_on_interval)(3, dim, P, from_int(1), from_int(0), back);
    for (int k = 0; k < 4; k++)
        for (int j = 0; j < dim; j++) {
            num sum = k == 0 ? add(Q[j], Q[dim + j]) : from_int(0), value = back[k * dim + j];
            same_curve &= equal_q(W[k * dim + j], j == 1 && only_the_abscissa ? value : sub(sum, value));
        }
    return same_curve;
}

CLAIM(exchanged_lengths_turn_the_cubic)
{
    static const char *const tangents[2][2] = {{"V", "U"}, {"V*", "U*"}}, *const curve[2][2] = {{"P", "W"},
                                                                                                {"P*", "W*"}};
    num Q[4], V[2][2][4], c[2][2][8];
    given_points(T, "Q", 2, 2, Q);
    for (int pair = 0; pair < 2; pair++)
        for (int k = 0; k < 2; k++) {
            given_points(T, tangents[pair][k], 2, 2, V[pair][k]);
            G(cubic_of_ends)(dim, Q, V[pair][k], c[pair][k]);
        }
    for (int pair = 0; pair < 2; pair++)
        for (int k = 0; k < 2; k++)
            found_points(T, curve[pair][k], 4, 2, c[pair][k]);
    num chord[2] = {sub(Q[2], Q[0]), sub(Q[3], Q[1])};
    int allowed = 1; /* the lengths alone differ, and no tangent is along the chord */
    for (int pair = 0; pair < 2; pair++) {
        allowed = allowed && only_the_lengths_differ(V[pair][0], V[pair][1]);
        for (int end = 0; end < 2; end++)
            allowed = allowed && !is_zero_q(G(cross2)(V[pair][0] + dim * end, chord));
    }
    about(T, "whether one of the second curves is no image of the first");
    refute(T, allowed && is_turned_over(Q, c[0][0], c[0][1], 0) && is_turned_over(Q, c[1][0], c[1][1], 1));
}

/*
:::{claim} tangents_along_the_chord_keep_the_segment
:title: With both tangents along the chord the lengths do not matter
:zh: 切矢沿弦时形状不变
:kind: counterexample
:given: two cubics with the ends $Q$ on the $x$-axis, and with the tangents $V$ and $U$, all along the chord, of the same directions and other lengths
:data: Q = (0,0) (1,0); V = (3/2,0) (3/2,0); U = (2,0) (1/2,0)
:instead: U = (2,1) (1/2,0)
:then: both curves run once and forward along the same segment: $y=0$, and $x'>0$ on $(0,1)$
:result: with V, x' = "3*t^2 - 3*t + 3/2"; with U, x' = "3/2*t^2 - 3*t + 2"
:method: The directions and lengths; the coefficients; the sign of $x'$ by root counts.  That the two sets differ is refuted.
:control: a second curve with a tangent that leaves the chord
:::
*/
/* Whether the cubic of these ends and tangents runs once and forward along the x-axis; its x' is the result of that name. */
static int runs_along_the_axis(trial *T, const char *name, const num Q[], const num V[])
{
    num c[8];
    G(cubic_of_ends)(dim, Q, V, c);
    poly speed = poly_derivative(poly_from_q(4, (num[]){c[0], c[2], c[4], c[6]}));
    int flat = 1;
    for (int k = 0; k < 4; k++)
        flat &= is_zero_q(c[dim * k + 1]);
    found_text(T, name, poly_to_string(speed, "t"));
    return flat && sign_on(speed, from_int(0), from_int(1), OPEN) == SIGN_POSITIVE;
}

CLAIM(tangents_along_the_chord_keep_the_segment)
{
    num Q[4], V[4], U[4];
    given_points(T, "Q", 2, 2, Q);
    given_points(T, "V", 2, 2, V);
    given_points(T, "U", 2, 2, U);
    int first = runs_along_the_axis(T, "with V, x'", Q, V), second = runs_along_the_axis(T, "with U, x'", Q, U);
    about(T, "whether the two sets of points differ");
    refute(T, only_the_lengths_differ(V, U) && first && second);
}
#endif

/*
:::{statement} hu-1987:1-4-lengths-matter
:title: Directions and lengths of the tangents have influence on the shape
:zh: 切矢的方向与大小均影响形状
:printed: Not only the direction of a tangent vector, its length, too: both influence the shape of the curve.
:holds-by: each_form_occurs other_directions_give_another_form
:example: an influence is said, and curves that differ in the lengths alone, and two that differ in a direction alone, show it.
:figure: lengths_of_the_tangents
:::
*/

#if RATIONAL
/*
:::{claim} other_directions_give_another_form
:title: With the same ends and lengths another direction makes an S of an arch
:zh: 端点与切矢长度相同而方向不同
:kind: decision
:given: two cubics with the ends $Q$ on the $x$-axis, and with the tangents $V$ and $U$, of the same lengths, the last one turned; two parameters $t$
:data: Q = (0,0) (3,0); V = (3,3) (3,-3); U = (3,3) (3,3); t = 1/4 3/4
:instead: U = (3,3) (3,-3)
:then: the first curve is above its chord for $0<t<1$; the second one is above it at the first $t$ and below it at the second
:result: y of the second = 9/32 -9/32
:method: The tangents, and the squares of their lengths; the sign of $y$ on $(0,1)$ by root counts, and its values.
:control: the same tangents
:::
*/
CLAIM(other_directions_give_another_form)
{
    num Q[4], V[4], U[4], t[2], c[8], e[8], y[2];
    given_points(T, "Q", 2, 2, Q);
    given_points(T, "V", 2, 2, V);
    given_points(T, "U", 2, 2, U);
    given_points(T, "t", 2, 1, t);
    G(cubic_of_ends)(dim, Q, V, c);
    G(cubic_of_ends)(dim, Q, U, e);
    about(T, "the lengths");
    for (int end = 0; end < 2; end++)
        same(T, G(norm_squared)(dim, V + 2 * end), G(norm_squared)(dim, U + 2 * end));
    about(T, "whether the first tangent is the same and the last one is turned");
    agree(T, equal_q(V[0], U[0]) && equal_q(V[1], U[1]) && !is_zero_q(G(cross2)(V + 2, U + 2)));
    poly height = poly_from_q(4, (num[]){c[1], c[3], c[5], c[7]});
    for (int k = 0; k < 2; k++)
        y[k] = G(power_sum)(3, dim, e, 1, t[k]);
    found_points(T, "y of the second", 2, 1, y);
    about(T, "whether the first curve is above its chord, and the second one first above and then below");
    agree(T, sign_on(height, from_int(0), from_int(1), OPEN) == SIGN_POSITIVE);
    agree(T, sign_q(y[0]) > 0 && sign_q(y[1]) < 0);
}
#endif

#include "chapters/judge/claims_off.h"
