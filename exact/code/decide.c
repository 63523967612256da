/* decide.c -- see decide.h. */
#include "exact/code/decide.h"

#include "exact/number/rational.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct cagd_code_outcome *run_at(const struct cagd_code_program *p, const struct cagd_code_harness *h,
                                        const struct cagd_code_point *at, enum cagd_code_numbers numbers)
{
    struct cagd_code_job job = {.entry = "cagd_code_entry",
                                .numbers = numbers,
                                .enclose = !h->refuse_roots,
                                .inputs = at->inputs,
                                .input = at->input};
    struct cagd_code_outcome *o = cagd_code_run(p, &job);
    if (o == NULL)
        abort();
    return o;
}

static int has(const struct cagd_code_outcome *o, enum cagd_code_answer answer)
{
    for (const struct cagd_code_result *r = o->results; r != NULL; r = r->next)
        if (r->wanted != NULL && r->same == answer)
            return 1;
    return 0;
}

static int differs(const struct cagd_code_outcome *o)
{
    return o->end == CAGD_CODE_FINISHED && has(o, CAGD_CODE_DIFFERENT);
}

/* ---- the smallest counterexample ------------------------------------------------------------------------ */

/* Of how many digits a value is: what is made small. */
static size_t length_of(const char *value)
{
    return strlen(value) + (*value == '-' ? 1u : 0u) + (strchr(value, '/') != NULL ? 2u : 0u);
}

static void make_small(const struct cagd_code_program *p, const struct cagd_code_harness *h,
                       struct cagd_code_verdict *v)
{
    static const char *const tries[] = {"0", "1", "2", "3", "-1", "1/2"};
    for (int again = 1; again != 0;) {
        again = 0;
        for (int i = 0; i < v->point->inputs; i++) {
            if (!v->point->input[i].variable)
                continue;
            for (int j = 0; j < (v->point->input[i].count > 0 ? v->point->input[i].count : 1); j++)
                for (size_t k = 0; k < sizeof tries / sizeof *tries; k++) {
                    const char *now = v->point->input[i].value[j];
                    if (length_of(tries[k]) > length_of(now) ||
                        (length_of(tries[k]) == length_of(now) && strcmp(tries[k], now) >= 0))
                        continue;
                    struct cagd_code_point *other = cagd_code_point_copy(v->point);
                    cagd_code_point_set(other, i, j, tries[k]);
                    struct cagd_code_outcome *o = run_at(p, h, other, CAGD_CODE_RATIONAL);
                    if (differs(o)) {
                        cagd_code_point_free(v->point);
                        cagd_code_outcome_free(v->outcome);
                        v->point = other, v->outcome = o;
                        again = 1;
                        break;
                    }
                    cagd_code_point_free(other);
                    cagd_code_outcome_free(o);
                }
        }
    }
}

/* ---- conditions that need not be said --------------------------------------------------------------------- */

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
static void simplify(struct cagd_code_outcome *outcome)
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
}

/* ---- points and paths -------------------------------------------------------------------------------------- */

static void keep(struct cagd_code_verdict *v, struct cagd_code_point *point, struct cagd_code_outcome *o)
{
    if (v->point != NULL) {
        cagd_code_point_free(point);
        cagd_code_outcome_free(o);
        return;
    }
    v->point = point;
    v->outcome = o;
}

/* Why and where the run ended, unless something is said already. */
static void say(size_t room, char message[], const struct cagd_code_outcome *o)
{
    if (message[0] != 0)
        return;
    if (o->line > 0)
        snprintf(message, room, "%s, at %s:%d in %s", o->message, o->file, o->line, o->function);
    else
        snprintf(message, room, "%s", o->message);
}

/* The path of the point becomes known; whether it was new.  Which variables are one belongs to it. */
static int new_path(struct cagd_code_verdict *v, const struct cagd_code_outcome *o, const struct cagd_code_point *point)
{
    unsigned long long hash = o->path;
    for (int i = 0; i < point->inputs; i++)
        for (int j = 0; j < point->input[i].count; j++)
            hash = (hash ^ (unsigned long long)(point->input[i].like[j] + 1)) * 0x100000001B3u;
    for (int k = 0; k < v->paths; k++)
        if (v->path[k].hash == hash)
            return 0;
    if (v->paths == CAGD_CODE_MOST_PATHS) {
        v->untold++;
        return 0;
    }
    v->path[v->paths++] = (struct cagd_code_path){.hash = hash, .point = cagd_code_point_copy(point)};
    return 1;
}

/* In rationals: 1 when the search is over. */
static int try_point(const struct cagd_code_program *p, const struct cagd_code_harness *h, struct cagd_code_verdict *v,
                     long k, unsigned char seen[])
{
    struct cagd_code_point *point = cagd_code_point_new(h, k, 0);
    struct cagd_code_outcome *o = run_at(p, h, point, CAGD_CODE_RATIONAL);
    switch (o->end) {
    case CAGD_CODE_OUTSIDE:
        v->outside++;
        break;
    case CAGD_CODE_UNDEFINED:
        v->undefined++;
        say(sizeof v->hole_message, v->hole_message, o);
        if (v->hole == NULL)
            v->hole = cagd_code_point_copy(point);
        break;
    case CAGD_CODE_FINISHED:
        v->points++;
        if (!seen[k % v->patterns])
            v->seen++;
        seen[k % v->patterns] = 1;
        if (differs(o)) {
            v->word = CAGD_CODE_DIFFERS;
            keep(v, point, o);
            make_small(p, h, v);
            return 1;
        }
        if (has(o, CAGD_CODE_UNKNOWN))
            v->word = CAGD_CODE_ENCLOSED;
        new_path(v, o, point);
        if (v->point == NULL && o->results != NULL && o->results->wanted == NULL) {
            keep(v, point, o);
            return 0;
        }
        break;
    default:
        say(sizeof v->message, v->message, o);
        v->word = CAGD_CODE_UNDECIDED;
        if (v->point != NULL) {
            cagd_code_point_free(v->point);
            cagd_code_outcome_free(v->outcome);
            v->point = NULL;
        }
        keep(v, point, o);
        return 1;
    }
    cagd_code_point_free(point);
    cagd_code_outcome_free(o);
    return 0;
}

/* Each path in the field.  A function that differs, though not at the point of its path, differs at others of that path. */
static void prove(const struct cagd_code_program *p, const struct cagd_code_harness *h, struct cagd_code_verdict *v)
{
    int unknown = 0;
    for (int k = 0; k < v->paths; k++) {
        struct cagd_code_path *path = &v->path[k];
        path->field = run_at(p, h, path->point, CAGD_CODE_FIELD);
        if (path->field->end != CAGD_CODE_FINISHED) {
            say(sizeof v->message, v->message, path->field);
            continue;
        }
        simplify(path->field);
        path->proved = !has(path->field, CAGD_CODE_DIFFERENT) && !has(path->field, CAGD_CODE_UNKNOWN);
        v->proved += path->proved;
        unknown += !path->proved;
    }
    if (unknown > 0 && v->message[0] == 0)
        snprintf(v->message, sizeof v->message,
                 "on %d of the ways the two sides are different functions that are equal at the points tried", unknown);
    if (v->proved == v->paths && v->paths > 0 && v->untold == 0)
        v->word = CAGD_CODE_PROVED;
    else if (v->untold > 0 && v->message[0] == 0)
        snprintf(v->message, sizeof v->message, "%d points took ways beyond the first %d", v->untold,
                 CAGD_CODE_MOST_PATHS);
}

/* ---- rounding -------------------------------------------------------------------------------------------- */

static struct cagd_code_worst *worst_of(struct cagd_code_verdict *v, const char *name)
{
    for (int k = 0; k < v->worsts; k++)
        if (strcmp(v->worst[k].name, name) == 0)
            return &v->worst[k];
    if (v->worsts == CAGD_CODE_MOST_WORST)
        return NULL;
    struct cagd_code_worst *w = &v->worst[v->worsts++];
    snprintf(w->name, sizeof w->name, "%s", name);
    w->ulps = -1;
    return w;
}

static void note_rounding(struct cagd_code_verdict *v, const struct cagd_code_outcome *o,
                          const struct cagd_code_point *point)
{
    if (o->end != CAGD_CODE_FINISHED)
        return;
    v->rounded++;
    v->turned += o->decided_otherwise;
    if (o->decided_otherwise > 0 && v->turned_at[0] == 0)
        snprintf(v->turned_at, sizeof v->turned_at, "%s:%d", o->turned.file, (int)o->turned.line);
    for (const struct cagd_code_result *r = o->results; r != NULL; r = r->next) {
        struct cagd_code_worst *w = worst_of(v, r->name);
        if (w == NULL || isnan(r->ulps) || r->ulps <= w->ulps)
            continue;
        cagd_code_point_free(w->point);
        w->point = cagd_code_point_copy(point);
        w->ulps = r->ulps;
        w->part = r->worst_part;
        w->computed = r->computed;
        snprintf(w->line, sizeof w->line, "%s", r->worst_line != NULL ? r->worst_line : "");
        snprintf(w->exact, sizeof w->exact, "%s", strlen(r->got) < sizeof w->exact ? r->got : "");
    }
}

/* Half of the points by chance; the others near the worst so far, one input changed. */
static void search_rounding(const struct cagd_code_program *p, const struct cagd_code_harness *h,
                            struct cagd_code_verdict *v, long points)
{
    for (long k = 0; k < points; k++) {
        struct cagd_code_point *point = cagd_code_point_new(h, k, 1);
        if (k > points / 2 && v->worsts > 0 && v->worst[k % v->worsts].point != NULL) {
            struct cagd_code_point *near = cagd_code_point_copy(v->worst[k % v->worsts].point);
            int i = (int)(k % near->inputs);
            int count = near->input[i].count > 0 ? near->input[i].count : 1;
            int j = (int)(k / near->inputs % count);
            if (h->input[i].shape == CAGD_CODE_ANY || h->input[i].shape == CAGD_CODE_POSITIVE ||
                h->input[i].shape == CAGD_CODE_BETWEEN)
                cagd_code_point_set(near, i, j, point->input[i].value[j]);
            cagd_code_point_free(point);
            point = near;
        }
        struct cagd_code_outcome *o = run_at(p, h, point, CAGD_CODE_ROUNDING);
        note_rounding(v, o, point);
        cagd_code_outcome_free(o);
        cagd_code_point_free(point);
    }
}

/* ---- all of it ------------------------------------------------------------------------------------------- */

struct cagd_code_verdict *cagd_code_decide(const struct cagd_code_program *p, const struct cagd_code_harness *h,
                                           long points, long rounding)
{
    struct cagd_code_verdict *v = calloc(1, sizeof *v);
    if (v == NULL)
        abort();
    v->word = h->expect.count > 0 ? CAGD_CODE_SAMPLED : CAGD_CODE_COMPUTED;
    v->patterns = cagd_code_patterns(h);
    unsigned char *seen = calloc((size_t)v->patterns, 1);
    if (seen == NULL)
        abort();
    int variables = cagd_code_variables(h);
    if (variables == 0)
        points = 1;
    else if (points < 4 * v->patterns && v->patterns > 1)
        points = 4 * v->patterns;
    /* as many points as are wanted, of ten times so many tries */
    for (long k = 0; k < 10 * points && v->points < points; k++)
        if (try_point(p, h, v, k, seen))
            break;
    free(seen);
    if (v->word != CAGD_CODE_DIFFERS && v->word != CAGD_CODE_UNDECIDED) {
        if (v->points == 0) {
            v->word = CAGD_CODE_UNDECIDED;
            if (v->hole != NULL)
                snprintf(v->message, sizeof v->message, "%s", v->hole_message);
            else
                snprintf(v->message, sizeof v->message, "no point was found where the preconditions are true");
        } else if (variables > 0 || v->word == CAGD_CODE_ENCLOSED) {
            enum cagd_code_word before = v->word;
            prove(p, h, v);
            if (before == CAGD_CODE_COMPUTED)
                v->word = before;
        }
    }
    if (rounding > 0 && v->word != CAGD_CODE_UNDECIDED)
        search_rounding(p, h, v, rounding);
    return v;
}

void cagd_code_verdict_free(struct cagd_code_verdict *v)
{
    if (v == NULL)
        return;
    for (int k = 0; k < v->paths; k++) {
        cagd_code_point_free(v->path[k].point);
        cagd_code_outcome_free(v->path[k].field);
    }
    for (int k = 0; k < v->worsts; k++)
        cagd_code_point_free(v->worst[k].point);
    cagd_code_point_free(v->point);
    cagd_code_point_free(v->hole);
    cagd_code_outcome_free(v->outcome);
    free(v);
}
