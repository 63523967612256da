/* problem.h -- what is asked, read from NAME.json and NAME.csv.  One process certifies one problem, which is this
 * one; after read_problem it does not change. */
#ifndef CERTIFY_PROBLEM_H
#define CERTIFY_PROBLEM_H

#include "proofs-tests/fit/certify/number.h"

#include <jansson.h>

enum { MOST = 32 }; /* unknowns, and points of the curve */

enum loss { SQUARES, HUBER, CAUCHY };

struct problem {
    int p, count, dim;           /* degree of the curve, its points, their coordinates */
    num *knot, *weight, *points; /* the true curve, with what is given put in */

    int N; /* measured points Q with their standard deviations, 1 where none are given */
    double *Q, *sigma;
    int known_sigma;

    enum loss loss;
    double scale, low, high; /* of the loss; bounds of the weights */

    /* All m unknowns, logarithms of weights and coordinates of points.  Those that are held, because they are on a
     * bound or the file says so, are not varied; varied[0], ..., varied[n-1] are. */
    struct {
        int is_weight, index, coordinate;
    } unknown[MOST];
    int m, held[MOST], at_bound[MOST], n, varied[MOST];

    num largest_coordinate, smallest_span; /* for the conditions */
};
extern struct problem problem;

/* What is looked for: the unknowns, and the foot of every point. */
struct found {
    num *value, *foot, gradient; /* gradient: its largest component at the end */
    int *at_end;
};
extern struct found found;

/* `file`, at `path`, and the points beside it.  The unknowns begin at the true curve; the feet are not set. */
void read_problem(const char *path, json_t *file);
#endif
