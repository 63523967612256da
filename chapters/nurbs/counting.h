/* counting.h -- a number type that has no value and knows what it cost.
 *
 * The kernels never look at a number, so they run on numbers that only count: `steps`, if it is not NULL, is a counter
 * that every operation on the number increases by one, and `tree` is the number of operations in the expression written out
 * in full, where a common part counts each time it occurs, or LONG_MAX where it is more.  The first is the time of a program that keeps what it has
 * computed, the second that of the plain recursion, which computes it again.
 * `roundings` is how many roundings there are at most on the way from a datum to the number: those of both factors of a
 * product or quotient, of the worse part of a sum, and that of the operation.  It bounds the relative error as long as
 * parts of one sign are added, and only data, which are exact, are subtracted; `cancels` is set where a computed
 * number is.  G is not defined afterwards. */
#ifndef CAGD_NURBS_COUNTING_H
#define CAGD_NURBS_COUNTING_H

#include "core/number/binomial.h"

#include <limits.h>
#include <stddef.h>

typedef struct num_n {
    long *steps;
    long tree;
    int roundings, cancels;
} num_n;

/* a + b + 1, or LONG_MAX where it is more. */
static inline long tree_of(long a, long b) { return a < LONG_MAX - b ? a + b + 1 : LONG_MAX; }

static inline num_n counted(num_n a, num_n b, int roundings)
{
    long *steps = a.steps != NULL ? a.steps : b.steps;
    if (steps != NULL)
        ++*steps;
    return (num_n){steps, tree_of(a.tree, b.tree), roundings + 1, a.cancels || b.cancels};
}
static inline num_n from_int_n(long m)
{
    (void)m;
    return (num_n){.steps = NULL};
}
static inline num_n from_ratio_n(long m, long n)
{
    (void)m, (void)n;
    return (num_n){.steps = NULL};
}
static inline num_n add_n(num_n a, num_n b)
{
    return counted(a, b, a.roundings > b.roundings ? a.roundings : b.roundings);
}
static inline num_n sub_n(num_n a, num_n b)
{
    num_n difference = add_n(a, b);
    difference.cancels |= a.roundings > 0 || b.roundings > 0;
    return difference;
}
static inline num_n mul_n(num_n a, num_n b) { return counted(a, b, a.roundings + b.roundings); }
static inline num_n div_n(num_n a, num_n b) { return counted(a, b, a.roundings + b.roundings); }
static inline num_n neg_n(num_n a) { return counted(a, from_int_n(0), a.roundings - 1); }
static inline num_n root_n(int n, num_n a)
{
    (void)n;
    return counted(a, from_int_n(0), a.roundings);
}

#undef G
#define G(name) name##_n
#include "core/kernels/spline_type.tmpl.h"

#include "core/kernels/net_type.tmpl.h"
#include "core/kernels/span_type.tmpl.h"

#include "core/kernels/kernels.tmpl.h"
#undef G

enum { counted_points = 18, counted_knots = 2 * counted_points, counted_coordinates = 3 };

/* One way to compute: the operations, and the number that comes out with the most roundings. */
struct counted_way {
    long cost;
    num_n worst;
};

static inline void count_result(struct counted_way *way, num_n a)
{
    int cancels = way->worst.cancels || a.cancels;
    if (a.roundings >= way->worst.roundings)
        way->worst = a;
    way->worst.cancels = cancels;
}

/* What one point of degree p < counted_points and dim <= counted_coordinates coordinates takes: way[0] by de Boor's algorithm on
 * homogeneous points, way[1] by the rational one, way[2] one insertion of a knot by the latter; *tree, the dim+1 coordinates of
 * the first written out in full. */
static inline void counted_ways(int p, int dim, struct counted_way way[3], long *tree)
{
    enum { most = counted_coordinates + 1 };
    num_n u[counted_knots], v[counted_knots + 1], R[most * counted_points], w[counted_points], P[most];
    num_n S[counted_coordinates * (counted_points + 1)], z[counted_points + 1];
    for (int k = 0; k < 3; k++) {
        way[k] = (struct counted_way){.cost = 0};
        num_n fresh = {.steps = &way[k].cost};
        for (int i = 0; i < 2 * p + 2; i++)
            u[i] = fresh;
        for (int i = 0; i < (dim + 1) * (p + 1); i++)
            R[i] = fresh;
        for (int i = 0; i <= p; i++)
            w[i] = fresh;
        if (k == 0)
            bspline_deboor_n(on_span_n(p, dim + 1, u, p, R), fresh, P);
        else if (k == 1)
            nurbs_deboor_n(nurbs_on_span_n(p, dim, u, p, R, w), fresh, P);
        else
            nurbs_insert_n(&(struct spline_n){p, p + 1, dim, u, R, w}, p, fresh, v, S, z);
        for (int c = 0; k < 2 && c < dim + 1 - k; c++)
            count_result(&way[k], P[c]);
        for (int i = 0; k == 2 && i < dim * (p + 2); i++)
            count_result(&way[k], S[i]);
        for (int i = 0; k == 2 && i < p + 2; i++)
            count_result(&way[k], z[i]);
        *tree = k == 0 ? 0 : *tree;
        for (int c = 0; k == 0 && c <= dim; c++)
            *tree += P[c].tree;
    }
}

/* The operations that the coefficient matrix of degree p < counted_points takes: by the recursion, by Marsden's identity, and by
 * divided differences over simple knots and over those of Bézier. */
static inline void counted_matrices(int p, long cost[4])
{
    num_n u[counted_knots], A[counted_points * counted_points];
    int group[counted_knots];
    for (int way = 0; way < 4; way++) {
        cost[way] = 0;
        for (int i = 0; i < 2 * p + 2; i++) {
            u[i] = (num_n){.steps = &cost[way]};
            group[i] = way == 2 ? i : i > p;
        }
        if (way == 0)
            bspline_matrix_n(p, u, p, A);
        else if (way == 1)
            bspline_matrix_by_marsden_n(p, u, p, A);
        else
            bspline_matrix_by_differences_n(p, u, group, p, A);
    }
}

/* The operations of these three ways alone. */
static inline void counted_work(int p, int dim, long cost[3], long *tree)
{
    struct counted_way way[3];
    counted_ways(p, dim, way, tree);
    for (int k = 0; k < 3; k++)
        cost[k] = way[k].cost;
}
#endif
