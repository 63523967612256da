/* rational.h -- the number type q: exact rationals (GMP).
 *
 * A cagd_num_q names an immutable value that lives until its region is dropped.  It is a struct, not a
 * bare pointer, so that a == b, a < b and a * b do not compile: text that slips out of the generic
 * vocabulary is caught here.  at is GMP's number, to be read only. */
#ifndef CAGD_NUM_RATIONAL_H
#define CAGD_NUM_RATIONAL_H

#include "exact/number/region.h"

#include <gmp.h>

typedef struct cagd_num_q {
    mpq_srcptr at;
} cagd_num_q;

cagd_num_q cagd_add_q(cagd_num_q a, cagd_num_q b);
cagd_num_q cagd_sub_q(cagd_num_q a, cagd_num_q b);
cagd_num_q cagd_mul_q(cagd_num_q a, cagd_num_q b);
cagd_num_q cagd_div_q(cagd_num_q a, cagd_num_q b); /* UNDEFINED for b = 0                                    */
cagd_num_q cagd_neg_q(cagd_num_q a);
cagd_num_q cagd_from_int_q(long m);
cagd_num_q cagd_from_ratio_q(long m, long n); /* m/n; UNDEFINED for n = 0                           */
cagd_num_q cagd_root_q(int n, cagd_num_q a);  /* exact; UNABLE unless a >= 0 is an n-th power      */
cagd_num_q cagd_floor_q(cagd_num_q a);        /* the greatest integer that is not above a       */

cagd_num_q cagd_from_mpq_q(mpq_srcptr x);        /* a copy; x in lowest terms              */
cagd_num_q cagd_from_double_q(double x);         /* the binary64 itself; UNDEFINED unless finite    */
cagd_num_q cagd_from_string_q(const char *text); /* "3", "-3/7", "0.1" (the decimal), "1e-3",
                                                    "0x1.8p-3"; UNDEFINED when it is none of these,
                                                    or has 100 000 digits at one place or an
                                                    exponent beyond 99 999                        */

/* Order, for decisions; generic text never compares.  The signs of a and of a - b, a = b, a = 0, and whether a is an integer. */
static inline int cagd_sign_q(cagd_num_q a) { return mpq_sgn(a.at); }
static inline int cagd_compare_q(cagd_num_q a, cagd_num_q b) { return mpq_cmp(a.at, b.at); }
static inline int cagd_equal_q(cagd_num_q a, cagd_num_q b) { return mpq_equal(a.at, b.at) != 0; }
static inline int cagd_is_zero_q(cagd_num_q a) { return mpq_sgn(a.at) == 0; }
static inline int cagd_is_whole_q(cagd_num_q a) { return mpz_cmp_ui(mpq_denref(a.at), 1) == 0; }

double cagd_to_double_q(cagd_num_q a);      /* correctly rounded, ties to even                 */
const char *cagd_to_string_q(cagd_num_q a); /* "-3/7"; lives in the region                     */
#endif
