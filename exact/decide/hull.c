#include "exact/decide/hull.h"

#include "exact/decide/simplex.h"
#include "exact/decide/with.h"
#include "exact/words.h"

#include <limits.h>
#include <stddef.h>
#include <stdlib.h>

static num_q dot(int d, const num_q u[], const num_q v[])
{
    num_q sum = from_int_q(0);
    for (int i = 0; i < d; i++)
        sum = add_q(sum, mul_q(u[i], v[i]));
    return sum;
}

int cagd_hull_certificate_holds_with(const struct cagd_order *order, int d, int count, const num_q points[],
                                     const num_q x[], struct cagd_hull_certificate c)
{
    int good = 1;
    if (!c.inside) {
        for (int j = 0; j < count; j++)
            good &= order->compare(dot(d, c.normal, points + d * j), c.offset) <= 0;
        return good && order->compare(c.offset, dot(d, c.normal, x)) < 0;
    }
    for (int i = -1; i < d; i++) { /* i = -1 stands for the coordinate 1 of every point */
        num_q sum = from_int_q(0);
        for (int j = 0; j < count; j++) {
            sum = add_q(sum, i < 0 ? c.coefficient[j] : mul_q(c.coefficient[j], points[d * j + i]));
            good &= order->sign(c.coefficient[j]) >= 0;
        }
        good &= order->equal(sum, i < 0 ? from_int_q(1) : x[i]);
    }
    return good;
}
static int compare(num_q a, num_q b) { return cagd_compare_q(a, b); }
static int sign(num_q a) { return cagd_sign_q(a); }
static int equal(num_q a, num_q b) { return cagd_equal_q(a, b); }
static const struct cagd_order plain = {compare, sign, equal};
int cagd_hull_certificate_holds(int d, int count, const num_q points[], const num_q x[], struct cagd_hull_certificate c)
{
    return cagd_hull_certificate_holds_with(&plain, d, count, points, x, c);
}

/* x = sum lambda_j P_j with lambda >= 0 and sum lambda_j = 1 is a linear system.  Where it has no solution, y = (n, m) with
 * n . P_j + m <= 0 for all j and n . x + m > 0 is a separating hyperplane. */
struct cagd_hull_certificate cagd_hull_membership(int d, int count, const num_q points[], const num_q x[])
{
    struct cagd_hull_certificate c = {.offset = from_int_q(0)};
    if (d > INT_MAX - 2 || count > INT_MAX - 2 - d) {
        region_faults |= FAULT_MEMORY;
        return c;
    }
    num_q *A = cagd_region_array(d + 1, count, sizeof *A), *b = cagd_region_array(d + 1, 1, sizeof *b);
    if (A == NULL || b == NULL)
        return c;
    for (int i = 0; i <= d; i++) {
        b[i] = i < d ? x[i] : from_int_q(1);
        for (int j = 0; j < count; j++)
            A[(ptrdiff_t)i * count + j] = i < d ? points[d * j + i] : from_int_q(1);
    }
    struct cagd_simplex s = cagd_simplex(d + 1, count, A, b);
    if (s.x == NULL && s.y == NULL)
        return c;
    c.inside = s.solvable, c.coefficient = s.x, c.normal = s.y;
    if (!c.inside)
        c.offset = neg_q(s.y[d]);
    if (!cagd_hull_certificate_holds(d, count, points, x, c))
        region_faults |= FAULT_UNABLE;
    return c;
}

struct vector {
    num_q x, y;
};
static struct vector from_to(const num_q P[2], const num_q Q[2])
{
    return (struct vector){sub_q(Q[0], P[0]), sub_q(Q[1], P[1])};
}
static int cross_sign_with(const struct cagd_order *order, struct vector u, struct vector v)
{
    return order->compare(mul_q(u.x, v.y), mul_q(u.y, v.x));
}
static int cross_sign(struct vector u, struct vector v) { return cross_sign_with(&plain, u, v); }
static int dot_sign(struct vector u, struct vector v) { return cagd_sign_q(add_q(mul_q(u.x, v.x), mul_q(u.y, v.y))); }
static int is_zero(struct vector u) { return cagd_is_zero_q(u.x) && cagd_is_zero_q(u.y); }

int cagd_turn_2d_with(const struct cagd_order *order, const num_q P[2], const num_q Q[2], const num_q R[2])
{
    region_mark m = region_open();
    int s = cross_sign_with(order, from_to(P, Q), from_to(P, R));
    region_drop(m);
    return s;
}
int cagd_turn_2d(const num_q P[2], const num_q Q[2], const num_q R[2]) { return cagd_turn_2d_with(&plain, P, Q, R); }

/* Angles in [0, pi) are above, in [pi, 2 pi) below. */
static int is_below(struct vector u) { return cagd_sign_q(u.y) < 0 || (cagd_is_zero_q(u.y) && cagd_sign_q(u.x) < 0); }

/* The nonzero edges, the closing one included. */
static int edges_of(int n, const num_q R[], struct vector edge[])
{
    int count = 0;
    for (int i = 0; i <= n; i++) {
        edge[count] = from_to(R + 2 * i, R + 2 * (i < n ? i + 1 : 0));
        count += !is_zero(edge[count]);
    }
    return count;
}

/* A closed polygon is convex when it always turns to the same side, and once round in all: the
 * direction leaves the lower half of the angles once.  A half turn needs no test: one more half turn
 * would have to lead back to the start, and can do so only on one line. */
static int closed_orientation(int count, const struct vector edge[])
{
    int side = 0, rounds = 0;
    for (int i = 0; i < count; i++) {
        struct vector u = edge[i], v = edge[(i + 1) % count];
        int s = cross_sign(u, v);
        if (s * side < 0)
            return 0;
        side = s != 0 ? s : side;
        rounds += is_below(u) && !is_below(v);
    }
    return rounds == 1 ? side : 0;
}

static int goes_straight_on(int n, const num_q R[])
{
    struct vector first = {0};
    int started = 0, straight = 1;
    for (int i = 0; i < n; i++) {
        struct vector u = from_to(R + 2 * i, R + 2 * i + 2);
        if (!is_zero(u)) {
            straight &= !started || (cross_sign(first, u) == 0 && dot_sign(first, u) > 0);
            first = started ? first : u;
            started = 1;
        }
    }
    return straight;
}

int cagd_polygon_is_convex(int n, const num_q points[], int closed, int *orientation)
{
    region_mark m = region_open();
    struct vector *edge = cagd_region_array(1, n + 1L, sizeof *edge);
    if (edge == NULL)
        return 0;
    int count = edges_of(n, points, edge);
    int side = closed_orientation(count, edge);
    int convex = side != 0 || count == 0 || (!closed && goes_straight_on(n, points));
    region_drop(m);
    if (orientation != NULL)
        *orientation = side;
    return convex;
}

struct site {
    const num_q *at;
    int index;
};
static int lexicographic(const void *p, const void *q)
{
    const num_q *P = ((const struct site *)p)->at, *Q = ((const struct site *)q)->at;
    int s = cagd_compare_q(P[0], Q[0]);
    return s != 0 ? s : cagd_compare_q(P[1], Q[1]);
}

/* Lower chain from left to right, then the upper one back; a point that makes no left turn goes. */
int cagd_convex_hull_2d(int count, const num_q points[], int vertex[])
{
    region_mark m = region_open();
    struct site *site = cagd_region_array(1, count, sizeof *site);
    if (site == NULL || count < 1)
        return 0;
    for (int j = 0; j < count; j++)
        site[j] = (struct site){points + 2 * j, j};
    qsort(site, (size_t)count, sizeof *site, lexicographic);
    int size = 0, ways = lexicographic(&site[0], &site[count - 1]) == 0 ? 0 : 2;
    for (int way = 0; way < ways; way++) {
        int base = size; /* a chain begins with its first point and never loses it */
        for (int j = 0; j < count; j++) {
            struct site next = site[way == 0 ? j : count - 1 - j];
            while (size >= base + 2 &&
                   cagd_turn_2d(points + 2 * vertex[size - 2], points + 2 * vertex[size - 1], next.at) <= 0)
                size--;
            vertex[size++] = next.index;
        }
        size--; /* its last point is the first one of the other chain */
    }
    if (ways == 0) /* all points are the same */
        vertex[size++] = site[0].index;
    region_drop(m);
    return size;
}
