/* unknowns.h -- the unknowns x in which a curve is varied, and the curve.
 *
 * x is counted from a curve nearby, the base, with weights b_j and points B_j.  It holds w_j (P_j - B_j) for the
 * coordinates of a point, and y_j with w_j = b_j phi(y_j) for a weight, where phi(y) is 1 + y from -1/2 on, and
 * positive below it, too.  A homogeneous curve is linear in such x: a direction in which the curve nearly stays where
 * it is is straight, while in theta, the logarithms of weights and the points, it is bent. */
#ifndef CAGD_FIT_UNKNOWNS_H
#define CAGD_FIT_UNKNOWNS_H

#include "core/fit/problem.h"

#ifdef __cplusplus
extern "C" {
#endif

/* x to curve, whose weights are put between the bounds; and back. */
void fit_unknowns_to_curve(const fit_problem *problem, const fit_curve *base, const double x[], fit_curve *curve);
void fit_unknowns_of_curve(const fit_problem *problem, const fit_curve *base, const fit_curve *curve, double x[]);

/* phi'(y), and phi''(y)/phi'(y). */
double fit_weight_slope(double y);
double fit_weight_bend(double y);

/* The bounds on x that those on the weights are, infinite for none. */
void fit_unknowns_bounds(const fit_problem *problem, const fit_curve *base, double low[], double high[]);

/* Whether unknown k of the curve is a weight that stands on a bound. */
int fit_unknown_is_on_bound(const fit_problem *problem, int k, const fit_curve *curve);

#ifdef __cplusplus
}
#endif
#endif
