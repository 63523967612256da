/* num_measured.h -- the number type m: binary64 with a running error bound (误差随行界).
 *
 * The value of every operation is bit for bit that of the type d.  Beside it runs a bound e, in
 * units of u = 2^-53, on the distance from the exact result of the exact operands, and the number k
 * of roundings on the longest path.  With fl(x) = x(1 + d), |d| <= u:
 *
 *     a + b    e = e_a + e_b + |v|                    k = max(k_a, k_b) + 1
 *     a b      e = e_a |b| + e_b |a| + |v|, with |a| and |b| enlarged by their own errors
 *     a / b    e = (e_a + |v| e_b) / |b'| + |v|, |b'| = |b| - e_b u > 0
 *
 * The e are themselves computed in binary64, every operation on them positive; k counts more
 * roundings than they suffer, hence
 *
 *     |v - exact| <= e k' u / (k' (1 - k' u)) = e u / (1 - k' u),   k' = 4 k + 4,
 *
 * as long as no product or quotient underflows: below 2^-1022 a rounding is not relative.  This is
 * the form k u/(1 - k u) of Higham's gamma with the data's own magnitudes in e.  No tolerance is
 * chosen anywhere.  Source: higham-2002, 3.3. */
#ifndef CAGD_NUM_MEASURED_H
#define CAGD_NUM_MEASURED_H

#include "core/number/num_double.h"

typedef struct num_m {
    double v; /* what binary64 computes                                  */
    double e; /* running error in units of u; infinite when unbounded    */
    double k; /* roundings on the longest path                           */
} num_m;

static const double unit_roundoff = 0x1p-53;

/* A bound on |v - exact|, itself rounded upwards by the factor 1/(1 - k' u); infinite when there is none. */
static inline double error_bound_m(num_m a)
{
    double k = 4 * a.k + 4;
    double bound = a.e * unit_roundoff / (1 - k * unit_roundoff) * (1 + 4 * unit_roundoff);
    return bound >= 0 ? bound : HUGE_VAL; /* infinity times 0 on the way is no bound */
}
static inline double larger_k(num_m a, num_m b) { return (a.k > b.k ? a.k : b.k) + 1; }

/* |v| enlarged by the value's own error: no exact value is larger in size. */
static inline double size_m(num_m a) { return fabs(a.v) + error_bound_m(a); }

static inline num_m exact_m(double v) { return (num_m){v, 0, 0}; }

static inline num_m add_m(num_m a, num_m b)
{
    double v = a.v + b.v;
    return (num_m){v, a.e + b.e + fabs(v), larger_k(a, b)};
}
static inline num_m sub_m(num_m a, num_m b)
{
    double v = a.v - b.v;
    return (num_m){v, a.e + b.e + fabs(v), larger_k(a, b)};
}
static inline num_m mul_m(num_m a, num_m b)
{
    double v = a.v * b.v;
    return (num_m){v, a.e * size_m(b) + b.e * fabs(a.v) + fabs(v), larger_k(a, b)};
}
static inline num_m div_m(num_m a, num_m b)
{
    double v = a.v / b.v, smallest = fabs(b.v) - error_bound_m(b);
    double e = smallest > 0 ? (a.e + fabs(v) * b.e) / smallest + fabs(v) : HUGE_VAL;
    return (num_m){v, e, larger_k(a, b)};
}
static inline num_m neg_m(num_m a) { return (num_m){-a.v, a.e, a.k}; }
static inline num_m from_int_m(long m)
{
    double v = (double)m; /* one rounding, if the integer is beyond 2^53 */
    return (num_m){v, fabs(v) >= 0x1p53 ? fabs(v) : 0, 1};
}
static inline num_m from_ratio_m(long m, long n) { return div_m(from_int_m(m), from_int_m(n)); }

/* Square roots only: |sqrt(a) - sqrt(x)| <= |a - x| / sqrt(a) for x >= 0.  Other roots are unbounded. */
static inline num_m root_m(int n, num_m a)
{
    double v = root_d(n, a.v), e = n == 1 ? a.e : n == 2 && v > 0 ? a.e / v + v : HUGE_VAL;
    return (num_m){v, e, a.k + 1};
}
#endif
