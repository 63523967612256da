#include "core/fit/feet.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static inline double inner(int dim, const double a[], const double b[])
{
    return a[0] * b[0] + a[1] * b[1] + (dim == 3 ? a[2] * b[2] : 0);
}

/* Newton's method for f(t) = (C - Q) C' = 0 between low and high, f(low) < 0 < f(high) as far as f is known there; nothing
 * is known at the ends of the domain before they are tried.  A step that leaves this interval, or where
 * f' = C' C' + (C - Q) C'' is not positive, is replaced by the foot on the tangent, f' = C' C'; when this too leaves it, an
 * end of the domain that was not tried is, or the middle.
 *
 * The last step is taken without another look at f: Newton's method squares the error in units of the length on which the
 * curve changes, |C'|/|C''| or the domain, so that after a step of the square root of the precision nothing is left. */
fit_foot_kind fit_foot(const fit_curve *curve, const double q[], double *t, double D[])
{
    int dim = curve->dim, low_known = 0, high_known = 0;
    double start = fit_curve_start(curve), end = fit_curve_end(curve), low = start, high = end, x = *t;
    const double *D1 = D + dim, *D2 = D + 2 * dim;
    double size = 1; /* of the curve, in working coordinates, and of q */
    for (int c = 0; c < dim; c++)
        size = fmax(size, fabs(q[c]));
    double blur = (2 * curve->degree + 2) * DBL_EPSILON * size; /* what rounding makes of C - Q */
    for (int looks = 1;; looks++) {
        double off[3];
        fit_curve_derivatives(curve, x, D);
        for (int c = 0; c < dim; c++)
            off[c] = D[c] - q[c];
        double f = inner(dim, off, D1), square = inner(dim, D1, D1), speed = sqrt(square);
        double slope = square + inner(dim, off, D2);
        *t = x;
        if (fabs(f) <= blur * speed)
            return square > 0 ? FOOT_ORTHOGONAL : FOOT_AT_CORNER;
        if (f < 0)
            low = x, low_known = 1;
        else
            high = x, high_known = 1;
        if (low == high)
            return FOOT_AT_END;
        if (low_known && high_known && nextafter(low, high) == high)
            return slope > 0 && fabs(f) <= blur * speed * (slope / square) + slope * (high - low) ? FOOT_ORTHOGONAL
                                                                                                  : FOOT_AT_CORNER;
        double next = slope > 0 ? x - f / slope : low;
        int newton = low < next && next < high;
        if (!newton)
            next = x - f / square;
        if (!(low < next && next < high) || (looks > 16 && looks % 2 == 0 && low_known && high_known)) {
            next = f < 0 && !high_known ? end : f > 0 && !low_known ? start : low + (high - low) / 2;
            newton = 0;
        }
        double bend = sqrt(inner(dim, D2, D2)), scale = fmin(end - start, bend > 0 ? speed / bend : end - start);
        if (newton && fabs(next - x) <= sqrt(DBL_EPSILON) * scale * fmin(1, slope / square)) {
            *t = next;
            fit_curve_derivatives(curve, next, D);
            return FOOT_ORTHOGONAL;
        }
        x = next;
    }
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
    double along = 0, square = 0, rest = 0;
    for (int c = 0; c < dim; c++) {
        along += (q[c] - a[c]) * (b[c] - a[c]);
        square += (b[c] - a[c]) * (b[c] - a[c]);
    }
    double s = square > 0 ? fmin(1, fmax(0, along / square)) : 0;
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

/* The nearest of the feet that are reached from sides first ... last; only sides whose part of the curve may be nearer than the
 * best one are tried, and of neighbours the nearest. */
static double nearest(const fit_curve *curve, const polygon *g, const double q[], int first, int last, double square[])
{
    int dim = g->dim;
    double best = HUGE_VAL, found = g->t[first], where, D[9];
    for (int k = first; k <= last; k++) {
        square[k] = from_side(g, k, q, &where);
        best = fmin(best, sqrt(square[k]) + g->deep[k]);
    }
    double smallest = HUGE_VAL;
    for (int k = first; k <= last; k++) {
        if ((k > first && square[k - 1] < square[k]) || (k < last && square[k + 1] <= square[k]) ||
            sqrt(square[k]) - g->deep[k] > best)
            continue;
        from_side(g, k, q, &where);
        double t = on_side(g, k, where);
        fit_foot(curve, q, &t, D);
        double d = distance(dim, D, q);
        if (d < smallest)
            smallest = d, found = t;
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

int fit_feet_search(const fit_problem *p, const fit_curve *curve, double t[])
{
    polygon g;
    int good = polygon_new(&g, curve), stride = (p->points - 1) / ANCHORS + 1, anchors = (p->points - 1) / stride + 1;
    double *square = good ? malloc((size_t)g.sides * sizeof *square) : NULL;
    int *side = malloc((size_t)anchors * sizeof *side);
    good = good && square && side && (p->unordered || anchor_sides(p, &g, anchors, stride, side));
    for (int i = 0; good && i < p->points; i++) {
        const double *q = p->Q + (size_t)i * (size_t)p->dim;
        int first = 0, last = g.sides - 1;
        if (!p->unordered) {
            int a = i / stride;
            first = side[a];
            last = a + 1 < anchors && i % stride ? side[a + 1] : i % stride ? last : first;
        }
        if (!p->unordered && i % stride == 0) {
            double D[9], where;
            from_side(&g, first, q, &where);
            t[i] = on_side(&g, first, where);
            fit_foot(curve, q, &t[i], D);
        } else
            t[i] = nearest(curve, &g, q, first, last, square);
    }
    polygon_free(&g);
    free(square);
    free(side);
    return good;
}
