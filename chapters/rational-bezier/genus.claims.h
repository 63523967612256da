/*
# Which algebraic curves are rational? (亏格)

Every plane rational curve has an implicit equation; which algebraic curves (代数曲线) are rational?  The answer is a
theorem of algebraic geometry, quoted by the source.  Part of it is decided here by computation, and part is cited;
each claim says which.  Cited, for every degree, is: an irreducible plane curve has a rational parametrisation over
the complex numbers if and only if its genus is 0, and the genus of a curve of degree $n$ is
$\frac{(n-1)(n-2)}2-\sum_P\delta_P$, the sum over all singular points of the complex projective plane
[walker-1950; sendra-winkler-perez-diaz-2008].  Here
$\delta_P=1$ for a node (结点) and an ordinary cusp (尖点), but 3 for an ordinary triple point, and more for points with
others infinitely near.
*/
#include "exact/record/resultant.h"
#include "exact/record/roots.h"
#include "exact/record/sign.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch3:def-3.4.1
:title: A plane algebraic curve of degree n
:zh: 平面 n 次代数曲线的定义
:printed: the points whose coordinates satisfy the algebraic equation of degree $n$,
  $F(x,y)=\sum_{i,j=0}^n\alpha_{ij}x^iy^j=0$, $\alpha_{ij}$ constants, form a plane algebraic curve of degree $n$
:definition: yes
:checked-by: total_degree_survives_affine_maps
:reading: total_degree_survives_affine_maps | "an equation of degree $n$" has its usual meaning, the total degree, and
  the sum only names coefficients, those with $i+j>n$ being 0: this is how the section uses it
:reading: hyperbola_has_the_printed_form_for_degree_one | the sum itself says what an equation of degree $n$ is
:corrected: F(x,y)=\sum_{i+j\le n}\alpha_{ij}x^iy^j=0,\quad\text{some }\alpha_{ij}\ne0\text{ with }i+j=n
:corrected-by: total_degree_survives_affine_maps
:figure: degree_of_a_hyperbola

The printed words and the printed sum disagree: the sum has terms up to $x^ny^n$, of degree $2n$.  The words decide;
the degree of theorem 3.4.2 is the total degree, and every polynomial of total degree $n$ is such a sum.  Taken by the
sum alone a hyperbola would have degree 1 in one system of coordinates and not in another, and theorem 3.4.3, whose $n$
this is, would be false at once (`printed_degree_spoils_the_genus`).  Better is the sum over $i+j\le n$.
:::
*/

#if FIELD
/* The total degree of F in x and y. */
static int total_degree(num_f F, num_f x, num_f y)
{
    num_f s = variable_f("scale"), sx = mul(s, x), sy = mul(s, y), sum = from_int(0);
    int n = degree_f(F, x);
    for (int k = n; k >= 0; k--) {
        num_f c = coefficient_f(F, x, k), row = from_int(0);
        for (int j = degree_f(c, y); j >= 0; j--)
            row = add(mul(row, sy), coefficient_f(c, y, j));
        sum = add(mul(sum, sx), row);
    }
    return degree_f(sum, s);
}

/*
:::{claim} hyperbola_has_the_printed_form_for_degree_one
:title: The hyperbola xy = 1 is of the form printed for n = 1
:zh: xy=1 符合所印一次形式
:kind: counterexample
:types: field
:given: $F=xy-1$, of the printed form with $n=1$: exponents at most 1
:then: its degree is 2: on the line $y=x$ it has two zeros; in the coordinates $x=p+q$, $y=p-q$ it is $p^2-q^2-1$,
  which is not of the printed form with $n=1$
:method: The degree in $s$ of $F(sx,sy)$ is compared with $n=1$.
:control: the line $x+y-1$
:::
*/
CLAIM(hyperbola_has_the_printed_form_for_degree_one)
{
    num x = variable_f("x"), y = variable_f("y"), F = sub(fault(T, add(x, y), mul(x, y)), from_int(1));
    show(T, "F", F);
    about(T, "F of the printed form with n = 1 has degree at most 1");
    if (degree_f(F, x) <= 1 && degree_f(F, y) <= 1)
        agree(T, total_degree(F, x, y) <= 1);
}

/*
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
:::{statement} wang-ch3:sec-3.4.2-algebraic
:title: A rational Bézier curve of degree n is an algebraic curve of degree n
:zh: n 次有理曲线是 n 次代数曲线
:printed: theorem 3.4.2 shows that a plane rational Bézier curve of degree $n$ is a plane algebraic curve of degree $n$
:holds-by: equation_vanishes_on_the_curve top_form_is_a_resultant
:hypothesis: elevated_curve_has_no_equation | no base point; else theorem 3.4.2 says nothing, and the degree is less
  than $n$
:reading: doubled_parameter_halves_the_degree | the degree is that of an equation without repeated factors: false, as $F$ is a
  power unless the parametrisation is proper, one parameter for almost every point; the source does not ask for a proper parametrisation
:reading: common_root_of_a_point_off_the_arc | the Bézier curve is all of the algebraic curve: false, it is an arc of it
:figure: arc_of_a_line

Without base point $F$ has degree exactly $n$ and vanishes on the curve; that is what is proved.  That $F$ is
irreducible when the parametrisation is proper is cited.
:::

:::{claim} doubled_parameter_halves_the_degree
:title: A quadratic that runs to and fro on a line
:zh: 非正常参数化使次数降低
:kind: counterexample
:types: field
:given: $n=2$, points $(0,0),(0,0),(1,1)$, weights 1: the curve $(t^2,t^2)$, without base point
:then: $F$ is a constant times $(x-y)^2$, so the curve is on an algebraic curve of degree 1
:method: The discriminant $\operatorname{Res}_x(F,F_x)$ is 0 exactly if $F$, which is not 0, has a repeated factor
  (containing $x$); that it is not 0 is what is compared.
:control: the last point $(1,0)$ and the middle one $(0,1)$
:::
*/
CLAIM(doubled_parameter_halves_the_degree)
{
    int middle = fault(T, 1, 0);
    num x = variable_f("x"), y = variable_f("y"), w[3] = {from_int(1), from_int(1), from_int(1)};
    num R[6] = {from_int(0), from_int(0), from_int(0), from_int(middle), from_int(1), from_int(1 - middle)};
    num F = implicit_value_f(2, R, w, x, y);
    show_points(T, "R", 3, 2, R);
    show(T, "F", F);
    about(T, "F has no repeated factor");
    if (!is_zero_f(F)) /* no base point */
        refute(T, is_zero_f(resultant_by_f(F, derivative_f(F, x), x)));
}
#endif

/*
:::{statement} wang-ch3:sec-3.4.2-converse
:title: Not every algebraic curve of degree n is a rational Bézier curve
:zh: 反之未必成立
:printed: the converse, that a plane algebraic curve of degree $n$ is a plane rational Bézier curve of degree $n$,
  need not hold
:holds-by: smooth_cubic_has_two_separate_parts
:figure: smooth_cubic
:::

## Counting singular points

The singular points of a projective curve $F(x,y,z)=0$ are the common zeros of its three derivatives.  They are
found by elimination and each is verified: the abscissas of the finite ones are the common zeros, for all $\beta$,
of $\operatorname{Res}_y(F,F_x+\beta F_y)$, and over each abscissa, as over the line at infinity, they are counted
by a greatest common divisor, complex ones included.  The list of points that a claim states must have just that
many.  At each of them the terms of second order decide whether it is a node; if they are a square, those of third
order on its line decide whether it is an ordinary cusp.

:::{statement} wang-ch3:thm-3.4.3
:title: A curve of degree n is a rational Bézier curve if and only if its genus is 0
:zh: 亏格判据
:printed: a plane algebraic curve of degree $n$ can be written as a rational Bézier curve if and only if its genus
  $g=\frac{(n-1)(n-2)}2-d-s$ is 0, where $d$ and $s$ are the numbers of its double points and its cusps, imaginary ones
  included
:class: missing-hypothesis
:refuted-by: reducible_curve_with_count_zero conic_without_real_points rational_quartic_with_a_triple_point
  rational_quartic_with_a_higher_cusp
:reading: cuspidal_cubic_at_infinity | only finite points are counted: false already for $y=x^3$; the projective
  plane has to be meant
:reading: cusp_counted_twice | a cusp, being a double point, is counted in $d$ and in $s$: false already for
  $y^2=x^3$; $d$ has to mean nodes
:reading: printed_degree_spoils_the_genus | $n$ is the range of the sum printed in definition 3.4.1: false for
  $x^2y+xy^2+1=0$
:reading: common_root_of_an_isolated_point | all real points of the curve are on the Bézier curve: false, an
  isolated point is on no arc; and with positive weights a Bézier curve is bounded, so that already a line is not
  one
:corrected: let a real plane curve of degree $n$ be irreducible over $\mathbb C$ and have a simple real point. For
  $n\le3$ its short regular arcs are rational Bézier curves of degree $n$ if and only if it has $\frac{(n-1)(n-2)}2$
  singular points in the complex projective plane; for $n\ge4$ they are if it has a point of multiplicity $n-1$, and
  for $n=4$ also if it has three double points
:corrected-by: curve_with_a_large_point_is_rational rational_cubic_has_one_double_point
  quartic_with_three_double_points_is_rational
:figure: genus_extra
:striking: 5

The correction says no more than what is proved here: an identity for each of its parts, and the argument from there
in the method of the claim; a line and a conic have no singular point.  Only cited is the theorem for every $n$, which
takes its place: the short regular arcs are rational Bézier curves if and only if
$\frac{(n-1)(n-2)}2-\sum_P\delta_P=0$, the sum over all singular points of the complex projective plane; it is $d+s$ if
they are all nodes and ordinary cusps.  `curves_that_fit_the_theorem` and the counterexamples agree with it.
:::

:::{claim} curve_with_a_large_point_is_rational
:title: A curve of degree n with a point of multiplicity n-1 is rational
:zh: 含 n-1 重点的 n 次曲线是有理的
:given: $F=f_{n-1}(x,y)+f_n(x,y)$ with any forms of degrees $n-1$ and $n\ge2$: a curve with a point of multiplicity
  $n-1$ in the origin
:then: $x=-f_{n-1}(1,t)/f_n(1,t)$, $y=tx$ satisfies $F=0$
:method: Every coefficient and $t$ are variables; the forms are added up term by term at $(x,y)$.  Where $F$ is
  irreducible neither form is 0 and all its points but those at the origin and on the line $x=0$ have such a $t=y/x$.
  With $n=2$ it is every conic with a real point, with $n=3$ every cubic with a double point.
:degrees: 2..6 sampled 12
:scope: larger $n$ by the argument $F(x,tx)=x^{n-1}(f_{n-1}(1,t)+xf_n(1,t))$ alone
:control: the sign of $x$
:::
*/
CLAIM(curve_with_a_large_point_is_rational)
{
    int n = T->degree;
    num low = from_int(0), high = from_int(0), t = parameter(T, "t"), power = from_int(1), c[2 * MAX_DEGREE];
    for (int k = 0; k <= n; k++) { /* the forms at (1, t) */
        if (k < n) {
            c[k] = unknown(T, "a", k);
            low = add(low, mul(c[k], power));
        }
        c[n + k] = unknown(T, "b", k);
        high = add(high, mul(c[n + k], power));
        power = mul(power, t);
    }
    num x = div(fault(T, neg(low), low), high), y = mul(t, x), F = from_int(0);
    for (int k = 0; k <= n; k++) { /* the forms at (x, y), term by term */
        num term = from_int(1);
        for (int j = 0; j < n - 1; j++)
            term = mul(term, j < k ? y : x);
        if (k < n)
            F = add(F, mul(c[k], term));
        term = from_int(1);
        for (int j = 0; j < n; j++)
            term = mul(term, j < k ? y : x);
        F = add(F, mul(c[n + k], term));
    }
    about(T, "F on the curve");
    vanishes(T, F);
}

/*
:::{claim} quartic_with_three_double_points_is_rational
:title: A quartic with three double points is the image of a conic
:zh: 含三个二重点的四次曲线由二次曲线变换而得
:given: $F=\sum c_{ijk}x^iy^jz^k$, $i+j+k=4$, $i,j,k\le2$: any quartic with points of multiplicity 2 or more in
  $(1:0:0)$, $(0:1:0)$, $(0:0:1)$
:then: $F(yz,zx,xy)=x^2y^2z^2\,Q(x,y,z)$ with the conic $Q=\sum c_{ijk}x^{2-i}y^{2-j}z^{2-k}$
:method: An identity in the six coefficients and $x,y,z$.  A quadratic parametrisation of the conic, put into
  $(yz:zx:xy)$, is one of degree 4 of the quartic.  Three double points of an irreducible quartic are never on a line,
  which would meet it six times, so a projective map brings them to these places.  If two of them are conjugate, that
  map is not real; the conics through the three points and a simple real point still meet the quartic in
  $8-6-1=1$ further point each, and these run through it.
:scope: n = 4
:control: a term $x^4$ added, with which $(1:0:0)$ is no point of the curve
:::
*/
/* a^i */
static num G(to_the)(num a, int i) { return i == 0 ? from_int(1) : mul(a, G(to_the)(a, i - 1)); }

CLAIM(quartic_with_three_double_points_is_rational)
{
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), z = unknown(T, "z", 0), Q = from_int(0), image = from_int(0);
    int used = 0;
    num yz = mul(y, z), zx = mul(z, x), xy = mul(x, y);
    for (int i = 0; i <= 4; i++)
        for (int j = 0; i + j <= 4; j++) {
            int k = 4 - i - j, allowed = i <= 2 && j <= 2 && k <= 2;
            if (fault(T, !allowed, !allowed && i != 4))
                continue;
            num c = unknown(T, "c", used++);
            image = add(image, mul(c, mul(G(to_the)(yz, i), mul(G(to_the)(zx, j), G(to_the)(xy, k)))));
            if (allowed)
                Q = add(Q, mul(c, mul(G(to_the)(x, 2 - i), mul(G(to_the)(y, 2 - j), G(to_the)(z, 2 - k)))));
        }
    same(T, image, mul(G(to_the)(mul(x, yz), 2), Q));
}

/*
:::{claim} rational_cubic_has_one_double_point
:title: Every rational cubic has exactly one double point
:zh: 有理三次曲线恰有一个二重点
:given: a cubic $(1+at^3:t+bt^3:t^2+ct^3)$, to which a projective map and a change of the parameter bring every curve
  $(A:B:W)$ with independent $A,B,W$
:let: $q(t)=(ac-b^2)t^2+(a+bc)t-(b+c^2)$, $s$ and $s'$ its zeros
:then: the points of the parameters $s$ and $s'$ are one
:method: The three minors of the two points, divided by $s-s'$, are symmetric; written in $\sigma=s+s'$ and
  $\pi=ss'$, the coefficients of $q$ inserted, they vanish identically in $a,b,c$.  There is no other pair: a
  relation $\lambda P(s)+\mu P(s')=0$ is a linear form on cubic polynomials that kills $A,B,W$, so it is a multiple
  of the one with the values $a,b,c,-1$ at $1,t,t^2,t^3$; its products with $q$ and $tq$ vanish, and $q$ is up to a
  factor the only such polynomial when the vectors $(a,b,c)$ and $(b,c,-1)$ are independent.  They are dependent
  exactly for $q=0$, when $1+ct$ divides $A$, $B$ and $W$ and the curve is a conic.  For $s=s'$ the divided minors
  say that $P$ and $P'$ are parallel there: a cusp.  So $d+s=1$, $g=0$, for $n=3$.
:scope: n = 3
:control: the sign of the middle coefficient of $q$
:::
*/
CLAIM(rational_cubic_has_one_double_point)
{
    num abc[3], q[3], zero = from_int(0), one = from_int(1);
    for (int k = 0; k < 3; k++)
        abc[k] = unknown(T, k == 0 ? "a" : k == 1 ? "b" : "c", 0);
    num a = abc[0], b = abc[1], c = abc[2], middle = add(a, mul(b, c));
    q[0] = neg(add(b, mul(c, c)));
    q[1] = fault(T, middle, neg(middle));
    q[2] = sub(mul(a, c), mul(b, b));
    num sigma = neg(q[1]), product = q[0];                                                      /* times q[2] */
    num h[3] = {mul(q[2], q[2]), mul(q[2], sigma), sub(mul(sigma, sigma), mul(q[2], product))}; /* h_k times q[2]^2 */
    num P[3][4];
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++)
            P[k][i] = i == k ? one : zero;
        P[k][3] = abc[k];
    }
    /* s^j s'^i - s^i s'^j = (s - s') (s s')^i h_{j-i-1}, and h_1 = σ, h_2 = σ² - π */
    about(T, "the minors of the two points");
    for (int k = 0; k < 3; k++)
        for (int l = k + 1; l < 3; l++) {
            num sum = zero;
            for (int i = 0; i < 4; i++)
                for (int j = i + 1; j < 4; j++) {
                    num minor = sub(mul(P[k][j], P[l][i]), mul(P[k][i], P[l][j])), term = h[j - i - 1];
                    for (int m = 0; m < i; m++) /* only i + (j-i-1) <= 2 factors of degree one in σ, π occur */
                        term = div(mul(term, product), q[2]);
                    sum = add(sum, mul(minor, term));
                }
            vanishes(T, sum);
        }
}

#if FIELD
/* A plane curve by its homogeneous polynomial F in the variables x, y, z, and the points where it is said to be
 * singular: the coordinates of point k may contain theta, which stands for each of the zeros of modulus[k]. */
struct singular_list {
    num_f F, x, y, z, theta;
    int points;
    num_f point[4][3], modulus[4];
};
/* How many singular points there are of each kind; nodes is -1 when the list is not complete and right. */
struct census {
    int nodes, cusps, others;
};

static poly in_one_variable(num_f a, num_f variable)
{
    poly numerator, denominator;
    poly_from_field(a, variable, &numerator, &denominator);
    return numerator;
}

static int different_zeros(poly p) { return poly_degree(p) - poly_degree(poly_gcd(p, poly_derivative(p))); }

/* The singular points with z = 1, or -1 when one of them has an abscissa that is not in the list. */
static int finite_singular_points(const struct singular_list *s)
{
    num_f one = from_int(1), F = substitute_f(s->F, s->z, one), Fx = derivative_f(F, s->x), Fy = derivative_f(F, s->y);
    poly common = poly_constant(from_int_q(0));
    for (int beta = 0; beta <= degree_f(F, s->y); beta++) {
        num_f slope = add(Fx, mul(from_int(beta), Fy));
        if (!is_zero_f(slope))
            common = poly_gcd(common, in_one_variable(resultant_by_f(F, slope, s->y), s->x));
    }
    int count = 0, abscissas = 0;
    for (int k = 0; k < s->points; k++) {
        num_q x;
        int repeated = 0;
        if (is_zero_f(s->point[k][2]) || !is_constant_f(s->point[k][0], &x))
            continue;
        for (int j = 0; j < k; j++)
            repeated |= !is_zero_f(s->point[j][2]) && is_zero_f(sub(s->point[j][0], s->point[k][0]));
        if (repeated || !is_zero_q(poly_value(common, x)))
            continue;
        abscissas++;
        num_f at = s->point[k][0];
        poly over = in_one_variable(substitute_f(F, s->x, at), s->y);
        over = poly_gcd(over, in_one_variable(substitute_f(Fx, s->x, at), s->y));
        count += different_zeros(poly_gcd(over, in_one_variable(substitute_f(Fy, s->x, at), s->y)));
    }
    return poly_is_zero(common) || different_zeros(common) != abscissas ? -1 : count;
}

/* The singular points with z = 0: those with y = 1, and (1 : 0 : 0). */
static int infinite_singular_points(const struct singular_list *s)
{
    num_f variable[3] = {s->x, s->y, s->z}, zero = from_int(0), one = from_int(1);
    poly common = poly_constant(from_int_q(0));
    int corner = 1;
    for (int k = 0; k < 3; k++) {
        num_f slope = substitute_f(derivative_f(s->F, variable[k]), s->z, zero);
        common = poly_gcd(common, in_one_variable(substitute_f(slope, s->y, one), s->x));
        corner &= is_zero_f(substitute_f(substitute_f(slope, s->y, zero), s->x, one));
    }
    return poly_is_zero(common) ? -1 : different_zeros(common) + corner;
}

/* The multiplicity of F at a listed point, 3 standing for 3 and more.  For 2 also: *node, the quadratic terms are no square;
 * *cusp, they are one and the cubic terms do not vanish on its line. */
static int order_at(const struct singular_list *s, int k, int *node, int *cusp)
{
    num_f all[3] = {s->x, s->y, s->z}, u[2], D[4][4];
    int chart = 2, used = 0;
    while (is_zero_f(s->point[k][chart]))
        chart--;
    for (int j = 0; j < 3; j++)
        if (j != chart)
            u[used++] = all[j];
    poly modulus = in_one_variable(s->modulus[k], s->theta);
    int zero[4][4];
    for (int i = 0; i < 4; i++)
        for (int j = 0; i + j < 4; j++) {
            D[i][j] = s->F;
            for (int m = 0; m < i; m++)
                D[i][j] = derivative_f(D[i][j], u[0]);
            for (int m = 0; m < j; m++)
                D[i][j] = derivative_f(D[i][j], u[1]);
            for (int m = 0; m < 3; m++)
                D[i][j] = substitute_f(D[i][j], all[m], s->point[k][m]);
            zero[i][j] = poly_divides(modulus, in_one_variable(D[i][j], s->theta));
        }
    if (!zero[0][0] || !zero[1][0] || !zero[0][1])
        return 1;
    if (zero[2][0] && zero[1][1] && zero[0][2])
        return 3;
    num_f hessian = sub(mul(D[1][1], D[1][1]), mul(D[2][0], D[0][2]));
    *node = !poly_divides(modulus, in_one_variable(hessian, s->theta));
    /* a direction (p, q) in which the quadratic form, if a square, vanishes */
    num_f p = zero[0][2] ? D[1][1] : D[0][2], q = neg(zero[0][2] ? D[2][0] : D[1][1]), sum = from_int(0);
    static const int binomials[4] = {1, 3, 3, 1};
    for (int i = 0; i < 4; i++) {
        num_f term = mul(from_int(binomials[i]), D[3 - i][i]);
        for (int m = 0; m < 3; m++)
            term = mul(term, m < i ? q : p);
        sum = add(sum, term);
    }
    *cusp = !*node && !poly_divides(modulus, in_one_variable(sum, s->theta));
    return 2;
}

static struct census census_of(const struct singular_list *s)
{
    struct census c = {0, 0, 0};
    int finite = finite_singular_points(s), infinite = infinite_singular_points(s), listed = 0,
        wrong = finite < 0 || infinite < 0;
    for (int k = 0; k < s->points; k++) {
        int node = 0, cusp = 0, order = order_at(s, k, &node, &cusp), copies = degree_f(s->modulus[k], s->theta);
        wrong |= order == 1;
        listed += copies;
        *(node ? &c.nodes : cusp ? &c.cusps : &c.others) += copies;
    }
    if (wrong || listed != finite + infinite)
        c.nodes = -1;
    return c;
}

/* The curve F(x, y) = 0 of total degree n, made homogeneous, with no points listed. */
static struct singular_list curve_of_degree(int n, num_f F)
{
    struct singular_list s = {
        .x = variable_f("x"), .y = variable_f("y"), .z = variable_f("z"), .theta = variable_f("theta")};
    s.F = substitute_f(substitute_f(F, s.x, div(s.x, s.z)), s.y, div(s.y, s.z));
    for (int k = 0; k < n; k++)
        s.F = mul(s.F, s.z);
    return s;
}

/* sum c_k x^{e_k} y^{f_k} from triples c, e, f. */
static num_f plane_polynomial(int terms, const int (*t)[3])
{
    num_f x = variable_f("x"), y = variable_f("y"), sum = from_int(0);
    for (int k = 0; k < terms; k++) {
        num_f term = from_int(t[k][0]);
        for (int j = 0; j < t[k][1]; j++)
            term = mul(term, x);
        for (int j = 0; j < t[k][2]; j++)
            term = mul(term, y);
        sum = add(sum, term);
    }
    return sum;
}
#define POLYNOMIAL(...)                                                                                                \
    plane_polynomial(sizeof((const int[][3]){__VA_ARGS__}) / sizeof(int[3]), (const int[][3]){__VA_ARGS__})

/*
:::{claim} smooth_cubic_has_two_separate_parts
:title: The cubic y² = x³ - x has no singular point, and its real points form two parts
:zh: 光滑三次曲线不是有理的
:kind: decision
:types: field
:given: $y^2=x^3-x$
:then: there is no singular point in the complex projective plane; there are real points with $-1<x<0$ and with
  $x>1$, and none with $0<x<1$ or $x<-1$
:method: Elimination as above, and the signs of $x^3-x$.  A rational Bézier curve, continued over all parameters, is
  a connected curve of the projective plane, and cannot contain arcs of both parts.  That no arc of it is rational
  follows from `rational_cubic_has_one_double_point`: by Lüroth's theorem, which is cited, a rational cubic has a
  parametrisation of degree 3.
:control: the cubic $y^2=x^3+x^2$
:::
*/
CLAIM(smooth_cubic_has_two_separate_parts)
{
    num_f F = fault(T, POLYNOMIAL({1, 0, 2}, {-1, 3, 0}, {1, 1, 0}), POLYNOMIAL({1, 0, 2}, {-1, 3, 0}, {-1, 2, 0}));
    struct singular_list s = curve_of_degree(3, F);
    struct census c = census_of(&s);
    about(T, "there is no singular point");
    agree(T, c.nodes == 0 && c.cusps == 0 && c.others == 0);
    poly square = poly_neg(in_one_variable(substitute_f(F, s.y, from_int(0)), s.x)); /* y^2 */
    num_q low = from_int_q(-1), zero = from_int_q(0), high = from_int_q(1);
    about(T, "the sign of y²");
    agree(T, sign_on(square, low, zero, OPEN) == SIGN_POSITIVE);
    agree(T, sign_on(square, zero, high, OPEN) == SIGN_NEGATIVE);
    agree(T, count_roots_above(square, high).distinct == 0 && sign_q(poly_value(square, from_int_q(2))) > 0);
    agree(T, count_roots_below(square, low).distinct == 0 && sign_q(poly_value(square, from_int_q(-2))) < 0);
}

static void list_point(struct singular_list *s, long x, long y, long z)
{
    num_f *P = s->point[s->points];
    P[0] = from_int(x);
    P[1] = from_int(y);
    P[2] = from_int(z);
    s->modulus[s->points++] = s->theta;
}

/* The comparison of the counterexamples: the count is 0 exactly if the curve is rational. */
static void count_against(trial *T, const struct singular_list *s, struct census c, int g, int rational)
{
    show(T, "F", s->F);
    show_text(T, "nodes, cusps, others", "%d, %d, %d", c.nodes, c.cusps, c.others);
    show_text(T, "the count g", "%d", g);
    show_text(T, "rational Bézier curve", "%s", rational ? "yes" : "no");
    about(T, "g = 0 exactly if the curve is rational");
    agree(T, (g == 0) == rational);
}

static int genus_count(int n, int points) { return (n - 1) * (n - 2) / 2 - points; }

/* Is an irreducible cubic rational?  With a singular point it is, by curve_with_a_large_point_is_rational for n = 3;
 * without, it is not, by rational_cubic_has_one_double_point. */
static int is_rational_cubic(struct census c) { return c.nodes + c.cusps + c.others == 1; }

/*
:::{claim} reducible_curve_with_count_zero
:title: A cubic and a line together: the count gives 0, and there is no parametrisation
:zh: 可约曲线的计数为零而无参数表示
:kind: counterexample
:types: field
:given: $y(y^2-x^3+x)=0$, $n=4$
:then: the singular points are exactly the three nodes $(0,0)$ and $(\pm1,0)$, so $g=3-3=0$; but a rational curve
  lies on one of the two factors
:method: The singular points as above.  If $F=fg$ vanishes on a rational curve, $f(R(t))g(R(t))=0$ for all $t$, so
  one factor vanishes on it; the other has points of its own, such as those with $x=2$, which are looked at.  Compared
  is: $g=0$ exactly if the curve is rational.
:control: the factor $y^2-x^3+x$ by itself, whose count is 1
:::
*/
CLAIM(reducible_curve_with_count_zero)
{
    num_f cubic = POLYNOMIAL({1, 0, 2}, {-1, 3, 0}, {1, 1, 0});
    int n = fault(T, 3, 4);
    struct singular_list s = curve_of_degree(n, fault(T, cubic, mul(variable_f("y"), cubic)));
    for (int x = -1; T->faulty && x <= 1; x++)
        list_point(&s, x, 0, 1);
    struct census c = census_of(&s);
    /* Over x = 2 the line has the point y = 0, the cubic the points y^2 = 6: parts that a rational curve cannot join. */
    poly over = in_one_variable(substitute_f(substitute_f(s.F, s.z, from_int(1)), s.x, from_int(2)), s.y);
    poly on_line = poly_variable(), on_cubic = poly_sub(poly_mul(on_line, on_line), poly_constant(from_int_q(6)));
    int parts = poly_divides(on_line, over) + poly_divides(on_cubic, over);
    int rational = parts == 1 && is_rational_cubic(c);
    if (c.nodes == fault(T, 0, 3) && c.cusps + c.others == 0 && parts > 0)
        count_against(T, &s, c, genus_count(n, c.nodes), rational);
}

/* Is the determinant (3.4.1) of the points with numerators X/unit, Y/unit and weights w/unit a constant times F? */
static int is_the_curve(int n, const int X[], const int Y[], const int w[], num_f F)
{
    num_f R[10], weight[5], quotient;
    for (int i = 0; i <= n; i++) {
        weight[i] = from_int(w[i]);
        R[2 * i] = from_ratio(X[i], w[i]);
        R[2 * i + 1] = from_ratio(Y[i], w[i]);
    }
    quotient = div(implicit_value_f(n, R, weight, variable_f("x"), variable_f("y")), F);
    return is_constant_f(quotient, NULL) && !is_zero_f(quotient);
}

/*
:::{claim} conic_without_real_points
:title: The conic x² + y² + 1 = 0 has count 0 and no real point
:zh: 无实点的二次曲线
:kind: counterexample
:types: field
:given: $x^2+y^2+1=0$, $n=2$
:then: there is no singular point, $g=0$, but $F\ge1$ for real $x,y$, so it is no Bézier curve
:method: The singular points as above; $F$ has only positive coefficients and even powers.  Compared is: $g=0$
  exactly if there is a real parametrisation.
:control: $x^2+y^2-1=0$, the curve of the points $(1,0),(1,1),(0,1)$ with weights $1,1,2$
:::
*/
CLAIM(conic_without_real_points)
{
    num_f F = POLYNOMIAL({1, 2, 0}, {1, 0, 2}, {fault(T, -1, 1), 0, 0});
    struct singular_list s = curve_of_degree(2, F);
    struct census c = census_of(&s);
    static const int X[3] = {1, 1, 0}, Y[3] = {0, 1, 2}, w[3] = {1, 1, 2};
    int rational = is_the_curve(2, X, Y, w, F), definite = coefficients_sign_f(F) == 1;
    if (c.nodes == 0 && c.cusps + c.others == 0 && rational != definite)
        count_against(T, &s, c, genus_count(2, 0), rational);
}

/*
:::{claim} rational_quartic_with_a_triple_point
:title: A quartic with one triple point is rational, though the count gives 3
:zh: 含三重点的有理四次曲线
:kind: counterexample
:types: field
:given: $y^3-3x^2y+x^4=0$, $n=4$; the curve $(3t-t^3,3t^2-t^4)$
:then: the only singular point is the origin, where three real tangents differ, so $d=s=0$ and $g=3$; yet the curve is a
  polynomial Bézier curve of degree 4
:method: The singular points as above; the equation is the determinant (3.4.1) of the Bézier points of the curve.
  Compared is: $g=0$ exactly if the curve is rational.
:control: the triple point counted as 3
:::
*/
CLAIM(rational_quartic_with_a_triple_point)
{
    num_f F = POLYNOMIAL({1, 0, 3}, {-3, 2, 1}, {1, 4, 0});
    struct singular_list s = curve_of_degree(4, F);
    list_point(&s, 0, 0, 1);
    struct census c = census_of(&s);
    num_q tangents[4] = {from_int_q(0), from_int_q(-3), from_int_q(0), from_int_q(1)}; /* y^3 - 3 x^2 y at x = 1 */
    int three = count_roots_line(poly_from_q(4, tangents)).distinct == 3;
    static const int X[5] = {0, 3, 6, 8, 8}, Y[5] = {0, 0, 2, 6, 8}, w[5] = {4, 4, 4, 4, 4};
    if (three && c.nodes == 0 && c.cusps == 0 && c.others == 1)
        count_against(T, &s, c, genus_count(4, fault(T, 3, 0)), is_the_curve(4, X, Y, w, F));
}

/*
:::{claim} rational_quartic_with_a_higher_cusp
:title: A quartic with one double point is rational, though the count gives 2
:zh: 含高阶尖点的有理四次曲线
:kind: counterexample
:types: field
:given: $(y-x^2)^2=xy^3$, $n=4$; the curve $(\frac{t^2}{1+t^3},\frac{t^4}{1+t^3})$
:then: the only singular point is the origin, a double point, neither a node nor an ordinary cusp; counted once it
  gives $g=2$; yet the curve is a rational Bézier curve of degree 4
:method: As for the triple point.  On the curve $x$ has order 2 and $y-x^2$ order 7 in $t$, so
  $\delta=\frac{(2-1)(7-1)}2=3$: two more double points are infinitely near.
:control: the point counted as 3
:::
*/
CLAIM(rational_quartic_with_a_higher_cusp)
{
    num_f F = POLYNOMIAL({1, 0, 2}, {-2, 2, 1}, {1, 4, 0}, {-1, 1, 3});
    struct singular_list s = curve_of_degree(4, F);
    list_point(&s, 0, 0, 1);
    struct census c = census_of(&s);
    int node, cusp, order = order_at(&s, 0, &node, &cusp);
    num t = variable_f("t"), tt = mul(t, t), power = mul(mul(tt, tt), mul(tt, t)), w1 = add(from_int(1), mul(t, tt));
    num difference = sub(mul(mul(tt, tt), w1), mul(tt, tt)); /* (y - x^2) (1 + t^3)^2 */
    int seven = is_zero_f(sub(difference, power));
    static const int X[5] = {0, 0, 2, 6, 12}, Y[5] = {0, 0, 0, 0, 12}, w[5] = {12, 12, 12, 15, 24};
    if (seven && order == 2 && c.nodes == 0 && c.cusps == 0 && c.others == 1)
        count_against(T, &s, c, genus_count(4, fault(T, 3, 1)), is_the_curve(4, X, Y, w, F));
}

/*
:::{claim} cuspidal_cubic_at_infinity
:title: The curve y = x³ has its cusp at infinity
:zh: y=x³ 的尖点在无穷远
:kind: counterexample
:types: field
:given: $y=x^3$, $n=3$, the curve $(t,t^3)$
:then: no finite point is singular, so the finite points give $g=1$; yet it is a polynomial Bézier curve
:method: The only singular point is $(0:1:0)$, a cusp.  Compared is: $g=0$ exactly if the curve is rational.
:control: the point at infinity counted
:::
*/
CLAIM(cuspidal_cubic_at_infinity)
{
    num_f F = POLYNOMIAL({1, 0, 1}, {-1, 3, 0});
    struct singular_list s = curve_of_degree(3, F);
    list_point(&s, 0, 1, 0);
    struct census c = census_of(&s);
    static const int X[4] = {0, 1, 2, 3}, Y[4] = {0, 0, 0, 3}, w[4] = {3, 3, 3, 3};
    if (c.nodes == 0 && c.cusps == 1 && c.others == 0)
        count_against(T, &s, c, genus_count(3, fault(T, 1, finite_singular_points(&s))), is_the_curve(3, X, Y, w, F));
}

/*
:::{claim} cusp_counted_twice
:title: Counted as double point and as cusp, the cusp of y² = x³ gives g = -1
:zh: 尖点重复计数
:kind: counterexample
:types: field
:given: $y^2=x^3$, $n=3$, with one singular point, a cusp; $d=1$, $s=1$
:then: $g=-1$, although the curve $(t^2,t^3)$ is rational
:method: The singular points as above.  Compared is: $g=0$ exactly if the curve is rational.
:control: $d=0$, $s=1$
:::
*/
CLAIM(cusp_counted_twice)
{
    num_f F = POLYNOMIAL({1, 0, 2}, {-1, 3, 0});
    struct singular_list s = curve_of_degree(3, F);
    list_point(&s, 0, 0, 1);
    struct census c = census_of(&s);
    static const int X[4] = {0, 0, 1, 3}, Y[4] = {0, 0, 0, 3}, w[4] = {3, 3, 3, 3};
    if (c.nodes == 0 && c.cusps == 1 && c.others == 0)
        count_against(T, &s, c, genus_count(3, c.cusps + fault(T, 0, 1)), is_the_curve(3, X, Y, w, F));
}

/*
:::{claim} printed_degree_spoils_the_genus
:title: x²y + xy² + 1 = 0 has the printed sum for degree 2, and has genus 1
:zh: 按所印定义的次数使判据失效
:kind: counterexample
:types: field
:given: $x^2y+xy^2+1=0$, whose exponents are at most 2
:then: with $n=2$ the count is 0; but it is a cubic without singular points, and not rational
:method: The singular points as above.  Whether the cubic is rational is read off their number, as
  `rational_cubic_has_one_double_point` allows; without any it is irreducible, because two parts would have a common
  point.  Compared is: $g=0$ exactly if the curve is rational.
:control: the total degree $n=3$
:::
*/
CLAIM(printed_degree_spoils_the_genus)
{
    num_f F = POLYNOMIAL({1, 2, 1}, {1, 1, 2}, {1, 0, 0});
    struct singular_list s = curve_of_degree(3, F);
    struct census c = census_of(&s);
    int degree = total_degree(F, s.x, s.y), n = fault(T, degree, 2);
    if (degree == 3 && c.nodes >= 0 && degree_f(F, s.x) <= 2 && degree_f(F, s.y) <= 2)
        count_against(T, &s, c, genus_count(n, c.nodes + c.cusps), is_rational_cubic(c));
}

/*
:::{statement} wang-ch3:thm-3.4.3-genus
:title: The genus as the count (n-1)(n-2)/2 - d - s
:zh: 亏格的计数公式
:printed: g=\frac{(n-1)(n-2)}2-d-s
:definition: yes
:checked-by: curves_that_fit_the_theorem large_point_takes_all_double_points
:figure: genus_zero

$\frac{(n-1)(n-2)}2$ is the number of double points that an irreducible curve of degree $n$ can have; the genus says
how many are missing.  The imaginary points count, as the source says, and so do those at infinity: the lemniscate
has only one finite double point.  A point of higher multiplicity counts for several double points.
:::

:::{claim} curves_that_fit_the_theorem
:title: Four curves of genus 0, their singular points counted and their parametrisations checked
:zh: 符合定理的四条曲线
:kind: decision
:types: field
:given: the nodal cubic $y^2=x^2(x+1)$, the cuspidal cubic $y^2=x^3$, the lemniscate $(x^2+y^2)^2=x^2-y^2$ and the
  cardioid $(x^2+y^2)^2+4x(x^2+y^2)=4y^2$
:then: they have exactly one node; one cusp; three nodes, two of them the imaginary points $(1:\pm\mathrm i:0)$ at
  infinity; three cusps, two of them these same points; so $g=0$; and they are the curves of rational Bézier points
  and weights whose determinant (3.4.1) is a constant times their equation
:method: The singular points are counted by elimination and verified one by one, the imaginary ones modulo
  $\theta^2+1$.  The determinant is computed from the Bézier points and divided by the equation.
:control: the imaginary points left out
:::
*/
/* The two points (1 : ±i : 0). */
static void list_circular_points(struct singular_list *s)
{
    num_f *P = s->point[s->points];
    P[0] = from_int(1);
    P[1] = s->theta;
    P[2] = from_int(0);
    s->modulus[s->points++] = add(mul(s->theta, s->theta), from_int(1));
}

CLAIM(curves_that_fit_the_theorem)
{
    num_f node = POLYNOMIAL({1, 0, 2}, {-1, 3, 0}, {-1, 2, 0}), cusp = POLYNOMIAL({1, 0, 2}, {-1, 3, 0});
    num_f lemniscate = POLYNOMIAL({1, 4, 0}, {2, 2, 2}, {1, 0, 4}, {-1, 2, 0}, {1, 0, 2});
    num_f cardioid = POLYNOMIAL({1, 4, 0}, {2, 2, 2}, {1, 0, 4}, {4, 3, 0}, {4, 1, 2}, {-4, 0, 2});
    const struct {
        num_f F;
        int n, nodes, cusps, X[5], Y[5], w[5];
    } curves[4] = {
        {node, 3, 1, 0, {-3, -3, -2, 0}, {0, -1, -2, 0}, {3, 3, 3, 3}},
        {cusp, 3, 0, 1, {0, 0, 1, 3}, {0, 0, 0, 3}, {3, 3, 3, 3}},
        {lemniscate, 4, 3, 0, {0, 1, 2, 4, 8}, {0, 1, 2, 2, 0}, {4, 4, 4, 4, 8}},
        {cardioid, 4, 0, 3, {0, 0, 2, 6, 0}, {0, 0, 0, 6, 24}, {3, 3, 4, 6, 12}},
    };
    for (int k = 0; k < 4; k++) {
        struct singular_list s = curve_of_degree(curves[k].n, curves[k].F);
        list_point(&s, 0, 0, 1);
        if (fault(T, curves[k].n == 4, 0))
            list_circular_points(&s);
        struct census c = census_of(&s);
        about(T, "nodes and cusps, and g = 0");
        agree(T, c.nodes == curves[k].nodes && c.cusps == curves[k].cusps && c.others == 0);
        agree(T, genus_count(curves[k].n, c.nodes + c.cusps) == 0);
        about(T, "the equation of the Bézier curve");
        agree(T, is_the_curve(curves[k].n, curves[k].X, curves[k].Y, curves[k].w, curves[k].F));
    }
}

/*
:::{claim} large_point_takes_all_double_points
:title: An ordinary point of multiplicity n-1 counts for all (n-1)(n-2)/2 double points
:zh: n-1 重点的 δ 等于 (n-1)(n-2)/2
:kind: decision
:types: field
:given: $F=f_{n-1}(x,y)+f_n(x,y)$, all coefficients of both forms variables
:then: $\operatorname{Res}_y(F,F_y)$, a polynomial in $x$, has at $x=0$ a zero of the order $(n-1)(n-2)$, so that
  $\delta=\frac{(n-1)(n-2)}2$ for the origin, and $g=0$
:method: The resultant is computed and its lowest power of $x$ looked for.  Cited is that this order is the number of
  common points of $F=0$ and $F_y=0$ over $x=0$, and that at a point with different tangents, none of them vertical,
  the number is $2\delta$ [milnor-1968].  The other point over $x=0$
  is simple, for $F(0,y)$ has the terms $y^{n-1}$ and $y^n$.
:degrees: 3..5
:control: a term $y^{n-2}$ added, which makes it a point of multiplicity $n-2$
:::
*/
CLAIM(large_point_takes_all_double_points)
{
    int n = T->degree, order = 0;
    num x = variable_f("x"), y = variable_f("y"), F = from_int(0);
    for (int m = fault(T, n - 1, n - 2); m <= n; m++)
        for (int k = m == n - 2 ? m : 0; k <= m; k++) { /* x^{m-k} y^k; of degree n-2 only the last */
            num term = unknown(T, m == n ? "b" : m == n - 1 ? "a" : "c", k);
            for (int j = 0; j < m; j++)
                term = mul(term, j < k ? y : x);
            F = add(F, term);
        }
    num D = resultant_by_f(F, derivative_f(F, y), y);
    while (order < degree_f(D, x) && is_zero_f(coefficient_f(D, x, order)))
        order++;
    about(T, "the order of the zero");
    agree(T, !is_zero_f(D) && order == (n - 1) * (n - 2));
}
#endif

#include "chapters/judge/claims_off.h"
