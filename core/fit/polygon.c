#include "core/fit/polygon.h"

#include "core/fit/wide.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A polygon begins with PER_PIECE sides in each piece of the curve, and never has more than MOST_SIDES beside these.
 * With 2, 4, 8, 16 or 32 sides per piece the same feet and fits are found; with 8 the fewest sides are needed in the
 * end, at most 143 for the curves of the tests.  So MOST_SIDES only bounds memory and time for curves that nobody has
 * thought of; the search is then as coarse as these sides are. */
enum { MOST_SIDES = 1024, PER_PIECE = 8 };

void fit_polygon_free(fit_polygon *g)
{
    free(g->t);
    free(g->point);
    free(g->depth);
    free(g->inverse);
}

static double distance(int dim, const double a[], const double b[]) { return sqrt(fit_distance_squared(dim, a, b)); }

/* Fills the arrays of the sides, from the corners.  Returns 0 when there is no memory. */
static int fill_sides(fit_polygon *g)
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

/* Adds sides from t[sides], whose point is there, to `end`.  A side is halved until it is no longer than `longest`,
 * nor as deep as an eighth of its length, or until there is no room for more. */
static void add_sides(fit_polygon *g, const fit_curve *curve, double end, const double at_end[], double longest,
                      int *room)
{
    int dim = g->dim, k = g->sides;
    const double start = g->t[k], middle = start + (end - start) / 2, *a = g->point + k * dim;
    double D[3];
    fit_curve_point(curve, middle, D);
    double length = distance(dim, a, at_end), way = distance(dim, a, D) + distance(dim, D, at_end);
    if ((length > longest || way > longest * 2 || (way > length * 1.125 && way > longest / 8)) && *room > 0 &&
        start < middle && middle < end) {
        --*room;
        add_sides(g, curve, middle, D, longest, room);
        add_sides(g, curve, end, at_end, longest, room);
        return;
    }
    g->depth[k] = sqrt(fmax(0, way * way - length * length));
    g->t[k + 1] = end;
    memcpy(g->point + (k + 1) * dim, at_end, (size_t)dim * sizeof *at_end);
    g->sides++;
}

/* The parameter at the end of side k of the polygon to begin with, which has PER_PIECE sides in every piece of the
 * curve. */
static double end_of_first(const fit_curve *curve, int k)
{
    const double *u = curve->spline.knots + curve->span[k / PER_PIECE];
    const int side = k % PER_PIECE + 1;
    return side == PER_PIECE ? u[1] : u[0] + (u[1] - u[0]) * side / PER_PIECE;
}

/* The length of that polygon. */
static double first_length(const fit_curve *curve)
{
    double before[3], here[3], length = 0;
    fit_curve_point(curve, fit_curve_start(curve), before);
    for (int k = 0; k < PER_PIECE * curve->pieces; k++) {
        fit_curve_point(curve, end_of_first(curve, k), here);
        length += distance(curve->spline.dim, before, here);
        memcpy(before, here, sizeof before);
    }
    return length;
}

int fit_polygon_new(const fit_curve *curve, int parts, fit_polygon *g)
{
    const int dim = curve->spline.dim, first = PER_PIECE * curve->pieces;
    const size_t most = (size_t)(MOST_SIDES + first + 1);
    int room = MOST_SIDES;
    double D[3];
    *g = (fit_polygon){.dim = dim,
                       .t = malloc(most * sizeof *g->t),
                       .point = malloc(most * (size_t)dim * sizeof *g->point),
                       .depth = malloc(most * sizeof *g->depth)};
    if (!g->t || !g->point || !g->depth)
        return 0;
    g->t[0] = fit_curve_start(curve);
    fit_curve_point(curve, g->t[0], D);
    memcpy(g->point, D, (size_t)dim * sizeof *D);
    const double longest = first_length(curve) / parts;
    for (int k = 0; k < first; k++) {
        const double end = end_of_first(curve, k);
        fit_curve_point(curve, end, D);
        add_sides(g, curve, end, D, longest, &room);
    }
    return fill_sides(g);
}

int fit_polygon_begin_at(fit_polygon *g, int first)
{
    const int m = g->sides, dim = g->dim;
    const double length = g->t[m] - g->t[0];
    double *was = malloc((size_t)(m + 1) * (size_t)(dim + 2) * sizeof *was), *point = was + m + 1,
           *depth = point + (m + 1) * dim;
    if (was == NULL)
        return 0;
    memcpy(was, g->t, (size_t)(m + 1) * sizeof *was);
    memcpy(point, g->point, (size_t)((m + 1) * dim) * sizeof *point);
    memcpy(depth, g->depth, (size_t)m * sizeof *depth);
    for (int k = 0; k <= m; k++) {
        const int from = (first + k) % m, round = first + k >= m;
        g->t[k] = was[from] + (round ? length : 0);
        memcpy(g->point + k * dim, point + from * dim, (size_t)dim * sizeof *point);
        if (k < m)
            g->depth[k] = depth[from];
    }
    free(was);
    free(g->inverse);
    return fill_sides(g);
}

/* Where on side k, between 0 and 1, its point nearest to q is. */
INLINE double where_on_side(const fit_polygon *g, const int dim, int k, const double q[])
{
    double along = 0;
    for (int c = 0; c < dim; c++)
        along += (q[c] - g->begin[c][k]) * g->vector[c][k];
    along *= g->inverse[k];
    along = along > 0 ? along : 0;
    return along < 1 ? along : 1;
}

/* fit_polygon_distances in `dim` dimensions, a constant for the compiler. */
INLINE void distances_in(const fit_polygon *g, const int dim, const double q[], int first, int last,
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

WIDE static void distances(const fit_polygon *g, const double q[], int first, int last, double square[])
{
    if (g->dim == 2)
        distances_in(g, 2, q, first, last, square);
    else
        distances_in(g, 3, q, first, last, square);
}

void fit_polygon_distances(const fit_polygon *g, const double q[], int first, int last, double square[])
{
    enum { FEW = 4 }; /* sides, for which to choose among processors takes longer than to compute */
    if (last - first >= FEW)
        distances(g, q, first, last, square);
    else if (g->dim == 2)
        distances_in(g, 2, q, first, last, square);
    else
        distances_in(g, 3, q, first, last, square);
}

double fit_polygon_parameter(const fit_polygon *g, int k, const double q[])
{
    const double part = g->dim == 2 ? where_on_side(g, 2, k, q) : where_on_side(g, 3, k, q);
    return g->t[k] + part * (g->t[k + 1] - g->t[k]);
}

int fit_polygon_is_beside(const fit_polygon *g, int k, double t)
{
    return g->t[k > 0 ? k - 1 : 0] <= t && t <= g->t[k + 2 < g->sides ? k + 2 : g->sides];
}

/* Minima of WIDE_SUMS columns, side by side, and then of these. */
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

int fit_smallest_of(int n, const double x[]) { return smallest_of(n, x); }
