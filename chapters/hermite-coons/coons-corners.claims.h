/*
# A patch from its corners (角点信息矩阵)

When the borders and the derivatives across them are themselves cubics of Hermite, sixteen vectors at the corners say
everything, and the Boolean sum becomes a product of matrices.
*/
#include "chapters/hermite-coons/definition.h"

#include "chapters/judge/claims_on.h"

/*
Each border is a cubic with two points and two tangents, and so is each derivative across a border, whose tangents at its ends are twists.
In this way the whole frame is computed from four points, eight tangents and four twists.

:::{statement} slides-ch4:3-borders-by-hermite
:title: Borders and derivatives across from the data of the corners
:zh: 用 Hermite 插值给出边界线与跨界切向量
:printed: $u0=00\,q_{00}(u)+10\,q_{01}(u)+00_uq_{10}(u)+10_uq_{11}(u)$, $u1=01\,q_{00}(u)+11\,q_{01}(u)+01_uq_{10}(u)+11_uq_{11}(u)$,
  $u0_w=00_wq_{00}(u)+10_wq_{01}(u)+00_{uw}q_{10}(u)+10_{uw}q_{11}(u)$, $u1_w=01_wq_{00}(u)+11_wq_{01}(u)+01_{uw}q_{10}(u)+11_{uw}q_{11}(u)$;
  so $[u0\;u1\;u0_w\;u1_w]=q(u)\,M$, and in the same way the column of $0w,1w,0w_u,1w_u$ is $M\,q(w)^T$
:holds-by: cubic_frame_takes_the_data_of_the_corners
:confirmed-by: cubic_frame_of_corners_gives_the_product
:figure: worked_patch

In the text at hand the sums have no signs; those shown here have the data of the corners.
:::
*/

/* What is given at the corner u = a, w = b: the derivative of order r in u and s in w.  The source writes 10_{uw} for a = 1, b = 0,
 * r = s = 1. */
struct G(corner) {
    num at[2][2]; /* r, s */
};

/*
:::{claim} cubic_frame_takes_the_data_of_the_corners
:title: The four cubics have the data of the corners at their ends, and are q(u) M
:zh: 四条 Hermite 三次边界取角点数据
:given: points, tangents and twists of the four corners; the printed sums with $q_{00},q_{01},q_{10},q_{11}$, for $u$ and for $w$
:let: $q=[q_{00}\;q_{01}\;q_{10}\;q_{11}]$; $M$ be the matrix with the rows $(00,01,00_w,01_w)$, $(10,11,10_w,11_w)$, $(00_u,01_u,00_{uw},01_{uw})$, $(10_u,11_u,10_{uw},11_{uw})$
:then: $u0$, $u1$, $u0_w$ and $u1_w$ have at $u=0$ and $u=1$ the given values and the given derivatives, and are the entries of $q(u)M$;
  $0w$, $1w$, $0w_u$ and $1w_u$ have theirs at $w=0$ and $w=1$, and are the entries of $Mq(w)^T$
:method: The sums are formed from the data by their names, as polynomials with the functions $q$ multiplied out from their factors;
  values and derivatives at the ends, and the product with $M$, entry by entry.
:scope: every $u$ and $w$
:over: x#: corner data; u: -
:control: the twist $11_{uw}$ left out of $u1_w$
:::
*/
CLAIM(cubic_frame_takes_the_data_of_the_corners)
{
    struct G(corner) corner[2][2]; /* u = a, w = b */
    num M[4][4], zero = from_int(0), one = from_int(1), x = parameter(T, "u");
    struct G(poly) q[4]; /* q_00, q_01, q_10, q_11 */
    for (int i = 0; i < 4; i++)
        q[i] = G(printed_blending)(zero, one, i);
    for (int k = 0; k < 16; k++) {
        int a = k & 1, b = k >> 1 & 1, r = k >> 2 & 1, s = k >> 3;
        corner[a][b].at[r][s] = M[2 * r + a][2 * s + b] = unknown(T, "x", k);
    }
    for (int end = 0; end < 2; end++)           /* u0 and u1, or 0w and 1w */
        for (int cross = 0; cross < 2; cross++) /* the border, or the derivative across */
            for (int along_w = 0; along_w < 2; along_w++) {
                num data[4], by_matrix = zero, value = zero; /* the factors of q_00, q_01, q_10, q_11 */
                for (int i = 0; i < 4; i++) {
                    int start = i & 1, order = i >> 1;
                    data[i] = along_w ? corner[end][start].at[cross][order] : corner[start][end].at[order][cross];
                    num used = fault(T, data[i], !along_w && end && cross && i == 3 ? zero : data[i]), column = zero;
                    value = add(value, mul(used, G(at)(q[i], 0, x)));
                    column = along_w ? M[2 * cross + end][i] : M[i][2 * cross + end];
                    by_matrix = add(by_matrix, mul(column, G(at)(q[i], 0, x)));
                }
                about(T, "the printed sum and the product with M");
                same(T, value, by_matrix);
                for (int i = 0; i < 4; i++) { /* the datum of q_i: the derivative of order i/2 at the end i%2 */
                    num sum = zero;
                    for (int k = 0; k < 4; k++)
                        sum = add(sum, mul(data[k], G(at)(q[k], i >> 1, from_int(i & 1))));
                    about(T, "a datum at an end");
                    same(T, sum, data[i]);
                }
            }
}

/* C = H M H^T, entry (i, j) belonging to u^{3-i} w^{3-j}. */
static void G(product_of_corners)(const num M[16], num C[16])
{
    num left[16];
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            left[4 * i + j] = from_int(0);
            for (int k = 0; k < 4; k++)
                left[4 * i + j] = add(left[4 * i + j], mul(from_int(G(printed_matrix)(i, k)), M[4 * k + j]));
        }
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            C[4 * i + j] = from_int(0);
            for (int k = 0; k < 4; k++)
                C[4 * i + j] = add(C[4 * i + j], mul(left[4 * i + k], from_int(G(printed_matrix)(j, k))));
        }
}

/* The derivative of order r in u and s in w of U C W^T. */
static num G(power_patch)(const num C[16], num u, num w, int r, int s)
{
    struct G(poly) rows = {.n = 3};
    for (int i = 0; i < 4; i++) {
        struct G(poly) row = {3, {C[4 * i + 3], C[4 * i + 2], C[4 * i + 1], C[4 * i]}};
        rows.c[3 - i] = G(at)(row, s, w);
    }
    return G(at)(rows, r, u);
}

static void G(any_corners)(trial *T, num M[16])
{
    for (int i = 0; i < 16; i++)
        M[i] = unknown(T, "m", i);
}

/*
:::{claim} cubic_frame_of_corners_gives_the_product
:title: The Boolean sum over a frame of Hermite cubics is q(u) M q(w)
:zh: Hermite 边框的布尔和为张量积
:let: $q=[q_{00}\;q_{01}\;q_{10}\;q_{11}]$, $U=[u^3\;u^2\;u\;1]$, $W=[w^3\;w^2\;w\;1]$, and $H$ the matrix whose columns are the coefficients of the functions $q$
:given: any $M$, $u$, $w$; the frame computed from $M$, $[u0\;u1\;u0_w\;u1_w]=q(u)M$ and the column of $0w,1w,0w_u,1w_u$ as $Mq(w)^T$
:then: all three terms of the patch are $q(u)Mq(w)^T$, so the patch is; it is also $UHMH^TW^T$
:method: The frame with the functions $q$ multiplied out from their factors, the patch by `coons_patch`, the product by the printed
  matrix $H$; everything variable.
:over: m#: corner data
:control: the twist $11_{uw}$ left out of $u1_w$
:::
*/
CLAIM(cubic_frame_of_corners_gives_the_product)
{
    num M[16], C[16], u = parameter(T, "u"), w = parameter(T, "w"), a[4], b[4], A[4], B[4], P;
    num zero = from_int(0), one = from_int(1);
    G(any_corners)(T, M);
    G(product_of_corners)(M, C);
    num expected = G(power_patch)(C, u, w, 0, 0), across = zero, along = zero;
    for (int i = 0; i < 4; i++) {
        struct G(poly) q = G(printed_blending)(zero, one, i);
        a[i] = G(at)(q, 0, u), b[i] = G(at)(q, 0, w);
    }
    for (int i = 0; i < 4; i++) {
        A[i] = B[i] = zero;
        for (int k = 0; k < 4; k++) {
            A[i] = add(A[i], mul(M[4 * i + k], b[k]));
            if (fault(T, 1, !(i == 3 && k == 3)))
                B[i] = add(B[i], mul(M[4 * k + i], a[k]));
        }
        across = add(across, mul(a[i], A[i]));
        along = add(along, mul(B[i], b[i]));
    }
    same(T, across, expected);
    same(T, along, expected);
    G(coons_patch)(4, 1, a, b, A, B, M, &P);
    about(T, "the patch");
    same(T, P, expected);
}

/*
All three terms of the Boolean sum are then the same surface, and of $1+1-1$ copies one is left.

:::{statement} slides-ch4:3-product
:title: The patch as a product of matrices
:zh: 双三次 Coons 曲面的矩阵形式
:printed: P(u,w)=q(u)\,M\,q(w)^T=[u^3\;u^2\;u\;1]\,H\,M\,H^T\,[w^3\;w^2\;w\;1]^T,\quad H=\begin{bmatrix}2&-2&1&1\\-3&3&-2&-1\\0&0&1&0\\1&0&0&0\end{bmatrix},\quad M=\begin{bmatrix}00&01&00_w&01_w\\10&11&10_w&11_w\\00_u&01_u&00_{uw}&01_{uw}\\10_u&11_u&10_{uw}&11_{uw}\end{bmatrix}
:holds-by: cubic_frame_of_corners_gives_the_product tensor_kernel_is_the_matrix_product
:confirmed-by: one_choice_of_signs_in_the_matrix
:figure: worked_patch

In the text at hand $H$ has no signs; of all choices of them the one shown is the only one whose columns are the functions $q$:
`one_choice_of_signs_in_the_matrix`.
:::

:::{claim} tensor_kernel_is_the_matrix_product
:title: The kernel gives every derivative of the product, and at the corners the sixteen data
:zh: 张量积曲面的各阶偏导与角点数据
:given: any $M$, $u$, $w$, orders 0 to 3 in $u$ and in $w$
:let: $U=[u^3\;u^2\;u\;1]$, $W=[w^3\;w^2\;w\;1]$, and $H$ the matrix whose columns are the coefficients of $q_{00},q_{01},q_{10},q_{11}$
:then: `hermite_tensor` is the derivative of $UHMH^TW^T$; its values, first derivatives and twists at the corners are $M$
:method: The sixteen coefficients $HMH^T$ and the derivatives of the powers; everything variable.
:defines: hermite_tensor
:over: m#: corner data
:control: $M$ transposed
:::
*/
CLAIM(tensor_kernel_is_the_matrix_product)
{
    num M[16], C[16], used[16], u = parameter(T, "u"), w = parameter(T, "w"), P;
    G(any_corners)(T, M);
    G(product_of_corners)(M, C);
    for (int i = 0; i < 16; i++)
        used[i] = M[fault(T, i, 4 * (i % 4) + i / 4)];
    for (int r = 0; r <= 3; r++)
        for (int s = 0; s <= 3; s++) {
            G(hermite_tensor)(1, used, u, w, r, s, &P);
            same(T, P, G(power_patch)(C, u, w, r, s));
        }
    about(T, "the corners");
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            G(hermite_tensor)(1, used, from_int(i % 2), from_int(j % 2), i / 2, j / 2, &P);
            same(T, P, M[4 * i + j]);
        }
}

/*
The example has lost its signs.  That $C=HMH^T$ holds with some choice of them is a strong test of the printed absolute values, since 48 numbers
must come out.  That it holds with several choices is due to symmetries: where a whole group of data can change its sign without changing any absolute value.

:::{statement} slides-ch4:3-worked-patch
:title: The worked patch
:zh: Coons 曲面算例
:printed: $P_0,\dots,P_3$ at $(0,0,0)$, $(0,\frac34,0)$, $(\frac34,0,0)$, $(\frac34,\frac34,0)$; the corner matrices have the absolute values
  $|M_x|=\frac34\begin{bmatrix}0&0&1&1\\1&1&1&1\\1&1&1&1\\1&1&1&1\end{bmatrix}$, $|M_y|=\frac34\begin{bmatrix}0&1&1&1\\0&1&1&1\\1&1&1&1\\1&1&1&1\end{bmatrix}$,
  $|M_z|=\frac34\begin{bmatrix}0&0&1&1\\0&0&1&1\\0&0&1&1\\0&0&1&1\end{bmatrix}$, and the patch the coefficients
  $|C_x|=\begin{bmatrix}3&3&0&0\\4.5&3.75&0.75&0\\0&0.75&0.75&0.75\\0&0.75&0.75&0\end{bmatrix}$,
  $|C_y|=\begin{bmatrix}0&0&0&0\\0&0.75&0.75&0.75\\0&0.75&0.75&0.75\\0&0&0.75&0\end{bmatrix}$,
  $|C_z|=\begin{bmatrix}0&0&0&0\\0&0.75&0.75&0\\0&0.75&0.75&0\\1.5&2.25&0.75&0\end{bmatrix}$
:holds-by: signs_of_the_worked_patch
:figure: worked_patch

In the text at hand the six matrices have no signs: there are signs of $M_x,M_y,M_z$ for which $C=HMH^T$, the columns of $H$ being the coefficients of $q_{00},q_{01},q_{10},q_{11}$, has the printed absolute
values.  Those for $x$ differ by the sign of all derivatives with respect to $w$, the twists among them.  In $z$ the sign of the tangents along
$w$ and that of the twists are free; in $y$ that of the tangents along $u$ and that of the twists.
:::
*/

#if RATIONAL
/*
:::{claim} signs_of_the_worked_patch
:title: How many choices of signs make the corner matrices fit the coefficients
:zh: 由数值恢复符号
:kind: decision
:data: |M_x| = 0 0 1 1 1 1 1 1 1 1 1 1 1 1 1 1; |C_x| = 4 4 0 0 6 5 1 0 0 1 1 1 0 1 1 0
:data: |M_y| = 0 1 1 1 0 1 1 1 1 1 1 1 1 1 1 1; |C_y| = 0 0 0 0 0 1 1 1 0 1 1 1 0 0 1 0
:data: |M_z| = 0 0 1 1 0 0 1 1 0 0 1 1 0 0 1 1; |C_z| = 0 0 0 0 0 1 1 0 0 1 1 0 2 3 1 0; choices = 2 4 4; free signs = 12 12 8
:data: blocks = 2 3 1 3 2 3; P = (0,0,0) (0,1,0) (1,0,0) (1,1,0)
:instead: |C_x| = 4 4 0 0 6 4 1 0 0 1 1 1 0 1 1 0; |C_y| = 0 0 0 0 0 0 1 1 0 1 1 1 0 0 1 0
:instead: |C_z| = 0 0 0 0 0 0 1 0 0 1 1 0 2 3 1 0
:given: the points $P$ of the corners, $w=0$ before $w=1$ and $u=0$ before $u=1$; the absolute values of the three corner matrices $M$ and of the three matrices $C$ of
  coefficients, row by row, in units of three quarters; the coordinates of the corners are not negative, as printed; all choices of the other signs; for each of $x$, $y$, $z$ two of the blocks of $M$, of which block 1 has
  the tangents along $u$, 2 those along $w$, 3 the twists; $H$, whose columns are the coefficients of the four functions $q$
:then: the corners in $M$ are the points; $|HMH^T|$ is the printed matrix for exactly as many choices of the free signs as are given for $x$, $y$ and $z$; from one that fits the others
  are found by changing the signs of whole blocks: for $x$ of both together, for $y$ and $z$ of either
:method: The corners of $M$ coordinate by coordinate; all choices, in integers; each that fits once more with the signs of its blocks changed.
:control: in each $C$ the second entry of the second row is one unit less
:::
*/
/* Whether |H N H^T| = C. */
static int fits_the_coefficients(const int N[16], const int C[16])
{
    int left[16], fits = 1;
    for (int i = 0; i < 16; i++) {
        left[i] = 0;
        for (int k = 0; k < 4; k++)
            left[i] += G(printed_matrix)(i / 4, k) * N[4 * k + i % 4];
    }
    for (int i = 0; i < 16 && fits; i++) {
        int sum = 0;
        for (int k = 0; k < 4; k++)
            sum += left[4 * (i / 4) + k] * G(printed_matrix)(i % 4, k);
        fits = (sum < 0 ? -sum : sum) == C[i];
    }
    return fits;
}

/* Whether |H N H^T| = C also with the signs of a block of N, or of two, changed.  Block 0 has the corners, 1 the tangents along u, 2
 * those along w, 3 the twists. */
static int fits_with_blocks_changed(const int N[16], const int C[16], int block, int other)
{
    int changed[16];
    for (int i = 0; i < 16; i++) {
        int of_i = i / 8 + 2 * (i % 4 / 2);
        changed[i] = of_i == block || of_i == other ? -N[i] : N[i];
    }
    return fits_the_coefficients(changed, C);
}

/* How many choices of signs of the entries of M, the four coordinates of corners excepted, have |H M H^T| = C.  *free_signs is the
 * number of entries that are not 0 and whose sign is free; *by_blocks is 1 if every choice that fits does so with the signs of the two
 * blocks changed: of either, or, if `together`, of both. */
static int fitting_signs(const int M[16], const int C[16], const int blocks[2], int together, int *free_signs,
                         int *by_blocks)
{
    int place[16], count = 0, fitting = 0;
    *by_blocks = 1;
    for (int i = 0; i < 16; i++)
        if (M[i] != 0 && !(i / 4 < 2 && i % 4 < 2))
            place[count++] = i;
    *free_signs = count;
    for (int signs = 0; signs < 1 << count; signs++) {
        int N[16];
        for (int i = 0; i < 16; i++)
            N[i] = M[i];
        for (int k = 0; k < count; k++)
            if (signs >> k & 1)
                N[place[k]] = -M[place[k]];
        if (!fits_the_coefficients(N, C))
            continue;
        fitting++;
        for (int k = 0; k < 2; k++)
            *by_blocks &= fits_with_blocks_changed(N, C, blocks[k], blocks[together ? 1 - k : k]);
    }
    return fitting;
}

CLAIM(signs_of_the_worked_patch)
{
    static const char *const name[3][3] = {
        {"|M_x|", "|C_x|", "choices for x"}, {"|M_y|", "|C_y|", "choices for y"}, {"|M_z|", "|C_z|", "choices for z"}};
    num choices[3], signs[3], blocks[6], P[4 * 3];
    given_points(T, "P", 4, 3, P);
    given_points(T, "choices", 3, 1, choices);
    given_points(T, "blocks", 6, 1, blocks);
    given_points(T, "free signs", 3, 1, signs);
    for (int axis = 0; axis < 3; axis++) {
        num M[16], C[16];
        int corners[16], coefficients[16], tried, by_blocks;
        given_points(T, name[axis][0], 16, 1, M);
        given_points(T, name[axis][1], 16, 1, C);
        about(T, "the corners in M, and the points");
        for (int k = 0; k < 4; k++) /* 00, 01, 10, 11 */
            same(T, M[4 * (k / 2) + k % 2], P[3 * k + axis]);
        for (int i = 0; i < 16; i++)
            corners[i] = (int)to_double_q(M[i]), coefficients[i] = (int)to_double_q(C[i]);
        int of_axis[2] = {(int)to_double_q(blocks[2 * axis]), (int)to_double_q(blocks[2 * axis + 1])};
        int fitting = fitting_signs(corners, coefficients, of_axis, axis == 0, &tried, &by_blocks);
        about(T, name[axis][2]);
        agree(T, equal_q(from_int(fitting), choices[axis]));
        about(T, "the choices that fit, by blocks");
        agree(T, by_blocks);
        about(T, "the number of signs that are free");
        same(T, from_int(tried), signs[axis]);
    }
}
#endif

#include "chapters/judge/claims_off.h"
