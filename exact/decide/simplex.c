#include "exact/decide/simplex.h"

#include "exact/words.h"

#include <limits.h>
#include <stddef.h>

/* Phase one: minimise the sum of the a_i subject to
 *
 *     sum_j A_ij x_j + a_i = b_i,   x, a >= 0,
 *
 * every equation multiplied by sigma_i = +-1 so that its right side is >= 0.  Row i of the tableau is
 * equation i solved for the basic variable of that row; the last row is the reduced costs and minus
 * the objective.  Columns: x_j, a_i, right side. */
struct tableau {
    int rows, columns; /* of A, and columns + rows + 1 */
    num_q *at;         /* (rows + 1) x columns         */
    int *basic;
};

static num_q *row(struct tableau t, int i) { return t.at + (ptrdiff_t)i * t.columns; }

static struct tableau first_tableau(int rows, int columns, const num_q A[], const num_q b[])
{
    if (rows > INT_MAX - 1 || columns > INT_MAX - 1 - rows) {
        region_faults |= FAULT_MEMORY;
        return (struct tableau){0};
    }
    struct tableau t = {.rows = rows, .columns = columns + rows + 1};
    t.at = cagd_region_array(t.rows + 1, t.columns, sizeof(num_q));
    t.basic = cagd_region_array(1, t.rows, sizeof(int));
    if (t.at == NULL || t.basic == NULL)
        return (struct tableau){0};
    num_q zero = from_int_q(0), one = from_int_q(1), *costs = row(t, t.rows);
    for (int k = 0; k < t.columns; k++)
        costs[k] = zero;
    for (int i = 0; i < rows; i++) {
        num_q *r = row(t, i);
        int minus = cagd_sign_q(b[i]) < 0;
        for (int j = 0; j < columns; j++) {
            num_q a = A[(ptrdiff_t)i * columns + j];
            r[j] = minus ? neg_q(a) : a;
        }
        for (int k = 0; k < rows; k++)
            r[columns + k] = k == i ? one : zero;
        r[t.columns - 1] = minus ? neg_q(b[i]) : b[i];
        t.basic[i] = columns + i;
        for (int k = 0; k < t.columns; k++)
            if (k < columns || k == t.columns - 1)
                costs[k] = sub_q(costs[k], r[k]);
    }
    return t;
}

/* The column enters the basis, the row's variable leaves it. */
static void pivot(struct tableau t, int r, int column)
{
    num_q *p = row(t, r), inverse = div_q(from_int_q(1), p[column]);
    for (int k = 0; k < t.columns; k++)
        p[k] = mul_q(p[k], inverse);
    for (int i = 0; i <= t.rows; i++) {
        num_q *q = row(t, i), factor = q[column];
        if (i != r && !cagd_is_zero_q(factor))
            for (int k = 0; k < t.columns; k++)
                if (!cagd_is_zero_q(p[k]))
                    q[k] = sub_q(q[k], mul_q(factor, p[k]));
    }
    t.basic[r] = column;
}

/* Bland's rule: the first column that lowers the objective enters; of the rows with the least ratio
 * the one with the first variable leaves.  So no basis comes twice. */
static void minimise(struct tableau t, int count)
{
    const num_q *costs = row(t, t.rows);
    for (;;) {
        int column = 0, leaving = -1;
        while (column < count && cagd_sign_q(costs[column]) >= 0)
            column++;
        if (column == count)
            return;
        num_q least = {0};
        for (int i = 0; i < t.rows; i++) {
            if (cagd_sign_q(row(t, i)[column]) <= 0)
                continue;
            num_q ratio = div_q(row(t, i)[t.columns - 1], row(t, i)[column]);
            int order = leaving < 0 ? -1 : cagd_compare_q(ratio, least);
            if (order < 0 || (order == 0 && t.basic[i] < t.basic[leaving])) {
                leaving = i;
                least = ratio;
            }
        }
        pivot(t, leaving, column); /* there is one: the objective is bounded by 0 */
    }
}

/* At the minimum, y_i = 1 - (reduced cost of a_i) has sigma y . A_j <= 0 for all columns j, and sigma y . b is the
 * minimum: if that is positive, no x fits. */
struct cagd_simplex cagd_simplex(int rows, int columns, const num_q A[], const num_q b[])
{
    struct tableau t = first_tableau(rows, columns, A, b);
    struct cagd_simplex s = {0};
    if (t.at == NULL)
        return s;
    minimise(t, columns);
    const num_q *costs = row(t, t.rows);
    s.solvable = cagd_is_zero_q(costs[t.columns - 1]);
    num_q *found = cagd_region_array(1, s.solvable ? columns : rows, sizeof *found);
    if (found == NULL)
        return (struct cagd_simplex){0};
    if (s.solvable) {
        for (int j = 0; j < columns; j++)
            found[j] = from_int_q(0);
        for (int i = 0; i < rows; i++)
            if (t.basic[i] < columns)
                found[t.basic[i]] = row(t, i)[t.columns - 1];
        s.x = found;
    } else {
        for (int i = 0; i < rows; i++) {
            num_q y = sub_q(from_int_q(1), costs[columns + i]);
            found[i] = cagd_sign_q(b[i]) < 0 ? neg_q(y) : y;
        }
        s.y = found;
    }
    return s;
}

/* ---- inequalities -------------------------------------------------------------------------------------- */

int cagd_inequalities_hold(int d, int count, const num_q forms[], const int strict[], struct cagd_inequalities s)
{
    int good = 1;
    for (int j = 0; s.solvable && j < count; j++) {
        num_q value = from_int_q(0);
        for (int i = 0; i < d; i++)
            value = add_q(value, mul_q(forms[d * j + i], s.point[i]));
        good &= strict[j] ? cagd_sign_q(value) > 0 : cagd_sign_q(value) >= 0;
    }
    for (int i = -1; !s.solvable && i < d; i++) { /* i = -1: the sum over the strict ones */
        num_q sum = from_int_q(0);
        for (int j = 0; j < count; j++) {
            if (i >= 0)
                sum = add_q(sum, mul_q(forms[d * j + i], s.lambda[j]));
            else if (strict[j])
                sum = add_q(sum, s.lambda[j]);
            good &= cagd_sign_q(s.lambda[j]) >= 0;
        }
        good &= cagd_equal_q(sum, from_int_q(i < 0));
    }
    return good;
}

/* The numbers lambda are a linear system; where it has no solution, y = (n, m) with n . form_j + m s_j <= 0 (s_j = 1 for a strict form,
 * else 0) and m > 0 shows -n as a point. */
struct cagd_inequalities cagd_inequalities(int d, int count, const num_q forms[], const int strict[])
{
    struct cagd_inequalities result = {0};
    num_q *A = cagd_region_array(d + 1, count, sizeof *A), *b = cagd_region_array(d + 1, 1, sizeof *b);
    if (A == NULL || b == NULL)
        return result;
    for (int i = 0; i <= d; i++) {
        b[i] = from_int_q(i == d);
        for (int j = 0; j < count; j++)
            A[(ptrdiff_t)i * count + j] = i < d ? forms[d * j + i] : from_int_q(strict[j] != 0);
    }
    struct cagd_simplex s = cagd_simplex(d + 1, count, A, b);
    num_q *point = s.y != NULL ? cagd_region_array(d, 1, sizeof *point) : NULL;
    if (s.x == NULL && point == NULL)
        return result;
    for (int i = 0; point != NULL && i < d; i++)
        point[i] = neg_q(s.y[i]);
    result = (struct cagd_inequalities){!s.solvable, point, s.x};
    if (!cagd_inequalities_hold(d, count, forms, strict, result))
        region_faults |= FAULT_UNABLE;
    return result;
}
