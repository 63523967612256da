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

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"
#include "chapters/rational-bezier/plane-polynomials.h"

/*
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
:printed: A plane algebraic curve of degree $n$ can be written as a rational Bézier curve if and only if its genus
  $g=\frac{(n-1)(n-2)}2-d-s$ is 0, where $d$ and $s$ are the numbers of the double points and of the cusps that it contains, imaginary points
  included.
:meant: the usual formula of the genus | The points are counted in the complex projective plane, a double point with two tangents in $d$, a cusp in $s$; $n$ is the
  degree of the curve; that it can be written as a rational Bézier curve says that it has arcs, and that short ones are such curves.  With this the counterexamples stand.
:class: missing-hypothesis
:refuted-by: reducible_curve_with_count_zero conic_without_real_points rational_quartic_with_a_triple_point
  rational_quartic_with_a_higher_cusp
:reading: cuspidal_cubic_at_infinity | only finite points are counted; already $y=x^3$ is against it
:reading: cusp_counted_twice | a cusp, being a double point, is counted in $d$ and in $s$; already $y^2=x^3$ is
  against it
:reading: printed_degree_spoils_the_genus | $n$ is the range of the sum printed in definition 3.4.1; $x^2y+xy^2+1=0$ is
  against it
:reading: isolated_point_is_on_no_arc | all real points of the curve are on the Bézier curve; but an
  isolated point is on no arc
:corrected: let a real plane curve of degree $n\ge2$ be irreducible over $\mathbb C$ and have a simple real point. For
  $n\le3$ its short regular arcs are rational Bézier curves of degree $n$ if and only if it has $\frac{(n-1)(n-2)}2$
  singular points in the complex projective plane; for $n\ge4$ they are if it has a point of multiplicity $n-1$, and
  for $n=4$ also if it has three double points
:corrected-by: lines_through_a_large_point_parametrize_the_curve rational_cubic_has_one_double_point
  quartic_with_three_double_points_is_rational
:confirmed-by: curve_with_a_large_point_is_rational curves_that_fit_the_theorem
:argued: | From the identities to the statement on arcs the methods of the claims argue: a map brings the singular
  points to their places, a conic has a quadratic parametrization and no singular point.
:figure: genus_extra
:striking: 5

The correction says no more than what is shown here: an identity for each of its parts, and the argument from there
in the method of the claim.  It leaves out $n=1$: a segment of any line is a rational Bézier curve, and the count is 0.
:::

That a curve is rational is shown by giving the parametrisation.  A line through a point of multiplicity $n-1$ meets
the curve in one further point, which is therefore a rational function of the slope.  This settles conics and singular
cubics.  For a quartic with three double points lines do not suffice; the quadratic map $(x:y:z)\mapsto(yz:zx:xy)$
makes a conic of it.  For cubics the other direction is within reach as well.

:::{claim} lines_through_a_large_point_parametrize_the_curve
:title: The lines through a point of multiplicity n-1 parametrize a curve of degree n, for every n
:zh: 过 n-1 重点的直线束给出 n 次曲线的有理参数化(任意次数)
:given: $F=f_{n-1}(x,y)+f_n(x,y)$ with any forms of degrees $n-1$ and $n\ge2$; $a=f_{n-1}(1,t)$, $b=f_n(1,t)\ne0$; a term $cx^{m-k}y^k$ of a form of degree $m$, with $V=x^k$ and $x^{m-k}=U/V$
:harmless: $b=f_n(1,t)\ne0$ | where $b=0$ a point with $x\ne0$ on the line $y=tx$ has $a=0$, too, and $F$ contains the line
:then: at $y=tx$ the term is $Uct^k$ with $U=x^m$; so $F(x,tx)=x^{n-1}(a+xb)$, which is 0 for $x=-\frac ab$
:method: Identities in $x$, $t^k$, $V$, $U$, $c$, $a$ and $b$, in every degree.  Where $F$ is irreducible neither form is 0 and all its points but those at the origin
  and on the line $x=0$ have such a $t=y/x$; there $b\ne0$, for with $b=0$ also $a=0$, and $F$ would contain the line $y=tx$.  With $n=2$ it is every conic with a simple real point, with $n=3$ every cubic with a double point.
:degrees: all from 2
:over: U V P x: -; a# b# c#: coefficients
:control: the sign of $x$
:::
*/
CLAIM(lines_through_a_large_point_parametrize_the_curve)
{
    num a = unknown(T, "a", 0), b = positive(T, "b", 0), c = unknown(T, "c", 0), U = positive(T, "U", 0);
    num V = positive(T, "V", 0), P = unknown(T, "P", 0); /* P = t^k */
    about(T, "one term");
    same(T, mul(c, mul(div(U, V), mul(P, V))), mul(U, mul(c, P)));
    num x = div(fault(T, neg(a), a), b);
    about(T, "F on the curve");
    vanishes(T, mul(U, add(a, mul(x, b))));
}

/*
The same by the coefficients of forms of low degree:

:::{claim} curve_with_a_large_point_is_rational
:title: A curve of degree n with a point of multiplicity n-1 is rational
:zh: 含 n-1 重点的 n 次曲线是有理的
:given: $F=f_{n-1}(x,y)+f_n(x,y)$ with any forms of degrees $n-1$ and $n\ge2$, a curve with a point of multiplicity
  $n-1$ in the origin; $f_n(1,t)\ne0$
:harmless: $f_n(1,t)\ne0$ | where it is 0 a point with $x\ne0$ on the line $y=tx$ has $f_{n-1}(1,t)=0$, too, and $F$ contains the line
:then: $x=-f_{n-1}(1,t)/f_n(1,t)$, $y=tx$ satisfies $F=0$
:method: Every coefficient and $t$ are variables; the forms are added up term by term at $(x,y)$.  Where $F$ is
  irreducible neither form is 0 and all its points but those at the origin and on the line $x=0$ have such a $t=y/x$.
  With $n=2$ it is every conic with a simple real point, with $n=3$ every cubic with a double point.
:degrees: 2..6 sampled 12
:argued: every n | $F(x,tx)=x^{n-1}(f_{n-1}(1,t)+xf_n(1,t))$, in every degree.
:over: a# b#: coefficients
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
:scope: every quartic with three double points (n = 4)
:over: c#: coefficients
:control: a term $x^4$ added, with which $(1:0:0)$ is no point of the curve
:::
*/
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
            image = add(image, mul(c, mul(G(power)(yz, i), mul(G(power)(zx, j), G(power)(xy, k)))));
            if (allowed)
                Q = add(Q, mul(c, mul(G(power)(x, 2 - i), mul(G(power)(y, 2 - j), G(power)(z, 2 - k)))));
        }
    /* F(yz, zx, xy) = x² y² z² Q(x, y, z) */
    same(T, image, mul(G(power)(mul(x, yz), 2), Q));
}

/*
:::{claim} rational_cubic_has_one_double_point
:title: Every rational cubic has exactly one double point
:zh: 有理三次曲线恰有一个二重点
:given: a cubic $(1+at^3:t+bt^3:t^2+ct^3)$, to which a projective map and a change of the parameter bring every curve
  $(A:B:W)$ with independent $A,B,W$
:let: $q(t)=(ac-b^2)t^2+(a+bc)t-(b+c^2)$, $s$ and $s'$ its zeros, $\infty$ among them where a leading coefficient of $q$ is 0
:then: the points of the parameters $s$ and $s'$ are one; the linear form $L$ with the values $a,b,c,-1$ at $1,t,t^2,t^3$ is 0 for $A$, $B$ and $W$; $L(p)$ and $L(tp)$ for
  $p=p_0+p_1t+p_2t^2$ are the products of $(p_0,p_1,p_2)$ with $(a,b,c)$ and $(b,c,-1)$, whose cross product is $q$; and for $(a,b,c)=-c\,(b,c,-1)$ it is $A=(1+ct)(1-ct+c^2t^2)$,
  $B=t(1+ct)(1-ct)$, $W=t^2(1+ct)$
:method: The three minors of the two points, divided by $s-s'$, are symmetric; written in $\sigma=s+s'$ and
  $\pi=ss'$, the coefficients of $q$ inserted, they vanish identically in $a,b,c$; multiplied by the square of the
  leading coefficient of $q$ they are polynomials, so $\infty$ is included.  There is no other pair: a
  relation $\lambda P(s)+\mu P(s')=0$ is a linear form on cubic polynomials that kills $A,B,W$, so it is a multiple
  of $L$; it is 0 for $p=(t-s)(t-s')$ and $tp$, and $q$ is up to a
  factor the only such polynomial when the vectors $(a,b,c)$ and $(b,c,-1)$ are independent.  They are dependent
  exactly for $q=0$, when $1+ct$ divides $A$, $B$ and $W$ and the curve is a conic.  For $s=s'$ the divided minors
  say that $P$ and $P'$ are parallel there: a cusp.  So $d+s=1$, $g=0$, for $n=3$.
:scope: every rational cubic (n = 3)
:over: a# b# c#: coefficients; t: -
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
    const num form[4] = {a, b, c, neg(one)}, second[3] = {b, c, neg(one)};
    about(T, "the linear form that is 0 for A, B and W");
    for (int k = 0; k < 3; k++) {
        num value = zero;
        for (int j = 0; j < 4; j++)
            value = add(value, mul(P[k][j], form[j]));
        vanishes(T, value);
    }
    num only[3], t = parameter(T, "t"), ct = mul(c, t), tt = mul(t, t), cube = mul(t, tt), more = add(one, ct);
    G(cross3)(abc, second, only);
    about(T, "the only polynomial, up to a factor");
    for (int k = 0; k < 3; k++)
        same(T, only[k], q[k]);
    about(T, "dependent vectors: the common factor of A, B and W");
    num cc = mul(c, c);
    same(T, add(one, mul(mul(c, cc), cube)), mul(more, add(sub(one, ct), mul(ct, ct))));
    same(T, sub(t, mul(cc, cube)), mul(t, mul(more, sub(one, ct))));
    same(T, add(tt, mul(c, cube)), mul(tt, more));
}

#if FIELD
/* A plane curve by its homogeneous polynomial F in the variables x, y, z, and the points where it is said to be
 * singular: the coordinates of point k may contain theta, which stands for each of the zeros of modulus[k]. */
struct singular_list {
    num_f F, x, y, z, theta;
    int n, points; /* the degree, and how many points there are in the list */
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

/* The curve F(x, y) = 0, made homogeneous in its total degree, with no points listed. */
static struct singular_list curve_of(num_f F)
{
    struct singular_list s = {
        .x = variable_f("x"), .y = variable_f("y"), .z = variable_f("z"), .theta = variable_f("theta")};
    s.n = total_degree(F, s.x, s.y);
    s.F = substitute_f(substitute_f(F, s.x, div(s.x, s.z)), s.y, div(s.y, s.z));
    for (int k = 0; k < s.n; k++)
        s.F = mul(s.F, s.z);
    return s;
}

static void found_census(trial *T, struct census c)
{
    found_points(T, "nodes, cusps, others", 3, 1, (num_f[]){from_int(c.nodes), from_int(c.cusps), from_int(c.others)});
}

/*
:::{claim} smooth_cubic_has_two_separate_parts
:title: The cubic y² = x³ - x has no singular point, and its real points form two parts
:zh: 三次曲线 y²=x³-x 无奇点, 实点分为两支
:kind: decision
:types: field
:data: α, i, j = (1,0,2) (-1,3,0) (1,1,0); x = -1 0 1
:instead: α, i, j = (1,0,2) (-1,3,0) (-1,2,0)
:result: F = "-x^3+x+y^2"; nodes, cusps, others = 0 0 0
:given: the cubic $F=0$ by its terms $\alpha x^iy^j$, and the three abscissas $x_0<x_1<x_2$ with $y=0$
:then: there is no singular point in the complex projective plane; there are real points with $x_0<x<x_1$ and with
  $x>x_2$, and none with $x_1<x<x_2$ or $x<x_0$
:method: The singular points are counted by elimination, also the imaginary ones; and the signs of $y^2$ as a polynomial in $x$.  A rational Bézier curve, continued over all
  parameters, is a connected curve of the projective plane, and cannot contain arcs of both parts.  That no arc of it is
  rational follows from `rational_cubic_has_one_double_point`: by Lüroth's theorem, which is cited, a rational cubic has a
  parametrisation of degree 3.
:control: the nodal cubic $y^2=x^3+x^2$
:::
*/
CLAIM(smooth_cubic_has_two_separate_parts)
{
    num_f F = given_polynomial(T, "α, i, j", 3), end[3];
    given_points(T, "x", 3, 1, end);
    struct singular_list s = curve_of(F);
    struct census c = census_of(&s);
    num_q low, middle, high, one = from_int_q(1);
    is_constant_f(end[0], &low);
    is_constant_f(end[1], &middle);
    is_constant_f(end[2], &high);
    found_text(T, "F", to_string_f(F));
    found_census(T, c);
    about(T, "there is no singular point");
    agree(T, c.nodes == 0 && c.cusps == 0 && c.others == 0);
    poly square = poly_neg(in_one_variable(substitute_f(F, s.y, from_int(0)), s.x)); /* y^2 */
    about(T, "the sign of y²");
    agree(T, sign_on(square, low, middle, OPEN) == SIGN_POSITIVE);
    agree(T, sign_on(square, middle, high, OPEN) == SIGN_NEGATIVE);
    agree(T, count_roots_above(square, high).distinct == 0 && sign_q(poly_value(square, add_q(high, one))) > 0);
    agree(T, count_roots_below(square, low).distinct == 0 && sign_q(poly_value(square, sub_q(low, one))) < 0);
}

/* Lists the points of homogeneous coordinates P[0..3*count), which are all rational. */
static void list_points(struct singular_list *s, int count, const num_f P[])
{
    for (int k = 0; k < count; k++) {
        for (int c = 0; c < 3; c++)
            s->point[s->points][c] = P[3 * k + c];
        s->modulus[s->points++] = s->theta;
    }
}

/* The curve F = 0, with the points listed first that are given as P, one by its homogeneous coordinates. */
static struct singular_list curve_with_point(trial *T, num_f F, num_f P[3])
{
    struct singular_list s = curve_of(F);
    given_points(T, "P", 1, 3, P);
    list_points(&s, 1, P);
    return s;
}

/* The comparison of the counterexamples: the count is 0 exactly if the curve is rational. */
static void count_against(trial *T, const struct singular_list *s, struct census c, int g, int rational)
{
    found_whole(T, "n", s->n);
    found_text(T, "F", to_string_f(substitute_f(s->F, s->z, from_int(1))));
    found_census(T, c);
    found_whole(T, "g", g);
    found_text(T, "rational", rational ? "yes" : "no");
    about(T, "g = 0 exactly if the curve is rational");
    agree(T, (g == 0) == rational);
}

static int genus_count(int n, int points) { return (n - 1) * (n - 2) / 2 - points; }

/* Is an irreducible cubic rational?  With a singular point it is, by curve_with_a_large_point_is_rational for n = 3;
 * without, it is not, by rational_cubic_has_one_double_point. */
static int is_rational_cubic(struct census c) { return c.nodes + c.cusps + c.others == 1; }

/*
Now the theorem as it is printed is tried.  A reducible curve and one without real points have the count 0 and are not
rational; a point of higher multiplicity or a higher cusp is counted too low, so that a rational curve has a positive
count.  Then the readings follow: points at infinity, the cusp counted twice, another meaning of $n$.  In each example
the list of singular points is found by elimination and not taken on trust.

:::{claim} reducible_curve_with_count_zero
:title: A cubic and a line together: the count gives 0, and there is no parametrisation
:zh: 可约曲线的计数为零而无参数表示
:kind: counterexample
:types: field
:data: cubic = (1,0,2) (-1,3,0) (1,1,0); line = (1,0,1); P = (-1,0,1) (0,0,1) (1,0,1); x = 2
:instead: line = (1,0,0)
:result: parts over x = 2; n = 4; F = "-x^3*y+x*y+y^3"; nodes, cusps, others = 3 0 0; g = 0; rational = "no"
:given: a smooth cubic and a line by their terms $(\alpha,i,j)$, $\alpha x^iy^j$, and $F$, the product of the two;
  three points $P$ in homogeneous coordinates, and an abscissa $x$; parts over $x$ are the factors with points there
:then: the singular points are exactly the three nodes $P$, so $g=0$; but a rational curve lies on one of the two factors
:method: The singular points are counted by elimination.  If $F=fg$ vanishes on a rational curve, $f(R(t))g(R(t))=0$ for all $t$, so
  one factor vanishes on it; the other has points of its own, such as those over $x$, which are looked at.  Nor is an arc of the cubic rational, by
  `rational_cubic_has_one_double_point` and Lüroth's theorem, which is cited: all singular points of $F$ are nodes on the line, so it has none.  Compared
  is: $g=0$ exactly if the curve is rational.
:control: the cubic by itself, whose count is 1
:::
*/
CLAIM(reducible_curve_with_count_zero)
{
    num factor[2] = {given_polynomial(T, "cubic", 3), given_polynomial(T, "line", 1)}, P[9],
        F = mul(factor[0], factor[1]);
    given_points(T, "P", 3, 3, P);
    num x = given(T, "x");
    struct singular_list s = curve_of(F);
    if (T->faulty)
        list_points(&s, 3, P);
    struct census c = census_of(&s);
    /* The factors with points over x: parts that a rational curve cannot join. */
    poly over = in_one_variable(substitute_f(F, s.x, x), s.y);
    int parts = 0;
    for (int k = 0; k < 2; k++) {
        poly part = in_one_variable(substitute_f(factor[k], s.x, x), s.y);
        parts += poly_degree(part) > 0 && poly_divides(part, over);
    }
    found_whole(T, "parts over x", parts);
    int rational = parts == 1 && is_rational_cubic(c);
    if (c.nodes == s.points && c.cusps + c.others == 0 && parts > 0)
        count_against(T, &s, c, genus_count(s.n, c.nodes), rational);
}

/* Is the determinant (3.4.1) of the points R with the weights w a constant times F? */
static int is_the_curve(int n, const num_f R[], const num_f w[], num_f F)
{
    num_f quotient = div(implicit_value_f(n, R, w, variable_f("x"), variable_f("y")), F);
    return is_constant_f(quotient, NULL) && !is_zero_f(quotient);
}

/* The same for the data R and ω of the claim, n <= 4. */
static int is_the_given_curve(trial *T, int n, num_f F)
{
    num_f R[10], w[5];
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    return is_the_curve(n, R, w, F);
}

/*
:::{claim} conic_without_real_points
:title: The conic x² + y² + 1 = 0 has count 0 and no real point
:zh: 无实点的二次曲线
:kind: counterexample
:types: field
:data: α, i, j = (1,2,0) (1,0,2) (1,0,0); R = (1,0) (1,1) (0,1); ω = 1 1 2
:instead: α, i, j = (1,2,0) (1,0,2) (-1,0,0)
:result: n = 2; F = "x^2+y^2+1"; nodes, cusps, others = 0 0 0; g = 0; rational = "no"
:given: the conic $F=0$ by its terms $\alpha x^iy^j$; and points $R$ with weights $\omega$ of the unit circle
:then: there is no singular point, $g=0$, but $F\ge1$ for real $x,y$, so it is no Bézier curve
:method: The singular points are counted by elimination; $F$ has only positive coefficients and even powers.  Compared is: $g=0$
  exactly if there is a real parametrisation.
:control: the last coefficient with the other sign: the unit circle, which is the curve of the points $R$
:::
*/
CLAIM(conic_without_real_points)
{
    num_f F = given_polynomial(T, "α, i, j", 3);
    struct singular_list s = curve_of(F);
    struct census c = census_of(&s);
    int rational = is_the_given_curve(T, 2, F), definite = coefficients_sign_f(F) == 1;
    if (c.nodes == 0 && c.cusps + c.others == 0 && rational != definite)
        count_against(T, &s, c, genus_count(s.n, 0), rational);
}

/*
:::{claim} rational_quartic_with_a_triple_point
:title: A quartic with one triple point is rational, though the count gives 3
:zh: 含三重点的有理四次曲线
:kind: counterexample
:types: field
:data: α, i, j = (1,0,3) (-3,2,1) (1,4,0); P = (0,0,1); R = (0,0) (3/4,0) (3/2,1/2) (2,3/2) (2,2); ω = 1 1 1 1 1
:result: real tangents = 3; n = 4; F = "x^4-3*x^2*y+y^3"; nodes, cusps, others = 0 0 1; g = 3; rational = "yes"
:given: the quartic $F=0$ by its terms $\alpha x^iy^j$, the point $P$ in homogeneous coordinates, and the points $R$
  of the curve $(3t-t^3,3t^2-t^4)$ with equal weights
:then: the only singular point is $P$, where three real tangents differ, so $d=s=0$ and $g=3$; yet the curve is a
  polynomial Bézier curve of degree $n$
:method: The singular points are counted by elimination; the tangents are the zeros of the terms of lowest degree; the equation is the
  determinant (3.4.1) of the Bézier points of the curve.  Compared is: $g=0$ exactly if the curve is rational.
:control: the triple point counted as three double points
:::
*/
CLAIM(rational_quartic_with_a_triple_point)
{
    num_f F = given_polynomial(T, "α, i, j", 3), P[3], t = variable_f("t");
    struct singular_list s = curve_with_point(T, F, P);
    struct census c = census_of(&s);
    int rational = is_the_given_curve(T, 4, F);
    /* F(t, t y) = t^3 f_3(1, y) + ... */
    num_f along = substitute_f(substitute_f(F, s.y, mul(t, s.y)), s.x, t);
    int tangents = count_roots_line(in_one_variable(coefficient_f(along, t, 3), s.y)).distinct;
    found_whole(T, "real tangents", tangents);
    if (tangents == 3 && c.nodes == 0 && c.cusps == 0 && c.others == 1)
        count_against(T, &s, c, genus_count(s.n, fault(T, tangents * (tangents - 1) / 2, 0)), rational);
}

/*
:::{claim} rational_quartic_with_a_higher_cusp
:title: A quartic with one double point is rational, though the count gives 2
:zh: 含高阶尖点的有理四次曲线
:kind: counterexample
:types: field
:data: α, i, j = (1,0,2) (-2,2,1) (1,4,0) (-1,1,3); P = (0,0,1); R = (0,0) (0,0) (1/6,0) (2/5,0) (1/2,1/2); ω = 4 4 4 5 8
:result: orders of x, y-x² in t = 2 7; δ = 3; n = 4; F = "x^4-2*x^2*y-x*y^3+y^2"; nodes, cusps, others = 0 0 1; g = 2;
  rational = "yes"
:given: the quartic $F=(y-x^2)^2-xy^3=0$ by its terms $\alpha x^iy^j$, the point $P$ in homogeneous coordinates, and
  points $R$ and weights $\omega$ of the curve $(\frac{t^2}{1+t^3},\frac{t^4}{1+t^3})$
:then: the only singular point is $P$, a double point, neither a node nor an ordinary cusp; counted once it
  gives $g=2$; yet the curve is a rational Bézier curve of degree $n$
:method: The singular points are counted by elimination; the tangents are the zeros of the terms of lowest degree.  From the orders $p$ of $x$ and $q$ of $y-x^2$ in $t$ on the curve follows
  $\delta=\frac{(p-1)(q-1)}2$, which is more than 1: other double points are infinitely near.
:control: the point counted as $\delta$ double points
:::
*/
/* The order in t of the zero of p at t = 0; p is not 0. */
static int order_at_zero(poly p)
{
    int order = 0;
    for (; poly_divides(poly_variable(), p); order++)
        p = poly_quotient(p, poly_variable());
    return order;
}

CLAIM(rational_quartic_with_a_higher_cusp)
{
    enum { n = 4 };
    num_f F = given_polynomial(T, "α, i, j", 4), P[3], R[2 * n + 2], w[n + 1];
    struct singular_list s = curve_with_point(T, F, P);
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    struct census c = census_of(&s);
    int node, cusp, order = order_at(&s, 0, &node, &cusp);
    num_q numerator[3][n + 1]; /* X, Y and W of the curve, in Bernstein form */
    for (int i = 0; i <= n; i++) {
        is_constant_f(mul(w[i], R[2 * i]), &numerator[0][i]);
        is_constant_f(mul(w[i], R[2 * i + 1]), &numerator[1][i]);
        is_constant_f(w[i], &numerator[2][i]);
    }
    poly X = poly_from_bernstein(n, numerator[0]), Y = poly_from_bernstein(n, numerator[1]);
    /* y - x² = (Y W - X²)/W² */
    poly difference = poly_sub(poly_mul(Y, poly_from_bernstein(n, numerator[2])), poly_mul(X, X));
    int p = order_at_zero(X), q = order_at_zero(difference), delta = (p - 1) * (q - 1) / 2;
    found_points(T, "orders of x, y-x² in t", 2, 1, (num_f[]){from_int(p), from_int(q)});
    found_whole(T, "δ", delta);
    if (order == 2 && c.nodes == 0 && c.cusps == 0 && c.others == 1)
        count_against(T, &s, c, genus_count(s.n, fault(T, delta, 1)), is_the_curve(n, R, w, F));
}

/*
:::{claim} cuspidal_cubic_at_infinity
:title: The curve y = x³ has its cusp at infinity
:zh: y=x³ 的尖点在无穷远
:kind: counterexample
:types: field
:data: α, i, j = (1,0,1) (-1,3,0); P = (0,1,0); R = (0,0) (1/3,0) (2/3,0) (1,1); ω = 1 1 1 1
:result: finite singular points = 0; n = 3; F = "-x^3+y"; nodes, cusps, others = 0 1 0; g = 1; rational = "yes"
:given: the cubic $F=0$ by its terms $\alpha x^iy^j$, the point $P$ at infinity in homogeneous coordinates, and the points $R$ of the curve
  $(t,t^3)$ with equal weights
:then: no finite point is singular, so the finite points give $g=1$; yet it is a polynomial Bézier curve
:method: The only singular point is $P$, a cusp.  Compared is: $g=0$ exactly if the curve is rational.
:control: the point at infinity counted
:::
*/
CLAIM(cuspidal_cubic_at_infinity)
{
    num_f F = given_polynomial(T, "α, i, j", 2), P[3];
    struct singular_list s = curve_with_point(T, F, P);
    struct census c = census_of(&s);
    int rational = is_the_given_curve(T, 3, F), finite = finite_singular_points(&s);
    found_whole(T, "finite singular points", finite);
    if (c.nodes == 0 && c.cusps == 1 && c.others == 0)
        count_against(T, &s, c, genus_count(s.n, fault(T, 1, finite)), rational);
}

/*
:::{claim} cusp_counted_twice
:title: Counted as double point and as cusp, the cusp of y² = x³ gives g = -1
:zh: 尖点重复计数
:kind: counterexample
:types: field
:data: α, i, j = (1,0,2) (-1,3,0); P = (0,0,1); R = (0,0) (0,0) (1/3,0) (1,1); ω = 1 1 1 1; d = 1
:instead: d = 0
:result: n = 3; F = "-x^3+y^2"; nodes, cusps, others = 0 1 0; g = -1; rational = "yes"
:given: the cubic $F=0$ by its terms $\alpha x^iy^j$, with one singular point $P$, a cusp, which is counted in $s$
  and, with $d$ double points, once more; and the points $R$ of the curve $(t^2,t^3)$ with equal weights
:then: $g=-1$, although the curve is rational
:method: The singular points are counted by elimination.  Compared is: $g=0$ exactly if the curve is rational.
:control: the cusp counted in $s$ alone
:::
*/
CLAIM(cusp_counted_twice)
{
    num_f F = given_polynomial(T, "α, i, j", 2), P[3];
    struct singular_list s = curve_with_point(T, F, P);
    struct census c = census_of(&s);
    int rational = is_the_given_curve(T, 3, F), double_points = given_whole(T, "d");
    if (c.nodes == 0 && c.cusps == 1 && c.others == 0)
        count_against(T, &s, c, genus_count(s.n, c.cusps + double_points), rational);
}

/*
:::{claim} printed_degree_spoils_the_genus
:title: x²y + xy² + 1 = 0 has the printed sum for degree 2, and is not rational
:zh: 按所印定义的次数使判据失效
:kind: counterexample
:types: field
:data: α, i, j = (1,2,1) (1,1,2) (1,0,0)
:result: largest exponent = 2; n = 3; F = "x^2*y+x*y^2+1"; nodes, cusps, others = 0 0 0; g = 0; rational = "no"
:given: the cubic $F=0$ by its terms $\alpha x^iy^j$, whose exponents are at most 2
:then: with the largest exponent for $n$ the count is 0; but it is a cubic without singular points, and not rational
:method: The singular points are counted by elimination.  Whether the cubic is rational is read off their number, as
  `rational_cubic_has_one_double_point` allows, as by Lüroth's theorem, which is cited, a rational cubic has a parametrisation of degree 3; without any it is irreducible, because two parts would have a common
  point.  Compared is: $g=0$ exactly if the curve is rational.
:control: the total degree for $n$
:::
*/
CLAIM(printed_degree_spoils_the_genus)
{
    num_f F = given_polynomial(T, "α, i, j", 3);
    struct singular_list s = curve_of(F);
    struct census c = census_of(&s);
    int in_x = degree_f(F, s.x), in_y = degree_f(F, s.y), largest = in_x > in_y ? in_x : in_y;
    found_whole(T, "largest exponent", largest);
    if (s.n == 3 && c.nodes >= 0)
        count_against(T, &s, c, genus_count(fault(T, s.n, largest), c.nodes + c.cusps), is_rational_cubic(c));
}

/*
:::{claim} isolated_point_is_on_no_arc
:title: The double point of the rational cubic y² = x(x + 1)² is isolated and on no real arc
:zh: 有理三次曲线的孤立二重点不在实弧上
:kind: counterexample
:types: field
:data: α, i, j = (1,0,2) (-1,3,0) (-2,2,0) (-1,1,0); P = (-1,0,1); R = (0,0) (0,1/3) (1/3,2/3) (1,2); ω = 1 1 1 1
:result: n = 3; F = "-x^3-2*x^2-x+y^2"; nodes, cusps, others = 1 0 0; g = 0; real parameters of P = 0
:given: the cubic $F=0$ by its terms $\alpha x^iy^j$, the point $P$ in homogeneous coordinates, and the points $R$ of the
  curve $(t^2,t^3+t)$ with equal weights
:then: the only singular point is $P$, a node, and $g=0$; but no real parameter gives this real point
:method: The singular points are counted by elimination; $F$ is the determinant (3.4.1) of the points $R$; the parameters of $P$ are the common zeros
  of two polynomials.  Compared is: $g=0$ exactly if $P$ is a point of the real curve.
:control: imaginary parameters counted
:::
*/
CLAIM(isolated_point_is_on_no_arc)
{
    enum { n = 3 };
    num_f F = given_polynomial(T, "α, i, j", 4), P[3], R[2 * n + 2], w[n + 1];
    struct singular_list s = curve_with_point(T, F, P);
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    struct census c = census_of(&s);
    poly common = poly_constant(from_int_q(0)); /* of X - P_x W and Y - P_y W */
    for (int axis = 0; axis < 2; axis++) {
        num_q b[n + 1];
        for (int i = 0; i <= n; i++)
            is_constant_f(mul(w[i], sub(R[2 * i + axis], P[axis])), &b[i]);
        common = poly_gcd(common, poly_from_bernstein(n, b));
    }
    int real = count_roots_line(common).distinct, g = genus_count(s.n, c.nodes);
    found_whole(T, "n", s.n);
    found_text(T, "F", to_string_f(F));
    found_census(T, c);
    found_whole(T, "g", g);
    found_whole(T, "real parameters of P", real);
    about(T, "g = 0 exactly if P is a point of the real curve");
    if (c.nodes == 1 && c.cusps + c.others == 0 && is_the_curve(n, R, w, F))
        agree(T, (g == 0) == (fault(T, different_zeros(common), real) > 0));
}

/*
:::{statement} wang-ch3:thm-3.4.3-genus
:title: The genus as the count (n-1)(n-2)/2 - d - s
:zh: 亏格的计数公式
:printed: The genus of the curve is $g=\frac{(n-1)(n-2)}2-d-s$, where the curve, of degree $n$, has $d$ double points and $s$ cusps, imaginary points included.
:class: missing-hypothesis
:refuted-by: rational_quartic_with_a_triple_point rational_quartic_with_a_higher_cusp
:corrected: for an irreducible plane curve of degree $n$ all of whose singular points in the complex projective plane are nodes, $d$ of them,
  and ordinary cusps, $s$ of them, the genus is $g=\frac{(n-1)(n-2)}2-d-s$
:corrected-by: curves_that_fit_the_theorem
:cites: [walker-1950]: the genus of an irreducible plane curve by its double points | The formula for all such curves is cited; the claim has four curves of
  genus 0 that fit it.
:argued: every n | The cited formula is one for curves of every degree.
:confirmed-by: large_point_takes_all_double_points
:meant: the theory of algebraic curves, to which the theorem appeals and in which the genus has its own definition | The sentence is one about the
  genus, and not a name for the count.
:figure: genus_zero

The genus of a rational curve is 0, and the two quartics are rational.

The imaginary points count, as the source says, and so do those at infinity: the lemniscate
has only one finite double point.
:::

:::{claim} curves_that_fit_the_theorem
:title: Four curves of genus 0, their singular points counted and their parametrisations checked
:zh: 符合定理的四条曲线
:kind: decision
:types: field
:data: nodal cubic = (1,0,2) (-1,3,0) (-1,2,0); R, nodal cubic = (-1,0) (-1,-1/3) (-2/3,-2/3) (0,0);
  ω, nodal cubic = 1 1 1 1; cuspidal cubic = (1,0,2) (-1,3,0); R, cuspidal cubic = (0,0) (0,0) (1/3,0) (1,1);
  ω, cuspidal cubic = 1 1 1 1; lemniscate = (1,4,0) (2,2,2) (1,0,4) (-1,2,0) (1,0,2);
  R, lemniscate = (0,0) (1/4,1/4) (1/2,1/2) (1,1/2) (1,0); ω, lemniscate = 1 1 1 1 2;
  cardioid = (1,4,0) (2,2,2) (1,0,4) (4,3,0) (4,1,2) (-4,0,2);
  R, cardioid = (0,0) (0,0) (1/2,0) (1,1) (0,2); ω, cardioid = 3 3 4 6 12
:result: nodes and cusps, nodal cubic = 1 0; nodes and cusps, cuspidal cubic = 0 1; nodes and cusps, lemniscate = 3 0;
  nodes and cusps, cardioid = 0 3
:given: a nodal and a cuspidal cubic, the lemniscate and the cardioid, each by its terms $(\alpha,i,j)$, $\alpha
  x^iy^j$, with points $R$ and weights $\omega$
:then: the cubics have one node and one cusp; the lemniscate has three nodes, two of them the imaginary points
  $(1:\pm\mathrm i:0)$ at infinity; the cardioid three cusps, two of them these same points; there are no other
  singular points, so $g=0$; and they are the curves of the points $R$ and weights $\omega$, whose determinant (3.4.1)
  is a constant times their equation
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
    static const struct {
        const char *name, *points, *weights, *census;
        int terms, n;
    } curve[4] = {
        {"nodal cubic", "R, nodal cubic", "ω, nodal cubic", "nodes and cusps, nodal cubic", 3, 3},
        {"cuspidal cubic", "R, cuspidal cubic", "ω, cuspidal cubic", "nodes and cusps, cuspidal cubic", 2, 3},
        {"lemniscate", "R, lemniscate", "ω, lemniscate", "nodes and cusps, lemniscate", 5, 4},
        {"cardioid", "R, cardioid", "ω, cardioid", "nodes and cusps, cardioid", 6, 4},
    };
    const num_f origin[3] = {from_int(0), from_int(0), from_int(1)};
    for (int k = 0; k < 4; k++) {
        int n = curve[k].n;
        num_f R[10], w[5], F = given_polynomial(T, curve[k].name, curve[k].terms);
        given_points(T, curve[k].points, n + 1, 2, R);
        given_points(T, curve[k].weights, n + 1, 1, w);
        struct singular_list s = curve_of(F);
        list_points(&s, 1, origin);
        if (fault(T, n == 4, 0))
            list_circular_points(&s);
        struct census c = census_of(&s);
        found_points(T, curve[k].census, 2, 1, (num_f[]){from_int(c.nodes), from_int(c.cusps)});
        about(T, "nodes and cusps only, and g = 0");
        agree(T, s.n == n && c.nodes >= 0 && c.others == 0);
        agree(T, genus_count(n, c.nodes + c.cusps) == 0);
        about(T, "the equation of the Bézier curve");
        agree(T, is_the_curve(n, R, w, F));
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
