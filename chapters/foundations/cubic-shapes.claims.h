/*
# The shapes of a cubic (参数三次曲线的形态)

A plane cubic can run on without incident, change its side once or twice, turn on its heel, or cross itself.  Which of these it
does is decided by three numbers, the determinants $a=A\times B$, $b=A\times C$, $c=B\times C$ of its coefficients, and by
$\delta=3b^2-4ac$.
*/
#include "chapters/foundations/definition.h"

#if RATIONAL
#include "exact/record/sign.h"
#endif

#include "chapters/judge/claims_on.h"

enum { dim = 2, space = 3 };

/*
## Ends and tangents

:::{statement} hu-1987:1-4-hermite-determined
:title: Points and tangents at both ends determine the cubic
:zh: 端点位置与切矢确定三次曲线
:printed: If the position vector and the tangent vector are given at $t=0$ and at $t=1$, the curve is completely determined.
:holds-by: end_data_determine_the_cubic
:figure: lengths_of_the_tangents
:::
*/

/* c = (D, C, B, A) for the ends Q = (Q_0, Q_1) with the derivatives V, as corrected. */
static void G(cubic_of_ends)(int dims, const num Q[], const num V[], num c[])
{
    for (int j = 0; j < dims; j++) {
        num q0 = Q[j], q1 = Q[dims + j], v0 = V[j], v1 = V[dims + j], edge = sub(q1, q0);
        c[j] = q0;
        c[dims + j] = v0;
        c[2 * dims + j] = sub(mul(from_int(3), edge), add(add(v0, v0), v1));
        c[3 * dims + j] = sub(add(v0, v1), add(edge, edge));
    }
}

/*
:::{claim} end_data_determine_the_cubic
:title: The coefficients meet the data at the ends, and are the only ones
:zh: 端点数据与系数一一对应
:given: any $Q_0,\dot Q_0,Q_1,\dot Q_1$ of the plane
:then: with the four coefficients $P(0)=Q_0$, $P'(0)=\dot Q_0$, $P(1)=Q_1$, $P'(1)=\dot Q_1$; and the data of any cubic give back its
  coefficients
:method: Both ways round with everything a variable: values and derivatives by the definition.
:control: $\dot Q_1$ left out of $B$
:::
*/
CLAIM(end_data_determine_the_cubic)
{
    num Q[2 * dim], V[2 * dim], c[4 * dim], given[4 * dim];
    for (int m = 0; m < 2 * dim; m++) {
        Q[m] = unknown(T, "q", m);
        V[m] = unknown(T, "v", m);
    }
    G(cubic_of_ends)(dim, Q, V, c);
    for (int j = 0; j < dim; j++)
        c[2 * dim + j] = fault(T, c[2 * dim + j], add(c[2 * dim + j], V[dim + j]));
    for (int end = 0; end < 2; end++)
        for (int j = 0; j < dim; j++) {
            same(T, G(power_sum)(3, dim, c, j, from_int(end)), Q[end * dim + j]);
            same(T, G(power_sum_derivative)(3, dim, c, j, 1, from_int(end)), V[end * dim + j]);
        }
    G(free_points)(T, 3, dim, given);
    for (int end = 0; end < 2; end++)
        for (int j = 0; j < dim; j++) {
            Q[end * dim + j] = G(power_sum)(3, dim, given, j, from_int(end));
            V[end * dim + j] = G(power_sum_derivative)(3, dim, given, j, 1, from_int(end));
        }
    G(cubic_of_ends)(dim, Q, V, c);
    for (int m = 0; m < 4 * dim; m++)
        same(T, c[m], given[m]);
}

/*
:::{statement} hu-1987:1-4-hermite-data
:title: The names of the data at the ends
:zh: 端点数据的记号
:printed: given the position vector $\dot Q_0$ and the tangent vector $\dot Q_0$ at $t=0$, and the position vector $\dot Q_1$ and the tangent vector
  $\dot Q_1$ at $t=1$
:refuted-by: position_is_not_the_tangent
:class: misprint
:corrected: the position vector $Q_0$ and the tangent vector $\dot Q_0$ at $t=0$, and $Q_1$ and $\dot Q_1$ at $t=1$
:corrected-by: end_data_determine_the_cubic
:figure: ends_with_lost_letters

One symbol for two data.  If it means the tangent, $C$ is right below and $A$, $B$, $D$ are not; if it means the position, $D$ is right and
$A$, $B$, $C$ are not (`positions_for_the_dots_miss_three_coefficients`).
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
:given: the cubic on a line with the coefficients $c$, from $D$ to $A$
:data: c = 0 1 0 0
:instead: c = 1 1 0 0
:then: $P(0)\ne\dot P(0)$: no $\dot Q_0$ is both, and $C\ne P(0)$
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
:data: Q = 0 1; V = 1 1
:instead: Q = 1 1
:then: of $D,C,B,A$ as printed $D$ alone is right
:result: printed D, C, B, A = 0 0 2 -1; corrected = 0 1 0 0
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
:::{statement} hu-1987:1-4-hermite-a
:title: The coefficient A from the data at the ends
:zh: 系数 A
:printed: A=2(\dot Q_0-\dot Q_1)+\dot Q_0+\dot Q_1
:refuted-by: dotted_first_coefficient_misses_the_end
:class: misprint
:corrected: A=2(Q_0-Q_1)+\dot Q_0+\dot Q_1
:corrected-by: end_data_determine_the_cubic
:figure: ends_with_lost_letters

The position vectors have been given the dots of the tangent vectors, here, in $B$ and in $D$.
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
:given: the ends $Q_0,Q_1$ on a line, with the derivatives $V_0,V_1$; $A$ as printed, $B$, $C$, $D$ as corrected
:data: Q = 0 1; V = 1 1
:then: $P(1)\ne Q_1$
:result: D, C, B, A = 0 1 0 2; P(1) = 3
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
:figure: ends_with_lost_letters
:::

:::{claim} dotted_second_coefficient_misses_the_end
:title: With the dotted points in B the curve does not end where it should
:zh: 印刷的 B 不满足端点条件
:kind: counterexample
:given: the ends $Q_0,Q_1$ on a line, with the derivatives $V_0,V_1$; $B$ as printed, $A$, $C$, $D$ as corrected
:data: Q = 0 1; V = 1 1
:then: $P(1)\ne Q_1$
:result: D, C, B, A = 0 1 -3 0; P(1) = -2
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
:reading: end_data_determine_the_cubic | $\dot Q_0$ is the tangent vector: true
:reading: position_is_not_the_tangent | $\dot Q_0$ is the position vector, as the next line has it for $D$: false
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
:reading: dotted_last_coefficient_misses_the_beginning | $\dot Q_0$ is the tangent vector, as for $C$ in the line before: false
:reading: end_data_determine_the_cubic | $\dot Q_0$ is the position vector, as the sentence above has it, too: true
:figure: ends_with_lost_letters
:::

:::{claim} dotted_last_coefficient_misses_the_beginning
:title: With the dotted point in D the curve does not begin where it should
:zh: 印刷的 D 不满足端点条件
:kind: counterexample
:given: the ends $Q_0,Q_1$ on a line, with the derivatives $V_0,V_1$; $D$ as printed, $A$, $B$, $C$ as corrected
:data: Q = 0 1; V = 1 1
:then: $P(0)\ne Q_0$
:result: D, C, B, A = 1 1 0 0; P(0) = 1
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
:::{statement} hu-1987:1-4-lengths-change-the-shape
:title: Tangents of other lengths give another shape
:zh: 切矢大小不同则形状不同
:printed: If two curves have the same position vectors at the beginning and at the end, and the same directions of the tangent
  vectors, but different lengths of these, the shapes of the two curves are different.
:holds-by: other_lengths_give_another_cubic congruent_cubics_have_these_lengths
:hypothesis: tangents_along_the_chord_keep_the_segment | $Q_1-Q_0$, $\dot Q_0$ and $\dot Q_1$ are not all parallel: if they are, the curve can be
  one segment for many lengths.
:hypothesis: exchanged_lengths_turn_the_cubic | The lengths of one curve are not those of the other with the two ends exchanged, if curves that
  can be moved onto each other have one shape, as in section 1-2: such a curve can be the first one, turned, or a mirror image.
:reading: other_lengths_give_another_cubic | the shape is the set of the points: true with the first hypothesis alone
:reading: exchanged_lengths_turn_the_cubic | the shape is what rotations and translations keep: false with the first hypothesis alone, true with
  both
:figure: exchanged_lengths
:::

:::{claim} other_lengths_give_another_cubic
:title: The cubic of other lengths leaves the first cubic
:zh: 切矢长度不同的三次曲线不重合
:types: rational
:given: random ends and directions that are not all parallel, two different pairs of lengths, one of them or both different
:then: the second curve is not contained in the implicit equation of the first
:method: The equation by Bézout's determinant, at ten points of the second curve: a polynomial of degree at most 9 in $t$ that is
  not 0 at all of them.  That no exception remains: two cubics with one arc are $P_2(t)=P_1(\phi(t))$ with a fractional
  linear $\phi$, as soon as they are no line; polynomials leave only the affine ones, so $\phi(t)=t$ or $\phi(t)=1-t$.  The first makes the
  lengths equal; the second makes $Q_0=Q_1$ and the tangents parallel.
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
        num factor = fault(T, kind == end ? one : add(one, positive(T, "l", end)), one);
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
:::{claim} congruent_cubics_have_these_lengths
:title: A cubic that is moved, or moved and run backward, has the same lengths, or the same with the ends exchanged
:zh: 合同的三次曲线切矢长度相同或两端互换
:given: any plane cubic; a rotation by any angle, with or without a reflection, and any translation
:then: the image of $P(t)$ has tangents of the lengths $|\dot Q_0|$, $|\dot Q_1|$ at its ends, that of $P(1-t)$ of the lengths $|\dot Q_1|$, $|\dot Q_0|$
:method: The squares of the lengths by the definition, everything a variable.  Two cubics that are no lines and of which a motion takes one to
  the other are one up to the motion and to $\phi(t)=t$ or $1-t$: so other lengths that are not exchanged ones give another shape.
:control: the lengths of $P(1-t)$ not exchanged
:::
*/
CLAIM(congruent_cubics_have_these_lengths)
{
    num c[4 * dim], image[4 * dim], D[2][dim], E[2][dim], one = from_int(1);
    struct G(turn) angle = G(turn_by)(parameter(T, "a"));
    G(free_points)(T, 3, dim, c);
    for (int end = 0; end < 2; end++)
        for (int j = 0; j < dim; j++)
            D[end][j] = G(power_sum_derivative)(3, dim, c, j, 1, from_int(end));
    for (int kind = 0; kind < 4; kind++) { /* reflected or not, run backward or not */
        int backward = kind / 2;
        if (backward)
            G(power_on_interval)(3, dim, c, one, from_int(0), image);
        for (int k = 0; k < 4; k++) {
            num x = (backward ? image : c)[dim * k], y = (backward ? image : c)[dim * k + 1];
            if (kind % 2)
                y = neg(y);
            image[dim * k] = sub(mul(angle.cos, x), mul(angle.sin, y));
            image[dim * k + 1] = add(mul(angle.sin, x), mul(angle.cos, y));
        }
        for (int j = 0; j < dim; j++)
            image[j] = add(image[j], unknown(T, "m", j));
        for (int end = 0; end < 2; end++) {
            for (int j = 0; j < dim; j++)
                E[end][j] = G(power_sum_derivative)(3, dim, image, j, 1, from_int(end));
            int other = fault(T, backward ? 1 - end : end, end);
            same(T, G(norm_squared)(dim, E[end]), G(norm_squared)(dim, D[other]));
        }
    }
}

#if RATIONAL
/*
:::{claim} exchanged_lengths_turn_the_cubic
:title: With exchanged lengths the cubic is the first one, turned over
:zh: 两端长度互换得旋转后的同一曲线
:kind: counterexample
:given: the ends $Q$; $P$ with the tangents $V$, and $W$ with the tangents $U$ of the same directions, the lengths exchanged; and $P^*$, $W^*$ with $V^*$, $U^*$
:data: Q = (0,0) (1,0); V = (1,1) (2,2); U = (2,2) (1,1); V* = (1,1) (2,-2); U* = (2,2) (1,-1)
:instead: U = (2,2) (2,2); U* = (2,2) (2,-2)
:then: $W(t)=Q_0+Q_1-P(1-t)$: $W$ is $P$ turned by two right angles about the middle of the chord; and $W^*$ is $P^*$, reflected in the
  perpendicular bisector of the chord.  Ends and directions are the same, the lengths are not, and no tangent is along the chord
:result: P = (0,0) (1,1) (-1,-4) (1,3); W = (0,0) (2,2) (-2,-5) (1,3); P* = (0,0) (1,1) (-1,0) (1,-1); W* = (0,0) (2,2) (-2,-3) (1,1)
:method: The coefficients of $P(1-t)$ by the kernel; that the second curve is no image of the first is refuted.
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
    about(T, "whether one of the second curves is no image of the first");
    refute(T, is_turned_over(Q, c[0][0], c[0][1], 0) && is_turned_over(Q, c[1][0], c[1][1], 1));
}

/*
:::{claim} tangents_along_the_chord_keep_the_segment
:title: With both tangents along the chord the lengths do not matter
:zh: 切矢沿弦时形状不变
:kind: counterexample
:given: the ends $Q$ on the $x$-axis; two pairs of tangents, $V$ and $U$, along the chord
:data: Q = (0,0) (1,0); V = (1,0) (1,0); U = (2,0) (1/2,0)
:instead: U = (2,1) (1/2,0)
:then: both curves run once and forward along the same segment: $y=0$, and $x'>0$ on $(0,1)$
:result: x' with V = "1"; x' with U = "3/2*t^2 - 3*t + 2"
:method: The coefficients; the sign of $x'$ by root counts.  That the two sets differ is refuted.
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
    int first = runs_along_the_axis(T, "x' with V", Q, V), second = runs_along_the_axis(T, "x' with U", Q, U);
    about(T, "whether the two sets of points differ");
    refute(T, first && second);
}
#endif

/*
:::{statement} hu-1987:1-4-lengths-matter
:title: Directions and lengths of the tangents have influence on the shape
:zh: 切矢的方向与大小均影响形状
:printed: Not only the direction of a tangent vector, its length, too, influences the shape of the curve.
:holds-by: each_form_occurs
:figure: lengths_of_the_tangents
:::

## Inflections (拐点)

:::{statement} hu-1987:1-4-derivatives
:title: The first two derivatives of the cubic
:zh: 一、二阶导矢
:printed: \dot P(t)=3At^2+2Bt+C,\qquad\ddot P(t)=6At+2B
:holds-by: derivatives_of_a_cubic
:figure: derivatives_with_lost_dots
:::

:::{claim} derivatives_of_a_cubic
:title: The three derivatives of a cubic
:zh: 三次曲线的各阶导矢
:given: any coefficients in space, any $t$
:then: $P'=3At^2+2Bt+C$, $P''=6At+2B$, $P'''=6A$
:method: The kernel against the printed expressions, everything a variable.
:control: $3At$ in the place of $3At^2$
:::
*/
CLAIM(derivatives_of_a_cubic)
{
    num c[4 * space], D[4 * space], t = parameter(T, "t");
    G(free_points)(T, 3, space, c);
    G(power_derivatives)(3, space, c, t, 3, D);
    for (int j = 0; j < space; j++) {
        num C = c[space + j], B = c[2 * space + j], A = c[3 * space + j], tt = fault(T, mul(t, t), t);
        same(T, D[space + j], add(add(mul(mul(from_int(3), A), tt), mul(mul(from_int(2), B), t)), C));
        same(T, D[2 * space + j], add(mul(mul(from_int(6), A), t), mul(from_int(2), B)));
        same(T, D[3 * space + j], mul(from_int(6), A));
    }
}

/*
:::{statement} hu-1987:1-4-third-derivative
:title: The third derivative of the cubic
:zh: 三阶导矢
:printed: \ddot P(t)=[\ddot x\;\ddot y\;\ddot z]=6A
:refuted-by: second_derivative_is_not_constant
:class: misprint
:corrected: \dddot P(t)=[\dddot x\;\dddot y\;\dddot z]=6A
:corrected-by: derivatives_of_a_cubic
:figure: derivatives_with_lost_dots

The third dot is lost in this line, and in those that use it.
:::
*/

#if RATIONAL
/*
:::{claim} second_derivative_is_not_constant
:title: The second derivative of a parabola is not six times its cubic coefficient
:zh: 二阶导矢不等于 6A
:kind: counterexample
:given: the parabola with the coefficients $c$, from $D$ to $A$, and $t$
:data: c = 0 0 1 0; t = 1/3
:then: $P''$ is not six times $A$
:result: P''(t) = 2; 6A = 0
:method: The kernel, exactly.
:control: the third derivative
:::
*/
CLAIM(second_derivative_is_not_constant)
{
    num c[4], D[4];
    given_points(T, "c", 4, 1, c);
    G(power_derivatives)(3, 1, c, given(T, "t"), 3, D);
    num derivative = D[fault(T, 3, 2)], printed = mul(from_int(6), c[3]);
    found(T, "P''(t)", derivative);
    found(T, "6A", printed);
    about(T, "the derivative, and 6A");
    same(T, derivative, printed);
}

/*
:::{statement} hu-1987:1-4-curvature
:title: The formula of the curvature
:zh: 曲率公式
:printed: K=\frac{|\dot P\times\ddot P|}{s^3}
:refuted-by: printed_letter_spoils_the_curvature
:class: misprint
:corrected: $K=\frac{|\dot P\times\ddot P|}{\dot s^3}$, where $\dot s=|\dot P|$ is the speed
:corrected-by: curvature_and_torsion_belong_to_arc_length
:reading: printed_letter_spoils_the_curvature | $s$ is the length of the arc, as everywhere else: false
:reading: curvature_and_torsion_belong_to_arc_length | $s=|\dot P|$ is the speed, which the text at hand does not say: true
:figure: curvature_and_the_speed

One more dot is lost.  Without it the letter is the length of the arc, and then the quotient depends on where the length is
measured from, and is not bounded near that point.
:::

:::{claim} printed_letter_spoils_the_curvature
:title: With the length of the arc in the place of the speed the quotient is not the curvature
:zh: 以弧长代替速率时曲率公式不成立
:kind: counterexample
:given: a cubic in space with the coefficients $c$; $t$; the polynomial with the coefficients $l$
:data: c = (0,0,0) (3,0,0) (0,3,0) (0,0,2); t = 1; l = 0 3 0 2
:then: $s(t)=\sum_kl_kt^k$ is the length of the arc from 0 to $t$, because its derivative is $|\dot P|$; and the printed quotient is not the curvature $K$
:result: s(t) = 5; s'(t) = 9; printed quotient = 54/125; K = 2/27
:method: The squares of $s'$ and of the speed are compared at five parameters, which determine a polynomial of degree four, and $s'>0$; then both
  numbers, exactly.
:control: the speed
:::
*/
CLAIM(printed_letter_spoils_the_curvature)
{
    num c[12], l[4], D[9], turning[space];
    int is_the_length = 1;
    given_points(T, "c", 4, 3, c);
    num t = given(T, "t");
    given_points(T, "l", 4, 1, l);
    poly length = poly_from_q(4, l), growth = poly_derivative(length);
    for (int k = 0; k < 5; k++) {
        num slope = poly_value(growth, from_int(k));
        G(power_derivatives)(3, space, c, from_int(k), 2, D);
        is_the_length = is_the_length && equal_q(mul(slope, slope), G(norm_squared)(space, D + space));
    }
    is_the_length = is_the_length && sign_on(growth, from_int(0), t, CLOSED) == SIGN_POSITIVE;
    G(power_derivatives)(3, space, c, t, 2, D);
    G(cross3)(D + space, D + 2 * space, turning);
    num arc = poly_value(length, t), speed = root(2, G(norm_squared)(space, D + space));
    num curvature = root(2, G(curvature_squared)(space, D + 3, D + 6));
    /* |P' x P''| / s^3, as printed, and / s'^3 */
    num quotient = div(root(2, G(norm_squared)(space, turning)), G(power)(fault(T, speed, arc), 3));
    found(T, "s(t)", arc);
    found(T, "s'(t)", speed);
    found(T, "printed quotient", quotient);
    found(T, "K", curvature);
    about(T, "the letter being the length of the arc, whether the quotient is the curvature");
    refute(T, is_the_length && !equal_q(quotient, curvature));
}
#endif

/*
:::{statement} hu-1987:1-4-inflection
:title: An inflection is a point of curvature zero
:zh: 拐点的定义
:definition: yes
:printed: By the formula of the curvature, where $K=0$ the point is called an inflection.
:checked-by: curvature_and_torsion_belong_to_arc_length merged_inflections_are_a_cusp
:figure: forms_of_a_cubic

For plane cubics it is what the word says elsewhere, a change from one side of the tangent to the other: a double zero of
$\dot P\times\ddot P$, without such a change, occurs at cusps and on lines only.  For higher degrees it is not: $(t,t^4)$ has $K=0$ at
$t=0$ and stays on one side.
:::

:::{statement} hu-1987:1-4-inflection-parallel
:title: At an inflection the second derivative is parallel to the first
:zh: 拐点处二阶导矢平行于切矢
:printed: An inflection is a point with $\dot P\times\ddot P=0$; points with $\dot P=0$ not considered, $\ddot P=g\dot P$ with a scalar $g$.
:holds-by: second_derivative_splits_along_the_first
:needs: cusp_has_no_such_factor | $\dot P\ne0$: where $\dot P=0\ne\ddot P$ there is no $g$.
:figure: forms_of_a_cubic
:::

:::{claim} second_derivative_splits_along_the_first
:title: The second derivative is a multiple of the first plus what the vector product measures
:zh: 二阶导矢的分解
:given: any $P'\ne0$ and $P''$ in space
:then: $|P'|^2P''=(P'\cdot P'')\,P'+(P'\times P'')\times P'$; so $P'\times P''=0$ gives $P''=gP'$ with $g=\frac{P'\cdot P''}{|P'|^2}$, and conversely
  $P'\times gP'=0$
:method: Identities in the six components and $g$.
:control: $P'\times(P'\times P'')$
:::
*/
CLAIM(second_derivative_splits_along_the_first)
{
    num d1[space], d2[space], n[space], back[space], g = unknown(T, "g", 0), scaled[space];
    for (int j = 0; j < space; j++) {
        d1[j] = unknown(T, "u", j);
        d2[j] = unknown(T, "v", j);
        scaled[j] = mul(g, d1[j]);
    }
    G(cross3)(d1, d2, n);
    if (T->faulty)
        G(cross3)(d1, n, back);
    else
        G(cross3)(n, d1, back);
    for (int j = 0; j < space; j++)
        same(T, mul(G(norm_squared)(space, d1), d2[j]), add(mul(G(dot)(space, d1, d2), d1[j]), back[j]));
    G(cross3)(d1, scaled, n);
    for (int j = 0; j < space; j++)
        vanishes(T, n[j]);
}

#if RATIONAL
/*
:::{claim} cusp_has_no_such_factor
:title: At a cusp the vector product vanishes and the second derivative is no multiple of the first
:zh: 尖点处不存在标量 g
:kind: counterexample
:given: a cubic with a cusp, with the coefficients $c$, and its parameter $t$
:data: c = (0,0) (0,0) (1,0) (0,1); t = 0
:instead: c = (0,0) (1,0) (1,0) (0,1)
:then: $P'\times P''=0$, and $P''\ne gP'=0$ for every $g$
:result: P'(t), P''(t) = (0,0) (2,0)
:method: The derivatives by the kernel.
:control: a cubic with an inflection there, where $P''$ is twice $P'$
:::
*/
CLAIM(cusp_has_no_such_factor)
{
    num c[8], D[6];
    given_points(T, "c", 4, 2, c);
    G(power_derivatives)(3, dim, c, given(T, "t"), 2, D);
    found_points(T, "P'(t), P''(t)", 2, 2, D + 2);
    int parallel = is_zero_q(G(cross2)(D + 2, D + 4));
    about(T, "P' × P'' being 0, whether P' is not 0, or P'' is 0");
    refute(T, parallel && is_zero_q(G(norm_squared)(2, D + 2)) && !is_zero_q(G(norm_squared)(2, D + 4)));
}
#endif

/*
:::{statement} hu-1987:1-4-inflection-quadratic
:title: The inflections are given by a quadratic equation
:zh: 拐点满足二次方程
:printed: This is a quadratic equation of $t$, the parameter running over $[0,1]$.
:holds-by: turning_of_a_cubic_is_quadratic
:hypothesis: graph_of_a_cubic_turns_linearly | $A\times B\ne0$.  Otherwise the equation is of lower degree, as for every graph $y=f(x)$ of a
  cubic function: one inflection.
:figure: degrees_two_and_three
:::

:::{claim} turning_of_a_cubic_is_quadratic
:title: The vector product of the two derivatives of a cubic
:zh: 三次曲线的转向多项式
:given: any plane cubic, and any cubic in space, any $t$
:then: $P'\times P''=-2(3at^2+3bt+c)$, of degree 2 or less, in the plane and, with vector products $a,b,c$, in space; the kernels give
  the numbers $a,b,c$ and the three coefficients
:method: The derivatives of the definition, multiplied, against the polynomial, everything a variable; $a,b,c$ as determinants
  written out.  In space each of the three coordinates of the vector product is such a polynomial, and one of them is not 0 everywhere
  unless the cubic is a line.
:defines: cubic_minors inflection_polynomial
:control: the factor 2 in the place of the first 3
:::
*/
CLAIM(turning_of_a_cubic_is_quadratic)
{
    num c[4 * dim], D[2][dim], m[3], f[3], t = parameter(T, "t");
    G(free_points)(T, 3, dim, c);
    G(cubic_minors)(c, m);
    for (int k = 0; k < 3; k++) { /* A x B, A x C, B x C */
        int i = k < 2 ? 3 : 2, h = k == 0 ? 2 : 1;
        same(T, m[k], sub(mul(c[2 * i], c[2 * h + 1]), mul(c[2 * i + 1], c[2 * h])));
    }
    G(inflection_polynomial)(m, f);
    for (int j = 0; j < dim; j++)
        for (int r = 1; r <= 2; r++)
            D[r - 1][j] = G(power_sum_derivative)(3, dim, c, j, r, t);
    num product = sub(mul(D[0][0], D[1][1]), mul(D[0][1], D[1][0]));
    same(T, G(power_sum)(2, 1, f, 0, t), product);
    num inner = add(add(mul(mul(from_int(fault(T, 3, 2)), m[0]), mul(t, t)), mul(mul(from_int(3), m[1]), t)), m[2]);
    same(T, product, mul(from_int(-2), inner));

    num d[4 * space], first[space], second[space], turning[space], pairs[3][space];
    about(T, "in space");
    for (int k = 0; k < 4 * space; k++)
        d[k] = unknown(T, "d", k);
    for (int j = 0; j < space; j++) {
        first[j] = G(power_sum_derivative)(3, space, d, j, 1, t);
        second[j] = G(power_sum_derivative)(3, space, d, j, 2, t);
    }
    G(cross3)(first, second, turning);
    for (int k = 0; k < 3; k++)
        G(cross3)(d + (k < 2 ? 3 : 2) * space, d + (k == 0 ? 2 : 1) * space, pairs[k]);
    for (int j = 0; j < space; j++) {
        num quadratic = add(mul(from_int(3), mul(t, add(mul(t, pairs[0][j]), pairs[1][j]))), pairs[2][j]);
        same(T, turning[j], mul(from_int(-2), quadratic));
    }
}

#if RATIONAL
/* P' x P'' of a plane cubic with the coefficients c, by the kernels. */
static poly turning_of(const num c[])
{
    num m[3], f[3];
    G(cubic_minors)(c, m);
    G(inflection_polynomial)(m, f);
    return poly_from_q(3, f);
}

/*
:::{claim} graph_of_a_cubic_turns_linearly
:title: For the graph of a cubic function the equation of the inflections is linear
:zh: 三次函数图形的拐点方程是一次的
:kind: counterexample
:given: the graph of a cubic function, with the coefficients $c$
:data: c = (0,0) (1,0) (0,0) (0,1)
:instead: c = (0,0) (1,0) (1,0) (0,1)
:then: $P'\times P''$ has degree 1: one inflection, at 0, and no second root anywhere
:result: P' × P'' = "6*t"
:method: The kernels; that the coefficient of $t^2$ is not 0 is refuted.
:control: a cubic that is no graph
:::
*/
CLAIM(graph_of_a_cubic_turns_linearly)
{
    num c[8];
    given_points(T, "c", 4, 2, c);
    poly turning = turning_of(c);
    found_text(T, "P' × P''", poly_to_string(turning, "t"));
    about(T, "whether the coefficient of t² is not 0");
    refute(T, is_zero_q(poly_coefficient(turning, 2)));
}

/*
:::{statement} hu-1987:1-4-two-inflections
:title: A cubic has at most two inflections
:zh: 参数三次曲线至多有两个拐点
:printed: So a parametric cubic has at most two inflections.
:holds-by: turning_of_a_cubic_is_quadratic each_form_occurs
:hypothesis: line_has_curvature_zero_everywhere | The cubic is no line.  On a line every point has curvature 0.
:figure: forms_of_a_cubic
:::

:::{claim} line_has_curvature_zero_everywhere
:title: Along a line the vector product is zero for every parameter
:zh: 直线上曲率处处为零
:kind: counterexample
:given: a cubic on a line, with the coefficients $c$
:data: c = (0,0) (1,0) (0,0) (1,0)
:instead: c = (0,0) (1,0) (0,0) (1,1)
:then: $P'\times P''=0$ as a polynomial: more than two parameters
:result: P' × P'' = "0"
:method: The kernels; that not all three coefficients vanish is refuted.
:control: a cubic that leaves the line
:::
*/
CLAIM(line_has_curvature_zero_everywhere)
{
    num c[8];
    given_points(T, "c", 4, 2, c);
    poly turning = turning_of(c);
    found_text(T, "P' × P''", poly_to_string(turning, "t"));
    about(T, "whether P' × P'' has finitely many zeros");
    refute(T, poly_is_zero(turning));
}
#endif

/*
## Cusp and loop (尖点与闭环)

:::{statement} hu-1987:1-4-forms
:title: The forms of a cubic
:zh: 参数三次曲线的几种形态
:printed: The forms of parametric cubics contain the ordinary one, the cusp, the closed loop, and that with inflections (figure 1-7).
:holds-by: each_form_occurs sign_of_delta_tells_the_form signs_decide_the_form
:figure: forms_of_a_cubic

Which it is, is decided by $\delta=3b^2-4ac$ on the whole curve if $a=A\times B\ne0$; not so for $a=0$: `delta_does_not_tell_graphs`.  On the
arc it is decided by the lengths of the tangents, for all of them, where these point along the sides of a triangle $Q_0MQ_1$, towards $M$
and away from it, `signs_decide_the_form`, and where they are parallel, `parallel_tangents_give_an_s_or_an_arch`.  Directions in which the
one or the other points backward are not among them.
:::

:::{claim} sign_of_delta_tells_the_form
:title: A cubic with a double point, and a cubic with two inflections, have delta of different signs
:zh: 判别式区分二重点与拐点
:given: any $s$ and $u$, any vectors $L,M,N$ of the plane: $P(t)=N+(t-s)(t-u)(Lt+M)$, a cubic with $P(s)=P(u)=N$
:then: with $a=A\times B$ etc.: $\delta=-a^2(s-u)^2$, `double_point_polynomial` is $a^2(t-s)(t-u)$, `cubic_double_point` is $N$; and for
  every cubic the discriminant of $P'\times P''$ is $12\delta$, that of the double point polynomial $-a^2\delta$
:method: The coefficients of $P$ are formed from $s,u,L,M,N$, all variables; the kernels then know nothing of these.  Conversely
  division by the polynomial with the sum $-\frac ba$ and the product $\frac{b^2-ac}{a^2}$ of its roots leaves a constant for every cubic with
  $a\ne0$: that remainder is computed for free coefficients.
:defines: cubic_delta double_point_polynomial cubic_double_point
:control: $\delta=b^2-4ac$
:::
*/
CLAIM(sign_of_delta_tells_the_form)
{
    num s = unknown(T, "s", 0), u = unknown(T, "u", 0), c[4 * dim], m[3], f[3], g[3], N[dim], point[dim];
    num sum = add(s, u), product = mul(s, u);
    for (int j = 0; j < dim; j++) { /* (t^2 - sum t + product)(L t + M) + N */
        num L = unknown(T, "l", j), M = unknown(T, "m", j);
        N[j] = unknown(T, "n", j);
        c[j] = add(mul(product, M), N[j]);
        c[dim + j] = sub(mul(product, L), mul(sum, M));
        c[2 * dim + j] = sub(M, mul(sum, L));
        c[3 * dim + j] = L;
    }
    G(cubic_minors)(c, m);
    G(double_point_polynomial)(m, g);
    G(cubic_double_point)(c, m, point);
    num aa = mul(m[0], m[0]),
        delta = fault(T, G(cubic_delta)(m), sub(mul(m[1], m[1]), mul(from_int(4), mul(m[0], m[2]))));
    about(T, "delta");
    same(T, delta, neg(mul(aa, G(power)(sub(s, u), 2))));
    about(T, "the parameters of the double point");
    same(T, g[2], aa);
    same(T, g[1], neg(mul(aa, sum)));
    same(T, g[0], mul(aa, product));
    for (int j = 0; j < dim; j++)
        same(T, point[j], N[j]);

    num any[4 * dim]; /* the general cubic */
    G(free_points)(T, 3, dim, any);
    G(cubic_minors)(any, m);
    G(inflection_polynomial)(m, f);
    G(double_point_polynomial)(m, g);
    delta = G(cubic_delta)(m);
    about(T, "the discriminants");
    same(T, sub(mul(f[1], f[1]), mul(from_int(4), mul(f[0], f[2]))), mul(from_int(12), delta));
    same(T, sub(mul(g[1], g[1]), mul(from_int(4), mul(g[0], g[2]))), neg(mul(mul(m[0], m[0]), delta)));
    num p = neg(div(m[1], m[0])), q = div(g[0], mul(m[0], m[0]));
    for (int j = 0; j < dim; j++) { /* A t^3 + B t^2 + C t = (t^2 - p t + q)(A t + B + p A) + linear t + ... */
        num A = any[3 * dim + j], rest = add(any[2 * dim + j], mul(p, A));
        about(T, "the remainder is constant");
        vanishes(T, add(sub(any[dim + j], mul(q, A)), mul(p, rest)));
    }
}

#if RATIONAL
/*
:::{claim} delta_does_not_tell_graphs
:title: Delta is 0 without a cusp, and positive with one inflection, where the cubic is a graph
:zh: A×B=0 时判别式不能区分形态
:kind: decision
:given: a parabola and the graph of a cubic function, with the coefficients $P$ and $Q$, both with $a=A\times B=0$
:data: P = (0,0) (1,0) (0,1) (0,0); Q = (0,0) (1,0) (0,0) (0,1)
:instead: P = (0,0) (1,0) (0,1) (0,1)
:then: $\delta=0$ for the first, which has no cusp, because its $x'$ is 1; $\delta>0$ for the second, whose $P'\times P''$ has one zero
:result: a, b, c of P = 0 0 -1; δ of P = 0; zeros of P' × P'' = 0; a, b, c of Q = 0 -1 0; δ of Q = 3; zeros of Q' × Q'' = 1
:method: The kernels for cubics; zeros by root counts from $-1$ to 1, outside of which a polynomial of degree 1 without constant has none.
:control: a cubic in the place of the parabola
:::
*/
/* a, b, c and delta of the cubic, and the zeros of its turning in (-1,1), under their names: those of P or of Q. */
static num signs_of_graph(trial *T, int second, const num c[], int *zeros)
{
    num m[3];
    G(cubic_minors)(c, m);
    num delta = G(cubic_delta)(m);
    *zeros = count_roots(turning_of(c), from_int(-1), from_int(1), OPEN).distinct;
    found_points(T, second ? "a, b, c of Q" : "a, b, c of P", 3, 1, m);
    found(T, second ? "δ of Q" : "δ of P", delta);
    found_whole(T, second ? "zeros of Q' × Q''" : "zeros of P' × P''", *zeros);
    vanishes(T, m[0]);
    return delta;
}

CLAIM(delta_does_not_tell_graphs)
{
    num P[8], Q[8];
    int zeros;
    given_points(T, "P", 4, 2, P);
    given_points(T, "Q", 4, 2, Q);
    vanishes(T, signs_of_graph(T, 0, P, &zeros));
    agree(T, zeros == 0 && equal_q(P[2], from_int(1)) && is_zero_q(P[4]) && is_zero_q(P[6])); /* x' = 1 */
    agree(T, sign_q(signs_of_graph(T, 1, Q, &zeros)) > 0);
    agree(T, zeros == 1);
}
#endif

/*
:::{claim} merged_inflections_are_a_cusp
:title: The two inflections meet at a cusp and nowhere else
:zh: 两拐点重合处为尖点
:given: any plane cubic with $a\ne0$, $t_0=-\frac b{2a}$
:then: $A\times P'(t_0)=0$ and $4a\,B\times P'(t_0)=-\delta$; since $A$ and $B$ are independent, $P'(t_0)=0$ exactly for $\delta=0$; and a cubic with
  $P'(t_1)=0$ somewhere has $\delta=0$
:method: The derivative at $t_0$ by the kernel, everything a variable; for the converse $C=-3At_1^2-2Bt_1$.
:control: $t_0=-\frac ba$
:::
*/
CLAIM(merged_inflections_are_a_cusp)
{
    num c[4 * dim], m[3], D[2 * dim], t1 = unknown(T, "t", 1);
    G(free_points)(T, 3, dim, c);
    G(cubic_minors)(c, m);
    num at = neg(div(m[1], fault(T, mul(from_int(2), m[0]), m[0])));
    G(power_derivatives)(3, dim, c, at, 1, D);
    vanishes(T, G(cross2)(c + 3 * dim, D + dim));
    same(T, mul(mul(from_int(4), m[0]), G(cross2)(c + 2 * dim, D + dim)), neg(G(cubic_delta)(m)));
    for (int j = 0; j < dim; j++) {
        num square = mul(mul(from_int(3), c[3 * dim + j]), mul(t1, t1));
        c[dim + j] = neg(add(square, mul(mul(from_int(2), c[2 * dim + j]), t1)));
    }
    G(cubic_minors)(c, m);
    about(T, "delta of a cubic with a vanishing derivative");
    vanishes(T, G(cubic_delta)(m));
}

/* The cubic of the triangle Q_0, M, Q_1 with the lengths alpha and beta. */
static void G(cubic_of_triangle)(const num R[], num alpha, num beta, num c[])
{
    num Q[2 * dim], V[2 * dim], two = from_int(2);
    for (int j = 0; j < dim; j++) {
        Q[j] = R[j];
        Q[dim + j] = R[2 * dim + j];
        V[j] = mul(mul(two, alpha), sub(R[dim + j], R[j]));
        V[dim + j] = mul(mul(two, beta), sub(R[2 * dim + j], R[dim + j]));
    }
    G(cubic_of_ends)(dim, Q, V, c);
}

/*
:::{claim} cusps_are_on_a_hyperbola
:title: In the plane of the lengths the cusps are a hyperbola
:zh: 切矢长度平面上的尖点双曲线
:given: a triangle $Q_0MQ_1$; tangents $\dot Q_0=2\alpha(M-Q_0)$, $\dot Q_1=2\beta(Q_1-M)$, any $\alpha,\beta$
:then: $\delta=-4\alpha\beta\,w^2\bigl((\alpha-2)(\beta-2)-1\bigr)$ with $w=2(Q_1-Q_0)\times(M-Q_0)$; the turning at the ends is
  $P'\times P''(0)=-2\alpha(3-2\beta)\,w$ and $P'\times P''(1)=-2\beta(3-2\alpha)\,w$
:method: The cubic of the ends, the kernels, everything a variable.  For $\alpha=\beta=1$ the curve is a parabola.
:control: $(\alpha-2)(\beta-2)-2$
:::
*/
CLAIM(cusps_are_on_a_hyperbola)
{
    num R[3 * dim], c[4 * dim], m[3], f[3], alpha = parameter(T, "alpha"), beta = parameter(T, "beta"),
                                            two = from_int(2);
    num chord[dim], side[dim];
    G(free_points)(T, 2, dim, R);
    G(cubic_of_triangle)(R, alpha, beta, c);
    G(cubic_minors)(c, m);
    G(inflection_polynomial)(m, f);
    for (int j = 0; j < dim; j++) {
        chord[j] = sub(R[2 * dim + j], R[j]);
        side[j] = sub(R[dim + j], R[j]);
    }
    num w = mul(two, G(cross2)(chord, side));
    num branch = sub(mul(sub(alpha, two), sub(beta, two)), from_int(fault(T, 1, 2)));
    same(T, G(cubic_delta)(m), mul(from_int(-4), mul(mul(alpha, beta), mul(mul(w, w), branch))));
    about(T, "the turning at the ends");
    num three = from_int(3), minus_w = mul(from_int(-2), w);
    same(T, f[0], mul(minus_w, mul(alpha, sub(three, mul(two, beta)))));
    same(T, add(f[0], add(f[1], f[2])), mul(minus_w, mul(beta, sub(three, mul(two, alpha)))));
}

#if RATIONAL
/* The cubic of the triangle R with the lengths alpha and beta: its inflections, and the parameters of its double point, in
 * (0,1), and its delta. */
static void events_of(const num R[], num alpha, num beta, int *inflections, int *doubles, num *delta)
{
    num c[8], m[3], g[3], zero = from_int(0), one = from_int(1);
    G(cubic_of_triangle)(R, alpha, beta, c);
    G(cubic_minors)(c, m);
    G(double_point_polynomial)(m, g);
    *inflections = count_roots(turning_of(c), zero, one, OPEN).distinct;
    *doubles = count_roots(poly_from_q(3, g), zero, one, OPEN).distinct;
    *delta = G(cubic_delta)(m);
}

/*
:::{claim} each_form_occurs
:title: With the same ends and directions all forms occur
:zh: 端点与切向相同而形态各异
:kind: decision
:given: the triangle $R$; five pairs $(\alpha,\beta)$ of lengths; for each the inflections, the parameters of the double point in $(0,1)$ and the sign of $\delta$
  that are wanted
:data: R = (0,0) (1,2) (3,0); (α,β) = (1/2,1/2) (1,3) (2,2) (3,3) (4,4); forms = (0,0,-1) (1,0,1) (2,0,1) (1,1,0) (0,2,-1)
:instead: (α,β) = (1,3) (1,3) (2,2) (3,3) (4,4)
:then: on the open arc no, one and two inflections; a cusp, where $P'=0$; a loop, whose double point has two parameters in $(0,1)$
:method: Root counts of $P'\times P''$ and of the double point polynomial, and the sign of $\delta$, all exact.
:control: the second pair twice
:::
*/
CLAIM(each_form_occurs)
{
    enum { FORMS = 5 };
    num R[6], lengths[2 * FORMS], wanted[3 * FORMS];
    given_points(T, "R", 3, 2, R);
    given_points(T, "(α,β)", FORMS, 2, lengths);
    given_points(T, "forms", FORMS, 3, wanted);
    for (int k = 0; k < FORMS; k++) {
        int inflections, doubles;
        num delta;
        events_of(R, lengths[2 * k], lengths[2 * k + 1], &inflections, &doubles, &delta);
        int as_wanted = equal_q(from_int(inflections), wanted[3 * k]) && equal_q(from_int(doubles), wanted[3 * k + 1]);
        agree(T, as_wanted && equal_q(from_int(sign_q(delta)), wanted[3 * k + 2]));
    }
}
#endif

/*
:::{claim} signs_decide_the_form
:title: The lengths of the tangents decide the form of the arc
:zh: 切矢长度完全决定曲线段的形态
:given: a triangle $Q_0MQ_1$; tangents $\dot Q_0=2\alpha(M-Q_0)$, $\dot Q_1=2\beta(Q_1-M)$, any $\alpha,\beta$; $w=2(Q_1-Q_0)\times(M-Q_0)$
:then: $P'\times P''$ has the Bernstein coefficients $f_0=2\alpha(2\beta-3)w$, $f_1=-2\alpha\beta w$, $f_2=2\beta(2\alpha-3)w$, and
  $f_1^2-f_0f_2=-12\alpha\beta w^2((\alpha-2)(\beta-2)-1)$; the polynomial of the double point has
  $g_0=\alpha(\alpha+2\beta^2-3\beta)w^2$, $g_1=-\alpha\beta(2\alpha\beta-3\alpha-3\beta+4)w^2$, $g_2=\beta(\beta+2\alpha^2-3\alpha)w^2$; for $\alpha=2+p$, $\beta=2+q$,
  $p,q>0$: $g_0,-g_1,g_2>0$; and $\alpha(3-2\alpha)^2-(4-3\alpha)=4(\alpha-1)^3$
:method: Identities, and signs of coefficients.  Let $\alpha,\beta>0$, $w>0$; then $f_1<0$.  Both below $\frac32$: $f_0,f_2<0$, no inflection.  One
  below and one above: one change of sign, one inflection.  Both above: two changes, so two inflections, one double one at a cusp, or none,
  as $(\alpha-2)(\beta-2)$ is less than 1, is 1, or is more, which needs $\alpha,\beta>2$; then the double point has two parameters in $(0,1)$: a loop.
  There is no other loop: it needs $(\alpha-2)(\beta-2)>1$, that is both more than 2, or both less than $\frac32$; in the second case let
  $\alpha\ge\beta$: it needs $g_2>0$, $\beta>\alpha(3-2\alpha)$, so $\alpha>1$, and $g_1<0$, $\beta(3-2\alpha)<4-3\alpha$, which contradict each other
  by the last identity.
:control: $3-\alpha$ in the place of $3-2\alpha$ in $f_2$ and in the last identity
:::
*/
CLAIM(signs_decide_the_form)
{
    num R[3 * dim], c[4 * dim], m[3], f[3], g[3], chord[dim], side[dim], one = from_int(1), two = from_int(2),
                                                                         three = from_int(3), four = from_int(4);
    G(free_points)(T, 2, dim, R);
    for (int j = 0; j < dim; j++) {
        chord[j] = sub(R[2 * dim + j], R[j]);
        side[j] = sub(R[dim + j], R[j]);
    }
    num w = mul(two, G(cross2)(chord, side)), ww = mul(w, w), alpha = parameter(T, "alpha"),
        beta = parameter(T, "beta");
    num twice = fault(T, mul(two, alpha), alpha), product = mul(alpha, beta);
    G(cubic_of_triangle)(R, alpha, beta, c);
    G(cubic_minors)(c, m);
    G(inflection_polynomial)(m, f);
    G(double_point_polynomial)(m, g);
    num half = from_ratio(1, 2), b[3] = {f[0], add(f[0], mul(half, f[1])), add(f[0], add(f[1], f[2]))};
    num wanted[3] = {mul(mul(two, alpha), sub(mul(two, beta), three)), mul(from_int(-2), product),
                     mul(mul(two, beta), sub(twice, three))};
    about(T, "the turning");
    for (int k = 0; k < 3; k++)
        same(T, b[k], mul(wanted[k], w));
    num branch = sub(mul(sub(alpha, two), sub(beta, two)), one);
    same(T, sub(mul(b[1], b[1]), mul(b[0], b[2])), mul(from_int(-12), mul(mul(product, ww), branch)));

    num e[3] = {g[0], add(g[0], mul(half, g[1])), add(g[0], add(g[1], g[2]))};
    about(T, "the double point");
    num p = positive(T, "p", 0), q = positive(T, "q", 0);
    for (int at_the_loop = 0; at_the_loop < 2; at_the_loop++) {
        num x = at_the_loop ? add(two, p) : alpha, y = at_the_loop ? add(two, q) : beta;
        num outer[2] = {mul(x, add(x, mul(y, sub(mul(two, y), three)))),
                        mul(y, add(y, mul(x, sub(mul(two, x), three))))};
        num middle = mul(mul(x, y), add(sub(mul(two, mul(x, y)), mul(three, add(x, y))), four));
        if (at_the_loop) {
            nonnegative(T, outer[0]);
            nonnegative(T, middle);
            nonnegative(T, outer[1]);
        } else {
            same(T, e[0], mul(outer[0], ww));
            same(T, e[1], neg(mul(middle, ww)));
            same(T, e[2], mul(outer[1], ww));
        }
    }
    num gap = sub(three, twice), rest = sub(four, mul(three, alpha));
    about(T, "the contradiction");
    same(T, sub(mul(alpha, mul(gap, gap)), rest), mul(four, G(power)(sub(alpha, one), 3)));
}

/*
:::{claim} parallel_tangents_give_an_s_or_an_arch
:title: With parallel tangents the arc has one inflection or none, and no loop
:zh: 端切矢平行时曲线段的形态
:given: any $Q_0$, $Q_1$ and $e$ in the plane, $w=(Q_1-Q_0)\times e$; $\dot Q_0=\lambda e$, and $\dot Q_1=\mu e$ or $-\mu e$; any $\lambda,\mu>0$
:then: in one sense: $\delta=12\lambda\mu w^2$, $P'\times P''$ is $-6\lambda w$ at 0 and $6\mu w$ at 1; in opposite senses: it has the Bernstein coefficients
  $-6\lambda w,0,-6\mu w$, and the polynomial of the double point is $\lambda(\lambda-3\mu)w^2$ at 0 and $\mu(\mu-3\lambda)w^2$ at 1
:method: The kernels, everything a variable.  Let $w\ne0$.  In one sense a quadratic changes its sign: one inflection, and no double point, as
  $\delta>0$ or, for $\lambda=\mu$, $a=0$ and the polynomial is the constant $b^2\ne0$.  In opposite senses there is no zero on the arc, so neither
  inflection nor cusp, and no loop: for that neither value may be negative, $\lambda\ge3\mu$ and $\mu\ge3\lambda$.
:control: $\lambda-2\mu$ in the place of $\lambda-3\mu$
:::
*/
CLAIM(parallel_tangents_give_an_s_or_an_arch)
{
    num lambda = positive(T, "l", 0), mu = positive(T, "m", 0), Q[4], e[2], V[4], c[8], m[3], f[3], g[3];
    for (int k = 0; k < 4; k++)
        Q[k] = unknown(T, "q", k);
    for (int j = 0; j < dim; j++) {
        e[j] = unknown(T, "e", j);
        V[j] = mul(lambda, e[j]);
    }
    num chord[2] = {sub(Q[2], Q[0]), sub(Q[3], Q[1])}, w = G(cross2)(chord, e), ww = mul(w, w);
    for (int opposite = 0; opposite < 2; opposite++) {
        num last = opposite ? neg(mu) : mu;
        for (int j = 0; j < dim; j++)
            V[dim + j] = mul(last, e[j]);
        G(cubic_of_ends)(dim, Q, V, c);
        G(cubic_minors)(c, m);
        G(inflection_polynomial)(m, f);
        G(double_point_polynomial)(m, g);
        about(T, "the turning");
        same(T, f[0], mul(from_int(-6), mul(lambda, w)));
        same(T, add(f[0], add(f[1], f[2])), mul(from_int(6), mul(last, w)));
        if (!opposite) {
            same(T, G(cubic_delta)(m), mul(from_int(12), mul(mul(lambda, mu), ww)));
            continue;
        }
        vanishes(T, add(f[0], mul(from_ratio(1, 2), f[1])));
        about(T, "the double point");
        num first = sub(lambda, mul(from_int(fault(T, 3, 2)), mu)), second = sub(mu, mul(from_int(3), lambda));
        same(T, g[0], mul(mul(lambda, first), ww));
        same(T, add(g[0], add(g[1], g[2])), mul(mul(mu, second), ww));
    }
}

#if RATIONAL
/*
:::{claim} forms_by_the_lengths_of_the_tangents
:title: What an arc does, by the lengths of its tangents
:zh: 由切矢长度判定曲线形态
:types: rational
:given: the triangle $R$; $\alpha,\beta$ random in the parts of the quadrant $\alpha,\beta>0$; a border $b$; a number $N$
:data: R = (0,0) (1,2) (3,0); b = 3/2; N = 20
:instead: b = 1
:then: both below $b$: no inflection; one above, one below: one; both above, and $(\alpha-2)(\beta-2)<1$ or one of them below 2: two;
  both above 2 and $(\alpha-2)(\beta-2)>1$: none, and a loop; on the hyperbola: a cusp
:method: Inflections and the parameters of the double point in $(0,1)$ as root counts, for $N$ points of each of the parts in every
  case, and $N$ cusps; the borders between the parts are those of `cusps_are_on_a_hyperbola`.
:control: another border
:::
*/
CLAIM(forms_by_the_lengths_of_the_tangents)
{
    num R[6], two = from_int(2), one = from_int(1);
    given_points(T, "R", 3, 2, R);
    num border = given(T, "b");
    int points = given_whole(T, "N");
    for (int k = 0; k < points; k++) {
        num low[2], high[2], delta;
        int inflections, doubles;
        for (int j = 0; j < 2; j++) {
            low[j] = mul(border, parameter(T, "l"));
            high[j] = add(border, positive(T, "h", j));
        }
        events_of(R, low[0], low[1], &inflections, &doubles, &delta);
        agree(T, inflections == 0 && doubles < 2);
        events_of(R, low[0], high[1], &inflections, &doubles, &delta);
        agree(T, inflections == 1 && doubles < 2);
        events_of(R, high[0], low[1], &inflections, &doubles, &delta);
        agree(T, inflections == 1 && doubles < 2);
        num branch = sub(mul(sub(high[0], two), sub(high[1], two)), one);
        int loop = sign_q(branch) > 0 && compare_q(high[0], two) > 0;
        events_of(R, high[0], high[1], &inflections, &doubles, &delta);
        agree(T, loop ? inflections == 0 && doubles == 2 : inflections == 2 && doubles < 2);
        num beyond = add(two, positive(T, "b", 0)), cusp = add(two, div(one, sub(beyond, two)));
        events_of(R, beyond, cusp, &inflections, &doubles, &delta);
        agree(T, is_zero_q(delta) && inflections == 1 && doubles == 1);
        num more = add(cusp, positive(T, "c", 0));
        events_of(R, beyond, more, &inflections, &doubles, &delta);
        agree(T, sign_q(delta) < 0 && inflections == 0 && doubles == 2);
    }
}
#endif

/*
## Torsion (挠率)

:::{statement} hu-1987:1-4-torsion-vectors
:title: The three vectors in the formula of the torsion
:zh: 挠率公式中的三个矢量
:printed: \tau=\frac{[\dot P\,\ddot P\,\ddot P]}{s^3K^2}
:refuted-by: printed_vectors_have_no_torsion
:class: misprint
:corrected: \tau=\frac{[\dot P\,\ddot P\,\dddot P]}{\dot s^6K^2}
:corrected-by: torsion_by_speed_and_curvature curvature_and_torsion_belong_to_arc_length
:figure: derivatives_with_lost_dots

A mixed product with one vector twice is 0, whatever is meant by the letter $s$, which has lost its dot as in the formula of the
curvature.
:::

:::{claim} torsion_by_speed_and_curvature
:title: The torsion by speed and curvature
:zh: 用速率与曲率表示挠率
:given: any three vectors $P',P'',P'''$ of space, $P'\times P''\ne0$
:then: $\frac{(P',P'',P''')}{\dot s^6K^2}=\frac{(P',P'',P''')}{|P'\times P''|^2}$, the torsion, with $\dot s^2=|P'|^2$ and $K^2=\frac{|P'\times P''|^2}{|P'|^6}$
:method: The kernels for the square of the curvature and for the torsion, everything a variable.
:control: $\dot s^4$
:::
*/
CLAIM(torsion_by_speed_and_curvature)
{
    num d[3][space];
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < space; j++)
            d[k][j] = unknown(T, k == 0 ? "u" : k == 1 ? "v" : "w", j);
    num speed = G(norm_squared)(space, d[0]),
        below = mul(G(power)(speed, fault(T, 3, 2)), G(curvature_squared)(space, d[0], d[1]));
    same(T, div(G(det3)(d[0], d[1], d[2]), below), G(torsion)(d[0], d[1], d[2]));
}

/* The determinant of three rows, by the rule of Sarrus. */
static num G(sarrus)(const num r0[], const num r1[], const num r2[])
{
    num sum = from_int(0);
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        sum = add(sum, sub(mul(r0[k], mul(r1[i], r2[j])), mul(r0[k], mul(r1[j], r2[i]))));
    }
    return sum;
}

#if RATIONAL
/*
:::{claim} printed_vectors_have_no_torsion
:title: With the second derivative twice every torsion is zero
:zh: 重复二阶导矢时挠率恒为零
:kind: counterexample
:given: a cubic in space with the coefficients $c$, and $t$
:data: c = (0,0,0) (1,0,0) (0,1,0) (0,0,1); t = 0
:then: $[P'\,P''\,P'']$ is 0, the torsion is not
:result: P', P'', P''' = (1,0,0) (0,2,0) (0,0,6); printed quotient = 0; τ = 3
:method: The derivatives by the kernel; at $t$ the speed is 1, so that its power does not matter.
:control: $P'''$ in the last place
:::
*/
CLAIM(printed_vectors_have_no_torsion)
{
    num c[12], D[12];
    given_points(T, "c", 4, 3, c);
    G(power_derivatives)(3, space, c, given(T, "t"), 3, D);
    const num *last = D + fault(T, 3, 2) * space;
    /* [P' P'' P''] / K^2, the speed being 1 */
    num quotient = div(G(sarrus)(D + 3, D + 6, last), G(curvature_squared)(space, D + 3, D + 6));
    num torsion = G(torsion)(D + 3, D + 6, D + 9);
    found_points(T, "P', P'', P'''", 3, 3, D + 3);
    found(T, "printed quotient", quotient);
    found(T, "τ", torsion);
    about(T, "the quotient, and the torsion");
    same(T, quotient, torsion);
}

/*
:::{statement} hu-1987:1-4-torsion-power
:title: The power of the speed in the formula of the torsion
:zh: 挠率公式中弧长导数的幂次
:printed: \tau=\frac{[\dot P\,\ddot P\,\dddot P]}{\dot s^3K^2}\quad\text{(the lost dots restored)}
:refuted-by: printed_power_spoils_the_torsion
:class: misprint
:corrected: \tau=\frac{[\dot P\,\ddot P\,\dddot P]}{\dot s^6K^2}
:corrected-by: torsion_by_speed_and_curvature curvature_and_torsion_belong_to_arc_length
:figure: torsion_and_the_speed
:::

:::{claim} printed_power_spoils_the_torsion
:title: With the third power of the speed the torsion is wrong where the speed is not one
:zh: 速率三次幂给出错误的挠率
:kind: counterexample
:given: a cubic in space with the coefficients $c$, and $t$
:data: c = (0,0,0) (3,0,0) (0,3,0) (0,0,2); t = 1
:then: the speed $\dot s$ is not 1, and the printed quotient is not the torsion
:result: s'(t) = 9; K² = 4/729; printed quotient = 54; τ = 2/27
:method: Both quotients, exactly.
:control: $\dot s^6$
:::
*/
CLAIM(printed_power_spoils_the_torsion)
{
    num c[12], D[12];
    given_points(T, "c", 4, 3, c);
    G(power_derivatives)(3, space, c, given(T, "t"), 3, D);
    num speed = root(2, G(norm_squared)(space, D + 3)), square = G(curvature_squared)(space, D + 3, D + 6);
    num below = mul(G(power)(speed, fault(T, 6, 3)), square);
    num quotient = div(G(sarrus)(D + 3, D + 6, D + 9), below), torsion = G(torsion)(D + 3, D + 6, D + 9);
    found(T, "s'(t)", speed);
    found(T, "K²", square);
    found(T, "printed quotient", quotient);
    found(T, "τ", torsion);
    about(T, "the quotient, and the torsion");
    same(T, quotient, torsion);
}
#endif

/*
:::{statement} hu-1987:1-4-torsion-first-determinant
:title: The determinant of the derivatives
:zh: 导矢的行列式
:printed: $(\dot P\times\ddot P)\cdot\ddot P=\begin{vmatrix}\dot x&\dot y&\dot z\\\ddot x&\ddot y&\ddot z\\\ddot x&\ddot y&\ddot z\end{vmatrix}=-12\begin{vmatrix}A_x&A_y&A_z\\B_x&B_y&B_z\\C_x&C_y&C_z\end{vmatrix}$
:refuted-by: determinant_with_equal_rows_is_zero
:class: misprint
:corrected: $(\dot P\times\ddot P)\cdot\dddot P=-12\,(A,B,C)$, with $\dddot x,\dddot y,\dddot z$ in the last row
:corrected-by: determinant_of_the_derivatives_is_constant
:figure: determinants_of_the_derivatives
:::
*/

/* The rows of the determinant in coefficients, the last entry of the first row with `power` of t. */
static void G(rows_in_coefficients)(const num c[], num t, int power_of_last, num rows[3][3])
{
    for (int j = 0; j < space; j++) {
        num C = c[space + j], B = c[2 * space + j], A = c[3 * space + j];
        num tt = G(power)(t, j == 2 ? power_of_last : 2), six_A = mul(from_int(6), A), two_B = mul(from_int(2), B);
        rows[0][j] = add(add(mul(mul(from_int(3), A), tt), mul(two_B, t)), C);
        rows[1][j] = add(mul(six_A, t), two_B);
        rows[2][j] = six_A;
    }
}

/*
:::{claim} determinant_of_the_derivatives_is_constant
:title: The determinant of the three derivatives does not depend on the parameter
:zh: 三阶导矢行列式为常数
:given: any cubic in space, any $t$
:then: $(P',P'',P''')=-12\,(A,B,C)$, also with the rows written out in coefficients
:method: The derivatives by the kernel, the mixed products as determinants of 9 entries, everything a variable.
:control: $12\,(A,B,C)$
:::
*/
CLAIM(determinant_of_the_derivatives_is_constant)
{
    num c[4 * space], D[4 * space], rows[3][3], t = parameter(T, "t");
    G(free_points)(T, 3, space, c);
    G(power_derivatives)(3, space, c, t, 3, D);
    G(rows_in_coefficients)(c, t, 2, rows);
    num value = mul(from_int(fault(T, -12, 12)), G(sarrus)(c + 3 * space, c + 2 * space, c + space));
    same(T, G(det3)(D + space, D + 2 * space, D + 3 * space), value);
    same(T, G(sarrus)(rows[0], rows[1], rows[2]), value);
}

#if RATIONAL
/*
:::{claim} determinant_with_equal_rows_is_zero
:title: The printed determinant has two equal rows
:zh: 两行相同的行列式为零
:kind: counterexample
:given: a cubic in space with the coefficients $c$, from $D$ to $A$, and $t$
:data: c = (0,0,0) (1,0,0) (0,1,0) (0,0,1); t = 0
:then: the printed determinant is 0, and the right side that is printed for it is not
:result: (A,B,C) = -1; printed determinant = 0; -12 (A,B,C) = 12
:method: Both sides, exactly.
:control: the third derivatives in the last row
:::
*/
CLAIM(determinant_with_equal_rows_is_zero)
{
    num c[12], D[12];
    given_points(T, "c", 4, 3, c);
    G(power_derivatives)(3, space, c, given(T, "t"), 3, D);
    num volume = G(sarrus)(c + 9, c + 6, c + 3), right = mul(from_int(-12), volume);
    num printed = G(sarrus)(D + 3, D + 6, D + fault(T, 9, 6));
    found(T, "(A,B,C)", volume);
    found(T, "printed determinant", printed);
    found(T, "-12 (A,B,C)", right);
    about(T, "the determinant, and -12 (A,B,C)");
    same(T, printed, right);
}

/*
:::{statement} hu-1987:1-4-torsion-entry
:title: The determinant with the coefficients inserted
:zh: 代入系数的行列式
:printed: \begin{vmatrix}3A_xt^2+2B_xt+C_x&3A_yt^2+2B_yt+C_y&3A_zt+2B_zt+C_z\\6A_xt+2B_x&6A_yt+2B_y&6A_zt+2B_z\\6A_x&6A_y&6A_z\end{vmatrix}=-12\,(A,B,C)
:refuted-by: printed_entry_spoils_the_determinant
:class: misprint
:corrected: The last entry of the first row is $3A_zt^2+2B_zt+C_z$.
:corrected-by: determinant_of_the_derivatives_is_constant
:figure: determinants_of_the_derivatives
:::

:::{claim} printed_entry_spoils_the_determinant
:title: With the printed entry the determinant depends on the parameter
:zh: 印刷的元素使行列式出错
:kind: counterexample
:given: a cubic in space with the coefficients $c$, from $D$ to $A$, and $t$
:data: c = (0,0,0) (0,0,1) (0,1,0) (1,0,1); t = 2
:then: the determinant with the printed rows is not the right side
:result: rows = (12,4,7) (12,2,12) (6,0,6); printed determinant = 60; -12 (A,B,C) = -12
:method: The determinant as printed, exactly.
:control: the entry with $t^2$
:::
*/
CLAIM(printed_entry_spoils_the_determinant)
{
    num c[12], rows[3][3];
    given_points(T, "c", 4, 3, c);
    G(rows_in_coefficients)(c, given(T, "t"), fault(T, 2, 1), rows);
    num printed = G(sarrus)(rows[0], rows[1], rows[2]);
    num right = mul(from_int(-12), G(sarrus)(c + 9, c + 6, c + 3));
    found_points(T, "rows", 3, 3, rows[0]);
    found(T, "printed determinant", printed);
    found(T, "-12 (A,B,C)", right);
    about(T, "the determinant, and -12 (A,B,C)");
    same(T, printed, right);
}
#endif

/*
:::{statement} hu-1987:1-4-torsion-value
:title: The value of the determinant
:zh: 行列式的值
:printed: The determinant of $\dot P$, $\ddot P$ and the third derivative is $-12\begin{vmatrix}A_x&A_y&A_z\\B_x&B_y&B_z\\C_x&C_y&C_z\end{vmatrix}$.
:holds-by: determinant_of_the_derivatives_is_constant
:figure: determinants_of_the_derivatives
:::

:::{statement} hu-1987:1-4-plane
:title: When the determinant is zero the cubic is plane
:zh: 行列式为零则为平面曲线
:printed: If this is zero, the parametric cubic is a plane curve.
:holds-by: cubic_is_plane_when_determinant_vanishes
:figure: plane_cubics
:::

:::{claim} cubic_is_plane_when_determinant_vanishes
:title: The cubic is plane exactly when the determinant of its coefficients is zero
:zh: 平面曲线的充要条件
:given: any cubic in space, any $t$
:then: $(A\times B)\cdot(P-D)=t\,(A,B,C)$, $(C\times A)\cdot(P-D)=t^2(A,B,C)$, $(B\times C)\cdot(P-D)=t^3(A,B,C)$
:method: Identities with everything a variable.  If the determinant is 0, each of the three products that is not 0 is the normal of
  a plane that holds the curve; if all are 0 the curve is a line.  Conversely a curve in a plane has its differences, so
  $A,B,C$, in one plane, and the determinant is 0.
:control: the last normal with the factor $t^2$
:::
*/
CLAIM(cubic_is_plane_when_determinant_vanishes)
{
    num c[4 * space], P[space], gone[space], normal[space], t = parameter(T, "t");
    G(free_points)(T, 3, space, c);
    G(power_point)(3, space, c, t, P);
    for (int j = 0; j < space; j++)
        gone[j] = sub(P[j], c[j]);
    const num *A = c + 3 * space, *B = c + 2 * space, *C = c + space, *pairs[3][2] = {{A, B}, {C, A}, {B, C}};
    num det = G(sarrus)(A, B, C);
    for (int k = 0; k < 3; k++) {
        G(cross3)(pairs[k][0], pairs[k][1], normal);
        same(T, G(dot)(space, normal, gone), mul(G(power)(t, fault(T, k + 1, k == 2 ? 2 : k + 1)), det));
    }
}

#include "chapters/judge/claims_off.h"
