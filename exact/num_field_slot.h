/* num_field_slot.h -- the inside of the number type f: FLINT's fractions of polynomials over Z.
 * Only slots.c, num_field.c and polynomial.c include this file; FLINT stays behind it. */
#ifndef CAGD_NUM_FIELD_SLOT_H
#define CAGD_NUM_FIELD_SLOT_H

#include <flint/flint.h>
#if __FLINT_RELEASE >= 30000
#include <flint/fmpz_mpoly_q.h>
#else
#include <calcium/fmpz_mpoly_q.h>
#endif

struct field_element {
    fmpz_mpoly_q_t x; /* in lowest terms */
};
void field_slot_init(void *p);
void field_slot_clear(void *p);

const fmpz_mpoly_ctx_struct *field_context(void);
#endif
