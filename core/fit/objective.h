/* objective.h -- the cost as a function of theta alone, the feet being functions of theta.
 *
 * With the feet t_i(theta) the derivative of a distance needs no derivative of its foot, because it is smallest there:
 * point i gives one residual n . (Q_i - C)/s_i for each direction n orthogonal to the curve, with the row
 *
 *     -(n . dC/dtheta)/s_i,    dC/dlog w_j = R_j (P_j - C),    dC/dP_j = R_j e,     R_j = N_j w_j / sum N w,
 *
 * and all directions where the foot is held, at an end of the domain or in a corner.  This is the Jacobian of all unknowns with
 * those of the feet eliminated, its Schur complement; the gradient of F is exact.  A robust loss multiplies residual and
 * row with sqrt(rho').
 *
 * The rows are taken in as they come; Ceres sees their triangle (R z; 0 e), e such that the cost is F:
 * unknowns+1 residuals, whatever the number of points. */
#ifndef CAGD_FIT_OBJECTIVE_H
#define CAGD_FIT_OBJECTIVE_H

#include "core/fit/feet.h"
#include "core/fit/problem.h"
#include "core/fit/reduction.h"

typedef struct fit_objective {
    const fit_problem *problem;
    fit_curve *curve; /* of the accepted theta, or of the one that is tried                         */
    fit_reduction *rows;
    double *feet, *theta;         /* accepted: the feet on the way to any other theta start here                */
    double *new_feet, *new_theta; /* of the last evaluation                                                */
    double *triangle;             /* of that one: (unknowns+1)^2                                                */
    double limit;                 /* of fit_foot_near                                                           */
    double cost;
    int evaluated; /* whether there was one                                                      */
} fit_objective;

/* Empty; feet and theta are to be filled in.  NULL when there is no memory. */
fit_objective *fit_objective_new(const fit_problem *problem);
void fit_objective_free(fit_objective *objective); /* NULL is allowed */

/* triangle, cost and new_feet at theta.  weighted 0: rows of the distances themselves, as for squares. */
void fit_objective_evaluate(fit_objective *objective, const double theta[], int weighted);

/* The same, weighted, unless theta is what was evaluated last. */
void fit_objective_at(fit_objective *objective, const double theta[]);

/* What was evaluated last becomes what is accepted. */
void fit_objective_accept(fit_objective *objective);

/* As Ceres asks, a fit_function: residuals[unknowns+1] and, unless it is NULL, the Jacobian by rows; where this is asked for,
 * theta is accepted. */
int fit_objective_residuals(void *objective, const double theta[], double residuals[], double jacobian[]);
#endif
