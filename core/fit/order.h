/* order.h -- the order along a curve of points that are given in none. */
#ifndef CAGD_FIT_ORDER_H
#define CAGD_FIT_ORDER_H

#include "core/fit/problem.h"

/* Three guesses: along the principal axis of the points; around their centre in the principal plane, from the widest
 * gap on; from each point to its nearest neighbour, beginning with the one farthest from the centre. */
enum fit_order_kind { FIT_ALONG_AXIS, FIT_AROUND_CENTRE, FIT_BY_NEIGHBOURS, FIT_ORDERS };

/* order[i]: the index of the i-th point along the curve; of the two ends the first is the one that has the lower index.
 * Returns 0 when there is no memory. */
int fit_order(const fit_problem *problem, enum fit_order_kind kind, int order[]);
#endif
