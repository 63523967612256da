/* counting.h -- a number type that counts: what a kernel costs is read off by running it.
 *
 * A number carries only a class: whether it is a power of two known in advance, such as the step of a difference
 * table.  A product with such a number, or a quotient by it, is a shift, any other a multiplication or a division.  The
 * counts are of the thread that runs the kernel. */
#ifndef CAGD_COUNTING_H
#define CAGD_COUNTING_H

#include "core/number/limits.h"
#include "exact/record/number.h"
#include "exact/words.h"

typedef struct num_c {
    int is_power_of_two;
} num_c;

struct operations {
    int additions, multiplications, divisions, shifts;
};
static _Thread_local struct operations counted;

static inline num_c add_c(num_c a, num_c b)
{
    (void)a, (void)b;
    counted.additions++;
    return (num_c){0};
}
static inline num_c sub_c(num_c a, num_c b) { return add_c(a, b); }
static inline num_c neg_c(num_c a) { return a; } /* costs nothing */
static inline num_c mul_c(num_c a, num_c b)
{
    *(a.is_power_of_two || b.is_power_of_two ? &counted.shifts : &counted.multiplications) += 1;
    return (num_c){a.is_power_of_two && b.is_power_of_two};
}
static inline num_c div_c(num_c a, num_c b)
{
    *(b.is_power_of_two ? &counted.shifts : &counted.divisions) += 1;
    return (num_c){a.is_power_of_two && b.is_power_of_two};
}
static inline num_c from_int_c(long m) { return (num_c){m > 0 && (m & (m - 1)) == 0}; }
static inline num_c from_ratio_c(long m, long n)
{
    return (num_c){from_int_c(m).is_power_of_two && from_int_c(n).is_power_of_two};
}

/* Notes for others that the program of these numbers, from its inputs, takes so many operations: counted for the same kernel
 * in the type that counts, to be counted by them in the program.  It has no divisions. */
static inline void note_cost(int count, const num_q out[], struct operations cost)
{
    cagd_testify_operations(count, out, cost.additions, cost.multiplications, cost.shifts);
}
#endif
