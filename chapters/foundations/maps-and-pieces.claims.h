/*
# What is done to a curve and keeps it (变换、升阶与分割)

Sentences in praise of the parametric form are about what can be done with a curve: its coordinates can be changed, it can be mapped, and it can be
given more freedom.
*/
#include "chapters/foundations/definition.h"

#include "chapters/judge/claims_on.h"

enum { dim = 2, space = 3 };

/*
## What is said of parametric curves in general

Section 1-4 of the source praises the parametric form.  It means a vector function $P(t)=[x(t)\;y(t)\;z(t)]$, and maps
its values; section 1-2 has moved control points, which is another thing.

:::{statement} hu-1987:1-4-advantage-invariance
:title: Parametric curves are geometrically invariant
:zh: 参数曲线的几何不变性
:printed: The parametric description has geometric invariance: its shape does not depend on the choice of coordinates, and geometric properties
  of a figure can be studied without relying on a coordinate system.
:holds-by: image_of_a_power_curve_is_one matrices_pass_to_the_points translation_adds_the_sum_of_the_functions rotations_keep_products
:hypothesis: image_keeps_no_chord | functions that are the factors of points have the sum 1: the relation of Cauchy.
  The curve (1-2-1) is parametric, and section 1-2 says of it that it depends on the coordinates.
:figure: two_cubes_and_their_image

As a vector function a polynomial curve is mapped to $P(t)\,T+m$, which is one of the same kind, whatever its coefficients are.  A change of coordinates is a rotation $T$ and a
translation $m$.  Then the derivatives are $P'(t)\,T$, $P''(t)\,T$, $P'''(t)\,T$, so that what their products say does not depend on the coordinates: speed, curvature and torsion.
With another constant sum $s$ the functions make of the points $Q_iT+m$ the curve $P(t)\,T+s\,m$, which has the shape but, for $m\ne0$, not the place of $P(t)\,T+m$.
:::

:::{claim} image_of_a_power_curve_is_one
:title: The image of a polynomial curve is the polynomial curve of the mapped coefficients
:zh: 多项式曲线的仿射象
:given: a sum $S=\sum c_kt^k$ of some terms, which may be any point of space, with one more coefficient $c$ and power $p=t^k$; any
  $3\times3$ matrix $T$ and any $m$
:then: $(S+cp)\,T+m=(ST+m)+(cT)\,p$; so $P(t)\,T+m=\sum_kd_kt^k$ with $d_0=c_0T+m$ and $d_k=c_kT$ for $k>0$
:method: Both sides with everything a variable; by induction for any number of terms.
:degrees: all
:scope: polynomial curves
:over: s# x# y# z#: coefficients; p: t; t#: matrices; m#: translations
:control: $m$ added to the new coefficient as well
:::
*/
CLAIM(image_of_a_power_curve_is_one)
{
    num S[space], M[space * space], power = unknown(T, "p", 0);
    num c[space] = {unknown(T, "x", 0), unknown(T, "y", 0), unknown(T, "z", 0)};
    for (int k = 0; k < space * space; k++)
        M[k] = unknown(T, "t", k);
    for (int k = 0; k < space; k++)
        S[k] = unknown(T, "s", k);
    for (int j = 0; j < space; j++) {
        num m = unknown(T, "m", j), image = m, before = m, d = fault(T, from_int(0), m);
        for (int k = 0; k < space; k++) {
            num entry = M[k * space + j];
            image = add(image, mul(add(S[k], mul(c[k], power)), entry));
            before = add(before, mul(S[k], entry));
            d = add(d, mul(c[k], entry));
        }
        same(T, image, add(before, mul(d, power))); /* (S + c p) T + m = (S T + m) + (c T) p */
    }
}

/*
## Maps (仿射变换、射影变换)

An affine map is a matrix and a translation, so what has been said covers it.  A projective map (射影变换) is a matrix as
well, but for homogeneous coordinates: afterwards one divides, and the division does not distribute over a sum.  The
parabola below shows that the images of control points are not the control points of the image, unless each takes its
denominator with it as a weight.

:::{statement} hu-1987:1-4-advantage-transformations
:title: Parametric curves are easily mapped by affine and projective maps
:zh: 参数曲线易于作仿射与射影变换
:printed: Geometric transformations of parametric curves, such as affine and projective ones, are easily carried out.
:reading: image_of_a_power_curve_is_one | affine maps can be carried out on the coefficients: each is multiplied by one matrix, and one vector is
  added to the one of $t^0$
:reading: projective_image_of_a_power_curve_is_rational | projective maps can be carried out on the homogeneous coefficients: each is multiplied by one matrix, and the coordinates of
  the point are divided by the last one
:reading: projective_image_is_not_the_curve_of_the_images | projective maps can be carried out on control points, each mapped for itself
:reading: what is easy: an opinion, which no computation decides
:figure: projective_image_of_a_parabola

:::

:::{claim} projective_image_of_a_power_curve_is_rational
:title: The projective image of a polynomial curve is the quotient of two polynomials of the mapped coefficients
:zh: 多项式曲线的射影象
:given: a sum $S=\sum c_kt^k$ of some terms, homogeneous coordinates of a point of space, four numbers, with one more coefficient $c$ and power
    $p=t^k$; any $4\times4$ matrix $T$
:where: the last coordinate of the image is not 0
:then: the three quotients of $(S+cp)\,T$ by its last coordinate are those of $ST+(cT)\,p$; so the image of the point with the homogeneous
  coordinates $\sum c_kt^k$ has the homogeneous coordinates $\sum_k(c_kT)\,t^k$
:method: Both sides with everything a variable; by induction for any number of terms.  A polynomial curve has $1$ for the last coordinate of $c_0$ and
  $0$ for that of the others.
:degrees: all
:scope: polynomial curves
:over: s# x#: coefficients; p: t; t#: matrices
:control: the last coordinate of the new coefficient left out of the denominator
:::
*/
CLAIM(projective_image_of_a_power_curve_is_rational)
{
    enum { homogeneous = 4 };
    num S[homogeneous], c[homogeneous], M[homogeneous * homogeneous], power = unknown(T, "p", 0);
    num whole_image[homogeneous], by_terms[homogeneous], zero = from_int(0);
    for (int k = 0; k < homogeneous * homogeneous; k++)
        M[k] = unknown(T, "t", k);
    for (int k = 0; k < homogeneous; k++) {
        S[k] = unknown(T, "s", k);
        c[k] = unknown(T, "x", k);
    }
    for (int j = 0; j < homogeneous; j++) {
        num before = zero, d = zero;
        whole_image[j] = zero;
        for (int k = 0; k < homogeneous; k++) {
            num entry = M[k * homogeneous + j];
            whole_image[j] = add(whole_image[j], mul(add(S[k], mul(c[k], power)), entry));
            before = add(before, mul(S[k], entry));
            d = add(d, mul(c[k], entry));
        }
        by_terms[j] = add(before, mul(j == homogeneous - 1 ? fault(T, d, zero) : d, power)); /* S T + (c T) p */
    }
    for (int j = 0; j < homogeneous - 1; j++)
        same(T, div(whole_image[j], whole_image[homogeneous - 1]), div(by_terms[j], by_terms[homogeneous - 1]));
}

#if RATIONAL
/*
:::{claim} projective_image_is_not_the_curve_of_the_images
:title: The projective images of the control points are not control points of the image
:zh: 射影变换不保持多项式曲线
:kind: counterexample
:given: the parabola $P$ with the Bézier points $R$, $x=2t-t^2$, $y=t^2$, so that $y=\bigl(\frac{x+y}2\bigr)^2$; the map $(x,y)\mapsto(\frac x{1+y},\frac y{1+y})$, and $t$
:data: R = (0,0) (1,0) (1,1); t = 1/2
:then: the image of $P(t)$ is not the point $Q(t)$ of the polynomial curve of the three images; and $Q(t)$ is the image of $Z$, which is not on the
  parabola, so that the two curves are not the same with another parameter
:result: images of R = (0,0) (1,0) (1/2,1/2); image of P(t) = (3/5,1/5); Q(t) = (5/8,1/8); Z = (5/7,1/7)
:method: Both points, exactly, and $Z$ by the inverse map $(x,y)\mapsto(\frac x{1-y},\frac y{1-y})$; with the control, the rational curve whose weights are the values $1+y$ of the points.
:control: the weights $1+y$ for the images
:::
*/
CLAIM(projective_image_is_not_the_curve_of_the_images)
{
    num R[6], images[6], w[3], P[2], Q[2], image[2], one = from_int(1);
    given_points(T, "R", 3, 2, R);
    num t = given(T, "t");
    for (int i = 0; i < 3; i++) {
        num below = add(one, R[2 * i + 1]);
        for (int j = 0; j < dim; j++)
            images[2 * i + j] = div(R[2 * i + j], below);
        w[i] = fault(T, below, one);
    }
    G(bezier_casteljau)(2, dim, R, t, P);
    G(rational_point)(2, dim, images, w, t, Q);
    for (int j = 0; j < dim; j++)
        image[j] = div(P[j], add(one, P[1]));
    found_points(T, "images of R", 3, 2, images);
    found_points(T, "image of P(t)", 1, 2, image);
    found_points(T, "Q(t)", 1, 2, Q);
    num Z[2] = {div(Q[0], sub(one, Q[1])), div(Q[1], sub(one, Q[1]))};
    found_points(T, "Z", 1, 2, Z);
    about(T, "y and the square of (x + y)/2 at Z");
    same(T, Z[1], G(power)(mul(from_ratio(1, 2), add(Z[0], Z[1])), 2));
    about(T, "the coordinates of the curve of the images, and of the image of the curve");
    for (int j = 0; j < dim; j++)
        same(T, Q[j], image[j]);
}
#endif

/*
## What is said of the descriptions that follow

Two more sentences of the source look ahead, to curves that will be met later.  One says that a curve can be given more
freedom without changing its shape, by a higher degree or by division; this is true of every polynomial curve.  The
other praises the convex hull (凸包) and the diminishing of variation (变差减小), and says cautiously that certain curves have
them.

:::{statement} hu-1987:1-2-degree-and-subdivision
:title: Raising the degree and dividing a curve keep its shape
:zh: 升阶与分割不改变形状
:printed: When the shape wanted is not reached by adjusting the parameters of the control points, the power to describe is raised by keeping the
  shape and raising the degree of the curve, or by keeping the shape and dividing the curve.
:reading: bernstein_raised_by_one_degree | the degree of a polynomial curve can be raised, and the shape is kept: the curve is a sum of Bernstein polynomials $B_i^n(t)$ with points
  as factors, and each is a combination of two of degree $n+1$
:reading-with: powers_in_every_degree
:reading: piece_of_a_sum_of_powers_is_one | a polynomial curve can be divided, and the shape is kept
:reading: what the power to describe is, and by how much it is raised: the source does not say, so that nothing is there to be decided
:confirmed-by: triangle_of_powers_consists_of_powers bernstein_sum_of_powers_is_a_power elevation_keeps_bezier_curve split_gives_the_two_parts division_keeps_power_curve
:::

:::{claim} division_keeps_power_curve
:title: The two pieces of a divided curve in powers are the curve, and a further coefficient 0 changes nothing
:zh: 分割保持形状
:given: a curve of degree $n$ in powers of $t$, any parameter $s$ of division, any $u$
:then: its pieces over $[0,s]$ and $[s,1]$ at $u$ are the points $P(su)$ and $P(s+(1-s)u)$; a further coefficient $c_{n+1}=0$
  changes nothing
:method: `power_on_interval` and `power_point` against the sum of powers, everything a variable.
:degrees: 1..6 sampled 10
:over: x# y#: coefficients; s u: parameter value
:control: the second piece at $su$
:::
*/
CLAIM(division_keeps_power_curve)
{
    int n = T->degree;
    num c[(MAX_DEGREE + 2) * dim], piece[(MAX_DEGREE + 1) * dim], P[dim], s = parameter(T, "s"), u = parameter(T, "u");
    num one = from_int(1), places[2] = {mul(s, u), add(s, mul(sub(one, s), u))};
    G(free_points)(T, n, dim, c);
    c[(n + 1) * dim] = c[(n + 1) * dim + 1] = from_int(0);
    for (int half = 0; half < 2; half++) {
        G(power_on_interval)(n, dim, c, half ? s : from_int(0), half ? one : s, piece);
        G(power_point)(n, dim, piece, u, P);
        for (int j = 0; j < dim; j++)
            same(T, P[j], G(power_sum)(n, dim, c, j, places[fault(T, half, 0)]));
    }
    G(power_point)(n + 1, dim, c, u, P);
    for (int j = 0; j < dim; j++)
        same(T, P[j], G(power_sum)(n, dim, c, j, u));
}

/*
:::{claim} piece_of_a_sum_of_powers_is_one
:title: A piece of a polynomial curve is a polynomial curve of no higher degree, in every degree
:zh: 多项式曲线的一段仍为不高于其次数的多项式曲线(任意次数)
:given: $t=a+hu$, any $a$, $h$ and $u$; a sum $S=\sum r_iu^i$ of some terms, one more coefficient $r$ and power $w=u^i$; a coefficient $c$ of the curve
:then: $(S+rw)\,t+c=(St+c)+(ar)\,w+(hr)\,(uw)$, and without a term it is $c$: a polynomial in $u$, multiplied by $t$ and with $c$ added, is one of a degree
  higher by one; so by Horner's rule $P(a+hu)=(\cdots(c_nt+c_{n-1})\,t+\cdots)\,t+c_0$ is a polynomial of degree $n$ or less in $u$, and its points for $0\le u\le1$ are those of
  $P$ from $a$ to $a+h$; a curve that is divided consists of two such pieces
:method: Both sides with everything a variable; by induction over the terms, and over the coefficients of the curve.
:degrees: all
:scope: polynomial curves
:over: S# r# c#: coefficients; a h u: parameter value; w: -
:control: $ar$ in the place of $hr$
:::
*/
CLAIM(piece_of_a_sum_of_powers_is_one)
{
    num a = unknown(T, "a", 0), h = unknown(T, "h", 0), u = unknown(T, "u", 0), t = add(a, mul(h, u));
    num S = unknown(T, "S", 0), r = unknown(T, "r", 0), w = unknown(T, "w", 0), c = unknown(T, "c", 0);
    num before = add(mul(S, t), c), next = mul(fault(T, h, a), r);
    about(T, "one term more");
    same(T, add(mul(add(S, mul(r, w)), t), c), add(before, add(mul(mul(a, r), w), mul(next, mul(u, w)))));
}

/*
:::{statement} hu-1987:1-2-hull-and-variation
:title: Some curves have the convex hull property and diminish variation
:zh: 凸包性与变差减小性
:printed: Certain curves have the property of the closed convex hull and the property of diminishing variation.
:holds-by: bernstein_recurrence recurrence_keeps_sum_sign_ends_and_symmetry linear_factor_adds_a_change_of_sign
  sign_changes_are_counted_one_by_one
:confirmed-by: curve_points_are_convex_combinations blocks_of_coefficients_are_independent

Bézier curves of every degree are such curves: their points, $0\le t\le1$, are averages of the control points, and along a line $ax+by+c=0$
the coefficients are $ax_i+by_i+c$, whose changes of sign are the crossings of the polygon; in space a plane takes the place of the line.  The polynomial whose roots are counted is the value of $ax+by+c$ along
the curve; it is 0 for every $t$ when the curve is on the line.
:::
*/
#include "chapters/judge/claims_off.h"
