/* read_matrix.c -- matrices: entries in rows, products, transposed, powers, determinants.
 *
 * A matrix of one column is a vector, and a matrix of one row and one column a number.  A vector in square brackets before a matrix of
 * as many rows is a row: [1 \; t \; t^2] M. */
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

enum { MOST_IN_DETERMINANT = 6, MOST_MATRIX_POWER = 12 };

static int shape_of(int rows, int columns) { return columns > 1 ? rows + CAGD_MATRIX * columns : rows > 1 ? rows : 0; }

const char *cagd_called(int dimension)
{
    char text[48];
    if (cagd_is_matrix(dimension))
        snprintf(text, sizeof text, "a matrix of %d rows and %d columns", cagd_rows(dimension),
                 cagd_columns(dimension));
    else
        snprintf(text, sizeof text, "a vector of %d components", dimension);
    const char *kept = cagd_text_of(text, (int)strlen(text));
    return dimension == 0 || kept == NULL ? "a number" : kept;
}

/* The same with the dimension, which is given and not that of the parts. */
static const cagd_tree *shaped(cagd_reader *r, cagd_tree_kind kind, int from, int count, const cagd_tree *const list[],
                               int dimension)
{
    cagd_tree *t = cagd_new_of(r, kind, from, count, list);
    if (t != NULL)
        t->dimension = dimension;
    return t;
}

/* Whether it is a vector in square brackets, perhaps with numbers before it: \frac12 [t \; 1]. */
static int may_be_row(const cagd_tree *a)
{
    const cagd_tree *vector = a;
    int vectors = 0;
    for (int k = 0; a->kind == CAGD_PRODUCT && k < a->count; k++)
        if (a->at[k]->dimension > 0)
            vector = a->at[k], vectors++;
    return vectors == 1 ? may_be_row(vector) : vector->kind == CAGD_POINT && !cagd_is_matrix(vector->dimension);
}

const cagd_tree *cagd_matrix_product(cagd_reader *r, const cagd_tree *a, const cagd_tree *b)
{
    int rows = a->dimension == 0 ? 1 : cagd_rows(a->dimension), inside = cagd_columns(a->dimension);
    if (may_be_row(a) && a->dimension == cagd_rows(b->dimension))
        rows = 1, inside = a->dimension;
    if (a->dimension == 0 || b->dimension == 0)
        return cagd_new_of(r, CAGD_PRODUCT, a->from, 2, (const cagd_tree *[]){a, b});
    if (inside != cagd_rows(b->dimension))
        return cagd_refuse_tree(r, b, "%s before %s: there is no such product", cagd_called(a->dimension),
                                cagd_called(b->dimension));
    cagd_tree *t = cagd_new_of(r, CAGD_MATRIX_PRODUCT, a->from, 2, (const cagd_tree *[]){a, b});
    if (t == NULL)
        return NULL;
    t->order = inside, t->dimension = shape_of(rows, cagd_columns(b->dimension)), t->to = b->to;
    int of_points = (b->kind == CAGD_TRANSPOSED || b->kind == CAGD_MATRIX_PRODUCT) && b->juxtaposed;
    t->juxtaposed = of_points;
    return of_points && rows == 1 ? cagd_transposed(r, t) : t;
}

const cagd_tree *cagd_chain_of_matrices(cagd_reader *r, const cagd_tree *t)
{
    const cagd_tree *product = t->at[0];
    for (int k = 1; k < t->count && product != NULL; k++)
        product = cagd_matrix_product(r, product, t->at[k]);
    return product;
}

const cagd_tree *cagd_determinant_of(cagd_reader *r, const cagd_tree *t, int from)
{
    const cagd_tree *list[CAGD_MOST_CHILDREN];
    int rows = cagd_rows(t->dimension);
    if (!cagd_is_matrix(t->dimension) || rows != cagd_columns(t->dimension) || rows > MOST_IN_DETERMINANT)
        return cagd_refuse_tree(r, t, "a determinant is of as many columns as rows, at most %d; this is %s",
                                MOST_IN_DETERMINANT, cagd_called(t->dimension));
    for (int k = 0; k < rows * rows; k++)
        list[k] = cagd_component_of(r, t, k);
    cagd_tree *d = cagd_new_of(r, CAGD_DETERMINANT, from, rows * rows, list);
    if (d != NULL)
        d->order = rows;
    return d;
}

int cagd_pass_transposed(cagd_reader *r)
{
    static const char *const faces[] = {"\\mathsf", "\\mathrm", "\\mathit", "\\mathtt", "\\mathbf"};
    const cagd_token *start = r->token;
    int outer = cagd_pass(r, "{"), inner = 0;
    for (size_t k = 0; k < sizeof faces / sizeof *faces; k++)
        if (cagd_pass(r, faces[k])) {
            inner = cagd_pass(r, "{");
            break;
        }
    if ((cagd_pass(r, "T") || cagd_pass(r, "t") || cagd_pass(r, "\\top") || cagd_pass(r, "\\intercal")) &&
        (!inner || cagd_pass(r, "}")) && (!outer || cagd_pass(r, "}")))
        return 1;
    r->token = start;
    return 0;
}

const cagd_tree *cagd_transposed(cagd_reader *r, const cagd_tree *t)
{
    int dimension = shape_of(cagd_columns(t->dimension), cagd_rows(t->dimension));
    return shaped(r, CAGD_TRANSPOSED, t->from, 1, &t, dimension);
}

/* The matrix with 1 on its diagonal and 0 elsewhere. */
static const cagd_tree *identity(cagd_reader *r, int dimension, const cagd_tree *where)
{
    const cagd_tree *entry[CAGD_MOST_ROWS * CAGD_MOST_ROWS];
    int rows = cagd_rows(dimension);
    for (int k = 0; k < rows * rows; k++)
        entry[k] = cagd_tree_number(k % (rows + 1) == 0, where->from, where->to);
    return shaped(r, CAGD_POINT, where->from, rows * rows, entry, dimension);
}

const cagd_tree *cagd_matrix_power(cagd_reader *r, const cagd_tree *t, const cagd_tree *exponent)
{
    int minus = exponent->kind == CAGD_NEGATIVE;
    const cagd_tree *n = minus ? exponent->at[0] : exponent, *factor = t;
    int square = cagd_is_matrix(t->dimension) && cagd_rows(t->dimension) == cagd_columns(t->dimension);
    if (!square)
        return cagd_refuse_tree(r, t, "a power of %s", cagd_called(t->dimension));
    if (n->kind == CAGD_NUMBER && cagd_sign_q(n->number) == 0)
        return identity(r, t->dimension, exponent);
    if (n->kind != CAGD_NUMBER || !cagd_is_whole_q(n->number) || cagd_sign_q(n->number) < 0 ||
        cagd_compare_q(n->number, from_int_q(MOST_MATRIX_POWER)) > 0)
        return cagd_refuse_tree(r, exponent, "a matrix has powers with numbers from 0 to %d, and ^T",
                                MOST_MATRIX_POWER);
    if (minus && cagd_rows(t->dimension) > MOST_IN_DETERMINANT)
        return cagd_refuse_tree(r, t, "the inverse of more than %d rows", MOST_IN_DETERMINANT);
    if (minus)
        factor = shaped(r, CAGD_INVERSE, t->from, 1, &t, t->dimension);
    const cagd_tree *power = factor;
    for (long k = mpz_get_si(mpq_numref(n->number.at)); k > 1 && power != NULL; k--)
        power = cagd_matrix_product(r, power, factor);
    return power;
}

const cagd_tree *cagd_columns_of(cagd_reader *r, int count, const cagd_tree *const list[], int from)
{
    const cagd_tree *entry[CAGD_MOST_ROWS * CAGD_MOST_ROWS];
    int rows = list[0]->dimension;
    for (int k = 0; k < count; k++) {
        if (cagd_is_matrix(list[k]->dimension) || list[k]->dimension != rows)
            return cagd_refuse_tree(r, list[k], "columns that are vectors have one dimension; this is %s",
                                    cagd_called(list[k]->dimension));
        for (int row = 0; row < rows; row++)
            entry[row * count + k] = cagd_component_of(r, list[k], row);
    }
    return shaped(r, CAGD_POINT, from, rows * count, entry, shape_of(rows, count));
}

/* The points P_0, P_1, ... below one another: the matrix whose rows they are; a row before it is a combination of them, and so a point. */
static const cagd_tree *points_below_one_another(cagd_reader *r, int count, const cagd_tree *const list[], int from)
{
    const cagd_tree *columns = cagd_columns_of(r, count, list, from);
    cagd_tree *rows = columns != NULL ? cagd_new_of(r, CAGD_TRANSPOSED, from, 1, &columns) : NULL;
    if (rows != NULL)
        rows->dimension = shape_of(count, cagd_rows(columns->dimension)), rows->juxtaposed = 1;
    return rows;
}

/* ---- entries in rows ----------------------------------------------------------------------------------- */

static const char *const environments[] = {"pmatrix", "bmatrix", "Bmatrix", "matrix", "smallmatrix", "array", NULL};

int cagd_pass_columns(cagd_reader *r)
{
    if (!cagd_expect(r, "{", "\\begin{array}"))
        return 0;
    while (cagd_pass(r, "c") || cagd_pass(r, "l") || cagd_pass(r, "r") || cagd_pass(r, "|"))
        ;
    return cagd_expect(r, "}", "the columns");
}

const char *cagd_pass_matrix(cagd_reader *r)
{
    for (int k = 0; environments[k] != NULL; k++)
        if (cagd_environment(r, environments[k]))
            return environments[k];
    return NULL;
}

const cagd_tree *cagd_read_matrix(cagd_reader *r, const char *name, int from)
{
    const cagd_tree *list[CAGD_MOST_CHILDREN];
    int count = 0, rows = 0, columns = 0;
    if (strcmp(name, "array") == 0 && !cagd_pass_columns(r))
        return NULL;
    do {
        if (cagd_next_is(r, "\\end"))
            break;
        int in_row = 0;
        do {
            if (in_row == CAGD_MOST_ROWS || rows == CAGD_MOST_ROWS)
                return cagd_refuse_token(r, "a matrix of more than %d rows or columns", CAGD_MOST_ROWS);
            list[count] = cagd_read_sum(r);
            if (list[count++] == NULL)
                return NULL;
            in_row++;
        } while (cagd_pass(r, "&"));
        if (rows++ > 0 && in_row != columns)
            return cagd_refuse_token(r, "rows of different lengths");
        columns = in_row;
    } while (cagd_pass(r, "\\\\"));
    if (!cagd_expect(r, "\\end", "the matrix") || !cagd_environment(r, name))
        return cagd_refuse_token(r, "expected \\end{%s}", name);
    if (count == 0)
        return cagd_refuse_token(r, "a matrix without entries");
    if (rows == 1 && count > 1 && list[0]->dimension > 0)
        return cagd_columns_of(r, count, list, from);
    if (columns == 1 && count > 1 && list[0]->dimension > 0)
        return points_below_one_another(r, count, list, from);
    return count == 1 ? list[0] : shaped(r, CAGD_POINT, from, count, list, shape_of(rows, columns));
}
