/* plain_ceres.h -- a peer of the fit: the same minimum as one Ceres problem of all unknowns.
 *
 * theta and a foot for every point are unknowns together; derivatives by their formulas; default options but for tolerance and
 * number of iterations.  It starts where cagd_fit does, and knows nothing of elimination, means of points or Newton's steps. */
#ifndef CAGD_BENCH_PLAIN_CERES_H
#define CAGD_BENCH_PLAIN_CERES_H

#include "core/fit/cagd_fit.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct plain_outcome {
    int iterations;
    int converged; /* 0 also where a foot has left the domain */
    double cost;   /* F as in cagd_fit.h                     */
} plain_outcome;

/* The options are those of cagd_fit; the first start alone is made. */
cagd_status plain_ceres(const cagd_fit_data *data, const cagd_fit_options *options, plain_outcome *outcome);

#ifdef __cplusplus
}
#endif
#endif
