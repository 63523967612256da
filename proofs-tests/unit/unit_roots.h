/* unit_roots.h -- polynomials whose real roots are known because they were planted. */
#ifndef CAGD_UNIT_ROOTS_H
#define CAGD_UNIT_ROOTS_H

#include "unit_exact.h"

#include "exact/decide/roots.h"
#include "exact/words.h"

enum { PLANTED = 6 };
struct planted {
    int count;
    num_q at[PLANTED]; /* increasing */
    int multiplicity[PLANTED];
    num_q leading;
    poly p; /* leading times the product of (t - at)^multiplicity, times quadratics without real roots */
};

static inline struct planted plant(void)
{
    struct planted f = {.count = random_int(0, PLANTED)};
    num_q x = from_ratio_q(random_int(-3, 0), random_int(1, 2));
    f.leading = from_ratio_q(random_int(1, 9) * (random_int(0, 1) ? 1 : -1), 7);
    f.p = poly_constant(f.leading);
    for (int k = 0; k < f.count; k++) {
        x = add_q(x, from_ratio_q(random_int(1, 4), random_int(1, 8)));
        f.at[k] = x;
        f.multiplicity[k] = random_int(1, 4);
        for (int m = 0; m < f.multiplicity[k]; m++)
            f.p = poly_mul(f.p, poly_from_q(2, (num_q[]){neg_q(x), from_int_q(1)}));
    }
    for (int k = random_int(0, 2); k > 0; k--) { /* (t - u)^2 + v, v > 0 */
        num_q u = random_q(), v = from_ratio_q(1, random_int(1, 1000));
        num_q c[3] = {add_q(mul_q(u, u), v), mul_q(from_int_q(-2), u), from_int_q(1)};
        f.p = poly_mul(f.p, poly_from_q(3, c));
    }
    return f;
}

/* Counted by comparing, from what was planted. */
static inline struct cagd_root_count planted_count(const struct planted *f, num_q a, num_q b, enum cagd_ends ends)
{
    struct cagd_root_count c = {0};
    for (int k = 0; k < f->count; k++) {
        int left = cagd_compare_q(f->at[k], a), right = cagd_compare_q(f->at[k], b);
        int open = left > 0 && right < 0, odd = f->multiplicity[k] % 2;
        int in = (ends == CLOSED && left >= 0 && right <= 0) || (ends == OPEN_LEFT && left > 0 && right <= 0) ||
                 (ends == OPEN_RIGHT && left >= 0 && right < 0) || open;
        c.distinct += in;
        c.counted += in * f->multiplicity[k];
        c.crossings += open && odd;
        c.touches += open && !odd;
    }
    return c;
}
static inline void assert_same_count(struct cagd_root_count x, struct cagd_root_count y)
{
    assert_int_equal(x.distinct, y.distinct);
    assert_int_equal(x.counted, y.counted);
    assert_int_equal(x.crossings, y.crossings);
    assert_int_equal(x.touches, y.touches);
}
#endif
