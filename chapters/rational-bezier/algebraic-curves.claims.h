/*
# Algebraic curves (代数曲线)

A plane algebraic curve is what a polynomial equation $F(x,y)=0$ describes.  With the implicit equation every
rational curve has become one.  Before the converse can be asked, it has to be said what the degree of such a curve is: of
the printed definition the words and the formula disagree.
*/
#include "exact/record/resultant.h"

#include "chapters/judge/claims_on.h"
#include "chapters/rational-bezier/plane-polynomials.h"

/*
:::{statement} wang-ch3:def-3.4.1
:title: A plane algebraic curve of degree n
:zh: 平面 n 次代数曲线的定义
:printed: Let $\alpha_{ij}$ be constants; the plane curve whose points $(x,y)$ satisfy the algebraic equation of degree $n$
  $F(x,y)=\sum_{i,j=0}^n\alpha_{ij}x^iy^j=0$ is called a plane algebraic curve of degree $n$.
:class: misprint
:refuted-by: hyperbola_has_the_printed_form_for_degree_one
:corrected: F(x,y)=\sum_{i+j\le n}\alpha_{ij}x^iy^j=0,\quad\text{some }\alpha_{ij}\ne0\text{ with }i+j=n
:corrected-by: highest_terms_go_along_with_an_affine_map
:confirmed-by: total_degree_survives_affine_maps
:reading: highest_terms_go_along_with_an_affine_map | by the words, an equation of degree $n$, in the usual sense: then it is right, and the sum only says
  that the terms are among these
:reading: hyperbola_has_the_printed_form_for_degree_one | by the sum, an equation of this form
:meant: the words, equation of degree $n$, and theorem 3.4.2 | The total degree.
:figure: degree_of_a_hyperbola

The printed words and the printed sum disagree: the sum has terms up to $x^ny^n$, of degree $2n$, and an equation of this form need not be of degree $n$.  The words, which have their usual meaning,
decide; the degree of theorem 3.4.2 is the total degree, and every polynomial of total degree $n$ is such a sum.  Taken by the
sum alone the hyperbola of the example would have degree 1 in one system of coordinates and not in another.
:::
*/

#if FIELD
/*
:::{claim} hyperbola_has_the_printed_form_for_degree_one
:title: The hyperbola xy = 1 is of the form printed for n = 1
:zh: xy=1 符合所印一次形式
:kind: counterexample
:types: field
:data: α, i, j = (1,1,1) (-1,0,0)
:instead: α, i, j = (1,1,0) (-1,0,0)
:result: F = "x*y-1"; degrees in x, y = 1 1; F(p+q, p-q) = "p^2-q^2-1"; degree = 2
:given: the hyperbola $F=0$ by its terms $\alpha x^iy^j$, of the printed form with $n=1$: no exponent is above 1
:then: its degree is 2; in the coordinates $p$, $q$ with $x=p+q$, $y=p-q$ it is not even of the printed form with $n=1$
:method: The degree in $s$ of $F(sx,sy)$ is compared with $n=1$.
:control: a line
:::
*/
CLAIM(hyperbola_has_the_printed_form_for_degree_one)
{
    num x = variable_f("x"), y = variable_f("y"), p = variable_f("p"), q = variable_f("q");
    num F = given_polynomial(T, "α, i, j", 2), degrees[2] = {from_int(degree_f(F, x)), from_int(degree_f(F, y))};
    int degree = total_degree(F, x, y);
    found_text(T, "F", to_string_f(F));
    found_points(T, "degrees in x, y", 2, 1, degrees);
    found_text(T, "F(p+q, p-q)", to_string_f(substitute_f(substitute_f(F, x, add(p, q)), y, sub(p, q))));
    found_whole(T, "degree", degree);
    about(T, "F of the printed form with n = 1 has degree at most 1");
    if (degree_f(F, x) <= 1 && degree_f(F, y) <= 1)
        agree(T, degree <= 1);
}

#endif

/*
:::{claim} highest_terms_go_along_with_an_affine_map
:title: The highest terms of a polynomial go along with an affine map, and do not vanish, in every degree
:zh: 仿射变换下最高次项仍为最高次项(任意次数)
:given: a polynomial $S^dp+q$ in a letter $S$ that counts the degree, $q$ of a degree less than $d$ in it, so that $p$ is the part of highest degree; one more factor $S(a_0x+b_0y)+e_0$; an affine map
  $u=a_0x+b_0y+e_0$, $v=a_1x+b_1y+e_1$, $D=a_0b_1-a_1b_0\ne0$
:where: the map is invertible
:then: the product has the part $p\,(a_0x+b_0y)$ of degree $d+1$, and the rest is of lower degree; and $x=\frac{b_1(u-e_0)-b_0(v-e_1)}D$, $y=\frac{a_0(v-e_1)-a_1(u-e_0)}D$
:method: The first is the step of an induction on the factors: the image of $x^iy^j$ has the highest part $(a_0x+b_0y)^i(a_1x+b_1y)^j$, of degree $i+j$.  So the sum of the terms with $i+j=n$, $f_n(x,y)$, has
  the image $f_n(a_0x+b_0y,a_1x+b_1y)$, and all other terms are of lower degree.  The second is the inverse map; it takes that image back to $f_n\ne0$, so it is not 0.
:degrees: all
:over: S U p q x y: -; a# b# e#: affine maps
:control: $b_0$ and $b_1$ exchanged in the inverse
:::
*/
CLAIM(highest_terms_go_along_with_an_affine_map)
{
    num S = positive(T, "S", 0), U = positive(T, "U", 0), p = unknown(T, "p", 0), q = unknown(T, "q", 0); /* U = S^d */
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), a[2], b[2], e[2], image[2];
    for (int k = 0; k < 2; k++) {
        a[k] = unknown(T, "a", k);
        b[k] = unknown(T, "b", k);
        e[k] = unknown(T, "e", k);
        image[k] = add(add(mul(a[k], x), mul(b[k], y)), e[k]);
    }
    num line = add(mul(a[0], x), mul(b[0], y));
    about(T, "one more factor");
    num top = mul(mul(U, S), mul(p, line)), rest = add(mul(mul(U, p), e[0]), add(mul(mul(S, q), line), mul(q, e[0])));
    same(T, mul(add(mul(U, p), q), add(mul(S, line), e[0])), add(top, rest));
    about(T, "the inverse map");
    num D = sub(mul(a[0], b[1]), mul(a[1], b[0])), u = sub(image[0], e[0]), v = sub(image[1], e[1]);
    num first = fault(T, b[1], b[0]), second = fault(T, b[0], b[1]);
    same(T, sub(mul(first, u), mul(second, v)), mul(D, x));
    same(T, sub(mul(a[0], v), mul(a[1], u)), mul(D, y));
}

#if FIELD
/*
For low degrees, with the general polynomial:

:::{claim} total_degree_survives_affine_maps
:title: The total degree does not depend on the affine coordinates
:zh: 总次数是仿射不变的
:kind: decision
:types: field
:given: the general polynomial of total degree $n$ with variable coefficients, and the general affine map
:then: after the map its total degree is again $n$
:method: The degree in $s$ of $F(sx,sy)$ before and after $x\mapsto a_0x+b_0y+e_0$, $y\mapsto a_1x+b_1y+e_1$, with all
  coefficients variables.  So it never grows; that it does not fall for an invertible map follows by the inverse map.
:degrees: 1..3
:argued: every n | A term $x^iy^j$ becomes a product of $i+j$ factors of degree at most 1; so the degree never grows,
  and with the inverse map it cannot fall.
:control: the sum taken over $i,j\le n$
:::
*/
CLAIM(total_degree_survives_affine_maps)
{
    int n = T->degree, m = 0;
    num x = variable_f("x"), y = variable_f("y"), F = from_int(0), image = from_int(0), u[2];
    for (int k = 0; k < 2; k++)
        u[k] = add(add(mul(unknown(T, "a", k), x), mul(unknown(T, "b", k), y)), unknown(T, "e", k));
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= fault(T, n - i, n); j++) {
            num before = unknown(T, "c", m++), after = before;
            for (int k = 0; k < i; k++) {
                before = mul(before, x);
                after = mul(after, u[0]);
            }
            for (int k = 0; k < j; k++) {
                before = mul(before, y);
                after = mul(after, u[1]);
            }
            F = add(F, before);
            image = add(image, after);
        }
    about(T, "the degree before and after the map");
    agree(T, total_degree(F, x, y) == n && total_degree(image, x, y) == n);
}

/*
With the total degree the passage from rational to algebraic curves can be stated.  Theorem 3.4.2 gives an upper bound
for the degree of $F$, and two things may make the degree of the curve less: $F$ may be 0, or $F$ may be a power of
the equation.

:::{statement} wang-ch3:sec-3.4.2-algebraic
:title: A rational Bézier curve of degree n is an algebraic curve of degree n
:zh: n 次有理曲线是 n 次代数曲线
:printed: Theorem 3.4.2 shows that a plane rational Bézier curve of degree $n$ is a plane algebraic curve of degree $n$.
:meant: theorem 3.4.2, whose $F$ has a degree | The $F$ of (3.4.1) is 0 at the points of the curve and has the degree $n$, repeated factors counted.
:holds-by: rows_of_the_determinant_are_shifted_equations sums_are_the_denominator_times_a_difference
  change_of_parameter_acts_on_one_factor bernstein_sum_of_powers_is_a_power top_form_is_a_resultant_row_by_row
:confirmed-by: parameter_change_and_its_inverse equation_vanishes_on_the_curve top_form_is_a_resultant
:argued: | The point of $t\ne a$ is that of $u=\frac{b-t}{t-a}$, by (3.4.3); a square matrix that takes a vector that is not 0 to 0 has the determinant 0, and at $\mathbf R_0$, the point of
  $t=a$, its first column is 0; and if the terms of degree $n$ vanished, so would a resultant for every $x:y$, and one zero of the denominator would be a zero of both numerators.
:hypothesis: elevated_curve_has_no_equation | the two numerators and the denominator of (3.4.4) have no common zero, real or complex; else $F$ is 0
  for all $(x,y)$, and theorem 3.4.2 says nothing of the degree of the curve
:needs: end_weight_zero_gives_no_equation | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\omega_0\ne0$; with $\omega_0=0$ the first
  column vanishes, and $u=\infty$ is a common zero
:reading: doubled_parameter_halves_the_degree | the degree is that of an equation without repeated factors; in the example, where
  $t$ and $-1-t$ give one point though the arc is run through once, $F$ is a square; the source does not ask that a parametrisation run through its curve once
:reading: common_root_of_a_point_off_the_arc | the Bézier curve is all of the algebraic curve, and not an arc of it
:figure: arc_of_a_parabola

No common zero and $\omega_0\ne0$ together say that there is no base point, $u=\infty$ included.  Then $F$ has degree exactly $n$ and vanishes on the curve; that is what is shown.
Theorem 3.4.2 by itself says that the degree is at most $n$; that it is not less follows from the terms of degree $n$, which do not vanish.
:::

:::{claim} doubled_parameter_halves_the_degree
:title: A quartic whose parameters t and −1−t have the same point of a parabola
:zh: 非正常参数化使次数降低
:kind: counterexample
:types: field
:data: R = (0,0) (1/8,0) (1/3,1/24) (5/8,1/4) (1,1); ω = 1 1 1 1 1
:instead: R = (0,0) (1/8,0) (1/3,1/24) (5/8,1/4) (1,2)
:result: F = "(x^4-2*x^2*y+y^2)/256"; Res_x(F, F_x) = "0"
:given: $n=4$, the points $R$ of the curve $(s,s^2)$ with $s=\frac{t+t^2}2$, all different, and equal weights: a curve without base point, whose arc is run through once
:then: $F$ is a multiple of the square of $x^2-y$, so the curve is on an algebraic curve of degree 2
:method: The discriminant $\operatorname{Res}_x(F,F_x)$ is 0 exactly if $F$, which is not 0, has a repeated factor
  (containing $x$); that it is not 0 is what is compared.
:control: another last point
:::
*/
CLAIM(doubled_parameter_halves_the_degree)
{
    enum { n = 4 };
    num x = variable_f("x"), y = variable_f("y"), R[2 * n + 2], w[n + 1];
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    num F = implicit_value_f(n, R, w, x, y), discriminant = resultant_by_f(F, derivative_f(F, x), x);
    found_text(T, "F", to_string_f(F));
    found_text(T, "Res_x(F, F_x)", to_string_f(discriminant));
    about(T, "F has no repeated factor");
    if (!is_zero_f(F)) /* no base point */
        refute(T, is_zero_f(discriminant));
}
#endif

/*
For the converse one curve suffices that no rational curve can follow.

:::{statement} wang-ch3:sec-3.4.2-converse
:title: Not every algebraic curve of degree n is a rational Bézier curve
:zh: 反之未必成立
:printed: But the converse, that a plane algebraic curve of degree $n$ is a plane rational Bézier curve of degree $n$,
  need not hold.
:holds-by: smooth_cubic_has_two_separate_parts rational_cubic_has_one_double_point
:cites: Lüroth's theorem: a curve with a rational parametrization has one that runs through it once | A rational cubic
  so has a parametrization of degree 3, hence a double point by `rational_cubic_has_one_double_point`; this one has
  none.  So no arc of it is rational.
:figure: smooth_cubic

That it need not hold is shown by one curve.
:::
*/

#include "chapters/judge/claims_off.h"
