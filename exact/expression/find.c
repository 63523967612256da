#include "exact/expression/find.h"

#include "core/clock.h"
#include "exact/expression/angle.h"
#include "exact/expression/bounds.h"
#include "exact/expression/cases.h"
#include "exact/expression/clauses.h"
#include "exact/expression/depends.h"
#include "exact/number/recorder.h"
#include "exact/record/trace.h"
#include "exact/words.h"

enum { MOST_CONSTRAINTS = 200, MOST_NODES = 200000 };

/* A relation as a certificate has it: d = n/m, the relation, and the other name with its bounds, -1 for none.  DIVISOR: d is not 0 whatever the other
 * names are. */
enum noted_relation { NOTED_EQUAL, NOTED_NOT_EQUAL, NOTED_AT_LEAST, NOTED_MORE, NOTED_DIVISOR };
struct noted {
    int d[MOST_CONSTRAINTS], numerator[MOST_CONSTRAINTS], denominator[MOST_CONSTRAINTS], relation[MOST_CONSTRAINTS];
    int other[MOST_CONSTRAINTS], low[MOST_CONSTRAINTS], high[MOST_CONSTRAINTS], open[2 * MOST_CONSTRAINTS];
    int count, parameter;
};

/* What the cases ask of a parameter. */
struct cagd_collection {
    int poles; /* numbers for which a divisor of a side is 0 are none of those that are looked for */
    cagd_constraint constraint[MOST_CONSTRAINTS];
    const char *other[MOST_CONSTRAINTS]; /* the name of its other variable */
    cagd_given chosen[MOST_CONSTRAINTS][CAGD_MOST_WHOLE];
    int count;
    cagd_side_of_box domain;
    struct noted *noted; /* NULL, or what a certificate is made of */
};

/* ---- what is noted ------------------------------------------------------------------------------------- */

static int constant_node(num_q q) { return cagd_node_of_q(cagd_value_constant(q).q); }

/* The relation between d and 0, of which t is the other variable, if other. */
static void note(struct cagd_collection *into, int relation, cagd_value d, num_f parameter, const cagd_side_of_box *t,
                 int other)
{
    struct noted *n = into->noted;
    if (n == NULL || n->count == MOST_CONSTRAINTS)
        return;
    int k = n->count++;
    num_f f = cagd_in_field(d), top = cagd_numerator_f(f), bottom = cagd_denominator_f(f);
    cagd_trace_resume(); /* what is compared is not noted */
    n->parameter = cagd_node_of_f(parameter);
    n->d[k] = d.rational ? cagd_node_of_q(d.q) : cagd_node_of_f(d.f), n->relation[k] = relation;
    n->numerator[k] = cagd_node_of_f(top), n->denominator[k] = cagd_node_of_f(bottom);
    n->other[k] = other ? cagd_node_of_f(t->variable) : -1;
    n->low[k] = other && t->has_low ? constant_node(t->low) : -1;
    n->high[k] = other && t->has_high ? constant_node(t->high) : -1;
    n->open[2 * k] = other && t->low_open, n->open[2 * k + 1] = other && t->high_open;
    cagd_trace_pause();
}

/* 1: the answer holds, 0: it does not, -1: there is nothing there. */
static int bit_of(int nothing, cagd_answer a) { return nothing ? -1 : a == CAGD_HOLDS; }

/* The relations, the domain, the numbers that cut it, and whether they hold in each cell and for each number, in increasing order. */
static int note_cells(const struct noted *n, const cagd_side_of_box *domain, const cagd_cells *c)
{
    enum { MOST_TERMS = 4000 };
    int terms[CAGD_MOST_CUTS], between[2 * CAGD_MOST_CUTS], holds[2 * CAGD_MOST_CUTS + 1], count = 0;
    int *term = region_bytes(MOST_TERMS * sizeof *term);
    int ends[2] = {domain->has_low ? constant_node(domain->low) : -1,
                   domain->has_high ? constant_node(domain->high) : -1};
    int open[2] = {domain->low_open, domain->high_open};
    for (int k = 0; k < c->count && term != NULL; k++) {
        const struct cagd_root *r = &c->root[k];
        int outside = cagd_equal_q(r->lo, r->hi) && !cagd_is_inside(domain, r->lo);
        terms[k] = cagd_poly_degree(r->factor) + 1;
        if (c->at[k] == CAGD_UNDECIDED || (!c->empty[k] && c->cell[k] == CAGD_UNDECIDED) ||
            count + terms[k] > MOST_TERMS)
            return 0;
        for (int i = 0; i < terms[k]; i++)
            term[count++] = constant_node(cagd_poly_coefficient(r->factor, i));
        between[2 * k] = constant_node(r->lo), between[2 * k + 1] = constant_node(r->hi);
        holds[2 * k] = bit_of(c->empty[k], c->cell[k]), holds[2 * k + 1] = bit_of(outside, c->at[k]);
    }
    holds[2 * c->count] = bit_of(c->empty[c->count], c->cell[c->count]);
    int last = c->count;
    if (term == NULL || region_faults != 0 || (!c->empty[last] && c->cell[last] == CAGD_UNDECIDED) ||
        !cagd_trace_fact("range_of_parameter"))
        return 0;
    cagd_trace_put_list("parameter", 1, &n->parameter);
    cagd_trace_put_list("of", n->count, n->d);
    cagd_trace_put_list("numerator", n->count, n->numerator);
    cagd_trace_put_list("denominator", n->count, n->denominator);
    cagd_trace_put_list("relation", n->count, n->relation);
    cagd_trace_put_list("other", n->count, n->other);
    cagd_trace_put_list("low", n->count, n->low);
    cagd_trace_put_list("high", n->count, n->high);
    cagd_trace_put_list("open", 2 * n->count, n->open);
    cagd_trace_put_list("domain", 2, ends);
    cagd_trace_put_list("domain_open", 2, open);
    cagd_trace_put_list("terms", c->count, terms);
    cagd_trace_put_list("roots", count, term);
    cagd_trace_put_list("between", 2 * c->count, between);
    cagd_trace_put_list("holds", 2 * c->count + 1, holds);
    cagd_trace_put("is", 1);
    cagd_trace_fact_end();
    cagd_trace_agree(1, "range_of_parameter(relations)");
    return 1;
}

/* ---- relations as constraints -------------------------------------------------------------------------- */

/* One more constraint, with the case that it comes from. */
static void collect(cagd_run *r, cagd_constraint one, const char *other)
{
    struct cagd_collection *into = r->into;
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

/* The polynomial whose roots are the values of the parameter for which p is 0 whatever the other names are, to the square; *is, whether there are any. */
static cagd_constraint not_at_poles(num_f p, const cagd_binding *parameter, int *is)
{
    num_f poles = cagd_factor_of_parameter(p, parameter->value.f);
    *is = !is_constant_f(poles, NULL);
    return (cagd_constraint){
        .p = mul_f(poles, poles), .demand = CAGD_MORE_THAN_ZERO, .t = {.variable = parameter->value.f}};
}

/* Such a value is none of those that are looked for; whether there is one. */
static int collect_poles(cagd_run *r, num_f p, const cagd_binding *parameter)
{
    int is;
    cagd_constraint one = not_at_poles(p, parameter, &is);
    if (is && r->into->count < MOST_CONSTRAINTS)
        collect(r, one, NULL);
    return is;
}

/* d >= 0, d > 0, d = 0, or d \ne 0 as a constraint, its other variable being left out; wherever d is defined. */
static cagd_constraint constraint_of(cagd_relation relation, num_f d)
{
    num_f n = cagd_numerator_f(d);
    return (cagd_constraint){.p = relation == CAGD_EQUAL       ? n
                                  : relation == CAGD_NOT_EQUAL ? mul_f(n, n)
                                                               : mul_f(n, cagd_denominator_f(d)),
                             .demand = relation == CAGD_EQUAL ? CAGD_ZERO
                                       : relation == CAGD_LESS_OR_EQUAL || relation == CAGD_GREATER_OR_EQUAL
                                           ? CAGD_AT_LEAST_ZERO
                                           : CAGD_MORE_THAN_ZERO};
}

/* The name besides the parameter on which the constraint depends becomes its other variable, *other; 0, and why, where there are several, or where more is
 * known of them than bounds.  Where `alone`, an equality may have any names. */
static int find_other(cagd_run *r, cagd_context *c, int alone, cagd_constraint *one, const cagd_binding **other)
{
    const cagd_binding *parameter = cagd_binding_of(c, r->parameter);
    cagd_side_of_box side[CAGD_MOST_UNKNOWNS];
    int of[CAGD_MOST_UNKNOWNS], count = cagd_sides_of_known(c, side, of);
    *other = NULL;
    if (!has_bounds_alone(c, one->p, parameter)) {
        cagd_note_undecided(r, c, "a condition or a bound that is not understood with :find:");
        return 0;
    }
    for (int m = 0; m < count; m++) {
        const cagd_binding *b = &c->binding[of[m]];
        if (b == parameter) {
            r->into->domain = side[m];
        } else if (degree_f(one->p, side[m].variable) > 0 && !(alone && one->demand == CAGD_ZERO)) {
            if (*other != NULL) {
                cagd_note_undecided(r, c, "an inequality of more than one name besides the parameter");
                return 0;
            }
            one->t = side[m];
            *other = b;
        }
    }
    if (*other == NULL)
        one->t.variable = parameter->value.f;
    return 1;
}

/* The constraint, or its variable is beyond an end that is a root. */
static void collect_outside(cagd_run *r, const cagd_binding *other, cagd_constraint one)
{
    num_f inside;
    for (int k = 0; k < 2 && other != NULL; k++)
        if (cagd_end_of_angle(other, k, &inside)) {
            r->unnoted = 1;
            collect(r,
                    (cagd_constraint){.p = neg_f(inside),
                                      .demand = other->root_end_open[k] ? CAGD_AT_LEAST_ZERO : CAGD_MORE_THAN_ZERO,
                                      .t = one.t,
                                      .or_next = 1},
                    other->key);
        }
    collect(r, one, other != NULL ? other->key : NULL);
}

/* Whether a denominator is never 0, unless for values of the parameter. */
static int is_denominator_of_parameter(const cagd_context *c, num_f m, const cagd_binding *parameter)
{
    cagd_side_of_box side[CAGD_MOST_UNKNOWNS];
    num_q point[CAGD_MOST_UNKNOWNS];
    int of[CAGD_MOST_UNKNOWNS], count = cagd_sides_of_known(c, side, of), unused;
    num_f rest = m, factor = cagd_factor_of_parameter(rest, parameter->value.f);
    while (!is_constant_f(factor, NULL) && region_faults == 0) {
        rest = div_f(rest, factor);
        factor = cagd_factor_of_parameter(rest, parameter->value.f);
    }
    return cagd_positive_in_box(rest, 1, count, side, point, &unused) == CAGD_HOLDS ||
           cagd_positive_in_box(neg_f(rest), 1, count, side, point, &unused) == CAGD_HOLDS;
}

/* Its value must not be a pole of d or of a divisor. */
cagd_answer cagd_collected(cagd_run *r, cagd_context *c, cagd_relation relation, cagd_value d)
{
    struct cagd_collection *into = r->into;
    const cagd_binding *parameter = cagd_binding_of(c, r->parameter);
    const cagd_binding *other;
    r->out->comparisons++;
    if (c->mixes_angles)
        return cagd_note_undecided(r, c, "an angle that is a number, too, with :find:");
    if (into->count + 3 + c->divisors >= MOST_CONSTRAINTS)
        return cagd_note_undecided(r, c, "too many cases");
    num_f f = cagd_in_field(d);
    cagd_constraint one = constraint_of(relation, f),
                    pole = {.p = cagd_denominator_f(f), .demand = CAGD_ZERO, .or_next = 1};
    if (!find_other(r, c, 1, &one, &other))
        return CAGD_UNDECIDED;
    /* Poles are left out, as where it is checked: those of > and < here, the others satisfy it. */
    if (one.demand == CAGD_MORE_THAN_ZERO && !is_denominator_of_parameter(c, pole.p, parameter)) {
        const cagd_binding *of_pole;
        if (!find_other(r, c, 0, &pole, &of_pole))
            return CAGD_UNDECIDED;
        collect_outside(r, of_pole, pole);
        r->unnoted = 1;
    }
    collect_outside(r, other, one);
    if (relation != CAGD_EQUAL)
        collect_poles(r, cagd_denominator_f(f), parameter);
    note(into,
         relation == CAGD_EQUAL             ? NOTED_EQUAL
         : relation == CAGD_NOT_EQUAL       ? NOTED_NOT_EQUAL
         : one.demand == CAGD_AT_LEAST_ZERO ? NOTED_AT_LEAST
                                            : NOTED_MORE,
         d, parameter->value.f, &one.t, other != NULL);
    for (int i = 0; into->poles && i < c->divisors; i++)
        if (collect_poles(r, c->divisor[i], parameter))
            note(into, NOTED_DIVISOR, cagd_value_f(c->divisor[i]), parameter->value.f, NULL, 0);
    return CAGD_HOLDS;
}

/* ---- clauses ------------------------------------------------------------------------------------------- */

/* A relation of a clause, and that the parameter is none of its poles. */
struct literal {
    cagd_constraint one, defined;
    const cagd_binding *other;
    int has_poles;
};

static int read_literal(cagd_run *r, cagd_context *c, const cagd_tree *t, struct literal *out)
{
    cagd_relation relation = t->relation[0];
    int less = relation == CAGD_LESS || relation == CAGD_LESS_OR_EQUAL;
    c->divisors = 0; /* what it divides by is noted anew */
    cagd_value a = cagd_evaluate(c, t->at[0]), b = cagd_evaluate(c, t->at[1]);
    const cagd_binding *parameter = cagd_binding_of(c, r->parameter);
    if (region_faults != 0)
        return 0;
    if (c->mixes_angles) {
        cagd_note_undecided(r, c, "an angle that is a number, too, with :find:");
        return 0;
    }
    num_f f = cagd_in_field(less ? cagd_value_sub(b, a) : cagd_value_sub(a, b)), poles = cagd_denominator_f(f);
    out->one = constraint_of(relation, f);
    for (int i = 0; r->into->poles && i < c->divisors; i++)
        poles = mul_f(poles, cagd_numerator_f(c->divisor[i]));
    out->defined = not_at_poles(poles, parameter, &out->has_poles);
    if (!find_other(r, c, 0, &out->one, &out->other))
        return 0;
    if (!is_denominator_of_parameter(c, poles, parameter)) {
        cagd_note_undecided(r, c, "a divisor that may be 0, in an alternative");
        return 0;
    }
    return region_faults == 0;
}

cagd_answer cagd_collect_clause(cagd_run *r, cagd_context *c, const cagd_tree *t)
{
    struct cagd_collection *into = r->into;
    struct literal literal[CAGD_MOST_LITERALS];
    int with_poles = 0, place[CAGD_MOST_LITERALS];
    for (int k = 0; k < t->count; k++) {
        if (!read_literal(r, c, t->at[k], &literal[k]))
            return CAGD_UNDECIDED;
        place[k] = literal[k].has_poles ? with_poles++ : -1;
    }
    if (into->count + 3 * (t->count << with_poles) >= MOST_CONSTRAINTS)
        return cagd_note_undecided(r, c, "too many cases");
    r->out->comparisons++;
    for (int choice = 0; choice < 1 << with_poles; choice++) /* each literal is "true and defined" */
        for (int k = 0; k < t->count; k++) {
            int defined = place[k] >= 0 && (choice >> place[k] & 1);
            cagd_constraint one = defined ? literal[k].defined : literal[k].one;
            one.or_next = k + 1 < t->count;
            collect_outside(r, defined ? NULL : literal[k].other, one);
        }
    return CAGD_HOLDS;
}

/* ---- the range of the parameter ------------------------------------------------------------------------ */

/* With `noted` a trace is opened, and stays open; *all: everything that was asked has been noted. */
static void find(const cagd_scope *scope, const cagd_tree *statement, const char *parameter, int poles, double seconds,
                 struct noted *noted, int *all, cagd_found *out)
{
    cagd_finding *f = region_bytes(sizeof *f);
    struct cagd_collection *into = region_bytes(sizeof *into);
    *out = (cagd_found){.why = "there was no memory for it"};
    if (f == NULL || into == NULL)
        return;
    if ((out->where = cagd_is_beyond_bounds(scope, statement)) != NULL) {
        out->why = CAGD_BEYOND_BOUNDS;
        *all = 0;
        return;
    }
    *f = (cagd_finding){0};
    *into = (struct cagd_collection){.poles = poles, .noted = noted};
    const cagd_tree *clauses = cagd_in_clauses(statement);
    if (clauses != NULL &&
        !cagd_has_squared_roots(statement)) /* otherwise what is not understood is told where it is met */
        statement = clauses;
    cagd_run r = {.scope = scope,
                  .statement = statement,
                  .out = f,
                  .until = cagd_seconds() + seconds,
                  .taken = CAGD_FIRST_CASES,
                  .parameter = parameter,
                  .into = into};
    r.wholes = cagd_whole_numbers(scope, statement, r.whole, CAGD_MOST_WHOLE);
    field_open(CAGD_FIELD_ROOM);
    if (noted != NULL)
        cagd_trace_open(MOST_NODES);
    if (r.wholes >= 0)
        cagd_decide_cases(&r, 0);
    out->cases = f->cases, out->why = f->why, out->where = f->where, out->wholes = r.wholes;
    out->domain = into->domain;
    if (f->out_of_time)
        out->why = "the time was over";
    else if (r.wholes < 0 || cagd_has_no_end(&r))
        out->why = "a range without end";
    else if (into->count == 0 && out->why == NULL)
        out->why = "the statement does not depend on the parameter, or there is no case";
    else if (out->why == NULL && region_faults == 0) {
        cagd_trace_pause();
        out->known = cagd_cells_of(into->count, into->constraint, &into->domain, &out->cells);
        cagd_trace_resume();
    }
    *all = !r.unnoted;
    out->leaves_out_poles = f->leaves_out_poles;
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

void cagd_find(const cagd_scope *scope, const cagd_tree *statement, const char *parameter, int poles, double seconds,
               cagd_found *out)
{
    int unused;
    find(scope, statement, parameter, poles, seconds, NULL, &unused, out);
}

int cagd_certify_found(const cagd_scope *scope, const cagd_tree *statement, const char *parameter, double seconds,
                       cagd_take_case *take, void *data)
{
    cagd_found *found = region_bytes(sizeof *found);
    struct noted *noted = region_bytes(sizeof *noted);
    int all = 0;
    if (found == NULL || noted == NULL)
        return 0;
    *noted = (struct noted){0};
    find(scope, statement, parameter, 1, seconds, noted, &all, found);
    int good = found->known && all && noted->count > 0 && noted->count < MOST_CONSTRAINTS && region_faults == 0 &&
               note_cells(noted, &found->domain, &found->cells);
    const char *inputs = cagd_trace_inputs(), *nodes = cagd_trace_nodes(), *steps = cagd_trace_steps();
    good = good && region_faults == 0 && inputs != NULL && nodes != NULL && steps != NULL &&
           take(data, inputs, nodes, steps);
    cagd_trace_close();
    region_faults &= FAULT_MEMORY;
    return good;
}
