/* polyhedron.h -- where conditions on the inputs hold: whether anywhere, and at which point. */
#ifndef CAGD_CODE_POLYHEDRON_H
#define CAGD_CODE_POLYHEDRON_H

#include "exact/number/rational.h"

enum { CAGD_CODE_ZERO = 1, CAGD_CODE_ABOVE = 2, CAGD_CODE_BELOW = 4 };

/* The signs of -f where f has these. */
static inline int cagd_code_turned(int signs)
{
    return (signs & CAGD_CODE_ZERO) | (signs & CAGD_CODE_ABOVE ? CAGD_CODE_BELOW : 0) |
           (signs & CAGD_CODE_BELOW ? CAGD_CODE_ABOVE : 0);
}

/* A polynomial with whole coefficients, as the field writes it: "3*k[1]*t-t^2+5"; its sign is one of `signs`, a sum of the above. */
struct cagd_code_claim {
    const char *polynomial;
    int signs;
};

/* Values of variables, in the region. */
struct cagd_code_witness {
    int count;
    const char **name;
    const cagd_num_q *value;
};

/* 0: the claims are true together nowhere, which is proved.  1: a point, which is one where all polynomials are linear; a monomial of
 * higher degree is treated as a variable of its own, positive where its factors are, so at the point some claim may be false.
 * -1: not decided. */
int cagd_code_is_anywhere(int count, const struct cagd_code_claim claim[], struct cagd_code_witness *witness);

/* Whether the claims are true at a point, of which `value` tells the variable of that name; a polynomial that cannot be read is not. */
int cagd_code_hold_at(int count, const struct cagd_code_claim claim[],
                      cagd_num_q (*value)(const void *context, const char *name, size_t length), const void *context);
#endif
