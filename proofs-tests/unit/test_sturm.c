/* test_sturm.c -- Sturm's theorem against planted roots. */
#include "unit_roots.h"

#include "exact/decide/sturm.h"
#include "exact/words.h"

static void planted_roots(void **state)
{
    (void)state;
    for (int k = 0; k < 400; k++) {
        region_mark m = region_open();
        struct planted f = plant();
        num_q a = f.count > 0 && k % 2 ? f.at[random_int(0, f.count - 1)] : coarse_q(3, 7);
        num_q b = f.count > 0 && k % 3 ? f.at[random_int(0, f.count - 1)] : coarse_q(3, 7), far = from_int_q(1000000);
        if (cagd_compare_q(a, b) <= 0)
            assert_int_equal(cagd_sturm_count(f.p, a, b),
                             cagd_compare_q(a, b) == 0 ? 0 : planted_count(&f, a, b, OPEN_LEFT).distinct);
        assert_int_equal(cagd_sturm_count_above(f.p, a), planted_count(&f, a, far, OPEN).distinct);
        assert_int_equal(cagd_sturm_count_below(f.p, a), planted_count(&f, neg_q(far), a, OPEN_LEFT).distinct);
        assert_int_equal(cagd_sturm_count_line(f.p), f.count);
        region_drop(m);
    }
}

static void edges(void **state)
{
    (void)state;
    num_q zero = from_int_q(0), one = from_int_q(1);
    assert_int_equal(cagd_sturm_count_line(poly_constant(one)), 0);
    assert_int_equal(cagd_sturm_count(poly_variable(), zero, one), 0); /* (0,1] */
    cagd_sturm_count_line(poly_from_q(0, NULL));
    expect_fault(FAULT_UNDEFINED);
    cagd_sturm_count(poly_variable(), one, zero);
    expect_fault(FAULT_UNDEFINED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(planted_roots), unit(edges)};
    return run_unit_tests(tests);
}
