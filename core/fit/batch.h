/* batch.h -- feet and rows of several neighbouring points at once, which the compiler computes in vectors. */
#ifndef CAGD_FIT_BATCH_H
#define CAGD_FIT_BATCH_H

#include "core/fit/objective.h"

enum { FIT_BATCH = 8 };

/* The points i, ..., i + FIT_BATCH - 1 of a conic or cubic of the plane, in one span and with squares for a loss: their feet from
 * feet[] go to new_feet[], their rows and products of second derivatives are taken in, and their losses returned.  0, and nothing done, when the curve is
 * another one or a foot is not found within LOOKS steps of Newton's method from the last one: then they are taken one by one. */
int fit_batch(fit_objective *objective, int i, int weighted, double loss[]);

/* The number of points in one vector of this processor, 2, 4 or 8.  The objective's `width` may be less: the numbers are the same;
 * or 0: all points are taken one by one. */
int fit_batch_widest(void);
#endif
