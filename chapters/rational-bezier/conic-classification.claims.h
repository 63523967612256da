/*
# Ellipse, parabola or hyperbola (有理二次曲线的分类)

The implicit equation of the rational quadratic tells which conic it is, and the answer is in one number.
*/
#include "exact/record/roots.h"
#include "exact/record/sturm.h"

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"
#include "chapters/rational-bezier/conics.h"

/*
## The implicit equation

:::{statement} wang-ch3:3.5-implicit
:title: Theorem 3.4.1 gives the implicit equation of the curve
:zh: 用定理 3.4.1 将曲线隐式化
:printed: By theorem 3.4.1 the curve (3.1.5) can be made implicit and its class be determined.
:holds-by: implicit_form_is_the_resultant kind_in_any_coordinates directions_at_infinity
:needs: determinant_may_vanish_identically | § 3.1: the affine frame $\{R_1;R_1R_0,R_1R_2\}$ | $R_0$, $R_1$, $R_2$ do not lie on
  a line.
:needs: determinant_needs_the_middle_weight | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | no weight
  is 0: positive ones are not.

For a true triangle and weights different from 0 the determinant is $4\omega_0\omega_2S$, where $S=0$ is no
degenerate conic, and its class is told by the sign of $AC-B^2$.
:::
*/

/* The determinant (3.4.1) of the rational quadratic (R, w) at (x, y). */
static num G(implicit_determinant)(const num R[], const num w[], num x, num y)
{
    num a[3], b[3];
    for (int i = 0; i < 3; i++) {
        num weight = i == 1 ? add(w[1], w[1]) : w[i];
        a[i] = mul(weight, sub(R[2 * i], x));
        b[i] = mul(weight, sub(R[2 * i + 1], y));
    }
    return G(resultant)(2, a, 2, b);
}

/*
:::{claim} implicit_form_is_the_resultant
:title: The implicit form of a rational quadratic is the resultant
:zh: 隐式方程即结式
:given: points $R_0,R_1,R_2$ with coordinates $(x_i,y_i)$, weights $\omega_i$, and a point $(x,y)$
:let: $a_i=\binom2i\omega_i(x_i-x)$ and $b_i=\binom2i\omega_i(y_i-y)$, as in (3.4.2)
:then: the determinant of (3.4.1) for $n=2$ is $4\omega_0\omega_2S(x,y)$ with the kernel's conic $S$ of the curve
:method: Sylvester's determinant of the two polynomials on one side, the conic from three lines on the other; all
  eleven numbers are variables.
:defines: conic_of_bezier
:control: 2 for 4
:::
*/
CLAIM(implicit_form_is_the_resultant)
{
    num R[6], w[3], S[6], x = unknown(T, "x", 0), y = unknown(T, "y", 0);
    G(six)(T, "R", R);
    G(three_weights)(T, w);
    G(conic_of_bezier)(R, w, S);
    num factor = mul(from_int(fault(T, 4, 2)), mul(w[0], w[2]));
    /* the determinant (3.4.1) is 4 ω_0 ω_2 S(x, y) */
    same(T, G(implicit_determinant)(R, w, x, y), mul(factor, G(form)(S, x, y)));
}

#if RATIONAL
/* For the data R, ω and P of the claim: refutes that the determinant (3.4.1) is a conic that is not degenerate. */
static void equation_expected(trial *T)
{
    num R[6], w[3], P[2], S[6];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    given_points(T, "P", 1, 2, P);
    G(conic_of_bezier)(R, w, S);
    found_points(T, "A, …, F", 6, 1, S);
    found(T, "determinant at P", G(implicit_determinant)(R, w, P[0], P[1]));
    about(T, "whether the conic is not degenerate");
    refute(T, is_zero_q(G(conic_determinant)(S)));
}

/*
:::{claim} determinant_may_vanish_identically
:title: With points on a line the determinant may vanish everywhere
:zh: 三点共线时行列式可恒为零
:kind: counterexample
:data: R = (-1,0) (0,0) (1,0); ω = 1 1 1; P = (0,2)
:instead: R = (-1,0) (0,1) (1,0)
:result: A, …, F = 0 0 0 0 0 0; determinant at P = 0
:given: three points $R$ of a line, equal weights, and a point $P$ off the line
:then: all six coefficients of the conic are 0: the determinant is no equation
:method: The conic, by its definition the determinant up to a factor, is computed, and the determinant at $P$.
:control: $R_1$ moved off the line
:::
*/
CLAIM(determinant_may_vanish_identically) { equation_expected(T); }

/*
:::{claim} determinant_needs_the_middle_weight
:title: With the middle weight 0 the determinant is that of a line
:zh: ω_1=0 时得到直线
:kind: counterexample
:data: R = (-1,0) (0,1) (1,0); ω = 1 0 1; P = (0,2)
:instead: ω = 1 1 1
:result: A, …, F = 0 0 1 0 0 0; determinant at P = 16
:given: the points $R$ of a triangle, the weights $\omega$ with $\omega_1=0$, and a point $P$ off the base
:then: the conic is $y^2=0$
:method: The conic, by its definition the determinant up to a factor, is computed, and the determinant at $P$.
:control: equal weights
:::
*/
CLAIM(determinant_needs_the_middle_weight) { equation_expected(T); }
#endif

/*
In special coordinates the determinant is short enough to be written out, and the source does so.  To test a display
of this kind one puts in a point at which most entries vanish; the origin shows that the determinant and the
polynomial behind the sign of equality are not the same, though both are 0 on the same curve.

:::{statement} wang-ch3:3.5.3
:title: The determinant of the curve in standard form
:zh: 标准形的隐式行列式
:printed: $\begin{vmatrix}-l-x&2\omega(x_1-x)&l-x&0\\0&-l-x&2\omega(x_1-x)&l-x\\-y&2\omega(y_1-y)&-y&0\\
  0&-y&2\omega(y_1-y)&-y\end{vmatrix}=Ax^2+2Bxy+Cy^2+2Dx+2Ey+F=0$ with the coefficients (3.5.4)
:reading: determinant_is_four_times_the_form | An equation for $(x,y)$, as the 0 at its end and its use suggest;
  the determinant is 0 exactly where the polynomial is.
:reading: determinant_is_not_the_printed_form | The first sign of equality by itself, for all $(x,y)$: a factor 4 is
  missing.
:corrected: the determinant is $4(Ax^2+2Bxy+Cy^2+2Dx+2Ey+F)=0$ with the coefficients (3.5.4)
:corrected-by: determinant_is_four_times_the_form
:figure: determinant_factor

In the text at hand the second and the fourth row stand below the first and the third without a shift, and the zeros are lost; the rows are those of (3.4.1).
:::
*/

/* The special position: R = (-l, 0, x_1, y_1, l, 0) and w = (1, omega, 1). */
static void G(special_position)(num l, num x1, num y1, num omega, num R[], num w[])
{
    R[0] = neg(l);
    R[1] = R[5] = from_int(0);
    R[2] = x1;
    R[3] = y1;
    R[4] = l;
    w[0] = w[2] = from_int(1);
    w[1] = omega;
}

/* The coefficients (3.5.4). */
static void G(printed_form)(num l, num x1, num y1, num omega, num S[])
{
    num oo = mul(omega, omega), ll = mul(l, l), yy = mul(y1, y1);
    S[0] = mul(oo, yy);
    S[1] = neg(mul(oo, mul(x1, y1)));
    S[2] = add(mul(oo, sub(mul(x1, x1), ll)), ll);
    S[3] = from_int(0);
    S[4] = mul(oo, mul(ll, y1));
    S[5] = neg(mul(oo, mul(ll, yy)));
}

/*
:::{claim} determinant_is_four_times_the_form
:title: In special coordinates the determinant is four times the printed form
:zh: 特殊坐标系下行列式等于所印多项式的四倍
:given: $R_0=(-l,0)$, $R_1=(x_1,y_1)$, $R_2=(l,0)$, the weights $1,\omega,1$, and a point $(x,y)$
:then: the determinant is $4(Ax^2+2Bxy+Cy^2+2Dx+2Ey+F)$ with the coefficients (3.5.4)
:method: An identity in $l$, $x_1$, $y_1$, $\omega$, $x$, $y$.
:over: l
:control: $C$ without its last term $l^2$
:::
*/
CLAIM(determinant_is_four_times_the_form)
{
    num l = positive(T, "l", 0), x1 = unknown(T, "x", 1), y1 = unknown(T, "y", 1), omega = positive(T, "w", 1);
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), R[6], w[3], S[6];
    G(special_position)(l, x1, y1, omega, R, w);
    G(printed_form)(l, x1, y1, omega, S);
    S[2] = fault(T, S[2], sub(S[2], mul(l, l)));
    /* the determinant is 4 (A x² + 2B xy + C y² + 2D x + 2E y + F) */
    same(T, G(implicit_determinant)(R, w, x, y), mul(from_int(4), G(form)(S, x, y)));
}

#if RATIONAL
/*
:::{claim} determinant_is_not_the_printed_form
:title: The determinant is not the printed polynomial
:zh: 行列式不等于所印多项式
:kind: counterexample
:data: l = 1; R_1 = (0,1); ω = 1; P = (0,0); factor = 4
:result: A, …, F = 1 0 0 0 1 -1; determinant at P = -4; polynomial at P = -1
:given: $l$, $R_1$ and $\omega$ of a curve in special position, and a point $P$
:then: the determinant at $P$ is the factor times the polynomial with the coefficients (3.5.4), and not the polynomial
:method: Both are computed.
:control: the polynomial multiplied by the factor
:::
*/
CLAIM(determinant_is_not_the_printed_form)
{
    num vertex[2], P[2], R[6], w[3], S[6];
    num l = given(T, "l");
    given_points(T, "R_1", 1, 2, vertex);
    num omega = given(T, "ω");
    given_points(T, "P", 1, 2, P);
    num factor = given(T, "factor");
    G(special_position)(l, vertex[0], vertex[1], omega, R, w);
    G(printed_form)(l, vertex[0], vertex[1], omega, S);
    num determinant = G(implicit_determinant)(R, w, P[0], P[1]), polynomial = G(form)(S, P[0], P[1]);
    found_points(T, "A, …, F", 6, 1, S);
    found(T, "determinant at P", determinant);
    found(T, "polynomial at P", polynomial);
    about(T, "at P, left the determinant, right the polynomial");
    same(T, determinant, fault(T, mul(factor, polynomial), polynomial));
}
#endif

/*
:::{statement} wang-ch3:3.5.4
:title: The coefficients of the conic
:zh: 二次曲线的系数
:printed: (A,B,C,D,E,F)=(\omega^2y_1^2,\ -\omega^2x_1y_1,\ \omega^2(x_1^2-l^2)+l^2,\ 0,\ \omega^2l^2y_1,\ -\omega^2l^2y_1^2)
:holds-by: printed_coefficients_are_the_conic_of_the_curve
:confirmed-by: determinant_is_four_times_the_form

The determinant of (3.5.3) has four times these coefficients; the equation is the same.
:::

:::{claim} printed_coefficients_are_the_conic_of_the_curve
:title: The printed coefficients are those of the conic of the curve
:zh: 所印系数正确
:given: the triangle in special position, the weights $1,\omega,1$, and a parameter $u$
:then: $S(R^*(u))=0$ for the coefficients (3.5.4), and these are what the three lines of the triangle give
:method: The homogeneous coordinates $X,Y,W$ of the point of the curve are put into $AX^2+2BXY+CY^2+2DXW+2EYW+FW^2$, so that nothing is divided; and the six coefficients are
  compared with the kernel's, whose definition is the resultant.
:over: l
:control: $D=\omega^2l^2x_1$ for $D=0$
:::
*/
/* A X² + 2B XY + C Y² + 2D XW + 2E YW + F W² at the point X : Y : W of the parameter t of the curve (R, w). */
static num G(form_along)(const num S[], const num R[], const num w[], num t)
{
    num H[9], P[3];
    G(rational_homogenize)(2, 2, R, w, H);
    G(bezier_casteljau)(2, 3, H, t, P);
    num X = P[0], Y = P[1], W = P[2];
    num squares = add(add(mul(S[0], mul(X, X)), mul(S[2], mul(Y, Y))), mul(S[5], mul(W, W)));
    num products = add(add(mul(S[1], mul(X, Y)), mul(S[3], mul(X, W))), mul(S[4], mul(Y, W)));
    return add(squares, mul(from_int(2), products));
}

CLAIM(printed_coefficients_are_the_conic_of_the_curve)
{
    num l = positive(T, "l", 0), x1 = unknown(T, "x", 1), y1 = unknown(T, "y", 1), omega = positive(T, "w", 1);
    num u = parameter(T, "u"), R[6], w[3], S[6], K[6];
    G(special_position)(l, x1, y1, omega, R, w);
    G(printed_form)(l, x1, y1, omega, S);
    S[3] = fault(T, S[3], mul(mul(omega, omega), mul(mul(l, l), x1)));
    about(T, "the form along the curve");
    vanishes(T, G(form_along)(S, R, w, u));
    G(conic_of_bezier)(R, w, K);
    about(T, "the coefficients");
    for (int k = 0; k < 6; k++)
        same(T, S[k], K[k]);
}

/*
## The classification

For the kind of a conic that has real points and is not degenerate only the quadratic part $Ax^2+2Bxy+Cy^2$ counts:
the directions in which it vanishes are those in which the conic goes to infinity, and $AC-B^2$ says how many there
are.  The weights enter this number by the sign of $1-\omega^2$.

:::{statement} wang-ch3:3.5-discriminant
:title: The discriminant in special coordinates
:zh: 判别式
:printed: AC-B^2=\omega^2l^2y_1^2(1-\omega^2)
:holds-by: discriminant_in_special_coordinates
:::

:::{claim} discriminant_in_special_coordinates
:title: The two determinants of the conic in special coordinates
:zh: 特殊坐标系下的两个判别式
:given: the coefficients (3.5.4) for any $l$, $x_1$, $y_1$, $\omega$
:then: $AC-B^2=\omega^2l^2y_1^2(1-\omega^2)$, and the $3\times3$ determinant is $-\omega^4l^4y_1^4$
:method: Identities in the four variables.
:over: l
:control: $1-\omega$ for $1-\omega^2$
:::
*/
CLAIM(discriminant_in_special_coordinates)
{
    num l = positive(T, "l", 0), x1 = unknown(T, "x", 1), y1 = unknown(T, "y", 1), omega = positive(T, "w", 1), S[6];
    G(printed_form)(l, x1, y1, omega, S);
    num oo = mul(omega, omega), product = mul(oo, mul(mul(l, l), mul(y1, y1)));
    about(T, "AC - B²");
    /* AC - B² = ω² l² y_1² (1 - ω²) */
    same(T, sub(mul(S[0], S[2]), mul(S[1], S[1])), mul(product, sub(from_int(1), fault(T, oo, omega))));
    about(T, "the determinant of the conic");
    /* the 3×3 determinant is -ω⁴ l⁴ y_1⁴ */
    num matrix[9] = {S[0], S[1], S[3], S[1], S[2], S[4], S[3], S[4], S[5]};
    same(T, G(determinant)(3, matrix), neg(mul(product, product)));
}

/*
:::{statement} wang-ch3:3.5-classification-omega
:title: Classification by the standard weight
:zh: 按 ω 分类
:printed: By what is known from analytic geometry the curve (3.1.5) is an ellipse, a parabola or a hyperbola for $\omega<1$, $\omega=1$ or
  $\omega>1$.
:holds-by: standard_form_by_a_change_of_parameter printed_coefficients_are_the_conic_of_the_curve sign_of_the_discriminant
  discriminant_in_special_coordinates directions_at_infinity
:needs: flat_triangle_is_no_conic | § 3.1: the affine frame $\{R_1;R_1R_0,R_1R_2\}$ | $R_0$, $R_1$, $R_2$ do not lie on a line:
  $l\ne0$, $y_1\ne0$.
:needs: weight_minus_one_is_a_parabola | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\omega>-1$: so it is for
  positive weights; for $\omega=-1$, as in the example, the denominator is 0 at $u=\frac12$.
:needs: weight_zero_is_a_segment | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\omega\ne0$: so it is for
  positive weights.
:meant: theorem 3.5.2, whose circular arcs have $I_1<1$ | A circle is an ellipse.
:figure: classification_by_weight

$\omega^2$ is the invariant $I_1$, and $\omega>0$.  With a weight $\omega$ of any sign it is $\omega^2$ that is compared with 1, for $\omega\ne0$.
:::

:::{claim} directions_at_infinity
:title: The discriminant counts the directions at infinity
:zh: 判别式决定无穷远方向的个数
:given: a conic $S$ and a direction $(p,q)$
:let: $f=Ap^2+2Bpq+Cq^2$, which is 0 for the directions in which the conic goes to infinity
:then: $Af=(Ap+Bq)^2+(AC-B^2)q^2$: with $A\ne0$ no direction for $AC-B^2>0$, one, $Ap+Bq=0$, for $AC-B^2=0$, and for
  $AC-B^2=-e^2$ the two of $Af=(Ap+Bq-eq)(Ap+Bq+eq)$; with $A=0$ it is $f=q\,(2Bp+Cq)$: two directions for
  $AC-B^2=-B^2<0$, and for $B=0$ the one $q=0$
:method: Identities in $A$, $B$, $p$, $q$ and $C$ or $e$.  Of the conics with real points that are not degenerate, the
  ellipses, parabolas and hyperbolas are those with no, one and two directions.
:over: A; B; C; e; p; q
:control: $B$ for $2B$ in $f$
:::
*/
CLAIM(directions_at_infinity)
{
    num A = unknown(T, "A", 0), B = unknown(T, "B", 0), C = unknown(T, "C", 0), p = unknown(T, "p", 0);
    num q = unknown(T, "q", 0), e = unknown(T, "e", 0), S[6], zero = from_int(0);
    for (int k = 0; k < 2; k++) {
        if (k == 1) /* AC - B^2 = -e^2 */
            C = div(sub(mul(B, B), mul(e, e)), A);
        S[0] = A, S[1] = fault(T, B, mul(from_ratio(1, 2), B)), S[2] = C, S[3] = S[4] = S[5] = zero;
        num left = mul(A, G(form)(S, p, q)), sum = add(mul(A, p), mul(B, q)), qq = mul(q, q), eq = mul(e, q);
        if (k == 0)
            /* A f = (A p + B q)² + (AC - B²) q² */
            same(T, left, add(mul(sum, sum), mul(sub(mul(A, C), mul(B, B)), qq)));
        else
            /* A f = (A p + B q - e q)(A p + B q + e q) */
            same(T, left, mul(sub(sum, eq), add(sum, eq)));
    }
    /* with A = 0: f = q (2 B p + C q) */
    C = unknown(T, "C", 0);
    S[0] = zero, S[1] = fault(T, B, mul(from_ratio(1, 2), B)), S[2] = C;
    same(T, G(form)(S, p, q), mul(q, add(mul(from_int(2), mul(B, p)), mul(C, q))));
}

/*
:::{claim} sign_of_the_discriminant
:title: The sign of the discriminant for I1 below, at and above 1
:zh: I_1 与判别式的符号
:given: a true triangle, positive weights with $I_1=\frac1{1+s}$, $I_1=1$ or $I_1=1+s$, $s>0$
:let: $d$ be twice the area of the triangle
:then: $\frac{4(AC-B^2)}{\omega_1^4d^2}$ is $s>0$, 0, or $\frac{-s}{1+s}<0$
:method: $\omega_0$, $\omega_1$ and $s$ are variables and $\omega_2$ follows from $I_1$, which is the kernel's invariant of
  the weights; every value of $I_1$ below or above 1 has one $s$.
:scope: every $I_1>0$
:where: $R_0$, $R_1$, $R_2$ do not lie on a line; the weights are positive
:over: s: -
:control: $I_1$ upside down
:::
*/
CLAIM(sign_of_the_discriminant)
{
    num R[6], w[3], S[6], I[1], s = positive(T, "s", 0), one = from_int(1), more = add(one, s), half = from_ratio(1, 2);
    G(six)(T, "R", R);
    w[0] = positive(T, "w", 0);
    w[1] = positive(T, "w", 1);
    num ww = mul(w[1], w[1]), d = G(area)(R + 2, R, R + 4), area = mul(half, d);
    const num invariant[3] = {div(one, more), one, more}, expected[3] = {s, from_int(0), neg(div(s, more))};
    for (int k = 0; k < 3; k++) {
        w[2] = div(ww, mul(w[0], fault(T, invariant[k], div(one, invariant[k]))));
        G(rational_invariants)(2, w, I);
        about(T, "I_1");
        same(T, I[0], invariant[k]);
        G(conic_of_bezier)(R, w, S);
        about(T, "4 (AC - B²)/(ω_1⁴ d²)");
        same(T, G(conic_delta)(S), mul(expected[k], mul(mul(ww, ww), mul(area, area))));
    }
    about(T, "the signs");
    G(must_be_positive)(T, expected[0]);
    G(must_be_positive)(T, neg(expected[2]));
}

#if RATIONAL
/* For the data R and ω of the claim: whether the curve is an ellipse, as ω < 1 would have it, AC - B² > 0 and the conic not
 * degenerate. */
static void ellipse_expected(trial *T)
{
    num R[6], w[3], S[6], I[1];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    G(conic_of_bezier)(R, w, S);
    G(rational_invariants)(2, w, I);
    found(T, "I_1", I[0]);
    found_points(T, "A, …, F", 6, 1, S);
    found(T, "AC-B²", G(conic_delta)(S));
    found(T, "3×3 determinant", G(conic_determinant)(S));
    about(T, "whether the conic is an ellipse");
    agree(T, sign_q(G(conic_delta)(S)) > 0 && !is_zero_q(G(conic_determinant)(S)));
}

/*
:::{claim} flat_triangle_is_no_conic
:title: With three points on a line the conic is degenerate
:zh: 三点共线时二次曲线退化
:kind: counterexample
:data: R = (-1,0) (0,0) (1,0); ω = 1 1/2 1
:instead: R = (-1,0) (0,1) (1,0)
:result: I_1 = 1/4; A, …, F = 0 0 3/4 0 0 0; AC-B² = 0; 3×3 determinant = 0
:given: three points $R$ of a line, and standard weights with $0<\omega_1<1$
:then: $I_1<1$, but the conic is $y^2=0$ counted with a factor: $AC-B^2=0$, and the determinant of its matrix is 0
:method: The conic of the curve is computed.
:control: $R_1$ moved off the line
:::
*/
CLAIM(flat_triangle_is_no_conic) { ellipse_expected(T); }

/*
:::{claim} weight_minus_one_is_a_parabola
:title: The weight -1 gives a parabola although it is less than 1
:zh: ω=-1 时为抛物线
:kind: counterexample
:data: R = (-1,0) (0,1) (1,0); ω = 1 -1 1
:instead: ω = 1 -1/2 1
:result: I_1 = 1; A, …, F = 1 0 0 0 1 -1; AC-B² = 0; 3×3 determinant = -1
:given: the points $R$ of a triangle, and the weights with $\omega_1=-1$
:then: $\omega_1<1$, but $AC-B^2=0$: the conic $x^2+2y-1=0$ is a parabola
:method: The conic of the curve is computed.
:control: $-1<\omega_1<0$, which gives an ellipse
:::
*/
CLAIM(weight_minus_one_is_a_parabola) { ellipse_expected(T); }

/*
:::{claim} weight_zero_is_a_segment
:title: With the middle weight 0 the conic is degenerate
:zh: ω_1=0 时二次曲线退化
:kind: counterexample
:data: R = (-1,0) (0,1) (1,0); ω = 1 0 1
:instead: ω = 1 1/2 1
:result: I_1 = 0; A, …, F = 0 0 1 0 0 0; AC-B² = 0; 3×3 determinant = 0
:given: the points $R$ of a triangle, and the weights with $\omega_1=0$
:then: $I_1<1$, but the conic is $y^2=0$
:method: The conic of the curve is computed.
:control: a positive middle weight
:::
*/
CLAIM(weight_zero_is_a_segment) { ellipse_expected(T); }
#endif

/*
The theorem says the same by the invariant, so that the weights need not be brought to standard form first.  Each of
its hypotheses is needed, and an example without it stands beside.

:::{statement} wang-ch3:thm-3.5.1
:title: Classification of rational quadratic curves
:zh: 定理 3.5.1：有理二次曲线的分类
:printed: The class of the rational quadratic Bézier curve (3.1.5) depends on the invariant
  $I_1=\frac{\omega_1^2}{\omega_0\omega_2}$ of definition 3.2.2: it is an ellipse, a parabola or a hyperbola for $I_1<1$,
  $I_1=1$ or $I_1>1$.
:holds-by: sign_of_the_discriminant kind_in_any_coordinates directions_at_infinity
:confirmed-by: points_at_infinity_tell_the_kind
:needs: flat_triangle_is_no_conic | § 3.1: the affine frame $\{R_1;R_1R_0,R_1R_2\}$ | $R_0$, $R_1$, $R_2$ do not lie on a line.
:needs: opposite_weights_are_a_hyperbola | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ |
  $\omega_0\omega_2>0$: so it is for positive weights; for $\omega_0\omega_2<0$, as in the example, the denominator is 0 between the ends.
:needs: weight_zero_is_a_segment | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\omega_1\ne0$: so it is for
  positive weights.
:meant: theorem 3.5.2, whose circular arcs have $I_1<1$ | A circle is an ellipse.
:figure: classification_by_weight

In any coordinates the sign of $AC-B^2$ is that of $\omega_0\omega_2-\omega_1^2$, for either sign of $\omega_1\ne0$.
:::

:::{claim} kind_in_any_coordinates
:title: The two determinants of the conic for any triangle and weights
:zh: 任意坐标下的判别式
:given: points $R_0,R_1,R_2$, weights $\omega_0,\omega_1,\omega_2$, any $t$
:where: $R_0$, $R_1$, $R_2$ do not lie on a line; no weight is 0
:let: $d=(R_0-R_1)\times(R_2-R_1)$, twice the area of the triangle up to sign; $S$ be the kernel's conic of the curve
:then: $S(R(t))=0$; $S$ has $AC-B^2=\omega_1^2(\omega_0\omega_2-\omega_1^2)\frac{d^2}4$, and its $3\times3$
  determinant is $-\omega_0\omega_2\omega_1^4\frac{d^4}{16}$, which is not 0 for a true triangle and weights different
  from 0
:method: Identities in the six coordinates, the weights and $t$; the first by the homogeneous coordinates of the point.  The conic has real points, those of the curve, and is not
  degenerate; so by `directions_at_infinity` it is an ellipse, a parabola or a hyperbola when $AC-B^2$ is positive,
  zero or negative.
:over: t: -
:control: $\omega_1$ for $\omega_1^2$ in the difference
:::
*/
CLAIM(kind_in_any_coordinates)
{
    num R[6], w[3], S[6];
    G(six)(T, "R", R);
    G(three_weights)(T, w);
    G(conic_of_bezier)(R, w, S);
    num half = mul(from_ratio(1, 2), G(area)(R + 2, R, R + 4)), hh = mul(half, half), outer = mul(w[0], w[2]);
    num ww = mul(w[1], w[1]), difference = sub(outer, fault(T, ww, w[1]));
    about(T, "S along the curve");
    vanishes(T, G(form_along)(S, R, w, parameter(T, "t")));
    about(T, "AC - B²");
    /* AC - B² = ω_1² (ω_0 ω_2 - ω_1²) d²/4 */
    same(T, G(conic_delta)(S), mul(mul(ww, difference), hh));
    about(T, "the determinant of the conic");
    /* the 3×3 determinant is -ω_0 ω_2 ω_1⁴ d⁴/16 */
    same(T, G(conic_determinant)(S), neg(mul(outer, mul(mul(ww, ww), mul(hh, hh)))));
}

#if RATIONAL
/*
:::{claim} points_at_infinity_tell_the_kind
:title: The class agrees with the number of points at infinity
:zh: 分类与无穷远点个数一致
:kind: decision
:data: R = (1,0) (0,0) (0,1); largest weight = 8
:result: ellipses, parabolas, hyperbolas = 224 12 276
:given: the points $R$ of a triangle and all triples of weights that are whole numbers from 1 to the largest weight
:then: the denominator has no, one (double) or two real zeros on the projective line of the parameter exactly when
  $I_1<1$, $I_1=1$ or $I_1>1$, and exactly when $AC-B^2$ of the conic is positive, zero or negative
:method: An ellipse, parabola or hyperbola has no, one or two real points at infinity; on the curve they are the zeros of
  the denominator $\omega(t)$, $t=\infty$ among them when its degree drops.  The zeros are counted by Descartes' rule
  and, independently, by Sturm's theorem.
:scope: weights 1 to 8
:control: the zero at $t=\infty$ left out
:::
*/
CLAIM(points_at_infinity_tell_the_kind)
{
    num R[6], S[6], one = from_int(1), many[3];
    given_points(T, "R", 3, 2, R);
    int most = given_whole(T, "largest weight"), of_kind[3] = {0, 0, 0};
    for (int k = 0; k < most * most * most; k++) {
        num w[3] = {from_int(k / (most * most) + 1), from_int(k / most % most + 1), from_int(k % most + 1)}, I[1];
        poly bottom = poly_from_bernstein(2, w);
        int at_infinity = fault(T, poly_degree(bottom) < 2, 0), finite = 0;
        if (poly_degree(bottom) > 0)
            finite = count_roots_line(bottom).distinct;
        agree(T, poly_degree(bottom) <= 0 || finite == sturm_count_line(bottom));
        G(rational_invariants)(2, w, I);
        G(conic_of_bezier)(R, w, S);
        int kind = finite + at_infinity - 1, side = compare_q(I[0], one);
        side = (side > 0) - (side < 0);
        of_kind[side + 1]++;
        if (T->outcome == HOLDS && (kind != side || kind != -sign_q(G(conic_delta)(S))))
            show_points(T, "ω", 3, 1, w);
        about(T, "the number of points at infinity less 1, and the signs of I_1 - 1 and B² - AC");
        agree(T, kind == side);
        agree(T, kind == -sign_q(G(conic_delta)(S)));
    }
    for (int k = 0; k < 3; k++)
        many[k] = from_int(of_kind[k]);
    found_points(T, "ellipses, parabolas, hyperbolas", 3, 1, many);
}

/*
:::{claim} opposite_weights_are_a_hyperbola
:title: With outer weights of opposite signs the curve is a hyperbola
:zh: ω_0 ω_2<0 时为双曲线
:kind: counterexample
:data: R = (1,0) (0,0) (0,1); ω = 1 1 -1
:instead: ω = 1 1 2
:result: I_1 = -1; AC-B² = -1/2
:given: the points $R$ of a triangle, and weights whose outer ones have opposite signs
:then: $I_1<1$, but $AC-B^2<0$
:method: The conic of the curve is computed.
:control: positive weights with $I_1<1$
:::
*/
CLAIM(opposite_weights_are_a_hyperbola)
{
    num R[6], w[3], S[6], I[1];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    G(conic_of_bezier)(R, w, S);
    G(rational_invariants)(2, w, I);
    found(T, "I_1", I[0]);
    found(T, "AC-B²", G(conic_delta)(S));
    about(T, "whether AC - B² is positive, as for an ellipse");
    refute(T, compare_q(I[0], from_int(1)) < 0 && sign_q(G(conic_delta)(S)) <= 0);
}
#endif

#include "chapters/judge/claims_off.h"
