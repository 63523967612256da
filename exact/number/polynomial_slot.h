/* polynomial_slot.h -- the inside of a cagd_poly: FLINT's polynomials over Q.
 * Only slots.c and polynomial.c include this file; FLINT stays behind it. */
#ifndef CAGD_POLYNOMIAL_SLOT_H
#define CAGD_POLYNOMIAL_SLOT_H

#include <flint/fmpq_poly.h>

struct cagd_polynomial {
    fmpq_poly_t x;
};
void cagd_polynomial_slot_init(void *p);
void cagd_polynomial_slot_clear(void *p);
#endif
