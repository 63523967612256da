/* sign.h -- the sign of a polynomial (exact/decide/sign.h), with testimony (number.h). */
#ifndef CAGD_RECORD_SIGN_H
#define CAGD_RECORD_SIGN_H

#include "exact/decide/sign.h"
#include "exact/record/roots.h"

enum cagd_sign_pattern cagd_testify_sign_on(cagd_poly p, cagd_num_q a, cagd_num_q b, enum cagd_ends ends);
/* Whether p >= 0 on [a,b]. */
int cagd_testify_is_nonnegative_on(cagd_poly p, cagd_num_q a, cagd_num_q b);

#define sign_on           cagd_testify_sign_on
#define is_nonnegative_on cagd_testify_is_nonnegative_on
#endif
