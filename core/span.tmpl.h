/* span.tmpl.h -- where a parameter lies among knots: the decisions that the kernels leave to their callers.
 *
 * Included once for binary64 (core/span.h) and once for rationals (exact/span.h); G(before)(a, b) says a < b.
 * Shapes as in bspline.tmpl.h: n points of degree p, knots u_0, ..., u_{n+p}. */
#include "core/number/generic_on.h"

/* How many of the `count` knots equal t (重数). */
static inline int G(multiplicity)(int count, const num u[], num t)
{
    int equal = 0;
    for (int i = 0; i < count; i++)
        equal += !G(before)(u[i], t) && !G(before)(t, u[i]);
    return equal;
}

/* What is wrong with the knots of n points of degree p, and where. */
static inline knot_fault G(check_knots)(int n, int p, const num u[], int *where)
{
    int run = 1;
    *where = 0;
    if (n <= p)
        return KNOTS_TOO_FEW;
    for (int i = 1; i <= n + p; i++) {
        *where = i;
        if (G(before)(u[i], u[i - 1]))
            return KNOTS_DECREASE;
        run = G(before)(u[i - 1], u[i]) ? 1 : run + 1;
        if (run > p + 1)
            return KNOTS_TOO_MULTIPLE;
    }
    *where = p;
    return G(before)(u[p], u[n]) ? KNOTS_GOOD : KNOTS_NO_DOMAIN;
}

/* The span mu of t in the domain: u_mu <= t < u_{mu+1}, for t = u_n the last span.  -1 for t outside.  By bisection. */
static inline int G(find_span)(int n, int p, const num u[], num t)
{
    if (G(before)(t, u[p]) || G(before)(u[n], t))
        return -1;
    int low = p, high = n; /* u_low <= t, and t < u_high or t = u_n */
    if (!G(before)(t, u[n])) {
        while (!G(before)(u[high - 1], u[n]))
            high--;
        return high - 1;
    }
    while (high - low > 1) {
        int middle = low + (high - low) / 2;
        if (G(before)(t, u[middle]))
            high = middle;
        else
            low = middle;
    }
    return low;
}

/* The span on the left of t: u_mu < t <= u_{mu+1}, for t = u_p the first span.  -1 for t outside. */
static inline int G(find_span_left)(int n, int p, const num u[], num t)
{
    int mu = G(find_span)(n, p, u, t);
    if (mu < 0)
        return mu;
    while (mu > p && !G(before)(u[mu], t))
        mu--;
    while (!G(before)(u[mu], u[mu + 1]))
        mu++;
    return mu;
}

/* For each of the m points of degree q over knots v with the domain of u: span[j], a span of u that contains a
 * non-empty [v_l, v_{l+1}], j <= l <= j+q, as bspline_refine and its relatives ask.  Returns 0 and stops where a
 * point has none: its support does not meet the domain. */
static inline int G(spans_of_points)(int n, int p, const num u[], int m, int q, const num v[], int span[])
{
    for (int j = 0; j < m; j++) {
        int l = j < q ? q : j, last = j + q < m ? j + q : m - 1;
        while (l <= last && !G(before)(v[l], v[l + 1]))
            l++;
        if (l > last)
            return 0;
        span[j] = G(find_span)(n, p, u, v[l]);
        if (span[j] < 0)
            return 0;
    }
    return 1;
}
#include "core/number/generic_off.h"
