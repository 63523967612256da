/* batch.h -- feet and rows of several neighbouring points at once, which the compiler computes in vectors. */
#ifndef CAGD_FIT_BATCH_H
#define CAGD_FIT_BATCH_H

#include "core/fit/objective.h"

enum { FIT_BATCH = 8 };

/* Takes in the points i, ..., i + FIT_BATCH - 1 of a conic or cubic of the plane, in one span and with squares for a
 * loss: their feet, sought from feet[], go to new_feet[], their losses to loss[] and, as `extent` says, their rows to the
 * reduction and their products of second derivatives to the curvature.  Returns 0, and nothing is done, when the curve is another
 * one, when one of the feet is held, or is not found within LOOKS steps of Newton's method; such points are to be taken one
 * by one. */
int fit_batch(fit_objective *objective, int i, fit_extent extent, double loss[]);

/* The feet of these points alone, as fit_foot finds them from feet[], which they replace, with a vector of `width` points; D[k]:
 * point and two derivatives at that of point i + k.  Returns 0 as above, whatever the loss. */
int fit_batch_feet(const fit_problem *problem, const fit_curve *curve, int width, int i, double feet[], double D[][6]);

/* The number of points in one vector of this processor: 2, 4 or 8.  The objective's `width` may be less, and the numbers
 * are the same; with 0 all points are taken one by one. */
int fit_batch_widest(void);
#endif
