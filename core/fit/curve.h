/* curve.h -- the curve of a fit: a spline together with the homogeneous Bézier points of its pieces, from which its points
 * and derivatives are computed quickly. */
#ifndef CAGD_FIT_CURVE_H
#define CAGD_FIT_CURVE_H

#include "core/api/cagd.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fit_curve {
    cagd_spline spline;       /* with weights, which are positive                        */
    int period;               /* of a closed curve: point i+period is point i; 0: open   */
    double *points, *weights; /* those of the spline, to be changed                      */
    int pieces, *span;        /* of each piece: u_span < u_{span+1}                      */
    double *begin, *inverse;  /* of each piece: u_span, 1/(u_{span+1} - u_span)          */
    double *bezier;           /* (p+1)(dim+1) homogeneous coordinates of each piece      */
    double *choose;           /* binomial coefficients of p-1                            */
} fit_curve;

/* NULL when there is no memory.  The points are 0, the weights 1.  A closed curve (闭曲线) has count = period + degree
 * points, and knots with u_{i+period} = u_i + (end - start). */
fit_curve *fit_curve_new(int degree, int count, int period, int dim, const double knots[]);
void fit_curve_free(fit_curve *curve); /* NULL is allowed */

/* Points and weights of one curve become those of another of the same shape. */
void fit_curve_copy(fit_curve *to, const fit_curve *from);

/* To be called after the points or the weights have changed; of a closed curve the first `period` ones are taken. */
void fit_curve_update(fit_curve *curve);

static inline double fit_curve_start(const fit_curve *c) { return c->spline.knots[c->spline.degree]; }
static inline double fit_curve_end(const fit_curve *c) { return c->spline.knots[c->spline.count]; }

/* Which of the points of a piece point `index` of the curve is, 0, ..., p; -1 for none. */
static inline int fit_curve_place(const fit_curve *c, int index, int piece)
{
    int m = index - c->span[piece] + c->spline.degree;
    if (c->period > 0 && m < 0)
        m += c->period;
    return m >= 0 && m <= c->spline.degree ? m : -1;
}

/* The piece that contains t; at a knot the one on its right. */
int fit_curve_piece(const fit_curve *curve, double t);

/* D: the point and the first two derivatives at t, 3 rows of dim coordinates. */
void fit_curve_derivatives(const fit_curve *curve, double t, double D[]);

/* P: the point at t, the same as in D. */
void fit_curve_point(const fit_curve *curve, double t, double P[]);

/* R[m] = N_i w_i / sum N w at t, i = span-p+m, m = 0, ..., p: what the point moves with point i; and dR/dt. */
void fit_curve_shares(const fit_curve *curve, int piece, double t, double R[], double slopes[]);

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
