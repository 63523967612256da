/*
# Spans and multiplicities (节点区间与重数)

A kernel never compares two numbers; which span contains a parameter, how often a knot occurs, and whether the knots are good is
decided before, exactly.  These decisions depend on the order of the numbers alone, so that all of them can be tried: knots are
small integers, parameters integers and the numbers halfway between.
*/
#include "chapters/nurbs/definition.h"
#include "chapters/nurbs/patterns.h"

#if RATIONAL
#include "exact/record/span.h" /* it closes G */
#define G(name) name##_q
#endif

#include "chapters/judge/claims_on.h"

#if RATIONAL
/* The knots of a pattern as integers 0, 1, 2, ...; returns how many. */
static int G(integer_knots)(const char *pattern, num u[], int value[])
{
    int count = 0;
    for (int i = 0; pattern[i] != '\0'; i++)
        for (int times = pattern[i] - '0'; times > 0; times--, count++)
            u[count] = from_int(i), value[count] = i;
    return count;
}

/*
A parameter that is a knot lies in two closed intervals. The recursion of de Boor and Cox begins with half-open ones,
$[u_\mu,u_{\mu+1})$, so that a value at a knot is the one from the right; the last interval of the domain alone is taken closed,
since by the letter the curve would have no end. Where a value from the left is wanted, all of this is mirrored: intervals are
closed on the right, and the first of the domain is closed on both sides.

:::{claim} spans_contain_their_parameters
:title: The span of a parameter, from the right and from the left
:zh: 参数所在的节点区间
:kind: decision
:given: every knot vector of at most 8 knots, of every degree $p=0,1,2,3$ that it is good for; every parameter on a knot, between two
  neighbouring ones, and outside the domain
:then: `find_span` is the one $\mu$ with $u_\mu\le t<u_{\mu+1}$ in the domain, at its end the last span, and $-1$ outside; `find_span_left` is the
  one with $u_\mu<t\le u_{\mu+1}$, at the beginning the first span, and $-1$ outside; `multiplicity` counts equal knots
:method: All patterns of multiplicities, all parameters; the answers against a search through all indices by the definition.  Only the
  order of the numbers is used, so no other knots can behave in another way.
:degrees: 0..3
:defines: multiplicity find_span find_span_left
:control: the last knot taken for the span of its own parameter when the domain ends there
:::
*/
CLAIM(spans_contain_their_parameters)
{
    int p = T->degree, value[MOST_KNOTS], where;
    num u[MOST_KNOTS];
    char pattern[MOST_KNOTS];
    for (int count = 2 * p + 2; count <= 8; count++)
        for (int bits = 0; bits < 1 << (count - 1); bits++) {
            G(pattern_of_bits)(count, bits, pattern);
            int n = G(integer_knots)(pattern, u, value) - p - 1;
            if (G(check_knots)(n, p, u, &where) != CAGD_OK)
                continue;
            for (int twice = -1; twice <= 2 * value[count - 1] + 1; twice++) { /* t = twice/2 */
                num t = from_ratio(twice, 2);
                int right = -1, left = -1, equal = 0;
                for (int mu = p; mu < n; mu++) {
                    if (2 * value[mu] <= twice && twice < 2 * value[mu + 1])
                        right = mu;
                    if (2 * value[mu] < twice && twice <= 2 * value[mu + 1])
                        left = mu;
                }
                for (int mu = p; mu < n; mu++)
                    if (value[mu] < value[mu + 1] && value[mu + 1] == value[n] && twice == 2 * value[n])
                        right = fault(T, mu, n);
                for (int mu = n - 1; mu >= p; mu--)
                    if (value[mu] < value[mu + 1] && value[mu] == value[p] && twice == 2 * value[p])
                        left = mu;
                for (int i = 0; i < count; i++)
                    equal += 2 * value[i] == twice;
                about(T, "the span on the right");
                agree(T, G(find_span)(n, p, u, t) == right);
                about(T, "the span on the left");
                agree(T, G(find_span_left)(n, p, u, t) == left);
                about(T, "the multiplicity");
                agree(T, G(multiplicity)(count, u, t) == equal);
            }
        }
}

/*
What is not a knot vector (节点向量) has to be refused before anything is computed, and the answer names the place. A knot may occur
$p+1$ times: the curve is then torn there, but every B-spline still has an interval. With $p+2$ equal knots one B-spline has none
and is $0$ everywhere. The order of the questions matters, because a sequence can be wrong in several ways at once.

:::{claim} knots_are_checked
:title: What can be wrong with knots is found, and where
:zh: 节点序列的检查
:kind: decision
:given: every sequence of at most 6 integers from $0$ to $3$ as knots, increasing or not, of every degree $p=0,1,2$
:harmless: increasing or not | every sequence is tried
:then: `check_knots` says in this order: too few points for the degree; the first knot below the one before it, or the first knot that is
  the $(p+2)$-nd of its value; an empty domain; good
:method: All sequences; the answer against counts by the definition.
:degrees: 0..2
:defines: check_knots
:control: a knot may occur $p+2$ times
:::
*/
CLAIM(knots_are_checked)
{
    int p = T->degree, value[6];
    num u[6];
    for (int count = p + 1; count <= 6; count++)
        for (int all = 0; all < 1 << 2 * count; all++) {
            int n = count - p - 1, where = -1, at = 0;
            for (int i = 0; i < count; i++) {
                value[i] = all >> 2 * i & 3;
                u[i] = from_int(value[i]);
            }
            cagd_status expected = n <= p ? CAGD_COUNT : CAGD_OK;
            for (int i = 1; i < count && expected == CAGD_OK; i++) {
                int equal = 0;
                for (int l = 0; l <= i; l++)
                    equal += value[l] == value[i];
                expected = value[i] < value[i - 1]          ? CAGD_KNOTS_DECREASE
                           : equal > fault(T, p + 1, p + 2) ? CAGD_KNOTS_MULTIPLE
                                                            : CAGD_OK;
                at = expected != CAGD_OK ? i : p;
            }
            if (expected == CAGD_OK && value[p] == value[n])
                expected = CAGD_KNOTS_EMPTY;
            agree(T, G(check_knots)(n, p, u, &where) == expected);
            if (expected != CAGD_OK)
                agree(T, where == at);
        }
}

/*
Refinement, elevation and reduction compute each new point by itself, as a value of the polar form of one segment. Any segment
will do whose interval contains an interval on which the new point counts. A new point that counts nowhere in the domain has no
such segment: this is no mistake in the knots, and the answer is then $-1$.

:::{claim} points_have_spans
:title: The spans that refinement, elevation and reduction ask for
:zh: 各控制顶点可用的区间
:kind: decision
:given: every good knot vector $u$ of degree $p=1,2$ with $2p+2$ or $2p+3$ knots, and as $v$ of degree $q=p-1,p,p+1$ the same
  knots, those with one more in every interval of the domain, and those with every knot of the domain once more
:then: `span_of_point` gives for a point $j$ of $v$ a span of $u$ that contains an interval $[v_l,v_{l+1}]\subset[u_p,u_n]$ with
  $j\le l\le j+q$, and $-1$ exactly if there is none; `spans_of_points` gives all of them, and whether every point has one
:method: All patterns; what is found is compared with the definition, and what is not found is searched for.
:degrees: 1..2
:defines: span_of_point spans_of_points
:control: the span after the one that was found
:::
*/
CLAIM(points_have_spans)
{
    int p = T->degree, value[MOST_KNOTS], finer[MOST_KNOTS], span[MOST_KNOTS], where;
    num u[MOST_KNOTS], v[MOST_KNOTS];
    char pattern[MOST_KNOTS];
    for (int count = 2 * p + 2; count <= 2 * p + 3; count++)
        for (int bits = 0; bits < 1 << (count - 1); bits++)
            for (int way = 0; way < 9; way++) {
                int more = way % 3, q = p - 1 + way / 3, total = 0;
                G(pattern_of_bits)(count, bits, pattern);
                int n = G(integer_knots)(pattern, u, value) - p - 1;
                if (G(check_knots)(n, p, u, &where) != CAGD_OK)
                    continue;
                for (int i = 0; i < count; i++) { /* finer[] is twice v */
                    int last = i + 1 == count || value[i] < value[i + 1];
                    int inside = value[p] <= value[i] && value[i] <= value[n];
                    finer[total++] = 2 * value[i];
                    if (more == 2 && inside && last)
                        finer[total++] = 2 * value[i];
                    if (more == 1 && inside && last && value[i] < value[n])
                        finer[total++] = 2 * value[i] + 1;
                }
                int m = total - q - 1, all = 1;
                for (int i = 0; i < total; i++)
                    v[i] = from_ratio(finer[i], 2);
                if (m <= q || finer[q] != 2 * value[p] || finer[m] != 2 * value[n])
                    continue;
                int every = G(spans_of_points)(n, p, u, m, q, v, span);
                for (int j = 0; j < m; j++) {
                    int some = 0, good = 0, found = G(span_of_point)(n, p, u, m, q, v, j),
                        mu = fault(T, found, found + 1);
                    for (int l = j; l <= j + q; l++)
                        if (2 * value[p] <= finer[l] && finer[l] < finer[l + 1] && finer[l + 1] <= 2 * value[n]) {
                            some = 1;
                            good = good || (p <= mu && mu < n && 2 * value[mu] <= finer[l] &&
                                            finer[l + 1] <= 2 * value[mu + 1]);
                        }
                    all = all && some;
                    about(T, "the span of a point");
                    agree(T, some ? good : found == -1);
                    agree(T, span[j] == found);
                }
                about(T, "every point has one");
                agree(T, every == all);
            }
}

/*
At a knot of multiplicity $m$ (重数) a spline of degree $p$ has $p-m$ continuous derivatives. To keep this number when the degree
goes up, $m$ has to go up with it, and down when it goes down. At the ends of the domain there is nothing to keep smooth; there
the two functions differ: what is raised keeps as many knots before the domain as the new degree needs, what is lowered is
clamped.

:::{claim} knots_of_the_next_degrees
:title: The knots of one degree more and of one degree less
:zh: 升阶与降阶的节点序列
:kind: decision
:given: every knot vector of at most 8 knots, of every degree $p=1,2,3$ that it is good for
:then: `raised_knots` is that part of the sequence with every distinct knot once more that has $p+2$ knots up to the last $u_p$ and $p+2$
  from the first $u_n$ on; `lowered_knots` has both ends of the domain $p$ times and every knot between them once less; both
  tell how many points there are, also when there is no room for the knots
:method: All patterns; the sequences against lists made by counting how often each value occurs.
:degrees: 1..3
:defines: raised_knots lowered_knots
:control: the multiplicity of every knot kept
:::
*/
CLAIM(knots_of_the_next_degrees)
{
    int p = T->degree, value[MOST_KNOTS], expected[2 * MOST_KNOTS], where;
    num u[MOST_KNOTS], v[2 * MOST_KNOTS];
    char pattern[MOST_KNOTS];
    for (int count = 2 * p + 2; count <= 8; count++)
        for (int bits = 0; bits < 1 << (count - 1); bits++) {
            G(pattern_of_bits)(count, bits, pattern);
            int n = G(integer_knots)(pattern, u, value) - p - 1, top = value[count - 1], total = 0, first = 0, last = 0;
            if (G(check_knots)(n, p, u, &where) != CAGD_OK)
                continue;
            for (int x = 0; x <= top; x++) { /* every value once more */
                int times = fault(T, pattern[x] - '0' + 1, pattern[x] - '0');
                first = x == value[n] ? total : first;
                while (times-- > 0)
                    expected[total++] = x;
                last = x == value[p] ? total - 1 : last;
            }
            int from = last - (p + 1), m = G(raised_knots)(n, p, u, v);
            about(T, "one degree more");
            agree(T, m == first - from);
            agree(T, G(raised_knots)(n, p, u, NULL) == m);
            agree(T, from >= 0); /* there are enough knots before the domain */
            for (int i = 0; i < m + p + 2 && m == first - from && from >= 0; i++)
                same(T, v[i], from_int(expected[from + i]));
            total = 0;
            for (int x = value[p]; x <= value[n]; x++) {
                int end = x == value[p] || x == value[n],
                    times = end ? p : fault(T, pattern[x] - '0' - 1, pattern[x] - '0');
                while (times-- > 0)
                    expected[total++] = x;
            }
            m = G(lowered_knots)(n, p, u, v);
            about(T, "one degree less");
            agree(T, m == total - p);
            agree(T, G(lowered_knots)(n, p, u, NULL) == m);
            for (int i = 0; i < m + p && m == total - p; i++)
                same(T, v[i], from_int(expected[i]));
        }
}
#endif

#include "chapters/judge/claims_off.h"
