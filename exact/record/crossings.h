/* crossings.h -- how curves and polygons meet a line (exact/decide/crossings.h), with testimony (number.h). */
#ifndef CAGD_RECORD_CROSSINGS_H
#define CAGD_RECORD_CROSSINGS_H

#include "exact/decide/crossings.h"

struct cagd_curve_meets_line cagd_testify_curve_meets_line(int n, const cagd_num_q R[], const cagd_num_q w[],
                                                           struct cagd_line line);
struct cagd_polygon_meets_line cagd_testify_polygon_meets_line(int n, const cagd_num_q R[], struct cagd_line line);
int cagd_testify_polygon_crossings(int n, const cagd_num_q R[], struct cagd_line line); /* all counts are noted */

#define curve_meets_line   cagd_testify_curve_meets_line
#define polygon_meets_line cagd_testify_polygon_meets_line
#define polygon_crossings  cagd_testify_polygon_crossings
#endif
