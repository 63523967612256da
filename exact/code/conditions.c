/* conditions.c -- see conditions.h. */
#include "exact/code/conditions.h"

#include "exact/code/polyhedron.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NODES = 400 };

/* x < y and x <= y, from the preconditions and among numbers, as a graph on texts. */
struct order {
    int nodes;
    const char *node[MOST_NODES];
    unsigned char below[MOST_NODES][MOST_NODES]; /* 1: <=, 2: < */
};

static int node_of(struct order *o, const char *text)
{
    for (int k = 0; k < o->nodes; k++)
        if (strcmp(o->node[k], text) == 0)
            return k;
    if (o->nodes == MOST_NODES)
        return -1;
    o->node[o->nodes] = text;
    return o->nodes++;
}

static int is_plain_number(const char *text) { return text[strspn(text, "-0123456789/")] == 0; }

static void close_order(struct order *o)
{
    cagd_region_mark mark = cagd_region_open();
    for (int a = 0; a < o->nodes; a++)
        for (int b = 0; b < o->nodes; b++)
            if (a != b && is_plain_number(o->node[a]) && is_plain_number(o->node[b]) &&
                cagd_compare_q(cagd_from_string_q(o->node[a]), cagd_from_string_q(o->node[b])) < 0)
                o->below[a][b] = 2;
    cagd_region_drop(mark);
    for (int m = 0; m < o->nodes; m++)
        for (int a = 0; a < o->nodes; a++)
            for (int b = 0; o->below[a][m] != 0 && b < o->nodes; b++)
                if (o->below[m][b] != 0) {
                    unsigned char both = o->below[a][m] > o->below[m][b] ? o->below[a][m] : o->below[m][b];
                    if (both > o->below[a][b])
                        o->below[a][b] = both;
                }
}

static int follows(const struct order *o, int a, int b, const char *relation)
{
    if (strcmp(relation, "<") == 0)
        return o->below[a][b] == 2;
    if (strcmp(relation, "<=") == 0)
        return o->below[a][b] != 0;
    if (strcmp(relation, ">") == 0)
        return o->below[b][a] == 2;
    if (strcmp(relation, ">=") == 0)
        return o->below[b][a] != 0;
    return strcmp(relation, "!=") == 0 && (o->below[a][b] == 2 || o->below[b][a] == 2);
}

static void add_to_order(struct order *o, const struct cagd_code_condition *c)
{
    int a = node_of(o, c->left), b = node_of(o, c->right), less = c->relation[0] == '<', more = c->relation[0] == '>';
    if (a < 0 || b < 0 || (!less && !more))
        return;
    unsigned char strength = c->relation[1] == '=' ? 1 : 2;
    unsigned char *edge = less ? &o->below[a][b] : &o->below[b][a];
    if (strength > *edge)
        *edge = strength;
}

/* Whether a condition says that the difference of this text is not 0. */
static int is_said(const struct cagd_code_outcome *o, const char *text, size_t length)
{
    for (const struct cagd_code_condition *c = o->conditions; c != NULL; c = c->next)
        if ((strlen(c->difference) == length && strncmp(c->difference, text, length) == 0) ||
            (strlen(c->opposite) == length && strncmp(c->opposite, text, length) == 0))
            if (strcmp(c->relation, "<") == 0 || strcmp(c->relation, ">") == 0 || strcmp(c->relation, "!=") == 0)
                return 1;
    return 0;
}

/* Denominators that cannot be 0 by what the conditions say are dropped. */
static void drop_denominators(struct cagd_code_outcome *o)
{
    if (o->denominators == NULL)
        return;
    char *to = (char *)(uintptr_t)o->denominators;
    for (const char *from = o->denominators; *from != 0;) {
        size_t length = strcspn(from, "\n");
        if (!is_said(o, from, length)) {
            memmove(to, from, length + 1);
            to += length + 1;
        }
        from += length + 1;
    }
    *to = 0;
}

/* x != y where x <= y is known is x < y. */
static void sharpen(struct cagd_code_outcome *outcome, struct order *o)
{
    for (struct cagd_code_condition *c = outcome->conditions; c != NULL; c = c->next) {
        int a = node_of(o, c->left), b = node_of(o, c->right);
        if (c->given || strcmp(c->relation, "!=") != 0 || a < 0 || b < 0)
            continue;
        if (o->below[a][b] != 0 && o->below[b][a] == 0) {
            c->relation = "<";
        } else if (o->below[b][a] != 0 && o->below[a][b] == 0) { /* the smaller one to the left */
            const char *left = c->left, *difference = c->difference;
            c->left = c->right, c->right = left;
            c->difference = c->opposite, c->opposite = difference;
            c->relation = "<";
        }
    }
}

/* Each condition of the code is dropped that follows, by chains of inequalities, from the preconditions and from those of the
 * code that are kept. */
enum { ANY_SIGN = CAGD_CODE_ZERO | CAGD_CODE_ABOVE | CAGD_CODE_BELOW, MOST_CLAIMS = 300 };

/* Whether the claim is true nowhere where the preconditions are and the conditions that are told, but for one, hold. */
static int is_excluded(const struct cagd_code_outcome *o, const struct cagd_code_condition *but, const char *polynomial,
                       int signs)
{
    struct cagd_code_claim claim[MOST_CLAIMS];
    struct cagd_code_witness witness;
    int count = 0;
    cagd_region_mark mark = cagd_region_open();
    for (const struct cagd_code_condition *c = o->conditions; c != NULL && count < MOST_CLAIMS; c = c->next)
        if (c != but && (c->given || !c->implied))
            claim[count++] = (struct cagd_code_claim){c->polynomial, c->holding};
    int excluded = 0;
    if (count < MOST_CLAIMS && polynomial[0] != 0) {
        claim[count++] = (struct cagd_code_claim){polynomial, signs};
        excluded = cagd_code_is_anywhere(count, claim, &witness) == 0;
    }
    cagd_region_drop(mark);
    return excluded;
}

/* The same, by linear inequalities. */
static void simplify_further(struct cagd_code_outcome *o)
{
    for (struct cagd_code_condition *c = o->conditions; c != NULL; c = c->next)
        if (!c->given && !c->implied)
            c->implied = is_excluded(o, c, c->polynomial, ANY_SIGN & ~c->holding);
    if (o->denominators == NULL)
        return;
    char *to = (char *)(uintptr_t)o->denominators;
    for (const char *from = o->denominators; *from != 0;) {
        char text[400];
        size_t length = strcspn(from, "\n");
        snprintf(text, sizeof text, "%.*s", (int)length, from);
        if (length >= sizeof text || !is_excluded(o, NULL, text, CAGD_CODE_ZERO)) {
            memmove(to, from, length + 1);
            to += length + 1;
        }
        from += length + 1;
    }
    *to = 0;
}

void cagd_code_simplify(struct cagd_code_outcome *outcome)
{
    struct order *o = calloc(1, sizeof *o);
    if (o == NULL)
        abort();
    for (struct cagd_code_condition *c = outcome->conditions; c != NULL; c = c->next)
        if (!c->given)
            node_of(o, c->left), node_of(o, c->right);
    for (struct cagd_code_condition *c = outcome->conditions; c != NULL; c = c->next)
        if (c->given)
            add_to_order(o, c);
    close_order(o);
    for (struct cagd_code_condition *c = outcome->conditions; c != NULL; c = c->next) {
        int a = node_of(o, c->left), b = node_of(o, c->right);
        c->implied = !c->given && a >= 0 && b >= 0 && follows(o, a, b, c->relation);
    }
    sharpen(outcome, o);
    drop_denominators(outcome);
    /* of those that stay, one that follows from the others */
    for (struct cagd_code_condition *c = outcome->conditions; c != NULL; c = c->next) {
        if (c->given || c->implied)
            continue;
        memset(o, 0, sizeof *o);
        for (struct cagd_code_condition *d = outcome->conditions; d != NULL; d = d->next)
            if (d != c && !d->implied)
                add_to_order(o, d);
        int a = node_of(o, c->left), b = node_of(o, c->right);
        close_order(o);
        c->implied = a >= 0 && b >= 0 && follows(o, a, b, c->relation);
    }
    free(o);
    simplify_further(outcome);
}

/* ---- ways that are open ------------------------------------------------------------------------------------ */

int cagd_code_count_conditions(const struct cagd_code_outcome *o)
{
    int count = 0;
    for (const struct cagd_code_condition *c = o->conditions; c != NULL; c = c->next)
        count++;
    return count;
}

int cagd_code_is_of_one_pattern(const struct cagd_code_point *a, const struct cagd_code_point *b)
{
    for (int i = 0; i < a->inputs; i++)
        for (int j = 0; j < a->input[i].count; j++)
            if (a->input[i].like[j] != b->input[i].like[j])
                return 0;
    return 1;
}

int cagd_code_branches_off(const struct cagd_code_leaf *leaf, int k, const struct cagd_code_leaf *other)
{
    const struct cagd_code_condition *c = leaf->outcome->conditions, *d = other->outcome->conditions;
    if (!cagd_code_is_of_one_pattern(leaf->point, other->point))
        return 0;
    for (int j = 0; c != NULL && d != NULL; j++, c = c->next, d = d->next) {
        if (c->polynomial[0] == 0 || strcmp(c->polynomial, d->polynomial) != 0)
            return 0;
        if (j == k)
            return d->holding == (ANY_SIGN & ~c->holding);
        if (c->holding != d->holding)
            return 0;
    }
    return 0;
}

int cagd_code_is_same_way(const struct cagd_code_leaf *a, const struct cagd_code_leaf *b)
{
    const struct cagd_code_condition *c = a->outcome->conditions, *d = b->outcome->conditions;
    if (a->outcome->end != b->outcome->end || !cagd_code_is_of_one_pattern(a->point, b->point))
        return 0;
    for (; c != NULL && d != NULL; c = c->next, d = d->next)
        if (c->holding != d->holding || strcmp(c->polynomial, d->polynomial) != 0 || strcmp(c->left, d->left) != 0)
            return 0;
    return c == NULL && d == NULL;
}

/* The witness's values of the variables, on top of the point's. */
static struct cagd_code_point *moved(const struct cagd_code_point *from, const struct cagd_code_witness *w)
{
    struct cagd_code_point *p = cagd_code_point_copy(from);
    for (int i = 0; i < p->inputs; i++)
        for (int j = 0; p->input[i].variable && j < (p->input[i].count > 0 ? p->input[i].count : 1); j++) {
            char name[64];
            if (p->input[i].count > 0)
                snprintf(name, sizeof name, "%s[%d]", p->input[i].name, p->input[i].like[j]);
            else
                snprintf(name, sizeof name, "%s", p->input[i].name);
            for (int k = 0; k < w->count; k++)
                if (strcmp(w->name[k], name) == 0)
                    cagd_code_point_set(p, i, j, cagd_to_string_q(w->value[k]));
        }
    return p;
}

/* The value of a variable, "t" or "k[2]", at a point. */
static cagd_num_q value_at(const void *context, const char *name, size_t length)
{
    const struct cagd_code_point *p = context;
    for (int i = 0; i < p->inputs; i++) {
        size_t n = strlen(p->input[i].name);
        if (strncmp(name, p->input[i].name, n) != 0 || (n != length && name[n] != '['))
            continue;
        return cagd_from_string_q(p->input[i].value[n == length ? 0 : strtol(name + n + 1, NULL, 10)]);
    }
    return cagd_from_int_q(0);
}

/* One part in `parts` of the way from a to b. */
static struct cagd_code_point *between_points(const struct cagd_code_point *a, const struct cagd_code_point *b,
                                              long part, long parts)
{
    struct cagd_code_point *p = cagd_code_point_copy(a);
    cagd_num_q share = cagd_from_ratio_q(part, parts);
    for (int i = 0; i < p->inputs; i++)
        for (int j = 0; p->input[i].variable && j < (p->input[i].count > 0 ? p->input[i].count : 1); j++) {
            cagd_num_q x = cagd_from_string_q(a->input[i].value[j]), y = cagd_from_string_q(b->input[i].value[j]);
            cagd_code_point_set(p, i, j, cagd_to_string_q(cagd_add_q(x, cagd_mul_q(share, cagd_sub_q(y, x)))));
        }
    return p;
}

/* Where the claims hold, if that is found: the witness's point, others on the way to it, or one by chance.  The claims are those of
 * polynomials; where one is not linear the witness may be wrong. */
static struct cagd_code_point *point_where(const struct cagd_code_harness *h, const struct cagd_code_point *from,
                                           int count, const struct cagd_code_claim claim[],
                                           const struct cagd_code_witness *w)
{
    enum { PARTS = 24, CHANCES = 400 };
    struct cagd_code_point *point = moved(from, w);
    for (long k = 0; k < PARTS + CHANCES; k++) {
        struct cagd_code_point *other = k == 0      ? cagd_code_point_copy(point)
                                        : k < PARTS ? between_points(from, point, k, PARTS)
                                                    : cagd_code_point_new(h, k, 0);
        cagd_region_mark mark = cagd_region_open();
        int good = cagd_code_is_of_one_pattern(from, other) && cagd_code_hold_at(count, claim, value_at, other);
        cagd_region_drop(mark);
        if (good) {
            cagd_code_point_free(point);
            return other;
        }
        cagd_code_point_free(other);
    }
    return point;
}

/* Neighbours that are not one variable are not equal: x[j] - x[j-1] > 0. */
static int claims_of_pattern(const struct cagd_code_harness *h, const struct cagd_code_point *p, int room,
                             struct cagd_code_claim claim[])
{
    int count = 0;
    for (int i = 0; i < p->inputs; i++)
        for (int j = 1; h->input[i].shape == CAGD_CODE_NONDECREASING && j < p->input[i].count && count < room; j++) {
            const int *like = p->input[i].like;
            if (like[j] == like[j - 1])
                continue;
            char *text = cagd_region_bytes(100);
            if (text == NULL)
                abort();
            snprintf(text, 100, "%s[%d]-%s[%d]", p->input[i].name, like[j], p->input[i].name, like[j - 1]);
            claim[count++] = (struct cagd_code_claim){text, CAGD_CODE_ABOVE};
        }
    return count;
}

int cagd_code_branch(const struct cagd_code_harness *h, const struct cagd_code_leaf *leaf, int k,
                     struct cagd_code_point **point, size_t room, char text[])
{
    static const char *const signs[] = {"", "=", ">", ">=", "<", "<=", "!="};
    struct cagd_code_claim claim[MOST_CLAIMS];
    struct cagd_code_witness witness;
    cagd_region_mark mark = cagd_region_open();
    int count = claims_of_pattern(h, leaf->point, MOST_CLAIMS, claim);
    const struct cagd_code_condition *c = leaf->outcome->conditions;
    for (int j = 0; j < k && count < MOST_CLAIMS; j++, c = c->next)
        claim[count++] = (struct cagd_code_claim){c->polynomial, c->holding};
    int found = -1, other = ANY_SIGN & ~c->holding;
    snprintf(text, room, "%s %s 0, at %s:%d",
             c->polynomial[0] != 0 && strlen(c->polynomial) < 200 ? c->polynomial : "(a long expression)", signs[other],
             c->place.file != NULL ? c->place.file : "", (int)c->place.line);
    if (count < MOST_CLAIMS && c->polynomial[0] != 0) {
        claim[count++] = (struct cagd_code_claim){c->polynomial, other};
        found = cagd_code_is_anywhere(count, claim, &witness);
    }
    if (found == 1)
        *point = point_where(h, leaf->point, count, claim, &witness);
    cagd_region_drop(mark);
    return found;
}
