#include "exact/expression/lift.h"

#include "exact/words.h"

#include <stdio.h>
#include <string.h>

struct lifting {
    cagd_scope *scope;
    cagd_lifted *out;
    int fails;
};

static cagd_tree *name_tree(const char *name, const cagd_tree *at)
{
    cagd_tree *t = cagd_tree_new(CAGD_NAME, at->from, at->to, 0);
    if (t != NULL)
        t->head = name;
    return t;
}

static cagd_tree *of_two(cagd_tree_kind kind, const cagd_tree *a, const cagd_tree *b)
{
    cagd_tree *t = a != NULL && b != NULL ? cagd_tree_new(kind, a->from, b->to, 2) : NULL;
    if (t != NULL)
        t->at[0] = a, t->at[1] = b;
    return t;
}

static const cagd_tree *related(const cagd_tree *a, cagd_relation relation, const cagd_tree *b)
{
    cagd_relation *r = cagd_region_array(1, 1, sizeof *r);
    cagd_tree *t = r != NULL ? of_two(CAGD_RELATION, a, b) : NULL;
    if (t != NULL)
        *r = relation, t->relation = r;
    return t;
}

/* Whether a name stands in it: the roots of numbers have values. */
static int has_names(const cagd_tree *t)
{
    int has = t->kind == CAGD_NAME;
    for (int k = 0; k < t->count && !has; k++)
        has = has_names(t->at[k]);
    return has;
}

static int is_liftable(const cagd_tree *t)
{
    return (t->kind == CAGD_NORM || (t->kind == CAGD_ROOT && t->count == 2 && t->at[1]->kind == CAGD_NUMBER &&
                                     cagd_equal_q(t->at[1]->number, from_int_q(2)))) &&
           has_names(t->at[0]);
}

/* The name for the root t; the same for the same root. */
static const cagd_tree *lifted(struct lifting *l, const cagd_tree *t, const cagd_tree *inner)
{
    cagd_lifted *out = l->out;
    int is_length = t->kind == CAGD_NORM;
    for (int k = 0; k < out->count; k++)
        if (out->is_length[k] == is_length && cagd_tree_equal(out->of[k], inner))
            return name_tree(out->name[k], t);
    char text[24];
    snprintf(text, sizeof text, "\\surd{%d}", out->count + 1);
    const char *name = out->count < CAGD_MOST_LIFTED ? cagd_text_of(text, (int)strlen(text)) : NULL;
    const cagd_tree *r = name != NULL ? name_tree(name, t) : NULL, *square = inner, *two, *zero;
    if (is_length)
        square = of_two(CAGD_DOT, inner, inner);
    two = cagd_tree_number(2, t->from, t->to), zero = cagd_tree_number(0, t->from, t->to);
    const cagd_tree *is = r != NULL ? related(of_two(CAGD_POWER, r, two), CAGD_EQUAL, square) : NULL;
    if (is == NULL || zero == NULL || !cagd_declare(l->scope, (cagd_variable){.head = name, .low = zero}) ||
        !cagd_suppose(l->scope, is)) {
        l->fails = 1;
        return t;
    }
    out->name[out->count] = name, out->of[out->count] = inner, out->is_length[out->count++] = is_length;
    return r;
}

/* Where letters are bound, or values are chosen by conditions, roots stay. */
static int is_entered(const cagd_tree *t)
{
    switch (t->kind) {
    case CAGD_SUM:
    case CAGD_PRODUCT:
    case CAGD_NEGATIVE:
    case CAGD_QUOTIENT:
    case CAGD_ROOT:
    case CAGD_ABSOLUTE:
    case CAGD_POINT:
    case CAGD_DOT:
    case CAGD_CROSS:
    case CAGD_NORM:
    case CAGD_RELATION:
    case CAGD_ALL:
    case CAGD_IMPLIES:
        return 1;
    default:
        return 0;
    }
}

static const cagd_tree *walk(struct lifting *l, const cagd_tree *t)
{
    int count = t->kind == CAGD_POWER ? 1 : is_entered(t) ? t->count : 0;
    cagd_tree *copy = NULL;
    for (int k = 0; k < count && !l->fails; k++) {
        const cagd_tree *one = walk(l, t->at[k]);
        if (one == t->at[k])
            continue;
        if (copy == NULL) {
            copy = cagd_tree_new(t->kind, t->from, t->to, t->count);
            const cagd_tree **at = copy != NULL ? copy->at : NULL;
            l->fails |= copy == NULL;
            if (copy == NULL)
                return t;
            *copy = *t, copy->at = at;
            memcpy(at, t->at, (size_t)t->count * sizeof *at);
        }
        copy->at[k] = one;
    }
    const cagd_tree *now = copy != NULL ? copy : t;
    return is_liftable(t) && !l->fails ? lifted(l, t, now->at[0]) : now;
}

const cagd_tree *cagd_with_roots_lifted(cagd_scope *scope, const cagd_tree *statement, cagd_lifted *out)
{
    struct lifting l = {scope, out, 0};
    *out = (cagd_lifted){0};
    const cagd_tree *t = walk(&l, statement);
    return l.fails || out->count == 0 ? NULL : t;
}

static int is_lifted(const cagd_lifted *lifted, const char *name)
{
    int is = 0;
    for (int k = 0; k < lifted->count && !is; k++)
        is = strcmp(lifted->name[k], name) == 0;
    return is;
}

void cagd_forget_lifted(cagd_finding *f, const cagd_lifted *lifted)
{
    int names = f->names, given = f->given;
    f->names = f->given = 0;
    for (int k = 0; k < names; k++)
        if (!is_lifted(lifted, f->name[k]))
            f->name[f->names++] = f->name[k];
    for (int k = 0; k < given; k++)
        if (!is_lifted(lifted, f->example[k].name))
            f->example[f->given++] = f->example[k];
}
