/* test_region.c -- where exact values live and when they die. */
#include "unit_exact.h"

#include "exact/number/field.h"
#include "exact/number/guard.h"
#include "exact/number/interval.h"
#include "exact/number/polynomial.h"
#include "exact/words.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <math.h>
#include <pthread.h>
#include <string.h>

static num_q big(int k) /* a number with some 1000 digits of its own */
{
    num_q r = from_ratio_q(2 * k + 1, 3);
    for (int j = 0; j < 9; j++)
        r = add_q(mul_q(r, r), from_ratio_q(1, 5));
    return r;
}

static void older_values_survive_a_drop(void **state)
{
    (void)state;
    enum { KEPT = 40 };
    num_q kept[KEPT];
    const char *text[KEPT];
    for (int k = 0; k < KEPT; k++) {
        kept[k] = big(k);
        text[k] = to_string_q(kept[k]);
        region_mark m = region_open();
        for (int j = 0; j < 200; j++) /* more than a chunk of slots dies here */
            to_string_q(big(1000 + j));
        region_drop(m);
    }
    for (int k = 0; k < KEPT; k++) {
        assert_true(cagd_equal_q(kept[k], big(k)));
        assert_string_equal(text[k], to_string_q(kept[k]));
    }
}

static void a_drop_gives_the_slots_back(void **state)
{
    (void)state;
    region_mark m = region_open();
    num_q first = from_int_q(1);
    const void *slot = first.at;
    char *bytes = region_bytes(10);
    for (int k = 0; k < 5000; k++)
        from_int_q(k);
    region_drop(m);
    assert_ptr_equal(from_int_q(2).at, slot);
    assert_ptr_equal(region_bytes(10), bytes);
}

static void marks_nest(void **state)
{
    (void)state;
    num_q a = from_int_q(1);
    region_mark outer = region_open();
    num_q b = from_int_q(2);
    region_mark inner = region_open();
    from_int_q(3);
    region_drop(inner);
    assert_true(cagd_equal_q(b, from_int_q(2)));
    region_drop(outer);
    assert_true(cagd_equal_q(a, from_int_q(1)));
}

/* Blocks do not overlap, whatever their sizes; 0 bytes and more than a page included. */
static void blocks_are_apart(void **state)
{
    (void)state;
    enum { BLOCKS = 300 };
    unsigned char *block[BLOCKS];
    size_t size[BLOCKS];
    for (int round = 0; round < 3; round++) {
        region_mark m = region_open();
        for (int k = 0; k < BLOCKS; k++) {
            size[k] = k % 7 == 0 ? 0 : k % 11 == 0 ? (size_t)random_int(60000, 200000) : (size_t)random_int(1, 5000);
            block[k] = region_bytes(size[k]);
            assert_int_equal((uintptr_t)block[k] % 16, 0);
            memset(block[k], k % 251, size[k]);
        }
        for (int k = 0; k < BLOCKS; k++)
            for (size_t j = 0; j < size[k]; j++)
                assert_true(block[k][j] == k % 251);
        region_drop(m);
    }
}

/* Pages are 2^16 bytes: requests that fill them to the last byte, and nothing after. */
static void page_boundaries(void **state)
{
    (void)state;
    memset(region_bytes(1 << 16), 1, 1 << 16);
    assert_non_null(region_bytes(0));
    memset(region_bytes((1 << 16) - 16), 2, (1 << 16) - 16);
    memset(region_bytes(16), 3, 16);
    memset(region_bytes(1 << 16), 4, 1 << 16); /* does not fit behind these 16 */
    memset(region_bytes((1 << 16) + 1), 5, (1 << 16) + 1);
}

/* What lies behind a block, and what was dropped: AddressSanitizer stops whoever touches it.  Elsewhere nobody can know. */
static void bytes_of_no_block_are_forbidden(void **state)
{
    (void)state;
#ifdef CAGD_GUARDED
    enum { ROUNDS = 3000 }; /* several pages */
    region_free_all();
    region_mark m = region_open();
    char *first = region_bytes(40), *block = first;
    for (size_t n = 1; n <= ROUNDS; n++) {
        block = region_bytes(n % 100);
        assert_null(__asan_region_is_poisoned(block, n % 100));
        assert_true(__asan_address_is_poisoned(block + n % 100));
    }
    assert_true(__asan_address_is_poisoned(first + 40));
    region_drop(m);
    assert_true(__asan_address_is_poisoned(first));
    assert_true(__asan_address_is_poisoned(block + 1));
    assert_ptr_equal(region_bytes(8), first);
    assert_false(__asan_address_is_poisoned(first + 7));
    assert_true(__asan_address_is_poisoned(first + 8));
#endif
}

static void every_kind_is_freed(void **state)
{
    (void)state;
    for (int round = 0; round < 3; round++) {
        field_open(3);
        num_f t = variable_f("t");
        poly p = poly_variable();
        num_i x = from_ratio_i(1, 3);
        for (int k = 0; k < 8; k++) {
            t = add_f(mul_f(t, t), variable_f("w"));
            p = poly_add(poly_mul(p, p), poly_constant(big(k)));
            x = mul_i(x, x);
            region_bytes(100000);
        }
        if (round == 1)
            region_drop((region_mark){.precision = 128});
        region_free_all();
        assert_true(cagd_equal_q(from_int_q(7), from_int_q(7))); /* a new life */
    }
}

static void *other_thread(void *state)
{
    *(int *)state = region_faults == 0;
    num_q a = big(5);
    div_q(a, from_int_q(0));
    field_open(1);
    num_f t = variable_f("t");
    *(int *)state &= region_faults == FAULT_UNDEFINED && !cagd_is_zero_f(t);
    cagd_thread_end();
    return NULL;
}

static void threads_have_their_own_region(void **state)
{
    (void)state;
    pthread_t thread;
    int good = 0;
    num_q a = big(3);
    root_q(2, from_int_q(2));
    assert_int_equal(pthread_create(&thread, NULL, other_thread, &good), 0);
    assert_int_equal(pthread_join(thread, NULL), 0);
    assert_true(good && cagd_equal_q(a, big(3)));
    expect_fault(FAULT_UNABLE);
}

/* ---- precision ---------------------------------------------------------------------------------------- */

/* x such that x^2 + x = 1, enclosed: (sqrt 5 - 1)/2. */
static num_i golden(void) { return div_i(sub_i(root_i(2, from_int_i(5)), from_int_i(1)), from_int_i(2)); }

static num_q end_of(mpfr_srcptr end)
{
    mpq_t x;
    mpq_init(x);
    mpfr_get_q(x, end);
    num_q r = cagd_from_mpq_q(x);
    mpq_clear(x);
    return r;
}
/* The sign of x^2 + x - 1, exactly. */
static int side_of(mpfr_srcptr end)
{
    num_q x = end_of(end);
    return cagd_compare_q(add_q(mul_q(x, x), x), from_int_q(1));
}

/* The interval has the number in it, and is as narrow as its bits allow and no narrower: with ends of `bits` bits in (1/2, 1) it
 * has at least one unit of 2^-bits, and at most the roundings of three operations. */
static int encloses_golden(num_i x, long bits)
{
    double unit = ldexp(1, (int)-bits);
    return mpfr_get_prec(x.at->lo) == bits && mpfr_get_prec(x.at->hi) == bits && side_of(x.at->lo) < 0 &&
           side_of(x.at->hi) > 0 && width_i(x) >= unit && width_i(x) <= 8 * unit;
}

static const long precisions[] = {64, 128, 512};

static void intervals_have_the_precision_of_their_region(void **state)
{
    (void)state;
    assert_int_equal(cagd_region_precision(), 128);
    for (int round = 0; round < 3; round++) /* slots are used again with other precisions */
        for (int k = 0; k < 3; k++) {
            region_mark m = region_open();
            cagd_region_set_precision(precisions[k]);
            for (int j = 0; j < 5; j++)
                assert_true(encloses_golden(golden(), precisions[k]));
            region_drop(m);
            assert_int_equal(cagd_region_precision(), 128);
        }
    assert_true(encloses_golden(golden(), 128));
}

/* Operands keep the precision that they were made with; results have the present one. */
static void precisions_mix(void **state)
{
    (void)state;
    cagd_region_set_precision(512);
    num_i fine = golden();
    region_mark m = region_open();
    cagd_region_set_precision(64);
    num_i coarse = golden(), product = mul_i(neg_i(fine), coarse), hull = cagd_hull_i(fine, coarse);
    assert_true(encloses_golden(coarse, 64) && encloses_golden(fine, 512));
    assert_int_equal(mpfr_get_prec(product.at->lo), 64);
    assert_true(mpfr_lessequal_p(hull.at->lo, coarse.at->lo) && mpfr_greaterequal_p(hull.at->hi, coarse.at->hi));
    num_i one = sub_i(fine, product); /* x + x^2 */
    assert_true(cagd_contains_i(one, from_int_q(1)) && width_i(one) < 0x1p-58);
    /* the only product with temporaries: both factors have points of both signs */
    num_i across = mul_i(cagd_between_i(-1.3, 2.7), cagd_between_i(-3.1, 1.9));
    assert_true(mpfr_equal_p(across.at->lo, mul_i(cagd_from_double_i(2.7), cagd_from_double_i(-3.1)).at->lo));
    assert_true(mpfr_equal_p(across.at->hi, mul_i(cagd_from_double_i(2.7), cagd_from_double_i(1.9)).at->hi));
    region_drop(m);
    assert_int_equal(cagd_region_precision(), 512);
    assert_true(encloses_golden(golden(), 512));
}

static void precisions_that_are_none(void **state)
{
    (void)state;
    const long bad[] = {-1, 0, 1, (1 << 24) + 1};
    for (int k = 0; k < 4; k++) {
        region_faults = FAULT_MEMORY; /* another fault stays */
        cagd_region_set_precision(bad[k]);
        expect_fault(FAULT_UNABLE | FAULT_MEMORY);
        assert_int_equal(cagd_region_precision(), 128);
    }
    cagd_region_set_precision(1 << 24);
    assert_int_equal(cagd_region_precision(), 1 << 24);
    cagd_region_set_precision(2);
    assert_int_equal(cagd_region_precision(), 2);
    assert_true(cagd_contains_i(from_ratio_i(1, 3), from_ratio_q(1, 3)));
}

/* Eight threads at once, each with a precision of its own that changes as it goes. */
static void *interval_work(void *state)
{
    int *k = state, good = 1;
    for (int round = 0; round < 2000; round++) {
        region_mark m = region_open();
        long bits = precisions[(*k + round) % 3];
        cagd_region_set_precision(bits);
        good &= encloses_golden(golden(), bits);
        region_drop(m);
        good &= cagd_region_precision() == 128;
    }
    *k = good && region_faults == 0;
    cagd_thread_end();
    return NULL;
}
static void threads_have_their_own_precision(void **state)
{
    (void)state;
    enum { THREADS = 8 };
    pthread_t thread[THREADS];
    int number[THREADS];
    for (int k = 0; k < THREADS; k++) {
        number[k] = k;
        assert_int_equal(pthread_create(&thread[k], NULL, interval_work, &number[k]), 0);
    }
    assert_true(encloses_golden(golden(), 128));
    for (int k = 0; k < THREADS; k++) {
        assert_int_equal(pthread_join(thread[k], NULL), 0);
        assert_true(number[k]);
    }
}

/* Blocks that do not fit in a page are given back at once, and not when the thread ends. */
static void large_blocks_are_given_back(void **state)
{
    (void)state;
#ifdef __GLIBC__
    const struct mallinfo2 before = mallinfo2();
    for (int k = 0; k < 100; k++) {
        region_mark m = region_open();
        assert_non_null(cagd_region_bytes(1 << 20));
        region_drop(m);
    }
    const struct mallinfo2 after = mallinfo2();
    assert_true(after.uordblks + after.hblkhd < before.uordblks + before.hblkhd + (10 << 20));
#endif
}

/* Arrays whose number of elements is no int, or whose bytes no size_t counts, are refused, beside a fault that stands; of none there is room. */
static void arrays_that_are_none(void **state)
{
    (void)state;
    static const struct {
        long rows, columns;
        size_t size;
    } bad[] = {{-1, 1, 1},
               {1, -1, 1},
               {-1, -1, 1},
               {-1, 0, 1},
               {0, -1, 1},
               {46341, 46341, 1},
               {1L << 31, 1, 1},
               {1, 1L << 31, 1},
               {1L << 31, 0, 1},
               {0, 1L << 31, 1},
               {1L << 16, 1L << 15, 1},
               {3, 1, SIZE_MAX / 2},
               {1, 2, SIZE_MAX / 2 + 1},
               {1, 1, SIZE_MAX},
               {INT32_MAX, 3, SIZE_MAX / 2}};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        region_faults = FAULT_CROWDED;
        assert_null(cagd_region_array(bad[k].rows, bad[k].columns, bad[k].size));
        expect_fault(FAULT_CROWDED | FAULT_MEMORY);
    }
    for (size_t less = 0; less < 16; less++) {
        region_faults = FAULT_CROWDED;
        assert_null(cagd_region_bytes(SIZE_MAX - less));
        expect_fault(FAULT_CROWDED | FAULT_MEMORY);
    }
    for (long rows = 0; rows <= 3; rows++)
        for (long columns = 0; columns <= 3; columns++) {
            unsigned char *a = cagd_region_array(rows, columns, 5), *b = cagd_region_array(rows, columns, 5);
            assert_non_null(a);
            assert_true(b >= a + rows * columns * 5);
        }
    assert_non_null(cagd_region_array(46340, 1, 1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        unit(older_values_survive_a_drop),
        unit(a_drop_gives_the_slots_back),
        unit(marks_nest),
        unit(blocks_are_apart),
        unit(page_boundaries),
        unit(bytes_of_no_block_are_forbidden),
        unit(every_kind_is_freed),
        unit(threads_have_their_own_region),
        unit(intervals_have_the_precision_of_their_region),
        unit(precisions_mix),
        unit(precisions_that_are_none),
        unit(threads_have_their_own_precision),
        unit(large_blocks_are_given_back),
        unit(arrays_that_are_none),
    };
    return run_unit_tests(tests);
}
