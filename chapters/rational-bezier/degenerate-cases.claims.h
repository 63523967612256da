/*
# Polynomial curves as rational ones (退化与还原)

The polynomial Bézier curves are among the rational ones: equal weights cancel.  In the other direction,
a change of parameter turns a polynomial curve into one with geometric weights, and no other weights
arise so.
*/
#include "exact/record/polynomial.h"

#include "chapters/judge/elementary.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch3:prop-3.2.11
:title: Equal weights give a Bézier curve
:zh: 可退化性:权相等时为 Bézier 曲线
:printed: When the weights are $\omega_i=\omega$, $i=0,1,\dots,n$, the curve (3.2.2) degenerates to the Bézier curve (1.3.2).
:holds-by: change_of_parameter_acts_on_one_factor mean_grows_by_one_term bernstein_sum_of_powers_is_a_power
:confirmed-by: equal_weights_give_polynomial_curve
:meant: the words: for equal weights it degenerates | One direction; the converse is not said.
:needs: weights_that_are_zero_have_no_curve | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the common weight is not 0
:reading: polynomial_line_with_unequal_weights | "exactly when" it is a polynomial curve, of whatever points: not claimed
:reading: products_of_coefficients_are_not_those_of_the_product | "exactly when" it is the Bézier curve of its own points $R_i$: not claimed either, but true unless all points
  coincide
:figure: equal_weights

Besides $\omega>0$ any $\omega\ne0$ will do.
:::

:::{claim} equal_weights_give_polynomial_curve
:title: With equal weights the curve is the Bézier curve of its points
:zh: 权相等时退化为 Bézier 曲线
:given: points $R_0,\dots,R_n$ and one weight $\omega\ne0$
:where: the common weight is not 0
:then: $R(t)=\sum B_i^n(t)R_i$ for every $t$
:method: The left side is computed as a rational curve, the right side with the Bernstein polynomials; both are
  rational functions of $t$, $\omega$ and the points.
:degrees: 1..8 sampled 16
:control: $\omega_1$ doubled
:::
*/
CLAIM(equal_weights_give_polynomial_curve)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], R[MAX_DEGREE + 1], B[MAX_DEGREE + 1], left, right = from_int(0);
    num t = parameter(T, "t"), weight = unknown(T, "w", 0);
    G(bernstein_basis)(n, t, B);
    for (int i = 0; i <= n; i++) {
        w[i] = weight;
        R[i] = unknown(T, "R", i);
        right = add(right, mul(B[i], R[i]));
    }
    w[1] = fault(T, w[1], add(weight, weight));
    G(rational_point)(n, 1, R, w, t, &left);
    same(T, left, right);
}

#if RATIONAL
/*
Must the weights be equal if the curve is a polynomial one?  Not if numerator and denominator have a common factor: it cancels, and
the weights keep it.

:::{claim} polynomial_line_with_unequal_weights
:title: Unequal weights can give a polynomial curve, without any change of parameter
:zh: 权不等时曲线亦可为多项式曲线
:kind: counterexample
:data: R = 0 1/3 1; ω = 1 3/2 2
:instead: R = 0 1/2 1; ω = 1 1 1
:result: powers of t in ω(t) = 1 1 0; powers of t in ω(t) R(t) = 0 1 1
:given: the quadratic curve of the line with points $R$ and weights $\omega$
:then: $R(t)=t$ for every $t$, a polynomial, but the weights are not equal
:method: The numerator and $t\,\omega(t)$ are compared as polynomials before the weights are compared.
:control: the points and equal weights of the same curve without the common factor
:::
*/
CLAIM(polynomial_line_with_unequal_weights)
{
    num R[3], w[3], x[3], power[3];
    given_points(T, "R", 3, 1, R);
    given_points(T, "ω", 3, 1, w);
    for (int i = 0; i < 3; i++)
        x[i] = mul(w[i], R[i]);
    poly below = poly_from_bernstein(2, w), above = poly_from_bernstein(2, x);
    G(bernstein_to_power)(2, w, power);
    found_points(T, "powers of t in ω(t)", 3, 1, power);
    G(bernstein_to_power)(2, x, power);
    found_points(T, "powers of t in ω(t) R(t)", 3, 1, power);
    about(T, "ω_1 and ω_0");
    if (poly_equal(above, poly_mul(poly_variable(), below)))
        same(T, w[1], w[0]);
}

#endif

/*
With the points kept it is otherwise.  If the curve is the Bézier curve of its own points, the products $\omega_iR_i$ are the coefficients of the product
of two polynomials, whose coefficients are $\omega_i$ and $R_i$.

:::{claim} products_of_coefficients_are_not_those_of_the_product
:title: A curve that is the Bézier curve of its own points has equal weights, or one point only, in every degree
:zh: 与自身控制顶点的 Bézier 曲线相同则权相等或顶点全重合(任意次数)
:given: polynomials $\omega(t)$ and $B(t)$ of the degrees $p,q\ge1$, $p+q\le n$, with the leading coefficients $\alpha$, $\beta$ and the Bernstein coefficients $\omega_i$, $R_i$ of the degree $n$
:harmless: of the degrees $p,q\ge1$, $p+q\le n$ | for $p=0$ the weights are equal, for $q=0$ the points; $p+q$ is the degree of a polynomial with $n+1$ coefficients
:then: as functions of $i$ the products $\omega_iR_i$ begin with $\frac{\alpha\beta}{(n)_p(n)_q}i^{p+q}$ and the coefficients of $\omega B$ with
  $\frac{\alpha\beta}{(n)_{p+q}}i^{p+q}$, $(n)_m=n(n-1)\cdots(n-m+1)$; these are different, as $\frac{(n)_{p+q}}{(n)_p(n)_q}=\prod_{0\le j<q}\frac{n-p-j}{n-j}$ lies
  between 0 and 1
:method: The coefficients of $t^m$ are $\frac{i(i-1)\cdots(i-m+1)}{(n)_m}$.  If $\sum B_i^n(t)\omega_iR_i=\omega(t)B(t)$, one coordinate of the points being taken, then both functions of $i$, of a degree of
  at most $n$, agree for $i=0,\dots,n$ and are one, and $p$ or $q$ is 0: the weights are equal, or the points.  In the field $0<\frac{n-p-j}{n-j}<1$ is decided with $p$ and $n-p-j$
  variables; outside it the differences of the order $p+q$ of both functions are computed for random polynomials.
:degrees: all
:over: p r c# d#: -
:control: $n-j$ for $n-p-j$
:::
*/
#if !FIELD
/* The difference of the highest order, m, of the first m+1 numbers. */
static num G(last_difference)(int m, const num b[])
{
    num sum = from_int(0);
    for (int i = 0; i <= m; i++)
        sum = add(sum, mul(from_int((m - i) % 2 == 0 ? binomial(m, i) : -binomial(m, i)), b[i]));
    return sum;
}
#endif

CLAIM(products_of_coefficients_are_not_those_of_the_product)
{
    num one = from_int(1);
#if FIELD
    num p = whole(T, "p", 1, 3), rest = whole(T, "r", 1, 3), below = add(p, rest), above = fault(T, rest, below);
    about(T, "a factor of the quotient");
    G(must_be_positive)(T, div(above, below));
    G(must_be_positive)(T, sub(one, div(above, below)));
#else
    enum { MOST = 9 };
    int p = pick(T, 1, 3), q = pick(T, 1, 3), n = p + q + pick(T, 0, 3);
    num c[MOST + 1], d[MOST + 1], e[MOST + 1], w[MOST + 1], R[MOST + 1], N[MOST + 1], quotient = one;
    for (int k = 0; k <= n; k++) {
        c[k] = k <= p ? unknown(T, "c", k) : from_int(0);
        d[k] = k <= q ? unknown(T, "d", k) : from_int(0);
        e[k] = from_int(0);
        for (int l = 0; l <= k; l++)
            e[k] = add(e[k], mul(c[l], d[k - l]));
    }
    G(bernstein_from_power)(n, c, w);
    G(bernstein_from_power)(n, d, R);
    G(bernstein_from_power)(n, e, N);
    for (int i = 0; i <= n; i++)
        w[i] = mul(w[i], R[i]);
    for (int j = 0; j < q; j++)
        quotient = mul(quotient, from_ratio(fault(T, n - p - j, n - j), n - j));
    about(T, "the differences of the order p + q");
    same(T, G(last_difference)(p + q, w), mul(quotient, G(last_difference)(p + q, N)));
#endif
}

#if RATIONAL
/*
:::{claim} weights_that_are_zero_have_no_curve
:title: With the weight 0 at every point there is no curve
:zh: 权全为零时无曲线
:kind: counterexample
:data: ω = 0; t = 1/2
:instead: ω = 1
:result: ω(t) = 0
:given: the weight $\omega$ at both points of a line, and a $t$
:then: the denominator $\omega(t)=(1-t)\omega+t\omega$ is 0, so that there is no point $R(t)$
:method: The sum of the definition.
:control: the weight 1
:::
*/
CLAIM(weights_that_are_zero_have_no_curve)
{
    num weight = given(T, "ω"), t = given(T, "t"), B[2];
    G(bernstein_basis)(1, t, B);
    num total = add(mul(B[0], weight), mul(B[1], weight));
    found(T, "ω(t)", total);
    about(T, "whether the denominator is not 0");
    refute(T, is_zero_q(total));
}
#endif

/* The weights 1, q, q^2, ..., q^n. */
static void G(geometric_weights)(int n, num q, num w[])
{
    w[0] = from_int(1);
    for (int i = 1; i <= n; i++)
        w[i] = mul(w[i - 1], q);
}

/* t = alpha u / (1 - u + alpha u) */
static num G(alpha_parameter)(num alpha, num u)
{
    num share = mul(alpha, u);
    return div(share, add(sub(from_int(1), u), share));
}

/*
If a change of parameter is allowed, the condition is on the quotients $I_i$ of the section before last.  They are $1$
for equal weights, and they do not notice the change.

:::{claim} unit_invariants_give_polynomial_curve
:title: Weights with all invariants 1 come from a polynomial curve
:zh: 不变量全为 1 的曲线来自多项式曲线
:given: points $P_0,\dots,P_n$ and positive weights with $I_i=1$, $0<i<n$: $\omega_0,\omega_1$ are free, the others
  follow from $\omega_{i+1}=\omega_i^2/\omega_{i-1}$
:where: the weights are positive
:let: $\alpha=\omega_1/\omega_0$, $t=\alpha u/(1-u+\alpha u)$
:then: $\omega_i=\omega_0\alpha^i$, and the curve at $u$ is the Bézier curve of the points at $t$
:method: The recursion produces all weights with these invariants; both sides are rational functions.
:degrees: 1..6 sampled 12
:control: the last weight doubled
:::
*/
CLAIM(unit_invariants_give_polynomial_curve)
{
    int n = T->degree;
    num P[MAX_DEGREE + 1], w[MAX_DEGREE + 1], q[MAX_DEGREE + 1], left, right, u = parameter(T, "u");
    w[0] = positive(T, "w", 0);
    w[1] = positive(T, "w", 1);
    for (int i = 1; i < n; i++)
        w[i + 1] = div(mul(w[i], w[i]), w[i - 1]);
    w[n] = fault(T, w[n], add(w[n], w[n]));
    num alpha = div(w[1], w[0]);
    G(geometric_weights)(n, alpha, q);
    for (int i = 0; i <= n; i++) {
        P[i] = unknown(T, "P", i);
        same(T, w[i], mul(w[0], q[i]));
    }
    G(rational_point)(n, 1, P, w, u, &left);
    G(bezier_casteljau)(n, 1, P, G(alpha_parameter)(alpha, u), &right);
    same(T, left, right);
}

/*
:::{statement} wang-ch3:prop-3.2.12
:title: A change of parameter gives a Bézier curve geometric weights
:zh: 被还原性:参数变换使 Bézier 曲线带上等比权
:printed: With $t=\alpha u/(1-u+\alpha u)$, $0\le u\le1$, the Bézier curve (1.3.2) becomes the rational Bézier curve
  $\sum_{i=0}^nB_i^n(u)\alpha^i\mathbf P_i\Big/\sum_{i=0}^nB_i^n(u)\alpha^i$ with the control points $\mathbf P_i$ and the weights
  $\omega_i=\alpha^i$.
:holds-by: geometric_weights_term_by_term alpha_runs_the_interval_once
:confirmed-by: geometric_weights_reparametrize_bezier
:needs: negative_alpha_has_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\alpha>0$; positive
  weights $\alpha^i$ mean it: for every $\alpha<0$ the denominator $(1-u+\alpha u)^n$ vanishes inside $[0,1]$
:needs: zero_alpha_collapses | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\alpha>0$: for $\alpha=0$
  the curve collapses to $\mathbf P_0$
:figure: geometric_weights

It is (3.2.10) with $a=\alpha$, $b=1$.
:::

With $D=1-u+\alpha u$ one has $t=\alpha u/D$ and $1-t=(1-u)/D$: each factor $t$ brings an $\alpha$ and each factor
$1-t$ none, so that $B_i^n$ gets $\alpha^i$.  The sum of all $B_i^n(t)$ is $1$, and so $D^n$ is the new denominator.

:::{claim} geometric_weights_reparametrize_bezier
:title: A Bézier curve in the new parameter is the rational curve with geometric weights
:zh: Bézier 曲线换参后成为等比权有理曲线
:given: points $P_0,\dots,P_n$, and $\alpha$, $u$
:let: $t=\alpha u/(1-u+\alpha u)$
:then: $\sum B_i^n(t)P_i=\sum B_i^n(u)\alpha^iP_i/\sum B_i^n(u)\alpha^i$
:method: Both sides are rational functions of $\alpha$, $u$ and the points.  The left side is computed as a
  polynomial curve.
:degrees: 1..8 sampled 16
:over: alpha
:control: the weights $\alpha^{n-i}$
:::
*/
CLAIM(geometric_weights_reparametrize_bezier)
{
    int n = T->degree;
    num P[MAX_DEGREE + 1], w[MAX_DEGREE + 1], v[MAX_DEGREE + 1], left, right;
    num alpha = positive(T, "alpha", 0), u = parameter(T, "u");
    G(geometric_weights)(n, alpha, w);
    for (int i = 0; i <= n; i++) {
        P[i] = unknown(T, "P", i);
        v[i] = w[fault(T, i, n - i)];
    }
    G(bezier_casteljau)(n, 1, P, G(alpha_parameter)(alpha, u), &left);
    G(rational_point)(n, 1, P, v, u, &right);
    same(T, right, left);
}

/*
:::{claim} geometric_weights_term_by_term
:title: Term by term, in every degree
:zh: 逐项成立:任意次数
:given: any $\alpha,u$ with $D=1-u+\alpha u\ne0$; a power $E$ of $D$ and a product $F$ of as many factors, each $t$ or $1-t$; $C$ a binomial coefficient and a point $P$
:let: $t=\alpha u/D$
:where: $1-u+\alpha u\ne0$
:then: $Dt=\alpha u$ and $D(1-t)=1-u$; so $(ED)(Ft)=EF\cdot\alpha u$ and $(ED)(F(1-t))=EF\cdot(1-u)$, and the same times $CP$; $Ft+F(1-t)=F$
:method: The steps of an induction on the number of factors, which begins with $E=F=1$: with $i$ factors $t$ and $n-i$ factors $1-t$ it is $D^nt^i(1-t)^{n-i}=\alpha^iu^i(1-u)^{n-i}$, and so
  $D^nB_i^n(t)=\alpha^iB_i^n(u)$ for all $i\le n$.  Multiply by $P_i$ and add: $D^n$ times the Bézier curve at $t$ is $\sum B_i^n(u)\alpha^iP_i$.  All products of $n$ factors, $\binom ni$ of them with $i$ factors $t$, have
  the sum 1, by induction from $Ft+F(1-t)=F$: so $\sum B_i^n(t)=1$, and the denominator $\sum B_i^n(u)\alpha^i$ is $D^n$.  Outside the field $n$ and $i$ are random integers, and the result is compared term by term.
:degrees: all
:over: alpha; C E F: -
:control: $\alpha^2$ for $\alpha$
:::
*/
CLAIM(geometric_weights_term_by_term)
{
    num one = from_int(1), alpha = positive(T, "alpha", 0), u = parameter(T, "u"), t = G(alpha_parameter)(alpha, u);
    num behind = sub(one, u), D = add(behind, mul(alpha, u)), rest = sub(one, t);
    num factor = fault(T, alpha, mul(alpha, alpha)), ahead = mul(factor, u);
#if !FIELD
    int index = pick(T, 0, 6), degree = index + pick(T, 0, 6);
    num old[MAX_DEGREE + 1], new[MAX_DEGREE + 1], scale = one;
    G(bernstein_basis)(degree, t, old);
    G(bernstein_basis)(degree, u, new);
    for (int k = 0; k < degree; k++)
        scale = mul(scale, D);
    for (int k = 0; k < index; k++)
        new[index] = mul(new[index], factor);
    about(T, "D^n B_i^n(t) = α^i B_i^n(u)");
    same(T, mul(scale, old[index]), new[index]);
    num sum = from_int(0), power = one;
    G(bernstein_basis)(degree, u, new);
    for (int k = 0; k <= degree; k++, power = mul(power, factor))
        sum = add(sum, mul(new[k], power));
    about(T, "the denominator is D^n");
    same(T, sum, scale);
#endif
    about(T, "D t and D (1-t)");
    same(T, mul(D, t), ahead);
    same(T, mul(D, rest), behind);
    num E = unknown(T, "E", 0), F = unknown(T, "F", 0), product = mul(E, F), more = mul(E, D);
    about(T, "all products of one factor more have the same sum");
    same(T, add(mul(F, t), mul(F, rest)), F);
    num scales[] = {one, mul(unknown(T, "C", 0), unknown(T, "P", 0))};
    static const char *const of[] = {"one factor more", "the same times the coefficient and the point of the term"};
    for (int k = 0; k < 2; k++) {
        about(T, of[k]);
        same(T, mul(scales[k], mul(more, mul(F, t))), mul(scales[k], mul(product, ahead)));
        same(T, mul(scales[k], mul(more, mul(F, rest))), mul(scales[k], mul(product, behind)));
    }
}

#if FIELD
/*
:::{claim} alpha_runs_the_interval_once
:title: For positive α the parameter t runs once from 0 to 1
:zh: α>0 时 t 单调地由 0 到 1
:types: field
:given: $\alpha>0$, $0<u<1$
:then: $t(0)=0$, $t(1)=1$, and $dt/du>0$
:method: With $u=s/(1+s)$ the derivative has positive coefficients only.
:scope: 0 ≤ u ≤ 1
:over: alpha; u s: -
:control: the sign of the derivative reversed
:::
*/
CLAIM(alpha_runs_the_interval_once)
{
    num alpha = positive(T, "alpha", 0), u = variable_f("u");
    num t = G(alpha_parameter)(alpha, u);
    vanishes(T, substitute_f(t, u, from_int(0)));
    same(T, substitute_f(t, u, from_int(1)), from_int(1));
    num speed = substitute_f(derivative_f(t, u), u, inside(T, "s"));
    nonnegative(T, fault(T, speed, neg(speed)));
    agree(T, !is_zero_f(speed));
}
#endif

/*
Nothing in this computation asks for the sign of $\alpha$.  But with a negative one the parameter $t$ does not run
from $0$ to $1$ any more: it goes to infinity on the way.

:::{claim} negative_alpha_has_a_pole
:title: For every negative α the denominator vanishes inside the interval
:zh: α<0 时分母在区间内必有零点
:given: $\alpha=-\beta$, $\beta>0$
:then: $u_0=1/(1+\beta)$ is in $(0,1)$, and $\sum B_i^n(u_0)\alpha^i=0$, while $t$ has a pole there
:method: $u_0$ and $1-u_0$ have positive coefficients only; the sum is the zero function of $\beta$.
:degrees: 1..6 sampled 12
:over: beta: -α
:control: $\alpha=+\beta$
:::
*/
CLAIM(negative_alpha_has_a_pole)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], beta = positive(T, "beta", ALONE), one = from_int(1), u = div(one, add(one, beta));
    num alpha = fault(T, neg(beta), beta);
    G(must_be_positive)(T, u);
    G(must_be_positive)(T, sub(one, u));
    vanishes(T, add(sub(one, u), mul(alpha, u)));
    show(T, "α", alpha);
    show(T, "u_0", u);
    G(geometric_weights)(n, alpha, w);
    vanishes(T, G(rational_weight)(n, w, u));
}

/*
:::{claim} zero_alpha_collapses
:title: For α = 0 only the first point is left
:zh: α=0 时曲线退缩为首点
:given: points $P_0,\dots,P_n$, the weights $1,0,\dots,0$, and $u\ne1$
:where: $u\ne1$
:then: the curve is $P_0$ for every $u$
:method: Computed as a rational function of $u$ and the points.
:degrees: 1..6 sampled 12
:control: $\omega_1=1$
:::
*/
CLAIM(zero_alpha_collapses)
{
    int n = T->degree;
    num P[MAX_DEGREE + 1], w[MAX_DEGREE + 1], u = parameter(T, "u"), value;
    G(geometric_weights)(n, from_int(0), w);
    w[1] = fault(T, w[1], from_int(1));
    for (int i = 0; i <= n; i++)
        P[i] = unknown(T, "P", i);
    G(rational_point)(n, 1, P, w, u, &value);
    show_points(T, "ω", n + 1, 1, w);
    show(T, "the curve at u", value);
    same(T, value, P[0]);
}

/*
:::{statement} wang-ch3:prop-3.2.12-restored
:title: A Bézier curve can be restored to a rational one
:zh: Bézier 曲线可还原为有理形式
:printed: That is, regarded as a degenerate case of the curve (3.2.2), the Bézier curve (1.3.2) can also be restored to (3.2.2).
:holds-by: geometric_weights_term_by_term alpha_runs_the_interval_once
:confirmed-by: geometric_weights_reparametrize_bezier unit_invariants_give_polynomial_curve equal_invariants_mean_geometric_ratios
:needs: negative_alpha_has_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\alpha>0$; positive
  weights $\alpha^i$ mean it
:needs: zero_alpha_collapses | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | $\alpha>0$: for $\alpha=0$
  the curve collapses to $\mathbf P_0$
:meant: the curve that the property displays | To a curve of the form (3.2.2).
:reading: geometric_weights_term_by_term | to a curve of the form (3.2.2), the one displayed
:reading: unit_invariant_is_necessary | to any curve (3.2.2) with the same points, by the change of parameter, for $n\ge2$
:::
*/

#if RATIONAL
/*
The word restored (还原) can be misread.  The change of parameter leads from the Bézier curve to those weights only that
are geometric, up to a common factor; three weights with another $I_1$ belong to another curve.

:::{claim} unit_invariant_is_necessary
:title: The quadratic with weights 1, 2, 1 does not come from its Bézier curve
:zh: 权 1,2,1 的二次曲线不能由 Bézier 曲线换参得到
:kind: counterexample
:data: ω = 1 2 1
:instead: ω = 1 2 4
:result: I_1 = 4; c = 1; α = 2; c α² = 4
:given: a quadratic curve with weights $\omega$ and points that are not on a line, so that other weights give the same map only if they are multiples of these
:then: the change of parameter leads to weights $c\,\alpha^i$; only one $c$ and one $\alpha$ agree with $\omega$ at $i=0,1$, but then
  $c\,\alpha^2\ne\omega_2$.  And $I_1\ne1$, while geometric weights have $I_1=1$
:method: $c=\omega_0$ and $\alpha=\omega_1/\omega_0$; computed exactly.
:control: a last weight that makes them geometric
:::
*/
CLAIM(unit_invariant_is_necessary)
{
    num w[3], q[3], I[1];
    given_points(T, "ω", 3, 1, w);
    num c = w[0], alpha = div(w[1], w[0]);
    G(rational_invariants)(2, w, I);
    G(geometric_weights)(2, alpha, q);
    found(T, "I_1", I[0]);
    found(T, "c", c);
    found(T, "α", alpha);
    found(T, "c α²", mul(c, q[2]));
    about(T, "whether the last weight is that of geometric weights, or I_1 = 1");
    refute(T, !equal_q(mul(c, q[2]), w[2]) && !equal_q(I[0], from_int(1)));
}
#endif

#include "chapters/judge/claims_off.h"
