/*
# Special cases and the order of contact (特殊情形与切触阶)

Three special cases of the theorem on the envelope are read off from the recursion: equal weights, a span between
$(k-1)$-fold knots, and the level $k-2$, where the members are straight.  Then a question that the source does not ask
here, though its chapter on Bézier curves does: how closely a member touches the curve.
*/
#include "chapters/nurbs/family.h"

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

/*
## Special cases

:::{statement} wang-ch4:cor-4.3.1-polynomial
:title: With equal weights the family is that of the B-spline curve
:zh: 权相等时即 B 样条曲线的包络定理
:printed: when the $w_i$ are constant, theorem 2.2.2 results
:holds-by: equal_weights_give_the_polynomial_family member_of_span_touches_curve envelope_condition_holds_on_the_diagonal
:hypothesis: span_member_shrinks_at_a_cusp | $\mathbf r'\ne0$; as for theorem 4.3.1
:meant: the number of theorem 2.2.2, which is not at hand: it belongs to the chapter on B-spline curves | The same theorem for B-spline curves: the curve is the envelope of the family
  that de Boor's algorithm without weights gives.
:figure: nurbs_envelope_contact

All weights of the levels and of the members are then the common weight, which is positive by definition 4.1.1.
:::

:::{claim} equal_weights_give_the_polynomial_family
:title: With equal weights all levels have these weights, and their points are those of de Boor's algorithm
:zh: 权相等时各层权不变
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, for $k\le4$ all
  patterns; one weight $w_1$
  for all points; any $\tau$, $r=1,\dots,k-1$
:then: $w_i^{[r]}(\tau)=w_1$, and $r_i^{[r]}(\tau)$ is the point of level $r$ of de Boor's triangle without weights
:method: The rational recursion against the kernel of de Boor's levels, one coordinate.
:degrees: 1..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:over: w#: equal weights
:argued: every order and all knots | The two factors of (4.1.3) add up to 1; with equal weights those of (4.1.4) are the same.
:control: the first weight different
:::
*/
CLAIM(equal_weights_give_the_polynomial_family)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], tau = parameter(T, "s"), all = positive(T, "w", 1);
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    for (int i = 0; i <= p; i++)
        w[i] = fault(T, all, i == 0 ? add(all, from_int(1)) : all);
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num d[MAX_DEGREE + 1], Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1];
        G(knots_of_span)(T, p, shape, u, place);
        for (int i = 0; i <= p; i++)
            d[i] = R[i];
        for (int r = 1; r <= p; r++) {
            G(bspline_deboor_level)(G(on_span)(p, 1, u, mu, NULL), r, d, tau);
            G(level_of_curve)(p, 1, u, mu, R, w, r, tau, Rr, wr);
            for (int m = 0; m <= p - r; m++) {
                same(T, wr[m], all);
                same(T, Rr[m], d[m]);
            }
        }
    }
}

/*
:::{statement} wang-ch4:cor-4.3.1-bezier
:title: Between (k-1)-fold knots the theorem on rational Bézier curves results
:zh: 两端均为 k-1 重节点时得出有理 Bézier 曲线的包络定理
:printed: or when $t_j$ and $t_{j+1}$ are both $(k-1)$-fold knots, theorem 3.3.2 results
:holds-by: bezier_span_gives_the_bezier_family member_of_span_touches_curve envelope_condition_holds_on_the_diagonal
:hypothesis: member_between_multiple_knots_shrinks_at_a_cusp | $\mathbf r'\ne0$; as for theorem 4.3.1
:meant: its being a corollary of theorem 4.3.1, which says that the curve is the envelope of a family, and nothing about the order of contact | What theorem 3.3.2
  says of the envelope, (3.3.4): the first and the second reading.
:reading: bezier_span_gives_the_bezier_family | the family is that of theorem 3.3.2
:reading: member_of_span_touches_curve | the envelope is that of theorem 3.3.2, a curve that every member touches wherever $\mathbf r'\ne0$
:reading: cubic_member_has_other_curvature | the whole of theorem 3.3.2 by its letter, with contact of order $n-r$, $n=k-1$: it is not there
:needs: member_may_lose_a_point | definition 4.1.1: $w_i>0$ | the weights are positive: otherwise a weight of a level may vanish
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:figure: bezier_knots

Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span: `extrapolated_members_keep_positive_weights_inside`.
:::

Between two $(k-1)$-fold knots all knots that a span can see are its ends, and the recursion is that of de Casteljau.
So (3.3.4) of the chapter on Bézier curves is a special case; the contact of order $n-r$ that theorem 3.3.2 claims besides
does not exist, here as there.

:::{claim} bezier_span_gives_the_bezier_family
:title: Between (k-1)-fold knots level r is level r of the rational de Casteljau triangle, and the basis is Bernstein's
:zh: k-1 重节点之间的族即有理 Bézier 曲线族
:given: order $k$; a span whose ends are $(k-1)$-fold knots; weights and points, any $t$ and $\tau$, $r=0,\dots,k-1$
:then: with $\lambda=\frac{\tau-t_j}{t_{j+1}-t_j}$: $w_i^{[r]}$ and $r_i^{[r]}$ are the weights and points of level
  $r$ of the rational de Casteljau triangle at $\lambda$, and
  $N_{i,k-r}(t)=B_{i-j+k-r-1}^{k-r-1}\bigl(\frac{t-t_j}{t_{j+1}-t_j}\bigr)$
:method: Kernel against kernel: the recursion over knots, and the recursion and the basis of chapter 3, which know
  nothing of knots.
:degrees: 1..6 sampled 7
:scope: (k-1)-fold ends of the span; the distinct knots variables up to order 5, numbers above
:where: the weights of the levels are not 0
:argued: every order and all knots | Every index $i$ of a level has $t_i=t_j$ and $t_{i+k-r}=t_{j+1}$, so that the factors of (4.1.3) are $\lambda$ and $1-\lambda$, and those of the recursion
  of the $N_{i,k-r}$ are those of the Bernstein polynomials.
:control: $1-\lambda$ in the place of $\lambda$
:::
*/
CLAIM(bezier_span_gives_the_bezier_family)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    G(knots_of_span)(T, p, 1, u, place);
    num length = sub(u[mu + 1], u[mu]), lambda = div(sub(tau, u[mu]), length), local = div(sub(t, u[mu]), length);
    lambda = fault(T, lambda, sub(from_int(1), lambda));
    for (int r = 0; r <= p; r++) {
        num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], Br[MAX_DEGREE + 1], br[MAX_DEGREE + 1];
        num N[MAX_DEGREE + 1], B[MAX_DEGREE + 1];
        G(level_of_curve)(p, 1, u, mu, R, w, r, tau, Rr, wr);
        G(rational_casteljau)(p, 1, R, w, lambda, r, Br, br);
        G(bspline_basis)(p - r, u, mu, t, N);
        G(bernstein_basis)(p - r, local, B);
        for (int m = 0; m <= p - r; m++) {
            about(T, "points and weights of level r");
            same(T, Rr[m], Br[m]);
            same(T, wr[m], br[m]);
            about(T, "the basis of order k-r");
            same(T, N[m], B[m]);
        }
    }
}

#if RATIONAL
/*
:::{claim} member_between_multiple_knots_shrinks_at_a_cusp
:title: Between (k-1)-fold knots, too, the line of the family may be a point at a cusp
:zh: k-1 重节点之间尖点处的族直线亦退化为点
:kind: counterexample
:given: the cubic $\sum a_mt^m$, which is $(t^2,t^3)$, as a segment between two $(k-1)$-fold knots of the knots $t_i$, weights 1; $r=2$, $\tau$
:data: t_i = -3 -1 -1 -1 1 1 1 3; a = (0,0) (0,0) (1,0) (0,1); τ = 0
:instead: τ = 1/2
:then: the member, a line by rights, is a point: it has no tangent that could be common
:result: r_i = (1,-1) (-1/3,1) (-1/3,-1) (1,1); the two points of the member = (0,0) (0,0)
:method: The two points of the level are computed exactly; that they differ is what is compared.
:control: a parameter where the curve has no cusp
:::
*/
CLAIM(member_between_multiple_knots_shrinks_at_a_cusp) { G(line_shrinks_to_a_point)(T); }
#endif

/*
:::{statement} wang-ch4:formula-4.3.8
:title: The lines of the family of order 2
:zh: 直线族的方程
:printed: \mathbf r^{[2]}(t,\tau)=\frac{(t_{j+1}-t)w_{j-1}^{[k-2]}(\tau)\mathbf
  r_{j-1}^{[k-2]}(\tau)+(t-t_j)w_j^{[k-2]}(\tau)\mathbf
  r_j^{[k-2]}(\tau)}{(t_{j+1}-t)w_{j-1}^{[k-2]}(\tau)+(t-t_j)w_j^{[k-2]}(\tau)},\quad t_j\le t,\tau<t_{j+1}
:holds-by: lines_of_the_family_by_two_points
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:needs: weight_of_a_level_may_vanish | definition 4.1.1: $w_i>0$ | the weights are positive: otherwise a weight of a level may vanish
:figure: nurbs_envelope_families

Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span: `extrapolated_members_keep_positive_weights_inside`.
:::

:::{statement} wang-ch4:cor-4.3.1-lines
:title: For k-r = 2 the curve is an envelope of straight lines
:zh: k-r=2 时曲线是直线族的包络
:printed: for $k-r=2$ one learns that $\mathbf r(t)$ is the envelope of the family of straight lines (4.3.8)
:holds-by: member_of_span_touches_curve envelope_condition_holds_on_the_diagonal lines_of_the_family_by_two_points
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:hypothesis: span_member_shrinks_at_a_cusp | $\mathbf r'\ne0$; at a cusp the line is a point
:needs: negative_weight_takes_a_point_away | definition 4.1.1: $w_i>0$ | the weights are positive
:meant: theorem 4.3.1, of which it is a corollary | That the curve is an envelope of these lines, touched by a line in each of its points.
:figure: nurbs_envelope_families

The lines are segments, the legs that de Boor's algorithm draws last.  Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span: `extrapolated_members_keep_positive_weights_inside`.
:::

For $r=k-2$ two points are left, and the B-splines of order 2 on a span are the two linear functions of its ends.  The
member is the last leg that de Boor's algorithm draws, and the theorem says what every drawing of the algorithm shows:
this leg is a tangent.

:::{claim} lines_of_the_family_by_two_points
:title: The member of order 2 is the printed quotient of two points
:zh: 二阶族曲线即所印的两点之商
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, for $k\le4$ all
  patterns; weights and
  points, any $t$ and $\tau$; $r=k-2$
:where: the weights of the curve, the levels and the member are not 0
:then: (4.3.3) is (4.3.8)
:method: Both quotients by their letter, one coordinate.
:degrees: 2..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:argued: every order and all knots | On the span $N_{j-1,2}=\frac{t_{j+1}-t}{t_{j+1}-t_j}$ and $N_{j,2}=\frac{t-t_j}{t_{j+1}-t_j}$; the common divisor falls away.
:control: $t-t_j$ and $t_{j+1}-t$ exchanged
:::
*/
CLAIM(lines_of_the_family_by_two_points)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], S[2];
        G(knots_of_span)(T, p, shape, u, place);
        G(level_of_curve)(p, 1, u, mu, R, w, p - 1, tau, Rr, wr);
        G(sums)(1, 1, u, mu, Rr, wr, t, S);
        num up = sub(t, u[mu]), down = sub(u[mu + 1], t);
        num left = mul(fault(T, down, up), wr[0]), right = mul(fault(T, up, down), wr[1]);
        /* ((t_j+1 - t) w_j-1 r_j-1 + (t - t_j) w_j r_j) / ((t_j+1 - t) w_j-1 + (t - t_j) w_j), all at level k-2 */
        same(T, div(S[0], S[1]), div(add(mul(left, Rr[0]), mul(right, Rr[1])), add(left, right)));
    }
}

/*
## The order of contact

The source says that the derivatives are parallel, and no more; rightly.  Let $m=k-1-r$ be the degree of the member and
$n=k-1$ that of the curve.  The homogeneous derivatives of member and curve at $\tau=t$ are parallel in every order,
with the factors $\frac{m!/(m-i)!}{n!/(n-i)!}$, which do not depend on the knots.  So the contact is what it is for
rational Bézier curves: it is of order 1 wherever the curvature is not 0, and the member is always flatter than the
curve.

:::{claim} span_derivatives_are_parallel
:title: The homogeneous derivatives of member and curve are parallel in every order
:zh: 族曲线与曲线的各阶齐次导矢平行
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, for $k\le4$ all
  patterns; weights and
  points, any $t$, every $r=0,\dots,k-1$ and $i=0,\dots,k-1-r$
:then: with $n=k-1$, $m=n-r$: $\frac{n!}{(n-i)!}\,\partial_t^iP^{[r]}(t,t)=\frac{m!}{(m-i)!}\,P^{(i)}(t)$ for the
  coordinate and for the weight
:method: The levels of de Boor's triangle in homogeneous coordinates, and the kernel of the derivatives of a segment.
:degrees: 1..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:argued: every order and all knots | With the polar form $f$ of the segment in homogeneous coordinates $P^{[r]}(t,\tau)=f[\tau^r,t^m]$, affine in each argument; so
  $\partial_t^iP^{[r]}=\frac{m!}{(m-i)!}f[\tau^r,t^{m-i},\delta^i]$, $\delta$ being the direction, and for $\tau=t$ the value of $f$ is that of $r=0$, where $m$ is $n$.
:control: the factors left out
:::
*/
CLAIM(span_derivatives_are_parallel)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], H[2 * (MAX_DEGREE + 1)], t = parameter(T, "t");
    int place[MOST_KNOTS];
    for (int m = 0; m < 2 * (p + 1); m++)
        H[m] = unknown(T, "H", m);
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num D[2 * (MAX_DEGREE + 1)], E[2 * (MAX_DEGREE + 1)], d[2 * (MAX_DEGREE + 1)];
        G(knots_of_span)(T, p, shape, u, place);
        G(bspline_derivatives)(G(span_alone)(p, 2, u, mu, H), t, p, D);
        for (int m = 0; m < 2 * (p + 1); m++)
            d[m] = H[m];
        for (int r = 0; r <= p; r++) {
            if (r > 0)
                G(bspline_deboor_level)(G(on_span)(p, 2, u, mu, NULL), r, d, t);
            G(bspline_derivatives)(G(span_alone)(p - r, 2, u, mu, d), t, p - r, E);
            for (int m = 0; m < 2 * (p - r + 1); m++) {
                long a = fault(T, G(falling_factorial)(p, m / 2), 1),
                     b = fault(T, G(falling_factorial)(p - r, m / 2), 1);
                /* n!/(n-i)! ∂_t^i P[r](t,t) = m!/(m-i)! P^(i)(t), n = k-1, m = n-r */
                same(T, mul(from_int(a), E[m]), mul(from_int(b), D[m]));
            }
        }
    }
}

/*
Parallel derivatives of numerator and denominator do not make the curvatures equal.  The first derivatives have the
ratio $\frac mn$ and the second ones $\frac{m(m-1)}{n(n-1)}$, where contact of order 2 would ask for the square of the
first.  In the plane and in space the quotient of the curvatures (曲率) is therefore a number less than 1, which only
the orders determine.

:::{claim} curvatures_have_a_fixed_ratio
:title: Member and curve turn in a fixed ratio, which depends on k and r only
:zh: 族曲线与曲线的曲率之比只与 k, r 有关
:given: the derivatives $P,P',P''$ of a curve with weight $w>0$, two coordinates, and those of the member,
  $P$, $\frac mnP'$, $\frac{m(m-1)}{n(n-1)}P''$; any $n\ge2$ and $m\ge1$
:where: $w(t)>0$
:let: $r$, $r_m$ the two in the plane, $\kappa$, $\kappa_m$ their curvatures
:then: $r_m'=\frac mnr'$ and $r_m'\times r_m''=\frac{m^2(m-1)}{n^2(n-1)}\,r'\times r''$, hence
  $\frac{\kappa_m}{\kappa}=\frac{n(m-1)}{m(n-1)}$, which is less than 1 for $m<n$: the contact is of order 1 where
  $\kappa\ne0$
:method: Quotient rule with $n$ and $m$ as variables.  The two coordinates are any two, so it holds in space as well.
  $m(n-1)-n(m-1)=n-m=r$.
:degrees: all
:over: n; m; P#: derivatives; w: weight
:control: the ratio $\frac{m(m-1)}{n(n-1)}$ for the determinants
:::
*/
CLAIM(curvatures_have_a_fixed_ratio)
{
    num n = parameter(T, "n"), m = parameter(T, "m"), one = from_int(1), R[2][6];
    num first = div(m, n), second = div(mul(m, sub(m, one)), mul(n, sub(n, one)));
    num P[9];
    for (int i = 0; i < 9; i++)
        P[i] = i == 2 ? positive(T, "w", 0) : unknown(T, "P", i);
    for (int j = 0; j < 2; j++) {
        num D[9];
        for (int i = 0; i < 9; i++)
            D[i] = mul(j == 0 || i < 3 ? one : i < 6 ? first : second, P[i]);
        G(rational_quotient_derivatives)(2, D, 2, R[j]);
    }
    about(T, "the first derivatives");
    /* r_m' = m/n r' */
    same(T, R[1][2], mul(first, R[0][2]));
    num ratio = fault(T, mul(first, second), second);
    about(T, "the determinants of the derivatives");
    /* r_m' × r_m'' = m²(m-1)/(n²(n-1)) r' × r'' */
    same(T, G(cross2)(R[1] + 2, R[1] + 4), mul(ratio, G(cross2)(R[0] + 2, R[0] + 4)));
}

#if !FIELD
/*
:::{claim} curvature_of_the_span_member
:title: The ratio of the curvatures, measured on curves of the plane and of space
:zh: 曲率比的直接计算
:types: rational interval double
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, for $k\le4$ all
  patterns; weights and
  points of the plane and of space, any $t$, $r=1,\dots,k-2$
:then: $((k-r-1)(k-2))^2\,\kappa^2_{k-r}(t)=((k-1)(k-r-2))^2\,\kappa^2(t)$
:method: The second way: the points of the member by (4.1.3), (4.1.4), and the curvatures of both curves by their
  derivatives.
:degrees: 2..4 sampled 5
:control: the ratio $\frac{k-r-2}{k-2}$
:::
*/
CLAIM(curvature_of_the_span_member)
{
    int p = T->degree, k = p + 1, mu = p;
    num u[MOST_KNOTS], R[3 * (MAX_DEGREE + 1)], w[MAX_DEGREE + 1];
    int place[MOST_KNOTS];
    for (int dim = 2; dim <= 3; dim++)
        for (int shape = 0; shape < G(shapes)(p); shape++) {
            num t = parameter(T, "t"), D[9], E[9];
            G(free_curve)(T, p, dim, R, w);
            G(knots_of_span)(T, p, shape, u, place);
            t = add(u[mu], mul(t, sub(u[mu + 1], u[mu])));
            G(curve_derivatives)(p, dim, u, mu, R, w, t, 2, D);
            for (int r = 1; r <= k - 2; r++) {
                num Rr[3 * (MAX_DEGREE + 1)], wr[MAX_DEGREE + 1];
                G(level_of_curve)(p, dim, u, mu, R, w, r, t, Rr, wr);
                G(curve_derivatives)(p - r, dim, u, mu, Rr, wr, t, 2, E);
                int a = fault(T, k - r - 1, 1) * (k - 2), b = fault(T, k - 1, 1) * (k - r - 2);
                /* ((k-r-1)(k-2))² κ²_k-r = ((k-1)(k-r-2))² κ² */
                same(T, mul(from_int((long)a * a), G(curvature_squared)(dim, E + dim, E + 2 * dim)),
                     mul(from_int((long)b * b), G(curvature_squared)(dim, D + dim, D + 2 * dim)));
            }
        }
}
#endif

#include "chapters/judge/claims_off.h"
