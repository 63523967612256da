/*
# Crossing a line (变差缩减性)

A plane curve is nowhere more winding than its polygon: no line is crossed by the curve more often than by
the polygon.  What is counted decides whether this is true.  A *crossing* is a change of side: a tangent
has a point in common with the curve and crosses nothing, and neither does an end on the line.

The source derives the property from Descartes' rule of signs.  Every step of its chain is decided by
itself in the next section.  Here the property is tried on designed curves, and cutting corners, by which it can be proved
without Descartes, is tried on patterns of signs.
*/
#include "chapters/rational-bezier/crossings.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch3:prop-3.2.7
:title: A line crosses the curve no more often than the polygon
:zh: 变差缩减性
:printed: For a plane rational Bézier curve and any line $L$ of its plane the number $I(\mathbf R,L)$ of intersections of the curve with $L$ is
  at most the number $I(\mathbf B,L)$ of intersections of the B-net with $L$; here the number of intersections is how often $L$ is crossed.
:holds-by: positive_terms_make_a_convex_mean mean_grows_by_one_term ratio_is_an_increasing_bijection
  change_of_parameter_acts_on_one_factor factor_of_a_positive_root_adds_a_sign_change
  averages_between_neighbours_keep_sign_changes sign_changes_are_counted_one_by_one bernstein_sum_of_powers_is_a_power
:confirmed-by: designed_curves_cross_no_more
:needs: mixed_weights_cross_more | § 3.2, after definition 3.2.1: one usually prescribes $\omega_i>0$ | the weights are positive
:meant: its last clause: the number is how often $L$ is crossed | Crossings, counted along the curve and along the
  polygon, also when edges, ends or the whole curve are on the line.
:reading: designed_curves_meet_no_more | The common points of the curve with $L$, ends and tangents included and counted along the curve, are at
  most as many as the points and runs of edges that the B-net has on $L$, where the curve is not contained in $L$.
:reading: self_crossing_polygon_meets_the_line_once | The common points of the curve with $L$ are at most as many as those of the B-net, each
  point of the plane counted once however often curve or B-net run through it.
:figure: line_crossings

The chain of the source proves it, for every degree and every line, the $y_i$ being the values of its form at the vertices: a crossing is a root of the numerator, which is a polynomial in $s=\frac t{1-t}$ times a positive function, the positive
roots of which are no more than its changes of sign, and these are the crossings of the polygon.  Where this polynomial is $0$, all $y_i$ are: curve and
polygon are inside the line, and neither crosses it.
:::

:::{statement} wang-ch3:prop-3.2.7-crossings
:title: What is counted is how often the line is crossed
:zh: 交点个数指跨越次数
:definition: yes
:printed: Here the number of intersections is the number of times that $L$ is crossed.
:checked-by: sign_changes_are_counted_one_by_one
:confirmed-by: sign_changes_are_polygon_crossings designed_curves_cross_no_more
:figure: line_crossings

For the curve: the parameters in $(0,1)$ at which $y(t)$ changes its sign, $L$ being $y=0$; counted along the curve, so
that a double point on $L$ counts twice.  For the polygon: the changes of sign along it; a piece on $L$ counts once if the
polygon changes sides there, and otherwise not at all.
:::
*/

#if RATIONAL
/* Roots of g != 0 in (0,1) where it changes its sign, by Sturm's theorem. */
static int crossings_by_sturm(poly g)
{
    poly factor[MAX_DEGREE + 1], odd = poly_constant(from_int_q(1));
    int multiplicity[MAX_DEGREE + 1], factors = poly_squarefree(g, factor, multiplicity);
    for (int k = 0; k < factors; k++)
        if (multiplicity[k] % 2 == 1)
            odd = poly_mul(odd, factor[k]);
    num_q one = from_int_q(1);
    return sturm_count(odd, from_int_q(0), one) - is_zero_q(poly_value(odd, one));
}

/* One designed curve: its points and weights, and the numerator of y. */
static poly designed_curve(int n, int family, const int y[], num_q R[], num_q w[])
{
    num_q b[MAX_DEGREE + 1];
    graph_of_signs(n, y, R);
    for (int i = 0; i <= n; i++) {
        w[i] = designed_weight(family, n, i);
        b[i] = mul_q(w[i], R[2 * i + 1]);
    }
    return poly_from_bernstein(n, b);
}

/*
The property is tried where it is most in danger: with vertices and whole edges on the line, where
crossings and common points part ways, and with weights that differ by many powers of ten, which press the curve
against single vertices.  Signs are all that matters, so a few heights will do.

:::{claim} designed_curves_cross_no_more
:title: Crossings of curves and polygons, counted exactly
:zh: 跨越次数的精确计数
:kind: decision
:given: all $y_i\in\{-1,0,1\}$, $x_i=i$, the line $y=0$; weights $1$; $1000$ and $1$ in turn; $10^i$; $\frac1{1000}$ inside and $1$
  at the ends
:let: $V$ the number of changes of sign, where zeros are left out
:then: the curve crosses the line at most as often as the polygon; even the roots with multiplicity in $(0,1)$ are at most $V$,
  and differ from it by an even number; for a curve inside the line both numbers of crossings are $0$
:method: Crossings of the curve by Descartes' rule in the Bernstein basis with subdivision, and by Sturm's theorem for the product
  of the factors of odd multiplicity.
:degrees: 1..5
:scope: the stated polygons and weights
:control: the polygon without its first vertex
:::
*/
CLAIM(designed_curves_cross_no_more)
{
    int n = T->degree;
    for (int family = 0; family < FAMILIES; family++)
        for (int code = 0; code < patterns(n + 1); code++) {
            int y[MAX_DEGREE + 1];
            num R[2 * (MAX_DEGREE + 1)], w[MAX_DEGREE + 1];
            region_mark mark = region_open();
            sign_pattern_of(code, n + 1, y);
            poly g = designed_curve(n, family, y, R, w);
            struct cagd_curve_meets_line curve = curve_meets_line(n, R, w, horizontal_axis());
            int polygon = polygon_crossings(fault(T, n, n - 1), fault(T, R, R + 2), horizontal_axis());
            agree(T, curve.crossings <= polygon);
            agree(T, curve.contained == poly_is_zero(g));
            if (poly_is_zero(g)) {
                agree(T, polygon == 0 && curve.crossings == 0);
            } else {
                int counted = count_roots(g, from_int(0), from_int(1), OPEN).counted;
                agree(T, crossings_by_sturm(g) == curve.crossings);
                agree(T, counted <= polygon && (polygon - counted) % 2 == 0);
            }
            region_drop(mark);
        }
}

/*
:::{claim} designed_curves_meet_no_more
:title: Common points of curves and polygons with a line, counted exactly
:zh: 公共点数的精确计数
:kind: decision
:given: all $y_i\in\{-1,0,1\}$, not all $0$, $x_i=i$, the line $y=0$; weights $1$; $1000$ and $1$ in turn; $10^i$; $\frac1{1000}$ inside and
  $1$ at the ends
:then: the curve has on $[0,1]$ at most as many parameters on the line as the polygon has maximal pieces (points or runs of
  edges) on it
:method: Counted by Descartes' rule in the Bernstein basis and by Sturm's theorem.
:degrees: 1..5
:scope: the stated polygons and weights
:argued: every n, all points and all positive weights | An end on the line is a piece of its own, every change of sign of the heights gives a piece between, and the roots
  inside are no more than these changes, as for crossings.
:control: the pieces without those at the ends
:::
*/
CLAIM(designed_curves_meet_no_more)
{
    int n = T->degree;
    for (int family = 0; family < FAMILIES; family++)
        for (int code = 0; code < patterns(n + 1); code++) {
            int y[MAX_DEGREE + 1];
            num R[2 * (MAX_DEGREE + 1)], w[MAX_DEGREE + 1];
            region_mark mark = region_open();
            sign_pattern_of(code, n + 1, y);
            poly g = designed_curve(n, family, y, R, w);
            if (!poly_is_zero(g)) {
                struct cagd_curve_meets_line curve = curve_meets_line(n, R, w, horizontal_axis());
                int pieces = polygon_meets_line(n, R, horizontal_axis()).common_runs;
                pieces -= fault(T, 0, (y[0] == 0) + (y[n] == 0));
                int at_zero = is_zero_q(poly_value(g, from_int(0)));
                agree(T, curve.common_closed <= pieces);
                agree(T, sturm_count(g, from_int(0), from_int(1)) + at_zero == curve.common_closed);
            }
            region_drop(mark);
        }
}

/*
Nor is the polygon's number too large: there are curves that cross as often as their polygons.

:::{claim} crossings_reach_their_bound
:title: A curve that crosses as often as its polygon
:zh: 上界可以达到
:kind: decision
:given: $y(t)=\prod_{j=1}^n(t-j(1-t))$, all weights $1$
:then: the polygon crosses $y=0$ exactly $n$ times, and so does the curve
:method: The Bernstein coefficients are those of $\prod(s-j)$ divided by $\binom ni$; both numbers are counted exactly.
:degrees: 1..10
:scope: this curve
:control: the factor $s+1$ taken for $s-1$
:::
*/
CLAIM(crossings_reach_their_bound)
{
    int n = T->degree;
    num c[MAX_DEGREE + 1], R[2 * (MAX_DEGREE + 1)], w[MAX_DEGREE + 1];
    poly product = poly_constant(from_int(1));
    for (int j = 1; j <= n; j++) {
        num factor[2] = {from_int(fault(T, -j, j == 1 ? 1 : -j)), from_int(1)};
        product = poly_mul(product, poly_from_q(2, factor));
    }
    for (int i = 0; i <= n; i++) {
        c[i] = div(poly_coefficient(product, i), from_int(binomial(n, i)));
        R[2 * i] = from_int(i);
        R[2 * i + 1] = c[i];
        w[i] = from_int(1);
    }
    agree(T, polygon_crossings(n, R, horizontal_axis()) == n);
    agree(T, curve_meets_line(n, R, w, horizontal_axis()).crossings == n);
    agree(T, crossings_by_sturm(poly_from_bernstein(n, c)) == n);
}

/*
The number is counted along the curve and along the polygon.  If one counted points of the plane instead, a polygon that
crosses itself on the line would count once where the curve meets the line twice.

:::{claim} self_crossing_polygon_meets_the_line_once
:title: Counted as points of the plane, the curve meets the line more often than the polygon
:zh: 若按平面点计数, 自交多边形给出反例
:kind: counterexample
:data: R = (-1,1) (1,-1) (-1,-1) (1,1); ω = 2 1 1 2; t = 1/3 2/3
:result: R(t) = (-2/9,0) (2/9,0); points of the curve on the line = 2; points of the polygon on the line = 1
:given: the cubic curve with points $R$ and weights $\omega$; the line $y=0$
:then: the polygon has one point on the line, where its first and last edge cross; the curve has two
:method: The curve is evaluated at the parameters $t$, which are all its roots; the connected parts of the
  polygon on the line are counted.
:control: crossings counted along curve and polygon instead: two and two
:::
*/
CLAIM(self_crossing_polygon_meets_the_line_once)
{
    enum { n = 3 };
    num R[2 * (n + 1)], w[n + 1], t[2], P[4];
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    given_points(T, "t", 2, 1, t);
    for (int k = 0; k < 2; k++)
        G(rational_point)(n, 2, R, w, t[k], P + 2 * k);
    found_points(T, "R(t)", 2, 2, P);
    struct cagd_curve_meets_line curve = curve_meets_line(n, R, w, horizontal_axis());
    struct cagd_polygon_meets_line polygon = polygon_meets_line(n, R, horizontal_axis());
    int all = curve.common_closed == 2 && is_zero_q(P[1]) && is_zero_q(P[3]);
    int points = fault(T, curve.crossings, 1 + !equal_q(P[0], P[2]));
    int of_polygon = fault(T, polygon.crossings, polygon.components);
    found_whole(T, "points of the curve on the line", points);
    found_whole(T, "points of the polygon on the line", of_polygon);
    about(T, "R(t) being all its points on the line, the curve has no more there than the polygon");
    refute(T, all && points > of_polygon);
}

/*
Nothing of this is left for weights of both signs.  The middle vertex, with its negative weight, pushes the curve
through a line from which the polygon keeps away.

:::{claim} mixed_weights_cross_more
:title: With weights of both signs a curve can cross a line that the polygon does not meet
:zh: 权因子变号时变差缩减性可不成立
:kind: counterexample
:data: R = (-1,2) (0,5) (1,2); ω = 2 -1 2; t = 1/3 2/3
:instead: ω = 2 1 2
:result: y(t) = 0 0; crossings of the curve = 2; crossings of the polygon = 0; poles = 0
:given: the quadratic curve with points $R$ and weights $\omega$, of which the middle one is negative, though $\omega(t)>0$ on $[0,1]$; the
  line $y=0$
:then: the curve crosses it twice, at the parameters $t$; the polygon is above it
:method: Crossings counted exactly; poles too, of which there is none.
:control: the middle weight made positive
:::
*/
CLAIM(mixed_weights_cross_more)
{
    enum { n = 2 };
    num R[2 * (n + 1)], w[n + 1], t[2], y[2];
    given_points(T, "R", n + 1, 2, R);
    given_points(T, "ω", n + 1, 1, w);
    given_points(T, "t", 2, 1, t);
    for (int k = 0; k < 2; k++) {
        num P[2];
        G(rational_point)(n, 2, R, w, t[k], P);
        y[k] = P[1];
    }
    struct cagd_curve_meets_line curve = curve_meets_line(n, R, w, horizontal_axis());
    int polygon = polygon_crossings(n, R, horizontal_axis());
    found_points(T, "y(t)", 2, 1, y);
    found_whole(T, "crossings of the curve", curve.crossings);
    found_whole(T, "crossings of the polygon", polygon);
    found_whole(T, "poles", curve.poles);
    about(T, "a curve without poles crosses y = 0 no more often than the polygon");
    refute(T, curve.poles == 0 && curve.crossings > polygon);
}

/*
:::{statement} wang-ch3:prop-3.2.7-Z-V
:title: Roots of a function and changes of sign of a sequence
:zh: 根数 Z 与变号数 V
:definition: yes
:printed: $Z[f(t)]$ denotes the number of roots of $f(t)$ in $(a,b)$, $V[a_i]$ the number of changes of sign in the sequence $a_i$
  when its zeros are removed.
:checked-by: sign_changes_are_counted_one_by_one factor_of_a_positive_root_adds_a_sign_change
  averages_between_neighbours_keep_sign_changes
:confirmed-by: designed_curves_cross_no_more designed_curves_meet_no_more

The symbol $Z$ has no place for the interval $(a,b)$ in the text at hand.  Whether a multiple root counts once or as often as its multiplicity is not said; no
step of the chain depends on it.
:::
*/

/*
Means of neighbours do not change their sign more often than the numbers of which they are means; for this the
numbers do not matter, only their signs.

:::{claim} corner_cutting_adds_no_sign_change
:title: Means of neighbours change sign no more often, in low degrees
:zh: 相邻项的凸组合不增加变号数
:kind: decision
:given: numbers $y_0,\dots,y_n$ and $\hat y_i$, $0\le i\le n+1$, with $\hat y_0=y_0$, $\hat y_{n+1}=y_n$, and $\hat y_i$ a mean
  of $y_{i-1}$ and $y_i$ with positive factors
:let: $V$ the number of changes of sign, where zeros are left out
:then: $V[\hat y_0,\dots,\hat y_{n+1}]\le V[y_0,\dots,y_n]$
:method: Only signs matter.  All patterns of signs $-,0,+$ of the $y_i$ are run through, and for each all patterns of the
  $\hat y_i$ that are possible: the sign of a mean is that of both numbers, or of the one that is not $0$, or, for
  different signs, any.  For every $n$ it follows from `averages_between_neighbours_keep_sign_changes`: put
  the means in, one by one, and then take the old inner numbers away.
:degrees: 1..6
:scope: all patterns of signs
:where: the factors of the means are positive
:control: a mean of two positive numbers taken to be possibly negative
:::
*/
CLAIM(corner_cutting_adds_no_sign_change)
{
    int n = T->degree;
    for (int code = 0; code < patterns(n + 1); code++) {
        int y[MAX_DEGREE + 1], mean[MAX_DEGREE + 2], most = 0;
        sign_pattern_of(code, n + 1, y);
        mean[0] = y[0];
        mean[n + 1] = y[n];
        for (int choice = 0; choice < patterns(n); choice++) {
            int possible = 1;
            sign_pattern_of(choice, n, mean + 1);
            for (int i = 1; i <= n; i++) {
                int opposite = y[i - 1] * y[i] < 0, larger_one = y[i] != 0 ? y[i] : y[i - 1];
                int allowed = fault(T, opposite || mean[i] == larger_one,
                                    opposite || mean[i] == larger_one || (y[i] > 0 && y[i - 1] > 0));
                possible &= allowed;
            }
            int changes = sign_changes(n + 2, mean);
            most = possible && changes > most ? changes : most;
        }
        agree(T, most <= sign_changes(n + 1, y));
    }
}
#endif

#include "chapters/judge/claims_off.h"
