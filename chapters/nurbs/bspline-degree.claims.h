/*
# Degree (升阶与降阶)

In degree $p+1$ the same polar form has one argument more: it is the mean of the old one over all ways to leave out an argument.
The points are again its values at consecutive knots, where every knot of the domain now has one more.  The way back begins
with one segment, in its Bézier form.
*/
#include "chapters/nurbs/bernstein-form.h"
#include "chapters/nurbs/definition.h"
#include "chapters/nurbs/patterns.h"

#include "chapters/judge/claims_on.h"

enum { dim = FIELD ? 1 : 2 }; /* every formula is taken coordinate by coordinate: the field takes one */

/* The knots of degree p+1: every knot of the domain once more. */
static void G(elevated_knots)(const struct G(knot_vector) * K, struct G(knot_vector) * L)
{
    *L = *K;
    for (int place = K->place[K->p]; place <= K->place[K->n]; place += 2)
        G(put_knot)(L, place, K->u[G(span_of_interval)(K->count, K->place, place)], L);
    L->p++;
    L->n = L->count - L->p - 1;
}

/* Compare, for several segments over knots of that kind: the spline and the elevated one, on every interval. */
static void G(check_elevation_keeps_bspline_curve)(trial *T, int kind)
{
    int p = T->degree, span[MOST_KNOTS];
    struct G(knot_vector) K = {.kind = kind}, L;
    num c[MOST_KNOTS * dim], d[MOST_KNOTS * dim];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        if (K.place[p] == K.place[p + 1] || K.place[K.n - 1] == K.place[K.n])
            continue;
        G(free_control_points)(T, K.n, dim, c);
        G(elevated_knots)(&K, &L);
        for (int last = 0; last <= 1; last++) {
            if (!G(spans_over)(&K, L.n, p + 1, L.place, last, span))
                continue;
            G(bspline_elevate)(over(&K, dim, c), L.n, L.u, span, d);
            for (int e = 0; e < dim; e++)
                d[(L.n - 1) * dim + e] = fault(T, d[(L.n - 1) * dim + e], d[(L.n - 2) * dim + e]);
            G(same_spline)(T, dim, &K, c, &L, d);
        }
    }
}

/*
The mean over all arguments left out is symmetric and affine in each of the $p+1$ arguments, and at equal arguments it is the
curve: these properties determine a polar form, so it is the one of degree $p+1$. What the formula does not say is over which
knots. At a knot of multiplicity $m$ the curve has $p-m$ continuous derivatives, which is what a knot of multiplicity $m+1$ leaves
to a spline of degree $p+1$: so every knot of the domain is taken once more.

:::{claim} elevation_keeps_bspline_curve
:title: Elevation changes points and knots, not the curve
:zh: B 样条升阶不改变曲线
:given: several segments, each point with a span in the domain, the distinct knots variables, points
:then: with every knot of the domain once more, the spline of degree $p+1$ of the points of `bspline_elevate` is the old one; it does
  not matter which admissible span a point is computed from
:method: Both splines in powers, from the recursion of de Boor and Cox by its letter, once with the first admissible span for every
  point, once with the last.
:degrees: 0..4 sampled 7
:defines: bspline_elevate
:control: the last point replaced by the one before it
:::
*/
CLAIM(elevation_keeps_bspline_curve) { G(check_elevation_keeps_bspline_curve)(T, 0); }

#if FIELD
/*
:::{claim} elevation_in_higher_degrees
:title: Elevation in higher degrees
:zh: 高次时的升阶
:given: several segments over the knots $0,1,3,6,10,\dots$ with simple and with clamped ends; points, variables
:then: with every knot of the domain once more, the spline of degree $p+1$ of the points of `bspline_elevate` is the old one; it does
  not matter which admissible span a point is computed from
:method: Both splines in powers, from the recursion of de Boor and Cox by its letter, once with the first admissible span for every
  point, once with the last.
:types: field
:degrees: 6..6
:scope: the distinct knots $0,1,3,6,10,\dots$
:control: the last point replaced by the one before it
:::
*/
CLAIM(elevation_in_higher_degrees) { G(check_elevation_keeps_bspline_curve)(T, INTEGERS); }
#endif

/*
Going down a degree (降阶) asks for a curve that is there only by accident. For one segment in Bézier form the equations of the
elevation are again one too many, and one number, the highest difference of the points, tells whether they agree.

:::{claim} bezier_reduction_inverts_elevation
:title: A Bézier curve of lower degree gives its points back, and the defect tells every other curve
:zh: Bézier 曲线的降阶与亏量
:given: points $e_0,\dots,e_n$, $n\ge1$, in every degree of the list; and points $b_0,\dots,b_{n-1}$
:then: for $e_i=\frac inb_{i-1}+(1-\frac in)b_i$ the points of `bezier_reduce` are the $b_i$, with the defect $0$; for any $e$ the
  defect is $(-1)^{n-m}\Delta^ne_0\big/\binom nm$ with $m=\lfloor n/2\rfloor$, so that it vanishes exactly if the curve is of degree $n-1$
:method: The kernel on elevated points and on variables, against the variables and the coefficient of $t^n$ by the binomial theorem.
:degrees: 1..8 sampled 14
:defines: bezier_reduce
:control: the defect with the other sign
:::
*/
CLAIM(bezier_reduction_inverts_elevation)
{
    int n = T->degree, m = n / 2;
    num b[(MAX_DEGREE + 1) * dim], e[(MAX_DEGREE + 1) * dim], back[(MAX_DEGREE + 1) * dim], defect[dim];
    G(free_control_points)(T, n, dim, b);
    for (int i = 0; i <= n; i++)
        for (int c = 0; c < dim; c++) {
            num before = i > 0 ? mul(from_ratio(i, n), b[(i - 1) * dim + c]) : from_int(0);
            e[i * dim + c] = i < n ? add(before, mul(from_ratio(n - i, n), b[i * dim + c])) : before;
        }
    G(bezier_reduce)(n, dim, e, back, defect);
    about(T, "the points before elevation");
    for (int i = 0; i < n * dim; i++)
        same(T, back[i], b[i]);
    for (int c = 0; c < dim; c++)
        vanishes(T, defect[c]);
    about(T, "the defect");
    G(free_control_points)(T, n + 1, dim, e);
    G(bezier_reduce)(n, dim, e, back, defect);
    for (int c = 0; c < dim; c++) {
        num power = div(G(bezier_coefficient)(n, dim, e, c, n), G(choose)(n, m));
        same(T, defect[c], (n - m) % 2 == fault(T, 0, 1) ? power : neg(power));
    }
}

#if FIELD || RATIONAL
/* Compare, for several segments over knots of that kind: the points c and the elevated points reduced; and that the points
 * 1, 0, ..., 0 of degree p+1, reduced and elevated, do not come back. */
static void G(check_reduction_inverts_bspline_elevation)(trial *T, int kind)
{
    int p = T->degree, span[MOST_KNOTS], down[MOST_KNOTS];
    struct G(knot_vector) K = {.kind = kind}, L;
    num c[MOST_KNOTS * dim], d[MOST_KNOTS * dim], back[MOST_KNOTS * dim];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        if (K.place[p] == K.place[p + 1] || K.place[K.n - 1] == K.place[K.n])
            continue;
        G(elevated_knots)(&K, &L);
        for (int last = 0; last <= 1; last++) {
            if (!G(spans_over)(&K, L.n, p + 1, L.place, 0, span) || !G(spans_over)(&L, K.n, p, K.place, last, down))
                continue;
            G(free_control_points)(T, K.n, dim, c);
            G(bspline_elevate)(over(&K, dim, c), L.n, L.u, span, d);
            for (int e = 0; T->faulty && e < dim; e++)
                for (int i = 0; i < L.n; i++)
                    d[i * dim + e] = add(d[i * dim + e], from_int(i * i * i * i));
            G(bspline_reduce)(over(&L, dim, d), K.n, K.u, down, back);
            about(T, "the points before elevation");
            for (int i = 0; i < K.n * dim; i++)
                same(T, back[i], c[i]);
            if (last)
                continue;
            about(T, "not every spline is of lower degree");
            int off = 0;
            for (int i = 0; i < L.n * dim; i++)
                d[i] = from_int(i < dim);
            G(bspline_reduce)(over(&L, dim, d), K.n, K.u, down, back);
            num again[MOST_KNOTS * dim];
            G(bspline_elevate)(over(&K, dim, back), L.n, L.u, span, again);
            for (int i = 0; i < L.n * dim; i++) {
#if FIELD
                off += !is_zero_f(sub(again[i], d[i]));
#else
                off += !is_zero_q(sub(again[i], d[i]));
#endif
            }
            agree(T, off > 0);
        }
    }
}

/*
For a spline the segments could each be of lower degree and still not fit together, since lowering the multiplicities asks for
smoothness as well. Instead of collecting these conditions, reduction trusts the curve, computes the points that it would have to
have, each from one segment, and elevates them: only for the right curve does this give its points again.

:::{claim} reduction_inverts_bspline_elevation
:title: A spline of lower degree gives its points back, and elevation tells every other one
:zh: B 样条降阶与检验
:given: several segments of a spline of degree $p$, which is reduced from degree $p+1$, each point with a span in the domain, the distinct knots variables, points
:then: `bspline_reduce` applied to the points of `bspline_elevate` gives the points before; applied to the points $1,0,\dots,0$ over the same knots and
  elevated again, it does not give these points
:method: Both kernels one after the other, everything a variable, with the first admissible span and with the last; what is elevated is of
  lower degree, so for any other points the test must fail, and for these it does.
:degrees: 1..4 sampled 7
:types: field rational
:defines: bspline_reduce
:control: the last point is moved before it is reduced
:::
*/
CLAIM(reduction_inverts_bspline_elevation) { G(check_reduction_inverts_bspline_elevation)(T, 0); }
#endif

#if FIELD
/*
:::{claim} reduction_in_higher_degrees
:title: Reduction in higher degrees
:zh: 高次时的降阶
:given: several segments of a spline of degree $p$, which is reduced from degree $p+1$, over the knots $0,1,3,6,10,\dots$ with simple and with clamped ends; points, variables
:then: `bspline_reduce` applied to the points of `bspline_elevate` gives the points before; applied to the points $1,0,\dots,0$ over the same knots and
  elevated again, it does not give these points
:method: Both kernels one after the other, with the first admissible span and with the last.
:types: field
:degrees: 5..5
:scope: the distinct knots $0,1,3,6,10,\dots$
:control: the last point is moved before it is reduced
:::
*/
CLAIM(reduction_in_higher_degrees) { G(check_reduction_inverts_bspline_elevation)(T, INTEGERS); }
#endif

#include "chapters/judge/claims_off.h"
