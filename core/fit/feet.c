#include "core/fit/feet.h"

#include "core/fit/wide.h"
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

static int shape_of(const fit_curve *c) { return c->dim * 100 + c->degree; }

void fit_curve_derivatives(const fit_curve *c, double t, double D[])
{
    switch (shape_of(c)) {
    case 202:
        derivatives_conic(c, t, D);
        break;
    case 203:
        derivatives_cubic(c, t, D);
        break;
    case 303:
        derivatives_space_cubic(c, t, D);
        break;
    default:
        derivatives_any(c, t, D);
    }
}

fit_foot_kind fit_foot_near(const fit_curve *c, const double q[], double limit, double *t, double D[])
{
    int shape = shape_of(c);
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
    int thorough; /* every side that may be nearest is tried, as two of them that are nearly as near may be neighbours */
    double *t, *point, *deep;
    double *begin[3], *vector[3], *inverse;
} polygon;

/* Sides of the polygon: never more, and those of each piece to begin with.  The latter are where halving begins: with 2, 4, 8, 16 or 32 of them
 * the same feet and fits are found, and 8 need the fewest sides in the end, at most 143 for the curves of the tests; so that the former
 * only bounds memory and time for what nobody has thought of, the search being then as coarse as these sides are. */
enum { MOST_SIDES = 1024, PER_PIECE = 8 };

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

/* Sides are halved until none is longer than its part of the whole, nor as deep as an eighth of its length; `room` is for so many
 * more.  From t[sides], whose point is there, to `end`. */
static void add_sides(polygon *g, const fit_curve *curve, double end, const double at_end[], double longest, int *room)
{
    int dim = g->dim, k = g->sides;
    const double start = g->t[k], middle = start + (end - start) / 2, *a = g->point + k * dim;
    double D[9];
    fit_curve_derivatives(curve, middle, D);
    double length = distance(dim, a, at_end), way = distance(dim, a, D) + distance(dim, D, at_end);
    if ((length > longest || way > longest * 2 || (way > length * 1.125 && way > longest / 8)) && *room > 0 &&
        start < middle && middle < end) {
        --*room;
        add_sides(g, curve, middle, D, longest, room);
        add_sides(g, curve, end, at_end, longest, room);
        return;
    }
    g->deep[k] = sqrt(fmax(0, way * way - length * length));
    g->t[k + 1] = end;
    memcpy(g->point + (k + 1) * dim, at_end, (size_t)dim * sizeof *at_end);
    g->sides++;
}

static int polygon_new(polygon *g, const fit_curve *curve, int sides)
{
    int dim = curve->dim, room = MOST_SIDES, first = PER_PIECE * curve->pieces;
    size_t most = (size_t)(room + first + 1);
    double D[9], before[3], length = 0, start = fit_curve_start(curve);
    *g = (polygon){.dim = dim};
    g->t = malloc(most * sizeof *g->t);
    g->point = malloc(most * (size_t)dim * sizeof *g->point);
    g->deep = malloc(most * sizeof *g->deep);
    if (!g->t || !g->point || !g->deep)
        return 0;
    g->t[0] = start;
    fit_curve_derivatives(curve, start, D);
    memcpy(g->point, D, (size_t)dim * sizeof *D);
    for (int pass = 0; pass < 2; pass++) /* first the length of a coarse polygon */
        for (int k = 0; k < first; k++) {
            double a = curve->knots[curve->span[k / PER_PIECE]], b = curve->knots[curve->span[k / PER_PIECE] + 1];
            double end = k % PER_PIECE == PER_PIECE - 1 ? b : a + (b - a) * (k % PER_PIECE + 1) / PER_PIECE;
            memcpy(before, k == 0 ? g->point : D, (size_t)dim * sizeof *D);
            fit_curve_derivatives(curve, end, D);
            if (pass == 0)
                length += distance(dim, before, D);
            else
                add_sides(g, curve, end, D, length / sides, &room);
        }
    return polygon_sides(g);
}

/* Where on side k, 0 ... 1, the point is that q is nearest to. */
INLINE double where_on_side(const polygon *g, const int dim, int k, const double q[])
{
    double along = 0;
    for (int c = 0; c < dim; c++)
        along += (q[c] - g->begin[c][k]) * g->vector[c][k];
    along *= g->inverse[k];
    along = along > 0 ? along : 0;
    return along < 1 ? along : 1;
}

/* The squared distances of q from the sides first ... last, `dim` being a constant for the compiler. */
INLINE void from_sides_of(const polygon *g, const int dim, const double q[], int first, int last,
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

WIDE static void from_sides(const polygon *g, const double q[], int first, int last, double square[])
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

/* Whether t is on side k or beside it. */
static int beside(const polygon *g, int k, double t)
{
    return g->t[k > 0 ? k - 1 : 0] <= t && t <= g->t[k + 2 < g->sides ? k + 2 : g->sides];
}

/* The nearest of the feet that are reached from sides first ... last, and its squared distance; only sides whose part of the
 * curve may be nearer than the best one are tried, and of neighbours the nearest, or all.  A foot that is known and lies on such a side or
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
    if (known != NULL && first == last && beside(g, first, *known))
        return *known;
    for (int k = first; k <= last; k++) {
        int farther = (k > first && square[k - 1] < square[k]) || (k < last && square[k + 1] <= square[k]);
        if ((farther && !g->thorough) || sqrt(square[k]) - g->deep[k] > best)
            continue;
        double t;
        if (known != NULL && beside(g, k, *known)) {
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

/* The losses of anchor i, point i stride, on all sides. */
static void anchor_losses(const fit_problem *p, const polygon *g, int i, int stride, double loss[])
{
    const size_t at = (size_t)i * (size_t)stride;
    double weight = p->precision[at] * p->precision[at], slope;
    from_sides(g, p->Q + at * (size_t)p->dim, 0, g->sides - 1, loss);
    for (int k = 0; k < g->sides; k++)
        loss[k] = p->loss == CAGD_FIT_SQUARES ? loss[k] * weight : fit_problem_loss(p, loss[k] * weight, &slope);
}

/* The first of the smallest of n numbers.  Minima of WIDE_SUMS columns, side by side, and then of these. */
WIDE static int smallest_of(int n, const double x[])
{
    double least[WIDE_SUMS], smallest = HUGE_VAL;
    int i = 0, first = 0;
    for (int k = 0; k < WIDE_SUMS; k++)
        least[k] = HUGE_VAL;
    for (; i + WIDE_SUMS <= n; i += WIDE_SUMS)
        for (int k = 0; k < WIDE_SUMS; k++)
            least[k] = x[i + k] < least[k] ? x[i + k] : least[k];
    for (; i < n; i++)
        smallest = x[i] < smallest ? x[i] : smallest;
    for (int k = 0; k < WIDE_SUMS; k++)
        smallest = least[k] < smallest ? least[k] : smallest;
    while (first < n - 1 && x[first] != smallest)
        first++;
    return first;
}

/* Each anchor on the side that it is nearest to; whether these sides do not decrease, so that their sum of losses is the smallest. */
static int nearest_sides(const fit_problem *p, const polygon *g, int anchors, int stride, double square[], int side[])
{
    for (int i = 0; i < anchors; i++) {
        from_sides(g, p->Q + (size_t)i * (size_t)stride * (size_t)p->dim, 0, g->sides - 1, square);
        side[i] = smallest_of(g->sides, square);
        if (i > 0 && side[i] < side[i - 1])
            return 0;
    }
    return 1;
}

/* The sides of the anchors: side[i] not decreasing, with the smallest sum of losses.  Dynamic programming, Bellman.  0 when there is no
 * memory. */
static int anchor_sides(const fit_problem *p, const polygon *g, int anchors, int stride, double loss[], int side[])
{
    if (nearest_sides(p, g, anchors, stride, loss, side))
        return 1;
    int m = g->sides;
    double *sum = calloc((size_t)m, sizeof *sum);
    int *from = malloc((size_t)anchors * (size_t)m * sizeof *from);
    if (sum == NULL || from == NULL) {
        free(sum);
        free(from);
        return 0;
    }
    for (int i = 0; i < anchors; i++) {
        anchor_losses(p, g, i, stride, loss);
        int before = 0;
        double smallest = sum[0];
        for (int k = 0; k < m; k++) {
            if (sum[k] < smallest)
                smallest = sum[k], before = k;
            from[i * m + k] = before;
            sum[k] = smallest + loss[k];
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

/* The sides a ... b on which the foot of a point is looked for: all, that of the anchor, or those between two anchors. */
typedef struct search {
    polygon polygon;
    int stride, anchors;
    int *side;
    double *square;
} search;

static void search_free(search *s)
{
    polygon_free(&s->polygon);
    free(s->side);
    free(s->square);
}

static int search_new(search *s, const fit_problem *p, const fit_curve *curve)
{
    *s = (search){.stride = (p->points - 1) / p->strategy.anchors + 1};
    s->anchors = (p->points - 1) / s->stride + 1;
    int good = polygon_new(&s->polygon, curve, p->strategy.sides);
    s->polygon.thorough = p->nothing_free;
    s->side = malloc((size_t)s->anchors * sizeof *s->side);
    s->square = good ? malloc((size_t)s->polygon.sides * sizeof *s->square) : NULL;
    return good && s->side && s->square &&
           (p->unordered || anchor_sides(p, &s->polygon, s->anchors, s->stride, s->square, s->side));
}

static void sides_of(const search *s, const fit_problem *p, int i, int *first, int *last)
{
    int a = i / s->stride, anchor = i % s->stride == 0;
    *first = p->unordered ? 0 : s->side[a];
    *last = p->unordered || (!anchor && a + 1 >= s->anchors) ? s->polygon.sides - 1 : s->side[anchor ? a : a + 1];
}

int fit_feet_guess(const fit_problem *p, const fit_curve *curve, double t[])
{
    search s;
    int good = search_new(&s, p, curve), first, last;
    for (int i = 0; good && i < p->points; i++) {
        const double *q = p->Q + (size_t)i * (size_t)p->dim;
        sides_of(&s, p, i, &first, &last);
        from_sides(&s.polygon, q, first, last, s.square);
        int best = first;
        for (int k = first + 1; k <= last; k++)
            best = s.square[k] < s.square[best] ? k : best;
        t[i] = on_side(&s.polygon, best, q);
    }
    search_free(&s);
    return good;
}

int fit_feet_search(const fit_problem *p, const fit_curve *curve, double t[], double *cost)
{
    search s;
    int good = search_new(&s, p, curve), first, last;
    double slope, square;
    *cost = 0;
    for (int i = 0; good && i < p->points; i++) {
        sides_of(&s, p, i, &first, &last);
        t[i] = nearest(curve, &s.polygon, p->Q + (size_t)i * (size_t)p->dim, first, last, NULL, s.square, &square);
        *cost += fit_problem_loss(p, square * p->precision[i] * p->precision[i], &slope) / 2;
    }
    search_free(&s);
    return good;
}

int fit_feet_improve(const fit_problem *p, const fit_curve *curve, const double known[], double t[], double *gain)
{
    search s;
    int good = search_new(&s, p, curve), first, last;
    double slope, square, D[9];
    *gain = 0;
    for (int i = 0; good && i < p->points; i++) {
        const double *q = p->Q + (size_t)i * (size_t)p->dim, weight = p->precision[i] * p->precision[i];
        sides_of(&s, p, i, &first, &last);
        t[i] = nearest(curve, &s.polygon, q, first, last, &known[i], s.square, &square);
        if (t[i] == known[i])
            continue;
        *gain -= fit_problem_loss(p, square * weight, &slope) / 2;
        fit_curve_derivatives(curve, known[i], D);
        *gain += fit_problem_loss(p, fit_distance_squared(p->dim, D, q) * weight, &slope) / 2;
    }
    search_free(&s);
    return good;
}
