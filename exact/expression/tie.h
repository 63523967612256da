/* tie.h -- equalities of higher degree between names without values.
 *
 * c^2 + s^2 = 1 makes both names functions of u = s/(1+c): c = (1-u^2)/(1+u^2), s = 2u/(1+u^2).  What no u reaches, c = -1 with s = 0,
 * is looked at apart.  r^2 = x makes x a function of r.  What tells one name alone, such as r^2 = 2, leaves finitely many numbers:
 * the rational ones are looked at one by one, and for each of the others the name is between two rational numbers that are near. */
#ifndef CAGD_TIE_H
#define CAGD_TIE_H

#include "exact/expression/evaluate.h"

/* Makes d = 0 known of the cell: 1; 0 where it is of no such kind, and nothing changes; -1 where the name has several values, which are
 * noted in the context. */
int cagd_tie(cagd_context *c, cagd_num_f d);

/* The name stands for the greatest root of the irreducible polynomial, and for nothing else: sqrt(2). */
void cagd_make_root(cagd_binding *b, cagd_poly factor);

/* d with the powers of every name that is near a root reduced by the polynomial of that root: equal to d at the root, UNDEFINED where the
 * denominator is 0 there. */
cagd_value cagd_at_roots(const cagd_context *c, cagd_value d);
#endif
