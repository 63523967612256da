/*
# Knot removal (消去节点)

Removal is insertion read backwards, and it asks for more than there is: of the $p+1-s$ equations that insertion of a knot of
multiplicity $s-1$ satisfies, one too many.  So a knot is removable (可消去) exactly if one number vanishes, the *defect*.  It is
the jump of the first derivative that the knot allows to jump, in another scale.
*/
#include "chapters/nurbs/definition.h"
#include "chapters/nurbs/patterns.h"

#include "chapters/judge/claims_on.h"

enum { dim = FIELD ? 1 : 2 }; /* every formula is taken coordinate by coordinate: the field takes one */

/* Compare, for several segments over knots of that kind: knots and points before an insertion with those after insertion and
 * removal, and the defect with 0. */
static void G(check_removal_inverts_insertion)(trial *T, int kind)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = kind};
    num b[MOST_KNOTS * dim], c[MOST_KNOTS * dim], back[MOST_KNOTS * dim], defect[dim], u[MOST_KNOTS], v[MOST_KNOTS];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, dim, b);
        for (int place = K.place[p]; place < K.place[K.n]; place++) {
            int s = G(multiplicity_at)(&K, place) + 1, mu = G(span_of_interval)(K.count, K.place, place);
            if (s > p + 1)
                continue;
            num x = G(knot_for)(T, &K, place, "s");
            G(bspline_insert)(over(&K, dim, b), mu, x, u, c);
            c[(mu - s + 1) * dim] = fault(T, c[(mu - s + 1) * dim], add(c[(mu - s + 1) * dim], from_int(1)));
            G(bspline_remove)(spline(p, K.n + 1, dim, u, c), mu + 1, s, v, back, defect);
            about(T, "the knots");
            for (int i = 0; i < K.count; i++)
                same(T, v[i], K.u[i]);
            about(T, "the points");
            for (int i = 0; i < K.n * dim; i++)
                same(T, back[i], b[i]);
            about(T, "the defect");
            for (int e = 0; e < dim; e++)
                vanishes(T, defect[e]);
        }
    }
}

/*
Where a knot had been inserted, removal has to give back what was there. The equations $c_i=(1-a_i)b_{i-1}+a_ib_i$ of the
insertion are solved from both ends, each point from its neighbour, until the two runs meet in the middle; what the equation lacks
that is left over there is the defect.

:::{claim} removal_inverts_insertion
:title: Removal of a knot that was inserted gives the points before
:zh: 消去插入的节点即还原
:given: several segments, the distinct knots variables, points $b_i$; a knot $x$ inserted in every interval of the domain and at every
  knot of it of multiplicity at most $p$, which gives it every multiplicity $s=1,\dots,p+1$
:then: `bspline_remove` gives back the knots and the $b_i$, and the defect $0$
:method: Insertion by `bspline_insert`, which keeps the curve by `boehm_insertion_keeps_curve`, then removal; everything a
  variable.
:degrees: 0..4 sampled 8
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3
:over: s: new knot
:defines: bspline_remove
:control: one of the points that removal solves for is moved before
:::
*/
CLAIM(removal_inverts_insertion) { G(check_removal_inverts_insertion)(T, 0); }

#if FIELD
/*
:::{claim} removal_in_higher_degrees
:title: Removal in higher degrees
:zh: 高次时的消去节点
:given: several segments over the knots $0,1,3,6,10,\dots$ with simple and with clamped ends; points $b_i$, variables; a knot $x$ inserted in every interval of the domain and at every
  knot of it of multiplicity at most $p$
:then: `bspline_remove` gives back the knots and the $b_i$, and the defect $0$
:method: Insertion by `bspline_insert`, then removal.
:types: field
:degrees: 6..6
:scope: an inner knot of every multiplicity up to k between simple and clamped ends;
  the distinct knots $0,1,3,6,10,\dots$
:over: s: new knot
:control: one of the points that removal solves for is moved before
:::
*/
CLAIM(removal_in_higher_degrees) { G(check_removal_inverts_insertion)(T, INTEGERS); }
#endif

#if FIELD || RATIONAL
/*
For a knot that cannot be removed the kernel still returns points. They are not nonsense: inserted again, they reproduce every old
point but one, and this one is missed by the defect. A program that removes knots within a tolerance (近似消去) may therefore read off
the defect how far that one vertex moves.

:::{claim} reinsertion_misses_by_the_defect
:title: Inserting the removed knot again gives all points but one, which is off by the defect
:zh: 消去后再插入仅差一点,其差即亏量
:given: several segments, the distinct knots variables, points $c_i$; every knot of multiplicity $s=1,\dots,p+1$ inside the domain
:then: the points of `bspline_remove` with the knot inserted again are the $c_i$, with one exception, and there $c_i$ minus the
  new point is the defect: with the defect $0$ the curve is the same
:method: `bspline_remove`, then `bspline_insert`, everything a variable; the differences of all points are computed, all but one
  must vanish, and that one is compared with the defect.
:types: field rational
:degrees: 0..6 sampled 8
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3;
  the distinct knots variables up to order 5, numbers above
:control: the defect with the other sign
:::
*/
CLAIM(reinsertion_misses_by_the_defect)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num c[MOST_KNOTS * dim], b[MOST_KNOTS * dim], d[MOST_KNOTS * dim], defect[dim], v[MOST_KNOTS], w[MOST_KNOTS];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, dim, c);
        for (int place = K.place[p] + 2; place < K.place[K.n]; place += 2) {
            int s = G(multiplicity_at)(&K, place), r = G(span_of_interval)(K.count, K.place, place), off = 0;
            G(bspline_remove)(over(&K, dim, c), r, s, v, b, defect);
            G(bspline_insert)(spline(p, K.n - 1, dim, v, b), r - 1, K.u[r], w, d);
            for (int i = 0; i < K.n; i++) {
                num gap = sub(c[i * dim], d[i * dim]);
#if FIELD
                int here = !is_zero_f(gap);
#else
                int here = !is_zero_q(gap);
#endif
                off += here;
                for (int e = 0; e < dim && here; e++)
                    same(T, sub(c[i * dim + e], d[i * dim + e]), fault(T, defect[e], neg(defect[e])));
            }
            agree(T, off == 1);
        }
    }
}

/*
At a knot of multiplicity $s$ the spline may jump in the derivative of order $p-s+1$ and after. With one knot less it may not jump
in this order. So the derivative of order $p-s+1$ must decide whether the knot can be removed, and the claim says in which way the
defect, a combination of points, knows of it.

:::{claim} knot_is_removable_iff_derivative_does_not_jump
:title: The defect vanishes exactly if the derivative of order p-s+1 does not jump
:zh: 节点可消去当且仅当 p-s+1 阶导矢连续
:given: several segments, the lengths between distinct knots positive variables, points $c_i$; every knot of multiplicity
  $s=1,\dots,p+1$ inside the domain
:where: the gaps between different knots are positive
:then: the defect is the jump of $s^{(p-s+1)}$ at the knot times a factor that depends on the knots only and is never $0$; so the knot
  is removable if and only if that derivative is continuous there
:method: The jump from the polynomials of both intervals in powers of $t$ minus the knot, by the recursion of de Boor and Cox by its
  letter.  Both are linear in the points: jump and defect of all points and of one unit point are in proportion, and
  jump and defect of that unit point, numbers of the knots, have coefficients of one sign only.
:types: field rational
:degrees: 0..4 sampled 8
:scope: an inner knot of every multiplicity up to k between simple and clamped ends, all patterns of 2k+1 at most k-fold knots up to order 3
:over: x: -
:control: the jump of the next order, or for $s=1$ of the order before
:::
*/
/* The jump of the derivative of order r at the knot of this place, from left to right, over r!. */
static num G(jump_at)(const struct G(knot_vector) * K, const num c[], int place, int r)
{
    num left[HIGHEST + 1], right[HIGHEST + 1], at = K->u[G(span_of_interval)(K->count, K->place, place)];
    G(spline_powers)(K->n, K->p, 1, K->u, K->place, c, 0, place - 2, at, left);
    G(spline_powers)(K->n, K->p, 1, K->u, K->place, c, 0, place, at, right);
    return sub(right[r], left[r]);
}

CLAIM(knot_is_removable_iff_derivative_does_not_jump)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = LENGTHS};
    num c[MOST_KNOTS], one[MOST_KNOTS], b[MOST_KNOTS], v[MOST_KNOTS], defect, unit;
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, 1, c);
        for (int place = K.place[p] + 2; place < K.place[K.n]; place += 2) {
            int s = G(multiplicity_at)(&K, place), r = G(span_of_interval)(K.count, K.place, place);
            int order = p - s + 1 + fault(T, 0, p == 0 ? 0 : s > 1 ? 1 : -1);
            for (int i = 0; i < K.n; i++)
                one[i] = from_int(i == r - s); /* a point that the jump sees */
            G(bspline_remove)(over(&K, 1, c), r, s, v, b, &defect);
            G(bspline_remove)(over(&K, 1, one), r, s, v, b, &unit);
            num jump = G(jump_at)(&K, c, place, order), unit_jump = G(jump_at)(&K, one, place, order);
            about(T, "defect and jump are in proportion");
            same(T, mul(defect, unit_jump), mul(jump, unit));
            about(T, "neither is 0 for the unit point");
#if FIELD
            agree(T, coefficients_sign_f(unit) * coefficients_sign_f(unit) == 1);
            agree(T, coefficients_sign_f(unit_jump) * coefficients_sign_f(unit_jump) == 1);
#else
            agree(T, !is_zero_q(unit) && !is_zero_q(unit_jump));
#endif
        }
    }
}
#endif

#include "chapters/judge/claims_off.h"
