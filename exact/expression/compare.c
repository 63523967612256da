#include "exact/expression/compare.h"

#include "exact/expression/find.h"
#include "exact/expression/implied.h"
#include "exact/expression/order.h"
#include "exact/expression/radical.h"
#include "exact/expression/refute.h"
#include "exact/expression/tie.h"
#include "exact/record/trace.h"
#include "exact/words.h"

/* Whether n/m > 0 in the box wherever m is not 0, n and m having no factor in common. */
static int is_positive_but_at_poles(num_f n, num_f m, int count, const cagd_side_of_box side[])
{
    num_q point[CAGD_MOST_UNKNOWNS];
    int unused;
    return cagd_positive_in_box(mul_f(n, m), 0, count, side, point, &unused) == CAGD_HOLDS &&
           (cagd_positive_in_box(n, 1, count, side, point, &unused) == CAGD_HOLDS ||
            cagd_positive_in_box(neg_f(n), 1, count, side, point, &unused) == CAGD_HOLDS);
}

/* The relation number k of the chain t, whose sides differ by n/m, where names are ordered or otherwise tied. */
static cagd_answer compared_in_cell(cagd_run *r, cagd_context *c, const cagd_tree *t, int k, num_f n, num_f m)
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
    if (answer == CAGD_FAILS && cagd_refuted_at(r, c, t, k, rational ? value : NULL) == CAGD_FAILS)
        return CAGD_FAILS;
    return answer == CAGD_HOLDS ? CAGD_HOLDS
                                : cagd_note_undecided(r, c, "an inequality that was neither proved nor refuted");
}

/* ---- squares that are told ----------------------------------------------------------------------------- */

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

/* ---- one relation -------------------------------------------------------------------------------------- */

/* The relation number k of the chain t for two values, in a box, or a cell. */
static cagd_answer compared_in_box(cagd_run *r, cagd_context *c, const cagd_tree *t, int k, cagd_value a, cagd_value b)
{
    cagd_relation relation = t->relation[k];
    int less = relation == CAGD_LESS || relation == CAGD_LESS_OR_EQUAL, names = 0;
    if (r->into != NULL)
        cagd_trace_resume(); /* the difference belongs to the certificate of what is found */
    cagd_value d = cagd_at_roots(c, less ? cagd_value_sub(b, a) : cagd_value_sub(a, b));
    if (r->into != NULL)
        cagd_trace_pause();
    if (region_faults != 0)
        return CAGD_UNDECIDED;
    if (r->into != NULL)
        return cagd_collected(r, c, relation, d);
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
            return cagd_refuted(r, c, t, k, NULL, NULL, 0);
        cagd_weaken(r->out, names > 0 && relation == CAGD_EQUAL ? CAGD_BY_IDENTITY : CAGD_BY_DECISION);
        return CAGD_HOLDS;
    }
    cagd_weaken(r->out, CAGD_BY_DECISION);
    r->out->bounded = 1;
    cagd_side_of_box side[CAGD_MOST_UNKNOWNS];
    num_q point[CAGD_MOST_UNKNOWNS];
    int of[CAGD_MOST_UNKNOWNS], count = cagd_sides_of_known(c, side, of), rational;
    num_f n = cagd_numerator_f(d.f), m = cagd_denominator_f(d.f);
    if (c->limits > 0)
        return compared_in_cell(r, c, t, k, n, m);
    int strict = relation == CAGD_LESS || relation == CAGD_GREATER || relation == CAGD_NOT_EQUAL;
    cagd_answer answer = CAGD_UNDECIDED;
    if (relation == CAGD_NOT_EQUAL) { /* of one sign, or of the other */
        for (int minus = 0; minus < 2 && answer != CAGD_HOLDS; minus++)
            answer = cagd_positive_in_box(minus ? neg_f(n) : n, 1, count, side, point, &rational);
        if (answer == CAGD_FAILS)
            return cagd_refuted(r, c, t, k, NULL, NULL, 0);
    } else {
        int one_sign = cagd_positive_in_box(m, 1, count, side, point, &rational) == CAGD_HOLDS;
        answer = cagd_positive_in_box(one_sign ? n : mul_f(n, m), strict, count, side, point, &rational);
        if (answer != CAGD_HOLDS && strict && !one_sign && is_positive_but_at_poles(n, m, count, side)) {
            r->out->leaves_out_poles = 1;
            return CAGD_HOLDS;
        }
        if (answer == CAGD_FAILS)
            return cagd_refuted(r, c, t, k, rational ? point : NULL, of, count);
    }
    return answer == CAGD_HOLDS ? CAGD_HOLDS
                                : cagd_note_undecided(r, c, "an inequality that was neither proved nor refuted");
}

/* The relation number k of the chain t from everything that is known (implied.h). */
static cagd_answer implied(cagd_run *r, cagd_context *c, const cagd_tree *t, int k)
{
    cagd_implied_example *e = region_bytes(sizeof *e);
    cagd_finding *f = r->out;
    if (e == NULL || region_faults != 0)
        return CAGD_UNDECIDED;
    cagd_answer answer = cagd_implied_relation(c, t, k, r->until, e);
    if (answer == CAGD_FAILS && e->rational)
        return cagd_refuted_at(r, c, t, k, e->value);
    if (answer == CAGD_FAILS && !f->has_example) {
        f->relation = t->relation[k], f->of_left = t->at[k], f->of_right = t->at[k + 1];
        f->has_root = 1, f->order = e->order;
        cagd_give_all(f, c, e->value, e->root);
    }
    r->unnoted = 1;
    return answer;
}

/* The relation number k of the chain t for two values. */
cagd_answer cagd_compared(cagd_run *r, cagd_context *c, const cagd_tree *t, int k, cagd_value a, cagd_value b)
{
    const char *why = r->out->why;
    const cagd_tree *where = r->out->where;
    cagd_answer answer = compared_in_box(r, c, t, k, a, b);
    if (answer != CAGD_UNDECIDED || r->into != NULL || region_faults != 0 || (c->ties > 0 && !r->decomposes))
        return answer;
    answer = implied(r, c, t, k);
    if (answer != CAGD_UNDECIDED) {
        r->out->why = why, r->out->where = where, r->out->bounded = 1;
        cagd_weaken(r->out, CAGD_BY_DECISION);
    }
    return answer;
}
