/* support.h -- which unknowns the rows of each piece of a curve depend on (支集). */
#ifndef CAGD_FIT_SUPPORT_H
#define CAGD_FIT_SUPPORT_H

/* The rows of piece k depend on the unknowns unknown[first[k]], ..., unknown[first[k+1] - 1] of 0, ..., unknowns-1,
 * and have their coefficients in this order. */
typedef struct fit_support {
    int unknowns, pieces;
    int *first, *unknown;
} fit_support;
#endif
