/* model.h -- the objective near theta up to second order, written as linear least squares:
 *
 *     F(theta + x) = F - |y|^2/2 + |J x + y|^2/2 + ...,    J^T y = gradient,    J^T J = Hessian matrix H.
 *
 * The triangle R of the distances gives Gauss and Newton's part of H; with what they leave out, S, and R = U T, U^T U
 * = 1, T W = 1, it is T^T (1 + M) T, M = W^T S W.  M is small where the distances are, however ill-conditioned R is,
 * so that nothing of R's precision is lost:  1 + M = L L^T,  J = L^T T,  y = L^-1 U^T z.  Where 1 + M is not positive
 * definite, or |y|^2 > 2F so that the model would end below zero, L = 1: Gauss and Newton's model.
 *
 * T is R itself where R is far from losing a rank; elsewhere it is the part of R's singular value decomposition that
 * counts, rank.h. */
#ifndef CAGD_FIT_MODEL_H
#define CAGD_FIT_MODEL_H

#include "core/fit/objective.h"

typedef struct fit_model {
    int n, rank;
    double *W, *z;     /* n x rank numbers, by rows of n; U^T z: rank numbers                          */
    double *L, *y, *v; /* rank x rank numbers below the diagonal, by rows of n; rank numbers; workspace */
    double decrement;  /* |y|, Newton's: half its square is what the model promises to take off F       */
} fit_model;

/* The model at what was evaluated last; unknowns with fixed[k] != 0 are held.  Returns 0 when there is no memory. */
int fit_model_of(const fit_objective *objective, const int fixed[], fit_model *model);
void fit_model_free(fit_model *model);

/* The x with J x + y = 0 that is shortest in scaled unknowns. */
void fit_model_step(const fit_model *model, double x[]);
#endif
