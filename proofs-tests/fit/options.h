/* options.h -- options of the fits that the tests make. */
#ifndef CAGD_TESTS_FIT_OPTIONS_H
#define CAGD_TESTS_FIT_OPTIONS_H

#include "core/fit/cagd_fit.h"

/* The defaults, but for the ends: exact unless END_POINTS is added to `free`, and then sliding. */
static inline cagd_fit_options options_with_exact_ends(void)
{
    cagd_fit_options options = cagd_fit_defaults();
    options.free = CAGD_FIT_WEIGHTS | CAGD_FIT_INNER_POINTS;
    options.ends = CAGD_FIT_ENDS_SLIDE;
    return options;
}
#endif
