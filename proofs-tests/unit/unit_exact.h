/* unit_exact.h -- what the unit tests of exact/ share: cmocka, and seeded high-entropy data. */
#ifndef CAGD_UNIT_EXACT_H
#define CAGD_UNIT_EXACT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "exact/number/rational.h"
#include "exact/number/region.h"
#include "exact/words.h"

/* splitmix64: every seed gives the same data on every machine. */
static uint64_t random_state = 20240607;
static inline uint64_t random_bits(void)
{
    uint64_t z = random_state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}
/* Uniform in lo..hi; 64 bits in between, since hi - lo may be beyond an int. */
static inline int random_int(int lo, int hi)
{
    return (int)(lo + (int64_t)(random_bits() % (uint64_t)((int64_t)hi - lo + 1)));
}

/* Numerators and denominators of about nine digits. */
static inline num_q random_q(void) { return from_ratio_q(random_int(-999999937, 999999937), random_int(1, 999999893)); }
/* Few different values, so that coincidences happen. */
static inline num_q coarse_q(int size, int denominator)
{
    return from_ratio_q(random_int(-size, size), random_int(1, denominator));
}

/* Every test starts with an empty region and no faults, and must leave without faults. */
static inline int unit_setup(void **state)
{
    (void)state;
    region_faults = 0;
    return 0;
}
static inline int unit_teardown(void **state)
{
    (void)state;
    region_drop((region_mark){.precision = 128});
    return region_faults != 0;
}
static inline int unit_end(void **state)
{
    (void)state;
    cagd_thread_end();
    return 0;
}

/* The fault that is expected, and none remains. */
static inline void expect_fault(unsigned fault)
{
    assert_int_equal(region_faults, fault);
    region_faults = 0;
}

#define unit(test)           cmocka_unit_test_setup_teardown(test, unit_setup, unit_teardown)
#define run_unit_tests(list) cmocka_run_group_tests(list, NULL, unit_end)
#endif
