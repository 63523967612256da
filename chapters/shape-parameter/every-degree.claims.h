/*
# The family in every degree (任意次的情形)

The corrected functions have a rule that does not know the number seven.  Take $n-2$ levels of de Casteljau's triangle;
three points $b_0,b_1,b_2$ are left, which depend on $t$.  The last two levels of the Bézier curve would blend them with
$s^2$, $2st$, $t^2$.  Here they are blended with the functions of the family for $n=2$,

$$q_\beta=s^2(1-\beta t)\,b_0+(2+\beta)st\,b_1+t^2(1-\beta s)\,b_2=q_0+\beta st\bigl(b_1-(s\,b_0+t\,b_2)\bigr).$$

This is what $\beta$ means: it pushes the point of the Bézier curve away from a point on the chord of the last triangle,
in the direction of the triangle's vertex.  For $\beta=-2$ the point is on the chord.
*/
#include "exact/record/hull.h"

#include "chapters/shape-parameter/definition.h"
#include "chapters/shape-parameter/distance.h"

#include "chapters/judge/claims_on.h"

/*
:::{claim} curve_is_a_blend_of_three_points
:title: The curve is a blend of the last three points of de Casteljau's triangle
:zh: 曲线是 de Casteljau 三角阵最后三点的混合
:given: points $P_0,\dots,P_n$ of the plane, any $\beta$, $h$ and $t$
:then: $q_\beta(t)=s^2(1-\beta t)b_0+(2+\beta)st\,b_1+t^2(1-\beta s)b_2$ with $b_j=\sum_iB_i^{n-2}(t)P_{i+j}$, and
  $q_{\beta+h}(t)-q_\beta(t)=h\,st(b_1-(s\,b_0+t\,b_2))$
:method: The Bézier points of the curve, in the sum of Bernstein polynomials of degree $n+1$, against the blend; everything a
  variable; coordinate by coordinate, so that it is true in every dimension.
:degrees: 2..7 sampled 12
:over: h: step of β
:control: $b_0$ and $b_2$ exchanged
:::
*/
CLAIM(curve_is_a_blend_of_three_points)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], Q[(MAX_DEGREE + 1) * dim], R[(MAX_DEGREE + 1) * dim];
    num beta = unknown(T, "beta", 0), h = unknown(T, "h", 0), t = parameter(T, "t"), s = sub(from_int(1), t);
    num st = mul(s, t), one = from_int(1);
    G(free_points)(T, n, dim, P);
    G(bezier_points_of)(0, n, dim, P, beta, Q);
    G(bezier_points_of)(0, n, dim, P, add(beta, h), R);
    for (int c = 0; c < dim; c++) {
        num b[3], q = from_int(0), moved = from_int(0);
        for (int j = 0; j <= 2; j++) {
            b[j] = from_int(0);
            for (int i = 0; i <= n - 2; i++) {
                num bernstein = mul(G(choose)(n - 2, i), G(product_of_powers)(n - 2 - i, i, t));
                b[j] = add(b[j], mul(bernstein, P[(i + j) * dim + c]));
            }
        }
        if (T->faulty) {
            num kept = b[0];
            b[0] = b[2], b[2] = kept;
        }
        for (int k = 0; k <= n + 1; k++) {
            num bernstein = mul(G(choose)(n + 1, k), G(product_of_powers)(n + 1 - k, k, t));
            q = add(q, mul(bernstein, Q[k * dim + c]));
            moved = add(moved, mul(bernstein, R[k * dim + c]));
        }
        num first = mul(mul(mul(s, s), sub(one, mul(beta, t))), b[0]);
        num middle = mul(mul(add(from_int(2), beta), st), b[1]);
        num last = mul(mul(mul(t, t), sub(one, mul(beta, s))), b[2]);
        about(T, "the blend");
        /* q = s² (1 - βt) b_0 + (2 + β) st b_1 + t² (1 - βs) b_2 */
        same(T, q, add(first, add(middle, last)));
        about(T, "how it moves");
        /* q_{β+h} - q_β = h st (b_1 - (s b_0 + t b_2)) */
        same(T, sub(moved, q), mul(mul(h, st), sub(b[1], add(mul(s, b[0]), mul(t, b[2])))));
    }
}

#if RATIONAL
/*
:::{claim} blend_is_convex_from_minus_two_to_one
:title: The factors of the last three points are nonnegative for beta from -2 to 1, and only that of the middle point grows with beta
:zh: -2≤β≤1 时点在最后的三角形内
:kind: decision
:data: range of β = -2 1
:instead: range of β = -3 1
:given: the three functions of the family for $n=2$, all real $\beta$
:then: their factors are all nonnegative exactly for $-2\le\beta\le1$; that of $b_1$ grows with $\beta$, those of $b_0$ and $b_2$
  do not grow, for every $t\in[0,1]$
:method: Signs of linear polynomials in $\beta$; the slopes of the factors are whole numbers.
:scope: every real β
:control: a range that begins earlier
:::
*/
CLAIM(blend_is_convex_from_minus_two_to_one)
{
    num range[2];
    given_points(T, "range of β", 2, 1, range);
    num low = range[0], high = range[1];
    poly near[3], far[3];
    G(factors_in_beta)(0, 2, near, far);
    for (int i = 0; i <= 2; i++) {
        agree(T, is_nonnegative_on(near[i], low, high) && is_nonnegative_on(far[i], low, high));
        int up = sign_q(poly_coefficient(near[i], 1)), also = sign_q(poly_coefficient(far[i], 1));
        agree(T, i == 1 ? up > 0 && also > 0 : up <= 0 && also <= 0);
    }
    agree(T, is_zero_q(poly_value(near[1], low)) && is_zero_q(poly_value(far[0], high)));
    agree(T, sign_q(poly_coefficient(far[0], 1)) < 0);
}
#endif

/*
## The range of the parameter in every degree

For $n=7$ it was $\nu_2$ that fixed the lower end of the range.  Which index it is, depends on $n$.  By the closed form
below $\nu_k$ vanishes at $\beta=-\frac{n(n-1)}{k(n+1-2k)}$, and the range begins at the largest of these numbers; the
denominator is largest for $k$ near $\frac{n+1}4$.  In the degrees up to five this is $k=1$, and the range begins at $-n$.
From degree six on another index is first, and the pattern that suggests $-7$ for $n=7$ is broken.  The upper end is 1 in
every degree, because of $\varphi_0$.

:::{claim} factors_in_closed_form
:title: The factors in closed form
:zh: 线性因子的封闭形式
:given: any $\beta$, $k=0,\dots,n$
:then: $n(n-1)\nu_k=\binom nk\bigl(n(n-1)+\beta k(n+1-2k)\bigr)$
:method: The kernel against the closed form, $\beta$ a variable.
:degrees: 2..16 sampled 40
:control: $n+1-k$ in the place of $n+1-2k$
:::
*/
CLAIM(factors_in_closed_form)
{
    int n = T->degree;
    num beta = unknown(T, "beta", 0), near[MAX_DEGREE + 1], far[MAX_DEGREE + 1];
    G(shape_factors)(n, beta, near, far);
    for (int k = 0; k <= n; k++) {
        num inner = add(from_int(n * (n - 1)), mul(from_int(k * (n + 1 - fault(T, 2, 1) * k)), beta));
        /* n (n-1) ν_k = C(n,k) (n (n-1) + β k (n+1-2k)) */
        same(T, mul(from_int(n * (n - 1)), near[k]), mul(G(choose)(n, k), inner));
    }
}

#if RATIONAL
/*
:::{claim} range_of_every_degree
:title: The range in which the functions are nonnegative
:zh: 各次的非负范围
:kind: decision
:data: l = -2 -3 -4 -5 -5 -21/4 -28/5 -6 -6 -55/9 -44/7
:given: all real $\beta$, the corrected functions of degree $n$
:then: they are nonnegative on $[0,1]$ exactly for $l_n\le\beta\le1$, where $l_2$, $l_3$, … are the numbers $l$ in their order
:method: All factors are nonnegative on the interval, one vanishes at each end and is negative beyond it.
:degrees: 2..12
:scope: every real β
:control: the interval begins 1 below
:::
*/
CLAIM(range_of_every_degree)
{
    int n = T->degree, at_low = 0;
    num l[11];
    given_points(T, "l", 11, 1, l);
    num low = l[n - 2], high = from_int(1);
    low = fault(T, low, sub(low, high));
    poly near[MAX_DEGREE + 1], far[MAX_DEGREE + 1];
    G(factors_in_beta)(0, n, near, far);
    for (int i = 0; i <= n; i++) {
        agree(T, is_nonnegative_on(near[i], low, high) && is_nonnegative_on(far[i], low, high));
        at_low += is_zero_q(poly_value(near[i], low)) && sign_q(poly_coefficient(near[i], 1)) > 0;
    }
    agree(T, at_low > 0);
    agree(T, is_zero_q(poly_value(far[0], high)) && sign_q(poly_coefficient(far[0], 1)) < 0);
}
#endif

/*
No range goes below $-8$, however high the degree: by completing the square in $k(n+1-2k)$ as in the first identity below, and since some whole
$k$ has $|d|\le\frac12$, the bound is approached.  For the upper end take $j=k-1$: that $\varphi_j\ge0$ says $n(n-1)\ge\beta(n-j)(n-1-2j)$.

:::{claim} lower_end_is_between_two_bounds
:title: Two identities for the lower end of the range
:zh: 关于范围下端的两个恒等式
:given: any $n$, $k$ and $d$ with $k=\frac{n+1}4+d$
:then: $8k(n+1-2k)=(n+1)^2-16d^2$, and $8n(n-1)(n+3)=8n((n+1)^2-4)$
:method: Identities with $n$ and $d$ variables.
:degrees: all
:over: n d: k
:control: $(n+1)^2$ in the place of $(n+1)^2-4$
:::
*/
CLAIM(lower_end_is_between_two_bounds)
{
    num n = whole(T, "n", 2, 40), d = unknown(T, "d", 0), one = from_int(1), two = from_int(2), eight = from_int(8);
    num k = add(div(add(n, one), from_int(4)), d), square = mul(add(n, one), add(n, one));
    num product = mul(k, sub(add(n, one), mul(two, k)));
    /* 8k (n+1-2k) = (n+1)² - 16d² */
    same(T, mul(eight, product), sub(square, mul(from_int(16), mul(d, d))));
    /* 8n (n-1)(n+3) = 8n ((n+1)² - 4) */
    num left = mul(mul(eight, mul(n, sub(n, one))), add(n, from_int(3)));
    same(T, left, mul(mul(eight, n), fault(T, sub(square, from_int(4)), square)));
}

/*
:::{claim} upper_end_is_one
:title: An identity for the upper end of the range
:zh: 关于范围上端的恒等式
:given: any $n$ and $j$
:then: $n(n-1)-(n-j)(n-1-2j)=j(3n-1-2j)$
:method: An identity with $n$ and $j$ variables.
:degrees: all
:over: n j: k
:control: $3n-1-j$ in the last factor
:::
*/
CLAIM(upper_end_is_one)
{
    num n = whole(T, "n", 2, 40), j = whole(T, "j", 0, 40), one = from_int(1), two = from_int(2);
    /* n (n-1) - (n-j)(n-1-2j) = j (3n-1-2j) */
    num left = sub(mul(n, sub(n, one)), mul(sub(n, j), sub(sub(n, one), mul(two, j))));
    num last = mul(from_int(fault(T, 2, 1)), j);
    same(T, left, mul(j, sub(sub(mul(from_int(3), n), one), last)));
}

#if RATIONAL
/*
:::{claim} pattern_breaks_in_degree_six
:title: In degree six the range -n to 1 is too wide
:zh: 六次起 -n≤β≤1 不再保证非负
:kind: counterexample
:data: n = 6; t = 1/20
:instead: n = 5
:result: B_2(t) = -390963/128000000
:given: the degree $n$, $\beta=-n$ and a small $t$
:then: $B_{2,n}(t)<0$
:method: The value of the function, exactly.
:control: the degree one less
:::
*/
CLAIM(pattern_breaks_in_degree_six)
{
    int n = given_whole(T, "n");
    num B[MAX_DEGREE + 1];
    G(shape_basis)(n, from_int(-n), given(T, "t"), B);
    found(T, "B_2(t)", B[2]);
    about(T, "B_2(t) >= 0");
    nonnegative(T, B[2]);
}
#endif

/*
## What "closer" can mean

For three points the sentence is true in the strongest sense: while $-2\le\beta\le1$ no point of the curve moves away from
the polygon when $\beta$ grows.  The point is in the triangle.  Its distances from the lines of the two edges are multiples
of its weights at $P_2$ and $P_0$, which do not grow.  The nearest point of the polygon is the foot on an edge; or $P_0$ or
$P_2$, when the foot is beyond it.  (It is never $P_1$, unless the point is $P_1$: for a point $P_1+\lambda a+\mu c$ with
$a=P_0-P_1$, $c=P_2-P_1$, $\lambda,\mu\ge0$ not both feet can be beyond $P_1$, since $(\lambda a+\mu c)\cdot(\lambda a+\mu
c)\ge0$.) That the distance from $P_0$ falls while the foot is beyond $P_0$ is a matter of signs.

From four points on it is no longer true, not even for a convex polygon.

:::{claim} quadratic_distance_to_a_line_shrinks
:title: The distances from the lines of the edges are the outer weights
:zh: 到两边所在直线的距离
:given: points $P_0,P_1,P_2$, any $\beta$ and $t$, $n=2$
:then: the determinants of $P_1-P_0$, $q-P_0$ and of $P_2-P_1$, $q-P_1$ are $t^2(1-\beta s)$ and $s^2(1-\beta t)$ times
  that of $P_1-P_0$, $P_2-P_0$; both factors do not grow with $\beta$, and are $\ge0$ for $\beta\le1$
:method: Everything is a variable.
:degrees: 2..2
:control: the two factors exchanged
:::
*/
CLAIM(quadratic_distance_to_a_line_shrinks)
{
    num P[3 * dim], q[dim], u[dim], v[dim], w[dim], e[dim], x[dim], one = from_int(1);
    num beta = unknown(T, "beta", 0), t = parameter(T, "t"), s = sub(one, t);
    G(free_points)(T, 2, dim, P);
    G(shape_point)(2, dim, P, beta, t, q);
    for (int c = 0; c < dim; c++) {
        u[c] = sub(P[dim + c], P[c]);
        v[c] = sub(P[2 * dim + c], P[c]);
        w[c] = sub(q[c], P[c]);
        e[c] = sub(P[2 * dim + c], P[dim + c]);
        x[c] = sub(q[c], P[dim + c]);
    }
    num area = G(cross2)(u, v), at_2 = mul(mul(t, t), sub(one, mul(beta, s)));
    num at_0 = mul(mul(s, s), sub(one, mul(beta, t)));
    /* (P_1-P_0) × (q-P_0) = t² (1 - βs) D, (P_2-P_1) × (q-P_1) = s² (1 - βt) D */
    same(T, G(cross2)(u, w), mul(fault(T, at_2, at_0), area));
    same(T, G(cross2)(e, x), mul(fault(T, at_0, at_2), area));
}

/*
:::{claim} quadratic_distance_to_an_end_shrinks
:title: Where the nearest point is an end, the point moves towards it
:zh: 最近点为端点时距离递减
:given: $u=P_1-P_0$, $v=P_2-P_0$, any $t$; a point $P_0+w$, $w=\lambda u+\mu v$; the direction $d=u-tv$ in which it moves
:then: $(u\cdot u)(d\cdot w)=(u\cdot w)(u\cdot u-t\,u\cdot v)-t\mu\bigl((u\cdot u)(v\cdot v)-(u\cdot v)^2\bigr)$
:method: Everything is a variable.  If the foot is beyond $P_0$, $u\cdot w<0$, then $u\cdot v<0$ because
  $\lambda,\mu\ge0$; so both terms are $\le0$, and so is $d\cdot w$, half the derivative of $|w|^2$ up to the factor $st$.
   At $P_2$ the same with $s$ and $t$ exchanged.
:degrees: 2..2
:over: u# v#: edges; l m: point of the plane
:control: $t\mu$ replaced by $\mu$
:::
*/
CLAIM(quadratic_distance_to_an_end_shrinks)
{
    num u[dim], v[dim], w[dim], d[dim], t = parameter(T, "t");
    num lambda = unknown(T, "l", 0), mu = unknown(T, "m", 0);
    for (int c = 0; c < dim; c++) {
        u[c] = unknown(T, "u", c);
        v[c] = unknown(T, "v", c);
        w[c] = add(mul(lambda, u[c]), mul(mu, v[c]));
        d[c] = sub(u[c], mul(t, v[c]));
    }
    num uu = G(dot)(dim, u, u), uv = G(dot)(dim, u, v), gram = G(gram)(dim, u, v);
    /* (u·u)(d·w) = (u·w)(u·u - t u·v) - tμ ((u·u)(v·v) - (u·v)²) */
    num right = mul(G(dot)(dim, u, w), sub(uu, mul(t, uv)));
    right = sub(right, mul(fault(T, mul(t, mu), mu), gram));
    same(T, mul(uu, G(dot)(dim, d, w)), right);
}

#if RATIONAL
/*
Both examples have four points with whole coordinates.  The first refutes the two senses of
"closer" at once, the second is convex.

:::{claim} cubic_of_larger_beta_is_farther
:title: A cubic polygon from which a larger beta takes the curve away
:zh: n=3:β 增大而曲线远离控制多边形
:kind: counterexample
:data: P = (1,0) (-2,0) (0,1) (-2,-2); β = 0 1; r² = 1/25; r² of a farther point = 1/16; R² = 1
:instead: β = 1 0
:result: t of a farther point = 5/16; control points farther than R = 0 1
:given: a polygon of four points, two values of $\beta$, and the squares of three distances
:then: for the first $\beta$ every point of the curve is nearer to the polygon than $r$, for the second some point is
  farther than even the larger of the two distances; for the first $\beta$ no control point is farther from the curve than
  $R$, for the second one is
:method: Nearer on all of $[0,1]$: the interval is cut until on each piece one edge is near, decided by the signs of three
  polynomials (the foot on the edge, the distance to its line).  Farther: one rational $t$ and all edges; for a control
  point the sign of $|q(t)-P_i|^2-R^2$ on $[0,1]$.
:control: the two values of $\beta$ exchanged
:::
*/
CLAIM(cubic_of_larger_beta_is_farther)
{
    num P[4 * dim], beta[2], away[2], R_squared = given(T, "R²"), larger_squared = given(T, "r² of a farther point");
    int farther = G(one_is_farther)(T, 3, P, beta);
    farther = farther && !is_zero_q(G(parameter_farther_than)(0, 3, P, beta[1], larger_squared));
    for (int k = 0; k < 2; k++)
        away[k] = from_int(G(points_far_from_the_curve)(0, 3, P, beta[k], R_squared));
    found_points(T, "control points farther than R", 2, 1, away);
    about(T, "in one of two senses the larger beta is not farther: curve from polygon, control points from curve");
    refute(T, farther && is_zero_q(away[0]) && sign_q(away[1]) > 0);
}

/*
:::{claim} convex_cubic_of_larger_beta_is_farther
:title: A convex polygon of four points from which a larger beta takes the curve away
:zh: n=3 的凸多边形:β 增大而曲线远离
:kind: counterexample
:data: P = (2,4) (-1,-4) (1,-4) (2,3); β = 0 1; r² = 16/25
:instead: β = 1 0
:result: t of a farther point = 31/64
:given: a trapezoid, two values of $\beta$, and the square of a distance
:then: for the first $\beta$ every point of the curve is nearer to the polygon than $r$, for the second some point is farther
:method: Nearer on all of $[0,1]$: the interval is cut until on each piece one edge is near, decided by signs of polynomials.  Farther: one
  rational $t$ and all edges.  `hull.h` decides that the polygon is convex.
:control: the two values of $\beta$ exchanged
:::
*/
CLAIM(convex_cubic_of_larger_beta_is_farther) { G(refute_closer_to_a_convex_polygon)(T, 3); }
#endif

/*
:::{claim} straight_points_are_run_through_unevenly
:title: Points in equal distances on a line are not run through evenly
:zh: 无线性精度
:given: any $\beta$ and $t$
:then: $\sum_i\frac inB_{i,n}(t)=t+\frac\beta n\,s\,t\,(1-2t)$: only for $\beta=0$ has the family linear precision
:method: The kernel's functions, $\beta$ and $t$ variables.
:degrees: 2..9 sampled 16
:control: $\beta$ without the denominator $n$
:::
*/
CLAIM(straight_points_are_run_through_unevenly)
{
    int n = T->degree;
    num beta = unknown(T, "beta", 0), t = parameter(T, "t"), s = sub(from_int(1), t), B[MAX_DEGREE + 1];
    num sum = from_int(0);
    G(shape_basis)(n, beta, t, B);
    for (int i = 0; i <= n; i++)
        sum = add(sum, mul(from_ratio(i, n), B[i]));
    num bend = mul(mul(beta, mul(s, t)), sub(s, t));
    /* Σ i/n B_i(t) = t + β/n st (1-2t) */
    same(T, sum, add(t, fault(T, div(bend, from_int(n)), bend)));
}

/*
## Outward

What is true of "closer" is this.  Let the polygon be convex and turn by no more than two right angles in all: for its edges
$e_k=P_{k+1}-P_k$ that says $e_a\times e_b\ge0$ for all $a<b$, when it turns to the left.  Then for $n=7$ and
$-\frac72\le\beta\le1$ a larger $\beta$ moves every point of the curve to the right of the curve, outward, or leaves it where it
is.  For the velocity $q'$ along the curve and the velocity $\partial_\beta q$ with $\beta$ have a vector product that is a sum over
pairs of edges, whose factors are powers of $s$ and $t$ times numbers.

:::{claim} growing_beta_pushes_by_the_turns
:title: How far a larger beta pushes the curve to one side is a sum of the turns of the polygon
:zh: β 增大时曲线的侧向速度由边的转向决定
:given: points $P_0,\dots,P_n$ of the plane, $e_k=P_{k+1}-P_k$, any $\beta$ and $t$
:then: $q'\times\partial_\beta q=-\sum_{a<b}K_{ab}\,s^{2n-1-a-b}t^{a+b+1}\,e_a\times e_b$ with
  $K_{ab}=\binom{n-1}a\binom{n-1}b\frac{b-a}{(n-1)^2}\cdot\bigl(2n(n-1)+\beta(n-1-2a)(n-1-2b)\bigr)$
:method: The derivative of the curve by the kernel, $\partial_\beta q=q_{\beta+1}-q_\beta$, since the curve is linear in $\beta$; everything a
  variable.
:degrees: 2..7 sampled 9
:control: $\beta$ left out of $K_{ab}$
:::
*/
CLAIM(growing_beta_pushes_by_the_turns)
{
    int n = T->degree;
    num P[(MAX_DEGREE + 1) * dim], D[2 * dim], here[dim], there[dim], push[dim], sum = from_int(0);
    num beta = unknown(T, "beta", 0), t = parameter(T, "t");
    G(free_points)(T, n, dim, P);
    G(shape_derivatives)(n, dim, P, beta, t, 1, D);
    G(shape_point)(n, dim, P, beta, t, here);
    G(shape_point)(n, dim, P, add(beta, from_int(1)), t, there);
    for (int c = 0; c < dim; c++)
        push[c] = sub(there[c], here[c]);
    for (int a = 0; a < n; a++)
        for (int b = a + 1; b < n; b++) {
            num first[dim], second[dim], size = mul(G(choose)(n - 1, a), G(choose)(n - 1, b));
            for (int c = 0; c < dim; c++) {
                first[c] = sub(P[(a + 1) * dim + c], P[a * dim + c]);
                second[c] = sub(P[(b + 1) * dim + c], P[b * dim + c]);
            }
            num bend = fault(T, mul(beta, from_int((n - 1 - 2 * a) * (n - 1 - 2 * b))), from_int(0));
            num K = mul(mul(size, from_ratio(b - a, (n - 1) * (n - 1))), add(from_int(2 * n * (n - 1)), bend));
            num power = G(product_of_powers)(2 * n - 1 - a - b, a + b + 1, t);
            sum = add(sum, mul(mul(K, power), G(cross2)(first, second)));
        }
    same(T, G(cross2)(D + dim, push), neg(sum));
}

/*
For every $n$ the numbers $K_{ab}$ come from the coefficients of one edge in the two velocities.

:::{claim} turns_push_by_these_numbers_in_every_degree
:title: The factor of a turn, for every degree
:zh: 任意次时转向的系数
:given: integers $0\le a<b\le n-1$, $n\ge2$, any $\beta$ and $t$; $\gamma_k=\binom{n-1}k$ and $p_k=s^{n-1-k}t^k$ for $k=a,b$
:let: $\partial_\beta q=st\sum_kc_ke_k$ with $c_k=\gamma_k\frac{n-1-2k}{n-1}p_k$, which is $\bigl(\binom{n-2}k-\binom{n-2}{k-1}\bigr)p_k$; the
  derivative of $st\,p_k$ is $p_k\bigl((k+1)s-(n-k)t\bigr)$, so that $q'=\sum_kd_ke_k$ with
  $d_k=n\gamma_kp_k+\beta\gamma_k\frac{n-1-2k}{n-1}p_k\bigl((k+1)s-(n-k)t\bigr)$
:then: $(d_ac_b-d_bc_a)\,st=-\gamma_a\gamma_b\frac{b-a}{(n-1)^2}\cdot\bigl(2n(n-1)+\beta(n-1-2a)(n-1-2b)\bigr)\,st\,p_ap_b$
:method: An identity with $n$, $a$, $b$, $\gamma_a$, $\gamma_b$, $p_a$, $p_b$, $\beta$, $t$ variables; for $c_k$ with
  $\binom{n-2}k=\gamma_k\frac{n-1-k}{n-1}$ and $\binom{n-2}{k-1}=\gamma_k\frac k{n-1}$, for $q'$ with $n\gamma_kp_k$, the coefficient of the
  edge in the derivative of the Bézier curve.
:degrees: all from 2
:over: beta; t; n a b A B p q: -
:control: $n-1-b$ in the place of $n-1-2b$
:::
*/
CLAIM(turns_push_by_these_numbers_in_every_degree)
{
    num n = whole(T, "n", 8, 20), one = from_int(1), two = from_int(2), M = sub(n, one), k[2], gamma[2], p[2], c[2],
        d[2];
    num beta = unknown(T, "beta", 0), t = parameter(T, "t"), s = sub(one, t), share[2];
    k[0] = whole(T, "a", 0, 3), k[1] = whole(T, "b", 4, 7);
    gamma[0] = positive(T, "A", 0), gamma[1] = positive(T, "B", 0);
    p[0] = positive(T, "p", 0), p[1] = positive(T, "q", 0);
    for (int j = 0; j < 2; j++) {
        share[j] = sub(M, mul(two, k[j]));
        num lower = sub(div(mul(gamma[j], sub(M, k[j])), M), div(mul(gamma[j], k[j]), M));
        about(T, "the difference of two binomial coefficients");
        same(T, lower, div(mul(gamma[j], share[j]), M));
        c[j] = mul(lower, p[j]);
        num slope = sub(mul(add(k[j], one), s), mul(sub(n, k[j]), t));
        d[j] = add(mul(mul(n, gamma[j]), p[j]), mul(beta, mul(c[j], slope)));
    }
    num last = fault(T, share[1], sub(M, k[1]));
    num bracket = add(mul(two, mul(n, M)), mul(beta, mul(share[0], last)));
    num size = div(mul(mul(gamma[0], gamma[1]), sub(k[1], k[0])), mul(M, M));
    about(T, "the factor of a turn");
    same(T, sub(mul(d[0], c[1]), mul(d[1], c[0])), neg(mul(mul(size, bracket), mul(p[0], p[1]))));
}

/*
:::{claim} turns_push_outward_in_the_range
:title: All factors have one sign for beta from -2n/(n-3) to 2n/(n-1), in every degree
:zh: 任意次时各系数同号的 β 范围
:given: integers $0\le a<b\le n-1$, $M=n-1$, $X=(M-2a)(M-2b)$
:then: $M^2+X\ge0$, with equality for $a=0$, $b=M$; and $M(M-2)-X\ge0$, with equality for $a=0$, $b=1$; so
  $2nM+\beta X\ge0$ for all $a<b$ exactly if $\beta\le\frac{2n}{n-1}$ and, for $n>3$, $\beta\ge-\frac{2n}{n-3}$
:method: With $b=a+1+d$ and $M=b+c$ both differences are polynomials in $a,c,d$ without negative coefficients.  For $\beta\ge0$ the least
  value of $2nM+\beta X$ is $2nM-\beta M^2$, for $\beta<0$ it is $2nM+\beta M(M-2)$.
:degrees: all from 2
:over: a c d: -
:control: both differences subtracted from $-1$
:::
*/
CLAIM(turns_push_outward_in_the_range)
{
    num a = positive(T, "a", 0), c = positive(T, "c", 0), d = positive(T, "d", 0), two = from_int(2),
        zero = from_int(0);
    for (int at_the_border = 0; at_the_border < 3; at_the_border++) { /* all a, b; a = 0, b = M; a = 0, b = 1 */
        num first = at_the_border ? zero : a, above = at_the_border == 1 ? zero : c;
        num gap = at_the_border == 2 ? zero : d, b = add(first, add(from_int(1), gap)), M = add(b, above);
        num X = mul(sub(M, mul(two, first)), sub(M, mul(two, b)));
        num low = add(mul(M, M), X), high = sub(mul(M, sub(M, two)), X), minus_one = from_int(-1);
        low = fault(T, low, sub(minus_one, low)), high = fault(T, high, sub(minus_one, high));
        if (at_the_border == 1)
            vanishes(T, low);
        else if (at_the_border == 2)
            vanishes(T, high);
        else
            nonnegative(T, low);
        if (at_the_border == 0)
            nonnegative(T, high);
    }
}

#if RATIONAL
/*
For $n=7$ the range is from $-\frac72$ to $\frac73$, and the left end lies inside the range in which the functions are nonnegative.  Below
it a polygon of two edges is enough.

:::{claim} below_the_range_a_larger_beta_pulls_inward
:title: For beta = -4 a larger beta moves a point of the curve of a convex polygon inward
:zh: β=-4 时 β 增大使凸多边形的曲线向内移动
:kind: counterexample
:data: β = -4; P = (0,0) (1,0) (1,1) (1,1) (1,1) (1,1) (1,1) (1,1); t = 1/2
:instead: β = -7/2
:result: q'(t) × ∂q/∂β = 1/8192
:given: $\beta$ below the range, a polygon that turns to the left by a right angle, and the middle of the interval; corrected functions
:then: $\partial_\beta q$ is to the left of $q'$
:method: Derivative and points by the kernels; that the product is not positive is refuted.
:control: the left end of the range
:::
*/
CLAIM(below_the_range_a_larger_beta_pulls_inward)
{
    num beta = given(T, "β"), P[8 * dim], D[2 * dim], here[dim], there[dim], push[dim];
    given_points(T, "P", 8, dim, P);
    num t = given(T, "t");
    G(shape_derivatives)(7, dim, P, beta, t, 1, D);
    G(shape_point)(7, dim, P, beta, t, here);
    G(shape_point)(7, dim, P, add(beta, from_int(1)), t, there);
    for (int c = 0; c < dim; c++)
        push[c] = sub(there[c], here[c]);
    num product = G(cross2)(D + dim, push);
    found(T, "q'(t) × ∂q/∂β", product);
    about(T, "whether the point moves outward, or stays");
    agree(T, sign_q(product) <= 0);
}
#endif

/*
Many edges make no new difficulty, since a product of two sums goes by pairs.

:::{claim} product_of_two_sums_goes_by_pairs
:title: The cross product of two sums over the same vectors is a sum over pairs of them, whatever their number
:zh: 两和的叉积按对展开
:given: two vectors $D$, $C$ of the plane, the sums so far; a vector $e$ with the factors $d$ and $c$; a vector $x$ with the factors $d'$ and $c'$
:then: $(D+de)\times(C+ce)=D\times C+c\,(D\times e)-d\,(C\times e)$; and for $D=d'x$, $C=c'x$ the last two terms are $(d'c-dc')\,x\times e$
:method: Everything is a variable.  The last two terms are linear in $(D,C)$, so for sums $D=\sum d_ae_a$, $C=\sum c_ae_a$ they are $\sum_a(d_ac-dc_a)\,e_a\times e$; by
  induction $\sum d_ae_a\times\sum c_ae_a=\sum_{a<b}(d_ac_b-d_bc_a)\,e_a\times e_b$ for any number of vectors.  Where a convex polygon turns to the left by at most two
  right angles the angle from $e_a$ to $e_b$ is between $0$ and $\pi$ for $a<b$, and no $e_a\times e_b$ is negative: with factors of one sign the product has that sign
  or is 0.
:degrees: all
:over: x# y#: edges; c d p q: -
:control: $d$ and $c$ exchanged in the last two terms
:::
*/
CLAIM(product_of_two_sums_goes_by_pairs)
{
    num D[dim], C[dim], e[dim], x[dim], left[2][dim], d[2], c[2];
    for (int k = 0; k < dim; k++) {
        D[k] = unknown(T, "p", k), C[k] = unknown(T, "q", k);
        e[k] = unknown(T, "x", k), x[k] = unknown(T, "y", k);
    }
    for (int k = 0; k < 2; k++)
        d[k] = unknown(T, "d", k), c[k] = unknown(T, "c", k);
    for (int k = 0; k < dim; k++)
        left[0][k] = add(D[k], mul(d[0], e[k])), left[1][k] = add(C[k], mul(c[0], e[k]));
    num of_d = fault(T, d[0], c[0]), of_c = fault(T, c[0], d[0]);
    num more = sub(mul(of_c, G(cross2)(D, e)), mul(of_d, G(cross2)(C, e)));
    /* (D + d e) × (C + c e) = D × C + c (D × e) - d (C × e) */
    same(T, G(cross2)(left[0], left[1]), add(G(cross2)(D, C), more));
    num first[dim], second[dim];
    for (int k = 0; k < dim; k++)
        first[k] = mul(d[1], x[k]), second[k] = mul(c[1], x[k]);
    num pair = sub(mul(of_c, G(cross2)(first, e)), mul(of_d, G(cross2)(second, e)));
    same(T, pair, mul(sub(mul(d[1], c[0]), mul(d[0], c[1])), G(cross2)(x, e)));
}

#include "chapters/judge/claims_off.h"
