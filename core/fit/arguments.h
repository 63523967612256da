/* arguments.h -- whether data and options are what cagd_fit.h says. */
#ifndef CAGD_FIT_ARGUMENTS_H
#define CAGD_FIT_ARGUMENTS_H

#include "core/fit/cagd_fit.h"
#include "core/require.h"

/* CAGD_OK or what is wrong; knots and the initial curve are checked where they are taken in, problem.h. */
cagd_status fit_check_options(const cagd_fit_options *options);

/* The same; one point suffices, and all may be equal, when nothing is free.  *where: the index of the point that is
 * wrong, or -1. */
cagd_status fit_check_data(const cagd_fit_data *data, int nothing_free, int *where);
#endif
