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

enum { FIELD_MOST_FACTORS = 200, FIELD_MOST_IN_DENOMINATOR = 24, FIELD_MOST_POWER = 200 };

/* c prod f_k^power[k]: the irreducible f_k by their numbers in fraction.c, no two the same, and c an integer. */
struct factored {
    unsigned char known, count, factor[FIELD_MOST_IN_DENOMINATOR], power[FIELD_MOST_IN_DENOMINATOR];
};
struct field_element {
    fmpz_mpoly_q_t x;            /* in lowest terms                                    */
    struct factored denominator; /* of x; known = 0: nobody has factored it            */
};
void field_slot_init(void *p);
void field_slot_clear(void *p);

const fmpz_mpoly_ctx_struct *field_context(void);
#endif
