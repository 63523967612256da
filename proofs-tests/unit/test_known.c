/* test_known.c -- random systems of what is known of names, and random inequalities, against slow forms: elimination (Fourier and Motzkin),
 * and all points of a grid with what lies near its ends. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/expression/cell.h"
#include "exact/expression/order.h"
#include "exact/expression/sign.h"

#include <string.h>

enum { NAMES = 3, MOST_ROWS = 4000 };

static cagd_scope scope;
static cagd_context cell;

/* c_0 + c_1 x + c_2 y + c_3 u > 0, or >= 0. */
struct row {
    long c[NAMES + 1];
    int strict;
};

static num_f variable(int k) { return cagd_in_field(cell.binding[k].value); } /* or the function of others that it is */
static num_f form_of(const long c[])
{
    num_f f = from_int_f(c[0]);
    for (int k = 0; k < NAMES; k++)
        f = add_f(f, mul_f(from_int_f(c[k + 1]), variable(k)));
    return f;
}

/* In the order that is drawn. */
static void begin(void)
{
    static const char *const name[] = {"x", "y", "u"};
    scope = (cagd_scope){0};
    field_open(16);
    cell = (cagd_context){.scope = &scope, .steps = CAGD_USUAL_STEPS, .in_field = 1};
    for (int k = 0, first = random_int(0, NAMES - 1); k < NAMES; k++)
        cagd_value_of_key(&cell, name[(first + k) % NAMES], NULL);
    assert_int_equal(cell.count, NAMES);
}

/* Whether numbers satisfy all rows: names are eliminated, each pair of a lower and an upper bound leaving one row.  The coefficients are
 * small, so that whole numbers suffice. */
static int is_solvable(int count, const struct row given[])
{
    static struct row row[MOST_ROWS], next[MOST_ROWS];
    memcpy(row, given, (size_t)count * sizeof *row);
    for (int k = NAMES; k >= 1; k--) {
        int made = 0;
        for (int i = 0; i < count; i++) {
            if (row[i].c[k] == 0)
                next[made++] = row[i];
            for (int j = 0; j < count && row[i].c[k] > 0; j++) {
                if (row[j].c[k] >= 0)
                    continue;
                struct row both = {.strict = row[i].strict || row[j].strict};
                for (int m = 0; m <= NAMES; m++)
                    both.c[m] = row[i].c[m] * -row[j].c[k] + row[j].c[m] * row[i].c[k];
                assert_true(made < MOST_ROWS);
                next[made++] = both;
            }
        }
        memcpy(row, next, (size_t)made * sizeof *row);
        count = made;
    }
    for (int i = 0; i < count; i++)
        if (row[i].c[0] < 0 || (row[i].c[0] == 0 && row[i].strict))
            return 0;
    return 1;
}

/* Rows of one, two or three names; often two that touch. */
static int draw_rows(struct row row[])
{
    int count = random_int(1, 5);
    for (int i = 0; i < count; i++) {
        row[i] = (struct row){.strict = random_int(0, 1)};
        int names = random_int(1, NAMES), first = random_int(0, NAMES - 1);
        row[i].c[0] = random_int(-2, 2);
        for (int k = 0; k < names; k++)
            row[i].c[1 + (first + k) % NAMES] = random_int(-2, 2);
        if (i > 0 && random_int(0, 3) == 0) { /* the other side of the one before */
            for (int m = 0; m <= NAMES; m++)
                row[i].c[m] = -row[i - 1].c[m];
            row[i].c[0] += random_int(0, 1);
        }
    }
    return count;
}

/* The rows become known, one of them as an equality if `equal` is not below 0; 0 where there is no room for one. */
static void make_known(int count, const struct row row[], int equal)
{
    for (int i = 0; i < count; i++) {
        num_f f = form_of(row[i].c);
        if (i == equal)
            assert_true(cagd_solve_in_cell(&cell, f));
        else
            assert_true(cagd_limit_cell(&cell, f, row[i].strict));
    }
}

/* Whether there are values, and which signs a form has there, is what elimination finds; a point of the cell meets all rows. */
static void cells_are_what_elimination_finds(void **state)
{
    (void)state;
    int empty = 0, seen[8] = {0};
    for (int trial = 0; trial < 1500; trial++) {
        region_mark mark = region_open();
        struct row row[10];
        int count = draw_rows(row), equal = random_int(0, 2) == 0 ? random_int(0, count - 1) : -1, rows = count;
        begin();
        make_known(count, row, equal);
        if (equal >= 0) {
            row[equal].strict = 0, row[rows] = row[equal];
            for (int m = 0; m <= NAMES; m++)
                row[rows].c[m] = -row[equal].c[m];
            rows++;
        }
        struct row asked = {{random_int(-2, 2), random_int(-2, 2), random_int(-2, 2), random_int(-2, 2)}, 0};
        if (random_int(0, 1)) { /* one of the rows, or nearly */
            asked = row[random_int(0, rows - 1)];
            asked.c[random_int(0, NAMES)] += random_int(0, 1);
        }
        unsigned expected = 0;
        for (int sign = -1; sign <= 1; sign++) {
            struct row more[12];
            int m = rows;
            memcpy(more, row, sizeof row);
            for (int side = -1; side <= 1; side += 2) { /* sign * form > 0, or both sides >= 0 */
                if (sign != 0 && side != sign)
                    continue;
                more[m].strict = sign != 0;
                for (int k = 0; k <= NAMES; k++)
                    more[m].c[k] = side * asked.c[k];
                m++;
            }
            if (is_solvable(m, more))
                expected |= sign < 0 ? CAGD_CAN_BE_NEGATIVE : sign > 0 ? CAGD_CAN_BE_POSITIVE : CAGD_CAN_BE_ZERO;
        }
        int is_empty = cagd_cell_is_empty(&cell);
        assert_int_equal(is_empty, !is_solvable(rows, row));
        assert_int_equal(is_empty, expected == 0);
        empty += is_empty;
        seen[expected]++;
        if (!is_empty) {
            num_q value[CAGD_MOST_UNKNOWNS];
            assert_int_equal(cagd_signs_of_form(&cell, form_of(asked.c)), expected);
            assert_int_equal(cagd_signs(&cell, cagd_value_f(form_of(asked.c))), expected);
            assert_int_equal(cagd_signs_of_form(&cell, form_of(asked.c)), expected); /* as it is remembered */
            assert_true(cagd_point_of_cell(&cell, value));
            for (int i = 0; i < rows; i++) {
                num_f f = form_of(row[i].c);
                num_q at;
                for (int k = 0; k < NAMES; k++)
                    if (cell.binding[k].unknown)
                        f = substitute_f(f, variable(k), from_rational_f(value[k]));
                assert_true(is_constant_f(f, &at));
                assert_true(cagd_sign_q(at) > 0 || (cagd_sign_q(at) == 0 && !row[i].strict));
            }
        }
        assert_int_equal(region_faults, 0);
        field_close();
        region_drop(mark);
    }
    assert_true(empty > 300 && seen[1] > 30 && seen[2] > 40 && seen[3] > 3 && seen[4] > 150 && seen[6] > 50 &&
                seen[7] > 400);
}

/* ---- inequalities -------------------------------------------------------------------------------------- */

/* a t^i ... for random exponents, or a product of such polynomials, or the square of one. */
static num_f draw_polynomial(int count, const num_f x[])
{
    num_f p = from_int_f(random_int(-3, 4));
    for (int term = random_int(1, 3); term > 0; term--) {
        num_f t = from_int_f(random_int(-3, 3));
        for (int k = 0; k < count; k++)
            for (int e = random_int(0, 2); e > 0; e--)
                t = random_int(0, 1) ? mul_f(t, x[k]) : t;
        p = add_f(p, t);
    }
    return random_int(0, 3) == 0 ? add_f(mul_f(p, p), from_int_f(random_int(-1, 1))) : p;
}

/* The sides of a box: with an end, two, or none, open or closed, or a point. */
static cagd_side_of_box draw_side(num_f x)
{
    cagd_side_of_box s = {x,
                          random_int(0, 3) > 0,
                          random_int(0, 3) > 0,
                          random_int(0, 1),
                          random_int(0, 1),
                          from_int_q(random_int(-2, 1)),
                          from_int_q(0)};
    s.high = add_q(s.low, from_int_q(random_int(0, 7) == 0 ? 0 : random_int(1, 3)));
    if (cagd_equal_q(s.low, s.high) && s.has_low && s.has_high)
        s.low_open = s.high_open = 0;
    return s;
}

enum { POINTS = 13 };
/* Numbers of the side: its ends, what is near them, between, and far where it has none; at most so many. */
static int numbers_of(const cagd_side_of_box *s, num_q out[], int most)
{
    static const long step[POINTS][2] = {{0, 1}, {1, 1000000}, {1, 3}, {1, 1}, {2, 1}, {-50, 1}, {50, 1},
                                         {1, 7}, {1, 2},       {3, 2}, {5, 2}, {3, 1}, {-1, 2}};
    int count = 0;
    for (int k = 0; k < 2 * POINTS; k++) {
        num_q from = k < POINTS ? s->low : s->high, by = from_ratio_q(step[k % POINTS][0], step[k % POINTS][1]);
        num_q x = k < POINTS ? add_q(from, by) : sub_q(from, by);
        int order = s->has_low ? cagd_compare_q(x, s->low) : 1, up = s->has_high ? cagd_compare_q(s->high, x) : 1;
        int is_in = (order > 0 || (order == 0 && !s->low_open)) && (up > 0 || (up == 0 && !s->high_open)), known = 0;
        assert_int_equal(cagd_is_inside(s, x), is_in);
        for (int m = 0; m < count; m++)
            known |= cagd_equal_q(out[m], x);
        if (is_in && !known && count < most)
            out[count++] = x;
    }
    return count;
}

static int sign_at(num_f p, int count, const num_f x[], const num_q at[])
{
    num_q value;
    for (int k = 0; k < count; k++)
        p = substitute_f(p, x[k], from_rational_f(at[k]));
    assert_true(is_constant_f(p, &value));
    return cagd_sign_q(value);
}

/* Whether p < 0, or 0 if it must not be, at a point of the grid. */
static int is_broken(num_f p, int strict, int count, const num_f x[], const cagd_side_of_box side[])
{
    num_q list[NAMES][POINTS], at[NAMES];
    int lengths[NAMES], all = 1;
    for (int k = 0; k < count; k++)
        all *= lengths[k] = numbers_of(&side[k], list[k], count < 3 ? POINTS : 7);
    for (int g = 0; g < all; g++) {
        region_mark mark = region_open();
        for (int k = 0, rest = g; k < count; rest /= lengths[k++])
            at[k] = list[k][rest % lengths[k]];
        int sign = sign_at(p, count, x, at);
        region_drop(mark);
        if (sign < 0 || (sign == 0 && strict))
            return 1;
    }
    return 0;
}

/* In boxes of every kind: what holds is broken at no point of the grid, what is broken fails, and a point that is given breaks it.  In one
 * variable and in two all is decided. */
static void inequalities_in_boxes(void **state)
{
    (void)state;
    int seen[NAMES + 1][3] = {{0}}, rationals = 0;
    for (int trial = 0; trial < 900; trial++) {
        region_mark mark = region_open();
        field_open(4);
        num_f x[NAMES] = {variable_f("a"), variable_f("b"), variable_f("c")};
        int count = 1 + trial % NAMES, strict = random_int(0, 1), rational;
        cagd_side_of_box side[NAMES];
        num_q point[NAMES];
        for (int k = 0; k < count; k++)
            side[k] = draw_side(x[k]);
        num_f p = draw_polynomial(count, x);
        cagd_answer answer = cagd_positive_in_box(p, strict, count, side, point, &rational);
        int broken = is_broken(p, strict, count, x, side);
        assert_int_equal(region_faults, 0);
        seen[count][answer]++;
        if (broken)
            assert_int_not_equal(answer, CAGD_HOLDS);
        if (count < 3)
            assert_int_not_equal(answer, CAGD_UNDECIDED);
        if (answer == CAGD_FAILS && rational) {
            for (int k = 0; k < count; k++)
                assert_true(cagd_is_inside(&side[k], point[k]));
            int sign = sign_at(p, count, x, point);
            assert_true(sign < 0 || (sign == 0 && strict));
            rationals++;
        }
        if (cagd_is_positive_by_coefficients(p, strict, count, side))
            assert_false(broken);
        field_close();
        region_drop(mark);
    }
    for (int count = 1; count <= NAMES; count++)
        assert_true(seen[count][CAGD_HOLDS] > 40 && seen[count][CAGD_FAILS] > 100);
    assert_true(seen[3][CAGD_UNDECIDED] < 10 && rationals > 300);
}

/* For which numbers of a parameter: at each of a grid the answer is that of its cell, or of the number where two cells meet. */
static void cells_of_a_parameter(void **state)
{
    (void)state;
    int seen[2][3] = {{0}};
    for (int trial = 0; trial < 300; trial++) {
        region_mark mark = region_open();
        field_open(4);
        num_f x[2] = {variable_f("a"), variable_f("b")};
        cagd_constraint constraint[2];
        cagd_side_of_box parameter = draw_side(x[1]);
        int constraints = random_int(1, 2);
        for (int i = 0; i < constraints; i++)
            constraint[i] = (cagd_constraint){
                .p = draw_polynomial(2, x), .demand = (cagd_demand)random_int(0, 1), .t = draw_side(x[0])};
        cagd_cells *cells = region_bytes(sizeof *cells);
        assert_non_null(cells);
        assert_true(cagd_cells_of(constraints, constraint, &parameter, cells));
        int telling = -1, rank = 0; /* beside a cell where all hold: 1000; and the shorter its number the better */
        for (int k = 0; k <= cells->count; k++) {
            int beside = (k > 0 && !cells->empty[k - 1] && cells->cell[k - 1] == CAGD_HOLDS) ||
                         (k < cells->count && !cells->empty[k + 1] && cells->cell[k + 1] == CAGD_HOLDS);
            int is = 1000 * beside + 900 - (int)strlen(to_string_q(cells->sample[k]));
            if (!cells->empty[k] && cells->cell[k] == CAGD_FAILS && is > rank)
                telling = k, rank = is;
        }
        assert_int_equal(cagd_telling_failure(cells), telling);
        num_q number[POINTS];
        for (int count = numbers_of(&parameter, number, POINTS), k = 0; k < count; k++) {
            cagd_answer expected = CAGD_HOLDS, is;
            for (int i = 0; i < constraints; i++) {
                num_f p = substitute_f(constraint[i].p, x[1], from_rational_f(number[k]));
                num_q point;
                int rational;
                if (cagd_positive_in_box(p, constraint[i].demand == CAGD_MORE_THAN_ZERO, 1, &constraint[i].t, &point,
                                         &rational) == CAGD_FAILS)
                    expected = CAGD_FAILS;
            }
            int below = 0, at = -1;
            for (int m = 0; m < cells->count; m++) {
                struct cagd_root *r = &cells->root[m];
                while (!cagd_equal_q(r->lo, r->hi) && cagd_compare_q(r->lo, number[k]) <= 0 &&
                       cagd_compare_q(number[k], r->hi) <= 0)
                    *r = refine_root(*r, div_q(sub_q(r->hi, r->lo), from_int_q(2)));
                if (cagd_equal_q(r->lo, r->hi) && cagd_equal_q(r->lo, number[k]))
                    at = m;
                below += cagd_compare_q(r->hi, number[k]) < 0;
            }
            is = at >= 0 ? cells->at[at] : cells->cell[below];
            assert_true(at >= 0 || !cells->empty[below]);
            assert_int_equal(is, expected);
            seen[at >= 0][is]++;
        }
        field_close();
        region_drop(mark);
    }
    assert_true(seen[0][CAGD_HOLDS] > 200 && seen[0][CAGD_FAILS] > 200 && seen[1][CAGD_HOLDS] > 20 &&
                seen[1][CAGD_FAILS] > 20);
}

/* Whether p is positive where names are known together: the points of a grid that meet all rows. */
static void inequalities_in_cells(void **state)
{
    (void)state;
    int seen[3] = {0}, broken_ones = 0, inside = 0, of_rows = 0, known = 0;
    for (int trial = 0; trial < 400; trial++) {
        region_mark mark = region_open();
        struct row row[10];
        int count = draw_rows(row), strict = random_int(0, 1), rational;
        num_q value[CAGD_MOST_UNKNOWNS];
        begin();
        make_known(count, row, -1);
        num_f x[NAMES] = {variable(0), variable(1), variable(2)}, p = draw_polynomial(NAMES, x);
        if (random_int(0, 1)) /* what follows by multiplying rows */
            p = add_f(mul_f(form_of(row[0].c), form_of(row[count - 1].c)), from_int_f(random_int(0, 1)));
        if (!cagd_cell_is_empty(&cell)) {
            for (int i = 0; i < count; i++) /* what is known is known */
                of_rows += 1, known += cagd_is_positive_in_cell(&cell, form_of(row[i].c), row[i].strict);
            cagd_answer answer = cagd_positive_in_cell(&cell, p, strict, value, &rational);
            int broken = 0;
            seen[answer]++;
            for (int g = 0; g < 9 * 9 * 9 && !broken; g++) {
                region_mark inner = region_open();
                long half[] = {1, g % 9 - 4, g / 9 % 9 - 4, g / 81 - 4};
                num_q at[NAMES];
                int is_in = 1;
                for (int k = 0; k < NAMES; k++)
                    at[k] = from_ratio_q(half[k + 1], 2);
                for (int i = 0; i < count; i++) {
                    long sum = 2 * row[i].c[0];
                    for (int k = 1; k <= NAMES; k++)
                        sum += row[i].c[k] * half[k];
                    is_in &= sum > 0 || (sum == 0 && !row[i].strict);
                }
                int sign = is_in ? sign_at(p, NAMES, x, at) : 1;
                broken = sign < 0 || (sign == 0 && strict);
                region_drop(inner);
            }
            broken_ones += broken;
            int breaks = answer == CAGD_FAILS &&
                         rational; /* a point of the cell, unless what is looked at is more than the cell */
            for (int i = 0; i < count && breaks; i++) {
                num_q sum = from_int_q(row[i].c[0]);
                for (int k = 0; k < NAMES; k++) /* the names were met in the order of `draw_rows` */
                    sum = add_q(sum, mul_q(from_int_q(row[i].c[k + 1]), value[k]));
                breaks = cagd_sign_q(sum) > 0 || (cagd_sign_q(sum) == 0 && !row[i].strict);
            }
            if (breaks) {
                int sign = sign_at(p, NAMES, x, value);
                assert_true(sign < 0 || (sign == 0 && strict));
            }
            inside += breaks;
            if (broken)
                assert_int_not_equal(answer, CAGD_HOLDS);
            if (answer == CAGD_HOLDS)
                assert_true(cagd_is_positive_in_cell(&cell, p, strict));
        }
        region_faults = 0;
        field_close();
        region_drop(mark);
    }
    assert_true(known >= of_rows - 1);
    assert_true(seen[CAGD_HOLDS] >= 167 && inside >= 113 && broken_ones >= 106 &&
                seen[CAGD_UNDECIDED] <= 2); /* no less than it was */
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(cells_are_what_elimination_finds), unit(inequalities_in_boxes),
                                       unit(cells_of_a_parameter), unit(inequalities_in_cells)};
    return run_unit_tests(tests);
}
