/* decide.c -- see decide.h. */
#include "exact/code/decide.h"

#include "exact/code/conditions.h"

#include "exact/number/rational.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct cagd_code_outcome *run_noting(const struct cagd_code_program *p, const struct cagd_code_harness *h,
                                            const struct cagd_code_point *at, enum cagd_code_numbers numbers,
                                            int certify)
{
    struct cagd_code_job job = {.entry = "cagd_code_entry",
                                .numbers = numbers,
                                .certify = certify,
                                .enclose = !h->refuse_roots,
                                .no_root_variables = h->enclose_roots,
                                .memcpy_moves = h->memcpy_moves,
                                .inputs = at->inputs,
                                .input = at->input};
    struct cagd_code_outcome *o = cagd_code_run(p, &job);
    if (o == NULL)
        abort();
    return o;
}

static struct cagd_code_outcome *run_at(const struct cagd_code_program *p, const struct cagd_code_harness *h,
                                        const struct cagd_code_point *at, enum cagd_code_numbers numbers)
{
    return run_noting(p, h, at, numbers, 0);
}

struct cagd_code_outcome *cagd_code_certify(const struct cagd_code_program *p, const struct cagd_code_harness *h,
                                            const struct cagd_code_path *path)
{
    return run_noting(p, h, path->point, CAGD_CODE_FIELD, 1);
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

/* In the place of a point that was kept because something was computed there. */
static void keep_instead(struct cagd_code_verdict *v, struct cagd_code_point *point, struct cagd_code_outcome *o)
{
    cagd_code_point_free(v->point);
    cagd_code_outcome_free(v->outcome);
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

static void note_overlap(struct cagd_code_verdict *v, const struct cagd_code_outcome *o)
{
    if (v->overlapping_at[0] == 0)
        snprintf(v->overlapping_at, sizeof v->overlapping_at, "%s", o->overlapping_at);
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
        note_overlap(v, o);
        if (!seen[k % v->patterns])
            v->seen++;
        seen[k % v->patterns] = 1;
        if (differs(o)) {
            v->word = CAGD_CODE_DIFFERS;
            keep_instead(v, point, o);
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
        keep_instead(v, point, o);
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
        cagd_code_simplify(path->field);
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

/* ---- all ways ---------------------------------------------------------------------------------------------- */

enum { MOST_LEAVES = 1024, MOST_RUNS = 600 };

/* The runs in the field; those that are no paths of the verdict are ours. */
struct leaves {
    int count, runs;
    struct cagd_code_leaf at[MOST_LEAVES];
    struct cagd_code_outcome *outcome[MOST_LEAVES];
    struct cagd_code_point *point[MOST_LEAVES];
};

static void leave_open(struct cagd_code_verdict *v, const char *why)
{
    v->exhaustive = 0;
    if (v->open[0] == 0)
        snprintf(v->open, sizeof v->open, "%s", why);
}

/* A way that ended with a result: one more path, proved or not. */
static void add_path(const struct cagd_code_program *p, const struct cagd_code_harness *h, struct cagd_code_verdict *v,
                     struct cagd_code_point *point, struct cagd_code_outcome *o)
{
    cagd_code_simplify(o);
    note_overlap(v, o);
    int good = !has(o, CAGD_CODE_DIFFERENT) && !has(o, CAGD_CODE_UNKNOWN);
    v->path[v->paths++] = (struct cagd_code_path){o->path, cagd_code_point_copy(point), o, good};
    v->proved += good;
    if (good)
        return;
    struct cagd_code_outcome *there = run_at(p, h, point, CAGD_CODE_RATIONAL);
    if (!differs(there)) {
        cagd_code_outcome_free(there);
        v->word = CAGD_CODE_SAMPLED;
        if (v->message[0] == 0)
            snprintf(v->message, sizeof v->message,
                     "on a way the two sides are different functions that are equal at its point");
        return;
    }
    v->word = CAGD_CODE_DIFFERS;
    keep_instead(v, cagd_code_point_copy(point), there);
    make_small(p, h, v);
}

/* Something that cannot be carried, or is no memory of its own, on a way that inputs can take: then nothing is proved. */
static void refuse_path(struct cagd_code_verdict *v, struct cagd_code_point *point, struct cagd_code_outcome *o)
{
    say(sizeof v->message, v->message, o);
    v->word = CAGD_CODE_UNDECIDED;
    keep_instead(v, cagd_code_point_copy(point), o);
}

/* Runs the code at the point, which becomes ours: a leaf, unless it takes a way that is known (0). */
static int add_leaf(const struct cagd_code_program *p, const struct cagd_code_harness *h, struct cagd_code_verdict *v,
                    struct leaves *l, struct cagd_code_point *point)
{
    struct cagd_code_outcome *o = run_at(p, h, point, CAGD_CODE_FIELD);
    const struct cagd_code_leaf leaf = {o, point};
    l->runs++;
    for (int k = 0; k < l->count; k++)
        if (cagd_code_is_same_way(&leaf, &l->at[k])) {
            cagd_code_point_free(point);
            cagd_code_outcome_free(o);
            return 0;
        }
    int is_path = o->end == CAGD_CODE_FINISHED, is_refused = o->end == CAGD_CODE_REFUSED || o->end == CAGD_CODE_CRASHED;
    l->at[l->count] = leaf;
    l->outcome[l->count] = is_path || is_refused ? NULL : o;
    l->point[l->count++] = point;
    if (is_path && v->paths == CAGD_CODE_MOST_PATHS) {
        l->outcome[l->count - 1] = o;
        leave_open(v, "there are more ways than are followed");
    } else if (is_path) {
        add_path(p, h, v, point, o);
    } else if (is_refused) {
        refuse_path(v, point, o);
    } else if (o->end == CAGD_CODE_BOUND) {
        leave_open(v, o->message);
    } else if (o->end == CAGD_CODE_UNDEFINED) {
        v->undefined++;
        say(sizeof v->hole_message, v->hole_message, o);
        if (v->hole == NULL)
            v->hole = cagd_code_point_copy(point);
    }
    return 1;
}

static int is_met(const struct leaves *l, int leaf, int k)
{
    for (int j = 0; j < l->count; j++)
        if (cagd_code_branches_off(&l->at[leaf], k, &l->at[j]))
            return 1;
    return 0;
}

/* The other branch of each condition of a leaf: met, taken by no inputs, or taken now. */
static void follow_leaf(const struct cagd_code_program *p, const struct cagd_code_harness *h,
                        struct cagd_code_verdict *v, struct leaves *l, int leaf)
{
    int conditions = cagd_code_count_conditions(l->at[leaf].outcome);
    for (int k = 0; k < conditions && v->word == CAGD_CODE_PROVED; k++) {
        struct cagd_code_point *point = NULL;
        char text[600];
        if (is_met(l, leaf, k))
            continue;
        int found = cagd_code_branch(h, &l->at[leaf], k, &point, sizeof text, text);
        v->closed += found == 0;
        if (found < 0) {
            leave_open(v, text);
        } else if (found == 1 && (l->count == MOST_LEAVES || l->runs == MOST_RUNS)) {
            cagd_code_point_free(point);
            leave_open(v, "there are more ways than are followed");
        } else if (found == 1) {
            int is_new = add_leaf(p, h, v, l, point);
            if (v->word == CAGD_CODE_PROVED &&
                (!is_new || !cagd_code_branches_off(&l->at[leaf], k, &l->at[l->count - 1])))
                leave_open(v, text);
        }
    }
}

/* Of each pattern of equal neighbours there has to be a leaf. */
static void begin_patterns(const struct cagd_code_program *p, const struct cagd_code_harness *h,
                           struct cagd_code_verdict *v, struct leaves *l)
{
    for (long k = 0; v->patterns > 1 && k < v->patterns && v->word == CAGD_CODE_PROVED; k++) {
        struct cagd_code_point *point = cagd_code_point_new(h, k, 0);
        int known = 0;
        for (int j = 0; j < l->count && !known; j++)
            known = cagd_code_is_of_one_pattern(l->at[j].point, point);
        if (known || l->count == MOST_LEAVES) {
            cagd_code_point_free(point);
            if (!known)
                leave_open(v, "there are more patterns of equal neighbours than are followed");
        } else {
            add_leaf(p, h, v, l, point);
        }
    }
}

/* What was proved on the paths that were met becomes proved for all inputs, or it is said which branch is open. */
static void follow_all_ways(const struct cagd_code_program *p, const struct cagd_code_harness *h,
                            struct cagd_code_verdict *v)
{
    struct leaves *l = calloc(1, sizeof *l);
    if (l == NULL)
        abort();
    v->exhaustive = 1;
    for (int k = 0; k < v->paths; k++)
        l->at[l->count++] = (struct cagd_code_leaf){v->path[k].field, v->path[k].point};
    begin_patterns(p, h, v, l);
    for (int k = 0; k < l->count && v->word == CAGD_CODE_PROVED; k++)
        follow_leaf(p, h, v, l, k);
    v->exhaustive = v->exhaustive && v->word == CAGD_CODE_PROVED;
    for (int k = 0; k < l->count; k++) {
        cagd_code_outcome_free(l->outcome[k]);
        cagd_code_point_free(l->point[k]);
    }
    free(l);
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

/* The means over the points that nobody looked for: at the worst ones every other order would look better. */
static void note_orders(struct cagd_code_worst *w, const struct cagd_code_result *r)
{
    int known = isfinite(r->ulps);
    for (int k = 0; k < CAGD_CODE_ORDERS; k++)
        known = known && isfinite(r->in_order[k]);
    if (!known)
        return;
    w->by_chance++;
    w->mean += (r->ulps - w->mean) / (double)w->by_chance;
    for (int k = 0; k < CAGD_CODE_ORDERS; k++)
        w->mean_in_order[k] += (r->in_order[k] - w->mean_in_order[k]) / (double)w->by_chance;
}

static void note_rounding(struct cagd_code_verdict *v, const struct cagd_code_outcome *o,
                          const struct cagd_code_point *point, int by_chance)
{
    if (o->end != CAGD_CODE_FINISHED)
        return;
    v->rounded++;
    v->turned += o->decided_otherwise;
    if (o->decided_otherwise > 0 && v->turned_at[0] == 0)
        snprintf(v->turned_at, sizeof v->turned_at, "%s:%d", o->turned.file, (int)o->turned.line);
    for (const struct cagd_code_result *r = o->results; r != NULL; r = r->next) {
        struct cagd_code_worst *w = worst_of(v, r->name);
        if (w != NULL && by_chance)
            note_orders(w, r);
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
        int by_chance = 1;
        if (k > points / 2 && point->inputs > 0 && v->worsts > 0 && v->worst[k % v->worsts].point != NULL) {
            struct cagd_code_point *near = cagd_code_point_copy(v->worst[k % v->worsts].point);
            int i = (int)(k % near->inputs);
            int count = near->input[i].count > 0 ? near->input[i].count : 1;
            int j = (int)(k / near->inputs % count);
            if (h->input[i].shape == CAGD_CODE_ANY || h->input[i].shape == CAGD_CODE_POSITIVE ||
                h->input[i].shape == CAGD_CODE_BETWEEN)
                cagd_code_point_set(near, i, j, point->input[i].value[j]);
            cagd_code_point_free(point);
            point = near;
            by_chance = 0;
        }
        struct cagd_code_outcome *o = run_at(p, h, point, CAGD_CODE_ROUNDING);
        note_rounding(v, o, point, by_chance);
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
    v->word = h->expect.count + h->known.count + h->printed.count > 0 ? CAGD_CODE_SAMPLED : CAGD_CODE_COMPUTED;
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
            else if (v->word == CAGD_CODE_PROVED)
                follow_all_ways(p, h, v);
        }
    }
    if (rounding > 0 && v->word != CAGD_CODE_UNDECIDED)
        search_rounding(p, h, v, rounding);
    return v;
}

void cagd_code_look_apart(const struct cagd_code_program *noting, const struct cagd_code_harness *h,
                          struct cagd_code_verdict *v)
{
    struct cagd_code_outcome *o = run_at(noting, h, v->point, CAGD_CODE_RATIONAL);
    if (!differs(o)) {
        cagd_code_outcome_free(o);
        return;
    }
    cagd_code_outcome_free(v->outcome);
    v->outcome = o;
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
