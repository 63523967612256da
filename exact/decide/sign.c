#include "exact/decide/sign.h"
#include "exact/words.h"

/* The sign at the first of the points a + (b - a)/k, k = 2, 3, ..., that is no root.  a < b, p != 0. */
static int sign_somewhere_inside(poly p, num_q a, num_q b)
{
    int s = 0;
    for (long k = 2; s == 0; k++)
        s = cagd_sign_q(poly_value(p, add_q(a, mul_q(from_ratio_q(1, k), sub_q(b, a)))));
    return s;
}

int cagd_is_nonnegative(enum cagd_sign_pattern sign)
{
    return sign == SIGN_ZERO || sign == SIGN_POSITIVE || sign == SIGN_NONNEGATIVE;
}

enum cagd_sign_pattern cagd_sign_on(poly p, num_q a, num_q b, enum cagd_ends ends)
{
    int order = cagd_compare_q(a, b);
    if (order > 0 || (order == 0 && ends != CLOSED)) {
        region_faults |= FAULT_UNDEFINED;
        return SIGN_ZERO;
    }
    if (cagd_poly_is_zero(p))
        return SIGN_ZERO;
    region_mark m = region_open();
    struct cagd_root_count roots = cagd_count_roots(p, a, b, ends);
    int s = order == 0 ? cagd_sign_q(poly_value(p, a)) : sign_somewhere_inside(p, a, b);
    region_drop(m);
    if (s == 0)
        return SIGN_ZERO;
    if (roots.crossings > 0)
        return SIGN_MIXED;
    if (roots.distinct > 0)
        return s > 0 ? SIGN_NONNEGATIVE : SIGN_NONPOSITIVE;
    return s > 0 ? SIGN_POSITIVE : SIGN_NEGATIVE;
}

int cagd_is_nonnegative_on(poly p, num_q a, num_q b) { return cagd_is_nonnegative(cagd_sign_on(p, a, b, CLOSED)); }
