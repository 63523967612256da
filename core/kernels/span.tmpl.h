/* span.tmpl.h -- where a parameter lies among knots: the decisions that the kernels leave to their callers.
 *
 * Included once for binary64 (core/kernels/span.h) and once for rationals (exact/span.h); G(before)(a, b) says a < b.
 * Shapes as in bspline.tmpl.h: n points of degree p, knots u_0, ..., u_{n+p}. */
#include <stddef.h>

#include "core/number/generic_on.h"

/* How many of the `count` knots equal t (重数). */
KERNEL int G(multiplicity)(int count, const num u[], num t)
{
    int equal = 0;
    for (int i = 0; i < count; i++)
        equal += !G(before)(u[i], t) && !G(before)(t, u[i]);
    return equal;
}

/* What is wrong with the knots of n points of degree p, and where. */
KERNEL cagd_status G(check_knots)(int n, int p, const num u[], int *where)
{
    int run = 1;
    *where = 0;
    if (n <= p)
        return CAGD_COUNT;
    for (int i = 1; i <= n + p; i++) {
        *where = i;
        if (G(before)(u[i], u[i - 1]))
            return CAGD_KNOTS_DECREASE;
        run = G(before)(u[i - 1], u[i]) ? 1 : run + 1;
        if (run > p + 1)
            return CAGD_KNOTS_MULTIPLE;
    }
    *where = p;
    return G(before)(u[p], u[n]) ? CAGD_OK : CAGD_KNOTS_EMPTY;
}

/* The span mu of t in the domain: u_mu <= t < u_{mu+1}, for t = u_n the last span.  -1 for t outside.  By bisection. */
KERNEL int G(find_span)(int n, int p, const num u[], num t)
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
KERNEL int G(find_span_left)(int n, int p, const num u[], num t)
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

/* For point j of the m points of degree q over knots v with the domain of u: a span of u that contains a non-empty
 * [v_l, v_{l+1}], j <= l <= j+q, as bspline_refine and its relatives ask.  -1 if its support does not meet the domain. */
KERNEL int G(span_of_point)(int n, int p, const num u[], int m, int q, const num v[], int j)
{
    int l = j < q ? q : j, last = j + q < m ? j + q : m - 1;
    while (l <= last && !G(before)(v[l], v[l + 1]))
        l++;
    return l <= last ? G(find_span)(n, p, u, v[l]) : -1;
}

/* span[j] for all of them.  Returns 0 if some point has none, otherwise 1. */
KERNEL int G(spans_of_points)(int n, int p, const num u[], int m, int q, const num v[], int span[])
{
    int all = 1;
    for (int j = 0; j < m; j++) {
        span[j] = G(span_of_point)(n, p, u, m, q, v, j);
        all = all && span[j] >= 0;
    }
    return all;
}
/* The knots of the same spline in degree p+1: every distinct knot once more than in u.  Of this sequence v takes as much as
 * the domain asks for: p+2 knots up to the last copy of u_p, those in between, and p+2 from the first copy of u_n on.
 * Returns the number m of points; v has m+p+2 knots and may be NULL. */
KERNEL int G(raised_knots)(int n, int p, const num u[], num v[])
{
    int up_to_start = 0, between = 0;
    for (int i = 0; i <= n + p; i++) {
        int copies = i == n + p || G(before)(u[i], u[i + 1]) ? 2 : 1;
        if (!G(before)(u[p], u[i]))
            up_to_start += copies;
        else if (G(before)(u[i], u[n]))
            between += copies;
    }
    int m = p + 2 + between, skip = up_to_start - (p + 2), at = 0;
    for (int i = 0; v != NULL && i <= n + p; i++)
        for (int copies = i == n + p || G(before)(u[i], u[i + 1]) ? 2 : 1; copies > 0; copies--, at++)
            if (skip <= at && at - skip < m + p + 2)
                v[at - skip] = u[i];
    return m;
}

/* The knots of the same spline in degree p-1, if it is of that degree, p >= 1: inner knots once less than in u, the ends
 * of the domain p times.  Returns the number m of points; v has m+p knots and may be NULL. */
KERNEL int G(lowered_knots)(int n, int p, const num u[], num v[])
{
    int m = p;
    for (int i = p; i < n; i++) /* an inner knot that is not the last of its copies */
        if (G(before)(u[p], u[i]) && !G(before)(u[i], u[i + 1]) && G(before)(u[i], u[n])) {
            if (v != NULL)
                v[m] = u[i];
            m++;
        }
    for (int i = 0; v != NULL && i < p; i++) {
        v[i] = u[p];
        v[m + i] = u[n];
    }
    return m;
}
#include "core/number/generic_off.h"
