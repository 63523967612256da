/* roots.h -- the counts of exact/decide/roots.h, with testimony (number.h). */
#ifndef CAGD_RECORD_ROOTS_H
#define CAGD_RECORD_ROOTS_H

#include "exact/decide/roots.h"
#include "exact/record/polynomial.h"

struct cagd_root_count cagd_testify_count_roots(cagd_poly p, cagd_num_q a, cagd_num_q b, enum cagd_ends ends);
struct cagd_root_count cagd_testify_count_roots_line(cagd_poly p);
struct cagd_root_count cagd_testify_count_roots_above(cagd_poly p, cagd_num_q a);
struct cagd_root_count cagd_testify_count_roots_below(cagd_poly p, cagd_num_q b);
int cagd_testify_isolate_roots(cagd_poly p, cagd_num_q a, cagd_num_q b, struct cagd_root out[],
                               int room); /* how many */

#define count_roots       cagd_testify_count_roots
#define count_roots_line  cagd_testify_count_roots_line
#define count_roots_above cagd_testify_count_roots_above
#define count_roots_below cagd_testify_count_roots_below
#define isolate_roots     cagd_testify_isolate_roots
#endif
