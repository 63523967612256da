/*
# Is the envelope unique? Every level (包络的唯一性: 任意 r)

For $r\ge2$ the source repeats the proof of $r=1$ with the member of level $r-1$ in the place of the curve.  Two
things of this idea are true and decide the question.  Write $Q(t)=P^{[r-1]}(t,\tau)$ for the member of level $r-1$
with the parameter $\tau$, in homogeneous coordinates, and $R$ for its points.  Then

$$P^{[r]}(t,\tau)=Q(t)+\frac{\tau-t}{k-r}\,Q'(t),\qquad\frac{\partial P^{[r]}}{\partial\tau}(t,\tau)=\frac
r{k-r}\,Q'(t),$$

and from these two, exactly as for $r=1$,

$$\frac{\partial\mathbf r^{[k-r]}}{\partial\tau}\times\frac{\partial\mathbf r^{[k-r]}}{\partial
t}=\frac{r\,(\tau-t)}{(k-r)^2}\,\frac{v^3}{V^3}\; R'(t)\times R''(t),$$

where $v$ and $V$ are the weights of $Q$ and of $P^{[r]}$, positive on the span.  So beside the diagonal the joint
solutions are the pairs for which *the member $\tau$ of the level before has no curvature at $t$*.  Nothing more can
be said in general: the curve may be convex and free of inflections, or a curve of space without any point of
vanishing curvature or torsion, and its members have them.
*/
#include "chapters/nurbs/family.h"

#include <string.h>

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch4:thm-4.3.3
:title: For every r the envelope is unique
:zh: 对任意 r 包络唯一
:printed: for every $r=1,2,\dots,k-2$ the envelope in (4.3.2) is unique: it is the segment $\mathbf r(t)$,
  $t_i\le t<t_{i+1}$, of the curve
:class: false
:refuted-by: convex_quartic_of_span_has_second_envelope twisted_sextic_has_second_envelope
:reading: convex_quartic_of_span_has_second_envelope | all joint solutions, for plane curves without inflections:
  a counterexample for $k=5$, $r=2$
:reading: twisted_sextic_has_second_envelope | all joint solutions, for curves of space with $\kappa\ne0$ and torsion
  $\ne0$ everywhere: a counterexample for $k=7$, $r=3$
:reading: solution_over_the_whole_span | only functions $\tau=\tau(t)$ defined on the whole span, as (4.3.16) may be
  meant: a counterexample for $k=6$, $r=3$, with an inflection
:reading: span_derivatives_are_parallel | only functions $\tau=\tau(t)$ that are continuous on the closed span, with values in it, for
  curves of plane or space with $\mathbf r'\times\mathbf r''\ne0$ on it | Beside $\tau=t$ the condition is $R'\times R''=0$ for the member of the level before, as what is corrected says;
  on the diagonal its derivatives are parallel to those of the curve, so that $R'\times R''$ is $\mathbf r'\times\mathbf r''$ times a factor which is not 0
  (`curvatures_have_a_fixed_ratio`).  So about a point of the diagonal $\tau=t$ is the only solution.  A continuous $\tau(t)$ of the closed span into itself has a
  point $\tau(t)=t$; the set of such points is closed in the span, and by what was said open in it: it is the whole span.
:reading-with: curvatures_have_a_fixed_ratio general_condition_is_that_of_the_level_before family_steps_along_the_tangent
  derivative_by_tau_is_that_of_the_level_before
:meant: (4.3.3) and (4.3.15), by which the section determines the envelope | The first and the second: all joint
  solutions.
:corrected: beside $\tau=t$ the joint solutions are the pairs for which the member of the level before, $R=\mathbf r^{[k-r+1]}(\cdot,\tau)$, has
  $R'\times R''=0$ at $t$; there are none if the control points of the span, in their order, are the corners of a strictly convex polygon of a plane
:corrected-by: general_condition_is_that_of_the_level_before family_steps_along_the_tangent
  derivative_by_tau_is_that_of_the_level_before convex_polygon_of_span_has_one_envelope
:confirmed-by: second_envelopes_of_spans member_of_span_is_polar
:striking: 2
:figure: nurbs_envelope_square

Printed is the span of $t_i$ for that of $t_j$, see `notation-4.3`.  As the polar form $f[\tau^r,t^{k-1-r}]$ says (`member_of_span_is_polar`), $r$ and $k-1-r$ have the same solutions
with $t$ and $\tau$ exchanged: for $r=k-2$ they are, beside $\tau=t$, the $\tau$ with $\mathbf r'(\tau)\times\mathbf r''(\tau)=0$, with any $t$.
:::

Two remarks on the polar form carry the section.  To replace one argument $t$ by $\tau$ is a step along the tangent of
the member before; and the derivative by $\tau$ of a form with $r$ equal arguments is $r$ times the derivative by one
of them, which the member before has as an argument $t$.  Both sides of each equation are computed by different
recursions.

:::{claim} family_steps_along_the_tangent
:title: A member is reached from that of the level before by a step along its tangent
:zh: 由上一层沿切线得到下一层
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, for $k\le4$ all
  patterns; weights and
  points, any $t$ and $\tau$, every $r=1,\dots,k-1$
:let: $P^{[r]}=(\mathbf p^{[r]},w^{[r]})$ of (4.3.17)
:where: the weights of the levels are not 0
:then: $P^{[r]}(t,\tau)=P^{[r-1]}(t,\tau)+\frac{\tau-t}{k-r}\partial_tP^{[r-1]}(t,\tau)$
:method: Both levels by (4.1.3), (4.1.4), the derivative by those of the B-splines; numerator and denominator.
:degrees: 1..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:argued: every order and all knots | With the polar form $f$ of the segment $P^{[r]}=f[\tau^r,t^{k-1-r}]$, which is affine in each argument: it is $f[\tau^{r-1},t^{k-r}]+(\tau-t)f[\tau^{r-1},t^{k-1-r},\delta]$,
  $\delta$ being the direction, and the derivative by $t$ of $f[\tau^{r-1},t^{k-r}]$ is $(k-r)f[\tau^{r-1},t^{k-1-r},\delta]$.
:control: the divisor $k-r+1$
:::
*/
CLAIM(family_steps_along_the_tangent)
{
    int p = T->degree, k = p + 1, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        G(knots_of_span)(T, p, shape, u, place);
        for (int r = 1; r <= k - 1; r++) {
            num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], S[2], Q[2], Q1[2];
            num step = div(sub(tau, t), from_int(fault(T, k - r, k - r + 1)));
            G(level_of_curve)(p, 1, u, mu, R, w, r, tau, Rr, wr);
            G(sums)(p - r, 1, u, mu, Rr, wr, t, S);
            G(level_of_curve)(p, 1, u, mu, R, w, r - 1, tau, Rr, wr);
            G(sums)(p - r + 1, 1, u, mu, Rr, wr, t, Q);
            G(derivative_sums)(p - r + 1, 1, u, mu, Rr, wr, t, Q1);
            for (int c = 0; c < 2; c++)
                /* P[r] = P[r-1] + (τ - t)/(k-r) ∂_t P[r-1] */
                same(T, S[c], add(Q[c], mul(step, Q1[c])));
        }
    }
}

/*
:::{claim} derivative_by_tau_is_that_of_the_level_before
:title: The derivative by τ is, up to a factor, the derivative by t of the level before
:zh: 对 τ 的偏导与上一层对 t 的偏导成比例
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, for $k\le4$ all
  patterns; any homogeneous
  coordinate of the points, any $t$ and $\tau$, every $r=1,\dots,k-1$
:let: $P^{[r]}=(\mathbf p^{[r]},w^{[r]})$ of (4.3.17)
:then: $\partial_\tau P^{[r]}(t,\tau)=\frac r{k-r}\,\partial_tP^{[r-1]}(t,\tau)$
:method: $P^{[r]}$ is a polynomial in $\tau$, whose Bézier points over the span are values of the polar form; the
  right side by the levels of de Boor's triangle and the derivatives of a segment.
:degrees: 1..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:argued: every order and all knots | With the polar form $f$ of the segment and the direction $\delta$: the derivative of $f[\tau^r,t^{k-1-r}]$ by $\tau$ is $r\,f[\tau^{r-1},t^{k-1-r},\delta]$, that of
  $f[\tau^{r-1},t^{k-r}]$ by $t$ is $(k-r)f[\tau^{r-1},t^{k-1-r},\delta]$.
:control: the factor $\frac{r}{k-r+1}$
:::
*/
CLAIM(derivative_by_tau_is_that_of_the_level_before)
{
    int p = T->degree, k = p + 1, mu = p;
    num u[MOST_KNOTS], H[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    for (int i = 0; i <= p; i++)
        H[i] = unknown(T, "H", i);
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num d[MAX_DEGREE + 1];
        G(knots_of_span)(T, p, shape, u, place);
        for (int i = 0; i <= p; i++)
            d[i] = H[i];
        num length = sub(u[mu + 1], u[mu]), local = div(sub(tau, u[mu]), length);
        for (int r = 1; r <= k - 1; r++) { /* d: the level r-1 */
            num b[MAX_DEGREE + 1], x[MAX_DEGREE], E[2], D[2];
            for (int i = 0; i <= r; i++) {
                for (int m = 0; m < p; m++)
                    x[m] = m < p - r ? t : u[m < p - i ? mu : mu + 1];
                G(bspline_blossom)(G(span_alone)(p, 1, u, mu, H), x, &b[i]);
            }
            G(bezier_derivatives)(r, 1, b, local, 1, E);
            G(bspline_derivatives)(G(span_alone)(p - r + 1, 1, u, mu, d), t, 1, D);
            /* ∂_τ P[r] = r/(k-r) ∂_t P[r-1] */
            same(T, div(E[1], length), mul(from_ratio(r, fault(T, k - r, k - r + 1)), D[1]));
            G(bspline_deboor_level)(G(on_span)(p, 1, u, mu, NULL), r, d, tau);
        }
    }
}

/*
With $Q$, $Q'$, $Q''$ as free vectors the rest is the quotient rule.  The result has the form of the first level, with
the member $\tau$ of the level before in the place of the curve.  For $r=1$ this member is the curve itself and does
not depend on $\tau$; for $r\ge2$ it does, and that makes the difference: the other factor is a curve in the square,
and not a set of lines $t=t_0$.

:::{claim} general_condition_is_that_of_the_level_before
:title: The condition of the envelope is (τ-t) R' x R'' of the level before
:zh: 包络条件等价于上一层族曲线的曲率为零
:given: the homogeneous vectors $Q,Q',Q''$ of a curve of space at $t$; any $\tau-t$, $r$ and $m=k-r$
:let: $P=Q+\frac{\tau-t}mQ'$, $P_t=\frac{m-1}mQ'+\frac{\tau-t}mQ''$, $P_\tau=\frac rmQ'$; $v$, $V$ the last
  coordinates of $Q$, $P$; $X$, $R$ the points of $P$, $Q$
:then: $X_\tau\times X_t=\frac{r(\tau-t)v^3}{m^2V^3}\,R'\times R''$
:method: The quotient rule for $X_\tau$, $X_t$, $R'$ and $R''$, three coordinates, everything a variable.  $P_t$ is
  the derivative of $P$; $P_\tau$ is what `derivative_by_tau_is_that_of_the_level_before` says.  With positive weights
  $v,V>0$ on the span.
:where: the weights of the level before and of the member are not 0
:degrees: all
:over: e: step from t to τ; m: -; Q# v#: derivatives of the level before
:control: $m$ in the place of $m^2$
:::
*/
CLAIM(general_condition_is_that_of_the_level_before)
{
    num Q[12], P[4], Pt[4], Ps[4], Xt[3], Xs[3], R[9], left[3], right[3], one = from_int(1);
    num e = unknown(T, "e", 0), r = parameter(T, "r"), m = add(parameter(T, "m"), one);
    for (int i = 0; i < 12; i++)
        Q[i] = i == 3 ? positive(T, "v", 0) : unknown(T, "Q", i);
    for (int c = 0; c < 4; c++) {
        P[c] = add(Q[c], mul(div(e, m), Q[4 + c]));
        Pt[c] = add(mul(div(sub(m, one), m), Q[4 + c]), mul(div(e, m), Q[8 + c]));
        Ps[c] = mul(div(r, m), Q[4 + c]);
    }
    G(rational_quotient_derivatives)(3, Q, 2, R);
    num V2 = mul(P[3], P[3]), v3 = mul(Q[3], mul(Q[3], Q[3]));
    for (int c = 0; c < 3; c++) {
        Xt[c] = div(sub(mul(Pt[c], P[3]), mul(P[c], Pt[3])), V2);
        Xs[c] = div(sub(mul(Ps[c], P[3]), mul(P[c], Ps[3])), V2);
    }
    G(cross3)(Xs, Xt, left);
    G(cross3)(R + 3, R + 6, right);
    num factor = div(mul(mul(r, e), v3), mul(fault(T, mul(m, m), m), mul(V2, P[3])));
    for (int c = 0; c < 3; c++)
        /* X_τ × X_t = r (τ - t) v³/(m² V³) R' × R'' */
        same(T, left[c], mul(factor, right[c]));
}

/*
:::{statement} wang-ch4:formula-4.3.15
:title: For every r the envelope is the joint solution of (4.3.3) and (4.3.15)
:zh: 一般 r 时包络为 (4.3.3) 与 (4.3.15) 的联合解
:printed: for $r\ge1$ the right side of (4.3.2) is the joint solution of (4.3.3) and
  $\frac{\partial\mathbf r^{[k-r]}(t,\tau)}{\partial\tau}\times\frac{\partial\mathbf
  r^{[k-r]}(t,\tau)}{\partial t}=\mathbf 0$, $t_j\le t,\tau<t_{j+1}$, $j=k,k+1,\dots,n$
:holds-by: touching_curve_satisfies_the_condition
:hypothesis: member_that_stands_still_is_not_touched | $\partial_t\mathbf r^{[k-r]}\ne0$; as for (4.3.9), which is $r=1$
:hypothesis: solutions_at_a_cusp_have_one_point | $\mathbf r^{[k-r]}$ is not constant on the solution; as for (4.3.9)
:hypothesis: member_of_an_inflection_is_a_solution | $\tau$ is not constant on the solution: otherwise it is one member, as for $r=k-2$ that of an
  inflection
:meant: the same notion as in (4.3.9) | A curve that passes from member to member and is tangent to each.
:confirmed-by: envelope_condition_holds_on_the_diagonal first_level_condition_factors
:figure: nurbs_envelope_square
:::

:::{statement} wang-ch4:formula-4.3.16
:title: The solutions as functions of t
:zh: 解写成 τ=τ(t)
:printed: in the joint solution of (4.3.3) and (4.3.15) $\tau=\tau(t)$
:reading: general_condition_is_that_of_the_level_before | it says which solutions are looked for: as an agreement it decides nothing, but then the
  pairs of a line $t=t_0$ are left out, as by (4.3.10); which pairs there are beside $\tau=t$, the condition $R'\times R''=0$ for the member
  $R=\mathbf r^{[k-r+1]}(\cdot,\tau)$ of the level before says
:reading-with: family_steps_along_the_tangent derivative_by_tau_is_that_of_the_level_before
:reading: inflected_cubic_has_second_envelope | it says that every joint solution has this form: for $r=1$ the lines $t=t_0$ with $\mathbf
  r'(t_0)\times\mathbf r''(t_0)=0$ do not
:reading: convex_quartic_of_span_has_second_envelope | it is $\tau=t$, as where the proof cites it: the quartic has a pair with $\tau\ne t$, one
  of those with $\tau(t)=-\frac1{4t}$ that `second_envelopes_of_spans` has
:confirmed-by: second_envelopes_of_spans first_level_condition_factors
:figure: nurbs_envelope_square

What the proof cites under this number is in `thm-4.3.3-alternatives`.
:::
*/

#if RATIONAL
/*
For $r=1$ the solutions beside the diagonal are lines $t=t_0$, on which $\tau$ runs through the members.  For $r=k-2$ they are lines $\tau=\tau_0$:
one member, all of it.

:::{claim} member_of_an_inflection_is_a_solution
:title: The member of an inflection satisfies the condition in all its points, and nothing else does about them
:zh: 拐点处的族曲线整条满足条件,附近别无他解
:kind: counterexample
:given: the cubic $\sum a_mt^m$, which is $(t,t^3)$, as a segment over the uniform knots $t_i$, weights 1; $r=2=k-2$, the member $\tau$ of its
  inflection, two of its parameters, $t$ and $t^*$, and other members $\sigma$
:data: t_i = -7 -5 -3 -1 1 3 5 7; a = (0,0) (1,0) (0,0) (0,1); t = 1/2; t* = -1/2; τ = 0; σ = -1/2 -1/4 1/4 3/4
:instead: a = (0,0) (1,0) (0,1) (0,0)
:then: (4.3.15) is satisfied on the whole member, where $\partial_tX\ne0$; at this $t$ it is not for any other member but that with $\tau=t$: so
  the solution about the pair is the member itself, and no curve that passes from member to member is tangent to one there
:result: r_i = (-3,-15) (-1,3) (1,-3) (3,15); point of the member = (1/6,0); its derivatives by t and τ = (1/3,0) (2/3,0); X_t × X_τ at t* =
  0; X_t × X_σ = -1/3 -1/8 1/24 -1/8
:method: $X$ is of degree 1 in $t$ and 2 in the parameter of the member.  So $X_t\times X_\tau$ is of degree 1 in $t$, and 0 for all $t$ if it is for
  two; and at one $t$ of degree 3 in the parameter $\sigma$ of the member: it is a multiple of $(\sigma-\tau)(t-\sigma)$ if it is at four $\sigma$.
:control: the parabola $(t,t^2)$, which has no inflection
:::
*/
CLAIM(member_of_an_inflection_is_a_solution)
{
    enum { OTHERS = 4 };
    num u[8], R[8], w[4], X[2], D[6], turn[OTHERS], sigma[OTHERS];
    num t = given(T, "t"), there = given(T, "t*"), tau = given(T, "τ"), factor = from_int(0);
    given_points(T, "σ", OTHERS, 1, sigma);
    G(given_curve_of_powers)(T, 3, 2, u, R, w);
    int satisfied = G(pair_in_the_square)(T, 3, 2, u, 3, R, w, 2, tau, t, X), others = 0;
    G(family_derivatives)(3, 2, u, 3, R, w, 2, tau, there, D);
    num once_more = G(cross2)(D + 2, D + 4);
    satisfied &= is_zero_q(once_more) && G(is_pair_of_span)(u, 3, there, tau) && (!is_zero_q(D[2]) || !is_zero_q(D[3]));
    for (int m = 0; m < OTHERS; m++) {
        G(family_derivatives)(3, 2, u, 3, R, w, 2, sigma[m], t, D);
        turn[m] = G(cross2)(D + 2, D + 4);
        num quotient = div(turn[m], mul(sub(sigma[m], tau), sub(t, sigma[m])));
        factor = m == 0 ? quotient : factor;
        others |= is_zero_q(factor) || !equal_q(quotient, factor);
    }
    found(T, "X_t × X_τ at t*", once_more);
    found_points(T, "X_t × X_σ", OTHERS, 1, turn);
    about(T,
          "a pair that satisfies the condition, X_t not being 0, is on a solution that passes from member to member");
    refute(T, satisfied && !others);
}
#endif

/*

The source derives the step from one level to the next by comparing the weights of two parameters, index by index.
The formulas are right but for the first index of two sums; at multiple knots they contain terms $0/0$, which stand for B-splines that vanish on the span.

:::{statement} wang-ch4:thm-4.3.3-difference
:title: How a weight of level r changes with its parameter
:zh: 第 r 层权随参数的变化
:printed: (t_{i+k-r}-t_i)(w_i^{[r]}(\tau)-w_i^{[r]}(t))=(\tau-t)(w_i^{[r-1]}(\tau)-w_{i-1}^{[r-1]}(\tau))+(t-t_i)(w_i^{[r-1]}(\tau)-w_i^{[r-1]}(t))
  +(t_{i+k-r}-t)(w_{i-1}^{[r-1]}(\tau)-w_{i-1}^{[r-1]}(t)),\quad i=j-k+r+1,j-k+r+2,\dots,j;\ t_i\le t,\tau<t_{i+1}
:holds-by: one_step_at_two_parameters divisors_contain_the_span
:confirmed-by: weights_of_two_parameters_differ_as_printed
:meant: (4.3.15) and the sums in which these weights stand, whose span is that of $t_j$ | The range is $t_j\le t,\tau<t_{j+1}$, see
  `notation-4.3`.
:figure: nurbs_envelope_square

The equation is true for any $t$ and $\tau$, also for those of the range that is printed.
:::

:::{claim} one_step_at_two_parameters
:title: One step of (4.1.3) at two parameters
:zh: (4.1.3) 的一步在两个参数下之差
:given: two knots $t_i\ne t_{i+k-r}$, any $t$ and $\tau$; any numbers for $w_{i-1}^{[r-1]}$ and $w_i^{[r-1]}$ at $\tau$, and any for them at $t$
:then: the printed equation for the $w_i^{[r]}(\tau)$ and $w_i^{[r]}(t)$ that (4.1.3) makes of them
:method: (4.1.3) by its letter, once at $\tau$ and once at $t$; everything a variable, so that it does not matter which order, level and index it is.  In the range of $i$ the
  two knots are different: `divisors_contain_the_span`.
:degrees: all
:over: u#: knots; h#: positive differences of two knots; w# v#: weights
:control: $t-\tau$ in the place of $\tau-t$ in the first term
:::
*/
CLAIM(one_step_at_two_parameters)
{
    num near = unknown(T, "u", 0), length = positive(T, "h", 0), far = add(near, length);
    num t = parameter(T, "t"), tau = parameter(T, "s"), at[2] = {tau, t}, step[2];
    num w[2][2]; /* w_{i-1} and w_i of level r-1, at τ and at t */
    for (int m = 0; m < 2; m++) {
        w[0][m] = unknown(T, "w", m);
        w[1][m] = unknown(T, "v", m);
    }
    for (int c = 0; c < 2; c++)
        step[c] = add(mul(div(sub(at[c], near), length), w[c][1]), mul(div(sub(far, at[c]), length), w[c][0]));
    num first = mul(sub(fault(T, tau, t), fault(T, t, tau)), sub(w[0][1], w[0][0]));
    num second = mul(sub(t, near), sub(w[0][1], w[1][1])), third = mul(sub(far, t), sub(w[0][0], w[1][0]));
    /* (t_i+k-r - t_i)(w_i[r](τ) - w_i[r](t)) = the three printed terms */
    same(T, mul(length, sub(step[0], step[1])), add(first, add(second, third)));
}

/*
:::{claim} weights_of_two_parameters_differ_as_printed
:title: The difference of the weights of two parameters
:zh: 两个参数下权之差
:given: order $k$; a span of simple knots, one whose ends are $(k-1)$-fold, one with a double knot, for $k\le4$ all patterns, the distinct knots
  variables for $k\le5$ and numbers above; weights, any $t$ and $\tau$, every $r=1,\dots,k-1$ and $i=j-k+r+1,\dots,j$
:then: the printed equation
:method: All levels by de Boor's recursion at $t$ and at $\tau$.
:degrees: 1..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:control: $t-\tau$ in the place of $\tau-t$ in the first term
:::
*/
CLAIM(weights_of_two_parameters_differ_as_printed)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], w[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    for (int i = 0; i <= p; i++)
        w[i] = positive(T, "w", i);
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num a[MAX_DEGREE + 1], b[MAX_DEGREE + 1]; /* the weights at tau and at t */
        G(knots_of_span)(T, p, shape, u, place);
        for (int i = 0; i <= p; i++)
            a[i] = b[i] = w[i];
        for (int r = 1; r <= p; r++) {
            num a1[MAX_DEGREE + 1], b1[MAX_DEGREE + 1];
            for (int i = 0; i <= p; i++) {
                a1[i] = a[i];
                b1[i] = b[i];
            }
            G(bspline_deboor_level)(G(on_span)(p, 1, u, mu, NULL), r, a, tau);
            G(bspline_deboor_level)(G(on_span)(p, 1, u, mu, NULL), r, b, t);
            for (int m = 0; m <= p - r; m++) {
                int i = mu - p + r + m, far = i + p + 1 - r;
                num first = mul(sub(fault(T, tau, t), fault(T, t, tau)), sub(a1[m + 1], a1[m]));
                num second = mul(sub(t, u[i]), sub(a1[m + 1], b1[m + 1])),
                    third = mul(sub(u[far], t), sub(a1[m], b1[m]));
                /* (t_i+k-r - t_i)(w_i[r](τ) - w_i[r](t)) = the three printed terms */
                same(T, mul(sub(u[far], u[i]), sub(a[m], b[m])), add(first, add(second, third)));
            }
        }
    }
}

/*
:::{statement} wang-ch4:thm-4.3.3-chain
:title: The denominator of level r by sums over level r-1
:zh: 第 r 层分母用第 r-1 层表示
:printed: \sum_{i=j-k+r+1}^jN_{i,k-r}(t)w_i^{[r]}(\tau)
  =\sum_{i=j-k+r}^jN_{i,k-r+1}(t)w_i^{[r-1]}(t)+\sum_{i=j-k+r+1}^jN_{i,k-r}(t)(w_i^{[r]}(\tau)-w_i^{[r]}(t))
  =\sum_{i=j-k+r}^jN_{i,k-r+1}(t)w_i^{[r-1]}(t)
  +(\tau-t)\sum_{i=j-k+r}^j\left[\frac{N_{i,k-r}(t)}{t_{i+k-r}-t_i}-\frac{N_{i+1,k-r}(t)}{t_{i+k-r+1}-t_{i+1}}\right]w_i^{[r-1]}(\tau)
  +\sum_{i=j-k+r}^j\left[\frac{t_{i+k-r+1}-t}{t_{i+k-r+1}-t_{i+1}}N_{i+1,k-r}(t)+\frac{t-t_i}{t_{i+k-r}-t_i}N_{i,k-r}(t)\right](w_i^{[r-1]}(\tau)-w_i^{[r-1]}(t))
  =\frac{\tau-t}{k-r}\sum_{i=i-k+r}^jN_{i,k-r+1}'(t)w_i^{[r-1]}(\tau)
  +\sum_{i=i-k+r}^jN_{i,k-r+1}(t)w_i^{[r-1]}(\tau),\quad t_j\le t,\tau\le t_{j+1}
:class: misprint
:refuted-by: sum_begins_at_no_index
:corrected: the last two sums begin at $i=j-k+r$, as those of the lines before
:corrected-by: level_by_sums_over_the_level_before
:reading: first_term_of_the_chain_divides_by_zero | with division by its letter, at multiple knots: the terms $i=j-k+r$
  and $i=j$ contain B-splines that vanish on the span over differences of knots that may be $0$; but by the usual agreement $0/0$ counts as $0$
:meant: the agreement that goes with the recursion of Cox and de Boor, (2.1.1), which is not in the text at hand: $0/0$ counts as $0$ | No division by its letter: a term with a B-spline that vanishes is
  left out.
:figure: divisor_zero

So corrected the display is true from end to end, with the polynomials of the span; at the right end $t_{j+1}$, which only this display
includes, the values are limits from the left.
:::

:::{claim} level_by_sums_over_the_level_before
:title: The three steps of the display
:zh: 所印等式链
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, for $k\le4$ all
  patterns; numbers for the weights, any $t$
  and $\tau$, every $r=1,\dots,k-2$
:then: each of the four expressions is equal to the first; 0/0 counts as 0
:method: Every expression by its letter, term by term.
:degrees: 2..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:argued: every order and all knots | The second expression is the first with (4.3.4) for one level.  The difference of the weights is that of `thm-4.3.3-difference`, divided by $t_{i+k-r}-t_i$; in the
  order of the $w_i^{[r-1]}$ it gives the third.  Its brackets are the derivative of $N_{i,k-r+1}$ divided by $k-r$, and $N_{i,k-r+1}$ by its recursion.
:control: the factor $\frac{\tau-t}{k-r}$ replaced by $\frac{\tau-t}{k-r+1}$ in the last
:::
*/
/* The value a/b of a term that contains a B-spline, 0/0 being 0: N is NULL outside the span's B-splines. */
static num G(quotient)(const num *N, num length) { return N == NULL ? from_int(0) : div(*N, length); }

/* The four expressions of the display for the numbers of two levels: a1, b1 those of level r-1 at τ and at t, a, b those of level r. */
static void G(check_chain)(trial *T, int p, const num u[], int r, num t, num tau, const num a1[], const num b1[],
                           const num a[], const num b[])
{
    int k = p + 1, mu = p, q = p - r; /* q: the degree of N_{i,k-r} */
    num N[MAX_DEGREE + 1], D[2 * (MAX_DEGREE + 1)], zero = from_int(0);
    G(bspline_basis)(q, u, mu, t, N);
    G(bspline_basis_derivatives)(q + 1, u, mu, t, 1, D);
    num first = zero, before = zero, change = zero, slope = zero, rest = zero, derivative = zero, last = zero;
    for (int m = 0; m <= q; m++) {
        first = add(first, mul(N[m], a[m]));
        change = add(change, mul(N[m], sub(a[m], b[m])));
    }
    for (int m = 0; m <= q + 1; m++) { /* i = j-k+r+m */
        int i = mu - q - 1 + m;
        const num *here = m > 0 ? &N[m - 1] : NULL, *next = m <= q ? &N[m] : NULL; /* N_{i,k-r}, N_{i+1,k-r} */
        num length = here ? sub(u[i + q + 1], u[i]) : zero, after = next ? sub(u[i + q + 2], u[i + 1]) : zero;
        num left = G(quotient)(here, length), right = G(quotient)(next, after);
        before = add(before, mul(D[m], b1[m]));
        slope = add(slope, mul(sub(left, right), a1[m]));
        num both = zero;
        if (next)
            both = add(both, mul(sub(u[i + q + 2], t), right));
        if (here)
            both = add(both, mul(sub(t, u[i]), left));
        rest = add(rest, mul(both, sub(a1[m], b1[m])));
        derivative = add(derivative, mul(D[q + 2 + m], a1[m]));
        last = add(last, mul(D[m], a1[m]));
    }
    num e = sub(tau, t);
    about(T, "the second expression");
    same(T, first, add(before, change));
    about(T, "the third expression");
    same(T, first, add(before, add(mul(e, slope), rest)));
    about(T, "the fourth expression");
    same(T, first, add(mul(div(e, from_int(fault(T, k - r, k - r + 1))), derivative), last));
}

CLAIM(level_by_sums_over_the_level_before)
{
    int p = T->degree, k = p + 1, mu = p;
    num u[MOST_KNOTS], w[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    for (int i = 0; i <= p; i++)
        w[i] = positive(T, "w", i);
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num a[MAX_DEGREE + 1], b[MAX_DEGREE + 1];
        G(knots_of_span)(T, p, shape, u, place);
        for (int i = 0; i <= p; i++)
            a[i] = b[i] = w[i];
        for (int r = 1; r <= k - 2; r++) {
            num a1[MAX_DEGREE + 1], b1[MAX_DEGREE + 1];
            for (int i = 0; i <= p; i++) {
                a1[i] = a[i];
                b1[i] = b[i];
            }
            G(bspline_deboor_level)(G(on_span)(p, 1, u, mu, NULL), r, a, tau);
            G(bspline_deboor_level)(G(on_span)(p, 1, u, mu, NULL), r, b, t);
            G(check_chain)(T, p, u, r, t, tau, a1, b1, a, b);
        }
    }
}

/*
:::{claim} weighted_points_by_sums_over_the_level_before
:title: The same steps with the weighted points
:zh: 对加权顶点的同样等式链
:given: order $k$; knots of a span that are simple, or with $(k-1)$-fold ends, or with one double knot, for $k\le4$ all
  patterns; weights and
  points, any $t$ and $\tau$, every $r=1,\dots,k-2$
:where: the weights of the levels are not 0
:then: with $w_i^{[r]}\mathbf r_i^{[r]}$ and $w_i^{[r-1]}\mathbf r_i^{[r-1]}$ for the weights each of the four expressions is equal to the first; 0/0 counts as 0
:method: The points by (4.1.4), which divides by weights; every expression by its letter, term by term.  A coordinate is any coordinate, so one suffices.
:degrees: 2..6 sampled 7
:scope: every pattern of the knots of a span up to order 4, three above; the distinct knots variables up to order 5, numbers above
:argued: every order and all knots | By (4.1.4) the products $w_i^{[r]}\mathbf r_i^{[r]}$ follow the recursion (4.1.3) of the weights, from which alone the steps were made.
:control: the factor $\frac{\tau-t}{k-r}$ replaced by $\frac{\tau-t}{k-r+1}$ in the last
:::
*/
CLAIM(weighted_points_by_sums_over_the_level_before)
{
    int p = T->degree, k = p + 1;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t"), at[2] = {parameter(T, "s"), t};
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    for (int shape = 0; shape < G(shapes)(p); shape++) {
        num d[2][MAX_DEGREE + 1]; /* the products w_i r_i of a level, at τ and at t */
        G(knots_of_span)(T, p, shape, u, place);
        for (int i = 0; i <= p; i++)
            d[0][i] = d[1][i] = mul(w[i], R[i]);
        for (int r = 1; r <= k - 2; r++) {
            num before[2][MAX_DEGREE + 1], Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1];
            for (int c = 0; c < 2; c++) {
                G(level_of_curve)(p, 1, u, p, R, w, r, at[c], Rr, wr);
                for (int i = 0; i <= p; i++)
                    before[c][i] = d[c][i];
                for (int i = 0; i <= p - r; i++)
                    d[c][i] = mul(wr[i], Rr[i]);
            }
            G(check_chain)(T, p, u, r, at[1], at[0], before[0], before[1], d[0], d[1]);
        }
    }
}

#if RATIONAL
/*
:::{claim} first_term_of_the_chain_divides_by_zero
:title: The display divides 0 by 0 at a multiple knot
:zh: 重节点处所印等式出现 0/0
:kind: counterexample
:given: a cubic span $[t_j,t_{j+1})$, $j=k$, of the knots $t_i$, $t_j$ being triple; $r$
:data: k = 4; r = 2; t_i = 0 3 3 3 4 5 6 7
:instead: t_i = 0 1 2 3 4 5 6 7
:then: a divisor $t_{i+k-r}-t_i$ with $j-k+r\le i\le j+1$ is 0
:result: divisors that are 0 = 1; i = 2
:method: All these divisors are computed; that none is 0 is what is compared.
:control: simple knots
:::
*/
CLAIM(first_term_of_the_chain_divides_by_zero)
{
    enum { MOST = 8 };
    int k = given_whole(T, "k"), r = given_whole(T, "r"), j = k, zeros = 0, index = 0;
    num t[MOST + 1];
    given_points(T, "t_i", 2 * k, 1, t + 1);
    for (int i = j - k + r; i <= j + 1; i++)
        if (is_zero_q(sub(t[i + k - r], t[i]))) {
            zeros++;
            index = i;
        }
    found_whole(T, "divisors that are 0", zeros);
    found_whole(T, "i", index);
    about(T, "no divisor is 0");
    refute(T, zeros > 0);
}
#endif

/*
:::{statement} wang-ch4:notation-4.3
:title: The letter of the span in theorem 4.3.3 and its proof
:zh: 区间端点的字母
:printed: $t_i\le t<t_{i+1}$ in theorem 4.3.3, and $t_i\le t,\tau<t_{i+1}$ with the difference of the weights, in (4.3.17) and with the products of level $r-2$
:class: misprint
:refuted-by: span_has_the_letter_of_the_sum
:corrected: $t_j\le t<t_{j+1}$, and $t_j\le t,\tau<t_{j+1}$
:corrected-by: span_has_its_own_letter

$j$ is the number of the span, $i$ that of a term of the sums.
:::
*/

#if RATIONAL
/*
:::{claim} sum_begins_at_no_index
:title: No index i is i-k+r for r < k
:zh: 求和下限 i=i-k+r 无意义
:kind: counterexample
:given: $k$, $r$, $j$ and an index $i$; the lower limit of the sum taken from $i$, as printed
:data: k = 4; r = 2; j = 6; i = 4
:then: $i$ is not $i-k+r$, so that the sum has no first term
:result: lower limit = 2
:method: The lower limit is computed and compared with $i$.
:control: the lower limit taken from $j$
:::
*/
CLAIM(sum_begins_at_no_index)
{
    int k = given_whole(T, "k"), r = given_whole(T, "r"), j = given_whole(T, "j"), i = given_whole(T, "i");
    int lower = fault(T, j, i) - k + r;
    found_whole(T, "lower limit", lower);
    about(T, "the index and the lower limit");
    same(T, from_int(i), from_int(lower));
}

/* Whether the span has the letter of the span in each of four places. */
static int spans_have_their_letter(trial *T)
{
    static const char *const place[] = {"theorem 4.3.3", "difference of the weights", "(4.3.17)",
                                        "products of level r-2"};
    int all = 1;
    for (int m = 0; m < 4; m++)
        all &= strcmp(given_text(T, place[m]), "t_j") == 0;
    about(T, "the span begins with t_j");
    return all;
}

/*
:::{claim} span_has_the_letter_of_the_sum
:title: In four places the span has the letter of the sums
:zh: 四处区间用了求和下标
:kind: counterexample
:given: the knot with which the span begins, in four places; everywhere else in section 4.3.2 it is $t_j$
:data: theorem 4.3.3 = "t_i"; difference of the weights = "t_i"; (4.3.17) = "t_i"; products of level r-2 = "t_i"
:instead: theorem 4.3.3 = "t_j"; difference of the weights = "t_j"; (4.3.17) = "t_j"; products of level r-2 = "t_j"
:then: none of the four is $t_j$
:method: Place by place.
:control: the four letters corrected
:::
*/
CLAIM(span_has_the_letter_of_the_sum) { agree(T, spans_have_their_letter(T)); }

/*
:::{claim} span_has_its_own_letter
:title: With the letters corrected the span is that of the other formulas
:zh: 更正后区间一致
:kind: decision
:given: the four letters, corrected
:data: theorem 4.3.3 = "t_j"; difference of the weights = "t_j"; (4.3.17) = "t_j"; products of level r-2 = "t_j"
:instead: theorem 4.3.3 = "t_i"; difference of the weights = "t_i"; (4.3.17) = "t_i"; products of level r-2 = "t_i"
:then: each is $t_j$
:method: Place by place.
:scope: the four places
:control: the letters as printed
:::
*/
CLAIM(span_has_its_own_letter) { agree(T, spans_have_their_letter(T)); }
#endif

/*
:::{statement} wang-ch4:thm-4.3.3-numerator
:title: The same for the numerators
:zh: 分子的类似等式
:printed: with $w_i^{[r]}(\tau)\mathbf r_i^{[r]}(\tau)$ in the place of $w_i^{[r]}(\tau)$ a similar equation holds
:holds-by: weighted_points_by_sums_over_the_level_before
:confirmed-by: family_steps_along_the_tangent level_by_sums_over_the_level_before extrapolated_members_keep_positive_weights_inside
:meant: the equation that is varied, `thm-4.3.3-chain` | The last two sums begin at $i=j-k+r$, and $0/0$ counts as $0$, as in that equation put right.
:figure: nurbs_envelope_square

Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span:
`extrapolated_members_keep_positive_weights_inside`.
:::

:::{statement} wang-ch4:formula-4.3.17
:title: Denominator and numerator of the member of level r-1
:zh: 第 r-1 层的分母与分子
:printed: w^{[r-1]}(t,\tau)=\sum_{i=j-k+r}^jN_{i,k-r+1}(t)w_i^{[r-1]}(\tau),\qquad\mathbf
  p^{[r-1]}(t,\tau)=\sum_{i=j-k+r}^jN_{i,k-r+1}(t)w_i^{[r-1]}(\tau)\mathbf r_i^{[r-1]}(\tau),\quad t_i\le t,\tau<t_{i+1}
:definition: yes
:checked-by: member_of_span_is_polar
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:meant: the sums, whose span is that of $t_j$ | The range is $t_j\le t,\tau<t_{j+1}$, see `notation-4.3`.
:figure: order_and_level

Their quotient is $\mathbf r^{[k-r+1]}(t,\tau)$ of (4.3.3): here the superscript counts levels, there it is the order.
Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span:
`extrapolated_members_keep_positive_weights_inside`.
:::

:::{statement} wang-ch4:formula-4.3.18
:title: From one level to the next
:zh: 相邻两层的递推
:printed: w^{[r]}(t,\tau)=\frac{\tau-t}{k-r}\frac\partial{\partial t}w^{[r-1]}(t,\tau)+w^{[r-1]}(t,\tau),\qquad\mathbf
  p^{[r]}(t,\tau)=\frac{\tau-t}{k-r}\frac\partial{\partial t}\mathbf p^{[r-1]}(t,\tau)+\mathbf p^{[r-1]}(t,\tau),\quad t_j\le t,\tau<t_{j+1},\ j=k,k+1,\dots,n
:holds-by: family_steps_along_the_tangent
:confirmed-by: extrapolated_members_keep_positive_weights_inside
:figure: nurbs_envelope_square

Positive weights $w_i$ make the weights of the levels and of the member positive for $t$ and $\tau$ in the span:
`extrapolated_members_keep_positive_weights_inside`.
:::
*/

#include "chapters/judge/claims_off.h"
