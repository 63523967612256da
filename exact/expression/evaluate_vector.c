/* evaluate_vector.c -- vectors and matrices, one component at a time. */
#include "exact/expression/evaluator.h"
#include "exact/words.h"

/* The component k of a vector, from 0, whichever is asked for here. */
cagd_value cagd_component_value(cagd_context *c, const cagd_tree *t, int k, const cagd_frame *f)
{
    int asked = c->component;
    c->component = k + 1;
    cagd_value r = cagd_evaluate_in(c, t, f);
    c->component = asked;
    return r;
}

cagd_value cagd_dot_value(cagd_context *c, const cagd_tree *a, const cagd_tree *b, const cagd_frame *f)
{
    cagd_value r = cagd_value_int(0);
    for (int k = 0; k < a->dimension; k++)
        r = cagd_value_add(r, cagd_value_mul(cagd_component_value(c, a, k, f), cagd_component_value(c, b, k, f)));
    return r;
}

/* The component k of a x b. */
static cagd_value cross(cagd_context *c, const cagd_tree *a, const cagd_tree *b, int k, const cagd_frame *f)
{
    int i = (k + 1) % 3, j = (k + 2) % 3;
    return cagd_value_sub(cagd_value_mul(cagd_component_value(c, a, i, f), cagd_component_value(c, b, j, f)),
                          cagd_value_mul(cagd_component_value(c, a, j, f), cagd_component_value(c, b, i, f)));
}

/* (a, b, c) = (a x b) . c */
cagd_value cagd_mixed_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    cagd_value r = cagd_value_int(0);
    for (int k = 0; k < 3; k++)
        r = cagd_value_add(r,
                           cagd_value_mul(cross(c, t->at[0], t->at[1], k, f), cagd_component_value(c, t->at[2], k, f)));
    return r;
}

cagd_value cagd_vector_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    if (c->component == 0)
        return cagd_fail(c, t, FAULT_UNABLE, "a vector where a number is expected");
    return t->kind == CAGD_POINT ? cagd_evaluate_in(c, t->at[c->component - 1], f)
                                 : cross(c, t->at[0], t->at[1], c->component - 1, f);
}

/* The determinant of the rows from `row` on without the columns used: by its first row (Laplace). */
static cagd_value minor(const cagd_value entry[], int rows, int row, unsigned used)
{
    cagd_value r = cagd_value_int(row == rows);
    for (int k = 0, sign = 1; k < rows && row < rows; k++) {
        if (used >> k & 1)
            continue;
        cagd_value a = entry[row * rows + k];
        if (!cagd_value_is_zero(a)) {
            cagd_value term = cagd_value_mul(a, minor(entry, rows, row + 1, used | 1u << k));
            r = sign > 0 ? cagd_value_add(r, term) : cagd_value_sub(r, term);
        }
        sign = -sign;
    }
    return r;
}

cagd_value cagd_determinant_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    cagd_value entry[CAGD_MOST_CHILDREN];
    for (int k = 0; k < t->count; k++)
        entry[k] = cagd_evaluate_in(c, t->at[k], f);
    return region_faults != 0 ? cagd_value_int(0) : minor(entry, t->order, 0, 0);
}

/* An entry of the inverse: the minor without its column and row, with its sign, by the determinant. */
static cagd_value inverse(cagd_context *c, const cagd_tree *t, int row, int column, const cagd_frame *f)
{
    cagd_value entry[CAGD_MOST_CHILDREN], rest[CAGD_MOST_CHILDREN];
    int n = cagd_rows(t->dimension), count = 0;
    for (int k = 0; k < n * n; k++)
        entry[k] = cagd_component_value(c, t->at[0], k, f);
    if (region_faults != 0)
        return cagd_value_int(0);
    for (int k = 0; k < n * n; k++)
        if (k / n != column && k % n != row)
            rest[count++] = entry[k];
    cagd_value whole = minor(entry, n, 0, 0), part = minor(rest, n - 1, 0, 0);
    if (cagd_is_zero_at_roots(c, whole))
        return cagd_fail(c, t, FAULT_UNDEFINED, "the inverse of a matrix whose determinant is 0");
    if (!cagd_note_divisor(c, whole))
        return cagd_fail(c, t, FAULT_UNABLE, "too many divisors");
    if ((row + column) % 2 != 0)
        part = cagd_value_sub(cagd_value_int(0), part);
    return cagd_value_div(part, whole);
}

/* The entry of a matrix that is asked for: of a product, of one transposed, of an inverse, by its minors. */
cagd_value cagd_matrix_value(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    if (c->component == 0 && t->dimension > 0)
        return cagd_fail(c, t, FAULT_UNABLE, "a matrix where a number is expected");
    int k = t->dimension > 0 ? c->component - 1 : 0, columns = cagd_columns(t->dimension);
    int row = k / columns, column = k % columns;
    if (t->kind == CAGD_TRANSPOSED)
        return cagd_component_value(c, t->at[0], column * cagd_columns(t->at[0]->dimension) + row, f);
    if (t->kind == CAGD_INVERSE)
        return inverse(c, t, row, column, f);
    cagd_value sum = cagd_value_int(0);
    for (int m = 0; m < t->order && region_faults == 0; m++) {
        int behind = m * cagd_columns(t->at[1]->dimension) + column;
        sum = cagd_value_add(sum, cagd_value_mul(cagd_component_value(c, t->at[0], row * t->order + m, f),
                                                 cagd_component_value(c, t->at[1], behind, f)));
    }
    return sum;
}
