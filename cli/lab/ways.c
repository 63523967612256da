/* ways.c -- the ways through an answer and the reference together; see lab.h.
 *
 * Each code decides what it compares next by what it has compared.  So the runs of both at a point, where the same neighbours are equal,
 * are a leaf of one tree: its branches are the conditions of the answer and those of the reference, in this order, and at its end
 * what the answer divides by, which is not 0.  Of each branch that was not taken it is asked whether any inputs take it for which the
 * reference has a value: by linear inequalities (conditions.h), which prove that there are none or tell a point; else, where a
 * condition is not linear, by points on both sides of its border. */
#include "cli/lab/lab.h"
#include "exact/code/border.h"
#include "exact/code/conditions.h"
#include "exact/code/polyhedron.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_WAYS = 256, MOST_TRIES = 400, MOST_QUEUED = 4000, MOST_PURSUITS = 2, ALL_STAGES = 2 };
enum { NOT_ZERO = CAGD_CODE_ABOVE | CAGD_CODE_BELOW };

/* A leaf: its conditions, first those that are given. */
struct way {
    struct cagd_code_outcome *outcome; /* of which the conditions alone are meant */
    struct cagd_code_point *point;
    int count;
    struct cagd_code_condition *condition;
    unsigned char *state; /* of each condition, see below */
};

/* A condition of a leaf: what is divided by; its other branch is taken by no inputs; it was looked for; its border was not found;
 * it is one of the answer. */
enum { DENOMINATOR = 1, CLOSED = 2, PURSUED = 4, NO_BORDER = 8, OF_ANSWER = 16 };

struct lab_ways {
    const struct cagd_code_harness *h;
    char seen[MOST_WAYS][80];
    int seen_count;
    struct way way[MOST_WAYS];
    int ways, lost; /* lost: there was no room for something */
    /* what is looked for: the other branch of condition k of a way */
    int of, k, is_open, stage; /* stage: of what is put into the queue, up to ALL_STAGES */
    struct cagd_code_point *queue[MOST_QUEUED];
    int queued, next;
    struct cagd_code_point *tried[MOST_TRIES];
    int tries;
};

struct lab_ways *lab_ways_new(const struct cagd_code_harness *h)
{
    struct lab_ways *w = calloc(1, sizeof *w);
    if (w == NULL)
        abort();
    w->h = h;
    w->k = -1;
    return w;
}

static void clear_queue(struct lab_ways *w)
{
    while (w->queued > 0)
        cagd_code_point_free(w->queue[--w->queued]);
    w->next = 0;
}

void lab_ways_free(struct lab_ways *w)
{
    clear_queue(w);
    for (int k = 0; k < w->tries; k++)
        cagd_code_point_free(w->tried[k]);
    for (int k = 0; k < w->ways; k++) {
        for (int j = 0; j < w->way[k].count; j++) {
            free((char *)(uintptr_t)w->way[k].condition[j].polynomial);
            free((char *)(uintptr_t)w->way[k].condition[j].left);
            free((char *)(uintptr_t)w->way[k].condition[j].difference);
        }
        free(w->way[k].condition);
        free(w->way[k].state);
        free(w->way[k].outcome);
        cagd_code_point_free(w->way[k].point);
    }
    free(w);
}

static const char *member(const json_t *row, const char *key)
{
    const char *text = json_string_value(json_object_get(row, key));
    return text != NULL ? text : "";
}

int lab_ways_is_new(struct lab_ways *w, const json_t *got, const json_t *want, const struct cagd_code_point *p)
{
    unsigned long hash = 0;
    char way[80];
    for (int i = 0; i < p->inputs; i++)
        for (int j = 0; j < p->input[i].count; j++)
            hash = hash * 31 + (unsigned long)(p->input[i].like != NULL ? p->input[i].like[j] : j);
    snprintf(way, sizeof way, "%.20s %.20s %lx", member(got, "path"), member(want, "path"), hash);
    for (int k = 0; k < w->seen_count; k++)
        if (strcmp(w->seen[k], way) == 0)
            return 0;
    w->lost |= w->seen_count == MOST_WAYS;
    if (w->seen_count == MOST_WAYS)
        return 0;
    strcpy(w->seen[w->seen_count++], way);
    return 1;
}

/* ---- leaves ------------------------------------------------------------------------------------------------ */

static char *copied(const char *text)
{
    char *copy = strdup(text);
    if (copy == NULL)
        abort();
    return copy;
}

/* "-a+b" becomes "a-b", so that f and -f are one text; whether it did. */
static int turn_sign(char *polynomial)
{
    if (*polynomial != '-' || strpbrk(polynomial, "()/ ") != NULL)
        return 0;
    memmove(polynomial, polynomial + 1, strlen(polynomial));
    for (char *at = polynomial; *at != 0; at++)
        *at = *at == '+' ? '-' : *at == '-' ? '+' : *at;
    return 1;
}

/* One more condition, unless an earlier one says it; row: what is told of it, where it stands in the code. */
static void put_condition(struct way *way, const char *polynomial, const char *difference, int holding, int given,
                          int state, const json_t *row)
{
    char *text = copied(polynomial);
    if (turn_sign(text))
        holding = cagd_code_turned(holding);
    for (int k = 0; k < way->count; k++) {
        const struct cagd_code_condition *c = &way->condition[k];
        if (*text != 0 && strcmp(c->polynomial, text) == 0 && (c->holding & ~holding) == 0) {
            free(text);
            return;
        }
    }
    char *told = NULL;
    if (asprintf(&told, "%s %s %s", member(row, "left"), member(row, "relation"), member(row, "right")) < 0)
        abort();
    way->condition[way->count] =
        (struct cagd_code_condition){.left = told,
                                     .relation = "",
                                     .right = "",
                                     .opposite = "",
                                     .difference = copied(difference),
                                     .polynomial = text,
                                     .holding = holding,
                                     .given = given,
                                     .place = {.line = (int)json_integer_value(json_object_get(row, "line"))}};
    way->state[way->count++] = (unsigned char)state;
}

static void put_conditions(struct way *way, const json_t *outcome, int given, int state)
{
    size_t k;
    const json_t *row;
    json_array_foreach(json_object_get(outcome, "conditions"), k,
                       row) if (json_is_true(json_object_get(row, "given")) == given)
    {
        const char *polynomial = member(row, "polynomial"), *difference = member(row, "difference");
        put_condition(way, polynomial, *difference != 0 ? difference : polynomial, /* the difference may be too long */
                      (int)json_integer_value(json_object_get(row, "holding")), given, state, row);
    }
}

static void put_denominators(struct way *way, const json_t *outcome, int given)
{
    size_t k;
    const json_t *value;
    json_array_foreach(json_object_get(outcome, "denominators"), k, value)
        put_condition(way, json_string_value(value), json_string_value(value), NOT_ZERO, given, DENOMINATOR, NULL);
}

void lab_ways_add(struct lab_ways *w, const json_t *got, const json_t *want, const struct cagd_code_point *p)
{
    size_t room = 1 + json_array_size(json_object_get(got, "conditions")) +
                  json_array_size(json_object_get(got, "denominators")) +
                  json_array_size(json_object_get(want, "conditions")) +
                  json_array_size(json_object_get(want, "denominators"));
    if (w->ways == MOST_WAYS) {
        w->lost = 1;
        return;
    }
    struct way *way = &w->way[w->ways++];
    *way = (struct way){calloc(1, sizeof *way->outcome), cagd_code_point_copy(p), 0,
                        calloc(room, sizeof *way->condition), calloc(room, 1)};
    if (way->outcome == NULL || way->condition == NULL || way->state == NULL)
        abort();
    put_conditions(way, want, 1, 0);
    put_conditions(way, got, 0, OF_ANSWER);
    put_conditions(way, want, 0, 0);
    put_denominators(way, want, 1); /* where one is 0 nothing is asked */
    put_denominators(way, got, 0);
    for (int j = 0; j + 1 < way->count; j++)
        way->condition[j].next = &way->condition[j + 1];
    way->outcome->conditions = way->count > 0 ? way->condition : NULL;
}

/* Whether two ways agree in what they decide in front of condition k, and are asked the same there. */
static int meet_at(const struct way *a, const struct way *b, int k)
{
    if (k >= b->count || !cagd_code_is_of_one_pattern(a->point, b->point))
        return 0;
    for (int j = 0; j <= k; j++) {
        const struct cagd_code_condition *c = &a->condition[j], *d = &b->condition[j];
        if (strcmp(c->polynomial, d->polynomial) != 0 || strcmp(c->difference, d->difference) != 0 ||
            (j < k && c->holding != d->holding))
            return 0;
    }
    return 1;
}

/* Whether the other branch is one of a known way. */
static int is_met(const struct lab_ways *w, int of, int k)
{
    for (int j = 0; j < w->ways; j++)
        if (j != of && meet_at(&w->way[of], &w->way[j], k) &&
            w->way[j].condition[k].holding != w->way[of].condition[k].holding)
            return 1;
    return 0;
}

/* How many ways have the same other branch and that mark. */
static int marked(const struct lab_ways *w, int of, int k, int mark)
{
    int count = 0;
    for (int j = 0; j < w->ways; j++)
        count += k < w->way[j].count && (w->way[j].state[k] & mark) != 0 &&
                 w->way[j].condition[k].holding == w->way[of].condition[k].holding &&
                 meet_at(&w->way[of], &w->way[j], k);
    return count;
}

/* ---- points ------------------------------------------------------------------------------------------------- */

static int elements_of(const struct cagd_code_input *in) { return in->count > 0 ? in->count : 1; }

static int same_point(const struct cagd_code_point *a, const struct cagd_code_point *b)
{
    for (int i = 0; i < a->inputs; i++)
        for (int j = 0; j < elements_of(&a->input[i]); j++)
            if (strcmp(a->input[i].value[j], b->input[i].value[j]) != 0 || a->input[i].like[j] != b->input[i].like[j])
                return 0;
    return 1;
}

static void put_point(struct lab_ways *w, struct cagd_code_point *p)
{
    if (w->queued < MOST_QUEUED)
        w->queue[w->queued++] = p;
    else
        w->lost = 1, cagd_code_point_free(p);
}

/* The point with one value changed. */
static void put_beside(struct lab_ways *w, const struct cagd_code_point *p, int input, int element, cagd_num_q value)
{
    struct cagd_code_point *other = cagd_code_point_copy(p);
    cagd_code_point_set(other, input, element, cagd_to_string_q(value));
    put_point(w, other);
}

/* Whether some other variable than element j of input i is in the expression. */
static int has_others(const char *expression, const struct cagd_code_point *p, int i, int j)
{
    char name[64];
    for (int k = 0; k < p->inputs; k++)
        for (int e = 0; p->input[k].variable && e < elements_of(&p->input[k]); e++) {
            snprintf(name, sizeof name, p->input[k].count > 0 ? "%s[%d]" : "%s", p->input[k].name, e);
            if ((k != i || e != j) && strstr(expression, name) != NULL)
                return 1;
        }
    return 0;
}

/* Points where the difference is 0, with small numbers for one variable and a rational zero in another; how many. */
static int put_zeros(struct lab_ways *w, const struct cagd_code_point *p, const char *difference)
{
    enum { MOST_FOUND = 6, MOST_TRIALS = 300 };
    static const char *const small[] = {"0",   "1",   "-1",  "2",   "-2",  "3",   "1/2",
                                        "3/2", "1/3", "2/3", "1/4", "3/4", "5/4", "5/3"};
    int found = 0, trials = 0;
    for (int i = 0; i < p->inputs; i++)
        for (int j = 0; p->input[i].variable && j < elements_of(&p->input[i]); j++) {
            char name[64];
            snprintf(name, sizeof name, p->input[i].count > 0 ? "%s[%d]" : "%s", p->input[i].name, j);
            for (size_t v = 0; strstr(difference, name) != NULL && v < sizeof small / sizeof *small; v++)
                for (int k = 0; k < p->inputs; k++)
                    for (int l = 0; p->input[k].variable && l < elements_of(&p->input[k]); l++) {
                        if ((k == i && l == j) || found >= MOST_FOUND || trials++ >= MOST_TRIALS)
                            continue;
                        struct cagd_code_point *at = cagd_code_point_copy(p);
                        cagd_code_point_set(at, i, j, small[v]);
                        cagd_region_mark mark = cagd_region_open();
                        struct cagd_code_border b = cagd_code_border(difference, at, k, l);
                        for (int z = 0; b.rational > 0 && z < b.values; z++)
                            put_beside(w, at, k, l, b.at[z]);
                        found += b.rational > 0;
                        cagd_region_drop(mark);
                        cagd_code_point_free(at);
                    }
        }
    return found;
}

/* What is known of a border: that it was met, and that points were met that lie on it. */
struct met {
    int any, real, zeros; /* a border, or none to be met; points on it; rational ones */
};

/* Points on the border of the condition and on all sides of it, near and far, for one variable after the other.  Before the next one is
 * looked at, that variable goes to where the difference is nearest to 0, always or where it has no zero: so a border that closes around a
 * small region is met. */
static void put_border(struct lab_ways *w, const struct cagd_code_point *p, const char *difference, int always,
                       struct met *met)
{
    struct cagd_code_point *at = cagd_code_point_copy(p);
    for (int i = 0; i < p->inputs; i++)
        for (int j = 0; p->input[i].variable && j < elements_of(&p->input[i]); j++) {
            cagd_region_mark mark = cagd_region_open();
            struct cagd_code_border here = cagd_code_border(difference, p, i, j),
                                    there = cagd_code_border(difference, at, i, j);
            for (int k = 0; k < here.values && !always; k++)
                put_beside(w, p, i, j, here.at[k]);
            for (int k = 0; k < there.values; k++)
                put_beside(w, at, i, j, there.at[k]);
            met->any |= here.zeros > 0 || there.zeros > 0 || (here.varies && !has_others(difference, p, i, j));
            met->real |= here.zeros > 0 || there.zeros > 0;
            met->zeros += here.rational + there.rational;
            if ((always || there.zeros == 0) && there.least.at != NULL)
                cagd_code_point_set(at, i, j, cagd_to_string_q(there.least));
            cagd_region_drop(mark);
        }
    cagd_code_point_free(at);
}

/* Points for the other branch of a condition; whether it is known where that is: on a border that was met, for an equation at points that
 * are rational. */
static int put_candidates(struct lab_ways *w, const struct cagd_code_point *p, const struct cagd_code_condition *c)
{
    struct met met = {0};
    put_border(w, p, c->difference, 0, &met);
    put_border(w, p, c->difference, 1, &met);
    int alone = met.any && met.zeros == 0 && c->holding == NOT_ZERO;
    return met.any && (!alone || put_zeros(w, p, c->difference) > 0 || !met.real);
}

/* Points for the other branch of condition k near those of ways that part from this one at an earlier condition: across its border, with all
 * other values as they are there. */
static void put_from_others(struct lab_ways *w)
{
    enum { MOST_FROM_OTHERS = 60 };
    const struct way *way = &w->way[w->of];
    int begun = w->queued;
    for (int j = 0; j < w->ways; j++)
        for (int k = 0; k < w->k && w->queued < begun + MOST_FROM_OTHERS && w->tries < MOST_TRIES / 2; k++) {
            struct met met = {0};
            if (j == w->of || !meet_at(way, &w->way[j], k) ||
                way->condition[k].holding == w->way[j].condition[k].holding)
                continue;
            put_border(w, w->way[j].point, way->condition[k].difference, 0, &met);
            break;
        }
}

/* ---- the search ----------------------------------------------------------------------------------------------- */

/* Whether what is given, at the way whose other branch is looked for, is true at the point: else nothing is run there. */
static int is_inside(const struct lab_ways *w, const struct cagd_code_point *p)
{
    const struct way *way = &w->way[w->of];
    int inside = 1;
    cagd_region_mark mark = cagd_region_open();
    for (int k = 0; k < way->count && inside; k++) {
        const struct cagd_code_condition *c = &way->condition[k];
        if (!c->given || c->polynomial[0] == 0 || (way->state[k] & DENOMINATOR) != 0)
            continue;
        cagd_num_q value = cagd_code_evaluate(c->polynomial, p, NULL, cagd_from_int_q(0));
        int sign = value.at != NULL ? cagd_sign_q(value) : 0;
        inside = value.at == NULL || (c->holding & (sign == 0  ? CAGD_CODE_ZERO
                                                    : sign > 0 ? CAGD_CODE_ABOVE
                                                               : CAGD_CODE_BELOW)) != 0;
    }
    cagd_region_drop(mark);
    return inside;
}

/* The next point of the queue that was not tried; NULL: it is empty. */
static struct cagd_code_point *untried(struct lab_ways *w)
{
    while (w->next < w->queued) {
        const struct cagd_code_point *p = w->queue[w->next++];
        int known = !is_inside(w, p);
        for (int k = 0; k < w->tries && !known; k++)
            known = same_point(w->tried[k], p);
        if (known)
            continue;
        if (w->tries == MOST_TRIES) {
            w->lost = 1;
            return NULL;
        }
        w->tried[w->tries++] = cagd_code_point_copy(p);
        return cagd_code_point_copy(p);
    }
    return NULL;
}

/* To the next other branch that is not met, not closed, and was not looked for often enough; 0: there is none. */
static int go_on(struct lab_ways *w)
{
    for (; w->of < w->ways; w->of++, w->k = -1)
        while (++w->k < w->way[w->of].count)
            if (!w->way[w->of].condition[w->k].given && !is_met(w, w->of, w->k) &&
                marked(w, w->of, w->k, CLOSED) == 0 && marked(w, w->of, w->k, PURSUED) < MOST_PURSUITS)
                return 1;
    return 0;
}

/* Whether the other branch of the condition is that something is 0, and it is at no fraction. */
static int is_no_equation(const struct cagd_code_condition *c)
{
    return c->holding == NOT_ZERO && c->polynomial[0] != 0 && lab_is_zero_at_no_fraction(c->polynomial);
}

/* What is known of the branch: of an equation in one variable by its factors, else by linear inequalities. */
static void begin_branch(struct lab_ways *w)
{
    struct way *way = &w->way[w->of];
    const struct cagd_code_leaf leaf = {way->outcome, way->point};
    struct cagd_code_point *point = NULL;
    char text[600];
    clear_queue(w);
    int found =
        is_no_equation(&way->condition[w->k]) ? 0 : cagd_code_branch(w->h, &leaf, w->k, &point, sizeof text, text);
    way->state[w->k] |= found == 0 ? CLOSED : PURSUED;
    w->is_open = found != 0;
    w->stage = 0;
    if (found == 1)
        put_point(w, point);
}

struct cagd_code_point *lab_ways_next(struct lab_ways *w)
{
    for (;;) {
        while (w->is_open && !is_met(w, w->of, w->k)) {
            struct way *way = &w->way[w->of];
            struct cagd_code_point *p = untried(w);
            if (p != NULL)
                return p;
            if (w->stage == ALL_STAGES || w->tries == MOST_TRIES)
                break;
            if (w->stage++ > 0)
                put_from_others(w);
            else if (!put_candidates(w, way->point, &way->condition[w->k]))
                way->state[w->k] |= NO_BORDER;
        }
        w->is_open = 0;
        if (w->tries == MOST_TRIES || !go_on(w))
            return NULL;
        begin_branch(w);
    }
}

/* How many patterns of equal neighbours the ways have. */
static long count_patterns(const struct lab_ways *w)
{
    long count = 0;
    for (int k = 0; k < w->ways; k++) {
        int known = 0;
        for (int j = 0; j < k && !known; j++)
            known = cagd_code_is_of_one_pattern(w->way[j].point, w->way[k].point);
        count += !known;
    }
    return count;
}

struct lab_open lab_ways_open(const struct lab_ways *w)
{
    struct lab_open open = {.undecided = w->lost, .branches = count_patterns(w) < cagd_code_patterns(w->h)};
    for (int of = 0; of < w->ways; of++)
        for (int k = 0; k < w->way[of].count; k++) {
            const struct way *way = &w->way[of];
            int denominator = way->state[k] & DENOMINATOR;
            if (way->condition[k].given)
                continue;
            open.conditions += !denominator;
            if (is_met(w, of, k) || marked(w, of, k, CLOSED) > 0)
                continue;
            open.denominators += denominator != 0;
            open.branches += !denominator;
            if (!denominator && open.line == 0 && (way->state[k] & OF_ANSWER) != 0) {
                open.line = (int)way->condition[k].place.line;
                snprintf(open.compared, sizeof open.compared, "%s", way->condition[k].left);
            }
            open.undecided += !denominator && marked(w, of, k, NO_BORDER) > 0;
        }
    return open;
}
