/* test_simplex.c -- systems of linear inequalities against a search of their own, and evidence that is spoiled. */
#include "unit_exact.h"

#include "exact/decide/simplex.h"
#include "exact/words.h"

#include <string.h>

enum { MOST = 7 };

/* Fourier and Motzkin: a variable is eliminated by adding every two rows in which it has both signs.  What remains has no variable. */
struct rows {
    int count, strict[2000];
    num_q at[2000][MOST + 1];
};

static void eliminate(const struct rows *from, int v, int d, struct rows *to)
{
    to->count = 0;
    for (int i = 0; i < from->count; i++) {
        int sign = cagd_sign_q(from->at[i][v]);
        for (int j = 0; sign > 0 && j < from->count; j++) {
            if (cagd_sign_q(from->at[j][v]) >= 0)
                continue;
            assert_true(to->count < 2000);
            for (int k = 0; k < d; k++)
                to->at[to->count][k] =
                    sub_q(mul_q(from->at[j][k], from->at[i][v]), mul_q(from->at[i][k], from->at[j][v]));
            to->strict[to->count++] = from->strict[i] || from->strict[j];
        }
        if (sign != 0)
            continue;
        memcpy(to->at[to->count], from->at[i], sizeof from->at[i]);
        to->strict[to->count++] = from->strict[i];
    }
}

/* All rows are numbers 0 in the end: 0 > 0 is false. */
static int solvable(int d, int count, const num_q forms[], const int strict[])
{
    static struct rows rows[2];
    rows[0].count = count;
    for (int j = 0; j < count; j++) {
        for (int i = 0; i < d; i++)
            rows[0].at[j][i] = forms[d * j + i];
        rows[0].strict[j] = strict[j];
    }
    for (int v = 0; v < d; v++)
        eliminate(&rows[v % 2], v, d, &rows[(v + 1) % 2]);
    for (int j = 0; j < rows[d % 2].count; j++)
        if (rows[d % 2].strict[j])
            return 0;
    return 1;
}

static void inequalities_are_those_of_an_elimination(void **state)
{
    (void)state;
    int both[2] = {0};
    for (int k = 0; k < 1500; k++) {
        region_mark m = region_open();
        int d = random_int(1, 4), count = random_int(1, MOST), strict[MOST];
        num_q forms[4 * MOST];
        for (int i = 0; i < d * count; i++)
            forms[i] = coarse_q(2, 2);
        for (int j = 0; j < count; j++)
            strict[j] = j == 0 || random_int(0, 2) == 0;
        struct cagd_inequalities s = cagd_inequalities(d, count, forms, strict);
        assert_int_equal(s.solvable, solvable(d, count, forms, strict));
        assert_true(cagd_inequalities_hold(d, count, forms, strict, s));
        both[s.solvable]++;
        region_drop(m);
    }
    assert_true(both[0] > 200 && both[1] > 200);
}

/* x >= 0, -x >= 0 leaves x = 0, which nothing strict forbids but x > 0 and -x > 0. */
static void closed_conditions_may_leave_a_face(void **state)
{
    (void)state;
    num_q one = from_int_q(1), zero = from_int_q(0), minus = from_int_q(-1);
    num_q forms[8] = {one, zero, zero, one, zero, minus, zero, one};
    int closed[3] = {1, 0, 0}, with[4] = {1, 0, 0, 1};
    assert_true(cagd_inequalities(2, 3, forms, closed).solvable);
    assert_false(cagd_inequalities(2, 4, forms, with).solvable);
    forms[7] = minus;
    assert_false(cagd_inequalities(2, 4, forms, with).solvable);
}

static void spoiled_evidence_is_refused(void **state)
{
    (void)state;
    num_q q[4] = {from_int_q(0), from_int_q(1), from_int_q(-1), from_int_q(2)};
    num_q forms[4] = {q[1], q[0], q[2], q[1]}; /* x > 0, y - x >= 0 */
    int strict[2] = {1, 0};
    num_q good[2] = {q[1], q[1]}, on_the_border[2] = {q[0], q[1]}, below[2] = {q[3], q[1]};
    struct cagd_inequalities s = {.solvable = 1, .point = good};
    assert_true(cagd_inequalities_hold(2, 2, forms, strict, s));
    s.point = on_the_border;
    assert_false(cagd_inequalities_hold(2, 2, forms, strict, s));
    s.point = below;
    assert_false(cagd_inequalities_hold(2, 2, forms, strict, s));
    num_q opposite[4] = {q[1], q[1], q[2], q[2]}; /* x + y > 0, -x - y >= 0 */
    num_q lambda[2] = {q[1], q[1]}, negative[2] = {q[2], q[2]}, none[2] = {q[0], q[0]}, unequal[2] = {q[1], q[3]};
    s = (struct cagd_inequalities){.lambda = lambda};
    assert_true(cagd_inequalities_hold(2, 2, opposite, strict, s));
    s.lambda = negative;
    assert_false(cagd_inequalities_hold(2, 2, opposite, strict, s));
    s.lambda = none;
    assert_false(cagd_inequalities_hold(2, 2, opposite, strict, s));
    s.lambda = unequal;
    assert_false(cagd_inequalities_hold(2, 2, opposite, strict, s));
    int second[2] = {0, 1}; /* the sum is over the strict ones */
    num_q thrice[2] = {q[3], q[3]};
    s.lambda = thrice;
    assert_false(cagd_inequalities_hold(2, 2, opposite, second, s));
}

/* Systems of equations in numbers >= 0: a solution solves, and otherwise y separates. */
static void a_system_has_a_solution_or_what_forbids_it(void **state)
{
    (void)state;
    int both[2] = {0};
    for (int k = 0; k < 600; k++) {
        region_mark m = region_open();
        int rows = random_int(1, 4), columns = random_int(1, 6);
        num_q A[24], b[4];
        for (int i = 0; i < rows * columns; i++)
            A[i] = coarse_q(3, 2);
        for (int i = 0; i < rows; i++)
            b[i] = coarse_q(3, 2);
        struct cagd_simplex s = cagd_simplex(rows, columns, A, b);
        assert_true((s.x != NULL) == s.solvable && (s.y != NULL) == !s.solvable);
        for (int i = 0; i < rows && s.solvable; i++) {
            num_q sum = from_int_q(0);
            for (int j = 0; j < columns; j++)
                sum = add_q(sum, mul_q(A[i * columns + j], s.x[j]));
            assert_true(cagd_equal_q(sum, b[i]));
        }
        for (int j = 0; j < columns && s.solvable; j++)
            assert_true(cagd_sign_q(s.x[j]) >= 0);
        for (int j = -1; j < columns && !s.solvable; j++) {
            num_q sum = from_int_q(0);
            for (int i = 0; i < rows; i++)
                sum = add_q(sum, mul_q(s.y[i], j < 0 ? b[i] : A[i * columns + j]));
            assert_true(j < 0 ? cagd_sign_q(sum) > 0 : cagd_sign_q(sum) <= 0);
        }
        both[s.solvable]++;
        region_drop(m);
    }
    assert_true(both[0] > 100 && both[1] > 100);
}

/* Evidence is refused when one form of three, one coordinate of three, or one number is wrong, whichever it is. */
static void one_form_spoils_evidence(void **state)
{
    (void)state;
    enum { D = 3, COUNT = 4 };
    num_q forms[D * COUNT], point[D] = {from_int_q(2), from_int_q(3), from_int_q(5)};
    for (int j = 0; j < 3; j++)
        for (int is_strict = 0; is_strict < 2; is_strict++)
            for (int value = -1; value <= 1; value++) {
                int strict[3] = {1, 1, 1};
                strict[j] = is_strict;
                for (int m = 0; m < 3 * D; m++) /* x, y and z, or one that has the value */
                    forms[m] = from_int_q(m / D == m % D);
                forms[D * j + (j + 1) % D] = div_q(sub_q(from_int_q(value), point[j]), point[(j + 1) % D]);
                assert_int_equal(
                    cagd_inequalities_hold(D, 3, forms, strict, (struct cagd_inequalities){1, point, NULL}),
                    is_strict ? value > 0 : value >= 0);
            }
    /* x, y, z and -x - y - z, each 1/2 or, for the strict ones, 1 in sum. */
    for (int spoiled = -1; spoiled < COUNT; spoiled++)
        for (int first = 0; first < COUNT; first++) {
            int strict[COUNT] = {0};
            num_q lambda[COUNT];
            strict[first] = 1;
            for (int m = 0; m < D * COUNT; m++)
                forms[m] = from_int_q(m / D == D ? -1 : m / D == m % D);
            for (int j = 0; j < COUNT; j++)
                lambda[j] = from_int_q(j == spoiled ? 2 : 1);
            const struct cagd_inequalities s = {.lambda = lambda};
            assert_int_equal(cagd_inequalities_hold(D, COUNT, forms, strict, s), spoiled < 0);
            strict[(first + 1) % COUNT] = 1; /* two strict ones have the sum 2 */
            assert_false(cagd_inequalities_hold(D, COUNT, forms, strict, s));
        }
    /* The forms 1, 1, 1 and -1 of one coordinate: two of the three may have -1 and 1, that of the strict one being 1. */
    for (int negative = 0; negative < 3; negative++) {
        num_q line[COUNT] = {from_int_q(1), from_int_q(1), from_int_q(1), from_int_q(-1)}, lambda[COUNT];
        const int strict[COUNT] = {0, 0, 0, 1};
        for (int j = 0; j < COUNT; j++)
            lambda[j] = from_int_q(j == negative ? -1 : 1);
        lambda[3] = from_int_q(1);
        assert_false(cagd_inequalities_hold(1, COUNT, line, strict, (struct cagd_inequalities){.lambda = lambda}));
        for (int j = 0; j < 3; j++)
            lambda[j] = from_int_q(j == negative);
        assert_true(cagd_inequalities_hold(1, COUNT, line, strict, (struct cagd_inequalities){.lambda = lambda}));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        unit(inequalities_are_those_of_an_elimination),
        unit(closed_conditions_may_leave_a_face),
        unit(spoiled_evidence_is_refused),
        unit(one_form_spoils_evidence),
        unit(a_system_has_a_solution_or_what_forbids_it),
    };
    return run_unit_tests(tests);
}
