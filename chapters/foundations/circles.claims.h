/*
# A point turned by a small angle (圆的生成)

To draw a circle by a machine that adds and shifts, one turns a point by a small angle again and again.  A step is a
matrix, $[x_{n+1}\;y_{n+1}]=[x_n\;y_n]\,T$, and everything that can be said about the drawing is said by the matrix.  Its
determinant tells whether the points drift outwards, an invariant quadratic form on which curve they stay, and whether its
eigenvalues are roots of unity (单位根) tells whether they ever come back.
*/
#include "chapters/foundations/turning.h"

#include "chapters/judge/claims_on.h"

/*
Three ways are printed.  The first turns by an exact rotation and is then simplified until nothing but shifts and
additions are left; the price is a spiral, and this section is about it.  The other two pay differently, and have
sections of their own.

## The first way

:::{statement} hu-1987:1-3-1
:title: One step of a rotation
:zh: 逆时针旋转一步
:printed: For a point $P_n=(x_n,y_n)$ of the circle of radius $r$, which an anticlockwise turn by $\Delta\theta$ takes to $P_{n+1}=(x_{n+1},y_{n+1})$:
  $x_{n+1}=r\cos(\theta+\Delta\theta)=r\cos\theta\cos\Delta\theta-r\sin\theta\sin\Delta\theta=x_n\cos\Delta\theta-y_n\sin\Delta\theta$,
  $y_{n+1}=r\sin(\theta+\Delta\theta)=r\sin\theta\cos\Delta\theta+r\cos\theta\sin\Delta\theta=y_n\cos\Delta\theta+x_n\sin\Delta\theta$
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

/*
:::{claim} rotation_matrix_adds_the_angle
:title: The row of the point times the matrix is the point of the sum of the angles
:zh: 旋转矩阵使角度相加
:given: any $r$, and two angles by the directions $(a_0,a_1)\ne(0,0)$ and $(b_0,b_1)\ne(0,0)$ of their halves, so that
  $\cos\theta=\frac{a_0^2-a_1^2}{a_0^2+a_1^2}$ and $\sin\theta=\frac{2a_0a_1}{a_0^2+a_1^2}$, likewise those of $\Delta\theta$
:harmless: $(a_0,a_1)\ne(0,0)$ and $(b_0,b_1)\ne(0,0)$ | so is the half of every angle
:then: for $(x_n,y_n)=r(\cos\theta,\sin\theta)$ the row $(x_n\cos\Delta\theta-y_n\sin\Delta\theta,\,x_n\sin\Delta\theta+y_n\cos\Delta\theta)$, the product of $[x_n\;y_n]$ and the
  matrix (1-3-2), is $r(\cos(\theta+\Delta\theta),\sin(\theta+\Delta\theta))$
:method: The sum of the angles is formed on the other side, from the direction $(a_0b_0-a_1b_1,\,a_0b_1+a_1b_0)$ of half of it; the five numbers
  are variables.
:over: a# b#: angles; r: radius
:control: the difference of the angles
:::
*/
CLAIM(rotation_matrix_adds_the_angle)
{
    struct G(half) a = G(free_half)(T, "a"), b = G(free_half)(T, "b"), used = {b.p, fault(T, b.q, neg(b.q))};
    struct G(turn) theta = G(turn_of)(a), sum = G(turn_of)(G(sum_of)(a, used));
    num r = positive(T, "r", 0), M[4], next[2], P[2] = {mul(r, theta.cos), mul(r, theta.sin)};
    G(rotation)(G(turn_of)(b), M);
    G(row_times)(P, M, next);
    same(T, next[0], mul(r, sum.cos));
    same(T, next[1], mul(r, sum.sin));
}

/*
The matrix is the addition theorem of cosine and sine, written as a row times a matrix, so $n$ steps are the $n$-th
power.  What has to be shown of the points is two things, that they stay on the circle and that they are equally far
apart; neither depends on where the point began.

:::{statement} hu-1987:1-3-equal-angles
:title: The first way computes points at equal angles on the circle
:zh: 圆周上等角度分布的点
:printed: With a $\Delta\theta$ of suitable size a sequence of points on the circle can be computed by this method, each from the one before, that are distributed at
  equal angles.
:holds-by: rotated_points_are_equally_spaced
:confirmed-by: rotation_matrix_adds_the_angle
:needs: centre_is_never_turned | the words above (1-3-1), a point of the circle of radius $r$ | $P_0\ne(0,0)$
:needs: angle_zero_turns_no_point | the words of suitable size (适当大小的 $\Delta\theta$) | $\Delta\theta$ is no
  multiple of $2\pi$
:figure: three_generators
:::
*/

#if RATIONAL
/* Whether one step with the given matrix moves the given point. */
static void refute_that_it_moves(trial *T, const num M[])
{
    num first[2], P[2];
    given_points(T, "P_0", 1, 2, first);
    P[0] = first[0], P[1] = first[1];
    G(steps)(1, M, P);
    found_points(T, "P_1", 1, 2, P);
    about(T, "whether P_1 is not P_0");
    refute(T, equal_q(P[0], first[0]) && equal_q(P[1], first[1]));
}

/* The same of the rotation whose angle has the given tangent a of its half. */
static void refute_that_a_turn_moves(trial *T)
{
    num M[4];
    G(rotation)(G(turn_by)(given(T, "a")), M);
    refute_that_it_moves(T, M);
}

/*
:::{claim} centre_is_never_turned
:title: The centre stays under a rotation
:zh: 旋转不动圆心
:kind: counterexample
:given: one step from $P_0$ to $P_1$ of the rotation about the origin whose angle has the tangent $a$ of its half
:data: a = 1; P_0 = (0,0)
:instead: P_0 = (1,0)
:then: $P_1=P_0$
:result: P_1 = (0,0)
:method: One step; that it moves the point is refuted.
:control: a point beside the centre
:::
*/
CLAIM(centre_is_never_turned) { refute_that_a_turn_moves(T); }

/*
:::{claim} angle_zero_turns_no_point
:title: A rotation by the angle 0 leaves every point where it is
:zh: 零转角不动任何点
:kind: counterexample
:given: one step from $P_0$ to $P_1$ of the rotation about the origin whose angle has the tangent $a$ of its half
:data: a = 0; P_0 = (3,4)
:instead: a = 1
:then: $P_1=P_0$: the points are one
:result: P_1 = (3,4)
:method: One step; that it moves the point is refuted.
:control: a right angle
:::
*/
CLAIM(angle_zero_turns_no_point) { refute_that_a_turn_moves(T); }
#endif

/*
:::{claim} rotated_points_are_equally_spaced
:title: All points are on the circle, at equal angles and distances
:zh: 点列在圆上,夹角与间距相等
:given: any point $P_n$, any angle $\Delta\theta$, by the direction $(a_0,a_1)\ne(0,0)$ of its half; the step $x_{n+1}=x_n\cos\Delta\theta-y_n\sin\Delta\theta$,
  $y_{n+1}=y_n\cos\Delta\theta+x_n\sin\Delta\theta$ of (1-3-1)
:harmless: $(a_0,a_1)\ne(0,0)$ | so is the half of every angle
:then: $x_{n+1}^2+y_{n+1}^2=x_n^2+y_n^2$, $P_n\cdot P_{n+1}=\cos\Delta\theta\,|P_n|^2$, $P_n\times P_{n+1}=\sin\Delta\theta\,|P_n|^2$ and
  $|P_{n+1}-P_n|^2=2(1-\cos\Delta\theta)\,|P_n|^2$; so all points are on one circle, each is turned by $\Delta\theta$ from the one before, and all
  distances are equal
:method: One step, the point, $a_0$ and $a_1$ variables.  By induction every radius is $|P_0|$, and with it every distance is the same.
:scope: every number of steps
:over: x y: point; a#: angles
:control: $\cos\Delta\theta$ replaced by 1
:::
*/
CLAIM(rotated_points_are_equally_spaced)
{
    num M[4], P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, Q[2] = {P[0], P[1]};
    struct G(turn) angle = G(turn_of)(G(free_half)(T, "a")), used = angle;
    used.cos = fault(T, used.cos, from_int(1));
    G(rotation)(used, M);
    G(steps)(1, M, Q);
    about(T, "the square of the radius");
    same(T, G(norm_squared)(2, Q), G(norm_squared)(2, P));
    about(T, "the angle: its cosine and its sine times the square of the radius");
    same(T, add(mul(P[0], Q[0]), mul(P[1], Q[1])), mul(angle.cos, G(norm_squared)(2, P)));
    same(T, G(cross2)(P, Q), mul(angle.sin, G(norm_squared)(2, P)));
    about(T, "the square of the distance");
    num edge[2] = {sub(Q[0], P[0]), sub(Q[1], P[1])}, factor = mul(from_int(2), sub(from_int(1), angle.cos));
    /* |P_{n+1} - P_n|² = 2 (1 - cos Δθ) |P_n|² */
    same(T, G(norm_squared)(2, edge), mul(factor, G(norm_squared)(2, P)));
}

/*
The source objects that cosine and sine have to be computed.  Only a prescribed angle needs them.  If a small step is
wanted, and any small step will do, then rational numbers $c$ and $s$ with $c^2+s^2=1$ turn just as exactly; they are
found by Pythagoras, or from the tangent of half the angle.

:::{statement} hu-1987:1-3-trigonometric
:title: The first way needs trigonometric functions
:zh: 需要三角函数计算
:printed: With hardware the algorithm needs products of matrices, and trigonometric functions have to be computed as well.
:holds-by: rotation_matrix_adds_the_angle
:meant: the words above, by which a suitable $\Delta\theta$ is chosen | The step is given by its angle.
:reading: rotation_matrix_adds_the_angle | the step is given by its angle, and the entries of the matrix, its cosine and its sine, have to be computed | They are functions of the
  angle alone.
:reading: rational_step_has_no_angle | any step that is small and always the same will do, and it needs trigonometric functions, too
:argued: | The entries of the matrix are functions of the angle alone, its cosine and its sine; where the step is given by its angle, these two have to be computed.
:figure: three_generators
:::
*/

#if RATIONAL
/*
:::{claim} rational_step_has_no_angle
:title: Equal steps on the circle without a trigonometric function
:zh: 不用三角函数的等步长旋转
:kind: counterexample
:given: the matrix $M$ of (1-3-2) with the numbers $\frac{1-a^2}{1+a^2}$ and $\frac{2a}{1+a^2}$ in the place of cosine and sine; $n$ steps
  from $P_0$
:data: P_0 = (1,0); n = 100; a = 1/16
:instead: ε = 1/8
:then: all points are on the circle about the origin through $P_0$, each at the distance $d$ from the one before
:result: M = (255/257,32/257) (-32/257,255/257); d² = 4/257
:method: The squares of radius and distance, exactly; the matrix takes the four operations only, no trigonometric function and no root;
  that one differs is refuted.
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
  $x_{n+1}=x_n-\Delta\theta\,y_n$, $y_{n+1}=\Delta\theta\,x_n+y_n$ (1-3-3).
:holds-by: small_step_is_the_rotation_to_first_order
:meant: the word approximately (近似地) | To first order in the angle.
:figure: three_generators

:::
*/

#if FIELD
/*
:::{claim} small_step_is_the_rotation_to_first_order
:title: The simplified matrix is the rotation to first order in the angle
:zh: 一阶近似
:types: field
:given: the matrix of (1-3-2), by which $[x\;y]$ becomes $(x\cos\Delta\theta-y\sin\Delta\theta,\,x\sin\Delta\theta+y\cos\Delta\theta)$; any point $(x,y)$ and any $e$; and the rotation by $\Delta\theta=2\arctan a$, so that
  $\frac{d\Delta\theta}{da}=\frac2{1+a^2}$
:then: with 1 and $e$ in the place of cosine and sine the row $(x,y)$ times the matrix is $(x-ey,\,ex+y)$, the printed step with $\Delta\theta=e$; at $a=0$ the
  rotation matrix is the unit matrix and its derivative with respect to $\Delta\theta$ is that of the step, $\begin{bmatrix}0&1\\-1&0\end{bmatrix}$
:method: The product with everything a variable; the matrix as a rational function of $a$, differentiated in the field; chain rule.
:scope: Δθ → 0
:over: x y e a: -
:control: the derivative with respect to $a$ taken for that with respect to $\Delta\theta$
:::
*/
CLAIM(small_step_is_the_rotation_to_first_order)
{
    num a = variable_f("a"), zero = from_int(0), one = from_int(1), M[4], S[4];
    num speed = fault(T, div(from_int(2), add(one, mul(a, a))), one);
    num P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, e = unknown(T, "e", 0), next[2];
    G(rotation)((struct G(turn)){one, e}, M);
    G(row_times)(P, M, next);
    about(T, "the step with 1 and e for cosine and sine");
    same(T, next[0], sub(P[0], mul(e, P[1])));
    same(T, next[1], add(mul(e, P[0]), P[1]));
    about(T, "the matrix at 0, or its derivative");
    G(rotation)(G(turn_by)(a), M);
    G(small_step)(one, S);
    for (int k = 0; k < 4; k++) {
        num unit = from_int(k == 0 || k == 3);
        same(T, substitute_f(M[k], a, zero), unit);
        /* dM/dΔθ = (dM/da)/(dΔθ/da) at a = 0 */
        same(T, substitute_f(div(derivative_f(M[k], a), speed), a, zero), sub(S[k], unit));
    }
}
#endif

/*
The simplified step keeps the trace 2 of an infinitely small rotation, and has a determinant larger than 1.  All that
follows, the growing radius and the curve that does not close, is in this determinant; the first order, which was kept,
says nothing about it.

:::{statement} hu-1987:1-3-5
:title: The simplified step (1-3-4) and its matrix
:zh: 简化递推的矩阵形式
:printed: If $\Delta\theta=\varepsilon=2^{-m}$, $m$ a positive whole number, then $x_{n+1}=x_n-\varepsilon y_n$, $y_{n+1}=\varepsilon x_n+y_n$ (1-3-4), in
  matrices (1-3-5)
  $[x_{n+1}\;y_{n+1}]=[x_n\;y_n]\begin{bmatrix}1&\varepsilon\\-\varepsilon&1\end{bmatrix}$.
:holds-by: small_step_matrix_is_the_recursion
:meant: (1-3-3), before it, in which $\cos\Delta\theta=1$ and $\sin\Delta\theta=\Delta\theta$ have been put | The points are those of (1-3-3), with $\varepsilon$ for $\Delta\theta$; not those of the rotation (1-3-1).
:figure: three_generators
:::

:::{claim} small_step_matrix_is_the_recursion
:title: The matrix gives the two formulas, and has the determinant 1 + ε²
:zh: 矩阵与递推一致
:given: any point, any $\varepsilon$
:then: the row times the matrix is $(x-\varepsilon y,\ \varepsilon x+y)$; the determinant is $1+\varepsilon^2$, the trace 2
:method: Identities in $x$, $y$ and $\varepsilon$.
:over: x y: point; e: ε
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
The gain is the speed: a product with $2^{-m}$ is a shift by $m$ places.  But a shift that drops what it moves out is no
product any more.  One must pay for each exact step with $m$ further binary places, or else accept that short
coordinates do not move at all; and since $\lfloor x/2^m\rfloor$ rounds negative numbers away from 0, the plane is not
treated alike in its four quadrants.

:::{statement} hu-1987:1-3-shift
:title: With a power of two the products are shifts
:zh: 用移位实现乘法
:printed: For $\varepsilon=2^{-m}$ with $m$ large enough, $\varepsilon x_n$ and $\varepsilon y_n$ are computed by shifting, and circles or
  arcs are generated at high speed.
:holds-by: exact_steps_need_m_more_bits_each
:meant: the words by shifts (通过移位运算), and the next sentence, in which the circle that is produced is not closed | High speed is: with shifts in the place of products.
  The circles or arcs are the points of (1-3-4), as the source calls them.
:hypothesis: short_registers_stop_the_point | the registers keep the bits that are shifted out: in $n$ steps the last bit of the
  point that is not 0 goes down by $nm$ places.
:confirmed-by: short_coordinates_never_move
:figure: circles_in_integers
:::
*/

#if RATIONAL
/*
:::{claim} exact_steps_need_m_more_bits_each
:title: In n exact steps the last bit that is not 0 goes down by n m places
:zh: 精确计算 n 步后末一非零位下移 nm 位
:kind: decision
:given: $P_0\ne(0,0)$ of binary coordinates, $2^b$ the power with which $2^bP_0$ has whole coordinates of which one is odd, $b$ any integer; $\varepsilon=2^{-m}$, $m\ge1$, any
  number $n$ of steps (1-3-4), $x_{n+1}=x_n-\varepsilon y_n$, $y_{n+1}=\varepsilon x_n+y_n$; $X=2^{nm+b}x_n$, $Y=2^{nm+b}y_n$
:harmless: $P_0\ne(0,0)$ | the scope says so
:then: $X$ and $Y$ are integers, and one of them is odd: shifts suffice, and no shorter words do
:method: The next two numbers are $2^mX-Y$ and $X+2^mY$; since $2^m$ is even, they have the remainders of $Y$ and $X$ modulo
  2.  All remainders of $X$ and $Y$ that are not both even are tried, then it is induction.
:scope: every m from 1 on, every number of steps from any point of binary coordinates but (0, 0)
:control: $2^m$ odd
:::
*/
CLAIM(exact_steps_need_m_more_bits_each)
{
    num half = from_ratio(1, 2), power = from_int(fault(T, 2, 1)); /* 2^m, an even number */
    /* the remainders of X and Y, not both even */
    for (int pair = 1; pair <= 3; pair++) {
        num X = from_int(pair & 1), Y = from_int(pair >> 1);
        num x = sub(mul(power, X), Y), y = add(X, mul(power, Y));
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
:given: one step of (1-3-4), $x_1=x_0-\varepsilon y_0$, $y_1=\varepsilon x_0+y_0$, $\varepsilon=2^{-m}$, in whole numbers; shifts that drop the bits shifted out
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
:title: Points with coordinates from 0 to 2^m - 1 stand still, and those with an ordinate from -2^m to -1 do not
:zh: 非负短坐标的点不动
:kind: decision
:given: every $m=1,\dots,M$ and all $x,y=0,\dots,2^m-1$, and $y=-2^m,\dots,-1$; shifts that drop the bits shifted out, $\lfloor x/2^m\rfloor$; and one point with a
  negative ordinate, for one $m$
:data: M = 6; m = 4; x_0 = 10; y_0 = -5
:then: $x_1=x$, $y_1=y$ for all of the former; the points with the negative ordinates, one of which is shown, move to the right, because $\lfloor y/2^m\rfloor$ is $-1$
:result: x_1 = 11; y_1 = -5
:method: The step in integers; what is added to one coordinate depends on the other one only, of which all are tried.
:scope: m = 1 to 6
:control: coordinates up to $2^m$
:::
*/
CLAIM(short_coordinates_never_move)
{
    int largest = given_whole(T, "M");
    for (int m = 1; m <= largest; m++) {
        int unit = 1 << m, most = fault(T, unit - 1, unit);
        for (int x = 0; x <= most; x++) /* a coordinate, either one */
            vanishes(T, from_int(floor_quotient(x, unit)));
        for (int y = -unit; y < 0; y++)
            same(T, from_int(floor_quotient(y, unit)), from_int(-1));
    }
    int unit = 1 << given_whole(T, "m"), x = given_whole(T, "x_0"), y = given_whole(T, "y_0");
    found_whole(T, "x_1", x - floor_quotient(y, unit));
    found_whole(T, "y_1", y + floor_quotient(x, unit));
    same(T, from_int(floor_quotient(y, unit)), from_int(-1));
    vanishes(T, from_int(floor_quotient(x, unit)));
}
#endif

/*
A circle closes when its points come back.  Here each step multiplies the radius by $\sqrt{1+\varepsilon^2}$, the same
number every time, so the points come back never, and leave every bounded region.  The print speaks of a tendency; it is
a geometric progression.

:::{statement} hu-1987:1-3-not-closed
:title: The simplified circle does not close
:zh: 简化算法所得的圆不封闭
:printed: The circle that this algorithm produces is not closed.
:holds-by: small_steps_multiply_the_radius radius_of_small_steps_exceeds_every_bound
:needs: small_step_of_zero_stays | the line above (1-3-4), $\Delta\theta=\varepsilon=2^{-m}$ | $\varepsilon\ne0$
:needs: centre_is_never_left | the words above (1-3-1), a point of the circle of radius $r$ | $P_0\ne(0,0)$
:figure: three_generators
:::

:::{statement} hu-1987:1-3-radius-grows
:title: The radius of the simplified circle keeps growing
:zh: 半径有不断增大的趋势
:printed: The radius of the circle has the tendency to increase continually.
:holds-by: small_steps_multiply_the_radius radius_of_small_steps_exceeds_every_bound
:confirmed-by: turn_of_small_steps_gains_a_fifth
:needs: small_step_of_zero_stays | the line above (1-3-4), $\Delta\theta=\varepsilon=2^{-m}$ | $\varepsilon\ne0$
:needs: centre_is_never_left | the words above (1-3-1), a point of the circle of radius $r$ | $P_0\ne(0,0)$
:figure: radius_of_the_first_way

It is more than a tendency: $|P_n|=\sqrt{1+\varepsilon^2}^n\,|P_0|$, exactly.  With $\varepsilon=\frac1{16}$ a turn takes a hundred steps and a part of one, and the
radius at its end is between $\frac65$ and $\frac54$ of the first one: `turn_of_small_steps_gains_a_fifth`.
:::

:::{claim} small_steps_multiply_the_radius
:title: Every step multiplies the radius by the same number
:zh: 半径按等比增长
:given: any point $P_n$, any $\varepsilon$; the step (1-3-4), $x_{n+1}=x_n-\varepsilon y_n$, $y_{n+1}=\varepsilon x_n+y_n$
:then: $x_{n+1}^2+y_{n+1}^2=(1+\varepsilon^2)(x_n^2+y_n^2)$; so $x_n^2+y_n^2=(1+\varepsilon^2)^n(x_0^2+y_0^2)$
:method: One step, point and $\varepsilon$ variables, then induction; the factor is the determinant.
:scope: every number of steps
:over: x y: point; e: ε
:control: the factor $1+\varepsilon$
:::
*/
CLAIM(small_steps_multiply_the_radius)
{
    num P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, Q[2] = {P[0], P[1]}, epsilon = unknown(T, "e", 0), M[4];
    G(small_step)(epsilon, M);
    G(steps)(1, M, Q);
    num factor = add(from_int(1), mul(epsilon, fault(T, epsilon, from_int(1))));
    /* |P_{n+1}|² = (1 + ε²) |P_n|² */
    same(T, G(norm_squared)(2, Q), mul(factor, G(norm_squared)(2, P)));
}

/*
:::{claim} radius_of_small_steps_exceeds_every_bound
:title: The number that multiplies the square of the radius in n steps grows with n, and exceeds every bound
:zh: n 步后半径平方的倍数递增且无界
:given: $\varepsilon\ne0$, any $n$, and $E_n=(1+\varepsilon^2)^n-1-n\varepsilon^2$
:where: $\varepsilon\ne0$
:then: $E_{n+1}=(1+\varepsilon^2)E_n+n\varepsilon^4$; so with $E_0=0$ no $E_n$ is negative, and $(1+\varepsilon^2)^n\ge1+n\varepsilon^2$, by which $n$
  steps multiply the square of a radius, grows with $n$ and exceeds every bound
:method: One step, with $E_n$, $n$ and $\varepsilon^2>0$ variables; what comes out has no negative coefficient.  The rest is
  induction.
:scope: every number of steps
:over: e E n: -
:control: $n+2$ in the place of $n+1$ in the product $(n+1)\varepsilon^2$
:::
*/
CLAIM(radius_of_small_steps_exceeds_every_bound)
{
    num square = positive(T, "e", 0), excess = positive(T, "E", 0), n = positive(T, "n", 0), one = from_int(1); /* ε² */
    num whole_power = add(excess, add(one, mul(n, square))); /* (1 + ε²)^n */
    num least = add(one, mul(add(n, from_int(fault(T, 1, 2))), square));
    num next = sub(mul(whole_power, add(one, square)), least);
    /* E_{n+1} = (1 + ε²) E_n + n ε⁴ */
    num as_told = add(mul(add(one, square), excess), mul(n, mul(square, square)));
    same(T, next, as_told);
    nonnegative(T, as_told);
}

#if RATIONAL
/*
:::{claim} turn_of_small_steps_gains_a_fifth
:title: The steps of a turn, counted, and the radius at its end between two bounds
:zh: 一周约百步,半径增大逾五分之一
:kind: decision
:given: $P_0$, $\varepsilon$, half a turn of $k$ steps and a whole one of $n$, each with a part of one step more; bounds $b$ of the radius
:data: P_0 = (1,0); ε = 1/16; k = 50; n = 100; b = 6/5 5/4
:instead: ε = 1/15
:then: the points from 1 to $k$ are above the axis, those from $k+1$ to $n$ below, the next one is above it again; $|P_n|$ is between the bounds
:method: All steps, exactly; squares of radii.  No step is as long as half a turn.
:control: a longer step
:::
*/
CLAIM(turn_of_small_steps_gains_a_fifth)
{
    num M[4], P[2], bound[2];
    given_points(T, "P_0", 1, 2, P);
    G(small_step)(given(T, "ε"), M);
    int half = given_whole(T, "k"), turn = given_whole(T, "n");
    given_points(T, "b", 2, 1, bound);
    for (int k = 1; k <= turn + 1; k++) {
        G(steps)(1, M, P);
        about(T, "the side of the axis");
        agree(T, sign_q(P[1]) == (k <= half || k > turn ? 1 : -1));
        if (k != turn)
            continue;
        num square = G(norm_squared)(2, P);
        about(T, "the radius of the last point of the turn");
        agree(T, compare_q(mul(bound[0], bound[0]), square) < 0 && compare_q(square, mul(bound[1], bound[1])) < 0);
    }
}

/* Whether one step with the given ε moves the given point. */
static void refute_that_a_step_moves(trial *T)
{
    num M[4];
    G(small_step)(given(T, "ε"), M);
    refute_that_it_moves(T, M);
}

/*
:::{claim} small_step_of_zero_stays
:title: A step of zero closes at once
:zh: 步长为零时不动
:kind: counterexample
:given: one step of (1-3-5), $x_1=x_0-\varepsilon y_0$, $y_1=\varepsilon x_0+y_0$, from $P_0$ to $P_1$
:data: ε = 0; P_0 = (1,0)
:instead: ε = 1/16
:then: $P_1=P_0$
:result: P_1 = (1,0)
:method: One step; that it moves the point is refuted.
:control: a small step
:::
*/
CLAIM(small_step_of_zero_stays) { refute_that_a_step_moves(T); }
#endif

#if RATIONAL
/*
:::{claim} centre_is_never_left
:title: A point at the centre stays there
:zh: 圆心处的点不动
:kind: counterexample
:given: one step of (1-3-5), $x_1=x_0-\varepsilon y_0$, $y_1=\varepsilon x_0+y_0$, from $P_0$ to $P_1$
:data: ε = 1/16; P_0 = (0,0)
:instead: P_0 = (1,0)
:then: $P_1=P_0$
:result: P_1 = (0,0)
:method: One step; that it moves the point is refuted.
:control: a point beside the centre
:::
*/
CLAIM(centre_is_never_left) { refute_that_a_step_moves(T); }
#endif

/*
:::{statement} hu-1987:1-3-perpendicular
:title: The small vector that is added is perpendicular to the radius
:zh: 增量与位置矢量垂直
:printed: $P_{n+1}$ is $P_n$ plus a small vector perpendicular to the position vector $P_n=[x_n,y_n]$; so the new radius is
  often larger than the one before.
:holds-by: small_step_adds_a_perpendicular_vector small_steps_multiply_the_radius
:needs: small_step_of_zero_stays | the line above (1-3-4), $\Delta\theta=\varepsilon=2^{-m}$ | $\varepsilon\ne0$
:needs: centre_is_never_left | the words above (1-3-1), a point of the circle of radius $r$ | $P_0\ne(0,0)$
:figure: radius_of_the_first_way

The new radius is larger after every step: $|P_{n+1}|^2=(1+\varepsilon^2)|P_n|^2$.
:::
*/

/*
:::{claim} small_step_adds_a_perpendicular_vector
:title: The step is at a right angle to the radius, and a fixed share of its length
:zh: 增量垂直于位置矢量
:given: any point $P_n$, any $\varepsilon$; the step (1-3-4), $x_{n+1}=x_n-\varepsilon y_n$, $y_{n+1}=\varepsilon x_n+y_n$
:then: $(P_{n+1}-P_n)\cdot P_n=0$ and $|P_{n+1}-P_n|^2=\varepsilon^2|P_n|^2$, whence $|P_{n+1}|^2=|P_n|^2+\varepsilon^2|P_n|^2$ by Pythagoras
:method: Identities in the point and $\varepsilon$.
:over: x y: point; e: ε
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
In complex numbers the step is the product with $1+i\varepsilon$, and this one number tells both halves of the story:
its argument, $\arctan\varepsilon$, is the angle of a step, and its modulus is the factor of the radius.  Equal angles
with equal factors make a logarithmic spiral (对数螺线).

:::{statement} hu-1987:1-3-spiral
:title: The points of the simplified circle are on a spiral
:zh: 所得曲线为螺线
:printed: The curve obtained is really not an exact arc of a circle, but a spiral.
:holds-by: small_steps_are_powers_of_a_complex_number small_steps_multiply_the_radius four_small_steps_are_on_no_circle
:confirmed-by: radius_of_small_steps_exceeds_every_bound
:needs: small_step_of_zero_stays | the line above (1-3-4), $\Delta\theta=\varepsilon=2^{-m}$ | $\varepsilon\ne0$
:needs: centre_is_never_left | the words above (1-3-1), a point of the circle of radius $r$ | $P_0\ne(0,0)$
:figure: three_generators

It is the logarithmic spiral: every step adds the angle $\arctan\varepsilon$, and multiplies the radius by
$\sqrt{1+\varepsilon^2}$.  No four successive points are on a circle, about whatever centre, so that not even a short piece is an
arc of one.
:::

:::{claim} small_steps_are_powers_of_a_complex_number
:title: The points are the powers of one complex number
:zh: 点列为复数的幂
:given: any first point, any $\varepsilon$; the step (1-3-4), $x_{n+1}=x_n-\varepsilon y_n$, $y_{n+1}=\varepsilon x_n+y_n$; any complex number $z=u+iv$, and
  $x_n+iy_n=z\,(x_0+iy_0)$
:then: $x_{n+1}+iy_{n+1}=(1+i\varepsilon)\,z\,(x_0+iy_0)$; so with $z=(1+i\varepsilon)^n$, from $z=1$ on,
  $x_n+iy_n=(1+i\varepsilon)^n(x_0+iy_0)$, and in every step the argument grows by $\arctan\varepsilon$, and the radius is
  multiplied by $|1+i\varepsilon|$
:method: One step against the product of complex numbers, everything a variable; then induction.
:scope: every number of steps
:over: x y: point; e: ε; u v: -
:control: the sign of $\varepsilon$ in the product
:::
*/
CLAIM(small_steps_are_powers_of_a_complex_number)
{
    num P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, z[2] = {unknown(T, "u", 0), unknown(T, "v", 0)};
    num epsilon = unknown(T, "e", 0), M[4], turned = fault(T, epsilon, neg(epsilon));
    num Q[2] = {sub(mul(z[0], P[0]), mul(z[1], P[1])), add(mul(z[0], P[1]), mul(z[1], P[0]))};
    num next[2] = {sub(z[0], mul(turned, z[1])), add(z[1], mul(turned, z[0]))}; /* (1 + iε) z */
    G(small_step)(epsilon, M);
    G(steps)(1, M, Q);
    /* x_{n+1} + i y_{n+1} = (1 + iε) z (x_0 + i y_0), real and imaginary part */
    same(T, Q[0], sub(mul(next[0], P[0]), mul(next[1], P[1])));
    same(T, Q[1], add(mul(next[0], P[1]), mul(next[1], P[0])));
}

/*
:::{claim} four_small_steps_are_on_no_circle
:title: No four successive points are on a circle or a line
:zh: 相继四点不共圆
:given: any point $P_n=(x,y)$ but the origin, any $\varepsilon\ne0$
:where: $\varepsilon\ne0$; $P_0\ne(0,0)$
:then: the determinant of the four rows $(x_k^2+y_k^2,\ x_k,\ y_k,\ 1)$, $k=n,\dots,n+3$, is $-\varepsilon^7(1+\varepsilon^2)(x^2+y^2)^2$, which is not 0
:method: Four points of a circle or a line $\alpha(x^2+y^2)+\beta x+\gamma y+\delta=0$ have the determinant 0.  An identity in the point and $\varepsilon$, from
  the rows by subtraction of the first one; $P_n$ is not the origin when $P_0$ is not, by `small_steps_multiply_the_radius`.
:scope: every number of steps
:over: x y: point; e: ε
:control: the matrix of a rotation
:::
*/
CLAIM(four_small_steps_are_on_no_circle)
{
    enum { space = 3 };
    num P[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, epsilon = unknown(T, "e", 0), one = from_int(1), M[4];
    num first[space] = {G(norm_squared)(2, P), P[0], P[1]}, rows[space * space];
    if (T->faulty)
        G(rotation)(G(turn_by)(epsilon), M);
    else
        G(small_step)(epsilon, M);
    for (int k = 0; k < space; k++) {
        G(steps)(1, M, P);
        num row[space] = {G(norm_squared)(2, P), P[0], P[1]};
        for (int j = 0; j < space; j++)
            rows[k * space + j] = sub(row[j], first[j]);
    }
    num square = mul(epsilon, epsilon),
        expected = mul(G(power)(epsilon, 7), mul(add(one, square), mul(first[0], first[0])));
    /* the column of ones, once the first row is subtracted, leaves the 3 × 3 determinant of the others, with the sign - */
    same(T, G(det3)(rows, rows + space, rows + 2 * space), expected);
}

#include "chapters/judge/claims_off.h"
