#include "exact/expression/tree.h"

#include "exact/words.h"

#include <string.h>

cagd_tree *cagd_tree_new(cagd_tree_kind kind, int from, int to, int count)
{
    cagd_tree *t = region_bytes(sizeof *t);
    const cagd_tree **at = cagd_region_array(count, 1, sizeof *at);
    if (t == NULL || at == NULL)
        return NULL;
    memset(at, 0, (size_t)count * sizeof *at);
    *t = (cagd_tree){.kind = kind, .from = from, .to = to, .count = count, .at = at};
    return t;
}

cagd_tree *cagd_tree_number(long value, int from, int to)
{
    cagd_tree *t = cagd_tree_new(CAGD_NUMBER, from, to, 0);
    if (t != NULL)
        t->number = from_int_q(value);
    return t;
}

int cagd_tree_has(const cagd_tree *t, const char *head)
{
    if ((t->head != NULL && strcmp(t->head, head) == 0) || (t->times != NULL && cagd_tree_has(t->times, head)))
        return 1;
    for (int k = 0; k < t->count; k++)
        if (cagd_tree_has(t->at[k], head))
            return 1;
    return 0;
}

int cagd_tree_equal(const cagd_tree *a, const cagd_tree *b)
{
    if (a->kind != b->kind || a->count != b->count || a->order != b->order || a->lower != b->lower ||
        a->upper != b->upper || (a->head == NULL) != (b->head == NULL) ||
        (a->head != NULL && strcmp(a->head, b->head) != 0) ||
        (a->kind == CAGD_NUMBER && !cagd_equal_q(a->number, b->number)) || (a->times == NULL) != (b->times == NULL) ||
        (a->times != NULL && !cagd_tree_equal(a->times, b->times)))
        return 0;
    for (int k = 0; a->kind == CAGD_RELATION && k + 1 < a->count; k++)
        if (a->relation[k] != b->relation[k])
            return 0;
    for (int k = 0; k < a->count; k++)
        if (!cagd_tree_equal(a->at[k], b->at[k]))
            return 0;
    return 1;
}

const cagd_tree *cagd_tree_with(const cagd_tree *t, const char *letter, const cagd_tree *other)
{
    if (t == NULL || other == NULL || !cagd_tree_has(t, letter))
        return t;
    if (t->kind == CAGD_NAME && t->count == 0 && strcmp(t->head, letter) == 0)
        return other;
    cagd_tree *copy = cagd_tree_new(t->kind, t->from, t->to, t->count);
    if (copy == NULL)
        return t;
    const cagd_tree **at = copy->at;
    *copy = *t, copy->at = at;
    for (int k = 0; k < t->count; k++)
        at[k] = cagd_tree_with(t->at[k], letter, other);
    return copy;
}

int cagd_same_index(const cagd_tree *left, int k)
{
    for (int m = 0; left->at[k]->kind == CAGD_NAME && m < k; m++)
        if (left->at[m]->kind == CAGD_NAME && strcmp(left->at[m]->head, left->at[k]->head) == 0)
            return m;
    return -1;
}
