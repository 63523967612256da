/* test_stationary_parts.c -- what the check in intervals is made of, by numbers that hands compute: where the check itself would show a
 * fault in its last digits alone. */
#include "unit_exact.h"

#include "exact/fit/stationary.c" /* for what is its own */

/* With W = (2) and V = (1/4), V W = 1/2: |y| <= |V| u + |y|/2, so |y| <= u/2 for the unit u. */
static void the_extent_of_a_box(void **state)
{
    (void)state;
    const double W[] = {2}, V[] = {0.25}, unit[] = {3}, no_inverse[] = {0};
    assert_true(extent(1, 1, W, V, unit) == 1.5);
    assert_true(isinf(extent(1, 1, W, no_inverse, unit)));
    const double W2[] = {2, 0, 1, 1}, V2[] = {0.5, 0, -0.5, 1}, units[] = {1, 1}; /* an inverse */
    double r = extent(2, 2, W2, V2, units);
    assert_true(r >= 1.5 && r < 1.5 + 0x1p-40);
}

static void what_a_radius_reaches(void **state)
{
    (void)state;
    const double W[] = {1, -2, 4, 0.5};
    double reach[2];
    reaches(2, 2, W, reach);
    assert_true(reach[0] > 3 && reach[0] < 3 + 0x1p-40);
    assert_true(reach[1] > 4.5 && reach[1] < 4.5 + 0x1p-40);
}

/* The least and the largest coordinate in any place, of each number of dimensions. */
static void the_size_of_points(void **state)
{
    (void)state;
    for (int dim = 1; dim <= 3; dim++)
        for (int least = 0; least < 5; least++)
            for (int most = 0; most < 5; most++)
                for (int c = 0; c < dim; c++) {
                    double points[15] = {0};
                    cagd_fit_data data = {5, dim, points, NULL};
                    points[least * dim + c] -= 3, points[most * dim + c] += 4;
                    assert_true(size_of_data(&data) == (least != most ? 7 : 1)); /* 0 for the same, with 1 more */
                }
}

static void ways_are_added_upward(void **state)
{
    (void)state;
    const cagd_fit_unknown unknown[] = {{1, 1, 0}, {0, 1, 0}};
    const cagd_stationary_problem problem = {.unknowns = 2, .unknown = unknown};
    const double moved[] = {0x1p-60, 0x1p-70};
    cagd_stationary_verdict v = {.weight_radius = 1, .point_radius = 1, .weight_alone = 2, .point_alone = 2};
    add_way(&problem, moved, 1, &v);
    assert_true(v.weight_radius > 1 && v.weight_radius < 1 + 0x1p-50);
    assert_true(v.point_radius > 1 && v.point_radius < 1 + 0x1p-50);
    assert_true(v.weight_alone < 2 && v.point_alone < 2 && v.weight_alone > 1.99 && v.point_alone > 1.99);
}

static void the_nearer_bound(void **state)
{
    (void)state;
    const cagd_fit_options options = {.weight_low = 0.5, .weight_high = 8, .tolerance = 0.01};
    assert_int_equal(bound_of(&options, log(0.5)), CAGD_STATIONARY_AT_LOW);
    assert_int_equal(bound_of(&options, log(1.9)), CAGD_STATIONARY_AT_LOW);
    assert_int_equal(bound_of(&options, log(2.1)), CAGD_STATIONARY_AT_HIGH);
    assert_int_equal(bound_of(&options, log(8)), CAGD_STATIONARY_AT_HIGH);
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(the_extent_of_a_box), unit(what_a_radius_reaches), unit(the_size_of_points),
                                       unit(ways_are_added_upward), unit(the_nearer_bound)};
    return run_unit_tests(tests);
}
