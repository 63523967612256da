#include "exact/decide/linear.h"

#include "exact/words.h"

typedef struct cagd_linear_condition condition_t;

static num_q value_at(int n, const num_q a[], const num_q x[])
{
    num_q sum = a[0];
    for (int i = 0; i < n; i++)
        sum = add_q(sum, mul_q(a[i + 1], x[i]));
    return sum;
}

static int solution_holds(int n, int count, const condition_t c[], const num_q x[])
{
    int good = 1;
    for (int k = 0; k < count; k++) {
        int sign = cagd_sign_q(value_at(n, c[k].a, x));
        good &= c[k].relation == CAGD_LINEAR_POSITIVE      ? sign > 0
                : c[k].relation == CAGD_LINEAR_NONNEGATIVE ? sign >= 0
                                                           : sign == 0;
    }
    return good;
}

static int contradiction_holds(int n, int count, const condition_t c[], const num_q multiplier[])
{
    int good = 1, strict = 0, sign = 0;
    for (int k = 0; k < count; k++) {
        good &= c[k].relation == CAGD_LINEAR_ZERO || cagd_sign_q(multiplier[k]) >= 0;
        strict |= c[k].relation == CAGD_LINEAR_POSITIVE && cagd_sign_q(multiplier[k]) > 0;
    }
    for (int i = 0; i <= n; i++) {
        num_q sum = from_int_q(0);
        for (int k = 0; k < count; k++)
            sum = add_q(sum, mul_q(multiplier[k], c[k].a[i]));
        if (i == 0)
            sign = cagd_sign_q(sum);
        else
            good &= cagd_is_zero_q(sum);
    }
    return good && (sign < 0 || (sign == 0 && strict));
}

int cagd_linear_answer_holds(int n, int count, const condition_t condition[], struct cagd_linear_answer answer)
{
    return answer.solvable ? solution_holds(n, count, condition, answer.x)
                           : contradiction_holds(n, count, condition, answer.multiplier);
}

/* With y = (y_0, ..., y_n), y_0 > 0 and x_i = y_i / y_0 the conditions are a . y > 0, >= 0, = 0.  By Motzkin they and y_0 > 0 have
 * no solution exactly when there are z >= 0, of either sign where the condition is an equation, with
 *
 *     sum_k z_k a_k = 0,   sum of the z_k of the strict ones = 1,
 *
 * y_0 > 0 being a strict one, too, whose row is (1, 0, ..., 0).  Phase one minimises the sum of the slacks of these n + 2 equations.
 * Columns: z_k; -z_k of equations; z of y_0 > 0; slacks; right side.  The last row has the reduced costs and minus the
 * objective. */
struct tableau {
    int rows, columns, unknowns;
    num_q *at;
    int *basic, *condition, *sign; /* of a column: of which condition, count being y_0 > 0, and with which sign */
};

static num_q *row(const struct tableau *t, int i) { return t->at + (ptrdiff_t)i * t->columns; }

static void put_column(struct tableau *t, int n, int count, const condition_t c[], int k, int sign)
{
    int j = t->unknowns++, is_strict = k == count || c[k].relation == CAGD_LINEAR_POSITIVE;
    t->condition[j] = k;
    t->sign[j] = sign;
    for (int i = 0; i <= n; i++) {
        num_q a = k == count ? from_int_q(i == 0) : c[k].a[i];
        row(t, i)[j] = sign < 0 ? neg_q(a) : a;
    }
    row(t, n + 1)[j] = from_int_q(is_strict);
}

static int first_tableau(struct tableau *t, int n, int count, const condition_t c[])
{
    int unknowns = 1;
    for (int k = 0; k < count; k++)
        unknowns += c[k].relation == CAGD_LINEAR_ZERO ? 2 : 1;
    *t = (struct tableau){.rows = n + 2, .columns = unknowns + n + 3};
    t->at = cagd_region_array(t->rows + 1, t->columns, sizeof(num_q));
    t->basic = cagd_region_array(1, t->rows, sizeof(int));
    t->condition = cagd_region_array(1, unknowns, sizeof(int));
    t->sign = cagd_region_array(1, unknowns, sizeof(int));
    if (t->at == NULL || t->basic == NULL || t->condition == NULL || t->sign == NULL)
        return 0;
    for (int k = 0; k <= count; k++) {
        put_column(t, n, count, c, k, 1);
        if (k < count && c[k].relation == CAGD_LINEAR_ZERO)
            put_column(t, n, count, c, k, -1);
    }
    num_q zero = from_int_q(0), one = from_int_q(1), *costs = row(t, t->rows);
    for (int i = 0; i < t->rows; i++) {
        for (int k = 0; k < t->rows; k++)
            row(t, i)[unknowns + k] = k == i ? one : zero;
        row(t, i)[t->columns - 1] = i == n + 1 ? one : zero;
        t->basic[i] = unknowns + i;
    }
    for (int k = 0; k < t->columns; k++) {
        costs[k] = zero;
        for (int i = 0; (k < unknowns || k == t->columns - 1) && i < t->rows; i++)
            costs[k] = sub_q(costs[k], row(t, i)[k]);
    }
    return 1;
}

/* The column enters the basis, the row's variable leaves it. */
static void pivot(const struct tableau *t, int r, int column)
{
    num_q *p = row(t, r), inverse = div_q(from_int_q(1), p[column]);
    for (int k = 0; k < t->columns; k++)
        if (!cagd_is_zero_q(p[k]))
            p[k] = mul_q(p[k], inverse);
    for (int i = 0; i <= t->rows; i++) {
        num_q *q = row(t, i), factor = q[column];
        if (i != r && !cagd_is_zero_q(factor))
            for (int k = 0; k < t->columns; k++)
                if (!cagd_is_zero_q(p[k]))
                    q[k] = sub_q(q[k], mul_q(factor, p[k]));
    }
    t->basic[r] = column;
}

/* Bland's rule: the first column that lowers the objective enters; of the rows with the least ratio the one with the first variable
 * leaves.  So no basis comes twice. */
static void minimise(const struct tableau *t)
{
    const num_q *costs = row(t, t->rows);
    for (;;) {
        int column = 0, leaving = -1;
        while (column < t->unknowns && cagd_sign_q(costs[column]) >= 0)
            column++;
        if (column == t->unknowns)
            return;
        num_q least = {0};
        for (int i = 0; i < t->rows; i++) {
            if (cagd_sign_q(row(t, i)[column]) <= 0)
                continue;
            num_q ratio = div_q(row(t, i)[t->columns - 1], row(t, i)[column]);
            int order = leaving < 0 ? -1 : cagd_compare_q(ratio, least);
            if (order < 0 || (order == 0 && t->basic[i] < t->basic[leaving])) {
                leaving = i;
                least = ratio;
            }
        }
        pivot(t, leaving, column); /* there is one: the objective is bounded by 0 */
    }
}

/* At the minimum 0 the z are the multipliers, that of y_0 > 0 left out.  Elsewhere u_i = 1 - (reduced cost of slack i) has
 * u . column <= 0 for all columns and u . right side > 0, so with y = -(u_0, ..., u_n) the products a . y are at least u_(n+1) > 0 for
 * strict conditions, among them y_0 > 0, at least 0 for the others, and 0 for equations. */
static struct cagd_linear_answer read_off(const struct tableau *t, int n, int count)
{
    struct cagd_linear_answer answer = {.solvable = cagd_sign_q(row(t, t->rows)[t->columns - 1]) < 0};
    num_q *out = cagd_region_array(1, answer.solvable ? n + 1 : count + 1, sizeof(num_q));
    if (out == NULL)
        return (struct cagd_linear_answer){0};
    if (answer.solvable) {
        const num_q *costs = row(t, t->rows) + t->unknowns;
        num_q y0 = sub_q(costs[0], from_int_q(1));
        for (int i = 0; i < n; i++)
            out[i] = div_q(sub_q(costs[i + 1], from_int_q(1)), y0);
        answer.x = out;
        return answer;
    }
    for (int k = 0; k <= count; k++)
        out[k] = from_int_q(0);
    for (int i = 0; i < t->rows; i++)
        if (t->basic[i] < t->unknowns) {
            int k = t->condition[t->basic[i]];
            num_q z = row(t, i)[t->columns - 1];
            out[k] = add_q(out[k], t->sign[t->basic[i]] < 0 ? neg_q(z) : z);
        }
    answer.multiplier = out;
    return answer;
}

struct cagd_linear_answer cagd_linear_solve(int n, int count, const condition_t condition[])
{
    struct tableau t;
    if (!first_tableau(&t, n, count, condition)) {
        region_faults |= FAULT_MEMORY;
        return (struct cagd_linear_answer){0};
    }
    minimise(&t);
    struct cagd_linear_answer answer = read_off(&t, n, count);
    if ((answer.x != NULL || answer.multiplier != NULL) && !cagd_linear_answer_holds(n, count, condition, answer))
        region_faults |= FAULT_UNABLE;
    return answer;
}
