/* closing.h -- whether the last point is the first one once more. */
#ifndef CAGD_FIT_CLOSING_H
#define CAGD_FIT_CLOSING_H

#include "core/fit/cagd_fit.h"

/* Up to the roundings of binary64 in computing them, 2^-40 of the way between the points that are farthest from the first one. */
int fit_repeats_first(const cagd_fit_data *data);
#endif
