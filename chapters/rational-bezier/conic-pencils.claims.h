/*
# Conics as a pencil (二次曲线束)

Two conics span a family of conics that share their common points.  A conic is $S=(A,B,C,D,E,F)$, a line
$l=(a,b,c)$; $l_i$ stands for the line and for its left-hand side $ax+by+c$.
*/
#include "exact/record/roots.h"

#include "chapters/judge/claims_on.h"
#include "chapters/rational-bezier/conics.h"

/*
## The quadratic equation

:::{statement} wang-ch3:3.1.1
:title: A conic is a quadratic equation in affine coordinates
:zh: 二次曲线的隐式方程
:printed: A conic section, also called a quadratic curve, can be given in an affine coordinate system of the plane by the
  quadratic implicit equation $S=S(x,y)=Ax^2+2Bxy+Cy^2+2Dx+2Ey+F=0$.
:holds-by: plane_sections_of_a_cone_are_quadratic
:confirmed-by: conic_value_and_gradient conic_invariants_are_determinants
:meant: the name, conic section (圆锥曲线) | A conic section is a curve in which a plane cuts a right circular cone, an ellipse, a parabola or a hyperbola; for the degenerate cuts it
  is true as well.

A quadratic equation asks for $(A,B,C)\ne(0,0,0)$.  The converse is not said.
:::

:::{claim} plane_sections_of_a_cone_are_quadratic
:title: A plane cuts a right circular cone in a quadratic curve, in any affine coordinates of the plane
:zh: 平面与直圆锥的截线在任意仿射坐标下为二次曲线
:given: the right circular cone $X^2+Y^2=c^2Z^2$, $c>0$, and the points $O+xU+yV$ of a plane with any origin $O$ and any two directions $U$, $V$ that span it
:let: $q(P,Q)=P_1Q_1+P_2Q_2-c^2P_3Q_3$ and $A=q(U,U)$, $B=q(U,V)$, $C=q(V,V)$, $D=q(O,U)$, $E=q(O,V)$, $F=q(O,O)$
:then: $X^2+Y^2-c^2Z^2=Ax^2+2Bxy+Cy^2+2Dx+2Ey+F$ at $O+xU+yV$; $(A+c^2U_3^2)(C+c^2V_3^2)=(B+c^2U_3V_3)^2+(U_1V_2-U_2V_1)^2$; and for
  $V=(kU_1,kU_2,v)$ it is $B=kA+c^2U_3(kU_3-v)$
:method: Identities in $c$, $O$, $U$, $V$, $x$, $y$, $k$ and $v$.  If $A$, $B$ and $C$ were 0, then $U_1V_2=U_2V_1$ by the second one; $(U_1,U_2)$ and
  $(V_1,V_2)$ are not 0, as $U_1^2+U_2^2=c^2U_3^2$ and $U\ne0$, so that $V=(kU_1,kU_2,v)$, and by the third one $v=kU_3$: $U$ and $V$ would be
  parallel, and span no plane.  So the equation is quadratic.
:over: c O# U# V# k v: -; x# y#: points
:scope: every plane and every right circular cone
:harmless: $c>0$ | every right circular cone has such a $c$
:control: the term $xy$ counted once, not twice
:::
*/
CLAIM(plane_sections_of_a_cone_are_quadratic)
{
    num c = positive(T, "c", 0), square = mul(c, c), x = unknown(T, "x", 0), y = unknown(T, "y", 0), frame[3][3],
        q[3][3], P[3];
    static const char *const name[] = {"O", "U", "V"};
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++)
            frame[k][j] = unknown(T, name[k], j);
    const num *U = frame[1], *V = frame[2];
    for (int k = 0; k < 3; k++)
        for (int m = 0; m < 3; m++) {
            const num *a = frame[k], *b = frame[m];
            q[k][m] = sub(add(mul(a[0], b[0]), mul(a[1], b[1])), mul(square, mul(a[2], b[2])));
        }
    for (int j = 0; j < 3; j++)
        P[j] = add(frame[0][j], add(mul(x, U[j]), mul(y, V[j])));
    num S[6] = {q[1][1], fault(T, q[1][2], mul(from_ratio(1, 2), q[1][2])), q[2][2], q[0][1], q[0][2], q[0][0]};
    about(T, "the cone in the points of the plane");
    same(T, sub(add(mul(P[0], P[0]), mul(P[1], P[1])), mul(square, mul(P[2], P[2]))), G(form)(S, x, y));
    about(T, "the quadratic part");
    num first = add(q[1][1], mul(square, mul(U[2], U[2]))), last = add(q[2][2], mul(square, mul(V[2], V[2])));
    num middle = add(q[1][2], mul(square, mul(U[2], V[2]))), turn = sub(mul(U[0], V[1]), mul(U[1], V[0]));
    same(T, mul(first, last), add(mul(middle, middle), mul(turn, turn)));
    about(T, "directions over one line");
    num k = unknown(T, "k", 0), v = unknown(T, "v", 0);
    num mixed = sub(add(mul(U[0], mul(k, U[0])), mul(U[1], mul(k, U[1]))), mul(square, mul(U[2], v)));
    same(T, mixed, add(mul(k, q[1][1]), mul(mul(square, U[2]), sub(mul(k, U[2]), v))));
}

/*
The kernels of the conics are these formulas.


:::{claim} conic_value_and_gradient
:title: The value of a conic and its gradient
:zh: 二次式的值与梯度
:given: a conic $S$, a point $(x,y)$ and a step $h$
:then: the kernel's value is $Ax^2+2Bxy+Cy^2+2Dx+2Ey+F$, and its gradient $(S_x,S_y)$ satisfies
  $2hS_x=S(x+h,y)-S(x-h,y)$, $2hS_y=S(x,y+h)-S(x,y-h)$
:method: The other side is the formula written out term by term.  For a quadratic polynomial the central difference
  is the derivative, so no derivative is taken.
:defines: conic_value conic_gradient
:over: S#: conics; h: -
:control: the product $xy$ counted once, not twice
:::
*/
CLAIM(conic_value_and_gradient)
{
    num S[6], g[2], x = unknown(T, "x", 0), y = unknown(T, "y", 0), h = positive(T, "h", 0), twice = add(h, h);
    G(six)(T, "S", S);
    num value = G(conic_value)(S, x, y);
    G(conic_gradient)(S, x, y, g);
    S[1] = fault(T, S[1], mul(from_ratio(1, 2), S[1]));
    about(T, "the value");
    same(T, value, G(form)(S, x, y));
    about(T, "the gradient");
    /* 2h S_x = S(x+h, y) - S(x-h, y), 2h S_y = S(x, y+h) - S(x, y-h) */
    same(T, mul(twice, g[0]), sub(G(form)(S, add(x, h), y), G(form)(S, sub(x, h), y)));
    same(T, mul(twice, g[1]), sub(G(form)(S, x, add(y, h)), G(form)(S, x, sub(y, h))));
}

/*
:::{claim} conic_invariants_are_determinants
:title: The two determinants of a conic
:zh: 二次曲线的两个行列式
:given: a conic $S$
:then: the kernels `conic_delta` and `conic_determinant` are the determinants of its $2\times2$ matrix
  $\begin{pmatrix}A&B\\B&C\end{pmatrix}$ and of its $3\times3$ matrix
  $\begin{pmatrix}A&B&D\\B&C&E\\D&E&F\end{pmatrix}$
:method: The other side is Bird's algorithm for determinants of any order.
:defines: conic_delta conic_determinant
:over: S#: conics
:control: $E$ taken for $D$ in the last row
:::
*/
CLAIM(conic_invariants_are_determinants)
{
    num S[6];
    G(six)(T, "S", S);
    num small[4] = {S[0], S[1], S[1], S[2]};
    num large[9] = {S[0], S[1], S[3], S[1], S[2], S[4], fault(T, S[3], S[4]), S[4], S[5]};
    same(T, G(conic_delta)(S), G(determinant)(2, small));
    same(T, G(conic_determinant)(S), G(determinant)(3, large));
}

/*
## Conics through the common points of two

Where two conics meet, every combination of their equations vanishes.  So the pencil (曲线束) consists of conics through the
common points, and this needs no hypothesis.  The sentence may also mean that the pencil has all of them; then it asks for
more.  Through four points of which no three are on a line the conics are the combinations of two, with two free factors.
But the print ties the factors together as $1-\lambda$ and $\lambda$, whose sum is 1, and a combination with the sum 0, such
as $S_1-S_2$, has no $\lambda$.

:::{statement} wang-ch3:3.1.2
:title: The pencil through the common points of two conics
:zh: 过两条二次曲线交点的曲线束
:printed: With $\lambda$ as the parameter of the family the quadratic implicit equation
  $(1-\lambda)S_1(x,y)+\lambda S_2(x,y)=(1-\lambda)S_1+\lambda S_2=0$ represents the pencil of the conics through the common points of
  $S_1(x,y)=0$ and $S_2(x,y)=0$.
:holds-by: pencil_passes_through_common_points conics_through_four_points_are_a_pencil
:hypothesis: pencil_misses_its_difference | $\lambda=\infty$ is admitted: the ratio $(1-\lambda):\lambda=1:(-1)$; otherwise the
  member $S_1-S_2=0$ is missing.
:hypothesis: two_common_points_allow_other_conics | $S_1=0$ and $S_2=0$ have four common points, no three on a line;
  through fewer there may be conics that are no members.
:hypothesis: dependent_conics_have_no_pencil | $S_2$ is no multiple of $S_1$.
:meant: the sentence behind (3.1.4), by which a point $R$ of the curve determines $\lambda$ | The members are all the
  conics through the common points, which asks for the hypotheses.
:reading: pencil_passes_through_common_points | Every member passes through the common points.  This needs none of the
  hypotheses.
:reading: pencil_misses_its_difference | The members are all the conics through the common points, without the hypotheses.
:figure: pencil_of_conics
:::

:::{claim} pencil_passes_through_common_points
:title: Every member of the pencil passes through every common point
:zh: 曲线束的每条曲线都过公共点
:given: conics $S_1$, $S_2$ with a common point $(x,y)$, and a number $\lambda$
:then: $S=(1-\lambda)S_1+\lambda S_2$ vanishes there; at any point $(u,v)$ its value is
  $(1-\lambda)S_1(u,v)+\lambda S_2(u,v)$
:method: $A,\dots,E$ of both conics, both points and $\lambda$ are variables; $F$ is computed so that $(x,y)$ lies on
  both.  Values are sums of terms, not the kernel `conic_value`.
:defines: conic_pencil
:over: S# Q#: conics; l: λ; u# v#: points
:control: the constant term taken from $S_2$ alone
:::
*/
CLAIM(pencil_passes_through_common_points)
{
    num S1[6], S2[6], S[6], lambda = unknown(T, "l", 0), mu = sub(from_int(1), lambda);
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), u = unknown(T, "u", 0), v = unknown(T, "v", 0);
    G(six)(T, "S", S1);
    G(six)(T, "Q", S2);
    S1[5] = S2[5] = from_int(0);
    S1[5] = neg(G(form)(S1, x, y));
    S2[5] = neg(G(form)(S2, x, y));
    G(conic_pencil)(lambda, S1, S2, S);
    S[5] = fault(T, S[5], S2[5]);
    about(T, "the value at the common point");
    vanishes(T, G(form)(S, x, y));
    about(T, "the value at any point");
    /* S(u, v) = (1-λ) S_1(u, v) + λ S_2(u, v) */
    same(T, G(form)(S, u, v), add(mul(mu, G(form)(S1, u, v)), mul(lambda, G(form)(S2, u, v))));
}

/*
:::{claim} conics_through_four_points_are_a_pencil
:title: The conics through four points in general position are the combinations of two
:zh: 过四个一般位置点的二次曲线构成二维空间
:given: points $(0,0)$, $(1,0)$, $(0,1)$ and $(a,b)$, $ab\ne0$, and any conic $S$
:where: no three of the four points are on a line
:let: $U=x^2-x-\frac{a-1}bxy$ and $V=y^2-y-\frac{b-1}axy$
:then: $S$ is $AU+CV$ plus its four values at the points, each multiplied by a fixed conic that is 1 at its own point
  and 0 at the others; so a conic through the four points is $AU+CV$, and any two independent ones span them all
:method: An identity of polynomials in $x$ and $y$, with $S$, $a$ and $b$ variables.  Four points of which no three lie
  on a line are the affine image of such four.
:over: S#: conics; a# b#: points
:control: $U$ with $a$ for $a-1$
:::
*/
CLAIM(conics_through_four_points_are_a_pencil)
{
    num S[6], a = unknown(T, "a", 0), b = unknown(T, "b", 0), x = unknown(T, "x", 0), y = unknown(T, "y", 0);
    num zero = from_int(0), one = from_int(1), xy = mul(x, y);
    G(six)(T, "S", S);
    num U = sub(mul(x, sub(x, one)), mul(div(fault(T, sub(a, one), a), b), xy));
    num V = sub(mul(y, sub(y, one)), mul(div(sub(b, one), a), xy));
    num W = div(xy, mul(a, b)); /* 1 at (a, b), 0 at the others; so are the factors of the others below */
    /* S = AU + CV + S(a,b) W + S(1,0) (x - aW) + S(0,1) (y - bW) + S(0,0) (1 - x - y - (1-a-b) W) */
    num sum = add(mul(S[0], U), mul(S[2], V));
    sum = add(sum, mul(G(form)(S, a, b), W));
    sum = add(sum, mul(G(form)(S, one, zero), sub(x, mul(a, W))));
    sum = add(sum, mul(G(form)(S, zero, one), sub(y, mul(b, W))));
    sum = add(sum, mul(G(form)(S, zero, zero), sub(sub(one, add(x, y)), mul(sub(sub(one, a), b), W))));
    same(T, G(form)(S, x, y), sum);
}

#if RATIONAL
/* Whether the conic S passes through the points; its values there are the result of that name. */
static int passes_through(trial *T, const char *name, const num S[], int count, const num P[])
{
    num value[4];
    int on_it = 1;
    for (int k = 0; k < count; k++) {
        value[k] = G(form)(S, P[2 * k], P[2 * k + 1]);
        on_it &= is_zero_q(value[k]);
    }
    found_points(T, name, count, 1, value);
    return on_it;
}

/* The determinant of the coefficients A, B, C of three conics: 0 when one of them is in the pencil of the others. */
static num of_quadratic_parts(num S[3][6])
{
    num rows[9];
    for (int k = 0; k < 9; k++)
        rows[k] = S[k / 3][k % 3];
    return G(determinant)(3, rows);
}

/*
Three small examples show what goes wrong without each of the three hypotheses.  In the first the two conics are pairs of
parallel lines, and the missing member is the pair of the diagonals.

:::{claim} pencil_misses_its_difference
:title: One conic through the common points has no lambda
:zh: 曲线束漏掉一条曲线
:kind: counterexample
:data: S_1 = 1 0 0 0 0 -1; S_2 = 0 0 1 0 0 -1; S = 1 0 -1 0 0 0; P = (1,1) (1,-1) (-1,1) (-1,-1)
:instead: S = 1 0 1 0 0 -2
:result: S_1(P) = 0 0 0 0; S_2(P) = 0 0 0 0; S(P) = 0 0 0 0; values of λ that fit = 0
:given: two pairs of parallel lines, $S_1$ and $S_2$, which meet in the four points $P$, and the pair of lines $S=S_1-S_2$
  through these; a conic is given by the $A,\dots,F$ of (3.1.1)
:then: for no $\lambda$ is $(1-\lambda)S_1+\lambda S_2$ a multiple of $S$
:method: The coefficients of $x^2$ and $y^2$ of a member and of the conic form a determinant, a polynomial of degree
  at most 1 in $\lambda$, whose real zeros are counted.
:control: the circle through the four points, which is the member in the middle
:::
*/
CLAIM(pencil_misses_its_difference)
{
    num S1[6], S2[6], S[6], P[8];
    given_points(T, "S_1", 6, 1, S1);
    given_points(T, "S_2", 6, 1, S2);
    given_points(T, "S", 6, 1, S);
    given_points(T, "P", 4, 2, P);
    int on_first = passes_through(T, "S_1(P)", S1, 4, P), on_second = passes_through(T, "S_2(P)", S2, 4, P);
    int fits = passes_through(T, "S(P)", S, 4, P), count = members_like(S1, S2, S, 0, 2);
    found_whole(T, "values of λ that fit", count);
    about(T, "whether the conic, which passes through the four points, is a member");
    refute(T, on_first && on_second && fits && count == 0);
}

/*
:::{claim} two_common_points_allow_other_conics
:title: Through two common points pass conics that are no members
:zh: 公共点太少时还有别的二次曲线
:kind: counterexample
:data: S_1 = 0 1/2 0 0 0 0; S_2 = 1 1 1 -1 -1 1; S = 1 1/2 0 -1/2 0 0; P = (1,0) (0,1)
:instead: S = 1 2 1 -1 -1 1
:result: S_1(P) = 0 0; S_2(P) = 0 0; S(P) = 0 0; determinant = 1/2
:given: the two axes, $S_1=xy$, a double line, $S_2=(x+y-1)^2$, their only common points $P$, and the conic $S=x(x+y-1)$
  through both; a conic is given by the $A,\dots,F$ of (3.1.1)
:then: the three conics are independent
:method: The determinant of their coefficients of $x^2$, $2xy$ and $y^2$ is 0 for a member of the pencil.
:control: the combination $2S_1+S_2$ in place of the third conic
:::
*/
CLAIM(two_common_points_allow_other_conics)
{
    num S[3][6], P[4];
    given_points(T, "S_1", 6, 1, S[0]);
    given_points(T, "S_2", 6, 1, S[1]);
    given_points(T, "S", 6, 1, S[2]);
    given_points(T, "P", 2, 2, P);
    int on_first = passes_through(T, "S_1(P)", S[0], 2, P), on_second = passes_through(T, "S_2(P)", S[1], 2, P);
    int fits = passes_through(T, "S(P)", S[2], 2, P);
    num determinant = of_quadratic_parts(S);
    found(T, "determinant", determinant);
    about(T, "determinant of the three rows (A, B, C), which is 0 for a member");
    if (on_first && on_second && fits)
        vanishes(T, determinant);
}

/*
:::{claim} dependent_conics_have_no_pencil
:title: When one conic is a multiple of the other, a member may be 0 = 0
:zh: 两条二次曲线相关时
:kind: counterexample
:data: S_1 = 1 0 1 0 0 -1; S_2 = -1 0 -1 0 0 1; λ = 1/2
:instead: λ = 1/3
:result: member = 0 0 0 0 0 0
:given: the unit circle $S_1$, $S_2=-S_1$, and $\lambda$; a conic is given by the $A,\dots,F$ of (3.1.1)
:then: the member of $\lambda$ is $0=0$, which is no conic
:method: The coefficients of the member.
:control: another $\lambda$
:::
*/
CLAIM(dependent_conics_have_no_pencil)
{
    num S1[6], S2[6], S[6];
    given_points(T, "S_1", 6, 1, S1);
    given_points(T, "S_2", 6, 1, S2);
    G(conic_pencil)(given(T, "λ"), S1, S2, S);
    found_points(T, "member", 6, 1, S);
    int zero = 1;
    for (int k = 0; k < 6; k++)
        zero &= is_zero_q(S[k]);
    about(T, "whether the member is an equation at all");
    refute(T, zero);
}

/*
:::{statement} wang-ch3:3.1.2-lambda
:title: What determines lambda
:zh: λ 由什么确定
:printed: The value of $\lambda$ is determined by the coordinates of the common points.
:class: false
:refuted-by: common_points_leave_lambda_free
:corrected: The value of $\lambda$ is determined by one further point $P$ of the curve:
  $\lambda=\frac{S_1(P)}{S_1(P)-S_2(P)}$, where $S_1(P)\ne S_2(P)$.
:corrected-by: a_further_point_fixes_lambda
:striking: 4
:figure: pencil_of_conics

After (3.1.4) the source itself uses one point of the curve to find $\lambda$.
:::

:::{claim} common_points_leave_lambda_free
:title: The common points lie on every member
:zh: 公共点不能确定 λ
:kind: counterexample
:data: S_1 = 1 0 0 0 0 -1; S_2 = 0 0 1 0 0 -1; P = (1,1) (1,-1) (-1,1) (-1,-1); λ = 1/3 1/2 2/3
:instead: P = (2,0) (2,0) (2,0) (2,0); λ = 1/3 1/2 3/4
:result: values of λ that fit = 3
:given: two pairs of parallel lines, $S_1$ and $S_2$, which meet in the four points $P$, and three values of $\lambda$; a conic is given by the $A,\dots,F$ of (3.1.1)
:then: all three $\lambda$ satisfy the equation at all four points
:method: The values $S(x,y)$ of the three members are computed at the points; if the points determined $\lambda$, one
  $\lambda$ would be left.
:control: a point that is no common point, on the member of the last $\lambda$, in place of the four
:::
*/
CLAIM(common_points_leave_lambda_free)
{
    num S1[6], S2[6], S[6], P[8], lambda[3];
    given_points(T, "S_1", 6, 1, S1);
    given_points(T, "S_2", 6, 1, S2);
    given_points(T, "P", 4, 2, P);
    given_points(T, "λ", 3, 1, lambda);
    int fitting = 0;
    for (int k = 0; k < 3; k++) {
        int fits = 1;
        G(conic_pencil)(lambda[k], S1, S2, S);
        for (int i = 0; i < 4; i++)
            fits &= is_zero_q(G(form)(S, P[2 * i], P[2 * i + 1]));
        fitting += fits;
    }
    found_whole(T, "values of λ that fit", fitting);
    about(T, "whether only one of the values of λ fits");
    agree(T, fitting == 1);
}
#endif

/*
:::{claim} a_further_point_fixes_lambda
:title: One further point of the curve fixes lambda
:zh: 曲线上另一点确定 λ
:given: conics $S_1$, $S_2$, a point $P$ with $S_1(P)\ne S_2(P)$, and any number $\kappa$
:where: $S_1(P)\ne S_2(P)$
:let: $\lambda=S_1(P)/(S_1(P)-S_2(P))$
:then: the member of $\lambda$ passes through $P$, and the value at $P$ of the member of $\kappa$ is
  $(\kappa-\lambda)(S_2(P)-S_1(P))$, so no other member does
:method: Identities in the coefficients of both conics, $P$ and $\kappa$.
:over: S# Q#: conics; k: κ
:control: $\lambda=S_1(P)/(S_1(P)+S_2(P))$
:::
*/
CLAIM(a_further_point_fixes_lambda)
{
    num S1[6], S2[6], S[6], x = unknown(T, "x", 0), y = unknown(T, "y", 0), kappa = unknown(T, "k", 0);
    G(six)(T, "S", S1);
    G(six)(T, "Q", S2);
    num f1 = G(form)(S1, x, y), f2 = G(form)(S2, x, y), lambda = div(f1, fault(T, sub(f1, f2), add(f1, f2)));
    G(conic_pencil)(lambda, S1, S2, S);
    about(T, "the member of the given λ at P");
    vanishes(T, G(form)(S, x, y));
    G(conic_pencil)(kappa, S1, S2, S);
    about(T, "another member at P");
    /* S(P) = (κ - λ) (S_2(P) - S_1(P)) */
    same(T, G(form)(S, x, y), mul(sub(kappa, lambda), sub(f2, f1)));
}

/*
:::{statement} wang-ch3:3.1.2-ends
:title: The members of lambda = 0 and 1
:zh: λ=0,1 时的曲线
:printed: $\lambda=0,1$ give $S_1=0$ and $S_2=0$, in this order.
:holds-by: pencil_begins_and_ends_with_the_two_conics
:::

:::{claim} pencil_begins_and_ends_with_the_two_conics
:title: The pencil begins with the first conic and ends with the second
:zh: 曲线束的两端
:given: conics $S_1$, $S_2$
:then: $(1-\lambda)S_1+\lambda S_2$ is $S_1$ for $\lambda=0$ and $S_2$ for $\lambda=1$
:method: The six coefficients, compared in the field.
:over: S# Q#: conics
:control: the two ends exchanged
:::
*/
CLAIM(pencil_begins_and_ends_with_the_two_conics)
{
    num S1[6], S2[6], S[6];
    G(six)(T, "S", S1);
    G(six)(T, "Q", S2);
    for (int end = 0; end < 2; end++) {
        G(conic_pencil)(from_int(fault(T, end, 1 - end)), S1, S2, S);
        for (int k = 0; k < 6; k++)
            same(T, S[k], end == 0 ? S1[k] : S2[k]);
    }
}

/*
## Two pairs of lines

:::{statement} wang-ch3:3.1.2-degenerate
:title: A pair of lines is a degenerate conic
:zh: 直线偶是退化的二次曲线
:printed: A pair of lines can be regarded as a degenerate conic.
:holds-by: line_pair_is_a_degenerate_conic
:::

:::{claim} line_pair_is_a_degenerate_conic
:title: The product of two linear forms is a conic with determinant 0
:zh: 两条直线之积
:given: the line $l_1$ through two points $p$, $q$, a line $l_2$ and a point $(x,y)$
:then: $l_1$ has at $(x,y)$ the value $(q-p)\times((x,y)-p)$; the product of the two lines is a
  conic $S$ with $S(x,y)=l_1(x,y)l_2(x,y)$, and its $3\times3$ determinant is 0; $2(A^2+2B^2+C^2)=|\mathbf u|^2|\mathbf v|^2+(\mathbf u\cdot\mathbf v)^2$ with
  $\mathbf u$, $\mathbf v$ the first two coefficients of $l_1$, $l_2$
:method: The other sides are a determinant of two vectors, the product of two values and scalar products, every coefficient a variable.  Neither $\mathbf u$ nor
  $\mathbf v$ is $\mathbf 0$ for a line, so by the last equation $A$, $B$ and $C$ are not all 0: the equation is quadratic.
:defines: line_through line_pair
:over: p# q#: points; l#: lines
:control: the coefficient $B$ doubled
:::
*/
CLAIM(line_pair_is_a_degenerate_conic)
{
    num p[2], q[2], l1[3], l2[3], S[6], x = unknown(T, "x", 0), y = unknown(T, "y", 0);
    for (int c = 0; c < 2; c++) {
        p[c] = unknown(T, "p", c);
        q[c] = unknown(T, "q", c);
    }
    for (int c = 0; c < 3; c++)
        l2[c] = unknown(T, "l", c);
    G(line_through)(p, q, l1);
    about(T, "the line through p and q");
    /* (q - p) × ((x, y) - p) */
    num turn = sub(mul(sub(q[0], p[0]), sub(y, p[1])), mul(sub(q[1], p[1]), sub(x, p[0])));
    same(T, G(on_line)(l1, x, y), turn);
    G(line_pair)(l1, l2, S);
    S[1] = fault(T, S[1], add(S[1], S[1]));
    about(T, "the product of two lines");
    same(T, G(form)(S, x, y), mul(turn, G(on_line)(l2, x, y)));
    about(T, "its determinant");
    vanishes(T, G(conic_determinant)(S));
    about(T, "its quadratic part");
    /* 2 (A² + 2B² + C²) = |u|² |v|² + (u·v)² */
    num squares = add(add(mul(S[0], S[0]), mul(from_int(2), mul(S[1], S[1]))), mul(S[2], S[2])), uv = G(dot)(2, l1, l2);
    same(T, mul(from_int(2), squares), add(mul(G(norm_squared)(2, l1), G(norm_squared)(2, l2)), mul(uv, uv)));
}

/*
Liming's idea is to take the simplest conics for $S_1$ and $S_2$: pairs of lines.  Their common points are seen without
solving an equation, as the four points where a line of the one pair meets a line of the other.  What was assumed of the
common points is now a matter of how the four lines lie.

:::{statement} wang-ch3:3.1.2-line-pairs
:title: The pencil of two pairs of lines
:zh: 两对直线确定的曲线束
:printed: $(1-\lambda)l_1l_2+\lambda l_3l_4=0$ represents the pencil of the conics through the four points where the
  lines of the pair $(l_1,l_2)$ meet those of the pair $(l_3,l_4)$.
:holds-by: line_pairs_share_four_points conics_through_four_points_are_a_pencil
:needs: parallel_lines_meet_in_two_points | the sentence itself, by which the pairs meet two by two in four points | each of
  $l_1,l_2$ meets each of $l_3,l_4$ in one point.
:needs: concurrent_lines_lose_a_point | the sentence itself, which has four points | the four points of the two pairs are different.
:hypothesis: diagonals_are_no_member | $\lambda=\infty$ is admitted; otherwise the member $l_1l_2-l_3l_4=0$ is missing.
:meant: (3.1.2), of which this is a case | The members are all the conics through the four points.
:figure: pencil_of_conics

That no three of the four points are on a line follows when they are four different ones, and so does that $l_3l_4$ is no multiple of $l_1l_2$: $l_3$
meets $l_1$ and $l_2$ in one point each, so it is neither of them.  That every member passes through the points where the pairs meet needs neither
that they are different nor $\lambda=\infty$; it is linear in the factors $1-\lambda$ and $\lambda$, hence true for the factors $1$ and $-1$ of $\lambda=\infty$, too.
:::

:::{claim} line_pairs_share_four_points
:title: Every member passes through the four points where the pairs meet
:zh: 直线偶曲线束过四交点
:given: lines $l_1,l_2,l_3,l_4$ such that $l_i$ and $l_j$ meet for $i=1,2$ and $j=3,4$, and a number $\lambda$
:then: $(1-\lambda)l_1l_2+\lambda l_3l_4$ vanishes at the four common points; and of the points $l_i\times l_j$, $l_i\times l_m$, $l_h\times l_j$ with $\{h,i\}=\{1,2\}$,
  $\{j,m\}=\{3,4\}$, in homogeneous coordinates, the determinant is $\det(l_i,l_j,l_m)\det(l_i,l_h,l_j)$
:method: The points are computed from the lines by Cramer's rule, all twelve coefficients and $\lambda$ being
  variables.  Three of the four points are on a line only if one of the two determinants is 0, three of the lines have a point in common, and two of the four points are one.
:over: l#: lines; k: λ
:control: the pairs taken as $(l_1,l_3)$ and $(l_2,l_4)$
:::
*/
CLAIM(line_pairs_share_four_points)
{
    num l[4][3], S1[6], S2[6], S[6], lambda = unknown(T, "k", 0);
    for (int i = 0; i < 4; i++)
        for (int c = 0; c < 3; c++)
            l[i][c] = unknown(T, "l", 3 * i + c);
    G(line_pair)(l[0], l[fault(T, 1, 2)], S1);
    G(line_pair)(l[fault(T, 2, 1)], l[3], S2);
    G(conic_pencil)(lambda, S1, S2, S);
    for (int i = 0; i < 2; i++)
        for (int j = 2; j < 4; j++) {
            num z = sub(mul(l[i][0], l[j][1]), mul(l[i][1], l[j][0]));
            /* l_i × l_j, as a point */
            num x = div(sub(mul(l[i][1], l[j][2]), mul(l[i][2], l[j][1])), z);
            num y = div(sub(mul(l[i][2], l[j][0]), mul(l[i][0], l[j][2])), z);
            about(T, "a member at a common point");
            vanishes(T, G(form)(S, x, y));
            const num *a = l[i], *b = l[j], *c = l[5 - j], *d = l[1 - i];
            num P[3][3];
            G(cross3)(a, b, P[0]);
            G(cross3)(a, c, P[1]);
            G(cross3)(d, b, P[2]);
            about(T, "three of the points on a line");
            same(T, G(det3)(P[0], P[1], P[2]), mul(G(det3)(a, b, c), G(det3)(a, d, b)));
        }
}

#if RATIONAL
/* The different points P that the lines of two pairs have in common, and how many, parallel ones having none. */
static int meeting_points(num l[4][3], num P[])
{
    int count = 0;
    for (int i = 0; i < 2; i++)
        for (int j = 2; j < 4; j++) {
            num z = sub(mul(l[i][0], l[j][1]), mul(l[i][1], l[j][0]));
            if (is_zero_q(z))
                continue;
            num x = div(sub(mul(l[i][1], l[j][2]), mul(l[i][2], l[j][1])), z);
            num y = div(sub(mul(l[i][2], l[j][0]), mul(l[i][0], l[j][2])), z);
            int seen = 0;
            for (int k = 0; k < count; k++)
                seen |= equal_q(P[2 * k], x) && equal_q(P[2 * k + 1], y);
            P[2 * count] = x;
            P[2 * count + 1] = y;
            count += !seen;
        }
    return count;
}

/* The lines l_1, ..., l_4 of the data of the claim, by their coefficients a, b, c. */
static void given_lines(trial *T, num l[4][3])
{
    static const char *const name[] = {"l_1", "l_2", "l_3", "l_4"};
    for (int i = 0; i < 4; i++)
        given_points(T, name[i], 3, 1, l[i]);
}

/*
Parallel lines lose a point, and so do three lines through one point; the pencil then has fewer conics than pass through
what is left.  The last example is the square with its diagonals, which is the missing difference once more.

:::{claim} parallel_lines_meet_in_two_points
:title: Parallel lines of the two pairs leave two of the four points
:zh: 平行时四点只剩两点
:kind: counterexample
:data: l_1 = 1 0 0; l_2 = 0 1 0; l_3 = 1 0 -1; l_4 = 0 1 -1
:instead: l_3 = 1 1 -3; l_4 = 1 -1 -1
:result: common points = (0,1) (1,0)
:given: the pair of the axes $l_1$, $l_2$, and a pair $l_3$, $l_4$ of which each is parallel to one of the axes; a line is given by the coefficients $a,b,c$ of $ax+by+c$
:then: only two of the four points exist
:method: The common points of the lines are computed and counted.
:control: a second pair that is parallel to no axis
:::
*/
CLAIM(parallel_lines_meet_in_two_points)
{
    num l[4][3], P[8];
    given_lines(T, l);
    int count = meeting_points(l, P);
    found_points(T, "common points", count, 2, P);
    about(T, "whether the common points are four");
    agree(T, count == 4);
}

/*
:::{claim} concurrent_lines_lose_a_point
:title: With three lines through one point there are other conics
:zh: 三线共点时
:kind: counterexample
:data: l_1 = 1 0 0; l_2 = 0 1 0; l_3 = 1 -1 0; l_4 = 1 1 -1; S = 1 0 1 -1/2 -1/2 0
:instead: S = 1 1 -1 -1/2 1/2 0
:result: common points = (0,0) (0,1) (1,0); S(P) = 0 0 0; determinant = -1
:given: the pair of the axes $l_1$, $l_2$, a pair $l_3$, $l_4$ of which one line passes through the origin, and a circle $S$ through
  the common points, which are three; a line is given by the coefficients $a,b,c$ of $ax+by+c$, the circle by the $A,\dots,F$ of (3.1.1)
:then: the circle is no member of the pencil
:method: The determinant of the coefficients of $x^2$, $2xy$ and $y^2$ of $l_1l_2$, $l_3l_4$ and the conic is 0 for a
  member.
:control: $2l_1l_2+l_3l_4$ in place of the circle
:::
*/
CLAIM(concurrent_lines_lose_a_point)
{
    num l[4][3], S[3][6], P[8];
    given_lines(T, l);
    given_points(T, "S", 6, 1, S[2]);
    G(line_pair)(l[0], l[1], S[0]);
    G(line_pair)(l[2], l[3], S[1]);
    int count = meeting_points(l, P);
    found_points(T, "common points", count, 2, P);
    int fits = passes_through(T, "S(P)", S[2], count, P);
    num determinant = of_quadratic_parts(S);
    found(T, "determinant", determinant);
    about(T, "determinant of the three rows (A, B, C), which is 0 for a member");
    if (fits)
        vanishes(T, determinant);
}

/*
:::{claim} diagonals_are_no_member
:title: The diagonals of the square pass through its corners and have no lambda
:zh: 正方形的对角线不在曲线束中
:kind: counterexample
:data: l_1 = 1 0 0; l_2 = 1 0 -1; l_3 = 0 1 0; l_4 = 0 1 -1; S = 1 0 -1 -1/2 1/2 0
:instead: S = 1 0 1 -1/2 -1/2 0
:result: common points = (0,0) (0,1) (1,0) (1,1); S(P) = 0 0 0 0; values of λ that fit = 0
:given: the pairs $l_1$, $l_2$ and $l_3$, $l_4$ of the opposite sides of a square, and the pair of its diagonals $S$; a line is given by the coefficients $a,b,c$ of $ax+by+c$, $S$ by
  the $A,\dots,F$ of (3.1.1)
:then: the diagonals are $l_1l_2-l_3l_4$, and no $\lambda$ gives them
:method: The real zeros in $\lambda$ of a determinant of coefficients are counted.
:control: the circle through the corners in place of the diagonals
:::
*/
CLAIM(diagonals_are_no_member)
{
    num l[4][3], S1[6], S2[6], S[6], P[8];
    given_lines(T, l);
    given_points(T, "S", 6, 1, S);
    G(line_pair)(l[0], l[1], S1);
    G(line_pair)(l[2], l[3], S2);
    int corners = meeting_points(l, P);
    found_points(T, "common points", corners, 2, P);
    int fits = passes_through(T, "S(P)", S, corners, P), count = members_like(S1, S2, S, 0, 2);
    found_whole(T, "values of λ that fit", count);
    about(T, "whether the conic, which passes through the four corners, is a member");
    refute(T, fits && count == 0);
}
#endif

#include "chapters/judge/claims_off.h"
