#include "exact/expression/change.h"

#include "exact/words.h"

static cagd_tree *copy_of(const cagd_tree *t)
{
    cagd_tree *copy = cagd_tree_new(t->kind, t->from, t->to, t->count);
    if (copy == NULL)
        return NULL;
    const cagd_tree **at = copy->at;
    *copy = *t;
    copy->at = at;
    for (int k = 0; k < t->count; k++)
        at[k] = t->at[k];
    return copy;
}

static const cagd_tree *with_child(const cagd_tree *t, int k, const cagd_tree *child)
{
    cagd_tree *copy = child != NULL ? copy_of(t) : NULL;
    if (copy != NULL)
        copy->at[k] = child;
    return copy;
}

static const cagd_tree *one_more(const cagd_tree *t)
{
    cagd_tree *sum = cagd_tree_new(CAGD_SUM, t->from, t->to, 2);
    if (sum == NULL)
        return NULL;
    sum->at[0] = t;
    sum->at[1] = cagd_tree_number(1, t->from, t->to);
    return sum->at[1] != NULL ? sum : NULL;
}

static const cagd_tree *negative(const cagd_tree *t)
{
    if (t->kind == CAGD_NEGATIVE)
        return t->at[0];
    cagd_tree *minus = cagd_tree_new(CAGD_NEGATIVE, t->from, t->to, 1);
    if (minus != NULL)
        minus->at[0] = t;
    return minus;
}

static const cagd_tree *other_direction(const cagd_tree *t, int k)
{
    static const cagd_relation other[] = {CAGD_NOT_EQUAL,        CAGD_EQUAL, CAGD_GREATER,
                                          CAGD_GREATER_OR_EQUAL, CAGD_LESS,  CAGD_LESS_OR_EQUAL};
    cagd_tree *copy = copy_of(t);
    cagd_relation *relation = cagd_region_array(t->count, 1, sizeof *relation);
    if (copy == NULL || relation == NULL)
        return NULL;
    for (int m = 0; m + 1 < t->count; m++)
        relation[m] = m == k ? other[t->relation[m]] : t->relation[m];
    copy->relation = relation;
    return copy;
}

/* Whether the child is a value that can be 1 more. */
static int is_index(const cagd_tree *t, int k)
{
    switch (t->kind) {
    case CAGD_NAME:
        return k < t->lower + t->upper;
    case CAGD_SUM_OVER:
    case CAGD_PRODUCT_OVER:
    case CAGD_MAXIMUM_OVER:
    case CAGD_MINIMUM_OVER:
        return k < 2;
    case CAGD_POWER:
    case CAGD_AT:
        return k == 1;
    case CAGD_BINOMIAL:
        return 1;
    default:
        return 0;
    }
}

/* The change at t or below it when *which is 0 there; *which counts down. */
static const cagd_tree *changed(const cagd_tree *t, int *which)
{
    if (t->kind == CAGD_NUMBER && (*which)-- == 0)
        return one_more(t);
    for (int k = 0; t->kind == CAGD_RELATION && k + 1 < t->count; k++)
        if (t->relation[k] != CAGD_EQUAL && (*which)-- == 0)
            return other_direction(t, k);
    for (int k = 0; k < t->count; k++) {
        const cagd_tree *child = t->at[k];
        int sign = t->kind == CAGD_SUM || (t->kind == CAGD_RELATION && child->kind == CAGD_NEGATIVE),
            index = is_index(t, k) && child->kind != CAGD_NUMBER;
        if (sign && (*which)-- == 0)
            return with_child(t, k, negative(child));
        if (index && (*which)-- == 0)
            return with_child(t, k, one_more(child));
        const cagd_tree *inside = changed(child, which);
        if (inside != NULL)
            return with_child(t, k, inside);
    }
    return NULL;
}

static const cagd_tree *twice(const cagd_tree *t)
{
    cagd_tree *product = cagd_tree_new(CAGD_PRODUCT, t->from, t->to, 2);
    if (product == NULL)
        return NULL;
    product->at[0] = cagd_tree_number(2, t->from, t->to);
    product->at[1] = t;
    return product->at[0] != NULL ? product : NULL;
}

/* A name at t or below it, not in an index, with 1 added; in an angle, which is no number, twice. */
static const cagd_tree *with_changed_name(const cagd_tree *t, int in_angle, int *which)
{
    if (t->kind == CAGD_NAME && (*which)-- == 0)
        return in_angle ? twice(t) : one_more(t);
    in_angle |= t->kind == CAGD_SINE || t->kind == CAGD_COSINE;
    for (int k = t->kind == CAGD_NAME ? t->count : 0; k < t->count; k++) {
        const cagd_tree *inside = with_changed_name(t->at[k], in_angle, which);
        if (inside != NULL)
            return with_child(t, k, inside);
    }
    return NULL;
}

const cagd_tree *cagd_changed(const cagd_tree *t, int which)
{
    int first = 0, number = which;
    const cagd_tree *one = changed(t, &number);
    return one != NULL || changed(t, &first) != NULL ? one : with_changed_name(t, 0, &which);
}
