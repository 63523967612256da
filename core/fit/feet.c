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

/* An inscribed polygon: the points of the curve at t[0] < ... < t[sides]; `deep` bounds how far the curve is from a side.  Of
 * the sides: where they begin, their vectors, and one over the square of their lengths, coordinate by coordinate. */
typedef struct polygon {
    int sides, dim;
    double *t, *point, *deep;
    double *begin[3], *vector[3], *inverse;
} polygon;

enum { MOST_SIDES = 4096, FEWEST_SIDES = 64, PER_PIECE = 8, ANCHORS = 512 };

static void polygon_free(polygon *g)
{
    free(g->t);
    free(g->point);
    free(g->deep);
    free(g->inverse);
}

static double distance(int dim, const double a[], const double b[]) { return sqrt(fit_distance_squared(dim, a, b)); }

/* The sides in their arrays; 0 when there is no memory. */
static int polygon_sides(polygon *g)
{
    size_t n = (size_t)g->sides, dim = (size_t)g->dim;
    g->inverse = malloc((2 * dim + 1) * n * sizeof *g->inverse);
    if (g->inverse == NULL)
        return 0;
    for (size_t c = 0; c < dim; c++) {
        g->begin[c] = g->inverse + (1 + c) * n;
        g->vector[c] = g->inverse + (1 + dim + c) * n;
    }
    for (size_t k = 0; k < n; k++) {
        const double *a = g->point + k * dim, *b = a + dim;
        double square = fit_distance_squared(g->dim, a, b);
        for (size_t c = 0; c < dim; c++) {
            g->begin[c][k] = a[c];
            g->vector[c][k] = b[c] - a[c];
        }
        g->inverse[k] = square > 0 ? 1 / square : 0;
    }
    return 1;
}

/* Sides are halved until none is longer than its part of the whole, nor as deep as an eighth of its length. */
static int polygon_new(polygon *g, const fit_curve *curve)
{
    int dim = curve->dim, n = 0;
    size_t room = MOST_SIDES + 2 * PER_PIECE * (size_t)curve->pieces;
    double D[9], *t = malloc(room * sizeof *t), *next = malloc(room * sizeof *next), longest = 0;
    *g = (polygon){.dim = dim, .t = t};
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
    return polygon_sides(g);
}

/* Where on side k, 0 ... 1, the point is that q is nearest to. */
static inline double where_on_side(const polygon *g, const int dim, int k, const double q[])
{
    double along = 0;
    for (int c = 0; c < dim; c++)
        along += (q[c] - g->begin[c][k]) * g->vector[c][k];
    along *= g->inverse[k];
    along = along > 0 ? along : 0;
    return along < 1 ? along : 1;
}

/* The squared distances of q from the sides first ... last, `dim` being a constant for the compiler. */
static inline void from_sides_of(const polygon *g, const int dim, const double q[], int first, int last,
                                 double square[restrict])
{
    for (int k = first; k <= last; k++) {
        double s = where_on_side(g, dim, k, q), rest = 0;
        for (int c = 0; c < dim; c++) {
            double d = q[c] - g->begin[c][k] - s * g->vector[c][k];
            rest += d * d;
        }
        square[k] = rest;
    }
}

static void from_sides(const polygon *g, const double q[], int first, int last, double square[])
{
    if (g->dim == 2)
        from_sides_of(g, 2, q, first, last, square);
    else
        from_sides_of(g, 3, q, first, last, square);
}

static double on_side(const polygon *g, int k, const double q[])
{
    return g->t[k] + where_on_side(g, g->dim, k, q) * (g->t[k + 1] - g->t[k]);
}

/* The nearest of the feet that are reached from sides first ... last, and its squared distance; only sides whose part of the
 * curve may be nearer than the best one are tried, and of neighbours the nearest.  A foot that is known and lies on such a side or
 * beside it is the one that is reached from there. */
static double nearest(const fit_curve *curve, const polygon *g, const double q[], int first, int last,
                      const double *known, double square[], double *smallest)
{
    int dim = g->dim;
    double best = HUGE_VAL, found = g->t[first], D[9];
    from_sides(g, q, first, last, square);
    for (int k = first; k <= last; k++) {
        double most = sqrt(square[k]) + g->deep[k];
        best = most < best ? most : best;
    }
    *smallest = HUGE_VAL;
    for (int k = first; k <= last; k++) {
        if ((k > first && square[k - 1] < square[k]) || (k < last && square[k + 1] <= square[k]) ||
            sqrt(square[k]) - g->deep[k] > best)
            continue;
        double t;
        if (known != NULL && g->t[k > 0 ? k - 1 : 0] <= *known && *known <= g->t[k + 2 < g->sides ? k + 2 : g->sides]) {
            t = *known;
            fit_curve_derivatives(curve, t, D);
        } else {
            t = on_side(g, k, q);
            fit_foot(curve, q, &t, D);
        }
        double d = fit_distance_squared(dim, D, q);
        if (d < *smallest)
            *smallest = d, found = t;
    }
    return found;
}

/* The sides of the anchors, points 0, stride, 2 stride, ...: side[i] not decreasing, with the smallest sum of losses.  Dynamic
 * programming, Bellman. */
static int anchor_sides(const fit_problem *p, const polygon *g, int anchors, int stride, double square[], int side[])
{
    int m = g->sides;
    double *sum = calloc((size_t)m, sizeof *sum), slope;
    int *from = malloc((size_t)anchors * (size_t)m * sizeof *from);
    if (sum == NULL || from == NULL) {
        free(sum);
        free(from);
        return 0;
    }
    for (int i = 0; i < anchors; i++) {
        double weight = p->precision[i * stride] * p->precision[i * stride];
        from_sides(g, p->Q + (size_t)(i * stride) * (size_t)p->dim, 0, m - 1, square);
        for (int k = 0; p->loss != CAGD_FIT_SQUARES && k < m; k++)
            square[k] = fit_problem_loss(p, square[k] * weight, &slope) / weight;
        int before = 0;
        double smallest = sum[0];
        for (int k = 0; k < m; k++) {
            if (sum[k] < smallest)
                smallest = sum[k], before = k;
            from[i * m + k] = before;
            sum[k] = smallest + square[k] * weight;
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

/* Both searches: *cost of the feet t, *before of the known ones, if there are any. */
static int search(const fit_problem *p, const fit_curve *curve, const double *known, double t[], double *cost,
                  double *before)
{
    polygon g;
    int good = polygon_new(&g, curve), stride = (p->points - 1) / ANCHORS + 1, anchors = (p->points - 1) / stride + 1;
    double *square = good ? malloc((size_t)g.sides * sizeof *square) : NULL, slope, D[9];
    int *side = malloc((size_t)anchors * sizeof *side);
    good = good && square && side && (p->unordered || anchor_sides(p, &g, anchors, stride, square, side));
    *cost = *before = 0;
    for (int i = 0; good && i < p->points; i++) {
        const double *q = p->Q + (size_t)i * (size_t)p->dim, weight = p->precision[i] * p->precision[i];
        int a = i / stride, anchor = !p->unordered && i % stride == 0;
        int first = p->unordered ? 0 : side[a], last = anchor ? first : g.sides - 1;
        if (!p->unordered && !anchor && a + 1 < anchors)
            last = side[a + 1];
        double here;
        t[i] = nearest(curve, &g, q, first, last, known != NULL ? &known[i] : NULL, square, &here);
        here = fit_problem_loss(p, here * weight, &slope) / 2;
        *cost += here;
        if (known != NULL && known[i] != t[i]) {
            fit_curve_derivatives(curve, known[i], D);
            here = fit_problem_loss(p, fit_distance_squared(p->dim, D, q) * weight, &slope) / 2;
        }
        *before += here;
    }
    polygon_free(&g);
    free(square);
    free(side);
    return good;
}

int fit_feet_search(const fit_problem *p, const fit_curve *curve, double t[], double *cost)
{
    double before;
    return search(p, curve, NULL, t, cost, &before);
}

int fit_feet_improve(const fit_problem *p, const fit_curve *curve, const double known[], double t[], double *gain)
{
    double cost, before;
    int good = search(p, curve, known, t, &cost, &before);
    *gain = before - cost;
    return good;
}
