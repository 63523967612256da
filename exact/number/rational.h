/* rational.h -- the number type q: exact rationals (GMP).
 *
 * A num_q names an immutable value that lives until its region is dropped.  It is a struct, not a
 * bare pointer, so that a == b, a < b and a * b do not compile: text that slips out of the generic
 * vocabulary is caught here. */
#ifndef CAGD_NUM_RATIONAL_H
#define CAGD_NUM_RATIONAL_H

#include "exact/number/region.h"
#include "exact/record/trace.h"

#include <gmp.h>

typedef struct num_q {
    mpq_srcptr at;
} num_q;

num_q add_q(num_q a, num_q b);
num_q sub_q(num_q a, num_q b);
num_q mul_q(num_q a, num_q b);
num_q div_q(num_q a, num_q b); /* UNDEFINED for b = 0                                    */
num_q neg_q(num_q a);
num_q from_int_q(long m);
num_q from_ratio_q(long m, long n); /* n != 0                                            */
num_q root_q(int n, num_q a);       /* exact; UNABLE unless a >= 0 is an n-th power      */

num_q from_mpq_q(mpq_srcptr x);
num_q from_double_q(double x);         /* the binary64 itself; UNDEFINED unless finite    */
num_q from_string_q(const char *text); /* "3", "-3/7", "0.1" (the decimal), "1e-3",
                                          "0x1.8p-3"; UNDEFINED when it is none of these  */

/* Order, for decisions; generic text never compares. */
static inline int sign_q(num_q a)
{
    int order = mpq_sgn(a.at);
    if (trace_noting())
        trace_order(a.at, NULL, order);
    return order;
}
static inline int compare_q(num_q a, num_q b)
{
    int order = mpq_cmp(a.at, b.at);
    if (trace_noting())
        trace_order(a.at, b.at, order);
    return order;
}
static inline int equal_q(num_q a, num_q b)
{
    int equal = mpq_equal(a.at, b.at);
    if (trace_noting())
        trace_equal(a.at, b.at, equal);
    return equal;
}
static inline int is_zero_q(num_q a)
{
    int zero = mpq_sgn(a.at) == 0;
    if (trace_noting())
        trace_equal(a.at, NULL, zero);
    return zero;
}
static inline int is_whole_q(num_q a)
{
    int whole = mpz_cmp_ui(mpq_denref(a.at), 1) == 0;
    if (trace_noting())
        trace_relation("whole", trace_number(a.at), -1, whole);
    return whole;
}

/* Puts the nodes of `count` numbers into the fact that is open (trace.h); they must have been named before it was. */
void trace_put_numbers(const char *field, int count, const num_q x[]);
void trace_name_numbers(int count, const num_q x[]);

double to_double_q(num_q a);      /* correctly rounded, ties to even                 */
const char *to_string_q(num_q a); /* "-3/7"; lives in the region                     */
#endif
