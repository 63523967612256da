/* foot.h -- the foot point (垂足) of one point for all curves of a box (only for this folder). */
#ifndef CAGD_STATIONARY_FOOT_H
#define CAGD_STATIONARY_FOOT_H

#include "core/number/limits.h"
#include "exact/fit/box.h"
#include "exact/fit/words.h"

/* So many more spans than one may a foot be in, and so many points of the curve count then. */
enum { MORE_SPANS = 2, WIDTH = MAX_DEGREE + 1 + MORE_SPANS };

/* What is seen from Q_i at the parameters of an interval: the points that count are first, ..., first + width - 1. */
struct view {
    int first, width;
    num_i R[3][WIDTH];                          /* rational basis, and its derivatives by t                     */
    num_i X[WIDTH * MAX_DIM];                   /* P_m - Q                                                       */
    num_i D[MAX_DIM], C1[MAX_DIM], C2[MAX_DIM]; /* C - Q = sum R_m (P_m - Q), C', C''                 */
    num_i phi, slope;                           /* D.C' and its derivative |C'|^2 + D.C''                        */
};

/* NO_FOOT: b->reason says why.  INSIDE: the zero of phi.  AT_END: it stays at an end of the domain.  NEAR_END: in
 * the box there may be curves of either kind.  ON_FIXED_END: the curve ends in the point, whatever the unknowns are. */
enum foot { NO_FOOT, FOOT_INSIDE, FOOT_AT_END, FOOT_NEAR_END, FOOT_ON_FIXED_END };

/* The foot of point i, near the given one; *v is what is seen from it, but for ON_FIXED_END.  Sets b->where. */
enum foot cagd_stationary_enclose_foot(struct box *b, int i, struct view *v);
#endif
