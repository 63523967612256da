/* tolerance.h -- the fewest control points found that keep every point within a distance (给定误差).
 *
 * A tolerance asks for no degrees of freedom, only for max |e_i| <= eps.  Where knots that help most do not meet it with half of the equations
 * left, they are put in as dense as the points; then even knots are tried, a quarter more of them each time, with curves led to from smooth ones
 * (continuation.h); and at last even knots with the smoothing term kept, as large, to a factor of 10, as meets it. */
#ifndef CAGD_FIT_TOLERANCE_H
#define CAGD_FIT_TOLERANCE_H

#include "core/fit/search.h"

/* s->best, which may not keep within the distance or have loops, is replaced where one of these ways leads to a better answer: one that meets the
 * distance without loops, or has no loops, or comes nearer. */
cagd_status fit_search_within(fit_search *s);
#endif
