/*
# Circular arcs (圆弧)

Among the ellipses are the circles.  In special coordinates, $R_0=(-l,0)$, $R_1=(x_1,y_1)$, $R_2=(l,0)$, the
conic of the curve is $S$ with the coefficients (3.5.4).  The angle $\theta$, which the source does not define, is the
base angle $\angle R_1R_0R_2$ in its derivation.
*/
#include "exact/record/roots.h"

#include "chapters/judge/claims_on.h"
#include "chapters/rational-bezier/conics.h"

/*
## When the conic is a circle

:::{statement} wang-ch3:3.5-circle-coefficients
:title: When the curve is an arc of a circle
:zh: 曲线为圆弧的系数条件
:printed: By theorem 3.5.1, when $I_1<1$, it is easily seen that the curve (3.1.5) is an arc of a circle with the central angle $2\theta$ if and only if $B=0$,
  $A=C$.
:meant: the formula that follows in the source, $\frac{l^2}{l^2+y_1^2}=\cos^2\theta$ | $\theta$ is the base angle of the triangle.
:holds-by: circles_among_the_conics_of_the_curve arc_and_its_central_angle curve_on_a_circle_has_five_conditions
:confirmed-by: arcs_satisfy_the_three_equations
:needs: negative_weight_gives_the_other_arc | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive; otherwise the central angle may be $2\pi-2\theta$.
:figure: circular_arc

If: $B=0$ and $A=C$, for the coefficients (3.5.4), say that $x_1=0$ and $\omega^2=\frac{l^2}{l^2+y_1^2}$, and this is the arc of `arc_and_its_central_angle`.  Only if: a curve on a circle has
$\|R_0R_1\|=\|R_2R_1\|$, so $x_1=0$, and $\omega^2\|R_0R_1\|^2=l^2$, by `curve_on_a_circle_has_five_conditions`.  Right angles and equal units on the axes, as the special coordinates have them, are used.
:::

:::{claim} circles_among_the_conics_of_the_curve
:title: Equal coefficients mean an isosceles triangle with its own weight
:zh: A=C,B=0 的充要条件
:given: the points in special coordinates, $\omega>0$, $l>0$, and the conic $S$ of the weights $1,\omega,1$
:where: $R_0\ne R_2$; the weights are positive
:then: $B=-\omega^2y_1x_1$, which is 0 only for $x_1=0$ or $y_1=0$; for $x_1=0$ it is
  $A-C=(l^2+y_1^2)\left(\omega^2-\frac{l^2}{l^2+y_1^2}\right)$; for $y_1=0$ it is
  $A-C=-\left(\omega^2x_1^2+(1-\omega^2)l^2\right)$
:method: Identities in $l$, $x_1$, $y_1$, $\omega$ for the kernel's conic of the curve.  For $I_1=\omega^2<1$ the last
  difference is not 0, so that three points on a line satisfy neither condition.
:over: l
:control: $l^2-y_1^2$ for $l^2+y_1^2$ in the quotient
:::
*/
/* The conic of R = (-l, 0), (x_1, y_1), (l, 0) and the weights 1, omega, 1. */
static void G(special_conic)(num l, num x1, num y1, num omega, num S[])
{
    num zero = from_int(0), one = from_int(1), R[6] = {neg(l), zero, x1, y1, l, zero}, w[3] = {one, omega, one};
    G(conic_of_bezier)(R, w, S);
}

CLAIM(circles_among_the_conics_of_the_curve)
{
    num l = positive(T, "l", 0), x1 = unknown(T, "x", 1), y1 = unknown(T, "y", 1), omega = positive(T, "w", 1), S[6];
    num oo = mul(omega, omega), ll = mul(l, l), yy = mul(y1, y1), sum = add(ll, yy);
    G(special_conic)(l, x1, y1, omega, S);
    about(T, "B");
    /* B = -ω² y_1 x_1 */
    same(T, S[1], neg(mul(oo, mul(y1, x1))));
    G(special_conic)(l, from_int(0), y1, omega, S);
    about(T, "A - C");
    /* A - C = (l² + y_1²)(ω² - l²/(l² + y_1²)) for x_1 = 0 */
    same(T, sub(S[0], S[2]), mul(sum, sub(oo, div(ll, fault(T, sum, sub(ll, yy))))));
    G(special_conic)(l, x1, from_int(0), omega, S);
    about(T, "A - C for points on a line");
    /* C - A = ω² x_1² + (1 - ω²) l² for y_1 = 0 */
    same(T, sub(S[2], S[0]), add(mul(oo, mul(x1, x1)), mul(sub(from_int(1), oo), ll)));
}

/* R_0 = M - (p, q), R_1 = M + k (-q, p), R_2 = M + (p, q) */
static void G(isosceles)(const num M[], num p, num q, num k, num R[])
{
    const num chord[2] = {p, q}, up[2] = {neg(q), p};
    for (int c = 0; c < 2; c++) {
        R[c] = sub(M[c], chord[c]);
        R[2 + c] = add(M[c], mul(k, up[c]));
        R[4 + c] = add(M[c], chord[c]);
    }
}

/* (a - o) . (b - o) */
static num G(scalar)(const num o[], const num a[], const num b[])
{
    return add(mul(sub(a[0], o[0]), sub(b[0], o[0])), mul(sub(a[1], o[1]), sub(b[1], o[1])));
}

/*
:::{claim} arc_and_its_central_angle
:title: The arc, its circle and its central angle
:zh: 圆弧的圆心、半径与圆心角
:given: an isosceles triangle with half base $l$ and height $h>0$ in any position, $\theta$ its base angle, and positive
  weights with $I_1=\cos^2\theta=\frac{l^2}{l^2+h^2}$
:let: $C$ and $r^2$ be the centre and squared radius that the kernel gives
:then: $\|R(t)-C\|^2=r^2$; $C$ has the distance $r$ from $R_0$ and $R_2$, and $R_0R_1$ and $R_2R_1$ are tangents;
  $r^2\sin^2\theta=l^2$, so $r=l\csc\theta$; $\cos\angle R_0CR_2=2\cos^2\theta-1$ and
  $\sin\angle R_0CR_2=2\sin\theta\cos\theta$; the arc lies on the side of $R_1$ and the centre on the other side
  of the chord, so the central angle of the arc is $2\theta<\pi$
:method: Identities in the position, $k=h:l$, $\omega_0$, $\omega_1$ and $t$; $\omega_2$ follows from $I_1$.  $R_1$ is to the left of $R_0R_2$; with
  $R_1$ to the right the ends, their weights, and $t$ and $1-t$ are exchanged.  The
  sides of the chord are told by cross products, whose quotients by that of $R_1$ have coefficients of one sign.
:defines: circular_arc_circle
:scope: 0 ≤ t ≤ 1
:where: $R_0\ne R_2$
:over: M# p# q#: points; k: ratio of height and half base; t: -
:control: $\omega_2$ doubled
:::
*/
CLAIM(arc_and_its_central_angle)
{
    num M[2] = {unknown(T, "M", 0), unknown(T, "M", 1)}, p = unknown(T, "p", 0), q = unknown(T, "q", 0), R[6];
    num k = positive(T, "k", 0), t = inside(T, "t"), one = from_int(1), two = from_int(2), w[3], C[2], P[2];
    G(isosceles)(M, p, q, k, R);
    num kk = mul(k, k), cos2 = div(one, add(one, kk)), sin2 = sub(one, cos2), ll = add(mul(p, p), mul(q, q));
    w[0] = positive(T, "w", 0);
    w[1] = positive(T, "w", 1);
    w[2] = div(mul(w[1], w[1]), mul(w[0], cos2));
    w[2] = fault(T, w[2], add(w[2], w[2]));
    num rr = G(circular_arc_circle)(R, C);
    about(T, "the distance of R(t) from the centre");
    G(rational_point)(2, 2, R, w, t, P);
    same(T, G(scalar)(C, P, P), rr);
    about(T, "the distance of the ends from the centre");
    same(T, G(scalar)(C, R, R), rr);
    same(T, G(scalar)(C, R + 4, R + 4), rr);
    about(T, "radius and tangent");
    vanishes(T, G(scalar)(R, C, R + 2));
    vanishes(T, G(scalar)(R + 4, C, R + 2));
    about(T, "r² sin²θ and l²");
    same(T, mul(rr, sin2), ll);
    about(T, "cosine of the central angle");
    same(T, div(G(scalar)(C, R, R + 4), rr), sub(mul(two, cos2), one));
    about(T, "sine of the central angle, from R2 to R0");
    same(T, div(G(area)(C, R + 4, R), rr), mul(two, mul(k, cos2)));
    about(T, "the sides of the chord");
    num arc = div(mul(two, mul(w[1], mul(t, sub(one, t)))), G(rational_weight)(2, w, t)),
        vertex = G(area)(R, R + 4, R + 2);
    same(T, G(area)(R, R + 4, P), mul(arc, vertex));
    nonnegative(T, arc);
    same(T, G(area)(R, R + 4, C), neg(div(vertex, kk)));
}

/*
:::{claim} standard_weights_of_the_arc
:title: The standard weights of a circular arc
:zh: 圆弧的标准权
:given: $l>0$, $h>0$ with $l^2+h^2$ a square: $l=2km$, $h=k(1-m^2)$, $0<m<1$, $k>0$
:then: the kernel's weights are $1,\cos\theta,1$ with $\cos\theta=\frac{2m}{1+m^2}$; the curve with these and the points
  $(-l,0),(0,h),(l,0)$ lies on the circle with the centre $\left(0,-\frac{l^2}h\right)$ through $(l,0)$
:method: Identities in $k$, $m$ and $t$; every ratio $l:h$ whose hypotenuse is rational has this form, and for $m$ real
  every ratio has.
:defines: circular_arc_weights
:scope: every θ below π/2
:over: k m: -
:control: $\cos^2\theta$ for $\cos\theta$
:::
*/
CLAIM(standard_weights_of_the_arc)
{
    num k = positive(T, "k", 0), m = inside(T, "m"), t = inside(T, "t"), zero = from_int(0), one = from_int(1), w[3],
        P[2];
    num mm = mul(m, m), l = mul(from_int(2), mul(k, m)), h = mul(k, sub(one, mm));
    G(circular_arc_weights)(l, h, w);
    w[1] = fault(T, w[1], mul(w[1], w[1]));
    about(T, "the weights");
    same(T, w[0], one);
    same(T, w[1], div(mul(from_int(2), m), add(one, mm)));
    same(T, w[2], one);
    num R[6] = {neg(l), zero, zero, h, l, zero}, C[2] = {zero, neg(div(mul(l, l), h))};
    G(rational_point)(2, 2, R, w, t, P);
    about(T, "the squared distances of R(t) and R_2 from the centre");
    same(T, G(scalar)(C, P, P), G(scalar)(C, R + 4, R + 4));
}

/*
The two tangents from a point to a circle are equally long, so the triangle of an arc is isosceles.  Its weight is
then no longer free: of all conics that touch the two equal sides at their ends one is a circle, and the cosine of the
base angle picks it out.

:::{statement} wang-ch3:3.5-circle-conditions
:title: The same in terms of the triangle and the weight
:zh: 等价的几何条件
:printed: For $I_1<1$ the condition $B=0$, $A=C$ is equivalent to $x_1=0$, $\omega^2=\frac{l^2}{l^2+y_1^2}=\cos^2\theta$.
:holds-by: circles_among_the_conics_of_the_curve base_angle_of_the_triangle arc_and_its_central_angle
:meant: the sentence before, in which the central angle of the arc is $2\theta$ | $\theta$ is half the central angle, which is the base angle of the triangle.
:figure: circular_arc

$A$, $B$, $C$ are the coefficients (3.5.4).  For a true triangle $I_1<1$ follows and is not needed; for three points on a line it makes either side false.
:::

:::{claim} base_angle_of_the_triangle
:title: The invariant of a circular arc is the squared cosine of the base angle
:zh: 圆弧的不变量等于底角余弦的平方
:given: an isosceles triangle $R_0=M-(p,q)$, $R_2=M+(p,q)$, $R_1=M+k(-q,p)$
:let: $l^2=p^2+q^2$ and $h=kl$, the height
:then: the kernel's $\frac{l^2}{l^2+h^2}$ is
  $\cos^2\angle R_1R_0R_2=\frac{((R_1-R_0)\cdot(R_2-R_0))^2}{\|R_1-R_0\|^2\|R_2-R_0\|^2}$; $\|R_0R_1\|=\|R_2R_1\|$ and
  $\|R_0R_2\|^2=4l^2$
:method: The angle is taken from scalar products of the points.  An identity in $M$, $p$, $q$ and $k$; the kernel depends
  on $h:l$ alone and is given $1$ and $k$, and once more in special coordinates $l$ and $h$.
:defines: circular_arc_invariant
:where: $R_0\ne R_2$
:over: M# p# q#: points; k: ratio of height and half base; l
:control: the angle at $R_1$ in place of the one at $R_0$
:::
*/
CLAIM(base_angle_of_the_triangle)
{
    num M[2] = {unknown(T, "M", 0), unknown(T, "M", 1)}, p = unknown(T, "p", 0), q = unknown(T, "q", 0), R[6];
    num k = positive(T, "k", 0), l = positive(T, "l", 0), one = from_int(1), ll = add(mul(p, p), mul(q, q));
    for (int position = 0; position < 2; position++) {
        num zero = from_int(0), origin[2] = {zero, zero};
        if (position == 0)
            G(isosceles)(M, p, q, k, R);
        else
            G(isosceles)(origin, l, zero, k, R);
        const num *o = fault(T, R, R + 2), *a = fault(T, R + 2, R);
        num product = G(scalar)(o, a, R + 4), squares = mul(G(scalar)(o, a, a), G(scalar)(o, R + 4, R + 4));
        num invariant = position == 0 ? G(circular_arc_invariant)(one, k) : G(circular_arc_invariant)(l, mul(k, l));
        about(T, "cos² of the base angle");
        /* cos² ∠R_1R_0R_2 = ((R_1 - R_0)·(R_2 - R_0))²/(‖R_1 - R_0‖² ‖R_2 - R_0‖²) */
        same(T, invariant, div(mul(product, product), squares));
    }
    G(isosceles)(M, p, q, k, R);
    about(T, "|R0 R1|² and |R2 R1|²");
    same(T, G(scalar)(R, R + 2, R + 2), G(scalar)(R + 4, R + 2, R + 2));
    about(T, "|R0 R2|²");
    same(T, G(scalar)(R, R + 4, R + 4), mul(from_int(4), ll));
}

/*
## The theorem

:::{statement} wang-ch3:3.5.5
:title: The lengths in the triangle of a circular arc
:zh: 圆弧控制三角形的边长
:printed: If the curve (3.1.5) is an arc of a circle with the central angle $2\theta$, $0<\theta<\frac\pi2$, and the radius
  $l\csc\theta$, then $\|R_0R_1\|=\|R_2R_1\|$, $\|R_0R_2\|=2l$.
:holds-by: curve_on_a_circle_has_five_conditions arcs_satisfy_the_three_equations

This is what the theorem says of (3.5.5) as a necessary condition.
:::

:::{statement} wang-ch3:3.5.6
:title: The invariant of a circular arc
:zh: 圆弧的不变量
:printed: If the curve (3.1.5) is an arc of a circle with the central angle $2\theta$, $0<\theta<\frac\pi2$, and the radius
  $l\csc\theta$, then $\frac{\omega_1^2}{\omega_0\omega_2}=\cos^2\theta$.
:holds-by: curve_on_a_circle_has_five_conditions arcs_satisfy_the_three_equations

This is what the theorem says of (3.5.6) as a necessary condition.
:::

:::{claim} arcs_satisfy_the_three_equations
:title: Every circular arc below a half circle satisfies the three equations
:zh: 圆弧满足三式
:given: a circle of radius $r>0$ about the origin and the arc from $-\theta$ to $\theta$ on it,
  $\cos\theta=\frac{1-m^2}{1+m^2}$, $\sin\theta=\frac{2m}{1+m^2}$, $0<m<1$
:let: $R_0=r(\cos\theta,-\sin\theta)$, $R_2=r(\cos\theta,\sin\theta)$; the end tangents meet in $R_1=(r\sec\theta,0)$; let
  $l=r\sin\theta$, and let $S$ be the conic of the curve with any weights $\omega_0,\omega_1,\omega_2$
:then: $R_0R_1$ and $R_2R_1$ are tangents of the circle; $\|R_0R_1\|^2=\|R_2R_1\|^2=l^2\sec^2\theta$,
  $\|R_0R_2\|^2=4l^2$; and $C-A=\frac{l^2}{\cos^2\theta}(\omega_1^2-\omega_0\omega_2\cos^2\theta)$ for $S$, which is 0 only
  for $I_1=\cos^2\theta$
:method: By `curve_on_a_circle_has_five_conditions` $R_0R_1$ and $R_2R_1$ are tangents of the circle of an arc, so that its triangle is this
  one up to a motion.  Identities in $r$, $m$ and the weights.
:scope: every θ below π/2
:over: r: radius; m: -
:control: $\cos\theta$ for $\cos^2\theta$ in the bracket
:::
*/
CLAIM(arcs_satisfy_the_three_equations)
{
    num r = positive(T, "r", 0), m = inside(T, "m"), one = from_int(1), zero = from_int(0), w[3], S[6];
    num mm = mul(m, m), bottom = add(one, mm), cosine = div(sub(one, mm), bottom);
    num sine = div(add(m, m), bottom), l = mul(r, sine), cc = mul(cosine, cosine), ll = mul(l, l), O[2] = {zero, zero};
    num R[6] = {mul(r, cosine), neg(l), div(r, cosine), zero, mul(r, cosine), l};
    G(three_weights)(T, w);
    about(T, "radius and tangent");
    vanishes(T, G(scalar)(R, O, R + 2));
    vanishes(T, G(scalar)(R + 4, O, R + 2));
    about(T, "|R0 R1|², |R2 R1|² and l²/cos²θ");
    same(T, G(scalar)(R, R + 2, R + 2), div(ll, cc));
    same(T, G(scalar)(R + 4, R + 2, R + 2), div(ll, cc));
    about(T, "|R0 R2|² and 4 l²");
    same(T, G(scalar)(R, R + 4, R + 4), mul(from_int(4), ll));
    about(T, "C - A of the curve");
    G(conic_of_bezier)(R, w, S);
    num difference = sub(mul(w[1], w[1]), mul(mul(w[0], w[2]), fault(T, cc, cosine)));
    /* C - A = l²/cos²θ (ω_1² - ω_0 ω_2 cos²θ) */
    same(T, sub(S[2], S[0]), mul(div(ll, cc), difference));
}

/*
That a curve is on a circle is five equations, the Bernstein coefficients of a polynomial of degree 4.

:::{claim} curve_on_a_circle_has_five_conditions
:title: What it means that a rational quadratic is on a circle
:zh: 有理二次曲线在圆上的五个条件
:given: points $R_0,R_1,R_2$ and $C$ of the plane, a number $r$, any weights $\omega_0,\omega_1,\omega_2$ and $t$
:let: $m_{ij}=(R_i-C)\cdot(R_j-C)-r^2$
:then: $\omega(t)^2(\|R(t)-C\|^2-r^2)$ is $(1-t)^4\omega_0^2m_{00}+4(1-t)^3t\,\omega_0\omega_1m_{01}
  +(1-t)^2t^2(2\omega_0\omega_2m_{02}+4\omega_1^2m_{11})+4(1-t)t^3\,\omega_1\omega_2m_{12}+t^4\omega_2^2m_{22}$;
  $\|R_i-R_j\|^2=m_{ii}-2m_{ij}+m_{jj}$, $(R_1-R_0)\cdot(R_0-C)=m_{01}-m_{00}$ and $(R_1-R_2)\cdot(R_2-C)=m_{12}-m_{22}$
:method: Identities in eight coordinates, $r$, the weights and $t$.  On a circle the left side is 0 for infinitely many $t$, so all five coefficients are 0.  With
  positive weights then $m_{00}=m_{01}=m_{12}=m_{22}=0$ and $\omega_0\omega_2m_{02}+2\omega_1^2m_{11}=0$: $R_0R_1$ and $R_2R_1$ are tangents,
  $\|R_0R_1\|^2=m_{11}=\|R_2R_1\|^2$, $\|R_0R_2\|^2=-2m_{02}$, and $4\omega_1^2\|R_0R_1\|^2=\omega_0\omega_2\|R_0R_2\|^2$.
:where: the weights are positive
:over: x# C#: points; r: radius; t: -
:control: the middle coefficient with $2\omega_1^2$ for $4\omega_1^2$
:::
*/
CLAIM(curve_on_a_circle_has_five_conditions)
{
    num R[6], C[2] = {unknown(T, "C", 0), unknown(T, "C", 1)}, r = unknown(T, "r", 0), t = parameter(T, "t");
    num one = from_int(1), two = from_int(2), four = from_int(4), s = sub(one, t), w[3], P[2], m[3][3];
    G(six)(T, "x", R);
    G(three_weights)(T, w);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            m[i][j] = sub(G(scalar)(C, R + 2 * i, R + 2 * j), mul(r, r));
    num ss = mul(s, s), st = mul(s, t), tt = mul(t, t);
    num middle = add(mul(mul(two, mul(w[0], w[2])), m[0][2]), mul(mul(fault(T, four, two), mul(w[1], w[1])), m[1][1]));
    num sum = mul(mul(ss, ss), mul(mul(w[0], w[0]), m[0][0]));
    sum = add(sum, mul(mul(four, mul(ss, st)), mul(mul(w[0], w[1]), m[0][1])));
    sum = add(sum, mul(mul(ss, tt), middle));
    sum = add(sum, mul(mul(four, mul(st, tt)), mul(mul(w[1], w[2]), m[1][2])));
    sum = add(sum, mul(mul(tt, tt), mul(mul(w[2], w[2]), m[2][2])));
    G(rational_point)(2, 2, R, w, t, P);
    num total = G(rational_weight)(2, w, t);
    about(T, "ω² (|R(t) - C|² - r²)");
    same(T, mul(mul(total, total), sub(G(scalar)(C, P, P), mul(r, r))), sum);
    for (int j = 1; j < 3; j++)
        for (int i = 0; i < j; i++) {
            about(T, "a squared side of the triangle");
            same(T, G(scalar)(R + 2 * i, R + 2 * j, R + 2 * j), add(sub(m[i][i], mul(two, m[i][j])), m[j][j]));
        }
    for (int end = 0; end <= 2; end += 2) {
        about(T, "side and radius at an end");
        same(T, neg(G(scalar)(R + 2 * end, R + 2, C)), sub(m[1][end], m[end][end]));
    }
}

/*
The equations (3.5.5) and (3.5.6) are consequences of being an arc.  The theorem takes them for conditions, and there
a quantity has been lost: none of them says how high the triangle is.

:::{statement} wang-ch3:thm-3.5.2
:title: When the rational quadratic curve is a circular arc
:zh: 定理 3.5.2：圆弧的充要条件
:printed: The rational quadratic Bézier curve (3.1.5) is an arc of a circle with the central angle $2\theta$,
  $0<\theta<\frac\pi2$, and the radius $l\csc\theta$ if and only if
  $\|R_0R_1\|=\|R_2R_1\|$, $\|R_0R_2\|=2l$, $\frac{\omega_1^2}{\omega_0\omega_2}=\cos^2\theta$.
:class: missing-hypothesis
:refuted-by: isosceles_triangle_with_another_angle
:corrected: For $l>0$ the rational quadratic Bézier curve (3.1.5) with positive weights is an arc of a circle with the central angle
  $2\theta$, $0<\theta<\frac\pi2$, and the radius $l\csc\theta$ if and only if $\|R_0R_1\|=\|R_2R_1\|=l\sec\theta$,
  $\|R_0R_2\|=2l$, $\frac{\omega_1^2}{\omega_0\omega_2}=\cos^2\theta$.
:corrected-by: arc_and_its_central_angle curve_on_a_circle_has_five_conditions arcs_satisfy_the_three_equations
:needs: negative_weight_gives_the_other_arc | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights
  are positive.
:meant: the theorem itself, which names $\theta$ and $l$ as given numbers and says that three equations suffice | $\theta$ is any angle between 0 and $\frac\pi2$.
:reading: isosceles_triangle_with_another_angle | $\theta$ is any angle that satisfies the three equations, as the theorem
  has it, or $\arccos\sqrt{I_1}$; nothing ties the height of the triangle to it
:reading: arc_and_its_central_angle | $\theta$ is the base angle $\angle R_1R_0R_2$, as in the derivation; of the three steps of the correction below the first says that the
  equations suffice, the others that they are necessary
:reading-with: curve_on_a_circle_has_five_conditions arcs_satisfy_the_three_equations
:striking: 2
:figure: circular_arc_extra

The conditions are necessary.  They are not sufficient: the three equations do not mention the height of the triangle,
so an isosceles triangle of any height passes them.  The derivation before the theorem has the missing equation,
$\omega^2=l^2/(l^2+y_1^2)$.
:::
*/

#if RATIONAL
/*
:::{claim} isosceles_triangle_with_another_angle
:title: An isosceles triangle whose arc is an ellipse
:zh: 满足三式而为椭圆弧
:kind: counterexample
:data: R = (-1,0) (0,1) (1,0); ω = 1 3/5 1; l = 1; cos θ = 3/5; t = 1/2 1/3
:instead: R = (-1,0) (0,4/3) (1,0)
:result: |R_0R_1|², |R_2R_1|², |R_0R_2|² = 2 2 4; I_1 = 9/25; A, …, F = 9/25 0 16/25 0 9/25 -9/25; R(t) = (0,3/8)
  (-15/37,12/37)
:given: the points $R$ of an isosceles triangle, standard weights, $l$ and $\cos\theta$, with an angle $\theta$ that
  is not the base angle, and two parameters $t$, whose points are shown
:then: the three equations hold, but $A\ne C$: the curve lies on an ellipse that is no circle
:method: The three equations are checked, and the conic of the curve is computed.
:control: $R_1$ at the height for which the base angle is $\theta$
:::
*/
CLAIM(isosceles_triangle_with_another_angle)
{
    num R[6], w[3], t[2], S[6], P[4], I[1];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    num l = given(T, "l"), cosine = given(T, "cos θ");
    given_points(T, "t", 2, 1, t);
    num side[3] = {G(scalar)(R, R + 2, R + 2), G(scalar)(R + 4, R + 2, R + 2), G(scalar)(R, R + 4, R + 4)};
    G(rational_invariants)(2, w, I);
    int conditions = equal_q(side[0], side[1]) && equal_q(side[2], mul(from_int(4), mul(l, l))) &&
                     equal_q(I[0], mul(cosine, cosine));
    G(conic_of_bezier)(R, w, S);
    for (int k = 0; k < 2; k++)
        G(rational_point)(2, 2, R, w, t[k], P + 2 * k);
    found_points(T, "|R_0R_1|², |R_2R_1|², |R_0R_2|²", 3, 1, side);
    found(T, "I_1", I[0]);
    found_points(T, "A, …, F", 6, 1, S);
    found_points(T, "R(t)", 2, 2, P);
    about(T, "A and C");
    if (conditions)
        same(T, S[0], S[2]);
}

/*
:::{claim} negative_weight_gives_the_other_arc
:title: With a negative middle weight the curve can be the other arc of the circle
:zh: 中间权为负时得到优弧
:kind: counterexample
:data: R = (-1,0) (0,4/3) (1,0); ω = 1 -3/5 1; cos θ = 3/5; t = 1/2 1/3
:instead: ω = 1 3/5 1
:result: C = (0,-3/4); r² = 25/16; R(t) = (0,-2) (-15/13,-16/13); cos ∠R_0CR(t) = -3/5
:given: the points $R$ of an isosceles triangle, the cosine of its base angle $\theta$, the weights with
  $\omega_1=-\cos\theta$, and two parameters $t$, the first in the middle
:then: the curve lies on the circle with the centre $C$ and the squared radius $r^2$, but its middle point $R(t)$ is seen
  from $C$ at an angle from $R_0$ with the cosine $-\cos\theta$: the central angle is $2\pi-2\theta$
:method: The points are computed, and scalar products are taken.
:control: the middle weight with the other sign
:::
*/
CLAIM(negative_weight_gives_the_other_arc)
{
    num R[6], w[3], t[2], C[2], P[4];
    given_points(T, "R", 3, 2, R);
    given_points(T, "ω", 3, 1, w);
    num cosine = given(T, "cos θ"), rr = G(circular_arc_circle)(R, C);
    given_points(T, "t", 2, 1, t);
    for (int k = 0; k < 2; k++)
        G(rational_point)(2, 2, R, w, t[k], P + 2 * k);
    num seen = div(G(scalar)(C, R, P), rr);
    found_points(T, "C", 1, 2, C);
    found(T, "r²", rr);
    found_points(T, "R(t)", 2, 2, P);
    found(T, "cos ∠R_0CR(t)", seen);
    about(T, "cosine of the angle from R_0 to the middle of the arc, and cos θ");
    if (equal_q(G(scalar)(C, P, P), rr) && equal_q(G(scalar)(C, P + 2, P + 2), rr))
        same(T, seen, cosine);
}
#endif

#include "chapters/judge/claims_off.h"
