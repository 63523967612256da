/* newton.h -- the minimum in all unknowns and feet at once, by Newton's method on the reduced system. */
#ifndef CERTIFY_NEWTON_H
#define CERTIFY_NEWTON_H

#include "proofs-tests/fit/certify/curve.h"

/* Solves A x = b, A symmetric, n by n, for several right-hand sides, the columns of b, which become the solutions;
 * by elimination without exchanges.  1 if all pivots are positive. */
int solve(int n, num *A, int columns, num *b);

/* Sets found to the minimum and returns the number of iterations.  From the true curve, with found.foot on it. */
int minimise(void);

/* S: second derivatives of the cost in the varied unknowns, n by n, when the feet follow; made by reduce, which
 * returns the largest component of the gradient in unknowns and feet. */
extern num *S;
num reduce(void);
#endif
