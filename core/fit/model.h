/* model.h -- the objective near theta up to second order, written as linear least squares:
 *
 *     F(theta + x) = F - |y|^2/2 + |J x + y|^2/2 + ...,    J^T y = gradient,    J^T J = Hessian matrix H.
 *
 * The triangle R = U s V^T D of the distances (D their scale, rank.h) gives Gauss and Newton's part of H; with what they leave out,
 * S, it is D V s (1 + M) s V^T D, M = s^-1 V^T D^-1 S D^-1 V s^-1.  M is small where the distances are, however ill-conditioned R is, so
 * that nothing of R's precision is lost:  1 + M = L L^T,  J = L^T s V^T D,  y = L^-1 U^T z.  Where 1 + M is not
 * positive definite, or |y|^2 > 2F so that the model would end below zero, L = 1: Gauss and Newton's model. */
#ifndef CAGD_FIT_MODEL_H
#define CAGD_FIT_MODEL_H

#include "core/fit/objective.h"
#include "core/fit/rank.h"

typedef struct fit_model {
    fit_rank rank;
    double *L, *y, *v; /* rank x rank numbers below the diagonal, by rows of n; rank numbers; workspace */
    double left;       /* |y|                                                                          */
} fit_model;

/* The model at what was evaluated last; unknowns with fixed[k] != 0 are held.  Returns 0 when there is no memory. */
int fit_model_of(const fit_objective *objective, const int fixed[], fit_model *model);
void fit_model_free(fit_model *model);

/* J by rows, rank x n, followed by zeros up to n rows. */
void fit_model_jacobian(const fit_model *model, double J[]);

/* The x with J x + y = 0 that is shortest in scaled unknowns. */
void fit_model_step(const fit_model *model, double x[]);
#endif
