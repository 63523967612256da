/* total_positivity.h -- is a rational matrix totally positive?  All its minors are asked about; a
 * few eliminations answer.  Matrices are row by row in one array, rows x columns, any shape.
 * Words: "totally nonnegative", all minors >= 0, is what many CAGD texts call totally positive;
 * "totally positive" here has all minors > 0. */
#ifndef CAGD_TOTAL_POSITIVITY_H
#define CAGD_TOTAL_POSITIVITY_H

#include "exact/number/rational.h"

/* All minors >= 0?  Neville elimination of rows and columns in turn, singular and rectangular
 * matrices included.  Source: whitney-1952: the reduction is an equivalence;
 * gasca-pena-1992. */
int cagd_is_totally_nonnegative(int rows, int columns, const cagd_num_q A[]);

/* All minors > 0?  By the criterion of Gasca and Pena: those of consecutive rows and the first
 * columns, and of consecutive columns and the first rows. */
int cagd_is_totally_positive(int rows, int columns, const cagd_num_q A[]);

/* The definition itself, in exponential time: 1 when every minor is >= 0 (> 0 if strict); else 0, and
 * the first minor of least order that is not goes to *worst, which may be NULL. */
struct cagd_minor {
    int order;
    const int *row, *column; /* increasing, `order` of each; they live in the region */
    cagd_num_q value;
};
int cagd_all_minors_nonnegative(int rows, int columns, const cagd_num_q A[], int strict, struct cagd_minor *worst);
#endif
