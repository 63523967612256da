/*
# Curvature and torsion at the ends (端点曲率与挠率)

At $t=0$ the derivatives of order $1$, $2$, $3$ are combinations of the first edges $a_1$, $a_2$, $a_3$ of the polygon.  Curvature and torsion
see only the newest edge in each of them, so the complicated coefficients drop out, and what is left are two short formulas.  The formulas are
right; of the three lines on which the proof rests, two are printed wrongly.

We write $a_i=R_i-R_{i-1}$, and start with what curvature and torsion are.  The source writes $k$ for $\kappa$ from this section on; here $k$
stays a number of points.
*/
#include "exact/record/roots.h"

#include "chapters/judge/claims_on.h"

/*
## Curvature and torsion

Both belong to the curve and not to its parameter: with the arc length $s$, $\kappa=|R_{ss}|$, and $\tau$ says how fast the plane of $R_s$ and
$R_{ss}$ turns.  The kernels have the usual formulas in $R'$, $R''$, $R'''$.  They are compared with the definitions, which need no root
because $\frac{d}{ds}=\frac1{\sqrt g}\frac{d}{dt}$, $g=|R'|^2$, gives $R_{ss}=\frac{R''}g-\frac{(R'\cdot R'')R'}{g^2}$.

A function is here its Taylor polynomial of order 3 in $\varepsilon$ at $t$, four coefficients.
*/

typedef struct G(series) {
    num c[4];
} G(series);

static inline G(series) G(series_add)(G(series) a, G(series) b)
{
    for (int k = 0; k < 4; k++)
        a.c[k] = add(a.c[k], b.c[k]);
    return a;
}
static inline G(series) G(series_mul)(G(series) a, G(series) b)
{
    G(series) p;
    for (int k = 0; k < 4; k++) {
        p.c[k] = mul(a.c[0], b.c[k]);
        for (int j = 1; j <= k; j++)
            p.c[k] = add(p.c[k], mul(a.c[j], b.c[k - j]));
    }
    return p;
}
static inline G(series) G(series_div)(G(series) a, G(series) b)
{
    G(series) q;
    for (int k = 0; k < 4; k++) {
        q.c[k] = a.c[k];
        for (int j = 1; j <= k; j++)
            q.c[k] = sub(q.c[k], mul(b.c[j], q.c[k - j]));
        q.c[k] = div(q.c[k], b.c[0]);
    }
    return q;
}
/* One order is lost: the last coefficient is not known any more. */
static inline G(series) G(series_derivative)(G(series) a)
{
    for (int k = 0; k < 3; k++)
        a.c[k] = mul(from_int(k + 1), a.c[k + 1]);
    a.c[3] = from_int(0);
    return a;
}
static inline G(series) G(series_dot)(int dim, const G(series) a[], const G(series) b[])
{
    G(series) sum = G(series_mul)(a[0], b[0]);
    for (int c = 1; c < dim; c++)
        sum = G(series_add)(sum, G(series_mul)(a[c], b[c]));
    return sum;
}

/* |R_ss|^2 and, in space, -(R_s x R_ss)_s . R_ss / |R_ss|^2 = -N . B_s, at epsilon = 0. */
static inline void G(by_arc_length)(int dim, const G(series) R[], num *curvature_squared, num *torsion)
{
    G(series) v[3], N[3];
    for (int c = 0; c < dim; c++) {
        v[c] = G(series_derivative)(R[c]);
        N[c] = G(series_derivative)(v[c]);
    }
    G(series) g = G(series_dot)(dim, v, v), h = G(series_dot)(dim, v, N);
    G(series) minus = {{from_int(-1), from_int(0), from_int(0), from_int(0)}};
    for (int c = 0; c < dim; c++) {
        G(series) along = G(series_div)(G(series_mul)(h, v[c]), G(series_mul)(g, g));
        N[c] = G(series_add)(G(series_div)(N[c], g), G(series_mul)(minus, along));
    }
    *curvature_squared = G(series_dot)(dim, N, N).c[0];
    if (dim != 3)
        return;
    num turning = from_int(0);
    for (int c = 0; c < 3; c++) { /* the derivative of (v x N)_c, times N_c */
        int i = (c + 1) % 3, j = (c + 2) % 3;
        num slope = sub(G(series_mul)(v[i], N[j]).c[1], G(series_mul)(v[j], N[i]).c[1]);
        turning = sub(turning, mul(slope, N[c].c[0]));
    }
    *torsion = div(turning, mul(g.c[0], *curvature_squared));
}

/*
:::{claim} curvature_and_torsion_belong_to_arc_length
:title: The formulas in R', R'', R''' are the curvature and torsion of the arc length
:zh: 曲率、挠率公式与弧长定义一致
:given: derivatives $R',R'',R'''$ of a curve, in the plane and in space
:then: $\frac{|R'|^2|R''|^2-(R'\cdot R'')^2}{|R'|^6}=|R_{ss}|^2$ and $\frac{(R',R'',R''')}{|R'\times R''|^2}=-N\cdot B_s$, where $N=R_{ss}/\kappa$,
  $B=R_s\times N$
:method: The definitions are expanded at the point as Taylor polynomials; both sides are one element of the field of rational functions of the
  coordinates of $R',R'',R'''$.  Differentiating $\kappa B=R_s\times R_{ss}$ gives $-N\cdot B_s=-(R_s\times R_{ss})_s\cdot R_{ss}/\kappa^2$.
:defines: curvature_squared torsion
:control: the two last derivatives exchanged
:::
*/
CLAIM(curvature_and_torsion_belong_to_arc_length)
{
    for (int dim = 2; dim <= 3; dim++) {
        num d[3][3], curvature_squared, torsion;
        G(series) R[3];
        for (int c = 0; c < dim; c++) {
            static const char *const name[] = {"u", "v", "w"};
            for (int k = 0; k < 3; k++)
                d[k][c] = unknown(T, name[k], c);
            R[c] = (G(series)){{from_int(0), d[0][c], div(d[1][c], from_int(2)), div(d[2][c], from_int(6))}};
        }
        G(by_arc_length)(dim, R, &curvature_squared, &torsion);
        int second = fault(T, 1, 2);
        about(T, "curvature squared");
        same(T, G(curvature_squared)(dim, d[0], d[second]), curvature_squared);
        about(T, "torsion");
        if (dim == 3)
            same(T, G(torsion)(d[0], d[second], d[3 - second]), torsion);
    }
}

/*
:::{claim} vector_products_are_determinants
:title: Scalar, cross and mixed products and Gram's determinant
:zh: 数量积、向量积、混合积与 Gram 行列式
:given: vectors $a,b,c$ of one to four coordinates, of the plane, of space
:then: $a\cdot b=\sum a_ib_i$; the cross product of the plane is $\det(a,b)$; $a\times b$ has the coordinates $\det(a,b,e_i)$; the mixed product is
  $\det(a,b,c)$; Gram's determinant is $|a|^2|b|^2-(a\cdot b)^2$, in space $|a\times b|^2$
:method: Determinants are written out as sums over permutations; equality in the field of the coordinates.
:defines: dot norm_squared cross2 cross3 det3 gram
:control: one sign of the sum over permutations of three
:::
*/
/* The sum over the permutations of 0, 1, 2. */
static inline num G(determinant_by_permutations)(const num a[], const num b[], const num c[], int last_is_even)
{
    static const int p[6][4] = {{0, 1, 2, 1}, {1, 2, 0, 1}, {2, 0, 1, 1}, {0, 2, 1, -1}, {2, 1, 0, -1}, {1, 0, 2, -1}};
    num sum = from_int(0);
    for (int k = 0; k < 6; k++) {
        int sign = k == 5 && last_is_even ? 1 : p[k][3];
        sum = add(sum, mul(from_int(sign), mul(mul(a[p[k][0]], b[p[k][1]]), c[p[k][2]])));
    }
    return sum;
}

CLAIM(vector_products_are_determinants)
{
    num a[4], b[4], c[3], x[3], gram[4];
    for (int i = 0; i < 4; i++) {
        a[i] = unknown(T, "a", i);
        b[i] = unknown(T, "b", i);
    }
    num aa = from_int(0), ab = from_int(0), bb = from_int(0);
    for (int dim = 1; dim <= 4; dim++) {
        aa = add(aa, mul(a[dim - 1], a[dim - 1]));
        ab = add(ab, mul(a[dim - 1], b[dim - 1]));
        bb = add(bb, mul(b[dim - 1], b[dim - 1]));
        same(T, G(dot)(dim, a, b), ab);
        same(T, G(norm_squared)(dim, a), aa);
        gram[dim - 1] = sub(mul(aa, bb), mul(ab, ab));
        same(T, G(gram)(dim, a, b), gram[dim - 1]);
    }
    num zero = from_int(0), e2[] = {zero, zero, from_int(1)}, a2[] = {a[0], a[1], zero}, b2[] = {b[0], b[1], zero};
    same(T, G(cross2)(a, b), G(determinant_by_permutations)(a2, b2, e2, 0));
    G(cross3)(a, b, x);
    num xx = from_int(0);
    for (int i = 0; i < 3; i++) {
        num e[] = {from_int(i == 0), from_int(i == 1), from_int(i == 2)};
        same(T, x[i], G(determinant_by_permutations)(a, b, e, fault(T, 0, 1)));
        xx = add(xx, mul(x[i], x[i]));
        c[i] = unknown(T, "c", i);
    }
    same(T, xx, gram[2]);
    same(T, G(det3)(a, b, c), G(determinant_by_permutations)(a, b, c, fault(T, 0, 1)));
}

/*
:::{claim} signed_curvature_is_the_turning_of_the_tangent
:title: The signed curvature of a plane curve is the turning of its tangent by arc length
:zh: 平面曲线的带号曲率是切线转角对弧长的导数
:given: $R'=(p^2-q^2,2pq)$, whose length $p^2+q^2$ is rational, and any $R''$
:let: $m=y'/x'$ the slope, so that the direction $\theta=\arctan m$ has $\theta'=m'/(1+m^2)$
:then: the signed curvature times $|R'|$ is $\theta'$; the curvature is its absolute value
:method: Equality in the field, the curvature compared by its square; in the other arithmetics it is also not negative.
:defines: signed_curvature curvature
:control: the factor $1/(1+m^2)$ left out
:::
*/
CLAIM(signed_curvature_is_the_turning_of_the_tangent)
{
    num p = unknown(T, "p", 0), q = unknown(T, "q", 0), two = from_int(2), one = from_int(1);
    num d1[] = {sub(mul(p, p), mul(q, q)), mul(two, mul(p, q))}, d2[] = {unknown(T, "x", 2), unknown(T, "y", 2)};
    num m = div(d1[1], d1[0]), slope = div(sub(d2[1], mul(m, d2[0])), d1[0]); /* y' = m x' differentiated */
    num turning = fault(T, div(slope, add(one, mul(m, m))), slope);
    num k = G(signed_curvature)(d1, d2), size = G(curvature)(2, d1, d2);
    num length = root(2, add(mul(d1[0], d1[0]), mul(d1[1], d1[1])));
    same(T, mul(k, length), turning);
    same(T, mul(size, size), mul(k, k));
#if !FIELD
    nonnegative(T, size);
    same(T, length, add(mul(p, p), mul(q, q)));
#endif
}

/*
:::{claim} rational_curvature_and_torsion_belong_to_arc_length
:title: Curvature and torsion of a rational Bézier curve, at any parameter
:zh: 有理 Bézier 曲线任意参数处的曲率与挠率
:given: any parameter; weights and points of the plane and of space drawn at random from small integers
:then: the kernels' $\kappa^2$ and $\tau$ are those of the definition by arc length
:method: The curve is expanded at $t$ from the definition of the Bernstein basis and divided as power series; nothing is shared with the kernels.
  That weights and points may be anything is decided where derivatives, curvature and torsion are decided one by one.
:types: rational interval double
:degrees: 2..5 sampled 8
:defines: rational_curvature_squared rational_torsion
:control: the weights equal in the denominator of the expansion
:::
*/
/* The coordinates of the curve at t + epsilon. */
static inline void G(expand)(int n, int dim, const num R[], const num w[], num t, int without_weights, G(series) out[])
{
    num zero = from_int(0), one = from_int(1);
    G(series) T = {{t, one, zero, zero}}, S = {{sub(one, t), from_int(-1), zero, zero}}, W = {{zero, zero, zero, zero}};
    for (int c = 0; c < dim; c++)
        out[c] = W;
    for (int i = 0; i <= n; i++) {
        G(series) B = {{from_int(binomial(n, i)), zero, zero, zero}};
        for (int k = 0; k < n; k++)
            B = G(series_mul)(B, k < i ? T : S);
        for (int c = 0; c < dim; c++) {
            G(series) weight = {{mul(w[i], R[i * dim + c]), zero, zero, zero}};
            out[c] = G(series_add)(out[c], G(series_mul)(B, weight));
        }
        G(series) weight = {{without_weights ? one : w[i], zero, zero, zero}};
        W = G(series_add)(W, G(series_mul)(B, weight));
    }
    for (int c = 0; c < dim; c++)
        out[c] = G(series_div)(out[c], W);
}

CLAIM(rational_curvature_and_torsion_belong_to_arc_length)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], t = parameter(T, "t");
    for (int i = 0; i <= n; i++)
        w[i] = from_int(pick(T, 1, 9));
    for (int dim = 2; dim <= 3; dim++) {
        num R[(MAX_DEGREE + 1) * 3], curvature_squared, torsion;
        G(series) curve[3];
        for (int m = 0; m < (n + 1) * dim; m++)
            R[m] = from_int(pick(T, -9, 9));
        G(expand)(n, dim, R, w, t, fault(T, 0, 1), curve);
        G(by_arc_length)(dim, curve, &curvature_squared, &torsion);
        same(T, G(rational_curvature_squared)(n, dim, R, w, t), curvature_squared);
        if (dim == 3)
            same(T, G(rational_torsion)(n, R, w, t), torsion);
    }
}

/*
## The two formulas

:::{statement} wang-ch3:prop-3.2.4
:title: Curvature and torsion at the ends, for control points without repetition
:zh: 端点曲率与挠率（控制顶点无重点）
:printed: Let no two control points coincide, $\mathbf a_i=\mathbf R_i-\mathbf R_{i-1}$, $i=1,\dots,n$.  Then the curvatures and torsions at the ends are
  (3.2.5) and (3.2.6).
:holds-by: end_curvature_and_torsion_follow_in_every_degree end_derivative_vectors_in_every_degree end_curvature_at_zero end_curvature_at_one
  end_torsion_at_zero end_torsion_at_one
:needs: repeated_first_points_leave_curvature_undetermined | $\mathbf a_1\ne\mathbf 0$ and $\mathbf a_n\ne\mathbf 0$, which is all that the formulas of the
  curvature use of the hypothesis; other points may coincide.
:hypothesis: collinear_first_points_leave_torsion_undetermined | For (3.2.6): $\mathbf a_1\times\mathbf a_2\ne\mathbf 0$ at $t=0$ and
  $\mathbf a_{n-1}\times\mathbf a_n\ne\mathbf 0$ at $t=1$, which distinct points do not ensure.
:figure: end_formulas_undetermined
:::

:::{statement} wang-ch3:3.2.5-left
:title: Curvature at t = 0
:zh: t=0 处的曲率
:printed: \kappa(0)=\frac{n-1}n\frac{\omega_0\omega_2}{\omega_1^2}\frac{\|\mathbf a_1\times\mathbf a_2\|}{\|\mathbf a_1\|^3}
:holds-by: end_curvature_and_torsion_follow_in_every_degree end_derivative_vectors_in_every_degree end_curvature_at_zero
:needs: repeated_first_points_leave_curvature_undetermined | $\mathbf R_0\ne\mathbf R_1$.
:needs: negative_weight_makes_printed_curvature_negative | $\omega_i>0$; in general the right side needs $|\omega_0\omega_2|$.
:reading: missing_points_have_the_factor_zero | Read for $n=1$, where $\omega_2$ and $\mathbf a_2$ do not exist: whatever stands for them, the factor $n-1$
  makes it $0$, the curvature of a segment.
:figure: end_curvature

$\|\mathbf a\times\mathbf b\|$ is the area of the parallelogram of $\mathbf a$ and $\mathbf b$; with this meaning the formula holds in any dimension.
:::

:::{statement} wang-ch3:3.2.5-right
:title: Curvature at t = 1
:zh: t=1 处的曲率
:printed: \kappa(1)=\frac{n-1}n\frac{\omega_{n-2}\omega_n}{\omega_{n-1}^2}\frac{\|\mathbf a_{n-1}\times\mathbf a_n\|}{\|\mathbf a_n\|^3}
:holds-by: end_curvature_and_torsion_follow_in_every_degree end_derivative_vectors_in_every_degree end_curvature_at_one
:needs: repeated_first_points_leave_curvature_undetermined | $\mathbf R_{n-1}\ne\mathbf R_n$; the example is to be read in reversed order.
:needs: negative_weight_makes_printed_curvature_negative | $\omega_i>0$, as at $t=0$.
:figure: end_curvature
:::

:::{statement} wang-ch3:3.2.6-left
:title: Torsion at t = 0
:zh: t=0 处的挠率
:printed: \tau(0)=\frac{n-2}n\frac{\omega_0\omega_3}{\omega_1\omega_2}\frac{(\mathbf a_1,\mathbf a_2,\mathbf a_3)}{\|\mathbf a_1\times\mathbf a_2\|^2}
:holds-by: end_curvature_and_torsion_follow_in_every_degree end_derivative_vectors_in_every_degree end_torsion_at_zero
:hypothesis: collinear_first_points_leave_torsion_undetermined | $\mathbf a_1\times\mathbf a_2\ne\mathbf 0$: the first three points are not on a line.
:reading: missing_points_have_the_factor_zero | Read for $n=2$, where $\omega_3$ and $\mathbf a_3$ do not exist: whatever stands for them, the factor $n-2$
  makes it $0$, the torsion of a plane curve.
:figure: end_formulas_undetermined

The sign of the weights does not matter here, as long as $\omega_0,\omega_1,\omega_2$ are not $0$.
:::

:::{statement} wang-ch3:3.2.6-right
:title: Torsion at t = 1
:zh: t=1 处的挠率
:printed: \tau(1)=\frac{n-2}n\frac{\omega_{n-3}\omega_n}{\omega_{n-2}\omega_{n-1}}\frac{(\mathbf a_{n-2},\mathbf a_{n-1},\mathbf a_n)}{\|\mathbf a_{n-1}\times\mathbf a_n\|^2}
:holds-by: end_curvature_and_torsion_follow_in_every_degree end_derivative_vectors_in_every_degree end_torsion_at_one
:hypothesis: collinear_first_points_leave_torsion_undetermined | $\mathbf a_{n-1}\times\mathbf a_n\ne\mathbf 0$: the last three points are not on a line; the example is
  to be read in reversed order.

Reversed order turns every edge round and reverses their order in the mixed product: four changes of sign, hence none, as printed.
:::
*/

/* a_i = R_i - R_{i-1} */
static inline void G(edge)(int dim, const num R[], int i, num a[])
{
    for (int c = 0; c < dim; c++)
        a[c] = sub(R[i * dim + c], R[(i - 1) * dim + c]);
}
static inline void G(free_polygon)(trial *T, int n, int dim, num R[], num w[])
{
    static const char *const axis[] = {"x", "y", "z"};
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        for (int c = 0; c < dim; c++)
            R[i * dim + c] = unknown(T, axis[c], i);
    }
}

/* Compares the curvature at t with factor |a x b| / |a|^3, in which `length` is |a|^2. */
static inline void G(compare_curvature)(trial *T, int n, int dim, const num R[], const num w[], num t, num factor,
                                        const num a[], const num b[], num length)
{
    num x[3], area = from_int(0), cube = mul(length, mul(length, length));
    if (dim == 2) {
        area = G(cross2)(a, b);
        area = mul(area, area);
    } else {
        G(cross3)(a, b, x);
        area = G(norm_squared)(3, x);
    }
    about(T, "curvature squared");
    same(T, G(rational_curvature_squared)(n, dim, R, w, t), mul(mul(factor, factor), div(area, cube)));
    about(T, "1/factor");
    nonnegative(T, div(from_int(1), factor));
#if INTERVAL || DOUBLE
    num D[3 * 3];
    G(rational_derivatives)(n, dim, R, w, t, 2, D);
    about(T, "curvature");
    same(T, G(curvature)(dim, D + dim, D + 2 * dim), mul(factor, div(root(2, area), mul(length, root(2, length)))));
#endif
}

/*
:::{claim} end_curvature_at_zero
:title: The curvature at t = 0 is the printed one
:zh: t=0 处曲率公式成立
:given: points of the plane and of space with $a_1\ne0$ and otherwise free, positive weights
:then: $\kappa(0)^2=\left(\frac{n-1}n\frac{\omega_0\omega_2}{\omega_1^2}\right)^2\frac{|a_1\times a_2|^2}{|a_1|^6}$ and the factor that is squared is
  positive
:method: The squares are one element of the field of rational functions of the weights and the coordinates; both $\kappa(0)$ and the printed side are not
  negative, so they are equal.  Intervals and binary64 also compare the roots.
:degrees: 2..6 sampled 10
:control: the factor $n/(n-1)$
:::
*/
CLAIM(end_curvature_at_zero)
{
    int n = T->degree;
    for (int dim = 2; dim <= 3; dim++) {
        num w[MAX_DEGREE + 1], R[(MAX_DEGREE + 1) * 3], a1[3], a2[3];
        G(free_polygon)(T, n, dim, R, w);
        G(edge)(dim, R, 1, a1);
        G(edge)(dim, R, 2, a2);
        num factor = mul(fault(T, from_ratio(n - 1, n), from_ratio(n, n - 1)), div(mul(w[0], w[2]), mul(w[1], w[1])));
        G(compare_curvature)(T, n, dim, R, w, from_int(0), factor, a1, a2, G(norm_squared)(dim, a1));
    }
}

/*
:::{claim} end_curvature_at_one
:title: The curvature at t = 1 is the printed one
:zh: t=1 处曲率公式成立
:given: points of the plane and of space with $a_n\ne0$ and otherwise free, positive weights
:then: $\kappa(1)^2=\left(\frac{n-1}n\frac{\omega_{n-2}\omega_n}{\omega_{n-1}^2}\right)^2\frac{|a_{n-1}\times a_n|^2}{|a_n|^6}$ and the factor that is
  squared is positive
:method: As at $t=0$; the curve is not reversed, the kernel is asked at $t=1$.
:degrees: 2..6 sampled 10
:control: the length $|a_{n-1}|$ in place of $|a_n|$
:::
*/
CLAIM(end_curvature_at_one)
{
    int n = T->degree;
    for (int dim = 2; dim <= 3; dim++) {
        num w[MAX_DEGREE + 1], R[(MAX_DEGREE + 1) * 3], last[3], before[3];
        G(free_polygon)(T, n, dim, R, w);
        G(edge)(dim, R, n, last);
        G(edge)(dim, R, n - 1, before);
        num factor = mul(from_ratio(n - 1, n), div(mul(w[n - 2], w[n]), mul(w[n - 1], w[n - 1])));
        num length = G(norm_squared)(dim, fault(T, last, before));
        G(compare_curvature)(T, n, dim, R, w, from_int(1), factor, last, before, length);
    }
}

/*
:::{claim} end_torsion_at_zero
:title: The torsion at t = 0 is the printed one
:zh: t=0 处挠率公式成立
:given: points of space with $a_1\times a_2\ne0$ and otherwise free, weights of which $\omega_0,\omega_1,\omega_2$ are not $0$
:then: $\tau(0)=\frac{n-2}n\frac{\omega_0\omega_3}{\omega_1\omega_2}\frac{(a_1,a_2,a_3)}{|a_1\times a_2|^2}$
:method: Both sides are one element of the field of rational functions of the weights and the coordinates.
:degrees: 3..6 sampled 10
:control: the factor $(n-1)/n$
:::
*/
CLAIM(end_torsion_at_zero)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[(MAX_DEGREE + 1) * 3], a[3][3], x[3];
    G(free_polygon)(T, n, 3, R, w);
    for (int i = 0; i < 3; i++)
        G(edge)(3, R, i + 1, a[i]);
    G(cross3)(a[0], a[1], x);
    num factor = mul(from_ratio(fault(T, n - 2, n - 1), n), div(mul(w[0], w[3]), mul(w[1], w[2])));
    same(T, G(rational_torsion)(n, R, w, from_int(0)),
         mul(factor, div(G(det3)(a[0], a[1], a[2]), G(norm_squared)(3, x))));
}

/*
:::{claim} end_torsion_at_one
:title: The torsion at t = 1 is the printed one
:zh: t=1 处挠率公式成立
:given: points of space with $a_{n-1}\times a_n\ne0$ and otherwise free, weights of which $\omega_{n-2},\omega_{n-1},\omega_n$ are not $0$
:then: $\tau(1)=\frac{n-2}n\frac{\omega_{n-3}\omega_n}{\omega_{n-2}\omega_{n-1}}\frac{(a_{n-2},a_{n-1},a_n)}{|a_{n-1}\times a_n|^2}$
:method: As at $t=0$; the curve is not reversed, the kernel is asked at $t=1$.
:degrees: 3..6 sampled 10
:control: the edges in the order $(a_n,a_{n-1},a_{n-2})$, the sign that a thoughtless reversal gives
:::
*/
CLAIM(end_torsion_at_one)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[(MAX_DEGREE + 1) * 3], a[3][3], x[3];
    G(free_polygon)(T, n, 3, R, w);
    for (int i = 0; i < 3; i++)
        G(edge)(3, R, n - 2 + i, a[i]);
    G(cross3)(a[1], a[2], x);
    num factor = mul(from_ratio(n - 2, n), div(mul(w[n - 3], w[n]), mul(w[n - 2], w[n - 1])));
    num volume = fault(T, G(det3)(a[0], a[1], a[2]), G(det3)(a[2], a[1], a[0]));
    same(T, G(rational_torsion)(n, R, w, from_int(1)), mul(factor, div(volume, G(norm_squared)(3, x))));
}

/*
:::{statement} wang-ch3:prop-3.2.4-letter
:title: The letter of the curvature
:zh: 曲率的记号
:definition: yes
:printed: The curvature $\kappa$ is usually written $k$, too, and is written so from here on.
:checked-by: curvature_and_torsion_belong_to_arc_length

The source remarks, at the end of its proof, that the curvature is also written $k$, as it is from there on.  In (3.2.3) and (3.2.4)
$k$ is a number of points; here it stays that.
:::

### What the formulas need

:::{claim} missing_points_have_the_factor_zero
:title: Segments have end curvature 0, and quadratics end torsion 0
:zh: 线段曲率为零，二次曲线挠率为零
:given: in space, two points with weights ($n=1$), and three points with weights ($n=2$)
:then: $\kappa(0)=\kappa(1)=0$ for $n=1$, and $(R',R'',R''')=0$ at both ends for $n=2$: what the factors $n-1$ and $n-2$ say
:method: Both are $0$ in the field of the weights and the coordinates.
:control: the same with one point more
:::
*/
CLAIM(missing_points_have_the_factor_zero)
{
    for (int end = 0; end <= 1; end++) {
        num w[4], R[4 * 3], D[4 * 3];
        G(free_polygon)(T, 3, 3, R, w);
        vanishes(T, G(rational_curvature_squared)(fault(T, 1, 2), 3, R, w, from_int(end)));
        G(rational_derivatives)(fault(T, 2, 3), 3, R, w, from_int(end), 3, D);
        vanishes(T, G(det3)(D + 3, D + 6, D + 9));
    }
}

#if FIELD
/*
:::{claim} repeated_first_points_leave_curvature_undetermined
:title: A parabola that starts with a repeated point has curvature 2 there; the formula says 0/0
:zh: 首点重合的抛物线弧起点曲率为 2，公式给出 0/0
:kind: counterexample
:types: field
:data: R = (0,0) (0,0) (1/6,0) (1/2,0) (1,1); ω = 1 1 1 1 1
:instead: R = (0,0) (1/8,0) (1/6,0) (1/2,0) (1,1)
:result: x(t) = "t^2"; y(t) = "t^4"; κ(0)² = 4; |a_1 × a_2|² = 0; |a_1|⁶ = 0
:given: the arc $x=t^2$, $y=t^4$ of the parabola $y=x^2$ as a curve of degree $n=4$ with points $R$ and equal weights: $R_0=R_1$
:then: $\kappa(t)\to2$ for $t\to0$, but the denominator $\|a_1\|^3$ of (3.2.5) is $0$, and so is the numerator
:method: $\kappa^2$ is computed at a variable $t$, and the rational function is evaluated at $t=0$: where its value is $4$, the
  denominator of the formula is asked to be different from $0$.
:control: the point $R_1$ moved away from $R_0$
:::
*/
CLAIM(repeated_first_points_leave_curvature_undetermined)
{
    num R[10], w[5], a1[2], a2[2], P[2], t = variable_f("t");
    given_points(T, "R", 5, 2, R);
    given_points(T, "ω", 5, 1, w);
    G(rational_point)(4, 2, R, w, t, P);
    found_text(T, "x(t)", to_string_f(P[0]));
    found_text(T, "y(t)", to_string_f(P[1]));
    num squared = G(rational_curvature_squared)(4, 2, R, w, t);
    show(T, "κ(t)²", squared);
    found(T, "κ(0)²", substitute_f(squared, t, from_int(0)));
    G(edge)(2, R, 1, a1);
    G(edge)(2, R, 2, a2);
    num area = G(cross2)(a1, a2), length = G(norm_squared)(2, a1);
    found(T, "|a_1 × a_2|²", mul(area, area));
    found(T, "|a_1|⁶", mul(mul(length, length), length));
    about(T, "the denominator |a_1|⁶ is not 0");
    refute(T, is_zero_f(length));
}

/*
:::{claim} collinear_first_points_leave_torsion_undetermined
:title: Points without repetition, torsion 2 at the start; the formula says 0/0
:zh: 无重点而首三点共线：起点挠率为 2，公式给出 0/0
:kind: counterexample
:types: field
:data: R = (0,0,0) (1/4,0,0) (1/2,0,0) (3/4,1/4,0) (1,1,1); ω = 1 1 1 1 1
:instead: R = (0,0,0) (1/4,0,0) (1/2,1/4,0) (3/4,1/4,0) (1,1,1)
:result: x(t) = "t"; y(t) = "t^3"; z(t) = "t^4"; pairs of equal points = 0; τ(0) = 2; (a_1, a_2, a_3) = 0; |a_1 × a_2|² = 0
:given: $x=t$, $y=t^3$, $z=t^4$ as a curve of degree $n=4$ with equal weights; its points $R$ are all different, the first three on a line
:then: $\tau(t)\to2$ for $t\to0$, but the denominator $\|a_1\times a_2\|^2$ of (3.2.6) is $0$, and so is the numerator
:method: $\tau$ is computed at a variable $t$, and the rational function is evaluated at $t=0$: where its value is $2$, the
  denominator of the formula is asked to be different from $0$.
:control: the point $R_2$ moved off the line of $R_0$ and $R_1$
:::
*/
CLAIM(collinear_first_points_leave_torsion_undetermined)
{
    num R[15], w[5], a[3][3], x[3], P[3], t = variable_f("t");
    given_points(T, "R", 5, 3, R);
    given_points(T, "ω", 5, 1, w);
    G(rational_point)(4, 3, R, w, t, P);
    found_text(T, "x(t)", to_string_f(P[0]));
    found_text(T, "y(t)", to_string_f(P[1]));
    found_text(T, "z(t)", to_string_f(P[2]));
    int equal = 0;
    for (int j = 1; j < 5; j++)
        for (int i = 0; i < j; i++)
            equal += equal_f(R[3 * i], R[3 * j]) && equal_f(R[3 * i + 1], R[3 * j + 1]) &&
                     equal_f(R[3 * i + 2], R[3 * j + 2]);
    found_whole(T, "pairs of equal points", equal);
    num torsion = G(rational_torsion)(4, R, w, t);
    show(T, "τ(t)", torsion);
    found(T, "τ(0)", substitute_f(torsion, t, from_int(0)));
    for (int i = 0; i < 3; i++)
        G(edge)(3, R, i + 1, a[i]);
    G(cross3)(a[0], a[1], x);
    num area = G(norm_squared)(3, x);
    found(T, "(a_1, a_2, a_3)", G(det3)(a[0], a[1], a[2]));
    found(T, "|a_1 × a_2|²", area);
    about(T, "the denominator |a_1 × a_2|² is not 0");
    refute(T, is_zero_f(area));
}
#endif

#if RATIONAL
/*
:::{claim} negative_weight_makes_printed_curvature_negative
:title: With a negative weight the printed curvature is negative
:zh: 权为负时所印曲率为负
:kind: counterexample
:data: R = (0,0) (1,0) (1,1) (0,1); ω = 1 1 -1/4 1
:instead: ω = 1 1 1/4 1
:result: zeros of ω(t) in [0,1] = 0; κ(0) = 1/6; κ(0) as printed = -1/6
:given: the cubic curve with the corners $R$ of a square and weights $\omega$, of which one is negative, though $\omega(t)$ has no zero in $[0,1]$
:then: the printed side of (3.2.5) is $-\kappa(0)$
:method: $\kappa(0)$ is the root of the exact $\kappa(0)^2$.
:control: the negative weight made positive
:::
*/
CLAIM(negative_weight_makes_printed_curvature_negative)
{
    enum { n = 3 };
    num R[2 * (n + 1)], w[n + 1], a1[2], a2[2], zero = from_int(0);
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    int zeros = count_roots(poly_from_bernstein(n, w), zero, from_int(1), CLOSED).distinct;
    found_whole(T, "zeros of ω(t) in [0,1]", zeros);
    G(edge)(2, R, 1, a1);
    G(edge)(2, R, 2, a2);
    num curvature = root(2, G(rational_curvature_squared)(n, 2, R, w, zero));
    num length = root(2, G(norm_squared)(2, a1)), area = root(2, G(gram)(2, a1, a2));
    num factor = mul(from_ratio(n - 1, n), div(mul(w[0], w[2]), mul(w[1], w[1])));
    /* (n-1)/n ω_0 ω_2/ω_1² |a_1 × a_2|/|a_1|³ */
    num printed = mul(factor, div(area, mul(length, mul(length, length))));
    found(T, "κ(0)", curvature);
    found(T, "κ(0) as printed", printed);
    about(T, "left κ(0), right as printed");
    if (zeros == 0)
        same(T, curvature, printed);
}
#endif

/*
## The proof

The proof writes $R=P/\omega$, differentiates $P=\omega R$ three times, solves for the derivatives of $R$, and puts $t=0$.

:::{statement} wang-ch3:prop-3.2.4-step-1
:title: First derivative of the quotient
:zh: 商的一阶导矢
:printed: \mathbf P=\omega\mathbf R,\qquad\mathbf R'=(\mathbf P'-\omega'\mathbf R)/\omega
:holds-by: derivatives_of_a_quotient
:::

:::{claim} derivatives_of_a_quotient
:title: The derivatives of R = P/ω up to the third
:zh: R = P/ω 的前三阶导矢
:given: any two functions $P$, $\omega$ with three derivatives, $\omega\ne0$
:then: $R'=(P'-\omega'R)/\omega$, $R''=(P''-\omega''R-2\omega'R')/\omega$, $R'''=(P'''-\omega'''R-3\omega''R'-3\omega'R'')/\omega$
:method: The formulas at a point depend on the values of $P,\omega$ and their three derivatives there only, so cubic polynomials with free coefficients stand
  for all functions.  In the field their quotient is differentiated formally; elsewhere it is divided as a power series.
:control: $\omega'$ for $\omega''$ in $R''$, as printed
:::
*/
CLAIM(derivatives_of_a_quotient)
{
    num P[4], W[4], R[4]; /* derivatives 0 ... 3 at t = 0 */
    W[0] = positive(T, "w", 0);
    for (int k = 0; k < 4; k++) {
        P[k] = unknown(T, "p", k);
        W[k] = k > 0 ? unknown(T, "w", k) : W[0];
    }
    num taylor[] = {from_int(1), from_int(1), from_ratio(1, 2), from_ratio(1, 6)};
#if FIELD
    num t = variable_f("t"), above = from_int(0), below = from_int(0);
    for (int k = 3; k >= 0; k--) {
        above = add(mul(above, t), mul(taylor[k], P[k]));
        below = add(mul(below, t), mul(taylor[k], W[k]));
    }
    num quotient = div(above, below);
    for (int k = 0; k < 4; k++, quotient = derivative_f(quotient, t))
        R[k] = substitute_f(quotient, t, from_int(0));
#else
    G(series) p, w;
    for (int k = 0; k < 4; k++) {
        p.c[k] = mul(taylor[k], P[k]);
        w.c[k] = mul(taylor[k], W[k]);
    }
    for (int k = 0; k < 4; k++)
        R[k] = div(G(series_div)(p, w).c[k], taylor[k]);
#endif
    num two = from_int(2), three = from_int(3);
    num first = mul(W[1], R[0]), second = add(mul(fault(T, W[2], W[1]), R[0]), mul(two, mul(W[1], R[1])));
    num third = add(mul(W[3], R[0]), mul(three, add(mul(W[2], R[1]), mul(W[1], R[2]))));
    same(T, R[0], div(P[0], W[0]));
    same(T, R[1], div(sub(P[1], first), W[0]));
    same(T, R[2], div(sub(P[2], second), W[0]));
    same(T, R[3], div(sub(P[3], third), W[0]));
}

/*
:::{statement} wang-ch3:prop-3.2.4-step-2
:title: Second derivative of the quotient
:zh: 商的二阶导矢
:printed: \mathbf R''=(\mathbf P''-\omega'\mathbf R-2\omega'\mathbf R')/\omega
:class: misprint
:refuted-by: printed_second_derivative_of_quotient_is_wrong
:corrected: \mathbf R''=(\mathbf P''-\omega''\mathbf R-2\omega'\mathbf R')/\omega
:corrected-by: derivatives_of_a_quotient
:figure: quotient_derivatives

A prime is missing.  In each term the orders of the derivatives have the sum $2$; in the printed $\omega'\mathbf R$ it is $1$.  As printed the vector
would even depend on the origin of the coordinates.
:::
*/

#if RATIONAL
/* The derivatives 0 ... r of P, of omega and of R = P/omega at t = 0, for points of the line. */
static void G(derivatives_at_zero)(int n, const num R[], const num w[], int r, num P[], num W[], num D[])
{
    num H[(MAX_DEGREE + 1) * 2], HD[(MAX_DEGREE + 1) * 2];
    G(rational_homogenize)(n, 1, R, w, H);
    G(bezier_derivatives)(n, 2, H, from_int(0), r, HD);
    for (int k = 0; k <= r; k++) {
        P[k] = HD[2 * k];
        W[k] = HD[2 * k + 1];
    }
    G(rational_derivatives)(n, 1, R, w, from_int(0), r, D);
}

/*
:::{claim} printed_second_derivative_of_quotient_is_wrong
:title: The printed R'' of the segment from 1 to 2 with weights 1, 2
:zh: 线段 1→2（权 1, 2）的 R″ 与所印不符
:kind: counterexample
:data: R = 1 2; ω = 1 2
:result: P, P', P'' = 1 3 0; ω, ω', ω'' = 1 1 0; R, R', R'' = 1 2 -4; R'' as printed = -5
:given: the segment of the line with points $R$ and weights $\omega$, $P=\omega R$; $t=0$
:then: $R''(0)$ is not $(P''-\omega'R-2\omega'R')/\omega$
:method: All derivatives are computed exactly.
:control: $\omega''R$ for $\omega'R$
:::
*/
CLAIM(printed_second_derivative_of_quotient_is_wrong)
{
    num R[2], w[2], P[3], W[3], D[3];
    given_points(T, "R", 2, 1, R);
    given_points(T, "ω", 2, 1, w);
    G(derivatives_at_zero)(1, R, w, 2, P, W, D);
    found_points(T, "P, P', P''", 3, 1, P);
    found_points(T, "ω, ω', ω''", 3, 1, W);
    found_points(T, "R, R', R''", 3, 1, D);
    /* (P'' - ω' R - 2 ω' R')/ω */
    num sum = add(mul(fault(T, W[2], W[1]), D[0]), mul(from_int(2), mul(W[1], D[1])));
    num printed = div(sub(P[2], sum), W[0]);
    found(T, "R'' as printed", printed);
    about(T, "R''(0), left as it is, right as printed");
    same(T, D[2], printed);
}

/*
:::{statement} wang-ch3:prop-3.2.4-step-3
:title: Third derivative of the quotient
:zh: 商的三阶导矢
:printed: \mathbf R'''=(\mathbf P'''-\omega'''\mathbf R-3\omega''\mathbf R''-3\omega'\mathbf R'')/\omega
:class: misprint
:refuted-by: printed_third_derivative_of_quotient_is_wrong
:corrected: \mathbf R'''=(\mathbf P'''-\omega'''\mathbf R-3\omega''\mathbf R'-3\omega'\mathbf R'')/\omega
:corrected-by: derivatives_of_a_quotient
:figure: quotient_derivatives

A prime too many: the orders in $\omega''\mathbf R''$ have the sum $4$.
:::

:::{claim} printed_third_derivative_of_quotient_is_wrong
:title: The printed R''' of (2t + 2t²)/(1 + t²)
:zh: (2t + 2t²)/(1 + t²) 的 R‴ 与所印不符
:kind: counterexample
:data: R = 0 1 2; ω = 1 1 2
:result: P, P', P'', P''' = 0 2 4 0; ω, ω', ω'', ω''' = 1 0 2 0; R, R', R'', R''' = 0 2 4 -12; R''' as printed = -24
:given: the quadratic curve of the line with points $R$ and weights $\omega$, $P=\omega R$, which is $R(t)=\frac{2t+2t^2}{1+t^2}$; $t=0$
:then: $R'''(0)$ is not the printed right side, but the half of it
:method: All derivatives are computed exactly.
:control: $\omega''R'$ for $\omega''R''$
:::
*/
CLAIM(printed_third_derivative_of_quotient_is_wrong)
{
    num R[3], w[3], P[4], W[4], D[4];
    given_points(T, "R", 3, 1, R);
    given_points(T, "ω", 3, 1, w);
    G(derivatives_at_zero)(2, R, w, 3, P, W, D);
    found_points(T, "P, P', P'', P'''", 4, 1, P);
    found_points(T, "ω, ω', ω'', ω'''", 4, 1, W);
    found_points(T, "R, R', R'', R'''", 4, 1, D);
    /* (P''' - ω''' R - 3 ω'' R'' - 3 ω' R'')/ω */
    num sum = add(mul(W[2], fault(T, D[1], D[2])), mul(W[1], D[2]));
    num printed = div(sub(P[3], add(mul(W[3], D[0]), mul(from_int(3), sum))), W[0]);
    found(T, "R''' as printed", printed);
    about(T, "R'''(0), left as it is, right as printed");
    same(T, D[3], printed);
}
#endif

/*
### The derivatives at the ends

:::{statement} wang-ch3:prop-3.2.4-step-4
:title: The first derivative at t = 0
:zh: t=0 处一阶导矢
:printed: \mathbf R'(0)=n\,\omega_1\mathbf a_1/\omega_0
:holds-by: end_derivative_vectors_in_every_degree end_derivative_vectors_at_both_ends
:::

:::{statement} wang-ch3:prop-3.2.4-step-5
:title: The second derivative at t = 0
:zh: t=0 处二阶导矢
:printed: \mathbf R''(0)=n(n-1)\,\omega_2\mathbf a_2/\omega_0+f_1\mathbf a_1
:holds-by: end_derivative_vectors_in_every_degree end_derivative_vectors_at_both_ends
:::

:::{statement} wang-ch3:prop-3.2.4-step-6
:title: The third derivative at t = 0
:zh: t=0 处三阶导矢
:printed: \mathbf R'''(0)=n(n-1)(n-2)\,\omega_3\mathbf a_3/\omega_0+g_2\mathbf a_2+g_1\mathbf a_1
:holds-by: end_derivative_vectors_in_every_degree end_derivative_vectors_at_both_ends
:::

:::{statement} wang-ch3:prop-3.2.4-step-7
:title: What the coefficients f_1, g_1, g_2 depend on
:zh: f_1、g_1、g_2 的依赖关系
:printed: Here $f_1$, $g_2$, $g_1$ are determined by the weights and $n$.
:holds-by: end_derivative_vectors_in_every_degree end_derivative_vectors_at_both_ends

They are, with $\omega'=n(\omega_1-\omega_0)$ and $\omega''=n(n-1)(\omega_2-2\omega_1+\omega_0)$, the derivatives of $\omega$ at $0$:

$\omega_0f_1=n(n-1)(\omega_2-2\omega_1)-2n\omega'\omega_1/\omega_0$,

$\omega_0g_2=n(n-1)(n-2)(\omega_3-3\omega_2)-3n(n-1)\omega'\omega_2/\omega_0$,

$\omega_0g_1=n(n-1)(n-2)(\omega_3-3\omega_2+3\omega_1)-3\omega'f_1-3n\omega''\omega_1/\omega_0$.
:::
*/

/* The right sides at t = 0, D[1], D[2], D[3], from w_0 ... w_3 and a[1], a[2], a[3]. */
static inline void G(end_vectors)(num n, const num w[], const num a[], int factor, num D[])
{
    num n1 = sub(n, from_int(1)), n2 = sub(n, from_int(2)), two = from_int(2), three = from_int(3);
    num second = mul(n, n1), third = mul(second, n2);
    num dw = mul(n, sub(w[1], w[0])), ddw = mul(second, add(sub(w[2], mul(two, w[1])), w[0]));
    num f1 = mul(second, sub(w[2], mul(from_int(factor), w[1])));
    f1 = div(sub(f1, div(mul(mul(two, n), mul(dw, w[1])), w[0])), w[0]);
    num g2 = mul(third, sub(w[3], mul(three, w[2])));
    g2 = div(sub(g2, div(mul(mul(three, second), mul(dw, w[2])), w[0])), w[0]);
    num g1 = mul(third, add(sub(w[3], mul(three, w[2])), mul(three, w[1])));
    g1 = sub(sub(g1, mul(three, mul(dw, f1))), div(mul(mul(three, n), mul(ddw, w[1])), w[0]));
    g1 = div(g1, w[0]);
    D[1] = mul(div(mul(n, w[1]), w[0]), a[1]);
    D[2] = add(mul(div(mul(second, w[2]), w[0]), a[2]), mul(f1, a[1]));
    D[3] = add(add(mul(div(mul(third, w[3]), w[0]), a[3]), mul(g2, a[2])), mul(g1, a[1]));
}

/*
:::{claim} end_derivative_vectors_in_every_degree
:title: The first three derivatives at t = 0 in terms of the edges, for every n
:zh: t=0 处前三阶导矢用边矢表示（任意 n）
:given: any $n$; weights, $\omega_0\ne0$; $R_0$ and the edges $a_1,a_2,a_3$
:let: $f_1$, $g_1$, $g_2$ the expressions in $n$ and the weights of step 7
:then: $R'(0)=\frac{n\omega_1}{\omega_0}a_1$, $R''(0)=\frac{n(n-1)\omega_2}{\omega_0}a_2+f_1a_1$,
  $R'''(0)=\frac{n(n-1)(n-2)\omega_3}{\omega_0}a_3+g_2a_2+g_1a_1$
:method: $\sum B_i^n(t)c_i$ has at $0$ the Taylor coefficients $\binom nj\Delta^jc_0$; numerator and denominator are divided as power series, with $n$ a variable of
  the field.  What does not exist for $n<3$ has a factor $0$.  A coordinate is any coordinate.
:degrees: all
:control: $-\omega_1$ for $-2\omega_1$ in $f_1$
:::
*/
CLAIM(end_derivative_vectors_in_every_degree)
{
    num n = positive(T, "n", 0), w[4], R[4], a[4], D[4], choose = from_int(1);
    G(series) P, W;
    for (int i = 0; i < 4; i++) {
        w[i] = positive(T, "w", i);
        a[i] = unknown(T, "a", i); /* a_0 stands for R_0 */
        R[i] = i > 0 ? add(R[i - 1], a[i]) : a[0];
    }
    num p[4], v[4];
    for (int i = 0; i < 4; i++) {
        p[i] = mul(w[i], R[i]);
        v[i] = w[i];
    }
    for (int j = 0; j < 4; j++) {
        P.c[j] = mul(choose, p[0]);
        W.c[j] = mul(choose, v[0]);
        choose = mul(choose, div(sub(n, from_int(j)), from_int(j + 1)));
        for (int i = 0; i < 3 - j; i++) {
            p[i] = sub(p[i + 1], p[i]);
            v[i] = sub(v[i + 1], v[i]);
        }
    }
    G(series) curve = G(series_div)(P, W);
    G(end_vectors)(n, w, a, fault(T, 2, 1), D);
    same(T, curve.c[0], R[0]);
    same(T, curve.c[1], D[1]);
    same(T, mul(from_int(2), curve.c[2]), D[2]);
    same(T, mul(from_int(6), curve.c[3]), D[3]);
}

/*
:::{claim} end_derivative_vectors_at_both_ends
:title: The first three derivatives at both ends in terms of the edges
:zh: 两端前三阶导矢用边矢表示
:given: weights and points
:let: $f_1,g_1,g_2$ the expressions of step 7, and $\tilde f_1,\tilde g_1,\tilde g_2$ the same with $\omega_n,\omega_{n-1},\dots$ for $\omega_0,\omega_1,\dots$
:then: at $t=0$ as above; $R'(1)=\frac{n\omega_{n-1}}{\omega_n}a_n$, $R''(1)=-\frac{n(n-1)\omega_{n-2}}{\omega_n}a_{n-1}-\tilde f_1a_n$,
  $R'''(1)=\frac{n(n-1)(n-2)\omega_{n-3}}{\omega_n}a_{n-2}+\tilde g_2a_{n-1}+\tilde g_1a_n$
:method: The kernel is asked at $t=0$ and at $t=1$; both sides are one element of the field of rational functions of the weights and the points.
:degrees: 3..6 sampled 10
:control: the sign of $R''(1)$ as that of $R''(0)$
:::
*/
CLAIM(end_derivative_vectors_at_both_ends)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], a[4], v[4], D[4], wanted[4];
    G(free_polygon)(T, n, 1, R, w);
    for (int i = 1; i <= 3; i++)
        G(edge)(1, R, i, &a[i]);
    G(rational_derivatives)(n, 1, R, w, from_int(0), 3, D);
    G(end_vectors)(from_int(n), w, a, 2, wanted);
    for (int k = 1; k <= 3; k++)
        same(T, D[k], wanted[k]);

    for (int i = 0; i <= 3; i++) { /* the same at t = 1, the weights and the edges from the end */
        v[i] = w[n - i];
        if (i > 0)
            G(edge)(1, R, n + 1 - i, &a[i]);
    }
    G(rational_derivatives)(n, 1, R, w, from_int(1), 3, D);
    G(end_vectors)(from_int(n), v, a, 2, wanted);
    for (int k = 1; k <= 3; k++)
        same(T, D[k], fault(T, k == 2 ? neg(wanted[k]) : wanted[k], wanted[k]));
}

/*
:::{statement} wang-ch3:prop-3.2.4-step-8
:title: Substitution gives the curvature and the torsion at t = 0
:zh: 代入曲率与挠率公式
:printed: Put into the formulas of the curvature and torsion of a parametric curve, these three give $\kappa(0)$ and $\tau(0)$.
:holds-by: end_curvature_and_torsion_follow_in_every_degree curvature_and_torsion_belong_to_arc_length
:hypothesis: collinear_first_points_leave_torsion_undetermined | $\mathbf a_1\times\mathbf a_2\ne\mathbf 0$ for the torsion, as in (3.2.6).

Nothing of $f_1$, $g_1$, $g_2$ is used but that they are numbers.
:::

:::{claim} end_curvature_and_torsion_follow_in_every_degree
:title: The end derivatives give the printed curvature and torsion, for every n and in any dimension
:zh: 由端点导矢得所印曲率与挠率（任意 n，任意维数）
:given: any $n$; weights; vectors $a_1,a_2,a_3$ of space; any numbers $f_1,g_1,g_2$; and, for the curvature in any dimension, only the products
  $a_1\cdot a_1$, $a_1\cdot a_2$, $a_2\cdot a_2$
:let: $R'=\frac{n\omega_1}{\omega_0}a_1$, $R''=\frac{n(n-1)\omega_2}{\omega_0}a_2+f_1a_1$, $R'''=\frac{n(n-1)(n-2)\omega_3}{\omega_0}a_3+g_2a_2+g_1a_1$
:then: $\kappa^2$ and $\tau$ of these are $\left(\frac{n-1}n\frac{\omega_0\omega_2}{\omega_1^2}\right)^2\frac{|a_1\times a_2|^2}{|a_1|^6}$ and
  $\frac{n-2}n\frac{\omega_0\omega_3}{\omega_1\omega_2}\frac{(a_1,a_2,a_3)}{|a_1\times a_2|^2}$
:method: Equality in the field in which $n$, the weights, the coordinates, the products and $f_1,g_1,g_2$ are variables.  The area $|a_1\times a_2|^2$ is
  $|a_1|^2|a_2|^2-(a_1\cdot a_2)^2$ in any dimension.  By reversal (property 3.2.2) the same holds at $t=1$.
:degrees: all
:control: the factor $(n-1)/n$ in the torsion
:::
*/
CLAIM(end_curvature_and_torsion_follow_in_every_degree)
{
    /* n > 2; in binary64 the factors stay away from 0 */
    num one = from_int(1), two = from_int(2), n = add(positive(T, "n", 0), two), w[4], a[3][3], D[3][3];
    num f1 = unknown(T, "f", 1), g1 = unknown(T, "g", 1), g2 = unknown(T, "g", 2), n1 = sub(n, one), n2 = sub(n, two);
    for (int i = 0; i < 4; i++)
        w[i] = positive(T, "w", i);
    num A = div(mul(n, w[1]), w[0]), B = div(mul(mul(n, n1), w[2]), w[0]),
        C = div(mul(mul(mul(n, n1), n2), w[3]), w[0]);
    for (int c = 0; c < 3; c++) {
        static const char *const axis[] = {"x", "y", "z"};
        for (int i = 0; i < 3; i++)
            a[i][c] = unknown(T, axis[c], i + 1);
        D[0][c] = mul(A, a[0][c]);
        D[1][c] = add(mul(B, a[1][c]), mul(f1, a[0][c]));
        D[2][c] = add(add(mul(C, a[2][c]), mul(g2, a[1][c])), mul(g1, a[0][c]));
    }
    num x[3];
    G(cross3)(a[0], a[1], x);
    num area = G(norm_squared)(3, x), g = G(norm_squared)(3, a[0]);
    num factor = mul(div(n1, n), div(mul(w[0], w[2]), mul(w[1], w[1])));
    about(T, "curvature squared, in space");
    same(T, G(curvature_squared)(3, D[0], D[1]), mul(mul(factor, factor), div(area, mul(g, mul(g, g)))));
    about(T, "torsion");
    num other = mul(div(fault(T, n2, n1), n), div(mul(w[0], w[3]), mul(w[1], w[2])));
    same(T, G(torsion)(D[0], D[1], D[2]), mul(other, div(G(det3)(a[0], a[1], a[2]), area)));

    /* p = a_1.a_1, q = a_1.a_2, r = a_2.a_2 */
    num p = positive(T, "p", 0), q = unknown(T, "q", 0), r = positive(T, "r", 0);
    num d11 = mul(mul(A, A), p), d12 = mul(A, add(mul(B, q), mul(f1, p)));
    num d22 = add(mul(mul(B, B), r), add(mul(mul(two, mul(B, f1)), q), mul(mul(f1, f1), p)));
    num gram = sub(mul(d11, d22), mul(d12, d12));
    about(T, "curvature squared, from scalar products");
    same(T, div(gram, mul(d11, mul(d11, d11))),
         mul(mul(factor, factor), div(sub(mul(p, r), mul(q, q)), mul(p, mul(p, p)))));
}

/*
:::{statement} wang-ch3:prop-3.2.4-step-9
:title: The same at t = 1
:zh: t=1 处同理
:printed: In the same way one has $\kappa(1)$ and $\tau(1)$.
:holds-by: end_derivative_vectors_at_both_ends end_curvature_at_one end_torsion_at_one
:hypothesis: collinear_first_points_leave_torsion_undetermined | $\mathbf a_{n-1}\times\mathbf a_n\ne\mathbf 0$ for the torsion, as in (3.2.6).

The same up to a sign: $\mathbf R''(1)$ has $-\mathbf a_{n-1}$ where $\mathbf R''(0)$ has $\mathbf a_2$.  The curvature does not see it, and in the torsion it
puts the edges into the order $(\mathbf a_{n-2},\mathbf a_{n-1},\mathbf a_n)$ of the print.
:::
*/
#include "chapters/judge/claims_off.h"
