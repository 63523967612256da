/* fraction.h -- sums, products and quotients of fractions of polynomials (有理分式) in lowest terms.
 *
 * The greatest common divisor of a numerator and a denominator is what rational functions spend their time on.  But the
 * denominators of this field are nearly all products of few irreducible polynomials, such as differences of knots.  They
 * are kept as lists of their factors, and multiplied out only where somebody asks for them: common factors are found by
 * comparing lists, and whether one of them divides a numerator is a trial division.  Denominators that are not factored
 * are left to FLINT.  The result is the same in either way: the lowest terms are unique, the leading coefficient of the
 * denominator being positive. */
#ifndef CAGD_FRACTION_H
#define CAGD_FRACTION_H

#include "exact/number/field_slot.h"

/* r = a + b, a - b, a b, a/b, da/dx for the variable of that number; r is none of the others and 0 before, and b != 0
 * in the quotient. */
void cagd_fraction_add(struct cagd_field_element *r, const struct cagd_field_element *a,
                       const struct cagd_field_element *b);
void cagd_fraction_sub(struct cagd_field_element *r, const struct cagd_field_element *a,
                       const struct cagd_field_element *b);
void cagd_fraction_mul(struct cagd_field_element *r, const struct cagd_field_element *a,
                       const struct cagd_field_element *b);
void cagd_fraction_div(struct cagd_field_element *r, const struct cagd_field_element *a,
                       const struct cagd_field_element *b);
void cagd_fraction_derivative(struct cagd_field_element *r, const struct cagd_field_element *a, int variable);

/* r = p/q for the denominator q of a. */
void cagd_fraction_over_denominator_of(struct cagd_field_element *r, const fmpz_mpoly_t p,
                                       const struct cagd_field_element *a);

int cagd_fraction_equal(const struct cagd_field_element *a, const struct cagd_field_element *b);
int cagd_fraction_is_polynomial(const struct cagd_field_element *a); /* over the integers: the denominator is 1 */

/* What FLINT has for it; and the denominator alone, multiplied out. */
void cagd_fraction_get(fmpz_mpoly_q_t x, const struct cagd_field_element *a);
void cagd_fraction_denominator(fmpz_mpoly_t q, const struct cagd_field_element *a);
int cagd_fraction_denominator_degree(const struct cagd_field_element *a, int variable);

/* The factors that denominators of this thread's field were found to have, begun anew with each field. */
void cagd_fraction_open(void);
void cagd_fraction_close(void);
#endif
