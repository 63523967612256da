/* starts.h -- the curves from which a minimum is sought. */
#ifndef CAGD_FIT_STARTS_H
#define CAGD_FIT_STARTS_H

#include "core/fit/problem.h"

/* Start number `start` becomes `curve`.  Number 0 is the initial curve of the options or, where there is none, the
 * best of several guesses, each of which was led near its minimum.  The others are the same curve with random
 * weights, and with points that fit them.  Returns 0 when there is no memory. */
int fit_start(const fit_problem *problem, int start, fit_curve *curve);

/* Random weights for those that are free: their logarithms are uniform between those of 1/weight_spread and
 * weight_spread (strategy.h), or of the bounds where these are nearer; from the seed of the options and `number`. */
void fit_random_weights(const fit_problem *problem, int number, fit_curve *curve);
#endif
