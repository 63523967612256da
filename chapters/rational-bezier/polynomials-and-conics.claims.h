/*
# Polynomial curves and conics (多项式曲线与圆锥曲线)

The chapter begins with what polynomial curves cannot do and rational curves can.

A conic is $S=(A,B,C,D,E,F)$, the equation $S(x,y)=Ax^2+2Bxy+Cy^2+2Dx+2Ey+F=0$.
*/
#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch3:opening-bezier-conics
:title: Of the conics, Bézier curves represent exactly only the parabola
:zh: 多项式 Bézier 曲线与圆锥曲线
:printed: A Bézier curve cannot represent exactly any conic section but the parabola.
:holds-by: highest_powers_along_a_conic parabola_arcs_are_quadratic
:confirmed-by: ellipse_carries_no_polynomial_arc hyperbola_carries_no_polynomial_arc
:meant: section 3.1, which calls a pair of lines a degenerate conic | A conic section is an ellipse, a
  parabola or a hyperbola.
:argued: | Along an arc of the conic the equation is one of polynomials in $t$ that is true for infinitely many $t$, so for all, and the coefficient of its
  highest power is 0: this the claim excludes for an ellipse and, in affine coordinates, for a hyperbola.
:reading: highest_powers_along_a_conic | A conic section is an ellipse, a parabola or a hyperbola. | A polynomial that is 0 for infinitely many $t$ is 0, and so
  is the coefficient of its highest power.
:reading: line_pair_carries_a_segment | Every equation (3.1.1) is a conic section, as 3.1 has it, two lines among them:
  these carry segments.
:figure: polynomial_on_conics

To represent a conic means to run through an arc of it.
:::
*/

/* s, the n+m+1 Bernstein coefficients of S(x(t), y(t)), n = m the degree of x and y: every term is a
 * product of two polynomials of degree n, the linear ones with the factor 1. */
static void G(conic_along)(const num S[], int twice, int n, const num x[], const num y[], num s[])
{
    num one[MAX_DEGREE + 1], term[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++)
        one[i] = from_int(1);
    const num *factors[6][2] = {{x, x}, {x, y}, {y, y}, {x, one}, {y, one}, {one, one}};
    const int times[6] = {1, twice, 1, 2, 2, 1};
    for (int i = 0; i <= 2 * n; i++)
        s[i] = from_int(0);
    for (int k = 0; k < 6; k++) {
        G(bernstein_product)(n, factors[k][0], n, factors[k][1], term);
        for (int i = 0; i <= 2 * n; i++)
            s[i] = add(s[i], mul(mul(from_int(times[k]), S[k]), term[i]));
    }
}

/*
Put a polynomial curve into the equation of a conic.  If an arc of it lies on the conic, $S(x(t),y(t))$ is zero for
infinitely many $t$, and so it is the zero polynomial.  Look at its highest power.  With $p$ and $q$ for the leading
coefficients of $x$ and $y$ this is $Ap^2+2Bpq+Cq^2$, the quadratic part of the conic, and for an ellipse (椭圆) this form is
definite: it vanishes for $p=q=0$ only.

:::{claim} ellipse_carries_no_polynomial_arc
:title: No polynomial curve but a point lies on an ellipse
:zh: 椭圆上没有多项式曲线段
:given: a conic $S$, and a Bézier curve $(x(t),y(t))$ of degree $n$ with any points
:let: $p$ and $q$ be the coefficients of $t^n$ in $x(t)$ and $y(t)$
:then: the coefficient of $t^{2n}$ in $S(x(t),y(t))$, multiplied by $A$, is $(Ap+Bq)^2+(AC-B^2)q^2$; for
  $AC-B^2>0$ it vanishes only when $p=q=0$, so a polynomial curve on an ellipse is a point
:method: $S(x(t),y(t))$ is formed in Bernstein form, term by term, and brought to powers of $t$, with the conic and
  every point a variable.  If an arc of a curve of degree $n\ge1$, $(p,q)\ne(0,0)$, lay on the ellipse,
  $S(x(t),y(t))$ would be zero for infinitely many $t$, hence as a polynomial, and so would be this coefficient.
:degrees: 1..6 sampled 12
:over: S#: conics
:control: the product $xy$ counted once, not twice
:::
*/
CLAIM(ellipse_carries_no_polynomial_arc)
{
    int n = T->degree;
    num S[6], x[MAX_DEGREE + 1], y[MAX_DEGREE + 1], s[MAX_DEGREE + 1];
    for (int k = 0; k < 6; k++)
        S[k] = unknown(T, "S", k);
    for (int i = 0; i <= n; i++) {
        x[i] = unknown(T, "x", i);
        y[i] = unknown(T, "y", i);
    }
    G(conic_along)(S, fault(T, 2, 1), n, x, y, s);
    G(bernstein_to_power)(2 * n, s, s);
    G(bernstein_to_power)(n, x, x);
    G(bernstein_to_power)(n, y, y);
    num p = x[n], q = y[n], square = add(mul(S[0], p), mul(S[1], q));
    num delta = sub(mul(S[0], S[2]), mul(S[1], S[1]));
    about(T, "A times the top coefficient; the sum of two squares");
    /* A s_{2n} = (Ap + Bq)² + (AC - B²) q² */
    same(T, mul(S[0], s[2 * n]), add(mul(square, square), mul(delta, mul(q, q))));
}

/*
For a hyperbola (双曲线) the form is not definite, and another reason is needed.  In coordinates along the asymptotes the curve
is $\xi\eta=1$, and two polynomials whose product is 1 are constants.  Only the parabola (抛物线) is left, and there nothing
stands in the way.

:::{claim} hyperbola_carries_no_polynomial_arc
:title: No polynomial curve but a point lies on a hyperbola
:zh: 双曲线上没有多项式曲线段
:given: polynomials $\xi(t)$ and $\eta(t)$ of degrees $j$ and $n$, $0\le j\le n$, in Bernstein form
:then: the coefficient of $t^{j+n}$ in $\xi\eta$ is the product of the coefficients of $t^j$ in $\xi$ and of
  $t^n$ in $\eta$, so $\xi\eta=1$ only for constants
:method: A hyperbola is $\xi\eta=1$ in affine coordinates whose axes are its asymptotes.  Of two polynomials with
  $\xi\eta=1$, taken in their true degrees, the product of the leading coefficients is not zero; so $j+n=0$, and
  the curve is a point.  The product is formed in Bernstein form, every coefficient a variable.
:degrees: 1..6 sampled 12
:over: x# y#: coefficients
:control: the leading coefficient of the product taken in degree $j+n-1$
:::
*/
CLAIM(hyperbola_carries_no_polynomial_arc)
{
    int n = T->degree;
    num xi[MAX_DEGREE + 1], eta[MAX_DEGREE + 1], top[MAX_DEGREE + 1], product[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++)
        eta[i] = unknown(T, "y", i);
    G(bernstein_to_power)(n, eta, top);
    num leading = top[n];
    for (int j = 0; j <= n; j++) {
        for (int i = 0; i <= j; i++)
            xi[i] = unknown(T, "x", i);
        G(bernstein_to_power)(j, xi, top);
        G(bernstein_product)(j, xi, n, eta, product);
        G(bernstein_to_power)(j + n, product, product);
        same(T, product[fault(T, j + n, j + n - 1)], mul(top[j], leading));
    }
}

/*
In both cases only the highest powers counted, and they do so in every degree.

:::{claim} highest_powers_along_a_conic
:title: The highest power along an ellipse and along a hyperbola, in every degree
:zh: 沿椭圆与双曲线的最高次项(任意次数)
:given: a conic $S$; $x=pU+X$ and $y=qU+Y$ with $U=t^n$ and the rest $X,Y$ of lower degree; $\xi=pU+X$ and $\eta=qV+Y$ with
  $U=t^j$, $V=t^n$ and rests of lower degree
:then: $S(x,y)=(Ap^2+2Bpq+Cq^2)U^2+2(Ap+Bq)UX+2(Bp+Cq)UY+2(Dp+Eq)U+S(X,Y)$, and $A(Ap^2+2Bpq+Cq^2)=(Ap+Bq)^2+(AC-B^2)q^2$;
  $\xi\eta=pqUV+pUY+qVX+XY$
:method: Identities in $A,\dots,F$, $p$, $q$, $U$, $V$, $X$, $Y$.  For $n\ge1$ all terms behind the first are of lower degree than $t^{2n}$,
  and than $t^{j+n}$ in the second.  An arc on the conic makes the left side 0, or 1, for infinitely many $t$, so for $j+n\ge1$ the first
  factor is 0: for $AC-B^2>0$ only with $p=q=0$, and $pq\ne0$ when $\xi$ and $\eta$ are taken in their true degrees.  A hyperbola is
  $\xi\eta=1$ in affine coordinates along its asymptotes.
:degrees: all
:over: S#: conics; p q U V X Y: -
:control: the product $xy$ counted once, not twice
:::
*/
CLAIM(highest_powers_along_a_conic)
{
    num S[6], p = unknown(T, "p", 0), q = unknown(T, "q", 0), U = unknown(T, "U", 0), V = unknown(T, "V", 0);
    num X = unknown(T, "X", 0), Y = unknown(T, "Y", 0), two = from_int(2), along, lower;
    for (int k = 0; k < 6; k++)
        S[k] = unknown(T, "S", k);
    num point[2][2] = {{add(mul(p, U), X), add(mul(q, U), Y)}, {X, Y}}, *value[2] = {&along, &lower};
    for (int k = 0; k < 2; k++) { /* the value of the conic, term by term */
        num x = point[k][0], y = point[k][1];
        num square =
            add(add(mul(S[0], mul(x, x)), mul(mul(from_int(fault(T, 2, 1)), S[1]), mul(x, y))), mul(S[2], mul(y, y)));
        *value[k] = add(square, add(mul(two, add(mul(S[3], x), mul(S[4], y))), S[5]));
    }
    num first = add(mul(S[0], p), mul(S[1], q)), second = add(mul(S[1], p), mul(S[2], q));
    num top = add(mul(p, first), mul(q, second)),
        rest = add(mul(first, X), add(mul(second, Y), add(mul(S[3], p), mul(S[4], q))));
    about(T, "the conic along the curve");
    same(T, along, add(mul(top, mul(U, U)), add(mul(mul(two, U), rest), lower)));
    about(T, "A times the top coefficient; the sum of two squares");
    num delta = sub(mul(S[0], S[2]), mul(S[1], S[1]));
    same(T, mul(S[0], top), add(mul(first, first), mul(delta, mul(q, q))));
    about(T, "the product along the asymptotes");
    num product = mul(add(mul(p, U), X), add(mul(q, V), Y));
    same(T, product, add(mul(mul(p, q), mul(U, V)), add(mul(mul(p, U), Y), add(mul(mul(q, V), X), mul(X, Y)))));
}

/*
:::{claim} parabola_arcs_are_quadratic
:title: Every arc of a parabola is a quadratic Bézier curve
:zh: 抛物线弧是二次 Bézier 曲线
:given: numbers $a$ and $b$, the ends of an arc of $y=x^2$
:then: the Bézier curve with the points $(a,a^2),(\frac{a+b}2,ab),(b,b^2)$ runs through it: $x=(1-t)a+tb$, $y=x^2$
:method: An identity in $a$, $b$ and $t$; every parabola is an affine image of $y=x^2$, and Bézier curves go along
  with affine maps.
:over: a b: -
:control: the middle point at the middle of the chord
:::
*/
CLAIM(parabola_arcs_are_quadratic)
{
    num a = unknown(T, "a", 0), b = unknown(T, "b", 0), t = parameter(T, "t"), P[2], half = from_ratio(1, 2);
    num aa = mul(a, a), bb = mul(b, b), between = fault(T, mul(a, b), mul(half, add(aa, bb)));
    num R[6] = {a, aa, mul(half, add(a, b)), between, b, bb};
    G(bezier_casteljau)(2, 2, R, t, P);
    num x = add(mul(sub(from_int(1), t), a), mul(t, b));
    same(T, P[0], x);
    same(T, P[1], mul(x, x));
}

#if RATIONAL
/*
The sentence is therefore true, if a conic section is one of these three curves.  The equation (3.1.1), by which the source
defines the word a few lines later, also has pairs of lines for its solutions; and a line carries a segment.

:::{claim} line_pair_carries_a_segment
:title: A pair of lines, a degenerate conic, carries Bézier curves
:zh: 退化的二次曲线上有多项式曲线
:kind: counterexample
:data: S = 0 1/2 0 0 0 0; R = (0,0) (1,0)
:instead: S = 0 1/2 0 0 0 -1
:result: S(R(t)) = 0 0 0
:given: the conic $S=(A,B,C,D,E,F)$ of (3.1.1), the two axes, $xy=0$, which are no parabola, and the Bézier curve $R(t)$ of degree 1 with the
  points $R$ on one of them
:then: the curve lies on the conic
:method: $S(R(t))$ is formed in Bernstein form; the conic carries the curve when it is the zero polynomial.
:control: the hyperbola with these axes for its asymptotes
:::
*/
CLAIM(line_pair_carries_a_segment)
{
    num S[6], R[4], s[3];
    given_points(T, "S", 6, 1, S);
    given_points(T, "R", 2, 2, R);
    G(conic_along)(S, 2, 1, (num[]){R[0], R[2]}, (num[]){R[1], R[3]}, s);
    found_points(T, "S(R(t))", 3, 1, s);
    about(T, "whether some coefficient of S(R(t)) in Bernstein form is not zero");
    refute(T, is_zero_q(s[0]) && is_zero_q(s[1]) && is_zero_q(s[2]));
}
#endif

/*
:::{statement} wang-ch3:opening-rational-conics
:title: Rational Bézier curves represent polynomial curves and conics
:zh: 有理形式统一表示多项式曲线与圆锥曲线
:printed: A rational Bézier curve can represent polynomial curves, such as the longitudinal curves of a fuselage, and can represent conic
  sections, such as its cross sections; the two can be programmed in one way.
:holds-by: mean_grows_by_one_term change_of_parameter_acts_on_one_factor tangent_conics_are_rational_quadratics conics_touching_two_lines_are_limings
  every_point_of_the_arc_is_reached bernstein_sum_of_powers_is_a_power
:confirmed-by: rational_form_contains_the_polynomial_one
:argued: | For a polynomial curve let the weights be equal: by (5) of `change_of_parameter_acts_on_one_factor` the denominator is the weight itself, and what is left is
  $\sum B_i^n(t)R_i$, which by (6) there is any polynomial, coordinate by coordinate.  For a conic: about any point of an ellipse, parabola or hyperbola there are two
  tangents that meet, and the short arc between their points is inside the triangle of these and of the point where they meet.  There $xy>0$, so $\nu/\mu<0$ and the three weights are positive, and with $\lambda/(1-\lambda)=-\nu/\mu$ the
  curve reaches every point of the arc.
:meant: the examples, which are arcs of such curves | To represent a curve is to run through an arc of it.
:figure: polynomial_on_conics

The fuselage is an example of the source; that both kinds are one formula is what is
decided.  For a polynomial curve the positive weights of which the verdict speaks are equal; for a conic they are $1,1,-4\nu/\mu$.
:::

A denominator takes the obstacle away, since now it is a quotient of polynomials that has to satisfy the equation.  That
polynomial curves remain among the rational ones is the case of equal weights; that conics come in, is shown here for those
which touch two sides of a triangle, and the next sections find out how the weights come about.

:::{claim} rational_form_contains_the_polynomial_one
:title: Equal weights give the polynomial curve
:zh: 权相等时即多项式曲线
:given: points $R_0,\dots,R_n$ and one weight $\omega\ne0$ for all of them
:where: $\omega\ne0$
:then: the rational curve is the Bézier curve $\sum B_i^n(t)R_i$
:method: The rational curve by its kernel, the polynomial one as the sum over $C(n,i)t^i(1-t)^{n-i}R_i$, compared in
  the field; a coordinate is any coordinate.
:degrees: 1..6 sampled 12
:control: the last weight doubled
:::
*/
CLAIM(rational_form_contains_the_polynomial_one)
{
    int n = T->degree;
    num t = parameter(T, "t"), s = sub(from_int(1), t), w = positive(T, "w", 0);
    num R[MAX_DEGREE + 1], weight[MAX_DEGREE + 1], point, sum = from_int(0);
    for (int i = 0; i <= n; i++) {
        R[i] = unknown(T, "R", i);
        weight[i] = fault(T, w, i == n ? add(w, w) : w);
        num term = mul(from_int(binomial(n, i)), R[i]);
        for (int k = 0; k < n; k++)
            term = mul(term, k < i ? t : s);
        sum = add(sum, term);
    }
    G(rational_point)(n, 1, R, weight, t, &point);
    same(T, point, sum);
}

/*
:::{claim} tangent_conics_are_rational_quadratics
:title: Every conic that touches two sides of a triangle at their ends carries a rational quadratic
:zh: 切于三角形两边的二次曲线上都有有理二次曲线
:given: a triangle $R_0R_1R_2$ with the coordinates $R=R_1+x(R_0-R_1)+y(R_2-R_1)$, and a conic
  $\mu\,xy+\nu(x+y-1)^2=0$, $\mu\nu\ne0$
:where: the conic is no pair of lines
:then: the rational quadratic with the points $R_i$ and the weights $1,1,-4\nu/\mu$ lies on it
:method: In the frame $R_0=(1,0)$, $R_1=(0,0)$, $R_2=(0,1)$, at a variable $t$, with $\mu$ and $\nu$ variables.  By
  `conics_touching_two_lines_are_limings` these are all conics that touch $R_1R_0$ in $R_0$ and $R_1R_2$ in
  $R_2$, apart from the two lines and the double line.  Where an arc is inside the triangle $xy>0$, so
  $\nu/\mu<0$, and the three weights are positive.
:over: m: μ; k: ν
:control: the last weight $-2\nu/\mu$
:::
*/
CLAIM(tangent_conics_are_rational_quadratics)
{
    num mu = positive(T, "m", 0), nu = positive(T, "k", 0), t = parameter(T, "t"), zero = from_int(0),
        one = from_int(1);
    num R[6] = {one, zero, zero, zero, zero, one}, P[2];
    num w[3] = {one, one, mul(from_int(fault(T, -4, -2)), div(nu, mu))};
    G(rational_point)(2, 2, R, w, t, P);
    num s = sub(add(P[0], P[1]), one);
    /* μ xy + ν (x + y - 1)² = 0 */
    vanishes(T, add(mul(mu, mul(P[0], P[1])), mul(nu, mul(s, s))));
}

#if RATIONAL
/*
## The list of references (参考文献)

:::{statement} wang-ch3:references-cited
:title: The numbered references
:zh: 参考文献的引用
:printed: the list has the references 1 to 10, and the text cites them by these numbers
:holds-by: each_of_ten_references_is_cited_once

Every number that is cited is in the list, and every entry of the list is cited.  Rowin, Coons, Ball, Forrest, Farin, Pigel and 刘鼎元 are named in the opening with the numbers 1 to 7, Liming with 8, which is the book of Faux and Pratt, the rule of
Descartes with 9 and the genus with 10.  Reference 1 is of the Boeing Company, printed Beoing; the report of reference 2, of 1967, is on space forms, printed figures; reference 3 is about the
conic lofting tile, printed title; reference 4 is in number 4 of its volume, printed 2; the author of reference 6 is Piegl, printed Pigel here and in the opening.
:::

:::{claim} each_of_ten_references_is_cited_once
:title: The numbers cited are 1 to 10, in this order
:zh: 参考文献 1 至 10 依次被引用
:kind: decision
:given: the citations by numbers in the text of the chapter, in their order, and how many references the list has, numbered from 1
:data: citations = 1 2 3 4 5 6 7 8 9 10; references = 10
:instead: citations = 1 2 3 4 5 6 7 8 8 10
:then: the $k$-th citation is that of reference $k$, and the last one that of the last reference
:method: The numbers are compared one after the other.
:scope: the numbered references
:control: one reference cited twice, and the next not at all
:::
*/
CLAIM(each_of_ten_references_is_cited_once)
{
    enum { CITATIONS = 10 };
    num cited[CITATIONS];
    given_points(T, "citations", CITATIONS, 1, cited);
    for (int k = 0; k < CITATIONS; k++)
        same(T, cited[k], from_int(k + 1));
    same(T, cited[CITATIONS - 1], from_int(given_whole(T, "references")));
}
#endif
#include "chapters/judge/claims_off.h"
