/* stationary.h -- is a fitted curve stationary?  A check in intervals, after the fact.
 *
 * A minimiser in binary64 ends somewhere.  Here its end is taken as exact numbers: theta_0 the unknowns, P and w the
 * points and weights, t_i the feet; and it is decided whether the sum of squared distances F(theta) has a stationary
 * point (驻点) near theta_0.  Nothing of the minimiser is used.
 *
 *     foot        For all theta of a box the foot t_i(theta), where phi = (C - Q_i).C' = 0, exists and is the only
 *                 one in an interval T_i, with phi' > 0, so that it is a nearest point in T_i: Newton's operator
 *                 t_i - phi(t_i, box)/phi'(T_i, box) lies in the interior of T_i.  At an end of the domain the sign
 *                 of phi over the box says that the foot stays there; when the box leaves open whether the foot is
 *                 at the end or inside, both cases are enclosed.
 *                 The feet of the points of measured ends are those ends, whatever the sign of phi is.
 *     gradient    of F: by the envelope theorem sum_i rho'(s_i)/sigma_i^2 D_i.C_a, D_i = C(t_i) - Q_i,
 *                 s_i = |D_i|^2/sigma_i^2.
 *     Hessian     sum_i rho'/sigma_i^2 (C_a.C_b + D.C_ab - (C_a.C' + D.C_a')(C_b.C' + D.C_b')/phi')
 *                 + 2 rho''/sigma_i^4 D.C_a D.C_b, without the quotient where the foot stays at an end; C_a.C_b less the quotient
 *                 is computed as what of them is across the curve.  Where rho''
 *                 or a second derivative by t jumps, or a foot comes to an end, the gradient is still Lipschitz, and
 *                 the hull of both values is taken: that is enough for the mean value theorem that follows.
 *     Krawczyk    theta = theta_0 + W y, with W chosen such that S W^T H W is nearly 1, S a diagonal of signs.  If
 *                 q = max-norm of 1 - S W^T H(box) W < 1 and eta = max-norm of W^T g(theta_0) < (1-q) r, there is
 *                 exactly one stationary point with |y| <= r, and it has |y| <= eta/(1-q).  When all signs are +,
 *                 the Hessian is positive definite over the box, and the point is a strict local minimum.  When that
 *                 fails at theta_0 itself, it is tried again at the end of a step of Newton's method; what is
 *                 reported are distances from theta_0.
 *
 *     bounds      Unknowns that are held are left out.  On a bound F need not be stationary; it has to grow towards the
 *                 inside: the derivative of F by that unknown, the multiplier (乘子), is enclosed over |y| <= eta/(1-q),
 *                 where the stationary point is.  When it grows from every bound and all signs are +, the point is a
 *                 strict local minimum among all curves within the bounds: a step that leaves bounds adds a term of
 *                 first order, one that does not adds the positive one of second order.
 *
 *     smoothing   lambda/2 integral |S''|^2 is added to F, of which the matrix follows without quadrature: S'' of a span in
 *                 Bernstein polynomials of degree m = p-2, whose products have the integrals C(m,i) C(m,j)/((2m+1) C(2m,i+j)).
 *     closed      The points of a closed curve that are one unknown move together.  The spans at the seam stand on both sides of the
 *                 domain once more, so that no foot is at an end.
 *
 * Along free directions F is flat, no stationary point is alone; then W spans a complement of these directions, and
 * what is said is said of the curves theta_0 + W y.
 *
 * The local claim is all: another foot may be nearer, another minimum lower.
 * Source: krawczyk-1969; moore-kearfott-cloud-2009, 8. */
#ifndef CAGD_STATIONARY_H
#define CAGD_STATIONARY_H

#include "core/fit/cagd_fit.h"

/* HELD: left out.  AT_LOW, AT_HIGH: held because it stands on a bound, which is below, or above, all others that are
 * allowed. */
enum cagd_stationary_hold {
    CAGD_STATIONARY_FREE,
    CAGD_STATIONARY_HELD,
    CAGD_STATIONARY_AT_LOW,
    CAGD_STATIONARY_AT_HIGH
};

/* Everything is read only; points, weights, feet in the order of cagd_fit_data and cagd_spline. */
typedef struct cagd_stationary_problem {
    const cagd_fit_data *data;
    cagd_fit_loss loss;
    double loss_scale;
    double smooth;            /* lambda of the smoothing term; 0: none                              */
    const cagd_spline *curve; /* weights NULL: all 1                                                 */
    int period, shift; /* of a closed curve: point i is number i - shift, modulo the period, of its own; 0, 0: open */
    const double *feet;
    const int *end_points; /* the two points whose feet are held at the ends of the domain, -1 for none; NULL: none */
    int unknowns;
    const cagd_fit_unknown *unknown;
    const int *held; /* a stationary_hold of each unknown; NULL: all are free                      */
    int free_count;
    const double *free_directions; /* free_count x unknowns, linearly independent; NULL when there are none */
} cagd_stationary_problem;

/* What F does when the unknowns leave their bounds.  GROWS: it grows, whichever does.  FALLS: there is one with
 * which it falls.  OPEN: of none that is known, but of one the sign is not. */
enum cagd_stationary_bounds {
    CAGD_STATIONARY_NO_BOUNDS,
    CAGD_STATIONARY_GROWS,
    CAGD_STATIONARY_FALLS,
    CAGD_STATIONARY_OPEN
};

typedef struct cagd_stationary_verdict {
    int verified;  /* 1: exactly one stationary point, as said above                                   */
    int minimum;   /* 1: it is a strict local minimum, within the bounds                               */
    int dimension; /* of the space in which that was decided: unknowns not held, less free directions */
    double weight_radius, point_radius; /* the stationary point is no farther away than this in the logarithm of any
                                           weight, and in any coordinate; rounded up                       */
    double weight_alone, point_alone;   /* a stationary point that is no farther away than this is that one;
                                           rounded down, 0 where nothing is said                           */
    enum cagd_stationary_bounds bounds; /* NO_BOUNDS also when not verified                                     */
    int bound;          /* the unknown at whose bound F falls, or the sign is not known; otherwise -1                */
    int where;          /* index of the measured point that the reason is about, or -1                     */
    const char *reason; /* why not verified, a sentence without full stop; NULL when verified; static     */
} cagd_stationary_verdict;

cagd_stationary_verdict cagd_stationary_check(const cagd_stationary_problem *problem);

/* The same of the result of a fit, from its origin: the coordinates of which the verdict speaks are `relative`. */
cagd_stationary_verdict cagd_stationary_check_fit(const cagd_fit_data *data, const cagd_fit_options *options,
                                                  const cagd_fit_result *result);

/* Whether the feet are the nearest points of the whole curve, which is what is left to verify where nothing is free.  Branch and bound:
 * the curve is divided until each part is known to come no nearer to the point than its foot does, but for an excess that is
 * at most 2^-44 of the size of points and curve.  Corners, cusps, ends of the curve, and points that are as near to two places are no
 * exceptions; a point that is as near to a whole arc is one, and is left undecided. */
typedef struct cagd_nearest_verdict {
    int verified;       /* 1: no point of the curve is nearer to any measured point than its foot, but for `excess` */
    int refuted;        /* 1: some point of it is nearer to point `where`, by more than 2^-44 of the size            */
    double excess;      /* rounded up                                                                         */
    int where;          /* index of the measured point that the reason is about, or -1                        */
    const char *reason; /* why not verified, a sentence without full stop; NULL when verified; static         */
} cagd_nearest_verdict;

cagd_nearest_verdict cagd_stationary_nearest(const cagd_fit_data *data, const cagd_spline *curve, const double feet[]);

/* Enclosures of gradient and Hessian of F over the box of unknowns no farther than radius[a] from the given ones,
 * a = 0, ..., unknowns-1; of the weights in their logarithms, radius <= 1.  Arrays of unknowns, and of unknowns x
 * unknowns numbers.  Returns 1, or 0 where a foot cannot be enclosed, and then *where is the index of its point. */
int cagd_stationary_enclosures(const cagd_stationary_problem *problem, const double radius[], double gradient_low[],
                               double gradient_high[], double hessian_low[], double hessian_high[], int *where);
#endif
