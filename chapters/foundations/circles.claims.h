/*
# Three ways to turn a point (圆的生成)

To draw a circle by a machine that adds and shifts, one turns a point by a small angle again and again.  A step is a
matrix, $[x_{n+1}\;y_{n+1}]=[x_n\;y_n]\,T$, and everything that can be said about the drawing is said by the matrix.  Its
determinant tells whether the points drift outwards, an invariant quadratic form on which curve they stay, and whether its
eigenvalues are roots of unity (单位根) tells whether they ever come back.
*/
#include "chapters/foundations/definition.h"

#include "chapters/judge/claims_on.h"

/*
## The first way

:::{statement} hu-1987:1-3-1
:title: One step of a rotation
:zh: 逆时针旋转一步
:printed: $x_{n+1}=r\cos(\theta+\Delta\theta)=x_n\cos\Delta\theta-y_n\sin\Delta\theta$,
  $y_{n+1}=r\sin(\theta+\Delta\theta)=y_n\cos\Delta\theta+x_n\sin\Delta\theta$
:holds-by: rotation_matrix_adds_the_angle
:figure: three_generators
:::

:::{statement} hu-1987:1-3-2
:title: The matrix of the rotation
:zh: 旋转矩阵
:printed: [x_{n+1}\;y_{n+1}]=[x_n\;y_n]\begin{bmatrix}\cos\Delta\theta&\sin\Delta\theta\\-\sin\Delta\theta&\cos\Delta\theta\end{bmatrix}
:holds-by: rotation_matrix_adds_the_angle
:figure: three_generators
:::
*/

/* out = [x y] M, the row times the matrix M = (M_0 M_1; M_2 M_3) */
static void G(row_times)(const num v[restrict], const num M[restrict], num out[restrict])
{
    for (int j = 0; j < 2; j++)
        out[j] = add(mul(v[0], M[j]), mul(v[1], M[2 + j]));
}

/* (1-3-2) for an angle with these cosine and sine */
static void G(rotation)(struct G(turn) angle, num M[])
{
    M[0] = M[3] = angle.cos;
    M[1] = angle.sin;
    M[2] = neg(angle.sin);
}

/* The half of the sum of two angles, by the tangents of their halves. */
static num G(half_of_sum)(num a, num b) { return div(add(a, b), sub(from_int(1), mul(a, b))); }

/*
:::{claim} rotation_matrix_adds_the_angle
:title: The row of the point times the matrix is the point of the sum of the angles
:zh: 旋转矩阵使角度相加
:given: any $r$, and two angles with the tangents $a$ and $b$ of their halves, $ab\ne1$
:then: $r(\cos\theta,\sin\theta)$ times the printed matrix of $\Delta\theta$ is $r(\cos(\theta+\Delta\theta),\sin(\theta+\Delta\theta))$
:method: The sum of the angles is formed on the other side, from the tangent $\frac{a+b}{1-ab}$ of half of it; $a$, $b$ and $r$
  are variables.
:control: the angle with the tangent $\frac{a-b}{1+ab}$
:::
*/
CLAIM(rotation_matrix_adds_the_angle)
{
    num a = parameter(T, "a"), b = parameter(T, "b"), r = positive(T, "r", 0), M[4], next[2];
    struct G(turn) theta = G(turn_by)(a), sum = G(turn_by)(G(half_of_sum)(a, fault(T, b, neg(b))));
    num P[2] = {mul(r, theta.cos), mul(r, theta.sin)};
    G(rotation)(G(turn_by)(b), M);
    G(row_times)(P, M, next);
    same(T, next[0], mul(r, sum.cos));
    same(T, next[1], mul(r, sum.sin));
}

/*
:::{statement} hu-1987:1-3-equal-angles
:title: The first way computes points at equal angles on the circle
:zh: 圆周上等角度分布的点
:printed: By this method a sequence of points on the circle can be computed that are distributed at equal angles.
:holds-by: rotated_points_are_equally_spaced
:figure: three_generators
:::
*/

/* v becomes v M^n. */
static void G(steps)(int n, const num M[], num v[])
{
    num next[2];
    for (int k = 0; k < n; k++) {
        G(row_times)(v, M, next);
        v[0] = next[0], v[1] = next[1];
    }
}

/*
:::{claim} rotated_points_are_equally_spaced
:title: All points are on the circle, at equal distances
:zh: 点列在圆上且间距相等
:given: any first point, any angle with the tangent $a$ of its half, $n$ steps
:then: $x_n^2+y_n^2=x_0^2+y_0^2$ and $|P_n-P_{n-1}|^2=2(1-\cos\Delta\theta)\,|P_0|^2$
:method: The steps one after the other, first point and $a$ variables.  The step is linear, so its $n$-th power is found
  by doing it.
:degrees: 1..8 sampled 20
:control: $\cos\Delta\theta$ replaced by 1
:::
*/
CLAIM(rotated_points_are_equally_spaced)
{
    num M[4], P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, Q[2] = {P[0], P[1]}, last[2];
    struct G(turn) angle = G(turn_by)(parameter(T, "a")), used = angle;
    used.cos = fault(T, used.cos, from_int(1));
    G(rotation)(used, M);
    G(steps)(T->degree - 1, M, Q);
    last[0] = Q[0], last[1] = Q[1];
    G(steps)(1, M, Q);
    about(T, "the square of the radius");
    same(T, G(norm_squared)(2, Q), G(norm_squared)(2, P));
    about(T, "the square of the distance");
    num edge[2] = {sub(Q[0], last[0]), sub(Q[1], last[1])}, factor = mul(from_int(2), sub(from_int(1), angle.cos));
    same(T, G(norm_squared)(2, edge), mul(factor, G(norm_squared)(2, P)));
}

/*
:::{statement} hu-1987:1-3-trigonometric
:title: The first way needs trigonometric functions
:zh: 需要三角函数计算
:printed: With hardware the algorithm needs products of matrices, and trigonometric functions have to be computed as well.
:holds-by: rotation_matrix_adds_the_angle
:hypothesis: rational_step_has_no_angle | The angle $\Delta\theta$ is prescribed.  Then it takes two values, $\cos\Delta\theta$ and $\sin\Delta\theta$, once for all points; a
  step that need only be small and constant takes none.
:figure: three_generators
:::
*/

/* (1-3-5) */
static void G(small_step)(num epsilon, num M[])
{
    M[0] = M[3] = from_int(1);
    M[1] = epsilon;
    M[2] = neg(epsilon);
}

#if RATIONAL
/*
:::{claim} rational_step_has_no_angle
:title: Equal steps on the circle without a trigonometric function
:zh: 不用三角函数的等步长旋转
:kind: counterexample
:given: the matrix $M$ with the entries $\frac{1-a^2}{1+a^2}$ and $\frac{2a}{1+a^2}$ in the place of cosine and sine; $n$ steps from $P_0$
:data: P_0 = (1,0); n = 100; a = 1/16
:instead: ε = 1/8
:then: all points are on the circle, at equal distances $d$
:result: M = (255/257,32/257) (-32/257,255/257); d² = 4/257
:method: The squares of radius and distance, exactly; the matrix takes the four operations only, no trigonometric function and no root; that one differs is refuted.
:control: the matrix (1-3-5)
:::
*/
CLAIM(rational_step_has_no_angle)
{
    num M[4], first[2], P[2], edge[2], first_edge = from_int(0);
    int differs = 0;
    given_points(T, "P_0", 1, 2, first);
    int n = given_whole(T, "n");
    if (T->faulty) /* what is printed would need an angle; this matrix has none */
        G(rotation)(G(turn_by)(given(T, "a")), M);
    else
        G(small_step)(given(T, "ε"), M);
    found_points(T, "M", 2, 2, M);
    P[0] = first[0], P[1] = first[1];
    for (int k = 1; k <= n; k++) {
        edge[0] = P[0], edge[1] = P[1];
        G(steps)(1, M, P);
        edge[0] = sub(P[0], edge[0]), edge[1] = sub(P[1], edge[1]);
        num square = G(norm_squared)(2, edge);
        if (k == 1)
            first_edge = square;
        differs |= !equal_q(square, first_edge) || !equal_q(G(norm_squared)(2, P), G(norm_squared)(2, first));
    }
    found(T, "d²", first_edge);
    about(T, "whether a radius or a distance differs from the others");
    refute(T, !differs);
}
#endif

/*
## The first way, simplified

:::{statement} hu-1987:1-3-3
:title: For a small angle the cosine is taken as 1 and the sine as the angle
:zh: 小角度近似
:printed: $\Delta\theta$ is small; with $\cos\Delta\theta=1$, $\sin\Delta\theta=\Delta\theta$ approximately, (1-3-1) becomes
  $x_{n+1}=x_n-\Delta\theta\,y_n$, $y_{n+1}=\Delta\theta\,x_n+y_n$.
:holds-by: small_step_is_the_rotation_to_first_order
:figure: three_generators

To first order, which is what the approximation means.  What the second order does follows.
:::
*/

#if FIELD
/*
:::{claim} small_step_is_the_rotation_to_first_order
:title: The simplified matrix is the rotation to first order in the angle
:zh: 一阶近似
:types: field
:given: the rotation by $\Delta\theta=2\arctan a$, so that $\frac{d}{da}\Delta\theta=\frac2{1+a^2}$
:then: at $a=0$ the rotation matrix is 1 and its derivative with respect to $\Delta\theta$ is that of the printed step,
  $\begin{bmatrix}0&1\\-1&0\end{bmatrix}$
:method: The matrix as a rational function of $a$, differentiated in the field; chain rule.
:control: the derivative with respect to $a$ taken for that with respect to $\Delta\theta$
:::
*/
CLAIM(small_step_is_the_rotation_to_first_order)
{
    num a = variable_f("a"), zero = from_int(0), one = from_int(1), M[4], S[4];
    num speed = fault(T, div(from_int(2), add(one, mul(a, a))), one);
    G(rotation)(G(turn_by)(a), M);
    G(small_step)(one, S);
    for (int k = 0; k < 4; k++) {
        num unit = from_int(k == 0 || k == 3);
        same(T, substitute_f(M[k], a, zero), unit);
        same(T, substitute_f(div(derivative_f(M[k], a), speed), a, zero), sub(S[k], unit));
    }
}
#endif

/*
:::{statement} hu-1987:1-3-5
:title: The simplified step (1-3-4) and its matrix
:zh: 简化递推的矩阵形式
:printed: $x_{n+1}=x_n-\varepsilon y_n$, $y_{n+1}=\varepsilon x_n+y_n$ is
  $[x_{n+1}\;y_{n+1}]=[x_n\;y_n]\begin{bmatrix}1&\varepsilon\\-\varepsilon&1\end{bmatrix}$.
:holds-by: small_step_matrix_is_the_recursion
:figure: three_generators
:::

:::{claim} small_step_matrix_is_the_recursion
:title: The matrix gives the two formulas, its determinant is more than 1
:zh: 矩阵与递推一致
:given: any point, any $\varepsilon$
:then: the row times the matrix is $(x-\varepsilon y,\ \varepsilon x+y)$; the determinant is $1+\varepsilon^2$, the trace 2
:method: Identities in $x$, $y$ and $\varepsilon$.
:control: the matrix transposed
:::
*/
CLAIM(small_step_matrix_is_the_recursion)
{
    num P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, epsilon = unknown(T, "e", 0), M[4], next[2];
    G(small_step)(fault(T, epsilon, neg(epsilon)), M);
    G(row_times)(P, M, next);
    same(T, next[0], sub(P[0], mul(epsilon, P[1])));
    same(T, next[1], add(mul(epsilon, P[0]), P[1]));
    about(T, "determinant and trace");
    same(T, G(cross2)(M, M + 2), add(from_int(1), mul(epsilon, epsilon)));
    same(T, add(M[0], M[3]), from_int(2));
}

/*
:::{statement} hu-1987:1-3-shift
:title: With a power of two the products are shifts
:zh: 用移位实现乘法
:printed: For $\varepsilon=2^{-m}$ with $m$ large enough, $\varepsilon x_n$ and $\varepsilon y_n$ are computed by shifting, and circles or arcs are
  generated at high speed.
:holds-by: exact_steps_need_m_more_bits_each
:hypothesis: short_registers_stop_the_point | The registers keep the bits that are shifted out.  In integers a point with
  coordinates from 0 to $2^m-1$ does not move at all; and to be exact, every step needs $m$ bits more.
:figure: circles_in_integers
:::
*/

#if RATIONAL
/*
:::{claim} exact_steps_need_m_more_bits_each
:title: After n exact steps a coordinate has n m binary places
:zh: 精确计算每步增加 m 位
:kind: decision
:given: $P_0=(1,0)$, $\varepsilon=2^{-m}$, $m=1,\dots,8$, $n=1,\dots,12$ steps
:then: $2^{nm}x_n$ and $2^{nm}y_n$ are integers, and one of them is odd: shifts suffice, and no shorter words do
:method: Exact rational steps and their denominators.
:scope: m = 1 to 8, n = 1 to 12 steps from (1, 0)
:control: one place less
:::
*/
CLAIM(exact_steps_need_m_more_bits_each)
{
    for (int m = 1; m <= 8; m++)
        for (int n = 1; n <= 12; n++) {
            num M[4], P[2] = {from_int(1), from_int(0)}, scale = from_int(1);
            G(small_step)(from_ratio(1, 1L << m), M);
            G(steps)(n, M, P);
            for (int k = 0; k < fault(T, n * m, n * m - 1); k++)
                scale = mul(scale, from_int(2));
            num x = mul(scale, P[0]), y = mul(scale, P[1]), half = from_ratio(1, 2);
            agree(T, is_whole_q(x) && is_whole_q(y));
            agree(T, !is_whole_q(mul(half, x)) || !is_whole_q(mul(half, y)));
        }
}

/* x / unit, rounded down: the shift that drops bits; unit > 0 */
static int floor_quotient(int x, int unit) { return x >= 0 ? x / unit : -((unit - 1 - x) / unit); }

/*
:::{claim} short_registers_stop_the_point
:title: With integers the point stands still
:zh: 整数移位使点停止不动
:kind: counterexample
:given: a whole $m$ and a point with whole coordinates; shifts that drop the bits shifted out
:data: m = 4; x_0 = 10; y_0 = 0
:instead: x_0 = 160
:then: $x_1=x_0$ and $y_1=y_0$: the point never moves, though the exact $y_1$ is not $y_0$
:result: x_1 = 10; y_1 = 0; exact y_1 = 5/8
:method: The step in integers, $y_1=y_0+\lfloor x_0/2^m\rfloor$, against the exact one.
:control: an abscissa whose shifted value is exact
:::
*/
CLAIM(short_registers_stop_the_point)
{
    int m = given_whole(T, "m"), x = given_whole(T, "x_0"), y = given_whole(T, "y_0");
    num exact = add(from_int(y), from_ratio(x, 1L << m));
    int next_x = x - floor_quotient(y, 1 << m), next_y = y + floor_quotient(x, 1 << m);
    found_whole(T, "x_1", next_x);
    found_whole(T, "y_1", next_y);
    found(T, "exact y_1", exact);
    about(T, "y_1, left by shifting integers, right exactly");
    same(T, from_int(next_y), exact);
}

/*
:::{claim} short_coordinates_never_move
:title: Points with coordinates from 0 to 2^m - 1 stand still, and negative coordinates do not
:zh: 非负短坐标的点不动
:kind: decision
:given: every $m=1,\dots,M$ and all $x,y=0,\dots,2^m-1$; shifts that drop the bits shifted out, $\lfloor x/2^m\rfloor$; and one point with a negative
  ordinate, for one $m$
:data: M = 6; m = 4; x_0 = 10; y_0 = -5
:then: $x_1=x$, $y_1=y$ for all of them; the point with the negative ordinate moves on and on to the right, because $\lfloor y_0/2^m\rfloor$ is $-1$
:result: x_1 = 11; y_1 = -5
:method: The step in integers, at every point.
:scope: m = 1 to 6
:control: coordinates up to $2^m$
:::
*/
CLAIM(short_coordinates_never_move)
{
    int largest = given_whole(T, "M");
    for (int m = 1; m <= largest; m++) {
        int unit = 1 << m, most = fault(T, unit - 1, unit);
        for (int x = 0; x <= most; x++)
            for (int y = 0; y <= most; y++)
                agree(T, floor_quotient(x, unit) == 0 && floor_quotient(y, unit) == 0);
    }
    int unit = 1 << given_whole(T, "m"), x = given_whole(T, "x_0"), y = given_whole(T, "y_0");
    found_whole(T, "x_1", x - floor_quotient(y, unit));
    found_whole(T, "y_1", y + floor_quotient(x, unit));
    agree(T, floor_quotient(y, unit) == -1 && floor_quotient(x, unit) == 0);
}
#endif

/*
:::{statement} hu-1987:1-3-not-closed
:title: The simplified circle does not close
:zh: 简化算法所得的圆不封闭
:printed: The circle that this algorithm produces is not closed.
:holds-by: small_steps_multiply_the_radius radius_of_small_steps_exceeds_every_bound
:needs: small_step_of_zero_stays | $\varepsilon\ne0$
:figure: three_generators
:::

:::{statement} hu-1987:1-3-radius-grows
:title: The radius of the simplified circle keeps growing
:zh: 半径有不断增大的趋势
:printed: The radius of the circle tends to increase without end.
:holds-by: small_steps_multiply_the_radius radius_of_small_steps_exceeds_every_bound
:figure: radius_of_the_first_way

It is more than a tendency: $|P_n|=\sqrt{1+\varepsilon^2}^{\,n}\,|P_0|$, exactly.  For $\varepsilon=\frac1{16}$ a turn of about a hundred steps
ends with a radius larger by a fifth.
:::

:::{claim} small_steps_multiply_the_radius
:title: Every step multiplies the radius by the same number
:zh: 半径按等比增长
:given: any first point, any $\varepsilon$, $n$ steps
:then: $x_n^2+y_n^2=(1+\varepsilon^2)^n(x_0^2+y_0^2)$
:method: The steps one after the other, in the field with the point and $\varepsilon$ variables; the factor of one step is the
  determinant.
:degrees: 1..8 sampled 24
:control: $n-1$ steps
:::
*/
CLAIM(small_steps_multiply_the_radius)
{
    num P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, Q[2] = {P[0], P[1]}, epsilon = unknown(T, "e", 0), M[4];
    G(small_step)(epsilon, M);
    G(steps)(fault(T, T->degree, T->degree - 1), M, Q);
    num factor = add(from_int(1), mul(epsilon, epsilon));
    same(T, G(norm_squared)(2, Q), mul(G(power)(factor, T->degree), G(norm_squared)(2, P)));
}

/*
:::{claim} radius_of_small_steps_exceeds_every_bound
:title: The points never come back, and leave every circle
:zh: 点列不返回且无界
:given: $\varepsilon>0$, $n$ steps
:then: $(1+\varepsilon^2)^n-1-n\varepsilon^2\ge0$, so the radius is larger after every step and exceeds every bound
:method: The power is formed by multiplication; its difference from $1+n\varepsilon^2$ has no negative coefficient.
:degrees: 1..8 sampled 24
:control: $n+1$ in the place of $n$ in the product $n\varepsilon^2$
:::
*/
CLAIM(radius_of_small_steps_exceeds_every_bound)
{
    num epsilon = positive(T, "e", 0), square = mul(epsilon, epsilon);
    num whole_power = G(power)(add(from_int(1), square), T->degree);
    num least = add(from_int(1), mul(from_int(fault(T, T->degree, T->degree + 1)), square));
    nonnegative(T, sub(whole_power, least));
}

#if RATIONAL
/*
:::{claim} small_step_of_zero_stays
:title: A step of zero closes at once
:zh: 步长为零时不动
:kind: counterexample
:given: $\varepsilon$ and $P_0$
:data: ε = 0; P_0 = (1,0)
:instead: ε = 1/16
:then: $P_1=P_0$
:result: P_1 = (1,0)
:method: One step; that it moves the point is refuted.
:control: a small step
:::
*/
CLAIM(small_step_of_zero_stays)
{
    num M[4], first[2], P[2];
    G(small_step)(given(T, "ε"), M);
    given_points(T, "P_0", 1, 2, first);
    P[0] = first[0], P[1] = first[1];
    G(steps)(1, M, P);
    found_points(T, "P_1", 1, 2, P);
    about(T, "whether P_1 is not P_0");
    refute(T, equal_q(P[0], first[0]) && equal_q(P[1], first[1]));
}
#endif

/*
:::{statement} hu-1987:1-3-perpendicular
:title: The small vector that is added is perpendicular to the radius
:zh: 增量与位置矢量垂直
:printed: $P_{n+1}$ is $P_n$ plus a small vector perpendicular to the position vector $P_n=[x_n,y_n]$; so the new radius is
  larger than the one before.
:holds-by: small_step_adds_a_perpendicular_vector
:figure: radius_of_the_first_way
:::
*/

/* The matrix of the second way. */
static void G(second_step)(num epsilon, num M[])
{
    G(small_step)(epsilon, M);
    M[3] = sub(from_int(1), mul(epsilon, epsilon));
}

/*
:::{claim} small_step_adds_a_perpendicular_vector
:title: The step is a right angle to the radius, of a fixed share of its length
:zh: 增量垂直于位置矢量
:given: any point, any $\varepsilon$
:then: $(P_{n+1}-P_n)\cdot P_n=0$ and $|P_{n+1}-P_n|^2=\varepsilon^2|P_n|^2$, whence $|P_{n+1}|^2=|P_n|^2+\varepsilon^2|P_n|^2$ by Pythagoras
:method: Identities in the point and $\varepsilon$.
:control: the step of the second way
:::
*/
CLAIM(small_step_adds_a_perpendicular_vector)
{
    num P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, Q[2] = {P[0], P[1]}, epsilon = unknown(T, "e", 0), M[4];
    if (T->faulty)
        G(second_step)(epsilon, M);
    else
        G(small_step)(epsilon, M);
    G(steps)(1, M, Q);
    num step[2] = {sub(Q[0], P[0]), sub(Q[1], P[1])}, radius = G(norm_squared)(2, P);
    vanishes(T, G(dot)(2, step, P));
    same(T, G(norm_squared)(2, step), mul(mul(epsilon, epsilon), radius));
    same(T, G(norm_squared)(2, Q), add(radius, G(norm_squared)(2, step)));
}

/*
:::{statement} hu-1987:1-3-spiral
:title: The points of the simplified circle are on a spiral
:zh: 所得曲线为螺线
:printed: The curve obtained is really not an exact arc of a circle, but a spiral.
:holds-by: small_steps_are_powers_of_a_complex_number small_steps_multiply_the_radius
:figure: three_generators

It is the logarithmic spiral: every step adds the angle $\arctan\varepsilon$, and multiplies the radius by $\sqrt{1+\varepsilon^2}$.  The angle is
not $\Delta\theta=\varepsilon$, but a little less.
:::

:::{claim} small_steps_are_powers_of_a_complex_number
:title: The points are the powers of one complex number
:zh: 点列为复数的幂
:given: any first point, any $\varepsilon$, $n$ steps
:then: $x_n+iy_n=(1+i\varepsilon)^n(x_0+iy_0)$; so the argument grows by $\arctan\varepsilon$, and the radius by $|1+i\varepsilon|$, in every step
:method: The steps against the binomial theorem, $\mathrm{Re}(1+i\varepsilon)^n=\sum_k(-1)^k\binom n{2k}\varepsilon^{2k}$ and the same for the
  imaginary part.
:degrees: 1..8 sampled 24
:control: the signs of the binomial theorem left out
:::
*/
CLAIM(small_steps_are_powers_of_a_complex_number)
{
    int n = T->degree;
    num P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, Q[2] = {P[0], P[1]}, epsilon = unknown(T, "e", 0), M[4];
    num z[2] = {from_int(0), from_int(0)};
    for (int k = 0; k <= n; k++) {
        num term = mul(from_int(binomial(n, k)), G(power)(epsilon, k));
        z[k % 2] = fault(T, k % 4 < 2 ? add(z[k % 2], term) : sub(z[k % 2], term), add(z[k % 2], term));
    }
    G(small_step)(epsilon, M);
    G(steps)(n, M, Q);
    same(T, Q[0], sub(mul(z[0], P[0]), mul(z[1], P[1])));
    same(T, Q[1], add(mul(z[0], P[1]), mul(z[1], P[0])));
}

/*
## The second way

The second formula may use the new $x$, which is already there.  That this is no loss of care but a gain is the point of
the method: the determinant becomes 1.

:::{statement} hu-1987:1-3-second-substitution
:title: The second formula with the new abscissa
:zh: 用新横坐标代入
:printed: $y_{n+1}=\varepsilon x_{n+1}+y_n=\varepsilon x_n+(1-\varepsilon^2)y_n$
:holds-by: second_step_uses_the_new_abscissa
:figure: ellipse_of_the_second_way
:::

:::{statement} hu-1987:1-3-second-matrix
:title: The matrix of the second way
:zh: 第二种方法的矩阵
:printed: $P_{n+1}=P_nT$ with $T=\begin{pmatrix}1&\varepsilon\\-\varepsilon&1-\varepsilon^2\end{pmatrix}$
:holds-by: second_step_uses_the_new_abscissa
:figure: ellipse_of_the_second_way
:::

:::{claim} second_step_uses_the_new_abscissa
:title: The matrix of the second way, and its determinant
:zh: 第二种方法的矩阵及其行列式
:given: any point, any $\varepsilon$
:then: the row times $T$ is $x'=x-\varepsilon y$, $y'=y+\varepsilon x'$; $\det T=1$, the trace of $T$ is $2-\varepsilon^2$
:method: Identities in $x$, $y$ and $\varepsilon$.
:control: $y'=y+\varepsilon x$
:::
*/
CLAIM(second_step_uses_the_new_abscissa)
{
    num P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, epsilon = unknown(T, "e", 0), M[4], next[2];
    G(second_step)(epsilon, M);
    G(row_times)(P, M, next);
    num x = sub(P[0], mul(epsilon, P[1]));
    same(T, next[0], x);
    same(T, next[1], add(P[1], mul(epsilon, fault(T, x, P[0]))));
    about(T, "determinant and trace");
    same(T, G(cross2)(M, M + 2), from_int(1));
    same(T, add(M[0], M[3]), sub(from_int(2), mul(epsilon, epsilon)));
}

/*
:::{statement} hu-1987:1-3-second-difference-equations
:title: The difference equations of the ellipse
:zh: 椭圆的差分方程
:printed: With $x_n=r\cos\theta$, $y_n=r\sin(\theta+\frac{\Delta\theta}2)$, $\varepsilon=2\sin\frac{\Delta\theta}2$:
  $x_{n+1}=r\cos(\theta+\Delta\theta)=r\cos\theta-2r\sin\frac{\Delta\theta}2\sin(\theta+\frac{\Delta\theta}2)=x_n-\varepsilon y_n$,
  $y_{n+1}=r\sin(\theta+\Delta\theta+\frac{\Delta\theta}2)=r\sin(\theta+\frac{\Delta\theta}2)+2r\sin\frac{\Delta\theta}2\cos(\theta+\Delta\theta)=y_n+\varepsilon x_{n+1}$
:holds-by: second_orbit_has_equal_angles
:needs: second_step_of_two_has_no_angle | $0<\varepsilon<2$; otherwise there is no such angle
:figure: ellipse_of_the_second_way
:::

:::{claim} second_orbit_has_equal_angles
:title: Along the orbit of the second way an angle grows evenly
:zh: 第二种方法的等角参数
:given: any $r$, $\theta$ and $\delta=\frac{\Delta\theta}2$ with the tangents $a$ and $b$ of their halves
:then: the step $T$ with $\varepsilon=2\sin\delta$ takes $(r\cos\theta,r\sin(\theta+\delta))$ to $(r\cos(\theta+2\delta),r\sin(\theta+3\delta))$, and the middle
  terms of both chains are equal to the outer ones
:method: All sums of angles from the tangents of their halves; $a$, $b$, $r$ variables.
:control: $\varepsilon=2\sin\Delta\theta$
:::
*/
CLAIM(second_orbit_has_equal_angles)
{
    num a = parameter(T, "a"), b = parameter(T, "b"), r = positive(T, "r", 0), two = from_int(2);
    num once = G(half_of_sum)(a, b), twice = G(half_of_sum)(once, b), thrice = G(half_of_sum)(twice, b);
    struct G(turn) theta = G(turn_by)(a), delta = G(turn_by)(b), one = G(turn_by)(once), full = G(turn_by)(twice),
                   last = G(turn_by)(thrice);
    num sine = fault(T, delta.sin, mul(two, mul(delta.sin, delta.cos)));
    num epsilon = mul(two, sine), M[4], next[2], P[2] = {mul(r, theta.cos), mul(r, one.sin)}, twice_r = mul(two, r);
    G(second_step)(epsilon, M);
    G(row_times)(P, M, next);
    about(T, "x_{n+1}");
    same(T, next[0], mul(r, full.cos));
    same(T, mul(r, full.cos), sub(mul(r, theta.cos), mul(mul(twice_r, delta.sin), one.sin)));
    about(T, "y_{n+1}");
    same(T, next[1], mul(r, last.sin));
    same(T, mul(r, last.sin), add(mul(r, one.sin), mul(mul(twice_r, delta.sin), full.cos)));
}

#if RATIONAL
/*
:::{claim} second_step_of_two_has_no_angle
:title: With the step 2 the orbit runs away
:zh: 步长为二时轨道无界
:kind: counterexample
:given: $\varepsilon$, $P_0$, $n$ steps of the second way, and a bound $b$
:data: ε = 2; P_0 = (1,0); n = 10; b = 4/3
:instead: ε = 1
:then: $|x_n|=2n-1$ grows without end: the points are on the two lines $(x-y)^2=1$, on no ellipse
:result: P_n = (-19,-20); x_n - y_n = 1
:method: Exact steps; $x_n^2$ is compared with $b$, the largest $x^2$ on the ellipse $x^2+y^2-xy=1$ of the control.
:control: a step for which there is an ellipse
:::
*/
CLAIM(second_step_of_two_has_no_angle)
{
    num M[4], P[2];
    G(second_step)(given(T, "ε"), M);
    given_points(T, "P_0", 1, 2, P);
    int n = given_whole(T, "n");
    num bound = given(T, "b");
    G(steps)(n, M, P);
    found_points(T, "P_n", 1, 2, P);
    found(T, "x_n - y_n", sub(P[0], P[1]));
    about(T, "whether x_n² is at most b");
    agree(T, compare_q(mul(P[0], P[0]), bound) <= 0);
}
#endif

/*
:::{statement} hu-1987:1-3-ellipse
:title: The equation of the ellipse
:zh: 椭圆方程
:printed: \frac{x^2}{(r\cos\frac{\Delta\theta}2)^2}+\frac{y^2}{(r\cos\frac{\Delta\theta}2)^2}-\frac{2\sin\frac{\Delta\theta}2}{(r\cos\frac{\Delta\theta}2)^2}\,xy=1
:holds-by: second_orbit_satisfies_the_printed_equation second_form_is_invariant second_form_is_an_ellipse
:figure: ellipse_of_the_second_way
:::

:::{claim} second_orbit_satisfies_the_printed_equation
:title: The points of the difference equations are on the printed ellipse
:zh: 差分方程的点满足椭圆方程
:given: any $r$, any $\theta$ and $\delta$ with the tangents $a$ and $b$ of their halves
:then: $x=r\cos\theta$, $y=r\sin(\theta+\delta)$ satisfy the printed equation
:method: An identity in $a$, $b$ and $r$, term by term as printed.
:control: the factor 2 of the product $xy$ left out
:::
*/
CLAIM(second_orbit_satisfies_the_printed_equation)
{
    num a = parameter(T, "a"), b = parameter(T, "b"), r = positive(T, "r", 0);
    struct G(turn) theta = G(turn_by)(a), delta = G(turn_by)(b), shifted = G(turn_by)(G(half_of_sum)(a, b));
    num x = mul(r, theta.cos), y = mul(r, shifted.sin), below = mul(r, delta.cos);
    num square = mul(below, below), factor = mul(from_int(fault(T, 2, 1)), delta.sin);
    num left = sub(add(div(mul(x, x), square), div(mul(y, y), square)), mul(div(factor, square), mul(x, y)));
    same(T, left, from_int(1));
}

/*
:::{claim} second_form_is_invariant
:title: A quadratic form is the same along the orbit
:zh: 不变二次型
:given: any first point, any $\varepsilon$, $n$ steps of the second way
:then: $x_n^2+y_n^2-\varepsilon x_ny_n=x_0^2+y_0^2-\varepsilon x_0y_0$
:method: The steps one after the other, in the field with the point and $\varepsilon$ variables.
:degrees: 1..8 sampled 24
:control: the form $x^2+y^2$
:::
*/
CLAIM(second_form_is_invariant)
{
    num P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, Q[2] = {P[0], P[1]}, epsilon = unknown(T, "e", 0), M[4];
    num mixed = fault(T, epsilon, from_int(0));
    G(second_step)(epsilon, M);
    G(steps)(T->degree, M, Q);
    same(T, sub(G(norm_squared)(2, Q), mul(mixed, mul(Q[0], Q[1]))),
         sub(G(norm_squared)(2, P), mul(mixed, mul(P[0], P[1]))));
}

/*
:::{claim} second_form_is_an_ellipse
:title: The invariant form is positive: the curve is an ellipse with its axes on the diagonals
:zh: 不变二次型正定
:given: $0<s<1$, $s=\frac\varepsilon2$
:then: $x^2+y^2-2sxy=\frac{1-s}2(x+y)^2+\frac{1+s}2(x-y)^2$, both coefficients positive
:method: An identity in $s$, $x$, $y$; $s=\frac\sigma{1+\sigma}$ with $\sigma>0$ for the signs.
:control: $1-s$ and $1+s$ exchanged
:::
*/
CLAIM(second_form_is_an_ellipse)
{
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), s = inside(T, "s"), one = from_int(1);
    num plus = G(power)(add(x, y), 2), minus = G(power)(sub(x, y), 2);
    num low = mul(from_ratio(1, 2), sub(one, s)), high = mul(from_ratio(1, 2), add(one, s));
    num form = sub(add(mul(x, x), mul(y, y)), mul(mul(from_int(2), s), mul(x, y)));
    same(T, form, fault(T, add(mul(low, plus), mul(high, minus)), add(mul(high, plus), mul(low, minus))));
    nonnegative(T, low);
    nonnegative(T, high);
}

/*
### How far the ellipse is from the circle

:::{statement} hu-1987:1-3-error
:title: The error of the ellipse
:zh: 椭圆与圆的误差公式
:printed: $E=\Bigl(\cos\frac{\Delta\theta}2\Big/\sqrt{1-\sin\frac{\Delta\theta}2}-1\Bigr)\times100(\%)$ is the error between the ellipse and the
  exact circle.
:holds-by: ellipse_lies_between_two_circles
:reading: ellipse_lies_between_two_circles | By how much the ellipse leaves the circle of radius $r$ outwards, relative to $r$.
:reading: ellipse_leaves_the_circle_by_more | The largest error in either direction: this is $1-\sqrt{1-s}$, inwards, and for every
  $s$ a little larger than the printed $\sqrt{1+s}-1$ (`inward_error_of_the_ellipse_is_larger`).
:figure: ellipse_of_the_second_way
:::

:::{claim} ellipse_lies_between_two_circles
:title: The largest and the smallest radius of the ellipse
:zh: 椭圆的最大与最小半径
:given: $s=\sin\frac{\Delta\theta}2$, $c^2=1-s^2$, $0<s<1$, any point on $x^2+y^2-2sxy=r^2c^2$
:then: $r^2(1+s)-(x^2+y^2)=\frac s{1-s}(x-y)^2$ and $(x^2+y^2)-r^2(1-s)=\frac s{1+s}(x+y)^2$; so the radius is between
  $r\sqrt{1-s}$ and $r\sqrt{1+s}$, both reached, on the diagonals, and $\frac{c^2}{1-s}=1+s$ makes $E=\sqrt{1+s}-1$
:method: $r^2$ is eliminated by the equation; identities in $s$, $x$, $y$, with $s=\frac\sigma{1+\sigma}$.
:control: the two circles exchanged
:::
*/
CLAIM(ellipse_lies_between_two_circles)
{
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), s = inside(T, "s"), one = from_int(1);
    num high = add(one, s), low = sub(one, s), cc = sub(one, mul(s, s)), radius = add(mul(x, x), mul(y, y));
    num rr = div(sub(radius, mul(mul(from_int(2), s), mul(x, y))), cc);
    num outer = fault(T, high, low), inner = fault(T, low, high);
    same(T, sub(mul(rr, outer), radius), mul(div(s, low), G(power)(sub(x, y), 2)));
    same(T, sub(radius, mul(rr, inner)), mul(div(s, high), G(power)(add(x, y), 2)));
    about(T, "the square of 1 + E");
    same(T, div(cc, low), high);
}

/* (1 + k)^2 - (1 + h) */
static num G(square_above)(num k, num h)
{
    num one = from_int(1);
    return sub(G(power)(add(one, k), 2), add(one, h));
}

/*
:::{claim} inward_error_of_the_ellipse_is_larger
:title: The ellipse leaves the circle farther inwards than outwards
:zh: 向内误差大于向外误差
:given: $0<s<1$
:then: $\sqrt{1+s}-1<\frac s2<1-\sqrt{1-s}$
:method: $(1+\frac s2)^2-(1+s)$ and $(1-\frac s2)^2-(1-s)$ are both $\frac{s^2}4$, and positive.
:control: $\frac s4$ in the place of $\frac s2$
:::
*/
CLAIM(inward_error_of_the_ellipse_is_larger)
{
    num s = inside(T, "s"), half = mul(from_ratio(1, fault(T, 2, 4)), s), gap = mul(from_ratio(1, 4), mul(s, s));
    same(T, G(square_above)(half, s), gap);
    same(T, G(square_above)(neg(half), neg(s)), gap);
    nonnegative(T, gap);
}

#if RATIONAL
/*
:::{claim} ellipse_leaves_the_circle_by_more
:title: Inwards the ellipse leaves the circle by more than the printed error
:zh: 椭圆向内偏离大于印刷的误差
:kind: counterexample
:given: the sine $s$ that the source's example has, $a=1+s$
:data: s = 1/32
:instead: s = 0
:then: $1-\sqrt{1-s}\le\sqrt{1+s}-1$ is false
:result: (1 + a)² - 4a = 1/1024
:method: It says $2-\sqrt a\le\sqrt{2-a}$; both sides are positive, and squaring twice it becomes $(1-a)^2\le0$.
:control: the circle
:::
*/
CLAIM(ellipse_leaves_the_circle_by_more)
{
    num a = add(from_int(1), given(T, "s")), once = add(from_int(1), a);
    /* 2 - √a <= √(2-a)  squared:  1 + a <= 2 √a;  squared again:  (1 + a)^2 - 4a = (1 - a)^2 <= 0 */
    num gap = sub(mul(once, once), mul(from_int(4), a));
    found(T, "(1 + a)² - 4a", gap);
    about(T, "whether the inward error is at most the outward one");
    agree(T, sign_q(gap) <= 0);
}

/*
:::{statement} hu-1987:1-3-error-approximation
:title: The error is about the reciprocal of a power of two
:zh: 误差的近似值
:printed: For $\varepsilon=2^{-m}=2\sin\frac{\Delta\theta}2$: $E\approx\frac1{2^{m+1}}\times100(\%)$.
:refuted-by: printed_error_is_twice_the_error
:class: misprint
:corrected: $E\approx\frac1{2^{m+2}}\times100(\%)$; more exactly $\frac s2-\frac{s^2}8<\sqrt{1+s}-1<\frac s2$ with $s=2^{-m-1}$
:corrected-by: error_is_half_the_sine
:figure: error_of_the_second_way
:striking: 41

The source's own example, 1.6% for $m=4$, is that of the corrected exponent.
:::
*/

/*
:::{claim} printed_error_is_twice_the_error
:title: For m = 4 the printed approximation gives 3.1 per cent, the formula 1.6
:zh: 近似式给出两倍的误差
:kind: counterexample
:given: the $m$ of the source's example, and $s=2^{-m-1}$
:data: m = 4
:then: in per cent, rounded to one decimal, the printed $2^{-(m+1)}$ is not $E=\sqrt{1+s}-1$, but nearly twice as much
:result: 2^-(m+1), per cent = 3.1; E, per cent = 1.6
:method: A number is rounded to $k$ tenths of a per cent when it is between the numbers half a tenth below and above, which is decided for $E$ after
  squaring.
:control: $2^{-(m+2)}$
:::
*/
/* k tenths of a per cent, and half a tenth more */
static num tenths_of_a_percent(int k) { return from_ratio(k, 1000); }
static num border_above(int k) { return from_ratio(2 * k + 1, 2000); }

/* The number x in tenths of a per cent, rounded. */
static int in_tenths(num x)
{
    int k = 0;
    while (compare_q(x, border_above(k)) >= 0)
        k++;
    return k;
}

/* sqrt(a) - 1 in tenths of a per cent, rounded; a >= 1. */
static int excess_of_root_in_tenths(num a)
{
    int k = 0;
    while (compare_q(a, G(power)(add(from_int(1), border_above(k)), 2)) >= 0)
        k++;
    return k;
}

CLAIM(printed_error_is_twice_the_error)
{
    int m = given_whole(T, "m");
    num s = from_ratio(1, 1L << (m + 1));
    int printed = in_tenths(fault(T, from_ratio(1, 1L << (m + 2)), s));
    int error = excess_of_root_in_tenths(add(from_int(1), s));
    num hundred = from_int(100);
    found(T, "2^-(m+1), per cent", mul(hundred, tenths_of_a_percent(printed)));
    found(T, "E, per cent", mul(hundred, tenths_of_a_percent(error)));
    about(T, "tenths of a per cent");
    same(T, from_int(printed), from_int(error));
}
#endif

/*
:::{claim} error_is_half_the_sine
:title: The error is half the sine, to second order
:zh: 误差的二阶估计
:given: $0<s<1$
:then: $\frac s2-\frac{s^2}8<\sqrt{1+s}-1<\frac s2$; for $s=2^{-m-1}$ the upper bound is $2^{-m-2}$
:method: $(1+\frac s2)^2-(1+s)=\frac{s^2}4$ and $(1+s)-(1+\frac s2-\frac{s^2}8)^2=\frac{s^3(8-s)}{64}$; both positive.
:control: $\frac{s^2}{16}$ in the place of $\frac{s^2}8$
:::
*/
CLAIM(error_is_half_the_sine)
{
    num s = inside(T, "s"), half = mul(from_ratio(1, 2), s), ss = mul(s, s);
    num lower = sub(half, mul(from_ratio(1, fault(T, 8, 16)), ss));
    num below = div(mul(mul(s, ss), sub(from_int(8), s)), from_int(64)), above = mul(from_ratio(1, 4), ss);
    same(T, G(square_above)(half, s), above);
    same(T, neg(G(square_above)(lower, s)), below);
    nonnegative(T, above);
    nonnegative(T, below);
}

/*
:::{statement} hu-1987:1-3-error-example
:title: The error for m = 4
:zh: m=4 时的误差
:printed: For $m=4$, $E=1.6\%$.
:holds-by: error_for_four_is_as_printed
:figure: error_of_the_second_way
:::
*/

#if RATIONAL
/*
:::{claim} error_for_four_is_as_printed
:title: The error for m = 4 is 1.6 per cent to the digits printed
:zh: m=4 时误差为百分之一点六
:kind: decision
:given: the $m$ of the source, $s=2^{-m-1}$, and the printed error $p$ in per cent, with half a unit $h$ of its last digit
:data: m = 4; p = 1.6; h = 0.05
:instead: m = 3
:then: $E=\sqrt{1+s}-1$ is between $p-h$ and $p+h$ per cent, and inwards $1-\sqrt{1-s}$ is so as well
:result: s = 1/32
:method: The four comparisons after squaring, in rationals.
:control: a longer step
:::
*/
/* lo < sqrt(a) < hi for positive lo */
static int root_is_between(num lo, num a, num hi)
{
    return compare_q(mul(lo, lo), a) < 0 && compare_q(a, mul(hi, hi)) < 0;
}

CLAIM(error_for_four_is_as_printed)
{
    num s = from_ratio(1, 1L << (given_whole(T, "m") + 1)), p = given(T, "p"), h = given(T, "h");
    num one = from_int(1), percent = from_ratio(1, 100), low = mul(percent, sub(p, h)), high = mul(percent, add(p, h));
    found(T, "s", s);
    agree(T, root_is_between(add(one, low), add(one, s), add(one, high)));
    agree(T, root_is_between(sub(one, high), sub(one, s), sub(one, low)));
}
#endif

/*
### Does the second way close?

The source says only of the first way that it does not close.  The ellipse of the second way is a closed curve, and the
points stay on it for ever; but they never come back to where they were.
*/

#if RATIONAL
/*
:::{claim} second_orbit_never_closes
:title: The orbit of the second way never returns to its first point
:zh: 第二种方法的点列永不重复
:kind: decision
:given: $\varepsilon=2^{-m}$, $m=1,\dots,6$; traces $V_k$ of $T^k$ for $k=1,\dots,48$, $V_{k+1}=(2-\varepsilon^2)V_k-V_{k-1}$, $V_0=2$
:then: $4^{mk}V_k$ is an odd integer; so $V_k\ne2$.  A point that returned after $k$ steps would belong to
  the eigenvalue 1 of $T^k$; the other one would be 1, too, because $\det T=1$, and their sum $V_k$ would be 2
:method: The traces by the recursion, exactly.  For every $k$: $V_k$ is a polynomial in $2-\varepsilon^2$ with whole
  coefficients and leading coefficient 1, and $2-\varepsilon^2=\frac{2\cdot4^m-1}{4^m}$ is in lowest terms, so $4^{mk}V_k$ is odd:
  the eigenvalues are no roots of unity, because their sum is no algebraic integer.
:scope: m = 1 to 6, k = 1 to 48 steps
:control: $\varepsilon=1$, where $V_6=2$
:::
*/
/* 2^bits V is an odd integer. */
static int has_exactly_the_bits(num V, int bits)
{
    for (int k = 0; k < bits; k++)
        V = mul(from_int(2), V);
    return is_whole_q(V) && !is_whole_q(mul(from_ratio(1, 2), V));
}

CLAIM(second_orbit_never_closes)
{
    for (int m = 1; m <= 6; m++) {
        num M[4], before = from_int(2);
        G(second_step)(fault(T, from_ratio(1, 1L << m), from_int(1)), M);
        num trace = add(M[0], M[3]), V = trace;
        for (int k = 1; k <= 48; k++) {
            agree(T, has_exactly_the_bits(V, fault(T, 2 * m * k, 0)));
            agree(T, !equal_q(V, from_int(2)));
            num next = sub(mul(trace, V), before);
            before = V, V = next;
        }
    }
}
#endif

/*
:::{claim} second_step_of_one_closes_after_six
:title: With the step 1 the second way closes after six points
:zh: 步长为一时六步闭合
:given: any first point, $\varepsilon$, and an even number $n$ of steps
:data: ε = 1; n = 6
:instead: n = 5
:then: $P_n=P_0$, and $P_{n/2}=-P_0$; the characteristic polynomial $\lambda^2-\lambda+1$ is the cyclotomic polynomial $\Phi_n$
:method: All steps with variable $P_0$.
:control: one step less
:::
*/
CLAIM(second_step_of_one_closes_after_six)
{
    num M[4], P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, Q[2] = {P[0], P[1]};
    G(second_step)(given(T, "ε"), M);
    int n = given_whole(T, "n");
    G(steps)(n / 2, M, Q);
    for (int j = 0; j < 2; j++)
        same(T, Q[j], neg(P[j]));
    G(steps)(n - n / 2, M, Q);
    for (int j = 0; j < 2; j++)
        same(T, Q[j], P[j]);
}

/*
## The third way

:::{statement} hu-1987:1-3-third-rotation
:title: A point turned again and again gives a circle
:zh: 连续旋转生成圆
:printed: With $R=\begin{pmatrix}\cos\theta&\sin\theta\\-\sin\theta&\cos\theta\end{pmatrix}$, $[x_n\;y_n]R=[x_{n+1}\;y_{n+1}]$, that is
  $x_{n+1}=\cos\theta\,x_n-\sin\theta\,y_n$, $y_{n+1}=\sin\theta\,x_n+\cos\theta\,y_n$; turning a point continually gives a circle.
:holds-by: rotation_matrix_adds_the_angle rotated_points_are_equally_spaced
:figure: three_generators
:::

:::{statement} hu-1987:1-3-third-distance
:title: The first two points are one pixel apart
:zh: 相邻两点距离为一个象素
:printed: When $A_0$ is turned by $\theta$ to $A_1(x_1,y_1)$, its coordinate is $y_1=r\sin\theta=1$, that is, the distance of the two
  points is to be the size of one pixel.
:refuted-by: unit_height_is_not_unit_distance
:class: false
:corrected: For $r\sin\theta=1$ the points are $\sqrt{1+\tan^2\frac\theta2}>1$ apart; they are one pixel apart for
  $2r\sin\frac\theta2=1$, that is $\cos\theta=1-\frac1{2r^2}$.
:corrected-by: distance_of_the_first_two_points
:figure: step_of_the_third_way

The difference vanishes for large $r$: for $r=100$ it is an eighty-thousandth of a pixel.
:::
*/

#if RATIONAL
/*
:::{claim} unit_height_is_not_unit_distance
:title: At height one the second point is farther than one from the first
:zh: 高度为一而距离大于一
:kind: counterexample
:given: $r$, $A_0=(r,0)$, and the cosine of $\theta$
:data: r = 1; cos θ = 0
:then: $A_1$ has the height $r\sin\theta=1$, and $|A_0A_1|$ is more than 1
:result: (r sin θ)² = 1; |A_0A_1|² = 2
:method: $|A_0A_1|^2=2r^2(1-\cos\theta)$, exactly.
:control: $\cos\theta=1-\frac1{2r^2}$
:::
*/
CLAIM(unit_height_is_not_unit_distance)
{
    num r = given(T, "r"), printed = given(T, "cos θ"), rr = mul(r, r), one = from_int(1), two = from_int(2);
    num cosine = fault(T, sub(one, div(one, mul(two, rr))), printed);
    num square = mul(mul(two, rr), sub(one, cosine));
    found(T, "(r sin θ)²", mul(rr, sub(one, mul(cosine, cosine))));
    found(T, "|A_0A_1|²", square);
    about(T, "the square of the distance, and one pixel");
    same(T, square, one);
}
#endif

/*
:::{claim} distance_of_the_first_two_points
:title: The distance of the first two points
:zh: 首两点的距离
:given: $0<\theta<\pi$ with the tangent $a$ of its half, $A_0=(r,0)$
:then: $|A_0A_1|^2=(2r\sin\frac\theta2)^2=\frac{4r^2a^2}{1+a^2}$; for $r\sin\theta=1$ this is $1+a^2$, and it is 1 exactly for
  $\cos\theta=1-\frac1{2r^2}$
:method: The point by the rotation, in the field with $a$ and $r$ variables; then $r=\frac{1+a^2}{2a}$; and
  $2r^2(1-\cos\theta)-1=2r^2\bigl(1-\frac1{2r^2}-\cos\theta\bigr)$.
:control: the distance as $r\sin\theta$
:::
*/
CLAIM(distance_of_the_first_two_points)
{
    num a = inside(T, "a"), r = positive(T, "r", 0), one = from_int(1), aa = mul(a, a), M[4], next[2];
    struct G(turn) angle = G(turn_by)(a);
    num from_sine = div(add(one, aa), mul(from_int(2), a)), first[2] = {r, from_int(0)};
    G(rotation)(angle, M);
    G(row_times)(first, M, next);
    num edge[2] = {sub(next[0], r), next[1]}, square = G(norm_squared)(2, edge), rr = mul(r, r);
    about(T, "the square of the distance");
    same(T, square, fault(T, div(mul(from_int(4), mul(rr, aa)), add(one, aa)), G(power)(mul(r, angle.sin), 2)));
    num unit[2] = {from_sine, from_int(0)};
    G(row_times)(unit, M, next);
    num step[2] = {sub(next[0], from_sine), next[1]};
    about(T, "the height");
    same(T, next[1], one);
    about(T, "the distance for the height one");
    same(T, G(norm_squared)(2, step), add(one, aa));
    num wanted = sub(one, div(one, mul(from_int(2), rr)));
    about(T, "the distance one");
    same(T, sub(square, one), mul(mul(from_int(2), rr), sub(wanted, angle.cos)));
}

/*
:::{statement} hu-1987:1-3-third-angle
:title: The angle of the third way
:zh: 第三种方法的转角
:printed: From $y_1=r\sin\theta=1$: $\sin\theta=\frac1r$, so $\theta=\sin^{-1}\frac1r$.
:holds-by: distance_of_the_first_two_points third_matrix_by_the_radius
:needs: negative_cosine_is_not_the_root | $0<\theta\le\frac\pi2$, as for a small step: for $\sin\theta=\frac45$, $r=\frac54$, the angle with $\cos\theta=-\frac35$ is not
  $\sin^{-1}\frac1r$, whose cosine is $\frac35$.
:figure: step_of_the_third_way
:::

:::{statement} hu-1987:1-3-third-matrix
:title: The matrix of the third way, by the radius
:zh: 用半径表示的旋转矩阵
:printed: With $\sin\theta=\varepsilon=\frac1r$, $\cos\theta=\sqrt{1-\sin^2\theta}=\sqrt{1-\varepsilon^2}$:
  $R=\begin{bmatrix}\sqrt{1-\varepsilon^2}&\varepsilon\\-\varepsilon&\sqrt{1-\varepsilon^2}\end{bmatrix}=\begin{bmatrix}\sqrt{r^2-1}/r&1/r\\-1/r&\sqrt{r^2-1}/r\end{bmatrix}$
:holds-by: third_matrix_by_the_radius
:needs: negative_cosine_is_not_the_root | $0<\theta<\frac\pi2$, so that the cosine is the positive root; and $r\ge1$
:figure: step_of_the_third_way
:::

:::{claim} third_matrix_by_the_radius
:title: The three forms of the matrix agree
:zh: 第三种方法矩阵的三种形式
:given: $0<\theta<\frac\pi2$ with the tangent $a$ of its half, $0<a<1$, $r=\frac1{\sin\theta}$
:then: $(1-\varepsilon^2)=\cos^2\theta$ and $(r^2-1)/r^2=\cos^2\theta$, with $\cos\theta>0$; the determinant is 1
:method: Identities in $a=\frac\alpha{1+\alpha}$, $\alpha>0$, by which the cosine is positive: it is the root.
:control: $r^2+1$ in the place of $r^2-1$
:::
*/
CLAIM(third_matrix_by_the_radius)
{
    num a = inside(T, "a"), one = from_int(1), M[4];
    struct G(turn) angle = G(turn_by)(a);
    num epsilon = angle.sin, r = div(one, epsilon), rr = mul(r, r), square = mul(angle.cos, angle.cos);
    G(rotation)(angle, M);
    same(T, sub(one, mul(epsilon, epsilon)), square);
    same(T, div(fault(T, sub(rr, one), add(rr, one)), rr), square);
    nonnegative(T, angle.cos);
    same(T, G(cross2)(M, M + 2), one);
}

#if RATIONAL
/*
:::{claim} negative_cosine_is_not_the_root
:title: Beyond a right angle the cosine is not the root
:zh: 钝角时余弦不等于算术根
:kind: counterexample
:given: cosine and sine of an obtuse angle $\theta$
:data: cos θ = -3/5; sin θ = 4/5
:instead: cos θ = 3/5
:then: $\sqrt{1-\sin^2\theta}\ne\cos\theta$
:result: √(1 - sin² θ) = 3/5
:method: Both numbers, exactly.
:control: the acute angle with this sine
:::
*/
CLAIM(negative_cosine_is_not_the_root)
{
    num cosine = given(T, "cos θ"), sine = given(T, "sin θ");
    num positive_root = root(2, sub(from_int(1), mul(sine, sine)));
    found(T, "√(1 - sin² θ)", positive_root);
    about(T, "the root of 1 - sin², and the cosine");
    same(T, positive_root, cosine);
}

/*
:::{claim} third_way_closes_for_two_radii
:title: For a whole radius the third way closes for r = 1 and r = 2 only
:zh: 整数半径时仅 r=1,2 闭合
:kind: decision
:given: $r=1,\dots,200$; $\tau=2-\frac4{r^2}$, the trace of $R^2$
:then: $\tau$ is an integer only for $r=1$ and $r=2$, where $R^4=1$ and $R^{12}=1$; otherwise no power of $R$ is 1
:method: The eigenvalues of $R^2$ are $\lambda$ and $1/\lambda$ with $\lambda+1/\lambda=\tau$; a root of unity has an algebraic integer
  there, and a rational one is whole.  For $r\ge3$, $0<\frac4{r^2}<1$.  Traces 2, $\pm1$, 0, $-2$ would remain: $\tau=-2$ and
  $\tau=1$ occur, with $R^4=1$ and $R^{12}=1$ by the recursion of the traces.
:scope: r = 1 to 200
:control: $r$ in the place of $r^2$
:::
*/
/* The least k <= most with V_k = 2 for the trace; 0 if there is none. */
static int order_of(num trace, int most)
{
    num before = from_int(2), V = trace;
    for (int k = 1; k <= most; k++) {
        if (equal_q(V, from_int(2)))
            return k;
        num next = sub(mul(trace, V), before);
        before = V, V = next;
    }
    return 0;
}

CLAIM(third_way_closes_for_two_radii)
{
    for (int r = 1; r <= 200; r++) {
        long square = fault(T, (long)r * r, r);
        num trace = sub(from_int(2), from_ratio(4, square));
        agree(T, is_whole_q(trace) == (r <= 2));
        agree(T, r > 2 || order_of(trace, 12) == (r == 1 ? 2 : 6));
        agree(T, r <= 2 || order_of(trace, 12) == 0);
    }
}
#endif

#include "chapters/judge/claims_off.h"
