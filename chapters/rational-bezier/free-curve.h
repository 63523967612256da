/* free-curve.h -- a rational curve of which nothing is asked but positive weights, and the edges of its polygon.
 *
 * Generic text; a section includes it for its one number type. */
#ifndef CAGD_RATIONAL_BEZIER_FREE_CURVE_H
#define CAGD_RATIONAL_BEZIER_FREE_CURVE_H

#include "chapters/judge/claims_on.h"

/* n+1 positive weights, and n+1 points of dim <= 3 coordinates, every one free; on the line (dim = 1) the points are called
 * R, as one coordinate stands for all. */
static inline void G(free_curve)(trial *T, int n, int dim, num R[], num w[])
{
    static const char *const axis[] = {"x", "y", "z"};
    for (int i = 0; i <= n; i++) {
        w[i] = positive(T, "w", i);
        for (int c = 0; c < dim; c++)
            R[i * dim + c] = unknown(T, dim > 1 ? axis[c] : "R", i);
    }
}

/* The same with weights of either sign, which the kernels take. */
static inline void G(curve_of_any_weights)(trial *T, int n, int dim, num R[], num w[])
{
    G(free_curve)(T, n, dim, R, w);
    for (int i = 0; i <= n; i++)
        w[i] = unknown(T, "w", i);
}

/* a_i = R_i - R_{i-1}, i >= 1, dim coordinates. */
static inline void G(edge)(int dim, const num R[], int i, num a[])
{
    for (int c = 0; c < dim; c++)
        a[c] = sub(R[i * dim + c], R[(i - 1) * dim + c]);
}
#include "chapters/judge/claims_off.h"
#endif
