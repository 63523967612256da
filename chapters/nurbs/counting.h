/* counting.h -- a number type that has no value and knows what it cost.
 *
 * The kernels never look at a number, so they run on numbers that only count: `steps`, if it is not NULL, is a counter
 * that every operation on the number increases by one, and `tree` is the number of operations in the expression written out
 * in full, where a common part counts each time it occurs.  The first is the time of a program that keeps what it has
 * computed, the second that of the plain recursion, which computes it again. */
#ifndef CAGD_NURBS_COUNTING_H
#define CAGD_NURBS_COUNTING_H

#include "core/number/binomial.h"

typedef struct num_n {
    long *steps;
    long tree;
} num_n;

static inline num_n counted(num_n a, num_n b)
{
    long *steps = a.steps != NULL ? a.steps : b.steps;
    if (steps != NULL)
        ++*steps;
    return (num_n){steps, a.tree + b.tree + 1};
}
static inline num_n from_int_n(long m)
{
    (void)m;
    return (num_n){NULL, 0};
}
static inline num_n from_ratio_n(long m, long n)
{
    (void)m, (void)n;
    return (num_n){NULL, 0};
}
static inline num_n add_n(num_n a, num_n b) { return counted(a, b); }
static inline num_n sub_n(num_n a, num_n b) { return counted(a, b); }
static inline num_n mul_n(num_n a, num_n b) { return counted(a, b); }
static inline num_n div_n(num_n a, num_n b) { return counted(a, b); }
static inline num_n neg_n(num_n a) { return counted(a, from_int_n(0)); }
static inline num_n root_n(int n, num_n a)
{
    (void)n;
    return counted(a, from_int_n(0));
}
#endif
