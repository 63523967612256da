/* radical.h -- inequalities with square roots of functions of other names: r^2 = q, r >= 0, as of lengths (根式不等式).
 *
 * A polynomial is A + B r with A and B free of r.  It is at least 0 where A, B >= 0, where B >= 0 and B^2 q >= A^2, and where A >= 0 and
 * A^2 >= B^2 q; each of these has one root less, and in the end signs in a box decide (sign.h).  What is not shown so is not refuted. */
#ifndef CAGD_RADICAL_H
#define CAGD_RADICAL_H

#include "exact/expression/sign.h"

/* x^2 = square, x a variable of the field on which `square` does not depend. */
typedef struct cagd_square_root {
    cagd_num_f x, square;
} cagd_square_root;

/* p with the squares of the roots in the place of even powers: A + B x for each of them. */
cagd_num_f cagd_without_powers(cagd_num_f p, int roots, const cagd_square_root root[]);
/* Whether it is shown that the polynomial p is at least 0 in the box, where the roots are at least 0, too. */
int cagd_is_nonnegative_with_roots(cagd_num_f p, int roots, const cagd_square_root root[], int count,
                                   const cagd_side_of_box side[]);
#endif
