#include "exact/expression/check.h"

#include "core/clock.h"
#include "exact/expression/bounds.h"
#include "exact/expression/cases.h"
#include "exact/expression/change.h"
#include "exact/expression/clauses.h"
#include "exact/expression/depends.h"
#include "exact/expression/lift.h"
#include "exact/expression/similar.h"
#include "exact/expression/vacuous.h"
#include "exact/number/recorder.h"
#include "exact/words.h"

#include <string.h>

enum { FURTHER_CASES = 248, MOST_CHANGES = 60 };

/* For the only whole number, or for every choice of several, whose first cases hold. */
static int proved_for_every(cagd_run *r)
{
    long low;
    r->out->for_every = (cagd_has_one_number(r, &low) && cagd_holds_for_every(r->scope, r->statement, r->whole[0], low,
                                                                              CAGD_FIRST_CASES, &r->out->every)) ||
                        cagd_holds_for_every_choice(r->scope, r->statement, r->whole, r->wholes, &r->out->every);
    r->out->strength = r->out->for_every ? CAGD_BY_IDENTITY : r->out->strength;
    return r->out->for_every;
}

/* The cases behind the first ones, of which none fails, in a quarter of the time that is left: whether one fails there. */
static int fails_further(cagd_run *r)
{
    cagd_finding before = *r->out;
    double now = cagd_seconds(), until = r->until;
    r->skipped = CAGD_FIRST_CASES, r->taken = FURTHER_CASES, r->until = now + (until - now) / 4;
    cagd_decide_cases(r, 0);
    r->skipped = 0, r->taken = CAGD_FIRST_CASES, r->until = until;
    if (r->out->has_example)
        return 1;
    *r->out = before;
    return 0;
}

/* What becomes of equalities of higher degree: they make names functions of others (tie.h), or they are left for a decomposition (implied.h), or both. */
enum use_of_ties { TIED, UNTIED, TIED_AND_DECOMPOSED };

static int check_once(const cagd_scope *scope, const cagd_tree *statement, double seconds, int quick,
                      enum use_of_ties use, cagd_finding *out);

/* For every real number in the place of the only whole one, from behind the first cases on. */
static int holds_for_reals(cagd_run *r)
{
    long low;
    cagd_finding *f = region_bytes(sizeof *f);
    if (f == NULL || !cagd_has_one_number(r, &low))
        return 0;
    cagd_scope scope = *r->scope;
    cagd_variable v = *r->whole[0];
    low += CAGD_FIRST_CASES;
    v.whole = v.low_open = 0, v.low = cagd_tree_number(low, v.low->from, v.low->to);
    if (v.low == NULL || !cagd_declare(&scope, v))
        return 0;
    check_once(&scope, r->statement, (r->until - cagd_seconds()) / 4, 0, TIED, f);
    if (f->answer != CAGD_HOLDS || f->leaves_out_poles)
        return 0;
    r->out->for_every = 1, r->out->every = (cagd_every){.real = 1, .from = low, .n = v.head, .k = "", .R = ""};
    cagd_weaken(r->out, f->strength);
    return 1;
}

/* How many equalities of higher degree were used; 0 where some side was not defined. */
static int check_once(const cagd_scope *scope, const cagd_tree *statement, double seconds, int quick,
                      enum use_of_ties use, cagd_finding *out)
{
    cagd_run r = {.scope = scope,
                  .statement = statement,
                  .out = out,
                  .until = cagd_seconds() + seconds,
                  .quick = quick,
                  .taken = CAGD_FIRST_CASES};
    r.untied = use == UNTIED, r.decomposes = use == TIED_AND_DECOMPOSED;
    r.wholes = cagd_whole_numbers(scope, statement, r.whole, CAGD_MOST_WHOLE);
    for (int room = CAGD_FIELD_ROOM;; room = CAGD_FIELD_MAX_VARIABLES) {
        *out = (cagd_finding){.answer = CAGD_UNDECIDED};
        field_open(room);
        if (r.wholes < 0)
            out->why = "more than eight whole numbers", out->undecided = 1;
        else
            cagd_decide_cases(&r, 0);
        unsigned faults = region_faults;
        region_faults = 0;
        if (!(faults & FAULT_CROWDED) || room == CAGD_FIELD_MAX_VARIABLES) {
            if (faults != 0 && out->why == NULL)
                out->why = faults & FAULT_MEMORY ? "there was no memory for it" : "too many variables";
            out->undecided += faults != 0;
            break;
        }
    }
    if (out->undecided == 0 && !out->has_example && !out->out_of_time && !quick && cagd_has_no_end(&r) &&
        !proved_for_every(&r) && !holds_for_reals(&r) && !fails_further(&r)) {
        out->first_alone = 1;
        out->why = "the first cases hold, and for every number it is not proved";
    }
    if (out->comparisons == 0 && out->undecided == 0 && !out->first_alone) {
        out->undecided = 1;
        out->why = out->cases == 0 ? "there is no case: a range is empty" : "what is supposed is never true";
    }
    out->answer = out->has_example                                                                 ? CAGD_FAILS
                  : out->undecided > 0 || out->failing > 0 || out->out_of_time || out->first_alone ? CAGD_UNDECIDED
                                                                                                   : CAGD_HOLDS;
    return r.undefined ? 0 : r.ties;
}

/* Bounds of names that are functions of others may be lost: then what is supposed is left out, as it may be, or decomposed. */
static void check_as_read(const cagd_scope *scope, const cagd_tree *statement, double until, int quick,
                          cagd_finding *out)
{
    int ties = check_once(scope, statement, until - cagd_seconds(), quick, TIED, out);
    cagd_finding *again = out->answer == CAGD_UNDECIDED && ties > 0 ? region_bytes(sizeof *again) : NULL;
    for (enum use_of_ties use = UNTIED; again != NULL && use <= TIED_AND_DECOMPOSED && cagd_seconds() < until; use++) {
        check_once(scope, statement, until - cagd_seconds(), quick, use, again);
        if (again->answer == CAGD_UNDECIDED)
            continue;
        *out = *again;
        return;
    }
}

/* A context in which the names have the values of the example; NULL without memory. */
static cagd_context *at_example(const cagd_scope *scope, const cagd_finding *f)
{
    cagd_context *c = region_bytes(sizeof *c);
    if (c == NULL)
        return NULL;
    *c = (cagd_context){.scope = scope, .in_field = 1, .steps = CAGD_USUAL_STEPS, .whole_angles = f->whole_angles};
    for (int k = 0; k < f->given; k++)
        cagd_bind(c, f->example[k].name, cagd_value_constant(f->example[k].value));
    return c;
}

static int tell_sides(const cagd_scope *scope, const cagd_tree *t, cagd_finding *f);

/* Of what is said for all numbers of a range the first one for which it is false, which then is one of the example. */
static int tell_number(const cagd_scope *scope, const cagd_tree *t, cagd_finding *f)
{
    enum { FURTHEST = 1000 };
    cagd_context *c = at_example(scope, f);
    long low = 0, high = -1;
    if (c == NULL || f->given == CAGD_MOST_UNKNOWNS)
        return 0;
    cagd_value first = cagd_evaluate(c, t->at[0]), last = cagd_evaluate(c, t->at[1]);
    int told = region_faults == 0 && cagd_value_is_whole(first, &low) && cagd_value_is_whole(last, &high);
    region_faults &= FAULT_MEMORY;
    if (!told || high - low > FURTHEST)
        return 0;
    told = 0;
    for (long k = low; k <= high && !told; k++) {
        f->example[f->given++] = (cagd_given){t->head, from_int_q(k), NULL};
        told = tell_sides(scope, t->at[2], f);
        f->given -= !told;
    }
    return told;
}

/* The first relation of the statement that is false at the numbers of the example, with its two sides; 0 where there is none. */
static int tell_sides(const cagd_scope *scope, const cagd_tree *t, cagd_finding *f)
{
    int told = 0;
    for (int k = 0; t->kind == CAGD_ALL && k < t->count && !told; k++)
        told = tell_sides(scope, t->at[k], f);
    if (t->kind == CAGD_FOR_ALL)
        return tell_number(scope, t, f);
    cagd_context *c = t->kind == CAGD_RELATION ? at_example(scope, f) : NULL;
    if (c == NULL)
        return told;
    for (int k = 0; k + 1 < t->count && !told; k++) {
        cagd_value a = cagd_evaluate(c, t->at[k]), b = cagd_evaluate(c, t->at[k + 1]);
        told = region_faults == 0 && a.rational && b.rational && cagd_compare_values(c, a, t->relation[k], b) == 0;
        if (told)
            f->relation = t->relation[k], f->of_left = t->at[k], f->of_right = t->at[k + 1], f->left = a.q,
            f->right = b.q;
    }
    region_faults &= FAULT_MEMORY;
    return told;
}

/* Whether q >= 0 wherever it is defined. */
static int is_never_negative(const cagd_scope *scope, const cagd_tree *q, double until)
{
    const cagd_relation at_least = CAGD_GREATER_OR_EQUAL;
    cagd_tree *t = cagd_tree_new(CAGD_RELATION, q->from, q->to, 2);
    cagd_finding *f = region_bytes(sizeof *f);
    if (t == NULL || f == NULL)
        return 0;
    t->at[0] = q, t->at[1] = cagd_tree_number(0, q->from, q->to), t->relation = &at_least;
    if (t->at[1] != NULL)
        check_as_read(scope, t, until, 1, f);
    return f->answer == CAGD_HOLDS;
}

/* Whether of the roots, whatever the names are, one is of a negative number. */
static int is_defined_nowhere(const cagd_scope *scope, const cagd_lifted *lifted, double until)
{
    static const cagd_relation less[] = {CAGD_LESS};
    const cagd_tree *one[CAGD_MOST_LIFTED], *any;
    cagd_finding *f = region_bytes(sizeof *f);
    int count = 0;
    for (int k = 0; k < lifted->count; k++) {
        const cagd_tree *q = lifted->of[k];
        cagd_tree *t = lifted->is_length[k] ? NULL : cagd_tree_new(CAGD_RELATION, q->from, q->to, 2);
        if (t == NULL)
            continue;
        t->at[0] = q, t->at[1] = cagd_tree_number(0, q->from, q->to), t->relation = less;
        one[count++] = t;
    }
    if (count == 0 || f == NULL)
        return 0;
    if (count == 1)
        any = one[0];
    else {
        cagd_tree *list = cagd_tree_new(CAGD_ANY, one[0]->from, one[0]->to, count);
        for (int k = 0; list != NULL && k < count; k++)
            list->at[k] = one[k];
        any = list;
    }
    *f = (cagd_finding){0};
    if (any != NULL)
        check_as_read(scope, any, until, 1, f);
    return f->answer == CAGD_HOLDS;
}

/* What is not decided with its roots may be decided with names for them (lift.h). */
static void check_with_names_for_roots(const cagd_scope *scope, const cagd_tree *statement, double until, int quick,
                                       cagd_finding *out)
{
    cagd_scope with_roots = *scope;
    cagd_lifted *lifted = region_bytes(sizeof *lifted);
    cagd_finding *f = region_bytes(sizeof *f);
    const cagd_tree *t = lifted != NULL ? cagd_with_roots_lifted(&with_roots, statement, lifted) : NULL;
    if (t == NULL || f == NULL)
        return;
    check_as_read(&with_roots, t, until, quick, f);
    if (f->answer == CAGD_UNDECIDED)
        return;
    cagd_forget_lifted(f, lifted);
    if (f->answer == CAGD_FAILS && !f->has_root && !tell_sides(scope, statement, f))
        f->of_left = f->of_right = NULL;
    for (int k = 0; f->answer == CAGD_HOLDS && k < lifted->count && !f->leaves_out_poles && !quick; k++)
        f->leaves_out_poles = !lifted->is_length[k] && !is_never_negative(scope, lifted->of[k], until);
    if (f->answer == CAGD_HOLDS && !quick && is_defined_nowhere(scope, lifted, until)) {
        f->answer = CAGD_UNDECIDED, f->undecided = 1;
        f->why = "it is defined nowhere: a root of what is negative";
    }
    *out = *f;
}

/* What is not decided with its amounts, and so with conditions of higher degree, may be decided as implications (clauses.h). */
static void check_in_clauses(const cagd_scope *scope, const cagd_tree *statement, double until, int quick,
                             cagd_finding *out)
{
    const cagd_tree *other = cagd_in_implications(statement);
    cagd_finding *second = other != NULL && other != statement ? region_bytes(sizeof *second) : NULL;
    if (second == NULL)
        return;
    check_as_read(scope, other, until, quick, second);
    if (second->answer == CAGD_FAILS && (second->has_root || !tell_sides(scope, statement, second))) {
        if (cagd_has_squared_roots(statement)) /* perhaps it is not defined there */
            return;
        second->of_left = second->of_right = NULL; /* those of a part that is not printed */
    }
    if (second->answer != CAGD_UNDECIDED)
        *out = *second;
}

static int has_root(const cagd_tree *t)
{
    int has = t->kind == CAGD_ROOT || t->kind == CAGD_NORM;
    for (int k = 0; k < t->count && !has; k++)
        has = has_root(t->at[k]);
    return has;
}

static void check(const cagd_scope *scope, const cagd_tree *statement, double seconds, int quick, cagd_finding *out);

/* An equality with roots, |P_0 - P_1| = |P_1 - P_0|, as two inequalities. */
static void check_from_both_sides(const cagd_scope *scope, const cagd_tree *statement, double until, int quick,
                                  cagd_finding *out)
{
    static const cagd_relation side[] = {CAGD_LESS_OR_EQUAL, CAGD_GREATER_OR_EQUAL};
    cagd_finding *f = region_bytes(2 * sizeof *f);
    if (f == NULL || statement->kind != CAGD_RELATION || statement->count != 2 ||
        statement->relation[0] != CAGD_EQUAL || !has_root(statement))
        return;
    for (int k = 0; k < 2; k++) {
        cagd_tree *t = cagd_tree_new(CAGD_RELATION, statement->from, statement->to, 2);
        if (t == NULL)
            return;
        t->at[0] = statement->at[0], t->at[1] = statement->at[1], t->relation = &side[k];
        check(scope, t, (until - cagd_seconds()) / (2 - k), quick, &f[k]);
        if (f[k].answer == CAGD_UNDECIDED)
            return;
        if (f[k].answer == CAGD_FAILS) {
            *out = f[k];
            if (out->of_left != NULL && !out->has_root)
                tell_sides(scope, statement, out);
            return;
        }
    }
    *out = f[0];
    out->leaves_out_poles |= f[1].leaves_out_poles, out->bounded |= f[1].bounded, out->one_sided |= f[1].one_sided;
    for (int k = 0; k < f[1].sums.count; k++)
        cagd_note_sum(&out->sums, f[1].sums.sum[k], f[1].sums.had_terms[k]);
    cagd_weaken(out, f[1].strength);
}

static void check(const cagd_scope *scope, const cagd_tree *statement, double seconds, int quick, cagd_finding *out)
{
    double until = cagd_seconds() + seconds;
    check_as_read(scope, statement, until, quick, out);
    if (out->answer == CAGD_UNDECIDED && !out->first_alone && cagd_seconds() < until)
        check_in_clauses(scope, statement, until, quick, out);
    if (out->answer == CAGD_UNDECIDED && !out->first_alone && cagd_seconds() < until)
        check_with_names_for_roots(scope, statement, until, quick, out);
    if (out->answer == CAGD_UNDECIDED && !out->first_alone && cagd_seconds() < until)
        check_from_both_sides(scope, statement, until, quick, out);
    if (out->answer == CAGD_FAILS && !out->has_root && out->of_left == NULL)
        tell_sides(scope, statement, out);
}

/* ---- conditions behind a formula -------------------------------------------------------------------------- */

/* x = ..., x meaning nothing else. */
static int tells_a_name(const cagd_scope *scope, const cagd_tree *t)
{
    return t->kind == CAGD_RELATION && t->count == 2 && t->relation[0] == CAGD_EQUAL && t->at[0]->kind == CAGD_NAME &&
           t->at[0]->count == 0 && cagd_defined(scope, t->at[0]->head) == NULL;
}

/* Whether the letter is an index of names of the tree. */
static int is_index_in(const cagd_tree *t, const char *letter, int in_index)
{
    int is = in_index && t->kind == CAGD_NAME && t->count == 0 && strcmp(t->head, letter) == 0;
    for (int k = 0; k < t->count && !is; k++)
        is = is_index_in(t->at[k], letter, in_index || (t->kind == CAGD_NAME && k < t->lower + t->upper));
    return is;
}

/* Whether it runs between ends, and is no last index, as n is. */
static int is_running(const cagd_scope *scope, const cagd_variable *v)
{
    int is = v->whole && v->high != NULL && !v->low_open && !v->high_open && cagd_declared(scope, v->head) == v &&
             cagd_defined(scope, v->head) == NULL && strchr("nmNM", v->head[0]) == NULL;
    for (const cagd_variable *w = scope->variables; w != NULL && is; w = w->next)
        is = (w->low == NULL || !cagd_tree_has(w->low, v->head)) &&
             (w->high == NULL || !cagd_tree_has(w->high, v->head));
    return is;
}

static const cagd_tree *new_of(cagd_tree_kind kind, int count, const cagd_tree *const child[])
{
    cagd_tree *t = cagd_tree_new(kind, child[0]->from, child[0]->to, count);
    for (int k = 0; t != NULL && k < count; k++)
        if ((t->at[k] = child[k]) == NULL)
            return NULL;
    return t;
}

/* t for low, low + step, ..., high, for the numbers that are listed, or for all from low to high, in the place of the letter of v; NULL without memory. */
static const cagd_tree *for_members(const cagd_tree *t, const cagd_variable *v)
{
    const cagd_tree *one[CAGD_MOST_CHILDREN], *low = v->low, *high = v->high;
    for (int k = 0; v->listed != NULL && k < v->listed_count && k < CAGD_MOST_CHILDREN; k++)
        one[k] = cagd_tree_with(t, v->head, v->listed[k]);
    if (v->listed != NULL)
        return v->listed_count <= CAGD_MOST_CHILDREN ? new_of(CAGD_ALL, v->listed_count, one) : NULL;
    if (v->step > 1) { /* low + step k for k = 0, ..., (high - low)/step, the letter being k */
        cagd_tree *k = cagd_tree_new(CAGD_NAME, t->from, t->to, 0);
        const cagd_tree *step = cagd_tree_number(v->step, t->from, t->to), *minus = new_of(CAGD_NEGATIVE, 1, &low);
        if (k == NULL || step == NULL || minus == NULL)
            return NULL;
        k->head = v->head;
        const cagd_tree *steps = new_of(CAGD_PRODUCT, 2, (const cagd_tree *[]){step, k});
        const cagd_tree *member = new_of(CAGD_SUM, 2, (const cagd_tree *[]){low, steps});
        const cagd_tree *length = new_of(CAGD_SUM, 2, (const cagd_tree *[]){high, minus});
        t = member != NULL ? cagd_tree_with(t, v->head, member) : NULL;
        high = length != NULL ? new_of(CAGD_QUOTIENT, 2, (const cagd_tree *[]){length, step}) : NULL;
        low = t != NULL ? cagd_tree_number(0, t->from, t->to) : NULL;
    }
    if (t == NULL || low == NULL || high == NULL)
        return NULL;
    cagd_tree *all = cagd_tree_new(CAGD_FOR_ALL, t->from, t->to, 3);
    if (all != NULL)
        all->head = v->head, all->at[0] = low, all->at[1] = high, all->at[2] = t;
    return all;
}

/* Whether something is supposed of the letter, i \text{ even}. */
static int has_condition(const cagd_scope *scope, const char *letter)
{
    int has = 0;
    for (int k = 0; k < scope->condition_count; k++)
        has |= cagd_tree_has(scope->conditions[k], letter);
    return has;
}

/* t, which is supposed, for all values of the running letters that are indices in it and, where `said` is no NULL, do not stand in that.  A letter of which
 * something is supposed is left as it is, and told in *conditioned; where that is NULL, t is supposed for its whole range. */
static const cagd_tree *for_every_letter(const cagd_scope *scope, const cagd_tree *t, const cagd_tree *said,
                                         int *conditioned)
{
    for (const cagd_variable *v = scope->variables; v != NULL; v = v->next) {
        if (!is_running(scope, v) || !is_index_in(t, v->head, 0) ||
            (said != NULL && cagd_depends_on(scope, said, v->head)))
            continue;
        if (conditioned != NULL && has_condition(scope, v->head)) {
            *conditioned = 1;
            continue;
        }
        const cagd_tree *all = for_members(t, v);
        if (all == NULL)
            return t;
        t = all;
    }
    return t;
}

/* What stands behind a formula and can be meant as supposed. */
struct parts {
    const cagd_tree *where, *supposed,
        *statement;         /* the first that is no range, or else the first; all of them; what the statement is then */
    int are_ranges, bounds; /* bounds: nothing else is said */
    int conditioned;        /* it is supposed of an index that has conditions, for each of its values alone */
    int asked; /* behind a word, in a row of its own, or between formulas: whether it is supposed is asked for */
};

/* Whether none of the names in t, which has some, stands in what is said. */
static int speaks_of_no_name_in(const cagd_scope *scope, const cagd_tree *t, const cagd_tree *said)
{
    int speaks = 0, names = 0;
    if (t->kind == CAGD_NAME && cagd_declared(scope, t->head) != NULL)
        return !cagd_tree_has(said, t->head) && !cagd_depends_on(scope, said, t->head);
    for (int k = 0; k < t->count; k++) {
        if (t->at[k]->kind == CAGD_NUMBER)
            continue;
        names++;
        speaks |= !speaks_of_no_name_in(scope, t->at[k], said);
    }
    return names > 0 && !speaks;
}

/* The statement, "A, \quad u + v = 1", or "A, \quad u + v = 1, \quad x \in [0,1]", with the parts of plain names supposed; 0 where there are none. */
static int suppose_parts(const cagd_scope *scope, const cagd_tree *t, struct parts *out)
{
    const cagd_tree *premise = NULL;
    if (t->kind == CAGD_IMPLIES && t->at[1]->from < t->at[0]->from)
        premise = t->at[0], t = t->at[1];
    cagd_tree *said = cagd_tree_new(CAGD_ALL, t->from, t->to, t->count),
              *supposed = cagd_tree_new(CAGD_ALL, t->from, t->to, t->count),
              *both = cagd_tree_new(CAGD_ALL, t->from, t->to, 2),
              *implication = cagd_tree_new(CAGD_IMPLIES, t->from, t->to, 2);
    if (t->kind != CAGD_ALL || t->juxtaposed || said == NULL || supposed == NULL || both == NULL || implication == NULL)
        return 0;
    said->count = supposed->count = 0;
    *out = (struct parts){.are_ranges = 1};
    for (int k = 0; k < t->count; k++) {
        int is_range = k > 0 && cagd_is_range_of_name(scope, t->at[k], premise),
            plain = is_range || (k > 0 && (tells_a_name(scope, t->at[k]) || (cagd_is_of_plain_names(scope, t->at[k]))));
        cagd_tree *to = plain ? supposed : said;
        to->at[to->count++] = t->at[k];
        if (plain && (out->where == NULL || (!is_range && out->are_ranges)))
            out->where = t->at[k];
        out->asked |= is_range && (t->asked >> k & 1);
        out->asked |= !plain && supposed->count > 0;
        out->are_ranges &= is_range || !plain;
    }
    for (int k = 0; k < supposed->count && said->count > 0; k++) /* x^2 \ge 0, y \ge 0 */
        out->asked |= speaks_of_no_name_in(scope, supposed->at[k], said);
    if (said->count == 0) { /* a >= 0, a^3 >= 0: what is no range is said */
        supposed->count = 0;
        for (int k = 0; k < t->count; k++) {
            cagd_tree *to = cagd_is_range_of_name(scope, t->at[k], premise) ? supposed : said;
            to->at[to->count++] = t->at[k];
        }
        out->where = supposed->at[0], out->are_ranges = 1;
    }
    out->bounds = 1; /* u >= 1/2, u >= 2: of bounds alone nobody knows which are said */
    for (int k = 0; k < said->count; k++)
        out->bounds &= cagd_is_range_of_name(scope, said->at[k], premise);
    if (supposed->count == 0 || said->count == 0)
        return 0;
    out->are_ranges &= !out->bounds;
    for (int k = 0; k < supposed->count; k++)
        supposed->at[k] = for_every_letter(scope, supposed->at[k], said, &out->conditioned);
    out->supposed = supposed->count == 1 ? supposed->at[0] : supposed;
    both->at[0] = premise, both->at[1] = out->supposed;
    implication->at[0] = premise != NULL ? both : out->supposed;
    implication->at[1] = said->count == 1 ? said->at[0] : said;
    out->statement = implication;
    return 1;
}

/* R_i \ge 0 \text{ if } \omega_i > 0, i = 0, 1, 2, which fails if it is supposed of one i each time: where it is supposed of all of them, does it not? */
static int fails_for_one_alone(const cagd_scope *scope, const cagd_tree *t, double seconds, cagd_finding *out)
{
    if (t->kind != CAGD_IMPLIES || t->at[1]->from > t->at[0]->from)
        return 0;
    cagd_tree *other = cagd_tree_new(CAGD_IMPLIES, t->from, t->to, 2);
    cagd_finding *second = region_bytes(sizeof *second);
    const cagd_tree *supposed = for_every_letter(scope, t->at[0], NULL, NULL);
    if (other == NULL || second == NULL || supposed == t->at[0])
        return 0;
    other->at[0] = supposed, other->at[1] = t->at[1];
    check(scope, other, seconds, 0, second);
    if (second->answer == CAGD_FAILS)
        return 0;
    *out = (cagd_finding){.answer = CAGD_UNDECIDED, .undecided = 1, .cases = 1, .where = t->at[0]};
    out->why =
        "it fails if this is supposed for one index each time, and not where it is for all of them: then write it in "
        ":for: or in a let block";
    return 1;
}

void cagd_check(const cagd_scope *scope, const cagd_tree *statement, double seconds, cagd_finding *out)
{
    struct parts parts;
    const cagd_tree *beyond = cagd_is_beyond_bounds(scope, statement);
    if (beyond != NULL) {
        *out = (cagd_finding){.answer = CAGD_UNDECIDED, .undecided = 1, .cases = 1, .where = beyond};
        out->why = CAGD_BEYOND_BOUNDS;
        return;
    }
    check(scope, statement, seconds, 0, out);
    if (out->answer == CAGD_FAILS && fails_for_one_alone(scope, statement, seconds, out))
        return;
    if (out->answer == CAGD_HOLDS || !suppose_parts(scope, statement, &parts) ||
        (out->answer == CAGD_UNDECIDED && (!parts.are_ranges || parts.asked)))
        return;
    cagd_finding *second = region_bytes(sizeof *second);
    if (second == NULL)
        return;
    check(scope, parts.statement, seconds, 0, second);
    if (second->answer == CAGD_FAILS && parts.bounds)
        return;
    if (second->answer == CAGD_FAILS && parts.conditioned) { /* more is supposed than was */
        *out = (cagd_finding){.answer = CAGD_UNDECIDED, .undecided = 1, .cases = 1, .where = parts.where};
        out->why = "it fails if this is supposed for one index each time: for all of them that have the condition "
                   "write a list";
        return;
    }
    if (second->answer == CAGD_FAILS ||
        (parts.are_ranges && !parts.asked)) { /* in both readings, with numbers that satisfy what can be a condition */
        *out = *second;
        out->supposed = out->answer == CAGD_HOLDS ? parts.supposed : NULL;
        return;
    }
    *out = (cagd_finding){.answer = CAGD_UNDECIDED, .undecided = 1, .cases = 1, .where = parts.where};
    out->why =
        "it fails if this is said, and not where it is supposed: write \\text{for} before it, or a statement for each";
}

/* ---- changed statements ----------------------------------------------------------------------------------- */

void cagd_check_changes(const cagd_scope *scope, const cagd_tree *statement, double seconds, cagd_finding *out)
{
    double until = cagd_seconds() + seconds;
    int held = 0;
    struct parts parts;
    if (out->supposed != NULL && suppose_parts(scope, statement, &parts))
        statement = parts.statement;
    for (int k = 0; k < MOST_CHANGES && cagd_seconds() < until; k++) {
        region_mark mark = region_open();
        cagd_finding *f = region_bytes(sizeof *f);
        const cagd_tree *changed = f != NULL ? cagd_changed(statement, k) : NULL;
        if (changed != NULL) {
            check(scope, changed, until - cagd_seconds(), 1, f);
            out->changes++;
            out->noticed += f->answer == CAGD_FAILS;
            out->open += f->answer == CAGD_UNDECIDED;
            held += f->answer == CAGD_HOLDS;
        }
        region_drop(mark);
        if (changed == NULL)
            break;
    }
    out->says_nothing =
        cagd_is_vacuous(scope, statement) || (held > 0 && held == out->changes && cagd_seconds() < until);
}
