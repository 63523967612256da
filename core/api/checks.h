/* checks.h -- what the functions of the double library share: the order of their checks, and what they do to
 * derivatives so that squares neither overflow nor vanish. */
#ifndef CAGD_CHECKS_H
#define CAGD_CHECKS_H

#include "core/api/cagd.h"
#include "core/kernels/kernels_d.h"
#include "core/require.h"

#include <math.h>
#include <stddef.h>

#define PASS(expression)                                                                                               \
    do {                                                                                                               \
        cagd_status passed = (expression);                                                                             \
        REQUIRE(passed == CAGD_OK, passed);                                                                            \
    } while (0)

static inline int in(int lowest, int k, int highest) { return lowest <= k && k <= highest; }

static inline int finite(int count, const double x[])
{
    for (int i = 0; i < count; i++)
        if (!isfinite(x[i]))
            return 0;
    return 1;
}

/* A result that left the range of binary64 is infinite or not a number. */
static inline cagd_status result(int count, const double x[]) { return finite(count, x) ? CAGD_OK : CAGD_OVERFLOW; }

static inline cagd_status nonzero(int count, const double weights[])
{
    for (int i = 0; i < count; i++)
        REQUIRE(weights[i] != 0, CAGD_UNDEFINED);
    return CAGD_OK;
}

/* d times the power 2^-e of two that brings its largest component into [1/2, 1).  Returns e, or 0 for d = 0.
 * Squares of components can then neither overflow nor vanish. */
static inline int normalize(int dim, double d[])
{
    double largest = 0;
    int e;
    for (int c = 0; c < dim; c++)
        largest = fmax(largest, fabs(d[c]));
    frexp(largest, &e);
    for (int c = 0; c < dim; c++)
        d[c] = ldexp(d[c], -e);
    return e;
}

/* *curvature from the first two derivatives, which are scaled on the way. */
static inline cagd_status curvature_of_derivatives(int dim, double d1[], double d2[], double *curvature)
{
    int e1 = normalize(dim, d1), e2 = normalize(dim, d2);
    REQUIRE(norm_squared_d(dim, d1) != 0, CAGD_UNDEFINED);
    *curvature = ldexp(curvature_d(dim, d1, d2), e2 - 2 * e1);
    return result(1, curvature);
}

/* *torsion from the first three derivatives of a curve in space, which are scaled on the way. */
static inline cagd_status torsion_of_derivatives(double d1[], double d2[], double d3[], double *torsion)
{
    int e1 = normalize(3, d1), e2 = normalize(3, d2), e3 = normalize(3, d3);
    REQUIRE(gram_d(3, d1, d2) != 0, CAGD_UNDEFINED);
    *torsion = ldexp(torsion_d(d1, d2, d3), e3 - e1 - e2);
    return result(1, torsion);
}
#endif
