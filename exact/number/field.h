/* field.h -- the number type f: rational functions over Q in named variables (FLINT).
 *
 * An equality of two elements is an equality of the functions for every value of the variables where
 * both sides are defined: a proof, not a sample.  The variables are introduced by name; there is
 * room for as many as field_open said, and one more raises CROWDED, upon which the runner starts
 * again in a larger field. */
#ifndef CAGD_NUM_FIELD_H
#define CAGD_NUM_FIELD_H

#include "exact/number/rational.h"

typedef struct num_f {
    const struct field_element *at;
} num_f;

enum { FIELD_MAX_VARIABLES = 96, FIELD_MAX_NAME = 15 };

/* Fix the field of this thread.  No element of an earlier field may be alive.  UNABLE when more than
 * FIELD_MAX_VARIABLES are asked for. */
void field_open(int variables);
void field_close(void);

const char *field_variables(void);  /* the names known, separated by blanks; in the region      */
num_f variable_f(const char *name); /* the variable of that name, new or known; UNABLE for a name of
                                       more than FIELD_MAX_NAME bytes                        */
num_f add_f(num_f a, num_f b);
num_f sub_f(num_f a, num_f b);
num_f mul_f(num_f a, num_f b);
num_f div_f(num_f a, num_f b); /* UNDEFINED when b is the zero function                    */
num_f neg_f(num_f a);
num_f from_int_f(long m);
num_f from_ratio_f(long m, long n);
num_f from_rational_f(num_q a);
num_f root_f(int n, num_f a); /* n >= 1; one of the two roots for even n; UNABLE unless a is
                                 an n-th power                                             */

int is_zero_f(num_f a);
int equal_f(num_f a, num_f b);                            /* the same function; not noted in a trace      */
int is_constant_f(num_f a, num_q *value);                 /* value may be NULL                        */
num_f derivative_f(num_f a, num_f variable);              /* formal partial derivative                */
num_f substitute_f(num_f a, num_f variable, num_f value); /* UNDEFINED at a pole           */
int degree_f(num_f a, num_f variable);                    /* of the numerator; -1 for 0; these four are
                                                  UNDEFINED unless it is a variable        */
int denominator_degree_f(num_f a, num_f variable);
int has_degrees_f(num_f a, num_f variable, int numerator, int denominator); /* both; noted as a fact (trace.h) */
num_f coefficient_f(num_f a, num_f variable, int k); /* of variable^k, k >= 0, as it is a polynomial
                                                  in it: UNDEFINED if the denominator has it  */
int field_variable_f(num_f variable);                /* its index, or -1 for any other element   */
/* +1, 0, -1: numerator and denominator have coefficients of one sign each, so a > 0, a = 0, a < 0
 * wherever all variables are positive.  -2: no such conclusion. */
int coefficients_sign_f(num_f a);
const char *to_string_f(num_f a); /* lives in the region                      */
int trace_field_element(num_f a); /* its node in the open trace (trace.h), made if there is none */
#endif
