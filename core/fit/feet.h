/* feet.h -- the search for the feet of all points on a curve. */
#ifndef CAGD_FIT_FEET_H
#define CAGD_FIT_FEET_H

#include "core/fit/foot.h"
#include "core/fit/problem.h"

/* Whether the foot of point i is held at an end of the domain; then *t is that end, and D the curve there and two
 * derivatives. */
int fit_held_foot(const fit_problem *problem, const fit_curve *curve, int i, double *t, double D[]);

/* The feet t of all points, found without knowledge of earlier ones, and *cost, half the sum of their losses.  Points
 * in any order: the nearest point of the curve for each.  Points in order along the curve: on a polygon inscribed in
 * the curve the feet, not decreasing, with the smallest sum of losses, and from there the feet on the curve.  Returns
 * 0 when there is no memory. */
int fit_feet_search(const fit_problem *problem, const fit_curve *curve, double t[], double *cost);

/* The same on the polygon alone: where to look for the feet. */
int fit_feet_guess(const fit_problem *problem, const fit_curve *curve, double t[]);

/* The search for a curve on which the feet of all points are known: t, the feet that the search prefers, and *gain,
 * by how much they lower half the sum of losses. */
int fit_feet_improve(const fit_problem *problem, const fit_curve *curve, const double known[], double t[],
                     double *gain);
#endif
