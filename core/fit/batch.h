/* batch.h -- feet and rows of several neighbouring points at once, which the compiler computes in vectors. */
#ifndef CAGD_FIT_BATCH_H
#define CAGD_FIT_BATCH_H

#include "core/fit/objective.h"

enum { FIT_BATCH = 8 };

/* Takes in the points i, ..., i + FIT_BATCH - 1 of a conic or cubic of the plane, in one span and with squares for a
 * loss: their feet, sought from feet[], go to new_feet[], their rows to the reduction, their products of second
 * derivatives to the curvature, and their losses to loss[].  Returns 0, and nothing is done, when the curve is another
 * one, or when one of the feet is not found within LOOKS steps of Newton's method; such points are to be taken one by
 * one. */
int fit_batch(fit_objective *objective, int i, int weighted, double loss[]);

/* The number of points in one vector of this processor: 2, 4 or 8.  The objective's `width` may be less, and the numbers
 * are the same; with 0 all points are taken one by one. */
int fit_batch_widest(void);
#endif
