/* spline.h -- the exact curve: Bézier, rational Bézier, B-spline and NURBS curves with rational knots, points and weights.
 *
 *     s(t) = sum N_{i,p}(t) R_i,   or with weights   R(t) = sum N_{i,p}(t) w_i R_i / w(t),   w(t) = sum N_{i,p}(t) w_i,
 *
 * as cagd_spline of cagd.h, but exactly: every function below answers for the curve itself, without rounding.
 *
 * Memory.  No pointer may be NULL but weights.  The arguments are only read; results are made in the region of the thread and
 * live as long as it does.  Status.  Results are written only with CAGD_OK.  NO_MEMORY when the region has no room
 * for a result, which sets its fault MEMORY; no other fault is set. */
#ifndef CAGD_EXACT_CURVE_SPLINE_H
#define CAGD_EXACT_CURVE_SPLINE_H

#include "core/api/cagd.h"
#include "exact/number/rational.h"

/* degree p, 0 <= p <= CAGD_MAX_DEGREE; count n > p; 1 <= dim <= CAGD_MAX_DIM; n+p+1 knots; coordinate c of point i is
 * points[i*dim + c]; weights NULL: none.  The domain is [u_p, u_n]. */
typedef struct cagd_spline_q {
    int degree, count, dim;
    const cagd_num_q *knots, *points, *weights;
} cagd_spline_q;

/* Whether the curve is one, which all other functions take for granted: DEGREE, DIMENSION, COUNT, KNOTS_...; *where is the
 * index of the knot that is meant, or -1. */
cagd_status cagd_spline_check_q(const cagd_spline_q *spline, int *where);

/* derivatives[(order+1)*dim]: row k is the k-th derivative at t, at a knot from the given side.  ORDER unless 0 <= order <=
 * CAGD_MAX_DEGREE; OUTSIDE_DOMAIN; UNDEFINED where the total weight is 0. */
cagd_status cagd_spline_derivatives_q(const cagd_spline_q *spline, cagd_num_q t, cagd_side side, int order,
                                      cagd_num_q *derivatives);

/* The square of the curvature at t, dim 2 or 3.  As for the derivatives, and UNDEFINED where the first one is 0. */
cagd_status cagd_spline_curvature_squared_q(const cagd_spline_q *spline, cagd_num_q t, cagd_side side,
                                            cagd_num_q *curvature_squared);

/* *turn: to which side the curve turns at t, dim 2: the sign of det(R', R''), 1 to the left.  As for the derivatives, and
 * UNDEFINED where R' is 0. */
cagd_status cagd_spline_turn_q(const cagd_spline_q *spline, cagd_num_q t, cagd_side side, int *turn);

/* The torsion at t, dim 3.  As for the derivatives, and UNDEFINED where the first two are linearly dependent. */
cagd_status cagd_spline_torsion_q(const cagd_spline_q *spline, cagd_num_q t, cagd_side side, cagd_num_q *torsion);

/* Whether the total weight vanishes somewhere in the domain; decided on every span. */
int cagd_spline_has_poles_q(const cagd_spline_q *spline);

/* The same curve with one knot x more, u_p <= x < u_n.  OUTSIDE_DOMAIN; KNOTS_MULTIPLE when x is a knot p+1 times.  Here and
 * below: UNDEFINED when point *where of the result would have the weight 0; otherwise *where is -1 unless said. */
cagd_status cagd_spline_insert_q(const cagd_spline_q *spline, cagd_num_q x, cagd_spline_q *result, int *where);

/* The same curve with one copy of the inner knot x less.  NO_KNOT; CHANGES when that is another curve. */
cagd_status cagd_spline_remove_q(const cagd_spline_q *spline, cagd_num_q x, cagd_spline_q *result, int *where);

/* The same curve in degree p+1.  DEGREE when p is CAGD_MAX_DEGREE. */
cagd_status cagd_spline_elevate_q(const cagd_spline_q *spline, cagd_spline_q *result, int *where);

/* The same curve in degree p-1.  DEGREE when p is 0; CHANGES when it is not of that degree, on the segment of span *where. */
cagd_status cagd_spline_reduce_q(const cagd_spline_q *spline, cagd_spline_q *result, int *where);

/* The parts on the left and on the right of t, u_p < t < u_n.  OUTSIDE_DOMAIN.  *where is an index in one of the parts. */
cagd_status cagd_spline_split_q(const cagd_spline_q *spline, cagd_num_q t, cagd_spline_q *left, cagd_spline_q *right,
                                int *where);

/* The segment of a span as a curve of p+1 points over its own interval [u_span, u_{span+1}].  OUTSIDE_DOMAIN unless
 * u_span < u_{span+1} are in the domain. */
cagd_status cagd_spline_segment_q(const cagd_spline_q *spline, int span, cagd_spline_q *segment, int *where);
#endif
