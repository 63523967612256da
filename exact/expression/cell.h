/* cell.h -- what is known of names without values together, and which signs a value can have there.
 *
 * A cell is the set of all values for which some linear forms are positive, or not negative, the names being within their bounds:
 * u_0 < u_1, u_1 <= t.  Equalities are solved: one name becomes a function of the others.  Whether such a set is empty, and
 * so which signs another form takes in it, is decided exactly (decide/simplex.h).  Where a condition depends on the sign of a
 * form that can have several, the cell is cut there, into three; so all orders of names come up, one by one, that make a
 * difference. */
#ifndef CAGD_CELL_H
#define CAGD_CELL_H

#include "exact/expression/evaluate.h"

/* Makes form > 0 (strict), form >= 0, form = 0 known; the form is linear in variables of the field, otherwise nothing changes and the
 * answer is 0.  0 also where there is no room. */
int cagd_limit_cell(cagd_context *c, cagd_num_f form, int strict);
int cagd_solve_in_cell(cagd_context *c, cagd_num_f form);
/* The name becomes that function of the other variables; 0 where something that was known of it is lost. */
int cagd_becomes_in_cell(cagd_context *c, cagd_binding *b, cagd_num_f value);
/* Makes what the cut says known; its names get variables of the field if they have no values. */
int cagd_cut_cell(cagd_context *c, const cagd_cut *cut);
/* Whether there are no values at all; what is known at `c`. */
int cagd_cell_is_empty(cagd_context *c);

/* Whether a is a polynomial of degree 0 or 1 in the variables of the field. */
int cagd_is_linear(cagd_num_f a);
/* The signs of a linear form in the cell; of any value, which is computed where its divisors are not 0.  Where there are several, a name
 * to split, or a form to cut, is noted in the context unless one is there already. */
unsigned cagd_signs_of_form(cagd_context *c, cagd_num_f form);
unsigned cagd_signs(cagd_context *c, cagd_value d);
/* Whether it has a variable that is near a place, on one side of it; the value with the places for all such variables. */
int cagd_is_beside(const cagd_context *c, cagd_value d);
cagd_value cagd_at_places(const cagd_context *c, cagd_value d);
/* Whether the value can be 0: a divisor that can is noted as above, or as a pole that is left out. */
int cagd_divides(cagd_context *c, cagd_value d);

/* Whether some limit form >= 0 can only be an equality, as in a <= b, b <= a; it is noted as a cut. */
int cagd_has_equality(cagd_context *c);

/* A point of the cell: value[m] for the unknown binding m; 0 where it is empty. */
int cagd_point_of_cell(cagd_context *c, cagd_num_q value[]);
#endif
