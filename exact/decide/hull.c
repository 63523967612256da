#include "exact/decide/hull.h"

#include "exact/decide/with.h"
#include "exact/words.h"

#include <limits.h>
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

/* Phase one: minimise a_0 + ... + a_d subject to
 *
 *     sum_j lambda_j P_ji + a_i = x_i (i < d),   sum_j lambda_j + a_d = 1,   lambda, a >= 0,
 *
 * every equation multiplied by sigma_i = +-1 so that its right side is >= 0.  Row i of the tableau is
 * equation i solved for the basic variable of that row; the last row is the reduced costs and minus
 * the objective.  Columns: lambda_j, a_i, right side. */
struct tableau {
    int rows, columns; /* d + 1 and count + d + 2 */
    num_q *at;         /* (rows + 1) x columns    */
    int *basic;
};

static num_q *row(struct tableau t, int i) { return t.at + (ptrdiff_t)i * t.columns; }

static struct tableau first_tableau(int d, int count, const num_q points[], const num_q x[])
{
    if (d > INT_MAX - 2 || count > INT_MAX - 2 - d) {
        region_faults |= FAULT_MEMORY;
        return (struct tableau){0};
    }
    struct tableau t = {.rows = d + 1, .columns = count + d + 2};
    t.at = cagd_region_array(t.rows + 1, t.columns, sizeof(num_q));
    t.basic = cagd_region_array(1, t.rows, sizeof(int));
    if (t.at == NULL || t.basic == NULL)
        return (struct tableau){0};
    num_q zero = from_int_q(0), one = from_int_q(1), *costs = row(t, t.rows);
    for (int k = 0; k < t.columns; k++)
        costs[k] = zero;
    for (int i = 0; i <= d; i++) {
        num_q right = i < d ? x[i] : one, *r = row(t, i);
        int minus = cagd_sign_q(right) < 0;
        for (int j = 0; j < count; j++) {
            num_q p = i < d ? points[d * j + i] : one;
            r[j] = minus ? neg_q(p) : p;
        }
        for (int k = 0; k <= d; k++)
            r[count + k] = k == i ? one : zero;
        r[t.columns - 1] = minus ? neg_q(right) : right;
        t.basic[i] = count + i;
        for (int k = 0; k < t.columns; k++)
            if (k < count || k == t.columns - 1)
                costs[k] = sub_q(costs[k], r[k]);
    }
    return t;
}

/* The column enters the basis, the row's variable leaves it. */
static void pivot(struct tableau t, int r, int column)
{
    num_q *p = row(t, r), inverse = div_q(from_int_q(1), p[column]);
    for (int k = 0; k < t.columns; k++)
        p[k] = mul_q(p[k], inverse);
    for (int i = 0; i <= t.rows; i++) {
        num_q *q = row(t, i), factor = q[column];
        if (i != r && !cagd_is_zero_q(factor))
            for (int k = 0; k < t.columns; k++)
                if (!cagd_is_zero_q(p[k]))
                    q[k] = sub_q(q[k], mul_q(factor, p[k]));
    }
    t.basic[r] = column;
}

/* Bland's rule: the first column that lowers the objective enters; of the rows with the least ratio
 * the one with the first variable leaves.  So no basis comes twice. */
static void minimise(struct tableau t, int count)
{
    const num_q *costs = row(t, t.rows);
    for (;;) {
        int column = 0, leaving = -1;
        while (column < count && cagd_sign_q(costs[column]) >= 0)
            column++;
        if (column == count)
            return;
        num_q least = {0};
        for (int i = 0; i < t.rows; i++) {
            if (cagd_sign_q(row(t, i)[column]) <= 0)
                continue;
            num_q ratio = div_q(row(t, i)[t.columns - 1], row(t, i)[column]);
            int order = leaving < 0 ? -1 : cagd_compare_q(ratio, least);
            if (order < 0 || (order == 0 && t.basic[i] < t.basic[leaving])) {
                leaving = i;
                least = ratio;
            }
        }
        pivot(t, leaving, column); /* there is one: the objective is bounded by 0 */
    }
}

/* At the minimum, y_i = 1 - (reduced cost of a_i) has sigma y . (P_j, 1) <= 0 for all j, and
 * sigma y . (x, 1) is the minimum: if that is positive, a separating hyperplane. */
struct cagd_hull_certificate cagd_hull_membership(int d, int count, const num_q points[], const num_q x[])
{
    struct tableau t = first_tableau(d, count, points, x);
    if (t.at == NULL)
        return (struct cagd_hull_certificate){.offset = from_int_q(0)};
    minimise(t, count);
    const num_q *costs = row(t, t.rows);
    struct cagd_hull_certificate c = {.inside = cagd_is_zero_q(costs[t.columns - 1]), .offset = from_int_q(0)};
    if (c.inside) {
        num_q *lambda = cagd_region_array(1, count, sizeof *lambda);
        if (lambda == NULL)
            return c;
        for (int j = 0; j < count; j++)
            lambda[j] = from_int_q(0);
        for (int i = 0; i <= d; i++)
            if (t.basic[i] < count)
                lambda[t.basic[i]] = row(t, i)[t.columns - 1];
        c.coefficient = lambda;
    } else {
        num_q *normal = cagd_region_array(1, d, sizeof *normal);
        if (normal == NULL)
            return c;
        for (int i = 0; i < d; i++) {
            num_q y = sub_q(from_int_q(1), costs[count + i]);
            normal[i] = cagd_sign_q(x[i]) < 0 ? neg_q(y) : y;
        }
        c.normal = normal;
        c.offset = sub_q(costs[count + d], from_int_q(1));
    }
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
