/* cylinders.h -- whether polynomial conditions imply another one, by cylindrical decomposition (柱形代数分解).
 *
 * The polynomials are projected: the last variable is eliminated by coefficients, discriminants and resultants of their irreducible
 * factors, until one is left.  Over each cell that the roots of the projection make, the polynomials with the next variable have
 * constantly many roots; so one point of each cell decides, a rational one between two roots, or a root itself (algebraic.h).  A polynomial
 * that is 0 for all values of its last variable over a cell is the exception; where it matters the answer is that nothing is known, which in
 * at most three variables does not happen.  Source: collins-1975; mccallum-1998, whose projection this is. */
#ifndef CAGD_CYLINDERS_H
#define CAGD_CYLINDERS_H

#include "exact/decide/algebraic.h"

/* That the polynomial p has one of these signs. */
enum { CAGD_IS_NEGATIVE = 1, CAGD_IS_ZERO = 2, CAGD_IS_POSITIVE = 4 };
typedef struct cagd_sign_condition {
    cagd_num_f p;
    unsigned signs;
} cagd_sign_condition;

/* IMPLIED: where all that is given is true, so is the claim.  NOT_IMPLIED: at *counterexample, whose coordinates are those of the
 * variables x[0], ..., in this order, it is not.  NOT_KNOWN: there were too many polynomials, of too high degrees, or the time
 * (core/clock.h) was over.  The variables of all polynomials are among the x, of which there are at most CAGD_MOST_COORDINATES. */
enum cagd_implication { CAGD_IMPLIED, CAGD_NOT_IMPLIED, CAGD_IMPLICATION_NOT_KNOWN };
enum cagd_implication cagd_implies(int count, const cagd_sign_condition given[], cagd_sign_condition claim,
                                   int variables, const cagd_num_f x[], double until,
                                   cagd_algebraic_point *counterexample);
#endif
