/* candidate.h -- how curves with different numbers of unknowns are compared. */
#ifndef CAGD_FIT_CANDIDATE_H
#define CAGD_FIT_CANDIDATE_H

#include "core/fit/cagd_fit.h"

/* Whether a curve counts: a minimum without excursions that no points show. */
int fit_is_good(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *result);

/* *problems: what is not good about a curve, as cagd_fit_quality_of says; all of it where the curve does not count.  Structure is among them where
 * it is beneath standard deviations or size, *beneath = 1: a curve that has none is better still.  OK, NO_MEMORY. */
cagd_status fit_problems_of(const cagd_fit_data *data, const cagd_fit_options *options, const cagd_fit_result *result,
                            int *problems, int *beneath);

/* A difference of scores that is very strong evidence against the curve with the higher one.  Source: kass-raftery-1995. */
enum { FIT_VERY_STRONG = 10 };

/* The score of cagd_fit.h, cagd_fit_choose; infinite where there are too few points for so many unknowns. */
double fit_score(const cagd_fit_data *data, const cagd_fit_result *result);

/* n = N (dim-1), and the unknowns that the points determine, without those of the ends. */
double fit_equations_of(const cagd_fit_data *data);
double fit_unknowns_of(const cagd_fit_result *result);
#endif
