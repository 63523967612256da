/*
# Discrete B-splines (离散 B 样条)

Over a refinement $v$ of the knots $u$ the old B-splines are combinations of the new ones,
$N_{i,p}=\sum_j\alpha_i(j)\,M_{j,p}$; then the new points are $d_j=\sum_i\alpha_i(j)\,c_i$.  The numbers $\alpha_i(j)$ are the
discrete B-splines.  The recursion of de Boor and Cox computes them too, with the knots $v_{j+1},\dots,v_{j+p}$ one after the
other in the place of $t$.
*/
#include "chapters/nurbs/definition.h"
#include "chapters/nurbs/patterns.h"
#include "exact/record/total_positivity.h"

#include "chapters/judge/claims_on.h"

/* K and new knots: one at the fraction `at` of the first interval of the domain, two in the last, one more at each inner knot
 * of multiplicity at most p. */
static void G(finer_knots)(trial *T, const struct G(knot_vector) * K, struct G(knot_vector) * L)
{
    int p = K->p, lowest = K->place[p], highest = K->place[K->n];
    *L = *K;
    for (int place = lowest; place < highest; place++) {
        int inside = place % 2 == 1, last = place == highest - 1, mu = G(span_of_interval)(K->count, K->place, place);
        int times = inside ? (place == lowest + 1) + 2 * last : place > lowest && G(multiplicity_at)(K, place) <= p;
        num x = K->u[mu];
        if (times > 0 && inside && K->kind == LENGTHS) {
            /* between positive lengths: a weighted mean of the two knots */
            num a = positive(T, "a", place), b = positive(T, "b", place);
            x = div(add(mul(b, K->u[mu]), mul(a, K->u[mu + 1])), add(a, b));
        } else if (times > 0 && inside) {
            x = G(in_interval)(T, K, mu, place == lowest + 1 ? "s" : "r");
        }
        for (int more = 0; more < times && G(multiplicity_at)(L, place) <= p; more++)
            G(put_knot)(L, place, x, L);
    }
}

/* a[j n + i] = alpha_i(j) for the points j of L whose knot v_j is in the domain of K, and 0 for the others;
 * with_v_j: v_j stands for the last of the knots that follow it. */
static void G(all_discrete)(const struct G(knot_vector) * K, const struct G(knot_vector) * L, int with_v_j, num a[])
{
    int p = K->p;
    num x[HIGHEST + 1], part[HIGHEST + 1];
    for (int j = 0; j < L->n; j++) {
        for (int i = 0; i < K->n; i++)
            a[j * K->n + i] = from_int(0);
        for (int r = 0; r < p; r++)
            x[r] = L->u[j + (with_v_j && r == p - 1 ? 0 : r + 1)];
        int mu = G(span_of_interval)(K->count, K->place, L->place[j]);
        mu = mu < p ? p : mu;
        G(bspline_discrete)(p, K->u, mu, x, part);
        for (int m = 0; m <= p; m++)
            a[j * K->n + mu - p + m] = part[m];
    }
}

/* Whether the domain begins and ends with a span, which every refinement of these patterns then does as well. */
static int G(ends_are_spans)(const struct G(knot_vector) * K)
{
    return K->place[K->p] < K->place[K->p + 1] && K->place[K->n - 1] < K->place[K->n];
}

/*
:::{claim} discrete_bsplines_satisfy_refinement_equation
:title: The discrete B-splines write the old B-splines in the new ones
:zh: 离散 B 样条的加细方程
:given: several segments, the distinct knots variables; new knots in the first and the last interval, the last one double, and one
  more at each inner knot of multiplicity at most $p$
:then: with $\alpha_{\mu-p}(j),\dots,\alpha_\mu(j)$ of `bspline_discrete`, $u_\mu\le v_j<u_{\mu+1}$, and $\alpha_i(j)=0$ for the
  other $i$: $N_{i,p}=\sum_j\alpha_i(j)\,M_{j,p}$ for every $i$, and $\sum_i\alpha_i(j)=1$ for every $j$
:method: Both sides in powers, on every interval of $v$ in the domain, the B-splines over $u$ and over $v$ from the recursion of
  de Boor and Cox by its letter.  As the $M_{j,p}$ are independent there are no other such numbers.
:degrees: 0..4 sampled 8
:over: s r: new knot
:defines: bspline_discrete
:control: the last of the knots $v_{j+1},\dots,v_{j+p}$ replaced by $v_j$
:::
*/
CLAIM(discrete_bsplines_satisfy_refinement_equation)
{
    int p = T->degree;
    struct G(knot_vector) K = {0}, L;
    num a[MOST_KNOTS * MOST_KNOTS], N[MOST_KNOTS * (HIGHEST + 1)], M[MOST_KNOTS * (HIGHEST + 1)];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        if (!G(ends_are_spans)(&K))
            continue;
        G(finer_knots)(T, &K, &L);
        G(all_discrete)(&K, &L, fault(T, 0, p > 0), a);
        about(T, "the sum of alpha_i(j)");
        for (int j = 0; j < L.n; j++) {
            num sum = from_int(0);
            for (int i = 0; i < K.n; i++)
                sum = add(sum, a[j * K.n + i]);
            same(T, sum, from_int(1));
        }
        about(T, "the refinement equation");
        for (int mu = p; mu < L.n; mu++) {
            int interval = L.place[mu];
            if (interval == L.place[mu + 1])
                continue;
            G(basis_powers)(p, K.count, K.u, K.place, interval, L.u[mu], N);
            G(basis_powers)(p, L.count, L.u, L.place, interval, L.u[mu], M);
            for (int i = 0; i < K.n; i++)
                for (int r = 0; r <= p; r++) {
                    num sum = from_int(0);
                    for (int j = 0; j < L.n; j++)
                        sum = add(sum, mul(a[j * K.n + i], M[j * (p + 1) + r]));
                    same(T, sum, N[i * (p + 1) + r]);
                }
        }
    }
}

#if FIELD || RATIONAL
/*
A row of these numbers says how much each old point contributes to one new point. They sum to 1; if none is negative, the new
polygon consists of means of old points and lies in their hull. The recursion does not show it as easily as for the B-splines
themselves: the knots $v_{j+1},\dots,v_{j+p}$ that are put in do not all lie in the interval of $v_j$, so that a factor
$v_{j+r}-u_i$ may be large and its partner negative. The signs are those of the result, as a fraction.

:::{claim} discrete_bsplines_are_nonnegative
:title: No discrete B-spline is negative
:zh: 离散 B 样条的非负性
:given: several segments, the lengths between distinct knots positive variables; new knots in the first and the
  last interval, strictly between its ends, the last one double, and one more at each inner knot of multiplicity at most $p$
:then: for every $j\ge p$ $\alpha_i(j)\ge0$, and $\alpha_i(j)=0$ unless $u_i\le v_j$ and $v_{j+p+1}\le u_{i+p+1}$; so such a point $d_j$ is a convex
  combination of $c_{\mu-p},\dots,c_\mu$
:method: The values of the kernel are fractions of polynomials with positive coefficients only, or the zero element.
:types: field rational
:degrees: 0..5 sampled 8
:over: x: -; a# b#: ratios in which the new knots divide their intervals
:control: the knot $v_j$ in the place of $v_{j+p}$, for $p>0$
:::
*/
CLAIM(discrete_bsplines_are_nonnegative)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = LENGTHS}, L;
    num a[MOST_KNOTS * MOST_KNOTS];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        if (!G(ends_are_spans)(&K))
            continue;
        G(finer_knots)(T, &K, &L);
        G(all_discrete)(&K, &L, fault(T, 0, p > 0), a);
        for (int j = p; j < L.n; j++)
            for (int i = 0; i < K.n; i++) {
                if (K.place[i] <= L.place[j] && L.place[j + p + 1] <= K.place[i + p + 1])
                    nonnegative(T, a[j * K.n + i]);
                else
                    vanishes(T, a[j * K.n + i]);
            }
    }
}
#endif

/*
## Collocation (配置) and the theorem of Schoenberg and Whitney

Insertion of one knot is a matrix with the numbers $a_i\ge0$ and $1-a_i\ge0$ on two neighbouring diagonals: no minor of it is
negative.  If every site $x$ is inserted up to the multiplicity $p$, the values $N_{0,p}(x),\dots,N_{n-1,p}(x)$ are a row of the
product of these matrices, and so, by the formula of Cauchy and Binet, no minor of the collocation matrix is negative.

For the theorem of Schoenberg and Whitney every order of knots and sites is a case of its own, and a determinant of order $n$ of
rational functions of all the gaps: with $n=5$ both the cases and the determinants are too many for a proof in passing, so that
the field stops at four functions; that no minor is negative is decided by the next claim for one site in every interval, and sampled by the
one after it for several.
*/

#if FIELD || RATIONAL
/*
:::{claim} bspline_collocation_is_product_of_insertions
:title: The values of all B-splines at a site are a row of a product of insertion matrices
:zh: 配置矩阵是插入节点矩阵之积的子矩阵
:given: several segments with a span at both ends of the domain, the lengths between distinct knots positive variables; a site
  inside every interval of the domain, at positive distances from its ends, all of them inserted $p$ times
:then: every insertion matrix has entries $\ge0$ on two neighbouring diagonals and $0$ elsewhere; the row of the product that belongs
  to a site is $N_{0,p}(x),\dots,N_{n-1,p}(x)$
:method: The matrices are `bspline_insert` applied to unit points; the row against the recursion of de Boor and Cox by its letter.
  A minor of a matrix with two neighbouring nonnegative diagonals is a product of entries or $0$.
:types: field rational
:degrees: 1..4 sampled 6
:over: x: -; a# b#: ratios in which the sites divide their intervals
:control: the row after
:::
*/
CLAIM(bspline_collocation_is_product_of_insertions)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = LENGTHS}, L;
    num A[MOST_KNOTS * MOST_KNOTS], B[MOST_KNOTS * MOST_KNOTS], c[MOST_KNOTS], d[MOST_KNOTS], v[MOST_KNOTS];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        if (!G(ends_are_spans)(&K))
            continue;
        L = K;
        for (int i = 0; i < K.n * K.n; i++)
            A[i] = from_int(i / K.n == i % K.n); /* row j, column i: point j over L of unit point i over K */
        for (int place = K.place[p] + 1; place < K.place[K.n]; place += 2) {
            int mu = G(span_of_interval)(K.count, K.place, place);
            num a = positive(T, "a", place), b = positive(T, "b", place);
            num x = div(add(mul(b, K.u[mu]), mul(a, K.u[mu + 1])), add(a, b));
            for (int more = 0; more < p; more++) {
                int nu = G(span_of_interval)(L.count, L.place, place);
                for (int i = 0; i < (L.n + 1) * K.n; i++)
                    B[i] = from_int(0);
                for (int one = 0; one < L.n; one++) {
                    for (int i = 0; i < L.n; i++)
                        c[i] = from_int(i == one);
                    G(bspline_insert)(over(&L, 1, c), nu, x, v, d);
                    for (int j = 0; j <= L.n; j++) {
                        if (j == one || j == one + 1)
                            nonnegative(T, d[j]);
                        else
                            vanishes(T, d[j]);
                        for (int i = 0; i < K.n && (j == one || j == one + 1); i++)
                            B[j * K.n + i] = add(B[j * K.n + i], mul(d[j], A[one * K.n + i]));
                    }
                }
                G(put_knot)(&L, place, x, &L);
                for (int i = 0; i < L.n * K.n; i++)
                    A[i] = B[i];
            }
            int row = fault(T, G(span_of_interval)(L.count, L.place, place) - p,
                            G(span_of_interval)(L.count, L.place, place) - p + 1); /* v_{row+1} = ... = v_{row+p} = x */
            for (int i = 0; i < K.n && row < L.n; i++)
                same(T, A[row * K.n + i], G(cox_de_boor)(p, K.u, K.place, i, place, x));
        }
    }
}
#endif

#if RATIONAL
/*
The elimination below knows nothing of knots. It finds for a matrix of numbers whether all of its minors are nonnegative (全正), in
a number of steps that grows with the cube of the order, where the minors themselves could not be counted.

:::{claim} bspline_collocation_is_totally_nonnegative
:title: The collocation matrix at increasing sites has no negative minor
:zh: B 样条配置矩阵的全正性
:given: random knots with the patterns of several segments, $p+1$ random increasing sites inside every interval of the domain
:where: the knots and the sites increase
:then: the matrix $\bigl(N_{j,p}(x_i)\bigr)$ is totally nonnegative
:method: The elimination of `total_positivity.h`, which knows nothing of B-splines, on the values of the recursion of de Boor and
  Cox by its letter.  The reason is that of `bspline_collocation_is_product_of_insertions`, where one site in every interval is decided for all knots.
:types: rational
:degrees: 1..6
:control: the first two sites exchanged
:::
*/
CLAIM(bspline_collocation_is_totally_nonnegative)
{
    int p = T->degree;
    struct G(knot_vector) K = {0};
    num M[2 * MOST_KNOTS * MOST_KNOTS];
    for (int k = G(several_knots)(T, p, 0, &K); k > 0; k = G(several_knots)(T, p, k, &K)) {
        int rows = 0;
        for (int place = K.place[p]; place < K.place[K.n]; place += 2) {
            int mu = G(span_of_interval)(K.count, K.place, place);
            num x = K.u[mu];
            for (int many = p + 1; many > 0; many--, rows++) {
                x = add(x, mul(inside(T, "x"), sub(K.u[mu + 1], x)));
                for (int j = 0; j < K.n; j++)
                    M[rows * K.n + j] = G(cox_de_boor)(p, K.u, K.place, j, place, x);
            }
        }
        if (T->faulty)
            for (int j = 0; j < K.n; j++) {
                num first = M[j];
                M[j] = M[K.n + j], M[K.n + j] = first;
            }
        agree(T, is_totally_nonnegative(rows, K.n, M));
    }
}
#endif

#if FIELD
/*
No minor is negative; when is the largest positive? Interpolation (插值) of $n$ values at $n$ sites has a solution for all values
just then. It cannot have one if some B-spline vanishes at its own site: then too many sites lie where too few functions live. The
theorem says that nothing else can go wrong.

:::{claim} schoenberg_whitney
:title: Interpolation has one solution exactly when every B-spline is positive at its site
:zh: Schoenberg–Whitney 定理
:given: $n=2,3$ B-splines of degree 1 and $n=3$ of degree 2 over knots of every good pattern with a span at both ends of the
  domain, and $n=4$ of the degrees 1, 2 and 3 over clamped knots; $n$ sites $x_0<\dots<x_{n-1}$ of the domain in every position to the knots, on knots too; the lengths
  between neighbours in the order of all knots and sites positive variables
:then: $\det\bigl(N_{j,p}(x_i)\bigr)>0$ if $N_{i,p}(x_i)>0$ for all $i$, and otherwise the determinant is $0$
:method: The determinant, without division, of the values of the recursion of de Boor and Cox by its letter, once for every order
  of knots and sites.  It is a fraction of polynomials with positive coefficients only, or the zero element: this decides it
  for all knots and sites in that order.  At a knot a value is the one from the right, at the end of the domain that from the
  left.
:types: field
:degrees: 1..3
:scope: at most three B-splines of degree 1 or 2, and four of degree 1 to 3 over clamped knots; every pattern of multiplicities and every position
  of the sites
:over: x: -; h#: gaps between neighbours
:control: the first and the second site exchanged
:::
*/
/* The determinant for sites in places of K; a site on an interval comes with others there, in order. */
static void G(decide_collocation)(trial *T, const struct G(knot_vector) * pattern, const int site[])
{
    struct G(knot_vector) K = *pattern;
    int n = K.n, p = K.p, top = K.place[K.count - 1], h = 0, regular = 1;
    num at[MOST_KNOTS], M[MAX_ORDER * MAX_ORDER], x = from_int(0);
    for (int place = 0; place <= top; place++) {
        if (place % 2 == 0) {
            x = place == 0 ? x : add(x, positive(T, "h", h++));
            for (int i = 0; i < K.count; i++)
                if (K.place[i] == place)
                    K.u[i] = x;
        }
        for (int i = 0; i < n; i++)
            if (site[i] == place)
                at[i] = place % 2 == 0 ? x : (x = add(x, positive(T, "h", h++)));
    }
    for (int i = 0; i < n; i++) {
        int place = site[i] == K.place[n] ? site[i] - 1 : site[i];
        num value = from_int(0);
        for (int j = 0; j < n; j++) {
            M[i * n + j] = G(cox_de_boor)(p, K.u, K.place, j, place, at[i]);
            value = i == j ? M[i * n + j] : value;
        }
        regular = regular && !is_zero_f(value);
    }
    for (int j = 0; T->faulty && j < n; j++) {
        num first = M[j];
        M[j] = M[n + j], M[n + j] = first;
    }
    if (regular)
        G(must_be_positive)(T, G(determinant)(n, M));
    else
        vanishes(T, G(determinant)(n, M));
}

CLAIM(schoenberg_whitney)
{
    int p = T->degree;
    struct G(knot_vector) K = {.kind = LENGTHS};
    char pattern[MOST_KNOTS];
    for (int n = p + 1; n <= 4; n++)
        for (int bits = 0; bits < 1 << (n + p); bits++) {
            G(pattern_of_bits)(n + p + 1, bits, pattern);
            if (!G(knots_good)(T, p, pattern, &K) || !G(ends_are_spans)(&K))
                continue;
            if (n > 3 && (K.place[0] < K.place[p] || K.place[n] < K.place[n + p]))
                continue;
            int low = K.place[p], high = K.place[n], site[MOST_KNOTS];
            for (int i = 0; i < n; i++)
                site[i] = low + (low % 2 == 0 && i > 0); /* the first site on the first knot, the others right of it */
            for (;;) {
                G(decide_collocation)(T, &K, site);
                int i = n - 1; /* the next positions: one that can move up does, those after it follow */
                while (i >= 0 && site[i] >= high - (n - 1 - i > 0))
                    i--;
                if (i < 0)
                    break;
                site[i]++;
                for (int l = i + 1; l < n; l++)
                    site[l] = site[l - 1] + (site[l - 1] % 2 == 0);
                if (site[n - 1] > high)
                    break;
            }
        }
}
#endif

#include "chapters/judge/claims_off.h"
