/*
# Closer to the polygon? (逼近性)

A curve may be near its polygon in several senses: the largest distance of a point of the curve from the polygon; the
largest distance of a control point from the curve; the distance of the point of one $t$.  In all three senses a larger
$\beta$ can make the curve worse, in the true range of $\beta$; in the first and the third even for a convex polygon.
*/
#include "exact/record/hull.h"

#include "chapters/shape-parameter/definition.h"
#include "chapters/shape-parameter/distance.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} deng-zhang-2022:property-3.5
:title: The larger beta, the closer the curve to its polygon
:zh: β 越大越逼近控制多边形
:printed: when $\beta$ grows the curve approximates the control polygon better (definition 2.1: $-7\le\beta\le1$)
:refuted-by: larger_beta_takes_the_curve_away_from_its_polygon larger_beta_is_worse_for_a_convex_polygon
:class: false
:corrected: with the corrected functions (`sec-2-properties`), for fixed $t$ the point moves with $\beta$ evenly, or not at all, on the straight line through it with
  the direction $b_1-(s\,b_0+t\,b_2)$, $s=1-t$, where $b_0,b_1,b_2$ is level 5 of de Casteljau's triangle; for $-2\le\beta\le1$ it is in the
  triangle $b_0b_1b_2$, its weight at $b_1$ does not fall and those at $b_0$ and $b_2$ do not grow; if the polygon is convex and turns by
  at most two right angles, each point of the curve with $q'(t)\ne0$ moves outward or stays while $\beta$ grows from $-\frac72$ to 1
:corrected-by: curve_is_a_blend_of_three_points corrected_functions_sum_to_one blend_is_convex_from_minus_two_to_one
  growing_beta_pushes_by_the_turns turns_push_outward_in_the_range
:confirmed-by: turns_push_by_these_numbers_in_every_degree product_of_two_sums_goes_by_pairs
:figure: closer_or_not
:striking: 11
:degree: 7

The weights are the functions of the family for $n=2$, whose sum is 1.  Outward is, for the curve $q$, to the right of $q'$, or along it, where the polygon turns to the left:
$q'\times\partial_\beta q$ is the sum over $a<b$ of $e_a\times e_b$, $e_k=P_{k+1}-P_k$, with the factors of the claims, none of them positive for $-\frac72\le\beta\le1$;
and where a convex polygon turns to the left by at most two right angles, the angle from $e_a$ to $e_b$ is between 0 and $\pi$, and $e_a\times e_b\ge0$.
:::
*/

#if RATIONAL
/*
"Nearer than $r$" is decided for a whole curve, not for sample points.  A piece of the curve is near an edge when the foot
of its points stays on the edge and their distance from its line stays below $r$; these are signs of three polynomials in
$t$.  Where one edge does not serve for the whole piece, the piece is halved.  "Farther" is easier: one point suffices.

:::{claim} larger_beta_takes_the_curve_away_from_its_polygon
:title: A larger beta takes a curve away from its polygon, in two senses at once
:zh: β 增大而曲线远离控制多边形
:kind: counterexample
:data: P = (-1,-1) (2,0) (2,-2) (1,-2) (1,-2) (0,0) (2,2) (2,1); β = 0 1; r² = 23/50; R² = 21/25
:instead: β = 1 0
:result: t of a farther point = 3/16 3/16; control points farther than R, corrected = 0 1;
  control points farther than R, printed = 0 1
:given: a polygon, two values of $\beta$, and the squares of two distances; printed and corrected functions
:then: for the first $\beta$ every point of the curve is nearer to the polygon than $r$, for the second some point is
  farther; for the first $\beta$ no control point is farther from the curve than $R$, for the second one is
:method: Nearer on all of $[0,1]$: the interval is cut until on each piece one edge is near, decided by the signs of three
  polynomials (the foot on the edge, the distance to its line).  Farther: one rational $t$ and all seven edges; for a control
  point the sign of $|q(t)-P_i|^2-R^2$ on $[0,1]$.
:control: the two values of $\beta$ exchanged
:::
*/
CLAIM(larger_beta_takes_the_curve_away_from_its_polygon)
{
    static const char *const away_of[] = {"control points farther than R, corrected",
                                          "control points farther than R, printed"};
    num P[8 * dim], beta[2], R_squared = given(T, "R²");
    int farther = G(one_is_farther)(T, 7, P, beta);
    for (int printed_ones = 0; printed_ones <= 1; printed_ones++) {
        num away[2];
        for (int k = 0; k < 2; k++)
            away[k] = from_int(G(points_far_from_the_curve)(printed_ones, 7, P, beta[k], R_squared));
        found_points(T, away_of[printed_ones], 2, 1, away);
        farther = farther && is_zero_q(away[0]) && sign_q(away[1]) > 0;
    }
    about(T, "in one of two senses the larger beta is not farther: curve from polygon, control points from curve");
    refute(T, farther);
}

/*
One may suspect the polygon above, which turns to and fro.  But a convex one does as well, and the next example takes
$\beta$ from one end of the true range to the other.  For the same polygon the curve of $\beta=1$ is nevertheless nearer
than the Bézier curve of $\beta=0$: the largest distance is greater there than at both ends of the range.

:::{claim} larger_beta_is_worse_for_a_convex_polygon
:title: From the left end of the range to its right end a curve goes away from its convex polygon
:zh: 凸多边形:β 由 -21/4 增至 1 时曲线远离多边形
:kind: counterexample
:data: P = (-1,-2) (2,0) (3,1) (4,3) (-2,4) (-4,-2) (-4,-3) (-3,-3); β = -21/4 1; r² = 24/5
:instead: β = 1 -21/4
:result: t of a farther point = 35/64 35/64
:given: a convex polygon, the two ends of the range of $\beta$ for which the functions are nonnegative, and the square of a distance; printed and corrected
  functions
:then: for the left end every point of the curve is nearer to the polygon than $r$, for the right end some point is farther
:method: Nearer on all of $[0,1]$: the interval is cut until on each piece one edge is near, decided by signs of polynomials.  Farther: one
  rational $t$ and all edges.  `hull.h` decides that the polygon is convex.
:control: the two values of $\beta$ exchanged
:::
*/
CLAIM(larger_beta_is_worse_for_a_convex_polygon) { G(refute_closer_to_a_convex_polygon)(T, 7); }

/* Whether the polygon of the claim is convex and the curve of the first β closer to it. */
static void G(agree_closer_to_a_convex_polygon)(trial *T)
{
    num P[8 * dim], beta[2];
    int better = G(one_is_farther)(T, 7, P, beta);
    agree(T, polygon_is_convex(7, P, 1, NULL));
    agree(T, better);
}

/*
:::{claim} convex_polygon_prefers_beta_one
:title: A convex polygon to which the curve of beta = 1 is closer than the Bézier curve
:zh: 凸多边形:β=1 的曲线更近
:kind: decision
:data: P = (-1,-2) (2,0) (3,1) (4,3) (-2,4) (-4,-2) (-4,-3) (-3,-3); β = 1 0; r² = 111/20
:instead: β = 0 1
:result: t of a farther point = 35/64 35/64
:given: a convex polygon, the right end of the range and the $\beta$ of
  the Bézier curve, and the square of a distance; printed and corrected functions
:then: for the first $\beta$ every point of the curve is nearer to the polygon than $r$, for the second, the Bézier curve,
  some point is farther
:method: Nearer on all of $[0,1]$: the interval is cut until on each piece one edge is near, decided by signs of polynomials.  Farther: one
  rational $t$ and all edges.  `hull.h` decides that the polygon is convex.
:degrees: 7..7
:scope: the stated polygon
:control: the two values of $\beta$ exchanged
:::
*/
CLAIM(convex_polygon_prefers_beta_one) { G(agree_closer_to_a_convex_polygon)(T); }

/*
The comparison with the Bézier curve is the comparison of $\beta$ with 0.  It was just won for one convex polygon; for
another one it is lost.

:::{statement} deng-zhang-2022:property-3.5-bezier
:title: The curve is closer to its polygon than the Bézier curve of degree seven
:zh: 比七次 Bezier 曲线更优
:printed: the approximation of the control polygon is better than that of the Bézier curve of degree seven (definition 2.1: $-7\le\beta\le1$)
:refuted-by: larger_beta_takes_the_curve_away_from_its_polygon convex_polygon_prefers_the_bezier_curve convex_polygon_prefers_zero_to_minus_two
:class: false
:corrected: the Bézier curve is that of $\beta=0$.  For one convex polygon, that of the two decisions, both the curve of $\beta=1$ and that of $\beta=-2$ are closer than it, the largest
  distances of points of the curves from the polygon being compared; for the convex polygon of the second counterexample the curve of $\beta=1$ is not, for that
  of the third one the curve of $\beta=-2$ is not
:corrected-by: beta_zero_gives_the_bezier_curve convex_polygon_prefers_beta_one convex_polygon_prefers_minus_two
:figure: closer_or_not

For which $\beta$ the sentence is, is not printed.  For $\beta<0$ it says the contrary of property 3.5, by which the curve of the larger $\beta$, which is 0, is the closer one.
:::

:::{claim} convex_polygon_prefers_the_bezier_curve
:title: A convex polygon to which the Bézier curve is closer
:zh: 凸多边形:七次 Bezier 曲线更近
:kind: counterexample
:data: P = (-3,-3) (-3,-4) (-2,-4) (5,0) (4,5) (3,5) (2,4) (-2,-1); β = 0 1; r² = 91/20
:instead: β = 1 0
:result: t of a farther point = 15/32 15/32
:given: a convex polygon, the $\beta$ of the Bézier curve and the right end of the range, and the square of a
  distance; printed and corrected functions
:then: for the first $\beta$ every point of the curve is nearer to the polygon than $r$, for the second some point is farther
:method: Nearer on all of $[0,1]$: the interval is cut until on each piece one edge is near, decided by signs of polynomials.  Farther: one
  rational $t$ and all edges.  `hull.h` decides that the polygon is convex.
:control: the two values of $\beta$ exchanged
:::
*/
CLAIM(convex_polygon_prefers_the_bezier_curve) { G(refute_closer_to_a_convex_polygon)(T, 7); }

/*
On the other side of 0 it is the same: one convex polygon is nearer to the curve of $\beta=-2$, another to the Bézier curve.

:::{claim} convex_polygon_prefers_zero_to_minus_two
:title: A convex polygon to which the Bézier curve is closer than the curve of beta = -2
:zh: 凸多边形:七次 Bezier 曲线比 β=-2 的曲线更近
:kind: counterexample
:data: P = (-6,-4) (-5,-2) (-3,0) (0,1) (1,1) (4,-1) (5,-3) (5,-6); β = 0 -2; r² = 6/5
:instead: β = -2 0
:result: t of a farther point = 15/32 31/64
:given: a convex polygon, the $\beta$ of the Bézier curve and a negative one, and the square of a distance; printed and corrected functions
:then: for the first $\beta$ every point of the curve is nearer to the polygon than $r$, for the second some point is farther
:method: Nearer on all of $[0,1]$: the interval is cut until on each piece one edge is near, decided by signs of polynomials.  Farther: one
  rational $t$ and all edges.  `hull.h` decides that the polygon is convex.
:control: the two values of $\beta$ exchanged
:::
*/
CLAIM(convex_polygon_prefers_zero_to_minus_two) { G(refute_closer_to_a_convex_polygon)(T, 7); }

/*
:::{claim} convex_polygon_prefers_minus_two
:title: A convex polygon to which the curve of beta = -2 is closer than the Bézier curve
:zh: 凸多边形:β=-2 的曲线更近
:kind: decision
:data: P = (-1,-2) (2,0) (3,1) (4,3) (-2,4) (-4,-2) (-4,-3) (-3,-3); β = -2 0; r² = 11/2
:instead: β = 0 -2
:result: t of a farther point = 35/64 35/64
:given: a convex polygon, a negative $\beta$ and that of the Bézier curve, and the square of a distance; printed and corrected functions
:then: for the first $\beta$ every point of the curve is nearer to the polygon than $r$, for the second, the Bézier curve,
  some point is farther
:method: Nearer on all of $[0,1]$: the interval is cut until on each piece one edge is near, decided by signs of polynomials.  Farther: one
  rational $t$ and all edges.  `hull.h` decides that the polygon is convex.
:degrees: 7..7
:scope: the stated polygon
:control: the two values of $\beta$ exchanged
:::
*/
CLAIM(convex_polygon_prefers_minus_two) { G(agree_closer_to_a_convex_polygon)(T); }
#endif

/*
:::{statement} deng-zhang-2022:property-3.5-c-bezier
:title: The curve is closer than the C-Bézier curve of degree seven
:zh: 比七次 C-Bezier 曲线更优
:printed: so the curve approximates better than the C-Bézier curve of degree seven
:reading: larger_beta_takes_the_curve_away_from_its_polygon | with the Bézier curve in the place of the C-Bézier curve, as the word "so" suggests, and
  $\beta=1$, the right end of the range, for the curve that is compared with it
:reading: with C-Bézier curves, built with sines and cosines: neither defined nor compared in the text, so that nothing is there
  to be decided
:figure: closer_or_not

The conclusion "so" has no premise about C-Bézier curves.
:::
*/
#include "chapters/judge/claims_off.h"
