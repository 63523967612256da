/*
# A line meets a NURBS curve (变差缩减性)

The second property that corner cutting gives: a line has no more to do with the curve than with its polygon.  The
proof is that an insertion of a knot puts points on the edges, which changes nothing, and then takes the old vertices
away, which replaces two sides of a triangle by the third; and that by insertion every point of the curve becomes a
vertex.

What is counted decides whether it is true.  The source says *number of points of intersection* and nothing more.
Counted along the curve and along the polygon it is true: for crossings, which are changes of side, and for common
points too, if an edge or a piece of curve on the line counts as one intersection.  As points of the plane, each
counted once however often the polygon runs through it, it is false; and it is false if an edge on the line is not
counted, or, for insertion, if it counts as infinitely many points.
*/
#include "chapters/nurbs/corner-cutting.h"
#include "chapters/nurbs/definition.h"

#include <stdio.h>

#if RATIONAL
#include "exact/record/crossings.h"
#include "exact/record/roots.h"
#endif

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch4:lemma-4.2.2-count
:title: The number of intersections with a line
:zh: 交点个数 I(Γ,L)
:definition: yes
:printed: $I(\Gamma,\boldsymbol L)$ is the number of points of intersection of the plane curve $\Gamma$ and a line $\boldsymbol L$ of its
  plane
:checked-by: designed_splines_cross_no_more designed_splines_meet_no_more
:meant: the words 交点个数, number of points of intersection | Points of the plane.
:reading: designed_splines_cross_no_more | lemma and theorem 4.2.2 for crossings: how often the curve changes sides, counted along the curve
:reading: designed_splines_meet_no_more | lemma and theorem for common points counted along the curve, a piece on the line counting once
:reading: touching_point_is_no_crossing | that these two counts are one: a curve may touch the line, in a common point that is no crossing
:reading: self_crossing_polygon_gains_points_on_a_line | the lemma for points of the plane, each counted once
:reading: edge_on_the_line_must_be_counted | lemma and theorem for points that are not on an edge or piece of curve on the line
:reading: self_crossing_polygon_meets_the_line_less_than_its_spline | the theorem for points of the plane, each counted once
:reading: cut_corner_lies_on_the_line | the lemma for points, of which an edge on the line has infinitely many
:figure: what_must_be_counted

As a definition it states nothing; the readings say whether lemma 4.2.2 and theorem 4.2.2 are true or false with them, the true ones for the designed curves.
:::
*/

#if RATIONAL
enum { MOST_POINTS = 40 };

static struct cagd_line x_axis(void) { return (struct cagd_line){from_int_q(0), from_int_q(1), from_int_q(0)}; }

/* How the curve of heights y(t) = sum N_i c_i / (something positive) meets the axis; numbered from 1. */
struct spline_meets_axis {
    int crossings; /* changes of side, jumps included                                          */
    int common;    /* parameters on the axis, an interval of them counted once                 */
};
static struct spline_meets_axis spline_meets_axis(int n, int k, const num_q t[], const num_q c[])
{
    struct spline_meets_axis m = {0};
    int side = 0, on_the_axis = 0, p = k - 1;
    for (int j = k; j <= n; j++) {
        num_q b[MAX_DEGREE + 1];
        int low = 0, high = p;
        if (compare_q(t[j], t[j + 1]) == 0)
            continue;
        bspline_to_bezier_q(on_span_q(p, 1, t + 1, j - 1, c + 1), b);
        while (low <= p && is_zero_q(b[low]))
            low++;
        while (high >= 0 && is_zero_q(b[high]))
            high--;
        if (low > p) { /* the whole interval */
            m.common += !on_the_axis;
            on_the_axis = 1;
            continue;
        }
        struct cagd_root_count inner = count_roots(poly_from_bernstein(p, b), from_int_q(0), from_int_q(1), OPEN);
        m.crossings += side * sign_q(b[low]) < 0;
        m.crossings += inner.crossings;
        m.common += (low > 0 && !on_the_axis) + inner.distinct + (high < p);
        side = sign_q(b[high]);
        on_the_axis = high < p;
    }
    return m;
}

/* mu with t_mu < tau <= t_{mu+1}. */
static int place_of(int count, const num_q t[], num_q tau)
{
    int mu = 0;
    while (mu < count && compare_q(t[mu + 1], tau) < 0)
        mu++;
    return mu;
}

/* A curve of the plane with points (i, y_i), numbered from 1. */
struct graph {
    int n, k;
    num_q t[MOST_POINTS], r[2 * MOST_POINTS], w[MOST_POINTS];
};

/* Points (i, y_i), the weights of odd i heavy and the others 1. */
static void graph_of(struct graph *g, int n, int k, const long knot[], const num_q y[], num_q heavy)
{
    g->n = n;
    g->k = k;
    for (int i = 1; i <= n + k; i++)
        g->t[i] = from_int_q(knot[i - 1]);
    for (int i = 1; i <= n; i++) {
        g->r[2 * i] = from_int_q(i);
        g->r[2 * i + 1] = y[i - 1];
        g->w[i] = i % 2 == 1 ? heavy : from_int_q(1);
    }
}

static struct graph with_knot(const struct graph *g, num_q tau)
{
    struct graph out = {.n = g->n + 1, .k = g->k};
    int mu = place_of(g->n + g->k, g->t, tau);
    printed_insertion_q(g->n, g->k, 2, g->t, mu, tau, g->r, g->w, out.t, out.r, out.w);
    return out;
}

static struct spline_meets_axis curve_of(const struct graph *g)
{
    num_q c[MOST_POINTS];
    for (int i = 1; i <= g->n; i++)
        c[i] = mul_q(g->w[i], g->r[2 * i + 1]);
    return spline_meets_axis(g->n, g->k, g->t, c);
}
static struct cagd_polygon_meets_line polygon_of_graph(const struct graph *g)
{
    return polygon_meets_line(g->n - 1, g->r + 2, x_axis());
}

/* The middles of all intervals of the domain, inserted. */
static struct graph with_middles(const struct graph *g)
{
    struct graph out = *g;
    for (int j = g->k; j <= g->n; j++)
        if (compare_q(g->t[j], g->t[j + 1]) < 0)
            out = with_knot(&out, mul_q(from_ratio_q(1, 2), add_q(g->t[j], g->t[j + 1])));
    return out;
}

static const struct {
    int k, n;
    long knot[11];
} knots_of_designed[] = {
    {2, 4, {0, 0, 1, 2, 3, 3}},
    {2, 6, {0, 0, 1, 1, 2, 3, 4, 4}},
    {3, 5, {0, 1, 2, 3, 4, 5, 6, 7}},
    {3, 5, {0, 0, 0, 1, 3, 4, 4, 4}},
    {3, 5, {0, 0, 0, 1, 1, 3, 3, 3}},
    {3, 6, {0, 0, 0, 2, 2, 2, 3, 3, 3}},
    {4, 5, {0, 1, 2, 4, 5, 6, 8, 9, 10}},
    {4, 6, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}},
    {4, 7, {0, 0, 0, 0, 2, 2, 2, 3, 3, 3, 3}},
};
enum { DESIGNED = sizeof knots_of_designed / sizeof *knots_of_designed };

static int sign_patterns(int n) { return n == 0 ? 1 : 3 * sign_patterns(n - 1); }

/* Runs through the designed curves of order k up to the sign of y, with the ordinates y and the weight w of a block, and asks
 * each whether it is as it should be. */
static void for_designed(trial *T, int (*good)(const struct graph *g, int faulty))
{
    num ordinate[3], weight[2] = {from_int(1), from_int(1)};
    given_points(T, "y", 3, 1, ordinate);
    weight[1] = given(T, "w");
    for (int example = 0; example < DESIGNED; example++) {
        int n = knots_of_designed[example].n, k = knots_of_designed[example].k;
        for (int code = 0; code <= sign_patterns(n) / 2 && k == T->degree; code++) {
            num y[MOST_POINTS];
            for (int i = 0, rest = code; i < n; i++, rest /= 3)
                y[i] = ordinate[rest % 3];
            for (int family = 0; family < 2; family++) {
                struct graph g;
                region_mark mark = region_open();
                graph_of(&g, n, k, knots_of_designed[example].knot, y, weight[family]);
                agree(T, good(&g, T->faulty));
                region_drop(mark);
            }
        }
    }
}

/*
A crossing (跨越) is a change of side, and a curve that only touches the line has none.  The two counts are compared on
curves that were designed for this: the ordinates are $-1$, 0 and 1 in every arrangement, so that vertices, edges and
pieces of the curve lie on the line as often as possible, and inner knots have the multiplicities 1, $k-1$ and, up to order 3, $k$.
Between curve and polygon stands a third count, that of the polygon after an insertion.

:::{claim} designed_splines_cross_no_more
:title: Designed splines cross a line no more often than their polygons
:zh: 设计算例的跨越次数
:kind: decision
:given: the designed curves of order $k$: simple knots for $k\ge3$; ends of multiplicity $k$ and inner knots of multiplicity 1, $k-1$
  and, for $k\le3$, $k$; all ordinates among the $y$; the weights 1, and $w$ and 1 in turn
:data: y = -1 0 1; w = 1000
:then: crossings of the curve $\le$ crossings of the polygon with the middles of all intervals inserted $\le$
  crossings of the polygon
:method: The curve as polynomials, interval by interval, by counting roots of odd multiplicity and by comparing the
  sides on which one interval ends and the next one begins; jumps are counted.  Polygons by
  `exact/decide/crossings.h`.  Of ordinates and their negatives one is taken.
:degrees: k = 2..4
:scope: the stated curves
:control: the polygon taken without its first vertex
:::
*/
static int crosses_no_more(const struct graph *g, int faulty)
{
    struct graph cut = with_middles(g);
    int polygon = polygon_crossings(g->n - 1 - faulty, g->r + 2 + 2 * faulty, x_axis());
    int between = polygon_of_graph(&cut).crossings;
    return curve_of(g).crossings <= between && between <= polygon;
}

CLAIM(designed_splines_cross_no_more) { for_designed(T, crosses_no_more); }

/*
:::{claim} designed_splines_meet_no_more
:title: Designed splines have no more in common with a line than their polygons
:zh: 设计算例的公共点
:kind: decision
:given: the designed curves of order $k$: simple knots for $k\ge3$; ends of multiplicity $k$ and inner knots of multiplicity 1, $k-1$
  and, for $k\le3$, $k$; all ordinates among the $y$; the weights 1, and $w$ and 1 in turn
:data: y = -1 0 1; w = 1000
:then: common points of the curve, ends and tangents included, pieces on the line counted once, $\le$ those of the
  polygon with knots inserted $\le$ those of the polygon
:method: The curve by counting different roots, interval by interval; polygons by `exact/decide/crossings.h`.  Of ordinates and their negatives one is
  taken.
:degrees: k = 2..4
:scope: the stated curves
:control: the ends of the polygon not counted
:::
*/
static int meets_no_more(const struct graph *g, int faulty)
{
    struct graph cut = with_middles(g);
    int ends = is_zero_q(g->r[3]) + is_zero_q(g->r[2 * g->n + 1]);
    int polygon = polygon_of_graph(g).common_runs - (faulty ? ends : 0);
    int between = polygon_of_graph(&cut).common_runs;
    return curve_of(g).common <= between && between <= polygon;
}

CLAIM(designed_splines_meet_no_more) { for_designed(T, meets_no_more); }

/* The curve of a block: its order k, its n points r_i with weights w_i, and the n+k knots t_i. */
static struct graph given_graph(trial *T)
{
    struct graph g;
    g.k = given_whole(T, "k");
    g.n = given_whole(T, "n");
    given_points(T, "t_i", g.n + g.k, 1, g.t + 1);
    given_points(T, "r_i", g.n, 2, g.r + 2);
    given_points(T, "w_i", g.n, 1, g.w + 1);
    return g;
}

/*
Whoever counts points of the plane counts a point once, although two edges pass through it.  An insertion can pull
these two passages apart.  The polygon of the next claim crosses itself on the line; four insertions later there are
two points in the place of one, while the number of crossings has not changed.

:::{claim} self_crossing_polygon_gains_points_on_a_line
:title: A polygon that crosses itself on the line has two points there after an insertion
:zh: 自交于直线的多边形嵌节点后交点增多
:kind: counterexample
:given: a NURBS curve of order $k$ with the $n$ points $r_i$, weights $w_i$ and knots $t_i$; the line $y=0$; knots
  $T'$ to be inserted
:data: k = 3; n = 4; t_i = 0 0 0 1 2 2 2; r_i = (-1,1) (1,-1) (-1,-1) (1,1); w_i = 3 1 1 3; T' = 1/2 1/2 3/2 3/2
:then: the polygon has one point on the line, the new polygon two
:result: new points = (-1,1) (-1/2,1/2) (-1/6,0) (1/2,-1) (-1/2,-1) (1/6,0) (1/2,1/2) (1,1); points of the polygon on
  the line = 1; points of the new polygon on the line = 2
:method: The printed insertions, one after the other; connected parts of the set of common points are counted by
  `exact/decide/crossings.h`.
:control: crossings counted: two and two
:::
*/
CLAIM(self_crossing_polygon_gains_points_on_a_line)
{
    enum { INSERTED = 4 };
    struct graph g = given_graph(T);
    num inserted[INSERTED];
    given_points(T, "T'", INSERTED, 1, inserted);
    struct graph cut = g;
    for (int m = 0; m < INSERTED; m++)
        cut = with_knot(&cut, inserted[m]);
    struct cagd_polygon_meets_line before = polygon_of_graph(&g), after = polygon_of_graph(&cut);
    int old = fault(T, before.crossings, before.components), new = fault(T, after.crossings, after.components);
    found_points(T, "new points", cut.n, 2, cut.r + 2);
    found_whole(T, "points of the polygon on the line", old);
    found_whole(T, "points of the new polygon on the line", new);
    about(T, "the new polygon has no more");
    agree(T, new <= old);
}

/*
The other two counts fail at an edge on the line.  If it does not count, a polygon may have nothing in common with a
line that its curve has to cross; if it counts with all its points, it is enough to cut a corner parallel to the line.

:::{claim} edge_on_the_line_must_be_counted
:title: A polygon with nothing but an edge on the line, and a curve that crosses it
:zh: 落在直线上的边必须计入
:kind: counterexample
:given: a cubic Bézier curve as a NURBS curve of order $k$ with the $n$ points $r_i$, weights $w_i$ and knots $t_i$;
  the line $y=0$; the parameter $\tau$ where the curve crosses it is inserted $k-1$ times, as in the proof of theorem 4.2.2
:data: k = 4; n = 4; t_i = 0 0 0 0 1 1 1 1; r_i = (0,1) (1,0) (2,0) (3,-1); w_i = 1 1 1 1; τ = 1/2
:then: outside its edge on the line the polygon has no common point with it; the new polygon has a vertex on the line
  and no edge there, and the curve crosses the line
:result: new points = (0,1) (1/2,1/2) (1,1/4) (3/2,0) (2,-1/4) (5/2,-1/2) (3,-1); intersections of the polygon, the edge on the line
  left out = 0; intersections of the new polygon = 1; intersections of the curve = 1
:method: Common points less those on edges of the polygon; the curve by counting roots.
:control: the edge counted as one intersection
:::
*/
CLAIM(edge_on_the_line_must_be_counted)
{
    struct graph g = given_graph(T), cut = g;
    num tau = given(T, "τ");
    for (int times = 1; times < g.k; times++)
        cut = with_knot(&cut, tau);
    struct cagd_polygon_meets_line before = polygon_of_graph(&g), after = polygon_of_graph(&cut);
    int old = before.common_runs - fault(T, 0, before.contained_edges);
    int new = after.common_runs - fault(T, 0, after.contained_edges), curve = curve_of(&g).common;
    found_points(T, "new points", cut.n, 2, cut.r + 2);
    found_whole(T, "intersections of the polygon, the edge on the line left out", old);
    found_whole(T, "intersections of the new polygon", new);
    found_whole(T, "intersections of the curve", curve);
    about(T, "the new polygon has no more than the old one, or the curve has no more");
    refute(T, new > old &&curve > old);
}

/*
:::{claim} cut_corner_lies_on_the_line
:title: A corner cut along the line puts an edge on it
:zh: 沿直线割角
:kind: counterexample
:given: a parabola as a NURBS curve of order $k$ with the $n$ points $r_i$, weights $w_i$ and knots $t_i$; the line
  $y=h$; the knot $\tau$ is inserted
:data: k = 3; n = 3; t_i = 0 0 0 2 2 2; r_i = (0,0) (1,1) (2,0); w_i = 1 1 1; h = 1/2; τ = 1
:then: the polygon has two points on the line; the new polygon has an edge on it, infinitely many points
:result: new points = (0,0) (1/2,1/2) (3/2,1/2) (2,0); points of the polygon on the line = 2; edges of the new polygon
  on the line = 1
:method: The printed insertion; points and edges by `exact/decide/crossings.h`, the heights taken less $h$.
:control: the edge counted as one intersection
:::
*/
CLAIM(cut_corner_lies_on_the_line)
{
    struct graph g = given_graph(T);
    struct cagd_line line = {from_int(0), from_int(1), neg(given(T, "h"))};
    struct graph cut = with_knot(&g, given(T, "τ"));
    struct cagd_polygon_meets_line before = polygon_meets_line(g.n - 1, g.r + 2, line),
                                   after = polygon_meets_line(cut.n - 1, cut.r + 2, line);
    int finite = before.contained_edges == 0, infinite = fault(T, 0, after.contained_edges > 0);
    found_points(T, "new points", cut.n, 2, cut.r + 2);
    found_whole(T, "points of the polygon on the line", before.common_runs);
    found_whole(T, "edges of the new polygon on the line", after.contained_edges);
    about(T, "the new polygon has no more points on the line");
    refute(T, finite && (infinite || after.common_runs > before.common_runs));
}

#if RATIONAL
/*
:::{claim} touching_point_is_no_crossing
:title: A parabola that touches the line has a common point with it and does not cross it
:zh: 切点不是跨越点
:kind: counterexample
:given: a parabola as a NURBS curve of order $k$ with the $n$ points $r_i$, weights $w_i$ and knots $t_i$; the line $y=0$
:data: k = 3; n = 3; t_i = 0 0 0 1 1 1; r_i = (0,1) (1,-1) (2,1); w_i = 1 1 1
:instead: r_i = (0,1) (1,-1) (2,-1)
:then: the curve has one point on the line and no crossing; its polygon crosses the line twice
:result: crossings of the curve = 0; points of the curve on the line = 1; crossings of the polygon = 2
:method: The curve by its roots and their multiplicities.
:control: a last point on the other side
:::
*/
CLAIM(touching_point_is_no_crossing)
{
    struct graph g = given_graph(T);
    struct spline_meets_axis curve = curve_of(&g);
    found_whole(T, "crossings of the curve", curve.crossings);
    found_whole(T, "points of the curve on the line", curve.common);
    found_whole(T, "crossings of the polygon", polygon_of_graph(&g).crossings);
    about(T, "every common point is a crossing");
    agree(T, curve.common <= curve.crossings);
}
#endif

/*
For the two counts that remain the lemma is a matter of signs.  A new vertex between $a$ and $b$ lies on their edge,
so it adds nothing; taking the vertex $a$ out replaces its two edges by one, and among the signs of neighbours no
change can arise.

:::{statement} wang-ch4:lemma-4.2.2
:title: Inserting knots adds no intersection with a line (4.2.1)
:zh: 嵌节点过程的变差缩减性
:printed: for the control polygon of the NURBS curve $\boldsymbol r_t(t)$ the insertion of any set $T'$ of knots is always variation diminishing: for every line $\boldsymbol L$ of
  the plane $I(\Gamma_k^{(T)}(\Phi),\boldsymbol L)\ge I(\Gamma_k^{(T)}(T'),\boldsymbol L)$
:holds-by: averages_between_neighbours_keep_sign_changes cut_corners_meet_a_line_no_more
  insertion_ratios_are_between_zero_and_one inserted_points_divide_the_edges printed_factors_are_the_discrete_shares
  knots_outside_the_domain_cut_corners clamped_start_inserted_again_repeats_the_first_point steps_of_refinement_compose weights_of_both_steps_are_positive knots_above_k_fold_repeat_new_points
:hypothesis: self_crossing_polygon_gains_points_on_a_line | intersections are counted along the polygon, not as points
  of the plane
:hypothesis: edge_on_the_line_must_be_counted | an edge on the line counts
:hypothesis: cut_corner_lies_on_the_line | a piece of the polygon on the line counts as one intersection: however many edges it has, and not as
  infinitely many points
:hypothesis: knot_at_a_k_fold_end_has_no_shares | every knot of $T'$ is in $(t_1,t_{n+k})$, or at $t_1$ where $t_1=t_k$: for (4.1.6)
:hypothesis: end_of_more_than_k_knots_has_no_shares | $t_n<t_{n+k}$: for (4.1.6)
:needs: insertion_with_mixed_weights_crosses_more | definition 4.1.1: $w_i>0$ | the weights are positive
:meant: section 4.1, which defines $\Gamma_k^{(T)}(T')$ | The polygon of the points (4.1.6).
:reading: averages_between_neighbours_keep_sign_changes | the step for crossings: a mean put between two neighbours changes nothing, and a number left out adds none
:reading: cut_corners_meet_a_line_no_more | the step for common points, a piece on the line counting once: a vertex put on an edge changes nothing, and one taken away adds none
:reading: knots_outside_the_domain_cut_corners | of (4.1.6), intervals closed on the left, for one knot outside the domain, too, over simple knots
:reading: knot_before_the_domain_asks_for_another_point | of the factors of the proof of lemma 4.2.1, for a knot before or behind the domain: an edge $r_0r_1$ or $r_nr_{n+1}$ would be needed
:reading: insertion_at_a_clamped_start_asks_for_another_point | of the factors of the proof of lemma 4.2.1, intervals closed on the right, for a $k$-fold $t_1$: it cannot be inserted
  again
:argued: every order and every number of points and knots | An insertion puts a point on each of some edges and takes the old
  vertices away, and where a knot is more than $k$-fold also vertices that have no share; one after the other, by (4.1.7), these are the cases that were decided.
:figure: line_and_cut_corners

The source gives no proof; the index $t$ of the curve is $k$, see `notation-order`.
:::

:::{claim} cut_corners_meet_a_line_no_more
:title: A cut corner has no more in common with a line than the corner
:zh: 割角不增加与直线的公共点
:kind: decision
:given: heights $\dots,p,a,b,s,\dots$ above a line; $c=(1-\lambda)a+\lambda b$, $0\le\lambda\le1$; intersections are
  the groups of neighbouring vertices on the line and the edges from one side to the other
:data: λ = 0 1/4 1/2 3/4 1
:instead: λ = 0 1/4 1/2 3/4 2
:then: $c$ put between $a$ and $b$ does not change their number, and taking $a$ out does not raise it
:result: cases = 81
:method: Only signs matter, and only those of neighbours: all cases of $p,a,b,s\in\{-1,0,1\}$, and the given $\lambda$
  give $c$ every sign it can have.  The number is a sum over pairs of neighbours, so this is for polygons of every length.  Where $s$ is not there, $p,a,b$ is tried, too; where $p$ is not
  there, $a$ is an end, which an insertion keeps unless it has no share: $a,b,s$ is tried, and $a,b$.
:degrees: all
:scope: every sign of four neighbouring heights and of the mean of the middle two
:harmless: $0\le\lambda\le1$ | a point of an edge is such a mean
:control: a $\lambda$ greater than 1
:::
*/
/* Groups of neighbouring zeros, and neighbours of different sign. */
static int intersections(int count, const int y[])
{
    int found = 0;
    for (int i = 0; i < count; i++)
        found += (y[i] == 0 && (i == 0 || y[i - 1] != 0)) || (i > 0 && y[i] * y[i - 1] < 0);
    return found;
}

CLAIM(cut_corners_meet_a_line_no_more)
{
    enum { MEANS = 5, PATTERNS = 3 * 3 * 3 * 3 };
    num lambda[MEANS];
    given_points(T, "λ", MEANS, 1, lambda);
    for (int pattern = 0; pattern < PATTERNS; pattern++) {
        int p = pattern % 3 - 1, a = pattern / 3 % 3 - 1, b = pattern / 9 % 3 - 1;
        int s = pattern / 27 - 1, before[] = {p, a, b, s}, shorter[] = {p, b, s};
        for (int m = 0; m < MEANS; m++) {
            int c = sign_q(add(from_int(a), mul(lambda[m], from_int(b - a)))), after[] = {p, a, c, b, s};
            agree(T, intersections(5, after) == intersections(4, before));
            for (int missing = 0; missing < 4; missing++) /* at an end */
                agree(T, intersections(5 - missing % 2 - missing / 2, after + missing % 2) ==
                             intersections(4 - missing % 2 - missing / 2, before + missing % 2));
        }
        agree(T, intersections(3, shorter) <= intersections(4, before));
        agree(T, intersections(2, shorter) <= intersections(3, before));
        for (int left = 2; left <= 3; left++) /* a is an end */
            agree(T, intersections(left - 1, before + 2) <= intersections(left, before + 1));
    }
    found_whole(T, "cases", PATTERNS);
}

/*
Positive weights are needed in one place: the new vertex has to be between the old ones.  With a negative weight it is
on the line through them and outside the edge, even where the curve itself has no pole.

:::{claim} insertion_with_mixed_weights_crosses_more
:title: With weights of both signs an insertion adds crossings
:zh: 权因子变号时嵌节点增加交点
:kind: counterexample
:given: a rational parabola as a NURBS curve of order $k$ with the $n$ points $r_i$, weights $w_i$ of both signs, for
  which $w(t)>0$, and knots $t_i$; the line $y=0$; the knot $\tau$ is inserted
:data: k = 3; n = 3; t_i = 0 0 0 1 1 1; r_i = (-1,2) (0,5) (1,2); w_i = 2 -1 2; τ = 1/2
:instead: w_i = 2 1 2
:then: the new polygon crosses the line twice, the old one does not
:result: new points = (-1,2) (-2,-1) (2,-1) (1,2); poles of the curve = 0; crossings of the polygon = 0; crossings of
  the new polygon = 2
:method: That $w$ has no zero on the closed interval is decided first; then the printed formulas; crossings by
  `exact/decide/crossings.h`.
:control: a positive weight in the middle
:::
*/
CLAIM(insertion_with_mixed_weights_crosses_more)
{
    struct graph g = given_graph(T), cut = with_knot(&g, given(T, "τ"));
    int poles = count_roots(poly_from_bernstein(g.k - 1, g.w + 1), from_int(0), from_int(1), CLOSED).distinct;
    int old = polygon_of_graph(&g).crossings, new = polygon_of_graph(&cut).crossings;
    found_points(T, "new points", cut.n, 2, cut.r + 2);
    found_whole(T, "poles of the curve", poles);
    found_whole(T, "crossings of the polygon", old);
    found_whole(T, "crossings of the new polygon", new);
    about(T, "the curve having no poles, the new polygon crosses the line no more often");
    refute(T, poles == 0 && new > old);
}
#endif

/*
:::{statement} wang-ch4:thm-4.2.2
:title: A line meets the curve no more often than the polygon (4.2.2)
:zh: 平面 NURBS 曲线的变差缩减性
:printed: plane NURBS curves are variation diminishing: with the notation of lemma 4.2.2
  $I(\Gamma_k^{(T)}(\Phi),\boldsymbol L)\ge I(\boldsymbol r_k(t),\boldsymbol L)$
:holds-by: averages_between_neighbours_keep_sign_changes cut_corners_meet_a_line_no_more
  insertion_ratios_are_between_zero_and_one inserted_points_divide_the_edges
  inserted_parameters_become_vertices line_form_of_a_nurbs_curve
:hypothesis: self_crossing_polygon_meets_the_line_less_than_its_spline | intersections are counted along curve and
  polygon, not as points of the plane
:hypothesis: edge_on_the_line_must_be_counted | a piece of curve or polygon on the line counts as one intersection: not counted it is
  too little; if pieces count as infinitely many points the theorem is true, too, since with a piece of curve its control points are on the line
:needs: mixed_weights_cross_more | definition 4.1.1: $w_i>0$ | the weights are positive
:reading: designed_splines_cross_no_more | of crossings
:reading: designed_splines_meet_no_more | of common points, a piece on the line counting once
:argued: | Insert parameters where the curve is on alternating sides until these points are vertices: the new polygon changes sides as
  often as the curve, and the old one no less often.  For common points take one parameter of each intersection and one, off the line,
  between any two; at a $k$-fold knot, also at the start or end, the point of the curve is a vertex already.
:figure: line_and_cut_corners
:::

To pass from the polygon to the curve one has to know the sign of the form $ax+by+c$ on the curve.  It is a quotient
of two splines with the same weights, and the denominator is positive; so a line may be taken as the axis, and only
heights matter.

:::{claim} line_form_of_a_nurbs_curve
:title: The form of a line, on the curve, has the weights of the curve
:zh: 曲线上的直线式仍以原权因子表示
:given: orders $k$, ends of multiplicity $k$ and a simple knot between; weights $w_i$, points $(x_i,y_i)$; a line
  $ax+by+c=0$
:then: $a\,x(t)+b\,y(t)+c=\sum_iN_{i,k}(t)w_i(ax_i+by_i+c)\big/\sum_iN_{i,k}(t)w_i$ on both intervals
:method: The curve by the kernel, the right side by the definition of B-splines; everything a variable.  So every line
  may be taken as the axis $y=0$, and $y(t)$ has the sign of $\sum N_{i,k}w_iy_i$ for positive weights.
:degrees: k = 1..6 sampled 7
:scope: clamped ends with one simple knot between
:argued: every order and all knots | The form is linear in $x$ and $y$: $a$ times the numerator of $x(t)$, $b$ times that of $y(t)$ and $c$ times the denominator, put together term by term.
:over: l#: lines
:where: $w(t)\ne0$
:control: the constant $c$ left out at the last vertex
:::
*/
CLAIM(line_form_of_a_nurbs_curve)
{
    enum { SIZE = 9 };
    int k = T->degree, n = k + 1, p = k - 1, place[MOST_KNOTS];
    char pattern[MOST_KNOTS];
    num u[MOST_KNOTS], R[2 * SIZE], w[SIZE], h[SIZE], line[3], x = parameter(T, "p"), P[2];
    snprintf(pattern, sizeof pattern, "%d1%d", k, k);
    (void)G(knots_of_pattern)(T, pattern, u, place);
    for (int c = 0; c < 3; c++)
        line[c] = unknown(T, "l", c);
    for (int i = 0; i < n; i++) {
        w[i] = positive(T, "w", i);
        R[2 * i] = unknown(T, "a", i);
        R[2 * i + 1] = unknown(T, "b", i);
        h[i] = add(mul(line[0], R[2 * i]), mul(line[1], R[2 * i + 1]));
        h[i] = mul(w[i], fault(T, add(h[i], line[2]), i == n - 1 ? h[i] : add(h[i], line[2])));
    }
    for (int interval = 0; interval < 2; interval++) {
        G(nurbs_point)(G(nurbs_on_span)(p, 2, u, p + interval, R, w), x, P);
        num form = add(add(mul(line[0], P[0]), mul(line[1], P[1])), line[2]);
        num above = G(spline_value)(n, p, 1, u, place, h, 0, interval, x);
        /* a x(t) + b y(t) + c = Σ N_i,k(t) w_i (a x_i + b y_i + c) / Σ N_i,k(t) w_i */
        same(T, form, div(above, G(spline_value)(n, p, 1, u, place, w, 0, interval, x)));
    }
}

#if RATIONAL
/*
:::{claim} self_crossing_polygon_meets_the_line_less_than_its_spline
:title: A curve with two points on a line, of which its polygon has one
:zh: 自交于直线的多边形与其曲线
:kind: counterexample
:given: a NURBS curve of order $k$ with the $n$ points $r_i$, weights $w_i$ and knots $t_i$; the line $y=0$; two parameters $t$
:data: k = 3; n = 4; t_i = 0 0 0 1 2 2 2; r_i = (-1,1) (1,-1) (-1,-1) (1,1); w_i = 3 1 1 3; t = 1/2 3/2
:then: the points $r(t)$ of the two parameters differ and are all points of the curve on the line $y=0$; the polygon
  has one point there
:result: r(t) = (-1/6,0) (1/6,0); points of the curve on the line = 2; points of the polygon on the line = 1
:method: The points by the kernel; the number of intersections by counting roots.
:control: crossings counted: two and two
:::
*/
CLAIM(self_crossing_polygon_meets_the_line_less_than_its_spline)
{
    struct graph g = given_graph(T);
    num t[2], P[4];
    given_points(T, "t", 2, 1, t);
    for (int m = 0; m < 2; m++) {
        int mu = place_of(g.n + g.k, g.t, t[m]) - 1;
        G(nurbs_point)(G(nurbs_on_span)(g.k - 1, 2, g.t + 1, mu, g.r + 2, g.w + 1), t[m], P + 2 * m);
    }
    struct spline_meets_axis curve = curve_of(&g);
    struct cagd_polygon_meets_line polygon = polygon_of_graph(&g);
    found_points(T, "r(t)", 2, 2, P);
    int all = curve.common == 2 && is_zero_q(P[1]) && is_zero_q(P[3]);
    int of_curve = fault(T, curve.crossings, 1 + !equal_q(P[0], P[2]));
    int of_polygon = fault(T, polygon.crossings, polygon.components);
    found_whole(T, "points of the curve on the line", of_curve);
    found_whole(T, "points of the polygon on the line", of_polygon);
    about(T, "these two being all, the curve has no more points on the line than the polygon");
    refute(T, all && of_curve > of_polygon);
}

/*
The printed proof is by contradiction: the points on the line are made vertices, and then the polygon has too many.
It works with points of the curve on the line; a curve with a $k$-fold knot inside can change sides without such a
point.

:::{statement} wang-ch4:thm-4.2.2-step-suppose
:title: If the theorem were false there were too many parameters
:zh: 反证法的假设
:printed: otherwise there is a line $\boldsymbol L_0$ with $N\equiv I(\Gamma_k^{(T)}(\Phi),\boldsymbol L_0)<I(\boldsymbol r_k(t),\boldsymbol L_0)$,
  so there are at least $N+1$ intersections of the curve with $\boldsymbol L_0$; let $t_i'$, $i=1,2,\dots,N+1$, be the parameters of
  these points
:holds-by: polygon_through_the_crossings_crosses_as_often
:confirmed-by: designed_splines_meet_no_more
:meant: lemma 4.2.2, which calls $I(\Gamma,\boldsymbol L)$ the number of intersections (交点) | Points that the curve and the line have in
  common.
:reading: polygon_through_the_crossings_crosses_as_often | intersections are points in common
:reading: jump_crosses_the_line_without_a_point | intersections are crossings: at a knot of multiplicity $k$ the curve may change sides by
  a jump, for which there is no parameter
:argued: every curve | Of whole numbers, more than $N$ is $N+1$ at least; and a point that the curve has in common with the line is a
  point of the curve, which has a parameter.
:figure: points_of_the_line_as_vertices

Where a piece of curve is on the line one of its parameters is taken.
:::

:::{claim} polygon_through_the_crossings_crosses_as_often
:title: With the crossings as vertices the polygon crosses as often as the curve
:zh: 交点嵌入后多边形的跨越次数
:kind: decision
:given: curves with all crossings rational, by their numerators $\sum N_{i,k}w_iy_i$: two cubics on $[0,1]$ with given roots, and a quadratic
  spline with the numbers $w_iy_i$ and its crossings, of which one is a knot; the weights 1, and $w$ and 1 in turn
:data: roots of the first cubic = 1/4 1/2 3/4; roots of the second cubic = 1/4 1/2 1/2; t_i of the cubics = 0 0 0 0 1
  1 1 1; t_i of the spline = 0 0 0 1 2 2 2; w_i y_i = -3 1 -1 3; crossings of the spline = 3/5 1 7/5; w = 1000
:let: $\mu_i$ the number of the knot before root $i$, that is $t_{\mu_i}$ less than the root and $t_{\mu_i+1}$ not
:then: after each root is inserted $k-1$ times, vertex $\mu_i+(i-1)(k-1)$ is on the line, and the polygon crosses it and
  meets it exactly as often as the curve
:method: The printed insertions; the curve by counting roots, polygons by `exact/decide/crossings.h`.
:scope: the stated curves
:control: the first root inserted once only
:::
*/
/* The roots of one curve, in order, inserted k-1 times each; the first only once in the control. */
static void check_roots(trial *T, const struct graph *g, int roots, const num_q root[])
{
    struct graph out = *g;
    int index[4];
    for (int j = 0; j < roots; j++) {
        index[j] = place_of(g->n + g->k, g->t, root[j]) + j * (g->k - 1);
        for (int times = 1; times < fault(T, g->k, j == 0 ? 2 : g->k); times++)
            out = with_knot(&out, root[j]);
    }
    struct spline_meets_axis curve = curve_of(g);
    struct cagd_polygon_meets_line polygon = polygon_of_graph(&out);
    for (int j = 0; j < roots; j++)
        agree(T, is_zero_q(out.r[2 * index[j] + 1]));
    agree(T, curve.common == roots);
    agree(T, polygon.crossings == curve.crossings);
    agree(T, polygon.common_runs == curve.common);
}

/* The curve of order k with four points (i, b_i / w_i): its height is sum N_i b_i over the sum of the weights. */
static struct graph graph_of_numerators(int k, const num knots[], const num b[], const num w[])
{
    struct graph g = {.n = 4, .k = k};
    for (int i = 1; i <= g.n + k; i++)
        g.t[i] = knots[i - 1];
    for (int i = 1; i <= g.n; i++) {
        g.w[i] = w[i - 1];
        g.r[2 * i] = from_int(i);
        g.r[2 * i + 1] = div(b[i - 1], w[i - 1]);
    }
    return g;
}

CLAIM(polygon_through_the_crossings_crosses_as_often)
{
    num cubic_roots[2][3], spline_roots[3], wave[4], knots[8], two[7];
    given_points(T, "roots of the first cubic", 3, 1, cubic_roots[0]);
    given_points(T, "roots of the second cubic", 3, 1, cubic_roots[1]);
    given_points(T, "t_i of the cubics", 8, 1, knots);
    given_points(T, "t_i of the spline", 7, 1, two);
    given_points(T, "w_i y_i", 4, 1, wave);
    given_points(T, "crossings of the spline", 3, 1, spline_roots);
    num heavy = given(T, "w");
    for (int family = 0; family < 2; family++) {
        num w[4];
        for (int i = 0; i < 4; i++)
            w[i] = family == 1 && i % 2 == 0 ? heavy : from_int(1);
        for (int which = 0; which < 2; which++) {
            poly product = poly_constant(from_int(1));
            num b[4];
            for (int j = 0; j < 3; j++)
                product = poly_mul(product, poly_sub(poly_variable(), poly_constant(cubic_roots[which][j])));
            poly_to_bernstein(product, 3, from_int(0), from_int(1), b);
            struct graph cubic = graph_of_numerators(4, knots, b, w);
            check_roots(T, &cubic, equal_q(cubic_roots[which][1], cubic_roots[which][2]) ? 2 : 3, cubic_roots[which]);
        }
        struct graph spline = graph_of_numerators(3, two, wave, w);
        check_roots(T, &spline, 3, spline_roots);
    }
}

/*
:::{claim} jump_crosses_the_line_without_a_point
:title: At a knot of multiplicity k a curve may change sides without meeting the line
:zh: k 重节点处曲线跳过直线
:kind: counterexample
:given: a broken line, of order $k$, with the $n$ points $r_i$, weights $w_i$ and knots $t_i$, the middle one of
  multiplicity $k$; the line $y=0$
:data: k = 2; n = 4; t_i = 0 0 1 1 2 2; r_i = (0,-1) (1,-1) (1,1) (0,1); w_i = 1 1 1 1
:instead: t_i = 0 0 1 3/2 2 2
:then: the curve changes sides once and has no point on the line; the polygon crosses once
:result: crossings of the curve = 1; points of the curve on the line = 0; crossings of the polygon = 1
:method: By intervals, as for the designed curves.
:control: two simple knots in the place of the double one
:::
*/
CLAIM(jump_crosses_the_line_without_a_point)
{
    struct graph g = given_graph(T);
    struct spline_meets_axis curve = curve_of(&g);
    found_whole(T, "crossings of the curve", curve.crossings);
    found_whole(T, "points of the curve on the line", curve.common);
    found_whole(T, "crossings of the polygon", polygon_of_graph(&g).crossings);
    about(T, "every crossing has a parameter whose point is on the line");
    agree(T, curve.crossings <= curve.common);
}

/*
With edges on the line left out, the proof fails even where the lemma does not.  The curve of the next claim crosses the line where it
has an inflection; made a vertex, the point is between two edges on the line.

:::{claim} crossing_becomes_a_vertex_between_edges
:title: A crossing of the curve becomes a vertex between edges on the line
:zh: 交点成为直线上两边之间的顶点
:kind: counterexample
:given: a quadratic spline as a NURBS curve of order $k$ with the $n$ points $r_i$, weights $w_i$ and knots $t_i$; the line $y=0$; the
  parameter $t'$ where the curve crosses it is inserted $k-1$ times
:data: k = 3; n = 4; t_i = 0 0 0 1 2 2 2; r_i = (0,1) (1,0) (2,0) (3,-1); w_i = 1 1 1 1; t' = 1
:then: the curve has one point on the line, a vertex of the new polygon; outside its edges on the line the polygon has no common point with
  it, before and after
:result: new points = (0,1) (1,0) (3/2,0) (3/2,0) (2,0) (3,-1); points of the curve on the line = 1; intersections of the polygon, edges
  on the line left out = 0; intersections of the new polygon = 0
:method: Runs of common points, less the one that has edges; the curve by counting roots.
:control: this run counted as one intersection
:::
*/
CLAIM(crossing_becomes_a_vertex_between_edges)
{
    struct graph g = given_graph(T), cut = g;
    num t = given(T, "t'");
    for (int times = 1; times < g.k; times++)
        cut = with_knot(&cut, t);
    struct cagd_polygon_meets_line before = polygon_of_graph(&g), after = polygon_of_graph(&cut);
    int curve = curve_of(&g).common; /* the edges on the line follow one another: they are one run of common points */
    int old = before.common_runs - fault(T, 0, before.contained_edges > 0);
    int new = after.common_runs - fault(T, 0, after.contained_edges > 0);
    found_points(T, "new points", cut.n, 2, cut.r + 2);
    found_whole(T, "points of the curve on the line", curve);
    found_whole(T, "intersections of the polygon, edges on the line left out", old);
    found_whole(T, "intersections of the new polygon", new);
    about(T, "the curve having more than the polygon, the new polygon has no less than the curve");
    refute(T, curve > old && new < curve);
}
#endif

/*
:::{statement} wang-ch4:thm-4.2.2-step-vertices
:title: Points of intersection become vertices
:zh: 交点成为顶点
:printed: with $T'=\{t_1'\}^{k-1}\oplus\{t_2'\}^{k-1}\oplus\cdots\oplus\{t_{N+1}'\}^{k-1}$ by (4.1.9) every point of intersection $\boldsymbol r_k(t_i')$ is a vertex of $\Gamma_k^{(T)}(T')$, $i=1,2,\dots,N+1$
:holds-by: inserted_parameters_become_vertices
:hypothesis: knot_at_a_k_fold_end_has_no_shares | every knot of $T'$ is in $(t_1,t_{n+k})$, or at $t_1$ where $t_1=t_k$: for (4.1.6)
:hypothesis: end_of_more_than_k_knots_has_no_shares | $t_n<t_{n+k}$: for (4.1.6)
:reading: right_value_with_the_other_interval | $t'_i$ is a knot of multiplicity $k$, or $t_1=t_k$: then $r(t'_i)$ is a vertex, too, though not the one with the index of (4.1.9)
:needs: negative_weight_loses_a_vertex_beside_the_common_point | definition 4.1.1: $w_i>0$ | the weights are positive: otherwise another vertex may not exist
:figure: points_of_the_line_as_vertices

In (4.1.9) the index is $\mu$; of several parameters the $i$-th, in increasing order, has the index $\mu_i+(i-1)(k-1)$.  At a $k$-fold right end the point of the curve is $r_n$, and nothing need be inserted.
:::

:::{statement} wang-ch4:thm-4.2.2-step-meet
:title: The polygon meets the line at these vertices
:zh: 这些顶点是多边形与直线的交点
:printed: these points are obviously also points of intersection of $\boldsymbol L_0$ and $\Gamma_k^{(T)}(T')$, so
  $I(\Gamma_k^{(T)}(T'),\boldsymbol L_0)\ge N+1$
:holds-by: inserted_parameters_become_vertices
:confirmed-by: polygon_through_the_crossings_crosses_as_often
:hypothesis: crossing_becomes_a_vertex_between_edges | an edge on the line counts: the vertices may be ends of such edges
:hypothesis: knot_at_a_k_fold_end_has_no_shares | every knot of $T'$ is in $(t_1,t_{n+k})$, or at $t_1$ where $t_1=t_k$: for (4.1.6)
:hypothesis: end_of_more_than_k_knots_has_no_shares | $t_n<t_{n+k}$: for (4.1.6)
:needs: negative_weight_loses_a_vertex_beside_the_common_point | definition 4.1.1: $w_i>0$ | the weights are positive: otherwise another vertex may not exist
:argued: | The points are common points of the line and of the polygon, being vertices.  Two of them that belong to different intersections are not joined by edges on the
  line: the curve between is a mean of the vertices from one to the other, and would be on the line with them.
:figure: points_of_the_line_as_vertices
:::

:::{statement} wang-ch4:thm-4.2.2-step-contradiction
:title: The contradiction to the lemma
:zh: 与引理矛盾
:printed: but by lemma 4.2.2 $I(\Gamma_k^{(T)}(T'),\boldsymbol L_0)\le N$, a contradiction
:holds-by: averages_between_neighbours_keep_sign_changes cut_corners_meet_a_line_no_more
  insertion_ratios_are_between_zero_and_one inserted_points_divide_the_edges printed_factors_are_the_discrete_shares
  clamped_start_inserted_again_repeats_the_first_point steps_of_refinement_compose weights_of_both_steps_are_positive knots_above_k_fold_repeat_new_points
:argued: every order and every number of points and knots | As for lemma 4.2.2: one knot after the other, by (4.1.7), and each insertion puts a point on each
  of some edges and takes the old vertices away, and those without a share where a knot is more than $k$-fold.
:hypothesis: self_crossing_polygon_gains_points_on_a_line | intersections are counted along the polygon; for points of the plane
  the lemma fails
:needs: insertion_with_mixed_weights_crosses_more | definition 4.1.1: $w_i>0$ | the weights are positive
:hypothesis: edge_on_the_line_must_be_counted | an edge on the line counts
:hypothesis: cut_corner_lies_on_the_line | a piece of the polygon on the line counts as one intersection: however many edges it has
:hypothesis: knot_at_a_k_fold_end_has_no_shares | every knot of $T'$ is in $(t_1,t_{n+k})$, or at $t_1$ where $t_1=t_k$: for (4.1.6)
:hypothesis: end_of_more_than_k_knots_has_no_shares | $t_n<t_{n+k}$: for (4.1.6)
:figure: what_must_be_counted
:::

:::{statement} wang-ch4:thm-4.2.2-corollaries
:title: The earlier properties are special cases
:zh: 性质 1.3.10、3.2.7 与定理 2.11.2
:printed: properties 1.3.10, 3.2.7 and theorem 2.11.2 are obviously direct corollaries of the theorem above
:holds-by: bezier_curves_are_nurbs_curves equal_weights_give_bspline averages_between_neighbours_keep_sign_changes cut_corners_meet_a_line_no_more
  insertion_ratios_are_between_zero_and_one inserted_points_divide_the_edges
  inserted_parameters_become_vertices line_form_of_a_nurbs_curve
:needs: mixed_weights_cross_more | definition 4.1.1: $w_i>0$ | the weights are positive
:hypothesis: self_crossing_polygon_meets_the_line_less_than_its_spline | intersections are counted in the theorem as
  in the corollary; property 3.2.7 counts crossings, and does not follow from a count of points
:argued: | They are the theorem for curves that are NURBS curves; that they say nothing else is read from the chapters on Bézier curves
  and B-splines, of which one is at hand.
:meant: the words by which they are corollaries, as of the three property 3.2.7 alone is at hand | The other two say the same of Bézier curves and of
  B-spline curves.
:figure: what_must_be_counted

A rational Bézier curve is the case $n=k$ with two knots of multiplicity $k$; equal weights give B-spline and Bézier
curves.
:::

:::{claim} bezier_curves_are_nurbs_curves
:title: With two knots of multiplicity k, a NURBS curve is a rational Bézier curve
:zh: 有理 Bézier 曲线是 NURBS 曲线的特例
:given: order $k=n$, knots $x_0$ and $x_1$ of multiplicity $k$; any weights and points
:then: the curve is the rational Bézier curve of degree $k-1$ of the same points and weights in $(t-x_0)/(x_1-x_0)$;
  with equal weights it is $\sum N_{i,k}r_i$
:method: The Bézier curve by the kernel, the sums by the definition of B-splines; everything a variable.
:degrees: k = 1..6 sampled 7
:over: r#: points; f: common weight
:where: $w(t)\ne0$
:control: the first two weights exchanged; for $k=1$ the point moved
:::
*/
CLAIM(bezier_curves_are_nurbs_curves)
{
    enum { SIZE = 8 };
    int k = T->degree, place[MOST_KNOTS];
    char pattern[MOST_KNOTS];
    num u[MOST_KNOTS], r[SIZE], w[SIZE], h[SIZE], x = parameter(T, "p"), P;
    snprintf(pattern, sizeof pattern, "%d%d", k, k);
    (void)G(knots_of_pattern)(T, pattern, u, place);
    for (int i = 0; i < k; i++) {
        r[i] = unknown(T, "r", i);
        w[i] = positive(T, "w", i);
        h[i] = mul(w[i], r[i]);
    }
    about(T, "equal weights");
    num ones[SIZE], weighted[SIZE], factor = positive(T, "f", 0);
    for (int i = 0; i < k; i++) {
        ones[i] = factor;
        weighted[i] = mul(factor, r[i]);
    }
    num t = div(sub(x, u[0]), sub(u[k], u[0])), sum = G(spline_value)(k, k - 1, 1, u, place, weighted, 0, 0, x);
    same(T, div(sum, G(spline_value)(k, k - 1, 1, u, place, ones, 0, 0, x)),
         G(spline_value)(k, k - 1, 1, u, place, r, 0, 0, x));
    about(T, "the rational Bézier curve");
    sum = div(G(spline_value)(k, k - 1, 1, u, place, h, 0, 0, x), G(spline_value)(k, k - 1, 1, u, place, w, 0, 0, x));
    if (T->faulty) {
        num first = w[0];
        w[0] = k > 1 ? w[1] : first;
        w[k > 1] = k > 1 ? first : add(first, first);
        r[0] = k > 1 ? r[0] : add(r[0], first); /* one point has no weights to exchange: it is moved */
    }
    G(rational_point)(k - 1, 1, r, w, t, &P);
    same(T, sum, P);
}

#include "chapters/judge/claims_off.h"
