/* cagd_fit.h -- rational curves that come closest to measured points (有理曲线的最小二乘拟合).
 *
 * Given points Q_1, ..., Q_N in the plane or in space, each measured with a standard deviation s_i in every
 * coordinate, cagd_fit finds the curve
 *
 *     C(t; theta) = sum N_{j,p}(t) w_j P_j / sum N_{j,p}(t) w_j
 *
 * of given degree and knots that minimises half the sum of squared orthogonal distances,
 *
 *     F(theta) = 1/2 sum_i rho(|Q_i - C(t_i; theta)|^2 / s_i^2),
 *
 * where the foot point (垂足) t_i of Q_i is an unknown of its own, inside the domain.  theta holds what is asked
 * for: weights, as logarithms, hence always positive; inner points; end points.  rho is the identity or a
 * robust loss.
 *
 * The gauge (规范).  A Bézier curve has the same points after a fractional-linear change of parameter, a spline of
 * several spans only after a common factor of its weights.  The first weight is 1, and so is the last one of a curve of
 * one span: then it is the standard form (标准型).  What is left undetermined, such as ends that slide along the curve, is
 * found by the rank of the problem and reported.
 *
 * Ends (端点).  Free ends are measured (ENDS_MEASURED): the first and the last point, with errors as the others have, are
 * measurements of the ends of the curve.  Their feet are the ends of the domain, and their distances count along the
 * curve as well as across; so every weight, end and invariant has an interval, in which the uncertainty of the cut is.  Of points in
 * any order those are taken that are nearest to the ends of the initial curve, or that a first fit, with two of the
 * points as exact ends, ends in.
 *
 * Free ends may also slide (ENDS_SLIDE): where a curve is cut off is no property of its points, and as long as no foot
 * is passed the cut changes weights and ends and not the cost.  What does not change with the cut, points, distances and
 * the type of a conic, is reported; weights and ends are not determined.
 *
 * Ends that are not free are the first and the last measured point as they are, with errors that no standard error
 * knows of: the intervals of what depends on them are then too short.
 *
 * Outliers at the ends (端点处的离群点).  With a robust loss, which sees how far a point is from the curve, an end would follow a
 * point that is an outlier.  So the first and the last point of points in order are judged by the curve of the others and what it goes on
 * as: where the point is farther from there than end_limit standard deviations, of the point and of that place together, it is an outlier and
 * left out, `left_out`, and the next point measures the end.  It is told of as all others are; statistics, cost and covariance are of
 * the points that are left.
 *
 * Closed curves (闭曲线).  With `closed` the curve comes back to where it began, without ends: a periodic spline, whose
 * derivatives of order up to p-1 agree at the seam.  `count` says how many points it has, more than p; it is given
 * back with the first p of them once more behind the last, on knots that are not clamped, as every evaluation takes it.
 * Unknowns are of the first ones.  Nothing is said of ends: CAGD_FIT_END_POINTS and `ends` have no effect.  An initial curve,
 * and knots, are periodic, too.
 *
 * Smoothing (光顺).  With smooth = lambda > 0 what is minimised is
 *
 *     F(theta) + lambda/2 integral |sum N_{j,p}''(u) P_j|^2 du,    u from 0 to 1 over the domain,
 *
 * a spline as a compromise between its points and its bending energy, which also says what the points leave open.  Weights are
 * not free then, and the degree is 2 or more.  Of the k unknowns the points determine tr H^-1 J^T J, `effective`, H the matrix of
 * second derivatives with the smoothing term; it takes the place of the rank in the degrees of freedom.  The covariance is
 * scale_squared H^-1 J^T J H^-1, that of the smoothed curve: how far smoothing moves the curve by itself is not in it.
 * Source: eilers-marx-1996; wahba-1990.
 *
 * Feet in order (保序垂足).  With `monotone` the feet do not fall back, t_1 <= t_2 <= ... <= t_N, on a closed curve but for the
 * seam; so a curve gains nothing by going back and forth between its points, as one with much freedom and few points does.  An
 * excursion between two neighbouring feet is against no order, and a matter of smoothing.  Where a foot would fall back behind the one
 * before both are at the same t, and the distances there count along the curve as well as across.  Of squares, for points in order,
 * and with something free.
 * What it changes in the statistics: a foot that is shared is one unknown less, so that there are `tied` more degrees of freedom, and
 * distances that are not orthogonal are in chi_squared.  Which feet are shared was decided by the same points, of which no standard
 * error knows: in simulations (cubic, 60 points whose errors are 1 to 3 times as large as they are apart, a fifth to a half of the feet
 * shared) the variance comes out 7 to 12 % too small, and intervals would cover 86 to 94 %; they are not sought.  Where no foot is shared
 * the curve is a minimum without `monotone`, too.  Source: barlow-1972.
 *
 * Nothing free (只求垂足).  With an initial curve and free = 0 the distances of the points from that curve are told, and
 * nothing is estimated.  One point is enough then.  The foot of each is the nearest point of the whole curve,
 * whatever the order of the points, which only says how many feet overtake the one before.  The curve, its gauge with
 * it, stays as it is given, and parameters of feet are those of the given curve.  There are no unknowns: rank 0, N
 * (dim-1) degrees of freedom.
 *
 * Far from the origin (远离原点).  The fit is computed in coordinates from an origin of its own, which is subtracted from
 * the measured coordinates without rounding; so nothing is lost where these are so large that the steps of binary64
 * are no longer small against the curve.  The curve itself may not have its points in binary64 there: curve, value
 * and feet are rounded to it, `relative` is not.
 *
 * Memory.  The caller owns the arguments, which are only read.  A result is made by cagd_fit and released by
 * cagd_fit_free, with all arrays it points to.  Nothing is printed. */
#ifndef CAGD_FIT_H
#define CAGD_FIT_H

#include "core/api/cagd.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    CAGD_FIT_MAX_POINTS = 1 << 28,       /* measured points                                             */
    CAGD_FIT_MAX_CONTROL_POINTS = 10000, /* points of the curve: the entries of a matrix are counted in int */
    CAGD_FIT_MAX_STARTS = 1000000
};

/* The measured points. */
typedef struct cagd_fit_data {
    int count, dim;       /* N points of dim coordinates, dim = 2 or 3                                     */
    const double *points; /* coordinate c of point i is points[i*dim + c]                                 */
    const double *sigma;  /* N standard deviations > 0; NULL: unknown and all alike                        */
} cagd_fit_data;

/* What may move, added up. */
enum { CAGD_FIT_WEIGHTS = 1, CAGD_FIT_INNER_POINTS = 2, CAGD_FIT_END_POINTS = 4 };

/* How free ends are fitted; see above. */
typedef enum cagd_fit_ends { CAGD_FIT_ENDS_MEASURED, CAGD_FIT_ENDS_SLIDE } cagd_fit_ends;

/* rho(x), x = squared distance in units of the standard deviation; a the scale:
 *     SQUARES x      HUBER x for x <= a^2, else 2 a sqrt(x) - a^2      CAUCHY a^2 log(1 + x/a^2)                  */
typedef enum cagd_fit_loss { CAGD_FIT_SQUARES, CAGD_FIT_HUBER, CAGD_FIT_CAUCHY } cagd_fit_loss;

typedef struct cagd_fit_options {
    int degree, count; /* p and the number of points of the curve; count 0: p+1, of a closed one p+2 */
    const double *
        knots; /* count+p+1 knots, clamped, of a closed curve count+2p+1, periodic; NULL: 0 and 1 at the ends, inner ones even  */
    const cagd_spline *initial; /* where to start; NULL: found from the points.  Gives degree and knots  */
    int free;                   /* CAGD_FIT_... added up; what is not free stays as in initial; without  */
                                /* initial the inner points must be free, and ends that are not free are */
                                /* the first and the last measured point; 0, with initial: only the feet */
    cagd_fit_ends ends;         /* of free ends                                                          */
    double smooth;              /* >= 0: the weight of the smoothing term; see above                     */
    int closed;                 /* 1: a closed curve; see above                                          */
    int monotone;               /* 1: the feet follow the order of the points; see above                 */
    int unordered;              /* 0: the points come in order along the curve; 1: in any order          */
    cagd_fit_loss loss;
    double loss_scale;              /* a > 0; 0: estimated, with the fit, from the median of the distances     */
    double weight_low, weight_high; /* 0 <= weight_low < 1 < weight_high <= infinity: bounds on the weights */
    int starts;            /* 1 ... MAX_STARTS: the first from initial, or the best of many curves found from   */
                           /* the points; the others with other weights; up to 8 more when none of  */
                           /* them comes to a minimum                                               */
    unsigned long seed;    /* of the other starts                                                   */
    double tolerance;      /* > 0: relative, on the decrease of the cost, on the gradient, the step */
    int max_iterations;    /* >= 1                                                                  */
    int without_intervals; /* 1: no 95 % intervals are sought; for those by the profile the curve is fitted again many */
                           /* times, under conditions                                              */
    /* NULL, or called with `context` after every start of every fit that cagd_fit or cagd_fit_choose makes: so many of the starts that
     * are asked for, or more, have ended.  It does not change the fit. */
    void (*after_start)(void *context, int ended, int starts);
    void *context;
} cagd_fit_options;

/* Degree 2 Bézier, all free, measured ends, ordered, squares, scale 1, weights unbounded, one start, seed 1,
 * tolerance 1e-14, 200 iterations. */
CAGD_API cagd_fit_options cagd_fit_defaults(void);

/* What an unknown is: the logarithm of weight `index`, or coordinate `coordinate` of point `index`. */
typedef struct cagd_fit_unknown {
    int is_weight, index, coordinate;
} cagd_fit_unknown;

/* One line of the minimiser's table. */
typedef struct cagd_fit_step {
    int iteration, accepted;
    double cost, gradient_norm, step_norm, trust_radius;
} cagd_fit_step;

/* How a 95 % interval was found: value +- quantile * error, LINEAR; by the profile of the cost, which is not quadratic
 * over that interval, PROFILE; or not at all, since the points hardly determine the unknown, NONE.  NOT_SOUGHT: a
 * standard error, and no interval, since none was asked for, or since none is known that covers the truth 95 times in a hundred:
 * with a smoothing term, whose bias is in no error, where feet are shared, and where cagd_fit_choose has found the knots, or that weights are fitted,
 * by the same points, or left the weights of a spline out though they would explain something. */
typedef enum cagd_fit_interval {
    CAGD_FIT_INTERVAL_LINEAR,
    CAGD_FIT_INTERVAL_PROFILE,
    CAGD_FIT_INTERVAL_NONE,
    CAGD_FIT_INTERVAL_NOT_SOUGHT
} cagd_fit_interval;

typedef enum cagd_fit_termination { CAGD_FIT_CONVERGED, CAGD_FIT_NOT_CONVERGED, CAGD_FIT_FAILED } cagd_fit_termination;

/* How points come back to where they began.  REPEATED: the last one repeats the first.  AROUND: it does not, but the way back is no
 * longer than the steps are.  CORNER: they come back, but with a corner that no other place has, as at the trailing edge of an
 * airfoil; a smooth closed curve would round it off. */
typedef enum cagd_fit_closing { CAGD_FIT_OPEN, CAGD_FIT_REPEATED, CAGD_FIT_AROUND, CAGD_FIT_CORNER } cagd_fit_closing;

/* A number with its standard error and the ends of its 95 % interval; NaN where there are none. */
typedef struct cagd_fit_number {
    double value, error, low, high;
} cagd_fit_number;

/* An ellipse, whole or an arc that may be longer than a half turn, which one segment of degree 2 cannot be.  Errors of s, alike in all
 * directions, put the points farther out by s^2/2 times the curvature in the mean; by what that makes of each number its interval is moved, so
 * that it does not lie in the middle of it.  An arc whose distances are more than a twentieth of the smallest radius of
 * curvature has no intervals: its points are smeared along it, and it seems to determine more than it does.  Source: berman-1989. */
typedef struct cagd_fit_ellipse {
    int known, whole;             /* known: the curve is one                                             */
    cagd_fit_number centre[3];    /* coordinates                                                         */
    cagd_fit_number major, minor; /* semi-axes                                                           */
    cagd_fit_number
        angle; /* in the plane, of the major axis, in degrees, -90 < angle <= 90; error NaN of a circle; no interval where that is wide */
    double sweep;                             /* how far around the arc goes, in degrees                             */
    int circle;                               /* 1: 95 % do not tell it from a circle                                */
    cagd_fit_number circle_centre[3], radius; /* of the circle that comes closest                             */
    double circle_rms, ratio;                 /* of its distances; of the F test, with 2 and `freedom` degrees       */
    int freedom;
} cagd_fit_ellipse;

/* Some kind of curve that was tried.  score: see cagd_fit_choose.  problems: what is not good about it, see cagd_fit_quality; all of it
 * where it does not count.  beneath: 1 where its distances have structure that is no problem, but counts beside a candidate without. */
typedef struct cagd_fit_candidate {
    char name[64];
    int unknowns, converged, problems, beneath;
    double score, rms;
} cagd_fit_candidate;

enum { CAGD_FIT_MAX_CANDIDATES = 8 };

/* What cagd_fit_choose has found and chosen. */
typedef struct cagd_fit_found {
    int chosen;               /* 1: by cagd_fit_choose                                                    */
    cagd_fit_closing closing; /* of the points                                                           */
    int count_chosen;         /* 1: the number of control points, and the knots, were chosen              */
    int knots_chosen;         /* 1: the knots were chosen, their number perhaps given                     */
    int smoothed; /* 1: the smoothing term was chosen by cross-validation, asked for; 2: since without one the fit was not good;
                     3: as large, to a factor of 10, as lets the curve keep within a distance, or come nearest to it, as none without was found to do */
    double smooth; /* its weight                                                               */
    int within;    /* of a tolerance: 1 met, -1 not met, 0 none was given                      */
    int weights;   /* of a spline whose weights could be left out: 1 they explain something and are fitted, 2 they
                    would explain something and are not, since with them no better minimum was found, 0 left out, -1 not asked */
    double weights_ratio, weights_probability; /* of the F test for weights                                 */
    int weights_number, weights_freedom;       /* its degrees of freedom                                  */
    int candidates;
    cagd_fit_candidate candidate[CAGD_FIT_MAX_CANDIDATES]; /* the first is the one that was chosen             */
    cagd_fit_ellipse ellipse;
} cagd_fit_found;

typedef struct cagd_fit_result {
    cagd_fit_found found;
    /* the curve, in the gauge above; with nothing free, as given */
    cagd_spline curve;
    int period;       /* of a closed curve: how many of its points are its own, the others repeat them; 0: open */
    double origin[3]; /* measured coordinates less these are exact in binary64                         */
    double *relative; /* the points of the curve less the origin, which are what was fitted and verified */
    /* the foot points and what is left: residuals[i*dim + c] = coordinate c of Q_i - C(feet[i]); distances[i] its
     * length, in the plane with the sign + on the left of the curve */
    int count;
    double *feet, *residuals, *distances;
    int *
        foot_at_end; /* 1 where the foot is an end of the domain and the distance is not orthogonal; 0 for end points */
    int feet_at_ends;    /* how many of them                                                            */
    int tied;            /* how many points share the foot of the one before, since it would fall back; see above */
    int out_of_order;    /* how many feet are smaller than the one before; 0 for unordered points        */
    double rms, largest; /* of the distances, unscaled                                                  */
    int largest_at;      /* index of the point it belongs to                                            */
    double spacing[3];   /* how far apart the numbers of binary64 are where each measured coordinate is largest */
    double loss_scale;   /* of a robust loss: as given, or as estimated                                     */
    double
        deviation; /* of a robust loss: what the median of the distances says of their standard deviation, in units of given ones */
    int outliers,
        *outlier; /* of a robust loss: how many points are farther than outlier_limit deviations, and 1 for these */
    double outlier_limit, rms_of_others; /* once in twenty times a point is as far by chance; rms without outliers  */
    int left_out[2]; /* so many outliers at the start and at the end, without which the curve is fitted; see above */
    int end_is_judged[2]; /* 1 where the first, the last point that measures an end was judged so            */
    double end_limit;     /* and how many standard deviations these are allowed                                      */
    int points_on_curve; /* 1 where the distances are no larger than the roundings of binary64, so that their scatter says */
                         /* nothing of measurements                                                     */
    /* the minimiser */
    cagd_fit_termination termination;
    int refuted; /* 1 after cagd_fit_refute                                                 */
    int iterations, best_start, agreeing_starts; /* starts that ended at the same cost                      */
    double initial_cost, cost, gradient_norm;    /* of F; the largest component of its gradient            */
    int steps;
    cagd_fit_step *history;
    char message[256];
    /* the unknowns, and how well they are known */
    int unknowns, rank;
    cagd_fit_unknown *unknown;
    double *value; /* of theta: logarithms of weights, coordinates                                */
    int *at_bound; /* 1 where a weight stands on a bound; it is then not counted as unknown       */
    double
        *covariance;  /* unknowns x unknowns, by rows: the generalised inverse of J^T J, J the Jacobian of the scaled */
                      /* residuals without feet; times scale_squared                                 */
    double effective; /* how many unknowns the points determine: the rank, with a smoothing term less; NaN where its */
                      /* matrix is singular, and then every unknown counts as one                         */
    double roughness; /* the integral of the smoothing term                                              */
    int flat;         /* unknowns that are not at a bound, less the rank                             */
    double *free_directions; /* flat x unknowns, by rows: orthonormal directions in which F is flat         */
    int *determined;         /* 1 where the unknown is not at a bound, and the same along all free directions */
    int scale_is_given;      /* 1: squares of distances over given standard deviations, which are believed    */
    double scale_squared;    /* 1 when it is given, else what the distances say it is: of squares              */
                             /* chi_squared / degrees_of_freedom, of a robust loss the factor of an M-estimate; of */
                             /* a spline that has no weights and is to have some, what they would leave of these   */
    int ends_are_exact;      /* 1: the ends are measured points whose errors no standard error knows of          */
    double chi_squared, reduced_chi_squared, aic, bic;
    int end_points[2]; /* the points that are measurements of the ends of the curve; -1: none              */
    int degrees_of_freedom; /* N (dim-1) - rank, and one more for each of the end points and for each shared foot; N without given ends  */
    double quantile; /* 95 % intervals are value +- quantile * standard error: normal with given standard */
                     /* deviations, else Student's t                                                */
    int invariants;  /* of a curve of one span, p-1: I_j = w_j^2/(w_{j-1} w_{j+1}), with standard errors */
    double *invariant, *invariant_error;
    cagd_fit_interval *interval_by; /* of the unknowns, and behind them of the invariants                    */
    double *
        interval; /* by PROFILE: from interval[2q] to interval[2q+1], logarithms of weights and invariants, coordinates */
                  /* from `origin`                                                                       */
} cagd_fit_result;

/* *result: the fit, or NULL unless CAGD_OK, which says that a result was made; whether it converged stands in it.
 * *where may be NULL; it becomes the index of the measured point that the status is about, or -1.  Of several starts
 * the one with the smallest cost.
 *
 * NULL: data, options, result or the points are NULL.  BAD_DATA, with the index.  BAD_OPTION.  BAD_CURVE: the initial
 * curve, or the knots, are none.  TOO_FEW: without a smoothing term fewer equations, N (dim-1), with measured ends 2 more, than unknowns, or fewer than 2 points; with
 * nothing free none.  ALL_EQUAL: all points; with nothing free, and the curve is that point, too.  OVERFLOW: squared
 * distances would leave the range of numbers, perhaps with the index of the point whose standard deviation is the
 * reason.  NO_MEMORY. */
CAGD_API cagd_status cagd_fit(const cagd_fit_data *data, const cagd_fit_options *options, cagd_fit_result **result,
                              int *where);
CAGD_API void cagd_fit_free(cagd_fit_result *result); /* NULL is allowed */

/* ---- Choosing a curve ---------------------------------------------------------------------------------------
 *
 * cagd_fit fits the curve that its options name.  cagd_fit_choose finds out what they leave open. */
typedef struct cagd_fit_choices {
    int closed;  /* 1, 0; -1: as the points say                                                           */
    int form;    /* 1: degree and number of control points are not given: a conic, a whole ellipse or a spline   */
    int count;   /* 1: the number of control points is found, and the knots                               */
    int degree;  /* 1: the degree is found, 2 to 5; the one of the options is not asked for, nor is `form`     */
    int weights; /* 1: of a spline weights are fitted where an F test at 95 % says that they explain something   */
    int smooth; /* 1: the weight of the smoothing term is found by cross-validation; 2: where the fit is not good without,
                   and knots that the points place, as many as given, are not good either                     */
    double within; /* > 0: the fewest control points found that keep every point within this distance       */
} cagd_fit_choices;

/* Everything is found. */
CAGD_API cagd_fit_choices cagd_fit_choices_all(void);

/* How the points come back to where they began.  In no order: around their centre. */
CAGD_API cagd_fit_closing cagd_fit_closing_of(const cagd_fit_data *data, int unordered);

/* As cagd_fit; the result says in `found` what was chosen.  Where the last point repeats the first one it is one
 * measurement, not two: it is left out, and `count` of the result is smaller by one.
 *
 * Curves are compared by Schwarz's criterion with the correction for few points, the smaller the better,
 *
 *     score = n log(chi_squared/n) + k log(n) n/(n - k - 2),    given standard deviations: chi_squared + k log(n) n/(n - k - 2),
 *
 * n = N (dim-1), k the unknowns that the points determine, without those of the ends, and one more where the standard deviation is unknown,
 * which is that one.  Where degrees compete within a distance, the score is the number of control points of those that keep within it.  A curve that is no minimum or has
 * excursions that no points show does not count.  One that cagd_fit_quality_of finds nothing against is better than one with problems,
 * unless that shows it to be too simple, CAGD_FIT_SIMPLE.  Beside a conic or an ellipse that does, an ellipse and a spline are tried of fewer than 64
 * points and where it leaves a gap, and count where they show that, or nothing is found against them as there is against it; where only the given
 * deviations are, they may be wrong, and the scores are those of unknown ones.  Source: mcquarrie-1999, kass-raftery-1995.
 *
 * Form.  A conic in one segment is kept where its residuals are noise: where neighbours lie on the same side no more often
 * than once in a hundred by chance.  A straight line competes with it where it is hardly bent or no minimum, and where nothing is found against the
 * line and its score is no higher.  Otherwise an ellipse and a cubic spline compete with it.
 *
 * Knots are put in one by one, where the sum of squared distances of a segment is largest, and even ones are tried; of the best
 * curve, where one that is not good counts as if its score were higher by 10, knots are taken out as long as that helps, the neighbours of one that is taken out moved towards its place where it does not help
 * otherwise.  Within a distance a spline that is not good or has loops gives way to one that is and has none.  A distance asks for no degrees of
 * freedom: where it is not kept with half of the equations, knots are put in as dense as the points, and splines over more and more even
 * knots are led to from smoothed ones; where none of them keeps it, these keep a smoothing term.  Within a distance that cannot be kept the fewest control points are sought that keep the smallest
 * one which was found.  Where the number of control points is given and the spline over even knots is not
 * good, or has loops, it is led to from a smoothed one, whose smoothing term is taken back by and by; if that is no better, as many knots
 * are put in one by one.  A spline that is not good then is given a smoothing term, whose weight minimises n chi_squared/(n - 1.4 k)^2
 * (generalised cross-validation).  Source: wahba-1990; kim-gu-2004. */
CAGD_API cagd_status cagd_fit_choose(const cagd_fit_data *data, const cagd_fit_options *options,
                                     const cagd_fit_choices *choices, cagd_fit_result **result, int *where);

/* How the residuals lie beside one another, in the order of their feet: pairs of neighbours, how many of them lie on the same
 * side of the curve, in space at less than a right angle, and the probability that by chance so many or more do, 1/2 each.
 *
 * And the part of the curve that passes its points by most: of 4, 8, 16, ... neighbours, up to a half of all, the mean distance over its standard
 * deviation, where distances count up to 2.5 of them, outliers and ends do not, and the scatter is that of all or of these and 32 on
 * either side, whichever is larger; what the bend of the
 * curve makes of it is taken off, and where it turns on a radius of less than five deviations nothing is said; the
 * probability is that by chance any of all these windows has such a mean: of independent errors of one distribution every order is as likely, and
 * it is the part of up to 499 orders, drawn by a fixed seed, in which a window reaches it; where it is less than 1/1000, the sum over all windows,
 * which is more than the probability of any.  Source: besag-clifford-1991.
 *
 * And whether the distances are a wave, of 16 points or more.  The correlation of a distance with the next, and the probability that by chance it
 * would be so large: of errors that are as likely on one side as on the other the products of neighbours have signs that are independent, so that
 * their sum is about normal with the sum of their squares for its variance, whatever the sizes of the errors are.  And the same of points
 * that are k apart, for the k = 2, ..., a third of all where that is least likely; the probability is the sum over all k.  Of few points it sees what
 * counting sides does not. */
typedef struct cagd_fit_runs {
    int pairs, same;
    double probability;
    int points;              /* of the window                         */
    double from, to, excess; /* parameters; mean / standard deviation */
    double local_probability;
    double next_correlation, next_probability;
    int lag; /* k */
    double lag_correlation, lag_probability;
} cagd_fit_runs;
/* `data` and `options` as for the fit. */
CAGD_API cagd_status cagd_fit_runs_of(const cagd_fit_data *data, const cagd_fit_options *options,
                                      const cagd_fit_result *result, cagd_fit_runs *runs); /* OK, NO_MEMORY */

/* ---- What a result says of its unknowns ---------------------------------------------------------------------
 *
 * Standard errors, intervals and probabilities are true only of a minimum.  Where the curve is none the numbers
 * belong to the last curve that was reached; then errors and intervals are NaN. */

/* Whether the curve is a minimum, as far as is known: the minimiser has converged, and nobody has found that it is
 * none. */
CAGD_API int cagd_fit_is_minimum(const cagd_fit_result *result);

/* To be called when a verification has found that the curve is no minimum, or a foot no nearest point. */
CAGD_API void cagd_fit_refute(cagd_fit_result *result);

/* An estimate with its standard error and 95 % interval.  The error is NaN where there is none: for an unknown on its
 * bound or one that is not determined, and where the curve is no minimum; so is the interval.  Weights and invariants
 * are fitted by their logarithms: their error is that of the logarithm times the value, and their interval that of
 * the logarithm, exponentiated.  The interval by a profile of the cost lies otherwise about the value; where there is none, error,
 * low and high are NaN, and where none was sought low and high.  Value, low and high of a coordinate are counted from `origin`, which is 0 for the
 * others. */
typedef struct cagd_fit_estimate {
    double value, error, low, high, origin;
    cagd_fit_interval by;
} cagd_fit_estimate;

/* Of unknown k = 0, ..., unknowns-1; of invariant[j], j = 0, ..., invariants-1. */
CAGD_API cagd_fit_estimate cagd_fit_unknown_estimate(const cagd_fit_result *result, int k);
CAGD_API cagd_fit_estimate cagd_fit_invariant_estimate(const cagd_fit_result *result, int j);

/* The correlation of unknowns i and j; NaN where one of them has no variance. */
CAGD_API double cagd_fit_correlation(const cagd_fit_result *result, int i, int j);

/* The standard deviation of a coordinate of point i: given, or else estimated; NaN where it is neither.  And the
 * distance of the point in units of it; NaN also where it is 0. */
CAGD_API double cagd_fit_deviation(const cagd_fit_data *data, const cagd_fit_result *result, int i);
CAGD_API double cagd_fit_standardised(const cagd_fit_data *data, const cagd_fit_result *result, int i);

/* Coordinates of the curve may be known better than binary64 holds the measured coordinates: errors that these have
 * in common, by their rounding, are in no standard error.  The index of the coordinate, among the unknowns, with the
 * smallest standard error of those that are smaller than the spacing; *spacing is the widest of these spacings.  -1
 * where there is none. */
CAGD_API int cagd_fit_finest_unknown(const cagd_fit_result *result, double *spacing);

/* Which conic (圆锥曲线) a fitted curve of degree 2 in one span is, and how sure that is.
 *
 * I_1 = w_1^2/(w_0 w_2) is less than 1 for an ellipse, 1 for a parabola, greater for a hyperbola.  log I_1 is linear
 * in the unknowns; the type is certain when its 95 % interval does not contain 0.
 * It has a meaning only when the three points are not on a line: that the 95 % interval of the distance of the middle
 * one from the line of the others does not contain 0 is asked first.  When the ends slide along the curve, I_1
 * changes but its being less than 1 does not; the error is then that of the generalised inverse. */
typedef enum cagd_fit_conic_kind {
    CAGD_FIT_NOT_QUADRATIC,   /* the curve has another degree or several spans; the rest is 0                */
    CAGD_FIT_CONIC_UNKNOWN,   /* there is no standard error, or the weight is undetermined or on its bound  */
    CAGD_FIT_STRAIGHT,        /* not told from a straight line                                              */
    CAGD_FIT_CONIC_UNDECIDED, /* the interval of log I_1 contains 0                                         */
    CAGD_FIT_CONIC_CERTAIN    /* the type is that of all weights in the interval, or the weights are given  */
} cagd_fit_conic_kind;

typedef struct cagd_fit_conic {
    cagd_fit_conic_kind kind;
    cagd_conic_type type;        /* of the fitted curve itself                                            */
    double log_invariant, error; /* log I_1 and its standard error                                        */
    const char *text;            /* "an ellipse at 95 %", "cannot tell ellipse from parabola", ...; static */
} cagd_fit_conic;

CAGD_API cagd_fit_conic cagd_fit_conic_of(const cagd_fit_result *result);

/* Whether the points contradict that a conic in one segment in the plane is an arc of a circle (圆弧), and which circle comes closest to them.
 *
 * The circle minimises the sum of squared orthogonal distances over s_i^2; of 5 numbers of a conic it has 3.  known: the curve is a conic in
 * one segment by least squares, all of it free, and a minimum, the curvature of the circle differs from 0 at 95 %, which tells it from a straight
 * line also where the conic with its two numbers more does not, and by
 *
 *     F = (chi_squared of the circle - chi_squared of the conic)/2 / (chi_squared of the conic/(N - 5))
 *
 * with 2 and N - 5 degrees of freedom so large a difference comes about by chance more than once in twenty times; from F a common factor of
 * given deviations drops out.  Otherwise all is 0.
 *
 * Intervals.  Of a short arc the radius R and the distance of the centre are determined through the height of the arc, and so by their
 * reciprocals: linear in the errors are the curvature k = 1/R, the place of the arc's middle M across the curve, h, and its direction there, theta.
 * 95 % of R is all R > 0 with |1/R - k| <= q s_k; a coordinate x of the centre is where the linear form k (x - M_x) - (1 + k h) n_x does not differ
 * from 0 by more than q of its standard errors, n from M to the centre (Fieller's theorem).  There are no intervals where the
 * distances are more than a twentieth of the radius.  Source: fieller-1954. */
typedef struct cagd_fit_circle {
    int known;
    cagd_fit_number centre[2], radius;
    double sweep;       /* how far around the feet of the points go, in degrees */
    double rms, ratio;  /* of its distances; F                                  */
    int freedom;        /* N - 5                                                */
    double probability; /* of so large an F, or a larger one, by chance         */
} cagd_fit_circle;

/* `data` and `options` as for the fit.  Statuses: OK, NO_MEMORY. */
CAGD_API cagd_status cagd_fit_circle_of(const cagd_fit_data *data, const cagd_fit_options *options,
                                        const cagd_fit_result *result, cagd_fit_circle *circle);

/* Whether the fitted curve turns as at a cusp (尖点), and at which parameter, *t.
 *
 * Where the speed |C'| is smallest, C' is orthogonal to C'', and the radius of curvature is |C'|^2/|C''|.  Feet, rank
 * and standard errors come from distances to tangents, which have a meaning as long as the distances are smaller than
 * the radii of curvature.  1: at *t, where the radius is smallest of all such places, it is not larger than the root
 * mean square of the distances or the roundings of coordinates.  0: there is no such place; *t is as before. */
CAGD_API int cagd_fit_has_cusp(const cagd_fit_result *result, double *t);

/* How long the curve is, for a polygon of points in their order of length 1; where neighbours are nearer than their errors, of means of
 * neighbours.  A curve that follows its points is hardly
 * longer than their polygon, which errors make longer still: where neighbours are farther apart than their errors and the curve turns
 * between them by at most 130 degrees, an arc, the ratio is at most CAGD_FIT_LONGEST_RATIO.  A larger one says that the curve has loops or
 * excursions that no points show.  Of points in no order it says nothing.  NaN where the length is not finite. */
#define CAGD_FIT_LONGEST_RATIO 1.26
CAGD_API double cagd_fit_length_ratio(const cagd_fit_data *data, const cagd_fit_result *result);

/* What is not good about a fit, whatever is known of its minimum; added up.
 *
 * EXCURSIONS   the curve is longer than CAGD_FIT_LONGEST_RATIO times the polygon of the points, cagd_fit_length_ratio, or makes a detour between two neighbouring
 * feet: it is more than CAGD_FIT_LONGEST_RATIO times as long there as a curve that turns no more than their chord and those beside it, and ten times the root mean
 * square of the distances longer
 * LOOPS        in the plane: it crosses itself more often than that polygon does
 * GAPS         between two neighbouring feet lies more than a tenth of its length, and more than four times the usual part of it
 * STRUCTURE    neighbours lie on one side more often than by chance once in a hundred times, or some of them by more than so, or distances are as
 * like the next, or once in a thousand times like those k further on, cagd_fit_runs_of, where the unknowns are a fourth of n or fewer;
 * no problem where all distances are beneath what the points are given to, cagd_fit_beneath
 * FAR          a control point is farther from the points than these are from one another
 * BACKWARDS    of points in order, feet fall back behind the one before by more than the distances explain: by more than
 * 6 times their root mean square along the curve: one in twenty of them, or one by 12 times that and a tenth of the length
 * COARSE       the root mean square is more than a fiftieth of the size of the points, with unknown errors, and nothing else tells noise from a
 * curve that is too simple: there are fewer than 30 pairs of neighbours, too few for STRUCTURE, or a smoothing term, which may have made a curve
 * between two sides of the points, whose distances alternate as noise does
 * DEVIATIONS   the given standard deviations are too small for the distances, which a chi-squared so large says once in a thousand times by chance, or
 * the curve is too simple
 * SIMPLE       of a candidate: another one that was tried, and does not go to and fro, has a score that is lower by more than 10 */
enum {
    CAGD_FIT_EXCURSIONS = 1,
    CAGD_FIT_LOOPS = 2,
    CAGD_FIT_GAPS = 4,
    CAGD_FIT_STRUCTURE = 8,
    CAGD_FIT_FAR = 16,
    CAGD_FIT_BACKWARDS = 32,
    CAGD_FIT_COARSE = 64,
    CAGD_FIT_SIMPLE = 128,
    CAGD_FIT_DEVIATIONS = 256
};

/* What all distances are beneath, so that structure in them says nothing about what was measured.  DIGITS: half the diagonal of a cell of the last
 * decimal place that is written, at most nine behind the point.  DEVIATIONS: the given standard deviations.  SIZE: without these, 10^-5 of the extent
 * of the points, the diagonal of their box, and 10^-4 of their width, twice the largest distance from their main axis; the finest grade of tolerances
 * of workpieces, IT01 of ISO 286-1, is about that. */
typedef enum cagd_fit_beneath {
    CAGD_FIT_BENEATH_NOTHING,
    CAGD_FIT_BENEATH_DIGITS,
    CAGD_FIT_BENEATH_DEVIATIONS,
    CAGD_FIT_BENEATH_SIZE
} cagd_fit_beneath;

enum { CAGD_FIT_STRAYS = 3 };

typedef struct cagd_fit_quality {
    int problems;
    double length_ratio;                /* NaN of points in no order                                              */
    int crossings, crossings_of_points; /* of the curve with itself, of the polygon                 */
    double gap, gap_from, gap_to;       /* the widest one as a part of the length, between two parameters */
    double detour, detour_from,
        detour_to; /* how long the curve is between two neighbouring feet where it makes a detour; 0: nowhere, or the whole is too long */
    cagd_fit_runs runs;
    cagd_fit_beneath beneath; /* of distances with structure that is no problem; otherwise NOTHING                 */
    int far;                  /* the control point; -1: none                                            */
    int backwards;            /* how many feet                                                          */
    int strays; /* points of another kind of error, which squares follow: farther than ten standard deviations as the median of
                      the distances has them, alone or two or three together between neighbours within two; no problem of the curve, and a robust loss cures it        */
    int stray[CAGD_FIT_STRAYS]; /* the first of them                                         */
    int too_large; /* 1: a chi-squared as small as this one is by chance once in a thousand times: the given deviations are too large */
} cagd_fit_quality;

/* `data` as for the fit; a point that repeats the first one is passed over.  Statuses: OK, NO_MEMORY. */
CAGD_API cagd_status cagd_fit_quality_of(const cagd_fit_data *data, const cagd_fit_options *options,
                                         const cagd_fit_result *result, cagd_fit_quality *quality);

/* What cures a fit that is no minimum or not good: other wishes, each of them tried on the same points, in this order, until nothing is found
 * against a fit.
 *
 * ITERATIONS ten times as many, where they did not suffice.  STARTS: eight, where the curve was refuted.  INNER: weights 1.  BOUNDS: weights
 * between 1/16 and 16.  HUBER: where points lie far off, HUBER_AUTO: with as many
 * control points as the points ask for.  UNORDERED, and then the polygon of the points goes from foot to foot.  MONOTONE.  SMOOTH:
 * a smoothing term by cross-validation.  COUNT: so many control points, fewer, or of a few points more.  LIGHTER: a smoothing term of less weight.
 * DEGREE: a higher one.  AUTO: as many control points as the points ask for.  DEGREES: the degree that they ask for.
 *
 * Whether points are in order no fit can tell: where feet go back UNORDERED and MONOTONE are both tried. */
typedef enum cagd_fit_cure {
    CAGD_FIT_CURE_ITERATIONS,
    CAGD_FIT_CURE_STARTS,
    CAGD_FIT_CURE_INNER,
    CAGD_FIT_CURE_BOUNDS,
    CAGD_FIT_CURE_HUBER,
    CAGD_FIT_CURE_UNORDERED,
    CAGD_FIT_CURE_MONOTONE,
    CAGD_FIT_CURE_SMOOTH,
    CAGD_FIT_CURE_COUNT,
    CAGD_FIT_CURE_LIGHTER,
    CAGD_FIT_CURE_DEGREE,
    CAGD_FIT_CURE_AUTO,
    CAGD_FIT_CURE_DEGREES,
    CAGD_FIT_CURE_HUBER_AUTO
} cagd_fit_cure;

/* One that was tried: what cagd_fit_choose was asked, and what came of it. */
typedef struct cagd_fit_trial {
    cagd_fit_cure cure;
    cagd_fit_options options;
    cagd_fit_choices choices;
    int minimum, problems; /* of that fit, as cagd_fit_quality says; all of them where it is no minimum */
    double rms;            /* of a robust loss without its outliers                                     */
} cagd_fit_trial;

enum { CAGD_FIT_MAX_TRIALS = 12, CAGD_FIT_MOST_TRIED = 2000, CAGD_FIT_MOST_TRIED_CONTROL_POINTS = 60 };

typedef struct cagd_fit_cures {
    int count;    /* of trials                                                                                      */
    int best;     /* the first one that is a minimum and that nothing is found against; -1: none                    */
    int too_many; /* 1: nothing was tried, since there are more than MOST_TRIED points or so many control points    */
    cagd_fit_trial trial[CAGD_FIT_MAX_TRIALS];
} cagd_fit_cures;

/* `data`, `options` and `choices` are those that led to the result, `quality` is that of the result.  Of a good fit nothing is tried.  Statuses:
 * OK, NO_MEMORY. */
CAGD_API cagd_status cagd_fit_cures_of(const cagd_fit_data *data, const cagd_fit_options *options,
                                       const cagd_fit_choices *choices, const cagd_fit_result *result,
                                       const cagd_fit_quality *quality, cagd_fit_cures *cures);

#ifdef __cplusplus
}
#endif
#endif
