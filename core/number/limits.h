/* limits.h -- the stated limits of the kernels.  Workspaces have these sizes; callers check them. */
#ifndef CAGD_LIMITS_H
#define CAGD_LIMITS_H

enum {
    MAX_DEGREE = 64, /* of a curve; binomial(MAX_DEGREE, i) fits in a long                     */
    MAX_DIM = 4,     /* coordinates of a point, the homogeneous one included                    */
    MAX_ORDER = 24   /* rows of a determinant                                                   */
};
#endif
