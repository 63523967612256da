#include "core/fit/order.h"

#include "core/fit/ceres.h"
#include "core/fit/keyed.h"

#include <math.h>
#include <stdlib.h>

static void find_centre(const fit_problem *p, double centre[])
{
    for (int c = 0; c < p->dim; c++)
        centre[c] = 0;
    for (int i = 0; i < p->points; i++)
        for (int c = 0; c < p->dim; c++)
            centre[c] += fit_point(p, i)[c] / p->points;
}

/* Along the chain that goes from each point to the nearest one that is left. */
static void order_by_neighbours(const fit_problem *p, int order[])
{
    int n = p->points, dim = p->dim, far = 0;
    double farthest = -1, centre[3];
    find_centre(p, centre);
    for (int i = 0; i < n; i++) {
        double d = fit_distance_squared(dim, fit_point(p, i), centre);
        order[i] = i;
        if (d > farthest)
            farthest = d, far = i;
    }
    order[0] = far, order[far] = 0;
    for (int i = 1; i < n; i++) {
        int best = i;
        double nearest = HUGE_VAL;
        for (int k = i; k < n; k++) {
            double d = fit_distance_squared(dim, fit_point(p, order[k]), fit_point(p, order[i - 1]));
            if (d < nearest)
                nearest = d, best = k;
        }
        int swap = order[i];
        order[i] = order[best];
        order[best] = swap;
    }
}

/* axes: the principal axes of the points, as columns, the longest first.  Returns 0 when there is no memory. */
static int find_axes(const fit_problem *p, const double centre[], double axes[])
{
    double scatter[9] = {0}, U[9], s[3];
    for (int i = 0; i < p->points; i++)
        for (int a = 0; a < p->dim; a++)
            for (int b = 0; b < p->dim; b++)
                scatter[a * p->dim + b] += (fit_point(p, i)[a] - centre[a]) * (fit_point(p, i)[b] - centre[b]);
    return fit_svd(p->dim, scatter, U, s, axes);
}

/* The index in the sorted list of the point after the widest gap between angles. */
static int after_widest_gap(int count, const keyed list[])
{
    int after = 0;
    double widest = 0;
    for (int i = 0; i < count; i++) {
        double before = i > 0 ? list[i - 1].key : list[count - 1].key - 2 * acos(-1);
        if (list[i].key - before > widest)
            widest = list[i].key - before, after = i;
    }
    return after;
}

/* By the coordinate along the first principal axis, or by the angle in the plane of the first two. */
static int order_by_axes(const fit_problem *p, int by_angle, int order[])
{
    int n = p->points, dim = p->dim;
    double centre[3], axes[9];
    keyed *list = malloc((size_t)n * sizeof *list);
    find_centre(p, centre);
    int good = list != NULL && find_axes(p, centre, axes);
    for (int i = 0; good && i < n; i++) {
        double x = 0, y = 0;
        for (int c = 0; c < dim; c++) {
            x += (fit_point(p, i)[c] - centre[c]) * axes[c * dim];
            y += (fit_point(p, i)[c] - centre[c]) * axes[c * dim + 1];
        }
        list[i] = (keyed){by_angle ? atan2(y, x) : x, i};
    }
    if (good) {
        qsort(list, (size_t)n, sizeof *list, fit_by_key);
        int from = by_angle ? after_widest_gap(n, list) : 0;
        for (int i = 0; i < n; i++)
            order[i] = list[(i + from) % n].index;
    }
    free(list);
    return good;
}

int fit_order(const fit_problem *p, enum fit_order_kind kind, int order[])
{
    int good = 1;
    if (kind == FIT_BY_NEIGHBOURS)
        order_by_neighbours(p, order);
    else
        good = order_by_axes(p, kind == FIT_AROUND_CENTRE, order);
    if (good && order[0] > order[p->points - 1])
        for (int i = 0, j = p->points - 1; i < j; i++, j--) {
            const int other = order[i];
            order[i] = order[j];
            order[j] = other;
        }
    return good;
}
