/* crossings.h -- how a plane curve or polygon meets a straight line: common points are one thing,
 * crossings another.  A tangent has a common point and crosses nothing; an endpoint on the line is a
 * common point and no crossing.  Statements about "intersections" hold for one and fail for the
 * other, so both are counted here.
 *
 * The line is a x + b y + c = 0.  Points are pairs x, y, one after the other. */
#ifndef CAGD_CROSSINGS_H
#define CAGD_CROSSINGS_H

#include "exact/number/rational.h"

struct cagd_line {
    cagd_num_q a, b, c;
};

struct cagd_curve_meets_line {
    int contained;     /* the whole curve is on the line; the counts of common points are then 0   */
    int common_closed; /* parameters in [0,1] whose point is on the line                           */
    int common_open;   /* the same in (0,1)                                                        */
    int crossings;     /* those in (0,1) where a x + b y + c changes its sign                      */
    int touches;       /* those in (0,1) where it does not: common_open = crossings + touches      */
    int poles;         /* parameters in [0,1] whose point is at infinity                           */
    int jumps;         /* those in (0,1) where a x + b y + c changes its sign                      */
};

/* The rational Bezier curve with points R[0 .. 2 n + 1] and weights w[0 .. n],
 *
 *     (x, y) = sum w_i R_i B_i^n(t) / sum w_i B_i^n(t),   0 <= t <= 1,
 *
 * numerators and denominator freed of common factors: that gives the curve its points where the
 * quotient is 0/0.  Weights may be negative or zero.  Parameters are counted, so that a double point
 * on the line counts twice and a constant curve on it is `contained`.
 * UNDEFINED when all weights are 0 and when a = b = 0. */
struct cagd_curve_meets_line cagd_curve_meets_line(int n, const cagd_num_q R[], const cagd_num_q w[],
                                                   struct cagd_line line);

struct cagd_polygon_meets_line {
    int crossings;       /* changes of the sign of a x + b y + c along R_0 ... R_n, zeros skipped  */
    int common_runs;     /* maximal intervals of the polygon's parameter on which it is on the line,
                            single parameters included                                             */
    int components;      /* connected components of the set of common points, in the plane         */
    int contained_edges; /* edges R_i R_(i+1) of positive length on the line                       */
};

/* The open polygon R_0 R_1 ... R_n, n >= 0, R[0 .. 2 n + 1].  A closed one repeats its first point.
 * UNDEFINED when a = b = 0. */
struct cagd_polygon_meets_line cagd_polygon_meets_line(int n, const cagd_num_q R[], struct cagd_line line);

int cagd_polygon_crossings(int n, const cagd_num_q R[], struct cagd_line line); /* the first count alone            */
#endif
