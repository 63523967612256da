/* total_positivity.h -- the minors of a matrix (exact/decide/total_positivity.h), with testimony (number.h). */
#ifndef CAGD_RECORD_TOTAL_POSITIVITY_H
#define CAGD_RECORD_TOTAL_POSITIVITY_H

#include "exact/decide/total_positivity.h"

int cagd_testify_is_totally_nonnegative(int rows, int columns, const cagd_num_q A[]);
int cagd_testify_is_totally_positive(int rows, int columns, const cagd_num_q A[]);
int cagd_testify_all_minors_nonnegative(int rows, int columns, const cagd_num_q A[], int strict,
                                        struct cagd_minor *worst);

#define is_totally_nonnegative cagd_testify_is_totally_nonnegative
#define is_totally_positive    cagd_testify_is_totally_positive
#define all_minors_nonnegative cagd_testify_all_minors_nonnegative
#endif
