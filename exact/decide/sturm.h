/* sturm.h -- the number of different real roots by Sturm's theorem.
 *
 * The second way, independent of roots.h: with p_0 = p squarefree, p_1 = p' and p_(k+1) minus the
 * remainder of p_(k-1) by p_k, the chain has V(a) - V(b) more changes of sign at a than at b, and
 * that is the number of roots in (a,b].  Source: C. Sturm 1829; S. Basu, R. Pollack, M.-F. Roy,
 * Algorithms in Real Algebraic Geometry, 2.2.2. */
#ifndef CAGD_STURM_H
#define CAGD_STURM_H

#include "exact/decide/polynomial.h"

/* Different roots in (a,b], (a,infinity), (-infinity,b], on the line.  UNDEFINED for p = 0 and for a > b. */
int sturm_count(poly p, num_q a, num_q b);
int sturm_count_above(poly p, num_q a);
int sturm_count_below(poly p, num_q b);
int sturm_count_line(poly p);
#endif
