/* smooth.h -- the smoothing term over a box of unknowns (only for this folder). */
#ifndef CAGD_STATIONARY_SMOOTH_H
#define CAGD_STATIONARY_SMOOTH_H

#include "exact/fit/box.h"

/* Adds what the smoothing term adds to gradient and Hessian, of which the upper triangle is filled; a stride-th part of it where only every
 * stride-th point counts. */
void cagd_stationary_smooth(struct box *b, int stride);
#endif
