/* fraction.h -- sums, products and quotients of fractions of polynomials (有理分式) in lowest terms.
 *
 * The greatest common divisor of a numerator and a denominator is what rational functions spend their time on.  But the
 * denominators of this field are nearly all products of few irreducible polynomials, such as differences of knots.  Where
 * the factors of the denominators are known, common ones are found by comparing lists, and whether one of them divides a
 * numerator is a trial division.  Where they are not known it is left to FLINT.  The result is the same in either way: the
 * lowest terms are unique, the leading coefficient of the denominator being positive. */
#ifndef CAGD_FRACTION_H
#define CAGD_FRACTION_H

#include "exact/num_field_slot.h"

/* r = a + b, a - b, a b, a/b; r is none of the others, and b != 0 in the last. */
void fraction_add(struct field_element *r, const struct field_element *a, const struct field_element *b);
void fraction_sub(struct field_element *r, const struct field_element *a, const struct field_element *b);
void fraction_mul(struct field_element *r, const struct field_element *a, const struct field_element *b);
void fraction_div(struct field_element *r, const struct field_element *a, const struct field_element *b);

/* Whether the list of factors, where there is one, multiplies out to the denominator but for an integer: for tests. */
int fraction_list_is_true(const struct field_element *a);

/* The factors that denominators of this thread's field were found to have, begun anew with each field. */
void fraction_open(void);
void fraction_close(void);
#endif
