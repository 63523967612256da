/* reduction.h -- a tall least-squares system, taken in row by row and kept as its triangle (QR).
 *
 * The rows of a curve depend only on the unknowns of one piece.  So every piece has its own triangle, of its own
 * unknowns and of the right-hand sides, and these are joined at the end (C. L.  Lawson and R. J.  Hanson, Solving
 * Least Squares Problems, ch. 27).  The memory does not depend on how many rows there are. */
#ifndef CAGD_FIT_REDUCTION_H
#define CAGD_FIT_REDUCTION_H

#include "core/fit/support.h"

typedef struct fit_reduction fit_reduction;

/* Of rows with `sides` right-hand sides.  The support has to outlive it.  NULL when there is no memory. */
fit_reduction *fit_reduction_new(const fit_support *support, int sides);
void fit_reduction_free(fit_reduction *reduction); /* NULL is allowed */

/* Forgets all rows. */
void fit_reduction_clear(fit_reduction *reduction);

/* Where the next row of the piece is to be written: its coefficients, then its right-hand sides, `stride` apart. */
double *fit_reduction_row(fit_reduction *reduction, int piece, int *stride);

/* The same for the next `count` <= 8 rows: those of one column lie side by side. */
double *fit_reduction_rows(fit_reduction *reduction, int piece, int count, int *stride);

/* The triangle of all rows: (unknowns+sides)^2 numbers by rows, zero below the diagonal.  Valid until the next
 * call. */
const double *fit_reduction_triangle(fit_reduction *reduction);
#endif
