/* jacobian.h -- curves with one or two unknowns moved by the step h, and what they give: derivatives of residuals. */
#ifndef CERTIFY_JACOBIAN_H
#define CERTIFY_JACOBIAN_H

#include "proofs-tests/fit/certify/curve.h"

/* moved[0]: none is moved; [1+k] varied unknown k by +h, [1+n+k] by -h; [pair(k, l)] k and l by +h, k != l. */
extern num **moved;
int pair(int k, int l);
void move_curves(void); /* around found.value */

/* What the residual of point i, divided by s_i, does when the unknowns move: rest, and in J the derivatives without
 * their part along the curve, for the foot follows.  E bounds how wrong each derivative may be when computed with
 * relative errors of eps = 1: |dC/d theta| and, for a weight, where points are subtracted, M; and the tangent turned
 * by 2 p M/(smallest span |C'|). */
void jacobian(int i, num *b[3], num rest[3], num J[MOST][3], num E[MOST]);
/* rho', rho'' at x. */
void loss_derivatives(num x, num *first, num *second);
/* A = J^T J, each point counted rho'(x) times, x its squared distance, or once if not robust; B, unless it is
 * NULL, = E^T E. */
void gauss_newton(num *A, num *B, int robust);
#endif
