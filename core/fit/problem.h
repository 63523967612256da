/* problem.h -- the fit as its parts see it.
 *
 * Everything is computed in working coordinates (x - centre)/unit with a power of two as unit, so that coordinates
 * are of the order of 1.  Those of measured points are exact (无舍入), however far from the origin they lie: in each
 * coordinate the centre is 0 unless all |x| >= 3h, 2h being the widest side of the data; and then it is the middle,
 * but for half of the unit, h < unit <= 2h.  With |centre - middle| <= h and middle - h <= x <= middle + h this is
 * |centre - x| <= 2h, hence x/2 <= centre <= 2x for x >= 3h, where binary64 subtracts without rounding
 * (sterbenz-1974, 4.3).  Distances are scaled back by 1/sigma, which is in units of the working coordinates: F is
 * that of cagd_fit.h. */
#ifndef CAGD_FIT_PROBLEM_H
#define CAGD_FIT_PROBLEM_H

#include "core/fit/cagd_fit.h"
#include "core/fit/curve.h"
#include "core/fit/strategy.h"
#include "core/fit/support.h"

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
    double smooth;               /* of the smoothing term, in working coordinates                           */
    int unordered, nothing_free; /* feet alone: those of points in any order            */
    int end_point[2];            /* the measured points whose feet are the ends of the domain; -1: none */
    int degree, count;
    int period; /* of a closed curve: how many of the points are its own; 0: open        */
    double *knots;
    int unknowns;
    cagd_fit_unknown *unknown;
    fit_support support;     /* of the pieces of the curve                                     */
    cagd_fit_unknown *local; /* the unknowns of the support, `index` counted from the first point of the piece */
    double low, high;        /* bounds on the weights                                          */
    double rounding;         /* sum b_i^2, see fit_problem_cost_error                                */
    int neighbours;          /* that points in order have to be taken together, see fit_neighbours   */
} fit_problem;

/* From checked data and options.  Whatever is returned, fit_problem_free releases it. */
cagd_status fit_problem_make(const cagd_fit_data *data, const cagd_fit_options *options, const fit_strategy *strategy,
                             fit_problem *problem, int *where);
void fit_problem_free(fit_problem *problem);

/* The checked initial curve in working coordinates and in the gauge; when nothing is free with its weights as they
 * are, but for a power of two. */
void fit_problem_curve(const fit_problem *problem, const cagd_spline *given, fit_curve *curve);

/* rho(x) and *slope = rho'(x). */
double fit_problem_loss(const fit_problem *problem, double x, double *slope);

/* How many equations there are, dim-1 for a point and one more for that of an end; and how many roundings an entry of the Jacobian suffers. */
int fit_problem_equations(const fit_problem *problem);
int fit_problem_roundings(const fit_problem *problem);

/* What rounding makes of a cost: of its sum, and of the points in it.  Residuals r_i that are off by b_i, as in
 * foot.tmpl.h, change half the sum of their squares by at most sum |r_i| b_i + b_i^2/2, which by Cauchy and Schwarz
 * is at most sqrt(2 cost sum b_i^2) + sum b_i^2/2; with a robust loss by less, for rho'(r^2) r <= sqrt(rho(r^2)). */
double fit_problem_cost_error(const fit_problem *problem, double cost);

/* `rounding` and `neighbours`; to be called when the points or their precision have changed. */
void fit_problem_look_at_points(fit_problem *problem);

/* Whether the foot of point i is an end of the domain: 0 the start, 1 the end, -1 no. */
static inline int fit_end_of(const fit_problem *p, int i)
{
    return i == p->end_point[0] ? 0 : i == p->end_point[1] ? 1 : -1;
}

/* The larger of two numbers: fmax without its care for NaN, which loops over all points need not pay for. */
static inline double fit_larger(double a, double b) { return a > b ? a : b; }

/* Measured point i in working coordinates. */
static inline const double *fit_point(const fit_problem *p, int i) { return p->Q + (size_t)i * (size_t)p->dim; }

#ifdef __cplusplus
}
#endif
#endif
