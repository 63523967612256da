/*
# Where tangents cut the sides (切线截比)

A point of a conic of the pencil is described by where its tangent cuts the two given tangents.  The two
ratios have a constant product.

Coordinates are those of the frame, $R=R_1+x(R_0-R_1)+y(R_2-R_1)$, and $s=x+y-1$; $S$ is the conic (3.1.4), with
the minus sign unless the plus sign is mentioned.  Through a point with $xy\ne0$ goes the conic of
$\lambda=\frac{xy}{xy+s^2}$, so an identity on all curves of the family is an identity in $x$ and $y$.
*/
#include "exact/record/roots.h"

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"
#include "chapters/rational-bezier/conics.h"

/*
## The tangent at a point

:::{statement} wang-ch3:3.1-tangent
:title: The equation of the tangent
:zh: 切线方程
:printed: The tangent of the curve at the point $R$ has the equation $\frac{Y-y}{X-x}=-\frac{S_x'}{S_y'}$.
:holds-by: tangent_meets_the_conic_doubly
:confirmed-by: slope_exists_inside_the_triangle
:needs: upright_tangent_has_no_slope | § 3.1: the tangent at $R$ meets $l_1=0$ and $l_2=0$ in $A$ and $B$ | $S_y'\ne0$; as at every point of the curve (3.1.4) with the
  minus sign inside the triangle when $0<\lambda<1$; a tangent with $S_y'=0$ is parallel to $l_2=0$ or is $l_2=0$ itself, and there is no point $B$.

Without division, $S_x'(X-x)+S_y'(Y-y)=0$ is the tangent at every point where the gradient is not zero.
:::

:::{claim} tangent_meets_the_conic_doubly
:title: The line orthogonal to the gradient meets the conic twice in its point
:zh: 切线与曲线二重相交
:given: a conic $S$, a point $P=(x,y)$ and a number $h$
:let: $d=(S_y,-S_x)$ at $P$
:then: $S(P+hd)=S(P)+h^2(AS_y^2-2BS_xS_y+CS_x^2)$: there is no term in $h$, so for $S(P)=0$ the line $P+hd$ meets the
  conic twice in $P$; its points $(X,Y)$ satisfy $Y-y=-\frac{S_x}{S_y}(X-x)$
:method: Identities in the coefficients, $x$, $y$ and $h$.
:over: S#: conics; h: -
:control: $d=(S_y,S_x)$
:::
*/
CLAIM(tangent_meets_the_conic_doubly)
{
    num S[6], g[2], x = unknown(T, "x", 0), y = unknown(T, "y", 0), h = unknown(T, "h", 0);
    G(six)(T, "S", S);
    G(conic_gradient)(S, x, y, g);
    num d[2] = {g[1], fault(T, neg(g[0]), g[0])}, X = add(x, mul(h, d[0])), Y = add(y, mul(h, d[1]));
    /* S(P + hd) = S(P) + h² (A d_1² + 2B d_1 d_2 + C d_2²), d = (S_y, -S_x) */
    num square =
        add(add(mul(S[0], mul(d[0], d[0])), mul(mul(from_int(2), S[1]), mul(d[0], d[1]))), mul(S[2], mul(d[1], d[1])));
    about(T, "S along the line");
    same(T, G(form)(S, X, Y), add(G(form)(S, x, y), mul(mul(h, h), square)));
    about(T, "the line");
    same(T, sub(Y, y), mul(neg(div(g[0], g[1])), sub(X, x)));
}

/*
:::{claim} slope_exists_inside_the_triangle
:title: Inside the triangle the tangent is parallel to neither side
:zh: 三角形内切线斜率存在
:given: the minus sign, $\lambda\in(0,1)$ and a point inside the triangle, $x=\frac a{1+a+b}$, $y=\frac b{1+a+b}$ with $a,b>0$
:then: $S_y\ge(1-\lambda)x>0$ and $S_x\ge(1-\lambda)y>0$
:method: $S_y-(1-\lambda)x$ and $S_x-(1-\lambda)y$ have numerators and denominators with coefficients of one sign in
  $a$, $b$ and $\frac\lambda{1-\lambda}$.
:scope: points inside the triangle; 0 < λ < 1
:over: a b k: -
:control: the plus sign
:::
*/
CLAIM(slope_exists_inside_the_triangle)
{
    num a = positive(T, "a", 0), b = positive(T, "b", 0), lambda = inside(T, "k"), one = from_int(1), S[6], g[2];
    num total = add(one, add(a, b)), x = div(a, total), y = div(b, total), mu = sub(one, lambda);
    G(frame_conic)(lambda, fault(T, -1, 1), S);
    G(conic_gradient)(S, x, y, g);
    nonnegative(T, sub(g[1], mul(mu, x)));
    nonnegative(T, sub(g[0], mul(mu, y)));
}

#if RATIONAL
/* A conic of the family (3.1.4), and a point. */
struct member_at_point {
    num lambda, S[6], R[2];
    num value, gradient[2]; /* of S at R */
    int on_curve;
};

/* The conic of the given λ and of that sign, and the given point R. */
static struct member_at_point given_member(trial *T, int sign)
{
    struct member_at_point m = {.lambda = given(T, "λ")};
    given_points(T, "R", 1, 2, m.R);
    G(frame_conic)(m.lambda, sign, m.S);
    m.value = G(form)(m.S, m.R[0], m.R[1]);
    m.on_curve = is_zero_q(m.value);
    G(conic_gradient)(m.S, m.R[0], m.R[1], m.gradient);
    return m;
}

/* The value and the gradient of the conic at the point are results. */
static void found_gradient(trial *T, struct member_at_point m)
{
    found(T, "S(R)", m.value);
    found_points(T, "∇S(R)", 1, 2, m.gradient);
}

/*
:::{claim} upright_tangent_has_no_slope
:title: A tangent parallel to the second side has no slope
:zh: 平行于 y 轴的切线没有斜率
:kind: counterexample
:data: λ = 1/2; R = (4/3,1/3)
:instead: R = (1/3,1/3)
:result: S(R) = 0; ∇S(R) = (-1/2,0)
:given: a $\lambda$ between 0 and 1, and a point $R=(x,y)$ of the curve $S=0$ of (3.1.4) with the minus
  sign, outside the triangle
:then: $S_y=0$, so the printed quotient does not exist
:method: The value and the gradient of $S$ at $R$ are computed.
:control: a point of the curve inside the triangle
:::
*/
CLAIM(upright_tangent_has_no_slope)
{
    struct member_at_point m = given_member(T, -1);
    found_gradient(T, m);
    about(T, "whether the second component of the gradient is not 0");
    refute(T, m.on_curve && is_zero_q(m.gradient[1]));
}
#endif

/*
## Where the tangent cuts the sides

The tangent is a line with a known direction, and to cut it with the axes takes no more than a division: $X_A=x+yS_y/S_x$.
The printed form looks different, because it uses that the point is on the curve.  Along a curve of the family
$(1-\lambda)xy=\lambda(x+y-1)^2$, and this lets $\lambda$ in or out of a formula as one likes.

:::{statement} wang-ch3:3.1-A
:title: The point A where the tangent cuts the first side
:zh: 切线与 l_1 的交点 A
:printed: The tangent of the curve at $R$ cuts $l_1=0$ in
  $A=\left(\frac{-2\lambda(x+y-1)}{(1-\lambda)y-2\lambda(x+y-1)},0\right)$.
:holds-by: tangent_cuts_the_sides
:confirmed-by: slope_exists_inside_the_triangle
:hypothesis: plus_sign_moves_the_cut | the sign in (3.1.4) is minus; with the plus sign both terms $-2\lambda(x+y-1)$ change
  sign.
:needs: tangent_parallel_to_the_first_side | § 3.1: the tangent at $R$ meets $l_1=0$ and $l_2=0$ in $A$ and $B$ | $S_x'\ne0$; as
  at every point of the curve inside the triangle when $0<\lambda<1$.
:figure: tangent_ratios

The point $B$ on the second side is not printed; it is
$\left(0,\frac{-2\lambda(x+y-1)}{(1-\lambda)x-2\lambda(x+y-1)}\right)$, and the claim decides it too.
:::

*/

/* -2 lambda (x + y - 1) / ((1-lambda) z - 2 lambda (x + y - 1)), with 2 for -2 when `other` */
static num G(printed_cut)(num lambda, num x, num y, num z, int other)
{
    num part = mul(mul(from_int(other ? 2 : -2), lambda), sub(add(x, y), from_int(1)));
    return div(part, add(mul(sub(from_int(1), lambda), z), part));
}

/*
:::{claim} tangent_cuts_the_sides
:title: Where the tangent cuts the two sides, and the ratios there
:zh: 切线截两边的点与两个比
:given: a point $R=(x,y)$, a number $\lambda$ and the conic $S$ of (3.1.4), with either sign $\sigma$
:let: $s=x+y-1$, $X_A=x+y\frac{S_y}{S_x}$, $Y_B=y+x\frac{S_x}{S_y}$, and $S$ be its value at $R$
:then: $S_x=(1-\lambda)y+2\sigma\lambda s$, $S_y=(1-\lambda)x+2\sigma\lambda s$; $X_A=\frac{2\sigma\lambda s}{(1-\lambda)y+2\sigma\lambda s}+\frac{2S}{S_x}$,
  $Y_B=\frac{2\sigma\lambda s}{(1-\lambda)x+2\sigma\lambda s}+\frac{2S}{S_y}$; $\frac{X_A}{1-X_A}=\frac{2\sigma\lambda s+2S}{(1-\lambda)y-2S}$,
  $\frac{Y_B}{1-Y_B}=\frac{2\sigma\lambda s+2S}{(1-\lambda)x-2S}$
:method: Identities in $x$, $y$ and $\lambda$.  For a point of the curve, $S=0$, the line with the direction $(S_y,-S_x)$ is the tangent, and meets $Y=0$ in
  $(X_A,0)$ where $S_x\ne0$, $X=0$ in $(0,Y_B)$ where $S_y\ne0$; with the minus sign these are the printed formulas.  Where $S_x\ne0$ it is
  $(1-\lambda)y\ne0$, too: with $(1-\lambda)y=0$ the equation of the curve would be $\lambda s^2=0$, and $S_x=0$; so with $S_y$ and $(1-\lambda)x$.
:over: k: λ
:control: $2\lambda s$ with the minus sign, $-2\lambda s$ with the plus sign
:::
*/
CLAIM(tangent_cuts_the_sides)
{
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), lambda = unknown(T, "k", 0), one = from_int(1), S[6], g[2];
    num s = sub(add(x, y), one), mu = sub(one, lambda), cut[2], other[2] = {y, x};
    for (int sign = -1; sign < 2; sign += 2) {
        int plus = fault(T, sign > 0, sign < 0);
        G(frame_conic)(lambda, sign, S);
        G(conic_gradient)(S, x, y, g);
        G(tangent_cuts)(S, x, y, &cut[0], &cut[1]);
        num twice = mul(from_int(2), G(form)(S, x, y)), part = mul(mul(from_int(plus ? 2 : -2), lambda), s);
        for (int side = 0; side < 2; side++) {
            num rest = mul(mu, other[side]);
            about(T, side == 0 ? "S_x" : "S_y");
            same(T, g[side], add(rest, part));
            about(T, side == 0 ? "the cut with the first side" : "the cut with the second side");
            /* X_A = 2σλs/((1-λ) y + 2σλs) + 2S/S_x */
            same(T, cut[side], add(G(printed_cut)(lambda, x, y, other[side], plus), div(twice, g[side])));
            about(T, side == 0 ? "the first ratio" : "the second ratio");
            /* X_A/(1 - X_A) = (2σλs + 2S)/((1-λ) y - 2S) */
            same(T, div(cut[side], sub(one, cut[side])), div(add(part, twice), sub(rest, twice)));
        }
    }
}

#if RATIONAL
/*
Three things can go wrong with the printed point.  It is computed for the minus sign, which (3.1.4) leaves open.  The
tangent may be parallel to the side.  And at the ends of the curve the tangent is the side itself.

:::{claim} plus_sign_moves_the_cut
:title: With the plus sign the printed point need not be on the tangent
:zh: 取正号时所印 A 可不在切线上
:kind: counterexample
:data: λ = 1/2; R = (-1,1)
:result: S(R) = 0; X_A from the tangent = 2; X_A as printed = 2/3
:given: a $\lambda$ between 0 and 1, and a point $R=(x,y)$ of the curve $S=0$ of (3.1.4) with the plus sign
:then: the tangent at $R$ meets the first side elsewhere than the printed quotient says
:method: The tangent is intersected with $Y=0$.
:control: $+2\lambda(x+y-1)$ for $-2\lambda(x+y-1)$ in numerator and denominator
:::
*/
CLAIM(plus_sign_moves_the_cut)
{
    struct member_at_point m = given_member(T, 1);
    num X, Y, printed = G(printed_cut)(m.lambda, m.R[0], m.R[1], m.R[1], fault(T, 1, 0));
    found(T, "S(R)", m.value);
    G(tangent_cuts)(m.S, m.R[0], m.R[1], &X, &Y);
    found(T, "X_A from the tangent", X);
    found(T, "X_A as printed", printed);
    about(T, "X_A, left from the tangent, right as printed");
    if (m.on_curve)
        same(T, X, printed);
}

/*
:::{claim} tangent_parallel_to_the_first_side
:title: A tangent may be parallel to the first side, or to the second
:zh: 切线可平行于 l_1 或 l_2
:kind: counterexample
:data: λ = 1/2; R = (1/3,4/3) (4/3,1/3)
:instead: R = (1/3,1/3) (1/3,1/3)
:result: S(R) = 0 0; ∇S(R) = (0,-1/2) (-1/2,0); denominators of the two cuts = 0 0
:given: a $\lambda$ between 0 and 1, and two points $R=(x,y)$ of the curve $S=0$ of (3.1.4) with the minus
  sign, outside the triangle
:then: at the first $S_x=0$ and $(1-\lambda)y-2\lambda(x+y-1)=0$: there is no point $A$; at the second $S_y=0$ and $(1-\lambda)x-2\lambda(x+y-1)=0$:
  there is no point $B$
:method: The value and the gradient of $S$ at both points are computed, the denominator of $X_A$ at the first, of $Y_B$ at the second.
:control: a point of the curve inside the triangle
:::
*/
CLAIM(tangent_parallel_to_the_first_side)
{
    num lambda = given(T, "λ"), one = from_int(1), R[4], S[6], value[2], gradient[4], below[2];
    given_points(T, "R", 2, 2, R);
    G(frame_conic)(lambda, -1, S);
    int missing = 0;
    for (int k = 0; k < 2; k++) {
        num x = R[2 * k], y = R[2 * k + 1], s = sub(add(x, y), one);
        value[k] = G(form)(S, x, y);
        G(conic_gradient)(S, x, y, gradient + 2 * k);
        /* (1-λ) y - 2λ (x+y-1), (1-λ) x - 2λ (x+y-1) */
        below[k] = sub(mul(sub(one, lambda), k == 0 ? y : x), mul(mul(from_int(2), lambda), s));
        missing += is_zero_q(value[k]) && is_zero_q(gradient[3 * k]) && is_zero_q(below[k]);
    }
    found_points(T, "S(R)", 2, 1, value);
    found_points(T, "∇S(R)", 2, 2, gradient);
    found_points(T, "denominators of the two cuts", 2, 1, below);
    about(T, "whether the denominator is not 0, at one of the two points");
    agree(T, missing <= fault(T, 0, 1)); /* the control: at both */
}

/*
:::{claim} end_has_but_one_ratio
:title: At an end of the curve the tangent is a side, and one of the two ratios does not exist
:zh: 端点处切线即边，两比之一无定义
:kind: counterexample
:data: λ = 1/2; R = (1,0) (0,1)
:instead: R = (1/3,1/3) (1/3,1/3)
:result: S(R) = 0 0; ∇S(R) = (0,1/2) (1/2,0); numerators of the two ratios = 0 0; denominators of the two ratios = 0 0
:given: a $\lambda$ between 0 and 1, and the points $R_0$ and $R_2$, which are on the curve $S=0$ of (3.1.4) with the minus sign
:then: $-2\lambda(x+y-1)$ and $(1-\lambda)y$ are both 0 in $R_0$: the printed $g_1$ is $\frac00$, and the tangent is $l_1$ itself,
  without a point $A$; so it is with $g_2$, $(1-\lambda)x$ and $l_2$ in $R_2$
:method: The values and the gradients of $S$ at the two points; the numerator and the denominator of $g_1$ at the first, of $g_2$ at the second.
:control: a point of the curve inside the triangle
:::
*/
CLAIM(end_has_but_one_ratio)
{
    num lambda = given(T, "λ"), one = from_int(1), R[4], S[6], value[2], gradient[4], above[2], below[2];
    given_points(T, "R", 2, 2, R);
    G(frame_conic)(lambda, -1, S);
    for (int k = 0; k < 2; k++) {
        num x = R[2 * k], y = R[2 * k + 1];
        value[k] = G(form)(S, x, y);
        G(conic_gradient)(S, x, y, gradient + 2 * k);
        above[k] = mul(mul(from_int(-2), lambda), sub(add(x, y), one));
        below[k] = mul(sub(one, lambda), k == 0 ? y : x);
    }
    found_points(T, "S(R)", 2, 1, value);
    found_points(T, "∇S(R)", 2, 2, gradient);
    found_points(T, "numerators of the two ratios", 2, 1, above);
    found_points(T, "denominators of the two ratios", 2, 1, below);
    int first = is_zero_q(value[0]) && (is_zero_q(gradient[0]) || is_zero_q(below[0]));
    int last = is_zero_q(value[1]) && (is_zero_q(gradient[3]) || is_zero_q(below[1]));
    about(T, "whether the tangent cuts the side in one point and the denominator is not 0, in one of the two points");
    refute(T, first && last);
}
#endif

/*
## The two ratios

:::{statement} wang-ch3:3.1-g-parameters
:title: The two ratios of lengths serve as the parameter of a point
:zh: 以切线截比作为点的参数
:printed: The tangent at $R$ meets $l_1=0$ and $l_2=0$ in $A$ and $B$; then
  $(g_1,g_2)=\left(\frac{\|R_1A\|}{\|R_0A\|},\frac{\|R_1B\|}{\|R_2B\|}\right)$ can be taken as the parameter of $R$, for
  every point $R$ of the curve.
:holds-by: ratios_of_lengths_inside_the_triangle signed_ratios_give_the_point ratios_on_the_curve
:hypothesis: lengths_do_not_tell_points_apart | $R$ lies inside the triangle, or the ratios have signs.
:needs: tangent_parallel_to_the_first_side | the sentence itself: the tangent at $R$ meets $l_1=0$ and $l_2=0$ | the tangent
  is parallel to neither $l_1=0$ nor $l_2=0$.
:needs: end_has_but_one_ratio | the sentence itself: the tangent at $R$ meets $l_1=0$ and $l_2=0$ in points $A$ and $B$ | $R\ne
  R_0,R_2$: there the tangent is one of the two lines.
:figure: tangent_ratios

Where $A$ and $B$ are points, $xy\ne0$ and $x+y\ne1$: for $\lambda\ne0,1$ the equation (3.1.4) has $xy=0$ only together with $x+y=1$, which is $R_0$ or $R_2$; for
$\lambda=0$ the curve is the two lines themselves, and for $\lambda=1$ a double line, without a tangent.
:::

:::{claim} ratios_of_lengths_inside_the_triangle
:title: Inside the triangle the ratios of lengths are these, and positive
:zh: 三角形内长度之比
:given: a triangle $R_0R_1R_2$ of the plane with any coordinates, and a point $P$ inside it, $x=\frac a{1+a+b}$,
  $y=\frac b{1+a+b}$ with $a,b>0$
:let: the tangent at $P$ of the conic of Liming's pencil through $P$ meet $R_1R_0$ in $A$ and $R_1R_2$ in $B$
:then: $A$ and $B$ exist and lie between the ends of the sides, $\|R_1A\|^2=(2a)^2\|R_0A\|^2$ and
  $\|R_1B\|^2=(2b)^2\|R_2B\|^2$, where $2a=\frac{-2x}{x+y-1}$, $2b=\frac{-2y}{x+y-1}$: $g_1=2a>0$, $g_2=2b>0$
:method: The conic is formed from the lines of the triangle in the plane's own coordinates, its tangent
  intersected with the sides there, and the squared distances are taken; all six coordinates and $a$, $b$ are
  variables.  $\|R_1A\|$ and $\|R_0A\|$ are measured on one line, so their ratio is that of the frame.
:scope: points inside the triangle for ratios of lengths
:over: R#: triangles; a b: -
:control: the tangent of the conic with half the $\lambda$
:::
*/
CLAIM(ratios_of_lengths_inside_the_triangle)
{
    num R[6], a = positive(T, "a", 0), b = positive(T, "b", 0), one = from_int(1), two = from_int(2);
    num l1[3], l2[3], l3[3], S[6], g[2], P[2], total = add(one, add(a, b));
    G(six)(T, "R", R);
    for (int c = 0; c < 2; c++) /* x R_0 + (1-x-y) R_1 + y R_2 */
        P[c] = div(add(add(mul(a, R[c]), R[2 + c]), mul(b, R[4 + c])), total);
    num lambda = G(lambda_at)(div(a, total), div(b, total), -1);
    G(line_through)(R + 2, R, l1);
    G(line_through)(R + 2, R + 4, l2);
    G(line_through)(R, R + 4, l3);
    G(conic_liming)(fault(T, lambda, mul(from_ratio(1, 2), lambda)), l1, l2, l3, S);
    G(conic_gradient)(S, P[0], P[1], g);
    for (int side = 0; side < 2; side++) {
        const num *end = R + 4 * side;
        num ratio = mul(two, side == 0 ? a : b), square[2] = {from_int(0), from_int(0)}, up = from_int(0), down = up;
        for (int c = 0; c < 2; c++) { /* the cut is R_1 + (up/down)(end - R_1) */
            up = add(up, mul(g[c], sub(P[c], R[2 + c])));
            down = add(down, mul(g[c], sub(end[c], R[2 + c])));
        }
        num share = div(up, down);
        for (int c = 0; c < 2; c++) {
            num cut = add(R[2 + c], mul(share, sub(end[c], R[2 + c])));
            num from = sub(cut, R[2 + c]), to = sub(cut, end[c]);
            square[0] = add(square[0], mul(from, from));
            square[1] = add(square[1], mul(to, to));
        }
        about(T, side == 0 ? "|R1 A|² and g1² |R0 A|²" : "|R1 B|² and g2² |R2 B|²");
        /* |R_1 A|² = (2a)² |R_0 A|², |R_1 B|² = (2b)² |R_2 B|² */
        same(T, square[0], mul(mul(ratio, ratio), square[1]));
        about(T, side == 0 ? "A between R1 and R0" : "B between R1 and R2");
        same(T, share, div(ratio, add(one, ratio)));
        G(must_be_positive)(T, div(ratio, add(one, ratio)));
        G(must_be_positive)(T, sub(one, div(ratio, add(one, ratio))));
    }
}

#if RATIONAL
/*
Outside the triangle a ratio of lengths is the absolute value of the ratio of coordinates, and two points can share it.
With their signs the ratios do tell all points apart, by `signed_ratios_give_the_point` of the next section.

:::{claim} lengths_do_not_tell_points_apart
:title: Two points of one curve with the same ratios of lengths
:zh: 长度之比不能区分两点
:kind: counterexample
:data: λ = 1/2; P = (1/3,1/3); Q = (1,1)
:result: at P, (g_1, g_2) = (2,2); at Q, (g_1, g_2) = (2,2)
:given: a $\lambda$ between 0 and 1, and two points of the curve (3.1.4) with the minus sign, $P$ inside the triangle and $Q$ outside
:then: both have the same ratios of lengths
:method: The tangents are intersected with the sides, and the lengths are taken along the sides.
:control: the ratios with their signs, which are positive at $P$ and negative at $Q$
:::
*/
CLAIM(lengths_do_not_tell_points_apart)
{
    num lambda = given(T, "λ"), P[2], Q[2], S[6], g[2], h[2];
    given_points(T, "P", 1, 2, P);
    given_points(T, "Q", 1, 2, Q);
    G(frame_conic)(lambda, -1, S);
    int on_curve = is_zero_q(G(form)(S, P[0], P[1])) && is_zero_q(G(form)(S, Q[0], Q[1]));
    ratios(lambda, -1, P[0], P[1], g);
    ratios(lambda, -1, Q[0], Q[1], h);
    for (int c = 0; c < 2; c++) {
        g[c] = fault(T, g[c], length(g[c]));
        h[c] = fault(T, h[c], length(h[c]));
    }
    found_points(T, "at P, (g_1, g_2)", 1, 2, g);
    found_points(T, "at Q, (g_1, g_2)", 1, 2, h);
    about(T, "whether the ratios tell the points apart");
    refute(T, on_curve && equal_q(g[0], h[0]) && equal_q(g[1], h[1]));
}
#endif

/*
:::{statement} wang-ch3:3.1-g1
:title: The first ratio
:zh: g_1 的表达式
:printed: g_1=\frac{X_A}{1-X_A}=\frac{-2\lambda(x+y-1)}{(1-\lambda)y}
:holds-by: tangent_cuts_the_sides ratios_of_lengths_inside_the_triangle
:confirmed-by: ratios_on_the_curve
:hypothesis: outside_the_triangle_lengths_lose_the_sign | $R$ lies inside the triangle, or $g_1$ is taken with its sign.
:hypothesis: plus_sign_turns_the_ratio | the sign in (3.1.4) is minus.
:needs: tangent_parallel_to_the_first_side | § 3.1: the tangent at $R$ meets $l_1=0$ and $l_2=0$ in $A$ and $B$ | $S_x'\ne0$; as
  in the triangle when $0<\lambda<1$; else the tangent does not cut the side in one point.

In $R_0$ the tangent is the side itself, with $S_x'=0$; in $R_2$ it is $l_2$, $A$ is $R_1$ and $g_1=0$, as printed.  On the curve, where $x+y\ne1$, both
ratios are simpler than printed: $g_1=\frac{-2x}{x+y-1}$ and $g_2=\frac{-2y}{x+y-1}$.
:::

:::{statement} wang-ch3:3.1-g2
:title: The second ratio
:zh: g_2 的表达式
:printed: In the same way $g_2=\frac{-2\lambda(x+y-1)}{(1-\lambda)x}$.
:holds-by: tangent_cuts_the_sides ratios_of_lengths_inside_the_triangle
:confirmed-by: ratios_on_the_curve
:hypothesis: outside_the_triangle_lengths_lose_the_sign | $R$ lies inside the triangle, or $g_2$ is taken with its sign.
:hypothesis: plus_sign_turns_the_ratio | the sign in (3.1.4) is minus.
:needs: tangent_parallel_to_the_first_side | § 3.1: the tangent at $R$ meets $l_1=0$ and $l_2=0$ in $A$ and $B$ |
  $S_y'\ne0$; as inside the triangle when $0<\lambda<1$; else the tangent does not cut the side in one point.

In $R_2$ the tangent is the side itself, with $S_y'=0$; in $R_0$ it is $l_1$, $B$ is $R_1$ and $g_2=0$, as printed.
:::

With $s=x+y-1$ the relation $(1-\lambda)xy=\lambda s^2$ turns the printed $g_1=\frac{-2\lambda s}{(1-\lambda)y}$ into
$\frac{-2x}s$: the ratio does not depend on the curve at all, only on the point.

:::{claim} ratios_on_the_curve
:title: The two ratios on every curve of the family
:zh: 曲线族上的两个比
:given: a point $R=(x,y)$ with $xy\ne0$, $s=x+y-1\ne0$, and the conic $S$ of the family through it, with either sign
:where: $xy\ne0$ and $x+y\ne1$
:let: $A=(X_A,0)$ and $B=(0,Y_B)$ be the cuts of the tangent, $g_1=\frac{X_A}{1-X_A}$, $g_2=\frac{Y_B}{1-Y_B}$
:then: $g_1=\frac{-2x}s$, $g_2=\frac{-2y}s$; with the minus sign also $g_1=\frac{-2\lambda s}{(1-\lambda)y}$,
  $g_2=\frac{-2\lambda s}{(1-\lambda)x}$, and with the plus sign the negatives of these
:method: $A$ and $B$ by intersecting the tangent with the sides; $\lambda$ is expressed by $x$ and $y$.
:control: the printed quotients taken with the plus sign without change
:::
*/
CLAIM(ratios_on_the_curve)
{
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), one = from_int(1), s = sub(add(x, y), one), S[6], X, Y;
    for (int sign = -1; sign < 2; sign += 2) {
        num lambda = G(lambda_at)(x, y, sign), mu = sub(one, lambda);
        G(frame_conic)(lambda, sign, S);
        G(tangent_cuts)(S, x, y, &X, &Y);
        num g1 = div(X, sub(one, X)), g2 = div(Y, sub(one, Y));
        about(T, "the ratios by the point alone");
        /* g_1 = -2x/s, g_2 = -2y/s */
        same(T, g1, div(mul(from_int(-2), x), s));
        same(T, g2, div(mul(from_int(-2), y), s));
        about(T, "the ratios as printed");
        num top = mul(mul(from_int(fault(T, 2 * sign, -2)), lambda), s);
        /* g_1 = 2σλs/((1-λ) y), g_2 = 2σλs/((1-λ) x) */
        same(T, g1, div(top, mul(mu, y)));
        same(T, g2, div(top, mul(mu, x)));
    }
}

#if RATIONAL
/* factor lambda (x + y - 1)/((1-lambda) y), and with x for y: the printed g_1 and g_2 have the factor -2. */
static void printed_ratios(struct member_at_point m, int factor, num g[2])
{
    num s = sub(add(m.R[0], m.R[1]), from_int(1)), mu = sub(from_int(1), m.lambda);
    for (int k = 0; k < 2; k++)
        g[k] = div(mul(from_int(factor), mul(m.lambda, s)), mul(mu, m.R[1 - k]));
}

/*
:::{claim} outside_the_triangle_lengths_lose_the_sign
:title: Outside the triangle the ratios of lengths need not be the printed quotients
:zh: 三角形外长度之比可与所印公式不符
:kind: counterexample
:data: λ = 1/2; R = (1,1)
:instead: R = (1/3,1/3)
:result: S(R) = 0; ‖R_1A‖/‖R_0A‖, ‖R_1B‖/‖R_2B‖ = 2 2; g_1, g_2 as printed = -2 -2
:given: a $\lambda$ between 0 and 1, and a point $R=(x,y)$ of the curve $S=0$ of (3.1.4) with the minus
  sign, outside the triangle
:then: the ratios $\|R_1A\|/\|R_0A\|$ and $\|R_1B\|/\|R_2B\|$ are the printed quotients without their sign
:method: The tangent is intersected with the sides, and the lengths are taken along these.
:control: a point of the curve inside the triangle
:::
*/
CLAIM(outside_the_triangle_lengths_lose_the_sign)
{
    struct member_at_point m = given_member(T, -1);
    num g[2], printed[2];
    printed_ratios(m, -2, printed);
    ratios(m.lambda, -1, m.R[0], m.R[1], g);
    int off = 0;
    for (int k = 0; k < 2; k++) {
        g[k] = length(g[k]);
        off += m.on_curve && !equal_q(g[k], printed[k]);
    }
    found(T, "S(R)", m.value);
    found_points(T, "‖R_1A‖/‖R_0A‖, ‖R_1B‖/‖R_2B‖", 2, 1, g);
    found_points(T, "g_1, g_2 as printed", 2, 1, printed);
    about(T, "whether one of the two ratios of lengths is as printed");
    agree(T, off <= fault(T, 0, 1)); /* the control: both */
}

/*
:::{claim} plus_sign_turns_the_ratio
:title: With the plus sign the printed quotients have the wrong sign
:zh: 取正号时 g_1, g_2 符号相反
:kind: counterexample
:data: λ = 1/2; R = (-1,1)
:result: S(R) = 0; X_A/(1-X_A), Y_B/(1-Y_B) = -2 2; g_1, g_2 as printed = 2 -2
:given: a $\lambda$ between 0 and 1, and a point $R=(x,y)$ of the curve $S=0$ of (3.1.4) with the plus sign
:then: $\frac{X_A}{1-X_A}$ and $\frac{Y_B}{1-Y_B}$ are the negatives of the printed quotients
:method: The tangent is intersected with the sides.
:control: $+2\lambda(x+y-1)$ in place of $-2\lambda(x+y-1)$
:::
*/
CLAIM(plus_sign_turns_the_ratio)
{
    struct member_at_point m = given_member(T, 1);
    num g[2], printed[2];
    printed_ratios(m, fault(T, 2, -2), printed);
    ratios(m.lambda, 1, m.R[0], m.R[1], g);
    found(T, "S(R)", m.value);
    found_points(T, "X_A/(1-X_A), Y_B/(1-Y_B)", 2, 1, g);
    found_points(T, "g_1, g_2 as printed", 2, 1, printed);
    about(T, "whether one of the two quotients is as printed");
    int off = 0;
    for (int k = 0; k < 2; k++)
        off += m.on_curve && !equal_q(g[k], printed[k]);
    agree(T, off <= fault(T, 0, 1)); /* the control: both */
}
#endif

/*
## Their product

Multiply the two short forms: $g_1g_2=\frac{4xy}{s^2}$, and on the curve $\frac{xy}{s^2}=\frac\lambda{1-\lambda}$.  This is
why the product is constant, and it shows at once where the print goes too far.  The constant is positive for $0<\lambda<1$,
while the sentence is about every curve of the family.

:::{statement} wang-ch3:3.1-g-product
:title: The product of the ratios is one positive constant on every curve of the family
:zh: g_1 g_2 为正常数
:printed: $g_1g_2=\frac{4\lambda}{1-\lambda}$, which shows that on every curve of the family (3.1.4) $g_1g_2=\mathrm{const}>0$
:class: missing-hypothesis
:refuted-by: product_of_lengths_is_not_printed product_of_ratios_can_be_negative
:corrected: $g_1g_2=\frac{4\lambda}{1-\lambda}=\mathrm{const}>0$ on every curve of (3.1.4) with the minus sign and
  $0<\lambda<1$, in the triangle and outside, at every point where both ratios exist: all but $R_0$, $R_2$ and those with
  a tangent parallel to $l_1=0$ or $l_2=0$
:corrected-by: product_of_ratios_is_constant
:confirmed-by: product_of_ratios_is_positive_inside
:reading: product_of_ratios_is_constant | Only the curves of points of the triangle are spoken of, with the minus sign, as where the source names $\lambda\in(0,1)$: then
  it is right, wherever both ratios exist.
:reading: product_of_ratios_can_be_negative | $g_1$, $g_2$ have signs: constant, but negative for $\lambda>1$ and for
  $\lambda<0$.
:reading: product_of_lengths_is_not_printed | $g_1$, $g_2$ are ratios of lengths: constant and positive, but not
  $4\lambda/(1-\lambda)$ for $\lambda>1$ and for $\lambda<0$.
:meant: the norms in the definition of $(g_1,g_2)$ | The ratios are those of lengths.  The formula that is printed is
  that of ratios with signs, $X_A/(1-X_A)$; with either the sentence fails.
:figure: ratio_product_extra

The source names $0<\lambda<1$ and the minus sign before, for the points of the triangle; what it
prints here is about every curve of the family.  With $0<\lambda<1$ and the minus sign the two ratios have one sign at every
point, so that it does not matter whether they have signs or are lengths.  With the plus sign the product of the signed
ratios is $-4\lambda/(1-\lambda)$.  On a curve with $0<\lambda<1$ only $R_0$ and $R_2$ have $xy=0$ or $x+y=1$.
:::

:::{statement} wang-ch3:3.1-g-product-constant
:title: The product of the ratios does not depend on the point
:zh: g_1 g_2 与动点无关
:printed: The value of $g_1g_2$ does not depend on the moving point $R$.
:holds-by: product_of_ratios_is_constant
:needs: end_has_but_one_ratio | § 3.1: the tangent at $R$ meets $l_1=0$ and $l_2=0$ in $A$ and $B$ | $R\ne R_0,R_2$: there one of the two ratios is $0/0$.
:needs: tangent_parallel_to_the_first_side | § 3.1: the tangent at $R$ meets $l_1=0$ and $l_2=0$ in $A$ and $B$ | the tangent is parallel to neither $l_1=0$ nor
  $l_2=0$, so that $A$ and $B$ are points; the printed quotients exist there, and so does their product.
:figure: tangent_ratios

For $\lambda\ne0,1$ the equation (3.1.4) has $xy=0$ only together with $x+y=1$, which is $R_0$ or $R_2$; for $\lambda=0$ the curve is the two lines
themselves, and for $\lambda=1$ a double line, without a tangent.  So $xy\ne0$ and $x+y\ne1$ where both ratios exist.
:::

:::{claim} product_of_ratios_is_constant
:title: On each curve of the family the product of the signed ratios is constant
:zh: 曲线族上 g_1 g_2 为常数
:given: a point $R=(x,y)$ with $xy\ne0$, $x+y\ne1$, and the conic of the family through it, with either sign $\sigma$
:where: $xy\ne0$ and $x+y\ne1$
:then: $g_1g_2=\frac{-4\sigma\lambda}{1-\lambda}$, and so is the product of the ratios of lengths up to its sign; and
  $\frac{4\lambda}{1-\lambda}>0$ for $0<\lambda<1$, and less than 0 for $\lambda>1$ and for $\lambda<0$
:method: The tangent is intersected with the sides; $\lambda$ is expressed by $x$ and $y$.  For the signs
  $\frac\lambda{1-\lambda}$, $\lambda-1$ and $-\lambda$ are positive variables.
:over: k p: -
:control: the factor 2 for 4
:::
*/
CLAIM(product_of_ratios_is_constant)
{
    num x = unknown(T, "x", 0), y = unknown(T, "y", 0), one = from_int(1), S[6], X, Y;
    for (int sign = -1; sign < 2; sign += 2) {
        num lambda = G(lambda_at)(x, y, sign);
        G(frame_conic)(lambda, sign, S);
        G(tangent_cuts)(S, x, y, &X, &Y);
        num product = mul(div(X, sub(one, X)), div(Y, sub(one, Y)));
        /* g_1 g_2 = -4σλ/(1-λ) */
        same(T, product, div(mul(from_int(fault(T, -4, -2) * sign), lambda), sub(one, lambda)));
    }
    num between = inside(T, "k"), p = positive(T, "p", 0), outer[2] = {add(one, p), neg(p)};
    about(T, "4λ/(1-λ) for 0 < λ < 1");
    G(must_be_positive)(T, div(mul(from_int(4), between), sub(one, between)));
    for (int k = 0; k < 2; k++) {
        about(T, k == 0 ? "-4λ/(1-λ) for λ > 1" : "-4λ/(1-λ) for λ < 0");
        G(must_be_positive)(T, neg(div(mul(from_int(4), outer[k]), sub(one, outer[k]))));
    }
}

/*
:::{claim} product_of_ratios_is_positive_inside
:title: Inside the triangle the product is positive
:zh: 三角形内 g_1 g_2 为正
:given: $\lambda\in(0,1)$, the minus sign, and a point of the curve inside the triangle
:then: $g_1g_2=\frac{4\lambda}{1-\lambda}>0$
:method: The point is $x=\frac a{1+a+b}$, $y=\frac b{1+a+b}$ with $a>0$ a variable and $b=\frac\lambda{(1-\lambda)a}$,
  which is where the curve meets the line $y:x=b:a$; the ratios come from the tangent.  The product has coefficients of
  one sign in $\frac\lambda{1-\lambda}$.
:scope: points inside the triangle; 0 < λ < 1
:over: a k: -
:control: the plus sign
:::
*/
CLAIM(product_of_ratios_is_positive_inside)
{
    num lambda = inside(T, "k"), a = positive(T, "a", 0), one = from_int(1), S[6], X, Y;
    num odds = div(lambda, sub(one, lambda)), b = div(odds, a), total = add(one, add(a, b));
    num x = div(a, total), y = div(b, total);
    G(frame_conic)(lambda, fault(T, -1, 1), S);
    about(T, "S at the point");
    vanishes(T, G(form)(S, x, y));
    G(tangent_cuts)(S, x, y, &X, &Y);
    num product = mul(div(X, sub(one, X)), div(Y, sub(one, Y)));
    about(T, "the product");
    /* g_1 g_2 = 4λ/(1-λ) */
    same(T, product, mul(from_int(4), odds));
    G(must_be_positive)(T, mul(from_int(4), odds));
}

#if RATIONAL
/* 4 lambda/(1-lambda) */
static num printed_product(num lambda) { return div(mul(from_int(4), lambda), sub(from_int(1), lambda)); }

/*
Both counterexamples use one point of a hyperbola, whose $\lambda$ is greater than 1.  As ratios of
coordinates its two ratios have a negative product.  As ratios of lengths they have a positive one, which then is not the
printed number.

:::{claim} product_of_ratios_can_be_negative
:title: A curve of the family whose ratios have a negative product
:zh: g_1 g_2 可为负
:kind: counterexample
:data: λ = 4/3; R = (2,-2)
:instead: λ = 1/2; R = (1/3,1/3)
:result: AC-B² = -17/36; S(R) = 0; (g_1, g_2) = (4,-4); g_1 g_2 = -16; 4λ/(1-λ) = -16
:given: a $\lambda$ greater than 1, whose curve $S=0$ of (3.1.4) with the minus sign is a hyperbola, $AC-B^2<0$ for the coefficients of (3.1.1), and a point $R=(x,y)$ of it
:then: $g_1g_2=\frac{4\lambda}{1-\lambda}$ is negative
:method: The tangent at $R$ is intersected with the sides.
:control: a $\lambda$ between 0 and 1, and a point of its curve inside the triangle
:::
*/
CLAIM(product_of_ratios_can_be_negative)
{
    struct member_at_point m = given_member(T, -1);
    num g[2];
    ratios(m.lambda, -1, m.R[0], m.R[1], g);
    num product = mul(g[0], g[1]);
    found(T, "AC-B²", G(conic_delta)(m.S));
    found(T, "S(R)", m.value);
    found_points(T, "(g_1, g_2)", 1, 2, g);
    found(T, "g_1 g_2", product);
    found(T, "4λ/(1-λ)", printed_product(m.lambda));
    about(T, "whether the product is positive");
    refute(T, m.on_curve && sign_q(product) <= 0);
}

/*
:::{claim} product_of_lengths_is_not_printed
:title: A curve of the family where the product of the ratios of lengths is not the printed one
:zh: 长度之比的乘积与所印不符
:kind: counterexample
:data: λ = 4/3; R = (2,-2)
:instead: λ = 1/2; R = (1/3,1/3)
:result: S(R) = 0; product of the ratios of lengths = 16; 4λ/(1-λ) = -16
:given: a $\lambda$ greater than 1, whose curve $S=0$ of (3.1.4) with the minus sign is a hyperbola, $AC-B^2<0$ for the coefficients of (3.1.1), and a point $R=(x,y)$ of it
:then: the product of the ratios of lengths is positive, and the printed product is its negative
:method: The tangent at $R$ is intersected with the sides, and the lengths are taken along these.
:control: a $\lambda$ between 0 and 1, and a point of its curve inside the triangle
:::
*/
CLAIM(product_of_lengths_is_not_printed)
{
    struct member_at_point m = given_member(T, -1);
    num g[2];
    ratios(m.lambda, -1, m.R[0], m.R[1], g);
    num product = mul(length(g[0]), length(g[1]));
    found(T, "S(R)", m.value);
    found(T, "product of the ratios of lengths", product);
    found(T, "4λ/(1-λ)", printed_product(m.lambda));
    about(T, "g1 g2, left as a product of ratios of lengths, right as printed");
    if (m.on_curve)
        same(T, product, printed_product(m.lambda));
}
#endif

#include "chapters/judge/claims_off.h"
