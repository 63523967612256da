/* field_slot.h -- the inside of the number type f: fractions of FLINT's polynomials over Z.
 * Only slots.c, field.c, fraction.c and polynomial.c include this file; FLINT stays behind it. */
#ifndef CAGD_NUM_FIELD_SLOT_H
#define CAGD_NUM_FIELD_SLOT_H

#include <flint/flint.h>
#if __FLINT_RELEASE >= 30000
#include <flint/fmpz_mpoly_q.h>
#else
#include <calcium/fmpz_mpoly_q.h>
#endif

enum { FIELD_MOST_FACTORS = 200, FIELD_MOST_IN_DENOMINATOR = 24, FIELD_MOST_POWER = 200 };

/* prod f_k^power[k]: the irreducible f_k by their numbers in fraction.c, primitive, no two the same. */
struct factored {
    unsigned char known, count, factor[FIELD_MOST_IN_DENOMINATOR], power[FIELD_MOST_IN_DENOMINATOR];
};

/* numerator / (content factors), or numerator / rest where nobody has factored the denominator and `factors` is not
 * known; in lowest terms, the denominator with positive leading coefficient.  What is constant is always factored. */
struct cagd_field_element {
    fmpz_mpoly_t numerator, rest;
    fmpz_t content;
    struct factored factors;
};
void cagd_field_slot_init(void *p); /* 0 */
void cagd_field_slot_clear(void *p);

const fmpz_mpoly_ctx_struct *cagd_field_context(void);
#endif
