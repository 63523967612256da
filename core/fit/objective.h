/* objective.h -- the cost as a function of the curve alone, the feet being functions of it.
 *
 * With the feet t_i(x) the derivative of a distance needs no derivative of its foot, because it is smallest there:
 * point i gives one residual n . (Q_i - C)/s_i for each direction n orthogonal to the curve, with the row
 *
 *     -(n . dC/dx)/s_i,    dC/dw_j = N_j (B_j - C)/sum N w,    dC/d(w_j (P_j - B_j)) = N_j e/sum N w,
 *
 * x as in unknowns.h, and one residual for each of all directions where the foot is held, at an end of the domain or in a corner.  This is the
 * Jacobian of all unknowns with those of the feet eliminated, its Schur complement; the gradient of F is exact.  A
 * robust loss multiplies residual and row with sqrt(rho').
 *
 * The rows are taken in as they come and kept as their triangle (R z), whatever the number of points.  What R^T R
 * lacks of the Hessian matrix of F is summed up beside it: model.h makes one least-squares problem of both. */
#ifndef CAGD_FIT_OBJECTIVE_H
#define CAGD_FIT_OBJECTIVE_H

#include "core/fit/curvature.h"
#include "core/fit/feet.h"
#include "core/fit/problem.h"
#include "core/fit/reduction.h"

/* What is evaluated: cost and feet alone; with the rows of the distances themselves, as for squares, and without the
 * smoothing term; or with those of the cost, and its curvature where it is asked for. */
typedef enum fit_extent { FIT_COST, FIT_DISTANCES, FIT_ROWS } fit_extent;

typedef struct fit_objective {
    const fit_problem *problem;
    fit_curve *base;  /* from which x is counted, unknowns.h                              */
    fit_curve *curve; /* at the x that was evaluated last                                 */
    double *inverse;  /* one over the weights of that curve                               */
    /* What was accepted.  The feet of every other x are sought from these. */
    double *x, *feet, accepted; /* accepted: the cost there                               */
    /* What was evaluated last. */
    int evaluated; /* whether there was anything                                          */
    double *new_x, *new_feet, cost;
    double *triangle;  /* (R z), (unknowns+1)^2 numbers by rows                           */
    double *curvature; /* the Hessian matrix less R^T R, unknowns^2 numbers               */
    /* How the next x is evaluated. */
    int newton;   /* whether the curvature is summed up, or stays what it was             */
    double limit; /* of fit_foot_near                                                     */
    int width;    /* of the vectors of batch.h                                            */
    fit_reduction *rows;
    fit_curvature *second;
} fit_objective;

/* Evaluated nowhere.  NULL when there is no memory. */
fit_objective *fit_objective_new(const fit_problem *problem);
void fit_objective_free(fit_objective *objective); /* NULL is allowed */

/* Evaluates and accepts a curve, which becomes the base, with its weights put between the bounds and feet to start
 * from. */
void fit_objective_begin(fit_objective *objective, const fit_curve *curve, const double feet[]);

/* Puts a curve there in the same way and accepts it, but evaluates cost and feet alone: there is no triangle.  Returns the cost. */
double fit_objective_cost(fit_objective *objective, const fit_curve *curve, const double feet[]);

/* Evaluates cost and feet at x and, as `extent` says, triangle and, if `newton`, curvature. */
void fit_objective_evaluate(fit_objective *objective, const double x[], fit_extent extent);

/* The same with FIT_ROWS; nothing is done when x is what was evaluated last. */
void fit_objective_at(fit_objective *objective, const double x[]);

/* What was evaluated last becomes what is accepted. */
void fit_objective_accept(fit_objective *objective);

/* Makes the columns of the triangle, from those by x, those by theta, log w_j and P_j; it is none any more. */
void fit_objective_by_theta(fit_objective *objective);

/* Component k of the gradient of F, R^T z. */
double fit_objective_gradient(const fit_objective *objective, int k);
#endif
