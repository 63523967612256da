/*
# Plane curves have coplanar points (顶点共面性)

If the curve lies in a plane, so does its polygon, and conversely.  The equation of the plane, applied to the curve, is
$\sum B_i^n(t)\omega_iz_i/\omega(t)$ with the values $z_i$ at the vertices; if this is $0$ for all $t$, every $\omega_iz_i$ is,
since the Bernstein functions are independent.  The last step, from $\omega_iz_i=0$ to $z_i=0$, is the only one that needs a
hypothesis: no weight is $0$.
*/
#if RATIONAL
#include "exact/record/sign.h"
#endif

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch3:prop-3.2.9
:title: The vertices of a plane curve are coplanar
:zh: 平面曲线的控制顶点共面
:printed: The vertices of a plane rational Bézier curve are coplanar.
:holds-by: mean_grows_by_one_term change_of_parameter_acts_on_one_factor weight_can_be_divided_out
  bernstein_sum_of_powers_is_a_power
:confirmed-by: plane_function_determines_the_vertices plane_form_of_the_curve powers_span_the_bernstein_functions
:needs: vertex_of_weight_zero_leaves_the_plane | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the
  weights are positive; it is enough that no weight is $0$
:figure: weight_zero_out_of_plane

The form of a plane, on the curve, is $\sum B_i^n\omega_if(R_i)/\omega(t)$; if it is 0, then so is $(1-t)^n\sum\binom ni\omega_if(R_i)s^i$ with $s=\frac t{1-t}$, a
polynomial in $s$, and so is every $\omega_if(R_i)$.
:::

First the equation of any plane, not only of $z=0$, is put into the curve.  It behaves as a coordinate does: the
weights stay, and the value at the vertex takes the place of the coordinate.

:::{claim} plane_form_of_the_curve
:title: The form of a plane, on the curve, has the weights of the curve
:zh: 曲线上的平面式仍以原权因子表示
:given: a curve of space with weights $\omega_i$ and points $(x_i,y_i,z_i)$; a plane $ax+by+cz+d=0$
:where: $\omega(t)\ne0$
:then: $\omega(t)\,(a\,x(t)+b\,y(t)+c\,z(t)+d)=\sum_iB_i^n(t)\omega_i(ax_i+by_i+cz_i+d)$
:method: Both sides are one element of the field, with every number a variable.  So the form vanishes on the curve exactly where
  the sum does, $\omega(t)$ being different from $0$; any plane may take the place of $z=0$.
:degrees: 1..6 sampled 12
:over: a#: planes
:control: the constant $d$ left out at the first vertex
:::
*/
CLAIM(plane_form_of_the_curve)
{
    int n = T->degree;
    num R[3 * (MAX_DEGREE + 1)], w[MAX_DEGREE + 1], B[MAX_DEGREE + 1], P[3], sum = from_int(0), form;
    num a[4], t = parameter(T, "t");
    for (int c = 0; c < 4; c++)
        a[c] = unknown(T, "a", c);
    G(bernstein_basis)(n, t, B);
    for (int i = 0; i <= n; i++) {
        static const char *const coordinate[] = {"x", "y", "z"};
        num value = fault(T, a[3], i == 0 ? from_int(0) : a[3]);
        w[i] = positive(T, "w", i);
        for (int c = 0; c < 3; c++) {
            R[3 * i + c] = unknown(T, coordinate[c], i);
            value = add(value, mul(a[c], R[3 * i + c]));
        }
        sum = add(sum, mul(B[i], mul(w[i], value)));
    }
    G(rational_point)(n, 3, R, w, t, P);
    form = add(add(mul(a[0], P[0]), mul(a[1], P[1])), add(mul(a[2], P[2]), a[3]));
    /* ω(t) (a x(t) + b y(t) + c z(t) + d) = Σ B_i^n(t) ω_i (a x_i + b y_i + c z_i + d) */
    same(T, mul(G(rational_weight)(n, w, t), form), sum);
}

/* sum_{k <= i} C(i,k) / C(n,k) c_k */
static num G(bernstein_coefficient)(int n, const num c[], int i)
{
    num sum = from_int(0);
    for (int k = 0; k <= i; k++)
        sum = add(sum, mul(from_ratio(binomial(i, k), binomial(n, k)), c[k]));
    return sum;
}

/*
The second step is that the Bernstein functions are independent.  To see it the coefficients are computed back from the
polynomial, by way of the powers of $t$.

:::{claim} powers_span_the_bernstein_functions
:title: Bernstein coefficients and coefficients of powers determine each other
:zh: Bernstein 系数与幂系数互相确定
:given: $b_0,\dots,b_n$
:let: $c_k=\binom nk\sum_{i\le k}(-1)^{k-i}\binom kib_i$
:then: $\sum_iB_i^n(t)b_i=\sum_kc_kt^k$ and $b_i=\sum_{k\le i}\binom ik\binom nk^{-1}c_k$; so if the polynomial vanishes for
  infinitely many $t$, or all $c_k$ vanish, then all $b_i$ do
:method: The sums are written out and compared in the field with the results of the kernels, with de Casteljau's algorithm at a variable
  $t$, and with the $b_i$.  
:degrees: 1..10 sampled 12
:defines: bernstein_to_power bernstein_from_power
:over: b#: coefficients
:control: the sign $(-1)^{k-i}$ left out
:::
*/
CLAIM(powers_span_the_bernstein_functions)
{
    int n = T->degree;
    num b[MAX_DEGREE + 1], c[MAX_DEGREE + 1], by_kernel[MAX_DEGREE + 1], back[MAX_DEGREE + 1];
    num t = parameter(T, "t"), value, sum = from_int(0);
    for (int i = 0; i <= n; i++)
        b[i] = unknown(T, "b", i);
    G(bernstein_to_power)(n, b, by_kernel);
    for (int k = 0; k <= n; k++) {
        c[k] = from_int(0);
        for (int i = 0; i <= k; i++) {
            long sign = fault(T, (k - i) % 2 == 0 ? 1 : -1, 1);
            c[k] = add(c[k], mul(from_int(sign * binomial(n, k) * binomial(k, i)), b[i]));
        }
        same(T, by_kernel[k], c[k]);
    }
    for (int k = n; k >= 0; k--)
        sum = add(mul(sum, t), c[k]);
    G(bezier_casteljau)(n, 1, b, t, &value);
    same(T, sum, value);
    G(bernstein_from_power)(n, c, back);
    for (int i = 0; i <= n; i++) {
        same(T, back[i], G(bernstein_coefficient)(n, c, i));
        same(T, back[i], b[i]);
    }
}

/*
Both together give the values $z_i$ from the function $z(t)$, and in the formula one sees the only danger, the division by $\omega_i$.

:::{claim} plane_function_determines_the_vertices
:title: The values at the vertices come back from the function on the curve
:zh: 由曲线上的函数还原顶点处的值
:given: weights $\omega_i\ne0$ and values $z_0,\dots,z_n$
:where: no weight is 0
:let: $N(t)=\omega(t)z(t)=\sum B_i^n(t)\omega_iz_i=\sum_kc_kt^k$
:then: $z_i=\frac1{\omega_i}\sum_{k\le i}\binom ik\binom nk^{-1}c_k$; so if $z(t)\equiv0$ then all $z_i=0$
:method: The $c_k$ are computed as the derivatives $N^{(k)}(0)/k!$, from the derivatives of $z(t)$ and of $\omega(t)$ by the rule of Leibniz;
  in the field with all weights and values variables.
:degrees: 1..6 sampled 8
:control: the weight of the last vertex taken for all
:::
*/
CLAIM(plane_function_determines_the_vertices)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], z[MAX_DEGREE + 1], Dz[MAX_DEGREE + 1], Dw[MAX_DEGREE + 1], c[MAX_DEGREE + 1];
    long factorial = 1;
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        z[i] = unknown(T, "z", i);
    }
    G(rational_derivatives)(n, 1, z, w, from_int(0), n, Dz);
    G(bezier_derivatives)(n, 1, w, from_int(0), n, Dw);
    for (int k = 0; k <= n; factorial *= ++k) {
        num sum = from_int(0);
        for (int j = 0; j <= k; j++)
            sum = add(sum, mul(from_int(binomial(k, j)), mul(Dw[j], Dz[k - j])));
        c[k] = div(sum, from_int(factorial));
    }
    for (int i = 0; i <= n; i++) /* z_i = 1/ω_i Σ C(i,k)/C(n,k) c_k */
        same(T, div(G(bernstein_coefficient)(n, c, i), w[fault(T, i, n)]), z[i]);
}

#if RATIONAL
/* The numerator sum w_i z_i B_i^n of z(t). */
static poly numerator_of(int n, const num_q w[], const num_q z[])
{
    num_q b[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++)
        b[i] = mul_q(w[i], z[i]);
    return poly_from_bernstein(n, b);
}

/* Is the denominator sum w_i B_i^n positive on [0,1]? */
static int is_positive(int n, const num_q w[])
{
    return sign_on(poly_from_bernstein(n, w), from_int_q(0), from_int_q(1), CLOSED) == SIGN_POSITIVE;
}

/*
A vertex of weight $0$ occurs neither in the numerator nor in the denominator, and the curve cannot know where it is.

:::{claim} vertex_of_weight_zero_leaves_the_plane
:title: A vertex of weight 0 may be outside the plane of the curve
:zh: 权为零的顶点可在平面之外
:kind: counterexample
:data: R = (0,0,0) (0,0,1) (1,0,0) (0,1,0); ω = 1 0 1 1
:instead: ω = 1 1 1 1
:result: ω(t) z(t) = "0"; (a_1, a_2, a_3) = 1
:given: the cubic curve of space with points $R$ and weights $\omega$, of which one is $0$, though $\omega(t)>0$ on $[0,1]$; $a_i=R_i-R_{i-1}$
:then: the curve is in the plane $z=0$, and the four vertices are not coplanar
:method: The numerator of $z(t)$ is computed, and the determinant of the edges.
:control: equal weights
:::
*/
CLAIM(vertex_of_weight_zero_leaves_the_plane)
{
    enum { n = 3 };
    num R[3 * (n + 1)], w[n + 1], z[n + 1], edge[9];
    given_points(T, "R", n + 1, 3, R);
    given_points(T, "ω", n + 1, 1, w);
    for (int i = 0; i <= n; i++)
        z[i] = R[3 * i + 2];
    for (int k = 0; k < 9; k++)
        edge[k] = sub(R[3 + k], R[k]);
    num volume = G(det3)(edge, edge + 3, edge + 6);
    poly numerator = numerator_of(n, w, z);
    found_text(T, "ω(t) z(t)", poly_to_string(numerator, "t"));
    found(T, "(a_1, a_2, a_3)", volume);
    about(T, "a curve in the plane z = 0 has coplanar vertices");
    refute(T, poly_is_zero(numerator) && is_positive(n, w) && !is_zero_q(volume));
}
#endif

/*
:::{statement} wang-ch3:prop-3.2.9-converse
:title: Coplanar vertices give a plane curve
:zh: 顶点共面则曲线为平面曲线
:printed: By property 3.2.5 the converse holds as well.
:holds-by: mean_grows_by_one_term
:confirmed-by: coplanar_vertices_give_a_plane_curve

True for all weights with $\omega(t)\ne0$: a point of the curve is a combination of the vertices with the sum of the factors $1$.
Property 3.2.5, of the convex hull, gives it for positive weights.
:::

The converse needs neither independence nor signs: the form of the plane vanishes at every vertex, and so does its sum.

:::{claim} coplanar_vertices_give_a_plane_curve
:title: A curve with coplanar vertices is in their plane
:zh: 顶点共面的曲线在该平面内
:given: any weights with $\omega(t)\ne0$; vertices $(x_i,y_i,z_i)$ with $ax_i+by_i+cz_i+d=0$, $c\ne0$
:where: $\omega(t)\ne0$; $c\ne0$
:then: $a\,x(t)+b\,y(t)+c\,z(t)+d=0$
:method: $z_i=-(ax_i+by_i+d)/c$; the form of the plane, on the curve, is the zero of the field.  Some coordinate has a factor that is
  not $0$ in the equation; that it is $z$ is a matter of names.
:degrees: 1..6 sampled 12
:over: a#: planes
:control: the last vertex lifted by $1$
:::
*/
CLAIM(coplanar_vertices_give_a_plane_curve)
{
    int n = T->degree;
    num R[3 * (MAX_DEGREE + 1)], w[MAX_DEGREE + 1], P[3], t = parameter(T, "t"), a[4];
    for (int c = 0; c < 4; c++)
        a[c] = c == 2 ? positive(T, "a", c) : unknown(T, "a", c);
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        R[3 * i] = unknown(T, "x", i);
        R[3 * i + 1] = unknown(T, "y", i);
        R[3 * i + 2] = div(neg(add(add(mul(a[0], R[3 * i]), mul(a[1], R[3 * i + 1])), a[3])), a[2]);
    }
    R[3 * n + 2] = fault(T, R[3 * n + 2], add(R[3 * n + 2], from_int(1)));
    G(rational_point)(n, 3, R, w, t, P);
    vanishes(T, add(add(mul(a[0], P[0]), mul(a[1], P[1])), add(mul(a[2], P[2]), a[3])));
}

/*
The printed proof goes the same way, with the plane taken as $z=0$, in four steps.

:::{statement} wang-ch3:prop-3.2.9-step-1
:title: The plane may be taken as the xy-plane
:zh: 可取曲线所在平面为 xy 平面
:printed: Without loss of generality the curve (3.2.2) is in the $xy$-plane.
:holds-by: mean_grows_by_one_term motion_takes_a_plane_to_the_coordinate_plane
:confirmed-by: plane_form_of_the_curve
:needs: weights_of_both_signs_make_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\omega(t)\ne0$:
  otherwise there is no point $\mathbf R(t)$

The motion is an affine map: the images of the points with the same weights have the image of the curve; and a point is in the plane exactly when the
third coordinate of its image is 0.
:::

:::{claim} motion_takes_a_plane_to_the_coordinate_plane
:title: A motion takes any plane to the xy-plane
:zh: 存在运动将任一平面化为 xy 平面
:types: field rational
:given: a plane $n\cdot X+d=0$ with the unit normal $n=\frac{(2p,\,2q,\,1-p^2-q^2)}{1+p^2+q^2}$, $m=(p,q,1)$; a point $X$
:let: $H=\frac2{m\cdot m}mm^T-I$; $e=(0,0,1)$
:then: $HH^T=I$, $\det H=1$, and the last coordinate of $HX+d\,e$ is $n\cdot X+d$
:method: Identities in $p$, $q$, $d$ and $X$.  Every unit vector but $-e$ is such an $n$; with $-e$ the same plane has the normal $e$, for
  which $p=q=0$.
:scope: every plane of space
:over: p q d x: -
:control: the sign of $d$
:::
*/
CLAIM(motion_takes_a_plane_to_the_coordinate_plane)
{
    num one = from_int(1), two = from_int(2), p = unknown(T, "p", 0), q = unknown(T, "q", 0), d = unknown(T, "d", 0);
    num m[3] = {p, q, one}, pp = mul(p, p), qq = mul(q, q), size = add(one, add(pp, qq)), X[3], H[3][3];
    num n[3] = {div(mul(two, p), size), div(mul(two, q), size), div(sub(one, add(pp, qq)), size)};
    for (int i = 0; i < 3; i++) {
        X[i] = unknown(T, "x", i);
        for (int j = 0; j < 3; j++)
            H[i][j] = sub(div(mul(two, mul(m[i], m[j])), size), from_int(i == j));
    }
    about(T, "a motion of space");
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            num product = from_int(0);
            for (int k = 0; k < 3; k++)
                product = add(product, mul(H[i][k], H[j][k]));
            same(T, product, from_int(i == j));
        }
    same(T, G(det3)(H[0], H[1], H[2]), one);
    num value = d, image = fault(T, d, neg(d));
    for (int j = 0; j < 3; j++) {
        value = add(value, mul(n[j], X[j]));
        image = add(image, mul(H[2][j], X[j]));
    }
    about(T, "the last coordinate of the image");
    same(T, image, value);
}

/*

:::{statement} wang-ch3:prop-3.2.9-step-2
:title: z(t) vanishes where its numerator does
:zh: z(t) 恒为零即分子恒为零
:printed: then $Z(t)/\omega(t)=\sum_{i=0}^nB_i^n(t)\omega_iz_i/\omega(t)\equiv0$, that is $\sum_{i=0}^nB_i^n(t)\omega_iz_i\equiv0$,
  $0\le t\le1$
:holds-by: mean_grows_by_one_term
:confirmed-by: plane_form_of_the_curve
:needs: weights_of_both_signs_make_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\omega(t)\ne0$:
  otherwise there is no point $\mathbf R(t)$

The mean of the numbers $z_i$ is the quotient of the two sums; it is 0 where its numerator is, and nowhere else.
:::

:::{statement} wang-ch3:prop-3.2.9-step-3
:title: The Bernstein functions are linearly independent
:zh: Bernstein 基线性无关
:printed: with $\sum_{i=0}^nB_i^n(t)\omega_iz_i\equiv0$ one has, by the linear independence of the basis, $\omega_iz_i=0$, $i=0,1,\dots,n$
:holds-by: change_of_parameter_acts_on_one_factor bernstein_sum_of_powers_is_a_power
:confirmed-by: powers_span_the_bernstein_functions collocation_determinant_does_not_vanish

Divided by $(1-t)^n$ the sum is $\sum\binom ni\omega_iz_is^i$ with $s=\frac t{1-t}$, by (2) of the first identity; a polynomial in $s$ that is 0 for all $s>0$ has
no coefficient but 0.
:::

:::{claim} collocation_determinant_does_not_vanish
:title: n+1 different parameters determine the Bernstein coefficients
:zh: n+1 个不同参数确定 Bernstein 系数
:given: parameters $t_0,\dots,t_n$
:then: $\det(B_j^n(t_i))=\prod_j\binom nj\prod_{i<j}(t_j-t_i)$, which is not $0$ when the parameters are different
:method: An identity in the field of the $t_i$; the determinant without division.
:degrees: 1..4
:over: t#: parameter values
:control: the binomial coefficients left out
:::
*/
CLAIM(collocation_determinant_does_not_vanish)
{
    enum { SIZE = 5 };
    int n = T->degree;
    num t[SIZE], B[SIZE * SIZE], product = from_int(1);
    for (int i = 0; i <= n; i++) {
        t[i] = unknown(T, "t", i);
        G(bernstein_basis)(n, t[i], B + i * (n + 1));
        product = fault(T, mul(product, from_int(binomial(n, i))), product);
        for (int j = 0; j < i; j++)
            product = mul(product, sub(t[i], t[j]));
    }
    same(T, G(determinant)(n + 1, B), product); /* Π C(n,j) Π (t_j - t_i), i < j */
}

/*
:::{statement} wang-ch3:prop-3.2.9-step-4
:title: The weights can be divided out
:zh: 约去权因子
:printed: $\omega_iz_i=0$ or (或) $z_i=0$, $i=0,1,\dots,n$, that is, the $\mathbf R_i$ are in the $xy$-plane
:meant: the words "that is, the $\mathbf R_i$ are in the $xy$-plane" | From $\omega_iz_i=0$ it follows that $z_i=0$: the word 或 joins a second form of the same
  equations.
:holds-by: weight_can_be_divided_out
:confirmed-by: plane_function_determines_the_vertices
:needs: weight_zero_hides_the_vertex | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\omega_i\ne0$
:figure: weight_zero_out_of_plane
:::
*/

/*
:::{claim} weight_can_be_divided_out
:title: A weight that is not 0 can be divided out
:zh: 非零权可约去
:given: a weight $\omega\ne0$ and a value $z$ at its vertex
:where: no weight is 0
:then: $\frac{\omega z}\omega=z$, so that $z=0$ when $\omega z=0$; index by index, in every degree
:method: An identity in $\omega$ and $z$.
:degrees: all
:control: $\omega^2$ for $\omega$ below
:::
*/
CLAIM(weight_can_be_divided_out)
{
    num w = positive(T, "w", 0), z = unknown(T, "z", 0), product = mul(w, z);
    same(T, div(product, fault(T, w, mul(w, w))), z);
}

#if RATIONAL
/*
In the last step it is seen once more, in one coordinate, what a weight $0$ hides.

:::{claim} weight_zero_hides_the_vertex
:title: With a weight 0 the product vanishes and the factor does not
:zh: 权为零时乘积为零而 z 不为零
:kind: counterexample
:data: z = 0 1 0; ω = 1 0 1
:instead: ω = 1 1 1
:result: ω(t) z(t) = "0"
:given: degree $2$, values $z$ at the vertices of which the middle one is not $0$, and weights $\omega$ of which the middle one is $0$
:then: $z(t)\equiv0$ and $z_1\ne0$
:method: The numerator of $z(t)$ is computed.
:control: equal weights
:::
*/
CLAIM(weight_zero_hides_the_vertex)
{
    num w[3], z[3];
    given_points(T, "z", 3, 1, z);
    given_points(T, "ω", 3, 1, w);
    poly numerator = numerator_of(2, w, z);
    found_text(T, "ω(t) z(t)", poly_to_string(numerator, "t"));
    about(T, "a curve in the plane z = 0 has its vertices there");
    refute(T, poly_is_zero(numerator) && is_positive(2, w) && !is_zero_q(z[1]));
}
#endif

#include "chapters/judge/claims_off.h"
