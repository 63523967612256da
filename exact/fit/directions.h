/* directions.h -- directions that make the Hessian nearly diagonal (only for this folder). */
#ifndef CAGD_STATIONARY_DIRECTIONS_H
#define CAGD_STATIONARY_DIRECTIONS_H

#include "exact/fit/box.h"
#include "exact/fit/words.h"

/* W (n x k by columns, W[a*n + j]) and the signs, such that W^T H W is nearly the diagonal of signs, where H is the
 * Hessian that was enclosed last; W has no part in unknowns that are held and spans a complement of the free
 * directions.  inverse[j*n + a]: nearly a left inverse of W.  Returns k, 0 where H is singular as far as binary64 can
 * see, or -1 where there is no memory. */
int cagd_stationary_directions(const struct box *b, double W[], double inverse[], int sign[]);
#endif
