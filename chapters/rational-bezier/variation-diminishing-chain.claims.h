/*
# The chain of the variation diminishing property (变差缩减性的证明)

The source proves the property by a chain of equalities and two inequalities,

$$I(\mathbf R,L)\le Z\Bigl[\sum B_i^n\omega_iy_i\Bigr]=Z\Bigl[(1-t)^n\sum\binom ni\tau^i\omega_iy_i\Bigr]
=Z\Bigl[\sum\binom ni\omega_iy_is^i\Bigr]\le V\Bigl[\binom n0\omega_0y_0,\dots,\binom nn\omega_ny_n\Bigr]=V[y_0,\dots,y_n]
=I(\mathbf B,L)$$

with $\tau=t/(1-t)$ taken as the new variable $s$, the roots being counted for $0<t<1$ and for $0<s<\infty$.  The
first inequality passes from crossings to roots, the second is Descartes' rule, and everything else is to make that
rule fit: it speaks of powers and of positive $s$, while the curve is written in Bernstein functions over $[0,1]$.
*/
#include "chapters/judge/elementary.h"
#include "chapters/rational-bezier/crossings.h"

#include "chapters/judge/claims_on.h"

/*
## From the line to the numerator

:::{statement} wang-ch3:prop-3.2.7-step-1
:title: The line may be taken as the axis
:zh: 可取直线为 x 轴
:printed: With $L$ as the $x$-axis a rectangular coordinate system is set up; by property 3.2.1 it suffices to prove the property there.
:holds-by: mean_grows_by_one_term motion_takes_a_line_to_the_axis
:confirmed-by: line_form_of_the_curve

A motion takes the line to the axis; with the same weights the images of the points have the image of the curve, and $y_i$ and $y(t)$ are the
values of the form of the line, whatever the system was.
:::

:::{claim} motion_takes_a_line_to_the_axis
:title: A motion takes any line of the plane to the x-axis
:zh: 存在运动将平面内任一直线化为 x 轴
:types: field rational
:given: a line $n\cdot X+d=0$ with the unit normal $n=(s,c)=\frac{(2p,\,1-p^2)}{1+p^2}$; a point $X$
:let: $H=\begin{pmatrix}c&-s\\s&c\end{pmatrix}$; $e=(0,1)$
:then: $HH^T=I$, $\det H=1$, and the last coordinate of $HX+d\,e$ is $n\cdot X+d$
:method: Identities in $p$, $d$ and $X$.  Every unit vector but $-e$ is such an $n$; with $-e$ the same line has the normal $e$, for which $p=0$.
:scope: every line of the plane
:over: p d x: -
:control: the sign of $d$
:::
*/
CLAIM(motion_takes_a_line_to_the_axis)
{
    num one = from_int(1), zero = from_int(0), p = unknown(T, "p", 0), d = unknown(T, "d", 0);
    num x = unknown(T, "x", 0), y = unknown(T, "x", 1), size = add(one, mul(p, p));
    num s = div(add(p, p), size), c = div(sub(one, mul(p, p)), size), H[2][2] = {{c, neg(s)}, {s, c}};
    about(T, "a motion of the plane");
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            same(T, add(mul(H[i][0], H[j][0]), mul(H[i][1], H[j][1])), i == j ? one : zero);
    same(T, sub(mul(H[0][0], H[1][1]), mul(H[0][1], H[1][0])), one);
    about(T, "the last coordinate of the image");
    same(T, add(add(mul(H[1][0], x), mul(H[1][1], y)), fault(T, d, neg(d))), add(add(mul(s, x), mul(c, y)), d));
}

/*
:::{claim} line_form_of_the_curve
:title: The form of a line, on the curve, has the weights of the curve
:zh: 曲线上的直线式仍以原权因子表示
:given: a curve of the plane with weights $\omega_i$ and points $(x_i,y_i)$; a line $ax+by+c=0$
:where: $\omega(t)\ne0$
:then: $a\,x(t)+b\,y(t)+c=\sum_iB_i^n(t)\omega_i(ax_i+by_i+c)/\omega(t)$
:method: Both sides are one element of the field, with every number a variable.
:degrees: 1..6 sampled 12
:over: a b c: line
:control: the constant $c$ left out at the last vertex
:::
*/
CLAIM(line_form_of_the_curve)
{
    int n = T->degree;
    num R[2 * (MAX_DEGREE + 1)], w[MAX_DEGREE + 1], value[MAX_DEGREE + 1], P[2], on_curve;
    num a = unknown(T, "a", 0), b = unknown(T, "b", 0), c = unknown(T, "c", 0), t = parameter(T, "t");
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        R[2 * i] = unknown(T, "x", i);
        R[2 * i + 1] = unknown(T, "y", i);
        value[i] = add(mul(a, R[2 * i]), mul(b, R[2 * i + 1]));
        if (fault(T, 1, i < n))
            value[i] = add(value[i], c);
    }
    G(rational_point)(n, 2, R, w, t, P);
    G(rational_point)(n, 1, value, w, t, &on_curve);
    /* a x(t) + b y(t) + c = Σ B_i^n(t) ω_i (a x_i + b y_i + c)/ω(t) */
    same(T, add(add(mul(a, P[0]), mul(b, P[1])), c), on_curve);
}

/*
:::{statement} wang-ch3:prop-3.2.7-step-2
:title: A crossing is a root of the numerator
:zh: 跨越处是分子的根
:printed: I(\mathbf R,L)\le Z_{0<t<1}\left[\sum_{i=0}^nB_i^n(t)\omega_iy_i\right]
:holds-by: positive_terms_make_a_convex_mean mean_grows_by_one_term
:confirmed-by: sign_of_the_curve_is_that_of_the_numerator designed_curves_cross_no_more
:needs: curve_changes_sides_at_a_pole | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive; it is enough that $\omega(t)$ has no zero in $(0,1)$
:meant: the last clause of the property | The intersections of the curve with $L$ are its crossings.
:reading: end_on_the_line_is_no_interior_root | The common points of the curve with $L$, ends included, are at most as many as the roots,
  against the last clause of the property.

Where $y(t)$ changes its sign the numerator does, and a polynomial that does so has a root between.  In the place of $Z_{0<t<1}$ the text at hand has a sign of
summation with $0<t<l$ (`wang-ch3:prop-3.2.7-notation`).
:::

The first inequality loses something: at a root where $y(t)$ keeps its sign the line is touched and not crossed.  It also needs the
denominator to be positive, for where $\omega(t)$ changes its sign so does $y(t)$, without any root.

:::{claim} sign_of_the_curve_is_that_of_the_numerator
:title: For positive weights y(t) has the sign of its numerator
:zh: 正权时 y(t) 与其分子同号
:given: positive weights and values $y_0,\dots,y_n$; $0<t<1$
:then: $\omega(t)>0$ and $y(t)\,\omega(t)=\sum_iB_i^n(t)\omega_iy_i$
:method: With $t=s/(1+s)$ and $s$ and the weights variables, $\omega(t)$ is a quotient of polynomials with positive coefficients;
  the equation is an identity in the field.
:degrees: 1..8 sampled 12
:scope: 0 < t < 1
:over: s: -
:control: the last value taken without its weight in the numerator
:::
*/
CLAIM(sign_of_the_curve_is_that_of_the_numerator)
{
    int n = T->degree;
    num w[MAX_DEGREE + 1], y[MAX_DEGREE + 1], B[MAX_DEGREE + 1], numerator = from_int(0), point;
    num t = inside(T, "s");
    G(bernstein_basis)(n, t, B);
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        y[i] = unknown(T, "y", i);
        num factor = fault(T, mul(B[i], w[i]), i == n ? B[i] : mul(B[i], w[i]));
        numerator = add(numerator, mul(factor, y[i]));
    }
    G(rational_point)(n, 1, y, w, t, &point);
    num weight = G(rational_weight)(n, w, t);
    G(must_be_positive)(T, weight);
    same(T, mul(point, weight), numerator); /* y(t) ω(t) = Σ B_i^n(t) ω_i y_i */
}

#if RATIONAL
/*
:::{claim} curve_changes_sides_at_a_pole
:title: At a pole a curve can change sides without a root
:zh: 极点处可变号而无根
:kind: counterexample
:data: y = 1 -1; ω = 1 -1; t = 1/4 3/4
:instead: ω = 1 1
:result: y(t) = 2 -2; roots of the numerator in (0,1) = 0
:given: degree $1$, opposite values $y$ and opposite weights $\omega$, and two parameters $t$, before and behind the pole
:then: $y(t)$ has opposite signs there, and the numerator has no root
:method: The numerator's roots in $(0,1)$ are counted exactly.
:control: the second weight made positive
:::
*/
CLAIM(curve_changes_sides_at_a_pole)
{
    num y[2], w[2], t[2], value[2];
    given_points(T, "y", 2, 1, y);
    given_points(T, "ω", 2, 1, w);
    given_points(T, "t", 2, 1, t);
    num b[2] = {mul(w[0], y[0]), mul(w[1], y[1])};
    for (int k = 0; k < 2; k++)
        G(rational_point)(1, 1, y, w, t[k], &value[k]);
    int roots = count_roots(poly_from_bernstein(1, b), from_int(0), from_int(1), OPEN).distinct;
    found_points(T, "y(t)", 2, 1, value);
    found_whole(T, "roots of the numerator in (0,1)", roots);
    about(T, "a change of sides is a root of the numerator");
    agree(T, (sign_q(value[0]) * sign_q(value[1]) < 0) <= roots);
}

/* The segment, n = 1, from (0, y_0) to (1, y_1) with the weights of the data: what it has in common with y = 0. */
static struct cagd_curve_meets_line given_segment(trial *T, num_q y[2], poly *numerator)
{
    num_q R[4], w[2], b[2];
    given_points_q(T, "y", 2, 1, y);
    given_points_q(T, "ω", 2, 1, w);
    for (int i = 0; i < 2; i++)
        b[i] = mul_q(w[i], y[i]);
    graph(1, y, R);
    *numerator = poly_from_bernstein(1, b);
    return curve_meets_line(1, R, w, horizontal_axis());
}

/*
Roots are counted in the open interval.  That is right for crossings and wrong for common points, of which an end can be one.

:::{claim} end_on_the_line_is_no_interior_root
:title: An end on the line is a common point and no root in (0,1)
:zh: 端点在直线上不计入内部根
:kind: counterexample
:data: y = 0 1; ω = 1 1
:result: common points = 1; roots in (0,1) = 0
:given: degree $1$, values $y$ of which the first is $0$, and equal weights $\omega$
:then: one common point, no root in $(0,1)$
:method: Counted exactly.
:control: crossings taken for common points
:::
*/
CLAIM(end_on_the_line_is_no_interior_root)
{
    poly g;
    num y[2];
    struct cagd_curve_meets_line curve = given_segment(T, y, &g);
    int points = fault(T, curve.crossings, curve.common_closed);
    int roots = count_roots(g, from_int(0), from_int(1), OPEN).distinct;
    found_whole(T, "common points", points);
    found_whole(T, "roots in (0,1)", roots);
    about(T, "there are no more intersections than roots");
    agree(T, points <= roots);
}
#endif

/*
:::{statement} wang-ch3:prop-3.2.7-step-3
:title: A power of 1-t is taken out
:zh: 提出因子 (1-t)^n
:printed: \sum_{i=0}^nB_i^n(t)\omega_iy_i=(1-t)^n\sum_{i=0}^n\binom ni\left(\frac t{1-t}\right)^i\omega_iy_i,\quad 0<t<1
:holds-by: change_of_parameter_acts_on_one_factor bernstein_sum_of_powers_is_a_power ratio_is_an_increasing_bijection
:confirmed-by: numerator_in_powers_of_the_ratio

The range is that in which the chain counts the roots of both sides; there it is printed as $0<t<l$ (`wang-ch3:prop-3.2.7-notation`).
:::

:::{claim} numerator_in_powers_of_the_ratio
:title: A polynomial in Bernstein form as a polynomial in t/(1-t)
:zh: Bernstein 形式化为 t/(1-t) 的多项式
:given: $b_0,\dots,b_n$
:then: $\sum_iB_i^n(t)b_i=(1-t)^n\sum_i\binom niS^ib_i$, $S=t/(1-t)$
:method: The left side by de Casteljau's algorithm, the right side by Horner's rule in $S$; one element of the field.
:degrees: 1..10 sampled 12
:over: b#: coefficients
:control: $(1-t)^{n-1}$ taken for $(1-t)^n$
:::
*/
CLAIM(numerator_in_powers_of_the_ratio)
{
    int n = T->degree;
    num b[MAX_DEGREE + 1], left, t = parameter(T, "t"), rest = sub(from_int(1), t), ratio = div(t, rest);
    for (int i = 0; i <= n; i++)
        b[i] = unknown(T, "b", i);
    G(bezier_casteljau)(n, 1, b, t, &left);
    num right = from_int(0);
    for (int i = n; i >= 0; i--)
        right = add(mul(right, ratio), mul(from_int(binomial(n, i)), b[i]));
    for (int k = 0; k < fault(T, n, n - 1); k++)
        right = mul(right, rest);
    same(T, right, left);
}

/*
:::{statement} wang-ch3:prop-3.2.7-step-4
:title: The substitution s = t/(1-t) keeps the roots
:zh: 变换 s=t/(1-t) 保持根数
:printed: Z_{0<t<1}\left[(1-t)^n\sum_{i=0}^n\binom ni\left(\frac t{1-t}\right)^i\omega_iy_i\right]
  =Z_{0<s<+\infty}\left[\sum_{i=0}^n\binom ni\omega_iy_is^i\right]
:holds-by: ratio_is_an_increasing_bijection change_of_parameter_acts_on_one_factor bernstein_sum_of_powers_is_a_power
:confirmed-by: numerator_in_powers_of_the_ratio root_counts_survive_the_substitution
:figure: roots_and_the_substitution

In the place of $Z_{0<t<1}$ and $Z_{0<s<+\infty}$ the text at hand has signs of summation, the first with $0<t<l$ (`wang-ch3:prop-3.2.7-notation`).  The equation holds for different roots and for roots
counted as often as their multiplicity, since $s-s_0$ is $t-t_0$ times a positive function, and $(1-t)^n$ has no root in $(0,1)$.
:::

The new variable $s$ runs through the positive numbers while $t$ runs from $0$ to $1$, once and without turning.  So
no root is lost and none counted twice.

:::{claim} ratio_is_an_increasing_bijection
:title: s = t/(1-t) runs once through the positive numbers
:zh: s=t/(1-t) 是 (0,1) 到正数的递增双射
:given: $0<t<1$; a second parameter $t'>t$ of $(0,1)$; $s>0$
:harmless: $t'>t$ of $(0,1)$; $s>0$ | any two parameters in order; $s$ is any value of the map
:then: $s(t)>0$, $t=\frac{s(t)}{1+s(t)}$, $s\bigl(\frac s{1+s}\bigr)=s$, and $s(t')-s(t)=\frac{t'-t}{(1-t')(1-t)}>0$
:method: Identities in the field; the signs by coefficients, with $t=\frac p{1+p}$ and $t'=\frac{p+q}{1+p+q}$, $p,q>0$.
:degrees: all
:scope: 0 < t < 1
:over: p q s: -
:control: $(1-t)^2$ taken for $(1-t')(1-t)$
:::
*/
CLAIM(ratio_is_an_increasing_bijection)
{
    num one = from_int(1), p = positive(T, "p", 0), q = positive(T, "q", 0), s = positive(T, "s", 0);
    num t = div(p, add(one, p)), later = div(add(p, q), add(one, add(p, q)));
    num at_t = div(t, sub(one, t)), at_later = div(later, sub(one, later)), back = div(s, add(one, s));
    G(must_be_positive)(T, at_t);
    same(T, div(at_t, add(one, at_t)), t);
    same(T, div(back, sub(one, back)), s);
    num rise = div(sub(later, t), mul(sub(one, fault(T, later, t)), sub(one, t)));
    same(T, sub(at_later, at_t), rise);
    G(must_be_positive)(T, rise);
}

#if RATIONAL
/*
:::{claim} root_counts_survive_the_substitution
:title: As many roots in 0<t<1 as in s>0
:zh: 变换前后根数相同
:kind: decision
:given: all numbers $b_i$ out of $-2,-1,0,1,2$ for $n\le3$, and out of $-1,0,1$ for $n=4,5$, not all $0$
:then: $\sum B_i^nb_i$ has in $(0,1)$ as many roots as $\sum\binom nib_is^i$ has in $(0,\infty)$, different ones and with
  multiplicity, and the same number of them are crossings
:method: Counted by Descartes' rule in the Bernstein basis with subdivision; the different ones again by Sturm's theorem, on both
  sides.
:degrees: 1..5
:scope: the stated coefficients
:control: roots up to $t=1$, the end included, counted on the left
:::
*/
/* sum C(n,i) b_i s^i */
static poly in_powers_of_the_ratio(int n, const num_q b[])
{
    num_q c[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++)
        c[i] = mul_q(from_int_q(binomial(n, i)), b[i]);
    return poly_from_q(n + 1, c);
}

CLAIM(root_counts_survive_the_substitution)
{
    int n = T->degree, radius = n <= 3 ? 2 : 1, base = 2 * radius + 1, codes = 1;
    num zero = from_int(0), one = from_int(1), b[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++)
        codes *= base;
    for (int code = 0; code < codes; code++) {
        region_mark mark = region_open();
        for (int i = 0, rest = code; i <= n; i++, rest /= base)
            b[i] = from_int(rest % base - radius);
        poly in_t = poly_from_bernstein(n, b), in_s = in_powers_of_the_ratio(n, b);
        if (!poly_is_zero(in_t)) {
            struct cagd_root_count left = count_roots(in_t, zero, one, fault(T, OPEN, OPEN_LEFT));
            struct cagd_root_count right = count_roots_above(in_s, zero);
            agree(T, left.distinct == right.distinct && left.counted == right.counted);
            agree(T, left.crossings == right.crossings);
            int at_one = is_zero_q(poly_value(in_t, one));
            agree(T, sturm_count(in_t, zero, one) - at_one == right.distinct);
            agree(T, sturm_count_above(in_s, zero) == right.distinct);
        }
        region_drop(mark);
    }
}

/*
:::{statement} wang-ch3:prop-3.2.7-notation
:title: The symbol for the number of roots in (0,1)
:zh: (0,1) 上根数的记号
:printed: \sum_{0<t<l}[\,\cdot\,]
:class: misprint
:refuted-by: roots_must_be_counted_up_to_one
:corrected: Z_{0<t<1}[\,\cdot\,]
:corrected-by: positive_terms_make_a_convex_mean mean_grows_by_one_term ratio_is_an_increasing_bijection
  change_of_parameter_acts_on_one_factor bernstein_sum_of_powers_is_a_power
:confirmed-by: designed_curves_cross_no_more root_counts_survive_the_substitution
:figure: roots_and_the_substitution

The symbol defined just before is $Z$, without a place for the interval; in the chain a sign of summation stands for it, three
times, and twice the range ends with the letter $l$ where it must end with the digit $1$.  By its letter it is a sum over
all numbers of an interval; such a sum of values of a polynomial that is not $0$ has no value, and it counts no roots.  With an $l<1$ the first step can be false, and with it the
substitution $s=\frac t{1-t}$, where the other $l$ stands: in the example the root with $s=2$ is lost.
:::

What the letter would mean, if it were one, is seen at a line that the curve crosses late.

:::{claim} roots_must_be_counted_up_to_one
:title: With an l below 1 the first step can be false
:zh: 若 l<1 则第一步可不成立
:kind: counterexample
:data: y = -2 1; ω = 1 1; l = 1/2
:instead: l = 1
:result: crossings of the curve = 1; t of the crossing = 2/3; y at this t = 0; roots of the numerator in (0,l) = 0
:given: degree $1$, values $y$ of both signs, equal weights $\omega$, and an $l<1$
:then: the curve crosses $y=0$ once, at a parameter behind $l$, and the numerator has no root with $0<t<l$
:method: Counted exactly; the curve being $y(t)=(1-t)y_0+ty_1$, it crosses at $t=y_0/(y_0-y_1)$.
:control: $l=1$
:::
*/
CLAIM(roots_must_be_counted_up_to_one)
{
    poly g;
    num y[2];
    struct cagd_curve_meets_line curve = given_segment(T, y, &g);
    num l = given(T, "l"), crossing = div(y[0], sub(y[0], y[1]));
    int roots = count_roots(g, from_int(0), l, OPEN).distinct;
    found_whole(T, "crossings of the curve", curve.crossings);
    found(T, "t of the crossing", crossing);
    found(T, "y at this t", poly_value(g, crossing));
    found_whole(T, "roots of the numerator in (0,l)", roots);
    about(T, "there are no more crossings than roots");
    agree(T, curve.crossings <= roots);
}

/*
:::{statement} wang-ch3:prop-3.2.7-step-5
:title: Descartes' rule bounds the number of roots
:zh: Descartes 符号法则
:printed: Z_{0<s<+\infty}\left[\sum_{i=0}^n\binom ni\omega_iy_is^i\right]\le
  V\left[\binom n0\omega_0y_0,\dots,\binom nn\omega_ny_n\right]
:holds-by: factor_of_a_positive_root_adds_a_sign_change averages_between_neighbours_keep_sign_changes
:confirmed-by: descartes_rule_by_sign_patterns
:hypothesis: curve_inside_the_line_has_too_many_roots | the polynomial is not $0$: the curve is not contained in $L$

In the place of $Z_{0<s<+\infty}$ the text at hand has a sign of summation (`wang-ch3:prop-3.2.7-notation`).
The rule is about the number of positive roots of a polynomial, each as often as its multiplicity; it is proved here by
multiplying one factor $s-\rho$ after the other.
:::

Descartes' rule itself is short.  Between two positive roots of a function its derivative has one.  Let $q$ first be
multiplied by $s^{-\alpha}$, with $\alpha$ between the two exponents at the first change of sign: then differentiating
multiplies the coefficients before this change by negative numbers and those behind it by positive ones, and removes
just this change.

:::{claim} descartes_rule_by_sign_patterns
:title: Descartes' rule of signs
:zh: Descartes 符号法则
:kind: decision
:given: $q(s)=\sum_{m=0}^nc_ms^m$, not $0$
:let: $V$ the number of changes of sign, where zeros are left out
:then: $q$ has at most $V[c_0,\dots,c_n]$ positive roots, counted with multiplicity
:method: If all $c_m\ne0$ have one sign there is no positive root.  Otherwise let $i$ be the index just before the first change
  of sign and $\alpha=i+\frac12$.  The function $s^{-\alpha}q(s)$ has the positive roots of $q$, and its derivative is
  $s^{-\alpha-1}\sum(m-\alpha)c_ms^m$; by Rolle's theorem, multiplicities counted, it has at most one root fewer.  The
  sequence $(m-\alpha)c_m$ is decided to have exactly one change of sign fewer than the $c_m$, for every pattern of signs; so
  the rule follows by induction on $V$.  For every $n$: up to the index $i$ all signs are reversed, behind it they stay.
:degrees: 1..8
:scope: all patterns of signs
:where: the polynomial whose roots are counted is not $0$
:control: $\alpha=i-\frac12$
:::
*/
CLAIM(descartes_rule_by_sign_patterns)
{
    int n = T->degree;
    for (int code = 0; code < patterns(n + 1); code++) {
        int c[MAX_DEGREE + 1], after[MAX_DEGREE + 1], i = -1;
        sign_pattern_of(code, n + 1, c);
        int changes = sign_changes(n + 1, c);
        for (int m = 0; m <= n && sign_changes(m + 1, c) == 0; m++)
            i = m;
        for (int m = 0; m <= n; m++) /* the sign of m - alpha, alpha = i + 1/2 */
            after[m] = (m > fault(T, i, i - 1) ? 1 : -1) * c[m];
        agree(T, changes == 0 || sign_changes(n + 1, after) == changes - 1);
    }
}

/*
The rule is about a polynomial that is not $0$.  A curve inside the line has nothing but roots, and its polygon no change of sign.

:::{claim} curve_inside_the_line_has_too_many_roots
:title: A curve inside the line has more roots than changes of sign
:zh: 曲线落在直线上时根数无界
:kind: counterexample
:data: y = 0 0; ω = 1 1; t = 1/4 1/2 3/4
:instead: y = 1 -1
:result: roots among the parameters t = 3; V = 0
:given: degree $1$, all values $y$ equal to $0$, equal weights $\omega$, and three parameters $t$
:then: the numerator is $0$ at all of them, and $V=0$
:method: Evaluated exactly.
:control: two values of different signs
:::
*/
CLAIM(curve_inside_the_line_has_too_many_roots)
{
    poly g;
    num y[2], t[3];
    int sign[2], roots = 0;
    (void)given_segment(T, y, &g);
    given_points(T, "t", 3, 1, t);
    for (int k = 0; k < 3; k++)
        roots += is_zero_q(poly_value(g, t[k]));
    signs_of(2, y, sign);
    found_whole(T, "roots among the parameters t", roots);
    found_whole(T, "V", sign_changes(2, sign));
    about(T, "there are no more roots than changes of sign");
    agree(T, roots <= sign_changes(2, sign));
}

/*
:::{statement} wang-ch3:prop-3.2.7-step-6
:title: Positive factors do not change the signs
:zh: 正因子不改变变号数
:printed: V\left[\binom n0\omega_0y_0,\binom n1\omega_1y_1,\dots,\binom nn\omega_ny_n\right]=V[y_0,y_1,\dots,y_n]
:holds-by: sign_changes_are_counted_one_by_one
:confirmed-by: positive_factors_keep_sign_changes
:needs: mixed_weights_change_sign_changes | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are
  positive
:figure: line_crossings
:::

The way back to the polygon is a matter of signs: positive binomial coefficients and positive weights do not touch them.

:::{claim} positive_factors_keep_sign_changes
:title: Binomial coefficients and positive weights keep the changes of sign
:zh: 二项系数与正权不改变变号数
:kind: decision
:given: all patterns of signs of $y_0,\dots,y_n$; weights $1$; $1000$ and $1$ in turn; $10^i$; $\frac1{1000}$ inside and $1$ at
  the ends
:let: $V$ the number of changes of sign, where zeros are left out
:then: $V[\binom ni\omega_iy_i]=V[y_i]$
:method: The products are computed exactly.  For all positive weights: the sign of a product is the product of the signs.
:degrees: 1..6
:scope: all patterns of signs, four families of weights
:control: the last weight with the sign $-$
:::
*/
CLAIM(positive_factors_keep_sign_changes)
{
    int n = T->degree;
    for (int family = 0; family < FAMILIES; family++)
        for (int code = 0; code < patterns(n + 1); code++) {
            int y[MAX_DEGREE + 1], product[MAX_DEGREE + 1];
            region_mark mark = region_open();
            sign_pattern_of(code, n + 1, y);
            for (int i = 0; i <= n; i++) {
                num w = designed_weight(family, n, i);
                w = fault(T, w, i == n ? neg(w) : w);
                product[i] = sign_q(mul(mul(from_int(binomial(n, i)), w), from_int(y[i])));
            }
            agree(T, sign_changes(n + 1, product) == sign_changes(n + 1, y));
            region_drop(mark);
        }
}

/*
A single negative weight is enough to add two changes of sign.

:::{claim} mixed_weights_change_sign_changes
:title: A negative weight can change the number of changes of sign
:zh: 负权改变变号数
:kind: counterexample
:data: y = 2 5 2; ω = 2 -1 2
:instead: ω = 2 1 2
:result: C(n,i) ω_i y_i = 4 -10 4; V of the products = 2; V of y = 0
:given: degree $2$, positive values $y$, and weights $\omega$ of which the middle one is negative
:let: $V$ the number of changes of sign, where zeros are left out
:then: $V[\binom ni\omega_iy_i]>V[y_i]$
:method: Computed.
:control: the middle weight made positive
:::
*/
CLAIM(mixed_weights_change_sign_changes)
{
    enum { n = 2 };
    num y[n + 1], w[n + 1], product[n + 1];
    int sign[n + 1], before, after;
    given_points(T, "y", n + 1, 1, y);
    given_points(T, "ω", n + 1, 1, w);
    for (int i = 0; i <= n; i++)
        product[i] = mul(from_int(binomial(n, i)), mul(w[i], y[i]));
    signs_of(n + 1, product, sign);
    after = sign_changes(n + 1, sign);
    signs_of(n + 1, y, sign);
    before = sign_changes(n + 1, sign);
    found_points(T, "C(n,i) ω_i y_i", n + 1, 1, product);
    found_whole(T, "V of the products", after);
    found_whole(T, "V of y", before);
    about(T, "the changes of sign are as many as those of y");
    agree(T, after == before);
}

/*
:::{statement} wang-ch3:prop-3.2.7-step-7
:title: The changes of sign are the crossings of the polygon
:zh: 变号数即 B 网跨越直线的次数
:printed: V[y_0,y_1,\dots,y_n]=I(\mathbf B,L)
:holds-by: sign_changes_are_counted_one_by_one
:confirmed-by: sign_changes_are_polygon_crossings
:meant: the last clause of the property | The intersections of the B-net with $L$ are its crossings.
:reading: touching_polygon_has_no_sign_change | The changes of sign are as many as the common points of the B-net with $L$, against the last
  clause of the property.
:::

:::{claim} sign_changes_are_polygon_crossings
:title: Changes of sign at the vertices are crossings of the polygon
:zh: 顶点变号数等于多边形跨越次数
:kind: decision
:given: all patterns $y_i\in\{-1,0,1\}$, the polygon with vertices $(i,y_i)$ and the line $y=0$
:let: $V$ the number of changes of sign, where zeros are left out
:then: $V[y_0,\dots,y_n]$ is the number of times that a point which runs along the polygon changes sides
:method: Between its quarters an edge of these polygons that is not on the line meets it at most once; the sides of the points at $\frac14$ and
  $\frac34$ of every edge, none of which is an isolated point on the line, are read one after the other.  Compared with
  $V$ and with the count of `exact/decide/crossings.h`.  Heights of other size but the same signs change the sides of the edges in the same way, since
  the height along an edge is linear.
:degrees: 1..8
:scope: all patterns of signs
:control: zeros counted as positive in $V$
:::
*/
CLAIM(sign_changes_are_polygon_crossings)
{
    int n = T->degree;
    for (int code = 0; code < patterns(n + 1); code++) {
        int y[MAX_DEGREE + 1], counted[MAX_DEGREE + 1], side = 0, changes = 0;
        num R[2 * (MAX_DEGREE + 1)];
        region_mark mark = region_open();
        sign_pattern_of(code, n + 1, y);
        graph_of_signs(n, y, R);
        for (int i = 0; i < n; i++)
            for (int quarter = 1; quarter <= 3; quarter += 2) {
                int height = (4 - quarter) * y[i] + quarter * y[i + 1]; /* four times the height there */
                changes += height * side < 0;
                side = height != 0 ? height : side;
            }
        for (int i = 0; i <= n; i++)
            counted[i] = fault(T, y[i], y[i] == 0 ? 1 : y[i]);
        int crossings = polygon_crossings(n, R, horizontal_axis());
        agree(T, crossings == changes && sign_changes(n + 1, counted) == changes);
        region_drop(mark);
    }
}

/*
Here as at the beginning crossings are meant.  A polygon that only touches the line has a point there and no change of sign.

:::{claim} touching_polygon_has_no_sign_change
:title: A polygon that touches the line has a common point and no change of sign
:zh: 多边形与直线相切时变号数为零
:kind: counterexample
:data: y = 1 0 1
:result: common points = 1; V = 0
:given: three values $y$ of which the middle one is $0$ and the others are positive
:then: one common point, $V=0$
:method: Counted exactly.
:control: crossings taken for common points
:::
*/
CLAIM(touching_polygon_has_no_sign_change)
{
    num y[3], R[6];
    int sign[3];
    given_points(T, "y", 3, 1, y);
    graph(2, y, R);
    signs_of(3, y, sign);
    struct cagd_polygon_meets_line polygon = polygon_meets_line(2, R, horizontal_axis());
    int points = fault(T, polygon.crossings, polygon.common_runs);
    found_whole(T, "common points", points);
    found_whole(T, "V", sign_changes(3, sign));
    about(T, "there are as many intersections as changes of sign");
    agree(T, points == sign_changes(3, sign));
}
#endif

#include "chapters/judge/claims_off.h"
