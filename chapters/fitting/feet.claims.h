/*
# Foot points are not unknowns (垂足的消去)

With $N$ foot points among the unknowns the problem grows with the data.  It need not: at a foot the distance is stationary in $t$, and
that is why the foot may be forgotten, in the gradient entirely, and in the Hessian but for one term.
*/
#include "chapters/fitting/definition.h"

#include "chapters/judge/claims_on.h"

enum { order = 3, plane = 2 }; /* coefficients of powers of epsilon */

/*
## The gradient: the envelope theorem (包络定理)
*/

/* The conic over (0,0), (x,y), (1,0) with weights 1, w, 1, its foot, and the point Q on the normal there. */
struct G(conic_and_foot) {
    num R[6], w[3], t, t1, t2, Q[2], C[2], C1[2], C2[2]; /* at t: the curve and two derivatives             */
    num L[2], L1[2], LL[2];                              /* by lambda: first, with C' first, second        */
};

static void G(free_conic_and_foot)(trial *T, struct G(conic_and_foot) * S)
{
    num one = from_int(1), zero = from_int(0), knots[] = {zero, zero, zero, one, one, one}, D[6], B[12], BB[18];
    num R[] = {zero, zero, unknown(T, "x", 0), positive(T, "y", 0), one, zero}, w[] = {one, positive(T, "w", 0), one};
    num k = unknown(T, "k", 0);
    S->t = parameter(T, "t");
    S->t1 = unknown(T, "a", 0);
    S->t2 = unknown(T, "b", 0);
    for (int m = 0; m < 6; m++)
        S->R[m] = R[m];
    for (int m = 0; m < 3; m++)
        S->w[m] = w[m];
    G(rational_derivatives)(2, plane, S->R, S->w, S->t, 2, D);
    G(nurbs_by_weights)(G(nurbs_on_span)(2, plane, knots, 2, S->R, S->w), S->t, 1, B);
    G(nurbs_by_two_weights)(G(nurbs_on_span)(2, plane, knots, 2, S->R, S->w), S->t, BB);
    for (int c = 0; c < plane; c++) {
        S->C[c] = D[c], S->C1[c] = D[2 + c], S->C2[c] = D[4 + c];
        S->L[c] = B[2 + c], S->L1[c] = B[6 + 2 + c], S->LL[c] = BB[(3 + 1) * plane + c];
    }
    S->Q[0] = sub(S->C[0], mul(k, S->C1[1]));
    S->Q[1] = add(S->C[1], mul(k, S->C1[0]));
}

/* Three coefficients of 1/2 |C - Q|^2 in powers of epsilon, when lambda grows by epsilon and t by t1 epsilon + t2 epsilon^2. */
static void G(distance_series)(const struct G(conic_and_foot) * S, num t, num t1, num t2, num out[order])
{
    num one = from_int(1), two = from_int(2), half = from_ratio(1, 2), middle = mul(two, S->w[1]);
    num at[order] = {t, t1, t2}, rest[order] = {sub(one, t), neg(t1), neg(t2)}, grow[order] = {one, one, half};
    num B[3][order], weight[order], total[order], square[order];
    G(series_product)(order, rest, rest, B[0]);
    G(series_product)(order, rest, at, weight);
    G(series_product)(order, weight, grow, B[1]);
    G(series_product)(order, at, at, B[2]);
    for (int r = 0; r < order; r++) {
        B[1][r] = mul(middle, B[1][r]);
        total[r] = add(add(B[0][r], B[1][r]), B[2][r]);
        out[r] = from_int(0);
    }
    for (int c = 0; c < plane; c++) {
        num above[order], value[order];
        for (int r = 0; r < order; r++) {
            above[r] = mul(B[0][r], S->R[c]);
            above[r] = add(above[r], mul(B[1][r], S->R[plane + c]));
            above[r] = add(above[r], mul(B[2][r], S->R[2 * plane + c]));
        }
        G(series_quotient)(order, above, total, value);
        value[0] = sub(value[0], S->Q[c]);
        G(series_product)(order, value, value, square);
        for (int r = 0; r < order; r++)
            out[r] = add(out[r], mul(half, square[r]));
    }
}

/*
At its foot the distance of a point is stationary in $t$.  So if the curve changes by $\varepsilon$ and the foot follows, the movement of
the foot changes the distance in the second order only, and the gradient is that with the foot held fixed.

:::{claim} gradient_does_not_see_the_foot_move
:title: The gradient of the reduced distance needs no derivative of the foot
:zh: 距离的梯度不含垂足的导数
:given: the conic with points $(0,0)$, $(x,y)$, $(1,0)$ and weights $1,w,1$; a point $Q=C(t)+k\,n$ with $n\perp C'(t)$, so that $t$ is its foot
:let: $w$ grow to $w(1+\varepsilon+\frac{\varepsilon^2}2)$, which is $\lambda+\varepsilon$ to second order, and the foot move as $t+t_1\varepsilon+t_2\varepsilon^2$
:then: the derivative of $\frac12|C-Q|^2$ by $\varepsilon$ at $0$ is $D\cdot\partial C/\partial\lambda$, whatever $t_1$ and $t_2$ are
:method: The distance at the moved foot as a quotient of power series in $\varepsilon$; $x,y,w,t,k,t_1,t_2$ are variables.
:over: x y: conic; k: normal distance; a b: movement of the foot
:control: the foot $t+\frac12$ of another point
:::
*/
CLAIM(gradient_does_not_see_the_foot_move)
{
    struct G(conic_and_foot) S;
    num f[order], D[plane];
    G(free_conic_and_foot)(T, &S);
    G(distance_series)(&S, fault(T, S.t, add(S.t, from_ratio(1, 2))), S.t1, S.t2, f);
    for (int c = 0; c < plane; c++)
        D[c] = sub(S.C[c], S.Q[c]);
    same(T, f[1], G(dot)(plane, D, S.L));
}

/*
## The Hessian: a Schur complement (Schur 补)

In the second order the foot does count.  How it follows is found by differentiating the condition $D\cdot C'=0$; what it contributes is one term, a square over
$\varphi'$, which lowers the curvature of the distance.

:::{claim} hessian_of_the_reduced_distance
:title: The second derivative of the reduced distance
:zh: 消去垂足后距离的二阶导数
:given: the conic with points $(0,0)$, $(x,y)$, $(1,0)$ and weights $1,w,1$; a point $Q=C(t)+k\,n$ with $n\perp C'(t)$; $w$ and the foot growing to
  $w(1+\varepsilon+\frac{\varepsilon^2}2)$ and $t+t_1\varepsilon+t_2\varepsilon^2$
:where: $\varphi'\ne0$
:let: $\varphi'=|C'|^2+D\cdot C''$, and $t_1=-\bigl(C_\lambda\cdot C'+D\cdot C_\lambda'\bigr)/\varphi'$, as differentiation of $D\cdot C'=0$ gives
:then: the second derivative of $\frac12|C-Q|^2$ by $\lambda$ is
  $|C_\lambda|^2+D\cdot C_{\lambda\lambda}-\frac{(C_\lambda\cdot C'+D\cdot C_\lambda')^2}{\varphi'}$, whatever $t_2$ is
:method: Twice the coefficient of $\varepsilon^2$ of the distance at the moved foot, against the formula with the derivatives of the kernels.
:over: x y: conic; k: normal distance; a b: movement of the foot
:control: $t_1$ of the opposite sign
:::
*/
CLAIM(hessian_of_the_reduced_distance)
{
    struct G(conic_and_foot) S;
    num f[order], D[plane];
    G(free_conic_and_foot)(T, &S);
    for (int c = 0; c < plane; c++)
        D[c] = sub(S.C[c], S.Q[c]);
    num turn = add(G(dot)(plane, S.L, S.C1), G(dot)(plane, D, S.L1));
    num slope = add(G(dot)(plane, S.C1, S.C1), G(dot)(plane, D, S.C2));
    num t1 = div(turn, slope);
    G(distance_series)(&S, S.t, fault(T, neg(t1), t1), S.t2, f);
    /* |C_l|^2 + D . C_ll - (C_l . C' + D . C_l')^2 / phi' */
    num hessian = add(G(dot)(plane, S.L, S.L), G(dot)(plane, D, S.LL));
    same(T, mul(from_int(2), f[2]), sub(hessian, div(mul(turn, turn), slope)));
}

/*
With many points the same elimination is one of matrices.  The Hessian of all unknowns, $\theta$ and feet, is an arrow
$\begin{pmatrix}A&B\\B^T&\Delta\end{pmatrix}$ with $\Delta$ diagonal, for no foot knows of another.

:::{claim} elimination_of_feet_gives_the_same_step
:title: Newton's step with the feet eliminated is Newton's step of the whole problem
:zh: 消去垂足后的牛顿步与整体牛顿步相同
:given: a symmetric $A$ (2 by 2), $B$ (2 by $n$), a diagonal $\Delta$ of $n$ numbers other than 0, right sides $g$ and $h$
:where: the numbers of $\Delta$ are not 0, and $S$ has an inverse
:let: $S=A-B\Delta^{-1}B^T$ and $x=S^{-1}(g-B\Delta^{-1}h)$, $y=\Delta^{-1}(h-B^Tx)$
:then: $Ax+By=g$ and $B^Tx+\Delta y=h$; the determinants satisfy $\det\begin{pmatrix}A&B\\B^T&\Delta\end{pmatrix}=\det S\,\prod\Delta_i$.  At feet $h=0$
:method: The four sides, everything variables; the determinant by the kernel from the whole matrix.
:degrees: 1..3 sampled 8
:over: a# b# c# d#: matrices; g# h#: right sides
:control: $S=A+B\Delta^{-1}B^T$
:::
*/
CLAIM(elimination_of_feet_gives_the_same_step)
{
    enum { most = 10 };
    int n = T->degree, N = n + 2;
    num A[4], B[2][most], delta[most], g[2], h[most], S[4], r[2], x[2], y[most], M[most * most];
    A[0] = unknown(T, "a", 0), A[1] = A[2] = unknown(T, "a", 1), A[3] = unknown(T, "a", 2);
    for (int c = 0; c < 2; c++)
        g[c] = r[c] = unknown(T, "g", c);
    for (int m = 0; m < 4; m++)
        S[m] = A[m];
    num product = from_int(1);
    for (int i = 0; i < n; i++) {
        delta[i] = positive(T, "d", i);
        h[i] = unknown(T, "h", i);
        product = mul(product, delta[i]);
        for (int c = 0; c < 2; c++)
            B[c][i] = unknown(T, c == 0 ? "b" : "c", i);
        for (int c = 0; c < 2; c++) {
            r[c] = sub(r[c], div(mul(B[c][i], h[i]), delta[i]));
            for (int e = 0; e < 2; e++) {
                num part = div(mul(B[c][i], B[e][i]), delta[i]);
                S[2 * c + e] = fault(T, sub(S[2 * c + e], part), add(S[2 * c + e], part));
            }
        }
    }
    /* x = S^{-1} (g - B Delta^{-1} h), y = Delta^{-1} (h - B^T x) */
    num det = sub(mul(S[0], S[3]), mul(S[1], S[2]));
    x[0] = div(sub(mul(S[3], r[0]), mul(S[1], r[1])), det);
    x[1] = div(sub(mul(S[0], r[1]), mul(S[2], r[0])), det);
    for (int i = 0; i < n; i++)
        y[i] = div(sub(h[i], add(mul(B[0][i], x[0]), mul(B[1][i], x[1]))), delta[i]);
    for (int c = 0; c < 2; c++) {
        num sum = add(mul(A[2 * c], x[0]), mul(A[2 * c + 1], x[1]));
        for (int i = 0; i < n; i++)
            sum = add(sum, mul(B[c][i], y[i]));
        same(T, sum, g[c]);
    }
    for (int i = 0; i < N; i++)
        for (int k = 0; k < N; k++)
            M[i * N + k] = i < 2 && k < 2 ? A[2 * i + k]
                           : i < 2        ? B[i][k - 2]
                           : k < 2        ? B[k][i - 2]
                           : i == k       ? delta[i - 2]
                                          : from_int(0);
    about(T, "the determinant");
    same(T, G(determinant)(N, M), mul(det, product));
}

/*
When the second derivatives are left out, as Gauss and Newton do, $\Delta_i=|C'|^2$, and what remains is the part of $C_a$ across the curve.  The
plane has one direction across the curve, hence one equation a point; space has two.

:::{claim} reduced_gauss_newton_matrix_is_the_part_across_the_curve
:title: The reduced Gauss-Newton matrix is that of the derivatives projected across the curve
:zh: 消去垂足后的 Gauss-Newton 矩阵即法向投影
:given: vectors $C_a$, $C_b$ and $C'\ne0$ of the plane or of space, $T=C'/|C'|$
:where: $C'\ne0$
:then: $C_a\cdot C_b-\frac{(C_a\cdot C')(C_b\cdot C')}{|C'|^2}=(C_a-TT^TC_a)\cdot(C_b-TT^TC_b)$, and in the plane both are
  $\det(C',C_a)\det(C',C_b)/|C'|^2$
:method: All coordinates are variables; $TT^T=C'C'^T/|C'|^2$ has no root.  The degree is the dimension.
:degrees: d = 2..3 sampled 3
:over: a# b# c#: vectors
:control: the projection along $C_a$ in the place of that along $C'$
:::
*/
CLAIM(reduced_gauss_newton_matrix_is_the_part_across_the_curve)
{
    int d = T->degree;
    num a[3], b[3], c[3], pa[3], pb[3];
    for (int k = 0; k < d; k++) {
        a[k] = unknown(T, "a", k);
        b[k] = unknown(T, "b", k);
        c[k] = positive(T, "c", k);
    }
    num cc = G(dot)(d, c, c), ac = G(dot)(d, a, c), bc = G(dot)(d, b, c);
    for (int k = 0; k < d; k++) {
        pa[k] = sub(a[k], div(mul(fault(T, c[k], a[k]), ac), cc));
        pb[k] = sub(b[k], div(mul(c[k], bc), cc));
    }
    num reduced = sub(G(dot)(d, a, b), div(mul(ac, bc), cc));
    same(T, G(dot)(d, pa, pb), reduced);
    if (d == 2)
        same(T, div(mul(G(cross2)(c, a), G(cross2)(c, b)), cc), reduced);
}

/*
The whole second derivative has that part, too.  Where one coordinate is much larger than the other nearly all of $C_a\cdot C_b$ lies along the curve
and is subtracted again; written without it, intervals stay narrow.

:::{claim} reduced_hessian_without_the_part_along_the_curve
:title: The second derivative of the reduced distance, without what cancels along the curve
:zh: 约化距离的二阶导数：去掉沿曲线相消的部分
:given: vectors $C_a$, $C_b$ and $C'\ne0$ of the plane or of space; any numbers $p$, $q$, $s$ for $D\cdot C_a'$, $D\cdot C_b'$, $D\cdot C''$; $\varphi'=|C'|^2+s\ne0$
:where: $C'\ne0$, $\varphi'\ne0$
:then: $C_a\cdot C_b-\frac{(C_a\cdot C'+p)(C_b\cdot C'+q)}{\varphi'}=\frac{(C_a\times C')\cdot(C_b\times C')}{|C'|^2}+
  \frac{(C_a\cdot C')(C_b\cdot C')\,s}{|C'|^2\varphi'}-\frac{(C_a\cdot C')\,q+p\,(C_b\cdot C'+q)}{\varphi'}$
:method: All coordinates and numbers are variables; the products of vectors by their definition.  The degree is the dimension.
:degrees: d = 2..3 sampled 3
:over: a# b# c#: vectors; p q s: value of p, q and s
:control: $s$ of the opposite sign on the right
:::
*/
CLAIM(reduced_hessian_without_the_part_along_the_curve)
{
    int d = T->degree;
    num a[3], b[3], c[3], across = from_int(0), zero = from_int(0);
    for (int k = 0; k < 3; k++) {
        a[k] = k < d ? unknown(T, "a", k) : zero;
        b[k] = k < d ? unknown(T, "b", k) : zero;
        c[k] = k < d ? positive(T, "c", k) : zero;
    }
    num p = unknown(T, "p", 0), q = unknown(T, "q", 0), s = positive(T, "s", 0);
    num cc = G(dot)(d, c, c), ac = G(dot)(d, a, c), bc = G(dot)(d, b, c), slope = add(cc, s);
    for (int k = 0; k < 3; k++) {
        int x = (k + 1) % 3, y = (k + 2) % 3;
        num u = sub(mul(a[x], c[y]), mul(a[y], c[x])), v = sub(mul(b[x], c[y]), mul(b[y], c[x]));
        across = add(across, mul(u, v));
    }
    num right = add(div(across, cc), div(mul(mul(ac, bc), fault(T, s, neg(s))), mul(cc, slope)));
    right = sub(right, div(add(mul(ac, q), mul(p, add(bc, q))), slope));
    same(T, sub(G(dot)(d, a, b), div(mul(add(ac, p), add(bc, q)), slope)), right);
}

/*
## How many feet a point has
*/

#if FIELD
/*
All this is about one foot, and a point has many.  To find the nearest one for certain one has to know how many there can be.

:::{claim} degree_of_the_equation_of_the_foot
:title: The feet are the roots of a polynomial of degree 2n-1 for a polynomial curve, 3n-2 for a rational one
:zh: 垂足方程的次数
:kind: decision
:types: field
:given: points $(x_i,y_i)$ with $x_i=i$ for $i<n$, $x_n=n^2$, and variable $y_i$: the polynomial curve, and the rational one with weights $1,w_1,\dots,w_n$; $Q=(0,0)$
:let: $C=P/w$, so that $\varphi=(P-Qw)\cdot(P'w-Pw')/w^3$
:then: the numerator of $\varphi$, reduced, is of degree exactly $2n-1$ in $t$ for the polynomial curve, $3n-2$ for the rational one, and its denominator
  is $w^3$ without a common factor
:method: $\varphi$ is a rational function of $t$, $y_i$ and $w_i$, which the field reduces; its degrees are read off.
:degrees: 2..3
:over: y#: points
:control: the rational curve is said to have the degree $3n-1$
:::
*/
CLAIM(degree_of_the_equation_of_the_foot)
{
    int n = T->degree;
    num R[2 * MOST_POINTS], w[MOST_POINTS], one[MOST_POINTS], t = parameter(T, "t"), D[4];
    for (int i = 0; i <= n; i++) {
        R[2 * i] = from_int(i == n ? n * n : i); /* not in equal steps, which would lower the degree */
        R[2 * i + 1] = unknown(T, "y", i);
        w[i] = i == 0 ? from_int(1) : positive(T, "w", i);
        one[i] = from_int(1);
    }
    for (int rational = 0; rational < 2; rational++) {
        G(rational_derivatives)(n, 2, R, rational ? w : one, t, 1, D);
        num phi = add(mul(D[0], D[2]), mul(D[1], D[3]));
        show(T, rational ? "degree, rational" : "degree, polynomial", from_int(degree_f(phi, t)));
        agree(T, has_degrees_f(phi, t, rational ? fault(T, 3 * n - 2, 3 * n - 1) : 2 * n - 1, rational ? 3 * n : 0));
    }
}
#endif

#include "chapters/judge/claims_off.h"
