/* number.h -- the order of rationals, and what is asked of rational functions, with testimony.
 *
 * Two families of predicates, told apart by their names.  cagd_compare_q and the like answer, and record nothing.  Those that
 * testify, cagd_testify_compare_q, give the same answer, and where a trace is open (trace.h) they note it as a fact for
 * others to check.  In the chapters the short words mean the latter: what a claim asks, it testifies.
 * So it is with the other headers of this folder: each has the questions of a header of exact/decide or exact/number.  */
#ifndef CAGD_RECORD_NUMBER_H
#define CAGD_RECORD_NUMBER_H

#include "exact/number/field.h"
#include "exact/number/rational.h"

int cagd_testify_sign_q(cagd_num_q a);
int cagd_testify_compare_q(cagd_num_q a, cagd_num_q b);
int cagd_testify_equal_q(cagd_num_q a, cagd_num_q b);
int cagd_testify_is_zero_q(cagd_num_q a);
int cagd_testify_is_whole_q(cagd_num_q a);
int cagd_testify_is_zero_f(cagd_num_f a);
int cagd_testify_has_degrees_f(cagd_num_f a, cagd_num_f variable, int numerator, int denominator);

/* The program of these numbers takes so many operations from its inputs, and no divisions: to be counted there by others. */
void cagd_testify_operations(int count, const cagd_num_q out[], int additions, int multiplications, int shifts);

#define sign_q        cagd_testify_sign_q
#define compare_q     cagd_testify_compare_q
#define equal_q       cagd_testify_equal_q
#define is_zero_q     cagd_testify_is_zero_q
#define is_whole_q    cagd_testify_is_whole_q
#define is_zero_f     cagd_testify_is_zero_f
#define has_degrees_f cagd_testify_has_degrees_f
#endif
