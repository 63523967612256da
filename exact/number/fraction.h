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
void fraction_add(struct field_element *r, const struct field_element *a, const struct field_element *b);
void fraction_sub(struct field_element *r, const struct field_element *a, const struct field_element *b);
void fraction_mul(struct field_element *r, const struct field_element *a, const struct field_element *b);
void fraction_div(struct field_element *r, const struct field_element *a, const struct field_element *b);
void fraction_derivative(struct field_element *r, const struct field_element *a, int variable);

/* r = p/q for the denominator q of a. */
void fraction_over_denominator_of(struct field_element *r, const fmpz_mpoly_t p, const struct field_element *a);

int fraction_equal(const struct field_element *a, const struct field_element *b);
int fraction_is_polynomial(const struct field_element *a); /* over the integers: the denominator is 1 */

/* What FLINT has for it; and the denominator alone, multiplied out. */
void fraction_get(fmpz_mpoly_q_t x, const struct field_element *a);
void fraction_denominator(fmpz_mpoly_t q, const struct field_element *a);
int fraction_denominator_degree(const struct field_element *a, int variable);

/* The factors that denominators of this thread's field were found to have, begun anew with each field. */
void fraction_open(void);
void fraction_close(void);
#endif
