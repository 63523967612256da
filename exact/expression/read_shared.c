/* read_shared.c -- bounds that several names have together: 0 \le u, v \le 1, and x, y > 0.
 *
 * Such a list becomes what it says, a relation for each name with commas between, before it is read: 0 \le u \le 1, 0 \le v \le 1. */
#include "exact/expression/reader.h"
#include "exact/words.h"

#include <string.h>

enum { MOST_NAMES = 16 };

struct part {
    const cagd_token *from, *to;
};

static int is_order(const cagd_reader *r, const cagd_token *t)
{
    cagd_relation relation;
    cagd_reader at = *r;
    at.token = t;
    return cagd_relation_next(&at, &relation) && relation != CAGD_EQUAL && relation != CAGD_NOT_EQUAL;
}

static int goes_up(const cagd_token *t) { return t->word[0] == '<' || strcmp(t->word, "\\le") == 0; }

/* Where the value ends that begins at t: at a relation, a comma, a word, or at the end of a bracket or of everything. */
static const cagd_token *behind_value(const cagd_reader *r, const cagd_token *t)
{
    static const char *const ends[] = {",",           ";",     "=",     "\\ne",   "\\in", "\\text", "\\Rightarrow",
                                       "\\Leftarrow", "\\iff", "\\lor", "\\land", "&",    "\\\\",   "\\dots",
                                       "\\forall",    "."};
    for (int depth = 0; t->kind != CAGD_TOKEN_END; t++) {
        int is_end = is_order(r, t);
        for (size_t k = 0; k < sizeof ends / sizeof *ends && !is_end; k++)
            is_end = strcmp(t->word, ends[k]) == 0;
        depth += (strchr("({[", t->word[0]) != NULL) - (strchr(")}]", t->word[0]) != NULL);
        if (depth < 0 || (depth == 0 && is_end))
            break;
    }
    return t;
}

/* Whether it is a number: no name, but \pi, whole numbers and what has a value. */
static int is_number(const cagd_reader *r, struct part p)
{
    for (const cagd_token *t = p.from; t < p.to; t++) {
        const cagd_variable *v = t->kind == CAGD_TOKEN_LETTER ? cagd_declared(r->scope, t->word) : NULL;
        const cagd_definition *d = t->kind == CAGD_TOKEN_LETTER ? cagd_defined(r->scope, t->word) : NULL;
        if (t->kind == CAGD_TOKEN_LETTER && strcmp(t->word, "\\pi") != 0 && (v == NULL || !v->whole) &&
            (d == NULL || d->left->count > 0) && !cagd_is_bound(r, t->word))
            return 0;
    }
    return p.from < p.to;
}

/* A name by itself from t on, or nothing. */
static struct part name_at(const cagd_reader *r, const cagd_token *t, const cagd_tree **tree)
{
    cagd_reading_error unused = {0};
    cagd_reader at = *r;
    at.error = &unused, at.token = t, at.declaring = 1;
    *tree = cagd_begins_name(&at) ? cagd_read_name(&at) : NULL;
    int is = *tree != NULL && (*tree)->kind == CAGD_NAME && (*tree)->arguments == 0;
    return (struct part){t, is ? at.token : t};
}

static cagd_token *put(cagd_token *out, struct part p)
{
    size_t n = (size_t)(p.to - p.from);
    if (n > 0)
        memcpy(out, p.from, n * sizeof *out);
    return out + n;
}

/* What is said of several names: [low before] name behind high. */
struct shared {
    struct part low, high;
    const cagd_token *before, *behind;
};

/* The list becomes a relation for each name, with commas between. */
static int each_with(cagd_reader *r, const struct part name[], int count, struct shared s)
{
    static const cagd_token comma = {CAGD_TOKEN_SIGN, ",", 0, 0};
    const cagd_token *end = s.high.to;
    while (end->kind != CAGD_TOKEN_END)
        end++;
    long all = (end - s.high.to) + 1;
    for (int k = 0; k < count; k++)
        all += (s.low.to - s.low.from) + (name[k].to - name[k].from) + (s.high.to - s.high.from) + 3;
    cagd_token *list = cagd_region_array((int)all, 1, sizeof *list), *out = list;
    if (list == NULL)
        return 0;
    for (int k = 0; k < count; k++) {
        if (k > 0) {
            *out = comma;
            out->from = out->to = name[k].from->from;
            out++;
        }
        if (s.before != NULL)
            out = put(put(out, s.low), (struct part){s.before, s.before + 1});
        out = put(put(put(out, name[k]), (struct part){s.behind, s.behind + 1}), s.high);
    }
    put(out, (struct part){s.high.to, end + 1});
    r->token = list;
    return 1;
}

int cagd_share_bounds(cagd_reader *r)
{
    struct part name[MOST_NAMES], low = {r->token, r->token}, high;
    const cagd_tree *tree[MOST_NAMES], *first, *last;
    const cagd_token *before = NULL, *t = r->token;
    int count = 0;
    low.to = behind_value(r, t);
    if (is_order(r, low.to))
        before = low.to, t = before + 1;
    else
        low.to = low.from;
    do {
        if (count == MOST_NAMES)
            return 1;
        name[count] = name_at(r, t, &tree[count]);
        if (name[count].from == name[count].to)
            return 1;
        t = name[count++].to;
    } while (strcmp(t->word, ",") == 0 && t++);
    const cagd_token *behind = t;
    if (count < 2 || !is_order(r, behind) || (before != NULL && goes_up(before) != goes_up(behind)))
        return 1;
    high = (struct part){behind + 1, behind_value(r, behind + 1)};
    if (high.from == high.to || is_order(r, high.to))
        return 1;
    for (int k = 1; before != NULL && k < count; k++) /* a whole number and another one have no bounds together */
        if (is_number(r, name[k]) != is_number(r, name[0]))
            return 1;
    if (before != NULL && !(is_number(r, low) && is_number(r, high))) { /* one of the relations can be another one */
        int same = 0, is_low = is_number(r, low), is_high = is_number(r, high);
        struct part a = name_at(r, low.from, &first), b = name_at(r, high.from, &last);
        first = a.to == low.to ? first : NULL, last = b.to == high.to ? last : NULL;
        for (int k = 0; k < count; k++)
            for (const cagd_token *other = low.from; other < high.to; other++)
                if ((other < low.to || other >= high.from) && other->kind == CAGD_TOKEN_LETTER)
                    same |= strcmp(other->word, name[k].from->word) == 0;
        int alike = first != NULL && last != NULL && first->count > 0 && strcmp(first->head, last->head) == 0;
        if (same || !(is_low || is_high || alike))
            return 1;
        return cagd_refuse_tree(
                   r, tree[1],
                   "are both bounds those of all these names? write u, v \\in [a,b], or two conditions with "
                   "'and' between") != NULL;
    }
    return each_with(r, name, count, (struct shared){low, high, before, behind});
}

void cagd_share_value(cagd_reader *r)
{
    struct part name[MOST_NAMES], value;
    const cagd_tree *tree;
    const cagd_token *t = r->token, *equal = NULL;
    int count = 0;
    while (count < MOST_NAMES) {
        struct part p = name_at(r, t, &tree);
        if (p.from == p.to || strcmp(p.to->word, "=") != 0)
            break;
        name[count++] = p;
        equal = p.to, t = p.to + 1;
    }
    value = (struct part){t, behind_value(r, t)};
    if (count < 2 || value.from == value.to || strcmp(value.to->word, "=") == 0 || is_order(r, value.to) ||
        strcmp(value.to->word, "\\dots") == 0)
        return;
    each_with(r, name, count, (struct shared){{t, t}, value, NULL, equal});
}
