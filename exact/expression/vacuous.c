#include "exact/expression/vacuous.h"

#include <string.h>

/* Whether a relation follows from another one between the same sides. */
static int follows(cagd_relation known, cagd_relation r)
{
    switch (known) {
    case CAGD_EQUAL:
        return r == CAGD_EQUAL || r == CAGD_LESS_OR_EQUAL || r == CAGD_GREATER_OR_EQUAL;
    case CAGD_LESS:
        return r == CAGD_LESS || r == CAGD_LESS_OR_EQUAL || r == CAGD_NOT_EQUAL;
    case CAGD_GREATER:
        return r == CAGD_GREATER || r == CAGD_GREATER_OR_EQUAL || r == CAGD_NOT_EQUAL;
    default:
        return r == known;
    }
}

static cagd_relation turned(cagd_relation r)
{
    return r == CAGD_LESS               ? CAGD_GREATER
           : r == CAGD_GREATER          ? CAGD_LESS
           : r == CAGD_LESS_OR_EQUAL    ? CAGD_GREATER_OR_EQUAL
           : r == CAGD_GREATER_OR_EQUAL ? CAGD_LESS_OR_EQUAL
                                        : r;
}

/* A relation with two sides. */
struct link {
    const cagd_tree *a, *b;
    cagd_relation relation;
};

/* Whether "left known right" says the link already, perhaps the other way around. */
static int says(const cagd_tree *left, cagd_relation known, const cagd_tree *right, struct link l)
{
    return (cagd_tree_equal(left, l.a) && cagd_tree_equal(right, l.b) && follows(known, l.relation)) ||
           (cagd_tree_equal(left, l.b) && cagd_tree_equal(right, l.a) && follows(known, turned(l.relation)));
}

static int is_said_by(const cagd_tree *t, struct link l)
{
    int is = 0;
    for (int k = 0; t->kind == CAGD_ALL && k < t->count && !is; k++)
        is = is_said_by(t->at[k], l);
    for (int k = 0; t->kind == CAGD_RELATION && k + 1 < t->count && !is; k++)
        is = says(t->at[k], t->relation[k], t->at[k + 1], l);
    return is;
}

/* The name was declared with that bound. */
static int is_declared_so(const cagd_scope *scope, struct link l)
{
    for (int side = 0; side < 2; side++) {
        const cagd_tree *name = side ? l.b : l.a;
        const cagd_variable *v = name->kind == CAGD_NAME ? cagd_declared(scope, name->head) : NULL;
        if (v != NULL && v->low != NULL && says(name, v->low_open ? CAGD_GREATER : CAGD_GREATER_OR_EQUAL, v->low, l))
            return 1;
        if (v != NULL && v->high != NULL && says(name, v->high_open ? CAGD_LESS : CAGD_LESS_OR_EQUAL, v->high, l))
            return 1;
    }
    return 0;
}

static int is_defined_so(const cagd_scope *scope, struct link l)
{
    for (const cagd_definition *d = scope->definitions; d != NULL; d = d->next)
        if (d->when == NULL && says(d->left, CAGD_EQUAL, d->body, l))
            return 1;
    return 0;
}

static int is_empty_link(const cagd_scope *scope, const cagd_tree *premise, struct link l)
{
    int is = cagd_tree_equal(l.a, l.b) || (premise != NULL && is_said_by(premise, l)) || is_declared_so(scope, l) ||
             is_defined_so(scope, l);
    for (int k = 0; k < scope->condition_count && !is; k++)
        is = is_said_by(scope->conditions[k], l);
    return is;
}

static int is_vacuous(const cagd_scope *scope, const cagd_tree *t, const cagd_tree *premise)
{
    int is = 1;
    switch (t->kind) {
    case CAGD_RELATION:
        for (int k = 0; k + 1 < t->count && is; k++)
            is = is_empty_link(scope, premise, (struct link){t->at[k], t->at[k + 1], t->relation[k]});
        return is;
    case CAGD_ALL:
        for (int k = 0; k < t->count && is; k++)
            is = is_vacuous(scope, t->at[k], premise);
        return is;
    case CAGD_IMPLIES:
        return is_vacuous(scope, t->at[1], t->at[0]);
    case CAGD_IFF:
        return cagd_tree_equal(t->at[0], t->at[1]);
    default:
        return 0;
    }
}

int cagd_is_vacuous(const cagd_scope *scope, const cagd_tree *statement) { return is_vacuous(scope, statement, NULL); }
