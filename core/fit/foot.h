/* foot.h -- the foot of a point on a curve (垂足): where the distance |C(t) - q| is smallest. */
#ifndef CAGD_FIT_FOOT_H
#define CAGD_FIT_FOOT_H

#include "core/fit/curve.h"

/* How a foot lies.  ORTHOGONAL: C'(t) is orthogonal to q - C(t).  AT_END: t is an end of the domain, and the distance
 * would become smaller beyond it.  AT_CORNER: C has no tangent at t, a corner or a point with C' = 0. */
typedef enum fit_foot_kind { FOOT_ORTHOGONAL, FOOT_AT_END, FOOT_AT_CORNER } fit_foot_kind;

/* The foot of q that is reached from *t, which becomes it.  D: the point of the curve there and two derivatives.
 *
 * A closed curve has no end: a foot that would lie beyond the end of the domain is sought on from its start, and the other
 * way round.  Where both say that it lies beyond, it is at the seam, but for rounding. */
fit_foot_kind fit_foot(const fit_curve *curve, const double q[], double *t, double D[]);

/* The same, but for steps shorter than `limit` times the length on which the curve changes, Taylor's polynomial of
 * second order takes the place of the curve.  With FOOT_EXACT, an eighth of the cube root of the precision, that
 * makes no difference. */
#define FOOT_EXACT 0x1p-21
fit_foot_kind fit_foot_near(const fit_curve *curve, const double q[], double limit, double *t, double D[]);
#endif
