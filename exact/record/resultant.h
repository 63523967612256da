/* resultant.h -- determinants and resultants (exact/decide/resultant.h), with testimony (number.h). */
#ifndef CAGD_RECORD_RESULTANT_H
#define CAGD_RECORD_RESULTANT_H

#include "exact/decide/resultant.h"
#include "exact/record/polynomial.h"

cagd_num_q cagd_testify_pivoted_determinant_q(int n, const cagd_num_q A[]); /* a fact of its own             */
cagd_num_f cagd_testify_pivoted_determinant_f(int n, const cagd_num_f A[]); /* whether a pivot is 0 is noted */
cagd_num_f cagd_testify_resultant_by_f(cagd_num_f p, cagd_num_f q, cagd_num_f variable);

#define pivoted_determinant_q cagd_testify_pivoted_determinant_q
#define pivoted_determinant_f cagd_testify_pivoted_determinant_f
#define resultant_by_f        cagd_testify_resultant_by_f
#endif
