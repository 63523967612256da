/* test_exact_memory.c -- decisions without room for their arrays: the k-th request of memory fails, alone and with all later ones,
 * for k = 1, 2, ... until no more is asked for.  Then MEMORY is set, nothing crashes, and the next decision is as good as before.
 *
 * The linker puts the functions below in the place of malloc and realloc wherever the library calls them.  Refused are arrays,
 * which come in pages of 2^16 bytes or larger; the places of numbers are smaller, and without them the process ends. */
#include "unit_exact.h"

#include "exact/curve/spline.h"
#include "exact/decide/crossings.h"
#include "exact/decide/hull.h"
#include "exact/decide/resultant.h"
#include "exact/decide/sign.h"
#include "exact/decide/sturm.h"
#include "exact/decide/total_positivity.h"
#include "exact/record/number.h"
#include "exact/record/trace.h"
#include "exact/words.h"

#include <limits.h>
#include <stdlib.h>

void *__wrap_malloc(size_t size);
void *__wrap_realloc(void *block, size_t size);
void *__real_malloc(size_t size);
void *__real_realloc(void *block, size_t size);

enum { PAGE = 1 << 16 };
static size_t smallest = PAGE;                   /* of the requests that count                                   */
static long asked, fail_at, fail_until, refused; /* fail_at 0: none                                              */

static int refuse(size_t size)
{
    if (size < smallest)
        return 0;
    asked++;
    int no = fail_at != 0 && fail_at <= asked && asked <= fail_until;
    refused += no;
    return no;
}
void *__wrap_malloc(size_t size) { return refuse(size) ? NULL : __real_malloc(size); }
void *__wrap_realloc(void *block, size_t size) { return refuse(size) ? NULL : __real_realloc(block, size); }

/* ---- what is decided; each answer is one number ------------------------------------------------------------- */

/* prod (t - k/(n+1)), k = 1, ..., n, times the square of the first three factors. */
static poly many_roots(int n)
{
    poly p = poly_constant(from_int_q(1));
    for (int k = 1; k <= n; k++) {
        num_q c[] = {from_ratio_q(-k, n + 1), from_int_q(1)};
        poly line = poly_from_q(2, c);
        p = poly_mul(p, k <= 3 ? poly_mul(line, poly_mul(line, line)) : line);
    }
    return p;
}
static int roots(void)
{
    struct cagd_root out[30];
    num_q zero = from_int_q(0), one = from_int_q(1);
    return cagd_count_roots(many_roots(24), zero, one, OPEN).counted +
           100 * cagd_isolate_roots(many_roots(24), zero, one, out, 30);
}
static int sturm(void) { return cagd_sturm_count_line(many_roots(24)); }
static int sign(void) { return (int)cagd_sign_on(many_roots(20), from_int_q(1), from_int_q(2), CLOSED); }
static int hull(void)
{
    enum { COUNT = 60 };
    num_q points[2 * COUNT], x[2] = {from_ratio_q(1, 2), from_ratio_q(1, 3)};
    int vertex[COUNT + 1];
    for (int j = 0; j < COUNT; j++) {
        points[2 * j] = from_ratio_q(j, COUNT);
        points[2 * j + 1] = mul_q(points[2 * j], points[2 * j]);
    }
    return cagd_hull_membership(2, COUNT, points, x).inside + 10 * cagd_convex_hull_2d(COUNT, points, vertex) +
           1000 * cagd_polygon_is_convex(COUNT - 1, points, 1, NULL);
}
static int crossings(void)
{
    enum { N = 30 };
    num_q R[2 * (N + 1)], w[N + 1];
    for (int i = 0; i <= N; i++) {
        R[2 * i] = from_int_q(i);
        R[2 * i + 1] = from_int_q(i % 2 == 0 ? 1 : -1);
        w[i] = from_int_q(i + 1);
    }
    struct cagd_line axis = {from_int_q(0), from_int_q(1), from_int_q(0)};
    return cagd_polygon_crossings(N, R, axis) + 100 * cagd_curve_meets_line(N, R, w, axis).crossings;
}
static int minors(void)
{
    enum { N = 66 };
    num_q A[N * N], power;
    for (int i = 0; i < N; i++) {
        power = from_int_q(1);
        for (int j = 0; j < N; j++) {
            A[i * N + j] = power;
            power = mul_q(power, from_int_q(i + 1));
        }
    }
    return cagd_is_totally_nonnegative(N, N, A) + 10 * cagd_is_totally_positive(8, 8, A) +
           100 * cagd_sign_q(cagd_pivoted_determinant_q(N, A)) + 1000 * cagd_all_minors_nonnegative(4, 4, A, 0, NULL);
}
static int resultants(void)
{
    num_q r = cagd_poly_resultant_sylvester(many_roots(20), poly_derivative(many_roots(20)));
    num_q s = cagd_poly_resultant_bezout(many_roots(20), poly_constant(from_int_q(2)));
    return cagd_is_zero_q(r) + 10 * cagd_sign_q(s);
}
static int texts(void) { return (int)(poly_to_string(many_roots(60), "t")[0] + to_string_q(from_ratio_q(1, 3))[0]); }

/* NO_MEMORY, and only then, when an array was refused since; nothing is written then, and no place is named. */
static int answered(cagd_status status, const cagd_spline_q *result, long before, int where)
{
    assert_true(status == CAGD_OK || where == -1);
    assert_int_equal(status, refused > before ? CAGD_NO_MEMORY : CAGD_OK);
    assert_int_equal(result->count == -1, status != CAGD_OK);
    return status == CAGD_OK;
}

/* Insertion, removal and the parts of an exact curve whose knots, points and weights are each longer than a page. */
static int curves(void)
{
    enum { N = 1 << 13 };
    const cagd_spline_q none = {.count = -1};
    long fail = fail_at, before;
    int good = 0, where;
    fail_at = 0;
    num_q *u = region_bytes((N + 2) * sizeof *u), *R = region_bytes(N * sizeof *R), *w = region_bytes(N * sizeof *w);
    for (int i = 0; i < N + 2; i++)
        u[i] = from_int_q(i);
    for (int i = 0; i < N; i++)
        R[i] = w[i] = from_int_q(i % 7 + 1);
    const cagd_spline_q s = {1, N, 1, u, R, w};
    cagd_spline_q finer, left = none, right = none, back = none;
    assert_int_equal(cagd_spline_insert_q(&s, from_ratio_q(5, 2), &finer, &where), CAGD_OK);
    fail_at = fail;
    asked = refused = before = 0;
    good += answered(cagd_spline_remove_q(&finer, from_ratio_q(5, 2), &back, &where), &back, before, where);
    back = none, before = refused;
    good += answered(cagd_spline_insert_q(&s, from_ratio_q(7, 2), &back, &where), &back, before, where);
    before = refused;
    good += answered(cagd_spline_split_q(&s, from_int_q(N / 2), &left, &right, &where), &left, before, where);
    assert_int_equal(left.count, right.count == -1 ? -1 : left.count);
    return good;
}

/* roots, ... are asked once for each place in a page; the curves, whose arrays are all longer, once. */
static int (*const decisions[])(void) = {roots, sturm, sign, hull, crossings, minors, resultants, texts};

/* In a new region, of whose first page so many bytes are taken: so that each array in its turn is the first of a page. */
static int begun_anew(int (*decision)(void), size_t taken)
{
    long fail = fail_at;
    fail_at = 0;
    region_free_all();
    if (taken > 0)
        region_bytes(taken);
    fail_at = fail;
    asked = refused = 0;
    return decision();
}

/* How many trials it took. */
static int every_request_fails(int (*decision)(void), size_t taken)
{
    int trials = 0;
    fail_at = 0;
    int right = begun_anew(decision, taken);
    assert_int_equal(region_faults, 0);
    for (int with_later = 0; with_later < 2; with_later++)
        for (fail_at = 1;; fail_at++, trials++) {
            fail_until = with_later ? LONG_MAX : fail_at;
            int answer = begun_anew(decision, taken);
            if (refused == 0) {
                assert_int_equal(region_faults, 0);
                assert_int_equal(answer, right);
                break;
            }
            assert_true(region_faults & FAULT_MEMORY);
            region_faults = 0;
        }
    fail_at = 0;
    return trials;
}

static void every_request_may_fail(void **state)
{
    (void)state;
    for (size_t d = 0; d < sizeof decisions / sizeof *decisions; d++) {
        int trials = 0;
        for (size_t taken = 0; taken <= PAGE; taken += taken < PAGE - 8192 ? 8192 : 512)
            trials += every_request_fails(decisions[d], taken);
        assert_true(trials > 0);
    }
    assert_true(every_request_fails(curves, 0) > 8);
}

/* A trace that finds no memory gives up, and what is computed goes on. */
static void traces_give_up(void **state)
{
    (void)state;
    region_free_all();
    from_int_q(1); /* numbers have their places from now on */
    many_roots(24);
    smallest = 1;
    for (fail_at = 1;; fail_at++) {
        fail_until = LONG_MAX;
        asked = refused = 0;
        region_mark mark = region_open();
        cagd_trace_open(1000000);
        num_q sum = from_int_q(0);
        for (int k = 0; k < 100; k++)
            sum = add_q(sum, from_int_q(k));
        int positive = cagd_testify_sign_q(sum);
        const char *nodes = cagd_trace_nodes(), *steps = cagd_trace_steps();
        assert_true(cagd_equal_q(sum, from_int_q(4950)) && positive == 1);
        assert_true(refused > 0 ? (region_faults & FAULT_MEMORY) && nodes == NULL && steps == NULL
                                : region_faults == 0 && nodes != NULL && steps != NULL);
        cagd_trace_close();
        region_drop(mark);
        region_faults = 0;
        if (refused == 0)
            break;
    }
    assert_true(fail_at > 5);
    fail_at = 0;
    smallest = PAGE;
}

static void sizes_that_are_none(void **state)
{
    (void)state;
    fail_at = 0;
    const struct {
        long rows, columns;
    } none[] = {{-1, 1}, {1, -1}, {-1, 0}, {0, -1}, {(long)INT_MAX + 1, 1}, {INT_MAX, 2}, {1L << 16, 1L << 15}, {LONG_MIN, LONG_MIN}};
    for (size_t k = 0; k < sizeof none / sizeof *none; k++) {
        assert_null(cagd_region_array(none[k].rows, none[k].columns, 8));
        expect_fault(FAULT_MEMORY);
    }
    assert_null(region_bytes(SIZE_MAX));
    expect_fault(FAULT_MEMORY);
    assert_non_null(cagd_region_array(0, 5, 8));
    num_q *c = calloc(60001, sizeof *c);
    for (int k = 0; k <= 60000; k++)
        c[k] = from_int_q(k == 60000);
    poly large = poly_from_q(60001, c);
    free(c);
    poly_compose(large, large); /* of degree 3 600 000 000 */
    expect_fault(FAULT_MEMORY);
    num_q zero = from_int_q(0);
    cagd_pivoted_determinant_q(-1, &zero);
    expect_fault(FAULT_MEMORY);
    cagd_is_totally_positive(1 << 20, 1 << 20, &zero);
    expect_fault(FAULT_MEMORY);
    cagd_field_open(-3);
    assert_false(cagd_is_zero_f(variable_f("t")));
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(every_request_may_fail), unit(traces_give_up), unit(sizes_that_are_none)};
    return run_unit_tests(tests);
}
