/* statistics.h -- standard errors and rank at the minimum, and how far binary64 may be off them. */
#ifndef CERTIFY_STATISTICS_H
#define CERTIFY_STATISTICS_H

#include "proofs-tests/fit/certify/problem.h"

/* How far the answer may move when every residual is wrong by eps times the largest coordinate M and every
 * derivative by eps E:
 *     |d theta_j| <= eps condition_j,  condition_j = sum_i |(S^-1 J_i)_j| M/s_i + (|S^-1| E_i)_j |r_i|,
 *     |d F|       <= eps cost_condition + eps^2 cost_floor/2 = eps sum_i |r_i| M/s_i + eps^2/2 sum_i (M/s_i)^2,
 * S the reduced Newton matrix.  Where the cost is larger than at the minimum by dF, theta_j is off by at most
 * sqrt(2 dF) spread_j, spread_j the root of (S^-1)_jj.  And the standard errors by what the derivatives make of
 * them, and by moving with theta. */
struct statistics {
    num *condition, *spread;      /* of the varied unknowns */
    num *error, *error_condition; /* standard errors of the varied unknowns, then of the logarithms of the invariants */
    num cost_condition, cost_floor;
    num squares, chi; /* the sum of squared distances, and the same in standard deviations */
    int missing;      /* how much less the rank is than n; if it is less, there are no standard errors */
};
struct statistics statistics_of_minimum(void);

/* log I_j = log of w_j^2/(w_{j-1} w_{j+1}) as a linear form in the varied unknowns. */
void invariant_form(int j, int v[MOST]);
/* How many invariants the curve has. */
int invariants(void);
/* How many points are measured: the ends that are given are not. */
int measurements(void);
/* What the covariance (J^T J)^-1 is multiplied by: 1 or chi^2/d; for a robust loss Huber's factor, as
 * core/fit/statistics.h has it. */
num scale_squared(void);
#endif
