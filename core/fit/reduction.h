/* reduction.h -- a tall least-squares system, taken in row by row and kept as its triangle (QR).
 *
 * The rows of a curve reach only the unknowns of one piece.  So every piece has its own triangle, of its own unknowns
 * and of the right-hand sides, and these are joined at the end (C. L. Lawson and R. J. Hanson, Solving Least Squares
 * Problems, ch. 27).  The memory does not depend on how many rows there are. */
#ifndef CAGD_FIT_REDUCTION_H
#define CAGD_FIT_REDUCTION_H

typedef struct fit_reduction fit_reduction;

/* Unknowns 0, ..., unknowns-1, and `sides` right-hand sides.  The rows of piece k reach the unknowns
 * reach[first[k]], ..., reach[first[k+1] - 1], in this order.  NULL when there is no memory. */
fit_reduction *fit_reduction_new(int unknowns, int sides, int pieces, const int first[], const int reach[]);
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
