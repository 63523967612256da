/* placement.h -- where knots are put in, and which are taken out again (节点的选取).
 *
 * With e_i the distances and t_i the feet, a knot is put into the segment [u_g, u_g+1) with the largest sum S_g = sum e_i^2, with a tolerance into
 * that with the largest e_i^2, where half of S_g lies on either side: midway between the feet i and i+1 for the first i up to which the sum is
 * S_g/2 or more.  Each fit begins with the one before on the new knots (knots.h).  The best curve then loses the knot without which its score is
 * the smallest, as long as that makes it smaller. */
#ifndef CAGD_FIT_PLACEMENT_H
#define CAGD_FIT_PLACEMENT_H

#include "core/fit/search.h"

/* Knots are put in, each where it helps most, and even ones; then they are taken out, of a shapely curve as long as it stays one.  s->best
 * becomes the best curve, NULL where there is none.  Of a tolerance that is not met the smallest one that is found takes its place. */
cagd_status fit_search_knots(fit_search *s);

/* Even knots, or those that are put in one by one, from these, over which `last` is a fit unless it is NULL, until `patience` more have not
 * helped, or there are more than 30 without any that may be best; of scattered points, of which means have led to none, 5.  `last` is released. */
cagd_status fit_put_into(fit_search *s, fit_knots k, cagd_fit_result *last, int even, int patience);

/* Knots are taken out of the best curve, that first without which it is best, as long as it becomes better.  Where it does not, the neighbours of
 * the one that is taken out move towards its place. */
cagd_status fit_take_out_idle(fit_search *s);

/* As many control points as are asked for, over knots that are put in one by one.  A fit with a knot more that ends higher is not taken; the one
 * before goes on with the next knot as well.  The curve takes the place of the best one, which is not good or has loops, if it has neither. */
cagd_status fit_place_knots(fit_search *s);
#endif
