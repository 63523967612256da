/* feet.h -- foot points: where the cost of a point is stationary in t, or smallest at an end of the domain. */
#ifndef CERTIFY_FEET_H
#define CERTIFY_FEET_H

#include "proofs-tests/fit/certify/curve.h"

/* The foot near t, by Newton's method; *end: whether it is an end of the domain.  0 if it is not found. */
int settle(num *curve, int i, num t, int *end);
/* found.foot and found.at_end, the nearest foot of every point: the nearest of many samples, then Newton between its
 * neighbours, else bisection. */
void find_feet(num *curve);
#endif
