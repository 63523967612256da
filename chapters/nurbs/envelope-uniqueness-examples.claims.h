/*
# Every level: three counterexamples and a condition that is enough (包络唯一性的反例与充分条件)

Of every level $r\ge2$ the joint solutions beside the diagonal are the pairs for which the member of level $r-1$ has no curvature, as the section
before has shown.  The families are computed from control points over uniform knots; a polynomial of the span has its control points as
values of its polar form.
*/
#include "chapters/nurbs/family.h"

#include "chapters/judge/claims_on.h"

#if RATIONAL
/*
How does one find a convex curve with a second envelope?  For $(t,y(t))$ of degree 4 and $r=2$ the member of level 1
has no curvature where $y''[\tau,t]$, the polar form of $y''$, vanishes.  For an even quartic this form is a constant
plus a multiple of $t\tau$; it is positive for $t=\tau$, and yet 0 on a hyperbola when $t$ and $\tau$ have different
signs.

:::{claim} convex_quartic_of_span_has_second_envelope
:title: A convex segment without inflections, and a point off it that satisfies the condition
:zh: 无拐点的凸四次曲线段,曲线外有点满足包络条件
:kind: counterexample
:given: the quartic $\sum a_mt^m$, which is $(t,2t^4+3t^2)$, as a segment over the uniform knots $t_i$, weights 1;
  $r=2$, a pair of $t$ and $\tau$
:data: t_i = -9 -7 -5 -3 -1 1 3 5 7 9; a = (0,0) (1,0) (0,3) (0,0) (0,2); t = -1/2; τ = 1/2
:instead: t = 1/2
:then: (4.3.15) is satisfied at a point that is not on the curve, whose $\mathbf r'\times\mathbf r''$ is positive on
  the closed span
:result: r_i = (-4,253) (-2,-23) (0,13) (2,-23) (4,253); r' × r'' is positive on the span = 1; point of the member =
  (0,-1/8); its derivatives by t and τ = (1/2,0) (1/2,0); point of the curve with its abscissa = (0,0)
:method: That $x'y''-x''y'$ is positive is decided first, by its sign as a polynomial on the closed span; then that
  the pair satisfies the condition; then the ordinate of the point is compared with that of the curve where the
  abscissa is the same.  All such pairs, and the parabola of their points, are in `second_envelopes_of_spans`.
:control: $t=\tau$
:::
*/
CLAIM(convex_quartic_of_span_has_second_envelope)
{
    num u[10], R[10], w[5], X[2], at[2], t = given(T, "t"), tau = given(T, "τ");
    G(given_curve_of_powers)(T, 4, 2, u, R, w);
    int convex = G(turns_left_on_span)(4, u, 4, R);
    found_whole(T, "r' × r'' is positive on the span", convex);
    if (!G(pair_in_the_square)(T, 4, 2, u, 4, R, w, 2, tau, t, X) || !convex)
        return;
    G(curve_derivatives)(4, 2, u, 4, R, w, X[0], 0, at); /* x(t) = t */
    found_points(T, "point of the curve with its abscissa", 1, 2, at);
    about(T, "the ordinates of the point and of the curve, the abscissas being the same");
    same(T, X[1], at[1]);
}
#endif

#if RATIONAL
/*
In space two coordinates of the vector product have to vanish at once.  The sextic is chosen so that both contain one
factor, $t\tau+1$: its zeros are no points of the diagonal, where curvature and torsion (挠率) would notice it.

:::{claim} twisted_sextic_has_second_envelope
:title: A curve of space, its curvature and torsion nowhere 0, and a point off it that satisfies the condition
:zh: 曲率与挠率处处非零的空间曲线,曲线外有点满足包络条件
:kind: counterexample
:given: the sextic curve of space $\sum a_mt^m$, which is $(t,t^6-15t^2,3t^5+10t^3)$, as a segment over the uniform
  knots $t_i$, weights 1; $r=3$, a pair of $t$ and $\tau$
:data: t_i = -26 -22 -18 -14 -10 -6 -2 2 6 10 14 18 22 26; a = (0,0,0) (1,0,0) (0,-15,0) (0,0,10) (0,0,0) (0,0,3)
  (0,1,0); r = 3; t = 1; τ = -1
:instead: t = -1
:then: (4.3.15) is satisfied at a point that is not on the curve; the curvature and the torsion are not 0 anywhere
:result: r_i = (-12,663260,-326304) (-8,-61300,9024) (-4,20060,-1248) (0,-14260,0) (4,20060,1248) (8,-61300,-9024)
  (12,663260,326304); y'' = "30*t^4 - 30"; z'' = "60*t^3 + 60*t"; (r', r'', r''') = "-1800*t^6 - 5400*t^4 - 5400*t^2 -
  1800"; point of the member = (0,2,0); its derivatives by t and τ = (1/2,0,-3/2) (1/2,0,-3/2); point of the curve
  with its x = (0,0,0)
:method: $\mathbf r'\times\mathbf r''$ has the coordinates $x'y''-x''y'=y''$ and $x'z''-x''z'=z''$, without a common
  real zero: their greatest common divisor is decided to have none.  $(\mathbf r',\mathbf r'',\mathbf r''')$ is
  decided to have no zero on the real line.  Then the condition, then the point against that of the curve with the
  same $x$.  All such pairs are in `second_envelopes_of_spans`.
:control: $t=\tau$, the point minus that of the curve
:::
*/
CLAIM(twisted_sextic_has_second_envelope)
{
    num u[14], R[21], w[7], a[21], X[3], at[9], t = given(T, "t"), tau = given(T, "τ");
    int r = given_whole(T, "r");
    given_points(T, "t_i", 14, 1, u);
    given_points(T, "a", 7, 3, a);
    G(curve_of_powers)(6, 3, u, a, R, w);
    found_points(T, "r_i", 7, 3, R);
    poly f[3][4]; /* the three coordinates and their derivatives */
    for (int c = 0; c < 3; c++) {
        num power[7];
        for (int m = 0; m < 7; m++)
            power[m] = a[3 * m + c];
        f[c][0] = poly_from_q(7, power);
        for (int d = 1; d < 4; d++)
            f[c][d] = poly_derivative(f[c][d - 1]);
    }
    /* x' = 1 and x'' = 0: the coordinates of r' × r'' are y'', z'' and one more */
    poly torsion = poly_sub(poly_mul(f[1][2], f[2][3]), poly_mul(f[2][2], f[1][3]));
    int curved = count_roots_line(poly_gcd(f[1][2], f[2][2])).distinct == 0,
        twisted = count_roots_line(torsion).distinct == 0;
    found_text(T, "y''", poly_to_string(f[1][2], "t"));
    found_text(T, "z''", poly_to_string(f[2][2], "t"));
    found_text(T, "(r', r'', r''')", poly_to_string(torsion, "t"));
    if (!G(pair_in_the_square)(T, 6, 3, u, 6, R, w, r, tau, t, X) || !curved || !twisted)
        return;
    G(curve_derivatives)(6, 3, u, 6, R, w, X[0], 0, at); /* x(t) = t */
    found_points(T, "point of the curve with its x", 1, 3, at);
    about(T, "the point, and the point of the curve with its x");
    for (int c = 0; c < 3; c++)
        same(T, X[c], at[c]);
}
#endif

#if RATIONAL
/*
:::{claim} solution_over_the_whole_span
:title: A second envelope whose τ(t) is defined on the whole span
:zh: 在整段上有定义的另一解 τ(t)
:kind: counterexample
:given: the cubic $\sum a_mt^m$, which is $(t,t^3)$, as a segment of degree five over the uniform knots $t_i$, weights
  1; $r=3$, the solution $\tau(t)=ct$, and a $t$
:data: t_i = -11 -9 -7 -5 -3 -1 1 3 5 7 9 11; a = (0,0) (1,0) (0,0) (0,1) (0,0) (0,0); r = 3; c = -1/2; t = 4/5
:instead: c = 1
:then: (4.3.15) is satisfied with this $\tau(t)$ for all $t$ of the span; the point of the given $t$ is not on the curve
:result: r_i = (-5,-95) (-3,-9) (-1,5) (1,-5) (3,9) (5,95); the condition is satisfied at t = (-1) (-3/4) (-1/2) (-1/4) (0) (1/4) (1/2) (3/4) (1); point of the member =
  (2/25,-4/625); its derivatives by t and τ = (2/5,-12/125) (3/5,-18/125)
:method: With weights 1 a member $X$ is a polynomial in $t$ and $\tau$ of degree $5$ together, and $X_t\times X_\tau$ one in $t$ of degree eight for $\tau=ct$: it is $0$ for all $t$
  if it is at nine.  Then $y-x^3$ of one point is compared with 0.
:control: $\tau=t$
:::
*/
CLAIM(solution_over_the_whole_span)
{
    enum { PLACES = 9 };
    num u[12], R[12], w[6], X[2], D[6], c = given(T, "c"), t = given(T, "t"), places[PLACES];
    int r = given_whole(T, "r"), satisfied = 0;
    G(given_curve_of_powers)(T, 5, 2, u, R, w);
    for (int i = 0; i < PLACES; i++) {
        num place = from_ratio(i - 4, 4);
        G(family_derivatives)(5, 2, u, 5, R, w, r, mul(c, place), place, D);
        if (is_zero_q(G(cross2)(D + 2, D + 4)))
            places[satisfied++] = place;
    }
    found_points(T, "the condition is satisfied at t", satisfied, 1, places);
    if (!G(pair_in_the_square)(T, 5, 2, u, 5, R, w, r, mul(c, t), t, X) || satisfied < PLACES)
        return;
    about(T, "y and x³ of the point");
    same(T, X[1], mul(X[0], mul(X[0], X[0])));
}
#endif

#if FIELD
/*
A single pair refutes the theorem.  To see a second envelope as a curve one takes $t$ and $\tau$ as variables and
factors the condition; the drawings show what comes out.

:::{claim} second_envelopes_of_spans
:title: The other factor of the condition, and the curves that it gives
:zh: 包络条件的另一因子及所得曲线
:types: field
:given: the families $X$ of a quartic, a sextic and a cubic, each curve by the vectors of its powers over uniform knots; $r=2$ for
  the quartic, and an $r$ for the two others; any $t$ and $\tau$
:data: t_i of the quartic = -9 -7 -5 -3 -1 1 3 5 7 9; quartic = (0,0) (1,0) (0,3) (0,0) (0,2); t_i of the sextic = -26
  -22 -18 -14 -10 -6 -2 2 6 10 14 18 22 26; sextic = (0,0,0) (1,0,0) (0,-15,0) (0,0,10) (0,0,0) (0,0,3) (0,1,0); t_i
  of the cubic = -11 -9 -7 -5 -3 -1 1 3 5 7 9 11; cubic = (0,0) (1,0) (0,0) (0,1) (0,0) (0,0); α = 1/2; β = 4; γ =
  1/8; δ = 3/2; (ξ,η) = (1/10,-1/80); r = 3
:then: $X_t\times X_\tau$ is $\alpha(t-\tau)(\beta t\tau+1)$ for the quartic, and there $y=2x^2-\gamma+\gamma(\beta
  t\tau+1)^2$, so that the points where $\beta t\tau=-1$ are on a parabola; it is
  $\delta(t-\tau)(t\tau+1)(t\tau-1,t+\tau,\dots)$ for the sextic; for the cubic it is a multiple of
  $(t-\tau)(t+2\tau)$, and for $t=-2\tau$ the points are $(\xi t,\eta t^3)$
:method: Members and derivatives from the control points over the knots with $t$ and $\tau$ as variables.  For the
  sextic the third component follows: $X_t\times X_\tau$ is perpendicular to $X_t$.
:scope: the three families
:control: $t+\tau$ in the place of $t-\tau$
:::
*/
CLAIM(second_envelopes_of_spans)
{
    num t = parameter(T, "t"), tau = parameter(T, "s"), u[14], a[21], R[21], w[7], D[9], turn[3], one = from_int(1);
    num front = fault(T, sub(t, tau), add(t, tau)), product = mul(t, tau), point[2];
    int r = given_whole(T, "r");

    given_points(T, "t_i of the quartic", 10, 1, u);
    given_points(T, "quartic", 5, 2, a);
    num alpha = given(T, "α"), gamma = given(T, "γ"), other = add(mul(given(T, "β"), product), one);
    G(curve_of_powers)(4, 2, u, a, R, w);
    G(family_derivatives)(4, 2, u, 4, R, w, 2, tau, t, D);
    about(T, "the condition for the quartic");
    /* X_t × X_τ = α (t - τ)(βtτ + 1) */
    same(T, G(cross2)(D + 2, D + 4), mul(alpha, mul(front, other)));
    about(T, "the points for the quartic");
    /* y = 2x² - γ + γ (βtτ + 1)² */
    same(T, D[1], add(mul(from_int(2), mul(D[0], D[0])), mul(gamma, sub(mul(other, other), one))));

    given_points(T, "t_i of the sextic", 14, 1, u);
    given_points(T, "sextic", 7, 3, a);
    G(curve_of_powers)(6, 3, u, a, R, w);
    G(family_derivatives)(6, 3, u, 6, R, w, r, tau, t, D);
    G(cross3)(D + 3, D + 6, turn);
    num common = mul(given(T, "δ"), mul(front, add(product, one)));
    about(T, "the condition for the sextic");
    /* X_t × X_τ = δ (t - τ)(tτ + 1) (tτ - 1, t + τ, ...), its last coordinate first */
    same(T, turn[2], mul(common, sub(product, one)));
    same(T, neg(turn[1]), mul(common, add(t, tau)));

    given_points(T, "t_i of the cubic", 12, 1, u);
    given_points(T, "cubic", 6, 2, a);
    given_points(T, "(ξ,η)", 1, 2, point);
    G(curve_of_powers)(5, 2, u, a, R, w);
    G(family_derivatives)(5, 2, u, 5, R, w, r, tau, t, D);
    num quotient = div(G(cross2)(D + 2, D + 4), mul(front, add(t, mul(from_int(2), tau))));
    about(T, "the condition for the cubic");
    agree(T, is_constant_f(quotient, NULL) && !is_zero_f(quotient));
    num half = mul(from_ratio(-1, 2), t);
    about(T, "the points for the cubic");
    same(T, substitute_f(D[0], tau, half), mul(point[0], t));
    same(T, substitute_f(D[1], tau, half), mul(point[1], mul(t, mul(t, t))));
}
#endif

/*
## A condition that is enough

The polar form of the segment, with $\tau$ put in $r-1$ times and $t$ put in $k-r-2$ times, is $q(x,y)$ with two
places left.  With $a=t_j$, $b=t_{j+1}$ the three points $q(a,a)$, $q(a,b)$, $q(b,b)$ are neighbours in the control
polygon after the knots $\tau$, $t$, $a$, $b$ have been inserted often enough.  The other factor of the condition says
whether they turn.  Insertion of knots is corner cutting; so from a strictly convex polygon only strictly convex
corners arise.
*/

#if FIELD || RATIONAL
/*
:::{claim} convex_polygon_of_span_has_one_envelope
:title: The determinant of the level before is a sum of triangles of the control points, no factor of which is negative and one of which is positive
:zh: 上一层族曲线的行列式是控制顶点三角形之非负组合
:types: field rational
:given: order $k$; a span of simple knots, one whose ends are $(k-1)$-fold, one with a double knot, for $k\le4$ all patterns, with positive gaps,
  variables for $k\le4$ and numbers above; homogeneous points of the plane; $t$, $\tau$ inside the span, for
  the minors also at its left end, one of them or both; every $r=1,\dots,k-2$
:let: $a=t_j$, $b=t_{j+1}$, $P_i=(w_ir_i,w_i)$; $\alpha(x)$ the row of the $k$ discrete B-splines at $k-1$ arguments $x$; $M$ the $3\times k$ matrix of the rows
  at $(\tau^{r-1},t^{k-r-2},x,y)$ with $(x,y)=(a,a),(a,b),(b,b)$
:then: with $Q=(\mathbf p^{[r-1]},w^{[r-1]})(\cdot,\tau)$ of (4.3.17) and $m=k-r$:
  $(b-a)^3\det(Q,Q',Q'')=m^2(m-1)\sum_{i<l<h}M_{ilh}\det(P_i,P_l,P_h)$, no $3\times3$ minor $M_{ilh}$ is
  negative, and one is positive; and $\det(Q,Q',Q'')=v^3\,R'\times R''$ for the point $R$ of any $Q$ with the weight $v$
:method: The equation in the field: the left side from the level $r-1$ of de Boor's triangle and its derivatives, the
  right side is Cauchy-Binet.  The minors have no negative coefficient in the gaps and in $x$, $y$ with
  $t=(a+bx)/(1+x)$, $\tau=(a+by)/(1+y)$, or with $t=a$, $\tau=a$, and one of them is not the zero element; for $k>5$ they
  are sampled.  If the points $r_{j-k+1},\dots,r_j$ are the
  corners of a strictly convex polygon in this order, all $\det(P_i,P_l,P_h)=w_iw_lw_h(r_l-r_i)\times(r_h-r_i)$ have
  one sign, and $\det(Q,Q',Q'')\ne0$, so that $R'\times R''\ne0$.
:degrees: 2..4 sampled 5
:scope: every pattern of the knots of a span up to order 4, three above; the gaps of the knots variables up to order 4, numbers above
:where: the weights are positive and $t$, $\tau$ in one span
:over: P#: homogeneous points; y#: ratios in which the parameters divide the span; x# v#: -
:argued: every order and all knots | The polar form of every order gives the equation, $\frac{(b-a)^3}{m^2(m-1)}\det(Q,Q',Q'')$ being the determinant of its values at $(x,y)=(a,a),(a,b),(b,b)$.  The
  rows of $M$ are three neighbouring rows of the matrix that inserts $a$, $b$ and $k-3$ knots $t$, $\tau$ between them; it is a product of matrices of single insertions, with two
  nonnegative neighbours in a row, so that no minor is negative; the three values are independent, so that one is not 0.
:control: the rows $(a,a)$ and $(a,b)$ of $M$ exchanged
:::
*/
/* The sum of the minors of M, each times the triangle of its points; that none is negative and one is positive is compared. */
static num G(sum_over_minors)(trial *T, int p, int r, const num u[], num t, num tau, const num P[])
{
    int mu = p, positive_ones = 0;
    num M[3][MAX_DEGREE + 1], x[MAX_DEGREE], sum = from_int(0);
    for (int row = 0; row < 3; row++) {
        int ends = fault(T, row, row < 2 ? 1 - row : row); /* how many of the last two arguments are b */
        for (int k = 0; k < p; k++)
            x[k] = k < r - 1 ? tau : k < p - 2 ? t : u[k < p - ends ? mu : mu + 1];
        G(bspline_discrete)(p, u, mu, x, M[row]);
    }
    for (int i = 0; i <= p; i++)
        for (int l = i + 1; l <= p; l++)
            for (int h = l + 1; h <= p; h++) {
                num A[9];
                for (int row = 0; row < 3; row++) {
                    A[3 * row] = M[row][i];
                    A[3 * row + 1] = M[row][l];
                    A[3 * row + 2] = M[row][h];
                }
                num minor = G(det3)(A, A + 3, A + 6);
                about(T, "a minor of M");
                nonnegative(T, minor);
                positive_ones += !G(is_zero)(minor);
                sum = add(sum, mul(minor, G(det3)(P + 3 * i, P + 3 * l, P + 3 * h)));
            }
    about(T, "that some minor of M is not 0");
    agree(T, positive_ones > 0);
    return sum;
}

CLAIM(convex_polygon_of_span_has_one_envelope)
{
    int p = T->degree, mu = p;
    num P[3 * (MAX_DEGREE + 1)];
    for (int i = 0; i < 3 * (p + 1); i++)
        P[i] = unknown(T, "P", i);
    num any[9], R[6], v = positive(T, "v", 0); /* a homogeneous vector and its derivatives, as variables */
    for (int i = 0; i < 9; i++)
        any[i] = i == 2 ? v : P[i];
    G(rational_quotient_derivatives)(2, any, 2, R);
    about(T, "the vector product of the derivatives of the point");
    same(T, G(det3)(any, any + 3, any + 6), mul(mul(v, mul(v, v)), G(cross2)(R + 2, R + 4)));
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num u[MOST_KNOTS], inside_span[2], d[3 * (MAX_DEGREE + 1)];
        G(gaps_of_span)(T, p, shape, u);
        for (int c = 0; c < 2; c++) {
            num x = positive(T, "y", c);
            inside_span[c] = div(add(u[mu], mul(x, u[mu + 1])), add(from_int(1), x));
        }
        num t = inside_span[0], tau = inside_span[1], length = sub(u[mu + 1], u[mu]);
        for (int i = 0; i < 3 * (p + 1); i++)
            d[i] = P[i];
        for (int r = 1; r < p; r++) { /* d: the level r-1 */
            num Q[9], sum = G(sum_over_minors)(T, p, r, u, t, tau, P);
            G(sum_over_minors)(T, p, r, u, u[mu], tau, P);
            G(sum_over_minors)(T, p, r, u, t, u[mu], P);
            G(sum_over_minors)(T, p, r, u, u[mu], u[mu], P);
            int m = p - r + 1;
            G(bspline_derivatives)(G(span_alone)(m, 3, u, mu, d), t, 2, Q);
            about(T, "the determinant of Q, Q', Q''");
            num cube = mul(length, mul(length, length));
            /* (b - a)³ det(Q, Q', Q'') = m²(m-1) Σ M_ilh det(P_i, P_l, P_h) */
            same(T, mul(cube, G(det3)(Q, Q + 3, Q + 6)), mul(from_int((long)m * m * (m - 1)), sum));
            G(bspline_deboor_level)(G(on_span)(p, 3, u, mu, NULL), r, d, tau);
        }
    }
}
#endif

#include "chapters/judge/claims_off.h"
