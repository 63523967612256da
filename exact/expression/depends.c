#include "exact/expression/depends.h"

#include <string.h>

static int uses(const cagd_scope *scope, const cagd_tree *t, const char *head, int depth)
{
    if (t == NULL || depth > 12)
        return t != NULL;
    if (t->head != NULL && strcmp(t->head, head) == 0)
        return t->kind != CAGD_EVERY_INDEX && t->kind != CAGD_FOR_ALL;
    if (t->times != NULL && uses(scope, t->times, head, depth))
        return 1;
    for (int k = 0; k < t->count; k++)
        if (uses(scope, t->at[k], head, depth))
            return 1;
    if (t->kind != CAGD_NAME)
        return 0;
    for (const cagd_definition *d = scope->definitions; d != NULL; d = d->next)
        if (d->body != NULL && strcmp(d->left->head, t->head) == 0 && !cagd_tree_has(d->left, head) &&
            (cagd_tree_has(d->body, t->head) ? cagd_tree_has(d->body, head) : uses(scope, d->body, head, depth + 1)))
            return 1;
    return 0;
}

int cagd_depends_on(const cagd_scope *scope, const cagd_tree *statement, const char *head)
{
    return uses(scope, statement, head, 0);
}

/* Whether the letter has a value, as r has behind r = 4, though it was declared before. */
int cagd_has_value(const cagd_scope *scope, const char *head)
{
    const cagd_definition *d = cagd_defined(scope, head);
    return d != NULL && d->left->count == 0 && d->when == NULL;
}

/* Whether a condition speaks of any name that the statement depends on, its index that means nothing left out: where none does, it takes
 * nothing from the first cases. */
int cagd_condition_speaks_of(const cagd_scope *scope, const cagd_tree *condition, const char *letter,
                             const cagd_tree *statement)
{
    if (condition->kind == CAGD_EVERY_INDEX)
        letter = condition->head;
    else if (condition->kind == CAGD_NAME && (letter == NULL || strcmp(letter, condition->head) != 0) &&
             uses(scope, statement, condition->head, 0))
        return 1;
    for (int k = 0; k < condition->count; k++)
        if (cagd_condition_speaks_of(scope, condition->at[k], letter, statement))
            return 1;
    return 0;
}

/* Whether the letter stands in the list of numbers of that variable. */
static int is_in_list(const cagd_variable *v, const char *head)
{
    for (int k = 0; k < v->listed_count; k++)
        if (cagd_tree_has(v->listed[k], head))
            return 1;
    return 0;
}

static int speaks_of(const cagd_variable *v, const char *letter)
{
    return (v->low != NULL && cagd_tree_has(v->low, letter)) || (v->high != NULL && cagd_tree_has(v->high, letter)) ||
           is_in_list(v, letter);
}

/* Those in whose ranges others stand come behind these. */
static void put_in_order(const cagd_variable *list[], int count)
{
    for (int k = 0; k < count; k++) {
        int next = k, waits = 1;
        for (int m = k; m < count && waits; m++) {
            waits = 0;
            for (int other = k; other < count; other++)
                waits |= other != m && speaks_of(list[m], list[other]->head);
            next = waits ? k : m;
        }
        const cagd_variable *v = list[next];
        for (int m = next; m > k; m--)
            list[m] = list[m - 1];
        list[k] = v;
    }
}

int cagd_whole_numbers(const cagd_scope *scope, const cagd_tree *statement, const cagd_variable *list[], int room)
{
    int count = 0;
    for (const cagd_variable *v = scope->variables; v != NULL; v = v->next) {
        int known = cagd_declared(scope, v->head) != v || cagd_has_value(scope, v->head),
            used = uses(scope, statement, v->head, 0);
        for (int k = 0; k < scope->condition_count; k++)
            used |= uses(scope, scope->conditions[k], v->head, 0);
        for (int k = 0; k < count; k++) /* or the range of one that is used */
            used |= speaks_of(list[k], v->head);
        for (const cagd_variable *w = scope->variables; w != NULL; w = w->next)
            used |= !w->whole && uses(scope, statement, w->head, 0) &&
                    ((w->low != NULL && cagd_tree_has(w->low, v->head)) ||
                     (w->high != NULL && cagd_tree_has(w->high, v->head)) ||
                     (w->when != NULL && cagd_tree_has(w->when, v->head) && !cagd_tree_has(w->left, v->head)));
        if (!v->whole || known || !used)
            continue;
        if (count == room)
            return -1;
        for (int k = count++; k > 0; k--)
            list[k] = list[k - 1];
        list[0] = v;
    }
    put_in_order(list, count);
    return count;
}
