#include "chapters/frame/run.h"

#include "chapters/frame/case.h"
#include "chapters/frame/judge.h"
#include "exact/number/parallel.h"
#include "exact/number/region.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* ---- one case --------------------------------------------------------------------------------- */

/* FNV-1a of the claim's name: its data depend on nothing else. */
static uint64_t seed_of(const char *name)
{
    uint64_t h = 14695981039346656037u;
    for (; *name; name++)
        h = (h ^ (unsigned char)*name) * 1099511628211u;
    return h;
}

void forget_exhibits(exhibit *shown, int count)
{
    for (int k = 0; k < count; k++) {
        free(shown[k].name);
        free(shown[k].value);
    }
    free(shown);
}

/* How many cases a claim has in a number type: every degree once where a case settles its degree,
 * otherwise as many random instances as the depth asks. */
static int cases_of(const struct plan *p)
{
    int degrees = p->claim->degree_high - p->claim->degree_low + 1;
    if (p->claim->kind != IDENTITY || p->type == FIELD_TYPE)
        return degrees;
    int wanted = p->deep ? 1000 : p->type == INTERVAL_TYPE ? 12 : 24;
    return wanted > degrees ? wanted : degrees;
}

static int degree_of(const struct plan *p, int k)
{
    const claim *c = p->claim;
    int high = c->kind != IDENTITY || p->type == FIELD_TYPE ? c->degree_high : c->degree_sampled;
    return c->degree_low + k % (high - c->degree_low + 1);
}

/* The field starts small and grows on demand. */
trial run_case(const struct plan *p, int k, int planted, char **variables, char **positive)
{
    trial T;
    for (int room = 12;; room = room * 2 < FIELD_MAX_VARIABLES ? room * 2 : FIELD_MAX_VARIABLES) {
        uint64_t seed = seed_of(p->claim->name) + (uint64_t)k;
        T = (trial){.seed = seed, .state = seed, .degree = degree_of(p, k), .planted = planted, .deep = p->deep};
        region_mark mark = region_open();
        if (p->type == FIELD_TYPE)
            field_open(room);
        region_faults = 0;
        p->claim->body[p->type](&T);
        int again = (region_faults & FAULT_CROWDED) && room < FIELD_MAX_VARIABLES;
        if (variables != NULL && !again) {
            *variables = strdup(p->type == FIELD_TYPE ? field_variables() : "");
            *positive = strdup(T.positive != NULL ? T.positive : "");
        }
        T.positive = NULL;
        region_drop(mark);
        if (!again)
            return T;
        cagd_trace_again();
        forget_exhibits(T.shown, T.exhibits);
    }
}

/* Undefined, unable and false are three answers; a case that compared nothing fails. */
static outcome judged(trial *T)
{
    if (region_faults & FAULT_UNDEFINED) {
        show_text(T, "undefined", "a division by zero");
        return FAILS;
    }
    if (T->compared == 0) {
        show_text(T, "empty", "nothing was compared");
        return FAILS;
    }
    if (T->outcome == HOLDS && (region_faults & (FAULT_UNABLE | FAULT_CROWDED)))
        return UNDECIDED;
    return T->outcome;
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ---- one claim in one number type --------------------------------------------------------------- */

static type_result judge_type(const struct plan *p)
{
    double start = now();
    int cases = cases_of(p), genuine = 0;
    type_result r = {.ran = 1, .outcome = HOLDS, .degree_low = p->claim->degree_low};
    for (int k = 0; k < cases && r.outcome != FAILS; k++) {
        char *variables = NULL, *positive = NULL;
        trial T = run_case(p, k, 0, &variables, &positive);
        outcome o = judged(&T);
        genuine = o == FAILS && region_faults == 0 && T.compared > 0;
        r.faults |= region_faults;
        r.cases++;
        r.compared += T.compared;
        if (T.worst > r.worst)
            r.worst = T.worst;
        if (T.degree > r.degree_high)
            r.degree_high = T.degree;
        free(r.variables);
        free(r.positive);
        r.variables = variables, r.positive = positive;
        if (k == 0 || o == FAILS) {
            forget_exhibits(r.shown, r.exhibits);
            r.shown = T.shown, r.exhibits = T.exhibits, r.seed = T.seed;
        } else {
            forget_exhibits(T.shown, T.exhibits);
        }
        if (o != HOLDS)
            r.outcome = o;
    }
    /* A counterexample must fail by comparison, not by trouble; and its control, the same computation
     * with the right formula, must hold.  Any other claim's control must fail by comparison. */
    int refutes = p->claim->kind == COUNTEREXAMPLE;
    if (refutes && r.outcome == FAILS && !genuine)
        r.outcome = UNDECIDED;
    r.control_caught = refutes;
    for (int k = 0; k < cases; k++) {
        trial T = run_case(p, k, 1, NULL, NULL);
        outcome o = judged(&T);
        int by_comparison = region_faults == 0 && T.compared > 0;
        forget_exhibits(T.shown, T.exhibits);
        if (refutes && (o == FAILS || !by_comparison))
            r.control_caught = 0;
        if (!refutes && o == FAILS && by_comparison) {
            r.control_caught = 1;
            break;
        }
    }
    r.seconds = now() - start;
    return r;
}

static evidence evidence_of(const claim *c, number_type t)
{
    static const evidence by_type[NUMBER_TYPES] = {PROVED, SAMPLED, ENCLOSED, MEASURED};
    return c->kind == IDENTITY ? by_type[t] : DECIDED;
}

static int is_word(const char *word, size_t n, const char *words)
{
    for (size_t m; *words != '\0'; words += m + (words[m] == ' ')) {
        m = strcspn(words, " ");
        if (m == n && strncmp(words, word, n) == 0)
            return 1;
    }
    return 0;
}

static int has_index(const char *letters, int index, const char *names)
{
    char name[FIELD_MAX_NAME + 16];
    int n = snprintf(name, sizeof name, "%s%d", letters, index);
    return is_word(name, (size_t)n, names);
}

/* "t w0 R0 w1 w3" -> "t, w0..w1, w3, R0": the variables by their letters. */
static char *put_variables(char *at, const char *names)
{
    const char *all = names;
    char letters[FIELD_MAX_VARIABLES][FIELD_MAX_NAME + 1];
    int low[FIELD_MAX_VARIABLES], high[FIELD_MAX_VARIABLES], count = 0;
    while (*names != '\0') {
        size_t n = strcspn(names, " "), stem = strcspn(names, "0123456789 ");
        int index = stem < n ? atoi(names + stem) : -1, k = 0;
        while (k < count &&
               ((low[k] < 0) != (index < 0) || strlen(letters[k]) != stem || strncmp(letters[k], names, stem) != 0))
            k++;
        if (k == count) {
            snprintf(letters[count], sizeof letters[0], "%.*s", (int)stem, names);
            low[count] = high[count] = index;
            count++;
        }
        low[k] = index < low[k] ? index : low[k];
        high[k] = index > high[k] ? index : high[k];
        names += n + (names[n] == ' ');
    }
    for (int k = 0; k < count; k++) {
        if (low[k] < 0)
            at += sprintf(at, "%s%s", k > 0 ? ", " : "", letters[k]);
        for (int first = low[k], last; first >= 0 && first <= high[k]; first = last + 1) {
            for (last = first; has_index(letters[k], last + 1, all);)
                last++;
            at += sprintf(at, "%s%s%d", k > 0 || first > low[k] ? ", " : "", letters[k], first);
            if (last > first)
                at += sprintf(at, "..%s%d", letters[k], last);
            while (last < high[k] && !has_index(letters[k], last + 1, all))
                last++;
        }
    }
    return at;
}

/* "every value of t, R0..R3 and every positive value of w0..w3": the variables of b, those apart that were
 * taken to be positive. */
static char *put_range(char *at, const type_result *b)
{
    char *free_ones = calloc(strlen(b->variables) + 2, 1), *end = free_ones;
    if (free_ones == NULL)
        abort();
    for (const char *name = b->variables; *name != '\0'; name += strspn(name, " ")) {
        size_t n = strcspn(name, " ");
        if (!is_word(name, n, b->positive))
            end += sprintf(end, "%s%.*s", end > free_ones ? " " : "", (int)n, name);
        name += n;
    }
    if (free_ones[0] != '\0')
        at = put_variables(at + sprintf(at, "every value of "), free_ones);
    if (b->positive[0] != '\0')
        at = put_variables(at + sprintf(at, "%severy positive value of ", free_ones[0] != '\0' ? " and " : ""),
                           b->positive);
    free(free_ones);
    return at;
}

static char *scope_of(const claim_result *r)
{
    const claim *c = r->claim;
    for (number_type t = 0; t < NUMBER_TYPES; t++) {
        const type_result *b = &r->by[t];
        if (!b->ran || evidence_of(c, t) != r->evidence)
            continue;
        size_t room = 160 + strlen(c->scope) + (b->variables != NULL ? 3 * strlen(b->variables) : 0);
        char *s = malloc(room), *at = s;
        if (s == NULL)
            abort();
        *s = '\0';
        if (c->all_degrees)
            at += sprintf(at, "all n");
        else if (b->degree_high > 0)
            at +=
                sprintf(at, b->degree_low == b->degree_high ? "n = %d" : "n = %d to %d", b->degree_low, b->degree_high);
        if (c->scope[0] != '\0')
            at += sprintf(at, "%s%s", at > s ? "; " : "", c->scope);
        if (r->evidence == PROVED && b->variables != NULL && b->variables[0] != '\0')
            put_range(at + sprintf(at, "%s", at > s ? "; " : ""), b);
        else if (r->evidence == SAMPLED || r->evidence == MEASURED || r->evidence == ENCLOSED)
            sprintf(at, "%s%d instances", at > s ? "; " : "", b->cases);
        else if (at == s)
            sprintf(at, "the stated instance");
        return s;
    }
    return strdup("");
}

static void conclude(claim_result *r)
{
    const claim *c = r->claim;
    outcome wanted = c->kind == COUNTEREXAMPLE ? FAILS : HOLDS;
    r->as_expected = 1;
    r->outcome = UNDECIDED;
    for (number_type t = 0; t < NUMBER_TYPES; t++) {
        const type_result *b = &r->by[t];
        if (!b->ran)
            continue;
        int cannot_confirm = t == INTERVAL_TYPE && b->outcome == UNDECIDED && wanted == HOLDS;
        if ((b->outcome != wanted && !cannot_confirm) || !b->control_caught)
            r->as_expected = 0;
        if ((b->outcome == wanted || cannot_confirm) && evidence_of(c, t) > r->evidence)
            r->evidence = evidence_of(c, t);
        if (b->outcome == FAILS)
            r->outcome = FAILS;
    }
    if (r->as_expected)
        r->outcome = wanted;
    else
        r->evidence = NO_EVIDENCE;
    r->scope = scope_of(r);
}

/* ---- all claims, on several threads ------------------------------------------------------------- */

struct task {
    struct plan plan;
    type_result *result;
};
struct agenda {
    struct task *tasks;
    int done, total;
    pthread_mutex_t lock; /* of `done` and the report of progress */
    const run_options *options;
};

static void judge_task(void *context, int k)
{
    struct agenda *a = context;
    *a->tasks[k].result = judge_type(&a->tasks[k].plan);
    pthread_mutex_lock(&a->lock);
    a->done++;
    if (a->options->progress != NULL)
        a->options->progress(a->options->context, a->done, a->total, a->tasks[k].plan.claim->name);
    pthread_mutex_unlock(&a->lock);
}

claim_result *judge_claims(const claim *const list[], int count, const run_options *options)
{
    claim_result *results = calloc((size_t)count + 1, sizeof *results);
    struct task *tasks = calloc((size_t)count * NUMBER_TYPES + 1, sizeof *tasks);
    int total = 0;
    if (results == NULL || tasks == NULL)
        abort();
    for (int k = 0; k < count; k++) {
        results[k].claim = list[k];
        for (number_type t = 0; t < NUMBER_TYPES; t++)
            if (list[k]->body[t] != NULL)
                tasks[total++] = (struct task){{list[k], t, options->deep}, &results[k].by[t]};
    }
    struct agenda agenda = {.tasks = tasks, .total = total, .options = options};
    pthread_mutex_init(&agenda.lock, NULL);
    cagd_in_parallel(options->jobs, total, judge_task, &agenda);
    pthread_mutex_destroy(&agenda.lock);
    free(tasks);
    for (int k = 0; k < count; k++)
        conclude(&results[k]);
    return results;
}

void free_results(claim_result *results, int count)
{
    for (int k = 0; k < count; k++) {
        for (number_type t = 0; t < NUMBER_TYPES; t++) {
            forget_exhibits(results[k].by[t].shown, results[k].by[t].exhibits);
            free(results[k].by[t].variables);
            free(results[k].by[t].positive);
        }
        free(results[k].scope);
    }
    free(results);
}
