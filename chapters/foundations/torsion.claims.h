/*
# Torsion of a cubic (挠率)

A curve in space leaves its osculating plane (密切平面) as fast as its torsion says.  For a cubic the numerator of the
torsion is a single number, which vanishes exactly when the cubic is plane.
*/
#include "chapters/foundations/cubic.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} hu-1987:1-4-torsion-vectors
:title: The three vectors in the formula of the torsion
:zh: 挠率公式中的三个矢量
:printed: \tau=\frac{[\dot P\,\ddot P\,\ddot P]}{s^3K^2}
:refuted-by: printed_vectors_have_no_torsion
:class: misprint
:corrected: $\tau=\frac{[\dot P\,\ddot P\,\dddot P]}{\dot s^6K^2}$, where $\dot s=|\dot P|$ is the speed and $K=\frac{|\dot P\times\ddot P|}{\dot s^3}$, at points with
  $\dot P\times\ddot P\ne0$
:corrected-by: torsion_by_speed_and_curvature torsion_belongs_to_arc_length
:hypothesis: torsion_divides_by_zero_at_an_inflection | $\dot P\times\ddot P\ne0$: in the correction; elsewhere it is divided by 0
:figure: derivatives_with_lost_dots
:::

:::{claim} torsion_by_speed_and_curvature
:title: The torsion by speed and curvature
:zh: 用速率与曲率表示挠率
:given: any three vectors $\dot P,\ddot P,\dddot P$ of space, $\dot P\times\ddot P\ne0$
:where: $\dot P\times\ddot P\ne0$
:then: $\frac{[\dot P\,\ddot P\,\dddot P]}{\dot s^6K^2}=\frac{[\dot P\,\ddot P\,\dddot P]}{|\dot P\times\ddot P|^2}=\tau$, the torsion, with $\dot s^2=|\dot P|^2$ and
  $K^2=\frac{|\dot P\times\ddot P|^2}{|\dot P|^6}$
:method: The kernels for the square of the curvature and for the torsion, everything a variable.
:over: u# v# w#: derivatives
:control: $\dot s^4$
:::
*/
CLAIM(torsion_by_speed_and_curvature)
{
    num d[3][space];
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < space; j++)
            d[k][j] = unknown(T, k == 0 ? "u" : k == 1 ? "v" : "w", j);
    num speed = G(norm_squared)(space, d[0]),
        below = mul(G(power)(speed, fault(T, 3, 2)), G(curvature_squared)(space, d[0], d[1]));
    /* (P', P'', P''') / (s'^6 K²) = τ */
    same(T, div(G(det3)(d[0], d[1], d[2]), below), G(torsion)(d[0], d[1], d[2]));
}

/* The determinant of three rows, by the rule of Sarrus. */
static num G(sarrus)(const num r0[], const num r1[], const num r2[])
{
    num sum = from_int(0);
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        sum = add(sum, sub(mul(r0[k], mul(r1[i], r2[j])), mul(r0[k], mul(r1[j], r2[i]))));
    }
    return sum;
}

#if RATIONAL
/*
:::{claim} printed_vectors_have_no_torsion
:title: With the second derivative twice the printed torsion is zero
:zh: 重复二阶导矢时挠率恒为零
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$ in space, and $t$, where its speed is 1
:data: c = (0,0,0) (1,0,0) (0,1,0) (0,0,1); t = 0
:then: $[P'\,P''\,P'']$ is 0, and with it the printed quotient, whatever number $s\ne0$ is; the torsion is not
:result: P', P'', P''' = (1,0,0) (0,2,0) (0,0,6); printed quotient = 0; τ = 3
:method: The derivatives by the kernel; at $t$ the speed is 1, so that its power does not matter.
:control: $P'''$ in the last place
:::
*/
CLAIM(printed_vectors_have_no_torsion)
{
    num c[12], D[12];
    given_points(T, "c", 4, 3, c);
    G(power_derivatives)(3, space, c, given(T, "t"), 3, D);
    const num *last = D + fault(T, 3, 2) * space;
    /* [P' P'' P''] / K^2, the speed being 1 */
    num quotient = div(G(sarrus)(D + 3, D + 6, last), G(curvature_squared)(space, D + 3, D + 6));
    num torsion = G(torsion)(D + 3, D + 6, D + 9);
    found_points(T, "P', P'', P'''", 3, 3, D + 3);
    found(T, "printed quotient", quotient);
    found(T, "τ", torsion);
    about(T, "the quotient, and the torsion");
    same(T, quotient, torsion);
}

/*
:::{claim} torsion_divides_by_zero_at_an_inflection
:title: At an inflection the formula of the torsion divides by 0
:zh: 拐点处挠率公式分母为零
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$ in space, and $t$, the parameter of an inflection
:data: c = (0,0,0) (1,0,0) (0,0,0) (0,1,0); t = 0
:instead: c = (0,0,0) (1,0,0) (0,1,0) (0,0,1)
:then: $P'$ is not 0, and the divisor $|P'\times P''|^2$ of the torsion is 0
:result: |P'|^2 = 1; |P' x P''|^2 = 0
:method: The derivatives by the kernel; that the divisor is not 0 is refuted.
:control: a cubic that turns at $t$
:::
*/
CLAIM(torsion_divides_by_zero_at_an_inflection)
{
    num c[12], D[9], normal[space];
    given_points(T, "c", 4, 3, c);
    G(power_derivatives)(3, space, c, given(T, "t"), 2, D);
    G(cross3)(D + 3, D + 6, normal);
    num speed = G(norm_squared)(space, D + 3), divisor = G(norm_squared)(space, normal);
    found(T, "|P'|^2", speed);
    found(T, "|P' x P''|^2", divisor);
    about(T, "whether the divisor is not 0");
    refute(T, !is_zero_q(speed) && is_zero_q(divisor));
}

/*
Two misprints overlap in the one formula of the source, and each has to be refuted with the other one mended.  A mixed
product with one vector twice is 0 for every curve.  The power of the speed shows only where the speed is not 1, so a
curve has to be taken at a place where it is not; there one sees that the sixth power is right and the third is not.

:::{statement} hu-1987:1-4-torsion-power
:title: The power of the speed in the formula of the torsion
:zh: 挠率公式中弧长导数的幂次
:printed: \tau=\frac{[\dot P\,\ddot P\,\ddot P]}{s^3K^2}
:refuted-by: printed_power_spoils_the_torsion
:class: misprint
:corrected: $\tau=\frac{[\dot P\,\ddot P\,\dddot P]}{\dot s^6K^2}$, where $\dot s=|\dot P|$ is the speed and $K=\frac{|\dot P\times\ddot P|}{\dot s^3}$, at points with
  $\dot P\times\ddot P\ne0$
:corrected-by: torsion_by_speed_and_curvature torsion_belongs_to_arc_length
:hypothesis: torsion_divides_by_zero_at_an_inflection | $\dot P\times\ddot P\ne0$: in the correction; elsewhere it is divided by 0
:meant: the formula of the curvature, in which $s$ stands for $\dot s$, too, and the third derivative $6A$ at the end of the chain behind the formula | $\dddot P$ stands in the last
  place and $\dot s$ below, so that the power alone is tried.
:figure: torsion_and_the_speed
:::

:::{claim} printed_power_spoils_the_torsion
:title: With the third power of the speed the torsion is wrong at a place where the speed is not one
:zh: 速率三次幂给出错误的挠率
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$ in space, and $t$; the printed quotient with $\dddot P$ in the last place and $\dot s$ for $s$
:data: c = (0,0,0) (3,0,0) (0,3,0) (0,0,2); t = 1
:then: the speed $\dot s$ is not 1, and the printed quotient is not the torsion
:result: s'(t) = 9; K² = 4/729; printed quotient = 54; τ = 2/27
:method: Both quotients, exactly.
:control: $\dot s^6$
:::
*/
CLAIM(printed_power_spoils_the_torsion)
{
    num c[12], D[12];
    given_points(T, "c", 4, 3, c);
    G(power_derivatives)(3, space, c, given(T, "t"), 3, D);
    num speed = root(2, G(norm_squared)(space, D + 3)), square = G(curvature_squared)(space, D + 3, D + 6);
    num below = mul(G(power)(speed, fault(T, 6, 3)), square);
    num quotient = div(G(sarrus)(D + 3, D + 6, D + 9), below), torsion = G(torsion)(D + 3, D + 6, D + 9);
    found(T, "s'(t)", speed);
    found(T, "K²", square);
    found(T, "printed quotient", quotient);
    found(T, "τ", torsion);
    about(T, "the quotient, and the torsion");
    same(T, quotient, torsion);
}
#endif

/*
:::{statement} hu-1987:1-4-torsion-first-determinant
:title: The determinant of the derivatives
:zh: 导矢的行列式
:printed: $(\dot P\times\ddot P)\cdot\ddot P=\begin{vmatrix}\dot x&\dot y&\dot z\\\ddot x&\ddot y&\ddot z\\\ddot x&\ddot y&\ddot
  z\end{vmatrix}=\cdots=-12\begin{vmatrix}A_x&A_y&A_z\\B_x&B_y&B_z\\C_x&C_y&C_z\end{vmatrix}$
:refuted-by: determinant_with_equal_rows_is_zero
:class: misprint
:corrected: $(\dot P\times\ddot P)\cdot\dddot P=-12\,(A,B,C)$, with $\dddot x,\dddot y,\dddot z$ in the last row
:corrected-by: determinant_of_the_derivatives_is_constant
:figure: determinants_of_the_derivatives
:::
*/

/* The rows of the determinant in coefficients, the last entry of the first row with `power` of t. */
static void G(rows_in_coefficients)(const num c[], num t, int power_of_last, num rows[3][3])
{
    for (int j = 0; j < space; j++) {
        num C = c[space + j], B = c[2 * space + j], A = c[3 * space + j];
        num tt = G(power)(t, j == 2 ? power_of_last : 2), six_A = mul(from_int(6), A), two_B = mul(from_int(2), B);
        rows[0][j] = add(add(mul(mul(from_int(3), A), tt), mul(two_B, t)), C);
        rows[1][j] = add(mul(six_A, t), two_B);
        rows[2][j] = six_A;
    }
}

/*
:::{claim} determinant_of_the_derivatives_is_constant
:title: The determinant of the three derivatives does not depend on the parameter
:zh: 三阶导矢行列式为常数
:given: any cubic $P(t)=At^3+Bt^2+Ct+D$ in space, any $t$
:then: $(P',P'',P''')=-12\,(A,B,C)$, also with the rows written out in coefficients
:method: The derivatives by the kernel, the mixed products as determinants of 9 entries, everything a variable.
:over: x# y# z#: coefficients
:control: $12\,(A,B,C)$
:::
*/
CLAIM(determinant_of_the_derivatives_is_constant)
{
    num c[4 * space], D[4 * space], rows[3][3], t = parameter(T, "t");
    G(free_points)(T, 3, space, c);
    G(power_derivatives)(3, space, c, t, 3, D);
    G(rows_in_coefficients)(c, t, 2, rows);
    num value = mul(from_int(fault(T, -12, 12)), G(sarrus)(c + 3 * space, c + 2 * space, c + space));
    /* (P', P'', P''') = -12 (A,B,C) */
    same(T, G(det3)(D + space, D + 2 * space, D + 3 * space), value);
    same(T, G(sarrus)(rows[0], rows[1], rows[2]), value);
}

#if RATIONAL
/*
:::{claim} determinant_with_equal_rows_is_zero
:title: The printed determinant has two equal rows
:zh: 两行相同的行列式为零
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$ in space, that is with the coefficients $c$ from $D$ to $A$, and $t$
:data: c = (0,0,0) (1,0,0) (0,1,0) (0,0,1); t = 0
:then: the printed determinant is 0, and the right side that is printed for it is not
:result: (A,B,C) = -1; printed determinant = 0; -12 (A,B,C) = 12
:method: Both sides, exactly.
:control: the third derivatives in the last row
:::
*/
CLAIM(determinant_with_equal_rows_is_zero)
{
    num c[12], D[12];
    given_points(T, "c", 4, 3, c);
    G(power_derivatives)(3, space, c, given(T, "t"), 3, D);
    num volume = G(sarrus)(c + 9, c + 6, c + 3), right = mul(from_int(-12), volume);
    num printed = G(sarrus)(D + 3, D + 6, D + fault(T, 9, 6));
    found(T, "(A,B,C)", volume);
    found(T, "printed determinant", printed);
    found(T, "-12 (A,B,C)", right);
    about(T, "the determinant, and -12 (A,B,C)");
    same(T, printed, right);
}

/*
The last line of the derivation drops an exponent in one of nine entries.  Such a slip can be found by asking what the
line claims: the determinant of the three derivatives does not depend on $t$, because multiples of the
rows below, taken from the second row and then from the first, remove $t$ altogether; with the printed entry it does depend on it.

:::{statement} hu-1987:1-4-torsion-entry
:title: The determinant with the coefficients inserted
:zh: 代入系数的行列式
:printed: \begin{vmatrix}3A_xt^2+2B_xt+C_x&3A_yt^2+2B_yt+C_y&3A_zt+2B_zt+C_z\\6A_xt+2B_x&6A_yt+2B_y&6A_zt+2B_z\\6A_x&6A_y&6A_z\end{vmatrix}=-12\begin{vmatrix}A_x&A_y&A_z\\B_x&B_y&B_z\\C_x&C_y&C_z\end{vmatrix}
:refuted-by: printed_entry_spoils_the_determinant
:class: misprint
:corrected: The last entry of the first row is $3A_zt^2+2B_zt+C_z$.
:corrected-by: determinant_of_the_derivatives_is_constant
:figure: determinants_of_the_derivatives
:::

:::{claim} printed_entry_spoils_the_determinant
:title: With the printed entry the determinant depends on the parameter
:zh: 印刷的元素使行列式出错
:kind: counterexample
:given: the cubic $P(t)=\sum_kc_kt^k$ in space, that is with the coefficients $c$ from $D$ to $A$, and $t$
:data: c = (0,0,0) (0,0,1) (0,1,0) (1,0,1); t = 1/2
:then: the determinant with the printed rows is not the right side
:result: rows = (3/4,1,5/2) (3,2,3) (6,0,6); printed determinant = -21; -12 (A,B,C) = -12
:method: The determinant as printed, exactly.
:control: the entry with $t^2$
:::
*/
CLAIM(printed_entry_spoils_the_determinant)
{
    num c[12], rows[3][3];
    given_points(T, "c", 4, 3, c);
    G(rows_in_coefficients)(c, given(T, "t"), fault(T, 2, 1), rows);
    num printed = G(sarrus)(rows[0], rows[1], rows[2]);
    num right = mul(from_int(-12), G(sarrus)(c + 9, c + 6, c + 3));
    found_points(T, "rows", 3, 3, rows[0]);
    found(T, "printed determinant", printed);
    found(T, "-12 (A,B,C)", right);
    about(T, "the determinant, and -12 (A,B,C)");
    same(T, printed, right);
}
#endif

/*
:::{statement} hu-1987:1-4-torsion-value
:title: The value of the determinant
:zh: 行列式的值
:printed: the last member of the chain: $\dots=-12\begin{vmatrix}A_x&A_y&A_z\\B_x&B_y&B_z\\C_x&C_y&C_z\end{vmatrix}$
:holds-by: determinant_of_the_derivatives_is_constant
:meant: the last row of the member before it, $6A_x$, $6A_y$, $6A_z$, the third derivative | It is the value of $(\dot
  P\times\ddot P)\cdot\dddot P$, with which the chain is to begin.
:figure: determinants_of_the_derivatives
:::

A single number decides whether a cubic is plane.  The three normals $A\times B$, $C\times A$ and $B\times C$ test the
three powers of the parameter one by one, so when the determinant vanishes $P(t)-D$ is perpendicular to each of them.

:::{statement} hu-1987:1-4-plane
:title: When the determinant is zero the cubic is plane
:zh: 行列式为零则为平面曲线
:printed: If this is zero, the parametric cubic is a plane curve.
:holds-by: cubic_is_plane_when_determinant_vanishes
:meant: the last member of the chain before it, and not its first, in which two rows are equal | It is the determinant of $A$, $B$, $C$.
:figure: plane_cubics
:::

:::{claim} cubic_is_plane_when_determinant_vanishes
:title: The cubic is plane exactly when the determinant of its coefficients is zero
:zh: 平面曲线的充要条件
:given: any cubic $P(t)=At^3+Bt^2+Ct+D$ in space, any $t$
:then: $(A\times B)\cdot(P-D)=t\,(A,B,C)$, $(C\times A)\cdot(P-D)=t^2(A,B,C)$, $(B\times C)\cdot(P-D)=t^3(A,B,C)$;
  $A\times(P-D)=t^2A\times B-t\,C\times A$, $B\times(P-D)=t\,B\times C-t^3A\times B$, $C\times(P-D)=t^3C\times A-t^2B\times C$; and for any vector $n$,
  $(A,B,C)\,n=(n\cdot A)\,B\times C+(n\cdot B)\,C\times A+(n\cdot C)\,A\times B$
:method: Identities with everything a variable.  If the determinant is 0, each of the three products that is not 0 is the normal of
  a plane that holds the curve; if all are 0, $P-D$ is parallel to each of $A$, $B$, $C$, and the curve is on a line, or a point.  Conversely, if
  $n\cdot(P-D)=0$ for all $t$ and $n\ne0$, the three coefficients $n\cdot A$, $n\cdot B$, $n\cdot C$ are 0, and so is the determinant.
:over: x# y# z#: coefficients; n#: -
:control: the last normal with the factor $t^2$
:::
*/
CLAIM(cubic_is_plane_when_determinant_vanishes)
{
    num c[4 * space], P[space], gone[space], normal[space], t = parameter(T, "t");
    G(free_points)(T, 3, space, c);
    G(power_point)(3, space, c, t, P);
    for (int j = 0; j < space; j++)
        gone[j] = sub(P[j], c[j]);
    const num *A = c + 3 * space, *B = c + 2 * space, *C = c + space, *pairs[3][2] = {{A, B}, {C, A}, {B, C}};
    num det = G(sarrus)(A, B, C);
    for (int k = 0; k < 3; k++) {
        G(cross3)(pairs[k][0], pairs[k][1], normal);
        /* (A × B)·(P - D) = t (A,B,C), and so on with t² and t³ */
        same(T, G(dot)(space, normal, gone), mul(G(power)(t, fault(T, k + 1, k == 2 ? 2 : k + 1)), det));
    }
    num products[3][space], n[space], tt = mul(t, t), ttt = mul(tt, t); /* A × B, C × A, B × C */
    for (int k = 0; k < 3; k++)
        G(cross3)(pairs[k][0], pairs[k][1], products[k]);
    for (int j = 0; j < space; j++)
        n[j] = unknown(T, "n", j);
    num along[3][space];
    for (int k = 0; k < 3; k++)
        G(cross3)(c + (3 - k) * space, gone, along[k]); /* of A, B and C with P - D */
    for (int j = 0; j < space; j++) {
        num AB = products[0][j], CA = products[1][j], BC = products[2][j];
        about(T, "the direction of P - D");
        same(T, along[0][j], sub(mul(tt, AB), mul(t, CA)));
        same(T, along[1][j], sub(mul(t, BC), mul(ttt, AB)));
        same(T, along[2][j], sub(mul(ttt, CA), mul(tt, BC)));
        about(T, "the determinant times any vector");
        num sum = add(mul(G(dot)(space, n, A), BC), add(mul(G(dot)(space, n, B), CA), mul(G(dot)(space, n, C), AB)));
        same(T, mul(det, n[j]), sum);
    }
}

#include "chapters/judge/claims_off.h"
