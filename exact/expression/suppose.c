#include "exact/expression/suppose.h"

#include "exact/expression/cell.h"
#include "exact/expression/tie.h"
#include "exact/record/trace.h"
#include "exact/words.h"

#include <stdlib.h>
#include <string.h>

/* ---- one condition ------------------------------------------------------------------------------------- */

/* a relation b becomes known: 1, or it was; 0: it is false; -1: it cannot be. */
static int limit(cagd_context *c, cagd_value a, cagd_relation relation, cagd_value b)
{
    cagd_trace_pause();
    int is = cagd_compare_values(c, a, relation, b);
    cagd_trace_resume();
    if (is >= 0 || region_faults != 0)
        return region_faults != 0 ? -1 : is;
    cagd_value d = cagd_value_sub(a, b);
    if (relation == CAGD_EQUAL && !cagd_is_linear(d.f) && !c->untied) {
        int is_tied = cagd_tie(c, d.f);
        c->ties += is_tied != 0;
        if (is_tied != 0)
            c->split = NULL, c->has_cut = 0;
        return is_tied == 0 ? -1 : is_tied;
    }
    if (relation == CAGD_NOT_EQUAL || !cagd_is_linear(d.f))
        return -1;
    int less = relation == CAGD_LESS || relation == CAGD_LESS_OR_EQUAL;
    int known = relation == CAGD_EQUAL
                    ? cagd_solve_in_cell(c, d.f)
                    : cagd_limit_cell(c, less ? neg_f(d.f) : d.f, relation == CAGD_LESS || relation == CAGD_GREATER);
    if (!known)
        return -1;
    c->split = NULL, c->has_cut = 0; /* what was to be cut there is known now */
    return 1;
}

enum { MOST_SUPPOSED = 1000 };

static int suppose(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    int result = 1;
    if (t->kind == CAGD_ALL) {
        for (int k = 0; k < t->count && result > 0; k++)
            result = suppose(c, t->at[k], f);
        return result;
    }
    if (t->kind == CAGD_FOR_ALL) {
        long low, high;
        cagd_value first = cagd_evaluate_in(c, t->at[0], f), last = cagd_evaluate_in(c, t->at[1], f);
        if (region_faults != 0 || !cagd_value_is_whole(first, &low) || !cagd_value_is_whole(last, &high) ||
            high - low > MOST_SUPPOSED)
            return -1;
        for (long k = low; k <= high && result > 0; k++) {
            cagd_frame inner = {t->head, cagd_value_int(k), f};
            result = suppose(c, t->at[2], &inner);
        }
        return result;
    }
    if (t->kind != CAGD_RELATION)
        return cagd_truth_in(c, t, f);
    for (int k = 0; k + 1 < t->count && result > 0; k++) { /* an equality changes values: both anew */
        cagd_value left = cagd_evaluate_in(c, t->at[k], f), right = cagd_evaluate_in(c, t->at[k + 1], f);
        result = region_faults == 0 ? limit(c, left, t->relation[k], right) : -1;
    }
    return result;
}

int cagd_suppose_conditions(cagd_context *c)
{
    for (int k = 0; k <= c->scope->condition_count; k++) {
        const cagd_tree *t = k < c->scope->condition_count ? c->scope->conditions[k] : c->premise;
        if (t == NULL)
            continue;
        int result = t->kind == CAGD_EVERY_INDEX ? 1 : suppose(c, t, NULL);
        if (region_faults & (FAULT_CROWDED | FAULT_MEMORY))
            return 1;
        if (result < 0 && (c->split != NULL || c->has_cut || c->rooted != NULL)) {
            region_faults = 0;
            return -1;
        }
        if (result < 0) { /* not used: what holds, holds without it */
            region_faults = 0;
            c->trouble = NULL;
            c->missing++;
        }
        if (result == 0)
            return 0;
    }
    return 1;
}

/* ---- for every index ----------------------------------------------------------------------------------- */

/* The index of the name "u_3", "u_{12}", which begins with that head; 0 where it is another name. */
static int index_of(const char *key, const char *head, long *index)
{
    size_t n = strlen(head);
    char *end;
    if (strncmp(key, head, n) != 0)
        return 0;
    key += n;
    int braces = *key == '{';
    key += braces;
    *index = strtol(key, &end, 10);
    return end != key && strcmp(end, braces ? "}" : "") == 0;
}

static void take_index(long index, long *low, long *high)
{
    *low = index < *low ? index : *low;
    *high = index > *high ? index : *high;
}

/* The index of u_0 = 0, and of u_n = 1, where n has a value. */
static int index_of_definition(cagd_context *c, const cagd_definition *d, long *index)
{
    const cagd_tree *at = d->left->at[0], *when = d->when;
    if (at->kind == CAGD_NUMBER)
        return cagd_value_is_whole(cagd_value_q(at->number), index);
    if (at->kind != CAGD_NAME || when == NULL || when->kind != CAGD_RELATION || when->count != 2 ||
        when->relation[0] != CAGD_EQUAL || when->at[0]->kind != CAGD_NAME || strcmp(when->at[0]->head, at->head) != 0)
        return 0;
    const char *trouble = c->trouble;
    const cagd_tree *where = c->where;
    const unsigned faults = region_faults;
    region_faults = 0;
    cagd_value v = cagd_evaluate(c, when->at[1]);
    int is = region_faults == 0 && cagd_value_is_whole(v, index);
    region_faults = faults | (region_faults & (FAULT_MEMORY | FAULT_CROWDED));
    c->trouble = trouble, c->where = where;
    return is;
}

/* The least and the greatest index that any name of the tree has, of those that were met, and of those that have values of their own, u_0 = 0. */
static void find_range(cagd_context *c, const cagd_tree *t, long *low, long *high)
{
    for (int k = 0; t->kind == CAGD_NAME && t->lower == 1 && k < c->count; k++) {
        long index;
        if (!c->binding[k].near && index_of(c->binding[k].key, t->head, &index))
            take_index(index, low, high);
    }
    for (const cagd_definition *d = c->scope->definitions; t->kind == CAGD_NAME && t->lower == 1 && d != NULL;
         d = d->next) {
        long index;
        if (strcmp(d->left->head, t->head) == 0 && d->left->count == 1 && index_of_definition(c, d, &index))
            take_index(index, low, high);
    }
    for (const cagd_variable *v = c->scope->variables; t->kind == CAGD_NAME && t->lower == 1 && v != NULL;
         v = v->next) { /* and of those alone of which bounds are known, t_0 \ge 0 */
        long index;
        if (v->left != NULL && v->left->count == 1 && strcmp(v->left->head, t->head) == 0 &&
            (v->low != NULL || v->high != NULL) && v->left->at[0]->kind == CAGD_NUMBER &&
            cagd_value_is_whole(cagd_value_q(v->left->at[0]->number), &index))
            take_index(index, low, high);
    }
    for (int k = 0; k < t->count; k++)
        find_range(c, t->at[k], low, high);
}

/* Whether the names of the tree, the letter having a value, have indices from low to high. */
static int is_within(cagd_context *c, const cagd_tree *t, const cagd_frame *f, long low, long high)
{
    if (t->kind == CAGD_NAME && t->lower == 1) {
        long index;
        cagd_value v = cagd_evaluate_in(c, t->at[0], f);
        if (region_faults != 0 || !cagd_value_is_whole(v, &index) || index < low || index > high)
            return 0;
    }
    for (int k = 0; k < t->count; k++)
        if (!is_within(c, t->at[k], f, low, high))
            return 0;
    return 1;
}

enum { FARTHEST = 16 }; /* how far indices of a condition are from its letter */

typedef int answer_of(cagd_context *, const cagd_tree *, const cagd_frame *);

/* The condition t for every value of its letter with which it speaks of names from the first to the last; the least answer. */
static int for_every_value(cagd_context *c, const char *letter, const cagd_tree *t, long low, long high,
                           answer_of *each)
{
    int result = 1;
    for (long k = low - FARTHEST; k <= high + FARTHEST && result > 0; k++) {
        cagd_frame f = {letter, cagd_value_int(k), NULL};
        if (is_within(c, t, &f, low, high))
            result = each(c, t, &f);
    }
    return result;
}

/* Of a chain, 0 \le u_i \le u_{i+1}, each relation by itself: one of them may speak of fewer names. */
static int for_every_index(cagd_context *c, const cagd_tree *t, answer_of *each)
{
    long low = FARTHEST * 1000, high = -low;
    const cagd_tree *said = t->at[0];
    int result = 1;
    find_range(c, said, &low, &high);
    if (said->kind != CAGD_RELATION)
        return for_every_value(c, t->head, said, low, high, each);
    for (int k = 0; k + 1 < said->count && result > 0; k++) {
        cagd_tree *link = cagd_tree_new(CAGD_RELATION, said->from, said->to, 2);
        if (link == NULL)
            return -1;
        link->at[0] = said->at[k], link->at[1] = said->at[k + 1], link->relation = said->relation + k;
        result = for_every_value(c, t->head, link, low, high, each);
    }
    return result;
}

static int suppose_or_leave(cagd_context *c, const cagd_tree *t, const cagd_frame *f)
{
    int result = suppose(c, t, f);
    if (result == 0)
        c->is_empty = 1;
    return result < 0 ? 1 : result;
}

void cagd_suppose_for_names(cagd_context *c)
{
    const int is_new = c->supposed < c->count; /* a name was met */
    for (int k = 0; k < c->scope->condition_count && is_new; k++) {
        const cagd_tree *t = c->scope->conditions[k];
        const char *split = c->split;
        int has_cut = c->has_cut;
        if (t->kind != CAGD_EVERY_INDEX || region_faults != 0)
            continue;
        int count = c->count, untied = c->untied;
        c->supposed = CAGD_MOST_UNKNOWNS; /* conditions are compared, too */
        c->untied = 1;                    /* values that have these names are known already               */
        for_every_index(c, t, suppose_or_leave);
        c->supposed = count, c->untied = untied;
        c->split = split, c->has_cut = has_cut;
        region_faults &= FAULT_CROWDED | FAULT_MEMORY;
    }
    c->supposed = c->count;
}

static int truth_of(cagd_context *c, const cagd_tree *t, const cagd_frame *f) { return cagd_truth_in(c, t, f); }

int cagd_conditions_hold(cagd_context *c)
{
    int is = c->premise != NULL ? cagd_truth(c, c->premise) : 1;
    for (int k = 0; k < c->scope->condition_count && is == 1; k++) {
        const cagd_tree *t = c->scope->conditions[k];
        is = t->kind == CAGD_EVERY_INDEX ? for_every_index(c, t, truth_of) : cagd_truth(c, t);
    }
    return is;
}
