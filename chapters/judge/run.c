#include "chapters/judge/run.h"

#include "chapters/judge/case.h"
#include "chapters/judge/scope.h"
#include "chapters/judge/witness.h"
#include "chapters/judge/words.h"
#include "core/clock.h"
#include "exact/number/parallel.h"
#include "exact/number/region.h"
#include "exact/record/trace.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

/* The field and decisions settle a degree; instances are sampled of larger ones, too. */
static int highest_degree(const struct plan *p)
{
    const claim *c = p->claim;
    return c->kind != IDENTITY || p->type == FIELD_TYPE ? c->degree_high : c->degree_sampled;
}

/* How many cases a claim has in a number type: every degree once where a case settles its degree,
 * otherwise as many random instances as the depth asks, and at least one of every degree. */
static int cases_of(const struct plan *p)
{
    int degrees = highest_degree(p) - p->claim->degree_low + 1;
    if (p->claim->kind != IDENTITY || p->type == FIELD_TYPE)
        return degrees;
    int wanted = p->deep ? 1000 : p->type == INTERVAL_TYPE ? 12 : 24;
    return wanted > degrees ? wanted : degrees;
}

static int degree_of(const struct plan *p, int k)
{
    int low = p->claim->degree_low;
    return low + k % (highest_degree(p) - low + 1);
}

/* The field starts small and grows on demand. */
trial run_case(const struct plan *p, int k, int planted, char **variables, char **positive)
{
    trial T;
    for (int room = 12;; room = room * 2 < FIELD_MAX_VARIABLES ? room * 2 : FIELD_MAX_VARIABLES) {
        uint64_t seed = seed_of(p->claim->name) + (uint64_t)k;
        T = (trial){.claim = p->claim,
                    .seed = seed,
                    .state = seed,
                    .degree = degree_of(p, k),
                    .deep = p->deep,
                    .small = p->small,
                    .planted = planted,
                    .faulty = planted != (p->claim->kind == COUNTEREXAMPLE)};
        region_mark mark = region_open();
        if (p->type == FIELD_TYPE)
            field_open(room);
        region_faults = 0;
        p->claim->body[p->type](&T);
        int again = (region_faults & FAULT_CROWDED) && room < FIELD_MAX_VARIABLES;
        if (variables != NULL && !again) {
            *variables = strdup(p->type == FIELD_TYPE ? field_variables() : "");
            *positive = strdup(T.positive != NULL ? T.positive : "");
            if (*variables == NULL || *positive == NULL)
                abort();
        }
        T.positive = NULL;
        region_drop(mark);
        if (!again)
            return T;
        cagd_trace_again();
        forget_exhibits(T.shown, T.exhibits);
    }
}

outcome judged_case(trial *T)
{
    look_for_unused(T);
    if (T->mistaken)
        return FAILS;
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

/* ---- one claim in one number type --------------------------------------------------------------- */

/* Adds to a list of words, separated by blanks, those of another one that it lacks.  Frees the other one. */
static void add_words(char **list, char *more)
{
    if (*list == NULL) {
        *list = more;
        return;
    }
    for (const char *word = more + strspn(more, " "); *word != '\0'; word += strspn(word, " ")) {
        size_t n = strcspn(word, " "), had = strlen(*list);
        int known = 0;
        for (const char *old = *list; *old != '\0' && !known; old += strspn(old, " ")) {
            size_t m = strcspn(old, " ");
            known = m == n && strncmp(old, word, n) == 0;
            old += m;
        }
        if (!known) {
            char *longer = realloc(*list, had + n + 2);
            if (longer == NULL)
                abort();
            sprintf(longer + had, "%s%.*s", had > 0 ? " " : "", (int)n, word);
            *list = longer;
        }
        word += n;
    }
    free(more);
}

void show_degree(const claim *c, trial *T)
{
    const char *letter = c->letter != NULL && c->letter[0] != '\0' ? c->letter : "n";
    for (int k = 0; k < T->exhibits; k++)
        if (strcmp(T->shown[k].name, letter) == 0)
            return;
    if (c->degree_high > 0)
        show_text(T, letter, "%d", T->degree);
}

static type_result judge_type(const struct plan *p)
{
    double start = cagd_seconds();
    int cases = cases_of(p), genuine = 0;
    type_result r = {.ran = 1, .outcome = HOLDS, .degree_low = p->claim->degree_low};
    for (int k = 0; k < cases && r.outcome != FAILS; k++) {
        char *variables = NULL, *positive = NULL;
        trial T = run_case(p, k, 0, &variables, &positive);
        outcome o = judged_case(&T);
        if (o == FAILS && p->claim->kind != COUNTEREXAMPLE)
            show_case(p, k, &T);
        genuine = o == FAILS && region_faults == 0 && T.compared > 0 && !T.mistaken;
        r.faults |= region_faults;
        r.cases++;
        r.compared += T.compared;
        if (!(T.worst <= r.worst)) /* the worst is what is no number, with which the cases end */
            r.worst = T.worst;
        if (T.degree > r.degree_high)
            r.degree_high = T.degree;
        add_words(&r.variables, variables);
        add_words(&r.positive, positive);
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
        outcome o = judged_case(&T);
        int by_comparison = region_faults == 0 && T.compared > 0 && !T.mistaken;
        forget_exhibits(T.shown, T.exhibits);
        if (refutes && (o == FAILS || !by_comparison))
            r.control_caught = 0;
        if (!refutes && o == FAILS && by_comparison) {
            r.control_caught = 1;
            break;
        }
    }
    r.seconds = cagd_seconds() - start;
    return r;
}

evidence evidence_of(const claim *c, number_type t)
{
    static const evidence by_type[NUMBER_TYPES] = {PROVED, SAMPLED, ENCLOSED, MEASURED};
    return c->kind == IDENTITY ? by_type[t] : DECIDED;
}

static void conclude(claim_result *r)
{
    const claim *c = r->claim;
    outcome wanted = c->kind == COUNTEREXAMPLE ? FAILS : HOLDS;
    int types = 0;
    r->as_expected = 1;
    r->outcome = UNDECIDED;
    for (number_type t = 0; t < NUMBER_TYPES; t++) {
        const type_result *b = &r->by[t];
        if (!b->ran)
            continue;
        types++;
        /* Intervals that meet confirm nothing, and refute nothing; what was not computed is another matter. */
        int cannot_confirm = t == INTERVAL_TYPE && b->outcome == UNDECIDED && wanted == HOLDS && b->faults == 0;
        if ((b->outcome != wanted && !cannot_confirm) || !b->control_caught)
            r->as_expected = 0;
        const evidence known = cannot_confirm ? ENCLOSED : evidence_of(c, t);
        if ((b->outcome == wanted || cannot_confirm) && known > r->computed)
            r->computed = known;
        if (b->outcome == FAILS)
            r->outcome = FAILS;
    }
    if (types == 0)
        r->as_expected = 0; /* what was not run is not known */
    if (r->as_expected)
        r->outcome = wanted;
    else
        r->computed = NO_EVIDENCE;
    int needs_words = c->argued != NULL && c->argued[0] != '\0' && c->argued_for[0] == '\0';
    r->evidence = needs_words && r->computed > BY_ARGUMENT ? BY_ARGUMENT : r->computed;
    scope s = scope_of(r);
    r->scope = scope_words(&s, c->letter != NULL && c->letter[0] != '\0' ? c->letter : "n");
    free_scope(&s);
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
                tasks[total++] = (struct task){{list[k], t, options->deep, NULL}, &results[k].by[t]};
    }
    struct agenda agenda = {.tasks = tasks, .total = total, .options = options};
    pthread_mutex_init(&agenda.lock, NULL);
    cagd_in_parallel(options->jobs, total, judge_task, &agenda);
    pthread_mutex_destroy(&agenda.lock);
    free(tasks);
    for (int k = 0; k < count; k++) {
        conclude(&results[k]);
        if (results[k].outcome == FAILS && !results[k].as_expected)
            find_witness(list[k], &results[k].witness, &results[k].witnesses);
    }
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
        forget_exhibits(results[k].witness, results[k].witnesses);
        free(results[k].scope);
    }
    free(results);
}
