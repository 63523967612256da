/*
# De Casteljau's algorithm (de Casteljau 算法)

A Bézier curve is $b(t)=\sum_{i=0}^nB_i^n(t)\,b_i$.  De Casteljau's algorithm never computes a Bernstein
polynomial: it divides the edges of the polygon in the ratio $t:(1-t)$, divides the edges of the new polygon, and so
on until one point is left,

$$b_i^0=b_i,\qquad b_i^k=(1-t)\,b_i^{k-1}+t\,b_{i+1}^{k-1},\qquad i=0,\dots,n-k.$$
*/
#include "chapters/bezier/definition.h"

#include "chapters/judge/claims_on.h"

enum { dim = 2 }; /* the plane: every formula is taken coordinate by coordinate */

/*
## Points

:::{claim} casteljau_triangle_holds_partial_curves
:title: A point of the triangle is the point of a curve of lower degree
:zh: 三角阵中间点即低次曲线上的点
:given: points $b_0,\dots,b_n$ of the plane, any $t$
:then: $b_i^k=\sum_{j=0}^kB_j^k(t)\,b_{i+j}$ for all $k\le n$, $i\le n-k$, and at every level the last point is left as it was
:method: The levels of the kernel one after the other, against the definition of the curve of $b_i,\dots,b_{i+k}$, at a
  variable $t$ with every coordinate a variable.
:degrees: 0..6 sampled 12
:defines: bezier_casteljau_level
:control: $t$ and $1-t$ exchanged at the last level
:::
*/
CLAIM(casteljau_triangle_holds_partial_curves)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * dim], w[(MAX_DEGREE + 1) * dim], t = parameter(T, "t"), last[dim];
    G(free_points)(T, n, dim, b);
    for (int m = 0; m < (n + 1) * dim; m++)
        w[m] = b[m];
    for (int k = 1; k <= n; k++) {
        int points = n + 1 - k; /* after this level */
        for (int c = 0; c < dim; c++)
            last[c] = w[points * dim + c];
        G(bezier_casteljau_level)(points, dim, w, fault(T, t, k == n ? sub(from_int(1), t) : t));
        about(T, "b_i^k");
        for (int i = 0; i < points; i++)
            for (int c = 0; c < dim; c++)
                same(T, w[i * dim + c], G(curve)(k, dim, b + i * dim, c, t));
        about(T, "the last point");
        for (int c = 0; c < dim; c++)
            same(T, w[points * dim + c], last[c]);
    }
    if (n == 0)
        same(T, w[0], b[0]);
}

/*
The point at the tip of the triangle is the special case $k=n$.  Every other point of it is a point of a curve too, of a
shorter polygon; this is what the recursion of the slides says in another section.

:::{claim} decasteljau_evaluates_bezier_curve
:title: De Casteljau's algorithm computes the point of the curve
:zh: de Casteljau 算法求曲线上的点
:given: points $b_0,\dots,b_n$ of the plane, any $t$
:then: `bezier_casteljau` gives $b(t)=\sum_i\binom ni(1-t)^{n-i}t^i\,b_i$
:method: The kernel against the sum, at a variable $t$ with every coordinate a variable; also with the result in the place
  of the first point.
:degrees: 0..7 sampled 16
:defines: bezier_casteljau
:control: the kernel given the points without the first one, in degree $n-1$
:::
*/
CLAIM(decasteljau_evaluates_bezier_curve)
{
    int n = T->degree, skip = fault(T, 0, n > 0);
    num b[(MAX_DEGREE + 1) * dim], P[dim], at[dim], t = parameter(T, "t");
    G(free_points)(T, n, dim, b);
    for (int c = 0; c < dim; c++)
        at[c] = G(curve)(n, dim, b, c, t);
    G(bezier_casteljau)(n - skip, dim, b + skip * dim, t, P);
    for (int c = 0; c < dim; c++)
        same(T, P[c], at[c]);
    G(bezier_casteljau)(n, dim, b, t, b);
    for (int c = 0; c < dim; c++)
        same(T, b[c], at[c]);
}

/*
:::{claim} horner_bernstein_evaluates_bezier_curve
:title: Horner's rule in the Bernstein form computes the point of the curve
:zh: Bernstein 形式的 Horner 法则
:given: points $b_0,\dots,b_n$ of the plane, any $t$
:then: `bezier_horner` gives $b(t)$
:method: The kernel against the sum, at a variable $t$ with every coordinate a variable.
:degrees: 0..7 sampled 16
:defines: bezier_horner
:control: $t$ and $1-t$ exchanged
:::
*/
CLAIM(horner_bernstein_evaluates_bezier_curve)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * dim], P[dim], t = parameter(T, "t");
    G(free_points)(T, n, dim, b);
    G(bezier_horner)(n, dim, b, fault(T, t, sub(from_int(1), t)), P);
    for (int c = 0; c < dim; c++)
        same(T, P[c], G(curve)(n, dim, b, c, t));
}

/*
Two properties can be seen without any formula.  Each step divides an edge in a ratio, and an affine map keeps ratios on a
line: so the whole construction moves with the points.  And the ratio $t:(1-t)$, read from the other end, is $(1-t):t$: so the
reversed polygon gives the same curve backwards.

:::{claim} bezier_curve_moves_with_its_points
:title: An affine map of the points is the same map of the curve
:zh: 仿射不变性
:given: points $b_0,\dots,b_n$ of the plane, any affine map, any $t$
:then: the curve of the mapped points is the mapped curve
:method: Map, points and $t$ are variables.
:degrees: 0..6 sampled 12
:over: m# v#: affine maps
:control: the last point is not moved
:::
*/
CLAIM(bezier_curve_moves_with_its_points)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * dim], moved[(MAX_DEGREE + 1) * dim], M[dim * dim], v[dim], P[dim], Q[dim];
    num t = parameter(T, "t");
    G(free_points)(T, n, dim, b);
    for (int m = 0; m < dim * dim; m++)
        M[m] = unknown(T, "m", m);
    for (int c = 0; c < dim; c++)
        v[c] = unknown(T, "v", c);
    for (int i = 0; i <= n; i++)
        for (int c = 0; c < dim; c++) {
            num image = add(add(mul(M[c * dim], b[i * dim]), mul(M[c * dim + 1], b[i * dim + 1])), v[c]);
            moved[i * dim + c] = fault(T, image, i == n ? b[i * dim + c] : image);
        }
    G(bezier_casteljau)(n, dim, b, t, P);
    G(bezier_casteljau)(n, dim, moved, t, Q);
    for (int c = 0; c < dim; c++)
        same(T, Q[c], add(add(mul(M[c * dim], P[0]), mul(M[c * dim + 1], P[1])), v[c]));
}

/*
:::{claim} reversed_points_reverse_the_curve
:title: The reversed polygon gives the curve backwards
:zh: 控制顶点反序,曲线反向
:given: points $b_0,\dots,b_n$ of the plane, any $t$
:then: the curve of $b_n,\dots,b_0$ at $t$ is $b(1-t)$
:method: Both by de Casteljau's algorithm at a variable $t$.
:degrees: 0..6 sampled 12
:control: the right side at $t$
:::
*/
CLAIM(reversed_points_reverse_the_curve)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * dim], r[(MAX_DEGREE + 1) * dim], P[dim], Q[dim], t = parameter(T, "t");
    G(free_points)(T, n, dim, b);
    for (int i = 0; i <= n; i++)
        for (int c = 0; c < dim; c++)
            r[i * dim + c] = b[(n - i) * dim + c];
    G(bezier_casteljau)(n, dim, r, t, P);
    G(bezier_casteljau)(n, dim, b, fault(T, sub(from_int(1), t), t), Q);
    for (int c = 0; c < dim; c++)
        same(T, P[c], Q[c]);
}

/*
## The blossom (极形式)

If every level of the triangle has its own parameter, the last point is a function of $n$ arguments.  It is the only
symmetric function, affine in each argument, that gives the curve when all arguments are equal: such a function is
fixed by its values at arguments $0$ and $1$, these are the points $b_i$, and the curve determines the $b_i$.

:::{claim} blossom_is_sum_over_subsets
:title: The blossom as a sum over subsets of its arguments
:zh: 极形式对自变量子集展开
:given: points $b_0,\dots,b_n$ of the plane, arguments $u_1,\dots,u_n$
:then: $b[u_1,\dots,u_n]=\sum_{S\subseteq\{1,\dots,n\}}\ \prod_{k\in S}u_k\prod_{k\notin S}(1-u_k)\;b_{|S|}$
:method: The kernel against the sum over all $2^n$ subsets, arguments and coordinates variables.
:degrees: 0..6 sampled 8
:over: u#: arguments
:defines: bezier_blossom
:control: the first argument taken as the last as well
:::
*/
CLAIM(blossom_is_sum_over_subsets)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * dim], u[MAX_DEGREE + 1], P[dim], sum[dim];
    G(free_points)(T, n, dim, b);
    for (int k = 0; k < n; k++)
        u[k] = unknown(T, "u", k);
    for (int c = 0; c < dim; c++)
        sum[c] = from_int(0);
    for (int S = 0; S < 1 << n; S++) {
        num product = from_int(1);
        int size = 0;
        for (int k = 0; k < n; k++) {
            int in = S >> k & 1;
            product = mul(product, in ? u[k] : sub(from_int(1), u[k]));
            size += in;
        }
        for (int c = 0; c < dim; c++)
            sum[c] = add(sum[c], mul(product, b[size * dim + c]));
    }
    if (T->faulty && n > 1)
        u[n - 1] = u[0];
    G(bezier_blossom)(n, dim, b, u, P);
    for (int c = 0; c < dim; c++)
        same(T, P[c], sum[c]);
}

/*
:::{claim} blossom_is_symmetric
:title: The blossom is symmetric
:zh: 极形式的对称性
:given: numbers $b_0,\dots,b_n$, arguments $u_1,\dots,u_n$
:then: exchanging two neighbouring arguments changes nothing, hence no permutation does
:method: The kernel before and after each exchange, everything a variable; these exchanges generate all permutations.
:degrees: 2..6 sampled 12
:over: x#: coefficients; u#: arguments
:control: the second of the two arguments is put in both places
:::
*/
CLAIM(blossom_is_symmetric)
{
    int n = T->degree;
    num b[MAX_DEGREE + 1], u[MAX_DEGREE], P, Q;
    G(free_points)(T, n, 1, b);
    for (int k = 0; k < n; k++)
        u[k] = unknown(T, "u", k);
    G(bezier_blossom)(n, 1, b, u, &P);
    for (int k = 0; k + 1 < n; k++) {
        num first = u[k], second = u[k + 1];
        u[k] = second;
        u[k + 1] = fault(T, first, second);
        G(bezier_blossom)(n, 1, b, u, &Q);
        same(T, Q, P);
        u[k] = first, u[k + 1] = second;
    }
}

/*
:::{claim} blossom_is_affine_in_each_argument
:title: The blossom is affine in each argument
:zh: 极形式的多重仿射性
:given: numbers $b_0,\dots,b_n$, arguments $u_1,\dots,u_n$, and $v$, $a$
:then: $b[\dots,(1-a)u_k+av,\dots]=(1-a)\,b[\dots,u_k,\dots]+a\,b[\dots,v,\dots]$ for every $k$
:method: The three values of the kernel, everything a variable.
:degrees: 1..6 sampled 12
:over: x#: coefficients; u#: arguments; v: argument; a: factor
:control: the factors $1-a$ and $a$ on the right exchanged
:::
*/
CLAIM(blossom_is_affine_in_each_argument)
{
    int n = T->degree;
    num b[MAX_DEGREE + 1], u[MAX_DEGREE], P, Q, between;
    num a = parameter(T, "a"), a1 = sub(from_int(1), a), v = unknown(T, "v", 0);
    G(free_points)(T, n, 1, b);
    for (int k = 0; k < n; k++)
        u[k] = unknown(T, "u", k);
    G(bezier_blossom)(n, 1, b, u, &P);
    for (int k = 0; k < n; k++) {
        num kept = u[k];
        u[k] = v;
        G(bezier_blossom)(n, 1, b, u, &Q);
        u[k] = add(mul(a1, kept), mul(a, v));
        G(bezier_blossom)(n, 1, b, u, &between);
        same(T, between, fault(T, add(mul(a1, P), mul(a, Q)), add(mul(a, P), mul(a1, Q))));
        u[k] = kept;
    }
}

/*
:::{claim} blossom_on_diagonal_is_curve
:title: With equal arguments the blossom is the curve, with arguments 0 and 1 a control point
:zh: 极形式的对角线即曲线,其端值即控制顶点
:given: points $b_0,\dots,b_n$ of the plane, any $t$
:then: $b[t,\dots,t]=b(t)$, and $b[0,\dots,0,1,\dots,1]=b_i$ with $i$ arguments $1$
:method: The kernel against the definition of the curve at a variable $t$, and against the variables $b_i$.
:degrees: 0..6 sampled 12
:control: one argument $0$ more among the equal ones
:::
*/
CLAIM(blossom_on_diagonal_is_curve)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * dim], u[MAX_DEGREE + 1], P[dim], t = parameter(T, "t");
    G(free_points)(T, n, dim, b);
    for (int k = 0; k < n; k++)
        u[k] = fault(T, t, k == 0 ? from_int(0) : t);
    G(bezier_blossom)(n, dim, b, u, P);
    about(T, "b[t, ..., t]");
    for (int c = 0; c < dim; c++)
        same(T, P[c], G(curve)(n, dim, b, c, t));
    about(T, "b[0, ..., 1]");
    for (int i = 0; i <= n; i++) {
        for (int k = 0; k < n; k++)
            u[k] = from_int(k >= n - i);
        G(bezier_blossom)(n, dim, b, u, P);
        for (int c = 0; c < dim; c++)
            same(T, P[c], b[i * dim + c]);
    }
}

/*
## Derivatives (导矢)

The derivative of a curve is again a curve of this kind, one degree lower, and its points are the edges of the polygon, times $n$.
Done $r$ times this gives differences of order $r$; done at an end it says how many points the curve sees there.

:::{claim} hodograph_is_derivative_curve
:title: The derivative is the curve of n times the edges
:zh: 速端曲线
:given: points $b_0,\dots,b_n$ of the plane, any $t$
:then: the curve of degree $n-1$ of the points $n(b_{i+1}-b_i)$ of `bezier_hodograph` is $b'$; its last point is left as it was
:method: The curve of the kernel's points, from the definition, against the derivative of the curve: in the field as the
  derivative of a rational function of $t$, in the other number types power by power.
:degrees: 1..6 sampled 12
:defines: bezier_hodograph
:control: the factor $n$ taken as $n-1$
:::
*/
CLAIM(hodograph_is_derivative_curve)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * dim], D[(MAX_DEGREE + 1) * dim], t = parameter(T, "t");
    G(free_points)(T, n, dim, b);
    for (int m = 0; m < (n + 1) * dim; m++)
        D[m] = b[m];
    G(bezier_hodograph)(n, dim, D);
    for (int m = 0; m < n * dim; m++)
        D[m] = fault(T, D[m], mul(D[m], from_ratio(n - 1, n)));
    for (int c = 0; c < dim; c++) {
        about(T, "b'");
        same(T, G(curve)(n - 1, dim, D, c, t), G(curve_derivative)(n, dim, b, c, 1, t));
        about(T, "the last point");
        same(T, D[n * dim + c], b[n * dim + c]);
    }
}

/*
:::{claim} differences_give_every_derivative
:title: The r-th derivative is the curve of the r-th differences
:zh: r 阶导矢由 r 阶差分给出
:given: points $b_0,\dots,b_n$ of the plane, $0\le r\le n$, any $t$
:then: the points of `bezier_differences` are $\frac{n!}{(n-r)!}\Delta^rb_i$ with
  $\Delta^rb_i=\sum_k(-1)^{r-k}\binom rk\,b_{i+k}$, and their curve of degree $n-r$ is $b^{(r)}$
:method: The kernel's points against the alternating sums, and their curve, from the definition, against the derivative
  of the curve.
:degrees: 0..6 sampled 10
:defines: bezier_differences
:control: the curve of the points taken backwards
:::
*/
CLAIM(differences_give_every_derivative)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * dim], D[(MAX_DEGREE + 1) * dim], t = parameter(T, "t");
    G(free_points)(T, n, dim, b);
    for (int r = 0; r <= n; r++) {
        G(bezier_differences)(n, dim, b, r, D);
        num factor = from_int(G(falling_factorial)(n, r)); /* n!/(n-r)! */
        for (int c = 0; c < dim; c++) {
            about(T, "the differences");
            for (int i = 0; i <= n - r; i++)
                same(T, D[i * dim + c], mul(factor, G(difference)(dim, b, c, i, r)));
            about(T, "the derivative");
            num at = fault(T, t, sub(from_int(1), t));
            same(T, G(curve)(n - r, dim, D, c, at), G(curve_derivative)(n, dim, b, c, r, t));
        }
    }
}

/*
:::{claim} bezier_derivatives_of_every_order
:title: The kernel computes all derivatives at a parameter
:zh: 任一参数处的各阶导矢
:given: points $b_0,\dots,b_n$ of the plane, any $t$, orders $0,\dots,n+1$
:then: `bezier_derivatives` gives $b^{(k)}(t)$, $0$ for $k>n$
:method: The kernel against the derivatives of the definition: in the field of a rational function of $t$, in the other
  number types power by power.
:degrees: 0..6 sampled 10
:defines: bezier_derivatives
:control: the derivatives of the reversed polygon
:::
*/
CLAIM(bezier_derivatives_of_every_order)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * dim], r[(MAX_DEGREE + 1) * dim], D[(MAX_DEGREE + 2) * dim], t = parameter(T, "t");
    G(free_points)(T, n, dim, b);
    for (int i = 0; i <= n; i++)
        for (int c = 0; c < dim; c++)
            r[i * dim + c] = b[fault(T, i, n - i) * dim + c];
    G(bezier_derivatives)(n, dim, r, t, n + 1, D);
    for (int k = 0; k <= n + 1; k++)
        for (int c = 0; c < dim; c++)
            same(T, D[k * dim + c], G(curve_derivative)(n, dim, b, c, k, t));
}

/*
At an end only the nearest points count: the derivative of order $r$ there depends on $r+1$ points.

:::{claim} end_derivatives_are_end_differences
:title: The derivatives at the ends
:zh: 端点的各阶导矢
:given: points $b_0,\dots,b_n$ of the plane, $0\le r\le n$
:then: $b^{(r)}(0)=\frac{n!}{(n-r)!}\Delta^rb_0$ and $b^{(r)}(1)=\frac{n!}{(n-r)!}\Delta^rb_{n-r}$; in particular
  $b(0)=b_0$, $b(1)=b_n$, $b'(0)=n(b_1-b_0)$, $b'(1)=n(b_n-b_{n-1})$
:method: The derivatives of the definition at the two integers against the alternating sums, every coordinate a variable.
:degrees: 0..6 sampled 10
:over: t: -
:control: the points at $t=1$ counted one too low, where there is one
:::
*/
CLAIM(end_derivatives_are_end_differences)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * dim];
    G(free_points)(T, n, dim, b);
    for (int r = 0; r <= n; r++) {
        num factor = from_int(G(falling_factorial)(n, r)); /* n!/(n-r)! */
        int last = fault(T, n - r, n > r ? n - r - 1 : n - r);
        for (int c = 0; c < dim; c++) {
            about(T, "at t = 0");
            same(T, G(curve_derivative)(n, dim, b, c, r, from_int(0)), mul(factor, G(difference)(dim, b, c, 0, r)));
            about(T, "at t = 1");
            same(T, G(curve_derivative)(n, dim, b, c, r, from_int(1)), mul(factor, G(difference)(dim, b, c, last, r)));
        }
    }
}

/*
## Subdivision (离散、分割)

The sides of the triangle are polygons of the two parts of the curve: the points $b_0^0,b_0^1,\dots,b_0^n$ that of the
part over $[0,t]$, the points $b_0^n,b_1^{n-1},\dots,b_n^0$ that of the part over $[t,1]$.

:::{claim} split_gives_the_two_parts
:title: The two sides of the triangle are the polygons of the two parts
:zh: 分割所得为原曲线的两段
:given: points $b_0,\dots,b_n$ of the plane, any $t$, any $u$
:then: the curves of `bezier_split` at $u$ are $b(tu)$ and $b(t+(1-t)u)$
:method: The curves of the kernel's points and of the given ones, both from the definition, everything a variable.
:degrees: 0..6 sampled 12
:defines: bezier_split
:control: the right part at $b(t+(1-t)u)$ compared with the curve at $b((1-t)+tu)$
:::
*/
CLAIM(split_gives_the_two_parts)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * dim], left[(MAX_DEGREE + 1) * dim], right[(MAX_DEGREE + 1) * dim];
    num t = parameter(T, "t"), u = parameter(T, "u"), s = sub(from_int(1), t);
    G(free_points)(T, n, dim, b);
    G(bezier_split)(n, dim, b, t, left, right);
    for (int c = 0; c < dim; c++) {
        about(T, "the part over [0,t]");
        same(T, G(curve)(n, dim, left, c, u), G(curve)(n, dim, b, c, mul(t, u)));
        about(T, "the part over [t,1]");
        num at = fault(T, add(t, mul(s, u)), add(s, mul(t, u)));
        same(T, G(curve)(n, dim, right, c, u), G(curve)(n, dim, b, c, at));
    }
}

/*
A part is found by one run of the algorithm.  To find a part between two parameters one may split twice, and the order must not
matter; that it does not is another way to say that the blossom is symmetric.

:::{claim} splits_commute
:title: Two splits give the same three parts in either order
:zh: 两次分割次序无关
:given: numbers $b_0,\dots,b_n$, parameters $t\ne0$ and $v=st\ne1$
:where: $t\ne0$ and $v\ne1$
:then: splitting at $t$ and then the left part at $s=\frac vt$ gives the same three polygons as splitting at $v$ and then the
  right part at $\frac{t-v}{1-v}$
:method: All six polygons by the kernel, everything a variable.
:degrees: 0..6 sampled 12
:over: x#: coefficients; s t: parameter value
:control: the right part split at $t$
:::
*/
CLAIM(splits_commute)
{
    int n = T->degree;
    num b[MAX_DEGREE + 1], first[3][MAX_DEGREE + 1], then[3][MAX_DEGREE + 1], rest[MAX_DEGREE + 1];
    num t = parameter(T, "t"), s = parameter(T, "s"), v = mul(s, t), one = from_int(1);
    G(free_points)(T, n, 1, b);
    G(bezier_split)(n, 1, b, t, rest, first[2]);
    G(bezier_split)(n, 1, rest, s, first[0], first[1]);
    G(bezier_split)(n, 1, b, v, then[0], rest);
    G(bezier_split)(n, 1, rest, fault(T, div(sub(t, v), sub(one, v)), t), then[1], then[2]);
    for (int part = 0; part < 3; part++)
        for (int i = 0; i <= n; i++)
            same(T, then[part][i], first[part][i]);
}

/*
:::{claim} interval_kernel_gives_the_part
:title: The polygon of the curve from u to v
:zh: 任意子区间上的控制顶点
:given: points $b_0,\dots,b_n$ of the plane, any $u$ and $v$, any $x$
:then: the curve of `bezier_on_interval` at $x$ is $b((1-x)u+xv)$
:method: The curves of the kernel's points and of the given ones, both from the definition, everything a variable.
:degrees: 0..6 sampled 10
:over: u v p: parameter value
:defines: bezier_on_interval
:control: $u$ and $v$ exchanged
:::
*/
CLAIM(interval_kernel_gives_the_part)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * dim], part[(MAX_DEGREE + 1) * dim];
    num u = unknown(T, "u", 0), v = unknown(T, "v", 0), x = parameter(T, "p");
    G(free_points)(T, n, dim, b);
    G(bezier_on_interval)(n, dim, b, fault(T, u, v), fault(T, v, u), part);
    num at = add(mul(sub(from_int(1), x), u), mul(x, v));
    for (int c = 0; c < dim; c++)
        same(T, G(curve)(n, dim, part, c, x), G(curve)(n, dim, b, c, at));
}

/*
:::{claim} bernstein_form_over_another_interval
:title: The same polynomial in the Bernstein form of another interval
:zh: 换区间的 Bernstein 形式
:given: coefficients $f_0,\dots,f_n$ over $[a,b]$, $a\ne b$, any $c$ and $d$, any $x$
:where: $a\ne b$
:then: the coefficients $g$ of `bernstein_on_interval` have
  $\sum g_iB_i^n(x)=\sum f_iB_i^n\bigl(\frac{y-a}{b-a}\bigr)$ at $y=c+x(d-c)$
:method: Both sums from the definition, everything a variable.
:degrees: 0..6 sampled 10
:over: f#: coefficients; a h c d: interval; p: parameter value
:defines: bernstein_on_interval
:control: the interval $[a,b]$ taken backwards
:::
*/
CLAIM(bernstein_form_over_another_interval)
{
    int n = T->degree;
    num f[MAX_DEGREE + 1], g[MAX_DEGREE + 1], x = parameter(T, "p");
    num a = unknown(T, "a", 0), b = add(a, unknown(T, "h", 0)), c = unknown(T, "c", 0), d = unknown(T, "d", 0);
    for (int i = 0; i <= n; i++)
        f[i] = unknown(T, "f", i);
    G(bernstein_on_interval)(n, fault(T, a, b), fault(T, b, a), f, c, d, g);
    num y = add(c, mul(x, sub(d, c)));
    same(T, G(curve)(n, 1, g, 0, x), G(curve)(n, 1, f, 0, div(sub(y, a), sub(b, a))));
}

/*
## Degree elevation (升阶)

A curve of degree $n$ is also one of degree $n+1$.  Its new polygon has one point more, and the point on each edge is found from the two
ends of that edge alone.

:::{claim} elevation_keeps_bezier_curve
:title: Elevation changes the polygon, not the curve
:zh: 升阶不改变曲线
:given: points $b_0,\dots,b_n$ of the plane, any $t$
:then: the curve of degree $n+1$ of the points of `bezier_elevate` is the curve of the $b_i$; the points are
  $(1-\frac i{n+1})b_i+\frac i{n+1}b_{i-1}$, the rows of the elevation matrix
:method: Both curves from the definition at a variable $t$, and the points against `bernstein_elevation_matrix`.
:degrees: 0..7 sampled 14
:defines: bezier_elevate
:control: one inner point left where it was
:::
*/
CLAIM(elevation_keeps_bezier_curve)
{
    int n = T->degree;
    num b[(MAX_DEGREE + 1) * dim], e[(MAX_DEGREE + 2) * dim], t = parameter(T, "t");
    num E[(MAX_DEGREE + 2) * (MAX_DEGREE + 1)];
    G(free_points)(T, n, dim, b);
    G(bezier_elevate)(n, dim, b, e);
    if (T->faulty && n > 0)
        e[dim] = b[dim];
    G(bernstein_elevation_matrix)(n, E);
    for (int c = 0; c < dim; c++) {
        about(T, "the curve");
        same(T, G(curve)(n + 1, dim, e, c, t), G(curve)(n, dim, b, c, t));
        about(T, "the points");
        for (int i = 0; i <= n + 1; i++) {
            num row = from_int(0);
            for (int j = 0; j <= n; j++)
                row = add(row, mul(E[i * (n + 1) + j], b[j * dim + c]));
            same(T, e[i * dim + c], row);
        }
    }
}
#include "chapters/judge/claims_off.h"
