/*
# One pixel at every step (以象素为步长)

The third way turns exactly, as the first one did, and chooses the angle by the screen: from one point to the next it
should be as far as one pixel (象素).
*/
#include "chapters/foundations/turning.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} hu-1987:1-3-third-rotation
:title: A point turned again and again gives a circle
:zh: 连续旋转生成圆
:printed: With $R=\begin{pmatrix}\cos\theta&\sin\theta\\-\sin\theta&\cos\theta\end{pmatrix}$, $[x_n\;y_n]R=[x_{n+1}\;y_{n+1}]$, that is
  $x_{n+1}=\cos\theta\,x_n-\sin\theta\,y_n$, $y_{n+1}=\sin\theta\,x_n+\cos\theta\,y_n$; turning a point
  continually, here about the $z$-axis, gives a circle as well.
:holds-by: rotation_matrix_adds_the_angle rotated_points_are_equally_spaced
:meant: the words of the first way, by which points of the circle at equal angles are computed (圆周上一系列等角度分布的点) | A circle is given by
  points: all of them are on one circle, and each is another point than the one before, from which it is turned by $\theta$.
:needs: centre_is_never_turned | the sentence after it, $y_1=r\sin\theta=1$ | $P_0=(x_0,y_0)\ne(0,0)$
:needs: angle_zero_turns_no_point | the angle of the sentence after it, $\theta=\sin^{-1}\frac1r$ | $\theta$ is no
  multiple of $2\pi$
:figure: three_generators

The claims call the angle of one step $\Delta\theta$, as the first way does; here it is $\theta$.
:::

The pixel is measured in two ways in one sentence, as the height of the second point and as its distance from the first.
The height is a leg of a right triangle whose hypotenuse is the distance, so the distance is larger.  For the large
radii that a screen has the two are nearly the same; for the smallest ones they are not.

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
:confirmed-by: distance_of_the_third_way_tends_to_a_pixel rotated_points_are_equally_spaced
:meant: the words, the distance of the two points (二点之间的距离), with nothing added | The distance along a straight line.
:reading: unit_height_is_not_unit_distance | with $y_1=1$ the two points are one pixel apart along a straight line
:reading: larger_difference_is_the_height | with $y_1=1$ the two points are one pixel apart in the rows and columns of a screen, where the distance is the larger of the two
  differences of the coordinates
:figure: step_of_the_third_way

For $0<\theta<\frac\pi2$ and $r\sin\theta=1$ the square of the distance is between 1 and $1+\frac1{r^2}$: `distance_of_the_third_way_tends_to_a_pixel`.
The height of $A_1$ is $r\sin\theta$ where the turning begins at $A_0=(r,0)$; the distance is the same wherever it begins:
`rotated_points_are_equally_spaced`.
:::
*/

#if RATIONAL
/*
:::{claim} unit_height_is_not_unit_distance
:title: At height one the second point is farther than one from the first
:zh: 高度为一而距离大于一
:kind: counterexample
:given: the radius $r$, $A_0=(r,0)$, and the cosine of the angle $\theta$ between 0 and $\pi$ by which it is turned to $A_1$
:data: r = 5/4; cos θ = 3/5
:then: $A_1$ has the height $r\sin\theta=1$, and $|A_0A_1|$ is more than 1
:result: (r sin θ)² = 1; |A_0A_1|² = 5/4
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
:then: $|A_0A_1|^2=(2r\sin\frac\theta2)^2=\frac{4r^2a^2}{1+a^2}$; for $r\sin\theta=1$ this is $1+a^2$; and for any $r$
  the square of the distance is 1 exactly for $\cos\theta=1-\frac1{2r^2}$
:method: The point by the rotation, in the field with $a$ and $r$ variables; then $r=\frac{1+a^2}{2a}$; and
  $2r^2(1-\cos\theta)-1=2r^2\bigl(1-\frac1{2r^2}-\cos\theta\bigr)$.
:scope: 0 < θ < π
:over: a: -; r: radius
:control: the distance as $r\sin\theta$
:::
*/
CLAIM(distance_of_the_first_two_points)
{
    num a = positive(T, "a", 0), r = positive(T, "r", 0), one = from_int(1), aa = mul(a, a), M[4], next[2];
    struct G(turn) angle = G(turn_by)(a);
    num from_sine = div(add(one, aa), mul(from_int(2), a)), first[2] = {r, from_int(0)};
    G(rotation)(angle, M);
    G(row_times)(first, M, next);
    num edge[2] = {sub(next[0], r), next[1]}, square = G(norm_squared)(2, edge), rr = mul(r, r);
    about(T, "the square of the distance");
    /* |A_0A_1|² = 4r²a²/(1 + a²) */
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
    /* 2r² (1 - cos θ) - 1 = 2r² (1 - 1/(2r²) - cos θ) */
    same(T, sub(square, one), mul(mul(from_int(2), rr), sub(wanted, angle.cos)));
}

/*
:::{claim} distance_of_the_third_way_tends_to_a_pixel
:title: For large radii the distance is nearly one pixel
:zh: 半径很大时距离趋于一个象素
:given: $0<\theta<\frac\pi2$ with the tangent $a$ of its half, $r=\frac1{\sin\theta}$
:then: $\frac1{r^2}-a^2=\frac{a^2(1-a^2)(3+a^2)}{(1+a^2)^2}>0$; so the square of the distance, $1+a^2$, is between 1 and $1+\frac1{r^2}$
:method: An identity in $a$, and the signs of coefficients for $a=\frac\alpha{1+\alpha}$, $\alpha>0$.
:scope: 0 < θ < π/2
:over: a: -
:control: $2+a^2$ in the place of $3+a^2$
:::
*/
CLAIM(distance_of_the_third_way_tends_to_a_pixel)
{
    num a = inside(T, "a"), aa = mul(a, a), one = from_int(1), below = add(one, aa);
    num sine = G(turn_by)(a).sin; /* 1/r */
    num factor = add(from_int(fault(T, 3, 2)), aa), gap = div(mul(aa, mul(sub(one, aa), factor)), mul(below, below));
    same(T, sub(mul(sine, sine), aa), gap);
    G(must_be_positive)(T, gap);
}

/*
:::{claim} larger_difference_is_the_height
:title: Of the differences of the coordinates of the first two points none is larger than the height
:zh: 首两点坐标差以高度为大
:given: $0<\theta\le\frac\pi2$ with the tangent $a$ of its half, $A_0=(r,0)$, $r=\frac1{\sin\theta}$
:then: the differences of the coordinates are $r-r\cos\theta=a$ and $r\sin\theta=1$; $0<a\le1$, so that none is larger than 1
:method: The point by the rotation, in the field, $a=\frac\alpha{1+\alpha}$, $\alpha>0$, and for $a=1$.
:scope: $0<\theta\le\frac\pi2$
:over: a: -
:control: the sum of the two
:::
*/
CLAIM(larger_difference_is_the_height)
{
    num acute = inside(T, "a"), one = from_int(1), M[4], next[2];
    for (int right_angle = 0; right_angle < 2; right_angle++) {
        num a = right_angle ? one : acute;
        struct G(turn) angle = G(turn_by)(a);
        num first[2] = {div(one, angle.sin), from_int(0)};
        G(rotation)(angle, M);
        G(row_times)(first, M, next);
        num across = sub(first[0], next[0]);
        about(T, "the difference of the abscissas");
        same(T, across, a);
        G(must_be_positive)(T, a);
        nonnegative(T, sub(one, a));
        about(T, "the larger difference");
        same(T, fault(T, next[1], add(next[1], across)), one);
    }
}

/*
With the height, the source computes the angle and then the matrix.  Both steps take an inverse: for $r>1$ there are
two angles between 0 and $\pi$ with this sine, and the cosine can be either of two roots; a small step means the smaller angle,
and the positive root.

:::{statement} hu-1987:1-3-third-angle
:title: The angle of the third way
:zh: 第三种方法的转角
:printed: From $y_1=r\sin\theta=1$: $\sin\theta=\frac1r$, so $\theta=\sin^{-1}\frac1r$.
:holds-by: third_matrix_by_the_radius
:confirmed-by: distance_of_the_first_two_points
:needs: negative_cosine_is_not_the_root | the words before it, that the two points are to be one pixel apart: with $y_1=1$ their distance is not exactly 1, but at most $\sqrt2$ for these angles, and more for an
    obtuse one |
    $0<\theta\le\frac\pi2$
:figure: step_of_the_third_way

With $r\sin\theta=1$ the square of the distance of the two points is $1+\tan^2\frac\theta2$, by `distance_of_the_first_two_points`; half of an obtuse angle has
a tangent greater than 1, so that this is more than 2, and otherwise it is at most 2.
:::

:::{statement} hu-1987:1-3-third-matrix
:title: The matrix of the third way, by the radius
:zh: 用半径表示的旋转矩阵
:printed: With $\sin\theta=\varepsilon=\frac1r$, $\cos\theta=\sqrt{1-\sin^2\theta}=\sqrt{1-\varepsilon^2}$:
  $R=\begin{bmatrix}\sqrt{1-\varepsilon^2}&\varepsilon\\-\varepsilon&\sqrt{1-\varepsilon^2}\end{bmatrix}=\begin{bmatrix}\sqrt{r^2-1}/r&1/r\\-1/r&\sqrt{r^2-1}/r\end{bmatrix}$
:holds-by: third_matrix_by_the_radius
:needs: negative_cosine_is_not_the_root | the angle of the sentence before it, $\theta=\sin^{-1}\frac1r$, where $r$ is a radius |
  $0<\theta\le\frac\pi2$; so that the cosine is the root that is not negative
:figure: step_of_the_third_way
:::

:::{claim} third_matrix_by_the_radius
:title: The three forms of the matrix agree
:zh: 第三种方法矩阵的三种形式
:given: $0<\theta\le\frac\pi2$ with the tangent $a$ of its half, $0<a\le1$; $\varepsilon=\sin\theta$, $r=\frac1{\sin\theta}$
:then: $1-\varepsilon^2=\cos^2\theta$ and $(r^2-1)/r^2=\cos^2\theta$, with $\cos\theta\ge0$, so that $\theta=\sin^{-1}\frac1r$; the rotation
  matrix has $\cos\theta$ twice in the diagonal, its other entries are $\varepsilon=\frac1r$ and $-\varepsilon=-\frac1r$, its determinant is 1
:method: Identities in $a=\frac\alpha{1+\alpha}$, $\alpha>0$, by which the cosine is positive, and for $a=1$, where it is 0: it is the root.
:scope: $0<\theta\le\frac\pi2$
:harmless: $0<a\le1$ | it is $0<\theta\le\frac\pi2$, $a=\tan\frac\theta2$
:over: a: -
:control: $r^2+1$ in the place of $r^2-1$
:::
*/
CLAIM(third_matrix_by_the_radius)
{
    num a = inside(T, "a"), one = from_int(1), M[4];
    for (int right_angle = 0; right_angle < 2; right_angle++) {
        struct G(turn) angle = G(turn_by)(right_angle ? one : a);
        num epsilon = angle.sin, r = div(one, epsilon), rr = mul(r, r), square = mul(angle.cos, angle.cos);
        G(rotation)(angle, M);
        same(T, sub(one, mul(epsilon, epsilon)), square);
        same(T, div(fault(T, sub(rr, one), add(rr, one)), rr), square);
        nonnegative(T, angle.cos);
        same(T, M[0], angle.cos);
        same(T, M[3], angle.cos);
        same(T, M[1], epsilon);
        same(T, M[1], div(one, r));
        same(T, M[2], neg(M[1]));
        same(T, G(cross2)(M, M + 2), one);
    }
}

#if RATIONAL
/*
:::{claim} negative_cosine_is_not_the_root
:title: Beyond a right angle the cosine is not the root
:zh: 钝角时余弦不等于算术根
:kind: counterexample
:given: cosine and sine of an obtuse angle $\theta$; the radius $r$ with $r\sin\theta=1$
:data: cos θ = -3/5; sin θ = 4/5
:instead: cos θ = 3/5
:then: $\sqrt{1-\sin^2\theta}\ne\cos\theta$; the cosine of $\sin^{-1}(\sin\theta)$ is that root, so that this angle is not $\theta$
:result: r = 5/4; √(1 - sin² θ) = 3/5
:method: Both numbers, exactly.
:control: the acute angle with this sine
:::
*/
CLAIM(negative_cosine_is_not_the_root)
{
    num cosine = given(T, "cos θ"), sine = given(T, "sin θ");
    num positive_root = root(2, sub(from_int(1), mul(sine, sine)));
    found(T, "r", div(from_int(1), sine));
    found(T, "√(1 - sin² θ)", positive_root);
    about(T, "the root of 1 - sin², and the cosine");
    same(T, positive_root, cosine);
}

/*
## Does the third way close?

The source does not ask whether the third way closes either.  For a whole radius $r$ the cosine is $\sqrt{r^2-1}/r$, in
general no rational number, but the matrix of two steps has a rational trace, and that is enough to decide it: a root of
unity plus its inverse is an algebraic integer, and a rational one of these is whole.

:::{claim} third_way_closes_for_two_radii
:title: Of the whole radii up to a bound the third way closes for r = 1 and r = 2 only
:zh: 整数半径时仅 r=1,2 闭合
:kind: decision
:given: $r=1,\dots,N$; $\tau=2-\frac4{r^2}$, the trace of $R^2$
:data: N = 200
:then: $\tau$ is an integer only for $r=1$ and $r=2$, where a power of $R$ is 1; otherwise no power of $R$ is 1
:result: τ for the radii 1, 2 = -2 1; order of R for the radii 1, 2 = 4 12
:method: The eigenvalues of $R^2$ are $\lambda$ and $1/\lambda$ with $\lambda+1/\lambda=\tau$; a root of unity has an algebraic integer
  there, and a rational one is whole.  For $r>2$, $0<\frac4{r^2}<1$.  Traces 2, $\pm1$, 0, $-2$ would remain: $\tau=-2$ and
  $\tau=1$ occur, and the recursion of the traces finds the power of $R^2$ that is 1.
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
    enum { MOST = 12 }; /* a whole trace belongs to an order of at most 6 */
    int largest = given_whole(T, "N");
    num closing[2], order[2];
    for (int r = 1; r <= largest; r++) {
        long square = fault(T, (long)r * r, r);
        num trace = sub(from_int(2), from_ratio(4, square));
        int k = order_of(trace, MOST);
        if (r <= 2) {
            closing[r - 1] = trace;
            order[r - 1] = from_int(2 * k); /* of R, when k is that of R^2 */
        }
        agree(T, is_whole_q(trace) == (r <= 2));
        agree(T, (k > 0) == (r <= 2));
    }
    found_points(T, "τ for the radii 1, 2", 2, 1, closing);
    found_points(T, "order of R for the radii 1, 2", 2, 1, order);
}
#endif

#include "chapters/judge/claims_off.h"
