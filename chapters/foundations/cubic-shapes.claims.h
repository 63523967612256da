/*
# The shapes of a cubic (参数三次曲线的形态)

A plane cubic can run on without incident, change its side once or twice, turn on its heel, or cross itself.  Which of
these it does is decided by three numbers, the determinants $a=A\times B$, $b=A\times C$, $c=B\times C$ of its
coefficients, and by $\delta=3b^2-4ac$.
*/
#include "chapters/foundations/cubic.h"

#if RATIONAL
#include "exact/record/roots.h"
#include "exact/record/sign.h"
#endif

#include "chapters/judge/claims_on.h"

/*
:::{statement} hu-1987:1-4-forms
:title: The forms of a cubic
:zh: 参数三次曲线的几种形态
:printed: The forms of parametric cubics contain the ordinary one, the cusp, the closed loop, and that with inflections (figure 1-7).
:holds-by: each_form_occurs
:example: each form occurs, and one curve of each shows it.
:confirmed-by: sign_of_delta_tells_the_form merged_inflections_are_a_cusp delta_does_not_tell_graphs signs_decide_the_form
  parallel_tangents_give_an_s_or_an_arch
:figure: forms_of_a_cubic

:::

:::{claim} sign_of_delta_tells_the_form
:title: A cubic with a double point, and a cubic with two inflections, have delta of different signs
:zh: 判别式区分二重点与拐点
:given: any $s$ and $u$, any vectors $L,M,N$ of the plane: $P(t)=N+(t-s)(t-u)(Lt+M)$, a cubic with $P(s)=P(u)=N$
:where: $A\times B\ne0$
:then: with $a=A\times B$ etc.: $\delta=-a^2(s-u)^2$, `cubic_double_point_polynomial` is $a^2(t-s)(t-u)$, `cubic_double_point` is $N$; and
  for every cubic the discriminant of $P'\times P''$ is $12\delta$, that of the double point polynomial $-a^2\delta$
:method: The coefficients of $P$ are formed from $s,u,L,M,N$, all variables; the kernels then know nothing of these.  Conversely division
  by the polynomial with the sum $-\frac ba$ and the product $\frac{b^2-ac}{a^2}$ of its roots leaves a constant for every cubic with
  $a\ne0$: that remainder is computed for free coefficients.
:defines: cubic_delta cubic_double_point_polynomial cubic_double_point
:scope: cubic curves
:over: s u: parameter value; l# m# n#: vectors; x# y#: coefficients
:control: $\delta=b^2-4ac$
:::
*/
CLAIM(sign_of_delta_tells_the_form)
{
    num s = unknown(T, "s", 0), u = unknown(T, "u", 0), c[4 * dim], m[3], f[3], g[3], N[dim], point[dim];
    num sum = add(s, u), product = mul(s, u);
    for (int j = 0; j < dim; j++) { /* (t^2 - sum t + product)(L t + M) + N */
        num L = unknown(T, "l", j), M = unknown(T, "m", j);
        N[j] = unknown(T, "n", j);
        c[j] = add(mul(product, M), N[j]);
        c[dim + j] = sub(mul(product, L), mul(sum, M));
        c[2 * dim + j] = sub(M, mul(sum, L));
        c[3 * dim + j] = L;
    }
    G(cubic_minors)(c, m);
    G(cubic_double_point_polynomial)(m, g);
    G(cubic_double_point)(c, m, point);
    num aa = mul(m[0], m[0]),
        delta = fault(T, G(cubic_delta)(m), sub(mul(m[1], m[1]), mul(from_int(4), mul(m[0], m[2]))));
    about(T, "delta");
    /* δ = -a² (s - u)² */
    same(T, delta, neg(mul(aa, G(power)(sub(s, u), 2))));
    about(T, "the parameters of the double point");
    same(T, g[2], aa);
    same(T, g[1], neg(mul(aa, sum)));
    same(T, g[0], mul(aa, product));
    for (int j = 0; j < dim; j++)
        same(T, point[j], N[j]);

    num any[4 * dim]; /* the general cubic */
    G(free_points)(T, 3, dim, any);
    G(cubic_minors)(any, m);
    G(cubic_inflection_polynomial)(m, f);
    G(cubic_double_point_polynomial)(m, g);
    delta = G(cubic_delta)(m);
    about(T, "the discriminants");
    /* f_1² - 4 f_0 f_2 = 12 δ,   g_1² - 4 g_0 g_2 = -a² δ */
    same(T, sub(mul(f[1], f[1]), mul(from_int(4), mul(f[0], f[2]))), mul(from_int(12), delta));
    same(T, sub(mul(g[1], g[1]), mul(from_int(4), mul(g[0], g[2]))), neg(mul(mul(m[0], m[0]), delta)));
    num p = neg(div(m[1], m[0])), q = div(g[0], mul(m[0], m[0]));
    for (int j = 0; j < dim; j++) { /* A t^3 + B t^2 + C t = (t^2 - p t + q)(A t + B + p A) + linear t + ... */
        num A = any[3 * dim + j], rest = add(any[2 * dim + j], mul(p, A));
        about(T, "the remainder is constant");
        vanishes(T, add(sub(any[dim + j], mul(q, A)), mul(p, rest)));
    }
}

#if RATIONAL
/*
One discriminant separates the forms, because the inflections and the double point are roots of two quadratic
polynomials whose discriminants have opposite signs: where the ones are real the others are not.  Only for $a\ne0$ are
both of them quadratic; the graphs $y=f(x)$ are the exception, as they were for the inflections.

:::{claim} delta_does_not_tell_graphs
:title: Delta is 0 without a cusp, and positive with one inflection, where the cubic is a graph
:zh: A×B=0 时判别式不能区分形态
:kind: decision
:given: a parabola and the graph of a cubic function, with the coefficients $P$ and $Q$, both with $a=A\times B=0$
:data: P = (0,0) (1,0) (0,1) (0,0); Q = (0,0) (1,0) (0,0) (0,1)
:instead: P = (0,0) (1,0) (0,1) (0,1)
:then: $\delta=0$ for the first, which has no cusp, because its $x'$ is 1; $\delta>0$ for the second, whose $P'\times P''$ has one zero
:result: for P, (a, b, c) = 0 0 -1; for P, δ = 0; for P, number of zeros = 0; for Q, (a, b, c) = 0 -1 0; for Q, δ = 3; for Q, number of zeros = 1
:method: The kernels for cubics; zeros by root counts from $-1$ to 1, outside of which a polynomial of degree 1 without constant has none.
:control: a cubic in the place of the parabola
:::
*/
/* a, b, c and delta of the cubic, and the zeros of its turning in (-1,1), under their names: those of P or of Q. */
static num signs_of_graph(trial *T, int second, const num c[], int *zeros)
{
    num m[3];
    G(cubic_minors)(c, m);
    num delta = G(cubic_delta)(m);
    *zeros = count_roots(turning_of(c), from_int(-1), from_int(1), OPEN).distinct;
    found_points(T, second ? "for Q, (a, b, c)" : "for P, (a, b, c)", 3, 1, m);
    found(T, second ? "for Q, δ" : "for P, δ", delta);
    found_whole(T, second ? "for Q, number of zeros" : "for P, number of zeros", *zeros);
    vanishes(T, m[0]);
    return delta;
}

CLAIM(delta_does_not_tell_graphs)
{
    num P[8], Q[8];
    int zeros;
    given_points(T, "P", 4, 2, P);
    given_points(T, "Q", 4, 2, Q);
    vanishes(T, signs_of_graph(T, 0, P, &zeros));
    agree(T, zeros == 0 && equal_q(P[2], from_int(1)) && is_zero_q(P[4]) && is_zero_q(P[6])); /* x' = 1 */
    agree(T, sign_q(signs_of_graph(T, 1, Q, &zeros)) > 0);
    agree(T, zeros == 1);
}
#endif

/*
:::{claim} merged_inflections_are_a_cusp
:title: The two inflections meet at a cusp and nowhere else
:zh: 两拐点重合处为尖点
:given: any plane cubic with $a\ne0$, $t_0=-\frac b{2a}$
:where: $A\times B\ne0$
:then: $A\times P'(t_0)=0$ and $4a\,B\times P'(t_0)=-\delta$; since $A$ and $B$ are independent, $P'(t_0)=0$ exactly for $\delta=0$; and a
  cubic with $P'(t_1)=0$ somewhere has $\delta=0$
:method: The derivative at $t_0$ by the kernel, everything a variable; for the converse $C=-3At_1^2-2Bt_1$.
:scope: cubic curves
:over: x# y#: coefficients; t1: parameter value
:control: $t_0=-\frac ba$
:::
*/
CLAIM(merged_inflections_are_a_cusp)
{
    num c[4 * dim], m[3], D[2 * dim], t1 = unknown(T, "t", 1);
    G(free_points)(T, 3, dim, c);
    G(cubic_minors)(c, m);
    num at = neg(div(m[1], fault(T, mul(from_int(2), m[0]), m[0])));
    G(power_derivatives)(3, dim, c, at, 1, D);
    vanishes(T, G(cross2)(c + 3 * dim, D + dim));
    /* 4a B × P'(t_0) = -δ */
    same(T, mul(mul(from_int(4), m[0]), G(cross2)(c + 2 * dim, D + dim)), neg(G(cubic_delta)(m)));
    for (int j = 0; j < dim; j++) {
        num square = mul(mul(from_int(3), c[3 * dim + j]), mul(t1, t1));
        c[dim + j] = neg(add(square, mul(mul(from_int(2), c[2 * dim + j]), t1)));
    }
    G(cubic_minors)(c, m);
    about(T, "delta of a cubic with a vanishing derivative");
    vanishes(T, G(cubic_delta)(m));
}

/* The cubic of the triangle Q_0, M, Q_1 with the lengths alpha and beta. */
static void G(cubic_of_triangle)(const num R[], num alpha, num beta, num c[])
{
    num Q[2 * dim], V[2 * dim], two = from_int(2);
    for (int j = 0; j < dim; j++) {
        Q[j] = R[j];
        Q[dim + j] = R[2 * dim + j];
        V[j] = mul(mul(two, alpha), sub(R[dim + j], R[j]));
        V[dim + j] = mul(mul(two, beta), sub(R[2 * dim + j], R[dim + j]));
    }
    G(cubic_of_ends)(dim, Q, V, c);
}

/*
Between two inflections and a loop there is a moment at which both pairs of parameters run together.  There the velocity
vanishes, and the curve has a cusp.  To see the moment, let the ends and the directions stand and let the two lengths
grow: the cusps are a curve in the plane of the lengths, but for the point of it where the cubic is a parabola.

:::{claim} cusps_are_on_a_hyperbola
:title: In the plane of the lengths the cusps are a hyperbola without one point
:zh: 切矢长度平面上的尖点为去一点的双曲线
:given: a triangle $Q_0MQ_1$; tangents $\dot Q_0=2\alpha(M-Q_0)$, $\dot Q_1=2\beta(Q_1-M)$, any $\alpha,\beta$
:then: $\delta=-4\alpha\beta\,w^2\bigl((\alpha-2)(\beta-2)-1\bigr)$ with $w=2(Q_1-Q_0)\times(M-Q_0)$; the turning at the ends is
  $P'\times P''(0)=-2\alpha(3-2\beta)\,w$ and $P'\times P''(1)=-2\beta(3-2\alpha)\,w$; $a=(\alpha+\beta-2\alpha\beta)\,w$ with
  $a+3(\alpha+\beta-2)w=-2\bigl((\alpha-2)(\beta-2)-1\bigr)w$, and for $\alpha=\beta=1$ is $A=0$
:method: The cubic of the ends, the kernels, everything a variable.  Let $w\ne0$, $\alpha,\beta\ne0$: then $\delta=0$ on the hyperbola $(\alpha-2)(\beta-2)=1$ only.
  There $a=0$ would be $\alpha+\beta=2$, so $\alpha=\beta=1$: a parabola, without cusp; everywhere else on it the curve has a cusp by
  `merged_inflections_are_a_cusp`.
:over: x# y#: triangles; alpha; beta
:control: $(\alpha-2)(\beta-2)-2$
:::
*/
CLAIM(cusps_are_on_a_hyperbola)
{
    num R[3 * dim], c[4 * dim], m[3], f[3], alpha = parameter(T, "alpha"), beta = parameter(T, "beta"),
                                            two = from_int(2);
    num chord[dim], side[dim];
    G(free_points)(T, 2, dim, R);
    G(cubic_of_triangle)(R, alpha, beta, c);
    G(cubic_minors)(c, m);
    G(cubic_inflection_polynomial)(m, f);
    for (int j = 0; j < dim; j++) {
        chord[j] = sub(R[2 * dim + j], R[j]);
        side[j] = sub(R[dim + j], R[j]);
    }
    num w = mul(two, G(cross2)(chord, side));
    num branch = sub(mul(sub(alpha, two), sub(beta, two)), from_int(fault(T, 1, 2)));
    /* δ = -4αβ w² ((α - 2)(β - 2) - 1) */
    same(T, G(cubic_delta)(m), mul(from_int(-4), mul(mul(alpha, beta), mul(mul(w, w), branch))));
    about(T, "the turning at the ends");
    num three = from_int(3), minus_w = mul(from_int(-2), w);
    /* at 0: -2α (3 - 2β) w,   at 1: -2β (3 - 2α) w */
    same(T, f[0], mul(minus_w, mul(alpha, sub(three, mul(two, beta)))));
    same(T, add(f[0], add(f[1], f[2])), mul(minus_w, mul(beta, sub(three, mul(two, alpha)))));
    about(T, "A × B");
    num sum = add(alpha, beta), a = mul(sub(sum, mul(two, mul(alpha, beta))), w);
    same(T, m[0], a);
    /* a + 3 (α + β - 2) w = -2 ((α - 2)(β - 2) - 1) w */
    same(T, add(a, mul(three, mul(sub(sum, two), w))), mul(from_int(-2), mul(branch, w)));
    about(T, "A of the parabola");
    G(cubic_of_triangle)(R, from_int(1), from_int(1), c);
    for (int j = 0; j < dim; j++)
        vanishes(T, c[3 * dim + j]);
}

#if RATIONAL
/* The cubic of the triangle R with the lengths alpha and beta: the zeros of its turning, which are its inflections but for a cusp, and
 * the parameters of its double point, in (0,1), and its delta. */
static void events_of(const num R[], num alpha, num beta, int *inflections, int *doubles, num *delta)
{
    num c[8], m[3], g[3], zero = from_int(0), one = from_int(1);
    G(cubic_of_triangle)(R, alpha, beta, c);
    G(cubic_minors)(c, m);
    G(cubic_double_point_polynomial)(m, g);
    *inflections = count_roots(turning_of(c), zero, one, OPEN).distinct;
    *doubles = count_roots(poly_from_q(3, g), zero, one, OPEN).distinct;
    *delta = G(cubic_delta)(m);
}

/* How many parameters of (0,1) have the derivative 0. */
static int zeros_of_the_derivative(const num c[])
{
    poly slope[dim];
    for (int j = 0; j < dim; j++)
        slope[j] = poly_derivative(poly_from_q(4, (num[]){c[j], c[2 + j], c[4 + j], c[6 + j]}));
    poly square = poly_add(poly_mul(slope[0], slope[0]), poly_mul(slope[1], slope[1]));
    return count_roots(square, from_int(0), from_int(1), OPEN).distinct;
}

/* Compare: where delta is 0 the derivative vanishes at the double root of the polynomial of the double point; elsewhere all roots of
 * that polynomial are parameters of one point. */
static void decide_cusp_or_loop(trial *T, const num c[])
{
    num m[3], g[3], D[2 * dim], N[dim];
    G(cubic_minors)(c, m);
    G(cubic_double_point_polynomial)(m, g);
    if (is_zero_q(G(cubic_delta)(m))) {
        about(T, "the derivative at the cusp");
        G(power_derivatives)(3, dim, c, div(m[1], mul(from_int(-2), m[0])), 1, D);
        for (int j = 0; j < dim; j++)
            vanishes(T, D[dim + j]);
        return;
    }
    about(T, "whether the parameters of the double point have one point");
    G(cubic_double_point)(c, m, N);
    for (int j = 0; j < dim; j++)
        agree(T,
              poly_divides(poly_from_q(3, g), poly_from_q(4, (num[]){sub(c[j], N[j]), c[2 + j], c[4 + j], c[6 + j]})));
}

/*
:::{claim} each_form_occurs
:title: With the same ends and directions all forms occur
:zh: 端点与切向相同而形态各异
:kind: decision
:given: the triangle $R$ of $Q_0$, $M$, $Q_1$; the cubics from $Q_0$ to $Q_1$ with the tangents $2\alpha(M-Q_0)$, $2\beta(Q_1-M)$ for five pairs $(\alpha,\beta)$; for each of these
  forms the number of zeros of $P'\times P''$ and that of the parameters of the double point, both in $(0,1)$, and the sign of $\delta=3b^2-4ac$, with
  $a=A\times B$, $b=A\times C$, $c=B\times C$
:data: R = (0,0) (1,2) (3,0); (α,β) = (1/2,1/2) (1,3) (2,2) (3,3) (4,4); forms = (0,0,-1) (1,0,1) (2,0,1) (1,1,0) (0,2,-1)
:instead: (α,β) = (1,3) (1,3) (2,2) (3,3) (4,4)
:then: on the open arc no, one and two inflections; a cusp, where $\delta=0$ and $P'=0$, which is the one zero of $P'\times P''$; a loop, whose double point has two
  parameters in $(0,1)$
:method: Root counts of $P'\times P''$, of the double point polynomial and of $|P'|^2$, and the sign of $\delta$, all exact: $P'$ is 0 at the cusp alone, so that in the
  other forms each zero of $P'\times P''$ is a point with $K=0$, an inflection.  At the cusp the derivative at the double root $-\frac b{2a}$ of the double point
  polynomial; of the loop, that this polynomial divides $P-N$ with one point $N$, in both coordinates.
:control: the second pair twice
:::
*/
CLAIM(each_form_occurs)
{
    enum { FORMS = 5 };
    num R[6], lengths[2 * FORMS], wanted[3 * FORMS], c[8];
    given_points(T, "R", 3, 2, R);
    given_points(T, "(α,β)", FORMS, 2, lengths);
    given_points(T, "forms", FORMS, 3, wanted);
    for (int k = 0; k < FORMS; k++) {
        int inflections, doubles;
        num delta;
        events_of(R, lengths[2 * k], lengths[2 * k + 1], &inflections, &doubles, &delta);
        int as_wanted = equal_q(from_int(inflections), wanted[3 * k]) && equal_q(from_int(doubles), wanted[3 * k + 1]);
        about(T, "the numbers of zeros and of parameters, and the sign");
        agree(T, as_wanted && equal_q(from_int(sign_q(delta)), wanted[3 * k + 2]));
        G(cubic_of_triangle)(R, lengths[2 * k], lengths[2 * k + 1], c);
        about(T, "whether the derivative is 0 at the cusp alone");
        agree(T, zeros_of_the_derivative(c) == is_zero_q(delta));
        if (doubles > 0)
            decide_cusp_or_loop(T, c);
    }
}
#endif

/*
The whole curve is classified by $\delta$.  A designer sees an arc, and on it the events may be absent because they lie
outside of $[0,1]$.  The coefficients of Bernstein (Bernstein 系数) decide this from signs alone: their changes of sign
count the inflections on the arc, up to an even number, and the polynomial of the double point is treated in the same
way.  The result is a map of the quadrant of the lengths with three borders.

:::{claim} signs_decide_the_form
:title: The lengths of the tangents decide the form of the arc
:zh: 切矢长度完全决定曲线段的形态
:given: a triangle $Q_0MQ_1$; tangents $\dot Q_0=2\alpha(M-Q_0)$, $\dot Q_1=2\beta(Q_1-M)$, any $\alpha,\beta$; $w=2(Q_1-Q_0)\times(M-Q_0)$
:then: $P'\times P''$ has the Bernstein coefficients $f_0=2\alpha(2\beta-3)w$, $f_1=-2\alpha\beta w$, $f_2=2\beta(2\alpha-3)w$, and
  $f_1^2-f_0f_2=-12\alpha\beta w^2((\alpha-2)(\beta-2)-1)$; the polynomial of the double point has
  $g_0=\alpha(\alpha+2\beta^2-3\beta)w^2$, $g_1=-\alpha\beta(2\alpha\beta-3\alpha-3\beta+4)w^2$, $g_2=\beta(\beta+2\alpha^2-3\alpha)w^2$;
  for $\alpha=2+p$, $\beta=2+q$, $p,q>0$: $g_0,-g_1,g_2>0$; and $\alpha(3-2\alpha)^2-(4-3\alpha)=4(\alpha-1)^3$
:method: Identities, and signs of coefficients.  Let $\alpha,\beta>0$, neither of them $\frac32$, and $w>0$; then $f_1<0$.  Both below $\frac32$: $f_0,f_2<0$, no
  inflection.  One below and one above: one change of sign, one inflection.  Both above: two changes, so two inflections, one double one
  at a cusp, or none, as $(\alpha-2)(\beta-2)$ is less than 1, is 1, or is more, which needs $\alpha,\beta>2$; then the double point has
  two parameters in $(0,1)$: a loop.  There is no other loop: it needs $(\alpha-2)(\beta-2)>1$, that is both more than 2, or both less
  than $\frac32$; in the second case let $\alpha\ge\beta$: it needs $g_2>0$, $\beta>\alpha(3-2\alpha)$, so $\alpha>1$, and $g_1<0$,
  $\beta(3-2\alpha)<4-3\alpha$, which contradict each other by the last identity.
:scope: the tangents along the sides of a triangle
:over: x# y#: triangles; alpha p: α; beta q: β
:control: $3-\alpha$ in the place of $3-2\alpha$ in $f_2$ and in the last identity
:::
*/
CLAIM(signs_decide_the_form)
{
    num R[3 * dim], c[4 * dim], m[3], f[3], g[3], chord[dim], side[dim], one = from_int(1), two = from_int(2),
                                                                         three = from_int(3), four = from_int(4);
    G(free_points)(T, 2, dim, R);
    for (int j = 0; j < dim; j++) {
        chord[j] = sub(R[2 * dim + j], R[j]);
        side[j] = sub(R[dim + j], R[j]);
    }
    num w = mul(two, G(cross2)(chord, side)), ww = mul(w, w), alpha = parameter(T, "alpha"),
        beta = parameter(T, "beta");
    num twice = fault(T, mul(two, alpha), alpha), product = mul(alpha, beta);
    G(cubic_of_triangle)(R, alpha, beta, c);
    G(cubic_minors)(c, m);
    G(cubic_inflection_polynomial)(m, f);
    G(cubic_double_point_polynomial)(m, g);
    num half = from_ratio(1, 2), b[3] = {f[0], add(f[0], mul(half, f[1])), add(f[0], add(f[1], f[2]))};
    num wanted[3] = {mul(mul(two, alpha), sub(mul(two, beta), three)), mul(from_int(-2), product),
                     mul(mul(two, beta), sub(twice, three))};
    about(T, "the turning");
    for (int k = 0; k < 3; k++)
        same(T, b[k], mul(wanted[k], w));
    num branch = sub(mul(sub(alpha, two), sub(beta, two)), one);
    /* f_1² - f_0 f_2 = -12αβ w² ((α - 2)(β - 2) - 1) */
    same(T, sub(mul(b[1], b[1]), mul(b[0], b[2])), mul(from_int(-12), mul(mul(product, ww), branch)));

    num e[3] = {g[0], add(g[0], mul(half, g[1])), add(g[0], add(g[1], g[2]))};
    about(T, "the double point");
    num p = positive(T, "p", 0), q = positive(T, "q", 0);
    for (int at_the_loop = 0; at_the_loop < 2; at_the_loop++) {
        num x = at_the_loop ? add(two, p) : alpha, y = at_the_loop ? add(two, q) : beta;
        num outer[2] = {mul(x, add(x, mul(y, sub(mul(two, y), three)))),
                        mul(y, add(y, mul(x, sub(mul(two, x), three))))};
        num middle = mul(mul(x, y), add(sub(mul(two, mul(x, y)), mul(three, add(x, y))), four));
        if (at_the_loop) {
            G(must_be_positive)(T, outer[0]);
            G(must_be_positive)(T, middle);
            G(must_be_positive)(T, outer[1]);
        } else {
            /* g_0 = α (α + 2β² - 3β) w²,   g_1 = -αβ (2αβ - 3α - 3β + 4) w²,   g_2 = β (β + 2α² - 3α) w² */
            same(T, e[0], mul(outer[0], ww));
            same(T, e[1], neg(mul(middle, ww)));
            same(T, e[2], mul(outer[1], ww));
        }
    }
    num gap = sub(three, twice), rest = sub(four, mul(three, alpha));
    about(T, "the contradiction");
    /* α (3 - 2α)² - (4 - 3α) = 4 (α - 1)³ */
    same(T, sub(mul(alpha, mul(gap, gap)), rest), mul(four, G(power)(sub(alpha, one), 3)));
}

/*
:::{claim} parallel_tangents_give_an_s_or_an_arch
:title: With parallel tangents the arc has one inflection or none, and no loop
:zh: 端切矢平行时曲线段的形态
:given: any $Q_0$, $Q_1$ and $e$ in the plane, $w=(Q_1-Q_0)\times e$; $\dot Q_0=\lambda e$, and $\dot Q_1=\mu e$ or $-\mu e$; any
  $\lambda,\mu>0$
:then: in one sense: $\delta=12\lambda\mu w^2$, $P'\times P''$ is $-6\lambda w$ at 0 and $6\mu w$ at 1; in opposite senses: it has the
  Bernstein coefficients $-6\lambda w,0,-6\mu w$, and the polynomial of the double point is $\lambda(\lambda-3\mu)w^2$ at 0 and
  $\mu(\mu-3\lambda)w^2$ at 1
:method: The kernels, everything a variable.  Let $w\ne0$.  In one sense a quadratic changes its sign: one inflection, and no double
  point, as $\delta>0$ or, for $\lambda=\mu$, $a=0$ and the polynomial is the constant $b^2\ne0$.  In opposite senses there is no zero on
  the arc, so neither inflection nor cusp, and no loop: for that neither value may be negative, $\lambda\ge3\mu$ and $\mu\ge3\lambda$.
:over: q#: end points; e#: directions; l: λ; m: μ
:control: $\lambda-2\mu$ in the place of $\lambda-3\mu$
:::
*/
CLAIM(parallel_tangents_give_an_s_or_an_arch)
{
    num lambda = positive(T, "l", 0), mu = positive(T, "m", 0), Q[4], e[2], V[4], c[8], m[3], f[3], g[3];
    for (int k = 0; k < 4; k++)
        Q[k] = unknown(T, "q", k);
    for (int j = 0; j < dim; j++) {
        e[j] = unknown(T, "e", j);
        V[j] = mul(lambda, e[j]);
    }
    num chord[2] = {sub(Q[2], Q[0]), sub(Q[3], Q[1])}, w = G(cross2)(chord, e), ww = mul(w, w);
    for (int opposite = 0; opposite < 2; opposite++) {
        num last = opposite ? neg(mu) : mu;
        for (int j = 0; j < dim; j++)
            V[dim + j] = mul(last, e[j]);
        G(cubic_of_ends)(dim, Q, V, c);
        G(cubic_minors)(c, m);
        G(cubic_inflection_polynomial)(m, f);
        G(cubic_double_point_polynomial)(m, g);
        about(T, "the turning");
        same(T, f[0], mul(from_int(-6), mul(lambda, w)));
        same(T, add(f[0], add(f[1], f[2])), mul(from_int(6), mul(last, w)));
        if (!opposite) {
            same(T, G(cubic_delta)(m), mul(from_int(12), mul(mul(lambda, mu), ww)));
            continue;
        }
        vanishes(T, add(f[0], mul(from_ratio(1, 2), f[1])));
        about(T, "the double point");
        num first = sub(lambda, mul(from_int(fault(T, 3, 2)), mu)), second = sub(mu, mul(from_int(3), lambda));
        /* at 0: λ (λ - 3μ) w²,   at 1: μ (μ - 3λ) w² */
        same(T, g[0], mul(mul(lambda, first), ww));
        same(T, add(g[0], add(g[1], g[2])), mul(mul(mu, second), ww));
    }
}

#if RATIONAL
/*
:::{claim} forms_by_the_lengths_of_the_tangents
:title: What an arc does, by the lengths of its tangents
:zh: 由切矢长度判定曲线形态
:types: rational
:given: the triangle $R$; $\alpha,\beta$ random in the parts of the quadrant $\alpha,\beta>0$; a border $b$; a number $N$
:data: R = (0,0) (1,2) (3,0); b = 3/2; N = 20
:instead: b = 1
:then: both below $b$: no inflection; one above, one below: one; both above, and $(\alpha-2)(\beta-2)<1$ or one of them below 2: two;
  both above 2 and $(\alpha-2)(\beta-2)>1$: none, and a loop; both above 2 and $(\alpha-2)(\beta-2)=1$: a cusp
:method: Inflections and the parameters of the double point in $(0,1)$ as root counts, for $N$ points of each of the parts in every
  case, and $N$ cusps; the borders between the parts are those of `cusps_are_on_a_hyperbola`.
:control: another border
:::
*/
CLAIM(forms_by_the_lengths_of_the_tangents)
{
    num R[6], two = from_int(2), one = from_int(1);
    given_points(T, "R", 3, 2, R);
    num border = given(T, "b");
    int points = given_whole(T, "N");
    for (int k = 0; k < points; k++) {
        num low[2], high[2], delta;
        int inflections, doubles;
        for (int j = 0; j < 2; j++) {
            low[j] = mul(border, inside(T, "l"));
            high[j] = add(border, positive(T, "h", j));
        }
        events_of(R, low[0], low[1], &inflections, &doubles, &delta);
        agree(T, inflections == 0 && doubles < 2);
        events_of(R, low[0], high[1], &inflections, &doubles, &delta);
        agree(T, inflections == 1 && doubles < 2);
        events_of(R, high[0], low[1], &inflections, &doubles, &delta);
        agree(T, inflections == 1 && doubles < 2);
        num branch = sub(mul(sub(high[0], two), sub(high[1], two)), one);
        int loop = sign_q(branch) > 0 && compare_q(high[0], two) > 0;
        events_of(R, high[0], high[1], &inflections, &doubles, &delta);
        agree(T, loop ? inflections == 0 && doubles == 2 : inflections == 2 && doubles < 2);
        num beyond = add(two, positive(T, "b", 0)), cusp = add(two, div(one, sub(beyond, two)));
        events_of(R, beyond, cusp, &inflections, &doubles, &delta);
        agree(T, is_zero_q(delta) && inflections == 1 && doubles == 1);
        num more = add(cusp, positive(T, "c", 0));
        events_of(R, beyond, more, &inflections, &doubles, &delta);
        agree(T, sign_q(delta) < 0 && inflections == 0 && doubles == 2);
    }
}
#endif

#include "chapters/judge/claims_off.h"
