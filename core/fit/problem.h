/* problem.h -- the fit as its parts see it.
 *
 * Everything is computed in working coordinates (x - centre)/unit with a power of two as unit, so that coordinates are of
 * the order of 1; the centre is 0 where the data surround or touch the origin, and few bits long elsewhere.  Distances
 * are scaled back by 1/sigma, which is in units of the working coordinates: F is that of cagd_fit.h. */
#ifndef CAGD_FIT_PROBLEM_H
#define CAGD_FIT_PROBLEM_H

#include "core/fit/cagd_fit.h"
#include "core/fit/curve.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fit_problem {
    int points, dim;
    double *Q;         /* the measured points in working coordinates                     */
    double *precision; /* 1/sigma of each                                                */
    double centre[3], unit;
    cagd_fit_loss loss;
    double loss_scale;
    int unordered;
    int degree, count;
    double *knots;
    int unknowns;
    cagd_fit_unknown *unknown;
    int *first, *reach;     /* of each piece, the unknowns its rows reach; see reduction.h    */
    cagd_fit_unknown *slot; /* the same unknowns, `index` counted from the first point of the piece */
    double low, high;       /* bounds on the logarithms of weights                            */
} fit_problem;

/* theta to curve and back. */
void fit_problem_set(const fit_problem *problem, const double theta[], fit_curve *curve);
void fit_problem_get(const fit_problem *problem, const fit_curve *curve, double theta[]);

/* rho(x) and *slope = rho'(x). */
double fit_problem_loss(const fit_problem *problem, double x, double *slope);

/* |a - b|^2 */
static inline double fit_distance_squared(int dim, const double a[], const double b[])
{
    double sum = 0;
    for (int c = 0; c < dim; c++)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

#ifdef __cplusplus
}
#endif
#endif
