/*
# Segments (分段)

A segment of a B-spline curve is a Bézier curve; a curve cut at a parameter is two B-spline curves; a closed curve is an open
one whose points and knots repeat.
*/
#include "chapters/nurbs/bernstein-form.h"
#include "chapters/nurbs/definition.h"
#include "chapters/nurbs/patterns.h"

#include "chapters/judge/claims_on.h"

enum { dim = FIELD ? 1 : 2 }; /* every formula is taken coordinate by coordinate: the field takes one */

/* Compare, for every segment over knots of that kind: the Bézier form of the kernel and the segment, both in powers. */
static void G(check_segment_is_a_bezier_curve)(trial *T, int kind)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = kind};
    num c[MOST_KNOTS * dim], b[MOST_KNOTS * dim], s[HIGHEST + 1];
    for (int k = G(segment_knots)(T, p, 0, &K); k > 0; k = G(segment_knots)(T, p, k, &K)) {
        num h = sub(K.u[p + 1], K.u[p]);
        G(free_control_points)(T, K.n, dim, c);
        G(bspline_to_bezier)(G(on_span)(p, dim, K.u, p, c), b);
        for (int e = 0; e < dim; e++) {
            G(spline_powers)(K.n, p, dim, K.u, K.place, c, e, K.place[p], K.u[p], s);
            for (int r = 0; r <= p; r++) {
                num sum = from_int(0);
                for (int i = 0; i <= r; i++) {
                    int from = fault(T, i, p - i);
                    sum = add(sum, mul(b[from * dim + e], G(bernstein_coefficient)(p, i, r)));
                }
                same(T, sum, mul(s[r], G(power)(h, r)));
            }
        }
    }
}

/*
The Bézier points of a segment are the values of its polar form at arguments of two kinds only, $u_\mu$ and $u_{\mu+1}$; the
control points are its values at consecutive knots. Either set determines the polar form, and so each is found from the other by
de Boor's triangle or de Casteljau's, whatever the multiplicities on both sides of the segment.

:::{claim} segment_is_a_bezier_curve
:title: The Bézier points of a segment
:zh: B 样条曲线段的 Bézier 点
:given: every segment, the distinct knots variables, points
:then: with $b_0,\dots,b_p$ of `bspline_to_bezier`, $s(t)=\sum_iB_i^p\bigl(\frac{t-u_\mu}{u_{\mu+1}-u_\mu}\bigr)b_i$
:method: The Bernstein polynomials by the binomial theorem, the segment in powers of $t-u_\mu$ from the recursion of de Boor and Cox by
  its letter; the coefficients are compared.
:degrees: 0..4 sampled 9
:defines: bspline_to_bezier
:control: the points backwards
:::
*/
CLAIM(segment_is_a_bezier_curve) { G(check_segment_is_a_bezier_curve)(T, 0); }

#if FIELD
/*
:::{claim} bezier_points_in_higher_degrees
:title: The Bézier points of a segment of higher degree
:zh: 高次时的 Bézier 点
:given: a segment over the knots $0,1,3,6,10,\dots$ in each of the patterns; points, variables
:then: with $b_0,\dots,b_p$ of `bspline_to_bezier`, $s(t)=\sum_iB_i^p\bigl(\frac{t-u_\mu}{u_{\mu+1}-u_\mu}\bigr)b_i$
:method: The Bernstein polynomials by the binomial theorem, the segment in powers of $t-u_\mu$ from the recursion of de Boor and Cox by
  its letter; the coefficients are compared.
:types: field
:degrees: 5..7
:scope: the distinct knots $0,1,3,6,10,\dots$
:control: the points backwards
:::
*/
CLAIM(bezier_points_in_higher_degrees) { G(check_segment_is_a_bezier_curve)(T, INTEGERS); }
#endif

/*
The way back needs the interval of the Bézier points, too, because arguments are measured in it: from $0$ to $1$ between $u_\mu$
and $u_{\mu+1}$. Exchange its ends, and the same points describe another polar form.

:::{claim} points_come_back_from_bezier_points
:title: The way back from Bézier points
:zh: 由 Bézier 点求 B 样条控制顶点
:given: a Bézier curve of free points over any interval $[a,b]$, any arguments; and every segment, the distinct knots variables, points
:then: `bspline_point_of_bezier` is the polar form of the curve at the arguments; at $u_{i+1},\dots,u_{i+p}$ it gives the point $c_i$ of a
  segment from its Bézier points
:method: The polar form in elementary symmetric polynomials, from the powers of $t-a$ that the binomial theorem gives; then
  `bspline_to_bezier` and back, everything a variable.
:degrees: 0..6 sampled 9
:scope: the distinct knots variables up to order 5, numbers above
:over: f: start of an interval; l: length of an interval; a#: arguments
:defines: bspline_point_of_bezier
:control: the ends of the interval exchanged
:::
*/
CLAIM(points_come_back_from_bezier_points)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num c[MOST_KNOTS * dim], b[MOST_KNOTS * dim], s[HIGHEST + 1], x[HIGHEST + 1], P[dim];
    num from = unknown(T, "f", 0), length = unknown(T, "l", 0), to = add(from, length);
    G(free_control_points)(T, p + 1, dim, b);
    for (int r = 0; r < p; r++)
        x[r] = unknown(T, "a", r);
    G(bspline_point_of_bezier)(p, dim, b, fault(T, from, to), fault(T, to, from), x, P);
    about(T, "the polar form");
    for (int e = 0; e < dim; e++) {
        for (int r = 0; r <= p; r++) {
            s[r] = div(G(bezier_coefficient)(p, dim, b, e, r), G(power)(length, r));
        }
        same(T, P[e], G(polar_of_powers)(p, s, from, x));
    }
    about(T, "the points of the segment");
    for (int k = G(segment_knots)(T, p, 0, &K); k > 0; k = G(segment_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, dim, c);
        G(bspline_to_bezier)(G(on_span)(p, dim, K.u, p, c), b);
        for (int i = 0; i <= p; i++) {
            G(bspline_point_of_bezier)(p, dim, b, K.u[p], K.u[p + 1], K.u + i + 1, P);
            for (int e = 0; e < dim; e++)
                same(T, P[e], c[i * dim + e]);
        }
    }
}

/* Compare, for several segments over knots of that kind and t in every place: knots of both parts, and both parts with the
 * spline on their intervals. */
static void G(check_split_gives_both_parts_of_bspline)(trial *T, int kind)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = kind}, L, R;
    num c[MOST_KNOTS * dim], left[MOST_KNOTS * dim], right[MOST_KNOTS * dim], v[MOST_KNOTS], w[MOST_KNOTS];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        G(free_control_points)(T, K.n, dim, c);
        for (int place = K.place[p]; place < K.place[K.n]; place++) {
            int s = G(multiplicity_at)(&K, place), mu = G(span_of_interval)(K.count, K.place, place);
            num t = G(knot_for)(T, &K, place, "s");
            G(bspline_split)(over(&K, dim, c), mu, s, t, v, left, w, right);
            L = R = K;
            L.n = mu - s + 1, L.count = L.n + p + 1;
            R.n = K.n - mu + p, R.count = R.n + p + 1;
            about(T, "the knots");
            for (int i = 0; i < L.count; i++) {
                int own = i < L.n;
                L.u[i] = own ? K.u[i] : t, L.place[i] = own ? K.place[i] : place;
                same(T, v[i], L.u[i]);
            }
            for (int i = 0; i < R.count; i++) {
                int own = i > p;
                R.u[i] = own ? K.u[mu + i - p] : t, R.place[i] = own ? K.place[mu + i - p] : place;
                same(T, w[i], R.u[i]);
            }
            for (int e = 0; T->faulty && e < dim; e++) {
                if (L.n > 1)
                    left[(L.n - 1) * dim + e] = left[(L.n - 2) * dim + e];
                if (R.n > 1)
                    right[e] = right[dim + e];
            }
            about(T, "the right part");
            G(same_spline)(T, dim, &K, c, &R, right);
            about(T, "the left part");
            if (place > K.place[p])
                G(same_spline)(T, dim, &K, c, &L, left);
        }
    }
}

/*
To cut a curve (分割) at $t$ means to insert $t$ until each part has it $p+1$ times. If $t$ is a knot already, fewer copies are
missing, and at a knot of multiplicity $p+1$ the curve is torn there and nothing has to be computed: the points are dealt out.
These cases are where an implementation goes wrong, and all of them are tried.

:::{claim} split_gives_both_parts_of_bspline
:title: A curve cut at a parameter, at a knot of any multiplicity too
:zh: B 样条曲线的分割
:given: several segments, the distinct knots variables, points; $t$ in every interval of the domain, and at every knot of it, of
  multiplicity $s=0,\dots,p+1$
:then: the right part of `bspline_split`, with $n-\mu+p$ points, is the curve to the right of $t$, and the left part, with $\mu-s+1$ points,
  the curve to the left of $t$, if $t$ is not the first knot of the domain; each part has $t$ as a knot of multiplicity $p+1$, and its
  other knots from the curve
:method: The knots one by one; the splines in powers on every interval, from the recursion of de Boor and Cox by its letter.
:degrees: 0..4 sampled 7
:over: s: t
:defines: bspline_split
:control: the last point of the left part and the first of the right part replaced by their neighbours, where there are any
:::
*/
CLAIM(split_gives_both_parts_of_bspline) { G(check_split_gives_both_parts_of_bspline)(T, 0); }

#if FIELD
/*
:::{claim} split_in_higher_degrees
:title: A curve of higher degree cut at a parameter
:zh: 高次时的分割
:given: several segments over the knots $0,1,3,6,10,\dots$ with simple and with clamped ends; points, variables; $t$, a variable, in every interval of the domain, and at every knot of it, of multiplicity $s$
:then: the right part of `bspline_split`, with $n-\mu+p$ points, is the curve to the right of $t$, and the left part, with $\mu-s+1$ points,
  the curve to the left of $t$, if $t$ is not the first knot of the domain; each part has $t$ as a knot of multiplicity $p+1$, and its
  other knots from the curve
:method: The knots one by one; the splines in powers on every interval, from the recursion of de Boor and Cox by its letter.
:types: field
:degrees: 6..6
:scope: the distinct knots $0,1,3,6,10,\dots$
:over: s: t
:control: the last point of the left part and the first of the right part replaced by their neighbours, where there are any
:::
*/
CLAIM(split_in_higher_degrees) { G(check_split_gives_both_parts_of_bspline)(T, INTEGERS); }
#endif

/*
A closed curve has no ends, but the kernels want some. So its points and knots are written down once more beyond the period; the
seam is then a knot inside the extended sequence, and nothing distinguishes it. That the derivatives agree there is the proof that
no index of the continuation is off by one.

:::{claim} periodic_spline_closes
:title: A periodic spline repeats, and its seam is a knot as any other
:zh: 周期 B 样条
:given: the knots of one period, $u_0<u_m$, with every pattern of multiplicities for $m\le4$ and for $m=p$, the multiplicity of $u_0=u_m$ counted around, none
  above $p$; $m\ge p$ points
:then: with `bspline_periodic` the knots and points satisfy $v_{i+m}=v_i+(u_m-u_0)$ and $d_{i+m}=d_i$, the domain is $[u_0,u_m]$ with
  $v_{p+i}=u_i$ and $d_i=c_i$, and the derivatives at both ends of the domain agree up to the order $p$ minus the multiplicity
:method: The knots and points by their indices; the segments at both ends in powers about the ends, from the recursion of de Boor and Cox
  by its letter.
:degrees: 1..6 sampled 6
:scope: the distinct knots variables up to order 5, numbers above
:harmless: $u_0<u_m$ | a period of length 0 has no curve
:defines: bspline_periodic
:control: the last point of the result is moved
:::
*/
CLAIM(periodic_spline_closes)
{
    int p = T->degree, most = p > 4 ? p : 4;
    struct G(knot_vector) U = {0}, V;
    char pattern[MOST_KNOTS];
    num c[MOST_KNOTS * dim], d[MOST_KNOTS * dim], v[MOST_KNOTS], first[HIGHEST + 1], last[HIGHEST + 1];
    for (int m = p > 1 ? p : 2; m <= most; m++)
        for (int bits = 1; bits < 1 << m; bits++) {
            G(pattern_of_bits)(m + 1, bits, pattern);
            (void)G(knots_good)(T, p, pattern, &U);
            int top = U.place[m], seam = -1, high = 0;
            for (int i = 0; i <= m; i++) {
                int many = G(multiplicity_at)(&U, U.place[i]);
                high = many > high ? many : high;
                seam += U.place[i] == 0 || U.place[i] == top;
            }
            if (high > p || seam > p)
                continue;
            G(free_control_points)(T, m, dim, c);
            G(bspline_periodic)(m, p, dim, U.u, c, v, d);
            about(T, "one period of the knots and of the points");
            for (int i = 0; i <= m; i++)
                same(T, v[p + i], U.u[i]);
            for (int i = 0; i < m * dim; i++)
                same(T, d[i], c[i]);
            about(T, "the knots and the points repeat");
            num period = sub(U.u[m], U.u[0]);
            for (int i = 0; i + m <= m + 2 * p; i++)
                same(T, sub(v[i + m], v[i]), period);
            for (int i = 0; i < p * dim; i++)
                same(T, d[m * dim + i], d[i]);
            d[(m + p) * dim - 1] = fault(T, d[(m + p) * dim - 1], add(d[(m + p) * dim - 1], from_int(1)));
            V.p = p, V.n = m + p, V.count = m + 2 * p + 1;
            for (int i = 0; i < V.count; i++) {
                int around = i < p ? -1 : i > p + m ? 1 : 0;
                V.place[i] = U.place[i - p - around * m] + (around + 1) * top;
                V.u[i] = v[i];
            }
            about(T, "the derivatives at the seam");
            int end = G(span_of_interval)(V.count, V.place, 2 * top - 1);
            for (int e = 0; e < dim; e++) {
                G(spline_powers)(V.n, p, dim, V.u, V.place, d, e, top, v[p], first);
                G(spline_powers)(V.n, p, dim, V.u, V.place, d, e, V.place[end], v[p + m], last);
                for (int r = 0; r <= p - seam; r++)
                    same(T, last[r], first[r]);
            }
        }
}
#include "chapters/judge/claims_off.h"
