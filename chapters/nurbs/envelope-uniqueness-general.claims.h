/*
# Is the envelope unique? Every level (包络的唯一性: 任意 r)

For $r\ge2$ the source repeats the proof of $r=1$ with the member of level $r-1$ in the place of the curve.  Two things of this idea are true and
decide the question.  Write $Q(t)=P^{[r-1]}(t,\tau)$ for the member of level $r-1$ with the parameter $\tau$, in homogeneous coordinates, and
$R$ for its points.  Then

$$P^{[r]}(t,\tau)=Q(t)+\frac{\tau-t}{k-r}\,Q'(t),\qquad\frac{\partial P^{[r]}}{\partial\tau}(t,\tau)=\frac r{k-r}\,Q'(t),$$

and from these two, exactly as for $r=1$,

$$\frac{\partial\mathbf r^{[k-r]}}{\partial\tau}\times\frac{\partial\mathbf r^{[k-r]}}{\partial t}=\frac{r\,(\tau-t)}{(k-r)^2}\,\frac{v^3}{V^3}\;
R'(t)\times R''(t),$$

where $v$ and $V$ are the weights of $Q$ and of $P^{[r]}$, positive on the span.  So beside the diagonal the joint solutions are the pairs for which
*the member $\tau$ of the level before has no curvature at $t$*.  Nothing more can be said in general: the curve may be
convex and free of inflections, or a curve of space without any point of vanishing curvature or torsion, and its members have them.

:::{statement} wang-ch4:thm-4.3.3
:title: For every r the envelope is unique
:zh: 对任意 r 包络唯一
:printed: for every $r=1,2,\dots,k-2$ the envelope in (4.3.2) is unique: it is the segment $\mathbf r(t)$, $t_j\le t<t_{j+1}$, of the curve
:class: false
:refuted-by: convex_quartic_of_span_has_second_envelope twisted_sextic_has_second_envelope
:reading: convex_quartic_of_span_has_second_envelope | all joint solutions, for plane curves without inflections: false for $k=5$, $r=2$
:reading: twisted_sextic_has_second_envelope | all joint solutions, for curves of space with $\kappa\ne0$ and torsion $\ne0$ everywhere: false for
  $k=7$, $r=3$
:reading: solution_over_the_whole_span | only functions $\tau=\tau(t)$ defined on the whole span, as (4.3.16) may be meant: false for $k=6$, $r=3$, with an
  inflection
:reading: curvatures_have_a_fixed_ratio | the same for plane segments without an inflection in the closed span, $\tau(t)$ continuous on it: true; there is a
  fixed point $\tau(t)=t$, and a second solution through it needs $\mathbf r'\times\mathbf r''=0$ there
:corrected: beside $\tau=t$ the joint solutions are the pairs for which the member $\tau$ of order $k-r+1$ has $R'\times R''=0$ at $t$; there are none if
  the control polygon of the span is plane and strictly convex
:corrected-by: general_condition_is_that_of_the_level_before family_steps_along_the_tangent derivative_by_tau_is_that_of_the_level_before
  convex_polygon_of_span_has_one_envelope
:figure: nurbs_envelope_square
:striking: 2

For $r=k-2$ the level before consists of conics: a conic without curvature is a line or a point, and it is one when $\mathbf r'\times\mathbf r''=0$ at
$\tau$.  For plane curves $r$ and $k-1-r$ have the same solutions with $t$ and $\tau$ exchanged.  In space two equations have to be fulfilled, so as a rule single
pairs are left and no curve; for $k=7$ there can be a curve.
:::

:::{statement} wang-ch4:formula-4.3.15
:title: The condition of the envelope for every r
:zh: 一般 r 的包络条件
:printed: \frac{\partial\mathbf r^{[k-r]}(t,\tau)}{\partial\tau}\times\frac{\partial\mathbf r^{[k-r]}(t,\tau)}{\partial t}=\mathbf 0,\quad t_j\le
  t,\tau<t_{j+1},\ j=k,k+1,\dots,n
:definition: yes
:checked-by: touching_curve_satisfies_the_condition envelope_condition_holds_on_the_diagonal
:::

:::{statement} wang-ch4:formula-4.3.16
:title: The solutions as functions of t, and as an alternative
:zh: 解写成 τ=τ(t)
:printed: \tau=\tau(t)
:class: misprint
:refuted-by: convex_quartic_of_span_has_second_envelope
:corrected: in the alternative "(4.3.16) or the sum vanishes" it should be $\tau=t$, (4.3.11)
:corrected-by: general_condition_is_that_of_the_level_before

As the form of a solution it says nothing; as an alternative it is cited where $\tau=t$ is meant, and then it excludes too little: with
$\tau(t)=-\frac1{4t}$ the quartic has another solution of this form.
:::

:::{statement} wang-ch4:thm-4.3.3-difference
:title: How a weight of level r changes with its parameter
:zh: 第 r 层权随参数的变化
:printed: (t_{i+k-r}-t_i)(w_i^{[r]}(\tau)-w_i^{[r]}(t))=(\tau-t)(w_i^{[r-1]}(\tau)-w_{i-1}^{[r-1]}(\tau))+(t-t_i)(w_i^{[r-1]}(\tau)-w_i^{[r-1]}(t))
  +(t_{i+k-r}-t)(w_{i-1}^{[r-1]}(\tau)-w_{i-1}^{[r-1]}(t))
:holds-by: weights_of_two_parameters_differ_as_printed
:::

:::{statement} wang-ch4:thm-4.3.3-chain
:title: The denominator of level r by sums over level r-1
:zh: 第 r 层分母用第 r-1 层表示
:printed: \sum_{i=j-k+r+1}^jN_{i,k-r}(t)w_i^{[r]}(\tau)=\dots=\frac{\tau-t}{k-r}\sum_{i=j-k+r}^jN_{i,k-r+1}'(t)w_i^{[r-1]}(\tau)
  +\sum_{i=j-k+r}^jN_{i,k-r+1}(t)w_i^{[r-1]}(\tau),\quad t_j\le t,\tau\le t_{j+1}
:holds-by: level_by_sums_over_the_level_before
:hypothesis: first_term_of_the_chain_divides_by_zero | a quotient 0/0 counts as 0; the terms $i=j-k+r$ and $i=j$ contain B-splines that vanish on the span,
  divided by differences of knots that may be 0

All four lines are true, with the polynomials of the span; at the right end $t_{j+1}$, which only this display includes, the values are limits from the left.
:::

:::{statement} wang-ch4:thm-4.3.3-numerator
:title: The same for the numerators
:zh: 分子的类似等式
:printed: with $w_i^{[r]}(\tau)\mathbf r_i^{[r]}(\tau)$ in the place of $w_i^{[r]}(\tau)$ a similar equation holds
:holds-by: family_steps_along_the_tangent
:::

:::{statement} wang-ch4:formula-4.3.17
:title: Denominator and numerator of the member of level r-1
:zh: 第 r-1 层的分母与分子
:printed: w^{[r-1]}(t,\tau)=\sum_{i=j-k+r}^jN_{i,k-r+1}(t)w_i^{[r-1]}(\tau),\qquad\mathbf p^{[r-1]}(t,\tau)=\sum_{i=j-k+r}^jN_{i,k-r+1}(t)w_i^{[r-1]}(\tau)\mathbf
  r_i^{[r-1]}(\tau)
:definition: yes
:checked-by: member_of_span_is_polar

Their quotient is $\mathbf r^{[k-r+1]}(t,\tau)$ of (4.3.3): here the superscript counts levels, there it is the order.
:::

:::{statement} wang-ch4:formula-4.3.18
:title: From one level to the next
:zh: 相邻两层的递推
:printed: w^{[r]}(t,\tau)=\frac{\tau-t}{k-r}\frac\partial{\partial t}w^{[r-1]}(t,\tau)+w^{[r-1]}(t,\tau),\qquad\mathbf p^{[r]}(t,\tau)=\frac{\tau-t}{k-r}\frac\partial{\partial
  t}\mathbf p^{[r-1]}(t,\tau)+\mathbf p^{[r-1]}(t,\tau)
:holds-by: family_steps_along_the_tangent
:::

:::{claim} weights_of_two_parameters_differ_as_printed
:title: The difference of the weights of two parameters
:zh: 两个参数下权之差
:given: $k=p+1$; a span of simple knots, one whose ends are $(k-1)$-fold, one with a double knot, the distinct knots variables for $k\le4$ and numbers
  above; weights, any $t$ and $\tau$, every $r=1,\dots,k-1$ and $i=j-k+r+1,\dots,j$
:then: the printed equation
:method: All levels by de Boor's recursion at $t$ and at $\tau$.
:degrees: 1..4 sampled 7
:control: $t$ in the place of $\tau$ in the first term
:::

:::{claim} level_by_sums_over_the_level_before
:title: The three steps of the display
:zh: 所印等式链
:given: $k=p+1$; knots of these three shapes; weights, any $t$ and $\tau$, every $r=1,\dots,k-2$
:then: each of the four expressions is equal to the first; 0/0 counts as 0
:method: Every expression by its letter, term by term.
:degrees: 2..4 sampled 7
:control: the factor $\frac{\tau-t}{k-r}$ replaced by $\frac{\tau-t}{k-r+1}$ in the last
:::

:::{claim} family_steps_along_the_tangent
:title: A member is reached from that of the level before by a step along its tangent
:zh: 由上一层沿切线得到下一层
:given: $k=p+1$; knots of these three shapes; weights and points, any $t$ and $\tau$, every $r=1,\dots,k-1$
:then: $P^{[r]}(t,\tau)=P^{[r-1]}(t,\tau)+\frac{\tau-t}{k-r}\partial_tP^{[r-1]}(t,\tau)$
:method: Both levels by (4.1.3), (4.1.4), the derivative by those of the B-splines; numerator and denominator.
:degrees: 1..4 sampled 7
:control: the divisor $k-r+1$
:::

:::{claim} derivative_by_tau_is_that_of_the_level_before
:title: The derivative by τ is, up to a factor, the derivative by t of the level before
:zh: 对 τ 的偏导与上一层对 t 的偏导成比例
:given: $k=p+1$; knots of these three shapes; any homogeneous coordinate of the points, any $t$ and $\tau$, every $r=1,\dots,k-1$
:then: $\partial_\tau P^{[r]}(t,\tau)=\frac r{k-r}\,\partial_tP^{[r-1]}(t,\tau)$
:method: $P^{[r]}$ is a polynomial in $\tau$, whose Bézier points over the span are values of the polar form; the right side by the levels of de Boor's triangle and
  the derivatives of a segment.
:degrees: 1..4 sampled 7
:control: the factor $\frac{r}{k-r+1}$
:::

:::{claim} general_condition_is_that_of_the_level_before
:title: The condition of the envelope is (τ-t) R' x R'' of the level before
:zh: 包络条件等价于上一层族曲线的曲率为零
:given: the homogeneous vectors $Q,Q',Q''$ of a curve of space at $t$; any $\tau-t$, $r$ and $m=k-r$
:let: $P=Q+\frac{\tau-t}mQ'$, $P_t=\frac{m-1}mQ'+\frac{\tau-t}mQ''$, $P_\tau=\frac rmQ'$; $v$, $V$ the last coordinates of $Q$, $P$; $X$, $R$ the points of $P$, $Q$
:then: $X_\tau\times X_t=\frac{r(\tau-t)v^3}{m^2V^3}\,R'\times R''$
:method: The quotient rule for $X_\tau$, $X_t$, $R'$ and $R''$, three coordinates, everything a variable.  $P_t$ is the derivative of $P$; $P_\tau$ is what
  `derivative_by_tau_is_that_of_the_level_before` says.  With positive weights $v,V>0$ on the span.
:degrees: all
:control: $m$ in the place of $m^2$
:::
*/
#include "chapters/nurbs/family.h"

#include "exact/sign.h"

#include "chapters/frame/claims_on.h"

CLAIM(weights_of_two_parameters_differ_as_printed)
{
    int p = T->degree, mu = p;
    num u[MOST_KNOTS], w[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    for (int i = 0; i <= p; i++)
        w[i] = positive(T, "w", i);
    for (int shape = 0; shape < SHAPES; shape++) {
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
            G(deboor_level)(p, 1, u, mu, r, a, tau);
            G(deboor_level)(p, 1, u, mu, r, b, t);
            for (int m = 0; m <= p - r; m++) {
                int i = mu - p + r + m, far = i + p + 1 - r;
                num first = mul(sub(T->planted ? t : tau, T->planted ? tau : t), sub(a1[m + 1], a1[m]));
                num second = mul(sub(t, u[i]), sub(a1[m + 1], b1[m + 1])), third = mul(sub(u[far], t), sub(a1[m], b1[m]));
                same(T, mul(sub(u[far], u[i]), sub(a[m], b[m])), add(first, add(second, third)));
            }
        }
    }
}

/* The value a/b of a term that contains a B-spline, 0/0 being 0: N is NULL outside the span's B-splines. */
static num G(quotient)(const num *N, num length) { return N == NULL ? from_int(0) : div(*N, length); }

CLAIM(level_by_sums_over_the_level_before)
{
    int p = T->degree, k = p + 1, mu = p;
    num u[MOST_KNOTS], w[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s"), zero = from_int(0);
    int place[MOST_KNOTS];
    for (int i = 0; i <= p; i++)
        w[i] = positive(T, "w", i);
    for (int shape = 0; shape < SHAPES; shape++) {
        num a[MAX_DEGREE + 1], b[MAX_DEGREE + 1];
        G(knots_of_span)(T, p, shape, u, place);
        for (int i = 0; i <= p; i++)
            a[i] = b[i] = w[i];
        for (int r = 1; r <= k - 2; r++) {
            int q = p - r; /* the degree of N_{i,k-r} */
            num a1[MAX_DEGREE + 1], b1[MAX_DEGREE + 1], N[MAX_DEGREE + 1], D[2 * (MAX_DEGREE + 1)];
            for (int i = 0; i <= p; i++) {
                a1[i] = a[i];
                b1[i] = b[i];
            }
            G(deboor_level)(p, 1, u, mu, r, a, tau);
            G(deboor_level)(p, 1, u, mu, r, b, t);
            G(bspline_basis)(q, u, mu, t, N);
            G(bspline_basis_derivatives)(q + 1, u, mu, t, 2, D);
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
            same(T, first, add(mul(div(e, from_int(T->planted ? k - r + 1 : k - r)), derivative), last));
        }
    }
}

CLAIM(family_steps_along_the_tangent)
{
    int p = T->degree, k = p + 1, mu = p;
    num u[MOST_KNOTS], R[MAX_DEGREE + 1], w[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    G(free_curve)(T, p, 1, R, w);
    for (int shape = 0; shape < SHAPES; shape++) {
        G(knots_of_span)(T, p, shape, u, place);
        for (int r = 1; r <= k - 1; r++) {
            num Rr[MAX_DEGREE + 1], wr[MAX_DEGREE + 1], S[2], Q[2], Q1[2];
            num step = div(sub(tau, t), from_int(T->planted ? k - r + 1 : k - r));
            G(level_of_curve)(p, 1, u, mu, R, w, r, tau, Rr, wr);
            G(sums)(p - r, 1, u, mu, Rr, wr, t, S);
            G(level_of_curve)(p, 1, u, mu, R, w, r - 1, tau, Rr, wr);
            G(sums)(p - r + 1, 1, u, mu, Rr, wr, t, Q);
            G(derivative_sums)(p - r + 1, 1, u, mu, Rr, wr, t, Q1);
            for (int c = 0; c < 2; c++)
                same(T, S[c], add(Q[c], mul(step, Q1[c])));
        }
    }
}

CLAIM(derivative_by_tau_is_that_of_the_level_before)
{
    int p = T->degree, k = p + 1, mu = p;
    num u[MOST_KNOTS], H[MAX_DEGREE + 1], t = parameter(T, "t"), tau = parameter(T, "s");
    int place[MOST_KNOTS];
    for (int i = 0; i <= p; i++)
        H[i] = unknown(T, "H", i);
    for (int shape = 0; shape < SHAPES; shape++) {
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
                G(blossom_of_span)(p, 1, u, mu, H, x, &b[i]);
            }
            G(bezier_derivatives)(r, 1, b, local, 1, E);
            G(derivatives_of_span)(p - r + 1, 1, u, mu, d, t, 2, D);
            same(T, div(E[1], length), mul(from_ratio(r, T->planted ? k - r + 1 : k - r), D[1]));
            G(deboor_level)(p, 1, u, mu, r, d, tau);
        }
    }
}

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
    G(quotient_derivatives)(3, Q, 2, R);
    num V2 = mul(P[3], P[3]), v3 = mul(Q[3], mul(Q[3], Q[3]));
    for (int c = 0; c < 3; c++) {
        Xt[c] = div(sub(mul(Pt[c], P[3]), mul(P[c], Pt[3])), V2);
        Xs[c] = div(sub(mul(Ps[c], P[3]), mul(P[c], Ps[3])), V2);
    }
    G(cross3)(Xs, Xt, left);
    G(cross3)(R + 3, R + 6, right);
    num factor = div(mul(mul(r, e), v3), mul(T->planted ? m : mul(m, m), mul(V2, P[3])));
    for (int c = 0; c < 3; c++)
        same(T, left[c], mul(factor, right[c]));
}

#if RATIONAL
/*
:::{claim} first_term_of_the_chain_divides_by_zero
:title: The display divides 0 by 0 at a multiple knot
:zh: 重节点处所印等式出现 0/0
:kind: counterexample
:given: $k=4$, the span $[3,4)$ of the knots $0,1,3,3,4,5,6,7$, $t_4=3$ being double; $r=2$, $i=j-k+r=2$... shown
:then: a divisor $t_{i+k-r}-t_i$ with $j-k+r\le i\le j$ is 0
:method: All divisors of the third line are computed; that none is 0 is what is compared.
:control: the knots $0,1,2,3,\dots,7$
:::
*/
CLAIM(first_term_of_the_chain_divides_by_zero)
{
    /* t_1, ..., t_8; j = 4 */
    int t[8] = {0, 1, T->planted ? 2 : 3, 3, 4, 5, 6, 7}, k = 4, j = 4, zero = 0;
    for (int r = 2; r <= k - 2 + 1; r++)
        for (int i = j - k + r; i <= j; i++)
            if (t[i + k - r - 1] == t[i - 1]) {
                show_text(T, "r, i", "%d, %d", r, i);
                zero = 1;
            }
    about(T, "no divisor is 0");
    agree(T, !zero);
}
#endif
#include "chapters/frame/claims_off.h"
