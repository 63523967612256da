/* read_vector.c -- points and vectors: their dimensions, products, and relations between them. */
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <string.h>

enum { MOST_COMPONENTS = 8, OF_SPACE = 3 };

/* The number 0 is the vector 0, too. */
static int is_zero(const cagd_tree *t) { return t->kind == CAGD_NUMBER && cagd_sign_q(t->number) == 0; }

/* The parts of t that are vectors where t is one. */
static int is_part(const cagd_tree *t, int k)
{
    switch (t->kind) {
    case CAGD_SUM:
    case CAGD_PRODUCT:
    case CAGD_NEGATIVE:
        return 1;
    case CAGD_QUOTIENT:
    case CAGD_DERIVATIVE:
    case CAGD_AT:
        return k == 0;
    case CAGD_SUM_OVER:
    case CAGD_INTEGRAL:
        return k == 2;
    case CAGD_CASES:
        return k % 2 == 0;
    default:
        return 0;
    }
}

/* [a b c], the brackets being where the product begins and ends. */
static int is_in_square_brackets(const cagd_reader *r, const cagd_tree *t)
{
    int before = t->from - 1;
    while (before > 0 && strchr(" \n", r->text[before]) != NULL)
        before--;
    return before >= 0 && r->text[before] == '[' && cagd_next_is(r, "]");
}

static cagd_tree *different_shapes(cagd_reader *r, const cagd_tree *t, int a, int b)
{
    if (!cagd_is_matrix(a) && !cagd_is_matrix(b))
        return cagd_refuse_tree(r, t, "vectors of %d and of %d components", a, b);
    return cagd_refuse_tree(r, t, "%s beside %s", cagd_called(a), cagd_called(b));
}

/* Vectors side by side: only three in square brackets are something, their mixed product. */
static cagd_tree *side_by_side(cagd_reader *r, cagd_tree *t)
{
    int vectors = 0;
    for (int k = 0; k < t->count; k++)
        vectors += t->at[k]->dimension == OF_SPACE;
    if (vectors != OF_SPACE || t->count != OF_SPACE || !is_in_square_brackets(r, t))
        return cagd_refuse_tree(r, t, "two vectors side by side: write \\cdot or \\times between");
    t->kind = CAGD_MIXED;
    t->dimension = 0;
    return t;
}

static int takes_vectors(cagd_tree_kind kind)
{
    return kind == CAGD_DOT || kind == CAGD_CROSS || kind == CAGD_MIXED || kind == CAGD_NORM ||
           kind == CAGD_COMPONENT || kind == CAGD_MATRIX_PRODUCT || kind == CAGD_TRANSPOSED || kind == CAGD_INVERSE ||
           kind >= CAGD_RELATION;
}

/* The product with matrices among its factors, in their order. */
static cagd_tree *of_matrices(cagd_reader *r, cagd_tree *t)
{
    const cagd_tree *product = cagd_chain_of_matrices(r, t);
    if (product == NULL)
        return NULL;
    int from = t->from, to = t->to;
    *t = *product;
    t->from = from, t->to = to;
    return t;
}

cagd_tree *cagd_with_dimension(cagd_reader *r, cagd_tree *t)
{
    int vectors = 0, matrices = 0;
    if (t->kind == CAGD_NORM && (t->at[0]->dimension == 0 || cagd_is_matrix(t->at[0]->dimension)))
        return cagd_refuse_tree(r, t, "the length of what is no vector; of a number it is |a|");
    if (takes_vectors(t->kind))
        return t;
    for (int k = 0; k < t->count; k++) {
        int dimension = t->at[k]->dimension;
        matrices += cagd_is_matrix(dimension);
        if (dimension > 0 && !is_part(t, k))
            return cagd_refuse_tree(r, t->at[k], "a %s where a number is expected",
                                    cagd_is_matrix(dimension) ? "matrix" : "vector");
        if (dimension > 0 && t->dimension > 0 && dimension != t->dimension && t->kind != CAGD_PRODUCT)
            return different_shapes(r, t->at[k], t->dimension, dimension);
        t->dimension = dimension > 0 ? dimension : t->dimension;
        vectors += dimension > 0;
    }
    if (t->kind == CAGD_PRODUCT && vectors > 1)
        return matrices > 0 ? of_matrices(r, t) : side_by_side(r, t);
    for (int k = 0; (t->kind == CAGD_SUM || t->kind == CAGD_CASES) && vectors > 0 && k < t->count; k++)
        if (is_part(t, k) && t->at[k]->dimension == 0 && !is_zero(t->at[k]))
            return cagd_refuse_tree(r, t->at[k], "a number where a vector is expected");
    return t;
}

const cagd_tree *cagd_vector_product(cagd_reader *r, const char *sign, const cagd_tree *a, const cagd_tree *b)
{
    int cross = strcmp(sign, "\\times") == 0;
    if (!cross && (cagd_is_matrix(a->dimension) || cagd_is_matrix(b->dimension)))
        return cagd_matrix_product(r, a, b);
    if (a->dimension != b->dimension)
        return different_shapes(r, b, a->dimension, b->dimension);
    if (cross && a->dimension != OF_SPACE)
        return cagd_is_matrix(a->dimension)
                   ? cagd_refuse_tree(r, b, "a matrix where a vector is expected")
                   : cagd_refuse_tree(r, b, "the product a \\times b is of vectors with 3 components, not %d",
                                      a->dimension);
    cagd_tree *t = cagd_new_of(r, cross ? CAGD_CROSS : CAGD_DOT, a->from, 2, (const cagd_tree *[]){a, b});
    if (t != NULL)
        t->dimension = cross ? OF_SPACE : 0;
    return t;
}

const cagd_tree *cagd_read_point(cagd_reader *r, const cagd_tree *first, const char *close, int from)
{
    const cagd_tree *list[MOST_COMPONENTS] = {first};
    int count = 1;
    while (cagd_pass(r, ",")) {
        if (count == MOST_COMPONENTS)
            return cagd_refuse_token(r, "more than %d components", MOST_COMPONENTS);
        list[count] = cagd_read_sum(r);
        if (list[count++] == NULL)
            return NULL;
    }
    if (!cagd_expect(r, close, "the components"))
        return NULL;
    int vectors = 0;
    for (int k = 0; k < count; k++)
        vectors += list[k]->dimension == OF_SPACE;
    if (vectors == OF_SPACE && count == OF_SPACE)
        return cagd_new_of(r, CAGD_MIXED, from, count, list);
    cagd_tree *t = cagd_new_of(r, CAGD_POINT, from, count, list);
    if (t != NULL)
        t->dimension = count;
    return t;
}

/* Whether each factor has a space of TeX behind it: [x \; y \; z], [x \quad y]. */
static int has_spaces(const cagd_reader *r, const cagd_tree *t)
{
    for (int k = 0; k + 1 < t->count; k++) {
        int found = 0;
        for (int at = t->at[k]->to; at + 1 < t->at[k + 1]->from; at++)
            found |= r->text[at] == '\\' && strchr(";: q", r->text[at + 1]) != NULL;
        if (!found)
            return 0;
    }
    return 1;
}

const cagd_tree *cagd_in_square_brackets(cagd_reader *r, const cagd_tree *t)
{
    if (t->kind != CAGD_PRODUCT || !t->juxtaposed || t->dimension > 0 || t->count > MOST_COMPONENTS ||
        !has_spaces(r, t))
        return t;
    cagd_tree *point = cagd_new_of(r, CAGD_POINT, t->from, t->count, t->at);
    if (point != NULL)
        point->dimension = t->count;
    return point;
}

/* ---- relations ----------------------------------------------------------------------------------------- */

static const cagd_tree *chain(cagd_reader *r, int from, int count, const cagd_tree *const list[],
                              const cagd_relation relation[])
{
    cagd_tree *t = cagd_new_of(r, CAGD_RELATION, from, count, list);
    cagd_relation *kept = t != NULL ? cagd_region_array(count, 1, sizeof *kept) : NULL;
    if (kept == NULL)
        return NULL;
    memcpy(kept, relation, (size_t)(count - 1) * sizeof *kept);
    t->relation = kept;
    return t;
}

const cagd_tree *cagd_component_of(cagd_reader *r, const cagd_tree *t, int k)
{
    cagd_tree *c = cagd_new_of(r, CAGD_COMPONENT, t->from, 1, &t);
    if (c != NULL)
        c->order = k, c->to = t->to;
    return c;
}

/* a \ne b: the square of the length of a - b is not 0. */
static const cagd_tree *different(cagd_reader *r, int from, const cagd_tree *a, const cagd_tree *b)
{
    const cagd_tree *minus = cagd_new_of(r, CAGD_NEGATIVE, b->from, 1, &b);
    const cagd_tree *d = cagd_new_of(r, CAGD_SUM, from, 2, (const cagd_tree *[]){a, minus});
    const cagd_tree *side[2] = {cagd_new_of(r, CAGD_DOT, from, 2, (const cagd_tree *[]){d, d}),
                                cagd_tree_number(0, b->from, b->to)};
    return chain(r, from, 2, side, &(cagd_relation){CAGD_NOT_EQUAL});
}

const cagd_tree *cagd_relate(cagd_reader *r, int from, int count, const cagd_tree *const list[],
                             const cagd_relation relation[])
{
    const cagd_tree *part[CAGD_MOST_ROWS * CAGD_MOST_ROWS], *side[CAGD_MOST_CHILDREN];
    int dimension = 0;
    for (int k = 0; k < count; k++)
        dimension = dimension == 0 ? list[k]->dimension : dimension;
    if (dimension == 0)
        return chain(r, from, count, list, relation);
    for (int k = 0; k < count; k++)
        if (list[k]->dimension != dimension && !is_zero(list[k]))
            return list[k]->dimension == 0 ? cagd_refuse_tree(r, list[k], "a number where a vector is expected")
                                           : different_shapes(r, list[k], dimension, list[k]->dimension);
    if (count == 2 && relation[0] == CAGD_NOT_EQUAL && !cagd_is_matrix(dimension))
        return list[0]->dimension > 0 ? different(r, from, list[0], list[1]) : different(r, from, list[1], list[0]);
    if (count == 2 && relation[0] == CAGD_NOT_EQUAL) {
        const cagd_tree *same = cagd_relate(r, from, count, list, &(cagd_relation){CAGD_EQUAL});
        return same != NULL ? cagd_new_of(r, CAGD_NOT, from, 1, &same) : NULL;
    }
    for (int k = 0; k + 1 < count; k++)
        if (relation[k] != CAGD_EQUAL)
            return cagd_refuse_tree(r, list[k], "vectors are equal or not; none is less than another");
    for (int c = 0; c < cagd_components(dimension); c++) {
        for (int k = 0; k < count; k++)
            side[k] = cagd_component_of(r, list[k], c);
        part[c] = chain(r, from, count, side, relation);
    }
    return cagd_new_of(r, CAGD_ALL, from, cagd_components(dimension), part);
}
