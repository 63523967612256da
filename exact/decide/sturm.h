/* sturm.h -- the number of different real roots by Sturm's theorem.
 *
 * The second way, independent of roots.h: with p_0 = p squarefree, p_1 = p' and p_(k+1) minus the
 * remainder of p_(k-1) by p_k, the chain has V(a) - V(b) more changes of sign at a than at b, and
 * that is the number of roots in (a,b].  Source: sturm-1829; basu-pollack-roy-2006, 2.2.2. */
#ifndef CAGD_STURM_H
#define CAGD_STURM_H

#include "exact/number/polynomial.h"

/* Different roots in (a,b], (a,infinity), (-infinity,b], on the line.  UNDEFINED for p = 0 and for a > b. */
int cagd_sturm_count(cagd_poly p, cagd_num_q a, cagd_num_q b);
int cagd_sturm_count_above(cagd_poly p, cagd_num_q a);
int cagd_sturm_count_below(cagd_poly p, cagd_num_q b);
int cagd_sturm_count_line(cagd_poly p);
#endif
