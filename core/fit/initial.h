/* initial.h -- a curve near given points, its weights being known. */
#ifndef CAGD_FIT_INITIAL_H
#define CAGD_FIT_INITIAL_H

#include "core/fit/problem.h"

/* From the points alone.  The ends are the first and the last point in the given order; the weights are those of
 * `curve`; the free points follow by linear least squares, at first for parameters along the chords, and then, in
 * turn with the feet, for the feet on the curve before.  Returns 0 when there is no memory. */
int fit_initial_curve(const fit_problem *problem, const int order[], fit_curve *curve);

/* From a curve: its feet and its free points in turn.  Returns 0 when there is no memory. */
int fit_initial_improve(const fit_problem *problem, fit_curve *curve);
#endif
