/* hull.h -- convex hulls of finitely many rational points, with evidence.
 * A point of dimension d is d coordinates; points follow one another: points[d j + i]. */
#ifndef CAGD_HULL_H
#define CAGD_HULL_H

#include "exact/number/rational.h"

/* Why x is, or is not, in the convex hull of P_0, ..., P_(count-1). */
struct cagd_hull_certificate {
    int inside;
    const cagd_num_q *coefficient; /* inside: count numbers >= 0 with sum 1 and sum coefficient_j P_j = x  */
    const cagd_num_q *normal;      /* outside: d numbers with normal . P_j <= offset < normal . x, all j   */
    cagd_num_q offset;
};

/* The hull of no points is empty.  d >= 1, count >= 0.  Phase one of the simplex method over Q with
 * Bland's rule; the certificate has been checked by the next function.
 * Source: bland-1977; farkas-1902. */
struct cagd_hull_certificate cagd_hull_membership(int d, int count, const cagd_num_q points[], const cagd_num_q x[]);

/* Does the certificate prove what it says?  Multiplications and additions only. */
int cagd_hull_certificate_holds(int d, int count, const cagd_num_q points[], const cagd_num_q x[],
                                struct cagd_hull_certificate c);

/* Is a plane polygon convex?  It is when, run through once, it stays in the boundary of its convex
 * hull and comes to no point twice; it may stop (repeated points), it may go straight on (collinear
 * ones), and if it is closed its end meets its start.  So three points in order on a line are convex
 * as an open polygon, and as a closed one, which would have to go back, are not; a single point is
 * convex.  An open polygon is convex exactly when its chord closes it convexly, or it lies on a line
 * and never turns back.
 *
 * points[0 .. 2 n + 1]: R_0 ... R_n.  closed: the edge R_n R_0 belongs to the polygon.
 * orientation, which may be NULL: +1 counterclockwise, -1 clockwise, 0 on a line or not convex. */
int cagd_polygon_is_convex(int n, const cagd_num_q points[], int closed, int *orientation);

/* The vertices of the convex hull of count >= 1 points of the plane, counterclockwise from the
 * leftmost (then lowest); no three on a line, no point twice.  Their indices go to vertex, which has
 * room for count + 1; returns how many there are.  Source: andrew-1979. */
int cagd_convex_hull_2d(int count, const cagd_num_q points[], int vertex[]);

/* The sign of (Q - P) x (R - P): +1 when P, Q, R turn left. */
int cagd_turn_2d(const cagd_num_q P[2], const cagd_num_q Q[2], const cagd_num_q R[2]);
#endif
