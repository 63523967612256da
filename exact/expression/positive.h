/* positive.h -- why a rational function has a sign where its variables have bounds (符号的证书), so that others can check it.
 *
 * The function is a product of a number and of powers of polynomials, and each of these that is needed has one sign: the box is cut
 * into parts by numbers, and x = (a + b u)/(1 + u), a + u or b - u maps the positive numbers to a side of a part; then the
 * numerator is a polynomial in the u whose coefficients are of one sign (over a bounded part they are its Bernstein
 * coefficients, each times a positive number). */
#ifndef CAGD_POSITIVE_H
#define CAGD_POSITIVE_H

#include "exact/expression/sign.h"

/* Where a trace is open, the fact {"fact":"sign_in_box"} that d >= 0, or d > 0 if strict, wherever d is defined in the box: 1.  0 where
 * the parts become too many; then nothing is noted.  The fields of the fact, all of nodes but the last five: "of": d; "constant":
 * c and "factors": f_i, d = c f_1^"powers"_1 ...; "variables": x_k, with the bounds "low" and "high", -1 where there is none;
 * "open": whether low and high do not belong to it, 2 for each k; "signs": of each f_i, 0 where none is needed; "cuts": for each f_i
 * with a sign its tree of parts, a part that is not cut being -1, and one that is cut k, the node of the number, the part below it and
 * the part above it; "strict"; "is": 1. */
int cagd_note_sign_in_box(cagd_value d, int strict, int count, const cagd_side_of_box side[]);
#endif
