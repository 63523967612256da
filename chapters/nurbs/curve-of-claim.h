/* curve-of-claim.h -- NURBS curves that are drawn from the data of the claims about them. */
#ifndef CAGD_NURBS_CURVE_OF_CLAIM_H
#define CAGD_NURBS_CURVE_OF_CLAIM_H

#include "chapters/judge/figure_data.h"
#include "chapters/nurbs/spline-figures.h"

/* The curve of n points and degree p that a claim has in its data: knots T, points r, weights w. */
static inline spline spline_of_claim(const char *name, int n, int p)
{
    spline s = {.n = n, .p = p};
    data_of(name, "T", n + p + 1, 1, s.u);
    data_of(name, "r", n, 2, s.R);
    data_of(name, "w", n, 1, s.w);
    return s;
}

/* The number that a claim has in its data. */
static inline num_q number_of_claim(const char *name, const char *entry)
{
    num_q a;
    data_of(name, entry, 1, 1, &a);
    return a;
}
#endif
