/* hull.h -- hulls and convex polygons (exact/decide/hull.h), with testimony (number.h). */
#ifndef CAGD_RECORD_HULL_H
#define CAGD_RECORD_HULL_H

#include "exact/decide/hull.h"
#include "exact/record/number.h"

struct cagd_hull_certificate cagd_testify_hull_membership(int d, int count, const cagd_num_q points[],
                                                          const cagd_num_q x[]);
int cagd_testify_polygon_is_convex(int n, const cagd_num_q points[], int closed, int *orientation);
int cagd_testify_convex_hull_2d(int count, const cagd_num_q points[], int vertex[]);

/* Of these two every comparison is noted. */
int cagd_testify_hull_certificate_holds(int d, int count, const cagd_num_q points[], const cagd_num_q x[],
                                        struct cagd_hull_certificate c);
int cagd_testify_turn_2d(const cagd_num_q P[2], const cagd_num_q Q[2], const cagd_num_q R[2]);

#define hull_membership        cagd_testify_hull_membership
#define polygon_is_convex      cagd_testify_polygon_is_convex
#define convex_hull_2d         cagd_testify_convex_hull_2d
#define hull_certificate_holds cagd_testify_hull_certificate_holds
#define turn_2d                cagd_testify_turn_2d
#endif
