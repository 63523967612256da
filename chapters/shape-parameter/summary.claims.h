/*
# What abstract and summary say (摘要与结论)

The sentences in which abstract, introduction and summary say what has been achieved are those of the sections before once
more, and so their verdicts are made of the claims of those sections.  Where the summary is true, it is true of the corrected functions and of
the range from $-\frac{21}4$ to 1.
*/
#if RATIONAL
#include "exact/record/sign.h"
#endif

#include "chapters/shape-parameter/definition.h"

#include "chapters/judge/claims_on.h"

#if RATIONAL
/*
:::{statement} deng-zhang-2022:sec-6-meaning
:title: The parameter has a clear geometric meaning
:zh: β 的几何意义
:printed: the geometric meaning of $\beta$ is clear: the larger $\beta$ in $-7\le\beta\le1$, the closer the curve to the
  control polygon
:refuted-by: larger_beta_takes_the_curve_away_from_its_polygon larger_beta_is_worse_for_a_convex_polygon
:class: false
:corrected: with the corrected functions (`sec-2-properties`) $\beta$ moves each inner Bézier point $Q_k$ of degree 8, $k=1,\dots,7$, but the middle one, $Q_4$,
  which stays, evenly on the line of its edge $P_{k-1}P_k$, if this is not 0, and each point of the curve on a straight line, evenly or not at all;
  if the polygon is convex and turns by at most two right angles, the latter, where $q'(t)\ne0$, move outward or stay while $\beta$ grows from $-\frac72$ to 1
:corrected-by: bezier_points_divide_the_edges points_move_evenly_with_beta curve_is_a_blend_of_three_points
  growing_beta_pushes_by_the_turns turns_push_outward_in_the_range
:confirmed-by: turns_push_by_these_numbers_in_every_degree product_of_two_sums_goes_by_pairs
:figure: closer_or_not
:degree: 7

Outward is, as in `property-3.5`, to the right of the derivative $q'$, or along it, where the polygon turns to the left.  As it turns by at most two right
angles in all, for $a<b$ the angle from the edge $e_a$ to $e_b$, $e_k=P_{k+1}-P_k$, is between 0 and $\pi$, and $e_a\times e_b\ge0$.
:::

:::{statement} deng-zhang-2022:sec-6-features
:title: The curve has the features of the Bézier curve of degree seven
:zh: 具有七次 Bezier 曲线的特征
:printed: end properties, tangency to the end edges, convex hull, symmetry and variation diminution hold as for the Bézier
  curve of degree seven (definition 2.1: $-7\le\beta\le1$)
:refuted-by: printed_curve_leaves_a_single_point corrected_curve_leaves_the_hull_at_minus_seven
  edge_is_not_tangent_at_minus_seven
:class: false
:corrected: with the corrected functions (`sec-2-properties`) and $-\frac{21}4<\beta\le1$ all of them hold, tangency to the end edges that are
  not 0, variation diminution for crossings and common points, counted along the curve and along the polygon; at
  $\beta=-\frac{21}4$ all hold too, variation diminution for crossings, and for common points unless the curve is on the line and the polygon is not
:corrected-by: end_points_and_end_derivatives corrected_functions_sum_to_one nonnegative_exactly_in_the_range
  combination_begins_and_ends_with_its_coefficients sign_changes_are_counted_one_by_one reversed_polygon_reverses_the_curve
  totally_positive_exactly_in_the_range inversions_of_two_diagonals_meet_a_zero averages_between_neighbours_keep_sign_changes
  linear_factor_adds_a_change_of_sign functions_are_independent_but_for_two_values
:confirmed-by: roots_are_at_most_sign_changes
:figure: ranges_of_beta
:::

:::{statement} deng-zhang-2022:sec-6-better
:title: The summary on approximation
:zh: 结论中的逼近性
:printed: from the point of view of approximation the curve is better than the Bézier curve of degree seven
:refuted-by: convex_polygon_prefers_the_bezier_curve larger_beta_takes_the_curve_away_from_its_polygon
:class: false
:corrected: for $\beta=1$ it depends on the polygon: by the largest distance of a point of the curve from the polygon the curve is nearer than the Bézier
  curve to the convex polygon of the decision, and farther than it from the convex one that begins with $(-3,-3)$, of the counterexample to what is printed
:corrected-by: convex_polygon_prefers_beta_one
:meant: property 3.5, by which a larger $\beta$ is better | The curve of $\beta=1$, the right end of the range, is compared with the one of $\beta=0$.
:reading: convex_polygon_prefers_zero_to_minus_two | with $\beta=-2$ in the place of 1, since the text does not say for which $\beta$ the curve is better: there is a
  convex polygon to which the Bézier curve is closer
:confirmed-by: polygons_that_do_not_move
:figure: closer_or_not

With a $\beta$ of its own for each polygon nothing more is said than that $\beta=0$ is one of the range; strictly nearer no $\beta$ makes the curve of
$P,P,P,P,Q,Q,Q,Q$ (`polygons_that_do_not_move`, with the corrected functions).
:::

:::{statement} deng-zhang-2022:abstract-features
:title: The features that the abstract names
:zh: 摘要所列特性
:printed: the curve has the features of the Bézier curve of degree seven, such as tangency to the end edges, convex hull,
  preservation of convexity and variation diminution (definition 2.1: $-7\le\beta\le1$)
:refuted-by: printed_curve_leaves_a_single_point corrected_curve_leaves_the_hull_at_minus_seven
  edge_is_not_tangent_at_minus_seven curve_of_a_triangle_meets_a_line_three_times
:class: false
:corrected: with the corrected functions (`sec-2-properties`) and $-\frac{21}4<\beta\le1$ all of them hold, tangency to the end edges that are
  not 0, variation diminution for crossings and common points, counted along the curve and along the polygon, and, for polygons convex when
  closed and not on a line, at most two points of the curve on any line; at $\beta=-\frac{21}4$
  all hold too, variation diminution for crossings, and for common points unless the curve is on the line and the polygon is
  not
:corrected-by: end_points_and_end_derivatives corrected_functions_sum_to_one nonnegative_exactly_in_the_range
  combination_begins_and_ends_with_its_coefficients sign_changes_are_counted_one_by_one
  totally_positive_exactly_in_the_range inversions_of_two_diagonals_meet_a_zero averages_between_neighbours_keep_sign_changes
  linear_factor_adds_a_change_of_sign
  four_vertices_of_a_convex_polygon_do_not_alternate functions_are_independent_but_for_two_values
:confirmed-by: roots_are_at_most_sign_changes
:figure: ranges_of_beta
:::

:::{statement} deng-zhang-2022:abstract-better
:title: Better approximation, in the abstract and the introduction
:zh: 摘要与引言中的"更好的逼近性"
:printed: the curve has adjustability of its shape and better approximation (abstract); as its functions, its pictures and its properties show, it has clearly
  better adjustability and better approximation than the Bézier curve of degree seven (introduction)
:refuted-by: convex_polygon_prefers_the_bezier_curve larger_beta_takes_the_curve_away_from_its_polygon
:class: false
:corrected: adjustable it is, but for the polygons $P,P,P,P,Q,Q,Q,Q$ with the corrected functions (`sec-2-properties`) and $0,0,0,0,5v,v,v,v$ with the printed
  ones; by the largest distance of a point of the curve from the polygon the curve of $\beta=1$ is nearer than that of $\beta=0$ to the convex polygon of the
  last decision, and farther than it from the convex one that begins with $(-3,-3)$, of the counterexample to what is printed
:corrected-by: polygons_that_do_not_move convex_polygon_prefers_beta_one
:meant: property 3.5, by which a larger $\beta$ is better | The curve of $\beta=1$, the right end of the range, is compared with the one of $\beta=0$.
:reading: convex_polygon_prefers_zero_to_minus_two | with $\beta=-2$ in the place of 1, since the text does not say for which $\beta$ the curve is better: there is a
  convex polygon to which the Bézier curve is closer
:figure: closer_or_not

Adjustable as a parametrized curve; sets of points are not compared.

With a $\beta$ of its own for each polygon nothing more is said than that $\beta=0$ is one of the range; strictly nearer no $\beta$ makes the curve of
$P,P,P,P,Q,Q,Q,Q$ (`polygons_that_do_not_move`, with the corrected functions).
:::

:::{statement} deng-zhang-2022:sec-1-unique
:title: Control points and Bernstein polynomials leave no freedom
:zh: 控制顶点与 Bernstein 基唯一确定 Bezier 曲线曲面
:printed: once the control points and the Bernstein basis are given, the Bézier curve or surface is uniquely determined; to change the shape of the curve one has
  to adjust its control points
:holds-by: decasteljau_evaluates_bezier_curve
:confirmed-by: surface_kernel_computes_the_double_sum bernstein_basis_is_independent
:argued: every n | By its definition the sum, or for a surface the double sum, has one value for given points and parameters, whatever the degrees.
:figure: curves_for_several_beta

Other points give another parametrized curve of the same degree: for $t=\frac s{1+s}$ the sum $\sum b_iB_i^n(t)$ of the differences, times
$(1+s)^n$, is $\sum\binom nib_is^i$, and 0 only if all $b_i$ are (`bernstein_basis_is_independent` up to degree 8).
:::

:::{statement} deng-zhang-2022:sec-1-bezier-properties
:title: The good properties of Bézier curves
:zh: Bezier 曲线的良好特性
:printed: the Bernstein polynomials have symmetry and end properties; so Bézier curves have end properties, tangency to
  the end edges, convex hull, symmetry and variation diminution
:holds-by: bernstein_recurrence recurrence_keeps_sum_sign_ends_and_symmetry bernstein_derivative
  sums_by_parts_give_the_edges linear_factor_adds_a_change_of_sign sign_changes_are_counted_one_by_one
:confirmed-by: bernstein_is_symmetric bernstein_at_ends end_derivatives_are_end_differences bernstein_sums_to_one
  bernstein_positive_inside reversed_points_reverse_the_curve roots_are_at_most_sign_changes
:meant: the proof of property 3.6, which counts changes of sign along the polygon in (19) and parameters of the curve in (20) | Variation diminution counts crossings along the curve and along the polygon.
:reading: linear_factor_adds_a_change_of_sign | crossings, counted along the curve and along the polygon
:reading-with: bernstein_recurrence recurrence_keeps_sum_sign_ends_and_symmetry sign_changes_are_counted_one_by_one
:reading: self_crossing_polygon_has_fewer_points_on_a_line | common points counted as points of the plane: a polygon that crosses itself on the
  line may have fewer than its Bézier curve
:hypothesis: double_end_point_has_no_end_edge | the end edges are not 0, for the tangency
:figure: end_edges

Bézier's name is printed Beizer in this sentence and twice more in the introduction.
:::

:::{claim} double_end_point_has_no_end_edge
:title: With a double end point the derivative at the end is 0
:zh: 端点重合时端点导矢为零
:kind: counterexample
:data: P = (0,0) (0,0) (2,4) (3,9) (4,16) (5,25) (6,36) (7,49)
:instead: P = (0,0) (1,1) (2,4) (3,9) (4,16) (5,25) (6,36) (7,49)
:result: q'(0) = (0,0)
:given: points of a parabola with $P_0=P_1$, and $\beta=0$: the Bézier curve
:then: $q'(0)$ is the zero vector
:method: The exact derivative; that it is not 0 is asked.
:control: another point of the parabola for $P_1$
:::
*/
CLAIM(double_end_point_has_no_end_edge)
{
    num P[8 * dim], D[2 * dim];
    given_points(T, "P", 8, dim, P);
    G(bezier_derivatives)(7, dim, P, from_int(0), 1, D);
    found_points(T, "q'(0)", 1, dim, D + dim);
    about(T, "the derivative is not 0");
    refute(T, is_zero_q(D[dim]) && is_zero_q(D[dim + 1]));
}

/*
:::{statement} deng-zhang-2022:ref-1-year
:title: The year of the first reference
:zh: 文献 [1] 的年份
:printed: [1] Pottmann, H. and Wagner, M.G. (1944) Helix Splines as an Example of Affine Tchebycheffian Splines. Advances in
  Computational Mathematics, 2, 123-142
:refuted-by: reference_is_older_than_its_journal
:class: misprint
:corrected: 1994
:corrected-by: second_volume_is_of_the_second_year
:example: the reference is the one that is printed.
:cites: the journal's list of volumes | volume 1 of Advances in Computational Mathematics is of 1993, and the first two volumes are of two successive years

One digit, 4 for 9.  The fact about the journal is no computation, and is cited.
:::

:::{claim} reference_is_older_than_its_journal
:title: The first reference is older than the journal it appeared in
:zh: 文献 [1] 早于所载期刊创刊
:kind: counterexample
:data: printed year = 1944; year of volume 1 = 1993
:instead: printed year = 1994
:given: the year that is printed, and the year of the first volume of the journal
:then: the printed year is before the first volume
:method: The two numbers; that the first is not less than the second is refuted.
:argued: | That volume 1 is of 1993 is said by the journal's list of volumes.
:control: the year 1994
:::
*/
CLAIM(reference_is_older_than_its_journal)
{
    int printed = given_whole(T, "printed year"), first = given_whole(T, "year of volume 1");
    about(T, "whether the printed year is not before the first volume");
    refute(T, printed < first);
}

/*
:::{claim} second_volume_is_of_the_second_year
:title: The volume of the first reference is of 1994
:zh: 文献 [1] 所在卷的年份
:kind: decision
:data: year of volume 1 = 1993; volume = 2; year = 1994
:instead: volume = 3
:given: the year of the first volume of the journal, the next volume a year later, and the printed volume, the second
:then: the year of the volume is the one given
:method: The year of the first volume plus the volume less 1.
:control: another volume
:::
*/
CLAIM(second_volume_is_of_the_second_year)
{
    int first = given_whole(T, "year of volume 1"), volume = given_whole(T, "volume");
    same(T, from_int(first + volume - 1), given(T, "year"));
}
#endif

/*
:::{statement} deng-zhang-2022:sec-1-degree
:title: A family with a parameter l has too high a degree
:zh: 文献 [11] 的曲线次数过高
:printed: for a polygon of $n+1$ points [11] uses Bernstein polynomials of degree $m=l(n-1)+1$; the geometric meaning of $l$ is vague, and
  the degree is too high for computing
:reading: degree_with_the_parameter_exceeds_that_of_the_polygon | for $l,n>1$ the degree $m$ exceeds $n$, that of the Bézier curve of $n+1$ points, by
  $(l-1)(n-1)$
:reading: that [11] has this degree, that its parameter is vague and its degree too high: no computation decides it, and [11] is not at hand
:::

:::{claim} degree_with_the_parameter_exceeds_that_of_the_polygon
:title: The degree with the parameter l exceeds that of the Bézier curve by a product
:zh: m-n=(l-1)(n-1)
:given: any $n$ and $l$, $m=l(n-1)+1$
:then: $m-n=(l-1)(n-1)$, which is 0 for $l=1$ or $n=1$ and positive for $l,n>1$
:method: An identity in $n$ and $l$.
:degrees: all
:over: n: -; l
:control: $l(n-1)$ for $m$
:::
*/
CLAIM(degree_with_the_parameter_exceeds_that_of_the_polygon)
{
    num n = whole(T, "n", 1, 20), l = whole(T, "l", 1, 9), one = from_int(1), product = mul(l, sub(n, one));
    num m = add(product, from_int(fault(T, 1, 0)));
    same(T, sub(m, n), mul(sub(l, one), sub(n, one)));
}

#if RATIONAL
/*
:::{statement} deng-zhang-2022:sec-1-weights
:title: Weights adjust the shape of a rational Bézier curve
:zh: 权因子可以调整有理 Bezier 曲线的形状
:printed: rational Bézier curves, with the control points unmoved, have weights, which can adjust the shape of the curve
:holds-by: two_middle_weights_give_two_arcs
:confirmed-by: more_weight_moves_a_mean_to_its_point growing_weight_pulls_each_point_straight_to_the_vertex
:meant: the word can (可以) | Some change of the weights changes the shape.
:reading: weights_in_a_progression_keep_the_shape | read as "every change of the weights changes the shape": weights in a geometric progression may give
  the arc that equal weights give
:reading: points_on_a_line_keep_their_segment | read as "every change of the weights changes the shape", for points on a line: they may keep their
  segment
:figure: geometric_weights

The two arcs are not even congruent: a congruence keeps the pair of their ends, and with it the line $x=y$ and distances from the chord, and these differ for their
points on this line.

The sentence goes on that it is not clear yet how to choose the weights; that is an opinion, which no computation decides.
It cites [10], whose first author is Mainar, printed Marnar.
:::

:::{claim} points_on_a_line_keep_their_segment
:title: Three points on a line make one segment with two different middle weights
:zh: 三点共线时不同权得同一线段
:kind: counterexample
:data: P = (0,0) (1,0) (2,0); w = 1 1 1; w, the other curve = 1 3 1
:instead: P = (0,0) (1,1) (2,0)
:result: sign of x' on [0,1] = 1 1
:given: three points on a line in order, and weights of two curves that differ in the middle one
:then: both curves run once and forward from $P_0$ to $P_2$: $y=0$ and $x'>0$ on $[0,1]$
:method: With $x=\frac NW$, the sign of $N'W-NW'$ on the interval.  That one of them does not is asked.
:control: the middle point moved off the line
:::
*/
/* Does x = N/W grow on [0,1], with the numerator and the denominator of the rational curve of three points? */
static int G(runs_forward)(const num P[], const num w[])
{
    num x[3];
    for (int i = 0; i < 3; i++)
        x[i] = mul(w[i], P[i * dim]);
    poly N = poly_from_bernstein(2, x), W = poly_from_bernstein(2, w);
    poly forward = poly_sub(poly_mul(poly_derivative(N), W), poly_mul(N, poly_derivative(W)));
    return sign_on(forward, from_int(0), from_int(1), CLOSED) == SIGN_POSITIVE;
}

CLAIM(points_on_a_line_keep_their_segment)
{
    num P[3 * dim], w[2][3], sign[2];
    given_points(T, "P", 3, dim, P);
    given_points(T, "w", 3, 1, w[0]);
    given_points(T, "w, the other curve", 3, 1, w[1]);
    int along = is_zero_q(P[1]) && is_zero_q(P[3]) && is_zero_q(P[5]);
    for (int k = 0; k < 2; k++) {
        int positive_everywhere = G(runs_forward)(P, w[k]);
        sign[k] = from_int(positive_everywhere);
        along = along && positive_everywhere;
    }
    found_points(T, "sign of x' on [0,1]", 2, 1, sign);
    about(T, "whether one of the curves does not run once and forward along the segment");
    refute(T, along);
}

/*
:::{claim} weights_in_a_progression_keep_the_shape
:title: Weights in a geometric progression give the same arc of a parabola as equal weights
:zh: 等比权因子给出同一段抛物线弧
:kind: counterexample
:data: P = (0,0) (1,2) (2,0); w = 1 2 4
:instead: w = 1 3 4
:result: YW-2XW+X² = "0"; x' > 0 on [0,1] = "yes"
:given: three points and weights in a geometric progression; with equal weights the curve of the points is an arc of the
  parabola $y=2x-x^2$
:then: the rational curve is on the same parabola, and with both weights $x$ runs once and forward from $P_0$ to $P_2$: both are the same arc
:method: With $X,Y,W$ for numerators and denominator: $YW-2XW+X^2$ as a polynomial, which vanishes also for equal weights, and the sign of $X'W-XW'$ on
  the interval for both.  That one of these is not so is asked.
:control: weights in no progression
:::
*/
/* Y W - 2 X W + X^2 for the numerators and the denominator of the rational curve of three points: 0 when y = 2 x - x^2. */
static poly G(off_the_parabola)(const num P[], const num w[])
{
    num x[3], y[3];
    for (int i = 0; i < 3; i++) {
        x[i] = mul(w[i], P[i * dim]);
        y[i] = mul(w[i], P[i * dim + 1]);
    }
    poly W = poly_from_bernstein(2, w), X = poly_from_bernstein(2, x), Y = poly_from_bernstein(2, y);
    return poly_sub(poly_mul(Y, W), poly_mul(X, poly_sub(poly_scale(W, from_int(2)), X)));
}

CLAIM(weights_in_a_progression_keep_the_shape)
{
    num P[3 * dim], w[3], equal[3] = {from_int(1), from_int(1), from_int(1)};
    given_points(T, "P", 3, dim, P);
    given_points(T, "w", 3, 1, w);
    poly gap = G(off_the_parabola)(P, w);
    int forward = G(runs_forward)(P, w) && G(runs_forward)(P, equal);
    found_text(T, "YW-2XW+X²", poly_to_string(gap, "t"));
    found_text(T, "x' > 0 on [0,1]", forward ? "yes" : "no");
    about(T, "some point is not on the parabola, or one of the curves does not run once and forward");
    refute(T, poly_is_zero(gap) && poly_is_zero(G(off_the_parabola)(P, equal)) && forward);
}
#endif

#include "chapters/judge/claims_off.h"
