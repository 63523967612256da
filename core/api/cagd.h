/* cagd.h -- the double library: Bézier and rational Bézier curves, conics, B-spline and NURBS curves, in binary64.
 *
 * A curve of degree n has n+1 points; coordinate c of point i is points[i*dim + c].  The weights of
 * a rational curve stand beside its points, not multiplied in.  The parameter t may be any finite
 * number; the curve segment itself is 0 <= t <= 1.
 *
 * Memory.  No pointer may be NULL unless a function says so.  The caller owns every array; nothing is allocated or kept
 * but by cagd_curve_new.
 * Result arrays do not overlap arguments or one another.
 *
 * Status.  Every function returns a cagd_status.  It checks its arguments first, and writes nothing when one
 * is wrong; after CAGD_UNDEFINED and CAGD_OVERFLOW the results have no meaning.  Functions have no state: they
 * may run in any number of threads. */
#ifndef CAGD_H
#define CAGD_H

/* The version of this header; cagd_version() is that of the library. */
#define CAGD_VERSION_MAJOR 0
#define CAGD_VERSION_MINOR 1
#define CAGD_VERSION_PATCH 0

/* What the shared library shows; the rest of its names is hidden. */
#if defined(__GNUC__)
#define CAGD_API __attribute__((visibility("default")))
#else
#define CAGD_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

enum {
    CAGD_MAX_DEGREE = 64, /* degrees are 0 ... CAGD_MAX_DEGREE unless a function says more */
    CAGD_MAX_DIM = 3      /* points have 1 ... CAGD_MAX_DIM coordinates                    */
};

/* What can be wrong, in one list for all headers of the library.
 *
 * Three that are easily taken for one another: OUTSIDE_DOMAIN is about a parameter, which the domain of the curve does not
 * contain; SIGN about another argument, which is < 0 or 0 where the function excludes that; OVERFLOW about a result, which
 * the arguments determine and binary64 does not hold. */
typedef enum cagd_status {
    CAGD_OK,
    CAGD_NULL,           /* a pointer is NULL                                                                  */
    CAGD_NO_MEMORY,      /* what was to be allocated could not be                                              */
    CAGD_DEGREE,         /* the degree is outside the range that the function states                           */
    CAGD_DIMENSION,      /* the dimension is outside the range that the function states                        */
    CAGD_ORDER,          /* the order of derivation is outside 0 ... CAGD_MAX_DEGREE                           */
    CAGD_COUNT,          /* a spline needs more points than its degree; an array has a length < 0              */
    CAGD_NOT_FINITE,     /* an argument is infinite or not a number                                            */
    CAGD_SIGN,           /* a number or a weight has a sign, or is a zero, that the function excludes          */
    CAGD_OUTSIDE_DOMAIN, /* a parameter, a knot or a span lies outside the domain of the spline                */
    CAGD_KNOTS_DECREASE, /* a knot is smaller than the one before it                                           */
    CAGD_KNOTS_MULTIPLE, /* a knot is repeated more than degree+1 times                                        */
    CAGD_KNOTS_EMPTY,    /* the domain of a spline is empty                                                    */
    CAGD_UNDEFINED,      /* there is no such value: a total weight or another divisor is 0                     */
    CAGD_OVERFLOW,       /* binary64 overflows on the way to a result, or a weight is lost to underflow        */
    CAGD_NO_KNOT,        /* there is no such knot inside the domain                                            */
    CAGD_CHANGES,        /* there is no such form of this curve: it would be another curve                     */
    /* of cagd_fit.h alone */
    CAGD_BAD_DATA,   /* a measured point or its standard deviation is none                                 */
    CAGD_BAD_OPTION, /* an option of the fit is outside its range                                          */
    CAGD_BAD_CURVE,  /* the initial curve, or the knots, are none                                          */
    CAGD_TOO_FEW,    /* fewer equations than unknowns, or fewer than two points, or none                   */
    CAGD_ALL_EQUAL,  /* all points are equal                                                               */
    CAGD_STATUSES    /* how many there are; no status itself                                               */
} cagd_status;

/* One English sentence without full stop, never NULL; static storage. */
CAGD_API const char *cagd_status_text(cagd_status status);

/* "major.minor.patch"; static storage. */
CAGD_API const char *cagd_version(void);

/* values[i] = B_i^n(t), i = 0, ..., n = degree. */
CAGD_API cagd_status cagd_bernstein(int degree, double t, double *values);

/* point[dim]: the point of the curve at t. */
CAGD_API cagd_status cagd_bezier_point(int degree, int dim, const double *points, double t, double *point);

/* derivatives[(order+1)*dim]: row k is the k-th derivative at t, row 0 the point; zeros above the degree. */
CAGD_API cagd_status cagd_bezier_derivatives(int degree, int dim, const double *points, double t, int order,
                                             double *derivatives);

/* left and right, degree+1 points each: the curve over [0,t] and over [t,1]. */
CAGD_API cagd_status cagd_bezier_split(int degree, int dim, const double *points, double t, double *left,
                                       double *right);

/* elevated: the degree+2 points of the same curve in degree+1; degree < CAGD_MAX_DEGREE. */
CAGD_API cagd_status cagd_bezier_elevate(int degree, int dim, const double *points, double *elevated);

/* point[dim]: the point of the rational curve at t.  Weights may have any sign.  UNDEFINED when the total
 * weight at t, as computed, is 0. */
CAGD_API cagd_status cagd_rational_point(int degree, int dim, const double *points, const double *weights, double t,
                                         double *point);

/* derivatives[(order+1)*dim]: row k is the k-th derivative at t.  UNDEFINED as for the point. */
CAGD_API cagd_status cagd_rational_derivatives(int degree, int dim, const double *points, const double *weights,
                                               double t, int order, double *derivatives);

/* *curvature >= 0 at t; dim 2 or 3.  UNDEFINED as for the point, and where the first derivative is 0. */
CAGD_API cagd_status cagd_rational_curvature(int degree, int dim, const double *points, const double *weights, double t,
                                             double *curvature);

/* *torsion at t of a curve in space (dim 3).  UNDEFINED as for the point, and where the first two
 * derivatives are linearly dependent. */
CAGD_API cagd_status cagd_rational_torsion(int degree, const double *points, const double *weights, double t,
                                           double *torsion);

/* left, right (degree+1 points) and their weights: the curve over [0,t] and over [t,1].  UNDEFINED when a
 * weight of the result is 0. */
CAGD_API cagd_status cagd_rational_split(int degree, int dim, const double *points, const double *weights, double t,
                                         double *left, double *left_weights, double *right, double *right_weights);

/* elevated (degree+2 points) and elevated_weights: the same curve in degree+1; degree < CAGD_MAX_DEGREE.
 * UNDEFINED when a weight of the result is 0. */
CAGD_API cagd_status cagd_rational_elevate(int degree, int dim, const double *points, const double *weights,
                                           double *elevated, double *elevated_weights);

/* new_weights[i] = w_i a^i b^{n-i}: the weights of the same curve after t = a u/(a u + b (1-u)).
 * SIGN unless a > 0 and b > 0. */
CAGD_API cagd_status cagd_rational_reparametrize(int degree, const double *weights, double a, double b,
                                                 double *new_weights);

/* new_weights: the weights of the same curve whose first and last weight are 1; degree >= 1.
 * SIGN unless the first and the last weight are not 0 and have one sign. */
CAGD_API cagd_status cagd_rational_standard_form(int degree, const double *weights, double *new_weights);

/* invariants[i-1] = w_i^2/(w_{i-1} w_{i+1}), i = 1, ..., degree-1; degree >= 2.  UNDEFINED when one of those
 * divisors is 0. */
CAGD_API cagd_status cagd_rational_invariants(int degree, const double *weights, double *invariants);

/* conic = (A, B, C, D, E, F), A x^2 + 2B xy + C y^2 + 2D x + 2E y + F = 0, of the plane rational quadratic with
 * 3 points and 3 weights.  The coefficients are rounded. */
CAGD_API cagd_status cagd_conic_implicit(const double points[6], const double weights[3], double conic[6]);

typedef enum cagd_conic_type { CAGD_ELLIPSE, CAGD_PARABOLA, CAGD_HYPERBOLA } cagd_conic_type;

/* *type: the type of a conic, by the sign of AC - B^2.  The sign is decided exactly for the six numbers given.
 * Exactness ends there: the six numbers of cagd_conic_implicit are themselves rounded, so that a parabola may
 * come out as its neighbour; cagd_conic_classify_weights has no such step.  Degenerate conics are not told
 * apart: they have the type of their AC - B^2.  UNDEFINED when A = B = C = 0. */
CAGD_API cagd_status cagd_conic_classify(const double conic[6], cagd_conic_type *type);

/* *type: the type of a rational quadratic with three points not on a line, by the sign of w_0 w_2 - w_1^2,
 * decided exactly.  SIGN when a weight is 0. */
CAGD_API cagd_status cagd_conic_classify_weights(const double weights[3], cagd_conic_type *type);

#define CAGD_DEGREE_OF_ORDER(k) ((k)-1)

/* A B-spline curve (B 样条曲线) sum N_{i,p}(t) c_i, or with weights a NURBS curve (NURBS 曲线)
 * sum N_{i,p}(t) w_i c_i / sum N_{i,p}(t) w_i.
 *
 * The degree p is the order k less one, CAGD_DEGREE_OF_ORDER(k).  count points, count > p; coordinate c of point i
 * is points[i*dim + c]; count+p+1 knots u_0 <= u_1 <= ..., each of multiplicity at most p+1.  The domain is [u_p, u_count]; ends need not be
 * clamped.  weights NULL: a B-spline curve.  Everything is the caller's and only read. */
typedef struct cagd_spline {
    int degree, count, dim;
    const double *knots, *points, *weights;
} cagd_spline;

/* At a knot the two neighbouring segments may differ: CAGD_RIGHT asks for the one on the right, at the end of the domain
 * for the last one; CAGD_LEFT for the one on the left, at the start for the first one. */
typedef enum cagd_side { CAGD_RIGHT, CAGD_LEFT } cagd_side;

/* Whether the spline is one, with a status that says what is wrong.  where may be NULL; otherwise *where is the index of
 * the knot, point coordinate or weight that is meant, or -1 where there is none. */
CAGD_API cagd_status cagd_spline_check(const cagd_spline *spline, int *where);

/* *span = mu with u_mu < u_{mu+1}: the segment of t. */
CAGD_API cagd_status cagd_spline_span(const cagd_spline *spline, double t, cagd_side side, int *span);

/* values[(order+1)*(p+1)]: row r holds the derivatives of order r at t of N_{mu-p,p}, ..., N_{mu,p}, mu = *span; row 0 the
 * values.  The points are not looked at. */
CAGD_API cagd_status cagd_spline_basis(const cagd_spline *spline, double t, cagd_side side, int order, int *span,
                                       double *values);

/* point[dim]: the point at t.  UNDEFINED when the total weight at t, as computed, is 0. */
CAGD_API cagd_status cagd_spline_point(const cagd_spline *spline, double t, cagd_side side, double *point);

/* derivatives[(order+1)*dim]: row r is the r-th derivative at t.  UNDEFINED as for the point. */
CAGD_API cagd_status cagd_spline_derivatives(const cagd_spline *spline, double t, cagd_side side, int order,
                                             double *derivatives);

/* *curvature >= 0 at t; dim 2 or 3.  UNDEFINED as for the point, and where the first derivative is 0. */
CAGD_API cagd_status cagd_spline_curvature(const cagd_spline *spline, double t, cagd_side side, double *curvature);

/* *torsion at t; dim 3.  UNDEFINED as for the point, and where the first two derivatives are dependent. */
CAGD_API cagd_status cagd_spline_torsion(const cagd_spline *spline, double t, cagd_side side, double *torsion);

/* The same curve with one knot x more (Boehm): count+p+2 knots, count+1 points, and as many weights if the spline has
 * any (else new_weights may be NULL).  OUTSIDE_DOMAIN unless u_p <= x < u_count; KNOTS_MULTIPLE when x is a knot p+1 times;
 * UNDEFINED when a new weight is 0. */
CAGD_API cagd_status cagd_spline_insert(const cagd_spline *spline, double x, double *new_knots, double *new_points,
                                        double *new_weights);

/* The p+1 Bézier points of the segment of the span, and as many weights if the spline has any: the curve over
 * [u_span, u_{span+1}] as a (rational) Bézier curve over [0,1].  OUTSIDE_DOMAIN unless that is a span; UNDEFINED when a weight
 * of the result is 0. */
CAGD_API cagd_status cagd_spline_bezier(const cagd_spline *spline, int span, double *bezier_points,
                                        double *bezier_weights);

/* How many points cagd_spline_split gives on the left and on the right of t, u_p < t < u_count. */
CAGD_API cagd_status cagd_spline_split_counts(const cagd_spline *spline, double t, int *left_count, int *right_count);

/* The parts of the curve on the left and on the right of t, u_p < t < u_count; in each of them t is a knot p+1 times.
 * left has *left_count points and p+1 knots more, right in the same way.  Weights if the spline has any.  UNDEFINED when
 * a weight of the result is 0. */
CAGD_API cagd_status cagd_spline_split(const cagd_spline *spline, double t, double *left_knots, double *left,
                                       double *left_weights, double *right_knots, double *right, double *right_weights);

/* How many points the curve has in degree p+1. */
CAGD_API cagd_status cagd_spline_elevated_count(const cagd_spline *spline, int *count);

/* The same curve in degree p+1 <= CAGD_MAX_DEGREE: *count points as cagd_spline_elevated_count says, over *count+p+2
 * knots in which every knot of the domain has one copy more; both ends clamped only if they were.  Weights if the spline has
 * any.  UNDEFINED when a weight of the result is 0. */
CAGD_API cagd_status cagd_spline_elevate(const cagd_spline *spline, double *new_knots, double *new_points,
                                         double *new_weights);

/* ---- prepared curves -------------------------------------------------------------------------------- */

/* A curve that was checked once and is then evaluated often: a copy of a spline, with its points made homogeneous.  Nothing
 * changes in it from cagd_curve_new to cagd_curve_free, so any number of threads may use it at once.  Values are bit
 * for bit those of the functions on the spline. */
typedef struct cagd_curve cagd_curve;

/* The prepared curve, or NULL with a *status that says what is wrong with the spline, or NO_MEMORY.  The spline may be
 * changed or gone afterwards.  status and where may be NULL; *where is as in cagd_spline_check.  The caller releases the
 * curve by cagd_curve_free. */
CAGD_API cagd_curve *cagd_curve_new(const cagd_spline *spline, cagd_status *status, int *where);
CAGD_API void cagd_curve_free(cagd_curve *curve); /* NULL is allowed */

/* point[dim], derivatives[(order+1)*dim], *curvature >= 0 (dim 2 or 3) and *torsion (dim 3) at t, with the statuses of
 * cagd_spline_point, _derivatives, _curvature and _torsion. */
CAGD_API cagd_status cagd_curve_point(const cagd_curve *curve, double t, cagd_side side, double *point);
CAGD_API cagd_status cagd_curve_derivatives(const cagd_curve *curve, double t, cagd_side side, int order,
                                            double *derivatives);
CAGD_API cagd_status cagd_curve_curvature(const cagd_curve *curve, double t, cagd_side side, double *curvature);
CAGD_API cagd_status cagd_curve_torsion(const cagd_curve *curve, double t, cagd_side side, double *torsion);

/* The same at count >= 0 parameters, in any order (in ascending order the spans are found at once): points[count*dim],
 * derivatives[count*(order+1)*dim], one value each.  At the first parameter that has none they end with its status, and
 * *where is its index; what stands before it in the results is right.  *where is -1 otherwise; where may be NULL. */
CAGD_API cagd_status cagd_curve_points(const cagd_curve *curve, int count, const double *t, cagd_side side,
                                       double *points, int *where);
CAGD_API cagd_status cagd_curve_all_derivatives(const cagd_curve *curve, int count, const double *t, cagd_side side,
                                                int order, double *derivatives, int *where);
CAGD_API cagd_status cagd_curve_curvatures(const cagd_curve *curve, int count, const double *t, cagd_side side,
                                           double *curvatures, int *where);
CAGD_API cagd_status cagd_curve_torsions(const cagd_curve *curve, int count, const double *t, cagd_side side,
                                         double *torsions, int *where);

#ifdef __cplusplus
}
#endif
#endif
