/* rational.h -- the number type q: exact rationals (GMP).
 *
 * A cagd_num_q names an immutable value that lives until its region is dropped.  It is a struct, not a
 * bare pointer, so that a == b, a < b and a * b do not compile: text that slips out of the generic
 * vocabulary is caught here. */
#ifndef CAGD_NUM_RATIONAL_H
#define CAGD_NUM_RATIONAL_H

#include "exact/number/region.h"
#include "exact/record/trace.h"

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
cagd_num_q cagd_from_ratio_q(long m, long n); /* n != 0                                            */
cagd_num_q cagd_root_q(int n, cagd_num_q a);  /* exact; UNABLE unless a >= 0 is an n-th power      */

cagd_num_q cagd_from_mpq_q(mpq_srcptr x);
cagd_num_q cagd_from_double_q(double x);         /* the binary64 itself; UNDEFINED unless finite    */
cagd_num_q cagd_from_string_q(const char *text); /* "3", "-3/7", "0.1" (the decimal), "1e-3",
                                          "0x1.8p-3"; UNDEFINED when it is none of these  */

/* Order, for decisions; generic text never compares. */
static inline int cagd_sign_q(cagd_num_q a)
{
    int order = mpq_sgn(a.at);
    if (cagd_trace_noting())
        cagd_trace_order(a.at, NULL, order);
    return order;
}
static inline int cagd_compare_q(cagd_num_q a, cagd_num_q b)
{
    int order = mpq_cmp(a.at, b.at);
    if (cagd_trace_noting())
        cagd_trace_order(a.at, b.at, order);
    return order;
}
static inline int cagd_equal_q(cagd_num_q a, cagd_num_q b)
{
    int equal = mpq_equal(a.at, b.at);
    if (cagd_trace_noting())
        cagd_trace_equal(a.at, b.at, equal);
    return equal;
}
static inline int cagd_is_zero_q(cagd_num_q a)
{
    int zero = mpq_sgn(a.at) == 0;
    if (cagd_trace_noting())
        cagd_trace_equal(a.at, NULL, zero);
    return zero;
}
static inline int cagd_is_whole_q(cagd_num_q a)
{
    int whole = mpz_cmp_ui(mpq_denref(a.at), 1) == 0;
    if (cagd_trace_noting())
        cagd_trace_relation("whole", cagd_trace_number(a.at), -1, whole);
    return whole;
}

/* Puts the nodes of `count` numbers into the fact that is open (trace.h); they must have been named before it was. */
void cagd_trace_put_numbers(const char *field, int count, const cagd_num_q x[]);
void cagd_trace_name_numbers(int count, const cagd_num_q x[]);

double cagd_to_double_q(cagd_num_q a);      /* correctly rounded, ties to even                 */
const char *cagd_to_string_q(cagd_num_q a); /* "-3/7"; lives in the region                     */
#endif
