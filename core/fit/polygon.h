/* polygon.h -- a polygon inscribed in a curve, on which the sides nearest to a point are found quickly. */
#ifndef CAGD_FIT_POLYGON_H
#define CAGD_FIT_POLYGON_H

#include "core/fit/curve.h"

/* The corners are the points of the curve at t[0] < ... < t[sides].  depth[k] is taken for a bound on how far the
 * curve is from side k: it is twice the height of the triangle with two equal sides over side k that are as long as
 * the way by the middle of the curve there.  Of the sides, coordinate by coordinate: where they begin and their
 * vectors; and one over the squares of their lengths. */
typedef struct fit_polygon {
    int sides, dim;
    double *t, *point, *depth;
    double *begin[3], *vector[3], *inverse;
} fit_polygon;

/* No side is longer than one `parts`-th of the whole, nor deeper than an eighth of its length, as far as MOST_SIDES
 * allows.  Returns 0 when there is no memory; fit_polygon_free is to be called all the same. */
int fit_polygon_new(const fit_curve *curve, int parts, fit_polygon *polygon);
void fit_polygon_free(fit_polygon *polygon);

/* Over a closed curve: what was side `first` becomes the first side, and the parameters of those before it are larger by
 * the length of the domain.  Returns 0 when there is no memory. */
int fit_polygon_begin_at(fit_polygon *polygon, int first);

/* square[k], k = first, ..., last: the squared distance of q from side k. */
void fit_polygon_distances(const fit_polygon *polygon, const double q[], int first, int last, double square[]);

/* The parameter, linear along side k, of the point of that side that is nearest to q. */
double fit_polygon_parameter(const fit_polygon *polygon, int k, const double q[]);

/* Whether t is over side k or one beside it. */
int fit_polygon_is_beside(const fit_polygon *polygon, int k, double t);

/* The index of the first of the smallest of n >= 1 numbers. */
int fit_smallest_of(int n, const double x[]);
#endif
