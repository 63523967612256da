/* curvature.h -- the part of the Hessian matrix that Gauss and Newton leave out, a sum over all points.
 *
 * It is a sum of products x y^T, and symmetric as a whole.  The products of a curve depend only on the unknowns of
 * one piece; they are taken in pair by pair and added up many at a time. */
#ifndef CAGD_FIT_CURVATURE_H
#define CAGD_FIT_CURVATURE_H

#include "core/fit/support.h"

typedef struct fit_curvature fit_curvature;

/* The support has to outlive it.  NULL when there is no memory. */
fit_curvature *fit_curvature_new(const fit_support *support);
void fit_curvature_free(fit_curvature *curvature); /* NULL is allowed */

/* Forgets all products. */
void fit_curvature_clear(fit_curvature *curvature);

/* Where the next `count` <= 32 pairs of the piece are to be written: of each unknown the numbers of the x, `stride`
 * apart, and behind them those of the y. */
double *fit_curvature_pairs(fit_curvature *curvature, int piece, int count, int *stride);

/* The sum: unknowns x unknowns numbers, symmetric.  The caller may change it; valid until the next call. */
double *fit_curvature_matrix(fit_curvature *curvature);
#endif
