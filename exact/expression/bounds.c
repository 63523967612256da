#include "exact/expression/bounds.h"

#include "exact/expression/depends.h"

#include <string.h>

static int is_plain(const cagd_scope *scope, const cagd_tree *t, int *names)
{
    int plain = t->kind == CAGD_NUMBER || t->kind == CAGD_SUM || t->kind == CAGD_PRODUCT || t->kind == CAGD_NEGATIVE ||
                t->kind == CAGD_QUOTIENT || t->kind == CAGD_POWER || t->kind == CAGD_RELATION;
    if (t->kind == CAGD_RELATION && t->count == 2 && t->at[0]->kind == CAGD_ABSOLUTE && t->relation[0] != CAGD_EQUAL)
        return is_plain(scope, t->at[0]->at[0], names) && is_plain(scope, t->at[1], names); /* |x| \le 1 */
    if (t->kind == CAGD_NAME)
        return ++*names, t->order == 0 && (cagd_defined(scope, t->head) == NULL || cagd_has_value(scope, t->head));
    for (int k = 0; k < t->count && plain; k++)
        plain = is_plain(scope, t->at[k], names);
    return plain;
}

int cagd_is_of_plain_names(const cagd_scope *scope, const cagd_tree *t)
{
    int names = 0;
    return is_plain(scope, t, &names) && names > 0;
}

/* Whether it has one value: numbers, whole numbers, and names that were defined by these alone, as knots u_i = i; `letters` has the indices of a
 * definition. */
static int is_constant(const cagd_scope *scope, const cagd_tree *t, const cagd_tree *letters, int depth)
{
    enum { DEEPEST = 8 };
    int is = t->kind == CAGD_NUMBER || t->kind == CAGD_SUM || t->kind == CAGD_PRODUCT || t->kind == CAGD_NEGATIVE ||
             t->kind == CAGD_QUOTIENT || t->kind == CAGD_POWER || t->kind == CAGD_ROOT || t->kind == CAGD_NAME ||
             t->kind == CAGD_BINOMIAL || t->kind == CAGD_FACTORIAL;
    if (t->kind == CAGD_NAME && t->count == 0) {
        const cagd_variable *v = cagd_declared(scope, t->head);
        if ((v != NULL && v->whole) || (letters != NULL && cagd_tree_has(letters, t->head)) ||
            (v == NULL && strcmp(t->head, "\\pi") == 0))
            return 1;
    }
    int defined = 0;
    for (const cagd_definition *d = scope->definitions; t->kind == CAGD_NAME && is && d != NULL; d = d->next)
        if (strcmp(d->left->head, t->head) == 0)
            defined = 1, is = depth < DEEPEST && d->left->arguments == 0 && d->body != NULL &&
                              is_constant(scope, d->body, d->left, depth + 1);
    is &= t->kind != CAGD_NAME || defined;
    for (int k = 0; k < t->count && is; k++)
        is = is_constant(scope, t->at[k], letters, depth);
    return is;
}

int cagd_is_constant(const cagd_scope *scope, const cagd_tree *t) { return is_constant(scope, t, NULL, 0); }

/* Two of the names u_i that do not depend on another one: of knots u_i <= u < u_{i+1} is a span. */
static int are_knots(const cagd_scope *scope, const cagd_tree *a, const cagd_tree *b, const char *head)
{
    return a->kind == CAGD_NAME && b->kind == CAGD_NAME && strcmp(a->head, b->head) == 0 && a->lower > 0 &&
           a->arguments == 0 && b->arguments == 0 && a->order == 0 && b->order == 0 && strcmp(a->head, head) != 0 &&
           !cagd_depends_on(scope, a, head) && !cagd_depends_on(scope, b, head);
}

/* A variable of which no other condition speaks. */
static int is_free(const cagd_scope *scope, const cagd_tree *t, const cagd_tree *premise)
{
    int is = t->kind == CAGD_NAME && t->arguments == 0 && t->order == 0 && cagd_defined(scope, t->head) == NULL &&
             (premise == NULL || !cagd_tree_has(premise, t->head));
    for (int k = 0; k < scope->condition_count && is; k++)
        is = scope->conditions[k]->kind == CAGD_EVERY_INDEX || !cagd_tree_has(scope->conditions[k], t->head);
    return is;
}

static int goes_up(cagd_relation r) { return r == CAGD_LESS || r == CAGD_LESS_OR_EQUAL; }
static int goes_down(cagd_relation r) { return r == CAGD_GREATER || r == CAGD_GREATER_OR_EQUAL; }

int cagd_is_range_of_name(const cagd_scope *scope, const cagd_tree *t, const cagd_tree *premise)
{
    if (t->kind != CAGD_RELATION || t->dimension > 0)
        return 0;
    if (t->count == 3)
        return is_free(scope, t->at[1], premise) &&
               ((is_constant(scope, t->at[0], NULL, 0) && is_constant(scope, t->at[2], NULL, 0)) ||
                are_knots(scope, t->at[0], t->at[2], t->at[1]->head)) &&
               ((goes_up(t->relation[0]) && goes_up(t->relation[1])) ||
                (goes_down(t->relation[0]) && goes_down(t->relation[1])));
    int which = t->count == 2 && is_free(scope, t->at[1], premise);
    return t->count == 2 && t->relation[0] != CAGD_EQUAL && is_free(scope, t->at[which], premise) &&
           is_constant(scope, t->at[1 - which], NULL, 0);
}

/* Whether an end of the range t, low <= v <= high or one of them, is a number outside of the bounds of v. */
static int is_beyond(const cagd_scope *scope, const cagd_tree *t)
{
    if (!cagd_is_range_of_name(scope, t, NULL))
        return 0;
    const int which = t->count == 3 || !is_free(scope, t->at[0], NULL);
    const cagd_variable *v = t->at[which]->count == 0 ? cagd_declared(scope, t->at[which]->head) : NULL;
    if (v == NULL || v->whole)
        return 0;
    cagd_num_q end, bound;
    for (int k = 0; k < t->count; k++) {
        if (k == which || !cagd_is_plain_number(t->at[k], &end))
            continue;
        const int is_low = (k < which) == goes_up(t->relation[k < which ? k : which]);
        const cagd_tree *of = is_low ? v->low : v->high;
        if (of != NULL && cagd_is_plain_number(of, &bound) &&
            (is_low ? cagd_compare_q(end, bound) < 0 : cagd_compare_q(end, bound) > 0))
            return 1;
    }
    return 0;
}

const cagd_tree *cagd_is_beyond_bounds(const cagd_scope *scope, const cagd_tree *statement)
{
    const int implies = statement->kind == CAGD_IMPLIES && statement->at[0]->from != statement->from;
    const cagd_tree *all = implies ? statement->at[0] : statement;
    if (implies && all->kind != CAGD_ALL)
        return is_beyond(scope, all) ? all : NULL;
    for (int k = !implies; (implies || (all->kind == CAGD_ALL && !all->juxtaposed)) && k < all->count; k++)
        if ((implies || all->at[k]->count == 3) && is_beyond(scope, all->at[k])) /* t >= -1 alone may be said */
            return all->at[k];
    return NULL;
}

/* A name that means nothing, and is none of the letters of `left`. */
static const cagd_tree *unknown_in(const cagd_scope *scope, const cagd_tree *t, const cagd_tree *left)
{
    const cagd_tree *found = NULL;
    if (t == NULL)
        return NULL;
    if (t->kind == CAGD_NAME && t->count == 0 && strcmp(t->head, "\\pi") != 0 &&
        cagd_declared(scope, t->head) == NULL && cagd_defined(scope, t->head) == NULL &&
        !(left != NULL && cagd_tree_has(left, t->head)))
        return t;
    for (int k = 0; k < t->count && found == NULL && t->kind != CAGD_SUM_OVER && t->kind != CAGD_PRODUCT_OVER; k++)
        found = unknown_in(scope, t->at[k], left);
    return found;
}

const cagd_tree *cagd_unknown_in_bounds(const cagd_scope *scope, const cagd_tree *statement, const cagd_variable **of)
{
    for (const cagd_variable *v = scope->variables; v != NULL; v = v->next) {
        const cagd_tree *t = unknown_in(scope, v->low, v->left);
        t = t == NULL ? unknown_in(scope, v->high, v->left) : t;
        t = t == NULL ? unknown_in(scope, v->when, v->left) : t;
        *of = v;
        if (t != NULL && cagd_declared(scope, v->head) == v && cagd_depends_on(scope, statement, v->head))
            return t;
    }
    return NULL;
}
