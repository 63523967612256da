/* curve.h -- the curve, by the recursion of its basis, and the cost of a point: the only formulas of the problem, of
 * which everything else is a difference.  A curve is an array: w_0, ..., w_{count-1} and, behind them, the
 * coordinates of w_j P_j. */
#ifndef CERTIFY_CURVE_H
#define CERTIFY_CURVE_H

#include "proofs-tests/fit/certify/problem.h"

/* The curve of these unknowns. */
void curve_of(num *theta, num *curve);
/* N_{j,p}(t), j = 0 ... count-1, by the recursion that defines them, on the span that holds t. */
void basis(num t, num *b);
/* Q_i - C: coordinates into r. */
void residual(num *curve, num *b, int i, num *r);
/* rho(|Q_i - C|^2 / s_i^2) / 2, b the basis at the foot. */
num phi(num *curve, num *b, int i);
/* The sum of phi over all points, with the feet t. */
num cost(num *theta, num *t);
#endif
