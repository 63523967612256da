#include "core/fit/feet.h"

#include "core/fit/polygon.h"

#include <math.h>
#include <stdlib.h>

/* What a search looks at: the polygon in the place of the curve and, of points in order, the sides of the anchors,
 * which are every stride-th point. */
typedef struct search {
    const fit_problem *problem;
    const fit_curve *curve;
    fit_polygon polygon;
    int thorough; /* every side that may be nearest is tried, since two that are nearly as near may be neighbours */
    int stride, anchors,
        beyond; /* a foot is looked for as far as so many anchors beyond those between which its point lies */
    int *side;
    double *square; /* room for a number of each side */
} search;

/* Some sides of the polygon. */
typedef struct sides {
    int first, last;
} sides;

int fit_held_foot(const fit_problem *p, const fit_curve *curve, int i, double *t, double D[])
{
    const int end = fit_end_of(p, i);
    if (end < 0)
        return 0;
    *t = end == 0 ? fit_curve_start(curve) : fit_curve_end(curve);
    fit_curve_derivatives(curve, *t, D);
    return 1;
}

/* ---- Closed curves ------------------------------------------------------------------------------------- */

/* The polygon over a closed curve begins with the side that is nearest to the first point, and its parameters run on
 * beyond the end of the domain.  What is there for the curve, and for the polygon, at a parameter of the other. */
static double parameter_of(const search *s, double t)
{
    const double start = fit_curve_start(s->curve), end = fit_curve_end(s->curve);
    return t > end && s->curve->period > 0 ? fmin(start + (t - end), end) : t;
}

static double unrolled(const search *s, double t)
{
    return t < s->polygon.t[0] ? t + (fit_curve_end(s->curve) - fit_curve_start(s->curve)) : t;
}

/* ---- One point ---------------------------------------------------------------------------------------- */

/* The smallest distance that a part of the curve surely has, by the sides over it; square[]: the squared distances of
 * these. */
static double surely_reached(const fit_polygon *g, sides range, const double square[])
{
    double best = HUGE_VAL;
    for (int k = range.first; k <= range.last; k++) {
        double most = sqrt(square[k]) + g->depth[k];
        best = most < best ? most : best;
    }
    return best;
}

/* Whether a neighbour of side k in the range is nearer. */
static int has_nearer_neighbour(sides range, int k, const double square[])
{
    return (k > range.first && square[k - 1] < square[k]) || (k < range.last && square[k + 1] <= square[k]);
}

/* Whether the curve over side k may be nearer than `best`; s->square[] is that of the sides in the range. */
static int is_tried(const search *s, sides range, int k, double best)
{
    return sqrt(s->square[k]) - s->polygon.depth[k] <= best &&
           (s->thorough || !has_nearer_neighbour(range, k, s->square));
}

/* The nearest of the feet that are reached from the sides in the range, and its squared distance.  Only sides over
 * which the curve may be nearer than the best one are tried; and of neighbours the nearest alone, unless the search
 * is thorough.  A foot that is known and lies over such a side or beside it is the one that is reached from there;
 * when it is the only one, *smallest is infinite. */
static double nearest_foot(const search *s, const double q[], sides range, const double *known, double *smallest)
{
    const fit_polygon *g = &s->polygon;
    double found = parameter_of(s, g->t[range.first]), D[9];
    *smallest = HUGE_VAL;
    if (known != NULL && range.first == range.last && fit_polygon_is_beside(g, range.first, unrolled(s, *known)))
        return *known;
    fit_polygon_distances(g, q, range.first, range.last, s->square);
    const double best = surely_reached(g, range, s->square);
    int tried = 0, last = range.first;
    for (int k = range.first; k <= range.last; k++)
        if (is_tried(s, range, k, best))
            tried++, last = k;
    if (known != NULL && tried == 1 && fit_polygon_is_beside(g, last, unrolled(s, *known)))
        return *known;
    for (int k = range.first; k <= last; k++) {
        if (!is_tried(s, range, k, best))
            continue;
        double t;
        if (known != NULL && fit_polygon_is_beside(g, k, unrolled(s, *known))) {
            t = *known;
            fit_curve_derivatives(s->curve, t, D);
        } else {
            t = parameter_of(s, fit_polygon_parameter(g, k, q));
            fit_foot(s->curve, q, &t, D);
        }
        double d = fit_distance_squared(g->dim, D, q);
        if (d < *smallest)
            *smallest = d, found = t;
    }
    return found;
}

/* Half the loss of point i at this squared distance. */
static double half_loss(const fit_problem *p, int i, double square)
{
    double slope;
    return fit_problem_loss(p, square * (p->precision[i] * p->precision[i]), &slope) / 2;
}

/* ---- Anchors ------------------------------------------------------------------------------------------ */

/* The side on which the foot of point i is held. */
static int side_of_end(const search *s, int i) { return fit_end_of(s->problem, i) == 0 ? 0 : s->polygon.sides - 1; }

/* The losses of anchor a on all sides. */
static void anchor_losses(const search *s, int a, double loss[])
{
    const fit_problem *p = s->problem;
    const int i = a * s->stride;
    double weight = p->precision[i] * p->precision[i], slope;
    fit_polygon_distances(&s->polygon, fit_point(p, i), 0, s->polygon.sides - 1, loss);
    for (int k = 0; k < s->polygon.sides; k++)
        loss[k] = p->loss == CAGD_FIT_SQUARES ? loss[k] * weight : fit_problem_loss(p, loss[k] * weight, &slope);
    for (int k = 0; k < s->polygon.sides && fit_end_of(p, i) >= 0; k++)
        loss[k] = k == side_of_end(s, i) ? loss[k] : HUGE_VAL;
}

/* Each anchor on the side that it is nearest to.  Returns whether these sides do not decrease; then no others in
 * order have a smaller sum of losses. */
static int take_nearest_sides(search *s)
{
    for (int a = 0; a < s->anchors; a++) {
        fit_polygon_distances(&s->polygon, fit_point(s->problem, a * s->stride), 0, s->polygon.sides - 1, s->square);
        s->side[a] = fit_end_of(s->problem, a * s->stride) >= 0 ? side_of_end(s, a * s->stride)
                                                                : fit_smallest_of(s->polygon.sides, s->square);
        if (a > 0 && s->side[a] < s->side[a - 1])
            return 0;
    }
    return 1;
}

/* The sides of the anchors that do not decrease and have the smallest sum of losses, by Bellman's dynamic
 * programming: sum[k] is the smallest sum of the anchors so far with the last of them on side k, and from[a m + k]
 * the side of the one before anchor a. */
static void take_sides_in_order(search *s, double sum[], int from[])
{
    const int m = s->polygon.sides;
    for (int k = 0; k < m; k++)
        sum[k] = 0;
    for (int a = 0; a < s->anchors; a++) {
        anchor_losses(s, a, s->square);
        int before = 0;
        double smallest = sum[0];
        for (int k = 0; k < m; k++) {
            if (sum[k] < smallest)
                smallest = sum[k], before = k;
            from[a * m + k] = before;
            sum[k] = smallest + s->square[k];
        }
    }
    int k = fit_smallest_of(m, sum);
    for (int a = s->anchors - 1; a >= 0; a--) {
        s->side[a] = k;
        k = from[a * m + k];
    }
}

/* Returns 0 when there is no memory. */
static int find_sides(search *s)
{
    if (take_nearest_sides(s))
        return 1;
    size_t m = (size_t)s->polygon.sides;
    double *sum = malloc(m * sizeof *sum);
    int *from = malloc((size_t)s->anchors * m * sizeof *from), good = sum != NULL && from != NULL;
    if (good)
        take_sides_in_order(s, sum, from);
    free(sum);
    free(from);
    return good;
}

/* ---- The search --------------------------------------------------------------------------------------- */

static void search_free(search *s)
{
    fit_polygon_free(&s->polygon);
    free(s->side);
    free(s->square);
}

/* Makes the polygon over a closed curve begin beside the first point.  Returns 0 when there is no memory. */
static int begin_at_first(search *s)
{
    if (s->curve->period == 0)
        return 1;
    fit_polygon_distances(&s->polygon, fit_point(s->problem, 0), 0, s->polygon.sides - 1, s->square);
    return fit_polygon_begin_at(&s->polygon, fit_smallest_of(s->polygon.sides, s->square));
}

/* Returns 0 when there is no memory; search_free is to be called all the same. */
static int search_new(const fit_problem *p, const fit_curve *curve, search *s)
{
    const int stride = (p->points - 1) / p->strategy.anchors + 1;
    *s = (search){.problem = p, .curve = curve, .thorough = p->nothing_free, .stride = stride};
    s->anchors = (p->points - 1) / stride + 1;
    s->beyond = p->neighbours > 1 ? p->neighbours / stride + 1 : 0;
    const int least = p->unordered ? 2 * p->strategy.sides : p->strategy.sides;
    if (!fit_polygon_new(curve, least, &s->polygon))
        return 0;
    s->side = malloc((size_t)s->anchors * sizeof *s->side);
    s->square = malloc((size_t)s->polygon.sides * sizeof *s->square);
    return s->side && s->square && (p->unordered || (begin_at_first(s) && find_sides(s)));
}

/* Where the foot of point i is looked for: on all sides, on that of the anchor which it is, or between those of two
 * anchors; of points that scatter by more than they are apart, between those of anchors farther away. */
static sides sides_of(const search *s, int i)
{
    const int a = i / s->stride, end = s->polygon.sides - 1, low = a - s->beyond, high = a + 1 + s->beyond;
    if (s->problem->unordered)
        return (sides){0, end};
    if (s->beyond > 0)
        return (sides){low >= 0 ? s->side[low] : 0, high < s->anchors ? s->side[high] : end};
    if (i % s->stride == 0)
        return (sides){s->side[a], s->side[a]};
    return (sides){s->side[a], a + 1 < s->anchors ? s->side[a + 1] : end};
}

int fit_feet_guess(const fit_problem *p, const fit_curve *curve, double t[])
{
    search s;
    int good = search_new(p, curve, &s);
    for (int i = 0; good && i < p->points; i++) {
        const sides range = sides_of(&s, i);
        double D[9];
        if (fit_held_foot(p, curve, i, &t[i], D))
            continue;
        int best = range.first;
        if (range.first < range.last)
            fit_polygon_distances(&s.polygon, fit_point(p, i), range.first, range.last, s.square);
        for (int k = range.first + 1; k <= range.last; k++)
            best = s.square[k] < s.square[best] ? k : best;
        t[i] = parameter_of(&s, fit_polygon_parameter(&s.polygon, best, fit_point(p, i)));
    }
    search_free(&s);
    return good;
}

int fit_feet_search(const fit_problem *p, const fit_curve *curve, double t[], double *cost)
{
    search s;
    int good = search_new(p, curve, &s);
    double square, D[9];
    *cost = 0;
    for (int i = 0; good && i < p->points; i++) {
        if (fit_held_foot(p, curve, i, &t[i], D))
            square = fit_distance_squared(p->dim, D, fit_point(p, i));
        else
            t[i] = nearest_foot(&s, fit_point(p, i), sides_of(&s, i), NULL, &square);
        *cost += half_loss(p, i, square);
    }
    search_free(&s);
    return good;
}

int fit_feet_improve(const fit_problem *p, const fit_curve *curve, const double known[], double t[], double *gain)
{
    search s;
    int good = search_new(p, curve, &s);
    double square, D[9];
    *gain = 0;
    for (int i = 0; good && i < p->points; i++) {
        if (fit_held_foot(p, curve, i, &t[i], D))
            continue;
        t[i] = nearest_foot(&s, fit_point(p, i), sides_of(&s, i), &known[i], &square);
        if (t[i] == known[i])
            continue;
        fit_curve_derivatives(curve, known[i], D);
        *gain += half_loss(p, i, fit_distance_squared(p->dim, D, fit_point(p, i))) - half_loss(p, i, square);
    }
    search_free(&s);
    return good;
}
