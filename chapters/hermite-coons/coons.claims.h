/*
# A surface in a frame of curves (Coons 曲面)

Two opposite curves are joined by a ruled surface; so are the two others.  The sum of both surfaces has too much at every
border, and what it has too much is the surface of the four corners.  Taken away, it leaves a surface with the four
curves as its borders: a Boolean sum (布尔和).  The same is done with curves and derivatives across them.
*/
#include "chapters/hermite-coons/definition.h"

#include "chapters/judge/claims_on.h"

enum { most_data = 4 };

/*
## Four curves

The notation of the slides names the borders by what is held fixed, $u0$ being the curve along which $w=0$, and drops the letter $P$
altogether.  It is short, and has to be learnt: $0w_u$ is a derivative across the border $0w$.

:::{statement} slides-ch4:3-notation
:title: Borders, tangents, derivatives across them and twists
:zh: 边界线、切向量、跨界切向量与扭曲向量
:definition: yes
:printed: $P(u,w)$, written $uw$, $0\le u,w\le1$: the borders $u0,u1,0w,1w$; the derivatives $uw_u$, $uw_w$, $uw_{uu}$, $uw_{uw}$, $uw_{ww}$ of the
  surface; along the border $u0$ the tangent $u0_u$, the derivative across it $u0_w$, and $u0_{uu}$, $u0_{ww}$; at the corners the points
  $00,01,10,11$ and the twists $00_{uw},01_{uw},10_{uw},11_{uw}$
:checked-by: tensor_kernel_is_the_matrix_product
:figure: boolean_sum

The surface of sixteen vectors has them as its points, tangents and twists at the corners.
:::

:::{statement} slides-ch4:3-blending-pair
:title: Two functions that blend the borders
:zh: 两个混合函数
:definition: yes
:printed: $f_0(t)$ and $f_1(t)$, $0\le t\le1$, are continuous, $f_0(0)=1$, $f_0(1)=0$, $f_1(0)=0$, $f_1(1)=1$, and $f_0(t)+f_1(t)=1$
:checked-by: four_curves_are_borders shifted_frame_shifts_the_patch_by_a_product
:confirmed-by: linear_interpolation_runs_along_straight_lines
:needs: blendings_without_end_values_lose_the_border | the conditions printed with the functions | the blending functions have
  the printed values at the ends: without them the borders are lost
:needs: blendings_without_sum_one_move_the_patch | the conditions printed with the functions | the blending functions have the
  sum 1: with it the patch of four border curves moves with them, without it this need not be so
:figure: boolean_sum

The end values keep the borders, the sum lets the surface move with its four curves; that the functions are continuous is not used.
:::
*/

static void G(any_data)(trial *T, const char *name, int count, num data[])
{
    for (int i = 0; i < count; i++)
        data[i] = unknown(T, name, i);
}

/* Compare on all borders: value 0 to m/2 - 1 across.  What runs across has its data in M, but for a fault in the last one
 * of them on the first border. */
static void G(borders_are_kept)(trial *T, int m)
{
    num M[most_data * most_data], along[most_data], free[most_data], P;
    G(any_data)(T, "m", m * m, M);
    G(any_data)(T, "x", m, along);
    G(any_data)(T, "f", m, free);
    for (int k = 0; k < m; k++) { /* the border k % 2, its value or its derivative across */
        num unit[most_data], across[most_data];
        for (int i = 0; i < m; i++)
            unit[i] = from_int(i == k);
        about(T, k < 2 ? "the value on a border" : "the derivative across a border");
        for (int j = 0; j < m; j++)
            across[j] =
                fault(T, M[k * m + j], k == m - 2 && j == m - 1 ? add(M[k * m + j], from_int(1)) : M[k * m + j]);
        G(coons_patch)(m, 1, unit, free, along, across, M, &P);
        same(T, P, along[k]);
        for (int j = 0; j < m; j++)
            across[j] = M[j * m + k];
        G(coons_patch)(m, 1, free, unit, across, along, M, &P);
        same(T, P, along[k]);
    }
}

/*
:::{claim} four_curves_are_borders
:title: The patch of four curves that meet has them as borders
:zh: 曲面以给定四曲线为边界
:given: corners, and at a border any value of its curve and of the blending functions of its parameter
:where: the curves meet at the corners
:then: the patch at $u=0$, $u=1$, $w=0$, $w=1$ is the value of $0w$, $1w$, $u0$, $u1$
:method: On a border the functions of the other parameter are 1 and 0 and the curves across are at their corners; no other property is used.
:over: m#: corners; x#: border curves; f#: blending functions
:control: one of the curves across does not end at its corner
:::
*/
CLAIM(four_curves_are_borders) { G(borders_are_kept)(T, 2); }

/*
:::{claim} shifted_frame_shifts_the_patch_by_a_product
:title: What a patch does when its frame is moved
:zh: 平移边框时曲面的变化
:given: any blending values with the sums $\alpha$ at $u$ and $\beta$ at $w$, any data, a shift $v$ of all curves and corners
:then: the point moves by $\bigl(1-(1-\alpha)(1-\beta)\bigr)v$: by $v$ wherever one of the sums is 1
:method: The kernel with both sets of data; everything variable.
:over: a# b#: blending functions; x# y#: border curves; m#: corners; v: shift
:control: the corners are not moved
:::
*/
CLAIM(shifted_frame_shifts_the_patch_by_a_product)
{
    num a[2], b[2], A[2], B[2], M[4], P, Q, v = unknown(T, "v", 0), one = from_int(1);
    G(any_data)(T, "a", 2, a);
    G(any_data)(T, "b", 2, b);
    G(any_data)(T, "x", 2, A);
    G(any_data)(T, "y", 2, B);
    G(any_data)(T, "m", 4, M);
    G(coons_patch)(2, 1, a, b, A, B, M, &P);
    for (int i = 0; i < 2; i++)
        A[i] = add(A[i], v), B[i] = add(B[i], v);
    for (int i = 0; i < 4; i++)
        M[i] = fault(T, add(M[i], v), M[i]);
    G(coons_patch)(2, 1, a, b, A, B, M, &Q);
    /* the shift is multiplied by 1 - (1 - alpha) (1 - beta) */
    num gap = mul(sub(one, add(a[0], a[1])), sub(one, add(b[0], b[1])));
    same(T, sub(Q, P), mul(sub(one, gap), v));
}

#if RATIONAL
/*
:::{claim} blendings_without_end_values_lose_the_border
:title: With functions that lack the end values a border is lost
:zh: 混合函数端点值不符则失去边界
:kind: counterexample
:data: f_0(0), f_1(0) = 1/2 1/2; f_0(w), f_1(w) = 1/2 1/2; w = 1/2
:instead: f_0(0), f_1(0) = 1 0
:result: height of 0w = 1/4; height of P(0,w) = 1/8
:given: two constant blending functions $f_0$, $f_1$, whose sum is 1; $0w=(0,w,w(1-w))$, the other borders straight, those of the unit square
:then: on the border the patch has another height than the curve
:method: The kernel, third coordinate.
:control: $f_0=1-t$, $f_1=t$
:::
*/
CLAIM(blendings_without_end_values_lose_the_border)
{
    num a[2], b[2], zero = from_int(0), P;
    given_points(T, "f_0(0), f_1(0)", 2, 1, a);
    given_points(T, "f_0(w), f_1(w)", 2, 1, b);
    num w = given(T, "w"), height = mul(w, sub(from_int(1), w));
    num A[2] = {height, zero}, B[2] = {zero, zero}, M[4] = {zero, zero, zero, zero};
    coons_patch_q(2, 1, a, b, A, B, M, &P);
    found(T, "height of 0w", height);
    found(T, "height of P(0,w)", P);
    about(T, "the heights of P(0,w) and of 0w");
    same(T, P, height);
}
#endif

/* P_1 and P_2, and P_3, as printed. */
static num G(ruled)(const num f[2], const num curve[2]) { return add(mul(f[0], curve[0]), mul(f[1], curve[1])); }

static num G(of_corners)(const num f[2], const num g[2], const num M[4])
{
    num first = mul(f[0], add(mul(g[0], M[0]), mul(g[1], M[1])));
    return add(first, mul(f[1], add(mul(g[0], M[2]), mul(g[1], M[3]))));
}

#if RATIONAL
/*
:::{claim} blendings_without_sum_one_bend_a_ruling
:title: With functions whose sum is not 1 two points are joined by a curve
:zh: 混合函数之和不为一时直母线弯曲
:kind: counterexample
:data: u = 1/2; 0w, 1w = (0,0,1) (1,0,1)
:result: P_1(u,w) = (1/4,0,1/2)
:given: $f_0=(1-u)^2$, $f_1=u^2$, which have the end values; the points of $0w$ and $1w$ for one $w$, and half way between them $u$
:then: $P_1(u,w)$ is below the line through the two points, whose height is 1
:method: The sum, coordinate by coordinate.
:control: $f_0=1-u$, $f_1=u$
:::
*/
CLAIM(blendings_without_sum_one_bend_a_ruling)
{
    num u = given(T, "u"), v = sub(from_int(1), u), ends[2 * 3], P[3];
    given_points(T, "0w, 1w", 2, 3, ends);
    num f[2] = {fault(T, v, mul(v, v)), fault(T, u, mul(u, u))};
    for (int c = 0; c < 3; c++)
        P[c] = ruled_q(f, (num[]){ends[c], ends[3 + c]});
    found_points(T, "P_1(u,w)", 1, 3, P);
    about(T, "the heights of P_1(u,w) and of the line");
    same(T, P[2], ends[2]);
}
#endif

/*
The two ruled surfaces are averages, each of two opposite curves.  Their sum has on every border the curve that is wanted and one more,
the straight one between two corners; and this is what the third surface has there as well.

:::{statement} slides-ch4:3-ruled
:title: Two ruled surfaces and the surface of the corners
:zh: 两张直纹面与角点曲面
:printed: By linear interpolation in the direction $u$ the ruled surface $P_1(u,w)=f_0(u)\,0w+f_1(u)\,1w$, in the direction $w$ $P_2(u,w)=f_0(w)\,u0+f_1(w)\,u1$, $P_3(u,w)=f_0(u)f_0(w)\,00+f_0(u)f_1(w)\,01+f_1(u)f_0(w)\,10+f_1(u)f_1(w)\,11$, where $f_0+f_1=1$, $0\le u,w\le1$
:definition: yes
:checked-by: linear_interpolation_runs_along_straight_lines
:confirmed-by: sum_of_ruled_surfaces_has_too_much
:needs: blendings_without_sum_one_bend_a_ruling | the conditions printed with the functions | $f_0+f_1=1$: else the
  curves of $P_1$ from $0w$ to $1w$ need not be straight
:figure: boolean_sum

In the text at hand the three sums have no signs.
:::

:::{claim} linear_interpolation_runs_along_straight_lines
:title: Through every point of the three surfaces runs a straight line from border to border
:zh: 三张曲面均为直纹面
:given: points of the border curves and corners in space, values of the blending functions with $f_0+f_1=1$
:where: $f_0+f_1=1$
:then: $P_1=0w+f_1(u)(1w-0w)$, so that for each $w$ it runs on the line from $0w$ to $1w$; $P_2=u0+f_1(w)(u1-u0)$, on the line from
  $u0$ to $u1$; and $P_3$ is on the line between the points of two opposite sides of the quadrangle of the corners, either way
:method: Coordinate by coordinate, $f_1(u)$ and $f_1(w)$ being variables.  What depends on $w$ alone, or on $u$ alone, is fixed on the line.
:over: f#: blending functions; x# y#: border curves; m#: corners
:control: $f_0=f_1$
:::
*/
/* Compare: f_0 A + f_1 B with A + f_1 (B - A). */
static void G(compare_with_line)(trial *T, const num f[2], num A, num B)
{
    same(T, G(ruled)(f, (num[]){A, B}), add(A, mul(f[1], sub(B, A))));
}

CLAIM(linear_interpolation_runs_along_straight_lines)
{
    num one = from_int(1), f1 = unknown(T, "f", 0), g1 = unknown(T, "f", 1);
    num f[2] = {fault(T, sub(one, f1), f1), f1}, g[2] = {fault(T, sub(one, g1), g1), g1}; /* of u, of w */
    for (int c = 0; c < 3; c++) {
        num across[2], along[2], M[4];
        for (int i = 0; i < 2; i++)
            across[i] = unknown(T, "x", 2 * c + i), along[i] = unknown(T, "y", 2 * c + i);
        for (int i = 0; i < 4; i++)
            M[i] = unknown(T, "m", 4 * c + i);
        about(T, "a ruling of P_1, and of P_2");
        G(compare_with_line)(T, f, across[0], across[1]);
        G(compare_with_line)(T, g, along[0], along[1]);
        about(T, "the two rulings of P_3");
        num P3 = G(of_corners)(f, g, M); /* rows: u, columns: w */
        num low = G(ruled)(g, M), high = G(ruled)(g, M + 2), left = G(ruled)(f, (num[]){M[0], M[2]});
        num right = G(ruled)(f, (num[]){M[1], M[3]});
        same(T, P3, add(low, mul(f[1], sub(high, low))));
        same(T, P3, add(left, mul(g[1], sub(right, left))));
    }
}

/*

:::{statement} slides-ch4:3-sum-of-ruled
:title: The sum of the ruled surfaces is moved from the four borders by an interpolation of the corners
:zh: 叠加曲面 Ps 的位移
:printed: For any point of $P_s=P_1+P_2$ one part of the displacement is due to the linear interpolation and one to the border curves; to remove
  the former a new surface $P_3$ is built.
:holds-by: sum_of_ruled_surfaces_has_too_much sum_of_ruled_surfaces_has_two_parts
:hypothesis: open_corner_loses_the_border | the curves meet at the corners
:needs: blendings_without_end_values_lose_the_border | the conditions printed with the functions | $f_0(0)=f_1(1)=1$,
  $f_0(1)=f_1(0)=0$
:meant: the curves that have to be the borders, from which the displacement is measured, and the surface that is then taken away | The part due to the linear
  interpolation is $P_3$.
:figure: boolean_sum

$P_3$ is what $P_1$ is on the borders $w=0,1$, and $P_2$ on the borders $u=0,1$.  At every point $P_s$ is twice $P_3$, plus what the border
curves differ from the interpolation of their corners; when $P_3$ is taken away, it is still there once.
:::

:::{claim} sum_of_ruled_surfaces_has_too_much
:title: On each border the sum exceeds the curve by the surface of the corners
:zh: 边界上多出的恰为角点插值
:given: four curves that meet at the corners, values of the blending functions with $f_0(0)=f_1(1)=1$, $f_0(1)=f_1(0)=0$
:then: $P_s-P_3$ is the border curve on each of the four borders; for $u=0,1$ it is $P_2$, for $w=0,1$ it is $P_1$ that equals $P_3$
:method: On a border one pair of blending functions has its values at the end, and the curves across are at corners; the values of the
  other pair and of the border curve are variables.
:scope: the four borders
:over: f#: blending functions; x#: border curves; m#: corners
:control: $f_0$ and $f_1$ exchanged in $P_2$
:::
*/
CLAIM(sum_of_ruled_surfaces_has_too_much)
{
    num M[4], free[2], border = unknown(T, "x", 0), other = unknown(T, "x", 1);
    G(any_data)(T, "m", 4, M);
    G(any_data)(T, "f", 2, free);
    for (int end = 0; end < 2; end++) {
        num unit[2] = {from_int(end == 0), from_int(end == 1)};
        num curves[2] = {end == 0 ? border : other, end == 0 ? other : border}; /* along this border, opposite */
        num u_corners[2] = {M[2 * end], M[2 * end + 1]}, w_corners[2] = {M[end], M[2 + end]};
        num swapped[2] = {free[1], free[0]};
        num P1 = G(ruled)(unit, curves), P2 = G(ruled)(fault(T, free, swapped), u_corners);
        num P3 = G(of_corners)(unit, free, M);
        about(T, "u = 0 and u = 1");
        same(T, sub(add(P1, P2), P3), border);
        same(T, P2, P3);
        P2 = G(ruled)(unit, curves), P1 = G(ruled)(free, w_corners);
        P3 = G(of_corners)(free, unit, M);
        about(T, "w = 0 and w = 1");
        same(T, sub(add(P1, P2), P3), border);
        same(T, P1, P3);
    }
}

/*
:::{claim} sum_of_ruled_surfaces_has_two_parts
:title: Everywhere the sum is twice the surface of the corners, and what the border curves add
:zh: 叠加曲面处处分为角点插值与边界偏差两部分
:given: any values of the blending functions, any corners, any points of the border curves; $\delta_{0w}=0w-f_0(w)\,00-f_1(w)\,01$, in the same way $\delta_{1w}$
  with $10,11$, and $\delta_{u0}=u0-f_0(u)\,00-f_1(u)\,10$, $\delta_{u1}$ with $01,11$
:then: $P_s=2P_3+f_0(u)\,\delta_{0w}+f_1(u)\,\delta_{1w}+f_0(w)\,\delta_{u0}+f_1(w)\,\delta_{u1}$
:method: The surfaces as printed; everything a variable.  The first part has the corners and no curve, the second is 0 where the curves interpolate
  their corners.
:scope: every point
:over: f# g#: blending functions; x# y#: border curves; m#: corners
:control: one $P_3$
:::
*/
CLAIM(sum_of_ruled_surfaces_has_two_parts)
{
    num f[2], g[2], across[2], along[2], M[4], d_across[2], d_along[2]; /* 0w and 1w, u0 and u1 */
    G(any_data)(T, "f", 2, f);
    G(any_data)(T, "g", 2, g);
    G(any_data)(T, "x", 2, across);
    G(any_data)(T, "y", 2, along);
    G(any_data)(T, "m", 4, M);
    for (int i = 0; i < 2; i++) {
        d_across[i] = sub(across[i], G(ruled)(g, M + 2 * i));
        d_along[i] = sub(along[i], G(ruled)(f, (num[]){M[i], M[2 + i]}));
    }
    num sum = add(G(ruled)(f, across), G(ruled)(g, along)), P3 = G(of_corners)(f, g, M);
    num corners = mul(from_int(fault(T, 2, 1)), P3);
    same(T, sum, add(corners, add(G(ruled)(f, d_across), G(ruled)(g, d_along))));
}

/*
So $P_1+P_2-P_3$ has the four borders.  The argument uses of the blending functions only their values at the ends, and of the curves
only that they meet at the corners; the condition $f_0+f_1=1$ is needed for something else.

:::{statement} slides-ch4:3-bilinear
:title: The patch with four given borders
:zh: 以给定四曲线为边界的 Coons 曲面
:printed: $P=P_1+P_2-P_3=[f_0(u)\;f_1(u)]\begin{bmatrix}0w\\1w\end{bmatrix}+[u0\;u1]\begin{bmatrix}f_0(w)\\f_1(w)\end{bmatrix}-[f_0(u)\;f_1(u)]\,M\begin{bmatrix}f_0(w)\\f_1(w)\end{bmatrix}$, $M=\begin{bmatrix}00&01\\10&11\end{bmatrix}$, has the borders $u0,u1,0w,1w$; for
  $u=0$ the right side is $0w+f_0(w)00+f_1(w)01-f_0(w)00-f_1(w)01=0w$
:holds-by: coons_kernel_is_the_bordered_product four_curves_are_borders
:hypothesis: open_corner_loses_the_border | the curves meet at the corners
:needs: blendings_without_end_values_lose_the_border | the conditions printed with the functions | $f_0(0)=f_1(1)=1$,
  $f_0(1)=f_1(0)=0$
:confirmed-by: shifted_frame_shifts_the_patch_by_a_product
:figure: boolean_sum

In the text at hand the sums of products have no signs; with those shown here the patch has the borders.
The other condition printed with the functions, $f_0+f_1=1$, is not needed for the borders.  It makes the patch move with its four curves.
:::

:::{statement} slides-ch4:3-corner-points
:title: The corners in the matrix can be computed from the four curves
:zh: 矩阵 M 的角点可由四条边界曲线求得
:printed: The four elements of $M$ are the position vectors of the corners, and can be computed from the four given curves.
:holds-by: corner_of_the_patch_is_two_ends_less_an_entry
:confirmed-by: four_curves_are_borders
:hypothesis: open_corner_is_two_points | the curves meet at the corners: each corner is an end of two of them, and both give one point
:needs: blendings_without_end_values_lose_a_corner | the conditions printed with the functions | $f_0(0)=f_1(1)=1$,
  $f_0(1)=f_1(0)=0$: with these the patch keeps its borders, and with them the corners
:figure: boolean_sum
:::

:::{claim} corner_of_the_patch_is_two_ends_less_an_entry
:title: At a corner the patch has what both curves have there, less the entry of the matrix
:zh: 角点处曲面数据为两边界数据之和减去矩阵元素
:given: $m=2$ or $m=4$ blending functions that have at the ends the values, and with $m=4$ the derivatives, of the unit matrix; any matrix $M$, any data
  of the curves at the corners
:then: in the place $(k,l)$ of $M$, a point or with $m=4$ a tangent or a twist of a corner, the patch has $A_k+B_l-M_{kl}$ with the data $A_k$ of $0w,1w,0w_u,1w_u$
  and $B_l$ of $u0,u1,u0_w,u1_w$; if both are one vector $c$ it is $2c-M_{kl}$, which is $c$, and $M_{kl}$, exactly where $M_{kl}=c$
:method: The kernel with rows of the unit matrix for both parameters, for each entry; everything a variable, each coordinate by itself.
:over: m#: corners; x# y#: border curves
:control: the matrix of the corners transposed
:::
*/
CLAIM(corner_of_the_patch_is_two_ends_less_an_entry)
{
    num A[most_data], B[most_data], M[most_data * most_data], P;
    for (int m = 2; m <= most_data; m += 2) {
        G(any_data)(T, "x", m, A);
        G(any_data)(T, "y", m, B);
        G(any_data)(T, "m", m * m, M);
        for (int k = 0; k < m; k++)
            for (int l = 0; l < m; l++) {
                num of_u[most_data], of_w[most_data];
                for (int i = 0; i < m; i++)
                    of_u[i] = from_int(i == k), of_w[i] = from_int(i == l);
                G(coons_patch)(m, 1, of_u, of_w, A, B, M, &P);
                same(T, P, sub(add(A[k], B[l]), M[fault(T, k * m + l, l * m + k)]));
            }
    }
}

/*
:::{claim} coons_kernel_is_the_bordered_product
:title: The kernel is the printed sum of products, for two and for four functions
:zh: Coons 曲面的分块矩阵形式
:given: any values of the blending functions, any data across, along and at the corners, $m=2$ and $m=4$
:then: `coons_patch` is $-[-1\;a]\begin{bmatrix}0&B\\A&M\end{bmatrix}\begin{bmatrix}-1\\b\end{bmatrix}$, which is the printed sum
:method: The bordered matrix of $m+1$ rows is formed and multiplied out; everything variable, each coordinate by itself.
:defines: coons_patch
:over: a# b#: blending functions; x# y#: border data; m#: corner data
:control: the matrix of the corners transposed
:::
*/
CLAIM(coons_kernel_is_the_bordered_product)
{
    num a[most_data], b[most_data], A[most_data], B[most_data], M[most_data * most_data], used[most_data * most_data];
    for (int m = 2; m <= most_data; m += 2) {
        num bordered[5][5], left[5] = {from_int(-1)}, right[5] = {from_int(-1)}, product = from_int(0), P;
        G(any_data)(T, "a", m, a);
        G(any_data)(T, "b", m, b);
        G(any_data)(T, "x", m, A);
        G(any_data)(T, "y", m, B);
        G(any_data)(T, "m", m * m, M);
        bordered[0][0] = from_int(0);
        for (int i = 0; i < m; i++) {
            left[i + 1] = a[i], right[i + 1] = b[i];
            bordered[i + 1][0] = A[i], bordered[0][i + 1] = B[i];
            for (int j = 0; j < m; j++) {
                bordered[i + 1][j + 1] = M[i * m + j];
                used[i * m + j] = M[fault(T, i * m + j, j * m + i)];
            }
        }
        for (int i = 0; i <= m; i++)
            for (int j = 0; j <= m; j++)
                product = add(product, mul(left[i], mul(bordered[i][j], right[j])));
        G(coons_patch)(m, 1, a, b, A, B, used, &P);
        same(T, P, neg(product)); /* -[-1 a] (0 B; A M) [-1; b] */
    }
}

#if RATIONAL
/*
:::{claim} open_corner_loses_the_border
:title: If two curves do not meet the patch loses a border
:zh: 角点不闭合则失去边界
:kind: counterexample
:data: u0 = 1; w = 1/2
:instead: u0 = 0
:result: P(0,w) = 1/2
:given: $f_0=1-t$, $f_1=t$; the curve $u0$ is the given constant, the three other curves are constant 0; the corners of $M$ are 0; a place $w$
:then: $P(0,w)=1-w$, not $0w=0$
:method: The kernel at $u=0$.
:control: $u0$ is 0 as well
:::
*/
CLAIM(open_corner_loses_the_border)
{
    num zero = from_int(0), one = from_int(1), B[2] = {given(T, "u0"), zero}, w = given(T, "w"), P;
    num a[2] = {one, zero}, b[2] = {sub(one, w), w}, A[2] = {zero, zero}, M[4] = {zero, zero, zero, zero};
    coons_patch_q(2, 1, a, b, A, B, M, &P);
    found(T, "P(0,w)", P);
    about(T, "P(0,w) and the curve 0w");
    same(T, P, A[0]);
}

/*
:::{claim} open_corner_is_two_points
:title: If two curves do not meet a corner is two points
:zh: 两边界不相接则角点不唯一
:kind: counterexample
:data: ends of 0w = 0 2; ends of u0 = 1 3
:instead: ends of u0 = 0 3
:result: 00 of the first = 0; 00 of the second = 1
:given: $f_0=1-t$, $f_1=t$; two straight borders on a line, each given by its ends: $0w$ from $w=0$ to $1$, $u0$ from $u=0$ to $1$
:then: the corner $00$ computed from the first, $0w$ at $w=0$, is not that computed from the second, $u0$ at $u=0$
:method: Both borders are computed at parameter 0.
:control: the borders meet
:::
*/
CLAIM(open_corner_is_two_points)
{
    num start[2] = {from_int(1), from_int(0)}, along_w[2], along_u[2];
    given_points(T, "ends of 0w", 2, 1, along_w);
    given_points(T, "ends of u0", 2, 1, along_u);
    num of_0w = ruled_q(start, along_w), of_u0 = ruled_q(start, along_u);
    found(T, "00 of the first", of_0w);
    found(T, "00 of the second", of_u0);
    about(T, "the corner 00 computed from 0w and from u0");
    same(T, of_0w, of_u0);
}

/*
:::{claim} blendings_without_end_values_lose_a_corner
:title: With a function whose end value is not 1 the patch loses a corner
:zh: 混合函数端值不为 1 则失去角点
:kind: counterexample
:data: f_0(0) = 1/2; f_1(0) = 1/2; 00 = 1
:instead: f_0(0) = 1; f_1(0) = 0
:result: P(0,0) = 3/4
:given: the values of two blending functions at 0, whose sum is 1; the curves $0w$ and $u0$, which have the corner $00$ at their ends $w=0$ and $u=0$; the three other
  corners are 0
:then: $P(0,0)$ is not $00$
:method: The kernel at $u=w=0$.
:control: $f_0(0)=1$, $f_1(0)=0$
:::
*/
CLAIM(blendings_without_end_values_lose_a_corner)
{
    num zero = from_int(0), corner = given(T, "00"), P;
    num f[2] = {given(T, "f_0(0)"), given(T, "f_1(0)")}, ends[2] = {corner, zero}, M[4] = {corner, zero, zero, zero};
    coons_patch_q(2, 1, f, f, ends, ends, M, &P);
    found(T, "P(0,0)", P);
    about(T, "P(0,0) and the corner 00");
    same(T, P, corner);
}

/*
:::{claim} blendings_without_sum_one_move_the_patch
:title: With functions whose sum is not 1 a frame of one point is filled by more than the point
:zh: 混合函数之和不为一时不具平移不变性
:kind: counterexample
:data: u = 1/2; w = 1/2; the frame = 1
:result: P(u,w) = 3/4
:given: $f_0=(1-t)^2$, $f_1=t^2$, which have the end values; all curves and corners are one constant, the frame, which is one point of a line
:then: inside, at $(u,w)$, the patch leaves that point
:method: The kernel.
:control: $f_0=1-t$, $f_1=t$
:::
*/
CLAIM(blendings_without_sum_one_move_the_patch)
{
    num at[2] = {given(T, "u"), given(T, "w")}, f[2][2], frame = given(T, "the frame"), P;
    for (int k = 0; k < 2; k++) {
        num t = at[k], s = sub(from_int(1), t);
        f[k][0] = fault(T, s, mul(s, s));
        f[k][1] = fault(T, t, mul(t, t));
    }
    num curves[2] = {frame, frame}, M[4] = {frame, frame, frame, frame};
    coons_patch_q(2, 1, f[0], f[1], curves, curves, M, &P);
    found(T, "P(u,w)", P);
    about(T, "P(u,w) and the only point of the frame");
    same(T, P, frame);
}
#endif

/*
:::{statement} slides-ch4:3-bicubic-degree
:title: Cubic curves and cubic blendings give a bicubic patch
:zh: 双三次多项式
:printed: If the border curves are cubic polynomials and the blending functions polynomials of degree not above 3, the formula is a cubic
  polynomial in $u$ and in $w$, a bicubic one.
:holds-by: cubic_frame_gives_bicubic_patch
:meant: the words "not above three" (不超过三次), said of the functions | Of degree at most 3 in each of the two parameters.
:figure: worked_patch
:::
*/

#if FIELD
/*
:::{claim} cubic_frame_gives_bicubic_patch
:title: The degree of the patch in each parameter is at most 3
:zh: 曲面关于每个参数次数不超过三
:types: field
:given: cubics $f_0,f_1,u0,u1,0w,1w$ with any coefficients, any corners
:then: the patch has degree at most 3 in $u$ and in $w$
:method: The fourth difference $\sum_k(-1)^k\binom4kP(u+k,w)$ is 0 for all $u$ and $w$, and that in $w$ too; everything variable.  A polynomial
  whose fourth difference is 0 is of degree at most 3.
:over: f# g#: blending functions; x# y# a# b#: border curves; m#: corners
:control: a curve $u0$ of degree 4
:::
*/
CLAIM(cubic_frame_gives_bicubic_patch)
{
    static const int alternating[5] = {1, -4, 6, -4, 1};
    num u = variable_f("u"), w = variable_f("w"), M[4], P, across_u = from_int(0), across_w = from_int(0);
    struct poly_f f0 = free_poly_f(T, "f", 3), f1 = free_poly_f(T, "g", 3);
    struct poly_f u0 = free_poly_f(T, "x", fault(T, 3, 4)), u1 = free_poly_f(T, "y", 3);
    struct poly_f w0 = free_poly_f(T, "a", 3), w1 = free_poly_f(T, "b", 3);
    G(any_data)(T, "m", 4, M);
    for (int direction = 0; direction < 2; direction++)
        for (int k = 0; k <= 4; k++) {
            num x = direction == 0 ? add(u, from_int(k)) : u, y = direction == 1 ? add(w, from_int(k)) : w;
            num a[2] = {at_f(f0, 0, x), at_f(f1, 0, x)}, b[2] = {at_f(f0, 0, y), at_f(f1, 0, y)};
            num A[2] = {at_f(w0, 0, y), at_f(w1, 0, y)}, B[2] = {at_f(u0, 0, x), at_f(u1, 0, x)};
            G(coons_patch)(2, 1, a, b, A, B, M, &P);
            num *sum = direction == 0 ? &across_u : &across_w;
            *sum = add(*sum, mul(from_int(alternating[k]), P));
        }
    vanishes(T, across_u);
    vanishes(T, across_w);
}
#endif

/*
## Four curves and the derivatives across them

With four functions in the place of two the same sum keeps four curves and four derivatives across them.  But now the data must agree
in more than the corners: from each of two borders the corner inherits a mixed derivative, the twist, and there is one place for it in $M$.

:::{statement} slides-ch4:3-bicubic
:title: The patch with given borders and derivatives across
:zh: 具有指定跨界切向量的曲面片
:printed: $P=q(u)\,[0w\;1w\;0w_u\;1w_u]^T+[u0\;u1\;u0_w\;u1_w]\,q(w)^T-q(u)\,M\,q(w)^T$,
  $q=[q_{00}\;q_{01}\;q_{10}\;q_{11}]$, $M=\begin{bmatrix}00&01&00_w&01_w\\10&11&10_w&11_w\\00_u&01_u&00_{uw}&01_{uw}\\10_u&11_u&10_{uw}&11_{uw}\end{bmatrix}$, has the four borders and the
  four derivatives across; for $u=0$ the right side is
  $0w+(00\,q_{00}(w)+01\,q_{01}(w)+00_wq_{10}(w)+01_wq_{11}(w))-(00\,q_{00}(w)+01\,q_{01}(w)+00_wq_{10}(w)+01_wq_{11}(w))=0w$, and its derivative with respect to $u$ is
  $[0\;0\;1\;0]\,[0w\;1w\;0w_u\;1w_u]^T+[00_u\;01_u\;00_{uw}\;01_{uw}]\,q(w)^T-[0\;0\;1\;0]\,M\,q(w)^T=0w_u$
:holds-by: coons_kernel_is_the_bordered_product borders_and_cross_derivatives_are_kept unit_functions_are_dual_to_the_data
:hypothesis: two_points_cannot_both_be_kept | the curves meet at the corners
:hypothesis: two_tangents_cannot_both_be_kept | at the corners the derivatives across the borders are the tangents of the other borders
:hypothesis: two_twists_cannot_both_be_kept | at each corner both derivatives across have one twist: the derivative of $0w_u$
  along its border is that of $u0_w$ along its own, likewise at the other corners
:figure: two_twists

In the text at hand the sums of products have no signs; with those shown here the patch keeps its data.
:::

:::{statement} slides-ch4:3-corner-data
:title: The corners can be computed from the given curves
:zh: 角点信息可由边界数据求得
:printed: From $u0,u1,0w,1w$ and $u0_w,u1_w,0w_u,1w_u$ the points, tangents and twist vectors of the four corners can be computed.
:holds-by: corner_of_the_patch_is_two_ends_less_an_entry unit_functions_are_dual_to_the_data
:confirmed-by: borders_and_cross_derivatives_are_kept cubic_frame_takes_the_data_of_the_corners
:hypothesis: two_points_cannot_both_be_kept | the curves meet at the corners
:hypothesis: two_tangents_cannot_both_be_kept | at the corners the derivatives across the borders are the tangents of the other borders
:hypothesis: two_twists_cannot_both_be_kept | at each corner both derivatives across have one twist: so for each of these vectors both ways to compute it give one
:figure: two_twists
:::

:::{claim} borders_and_cross_derivatives_are_kept
:title: The patch keeps curves and derivatives across when the data agree at the corners
:zh: 曲面保持边界与跨界切向量
:given: any matrix $M$; on a border any values of its curve, of its derivative across, and of the four functions along it; across it the four functions have the
  values and derivatives of the unit matrix
:then: on all four borders the value of the patch and its derivative across are the given ones
:method: At $u=0$ and $u=1$ the values and the derivatives of the four functions are rows of the unit matrix, and what
  runs across has its values and derivatives in $M$; at $w=0$ and $w=1$ the same, run as well.  No other property is used.  Each coordinate is computed by itself.
:over: m#: corner data; x#: border data; f#: blending functions
:control: one twist differs between the curve and $M$
:::
*/
CLAIM(borders_and_cross_derivatives_are_kept) { G(borders_are_kept)(T, 4); }

#if RATIONAL
/* Two borders ask for different vectors, asked[0] and asked[1], at the corner u = w = 0, in the place (k,l) of M, k and l being 0 or 2; all
 * other data are 0.  The datum number k of 0w,1w,0w_u,1w_u is asked[0] q_l(w), the datum number l of u0,u1,u0_w,u1_w is asked[1] q_k(u). */
static void one_of_two_is_lost(trial *T, int k, int l, const char *const data[4], const char *const name[2][2])
{
    num zero = from_int(0), one = from_int(1), q[2][4], M[16], P[2], asked[2] = {given(T, data[0]), given(T, data[1])};
    hermite_blending_q(zero, one, given(T, "u"), 0, q[0]);
    hermite_blending_q(zero, one, given(T, "w"), 0, q[1]);
    num at[2] = {mul(asked[0], q[1][l]), mul(asked[1], q[0][k])};
    num unit_k[4] = {zero, zero, zero, zero}, unit_l[4] = {zero, zero, zero, zero};
    unit_k[k] = one, unit_l[l] = one;
    int kept = 0;
    found(T, data[2], at[0]);
    found(T, data[3], at[1]);
    for (int taken = 0; taken < 2; taken++) {
        for (int i = 0; i < 16; i++)
            M[i] = i == 4 * k + l ? asked[taken] : zero;
        /* on a border its own function is asked for; what runs along the other one has there its vector */
        num along_w[4] = {zero, zero, zero, zero}, along_u[4] = {zero, zero, zero, zero};
        num end_of_w[4] = {zero, zero, zero, zero}, end_of_u[4] = {zero, zero, zero, zero};
        along_w[k] = at[0], end_of_u[l] = asked[1];
        coons_patch_q(4, 1, unit_k, q[1], along_w, end_of_u, M, &P[0]);
        end_of_w[k] = asked[0], along_u[l] = at[1];
        coons_patch_q(4, 1, q[0], unit_l, end_of_w, along_u, M, &P[1]);
        for (int side = 0; side < 2; side++)
            found(T, name[taken][side], P[side]);
        kept += equal_q(P[0], at[0]) && equal_q(P[1], at[1]);
    }
    about(T, "whether one of the two matrices keeps both data");
    agree(T, kept > 0);
}

/*
:::{claim} two_points_cannot_both_be_kept
:title: Two points at a corner: whichever is taken, one border is lost
:zh: 角点不闭合则不能同时保持两边界
:kind: counterexample
:data: p = 0; p' = 1; u = 1/2; w = 1/2
:instead: p' = 0
:result: point of 0w = 0; point of u0 = 1/2; P(0,w) with the first = 1/2; P(u,0) with the first = 1/2; P(0,w) with the second = 0; P(u,0) with the second = 0
:given: all data 0 but two borders, $0w=pq_{00}(w)$ and $u0=p'q_{00}(u)$: the one begins at $p$ for $u=w=0$, the other at $p'$, and they differ
:then: with the first point as $00$ in the matrix $M$ of the corners the border $u=0$ is another curve than $0w$; with the second the border $w=0$ is another
  than $u0$
:method: The kernel at $w$ on the one border and at $u$ on the other, for both matrices.
:control: both borders begin at one point
:::
*/
CLAIM(two_points_cannot_both_be_kept)
{
    static const char *const data[4] = {"p", "p'", "point of 0w", "point of u0"};
    static const char *const name[2][2] = {{"P(0,w) with the first", "P(u,0) with the first"},
                                           {"P(0,w) with the second", "P(u,0) with the second"}};
    one_of_two_is_lost(T, 0, 0, data, name);
}

/*
:::{claim} two_tangents_cannot_both_be_kept
:title: Two tangents at a corner: whichever is taken, a border or a derivative across is lost
:zh: 角点切向量不相容则不能同时保持
:kind: counterexample
:data: τ = 0; τ' = 1; u = 1/2; w = 1/2
:instead: τ' = 0
:result: vector of 0w_u = 0; point of u0 = 1/8; P_u(0,w) with the first = 1/2; P(u,0) with the first = 1/8; P_u(0,w) with the second = 0; P(u,0) with the second = 0
:given: all data 0 but a derivative across a border, $0w_u=\tau q_{00}(w)$, and a border, $u0=\tau'q_{10}(u)$: the one asks for the tangent $\tau$ along $u$ at
  $u=w=0$, the other for $\tau'$, and they differ
:then: with the first tangent as $00_u$ in the matrix $M$ of the corners the border $u=0$ has another derivative across it than $0w_u$; with the second the border $w=0$ is
  another than $u0$
:method: The kernel at $w$ on the one border and at $u$ on the other, for both matrices.
:control: both ask for one tangent
:::
*/
CLAIM(two_tangents_cannot_both_be_kept)
{
    static const char *const data[4] = {"τ", "τ'", "vector of 0w_u", "point of u0"};
    static const char *const name[2][2] = {{"P_u(0,w) with the first", "P(u,0) with the first"},
                                           {"P_u(0,w) with the second", "P(u,0) with the second"}};
    one_of_two_is_lost(T, 2, 0, data, name);
}

/*
:::{claim} two_twists_cannot_both_be_kept
:title: Two twists at a corner: whichever is taken, one derivative across is lost
:zh: 扭矢不相容则不能同时保持
:kind: counterexample
:data: τ = 0; τ' = 1; u = 1/2; w = 1/2
:instead: τ' = 0
:result: vector of 0w_u = 0; vector of u0_w = 1/8; P_u(0,w) with the first = 1/8; P_w(u,0) with the first = 1/8; P_u(0,w) with the second = 0; P_w(u,0) with the second = 0
:given: all data 0 but the derivatives across two borders, $0w_u=\tau q_{10}(w)$ and $u0_w=\tau'q_{10}(u)$: the one asks for the twist $\tau$ at
  $u=w=0$, the other for $\tau'$, and they differ
:then: with the first twist as $00_{uw}$ in the matrix $M$ of the corners the border $u=0$ has another derivative across it than $0w_u$; with the second the border $w=0$ has
  another than $u0_w$
:method: The kernel at $w$ on the one border and at $u$ on the other, for both matrices.
:control: both curves ask for one twist
:::
*/
CLAIM(two_twists_cannot_both_be_kept)
{
    static const char *const data[4] = {"τ", "τ'", "vector of 0w_u", "vector of u0_w"};
    static const char *const name[2][2] = {{"P_u(0,w) with the first", "P_w(u,0) with the first"},
                                           {"P_u(0,w) with the second", "P_w(u,0) with the second"}};
    one_of_two_is_lost(T, 2, 2, data, name);
}
#endif

#include "chapters/judge/claims_off.h"
