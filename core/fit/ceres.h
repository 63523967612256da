/* ceres.h -- what the fit asks of Ceres, and of Eigen, which comes with it.
 *
 * Nothing is printed, nothing is thrown, and nothing global is written, so that any number of threads may call at the
 * same time. A function that returns an int returns 0 when there was no memory. */
#ifndef CAGD_FIT_CERES_H
#define CAGD_FIT_CERES_H

#include "core/fit/cagd_fit.h"

#ifdef __cplusplus
extern "C" {
#endif

/* residuals[rows] and the Jacobian, rows x unknowns by rows, at x.  Returns 0 where the residuals are not defined. */
typedef int (*fit_residuals)(void *context, const double x[], double residuals[], double jacobian[]);

/* Half the sum of squares of the residuals, to be minimised within bounds, which are infinite where there are none. */
typedef struct fit_least_squares {
    int unknowns, rows;
    fit_residuals residuals;
    void *context;
    const double *low, *high;
} fit_least_squares;

/* What a run of the minimiser did. */
typedef struct fit_outcome {
    cagd_fit_termination termination;
    int iterations, steps;
    cagd_fit_step *history; /* malloc */
    char message[256];
} fit_outcome;

/* Minimises from x, which becomes the minimum, until a step gains less than `tolerance` of the sum.  *radius is that
 * of the trust region, at the start and at the end. */
int fit_minimise(const fit_least_squares *problem, double tolerance, int max_iterations, double x[], double *radius,
                 fit_outcome *outcome);

/* a = U diag(s) V^T for n x n numbers by rows; s decreasing; U and V by rows.  All are 0 when an entry of a is not a
 * number. */
int fit_svd(int n, const double a[], double U[], double s[], double V[]);

#ifdef __cplusplus
}
#endif
#endif
