#include "exact/expression/part.h"

#include "core/clock.h"
#include "exact/expression/angle.h"
#include "exact/expression/cell.h"
#include "exact/expression/certify.h"
#include "exact/expression/clauses.h"
#include "exact/expression/compare.h"
#include "exact/expression/find.h"
#include "exact/expression/irrational.h"
#include "exact/expression/refute.h"
#include "exact/expression/sign.h"
#include "exact/expression/suppose.h"
#include "exact/record/trace.h"
#include "exact/words.h"

#include <string.h>

enum { MOST_DIVISORS = 24, TRIED_NUMBERS = 12, MOST_TRIED = 3 };

static void begin(const cagd_run *r, const cagd_part *p, cagd_context *c)
{
    *c = (cagd_context){.scope = r->scope, .premise = r->premise, .in_field = 1, .steps = CAGD_USUAL_STEPS};
    c->untied = r->untied, c->has_roots = 1, c->until = r->until;
    c->whole_angles = r->out->whole_angles = !cagd_has_half_angles(r->scope, r->statement);
    for (int k = 0; k < r->wholes; k++)
        cagd_bind(c, r->chosen[k].name, cagd_value_constant(r->chosen[k].value));
    memcpy(c->piece, p->piece, sizeof p->piece);
    c->pieces = p->pieces;
    if (r->parameter != NULL) { /* it is a variable of every case, the same one */
        cagd_tree name = {.kind = CAGD_NAME, .head = r->parameter};
        cagd_evaluate(c, &name);
    }
    for (int k = 0; k < p->numbers; k++) {
        cagd_binding *b = cagd_bind(c, p->number[k].name, cagd_value_constant(p->number[k].value));
        if (b != NULL)
            b->variable = p->of_number[k];
    }
    for (int k = 0; k < p->cuts; k++)
        cagd_cut_cell(c, &p->cut[k]);
}

/* ---- parts of a part ----------------------------------------------------------------------------------- */

static void put_number(cagd_part *p, const char *key, const cagd_variable *v, num_q at)
{
    p->of_number[p->numbers] = v;
    p->number[p->numbers++] = (cagd_given){key, at, NULL};
}

/* The variable `key` below the number, at it, and above it. */
static cagd_answer split(cagd_run *r, const cagd_part *p, const char *key, const cagd_variable *v, num_q at)
{
    cagd_answer answer = CAGD_HOLDS;
    if (r->into != NULL) {
        if (r->out->why == NULL)
            r->out->why = "a condition that depends on variables";
        return CAGD_UNDECIDED;
    }
    r->out->bounded = 1;
    for (int which = 0; which < 3; which++) {
        cagd_part q = *p;
        if (q.pieces == CAGD_MOST_PIECES || q.numbers == CAGD_MOST_PIECES || cagd_seconds() > r->until)
            return CAGD_UNDECIDED;
        q.touches |= which == 1;
        if (which == 1)
            put_number(&q, key, v, at);
        else
            q.piece[q.pieces++] = (cagd_piece){key, which == 0, at};
        answer = cagd_worse(answer, cagd_decide_part(r, &q));
    }
    return answer;
}

/* The form of the cut below 0, at it, and above it. */
static cagd_answer cut(cagd_run *r, const cagd_part *p, const cagd_cut *where)
{
    cagd_answer answer = CAGD_HOLDS;
    if (r->into != NULL) {
        if (r->out->why == NULL)
            r->out->why = "a condition that depends on variables";
        return CAGD_UNDECIDED;
    }
    for (int sign = 1; sign >= -1 && answer != CAGD_FAILS; sign--) {
        cagd_part *q = region_bytes(sizeof *q);
        if (q == NULL || p->cuts == CAGD_MOST_CUTS_OF_CELL || cagd_seconds() > r->until) {
            r->out->out_of_time |= cagd_seconds() > r->until;
            return CAGD_UNDECIDED;
        }
        *q = *p;
        q->cut[q->cuts] = *where;
        q->cut[q->cuts++].sign = sign;
        q->touches |= sign == 0;
        answer = cagd_worse(answer, cagd_decide_part(r, q));
    }
    return answer;
}

/* The name is one of the roots: that number, or between two numbers that are near. */
static cagd_answer at_roots(cagd_run *r, const cagd_part *p, const cagd_context *c)
{
    cagd_answer answer = CAGD_HOLDS;
    for (int k = 0; k < c->roots && answer != CAGD_FAILS; k++) {
        cagd_part *q = region_bytes(sizeof *q);
        if (q == NULL || p->pieces + 2 > CAGD_MOST_PIECES || p->numbers == CAGD_MOST_PIECES ||
            cagd_seconds() > r->until)
            return CAGD_UNDECIDED;
        *q = *p;
        if (cagd_equal_q(c->root[k].lo, c->root[k].hi)) {
            put_number(q, c->rooted->key, c->rooted->variable, c->root[k].lo);
        } else {
            q->piece[q->pieces++] = (cagd_piece){c->rooted->key, 0, c->root[k].lo};
            q->piece[q->pieces++] = (cagd_piece){c->rooted->key, 1, c->root[k].hi};
        }
        answer = cagd_worse(answer, cagd_decide_part(r, q));
    }
    return answer;
}

/* What is noted in the context: a name that has several values, a name to split, or a form to cut. */
static int is_to_be_cut(const cagd_context *c) { return c->rooted != NULL || c->split != NULL || c->has_cut; }
static cagd_answer cut_further(cagd_run *r, const cagd_part *p, const cagd_context *c)
{
    if (c->rooted != NULL)
        return at_roots(r, p, c);
    const cagd_binding *b = c->split != NULL ? cagd_binding_of((cagd_context *)c, c->split) : NULL;
    return c->split != NULL ? split(r, p, c->split, b != NULL ? b->variable : NULL, c->split_at) : cut(r, p, &c->cut);
}

/* ---- what is said, in one part --------------------------------------------------------------------------- */

/* The numbers of the part are within what was declared of their names; 0 where one is not. */
static int limit_numbers(cagd_context *c)
{
    for (int k = 0; k < c->count; k++) {
        const cagd_variable *v = c->binding[k].variable;
        if (c->binding[k].unknown || c->binding[k].solved || v == NULL || v->whole)
            continue;
        for (int high = 0; high < 2; high++) {
            const cagd_tree *end = high ? v->high : v->low;
            cagd_value d = end != NULL ? cagd_value_sub(c->binding[k].value, cagd_evaluate(c, end)) : cagd_value_int(0);
            if (end == NULL || region_faults != 0)
                continue;
            int strict = high ? v->high_open : v->low_open;
            cagd_limit_cell(c, high ? neg_f(cagd_in_field(d)) : cagd_in_field(d), strict);
        }
    }
    return !c->is_empty;
}

/* An empty piece has no numbers. */
static int is_empty(cagd_context *c)
{
    cagd_suppose_for_names(c);
    if (cagd_cell_is_empty(c))
        return 1;
    for (int k = 0; k < c->count; k++) {
        const cagd_binding *b = &c->binding[k];
        int order = b->unknown && b->has_low && b->has_high ? cagd_compare_q(b->low, b->high) : -1;
        if (order > 0 || (order == 0 && (b->low_open || b->high_open)))
            return 1;
    }
    return 0;
}

/* A chain of relations; *cuts where it is to be looked at in parts. */
static cagd_answer decide_chain(cagd_run *r, cagd_context *c, const cagd_tree *t, int *cuts)
{
    cagd_answer answer = CAGD_HOLDS;
    cagd_value left = cagd_evaluate(c, t->at[0]);
    for (int k = 0; k + 1 < t->count && region_faults == 0 && answer != CAGD_FAILS; k++) {
        cagd_value right = cagd_evaluate(c, t->at[k + 1]);
        int empty = region_faults != 0 || is_empty(c);
        if (!empty && !is_to_be_cut(c) && cagd_has_equality(c)) {
            *cuts = 1;
            return CAGD_UNDECIDED;
        }
        if (!empty && r->take != NULL)
            cagd_note_step(r, c, t->relation[k], left, right);
        cagd_trace_pause();
        if (!empty)
            answer = cagd_worse(answer, cagd_compared(r, c, t, k, left, right));
        cagd_trace_resume();
        left = right;
    }
    return answer;
}

/* One of several relations of two sides. */
static int is_alternative(const cagd_tree *t)
{
    int is = t->kind == CAGD_ANY && t->count <= CAGD_MOST_LITERALS;
    for (int k = 0; k < t->count && is; k++)
        is = t->at[k]->kind == CAGD_RELATION && t->at[k]->count == 2;
    return is;
}

/* Any other truth: it is decided in each part of the cell in which its relations are; what decides none of them is a fault. */
static cagd_answer decide_truth(cagd_run *r, cagd_context *c, const cagd_tree *t)
{
    r->unnoted = 1;
    if (r->into != NULL)
        return is_alternative(t) ? cagd_collect_clause(r, c, t)
                                 : cagd_note_undecided(r, c, "a relation that is not understood with :find:");
    int is = cagd_truth(c, t);
    if (is < 0 && region_faults == 0 && !is_to_be_cut(c))
        return cagd_note_undecided(r, c, "a condition that depends on variables");
    if (is < 0)
        region_faults |= FAULT_UNABLE;
    if (region_faults != 0 || is_empty(c))
        return CAGD_HOLDS;
    r->out->comparisons++;
    r->out->bounded = 1;
    cagd_weaken(r->out, CAGD_BY_DECISION);
    return is == 1 ? CAGD_HOLDS : cagd_refuted_at(r, c, t, -1, NULL);
}

/* ---- what a part leaves out ------------------------------------------------------------------------------ */

/* Whether both sides of every relation are continuous, as functions without cases are, and it is one that limits keep. */
static int keeps_limits(const cagd_run *r, const cagd_context *c)
{
    int keeps = r->premise == NULL && r->scope->condition_count == 0 && !c->used_bounds;
    for (int m = 0; m < (r->claim->kind == CAGD_ALL ? r->claim->count : 1); m++) {
        const cagd_tree *t = r->claim->kind == CAGD_ALL ? r->claim->at[m] : r->claim;
        keeps = keeps && t->kind == CAGD_RELATION;
        for (int k = 0; keeps && k + 1 < t->count; k++)
            keeps = t->relation[k] == CAGD_EQUAL || t->relation[k] == CAGD_LESS_OR_EQUAL ||
                    t->relation[k] == CAGD_GREATER_OR_EQUAL;
    }
    return keeps;
}

/* What the angles and circles of the part leave out, with the numbers that it has there.  Where limits are kept it is looked at for values
 * that are not there, and is no weaker evidence. */
static cagd_answer decide_apart(cagd_run *r, const cagd_part *p, const cagd_context *c)
{
    cagd_strength strength = r->out->strength;
    int kept = keeps_limits(r, c);
    cagd_answer answer = CAGD_HOLDS;
    for (int k = 0; k < c->aparts && answer != CAGD_FAILS; k++) {
        cagd_part *q = region_bytes(sizeof *q);
        if (q == NULL || p->numbers + 2 > CAGD_MOST_PIECES || cagd_seconds() > r->until)
            return CAGD_UNDECIDED;
        *q = *p;
        q->touches = 1;
        for (int m = 0; m < c->apart[k].count; m++)
            put_number(q, c->apart[k].key[m], c->apart[k].variable[m], c->apart[k].value[m]);
        q->apart += c->apart[k].count;
        answer = cagd_worse(answer, cagd_decide_part(r, q));
    }
    if (kept && c->aparts > 0 && answer == CAGD_HOLDS)
        r->out->strength = strength;
    return answer;
}

/* ---- numbers ----------------------------------------------------------------------------------------------- */

/* Whether it is false for some of a few choices of numbers for all names: roots, which were no functions, are numbers there, too. */
static int is_false_for_numbers(cagd_run *r, const cagd_part *p, const cagd_context *c)
{
    int is = 0, unknown = 0;
    for (int m = 0; m < c->count; m++)
        unknown += c->binding[m].unknown && !c->binding[m].has_root;
    if (!(c->met_root || c->ties > 0) || r->into != NULL || r->take != NULL || unknown == 0 || p->tried == MOST_TRIED ||
        p->numbers + unknown > CAGD_MOST_PIECES)
        return 0;
    cagd_finding *before = region_bytes(sizeof *before);
    if (before != NULL)
        *before = *r->out;
    const cagd_run run = *r;
    double now = cagd_seconds(), until = now + (r->until - now) / 8; /* most of the time is for other ways */
    int rounds = p->tried == 0 ? TRIED_NUMBERS : 2;
    for (int round = 0; before != NULL && round < rounds && !is && cagd_seconds() < until; round++) {
        cagd_part *q = region_bytes(sizeof *q);
        num_q value[CAGD_MOST_UNKNOWNS];
        if (q == NULL)
            return 0;
        *q = *p;
        q->tried++;
        r->until = until;
        cagd_choose_numbers(c, round, value);
        for (int m = 0; m < c->count; m++)
            if (c->binding[m].unknown && !c->binding[m].has_root)
                put_number(q, c->binding[m].key, c->binding[m].variable, value[m]);
        is = cagd_decide_part(r, q) == CAGD_FAILS;
        region_faults &= FAULT_MEMORY | FAULT_CROWDED;
        if (!is) /* as if it had not been tried */
            *r = run, *r->out = *before;
    }
    return is;
}

/* ---- one part -------------------------------------------------------------------------------------------- */

/* Whether some divisor may be 0: it is not seen that it cannot.  Those of a parameter alone are looked at with that (find.h). */
static int divides_by_0(const cagd_run *r, cagd_context *c)
{
    const cagd_binding *parameter = r->into != NULL ? cagd_binding_of(c, r->parameter) : NULL;
    int can_be_zero = 0;
    for (int i = 0; i < c->divisors && !can_be_zero; i++) {
        if (parameter != NULL &&
            is_constant_f(div_f(c->divisor[i], cagd_factor_of_parameter(c->divisor[i], parameter->value.f)), NULL))
            continue;
        can_be_zero = (cagd_signs(c, cagd_value_f(c->divisor[i])) & CAGD_CAN_BE_ZERO) != 0 || region_faults != 0;
        region_faults &= FAULT_MEMORY | FAULT_CROWDED;
    }
    return can_be_zero;
}

/* The names that stand for all numbers; an angle, too, whose tangent is a number of the part, by a condition. */
static void note_names(cagd_finding *f, const cagd_context *c)
{
    for (int k = 0; k < c->count; k++) {
        const cagd_binding *b = &c->binding[k];
        const char *name = b->angle != NULL ? b->angle : b->key;
        int known = (!b->unknown && !b->solved && b->angle == NULL) || b->hidden || name[0] == '\0' ||
                    f->names == CAGD_MOST_UNKNOWNS;
        for (int m = 0; m < f->names; m++)
            known |= strcmp(f->name[m], name) == 0;
        if (!known)
            f->name[f->names++] = name;
    }
}

cagd_answer cagd_decide_part(cagd_run *r, const cagd_part *p)
{
    cagd_context *c = region_bytes(sizeof *c);
    if (c == NULL)
        return CAGD_UNDECIDED;
    begin(r, p, c);
    r->out->pieces++;
    r->unnoted |= p->pieces > 0 || p->numbers > p->apart || p->cuts > 0 || r->premise != NULL;
    int is = region_faults == 0 ? cagd_suppose_conditions(c) : 1;
    if (region_faults & (FAULT_CROWDED | FAULT_MEMORY))
        return CAGD_UNDECIDED;
    if (!c->scope->zero_over_zero && r->take == NULL && !r->quick && !r->out->leaves_out_poles) {
        c->divisor = cagd_region_array(MOST_DIVISORS, 1, sizeof *c->divisor);
        c->most_divisors = c->divisor != NULL ? MOST_DIVISORS : 0, c->tells_poles = 1;
    }
    r->ties += c->ties;
    if (!limit_numbers(c))
        return CAGD_HOLDS;
    if (is == 0 || is_empty(c))
        return decide_apart(r, p, c);
    if (is < 0)
        return cut_further(r, p, c);
    cagd_answer answer = CAGD_HOLDS;
    const cagd_tree *claim = r->claim;
    int chains = claim->kind == CAGD_ALL ? claim->count : 1;
    for (int m = 0; m < chains && answer != CAGD_FAILS; m++) {
        const cagd_tree *t = claim->kind == CAGD_ALL ? claim->at[m] : claim;
        int cuts = 0;
        cagd_answer one = t->kind == CAGD_RELATION ? decide_chain(r, c, t, &cuts) : decide_truth(r, c, t);
        if (region_faults & (FAULT_CROWDED | FAULT_MEMORY))
            return CAGD_UNDECIDED;
        if (cuts || (region_faults != 0 && is_to_be_cut(c))) {
            region_faults = 0;
            return is_empty(c) ? decide_apart(r, p, c) : cut_further(r, p, c);
        }
        if (region_faults == FAULT_UNDEFINED && p->touches) { /* it is said of where both sides are defined */
            region_faults = 0;
            r->out->leaves_out_poles = 1;
            continue;
        }
        if (region_faults != 0) {
            r->undefined |= (region_faults & FAULT_UNDEFINED) != 0;
            region_faults = 0;
            if (is_empty(c))
                return decide_apart(r, p, c);
            cagd_answer other = cagd_note_undecided(r, c, "a value that is not computed");
            return is_false_for_numbers(r, p, c) ? CAGD_FAILS : other;
        }
        answer = cagd_worse(answer, one);
    }
    if (answer == CAGD_UNDECIDED && is_false_for_numbers(r, p, c))
        return CAGD_FAILS;
    r->out->bounded |= c->used_bounds;
    r->out->leaves_out_poles |= c->omits_poles;
    r->out->one_sided |= c->one_sided;
    for (int k = 0; k < c->sums.count; k++)
        cagd_note_sum(&r->out->sums, c->sums.sum[k], c->sums.had_terms[k]);
    if (answer == CAGD_HOLDS && !r->quick && !r->out->leaves_out_poles)
        r->out->leaves_out_poles = divides_by_0(r, c);
    note_names(r->out, c);
    return answer == CAGD_FAILS ? answer : cagd_worse(answer, decide_apart(r, p, c));
}
