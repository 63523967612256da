/*
# Liming's pencil (Liming 曲线束)

Liming takes two lines that the conic touches, and the line through the two points where it touches them.  In
the frame of the triangle of the three lines, $R=R_1+x(R_0-R_1)+y(R_2-R_1)$, the pencil has one equation for
all triangles.
*/
#include "exact/record/roots.h"

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"
#include "chapters/rational-bezier/conics.h"

/*
## Liming's pencil: two tangents and the chord of contact

:::{statement} wang-ch3:3.1.3
:title: The conics that touch two lines at given points
:zh: 与两直线切于定点的曲线束
:printed: In particular, when the line $l_3$ falls on $l_4$, $(1-\lambda)l_1l_2+\lambda l_3^2=0$ represents the pencil of the
  conics through $R_0$ and $R_2$ that touch $l_1=0$ in $R_0$ and $l_2=0$ in $R_2$.
:holds-by: limings_conics_touch_the_lines conics_touching_two_lines_are_limings conics_touching_parallel_lines_are_limings
:hypothesis: double_line_has_no_tangent | $\lambda\ne1$: otherwise the conic is the line $l_3$ taken twice, which touches nothing.
:hypothesis: flat_frame_has_no_tangent | $R_0\ne R_2$; so that $l_3$ joins two points, $R_0$ is not on $l_2$, and $R_2$ not on $l_1$.
:hypothesis: limings_pencil_misses_one_conic | $\lambda=\infty$ is admitted; otherwise the member $l_1l_2-l_3^2=0$ is missing.
:meant: the equation, which leaves $\lambda l_3^2=0$ where $l_1=0$ or $l_2=0$ | $R_0$ is the point where $l_3$ meets $l_1$, and $R_2$ the point where it meets $l_2$.
:figure: limings_pencil

That $R_0\ne R_2$ is stated only later, with the frame $\{R_1;R_1R_0,R_1R_2\}$, for which $l_1$ and $l_2$ have to meet; here they may be parallel.  As at (3.1.2) all such conics
are to be members; that each member touches the two lines needs $\lambda\ne1$ and $R_0\ne R_2$ only.

The values and gradients of the members are linear in the two factors $1-\lambda$ and $\lambda$, so what is proved of them is true for the factors $1$ and $-1$ of
$\lambda=\infty$ as well.
:::

Let the lines $l_3$ and $l_4$ of the last section move together.  Two of the four common points then fall together in $R_0$
and two in $R_2$, and where a conic meets $l_1$ twice in one point, it touches $l_1$ there.  The gradient says it without a
limit: at $R_0$ both $l_1$ and $l_3$ vanish, so that of the gradient of $(1-\lambda)l_1l_2+\lambda l_3^2$ only
$(1-\lambda)l_2(R_0)$ times that of $l_1$ is left.

:::{claim} limings_conics_touch_the_lines
:title: Liming's conics pass through the two points and touch the two lines there
:zh: Liming 曲线束的相切性
:given: a triangle $R_0R_1R_2$, the lines $l_1=R_1R_0$, $l_2=R_1R_2$, $l_3=R_0R_2$, and a number $\lambda$
:let: $S=(1-\lambda)l_1l_2+\lambda l_3^2$
:then: at every point $S$ has this value; $S(R_0)=S(R_2)=0$; the gradient of $S$ is $(1-\lambda)l_2(R_0)$ times that
  of $l_1$ in $R_0$, and $(1-\lambda)l_1(R_2)$ times that of $l_2$ in $R_2$: for $\lambda\ne1$ and
  a true triangle it is not zero, and the tangents are $l_1$ and $l_2$
:method: Identities in the six coordinates, $\lambda$ and the point.
:defines: conic_liming
:over: k: λ
:control: $l_3^2$ replaced by $l_1l_3$
:::
*/
CLAIM(limings_conics_touch_the_lines)
{
    num R[6], l1[3], l2[3], l3[3], S[6], g[2], lambda = unknown(T, "k", 0), mu = sub(from_int(1), lambda);
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0);
    G(six)(T, "R", R);
    G(line_through)(R + 2, R, l1);
    G(line_through)(R + 2, R + 4, l2);
    G(line_through)(R, R + 4, l3);
    G(conic_liming)(lambda, l1, l2, l3, S);
    if (T->faulty) {
        num tangents[6], other[6];
        G(line_pair)(l1, l2, tangents);
        G(line_pair)(l1, l3, other);
        G(conic_pencil)(lambda, tangents, other, S);
    }
    about(T, "S(x, y)");
    num third = G(on_line)(l3, x, y), pair = mul(G(on_line)(l1, x, y), G(on_line)(l2, x, y));
    /* S = (1-λ) l_1 l_2 + λ l_3² */
    same(T, G(form)(S, x, y), add(mul(mu, pair), mul(lambda, mul(third, third))));
    about(T, "S and its gradient at R0");
    vanishes(T, G(form)(S, R[0], R[1]));
    G(conic_gradient)(S, R[0], R[1], g);
    for (int c = 0; c < 2; c++)
        same(T, g[c], mul(mul(mu, G(on_line)(l2, R[0], R[1])), l1[c]));
    about(T, "S and its gradient at R2");
    vanishes(T, G(form)(S, R[4], R[5]));
    G(conic_gradient)(S, R[4], R[5], g);
    for (int c = 0; c < 2; c++)
        same(T, g[c], mul(mul(mu, G(on_line)(l1, R[4], R[5])), l2[c]));
}

/*
That there are no other conics with these tangents is the converse.  Four conditions, two values and two components of
gradients, cut the six coefficients down to two; when the lines are parallel, another frame has to be taken, and the count
is the same.

:::{claim} conics_touching_two_lines_are_limings
:title: There are no other conics that touch the two lines there
:zh: 切于两定点的二次曲线都在 Liming 束中
:given: three points $R_0,R_1,R_2$ of the plane, any conic $S$, with the gradient $\nabla S$ and the quadratic form $q$ of its terms of degree two
:let: $[XYZ]$ the determinant of three points, $D=[R_0R_1R_2]$; $l_1=[R_0R_1X]$, $l_2=[R_1R_2X]$, $l_3=[R_2R_0X]$; $u=R_0-R_1$, $v=R_2-R_1$; $c_1=S(R_0)$,
  $c_2=\nabla S(R_0)\cdot u$, $c_3=S(R_2)$, $c_4=\nabla S(R_2)\cdot v$, $\kappa=c_1-c_2-c_3+c_4$
:then: $D^2S=q(u)\,l_3^2+2(q(u,v)-q(u))\,l_1l_2+\kappa\,(l_1^2-2Dl_1)+c_2Dl_2+c_4Dl_1+(c_1-c_2)D^2$ at every point $X$; so a conic through $R_0$ and $R_2$ whose
  gradient has no component along $l_1=0$ in $R_0$ and none along $l_2=0$ in $R_2$, all $c_i$ being 0, is in a triangle, $D\ne0$, a combination
  of $l_3^2$ and $l_1l_2$
:method: An identity of polynomials in the coordinates of $X$, with the three points and the six coefficients of $S$ variables.
:over: S#: conics; R#: points; x; y
:control: $q(u,v)-q(u)$ replaced by $q(u,v)$
:::
*/
/* The determinant of three points. */
static num G(three)(const num X[2], const num Y[2], const num Z[2])
{
    num u[2] = {sub(Y[0], X[0]), sub(Y[1], X[1])}, v[2] = {sub(Z[0], X[0]), sub(Z[1], X[1])};
    return G(cross2)(u, v);
}

/* q(u,v), the terms of degree two of S. */
static num G(bilinear)(const num S[], const num u[2], const num v[2])
{
    num mixed = add(mul(u[0], v[1]), mul(u[1], v[0]));
    return add(mul(S[0], mul(u[0], v[0])), add(mul(S[1], mixed), mul(S[2], mul(u[1], v[1]))));
}

/* The derivative of S at X along u. */
static num G(slope_along)(const num S[], const num X[2], const num u[2])
{
    num g[2];
    G(conic_gradient)(S, X[0], X[1], g);
    return add(mul(g[0], u[0]), mul(g[1], u[1]));
}

CLAIM(conics_touching_two_lines_are_limings)
{
    num S[6], R[3][2], X[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, two = from_int(2);
    for (int i = 0; i < 6; i++)
        R[i / 2][i % 2] = unknown(T, "R", i);
    G(six)(T, "S", S);
    num u[2] = {sub(R[0][0], R[1][0]), sub(R[0][1], R[1][1])}, v[2] = {sub(R[2][0], R[1][0]), sub(R[2][1], R[1][1])};
    num D = G(three)(R[0], R[1], R[2]), DD = mul(D, D);
    num l1 = G(three)(R[0], R[1], X), l2 = G(three)(R[1], R[2], X), l3 = G(three)(R[2], R[0], X);
    num c1 = G(form)(S, R[0][0], R[0][1]), c2 = G(slope_along)(S, R[0], u);
    num c3 = G(form)(S, R[2][0], R[2][1]), c4 = G(slope_along)(S, R[2], v);
    num kappa = add(sub(sub(c1, c2), c3), c4), quv = G(bilinear)(S, u, v), quu = G(bilinear)(S, u, u);
    num member = add(mul(quu, mul(l3, l3)), mul(mul(two, fault(T, sub(quv, quu), quv)), mul(l1, l2)));
    num rest = add(mul(kappa, sub(mul(l1, l1), mul(two, mul(D, l1)))),
                   add(mul(mul(c2, D), l2), add(mul(mul(c4, D), l1), mul(sub(c1, c2), DD))));
    same(T, mul(DD, G(form)(S, X[0], X[1])), add(member, rest));
}

/*
:::{claim} conics_touching_parallel_lines_are_limings
:title: The same with two parallel lines
:zh: 两条平行线时亦然
:given: two points $R_0$, $R_2$ of the plane, a direction $d$, a number $\lambda$, and any conic $S$, with the quadratic form $q$ of its terms of degree two
:let: $l_1$ and $l_2$ the determinants of $X-R_0$ and of $X-R_2$ with $d$, $l_3$ that of $R_0-R_2$ with $X-R_2$; $e=R_0-R_2$, $D$ the determinant of $e$ and $d$; $c_1=S(R_0)$,
  $c_2=S(R_2)$, $c_3=\nabla S(R_0)\cdot d$, $c_4=\nabla S(R_2)\cdot d$
:then: $(1-\lambda)l_1l_2+\lambda l_3^2$ is 0 in $R_0$ and $R_2$, with the gradients $(1-\lambda)D\,\nabla l_1$ and $-(1-\lambda)D\,\nabla l_2$;
  and $D^2S=q(e)\,l_1l_2+q(d)\,l_3^2+(c_3-c_4)\,\frac{l_1+l_2}2\,l_3+(c_1-c_2)\,D\,\frac{l_1+l_2}2+\frac{c_3+c_4}2\,Dl_3+\frac{c_1+c_2}2\,D^2$ at every point $X$, so that a conic through
  $R_0$ and $R_2$ whose gradient has no component along the lines there, all $c_i$ being 0, is for $D\ne0$ a combination of $l_1l_2$
  and $l_3^2$
:method: Identities in $\lambda$, the coordinates of $X$, $R_0$, $R_2$ and $d$, and the six coefficients of $S$.
:over: S#: conics; R#: points; d#: -; k: λ; x; y
:control: $c_3+c_4$ for $c_3-c_4$
:::
*/
CLAIM(conics_touching_parallel_lines_are_limings)
{
    num S[6], M[6], R[2][2], X[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, lambda = unknown(T, "k", 0), g[2];
    num d[2] = {unknown(T, "d", 0), unknown(T, "d", 1)}, mu = sub(from_int(1), lambda), half = from_ratio(1, 2);
    for (int i = 0; i < 4; i++)
        R[i / 2][i % 2] = unknown(T, "R", i);
    num e[2] = {sub(R[0][0], R[1][0]), sub(R[0][1], R[1][1])}, D = G(cross2)(e, d), DD = mul(D, D);
    /* lines as three coefficients */
    num l1[3] = {d[1], neg(d[0]), neg(G(cross2)(R[0], d))}, l2[3] = {d[1], neg(d[0]), neg(G(cross2)(R[1], d))};
    num l3[3] = {neg(e[1]), e[0], neg(G(cross2)(e, R[1]))};
    G(conic_liming)(lambda, l1, l2, l3, M);
    for (int end = 0; end < 2; end++) {
        const num *line = end == 0 ? l1 : l2;
        num factor = end == 0 ? mul(mu, D) : neg(mul(mu, D));
        about(T, "a member at its end");
        vanishes(T, G(form)(M, R[end][0], R[end][1]));
        about(T, "the gradient of a member");
        G(conic_gradient)(M, R[end][0], R[end][1], g);
        same(T, g[0], mul(factor, line[0]));
        same(T, g[1], mul(factor, line[1]));
    }
    G(six)(T, "S", S);
    num c1 = G(form)(S, R[0][0], R[0][1]), c2 = G(form)(S, R[1][0], R[1][1]);
    num c3 = G(slope_along)(S, R[0], d), c4 = G(slope_along)(S, R[1], d), at[3];
    for (int l = 0; l < 3; l++) {
        const num *line = l == 0 ? l1 : l == 1 ? l2 : l3;
        at[l] = add(add(mul(line[0], X[0]), mul(line[1], X[1])), line[2]);
    }
    num middle = mul(half, add(at[0], at[1]));
    num member = add(mul(G(bilinear)(S, e, e), mul(at[0], at[1])), mul(G(bilinear)(S, d, d), mul(at[2], at[2])));
    num rest = add(mul(mul(fault(T, sub(c3, c4), add(c3, c4)), middle), at[2]), mul(mul(sub(c1, c2), D), middle));
    rest = add(rest, add(mul(mul(half, add(c3, c4)), mul(D, at[2])), mul(mul(half, add(c1, c2)), DD)));
    about(T, "any conic");
    same(T, mul(DD, G(form)(S, X[0], X[1])), add(member, rest));
}

#if RATIONAL
/* The lines l_1, l_2, l_3 of the data of the claim, by their coefficients a, b, c. */
static void G(given_lines)(trial *T, num l[3][3])
{
    static const char *const name[] = {"l_1", "l_2", "l_3"};
    for (int i = 0; i < 3; i++)
        given_points(T, name[i], 3, 1, l[i]);
}

/* Refutes that the conic (1-lambda) l_1 l_2 + lambda l_3^2 has a tangent at R_0, lines, point and lambda being data of the claim. */
static void G(refute_tangent)(trial *T)
{
    num l[3][3], R[2], S[6], g[2];
    G(given_lines)(T, l);
    given_points(T, "R_0", 1, 2, R);
    G(conic_liming)(given(T, "λ"), l[0], l[1], l[2], S);
    G(conic_gradient)(S, R[0], R[1], g);
    found_points(T, "gradient", 1, 2, g);
    about(T, "whether the conic has a tangent at R0: whether the gradient is not zero");
    refute(T, is_zero_q(g[0]) && is_zero_q(g[1]));
}

/*
The factor $(1-\lambda)l_2(R_0)$ also shows when nothing is touched: for $\lambda=1$, and when $R_0$ lies on both lines.

:::{claim} double_line_has_no_tangent
:title: The member of lambda = 1 is a double line
:zh: λ=1 时为重合直线
:kind: counterexample
:data: l_1 = 0 1 0; l_2 = 1 0 0; l_3 = 1 1 -1; R_0 = (1,0); λ = 1
:instead: λ = 1/2
:result: gradient = (0,0)
:given: the axes $l_1$ and $l_2$, the line $l_3$ through a point $R_0$ of $l_1$, and $\lambda=1$; a line is given by the coefficients $a,b,c$ of $ax+by+c$
:then: the gradient at $R_0$ is zero, so the conic has no tangent there
:method: The gradient is computed.
:control: a $\lambda$ between 0 and 1
:::
*/
CLAIM(double_line_has_no_tangent) { G(refute_tangent)(T); }

/*
:::{claim} flat_frame_has_no_tangent
:title: With three lines through one point nothing is touched
:zh: 三线共点时无切线
:kind: counterexample
:data: l_1 = 0 1 0; l_2 = 1 0 0; l_3 = 1 -1 0; R_0 = (0,0); λ = 1/2
:instead: l_3 = 1 1 -1; R_0 = (1,0)
:result: gradient = (0,0)
:given: the axes $l_1$ and $l_2$, a line $l_3$ through the origin $R_0=R_2$, and a $\lambda$ between 0 and 1; a line is given by the coefficients $a,b,c$ of $ax+by+c$
:then: the gradient at $R_0$ is zero (the conic $x^2-xy+y^2=0$ is this one point)
:method: The gradient is computed.
:control: a line $l_3$ that meets the axes in two points
:::
*/
CLAIM(flat_frame_has_no_tangent) { G(refute_tangent)(T); }

/*
:::{claim} limings_pencil_misses_one_conic
:title: One ellipse that touches both lines has no lambda
:zh: Liming 曲线束漏掉一个椭圆
:kind: counterexample
:data: l_1 = 0 1 0; l_2 = 1 0 0; l_3 = 1 1 -1; R_0 = (1,0); R_2 = (0,1); κ = -1
:instead: κ = -2
:result: AC-B² = 3/4; S(R_0), S(R_2) = 0 0; ∇S(R_0) = (0,1); ∇S(R_2) = (1,0); values of λ that fit = 0
:given: the axes $l_1$ and $l_2$, the line $l_3$ through their points $R_0$ and $R_2$, and the conic $S=l_1l_2+\kappa l_3^2$; a line is given by the coefficients $a,b,c$ of $ax+by+c$,
  a conic by the $A,\dots,F$ of (3.1.1)
:then: $S$ is an ellipse, $AC-B^2>0$, which touches $l_1$ in $R_0$ and $l_2$ in $R_2$; for no $\lambda$ is
  $(1-\lambda)l_1l_2+\lambda l_3^2$ a multiple of it
:method: The real zeros in $\lambda$ of a determinant of coefficients are counted.  That the conic is an ellipse through
  the two points, with gradients along those of $l_1$ and $l_2$, is asked first.
:control: another $\kappa$
:::
*/
CLAIM(limings_pencil_misses_one_conic)
{
    num l[3][3], R0[2], R2[2], S1[6], S2[6], S[6], g0[2], g2[2];
    G(given_lines)(T, l);
    given_points(T, "R_0", 1, 2, R0);
    given_points(T, "R_2", 1, 2, R2);
    num kappa = given(T, "κ");
    G(line_pair)(l[0], l[1], S1);
    G(line_pair)(l[2], l[2], S2);
    for (int i = 0; i < 6; i++)
        S[i] = add(S1[i], mul(kappa, S2[i]));
    num delta = G(conic_delta)(S), value[2] = {G(form)(S, R0[0], R0[1]), G(form)(S, R2[0], R2[1])};
    G(conic_gradient)(S, R0[0], R0[1], g0);
    G(conic_gradient)(S, R2[0], R2[1], g2);
    int count = members_like(S1, S2, S, 0, 1);
    found(T, "AC-B²", delta);
    found_points(T, "S(R_0), S(R_2)", 2, 1, value);
    found_points(T, "∇S(R_0)", 1, 2, g0);
    found_points(T, "∇S(R_2)", 1, 2, g2);
    found_whole(T, "values of λ that fit", count);
    int touches = is_zero_q(value[0]) && is_zero_q(g0[0]) && !is_zero_q(g0[1]) && is_zero_q(value[1]) &&
                  is_zero_q(g2[1]) && !is_zero_q(g2[0]);
    about(T, "whether the ellipse, which touches both lines, is a member");
    refute(T, touches && sign_q(delta) > 0 && count == 0);
}
#endif

/*
:::{statement} wang-ch3:fig-3.1.1
:title: The pencil of conics that three lines determine
:zh: 由三条直线决定的二次曲线束
:printed: The caption of figure 3.1.1: the pencil of conics that is determined by three lines.
:holds-by: limings_conics_touch_the_lines conics_touching_two_lines_are_limings every_scaling_takes_the_normal_form
:hypothesis: limings_pencil_misses_one_conic | $\lambda=\infty$ is admitted; otherwise the member $l_1l_2-l_3^2=0$ is missing, and
  with other factors of the three equations it is another conic that is missing.
:needs: flat_frame_has_no_tangent | § 3.1: the affine frame $\{R_1;R_1R_0,R_1R_2\}$ of the three lines | $R_0$, $R_1$, $R_2$ do not
  lie on a line; three lines through one point have no such conics
:meant: the text that refers to the figure, where $l_3$ joins the points of contact on $l_1$ and $l_2$ | One of the lines is the chord, the
  two others are tangents.
:reading: every_scaling_takes_the_normal_form | The lines have these parts: then the pencil, $\lambda=\infty$ admitted, is determined
  by them, whatever factors their equations have.
:reading: three_lines_have_three_pencils | Three lines without parts: each of them may be the chord, and with another chord the pencil is
  another one.

The figure itself is not in the text at hand.  What is proved of the members is linear in $1-\lambda$ and $\lambda$, hence true of $\lambda=\infty$, too.
Two parallel tangents have no point $R_1$; that they and the chord determine a pencil, too, is decided at (3.1.3).
:::
*/

#if RATIONAL
/*
:::{claim} three_lines_have_three_pencils
:title: With another line for the chord the pencil is another one
:zh: 以另一直线为弦得另一曲线束
:kind: counterexample
:data: l_1 = 0 1 0; l_2 = 1 0 0; l_3 = 1 1 -1; λ = 1/2; P = (0,0)
:instead: λ = 0
:result: l_1(P), l_2(P) = 0 0; S(P) = 1/2
:given: three lines, each by the coefficients $a,b,c$ of $ax+by+c$, the conic $S=(1-\lambda)l_1l_2+\lambda l_3^2$ of the pencil with the chord $l_3$, and the point $P$ where $l_1$ and $l_2$ meet
:then: every conic of the pencil with the chord $l_2$, $(1-\mu)l_1l_3+\mu l_2^2=0$, passes through $P$, and $S$ does not
:method: At $P$ both $l_1$ and $l_2$ are 0, and so is every combination of $l_1l_3$ and $l_2^2$; $S(P)$ is computed.
:control: the member of $\lambda=0$, the pair of the tangents
:::
*/
CLAIM(three_lines_have_three_pencils)
{
    num l[3][3], P[2], S[6], value[2];
    G(given_lines)(T, l);
    num lambda = given(T, "λ");
    given_points(T, "P", 1, 2, P);
    for (int k = 0; k < 2; k++)
        value[k] = G(on_line)(l[k], P[0], P[1]);
    G(conic_liming)(lambda, l[0], l[1], l[2], S);
    num at = G(form)(S, P[0], P[1]);
    found_points(T, "l_1(P), l_2(P)", 2, 1, value);
    found(T, "S(P)", at);
    about(T, "the value at P of a conic of the pencil with the chord l_2, which is 0");
    if (is_zero_q(value[0]) && is_zero_q(value[1]))
        vanishes(T, at);
}
#endif

/*
## In the frame of the triangle

:::{statement} wang-ch3:3.1-affine-coordinates
:title: Affine coordinates of a point in the frame of the triangle
:zh: 仿射坐标
:printed: For every point $\mathbf R$ of the curve
  $\mathbf R=\mathbf R(x,y)=\mathbf R_1+x(\mathbf R_0-\mathbf R_1)+y(\mathbf R_2-\mathbf R_1)$.
:holds-by: affine_coordinates_exist
:needs: collinear_points_are_no_frame | § 3.1: the affine frame $\{R_1;R_1R_0,R_1R_2\}$ | $R_0$, $R_1$, $R_2$ do not
  lie on a line: they form an affine frame; on a line a point has more than one pair $(x,y)$.
:::

:::{claim} affine_coordinates_exist
:title: Every point has one pair of coordinates in the frame
:zh: 标架中坐标存在唯一
:given: a triangle $R_0R_1R_2$ and a point $R$
:let: $x=\frac{(R-R_1)\times(R_2-R_1)}d$, $y=\frac{(R_0-R_1)\times(R-R_1)}d$ with $d=(R_0-R_1)\times(R_2-R_1)$
:then: $R=R_1+x(R_0-R_1)+y(R_2-R_1)$; and from the point with given $x$ and $y$ the formulas give these back
:method: Identities in the coordinates of the four points, $x$ and $y$.
:over: u# v#: coordinates
:control: $x$ and $y$ exchanged
:::
*/
CLAIM(affine_coordinates_exist)
{
    num R[6], P[2], Q[2], u = unknown(T, "u", 0), v = unknown(T, "v", 0);
    G(six)(T, "R", R);
    for (int c = 0; c < 2; c++)
        P[c] = unknown(T, "P", c);
    /* x = (R - R_1) × (R_2 - R_1)/d, y = (R_0 - R_1) × (R - R_1)/d */
    num d = G(area)(R + 2, R, R + 4), x = div(G(area)(R + 2, P, R + 4), d), y = div(G(area)(R + 2, R, P), d);
    G(point_in_frame)(R, fault(T, x, y), fault(T, y, x), Q);
    about(T, "the point with these coordinates");
    same(T, Q[0], P[0]);
    same(T, Q[1], P[1]);
    about(T, "the coordinates of the point");
    G(point_in_frame)(R, u, v, P);
    same(T, div(G(area)(R + 2, P, R + 4), d), u);
    same(T, div(G(area)(R + 2, R, P), d), v);
}

#if RATIONAL
/*
:::{claim} collinear_points_are_no_frame
:title: Three points on a line are no frame of the plane
:zh: 三点共线不成标架
:kind: counterexample
:data: R = (0,0) (0,0) (1,0); (x,y) = (0,0) (1,0)
:instead: R = (0,1) (0,0) (1,0)
:result: determinant of the frame = 0; R(x,y) = (0,0) (0,0)
:given: three points $R_0=R_1$ and $R_2$ on a line, and two pairs $(x,y)$; $l_1$ is any other line through $R_0$, so that it meets $l_2=R_1R_2$ in $R_1$
:then: $(R_0-R_1)\times(R_2-R_1)=0$, and both pairs have the same point $R(x,y)$, which so has more than one pair
:method: The determinant of the frame and the two points are computed; that different pairs have different points is refuted.
:control: $R_0$ moved off the line
:::
*/
CLAIM(collinear_points_are_no_frame)
{
    num R[6], pair[4], P[4];
    given_points(T, "R", 3, 2, R);
    given_points(T, "(x,y)", 2, 2, pair);
    num d = G(area)(R + 2, R, R + 4);
    for (int k = 0; k < 4; k += 2)
        G(point_in_frame)(R, pair[k], pair[k + 1], P + k);
    found(T, "determinant of the frame", d);
    found_points(T, "R(x,y)", 2, 2, P);
    int pairs_differ = !equal_q(pair[0], pair[2]) || !equal_q(pair[1], pair[3]);
    about(T, "whether different pairs have different points");
    refute(T, is_zero_q(d) && pairs_differ && equal_q(P[0], P[2]) && equal_q(P[1], P[3]));
}
#endif

/*
In the frame (仿射标架) with the origin $R_1$ and the axes along the two tangents the three lines are $y=0$, $x=0$ and $x+y=1$,
whatever the triangle was.  All triangles have the same pencil.  One has to look out for two things.  The equation of a line
may be multiplied by any number, and the value of $\lambda$ in (3.1.3) depends on this choice; so $\lambda$ in (3.1.4) is a
new number, unless the equations are scaled to fit.  And the frame needs the point $R_1$.

:::{statement} wang-ch3:3.1.4
:title: The pencil in the frame of the triangle
:zh: 仿射标架下的曲线束
:printed: Let $l_1=0$ and $l_2=0$ meet in $R_1$; then (3.1.3) can be brought to $S(x,y)=(1-\lambda)xy\pm\lambda(x+y-1)^2=0$ in the affine frame
  $\{R_1;R_1R_0,R_1R_2\}$.
:holds-by: limings_pencil_in_the_frame every_scaling_takes_the_normal_form
:meant: what follows, by which one point of the curve determines $\lambda$ of (3.1.4) | $\lambda$ of (3.1.4) is the parameter of the pencil in this form; it need not be the number
  of (3.1.3).
:needs: half_circle_has_no_frame | the sentence itself: let $l_1=0$ and $l_2=0$ meet in $R_1$ | $l_1$ and $l_2$ meet.
  With parallel tangents, as of a half circle, there is no $R_1$.
:needs: collinear_points_are_no_frame | the sentence itself: the affine frame $\{R_1;R_1R_0,R_1R_2\}$ | $R_0$, $R_1$, $R_2$ do not
  lie on a line: they form an affine frame.
:reading: every_scaling_takes_the_normal_form | $\lambda$ of (3.1.4) is a new parameter; then it is so for each conic of the
  pencil, with one of the two signs.
:reading: scaled_lines_change_lambda | $\lambda$ is the same number in both.  This is so, with the minus sign, when
  the lines are written as determinants of their points, and not for all factors of
  their equations.
:figure: limings_pencil
:::

:::{claim} limings_pencil_in_the_frame
:title: In the frame of the triangle Liming's pencil is xy and the square of the chord
:zh: Liming 束在标架中的形式
:given: a triangle $R_0R_1R_2$, the lines $l_1=R_1R_0$, $l_2=R_1R_2$, $l_3=R_0R_2$ as determinants
  $l(X)=\det(p,q,X)$ of their points, and a number $\lambda$
:then: at $R=R_1+x(R_0-R_1)+y(R_2-R_1)$ the value of $(1-\lambda)l_1l_2+\lambda l_3^2$ is
  $-d^2\bigl((1-\lambda)xy-\lambda(x+y-1)^2\bigr)$ with $d=(R_0-R_1)\times(R_2-R_1)$
:method: An identity in the coordinates of the triangle, $x$, $y$ and $\lambda$.
:over: k: λ
:control: the plus sign
:::
*/
CLAIM(limings_pencil_in_the_frame)
{
    num R[6], l1[3], l2[3], l3[3], S[6], N[6], P[2];
    num lambda = unknown(T, "k", 0), x = unknown(T, "x", 0), y = unknown(T, "y", 0);
    G(six)(T, "R", R);
    G(line_through)(R + 2, R, l1);
    G(line_through)(R + 2, R + 4, l2);
    G(line_through)(R, R + 4, l3);
    G(conic_liming)(lambda, l1, l2, l3, S);
    G(point_in_frame)(R, x, y, P);
    num d = G(area)(R + 2, R, R + 4);
    G(frame_conic)(lambda, fault(T, -1, 1), N);
    /* S(R(x, y)) = -d² ((1-λ) xy - λ (x+y-1)²) */
    same(T, G(form)(S, P[0], P[1]), neg(mul(mul(d, d), G(form)(N, x, y))));
}

/*
The two signs in (3.1.4) are two ways to number the same conics.  One of them always serves.

:::{claim} every_scaling_takes_the_normal_form
:title: However the lines are scaled, the conic takes the normal form
:zh: 直线方程任意定标时的标准形
:given: the lines $l_1=c_1y$, $l_2=c_2x$, $l_3=c_3(x+y-1)$ in the frame, a number $\lambda$, and either sign
  $\sigma=\pm1$
:let: $\mu=(1-\lambda)c_1c_2$, $\nu=\lambda c_3^2$, $\lambda'=\frac{\sigma\nu}{\mu+\sigma\nu}$
:then: $(1-\lambda)l_1l_2+\lambda l_3^2=(\mu+\sigma\nu)\bigl((1-\lambda')xy+\sigma\lambda'(x+y-1)^2\bigr)$; the two
  factors $\mu\pm\nu$ have the sum $2\mu$ and the difference $2\nu$, so they are not both 0 unless the conic is $0=0$
:method: An identity in $x$, $y$, $\lambda$, $c_1$, $c_2$, $c_3$.  Where $\mu+\sigma\nu=0$, one conic for each
  sign, the other sign serves.
:over: k: λ; c#: factors of the lines
:control: $\lambda'=\lambda$
:::
*/
CLAIM(every_scaling_takes_the_normal_form)
{
    num lambda = unknown(T, "k", 0), x = unknown(T, "x", 0), y = unknown(T, "y", 0), zero = from_int(0), factor[2];
    num c1 = positive(T, "c", 1), c2 = positive(T, "c", 2), c3 = positive(T, "c", 3), S[6], N[6];
    num l1[3] = {zero, c1, zero}, l2[3] = {c2, zero, zero}, l3[3] = {c3, c3, neg(c3)};
    num mu = mul(sub(from_int(1), lambda), mul(c1, c2)), nu = mul(lambda, mul(c3, c3));
    G(conic_liming)(lambda, l1, l2, l3, S);
    for (int k = 0; k < 2; k++) {
        int sign = k == 0 ? 1 : -1;
        num signed_nu = mul(from_int(sign), nu);
        factor[k] = add(mu, signed_nu);
        G(frame_conic)(fault(T, div(signed_nu, factor[k]), lambda), sign, N);
        about(T, sign > 0 ? "with the plus sign" : "with the minus sign");
        /* S = (μ + σν) ((1-λ') xy + σλ' (x+y-1)²) */
        same(T, G(form)(S, x, y), mul(factor[k], G(form)(N, x, y)));
    }
    about(T, "the two factors");
    same(T, add(factor[0], factor[1]), add(mu, mu));
    same(T, sub(factor[0], factor[1]), add(nu, nu));
}

#if RATIONAL
/*
:::{claim} scaled_lines_change_lambda
:title: A factor of a line's equation can change lambda
:zh: 直线方程乘以因子可改变 λ
:kind: counterexample
:data: l_1 = 0 2 0; l_2 = 1 0 0; l_3 = 1 1 -1; λ = 1/2; λ of (3.1.4), first with plus, then with minus = 1/2 1/2
:instead: λ of (3.1.4), first with plus, then with minus = 1/3 -1
:result: A : B of (3.1.3) = 1/2; A : B of (3.1.4), first with plus, then with minus = 2/3 2
:given: the three lines in the frame, each by the coefficients $a,b,c$ of $ax+by+c$, the equation of $l_1$ multiplied by a factor, and the same $\lambda$ for (3.1.3) and for (3.1.4)
  with either sign; $A$ and $B$ the coefficients of $x^2$ and $2xy$
:then: $(1-\lambda)l_1l_2+\lambda l_3^2$ is no multiple of (3.1.4)
:method: The coefficients of $x^2$ and $2xy$ of both conics are compared as a ratio.
:control: the $\lambda'$ of `every_scaling_takes_the_normal_form`
:::
*/
CLAIM(scaled_lines_change_lambda)
{
    num l[3][3], S[6], N[6], frame[2], other[2];
    G(given_lines)(T, l);
    num lambda = given(T, "λ");
    given_points(T, "λ of (3.1.4), first with plus, then with minus", 2, 1, frame);
    G(conic_liming)(lambda, l[0], l[1], l[2], S);
    num ratio = div(S[0], S[1]);
    int fits = 0;
    for (int k = 0; k < 2; k++) {
        G(frame_conic)(frame[k], k == 0 ? 1 : -1, N);
        other[k] = div(N[0], N[1]);
        fits += equal_q(ratio, other[k]);
    }
    found(T, "A : B of (3.1.3)", ratio);
    found_points(T, "A : B of (3.1.4), first with plus, then with minus", 2, 1, other);
    about(T, "whether one sign gives the conic (3.1.3)");
    agree(T, fits > 0);
}

/*
:::{claim} half_circle_has_no_frame
:title: The tangents at the ends of a half circle do not meet
:zh: 半圆两端切线不相交
:kind: counterexample
:data: l_1 = 1 0 -1; l_2 = 1 0 1; l_3 = 0 1 0; λ = 1/2
:instead: l_2 = 0 1 -1
:result: A, …, F = 1/2 0 1/2 0 0 -1/2; determinant of the two tangents = 0
:given: the tangents $l_1$ and $l_2$ of the unit circle at the ends of a diameter, the line $l_3$ of the diameter, and the
  $\lambda$ for which (3.1.3) is this circle, with the coefficients $A,\dots,F$ of (3.1.1); a line is given by the coefficients $a,b,c$ of $ax+by+c$
:then: $l_1$ and $l_2$ have no common point $R_1$
:method: The determinant $a_1b_2-a_2b_1$ of the two lines is computed.
:control: the tangent at another point for $l_2$
:::
*/
CLAIM(half_circle_has_no_frame)
{
    num l[3][3], S[6];
    G(given_lines)(T, l);
    G(conic_liming)(given(T, "λ"), l[0], l[1], l[2], S);
    found_points(T, "A, …, F", 6, 1, S);
    num d = sub(mul(l[0][0], l[1][1]), mul(l[1][0], l[0][1]));
    found(T, "determinant of the two tangents", d);
    about(T, "whether the lines meet");
    refute(T, is_zero_q(d));
}
#endif

/*
:::{statement} wang-ch3:3.1.4-lambda-from-point
:title: One point of the curve determines lambda
:zh: 曲线上一点确定 λ
:printed: As soon as one point $R$ of the curve is given, $\lambda$ is determined.
:holds-by: one_point_fixes_lambda
:hypothesis: end_points_leave_lambda_free | $R$ is neither $R_0$ nor $R_2$.

The sign in (3.1.4) is chosen first: the conic through $(\frac14,\frac14)$ has $\lambda=\frac15$ with the minus sign and
$\lambda=-\frac13$ with the plus sign.
:::

:::{claim} one_point_fixes_lambda
:title: The lambda of the conic through a given point
:zh: 过定点的曲线的 λ
:data: R = (1/4,1/4); λ of both signs, first minus = 1/5 -1/3
:given: a point $(x,y)$, a sign $\sigma=\pm1$, and any number $\kappa$; and the point $R=(\frac14,\frac14)$
:let: $\lambda=\frac{xy}{xy-\sigma(x+y-1)^2}$
:then: $(1-\lambda)xy+\sigma\lambda(x+y-1)^2=0$; and the value of (3.1.4) with $\kappa$ is
  $xy-\kappa\bigl(xy-\sigma(x+y-1)^2\bigr)$, so no other $\kappa$ fits, and a point of the curve with
  $xy=\sigma(x+y-1)^2$ has $xy=0=x+y-1$: it is $R_0$ or $R_2$; at $R$ the minus sign has $\lambda=\frac15$, the plus sign
  $\lambda=-\frac13$
:method: Identities in $x$, $y$, $\kappa$, for both signs; and the same at $R$.
:over: k: -
:control: $\sigma$ of the other sign in $\lambda$
:::
*/
CLAIM(one_point_fixes_lambda)
{
    num free[2] = {unknown(T, "x", 0), unknown(T, "y", 0)}, kappa = unknown(T, "k", 0), one = from_int(1), S[6];
    num R[2], known[2];
    given_points(T, "R", 1, 2, R);
    given_points(T, "λ of both signs, first minus", 2, 1, known);
    for (int sign = -1; sign < 2; sign += 2)
        for (int k = 0; k < 2; k++) { /* a variable point, then R */
            const num *P = k == 0 ? free : R;
            num s = sub(add(P[0], P[1]), one), xy = mul(P[0], P[1]);
            num d = sub(xy, mul(from_int(fault(T, sign, -sign)), mul(s, s))), lambda = div(xy, d);
            G(frame_conic)(lambda, sign, S);
            about(T, "the conic of this λ at the point");
            vanishes(T, G(form)(S, P[0], P[1]));
            G(frame_conic)(kappa, sign, S);
            about(T, "another conic at the point");
            /* the conic of κ at P = (x, y): xy - κ (xy - σ (x+y-1)²) */
            same(T, G(form)(S, P[0], P[1]), sub(xy, mul(kappa, d)));
            about(T, "λ at R");
            if (k == 1)
                same(T, lambda, known[sign > 0]);
        }
}

#if RATIONAL
/*
:::{claim} end_points_leave_lambda_free
:title: The points R0 and R2 lie on every member
:zh: 端点不能确定 λ
:kind: counterexample
:data: R = (1,0) (0,1); λ = 1/5 1/2
:instead: R = (1/4,1/4) (1/3,1/3)
:result: S(R) = 0 0 0 0
:given: the points $R=R_0$ and $R=R_2$ by their coordinates in the frame, the conic $S$ of (3.1.4) with the minus sign, and two values of $\lambda$
:then: for each point both $\lambda$ satisfy (3.1.4)
:method: The values $S(R)$ are computed, for $R_0$ with both $\lambda$, then for $R_2$.
:control: two points inside the triangle
:::
*/
CLAIM(end_points_leave_lambda_free)
{
    num R[4], lambda[2], value[4], S[6];
    int determined = 0;
    given_points(T, "R", 2, 2, R);
    given_points(T, "λ", 2, 1, lambda);
    for (int point = 0; point < 2; point++) {
        int fitting = 0;
        for (int k = 0; k < 2; k++) {
            G(frame_conic)(lambda[k], -1, S);
            value[2 * point + k] = G(form)(S, R[2 * point], R[2 * point + 1]);
            fitting += is_zero_q(value[2 * point + k]);
        }
        determined += fitting == 1;
    }
    found_points(T, "S(R)", 4, 1, value);
    about(T, "whether one of the two points has only one of the two λ");
    agree(T, determined > 0);
}
#endif

/*
:::{statement} wang-ch3:3.1.4-range
:title: Points of the triangle have lambda between 0 and 1
:zh: 三角形内的点对应的 λ
:printed: With the minus sign in (3.1.4), points $R\in\triangle R_0R_1R_2$ have $\lambda\in(0,1)$.
:holds-by: lambda_inside_the_triangle
:hypothesis: lambda_on_the_border | $R$ lies inside the triangle, not on its border.
:figure: limings_pencil
:::

With the minus sign the numbering has a meaning: inside the triangle $xy$ and $(x+y-1)^2$ are both positive, and
$\lambda:(1-\lambda)=xy:(x+y-1)^2$.

:::{claim} lambda_inside_the_triangle
:title: Inside the triangle lambda lies between 0 and 1
:zh: 三角形内部 0<λ<1
:given: a point inside the triangle, $x=\frac a{1+a+b}$, $y=\frac b{1+a+b}$ with $a,b>0$
:let: $\lambda=\frac{xy}{xy+(x+y-1)^2}$, the one of the conic with the minus sign through the point
:then: $\lambda=\frac{ab}{1+ab}$ and $1-\lambda=\frac1{1+ab}$, both positive
:method: Identities in $a$ and $b$; every point with $x>0$, $y>0$, $x+y<1$ has this form.
:scope: points inside the triangle
:over: a b: -
:control: the plus sign
:::
*/
CLAIM(lambda_inside_the_triangle)
{
    num a = positive(T, "a", 0), b = positive(T, "b", 0), one = from_int(1), total = add(one, add(a, b)), S[6];
    num x = div(a, total), y = div(b, total), s = sub(add(x, y), one), xy = mul(x, y), ss = mul(s, s);
    num lambda = div(xy, fault(T, add(xy, ss), sub(xy, ss))), ab = mul(a, b);
    G(frame_conic)(lambda, -1, S);
    about(T, "the conic of this λ at the point");
    vanishes(T, G(form)(S, x, y));
    about(T, "λ and 1 - λ");
    /* λ = ab/(1+ab), 1 - λ = 1/(1+ab) */
    same(T, lambda, div(ab, add(one, ab)));
    same(T, sub(one, lambda), div(one, add(one, ab)));
    G(must_be_positive)(T, div(ab, add(one, ab)));
    G(must_be_positive)(T, div(one, add(one, ab)));
}

#if RATIONAL
/*
:::{claim} lambda_on_the_border
:title: On the border of the triangle lambda can be 0 or 1
:zh: 三角形边界上 λ 可为 0 或 1
:kind: counterexample
:data: R = (1/2,0) (1/2,1/2)
:instead: R = (1/2,1/4) (1/4,1/4)
:result: λ of the two points = 0 1
:given: the minus sign in (3.1.4), and two points $R=(x,y)$ of the border, the middle of $R_1R_0$ and that of $R_0R_2$
:then: $\lambda$ is one end of the interval for the first, the other for the second
:method: $\lambda=\frac{xy}{xy+(x+y-1)^2}$ is computed.
:control: two points inside the triangle
:::
*/
CLAIM(lambda_on_the_border)
{
    num R[4], lambda[2], one = from_int(1);
    int between = 0;
    given_points(T, "R", 2, 2, R);
    for (int k = 0; k < 2; k++) {
        lambda[k] = G(lambda_at)(R[2 * k], R[2 * k + 1], -1);
        between += sign_q(lambda[k]) > 0 && compare_q(lambda[k], one) < 0;
    }
    found_points(T, "λ of the two points", 2, 1, lambda);
    about(T, "whether one of the two λ lies between 0 and 1");
    agree(T, between > 0);
}
#endif

#include "chapters/judge/claims_off.h"
