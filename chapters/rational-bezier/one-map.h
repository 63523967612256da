/* one-map.h -- whether two rational curves are one function of the parameter.
 *
 * Generic text; a section includes it for its one number type. */
#ifndef CAGD_RATIONAL_BEZIER_ONE_MAP_H
#define CAGD_RATIONAL_BEZIER_ONE_MAP_H

#include "exact/record/polynomial.h"

#include "chapters/judge/claims_on.h"

#if RATIONAL
/* The curves of (R, w) and of (S, v), n+1 points of dim coordinates and weights, are one map of t: the cross products of
 * numerators and denominators are equal polynomials.  n <= MAX_DEGREE. */
static inline int G(one_map)(int n, int dim, const num R[], const num w[], const num S[], const num v[])
{
    int equal = 1;
    for (int c = 0; c < dim; c++) {
        num x[MAX_DEGREE + 1], y[MAX_DEGREE + 1];
        for (int i = 0; i <= n; i++) {
            x[i] = mul(w[i], R[i * dim + c]);
            y[i] = mul(v[i], S[i * dim + c]);
        }
        equal &= poly_equal(poly_mul(poly_from_bernstein(n, x), poly_from_bernstein(n, v)),
                            poly_mul(poly_from_bernstein(n, y), poly_from_bernstein(n, w)));
    }
    return equal;
}
#endif
#include "chapters/judge/claims_off.h"
#endif
