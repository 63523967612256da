#include "exact/expression/cases.h"

#include "core/clock.h"
#include "exact/expression/depends.h"
#include "exact/expression/part.h"
#include "exact/number/recorder.h"
#include "exact/record/trace.h"
#include "exact/words.h"

#include <stdio.h>

enum { QUICK_CASES = 16 };

/* The value of an end of a range in the numbers that are chosen already. */
static int end_of_range(cagd_run *r, int level, const cagd_tree *end, long *value)
{
    cagd_context *c = region_bytes(sizeof *c);
    if (c == NULL)
        return 0;
    *c = (cagd_context){.scope = r->scope, .steps = CAGD_USUAL_STEPS};
    for (int k = 0; k < level; k++)
        cagd_bind(c, r->chosen[k].name, cagd_value_q(r->chosen[k].value));
    cagd_value v = cagd_evaluate(c, end);
    int good = region_faults == 0 && cagd_value_is_whole(v, value);
    if (!good) {
        region_faults &= FAULT_MEMORY;
        cagd_note_undecided(r, c, "a range that does not end at whole numbers");
    }
    return good;
}

/* A => B is B where A is supposed; A <=> B is both directions. */
static cagd_answer decide_statement(cagd_run *r, const cagd_tree *t, const cagd_part *all)
{
    cagd_answer answer = CAGD_HOLDS;
    int parts = t->kind == CAGD_ALL ? t->count : t->kind == CAGD_IFF ? 2 : 1;
    for (int m = 0; m < parts && answer != CAGD_FAILS; m++) {
        const cagd_tree *one = t->kind == CAGD_ALL ? t->at[m] : t;
        int pair = one->kind == CAGD_IMPLIES || one->kind == CAGD_IFF;
        if (one->kind == CAGD_IFF && t->kind == CAGD_ALL) {
            answer = cagd_worse(answer, decide_statement(r, one, all));
            continue;
        }
        r->premise = pair ? one->at[m == 1 && t->kind == CAGD_IFF] : NULL;
        r->claim = pair ? one->at[!(m == 1 && t->kind == CAGD_IFF)] : one;
        if (pair && r->into != NULL)
            return cagd_note_undecided(r, &(cagd_context){0}, "an implication is not understood with :find:");
        answer = cagd_worse(answer, cagd_decide_part(r, all));
    }
    return answer;
}

/* The case that was noted goes where it is wanted; 0 where it says too little. */
int cagd_give_case(cagd_run *r)
{
    const char *inputs = cagd_trace_inputs(), *nodes = cagd_trace_nodes(), *steps = cagd_trace_steps();
    return !r->unnoted && region_faults == 0 && inputs != NULL && nodes != NULL && steps != NULL &&
           r->take(r->data, inputs, nodes, steps);
}

static int is_enough(const cagd_finding *f) { return f->has_example || f->cases >= QUICK_CASES; }

/* The cases of one value of the whole number of that level; 0 where no more are wanted. */
static int decide_number(cagd_run *r, int level, long m)
{
    region_mark mark = region_open();
    int kept = r->out->has_example, why = r->out->why != NULL, names = r->out->names;
    r->chosen[level] = (cagd_given){r->whole[level]->head, from_int_q(m), NULL};
    cagd_decide_cases(r, level + 1);
    /* What was found lives on; a case that found nothing new leaves nothing behind. */
    if (r->into == NULL && r->out->has_example == kept && (r->out->why != NULL) == why && r->out->names == names)
        region_drop(mark);
    return !(r->out->out_of_time || (region_faults & (FAULT_CROWDED | FAULT_MEMORY)) ||
             (r->quick && is_enough(r->out)));
}

/* Each number of a list once. */
static void decide_listed(cagd_run *r, int level, const cagd_variable *v)
{
    long value[CAGD_MOST_CHILDREN];
    for (int k = 0; k < v->listed_count; k++) {
        int is_new = end_of_range(r, level, v->listed[k], &value[k]);
        if (!is_new) {
            r->out->undecided++;
            return;
        }
        for (int m = 0; m < k; m++)
            is_new &= value[m] != value[k];
        if (is_new && !decide_number(r, level, value[k]))
            return;
    }
}

void cagd_decide_cases(cagd_run *r, int level)
{
    if (r->out->out_of_time || (region_faults & (FAULT_CROWDED | FAULT_MEMORY)))
        return;
    if (level == r->wholes) {
        cagd_part all = {0};
        if (cagd_seconds() > r->until) {
            r->out->out_of_time = 1;
            return;
        }
        r->out->cases++;
        if (r->take != NULL)
            cagd_trace_again();
        long before = r->out->comparisons;
        cagd_answer answer = decide_statement(r, r->statement, &all);
        if (r->take != NULL && r->out->comparisons > before && !cagd_give_case(r))
            r->out->out_of_time = 1;
        r->out->failing += answer == CAGD_FAILS;
        r->out->undecided += answer == CAGD_UNDECIDED;
        return;
    }
    const cagd_variable *v = r->whole[level];
    long low, high;
    if (!end_of_range(r, level, v->low, &low) || (v->high != NULL && !end_of_range(r, level, v->high, &high))) {
        r->out->undecided++;
        return;
    }
    if (v->listed != NULL) {
        decide_listed(r, level, v);
        return;
    }
    low += v->low_open + (v->high == NULL ? r->skipped : 0);
    high = v->high != NULL ? high - v->high_open : low + r->taken - 1;
    long step = v->step > 1 ? v->step : 1;
    if (low <= high && (high - low) % step != 0) {
        char text[160];
        int n =
            snprintf(text, sizeof text, "the list of %.20s goes from %ld by steps of %ld: %s%.20s%s%ld is not reached",
                     v->head, low, step, v->high->kind == CAGD_NAME ? "" : "its last number, ",
                     v->high->kind == CAGD_NAME ? v->high->head : "", v->high->kind == CAGD_NAME ? " = " : "", high);
        cagd_note_undecided(r, &(cagd_context){0}, cagd_text_of(text, n));
        r->out->undecided++;
        return;
    }
    for (long m = low; m <= high && decide_number(r, level, m); m += step)
        ;
}

int cagd_has_no_end(const cagd_run *r)
{
    for (int k = 0; k < r->wholes; k++)
        if (r->whole[k]->high == NULL)
            return 1;
    return 0;
}

/* x \ne y: what is proved without it, is proved. */
static int is_inequation(const cagd_tree *t)
{
    return t->kind == CAGD_RELATION && t->count == 2 && t->relation[0] == CAGD_NOT_EQUAL;
}

/* Whether there is one whole number alone, on which no condition depends; then it begins at *low. */
int cagd_has_one_number(cagd_run *r, long *low)
{
    for (int k = 0; k < r->scope->condition_count; k++)
        if (!is_inequation(r->scope->conditions[k]) &&
            cagd_condition_speaks_of(r->scope, r->scope->conditions[k], NULL, r->statement))
            return 0;
    if (r->wholes != 1 || !end_of_range(r, 0, r->whole[0]->low, low))
        return 0;
    *low += r->whole[0]->low_open;
    return 1;
}
