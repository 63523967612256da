/* read_restrict.c -- what a list of ranges says of some indices alone.
 *
 *     a_i \ge 0, i = 0, 1, 2      a_i = 0, i = 0..4 \text{ even}      a_{ij} \ge 0, i < j      a_i \in [0,1], 0 \le i \le 2
 *
 * Bounds and values are those of the indices of which the list speaks, wherever in the list it does. */
#include "exact/expression/depends.h"
#include "exact/expression/reader.h"

#include <string.h>

/* What is said there and was not said before. */
struct said {
    cagd_reader *reader;
    cagd_scope *scope;
    const cagd_scope *before;
    const cagd_tree *left; /* the name of which it is said */
};

static int is_letter(const cagd_tree *t) { return t->kind == CAGD_NAME && t->count == 0; }

/* Whether all names in t are letters of the indices, whole numbers or letters with a value, and one is such a letter. */
static int is_about_indices(const struct said *s, const cagd_tree *t, int *has_letter)
{
    if (t->kind == CAGD_EVERY_INDEX || t->kind == CAGD_FOR_ALL || t->kind == CAGD_EXISTS)
        return 0;
    int is = t->kind != CAGD_NAME || t->count == 0;
    for (int k = 0; is && is_letter(t) && k < s->left->lower + s->left->upper; k++)
        if (is_letter(s->left->at[k]) && strcmp(s->left->at[k]->head, t->head) == 0)
            return *has_letter = 1;
    const cagd_variable *v = is_letter(t) ? cagd_declared(s->scope, t->head) : NULL;
    is &= t->kind != CAGD_NAME || (v != NULL && v->whole) || cagd_has_value(s->scope, t->head);
    for (int k = 0; is && k < t->count; k++)
        is = is_about_indices(s, t->at[k], has_letter);
    return is;
}

/* low <= letter <= high, of the ends that there are. */
static const cagd_tree *is_between(const struct said *s, const cagd_tree *letter, const cagd_variable *v)
{
    const cagd_relation up[2] = {v->low_open ? CAGD_LESS : CAGD_LESS_OR_EQUAL,
                                 v->high_open ? CAGD_LESS : CAGD_LESS_OR_EQUAL};
    const cagd_tree *list[3] = {v->low, letter, v->high};
    if (v->low == NULL)
        return cagd_relate(s->reader, letter->from, 2, list + 1, up + 1);
    return cagd_relate(s->reader, letter->from, v->high != NULL ? 3 : 2, list, up);
}

/* What the list says of that letter by a range or by bounds; NULL where it does not. */
static const cagd_tree *range_of_letter(const struct said *s, const cagd_tree *letter)
{
    const cagd_variable *v = cagd_declared(s->scope, letter->head);
    if (v == NULL || v == cagd_declared(s->before, letter->head) || (v->low == NULL && v->high == NULL))
        return NULL;
    if (!v->whole || v->low_open || v->high_open)
        return is_between(s, letter, v);
    cagd_list list = {v->low, v->high, v->step > 1 ? v->step : 1, v->listed, v->listed_count, 1};
    return cagd_is_in_list(s->reader, letter, &list);
}

/* For which indices it is said: 1 and *when, which is NULL where for all; 0 and the error. */
static int when_said(const struct said *s, const cagd_tree **when)
{
    const cagd_tree *part[CAGD_MOST_CHILDREN];
    int count = 0;
    for (int k = 0; k < s->left->lower + s->left->upper; k++) {
        const cagd_tree *one = is_letter(s->left->at[k]) ? range_of_letter(s, s->left->at[k]) : NULL;
        if (s->reader->error->message[0] != '\0')
            return 0;
        if (one != NULL)
            part[count++] = one;
    }
    for (int k = s->before->condition_count; k < s->scope->condition_count && count < CAGD_MOST_CHILDREN; k++) {
        int has_letter = 0;
        if (is_about_indices(s, s->scope->conditions[k], &has_letter) && has_letter)
            part[count++] = s->scope->conditions[k];
    }
    if (count == CAGD_MOST_CHILDREN)
        return cagd_refuse_tree(s->reader, s->left, "more than %d conditions", CAGD_MOST_CHILDREN - 1) != NULL;
    *when = count == 0 ? NULL : count == 1 ? part[0] : cagd_new_of(s->reader, CAGD_ALL, s->left->from, count, part);
    return count == 0 || *when != NULL;
}

/* The ends of the range of the only index, where they are numbers and nothing else is said of it. */
static void find_ends(const struct said *s, cagd_variable *v)
{
    const cagd_tree *index = v->left->lower == 1 && v->left->upper == 0 ? v->left->at[0] : NULL;
    const cagd_variable *i = index != NULL && is_letter(index) ? cagd_declared(s->scope, index->head) : NULL;
    v->some = v->when != NULL && v->when->kind == CAGD_RELATION && i != NULL && i->whole && i->high != NULL &&
              !i->low_open && !i->high_open && i->listed == NULL && i->step <= 1 &&
              cagd_is_whole_in_long(i->low, &v->first) && cagd_is_whole_in_long(i->high, &v->last);
}

static int has_bounds(const cagd_variable *v) { return v->low != NULL || v->high != NULL; }
static int is_of_all(const cagd_variable *v)
{
    return v->left != NULL && v->left->count > 0 && strcmp(v->left->head, v->head) == 0;
}
static int is_one(const cagd_variable *v) { return v->left != NULL && v->left->count > 0 && !is_of_all(v); }

/* Whether a bound of v is that of w, an earlier declaration. */
static int inherits(const cagd_variable *v, const cagd_variable *w)
{
    return (v->low != NULL && v->low == w->low) || (v->high != NULL && v->high == w->high);
}

static int refuse_two(cagd_reader *r, const cagd_variable *v)
{
    return cagd_refuse_tree(r, v->left,
                            "bounds of %s for some indices and for others: of which are these? write those of each "
                            "alone",
                            cagd_spelled(v->left->head)) != NULL;
}

/* Bounds for some indices, and earlier ones for others: they do not go together where an index can be of both. */
static int fits_earlier(const struct said *s, const cagd_variable *v, int is_in_list)
{
    for (const cagd_variable *w = v->next; w != NULL; w = w->next) {
        is_in_list &= w != s->before->variables;
        if (!is_of_all(w) || strcmp(w->left->head, v->left->head) != 0 || !has_bounds(w))
            continue;
        if (is_one(v)) {
            long index;
            int is_within = w->some && cagd_is_whole_in_long(v->left->at[0], &index)
                                ? w->first <= index && index <= w->last
                                : w->when == NULL;
            return is_within || (w->some && !inherits(v, w)) || refuse_two(s->reader, v);
        }
        int same = v->when == NULL ? w->when == NULL : w->when != NULL && cagd_tree_equal(v->when, w->when);
        int apart = v->some && w->some && (v->last < w->first || w->last < v->first) && !inherits(v, w);
        if (!same && !apart && (w->when != NULL || (is_in_list && inherits(v, w))))
            return refuse_two(s->reader, v);
    }
    return 1;
}

/* Whether an index has a range that was told before this list, so that all indices can be meant or those alone. */
static const cagd_tree *has_earlier_range(const struct said *s)
{
    for (int k = 0; k < s->left->lower + s->left->upper; k++) {
        const cagd_tree *letter = s->left->at[k];
        const cagd_variable *v = is_letter(letter) ? cagd_declared(s->before, letter->head) : NULL;
        if (v != NULL && v->whole && v->high != NULL && v == cagd_declared(s->scope, letter->head) &&
            !cagd_is_called_as_last(letter->head) && !cagd_has_value(s->scope, letter->head))
            return letter;
    }
    return NULL;
}

static int fits_earlier_range(struct said *s, const cagd_variable *v)
{
    s->left = v->left;
    const cagd_tree *letter = is_of_all(v) && v->when == NULL ? has_earlier_range(s) : NULL;
    return letter == NULL ||
           cagd_refuse_tree(s->reader, v->left,
                            "is it said of all %s, or of those in the range of %s that was told before? write that "
                            "range behind it, or take another letter",
                            cagd_spelled(v->left->head), letter->head) != NULL;
}

static int restrict_values(struct said *s)
{
    int known = 0;
    for (const cagd_definition *d = s->before->definitions; d != NULL; d = d->next)
        known++;
    for (cagd_definition *d = s->scope->definitions; d != NULL; d = d->next, known--) {
        const cagd_tree *when, *given = d->when;
        s->left = d->left;
        if (known > 0 || d->left->count == 0 || d->left->arguments > 0)
            continue;
        if (!when_said(s, &when))
            return 0;
        d->when = when == NULL || given == NULL
                      ? (when != NULL ? when : given)
                      : cagd_new_of(s->reader, CAGD_ALL, d->left->from, 2, (const cagd_tree *[]){given, when});
    }
    return 1;
}

int cagd_restrict_to_ranges(cagd_reader *r, cagd_scope *scope, const cagd_scope *before)
{
    struct said s = {r, scope, before, NULL};
    for (const cagd_variable *v = scope->variables; v != NULL && v != before->variables; v = v->next) {
        cagd_variable *own = (cagd_variable *)v; /* it was declared by this list */
        s.left = v->left;
        if (!is_of_all(v) || !has_bounds(v))
            continue;
        if (!when_said(&s, &own->when))
            return 0;
        find_ends(&s, own);
    }
    for (const cagd_variable *v = scope->variables; v != NULL && v != before->variables; v = v->next)
        if ((is_of_all(v) || is_one(v)) && has_bounds(v) && (!fits_earlier(&s, v, 1) || !fits_earlier_range(&s, v)))
            return 0;
    return restrict_values(&s);
}
