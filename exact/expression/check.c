#include "exact/expression/check.h"

#include "core/clock.h"
#include "exact/expression/angle.h"
#include "exact/expression/cell.h"
#include "exact/expression/change.h"
#include "exact/expression/example.h"
#include "exact/expression/implied.h"
#include "exact/expression/irrational.h"
#include "exact/expression/order.h"
#include "exact/expression/positive.h"
#include "exact/expression/radical.h"
#include "exact/expression/suppose.h"
#include "exact/expression/tie.h"
#include "exact/expression/vacuous.h"
#include "exact/number/recorder.h"
#include "exact/record/trace.h"
#include "exact/words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST_WHOLE = 8,
    FIRST_CASES = 8,
    FURTHER_CASES = 24,
    QUICK_CASES = 16,
    MOST_CHANGES = 60,
    MOST_CONSTRAINTS = 200,
    FIELD_ROOM = 32,
    MOST_DIVISORS = 24
};

/* One run over a statement. */
struct run {
    const cagd_scope *scope;
    const cagd_tree *statement;
    cagd_finding *out;
    double until;
    int quick; /* one case that fails is enough, and few cases are */
    const cagd_tree *premise,
        *claim; /* of the statement the part that is looked at: what is supposed, or NULL, and what is said */
    cagd_take_case
        *take; /* NULL, or where each case goes with what was noted; `unnoted`: it is not the whole evidence */
    void *data;
    int unnoted;
    int undefined;           /* in some part a side was not defined */
    int untied, ties;        /* equalities of higher degree are not used (tie.h); how many were                 */
    int decomposes;          /* where they are, what is not decided is decomposed, too (implied.h)              */
    struct collection *into; /* NULL, or where constraints of a parameter are collected and nothing is decided */
    const cagd_variable *whole[MOST_WHOLE];
    int wholes;
    cagd_given chosen[MOST_WHOLE]; /* values of the whole numbers */
    long skipped, taken;           /* of a range without end so many are left out, and so many are looked at */
};

/* What the cases ask of a parameter. */
struct collection {
    const char *parameter;
    int poles; /* numbers for which a divisor of a side is 0 are none of those that are looked for */
    cagd_constraint constraint[MOST_CONSTRAINTS];
    const char *other[MOST_CONSTRAINTS]; /* the name of its other variable */
    cagd_given chosen[MOST_CONSTRAINTS][MOST_WHOLE];
    int count;
    cagd_side_of_box domain;
};

/* ---- what a statement depends on ----------------------------------------------------------------------- */

static int uses(const cagd_scope *scope, const cagd_tree *t, const char *head, int depth)
{
    if (t == NULL || depth > 12)
        return t != NULL;
    if (t->head != NULL && strcmp(t->head, head) == 0)
        return t->kind != CAGD_EVERY_INDEX;
    if (t->times != NULL && uses(scope, t->times, head, depth))
        return 1;
    for (int k = 0; k < t->count; k++)
        if (uses(scope, t->at[k], head, depth))
            return 1;
    if (t->kind != CAGD_NAME)
        return 0;
    for (const cagd_definition *d = scope->definitions; d != NULL; d = d->next)
        if (strcmp(d->left->head, t->head) == 0 && !cagd_tree_has(d->left, head) &&
            (cagd_tree_has(d->body, t->head) ? cagd_tree_has(d->body, head) : uses(scope, d->body, head, depth + 1)))
            return 1;
    return 0;
}

int cagd_depends_on(const cagd_scope *scope, const cagd_tree *statement, const char *head)
{
    return uses(scope, statement, head, 0);
}

/* Whether the letter has a value, as r has behind r = 4, though it was declared before. */
static int has_value(const cagd_scope *scope, const char *head)
{
    const cagd_definition *d = cagd_defined(scope, head);
    return d != NULL && d->left->count == 0 && d->when == NULL;
}

int cagd_whole_numbers(const cagd_scope *scope, const cagd_tree *statement, const cagd_variable *list[], int room)
{
    int count = 0;
    for (const cagd_variable *v = scope->variables; v != NULL; v = v->next) {
        int known = cagd_declared(scope, v->head) != v || has_value(scope, v->head),
            used = uses(scope, statement, v->head, 0);
        for (int k = 0; k < scope->condition_count; k++)
            used |= uses(scope, scope->conditions[k], v->head, 0);
        for (int k = 0; k < count; k++) /* or the range of one that is used */
            used |= (list[k]->low != NULL && cagd_tree_has(list[k]->low, v->head)) ||
                    (list[k]->high != NULL && cagd_tree_has(list[k]->high, v->head));
        for (const cagd_variable *w = scope->variables; w != NULL; w = w->next)
            used |= !w->whole && uses(scope, statement, w->head, 0) &&
                    ((w->low != NULL && cagd_tree_has(w->low, v->head)) ||
                     (w->high != NULL && cagd_tree_has(w->high, v->head)));
        if (!v->whole || known || !used)
            continue;
        if (count == room)
            return -1;
        for (int k = count++; k > 0; k--)
            list[k] = list[k - 1];
        list[0] = v;
    }
    return count;
}

/* ---- one case ------------------------------------------------------------------------------------------ */

/* A part of a case: pieces of some variables, and numbers for others. */
struct part {
    cagd_piece piece[CAGD_MOST_PIECES];
    int pieces;
    cagd_given number[CAGD_MOST_PIECES];
    const cagd_variable *of_number[CAGD_MOST_PIECES]; /* their declarations, or NULL */
    int numbers;
    cagd_cut cut[CAGD_MOST_CUTS_OF_CELL];
    int cuts;
    int apart;   /* so many of the numbers are those of a place that a tie leaves out (tie.h) */
    int touches; /* an equality is among them: it is a part of lower dimension */
};

static void begin(const struct run *r, const struct part *p, cagd_context *c)
{
    *c = (cagd_context){.scope = r->scope, .premise = r->premise, .in_field = 1, .steps = CAGD_USUAL_STEPS};
    c->untied = r->untied, c->has_roots = 1;
    c->whole_angles = r->out->whole_angles = !cagd_has_half_angles(r->scope, r->statement);
    for (int k = 0; k < r->wholes; k++)
        cagd_bind(c, r->chosen[k].name, cagd_value_constant(r->chosen[k].value));
    memcpy(c->piece, p->piece, sizeof p->piece);
    c->pieces = p->pieces;
    if (r->into != NULL) { /* the parameter is a variable of every case, the same one */
        cagd_tree name = {.kind = CAGD_NAME, .head = r->into->parameter};
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

/* The sides of the box of all variables that are known. */
static int sides(const cagd_context *c, cagd_side_of_box side[], int of[])
{
    int count = 0;
    for (int k = 0; k < c->count; k++) {
        const cagd_binding *b = &c->binding[k];
        if (!b->unknown)
            continue;
        of[count] = k;
        side[count++] =
            (cagd_side_of_box){b->value.f, b->has_low, b->has_high, b->low_open, b->high_open, b->low, b->high};
    }
    return count;
}

static cagd_answer worse(cagd_answer a, cagd_answer b)
{
    return a == CAGD_FAILS || b == CAGD_FAILS ? CAGD_FAILS : a == CAGD_UNDECIDED ? a : b;
}

static void weaken(cagd_finding *f, cagd_strength s)
{
    f->strength = f->strength == CAGD_BY_NOTHING || s < f->strength ? s : f->strength;
}

static cagd_answer undecided(struct run *r, const cagd_context *c, const char *why)
{
    if (r->out->why == NULL) {
        r->out->why = c->trouble != NULL ? c->trouble : why;
        r->out->where = c->trouble != NULL ? c->where : NULL;
    }
    return CAGD_UNDECIDED;
}

/* Whether both are names of one letter with an index, and how far the first index is behind the second: u_10 and u_2, 8. */
static int is_one_letter(const char *a, const char *b, long *distance)
{
    size_t n = strcspn(a, "_");
    if (a[n] == '\0' || strncmp(a, b, n + 1) != 0)
        return 0;
    a += n + 1, b += n + 1;
    *distance = strtol(a + (*a == '{'), NULL, 10) - strtol(b + (*b == '{'), NULL, 10);
    return 1;
}

/* One more name with its value; those of one letter stand together, by their indices. */
static void give(cagd_finding *f, cagd_given one)
{
    int place = f->given, is_placed = 0;
    long distance;
    for (int k = 0; k < f->given; k++)
        if (is_one_letter(f->example[k].name, one.name, &distance) && (distance < 0 || !is_placed))
            place = distance < 0 ? k + 1 : k, is_placed = 1;
    for (int k = f->given++; k > place; k--)
        f->example[k] = f->example[k - 1];
    f->example[place] = one;
}

/* All names of the page with their values; a name with root[m] has that root instead, with no `root` none has. */
static void give_all(cagd_finding *f, const cagd_context *c, const num_q value[], const struct cagd_root *const root[])
{
    f->has_example = 1;
    for (int m = 0; m < c->count; m++) {
        const cagd_binding *b = &c->binding[m];
        const struct cagd_root *r = root != NULL && root[m] != NULL ? root[m]
                                    : b->has_root && b->unknown     ? &b->root
                                                                    : NULL;
        if (b->key[0] != '\0' && !b->hidden)
            give(f, (cagd_given){b->key, b->unknown || b->solved ? value[m] : b->value.q,
                                 r != NULL ? cagd_told_root(*r) : NULL});
    }
}

/* Refuted by a number that is no rational one. */
static int refuted_at_root(cagd_finding *f, const cagd_context *c, const cagd_tree *t, int k)
{
    cagd_irrational_example *e = region_bytes(sizeof *e);
    if (e == NULL || !cagd_find_irrational_example(c, t, k, e))
        return 0;
    const struct cagd_root *root[CAGD_MOST_UNKNOWNS] = {NULL};
    if (e->of >= 0)
        root[e->of] = &e->root;
    f->has_root = 1, f->order = e->order;
    give_all(f, c, e->value, root);
    return 1;
}

/* a relation b is refuted: by small numbers that are looked for, or by those that are given. */
static cagd_answer refuted_at(struct run *r, cagd_context *c, const cagd_tree *t, int k, const num_q at[])
{
    cagd_finding *f = r->out;
    if (f->has_example)
        return CAGD_FAILS;
    if (k >= 0)
        f->relation = t->relation[k], f->of_left = t->at[k], f->of_right = t->at[k + 1];
    num_q value[CAGD_MOST_UNKNOWNS];
    int found = cagd_find_example(c, t, k, value, &f->left, &f->right);
    if (!found && at != NULL) {
        memcpy(value, at, sizeof value);
        found = cagd_is_example(c, t, k, value, &f->left, &f->right);
    }
    if (!found && refuted_at_root(f, c, t, k))
        return CAGD_FAILS;
    if (!found)
        return undecided(r, c, "no numbers were found for which it is false, though it is no identity");
    give_all(f, c, value, NULL);
    return CAGD_FAILS;
}

/* The same, the point having coordinates of some names. */
static cagd_answer refuted(struct run *r, cagd_context *c, const cagd_tree *t, int k, const num_q point[],
                           const int of[], int count)
{
    num_q at[CAGD_MOST_UNKNOWNS] = {0};
    for (int m = 0; point != NULL && m < count; m++)
        at[of[m]] = point[m];
    return refuted_at(r, c, t, k, point != NULL ? at : NULL);
}

/* One more constraint, with the case that it comes from. */
static void collect(struct run *r, cagd_constraint one, const char *other)
{
    struct collection *into = r->into;
    for (int m = 0; m < r->wholes; m++)
        into->chosen[into->count][m] = r->chosen[m];
    into->constraint[into->count] = one;
    into->other[into->count++] = other;
}

/* Whether all that is known of the names in p, and of the parameter, are their bounds. */
static int has_bounds_alone(const cagd_context *c, num_f p, const cagd_binding *parameter)
{
    for (int m = 0; m < c->count; m++) {
        const cagd_binding *b = &c->binding[m];
        const cagd_variable *v = b->variable;
        if (!b->unknown || (b != parameter && degree_f(p, b->value.f) < 1))
            continue;
        if (b->has_root || (v != NULL && ((v->low != NULL && !b->has_low) || (v->high != NULL && !b->has_high))))
            return 0;
        for (int i = 0; i < c->limits; i++)
            if (degree_f(c->limit[i].form, b->value.f) > 0)
                return 0;
    }
    return c->missing == 0 && !c->loose;
}

/* A value of the parameter for which the polynomial is 0 whatever the other names are is none of those that are looked for. */
static void collect_poles(struct run *r, num_f p, const cagd_binding *parameter)
{
    num_f poles = cagd_factor_of_parameter(p, parameter->value.f);
    if (!is_constant_f(poles, NULL) && r->into->count < MOST_CONSTRAINTS)
        collect(r, (cagd_constraint){mul_f(poles, poles), CAGD_MORE_THAN_ZERO, {.variable = parameter->value.f}}, NULL);
}

/* The relation a >= b, a > b, a = b, or a \ne b as a constraint of the parameter; its value must not be a pole. */
static cagd_answer collected(struct run *r, cagd_context *c, cagd_relation relation, cagd_value d)
{
    struct collection *into = r->into;
    const cagd_binding *parameter = cagd_binding_of(c, into->parameter);
    cagd_side_of_box side[CAGD_MOST_UNKNOWNS];
    int of[CAGD_MOST_UNKNOWNS], count = sides(c, side, of);
    r->out->comparisons++;
    if (into->count + 1 + c->divisors >= MOST_CONSTRAINTS)
        return undecided(r, c, "too many cases");
    num_f f = cagd_in_field(d), n = cagd_numerator_f(f),
          p = relation == CAGD_EQUAL       ? n
              : relation == CAGD_NOT_EQUAL ? mul_f(n, n)
                                           : mul_f(n, cagd_denominator_f(f));
    cagd_constraint one = {.p = p,
                           .demand = relation == CAGD_EQUAL ? CAGD_ZERO
                                     : relation == CAGD_LESS_OR_EQUAL || relation == CAGD_GREATER_OR_EQUAL
                                         ? CAGD_AT_LEAST_ZERO
                                         : CAGD_MORE_THAN_ZERO};
    if (!has_bounds_alone(c, p, parameter))
        return undecided(r, c, "a condition or a bound that is not understood with :find:");
    const char *other = NULL;
    for (int m = 0; m < count; m++) {
        const cagd_binding *b = &c->binding[of[m]];
        if (b == parameter) {
            into->domain = side[m];
        } else if (degree_f(p, side[m].variable) > 0 && one.demand != CAGD_ZERO) {
            if (other != NULL)
                return undecided(r, c, "an inequality of more than one name besides the parameter");
            one.t = side[m];
            other = b->key;
        }
    }
    if (other == NULL)
        one.t.variable = parameter->value.f;
    collect(r, one, other);
    if (relation != CAGD_EQUAL)
        collect_poles(r, cagd_denominator_f(f), parameter);
    for (int i = 0; into->poles && i < c->divisors; i++)
        collect_poles(r, c->divisor[i], parameter);
    return CAGD_HOLDS;
}

/* The relation number k of the chain t, whose sides differ by n/m, where names are ordered or otherwise tied. */
static cagd_answer compared_in_cell(struct run *r, cagd_context *c, const cagd_tree *t, int k, num_f n, num_f m)
{
    cagd_relation relation = t->relation[k];
    num_q value[CAGD_MOST_UNKNOWNS];
    int strict = relation == CAGD_LESS || relation == CAGD_GREATER || relation == CAGD_NOT_EQUAL, rational = 0;
    cagd_answer answer = CAGD_UNDECIDED;
    if (cagd_is_positive_in_cell(c, m, 1))
        answer = cagd_positive_in_cell(c, n, strict, value, &rational);
    else if (cagd_is_positive_in_cell(c, neg_f(m), 1))
        answer = cagd_positive_in_cell(c, neg_f(n), strict, value, &rational);
    else
        answer = cagd_positive_in_cell(c, mul_f(n, m), strict, value, &rational);
    if (relation == CAGD_NOT_EQUAL && answer != CAGD_HOLDS && cagd_is_positive_in_cell(c, neg_f(mul_f(n, m)), 1))
        answer = CAGD_HOLDS;
    if (answer == CAGD_FAILS && refuted_at(r, c, t, k, rational ? value : NULL) == CAGD_FAILS)
        return CAGD_FAILS;
    return answer == CAGD_HOLDS ? CAGD_HOLDS : undecided(r, c, "an inequality that was neither proved nor refuted");
}

/* Uses a condition such as r^2 = 2, or c^2 + s^2 = 1: a name whose square it tells. */
static void use_square(cagd_context *c, const cagd_tree *t, num_f *p)
{
    if (t->kind != CAGD_RELATION || t->count != 2 || t->relation[0] != CAGD_EQUAL)
        return;
    const char *trouble = c->trouble;
    cagd_value d = cagd_value_sub(cagd_evaluate(c, t->at[0]), cagd_evaluate(c, t->at[1]));
    unsigned faults = region_faults;
    region_faults &= FAULT_CROWDED | FAULT_MEMORY;
    c->trouble = trouble;
    for (int m = 0; m < c->count && faults == 0 && !d.rational; m++) {
        const cagd_binding *b = &c->binding[m];
        num_f x = b->value.f, n = cagd_numerator_f(d.f);
        if (!b->unknown || b->value.rational || cagd_degree_f(n, x) != 2 ||
            !cagd_is_zero_f(cagd_coefficient_f(n, x, 1)) || !cagd_is_constant_f(cagd_coefficient_f(n, x, 2), NULL))
            continue;
        cagd_square_root r = {x, neg_f(div_f(cagd_coefficient_f(n, x, 0), cagd_coefficient_f(n, x, 2)))};
        *p = cagd_without_powers(*p, 1, &r);
        return;
    }
}

/* Whether d is 0 where the conditions tell squares of names, as of a root r with r^2 = 2: what is not needed to be rational. */
static int is_zero_with_squares(cagd_context *c, num_f d)
{
    num_f p = cagd_numerator_f(d);
    for (int k = 0; k < c->scope->condition_count; k++)
        use_square(c, c->scope->conditions[k], &p);
    if (c->premise != NULL)
        use_square(c, c->premise, &p);
    for (int k = 0; c->premise != NULL && c->premise->kind == CAGD_ALL && k < c->premise->count; k++)
        use_square(c, c->premise->at[k], &p);
    return region_faults == 0 && cagd_is_zero_f(p);
}

/* Whether n/m > 0 in the box wherever m is not 0, n and m having no factor in common. */
static int is_positive_but_at_poles(num_f n, num_f m, int count, const cagd_side_of_box side[])
{
    num_q point[CAGD_MOST_UNKNOWNS];
    int unused;
    return cagd_positive_in_box(mul_f(n, m), 0, count, side, point, &unused) == CAGD_HOLDS &&
           (cagd_positive_in_box(n, 1, count, side, point, &unused) == CAGD_HOLDS ||
            cagd_positive_in_box(neg_f(n), 1, count, side, point, &unused) == CAGD_HOLDS);
}

/* The relation number k of the chain t for two values, in a box, or a cell. */
static cagd_answer compared_in_box(struct run *r, cagd_context *c, const cagd_tree *t, int k, cagd_value a,
                                   cagd_value b)
{
    cagd_relation relation = t->relation[k];
    cagd_value d = cagd_at_roots(c, relation == CAGD_LESS || relation == CAGD_LESS_OR_EQUAL ? cagd_value_sub(b, a)
                                                                                            : cagd_value_sub(a, b));
    int names = 0;
    if (region_faults != 0)
        return CAGD_UNDECIDED;
    if (r->into != NULL)
        return collected(r, c, relation, d);
    for (int m = 0; m < c->count; m++)
        names += c->binding[m].unknown;
    r->out->comparisons++;
    if (relation == CAGD_EQUAL || d.rational) {
        int sign = d.rational ? cagd_sign_q(d.q) : 2;
        int holds = relation == CAGD_EQUAL                              ? sign == 0
                    : relation == CAGD_NOT_EQUAL                        ? sign != 0
                    : relation == CAGD_LESS || relation == CAGD_GREATER ? sign > 0
                                                                        : sign >= 0;
        if (!holds && relation == CAGD_EQUAL && !d.rational && is_zero_with_squares(c, d.f))
            holds = r->unnoted = 1;
        if (!holds)
            return refuted(r, c, t, k, NULL, NULL, 0);
        weaken(r->out, names > 0 && relation == CAGD_EQUAL ? CAGD_BY_IDENTITY : CAGD_BY_DECISION);
        return CAGD_HOLDS;
    }
    weaken(r->out, CAGD_BY_DECISION);
    r->out->bounded = 1;
    cagd_side_of_box side[CAGD_MOST_UNKNOWNS];
    num_q point[CAGD_MOST_UNKNOWNS];
    int of[CAGD_MOST_UNKNOWNS], count = sides(c, side, of), rational;
    num_f n = cagd_numerator_f(d.f), m = cagd_denominator_f(d.f);
    if (c->limits > 0)
        return compared_in_cell(r, c, t, k, n, m);
    int strict = relation == CAGD_LESS || relation == CAGD_GREATER || relation == CAGD_NOT_EQUAL;
    cagd_answer answer = CAGD_UNDECIDED;
    if (relation == CAGD_NOT_EQUAL) { /* of one sign, or of the other */
        for (int minus = 0; minus < 2 && answer != CAGD_HOLDS; minus++)
            answer = cagd_positive_in_box(minus ? neg_f(n) : n, 1, count, side, point, &rational);
        if (answer == CAGD_FAILS)
            return refuted(r, c, t, k, NULL, NULL, 0);
    } else {
        int one_sign = cagd_positive_in_box(m, 1, count, side, point, &rational) == CAGD_HOLDS;
        answer = cagd_positive_in_box(one_sign ? n : mul_f(n, m), strict, count, side, point, &rational);
        if (answer != CAGD_HOLDS && strict && !one_sign && is_positive_but_at_poles(n, m, count, side)) {
            r->out->leaves_out_poles = 1;
            return CAGD_HOLDS;
        }
        if (answer == CAGD_FAILS)
            return refuted(r, c, t, k, rational ? point : NULL, of, count);
    }
    return answer == CAGD_HOLDS ? CAGD_HOLDS : undecided(r, c, "an inequality that was neither proved nor refuted");
}

/* The relation number k of the chain t from everything that is known (implied.h). */
static cagd_answer implied(struct run *r, cagd_context *c, const cagd_tree *t, int k)
{
    cagd_implied_example *e = region_bytes(sizeof *e);
    cagd_finding *f = r->out;
    if (e == NULL || region_faults != 0)
        return CAGD_UNDECIDED;
    cagd_answer answer = cagd_implied_relation(c, t, k, r->until, e);
    if (answer == CAGD_FAILS && e->rational)
        return refuted_at(r, c, t, k, e->value);
    if (answer == CAGD_FAILS && !f->has_example) {
        f->relation = t->relation[k], f->of_left = t->at[k], f->of_right = t->at[k + 1];
        f->has_root = 1, f->order = e->order;
        give_all(f, c, e->value, e->root);
    }
    r->unnoted = 1;
    return answer;
}

/* The relation number k of the chain t for two values. */
static cagd_answer compared(struct run *r, cagd_context *c, const cagd_tree *t, int k, cagd_value a, cagd_value b)
{
    const char *why = r->out->why;
    const cagd_tree *where = r->out->where;
    cagd_answer answer = compared_in_box(r, c, t, k, a, b);
    if (answer != CAGD_UNDECIDED || r->into != NULL || region_faults != 0 || (c->ties > 0 && !r->decomposes))
        return answer;
    answer = implied(r, c, t, k);
    if (answer != CAGD_UNDECIDED) {
        r->out->why = why, r->out->where = where, r->out->bounded = 1;
        weaken(r->out, CAGD_BY_DECISION);
    }
    return answer;
}

static cagd_answer decide_part(struct run *r, const struct part *p);

static void put_number(struct part *p, const char *key, const cagd_variable *v, num_q at)
{
    p->of_number[p->numbers] = v;
    p->number[p->numbers++] = (cagd_given){key, at, NULL};
}

/* The variable `key` below the number, at it, and above it. */
static cagd_answer split(struct run *r, const struct part *p, const char *key, const cagd_variable *v, num_q at)
{
    cagd_answer answer = CAGD_HOLDS;
    if (r->into != NULL) {
        if (r->out->why == NULL)
            r->out->why = "a condition that depends on variables";
        return CAGD_UNDECIDED;
    }
    r->out->bounded = 1;
    for (int which = 0; which < 3; which++) {
        struct part q = *p;
        if (q.pieces == CAGD_MOST_PIECES || q.numbers == CAGD_MOST_PIECES || cagd_seconds() > r->until)
            return CAGD_UNDECIDED;
        q.touches |= which == 1;
        if (which == 1)
            put_number(&q, key, v, at);
        else
            q.piece[q.pieces++] = (cagd_piece){key, which == 0, at};
        answer = worse(answer, decide_part(r, &q));
    }
    return answer;
}

/* The form of the cut below 0, at it, and above it. */
static cagd_answer cut(struct run *r, const struct part *p, const cagd_cut *where)
{
    cagd_answer answer = CAGD_HOLDS;
    if (r->into != NULL) {
        if (r->out->why == NULL)
            r->out->why = "a condition that depends on variables";
        return CAGD_UNDECIDED;
    }
    for (int sign = 1; sign >= -1 && answer != CAGD_FAILS; sign--) {
        struct part *q = region_bytes(sizeof *q);
        if (q == NULL || p->cuts == CAGD_MOST_CUTS_OF_CELL || cagd_seconds() > r->until) {
            r->out->out_of_time |= cagd_seconds() > r->until;
            return CAGD_UNDECIDED;
        }
        *q = *p;
        q->cut[q->cuts] = *where;
        q->cut[q->cuts++].sign = sign;
        q->touches |= sign == 0;
        answer = worse(answer, decide_part(r, q));
    }
    return answer;
}

/* The name is one of the roots: that number, or between two numbers that are near. */
static cagd_answer at_roots(struct run *r, const struct part *p, const cagd_context *c)
{
    cagd_answer answer = CAGD_HOLDS;
    for (int k = 0; k < c->roots && answer != CAGD_FAILS; k++) {
        struct part *q = region_bytes(sizeof *q);
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
        answer = worse(answer, decide_part(r, q));
    }
    return answer;
}

/* What is noted in the context: a name that has several values, a name to split, or a form to cut. */
static int is_to_be_cut(const cagd_context *c) { return c->rooted != NULL || c->split != NULL || c->has_cut; }
static cagd_answer cut_further(struct run *r, const struct part *p, const cagd_context *c)
{
    if (c->rooted != NULL)
        return at_roots(r, p, c);
    const cagd_binding *b = c->split != NULL ? cagd_binding_of((cagd_context *)c, c->split) : NULL;
    return c->split != NULL ? split(r, p, c->split, b != NULL ? b->variable : NULL, c->split_at) : cut(r, p, &c->cut);
}

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

/* The node of a value. */
static int node_of(cagd_value a) { return a.rational ? cagd_node_of_q(a.q) : cagd_node_of_f(a.f); }

/* That a relation b holds in the box of the names; 0 where that is not noted. */
static int note_inequality(const cagd_context *c, cagd_relation relation, cagd_value a, cagd_value b)
{
    cagd_side_of_box side[CAGD_MOST_UNKNOWNS];
    int of[CAGD_MOST_UNKNOWNS], count = sides(c, side, of), noted = 0;
    int less = relation == CAGD_LESS || relation == CAGD_LESS_OR_EQUAL;
    int strict = relation != CAGD_LESS_OR_EQUAL && relation != CAGD_GREATER_OR_EQUAL;
    for (int turned = 0; turned <= (relation == CAGD_NOT_EQUAL) && !noted; turned++)
        noted =
            cagd_note_sign_in_box(less != turned ? cagd_value_sub(b, a) : cagd_value_sub(a, b), strict, count, side);
    if (noted)
        cagd_trace_agree(1, strict ? "is_positive_in_box(difference)" : "is_nonnegative_in_box(difference)");
    return noted;
}

/* What is compared, as a step of the certificate; an identity stands for itself where no name is a function of others. */
static void note_step(struct run *r, const cagd_context *c, cagd_relation relation, cagd_value a, cagd_value b)
{
    for (int m = 0; m < c->count; m++)
        r->unnoted |= (c->binding[m].solved && !c->binding[m].is_tied) || c->binding[m].has_root;
    r->unnoted |= relation != CAGD_EQUAL && (c->limits > 0 || !note_inequality(c, relation, a, b));
    if (!r->unnoted && relation == CAGD_EQUAL)
        cagd_trace_same(node_of(a), node_of(b), 1);
}

/* A chain of relations; *cuts where it is to be looked at in parts. */
static cagd_answer decide_chain(struct run *r, cagd_context *c, const cagd_tree *t, int *cuts)
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
            note_step(r, c, t->relation[k], left, right);
        cagd_trace_pause();
        if (!empty)
            answer = worse(answer, compared(r, c, t, k, left, right));
        cagd_trace_resume();
        left = right;
    }
    return answer;
}

/* Any other truth: it is decided in each part of the cell in which its relations are; what decides none of them is a fault. */
static cagd_answer decide_truth(struct run *r, cagd_context *c, const cagd_tree *t)
{
    r->unnoted = 1;
    if (r->into != NULL)
        return undecided(r, c, "a relation that is not understood with :find:");
    int is = cagd_truth(c, t);
    if (is < 0 && region_faults == 0 && !is_to_be_cut(c))
        return undecided(r, c, "a condition that depends on variables");
    if (is < 0)
        region_faults |= FAULT_UNABLE;
    if (region_faults != 0 || is_empty(c))
        return CAGD_HOLDS;
    r->out->comparisons++;
    r->out->bounded = 1;
    weaken(r->out, CAGD_BY_DECISION);
    return is == 1 ? CAGD_HOLDS : refuted_at(r, c, t, -1, NULL);
}

/* Whether both sides of every relation are continuous, as functions without cases are, and it is one that limits keep. */
static int keeps_limits(const struct run *r, const cagd_context *c)
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
static cagd_answer decide_apart(struct run *r, const struct part *p, const cagd_context *c)
{
    cagd_strength strength = r->out->strength;
    int kept = keeps_limits(r, c);
    cagd_answer answer = CAGD_HOLDS;
    for (int k = 0; k < c->aparts && answer != CAGD_FAILS; k++) {
        struct part *q = region_bytes(sizeof *q);
        if (q == NULL || p->numbers + 2 > CAGD_MOST_PIECES || cagd_seconds() > r->until)
            return CAGD_UNDECIDED;
        *q = *p;
        q->touches = 1;
        for (int m = 0; m < c->apart[k].count; m++)
            put_number(q, c->apart[k].key[m], c->apart[k].variable[m], c->apart[k].value[m]);
        q->apart += c->apart[k].count;
        answer = worse(answer, decide_part(r, q));
    }
    if (kept && c->aparts > 0 && answer == CAGD_HOLDS)
        r->out->strength = strength;
    return answer;
}

/* Whether some divisor may be 0: it is not seen that it cannot. */
static int divides_by_0(cagd_context *c)
{
    int can_be_zero = 0;
    for (int i = 0; i < c->divisors && !can_be_zero; i++) {
        can_be_zero = (cagd_signs(c, cagd_value_f(c->divisor[i])) & CAGD_CAN_BE_ZERO) != 0 || region_faults != 0;
        region_faults &= FAULT_MEMORY | FAULT_CROWDED;
    }
    return can_be_zero;
}

/* The names that stand for all numbers. */
static void note_names(cagd_finding *f, const cagd_context *c)
{
    for (int k = 0; k < c->count; k++) {
        const cagd_binding *b = &c->binding[k];
        const char *name = b->angle != NULL ? b->angle : b->key;
        int known = (!b->unknown && !b->solved) || b->hidden || name[0] == '\0' || f->names == CAGD_MOST_UNKNOWNS;
        for (int m = 0; m < f->names; m++)
            known |= strcmp(f->name[m], name) == 0;
        if (!known)
            f->name[f->names++] = name;
    }
}

static cagd_answer decide_part(struct run *r, const struct part *p)
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
            return is_empty(c) ? decide_apart(r, p, c) : undecided(r, c, "a value that is not computed");
        }
        answer = worse(answer, one);
    }
    r->out->bounded |= c->used_bounds;
    r->out->leaves_out_poles |= c->omits_poles;
    r->out->one_sided |= c->one_sided;
    for (int k = 0; k < c->sums.count; k++)
        cagd_note_sum(&r->out->sums, c->sums.sum[k], c->sums.had_terms[k]);
    if (answer == CAGD_HOLDS && r->into == NULL && !r->quick && !r->out->leaves_out_poles)
        r->out->leaves_out_poles = divides_by_0(c);
    note_names(r->out, c);
    return answer == CAGD_FAILS ? answer : worse(answer, decide_apart(r, p, c));
}

/* ---- all cases ----------------------------------------------------------------------------------------- */

/* The value of an end of a range in the numbers that are chosen already. */
static int end_of_range(struct run *r, int level, const cagd_tree *end, long *value)
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
        undecided(r, c, "a range that does not end at whole numbers");
    }
    return good;
}

/* A => B is B where A is supposed; A <=> B is both directions. */
static cagd_answer decide_statement(struct run *r, const cagd_tree *t, const struct part *all)
{
    cagd_answer answer = CAGD_HOLDS;
    int parts = t->kind == CAGD_ALL ? t->count : t->kind == CAGD_IFF ? 2 : 1;
    for (int m = 0; m < parts && answer != CAGD_FAILS; m++) {
        const cagd_tree *one = t->kind == CAGD_ALL ? t->at[m] : t;
        int pair = one->kind == CAGD_IMPLIES || one->kind == CAGD_IFF;
        if (one->kind == CAGD_IFF && t->kind == CAGD_ALL) {
            answer = worse(answer, decide_statement(r, one, all));
            continue;
        }
        r->premise = pair ? one->at[m == 1 && t->kind == CAGD_IFF] : NULL;
        r->claim = pair ? one->at[!(m == 1 && t->kind == CAGD_IFF)] : one;
        if (pair && r->into != NULL)
            return undecided(r, &(cagd_context){0}, "an implication is not understood with :find:");
        answer = worse(answer, decide_part(r, all));
    }
    return answer;
}

/* The case that was noted goes where it is wanted; 0 where it says too little. */
static int give_case(struct run *r)
{
    const char *inputs = cagd_trace_inputs(), *nodes = cagd_trace_nodes(), *steps = cagd_trace_steps();
    return !r->unnoted && region_faults == 0 && inputs != NULL && nodes != NULL && steps != NULL &&
           r->take(r->data, inputs, nodes, steps);
}

static int is_enough(const cagd_finding *f) { return f->has_example || f->cases >= QUICK_CASES; }

static void decide_cases(struct run *r, int level)
{
    if (r->out->out_of_time || (region_faults & (FAULT_CROWDED | FAULT_MEMORY)))
        return;
    if (level == r->wholes) {
        struct part all = {0};
        if (cagd_seconds() > r->until) {
            r->out->out_of_time = 1;
            return;
        }
        r->out->cases++;
        if (r->take != NULL)
            cagd_trace_again();
        long before = r->out->comparisons;
        cagd_answer answer = decide_statement(r, r->statement, &all);
        if (r->take != NULL && r->out->comparisons > before && !give_case(r))
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
    low += v->low_open + (v->high == NULL ? r->skipped : 0);
    high = v->high != NULL ? high - v->high_open : low + r->taken - 1;
    for (long m = low; m <= high; m++) {
        region_mark mark = region_open();
        int kept = r->out->has_example, why = r->out->why != NULL, names = r->out->names;
        r->chosen[level] = (cagd_given){v->head, from_int_q(m), NULL};
        decide_cases(r, level + 1);
        /* What was found lives on; a case that found nothing new leaves nothing behind. */
        if (r->into == NULL && r->out->has_example == kept && (r->out->why != NULL) == why && r->out->names == names)
            region_drop(mark);
        if (r->out->out_of_time || (region_faults & (FAULT_CROWDED | FAULT_MEMORY)) || (r->quick && is_enough(r->out)))
            break;
    }
}

static int has_no_end(const struct run *r)
{
    for (int k = 0; k < r->wholes; k++)
        if (r->whole[k]->high == NULL)
            return 1;
    return 0;
}

/* Whether a condition speaks of any name that the statement depends on, its index that means nothing left out: where none does, it takes
 * nothing from the first cases. */
static int speaks_of(const cagd_scope *scope, const cagd_tree *condition, const char *letter,
                     const cagd_tree *statement)
{
    if (condition->kind == CAGD_EVERY_INDEX)
        letter = condition->head;
    else if (condition->kind == CAGD_NAME && (letter == NULL || strcmp(letter, condition->head) != 0) &&
             uses(scope, statement, condition->head, 0))
        return 1;
    for (int k = 0; k < condition->count; k++)
        if (speaks_of(scope, condition->at[k], letter, statement))
            return 1;
    return 0;
}

/* x \ne y: what is proved without it, is proved. */
static int is_inequation(const cagd_tree *t)
{
    return t->kind == CAGD_RELATION && t->count == 2 && t->relation[0] == CAGD_NOT_EQUAL;
}

/* Whether there is one whole number alone, on which no condition depends; then it begins at *low. */
static int has_one_number(struct run *r, long *low)
{
    for (int k = 0; k < r->scope->condition_count; k++)
        if (!is_inequation(r->scope->conditions[k]) && speaks_of(r->scope, r->scope->conditions[k], NULL, r->statement))
            return 0;
    if (r->wholes != 1 || !end_of_range(r, 0, r->whole[0]->low, low))
        return 0;
    *low += r->whole[0]->low_open;
    return 1;
}

/* For the only whole number, whose first cases hold. */
static int proved_for_every(struct run *r)
{
    long low;
    if (!has_one_number(r, &low))
        return 0;
    r->out->for_every = cagd_holds_for_every(r->scope, r->statement, r->whole[0], low, FIRST_CASES, &r->out->every);
    r->out->strength = r->out->for_every ? CAGD_BY_IDENTITY : r->out->strength;
    return r->out->for_every;
}

/* The cases behind the first ones, of which none fails, in a quarter of the time that is left: whether one fails there. */
static int fails_further(struct run *r)
{
    cagd_finding before = *r->out;
    double now = cagd_seconds(), until = r->until;
    r->skipped = FIRST_CASES, r->taken = FURTHER_CASES, r->until = now + (until - now) / 4;
    decide_cases(r, 0);
    r->skipped = 0, r->taken = FIRST_CASES, r->until = until;
    if (r->out->has_example)
        return 1;
    *r->out = before;
    return 0;
}

/* What becomes of equalities of higher degree: they make names functions of others (tie.h), or they are left for a decomposition (implied.h), or both. */
enum use_of_ties { TIED, UNTIED, TIED_AND_DECOMPOSED };

/* How many equalities of higher degree were used; 0 where some side was not defined. */
static int check_once(const cagd_scope *scope, const cagd_tree *statement, double seconds, int quick,
                      enum use_of_ties use, cagd_finding *out)
{
    struct run r = {.scope = scope,
                    .statement = statement,
                    .out = out,
                    .until = cagd_seconds() + seconds,
                    .quick = quick,
                    .taken = FIRST_CASES};
    r.untied = use == UNTIED, r.decomposes = use == TIED_AND_DECOMPOSED;
    r.wholes = cagd_whole_numbers(scope, statement, r.whole, MOST_WHOLE);
    for (int room = FIELD_ROOM;; room = CAGD_FIELD_MAX_VARIABLES) {
        *out = (cagd_finding){.answer = CAGD_UNDECIDED};
        field_open(room);
        if (r.wholes < 0)
            out->why = "more than eight whole numbers", out->undecided = 1;
        else
            decide_cases(&r, 0);
        unsigned faults = region_faults;
        region_faults = 0;
        if (!(faults & FAULT_CROWDED) || room == CAGD_FIELD_MAX_VARIABLES) {
            if (faults != 0 && out->why == NULL)
                out->why = faults & FAULT_MEMORY ? "there was no memory for it" : "too many variables";
            out->undecided += faults != 0;
            break;
        }
    }
    if (out->undecided == 0 && !out->has_example && !out->out_of_time && !quick && has_no_end(&r) &&
        !proved_for_every(&r) && !fails_further(&r)) {
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
static void check(const cagd_scope *scope, const cagd_tree *statement, double seconds, int quick, cagd_finding *out)
{
    double until = cagd_seconds() + seconds;
    int ties = check_once(scope, statement, seconds, quick, TIED, out);
    cagd_finding *again = out->answer == CAGD_UNDECIDED && ties > 0 ? region_bytes(sizeof *again) : NULL;
    for (enum use_of_ties use = UNTIED; again != NULL && use <= TIED_AND_DECOMPOSED && cagd_seconds() < until; use++) {
        check_once(scope, statement, until - cagd_seconds(), quick, use, again);
        if (again->answer == CAGD_UNDECIDED)
            continue;
        *out = *again;
        return;
    }
}

/* Names without meaning and numbers alone: a condition, if it is no statement. */
static int is_of_plain_names(const cagd_scope *scope, const cagd_tree *t, int *names)
{
    int plain = t->kind == CAGD_NUMBER || t->kind == CAGD_SUM || t->kind == CAGD_PRODUCT || t->kind == CAGD_NEGATIVE ||
                t->kind == CAGD_QUOTIENT || t->kind == CAGD_POWER || t->kind == CAGD_RELATION;
    if (t->kind == CAGD_NAME)
        return ++*names, t->order == 0 && (cagd_defined(scope, t->head) == NULL || has_value(scope, t->head));
    for (int k = 0; k < t->count && plain; k++)
        plain = is_of_plain_names(scope, t->at[k], names);
    return plain;
}

/* x = ..., x meaning nothing else. */
static int tells_a_name(const cagd_scope *scope, const cagd_tree *t)
{
    return t->kind == CAGD_RELATION && t->count == 2 && t->relation[0] == CAGD_EQUAL && t->at[0]->kind == CAGD_NAME &&
           t->at[0]->count == 0 && cagd_defined(scope, t->at[0]->head) == NULL;
}

/* "A, \quad u + v = 1" with the parts of plain names behind the first supposed; NULL where there are none. */
static const cagd_tree *with_parts_supposed(const cagd_scope *scope, const cagd_tree *t, const cagd_tree **first)
{
    cagd_tree *said = cagd_tree_new(CAGD_ALL, t->from, t->to, t->count),
              *supposed = cagd_tree_new(CAGD_ALL, t->from, t->to, t->count),
              *both = cagd_tree_new(CAGD_IMPLIES, t->from, t->to, 2);
    if (t->kind != CAGD_ALL || said == NULL || supposed == NULL || both == NULL)
        return NULL;
    said->count = supposed->count = 0;
    for (int k = 0; k < t->count; k++) {
        int names = 0, plain = k > 0 && (tells_a_name(scope, t->at[k]) ||
                                         (is_of_plain_names(scope, t->at[k], &names) && names > 0));
        cagd_tree *to = plain ? supposed : said;
        to->at[to->count++] = t->at[k];
    }
    if (supposed->count == 0)
        return NULL;
    *first = supposed->at[0];
    both->at[0] = supposed->count == 1 ? supposed->at[0] : supposed;
    both->at[1] = said->count == 1 ? said->at[0] : said;
    return both;
}

void cagd_check(const cagd_scope *scope, const cagd_tree *statement, double seconds, cagd_finding *out)
{
    const cagd_tree *where = NULL;
    check(scope, statement, seconds, 0, out);
    const cagd_tree *other = out->answer == CAGD_FAILS ? with_parts_supposed(scope, statement, &where) : NULL;
    if (other == NULL)
        return;
    cagd_finding *second = region_bytes(sizeof *second);
    if (second == NULL)
        return;
    check(scope, other, seconds, 0, second);
    if (second->answer == CAGD_FAILS) { /* in both readings, with numbers that satisfy what can be a condition */
        *out = *second;
        return;
    }
    *out = (cagd_finding){.answer = CAGD_UNDECIDED, .undecided = 1, .cases = 1, .where = where};
    out->why = "it fails if this is said, and not where it is supposed: then write \\text{for} before it";
}

/* ---- certificates --------------------------------------------------------------------------------------- */

enum { MOST_NOTED = 200000 };

/* Whether the name of the example runs over whole numbers: those are no inputs, for the program depends on them. */
static int is_whole_number(const cagd_scope *scope, const char *name)
{
    const cagd_variable *v = cagd_declared(scope, name);
    return v != NULL && v->whole;
}

static int certify_cases(const cagd_scope *scope, const cagd_tree *statement, double seconds, cagd_take_case *take,
                         void *data)
{
    cagd_finding *f = region_bytes(sizeof *f);
    struct run r = {
        .scope = scope, .statement = statement, .out = f, .until = cagd_seconds() + seconds, .taken = FIRST_CASES};
    r.take = take, r.data = data;
    r.wholes = cagd_whole_numbers(scope, statement, r.whole, MOST_WHOLE);
    long low;
    if (f == NULL || r.wholes < 0)
        return 0;
    *f = (cagd_finding){0};
    field_open(CAGD_FIELD_MAX_VARIABLES);
    cagd_trace_open(MOST_NOTED);
    decide_cases(&r, 0);
    int good = region_faults == 0 && !r.unnoted && !f->out_of_time && !f->has_example && f->undecided == 0;
    if (good && has_no_end(&r)) { /* one case more, which stands for all others */
        cagd_trace_again();
        good = has_one_number(&r, &low) && cagd_note_for_every(scope, statement, r.whole[0], low, FIRST_CASES) &&
               give_case(&r);
    }
    cagd_trace_close();
    region_faults &= FAULT_MEMORY;
    return good;
}

/* The two sides at the example, and that their order is not the one that is printed. */
static int certify_example(const cagd_scope *scope, const cagd_finding *found, cagd_take_case *take, void *data)
{
    static const char *const printed[] = {NULL, "!=", "<", "<=", ">", ">="};
    cagd_context *c = region_bytes(sizeof *c);
    if (c == NULL || !found->has_example || found->has_root || found->of_left == NULL)
        return 0;
    *c = (cagd_context){.scope = scope, .in_field = 1, .steps = CAGD_USUAL_STEPS};
    c->whole_angles = found->whole_angles;
    field_open(FIELD_ROOM);
    cagd_trace_open(MOST_NOTED);
    for (int k = 0; k < found->given; k++) {
        cagd_value value = cagd_value_constant(found->example[k].value);
        char name[16];
        snprintf(name, sizeof name, "v%d", k);
        if (!is_whole_number(scope, found->example[k].name))
            cagd_trace_input(value.q, name, -1);
        cagd_bind(c, found->example[k].name, value);
    }
    cagd_value a = cagd_evaluate(c, found->of_left), b = cagd_evaluate(c, found->of_right);
    int good = region_faults == 0 && a.rational && b.rational && cagd_equal_q(a.q, found->left) &&
               cagd_equal_q(b.q, found->right);
    if (good && found->relation == CAGD_EQUAL)
        cagd_trace_same(node_of(a), node_of(b), 0);
    if (good && found->relation != CAGD_EQUAL) {
        char formula[64];
        snprintf(formula, sizeof formula, "compare_q(left, right) %s 0", printed[found->relation]);
        cagd_trace_relation("order", node_of(a), node_of(b), cagd_compare_q(a.q, b.q));
        cagd_trace_agree(0, formula);
    }
    const char *inputs = cagd_trace_inputs(), *nodes = cagd_trace_nodes(), *steps = cagd_trace_steps();
    good = good && region_faults == 0 && inputs != NULL && nodes != NULL && steps != NULL &&
           take(data, inputs, nodes, steps);
    cagd_trace_close();
    region_faults &= FAULT_MEMORY;
    return good;
}

int cagd_certify(const cagd_scope *scope, const cagd_tree *statement, const cagd_finding *found, double seconds,
                 cagd_take_case *take, void *data)
{
    return found->answer == CAGD_FAILS   ? certify_example(scope, found, take, data)
           : found->answer == CAGD_HOLDS ? certify_cases(scope, statement, seconds, take, data)
                                         : 0;
}

void cagd_check_changes(const cagd_scope *scope, const cagd_tree *statement, double seconds, cagd_finding *out)
{
    double until = cagd_seconds() + seconds;
    int held = 0;
    for (int k = 0; k < MOST_CHANGES && cagd_seconds() < until; k++) {
        region_mark mark = region_open();
        cagd_finding *f = region_bytes(sizeof *f);
        const cagd_tree *changed = f != NULL ? cagd_changed(statement, k) : NULL;
        if (changed != NULL) {
            check(scope, changed, until - cagd_seconds(), 1, f);
            out->changes++;
            out->noticed += f->answer == CAGD_FAILS;
            held += f->answer == CAGD_HOLDS;
        }
        region_drop(mark);
        if (changed == NULL)
            break;
    }
    out->says_nothing =
        cagd_is_vacuous(scope, statement) || (held > 0 && held == out->changes && cagd_seconds() < until);
}

void cagd_find(const cagd_scope *scope, const cagd_tree *statement, const char *parameter, int poles, double seconds,
               cagd_found *out)
{
    cagd_finding *f = region_bytes(sizeof *f);
    struct collection *into = region_bytes(sizeof *into);
    *out = (cagd_found){.why = "there was no memory for it"};
    if (f == NULL || into == NULL)
        return;
    *f = (cagd_finding){0};
    *into = (struct collection){.parameter = parameter, .poles = poles};
    struct run r = {.scope = scope,
                    .statement = statement,
                    .out = f,
                    .until = cagd_seconds() + seconds,
                    .taken = FIRST_CASES,
                    .into = into};
    r.wholes = cagd_whole_numbers(scope, statement, r.whole, MOST_WHOLE);
    field_open(FIELD_ROOM);
    if (r.wholes >= 0)
        decide_cases(&r, 0);
    out->cases = f->cases, out->why = f->why, out->where = f->where, out->wholes = r.wholes;
    out->domain = into->domain;
    if (f->out_of_time)
        out->why = "the time was over";
    else if (r.wholes < 0 || has_no_end(&r))
        out->why = "a range without end";
    else if (into->count == 0 && out->why == NULL)
        out->why = "the statement does not depend on the parameter, or there is no case";
    else if (out->why == NULL && region_faults == 0)
        out->known = cagd_cells_of(into->count, into->constraint, &into->domain, &out->cells);
    if (!out->known && out->why == NULL)
        out->why = "too many numbers where it may change, or too many variables";
    region_faults = 0;
    for (int k = 0; out->known && k <= out->cells.count; k++) {
        int broken = out->cells.broken[k];
        out->name_of_witness[k] = into->other[broken];
        for (int m = 0; m < r.wholes; m++)
            out->breaking[k][m] = into->chosen[broken][m];
    }
}
