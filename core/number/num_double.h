/* num_double.h -- the number type d: IEEE binary64, one rounding per operation.
 * Built with -ffp-contract=off, so that "one rounding per operation" stays true. */
#ifndef CAGD_NUM_DOUBLE_H
#define CAGD_NUM_DOUBLE_H

#include <math.h>

typedef double num_d;

static inline num_d add_d(num_d a, num_d b) { return a + b; }
static inline num_d sub_d(num_d a, num_d b) { return a - b; }
static inline num_d mul_d(num_d a, num_d b) { return a * b; }
static inline num_d div_d(num_d a, num_d b) { return a / b; }
static inline num_d neg_d(num_d a) { return -a; }
static inline num_d from_int_d(long m) { return (double)m; }
static inline num_d from_ratio_d(long m, long n) { return (double)m / (double)n; }

/* a^(1/n), a >= 0.  The square root is correctly rounded; the others are as good as pow. */
static inline num_d root_d(int n, num_d a) { return n == 1 ? a : n == 2 ? sqrt(a) : pow(a, 1.0 / n); }
#endif
