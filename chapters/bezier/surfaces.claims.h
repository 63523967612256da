/*
# Tensor product surfaces (张量积 Bézier 曲面)

A net of points $P_{ij}$, $i=0,\dots,n$, $j=0,\dots,m$, and the two parameters $u$ and $w$ make the surface

$$P(u,w)=\sum_{i=0}^n\sum_{j=0}^mB_i^n(u)\,B_j^m(w)\,P_{ij}.$$

Each row of the net is a curve in $w$; its points at one $w$ are the polygon of a curve in $u$.  The slides name such surfaces
in the title of their fourth section and say no more; the surface with a shape parameter in another chapter is of this kind.
What a user needs is collected here: points, parameter lines, partial derivatives of every order, normals, pieces.  All of it
is the theory of curves, used twice, but for the normal, which may vanish where the surface has a tangent plane.
*/
#include "chapters/bezier/definition.h"

#include "chapters/judge/claims_on.h"

enum { dim = 2, MOST_OF_NET = 9 * 6 }; /* points of a net: degrees 8 and 5 */

/*
## Points and lines
*/

static int G(other_degree)(int n) { return n / 2 + 1; }

/* The net of degrees n and m, every coordinate free. */
static void G(free_net)(trial *T, int n, int m, int coordinates, num P[])
{
    G(free_points)(T, (n + 1) * (m + 1) - 1, coordinates, P);
}

/*
:::{claim} surface_kernel_computes_the_double_sum
:title: The kernel computes the double sum
:zh: 张量积曲面上的点
:given: a net of degree $n$ in $u$ and $m=\lfloor\frac n2\rfloor+1$ in $w$ in the plane, any $u,w$
:then: `bezier_surface_point` gives $\sum_i\sum_jB_i^n(u)B_j^m(w)P_{ij}$
:method: The kernel against the double sum from the definition, everything a variable.
:degrees: 0..5 sampled 8
:scope: m = ⌊n/2⌋ + 1
:defines: bezier_surface_point
:control: $u$ and $w$ exchanged
:::
*/
CLAIM(surface_kernel_computes_the_double_sum)
{
    int n = T->degree, m = G(other_degree)(n);
    num P[MOST_OF_NET * dim], at[dim], u = parameter(T, "u"), w = parameter(T, "w");
    G(free_net)(T, n, m, dim, P);
    G(bezier_surface_point)(G(net)(n, m, dim, P), fault(T, u, w), fault(T, w, u), at);
    for (int c = 0; c < dim; c++) {
        num sum = from_int(0);
        for (int i = 0; i <= n; i++)
            for (int j = 0; j <= m; j++) {
                num B = mul(G(basis)(n, i, u), G(basis)(m, j, w));
                sum = add(sum, mul(B, P[(i * (m + 1) + j) * dim + c]));
            }
        same(T, at[c], sum);
    }
}

/* Coordinate c of the derivative of orders k and l at (u, w): the double sum of derivatives of the basis. */
static num G(surface)(int n, int m, int coordinates, const num P[], int c, int k, int l, num u, num w)
{
    num sum = from_int(0);
    for (int i = 0; i <= n; i++) {
        num row = G(curve_derivative)(m, coordinates, P + i * (m + 1) * coordinates, c, l, w);
        sum = add(sum, mul(G(basis_derivative)(n, i, k, u), row));
    }
    return sum;
}

/*
A surface is best understood by its lines.  Hold $u$ fixed: each column of the net becomes one point, and these points are the polygon of
a curve in $w$.  At $u=0$ they are the first row of the net itself.

:::{claim} parameter_lines_are_bezier_curves
:title: The lines of the surface are curves, and the borders those of the borders of the net
:zh: 等参线与边界曲线
:given: a net of degrees $n$ and $m=\lfloor\frac n2\rfloor+1$ in the plane, any $u,w$
:then: the curve of `bezier_surface_line` at $w$ is the double sum; for $u=0$ and $u=1$ its points are the first and the last row; with
  `bezier_surface_transpose` the same holds with $u$ and $w$ exchanged
:method: The curve of the kernel's points, from the definition, against the double sum; everything a variable.
:degrees: 0..4 sampled 8
:scope: m = ⌊n/2⌋ + 1
:over: t: u
:defines: bezier_surface_line bezier_surface_transpose
:control: the line at $1-u$
:::
*/
CLAIM(parameter_lines_are_bezier_curves)
{
    int n = T->degree, m = G(other_degree)(n);
    num P[MOST_OF_NET * dim], Q[MOST_OF_NET * dim], line[MOST_OF_NET * dim];
    num u = parameter(T, "u"), w = parameter(T, "w"), one = from_int(1);
    G(free_net)(T, n, m, dim, P);
    G(bezier_surface_transpose)(G(net)(n, m, dim, P), Q);
    for (int exchanged = 0; exchanged < 2; exchanged++) {
        int first = exchanged ? m : n, second = exchanged ? n : m, size = (second + 1) * dim;
        num fixed = exchanged ? w : u, along = exchanged ? u : w;
        const num *net = exchanged ? Q : P;
        about(T, "a line");
        G(bezier_surface_line)(G(net)(first, second, dim, net), fault(T, fixed, sub(one, fixed)), line);
        for (int c = 0; c < dim; c++)
            same(T, G(curve)(second, dim, line, c, along), G(surface)(n, m, dim, P, c, 0, 0, u, w));
        about(T, "a border");
        for (int end = 0; end < 2; end++) {
            G(bezier_surface_line)(G(net)(first, second, dim, net), from_int(end), line);
            for (int k = 0; k < size; k++) {
                int place = k / dim, border = end * first; /* P_{border, place}, or P_{place, border} */
                int point = exchanged ? place * (m + 1) + border : border * (m + 1) + place;
                same(T, line[k], P[point * dim + k % dim]);
            }
        }
    }
}

/*
:::{claim} surface_functions_sum_to_one_and_are_positive
:title: The functions of a surface are positive inside, and their sum is 1
:zh: 基函数的正性与规范性
:given: $u=\frac s{1+s}$, $w=\frac r{1+r}$, $r,s>0$, degrees $n$ and $m=\lfloor\frac n2\rfloor+1$
:then: $B_i^n(u)B_j^m(w)>0$, and their sum is 1
:method: The functions are the surfaces of nets with one point 1 and the others 0, by the kernel; their coefficients in $r,s$ are positive.
:degrees: 0..4 sampled 8
:scope: m = ⌊n/2⌋ + 1, 0 < u < 1, 0 < w < 1
:harmless: $r,s>0$ | it is $0<u<1$, $0<w<1$
:over: s r: -
:control: $w$ taken as $-\frac r{1+r}$
:::
*/
CLAIM(surface_functions_sum_to_one_and_are_positive)
{
    int n = T->degree, m = G(other_degree)(n), points = (n + 1) * (m + 1);
    num P[MOST_OF_NET], u = inside(T, "s"), w = inside(T, "r"), sum = from_int(0), value;
    for (int k = 0; k < points; k++) {
        for (int i = 0; i < points; i++)
            P[i] = from_int(i == k);
        G(bezier_surface_point)(G(net)(n, m, 1, P), u, fault(T, w, neg(w)), &value);
        about(T, "a function");
        G(must_be_positive)(T, value);
        sum = add(sum, value);
    }
    about(T, "the sum");
    same(T, sum, from_int(1));
}

/*
## Derivatives and normals

:::{claim} surface_derivatives_of_every_order
:title: The kernel computes all partial derivatives
:zh: 任意阶偏导矢
:given: a net of degrees $n$ and $m=\lfloor\frac n2\rfloor+1$ in the plane, any $u,w$, orders $0,\dots,n+1$ in $u$ and $0,\dots,m+1$ in $w$
:then: `bezier_surface_derivatives` gives $\frac{\partial^{k+l}P}{\partial u^k\partial w^l}$, 0 for $k>n$ and for $l>m$
:method: The kernel against the double sum of derivatives of the basis from the definition: in the field of rational functions,
  in the other number types power by power.
:degrees: 0..3 sampled 7
:scope: m = ⌊n/2⌋ + 1
:over: t: u
:defines: bezier_surface_derivatives
:control: the derivatives at $(w,u)$
:::
*/
CLAIM(surface_derivatives_of_every_order)
{
    int n = T->degree, m = G(other_degree)(n);
    num P[MOST_OF_NET * dim], D[10 * 7 * dim], B[10][9], C[7][6], u = parameter(T, "u"), w = parameter(T, "w");
    G(free_net)(T, n, m, dim, P);
    G(bezier_surface_derivatives)(G(net)(n, m, dim, P), fault(T, u, w), fault(T, w, u), n + 1, m + 1, D);
    for (int k = 0; k <= n + 1; k++)
        for (int i = 0; i <= n; i++)
            B[k][i] = G(basis_derivative)(n, i, k, u);
    for (int l = 0; l <= m + 1; l++)
        for (int j = 0; j <= m; j++)
            C[l][j] = G(basis_derivative)(m, j, l, w);
    for (int k = 0; k <= n + 1; k++)
        for (int l = 0; l <= m + 1; l++)
            for (int c = 0; c < dim; c++) {
                num sum = from_int(0);
                for (int i = 0; i <= n; i++) {
                    num row = from_int(0);
                    for (int j = 0; j <= m; j++)
                        row = add(row, mul(C[l][j], P[(i * (m + 1) + j) * dim + c]));
                    sum = add(sum, mul(B[k][i], row));
                }
                same(T, D[(k * (m + 2) + l) * dim + c], sum);
            }
}

/* The determinant of three vectors of space by its six products. */
static num G(volume)(const num a[3], const num b[3], const num c[3])
{
    num sum = from_int(0);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        sum = add(sum, mul(a[i], sub(mul(b[j], c[k]), mul(b[k], c[j]))));
    }
    return sum;
}

/*
The normal is the cross product of two partial derivatives.  It is compared here without computing a cross product: its product
with every vector is a volume.

:::{claim} surface_normal_is_the_cross_product
:title: The normal gives with every vector the volume of the two tangents and the vector
:zh: 法矢
:given: a net of degrees $n$ and $m=\lfloor\frac n2\rfloor+1$ in space, any $u,w$, any vector $v$
:then: the result $N$ of `bezier_surface_normal` has $N\cdot v=\det(P_u,P_w,v)$; hence $N\cdot P_u=N\cdot P_w=0$
:method: The determinant by its six products, of the partial derivatives from the definition; $v$ is each of three unit vectors, $P_u$
  and $P_w$.  Everything is a variable.
:degrees: 1..2 sampled 6
:scope: m = ⌊n/2⌋ + 1
:over: t: u
:defines: bezier_surface_normal
:control: the normal of the net with $u$ and $w$ exchanged
:::
*/
CLAIM(surface_normal_is_the_cross_product)
{
    int n = T->degree, m = G(other_degree)(n);
    num P[MOST_OF_NET * 3], Q[MOST_OF_NET * 3], N[3], u = parameter(T, "u"), w = parameter(T, "w");
    G(free_net)(T, n, m, 3, P);
    if (T->faulty) {
        G(bezier_surface_transpose)(G(net)(n, m, 3, P), Q);
        G(bezier_surface_normal)(G(net)(m, n, 3, Q), w, u, N);
    } else {
        G(bezier_surface_normal)(G(net)(n, m, 3, P), u, w, N);
    }
    num v[5][3];
    for (int c = 0; c < 3; c++) {
        for (int k = 0; k < 3; k++)
            v[k][c] = from_int(k == c);
        v[3][c] = G(surface)(n, m, 3, P, c, 1, 0, u, w);
        v[4][c] = G(surface)(n, m, 3, P, c, 0, 1, u, w);
    }
    for (int k = 0; k < 5; k++) {
        num product = from_int(0);
        for (int c = 0; c < 3; c++)
            product = add(product, mul(N[c], v[k][c]));
        about(T, k < 3 ? "a coordinate of the normal" : "the normal times a tangent");
        same(T, product, k < 3 ? G(volume)(v[3], v[4], v[k]) : from_int(0));
    }
}

/*
:::{claim} corners_of_the_net_give_tangents_normal_and_twist
:title: Tangents, normal and twist at a corner
:zh: 角点处的切矢、法矢与扭矢
:given: a net of degrees $n$ and $m=\lfloor\frac n2\rfloor+1$ in space
:then: at $(0,0)$: $P_u=n(P_{10}-P_{00})$, $P_w=m(P_{01}-P_{00})$, $P_{uw}=nm(P_{11}-P_{10}-P_{01}+P_{00})$ and
  $N=nm\,(P_{10}-P_{00})\times(P_{01}-P_{00})$
:method: The kernels at $(0,0)$, everything a variable; the other corners are those of the reversed nets.
:degrees: 1..4 sampled 8
:scope: m = ⌊n/2⌋ + 1
:control: $P_{11}$ left out of the twist
:::
*/
CLAIM(corners_of_the_net_give_tangents_normal_and_twist)
{
    int n = T->degree, m = G(other_degree)(n);
    num P[MOST_OF_NET * 3], D[4 * 3], N[3], a[3], b[3], zero = from_int(0), degree[2] = {from_int(n), from_int(m)};
    G(free_net)(T, n, m, 3, P);
    G(bezier_surface_derivatives)(G(net)(n, m, 3, P), zero, zero, 1, 1, D);
    G(bezier_surface_normal)(G(net)(n, m, 3, P), zero, zero, N);
    const num *right = P + 3, *up = P + 3 * (m + 1), *far = up + 3; /* P_01, P_10, P_11 */
    num product = mul(degree[0], degree[1]);
    for (int c = 0; c < 3; c++) {
        a[c] = sub(up[c], P[c]);
        b[c] = sub(right[c], P[c]);
        about(T, "the tangents");
        same(T, D[6 + c], mul(degree[0], a[c]));
        same(T, D[3 + c], mul(degree[1], b[c]));
        about(T, "the twist"); /* n m (P_11 - P_10 - P_01 + P_00) */
        num twist = sub(P[c], add(up[c], right[c]));
        same(T, D[9 + c], mul(product, fault(T, add(far[c], twist), twist)));
    }
    about(T, "the normal");
    for (int c = 0; c < 3; c++) {
        num unit[3] = {from_int(c == 0), from_int(c == 1), from_int(c == 2)};
        same(T, N[c], mul(product, G(volume)(a, b, unit)));
    }
}

#if RATIONAL
/*
What if one border of the net is a single point, as at the pole of a sphere?  Then one of the two tangents is 0 there and with it the cross
product.  A program that divides by its length fails at a place where the surface may be perfectly smooth.

:::{claim} collapsed_border_has_no_normal
:title: On a border of one point the normal vanishes, and the tangent plane is there
:zh: 退化边界处法矢为零
:kind: counterexample
:data: P = (0,0,0) (0,0,0) (1,0,0) (0,1,0); u = 1/2; w = 1/2
:instead: P = (0,0,0) (-1,1,0) (1,0,0) (0,1,0)
:result: N(u,w) = (0,0,1/2); N(0,w) = (0,0,0)
:given: $n=m=1$ and the net $P_{00},P_{01},P_{10},P_{11}$ in this order: the first border is one point, and the surface is a triangle of
  the plane $z=0$
:then: inside the normal is not 0, on the border of one point it is, although the surface has a tangent plane there
:method: The kernel inside, at $(u,w)$, and on the border; that the length of the second is not 0 is refuted.
:control: $P_{01}$ apart from $P_{00}$
:::
*/
CLAIM(collapsed_border_has_no_normal)
{
    num P[4 * 3], N[3];
    given_points(T, "P", 4, 3, P);
    num u = given(T, "u"), w = given(T, "w");
    bezier_surface_normal_q(net_q(1, 1, 3, P), u, w, N);
    found_points(T, "N(u,w)", 1, 3, N);
    about(T, "whether the normal inside is not 0");
    agree(T, !is_zero_q(norm_squared_q(3, N)));
    bezier_surface_normal_q(net_q(1, 1, 3, P), from_int(0), w, N);
    found_points(T, "N(0,w)", 1, 3, N);
    about(T, "whether the normal on the border is not 0");
    refute(T, is_zero_q(norm_squared_q(3, N)));
}
#endif

/*
## Pieces

A piece between parameters $u_0,u_1$ and $w_0,w_1$ is found as for curves, in one direction and then in the other.

:::{claim} surface_part_is_the_piece
:title: The net of a piece
:zh: 子曲面片的控制网格
:given: a net of numbers, of degrees $n$ and $m=\lfloor\frac n2\rfloor+1$, any $u_0,u_1,w_0,w_1$, any $a,b$
:then: the surface of the net of `bezier_surface_part` at $(a,b)$ is $P\bigl((1-a)u_0+au_1,(1-b)w_0+bw_1\bigr)$
:method: Both double sums from the definition; $a$ and $b$, the ends and the points are variables.
:degrees: 0..3 sampled 6
:scope: m = ⌊n/2⌋ + 1
:over: u# w# a b t: parameter value; x#: points
:defines: bezier_surface_part
:control: $w_0$ and $w_1$ exchanged
:::
*/
CLAIM(surface_part_is_the_piece)
{
    int n = T->degree, m = G(other_degree)(n);
    num P[MOST_OF_NET], part[MOST_OF_NET], a = parameter(T, "a"), b = parameter(T, "b"), one = from_int(1);
    num u[2] = {unknown(T, "u", 0), unknown(T, "u", 1)}, w[2] = {unknown(T, "w", 0), unknown(T, "w", 1)};
    G(free_net)(T, n, m, 1, P);
    G(bezier_surface_part)(G(net)(n, m, 1, P), u[0], u[1], w[fault(T, 0, 1)], w[fault(T, 1, 0)], part);
    num there_u = add(mul(sub(one, a), u[0]), mul(a, u[1])), there_w = add(mul(sub(one, b), w[0]), mul(b, w[1]));
    same(T, G(surface)(n, m, 1, part, 0, 0, 0, a, b), G(surface)(n, m, 1, P, 0, 0, 0, there_u, there_w));
}

/*
The degrees above are $n$ and $\lfloor\frac n2\rfloor+1$, and coordinates do not mix.  That the kernels keep three of them apart, also where the
degree in $w$ is not the lower one, is seen on nets of space: square ones, bicubic among them, and with one more column.

:::{claim} surface_kernels_in_space
:title: Points, lines, pieces and derivatives of square nets of space, and of those with one more column
:zh: 空间网格上的曲面算法
:given: nets of degrees $n$ and $m=n$, and $n$ and $m=n+1$, in space; any $u,w$; pieces with the ends $u_0,u_1$ and $w_0,w_1$ in any order
:then: the kernels for points, parameter lines, transposed nets, derivatives up to the orders 4 in $u$ and 3 in $w$ and for pieces give the double
  sum, its derivatives and its pieces
:method: Against the double sums of the definition, coordinate by coordinate; everything a variable.
:degrees: 0..3 sampled 4
:over: t: u; u# w#: ends
:control: $u$ and $w$ exchanged
:::
*/
CLAIM(surface_kernels_in_space)
{
    enum { space = 3, in_u = 4, in_w = 3 };
    int n = T->degree;
    num u = parameter(T, "u"), w = parameter(T, "w"), one = from_int(1);
    num ends[4] = {unknown(T, "u", 0), unknown(T, "u", 1), unknown(T, "w", 0), unknown(T, "w", 1)};
    num x = fault(T, u, w), y = fault(T, w, u); /* where the kernels are asked */
    for (int m = n; m <= n + 1; m++) {
        num P[MOST_OF_NET * space], Q[MOST_OF_NET * space], line[MOST_OF_NET * space], at[space];
        num D[(in_u + 1) * (in_w + 1) * space];
        G(free_net)(T, n, m, space, P);
        struct G(net) net = G(net)(n, m, space, P);
        G(bezier_surface_point)(net, x, y, at);
        G(bezier_surface_transpose)(net, Q);
        G(bezier_surface_line)(G(net)(m, n, space, Q), y, line);
        G(bezier_surface_derivatives)(net, x, y, in_u, in_w, D);
        for (int c = 0; c < space; c++) {
            about(T, "the point");
            same(T, at[c], G(surface)(n, m, space, P, c, 0, 0, u, w));
            about(T, "the line w = const");
            same(T, G(curve)(n, space, line, c, u), at[c]);
            about(T, "a derivative");
            for (int k = 0; k <= in_u; k++)
                for (int l = 0; l <= in_w; l++)
                    same(T, D[(k * (in_w + 1) + l) * space + c], G(surface)(n, m, space, P, c, k, l, u, w));
        }
        G(bezier_surface_part)(net, ends[0], ends[1], ends[2], ends[3], Q);
        num there_u = add(mul(sub(one, x), ends[0]), mul(x, ends[1]));
        num there_w = add(mul(sub(one, y), ends[2]), mul(y, ends[3]));
        about(T, "the piece");
        for (int c = 0; c < space; c++)
            same(T, G(surface)(n, m, space, Q, c, 0, 0, u, w), G(surface)(n, m, space, P, c, 0, 0, there_u, there_w));
    }
}

#include "chapters/judge/claims_off.h"
