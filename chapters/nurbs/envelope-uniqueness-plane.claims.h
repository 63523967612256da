/*
# The proof for the first level: from the triple product to the plane (r = 1 的证明: 由混合积到平面)

The proof of uniqueness for $r=1$ has replaced the condition of the envelope by one equation, a triple product.  Now
it concludes that the control points of the span are coplanar, and settles the plane case with the determinant
$x'y''-x''y'$.  Two of its steps are of one kind: an equation that was found at one pair $(t,\tau)$ is used as if it
held for all $t$ of the span.  If it does hold for all of them both conclusions are right; at one $t$ neither is.
*/
#include "chapters/nurbs/family.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch4:thm-4.3.2-independence
:title: Each term of the sum vanishes, because B-splines are linearly independent
:zh: 由线性无关性得每个混合积为零
:printed: if (4.3.12) holds, then by $w_i>0$ and the linear independence of the B-splines $(\mathbf r_i,\mathbf
  r'(t),\mathbf r''(t))=0$ for $i=j-k+1,\dots,j$, $t_j\le t<t_{j+1}$, $j=k,k+1,\dots,n$
:class: invalid-proof
:refuted-by: osculating_plane_meets_the_origin_once
:reading: osculating_plane_meets_the_origin_once | at one $t$, from (4.3.12) alone, as the sentence says
:reading: first_level_condition_factors | at one $t$ where (4.3.9) itself holds with $\tau\ne t$: there $\mathbf r'\times\mathbf r''=0$, and each
  product is 0 at this $t$, whatever the points are
:reading-with: first_level_follows_the_tangent
:reading: points_are_polar_values_of_the_segment | for all $t$ of the span, but not for this reason, the
  coefficients $(\mathbf r_i,\mathbf r'(t),\mathbf r''(t))$ not being constants | The Wronskian of the coordinates of $\mathbf r$ is 0,
  so they are linearly dependent, as for the corrected sentence; a plane through the origin that has the segment has its points.
:meant: the sentence, which begins with (4.3.12) and names its reason | The first: at one $t$, from (4.3.12).
:corrected: if (4.3.12) holds for all $t$ of the span, the three coordinates of $\mathbf r$ have the Wronskian 0 and are therefore
  linearly dependent, the segment is in a plane through the origin, and so are its control points
:corrected-by: points_are_polar_values_of_the_segment common_normal_makes_points_coplanar
:argued: | Rational functions whose Wronskian is 0 for all $t$ of a span are linearly dependent: the rows $\mathbf r,\mathbf r',\mathbf
  r''$ have a common normal $n=\mathbf r\times\mathbf r'$; $n$ and $n'=\mathbf r\times\mathbf r''$ are both normal to the first two, so
  that the direction of $n$ is constant on an interval where these are independent: there, and being rational everywhere, $\mathbf r$ is in the plane through the
  origin with this normal.  If they are dependent for all $t$, $\mathbf r$ is on a line through the origin.
:figure: points_off_the_plane
:::

That the B-splines are independent says something of sums with constant coefficients, and $(\mathbf r_i,\mathbf
r',\mathbf r'')$ changes with $t$.  The conclusion can be saved by another thought: a linear relation that holds on
the whole segment holds for its polar form, and the control points are values of the polar form.

:::{claim} points_are_polar_values_of_the_segment
:title: The points of a span are values of the polar form of its segment: a linear relation of the segment is one of
  the points
:zh: 控制顶点是该段极形式之值
:given: order $k$; a span of simple knots, one whose ends are $(k-1)$-fold, one with a double knot, for $k\le4$ all patterns, the
  distinct knots variables for $k\le5$ and numbers above; homogeneous points, the weights not 0
:then: the point $i$ is the polar form of the segment, given by its Bézier points, at $t_{i+1},\dots,t_{i+k-1}$
:method: From the points to the Bézier points of the segment by one kernel, back by another.  If $L(p(t),w(t))=0$ for
  all $t$ with a linear $L$, then the polar form of this polynomial is 0, hence $L(w_ir_i,w_i)=0$ for every point.  So
  a segment in a plane, on a line or in a plane through the origin has its points there.
:degrees: 1..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:where: no weight is 0
:argued: every order and all knots | By the recursion of de Boor the curve of the points $f[t_{i+1},\dots,t_{i+k-1}]$ is on the span the polynomial $f[t^{k-1}]$, since $f$ is affine in each
  argument; and the $N_{i,k}$ of a span are linearly independent on it, so that no other points have this segment.
:control: the knots from $t_i$ on
:::
*/
CLAIM(points_are_polar_values_of_the_segment)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], c[MAX_DEGREE + 1], b[MAX_DEGREE + 1], f;
    int place[MOST_KNOTS];
    for (int i = 0; i <= p; i++)
        c[i] = unknown(T, "c", i);
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        G(knots_of_span)(T, p, shape, u, place);
        G(bspline_to_bezier)(G(on_span)(p, 1, u, mu, c), b);
        for (int i = 0; i <= p; i++) {
            G(bspline_point_of_bezier)(p, 1, b, u[mu], u[mu + 1], fault(T, u + i + 1, u + i), &f);
            same(T, f, c[i]);
        }
    }
}

/*
:::{claim} common_normal_makes_points_coplanar
:title: Three points with one normal that is not 0 are in a plane with the origin
:zh: 有公共非零法向的三点与原点共面
:given: three points $a,b,c$ and a vector $n$ of space
:then: $(a,b,c)\,n=(n\cdot a)\,b\times c+(n\cdot b)\,c\times a+(n\cdot c)\,a\times b$
:method: Three coordinates, everything a variable.  If $n=r'\times r''\ne0$ and $n\cdot r_i=(r_i,r',r'')=0$, then all
  $r_i$ are in the plane through the origin with the normal $n$.
:over: n#: vectors
:control: $n$ on the left side with the second and third coordinates exchanged
:::
*/
CLAIM(common_normal_makes_points_coplanar)
{
    num a[3], b[3], c[3], n[3], bc[3], ca[3], ab[3];
    for (int m = 0; m < 3; m++) {
        a[m] = unknown(T, "a", m);
        b[m] = unknown(T, "b", m);
        c[m] = unknown(T, "c", m);
        n[m] = unknown(T, "n", m);
    }
    G(cross3)(b, c, bc);
    G(cross3)(c, a, ca);
    G(cross3)(a, b, ab);
    num volume = G(det3)(a, b, c), na = G(dot)(3, n, a), nb = G(dot)(3, n, b), nc = G(dot)(3, n, c);
    for (int m = 0; m < 3; m++) {
        num right = add(add(mul(na, bc[m]), mul(nb, ca[m])), mul(nc, ab[m]));
        /* (a, b, c) n = (n·a) b × c + (n·b) c × a + (n·c) a × b */
        same(T, mul(volume, n[fault(T, m, m > 0 ? 3 - m : m)]), right);
    }
}

#if RATIONAL
/*
At a single $t$ the triple product $(\mathbf p,\mathbf r',\mathbf r'')$ says that the osculating plane (密切平面) passes
through the origin.  A moving plane does so now and then, and the origin is nowhere special.

:::{claim} osculating_plane_meets_the_origin_once
:title: At one t the triple product with p vanishes, and those with the points do not
:zh: 某一 t 处 (p, r', r'')=0 而 (r_i, r', r'')≠0
:kind: counterexample
:given: the cubic curve of space $\sum a_mt^m$ as a segment over the uniform knots $t_i$, weights 1; a $t$ where its
  osculating plane contains the origin
:data: t_i = -7 -5 -3 -1 1 3 5 7; a = (1,0,0) (1,0,0) (0,1,0) (0,0,1); t = 0
:then: $\sum N_{i,k}(t)w_i(r_i,r',r'')=0$, and not every $(r_i,r',r'')$ is 0
:result: r_i = (-2,23/3,-15) (0,-1/3,3) (2,-1/3,-3) (4,23/3,15); r', r'' = (1,0,0) (0,2,0); (r_i, r', r'') = -30 6 -6
  30; the sum = 0
:method: The sum is found to be 0; then its triple products are compared with 0.
:control: the sum in the place of its terms
:::
*/
CLAIM(osculating_plane_meets_the_origin_once)
{
    num u[8], R[12], w[4], D[9], N[4], term[4], sum = from_int(0), t = given(T, "t");
    G(given_curve_of_powers)(T, 3, 3, u, R, w);
    G(curve_derivatives)(3, 3, u, 3, R, w, t, 2, D);
    G(bspline_basis)(3, u, 3, t, N);
    for (int i = 0; i < 4; i++) {
        term[i] = G(det3)(R + 3 * i, D + 3, D + 6);
        sum = add(sum, mul(N[i], term[i]));
    }
    found_points(T, "r', r''", 2, 3, D + 3);
    found_points(T, "(r_i, r', r'')", 4, 1, term);
    found(T, "the sum", sum);
    if (!is_zero_q(sum))
        return;
    about(T, "(r_i, r', r'')");
    for (int i = 0; i < 4; i++)
        vanishes(T, fault(T, sum, term[i]));
}

/*
:::{statement} wang-ch4:thm-4.3.2-coplanar
:title: The control points of the span are coplanar, and the family is plane
:zh: 控制顶点共面
:printed: $(\mathbf r_i,\mathbf r'(t),\mathbf r''(t))=0$ for $i=j-k+1,\dots,j$, $t_j\le t<t_{j+1}$, $j=k,k+1,\dots,n$, means that these
  $\mathbf r_i$ are coplanar, so that the family is one of plane curves
:holds-by: common_normal_makes_points_coplanar slope_is_constant_where_nothing_turns
  points_are_polar_values_of_the_segment member_of_span_is_polar
:needs: vanishing_curvature_says_nothing_about_the_points | the sentence, which is about the whole span | the condition holds for all
  $t$ of the span; at one $t$, which is what the alternative to $\tau=t$ is about, nothing follows if $\mathbf r'\times\mathbf
  r''=0$ there
:argued: | If $\mathbf r'\times\mathbf r''\ne0$ at one $t$, the points are in one plane through the origin.  If it is 0 for all $t$, the slopes $y'/x'$ and $z'/x'$ have the
  derivative 0 and are constant, the segment is straight, and so its points are on a line; where $x'=0$ for all $t$ another coordinate takes the place of $x$, and where
  none does the segment is a point.  A plane that has the points has the polar form of the segment, and so every member.
:figure: points_off_the_plane
:::

:::{claim} vanishing_curvature_says_nothing_about_the_points
:title: Where the curvature is 0 all triple products vanish, whatever the points are
:zh: 曲率为零处混合积恒为零,控制顶点未必共面
:kind: counterexample
:given: the quartic curve of space $\sum a_mt^m$, which is $(t,t^3,t^4)$, as a segment over the uniform knots $t_i$,
  weights 1; $t$
:data: t_i = -9 -7 -5 -3 -1 1 3 5 7 9; a = (0,0,0) (1,0,0) (0,0,0) (0,1,0) (0,0,1); t = 0
:instead: a = (0,0,0) (1,0,0) (0,0,0) (0,1,0) (0,0,0)
:then: $(r_i,r',r'')=0$ for all the points, which are not coplanar
:result: r_i = (-4,-44,105) (-2,2,-15) (0,0,9) (2,-2,-15) (4,44,105); r', r'' = (1,0,0) (0,0,0); (r_i, r', r'') = 0 0
  0 0 0
:method: The triple products are found to be 0; then the volume of four of the points is compared with 0.
:control: the curve $(t,t^3,0)$, which is plane
:::
*/
CLAIM(vanishing_curvature_says_nothing_about_the_points)
{
    num u[10], R[15], w[5], D[9], product[5], edge[9], t = given(T, "t");
    int all = 1;
    G(given_curve_of_powers)(T, 4, 3, u, R, w);
    G(curve_derivatives)(4, 3, u, 4, R, w, t, 2, D);
    for (int i = 0; i < 5; i++) {
        product[i] = G(det3)(R + 3 * i, D + 3, D + 6);
        all &= is_zero_q(product[i]);
    }
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 3; c++)
            edge[3 * i + c] = sub(R[3 * (i + 1) + c], R[c]);
    found_points(T, "r', r''", 2, 3, D + 3);
    found_points(T, "(r_i, r', r'')", 5, 1, product);
    if (!all)
        return;
    about(T, "the volume of the first four points");
    vanishes(T, G(det3)(edge, edge + 3, edge + 6));
}
#endif

/*
## The plane case

:::{statement} wang-ch4:thm-4.3.2-coordinates
:title: The plane of the family may be taken as z = 0
:zh: 可设族所在平面为 z=0
:printed: hence one may put $\mathbf r_i=(x_i,y_i,0)$, $\mathbf r(t)=(x(t),y(t),0)$, $\mathbf
  r^{[k-1]}(t,\tau)=(x^{[k-1]}(t,\tau),y^{[k-1]}(t,\tau),0)$, $i=j-k+1,j-k+2,\dots,j$; $t_j\le t,\tau<t_{j+1}$
:holds-by: family_moves_with_its_points
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:figure: nurbs_second_line

That two derivatives are parallel does not depend on the coordinates.
Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span:
`extrapolated_members_keep_positive_weights_inside`.
:::

To turn the plane of the points into $z=0$ one has to know that the construction does not depend on coordinates.  The
recursion forms means of points, with factors that do not depend on the points; so members follow every affine map,
and their derivatives its linear part.

:::{claim} family_moves_with_its_points
:title: Under an affine map of the points the members are mapped, and their derivatives by its linear part
:zh: 顶点经仿射变换,族曲线随之变换
:given: order $k$; simple knots, or the ends of the span $(k-1)$-fold, or its left end double, for $k\le4$ all patterns; weights
  and points, any $t$
  and $\tau$, $r=0,\dots,k-2$, which for $r=0$ is the curve itself; a function $\ell(x,y)=ax+by+c$
:where: the weights of the curve, the levels and the member are not 0
:then: with $\ell(\mathbf r_i)$ for the points the member is $\ell(\mathbf r^{[k-r]}(t,\tau))$, and its derivatives by
  $t$ and by $\tau$ are those of $\mathbf r^{[k-r]}$ under $ax+by$
:method: Both families by the recursion.  $\ell$ is any coordinate of an affine map; a third coordinate enters as the
  second does.  A linear map that can be inverted keeps parallel vectors parallel, and makes none so.
:degrees: 2..4 sampled 6
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 4, numbers above
:argued: every order and all knots | A member is a mean of the points with factors that add up to 1 and in which the points are not.  So it goes with them under $\ell$, and its derivatives, whose
  factors add up to 0, under the linear part.
:over: l#: affine functions
:control: $c$ left out at the last point
:::
*/
CLAIM(family_moves_with_its_points)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], R[2 * (MAX_DEGREE + 1)], w[MAX_DEGREE + 1], L[MAX_DEGREE + 1], l[3];
    num t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 2, R, w);
    for (int c = 0; c < 3; c++)
        l[c] = unknown(T, "l", c);
    for (int i = 0; i <= p; i++) {
        L[i] = add(mul(l[0], R[2 * i]), mul(l[1], R[2 * i + 1]));
        L[i] = fault(T, add(L[i], l[2]), i == p ? L[i] : add(L[i], l[2]));
    }
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        G(knots_of_span)(T, p, shape, u, place);
        G(numbers_above)(3, p, 2 * p + 2, place, u);
        for (int r = 0; r <= p - 1; r++) {
            num D[6], E[3];
            G(family_derivatives)(p, 2, u, mu, R, w, r, tau, t, D);
            G(family_derivatives)(p, 1, u, mu, L, w, r, tau, t, E);
            for (int d = 0; d < 3; d++) {
                static const char *const what[] = {"the point", "the derivative by t", "the derivative by τ"};
                num value = add(mul(l[0], D[2 * d]), mul(l[1], D[2 * d + 1]));
                about(T, what[d]);
                /* the member of the l(r_i) is l of the member, l(x,y) = a x + b y + c; its derivatives are those under a x + b y */
                same(T, E[d], d == 0 ? add(value, l[2]) : value);
            }
        }
    }
}

/*
:::{statement} wang-ch4:formula-4.3.13
:title: In the plane the envelope is the joint solution of (4.3.3) and (4.3.13)
:zh: 平面情形包络为 (4.3.3) 与 (4.3.13) 的联合解
:printed: by [18] the envelope of this family is the joint solution of the equation (4.3.3), $r=1$, of plane curves and
  $\frac{\partial x^{[k-1]}(t,\tau)}{\partial\tau}\cdot\frac{\partial y^{[k-1]}(t,\tau)}{\partial
  t}=\frac{\partial x^{[k-1]}(t,\tau)}{\partial t}\cdot\frac{\partial y^{[k-1]}(t,\tau)}{\partial\tau}$, $t_j\le
  t,\tau<t_{j+1}$, where $\tau=\tau(t)$
:holds-by: touching_curve_satisfies_the_condition
:confirmed-by: first_level_condition_factors
:hypothesis: member_at_a_fold_is_one_point | $\partial_t\mathbf r^{[k-1]}\ne0$; where it is 0 the member may be one point, which has no tangent
:hypothesis: opposite_parameters_have_one_point | $\mathbf r^{[k-1]}$ is not constant on the solution; where it is, the solution is no curve
:hypothesis: folded_line_has_another_solution | $\tau$ is not constant on the solution; as for (4.3.9)
:meant: the same notion as in (4.3.9) | A curve that passes from member to member and is tangent to each; for $\tau=\tau(t)$ see (4.3.10).
:figure: nurbs_second_line

(4.3.13) is the third coordinate of (4.3.9), the two others being 0.  In the examples, which are straight segments, $\tau$ is a function of $t$; if the segment is not straight,
$\tau=t$ is the only continuous one, see `thm-4.3.2-otherwise`.  The lines $t=t_0$, on which $\tau$ is no function of $t$, see (4.3.10), are then left out.
:::

:::{statement} wang-ch4:thm-4.3.2-plane-condition
:title: In the plane the condition is (τ-t)(x'y''-x''y') = 0
:zh: 平面情形的等价条件
:printed: (4.3.13) is equivalent to $(\tau-t)[x'(t)y''(t)-x''(t)y'(t)]=0$
:holds-by: first_level_condition_factors first_level_follows_the_tangent
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:figure: nurbs_second_line

The factor between them is $w^3/((k-1)^2W^3)$, which is not 0.
Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span:
`extrapolated_members_keep_positive_weights_inside`.
:::

:::{statement} wang-ch4:formula-4.3.14
:title: If x'y''-x''y' = 0 the segment is straight
:zh: x'y''-x''y'=0 则为直线段
:printed: if $x'(t)y''(t)-x''(t)y'(t)=0$ (4.3.14) holds, then $\mathbf r(t)$ is a segment of a straight line
:class: invalid-proof
:refuted-by: inflected_cubic_is_not_straight
:meant: the proof, in which (4.3.14) is what is left of the alternative to $\tau=t$ | The first: at one $t$.
:reading: inflected_cubic_is_not_straight | at one $t$, which is all that the alternative gives
:reading: slope_is_constant_where_nothing_turns | for all $t$ | A quotient whose derivative is 0 on an interval is constant there; where $x'$ is 0 for all $t$, $x$ is constant.
:corrected: if (4.3.14) holds for all $t$ of the span, $\mathbf r$ is on a straight line
:corrected-by: slope_is_constant_where_nothing_turns
:argued: | A quotient whose derivative is 0 on an interval is constant there: so on an interval without zeros of $x'$ the slope $y'/x'$ is, and $y=ax+b$ there; both being rational, so
  it is on the whole span.  Where $x'$ is 0 for all $t$, $x$ is constant.
:figure: nurbs_second_line
:::
*/

#if FIELD
/*
:::{claim} slope_is_constant_where_nothing_turns
:title: The derivative of the slope is x'y''-x''y' over x'^2
:zh: 斜率之导数
:types: field
:given: any $x$ and $y$ with their first and second derivatives, $x'\ne0$, here cubic polynomials of $t$ with variable
  coefficients
:harmless: $x'\ne0$ | what is said where $x'$ is 0 is said apart
:then: $(y'/x')'=(x'y''-x''y')/x'^2$
:method: Formal derivatives.  Both sides depend on $x',x'',y',y''$ at $t$ only, which are any numbers for cubics, so the rule holds for all functions; if the right side is 0 for all $t$ of the span,
  $y'/x'$ is constant and $y=ax+b$, or $x'=0$ for all $t$ and $x$ is constant: a line.
:degrees: all
:over: a# b#: coefficients
:control: the sign of the second term
:::
*/
CLAIM(slope_is_constant_where_nothing_turns)
{
    num t = parameter(T, "t"), f[2], f1[2], f2[2];
    for (int c = 0; c < 2; c++) {
        f[c] = from_int(0);
        for (int m = 3; m >= 0; m--)
            f[c] = add(mul(t, f[c]), unknown(T, c == 0 ? "a" : "b", m));
        f1[c] = derivative_f(f[c], t);
        f2[c] = derivative_f(f1[c], t);
    }
    num a = mul(f1[0], f2[1]), b = mul(f2[0], f1[1]);
    /* (y'/x')' = (x' y'' - x'' y')/x'² */
    same(T, derivative_f(div(f1[1], f1[0]), t), div(fault(T, sub(a, b), add(a, b)), mul(f1[0], f1[0])));
}
#endif

#if RATIONAL
/*
In the plane the condition is a product of two factors, which is true and is the whole answer.  The proof reads the
second factor as an equation for all $t$ and concludes that the segment is straight.  The simplest inflection of all,
that of $(t,t^3)$ at 0, is a counterexample.

:::{claim} inflected_cubic_is_not_straight
:title: At the inflection of (t, t³) the determinant vanishes; the curve is not straight
:zh: 拐点处行列式为零而曲线非直线
:kind: counterexample
:given: the cubic $\sum a_mt^m$, which is $(t,t^3)$, as a segment over the uniform knots $t_i$, weights 1; its
  inflection $t$
:data: t_i = -7 -5 -3 -1 1 3 5 7; a = (0,0) (1,0) (0,0) (0,1); t = 0
:instead: a = (0,0) (1,1) (0,0) (0,0)
:then: $x'y''-x''y'=0$, and three of the points are not collinear
:result: r_i = (-3,-15) (-1,3) (1,-3) (3,15); r', r'' = (1,0) (0,0); x'y'' - x''y' = 0
:method: The determinant is found to be 0; then the area of the first three points is compared with 0.  The points of
  a straight segment are collinear.
:control: the curve $(t,t)$
:::
*/
CLAIM(inflected_cubic_is_not_straight)
{
    num u[8], R[8], w[4], D[6], a[2], b[2], t = given(T, "t");
    G(given_curve_of_powers)(T, 3, 2, u, R, w);
    G(curve_derivatives)(3, 2, u, 3, R, w, t, 2, D);
    num turn = G(cross2)(D + 2, D + 4);
    found_points(T, "r', r''", 2, 2, D + 2);
    found(T, "x'y'' - x''y'", turn);
    if (!is_zero_q(turn))
        return;
    for (int c = 0; c < 2; c++) {
        a[c] = sub(R[2 + c], R[c]);
        b[c] = sub(R[4 + c], R[c]);
    }
    about(T, "the determinant of the first two edges");
    vanishes(T, G(cross2)(a, b));
}

/*
:::{statement} wang-ch4:thm-4.3.2-collinear
:title: A straight segment has collinear control points
:zh: 直线段的控制顶点共线
:printed: that $\mathbf r(t)$ is a straight segment implies that $\mathbf r_i$, $i=j-k+1,\dots,j$, are collinear, so
  that every member is on this line
:holds-by: points_are_polar_values_of_the_segment member_of_span_is_polar
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:figure: nurbs_folded_line

Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span:
`extrapolated_members_keep_positive_weights_inside`.
:::

:::{statement} wang-ch4:thm-4.3.2-on-a-line
:title: If all members are on a line, their envelope is the segment
:zh: 族曲线均在一直线上时包络即 r(t)
:printed: every member of the family being on the straight line of $\mathbf r(t)$, its envelope is $\mathbf r(t)$
:class: false
:refuted-by: straight_segment_is_overshot folded_line_has_another_solution
:corrected: then every pair $(t,\tau)$ is a joint solution
:corrected-by: first_level_condition_factors first_level_follows_the_tangent
:figure: nurbs_folded_line

Members may have points that $\mathbf r$ has not: in both examples there is one.  In the first $\mathbf r'\ne0$ on the closed span, and $\mathbf r$ runs
through its segment once; the pair is on the line $t=0$, on which $\tau$ varies and the point moves, so that no hypothesis of `formula-4.3.9` is violated.  As
every pair is a solution, this one belongs to every function $\tau(t)$ with this value at $t=0$, too, whether constant or not.  The second is a constant $\tau(t)$, one member: a joint solution, too, but no curve
that passes from member to member.
:::

Even the straight segment is not as harmless as it looks.  If all members are on a line, every pair satisfies the
condition, and the members may reach farther than the segment itself.  A member of level 1 goes from $\mathbf r(t)$ a part of the way along the
tangent, as far as the speed at $t$ says; if the curve is fast at $t$ and slow behind, this is too far.

:::{claim} straight_segment_is_overshot
:title: A member of a straight segment that is run through once reaches beyond its end
:zh: 单向走过的直线段,其族曲线仍可伸出端点之外
:kind: counterexample
:given: the cubic $\sum a_mt^m$ on a line as a segment over the uniform knots $t_i$, weights 1; $r=1$, the start $t$ of the span, and the member $\tau$
:data: t_i = -3 -2 -1 0 1 2 3 4; a = (0,0) (1,1) (-3/2,-3/2) (4/5,4/5); t = 0; τ = 19/20
:instead: τ = 0
:then: $\mathbf r'\ne0$ on the closed span; (4.3.9) is satisfied, and no parameter of the closed span has $\mathbf r$ at the point of the member
:result: r_i = (-2,-2) (1/2,1/2) (0,0) (13/10,13/10); point of the member = (19/60,19/60); its derivatives by t and τ = (-17/60,-17/60) (1/3,1/3);
  ends of the segment = (0,0) (3/10,3/10); zeros of r' = 0; parameters with this point = 0
:method: The condition is found to be satisfied; then the roots in the closed span of $x'(t)$ and of $x(t)$ minus the abscissa of the point are counted.
:control: $\tau=t$
:::
*/
CLAIM(straight_segment_is_overshot)
{
    num u[8], R[8], b[8], x[4], w[4], X[2], ends[4], t = given(T, "t"), tau = given(T, "τ"), zero = from_int(0),
                                                     one = from_int(1);
    G(given_curve_of_powers)(T, 3, 2, u, R, w);
    if (!G(pair_in_the_square)(T, 3, 2, u, 3, R, w, 1, tau, t, X))
        return;
    G(bspline_to_bezier)(G(on_span)(3, 2, u, 3, R), b);
    for (int i = 0; i < 4; i++) {
        x[i] = sub(b[2 * i], X[0]);
        ends[i] = b[i < 2 ? i : i + 4];
    }
    poly f = poly_from_bernstein(3, x);
    int still = count_roots(poly_derivative(f), zero, one, CLOSED).distinct;
    int places = count_roots(f, zero, one, CLOSED).distinct;
    found_points(T, "ends of the segment", 2, 2, ends);
    found_whole(T, "zeros of r'", still);
    found_whole(T, "parameters with this point", places);
    about(T, "the point of the member is on the segment, which is run through once");
    refute(T, still == 0 && places == 0);
}

/*
Where the segment does not run through its line in one direction this is easily drawn.

:::{claim} folded_line_has_another_solution
:title: On a line every function τ(t) is a solution, and its points may be off the segment
:zh: 共线时任意 τ(t) 均为解,其点可在 r(t) 之外
:kind: counterexample
:given: a quadratic segment over the simple knots $t_i$, its points $r_i$ on a line and the first the same as the
  last, weights 1; $r=1$, the constant function $\tau(t)=\tau$, and a $t$
:data: t_i = 0 1 2 3 4 5; r_i = (0,0) (1,1) (0,0); τ = 2; t = 11/4
:instead: τ = 11/4
:then: (4.3.9) is satisfied, and no parameter of the closed span has $\mathbf r$ at the point of the member; the segment
  runs from its end to its middle point and back
:result: point of the member = (7/8,7/8); its derivatives by t and τ = (1/2,1/2) (-1/4,-1/4); end and middle of the
  segment = (1/2,1/2) (3/4,3/4); parameters with this point = 0
:method: The condition is found to be satisfied; then the roots in the closed span of $x(t)$ minus the abscissa of the
  point are counted.
:control: $\tau=t$
:::
*/
CLAIM(folded_line_has_another_solution)
{
    num u[6], R[6], b[6], x[3], w[3] = {from_int(1), from_int(1), from_int(1)}, X[2], ends[4];
    given_points(T, "t_i", 6, 1, u);
    given_points(T, "r_i", 3, 2, R);
    num tau = given(T, "τ"), t = given(T, "t");
    if (!G(pair_in_the_square)(T, 2, 2, u, 2, R, w, 1, tau, t, X))
        return;
    G(bspline_to_bezier)(G(on_span)(2, 2, u, 2, R), b);
    for (int i = 0; i < 3; i++)
        x[i] = sub(b[2 * i], X[0]);
    int places = count_roots(poly_from_bernstein(2, x), from_int(0), from_int(1), CLOSED).distinct;
    for (int m = 0; m < 2; m++) /* at t_j and half way to t_{j+1} */
        G(bspline_deboor)(G(on_span)(2, 2, u, 2, R), add(u[2], mul(from_ratio(m, 2), sub(u[3], u[2]))), ends + 2 * m);
    found_points(T, "end and middle of the segment", 2, 2, ends);
    found_whole(T, "parameters with this point", places);
    about(T, "the point is on the segment");
    agree(T, places > 0);
}

/*
On straight segments there are functions $\tau(t)$ that are no envelopes, constant or not: one passes a member that is a point, another has one point only.

:::{claim} member_at_a_fold_is_one_point
:title: Where a straight segment turns back, the member of this parameter may be one point
:zh: 直线段折返处的族曲线可退化为一点
:kind: counterexample
:given: a quadratic segment over the simple knots $t_i$, its points $r_i$ on a line and the first the same as the last, weights 1; $r=1$, the function
  $\tau(t)=t$ at the $t$ where the segment turns back, and another parameter $t^*$ of the member
:data: t_i = 0 1 2 3 4 5; r_i = (0,0) (1,1) (0,0); τ = 5/2; t = 5/2; t* = 9/4
:instead: τ = 9/4; t = 9/4; t* = 5/2
:then: (4.3.13) is satisfied, and $\partial_t\mathbf r^{[k-1]}=0$ on the whole member, which is one point
:result: point of the member = (3/4,3/4); its derivatives by t and τ = (0,0) (0,0); point at t* = (3/4,3/4)
:method: The member is of degree 1 in $t$: it is one point if it has the same point at two $t$.
:control: another $t$, with $\tau=t$
:::
*/
CLAIM(member_at_a_fold_is_one_point)
{
    num u[6], R[6], w[3] = {from_int(1), from_int(1), from_int(1)}, X[2], D[6];
    given_points(T, "t_i", 6, 1, u);
    given_points(T, "r_i", 3, 2, R);
    num tau = given(T, "τ"), t = given(T, "t"), there = given(T, "t*");
    int satisfied = G(pair_in_the_square)(T, 2, 2, u, 2, R, w, 1, tau, t, X);
    G(family_derivatives)(2, 2, u, 2, R, w, 1, tau, there, D);
    found_points(T, "point at t*", 1, 2, D);
    about(T, "the two points of the member differ");
    refute(T, satisfied && !equal_q(t, there) && equal_q(X[0], D[0]) && equal_q(X[1], D[1]));
}

/*
:::{claim} opposite_parameters_have_one_point
:title: On a straight segment the points of a solution may all be the same
:zh: 直线段上一个解 τ(t) 可只给出一点
:kind: counterexample
:given: the segment $(t,t)$ as one of degree 2 over the simple knots $t_i$, weights 1; $r=1$, three $t$ and for each its $\tau(t)=t_j+t_{j+1}-t$
:data: t_i = 0 1 2 3 4 5; r_i = (3/2,3/2) (5/2,5/2) (7/2,7/2); t = 9/4 5/2 11/4; τ = 11/4 5/2 9/4
:instead: τ = 9/4 5/2 11/4
:then: (4.3.13) is satisfied with $\partial_t\mathbf r^{[k-1]}\ne0$; with this $\tau(t)$, which is not constant, the point is the same for every $t$
:result: points = (5/2,5/2) (5/2,5/2) (5/2,5/2); derivatives by t = (1/2,1/2) (1/2,1/2) (1/2,1/2)
:method: The member is of degree 1 in $t$ and in $\tau$, so that its point is of degree 2 in $t$ for this $\tau(t)$: it is the same for every $t$ if it is for three.
:control: $\tau=t$
:::
*/
CLAIM(opposite_parameters_have_one_point)
{
    enum { PLACES = 3 };
    num u[6], R[6], w[3] = {from_int(1), from_int(1), from_int(1)}, t[PLACES], tau[PLACES], D[6];
    num point[2 * PLACES], by_t[2 * PLACES];
    int satisfied = 1, one_point = 1;
    given_points(T, "t_i", 6, 1, u);
    given_points(T, "r_i", 3, 2, R);
    given_points(T, "t", PLACES, 1, t);
    given_points(T, "τ", PLACES, 1, tau);
    for (int m = 0; m < PLACES; m++) {
        G(family_derivatives)(2, 2, u, 2, R, w, 1, tau[m], t[m], D);
        satisfied &= G(is_pair_of_span)(u, 2, t[m], tau[m]) && is_zero_q(G(cross2)(D + 2, D + 4));
        for (int c = 0; c < 2; c++) {
            point[2 * m + c] = D[c];
            by_t[2 * m + c] = D[2 + c];
            one_point &= equal_q(point[2 * m + c], point[c]);
        }
        satisfied &= !is_zero_q(D[2]) && !is_zero_q(D[3]);
    }
    found_points(T, "points", PLACES, 2, point);
    found_points(T, "derivatives by t", PLACES, 2, by_t);
    about(T, "the points differ");
    refute(T, satisfied && one_point);
}

/*
:::{statement} wang-ch4:thm-4.3.2-otherwise
:title: If (4.3.14) does not hold, τ = t
:zh: 否则必有 τ=t
:printed: if (4.3.14) does not hold, (4.3.11) must hold, and put into (4.3.3), $r=1$, it shows that the envelope of the family is $\mathbf r(t)$
:holds-by: first_level_condition_factors first_level_follows_the_tangent member_of_span_touches_curve
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:hypothesis: inflected_cubic_has_second_envelope | (4.3.14) holds for no $t$ of the span; that it does not hold
  identically is not enough
:meant: (4.3.3) and (4.3.9), by which the section determines the envelope | All joint solutions, as in theorem 4.3.2.
:reading: inflected_cubic_has_second_envelope | all joint solutions, if (4.3.14) does not hold identically
:reading: first_level_condition_factors | at one $t$: where (4.3.14) does not hold for it, $\tau=t$ is the only solution with this $t$, and its point is that of the curve
:reading-with: first_level_follows_the_tangent member_of_span_touches_curve
:reading: first_level_condition_factors | only solutions of the form $\tau=\tau(t)$ with a continuous function, as (4.3.10) may be meant: then
  it is enough that (4.3.14) does not hold identically | Away from the isolated zeros of $\mathbf r'\times\mathbf r''$ the condition leaves
  $\tau=t$ only, and a continuous function has the same value at them.
:reading-with: first_level_follows_the_tangent
:figure: nurbs_envelope_extra

Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span:
`extrapolated_members_keep_positive_weights_inside`.
:::

So the theorem fails at every inflection, and it fails visibly: the members of the cubic $(t,t^3)$ are parabolas, and
each of them touches the axis in a point of its own.  The last claim is the same in space, where one may have hoped
for more room.

:::{claim} inflected_cubic_has_second_envelope
:title: The parabolas of the cubic (t, t³) touch the axis y = 0 as well
:zh: 三次曲线 (t,t³) 的二次族曲线还与 y=0 相切
:kind: counterexample
:given: the cubic $\sum a_mt^m$, which is $(t,t^3)$, as a segment over the uniform knots $t_i$, weights 1; $r=1$, the member $\tau$ at the inflection
  $t$
:data: t_i = -7 -5 -3 -1 1 3 5 7; a = (0,0) (1,0) (0,0) (0,1); t = 0; τ = 1/2
:instead: τ = 0
:then: (4.3.9) is satisfied at a point which is not on the curve; the member's tangent there is the axis $y=0$
:result: r_i = (-3,-15) (-1,3) (1,-3) (3,15); point of the member = (1/6,0); its derivatives by t and τ = (2/3,0)
  (1/3,0)
:method: Member and derivatives by its points over the knots.  The condition is found to be satisfied; then $y-x^3$ is
  compared with 0.  With the same $t$ every $\tau$ gives a pair: `first_level_condition_factors`.
:control: $\tau=t$
:::
*/
CLAIM(inflected_cubic_has_second_envelope)
{
    num u[8], R[8], w[4], X[2], t = given(T, "t"), tau = given(T, "τ");
    G(given_curve_of_powers)(T, 3, 2, u, R, w);
    if (!G(pair_in_the_square)(T, 3, 2, u, 3, R, w, 1, tau, t, X))
        return;
    about(T, "y - x³ at the point, and on the curve");
    vanishes(T, sub(X[1], mul(X[0], mul(X[0], X[0]))));
}

/*
:::{claim} space_quartic_has_second_envelope
:title: A curve of space, not in a plane, whose family of order 4 touches a line as well
:zh: 非平面曲线的族另有包络
:kind: counterexample
:given: the quartic curve of space $\sum a_mt^m$, which is $(t,t^3,t^4)$, as a segment over the uniform knots $t_i$, weights 1; $r=1$, the member
  $\tau$ at the $t$ where the curvature is 0
:data: t_i = -9 -7 -5 -3 -1 1 3 5 7 9; a = (0,0,0) (1,0,0) (0,0,0) (0,1,0) (0,0,1); t = 0; τ = 1/2
:instead: τ = 0
:then: (4.3.9) is satisfied at a point which is not on the curve
:result: r_i = (-4,-44,105) (-2,2,-15) (0,0,9) (2,-2,-15) (4,44,105); point of the member = (1/8,0,0); its derivatives
  by t and τ = (3/4,0,0) (1/4,0,0); six times the volume of the first four points = 4608
:method: Member and derivatives by its points over the knots; the condition is found to be satisfied, and $y-x^3$ is compared with 0.  The volume says that the first four points, and so the curve, are in no plane.
:control: $\tau=t$
:::
*/
CLAIM(space_quartic_has_second_envelope)
{
    num u[10], R[15], w[5], X[3], edge[9], t = given(T, "t"), tau = given(T, "τ");
    G(given_curve_of_powers)(T, 4, 3, u, R, w);
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 3; c++)
            edge[3 * i + c] = sub(R[3 * (i + 1) + c], R[c]);
    num volume = G(det3)(edge, edge + 3, edge + 6);
    found(T, "six times the volume of the first four points", volume);
    if (!G(pair_in_the_square)(T, 4, 3, u, 4, R, w, 1, tau, t, X) || is_zero_q(volume))
        return;
    about(T, "y - x³ at the point, and on the curve");
    vanishes(T, sub(X[1], mul(X[0], mul(X[0], X[0]))));
}
#endif

#include "chapters/judge/claims_off.h"
