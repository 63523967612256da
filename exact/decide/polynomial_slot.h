/* polynomial_slot.h -- the inside of a poly: FLINT's polynomials over Q.
 * Only slots.c and polynomial.c include this file; FLINT stays behind it. */
#ifndef CAGD_POLYNOMIAL_SLOT_H
#define CAGD_POLYNOMIAL_SLOT_H

#include <flint/fmpq_poly.h>

struct polynomial {
    fmpq_poly_t x;
};
void polynomial_slot_init(void *p);
void polynomial_slot_clear(void *p);
#endif
