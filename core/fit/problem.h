/* problem.h -- the fit as its parts see it.
 *
 * Everything is computed in working coordinates (x - centre)/unit with a power of two as unit, so that coordinates are of
 * the order of 1.  Those of measured points are exact (无舍入), however far from the origin they lie: in each coordinate the centre is
 * 0 unless all |x| >= 3h, 2h being the widest side of the data; and then it is the middle, but for half of the unit, h < unit <= 2h.
 * With |centre - middle| <= h and middle - h <= x <= middle + h this is |centre - x| <= 2h, hence x/2 <= centre <= 2x for x >= 3h,
 * where binary64 subtracts without rounding (sterbenz-1974, 4.3).  Distances
 * are scaled back by 1/sigma, which is in units of the working coordinates: F is that of cagd_fit.h. */
#ifndef CAGD_FIT_PROBLEM_H
#define CAGD_FIT_PROBLEM_H

#include "core/fit/cagd_fit.h"
#include "core/fit/curve.h"
#include "core/fit/strategy.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fit_problem {
    const cagd_fit_options *options; /* the caller's                                                  */
    fit_strategy strategy;
    int points, dim;
    double *Q;         /* the measured points in working coordinates                     */
    double *precision; /* 1/sigma of each                                                */
    double centre[3], unit;
    double size; /* no coordinate of Q is larger; at least 2                              */
    cagd_fit_loss loss;
    double loss_scale;
    int unordered, nothing_free; /* feet alone: those of points in any order            */
    int degree, count;
    double *knots;
    int unknowns;
    cagd_fit_unknown *unknown;
    int *first, *reach;     /* of each piece, the unknowns its rows reach; see reduction.h    */
    cagd_fit_unknown *slot; /* the same unknowns, `index` counted from the first point of the piece */
    double low, high;       /* bounds on the weights                                          */
    double rounding;        /* sum b_i^2, see fit_problem_cost_error                                */
} fit_problem;

/* From checked data and options.  Whatever is returned, fit_problem_free releases it. */
cagd_status fit_problem_make(const cagd_fit_data *data, const cagd_fit_options *options, const fit_strategy *strategy,
                             fit_problem *problem, int *where);
void fit_problem_free(fit_problem *problem);

/* The checked initial curve in working coordinates and in the gauge; when nothing is free with its weights as they are, but for a power of two. */
void fit_problem_curve(const fit_problem *problem, const cagd_spline *given, fit_curve *curve);

/* x to curve and back: x holds w_j (P_j - B_j) for the coordinates of a point and y_j, w_j = b_j phi(y_j), for a weight, b_j and
 * B_j being weight and point of the base, a curve nearby.  phi(y) is 1 + y, or positive all the same below -1/2.  A homogeneous
 * curve is linear in such x: a change of the unknowns that leaves the curve nearly where it is leads straight on, while in theta its
 * way is bent. */
void fit_problem_set(const fit_problem *problem, const fit_curve *base, const double x[], fit_curve *curve);
void fit_problem_get(const fit_problem *problem, const fit_curve *base, const fit_curve *curve, double x[]);

/* phi'(y), and phi''(y)/phi'(y). */
double fit_problem_slope(double y);
double fit_problem_bend(double y);

/* Curve to theta, log w_j and P_j, and back; weights are put between the bounds. */
void fit_problem_theta(const fit_problem *problem, const fit_curve *curve, double theta[]);
void fit_problem_curve_of(const fit_problem *problem, const double theta[], fit_curve *curve);

/* rho(x) and *slope = rho'(x). */
double fit_problem_loss(const fit_problem *problem, double x, double *slope);

/* How many equations there are, and how many roundings an entry of the Jacobian suffers. */
int fit_problem_equations(const fit_problem *problem);
int fit_problem_roundings(const fit_problem *problem);

/* Bounds on x, infinite for none, and whether unknown k of the curve is a weight that stands on one. */
void fit_problem_bounds(const fit_problem *problem, const fit_curve *base, double low[], double high[]);
int fit_problem_on_bound(const fit_problem *problem, int k, const fit_curve *curve);

/* What rounding makes of a cost: of its sum, and of the points in it, as in fit_foot.  Residuals r_i that are off by b_i change
 * half the sum of their squares by at most sum |r_i| b_i + b_i^2/2, by Cauchy and Schwarz at most sqrt(2 cost sum b_i^2) + sum b_i^2/2;
 * with a robust loss by less, for rho'(r^2) r <= sqrt(rho(r^2)). */
double fit_problem_cost_error(const fit_problem *problem, double cost);

/* Sums the b_i^2: to be called when the points or their precision have changed. */
void fit_problem_update_errors(fit_problem *problem);

/* Measured point i in working coordinates. */
static inline const double *fit_point(const fit_problem *p, int i) { return p->Q + (size_t)i * (size_t)p->dim; }

#ifdef __cplusplus
}
#endif
#endif
