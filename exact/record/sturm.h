/* sturm.h -- the counts of exact/decide/sturm.h, with testimony (number.h). */
#ifndef CAGD_RECORD_STURM_H
#define CAGD_RECORD_STURM_H

#include "exact/decide/sturm.h"
#include "exact/record/polynomial.h"

int cagd_testify_sturm_count(cagd_poly p, cagd_num_q a, cagd_num_q b);
int cagd_testify_sturm_count_above(cagd_poly p, cagd_num_q a);
int cagd_testify_sturm_count_below(cagd_poly p, cagd_num_q b);
int cagd_testify_sturm_count_line(cagd_poly p);

#define sturm_count       cagd_testify_sturm_count
#define sturm_count_above cagd_testify_sturm_count_above
#define sturm_count_below cagd_testify_sturm_count_below
#define sturm_count_line  cagd_testify_sturm_count_line
#endif
