/* feet.h -- the feet of points on a curve (垂足): where the distance |C(t) - Q| is smallest. */
#ifndef CAGD_FIT_FEET_H
#define CAGD_FIT_FEET_H

#include "core/fit/problem.h"

/* How a foot lies: C'(t) is orthogonal to Q - C(t); t is an end of the domain and the distance would become smaller beyond;
 * t is where C has no tangent, a corner or a point with C' = 0. */
typedef enum fit_foot_kind { FOOT_ORTHOGONAL, FOOT_AT_END, FOOT_AT_CORNER } fit_foot_kind;

/* The foot of q that is reached from *t, which becomes it.  D: the point of the curve there and two derivatives. */
fit_foot_kind fit_foot(const fit_curve *curve, const double q[], double *t, double D[]);

/* The same with Taylor's polynomial of second order in place of the curve for steps shorter than `limit` times the length on
 * which the curve changes; FOOT_EXACT, an eighth of the cube root of the precision, makes no difference. */
#define FOOT_EXACT 0x1p-21
#define FOOT_ROUGH 0x1p-8 /* for the way to the minimum */
fit_foot_kind fit_foot_near(const fit_curve *curve, const double q[], double limit, double *t, double D[]);

/* The feet t of all points, found without knowledge of earlier ones, and *cost, half the sum of their losses.  Points in any
 * order: the nearest point of the curve for each.  Points in order along the curve: on a polygon inscribed in the curve
 * the feet, not decreasing, with the smallest sum of losses, and from there the feet on the curve.  Returns 0 when there
 * is no memory. */
int fit_feet_search(const fit_problem *problem, const fit_curve *curve, double t[], double *cost);

/* The same on the polygon alone: where to look for the feet. */
int fit_feet_guess(const fit_problem *problem, const fit_curve *curve, double t[]);

/* The search for a curve on which the feet of all points are known: t, the feet that the search prefers, and *gain, by how much they lower
 * half the sum of losses. */
int fit_feet_improve(const fit_problem *problem, const fit_curve *curve, const double known[], double t[],
                     double *gain);
#endif
