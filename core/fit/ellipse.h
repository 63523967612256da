/* ellipse.h -- the ellipse or circle that comes closest to points: whole ones, and arcs of any length (椭圆拟合).
 *
 *     E(phi) = c + a cos(phi) + b sin(phi),    the centre c, and a and b conjugate semi-diameters,
 *
 * minimises the sum of the squared orthogonal distances over s_i^2.  A rational curve of degree 2 in one segment is less than a whole
 * turn, with positive weights less than a half; this one has no such limit.  a and b may be turned by a phase without
 * changing the ellipse: of the 3 dim numbers 3 dim - 1 count, 5 in the plane and 8 in space.  A circle has |a| = |b| and a.b = 0, which
 * takes 2 away.
 *
 * Gauss and Newton's steps with Levenberg's damping, the feet being functions of the ellipse, as in objective.h.  The first
 * ellipse is an affine image of a circle: in coordinates in which the scatter of the points is the same in all directions of their
 * plane, the circle by linear least squares. */
#ifndef CAGD_FIT_ELLIPSE_H
#define CAGD_FIT_ELLIPSE_H

#include "core/fit/cagd_fit.h"

typedef struct fit_ellipse {
    int dim, circle;    /* circle: asked for one */
    double x[9];        /* c, a, b: dim numbers each; a the longer principal semi-axis, b the other one */
    double inverse[81]; /* (J^T J)^+ of x, 3 dim x 3 dim by rows, J the Jacobian of distances over s_i */
    double
        bias[9]; /* of x, for s_i the standard deviations: what errors along the curve make of it, see fit_ellipse_of */
    int unknowns; /* that count                                                         */
    int converged, iterations;
    double chi_squared; /* the sum that was minimised                                        */
    double rms;         /* of the distances themselves, which are lengths                     */
} fit_ellipse;

/* Both ellipse and circle; from: where to begin, NULL: with the first ellipse; phi: the N parameters of the feet on the ellipse, between -pi and pi.  The points are
 * finite.  Returns 0 when there is no memory.
 *
 * Bias.  A point that is off by errors of s alike in all directions is by k s^2/2 farther in the mean from a curve of curvature k, on the
 * side away from its centre: these distances b_i, over s_i, make -(J^T J)^+ J^T b of x.  Of a whole circle s^2/(2 R) of the radius, however many
 * points there are.  Source: berman-1989. */
int fit_ellipse_of(const cagd_fit_data *data, int circle, const fit_ellipse *from, fit_ellipse *ellipse, double phi[]);

/* The arc from phi0 to phi1 > phi0 as a rational curve of degree 2 whose segments are no longer than a quarter turn; a whole turn begins and
 * ends in one point.  The arrays belong to the caller: free(points) frees all.  Returns 0 when there is no memory. */
int fit_ellipse_curve(const fit_ellipse *ellipse, double phi0, double phi1, cagd_spline *curve, double **points);

/* Distances over the smallest radius of curvature, beyond which an arc has no intervals.  Errors along an arc smear its points over more of it
 * than it has, so that it seems to determine more than it does: of a third of a circle with errors of a tenth of the radius 90 to 92 % held
 * the truth, and where the ends bend inwards among the points, as of an ellipse that the circle is not, none. */
static const double FIT_BENT = 0.05;

/* The probability, by chance, of what the points say against a circle, up to which they contradict it. */
static const double FIT_NO_CIRCLE = 0.05;

#endif
