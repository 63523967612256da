/* field.h -- the number type f: rational functions over Q in named variables (FLINT).
 *
 * An equality of two elements is an equality of the functions for every value of the variables where
 * both sides are defined: a proof, not a sample.  The variables are introduced by name; there is
 * room for as many as cagd_field_open said, and one more raises CROWDED, upon which one starts
 * again in a larger field. */
#ifndef CAGD_NUM_FIELD_H
#define CAGD_NUM_FIELD_H

#include "exact/number/rational.h"

typedef struct cagd_num_f {
    const struct cagd_field_element *at;
} cagd_num_f;

enum { CAGD_FIELD_MAX_VARIABLES = 96, CAGD_FIELD_MAX_NAME = 15 };

/* Fix the field of this thread.  No element of an earlier field may be alive.  UNABLE when more than
 * CAGD_FIELD_MAX_VARIABLES are asked for, and then there is room for so many; for less than 1 there is room for 1. */
void cagd_field_open(int variables);
void cagd_field_close(void);

/* The names known, separated by blanks; in the region. */
const char *cagd_field_variables(void);

/* The variable of that name, new or known.  CROWDED, unless a fault stands already; UNABLE for a name of more than CAGD_FIELD_MAX_NAME bytes. */
cagd_num_f cagd_variable_f(const char *name);

cagd_num_f cagd_add_f(cagd_num_f a, cagd_num_f b);
cagd_num_f cagd_sub_f(cagd_num_f a, cagd_num_f b);
cagd_num_f cagd_mul_f(cagd_num_f a, cagd_num_f b);
cagd_num_f cagd_div_f(cagd_num_f a, cagd_num_f b); /* UNDEFINED when b is the zero function                    */
cagd_num_f cagd_neg_f(cagd_num_f a);
cagd_num_f cagd_from_int_f(long m);
cagd_num_f cagd_from_ratio_f(long m, long n); /* m/n; UNDEFINED for n = 0                                      */
cagd_num_f cagd_from_rational_f(cagd_num_q a);
cagd_num_f cagd_root_f(int n, cagd_num_f a); /* n >= 1; one of the two roots for even n; UNABLE unless a is an
                                                n-th power                                                     */

int cagd_is_zero_f(cagd_num_f a);
int cagd_equal_f(cagd_num_f a, cagd_num_f b);            /* the same function                                  */
int cagd_is_constant_f(cagd_num_f a, cagd_num_q *value); /* value, which may be NULL, is written if it is        */

/* Of a variable of the field; when `variable` is none, they are UNDEFINED. */
cagd_num_f cagd_derivative_f(cagd_num_f a, cagd_num_f variable);                   /* formal, partial          */
cagd_num_f cagd_substitute_f(cagd_num_f a, cagd_num_f variable, cagd_num_f value); /* UNDEFINED at a pole      */
cagd_num_f cagd_coefficient_f(cagd_num_f a, cagd_num_f variable, int k);           /* of variable^k, a being a
                                                     polynomial in it: UNDEFINED if the denominator has it     */
int cagd_degree_f(cagd_num_f a, cagd_num_f variable);                              /* of the numerator; -1 for 0 */
int cagd_denominator_degree_f(cagd_num_f a, cagd_num_f variable);
int cagd_has_degrees_f(cagd_num_f a, cagd_num_f variable, int numerator, int denominator); /* are these both?  */

int cagd_field_variable_f(cagd_num_f variable); /* its index, or -1 for any other element                      */

/* a = constant + sum coefficient[k] x_variable[k], x_v being the variable of index v; no coefficient is 0.  0 where a is no such form;
 * the arrays live in the region. */
struct cagd_linear {
    int count;
    const int *variable;
    const cagd_num_q *coefficient;
    cagd_num_q constant;
};
int cagd_linear_f(cagd_num_f a, struct cagd_linear *out);

/* +1, 0, -1: numerator and denominator have coefficients of one sign each, so a > 0, a = 0, a < 0
 * wherever all variables are positive.  -2: no such conclusion. */
int cagd_coefficients_sign_f(cagd_num_f a);

/* Numerator and denominator in lowest terms, as polynomials. */
cagd_num_f cagd_numerator_f(cagd_num_f a);
cagd_num_f cagd_denominator_f(cagd_num_f a);

/* How many words the coefficients of numerator and denominator take, about: what is large takes long to multiply. */
long cagd_words_f(cagd_num_f a);

/* The factors of the numerator that contain the variable, irreducible over the rationals, with their powers; their number,
 * at most room, or -1 when there are more, or with UNABLE where that is no variable or they were not found.  The rest is a factor
 * without the variable. */
int cagd_factors_f(cagd_num_f a, cagd_num_f variable, int room, cagd_num_f factor[], int power[]);

const char *cagd_to_string_f(cagd_num_f a); /* "(a + b)/c"; in the region                                      */
#endif
