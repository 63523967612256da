/* counting.h -- a number type that has no value and knows what it cost.
 *
 * The kernels never look at a number, so they run on numbers that only count: `steps`, if it is not NULL, is a counter
 * that every operation on the number increases by one, and `tree` is the number of operations in the expression written out
 * in full, where a common part counts each time it occurs.  The first is the time of a program that keeps what it has
 * computed, the second that of the plain recursion, which computes it again.  G is not defined afterwards. */
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

#undef G
#define G(name) name##_n
#include "core/kernels.tmpl.h"
#undef G

enum { counted_points = 18, counted_knots = 2 * counted_points };

/* What one point of degree p < counted_points costs in the plane: cost[0] by de Boor's algorithm on homogeneous points,
 * cost[1] by the rational one, cost[2] one insertion of a knot by the latter; *tree, the three coordinates of the first written out
 * in full. */
static inline void counted_work(int p, long cost[3], long *tree)
{
    num_n u[counted_knots], v[counted_knots + 1], R[3 * counted_points], w[counted_points], P[3];
    num_n S[2 * counted_points + 2], z[counted_points + 1];
    for (int way = 0; way < 3; way++) {
        num_n fresh = {&cost[way], 0};
        cost[way] = 0;
        for (int i = 0; i < 2 * p + 2; i++)
            u[i] = fresh;
        for (int i = 0; i < 3 * (p + 1); i++)
            R[i] = fresh;
        for (int i = 0; i <= p; i++)
            w[i] = fresh;
        if (way == 0)
            deboor_n(p, 3, u, p, R, fresh, P);
        else if (way == 1)
            nurbs_deboor_n(p, 2, u, p, R, w, fresh, P);
        else
            nurbs_insert_n(p + 1, p, 2, u, p, R, w, fresh, v, S, z);
        if (way == 0)
            *tree = P[0].tree + P[1].tree + P[2].tree;
    }
}
#endif
