/*
# Is the envelope unique? The first level (包络的唯一性: r = 1)

A joint solution of the family (4.3.3) and of the condition that its two derivatives are parallel is a set of pairs
$(t,\tau)$ of the square $[t_j,t_{j+1})^2$.  The diagonal $\tau=t$ is the curve.  Whether there is anything else is a
question about the other factor of the condition.  For $r=1$ it can be answered completely.  With $k$ and the
derivatives of $p$ and $w$ at $t$ as variables the member and its derivatives are explicit, and

$$\frac{\partial\mathbf r^{[k-1]}}{\partial\tau}\times\frac{\partial\mathbf r^{[k-1]}}{\partial t}=
\frac{(\tau-t)\,w^3(t)}{(k-1)^2\,W^3(t,\tau)}\;\mathbf r'(t)\times\mathbf r''(t),\qquad
W=w(t)+\frac{\tau-t}{k-1}w'(t)>0.$$

The other factor depends on $t$ alone.  A zero $t_0$ of $\mathbf r'\times\mathbf r''$, an inflection for instance,
gives the whole line $t=t_0$ of the square, and the points of that line are a segment of the tangent at the
inflection: it is touched by every member that does not stand still there.
*/
#include "chapters/nurbs/family.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch4:thm-4.3.2
:title: For r = 1 the envelope is unique
:zh: r=1 时包络唯一
:printed: for $r=1$ the envelope in (4.3.2) is unique: it is the segment $\mathbf r(t)$, $t_j\le t<t_{j+1}$, of the
  curve
:class: false
:refuted-by: inflected_cubic_has_second_envelope folded_line_has_another_solution
:meant: (4.3.3) and (4.3.9), by which the section determines the envelope | The first: all joint solutions.
:reading: inflected_cubic_has_second_envelope | all joint solutions of (4.3.3) and (4.3.9), at an inflection, in
  the plane
:reading: space_quartic_has_second_envelope | all joint solutions of (4.3.3) and (4.3.9), of a curve that is not plane, where its
  curvature vanishes
:reading: first_level_condition_factors | only solutions of the form $\tau=\tau(t)$ with a continuous function, as
  (4.3.10) may be meant, if $\mathbf r'\times\mathbf r''$ is not 0 identically: the lines $t=t_0$ are then left out |
  Away from the isolated zeros of $\mathbf r'\times\mathbf r''$ the condition leaves $\tau=t$ only, and a continuous function has
  the same value at them.
:reading-with: first_level_follows_the_tangent
:reading: folded_line_has_another_solution | only solutions of the form $\tau=\tau(t)$ with a continuous function, when $\mathbf r'\times\mathbf r''$ is 0 identically, a case which the proof includes
:corrected: the joint solutions are $\tau=t$ and the lines $t=t_0$ with $\mathbf r'(t_0)\times\mathbf r''(t_0)=0$; the
  points of such a line are $\mathbf r(t_0)+\frac{(\tau-t_0)w(t_0)}{(k-1)W(t_0,\tau)}\mathbf r'(t_0)$, $W$ being the denominator of the member; hence, unless
  $\mathbf r$ is on a straight line, the envelope is $\mathbf r$ alone if and only if $\mathbf r'\times\mathbf r''=0$
  only where $\mathbf r'=0$; so for a strictly convex control polygon of the span
:corrected-by: first_level_condition_factors first_level_follows_the_tangent extra_points_run_along_the_tangent
  convex_polygon_of_span_has_one_envelope
:argued: | That an extra segment is more than $\mathbf r$: a rational curve that is not straight has finitely many points on a tangent.
:striking: 2
:figure: nurbs_second_line

A zero of $\mathbf r'\times\mathbf r''$ with $\mathbf r'=0$, a cusp, gives a line of the square as well, but all
its pairs have the point $\mathbf r(t_0)$.
:::

:::{statement} wang-ch4:formula-4.3.9
:title: For r = 1 the envelope is the joint solution of (4.3.3) and (4.3.9)
:zh: r=1 时包络为 (4.3.3) 与 (4.3.9) 的联合解
:printed: by [18] the envelope of the family $\{\mathbf r^{[k-1]}(t,\tau),\ t_j\le t<t_{j+1}\mid t_j\le\tau<t_{j+1}\}$ is the joint solution of (4.3.3), $r=1$, and
  $\frac{\partial\mathbf r^{[k-1]}(t,\tau)}{\partial\tau}\times\frac{\partial\mathbf
  r^{[k-1]}(t,\tau)}{\partial t}=\mathbf 0$, $t_j\le t,\tau<t_{j+1}$
:holds-by: touching_curve_satisfies_the_condition
:confirmed-by: first_level_condition_factors
:hypothesis: member_that_stands_still_is_not_touched | $\partial_t\mathbf r^{[k-1]}\ne0$: where a member stands still the condition is satisfied, and the
  member may have another direction
:hypothesis: solutions_at_a_cusp_have_one_point | $\mathbf r^{[k-1]}$ is not constant on the solution: at a cusp $t_0$ of the curve the pairs of the line $t=t_0$
  satisfy the condition and have one point, which is no curve
:hypothesis: folded_line_has_another_solution | $\tau$ is not constant on the solution: on a straight segment every pair satisfies the condition, and a constant $\tau$
  gives one member, which does not pass from member to member and may have points that $\mathbf r$ has not
:meant: the usual notion of an envelope, as [18] is not at hand | A curve $\mathbf r^{[k-1]}(t(s),\tau(s))$ that passes from member to member, $\tau'\ne0$, and is tangent
  to each member where it passes it.
:figure: nurbs_second_line

The condition is necessary for every such curve, and sufficient where $\partial_t\mathbf r^{[k-1]}\ne0$ and the curve is neither one point nor one
member.  One member it can be on a straight segment only: on others the solutions are the diagonal and single lines $t=t_0$, see `formula-4.3.10`.
:::

:::{claim} touching_curve_satisfies_the_condition
:title: A curve that is tangent to the members it passes satisfies the condition
:zh: 与族曲线相切的曲线满足包络条件
:given: the derivatives $X_t$, $X_\tau$ of a family at a pair $(t,\tau)$, and a curve through it with $t'$ and $\tau'$
:then: $(t'X_t+\tau'X_\tau)\times X_t=\tau'\,X_\tau\times X_t$ in space
:method: The chain rule; three coordinates, everything a variable.  The left side is 0 if the curve and the member
  have one tangent; so $X_\tau\times X_t=0$ where $\tau'\ne0$.  Conversely the curve is tangent where this holds,
  $X_t\ne0$ and the derivative $t'X_t+\tau'X_\tau$ of the curve is not 0.
:argued: isolated points where the curve stands still | Its direction there is the limit of its directions beside the point; these are along $X_t$, which is
  continuous and not 0.
:over: dt ds: -; X# Y#: derivatives of the family
:control: the factor $t'$ in the place of $\tau'$
:::
*/
CLAIM(touching_curve_satisfies_the_condition)
{
    num Xt[3], Xs[3], along[3], left[3], right[3], dt = unknown(T, "dt", 0), ds = unknown(T, "ds", 0);
    for (int c = 0; c < 3; c++) {
        Xt[c] = unknown(T, "X", c);
        Xs[c] = unknown(T, "Y", c);
        along[c] = add(mul(dt, Xt[c]), mul(ds, Xs[c]));
    }
    G(cross3)(along, Xt, left);
    G(cross3)(Xs, Xt, right);
    for (int c = 0; c < 3; c++)
        /* (t' X_t + τ' X_τ) × X_t = τ' X_τ × X_t */
        same(T, left[c], mul(fault(T, ds, dt), right[c]));
}

#if RATIONAL
/*
:::{claim} member_that_stands_still_is_not_touched
:title: Where a member stands still the condition is satisfied, and the member is not touched
:zh: 族曲线的驻点处满足包络条件而不相切
:kind: counterexample
:given: the cubic $\sum a_mt^m$, which is $(t+t^2,t^3)$, as a segment over the uniform knots $t_i$, weights 1; $r=1$, its inflection $t$ and the member $X$ of the parameter $\tau$
:data: t_i = -7 -5 -3 -1 1 3 5 7; a = (0,0) (1,0) (1,0) (0,1); t = 0; τ = -1
:instead: τ = -1/2
:then: (4.3.9) is satisfied because $\partial_tX=0$; the solutions about the pair are the line $t=0$, whose points run along the axis, and the
  member runs there in another direction, that of $\partial_t^2X$
:result: r_i = (14/3,-15) (-4/3,3) (2/3,-3) (32/3,15); point of the member = (-1/3,0); its derivatives by t and τ = (0,0) (1/3,0); direction of the member = (2/3,-2)
:method: Member and derivatives by its points over the knots.  The direction of the member is its first derivative that is not 0; the determinant of it and of the derivative by
  $\tau$ is compared with 0.  With the same $t$ every $\tau$ gives a pair: `first_level_condition_factors`.
:control: another member, which does not stand still
:::
*/
CLAIM(member_that_stands_still_is_not_touched)
{
    num u[8], R[8], w[4], Rr[8], wr[4], D[6], E[6], X[2], t = given(T, "t"), tau = given(T, "τ");
    G(given_curve_of_powers)(T, 3, 2, u, R, w);
    if (!G(pair_in_the_square)(T, 3, 2, u, 3, R, w, 1, tau, t, X))
        return;
    G(family_derivatives)(3, 2, u, 3, R, w, 1, tau, t, D);
    G(level_of_curve)(3, 2, u, 3, R, w, 1, tau, Rr, wr);
    G(curve_derivatives)(2, 2, u, 3, Rr, wr, t, 2, E);
    const num *direction = is_zero_q(E[2]) && is_zero_q(E[3]) ? E + 4 : E + 2;
    found_points(T, "direction of the member", 1, 2, direction);
    about(T, "the determinant of the directions of the solutions and of the member");
    vanishes(T, G(cross2)(D + 4, direction));
}

/*
:::{claim} solutions_at_a_cusp_have_one_point
:title: At a cusp the pairs that satisfy the condition have one point
:zh: 尖点处满足包络条件的各对参数只给出一点
:kind: counterexample
:given: the cubic $\sum a_mt^m$, which is $(t^2,t^3)$, as a segment over the uniform knots $t_i$, weights 1; $r=1$, its cusp $t$ and the members $X$ of the
  parameters $\tau$ and $\sigma$
:data: t_i = -7 -5 -3 -1 1 3 5 7; a = (0,0) (0,0) (1,0) (0,1); t = 0; τ = 1/2; σ = -1/2
:instead: a = (0,0) (1,0) (0,0) (0,1)
:then: (4.3.9) is satisfied by both, with $\partial_tX\ne0$; the two points are one, so that the solutions about the pairs, the line $t=0$, are no curve that could be tangent
:result: r_i = (23/3,-15) (-1/3,3) (-1/3,-3) (23/3,15); point of the member = (0,0); its derivatives by t and τ = (1/3,0) (0,0); point of the other member = (0,0)
:method: Members and derivatives by their points over the knots.  By `first_level_condition_factors` the solutions beside $\tau=t$ are the zeros of
  $\mathbf r'\times\mathbf r''$, of $t^2$ up to a factor, and on $t=0$ the point is $\mathbf r(0)+\frac{\tau}{k-1}\mathbf r'(0)$ for every $\tau$.
:control: the inflection of $(t,t^3)$, whose solutions have a segment of points
:::
*/
CLAIM(solutions_at_a_cusp_have_one_point)
{
    num u[8], R[8], w[4], D[6], E[6], X[2], t = given(T, "t"), tau = given(T, "τ"), sigma = given(T, "σ");
    G(given_curve_of_powers)(T, 3, 2, u, R, w);
    int satisfied = G(pair_in_the_square)(T, 3, 2, u, 3, R, w, 1, tau, t, X);
    G(family_derivatives)(3, 2, u, 3, R, w, 1, tau, t, D);
    G(family_derivatives)(3, 2, u, 3, R, w, 1, sigma, t, E);
    found_points(T, "point of the other member", 1, 2, E);
    satisfied &= G(is_pair_of_span)(u, 3, t, sigma) && is_zero_q(G(cross2)(E + 2, E + 4));
    for (int m = 0; m < 2; m++) /* both members move at t */
        satisfied &= m == 0 ? !is_zero_q(D[2]) || !is_zero_q(D[3]) : !is_zero_q(E[2]) || !is_zero_q(E[3]);
    about(T, "the two points differ");
    refute(T, satisfied && equal_q(X[0], E[0]) && equal_q(X[1], E[1]));
}
#endif

/*
:::{statement} wang-ch4:formula-4.3.10
:title: The solutions as functions of t
:zh: 解写成 τ=τ(t)
:printed: in the joint solution of (4.3.3) and (4.3.9) $\tau=\tau(t)$
:reading: first_level_condition_factors | it says which solutions are looked for: as an agreement it decides nothing, but then a
  line $t=t_0$ of the square $[t_j,t_{j+1})^2$ is left out of the envelope by agreement
:reading-with: first_level_follows_the_tangent
:reading: inflected_cubic_has_second_envelope | it says that every joint solution has this form: the lines
  $t=t_0$ with $\mathbf r'(t_0)\times\mathbf r''(t_0)=0$ do not
:corrected: the solutions of (4.3.9) in the square $[t_j,t_{j+1})^2$ are the diagonal and the lines $t=t_0$ with $\mathbf
  r'(t_0)\times\mathbf r''(t_0)=0$, on which $t$ is a function of $\tau$
:corrected-by: first_level_condition_factors first_level_follows_the_tangent
:figure: nurbs_second_line
:::

## The member of the first level

:::{statement} wang-ch4:thm-4.3.2-differences
:title: The derivative as a sum over differences
:zh: 导矢的差分表示
:printed: \sum_{i=j-k+2}^jN_{i,k-1}(t)\frac{w_i-w_{i-1}}{t_{i+k-1}-t_i}=\frac{w'(t)}{k-1},\qquad
  \sum_{i=j-k+2}^jN_{i,k-1}(t)\frac{w_i\mathbf r_i-w_{i-1}\mathbf r_{i-1}}{t_{i+k-1}-t_i}=\frac{\mathbf p'(t)}{k-1},\quad t_j\le t<t_{j+1}
:holds-by: differences_of_span_give_the_derivative
:figure: nurbs_second_line
:::

The member of level 1 is computed from $w_i^{[1]}(\tau)$, a mean of $w_{i-1}$ and $w_i$ which is linear in $\tau$.
Its change with $\tau$ is a difference of weights over a length of knots, and such differences, summed with the
B-splines of order $k-1$, are the derivative.  So the member of level 1 is a piece of Taylor's formula: value and
first derivative at $t$, followed as far as $\tau-t$, with the factor $\frac1{k-1}$.

:::{claim} differences_of_span_give_the_derivative
:title: The differences of the points, over lengths, with the basis of the next lower order are the derivative
:zh: 差分与低一阶基函数之和即导矢
:given: order $k$; a span of simple knots, one whose ends are $(k-1)$-fold, one with a double knot, for $k\le4$ all patterns, the distinct knots
  variables for $k\le5$ and numbers above; numbers $c_i$, which are the weights $w_i$ or one coordinate of the $w_i\mathbf r_i$; any $t$
:then: the printed sums are the derivative divided by $k-1$
:method: The sums by their letter against the sum with the derivatives of the B-splines of order $k$.
:degrees: 1..6 sampled 7
:argued: every order and all knots | With the polar form $f$ of the segment $c_i=f[t_{i+1},\dots,t_{i+k-1}]$; it is affine in each argument, so that the printed quotient of differences is
  $f[t_{i+1},\dots,t_{i+k-2},\delta]$, $\delta$ being the direction.  These are the points over the same knots of $f[t^{k-2},\delta]$, which is the derivative divided by $k-1$.
:over: c#: weights and coordinates of weighted points
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:control: the divisors doubled
:::
*/
CLAIM(differences_of_span_give_the_derivative)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], c[MAX_DEGREE + 1], one[MAX_DEGREE + 1], t = parameter(T, "t");
    int place[MOST_KNOTS];
    for (int i = 0; i <= p; i++) {
        c[i] = unknown(T, "c", i);
        one[i] = from_int(1);
    }
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num N[MAX_DEGREE + 1], S[2], sum = from_int(0);
        G(knots_of_span)(T, p, shape, u, place);
        G(derivative_sums)(p, 1, u, mu, c, one, t, S);
        G(bspline_basis)(p - 1, u, mu, t, N);
        for (int m = 0; m < p; m++) {
            int i = mu - p + 1 + m;
            num length = fault(T, sub(u[i + p], u[i]), mul(from_int(2), sub(u[i + p], u[i])));
            sum = add(sum, mul(N[m], div(sub(c[m + 1], c[m]), length)));
        }
        /* (k-1) Σ N_i,k-1 (c_i - c_i-1)/(t_i+k-1 - t_i) = Σ N'_i,k c_i */
        same(T, mul(from_int(p), sum), S[0]);
    }
}

/*
:::{statement} wang-ch4:thm-4.3.2-member
:title: Denominator and numerator of the member
:zh: 族曲线的分母与分子
:printed: \sum_{i=j-k+2}^jN_{i,k-1}(t)\,w_i^{[1]}(\tau)=\frac{\tau-t}{k-1}w'(t)+w(t),\qquad
  \sum_{i=j-k+2}^jN_{i,k-1}(t)\,w_i^{[1]}(\tau)\mathbf r_i^{[1]}(\tau)=\frac{\tau-t}{k-1}\mathbf p'(t)+\mathbf p(t)
:holds-by: first_level_follows_the_tangent
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:figure: nurbs_second_line

Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span:
`extrapolated_members_keep_positive_weights_inside`.
:::

:::{claim} first_level_follows_the_tangent
:title: Numerator and denominator of the member are the first two terms of Taylor's expansion
:zh: 第一层族曲线的分子分母
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, for $k\le4$ all
  patterns; weights and
  points, any $t$ and $\tau$
:where: the weights of the levels are not 0
:then: $\sum N_{i,k-1}(t)w_i^{[1]}(\tau)=w(t)+\frac{\tau-t}{k-1}w'(t)$ and the same with $w_ir_i$ and $p$
:method: The left sides by (4.1.3), (4.1.4); $w'$ and $p'$ by the derivatives of the B-splines of order $k$.
:degrees: 1..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:argued: every order and all knots | With the polar form $f$ of the segment in homogeneous coordinates the sums are $f[\tau,t^{k-2}]$, which is affine in $\tau$, the value $f(t)$ for $\tau=t$, and has
  the derivative $f[\delta,t^{k-2}]=\frac1{k-1}f'(t)$ by $\tau$, $\delta$ being the direction.
:control: the factor $\frac1{k-1}$ replaced by $\frac1k$
:::
*/
CLAIM(first_level_follows_the_tangent)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    num step = mul(sub(tau, t), from_ratio(1, fault(T, p, p + 1)));
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], S[2], P[2], P1[2];
        G(knots_of_span)(T, p, shape, u, place);
        G(level_of_curve)(p, 1, u, mu, R, w, 1, tau, Rr, wr);
        G(sums)(p - 1, 1, u, mu, Rr, wr, t, S);
        G(sums)(p, 1, u, mu, R, w, t, P);
        G(derivative_sums)(p, 1, u, mu, R, w, t, P1);
        for (int c = 0; c < 2; c++)
            /* Σ N_i,k-1(t) w_i[1](τ) = w(t) + (τ - t)/(k-1) w'(t), and the same with p */
            same(T, S[c], add(P[c], mul(step, P1[c])));
    }
}

/*
From here the two derivatives of the member can be written down, and the printed formulas are right.  Note what the
derivative by $\tau$ is: a positive multiple of $\mathbf r'(t)$.  Whatever $\tau$ may be, the member moves along the
tangent of the curve at $t$.

:::{statement} wang-ch4:thm-4.3.2-by-tau
:title: The derivative of the member by τ
:zh: 族曲线对 τ 的偏导矢
:printed: (k-1)\Bigl[\frac{\tau-t}{k-1}w'(t)+w(t)\Bigr]^2\frac{\partial\mathbf
  r^{[k-1]}(t,\tau)}{\partial\tau}=w^2(t)\,\mathbf r'(t)
:holds-by: derivatives_of_the_first_member first_level_follows_the_tangent
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:figure: nurbs_second_line

The words before it are lost in the copy at hand.
Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span:
`extrapolated_members_keep_positive_weights_inside`.
:::

:::{statement} wang-ch4:thm-4.3.2-by-t
:title: The derivative of the member by t
:zh: 族曲线对 t 的偏导矢
:printed: (k-1)\Bigl[\frac{\tau-t}{k-1}w'(t)+w(t)\Bigr]^2\frac{\partial\mathbf r^{[k-1]}(t,\tau)}{\partial
  t}=(\tau-t)\Bigl\{\Bigl[\frac{\tau-t}{k-1}w'(t)+w(t)\Bigr]\mathbf p''(t)-w''(t)\Bigl[\frac{\tau-t}{k-1}\mathbf p'(t)+\mathbf
  p(t)\Bigr]\Bigr\}+(k-2)w^2(t)\mathbf r'(t)
:holds-by: derivatives_of_the_first_member first_level_follows_the_tangent
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:figure: nurbs_second_line

Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span:
`extrapolated_members_keep_positive_weights_inside`.
:::
*/

#if FIELD
/*
:::{claim} derivatives_of_the_first_member
:title: The two derivatives of the member by their formulas
:zh: 族曲线的两个偏导矢
:types: field
:given: $X=A/W$ with $A=p(t)+\frac{\tau-t}{k-1}p'(t)$, $W=w(t)+\frac{\tau-t}{k-1}w'(t)$, $p$ and $w$ quadratic
  polynomials of $t$ with variable coefficients; any $k\ge2$, $\tau$, at any $t$
:then: both printed formulas, in one coordinate
:method: The left sides are formal derivatives of a quotient; the right sides the printed terms.  Both depend on
  $p,p',p''$ and $w,w',w''$ at $t$ only, so quadratic polynomials are enough.
:where: the weights of the curve, the levels and the member are not 0
:degrees: all from 1
:over: k: -; p# w#: coefficients
:control: $k-1$ in the place of $k-2$
:::
*/
CLAIM(derivatives_of_the_first_member)
{
    num t = parameter(T, "t"), tau = parameter(T, "s"), k = parameter(T, "k"), one = from_int(1), two = from_int(2);
    num f[2], f1[2], f2[2], F[2], step = div(sub(tau, t), sub(k, one));
    for (int c = 0; c < 2; c++) { /* p and w */
        const char *name = c == 0 ? "p" : "w";
        f[c] = add(unknown(T, name, 0), mul(t, add(unknown(T, name, 1), mul(t, unknown(T, name, 2)))));
        f1[c] = derivative_f(f[c], t);
        f2[c] = derivative_f(f1[c], t);
        F[c] = add(f[c], mul(step, f1[c]));
    }
    num X = div(F[0], F[1]), front = mul(sub(k, one), mul(F[1], F[1]));
    num tangent = mul(mul(f[1], f[1]), derivative_f(div(f[0], f[1]), t));
    about(T, "the derivative by τ");
    /* (k-1) W² X_τ = w² r' */
    same(T, mul(front, derivative_f(X, tau)), tangent);
    num rest = mul(sub(tau, t), sub(mul(F[1], f2[0]), mul(f2[1], F[0])));
    about(T, "the derivative by t");
    /* (k-1) W² X_t = (τ - t)(W p'' - w'' A) + (k-2) w² r' */
    same(T, mul(front, derivative_f(X, t)), add(rest, mul(sub(k, fault(T, two, one)), tangent)));
}
#endif

/*
From here on the knots are not needed any more: $p$, $p'$, $p''$ at $t$ are three vectors of space and $w$, $w'$,
$w''$ three numbers, all of them variables, and so is $k$.

:::{statement} wang-ch4:thm-4.3.2-equivalent
:title: The condition with the factor τ-t
:zh: 包络条件的等价形式
:printed: (4.3.9) is equivalent to $(\tau-t)\Bigl[\frac{\tau-t}{k-1}w'(t)+w(t)\Bigr][\mathbf r'(t)\times\mathbf p''(t)]=(\tau-t)\,w''(t)\Bigl\{\mathbf
  r'(t)\times\Bigl[\frac{\tau-t}{k-1}\mathbf p'(t)+\mathbf p(t)\Bigr]\Bigr\}$
:holds-by: first_level_condition_as_printed first_level_follows_the_tangent
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:figure: nurbs_second_line

Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span:
`extrapolated_members_keep_positive_weights_inside`.
:::
*/

/* What is known at one t of a curve of order k, and of the member tau of level 1: P = (p, w) and its derivatives, A and W,
 * r' and r'', the derivatives of the member by tau and t.  e = tau - t. */
typedef struct G(jet) {
    num k, e, p[3], p1[3], p2[3], w, w1, w2, A[3], W, r[3], r1[3], r2[3], by_tau[3], by_t[3];
} G(jet);

static G(jet) G(free_jet)(trial *T)
{
    G(jet) J;
    num H[12], D[9], one = from_int(1), two = from_int(2);
    J.k = add(parameter(T, "k"), two);
    J.e = unknown(T, "e", 0);
    J.w = positive(T, "v", 0);
    J.w1 = unknown(T, "v", 1);
    J.w2 = unknown(T, "v", 2);
    num step = div(J.e, sub(J.k, one)), n = sub(J.k, one), kept = div(sub(J.k, two), n);
    J.W = add(J.w, mul(step, J.w1));
    num W_by_tau = div(J.w1, n), W_by_t = add(mul(kept, J.w1), mul(step, J.w2)), square = mul(J.W, J.W);
    for (int c = 0; c < 3; c++) {
        J.p[c] = H[c] = unknown(T, "f", c);
        J.p1[c] = H[4 + c] = unknown(T, "g", c);
        J.p2[c] = H[8 + c] = unknown(T, "h", c);
        J.A[c] = add(J.p[c], mul(step, J.p1[c]));
    }
    H[3] = J.w, H[7] = J.w1, H[11] = J.w2;
    G(rational_quotient_derivatives)(3, H, 2, D);
    for (int c = 0; c < 3; c++) {
        J.r[c] = D[c];
        J.r1[c] = D[3 + c];
        J.r2[c] = D[6 + c];
        num by_tau = div(J.p1[c], n), by_t = add(mul(kept, J.p1[c]), mul(step, J.p2[c])); /* the derivatives of A */
        J.by_tau[c] = div(sub(mul(by_tau, J.W), mul(J.A[c], W_by_tau)), square);
        J.by_t[c] = div(sub(mul(by_t, J.W), mul(J.A[c], W_by_t)), square);
    }
    return J;
}

/* W r' x p'' - w'' r' x A, with plus in the place of minus if asked for. */
static void G(bracket)(const G(jet) * J, int plus, num out[])
{
    num first[3], second[3];
    G(cross3)(J->r1, J->p2, first);
    G(cross3)(J->r1, J->A, second);
    for (int c = 0; c < 3; c++) {
        num a = mul(J->W, first[c]), b = mul(J->w2, second[c]);
        out[c] = plus ? add(a, b) : sub(a, b);
    }
}

/*
The condition of the envelope is then a vector equation.  The source divides by $\tau-t$ and goes on with what it
calls the other case. It could have stopped here: by the quotient rule the bracket is $Ww\,\mathbf r'\times\mathbf
r''$, so that the other case is the zeros of $\mathbf r'\times\mathbf r''$, inflections and cusps of the curve, and nothing else.

:::{claim} first_level_condition_as_printed
:title: The condition of the envelope is the printed equation of vector products
:zh: 包络条件与所印方程等价
:given: vectors $p,p',p''$ of space, numbers $w,w',w''$, any $k\ge2$ and $\tau-t$
:let: $r=\frac pw$; $A=p+\frac{\tau-t}{k-1}p'$, $W=w+\frac{\tau-t}{k-1}w'$ and $X=\frac AW$ the member
:then: $(k-1)^2W^4\,X_\tau\times X_t=w^2(\tau-t)\{W\,r'\times p''-w''\,r'\times A\}$
:method: $X_\tau$ and $X_t$ by the quotient rule from $A_\tau=\frac{p'}{k-1}$, $A_t=\frac{k-2}{k-1}p'+\frac{\tau-t}{k-1}p''$, and those of $W$ likewise;
  everything a variable; $W$ and $w$ are positive on the span.
:where: the weights of the curve, the levels and the member are not 0
:degrees: all from 1
:over: k: -; e: step from t to τ; f# g# h#: derivatives of the numerator; v#: derivatives of the denominator
:control: the sign of the second term
:::
*/
CLAIM(first_level_condition_as_printed)
{
    G(jet) J = G(free_jet)(T);
    num left[3], right[3], n = sub(J.k, from_int(1)), W2 = mul(J.W, J.W), front = mul(mul(n, n), mul(W2, W2));
    G(cross3)(J.by_tau, J.by_t, left);
    G(bracket)(&J, fault(T, 0, 1), right);
    for (int c = 0; c < 3; c++)
        /* (k-1)² W⁴ X_τ × X_t = w² (τ - t) (W r' × p'' - w'' r' × A) */
        same(T, mul(front, left[c]), mul(mul(mul(J.w, J.w), J.e), right[c]));
}

/*
:::{claim} first_level_condition_factors
:title: The condition of the envelope is (τ-t) r' x r'' up to a factor
:zh: 包络条件等价于 (τ-t) r'×r''=0
:given: vectors $p,p',p''$ of space, numbers $w,w',w''$, any $k\ge2$ and $\tau-t$
:let: $r=\frac pw$; $A=p+\frac{\tau-t}{k-1}p'$, $W=w+\frac{\tau-t}{k-1}w'$ and $X=\frac AW$ the member
:then: $W\,r'\times p''-w''\,r'\times A=W\,w\;r'\times r''$, hence
  $X_\tau\times X_t=\frac{(\tau-t)w^3}{(k-1)^2W^3}\,r'\times r''$
:method: $X_\tau$, $X_t$, $r'$ and $r''$ by the quotient rule; three coordinates, everything a variable.  So for positive weights the
  joint solutions in the square $[t_j,t_{j+1})^2$ are $\tau=t$ and the lines $t=t_0$ with $r'(t_0)\times r''(t_0)=0$.
:where: the weights of the curve, the levels and the member are not 0
:degrees: all from 1
:over: k: -; e: step from t to τ; f# g# h#: derivatives of the numerator; v#: derivatives of the denominator
:control: $w^2$ in the place of $w^3$
:::
*/
CLAIM(first_level_condition_factors)
{
    G(jet) J = G(free_jet)(T);
    num left[3], turn[3], B[3], n = sub(J.k, from_int(1)), front = mul(mul(n, n), mul(J.W, mul(J.W, J.W)));
    num power = mul(J.w, fault(T, mul(J.w, J.w), J.w));
    G(bracket)(&J, 0, B);
    G(cross3)(J.by_tau, J.by_t, left);
    G(cross3)(J.r1, J.r2, turn);
    for (int c = 0; c < 3; c++) {
        about(T, "the bracket");
        /* W r' × p'' - w'' r' × A = W w r' × r'' */
        same(T, B[c], mul(mul(J.W, J.w), turn[c]));
        about(T, "the condition");
        /* (k-1)² W³ X_τ × X_t = (τ - t) w³ r' × r'' */
        same(T, mul(front, left[c]), mul(mul(J.e, power), turn[c]));
    }
}

/*
What do the points of a line $t=t_0$ of the square look like?  As $\tau$ runs through the span the point of contact
runs along the tangent at $t_0$.  Each member passes it in another point and, if it does not stand still, is tangent to it there: the tangent at an
inflection is touched by all of these.

:::{claim} extra_points_run_along_the_tangent
:title: The points of a line t = t₀ of the square are a segment of the tangent
:zh: 直线 t=t₀ 上的点构成切线段
:given: vectors $p,p',p''$ of space, numbers $w,w',w''$, any $k\ge2$ and $\tau-t$
:let: $r=\frac pw$; $A=p+\frac{\tau-t}{k-1}p'$, $W=w+\frac{\tau-t}{k-1}w'$ and $X=\frac AW$ the member
:then: $X(t_0,\tau)-r(t_0)=\frac{(\tau-t_0)\,w}{(k-1)W}\,r'(t_0)$
:method: Both sides in one coordinate.  For $r'(t_0)\ne0$ the factor is strictly increasing in $\tau$, its derivative
  being $w^2/((k-1)W^2)$: a segment; for $r'(t_0)=0$ the point $r(t_0)$.
:where: the weights of the curve, the levels and the member are not 0
:degrees: all from 1
:over: k: -; e: step from t to τ; f# g# h#: derivatives of the numerator; v#: derivatives of the denominator
:control: $w$ left out
:::
*/
CLAIM(extra_points_run_along_the_tangent)
{
    G(jet) J = G(free_jet)(T);
    num factor = div(J.e, mul(sub(J.k, from_int(1)), J.W));
    factor = fault(T, mul(factor, J.w), factor);
    /* X(t_0,τ) - r(t_0) = (τ - t_0) w / ((k-1) W) r'(t_0) */
    same(T, sub(div(J.A[0], J.W), J.r[0]), mul(factor, J.r1[0]));
}

/*
:::{statement} wang-ch4:thm-4.3.2-dot
:title: The product with p'' gives a triple product
:zh: 与 p'' 作数量积得混合积
:printed: the scalar product of both sides with $\mathbf p''(t)$ gives $(\tau-t)\bigl(\mathbf
  r'(t),\frac{\tau-t}{k-1}\mathbf p'(t)+\mathbf p(t),\mathbf p''(t)\bigr)=0$
:class: invalid-proof
:refuted-by: product_with_second_derivative_says_nothing
:corrected: the scalar product with $\frac{\tau-t}{k-1}\mathbf p'(t)+\mathbf p(t)$ gives the printed equation; that with
  $\mathbf p''(t)$ gives $(\tau-t)\,w''(t)\,\bigl(\mathbf r'(t),\frac{\tau-t}{k-1}\mathbf p'(t)+\mathbf p(t),\mathbf p''(t)\bigr)=0$, with a factor $w''$ that
  may be 0
:corrected-by: product_with_the_numerator_gives_the_triple_product product_with_second_derivative_loses_the_left_side
:figure: product_that_says_nothing

For equal weights, that is for B-spline curves, the product with $\mathbf p''$ is $0=0$ for all $t$ and $\tau$.
:::

:::{claim} product_with_second_derivative_loses_the_left_side
:title: The scalar product of the condition with p'' is w'' times a triple product
:zh: 与 p'' 的数量积只留下 w'' 倍的混合积
:given: vectors $p,p',p''$ of space, numbers $w,w',w''$, any $k\ge2$ and $\tau-t$
:let: $r=\frac pw$; $A=p+\frac{\tau-t}{k-1}p'$, $W=w+\frac{\tau-t}{k-1}w'$ and $X=\frac AW$ the member
:then: $(W\,r'\times p''-w''\,r'\times A)\cdot p''=-w''\,(r',A,p'')$
:method: Everything a variable.
:where: the weights of the curve, the levels and the member are not 0
:degrees: all from 1
:over: k: -; e: step from t to τ; f# g# h#: derivatives of the numerator; v#: derivatives of the denominator
:control: the factor $w''$ left out
:::
*/
CLAIM(product_with_second_derivative_loses_the_left_side)
{
    G(jet) J = G(free_jet)(T);
    num B[3], triple = neg(G(det3)(J.r1, J.A, J.p2));
    G(bracket)(&J, 0, B);
    /* (W r' × p'' - w'' r' × A) · p'' = -w'' (r', A, p'') */
    same(T, G(dot)(3, B, J.p2), fault(T, mul(J.w2, triple), triple));
}

/*
:::{claim} product_with_the_numerator_gives_the_triple_product
:title: The scalar product of the condition with the numerator of the member is the triple product
:zh: 与族曲线分子的数量积给出混合积
:given: vectors $p,p',p''$ of space, numbers $w,w',w''$, any $k\ge2$ and $\tau-t$
:let: $r=\frac pw$; $A=p+\frac{\tau-t}{k-1}p'$, $W=w+\frac{\tau-t}{k-1}w'$ and $X=\frac AW$ the member
:then: $(W\,r'\times p''-w''\,r'\times A)\cdot A=-W\,(r',A,p'')$
:method: Everything a variable.  $W>0$ on the span, so where the condition holds with $\tau\ne t$ the triple product
  is 0.
:where: the weights of the curve, the levels and the member are not 0
:degrees: all from 1
:over: k: -; e: step from t to τ; f# g# h#: derivatives of the numerator; v#: derivatives of the denominator
:control: the factor $w$ in the place of $W$
:::
*/
CLAIM(product_with_the_numerator_gives_the_triple_product)
{
    G(jet) J = G(free_jet)(T);
    num B[3];
    G(bracket)(&J, 0, B);
    /* (W r' × p'' - w'' r' × A) · A = -W (r', A, p'') */
    same(T, G(dot)(3, B, J.A), neg(mul(fault(T, J.W, J.w), G(det3)(J.r1, J.A, J.p2))));
}

#if RATIONAL
/*
Three equations have been replaced by one.  Which one matters: the product with $\mathbf p''$, which is printed,
multiplies by $w''$ what is to be shown to vanish, and for a polynomial curve $w''=0$.

:::{claim} product_with_second_derivative_says_nothing
:title: For equal weights the scalar product with p'' is 0 = 0
:zh: 权相等时与 p'' 的数量积恒为零
:kind: counterexample
:given: the cubic curve of space $\sum a_mt^m$ as a segment over the uniform knots $t_i$, weights 1; $t$ and $\tau$; $A=\mathbf p+\frac{\tau-t}{k-1}\mathbf p'$
:data: t_i = -7 -5 -3 -1 1 3 5 7; a = (0,0,1) (1,0,0) (0,1,0) (0,0,1); t = 0; τ = 1/2
:instead: a = (0,0,0) (1,0,0) (0,1,0) (0,0,1)
:then: the scalar product of both sides with $p''$ is satisfied, and $(\tau-t)(r',A,p'')\ne0$
:result: r_i = (-3,23/3,-14) (-1,-1/3,4) (1,-1/3,-2) (3,23/3,16); (p,w), (p',w'), (p'',w'') = (0,0,1,1) (1,0,0,0) (0,2,0,0);
  left side times p'' = 0; right side times p'' = 0
:method: The derivatives of $\mathbf p$ and $w$ by points and weights over uniform knots, those of $\mathbf r$ by the quotient rule; the triple product is compared with 0 after
  the other equation has been found to be true.
:control: the curve moved so that its osculating plane at $t$ passes through the origin, where $r'$, $A$ and $p''$ are dependent
:::
*/
CLAIM(product_with_second_derivative_says_nothing)
{
    num u[8], R[12], w[4], H[16], P[12], D[9], A[3], left[3], right[3];
    num t = given(T, "t"), tau = given(T, "τ"), e = sub(tau, t), step = div(e, from_int(3)); /* (τ-t)/(k-1) */
    G(given_curve_of_powers)(T, 3, 3, u, R, w);
    if (!G(is_pair_of_span)(u, 3, t, tau))
        return;
    G(rational_homogenize)(3, 3, R, w, H);
    G(bspline_derivatives)(G(span_alone)(3, 4, u, 3, H), t, 2, P);
    const num *p = P, *p1 = P + 4, *p2 = P + 8; /* (p, w), (p', w'), (p'', w'') */
    G(rational_quotient_derivatives)(3, P, 2, D);
    for (int c = 0; c < 3; c++)
        A[c] = add(p[c], mul(step, p1[c]));
    num W = add(p[3], mul(step, p1[3]));
    G(cross3)(D + 3, p2, left);
    G(cross3)(D + 3, A, right);
    num side = mul(e, mul(W, G(dot)(3, left, p2))), other = mul(e, mul(p2[3], G(dot)(3, right, p2)));
    num triple = mul(e, G(det3)(D + 3, A, p2));
    found_points(T, "(p,w), (p',w'), (p'',w'')", 3, 4, P);
    found(T, "left side times p''", side);
    found(T, "right side times p''", other);
    if (!equal_q(side, other))
        return;
    about(T, "(τ-t)(r', A, p'')");
    vanishes(T, triple);
}
#endif

/*
:::{statement} wang-ch4:formula-4.3.11
:title: The first alternative is the diagonal
:zh: 第一种情形:τ=t
:printed: \tau(t)=t
:holds-by: envelope_condition_holds_on_the_diagonal member_of_span_touches_curve
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:figure: nurbs_second_line

It solves (4.3.9), and its points are those of the curve.
Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span:
`extrapolated_members_keep_positive_weights_inside`.
:::

:::{statement} wang-ch4:formula-4.3.12
:title: The second alternative, a triple product with the points
:zh: 第二种情形:混合积之和
:printed: \tau(t)=t\text{ or }\sum_{i=j-k+1}^jN_{i,k}(t)\,w_i\cdot(\mathbf r_i,\mathbf r'(t),\mathbf r''(t))=0
:holds-by: triple_product_is_that_of_the_point
:reading: triple_product_is_that_of_the_point | it follows, $W$ not being 0, from the equation before it, that of `thm-4.3.2-dot`
:reading: first_level_condition_factors | it holds for the joint solutions of (4.3.3) and (4.3.9) | For $\tau\ne t$ the condition says $\mathbf r'\times\mathbf r''=0$, so that each term of the sum is 0.
:reading-with: first_level_follows_the_tangent
:needs: member_of_weight_zero_leaves_the_sum_open | definition 4.1.1: $w_i>0$ | the weight $W$ of the member is not 0:
  positive $w_i$ make it positive for $t$ and $\tau$ in one span
:figure: points_off_the_plane

For $\tau\ne t$ it is equivalent to the triple product of `thm-4.3.2-dot`.
:::

:::{claim} triple_product_is_that_of_the_point
:title: The triple product is that of p, r', r'', up to the factor −W
:zh: 混合积与 (p, r', r'') 只差因子 −W
:given: vectors $p,p',p''$ of space, numbers $w,w',w''$, any $k\ge2$ and $\tau-t$; and for
  $k=2,3,4$ every pattern of the knots of a span, points and weights, two vectors $a$, $b$ in the place of $r'$, $r''$
:let: $r=\frac pw$; $A=p+\frac{\tau-t}{k-1}p'$, $W=w+\frac{\tau-t}{k-1}w'$ and $X=\frac AW$ the member
:then: $(r',A,p'')=-W\,(p,r',r'')$, and $(p,r',r'')=\sum N_{i,k}(t)w_i\,(r_i,r',r'')$
:method: The first equation in space with everything a variable.  The second: for fixed vectors $r'$, $r''$ the triple
  product is a linear function of its first factor, and $p$ is the sum of $N_{i,k}(t)w_ir_i$; computed for points,
  weights, knots and $t$ as variables.
:scope: k = 2 to 4 and every pattern of the knots of a span for the sum over the points
:where: $w(t)\ne0$
:argued: every order and all knots | The triple product with two fixed vectors is a linear function of the third, and $p$ is the sum of the
  $N_{i,k}(t)w_ir_i$.
:over: k: -; e: step from t to τ; f# g# h#: derivatives of the numerator; v#: derivatives of the denominator; A# B#: vectors
:control: the sign
:::
*/
CLAIM(triple_product_is_that_of_the_point)
{
    G(jet) J = G(free_jet)(T);
    num product = mul(J.W, G(det3)(J.p, J.r1, J.r2));
    about(T, "the triple products");
    /* (r', A, p'') = -W (p, r', r'') */
    same(T, G(det3)(J.r1, J.A, J.p2), fault(T, neg(product), product));
    for (int p = 1; p <= 3; p++) {
        num u[MOST_KNOTS], R[3 * 4], w[4], a[3], b[3], t = parameter(T, "t");
        int place[MOST_KNOTS];
        G(free_curve)(T, p, 3, R, w);
        for (int c = 0; c < 3; c++) { /* r' and r'' */
            a[c] = unknown(T, "A", c);
            b[c] = unknown(T, "B", c);
        }
        for (int shape = 0; shape < G(shapes)(p); shape++) {
            num S[4], N[4], sum = from_int(0);
            G(knots_of_span)(T, p, shape, u, place);
            G(sums)(p, 3, u, p, R, w, t, S);
            G(bspline_basis)(p, u, p, t, N);
            for (int i = 0; i <= p; i++)
                sum = add(sum, mul(mul(N[i], w[i]), G(det3)(R + 3 * i, a, b)));
            about(T, "the sum over the points");
            /* Σ N_i,k w_i (r_i, r', r'') = (p, r', r'') */
            same(T, sum, G(det3)(S, a, b));
        }
    }
}

#if RATIONAL
/*
The factor $-W$ is divided out, and so it must not be 0.

:::{claim} member_of_weight_zero_leaves_the_sum_open
:title: Where the member has the weight 0, the triple product is 0 and the sum over the points is not
:zh: 族曲线的权为零时混合积为零而和不为零
:kind: counterexample
:data: p = (1,0,0); p' = (0,1,0); p'' = (0,0,1); w = 1; w' = -1; s = 1
:instead: w' = 1
:given: $p$, $p'$, $p''$, $w$ and $w'$ of a curve at $t$, $w''=0$, and $s=\frac{\tau-t}{k-1}$
:let: $W=w+s\,w'$, $A=p+s\,p'$
:then: $W=0$ and $(r',A,p'')=0$, but $(p,r',r'')\ne0$
:result: W = 0; (r',A,p'') = 0; (p,r',r'') = 1
:method: $r'$ and $r''$ by the quotient rule, the triple products as determinants.
:control: a weight $W$ that is not 0
:::
*/
CLAIM(member_of_weight_zero_leaves_the_sum_open)
{
    num p[3], p1[3], p2[3], A[3], r1[3], r2[3], w = given(T, "w"), w1 = given(T, "w'"), s = given(T, "s");
    given_points(T, "p", 1, 3, p);
    given_points(T, "p'", 1, 3, p1);
    given_points(T, "p''", 1, 3, p2);
    for (int c = 0; c < 3; c++) {
        A[c] = add(p[c], mul(s, p1[c]));
        r1[c] = div(sub(p1[c], div(mul(w1, p[c]), w)), w);            /* r' = (p' - w' r) / w     */
        r2[c] = div(sub(p2[c], mul(from_int(2), mul(w1, r1[c]))), w); /* r'' = (p'' - 2 w' r') / w */
    }
    num triple = G(det3)(r1, A, p2), sum = G(det3)(p, r1, r2);
    found(T, "W", add(w, mul(s, w1)));
    found(T, "(r',A,p'')", triple);
    found(T, "(p,r',r'')", sum);
    about(T, "whether the two triple products vanish together");
    refute(T, is_zero_q(triple) != is_zero_q(sum));
}
#endif

#include "chapters/judge/claims_off.h"
