/* initial.h -- where the minimiser starts. */
#ifndef CAGD_FIT_INITIAL_H
#define CAGD_FIT_INITIAL_H

#include "core/fit/problem.h"

/* The order of points that come in none: order[i] is the index of the i-th along a curve.  Three guesses, `guess` 0, 1, 2: along
 * the principal axis; around the centre in the principal plane, from the widest gap on; from neighbour to neighbour.
 * Returns 0 when there is no memory. */
enum { FIT_ORDERS = 3 };
int fit_initial_order(const fit_problem *problem, int guess, int order[]);

/* The curve without knowledge: ends at the first and the last point in the given order, weights as they stand in `curve`, the free points by linear
 * least squares, at first for parameters that follow the chords, then for the feet on the curve before.  *cost: its own.
 * Returns 0 when there is no memory. */
int fit_initial_curve(const fit_problem *problem, const int order[], fit_curve *curve, double *cost);

/* A few rounds more of it, for a curve that is there. */
int fit_initial_improve(const fit_problem *problem, fit_curve *curve);

/* Other weights for the free ones: logarithms even between those of 1/spread and spread (strategy.h), or the bounds, from a
 * seeded generator. */
void fit_initial_weights(const fit_problem *problem, unsigned long seed, int start, fit_curve *curve);
#endif
