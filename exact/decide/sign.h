/* sign.h -- the sign of a polynomial over Q on an interval, exactly. */
#ifndef CAGD_SIGN_H
#define CAGD_SIGN_H

#include "exact/decide/roots.h"

enum cagd_sign_pattern {
    CAGD_SIGN_ZERO,        /* p = 0 everywhere                                                         */
    CAGD_SIGN_POSITIVE,    /* p > 0 on the whole interval                                              */
    CAGD_SIGN_NONNEGATIVE, /* p >= 0, and somewhere p = 0 and somewhere p > 0                          */
    CAGD_SIGN_NONPOSITIVE, /* p <= 0, and somewhere p = 0 and somewhere p < 0                          */
    CAGD_SIGN_NEGATIVE,    /* p < 0 on the whole interval                                              */
    CAGD_SIGN_MIXED        /* p < 0 somewhere and p > 0 somewhere                                      */
};

/* Of p on the interval with the given ends.  UNDEFINED for an empty interval. */
enum cagd_sign_pattern cagd_sign_on(cagd_poly p, cagd_num_q a, cagd_num_q b, enum cagd_ends ends);
/* Whether such a sign says p >= 0. */
int cagd_is_nonnegative(enum cagd_sign_pattern sign);
/* Whether p >= 0 on [a,b]. */
int cagd_is_nonnegative_on(cagd_poly p, cagd_num_q a, cagd_num_q b);
#endif
