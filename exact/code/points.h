/* points.h -- the points at which code is run: values of the inputs of a harness. */
#ifndef CAGD_CODE_POINTS_H
#define CAGD_CODE_POINTS_H

#include "exact/code/harness.h"
#include "exact/code/run.h"

/* Values for all inputs, as a job takes them. */
struct cagd_code_point {
    int inputs;
    struct cagd_code_input input[CAGD_CODE_MOST_IN_HARNESS];
};

/* The k-th point: small numbers at first.  fine: numbers with many digits.  The same for the same name of the harness. */
struct cagd_code_point *cagd_code_point_new(const struct cagd_code_harness *h, long k, int fine);
struct cagd_code_point *cagd_code_point_copy(const struct cagd_code_point *p);
void cagd_code_point_free(struct cagd_code_point *p);
/* One value of it becomes this text. */
void cagd_code_point_set(struct cagd_code_point *p, int input, int element, const char *text);

/* In how many ways neighbours in inputs that do not decrease can be equal; 1 where there are none. */
long cagd_code_patterns(const struct cagd_code_harness *h);
#endif
