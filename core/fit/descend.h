/* descend.h -- from the curve of an attempt downhill to a minimum. */
#ifndef CAGD_FIT_DESCEND_H
#define CAGD_FIT_DESCEND_H

#include "core/fit/attempt.h"

/* From curve and feet of the attempt near to the minimum, until what the unknowns can still take away of the residuals is less than
 * `tolerance` of them, with rough feet.  This and the others leave the objective at the best x, and return 0 when there is no
 * memory. */
int fit_descend_near(const fit_problem *problem, const cagd_fit_options *options, double tolerance,
                     fit_attempt *attempt);

/* To the minimum as far as binary64 goes or `tolerance` of the options asks, and again when a search finds better feet. */
int fit_descend(const fit_problem *problem, const cagd_fit_options *options, fit_attempt *attempt);

/* The same as one problem of all unknowns, for comparison. */
int fit_descend_plain(const fit_problem *problem, const cagd_fit_options *options, fit_attempt *attempt);
#endif
