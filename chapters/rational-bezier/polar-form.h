/* polar-form.h -- the polar form of a curve at arguments of which most are one of two parameters.
 *
 * Generic text; a section includes it for its one number type. */
#ifndef CAGD_RATIONAL_BEZIER_POLAR_FORM_H
#define CAGD_RATIONAL_BEZIER_POLAR_FORM_H

#include "chapters/judge/claims_on.h"

/* out = p(c^r, t^k, ...): the polar form of the points H with r arguments c, k arguments t and then x, y,
 * as many of these as places are left; r + k = n-2, n-1 or n. */
static inline void G(polar)(int n, int dim, const num H[], int r, num c, int k, num t, num x, num y, num out[])
{
    num u[MAX_DEGREE];
    for (int i = 0; i < n; i++)
        u[i] = i < r ? c : i < r + k ? t : i == r + k ? x : y;
    G(bezier_blossom)(n, dim, H, u, out);
}
#include "chapters/judge/claims_off.h"
#endif
