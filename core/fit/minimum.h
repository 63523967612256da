/* minimum.h -- the lowest of the minima that several starts lead to. */
#ifndef CAGD_FIT_MINIMUM_H
#define CAGD_FIT_MINIMUM_H

#include "core/fit/attempt.h"

typedef struct fit_minimum {
    fit_attempt attempt; /* the best one                                     */
    int start;           /* its number                                       */
    int agreeing_starts; /* how many starts have ended at the same cost      */
} fit_minimum;

/* All starts that the options ask for, and some more as long as none has come to a minimum.  Returns 0 when there is
 * no memory; fit_minimum_free is to be called all the same. */
int fit_minimum_of(const fit_problem *problem, fit_minimum *minimum);
void fit_minimum_free(fit_minimum *minimum);
#endif
