/* test_linear.c -- linear inequalities against the points of a grid, and what spoils an answer. */
#include "unit_exact.h"

#include "exact/decide/linear.h"
#include "exact/words.h"

enum { N = 2, MOST = 8 };

static struct cagd_linear_condition condition[MOST];

/* Conditions with small coefficients on two variables. */
static void make_conditions(int count)
{
    for (int k = 0; k < count; k++) {
        num_q *a = cagd_region_array(1, N + 1, sizeof *a);
        for (int i = 0; i <= N; i++)
            a[i] = from_int_q(random_int(-3, 3));
        int kind = random_int(0, 9);
        condition[k] = (struct cagd_linear_condition){a, kind < 5   ? CAGD_LINEAR_POSITIVE
                                                         : kind < 9 ? CAGD_LINEAR_NONNEGATIVE
                                                                    : CAGD_LINEAR_ZERO};
    }
}

static int holds_at(int count, num_q x, num_q y)
{
    const num_q at[N] = {x, y};
    return cagd_linear_answer_holds(N, count, condition, (struct cagd_linear_answer){1, at, NULL});
}

/* A system without a solution has none on the grid, and its multipliers prove it; one with a solution has that one. */
static void answers_agree_with_a_grid(void **state)
{
    (void)state;
    int solvable = 0, unsolvable = 0, met = 0;
    for (int k = 0; k < 400; k++) {
        region_mark m = region_open();
        int count = random_int(0, MOST), on_grid = 0;
        make_conditions(count);
        struct cagd_linear_answer answer = cagd_linear_solve(N, count, condition);
        assert_int_equal(region_faults, 0);
        assert_true(cagd_linear_answer_holds(N, count, condition, answer));
        for (int i = -8; i <= 8; i++)
            for (int j = -8; j <= 8; j++)
                on_grid |= holds_at(count, from_ratio_q(i, 2), from_ratio_q(j, 2));
        assert_true(answer.solvable || !on_grid);
        *(answer.solvable ? &solvable : &unsolvable) += 1;
        met += on_grid;
        region_drop(m);
    }
    assert_true(solvable > 50 && unsolvable > 50 && met > 50);
}

/* With the last variable of a tie in the place of the first, the search goes round in a circle here: found among 64505 random systems, as
 * one of four. */
static void ties_do_not_go_round(void **state)
{
    (void)state;
    static const int a[][N + 1] = {{2, 5, 3}, {1, 0, -2}, {5, 3, 2}, {-5, 4, 2}, {0, 2, 1}, {2, 4, 2}, {2, 4, 5}};
    enum { COUNT = sizeof a / sizeof *a };
    region_mark m = region_open();
    for (int k = 0; k < COUNT; k++) {
        num_q *numbers = cagd_region_array(1, N + 1, sizeof *numbers);
        for (int i = 0; i <= N; i++)
            numbers[i] = from_int_q(a[k][i]);
        condition[k] =
            (struct cagd_linear_condition){numbers, k == 1 || k == 2 ? CAGD_LINEAR_POSITIVE : CAGD_LINEAR_NONNEGATIVE};
    }
    assert_true(cagd_linear_solve(N, COUNT, condition).solvable);
    region_drop(m);
}

/* x > 0, y >= 0 and x + y <= 0, and the same with x >= 0. */
static void strictness_decides(void **state)
{
    (void)state;
    region_mark m = region_open();
    const num_q x[3] = {from_int_q(0), from_int_q(1), from_int_q(0)},
                y[3] = {from_int_q(0), from_int_q(0), from_int_q(1)},
                minus[3] = {from_int_q(0), from_int_q(-1), from_int_q(-1)};
    condition[0] = (struct cagd_linear_condition){x, CAGD_LINEAR_POSITIVE};
    condition[1] = (struct cagd_linear_condition){y, CAGD_LINEAR_NONNEGATIVE};
    condition[2] = (struct cagd_linear_condition){minus, CAGD_LINEAR_NONNEGATIVE};
    assert_false(cagd_linear_solve(N, 3, condition).solvable);
    condition[0].relation = CAGD_LINEAR_NONNEGATIVE;
    assert_true(cagd_linear_solve(N, 3, condition).solvable);
    region_drop(m);
}

/* A multiplier of the wrong sign, a sum that is not constant, and one that is no contradiction prove nothing; a point that a
 * condition excludes is no solution. */
static void a_wrong_answer_is_seen(void **state)
{
    (void)state;
    region_mark m = region_open();
    const num_q above[3] = {from_int_q(-1), from_int_q(1), from_int_q(0)},
                below[3] = {from_int_q(0), from_int_q(-1), from_int_q(0)};
    condition[0] = (struct cagd_linear_condition){above, CAGD_LINEAR_NONNEGATIVE}; /* x >= 1 */
    condition[1] = (struct cagd_linear_condition){below, CAGD_LINEAR_NONNEGATIVE}; /* x <= 0 */
    struct cagd_linear_answer answer = cagd_linear_solve(N, 2, condition);
    assert_false(answer.solvable);
    const num_q unequal[2] = {from_int_q(1), from_int_q(2)}, negative[2] = {from_int_q(-1), from_int_q(-1)},
                nothing[2] = {from_int_q(0), from_int_q(0)}, point[2] = {from_ratio_q(1, 2), from_int_q(0)};
    answer.multiplier = unequal;
    assert_false(cagd_linear_answer_holds(N, 2, condition, answer));
    answer.multiplier = negative;
    assert_false(cagd_linear_answer_holds(N, 2, condition, answer));
    answer.multiplier = nothing;
    assert_false(cagd_linear_answer_holds(N, 2, condition, answer));
    /* x - 1 >= 0 and -1 times what is said of x make -1 >= 0: a contradiction where x = 0 is said, and none with x > 0 or x >= 0 */
    const num_q right[3] = {from_int_q(0), from_int_q(1), from_int_q(0)},
                far[3] = {from_int_q(-1), from_int_q(1), from_int_q(0)}, mixed[2] = {from_int_q(-1), from_int_q(1)};
    answer.multiplier = mixed;
    for (int relation = 0; relation < 3; relation++) {
        static const enum cagd_linear_relation relations[] = {CAGD_LINEAR_POSITIVE, CAGD_LINEAR_NONNEGATIVE,
                                                              CAGD_LINEAR_ZERO};
        condition[0] = (struct cagd_linear_condition){right, relations[relation]};   /* x > 0, x >= 0, x = 0 */
        condition[1] = (struct cagd_linear_condition){far, CAGD_LINEAR_NONNEGATIVE}; /* x >= 1 */
        assert_int_equal(cagd_linear_answer_holds(N, 2, condition, answer), relation == 2);
    }
    condition[0] = (struct cagd_linear_condition){above, CAGD_LINEAR_NONNEGATIVE};
    condition[1] = (struct cagd_linear_condition){below, CAGD_LINEAR_NONNEGATIVE};
    answer = (struct cagd_linear_answer){1, point, NULL};
    assert_false(cagd_linear_answer_holds(N, 2, condition, answer));
    region_drop(m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        unit(answers_agree_with_a_grid),
        unit(ties_do_not_go_round),
        unit(strictness_decides),
        unit(a_wrong_answer_is_seen),
    };
    return run_unit_tests(tests);
}
