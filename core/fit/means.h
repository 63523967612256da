/* means.h -- points whose noise is larger than the way from one to the next, and the means of their neighbours. */
#ifndef CAGD_FIT_MEANS_H
#define CAGD_FIT_MEANS_H

#include "core/fit/cagd_fit.h"

/* Of points in order: how many neighbours to take together, 3, 9, 27, ..., so that the polygon of the means is not longer because of noise.  The
 * polygon of points that scatter by more than they are apart goes to and fro, and is shorter, each time, by much when three of them become
 * one.  1: the points do as they are, or there are too few. */
int fit_neighbours(const cagd_fit_data *data);

/* The means of that many neighbours, weighted by 1/sigma^2, with the standard deviations that they have; the last group may be larger.
 * Releases nothing of `data`; fit_means_free releases what is made.  CAGD_NO_MEMORY. */
cagd_status fit_means(const cagd_fit_data *data, int neighbours, cagd_fit_data *means);
void fit_means_free(cagd_fit_data *means);
#endif
