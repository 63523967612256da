/* knots.h -- the inner knots of a spline (节点), and a spline on other knots.
 *
 * A polynomial spline of degree p has over each span a polar form f, symmetric and affine in each of p arguments, with C(t) = f(t, ..., t);
 * over the knots u the points of the segment [u_mu, u_mu+1] are f(u_i+1, ..., u_i+p), i = mu-p, ..., mu.  So the points over other knots v are
 * f(v_j+1, ..., v_j+p), f that of a span which P_j moves.  f(a_1, ..., a_p) by de Boor's recursion with another argument in every step:
 *
 *     d_i <- d_i + (a_r - u_i+r)/(u_i+p+1 - u_i+r) (d_i+1 - d_i),    r = 1, ..., p, i = mu-p, ..., mu-r.
 *
 * Source: ramshaw-1989. */
#ifndef CAGD_FIT_KNOTS_H
#define CAGD_FIT_KNOTS_H

#include "core/api/cagd.h"

enum { FIT_MOST_KNOTS = 120 }; /* inner knots; one more of a closed curve's segments */

/* Inner knots between 0 and 1, increasing; of a closed curve also 0, the seam, which is not among them. */
typedef struct fit_knots {
    int inner;
    double u[FIT_MOST_KNOTS + 1];
} fit_knots;

/* How many control points a curve has over them; those of a closed one once. */
int fit_knots_count(const fit_knots *k, int degree, int closed);

/* All knots, as cagd_fit takes them: count + p + 1, clamped; of a closed curve count + 2p + 1, periodic. */
void fit_knots_spell(const fit_knots *k, int degree, int closed, double U[]);

/* Those of segments of one length. */
void fit_knots_even(int inner, fit_knots *k);

/* One more, where there is room. */
void fit_knots_insert(fit_knots *k, double u);

/* The knots without knot i; the one before it (shift & 1) and the one behind it (shift & 2), which are there, are moved half the way to where it
 * was. */
fit_knots fit_knots_without(const fit_knots *from, int i, int shift);

/* The points of a polynomial spline on other knots, count of them in `to`, where every span of the new knots that lies in one of the old ones
 * has the old curve; elsewhere near it.  Period: of the old curve, 0 when open. */
void fit_respace(const cagd_spline *from, int period, const double knots[], int count, double to[]);
#endif
