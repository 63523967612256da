/* ceres.h -- what the fit asks of Ceres, and of Eigen, which comes with it.  Nothing is printed and nothing is thrown; a
 * function that returns an int returns 0 when there was no memory. */
#ifndef CAGD_FIT_CERES_H
#define CAGD_FIT_CERES_H

#include "core/fit/problem.h"

#ifdef __cplusplus
extern "C" {
#endif

/* residuals[rows] at theta and, unless it is NULL, the Jacobian, rows x unknowns by rows.  0: theta has none. */
typedef int (*fit_function)(void *context, const double theta[], double residuals[], double jacobian[]);

typedef struct fit_outcome {
    cagd_fit_termination termination;
    int iterations, steps;
    cagd_fit_step *history; /* malloc */
    char message[256];
} fit_outcome;

/* Minimises half the sum of squares from theta, which becomes the minimum; low and high are bounds, infinite for none.
 * *radius is that of the trust region, at the start and at the end. */
int fit_minimise(int unknowns, int rows, fit_function function, void *context, const double low[], const double high[],
                 double tolerance, int max_iterations, double theta[], double *radius, fit_outcome *outcome);

/* The same minimum as one Ceres problem of all unknowns: theta and a foot for every point, derivatives by their formulas,
 * default options but for tolerance and number of iterations. */
int fit_minimise_plain(const fit_problem *problem, const fit_curve *curve, double tolerance, int max_iterations,
                       double theta[], double feet[], fit_outcome *outcome);

/* a = U diag(s) V^T for n x n numbers by rows; s decreasing; U and V by rows.  All 0 when an
 * entry of a is not a number. */
int fit_svd(int n, const double a[], double U[], double s[], double V[]);

#ifdef __cplusplus
}
#endif
#endif
