/* standard.h -- functions that every text of the field has, by name, under the letters of the text that is read.
 *
 *     bernstein B_i^n(t)                                B_i^n(t) = \binom{n}{i} t^i (1-t)^{n-i}
 *     bspline N_i^p(t) over u_i                         of degree p: Cox and de Boor; over knots that coincide a term is 0
 *     bspline-order N_i^k(t) over u_i                   the same, of order k
 *     de-casteljau P_i^r(t) of P_i                      the points of the algorithm
 *     de-boor d_i^{p,r}(t) of d_i over u_i              the points of the algorithm, of degree p
 *     bezier P^n(t) of P_i                              \sum_{i=0}^n P_i B_i^n(t)
 *     rational-bezier R^n(t) of P_i with \omega_i
 *     cubic-hermite H_i(t)                              i = 0, 1: the values at 0 and 1; 2, 3: the derivatives there
 *
 * The letters and the form are those of the text: \hat N_{j,k}(x), C_n(t).  Indices are told apart by where they stand, those below before those
 * above, the first below before the second. */
#ifndef CAGD_STANDARD_H
#define CAGD_STANDARD_H

#include "exact/expression/scope.h"

enum { CAGD_STANDARD_MESSAGE = 300 };

/* What the line stands for, as lines of a let block (read.h), each with its end; the text lives in the region.  Knots that are not yet known are
 * declared, in their order.  NULL and the message where it is no such line. */
const char *cagd_standard(const cagd_scope *scope, const char *line, int length, char message[CAGD_STANDARD_MESSAGE]);
#endif
