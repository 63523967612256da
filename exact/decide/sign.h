/* sign.h -- the sign of a polynomial over Q on an interval, exactly. */
#ifndef CAGD_SIGN_H
#define CAGD_SIGN_H

#include "exact/decide/roots.h"

enum sign_pattern {
    SIGN_ZERO,        /* p = 0 everywhere                                                         */
    SIGN_POSITIVE,    /* p > 0 on the whole interval                                              */
    SIGN_NONNEGATIVE, /* p >= 0, and somewhere p = 0 and somewhere p > 0                          */
    SIGN_NONPOSITIVE, /* p <= 0, and somewhere p = 0 and somewhere p < 0                          */
    SIGN_NEGATIVE,    /* p < 0 on the whole interval                                              */
    SIGN_MIXED        /* p < 0 somewhere and p > 0 somewhere                                      */
};

/* Of p on the interval with the given ends.  UNDEFINED for an empty interval. */
enum sign_pattern sign_on(poly p, num_q a, num_q b, enum ends ends);
#endif
