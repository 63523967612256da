/* crossings.h -- what the two sections on the crossings of a line share: patterns of signs, families of weights, the polygon
 * over 0, 1, ..., n with given heights, and changes of sign.  For rationals. */
#ifndef CAGD_RATIONAL_BEZIER_CROSSINGS_H
#define CAGD_RATIONAL_BEZIER_CROSSINGS_H

#if RATIONAL
#include "exact/record/crossings.h"
#include "exact/record/roots.h"
#include "exact/record/sturm.h"

/* The pattern of signs number `code`, 0 <= code < 3^count. */
static inline void sign_pattern_of(int code, int count, int sign[])
{
    for (int i = 0; i < count; i++, code /= 3)
        sign[i] = code % 3 - 1;
}
/* 3^count */
static inline int patterns(int count) { return count == 0 ? 1 : 3 * patterns(count - 1); }

/* The weight of number i, 0 <= i <= n <= 9, in the families: all 1; 1000 and 1 in turn; 10^i; 1 at the ends and 1/1000 inside. */
enum { FAMILIES = 4 };
static inline num_q designed_weight(int family, int n, int i)
{
    long power = 1;
    for (int k = 0; k < i; k++)
        power *= 10;
    num_q weight[FAMILIES] = {from_int_q(1), from_int_q(i % 2 == 0 ? 1000 : 1), from_int_q(power),
                              from_ratio_q(1, i == 0 || i == n ? 1 : 1000)};
    return weight[family];
}

/* The polygon with vertices (i, y_i). */
static inline void graph(int n, const num_q y[], num_q R[])
{
    for (int i = 0; i <= n; i++) {
        R[2 * i] = from_int_q(i);
        R[2 * i + 1] = y[i];
    }
}
/* The same with the heights -1, 0, 1. */
static inline void graph_of_signs(int n, const int sign[], num_q R[])
{
    num_q y[MAX_DEGREE + 1];
    for (int i = 0; i <= n; i++)
        y[i] = from_int_q(sign[i]);
    graph(n, y, R);
}
/* The line y = 0. */
static inline struct cagd_line horizontal_axis(void)
{
    return (struct cagd_line){from_int_q(0), from_int_q(1), from_int_q(0)};
}

/* sign[i] = -1, 0, 1 as y_i < 0, = 0, > 0. */
static inline void signs_of(int count, const num_q y[], int sign[])
{
    for (int i = 0; i < count; i++)
        sign[i] = sign_q(y[i]);
}

/* Changes of sign in a sequence of signs, zeros left out. */
static inline int sign_changes(int count, const int sign[])
{
    int changes = 0, last = 0;
    for (int i = 0; i < count; i++) {
        changes += sign[i] * last < 0;
        last = sign[i] != 0 ? sign[i] : last;
    }
    return changes;
}
#endif
#endif
