#include "core/fit/feet.h"

#include "core/number/limits.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static inline double inner(int dim, const double a[], const double b[])
{
    return a[0] * b[0] + a[1] * b[1] + (dim == 3 ? a[2] * b[2] : 0);
}

#define NAME(name) name##_conic
#define DIM        2
#define DEGREE     2
#include "core/fit/foot.tmpl.h"
#undef NAME
#undef DEGREE
#define NAME(name) name##_cubic
#define DEGREE     3
#include "core/fit/foot.tmpl.h"
#undef NAME
#undef DIM
#define NAME(name) name##_space_cubic
#define DIM        3
#include "core/fit/foot.tmpl.h"
#undef NAME
#undef DIM
#undef DEGREE
#define NAME(name) name##_any
#define DIM        (curve->dim)
#define DEGREE     (curve->degree)
#include "core/fit/foot.tmpl.h"
#undef NAME
#undef DIM
#undef DEGREE

void fit_curve_derivatives(const fit_curve *c, double t, double D[]) { derivatives_any(c, t, D); }

fit_foot_kind fit_foot_near(const fit_curve *c, const double q[], double limit, double *t, double D[])
{
    int shape = c->dim * 100 + c->degree;
    return shape == 202   ? newton_conic(c, q, limit, t, D)
           : shape == 203 ? newton_cubic(c, q, limit, t, D)
           : shape == 303 ? newton_space_cubic(c, q, limit, t, D)
                          : newton_any(c, q, limit, t, D);
}

fit_foot_kind fit_foot(const fit_curve *c, const double q[], double *t, double D[])
{
    return fit_foot_near(c, q, FOOT_EXACT, t, D);
}

/* An inscribed polygon: the points of the curve at t[0] < ... < t[sides]; `deep` bounds how far the curve is from a side. */
typedef struct polygon {
    int sides, dim;
    double *t, *point, *deep;
} polygon;

enum { MOST_SIDES = 4096, FEWEST_SIDES = 64, PER_PIECE = 8, ANCHORS = 512 };

static void polygon_free(polygon *g)
{
    free(g->t);
    free(g->point);
    free(g->deep);
}

static double distance(int dim, const double a[], const double b[]) { return sqrt(fit_distance_squared(dim, a, b)); }

/* Sides are halved until none is longer than its part of the whole, nor as deep as an eighth of its length. */
static int polygon_new(polygon *g, const fit_curve *curve)
{
    int dim = curve->dim, n = 0;
    size_t room = MOST_SIDES + 2 * PER_PIECE * (size_t)curve->pieces;
    double D[9], *t = malloc(room * sizeof *t), *next = malloc(room * sizeof *next), longest = 0;
    g->dim = dim;
    g->t = t;
    g->point = malloc(room * (size_t)dim * sizeof *g->point);
    g->deep = malloc(room * sizeof *g->deep);
    if (!t || !next || !g->point || !g->deep) {
        free(next);
        return 0;
    }
    for (int k = 0; k < curve->pieces; k++)
        for (int i = 0; i < PER_PIECE; i++) {
            double a = curve->knots[curve->span[k]], b = curve->knots[curve->span[k] + 1];
            t[n++] = a + (b - a) * i / PER_PIECE;
        }
    t[n] = fit_curve_end(curve);
    for (int split = 1; split;) {
        double total = 0;
        for (int i = 0; i <= n; i++) {
            fit_curve_derivatives(curve, t[i], D);
            memcpy(g->point + i * dim, D, (size_t)dim * sizeof *D);
            total += i > 0 ? distance(dim, g->point + i * dim, g->point + (i - 1) * dim) : 0;
        }
        longest = total / FEWEST_SIDES;
        int m = 0, left = (int)room - 1 - n;
        split = 0;
        for (int i = 0; i < n; i++) {
            const double *a = g->point + i * dim, *b = a + dim;
            double middle = t[i] + (t[i + 1] - t[i]) / 2, length = distance(dim, a, b);
            fit_curve_derivatives(curve, middle, D);
            double way = distance(dim, a, D) + distance(dim, D, b);
            g->deep[i] = sqrt(fmax(0, way * way - length * length));
            next[m++] = t[i];
            if ((length > longest || way > longest * 2 || (way > length * 1.125 && way > longest / 8)) && left > 0 &&
                t[i] < middle && middle < t[i + 1]) {
                next[m++] = middle;
                left--;
                split = 1;
            }
        }
        next[m] = t[n];
        n = m;
        memcpy(t, next, (size_t)(n + 1) * sizeof *t);
    }
    g->sides = n;
    free(next);
    return 1;
}

/* The squared distance of q from side k, and where on it, 0 ... 1, it is. */
static inline double from_side(const polygon *g, int k, const double q[], double *where)
{
    int dim = g->dim;
    const double *a = g->point + k * dim, *b = a + dim;
    double along = 0, square = 0, rest = 0, s = 0;
    for (int c = 0; c < dim; c++) {
        along += (q[c] - a[c]) * (b[c] - a[c]);
        square += (b[c] - a[c]) * (b[c] - a[c]);
    }
    if (along > 0)
        s = along < square ? along / square : 1;
    for (int c = 0; c < dim; c++) {
        double d = q[c] - a[c] - s * (b[c] - a[c]);
        rest += d * d;
    }
    *where = s;
    return rest;
}

static inline double on_side(const polygon *g, int k, double where)
{
    return g->t[k] + where * (g->t[k + 1] - g->t[k]);
}

/* The nearest of the feet that are reached from sides first ... last, and its squared distance; only sides whose part of the
 * curve may be nearer than the best one are tried, and of neighbours the nearest. */
static double nearest(const fit_curve *curve, const polygon *g, const double q[], int first, int last, double square[],
                      double *smallest)
{
    int dim = g->dim;
    double best = HUGE_VAL, found = g->t[first], where, D[9];
    for (int k = first; k <= last; k++) {
        square[k] = from_side(g, k, q, &where);
        double most = sqrt(square[k]) + g->deep[k];
        best = most < best ? most : best;
    }
    *smallest = HUGE_VAL;
    for (int k = first; k <= last; k++) {
        if ((k > first && square[k - 1] < square[k]) || (k < last && square[k + 1] <= square[k]) ||
            sqrt(square[k]) - g->deep[k] > best)
            continue;
        from_side(g, k, q, &where);
        double t = on_side(g, k, where);
        fit_foot(curve, q, &t, D);
        double d = fit_distance_squared(dim, D, q);
        if (d < *smallest)
            *smallest = d, found = t;
    }
    return found;
}

/* The sides of the anchors, points 0, stride, 2 stride, ...: side[i] not decreasing, with the smallest sum of losses.  Dynamic
 * programming, Bellman. */
static int anchor_sides(const fit_problem *p, const polygon *g, int anchors, int stride, int side[])
{
    int m = g->sides;
    double *sum = calloc((size_t)m, sizeof *sum), slope, where;
    int *from = malloc((size_t)anchors * (size_t)m * sizeof *from);
    if (sum == NULL || from == NULL) {
        free(sum);
        free(from);
        return 0;
    }
    for (int i = 0; i < anchors; i++) {
        const double *q = p->Q + (size_t)(i * stride) * (size_t)p->dim;
        double weight = p->precision[i * stride] * p->precision[i * stride];
        int before = 0;
        double smallest = sum[0];
        for (int k = 0; k < m; k++) {
            if (sum[k] < smallest)
                smallest = sum[k], before = k;
            from[i * m + k] = before;
            sum[k] = smallest + fit_problem_loss(p, from_side(g, k, q, &where) * weight, &slope);
        }
    }
    int k = 0;
    for (int j = 1; j < m; j++)
        if (sum[j] < sum[k])
            k = j;
    for (int i = anchors - 1; i >= 0; i--) {
        side[i] = k;
        k = from[i * m + k];
    }
    free(sum);
    free(from);
    return 1;
}

int fit_feet_search(const fit_problem *p, const fit_curve *curve, double t[], double *cost)
{
    polygon g;
    int good = polygon_new(&g, curve), stride = (p->points - 1) / ANCHORS + 1, anchors = (p->points - 1) / stride + 1;
    double *square = good ? malloc((size_t)g.sides * sizeof *square) : NULL, slope;
    int *side = malloc((size_t)anchors * sizeof *side);
    good = good && square && side && (p->unordered || anchor_sides(p, &g, anchors, stride, side));
    *cost = 0;
    for (int i = 0; good && i < p->points; i++) {
        int a = i / stride, anchor = !p->unordered && i % stride == 0;
        int first = p->unordered ? 0 : side[a], last = anchor ? first : g.sides - 1;
        if (!p->unordered && !anchor && a + 1 < anchors)
            last = side[a + 1];
        double distance_squared;
        t[i] = nearest(curve, &g, p->Q + (size_t)i * (size_t)p->dim, first, last, square, &distance_squared);
        *cost += fit_problem_loss(p, distance_squared * p->precision[i] * p->precision[i], &slope) / 2;
    }
    polygon_free(&g);
    free(square);
    free(side);
    return good;
}
