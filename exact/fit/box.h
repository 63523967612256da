/* box.h -- a box of unknowns, and the cost over it (only for this folder).
 *
 * A box is a centre, which is the curve of a cagd_stationary_problem, and a radius for every unknown, in the logarithm
 * where it is a weight.  cagd_stationary_enclose sums over the points what each adds to the gradient and to the Hessian,
 * for all curves of the box at once; the formulas stand in stationary.h. */
#ifndef CAGD_STATIONARY_BOX_H
#define CAGD_STATIONARY_BOX_H

#include "exact/fit/stationary.h"
#include "exact/fit/words.h"
#include "exact/kernels_i.h"

struct box {
    const cagd_stationary_problem *problem;
    int n;                          /* unknowns                                                        */
    const double *radius;           /* of each unknown                                                 */
    const double *rest;             /* the centre's coordinates are the points of the curve and these; NULL: none */
    int *of_weight, *of_coordinate; /* the unknown that a weight or coordinate is, or -1               */
    num_i *knot, *point, *weight;   /* in intervals                                                    */
    struct cagd_interval *gradient, *hessian; /* of which the upper triangle is filled                         */
    int is_point;                             /* all radii are 0                                               */
    const char *reason;
    int where;
};

static inline int is_held(const cagd_stationary_problem *problem, int a)
{
    return problem->held != NULL && problem->held[a];
}

/* Which of the own points of the curve, those of the unknowns, point i is. */
static inline int own_point(const cagd_stationary_problem *problem, int i)
{
    return problem->period > 0 ? (i - problem->shift + 2 * problem->period) % problem->period : i;
}

/* Takes memory for everything; 0 where there is none, and then cagd_stationary_box_free is to be called as well. */
int cagd_stationary_box_new(struct box *b, const cagd_stationary_problem *problem);
void cagd_stationary_box_free(struct box *b);

/* Gradient and Hessian over the box, summed over every stride-th point.  1; or 0, and reason and where say why not. */
int cagd_stationary_enclose(struct box *b, const double radius[], int stride);
#endif
