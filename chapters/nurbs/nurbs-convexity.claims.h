/*
# What convex means (凸的定义)

The source inserts knots until the polygon is the curve.  An insertion puts one new vertex on each edge and takes the old
ones away: it cuts corners.  A convex polygon with its corners cut is convex, and so is a limit of convex polygons.

All depends on the word.  By the letter of the definition a *set* of points is convex when it is part of the boundary of a
convex set, and it does not matter how often the polygon runs there.  With that meaning lemma and theorem are false: a polygon that
goes along one side of a triangle, back, and along another is part of the boundary as a set, but the corners are cut where it turns back,
and the polygon with its corners cut leaves the boundary, as the curve does.  They are true for polygons that run through the
boundary *once*; then the polygon, closed by its chord, is convex.  This section decides what the word has to mean; the next two cut
the corners and pass to the curve.
*/
#include "chapters/nurbs/convexity.h"

#include "chapters/judge/claims_on.h"

/*
:::{statement} wang-ch4:def-4.2.1
:title: When a plane curve is convex
:zh: 凸曲线的定义
:definition: yes
:printed: a continuous plane curve $\Gamma$ is called convex if it is the boundary of a convex set of the plane, or part of it
:checked-by: convex_polygons_lie_on_the_border_of_their_hull
:meant: the words of the definition, which speak of a set | That the set of points of $\Gamma$ is the boundary or a part of it, as in the first reading.
:reading: polygon_that_turns_back_loses_convexity | that convexity is kept by insertion, lemma 4.2.1, when the set of points of $\Gamma$ has to be part of the boundary
:reading: polygon_that_overlaps_itself_loses_convexity | that convexity is kept by insertion, lemma 4.2.1, when the set of points has to be part of the boundary and besides $\Gamma$ must never turn back
:reading: turns_of_one_sign_are_not_enough | that the curve of a convex polygon is convex, theorem 4.2.1, when $\Gamma$ has to turn always to the same side, which the
  definition does not say
:reading: triangles_of_one_sign_make_a_polygon_convex | when $\Gamma$ has to run through the boundary or part of it once, coming to no
  point twice except the end to the start: for a polygon that is not on one line this can be told from the areas of triangles, by which lemma 4.2.1 is decided
:figure: what_convex_must_mean

As a definition it states nothing; what the readings say is whether lemma and theorem are true or false with them.
:::
*/

#if RATIONAL
/* All polygons of n points of a grid of `width` times `height` points, or of as many as there are. */
static int grid_width(int n) { return n <= 5 ? 3 : 2; }
static int grid_height(int n) { return n <= 4 ? 3 : 2; }
static int grid_polygons(int n)
{
    int codes = 1;
    for (int i = 0; i < n; i++)
        codes *= grid_width(n) * grid_height(n);
    return codes;
}
static void grid_polygon(int n, int code, long point[])
{
    int width = grid_width(n), places = width * grid_height(n);
    for (int i = 0; i < n; i++, code /= places) {
        point[2 * i] = code % places % width;
        point[2 * i + 1] = code % places / width;
    }
}

/*
To decide convexity one needs a criterion that sees order as well as place. The areas of all triangles $r_ir_jr_l$ with $i<j<l$
are such a criterion: they have one sign just when the polygon, closed by its chord, runs round a convex region once. Neighbouring
triples are not enough: a polygon may turn left at every vertex and come round twice.

:::{claim} triangles_of_one_sign_make_a_polygon_convex
:title: A polygon closed by its chord is convex exactly when its triangles have one sign
:zh: 凸多边形等价于各三角形同向
:kind: decision
:let: $D_{ijl}$ twice the signed area of the triangle of the points $i$, $j$, $l$
:given: all polygons of $n$ points: of the grid $\{0,1,2\}^2$ for $n=3,4$, of $\{0,1,2\}\times\{0,1\}$ for $n=5$, of $\{0,1\}^2$
  for $n=6$
:then: the polygon is convex when closed by its chord if and only if all $D_{ijl}$, $i<j<l$, are $\ge0$ or all $\le0$, and not all are $0$
:method: Convexity by `exact/decide/hull.h`, from the turns of the edges; the areas are computed.  The converse for all polygons: three points in order of the boundary turn left or are on one line.
:degrees: points = 3..6
:scope: the stated polygons
:argued: every polygon | If the $D_{ijl}$ are $\ge0$ and one is positive, no point is on the right of an edge or of the chord, so that all edges
  are on the boundary of the hull, in its direction; a second round would give three points in clockwise order.
:control: only the areas of three neighbouring points are asked for, which leaves out some for $n>3$
:::
*/
static long triangle_area(const long P[], const long Q[], const long R[])
{
    return (Q[0] - P[0]) * (R[1] - P[1]) - (Q[1] - P[1]) * (R[0] - P[0]);
}

CLAIM(triangles_of_one_sign_make_a_polygon_convex)
{
    int n = T->degree;
    for (int code = 0; code < grid_polygons(n); code++) {
        long point[2 * 6];
        num R[2 * 6];
        int signs = 0;
        region_mark mark = region_open();
        grid_polygon(n, code, point);
        points_of(n, point, R);
        for (int l = 2; l < n; l++)
            for (int j = 1; j < l; j++)
                for (int i = 0; i < j; i++) {
                    long area = triangle_area(point + 2 * i, point + 2 * j, point + 2 * l);
                    if (fault(T, 1, l == j + 1 && j == i + 1))
                        signs |= area > 0 ? 1 : area < 0 ? 2 : 0;
                }
        int orientation, wanted = signs == 1 ? 1 : signs == 2 ? -1 : 0;
        (void)polygon_is_convex(n - 1, R, 1, &orientation);
        agree(T, orientation == wanted);
        region_drop(mark);
    }
}

/* No two points are on different sides of the line of an edge; R: points 0, ..., n-1. */
static int every_edge_on_the_border(int n, const num_q R[])
{
    int good = 1;
    for (int i = 0; i + 1 < n; i++) {
        int sides = 0;
        for (int j = 0; j < n; j++) {
            int side = turn_2d(R + 2 * i, R + 2 * i + 2, R + 2 * j);
            sides |= side > 0 ? 1 : side < 0 ? 2 : 0;
        }
        good &= sides != 3;
    }
    return good;
}

/*
:::{claim} convex_polygons_lie_on_the_border_of_their_hull
:title: A convex polygon is part of the boundary of its hull
:zh: 凸多边形位于其凸包边界上
:kind: decision
:let: $D_{ijl}$ twice the signed area of the triangle of the points $i$, $j$, $l$
:given: all polygons of $n$ points: of the grid $\{0,1,2\}^2$ for $n=3,4$, of $\{0,1,2\}\times\{0,1\}$ for $n=5$, of $\{0,1\}^2$
  for $n=6$
:then: if a polygon runs through once and is convex, then each of its edges has all vertices on one side: it is part of the boundary
  of the hull
:method: An edge is part of the boundary of the hull exactly when no two vertices are on different sides of its line.  Convexity by
  `exact/decide/hull.h`.
:degrees: points = 3..6
:scope: the stated polygons
:argued: every polygon | All $D_{ijl}$ having one sign, so have the areas $D_{i,i+1,l}$ of an edge and a later vertex and $D_{l,i,i+1}$ of an edge and an earlier
  one: every vertex is on one side of the edge.
:control: the converse: every polygon on the boundary of its hull runs through once
:::
*/
CLAIM(convex_polygons_lie_on_the_border_of_their_hull)
{
    int n = T->degree;
    for (int code = 0; code < grid_polygons(n); code++) {
        long point[2 * 6];
        num R[2 * 6];
        region_mark mark = region_open();
        grid_polygon(n, code, point);
        points_of(n, point, R);
        int convex = polygon_is_convex(n - 1, R, 0, NULL), border = every_edge_on_the_border(n, R);
        agree(T, fault(T, !convex || border, !border || convex));
        region_drop(mark);
    }
}

/* Refutes for the given curve of order three with n points: part of the boundary of a convex set before the insertion of the given tau
 * is part of the boundary of one after it. */
static void lose_convexity(trial *T, int n)
{
    enum { MOST = 5 };
    num_q t[MOST + 5], r[2 * MOST + 4], w[MOST + 2], v[MOST + 5], S[2 * MOST + 4], z[MOST + 2];
    given_curve(T, n, 3, t, r, w);
    num_q tau = given_q(T, "τ");
    printed_insertion_q(n, 3, 2, t, place_of(n + 3, t, tau), tau, r, w, v, S, z);
    found_points_q(T, "r'", n + 1, 2, S + 2);
    about(T, "if every edge of the polygon is on the boundary of its hull, so is every edge of the new one");
    refute(T, every_edge_on_the_border(n, r + 2) && !every_edge_on_the_border(n + 1, S + 2));
}

/*
Here is a small polygon that is convex as a set and is not run through once. It goes out and back on the same side of a triangle.
The insertion cuts the corner where it turns, and what was hidden by running over the same points twice comes to light. The second
example shows that it does not help to forbid turning back.

:::{claim} polygon_that_turns_back_loses_convexity
:title: A polygon on the boundary of a triangle that turns back, and its corners cut
:zh: 往返的多边形割角后非凸
:kind: counterexample
:given: a quadratic curve of the points $r$ and weights $w$ over the knots $T$; one knot inserted, $T'=\{\tau\}$
:data: T = 0 0 0 1 2 2 2; r = (0,0) (1,0) (0,0) (0,1); w = 1 1 1 1; τ = 3/2
:instead: r = (0,0) (1,0) (1,1) (0,1)
:then: the points of the polygon are two sides of a triangle, so part of the boundary of a convex set; the new polygon $r'$ has an edge inside
  its hull
:result: r' = (0,0) (1,0) (1/4,0) (0,1/2) (0,1)
:method: By the printed formulas; an edge is on the boundary of the hull when no two vertices are on different sides of it.
:control: the points of a square
:::
*/
CLAIM(polygon_that_turns_back_loses_convexity) { lose_convexity(T, 4); }

/*
:::{claim} polygon_that_overlaps_itself_loses_convexity
:title: A polygon that runs round a triangle and over its first side again
:zh: 首尾重叠的多边形割角后非凸
:kind: counterexample
:given: a quadratic curve of the points $r$ and weights $w$ over the knots $T$; the points go round a triangle, always turning
  left, and then over its first side again; one knot inserted, $T'=\{\tau\}$
:data: T = 0 0 0 1 2 3 3 3; r = (0,0) (2,0) (0,2) (0,0) (2,0); w = 1 1 1 1 1; τ = 1/2
:instead: r = (0,0) (2,0) (0,2) (0,1) (0,0)
:then: the points of the polygon are the sides of the triangle; the new polygon $r'$ has an edge inside its hull
:result: r' = (0,0) (1,0) (3/2,1/2) (0,2) (0,0) (2,0)
:method: By the printed formulas; an edge is on the boundary of the hull when no two vertices are on different sides of it.
:control: the last two points on the third side: the polygon is closed and runs round once
:::
*/
CLAIM(polygon_that_overlaps_itself_loses_convexity) { lose_convexity(T, 5); }

/*
The proof of the theorem speaks about a set $A(\Gamma)$. It exists only where $\Gamma$ lies on the boundary of its own hull (凸包),
and is then this hull. So "smallest" hides a hypothesis, the same that is to be proved of the curve.

:::{statement} wang-ch4:def-4.2.1-smallest
:title: The smallest closed convex set with the curve on its boundary
:zh: 以 Γ 为边界的最小凸闭集
:definition: yes
:printed: if $\Gamma$ is convex, $A(\Gamma)$ is the smallest closed convex set that has $\Gamma$ as its boundary or as part of its boundary
:checked-by: convex_polygons_lie_on_the_border_of_their_hull
:meant: the sentence itself, which begins with a curve that is part of the boundary of a convex set | $\Gamma$ is convex.
:reading: curve_inside_its_hull_has_no_smallest_set | for a $\Gamma$ that need not be convex: there may be no such set
:reading: convex_polygons_lie_on_the_border_of_their_hull | for a convex $\Gamma$: there is one, the convex hull of $\Gamma$
:argued: every compact curve, and that no set is smaller | Let $\Gamma$ be compact and part of the boundary of a convex set $C$.  Every closed convex set that
  contains $\Gamma$ contains its hull; the hull is closed; and a point of $\Gamma$ inside the hull would be inside $C$.  So the hull is such a set, and every other one is larger.
:figure: where_hypotheses_are_needed
:::

:::{claim} curve_inside_its_hull_has_no_smallest_set
:title: A polygon that is not convex has no convex set with it on the boundary
:zh: 非凸时 A(Γ) 不存在
:kind: counterexample
:given: a polygon of four points $r$
:data: r = (0,0) (3,0) (1,1) (0,3)
:instead: r = (0,0) (3,0) (2,2) (0,3)
:then: $r_3$ is strictly inside the triangle of the others, so inside every convex set that contains the polygon
:result: areas on the inside, twice = 3 3 3
:method: Three turns: the areas of the triangles of $r_3$ and the sides.
:control: $r_3$ on the other side of the line of its neighbours
:::
*/
CLAIM(curve_inside_its_hull_has_no_smallest_set)
{
    num P[8], area[3];
    given_points(T, "r", 4, 2, P);
    const num *corner[3] = {P, P + 2, P + 6}, *third = P + 4;
    int inside_all = 1;
    for (int i = 0; i < 3; i++) {
        const num *from = corner[i], *to = corner[(i + 1) % 3];
        num along[2] = {sub(to[0], from[0]), sub(to[1], from[1])};
        num there[2] = {sub(third[0], from[0]), sub(third[1], from[1])};
        area[i] = G(cross2)(along, there);
        inside_all &= turn_2d(from, to, third) > 0;
    }
    found_points(T, "areas on the inside, twice", 3, 1, area);
    about(T, "the third point is not inside the triangle of the others");
    refute(T, inside_all);
}
#endif

#include "chapters/judge/claims_off.h"
