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
 * The square of its length can then neither overflow nor vanish. */
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

/* n = a x b, of vectors of the plane its third component, scaled as well: of nearly parallel vectors of length 1 it is so short that
 * its square would vanish.  Returns the exponent. */
static inline int normalized_product(int dim, const double a[], const double b[], double n[])
{
    n[0] = n[1] = 0;
    if (dim == 2)
        n[2] = cross2_d(a, b);
    else
        cross3_d(a, b, n);
    return normalize(3, n);
}

/* *curvature = |d1 x d2| / |d1|^3 from the first two derivatives, which are scaled on the way, dim 2 or 3. */
static inline cagd_status curvature_of_derivatives(int dim, double d1[], double d2[], double *curvature)
{
    int e1 = normalize(dim, d1), e2 = normalize(dim, d2);
    double n[3], g = norm_squared_d(dim, d1);
    REQUIRE(g != 0, CAGD_UNDEFINED);
    int e = normalized_product(dim, d1, d2, n);
    double gram = norm_squared_d(3, (const double[]){n[2], n[1], n[0]}); /* the minors in the order of the kernel */
    *curvature = ldexp(sqrt(gram / (g * (g * g))), e + e2 - 2 * e1);
    return result(1, curvature);
}

/* *torsion = (d1 x d2) . d3 / |d1 x d2|^2 from the first three derivatives of a curve in space, which are scaled on the way. */
static inline cagd_status torsion_of_derivatives(double d1[], double d2[], double d3[], double *torsion)
{
    int e1 = normalize(3, d1), e2 = normalize(3, d2), e3 = normalize(3, d3);
    double n[3];
    int e = normalized_product(3, d1, d2, n);
    REQUIRE(norm_squared_d(3, n) != 0, CAGD_UNDEFINED);
    *torsion = ldexp(dot_d(3, n, d3) / norm_squared_d(3, n), e3 - e1 - e2 - e);
    return result(1, torsion);
}
#endif
